"""Ideal forces over a turn of the wave, sampled.

Forces of all pairs are smooth between switching angles. Each such stretch is cut into panels of
three places, which are halved until the middle one lies on the line between the ends. Pins an N-th
of a turn apart bear equal forces an N-th of a turn later, so that one such sector is sampled, of
all pins.
"""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray, IntArray
from core.errors import InvalidInput
from core.output.contact_force import AT_SWITCH, force_peak
from core.output.mechanism import Mechanism
from core.output.sampled_turn import PinSamples, SampledTurn, largest_of_samples
from core.precision import SEARCHED

WIDEST = 1 / 1600
"""Largest width of a panel, turns."""

OFF_LINE = 4 * SEARCHED
"""Largest distance of a panel's middle from the line between its ends, over the largest force."""

HALVED = 18
"""Most halvings of a panel: beside a pair that starts, forces of an exponent below 1 have no finite
slope."""

LEAST = 1e-3
"""Least exponent but 0: below, a pair takes up its share within the rounding of its place."""

NOTHING = 1e-30
"""Force of a pair, over that of the best placed one, that is too small to change any sum."""

SIMPSON = np.array([1.0, 4.0, 1.0]) / 6


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class IdealTurn(SampledTurn):
    """Ideal forces under one torque, of all pins over one sector."""

    weights: FloatArray  # weights of the means over the turn, shape (n,)
    smooth: BoolArray  # True if smooth from the sample before to the one after, shape (n,)
    first: float  # wave angle at which the turn begins, rad

    def mean(self, values: FloatArray) -> FloatArray:
        """Mean of values over the turn, by Simpson's rule of each panel."""
        found: FloatArray = values @ self.weights
        return found

    def largest(self, values: FloatArray) -> FloatArray:
        """Largest values over the turn, for values of shape (..., n)."""
        rows = values.reshape(-1, values.shape[-1])
        found = largest_of_samples(values=rows, wave=self.wave, smooth=self.smooth)
        return found.reshape(values.shape[:-1])

    def missed(self, values: ComplexArray) -> float:
        """Error of values between the samples, `SEARCHED` of the largest value."""
        return float(SEARCHED * np.abs(values).max())

    def felt(self, pin: int) -> PinSamples:
        """Forces on a pin over the turn, joined from the sector sampled of all pins."""
        count = self.on_pins.shape[1]
        wave = np.add.outer(2 * np.pi * np.arange(count) / count, self.wave).ravel()
        smooth = np.tile(self.smooth, count)
        begun = np.flatnonzero(~smooth)[::2]  # starts of stretches, each of which has two ends
        late = begun[wave[begun] >= self.first + 2 * np.pi]
        if len(late):  # samples past the turn come first
            wave[late[0] :] -= 2 * np.pi
        first = -int(late[0]) if len(late) else 0
        forces = np.roll(self.on_pins.reshape(len(self.on_pins), -1), first, axis=1)
        found = PinSamples(forces, np.roll(wave, first), np.roll(smooth, first))
        return found.thinned(OFF_LINE / 4)  # many samples serve other pins alone


@dataclass(frozen=True, eq=False, slots=True)
class _Arcs:
    """Stretches of a sector between switching angles."""

    phase: FloatArray  # phases of all pairs, turns, shape (K, N)
    start: FloatArray  # start of each arc, turns of the wave, shape (a,)
    width: FloatArray  # width of each arc, turns, shape (a,)
    exponent: float

    @classmethod
    def of(cls, mechanism: Mechanism, exponent: float) -> "_Arcs":
        phases = mechanism.phases
        start = np.array([place for place, _ in phases.switching()])
        width = np.diff(start, append=start[0] + 1 / phases.pins)
        pins = np.arange(phases.pins) / phases.pins
        return cls(np.add.outer(np.array(phases.satellite_phase), pins), start, width, exponent)

    def forces(self, arc: IntArray, place: FloatArray) -> ComplexArray:
        """Forces of all pairs over F0, tangential + i*radial, shape (K, N, n), at places of arcs,
        in turns from their start.
        """
        phase = self.phase[..., None] + 0.25
        middle = phase + (self.start + self.width / 2)[arc]
        angle = phase + (self.start[arc] + place)
        turns = np.rint(middle)
        drives = np.abs(middle - turns) < 0.25
        angle = angle - turns
        away = 0.25 - np.abs(angle)
        cosine = np.sin(2 * np.pi * away) * (drives & (away > AT_SWITCH))
        best = cosine.max(axis=(0, 1))
        share = cosine / best
        share = drives * (share * (share > NOTHING ** (1 / max(self.exponent, 1)))) ** self.exponent
        force = share / (share * cosine).sum(axis=(0, 1))
        return np.asarray(force * np.exp(2j * np.pi * angle))


