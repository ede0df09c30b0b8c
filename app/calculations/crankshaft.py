"""Reactions and balance of the crankshaft: request, answer, figure."""

import math
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
    Maybe,
    ResponseModel,
    Values,
    WorkedFields,
    result,
    timed,
)
from app.sources import ISO_281, YANCHEVSKIY_2021
from app.theme import Chart, Figure, Theme, text
from app.units import from_si
from app.worked import Steps
from core.crank.balance import Balance, Correction
from core.crank.crankshaft import Crankshaft
from core.design.curves import design_reactions
from core.worked.crank import shaft_steps


class CrankshaftRequest(StrengthFields, WorkedFields):
    """Design document with a load, crank, ring and crankshaft; pins and holes if the forces follow
    from them too.
    """

    NEEDS: ClassVar[Needs] = (*TURNING, "gear", "crankshaft")
    NEEDED_OF: ClassVar[dict[str, Needs]] = dict.fromkeys(PIN_SECTIONS, TOUCHING)
    USES: ClassVar[frozenset[str]] = FORCES | {"bearing", "crankshaft", "requirements"}

    def cost(self) -> float:
        """Infinite, as the loads of the bearings are searched over the turn."""
        return math.inf

    def solve(self) -> Crankshaft:
        """Reactions and lives of the bearings, and balance if mass and speed are known."""
        return self.with_fit(self.results.crank.shaft)

    def steps(self) -> Steps:
        """Worked steps of reactions, lives and balance."""
        return {"crankshaft": shaft_steps(self.results)}


class ShaftBearingOut(ResponseModel):
    """A bearing of the shaft."""

    peak_N: float = result(
        "Largest reaction over the turn; the reaction to centrifugal forces is included if the "
        "balance is known.",
        symbol="R_max",
    )
    equivalent_N: float = result("Equivalent load, ⟨Rᵖ⟩^(1/p).", symbol="P")
    basic_life_h: Maybe[float] = result(
        "Life that 90 % of such bearings in the housing reach, (C/P)ᵖ million turns.",
        symbol="L_10h",
    )


class CorrectionOut(ResponseModel, of=Correction):
    """Correction of the unbalance in the plane of a bearing."""


class BalanceOut(ResponseModel, of=Balance):
    """Centrifugal forces of satellites and counterweights."""

    bearing_force_N: list[float]
    corrections: list[CorrectionOut]


class CrankshaftResponse(DocumentResponse, of=Crankshaft):
    """Reactions of the shaft's bearings, and its balance."""

    forces: ForcesUsed = forces_used()
    bearings: list[ShaftBearingOut]

    @classmethod
    def values(cls, result: Crankshaft, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's arrays, a row for each bearing."""
        sizes = zip(result.peak_reaction.tolist(), result.equivalent_reaction.tolist(), strict=True)
        rows = [{"peak_N": peak, "equivalent_N": equivalent} for peak, equivalent in sizes]
        for row, life in result.basic_life.items():
            rows[row]["basic_life_h"] = from_si("life_h", life)
        return super().values(result, run_time_us, bearings=rows, **given)


def solve(body: CrankshaftRequest) -> Values:
    """Reactions of the crankshaft's bearings, their life, and its balance."""
    return CrankshaftResponse.values(*timed(body.solve), forces=body.forces)


def figure(body: CrankshaftRequest, theme: Theme = "light") -> Figure:
    """Reactions in the crank's frame and over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    angles, _ = body.drawn_angles()
    curves = design_reactions(results=body.results, crank_angle=angles)
    chart = Chart(theme, height=420)
    plane = ("across_first_crank", "along_first_crank", "N")
    chart.locus_and_turn(*plane, "reaction", "N", rangemode="tozero")
    for index, letter in enumerate("AB"):
        own = curves.reaction[:, index]
        name = text("bearing", letter=letter)
        chart.locus(name, own.imag, own.real, index, legendgroup=letter)
        more: Figure = {"axis": "y2", "legendgroup": letter, "showlegend": False}
        chart.curve(name, from_si("angle_deg", angles), np.abs(own), index, **more)
    return chart.figure


CALCULATION = Calculation(
    name="crankshaft",
    title="Crankshaft",
    tag="crank-planetary",
    request=CrankshaftRequest,
    answer=CrankshaftResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, ISO_281),
    neglects=("friction", "bearing_elasticity", "centrifugal_forces"),
)
