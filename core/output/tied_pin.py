"""Pins that a floating tie ring joins, under the forces of a turn: the ring is one load more."""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.output.contact_force import force_ratios
from core.output.loaded_pin import LoadedPin
from core.output.mechanism import Mechanism
from core.output.sampled_turn import PinForces, PinsMade, SampledTurn, off_straight
from core.output.tie_ring import RingForces, TieRing, ring_forces

SAMPLES, PER_PAIR = 1440, 24
"""Samples of ideal forces over the turn at least, and for each pair."""

BESIDE = 1e-9
"""How far on both sides of a switching angle ideal forces are sampled, rad."""

CLOSER = 16
"""How often what lies beside a largest value is halved."""


@dataclass(frozen=True, slots=True)
class TieRingLoad:
    """What a tie ring bears over the turn, each where it is largest."""

    peak_force: float  # X of the ring on a pin, N
    peak_end_moment: float  # at the end of a pin, N*m; 0 where the joint is pinned
    shift: float  # how far its middle moves, m
    turn: float  # how far it turns about the axis against the carrier, rad


@dataclass(frozen=True)
class TiedPin(LoadedPin):
    """A pin that a tie ring holds at its end: the last load is that of the ring."""

    ring: TieRing = field(kw_only=True)  # as the pin feels it

    def by_unit(self, what: str, x: FloatArray) -> FloatArray:
        """What a unit of each load does at sections, shape (..., K + 1)."""
        own, span, rigidity = super().by_unit(what, x), self.ring.span, self.ring.rigidity
        x = np.asarray(x)[..., None]
        # by the ring's force, and by a moment at the end
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
        """Moment of the ring on the end by a unit of each load, m, shape (K + 1,)."""
        return np.asarray(self.ring.end_moment(np.append(self.positions, self.ring.span)))

    def ring_forces(self, forces: ComplexArray) -> RingForces:
        """The ring under the forces of the satellites on all pins, shape (K, N, n)."""
        rings = [self.ring] * forces.shape[1]
        return ring_forces(rings=rings, positions=self.positions.tolist(), forces=forces)

    def held(self, turn: PinForces) -> PinForces:
        """Forces over a turn with those of the ring as the last of each pin."""
        by_ring = self.ring_forces(turn.on_pins).forces
        return replace(turn, on_pins=np.concatenate((turn.on_pins, by_ring[None])))

    def holding(self, made: PinsMade) -> PinsMade:
        """The same of the forces under each torque."""
        return lambda torque: self.held(made(torque))

    def ring_load(self, turns: list[PinForces], pin_circle_radius: float) -> TieRingLoad:
        """What the ring bears over turns that it holds, with the radius of the pin circle, m."""
        forces = np.concatenate([turn.on_pins for turn in turns], axis=2)
        moved = self.ring_forces(forces[:-1])
        moments = np.tensordot(self.end_moments, forces, axes=1)
        return TieRingLoad(
            peak_force=float(np.abs(forces[-1]).max()),
            peak_end_moment=float(np.abs(moments).max()),
            shift=float(np.abs(moved.shift).max()),
            turn=float(np.abs(moved.along).max()) / pin_circle_radius,
        )


def ideal_samples(
    torque: float,
    *,
    pin: TiedPin,
    mechanism: Mechanism,
    force_exponent: float,
    pin_circle_radius: float,
) -> SampledTurn:
    """Ideal forces over a turn, sampled; dense where the ring or the root of a pin bears most.

    Parameters
    ----------
    torque : float
        On the output link, N*m; negative in reverse.
    pin : TiedPin
        The pins.
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m.

    Returns
    -------
    SampledTurn

    Raises
    ------
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    cranks, first = np.array(mechanism.crank_angles), mechanism.initial_crank_angle
    radial = 1j * np.exp(2j * np.pi * np.arange(mechanism.pins) / mechanism.pins)

    def at(wave: FloatArray) -> SampledTurn:
        crank = 1j * np.exp(-1j * (wave + cranks[:, None]))[:, None]
        ratios = force_ratios(
            mechanism=mechanism,
            crank_angles=(wave - first) / mechanism.waves_per_turn,
            force_exponent=force_exponent,
        )
        acts = (torque / pin_circle_radius * ratios.transpose(1, 2, 0)) * crank
        tangential = (1j * radial)[:, None]
        on_pins = np.conj(acts / tangential)
        around = np.concatenate((on_pins[..., -1:], on_pins, on_pins[..., :1]), axis=-1)
        turn = 2 * np.pi
        beyond = np.concatenate(([wave[-1] - turn], wave, [wave[0] + turn]))
        off = float(off_straight(wave=beyond, values=around).max())
        return SampledTurn(
            wave=wave,
            on_pins=on_pins,
            on_satellites=np.conj((acts / crank).sum(axis=1)),
            total=np.abs(acts).sum(axis=(0, 1)),
            couple=pin_circle_radius * on_pins.real.sum(axis=1),
            crank_angles=mechanism.crank_angles,
            error=off / float(np.abs(acts).max()),
            evaluations=len(wave),
            unlike=1,
        )

    pairs = mechanism.pins * mechanism.satellites
    grid = np.linspace(0, 2 * np.pi, max(SAMPLES, PER_PAIR * pairs), endpoint=False)
    dead = np.arange(2 * mechanism.pins) * np.pi / mechanism.pins - cranks[:, None]
    beside = (dead.ravel()[:, None] + np.array([-BESIDE, BESIDE])).ravel()
    wave = first + np.unique(np.concatenate((grid, (beside - first) % (2 * np.pi))))
    places = np.append(pin.positions, pin.ring.span)
    measures = places + pin.end_moments, pin.end_moments, places == pin.ring.span
    for _ in range(CLOSER):
        alike = pin.held(at(wave)).on_pins[:, 0]
        between = []
        for arms in measures:
            top = int(np.abs(arms @ alike).argmax())
            around = np.take(wave, [top - 1, top, top + 1], mode="wrap")
            gaps = (np.diff(around) % (2 * np.pi)) / 2
            between += [wave[top] - gaps[0], wave[top] + gaps[1]]
        inside = first + (np.array(between) - first) % (2 * np.pi)
        wave = np.unique(np.concatenate((wave, inside)))
    return at(wave)


def section_of(*, position: float, span: float) -> str:
    """Where along a pin that a tie ring holds a section is.

    Parameters
    ----------
    position : float
        Of the section from the carrier's face, m.
    span : float
        Of the ring, m.

    Returns
    -------
    str
        ``"root"``, ``"ring"``, or ``""`` between them.
    """
    if math.isclose(position, span):
        return "ring"
    return "" if position else "root"
