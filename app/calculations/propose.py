"""Whole reducers from a requirement: request and answer."""

import math
import time
from collections.abc import Iterator
from dataclasses import asdict
from functools import cache
from typing import TYPE_CHECKING, Any, Literal

from pydantic import Field, PrivateAttr

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.calculations.tolerance_study import ToleranceStudyRequest
from app.model import (
    AccuracyOut,
    Maybe,
    Report,
    RequestModel,
    ResponseModel,
    Size,
    StudyCalculation,
    Values,
    Whole,
    accuracy_values,
    core_paths,
    pointer,
    present,
    quantity,
    result,
    timed,
    untold,
)
from app.problems import refusal
from app.settings import Settings
from app.sources import WANG_2016, YANCHEVSKIY_2021
from app.units import from_si, to_si
from core.checks.cold_yield import cold_yield
from core.checks.reserve import NEAR, crank_verdict
from core.design.mass import mass
from core.design.results import Results
from core.design.sections import USUAL_LIFE
from core.errors import Accuracy, if_known
from core.material_table import MATERIALS
from core.materials import PLASTICS
from core.proposal.screen import Demand
from core.proposal.search import Document, Ended, Judged, Pieces, Search
from core.proposal.shop import SHOPS, ShopName
from core.tolerance.study import tolerance_study

SECONDS = 10.0
"""Processor time of a search that is answered in lines, s."""

SHARE = 0.5
"""Part of the time of a request that a search takes, if it is answered as a whole."""

MOST_RATIOS = 8
"""Largest number of ratios that are tried."""

STUDY: Values = {
    "samples": 256,
    "quantities": ["backlash_max_arcmin"],
    "percentiles": [90.0],
    "crank_angles": 12,
}
RING_STUDY = STUDY | {"samples": 64, "quantities": ["ring_max_pressure_MPa"]}
"""Requests of `/tolerance-study` for the pieces of a design, beside the design: forces take six
times as long as backlash and spread less."""

METALS = tuple(
    name for name, each in MATERIALS.items() if each.group not in PLASTICS and not each.missing
)
"""Metals; without a known limit of the contact pressure no design holds."""

SOFT = tuple(
    name
    for name, each in MATERIALS.items()
    if each.group in PLASTICS and not each.missing and each.material.strengths
)
"""Plastics of known strength."""

WITHOUT_DENSITY = tuple(name for name in METALS + SOFT if MATERIALS[name].material.density is None)
"""Materials whose discs have no known mass."""

if TYPE_CHECKING:
    Metal = str
    DiscMaterial = str
else:
    Metal, DiscMaterial = Literal[METALS], Literal[METALS + SOFT]


class MaterialsFields(RequestModel, group="propose"):
    """Materials by name in place of those of the process."""

    disc: Maybe[DiscMaterial] = quantity(
        "Material of the discs", help="In place of that of the process."
    )
    pins: Maybe[Metal] = quantity(
        "Material of the output pins", help="And of sleeves; in place of that of the process."
    )
    ring_pins: Maybe[Metal] = quantity(
        "Material of the ring pins", help="In place of that of the process."
    )


