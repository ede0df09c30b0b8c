"""Parallel-crank mechanism of a request: pins, satellites and ratio; pin, hole and crank with their
clearance and the sizes that follow; and the fit of pins in holes.
"""

import math
import re
from collections.abc import Iterator
from decimal import Decimal
from functools import cached_property
from typing import Annotated, Any, ClassVar, Literal, Self, cast

from pydantic import Field, model_validator

from app.calculations.hertz import (
    ContactFields,
    contact_length,
    distribution_factor,
    eccentricity,
    hole_radius,
    material_of,
    pin_radius,
)
from app.model import (
    Angle,
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    Whole,
    quantity,
    result,
)
from app.rules import Forms, Kinds, Rule, field_error
from app.settings import Settings
from app.units import from_si, to_si
from core.design.document import mechanism_of
from core.design.sections import Contact, MechanismSection, SharedBy
from core.errors import InvalidInput, Notice
from core.output.mechanism import MAX_SATELLITES as MAX_SATELLITES
from core.output.mechanism import Mechanism, Members, Output, felt, ratio_from_teeth
from core.output.room import Rooms
from core.tolerance.iso286 import CLASSES, GRADES, SIZES, fit_clearance

MAX_PAIRS = 10_000
"""Largest number of pairs (pins times satellites) of a mechanism."""

MAX_DRAWN_PAIRS = 240
"""Largest number of pairs in a figure."""


PAIR_POINTS = 240
"""Number of points of a pair whose forces are searched and integrated over the turn."""

STEEP = 1.25
"""Number of points for an exponent below 1 over that for 1, in calls: such forces rise steeply as a
pair begins to drive."""


OF_RINGS = ("ratio", "satellite_teeth", "ring_teeth", "crank_spacing_deg", "crank_angles_deg")
"""Fields of a mechanism that has a ring, and cranks."""


def count_satellites(fields: Any) -> None:
    """Set the number of satellites by the crank angles; another given number is refused."""
    angles = fields.crank_angles_deg
    if angles is None:
        return
    if "satellites" not in fields.model_fields_set:
        fields.satellites = len(angles)
    if len(angles) != fields.satellites:
        count = {"expected": fields.satellites, "actual": len(angles)}
        raise field_error("crank_angles_deg", "different_length", **count)


