"""The output mechanism as it is made: its sizes, clearance, deviations and elasticity.

Every satellite is a rigid disc, held by its crank and turned by the ring. The one unknown is the
lag of the output behind its ideal angle; the approach of each pair follows from it, a force from
each approach, and the torque of all forces must be the load.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from core.arrays import Number, check_finite, check_positive, check_single
from core.errors import ImpossibleMechanism, InvalidInput
from core.hertz import ElasticMaterial, HertzContact, hertz
from core.output.compiled import PLAIN, at_hand
from core.output.conformal_law import conformal_wrap
from core.output.elasticity import (
    RIGID_PINS,
    RIGID_SUPPORT,
    ContactLaw,
    Pins,
    SatelliteSupport,
    Shares,
    check_law,
    law_constants,
    law_curve,
    law_kind,
)
from core.output.loop_rows import TIED, Law, Pairs, Room, Setup, Wrap
from core.output.mechanism import Mechanism
from core.output.room import Deviations, Rooms
from core.output.sharing_kernel import prepare
from core.output.stage import Stage, blank_rows, in_floats


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
    # What the satellites' bearings or mesh give, in first order.
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
        if self.support.first_order and self.exact:
            raise InvalidInput("exact", self.exact, "first_order_only", field="support")
        self.support.check(self.mechanism.satellites)
        if self.pin.tied and self.exact:
            raise InvalidInput("exact", self.exact, "first_order_only", field="pin.support")
        if self.pin.tied and self.support.first_order:
            raise InvalidInput("support", self.support, "only_one", field="pin.support")

    @property
    def pins_alike(self) -> bool:
        """Whether all pins are alike, and all holes of a satellite."""
        own = self.deviations
        pins = own.pin_radial, own.pin_tangential, own.pin_radius
        holes = own.hole_radial, own.hole_tangential, own.hole_radius
        return not any(map(any, pins)) and not any(any(map(any, each)) for each in holes)

    def setup(self, direction: float) -> Setup:
        """The design as the kernel takes it.

        Parameters
        ----------
        direction : float
            Of the torque: 1, or -1 in reverse.

        Returns
        -------
        Setup
        """
        kind, exponent = law_kind(self.law)
        return in_floats(
            Setup(
                pins=self.mechanism.pins,
                satellites=self.mechanism.satellites,
                ratio=self.mechanism.ratio,
                exact=self.exact,
                radius=self.pin_circle_radius,
                pin_radius=self.pin_radius,
                eccentricity=self.eccentricity,
                clearance=self.clearance,
                direction=direction,
                law=kind,
                exponent=exponent,
                curve=law_curve(
                    law=self.law,
                    contact_length=self.contact_length,
                    pin=self.pin_material,
                    hole=self.hole_material,
                ),
                wrap=self.wrap,
                support=TIED if self.pin.tied else self.support.kind,
                gives=self.support.gives,
                loose=self.roller_play + self.support.loose,
            )
        )

    @property
    def wrap(self) -> Wrap:
        """Largest pressures of contacts that wrap."""
        return conformal_wrap(
            contact_length=self.contact_length, pin=self.pin_material, hole=self.hole_material
        )

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
    def compliance(self) -> list[float]:
        """Of the pin at each satellite, with the wall about its bore, m/N; where a tie ring joins
        the pins what `tied_compliance` gives.
        """
        own = self.mechanism
        return self.pin.compliance(
            satellites=own.satellites, contact_length=self.contact_length, pins=own.pins
        )

    @property
    def outward(self) -> list[float]:
        """Directions of the pins from the middle, ``-sin, cos`` of their angles, [N, 2]."""
        angles = [2 * math.pi * n / self.mechanism.pins for n in range(self.mechanism.pins)]
        return [each for angle in angles for each in (-math.sin(angle), math.cos(angle))]

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
            apart=isinstance(self.support, Shares),
        )

    @cached_property
    def _prepared(self) -> tuple[Pairs, list[float]]:
        """Constants of the pairs, and their pins' radii."""
        pins, satellites = self.mechanism.pins, self.mechanism.satellites
        errors = self.rooms.numbered[0].rows(pins, satellites)
        pairs: Pairs = self.blank(Pairs)
        phase = list(self.mechanism.crank_angles)
        setup = self.setup(1.0)
        given = setup, self.law_constants, errors, phase, self.compliance, self.outward
        none = prepare(*given, pairs)
        if none >= 0:
            j, n = divmod(none, pins)
            raise ImpossibleMechanism("no_room_in_hole", satellite=j + 1, pin=n + 1)
        return pairs, [self.pin_radius + error for error in errors.pin_radius] * satellites

    @property
    def pairs(self) -> Pairs:
        """Constants of the pairs."""
        return self._prepared[0]

    @property
    def pin_radii(self) -> list[float]:
        """Radius of each pair's pin, m."""
        return self._prepared[1]

    def room(self) -> Room:
        """Room for the results of one position."""
        room: Room = self.blank(Room)
        return room

    def blank(self, kind: Any) -> Any:
        """Rows of zeros for the kernel.

        Parameters
        ----------
        kind : type
            `Pairs` or `Room`.

        Returns
        -------
        Pairs or Room
        """
        pins, satellites = self.mechanism.pins, self.mechanism.satellites
        square = (pins * satellites) ** 2 if self.pin.tied else 0
        sizes = {"give": square, "system": 2 * square}
        shares = self.support.given_shares
        return blank_rows(kind, pins=pins, satellites=satellites, shares=shares, **sizes)

    @property
    def loops(self) -> Any:
        """The functions of `core.output.sharing_kernel`, interpreted."""
        return PLAIN

    @property
    def loops_of_turns(self) -> Any:
        """The same, compiled where they can be."""
        return at_hand()

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
        return self._contact(force, self.pin_radii[pair], self.pairs.distance[pair])

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
        return self._contact(*map(np.array, (force, self.pin_radii, self.pairs.distance)))

    def _contact(self, force: Number, radius: Number, apart: Number) -> HertzContact:
        if self.exact:
            apart = apart - self.roller_play  # which lets the centres move, not the radii grow
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
        curved = [f * curved for f, curved in zip(force, self.pairs.curved, strict=True)]
        return curved.index(max(curved))

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
