"""Strength of the pins: request, answer, figure."""

import math
from collections.abc import Iterator
from functools import partial
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from app.calculations.document import (
    FORCES,
    LOADED,
    TOUCHING,
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
    result,
    timed,
)
from app.rules import Rule, field_error
from app.sources import SHIGLEY, YANCHEVSKIY_2021
from app.theme import Amount, Chart, Figure, Theme, text
from app.units import from_si
from app.worked import Steps
from core.design.document import changed
from core.design.results import Results
from core.errors import if_known
from core.output.pin_beam import Support
from core.output.pin_bolt import Grip
from core.output.pin_fatigue import PinFatigue
from core.output.pin_strength import MomentLocus, PinDeflection, PinStrength
from core.output.tied_pin import TieRingLoad
from core.worked.pins import strength_steps

BOUNDS: tuple[Support, ...] = ("supported", "fixed")
"""Supports between which the true support of a cage lies."""


class PinStrengthRequest(StrengthFields):
    """Design document with a load, a pin and the basis of its fatigue strength; with a contact the
    forces follow from it too.
    """

    NEEDS: ClassVar[Needs] = (*LOADED, "pin", "pin/satellite_positions_mm")
    NEEDED_OF: ClassVar[dict[str, Needs]] = {"contact": TOUCHING}
    USES: ClassVar[frozenset[str]] = FORCES | {"fatigue", "requirements"}
    BETWEEN: ClassVar[tuple[Rule, ...]] = tuple(
        Rule(f"pin/{name}", "needed", "contact")
        for name in ("diameter_mm", "contact_length_mm", "material")
    )

    include: list[Literal["deflection", "locus", "support_bounds", "worked"]] = Field(
        default=[],
        max_length=4,
        description="Optional results; only those that are named are computed.",
    )

    @model_validator(mode="after")
    def _span_of_bounds(self) -> Self:
        if "support_bounds" in self.include and not self.says("pin/span_mm"):
            raise field_error("pin/span_mm", "needed_for", section="support_bounds")
        return self

    PIN_ALONE: ClassVar[bool] = True

    def solve(self, *, locus: bool = False) -> PinStrength:
        """Strength of the pin."""
        return self.with_fit(self.results.judged_pins(locus=locus or "locus" in self.include))

    def steps(self) -> Steps:
        """Worked steps of the strength."""
        deflection = "deflection" in self.include
        return {
            "pin_strength": strength_steps(
                results=self.results, found=self.solve(), deflection=deflection
            )
        }

    @property
    def left_out(self) -> dict[str, None]:
        """Subjects that are not requested, as an answer states them."""
        return {} if "deflection" in self.include else {"deflection": None}

    def solve_held(self, support: Support) -> PinStrength:
        """Strength of the pin in other supports, under the forces with these supports."""
        held = Results(changed(self.design, {"pin.support": support}))
        return held.pin_strength

    def bounds(self) -> Iterator[Values]:
        """Strength of the pin in the two supports that bound the true support of a cage."""
        for support in BOUNDS:
            found = timed(partial(self.solve_held, support))
            yield SupportBoundOut.values(*found, support=support, **self.left_out)


class PinFatigueOut(ResponseModel, of=PinFatigue):
    """Worst stress cycle of a pin. Direction and stresses are accurate to 1e-4, as the safety is
    nearly constant around them.
    """


class PinDeflectionOut(ResponseModel, of=PinDeflection):
    """Largest deflection and slope in the middle of satellites."""


class TieRingOut(ResponseModel, of=TieRingLoad):
    """Largest loads and movements of a tie ring over the turn; the strength of the joint is not
    judged.
    """


class BoltOut(ResponseModel, of=Grip):
    """Bolt through a spacer under the largest loads of the root, as the spacer carries them."""


class MomentLocusOut(ResponseModel, of=MomentLocus):
    """Bending moment of a section of the worst pin over one turn of the crank relative to the pins:
    the section of the worst stress cycle, or of the largest moment without fatigue data.
    """


class PinStrengthOut(ResponseModel, of=PinStrength):
    """Bending, shear, static safety, fatigue and deflection of the pins in their supports."""

    deflection: Maybe[PinDeflectionOut]


class SupportBoundOut(PinStrengthOut):
    """Pin in one of the supports that bound the true support of a cage."""

    support: Support = result(
        "Support at both ends: free to tilt (supported), or built in (fixed)."
    )


class PinStrengthResponse(PinStrengthOut, DocumentResponse):
    """Bending, shear, static safety, fatigue and deflection of the pins."""

    BESIDE = ("support_bounds",)

    forces: ForcesUsed = forces_used()
    locus: Maybe[MomentLocusOut] = None
    support_bounds: Maybe[list[SupportBoundOut]] = result(
        "Strength of pins held at both ends, first free to tilt, then built in, for any support"
        " in the request. The true support of a cage lies between them; the worse result is on "
        "the safe side."
    )


def solve(body: PinStrengthRequest) -> Values:
    """Strength of the pins: bending, shear, static safety, fatigue by the true stress cycle."""
    strength = timed(body.solve)
    bounds = [*body.bounds()] if "support_bounds" in body.include else None
    said: dict[str, Any] = {"forces": body.forces, "support_bounds": bounds} | body.left_out
    return PinStrengthResponse.values(*strength, **said)


def figure(body: PinStrengthRequest, theme: Theme = "light") -> Figure:
    """Locus of the moment and stress over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    found = body.solve(locus=True)
    locus = found.locus
    assert locus is not None
    chart = Chart(theme, height=420)
    plane = ("moment_tangential", "moment_radial", "N·m")
    chart.locus_and_turn(*plane, "bending_stress", "MPa")
    chart.locus("moment_locus", locus.tangential, locus.radial)
    largest = float(np.hypot(locus.tangential, locus.radial).max())
    if (chi := if_known(lambda: found.fatigue.direction)) is not None:
        ends, worst = np.array([-largest, largest]), text("worst_direction")
        hovered = text("mean_hover", name=worst, value=Amount(math.degrees(chi), "°", 5))
        chart.curve(worst, ends * math.cos(chi), ends * math.sin(chi), 1, hovered)
    angles, stress = from_si("angle_deg", locus.crank_angle), from_si("stress_MPa", locus.stress)
    chart.curve("bending_stress", angles, stress, 2, axis="y2")
    return chart.figure


CALCULATION = Calculation(
    name="pin-strength",
    title="Strength of the pins",
    tag="crank-planetary",
    request=PinStrengthRequest,
    answer=PinStrengthResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, SHIGLEY),
    neglects=(
        "fretting",
        "friction",
        "seat_compliance",
    ),
)
