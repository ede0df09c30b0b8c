"""The output mechanism as it is made: its sizes, clearance, deviations and elasticity.

Every satellite is a rigid disc, held by its crank and turned by the ring, or by bearings and meshes
that give. The output lags behind its ideal angle; the approach of each pair follows from that, a
force from each approach, and the torque of all forces must be the load.
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
    """A mechanism with its sizes, clearance, deviations and elasticity."""

    mechanism: Mechanism
    pin_circle_radius: float  # R, m, > 0
    pin_radius: float  # r_p, m, > 0
    eccentricity: float  # e, m, > 0
    contact_length: float  # b, m, > 0
    law: ContactLaw  # of contact of each pair
    pin_material: ElasticMaterial  # of the pins, or of what is on them
    hole_material: ElasticMaterial  # of the satellites
    clearance: float = 0.0  # radial, c, m: hole less pin radius less e; < 0 is interference
    pin: Pins = RIGID_PINS  # how they are held
    deviations: Deviations = field(default_factory=Deviations)
    # Exact geometry; else first order in lag and deviations, fixed lines of action.
    exact: bool = True
    # What the satellites' bearings or mesh give.
    support: SatelliteSupport = RIGID_SUPPORT
    # What rollers give to either side on their pins, m: in the play, not in the curvatures.
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
        """Whether all pins are alike, and all holes of a satellite."""
        own = self.deviations
        pins = own.pin_radial, own.pin_tangential, own.pin_radius
        holes = own.hole_radial, own.hole_tangential, own.hole_radius
        return not any(map(any, pins)) and not any(any(map(any, each)) for each in holes)

    @property
    def curve(self) -> Curve:
        """Approach over force of contacts that wrap."""
        return law_curve(
            law=self.law,
            contact_length=self.contact_length,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    @property
    def table(self) -> FloatArray:
        """Constants of contacts that wrap, as the engine takes them."""
        wrap = conformal_wrap(
            contact_length=self.contact_length, pin=self.pin_material, hole=self.hole_material
        )
        return table_of(curve=self.curve, wrap=wrap)

    @property
    def law_constants(self) -> Law:
        """Constants of the law, of which each pair's are made."""
        return law_constants(
            law=self.law,
            contact_length=self.contact_length,
            hole_radius=self.pin_radius + self.eccentricity + self.clearance,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    @property
    def _joined(self) -> bool:
        """True where each pin is bent by several discs at once, or by a ring."""
        return self.pin.tied or (self.pin.bends and self.mechanism.satellites > 1)

    @property
    def compliance(self) -> list[float]:
        """In series with the contacts at each satellite, m/N: of the wall about a pin's bore, and
        of a pin that this satellite alone bends.
        """
        bent = self.pin.bending(self.mechanism.satellites)
        wall = self.pin.wall_compliance(self.contact_length)
        return [wall + (0.0 if self._joined else each) for each in bent]

    @property
    def springs(self) -> Springs:
        """What gives besides the contacts."""
        bending = self.pin.spring if self._joined else None
        return Springs(self.support.bearing, self.support.mesh, bending)

    @cached_property
    def rooms(self) -> Rooms:
        """The geometry: pins in their holes."""
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
        """Deviations as rows of one piece, whose discs are put onto the pins by the holes that lie
        next to them.
        """
        own = self.mechanism
        rows = self.rooms.numbered[0].rows(own.pins, own.satellites)
        return Errors(*[np.array([each]) for each in rows])

    @cached_property
    def drive(self) -> Pieces:
        """The mechanism as the engine takes it."""
        found = output_pieces(output=self, errors=self.errors)
        radius, own = found.cf[0, :, engine.RAD], found.gf[0, :, engine.ECC]
        least = np.minimum(radius, self.eccentricity + found.cf[0, :, engine.WIDER])
        none = np.minimum(least, own.repeat(self.mechanism.pins)) <= 0
        if none.any():
            j, n = divmod(int(none.argmax()), self.mechanism.pins)
            raise ImpossibleMechanism("no_room_in_hole", satellite=j + 1, pin=n + 1)
        return found

    @property
    def phases(self) -> list[float]:
        """Angles of the cranks with their errors, rad."""
        errors = self.deviations.crank_phase or (0.0,) * self.mechanism.satellites
        return [each + more for each, more in zip(self.mechanism.crank_angles, errors, strict=True)]

    @property
    def pin_radii(self) -> FloatArray:
        """Radius of each pair's pin, m, shape (K*N,)."""
        return np.asarray(self.drive.cf[0, :, engine.RAD])

    @property
    def differences(self) -> FloatArray:
        """By how much each hole's radius is larger than its pin's, m, shape (K*N,)."""
        return np.asarray(self.eccentricity + self.drive.cf[0, :, engine.WIDER])

    @property
    def curved(self) -> FloatArray:
        """Difference of the curvatures of each pair, 1/m, shape (K*N,)."""
        return np.asarray(self.drive.cf[0, :, engine.CURVED])

    def contact(self, pair: int, force: float) -> HertzContact:
        """Contact of a pair.

        Parameters
        ----------
        pair : int
            Its index, satellite by satellite.
        force : float
            Its force, N.

        Returns
        -------
        HertzContact
        """
        return self._contact(force, float(self.pin_radii[pair]), float(self.differences[pair]))

    def contacts(self, force: Sequence[float]) -> HertzContact:
        """The same of all pairs, as arrays.

        Parameters
        ----------
        force : sequence of float, K*N
            Force of each pair, N.

        Returns
        -------
        HertzContact
        """
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
        """Largest pressure of each pair, where that of each is known.

        Parameters
        ----------
        force : tuple of tuple of float, K x N
            Force of each pair, N.

        Returns
        -------
        tuple of tuple of float, K x N, or None
            Pressures, Pa.
        """
        pressures = self.contacts([each for row in force for each in row]).governing
        return None if np.isnan(pressures).any() else self.rows(pressures.tolist())

    def hardest_pair(self, force: Sequence[float]) -> int:
        """Index of the pair with the largest pressure. Of narrow contacts it grows with the force
        times the difference of the curvatures; a pressure that is not known is the largest.

        Parameters
        ----------
        force : sequence of float, K*N
            Force of each pair, N.

        Returns
        -------
        int
        """
        contacts = self.contacts(force)
        if _wrap(contacts):
            pressure = contacts.governing
            unknown = np.isnan(pressure)
            return int(np.argmax(force if unknown.all() else np.where(unknown, math.inf, pressure)))
        return int((np.array(force) * self.curved).argmax())

    def wraps(self, force: Sequence[float]) -> bool:
        """Whether any pair wraps, so that its pressure is not Hertz's.

        Parameters
        ----------
        force : sequence of float, K*N
            Force of each pair, N.

        Returns
        -------
        bool
        """
        return _wrap(self.contacts(force))

    def hardest(self, force: Sequence[float]) -> HertzContact:
        """Contact of the pair with the largest pressure.

        Parameters
        ----------
        force : sequence of float, K*N
            Force of each pair, N.

        Returns
        -------
        HertzContact
        """
        pair = self.hardest_pair(force)
        return self.contact(pair, force[pair])


def _wrap(contacts: HertzContact) -> bool:
    """Whether the pressure of any of some contacts is not Hertz's."""
    return bool((contacts.governing != contacts.max_pressure).any())
