"""Tolerances of the parts as the design document states them, and their guide values by process."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, ClassVar, Literal, get_args

from core.errors import InvalidInput
from core.fields import LARGEST, Forms, quantity
from core.tolerance.draws import Distribution, Spread
from core.tolerance.iso286 import CLASSES, GRADES, SIZES, Limits, class_limits
from core.tolerance.processes import PROCESSES, Process, ProcessName
from core.tolerance.tolerances import Tolerances

Part = Literal["pin", "hole"]

PARTS: tuple[Part, ...] = get_args(Part)
"""Parts that may be made in different ways."""


def class_pattern(*, of_pins: bool) -> str:
    """Pattern of the ISO 286 classes of pins, or of holes."""
    letters = "|".join(each for each in CLASSES if each.islower() == of_pins)
    return f"({letters})({'|'.join(map(str, GRADES))})"


common = partial(quantity, "Common to all", default=False)
length = partial(quantity, unit="mm", step=0.001, ge=-1e6, le=1e6)
phase = partial(quantity, unit="deg", step=0.001, ge=-360, le=360)
zone = partial(quantity, unit="mm", default=None, step=0.001, ge=0, le=LARGEST)


@dataclass(frozen=True, slots=True)
class ToolSpread(Spread):
    """Limits of a tool's deviation, which all discs of a piece share."""

    lower: float = length("From")
    """Lower limit of the deviation."""
    upper: float = length("To")
    """Upper limit of the deviation."""
    distribution: Distribution = quantity("Distribution", default="normal")
    """Distribution between the limits: normal, cut off at the limits three standard deviations from
    the middle, or uniform."""


@dataclass(frozen=True, slots=True)
class LengthSpread(ToolSpread):
    """Limits of a length's deviation."""

    common: bool = common()
    """True if all such parts of a piece have the same deviation, as with one batch or one tool."""


@dataclass(frozen=True, slots=True)
class PhaseSpread(LengthSpread):
    """Limits of an angle's deviation."""

    lower: float = phase("From")
    """Lower limit of the deviation."""
    upper: float = phase("To")
    """Upper limit of the deviation."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Diameter:
    """A diameter's ISO 286 class or limits."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("tolerance_class",), ("lower", "upper")),)
    CLASS: ClassVar[str]

    distribution: Distribution = quantity("Distribution", default="normal")
    """Distribution between the limits: normal, cut off at the limits three standard deviations from
    the middle, or uniform."""
    common: bool = common()
    """True if all such parts of a piece have the same deviation, as with one batch or one tool."""
    tolerance_class: str | None = None  # ISO 286 class; of pins or of holes
    lower: float | None = length("From", default=None)
    """Lower limit of the deviation."""
    upper: float | None = length("To", default=None)
    """Upper limit of the deviation."""

    def __post_init__(self) -> None:
        name = self.tolerance_class
        if name is not None and not re.fullmatch(self.CLASS, name):
            raise InvalidInput("tolerance_class", name, "no_class")
        if self.lower is not None and self.upper is not None:
            Spread(self.lower, self.upper)

    def of_radius(self, diameter: float, path: str) -> Spread:
        """Deviation of the radius of a nominal diameter, both in m; `path` names this diameter."""
        lower, upper = self.lower or 0.0, self.upper or 0.0
        if self.tolerance_class is not None:
            largest = SIZES[-1] / 1e3
            if diameter > largest:
                name = f"{path}.tolerance_class"
                given = self.tolerance_class
                raise InvalidInput(name, given, "no_class_of_size", limit_mm=largest)
            limits = class_limits(size=diameter, tolerance_class=self.tolerance_class)
            lower, upper = limits.lower, limits.upper
        return Spread(lower / 2, upper / 2, self.distribution, self.common)


@dataclass(frozen=True, slots=True, kw_only=True)
class PinDiameter(Diameter):
    """Class or limits of the pins' diameter."""

    CLASS: ClassVar[str] = class_pattern(of_pins=True)

    tolerance_class: str | None = quantity("Class", default=None, alias="class", pattern=CLASS)
    """ISO 286 class of a shaft, such as m6, given instead of limits."""


@dataclass(frozen=True, slots=True, kw_only=True)
class HoleDiameter(Diameter):
    """Class or limits of the holes' diameter."""

    CLASS: ClassVar[str] = class_pattern(of_pins=False)

    tolerance_class: str | None = quantity("Class", default=None, alias="class", pattern=CLASS)
    """ISO 286 class of a hole, such as H7, given instead of limits."""


DIAMETERS: dict[Part, type[Diameter]] = {"pin": PinDiameter, "hole": HoleDiameter}

SPREADS = (
    "eccentricity",
    "crank_phase",
    "disc_phase",
    "equidistant",
    "modification_pin_circle",
)
"""Tolerances that are limits of a deviation."""

