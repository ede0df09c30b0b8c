"""Means over the turn of what follows from all ideal forces: positions at equal steps, and rules
between switching angles.
"""

import math
import operator
from collections.abc import Callable, Sequence
from functools import partial
from itertools import chain, pairwise
from typing import Any, TypedDict, Unpack

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.crank.bearing_life import EXPONENTS, Bearing
from core.crank.crankshaft import Crankshaft, crankshaft
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import SatelliteBearings, satellite_bearings
from core.errors import ImpossibleMechanism
from core.output.contact_force import force_peak, force_ratios
from core.output.losses import total_force
from core.output.mechanism import Mechanism, pressure_cosines
from core.output.pin_turn import all_pairs, satellite_turn
from core.work_precision.exact import pair_forces, pair_phases
from core.work_precision.rules import Rule, by_rule, rules
from core.work_precision.study import (
    DEFAULT,
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    refuse_many_pairs,
    work_precision,
)

MAX_PAIRS = 48
"""Most pairs of a study: the work of its reference grows with the cube of them at worst."""

SAMPLES = (16, 64, 256, 1024, 4096, 16384)

Exact = Callable[[list[list[Any]], list[list[Any]]], Any]
"""What is averaged, in multiple precision: of the forces over F0 and the cosines of the driving
pairs, a list for each satellite."""


class Turning(TypedDict):
    """What presses the cranks over the turn."""

    mechanism: Mechanism
    force_exponent: float  # v of the force over the approach
    pin_circle_radius: float  # R, m, > 0
    eccentricity: float  # e of the cranks, m, > 0
    mesh: RingMesh  # the ring's force along the crank


def turn_mean_study(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    values: Callable[[FloatArray], FloatArray],
    exact: Exact,
    power: float,
    calculator: Method,
) -> WorkPrecision:
    """Error against run time of a mean over the turn, ``<x^p>^(1/p)``, of what repeats with every
    pitch of the pins.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.
    values : callable
        x at crank angles, rad, shape (n,).
    exact : callable
        The same in multiple precision.
    power : float
        p.
    calculator : Method
        The mean as the calculators have it.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    """
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)
    ends, mean = _exact_mean(mechanism, force_exponent, exact, power)
    period = mechanism.crank_angle_per_wave / mechanism.pins
    # Crank angles between which the same pairs drive and the same one is the best placed.
    pieces = list(pairwise(float(end) * mechanism.crank_angle_per_wave / math.tau for end in ends))

    def powers(angles: FloatArray) -> FloatArray:
        return np.asarray(values(angles) ** power)

    def sampled(count: int) -> Outcome:
        mean = powers(np.linspace(0.0, period, count, endpoint=False)).mean()
        return float(mean ** (1 / power)), count

    def between(rule: Rule) -> float:
        parts = [rule.integral(powers, start, end) for start, end in pieces]
        return float((math.fsum(parts) / period) ** (1 / power))

    return work_precision(
        reference=Reference("multiple_tanh_sinh"),
        exact=[mean],
        methods=[
            Method("sampling", [("points", count) for count in SAMPLES], sampled),
            *(
                by_rule(rule=rule, code="segments_gauss", value=between, intervals=len(pieces))
                for rule in rules()
                if rule.code == "gauss_legendre"
            ),
            calculator,
        ],
    )


def _exact_mean(
    mechanism: Mechanism, force_exponent: float, exact: Exact, power: float
) -> tuple[list[Any], Any]:
    """Ends of the smooth parts of the wave within a pitch, and the mean, to 40 digits."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        phases, pitch = pair_phases(mechanism), 2 * mpmath.pi / mechanism.pins
        # A pair starts or stops to drive where the sine of wave angle and phase vanishes; midway
        # between neighbouring phases another one becomes the best placed.
        places = {(half - own[0]) % pitch for own in phases for half in (0, mpmath.pi)}
        around = sorted(own[0] % pitch for own in phases)
        around.append(around[0] + pitch)
        places |= {(-mpmath.pi / 2 - (a + b) / 2) % pitch for a, b in pairwise(around)}
        ends, nothing = [mpmath.mpf(0)], mpmath.mpf(10) ** (10 - REFERENCE_DIGITS)
        ends += [each for each in (*sorted(places), pitch) if each - ends[-1] > nothing]

        def averaged(driving: list[list[Any]], angle: Any) -> Any:
            forces, cosines = pair_forces(
                phases=driving, force_exponent=force_exponent, wave_angle=angle
            )
            return exact(forces, cosines) ** power

        integral = mpmath.mpf(0)
        for low, high in pairwise(ends):
            middle = (low + high) / 2
            driving = [[phase for phase in own if mpmath.sin(middle + phase) < 0] for own in phases]
            integral += mpmath.quad(partial(averaged, driving), [low, high])
        return ends, (integral / pitch) ** (1 / mpmath.mpf(power))


def total_force_study(*, mechanism: Mechanism, force_exponent: float = 1.0) -> WorkPrecision:
    """Error against run time of the mean total force, to which the mean loss is proportional.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    forces: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}

    def totals(angles: FloatArray) -> FloatArray:
        total: FloatArray = force_ratios(crank_angles=angles, **forces).sum(axis=(1, 2))
        return total

    def calculate(_: float) -> Outcome:
        total = total_force.__wrapped__(**forces)  # not what it remembers
        return total.mean, total.accuracy.evaluations

    return turn_mean_study(
        **forces,
        values=totals,
        exact=lambda own, _: sum(chain.from_iterable(own)),
        power=1.0,
        calculator=Method(total_force(**forces).accuracy.method, DEFAULT, calculate, chosen=True),
    )


