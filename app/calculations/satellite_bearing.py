"""Load and life of the satellites' bearings: request, answer, figure."""

from collections.abc import Iterator
from contextlib import suppress
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from app.calculations.design import (
    DesignFields,
    DrivenLoadFields,
    ForcesUsed,
    forces_used,
)
from app.calculations.mechanism import MAX_SATELLITES, TOUCHING, CrankContactFields
from app.calculations.named_bearing import NamedBearingFields, bearing_name
from app.calculations.ring import RingFields
from app.model import (
    AccuracyOut,
    Angle,
    AssumingResponse,
    Calculation,
    Maybe,
    PartFields,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    WarningOut,
    WorkedFields,
    quantity,
    result,
    timed,
)
from app.rules import Rule, field_error
from app.sources import ISO_281, YANCHEVSKIY_2021
from app.theme import Amount, Figure, Theme, axis, curve, layout, text, vertical_line
from app.units import from_si
from app.worked import worked
from core.arrays import FloatArray
from core.crank.balance import Counterweight
from core.crank.satellite_bearing import BearingCurves, SatelliteBearings
from core.design.curves import design_bearings
from core.design.sections import RollingBearing, Seat, Shaft
from core.errors import NotKnown
from core.worked.crank import bearing_steps
from core.worked.step import Step

OF_PINS = ("contact_law", "deviations", "pin", "crank_support", "satellite_coupling")
"""Sections that concern pins and holes."""


class ShaftBearingFields(NamedBearingFields, group="bearing"):
    """A bearing of the crankshaft."""

    name: Maybe[str] = bearing_name()
    kind: Maybe[Literal["ball", "roller"]] = quantity("Rolling elements")
    """Kind of rolling elements, which states the exponent of the load in the life: 3 for balls,
    10/3 for rollers."""
    dynamic_rating_N: Maybe[Size] = quantity("Dynamic load rating", "C", step=100)
    """Basic dynamic load rating; without it the life is not calculated."""
    bore_diameter_mm: Maybe[Size] = quantity("Bore", "d", step=1)
    """Bore diameter of the bearing; bore, outer diameter and width together show if such a bearing
    exists."""
    outer_diameter_mm: Maybe[Size] = quantity("Outer diameter", "D", step=1)
    """Outer diameter of the bearing, larger than its bore."""
    width_mm: Maybe[Size] = quantity("Width", "B", step=1)
    """Width of the bearing."""
    limiting_speed_rpm: Maybe[Size] = quantity("Limiting speed", "n_lim", step=500)
    """Limiting speed in the catalogue for the lubrication used; without it the speed is not
    judged."""


class BearingFields(ShaftBearingFields, group="bearing"):
    """A rolling bearing as its catalogue gives it."""

    static_rating_N: Maybe[Size] = quantity("Static load rating", "C₀", step=100)
    """Basic static load rating, for the static safety."""
    reliability_percent: float = quantity("Reliability", default=90.0, ge=90, le=99)
    """Share of bearings that reach the life: 90, 95, 96, 97, 98 or 99 %."""
    ring_factor: float = quantity("Factor of the rings", "V", default=1.0, step=0.1, ge=0.1, le=10)
    """Rotation factor V of the equivalent load; 1.2 is usual if the outer ring turns relative to
    the load."""
    weibull_slope: Maybe[float] = quantity("Weibull slope", "β", step=0.1, ge=0.1, le=10)
    """Slope of the Weibull distribution of lives, for the common life of all satellites' bearings,
    without those of the crankshaft."""

    def section(self, _: Any) -> RollingBearing:
        """The bearing in SI units."""
        return RollingBearing(**self.to_core())


Place = Annotated[float, Field(ge=-1e12, le=1e12)]

Unbalance = Annotated[float, Field(ge=0, le=1e12)]


MAX_WEIGHTS = 20
"""Largest number of counterweights."""


