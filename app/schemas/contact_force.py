"""Request and answer of the contact force."""

from dataclasses import replace
from typing import Any, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from app.schemas.base import (
    SIZE,
    AccuracyOut,
    RequestModel,
    ResponseModel,
    Values,
    WarningOut,
    field_error,
    quantity,
)
from app.schemas.mechanism import MechanismFields
from app.settings import Settings
from app.units import from_si, rounded, to_si
from core.arrays import FloatArray
from core.errors import InvalidInput
from core.output.contact_force import (
    ContactForce,
    ForceCurves,
    contact_force,
    drawing_angles,
    force_curves,
)
from core.output.mechanism import Mechanism
from core.output.pin_forces import (
    force_ratios,
    output_torque_from_input,
    reference_force,
)

ForceSection = Literal["curves", "equal_sharing", "approximation"]

MAX_SAMPLES = 10_001

FORCE_DIGITS = 12
"""Digits of the largest force of curves: fewer bytes, and still finer than any use."""

MAX_CURVE_VALUES = 1_000_000


class LoadFields(RequestModel):
    """Torque, lever and load sharing of the pins, and what is asked of the force."""

    output_torque_Nm: float | None = quantity(
        "Output torque",
        symbol="T",
        group="load",
        default=None,
        **SIZE,
        step=10,
        help="Torque on the output link.",
    )
    input_torque_Nm: float | None = quantity(
        "Input torque",
        symbol="T₁",
        group="load",
        default=None,
        **SIZE,
        step=1,
        help="Torque on the crankshaft; T = T₁·u·η.",
    )
    efficiency: float | None = quantity(
        "Efficiency",
        symbol="η",
        group="load",
        default=None,
        ge=1e-3,
        le=1,
        step=0.01,
        help="Efficiency of the reducer, needed with the input torque.",
    )
    pin_circle_radius_mm: float = quantity(
        "Pin circle radius",
        symbol="R",
        group="load",
        **SIZE,
        step=1,
        help="Radius of the circle of pin centres.",
    )
    force_exponent: float = quantity(
        "Force exponent",
        symbol="v",
        group="load",
        default=1.0,
        ge=0,
        le=1e6,
        step=0.1,
        help="Force ∝ approach^v: 0 equal sharing, 1 linear, 10/9 and 3/2 the usual contact laws.",
    )
    include: list[ForceSection] = Field(
        default=[], max_length=3, description="Optional results: what is not named is not computed."
    )
    samples: int = quantity(
        "Samples",
        symbol="",
        group="load",
        default=361,
        ge=2,
        le=MAX_SAMPLES,
        step=1,
        advanced=True,
        help="Number of crank angles of the curves over one turn.",
    )

    @model_validator(mode="after")
    def _one_torque(self) -> Self:
        if self.output_torque_Nm is not None:
            for name in ("input_torque_Nm", "efficiency"):
                if getattr(self, name) is not None:
                    raise field_error(
                        name, "give either output_torque_Nm or input_torque_Nm and efficiency"
                    )
        elif self.input_torque_Nm is None:
            raise field_error(
                "output_torque_Nm",
                "is needed: output_torque_Nm, or input_torque_Nm and efficiency",
            )
        elif self.efficiency is None:
            raise field_error("efficiency", "is needed with input_torque_Nm")
        return self

    def torque(self, mechanism: Mechanism) -> float:
        """Torque on the output link, N*m."""
        if self.output_torque_Nm is not None:
            return self.output_torque_Nm
        assert self.input_torque_Nm is not None and self.efficiency is not None
        return output_torque_from_input(
            input_torque=self.input_torque_Nm,
            ratio=mechanism.ratio,
            efficiency=self.efficiency,
        )

    def cost_of(self, fields: MechanismFields, *, drawn: bool) -> float:
        """About what the force costs for a mechanism, milliseconds.

        Evenly spaced pairs have closed forms or a few driving sets; otherwise there are about 3*K
        of them, with K phases each, searched where the exponent is neither 0 nor 1.
        """
        pairs, satellites = fields.pairs, fields.satellites
        searched = self.force_exponent not in (0.0, 1.0)
        if fields.crank_angles_deg is None and fields.crank_spacing_deg is None:
            cost = 0.002 * pairs + (2.0 if searched else 0.0)
        else:
            cost = satellites * (0.05 + 0.01 * satellites)
            if searched:
                cost += 1.0 + satellites * (0.2 + 1.2e-3 * pairs)
        if "curves" in self.include:
            cost += 3e-4 * pairs * self.samples
        return cost + (0.5 * pairs if drawn else 0.0)

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more samples than the operator allows.

        Raises
        ------
        InvalidInput
            If there are.
        """
        if self.samples > settings.max_curve_samples:
            limit = settings.max_curve_samples
            raise InvalidInput(
                "samples", self.samples, f"must be at most {limit}: this service takes no more"
            )
        super().refuse_beyond(settings)

    def solve_for(self, mechanism: Mechanism) -> ContactForce:
        """Contact force of a mechanism under this load; what is not included is not computed."""
        curves = "curves" in self.include
        pairs = mechanism.pins * mechanism.satellites
        if curves and self.samples * pairs > MAX_CURVE_VALUES:
            raise InvalidInput(
                "samples",
                self.samples,
                f"must be at most {MAX_CURVE_VALUES // pairs} for {pairs} pairs",
            )
        return contact_force(
            mechanism=mechanism,
            output_torque=self.torque(mechanism),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
            force_exponent=self.force_exponent,
            curve_samples=self.samples if curves else None,
            equal_sharing="equal_sharing" in self.include,
            approximation="approximation" in self.include,
        )

    def forces_at(self, mechanism: Mechanism, crank_angle: float) -> FloatArray:
        """Force of every pair, N, shape (K, N), at a crank angle, rad."""
        reference = reference_force(
            output_torque=self.torque(mechanism),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
        )
        ratios = force_ratios(
            mechanism=mechanism,
            crank_angles=np.array([crank_angle]),
            force_exponent=self.force_exponent,
        )
        forces: FloatArray = reference * ratios[0]
        return forces

    def solve_for_drawing(self, mechanism: Mechanism) -> tuple[ContactForce, FloatArray]:
        """Contact force with curves fit to be drawn, and the switching angles, rad."""
        angles, switching = drawing_angles(mechanism=mechanism)
        force = self.model_copy(update={"include": []}).solve_for(mechanism)
        curves = force_curves(
            mechanism=mechanism,
            crank_angle=angles,
            reference=force.reference_force,
            force_exponent=self.force_exponent,
        )
        return replace(force, curves=curves), switching


class ContactForceRequest(MechanismFields, LoadFields):
    """A mechanism and its load."""

    def cost_ms(self, *, drawn: bool) -> float:
        """What the force costs."""
        return self.cost_of(self, drawn=drawn)

    def solve(self) -> ContactForce:
        """Contact force of the mechanism under the load."""
        return self.solve_for(self.mechanism())


class PairOut(ResponseModel):
    """A pair of hole and pin by number."""

    satellite: int
    pin: int


class ForceCurvesOut(ResponseModel):
    """Force of every pair over the turn: one list for each pair, in the order of `pairs`, rounded
    to 12 digits of the largest force.
    """

    crank_angle_deg: list[float]
    force_N: list[list[float]]
    pairs: list[PairOut]

    @classmethod
    def values(cls, result: ForceCurves, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's curves."""
        forces = rounded(from_si("force_N", result.force), FORCE_DIGITS)
        return super().values(result, run_time_us, force_N=forces, **given)


class ContactForceResponse(ResponseModel):
    """The exact peak of the contact force, and what was asked besides."""

    reference_force_N: float
    peak_force_N: float
    peak_force_ratio: float
    peak_crank_angle_deg: float
    peak_pair: PairOut
    curves: ForceCurvesOut | None = None
    equal_sharing_peak_N: float | None = None
    approximate_peak_N: float | None = None
    approximate_peak_error: float | None = None
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None
