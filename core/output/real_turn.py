"""Forces on pins, satellites and crank of the mechanism as it is made, over the turn.

In exact geometry a contact's force acts along the line of centres of its pin and its hole, which
deviations and lag turn out of the crank's direction; in first order it keeps that direction.
"""

import math
from typing import NamedTuple

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.sampled_turn import SampledTurn, off_straight
from core.output.turn import Rows, Turn, joined
from core.precision import JUDGED

FELT = 4.0
"""How many times its own error a sample has to lie off that line, to be more than noise."""

HALVINGS = 16
"""How often the samples beside a kink are halved."""


class CloseSamples(NamedTuple):
    """Forces of all pairs under one torque, over a whole turn."""

    wave: FloatArray  # wave angles, rad, ascending, shape (n,)
    force: FloatArray  # N, shape (K*N, n)
    lag: FloatArray  # of the output behind its ideal angle, rad, negative in reverse, shape (n,)
    error: float  # as `core.output.sampled_turn.PinForces.error`
    evaluations: int  # positions that were solved


def sampled(turn: Turn) -> SampledTurn:
    """Forces under one torque, sampled as closely as they need, with their directions.

    Parameters
    ----------
    turn : Turn
        The mechanism under the torque.

    Returns
    -------
    SampledTurn

    Raises
    ------
    ImpossibleMechanism
        See `RealMechanism.solved`.

    Examples
    --------
    >>> from core.output.contact_law import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False)
    >>> found = sampled(Turn(real, 30.0))
    >>> round(float(abs(found.on_pins).max()), 1), bool(np.allclose(found.couple, 30.0))
    (957.1, True)
    """
    return _directed(turn.real, close_samples(turn))


def close_samples(turn: Turn) -> CloseSamples:
    """Forces under one torque, sampled as closely as they need.

    Parameters
    ----------
    turn : Turn
        A mechanism under the torque.

    Returns
    -------
    CloseSamples
    """
    rows = turn.fine
    for _ in range(HALVINGS):
        wave = rows["wave"]
        felt = np.maximum(JUDGED * rows["forces"].max(), FELT * rows["force_error"])
        rough = _off(turn, rows) > felt
        gaps = np.diff(wave, append=wave[0] + turn.period)
        between = (wave + gaps / 2)[rough | np.roll(rough, -1)]
        if not len(between):
            break
        rows = joined(one=rows, other=turn.poses(between.tolist()))
    force = rows["forces"]
    error = (float(_off(turn, rows).max()) + float(rows["force_error"].max())) / force.max()
    periods, pins = np.arange(turn.repeats), turn.real.mechanism.pins
    wave = (rows["wave"] + turn.period * periods[:, None]).ravel()
    each = force.reshape(len(force), -1, pins)
    whole = np.concatenate([np.roll(each, -k, axis=2) for k in periods]).reshape(len(wave), -1)
    lag = math.copysign(1.0, turn.torque) * np.tile(rows["lag"], turn.repeats)
    return CloseSamples(wave, whole.T, lag, error, len(force))


def _off(turn: Turn, rows: Rows) -> FloatArray:
    """How far the largest of the forces' samples lies off the line between its neighbours."""
    wave, force, pins = rows["wave"], rows["forces"], turn.real.mechanism.pins
    step = 1 if turn.repeats > 1 else 0  # what a pin felt a period before, the next one feels
    before, after = (
        np.roll(row.reshape(-1, pins), way * step, axis=1).reshape(1, -1)
        for row, way in ((force[-1], 1), (force[0], -1))
    )
    padded = np.concatenate((before, force, after)).T
    around = np.concatenate(([wave[-1] - turn.period], wave, [wave[0] + turn.period]))
    off: FloatArray = off_straight(wave=around, values=padded).max(axis=0)
    return off


def _directed(real: RealMechanism, samples: CloseSamples) -> SampledTurn:
    """Forces with their directions."""
    wave, force, lag, error, evaluations = samples
    pins, satellites = real.mechanism.pins, real.mechanism.satellites
    errors = real.deviations.rows(pins, satellites)
    cranks = np.array(real.mechanism.crank_angles) + np.array(errors.crank_phase)
    crank = 1j * np.exp(-1j * (wave + cranks[:, None]))[:, None]  # (K, 1, n)
    radial = 1j * np.exp(2j * np.pi * np.arange(pins) / pins)[:, None]  # (N, 1)
    size = force.reshape(satellites, pins, -1)
    if real.exact:
        hole, pin = _centres(real, crank, radial, lag)
        arm = hole - pin
        acts: ComplexArray = size * (arm / np.abs(arm))
        tangential = 1j * radial * np.exp(-1j * lag)
        hole = hole - _eccentricities(real) * crank
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
        pins_alike=real.deviations == Deviations(),
    )


def _eccentricities(real: RealMechanism) -> FloatArray:
    """Of the cranks with their deviations, shape (K, 1, 1)."""
    errors = real.deviations.rows(real.mechanism.pins, real.mechanism.satellites)
    return (real.eccentricity + np.array(errors.eccentricity))[:, None, None]


def _centres(
    real: RealMechanism, crank: ComplexArray, radial: ComplexArray, lag: FloatArray
) -> tuple[ComplexArray, ComplexArray]:
    """Centres of holes and pins, shape (K, N, n), in the frame of the output without a lag."""
    pins, satellites = real.mechanism.pins, real.mechanism.satellites
    errors = real.deviations.rows(pins, satellites)
    radius = real.pin_circle_radius
    off_pin = np.array(errors.pin_radial) + 1j * np.array(errors.pin_tangential)
    off_hole = np.array(errors.hole_radial) + 1j * np.array(errors.hole_tangential)
    turned = np.array(errors.disc_phase) + np.array(errors.crank_phase) / real.mechanism.ratio
    pin = radial * (radius + off_pin)[:, None] * np.exp(-1j * lag)
    hole = radial * (radius + off_hole.reshape(satellites, pins, 1))
    return _eccentricities(real) * crank + np.exp(1j * turned)[:, None, None] * hole, pin
