"""Answer of a crank-planetary reducer."""

from typing import Any, Literal

from pydantic import Field

from app.calculations.checks import JudgedResponse, PartOut, ReasonOut
from app.calculations.combined import CombinedOut
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.document import ForcesUsed, forces_used
from app.calculations.geometry_answer import GeometryOut
from app.calculations.hertz import HertzResponse
from app.calculations.ideal_forces import ContactForceResponse, CyclogramResponse, ForceCurvesOut
from app.calculations.load_sharing_answer import OverTurnOut, RealCyclogramOut
from app.calculations.mechanism import FitOut
from app.calculations.members_answer import MembersOut
from app.calculations.output_efficiency import OutputEfficiencyResponse
from app.calculations.pin_rollers_answer import RollersOut
from app.calculations.pin_strength import PinStrengthResponse
from app.calculations.ring_mesh_answer import DesignMeshOut, DesignPairOut, RingDrawingOut
from app.calculations.satellite_bearing import SatelliteBearingResponse
from app.calculations.shares_answer import SharesOut
from app.calculations.usual_fit_answer import UsualFitOut, UsualModificationOut
from app.model import (
    AccuracyOut,
    DocumentResponse,
    Maybe,
    ResponseModel,
    Values,
    WarningOut,
    result,
)
from core.checks.cold_yield import ColdYield
from core.checks.records import CHECKS
from core.design.layout import Envelope
from core.design.mass import Mass, PartMass
from core.design.real_forces import RealForces
from core.output.sampled_turn import WAYS


