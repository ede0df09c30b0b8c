"""Tolerances of the parts, as a request states them."""

from functools import partial
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from app.fields import JSON_FORMS, LIMITED, JsonForm, SectionFields, model_of
from app.model import UNION_TAGS, RequestModel
from app.units import from_si, to_si
from core.design.tolerances import (
    Diameter,
    HoleDiameter,
    LengthSpread,
    PhaseSpread,
    PinDiameter,
    ToleranceSection,
    ToolSpread,
)
from core.fields import LARGEST
from core.tolerance.draws import Spread


def _form(given: Any) -> Literal["plus_minus", "limits"]:
    return "limits" if isinstance(given, (dict, RequestModel)) else "plus_minus"


def _spread(unit: str, given: Any) -> Spread:
    """Limits of a deviation, given as such or as a value for plus or minus."""
    if isinstance(given, SectionFields):
        limits: Spread = given.section()
        return limits
    size = to_si(unit, given)
    return Spread(-size, size)


for _kind, _unit, _most in (
    (ToolSpread, "size_mm", LARGEST),
    (LengthSpread, "size_mm", LARGEST),
    (PhaseSpread, "angle_deg", 360),
):
    _size = Annotated[float, Field(ge=0, le=_most), Tag("plus_minus")]
    _limits = LIMITED[model_of(_kind, "tolerances"), Tag("limits")]
    JSON_FORMS[_kind] = JsonForm(
        LIMITED[_size | _limits, Discriminator(_form)], partial(_spread, _unit)
    )

UNION_TAGS.update(("plus_minus", "limits"))


class PinDiameterFields(SectionFields, of=PinDiameter, group="pin_diameter"):
    """Class or limits of the pins' diameter."""


class HoleDiameterFields(SectionFields, of=HoleDiameter, group="hole_diameter"):
    """Class or limits of the holes' diameter."""


class TolerancesFields(SectionFields, of=ToleranceSection, group="tolerances"):
    """Tolerances of the parts; parts that are not named are exact. Each part of a piece has a
    deviation of its own.
    """


def as_given(quantity: str, value: Any) -> tuple[str, Any]:
    """Name and value of a tolerance of core, as a request states them."""
    if not isinstance(value, Diameter):
        name = f"{quantity}_mm"
        return name, from_si(name, value)
    if value.tolerance_class is not None:
        return quantity, {"class": value.tolerance_class}
    ends = {"lower_mm": value.lower, "upper_mm": value.upper}
    return quantity, {name: from_si(name, end) for name, end in ends.items()}
