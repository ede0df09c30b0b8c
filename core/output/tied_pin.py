"""Pins that a floating tie ring joins, under the forces of a turn; the ring is one more load."""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.fields import answer
from core.output.loaded_pin import LoadedPin
from core.output.sampled_turn import PinForces
from core.output.tie_ring import RingForces, TieRing, ring_forces


@dataclass(frozen=True, slots=True)
class TieRingLoad:
    """Largest loads and movements of a tie ring over the turn."""

    peak_force: float = answer("N", "X")
    """Largest force of the tie ring on a pin."""
    peak_end_moment: float = answer("Nm", "M_L")
    """Largest moment of the tie ring on the end of a pin; 0 if the joint is pinned."""
    shift: float = answer("mm", "U")
    """Largest displacement of the tie ring in its plane."""
    turn: float = answer("mrad", "ω")
    """Largest rotation of the tie ring relative to the carrier."""


@dataclass(frozen=True)
class TiedPin(LoadedPin):
    """Pin whose end a tie ring holds; the last load is that of the ring."""

    ring: TieRing = field(kw_only=True)  # ring as the pin feels it

    def by_unit(self, what: str, x: FloatArray) -> FloatArray:
        """Effect of a unit of each load at sections, shape (..., K + 1)."""
        own, span, rigidity = super().by_unit(what, x), self.ring.span, self.ring.rigidity
        x = np.asarray(x)[..., None]
        # effect of the ring's force, and of a moment at the end
        alone, by_moment = {
            "moment": (span - x, 1.0 + 0 * x),
            "shear": (1.0 + 0 * x, 0.0 * x),
            "slope": ((span * x - x * x / 2) / rigidity, x / rigidity),
            "deflection": (
                (span * x * x / 2 - x**3 / 6 + self.ring.shear_area * x) / rigidity,
                x * x / (2 * rigidity),
            ),
        }[what]
        return np.asarray(np.concatenate((own, alone), axis=-1) + by_moment * self.end_moments)

    @cached_property
    def end_moments(self) -> FloatArray:
        """Moment of the ring on the pin's end by a unit of each load, m, shape (K + 1,)."""
        return np.asarray(self.ring.end_moment(np.append(self.positions, self.ring.span)))

    def ring_forces(self, forces: ComplexArray) -> RingForces:
        """Ring under the forces of the discs on all pins, shape (K, N, n)."""
        rings = [self.ring] * forces.shape[1]
        return ring_forces(rings=rings, positions=self.positions.tolist(), forces=forces)

    def held(self, turn: PinForces) -> PinForces:
        """Forces over a turn with those of the ring as the last of each pin."""
        by_ring = self.ring_forces(turn.on_pins).forces
        return replace(turn, on_pins=np.concatenate((turn.on_pins, by_ring[None])))

    def ring_load(self, turns: list[PinForces], pin_circle_radius: float) -> TieRingLoad:
        """Largest loads of the ring over turns that it holds, for a pin circle radius, m."""
        found = []
        for turn in turns:
            moved = self.ring_forces(turn.on_pins[:-1])
            moments = np.tensordot(self.end_moments, turn.on_pins, axes=1)
            every = turn.on_pins[-1], moments, moved.shift, moved.along / pin_circle_radius
            found.append([float(turn.largest(np.abs(each)).max()) for each in every])
        return TieRingLoad(*map(max, zip(*found, strict=True)))


def section_of(*, position: float, span: float) -> str:
    """Name of a section of a pin with a tie ring: "root", "ring", or "" between them."""
    if math.isclose(position, span):
        return "ring"
    return "" if position else "root"
