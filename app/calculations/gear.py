"""Mesh of a precessional gear in a request: geometry and rollers."""

import math
from collections.abc import Sequence
from functools import partial
from typing import Annotated, ClassVar

from pydantic import Field, field_validator

from app.model import Angle, Maybe, RequestModel, Size, Whole, no_dust, quantity
from app.rules import Forms
from app.units import to_si
from core.errors import InvalidInput
from core.precession.rollers import Roller, RollerByAngle, RollerByLength, wheel_rollers

MAX_ROLLERS = 500
"""Largest number of rollers of a wheel."""

Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]

_position = partial(
    quantity,
    "Position angle",
    "φ₁",
    help="Angular position of the roller on the central wheel, or of the first roller of a wheel.",
)
_from = partial(
    quantity,
    "Working length from",
    "z_min",
    step=1,
    help="Start of the working length, along the axis from the precession centre.",
)
_to = partial(quantity, "Working length to", "z_max", step=1, help="End of the working length.")
"""Fields that a roller and a wheel both have."""


class RollerFields(RequestModel, group="rollers"):
    """One roller: its place on the wheel and the limits of its contact line."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("z_min_mm", "z_max_mm"), ("phi_min_deg", "phi_max_deg")),
    )

    position_angle_deg: Angle = _position(step=15)
    z_min_mm: Maybe[Coordinate] = _from()
    z_max_mm: Maybe[Coordinate] = _to()
    phi_min_deg: Maybe[Angle] = quantity("Contact from", "φ_min", step=1)
    """Polar angle on the roller at which contact starts, instead of a working length."""
    phi_max_deg: Maybe[Angle] = quantity("Contact to", "φ_max", step=1)
    """Polar angle on the roller at which contact ends."""

    _sizes = field_validator("z_min_mm", "z_max_mm")(no_dust)

    def roller(self) -> Roller:
        """The roller in SI units."""
        if self.z_min_mm is not None:
            return RollerByLength(**self.to_core())
        return RollerByAngle(**self.to_core())


class WheelFields(RequestModel, group="rollers"):
    """Evenly spaced rollers with one working length."""

    rollers_total: Whole = quantity("Rollers of the wheel", "z₁", step=1, ge=1, le=MAX_ROLLERS)
    """Number of rollers of the central wheel."""
    rollers_in_mesh: Maybe[Whole] = quantity("Rollers in mesh", step=1, ge=1, le=MAX_ROLLERS)
    """Number of rollers that touch the satellite, counted from the first; all if not given."""
    position_angle_deg: Angle = _position(step=5)
    z_min_mm: Coordinate = _from()
    z_max_mm: Coordinate = _to()

    _sizes = field_validator("z_min_mm", "z_max_mm")(no_dust)


ROLLER_POINTS = 400
"""Number of points of a roller, with the nodes of its contact line."""


class GearFields(RequestModel, group="gear"):
    """Geometry of the mesh and its rollers."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("rollers",), ("wheel",)),)

    roller_circle_radius_mm: Size = quantity("Roller circle radius", "R_C", step=1)
    """Radius of the circle of the roller axes."""
    roller_radius_mm: Size = quantity("Roller radius", "ρ", step=0.5)
    """Radius of a roller."""
    nutation_angle_deg: float = quantity("Nutation angle", "θ", step=0.5, ge=1e-9, lt=90)
    """Angle between the axes of the central wheel and the satellite."""
    ratio_u12: float = quantity("Ratio", "u₁₂", step=0.01, ge=-1e6, le=1e6)
    """Ratio of the mesh with the input shaft held."""
    rollers: Maybe[list[RollerFields]] = quantity(
        "Rollers", group="rollers", min_length=1, max_length=MAX_ROLLERS
    )
    """Rollers in mesh, listed one by one."""
    wheel: Maybe[WheelFields] = quantity("Wheel", group="rollers")
    """Evenly spaced rollers with one working length, instead of a list."""

    def gear(self) -> dict[str, float]:
        """Geometry in SI units, as the core's arguments."""
        return {
            "roller_circle_radius": to_si("radius_mm", self.roller_circle_radius_mm),
            "roller_radius": to_si("radius_mm", self.roller_radius_mm),
            "nutation_angle": to_si("angle_deg", self.nutation_angle_deg),
            "ratio_u12": self.ratio_u12,
        }

    def points(self, samples: int = 0) -> float:
        """Number of points of all contact lines: nodes, or requested points if more."""
        return float(len(self.positions()) * max(ROLLER_POINTS, samples))

    def cost(self) -> float:
        """Number of points of the contact lines."""
        return self.points()

    def all_rollers(self) -> Sequence[Roller]:
        """The rollers in SI units."""
        match self.given:
            case {"wheel": wheel}:
                return wheel_rollers(**{"rollers_in_mesh": wheel.rollers_total} | wheel.to_core())
            case given:
                return [each.roller() for each in given["rollers"]]

    @property
    def by_angle(self) -> bool:
        """True if the first line is given by its polar angles."""
        return isinstance(self.all_rollers()[0], RollerByAngle)

    def positions(self) -> list[float]:
        """Position angles, rad, of all rollers of the wheel, in mesh or not; or those of a list."""
        match self.given:
            case {"wheel": wheel}:
                total = wheel.rollers_total
                return [2 * math.pi * index / total for index in range(total)]
            case given:
                return [to_si("angle_deg", each.position_angle_deg) for each in given["rollers"]]

    def about_the_wheel(self, error: InvalidInput) -> InvalidInput:
        """Refusal of one roller as a refusal of the wheel, if a wheel was given."""
        if self.wheel is not None and error.parameter.startswith("rollers["):
            name = error.parameter.rpartition(".")[2]
            return InvalidInput(name, error.value, error.code, **error.params)
        return error
