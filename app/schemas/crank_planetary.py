"""Request and answer of the crank-planetary reducer as one job."""

from functools import cached_property
from typing import Any, Literal, Self

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
from app.schemas.contact_force import ContactForceResponse, LoadFields
from app.schemas.cyclogram import CyclogramRequest, CyclogramResponse
from app.schemas.hertz import ContactFields, HertzResponse
from app.schemas.mechanism import Angle
from app.settings import Settings
from app.units import from_si, to_si
from core.arrays import FloatArray
from core.hertz import HertzContact
from core.output.contact_force import ContactForce
from core.output.mechanism import Mechanism
from core.output.pin_geometry import PinFit, PinGeometry, pin_fit, pin_geometry

Section = Literal["cyclogram", "contact_force", "hertz", "geometry"]

_NEEDS: dict[Section, tuple[str, ...]] = {
    "cyclogram": (),
    "contact_force": ("load",),
    "hertz": ("load", "contact"),
    "geometry": ("load", "contact"),
}
"""Which parts of the request each section of the answer needs."""


class PinContactFields(ContactFields):
    """Pin, hole and crank."""

    eccentricity_mm: float | None = quantity(
        "Eccentricity",
        symbol="e",
        group="contact",
        default=None,
        **SIZE,
        step=0.5,
        help="Eccentricity of the cranks; hole radius − pin radius where not given.",
    )

    def sizes(self, pin_circle_radius_mm: float | None) -> dict[str, Any]:
        """Sizes of pins and holes on their circle in SI units, None for what is not given."""
        return {
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "hole_radius": to_si("hole_radius_mm", self.hole_radius_mm),
            "eccentricity": to_si("eccentricity_mm", self.eccentricity_mm),
            "pin_circle_radius": to_si("pin_circle_radius_mm", pin_circle_radius_mm),
        }


class CrankPlanetaryRequest(RequestModel):
    """Mechanism, load and contact, and which sections of the answer are wanted."""

    mechanism: CyclogramRequest
    load: LoadFields | None = None
    contact: PinContactFields | None = None
    crank_angle_deg: Angle = quantity(
        "Crank angle",
        symbol="φ",
        group="mechanism",
        default=0.0,
        step=5,
        advanced=True,
        help="Crank angle of the section geometry.",
    )
    include: list[Section] = Field(
        default=["cyclogram", "contact_force", "hertz"],
        min_length=1,
        max_length=4,
        description="Sections of the answer: what is not named is not computed.",
    )

    @model_validator(mode="after")
    def _parts_for_sections(self) -> Self:
        for section in self.include:
            for part in _NEEDS[section]:
                if getattr(self, part) is None:
                    raise field_error(part, f"is needed for the section {section}")
        return self

    def cost_ms(self, *, drawn: bool) -> float:
        """What the sections that are asked cost."""
        cost = 0.0
        if drawn or "cyclogram" in self.include:
            cost += self.mechanism.cost_ms(drawn=drawn)
        if self.load is not None and (drawn or {"contact_force", "hertz"} & {*self.include}):
            cost += self.load.cost_of(self.mechanism, drawn=drawn)
        if "geometry" in self.include:
            cost += 0.02 * self.mechanism.pairs
        return cost

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits in mechanism or load."""
        self.mechanism.refuse_beyond(settings)
        if self.load is not None:
            self.load.refuse_beyond(settings)

    @cached_property
    def built(self) -> Mechanism:
        """The mechanism, built once for all sections."""
        return self.mechanism.mechanism()

    def solve_force(self) -> ContactForce:
        """Contact force; without its own section only what the others need of it."""
        assert self.load is not None
        load = self.load
        if "contact_force" not in self.include:
            load = load.model_copy(update={"include": []})
        return load.solve_for(self.built)

    def solve_hertz(self, force: ContactForce) -> HertzContact:
        """Contact under the peak force."""
        assert self.contact is not None
        return self.contact.solve_for(force.peak_force)

    def solve_fit(self) -> PinFit | None:
        """How pins and holes fit, as far as their sizes are given."""
        if self.contact is None:
            return None
        radius = None if self.load is None else self.load.pin_circle_radius_mm
        return pin_fit(pins=self.mechanism.pins, **self.contact.sizes(radius))

    def solve_geometry(self) -> tuple[PinGeometry, FloatArray]:
        """Pins and holes at the crank angle, and the force of each pair there, N."""
        assert self.load is not None and self.contact is not None
        crank_angle = to_si("crank_angle_deg", self.crank_angle_deg)
        forces = self.load.forces_at(self.built, crank_angle)
        sizes = self.contact.sizes(self.load.pin_circle_radius_mm)
        sizes["eccentricity"] = pin_fit(pins=self.mechanism.pins, **sizes).eccentricity
        geometry = pin_geometry(mechanism=self.built, crank_angle=crank_angle, **sizes)
        return geometry, forces


class PointOut(ResponseModel):
    """A pin with its centre."""

    pin: int
    centre_mm: tuple[float, float]


class PairGeometryOut(ResponseModel):
    """Hole, contact point and pressure angle of one pair."""

    satellite: int
    pin: int
    hole_centre_mm: tuple[float, float]
    contact_point_mm: tuple[float, float]
    pressure_angle_deg: float
    driving: bool
    force_N: float


class GeometryOut(ResponseModel):
    """Pins and holes at a crank angle (Y up through pin 1 at crank angle 0, X right)."""

    clearance_mm: float
    pins: list[PointOut]
    pairs: list[PairGeometryOut]
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None

    @classmethod
    def values(
        cls,
        result: tuple[PinGeometry, FloatArray],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the geometry and the forces of the pairs, N, satellite by satellite."""
        geometry, forces = result
        satellites, pins = geometry.driving.shape
        force = from_si("force_N", forces).tolist()
        centres = from_si("centre_mm", geometry.pin_centres).tolist()
        holes = from_si("hole_centre_mm", geometry.hole_centres).tolist()
        contacts = from_si("contact_point_mm", geometry.contact_points).tolist()
        angles = from_si("pressure_angle_deg", geometry.pressure_angles).tolist()
        driving = geometry.driving.tolist()
        return super().values(
            geometry,
            run_time_us,
            pins=[{"pin": n + 1, "centre_mm": centres[n]} for n in range(pins)],
            pairs=[
                {
                    "satellite": j + 1,
                    "pin": n + 1,
                    "hole_centre_mm": holes[j][n],
                    "contact_point_mm": contacts[j][n],
                    "pressure_angle_deg": angles[j][n],
                    "driving": driving[j][n],
                    "force_N": force[j][n],
                }
                for j in range(satellites)
                for n in range(pins)
            ],
            **given,
        )


class CrankPlanetaryResponse(ResponseModel):
    """One section for each that was asked."""

    cyclogram: CyclogramResponse | None = None
    contact_force: ContactForceResponse | None = None
    hertz: HertzResponse | None = None
    geometry: GeometryOut | None = None
    warnings: list[WarningOut] | None = Field(
        default=None,
        description="How pins and holes fit, whichever sections are asked: `interference`, "
        "`holes_overlap`, `pins_overlap` (such a mechanism is not possible), `clearance`, "
        "`eccentricity_assumed`.",
    )
