"""Energy of discs between a ring and output pins, with all that gives at once: the discs float in
their bearings, or turn in elastic meshes, pins bend, a tie ring joins them. Points in the plane as
complex numbers, linear contacts. Doubles lead near to where the energy is least, and from there on
slopes of 40 digits are narrowed until nothing is left of 30.

Nothing is shared with ``core``. Unknowns: the lag of the output; of each disc its lag and its shift
on its crank; the bends of each pin at each disc, in the plane; the tie ring's shift and turn.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp, mpf

from tests.oracles.tie_ring import Pin

LEFT = mpf("1e-30")
"""Rest of the slopes over the largest force."""


class Numbers(NamedTuple):
    """Numbers to calculate with. In products arrays stand first: mpmath's numbers would try to read
    the array, which takes longer than all else.
    """

    one: Any
    pi: Any
    turned: Callable[[Any], Any]  # exp(i*x)
    real: Callable[[Any], Any]
    near: float  # last step of Newton to a foot, rad, which leaves its square


DOUBLES = Numbers(1.0, np.pi, lambda x: np.exp(1j * x), np.real, 1e-8)
DIGITS = Numbers(
    mpf(1), mp.pi, np.frompyfunc(mp.expj, 1, 1), np.frompyfunc(lambda z: z.real, 1, 1), 1e-17
)


class Stored(NamedTuple):
    """Slopes of the energy at unknowns, and the forces of the contacts."""

    x: np.ndarray
    slopes: np.ndarray
    force: np.ndarray  # of output pins, N, shape (K, N)
    ring_force: np.ndarray  # of the ring's pins, N, shape (K, z_p)
    journal: np.ndarray  # of the bearings, N, shape (K,), complex in the frame of the crank
    energy: Any  # N*m

    @property
    def top(self) -> Any:
        """Largest force, N."""
        return max(*self.force.ravel(), *self.ring_force.ravel())


class Teeth:
    """A disc as it is cut, on the pins of its ring."""

    def __init__(self, mesh: Any, j: int, crank_angle: float, kind: Numbers) -> None:
        disc, own, one, self.kind = mesh.disc, mesh.deviations, kind.one, kind
        self.z, self.e = disc.satellite_teeth, one * disc.eccentricity
        self.tool = one * disc.ring_pin_radius + disc.modification.equidistant
        self.circle = one * disc.ring_pin_circle_radius + disc.modification.pin_circle
        ahead = one * (own.crank_phase[j] if own.crank_phase else 0)
        self.late = (own.disc_phase[j] if own.disc_phase else 0) + ahead / self.z
        self.angle = one * crank_angle + mesh.crank_angles[j] + ahead
        self.crank = 1j * kind.turned(-self.angle)
        """Direction of the crank in the frame of the ring."""
        count = self.z + 1
        radial, along, larger = (
            np.array(row or (0.0,) * count) * one
            for row in (own.pin_radial, own.pin_tangential, own.pin_radius)
        )
        pitch = np.arange(count) * (2 * kind.pi / count)
        self.place = 1j * kind.turned(pitch) * (radial + disc.ring_pin_circle_radius + 1j * along)
        self.radius = larger + disc.ring_pin_radius
        self.foot = -pitch + self.angle / self.z

    def approaches(self, lag: Any, arm: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """How far the pins press in, the outward normals, and the arms of the feet."""
        turned, real = self.kind.turned(self.angle / self.z - lag - self.late), self.kind.real
        point, n, last = (self.place - arm * self.crank) / turned, self.z + 1, np.inf
        for _ in range(60):
            first, second = (self.kind.turned(self.foot * -k) for k in (1, n))
            path = (first * self.circle - second * self.e) * 1j
            way = first * self.circle - second * (n * self.e)
            if last < self.kind.near:
                break
            bend = (first * self.circle - second * (n * n * self.e)) * -1j
            apart, square = point - path, real(way * way.conj())
            under = square - real(apart * bend.conj())
            step = real(apart * way.conj()) / np.where(under > 0, under, square)
            self.foot, last = self.foot + np.clip(step, -0.1 / n, 0.1 / n), np.abs(step).max()
        outward = way * 1j / np.abs(way)
        distance = real((point - path) * outward.conj())
        return self.radius - self.tool - distance, outward * turned, path * turned


def beam(pin: Any, kind: Numbers) -> np.ndarray:
    """Stiffness of a pin between its discs and its end, if a tie ring holds it, by Timoshenko's
    elements: all other movements are condensed.
    """
    one, made = kind.one, pin.material
    sizes = pin.diameter, pin.bore_diameter, made.youngs_modulus, made.poissons_ratio
    part = Pin(*(one * each for each in sizes), one * 10 / 9)
    ends = () if pin.support == "cantilever" else (pin.span,)
    nodes = (0.0, *pin.satellite_positions, *ends)
    last = 2 * len(nodes)
    whole = np.zeros((last, last)) * one
    for i, (low, high) in enumerate(pairwise(nodes)):
        whole[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += part.element(one * high - low, kind.pi)
    free = [*range(3, last, 2)]
    if pin.support == "supported":
        free.append(1)
    if pin.support == "fixed" or (pin.tied and pin.ring_joint == "clamped"):
        free.remove(last - 1)
    for k in free:
        whole = whole - np.outer(whole[:, k], whole[k]) / whole[k, k]
    kept = slice(2, last if pin.tied or not ends else last - 2, 2)
    return whole[kept, kept]


class Network:
    """Elastic parts at a crank angle under a torque. Deviations of pins, cranks and discs are those
    of the mechanism. Without a ring discs are shifted along their cranks alone.
    """

    def __init__(
        self, real: Any, ring: Any, crank_angle: float, torque: float, kind: Numbers = DIGITS
    ) -> None:
        self.given, self.kind, one = (real, ring, crank_angle, torque), kind, kind.one
        own, made, support = real.mechanism, real.deviations, real.support
        self.torque, self.pins, self.discs = torque, own.pins, own.satellites

        def errors(*names: str) -> list[np.ndarray]:
            rows = [getattr(made, name) for name in names]
            return [np.array(row) * one if row else np.zeros(1) * one for row in rows]

        off, phases, late = errors("eccentricity", "crank_phase", "disc_phase")
        psi = crank_angle * (1 + 1 / (one * own.ratio)) + own.initial_crank_angle
        self.crank = 1j * kind.turned(-(phases + np.array(own.crank_angles) + psi))
        self.arm = off + np.full(self.discs, real.eccentricity)
        self.circle = one * real.pin_circle_radius
        self.out = 1j * kind.turned(np.arange(own.pins) * (2 * kind.pi / own.pins))
        radial, along, larger = errors("pin_radial", "pin_tangential", "pin_radius")
        self.pin = self.out * (radial + self.circle + 1j * along)
        radial, along, wider = errors("hole_radial", "hole_tangential", "hole_radius")
        self.hole = self.out * (radial + self.circle + 1j * along)
        self.room = wider - larger + (one * real.eccentricity + real.clearance)
        discs = range(self.discs) if ring else ()
        self.teeth = [Teeth(ring, j, crank_angle, kind) for j in discs]
        self.stiff, self.ring_stiff = real.law.stiffness, ring.law.stiffness if ring else 0.0
        self.late = np.zeros(self.discs) if ring else -(late + phases / own.ratio)
        self.bearing, self.loose, self.mesh = support.bearing, support.loose, support.mesh
        self.tied = real.pin.tied
        self.bent = bool(real.pin.bends or self.tied)
        self.beam = beam(real.pin, kind) if self.bent else None

    @property
    def sizes(self) -> np.ndarray:
        """Lengths of the unknowns: a lag times this is a displacement."""
        circle, bends = float(self.circle), 2 * self.pins * self.discs if self.bent else 0
        rest = [1.0] * (2 * self.discs + bends + (2 if self.tied else 0))
        return np.array([circle] * (1 + self.discs) + rest + ([circle] if self.tied else []))

    def at(self, x: np.ndarray) -> Stored:
        """Slopes of the energy at unknowns."""
        count, pins, real = self.discs, self.pins, self.kind.real
        lag, own = x[0], x[1 : 1 + count]
        shift = x[1 + count : 1 + 2 * count] + 1j * x[1 + 2 * count : 1 + 3 * count]
        bends, rest = np.zeros((pins, 1)), x[1 + 3 * count :]
        if self.bent:
            flat = rest[: 2 * pins * count].reshape(pins, count, 2)
            bends, rest = flat[..., 0] + 1j * flat[..., 1], rest[2 * pins * count :]
        centre = (self.arm + shift) * self.crank
        place = self.pin * self.kind.turned(-lag)
        arm = self.hole * self.kind.turned(-(own + self.late))[:, None]
        apart = place + bends.T - arm - centre[:, None]
        # A bearing without a ring acts along its crank alone: its clearance is one of each pin.
        loose = 0.0 if self.teeth else self.loose
        deep = np.maximum(np.abs(apart) - self.room - loose, 0.0)
        force = self.stiff * deep
        energy = (force * deep).sum() / 2 + self.mesh * (own @ own) / 2 - self.torque * lag
        pull = force * apart / np.abs(apart)
        by_lag = real((pull.conj() * place * -1j).sum()) - self.torque
        by_own = real((pull.conj() * arm * 1j).sum(axis=1)) + self.mesh * own
        by_shift = -pull.sum(axis=1) / self.crank
        ring_force = []
        for j, teeth in enumerate(self.teeth):
            deep, outward, foot = teeth.approaches(own[j], self.arm[j] + shift[j])
            deep = np.maximum(deep, 0.0)
            ring_force.append(pressing := self.ring_stiff * deep)
            energy += (pressing * deep).sum() / 2
            by_shift[j] += (pressing * outward).sum() / teeth.crank
            by_own[j] += real((pressing * outward.conj() * foot * -1j).sum())
        far = np.abs(shift)
        deep = np.maximum(far - (self.loose - loose), 0.0)
        journal = self.bearing * deep * shift / np.where(far > 0, far, 1.0)
        energy += self.bearing * (deep @ deep) / 2
        by_shift += journal
        slopes = [np.array([by_lag]), by_own, real(by_shift), real(by_shift * -1j)]
        if self.bent:
            all_bends = bends
            if self.tied:
                # The ring's turn moves a pin's end as the output turns, against the lag.
                ends = self.out * (1j * rest[2] * self.circle) + (rest[0] + 1j * rest[1])
                all_bends = np.concatenate([bends, ends[:, None]], axis=1)
            back = all_bends @ self.beam
            energy += real((back * all_bends.conj()).sum()) / 2
            by_bend = back[:, :count] + pull.T
            slopes.append(np.stack([real(by_bend), real(by_bend * -1j)], axis=-1).ravel())
            if self.tied:
                on_ring = back[:, -1].sum()
                turn = (back[:, -1].conj() * self.out).sum() * (1j * self.circle)
                slopes.append(real(np.array([on_ring, -1j * on_ring, turn])))
        return Stored(x, np.concatenate(slopes), force, np.array(ring_force), journal, energy)

    @property
    def held(self) -> np.ndarray:
        """Unknowns that nothing lets move."""
        count, found = self.discs, np.zeros(len(self.sizes), bool)
        found[1 : 1 + count] = not self.teeth and not self.mesh
        gives = bool(self.bearing or (self.teeth and self.loose))
        found[1 + count : 1 + 2 * count] = not gives
        found[1 + 2 * count : 1 + 3 * count] = not (gives and self.teeth)
        return found

    def unknowns(self, lag: float, own: np.ndarray, shift: np.ndarray) -> np.ndarray:
        """The first unknowns: lags of output and discs, without those due to errors, and shifts."""
        return np.array([lag, *(own - self.late).astype(float), *shift.real, *shift.imag])

    def rest(self, near: np.ndarray) -> Stored:
        """The equilibrium next to lags and shifts; pins are straight at first."""
        moves, sizes, rough = ~self.held, self.sizes, Network(*self.given, DOUBLES)
        ways, step = np.diag(1e-10 / sizes)[moves], np.ones(len(sizes))
        x = np.pad(near, (0, len(sizes) - len(near))) * moves

        def far(step: np.ndarray) -> bool:
            return bool(np.abs(step * sizes).max() > 1e-9)

        while far(step):
            there = rough.at(x)
            rows = [rough.at(x + way).slopes - rough.at(x - way).slopes for way in ways]
            stiff = (np.array(rows) / sizes)[:, moves] / 2e-10
            stiff += np.eye(len(stiff))  # 1 N/m holds discs that carry nothing
            step = np.zeros(len(sizes))
            step[moves] = np.linalg.solve(stiff, (there.slopes / sizes)[moves]) / sizes[moves]
            while far(step) and rough.at(x - step).energy > there.energy:
                step /= 2
            x = x - step
        x = x * mpf(1)
        for _ in range(100):
            there = self.at(x)
            left = (there.slopes / sizes)[moves]
            if np.abs(left).max() < LEFT * there.top:
                break
            x[moves] -= np.linalg.solve(stiff, left.astype(float)) / sizes[moves]
        else:
            raise AssertionError("no equilibrium is near the lags and shifts given")
        assert np.linalg.eigvalsh(stiff).min() > 0  # it is a minimum
        way = np.random.default_rng(1).normal(0, 1e-15, len(sizes)) / sizes * moves
        low, high = (self.at(each).energy - there.energy for each in (x - way, x + way))
        assert abs(high - low) < 1e-9 * (high + low)  # the slopes are those of the energy
        return there
