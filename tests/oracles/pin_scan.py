"""Loads of a pin over the turn, for thousands of pins: a dense scan, then grids that close in.

All is looked at in doubles at once, every summit near the highest is narrowed in all variables
together, and the best are narrowed again at 64 bits. A value found is one that there is, so that
a search that says less, and states less, has missed it; on the corners of a line of fatigue the
grids may end early, up to some 1e-7 below. Nothing is shared with ``core``: each pair by its own
cosine over the whole turn, the law of the forces as printed, the pin by finite elements.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from mpmath import mpf

from tests.oracles.answers.fatigue import Strength
from tests.oracles.answers.pins import Beam
from tests.oracles.pin_turn import long

Array = Any

ENDS = 10 ** np.linspace(-9, -1.2, 16)
WAY = np.unique(np.concatenate(([0.0, 1.0], ENDS, 1 - ENDS, np.linspace(0.1, 0.9, 17))))
"""Where a segment is looked at, as parts of the way."""

NEAR = 1e-2
"""How far below the largest, as a part of it, samples are that are narrowed."""

STARTS = 1500
"""Most places from which is narrowed."""

BEST = 2
"""How many of these are narrowed at 64 bits."""

DIRECTIONS = 360
"""Directions in which a cycle is looked at first."""

SNAP = 1e-17
"""Angles within this of a switch are at it."""

PARTS = 10, 4
"""Into how many parts a stretch of a pin is cut, between two supports and as a cantilever."""

GRID = np.linspace(-1, 1, 9)
AGAIN = 1e4, 1e-9
"""How many times as far about a place as it ended is looked anew, and how far at least."""

BLOCK = 20_000_000
"""Numbers that are worked on at once."""

ROUNDS = ((2, 4e-3, 400), (3, 5e-4, 150), (6, 3e-5, 40), (12, 1e-8, 8))
"""Rounds of grids, how far below the highest a place may be after these, and how many are left."""

PI = np.arctan2(np.longdouble(0), np.longdouble(-1))


class Turn:
    """Forces of the satellites on pin 1 over F0, tangential + i*radial, by segment."""

    def __init__(self, pins: int, crank_angles: Sequence[float], exponent: float) -> None:
        own = np.array([np.longdouble(each) for each in crank_angles])
        phase = (own[:, None] + 2 * PI * np.arange(pins) / pins).ravel()
        self.own = np.arange(len(own)) * pins
        self.exponent = exponent
        turned = np.sort(phase % (2 * PI))
        after = np.append(turned[1:], turned[0] + 2 * PI)
        places = np.concatenate((-phase, PI - phase, -PI / 2 - (turned + after) / 2)) % (2 * PI)
        places = np.sort(places)
        places = places[np.diff(places, append=places[0] + 2 * PI) > SNAP]
        width = np.diff(places, append=places[0] + 2 * PI)
        angle = places[:, None] + phase
        half = np.rint(angle / PI)
        base = angle - half * PI
        base = np.where(np.abs(base) < SNAP, 0, base)
        base = np.where(np.abs(base + width[:, None]) < SNAP, -width[:, None], base)
        self.base, self.width = base, width
        self.sign = np.where(half % 2 == 0, -1.0, 1.0)
        self.drives = np.where(base + width[:, None] / 2 > 0, self.sign, -self.sign) > 0
        self.rough = base.astype(float), width.astype(float)

    def forces(self, part: Array, way: Array) -> Array:
        """Forces of segments (n,) at parts of the way (n, m), shape (n, K, m)."""
        base, width = (self.base, self.width) if way.dtype != np.float64 else self.rough
        turned = base[part][:, :, None] + (width[part][:, None] * way)[:, None]
        sign = self.sign[part][:, :, None]
        cosine = np.where(self.drives[part][:, :, None], np.maximum(sign * np.sin(turned), 0), 0)
        best = cosine.max(axis=1, keepdims=True)
        power = self.drives[part][:, :, None] * (cosine / best) ** way.dtype.type(self.exponent)
        total = (power * cosine).sum(axis=1, keepdims=True)
        own, turned, sign = (each[:, self.own] for each in (cosine, turned, sign))
        return power[:, self.own] / total * (own - 1j * sign * np.cos(turned))

    def scanned(self) -> Array:
        """At all segments' `WAY`, shape (K, s, n)."""
        some = max(1, BLOCK // (self.base.shape[1] * len(WAY)))
        every = np.arange(len(self.width))
        parts = [every[i : i + some] for i in range(0, len(every), some)]
        ways = (np.broadcast_to(WAY, (len(part), len(WAY))) for part in parts)
        found = [self.forces(*each) for each in zip(parts, ways, strict=True)]
        return np.concatenate(found).swapaxes(0, 1)


GAPS = np.maximum(np.maximum(np.diff(WAY, prepend=0.0), np.diff(WAY, append=1.0)), 1e-4)
"""How far about each of these is looked first."""


@dataclass
class Places:
    """Places of a grid in several variables: each shape (n,), and how far about them is looked."""

    at: list[Array]
    window: list[Array]
    low: list[Array]
    high: list[Array]

    def of(self, index: Array) -> "Places":
        return Places(*([each[index] for each in row] for row in self.rows))

    @property
    def rows(self) -> tuple[list[Array], ...]:
        return self.at, self.window, self.low, self.high

    def long(self) -> "Places":
        return Places(*([each.astype(np.longdouble) for each in row] for row in self.rows))


Value = Callable[[Array, list[Array]], tuple[Array, list[Array]]]
"""Of rows and their grids (n, m): the largest value of each row, and where on each grid."""


def narrowed(value: Value, key: Array, places: Places, rounds: int) -> Array:
    """Largest values near places, by grids that are halved, or doubled where the best is at the
    edge; `places` moves there.
    """
    best = np.full(len(key), -np.inf)
    every = np.arange(len(key))
    for _ in range(rounds):
        grids = [
            np.clip(
                at[:, None] + window[:, None] * GRID.astype(at.dtype), low[:, None], high[:, None]
            )
            if window.any()
            else at[:, None]
            for at, window, low, high in zip(*places.rows, strict=True)
        ]
        found, index = value(key, grids)
        best = np.maximum(best, found)
        free = [k for k, grid in enumerate(grids) if grid.shape[1] > 1]
        edges = np.zeros((len(grids), len(key)), dtype=bool)
        for k in free:
            places.at[k] = at = grids[k][every, index[k]]
            inside = (at > places.low[k]) & (at < places.high[k])
            edges[k] = ((index[k] == 0) | (index[k] == len(GRID) - 1)) & inside
        held = edges.any(axis=0)  # one that has to go far waits for no other
        for k in free:
            factor = np.where(edges[k], 4.0, np.where(held, 1.0, 0.5))
            places.window[k] = places.window[k] * factor
    return best


def climbed(value: Value, key: Array, places: Places) -> tuple[Any, int]:
    """The largest value of all places, and of which row it is."""
    at, index = places, np.arange(len(key))
    for rounds, near, most in ROUNDS:
        found = narrowed(value, key[index], at, rounds)
        kept = np.flatnonzero(found >= found.max() * (1 - near))
        kept = kept[np.argsort(-found[kept], kind="stable")]
        kept = kept[:most]
        at, index = at.of(kept), index[kept]
    at, index = at.of(np.arange(len(index))[:BEST]).long(), index[:BEST]
    window = [each.copy() for each in at.window]
    best = narrowed(value, key[index], at, 34)
    while True:
        at.window = [np.maximum(each * AGAIN[0], AGAIN[1] * (each > 0)) for each in window]
        again = narrowed(value, key[index], at, 50)
        if not (again > best).any():
            break
        gain = (again / best - 1).max()
        best = np.maximum(best, again)
        if gain < 1e-18:
            break
    top = int(best.argmax())
    return best[top], int(index[top])


def largest(
    turn: Turn,
    scanned: Array,
    measure: Callable[[Array, Array], Array],
    x: Array,
    within: tuple[Array, Array, Array] | None = None,
) -> Any:
    """Largest measure of forces (n, K, m) at sections (n, s), shape (n, s, m).

    Sections x stand alone, or are looked at between their neighbours: (window, low, high).
    """
    count, parts, nodes = scanned.shape
    values = np.concatenate(
        [measure(scanned.reshape(1, count, -1), x[None, [i]])[0] for i in range(len(x))]
    ).reshape(len(x), parts, nodes)
    beside = np.concatenate((values[..., :1], values, values[..., -1:]), axis=-1)
    tops = (values >= np.maximum(beside[..., :-2], beside[..., 2:])) & (
        values >= values.max() * (1 - NEAR)
    )
    if within is not None:
        high = np.where(tops, values, -np.inf).max(axis=2)
        around = np.concatenate((high[:1], high, high[-1:]))
        tops &= (high >= np.maximum(around[:-2], around[2:]))[..., None]
    row, part, node = np.nonzero(tops)
    order = np.argsort(-values[row, part, node], kind="stable")[:STARTS]
    row, part, node = row[order], part[order], node[order]
    zero = np.zeros(len(row))
    window, low, high = (zero, x[row], x[row]) if within is None else (each[row] for each in within)
    places = Places([WAY[node], x[row]], [GAPS[node], window], [zero, low], [zero + 1, high])

    def value(key: Array, grids: list[Array]) -> tuple[Array, list[Array]]:
        way, section = grids
        found = measure(turn.forces(key, way), section)
        index = found.reshape(len(found), -1).argmax(axis=1)
        s, m = np.divmod(index, found.shape[2])
        return found[np.arange(len(found)), s, m], [m, s]

    return climbed(value, part, places)[0]


def worst_cycle(
    turn: Turn,
    scanned: Array,
    moment: Callable[[Array], Array],
    used: Callable[[Array, Array], Array],
    x: Array,
    within: tuple[Array, Array, Array],
) -> Any:
    """Largest utilisation of any section in any direction by its largest and least stress.

    ``moment`` of sections (n, s) are arms (n, s, K).
    """
    nodes = scanned.shape[2]
    flat = scanned.reshape(len(scanned), -1)
    chi = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    step = chi[1]
    turned = np.stack((np.cos(chi), np.sin(chi)), axis=1)
    seen: dict[tuple[int, ...], tuple[float, int, int, int, int]] = {}
    looked = []
    for i in range(len(x)):
        locus = moment(x[None, [i]])[0, 0] @ flat
        along = turned @ np.stack((locus.real, locus.imag))
        upper = along.argmax(axis=1)
        lower = np.roll(upper, -DIRECTIONS // 2)
        top = along.max(axis=1)
        looked.append((used(top, -np.roll(top, -DIRECTIONS // 2)), upper, lower))
    use = np.array([each[0] for each in looked])
    most = use.max()
    near = use >= most * (1 - NEAR)
    starts = []
    for i, k in zip(*np.nonzero(near), strict=True):
        _, upper, lower = looked[i]
        around = [(k - 1) % DIRECTIONS, k, (k + 1) % DIRECTIONS]
        for a in {int(upper[j]) for j in around}:
            for b in {int(lower[j]) for j in around}:
                key = (a // nodes, b // nodes, k // 12, i // 4)
                if key not in seen or seen[key][0] < use[i, k]:
                    seen[key] = (use[i, k], i, k, a, b)
    starts = sorted(seen.values(), reverse=True)[:STARTS]
    _, i, k, a, b = (np.array(each) for each in zip(*starts, strict=True))
    one = np.ones(len(i))
    window, low, high = (each[i] for each in within)
    places = Places(
        [WAY[a % nodes], WAY[b % nodes], x[i], chi[k]],
        [GAPS[a % nodes], GAPS[b % nodes], window, step * one],
        [0 * one, 0 * one, low, -9 * one],
        [one, one, high, 9 * one],
    )
    parts_of = np.stack((a // nodes, b // nodes), axis=1)

    def value(key: Array, grids: list[Array]) -> tuple[Array, list[Array]]:
        up, down, section, angle = grids
        arms = moment(section)
        cosine, sine = np.cos(angle)[:, None, :, None], np.sin(angle)[:, None, :, None]
        ends = []
        for n, way in enumerate((up, down)):
            sums = (arms @ turn.forces(parts_of[key, n], way))[:, :, None]
            ends.append(cosine * sums.real + sine * sums.imag)
        top, bottom = ends
        found = used(top.max(axis=3), bottom.min(axis=3))
        index = found.reshape(len(found), -1).argmax(axis=1)
        s, c = np.divmod(index, found.shape[2])
        every = np.arange(len(found))
        return found[every, s, c], [
            top[every, s, c].argmax(axis=1),
            bottom[every, s, c].argmin(axis=1),
            s,
            c,
        ]

    return climbed(value, np.arange(len(i)), places)[0]


def pin_extremes(design: dict[str, Any]) -> dict[str, Any]:
    """Results of `core.output.pin_strength` for a design, at 64 bits: force, moment, shear force,
    equivalent stress, deflection, slope and the safety in fatigue.
    """
    mechanism, span, d = design["mechanism"], design["span"], design["diameter"]
    material, strength = design["material"], design["fatigue"]
    body = {  # any units that fit together
        "diameter_mm": d,
        "contact_length_mm": design["contact_length"],
        "satellite_positions_mm": list(design["satellite_positions"]),
        "support": design["support"],
        "material": {
            "youngs_modulus_GPa": material.youngs_modulus / 1000,
            "poissons_ratio": material.poissons_ratio,
        },
    }
    beam = Beam(body if span is None else body | {"span_mm": span})
    modulus, area = PI * np.longdouble(d) ** 3 / 32, PI * np.longdouble(d) ** 2 / 4
    turn = Turn(mechanism.pins, mechanism.crank_angles, design["force_exponent"])
    scanned = turn.scanned()
    unit = np.longdouble(design["output_torque"]) / np.longdouble(design["pin_circle_radius"])
    arms, loads = _Arms(beam), np.arange(mechanism.satellites).astype(float)
    x, within = _sections(beam, span)

    def equivalent(forces: Array, x: Array) -> Array:
        s = arms.moments(x) @ forces / x.dtype.type(modulus)
        t = arms.shears(x) @ forces * (np.sqrt(x.dtype.type(3)) * 4 / 3 / x.dtype.type(area))
        # on the edge of the section, at the worst of all places
        return np.sqrt((np.abs(s) ** 2 + np.abs(t) ** 2 + np.abs(s * s - t * t)) / 2)

    def of_each(table: Array) -> Any:
        rows = np.array([[long(mpf(arm)) for arm in row] for row in table])
        size = np.abs(rows).max()
        rows = rows / size
        return size * largest(
            turn,
            scanned,
            lambda forces, k: np.abs(rows.astype(k.dtype)[k.astype(int)] @ forces),
            loads,
        )

    tensile, yields, limit = (
        mpf(each) / 10**6
        for each in (strength.tensile_strength, strength.yield_strength, strength.endurance_limit)
    )
    judge = Strength(
        {"criterion": strength.criterion, "endurance_limit_MPa": 1.0}, d, tensile, yields
    )
    judge.limit = limit
    scale = unit / modulus / 10**6

    def used(top: Array, bottom: Array) -> Array:
        size = top.dtype.type(scale)
        return judge.use(size * top, size * bottom).astype(top.dtype)

    def over(measure: Callable[[Array, Array], Array]) -> Any:
        return unit * largest(turn, scanned, measure, x, within)

    return {
        "peak_force": unit * of_each(np.eye(mechanism.satellites)),
        "peak_moment": over(lambda forces, x: np.abs(arms.moments(x) @ forces)),
        "peak_shear_force": over(lambda forces, x: np.abs(arms.shears(x) @ forces)),
        "peak_equivalent_stress": over(equivalent),
        "deflection": unit * of_each(beam.deflections),
        "slope": unit * of_each(beam.slopes),
        "safety_factor": 1 / worst_cycle(turn, scanned, arms.moments, used, x, within),
    }


class _Arms:
    """Moments and shear forces of unit forces of the satellites at sections (n, s)."""

    def __init__(self, beam: Beam) -> None:
        self.place = np.array([long(z) for z in beam.places])
        self.half = long(beam.half)
        self.shear, self.moment = (np.array([long(row[k]) for row in beam.start]) for k in (0, 1))

    def _at(self, x: Array) -> tuple[Array, ...]:
        kind = x.dtype
        place, shear, moment = (each.astype(kind) for each in (self.place, self.shear, self.moment))
        return x[..., None], place - kind.type(self.half), 2 * kind.type(self.half), shear, moment

    def moments(self, x: Array) -> Array:
        """Shape (n, s, K)."""
        x, before, length, shear, moment = self._at(x)
        into = np.clip(x - before, 0, length)
        return moment - shear * x + into / length * (x - before - into / 2)

    def shears(self, x: Array) -> Array:
        """Shape (n, s, K)."""
        x, before, length, shear, _ = self._at(x)
        return shear - np.clip((x - before) / length, 0, 1)


def _sections(beam: Beam, span: float | None) -> tuple[Array, tuple[Array, Array, Array]]:
    """Sections, and how far about each is looked first, and at most from where to where."""
    ends = {mpf(0)} | {z + side * beam.half for z in beam.places for side in (-1, 1)}
    if span is not None:
        ends.add(mpf(span))
    top = mpf(span) if span is not None else max(ends)
    parts = PARTS[span is None]
    places = [mpf(0)]
    for start, stop in pairwise(sorted(each for each in ends if 0 <= each <= top)):
        places += [start + (stop - start) * i / parts for i in range(1, parts + 1)]
    x = np.array([float(each) for each in places])
    before, after = np.concatenate((x[:1], x[:-1])), np.concatenate((x[1:], x[-1:]))
    apart = after - before
    low, high = np.maximum(before - apart, 0.0), np.minimum(after + apart, float(top))
    return x, (apart / 2, low, high)
