"""The forces on one pin, or of one satellite, over a turn of the wave: at any place, and sampled.

Between the places at which a pair starts or stops driving, or another becomes the best placed, the
forces are smooth; such a stretch of a turn is an arc. With t the tangent of the pressure
angle of the best placed pair and d the phase of another against it, that one's cosine over the best
is ``u = cos(d) - t*sin(d)``, and its sine ``s = sin(d) + t*cos(d)``, so that its force is

    F/F0 = u^v*(u + i*s)/T,   T = sum(u^(1 + v)) over all driving pairs

as a complex number, tangential + i*radial: bounded for any exponent. Both u and s are linear in t,
and are taken between their values at the ends of the arc: sums of positive numbers only.

All pins of a mechanism are alike but for the time at which they feel the forces.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache, cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import ComplexArray, FloatArray, IntArray
from core.numerics.quadrature import tanh_sinh_rule
from core.output.contact_force import PHASE_ROUNDING
from core.output.driving_set import segments
from core.output.losses import AT_SWITCH
from core.output.mechanism import Mechanism
from core.precision import ROUNDING

MANY = 64
"""Driving pairs above which samples are fewer: each pair changes little over an arc."""

SPARSE, DENSE = 0.5, 0.7
"""Ratio of the distances of neighbouring samples from the nearer end of their arc."""

FIRST = 0.05
"""Distance of the first sample from an end, over the arc, where the forces are as smooth as their
cosines; a force exponent above 1 divides it, as it does the distance within which the force goes
over from one pair to the next."""

SINGULAR = 1e-5
"""The same where the force rises with a power of the cosine that is not whole."""

DRAWN = np.linspace(0.0, 1.0, 13)
"""Places of an arc that are drawn besides its samples."""

BLOCK = 1_000_000
"""Numbers that are worked on at once."""

COARSEST = 3
"""Level of the coarsest rule of means over the turn, 56 nodes an arc."""

NOTHING = 1e-30
"""Force of a pair, over that of the best placed one, that no sum feels."""

ULPS, ULPS_OF_POWER = 4, 2
"""Rounding of a sum of forces where the phases are right, in units of `ROUNDING`, and what a force
exponent of 1 adds."""


class AllPairs:
    """All pairs that drive over the turn of the wave, segment by segment of one repeat of the
    pattern.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; without a dead centre.
    force_exponent : float
        Exponent v of the force over the approach.

    Attributes
    ----------
    phase : array, shape (s,)
        Phase of the best placed pair of each segment, in turns.
    ends : array, shape (2, s)
        Its pressure angle at both ends, in turns.
    cosines, weights : array, shapes (2, s, m) and (s, m)
        Relative cosines of the driving pairs at both ends of each of these, and how many are there.
    nodes, gaps : array, shape (n,)
        Places of samples, as parts of the way along an arc, by the tangent; the distance of the
        farther neighbour of each.
    samples : array, shape (s, 1, n)
        T there.
    """

    def __init__(self, mechanism: Mechanism, force_exponent: float) -> None:
        self.phases, self.exponent = mechanism.phases, force_exponent
        parts = list(segments(self.phases))
        self.phase = np.array([part.phase for part in parts])
        self.ends = np.array([[part.low for part in parts], [part.high for part in parts]])
        pairs = [part.driving.pairs() for part in parts]
        most = max(len(weights) for _, weights in pairs)
        phase = np.full((len(pairs), most), 0.5)  # drives nowhere
        self.weights = np.zeros((len(pairs), most))
        for row, (own, weights) in enumerate(pairs):
            phase[row, : len(own)], self.weights[row, : len(own)] = own, weights
        self.cosines = _relative_cosines(phase, self.ends[..., None])
        self.nodes, self.gaps = _nodes(force_exponent, most > MANY)
        self.samples = self.total(np.arange(len(pairs)))(self.nodes[None])

    def arcs(self, repeats: int) -> tuple[IntArray, FloatArray]:
        """Segments so many times each: which, and by what pairs come before the best placed one
        that are at 0 first, in turns.
        """
        part, repeat = np.divmod(np.arange(len(self.phase) * repeats), repeats)
        each = self.phases.pins * self.phases.symmetry
        return part, repeat / each - self.phase[part]

    def total(self, rows: IntArray) -> Callable[[FloatArray], FloatArray]:
        """T at parts of the way along some of them, shape (rows, 1, m)."""
        low, high = self.cosines[:, rows, :, None]
        weights = self.weights[rows][..., None]

        def total(way: FloatArray) -> FloatArray:
            cosines = _between(low, high, way[:, None])
            shares = weights * cosines * _power(cosines, self.exponent)
            found: FloatArray = shares.sum(axis=1, keepdims=True)
            return found

        return total


class Turn:
    """What some of the pairs do over the turn of the wave, arc by arc.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; without a dead centre.
    force_exponent : float
        Exponent v of the force over the approach.
    own : sequence of float
        Phases of these pairs, in turns.
    repeats : int
        How often they meet the segments of one repeat of the pattern before all is as it was.

    Attributes
    ----------
    pairs : AllPairs
        All pairs, by whose forces those of these are divided.
    smooth : bool
        Whether the forces have a slope and a curvature where a pair switches.
    nodes, gaps : array, shape (n,)
        Places of the samples, as parts of the way along an arc, by the tangent; the distance of
        the farther neighbour of each.
    centres : array, shape (all arcs,)
        Of the best placed pair's pressure angle midway between the ends of every arc, in turns.
    arcs : array of int, shape (a,)
        Arcs over which any of the pairs drives, and one of the others.
    forces : array, shape (K, a, n)
        What is asked of the pairs at the samples of these.
    tangents : array, shape (2, all arcs, 1)
        Of the best placed pair's pressure angle at both ends of every arc.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        force_exponent: float,
        own: Sequence[float],
        repeats: int,
    ) -> None:
        self.exponent, self.smooth = force_exponent, _smooth(force_exponent)
        self.pairs = pairs = all_pairs(mechanism, force_exponent)
        self.nodes, self.gaps = pairs.nodes, pairs.gaps
        self.part, self.shift = pairs.arcs(repeats)
        self.ends = pairs.ends[:, self.part]
        self.centres = (self.ends[0] + self.ends[1]) / 2
        self._own_pairs(np.add.outer(self.shift, own))
        power = _power(self.own.real, force_exponent)
        felt = (power * self.drives).max(axis=(0, 2)) > NOTHING
        idle = np.flatnonzero(~felt)[:1]  # one of them stands for all over which nothing is felt
        self.arcs = np.concatenate((np.flatnonzero(felt), idle))
        forces = self._own(self.arcs)(self.nodes[None]) / pairs.samples[self.part[self.arcs]]
        self.forces: NDArray[Any] = np.ascontiguousarray(forces.swapaxes(0, 1))

    def _own_pairs(self, phase: FloatArray) -> None:
        """Relative cosines + i*sines of the pairs at the ends of each arc, and which drive."""
        ends, middle = self.ends, self.centres[:, None]
        phase = phase - np.rint(phase + middle)
        drives = np.abs(phase + middle) < 0.25
        self.drives = drives
        cosines = np.where(drives, _relative_cosines(phase, ends[..., None]), 0.0)
        turned, self.tangents = 2 * np.pi * phase, np.tan(2 * np.pi * ends)[..., None]
        self.own = cosines + 1j * (np.sin(turned) + self.tangents * np.cos(turned))

    def _own(self, arcs: IntArray) -> Callable[[FloatArray], NDArray[Any]]:
        """T times what is asked of the pairs, at parts of the way along arcs."""
        raise NotImplementedError

    def at(self, arcs: IntArray) -> Callable[[FloatArray], NDArray[Any]]:
        """What is asked of the pairs, along arcs.

        Parameters
        ----------
        arcs : array of int, shape (rows,)
            Arcs.

        Returns
        -------
        callable
            Of parts of the way along each, shape (rows, m) or (1, m): shape (rows, K, m).
        """
        own, total = self._own(arcs), self.pairs.total(self.part[arcs])
        return lambda way: own(way) / total(way)

    def nodes_of(self, *levels: int) -> tuple[NDArray[Any], FloatArray]:
        """What is asked of the pairs at the nodes of rules of the whole turn, and their weights.

        Parameters
        ----------
        *levels : int
            Of the tanh-sinh rules of each arc.

        Returns
        -------
        values : array, shape (K, n)
        weights : array, shape (n, rules)
        """
        start, stop = self.tangents[:, self.arcs]
        way, weights = _rules(*levels)
        whole = 2 * np.pi * (self.ends[1] - self.ends[0]).sum()
        slopes = (stop - start) / ((1 + _between(start, stop, way) ** 2) * whole)
        values = self.at(self.arcs)(way).swapaxes(0, 1)
        weights = slopes[..., None] * weights
        return values.reshape(len(values), -1), weights.reshape(-1, len(levels))


