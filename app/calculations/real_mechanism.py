"""The output mechanism as it is made, as a request gives it."""

import math
from collections import ChainMap
from collections.abc import Iterator
from functools import cached_property, partial
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, field_validator, model_validator

from app.calculations.contact_force import TorqueFields
from app.calculations.hertz import Material, distribution_factor, eccentricity, material_of
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.pin import HeldPinFields
from app.calculations.pin_contact import Deviation, PinContactFields
from app.model import LARGEST, NO_DUST, Maybe, RequestModel, Size, no_dust, quantity
from app.problems import invalid_input, refusal, wrong
from app.rules import Kinds, field_error
from app.units import to_si
from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    ElasticMesh,
    PinSupport,
    SatelliteSupport,
    Shares,
)
from core.output.real_mechanism import Deviations
from core.output.sampled_turn import Direction
from core.precision import SAME

Phase = Annotated[float, Field(ge=-360, le=360)]

MAX_LISTED_PINS = 1000
"""Most pins whose deviations are listed one by one."""


torque_direction = partial(
    quantity,
    "Direction of the torque",
    default="driving",
    help="Driving: the satellites turn the pins; reverse: the load turns them back; alternating: "
    "both are solved, and the worse is given.",
)


class RealLoadFields(TorqueFields, group="load"):
    """Torque, its direction, and its lever; the force exponent is that of the contact law."""

    torque_direction: Direction = torque_direction()

    def signed_torque(self, torque: float) -> float:
        """A torque with the sign of its direction, N*m."""
        return -torque if self.torque_direction == "reverse" else torque


class OneWayLoadFields(RealLoadFields, group="study"):
    """Torque in one direction."""

    torque_direction: Literal["driving", "reverse"] = quantity(
        "Direction of the torque", default="driving"
    )
    """Driving: the satellites turn the pins; reverse: the load turns them back."""


class RealContactFields(PinContactFields, group="contact"):
    """Pin, hole, crank and clearance. Forces and pressures are those at the torque: the dynamic
    factor is for checks.
    """

    eccentricity_mm: Size = eccentricity()
    distribution_factor: float = distribution_factor(ge=1e-12, le=1)

    def sizes(self) -> dict[str, Any]:
        """Sizes and materials in SI units, as the core's arguments."""
        return {
            "contact_length": to_si("contact_length_mm", self.contact_length_mm),
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "eccentricity": to_si("eccentricity_mm", self.eccentricity_mm),
            "clearance": to_si("clearance_mm", self.clearance_mm()),
            "pin_material": material_of(self.pin_material),
            "hole_material": material_of(self.hole_material),
        }


class BentPinFields(HeldPinFields, group="pin"):
    """How the pins are held, and where the satellites load them."""

    diameter_mm: Maybe[Size] = quantity("Pin diameter", "d", step=0.5)
    """Diameter of the pin itself, inside its sleeve or its rollers where it has them."""
    bore_diameter_mm: float = quantity(
        "Bore of the pin", "d_i", default=0.0, step=0.5, ge=0, le=LARGEST, schema=NO_DUST
    )
    """Diameter of its bore, up to 0.95 of its own; 0 of a solid pin."""
    material: Maybe[Material] = quantity("Material of the pin")
    """A name of the table of materials, or values; that of the contact where it has one."""

    _bore_size = field_validator("bore_diameter_mm")(no_dust)

    def held(self, *around: dict[str, Any]) -> PinSupport:
        """The pin in SI units.

        Parameters
        ----------
        *around : dict
            Diameter, m, and material of what is around it, the nearest first, which it has where
            its own are not given.

        Returns
        -------
        PinSupport
        """
        own = ChainMap(self.to_core(), *around)
        return PinSupport(
            support=self.support,
            diameter=own["diameter"],
            satellite_positions=own.get("satellite_positions", ()),
            material=material_of(own["material"]),
            span=own.get("span"),
            bore_diameter=own["bore_diameter"],
            ring_joint=self.ring_joint or "pinned",
        )


