"""Ring of a request: pins and discs of a cycloid, or other teeth that load the satellites."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

from app.fields import JSON_FORMS, JsonForm, SectionFields
from app.model import Maybe, Size, quantity
from core.design.ring import RINGS
from core.output.elasticity import LAWS, ContactLaw

OF_SUPPORTS = ("span_mm", "satellite_positions_mm")
"""Fields of ring pins that bend."""


class MeshLawFields(
    SectionFields,
    of={kind: law for kind, law in LAWS.items() if kind != "conformal"},
    group="contact_law",
):
    """Elastic law of a pair of tooth and ring pin; teeth do not wrap around the pins.

    If it is not given, Hertz's law holds.
    """

    kind: Maybe[Literal["hertz", "palmgren", "linear", "power"]] = quantity("Law of contact")
    """Hertz: line contact with a logarithmic approach; Palmgren: steel rollers; linear; power. The
    default is Hertz."""
    reference_depth_mm: Maybe[Size] = quantity("Reference depth", "t", step=1, advanced=True)
    """Depth to which the Hertz law counts the approach of pin and disc; the pin's radius if not
    given."""

    def section(self) -> ContactLaw | None:
        """Law in SI units; None if no law is named."""
        return super().section() if self.given else None


JSON_FORMS[ContactLaw] = JsonForm(MeshLawFields)


class RingFields(SectionFields, of=RINGS, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {
                "properties": {"pin_support": {"enum": ["supported", "fixed"]}},
                "required": ["pin_support"],
            },
            "then": {"required": [*OF_SUPPORTS]},
            "else": {"not": {"anyOf": [{"required": [name]} for name in OF_SUPPORTS]}},
        },
    )

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of the ring if its mesh is judged."""
        if self.kind != "cycloid" or self.modification is not None:
            yield from super().assumed()
