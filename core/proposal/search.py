"""Search: the best designs of the screen, judged by the whole calculation."""

import math
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np

from core.checks.check import MARGIN, Check, Verdict
from core.checks.contacts import PLASTICS
from core.checks.reserve import crank_verdict
from core.design.mass import mass
from core.design.results import Results
from core.errors import CalculationError
from core.proposal.screen import MOST, Demand, Screen, numbers_of_pins
from core.proposal.shop import NOTCH, RELIABILITY, Shop
from core.tolerance.iso286 import Limits, class_limits
from core.tolerance.processes import PROCESSES

Document = dict[str, Any]
"""Design document in SI units, nested as its JSON is."""

Ended = Literal["wanted", "time", "all"]
"""Reason why a search ended: as many hold as wanted, the time is over, or no other promises to."""

ENOUGH = 1.25
"""Estimated reserve beyond which a smaller design comes first."""

SLIPS = 0.4
"""Reserve that a satellite's bearing of too little load for its size is worth."""

RANKED = 2000
"""Number of designs of a screen that may be judged."""

TOGETHER = 0.9
"""Least part of the pieces that go together."""

SMALLER = 1.0, 0.8, 0.64
"""Outer diameters that are tried, over the largest one."""

HOPELESS = 0.6
"""Estimated reserve below which designs are judged only for the one that comes nearest."""

ALIKE = 2
"""Number of designs with the same ring pins and bearings, but other output pins, that are shown."""

NEAREST = 4
"""Number of designs that are judged for that one, if none promises more."""


def diameters(most: float) -> list[float]:
    """Outer diameters that are tried, m: the largest one to 0.1 um, and smaller ones to 1 mm."""
    largest, *others = (most * part for part in SMALLER)
    return [math.floor(largest * 1e7 + 1e-3) / 1e7, *(math.floor(d * 1e3) / 1e3 for d in others)]


def _tolerances(shop: Shop, pin_radius: float) -> Document:
    """Tolerances of the pieces of a shop; limits of pins where those of holes are of no class."""
    made = PROCESSES[shop.code].hole
    sizes = {"hole": made, "pin": shop.pin_class, "ring_pin": shop.pin_class}
    if isinstance(made, Limits):
        sizes["pin"] = class_limits(size=2 * pin_radius, tolerance_class=shop.pin_class)
    return {
        **{f"{part}_position": shop.zone for part in sizes},
        **{
            f"{part}_diameter": asdict(size)
            if isinstance(size, Limits)
            else {"tolerance_class": size}
            for part, size in sizes.items()
        },
    }


def document(*, screen: Screen, index: int) -> Document:
    """Design document of a design of a screen."""
    demand, shop = screen.demand, screen.demand.shop
    names = ("ring_pin", "circle", "eccentricity", "pin", "touching", "pin_circle", "width")
    at = {name: round(float(getattr(screen, name)[index]), 9) for name in names}
    bearing, crank = (screen.bearings[each[index]] for each in (screen.bearing, screen.crank))
    asked = {"life": demand.life, "max_outer_diameter": demand.outer_diameter}
    if demand.length < math.inf:
        asked["max_length"] = demand.length
    if demand.efficiency:
        asked["min_efficiency"] = demand.efficiency
    if demand.backlash:
        asked["max_backlash"] = demand.backlash
    return {
        "mechanism": {
            "pins": screen.pins,
            "satellites": screen.discs,
            "satellite_teeth": demand.lobes,
            "ring_teeth": demand.lobes + 1,
            "output": demand.output,
        },
        "load": {
            "output_torque": demand.torque,
            "input_speed": demand.input_speed,
            "pin_circle_radius": at["pin_circle"],
            "application_factor": demand.application_factor,
        },
        "contact": {
            "eccentricity": at["eccentricity"],
            "pin_radius": at["touching"],
            "contact_length": at["width"],
            "hole_clearance": shop.clearance,
            "pin_material": demand.pin,
            "hole_material": demand.disc,
        },
        "pin": {"support": "supported", "diameter": at["pin"]},
        "fatigue": {
            "surface": "ground",
            "fatigue_notch_factor": NOTCH,
            "reliability_percent": RELIABILITY,
        },
        "friction": {"coefficient": demand.friction, "sleeve": at["touching"] > 0.51 * at["pin"]},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius": at["circle"],
            "ring_pin_radius": at["ring_pin"],
            "modification": {"equidistant": float(shop.modification(at["circle"]))},
            "pin_material": demand.ring_pin,
            "friction_coefficient": demand.friction,
        },
        "bearing": {"name": bearing.name},
        "crankshaft": {
            "shaft_diameter": crank.bore_diameter,
            "bearings": [{"name": crank.name}, {"name": crank.name}],
        },
        "satellite_body": {"bore_radius": bearing.outer_diameter / 2},
        "build": {"housing_diameter": screen.diameter},
        "tolerances": _tolerances(shop, at["touching"]),
        "requirements": asked,
    }


