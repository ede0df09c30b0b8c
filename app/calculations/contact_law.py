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
    """Hertz: line contact with its logarithm; conformal: the hole wraps around the pin, its
    approach counted to three hole radii; Palmgren: rollers of steel; linear; power. Where not
    given, conformal with a body below 20 GPa, else Hertz."""
    reference_depth_mm: Maybe[Size] = quantity("Reference depth", "t", step=1, advanced=True)
    """Depth to which Hertz counts the approach of the hole; the hole's radius where not given."""
    stiffness_N_per_mm: Maybe[Size] = quantity("Contact stiffness", "k", step=1000)
    """Stiffness of a pair, for the linear law."""
    exponent: Maybe[float] = quantity("Exponent", "n", step=0.1, ge=MIN_EXPONENT, le=MAX_EXPONENT)
    """Force ∝ approachⁿ, for the power law."""
    reference_force_N: Maybe[Size] = quantity("Reference force", "F_ref", step=100)
    """A force whose approach is known, for the power law."""
    reference_approach_mm: Maybe[Size] = quantity("Reference approach", "δ_ref", step=0.001)
    """The approach under the reference force."""

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
    """Hertz: line contact with its logarithm; Palmgren: rollers of steel; linear; power. Where not
    given, Hertz."""
    reference_depth_mm: Maybe[Size] = quantity("Reference depth", "t", step=1, advanced=True)
    """Depth to which Hertz counts the approach of pin and disc; the pin's radius where not
    given."""

    def section(self) -> ContactLaw | None:
        """Law in SI units; None if no law is named."""
        return self.named()


assert {*get_args(Kind), None} == {*LawFields.KINDS}