class ProposeRequest(RequestModel, group="propose"):
    """Task of a reducer with cycloid discs, and how it is made."""

    torque_Nm: float = quantity(
        "Output torque", "T₂", help="Torque of the output.", ge=1e-3, le=1e6
    )
    ratio: Whole = quantity(
        "Ratio", "i", help="Speed of the input over that of the output.", ge=5, le=119
    )
    ratio_to: Maybe[Whole] = quantity(
        "Largest ratio",
        help=f"Largest of at most {MOST_RATIOS} ratios that are tried, from the ratio on.",
        ge=5,
        le=119,
    )
    outer_diameter_mm: float = quantity(
        "Largest outer diameter", "D", help="Diameter that the reducer may have.", ge=30, le=600
    )
    length_mm: Maybe[float] = quantity(
        "Largest length",
        "L",
        help="Length that the reducer may have, without motor, output bearing and seals.",
        ge=10,
        le=1000,
    )
    input_speed_rpm: float = quantity(
        "Input speed", "n₁", help="Speed of the crankshaft.", default=1500.0, ge=1, le=20_000
    )
    life_h: Maybe[float] = quantity(
        "Life",
        "L_h",
        help="Life that bearings and teeth last: 5,000 h if none is given, 500 h of plastic discs.",
        ge=10,
        le=2e5,
    )
    application_factor: Size = quantity(
        "Application factor",
        "K_A",
        help="Factor on the torque for stresses and pressures, not "
        "for losses, wear and the life of bearings; 1 where not given.",
        default=1.0,
        step=0.05,
    )
    process: ShopName = quantity(
        "Process",
        help="How discs and pins are made: materials, fit, modification.",
        default="precise",
    )
    materials: MaterialsFields = Field(default_factory=MaterialsFields)
    output: Literal["pins", "ring"] = quantity(
        "Output", help="Member that gives the output torque; the other one stands.", default="pins"
    )
    discs: Literal[1, 2, 3] = quantity(
        "Discs", "K", help="Number of discs; one comes with counterweights.", default=2
    )
    min_efficiency: Maybe[float] = quantity(
        "Least efficiency", "η", help="Efficiency of pins and teeth.", ge=0.1, le=0.99
    )
    max_backlash_arcmin: Maybe[float] = quantity(
        "Largest backlash",
        "j",
        help="Backlash at the output that nine tenths of the pieces keep.",
        ge=0.01,
        le=600,
    )
    wanted: Whole = quantity(
        "Proposals", help="Number of proposals after which the search ends.", default=5, ge=1, le=10
    )

    @property
    def ratios(self) -> range:
        """Ratios that are tried."""
        return range(self.ratio, (self.ratio_to or self.ratio) + 1)

    _seconds: float = PrivateAttr(default=SECONDS)

    @property
    def seconds(self) -> float:
        """Processor time of a search that is answered as a whole, s."""
        return self._seconds

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse an empty range of ratios, one with too many of them, and one disc whose mass, for
        its counterweights, is not known.
        """
        super().refuse_beyond(settings)
        self._seconds = SHARE * settings.max_seconds
        count, low = len(self.ratios), self.ratios.start
        if not 1 <= count <= MOST_RATIOS:
            code = "less_than_equal" if count else "greater_than_equal"
            limit = low + MOST_RATIOS - 1 if count else low
            raise refusal("/ratio_to", code, limit=limit)
        if self.discs == 1 and self.materials.disc in WITHOUT_DENSITY:
            known = [name for name in METALS + SOFT if name not in WITHOUT_DENSITY]
            raise refusal("/materials/disc", "literal_error", expected=", ".join(known))

    def cost(self) -> float:
        """Infinite, as a search takes seconds."""
        return math.inf

    @property
    def demands(self) -> Iterator[Demand]:
        """Task for each ratio."""
        chosen, shop = self.materials.given, SHOPS[self.process]
        usual_life = USUAL_LIFE / (10 if chosen.get("disc", shop.disc) in SOFT else 1)
        for ratio in self.ratios:
            yield Demand(
                torque=self.torque_Nm,
                ratio=ratio,
                outer_diameter=to_si("outer_diameter_mm", self.outer_diameter_mm),
                length=to_si("length_mm", self.length_mm) or math.inf,
                input_speed=to_si("input_speed_rpm", self.input_speed_rpm),
                life=to_si("life_h", self.life_h) or usual_life,
                shop=shop,
                disc_material=chosen.get("disc", ""),
                pin_material=chosen.get("pins", ""),
                ring_pin_material=chosen.get("ring_pins", ""),
                output=self.output,
                application_factor=self.application_factor,
                discs=self.discs,
                efficiency=self.min_efficiency,
                backlash=to_si("max_backlash_arcmin", self.max_backlash_arcmin),
            )


class ColumnsOut(ResponseModel):
    """Numbers that tell proposals apart."""

    outer_diameter_mm: float = result("Outer diameter.", symbol="D")
    length_mm: float = result("Length, without motor, output bearing and seals.", symbol="L")
    mass_kg: Maybe[float] = result(
        "Mass, without motor and output bearing; housing, carrier and shaft are estimates.",
        symbol="m",
    )
    largest_torque_Nm: Maybe[float] = result("Torque at which the first check fails.")
    yield_torque_Nm: Maybe[float] = result(
        "Torque at which plastic discs yield at once, in place of the largest torque."
    )
    lasting_torque_Nm: Maybe[float] = result(
        "Quarter of that torque, at which the stress is half of the strength."
    )
    backlash_arcmin: Maybe[float] = result(
        "Backlash at the output that nine tenths of the pieces keep: `/tolerance-study` of the "
        "design with `study`."
    )
    efficiency: Maybe[float] = result("Efficiency of pins and teeth.", symbol="η")
    ring_utilisation: Maybe[float] = result(
        "Pressure between teeth and ring pins that nine tenths of the pieces keep, over its limit: "
        "`/tolerance-study` of the design with `ring_study`."
    )


class ProposalOut(ResponseModel):
    """A whole reducer."""

    design: dict[str, Any] = Field(description="Request of `/crank-planetary`.")
    verdict: str = Field(description="Its verdict there.")
    governing: Maybe[str] = Field(description="Code of the check that decides.")
    columns: ColumnsOut


class TallyOut(ResponseModel):
    """Number of screened designs that a check rejects by estimates."""

    code: str = Field(description="Code of the check.")
    failed: int = Field(description="Number of designs that it rejects.")
    only_this: int = Field(description="Number of designs that hold all else.")


class RatioOut(ResponseModel):
    """Demand of a check over what is reached."""

    code: str = Field(description="Code of the check.")
    asked_over_reached: Maybe[float] = Field(
        description="Demand over what is reached: of the torque, where it decides."
    )
    missing: Maybe[list[str]] = Field(
        description="JSON pointers into `design` to values without which the check stays open."
    )


class NearestOut(ProposalOut):
    """Judged design that comes nearest where none holds."""

    lacks: list[RatioOut] = Field(description="Failed checks, the worst first.")


class ProposeResponse(ResponseModel):
    """Reducers that do what is asked, each judged by the whole calculation."""

    proposals: list[ProposalOut] = Field(
        description="Designs that hold, of different ring pins or bearings."
    )
    nearest: Maybe[NearestOut] = Field(
        description="Design that comes nearest; absent if one holds."
    )
    processes: Maybe[list[str]] = Field(
        description="Other processes by whose estimate a design would hold; absent if one holds."
    )
    tally: list[TallyOut] = Field(description="Why screened designs do not hold, most first.")
    study: dict[str, Any] = Field(
        description="What `/tolerance-study` is asked beside a design for the backlash of pieces."
    )
    ring_study: dict[str, Any] = Field(
        description="What it is asked for the pressure between their teeth and ring pins."
    )
    screened: int = Field(description="Number of designs that were estimated.")
    judged: int = Field(description="Number of designs that were judged.")
    ended: Ended = Field(
        description="Why the search ended: `wanted` as many hold, `time` is over, or `all` others "
        "promise nothing."
    )
    accuracy: AccuracyOut = Field(description="That of the largest torques.")


@cache
def _paths() -> dict[str, list[tuple[str, ...]]]:
    return core_paths(CrankPlanetaryRequest)


def _names(name: str) -> tuple[str, ...]:
    """Names of a field of a request of `/crank-planetary`, outermost first, by its core name."""
    depth = name.count(".") + 1
    return next(each for each in _paths()[name] if len(each) == depth)


def in_json(document: Document, within: str = "") -> dict[str, Any]:
    """Design document, or a section of it by its core name, as a request of `/crank-planetary`."""
    body: dict[str, Any] = {}
    for name, value in document.items():
        path = f"{within}.{name}".lstrip(".")
        own = _names(path)[-1]
        if isinstance(value, dict):
            body[own] = in_json(value, path)
        elif isinstance(value, list):
            body[own] = [in_json(each, path) for each in value]
        else:
            shown = from_si(own, value)
            body[own] = float(f"{shown:.9g}") if isinstance(shown, float) else shown
    return body


def _results(document: Document) -> Results:
    """Results of a document, as whoever posts it gets them."""
    return CrankPlanetaryRequest.model_validate(in_json(document)).results


def _kept(body: Values) -> tuple[float, float | None]:
    """Share of the pieces that go together, and what nine tenths of them keep, by a request of
    `/tolerance-study` for one quantity.
    """
    asked = ToleranceStudyRequest.model_validate(body)
    found = tolerance_study(asked.study(untold), errors=False)
    kept = asked.kept(asked.names[0], found)
    return float(found.fits.mean()), kept[0]["value"] if kept else None


def pieces_of(document: Document) -> Pieces:
    """Pieces of a document."""
    body = in_json(document)
    together, backlash = _kept(body | STUDY)
    if backlash is None:
        return Pieces(together)
    _, pressure = _kept(body | RING_STUDY)
    return Pieces(together, to_si("backlash_arcmin", backlash), to_si("pressure_MPa", pressure))


class _Found:
    """Proposals of a request, as they are found."""

    def __init__(self, body: ProposeRequest, report: Report, seconds: float) -> None:
        self.body, self.seconds = body, seconds
        self.search = Search(
            body.demands,
            results_of=_results,
            pieces=pieces_of,
            seconds=seconds,
            clock=time.monotonic if report is untold else time.process_time,
        )
        self.shown: list[Values] = []
        for found in self.search.run(body.wanted):
            self.shown.append(self.proposal(found))
            share = max(len(self.shown) / body.wanted, self.search.spent / seconds)
            report(min(share, 1.0), proposal=self.shown[-1])

    def proposal(self, found: Judged) -> Values:
        """Values of a proposal."""
        results = found.results
        torque, outside = results.design.output_torque, results.design.envelope
        metal = found.held and not found.plastic
        largest = crank_verdict(results, largest=True) if metal else found.verdict
        pieces = found.pieces if found.holds else None
        soft = cold_yield(results=results, found=found.verdict)
        columns = {
            "outer_diameter_mm": from_si("outer_diameter_mm", outside.outer_diameter),
            "length_mm": from_si("length_mm", outside.length),
            "mass_kg": if_known(lambda: mass(results.design).mass),
            "largest_torque_Nm": largest.largest_torque(torque),
            "yield_torque_Nm": soft and soft.torque,
            "lasting_torque_Nm": soft and soft.quarter,
            "backlash_arcmin": from_si("backlash_arcmin", pieces and pieces.backlash),
            "ring_utilisation": pieces and found.ring_utilisation,
            "efficiency": if_known(lambda: float(results.losses.total_efficiency)),
        }
        return {
            "design": in_json(found.document),
            "verdict": found.verdict.verdict,
            "governing": found.verdict.governing,
            "columns": present(columns),
        }

    @property
    def processes(self) -> list[str] | None:
        """Other processes by whose estimate a design holds, if none holds by this one; as many as
        the time allows.
        """
        if self.shown:
            return None
        found = list[str]()
        for process in SHOPS:
            if process != self.body.process and self.search.spent < self.seconds:
                demands = self.body.model_copy(update={"process": process}).demands
                other = Search(demands, results_of=_results, pieces=pieces_of, seconds=0.0)
                found += [process] * other.hopeful
        return found

    @property
    def nearest(self) -> Values | None:
        """Values of the design that comes nearest if none holds."""
        found = None if self.shown else self.search.nearest
        if found is None:
            return None
        lacks = []
        for code, over in found.ratios.items():
            check = found.unknown.get(code)
            names = [pointer(_names(each)) for each in check.missing] if check else []
            known = over if math.isfinite(over) else None
            lacks.append(
                present({"code": code, "asked_over_reached": known, "missing": names or None})
            )
        return self.proposal(found) | {"lacks": lacks}


def reporting(body: ProposeRequest, report: Report, seconds: float = SECONDS) -> Values:
    """Values of the search; proposals are reported as they are found."""
    found, run_time_us = timed(lambda: _Found(body, report, seconds))
    search = found.search
    values = {
        "proposals": found.shown,
        "nearest": found.nearest,
        "processes": found.processes,
        "tally": [asdict(each) for each in search.tally],
        "study": STUDY,
        "ring_study": RING_STUDY,
        "screened": search.screened,
        "judged": len(search.judged),
        "ended": search.ended,
        "accuracy": accuracy_values(Accuracy("bracketing", NEAR - 1, search.screened), run_time_us),
    }
    return present(values)


def solve(body: ProposeRequest) -> Values:
    """Whole reducers with cycloid discs that do what is asked: of pins, bearings and lengths that
    can be bought, each judged as `/crank-planetary` judges it.

    Many designs are estimated, and the best ones are judged until as many as wanted hold or the
    time is over. Where none holds, the tally says why, and `nearest` is the design that lacks
    least. The header `Accept: application/x-ndjson` asks for an answer in lines:
    `{"progress": 0.4, "proposal": {...}}` as soon as one is found, and at last `{"result": ...}` or
    `{"problem": ...}`. Closing the connection ends the search.
    """
    return reporting(body, untold, body.seconds)


CALCULATION = StudyCalculation(
    name="propose",
    title="Reducers from a requirement",
    tag="exploration",
    request=ProposeRequest,
    answer=ProposeResponse,
    solve=solve,
    sources=(YANCHEVSKIY_2021, WANG_2016),
    batched=False,
    reporting=reporting,
)