MOVED = ("discs", "satellite_bearings")
"""Parts that move on the circle of the eccentricity."""


def balanced(*, made: Document, results_of: Callable[[Document], Results]) -> Document:
    """Design of one disc with counterweights in the planes of the crankshaft's bearings, to three
    digits. The densities of discs and the masses of bearings have to be known.
    """
    parts = mass(results_of(made).design).parts
    moved = sum(each.mass or math.nan for each in parts if each.code in MOVED)
    shaft = made["crankshaft"] | {"satellite_mass": float(f"{moved:.3g}")}
    own = results_of(made | {"crankshaft": shaft})
    planes = own.design.crankshaft.places["bearing_positions"]
    shaft["counterweights"] = [
        {"unbalance": float(f"{each.unbalance:.3g}"), "position": place, "angle": each.angle}
        for place, each in zip(planes, own.crank.balance.corrections, strict=True)
    ]
    return made | {"crankshaft": shaft}


FIRST_YIELD = ("contact_static_cold", "ring_static_cold")
"""Checks of the first yield of plastic holes and teeth."""

OF_PLASTICS = {each.code for each in PLASTICS} | {
    *FIRST_YIELD,
    "contact_pressure_hole",
    "ring_pressure_disc",
}
"""Checks that may stay open of discs of plastic."""


BETWEEN = "ring_pin_room"
"""Check of the room between ring pins."""

OF_RING = ("ring_pressure_disc", "ring_pressure_pin", "ring_static_cold")
"""Checks of the pressure between discs and ring pins."""


OF_PIECES = "ring_pieces"
"""Check of a ring pin within its tolerance, which the pieces of a design judge better."""


class Pieces(NamedTuple):
    """Pieces of a design with the tolerances of its document."""

    together: float  # share of them that go together
    backlash: float | None = None  # of the output, that nine tenths of them keep, rad
    ring_pressure: float | None = None  # that nine tenths of them keep, Pa


@dataclass(frozen=True)
class Judged:
    """Design that was judged by the whole calculation."""

    document: Document
    results: Results  # of the document
    verdict: Verdict  # under its torque, of parts without errors
    pieces_of: Callable[[Document], Pieces]  # pieces of a document

    @cached_property
    def pieces(self) -> Pieces:
        """Pieces with the tolerances of the document; none go together if they are refused."""
        try:
            return self.pieces_of(self.document)
        except CalculationError:
            return Pieces(0.0)

    @property
    def missed(self) -> dict[str, float]:
        """Asked over reached, above 1, of assembly and backlash of the pieces of a design that
        holds otherwise.
        """
        if not self.holds:
            return {}
        together, backlash, _ = self.pieces
        if together < TOGETHER:
            return {"interference": math.inf}
        over = (backlash or 0.0) / self.document["requirements"].get("max_backlash", math.inf)
        return {"backlash": over} if over > 1 else {}

    @property
    def ring_utilisation(self) -> float | None:
        """Largest part of a limit of the ring's pressure that nine tenths of the pieces keep; None
        if it is not known.
        """
        of_ring = [each for each in self.verdict.checks if each.code in OF_RING]
        found = [each.utilisation for each in of_ring if each.utilisation is not None]
        pressure = self.pieces.ring_pressure
        if not found or pressure is None:
            return None
        return max(found) * pressure / self.results.ring.working[0].max_pressure

    @property
    def plastic(self) -> bool:
        """True if only checks of plastics are open, which no source can close, and the torque is
        below that at which the plastic yields.
        """
        checks = self.verdict.checks
        open_codes = {each.code for each in checks if each.opens}
        parts = {each.code for each in self.verdict.parts if each.status == "open"}
        named = {each.code: each for each in checks if each.code in FIRST_YIELD}
        below = all(each.by_torque and not _yields(each) for each in named.values())
        return (
            len(named) == len(FIRST_YIELD)
            and below
            and open_codes <= OF_PLASTICS
            and parts <= {"contact", "teeth"}
        )

    @property
    def passed(self) -> bool:
        """True if all checks pass, but for those of plastics that no source can close; parts are
        without errors.
        """
        of_parts = (each for each in self.verdict.checks if each.code != OF_PIECES)
        return self.holds and not any(each.status == "marginal" for each in of_parts)

    @property
    def holds(self) -> bool:
        """True if it does what is asked with parts without errors."""
        said = self.verdict.verdict
        return said in ("pass", "marginal") or (said == "incomplete" and self.plastic)

    @property
    def held(self) -> bool:
        """True if it and its pieces do what is asked."""
        return self.holds and not self.missed

    @property
    def unknown(self) -> dict[str, Check]:
        """Checks that are open for another reason than that no source closes them for a plastic."""
        soft = OF_PLASTICS if any(each.code in FIRST_YIELD for each in self.verdict.checks) else ()
        return {
            each.code: each for each in self.verdict.checks if each.opens and each.code not in soft
        }

    @property
    def ratios(self) -> dict[str, float]:
        """Asked over reached, above 1, by the codes of failed checks, the worst first; infinite for
        those that are open.
        """
        found = {
            each.code: asked_over_reached(each)
            for each in self.verdict.checks
            if each.status == "fail" or (each.code in FIRST_YIELD and _yields(each))
        }
        found |= dict.fromkeys(self.unknown, math.inf) | self.missed
        return dict(sorted(found.items(), key=lambda item: -item[1]))

    @property
    def worst(self) -> float:
        """Largest of these ratios; infinite if the verdict is open for another reason."""
        return max(self.ratios.values(), default=math.inf)


