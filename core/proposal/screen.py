"""Screen: closed formulas over arrays of designs, and reasons of those that cannot be.

Forces of the ring are those of the set of pins that touch discs of modified teeth, in first order
and with one stiffness of all contacts; so are forces on output pins with their clearance. These
estimates only rank designs: no verdict rests on them.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.bearings import NamedBearing
from core.checks.teeth import NEAR_UNDERCUT
from core.checks.walls import BETWEEN_PINS
from core.crank.bearing_life import EXPONENTS
from core.crank.envelope import MIN_LOAD
from core.design.document import WALL_GUIDE
from core.design.layout import GAP, GAPS, HOUSING, LEAST_PLATE, LEAST_WALL, PLATE
from core.hertz import first_yield
from core.material_table import MATERIALS
from core.output.mechanism import Mechanism, assembly_angles
from core.precision import AS_TYPED
from core.proposal.shop import SHOPS, Shop, bought, pin_sizes

SHORTENING = 0.5, 0.85
"""Least and largest ``e*z_p/R_m`` that is tried."""

STEP, ECCENTRICITIES = 0.05e-3, 9
"""Step of the eccentricity, m, and largest number of those tried on a circle of ring pins."""

PINS = range(4, 13)
"""Numbers of output pins that are tried."""

MOST = 6_000_000
"""Largest number of designs times their lobes."""

WIDTHS = 1.0, 0.75, 0.5
"""Widths of the discs that are tried, over the largest one."""

WIDEST, NARROWEST = 1 / 3, 3e-3
"""Largest width of a disc over the diameter of the reducer, a rule of thumb, and least width, m."""

COMPLIANCE = 2.8
"""Compliance of a line contact times width and reduced modulus: ``(2/pi)*(ln(4*R/a) - 1/2)`` at
``R/a = 30``."""

POSITIONS = 4
"""Positions of a disc within a pitch of the ring pins."""

RADIAL = 0.6
"""Radial over tangential force of the ring, before the pins that touch are known."""

SAFE = 1.3
"""Limit of a pressure over the pressure that is estimated to last."""

BENDING = 450e6
"""Bending stress that is estimated to last in a pin, Pa: about that at which judged pins of bearing
steel reach their fatigue limit."""

BESIDE = 1e-3
"""Least gap between a bearing of the crankshaft and the pins, m."""

REACTION = 0.7
"""Load of a bearing of the crankshaft over the tangential force on a disc, before all sizes are
known."""

ARM, SHAFT = 0.12, 100e6
"""Arm of that load on the crankshaft over the diameter of the reducer, and bending stress of the
shaft, Pa, from which its least diameter follows."""

ROUNDED = 0.15e-3
"""Addition to usual walls for sizes that are rounded, m."""

SPREAD = 1.25
"""Backlash that nine tenths of the pieces keep over that of perfect parts."""

LEAST = 0.5
"""Least over largest load of a satellite's bearing."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Demand:
    """Task of a reducer, in SI units, and its shop."""

    torque: float  # of the output, N*m
    ratio: int  # of input to output speed
    outer_diameter: float  # largest one, m
    length: float = math.inf  # largest one, m
    input_speed: float  # rad/s
    life: float  # s
    shop: Shop = SHOPS["precise"]
    disc_material: str = ""  # name in place of that of the shop
    pin_material: str = ""  # likewise, of the output pins
    ring_pin_material: str = ""  # likewise, of the ring pins
    output: str = "pins"  # pins or ring
    discs: int = 2  # number of discs
    application_factor: float = 1.0  # on the torque, for stresses and pressures
    efficiency: float | None = None  # least one
    backlash: float | None = None  # largest one, rad

    @property
    def lobes(self) -> int:
        """Number of lobes of a disc."""
        return self.ratio - (self.output == "ring")

    @property
    def disc(self) -> str:
        """Name of the discs' material."""
        return self.disc_material or self.shop.disc

    @property
    def pin(self) -> str:
        """Name of the material of the output pins and their sleeves."""
        return self.pin_material or self.shop.pin

    @property
    def ring_pin(self) -> str:
        """Name of the material of the ring pins."""
        return self.ring_pin_material or self.shop.pin

    @property
    def friction(self) -> float:
        """Coefficient of friction: that of a plastic on steel if it is known, or of the shop."""
        plastic = MATERIALS[self.disc].material.plastic
        return plastic.friction.usual if plastic and plastic.friction else self.shop.friction

    @property
    def disc_torque(self) -> float:
        """Torque of the pins on all discs, N*m: less than that of a ring that is the output."""
        return self.torque * self.lobes / self.ratio


