"""Effect of tolerances on the pieces: request and answer."""

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, partial
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Field, PrivateAttr

from app.calculations.document import FORCES, LOADED, TOUCHING, Needs
from app.calculations.members_answer import factor_at_output
from app.calculations.solved_design import (
    FLOATS_AS_LONG,
    LEFT_OUT,
    SolvedFields,
    lost_motion_torque_share,
)
from app.calculations.tolerance_answer import ContributionOut, EstimateOut, ToleranceStudyResponse
from app.calculations.tolerance_figure import tolerance_figure
from app.calculations.tolerances import TolerancesFields, as_given
from app.cluster import Lost, on_cluster
from app.model import (
    Maybe,
    Report,
    RequestModel,
    Size,
    StudyCalculation,
    Values,
    Whole,
    accuracy_values,
    quantity,
    timed,
    untold,
    warning,
)
from app.problems import refusal, unavailable
from app.settings import Settings, current
from app.sources import ISO_286, JANSEN_1999, YANCHEVSKIY_2021
from app.theme import Figure, Theme
from app.units import core_name, from_si, to_si
from app.worked import stated
from core.arrays import FloatArray
from core.design.document import changed
from core.design.results import Results
from core.errors import Accuracy, InvalidInput, Notice
from core.ring.series import MeshesInSeries
from core.ring.series_study import FINER, SeriesStudy
from core.tolerance.contributions import MOST_FIT, contributions
from core.tolerance.quantiles import Estimate, refuse_few
from core.tolerance.study import (
    FINER_SAMPLES,
    Evaluation,
    Mapped,
    Study,
    ToleranceStudy,
    tolerance_study,
)
from core.tolerance.tolerances import Tolerances

POSITIONS_PER_SECOND = 500_000
"""Number of positions of a pair allowed for each second of a calculation; one processor solves some
three times as many with the slowest law."""

LOST_MOTION_SOLVES = 3
"""Number of solutions of a position for the lost motion, in both directions besides."""

BACKLASH_SOLVES = 0.1
"""Cost of a position if only the backlash is requested, whose ends are closed forms; given shares
need the room around the whole turn instead."""

TURNS_IN_SERIES = 4
"""Factor on the number of positions of both meshes in series, over all turns of their period."""

LOOKED_CLOSER = FINER * FINER_SAMPLES
"""Number of samples that take as long as the second look between positions."""

FEWEST = 20
"""Number of samples that a mechanism must allow; otherwise it has too many pairs for a study."""

MAX_SAMPLES = 1_000_000

OF_THE_RING = (
    "ring_pin_position_mm",
    "ring_pin_diameter",
    "equidistant_mm",
    "modification_pin_circle_mm",
)
"""Tolerances of ring pins and of the cycloid discs on them."""

USUAL_SAMPLES = 4096
USUAL_RANKED_SAMPLES = 1024
"""Number of samples if none is given and as many fit; the second one is with contributions."""


_limit = partial(
    quantity, help="Limit for which the yield is calculated, together with the quantity itself."
)


class LimitsFields(RequestModel, group="limits"):
    """Limits of quantities: lower for the stiffness, upper for all others."""

    peak_force_N: Maybe[Size] = _limit("Limit of the peak force")
    max_pressure_MPa: Maybe[Size] = _limit("Limit of the pressure")
    transmission_error_arcmin: Maybe[Size] = _limit("Limit of the transmission error")
    backlash_max_arcmin: Maybe[Size] = _limit("Limit of the backlash")
    lost_motion_arcmin: Maybe[Size] = _limit("Limit of the lost motion")
    stiffness_min_Nm_per_arcmin: Maybe[Size] = _limit("Limit of the stiffness")
    ring_peak_force_N: Maybe[Size] = _limit("Limit of the force on the ring's pins")
    ring_max_pressure_MPa: Maybe[Size] = _limit("Limit of the pressure on the ring's pins")


OF_RING_PINS = ("ring_peak_force_N", "ring_max_pressure_MPa")
"""Quantities of the pins of a ring in series."""


