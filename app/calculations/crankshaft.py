"""Reactions and balance of the crankshaft: request, answer, figure."""

import math
from collections.abc import Iterator
from typing import Annotated, Any, Self

import numpy as np
from pydantic import Field, model_validator

from app.calculations.design import ForcesUsed, forces_used
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.satellite_bearing import CrankedRequest, ShaftBearingFields
from app.model import (
    AccuracyOut,
    Angle,
    AssumingResponse,
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    WarningOut,
    field_error,
    quantity,
    result,
)
from app.running import run
from app.sources import ISO_281, YANCHEVSKIY_2021
from app.theme import Amount, Figure, Theme, axis, curve, layout, text
from app.units import from_si
from app.worked import worked
from core.crank.balance import Counterweight
from core.crank.crankshaft import Crankshaft, ReactionCurves
from core.design.curves import design_reactions
from core.design.sections import RollingBearing, Seat, Shaft
from core.worked.crank import shaft_steps
from core.worked.step import Step

Place = Annotated[float, Field(ge=-1e12, le=1e12)]

Unbalance = Annotated[float, Field(ge=0, le=1e12)]


MAX_WEIGHTS = 20
"""Counterweights at most."""


class CounterweightFields(RequestModel, group="crankshaft"):
    """A mass on the shaft that is off its axis."""

    unbalance_kg_mm: Unbalance = quantity("Unbalance", "U", step=0.1)
    """Mass times the distance of its centre from the axis."""
    position_mm: Place = quantity("Place", "z", step=1)
    """Of its middle along the shaft, counted as the satellites' are."""
    angle_deg: Angle = quantity("Direction", "β", default=180.0, step=15)
    """Counted as the crank angles are; 180° is opposite to a crank at 0°."""


class SeatedBearingFields(ShaftBearingFields, group="crankshaft"):
    """A bearing of the crankshaft, and what it sits in."""

    seat: Seat = quantity("Sits in", alias="in", default="housing")
    """The housing, or the part of the pins or of the ring where that turns: the life is that of the
    speed against it."""

    def section(self) -> RollingBearing:
        """The bearing in SI units."""
        return RollingBearing(**self.to_core())


