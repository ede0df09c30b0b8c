"""Equivalent load of a satellite's bearing."""

from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.crank.bearing_life import EXPONENTS, Bearing
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import SatelliteBearings, satellite_bearings
from core.output.mechanism import Mechanism
from core.output.pin_forces import force_ratios, pressure_cosines
from core.work_precision.study import WorkPrecision
from core.work_precision.turn_mean import forget, turn_mean_study


def equivalent_load_study(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    pin_circle_radius: float,
    eccentricity: float,
    mesh: RingMesh,
    kind: Bearing,
) -> WorkPrecision:
    """Error against run time of the equivalent load ``<Q^p>^(1/p)``, with which the life falls, of
    the most loaded bearing; of ideal forces that the satellites share equally.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `core.work_precision.turn_mean.MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m, > 0.
    eccentricity : float
        Eccentricity e of the cranks, m, > 0.
    mesh : RingMesh
        The ring's force along the crank.
    kind : {"ball", "roller"}
        Rolling elements.

    Returns
    -------
    WorkPrecision
        The calculator's method looks for the largest and the least load as well.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    forces: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}
    rho, arm = float(mesh.radial_force_ratio), eccentricity * mechanism.ratio / pin_circle_radius

    def solve() -> SatelliteBearings:
        forget()
        return satellite_bearings(
            **forces,
            output_torque=eccentricity * mechanism.ratio,  # loads over that of all the torque
            pin_circle_radius=pin_circle_radius,
            eccentricity=eccentricity,
            mesh=mesh,
            kind=kind,
        )

    found = solve()
    worst = int(np.argmax(found.equivalent_load))

    def loads(angles: FloatArray) -> FloatArray:
        own = force_ratios(crank_angles=angles, **forces)[:, worst]
        cosines = pressure_cosines(mechanism=mechanism, crank_angles=angles)[:, worst]
        share = (own * cosines).sum(axis=1)
        load: FloatArray = np.hypot(share, rho * share + arm * own.sum(axis=1))
        return load

    def exact(own: list[list[Any]], cosines: list[list[Any]]) -> Any:
        import mpmath

        share = mpmath.fdot(own[worst], cosines[worst])
        return mpmath.hypot(share, rho * share + arm * mpmath.fsum(own[worst]))

    return turn_mean_study(
        **forces,
        values=loads,
        exact=exact,
        power=EXPONENTS[kind],
        calculate=lambda: float(solve().equivalent_load[worst]),
        accuracy=found.accuracy,
    )
