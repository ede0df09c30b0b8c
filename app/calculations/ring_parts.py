"""Satellites, ring and supports: fields of a request about their mesh."""

from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from app.calculations.design import (
    SatelliteCouplingFields,
    input_speed,
)
from app.calculations.hertz import Material, eccentricity, of_load_factor
from app.calculations.ideal_forces import application_factor
from app.calculations.mechanism import MAX_SATELLITES, count_satellites
from app.calculations.ring import (
    DISC_MATERIAL,
    PIN_MATERIAL,
    RingPinDeviationsFields,
    RingPinsFields,
)
from app.model import Angle, Maybe, RequestModel, Size, Whole, quantity
from app.problems import invalid_input, wrong
from app.rules import Forms
from app.units import to_si
from core.design.document import mechanism_of
from core.design.ring import CycloidRing
from core.design.sections import MechanismSection
from core.errors import Notice
from core.output.room import Deviations
from core.ring.sharing import RingDeviations


class RingTeethFields(RequestModel, group="mechanism"):
    """Teeth and cranks, without the output pins."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("crank_spacing_deg",), ("crank_angles_deg",), ()),
    )
    ASSUMED: ClassVar[tuple[str, ...]] = ("satellites",)

    satellite_teeth: Whole = quantity("Satellite teeth", "z₂", step=1, ge=2, le=999)
    """Number of teeth of a satellite; the lobes of a cycloid disc."""
    ring_teeth: Whole = quantity("Ring teeth", "z₃", step=1, ge=3, le=1000)
    """Number of teeth or pins of the ring; a cycloid disc has one lobe less than the ring has
    pins."""
    satellites: Whole = quantity("Satellites", "K", default=2, step=1, ge=1, le=MAX_SATELLITES)
    """Number of satellites, each on its own crank."""
    crank_spacing_deg: Maybe[Angle] = quantity("Crank spacing", "α", step=15)
    """Angle between neighbouring cranks; 360°/K where not given."""
    crank_angles_deg: Maybe[list[Angle]] = quantity(
        "Crank angles", "α₁ … α_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Angle of each crank, one for each satellite, instead of an even spacing."""
    pins: Maybe[Whole] = quantity("Pins", "N", step=1, ge=1, le=10_000)
    """Number of pins of the output link; not used here."""

    @model_validator(mode="after")
    def _counts(self) -> Self:
        count_satellites(self)
        return self

    @property
    def pairs(self) -> int:
        """Number of pairs of pins and discs."""
        return self.ring_teeth * self.satellites

    @property
    def crank_angles(self) -> tuple[float, ...]:
        """Crank angles, rad."""
        angles = to_si("crank_angles_deg", self.crank_angles_deg)
        section = MechanismSection(
            pins=self.ring_teeth,
            satellites=self.satellites,
            ratio=float(self.satellite_teeth),
            crank_spacing=to_si("spacing_deg", self.crank_spacing_deg),
            crank_angles=angles and tuple(angles),
        )
        return mechanism_of(section).crank_angles


class RingLoadFields(RequestModel, group="load"):
    """Torque and speed."""

    output_torque_Nm: Size = quantity("Output torque", "T", step=10)
    """Torque of all discs on the output."""
    torque_direction: Literal["driving", "reverse"] = quantity(
        "Direction of the torque", default="driving"
    )
    """Driving: the satellites turn the output; reverse: the load turns the satellites back."""
    application_factor: Maybe[Size] = application_factor(
        help="Factor on the torque for the stresses of involute teeth, not for cycloid discs."
    )
    input_speed_rpm: Maybe[Size] = input_speed()
    pin_circle_radius_mm: Maybe[Size] = quantity("Pin circle radius", "R", step=1)
    """Radius of the circle of the output's pins; not used here."""

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of an application factor below 1."""
        return super().notices() + of_load_factor(self.application_factor)


class RingCrankFields(RequestModel, group="contact"):
    """The crank."""

    eccentricity_mm: Size = eccentricity()


class CycloidRingFields(
    RingPinsFields,
    of=CycloidRing,
    without=("rotates", "tool_radius", "every_second_pin", "ring_class"),
    needs=("ring_pin_radius", "contact_length"),
    group="gear",
):
    """Cycloid discs and their ring pins."""

    ASSUMED: ClassVar[tuple[str, ...]] = ("pin_material", "disc_material")

    kind: Literal["cycloid"] = quantity("Ring")
    """Ring of pins on which a cycloid disc rolls."""
    pin_material: Material = quantity("Material of the ring's pins", default=PIN_MATERIAL)
    """Name in the table of materials, or values; bearing steel if not given."""
    disc_material: Material = quantity("Disc material", default=DISC_MATERIAL)
    """Name in the table of materials, or values."""

    @property
    def turned(self) -> bool:
        """True if the modification rotates the flanks."""
        return self.modification is not None and self.modification.rotation_arcmin > 0

    def notices(self) -> tuple[Notice, ...]:
        """Notice of an unknown modification."""
        unknown = self.modification is None
        return super().notices() + ((Notice("modification_unknown"),) if unknown else ())


class RingDeviationsFields(
    RingPinDeviationsFields,
    of=Deviations,
    only=("eccentricity", "crank_phase", "disc_phase"),
    group="deviations",
):
    """Deviations of a ring and its discs from their nominal sizes. Positive means outward, as the
    output turns, larger, ahead.
    """

    def section(self, around: Any = None) -> RingDeviations:
        """The deviations in SI units."""
        own = self.to_core()
        return RingDeviations(
            **{name.removeprefix("ring_"): tuple(value) for name, value in own.items()}
        )

    def refuse_other_lengths(self, pins: int, satellites: int) -> None:
        """Refuse lists that do not fit the ring."""
        counts = [
            (name, pins if name.startswith("ring") else satellites, len(value))
            for name, value in self.given.items()
        ]
        errors = [
            wrong(f"/deviations/{name}", "different_length", expected=want, actual=have)
            for name, want, have in counts
            if want != have
        ]
        if errors:
            raise invalid_input(errors)


class MeshCouplingFields(SatelliteCouplingFields, group="satellite_coupling"):
    """Sharing of the torque between the discs."""

    kind: Literal["rigid", "shares"] = quantity("Coupling of the satellites", default="rigid")
    """Rigid: all satellites have one lag; shares: each satellite carries a given share."""
