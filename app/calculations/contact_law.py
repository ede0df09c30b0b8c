"""Contact laws of a request: of pins in holes, and of disc teeth on ring pins."""

from typing import Literal

from app.fields import JSON_FORMS, JsonForm, SectionFields
from app.model import Maybe, Size, quantity
from core.output.elasticity import (
    LAWS,
    ContactLaw,
)


class ContactLawFields(SectionFields, of=LAWS, group="contact_law"):
    """Elastic law of a pair of pin and hole.

    If it is not given, the conformal law holds with a body below 20 GPa, else Hertz's law.
    """


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
