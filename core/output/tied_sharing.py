"""Load sharing of pins that a floating tie ring joins: one position, first order.

Each force bends its pin under all satellites, and by the ring all other pins: the approaches are

    delta = h*lag - g - S*F,   F = law(delta), 0 where it is negative,   sum F*h = T

with one full matrix S of compliances. It is symmetric and positive, so that there is one solution;
Newton finds which pairs carry as it goes.
"""

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.output.contact_law import PinSupport
from core.output.pin_beam import PinBeam
from core.output.sharing_kernel import (
    EPS,
    NOT_SOLVED,
    SOLVED,
    STEPS,
    TINY,
    Pairs,
    Position,
    Room,
    Setup,
    law,
    solve,
    wave_torque,
)
from core.output.tie_ring import TieRing

HALVINGS = 8
"""How often a step of Newton is halved that leads away from the balance."""


def ring_of(pin: PinSupport) -> TieRing:
    """The ring as one pin feels it.

    Parameters
    ----------
    pin : PinSupport
        Pins that a tie ring joins.

    Returns
    -------
    TieRing
    """
    beam = PinBeam.round(
        support="cantilever",
        diameter=pin.diameter,
        contact_length=1.0,  # of the loads, which are single ones here
        youngs_modulus=pin.material.youngs_modulus,
        poissons_ratio=pin.material.poissons_ratio,
    )
    assert pin.span is not None
    return TieRing(pin.ring_joint, pin.span, beam.rigidity, beam.shear_area)


def tied_compliance(*, pin: PinSupport, pins: int) -> list[float]:
    """Deflection of a pin under a unit force that is alone, on the mean of its directions.

    Parameters
    ----------
    pin : PinSupport
        Pins that a tie ring joins.
    pins : int
        Their number N.

    Returns
    -------
    list of float
        At each satellite, m/N.
    """
    ring, places = ring_of(pin), pin.satellite_positions
    held = (1 - 1.5 / pins) / ring.end(ring.span)
    return [float(ring.flexibility(z, z) - ring.end(z) ** 2 * held) for z in places]