class ToleranceStudyRequest(SolvedFields, group="study"):
    """Design document with a load, pins in holes and tolerances, and the results that are wanted.
    Deviations of a piece are drawn, and those of the document are not used.
    """

    NEEDS: ClassVar[Needs] = (*LOADED, *TOUCHING, "tolerances")
    USES: ClassVar[frozenset[str]] = FORCES - {"deviations"} | {"tolerances"}

    lost_motion_torque_share: float = lost_motion_torque_share()
    samples: Maybe[Whole] = quantity("Samples", "n", step=100, ge=1, le=MAX_SAMPLES)
    """Number of pieces to draw; samples × pairs × crank angles are bounded. The default is the
    largest number allowed, up to 4096, or up to 1024 with contributions."""
    seed: Whole = quantity("Seed", default=0, step=1, advanced=True, ge=0, le=2**53 - 1)
    """Seed of the random numbers; equal seeds give equal pieces, for any number of samples."""
    if_cluster_lost: Literal["here", "end"] = quantity(
        "If the cluster is lost", default="here", advanced=True
    )
    """Behaviour of a study on a cluster if the service loses the cluster: continue in the service,
    or end."""
    crank_angles: Whole = quantity(
        "Crank angles", default=60, step=12, advanced=True, ge=12, le=1000
    )
    """Number of even positions of the turn at which each piece is solved; with a ring in series
    four times as many, over all turns after which both meshes repeat."""
    quantities: list[Literal[*LimitsFields.model_fields]] = Field(  # type: ignore[valid-type]
        default=["peak_force_N", "backlash_max_arcmin"],
        min_length=1,
        max_length=8,
        description="Quantities of each piece over the turn. The lost motion takes three times as"
        " long. Forces and pressures of ring pins need a ring in series.",
    )
    percentiles: list[Annotated[float, Field(ge=0.01, le=99.99)]] = quantity(
        "Percentiles", default=[50.0, 95.0], max_length=20
    )
    """Percentages of the requested percentiles; a rare one needs many samples: 95 % takes 72, 99 %
    takes 368."""
    limits: LimitsFields = Field(default_factory=LimitsFields)
    include: list[Literal["histogram", "contributions", "worked"]] = Field(
        default=[],
        max_length=3,
        description="Optional results. `contributions` of G tolerances to the first quantity take"
        " 2·G + 2 times as many additional pieces.",
    )

    @cached_property
    def spread(self) -> Tolerances:
        """Tolerances with guide values of processes; a fit gives the classes of both diameters."""
        return self.design.tolerances.filled(self.design.contact.iso_fit).of_parts(self.diameters)

    @cached_property
    def results(self) -> Results:
        """Results of nominal sizes; a fit's classes apply to a hole of pin plus eccentricity."""
        design, contact = self.design, self.design.contact
        if contact.iso_fit:
            pin, eccentricity = design.nominal_pair.pin_radius, design.known_eccentricity
            design = changed(design, {"contact.hole_radius": pin + eccentricity})
        return Results(design, bounded=False)

    def refuse_of_no_ring(self) -> None:
        """Refuse tolerances, limits and quantities of the ring if both meshes are not in series."""
        of_ring = (
            *(f"tolerances/{name}" for name in OF_THE_RING if self.says(f"tolerances/{name}")),
            *(f"limits/{name}" for name in OF_RING_PINS if name in self.limits.given),
            *(f"quantities/{n}" for n, name in enumerate(self.quantities) if name in OF_RING_PINS),
        )
        if not of_ring or self.in_series:
            return
        if self.ring_kind == "cycloid":
            for path in ("gear/modification", "contact/hole_clearance_mm"):
                if not self.says(path):
                    raise refusal(f"/{path}", "needed_beside", field=of_ring[0].partition("/")[0])
        raise refusal(f"/{of_ring[0]}", "of_another_kind", kind="rigid")

    _fitting: int = PrivateAttr(default=MAX_SAMPLES)
    _lost: bool = PrivateAttr(default=False)

    @property
    def drawn(self) -> int:
        """Number of samples: the given one, or as many of the usual number as fit."""
        usual = USUAL_RANKED_SAMPLES if "contributions" in self.include else USUAL_SAMPLES
        return self.samples or min(usual, self._fitting)

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the limits or too slow, and percentiles that need more samples."""
        super().refuse_beyond(settings)
        self.refuse_of_no_ring()
        self.refuse_longer(settings)
        for index, percent in enumerate(self.percentiles):
            try:
                refuse_few(count=self.drawn, percent=percent)
            except InvalidInput as error:
                raise refusal(f"/percentiles/{index}", error.code, **error.params) from error

    def refuse_longer(self, settings: Settings, times: int = 1) -> None:
        """Refuse more samples than the time allows for `times` repetitions of the study."""
        budget = int(POSITIONS_PER_SECOND * settings.max_seconds)
        positions = times * self._positions_of_a_pair
        if self.in_series:
            closer = times * LOOKED_CLOSER * self._solves(self.names)
            self.refuse_many_in_series(int(budget / (positions * FEWEST + closer)))
            most = int((budget / self.pairs_in_series - closer) / positions)
        else:
            most = int(budget / (positions * self.mechanism.pairs))
        if most < FEWEST:
            self.refuse_pairs(int(budget / (positions * FEWEST)))
        self._fitting = min(self._fitting, most)
        if self.drawn > most:
            raise InvalidInput("samples", self.samples, "service_limit", limit=most)

    @property
    def _positions_of_a_pair(self) -> float:
        """Number of solved positions of a pair for each sample, or their equivalent in time."""
        each = self._solves(self.names)
        if "contributions" in self.include:
            each += (2 * len(self.spread.sources) + 2) * self._solves(self.names[:1])
        floats = self.in_series and self.design.support.loose > 0
        return each * (FLOATS_AS_LONG if floats else self.times_as_long)

    def _solves(self, names: list[str]) -> float:
        fit = self.design.ring_pins if self.in_series else 0
        ways = 2 if self.alternating else 1
        return ways * self._times(names) * self.positions + fit

    @property
    def positions(self) -> int:
        """Number of positions at which each piece is solved."""
        return self.crank_angles * (TURNS_IN_SERIES if self.in_series else 1)

    @property
    def diameters(self) -> dict[str, float]:
        """Nominal diameters of pins, holes and ring pins, m, as far as they are given."""
        pair = self.results.design.nominal_pair
        found = {"pin": 2 * pair.pin_radius, "hole": 2 * pair.hole_radius}
        return found | (
            {"ring_pin": 2 * self.design.cycloid.known_pin_radius} if self.in_series else {}
        )

    def _times(self, names: list[str]) -> float:
        if names == ["backlash_max_arcmin"]:
            return BACKLASH_SOLVES
        return LOST_MOTION_SOLVES if "lost_motion_arcmin" in names else 1

    @property
    def names(self) -> list[str]:
        """Quantities that are calculated: requested ones, and those with a limit."""
        return list(dict.fromkeys([*self.quantities, *self.given_limits]))

    @cached_property
    def given_limits(self) -> dict[str, float]:
        """Limits by the name of their quantity."""
        return {**self.limits.given}

    def study(self, report: Report) -> Study:
        """Study in SI units, which reports progress; on the operator's cluster if there is one."""
        given: Values = {
            "tolerances": self.spread,
            "asked": Evaluation(
                quantities=tuple(map(core_name, self.names)),
                output_torque=self.torque,
                alternating=self.alternating,
                positions=self.positions,
                lost_motion_share=self.lost_motion_torque_share,
            ),
            "samples": self.drawn,
            "seed": self.seed,
            "progress": self._counted(report),
        }
        real = self.results.real
        study = Study(real=real, **given)
        if self.in_series:
            study = SeriesStudy(real=MeshesInSeries(self.results.ring.mesh, real), **given)
        address = current().dask
        if not address:
            return study

        def lost(why: Lost) -> Mapped:
            self._lost = True
            if self.if_cluster_lost != "here":
                raise why
            return study.in_threads

        return replace(study, mapped=on_cluster(address, lost))

    def _counted(self, report: Report) -> Callable[[int], None]:
        """Function that takes the number of finished pieces, restarting for each contribution, and
        reports their share of all.
        """
        before = last = 0

        def count(done: int) -> None:
            nonlocal before, last
            before += last if done <= last else 0
            last = done
            report(min((before + done) / self._pieces, 1.0))

        return count

    @property
    def _pieces(self) -> int:
        """Number of pieces that are calculated."""
        if "contributions" not in self.include:
            return self.drawn
        return self.drawn * (2 * len(self.spread.sources) + 3)

    def solve(self, report: Report = untold) -> tuple[Values, Accuracy]:
        """Requested values with their accuracy; progress is reported from 0 to 1."""
        study = self.study(report)
        found = tolerance_study(study)
        quantities = {name: self._quantity(name, found) for name in self.names}
        share = found.fits.mean()
        values: Values = {
            "quantities": quantities,
            "samples": self.drawn,
            "fits": int(found.fits.sum()),
            "binds_in_turning": int(found.binds.sum()),
            "does_not_fit": int((~found.fits & ~found.binds).sum()),
            "cannot_assemble": EstimateOut.values(found.cannot_assemble),
            "cannot_work": int((np.isnan(found.values[:, 0]) & found.fits).sum()),
        }
        values |= self._process()
        if "contributions" in self.include:
            if share < MOST_FIT:
                values["fit_contributions"] = self._contributions(study, to_fit=True)
            else:
                quantities[self.names[0]]["contributions"] = self._contributions(study)
        sampling = max(self._sampling_error(name, quantities, found) for name in self.names)
        grid = max(found.angle_grid_error.values())
        values["accuracy"] = {"sampling_error": sampling, "angle_grid_error": grid}
        if "worked" in self.include:
            means = {name: each.get("mean") for name, each in quantities.items()}
            counts = {name: values[name] for name in ("samples", "fits", "cannot_work")}
            values["worked"] = stated("tolerance_study", means | counts, "simulated")
        notices = self._few(found)
        if self._lost:
            notices += (Notice("cluster_lost"),)
        if notices:
            values["warnings"] = [*map(warning, notices)]
        return values, Accuracy("monte_carlo", sampling + grid, self._pieces * self.positions)

    @property
    def guided(self) -> Values:
        """Values that processes fill in, by names of tolerances."""
        guides = self.design.tolerances.guides(self.design.contact.iso_fit)
        return dict(map(as_given, guides, guides.values()))

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with those that processes fill in."""
        yield from super().assumed()
        yield from ((("tolerances", name), value) for name, value in self.guided.items())

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also that tolerances are guide values."""
        guides = (Notice("guide_tolerances"),) if self.guided else ()
        return (*super().notices(), *guides)

    def _process(self) -> Values:
        """Processes of the parts and the values taken from them, if stated."""
        made = self.design.tolerances.processes
        known = [made[part] for part in ("hole", "pin") if part in made]
        if not known:
            return {}
        first, last = known[0], known[-1]
        other = {"pin_code": last.code, "pin_source": last.source} if last != first else {}
        more = self.spread.mean_clearance
        said = {
            "code": first.code,
            "source": first.source,
            **other,
            "filled": [f"/tolerances/{name}" for name in self.guided],
            "mean_clearance_mm": from_si("clearance_mm", self.results.design.play + more),
        }
        return {"process": said}

    def _few(self, found: ToleranceStudy) -> tuple[Notice, ...]:
        """Percentiles that are left out, as too few pieces fit."""
        fits, asked = int(found.fits.sum()), len(self.percentiles)
        if fits == 0:
            return (Notice("no_piece_fits"),)
        given = min(len(self.kept(name, found)) for name in self.names)
        return (Notice("too_few_fit", {"fits": fits}),) if given < asked else ()

    def seen(self, name: str, value: Any) -> Any:
        """Quantity of the output in its unit, from that of the satellites against the pins."""
        return from_si(name, value * factor_at_output(name, self.members))

    def estimate(self, estimate: Estimate, name: str) -> Values:
        """Number of the sample, as the output has it, with its interval."""
        return {end: self.seen(name, getattr(estimate, end)) for end in ("value", "low", "high")}

    def kept(self, name: str, found: ToleranceStudy) -> list[Values]:
        """Percentiles that the fitting pieces support."""
        given = []
        for percent in self.percentiles:
            with suppress(InvalidInput):
                each = found.percentile(quantity=core_name(name), percent=percent)
                given.append({"percent": percent} | self.estimate(each, name))
        return given

    def _quantity(self, name: str, found: ToleranceStudy) -> Values:
        quantity = core_name(name)
        column, factor = found.column(quantity), factor_at_output(name, self.members)
        values: Values = {
            "percentiles": self.kept(name, found),
            "angle_grid_error": found.angle_grid_error[quantity],
        }
        if quantity in found.nominal:
            values["nominal"] = self.seen(name, found.nominal[quantity])
        if len(column):
            values["mean"] = self.seen(name, float(column.mean()))
        if name in self.given_limits:
            limit = self.given_limits[name]
            asked: dict[str, Any] = {"quantity": quantity, "limit": to_si(name, limit) / factor}
            values["yield"] = {"limit": limit} | EstimateOut.values(found.yield_within(**asked))
            if found.fits.any():
                of_fitting = found.yield_within(**asked, of_fitting=True)
                values["yield_of_fitting"] = {"limit": limit} | EstimateOut.values(of_fitting)
        if "histogram" in self.include and len(column):
            values["histogram"] = _histogram(self.seen(name, column))
        return values

    def _contributions(self, study: Study, to_fit: bool = False) -> list[Values]:
        first = replace(study, asked=replace(study.asked, quantities=study.asked.quantities[:1]))
        percent = max(self.percentiles, default=50.0)
        given = {core_name(name): name for name in TolerancesFields.model_fields}
        for part in ("pin", "hole", "ring_pin"):
            given[f"{part}_radius"] = f"{part}_diameter"

        def without(each: Estimate) -> Values:
            if to_fit:
                return {"fits_without": EstimateOut.values(each)}
            return {"percentile_without": {"percent": percent} | self.estimate(each, self.names[0])}

        return [
            ContributionOut.values(each, source=given[each.source], **without(each.without))
            for each in contributions(study=first, percent=percent, to_fit=to_fit)
        ]

    def _sampling_error(
        self, name: str, quantities: dict[str, Values], found: ToleranceStudy
    ) -> float:
        """Largest relative half width of a quantity's percentiles, or of its mean without them."""
        column = found.column(core_name(name))
        if percentiles := quantities[name]["percentiles"]:
            return max(_relative(each["high"] - each["low"], each["value"]) for each in percentiles)
        if len(column) < 2:
            return 1.0
        width = 2 * 1.96 * float(column.std(ddof=1)) / math.sqrt(len(column))
        return _relative(width, float(column.mean()))


