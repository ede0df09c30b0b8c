"""The mesh of a precessional gear as a request gives it: geometry and rollers."""

import math
from collections.abc import Sequence
from functools import partial
from typing import Annotated, ClassVar

from pydantic import Field, field_validator

from app.model import SIZE, Forms, Maybe, RequestModel, Whole, no_dust, quantity
from app.units import to_si
from core.errors import InvalidInput
from core.precession.rollers import Roller, RollerByAngle, RollerByLength, wheel_rollers

MAX_ROLLERS = 500
"""Most rollers of one wheel."""

Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]

_position = partial(
    quantity,
    "Position angle",
    symbol="φ₁",
    group="rollers",
    ge=-3600,
    le=3600,
    help="Position of the roller on the central wheel; of a wheel's first.",
)
_from = partial(
    quantity,
    "Working length from",
    symbol="z_min",
    group="rollers",
    step=1,
    help="Start of the working length, along the axis from the precession centre.",
)
_to = partial(
    quantity,
    "Working length to",
    symbol="z_max",
    group="rollers",
    step=1,
    help="End of the working length.",
)
"""Fields that a roller and a wheel both have."""


class RollerFields(RequestModel):
    """One roller: its place on the wheel and the limits of its contact line."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("z_min_mm", "z_max_mm"), ("phi_min_deg", "phi_max_deg")),
    )

    position_angle_deg: float = _position(step=15)
    z_min_mm: Maybe[Coordinate] = _from(default=None)
    z_max_mm: Maybe[Coordinate] = _to(default=None)
    phi_min_deg: Maybe[float] = quantity(
        "Contact from",
        symbol="φ_min",
        group="rollers",
        default=None,
        ge=-3600,
        le=3600,
        step=1,
        help="Polar angle on the roller at which contact starts, instead of a working length.",
    )
    phi_max_deg: Maybe[float] = quantity(
        "Contact to",
        symbol="φ_max",
        group="rollers",
        default=None,
        ge=-3600,
        le=3600,
        step=1,
        help="Polar angle on the roller at which contact ends.",
    )

    _sizes = field_validator("z_min_mm", "z_max_mm")(no_dust)

    def roller(self) -> Roller:
        """The roller in SI units."""
        if self.z_min_mm is not None:
            return RollerByLength(**self.to_core())
        return RollerByAngle(**self.to_core())


class WheelFields(RequestModel):
    """Evenly spaced rollers with one working length."""

    rollers_total: Whole = quantity(
        "Rollers of the wheel",
        symbol="z₁",
        group="rollers",
        ge=1,
        le=MAX_ROLLERS,
        step=1,
        help="Number of rollers of the central wheel.",
    )
    rollers_in_mesh: Maybe[Whole] = quantity(
        "Rollers in mesh",
        symbol="",
        group="rollers",
        default=None,
        ge=1,
        le=MAX_ROLLERS,
        step=1,
        help="How many of them touch the satellite, from the first on; all where not given.",
    )
    position_angle_deg: float = _position(step=5)
    z_min_mm: Coordinate = _from()
    z_max_mm: Coordinate = _to()

    _sizes = field_validator("z_min_mm", "z_max_mm")(no_dust)


ROLLER_POINTS = 400
"""Points of a roller, with the nodes of its contact line."""


class GearFields(RequestModel):
    """Geometry of the mesh and its rollers."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("rollers",), ("wheel",)),)

    roller_circle_radius_mm: float = quantity(
        "Roller circle radius",
        symbol="R_C",
        group="gear",
        **SIZE,
        step=1,
        help="Radius of the circle of the roller axes.",
    )
    roller_radius_mm: float = quantity(
        "Roller radius",
        symbol="ρ",
        group="gear",
        **SIZE,
        step=0.5,
        help="Radius of a roller.",
    )
    nutation_angle_deg: float = quantity(
        "Nutation angle",
        symbol="θ",
        group="gear",
        ge=1e-9,
        lt=90,
        step=0.5,
        help="Angle between the axes of the central wheel and the satellite.",
    )
    ratio_u12: float = quantity(
        "Ratio",
        symbol="u₁₂",
        group="gear",
        ge=-1e6,
        le=1e6,
        step=0.01,
        help="Ratio of the mesh with the input shaft held.",
    )
    rollers: Maybe[list[RollerFields]] = quantity(
        "Rollers",
        symbol="",
        group="rollers",
        default=None,
        min_length=1,
        max_length=MAX_ROLLERS,
        help="The rollers in mesh, one by one.",
    )
    wheel: Maybe[WheelFields] = quantity(
        "Wheel",
        symbol="",
        group="rollers",
        default=None,
        help="Evenly spaced rollers with one working length, instead of a list.",
    )

    def gear(self) -> dict[str, float]:
        """Geometry in SI units, as the core's arguments."""
        return {
            "roller_circle_radius": to_si("radius_mm", self.roller_circle_radius_mm),
            "roller_radius": to_si("radius_mm", self.roller_radius_mm),
            "nutation_angle": to_si("angle_deg", self.nutation_angle_deg),
            "ratio_u12": self.ratio_u12,
        }

    def points(self, samples: int = 0) -> float:
        """Points of all contact lines: nodes, or those that are asked if these are more."""
        count = self.wheel.rollers_total if self.wheel is not None else len(self.rollers or ())
        return float(count * max(ROLLER_POINTS, samples))

    def cost(self) -> float:
        """Points of the contact lines."""
        return self.points()

    def all_rollers(self) -> Sequence[Roller]:
        """The rollers in SI units."""
        if self.rollers is not None:
            return [each.roller() for each in self.rollers]
        assert self.wheel is not None
        return wheel_rollers(**self.wheel.to_core())

    def positions(self) -> list[float]:
        """Position angles, rad, of all rollers of the wheel, in mesh or not; those of a list."""
        if self.rollers is not None:
            return [to_si("angle_deg", each.position_angle_deg) for each in self.rollers]
        assert self.wheel is not None
        total = self.wheel.rollers_total
        return [2 * math.pi * index / total for index in range(total)]

    def about_the_wheel(self, error: InvalidInput) -> InvalidInput:
        """A refusal of one roller, as one of the wheel where a wheel was given."""
        if self.wheel is not None and error.parameter.startswith("rollers["):
            name = error.parameter.rpartition(".")[2]
            return InvalidInput(name, error.value, error.code, **error.params)
        return error
