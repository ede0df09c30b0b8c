"""The ring as a request gives it: what presses the satellites along their cranks."""

from typing import Any, ClassVar

from app.model import Forms, Kinds, Maybe, RequestModel, Size, Whole, field_error, quantity
from app.units import to_si
from core.design.sections import Ring
from core.design.sections import RingKind as Kind

REFERENCE_ANGLE_DEG = 20.0


class RingFields(RequestModel, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces itself."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("kind",), ("radial_force_ratio",)),)

    KINDS: ClassVar[Kinds] = {
        "involute": (("module_mm",), ("teeth_difference", "reference_pressure_angle_deg")),
        "cycloid": (("ring_pin_circle_radius_mm",), ("ring_pin_radius_mm",)),
        "none": ((), ()),
        None: ((), ()),
    }
    """The difference of teeth is that of the mechanism where this has teeth, and needed where it
    has none; a ratio that is given needs nothing."""

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

    def section(self, whole: Any) -> Ring:
        """The ring in SI units, with the difference of the mechanism's teeth where it has them."""
        own, difference = self.to_core(), whole.mechanism.teeth_difference
        if difference is not None:
            own["teeth_difference"] = difference
        if self.kind == "involute":
            own.setdefault("reference_pressure_angle", to_si("angle_deg", REFERENCE_ANGLE_DEG))
        return Ring(**own)