def _relative(width: float, value: float) -> float:
    """Half an interval's width over its value, at most 1, which holds for a value of 0 too."""
    if width == 0:
        return 0.0
    return min(width / 2 / abs(value), 1.0) if value else 1.0


def _histogram(values: FloatArray) -> Values:
    """Histogram with classes by Rice's rule."""
    counts, edges = np.histogram(values, bins=max(1, math.ceil(2 * len(values) ** (1 / 3))))
    return {"edges": edges, "counts": counts}


def reporting(body: ToleranceStudyRequest, report: Report) -> Values:
    """Values of the study; its progress is reported."""
    try:
        (values, accuracy), run_time_us = timed(lambda: body.solve(report))
    except Lost as error:
        raise unavailable("The cluster of this study is lost") from error
    values["accuracy"] |= accuracy_values(accuracy, run_time_us)
    return values


def solve(body: ToleranceStudyRequest) -> Values:
    """Effect of tolerances on peak force, backlash, lost motion and others: percentiles and yield
    of sampled pieces with their intervals, and the tolerance with the largest effect.

    The header `Accept: application/x-ndjson` asks for an answer in lines, at most four a second:
    `{"progress": 0.25}`, from 0 to 1, and at last `{"result": ...}` or `{"problem": ...}`. Closing
    the connection ends the study.
    """
    return reporting(body, untold)


def figure(body: ToleranceStudyRequest, theme: Theme = "light") -> Figure:
    """Histogram of the first quantity with its percentiles; with `contributions`, their ranking."""
    if "contributions" not in body.include:
        body = body.model_copy(update={"include": ["histogram"]})
    values, _ = body.solve()
    name = body.names[0]
    shown = values["quantities"][name]
    if "fit_contributions" in values:
        shown = shown | {"contributions": values["fit_contributions"]}
    return tolerance_figure(name, shown, theme)


CALCULATION = StudyCalculation(
    name="tolerance-study",
    title="Tolerances and their effect",
    tag="crank-planetary",
    request=ToleranceStudyRequest,
    answer=ToleranceStudyResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, ISO_286, JANSEN_1999),
    neglects=LEFT_OUT,
    batched=False,
    reporting=reporting,
)
