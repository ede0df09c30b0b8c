"""Error against run time: request, answer, figure."""

from functools import partial
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from app.calculations.contact_force import ContactForceRequest
from app.calculations.contact_line import ContactLineRequest
from app.calculations.crankshaft import CrankshaftRequest
from app.calculations.fit import FitRequest
from app.calculations.hertz import HertzRequest
from app.calculations.load_sharing import LoadSharingRequest
from app.calculations.meshing_load import MeshingLoadRequest
from app.calculations.output_efficiency import OutputEfficiencyRequest
from app.calculations.pin_strength import PinStrengthRequest
from app.calculations.ring_mesh import RingMeshRequest
from app.calculations.ring_parts import CycloidRingFields
from app.calculations.roller_strength import RollerStrengthRequest
from app.calculations.satellite_bearing import SatelliteBearingRequest
from app.calculations.shaft_deflection import ShaftDeflectionRequest
from app.calculations.tolerance_study import ToleranceStudyRequest
from app.model import Calculation, RequestModel, ResponseModel, Values, result, untold
from app.rules import field_error
from app.settings import Settings
from app.theme import DASHES, Amount, Figure, Theme, axis, curve, layout, marker, text
from app.units import to_si
from core.design.results import Results
from core.errors import METHODS, InvalidInput
from core.ring.sharing import MeshTurn
from core.work_precision.contact import contact_pressure_study
from core.work_precision.means import (
    equivalent_load_study,
    equivalent_reaction_study,
    total_force_study,
)
from core.work_precision.peaks import (
    edge_load_study,
    peak_force_study,
    pin_bending_study,
    real_peak_study,
)
from core.work_precision.precession import (
    contact_line_study,
    meshing_load_study,
    shaft_deflection_study,
)
from core.work_precision.rollers import roller_sharing_study
from core.work_precision.study import SETTINGS, Reference, WorkPoint, WorkPrecision
from core.work_precision.tolerance import COST, Mean, Percentile, tolerance_sampling_study
from core.work_precision.turns import carried_ends_study, least_room_study

MAX_ROLLERS = 24
"""Most rollers of a study: its reference is calculated for each."""

compared = partial(Field, description="Whose methods are compared.")


class Study(RequestModel):
    """A study of one calculation, which repeats every method."""


class PeakForceStudy(Study):
    """Peak of the contact force."""

    calculation: Literal["contact-force", "peak_force"] = compared()
    input: ContactForceRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return peak_force_study(
            mechanism=self.input.mechanism(), force_exponent=self.input.force_exponent
        )


class ContactPressureStudy(Study):
    """Largest pressure of pin in hole."""

    calculation: Literal["hertz"] = compared()
    input: HertzRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return contact_pressure_study(contact=self.input.solve())


class TotalForceStudy(Study):
    """Mean of the total force, to which the mean loss is proportional."""

    calculation: Literal["output-efficiency"] = compared()
    input: OutputEfficiencyRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return total_force_study(
            mechanism=self.input.built, force_exponent=self.input.load.force_exponent
        )


class PinStrengthStudy(Study):
    """Largest bending stress or slope of the pins, or line load where they slope, by ideal forces
    that the satellites share equally.
    """

    calculation: Literal["pin-strength"] = compared()
    input: PinStrengthRequest
    quantity: Literal["bending_stress", "slope", "edge_load"] = Field(
        default="bending_stress",
        description="Whose error is measured: of the stress, the slope, or the largest line load "
        "at an end of a contact, which needs the contact.",
    )

    @model_validator(mode="after")
    def _contact_of_edges(self) -> Self:
        if self.quantity == "edge_load" and self.input.contact is None:
            raise field_error("input/contact", "needed_beside", field="quantity")
        return self

    def solve(self) -> WorkPrecision:
        """The study."""
        results, equally = self.input.results, {"made": None}
        loaded = results.loaded_pins | equally
        if self.quantity != "edge_load":
            return pin_bending_study(quantity=self.quantity, **loaded)
        length = results.design.nominal_pair.contact_length
        return edge_load_study(edge_length=length, compliance=results.compliance, **loaded)


def _turning(results: Results) -> dict[str, Any]:
    """What presses the cranks over the turn, as arguments."""
    design = results.design
    return {
        "mechanism": design.built,
        "force_exponent": design.load.force_exponent,
        "pin_circle_radius": design.load.pin_circle_radius,
        "eccentricity": design.known_eccentricity,
        "mesh": results.ring.force,
    }


class SatelliteBearingStudy(Study):
    """Equivalent load of the satellites' bearings, by ideal forces that these share equally."""

    calculation: Literal["satellite-bearing"] = compared()
    input: SatelliteBearingRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        results = self.input.results
        return equivalent_load_study(**_turning(results), kind=results.design.bearing.kind)


