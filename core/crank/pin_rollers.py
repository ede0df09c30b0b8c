"""Rolling bearings as rollers on the output pins: loads, ratings, speed and life.

The outer ring of a bearing on each pin rolls in the hole. The load turns with the crank and not
with the ring, so that the life follows from the load over the turn, also if an unloaded ring stops.
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.arrays import check_positive
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.errors import Accuracy, Notice, poorly_known, required
from core.fields import answer, answered
from core.output.contact_force import force_peak
from core.output.pin_circle_load import PinCircleLoad
from core.output.sampled_turn import SampledTurn
from core.precision import SEARCHED

RollerKind = Literal["ball", "cylindrical", "needle"]

Ratings = Literal["bearing", "roller"]
"""Meaning of load ratings: of a bearing in a rigid seat, or of a roller whose outer ring is
carried by its rolling elements only."""

KINDS: dict[RollerKind, Bearing] = {"ball": "ball", "cylindrical": "roller", "needle": "roller"}
"""Rolling elements by the kind of roller."""

FRICTION: dict[RollerKind, float] = {"ball": 0.0015, "cylindrical": 0.0020, "needle": 0.0030}
"""Friction coefficient at the bore by catalogues, used where none is given."""

TILT: dict[RollerKind, float] = {"ball": 1.0e-3, "cylindrical": 0.4e-3, "needle": 0.1e-3}
"""Slope of a pin that the life of its rollers allows, rad (Tribology Handbook, A22)."""

MIN_LOAD = 0.0167
"""Least load of a track roller over its static rating at which its outer ring turns (SKF)."""

UNKNOWN_ELEMENTS: dict[Bearing, tuple[float, float]] = {"ball": (0.6, 0.5), "roller": (0.33, 0.25)}
"""Shares of C and C0 where the number of rolling elements is not known."""


def unsupported_shares(*, kind: Bearing, elements: int | None) -> tuple[float, float]:
    """Shares of C and C0 that a bearing keeps where no seat holds its outer ring; `elements` is Z.

    The shares are a derived lower bound: only the two elements next to the load carry. The dynamic
    share follows from the load-zone integral of the ring that stands still against the load
    (Lundberg and Palmgren): ``(13*Z/6)^0.3/(0.3894*Z)`` for balls, ``(2.75*Z)^(2/9)/(0.3637*Z)``
    for rollers. The static share is 5/Z; neither is above 1. A hole supports the ring better than
    this, and ratings that makers state for track rollers include the effect.

    >>> [round(each, 3) for each in unsupported_shares(kind="ball", elements=8)]
    [0.755, 0.625]
    """
    if elements is None:
        return UNKNOWN_ELEMENTS[kind]
    if kind == "ball":
        dynamic = (13 * elements / 6) ** 0.3 / (0.3894 * elements)
    else:
        dynamic = (2.75 * elements) ** (2 / 9) / (0.3637 * elements)
    return min(dynamic, 1.0), min(5 / elements, 1.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class PinRollers:
    """Loads, ratings and life of the most loaded roller on the pins.

    Results that need a rating or a speed raise `NotKnown` without it.
    """

    elements: Bearing  # rolling elements
    input_speed: float | None  # speed of the crank, rad/s
    waves_per_turn: float  # turns of the crank against the output link per turn of the crank
    eccentricity: float  # e, m
    pin_radius: float  # outer radius r_s, m
    peak_load: float = answer("N", "F")
    """Largest load of a roller over the turn."""
    static_load: float = answer("N", "F_max")
    """Largest load of a roller at the peak torque."""
    equivalent_load: float = answer("N", "P")
    """Equivalent load, ⟨Fᵖ⟩^(1/p) over the turn."""
    shares: tuple[float, float]  # C_w/C and C_0w/C0
    dynamic_rating: float | None  # C, N
    static_rating: float | None  # C0, N
    satellite: int = answer()
    """Number of the satellite whose roller has the largest load, from 1."""
    pin: int = answer()
    """Number of the pin whose roller has the largest load, from 1."""
    accuracy: Accuracy = answer()  # of the loads; the error of the life is p times as large
    notices: tuple[Notice, ...] = answer()

    @property
    @answered("rpm", "n_s", optional=True)
    def speed(self) -> float:
        """Speed of an outer ring on its pin, n·e/r_s; absent without an input speed."""
        speed = required(self.input_speed, "speed_missing", "load.input_speed")
        return speed * self.waves_per_turn * self.eccentricity / self.pin_radius

    @property
    @answered("N", "C_w", optional=True)
    def dynamic_rating_as_roller(self) -> float:
        """Dynamic load rating without a seat around the outer ring."""
        return self.shares[0] * required(self.dynamic_rating, "rating_unknown")

    @property
    @answered("N", "C_0w", optional=True)
    def static_rating_as_roller(self) -> float:
        """Static load rating without a seat around the outer ring."""
        return self.shares[1] * required(self.static_rating, "rating_unknown")

    @property
    @answered("h", "L_10h", optional=True)
    def life(self) -> float:
        """Life that 90 % of such rollers reach, (C_w/P)ᵖ million turns."""
        rating = self.dynamic_rating_as_roller
        turns = 1e6 * rating_life(load=self.equivalent_load, rating=rating, kind=self.elements)
        return float(turns * 2 * math.pi / self.speed)

    @property
    @answered("", "S₀", optional=True)
    def static_safety_factor(self) -> float:
        """Static load rating without a seat over the load at the peak torque."""
        return self.static_rating_as_roller / self.static_load


@dataclass(frozen=True, slots=True)
class _Loads:
    """Loads over the turn of the most loaded contact, N."""

    peak: float
    equivalent: float
    accuracy: Accuracy
    satellite: int = 1  # from 1
    pin: int = 1


def pin_rollers(
    *,
    load: PinCircleLoad[SampledTurn],
    eccentricity: float,
    pin_radius: float,
    input_speed: float | None = None,
    kind: RollerKind,
    ratings: Ratings = "bearing",
    per_satellite: int = 1,
    dynamic_rating: float | None = None,
    static_rating: float | None = None,
    rolling_elements: int | None = None,
) -> PinRollers:
    """Loads, ratings and life of rolling bearings on the output pins.

    The outer ring of radius r_s rolls in the hole and turns on its pin at ``n_s = n*e/r_s``, with
    the speed n of the crank against the output link. With the force F of its contact, 0 while open,
    ``P = <F^p>^(1/p)`` over the turn and ``L = (C_w/P)^p`` million turns of n_s. For ideal forces
    with v = 1 and an even number of evenly spaced phases
    ``P/F = (gamma((p + 1)/2)/(2*sqrt(pi)*gamma(p/2 + 1)))^(1/p)``. The rating takes the outer ring
    as standing still against the load, so that its rotation factor is 1. Life: ISO 281:2007.
    `ImpossibleMechanism` is raised at a dead centre.

    The pin radius is the outer radius r_s of the roller, m. The static safety is under the peak
    torque. Ratings C and C0, N, are those of a single roller, reduced by `unsupported_shares` if of
    a bearing; `per_satellite` rollers side by side share the force of a satellite.

    >>> from core.output.mechanism import Mechanism
    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=15.0)
    >>> found = pin_rollers(
    ...     load=PinCircleLoad(mechanism=six, output_torque=4.05, pin_circle_radius=0.024),
    ...     eccentricity=1.5e-3, pin_radius=6.5e-3, input_speed=10*math.pi, kind="ball",
    ...     dynamic_rating=1080.0, static_rating=440.0, rolling_elements=8)
    >>> [round(each, 2) for each in (found.peak_load, found.equivalent_load)]
    [56.25, 33.55]
    >>> round(found.speed*30/math.pi, 3), round(found.static_safety_factor, 3)
    (73.846, 4.889)
    """
    check_positive(
        eccentricity=eccentricity, pin_radius=pin_radius, per_satellite=float(per_satellite)
    )
    elements = KINDS[kind]
    power = EXPONENTS[elements]
    if load.made is None:
        loads = _ideal(load, power)
        static = loads.peak * load.static_torque / load.output_torque
    else:
        loads = _made(load.turns(load.output_torque), power)
        turns = load.turns(load.static_torque)
        static = max(float(np.abs(turn.on_pins).max()) for turn in turns)
    shares, notices = (1.0, 1.0), list[Notice]()
    if ratings == "bearing":
        shares = unsupported_shares(kind=elements, elements=rolling_elements)
        notices.append(Notice("outer_ring_not_supported", {"dynamic": shares[0]}))
    peak, static, equivalent = (
        each / per_satellite for each in (loads.peak, static, loads.equivalent)
    )
    if input_speed is not None:
        check_positive(input_speed=input_speed)
    return PinRollers(
        elements=elements,
        input_speed=input_speed,
        waves_per_turn=load.mechanism.waves_per_turn,
        eccentricity=eccentricity,
        pin_radius=pin_radius,
        peak_load=peak,
        static_load=static,
        equivalent_load=equivalent,
        shares=shares,
        dynamic_rating=dynamic_rating,
        static_rating=static_rating,
        satellite=loads.satellite,
        pin=loads.pin,
        accuracy=loads.accuracy,
        notices=(*notices, *poorly_known(loads.accuracy)),
    )


def _ideal(load: PinCircleLoad[SampledTurn], power: float) -> _Loads:
    """Loads under ideal forces, which are alike for every contact over the turn."""
    peak = force_peak(load.mechanism, load.force_exponent)
    turn = load.forces(load.output_torque)
    mean = float(turn.mean(np.abs(turn.on_pins[0]) ** power).mean())
    error = peak.accuracy.relative_error + SEARCHED
    return _Loads(
        peak=load.output_torque / load.pin_circle_radius * peak.peak_force_ratio,
        equivalent=mean ** (1 / power),
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )


def _made(turns: list[SampledTurn], power: float) -> _Loads:
    """Loads under the forces of the mechanism as made, in the worse direction."""
    found = []
    for turn in turns:
        force = np.abs(turn.on_pins)
        means = turn.mean(force**power) ** (1 / power)
        satellite, pin = divmod(int(means.argmax()), means.shape[1])
        found.append((float(means.max()), float(force.max()), satellite, pin))
    equivalent, _, satellite, pin = max(found, key=lambda each: each[0])
    return _Loads(
        peak=max(each[1] for each in found),
        equivalent=equivalent,
        satellite=satellite + 1,
        pin=pin + 1,
        accuracy=Accuracy(
            "sampling",
            float(max(turn.error for turn in turns)),
            sum(turn.evaluations for turn in turns),
        ),
    )
