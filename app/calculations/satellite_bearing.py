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
from app.theme import Amount, Figure, Theme, axis, curve, layout, text, vertical_line
from app.units import core_name, from_si
from app.worked import Steps
from core.arrays import FloatArray
from core.crank.satellite_bearing import BearingCurves, SatelliteBearings
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

    def solve_for_drawing(self) -> tuple[SatelliteBearings, BearingCurves, FloatArray]:
        """Loads and lives, curves over the turn, and the switching angles, rad."""
        angles, switching = self.drawn_angles()
        curves = design_bearings(results=self.results, crank_angle=angles)
        return self.solve(), curves, switching


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


def load_figure(
    found: SatelliteBearings, curves: BearingCurves, switching_deg: FloatArray, theme: Theme
) -> Figure:
    """Load in the crank's frame at the left, over the turn at the right, with its equivalent;
    switching angles, degrees, are thin lines.
    """
    angles = from_si("crank_angle_deg", curves.crank_angle)
    force = Amount("%{y:.5g}", "N")
    data = []
    for index in range(curves.load.shape[1]):
        name = text("satellite", satellite=index + 1)
        hovered = text("locus_hover", name=name, along=Amount("%{x:.5g}", "N"), across=force)
        across, along, load = (
            each[:, index] for each in (curves.across, curves.along, curves.load)
        )
        data.append(curve(name, across, along, index, theme, hovered, legendgroup=str(index)))
        hovered = text("at_angle", name=name, value=force, angle=Amount("%{x:.2f}", "°"))
        more: dict[str, Any] = {
            "xaxis": "x2",
            "yaxis": "y2",
            "legendgroup": str(index),
            "showlegend": False,
        }
        data.append(curve(name, angles, load, index, theme, hovered, **more))
    equivalent = text("equivalent_load")
    hovered = text("mean_hover", name=equivalent, value=force)
    largest = float(np.max(found.equivalent_load))
    ends = [0.0, float(angles[-1])]
    more = {"xaxis": "x2", "yaxis": "y2"}
    data.append(
        curve(equivalent, ends, [largest] * 2, curves.load.shape[1], theme, hovered, **more)
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=420,
            xaxis=axis(theme, text("across_crank"), "N", domain=[0, 0.42]),
            yaxis=axis(theme, text("along_crank"), "N", scaleanchor="x"),
            xaxis2=axis(theme, text("crank_angle"), "°", domain=[0.58, 1], anchor="y2", range=ends),
            yaxis2=axis(theme, text("bearing_load"), "N", anchor="x2"),
            shapes=[
                vertical_line(theme, place, xref="x2", yref="y2 domain")
                for place in switching_deg.round(4).tolist()
            ],
        ),
    }


def solve(body: SatelliteBearingRequest) -> Values:
    """Load of the satellites' bearings by pins and ring, static safety and life."""
    return SatelliteBearingResponse.values(*timed(body.solve), forces=body.forces)


def figure(body: SatelliteBearingRequest, theme: Theme = "light") -> Figure:
    """Load in the crank's frame and over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    found, curves, switching = body.solve_for_drawing()
    return load_figure(found, curves, from_si("switching_deg", switching), theme)


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
