"""Results of a design over crank angles."""

import numpy as np

from core.arrays import ComplexArray, FloatArray, IntArray
from core.crank.crankshaft import STILL, ReactionCurves, reaction_curves
from core.crank.satellite_bearing import (
    BearingCurves,
    bearing_curves,
    made_parts,
    uneven_shares,
)
from core.design.results import Results
from core.output.losses import LossCurves, PinLosses, loss_curves
from core.output.sampled_turn import WAYS

MISSED_OF_PEAK = 0.01
"""Relative amount of a peak that samples of a curve may miss."""


def design_losses(*, results: Results, losses: PinLosses, crank_angle: FloatArray) -> LossCurves:
    """Loss and efficiency of a design with its pin losses, at crank angles in rad."""
    design = results.design
    if not results.solved:
        return loss_curves(
            losses=losses,
            mechanism=design.driven,
            force_exponent=design.load.force_exponent,
            crank_angle=crank_angle,
        )
    wave, turn = design.built.wave_angle(crank_angle), results.losses.turn
    total = turn.at(wave=wave, values=turn.total[None])[0]
    loss = losses.mean_loss * total / turn.mean(turn.total)
    return LossCurves(crank_angle, loss, 1 / (1 + loss / losses.output_power))


def _load_curves(
    results: Results, crank_angle: FloatArray, shares: FloatArray
) -> list[BearingCurves]:
    """Load of the satellite bearings in each direction of the torque; for ideal forces also for
    each row of `shares`, shape (cases, K): shares of the torque times K.
    """
    design, load = results.design, results.design.load
    eccentricity, rho = design.known_eccentricity, float(results.ring.on_crank.radial_force_ratio)
    ways = WAYS[load.torque_direction]
    curves = []
    if not results.solved:
        for way in ways:
            found = bearing_curves(
                mechanism=design.built,
                force_exponent=load.force_exponent,
                output_torque=design.pin_torque,
                pin_circle_radius=design.pin_circle_radius,
                eccentricity=eccentricity,
                radial_force_ratio=rho,
                crank_angle=crank_angle,
                torque_direction="driving" if way > 0 else "reverse",
            )
            loads = found.along + 1j * found.across
            curves += [_of_loads(crank_angle, own * loads) for own in shares]
        return curves
    arm = eccentricity * design.mechanism.ratio
    wave = design.built.wave_angle(crank_angle)
    for way in ways:
        turn = results.made(way * design.pin_torque)
        parts = made_parts(turn=turn, arm=arm, radial_force_ratio=rho)
        curves.append(_of_loads(crank_angle, turn.at(wave=wave, values=parts.load).T))
    return curves


def _of_loads(crank_angle: FloatArray, loads: ComplexArray) -> BearingCurves:
    """Bearing curves of complex loads, along the crank plus i times across it, shape (n, K)."""
    return BearingCurves(crank_angle, loads.imag, loads.real, np.abs(loads))


def design_bearings(*, results: Results, crank_angle: FloatArray) -> BearingCurves:
    """Load of the satellite bearings in the worst direction, at crank angles in rad."""
    factor, relief = np.array([[results.design.disc_factor]]), results.crank.centrifugal
    cases = [
        _of_loads(crank_angle, each.along - relief + 1j * each.across)
        for each in _load_curves(results, crank_angle, factor)
    ]
    worst = _worst([each.load for each in cases])
    across, along, load = (
        np.choose(worst, [getattr(each, name) for each in cases])
        for name in ("across", "along", "load")
    )
    return BearingCurves(crank_angle, across, along, load)


def design_reactions(*, results: Results, crank_angle: FloatArray) -> ReactionCurves:
    """Reactions of the crankshaft bearings, each in its worst case, at crank angles in rad."""
    design, shaft, load = results.design, results.design.crankshaft, results.design.load
    cranks = design.built.crank_angles
    if results.solved:
        torque = WAYS[load.torque_direction][0] * design.pin_torque
        cranks = results.made(torque).crank_angles
    shares = uneven_shares(
        satellites=design.mechanism.satellites, distribution_factor=design.disc_factor
    )
    spun = results.crank.shaft.balance
    cases = [
        reaction_curves(
            loads=each,
            crank_angles=cranks,
            **shaft.places,
            unbalanced=np.array(spun.reaction) if spun else STILL,
        ).reaction
        for each in _load_curves(results, crank_angle, shares)
    ]
    worst = _worst([np.abs(each) for each in cases])
    return ReactionCurves(crank_angle, np.choose(worst, cases))


def _worst(sizes: list[FloatArray]) -> IntArray:
    """Index of the case with the largest peak, for each column; the first of cases whose peaks
    differ by less than the samples of a curve may miss.
    """
    peaks = np.max(sizes, axis=1)
    worst: IntArray = np.argmax(peaks >= (1 - MISSED_OF_PEAK) * peaks.max(axis=0), axis=0)
    return worst