class CrankshaftFields(RequestModel, group="crankshaft"):
    """The shaft: where its loads and bearings are."""

    satellite_positions_mm: list[Place] = quantity(
        "Places of the satellites", "z₁ … z_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Middle plane of each satellite along the shaft."""
    bearing_positions_mm: list[Place] = quantity(
        "Places of the bearings", "A, B", min_length=2, max_length=2
    )
    """Of both bearings along the shaft, ascending; satellites may lie beyond."""
    satellite_mass_kg: Maybe[Size] = quantity("Mass of a satellite", "m", step=0.1)
    """With its bearing; without it no balance is answered, and no bearing feels it."""
    counterweights: Maybe[list[CounterweightFields]] = quantity(
        "Counterweights", max_length=MAX_WEIGHTS
    )
    """Masses on the shaft besides the satellites, whose mass has to be given then."""
    rotor_mass_kg: Maybe[Size] = quantity("Mass of what turns", "M", step=0.1)
    """Of all that turns with the crankshaft, for the grade of its balance; where it is not given,
    that of the satellites."""
    eccentric_diameter_mm: Maybe[Size] = quantity("Diameter of the eccentrics", "d_e", step=1)
    """Of a crank inside the bearing of its satellite."""
    shaft_diameter_mm: Maybe[Size] = quantity("Diameter of the shaft", "d_s", step=1)
    """Of the shaft between the cranks and in its bearings."""
    bearings: Maybe[list[SeatedBearingFields]] = Field(
        min_length=2,
        max_length=2,
        description="Both bearings; ball bearings in the housing where not given.",
    )

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Also what names of bearings say."""
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
        own = self.to_core()
        for name in ("satellite_positions", "bearing_positions"):
            own[name] = tuple(own[name])
        own["counterweights"] = tuple(
            Counterweight(**each.to_core()) for each in self.counterweights or ()
        )
        if self.bearings is not None:
            own["bearings"] = tuple(each.section() for each in self.bearings)
        return Shaft(**own)


class CrankshaftRequest(CrankedRequest):
    """Mechanism, load, crank, ring and shaft."""

    crankshaft: CrankshaftFields

    def cost(self) -> float:
        """No end: the loads of its bearings are searched over the turn."""
        return math.inf

    def solve(self) -> Crankshaft:
        """Reactions and balance."""
        return self.with_fit(self.results.crankshaft)

    def steps(self) -> list[Step]:
        """Worked steps of reactions, lives and balance."""
        return shaft_steps(self.results)

    def solve_for_drawing(self) -> tuple[Crankshaft, ReactionCurves]:
        """The same, and curves over the turn."""
        angles, _ = self.drawn_angles()
        return self.solve(), design_reactions(results=self.results, crank_angle=angles)


class ShaftBearingOut(ResponseModel):
    """A bearing of the shaft."""

    peak_N: float = result(
        "Largest reaction over the turn, with that to the centrifugal forces where the balance is "
        "known.",
        symbol="R_max",
    )
    equivalent_N: float = result("Equivalent load, ⟨Rᵖ⟩^(1/p).", symbol="P")
    basic_life_h: Maybe[float] = result(
        "Time that 90 % of such bearings in the housing reach, (C/P)ᵖ million turns.",
        symbol="L_10h",
    )


class CorrectionOut(ResponseModel):
    """What balances the shaft in the plane of a bearing."""

    unbalance_kg_mm: float = result("Mass times radius.", symbol="U")
    angle_deg: float = result("Its direction, counted as the crank angles are.", symbol="α")


class BalanceOut(ResponseModel):
    """Centrifugal forces of satellites and counterweights."""

    unbalance_kg_mm: float = result("Mass times radius that is left.", symbol="U")
    force_N: float = result("Its force, U·ω₁².", symbol="F")
    couple_Nm: float = result("Couple about the middle of the bearings.", symbol="M")
    grade_mm_per_s: float = result(
        "Speed of the centre of what turns about the axis, U·ω₁/M.", symbol="G"
    )
    bearing_force_N: list[float] = result("Size of the reaction of each bearing to it.")
    corrections: list[CorrectionOut]


class CrankshaftResponse(AssumingResponse):
    """Reactions of the shaft's bearings, and its balance."""

    forces: ForcesUsed = forces_used()
    bearings: list[ShaftBearingOut]
    balance: Maybe[BalanceOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

    @classmethod
    def values(cls, result: Crankshaft, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's arrays, a row for each bearing."""
        rows = []
        for peak, equivalent, life in zip(
            result.peak_reaction.tolist(),
            result.equivalent_reaction.tolist(),
            result.basic_life,
            strict=True,
        ):
            row = {"peak_N": peak, "equivalent_N": equivalent}
            rows.append(row if life is None else row | {"basic_life_h": from_si("life_h", life)})
        return super().values(result, run_time_us, bearings=rows, **given)


def reaction_figure(curves: ReactionCurves, theme: Theme) -> Figure:
    """Reactions in the crank's frame at the left, over the turn at the right.

    Parameters
    ----------
    curves : ReactionCurves
        Reactions over the turn.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    angles = from_si("crank_angle_deg", curves.crank_angle)
    force = Amount("%{y:.5g}", "N")
    data = []
    for index, letter in enumerate("AB"):
        name = text("bearing", letter=letter)
        own = curves.reaction[:, index]
        hovered = text("locus_hover", name=name, along=Amount("%{x:.5g}", "N"), across=force)
        data.append(curve(name, own.imag, own.real, index, theme, hovered, legendgroup=letter))
        hovered = text("at_angle", name=name, value=force, angle=Amount("%{x:.2f}", "°"))
        more: dict[str, Any] = {"xaxis": "x2", "yaxis": "y2", "legendgroup": letter}
        more["showlegend"] = False
        data.append(curve(name, angles, np.abs(own), index, theme, hovered, **more))
    return {
        "data": data,
        "layout": layout(
            theme,
            height=420,
            xaxis=axis(theme, text("across_first_crank"), "N", domain=[0, 0.42]),
            yaxis=axis(theme, text("along_first_crank"), "N", scaleanchor="x"),
            xaxis2=axis(theme, text("crank_angle"), "°", domain=[0.58, 1], anchor="y2"),
            yaxis2=axis(theme, text("reaction"), "N", anchor="x2", rangemode="tozero"),
        ),
    }


def solve(body: CrankshaftRequest) -> Values:
    """Reactions of the crankshaft's bearings, their life, and its balance."""
    return CrankshaftResponse.values(*run(body, body.solve), forces=body.forces)


def figure(body: CrankshaftRequest, theme: Theme = "light") -> Figure:
    """Reactions in the crank's frame and over the turn as a Plotly figure, ready for Plotly.js."""
    run(body, body.mechanism.refuse_undrawable)
    (_, curves), _ = run(body, body.solve_for_drawing)
    return reaction_figure(curves, theme)


def work(body: CrankshaftRequest) -> list[Values]:
    """Worked steps of the crankshaft."""
    steps, _ = run(body, body.steps)
    return worked(crankshaft=steps)


CALCULATION = Calculation(
    name="crankshaft",
    title="Crankshaft",
    tag="crank-planetary",
    request=CrankshaftRequest,
    answer=CrankshaftResponse,
    solve=solve,
    worked=work,
    figure=figure,
    sources=(YANCHEVSKIY_2021, ISO_281),
    neglects=("friction", "bearing_elasticity", "centrifugal_forces"),
)
