"""Forces on pins, satellites and crank of the mechanism as it is made, over the turn.

In exact geometry a contact's force acts along the line of centres of its pin and its hole, which
deviations and lag turn out of the crank's direction; in first order it keeps that direction.
"""

import math
from functools import cache

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_finite, check_single
from core.errors import InvalidInput
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.sampled_turn import Made, SampledTurn, off_straight
from core.output.turn import Turn

ENOUGH = 1e-5
"""How far a sample may lie off the straight line between its neighbours, over the largest force."""

HALVINGS = 16
"""How often the samples beside a kink are halved."""


def real_turn(*, real: RealMechanism, output_torque: float) -> SampledTurn:
    """Forces under one torque, sampled as closely as they need.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    SampledTurn

    Raises
    ------
    InvalidInput
        If the torque is no number or 0.
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
    >>> turn = real_turn(real=real, output_torque=30.0)
    >>> round(float(abs(turn.on_pins).max()), 1), bool(np.allclose(turn.couple, 30.0))
    (957.1, True)
    """
    check_single(output_torque=output_torque)
    check_finite(output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    turn = Turn(real, output_torque)
    even, near = turn.positions()
    wave = np.array(sorted({*even, *near}))
    force, lag, unsure = turn.forces(wave.tolist())
    for _ in range(HALVINGS):
        rough = off_straight(wave=wave, values=force.T).max(axis=0) > ENOUGH * force.max()
        gaps = np.diff(wave, append=wave[0] + 2 * math.pi)
        between = (wave + gaps / 2)[rough | np.roll(rough, -1)]
        if not len(between):
            break
        more_force, more_lag, more_unsure = turn.forces(between.tolist())
        order = np.argsort(np.concatenate((wave, between)), kind="stable")
        wave = np.concatenate((wave, between))[order]
        force = np.concatenate((force, more_force))[order]
        lag = np.concatenate((lag, more_lag))[order]
        unsure = np.concatenate((unsure, more_unsure))
    off = float(off_straight(wave=wave, values=force.T).max())
    signed = math.copysign(1.0, output_torque) * lag
    return _directed(
        real, wave, force.T, signed, (off + float(unsure.max())) / force.max(), turn.evaluations
    )


def made(real: RealMechanism) -> Made:
    """The forces of a mechanism under any torque; each is solved once.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.

    Returns
    -------
    callable
        Of the torque on the output link, N*m, negative in reverse: `SampledTurn`.
    """
    return cache(lambda torque: real_turn(real=real, output_torque=torque))


def _directed(
    real: RealMechanism,
    wave: FloatArray,
    force: FloatArray,
    lag: FloatArray,
    error: float,
    evaluations: int,
) -> SampledTurn:
    """Forces, shape (K*N, n), with their directions."""
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
    if real.deviations == Deviations():
        on_pins = on_pins[:, :1]
    return SampledTurn(
        wave=wave,
        on_pins=on_pins,
        on_satellites=np.conj((acts / crank).sum(axis=1)),
        total=force.sum(axis=0),
        couple=(acts * np.conj(hole)).imag.sum(axis=1),
        crank_angles=tuple(cranks.tolist()),
        error=error,
        evaluations=evaluations,
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
