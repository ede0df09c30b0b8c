"""Geometric fit of pins in holes, and freedom to turn: request, answer, figure."""

from functools import cached_property
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.document import TOUCHING, DocumentFields, Needs
from app.calculations.fit_answer import (
    DiscOut,
    ElasticOut,
    FitPositionOut,
    FitResponse,
    WholeFitOut,
)
from app.calculations.members_answer import at_output
from app.model import (
    Angle,
    Calculation,
    Values,
    accuracy_values,
    quantity,
    timed,
    warning,
)
from app.settings import Settings
from app.sources import JOHNSON_1985
from app.theme import Chart, Figure, Theme, text
from app.units import from_si, to_si
from app.worked import stated
from core.design.document import Design
from core.design.results import Results
from core.errors import Accuracy, InvalidInput, Notice
from core.output.mechanism import slip_notices
from core.output.room import POSITIONS, Rooms
from core.precision import ROUNDING

Section = Literal["positions", "elastic", "discs", "worked"]

MAX_FIT_PAIRS = 240
"""Largest number of pairs whose room and play are searched over the turn."""

MAX_POSITIONS = 1000
"""Largest number of crank angles in a request."""

MAX_ARCS = 100_000
"""Largest number of lags of pairs: crank angles times pairs."""


DRAWN_ANGLES = 721
"""Number of crank angles of the figure's curves, besides the ends of jammed stretches."""

LEFT_OUT = ("bodies_rigid", "friction", "heat", "pin_bending", "shaft_bearings", "tilt")
"""Effects that the model leaves out."""


class FitRequest(DocumentFields, group="positions"):
    """Design document with pins in holes, and the results that are wanted; no load is needed."""

    NEEDS: ClassVar[Needs] = ("mechanism/pins", "load/pin_circle_radius_mm", *TOUCHING)
    USES: ClassVar[frozenset[str]] = frozenset(
        ("mechanism", "load", "contact", "contact_law", "deviations", "crank_support")
    )

    crank_angle_deg: list[Angle] = quantity(
        "Crank angles", "φ", default=[0.0], min_length=1, max_length=MAX_POSITIONS
    )
    """Crank angles of the section `positions`."""
    include: list[Section] = Field(
        default=[],
        max_length=4,
        description="Results besides the fit: room and lags of each pin at the crank angles, the "
        "part of a misfit that elasticity takes up, the fit of each satellite by "
        "itself, and worked steps.",
    )

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits or too slow, and lists of other lengths."""
        super().refuse_beyond(settings)
        limit = MAX_FIT_PAIRS
        if "positions" in self.include:
            limit = min(limit, MAX_ARCS // len(self.crank_angle_deg))
        if self.mechanism.pairs > limit:
            most = self.mechanism.most_pins(limit)
            raise InvalidInput("pins", self.mechanism.pins, "too_many_pairs", **most)

    @cached_property
    def results(self) -> Results:
        """Results of the design, for any number of pairs within the limit here."""
        return Results(self.design, bounded=False)

    def solve_all(self) -> tuple[Values, Accuracy, tuple[Notice, ...]]:
        """Requested values, with their accuracy and notices."""
        fit, members = self.results.fit, self.members
        rooms = fit.rooms
        values: Values = {"fit": at_output(WholeFitOut.values(rooms), members)}
        bound = rooms.state != "no_bound"
        if bound and fit.misfit:
            values["fit"]["misfit"] = fit.misfit
        asked = {*self.include} if bound else {}
        if "discs" in asked:
            values["fit"]["discs"] = [*map(DiscOut.values, rooms.discs())]
        if "elastic" in asked and (elastic := ElasticOut.values(fit.elastic)):
            values["fit"]["elastic"] = elastic
        if "positions" in asked:
            angles = np.array(to_si("crank_angle_deg", self.crank_angle_deg))
            values["positions"] = FitPositionOut.all_values(rooms, members, angles)
        return values, room_accuracy(rooms), fit_notices(self.design, rooms)


def fit_notices(design: Design, rooms: Rooms) -> tuple[Notice, ...]:
    """Notices of sizes that look mistyped, and of satellites assembled by other holes."""
    pair = design.nominal_pair
    slips = slip_notices(
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=design.contact.eccentricity,
    )
    return (*slips, *((Notice("next_hole"),) if any(rooms.numbered[1]) else ()))


def room_accuracy(rooms: Rooms) -> Accuracy:
    """Accuracy of the least room: relative to the room, at most 1."""
    if rooms.state == "no_bound":
        return Accuracy("closed_form", ROUNDING, 1)
    if rooms.even:
        return Accuracy("closed_form", 4 * ROUNDING, 1)
    error, least = rooms.room.error, abs(rooms.room.least)
    return Accuracy("arcs_zoomed", error / least if error < least else 1.0, POSITIONS)


def solve(body: FitRequest) -> Values:
    """Fit of pins in holes by geometry: freedom to turn, and the room that is left."""
    (values, accuracy, notices), run_time_us = timed(body.solve_all)
    values["accuracy"] = accuracy_values(accuracy, run_time_us)
    if notices:
        values["warnings"] = [*map(warning, notices)]
    if "worked" in body.include:
        values["worked"] = stated("fit", values["fit"], "of_distances")
    return values


def figure(body: FitRequest, theme: Theme = "light") -> Figure:
    """Room over the crank angle, its least place, and jammed stretches, for Plotly.js."""
    body.mechanism.refuse_undrawable()
    rooms = body.results.rooms
    rooms.refuse_without_bound()
    mechanism, room, blocked = rooms.mechanism, rooms.room, rooms.blocked_crank or ()
    end = mechanism.crank_angle_per_wave
    edges = np.array([each % end for ends in blocked for each in ends])
    least = [*room.where.values()]
    angle = np.unique(np.concatenate((np.linspace(0.0, end, DRAWN_ANGLES), edges, least)))
    wave, x = mechanism.wave_angle(angle), from_si("angle_deg", angle)
    chart = Chart(theme, height=420)
    chart.axis("x", "crank_angle", "°", range=[0, from_si("angle_deg", end)])
    chart.axis("y", "room", "mm", rangemode="tozero")
    chart.curve("room", x, from_si("room_mm", rooms.rooms(wave)[0]))
    for disc in range(mechanism.satellites) if mechanism.satellites > 1 else ():
        y = from_si("room_mm", rooms.rooms(wave, disc)[0])
        chart.curve(text("satellite", satellite=disc + 1), x, y, disc + 1, line={"width": 1})
    for place in least:
        chart.mark("least_room", from_si("angle_deg", place), from_si("room_mm", room.least))
    if room.state == "does_not_fit":
        blocked = ((0.0, end),)
    for start, stop in blocked:
        for ends in [(start, stop)] if stop <= end else [(start, end), (0.0, stop - end)]:
            chart.shaded(*from_si("angle_deg", list(ends)), opacity=0.15)
    return chart.figure


CALCULATION = Calculation(
    name="fit",
    title="Room of the pins in their holes",
    tag="crank-planetary",
    request=FitRequest,
    answer=FitResponse,
    solve=solve,
    figure=figure,
    sources=(JOHNSON_1985,),
    neglects=LEFT_OUT,
)