def equivalent_load_study(
    *,
    kind: Bearing,
    **turning: Unpack[Turning],
) -> WorkPrecision:
    """Error against run time of the equivalent load ``<Q^p>^(1/p)``, with which the life falls, of
    the most loaded bearing; of ideal forces that the satellites share equally.

    Parameters
    ----------
    kind : {"ball", "roller"}
        Rolling elements.
    **turning
        `Turning`; at most `MAX_PAIRS` pairs.

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
    mechanism = turning["mechanism"]
    torque = turning["eccentricity"] * mechanism.ratio  # loads over that of all the torque

    def solve() -> SatelliteBearings:
        _forget()
        return satellite_bearings(**turning, output_torque=torque, kind=kind)

    result = solve()
    worst = int(np.argmax(result.equivalent_load))

    def calculate(_: float) -> Outcome:
        result = solve()
        return float(result.equivalent_load[worst]), result.accuracy.evaluations

    weights = np.eye(mechanism.satellites)[worst]
    return _load_study(
        turning,
        weights=weights,
        exact_weights=weights.tolist(),
        power=EXPONENTS[kind],
        calculator=Method(result.accuracy.method, DEFAULT, calculate, chosen=True),
    )


def equivalent_reaction_study(
    *,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    kinds: tuple[Bearing, Bearing] = ("ball", "ball"),
    **turning: Unpack[Turning],
) -> WorkPrecision:
    """Error against run time of the equivalent reaction ``<R^p>^(1/p)``, with which the life falls,
    of a crankshaft's most loaded bearing; of ideal forces that the satellites share equally.

    Parameters
    ----------
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m; B beyond A.
    kinds : tuple of {"ball", "roller"}
        Rolling elements of each bearing.
    **turning
        `Turning`; at most `MAX_PAIRS` pairs.

    Returns
    -------
    WorkPrecision
        The calculator's method looks for the largest reactions as well.

    Raises
    ------
    InvalidInput
        If there are too many pairs, or a size is out of range.
    ImpossibleMechanism
        If the mechanism has a dead centre, or nothing is left of the forces.
    """
    import mpmath

    mechanism = turning["mechanism"]
    torque = turning["eccentricity"] * mechanism.ratio  # reactions over a load of all the torque

    def solve() -> Crankshaft:
        _forget()
        return crankshaft(
            **turning,
            output_torque=torque,
            satellite_positions=satellite_positions,
            bearing_positions=bearing_positions,
            kinds=kinds,
        )

    result = solve()
    worst = int(np.argmax(result.equivalent_reaction))
    if result.equivalent_reaction[worst] == 0:
        raise ImpossibleMechanism("unloaded", parameter="crankshaft.satellite_positions")
    here, other = bearing_positions[worst], bearing_positions[1 - worst]
    cranks = mechanism.crank_angles

    def levers(other: Any) -> list[Any]:
        return [(other - place) / (other - here) for place in satellite_positions]

    def calculate(_: float) -> Outcome:
        result = solve()
        return float(result.equivalent_reaction[worst]), result.accuracy.evaluations

    with mpmath.workdps(REFERENCE_DIGITS):
        exact_cranks = map(mpmath.expj, cranks)
        exact_weights = [*map(operator.mul, exact_cranks, levers(mpmath.mpf(other)))]
    return _load_study(
        turning,
        weights=np.exp(1j * np.array(cranks)) * levers(other),
        exact_weights=exact_weights,
        power=EXPONENTS[kinds[worst]],
        calculator=Method(result.accuracy.method, DEFAULT, calculate, chosen=True),
    )


def _forget() -> None:
    """Forget what calculators remember of forces, so that a mean costs what it does at first."""
    for remembered in (force_peak, satellite_turn, all_pairs):
        remembered.cache_clear()


def _load_study(
    turning: Turning,
    *,
    weights: FloatArray | ComplexArray,
    exact_weights: Sequence[Any],
    power: float,
    calculator: Method,
) -> WorkPrecision:
    """Study of a load ``|sum w_j*Q_j|`` of the satellites' loads, ``Q = i*W + rho*W + S`` in the
    crank's frame over the load across it by all the torque; see `core.crank.satellite_bearing`.
    """
    mechanism, force_exponent = turning["mechanism"], turning["force_exponent"]
    rho = float(turning["mesh"].radial_force_ratio)
    arm = turning["eccentricity"] * mechanism.ratio / turning["pin_circle_radius"]

    def loads(angles: FloatArray) -> FloatArray:
        forces = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        cosines = pressure_cosines(mechanism=mechanism, crank_angles=angles)
        across, along = (forces * cosines).sum(axis=2), forces.sum(axis=2)
        return np.asarray(np.abs(((1j + rho) * across + arm * along) @ weights))

    def exact(forces: list[list[Any]], cosines: list[list[Any]]) -> Any:
        import mpmath

        across, along = map(mpmath.fdot, forces, cosines), map(mpmath.fsum, forces)
        own = [(1j + rho) * w + arm * s for w, s in zip(across, along, strict=True)]
        return abs(mpmath.fdot(own, exact_weights))

    return turn_mean_study(
        mechanism=mechanism,
        force_exponent=force_exponent,
        values=loads,
        exact=exact,
        power=power,
        calculator=calculator,
    )
