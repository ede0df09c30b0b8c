"""Forces on pins, discs and crank of the mechanism as made, over the turn.

In exact geometry the force of a contact acts along the line of centres of pin and hole, which
deviations and lag turn out of the crank's direction. In the first order the force keeps the crank's
direction.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.sampled_turn import SampledTurn, off_straight
from core.output.turn import Rows, Turn, joined
from core.precision import JUDGED

FELT = 4.0
"""Distance of a sample from the straight line, over its error, that is more than noise."""

HALVINGS = 16
"""Number of halvings of the steps beside a kink."""


class CloseSamples(NamedTuple):
    """Forces of all pairs under one torque, over a whole turn."""

    wave: FloatArray  # wave angles, rad, ascending, shape (n,)
    force: FloatArray  # N, shape (K*N, n)
    lag: FloatArray  # angular deflection of the output, rad, < 0 in reverse, shape (n,)
    error: float  # relative error, as in `core.output.sampled_turn.PinForces`
    evaluations: int  # number of solved positions


def sampled(turn: Turn) -> SampledTurn:
    """Forces on pins and discs under one torque over the turn, sampled as closely as they need.

    ImpossibleMechanism is raised as by `Stage.solved`.
    """
    rows = refined(turn=turn)
    return directed(turn=turn, rows=rows, samples=over_all(turn=turn, rows=rows))


def close_samples(turn: Turn) -> CloseSamples:
    """Forces of all pairs under one torque over the whole turn, sampled as closely as they need."""
    return over_all(turn=turn, rows=refined(turn=turn))


def over_all(*, turn: Turn, rows: Rows) -> CloseSamples:
    """Samples of all periods of the turn, from the solved positions of one period."""
    force = rows["forces"]
    error = float((off(turn=turn, rows=rows).max() + rows["error"].max()) / force.max())
    periods = np.arange(turn.repeats)
    wave = (rows["wave"] + turn.period * periods[:, None]).ravel()
    lag = math.copysign(1.0, turn.torque) * np.tile(rows["lag"], turn.repeats)
    return CloseSamples(wave, over_periods(turn=turn, force=force).T, lag, error, len(force))


def over_periods(*, turn: Turn, force: FloatArray) -> FloatArray:
    """Forces of all periods, N, shape (n*repeats, K*N), from one period of shape (n, K*N)."""
    each = force.reshape(len(force), -1, turn.real.mechanism.pins)
    moved = [np.roll(each, -k * turn.step, axis=2) for k in range(turn.repeats)]
    return np.concatenate(moved).reshape(-1, force.shape[1])


def refined(
    *, turn: Turn, near: float = JUDGED, besides: Callable[[Rows], FloatArray] | None = None
) -> Rows:
    """Positions of a period, as close as the forces need. Forces lie nearer than `near`, over the
    largest force, to the straight lines between samples, and so do further quantities (`besides`:
    their relative distances, shape (n,)).
    """
    rows = turn.fine
    for _ in range(HALVINGS):
        wave = rows["wave"]
        felt = np.maximum(near * rows["forces"].max(), FELT * rows["error"])
        rough = off(turn=turn, rows=rows) > felt
        if besides:
            rough |= besides(rows) > near
        gaps = np.diff(wave, append=wave[0] + turn.period)
        between = (wave + gaps / 2)[rough | np.roll(rough, -1)]
        if not len(between):
            break
        rows = joined(one=rows, other=turn.poses(between.tolist(), play=False))
    return rows


def off(*, turn: Turn, rows: Rows) -> FloatArray:
    """Distance of each position's forces from the line between their neighbours, N, shape (n,)."""
    wave, force, pins = rows["wave"], rows["forces"], turn.real.mechanism.pins
    before, after = (  # A pin's force passes to another pin after a period.
        np.roll(row.reshape(-1, pins), way * turn.step, axis=1).reshape(1, -1)
        for row, way in ((force[-1], 1), (force[0], -1))
    )
    padded = np.concatenate((before, force, after)).T
    around = np.concatenate(([wave[-1] - turn.period], wave, [wave[0] + turn.period]))
    found: FloatArray = off_straight(wave=around, values=padded).max(axis=0)
    return found


def directed(*, turn: Turn, rows: Rows, samples: CloseSamples) -> SampledTurn:
    """Forces with their directions on pins and discs, over a turn of the wave.

    `rows` are the positions of one period, `samples` the sizes of the forces of all periods.
    """
    wave, force, lag, error, evaluations = samples
    real = getattr(turn.real, "output", turn.real)
    pins, satellites = real.mechanism.pins, real.mechanism.satellites
    errors = real.deviations.rows(pins, satellites)
    cranks = np.array(real.mechanism.crank_angles) + np.array(errors.crank_phase)
    crank = 1j * np.exp(-1j * (wave + cranks[:, None]))[:, None]  # (K, 1, n)
    radial = 1j * np.exp(2j * np.pi * np.arange(pins) / pins)[:, None]  # (N, 1)
    size = force.reshape(satellites, pins, -1)
    if real.exact:
        own, off = (np.tile(rows[name], (turn.repeats, 1)).T for name in ("behind", "off"))
        eccentricities = (real.eccentricity + np.array(errors.eccentricity))[:, None, None]
        centre = (eccentricities + off[:, None]) * crank
        hole, pin = _centres(real, centre, radial, lag, own)
        arm = hole - pin
        acts: ComplexArray = size * (arm / np.abs(arm))
        tangential = 1j * radial * np.exp(-1j * lag)
        hole = hole - centre
    else:
        acts, tangential, hole = size * crank, 1j * radial, real.pin_circle_radius * radial
    on_pins = np.conj(acts / tangential)
    return SampledTurn(
        wave=wave,
        on_pins=on_pins,
        on_satellites=np.conj((acts / crank).sum(axis=1)),
        total=force.sum(axis=0),
        couple=(acts * np.conj(hole)).imag.sum(axis=1),
        crank_angles=tuple(cranks.tolist()),
        error=error,
        evaluations=evaluations,
        unlike=1 if real.deviations == Deviations() else pins,
    )


def _centres(
    real: RealMechanism,
    centre: ComplexArray,
    radial: ComplexArray,
    lag: FloatArray,
    own: FloatArray,
) -> tuple[ComplexArray, ComplexArray]:
    """Centres of holes and pins, m, shape (K, N, n), in the frame of the output without a lag."""
    pins, satellites = real.mechanism.pins, real.mechanism.satellites
    errors = real.deviations.rows(pins, satellites)
    radius = real.pin_circle_radius
    off_pin = np.array(errors.pin_radial) + 1j * np.array(errors.pin_tangential)
    off_hole = np.array(errors.hole_radial) + 1j * np.array(errors.hole_tangential)
    pin = radial * (radius + off_pin)[:, None] * np.exp(-1j * lag)
    hole = radial * (radius + off_hole.reshape(satellites, pins, 1))
    return centre + np.exp(-1j * own[:, None]) * hole, pin
