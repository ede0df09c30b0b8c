"""Energy of discs between a ring and output pins, with all that gives at once: the discs float in
their bearings, or turn in elastic meshes, pins bend, a tie ring joins them. Points in the plane as
complex numbers, linear contacts; scipy finds where the slopes of the energy are zero.

Nothing is shared with ``core``. Unknowns: the lag of the output; of each disc its lag and its shift
on its crank; the bends of each pin at each disc, in the plane; the tie ring's shift and turn.
"""

import math
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import root

from tests.oracles.tie_ring import Pin


class Stored(NamedTuple):
    """Slopes of the energy, and the forces of the contacts."""

    slopes: np.ndarray
    force: np.ndarray  # of output pins, N, shape (K, N)
    ring_force: np.ndarray  # of the ring's pins, N, shape (K, z_p)
    journal: np.ndarray  # of the bearings, N, shape (K,), complex in the frame of the crank
    energy: float  # N*m


class Teeth:
    """A disc as it is cut, on the pins of its ring."""

    def __init__(self, mesh: Any, j: int, crank_angle: float) -> None:
        disc, own = mesh.disc, mesh.deviations
        self.z, self.e = disc.satellite_teeth, disc.eccentricity
        self.tool = disc.ring_pin_radius + disc.modification.equidistant
        self.circle = disc.ring_pin_circle_radius + disc.modification.pin_circle
        ahead = own.crank_phase[j] if own.crank_phase else 0.0
        self.late = (own.disc_phase[j] if own.disc_phase else 0.0) + ahead / self.z
        self.angle = crank_angle + mesh.crank_angles[j] + ahead
        self.crank = 1j * np.exp(-1j * self.angle)
        """Direction of the crank in the frame of the ring."""
        count = self.z + 1
        zeros = (0.0,) * count
        out = 1j * np.exp(2j * np.pi * np.arange(count) / count)
        radial, along = (np.array(row or zeros) for row in (own.pin_radial, own.pin_tangential))
        self.place = out * (disc.ring_pin_circle_radius + radial + 1j * along)
        self.radius = disc.ring_pin_radius + np.array(own.pin_radius or zeros)
        self.start = self.angle / self.z - 2 * np.pi * np.arange(count) / count

    def approaches(self, lag: float, arm: complex) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """How far the pins press in, the outward normals, and the arms of the feet."""
        turned = np.exp(1j * (self.angle / self.z - lag - self.late))
        point, n, t = (self.place - arm * self.crank) / turned, self.z + 1, self.start.copy()

        def path() -> np.ndarray:
            return 1j * (self.circle * np.exp(-1j * t) - self.e * np.exp(-1j * n * t))

        for _ in range(15):
            way = self.circle * np.exp(-1j * t) - n * self.e * np.exp(-1j * n * t)
            bend = -1j * (self.circle * np.exp(-1j * t) - n * n * self.e * np.exp(-1j * n * t))
            apart = point - path()
            under = np.abs(way) ** 2 - (apart * bend.conj()).real
            step = (apart * way.conj()).real / np.where(under > 0, under, np.abs(way) ** 2)
            t = t + np.clip(step, -0.1 / n, 0.1 / n)
        outward = 1j * way / np.abs(way)
        distance = ((point - path()) * outward.conj()).real
        return self.radius - self.tool - distance, outward * turned, path() * turned