class PinTurn(Turn):
    """Forces of the satellites on a pin over F0, tangential + i*radial; made as `AllPairs`."""

    def __init__(self, mechanism: Mechanism, force_exponent: float) -> None:
        phases = mechanism.phases
        repeats = phases.pins * phases.symmetry
        super().__init__(mechanism, force_exponent, phases.satellite_phase, repeats)

    def _own(self, arcs: IntArray) -> Callable[[FloatArray], ComplexArray]:
        """T times the forces of the satellites on the pin, shape (rows, K, m)."""
        low, high = self.own[:, arcs, :, None]
        drives = self.drives[arcs, :, None]

        def own(way: FloatArray) -> ComplexArray:
            turned = _between(low, high, way[:, None])
            found: ComplexArray = turned * (_power(turned.real, self.exponent) * drives)
            return found

        return own

    @cached_property
    def _polygons(self) -> tuple[FloatArray, FloatArray]:
        """The forces along each arc for v = 1, where they are rational, of degree two, with weights
        t_i of their three control points: the control points, tangential then radial, shape
        (3, arcs, 2*K), and the weights, shape (3, arcs).
        """
        low, high = self.own[:, self.arcs]
        rows = self.part[self.arcs]
        first, last = self.pairs.cosines[:, rows]
        weights = self.pairs.weights[rows]
        ends = (first, first), (first, last), (last, last)
        total = np.array([(weights * x * y).sum(axis=1) for x, y in ends])
        mixed = (low * high.real + high * low.real) / 2
        forces = np.array((low * low.real, mixed, high * high.real)) * self.drives[self.arcs]
        points = forces / total[..., None]
        return np.concatenate((points.real, points.imag), axis=2), total

    def extremes(self, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Largest and least sums of the forces' parts over the turn, in closed form for v = 1.

        Parameters
        ----------
        weights : array, shape (rows, 2*K)
            What unit forces of the satellites do, tangential ones and then radial ones.

        Returns
        -------
        largest, least : array, shape (rows,)
        """
        points, total = self._polygons
        sums = points @ weights.T
        largest, lowered = _highest(np.concatenate((sums, -sums), axis=2), total).reshape(2, -1)
        return largest, -lowered

    def drawn(self) -> tuple[FloatArray, ComplexArray]:
        """Forces over the turn, both sides of every switching angle.

        Returns
        -------
        places : array, shape (n,)
            Ascending, in turns of the wave.
        forces : array, shape (K, n)
        """
        low, high = self.tangents
        parts = np.union1d(self.nodes, DRAWN)
        angles = np.arctan(_between(low, high, parts)) / (2 * np.pi)
        middle = (self.shift + 0.75 + self.centres) % 1.0
        places = angles + (middle - self.centres)[:, None]
        forces = np.zeros((len(self.forces), *places.shape), dtype=np.complex128)
        drawn = self.at(self.arcs)(parts[None])
        forces[:, self.arcs] = drawn.swapaxes(0, 1)
        order = np.argsort(middle, kind="stable")
        return places[order].ravel(), forces[:, order].reshape(len(forces), -1)


class SatelliteTurn(Turn):
    """What the satellites do: their shares ``T_j/T`` of the torque, then their pins' ``S_j/F0``;
    made as `AllPairs`.
    """

    def __init__(self, mechanism: Mechanism, force_exponent: float) -> None:
        phases = mechanism.phases
        pins = np.arange(phases.pins) / phases.pins
        own = np.add.outer(phases.satellite_phase, pins).ravel()
        self.pins = phases.pins
        aligned = len(phases.sector_phases) == phases.symmetry  # no rounding of angles between them
        self.off = 2 * math.pi * ((ROUNDING if aligned else PHASE_ROUNDING) + phases.error)
        super().__init__(mechanism, force_exponent, own.tolist(), phases.symmetry)

    @cached_property
    def coarse_nodes(self) -> tuple[FloatArray, FloatArray]:
        """The same of the two coarsest rules of means."""
        return self.nodes_of(COARSEST, COARSEST + 1)

    @cached_property
    def errors(self) -> FloatArray:
        """Errors of shares and forces by rounding, that of the phases first of all, shape (2*K,).

        Notes
        -----
        A pair's ``c^(1 + v)`` has the slope ``(1 + v)*c^v*s``, its ``c^v`` has ``v*c^(v - 1)*s``;
        pairs of the same satellite raise its share, those of the others lower it.
        """
        v = self.exponent
        way = self.nodes[None]
        low, high = self.own[:, self.arcs, :, None]
        turned = _between(low, high, way[:, None])
        weights = self.drives[self.arcs, :, None] * (turned.real > 0)
        cosines = np.where(weights > 0, turned.real, 1.0)
        tilted = _power(cosines, self.exponent) * np.abs(turned.imag) * weights
        tilted = tilted / self.pairs.samples[self.part[self.arcs]]
        start, stop = self.tangents[:, self.arcs]
        secant = np.sqrt(1 + _between(start, stop, way) ** 2)[:, None]
        share, force = self.forces.reshape(2, -1, *self.forces.shape[1:]).swapaxes(1, 2)
        alone = v * secant / np.maximum(cosines, self.off) - (1 + v) * np.repeat(
            force, self.pins, axis=1
        )
        both = np.stack(((1 + v) * tilted, np.abs(alone) * tilted), axis=1)
        summed = both.reshape(len(both), 2, -1, self.pins, way.shape[1]).sum(axis=3)
        own, first = summed.swapaxes(0, 1)
        others = own.sum(axis=1, keepdims=True) - own
        slopes = np.array(((1 - share) * own + share * others, first + force * others))
        off = self.off * slopes.swapaxes(1, 2).reshape(self.forces.shape)
        found = off + ROUNDING * (ULPS + ULPS_OF_POWER * v) * self.forces
        return np.asarray(found.max(axis=(1, 2)))

    def carried(self, arcs: IntArray) -> Callable[[FloatArray], FloatArray]:
        """T times the shares alone, shape (rows, K, m), at parts of the way along arcs."""
        own, satellites = self._own(arcs), len(self.forces) // 2
        return lambda way: own(way)[:, :satellites]

    def _own(self, arcs: IntArray) -> Callable[[FloatArray], FloatArray]:
        """T times shares and forces."""
        low, high = self.own.real[:, arcs, :, None]
        drives = self.drives[arcs, :, None]
        start, stop = self.tangents[:, arcs]

        def own(way: FloatArray) -> FloatArray:
            cosines = _between(low, high, way[:, None])
            powers = _power(cosines, self.exponent) * drives
            secant = np.sqrt(1 + _between(start, stop, way) ** 2)
            both = np.empty((len(powers), 2, *powers.shape[1:]))
            np.multiply(powers, cosines, out=both[:, 0])
            np.multiply(powers, secant[:, None], out=both[:, 1])
            found: FloatArray = both.reshape(len(both), -1, self.pins, way.shape[1]).sum(axis=2)
            return found

        return own


def _relative_cosines(phase: FloatArray, offset: FloatArray) -> FloatArray:
    """Cosines of pairs over that of the best placed one; exactly 0 where a pair switches.

    Parameters
    ----------
    phase : array
        Phases against the best placed pair, in turns.
    offset : array
        Its pressure angle, in turns.
    """
    away = 0.25 - np.abs(phase + offset)
    best = np.sin(2 * np.pi * (0.25 - np.abs(offset)))
    found: FloatArray = np.where(away > AT_SWITCH, np.sin(2 * np.pi * away), 0.0) / best
    return found


def _between(low: NDArray[Any], high: NDArray[Any], way: FloatArray) -> NDArray[Any]:
    """Between two values; exactly these at the ends."""
    found: NDArray[Any] = low * (1 - way) + high * way
    return found


def _power(cosines: FloatArray, exponent: float) -> FloatArray:
    """Relative cosines to the exponent; 0 where nothing is felt, not numbers beside underflow,
    with which processors take a hundred times as long.
    """
    if exponent == 1:
        return cosines
    if exponent > 1:
        cosines = cosines * (cosines > NOTHING ** (1 / exponent))
    found: FloatArray = cosines**exponent
    return found


def _smooth(exponent: float) -> bool:
    """Whether the forces have a slope and a curvature where a pair switches."""
    return exponent in (0.0, 1.0) or exponent >= 2


@lru_cache(maxsize=16)
def _nodes(exponent: float, many: bool) -> tuple[FloatArray, FloatArray]:
    """Places at which an arc is sampled, as parts of the way: the denser the nearer to an end; the
    distance of the farther neighbour of each.
    """
    first = FIRST / max(exponent, 1.0) if _smooth(exponent) else SINGULAR
    ratio = SPARSE if many else DENSE
    count = math.ceil(math.log(2 * first) / math.log(ratio))
    half = np.concatenate(([0.0], 0.5 * ratio ** np.arange(count, -1, -1.0)))
    nodes = np.concatenate((half, 1 - half[-2::-1]))
    gaps = np.concatenate(([0.0], np.diff(nodes), [0.0]))
    return nodes, np.maximum(gaps[:-1], gaps[1:])


@cache
def _rules(*levels: int) -> tuple[FloatArray, FloatArray]:
    """Nodes of tanh-sinh rules, shape (1, n), and weights of each, shape (n, rules)."""
    halves, own = zip(*map(tanh_sinh_rule, levels), strict=True)
    nodes = np.concatenate(halves)
    weights = np.zeros((len(nodes), len(levels)))
    stop = np.cumsum([len(each) for each in own])
    for k, each in enumerate(own):
        weights[stop[k] - len(each) : stop[k], k] = each
    return np.concatenate((nodes, 1 - nodes))[None], np.concatenate((weights, weights))


def _highest(points: FloatArray, weights: FloatArray) -> FloatArray:
    """Largest value of curves of degree two with weighted control points, shape (3, arcs, rows).

    A curve lies within its control points, so that only an arc whose middle one lies beyond the
    ends of all arcs is looked at within. With ``c_i = t_i*p_i`` the slope of the quotient has the
    coefficients ``c1*t0 - c0*t1, (c2*t0 - c0*t2)/2, c2*t1 - c1*t2``.
    """
    found: FloatArray = np.maximum(points[0], points[2]).max(axis=0)
    arc, row = np.nonzero(points[1] > found)
    t0, t1, t2 = weights[:, arc]
    p0, p1, p2 = points[:, arc, row]
    c0, c1, c2 = p0 * t0, p1 * t1, p2 * t2
    rise, bend, fall = c1 * t0 - c0 * t1, c2 * t0 - c0 * t2, c2 * t1 - c1 * t2
    root = np.sqrt(np.maximum(bend * bend - 4 * rise * fall, 0.0))
    up = bend > 0  # the root at which the slope falls, without a difference of numbers alike
    root += np.abs(bend)
    after, before = np.where(up, root, 2 * rise), np.where(up, -2 * fall, root)
    # the middle point is the highest: both are positive, or both 0 by rounding
    way = after / np.where(after + before > 0, after + before, 1.0)
    left = 1 - way
    b0, b1, b2 = left * left, 2 * way * left, way * way
    inside = (c0 * b0 + c1 * b1 + c2 * b2) / (t0 * b0 + t1 * b1 + t2 * b2)
    np.maximum.at(found, row, inside)
    return found


def combine(*, arms: NDArray[Any], forces: NDArray[Any]) -> NDArray[Any]:
    """Sums of the satellites' forces times what each does.

    Parameters
    ----------
    arms : array, shape (rows, K) or (rows, s, K)
        What unit forces do.
    forces : array, shape (K, m) or (rows, K, m)
        Forces.

    Returns
    -------
    array, shape (rows, m) or (rows, s, m)
        The same column may differ in its last bits where it stands elsewhere.
    """
    alone = arms.ndim < forces.ndim  # each row has forces of its own
    doubled = forces.dtype.kind == "c" and arms.dtype.kind != "c"
    if doubled:  # as twice as many real numbers
        forces = np.ascontiguousarray(forces).view(np.float64)
    found: NDArray[Any] = (arms[:, None] @ forces)[:, 0] if alone else arms @ forces
    return found.view(np.complex128) if doubled else found


all_pairs = lru_cache(maxsize=256)(AllPairs)
"""All pairs of a mechanism that drive over the turn, looked at once."""

pin_turn = lru_cache(maxsize=256)(PinTurn)
"""The forces on a pin of a mechanism, looked at once."""

satellite_turn = lru_cache(maxsize=256)(SatelliteTurn)
"""What the satellites of a mechanism do, looked at once."""
