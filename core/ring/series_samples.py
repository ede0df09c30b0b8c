"""Forces of both meshes in series on pins, discs and eccentric over the turn."""

import math
from dataclasses import replace

import numpy as np

from core.output.real_turn import CloseSamples, directed, over_all
from core.output.sampled_turn import SampledTurn, off_straight
from core.ring.series_turn import SeriesTurn, of_ring


def sampled_in_series(turn: SeriesTurn) -> SampledTurn:
    """Forces under one torque with the ring's forces on each disc, sampled as closely as the forces
    on the output pins and of the ring need. Raises ImpossibleMechanism as `Stage.solved` does.

    In exact geometry the forces of ring and pins across the crank give the input torque.
    """
    output = turn.real.output
    rows = turn.close
    samples = over_all(turn=turn, rows=rows)
    waves = samples.wave * output.mechanism.waves_per_turn
    found = directed(
        turn=turn,
        rows=rows,
        samples=samples._replace(wave=waves + output.mechanism.initial_crank_angle),
    )
    return replace(
        found,
        unlike=math.gcd(turn.step, output.mechanism.pins),
        waves=turn.waves,
        of_ring=np.tile(of_ring(rows), (turn.repeats, 1)).T,
    )


def teeth_samples(turn: SeriesTurn) -> CloseSamples:
    """Forces of the ring pins at the samples of `SeriesTurn.close`, with the lag of the output,
    until pins that are alike have had each other's forces.
    """
    rows, ring = turn.close, turn.real.ring
    force, pins = rows["teeth"], ring.disc.pins
    each = force.reshape(len(force), -1, pins)
    periods = np.arange(pins if ring.pins_alike else 1)
    every = np.concatenate([np.roll(each, -k * turn.pitches, axis=2) for k in periods])
    wave = (rows["wave"] + turn.period * periods[:, None]).ravel()
    lag = math.copysign(1.0, turn.torque) * np.tile(rows["lag"], len(periods))
    flat = every.reshape(len(wave), -1).T
    inner = off_straight(wave=wave, values=flat).max() if len(wave) > 2 else 0.0
    error = float((inner + rows["error"].max()) / force.max())
    return CloseSamples(wave, flat, lag, error, len(force))