def beam(pin: Any, places: tuple[float, ...]) -> np.ndarray:
    """Stiffness of a pin between places, the last of which a tie ring holds, by Timoshenko's
    elements: its slopes are condensed.
    """
    one, nodes = Pin(pin.diameter, pin.bore_diameter), (0.0, *places)
    whole = np.zeros((2 * len(nodes), 2 * len(nodes)))
    for i, (low, high) in enumerate(pairwise(nodes)):
        whole[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += one.element(high - low)
    free = [*range(3, 2 * len(nodes), 2)]
    if pin.tied and pin.ring_joint == "clamped":
        free.pop()
    kept = [*range(2, 2 * len(nodes), 2)]
    corner = whole[np.ix_(kept, free)]
    return whole[np.ix_(kept, kept)] - corner @ np.linalg.solve(whole[np.ix_(free, free)], corner.T)


class Network:
    """Elastic parts at a crank angle under a torque. Deviations of pins, cranks and discs are those
    of the mechanism. Without a ring discs are shifted along their cranks alone.
    """

    def __init__(self, real: Any, ring: Any, crank_angle: float, torque: float) -> None:
        self.real, self.torque = real, torque
        own, made, zeros = real.mechanism, real.deviations, (0.0,) * real.mechanism.satellites
        self.pins, self.discs = own.pins, own.satellites
        self.stiff = real.law.stiffness
        psi = crank_angle * (1 + 1 / own.ratio) + own.initial_crank_angle
        phases = np.array(made.crank_phase or zeros)
        self.crank = 1j * np.exp(-1j * (psi + np.array(own.crank_angles) + phases))
        self.arm = real.eccentricity + np.array(made.eccentricity or zeros)
        self.out = 1j * np.exp(2j * np.pi * np.arange(own.pins) / own.pins)
        none = np.zeros(own.pins)
        radial, along, larger = (
            np.array(row) if row else none
            for row in (made.pin_radial, made.pin_tangential, made.pin_radius)
        )
        self.pin = self.out * (real.pin_circle_radius + radial + 1j * along)
        holes = [
            np.array(row) if row else np.zeros((self.discs, own.pins))
            for row in (made.hole_radial, made.hole_tangential, made.hole_radius)
        ]
        self.hole = self.out * (real.pin_circle_radius + holes[0] + 1j * holes[1])
        self.room = real.eccentricity + real.clearance + holes[2] - larger
        self.teeth = [Teeth(ring, j, crank_angle) for j in range(self.discs)] if ring else []
        self.ring_stiff = ring.law.stiffness if ring else 0.0
        self.late = (
            np.zeros(self.discs)
            if ring
            else -(np.array(made.disc_phase or zeros) + phases / own.ratio)
        )
        support = real.support
        self.bearing, self.loose, self.mesh = support.bearing, support.loose, support.mesh
        self.bent = bool(real.pin.bends or real.pin.tied)
        self.tied = real.pin.tied
        if self.bent:
            places = real.pin.satellite_positions
            self.beam = beam(real.pin, (*places, real.pin.span) if self.tied else places)

    @property
    def sizes(self) -> np.ndarray:
        """Lengths of the unknowns: a lag times this is a displacement."""
        circle = self.real.pin_circle_radius
        bends = 2 * self.pins * self.discs if self.bent else 0
        rest = [1.0] * (2 * self.discs + bends + (2 if self.tied else 0))
        return np.array([circle] * (1 + self.discs) + rest + ([circle] if self.tied else []))

    def at(self, x: np.ndarray) -> Stored:
        """Slopes of the energy at unknowns."""
        count, pins = self.discs, self.pins
        lag, own = x[0], x[1 : 1 + count]
        shift = x[1 + count : 1 + 2 * count] + 1j * x[1 + 2 * count : 1 + 3 * count]
        rest = x[1 + 3 * count :]
        by_lag, by_own, by_shift = -self.torque, np.zeros(count), np.zeros(count, complex)
        bends = np.zeros((pins, count), complex)
        if self.bent:
            flat = rest[: 2 * pins * count].reshape(pins, count, 2)
            bends, rest = flat[..., 0] + 1j * flat[..., 1], rest[2 * pins * count :]
        centre = (self.arm + shift) * self.crank
        place = self.pin * np.exp(-1j * lag)
        energy = -self.torque * lag
        arm = self.hole * np.exp(-1j * (own + self.late))[:, None]
        apart = place + bends.T - arm - centre[:, None]
        # A bearing without a ring acts along its crank alone: its clearance is one of each pin.
        loose = 0.0 if self.teeth else self.loose
        approach = np.abs(apart) - self.room - loose
        force = self.stiff * np.maximum(approach, 0.0)
        energy += float((force * np.maximum(approach, 0.0)).sum()) / 2
        pull = force * apart / np.abs(apart)
        by_lag += (pull.conj() * (-1j * place)).real.sum()
        by_own += (pull.conj() * (1j * arm)).real.sum(axis=1)
        by_shift -= pull.sum(axis=1) / self.crank
        ring_force = []
        for j, teeth in enumerate(self.teeth):
            deep, outward, foot = teeth.approaches(float(own[j]), complex(self.arm[j] + shift[j]))
            pressing = self.ring_stiff * np.maximum(deep, 0.0)
            energy += float((pressing * np.maximum(deep, 0.0)).sum()) / 2
            by_shift[j] += (pressing * outward).sum() / teeth.crank
            by_own[j] += (pressing * (outward.conj() * (-1j * foot)).real).sum()
            ring_force.append(pressing)
        by_own += self.mesh * own
        energy += self.mesh * float(own @ own) / 2
        far = np.abs(shift)
        deep = np.maximum(far - (self.loose if self.teeth else 0.0), 0.0)
        journal = self.bearing * deep * shift / np.where(far > 0, far, 1.0)
        energy += self.bearing * float(deep @ deep) / 2
        by_shift += journal
        slopes = [np.array([by_lag]), by_own, by_shift.real, by_shift.imag]
        if self.bent:
            all_bends = bends
            if self.tied:
                # The ring's turn moves a pin's end as the output turns, against the lag.
                ends = complex(rest[0], rest[1]) + rest[2] * 1j * self.out * self._circle
                all_bends = np.concatenate([bends, ends[:, None]], axis=1)
            back = all_bends @ self.beam
            energy += float((back * all_bends.conj()).real.sum()) / 2
            by_bend = back[:, :count] + pull.T
            slopes.append(np.stack([by_bend.real, by_bend.imag], axis=-1).ravel())
            if self.tied:
                ring = back[:, -1]
                turn = (ring.conj() * 1j * self.out).real.sum() * self._circle
                slopes.append(np.array([ring.real.sum(), ring.imag.sum(), turn]))
        every = np.concatenate(slopes)
        return Stored(every, force, np.array(ring_force), journal, float(energy))

    @property
    def _circle(self) -> float:
        return float(self.real.pin_circle_radius)

    @property
    def held(self) -> np.ndarray:
        """Unknowns that nothing lets move."""
        count, found = self.discs, np.zeros(len(self.sizes), bool)
        found[1 : 1 + count] = not self.teeth and not self.mesh
        gives = bool(self.bearing or (self.teeth and self.loose))
        found[1 + count : 1 + 2 * count] = not gives
        found[1 + 2 * count : 1 + 3 * count] = not (gives and self.teeth)
        return found

    def rest(self, near: np.ndarray) -> Stored:
        """The equilibrium next to unknowns, some micrometres off it."""
        moves, sizes = ~self.held, self.sizes

        def balance(y: np.ndarray) -> np.ndarray:
            x = np.zeros(len(sizes))
            x[moves] = y * 1e-6 / sizes[moves]
            return np.asarray(self.at(x).slopes[moves] / sizes[moves])

        start = (near * sizes * 1e6)[moves]
        found = root(balance, start, method="hybr", options={"xtol": 1e-13, "eps": 1e-10})
        x = np.zeros(len(sizes))
        x[moves] = found.x * 1e-6 / sizes[moves]
        there = self.at(x)
        top = max(there.force.max(), *(each.max() for each in there.ring_force), 1e-300)
        left = np.abs(there.slopes[moves] / sizes[moves]).max()
        assert left < 1e-8 * top, left / top
        for seed in range(6):  # it is a minimum
            way = np.random.default_rng(seed).normal(0, 1e-6, len(sizes)) / sizes * moves
            assert self.at(x + way).energy > there.energy
        assert math.isfinite(there.energy)
        return there
