"""What a pin feels over the turn, the slow way: looked at closely in doubles, climbed at 40 digits.

Nothing is shared with ``core``: every pair by its own cosine over a whole turn, the law of the
forces as printed, no arcs, no support function. A climb goes along one variable at a time, by
golden section, until nothing grows any more.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise, product

import numpy as np
from mpmath import mp, mpc, mpf

from tests.oracles.crank_planetary import breaks, phases

NEAR = 1e-3
"""How far below the largest, as a part of it, a sample may be that lies beside the largest."""

ENOUGH = mpf("1e-17")
"""Relative growth that ends a climb."""

STEPS = 24
"""Steps of golden section: to a part in 10^5 of a window, which follows the last move."""

PART = np.unique(
    np.concatenate(((1 - np.cos(np.linspace(0, np.pi, 30))) / 2, 10 ** np.linspace(-8, -0.4, 40)))
)
WAY = np.unique(np.concatenate((PART, 1 - PART)))
"""Where a segment is looked at, as parts of the way."""


class Turn:
    """Forces of the satellites on pin 1 over F0, tangential + i*radial."""

    def __init__(self, pins: int, crank_angles: Sequence[mpf], exponent: mpf) -> None:
        rows = phases(pins, crank_angles)
        self.own = [row[0] for row in rows]
        self.all = [t for row in rows for t in row]
        self.exponent = exponent
        self.ends = breaks(self.all, 2 * mp.pi)
        self.parts = list(pairwise(self.ends))
        self.driving = [
            (
                [t for t in self.all if mp.sin((start + stop) / 2 + t) < 0],
                [mp.sin((start + stop) / 2 + t) < 0 for t in self.own],
            )
            for start, stop in self.parts
        ]

    def forces(self, part: int, psi: mpf) -> list[mpc]:
        driving, own = self.driving[part]
        v = self.exponent
        cosines = [max(-mp.sin(psi + t), mpf(0)) for t in driving]
        best = max(cosines)
        total = mp.fsum((c / best) ** v * c if c else mpf(0) for c in cosines)
        found = []
        for t, drives in zip(self.own, own, strict=True):
            c = max(-mp.sin(psi + t), mpf(0))
            if c < mpf("1e-35"):
                c = mpf(0)
            force = (c / best) ** v / total if drives and (c or not v) else mpf(0)
            found.append(force * mp.expj(psi + t + mp.pi / 2))
        return found

    def samples(self, part: int) -> np.ndarray:
        """The same in doubles, shape (K, len(WAY))."""
        start, stop = self.parts[part]
        driving, own = self.driving[part]
        width, v = float(stop - start), float(self.exponent)
        shift = np.array([float(mp.fmod(start + t, 2 * mp.pi)) for t in driving])
        cosines = np.maximum(-np.sin(shift[:, None] + width * WAY), 0)
        best = cosines.max(axis=0)
        total = ((cosines / best) ** v * cosines).sum(axis=0)
        angle = np.array([float(mp.fmod(start + t, 2 * mp.pi)) for t in self.own])
        angle = angle[:, None] + width * WAY + np.pi / 2
        force = (np.maximum(np.cos(angle), 0) / best) ** v / total
        return np.where(np.array(own)[:, None], force, 0) * np.exp(1j * angle)


Window = tuple[mpf, mpf]


def climb(
    value: Callable[[list[mpf]], mpf], place: list[mpf], within: list[Window], window: list[mpf]
) -> mpf:
    """Largest value near a place: golden section along one variable after the other."""
    golden = (mp.sqrt(5) - 1) / 2
    best = value(place)
    for _ in range(200):
        before = best
        for k, (least, most) in enumerate(within):
            if least == most:
                continue

            def along(x: mpf, k: int = k) -> mpf:
                return value([*place[:k], x, *place[k + 1 :]])

            low, high = max(place[k] - window[k], least), min(place[k] + window[k], most)
            ends = [(along(x), x) for x in (low, high)]
            a, b = high - golden * (high - low), low + golden * (high - low)
            at_a, at_b = along(a), along(b)
            for _ in range(STEPS):
                if at_a >= at_b:
                    high, b, at_b = b, a, at_a
                    a = high - golden * (high - low)
                    at_a = along(a)
                else:
                    low, a, at_a = a, b, at_b
                    b = low + golden * (high - low)
                    at_b = along(b)
            found, x = max((at_a, a), (at_b, b), *ends)
            if found > best:
                window[k] = max(4 * abs(x - place[k]), mpf("1e-25"))
                best, place[k] = found, x
        if best - before <= ENOUGH * abs(best):
            break
    return best


def largest(
    turn: Turn,
    coarse: Callable[[np.ndarray], np.ndarray],
    exact: Callable[[list[mpc], mpf], mpf],
    sections: Sequence[mpf],
) -> mpf:
    """Largest measure: in doubles of forces (K, n) for all sections, exactly of forces at one."""
    looked = [coarse(turn.samples(part)) for part in range(len(turn.parts))]
    highest = max(values.max() for values in looked)
    found = []
    for part, values in enumerate(looked):
        if values.max() < highest * (1 - NEAR):
            continue
        section, node = np.unravel_index(int(values.argmax()), values.shape)
        start, stop = turn.parts[part]
        psi = start + (stop - start) * mpf(float(WAY[node]))
        window = (stop - start) * mpf(float(gap(WAY, int(node))))
        x, low, high = around(sections, int(section))
        remembered: dict[mpf, list[mpc]] = {}

        def value(place: list[mpf], part: int = part, known: dict = remembered) -> mpf:  # type: ignore[type-arg]
            psi, x = place
            if psi not in known:
                known[psi] = turn.forces(part, psi)
            return exact(known[psi], x)

        found.append(climb(value, [psi, x], [(start, stop), (low, high)], [window, high - low]))
    return max(found)


def gap(way: np.ndarray, node: int) -> float:
    """Distance of the farther neighbour."""
    low, high = max(node - 1, 0), min(node + 1, len(way) - 1)
    return float(max(way[high] - way[node], way[node] - way[low]))


def around(sections: Sequence[mpf], index: int) -> tuple[mpf, mpf, mpf]:
    """A section and those beside it."""
    last = len(sections) - 1
    return sections[index], sections[max(index - 1, 0)], sections[min(index + 1, last)]


def worst_cycle(
    turn: Turn,
    arms: Callable[[mpf], list[mpf]],
    sections: Sequence[mpf],
    used: Callable[[mpf, mpf], mpf],
    used_of_arrays: Callable[[np.ndarray, np.ndarray], np.ndarray],
) -> mpf:
    """Largest utilisation of any section in any direction by the largest and least moment."""
    samples = [turn.samples(part) for part in range(len(turn.parts))]
    forces = np.concatenate(samples, axis=1)
    size = len(WAY)
    chi = np.linspace(0, 2 * np.pi, 73)[:-1]
    looked = []
    for index, x in enumerate(sections):
        locus = np.array([float(arm) for arm in arms(x)]) @ forces
        along = np.cos(chi)[:, None] * locus.real + np.sin(chi)[:, None] * locus.imag
        top, bottom = along.max(axis=1), along.min(axis=1)
        use = used_of_arrays(top, bottom)
        for k in np.flatnonzero((use >= np.roll(use, 1)) & (use >= np.roll(use, -1))):
            beside = (k - 1) % len(chi), k, (k + 1) % len(chi)
            upper, lower = (
                {int(of[i]) for i in beside} for of in (along.argmax(1), along.argmin(1))
            )
            looked += [(use[k], index, k, ends) for ends in product(upper, lower)]
    highest = max(each[0] for each in looked)
    best = mpf(0)
    seen = set()
    for use, index, k, ends in sorted(looked, reverse=True):
        key = (*(end // size for end in ends), k // 4)
        if use < highest * (1 - 4 * NEAR) or key in seen or len(seen) > 9:
            continue
        seen.add(key)
        x, low, high = around(sections, index)
        place, within, window = (
            [mpf(float(chi[k])), x],
            [(mpf(-9), mpf(9)), (low, high)],
            [
                mpf("0.1"),
                high - low,
            ],
        )
        for end in ends:
            start, stop = turn.parts[end // size]
            place.append(start + (stop - start) * mpf(float(WAY[end % size])))
            within.append((start, stop))
            window.append((stop - start) * mpf(gap(WAY, end % size)) * 2)
        parts = [end // size for end in ends]
        known: dict[tuple[int, mpf], list[mpc]] = {}

        def value(
            place: list[mpf],
            parts: list[int] = parts,
            known: dict = known,  # type: ignore[type-arg]
        ) -> mpf:
            chi, x, *psi = place
            reach = []
            for part, each in zip(parts, psi, strict=True):
                if (part, each) not in known:
                    known[part, each] = turn.forces(part, each)
                moment = mp.fdot(arms(x), known[part, each])
                reach.append(moment.real * mp.cos(chi) + moment.imag * mp.sin(chi))
            return used(*reach)

        best = max(best, climb(value, place, within, window))
    return best