class CrankshaftStudy(Study):
    """Equivalent reaction of the crankshaft's bearings, by ideal forces that satellites share
    equally.
    """

    calculation: Literal["crankshaft"] = compared()
    input: CrankshaftRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        shaft = self.input.design.crankshaft
        kinds: dict[str, Any] = {}
        if shaft.bearings:
            kinds["kinds"] = (shaft.bearings[0].kind, shaft.bearings[1].kind)
        return equivalent_reaction_study(
            **_turning(self.input.results),
            satellite_positions=shaft.satellite_positions,
            bearing_positions=shaft.bearing_positions,
            **kinds,
        )


class ContactLineStudy(Study):
    """Total length of the contact lines."""

    calculation: Literal["precession/contact-line", "contact_line_length"] = compared()
    input: ContactLineRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        rollers = self.input.all_rollers()
        _refuse_many(len(rollers))
        return contact_line_study(gear=self.input.gear(), rollers=rollers)


class MeshingLoadStudy(Study):
    """Force of the mesh."""

    calculation: Literal["precession/meshing-load", "meshing_load"] = compared()
    input: MeshingLoadRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        rollers = self.input.all_rollers()
        _refuse_many(len(rollers))
        return meshing_load_study(
            gear=self.input.gear(),
            rollers=rollers,
            torque=self.input.torque_Nm,
            reference_z=to_si("reference_z_mm", self.input.reference_z_mm),
        )


class RollerSharingStudy(Study):
    """Forces of the swinging rollers."""

    calculation: Literal["roller-strength", "roller_sharing"] = compared()
    input: RollerStrengthRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        design = self.input.solve()
        return roller_sharing_study(
            total=design.mean_force * self.input.rollers,
            stiffness=design.stiffness,
            gaps=self.input.design["spacing"].gaps(self.input.rollers),
        )


class ShaftDeflectionStudy(Study):
    """Deflection of the shaft at C."""

    calculation: Literal["precession/shaft-deflection", "shaft_deflection"] = compared()
    input: ShaftDeflectionRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        load = self.input.solve_load()
        return shaft_deflection_study(
            force=load.force,
            moment=load.moment,
            **self.input.shaft,
        )


class LoadSharingStudy(Study):
    """Peak force with clearance and errors, or from where to where pairs carry, by the output alone
    or in series with the ring; of a torque that alternates its driving direction.
    """

    calculation: Literal["load-sharing"] = compared()
    input: LoadSharingRequest
    quantity: Literal["peak_force", "carried_ends"] = Field(
        default="peak_force",
        description="Whose error is measured: of the peak force, or of the crank angles from and "
        "to which pairs carry.",
    )

    def solve(self) -> WorkPrecision:
        """The study."""
        study = real_peak_study if self.quantity == "peak_force" else carried_ends_study
        stage = self.input.stage(self.input.real())
        return study(real=stage, output_torque=self.input.torque)


class ComparedMeshRequest(RingMeshRequest):
    """Cycloid discs on the pins of their ring: of involute teeth all is in closed form."""

    gear: CycloidRingFields


class RingMeshStudy(Study):
    """Peak force of cycloid discs on the pins of their ring."""

    calculation: Literal["ring-mesh"] = compared()
    input: ComparedMeshRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return real_peak_study(
            real=self.input.mesh,
            output_torque=self.input.torque,
            over=MeshTurn,
            pins="ring_teeth",
        )


class FitStudy(Study):
    """Least room of the pins in their holes over the turn."""

    calculation: Literal["fit"] = compared()
    input: FitRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return least_room_study(rooms=self.input.rooms_to_draw())


class ToleranceSamplingStudy(Study):
    """The highest percentile asked of the first quantity, its mean where none is."""

    calculation: Literal["tolerance-study"] = compared()
    input: ToleranceStudyRequest

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what the operator does not allow, or what takes too long, as often as it is done
        here.
        """
        self.input.refuse_longer(settings, COST)
        self.input.refuse_beyond(settings)

    def solve(self) -> WorkPrecision:
        """The study."""
        asked = self.input.percentiles
        return tolerance_sampling_study(
            study=self.input.study(untold),
            statistic=Percentile(max(asked)) if asked else Mean(),
        )


def _refuse_many(rollers: int) -> None:
    if rollers > MAX_ROLLERS:
        raise InvalidInput("rollers", rollers, "service_limit", limit=MAX_ROLLERS)


WorkPrecisionRequest = Annotated[
    PeakForceStudy
    | ContactPressureStudy
    | TotalForceStudy
    | PinStrengthStudy
    | SatelliteBearingStudy
    | CrankshaftStudy
    | ContactLineStudy
    | MeshingLoadStudy
    | RollerSharingStudy
    | ShaftDeflectionStudy
    | LoadSharingStudy
    | RingMeshStudy
    | FitStudy
    | ToleranceSamplingStudy,
    Field(discriminator="calculation"),
]


class ReferenceOut(ResponseModel):
    """What the errors are measured against."""

    method: str = result("How the reference was got, in English.")
    method_code: str = result("The same by code.")
    digits: int = result("Decimal digits that it is right to.")

    @classmethod
    def values(cls, result: Reference, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's reference."""
        return super().values(result, method=METHODS[result.method], method_code=result.method)


