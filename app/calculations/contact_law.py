"""Contact laws of a request: of pins in holes, and of disc teeth on ring pins."""

from typing import Any, ClassVar, Literal, get_args

from app.calculations.hertz import material_of
from app.model import Maybe, PartFields, RequestModel, Size, quantity
from app.rules import Kinds
from core.output.elasticity import (
    MAX_EXPONENT,
    MIN_EXPONENT,
    ConformalLaw,
    ContactLaw,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PowerLaw,
    usual_law,
)

Kind = Literal["hertz", "conformal", "palmgren", "linear", "power"]


class LawFields(RequestModel, group="contact_law"):
    """Elastic law of a pair of bodies, by its name."""

    KINDS: ClassVar[Kinds] = {
        None: ((), ("reference_depth_mm",)),
        "hertz": ((), ("reference_depth_mm",)),
        "conformal": ((), ()),
        "palmgren": ((), ()),
        "linear": (("stiffness_N_per_mm",), ()),
        "power": (("exponent", "reference_force_N", "reference_approach_mm"), ()),
    }

    kind: Maybe[Kind] = quantity("Law of contact")
    """Hertz: line contact with a logarithmic approach; conformal: the hole wraps around the pin,
    and its approach is counted to a depth of three hole radii; Palmgren: steel rollers; linear;
    power. The default is conformal if a body is softer than 20 GPa, else Hertz."""
    reference_depth_mm: Maybe[Size] = quantity("Reference depth", "t", step=1, advanced=True)
    """Depth to which the Hertz law counts the approach of the hole; the hole's radius if not
    given."""
    stiffness_N_per_mm: Maybe[Size] = quantity("Contact stiffness", "k", step=1000)
    """Stiffness of a pair of pin and hole, for the linear law."""
    exponent: Maybe[float] = quantity("Exponent", "n", step=0.1, ge=MIN_EXPONENT, le=MAX_EXPONENT)
    """Exponent n of the power law, force ∝ approachⁿ."""
    reference_force_N: Maybe[Size] = quantity("Reference force", "F_ref", step=100)
    """Force at which the approach of a pair is known, for the power law."""
    reference_approach_mm: Maybe[Size] = quantity("Reference approach", "δ_ref", step=0.001)
    """Approach of a pair under the reference force, for the power law."""

    def named(self) -> ContactLaw | None:
        """Law in SI units; None if no law is named."""
        own = self.to_core()
        if not own:
            return None
        kinds = {
            "hertz": HertzLaw,
            "conformal": ConformalLaw,
            "palmgren": PalmgrenLaw,
            "linear": LinearLaw,
            "power": PowerLaw,
        }
        return kinds[own.pop("kind", "hertz")](**own)  # type: ignore[no-any-return]


class ContactLawFields(LawFields, group="contact_law"):
    """Elastic law of a pair of pin and hole.

    If it is not given, the conformal law holds with a body below 20 GPa, else Hertz's law.
    """

    def section(self, body: Any) -> ContactLaw:
        """Law in SI units; by the materials of the contact if no law is named."""
        return self.named() or law_by_materials(body.contact)


def law_by_materials(contact: Any) -> ContactLaw:
    """Contact law by the materials; any law without a contact, which is refused later."""
    if not contact:
        return HertzLaw()
    pin, hole = material_of(contact.pin_material), material_of(contact.hole_material)
    return usual_law(pin=pin, hole=hole)


class MeshLawFields(LawFields, PartFields, group="contact_law"):
    """Elastic law of a pair of tooth and ring pin; teeth do not wrap around the pins.

    If it is not given, Hertz's law holds.
    """

    KINDS: ClassVar[Kinds] = {
        kind: rules for kind, rules in LawFields.KINDS.items() if kind != "conformal"
    }

    kind: Maybe[Literal["hertz", "palmgren", "linear", "power"]] = quantity("Law of contact")
    """Hertz: line contact with a logarithmic approach; Palmgren: steel rollers; linear; power. The
    default is Hertz."""
    reference_depth_mm: Maybe[Size] = quantity("Reference depth", "t", step=1, advanced=True)
    """Depth to which the Hertz law counts the approach of pin and disc; the pin's radius if not
    given."""

    def section(self) -> ContactLaw | None:
        """Law in SI units; None if no law is named."""
        return self.named()


assert {*get_args(Kind), None} == {*LawFields.KINDS}
