"""Load and life of the satellites' bearings: request, answer, figure."""

from contextlib import suppress
from typing import Any, ClassVar

import numpy as np

from app.calculations.document import (
    FORCES,
    PIN_SECTIONS,
    TOUCHING,
    TURNING,
    ForcesUsed,
    Needs,
    StrengthFields,
    forces_used,
)
from app.model import (
    Calculation,
    DocumentResponse,
    ResponseModel,
    Values,
    WorkedFields,
    timed,
)
from app.sources import ISO_281, YANCHEVSKIY_2021
from app.theme import Amount, Chart, Figure, Theme, text
from app.units import core_name, from_si
from app.worked import Steps
from core.crank.satellite_bearing import SatelliteBearings
from core.design.curves import design_bearings
from core.errors import NotKnown
from core.worked.crank import bearing_steps


class SatelliteBearingRequest(StrengthFields, WorkedFields):
    """Design document with a load, crank, ring and satellite bearing; pins and holes if the forces
    follow from them too.
    """

    NEEDS: ClassVar[Needs] = (*TURNING, "gear", "bearing")
    NEEDED_OF: ClassVar[dict[str, Needs]] = dict.fromkeys(PIN_SECTIONS, TOUCHING)
    USES: ClassVar[frozenset[str]] = FORCES | {"bearing", "crankshaft", "requirements"}

    def solve(self) -> SatelliteBearings:
        """Loads and lives."""
        return self.with_fit(self.results.crank.bearings)

    def steps(self) -> Steps:
        """Worked steps of the bearing with the largest load."""
        return {"satellite_bearing": bearing_steps(self.results)}


OF_EACH = (
    *("peak_load", "min_load", "equivalent_load", "peak_ring_force"),
    *("basic_life", "life", "static_safety_factor"),
)
"""Quantities of each bearing."""


class SatelliteBearingOut(ResponseModel, of=SatelliteBearings, only=OF_EACH):
    """The bearing of one satellite."""


class SatelliteBearingResponse(DocumentResponse, of=SatelliteBearings, without=OF_EACH):
    """Loads and lives of the satellites' bearings."""

    forces: ForcesUsed = forces_used()
    satellites: list[SatelliteBearingOut]

    @classmethod
    def values(
        cls, result: SatelliteBearings, run_time_us: float | None = None, **given: Any
    ) -> Values:
        """Values of the core's arrays, a row for each satellite."""
        carries = result.peak_load > 0
        columns = {}
        for name in SatelliteBearingOut.model_fields:
            with suppress(NotKnown):
                known = np.where(carries, getattr(result, core_name(name)), 0.0)
                columns[name] = from_si(name, known).tolist()
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        for row, loaded in zip(rows, carries.tolist(), strict=True):
            if not loaded:
                for name in ENDLESS:
                    row.pop(name, None)
        return super().values(result, run_time_us, satellites=rows, **given)


ENDLESS = ("basic_life_h", "life_h", "static_safety_factor")
"""Values that the bearing of an unloaded satellite does not have."""


def solve(body: SatelliteBearingRequest) -> Values:
    """Load of the satellites' bearings by pins and ring, static safety and life."""
    return SatelliteBearingResponse.values(*timed(body.solve), forces=body.forces)


def figure(body: SatelliteBearingRequest, theme: Theme = "light") -> Figure:
    """Load in the crank's frame and over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    turn, switching = body.drawn_angles()
    curves = design_bearings(results=body.results, crank_angle=turn)
    largest = float(np.max(body.solve().equivalent_load))
    angles = from_si("angle_deg", turn)
    ends = [0.0, float(angles[-1])]
    chart = Chart(theme, height=420)
    chart.locus_and_turn("across_crank", "along_crank", "N", "bearing_load", "N")
    chart.layout["xaxis2"]["range"] = ends
    columns = zip(curves.across.T, curves.along.T, curves.load.T, strict=True)
    for index, (across, along, load) in enumerate(columns):
        name = text("satellite", satellite=index + 1)
        own: Figure = {"legendgroup": str(index)}
        chart.locus(name, across, along, index, **own)
        chart.curve(name, angles, load, index, axis="y2", showlegend=False, **own)
    equivalent = text("equivalent_load")
    hovered = text("mean_hover", name=equivalent, value=Amount("%{y:.5g}", "N"))
    chart.curve(equivalent, ends, [largest] * 2, len(curves.load.T), hovered, axis="y2")
    places = from_si("switching_deg", switching).round(4).tolist()
    chart.verticals(places, xref="x2", yref="y2 domain")
    return chart.figure


CALCULATION = Calculation(
    name="satellite-bearing",
    title="Bearings of the satellites",
    tag="crank-planetary",
    request=SatelliteBearingRequest,
    answer=SatelliteBearingResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, ISO_281),
    neglects=("friction", "bearing_elasticity", "centrifugal_forces"),
)