@lru_cache(maxsize=64)
def _sampled(mechanism: Mechanism, exponent: float) -> IdealTurn:
    """Turn under a reference force F0 = 1 and a unit torque."""
    peak = force_peak(mechanism, exponent)  # refuses what cannot be
    arcs = _Arcs.of(mechanism, exponent)
    count = np.ceil(arcs.width / WIDEST).astype(int)
    arc = np.repeat(np.arange(len(count)), count)
    part = np.arange(len(arc)) - np.repeat(np.cumsum(count) - count, count)
    low, width = part * (arcs.width / count)[arc], (arcs.width / count)[arc]
    values = [arcs.forces(arc, low + share * width) for share in (0.0, 0.5, 1.0)]
    kept = []
    evaluations = 3 * len(arc)
    for halved in range(HALVED + 1):
        first, middle, last = values
        off = np.abs(middle - (first + last) / 2).max(axis=(0, 1))
        bent = (off > OFF_LINE * peak.peak_force_ratio) & (halved < HALVED)
        kept.append((arc[~bent], low[~bent], width[~bent], *(each[..., ~bent] for each in values)))
        if not bent.any():
            break
        arc, low, width = arc[bent], low[bent], width[bent]
        first, middle, last = (each[..., bent] for each in values)
        quarters = (arcs.forces(arc, low + share * width) for share in (0.25, 0.75))
        before, after = quarters
        evaluations += 2 * len(arc)
        values = [
            np.concatenate(pair, axis=-1)
            for pair in ((first, middle), (before, after), (middle, last))
        ]
        arc, low = np.tile(arc, 2), np.concatenate((low, low + width / 2))
        width = np.tile(width / 2, 2)
    arc, low, width, *values = (np.concatenate(each, axis=-1) for each in zip(*kept, strict=True))
    order = np.lexsort((low, arc))
    arc, low, width = arc[order], low[order], width[order]
    ends = np.append(arc[1:] != arc[:-1], True)  # panels at the end of their arc
    weights = width[:, None] * SIMPSON
    weights[1:, 0] += np.where(ends[:-1], 0.0, weights[:-1, 2])
    once = np.ones((len(arc), 3), dtype=np.bool_)
    once[:, 2] = ends
    smooth = np.ones((len(arc), 3), dtype=np.bool_)
    smooth[:, 0], smooth[:, 2] = ~np.roll(ends, 1), False
    places = (arcs.start[arc] + low)[:, None] + width[:, None] * np.array([0.0, 0.5, 1.0])
    on_pins = np.stack(values, axis=-1)[..., order, :][..., once]
    force = np.abs(on_pins)
    return IdealTurn(
        wave=mechanism.initial_crank_angle + 2 * np.pi * places[once],
        on_pins=on_pins,
        on_satellites=force.sum(axis=1) + 0j,
        total=force.sum(axis=(0, 1)),
        couple=on_pins.real.sum(axis=1),
        crank_angles=mechanism.crank_angles,
        weights=weights[once] * mechanism.pins,
        smooth=smooth[once],
        first=mechanism.initial_crank_angle,
        error=2 * peak.accuracy.relative_error,
        evaluations=evaluations,
        unlike=1,
    )


def ideal_turn(
    torque: float, *, mechanism: Mechanism, force_exponent: float, pin_circle_radius: float
) -> IdealTurn:
    """Ideal forces over a turn of the wave, sampled (Yanchevskiy and Niekhoroshykh 2021, eq. 10).

    In reverse (torque < 0, N*m) a pin bears equal forces the other way, half a turn of the wave
    later. `ImpossibleMechanism` is raised for a mechanism with a dead centre, `InvalidInput` for
    an exponent between 0 and `LEAST`.

    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    >>> turn = ideal_turn(500.0, mechanism=six, force_exponent=1.0, pin_circle_radius=0.05)
    >>> round(float(abs(turn.on_pins).max()), 4), round(float(turn.couple.sum(axis=0)[0]), 4)
    (3333.3333, 500.0)
    """
    if 0 < force_exponent < LEAST:
        raise InvalidInput("force_exponent", force_exponent, "greater_than_equal", limit=LEAST)
    unit = _sampled(mechanism, float(force_exponent))
    force, half = torque / pin_circle_radius, np.pi if torque < 0 else 0.0
    return replace(
        unit,
        wave=unit.wave + half,
        on_pins=force * unit.on_pins,
        on_satellites=abs(force) * unit.on_satellites,
        total=abs(force) * unit.total,
        couple=torque * unit.couple,
    )