class CrankSupportFields(RequestModel, group="crank_support"):
    """Bearings of the satellites on their cranks. The gear's force on them is left out."""

    stiffness_N_per_mm: Maybe[Size] = quantity("Stiffness of a bearing", "k_b", step=10_000)
    """Radial stiffness of the bearing of one satellite; rigid where not given."""
    radial_clearance_mm: float = quantity(
        "Clearance of a bearing", "G", default=0.0, step=0.005, ge=0, le=LARGEST
    )
    """Radial internal clearance, as catalogues give it: half of it to either side."""

    gives: ClassVar[bool] = True

    def section(self, _: Any = None) -> CrankSupport:
        """The bearings in SI units."""
        return CrankSupport(**self.to_core())


CouplingKind = Literal["rigid", "elastic", "shares"]


class SatelliteCouplingFields(RequestModel, group="satellite_coupling"):
    """How the satellites share the torque."""

    KINDS: ClassVar[Kinds] = {
        "rigid": ((), ()),
        "elastic": (("stiffness_Nm_per_arcmin",), ()),
        "shares": (("shares",), ()),
    }

    kind: CouplingKind = quantity("Coupling of the satellites", default="rigid")
    """Rigid: all turn as one; elastic: each gives in its mesh with the ring; shares: each carries a
    given share."""
    stiffness_Nm_per_arcmin: Maybe[Size] = quantity("Stiffness of a mesh", "k_D", step=1)
    """Torque of one satellite over what its mesh lets it turn, for elastic coupling."""
    shares: Maybe[list[Annotated[float, Field(ge=1e-6, le=1)]]] = quantity(
        "Shares of the torque", "w_j", min_length=1, max_length=MAX_SATELLITES
    )
    """Share of each satellite, together 1."""

    @model_validator(mode="after")
    def _shares_of_one(self) -> Self:
        total = math.fsum(self.shares or [1.0])
        if abs(total - 1) > SAME:
            raise field_error("shares", "sum_not_one", sum=total)
        return self

    @property
    def gives(self) -> bool:
        """Whether the satellites give by it."""
        return self.kind != "rigid"

    def section(self, _: Any = None) -> SatelliteSupport:
        """The coupling in SI units."""
        match self.to_core():
            case {"stiffness": stiffness}:
                return ElasticMesh(stiffness)
            case {"shares": shares}:
                return Shares(tuple(shares))
        return RIGID_SUPPORT


GIVING = ("crank_support", "satellite_coupling")
"""Sections that say what the satellites give."""