def numbers_of_pins(demand: Demand) -> list[int]:
    """Numbers of output pins with which all discs are equal parts; all numbers if there is none.

    >>> numbers_of_pins(
    ...     Demand(torque=20.0, ratio=20, outer_diameter=0.1, input_speed=150.0, life=2e7)
    ... )
    [8]
    """
    found = [pins for pins in PINS if _alike(demand, pins)]
    return found or [*PINS]


def _alike(demand: Demand, pins: int) -> bool:
    """True if all discs on a number of pins are equal parts."""
    ratio, discs = float(demand.lobes), demand.discs
    made = Mechanism.evenly_spaced(pins=pins, satellites=discs, ratio=ratio)
    angles = assembly_angles(mechanism=made, satellite_teeth=demand.lobes)
    return all(each.identical for each in angles)


def path_bends(*, short: Any, lobes: int, less: Any) -> tuple[FloatArray, FloatArray]:
    """Curvature of the path of ring pins times the radius of their circle, positive at lobes, and
    slope of the path, at pins whose angle to the crank has ``less = 1 - cos a``.
    """
    pins = lobes + 1
    slope = np.sqrt((1 - short) ** 2 + 2 * short * less)
    bend = (1 - short) * (1 - pins * short) + (pins + 1) * short * less
    return bend / slope**3, slope


