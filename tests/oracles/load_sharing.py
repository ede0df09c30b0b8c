"""The mechanism with clearance and errors from its definition: vectors, false position, 45 digits.

Nothing is shared with ``core``: pins and holes are points in the plane, the lag is narrowed until
the torque of all forces is the load; no derivative, no shift, no Newton: false position, whose
result must change the sign, else bisection. Hertz's law is inverted with Lambert's W, a pin in
series by bisection. Of satellites that give the place or the angle is sought inside.
"""

from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpc, mpf

DIGITS = 45
SAME = mpf("1e-25")
"""Lengths below it are none, m."""


@dataclass(frozen=True, slots=True)
class Exact:
    """Forces satellite by satellite, lag and play in the sense of the driving torque."""

    force: list[mpf]
    rotation: mpf
    play: tuple[mpf, mpf] | None
    torques: list[mpf]


def exact_position(real: Any, crank_angle: float, torque: float) -> Exact:
    """A position; the torque may be negative."""
    with mp.workdps(DIGITS):
        return _position(real, mpf(crank_angle), mpf(torque))


def _position(real: Any, crank_angle: mpf, torque: mpf) -> Exact:
    held, far = (
        _held(real),
        (mpf(real.eccentricity) + max(real.clearance, 0)) / real.pin_circle_radius * 3,
    )
    satellites = _pairs(real, crank_angle)
    if hasattr(held, "stiffness") and not hasattr(held, "radial_clearance"):
        far += abs(torque) / held.stiffness  # each disc turns in its mesh by that at most
    if hasattr(held, "shares"):
        shares = [*map(mpf, held.shares)]
        apart = [
            _balanced(real, [each], share * torque, far)
            for each, share in zip(satellites, shares, strict=True)
        ]
        ends = [each.play for each in apart]
        return Exact(
            [force for each in apart for force in each.force],
            mp.fdot(shares, [each.rotation for each in apart]),
            None
            if None in ends
            else tuple(mp.fdot(shares, end) for end in zip(*ends, strict=True)),
            [each.torques[0] for each in apart],
        )
    return _balanced(real, satellites, torque, far)


def _held(real: Any) -> Any:
    return getattr(real, "support", None)


def _balanced(real: Any, satellites: list, torque: mpf, far: mpf) -> Exact:
    def loaded(lag: mpf) -> list:
        return [_loaded(real, pairs, lag) for pairs in satellites]

    def balance(lag: mpf) -> mpf:
        return mp.fsum(own for _, own in loaded(lag)) - torque

    lag = _root(balance, -far, far)
    found = loaded(lag)
    every = [pair for pairs in satellites for pair in pairs]

    def worst(lag: mpf) -> mpf:
        return max(approach for _, approach, *_ in _state(real, every, lag))

    # Play: around the lag at which the worst approach is least, as far as nothing touches.
    middle = mpf(0) if worst(mpf(0)) < SAME else _least(worst, -far, far)
    play = None
    if worst(middle) < SAME:
        play = (
            -_root(lambda off: worst(-off), -middle, far),
            _root(worst, middle, far),
        )
    forces = [force for own, _ in found for force in own]
    return Exact(forces, lag, play, [own for _, own in found])


def _loaded(real: Any, pairs: list, lag: mpf) -> tuple[list[mpf], mpf]:
    """Forces and torque of one satellite at a lag of the output."""

    def loaded(back: mpf) -> tuple[list[mpf], mpf, mpf]:
        """Forces, and what they do to the output and to what gives."""
        state = _state(real, pairs, lag, back)
        own = [law(approach) for law, approach, _, _ in state]
        return own, *(mp.fdot(own, [each[i] for each in state]) for i in (2, 3))

    held, back = _held(real), mpf(0)
    if hasattr(held, "stiffness"):  # the disc moves back along its crank, or turns in the mesh
        gives = 1 / mpf(held.stiffness)
        far = gives * loaded(back)[2]
        low, high = sorted((back, far))
        if not hasattr(held, "radial_clearance") and not loaded(lag)[2]:  # turned as far it is free
            reach = (mpf(real.eccentricity) + max(real.clearance, 0)) / real.pin_circle_radius * 3
            low, high = sorted((lag, mp.sign(lag) * max(abs(lag) - reach, 0)))
        back = _root(lambda x: x - gives * loaded(x)[2], low, high)
    return loaded(back)[:2]


def _root(f, low: mpf, high: mpf) -> mpf:
    """Root of an increasing function: false position (Illinois), sure by the signs beside it."""
    close = mpf(10) ** (8 - DIGITS)
    left, right, side, last = f(low), f(high), 0, mp.inf
    if left >= 0 or right <= 0:
        return low if left >= 0 else high
    for _ in range(60):
        x = (low * right - high * left) / (right - left)
        here = f(x)
        width = abs(x) * close + mpf(10) ** -DIGITS
        if here == 0:
            return x
        near = abs(x - last) < mp.sqrt(width)  # else it is not worth a look
        if here < 0:
            if near and f(x + width) >= 0:
                return x
            low, left = x, here
            right, side = (right / 2 if side == -1 else right), -1
        else:
            if near and f(x - width) <= 0:
                return x
            high, right = x, here
            left, side = (left / 2 if side == 1 else left), 1
        last = x
    return _bisected(lambda x: f(x) < 0, low, high)


