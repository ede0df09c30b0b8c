"""Equivalent reaction of a crankshaft's bearing."""

from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.crank.bearing_life import EXPONENTS, Bearing
from core.crank.crankshaft import Crankshaft, crankshaft
from core.crank.ring_mesh import RingMesh
from core.errors import InvalidInput
from core.output.mechanism import Mechanism
from core.output.pin_forces import force_ratios, pressure_cosines
from core.work_precision.study import WorkPrecision
from core.work_precision.turn_mean import forget, turn_mean_study


def equivalent_reaction_study(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    pin_circle_radius: float,
    eccentricity: float,
    mesh: RingMesh,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    kinds: tuple[Bearing, Bearing] = ("ball", "ball"),
) -> WorkPrecision:
    """Error against run time of the equivalent reaction ``<R^p>^(1/p)``, with which the life falls,
    of the most loaded bearing; of ideal forces that the satellites share equally.

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
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m; B beyond A.
    kinds : tuple of {"ball", "roller"}
        Rolling elements of each bearing.

    Returns
    -------
    WorkPrecision
        The calculator's method looks for the largest reactions as well.

    Raises
    ------
    InvalidInput
        If there are too many pairs, a size is out of range, or nothing is left of the forces.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    forces: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}
    rho, arm = float(mesh.radial_force_ratio), eccentricity * mechanism.ratio / pin_circle_radius

    def solve() -> Crankshaft:
        forget()
        return crankshaft(
            **forces,
            output_torque=eccentricity * mechanism.ratio,  # reactions over a load of all the torque
            pin_circle_radius=pin_circle_radius,
            eccentricity=eccentricity,
            mesh=mesh,
            satellite_positions=satellite_positions,
            bearing_positions=bearing_positions,
            kinds=kinds,
        )

    found = solve()
    worst = int(np.argmax(found.equivalent_reaction))
    if found.equivalent_reaction[worst] == 0:
        raise InvalidInput("satellite_positions", satellite_positions, "no_reaction")
    here, other = bearing_positions[worst], bearing_positions[1 - worst]
    cranks = np.exp(1j * np.array(mechanism.crank_angles))
    carried = cranks * [(other - place) / (other - here) for place in satellite_positions]

    def reactions(angles: FloatArray) -> FloatArray:
        own = force_ratios(crank_angles=angles, **forces)
        cosines = pressure_cosines(mechanism=mechanism, crank_angles=angles)
        share = (own * cosines).sum(axis=2)
        load: FloatArray = np.abs(((1j + rho) * share + arm * own.sum(axis=2)) @ carried)
        return load

    def exact(own: list[list[Any]], cosines: list[list[Any]]) -> Any:
        import mpmath

        reaction = mpmath.mpc(0)
        for j, (some, along) in enumerate(zip(own, cosines, strict=True)):
            load = (1j + rho) * mpmath.fdot(some, along) + arm * mpmath.fsum(some)
            lever = (mpmath.mpf(other) - satellite_positions[j]) / (mpmath.mpf(other) - here)
            reaction += load * lever * mpmath.expj(mechanism.crank_angles[j])
        return abs(reaction)

    return turn_mean_study(
        **forces,
        values=reactions,
        exact=exact,
        power=EXPONENTS[kinds[worst]],
        calculate=lambda: float(solve().equivalent_reaction[worst]),
        accuracy=found.accuracy,
    )
