"""Answer of a crank-planetary reducer."""

from typing import Any, Literal

from pydantic import Field

from app.calculations.checks import JudgedResponse, PartOut
from app.calculations.combined import CombinedOut
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.design import ForcesUsed, forces_used
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
from app.model import AccuracyOut, Maybe, ResponseModel, Values, WarningOut, result
from core.checks.records import CHECKS
from core.design.real_forces import RealForces
from core.output.sampled_turn import WAYS


class LoadSharingOut(OverTurnOut):
    """Mechanism as it is made, over the turn, under the torque without the dynamic factor."""

    torque_direction: Literal["driving", "reverse"] = result(
        "Direction of the torque: of both the one with the larger pressure."
    )
    judged_force_N: Maybe[float] = result(
        "Force with the largest pressure under the dynamic load: that of the section hertz and of "
        "the checks.",
        symbol="F",
    )
    curves: Maybe[ForceCurvesOut] = result(
        "Force of every pair over the turn, where `load.include` asks for curves."
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
        "Largest line load over the even one of the force, where pins bend: by how they share the "
        "load, and by their slope. All else is said of that line load.",
        symbol="K_b",
    )


class ColdYieldOut(ResponseModel):
    """First yield of a plastic contact. A lower torque is not proven to be safe over the life."""

    torque_Nm: float = result(
        "Torque above which the plastic yields at once, cold: the first time it acts, at 23 °C."
    )
    part: Literal["contact", "teeth"] = result(
        "What yields: a pin or a hole, or the teeth of a disc on pins whose forces are known."
    )
    quarter_Nm: float = result("A quarter of it, at which the stress is half of the strength.")
    strength_MPa: float = result("Strength that this is by, in the direction that is loaded.")
    friction: float = result(
        "Friction coefficient of what slides there; of teeth 0 where it is not known.", symbol="μ"
    )
    source: Maybe[str] = result("Where the strength comes from; absent where it was given.")
    open: list[str] = Field(
        description="Checks of what nothing here says, or more would have to be given for.",
        json_schema_extra={"items": {"type": "string", "enum": [*CHECKS]}},
    )


class CrankPlanetaryResponse(JudgedResponse):
    """One section for each that was requested, and the verdict."""

    model: ForcesUsed = forces_used()
    parts: Maybe[list[PartOut]] = Field(
        description="The parts of the reducer, of which the verdict is."
    )
    shares: Maybe[SharesOut] = result(
        "How the satellites share the torque, where one does not carry its part within 1 %."
    )
    largest_torque_of: Maybe[list[str]] = Field(description="Parts that the largest torque is of.")
    cold_yield: Maybe[ColdYieldOut] = Field(
        description="Where a plastic touches and its strength and friction are known: in the place "
        "of the largest torque, which nobody knows of it.",
    )
    cyclogram: Maybe[CyclogramResponse] = result("As `/cyclogram` answers.")
    members: Maybe[MembersOut] = result(
        "Speeds, torques and powers of crank, pins and ring; where others than the pins are the "
        "output, or where asked."
    )
    contact_force: Maybe[ContactForceResponse] = result("As `/contact-force` answers.")
    load_sharing: Maybe[LoadSharingOut] = result("As `/load-sharing` answers over the turn.")
    real_cyclogram: Maybe[RealCyclogramOut] = result(
        "Which pairs carry by the forces of `load_sharing`, in its direction of the torque."
    )
    hertz: Maybe[DesignHertzOut] = result(
        "As `/hertz` answers, under the peak of the contact force; with clearance, deviations or a "
        "law of contact of the pair and under the force with the largest pressure; with bending "
        "pins under the largest line load."
    )
    pin_strength: Maybe[PinStrengthResponse] = result(
        "As `/pin-strength` answers, with the deflection: under the torque times its factor, the "
        "static safety under the peak torque."
    )
    output_efficiency: Maybe[OutputEfficiencyResponse] = result(
        "As `/output-efficiency` answers, under the torque without its factor."
    )
    ring_mesh: Maybe[DesignMeshOut | DesignPairOut] = result(
        "As `/ring-mesh` answers: of cycloid discs under the torque without its factor, where both "
        "meshes are in series as they work there; of involute teeth stresses under the dynamic "
        "load."
    )
    ring_drawing: Maybe[RingDrawingOut] = result(
        "Satellites and ring of `ring_mesh` as they are drawn, in its direction of the torque; "
        "absent of more than 240 pairs of a ring of pins, and of involute teeth without an outline."
    )
    satellite_bearing: Maybe[SatelliteBearingResponse] = result(
        "As `/satellite-bearing` answers, under the torque without its factor, the static safety "
        "under the peak torque."
    )
    crankshaft: Maybe[CrankshaftResponse] = result(
        "As `/crankshaft` answers, under the torque without its factor."
    )
    rollers: Maybe[RollersOut] = result(
        "Rolling bearings on the pins, under the torque without its factor, the static safety "
        "under the peak torque."
    )
    fit: Maybe[FitOut] = result(
        "How the pins fit into their holes, whichever sections are asked, where their sizes and "
        "their circle are given."
    )
    geometry: Maybe[GeometryOut] = result("Pins and holes at the crank angle asked.")
    combined: Maybe[CombinedOut] = result(
        "Changes of several inputs with which no check fails, where no change of one is enough."
    )
    usual_fit: Maybe[UsualFitOut] = result(
        "The design with a usual clearance, where it is not known, or 0, and sizes have such a fit."
    )
    usual_modification: Maybe[UsualModificationOut] = result(
        "The design with a usual ring of pins, where nothing is known of the modification of its "
        "discs, or of the places of its pins."
    )
    warnings: Maybe[list[WarningOut]] = Field(
        description="How pins and holes fit, whichever sections are asked: `interference`, "
        "`wall_holes`, `pins_apart` (such a mechanism is not possible), `clearance`, "
        "`eccentricity_assumed`, not what `checks` say; and `uneven_sharing` of `shares`.",
    )
