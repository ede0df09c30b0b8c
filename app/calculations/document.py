"""Design document of a drive: the request that all calculations of a drive share, with what each of
them needs of it.
"""

import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, partial
from itertools import chain
from typing import Any, ClassVar, Literal, Self, TypeVar, cast

from pydantic import Field, model_validator

from app.calculations.checks import ScopedRequirementsFields
from app.calculations.fatigue import PinFatigueFields
from app.calculations.ideal_forces import CyclogramFields, force_of_one
from app.calculations.mechanism import PinContactFields
from app.calculations.pin import PinFields
from app.calculations.ring import RingFields
from app.calculations.sections import DesignLoadFields
from app.calculations.tolerances import TolerancesFields
from app.fields import SectionedFields
from app.model import Maybe, RequestModel, Values, notices_of, result
from app.rules import field_error
from app.settings import Settings
from app.units import from_si
from core.arrays import FloatArray
from core.design.document import KINDS, Design
from core.design.results import Results
from core.design.stated import design_of
from core.errors import CalculationError, Notice, if_known, is_known, within
from core.output.contact_force import drawing_angles
from core.output.mechanism import Members

Result = TypeVar("Result")

Needs = tuple[str, ...]
"""Paths of sections and fields of a document in JSON, such as ``load/input_speed_rpm``."""

PLACES: Needs = ("crankshaft/satellite_positions_mm", "crankshaft/bearing_positions_mm")
"""Places that a crankshaft needs."""

INSTEAD = {
    "friction": "rollers",
    "load/output_torque_Nm": "load/input_torque_Nm",
    **dict.fromkeys(("pin/satellite_positions_mm", *PLACES), "build"),
}
"""Parts of a document that stand for others: rollers have friction."""

TOUCHING: Needs = ("contact/pin_radius_mm", "contact/contact_length_mm")
"""Sizes of pins that touch their holes."""

FORCES = frozenset(
    (
        "mechanism",
        "load",
        "contact",
        "contact_law",
        "deviations",
        "crank_support",
        "satellite_coupling",
        "pin",
        "rollers",
        "gear",
        "build",
    )
)
"""Sections on which forces on pins and ring depend."""

TORQUE: Needs = ("load/output_torque_Nm", "load/pin_circle_radius_mm")
"""Torque and its lever."""

LOADED: Needs = ("mechanism/pins", *TORQUE)
"""Pins under a torque."""

TURNING: Needs = (*LOADED, "load/input_speed_rpm", "contact/eccentricity_mm")
"""Pins under a torque, with the motion of the crank."""

PIN_SECTIONS = ("contact_law", "deviations", "pin", "crank_support", "satellite_coupling")
"""Sections that concern pins and holes."""

ForcesUsed = Literal["ideal", "real"]