class MechanismFields(RequestModel, group="mechanism"):
    """Pins, satellites, cranks and ratio."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("ratio",), ("output_ratio",), ("satellite_teeth", "ring_teeth"), ()),
        (("crank_spacing_deg",), ("crank_angles_deg",), ()),
    )
    KIND: ClassVar[str] = "output"
    OF_OTHERS: ClassVar[tuple[str, str]] = ("of_other_output", "output")
    KINDS: ClassVar[Kinds] = {
        "pins": ((), OF_RINGS),
        "ring": ((), (*OF_RINGS, "output_ratio")),
        "both": ((), OF_RINGS),
        "coupling": ((), ()),
        "crankshafts": ((), OF_RINGS),
    }
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

    pins: Whole = quantity("Pins", "N", step=1, ge=1, le=MAX_PAIRS)
    """Number of pins of the output link, evenly spaced on the pin circle."""
    satellites: Whole = quantity("Satellites", "K", default=2, step=1, ge=1, le=MAX_SATELLITES)
    """Number of satellites, each on its own crank."""
    crank_spacing_deg: Maybe[Angle] = quantity("Crank spacing", "α", step=15)
    """Angle between neighbouring cranks; 360°/K where not given."""
    crank_angles_deg: Maybe[list[Angle]] = quantity(
        "Crank angles", "α₁ … α_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Angle of each crank, one for each satellite, instead of an even spacing."""
    ratio: Maybe[float] = quantity(
        "Ratio", "u", step=1, schema={"anyOf": [{"minimum": 1}, {"maximum": -1}]}, ge=-1e9, le=1e9
    )
    """Speed of the crank over that of the pins with the ring at rest, u = z₂/(z₃ − z₂), at least 1.
    A negative sign, for pins that turn opposite to the crank, as they always do, is accepted and
    ignored."""
    output_ratio: Maybe[float] = quantity("Ratio of the output", "i", step=1, ge=2, le=1e9)
    """Speed of the crank over that of the ring, i = u + 1, if the ring is the output."""
    satellite_teeth: Maybe[Whole] = quantity("Satellite teeth", "z₂", step=1, ge=1, le=10**6)
    """Number of teeth of a satellite, from which the ratio and the assembly angles follow."""
    ring_teeth: Maybe[Whole] = quantity("Ring teeth", "z₃", step=1, ge=2, le=10**6)
    """Number of teeth of the ring, larger than that of the satellite."""
    output: Literal["pins", "ring", "both", "coupling", "crankshafts"] = quantity(
        "Output", default="pins", advanced=True
    )
    """Output link: the pins with the ring at rest, the ring with the pins at rest, or both; or a
    coupling, in which pins connect two shafts an eccentricity apart, without a ring. RV reducers,
    whose crankshafts drive the output, are not calculated."""
    initial_crank_angle_deg: Angle = quantity(
        "Initial wave angle", "φ₀", default=0.0, step=15, advanced=True
    )
    """Wave angle at the crank angle 0: 0° by the sign convention of Yanchevskiy 2021, 180° by that
    of Yanchevsky 2018; 180° also equals a reversed torque."""

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
    def _by_pins(self) -> Self:
        if self.output == "crankshafts":
            raise field_error("output", "not_this_mechanism")
        return self

    @model_validator(mode="after")
    def _reduces(self) -> Self:
        match self.given:
            case {"ratio": ratio}:
                self._refuse_ratio(ratio)
            case {"satellite_teeth": satellite, "ring_teeth": ring} if ring > 2 * satellite:
                more = {"limit": 2 * satellite, "field": "satellite_teeth"}
                raise field_error("ring_teeth", "ratio_of_teeth", **more)
            case {"output_ratio": _} | {"ring_teeth": _} | {"output": "coupling"}:
                pass
            case _:
                raise field_error("ratio", "needed", field="satellite_teeth")
        return self

    def _refuse_ratio(self, ratio: float) -> None:
        if ratio == 0:
            raise field_error("ratio", "not_zero")
        if abs(ratio) < 1:
            raise field_error("ratio", "ratio_below_one", limit=1, offered=1 / ratio)
        if ratio < 0 and self.output == "ring":
            raise field_error("ratio", "sign_of_ring", offered=-ratio)

    @model_validator(mode="after")
    def _counts(self) -> Self:
        count_satellites(self)
        if self.output == "coupling":
            if "satellites" in self.model_fields_set and self.satellites > 1:
                raise field_error("satellites", "one_of_coupling", limit=1)
            self.satellites = 1
        if self.pairs > MAX_PAIRS:
            raise field_error("pins", "too_many_pairs", **self.most_pins(MAX_PAIRS))
        return self

    @property
    def pairs(self) -> int:
        """Number of pin/hole pairs."""
        return self.pins * self.satellites

    def points(self, *, exponent: float = 1.0, samples: int = 0, revolutions: float = 1.0) -> float:
        """Number of points over the turn: each satellite has a driving set, which meets those of
        all others. Exponents above 1 and curves with more samples need more points in proportion;
        exponents below 1 are steeper at the ends.
        """
        sharp = STEEP if 0 < exponent < 1 else max(1.0, exponent)
        of_each = max(PAIR_POINTS * sharp, samples) * max(1.0, revolutions)
        teeth = (self.ring_teeth or 1) / (self.satellite_teeth or 1)
        return of_each * self.pins * self.satellites**2 * teeth

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
        if self.pins * self.satellites > MAX_DRAWN_PAIRS:
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

    @property
    def teeth_difference(self) -> int | None:
        """Teeth of the ring less those of a satellite, if they are given."""
        match self.given:
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return int(ring - satellite)
        return None

    def notices(self) -> tuple[Notice, ...]:
        """Notice of a ratio with the sign of the output."""
        signed = (self.ratio or 0) < 0
        return (Notice("ratio_sign", {"ratio": self.ratio_given()}),) if signed else ()

    def ratio_given(self) -> float:
        """Ratio u, given directly, by the ring or by teeth; infinite for a coupling."""
        match self.given:
            case {"ratio": ratio}:
                return float(abs(ratio))
            case {"output_ratio": ratio}:
                return float(ratio - 1)
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return ratio_from_teeth(satellite_teeth=satellite, ring_teeth=ring)
        return math.inf

    @cached_property
    def in_si(self) -> MechanismSection:
        """Mechanism in SI units."""
        angles = to_si("crank_angles_deg", self.crank_angles_deg)
        return MechanismSection(
            pins=self.pins,
            satellites=self.satellites,
            ratio=self.ratio_given(),
            output=cast(Output, self.output),
            crank_spacing=to_si("spacing_deg", self.crank_spacing_deg),
            crank_angles=tuple(angles or ()),
            initial_crank_angle=to_si("initial_crank_angle_deg", self.initial_crank_angle_deg),
            satellite_teeth=self.satellite_teeth,
        )

    def section(self, _: Any) -> MechanismSection:
        """Section of the design in SI units."""
        return self.in_si

    def mechanism(self) -> Mechanism:
        """The mechanism in SI units."""
        return mechanism_of(self.in_si)

    @property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return Members(self.in_si.output, self.in_si.ratio)


