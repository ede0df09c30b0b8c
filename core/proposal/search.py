"""Search: the best designs of the screen, judged by the whole calculation."""

import math
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from core.checks.check import Check, Verdict
from core.checks.reserve import crank_verdict
from core.design.results import Results
from core.errors import CalculationError
from core.proposal.screen import Demand, Screen, numbers_of_pins
from core.proposal.shop import NOTCH, RELIABILITY

Document = dict[str, Any]
"""Design document in SI units, nested as its JSON is."""

Ended = Literal["wanted", "time", "all"]
"""Reason why a search ended: as many hold as wanted, the time is over, or no other promises to."""

ENOUGH = 1.25
"""Estimated reserve beyond which a shorter design comes first."""

HOPELESS = 0.6
"""Estimated reserve below which designs are judged only for the one that comes nearest."""

ALIKE = 2
"""Number of designs with the same ring pins, or with the same bearings, that are shown."""

NEAREST = 4
"""Number of designs that are judged for that one, if none promises more."""


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
        "friction": {"coefficient": shop.friction, "sleeve": at["touching"] > 0.51 * at["pin"]},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius": at["circle"],
            "ring_pin_radius": at["ring_pin"],
            "modification": {"equidistant": float(shop.modification(at["circle"]))},
            "pin_material": demand.ring_pin,
            "friction_coefficient": shop.friction,
        },
        "bearing": {"name": bearing.name},
        "crankshaft": {
            "shaft_diameter": crank.bore_diameter,
            "bearings": [{"name": crank.name}, {"name": crank.name}],
        },
        "satellite_body": {"bore_radius": bearing.outer_diameter / 2},
        "build": {"housing_diameter": demand.outer_diameter},
        "tolerances": {"process": shop.code},
        "requirements": asked,
    }


class Judged(NamedTuple):
    """Design that was judged by the whole calculation."""

    document: Document
    results: Results  # of the document
    verdict: Verdict  # under its torque

    @property
    def held(self) -> bool:
        """True if it does what is asked, as far as checks say."""
        return self.verdict.verdict in ("pass", "marginal")

    @property
    def ratios(self) -> dict[str, float]:
        """Asked over reached, above 1, by the codes of failed checks, the worst first."""
        found = {
            each.code: asked_over_reached(each)
            for each in self.verdict.checks
            if each.status == "fail"
        }
        return dict(sorted(found.items(), key=lambda item: -item[1]))

    @property
    def worst(self) -> float:
        """Largest of these ratios; infinite if the verdict is open for another reason."""
        return max(self.ratios.values(), default=math.inf)


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
    accepts : callable
        True if a design that holds also holds what its checks do not say.
    seconds : float
        Processor time after which no further design is judged, s.
    """

    def __init__(
        self,
        demands: Iterable[Demand],
        *,
        results_of: Callable[[Document], Results],
        accepts: Callable[[Judged], bool],
        seconds: float,
    ) -> None:
        self._began, self.seconds = time.process_time(), seconds
        self.results_of, self.accepts = results_of, accepts
        self.judged: list[Judged] = []
        self.ended: Ended = "all"
        self.screens = [
            Screen(demand, pins) for demand in demands for pins in numbers_of_pins(demand)
        ]
        self.screened = sum(map(len, self.screens))

    @property
    def spent(self) -> float:
        """Processor time since the beginning, s."""
        return time.process_time() - self._began

    @property
    def tally(self) -> list[Tally]:
        """Numbers of designs that each check rejects by the screen, most first."""
        failed, only = Counter[str](), Counter[str]()
        for screen in self.screens:
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
        their length, others by their reserve.
        """
        best = []
        for number, screen in enumerate(self.screens):
            reserve, length = screen.reserve, screen.length
            capped = np.minimum(reserve, ENOUGH)
            order = np.lexsort((-reserve, length.round(4), -capped))
            best += [(-capped[i], length[i].round(4), -reserve[i], number, int(i)) for i in order]
        for _, _, less, number, index in sorted(best):
            yield self.screens[number], index, -less

    def run(self, wanted: int) -> Iterator[Judged]:
        """Designs that hold, as they are found: `wanted` ones that pass, and then marginal ones, if
        fewer pass. Of equal ring pins, and of equal bearings, at most `ALIKE` are held.
        """
        marginal: list[Judged] = []
        passed, tried, shown = 0, set[Any](), Counter[Any]()
        for screen, index, reserve in self._ranked():
            if passed == wanted:
                self.ended = "wanted"
                break
            if self.spent > self.seconds:
                self.ended = "time"
                break
            if reserve <= 0 or (reserve < HOPELESS and len(self.judged) >= NEAREST):
                break
            family = screen.family(index)
            if family in tried or any(shown[each] >= ALIKE for each in family):
                continue
            tried.add(family)
            found = self._judge(document(screen=screen, index=index))
            if not (found and found.held and self.accepts(found)):
                continue
            shown.update(family)
            if found.verdict.verdict == "pass":
                passed += 1
                yield found
            else:
                marginal.append(found)
        yield from marginal[: wanted - passed]

    def _judge(self, made: Document) -> Judged | None:
        """Design judged by the whole calculation; None if it is refused."""
        try:
            results = self.results_of(made)
            found = Judged(made, results, crank_verdict(results))
        except CalculationError:
            return None
        self.judged.append(found)
        return found