def _bisected(below, low: mpf, high: mpf) -> mpf:
    for _ in range(int(DIGITS * 3.33)):
        middle = (low + high) / 2
        low, high = (middle, high) if below(middle) else (low, middle)
    return (low + high) / 2


def _least(f, low: mpf, high: mpf) -> mpf:
    """Place at which a function is least, or anywhere below 0."""
    for _ in range(110):
        a, b = (2 * low + high) / 3, (low + 2 * high) / 3
        at_a, at_b = f(a), f(b)
        if at_a < 0:
            return a
        low, high = (low, b) if at_a < at_b else (a, high)
    return (low + high) / 2


def _pairs(real: Any, crank_angle: mpf) -> list:
    """Law, pin, crank, hole from there and largest distance of the centres of pin and hole for each
    pair, satellite by satellite; lever and gap in first order.
    """
    m, d = real.mechanism, real.deviations
    ratio, start = mpf(m.ratio), mpf(m.initial_crank_angle)
    psi = crank_angle * (1 + 1 / ratio) + start
    bent = (
        pin_give(real.pin) if hasattr(real.pin, "satellite_positions") else [mpf(0)] * m.satellites
    )

    def of(values, *place):
        for index in place:
            values = values[index] if values else 0
        return mpf(values or 0)

    pairs = []
    for j, angle in enumerate(m.crank_angles):
        phase = of(d.crank_phase, j)
        eta = of(d.disc_phase, j) + phase / ratio
        crank = mpc(0, 1) * mp.expj(-(psi + angle + phase))
        e = real.eccentricity + of(d.eccentricity, j)
        pairs.append([])
        for n in range(m.pins):
            radial = mpc(0, 1) * mp.expj(2 * mp.pi * n / m.pins)
            r_p, r_h = of(d.pin_radius, n), of(d.hole_radius, j, n)
            pin = radial * mpc(
                real.pin_circle_radius + of(d.pin_radial, n), of(d.pin_tangential, n)
            )
            hole = radial * mpc(
                real.pin_circle_radius + of(d.hole_radial, j, n), of(d.hole_tangential, j, n)
            )
            reach = mpf(real.eccentricity) + real.clearance + r_h - r_p
            law = _law(real, real.pin_radius + r_p, reach, mpf(bent[j]))
            if real.exact:
                pairs[j].append((law, pin, (crank, e), hole * mp.expj(eta), reach))
                continue
            # The difference of the nominal places and of the errors, along the crank.
            lever = -real.pin_circle_radius * (mp.conj(crank) * radial).imag
            off = mp.conj(crank) * (pin - hole - radial * mpc(0, eta * real.pin_circle_radius))
            pairs[j].append((law, lever, off.real + (reach - e)))
    return pairs


def pin_give(pin) -> list[mpf]:
    """Deflection under a unit force at each satellite by least work: end forces and moments are
    those that make the energy of bending and shear least.
    """
    modulus, d = mpf(pin.material.youngs_modulus), mpf(pin.diameter)
    bending = modulus * mp.pi * d**4 / 64
    area = mp.pi * d**2 / 4
    shearing = modulus / (2 * (1 + mpf(pin.material.poissons_ratio))) * area * 9 / 10
    found = []
    for z in map(mpf, pin.satellite_positions):
        # moment and shear force as c0 + c1*x before and behind the force, of the load and of each
        # unknown: a force and a moment at the far end
        load = [((z, mpf(-1)), mpf(1)), ((mpf(0), mpf(0)), mpf(0))]
        free = []
        length = z
        if pin.support != "cantilever":
            length = mpf(pin.span)
            free = [[((length, mpf(-1)), mpf(1))] * 2]
            free += [[((mpf(1), mpf(0)), mpf(0))] * 2]
        pieces = [(mpf(0), z), (z, length)]

        def work(one: list, other: list, pieces: list = pieces) -> mpf:
            total = mpf(0)
            for (low, high), ((a, b), v), ((c, e), w) in zip(pieces, one, other, strict=True):
                parts = (a * c, (a * e + b * c) / 2, b * e / 3)
                total += (
                    mp.fsum(part * (high**k - low**k) for k, part in enumerate(parts, start=1))
                    / bending
                )
                total += v * w * (high - low) / shearing
            return total

        if pin.support == "supported":  # no moment at either end: statics alone
            share = z / length
            own = [((mpf(0), 1 - share), share - 1), ((z, -share), share)]
            found.append(work(own, own))
            continue
        if not free:
            found.append(work(load, load))
            continue
        system = mp.matrix([[work(one, other) for other in free] for one in free])
        known = mp.matrix([-work(load, one) for one in free])
        forces = mp.lu_solve(system, known)
        found.append(
            work(load, load)
            + mp.fsum(f * work(load, one) for f, one in zip(forces, free, strict=True))
        )
    return found