class PairOut(ResponseModel):
    """Pair of hole and pin by number."""

    satellite: int = result("Number of the satellite, from 1.", symbol="j")
    pin: int = result("Number of the pin, from 1.", symbol="n")


Deviation = Annotated[float, Field(ge=-1e6, le=1e6)]

LEAST_CLEARANCE = 1e-6
"""Least clearance or interference other than 0, mm, as none smaller is made or measured."""

SAYING_CLEARANCE = ("hole_clearance_mm", "fit", "hole_radius_mm")
"""Fields that state the clearance; the first given one counts."""

RADII = ("pin_radius_mm", "eccentricity_mm", "stated_clearance_mm")
"""Sizes whose sum is the radius of the hole."""


def class_pattern(of_pins: bool) -> str:
    """Pattern of the ISO 286 classes of pins, or of holes."""
    letters = "|".join(each for each in CLASSES if each.islower() == of_pins)
    return f"({letters})({'|'.join(map(str, GRADES))})"


USUAL_FITS = ["H7/g6", "H7/h6", "H7/f7", "H8/h7", "H8/f7", "H8/f8", "H9/f9"]
"""Fits that the form offers."""

FIT = f"^{class_pattern(False)}/{class_pattern(True)}$"


class PinContactFields(ContactFields, group="contact"):
    """Pin, hole, crank and clearance. Any two of hole radius, eccentricity and clearance determine
    the third.
    """

    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("hole_radius_mm", "only_one", "fit"),
        Rule("hole_clearance_mm", "only_one", "fit"),
        Rule("eccentricity_mm", "needed_beside", "fit"),
        Rule("eccentricity_mm", "needed_beside", "hole_clearance_mm"),
        Rule("hole_radius_mm", "needed", "eccentricity_mm"),
    )

    hole_radius_mm: Maybe[Size] = hole_radius()  # type: ignore[assignment]
    eccentricity_mm: Maybe[Size] = eccentricity()
    hole_clearance_mm: Maybe[Deviation] = quantity("Clearance", "c", step=0.005)
    """Radial clearance: hole radius − pin radius − eccentricity. A negative value is interference,
    and 0 means perfect parts. Forces and stresses depend on it more than on most sizes."""
    fit: Maybe[str] = quantity("Fit", schema={"pattern": FIT, "x-options": USUAL_FITS})
    """ISO 286 classes of hole and pin (or sleeve), such as H7/f7, given instead of the clearance,
    which is half of the mean clearance of the two diameters."""
    dynamic_factor: Maybe[Size] = quantity(  # type: ignore[assignment]
        "Application factor", "K_A", step=0.05, schema={"deprecated": True}
    )
    """Older place of `load.application_factor`, as which it is read."""
    distribution_factor: float = distribution_factor(ge=1, le=1e12)
    distribution_of: Maybe[SharedBy] = quantity("Uneven share of", advanced=True)
    """Parts among which the load-sharing factor states uneven sharing. Satellites: one satellite
    carries this multiple of its even share of the torque, at most all of it, and the others carry
    the rest evenly. Pins: the sharing is uneven among the pins of each satellite, and bearings do
    not feel it. The default is satellites if there are several, else pins."""

    @model_validator(mode="after")
    def _fit_says_the_clearance(self) -> Self:
        if self.fit is None:
            return self
        if not re.fullmatch(FIT, self.fit):
            raise field_error("fit", "no_fit")
        if 2 * float(self._sum(*RADII[:2])) > SIZES[-1]:
            raise field_error("fit", "no_class_of_size", limit_mm=float(SIZES[-1]))
        return self

    @model_validator(mode="after")
    def _radii_agree(self) -> Self:
        if self.model_fields_set >= {"hole_radius_mm", "hole_clearance_mm", *RADII[:2]}:
            hole, others = self._sum("hole_radius_mm"), self._sum(*RADII)
            if abs(hole - others) > Decimal("1e-9") * hole:
                raise field_error("hole_radius_mm", "hole_disagrees", expected_mm=float(others))
        return self

    @model_validator(mode="after")
    def _clearance_can_be_made(self) -> Self:
        if 0 < abs(self.clearance_mm()) < LEAST_CLEARANCE:
            named = next(name for name in SAYING_CLEARANCE if name in self.given)
            raise field_error(named, "clearance_dust", limit_mm=LEAST_CLEARANCE)
        return self

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed materials of pins and holes, and the eccentricity of a hole alone."""
        if self.pin_radius_mm is None:
            return
        yield from super().assumed()
        if self.eccentricity_mm is None:
            yield ("eccentricity_mm",), float(self._sum("hole_radius_mm") - self._sum(*RADII[:1]))

    def _sum(self, *names: str) -> Decimal:
        """Sum of the given sizes, in decimals as they were typed, without loss of digits."""
        return sum((Decimal(repr(getattr(self, name) or 0.0)) for name in names), Decimal())

    @cached_property
    def stated_clearance_mm(self) -> float | None:
        """Radial clearance as given, or by the fit."""
        if self.fit is None:
            return self.hole_clearance_mm
        hole, pin = (float(2 * self._sum(*names)) for names in (RADII[:2], RADII[:1]))
        mean = fit_clearance(fit=self.fit, hole_diameter=hole / 1e3, pin_diameter=pin / 1e3)
        return round(mean * 1e3, 9)

    @property
    def clearance_unknown(self) -> bool:
        """True if pin, hole and eccentricity are given, but the clearance is not known."""
        return self._sized and not (self.in_si.clearance_stated or self.clearance_mm())

    @property
    def _sized(self) -> bool:
        return self.given.keys() >= {"pin_radius_mm", "eccentricity_mm"}

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of parts without clearance, which are taken as perfect."""
        perfect = self._sized and not self.clearance_mm()
        return super().notices() + ((Notice("perfect_parts"),) if perfect else ())

    @cached_property
    def hole_mm(self) -> float:
        """Radius of the hole: given, or by pin, eccentricity and clearance."""
        given = self.hole_radius_mm
        return float(self._sum(*RADII)) if given is None else given

    def clearance_mm(self) -> float:
        """Radial clearance: given, or by the radii; None if they do not determine it."""
        if self.stated_clearance_mm is not None:
            return self.stated_clearance_mm
        if not self.given.keys() >= {"hole_radius_mm", "eccentricity_mm"}:
            return 0.0
        clearance = float(self._sum("hole_radius_mm") - self._sum(*RADII[:2]))
        return felt(clearance=clearance, hole_radius=self.hole_mm)

    @property
    def surface(self) -> dict[str, Any]:
        """Diameter, m, and material that pins take if they do not state them."""
        diameter = 2 * to_si("radius_mm", self.pin_radius_mm)
        return {"diameter": diameter, "material": self.pin_material}

    @cached_property
    def in_si(self) -> Contact:
        """Contact in SI units."""
        return Contact(
            contact_length=to_si("contact_length_mm", self.contact_length_mm),
            pin_radius=to_si("pin_radius_mm", self.pin_radius_mm),
            hole_radius=to_si("hole_radius_mm", self.hole_mm),
            eccentricity=to_si("eccentricity_mm", self.eccentricity_mm),
            distribution_factor=self.distribution_factor,
            distribution_of=self.distribution_of,
            clearance_stated=self.stated_clearance_mm is not None,
            iso_fit=self.fit or "",
            pin_material=material_of(self.pin_material),
            hole_material=material_of(self.hole_material),
        )

    def section(self, _: Any) -> Contact:
        """Section of the design in SI units."""
        return self.in_si

    def sizes_on(self, pin_circle_radius_mm: float) -> dict[str, Any]:
        """Sizes of pins and holes on their circle in SI units; None for those not given."""
        return {
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "hole_radius": to_si("hole_radius_mm", self.hole_mm),
            "eccentricity": to_si("eccentricity_mm", self.eccentricity_mm),
            "pin_circle_radius": to_si("pin_circle_radius_mm", pin_circle_radius_mm),
        }