class CounterweightFields(PartFields, group="crankshaft"):
    """Mass on the shaft off its axis."""

    unbalance_kg_mm: Unbalance = quantity("Unbalance", "U", step=0.1)
    """Mass of the counterweight times the distance of its centre of mass from the axis."""
    position_mm: Place = quantity("Place", "z", step=1)
    """Position of the counterweight's middle along the shaft, from the same point as those of the
    satellites."""
    angle_deg: Angle = quantity("Direction", "β", default=180.0, step=15)
    """Direction of the counterweight, measured like the crank angles; 180° is opposite to a crank
    at 0°."""

    def section(self) -> Counterweight:
        """Counterweight in SI units."""
        return Counterweight(**self.to_core())


class SeatedBearingFields(ShaftBearingFields, PartFields, group="crankshaft"):
    """Bearing of the crankshaft, and the part that holds it."""

    seat: Seat = quantity("Sits in", alias="in", default="housing")
    """Part in which the bearing sits: the housing, or the part of the pins or of the ring if it
    turns. The life uses the speed of the crankshaft relative to that part."""

    def section(self) -> RollingBearing:
        """The bearing in SI units."""
        return RollingBearing(**self.to_core())


class CrankshaftFields(RequestModel, group="crankshaft"):
    """Crankshaft with the places of its loads and bearings."""

    satellite_positions_mm: list[Place] = quantity(
        "Places of the satellites", "z₁ … z_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Middle plane of each satellite along the shaft."""
    bearing_positions_mm: list[Place] = quantity(
        "Places of the bearings", "A, B", min_length=2, max_length=2
    )
    """Position of both bearings along the shaft, ascending; satellites may lie beyond them."""
    satellite_mass_kg: Maybe[Size] = quantity("Mass of a satellite", "m", step=0.1)
    """Mass of one satellite with its bearing; without it the balance is not calculated, and
    bearings carry no centrifugal forces."""
    counterweights: Maybe[list[CounterweightFields]] = quantity(
        "Counterweights", max_length=MAX_WEIGHTS
    )
    """Counterweights on the shaft; the mass of a satellite has to be given as well."""
    rotor_mass_kg: Maybe[Size] = quantity("Mass of what turns", "M", step=0.1)
    """Mass of all parts that turn with the crankshaft, for the balance grade; the mass of the
    satellites if not given."""
    eccentric_diameter_mm: Maybe[Size] = quantity("Diameter of the eccentrics", "d_e", step=1)
    """Diameter of the eccentric inside the satellite's bearing."""
    shaft_diameter_mm: Maybe[Size] = quantity("Diameter of the shaft", "d_s", step=1)
    """Diameter of the shaft between the eccentrics and in its bearings."""
    bearings: Maybe[list[SeatedBearingFields]] = Field(
        min_length=2,
        max_length=2,
        description="Both bearings of the crankshaft; ball bearings in the housing if not given.",
    )

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with those of named bearings."""
        yield from super().assumed()
        for index, each in enumerate(self.bearings or ()):
            yield from ((("bearings", str(index), *path), value) for path, value in each.assumed())

    @model_validator(mode="after")
    def _weights_of_masses(self) -> Self:
        if self.counterweights and self.satellite_mass_kg is None:
            raise field_error("satellite_mass_kg", "needed_beside", field="counterweights")
        return self

    def section(self, _: Any) -> Shaft:
        """The shaft in SI units."""
        return Shaft(**self.to_core())


class CrankedRequest(DesignFields, WorkedFields):
    """Mechanism, load, crank and ring; pins and holes if the forces follow from them too."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = tuple(
        Rule(f"contact/{name}", "needed_beside", section)
        for section in OF_PINS
        for name in TOUCHING
    )

    load: DrivenLoadFields
    contact: CrankContactFields
    gear: RingFields


