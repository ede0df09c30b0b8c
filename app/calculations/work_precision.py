"""Error against run time: request, answer, figure."""

from abc import abstractmethod
from functools import partial
from typing import Annotated, Any, Literal, NoReturn, Self, get_args

from pydantic import Field, model_validator
from pydantic.json_schema import SkipJsonSchema

from app.calculations.contact_force import ContactForceRequest
from app.calculations.contact_line import ContactLineRequest
from app.calculations.load_sharing import LoadSharingRequest
from app.calculations.ring_mesh import RingMeshRequest
from app.calculations.shaft_deflection import ShaftDeflectionRequest
from app.calculations.tolerance_study import ToleranceStudyRequest
from app.model import Calculation, RequestModel, ResponseModel, Values, result, untold
from app.rules import field_error
from app.settings import Settings
from app.theme import LEGEND, Amount, Chart, Figure, Theme, text
from core.errors import METHODS, InvalidInput
from core.precision import CLASSES
from core.work_precision.peaks import peak_force_study, real_peak_study
from core.work_precision.precession import contact_line_study, shaft_deflection_study
from core.work_precision.study import SETTINGS, Reference, WorkPoint, WorkPrecision
from core.work_precision.tolerance import COST, tolerance_sampling_study

MAX_ROLLERS = 24
"""Largest number of rollers in a study, as the reference is calculated for each."""

ONE_METHOD = {
    "crankshaft": "sampling",
    "cyclogram": "closed_form",
    "fit": "arcs_zoomed",
    "hertz": "closed_form_newton",
    "meshing_load": "graded_quadrature",
    "output-efficiency": "segments_tanh_sinh",
    "pin-strength": "sampling",
    "precession/meshing-load": "graded_quadrature",
    "roller-strength": "closed_form_gaps",
    "roller_sharing": "closed_form_gaps",
    "satellite-bearing": "sampling",
}
"""Method of each calculation that has one, of ideal forces, by every name that it has had."""

compared = partial(Field, description="Calculation whose methods are compared.")


class Study(RequestModel):
    """Study of one calculation, which repeats every method."""

    @abstractmethod
    def solve(self) -> WorkPrecision:
        """The study."""


class NotCompared(RequestModel):
    """Calculation with one method and nothing to compare."""

    calculation: Literal[*ONE_METHOD]  # type: ignore[valid-type]

    @model_validator(mode="before")
    @classmethod
    def _refused(cls, asked: dict[str, Any]) -> NoReturn:
        promised = CLASSES[ONE_METHOD[asked["calculation"]]]
        raise field_error("calculation", "no_methods", relative_error=promised)


class PeakForceStudy(Study):
    """Peak of the contact force."""

    calculation: Literal["contact-force", "peak_force"] = compared()
    input: ContactForceRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return peak_force_study(
            mechanism=self.input.mechanism(), force_exponent=self.input.force_exponent
        )


class ContactLineStudy(Study):
    """Total length of the contact lines."""

    calculation: Literal["precession/contact-line", "contact_line_length"] = compared()
    input: ContactLineRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        rollers = self.input.all_rollers()
        if len(rollers) > MAX_ROLLERS:
            raise InvalidInput("rollers", len(rollers), "service_limit", limit=MAX_ROLLERS)
        return contact_line_study(gear=self.input.gear(), rollers=rollers)


class ShaftDeflectionStudy(Study):
    """Deflection of the shaft at C."""

    calculation: Literal["precession/shaft-deflection", "shaft_deflection"] = compared()
    input: ShaftDeflectionRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        load = self.input.solve_load()
        loaded = {"force": load.force, "moment": load.moment}
        return shaft_deflection_study(shaft=loaded | self.input.shaft)


class LoadSharingStudy(Study):
    """Peak force with clearance and errors, by the output alone or in series with the ring."""

    calculation: Literal["load-sharing"] = compared()
    input: LoadSharingRequest

    def solve(self) -> WorkPrecision:
        """Study under a torque; an alternating one in its driving direction."""
        return real_peak_study(real=self.input.results.stage, output_torque=self.input.torque)


class ComparedMeshRequest(RingMeshRequest):
    """Cycloid discs on their ring pins; involute teeth have closed forms only."""

    @model_validator(mode="after")
    def _of_cycloids(self) -> Self:
        if self.ring_kind != "cycloid":
            raise field_error("gear/kind", "literal_error", expected="'cycloid'")
        return self