def _state(real: Any, pairs: list, lag: mpf, back: mpf | int = 0) -> list:
    """Law, approach and levers of each pair on the output and on the elastic part, whose disc is
    moved back along its crank or turned back about its centre.
    """
    held = _held(real)
    bearing = hasattr(held, "radial_clearance")
    loose = mpf(held.radial_clearance) / 2 if bearing else mpf(0)
    if not real.exact:
        return [
            (law, lever * lag - gap - loose - back * (arm := 1 if bearing else lever), lever, arm)
            for law, lever, gap in pairs
        ]
    found, turn = [], mp.expj(-lag)
    for law, pin, (crank, e), hole, reach in pairs:
        turned, own = pin * turn, hole if bearing else hole * mp.expj(-back)
        d = turned - (e - back if bearing else e) * crank - own
        apart = abs(d)
        lever = (mp.conj(d) * turned).imag / apart
        arm = -(mp.conj(d) * crank).real if bearing else (mp.conj(d) * own).imag
        found.append((law, apart - reach - loose, lever, arm / apart))
    return found


def law_of(real: Any, radius: float, reach: float):
    """Force over approach of a rigid pin of a radius in a hole that is so much larger."""
    return _law(real, mpf(radius), mpf(reach), mpf(0))


def _law(real: Any, radius: mpf, reach: mpf, bent: mpf):
    law, length = real.law, mpf(real.contact_length)
    match law:
        case object(stiffness=k):
            return lambda a: a / (1 / mpf(k) + bent) if a > 0 else mpf(0)
        case object(exponent=n, reference_force=f, reference_approach=ref):
            n = mpf(n)
            return _in_series(
                lambda a: f * (a / ref) ** n, lambda f_: ref * (f_ / f) ** (1 / n), bent
            )
        case object(reference_depth=depth):  # Hertz
            pass
        case _ if type(law).__name__ == "ConformalLaw":
            return _wrapped(real.curve, reach, bent)
        case _:  # Palmgren
            k = mpf("3.84e-5") / (1000 * length) ** mpf("0.8") / 1000
            n = mpf(10) / 9
            return _in_series(lambda a: (a / k) ** n, lambda f_: k * f_ ** (1 / n), bent)
    (e1, v1), (e2, v2) = (
        (mpf(each.youngs_modulus), mpf(each.poissons_ratio))
        for each in (real.pin_material, real.hole_material)
    )
    c1, c2 = (1 - v1**2) / e1, (1 - v2**2) / e2
    rho = radius * (radius + reach) / reach
    t = mpf(depth) if depth else mpf(real.pin_radius) + real.eccentricity + real.clearance
    width2 = 4 * rho * (c1 + c2) / (mp.pi * length)  # a^2 / F
    b = (c1 + c2) / (mp.pi * length)
    a0 = c1 * (mp.log(16 * radius**2 / width2) - 1)
    a0 += c2 * (mp.log(4 * t**2 / width2) - v2 / (1 - v2))
    a0 = a0 / (mp.pi * length) + bent

    def force(a: mpf) -> mpf:
        if a <= 0:
            return mpf(0)
        m = a0 / b - mp.log(a / b)
        if m <= mpf("1.02"):
            return a / b  # beyond; bisection goes on
        return a / (b * -mp.lambertw(-mp.exp(-m), -1).real)

    return force


def _wrapped(curve: Any, difference: mpf, bent: mpf):
    """The law of a contact that wraps, by the numbers of its curve."""
    modulus, widest, powers = (curve.modulus, mpf(curve.widest), [*map(mpf, curve.powers)])

    def approach(force: mpf) -> mpf:
        load = force / (modulus * difference)
        width = min(mp.sqrt(load / (1 + load * mpf(0.4))), widest)
        place = 2 * width / widest - 1
        gives = mp.fsum(power * place**n for n, power in enumerate(reversed(powers)))
        gives -= 2 / mp.pi * mp.log(width)
        return (gives / modulus + bent) * force

    def force(a: mpf) -> mpf:
        if a <= 0:
            return mpf(0)
        most = mp.log(10 * a * modulus)
        least = most - mp.log(5000 + 10 * bent * modulus)
        return mp.exp(_root(lambda log: mp.log(approach(mp.exp(log)) / a), least, most))

    return force


def _in_series(force, approach, bent: mpf):
    def together(a: mpf) -> mpf:
        if a <= 0:
            return mpf(0)
        if not bent:
            return force(a)
        return _bisected(lambda f: approach(f) + bent * f < a, mpf(0), a / bent)

    return together
