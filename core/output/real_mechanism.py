"""Output mechanism as made: sizes, clearance, deviations and elasticity.

Every satellite is a rigid disc, held by its crank and turned by the ring, or by bearings and meshes
that give. The output lags behind its ideal angle. The lag gives the approach of each pair, the
approaches give the forces, and the torque of all forces must be the load.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from core.arrays import FloatArray, Number, check_finite, check_positive, check_single
from core.drive import engine
from core.drive.model import Pieces, Springs
from core.errors import ImpossibleMechanism, InvalidInput
from core.hertz import ElasticMaterial, HertzContact, hertz
from core.numerics.extremes import first_largest
from core.output.conformal_law import Curve, conformal_wrap, table_of
from core.output.drives import output_pieces
from core.output.elasticity import (
    RIGID_PINS,
    RIGID_SUPPORT,
    ContactLaw,
    Law,
    Pins,
    SatelliteSupport,
    check_law,
    law_constants,
    law_curve,
)
from core.output.mechanism import Mechanism
from core.output.room import Deviations, Errors, Rooms
from core.output.stage import Stage


@dataclass(frozen=True)
class RealMechanism(Stage):
    """Output mechanism with its sizes, clearance, deviations and elasticity."""

    mechanism: Mechanism
    pin_circle_radius: float  # R, m, > 0
    pin_radius: float  # r_p, m, > 0
    eccentricity: float  # e, m, > 0
    contact_length: float  # b, m, > 0
    law: ContactLaw  # contact law of each pair
    pin_material: ElasticMaterial  # material of the pins, or of their sleeves or rollers
    hole_material: ElasticMaterial  # material of the satellites
    clearance: float = 0.0  # radial, c, m: hole less pin radius less e; < 0 is interference
    pin: Pins = RIGID_PINS  # elasticity of the pins by their support
    deviations: Deviations = field(default_factory=Deviations)
    # True for exact geometry; False for fixed lines of action, to the first order in lag and
    # deviations.
    exact: bool = True
    # Elasticity of the satellites' bearings and mesh.
    support: SatelliteSupport = RIGID_SUPPORT
    # Play of rollers on their pins to either side, m; it does not change the curvatures.
    roller_play: float = 0.0

    def __post_init__(self) -> None:
        sizes = {
            name: getattr(self, name)
            for name in ("pin_circle_radius", "pin_radius", "eccentricity", "contact_length")
        }
        check_single(**sizes, clearance=self.clearance, roller_play=self.roller_play)
        check_positive(**sizes)
        check_finite(**sizes, clearance=self.clearance)
        if not self.eccentricity < self.pin_circle_radius:
            than = {"field": "pin_circle_radius", "limit": self.pin_circle_radius}
            raise InvalidInput("eccentricity", self.eccentricity, "smaller_than", **than)
        check_law(self.law)
        self.support.check(self.mechanism.satellites)

    @property
    def pins_alike(self) -> bool:
        """True if all pins are alike, and all holes of a satellite."""
        own = self.deviations
        pins = own.pin_radial, own.pin_tangential, own.pin_radius
        holes = own.hole_radial, own.hole_tangential, own.hole_radius
        return not any(map(any, pins)) and not any(any(map(any, each)) for each in holes)

    @property
    def curve(self) -> Curve:
        """Approach over force of contacts that wrap the pin."""
        return law_curve(
            law=self.law,
            contact_length=self.contact_length,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    @property
    def table(self) -> FloatArray:
        """Constants of contacts that wrap the pin, in the engine's form."""
        wrap = conformal_wrap(
            contact_length=self.contact_length, pin=self.pin_material, hole=self.hole_material
        )
        return table_of(curve=self.curve, wrap=wrap)

    @property
    def law_constants(self) -> Law:
        """Constants of the contact law at nominal sizes."""
        return law_constants(
            law=self.law,
            contact_length=self.contact_length,
            hole_radius=self.pin_radius + self.eccentricity + self.clearance,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    @property
    def _joined(self) -> bool:
        """True if several discs at once or a tie ring bend each pin."""
        return self.pin.tied or (self.pin.bends and self.mechanism.satellites > 1)

    @property
    def compliance(self) -> list[float]:
        """Compliance in series with the contacts at each satellite, m/N.

        The wall about a pin's bore adds to the bending of a pin that only this satellite loads.
        """
        bent = self.pin.bending(self.mechanism.satellites)
        wall = self.pin.wall_compliance(self.contact_length)
        return [wall + (0.0 if self._joined else each) for each in bent]

    @property
    def springs(self) -> Springs:
        """Elasticity besides that of the contacts."""
        bending = self.pin.spring if self._joined else None
        return Springs(self.support.bearing, self.support.mesh, bending)

    @cached_property
    def rooms(self) -> Rooms:
        """Room of the pins in their holes."""
        return Rooms(
            mechanism=self.mechanism,
            pin_circle_radius=self.pin_circle_radius,
            pin_radius=self.pin_radius,
            eccentricity=self.eccentricity,
            clearance=self.clearance,
            deviations=self.deviations,
            roller_play=self.roller_play,
            apart=bool(self.support.given_shares),
        )

    @property
    def errors(self) -> Errors[FloatArray]:
        """Deviations as rows of one piece, renumbered by the holes that come onto the pins."""
        own = self.mechanism
        rows = self.rooms.numbered[0].rows(own.pins, own.satellites)
        return Errors(*[np.array([each]) for each in rows])

    @cached_property
    def drive(self) -> Pieces:
        """Mechanism in the form that the engine takes; holes no larger than pins are refused."""
        found = output_pieces(output=self, errors=self.errors)
        radius, own = found.cf[0, :, engine.RAD], found.gf[0, :, engine.ECC]
        least = np.minimum(radius, self.eccentricity + found.cf[0, :, engine.WIDER])
        none = np.minimum(least, own.repeat(self.mechanism.pins)) <= 0
        if none.any():
            j, n = divmod(int(none.argmax()), self.mechanism.pins)
            raise ImpossibleMechanism("no_room_in_hole", satellite=j + 1, pin=n + 1)
        return found

    @property
    def pin_radii(self) -> FloatArray:
        """Radius of each pair's pin, m, shape (K*N,)."""
        return np.asarray(self.drive.cf[0, :, engine.RAD])

    @property
    def differences(self) -> FloatArray:
        """Hole radius less pin radius of each pair, m, shape (K*N,)."""
        return np.asarray(self.eccentricity + self.drive.cf[0, :, engine.WIDER])

    @property
    def curved(self) -> FloatArray:
        """Difference of the curvatures of each pair, 1/m, shape (K*N,)."""
        return np.asarray(self.drive.cf[0, :, engine.CURVED])

    def contact(self, pair: int, force: float) -> HertzContact:
        """Contact of the pair with this index, satellite by satellite, under a force, N."""
        return self._contact(force, float(self.pin_radii[pair]), float(self.differences[pair]))

    def contacts(self, force: Sequence[float]) -> HertzContact:
        """Contacts of all pairs under K*N forces, N, as arrays."""
        return self._contact(np.array(force), self.pin_radii, self.differences)

    def _contact(self, force: Number, radius: Number, apart: Number) -> HertzContact:
        return hertz(
            force=force,
            contact_length=self.contact_length,
            pin_radius=radius,
            hole_radius=radius + apart,
            pin_material=self.pin_material,
            hole_material=self.hole_material,
        )

    def pressures(
        self, force: tuple[tuple[float, ...], ...]
    ) -> tuple[tuple[float, ...], ...] | None:
        """Largest pressure of each pair, Pa, K x N, or None if any of them is not known."""
        pressures = self.contacts([each for row in force for each in row]).governing
        return None if np.isnan(pressures).any() else self.rows(pressures.tolist())

    def hardest_pair(self, force: Sequence[float]) -> int:
        """Index of the pair with the largest pressure; a pressure that is not known counts as the
        largest.

        The pressure of narrow contacts grows with the force times the difference of the curvatures.
        """
        contacts = self.contacts(force)
        if _wrap(contacts):
            pressure = contacts.governing
            unknown = np.isnan(pressure)
            return int(np.argmax(force if unknown.all() else np.where(unknown, math.inf, pressure)))
        return first_largest(np.array(force) * self.curved)

    def wraps(self, force: Sequence[float]) -> bool:
        """True if any pair wraps its pin, so that its pressure is not Hertz's."""
        return _wrap(self.contacts(force))

    def hardest(self, force: Sequence[float]) -> HertzContact:
        """Contact of the pair with the largest pressure."""
        pair = self.hardest_pair(force)
        return self.contact(pair, force[pair])


def _wrap(contacts: HertzContact) -> bool:
    """True if the pressure of any contact is not Hertz's."""
    return bool((contacts.governing != contacts.max_pressure).any())
