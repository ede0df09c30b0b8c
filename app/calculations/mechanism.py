"""Parallel-crank mechanism of a request: pins, satellites and ratio; pin, hole and crank with their
clearance and the sizes that follow; and the fit of pins in holes.
"""

from collections.abc import Iterator
from typing import Any, ClassVar, Self

from pydantic import model_validator

from app.calculations.hertz import ContactFields, of_load_factor
from app.fields import SectionFields
from app.model import (
    Maybe,
    ResponseModel,
    Size,
    Values,
    quantity,
)
from app.rules import field_error
from app.settings import Settings
from app.units import from_si
from core.design.contact import Contact
from core.design.document import mechanism_of
from core.design.sections import MAX_PAIRS as MAX_PAIRS
from core.design.sections import MechanismSection
from core.design.stated import satellites_of
from core.errors import InvalidInput, Notice
from core.output.contact_force import PairNumber
from core.output.mechanism import MAX_SATELLITES as MAX_SATELLITES
from core.output.mechanism import Mechanism, Members
from core.output.room import Binding, Rooms

MAX_DRAWN_PAIRS = 240
"""Largest number of pairs in a figure."""


PAIR_POINTS = 240
"""Number of points of a pair whose forces are searched and integrated over the turn."""

STEEP = 1.25
"""Number of points for an exponent below 1 over that for 1, in calls: such forces rise steeply as a
pair begins to drive."""


class MechanismFields(SectionFields, of=MechanismSection, group="mechanism"):
    """Pins, satellites, cranks and ratio."""

    OF_OTHERS: ClassVar[tuple[str, str]] = ("of_other_output", "output")
    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {"properties": {"output": {"const": "coupling"}}, "required": ["output"]},
            "then": {"properties": {"satellites": {"maximum": 1}}},
            "else": {
                "anyOf": [
                    {"required": ["ratio"]},
                    {"required": ["output_ratio"]},
                    {"required": ["satellite_teeth", "ring_teeth"]},
                ]
            },
        },
    )

    ASSUMED: ClassVar[tuple[str, ...]] = ("satellites",)

    @model_validator(mode="before")
    @classmethod
    def _of_one_ratio(cls, data: Any) -> Any:
        """Refuse a ratio that contradicts the numbers of teeth."""
        match data:
            case {"ratio": ratio, "satellite_teeth": int(lobes), "ring_teeth": int(ring)}:
                if lobes < ring and ratio != lobes / (ring - lobes):
                    more = {"field": "satellite_teeth", "other": "ring_teeth"}
                    raise field_error("ratio", "other_ratio", given=lobes / (ring - lobes), **more)
        return data

    @model_validator(mode="after")
    def _counted(self) -> Self:
        follows = self.output == "coupling" or self.crank_angles_deg
        if follows and "satellites" not in self.model_fields_set:
            self.satellites = satellites_of(self.stated)
        return self

    @property
    def pairs(self) -> int:
        """Number of pin/hole pairs; 0 without pins."""
        pairs: int = (self.pins or 0) * self.satellites
        return pairs

    def points(self, *, exponent: float = 1.0, samples: int = 0, revolutions: float = 1.0) -> float:
        """Number of points over the turn: each satellite has a driving set, which meets those of
        all others. Exponents above 1 and curves with more samples need more points in proportion;
        exponents below 1 are steeper at the ends.
        """
        sharp = STEEP if 0 < exponent < 1 else max(1.0, exponent)
        of_each = max(PAIR_POINTS * sharp, samples) * max(1.0, revolutions)
        teeth: float = (self.ring_teeth or 1) / (self.satellite_teeth or 1)
        return float(of_each * self.pairs * self.satellites * teeth)

    def cyclogram_given(self) -> dict[str, Any]:
        """Mechanism as the worked steps of the cyclogram take it."""
        return {
            "mechanism": self.mechanism(),
            "teeth": self.teeth,
            "satellite_teeth": self.satellite_teeth,
        }

    def most_pins(self, pairs: int) -> dict[str, int]:
        """Largest number of pins that a limit of pairs allows, for a refusal."""
        return {"limit": pairs // self.satellites, "satellites": self.satellites}

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs than the operator allows."""
        if self.pairs > settings.max_pairs:
            raise InvalidInput(
                "pins", self.pins, "too_many_pairs", **self.most_pins(settings.max_pairs)
            )
        super().refuse_beyond(settings)

    def refuse_undrawable(self) -> None:
        """Refuse a figure of more than `MAX_DRAWN_PAIRS` pairs."""
        if self.pairs > MAX_DRAWN_PAIRS:
            raise InvalidInput(
                "pins", self.pins, "too_many_pairs", **self.most_pins(MAX_DRAWN_PAIRS)
            )

    @property
    def teeth(self) -> tuple[int, int] | None:
        """Teeth of a satellite and of the ring, if they are given."""
        match self.given:
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return satellite, ring
        return None

    def notices(self) -> tuple[Notice, ...]:
        """Notice of a ratio with the sign of the output."""
        signed = (self.ratio or 0) < 0
        return (Notice("ratio_sign", {"ratio": self.made.ratio}),) if signed else ()

    def mechanism(self) -> Mechanism:
        """The mechanism in SI units."""
        return mechanism_of(self.made)

    @property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return Members(self.made.output, self.made.ratio)


class PairOut(ResponseModel, of=PairNumber):
    """Pair of hole and pin by number."""


class PinContactFields(ContactFields, of=Contact, group="contact"):
    """Crank, pin, hole and clearance. Any two of hole radius, eccentricity and clearance determine
    the third; a crank alone has an eccentricity.
    """

    dynamic_factor: Maybe[Size] = quantity(
        "Application factor", "K_A", step=0.05, schema={"deprecated": True}
    )
    """Older place of `load.application_factor`, as which it is read."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed materials of pins and holes, and the eccentricity of a hole alone."""
        if self.pin_radius_mm is None:
            return
        yield from super().assumed()
        if self.eccentricity_mm is None:
            own: Contact = self.made
            gap = (own.hole_radius or 0.0) - (own.pin_radius or 0.0)
            yield ("eccentricity_mm",), round(from_si("eccentricity_mm", gap), 9)

    @property
    def clearance_unknown(self) -> bool:
        """True if pin and eccentricity are given, but the clearance is not known."""
        contact: Contact = self.made
        return contact.clearance_unknown

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of a factor below 1, and of parts without clearance, taken as perfect, or
        with an unknown one.
        """
        found = super().notices() + of_load_factor(self.dynamic_factor)
        if self.made.clearance != 0:
            return found
        return (*found, Notice("clearance_unknown" if self.clearance_unknown else "perfect_parts"))


class BindingOut(PairOut, of=Binding):
    """Pair that limits the room."""


class FitOut(ResponseModel, of=Rooms):
    """Fit of pins in their holes by geometry, before any force."""

    blocked_crank_deg: Maybe[list[list[float]]]

    @classmethod
    def values(cls, result: Rooms, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a fit."""
        if result.state in ("fits", "no_bound"):
            given["needed_hole_radius_mm"] = None
        return super().values(result, run_time_us, **given)
