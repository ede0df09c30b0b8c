"""A cycloid mesh from its definition: pins, crank and disc as points in the plane, 40 digits.

Nothing is shared with ``core``: the disc is a curve at the tool's radius inside the path of the
tool; a pin's approach is its distance from that path, sought along it; levers are differences of
approaches; curvatures those of the outline, by differences too; the lag is narrowed until the
torque of all forces is the load.
"""

from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpc, mpf

DIGITS = 40
STEP = mpf("1e-13")
"""Of differences, rad: they are right to its square."""

FAR = mpf("5e-3")
"""Lag that no play reaches, rad."""


@dataclass(frozen=True, slots=True)
class ExactMesh:
    """Forces satellite by satellite, lags, and what the ring does to the cranks."""

    force: list[mpf]
    rotation: list[mpf]
    across: list[mpf]
    along: list[mpf]
    play: tuple[mpf, mpf] | None
    energy: mpf


class Teeth:
    """A disc on its crank, turned back by a lag."""

    def __init__(self, mesh: Any, j: int, crank_angle: mpf) -> None:
        disc, own = mesh.disc, mesh.deviations
        self.z, self.zp = disc.satellite_teeth, disc.satellite_teeth + 1
        self.e = mpf(disc.eccentricity)
        self.R, self.r = mpf(disc.ring_pin_circle_radius), mpf(disc.ring_pin_radius)
        self.Rm = self.R + mpf(disc.modification.pin_circle)
        self.rm = self.r + mpf(disc.modification.equidistant)

        def error(name: str, index: int) -> mpf:
            values = getattr(own, name)
            return mpf(values[index]) if values else mpf(0)

        ahead = error("crank_phase", j)
        self.angle = crank_angle + mpf(mesh.crank_angles[j]) + ahead
        self.crank = 1j * mp.expj(-self.angle)
        self.centre = (self.e + error("eccentricity", j)) * self.crank
        self.late = error("disc_phase", j) + ahead / self.z
        self.pins = [
            (
                1j * mp.expj(2 * mp.pi * k / self.zp)
                * mpc(self.R + error("pin_radial", k), error("pin_tangential", k)),
                self.r + error("pin_radius", k),
                self.angle / self.z - 2 * mp.pi * k / self.zp,
            )
            for k in range(self.zp)
        ]  # fmt: skip

    def path(self, t: mpf) -> mpc:
        return 1j * (self.Rm * mp.expj(-t) - self.e * mp.expj(-self.zp * t))

    def tangent(self, t: mpf) -> mpc:
        return self.Rm * mp.expj(-t) - self.zp * self.e * mp.expj(-self.zp * t)

    def outline(self, t: mpf) -> mpc:
        way = self.tangent(t)
        return self.path(t) - self.rm * 1j * way / abs(way)

    def pin(self, k: int, lag: mpf) -> tuple[mpf, mpc]:
        """How far a pin presses into the disc, and the outward normal there in the fixed frame."""
        place, radius, t = self.pins[k]
        turned = mp.expj(self.angle / self.z - lag - self.late)
        point = (place - self.centre) / turned
        for _ in range(60):  # the foot: Newton on the distance squared
            apart, way = point - self.path(t), self.tangent(t)
            bend = -1j * (self.Rm * mp.expj(-t) - self.zp**2 * self.e * mp.expj(-self.zp * t))
            slope = (apart * mp.conj(way)).real
            under = abs(way) ** 2 - (apart * mp.conj(bend)).real
            step = slope / (under if under > 0 else abs(way) ** 2)
            step = max(min(step, mpf("0.1") / self.zp), -mpf("0.1") / self.zp)
            t += step
            if abs(step) < mpf(10) ** (5 - DIGITS):
                break
        way = self.tangent(t)
        outward = 1j * way / abs(way)
        apart = point - self.path(t)
        distance = abs(apart) * mp.sign((apart * mp.conj(outward)).real)
        return radius - self.rm - distance, outward * turned

    def lever(self, k: int, lag: mpf) -> mpf:
        return (self.pin(k, lag + STEP)[0] - self.pin(k, lag - STEP)[0]) / (2 * STEP)

    def curved(self, k: int) -> mpf:
        """Sum of the curvatures of a pin and of the outline where they meet without errors."""
        _, radius, t = self.pins[k]
        step = mpf("1e-10")
        low, here, high = self.outline(t - step), self.outline(t), self.outline(t + step)
        first, second = (high - low) / (2 * step), (high - 2 * here + low) / step**2
        return 1 / radius - (mp.conj(first) * second).imag / abs(first) ** 3


def spring(mesh: Any, teeth: Teeth, k: int) -> Any:
    """Force and energy of a pin by its approach."""
    law, name = mesh.law, type(mesh.law).__name__
    if name == "LinearLaw":
        stiff = mpf(law.stiffness)
        return lambda d: (stiff * d, stiff * d * d / 2)
    if name in ("PowerLaw", "PalmgrenLaw"):
        if name == "PowerLaw":
            n = mpf(law.exponent)
            stiff = mpf(law.reference_force) / mpf(law.reference_approach) ** n
        else:
            n = mpf(10) / 9
            per = mpf("3.84e-5") / (1000 * mpf(mesh.contact_length)) ** mpf("0.8") / 1000
            stiff = per**-n
        return lambda d: (stiff * d**n, stiff * d ** (n + 1) / (n + 1))
    radius = teeth.pins[k][1]
    c1, c2 = (
        (1 - mpf(each.poissons_ratio) ** 2) / mpf(each.youngs_modulus)
        for each in (mesh.pin_material, mesh.disc_material)
    )
    nu = mpf(mesh.disc_material.poissons_ratio)
    length = mpf(mesh.contact_length)
    depth = teeth.r if law.reference_depth is None else mpf(law.reference_depth)
    b = (c1 + c2) / (mp.pi * length)
    q = mp.pi * length / (4 * (c1 + c2)) * teeth.curved(k)
    a = c1 * (mp.log(16 * radius**2 * q) - 1) + c2 * (mp.log(4 * depth**2 * q) - nu / (1 - nu))
    a /= mp.pi * length

    def pressed(d: mpf) -> tuple[mpf, mpf]:
        y = -mp.lambertw(-mp.exp(-(a / b - mp.log(d / b))), -1)
        force = (d / (b * y)).real
        stored = force**2 * (a / 2 - b * (mp.log(force) / 2 - mpf(1) / 4))
        return force, force * d - stored

    return pressed


