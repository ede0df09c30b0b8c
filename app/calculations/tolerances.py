"""Tolerances of the parts, as a request states them."""

import re
from collections.abc import Collection, Iterator, Mapping
from functools import cached_property, partial
from typing import Annotated, Any, ClassVar, Literal, Self, get_args

from pydantic import Discriminator, Field, Tag, model_validator

from app.calculations.mechanism import Deviation, class_pattern
from app.model import (
    LARGEST,
    UNION_TAGS,
    Maybe,
    RequestModel,
    Values,
    quantity,
)
from app.problems import refusal
from app.rules import Forms, field_error
from app.units import core_name, from_si, to_si
from core.errors import InvalidInput
from core.tolerance.draws import Distribution, Spread
from core.tolerance.iso286 import SIZES, Limits, class_limits
from core.tolerance.processes import PROCESSES, Process, ProcessName
from core.tolerance.tolerances import Tolerances

Phase = Annotated[float, Field(ge=-360, le=360)]

Part = Literal["pin", "hole"]

PARTS: tuple[Part, ...] = get_args(Part)
"""Parts that may be made in different ways."""


class _OneSpreadFields(RequestModel, group="tolerances"):
    """Distribution of a single deviation of a piece between its limits."""

    distribution: Distribution = quantity("Distribution", default="normal")
    """Distribution between the limits: normal, cut off at the limits three standard deviations from
    the middle, or uniform."""

    def _refuse_reversed(self, unit: str) -> None:
        lower, upper = getattr(self, f"lower_{unit}"), getattr(self, f"upper_{unit}")
        if lower > upper:
            raise field_error(f"lower_{unit}", "at_most", field=f"upper_{unit}", limit=upper)

    def _spread(self, lower: float, upper: float) -> Spread:
        return Spread(lower, upper, self.distribution, getattr(self, "common", False))


class _SpreadFields(_OneSpreadFields, group="tolerances"):
    """Distribution of a size or an angle of each part between its limits."""

    common: bool = quantity("Common to all", default=False)
    """True if all such parts of a piece have the same deviation, as with one batch or one tool."""


_lower = partial(quantity, "From", step=0.001, help="Lower limit of the deviation.")
_upper = partial(quantity, "To", step=0.001, help="Upper limit of the deviation.")
"""Fields of lengths, angles and diameters."""


class ToolSpreadFields(_OneSpreadFields, group="tolerances"):
    """Limits of a tool's deviation, which all discs of a piece share."""

    lower_mm: Deviation = _lower()
    upper_mm: Deviation = _upper()

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        self._refuse_reversed("mm")
        return self

    def spread(self) -> Spread:
        """Limits and distribution in SI units."""
        return self._spread(to_si("lower_mm", self.lower_mm), to_si("upper_mm", self.upper_mm))


class LengthSpreadFields(ToolSpreadFields, _SpreadFields, group="tolerances"):
    """Limits of a length's deviation."""


class PhaseSpreadFields(_SpreadFields, group="tolerances"):
    """Limits of an angle's deviation."""

    lower_deg: Phase = _lower()
    upper_deg: Phase = _upper()

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        self._refuse_reversed("deg")
        return self

    def spread(self) -> Spread:
        """Limits and distribution in SI units."""
        return self._spread(to_si("lower_deg", self.lower_deg), to_si("upper_deg", self.upper_deg))


SAID_BY_PROCESS = ("process", "pin_process", "hole_process")
"""Fields that fill in others and vary nothing themselves."""