POSITIONS = ("pin_position", "hole_position", "ring_pin_position")
"""Tolerances that are round zones of centres."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ToleranceSection:
    """Tolerances of the parts; parts that are not named are exact. Each part of a piece has a
    deviation of its own.
    """

    process: ProcessName | None = quantity("Process", default=None)
    """Manufacturing process of the parts; its guide values fill the fields that are not given."""
    pin_process: ProcessName | None = quantity("Process of the pins", default=None, advanced=True)
    """Manufacturing process of the pins alone, for instance of bought pins; its guide values fill
    the fields that are not given."""
    hole_process: ProcessName | None = quantity("Process of the holes", default=None, advanced=True)
    """Manufacturing process of the holes alone; its guide values fill the fields that are not
    given."""
    pin_position: float | None = zone("Position of the pins", "t")
    """Diameter of the round tolerance zone of each pin's centre."""
    hole_position: float | None = zone("Position of the holes", "t_j")
    """Diameter of the round tolerance zone of each hole's centre."""
    pin_diameter: PinDiameter | None = quantity("Pin diameter", default=None, step=0.001)
    """Class or limits of the pin's diameter, or of the sleeve or roller that touches the hole."""
    hole_diameter: HoleDiameter | None = quantity("Hole diameter", default=None, step=0.001)
    """Class or limits of the diameter of the holes."""
    eccentricity: LengthSpread | None = quantity(
        "Eccentricity", "Δe", "mm", default=None, step=0.001
    )
    """Deviation of the eccentricity of each crank: a value for plus or minus, or limits."""
    crank_phase: PhaseSpread | None = quantity("Crank phase", "Δα", "deg", default=None, step=0.001)
    """Deviation of the angle of each crank: a value for plus or minus, or limits."""
    disc_phase: PhaseSpread | None = quantity("Disc phase", "η", "deg", default=None, step=0.001)
    """Deviation of the angle of each disc's holes relative to its teeth: a value for plus or minus,
    or limits."""
    ring_pin_position: float | None = zone("Position of the ring's pins", "t_r")
    """Diameter of the round tolerance zone of each ring pin's centre."""
    ring_pin_diameter: PinDiameter | None = quantity(
        "Diameter of the ring's pins", default=None, step=0.001
    )
    """Class or limits of the diameter of the ring pins."""
    equidistant: ToolSpread | None = quantity(
        "Equidistant modification", "Δ_e", "mm", default=None, step=0.001
    )
    """Deviation of the tool's radius, common to all discs of a piece: a value for plus or minus, or
    limits."""
    modification_pin_circle: ToolSpread | None = quantity(
        "Modification of the circle", "Δ_p", "mm", default=None, step=0.001
    )
    """Deviation of the radius of the tool's circle, common to all discs of a piece: a value for
    plus or minus, or limits."""

    @property
    def processes(self) -> dict[Part, Process]:
        """Manufacturing processes of pins and holes, as far as they are stated."""
        said = {part: getattr(self, f"{part}_process") or self.process for part in PARTS}
        return {part: PROCESSES[name] for part, name in said.items() if name is not None}

    def guides(self, fit: str = "") -> dict[str, Any]:
        """Values that processes state for fields that are not given, without what a fit states."""
        found: dict[str, Any] = {}
        for part, process in self.processes.items():
            found[f"{part}_position"] = process.position
            kind, name = DIAMETERS[part], f"{part}_diameter"
            match process.size(part):
                case _ if fit:
                    pass
                case Limits(lower, upper):
                    found[name] = kind(lower=lower, upper=upper)
                case str(size):
                    found[name] = kind(tolerance_class=size)
        return {name: each for name, each in found.items() if getattr(self, name) is None}

    def filled(self, fit: str = "") -> "ToleranceSection":
        """Tolerances with the classes of a fit, such as H7/f7, and guide values of processes."""
        said = self.guides(fit)
        if fit:
            of_hole, of_pin = fit.split("/")
            classes: dict[Part, str] = {"pin": of_pin, "hole": of_hole}
            for part, size in classes.items():
                name = f"{part}_diameter"
                if given := getattr(self, name):
                    raise InvalidInput(f"tolerances.{name}", given, "only_one", field="fit")
                said[name] = DIAMETERS[part](tolerance_class=size)
        return replace(self, **said)

    def of_parts(self, diameters: Mapping[str, float]) -> Tolerances:
        """Tolerances of pieces, for nominal diameters of `pin`, `hole` and `ring_pin`, m."""
        radii = {
            f"{part}_radius": given.of_radius(diameter, f"tolerances.{part}_diameter")
            for part, diameter in diameters.items()
            if (given := getattr(self, f"{part}_diameter"))
        }
        own = {name: getattr(self, name) for name in (*POSITIONS, *SPREADS)}
        return Tolerances(**own, **radii)