class DocumentFields(SectionedFields, sections=KINDS):
    """Crank-planetary reducer, as far as it is given.

    One document serves all calculations of a drive: each names the fields that it needs, and
    `not_used` lists the given sections that it does not use. Both meshes are solved in series for
    cycloid discs of known modification with a known clearance of the pins, unless
    `satellite_coupling` says otherwise.
    """

    NEEDED_OF: ClassVar[dict[str, Needs]] = {}
    """Fields that the calculation needs of sections that are given."""

    PIN_ALONE: ClassVar[bool] = False
    """True if the calculation takes a pin that no contact loads."""

    USES: ClassVar[frozenset[str]] = frozenset()
    """Sections that the calculation uses."""

    mechanism: CyclogramFields
    load: Maybe[DesignLoadFields] = None
    contact: Maybe[PinContactFields] = None
    pin: Maybe[PinFields] = None
    fatigue: Maybe[PinFatigueFields] = None
    gear: Maybe[RingFields] = None
    tolerances: Maybe[TolerancesFields] = None
    requirements: ScopedRequirementsFields = Field(default_factory=ScopedRequirementsFields)

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> Self:
        for part in self.needs():
            if not self.has(part):
                raise field_error(part, "missing")
        return self

    @model_validator(mode="after")
    def _one_application_factor(self) -> Self:
        given = self.load.application_factor if self.load else None
        if None not in (given, self.older_factor) and given != self.older_factor:
            raise field_error("load/application_factor", "only_one", field="dynamic_factor")
        return self

    @model_validator(mode="after")
    def _pins_have_a_span(self) -> Self:
        held = self.pin and self.pin.support != "cantilever"
        if held and not (self.says("pin/span_mm") or self.says("build")):
            raise field_error("pin/span_mm", "needed_beside", field="support")
        return self

    @property
    def older_factor(self) -> float | None:
        """Application factor where requests of before had it, beside the contact."""
        return self.contact.dynamic_factor if self.contact else None

    def needs(self) -> Needs:
        """Fields that the calculation needs, also of sections that are given."""
        parts = {"crankshaft": PLACES} | self.NEEDED_OF
        of_given = (needed for name, needed in parts.items() if self.says(name))
        return (*self.NEEDS, *chain.from_iterable(of_given))

    def has(self, part: str) -> bool:
        """True if a section or field is given, or what stands for it."""
        return self.says(part) or (part in INSTEAD and self.says(INSTEAD[part]))

    @property
    def uses(self) -> frozenset[str]:
        """Sections that the calculation uses."""
        return self.USES

    @property
    def not_used(self) -> list[str]:
        """Given sections that the calculation does not use."""
        own = DocumentFields.model_fields
        return [name for name in own if self.says(name) and name not in self.uses]

    @property
    def known_load(self) -> DesignLoadFields:
        """Load, for results that need one."""
        load: DesignLoadFields = self.given["load"]
        return load

    @property
    def ring_kind(self) -> str | None:
        """Kind of the mesh with the ring, if a ring is given and states it."""
        return self.gear.kind if self.gear else None

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values of used sections, with the material of pins taken from the contact."""
        yield from ((path, each) for path, each in super().assumed() if path[0] in self.uses)
        match self.given:
            case {"pin": PinFields(material=None), "contact": PinContactFields() as contact}:
                if "pin" in self.uses:
                    given = contact.pin_material
                    values = (
                        given if isinstance(given, str) else given.model_dump(exclude_none=True)
                    )
                    yield ("pin", "material"), values
        usual: dict[str, Any] = {}
        with suppress(CalculationError):  # a solution is asked for a size that makes no design yet
            usual = self.design.usual_build if self.builds else usual
        for name, value in usual.items():
            path = tuple(map(str, self.path_of(name)))
            yield path, from_si(path[-1], value)

    @property
    def builds(self) -> bool:
        """True if the answer states usual sizes of housing and carrier."""
        return self.says("build") and "build" in self.uses

    def notices(self) -> tuple[Notice, ...]:
        """Notices of used sections, and of a ratio that no cycloid disc with one lobe less has."""
        used = (each for name, each in self.given.items() if name in self.uses)
        parts = (each for each in used if isinstance(each, RequestModel))
        found = tuple(chain.from_iterable(each.notices() for each in parts))
        gear = self.gear if "gear" in self.uses else None
        one_lobe_less = gear and gear.kind == "cycloid" and (gear.teeth_difference or 1) == 1
        if one_lobe_less and self.mechanism.teeth is None:
            ratio = self.mechanism.made.ratio
            if not ratio.is_integer():
                found += (Notice("ratio_not_whole", {"ratio": ratio}),)
        return found

    def cost(self) -> float:
        """Infinite, as solutions and searches leave the event loop."""
        return math.inf

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse too many pairs, and a document that contradicts itself."""
        self.mechanism.refuse_beyond(settings)
        super().refuse_beyond(settings)
        is_known(lambda: self.design)  # what lacks is answered where it is asked for

    @property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return self.mechanism.members

    @property
    def used(self) -> frozenset[str]:
        """Sections of the design that are used."""
        return self.uses

    @cached_property
    def stated(self) -> dict[str, Values]:
        """Stated values of all sections in SI units."""
        parts = {name: self.given[name] for name in KINDS if name in self.given}
        given = {
            name: within(name, partial(getattr, each, "stated")) for name, each in parts.items()
        }
        if self.load and self.older_factor is not None:
            factor = {"application_factor": self.older_factor}
            given["load"] = given["load"] | factor
        return given

    @cached_property
    def design(self) -> Design:
        """Design in SI units."""
        return design_of(self.stated, used=self.used, pin_alone=self.PIN_ALONE)

    @cached_property
    def results(self) -> Results:
        """Results of the design."""
        return Results(self.design)

    @property
    def forces(self) -> ForcesUsed:
        """Kind of forces that the results follow from."""
        return "real" if self.results.solved else "ideal"


class StrengthFields(DocumentFields):
    """Document whose results follow from the forces on the pins, ideal or solved.

    If clearance, deviations, a contact law or elastic satellites are given, or pins bend, forces
    are those of the mechanism as it is made. Otherwise forces are ideal and shared equally by the
    satellites.
    """

    @property
    def ideal(self) -> bool:
        """True if nothing is given by which forces are solved."""
        try:
            return not self.design.as_made
        except CalculationError:  # answered where the design is asked for
            return False

    def without(self, path: tuple[str, ...]) -> Values:
        """Ideal peak force of one satellite, if the number of satellites is assumed."""
        if path != ("mechanism", "satellites") or self.load is None:
            return {}
        return force_of_one(self.mechanism, self.load)

    def cost(self) -> float:
        """Number of points of ideal forces; infinite for solved forces and bent pins."""
        if self.pin is not None or self.load is None or not self.ideal:
            return math.inf
        return self.mechanism.points(exponent=self.load.force_exponent)

    def with_fit(self, result: Result) -> Result:
        """Result with notices about the fit of pins and holes."""
        fit = notices_of(if_known(lambda: self.design.pin_fit))
        notices = (*fit, *notices_of(result))
        return cast(Result, replace(cast(Any, result), notices=notices))

    def drawn_angles(self) -> tuple[FloatArray, FloatArray]:
        """Crank angles of a figure's curves with the switching angles of ideal pairs, rad."""
        angles, switching = drawing_angles(mechanism=self.design.built)
        return angles, switching[:0] if self.results.solved else switching


def forces_used() -> Any:
    """Field of an answer that states the kind of forces."""
    return result(
        "Forces behind the results: ideal forces, or real forces with clearance, deviations and "
        "elasticity, if these are given or pins bend."
    )