class _DiameterFields(_SpreadFields, group="tolerances"):
    """A diameter's class or limits."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("class",), ("lower_mm", "upper_mm")),)

    CLASSES: ClassVar[str]
    """Pattern of its classes."""

    tolerance_class: Maybe[str] = None
    lower_mm: Maybe[Deviation] = _lower()
    upper_mm: Maybe[Deviation] = _upper()

    @model_validator(mode="after")
    def _known_or_in_order(self) -> Self:
        if not self.by_class:
            self._refuse_reversed("mm")
        elif not re.fullmatch(self.CLASSES, self.given["tolerance_class"]):
            raise field_error("class", "no_class")
        return self

    @property
    def by_class(self) -> bool:
        """True if a class states its limits."""
        return "tolerance_class" in self.given

    def spread(self, diameter: float) -> Spread:
        """Deviation of the radius in SI units; refused if no class covers the nominal diameter."""
        if self.by_class:
            limits = class_limits(size=diameter, tolerance_class=self.given["tolerance_class"])
            return self._spread(limits.lower / 2, limits.upper / 2)
        lower, upper = to_si("lower_mm", self.lower_mm), to_si("upper_mm", self.upper_mm)
        return self._spread(lower / 2, upper / 2)


class PinDiameterFields(_DiameterFields, group="pin_diameter"):
    """Class or limits of the pins' diameter."""

    CLASSES: ClassVar[str] = class_pattern(True)

    tolerance_class: Maybe[str] = quantity(
        "Class", alias="class", schema={"pattern": f"^{CLASSES}$"}
    )
    """ISO 286 class of a shaft, such as m6, given instead of limits."""


class HoleDiameterFields(_DiameterFields, group="hole_diameter"):
    """Class or limits of the holes' diameter."""

    CLASSES: ClassVar[str] = class_pattern(False)

    tolerance_class: Maybe[str] = quantity(
        "Class", alias="class", schema={"pattern": f"^{CLASSES}$"}
    )
    """ISO 286 class of a hole, such as H7, given instead of limits."""


def _kind(given: Any) -> Literal["plus_minus", "limits"]:
    return "limits" if isinstance(given, (dict, RequestModel)) else "plus_minus"


UNION_TAGS.update(("plus_minus", "limits"))

Zone = Annotated[float, Field(ge=0, le=LARGEST)]
"""Length about a middle, or 0 for an exact part."""

AnglePlusMinus = Annotated[float, Field(ge=0, le=360)]
LengthSpread = Annotated[
    Annotated[Zone, Tag("plus_minus")] | Annotated[LengthSpreadFields, Tag("limits")],
    Discriminator(_kind),
]
ToolSpread = Annotated[
    Annotated[Zone, Tag("plus_minus")] | Annotated[ToolSpreadFields, Tag("limits")],
    Discriminator(_kind),
]
PhaseSpread = Annotated[
    Annotated[AnglePlusMinus, Tag("plus_minus")] | Annotated[PhaseSpreadFields, Tag("limits")],
    Discriminator(_kind),
]


OF_THE_RING = (
    "ring_pin_position_mm",
    "ring_pin_diameter",
    "equidistant_mm",
    "modification_pin_circle_mm",
)
"""Tolerances of ring pins and of the cycloid discs on them."""