@dataclass(frozen=True)
class TiedPins:
    """Pins that a tie ring joins, for the design's N*K pairs, satellite by satellite.

    Its methods stand for the functions of the same names of `core.output.sharing_kernel`, as those
    of `core.output.satellite_support.Shares` do.
    """

    # S without what the turn of the ring adds, and without `tied_compliance`, which is in the
    # pairs' laws, m/N, shape (N*K, N*K).
    give: FloatArray
    ends: FloatArray  # a(z)/sqrt(f*N), by which each pair turns the ring, sqrt(m/N), shape (N*K,)

    @classmethod
    def of(cls, *, pin: PinSupport, pins: int, phases: list[float]) -> Self:
        """Pins of a design.

        Parameters
        ----------
        pin : PinSupport
            How they are held.
        pins : int
            Their number N.
        phases : list of float
            Angles of the cranks, rad, K values.

        Returns
        -------
        TiedPins
        """
        ring, places, phase = ring_of(pin), np.array(pin.satellite_positions), np.array(phases)
        held = ring.end(ring.span)
        arm = np.asarray(ring.end(places))
        along = np.cos(phase[:, None] - phase)
        free = np.asarray(ring.flexibility(places[:, None], places)) * along
        by_ring = arm[:, None] * arm / held * along
        same = np.eye(pins)
        give = np.kron(free, same) - np.kron(by_ring, same - 1 / pins)
        give -= np.diag(np.repeat(tied_compliance(pin=pin, pins=pins), pins))
        return cls(give, np.repeat(arm / math.sqrt(held * pins), pins))

    def solve(self, psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
        """Equilibrium at a wave angle psi, rad, under a torque, N*m, > 0; see `RealMechanism`.

        The search begins where each pair would be with a pin of its own.
        """
        found = solve(psi, torque, setup, pairs, room)
        if not found.stiffness > 0:
            return found
        pressed = found.low > found.high + found.play_error
        zero = 0.0 if pressed else found.high
        base, lever = np.array(room.q), np.array(room.v)
        turning = self.ends * lever / setup.radius
        give = self.give + np.outer(turning, turning)
        balance = _Balance(setup, pairs, base, lever, give)
        lag = found.lag - zero
        lag, approach, status, steps = balance.found(torque, lag, base + lag * lever)
        force, stiff = balance.forces(approach)
        carries = force > 0
        rounding = EPS * (4 + 2 * abs(psi))
        unsure = np.array(room.unsure) + 4 * EPS * (np.abs(balance.give) @ force + np.abs(base))
        off = np.abs(balance.off(lag, approach, force)) + unsure
        answers = np.linalg.inv(
            np.eye(int(carries.sum())) + balance.give[carries][:, carries] * stiff[carries]
        )
        answers *= stiff[carries][:, None]  # forces by the approaches without them
        slope = float(lever[carries] @ answers @ lever[carries])
        short = abs(torque - float(lever @ force)) + rounding * float(force.sum()) * setup.radius
        short += float(np.abs(lever[carries] @ answers) @ off[carries])
        lag_error = short / slope if slope > 0 else math.inf
        near = off[carries] + np.abs(lever[carries]) * lag_error
        force_error = float((np.abs(answers) @ near).max(initial=0.0) + 8 * EPS * force.max())
        for name, row in (
            ("force", force),
            ("lever", np.where(carries, lever, 0.0)),
            ("stiffness", stiff),
            ("unsure", unsure),
        ):
            getattr(room, name)[:] = row.tolist()
        lag_error += (0.0 if pressed else found.play_error) + EPS * abs(lag)
        return found._replace(
            lag=zero + lag,
            stiffness=slope,
            lag_error=lag_error,
            force_error=force_error,
            status=status if slope > 0 else NOT_SOLVED,
            steps=found.steps + steps,
        )

    def wave_torque(self, psi: float, lag: float, setup: Setup, pairs: Pairs, room: Room) -> float:
        """Torque of the forces on the wave, N*m, as `solve` left the room: also by what the wave
        changes of the pins' compliance, as the ring turns more easily or less.
        """
        now = beside = 0.0
        for i, force in enumerate(room.force):
            angle = psi + pairs.phase[i // setup.pins]
            x, y, felt = pairs.x[i], pairs.y[i], force * self.ends[i] / setup.radius
            now += felt * (math.sin(angle) * x + math.cos(angle) * y)
            beside += felt * (math.cos(angle) * x - math.sin(angle) * y)
        return wave_torque(psi, lag, setup, pairs, room) - float(now * beside)


@dataclass(frozen=True, slots=True)
class _Balance:
    """A position to be solved."""

    setup: Setup
    pairs: Pairs
    base: FloatArray  # approach without lag and forces, m
    lever: FloatArray  # m
    give: FloatArray  # S, but for what is in the laws, m/N

    def forces(self, approach: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Forces and stiffnesses of the pairs."""
        kind, exponent = self.setup.law, self.setup.exponent
        force, stiff = np.zeros_like(approach), np.zeros_like(approach)
        for i in np.flatnonzero(approach > TINY).tolist():
            a, b = self.pairs.a[i], self.pairs.b[i]
            force[i], stiff[i] = law(kind, float(approach[i]), a, b, exponent, 0.0, 0.0)
        return force, stiff

    def off(self, lag: float, approach: FloatArray, force: FloatArray) -> FloatArray:
        """By how much approaches are not what forces and lag leave of them, m."""
        found: FloatArray = self.base + lag * self.lever - approach - self.give @ force
        return found

    def found(
        self, torque: float, lag: float, approach: FloatArray
    ) -> tuple[float, FloatArray, int, int]:
        """Lag and approaches that balance the torque, a status, and the steps that it took."""
        force, stiff = self.forces(approach)
        error = self._error(torque, lag, approach, force)
        status, steps = NOT_SOLVED, 0
        while status != SOLVED and steps < STEPS:
            steps += 1
            turned, moved = self._step(torque, lag, approach, force, stiff)
            part = 1.0
            for _ in range(HALVINGS):
                trial = approach + part * moved
                bent, stiffer = self.forces(trial)
                after = self._error(torque, lag + part * turned, trial, bent)
                if after < error or after <= 4 * EPS:
                    break
                part /= 2
            size = max(float(np.abs(approach).max()), TINY)
            small = float(np.abs(moved).max()) <= 16 * EPS * size
            if after < error or not small:
                lag, approach, error = lag + part * turned, trial, after
                force, stiff = bent, stiffer
            if small or error <= 4 * EPS:
                status = SOLVED
        return lag, approach, status, steps

    def _error(self, torque: float, lag: float, approach: FloatArray, force: FloatArray) -> float:
        size = max(float(np.abs(approach).max()), TINY)
        off = float(np.abs(self.off(lag, approach, force)).max()) / size
        return off + abs(torque - float(self.lever @ force)) / torque

    def _step(
        self,
        torque: float,
        lag: float,
        approach: FloatArray,
        force: FloatArray,
        stiff: FloatArray,
    ) -> tuple[float, FloatArray]:
        """Newton's step of lag and approaches."""
        carries: BoolArray = stiff > 0
        off = self.off(lag, approach, force)
        own = self.give[:, carries] * stiff[carries]  # approaches lost by approaches
        both = np.linalg.solve(
            own[carries] + np.eye(int(carries.sum())),
            np.stack((off[carries], self.lever[carries]), axis=1),
        )
        pull = stiff[carries] * self.lever[carries]
        short = torque - float(self.lever @ force)
        turned = (short - float(pull @ both[:, 0])) / float(pull @ both[:, 1])
        moved = off + turned * self.lever
        moved -= own @ (both[:, 0] + turned * both[:, 1])
        return turned, moved