TOUCHING = ("pin_radius_mm", "contact_length_mm")
"""Fields that pins need if their holes are given."""


class CrankContactFields(PinContactFields, group="contact"):
    """Crank, with pin and hole if forces of real pins and holes are wanted."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = tuple(
        Rule(name, "needed_beside", hole)
        for hole in ("hole_radius_mm", "hole_clearance_mm", "fit")
        for name in TOUCHING
    )

    contact_length_mm: Maybe[Size] = contact_length()  # type: ignore[assignment]
    pin_radius_mm: Maybe[Size] = pin_radius()  # type: ignore[assignment]
    eccentricity_mm: Size = eccentricity()


class BindingOut(PairOut):
    """Pair that limits the room."""

    side: Literal["driving", "reverse", "radial"] = result(
        "Sense of the output in which the pair limits the rotation; radial if in neither."
    )


class FitOut(ResponseModel):
    """Fit of pins in their holes by geometry, before any force."""

    state: Literal["fits", "binds_in_turning", "does_not_fit", "no_bound"] = result(
        "State of the fit: room at all crank angles (fits), at some (binds_in_turning), at none"
        " (does_not_fit), or holes that do not bound their pins (no_bound)."
    )
    least_room_mm: Maybe[float] = result(
        "Least room over the turn: amount by which all pins might grow in radius until the "
        "parts just fit, negative if they have to shrink; absent if holes do not bound their "
        "pins.",
        equation="max over θ of min(C − |P·exp(−iθ) − H|)",
    )
    least_room_crank_angle_deg: Maybe[float] = result(
        "First crank angle with the least room; absent if the room is the same at all crank angles."
    )
    binding: Maybe[list[BindingOut]] = result(
        "Pairs that limit the room at that crank angle; absent if all pairs limit it alike."
    )
    needed_hole_radius_mm: Maybe[float] = result(
        "Radius of all holes with which the parts would just fit, if they do not fit."
    )
    blocked_crank_deg: Maybe[list[list[float]]] = result(
        "Ranges of crank angle in which the parts jam, if they go together in others."
    )
    renumbered: Maybe[list[int]] = result(
        "Number of holes by which each satellite is put on the pins further, if any is."
    )

    @classmethod
    def values(cls, result: Rooms, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a fit."""
        room, holes = result.room, result.numbered[1]
        found: dict[str, Any] = {"state": result.state}
        if any(holes):
            found["renumbered"] = [*holes]
        if result.state == "no_bound":
            return found
        found["least_room_mm"] = from_si("least_room_mm", room.least)
        if room.crank_angle is not None:
            found["least_room_crank_angle_deg"] = from_si("angle_deg", room.crank_angle)
        if room.binding:
            found["binding"] = [
                {"satellite": each.satellite, "pin": each.pin, "side": each.side}
                for each in room.binding
            ]
        if room.state != "fits":
            found["needed_hole_radius_mm"] = from_si("radius_mm", result.needed_hole_radius)
        if room.state == "binds_in_turning":
            blocked = [[*ends] for ends in result.blocked()]
            found["blocked_crank_deg"] = from_si("angle_deg", blocked)
        return found