class RingMeshStudy(Study):
    """Peak force of cycloid discs on the pins of their ring."""

    calculation: Literal["ring-mesh"] = compared()
    input: ComparedMeshRequest

    def solve(self) -> WorkPrecision:
        """The study."""
        return real_peak_study(real=self.input.mesh, output_torque=self.input.torque)


class ToleranceSamplingStudy(Study):
    """Highest requested percentile of the first quantity, or its mean."""

    calculation: Literal["tolerance-study"] = compared()
    input: ToleranceStudyRequest

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits, or too slow for the repetitions here."""
        self.input.refuse_longer(settings, COST)
        self.input.refuse_beyond(settings)

    def solve(self) -> WorkPrecision:
        """The study."""
        percent = max(self.input.percentiles, default=None)
        return tolerance_sampling_study(study=self.input.study(untold), percent=percent)


WorkPrecisionRequest = Annotated[
    PeakForceStudy
    | ContactLineStudy
    | ShaftDeflectionStudy
    | LoadSharingStudy
    | RingMeshStudy
    | ToleranceSamplingStudy
    | SkipJsonSchema[NotCompared],
    Field(discriminator="calculation"),
]

COMPARED = [
    get_args(each.model_fields["calculation"].annotation) for each in Study.__subclasses__()
]
"""Names of each calculation whose methods are compared, with former names behind."""


class ReferenceOut(ResponseModel, of=Reference):
    """Reference against which errors are measured."""

    method_code: str = result("Method of the reference, by code.")

    @classmethod
    def values(cls, result: Reference, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's reference."""
        return super().values(result, method=METHODS[result.method], method_code=result.method)


class WorkPointOut(ResponseModel, of=WorkPoint):
    """One method at one setting."""

    method_code: str = result("Method, by code.")
    setting_code: str = result("Setting that is varied, by code.")
    setting_value: float = result("Value of the setting.")

    @classmethod
    def values(cls, result: WorkPoint, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's point."""
        return super().values(
            result,
            method=METHODS[result.method],
            method_code=result.method,
            setting=SETTINGS[result.setting].format(value=result.value),
            setting_code=result.setting,
            setting_value=result.value,
        )


class WorkPrecisionResponse(ResponseModel, of=WorkPrecision):
    """Error against run time of every method, and the method that the calculators use."""


EXACT = 1e-17
"""Place of an error of 0 in the figure, below the rounding of any double."""


def solve(body: WorkPrecisionRequest) -> Values:
    """Error against run time of the methods of a calculation, for the input given."""
    assert isinstance(body, Study)  # the other is refused as it is read
    return WorkPrecisionResponse.values(body.solve())


def figure(body: WorkPrecisionRequest, theme: Theme = "light") -> Figure:
    """Error against run time as a diagram with logarithmic axes."""
    answer, methods = solve(body), dict[str, list[Values]]()
    for point in answer["points"]:
        methods.setdefault(point["method_code"], []).append(point)
    amounts = {"error": Amount("%{y:.2g}"), "time": Amount("%{x:.3g}", "µs")}
    chart = Chart(theme, height=600)
    chart.layout["legend"] = LEGEND | {"y": -0.18, "yanchor": "top", "font": {"size": 11}}
    # All powers of ten alike, 1e-4 as 1e-14, and only digits between them.
    chart.axis("x", "run_time", "µs", type="log", dtick=1, tickformat="~r")
    chart.axis("y", "relative_error", type="log", exponentformat="e", tickformat="")
    for index, (code, points) in enumerate(methods.items()):
        method = text(f"methods.{code}")
        chart.curve(
            method,
            [point["run_time_us"] for point in points],
            [max(point["relative_error"], EXACT) for point in points],
            index,
            text("error_in_time", method=method, setting="%{customdata}", **amounts),
            mode="lines+markers",
            marker={"size": 7},
            customdata=[
                text(f"settings.{point['setting_code']}", value=point["setting_value"])
                for point in points
            ],
        )
    chosen = answer["chosen"]
    used = text("error_in_time_chosen", method=text(f"methods.{chosen['method_code']}"), **amounts)
    chart.mark("used", chosen["run_time_us"], max(chosen["relative_error"], EXACT), used)
    return chart.figure


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
