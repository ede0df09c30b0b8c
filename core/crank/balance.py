"""Balance of the crankshaft: centrifugal forces of satellites and counterweights on it.

A mass m on a crank pulls outwards along it with ``m*e*w^2``, a counterweight of unbalance U_k with
``U_k*w^2`` in its own direction. All forces stand still in the crank's frame, as the loads of the
mechanism do.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_count, check_not_negative, check_positive
from core.errors import InvalidInput
from core.fields import LARGEST, answer, answered, quantity
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True)
class Counterweight:
    """Mass on the shaft off its axis."""

    unbalance: float = quantity("Unbalance", "U", "kg_mm", step=0.1, ge=0, le=LARGEST)
    """Mass of the counterweight times the distance of its centre of mass from the axis."""
    position: float = quantity("Place", "z", "mm", step=1, ge=-LARGEST, le=LARGEST)
    """Position of the counterweight's middle along the shaft, from the same point as those of the
    satellites."""
    angle: float = quantity("Direction", "β", "deg", default=math.pi, step=15, ge=-3600, le=3600)
    """Direction of the counterweight, measured like the crank angles; 180° is opposite to a crank
    at 0°."""


@dataclass(frozen=True, slots=True)
class Correction:
    """Unbalance that balances the shaft in the plane of a bearing."""

    unbalance: float = answer("kg_mm", "U")
    """Unbalance of the correction: mass times radius."""
    angle: float = answer("deg", "α")
    """Direction of the correction, measured like the crank angles."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Balance:
    """Centrifugal forces of satellites and counterweights on the shaft."""

    unbalance: float = answer("kg_mm", "U")
    """Residual unbalance: mass times radius."""
    force: float = answer("N", "F")
    """Centrifugal force of the residual unbalance, U·ω₁²."""
    couple: float = answer("Nm", "M")
    """Couple of the residual unbalance about the middle of the bearings."""
    grade: float = answer("mm_per_s", "G")
    """Speed of the rotor's centre of mass about the axis, U·ω₁/M."""
    # Reaction of each bearing, N: real part along the direction of crank angle 0, imaginary part a
    # right angle ahead of it.
    reaction: tuple[complex, complex]
    rounding: float  # rounding error of each reaction, N
    corrections: tuple[Correction, Correction] = answer()
    """Corrections in the planes of both bearings, which balance the force and the couple."""

    @property
    @answered("N")
    def bearing_force(self) -> tuple[float, float]:
        """Magnitude of each bearing's reaction to the residual unbalance."""
        first, last = self.reaction
        return abs(first), abs(last)


def balance(
    *,
    satellite_mass: float,
    eccentricity: float,
    crank_angles: tuple[float, ...],
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    counterweights: tuple[Counterweight, ...] = (),
    input_speed: float,
    rotor_mass: float | None = None,
) -> Balance:
    """Unbalance of the shaft with its force and couple, and the corrections that balance it.

    ``U = sum m*e*e^(i*alpha_j) + sum U_k*e^(i*beta_k)``, force ``|U|*w^2``, couple
    ``|sum U*(z - (A + B)/2)|*w^2``, reactions ``R_B = -sum U*(z - A)/(B - A)*w^2`` and
    ``R_A = -sum U*w^2 - R_B``, grade ``|U|*w/M`` (ISO 21940-11). Numbers within rounding are 0.
    Masses are in kg: m of a satellite with its bearing, M of all that turns with the shaft, by
    default that of the satellites. Middle planes z of the satellites, and places A and B of the
    bearings, B beyond A, count along the shaft, m; w is the speed of the crank against the housing,
    rad/s, > 0.

    One satellite of 1.5 kg at 1500 rpm, and a counterweight opposite in its plane.

    >>> alone = dict(satellite_mass=1.5, eccentricity=2e-3, crank_angles=(0.0,),
    ...     satellite_positions=(0.031,), bearing_positions=(0.0, 0.062),
    ...     input_speed=50*math.pi)
    >>> found = balance(**alone)
    >>> round(found.force, 4), [round(each, 4) for each in found.bearing_force]
    (74.022, [37.011, 37.011])
    >>> balance(**alone, counterweights=(Counterweight(3e-3, 0.031, math.pi),)).force
    0.0
    """
    check_positive(
        satellite_mass=satellite_mass, eccentricity=eccentricity, input_speed=input_speed
    )
    mass = len(crank_angles) * satellite_mass if rotor_mass is None else rotor_mass
    check_positive(rotor_mass=mass)
    for index, each in enumerate(counterweights):
        check_not_negative(**{f"counterweights[{index}].unbalance": each.unbalance})
    first, last = bearing_positions
    check_places(
        satellites=len(crank_angles), positions=satellite_positions, bearings=bearing_positions
    )
    sizes = np.array(
        [satellite_mass * eccentricity] * len(crank_angles)
        + [each.unbalance for each in counterweights]
    )
    angles = (*crank_angles, *(each.angle for each in counterweights))
    places = (*satellite_positions, *(each.position for each in counterweights))
    held = carried(positions=places, bearings=bearing_positions)
    lost = float(sizes.sum()) * rounding(
        angles=angles, positions=places, bearings=bearing_positions
    )
    unbalances: ComplexArray = sizes * np.exp(1j * np.array(angles))
    needed = -(held * unbalances).sum(axis=1)
    left = abs(complex(unbalances.sum()))
    left = left if left > lost else 0.0
    at_first, at_last = [each if abs(each) > lost else 0j for each in needed.tolist()]
    square = input_speed**2
    return Balance(
        unbalance=left,
        force=left * square,
        couple=abs(at_last - at_first) / 2 * (last - first) * square,
        grade=left * input_speed / mass,
        reaction=(at_first * square, at_last * square),
        rounding=lost * square,
        corrections=(
            Correction(abs(at_first), _turned(at_first)),
            Correction(abs(at_last), _turned(at_last)),
        ),
    )


def check_places(
    *, satellites: int, positions: tuple[float, ...], bearings: tuple[float, float]
) -> None:
    """Refuse positions that are not one for each satellite, and bearings that do not ascend."""
    check_count(satellites, satellite_positions=positions)
    first, last = bearings
    if not last > first:
        raise InvalidInput("bearing_positions[1]", last, "greater_than", limit=first)


def carried(*, positions: tuple[float, ...], bearings: tuple[float, float]) -> FloatArray:
    """Share of a force at each position of the shaft that each bearing carries, shape (2, K)."""
    places, (first, last) = np.array(positions), bearings
    return np.array((last - places, places - first)) / (last - first)


def rounding(
    *, angles: tuple[float, ...], positions: tuple[float, ...], bearings: tuple[float, float]
) -> float:
    """Error of the reactions over a force, by rounding of its direction and its place."""
    far = max(map(abs, (*positions, *bearings))) / (bearings[1] - bearings[0])
    return ROUNDING * (4 + 2 * max(map(abs, angles))) * (1 + 2 * far)


def _turned(value: complex) -> float:
    """Direction of a complex number, rad, from 0 to less than a turn, also in degrees."""
    angle = math.atan2(value.imag, value.real) % (2 * math.pi)
    return angle if angle < 2 * math.pi * (1 - 4 * ROUNDING) else 0.0  # 0 for angles just below 0
