"""Rolling bearings as rollers on the pins: their loads, ratings, speed and life.

The outer ring of a bearing on each pin rolls in the hole. Its load turns with the crank, not with
the ring: whatever the ring does while nothing presses it, the life is that of the load over the
turn.
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.arrays import check_positive
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.errors import Accuracy, Notice, poorly_known, required
from core.output.contact_force import force_peak
from core.output.ideal_turn import ideal_turn
from core.output.mechanism import Mechanism
from core.output.sampled_turn import WAYS, Direction, Made
from core.precision import SEARCHED

RollerKind = Literal["ball", "cylindrical", "needle"]

Ratings = Literal["bearing", "roller"]
"""Whether load ratings are those of a bearing in a rigid seat, or of a roller whose outer ring is
carried by nothing but its rolling elements."""

KINDS: dict[RollerKind, Bearing] = {"ball": "ball", "cylindrical": "roller", "needle": "roller"}
"""Rolling elements by the kind of roller."""

FRICTION: dict[RollerKind, float] = {"ball": 0.0015, "cylindrical": 0.0020, "needle": 0.0030}
"""Friction coefficient at the bore, of catalogues, where none is given."""

TILT: dict[RollerKind, float] = {"ball": 1.0e-3, "cylindrical": 0.4e-3, "needle": 0.1e-3}
"""Slope of a pin that the life of its rollers is made for, rad (Tribology Handbook, A22)."""

MIN_LOAD = 0.0167
"""Least load of a track roller over its static rating, that its outer ring turns (SKF)."""

UNKNOWN_ELEMENTS: dict[Bearing, tuple[float, float]] = {"ball": (0.6, 0.5), "roller": (0.33, 0.25)}
"""Shares of C and C0 where the number of rolling elements is not known."""


def unsupported_shares(*, kind: Bearing, elements: int | None) -> tuple[float, float]:
    """Shares of the ratings of a bearing that are left where no seat holds its outer ring.

    A lower bound: only the two elements next to the load carry. The dynamic one follows from the
    load-zone integral of the ring that stands still against the load (Lundberg and Palmgren): of
    balls ``(13*Z/6)^0.3/(0.3894*Z)``, of rollers ``(2.75*Z)^(2/9)/(0.3637*Z)``; the static one is
    5/Z; neither is above 1.

    Parameters
    ----------
    kind : {"ball", "roller"}
        Rolling elements.
    elements : int or None
        Their number Z.

    Returns
    -------
    tuple of float
        Of the dynamic and of the static rating.

    Notes
    -----
    Derived. A hole hugs the ring more than this says; makers of track rollers state ratings of
    their own, which have all of it in them.

    Examples
    --------
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


@dataclass(frozen=True, slots=True)
class PinRollers:
    """Rollers on the pins: the one that is loaded most. What rests on a rating or a speed that is
    not given raises `NotKnown`.
    """

    elements: Bearing  # what rolls
    input_speed: float | None  # of the crank, rad/s
    waves_per_turn: float  # turns of the crank against the output link for one of it
    eccentricity: float  # e, m
    pin_radius: float  # r_s of what touches the hole, m
    peak_load: float  # F of a roller over the turn, N
    static_load: float  # the same at the peak torque, N
    equivalent_load: float  # <F^p>^(1/p) over the turn, N
    shares: tuple[float, float]  # what is left of both ratings
    dynamic_rating: float | None  # C, N
    static_rating: float | None  # C0, N
    satellite: int  # of the equivalent load, from 1
    pin: int  # from 1
    accuracy: Accuracy  # of the loads; of the life p times that
    notices: tuple[Notice, ...]

    @property
    def speed(self) -> float:
        """n_s of the outer ring on its pin, rad/s."""
        speed = required(self.input_speed, "speed_missing", "load.input_speed")
        return speed * self.waves_per_turn * self.eccentricity / self.pin_radius

    @property
    def dynamic_rating_as_roller(self) -> float:
        """C_w, N."""
        return self.shares[0] * required(self.dynamic_rating, "rating_unknown")

    @property
    def static_rating_as_roller(self) -> float:
        """C_0w, N."""
        return self.shares[1] * required(self.static_rating, "rating_unknown")

    @property
    def life(self) -> float:
        """Time that 90 % of such rollers reach, s."""
        rating = self.dynamic_rating_as_roller
        turns = 1e6 * rating_life(load=self.equivalent_load, rating=rating, kind=self.elements)
        return float(turns * 2 * math.pi / self.speed)

    @property
    def static_safety_factor(self) -> float:
        """C_0w over the largest load at the peak torque."""
        return self.static_rating_as_roller / self.static_load


@dataclass(frozen=True, slots=True)
class _Loads:
    """Loads over the turn of the contact that is loaded most, N."""

    peak: float
    equivalent: float
    accuracy: Accuracy
    satellite: int = 1  # from 1
    pin: int = 1