class SatelliteBearingRequest(CrankedRequest):
    """Mechanism, load, crank, ring and bearing."""

    bearing: BearingFields
    crankshaft: Maybe[CrankshaftFields] = None

    def solve(self) -> SatelliteBearings:
        """Loads and lives."""
        return self.with_fit(self.results.crank.bearings)

    def steps(self) -> list[Step]:
        """Worked steps of the bearing with the largest load."""
        return bearing_steps(self.results)

    def solve_for_drawing(self) -> tuple[SatelliteBearings, BearingCurves, FloatArray]:
        """Loads and lives, curves over the turn, and the switching angles, rad."""
        angles, switching = self.drawn_angles()
        curves = design_bearings(results=self.results, crank_angle=angles)
        return self.solve(), curves, switching


class SatelliteBearingOut(ResponseModel):
    """The bearing of one satellite."""

    peak_load_N: float = result("Largest load over the turn.", symbol="Q_max")
    min_load_N: float = result("Least load over the turn.", symbol="Q_min")
    equivalent_load_N: float = result("Equivalent load, V·⟨Qᵖ⟩^(1/p).", symbol="P")
    peak_ring_force_N: float = result(
        "Largest resultant of the ring's forces on the satellite, W·√(1 + ρ²).", symbol="F_r"
    )
    basic_life_h: Maybe[float] = result(
        "Life that 90 % of such bearings reach, (C/P)ᵖ million turns.", symbol="L_10h"
    )
    life_h: Maybe[float] = result("Life at the requested reliability.", symbol="L_nh")
    static_safety_factor: Maybe[float] = result(
        "Static load rating over the largest load at the peak torque.", symbol="S₀"
    )


class SatelliteBearingResponse(AssumingResponse):
    """Loads and lives of the satellites' bearings."""

    forces: ForcesUsed = forces_used()
    relative_speed_rpm: float = result(
        "Speed of a bearing's inner ring relative to its outer ring, n₁·(1 + 1/u).", symbol="n"
    )
    radial_force_ratio: float = result(
        "Force of the ring along the crank over that across it; positive towards the axis.",
        symbol="ρ",
    )
    operating_pressure_angle_deg: Maybe[float] = result(
        "Operating pressure angle of involute teeth.", symbol="α_w"
    )
    satellites: list[SatelliteBearingOut]
    system_life_h: Maybe[float] = result(
        "Life that such reducers reach at the requested reliability without a failure of any "
        "satellite bearing, if the Weibull slope is given.",
        symbol="L_s",
    )
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

    @classmethod
    def values(
        cls, result: SatelliteBearings, run_time_us: float | None = None, **given: Any
    ) -> Values:
        """Values of the core's arrays, a row for each satellite."""
        carries = result.peak_load > 0
        columns = {}
        for name, field in COLUMNS.items():
            with suppress(NotKnown):
                known = np.where(carries, getattr(result, field), 0.0)
                columns[name] = from_si(name, known).tolist()
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        for row, loaded in zip(rows, carries.tolist(), strict=True):
            if not loaded:
                for name in ENDLESS:
                    row.pop(name, None)
        return super().values(result, run_time_us, satellites=rows, **given)


COLUMNS = {
    "peak_load_N": "peak_load",
    "min_load_N": "min_load",
    "equivalent_load_N": "equivalent_load",
    "peak_ring_force_N": "peak_ring_force",
    "basic_life_h": "basic_life",
    "life_h": "life",
    "static_safety_factor": "static_safety_factor",
}
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


def work(body: SatelliteBearingRequest) -> list[Values]:
    """Worked steps of the bearing with the largest load."""
    return worked(satellite_bearing=body.steps())


CALCULATION = Calculation(
    name="satellite-bearing",
    title="Bearings of the satellites",
    tag="crank-planetary",
    request=SatelliteBearingRequest,
    answer=SatelliteBearingResponse,
    solve=solve,
    worked=work,
    figure=figure,
    sources=(YANCHEVSKIY_2021, ISO_281),
    neglects=("friction", "bearing_elasticity", "centrifugal_forces"),
)