class WorkPointOut(ResponseModel):
    """One method at one setting."""

    method: str = result("The method, in English.")
    method_code: str = result("The same by code.")
    setting: str = result("What was varied, in English.")
    setting_code: str = result("The same by code.")
    setting_value: float = result("Its value.")
    relative_error: float = result("Error against the reference, relative.")
    run_time_us: float = result("Run time.")
    evaluations: int = result("Evaluations of the function behind the method.")

    @classmethod
    def values(cls, result: WorkPoint, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's point."""
        code, value = result.setting
        return super().values(
            result,
            method=METHODS[result.method],
            method_code=result.method,
            setting=SETTINGS[code].format(value=value),
            setting_code=code,
            setting_value=value,
        )


class WorkPrecisionResponse(ResponseModel):
    """Error against run time of every method, and the method that the calculators use."""

    reference: ReferenceOut = result("What the errors are measured against.")
    points: list[WorkPointOut] = result("Every method at each of its settings.")
    chosen: WorkPointOut = result("The method that the calculators use.")


EXACT = 1e-17
"""Where an error of nothing is drawn: below the rounding of any double."""

POWERS = {"type": "log", "exponentformat": "e", "tickformat": ""}
"""Ticks of an axis: all powers of ten alike, 1e-4 as 1e-14, and only digits between them."""

SYMBOLS = ("circle", "square", "triangle-up")
"""Marks that tell methods apart whose colours and dashes repeat."""


def work_precision_figure(answer: Values, theme: Theme) -> Figure:
    """Every method's errors over its run times, the default marked."""
    methods: dict[str, list[Values]] = {}
    for point in answer["points"]:
        methods.setdefault(point["method_code"], []).append(point)
    data = []
    for index, (code, points) in enumerate(methods.items()):
        method = text(f"methods.{code}")
        line = curve(
            method,
            [point["run_time_us"] for point in points],
            [max(point["relative_error"], EXACT) for point in points],
            index,
            theme,
            text(
                "error_in_time",
                method=method,
                setting="%{customdata}",
                error=Amount("%{y:.2g}"),
                time=Amount("%{x:.3g}", "µs"),
            ),
        )
        line |= {
            "mode": "lines+markers",
            "marker": {"symbol": SYMBOLS[index // len(DASHES) % len(SYMBOLS)], "size": 7},
            "customdata": [
                text(f"settings.{point['setting_code']}", value=point["setting_value"])
                for point in points
            ],
        }
        data.append(line)
    chosen = answer["chosen"]
    data.append(
        marker(
            text("used"),
            chosen["run_time_us"],
            max(chosen["relative_error"], EXACT),
            theme,
            text(
                "error_in_time_chosen",
                method=text(f"methods.{chosen['method_code']}"),
                error=Amount("%{y:.2g}"),
                time=Amount("%{x:.3g}", "µs"),
            ),
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=600,
            # All powers of ten alike, 1e-4 as 1e-14, and only digits between them.
            xaxis=axis(theme, text("run_time"), "µs", type="log", dtick=1, tickformat="~r"),
            yaxis=axis(
                theme, text("relative_error"), type="log", exponentformat="e", tickformat=""
            ),
            legend={"orientation": "h", "y": -0.18, "yanchor": "top", "x": 0, "font": {"size": 11}},
        ),
    }


def solve(body: WorkPrecisionRequest) -> Values:
    """Error against run time of the methods of a calculation, for the input given."""
    study = body.solve()
    return WorkPrecisionResponse.values(study)


def figure(body: WorkPrecisionRequest, theme: Theme = "light") -> Figure:
    """The same as a diagram, both axes logarithmic."""
    return work_precision_figure(solve(body), theme)


CALCULATION = Calculation(
    name="work-precision",
    title="Error against run time",
    tag="accuracy",
    request=WorkPrecisionRequest,
    answer=WorkPrecisionResponse,
    solve=solve,
    figure=figure,
    batched=False,
)
