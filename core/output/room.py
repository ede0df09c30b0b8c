"""Deviations of parts, and the room of pins in their holes, which says if parts go together.

The lag is the angle by which the output link is behind its ideal angle. At a lag, the centre P of a
pin and the centre H of its hole are ``|P*exp(-i*lag) - H|`` apart, which must not exceed the
difference C of their radii. The room of a pair is C less this distance. Room needs no forces and
holds for clearances and misfits of any size. A disc with play in a ring turns within the ring about
its own centre to where its pins have most room.
"""

import math
from collections.abc import Callable, MutableSequence, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache, cached_property, partial
from itertools import chain
from typing import Generic, Literal, NamedTuple, TypeVar

import numpy as np

from core.arrays import ComplexArray, FloatArray, IntArray, check_count, check_finite
from core.errors import ImpossibleMechanism
from core.fields import answer, answered, quantity
from core.numerics.extremes import zoom
from core.output.mechanism import MAX_SATELLITES, Mechanism
from core.precision import AS_TYPED, ROUNDING

Row = MutableSequence[float]
R = TypeVar("R")

State = Literal["fits", "binds_in_turning", "does_not_fit", "no_bound"]
Side = Literal["driving", "reverse", "radial"]

POSITIONS = 720
"""Even positions of the turn; the room falls between two by at most the eccentricity*step/2."""

OF_A_TURN = 48
"""Least number of even positions of a turn if the room repeats only after many turns."""

RETURNS = 8
"""Largest number of corrections of a disc's rotation in its ring; each correction is smaller, as
the eccentricity is less than the pin circle's radius.
"""

ELSEWHERE = 1e-9
"""Largest room, m, that a disc could win by a rotation in its ring that its pins do not need: the
effect of deviations of some micrometres over the angle of the disc's play.
"""

FINEST = 2**14
"""Largest number of positions of a turn at which the sign of the room is examined."""

STEPS = 60
"""Largest number of steps to the lag with most room."""

HALVINGS = 48
"""Number of halvings of a stretch of lags, down to rounding."""

NEAR = 1e-7
"""Wave angle, rad, within which a place counts as the start of the turn."""

RADIAL = 1e-5
"""Lever over pin circle radius below which a pair binds radially and not in turning."""

CLUSTER = 12
"""Number of halvings of the distance to a pair's dead angle, where the play has spikes."""

NO_PLAY = -1e3
"""Play, rad, below any real one, for positions where a pin fits its hole at no lag."""

TINY = 1e-300
"""Divisor in the place of 0."""

PER_PIN, PER_SATELLITE = (1, 1000), (1, MAX_SATELLITES)
"""Least and largest number of values of lists that are stated one by one."""

_length = partial(quantity, unit="mm", default=(), step=0.001, ge=-1e6, le=1e6)
_of_pin = partial(_length, lengths=(PER_PIN,))
_of_hole = partial(_length, lengths=(PER_SATELLITE, PER_PIN))
_of_ring_pin = partial(_of_pin, ge=-0.2, le=0.2)
_phase = partial(
    quantity, unit="deg", default=(), step=0.001, ge=-360, le=360, lengths=(PER_SATELLITE,)
)
"""Lists of deviations."""


def _check_length(name: str, values: Sequence[object], expected: int | None) -> None:
    if values and expected is not None:
        check_count(expected, **{name: values})


OF_RING_PINS = ("ring_pin_radial", "ring_pin_tangential", "ring_pin_radius")
"""Deviations of the pins of a ring."""


def deviation_row(name: str, *, values: Sequence[float], expected: int) -> list[float]:
    """Deviations of a list, zeros if it is empty; another length or infinite values are refused."""
    if not values:
        return [0.0] * expected
    check_count(expected, **{name: values})
    check_finite(**{f"{name}[{index}]": value for index, value in enumerate(values)})
    return [float(value) for value in values]


class Errors(NamedTuple, Generic[R]):
    """Deviations of one piece as rows of [N], [K*N] or [K]; of many pieces as tables."""

    pin_radial: R  # place of each pin, m
    pin_tangential: R  # m
    pin_radius: R  # m
    hole_radial: R  # place of each hole, m
    hole_tangential: R  # m
    hole_radius: R  # m
    eccentricity: R  # of each crank, m
    crank_phase: R  # of each crank, rad
    disc_phase: R  # of each disc's holes against its teeth, rad