class TolerancesFields(RequestModel, group="tolerances"):
    """Tolerances of the parts; parts that are not named are exact. Each part of a piece has a
    deviation of its own.
    """

    process: Maybe[ProcessName] = quantity("Process")
    """Manufacturing process of the parts; its guide values fill the fields that are not given."""
    pin_process: Maybe[ProcessName] = quantity("Process of the pins", advanced=True)
    """Manufacturing process of the pins alone, for instance of bought pins; its guide values fill
    the fields that are not given."""
    hole_process: Maybe[ProcessName] = quantity("Process of the holes", advanced=True)
    """Manufacturing process of the holes alone; its guide values fill the fields that are not
    given."""
    pin_position_mm: Maybe[Zone] = quantity("Position of the pins", "t", step=0.001)
    """Diameter of the round tolerance zone of each pin's centre."""
    hole_position_mm: Maybe[Zone] = quantity("Position of the holes", "t_j", step=0.001)
    """Diameter of the round tolerance zone of each hole's centre."""
    pin_diameter: Maybe[PinDiameterFields] = quantity("Pin diameter", step=0.001)
    """Class or limits of the pin's diameter, or of the sleeve or roller that touches the hole."""
    hole_diameter: Maybe[HoleDiameterFields] = quantity("Hole diameter", step=0.001)
    """Class or limits of the diameter of the holes."""
    eccentricity_mm: Maybe[LengthSpread] = quantity("Eccentricity", "Δe", step=0.001)
    """Deviation of the eccentricity of each crank: a value for plus or minus, or limits."""
    crank_phase_deg: Maybe[PhaseSpread] = quantity("Crank phase", "Δα", step=0.001)
    """Deviation of the angle of each crank: a value for plus or minus, or limits."""
    disc_phase_deg: Maybe[PhaseSpread] = quantity("Disc phase", "η", step=0.001)
    """Deviation of the angle of each disc's holes relative to its teeth: a value for plus or minus,
    or limits."""
    ring_pin_position_mm: Maybe[Zone] = quantity("Position of the ring's pins", "t_r", step=0.001)
    """Diameter of the round tolerance zone of each ring pin's centre."""
    ring_pin_diameter: Maybe[PinDiameterFields] = quantity(
        "Diameter of the ring's pins", step=0.001
    )
    """Class or limits of the diameter of the ring pins."""
    equidistant_mm: Maybe[ToolSpread] = quantity("Equidistant modification", "Δ_e", step=0.001)
    """Deviation of the tool's radius, common to all discs of a piece: a value for plus or minus, or
    limits."""
    modification_pin_circle_mm: Maybe[ToolSpread] = quantity(
        "Modification of the circle", "Δ_p", step=0.001
    )
    """Deviation of the radius of the tool's circle, common to all discs of a piece: a value for
    plus or minus, or limits."""

    @property
    def processes(self) -> dict[Part, Process]:
        """Manufacturing processes of pins and holes, as far as they are stated."""
        said = {part: self.given.get(f"{part}_process", self.process) for part in PARTS}
        return {part: PROCESSES[name] for part, name in said.items() if name is not None}

    @cached_property
    def guides(self) -> Values:
        """Values that processes fill in for fields that are not given."""
        found: Values = {}
        for part, process in self.processes.items():
            found[f"{part}_position_mm"] = from_si("position_mm", process.position)
            match process.size(part):
                case Limits(lower, upper):
                    ends = {"lower_mm": lower, "upper_mm": upper}
                    found[f"{part}_diameter"] = {end: from_si(end, ends[end]) for end in ends}
                case str() as size:
                    found[f"{part}_diameter"] = {"class": size}
        return {name: value for name, value in found.items() if name not in self.given}

    def filled(self, without: Collection[str] = ()) -> "TolerancesFields":
        """Tolerances with guide values of their processes, except for fields stated elsewhere."""
        guides = {name: each for name, each in self.guides.items() if name not in without}
        values = TolerancesFields.model_validate(guides)
        return self.model_copy(update={name: getattr(values, name) for name in guides})

    def spreads(self) -> list[str]:
        """Names of the tolerances."""
        return [name for name in self.given if name not in SAID_BY_PROCESS]

    def tolerances(self, diameters: Mapping[str, float]) -> Tolerances:
        """Tolerances in SI units, for diameters of pins, holes and ring pins, m, by their names."""
        radii = {
            f"{part}_radius": _of_diameter(name, self.given[name], diameter)
            for part, diameter in diameters.items()
            if (name := f"{part}_diameter") in self.given
        }
        return Tolerances(
            pin_position=to_si("position_mm", self.pin_position_mm),
            hole_position=to_si("position_mm", self.hole_position_mm),
            ring_pin_position=to_si("position_mm", self.ring_pin_position_mm),
            **radii,
            **dict(self._spreads()),
        )

    def _spreads(self) -> Iterator[tuple[str, Spread]]:
        for name in (
            "eccentricity_mm",
            "crank_phase_deg",
            "disc_phase_deg",
            "equidistant_mm",
            "modification_pin_circle_mm",
        ):
            match self.given.get(name):
                case float() as given:
                    size = to_si(name, given)
                    yield core_name(name), Spread(-size, size)
                case ToolSpreadFields() | PhaseSpreadFields() as limits:
                    yield core_name(name), limits.spread()


def _of_diameter(name: str, given: _DiameterFields, diameter: float) -> Spread:
    try:
        return given.spread(diameter)
    except InvalidInput as error:
        place, limit_mm = f"/tolerances/{name}/class", float(SIZES[-1])
        raise refusal(place, "no_class_of_size", limit_mm=limit_mm) from error