def _yields(check: Check) -> bool:
    """True if a check of the first yield does not hold at the least strength."""
    return check.by_torque and check.reserve < 1


def asked_over_reached(check: Check) -> float:
    """Asked over reached of a failed check: of the torque where it decides, else of the value."""
    if check.by_torque and check.reserve > 0:
        return 1 / check.reserve
    value, limit = check.compared
    over = (limit, value) if check.kind.keep == "above" else (value, limit)
    return over[0] / over[1] if over[1] > 0 else math.inf


@dataclass(frozen=True, slots=True)
class Tally:
    """Number of designs that a check rejects."""

    code: str  # of the check
    failed: int  # designs that it rejects
    only_this: int  # designs that hold all else


class Search:
    """Search for designs that do what is asked.

    Parameters
    ----------
    demands : iterable of Demand
        What is asked, for each ratio.
    results_of : callable
        Results of a document; it may raise `CalculationError`.
    pieces : callable
        Pieces of a document with the tolerances in it.
    seconds : float
        Time, s, by the clock; no design is begun that is expected to end more than half after it.
    clock : callable
        Processor time, or what passes of a request that waits, s.
    """

    def __init__(
        self,
        demands: Iterable[Demand],
        *,
        results_of: Callable[[Document], Results],
        pieces: Callable[[Document], Pieces],
        seconds: float,
        clock: Callable[[], float] = time.process_time,
    ) -> None:
        self._now, self.seconds = clock, seconds
        self._began = clock()
        self.results_of, self.pieces = results_of, pieces
        self.judged: list[Judged] = []
        self.shares: dict[str, float] = {}  # judged over estimated reserve of checks not passed
        self.shown = Counter[Any]()  # designs that hold, by what they share with others
        self.ended: Ended = "all"
        tried = [
            (demand, pins, diameter)
            for demand in demands
            for pins in numbers_of_pins(demand)
            for diameter in diameters(demand.outer_diameter)
        ]
        self.screens = [
            Screen(demand, pins=pins, diameter=diameter, most=MOST // (demand.lobes * len(tried)))
            for demand, pins, diameter in tried
        ]
        self.screened = sum(map(len, self.screens))
        self._looked, self._longest = self.spent, 0.0  # time of the last design, and the longest, s

    @property
    def spent(self) -> float:
        """Time since the beginning, s."""
        return self._now() - self._began

    @property
    def hopeful(self) -> bool:
        """True if a design is estimated to pass."""
        return any((screen.reserve > MARGIN).any() for screen in self.screens)

    @property
    def tally(self) -> list[Tally]:
        """Numbers of designs that each check rejects by the screen, most first; of ring pins that
        have no room on their circle the number of sizes.
        """
        failed, only = Counter[str](), Counter[str]()
        for screen in self.screens:
            failed[BETWEEN] += screen.crowded
            named = screen.rejected
            count = np.sum([*named.values()], axis=0)
            for code, wrong in named.items():
                failed[code] += int(wrong.sum())
                only[code] += int((wrong & (count == 1)).sum())
        return [Tally(code, number, only[code]) for code, number in failed.most_common() if number]

    @property
    def nearest(self) -> Judged | None:
        """Judged design whose largest ratio of asked to reached is least, if none holds."""
        known = [each for each in self.judged if each.ratios]
        return min(known, key=lambda each: each.worst, default=None)

    def _ranked(self) -> Iterator[tuple[Screen, int, float]]:
        """Designs with the reserve that is estimated, the best first: those with enough reserve by
        that of their pieces, and by their volume; others by their reserve.
        """
        best = []
        for number, screen in enumerate(self.screens):
            reserve = screen.reserve
            volume = screen.length * screen.diameter**2
            promise = np.minimum(reserve, ENOUGH) - SLIPS * screen.slips
            pieces = np.minimum(screen.of_pieces, ENOUGH)
            order = np.lexsort((volume, -pieces, -promise))[:RANKED]
            best += [
                (-promise[i], -pieces[i], volume[i], -reserve[i], number, int(i)) for i in order
            ]
        for *_, less, number, index in sorted(best):
            if less < 0:
                yield self.screens[number], index, -less

    def _candidates(self) -> Iterator[tuple[Screen, int]]:
        """Designs to judge: first those expected to pass, then those expected to be marginal; of
        these first those with other ring pins and other bearings than all that are shown.
        """
        ranked, tried = [*self._ranked()], set[Any]()
        passes = (MARGIN, False, 1), (MARGIN, True, 1), (MARGIN, True, ALIKE), (1.0, True, ALIKE)
        for least, both, most in passes:
            for screen, index, reserve in ranked:
                family = screen.family(index)
                shown = max(self.shown[each] for each in ((family,) if both else family))
                if (screen.pins, family) in tried or shown >= most:
                    continue
                enough = len(self.judged) >= NEAREST
                if (enough or least > 1) and self._expected(screen, index) < least:
                    continue
                if enough and reserve < HOPELESS:
                    continue
                tried.add((screen.pins, family))
                yield screen, index

    def run(self, wanted: int) -> Iterator[Judged]:
        """Designs that hold, as they are found: `wanted` ones that pass, and then marginal ones, if
        fewer pass. At most `ALIKE` have the same ring pins and bearings.
        """
        marginal, held = list[Judged](), 0
        for screen, index in self._candidates():
            if self._ends(bool(self.judged), held == wanted):
                break
            found = self._judge(document(screen=screen, index=index))
            if not found:
                continue
            if found.unknown and {*found.unknown} == {*found.ratios}:
                break  # every design lacks these values
            if not found.passed:
                self._learn(screen, index, found.verdict)
                marginal += [found] * found.holds
            elif found.held:
                family = screen.family(index)
                self.shown.update((family, *family))
                held += 1
                yield found
        for found in marginal:
            if self._ends(held > 0, held == wanted):
                break
            if found.held:
                held += 1
                yield found

    def _ends(self, enough: bool, all_found: bool) -> bool:
        """True if as many hold as wanted, or if enough was found and the time is nearer than the
        end of another design.
        """
        now, before = self.spent, self._looked
        self._longest, self._looked = max(self._longest, now - before), now
        late = enough and now + self._longest / 2 > self.seconds
        if all_found or late:
            self.ended = "wanted" if all_found else "time"
        return all_found or late

    def _learn(self, screen: Screen, index: int, found: Verdict) -> None:
        """Keep the judged over the estimated reserve of checks that do not pass, the largest of
        each.
        """
        for check in found.checks:
            said = check.status in ("fail", "marginal") and check.code in screen.reserves
            if said and check.by_torque:
                share = check.reserve / float(screen.reserves[check.code][index])
                self.shares[check.code] = max(share, self.shares.get(check.code, 0.0))

    def _expected(self, screen: Screen, index: int) -> float:
        """Least reserve that checks are expected to have, which did not pass for other designs."""
        of_checks = (
            float(screen.reserves[code][index]) * share for code, share in self.shares.items()
        )
        return min(of_checks, default=math.inf)

    def _judge(self, made: Document) -> Judged | None:
        """Design judged by the whole calculation; None if it is refused."""
        try:
            if made["mechanism"]["satellites"] == 1:
                made = balanced(made=made, results_of=self.results_of)
            results = self.results_of(made)
            found = Judged(made, results, crank_verdict(results), self.pieces)
        except CalculationError:
            return None
        self.judged.append(found)
        return found
