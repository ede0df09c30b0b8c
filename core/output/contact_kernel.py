"""Laws of contact of one pair, and the steps of Newton that follow them; rules in `loop_rows`."""

import math

from core.output.loop_rows import (
    BEND,
    CONFORMAL,
    HERTZ,
    HERTZ_END,
    LINEAR,
    NEWTON_ALONE,
    POWER,
    SAME_FORCE,
    TINY,
    Curve,
    Law,
    Wrap,
)


def pair_law(
    kind: int, law: Law, pin: float, difference: float, compliance: float
) -> tuple[float, float, float]:
    """Constants a and b of a pair's law with a compliance in series, and the force at which it
    ends: the contact would be as wide as the pin. See `core.output.elasticity.law_constants`.
    """
    if kind == LINEAR:
        return law.a + compliance, 0.0, math.inf
    if kind == POWER:
        return law.a, compliance, math.inf
    if kind == CONFORMAL:
        return law.a * difference, law.a * compliance, law.a * difference * law.end
    return line_law(law, pin, pin * (pin + difference) / difference, compliance)


def line_law(law: Law, pin: float, reduced: float, compliance: float) -> tuple[float, float, float]:
    """The same of a Hertz line contact with a reduced radius."""
    q = law.quarter / reduced
    b = (law.first + law.second) / law.around
    a = law.first * (math.log(16 * pin * pin * q) - 1)
    a += law.second * (math.log(4 * law.depth * law.depth * q) - law.ratio)
    a /= law.around
    limit = min(q * pin * pin, math.exp(min(a / b - HERTZ_END, 700.0)))
    return a + compliance, b, limit


def law(
    kind: int,
    approach: float,
    a: float,
    b: float,
    n: float,
    force: float,
    stiffness: float,
    curve: Curve,
) -> tuple[float, float]:
    """Force of an approach > 0, and its derivative; given those at another one nearby, or 0."""
    if kind == LINEAR:
        return approach / a, 1 / a
    if kind == HERTZ:
        m = a / b - math.log(approach / b)
        if m <= HERTZ_END - math.log(HERTZ_END):
            return approach / (HERTZ_END * b), 1 / (HERTZ_END * b)
        y = m + math.log(m) + math.log(m) / m
        for _ in range(8):
            step = (y - math.log(y) - m) * y / (y - 1)
            y -= step
            if abs(step) <= 1e-9 * y:
                break
        return approach / (b * y), 1 / (b * (y - 1))
    if kind == CONFORMAL:
        return wrapped(approach, a, b, curve, force)
    if b == 0:
        force = a * approach**n
        return force, n * force / approach
    if n >= 1:  # a part of the approach is the bending b*F
        near = min(n * (force / stiffness - b * force), approach) if force > 0 else 0.0
        x, bent = shared(approach, 1.0, a * b, 1.0, n, near)
        force, contact = bent / b, x
    else:
        force, contact = shared(approach, b, 1.0, 1 / a, 1 / n, force)
    stiffness = n * force / contact
    return force, stiffness / (1 + b * stiffness)


def shared(
    total: float, first: float, second: float, scale: float, power: float, near: float
) -> tuple[float, float]:
    """The positive root x of ``first*x + second*(scale*x)^power = total`` for a power >= 1, and the
    second term there; `near` is a number near the root, or 0.
    """
    x, term = near, 0.0
    for step in range(60):
        if not x > TINY:
            one, other = total / first, (total / second) ** (1 / power) / scale
            x = one * other / (one + other)  # below the root: Halley's steps all lead upwards
        term = second * (scale * x) ** power
        off, slope = first * x + term - total, first + power * term / x
        curve = power * (power - 1) * term / (x * x)
        part = off * slope / (slope * slope - off * curve / 2) / x
        if step == 0 and near > 0 and abs(part) > 0.3:
            x = 0.0
            continue
        x -= part * x
        if abs(part) <= 3e-6:  # its cube is what is left
            term *= 1 - power * part * (1 - (power - 1) * part / 2)
            break
    return x, term


def given_over(x: float, curve: Curve) -> tuple[float, float]:
    """``Delta/dR`` over the load x, and its derivative by it."""
    width = math.sqrt(x / (1 + BEND * x))
    beyond = width >= curve.widest
    if beyond:
        width = curve.widest
    place = 2 * width / curve.widest - 1
    value = slope = 0.0
    for power in curve.powers:
        slope = slope * place + value
        value = value * place + power
    value -= 2 / math.pi * math.log(width)
    if beyond:
        return value, value
    turn = 2 * width / curve.widest * slope - 2 / math.pi  # by the logarithm of the width
    return value, value + turn * (1 - BEND * width * width) / 2


def wrapped(approach: float, a: float, b: float, curve: Curve, force: float) -> tuple[float, float]:
    """Force of a contact that wraps, and its derivative, by Newton's method in logarithms, where it
    is nearly straight: with the force at another approach nearby, or 0.
    """
    aim = approach * curve.modulus / a
    x, tangent = force / a if force > 0 else aim, 1.0
    for _ in range(16):
        secant, tangent = given_over(x, curve)
        secant, tangent = secant + b, tangent + b
        part = math.log(aim / (x * secant)) * secant / tangent
        x *= math.exp(part)
        if abs(part) <= SAME_FORCE:
            break
    return a * x, curve.modulus / tangent


def alone(kind: int, force: float, a: float, b: float, n: float, curve: Curve) -> float:
    """Approach under a force."""
    if kind == LINEAR:
        return a * force
    if kind == HERTZ:
        return force * b * max(a / b - math.log(force), HERTZ_END)
    if kind == CONFORMAL:
        return force * (given_over(force / a, curve)[0] + b) / curve.modulus
    return float((force / a) ** (1 / n) + b * force)


def within(x: float, change: float, low: float, high: float, step: int) -> float:
    """The next place of Newton inside a bracket, at one of its ends where nothing is left of it.

    Below the exponent 1 each touch is a step of the torque, over which Newton goes back and forth,
    and within rounding it creeps: then every second time the stretch is halved, or its end sought.
    """
    following = x + change
    if low < following < high and not (step > NEWTON_ALONE and step % 2):
        return following
    if high == math.inf:
        return x + max(abs(x), 1e-9)
    if low == -math.inf:
        return x - max(abs(x), 1e-9)
    return (low + high) / 2


def excess(x: float, wrap: Wrap) -> float:
    """Square of the pressure under the load x over Hertz's."""
    place, value = 2 * min(math.sqrt(x / (1 + BEND * x)) / wrap.widest, 1.0) - 1, 0.0
    for power in wrap.powers:
        value = value * place + power
    return value * value * (1 + BEND * x)