class GivingFields(RequestModel):
    """What the satellites give, in one way."""

    crank_support: Maybe[CrankSupportFields] = None
    satellite_coupling: Maybe[SatelliteCouplingFields] = None

    @model_validator(mode="after")
    def _gives_in_one_way(self) -> Self:
        giving = self.giving
        if len(giving) > 1:
            raise field_error("satellite_coupling", "only_one", field="crank_support")
        if self.tied and giving:
            raise field_error("pin/support", "only_one", field=giving[0])
        return self

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Also the material of pins where it is not given: that of the contact."""
        yield from super().assumed()
        match self.given:
            case {"pin": BentPinFields(material=None), "contact": PinContactFields() as contact}:
                given = contact.pin_material
                values = given if isinstance(given, str) else given.model_dump(exclude_none=True)
                yield ("pin", "material"), values

    @property
    def around_pins(self) -> list[dict[str, Any]]:
        """What pins have where they do not say it, by what is around them, the nearest first."""
        given = self.given
        return [given[name].surface for name in ("rollers", "contact") if name in given]

    def refuse_of_a_coupling(self, *sections: str) -> None:
        """Refuse sections that two shafts which pins couple have none of.

        Parameters
        ----------
        *sections : str
            Their names.

        Raises
        ------
        PydanticCustomError
            If any is given.
        """
        for name in sections:
            if self.says(name):
                raise field_error(name, "of_other_output", output="coupling")

    @property
    def tied(self) -> bool:
        """Whether a tie ring joins the pins."""
        pin = getattr(self, "pin", None)
        return getattr(pin, "support", None) == "tie_ring"

    @property
    def giving(self) -> list[str]:
        """Sections by which the satellites give."""
        given = self.given
        return [name for name in GIVING if name in given and given[name].gives]

    @cached_property
    def support(self) -> SatelliteSupport:
        """What the satellites give."""
        return next((self.given[name].section() for name in self.giving), RIGID_SUPPORT)

    def refuse_other_shares(self, satellites: int) -> None:
        """Refuse shares that are not one for each satellite.

        Parameters
        ----------
        satellites : int
            Their number.

        Raises
        ------
        Problem
            If they are not.
        """
        if isinstance(self.support, Shares) and len(self.support.shares) != satellites:
            counts = {"expected": satellites, "actual": len(self.support.shares)}
            raise refusal("/satellite_coupling/shares", "different_length", **counts)


OF_PINS = Field(min_length=1, max_length=MAX_LISTED_PINS)
OF_SATELLITES = Field(min_length=1, max_length=MAX_SATELLITES)

PerPin = Annotated[list[Deviation], OF_PINS]
PerHole = Annotated[list[PerPin], OF_SATELLITES]
PerSatellite = Annotated[list[Deviation], OF_SATELLITES]
PhasePerSatellite = Annotated[list[Phase], OF_SATELLITES]


class DeviationsFields(RequestModel, group="deviations"):
    """What a piece deviates from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc. Positive: outward, in the driving sense, larger, ahead.
    """

    pin_radial_mm: Maybe[PerPin] = quantity("Pins outward", "ρ", step=0.001)
    """Of each pin, outward."""
    pin_tangential_mm: Maybe[PerPin] = quantity("Pins along the circle", "τ", step=0.001)
    """Of each pin, in the driving sense."""
    pin_radius_mm: Maybe[PerPin] = quantity("Pin radii", "Δr", step=0.001)
    """Of each pin's radius."""
    hole_radial_mm: Maybe[PerHole] = quantity("Holes outward", "ρ_j", step=0.001)
    """Of each hole, outward, a list for each satellite."""
    hole_tangential_mm: Maybe[PerHole] = quantity("Holes along the circle", "τ_j", step=0.001)
    """The same in the driving sense."""
    hole_radius_mm: Maybe[PerHole] = quantity("Hole radii", "Δr_j", step=0.001)
    """Of each hole's radius."""
    eccentricity_mm: Maybe[PerSatellite] = quantity("Eccentricities", "Δe", step=0.001)
    """Of each crank."""
    crank_phase_deg: Maybe[PhasePerSatellite] = quantity("Crank phases", "Δα", step=0.001)
    """Angle of each crank, positive ahead."""
    disc_phase_deg: Maybe[PhasePerSatellite] = quantity("Disc phases", "η", step=0.001)
    """Angle of each disc's holes against its teeth, positive ahead."""

    def section(self, _: Any = None) -> Deviations:
        """The deviations in SI units."""

        def fixed(value: Any) -> Any:
            return tuple(map(fixed, value)) if isinstance(value, list) else value

        return Deviations(**{name: fixed(value) for name, value in self.to_core().items()})

    def refuse_other_lengths(self, pins: int, satellites: int) -> None:
        """Refuse lists that do not fit the mechanism.

        Raises
        ------
        Problem
            If there are.
        """
        errors = [
            wrong(f"/deviations/{place}", "different_length", expected=want, actual=have)
            for place, want, have in self._lengths(pins, satellites)
            if want != have
        ]
        if errors:
            raise invalid_input(errors)

    def _lengths(self, pins: int, satellites: int) -> Iterator[tuple[str, int, int]]:
        for name, value in self.given.items():
            if name.startswith("ring"):
                continue
            if not name.startswith("hole"):
                yield name, pins if name.startswith("pin") else satellites, len(value)
                continue
            yield name, satellites, len(value)
            for index, row in enumerate(value):
                yield f"{name}/{index}", pins, len(row)