def pin_rollers(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    torque_direction: Direction = "driving",
    made: Made | None = None,
    eccentricity: float,
    pin_radius: float,
    input_speed: float | None = None,
    peak_torque: float | None = None,
    kind: RollerKind,
    ratings: Ratings = "bearing",
    per_satellite: int = 1,
    dynamic_rating: float | None = None,
    static_rating: float | None = None,
    rolling_elements: int | None = None,
) -> PinRollers:
    """Loads, ratings and life of rolling bearings on the pins.

    The outer ring of radius r_s rolls in the hole, so that it turns on its pin at
    ``n_s = n*e/r_s``, n being the speed of the crank against the output link. With the force F of
    its contact, 0 where it does not touch, ``P = <F^p>^(1/p)`` over the turn and
    ``L = (C_w/P)^p`` million turns of n_s; of ideal forces with v = 1 and an even number of
    evenly spaced phases ``P/F = (gamma((p + 1)/2)/(2*sqrt(pi)*gamma(p/2 + 1)))^(1/p)``.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    output_torque : float
        Torque T on the output link, N*m, > 0.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m, > 0.
    torque_direction : {"driving", "reverse", "alternating"}
        Of both directions the worse counts.
    made : callable, optional
        Forces of the mechanism as it is made, see `core.output.real_turn.sampled`; else they are
        the ideal ones.
    eccentricity : float
        Eccentricity e of the cranks, m, > 0.
    pin_radius : float
        Radius r_s of what touches the hole, m, > 0.
    input_speed : float, optional
        Speed of the crank, rad/s, > 0; without it there is no life.
    peak_torque : float, optional
        Torque of the static safety, N*m, > 0; T where not given.
    kind : {"ball", "cylindrical", "needle"}
        What rolls.
    ratings : {"bearing", "roller"}
        What the ratings are of: a bearing in a rigid seat, of which `unsupported_shares` are left,
        or a roller.
    per_satellite : int
        Rollers side by side under each satellite, which share its force.
    dynamic_rating, static_rating : float, optional
        Ratings C and C0 of one of them, N, > 0.
    rolling_elements : int, optional
        Number Z of balls or rollers.

    Returns
    -------
    PinRollers

    Raises
    ------
    InvalidInput
        If a size is not positive.
    ImpossibleMechanism
        If the mechanism has a dead centre.

    Notes
    -----
    Derived; ISO 281:2007 is the life. The factor of the turning outer ring is 1: the share that is
    left of the rating is that of a ring which stands still against the load.

    Examples
    --------
    >>> found = pin_rollers(
    ...     mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=15.0),
    ...     output_torque=4.05, pin_circle_radius=0.024, eccentricity=1.5e-3, pin_radius=6.5e-3,
    ...     input_speed=10*math.pi, kind="ball", dynamic_rating=1080.0, static_rating=440.0,
    ...     rolling_elements=8)
    >>> [round(each, 2) for each in (found.peak_load, found.equivalent_load)]
    [56.25, 33.55]
    >>> round(found.speed*30/math.pi, 3), round(found.static_safety_factor, 3)
    (73.846, 4.889)
    """
    check_positive(
        output_torque=output_torque,
        pin_circle_radius=pin_circle_radius,
        eccentricity=eccentricity,
        pin_radius=pin_radius,
        per_satellite=float(per_satellite),
    )
    elements = KINDS[kind]
    power = EXPONENTS[elements]
    static_torque = output_torque if peak_torque is None else peak_torque
    if made is None:
        force = output_torque / pin_circle_radius
        loads = _ideal(mechanism, force_exponent, force, power)
        static = loads.peak * static_torque / output_torque
    else:
        loads = _made(made, WAYS[torque_direction], output_torque, power)
        static = loads.peak
        if static_torque != output_torque:
            static = _made(made, WAYS[torque_direction], static_torque, power).peak
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
        waves_per_turn=mechanism.waves_per_turn,
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


def _ideal(mechanism: Mechanism, exponent: float, reference: float, power: float) -> _Loads:
    """Under ideal forces; each contact feels the same over the turn."""
    peak = force_peak(mechanism, exponent)
    turn = ideal_turn(
        reference, mechanism=mechanism, force_exponent=exponent, pin_circle_radius=1.0
    )
    mean = float(turn.mean(np.abs(turn.on_pins[0]) ** power).mean())
    error = peak.accuracy.relative_error + SEARCHED
    return _Loads(
        peak=reference * peak.peak_force_ratio,
        equivalent=mean ** (1 / power),
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )


def _made(made: Made, ways: tuple[float, ...], torque: float, power: float) -> _Loads:
    """Under the forces of the mechanism as it is made, in the worse direction."""
    found = []
    for way in ways:
        turn = made(way * torque)
        force = np.abs(turn.on_pins)
        means = turn.mean(force**power) ** (1 / power)
        satellite, pin = divmod(int(means.argmax()), means.shape[1])
        found.append((float(means.max()), float(force.max()), satellite, pin, turn))
    equivalent, _, satellite, pin, _ = max(found, key=lambda each: each[0])
    turns = [each[-1] for each in found]
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