class Balance:
    """All pins of discs that have one lag."""

    def __init__(self, mesh: Any, discs: list[Teeth]) -> None:
        self.discs = discs
        self.springs = [[spring(mesh, one, k) for k in range(one.zp)] for one in discs]

    def torque(self, lag: mpf) -> mpf:
        total = mpf(0)
        for one, laws in zip(self.discs, self.springs, strict=True):
            for k in range(one.zp):
                approach, _ = one.pin(k, lag)
                if approach > 0:
                    total += laws[k](approach)[0] * one.lever(k, lag)
        return total

    def energy(self, lag: mpf) -> mpf:
        total = mpf(0)
        for one, laws in zip(self.discs, self.springs, strict=True):
            for k in range(one.zp):
                approach, _ = one.pin(k, lag)
                if approach > 0:
                    total += laws[k](approach)[1]
        return total

    def balanced(self, torque: mpf) -> mpf:
        """The lag, by false position with halving (Illinois)."""
        low, high = mpf("-1e-5"), mpf("1e-5")
        below, above = self.torque(low) - torque, self.torque(high) - torque
        while above < 0:
            low, below = high, above
            high *= 2
            above = self.torque(high) - torque
        while below > 0:
            high, above = low, below
            low *= 2
            below = self.torque(low) - torque
        side = 0
        for _ in range(200):
            place = (low * above - high * below) / (above - below)
            value = self.torque(place) - torque
            if abs(value) <= mpf("1e-24") * abs(torque) or high - low < mpf("1e-30"):
                break
            if value > 0:
                high, above = place, value
                below = below / 2 if side == 1 else below
                side = 1
            else:
                low, below = place, value
                above = above / 2 if side == -1 else above
                side = -1
        return place


def exact_mesh(mesh: Any, crank_angle: float, torque: float) -> ExactMesh:
    """A position; the torque may be negative."""
    with mp.workdps(DIGITS):
        discs = [Teeth(mesh, j, mpf(crank_angle)) for j in range(len(mesh.crank_angles))]
        if not hasattr(mesh.support, "shares"):
            whole = Balance(mesh, discs)
            lags = [whole.balanced(mpf(torque))] * len(discs)
        else:
            each = zip(discs, mesh.support.shares, strict=True)
            lags = [Balance(mesh, [one]).balanced(mpf(w) * mpf(torque)) for one, w in each]
        force, across, along, energy = [], [], [], mpf(0)
        for one, lag in zip(discs, lags, strict=True):
            on_crank = mpc(0)
            for k in range(one.zp):
                approach, normal = one.pin(k, lag)
                pressing, stored = (
                    spring(mesh, one, k)(approach) if approach > 0 else (mpf(0), mpf(0))
                )
                force.append(pressing)
                energy += stored
                on_crank += pressing * normal / one.crank
            across.append(-on_crank.imag)
            along.append(on_crank.real)
        return ExactMesh(force, lags, across, along, play(discs), energy)


def play(discs: list[Teeth]) -> tuple[mpf, mpf] | None:
    """Lags at which pins touch first, one way and the other; none where they press."""
    ends = {1: mpf("inf"), -1: mpf("-inf")}
    for one in discs:
        longest = one.e * one.z
        for k in range(one.zp):
            lag, lever = mpf(0), one.lever(k, mpf(0))
            if abs(lever) < longest / 50:
                continue
            side = 1 if lever > 0 else -1
            for _ in range(40):
                step = one.pin(k, lag)[0] / one.lever(k, lag)
                lag -= step
                if abs(step) < mpf("1e-26") or abs(lag) > FAR:
                    break
            if abs(lag) < FAR:  # else it comes to another lobe, long after the others
                ends[side] = side * min(side * ends[side], side * lag)
    return (ends[-1], ends[1]) if ends[-1] <= ends[1] else None


def virtual_work(mesh: Any, crank_angle: float, torque: float) -> tuple[mpf, mpf]:
    """Derivatives of the stored energy by the lag, and by the crank angle at that lag: the torque,
    and what the crank gives beyond its part of it. Laws are those of the position.
    """
    with mp.workdps(DIGITS):
        count, step = range(len(mesh.crank_angles)), mpf("1e-11")
        whole = Balance(mesh, [Teeth(mesh, j, mpf(crank_angle)) for j in count])
        lag = whole.balanced(mpf(torque))
        by_lag = (whole.energy(lag + step) - whole.energy(lag - step)) / (2 * step)
        sides = []
        for way in (1, -1):
            whole.discs = [Teeth(mesh, j, mpf(crank_angle) + way * step) for j in count]
            sides.append(whole.energy(lag))
        return by_lag, (sides[0] - sides[1]) / (2 * step)