@dataclass(frozen=True, slots=True)
class Deviations:
    """Deviations of a piece from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc, of each ring pin. Positive means outward, in the driving
    sense, larger, ahead.
    """

    pin_radial: tuple[float, ...] = _of_pin("Pins outward", "ρ")
    """Radial deviation of each pin's centre, positive outward."""
    pin_tangential: tuple[float, ...] = _of_pin("Pins along the circle", "τ")
    """Tangential deviation of each pin's centre, positive in the driving sense."""
    pin_radius: tuple[float, ...] = _of_pin("Pin radii", "Δr")
    """Deviation of each pin's radius, positive for a larger pin."""
    hole_radial: tuple[tuple[float, ...], ...] = _of_hole("Holes outward", "ρ_j")
    """Radial deviation of each hole's centre, positive outward, as one list per satellite."""
    hole_tangential: tuple[tuple[float, ...], ...] = _of_hole("Holes along the circle", "τ_j")
    """Tangential deviation of each hole's centre, positive in the driving sense, as one list per
    satellite."""
    hole_radius: tuple[tuple[float, ...], ...] = _of_hole("Hole radii", "Δr_j")
    """Deviation of each hole's radius, positive for a larger hole, as one list per satellite."""
    eccentricity: tuple[float, ...] = _length("Eccentricities", "Δe", lengths=(PER_SATELLITE,))
    """Deviation of the eccentricity of each crank, positive for a larger one."""
    crank_phase: tuple[float, ...] = _phase("Crank phases", "Δα")
    """Deviation of the angle of each crank, positive ahead."""
    disc_phase: tuple[float, ...] = _phase("Disc phases", "η")
    """Deviation of the angle of each disc's holes relative to its teeth, positive ahead."""
    ring_pin_radial: tuple[float, ...] = _of_ring_pin("Ring pins outward", "ρ")
    """Radial deviation of each ring pin's centre, positive outward; the first pin faces the crank
    at the crank angle 0."""
    ring_pin_tangential: tuple[float, ...] = _of_ring_pin("Ring pins along the circle", "τ")
    """Tangential deviation of each ring pin's centre, positive in the sense of the output's
    rotation."""
    ring_pin_radius: tuple[float, ...] = _of_ring_pin("Ring pin radii", "Δr")
    """Deviation of each ring pin's radius, positive for a larger pin."""

    @property
    def of_output(self) -> "Deviations":
        """Deviations without those of a ring."""
        return replace(self, ring_pin_radial=(), ring_pin_tangential=(), ring_pin_radius=())

    @property
    def of_ring(self) -> bool:
        """True if a pin of a ring deviates."""
        return self != self.of_output

    def check(self, *, pins: int | None, satellites: int, ring_pins: int | None) -> None:
        """Raise `InvalidInput` for a list without one value for each part; None for an unknown
        number of parts.
        """
        for name, values in ((each.name, getattr(self, each.name)) for each in fields(self)):
            if name in OF_RING_PINS:
                _check_length(name, values, ring_pins)
                continue
            _check_length(name, values, pins if name.startswith("pin") else satellites)
            if name.startswith("hole"):
                for index, row in enumerate(values):
                    _check_length(f"{name}[{index}]", row, pins)

    def rows(self, pins: int, satellites: int) -> Errors[Row]:
        """Flat rows for N pins and K satellites; another length or infinite values are refused."""
        self.check(pins=pins, satellites=satellites, ring_pins=None)

        def table(name: str) -> list[float]:
            values = getattr(self, name) or ((),) * satellites
            rows = (
                deviation_row(f"{name}[{j}]", values=each, expected=pins)
                for j, each in enumerate(values)
            )
            return [*chain(*rows)]

        def row(name: str, expected: int) -> list[float]:
            return deviation_row(name, values=getattr(self, name), expected=expected)

        return Errors(
            *[row(name, pins) for name in Errors._fields[:3]],
            *[table(name) for name in Errors._fields[3:6]],
            *[row(name, satellites) for name in Errors._fields[6:]],
        )

    def at_next_holes(self, mechanism: Mechanism) -> "tuple[Deviations, tuple[int, ...]]":
        """Deviations with each satellite on the pins next to its holes, and the K shifts.

        A satellite that is turned against the first one by more than half a pitch of its holes goes
        onto the pins by other holes. The holes are renumbered, and the shifts are numbers of holes.
        """
        pins, pitch = mechanism.pins, 2 * math.pi / mechanism.pins
        zeros = (0.0,) * mechanism.satellites
        phases, cranks = self.disc_phase or zeros, self.crank_phase or zeros
        turned = [
            phase + crank / mechanism.ratio for phase, crank in zip(phases, cranks, strict=True)
        ]
        further = [round((each - turned[0]) / pitch) for each in turned]
        if not any(further):
            return self, (0,) * mechanism.satellites

        def moved(rows: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
            return tuple(
                tuple(row[(n - by) % pins] for n in range(pins))
                for row, by in zip(rows, further, strict=bool(rows))
            )

        renumbered = replace(
            self,
            disc_phase=tuple(phase - by * pitch for phase, by in zip(phases, further, strict=True)),
            hole_radial=moved(self.hole_radial),
            hole_tangential=moved(self.hole_tangential),
            hole_radius=moved(self.hole_radius),
        )
        return renumbered, tuple(by % pins for by in further)


@dataclass(frozen=True, slots=True)
class Binding:
    """Pair that limits the room."""

    satellite: int  # from 1
    pin: int  # from 1
    side: Side = answer()
    """Sense of the output in which the pair limits the rotation; radial if in neither."""


@dataclass(frozen=True, slots=True)
class DiscRoom:
    """Room of one satellite by itself."""

    satellite: int = answer("", "j")
    """Number of the satellite, from 1."""
    least_room: float = answer("mm")
    """Least room of the satellite over the turn."""
    turned: float = answer("deg")
    """Angle of the holes ahead of the pins with the satellite in place, as a mean by least
    squares."""


class Play(NamedTuple):
    """Play of the unloaded output over the turn, rad; negative if parts do not fit.

    Minus infinity stands for a pin that fits its hole at no lag.
    """

    least: float  # rad
    greatest: float  # rad


@dataclass(frozen=True, slots=True)
class TurnRoom:
    """Room over the turn."""

    # Room at all crank angles, at some, or at none; "no_bound" if no hole holds its pin.
    state: State
    # Least room, m: growth of all pins until they just fit, or if negative their shrinkage.
    least: float
    error: float  # estimated error of the least room, m
    crank_angle: float | None  # place of the least room, rad; None if alike everywhere
    binding: tuple[Binding, ...]  # pairs that limit the room; none if all alike

    @property
    def where(self) -> dict[str, float]:
        """Crank angle of the least room by its name; empty if the room is alike at all angles."""
        return {} if self.crank_angle is None else {"crank_angle": self.crank_angle}


_Extreme = tuple[float, float, float]
"""Wave angle of a largest or least value over the turn, rad, the value, and its error."""


class _Pairs(NamedTuple):
    """Pins and hole centres of each position and pair: distances p and h from the output's centre,
    m, the lag at which the pin is nearest, rad, and the difference C of the radii, m.
    """

    p: FloatArray
    h: FloatArray
    nearest: FloatArray
    gap: FloatArray

    def left(self, lag: FloatArray) -> FloatArray:
        """Room of each pair at a lag, m."""
        sine = np.sin((lag - self.nearest) / 2)
        apart = np.sqrt((self.p - self.h) ** 2 + 4 * self.p * self.h * sine * sine)
        return np.asarray(self.gap - apart)

    def chosen(self, pair: IntArray) -> "_Pairs":
        """One pair of each position."""
        row = np.arange(len(pair))
        return _Pairs(*[each[row, pair] for each in self])


Turned = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""Least and largest rotation of discs in their ring, rad, shape (M, K), by crank angles, rad."""


class _Placed(NamedTuple):
    """Parts at rest as complex numbers: pins, holes without their crank, differences of radii,
    eccentricities and crank angles of the satellites.
    """

    pin: ComplexArray  # [N]
    hole: ComplexArray  # [K, N]
    gap: FloatArray  # [K, N]
    eccentricity: FloatArray  # [K]
    cranks: FloatArray  # [K]


def _best_of_two(
    low: FloatArray, high: FloatArray, one: _Pairs, other: _Pairs
) -> tuple[FloatArray, FloatArray]:
    """Lag between two at which the worse one of two pairs has most room, and that room, m."""
    for _ in range(HALVINGS):
        lag = (low + high) / 2
        ahead = lag > np.where(one.left(lag) < other.left(lag), one.nearest, other.nearest)
        low, high = np.where(ahead, low, lag), np.where(ahead, lag, high)
    lag = (low + high) / 2
    return lag, np.minimum(one.left(lag), other.left(lag))


@dataclass(frozen=True)
class Rooms:
    """Pins in their holes over the turn.

    Two equal discs of 20 lobes with four holes have 0.5 mm of room each; on cranks half a turn
    apart their holes are 9 degrees off and nothing goes together.

    >>> rooms = Rooms(
    ...     mechanism=Mechanism.evenly_spaced(pins=4, satellites=2, ratio=20.0),
    ...     pin_circle_radius=0.030, pin_radius=0.002, eccentricity=0.0015, clearance=0.0005,
    ...     deviations=Deviations(disc_phase=(0.0, math.radians(9))))
    >>> found = rooms.over_turn()
    >>> found.state, round(found.least * 1e3, 4), round(rooms.greatest() * 1e3, 4)
    ('does_not_fit', -1.8549, -1.6031)
    """

    mechanism: Mechanism
    pin_circle_radius: float  # R, m, > 0
    pin_radius: float  # r_p, m, > 0
    eccentricity: float  # e, m, > 0
    clearance: float  # radial, c, m; negative is interference
    deviations: Deviations = field(default_factory=Deviations)  # deviations of the piece
    # Play of rollers on their pins to either side, m; it adds to the clearance.
    roller_play: float = 0.0
    apart: bool = False  # True if each satellite turns for itself
    ring: Turned | None = None  # play of the discs in a ring; None if there is none
    turns: int = 1  # turns of the wave after which the ring's play repeats

    @cached_property
    def numbered(self) -> tuple[Deviations, tuple[int, ...]]:
        """Deviations by the holes that come onto the pins, and each satellite's shift in holes."""
        self.deviations.rows(self.mechanism.pins, self.mechanism.satellites)
        return self.deviations.at_next_holes(self.mechanism)

    @property
    def _play(self) -> float:
        return self.clearance + self.roller_play

    @cached_property
    def _placed(self) -> _Placed:
        pins, satellites = self.mechanism.pins, self.mechanism.satellites
        rows = self.numbered[0].rows(pins, satellites)
        own = {name: np.array(row) for name, row in rows._asdict().items()}
        for name in ("hole_radial", "hole_tangential", "hole_radius"):
            own[name] = own[name].reshape(satellites, pins)
        outward = 1j * np.exp(2j * np.pi * np.arange(pins) / pins)
        pin = (self.pin_circle_radius + own["pin_radial"] + 1j * own["pin_tangential"]) * outward
        turned = own["disc_phase"] + own["crank_phase"] / self.mechanism.ratio
        hole = self.pin_circle_radius + own["hole_radial"] + 1j * own["hole_tangential"]
        hole = hole * outward * np.exp(1j * turned)[:, None]
        gap = self.eccentricity + self._play + own["hole_radius"] - own["pin_radius"]
        cranks = np.array(self.mechanism.crank_angles) + own["crank_phase"]
        return _Placed(pin, hole, gap, self.eccentricity + own["eccentricity"], cranks)

    @property
    def even(self) -> bool:
        """True if the room is the clearance at all angles: several pins without deviations."""
        made = self.deviations != Deviations() or self.ring
        return not made and self.mechanism.pins > 1

    def _pairs(self, wave: FloatArray, disc: int | None) -> _Pairs:
        pin, hole, gap, eccentricity, cranks = self._placed
        chosen = slice(None) if disc is None else slice(disc, disc + 1)
        angle = np.add.outer(wave, cranks[chosen])
        centre = hole[chosen] + (eccentricity[chosen] * 1j * np.exp(-1j * angle))[..., None]
        nearest = np.angle(pin * centre.conj()).reshape(len(wave), -1)
        first = nearest[:, :1]
        nearest = first + np.remainder(nearest - first + np.pi, 2 * np.pi) - np.pi
        h = np.abs(centre).reshape(len(wave), -1)
        p = np.broadcast_to(np.abs(pin), centre.shape).reshape(len(wave), -1)
        return _Pairs(p, h, nearest, np.broadcast_to(gap[chosen].ravel(), h.shape))

    def arcs(self, wave: FloatArray, disc: int | None = None) -> tuple[FloatArray, FloatArray]:
        """Least and largest lag, rad, at which each pin is in its hole, shape (M, pairs).

        The lags are ``theta_c -+ 2*asin(sqrt((C - (p - h))*(C + (p - h))/(4*p*h)))`` at the M wave
        angles, of all satellites or of one, counted from 0. A pair without such a lag has infinite
        lags with low above high; a hole that is no bound has infinite lags with low below high.
        """
        p, h, nearest, gap = self._pairs(wave, disc)
        off = p - h
        square = (gap - off) * (gap + off) / np.maximum(4 * p * h, TINY)
        half = 2 * np.arcsin(np.sqrt(np.clip(square, 0.0, 1.0)))
        half = np.where(gap >= p + h, np.inf, half)
        half = np.where(gap < np.abs(off) - self._rounding, -np.inf, half)
        return nearest - half, nearest + half

    def windows(self, wave: FloatArray, disc: int | None = None) -> tuple[FloatArray, FloatArray]:
        """Least and largest lag, rad, at which all pins are in their holes, shape (M,): the largest
        lower end and the least upper end of all `arcs`. Low is above high if there is none.
        """
        if not self.ring or disc is not None:
            low, high = self.arcs(wave, disc)
            return low.max(axis=1), high.min(axis=1)
        found = []
        for end, turned in enumerate(self.ring(self._crank(wave))):  # end 0 is back, end 1 is ahead
            own = [self.windows(wave - each, j)[end] for j, each in enumerate(turned.T)]
            found.append(np.stack(own, axis=1) + turned)
        return found[0].max(axis=1), found[1].min(axis=1)

    def rooms(self, wave: FloatArray, disc: int | None = None) -> tuple[FloatArray, FloatArray]:
        """Room at M wave angles, m, and the lag where it is found, rad: the largest over the lag of
        the least ``C - |P*exp(-i*lag) - H|``, of all satellites or of one, counted from 0.

        The room is negative if the pins have to shrink by that much. Each distance falls up to its
        pair's own lag and rises after it, so that the room of the worst pair is largest where a
        rising and a falling pair have equal room.
        """
        if self.ring and disc is None:
            return self._free(wave)[:2]
        pairs, row = self._pairs(wave, disc), np.arange(len(wave))
        low, high = pairs.nearest.min(axis=1), pairs.nearest.max(axis=1)
        rising, falling = (pairs.left(lag[:, None]).argmin(axis=1) for lag in (low, high))
        for _ in range(STEPS):
            # room with the worst pairs of both ends alone
            lag, two = _best_of_two(low, high, pairs.chosen(rising), pairs.chosen(falling))
            heights = pairs.left(lag[:, None])
            worst = heights.argmin(axis=1)
            room = heights[row, worst]
            if (room >= two - self._rounding).all():
                break
            ahead = lag > pairs.nearest[row, worst]
            low, rising = np.where(ahead, low, lag), np.where(ahead, rising, worst)
            high, falling = np.where(ahead, lag, high), np.where(ahead, worst, falling)
        return room, lag

    def _free(self, wave: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Most room of discs that turn in their ring, m, lag of the output, rad, both of shape
        (M,), and rotation of each disc in the ring, rad, shape (M, K).

        The holes of a turned disc are where they would be at a wave angle less by the rotation. A
        change of the room by that alone is no reason to turn (`ELSEWHERE`).
        """
        assert self.ring
        low, high = self.ring(self._crank(wave))
        turned, discs = np.clip(0.0, low, high), range(self.mechanism.satellites)
        best = np.stack([self.rooms(wave, j)[1] for j in discs], axis=1)
        for _ in range(RETURNS):
            pairs = [self._pairs(wave - turned[:, j], j) for j in discs]
            # Between the largest least lag and the least largest lag each disc has all of its room.
            # If the two cross, the lag with most room for the worse disc is searched.
            ends = (best + low).max(axis=1), (best + high).min(axis=1)
            first, last = np.minimum(*ends), np.maximum(*ends)
            crossed, lag = ends[0] > ends[1], (first + last) / 2
            for _ in range(HALVINGS if crossed.any() else 0):
                own = np.clip(best, lag[:, None] - high, lag[:, None] - low)
                left = [p.left(o[:, None]).min(axis=1) for p, o in zip(pairs, own.T, strict=True)]
                worst = np.argmin(left, axis=0)[:, None]
                ahead = np.take_along_axis(own > best, worst, axis=1)[:, 0]
                first, last = np.where(ahead, first, lag), np.where(ahead, lag, last)
                lag = np.where(crossed, (first + last) / 2, lag)
            own = np.clip(best, lag[:, None] - high, lag[:, None] - low)
            before, turned = turned, lag[:, None] - own
            if np.abs(turned - before).max() * self._steepest <= self._rounding:
                break
        left = [p.left(o[:, None]).min(axis=1) for p, o in zip(pairs, own.T, strict=True)]
        return np.min(left, axis=0), lag, turned

    @property
    def _rounding(self) -> float:
        return 4 * ROUNDING * self.pin_circle_radius

    @property
    def closed(self) -> bool:
        """True if a hole is no larger than its pin."""
        return bool((self._placed.gap <= 0).any())

    def _start(self) -> float:
        return self.mechanism.initial_crank_angle

    @cached_property
    def _heights(self) -> Callable[[int | None], FloatArray]:
        """Room at the places of the grid, m, of all satellites or of one, calculated once."""
        return cache(lambda disc: self.rooms(self._grid(), disc)[0])

    @property
    def _positions(self) -> int:
        return max(POSITIONS, OF_A_TURN * self.turns)

    @property
    def _step(self) -> float:
        return 2 * math.pi * self.turns / self._positions

    def _grid(self) -> FloatArray:
        return self._start() + self._step * np.arange(self._positions, dtype=float)

    def _crank(self, wave: FloatArray) -> FloatArray:
        """Crank angles of wave angles, rad."""
        found: FloatArray = (wave - self._start()) / (1 + 1 / self.mechanism.ratio)
        return found

    def _narrowed(
        self,
        values: Callable[[FloatArray], FloatArray],
        places: FloatArray,
        width: FloatArray | float,
        sign: int,
    ) -> _Extreme:
        """First place and height of the largest (sign 1) or least value (-1) near some places."""
        places, height, errors = zoom(
            values=lambda wave: sign * values(wave), places=places, width=width
        )
        alike = places[height >= height.max() - AS_TYPED * self.eccentricity]
        first = alike[((alike - self._start() + NEAR) % (2 * np.pi * self.turns)).argmin()]
        error = float(errors[height.argmax()]) + self._rounding
        return float(first), float(sign * height.max()), error

    def _extreme(self, grid: FloatArray, heights: FloatArray, sign: int, disc: int | None
                 ) -> _Extreme:  # fmt: skip
        """Place and height of the greatest room over the turn (sign 1), or of the least (-1)."""
        signed, step = sign * heights, self._step
        best = signed.max()
        tops = (signed >= np.roll(signed, 1)) & (signed >= np.roll(signed, -1))
        tops &= signed >= best - self._steepest * step / 2
        return self._narrowed(lambda wave: self.rooms(wave, disc)[0], grid[tops], step, sign)

    @property
    def _steepest(self) -> float:
        """Bound of the room's slope over the wave angle, m/rad: the largest eccentricity."""
        return float(np.abs(self._placed.eccentricity).max())

    def over_turn(self, disc: int | None = None) -> TurnRoom:
        """Room over the turn of all satellites, or of one, counted from 0."""
        pin, hole, gap, eccentricity, _ = self._placed
        if (gap >= np.abs(pin) + np.abs(hole) + eccentricity[:, None]).all():
            return TurnRoom("no_bound", math.inf, 0.0, None, ())
        if self.even:
            return self._turn_room(self._play, self._rounding, None, (), disc)
        grid, heights = self._grid(), self._heights(disc)
        least, flat, error = float(heights.min()), self._flat(heights), self._rounding
        if not flat:
            place, least, error = self._extreme(grid, heights, -1, disc)
        below = self._below(grid, heights, disc) if least >= 0 else None
        if below is not None:  # room falls below 0 between positions
            place, least, error = self._narrowed(
                lambda wave: self.rooms(wave, disc)[0], np.array([below]), 1e-3, -1
            )
        elif flat:
            error = AS_TYPED * self.eccentricity
            return self._turn_room(least, error, None, (), disc)
        angle = self.crank_angle(place)
        return self._turn_room(least, error, angle, self._binding(place, disc), disc)

    @cached_property
    def room(self) -> TurnRoom:
        """Room over the turn; the least one of satellites that turn for themselves."""
        if not self.apart:
            return self.over_turn()
        turns = [self.over_turn(j) for j in range(self.mechanism.satellites)]
        return min(turns, key=lambda turn: turn.least)

    @property
    def hole_radius(self) -> float:
        """Nominal radius of the holes, m."""
        return self.pin_radius + self.eccentricity + self.clearance

    @property
    def largest_hole_radius(self) -> float:
        """Hole radius, m, at which a pin can enter the next hole or pass the disc's centre."""
        if self.mechanism.pins == 1:
            return self.pin_circle_radius
        apart = self.pin_circle_radius * math.sin(math.pi / self.mechanism.pins)
        return min(self.pin_circle_radius, math.hypot(self.pin_radius, apart))

    def refuse_without_bound(self) -> None:
        """Raise ImpossibleMechanism if a hole does not hold its pin."""
        if self.state == "no_bound":
            larger = max(chain(*self.deviations.hole_radius), default=0.0)
            raise ImpossibleMechanism(
                "no_mechanism",
                parameter="hole_radius",
                given_length=self.hole_radius + larger,
                limit_length=self.largest_hole_radius,
            )

    @property
    @answered()
    def state(self) -> State:
        """State of the fit: room at all crank angles (fits), at some (binds_in_turning), at none
        (does_not_fit), or holes that do not bound their pins (no_bound).
        """
        return "no_bound" if self.hole_radius >= self.largest_hole_radius else self.room.state

    @property
    def _bound(self) -> TurnRoom | None:
        """Room over the turn; None if holes do not bound their pins."""
        return None if self.state == "no_bound" else self.room

    @property
    @answered("mm", "", "max over θ of min(C − |P·exp(−iθ) − H|)")
    def least_room(self) -> float | None:
        """Least room over the turn: amount by which all pins might grow in radius until the parts
        just fit, negative if they have to shrink; absent if holes do not bound their pins.
        """
        return self._bound.least if self._bound else None

    @property
    @answered("deg")
    def least_room_crank_angle(self) -> float | None:
        """First crank angle with the least room; absent if the room is the same at all crank
        angles.
        """
        return self._bound.crank_angle if self._bound else None

    @property
    @answered()
    def binding(self) -> tuple[Binding, ...] | None:
        """Pairs that limit the room at that crank angle; absent if all pairs limit it alike."""
        return (self._bound and self._bound.binding) or None

    @property
    @answered("mm", optional=True)
    def needed_hole_radius(self) -> float:
        """Radius of all holes with which the parts would just fit, if they do not fit."""
        return self.hole_radius - self.room.least

    @property
    @answered("deg")
    def blocked_crank(self) -> tuple[tuple[float, float], ...] | None:
        """Ranges of crank angle in which the parts jam, if they go together in others."""
        return self.blocked() if self.state == "binds_in_turning" else None

    @property
    @answered()
    def renumbered(self) -> tuple[int, ...] | None:
        """Number of holes by which each satellite is put on the pins further, if any is."""
        return self.numbered[1] if any(self.numbered[1]) else None

    def _turn_room(
        self,
        least: float,
        error: float,
        angle: float | None,
        binding: tuple[Binding, ...],
        disc: int | None,
    ) -> TurnRoom:
        state: State = "fits"
        nothing = -AS_TYPED * (self.pin_radius + self.eccentricity)
        if least < nothing:
            state = "binds_in_turning" if self.greatest(disc) >= nothing else "does_not_fit"
        return TurnRoom(state, least, error, angle, binding)

    def _flat(self, heights: FloatArray) -> bool:
        """True if the room is alike at all positions."""
        return float(np.ptp(heights)) <= AS_TYPED * self.eccentricity

    def greatest(self, disc: int | None = None) -> float:
        """Greatest room over the turn, m, of all satellites or of one, counted from 0."""
        if self.even:
            return self._play
        grid, heights = self._grid(), self._heights(disc)
        if self._flat(heights):
            return float(heights.max())
        return self._extreme(grid, heights, 1, disc)[1]

    def _below(self, grid: FloatArray, heights: FloatArray, disc: int | None) -> float | None:
        """Position without room between the positions of a grid that all have some, or None.

        Intervals in which the room may fall below 0 are halved.
        """
        low, step, rooms = grid, self._step, heights
        following = np.roll(heights, -1)
        while len(low) and 2 * np.pi / step < FINEST:
            doubtful = (rooms + following) / 2 < self._steepest * step / 2
            low, rooms, following = low[doubtful], rooms[doubtful], following[doubtful]
            if not len(low):
                return None
            middle = low + step / 2
            first, last = self.windows(middle, disc)
            if (first > last).any():
                return float(middle[(first > last).argmax()])
            between, _ = self.rooms(middle, disc)
            low = np.concatenate([low, middle])
            following = np.concatenate([between, following])
            rooms = np.concatenate([rooms, between])
            step /= 2
        return None

    def _binding(self, wave: float, disc: int | None) -> tuple[Binding, ...]:
        """Pairs that limit the room at a wave angle."""
        where = np.array([wave])
        if self.ring and disc is None:
            (room,), (lag,), (turned,) = self._free(where)
            own = [(lag - each, self._pairs(where - each, j)) for j, each in enumerate(turned)]
        else:
            (room,), (lag,) = self.rooms(where, disc)
            own = [(lag, self._pairs(where, disc))]
        found = []
        for first, (lag, of_disc) in enumerate(own, disc or 0):
            pairs = _Pairs(*[row[0] for row in of_disc])
            left = pairs.left(lag)
            away = np.maximum(pairs.gap - left, TINY)
            lever = pairs.p * pairs.h * np.sin(lag - pairs.nearest) / away
            for i in np.flatnonzero(left <= room + AS_TYPED * self.eccentricity):
                j, n = divmod(int(i), self.mechanism.pins)
                side: Side = "driving" if lever[i] > 0 else "reverse"
                if abs(lever[i]) <= RADIAL * self.pin_circle_radius:
                    side = "radial"
                found.append(Binding(first + j + 1, n + 1, side))
        return tuple(found)

    def crank_angle(self, wave: float) -> float:
        """First crank angle >= 0 of a wave angle, rad."""
        off = (wave - self._start()) % (2 * math.pi * self.turns)
        if off > 2 * math.pi * self.turns - NEAR:
            off = 0.0
        return off / (1 + 1 / self.mechanism.ratio)

    def discs(self) -> tuple[DiscRoom, ...]:
        """Room of each satellite by itself."""
        placed = self._placed
        turned = np.angle((placed.hole * placed.pin.conj()).sum(axis=1))
        return tuple(
            DiscRoom(j + 1, self.over_turn(j).least, float(turned[j]))
            for j in range(self.mechanism.satellites)
        )

    def play(self) -> Play:
        """Least and greatest play of the unloaded output over the turn, rad."""
        pins, cranks = self.mechanism.pins, self._placed.cranks
        period = 2 * np.pi / (pins if self.even else 1)
        step = period / POSITIONS
        dead = np.add.outer(-cranks, -2 * np.pi * np.arange(2 * pins) / (2 * pins)).ravel()
        near = step * 2.0 ** -np.arange(1, CLUSTER + 1)
        around = np.add.outer(dead, np.concatenate([-near, [0.0], near])).ravel() - self._start()
        wave = np.unique(np.concatenate([step * np.arange(POSITIONS), around % period]))
        wave = self._start() + wave[np.diff(wave, append=period) > AS_TYPED]

        def height(places: FloatArray) -> FloatArray:
            low, high = self.windows(places)
            return np.maximum(high - low, NO_PLAY)

        heights, ends = height(wave), []
        after = np.diff(wave, append=wave[0] + period)
        before = np.roll(after, 1)
        for sign in (-1, 1):
            signed = sign * heights
            up, down = signed - np.roll(signed, 1), signed - np.roll(signed, -1)
            tops = (up >= 0) & (down >= 0)
            # The play is taken to rise between places no steeper than beside them.
            tops &= signed + np.maximum(up * after / before, down * before / after) >= signed.max()
            found = float(heights[signed.argmax()])
            if found > NO_PLAY:
                width = np.maximum(after, before)[tops]
                _, closer, _ = self._narrowed(height, wave[tops], width, sign)
                found = sign * max(sign * closer, sign * found)
            ends.append(found if found > NO_PLAY else -math.inf)
        return Play(ends[0], ends[1])

    def blocked(self) -> tuple[tuple[float, float], ...]:
        """Crank angles, rad, between which there is no room; the last may exceed a turn."""
        grid = self._grid()
        free = self._heights(None) >= 0
        if free.all() or not free.any():
            return ()
        turns = np.flatnonzero(free != np.roll(free, -1))
        low, high = grid[turns], grid[turns] + self._step
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            before = (self.rooms(middle)[0] >= 0) == free[turns]
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        ends = [*zip(map(self.crank_angle, high.tolist()), free[turns].tolist(), strict=True)]
        turn = self.mechanism.crank_angle_per_wave * self.turns
        starts = [angle for angle, begins in ends if begins]
        stops = [angle for angle, begins in ends if not begins]
        return tuple(
            (start, min(stop + (0.0 if stop > start else turn) for stop in stops
                        if stop > start or stop == min(stops)))
            for start in starts
        )  # fmt: skip