class LoadSharingOut(OverTurnOut):
    """Mechanism as it is made, over the turn, under the torque without the dynamic factor."""

    torque_direction: Literal["driving", "reverse"] = result(
        "Direction of the torque that is shown; with an alternating torque the one with the "
        "larger pressure."
    )
    judged_force_N: Maybe[float] = result(
        "Force with the largest pressure under the dynamic load, by which the section `hertz` "
        "and the checks judge.",
        symbol="F",
    )
    curves: Maybe[ForceCurvesOut] = result(
        "Force of every pair over the turn, if `load.include` names the curves."
    )
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

    @classmethod
    def values(cls, result: RealForces, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the forces over the turn; `judged_force_N` and `curves` are given."""
        direction = next(name for name, ways in WAYS.items() if ways == (result.way,))
        return super().values(result.turn, run_time_us, torque_direction=direction, **given)


class DesignHertzOut(HertzResponse):
    """Contact with the largest pressure."""

    line_load_factor: Maybe[float] = result(
        "Largest line load over the mean line load of the force, if pins bend; caused by the "
        "bending's load sharing and by the slope of the pins. All other values of the section "
        "are those at the largest line load.",
        symbol="K_b",
    )


class DesignLossesOut(OutputEfficiencyResponse):
    """Friction of the output pins, and what it makes of the whole reducer."""

    total_efficiency: Maybe[float] = result(
        "Efficiency of pins and teeth, of the pins alone if friction of the teeth is not given; "
        "bearings and seals are left out.",
        symbol="η",
    )
    input_torque_Nm: Maybe[float] = result(
        "Torque at the input that the output torque needs at this efficiency; absent if ring and "
        "pins are both outputs.",
        symbol="T₁",
    )


class EnvelopeOut(ResponseModel, of=Envelope):
    """Outer sizes of a reducer, without motor, bearing of the output and seals."""


class PartMassOut(ResponseModel, of=PartMass):
    """Mass of one part of a reducer, or the reason why it is not known."""

    BESIDE = ("reason", "missing")

    reason: Maybe[ReasonOut]
    missing: Maybe[list[str]] = Field(
        description="JSON pointers to the inputs that the mass lacks."
    )


class MassOut(ResponseModel, of=Mass):
    """Mass of a reducer without motor and bearing of the output, and its inertia at the input."""


class ColdYieldOut(ResponseModel, of=ColdYield):
    """First yield of a plastic contact. A lower torque is not proven to be safe over the life."""

    source: Maybe[str] = result("Source of the strength; absent if the request gives the strength.")
    open: list[str] = Field(
        description="Checks that this section does not cover, or whose input is not given.",
        json_schema_extra={"items": {"type": "string", "enum": [*CHECKS]}},
    )


class CrankPlanetaryResponse(JudgedResponse, DocumentResponse):
    """One section for each that was requested, and the verdict."""

    model: ForcesUsed = forces_used()
    parts: Maybe[list[PartOut]] = Field(
        description="Parts of the reducer, from which the verdict follows."
    )
    shares: Maybe[SharesOut] = result(
        "Shares of the torque that the satellites carry, if one differs from the even share by "
        "more than 1 %."
    )
    largest_torque_of: Maybe[list[str]] = Field(description="Parts that the largest torque covers.")
    largest_torque_without: Maybe[list[str]] = Field(
        description="Checks that only warn, as that of the ring's pieces, and do so at the largest "
        "torque: it does not count them."
    )
    cold_yield: Maybe[ColdYieldOut] = Field(
        description="First yield of a plastic in contact, if its strength and friction are known."
        " It stands in place of the largest torque, which is not known for plastics.",
    )
    cyclogram: Maybe[CyclogramResponse] = result("Answer of `/cyclogram`.")
    members: Maybe[MembersOut] = result(
        "Speeds, torques and powers of crank, pins and ring, if the output is not the pins or "
        "if requested."
    )
    contact_force: Maybe[ContactForceResponse] = result("Answer of `/contact-force`.")
    load_sharing: Maybe[LoadSharingOut] = result("Answer of `/load-sharing` over the turn.")
    real_cyclogram: Maybe[RealCyclogramOut] = result(
        "Pairs that carry by the forces of `load_sharing`, in its direction of the torque."
    )
    hertz: Maybe[DesignHertzOut] = result(
        "Answer of `/hertz` under the peak of the contact force. With clearance, deviations or "
        "a law of contact it also holds for the pair and the force with the largest pressure; "
        "with bending pins, for the largest line load."
    )
    pin_strength: Maybe[PinStrengthResponse] = result(
        "Answer of `/pin-strength` with the deflection: stresses under the torque times the "
        "application factor, static safety under the peak torque."
    )
    output_efficiency: Maybe[DesignLossesOut] = result(
        "Answer of `/output-efficiency` under the torque without the application factor, and the "
        "efficiency of pins and teeth together."
    )
    ring_mesh: Maybe[DesignMeshOut | DesignPairOut] = result(
        "Answer of `/ring-mesh`. Cycloid discs: under the torque without the application "
        "factor, as they work there if both meshes are in series. Involute teeth: stresses "
        "under the dynamic load."
    )
    ring_drawing: Maybe[RingDrawingOut] = result(
        "Satellites and ring of `ring_mesh` for drawing, in its direction of the torque; absent"
        " for more than 240 pairs of a ring of pins, and for involute teeth without an outline."
    )
    satellite_bearing: Maybe[SatelliteBearingResponse] = result(
        "Answer of `/satellite-bearing` under the torque without the application factor; static"
        " safety under the peak torque."
    )
    crankshaft: Maybe[CrankshaftResponse] = result(
        "Answer of `/crankshaft` under the torque without the application factor."
    )
    rollers: Maybe[RollersOut] = result(
        "Rolling bearings on the pins under the torque without the application factor; static "
        "safety under the peak torque."
    )
    fit: Maybe[FitOut] = result(
        "Fit of the pins in their holes, for any requested sections, if their sizes and the pin"
        " circle are given."
    )
    geometry: Maybe[GeometryOut] = result("Pins and holes at the requested crank angle.")
    envelope: Maybe[EnvelopeOut] = result(
        "Outer diameter and length without motor, bearing of the output and seals; by usual sizes "
        "where `build` does not give them."
    )
    mass: Maybe[MassOut] = result(
        "Mass of the parts, of all together without motor, bearing of the output, covers, seals "
        "and screws, and inertia at the input; by usual sizes where `build` does not give them."
    )
    combined: Maybe[CombinedOut] = result(
        "Changes of several inputs after which no check fails, if no change of a single input "
        "is enough."
    )
    untried: Maybe[list[str]] = Field(
        description="JSON pointers to inputs that `fixes` and `combined` did not try, as the time "
        "of the request was nearly over."
    )
    usual_fit: Maybe[UsualFitOut] = result(
        "Design with a usual clearance, if the clearance is not known, or 0, and such a fit "
        "exists for the sizes."
    )
    usual_modification: Maybe[UsualModificationOut] = result(
        "Design with a usual ring of pins, if the modification of the discs or the places of "
        "the ring pins are not known."
    )
    warnings: Maybe[list[WarningOut]] = Field(
        description="Warnings about the fit of pins and holes, for any requested sections: "
        "`interference`, `wall_holes`, `pins_apart` (such a mechanism is not "
        "possible), `clearance`, `eccentricity_assumed`, as far as `checks` do not "
        "contain them; and `uneven_sharing` of `shares`.",
    )
