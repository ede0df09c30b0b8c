"""Pins that a floating tie ring joins, as a frame: every pin of Timoshenko's elements in two
planes, the ring as three movements of their ends. None of the closed forms is used.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

TURNS = 400
"""Turns of Gauss and Seidel at a lag, of which few are needed."""


class Pin(NamedTuple):
    """A round pin, or a tube, of one material."""

    diameter: float
    bore: float = 0.0
    youngs_modulus: float = 210e9
    poissons_ratio: float = 0.3
    shear_factor: float = 10 / 9

    def element(self, length: float, pi: float = math.pi) -> np.ndarray:
        """Stiffness of an element by deflection and slope of its ends, exact for loads at ends."""
        inertia = pi * (self.diameter**4 - self.bore**4) / 64
        area = pi * (self.diameter**2 - self.bore**2) / 4
        bending = self.youngs_modulus * inertia
        shear = self.youngs_modulus / (2 * (1 + self.poissons_ratio)) * area / self.shear_factor
        phi, x = 12 * bending / (shear * length**2), length
        return (bending / (x**3 * (1 + phi))) * np.array(
            [[12, 6 * x, -12, 6 * x],
             [6 * x, (4 + phi) * x * x, -6 * x, (2 - phi) * x * x],
             [-12, -6 * x, 12, -6 * x],
             [6 * x, (2 - phi) * x * x, -6 * x, (4 + phi) * x * x]]
        )  # fmt: skip


class Loaded(NamedTuple):
    """The frame under forces at places along the pins; vectors of the fixed frame as complex."""

    deflections: np.ndarray  # of each pin at each place, m, shape (K, N)
    ring_forces: np.ndarray  # of the ring on each pin, N, shape (N,)
    root_moments: np.ndarray  # N*m, shape (N,)
    end_moments: np.ndarray  # N*m, shape (N,)
    shift: complex  # of the ring, m
    along: float  # along the circle of the pins, m


class Frame:
    """N pins, evenly spaced, their roots built in, their ends in the ring.

    Parameters
    ----------
    pins : sequence of Pin
        The pins, which may differ.
    joint : str
        ``"pinned"`` or ``"clamped"``.
    span : float
        From the roots to the ring, m.
    places : sequence of float
        Where the satellites load the pins, m.
    parts : int
        Elements between them.
    """

    def __init__(
        self,
        pins: Sequence[Pin],
        joint: str,
        span: float,
        places: Sequence[float],
        parts: int = 3,
    ) -> None:
        self.pins, self.joint, self.span, self.places = pins, joint, span, places
        stops = [0.0, *sorted({*places, span})]
        nodes = [0.0]
        for low, high in pairwise(stops):
            nodes += np.linspace(low, high, parts + 1)[1:].tolist()
        self.nodes = np.array(nodes)
        count = len(nodes)
        self.own = 4 * count  # of a pin: deflection and slope in x, then in y
        self.elements = []
        whole = np.zeros((self.own * len(pins),) * 2)
        for n, pin in enumerate(pins):
            for plane in range(2):
                first = n * self.own + plane * 2 * count
                for i, length in enumerate(np.diff(self.nodes)):
                    at = np.arange(4) + first + 2 * i
                    stiffness = pin.element(float(length))
                    whole[np.ix_(at, at)] += stiffness
                    self.elements.append((at, stiffness))
        # all movements by the free ones: roots stand still, ends go with the ring
        kept, ends = [], []
        for n in range(len(pins)):
            for plane in range(2):
                first, end = n * self.own + plane * 2 * count, 2 * count - 2
                kept += [first + k for k in range(2, end)]
                kept += [first + end + 1] if joint == "pinned" else []  # its slope
                ends.append((n, plane, first + end))
        self.by_free = np.zeros((len(whole), len(kept) + 3))
        for column, row in enumerate(kept):
            self.by_free[row, column] = 1.0
        for n, plane, row in ends:
            self.by_free[row, len(kept) + plane] = 1.0
            self.by_free[row, len(kept) + 2] = self.along(n)[plane]
        self.whole = whole
        self.inverse = np.linalg.inv(self.by_free.T @ whole @ self.by_free)

    def along(self, n: int) -> np.ndarray:
        """Tangential direction at a pin; the first is at the top, and the next go to the left."""
        beta = 2 * math.pi * n / len(self.pins)
        return np.array([-math.cos(beta), -math.sin(beta)])

    def _row(self, n: int, plane: int, place: float) -> int:
        node = int(np.abs(self.nodes - place).argmin())
        return n * self.own + plane * 2 * len(self.nodes) + 2 * node

    def under(self, forces: np.ndarray) -> Loaded:
        """The frame under forces on each pin at each place, complex, shape (K, N)."""
        count, load = len(self.pins), np.zeros(len(self.whole))
        for (j, n), force in np.ndenumerate(forces):
            load[self._row(n, 0, self.places[j])] += force.real
            load[self._row(n, 1, self.places[j])] += force.imag
        free = self.inverse @ (self.by_free.T @ load)
        moved = self.by_free @ free
        held = self.whole @ moved - load  # what holds: roots and ring

        def read(values: np.ndarray, step: int, place: float) -> np.ndarray:
            x, y = ([self._row(n, plane, place) + step for n in range(count)] for plane in (0, 1))
            return np.asarray(values[x] + 1j * values[y])

        return Loaded(
            deflections=np.array([read(moved, 0, place) for place in self.places]),
            ring_forces=read(held, 0, self.span),
            root_moments=-read(held, 1, 0.0),
            end_moments=read(held, 1, self.span),
            shift=complex(free[-3], free[-2]),
            along=float(free[-1]),
        )


class Shared(NamedTuple):
    """A position of the load sharing."""

    lag: float  # rad
    forces: np.ndarray  # N, shape (K, N)


def shared(
    *,
    frame: Frame,
    radius: float,
    cranks: Sequence[float],
    gaps: np.ndarray,
    stiffness: float,
    torque: float,
    psi: float,
) -> Shared:
    """Forces of contacts with gaps, shape (K, N), and one stiffness, by unit loads of the frame:
    at a lag by Gauss and Seidel, and the lag by halving.
    """
    pins, satellites = len(frame.pins), len(cranks)
    normal = [1j * np.exp(-1j * (psi + crank)) for crank in cranks]
    along = np.array([complex(*frame.along(n)) for n in range(pins)])
    lever = np.array([radius * (each * along.conj()).real for each in normal]).ravel()
    count = pins * satellites
    give = np.zeros((count, count))
    for i in range(count):
        j, n = divmod(i, pins)
        unit = np.zeros((satellites, pins), dtype=complex)
        unit[j, n] = normal[j]
        bent = frame.under(unit).deflections
        give[i] = np.concatenate([(bent[k] * np.conj(normal[k])).real for k in range(satellites)])
    stiff = give + np.eye(count) / stiffness

    def at(lag: float, force: np.ndarray) -> np.ndarray:
        wanted = lag * lever - gaps.ravel()
        for _ in range(TURNS):
            before = force.copy()
            for i in range(count):
                rest = wanted[i] - stiff[i] @ force + stiff[i, i] * force[i]
                force[i] = max(rest / stiff[i, i], 0.0)
            if np.abs(force - before).max() <= 1e-14 * max(force.max(), 1.0):
                break
        return force

    low, high, force = 0.0, 1.0, np.zeros(count)
    for _ in range(60):
        middle = (low + high) / 2
        force = at(middle, force)
        if force @ lever > torque:
            high = middle
        else:
            low = middle
    return Shared((low + high) / 2, force.reshape(satellites, pins))
