"""The ring as a request gives it: what presses the satellites along their cranks."""

from typing import Any, ClassVar, Self, get_args

from pydantic import ConfigDict, model_validator

from app.model import Forms, Maybe, RequestModel, Size, Whole, field_error, quantity, request_schema
from app.units import to_si
from core.checks.sections import Ring
from core.checks.sections import RingKind as Kind

NEEDED: dict[Kind | None, tuple[str, ...]] = {
    "involute": ("module_mm",),
    "cycloid": ("ring_pin_circle_radius_mm",),
    "none": (),
    None: (),
}
"""What each kind of ring needs; a ratio that is given needs nothing."""

OPTIONAL: dict[Kind | None, tuple[str, ...]] = {
    "involute": ("teeth_difference", "reference_pressure_angle_deg"),
    "cycloid": ("ring_pin_radius_mm",),
}
"""What it may have besides; the difference of teeth is that of the mechanism where this has teeth,
and needed where it has none.
"""

REFERENCE_ANGLE_DEG = 20.0


def _strange(kind: Kind | None) -> list[str]:
    """Fields of other kinds."""
    every = [name for names in (*NEEDED.values(), *OPTIONAL.values()) for name in names]
    own = (*NEEDED[kind], *OPTIONAL.get(kind, ()))
    return [name for name in every if name not in own]


def _ring_schema(schema: dict[str, Any], model: type[RequestModel]) -> None:
    """What each kind needs, and that it takes nothing of the others."""
    request_schema(schema, model)
    ratio = {"not": {"required": ["kind"]}}
    schema["allOf"] += [
        {
            "if": {"properties": {"kind": {"const": kind}}, "required": ["kind"]}
            if kind
            else ratio,
            "then": ({"required": [*needed]} if needed else {})
            | {"not": {"anyOf": [{"required": [name]} for name in _strange(kind)]}},
        }
        for kind, needed in NEEDED.items()
    ]


class RingFields(RequestModel, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces itself."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("kind",), ("radial_force_ratio",)),)

    kind: Maybe[Kind] = quantity("Ring")
    """Involute teeth, pins on which a cycloid disc rolls, or none: its force along the crank is
    left out."""
    module_mm: Maybe[Size] = quantity("Module", "m", step=0.5)
    """Of the teeth."""
    teeth_difference: Maybe[Whole] = quantity("Difference of teeth", "z₃ − z₂", ge=1, le=1000)
    """Teeth of the ring less those of a satellite; that of the mechanism's teeth where these are
    given."""
    reference_pressure_angle_deg: Maybe[float] = quantity(
        "Reference pressure angle", "α", step=0.5, ge=1, le=60
    )
    """Of the teeth; 20° where not given."""
    ring_pin_circle_radius_mm: Maybe[Size] = quantity("Circle of the ring's pins", "R_p", step=1)
    """Radius of the circle of the ring's pins, on which a cycloid disc rolls."""
    ring_pin_radius_mm: Maybe[Size] = quantity("Radius of the ring's pins", "r_p", step=0.5)
    """With it the roots of a cycloid disc are known, which the holes must not reach."""
    radial_force_ratio: Maybe[float] = quantity(
        "Ratio of the ring's forces", "ρ", step=0.05, ge=-100, le=100
    )
    """Force along the crank over that across it: positive towards the reducer's axis, as with
    involute teeth, negative outwards, as with a ring of pins."""

    model_config = ConfigDict(json_schema_extra=_ring_schema)

    @model_validator(mode="after")
    def _fields_of_the_kind(self) -> Self:
        for name in NEEDED[self.kind]:
            if getattr(self, name) is None:
                raise field_error(name, "needed_beside", field="kind")
        for name in _strange(self.kind):
            if getattr(self, name) is not None:
                raise field_error(name, "of_another_kind", kind=self.kind or get_args(Kind)[-1])
        return self

    def refuse_other_teeth(self, difference: int | None) -> None:
        """Refuse involute teeth without a difference, or with another than the mechanism's.

        Raises
        ------
        PydanticCustomError
            If they are.
        """
        if self.kind != "involute":
            return
        given, name = self.teeth_difference, "gear/teeth_difference"
        if difference is None and given is None:
            raise field_error(name, "needed_beside", field="ratio")
        # a ring without more teeth than its satellites is refused by itself
        if given and difference and difference > 0 and given != difference:
            raise field_error(name, "teeth_disagree", expected=difference)

    def ring(self, difference: int | None) -> Ring:
        """The ring in SI units.

        Parameters
        ----------
        difference : int or None
            Of the mechanism's teeth, where it has them.

        Returns
        -------
        Ring
        """
        own = self.to_core()
        if difference is not None:
            own["teeth_difference"] = difference
        if self.kind == "involute":
            own.setdefault("reference_pressure_angle", to_si("angle_deg", REFERENCE_ANGLE_DEG))
        return Ring(**own)