class Screen:
    """Designs of an outer diameter with a number of output pins, as columns in SI units; at most
    `most` of them are drawn by a seed. By code of a check, `failed` has those that cannot be, and
    `reserves` estimates what is reached over what is asked; `of_pieces` does so for the teeth of
    pieces in which a ring pin stands out of its place.
    """

    def __init__(
        self, demand: Demand, *, pins: int, diameter: float | None = None, most: int | None = None
    ) -> None:
        self.demand, self.discs, self.pins = demand, demand.discs, pins
        self.diameter = diameter or demand.outer_diameter
        self.failed: dict[str, NDArray[np.bool_]] = {}
        self.reserves: dict[str, FloatArray] = {}
        self.bearings = bought(widest=WIDEST * self.diameter, most=self.diameter / 2)
        teeth = self._teeth()
        sizes = range(len(teeth)), range(len(self.bearings)), WIDTHS, (0, 1)
        index = [each.ravel() for each in np.meshgrid(*sizes, indexing="ij")]
        most = most or MOST // demand.lobes
        if len(index[0]) > most:
            drawn = np.random.default_rng(0).choice(len(index[0]), most, replace=False)
            index = [each[drawn] for each in index]
        self.teeth, self.bearing = index[0].astype(int), index[1].astype(int)
        self.ring_pin, self.circle, self.eccentricity = teeth[self.teeth].T
        self._fit_pins(index[3].astype(int))
        self._cut(teeth)
        self._fit_crank()
        self._fit_width(index[2])
        self._press_ring(teeth)
        self._press_holes()
        self._play()

    def __len__(self) -> int:
        return len(self.bearing)

    @property
    def possible(self) -> NDArray[np.bool_]:
        """True for designs whose parts fit."""
        found: NDArray[np.bool_] = ~np.any([*self.failed.values()], axis=0)
        return found

    @property
    def reserve(self) -> FloatArray:
        """Least reserve of each design, 0 if its parts do not fit."""
        return np.where(self.possible, np.min([*self.reserves.values()], axis=0), 0.0)

    @property
    def rejected(self) -> dict[str, NDArray[np.bool_]]:
        """Designs that fail by a check, by its code."""
        short = {code: ~(reserve >= 1) for code, reserve in self.reserves.items()}
        return self.failed | short

    def family(self, index: int) -> tuple[tuple[int, float], tuple[int, str]]:
        """Ring pins and bearing of a design, which it shares with others, each with the ratio."""
        ratio, bearing = self.demand.ratio, self.bearings[self.bearing[index]].name
        return (ratio, float(self.ring_pin[index])), (ratio, bearing)

    def _teeth(self) -> FloatArray:
        """Radius of ring pins, radius of their circle and eccentricity of all teeth, m, as rows."""
        pins, outer, rows = self.demand.lobes + 1, self.diameter / 2, []
        self.crowded = 0  # sizes of pins without room on their circle
        for size in pin_sizes()[:, 0]:
            circle = math.floor((min(outer / HOUSING, outer - LEAST_WALL) - size / 2) * 1e4) / 1e4
            apart = 2 * circle * math.sin(math.pi / pins)
            if circle > 0 and apart >= (1 + BETWEEN_PINS) * size:
                least, most = (each * circle / pins / STEP for each in SHORTENING)
                steps = np.linspace(math.ceil(least), math.floor(most), ECCENTRICITIES).round()
                rows += [(size / 2, circle, step * STEP) for step in np.unique(steps) if step > 0]
            else:
                self.crowded += 1
        return np.array(rows).reshape(-1, 3)

    def of(self, name: str, which: NDArray[np.int_]) -> FloatArray:
        """Size or rating of bearings by their index."""
        return np.array([getattr(each, name) for each in self.bearings])[which]

    def _fit_pins(self, smaller: NDArray[np.int_]) -> None:
        """Set the largest pins between bearing and teeth, or the next smaller ones."""
        wall = WALL_GUIDE * 2 * self.circle + ROUNDED
        inner = self.of("outer_diameter", self.bearing) / 2
        root = self.circle - self.ring_pin - self.eccentricity
        self.pin_circle = ((root + inner) * 5e3).round() / 1e4
        beside = self.pin_circle * math.sin(math.pi / self.pins) - wall / 2
        band = np.minimum(root - self.pin_circle, self.pin_circle - inner) - wall
        sizes = pin_sizes()
        room = np.minimum(band, beside) - self.eccentricity - self.demand.shop.clearance
        which = np.searchsorted(sizes[:, 1], room, side="right") - 1 - smaller
        self.failed["wall_bore"] = which < 0
        self.pin, self.touching = sizes[np.maximum(which, 0)].T

    def _cut(self, teeth: FloatArray) -> None:
        """Reject teeth that are cut under."""
        (ring_pin, circle, _), short = teeth.T, self._shortening(teeth)
        bend, _ = path_bends(short=short, lobes=self.demand.lobes, less=np.linspace(0, 2, 65))
        under = NEAR_UNDERCUT * ring_pin * bend.max(axis=1) > circle
        self.failed["ring_undercut"] = under[self.teeth]

    def _shortening(self, teeth: FloatArray) -> FloatArray:
        """Shortening of teeth, shape (teeth, 1)."""
        found: FloatArray = teeth[:, 2:] * (self.demand.lobes + 1) / teeth[:, 1:2]
        return found

    def _fit_crank(self) -> None:
        """Set the smallest bearings of the crankshaft that last, between pins and eccentrics and
        on a shaft thick enough, or the strongest that fit.
        """
        across = self.demand.disc_torque / self.discs / (self.eccentricity * self.demand.lobes)
        bending = REACTION * across * ARM * self.diameter * self.demand.application_factor
        least = np.cbrt(32 * bending / (math.pi * SHAFT))
        widest = self.of("bore_diameter", self.bearing) - 2 * self.eccentricity
        room = 2 * (self.pin_circle - self.pin / 2 - BESIDE)
        self.crank, lasts = np.full(len(self), -1), np.zeros(len(self), dtype=bool)
        for index, each in enumerate(self.bearings):
            fits = (each.bore_diameter <= widest) & (each.outer_diameter <= room) & ~lasts
            self.crank[fits] = index
            lasts |= (
                fits
                & (least <= each.bore_diameter)
                & (self._bears(each, self.demand.input_speed) >= REACTION * across)
            )
        self.failed["crank_bearing_fits"] = self.crank < 0
        self.crank = np.maximum(self.crank, 0)
        self.reserves["crank_bearing_fits"] = (self.of("bore_diameter", self.crank) / least) ** 3

    def _bears(self, bearing: NamedBearing, speed: float) -> float:
        """Load that a bearing bears for the life, N."""
        turns = speed / (2 * math.pi) * self.demand.life / 1e6
        return float(bearing.dynamic_rating / turns ** (1 / EXPONENTS[bearing.kind]))

    def _all_bear(self, which: NDArray[np.int_], speed: float) -> FloatArray:
        return np.array([self._bears(each, speed) for each in self.bearings])[which]

    def _fit_width(self, part: FloatArray) -> None:
        """Set the width of the discs, to 0.5 mm, in the length and beside the bearings."""
        self.plate = np.maximum(PLATE * self.pin, LEAST_PLATE)
        self.plate = np.maximum(self.plate, self.of("width", self.crank))
        free, (least_gap, most_gap) = self.demand.length - 2 * self.plate, GAPS
        gap = np.clip(GAP * free / self.discs, least_gap, most_gap)
        width = (free - (self.discs + 1) * gap) / self.discs
        width = np.minimum(width, WIDEST * self.diameter)
        self.width = np.maximum(np.floor(width * part * 2e3 + 1e-6) / 2e3, NARROWEST)
        self.failed["bearing_fits"] = self.of("width", self.bearing) > self.width
        self.gap = np.clip(GAP * self.width, least_gap, most_gap)
        self.span = self.discs * self.width + (self.discs + 1) * self.gap
        if math.isfinite(self.demand.length):
            self.reserves["length"] = self.demand.length / self.length * (1 + AS_TYPED)

    @property
    def length(self) -> FloatArray:
        """Length of the reducer, m."""
        found: FloatArray = self.span + 2 * self.plate
        return found

    @property
    def places(self) -> list[FloatArray]:
        """Middle of each disc from the inner face of the carrier, m."""
        first, pitch = self.gap + self.width / 2, self.width + self.gap
        return [first + index * pitch for index in range(self.discs)]

    def _pair(self, pin: str) -> tuple[float, float]:
        """Reduced modulus of a disc and its pins, Pa, and pressure that is estimated to last;
        infinite if no limit of them is known.
        """
        bodies = [MATERIALS[each].material for each in (pin, self.demand.disc)]
        gives = sum((1 - each.poissons_ratio**2) / each.youngs_modulus for each in bodies)
        limits = [each.limit.pressure / SAFE for each in bodies if each.limit]
        limits += [
            each.yield_strength
            * first_yield(poissons_ratio=each.poissons_ratio, friction=self.demand.friction)
            for each in bodies
            if each.plastic and each.yield_strength
        ]
        return 1 / gives, min(limits, default=math.inf)

    def _press_ring(self, teeth: FloatArray) -> None:
        """Set the reserves of teeth and of the satellites' bearings by the set of pins that
        touch: ``F_i = max(l_i*beta - gap, 0)/c`` with ``sum F_i*l_i = T``.
        """
        (pin, circle, shift), short = (teeth.T[..., None], self._shortening(teeth))
        lobes, torque = self.demand.lobes, self.demand.disc_torque / self.discs
        shock = self.demand.application_factor
        modulus, limit = self._pair(self.demand.ring_pin)
        stiff = modulus * self.width / COMPLIANCE
        gap, ahead_by = self.demand.shop.modification(self.circle), self.demand.shop.zone / 2
        gap, asked = (each.astype(np.float32) for each in (gap, torque / stiff))
        pressed, off, load = np.zeros((3, len(self)))
        for place in range(POSITIONS):
            ahead = np.arange(1, (lobes + 1) // 2 + 1) - place / POSITIONS
            angles = 2 * np.pi / (lobes + 1) * ahead
            bend, slope = path_bends(short=short, lobes=lobes, less=1 - np.cos(angles))
            lever = shift * lobes * np.sin(angles) / slope
            bend = bend / circle
            curved = np.maximum(1 / pin + bend / (1 - pin * bend), 0)
            radial = (short - np.cos(angles)) / slope
            order = np.argsort(-lever, axis=1)
            lever, curved, radial = (
                np.take_along_axis(each, order, axis=1).astype(np.float32)[self.teeth]
                for each in (lever, curved, radial)
            )
            given = touching(lever=lever, gap=gap, asked=asked)
            pressed = np.maximum(pressed, stiff * (given * curved).max(axis=1))
            one = standing_out(lever=lever, gap=gap, asked=asked, given=given, by=ahead_by)
            off = np.maximum(off, stiff * (one * curved).max(axis=1))
            along = stiff * (given * radial).sum(axis=1)
            along -= 4 * torque / (math.pi * self.pin_circle)
            load = np.maximum(load, np.hypot(torque / (self.eccentricity * lobes), along))
        most = limit**2 * math.pi * self.width / modulus / shock
        self.reserves["ring_pressure_disc"] = most / pressed
        self.of_pieces = most / off
        speed = self.demand.input_speed * (1 + 1 / lobes)
        self.reserves["bearing_life"] = self._all_bear(self.bearing, speed) / load
        least = np.array([MIN_LOAD[each.kind] * each.dynamic_rating for each in self.bearings])
        self.slips = LEAST * load < least[self.bearing]
        apart = self.span + self.plate
        away = [(self.plate / 2 + place) / apart for place in self.places]
        turns = np.exp(2j * np.pi / self.discs * np.arange(self.discs))
        far = sum(share * turn for share, turn in zip(away, turns, strict=True))
        near = turns.sum() - far
        reaction = np.maximum(np.abs(near), np.abs(far)) * load
        bears = self._all_bear(self.crank, self.demand.input_speed)
        self.reserves["crank_bearing_life"] = bears / reaction

    def _play(self) -> None:
        """Set the reserve of the backlash of pins in holes and of the ring, if one is asked."""
        if self.demand.backlash:
            gap = self.demand.shop.modification(self.circle) / self.demand.lobes
            play = 2 * (self.demand.shop.clearance / self.pin_circle + gap / self.eccentricity)
            self.reserves["backlash"] = self.demand.backlash / (SPREAD * play)

    def _press_holes(self) -> None:
        """Set the reserves of holes and pins by the set of pins that touch with their clearance.
        They bend between both plates, and a disc presses more on the side where a pin slopes.
        """
        torque, radius = self.demand.disc_torque / self.discs, self.pin_circle
        span, at = self.span, self.places[(self.discs - 1) // 2]
        away = span - at
        modulus, limit = self._pair(self.demand.pin)
        elastic = MATERIALS[self.demand.pin].material.youngs_modulus
        bent = 64 * at * away / (3 * math.pi * elastic * self.pin**4 * span)
        soft = bent * at * away + COMPLIANCE / (modulus * self.width)
        clear = np.full(len(self), self.demand.shop.clearance)
        angles = 2 * np.pi / self.pins * np.arange(self.pins)
        force = np.zeros(len(self))
        for place in range(POSITIONS):
            lever = np.sin(angles + np.pi / self.pins * place / POSITIONS)
            lever = radius[:, None] * np.sort(np.maximum(lever, 0.0))[::-1]
            given = touching(lever=lever, gap=clear, asked=torque * soft)
            force = np.maximum(force, given.max(axis=1) / soft)
        line = modulus / COMPLIANCE * bent * force * abs(away - at)
        even, edge = force / self.width, line * self.width / 2
        line = np.where(even > edge, even + edge, np.sqrt(2 * force * line))
        curved = 1 / self.touching - 1 / (self.touching + self.eccentricity)
        pressure = np.sqrt(line * curved * modulus / math.pi)
        shock = self.demand.application_factor
        self.reserves["contact_pressure_hole"] = (limit / pressure) ** 2 / shock
        stress = 32 * force * at * away / span / (math.pi * self.pin**3)
        self.reserves["pin_fatigue"] = BENDING / stress / shock


def standing_out(
    *, lever: FloatArray, gap: FloatArray, asked: FloatArray, given: FloatArray, by: float
) -> FloatArray:
    """Approach of each pin, m, if it alone stands out of its place by a length, m; ``given`` are
    those of `touching` without that error.

    The turn of the disc gives way: a pin bears the torque alone, or with those that touched before.
    """
    touch = given > 0
    both = (lever**2 * touch).sum(axis=1)[:, None]
    turn = (asked[:, None] + (lever * touch).sum(axis=1)[:, None] * gap[:, None]) / both
    free = turn * lever - gap[:, None]
    more = np.where(
        touch, free + by * (1 - lever**2 / both), (free + by) * both / (both + lever**2)
    )
    alone = asked[:, None] / np.maximum(lever, 1e-9)
    found: FloatArray = np.maximum(np.minimum(more, alone), 0.0)
    return found


def touching(*, lever: FloatArray, gap: FloatArray, asked: FloatArray) -> FloatArray:
    """Approaches of pins, m, whose sum with their levers is asked, m^2.

    ``lever`` [designs, pins] in m, the largest first, ``gap`` [designs] in m of all pins, ``asked``
    [designs] torque over stiffness.
    """
    first, second = np.cumsum(lever, axis=1), np.cumsum(lever**2, axis=1)
    turn = (asked[:, None] + gap[:, None] * first) / second  # of the first 1, 2, ... pins
    holds = turn * lever > gap[:, None]
    count = np.maximum(holds.sum(axis=1), 1) - 1
    found = turn[np.arange(len(lever)), count]
    pressed: FloatArray = np.maximum(lever * found[:, None] - gap[:, None], 0.0)
    return pressed
