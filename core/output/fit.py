"""Misfits of pins in their holes, and how much of a misfit elasticity takes up."""

from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Literal

import numpy as np

from core.drive import engine
from core.errors import ImpossibleMechanism, NotKnown, if_known
from core.hertz import force_factor
from core.output.elasticity import approach_under
from core.output.real_mechanism import RealMechanism
from core.output.room import Binding, Rooms
from core.precision import AS_TYPED

Misfit = Literal[
    "", "fits_by_bearing_clearance", "pressed_without_load", "jams", "discs_out_of_phase",
    "cannot_assemble",
]  # fmt: skip
"""Kind of a misfit, a key of `core.codes.CODES`; empty where all pins fit."""

FITS: tuple[Misfit, ...] = ("", "fits_by_bearing_clearance")
"""Kinds of `Misfit` with which pins fit into their holes."""

NO_TORQUE = 1e-9
"""Part of the torque at the elastic limit that stands for no torque."""


@dataclass(frozen=True, slots=True)
class Elastic:
    """Elastic limit of the pairs, and forces of parts pressed without load; None if not known."""

    limit: float | None  # largest approach that a pair takes elastically, m
    limit_force: float | None  # force of that pair at this approach, N
    # Largest force of a pair where the room is least and parts press without load, N.
    force_without_load: float | None
    pressure_without_load: float | None  # largest pressure under these forces, Pa


@dataclass(frozen=True)
class Fit:
    """Misfit of the pins of a mechanism in their holes, and what follows from it."""

    rooms: Rooms  # room of the pins by geometry alone
    real: RealMechanism  # mechanism of these sizes, under any torque

    @cached_property
    def forces_at_limit(self) -> tuple[float, ...]:
        """Force of each pair, N, satellite by satellite, at which the pressure reaches the limit at
        rest of the weaker body; empty where neither limit is known.
        """
        real, known = self.real, list[float]()
        for material in (real.pin_material, real.hole_material):
            with suppress(NotKnown):
                known.append(material.elastic_pressure)
        if not known:
            return ()
        found, limit = dict[tuple[float, float], float](), min(known)
        sizes = [*zip(real.pin_radii.tolist(), real.differences.tolist(), strict=True)]
        for pair, size in enumerate(sizes):
            if size not in found:
                under = partial(real.contact, pair)
                found[size] = force_factor(contact=under(1.0), contact_at=under, limit=limit)
        return tuple(found[size] for size in sizes)

    @cached_property
    def _approaches_at_limit(self) -> list[float]:
        """Approach of each pair under `forces_at_limit`, m; empty where these are not known."""
        real, forces = self.real, self.forces_at_limit
        if not forces:
            return []
        a, b = real.drive.cf[0, :, [engine.A, engine.B]]
        under = approach_under(law=real.law, curve=real.curve, force=np.array(forces), a=a, b=b)
        return [*map(float, under)]

    @cached_property
    def impossible(self) -> bool:
        """True if no elastic state exists: at any lag some pair is pressed in by more than its
        bodies bear. False where no limit is known, unless a hole is no larger than its pin.
        """
        short = self._short
        if not short or self.rooms.closed:
            return short > 0
        approaches = self._approaches_at_limit
        return bool(approaches) and short > max(approaches)

    @property
    def _short(self) -> float:
        """Missing radius of the holes beyond the crank bearings' free travel, m, at least 0."""
        nothing = AS_TYPED * (self.real.pin_radius + self.real.eccentricity)
        short = -self.rooms.room.least - self.real.support.loose
        return short if short > nothing else 0.0

    @cached_property
    def misfit(self) -> Misfit:
        """Kind of misfit: "pressed_without_load" if, where the room is least, every pair bears its
        force, or forces balance and no limit is known.
        """
        if self.rooms.room.state == "fits":
            return ""
        if self.rooms.room.state == "no_bound":
            return "cannot_assemble"
        if not self._short:
            return "fits_by_bearing_clearance"
        if not self.impossible and self._pressed():
            return "pressed_without_load"
        if self.rooms.room.state == "binds_in_turning":
            return "jams"
        several = self.real.mechanism.satellites > 1
        if several and all(disc.least_room >= 0 for disc in self.rooms.discs()):
            return "discs_out_of_phase"
        return "cannot_assemble"

    @cached_property
    def forces_without_load(self) -> tuple[float, ...]:
        """Force of each pair, N, satellite by satellite, where the room is least and no torque
        loads the output; empty where no forces balance there.
        """
        real = self.real
        psi = real.wave(self.rooms.room.crank_angle or 0.0)
        torque = NO_TORQUE * real.pin_circle_radius * min(self.forces_at_limit or (1.0,))
        try:
            room = real.solved([psi], torque)
        except ImpossibleMechanism:
            return ()
        return tuple(room.forces[0].tolist())

    def _pressed(self) -> bool:
        """True if every pair bears its force without load at the position of the least room or,
        with no known limit, if forces balance there.
        """
        forces, limits = self.forces_without_load, self.forces_at_limit
        within = (force <= limit for force, limit in zip(forces, limits, strict=bool(limits)))
        return bool(forces) and all(within)

    @property
    def elastic(self) -> Elastic:
        """Limits of the elastic approach, and forces if parts press without load and may do so
        elastically. All are None if a hole is no larger than its pin.
        """
        if self.rooms.closed:
            return Elastic(None, None, None, None)
        approaches = zip(self._approaches_at_limit, self.forces_at_limit, strict=True)
        limit, force = max(approaches, key=lambda each: each[0], default=(None, None))
        forces = self.forces_without_load if self._short and not self.impossible else ()
        return Elastic(
            limit=limit,
            limit_force=force,
            force_without_load=max(forces, default=None),
            pressure_without_load=if_known(lambda: self.real.hardest(forces).governing_pressure)
            if forces
            else None,
        )

    def refusal(self) -> ImpossibleMechanism:
        """Refusal of a mechanism that cannot be assembled, with the hole radius needed."""
        room, where = self.rooms.room, self.rooms.room.where
        (pair, *_) = room.binding if where else (Binding(1, 1, "radial"),)  # all alike: any
        return ImpossibleMechanism(
            "cannot_assemble",
            where,
            parameter="deviations" if where and self.real.clearance >= 0 else "hole_radius",
            satellite=pair.satellite,
            pin=pair.pin,
            missing_length=-room.least,
            needed_length=self.rooms.needed_hole_radius,
        )


def solvable(*, real: RealMechanism, rooms: Rooms | None = None) -> Fit:
    """Fit of the pins of a mechanism whose forces may be solved.

    Elasticity of a ring in which discs turn may take up a misfit too, so that with `rooms` of such
    discs a missing elastic state is not refused. `ImpossibleMechanism` is raised if a hole is no
    larger than its pin, if pins could pass from one hole into the next or around the satellite's
    centre, or if no elastic state exists.
    """
    fit = Fit(rooms or real.rooms, real)
    real.rooms.refuse_without_bound()
    real.drive  # noqa: B018 - refuses holes that are no larger than their pins
    if not rooms and fit.impossible:
        raise fit.refusal()
    return fit
