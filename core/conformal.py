"""Conformal contact: a pin in a hole only a little larger, of any two materials.

The model is a disc in a hole of an infinite plane, in plane strain, without friction. With
``x = tan(angle/2)`` and ``b = tan(eps/2)`` of the half-angle eps of the contact, the
pressure is the solution of

    (1 + x^2)/2*(1/pi)*PV int p'(y)/(x - y) dy + beta*p
        = E* dR/(2*R_m) + (1 + alpha)/2*p_0 + (1 + beta)*Q/(pi*R_m)*cos(angle)

with Dundurs' alpha and beta of pin and hole (`core.hertz.mismatch`; both positive where the pin is
the stiffer), the mean p_0 of the pressure over the whole rim, the load per length Q, the difference
dR of the radii and ``R_m = sqrt(r*R)``. Over Q/R_m the pressure of a half-angle thus depends on
beta alone, and

    E* dR/Q = 2*G(eps, beta) - (1 + alpha)*P_0(eps, beta),  p_max = P(eps, beta)*Q/R_m.

G, P_0, P and the approach have closed forms for beta = 0 and any alpha. For other beta, factors on
the closed forms, smooth in eps and beta, are solved once at Chebyshev's nodes of both.
"""

import math
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from core.arrays import (
    FloatArray,
    Number,
    atanh,
    every,
    larger,
    log,
    log1p,
    smaller,
    some,
    sqrt,
    where,
)
from core.precision import ROUNDING

WIDEST = math.pi / 2
"""Half-angle up to which a contact is known, rad."""

ERROR = 5e-9
"""Relative error that the factors leave in pressures, angles and loads, for |beta| = 1/2."""

TERMS = 32
"""Odd sine terms of the pressure; the error falls with the fourth power of their number."""

OVALS = 2.0
"""Distance of the hole's axis from the nearest edge of the disc, over its radius, below which
the disc deforms as a ring around the pin and the pressure of a conformal contact is unknown."""

DISC_ERRORS = ((3.0, 0.15), (4.0, 0.08), (5.0, 0.05))
"""Distances of the edge as in `OVALS`, and relative error of the pressure below each: finite
elements of a disc with a concentric rim, free or clamped, against an infinite plane
(docs/theory.md, section 4)."""

_DEPTHS, _WIDTHS = 10, 16
"""Numbers of Chebyshev nodes in beta and in sin(eps/2)."""

_HALF_SINE = math.sin(WIDEST / 2)


class ConformalContact(NamedTuple):
    """Contact of pin and hole, or an array of contacts; NaN if wider than `WIDEST`."""

    tangent: Number  # b = tan(eps/2), eps the half-angle
    pressure: Number  # p_max*R_m/Q, in the middle
    mean_pressure: Number  # p_0*R_m/Q, over the whole rim
    evaluations: int  # Newton steps; in an array those of the slowest contact


class _Factors:
    """Factors on the closed forms and their derivatives, by s = sin(eps/2): 1 plus sums of powers
    of `_at(s)`, all 1 for beta = 0. `s_turn` is the derivative of s by the variable of the search.
    """

    def __init__(
        self,
        stiffness: list[Number],  # sum added to 2*pi*G*s^2
        mean: list[Number],  # sum added to 1
        middle: list[Number],  # sum added to 1
        approach: list[Number],
        *,
        precise: float = 64 * ROUNDING,  # step of Newton's method at which it ends
    ) -> None:
        self._stiffness, self._mean = stiffness, mean
        self._middle, self._approach = middle, approach
        self.precise = precise

    def balance(self, y: Number) -> tuple[Number, Number, Number, Number]:
        """Factors on G and P_0, each followed by its derivative by ``y = b^2``."""
        s, s_turn = sqrt(y / (1 + y)), 0.5 / (sqrt(y * (1 + y)) * (1 + y))
        return *self.stiffness(s, s_turn), *self.mean(s, s_turn)

    def stiffness(self, s: Number, s_turn: Number = 0.0) -> tuple[Number, Number]:
        """Factor on ``G = (1 - s^2)^2/(2*pi*s^2)`` and its derivative."""
        value, turn = _powers(self._stiffness, s)
        square = (1 - s) * (1 + s)
        over = value / (square * square)
        return 1 + over, (turn / (square * square) + 4 * s * over / square) * s_turn

    def mean(self, s: Number, s_turn: Number = 0.0) -> tuple[Number, Number]:
        """Factor on P_0 and its derivative."""
        value, turn = _powers(self._mean, s)
        return 1 + value, turn * s_turn

    def middle(self, s: Number, s_turn: Number = 0.0) -> tuple[Number, Number]:
        """Factor on P and its derivative."""
        value, turn = _powers(self._middle, s)
        return 1 + value, turn * s_turn

    def approach(self, s: Number) -> Number:
        """Term of beta in ``local_approach - (1 + alpha)*P_0``, times pi."""
        return _powers(self._approach, s)[0]


_CLOSED = _Factors([], [], [], [], precise=2 * ROUNDING)


def conformal_contact(
    *, load_parameter: Number, alpha: Number = 0.0, beta: Number = 0.0
) -> ConformalContact:
    """Contact under the load parameter ``lambda = E* dR/Q`` >= 0, of Dundurs' alpha and beta.

    With ``y = b^2`` the equation is
    ``2*g - (1 + alpha)*m*(ln(1 + y) + 2*y^2) = 2*pi*lambda*y*(1 + y)``, where g and m are the
    factors on G and P_0. The left side less the right one falls with y, so that Newton's method
    converges from the Hertz value or from that of no clearance, whichever is smaller. Source:
    Persson 1964, On the stress distribution of cylindrical elastic bodies in contact, for identical
    materials; docs/theory.md, section 4, for others.

    >>> contact = conformal_contact(load_parameter=2.009354283, alpha=0.97, beta=0.21)
    >>> round(2*math.degrees(math.atan(contact.tangent)), 6), round(contact.pressure, 6)
    (40.0, 0.967843)
    """
    factors = _factors(beta)
    least = widest_load(alpha=alpha, beta=beta)
    known = load_parameter >= least
    load, share = 2 * math.pi * larger(load_parameter, least), 1 + alpha
    y = 2 / larger(load, 2 / 0.84)
    evaluations = 0
    while evaluations < 60:
        g, g_turn, m, m_turn = factors.balance(y)
        part, log, rest = share * m, log1p(y), load * y * (1 + y)
        value = 2 * g - part * log - 2 * part * y * y - rest
        slope = 2 * g_turn - share * m_turn * (log + 2 * y * y)
        step = value / (slope - part / (1 + y) - 4 * part * y - load * (1 + 2 * y))
        y = smaller(y - step, 1.0)
        evaluations += 1
        if every(abs(step) <= factors.precise * y):
            break
    b, mean = sqrt(y), _closed_mean(y)
    middle = closed_pressure(position=0.0 * b, tangent=b)
    s = sqrt(y / (1 + y))
    mean, middle = mean * factors.mean(s)[0], middle * factors.middle(s)[0]
    b, middle, mean = (where(known, each, math.nan) for each in (b, middle, mean))
    return ConformalContact(b, middle, mean, evaluations)


def widest_load(*, alpha: Number, beta: Number) -> Number:
    """Load parameter of the contact of half-angle `WIDEST`; smaller parameters have no known
    contact.

    A negative result means that every contact is known, as no load makes it so wide.
    """
    factors, length = _factors(beta), math.log(2) + 2
    g, m = factors.stiffness(_HALF_SINE)[0], factors.mean(_HALF_SINE)[0]
    return (2 * g - (1 + alpha) * m * length) / (4 * math.pi)


def load_under_pressure(
    *, pressure_parameter: Number, alpha: Number = 0.0, beta: Number = 0.0
) -> Number:
    """Load parameter ``E* dR/Q`` of the contact with a given largest pressure.

    The pressure parameter is ``p_max*R_m/(E* dR) = P/lambda`` > 0, which grows with the load. If
    the widest known contact stays below it, the load parameter of that contact is returned.

    >>> contact = conformal_contact(load_parameter=0.7, alpha=0.5, beta=0.1)
    >>> round(load_under_pressure(
    ...     pressure_parameter=contact.pressure/0.7, alpha=0.5, beta=0.1), 9)
    0.7
    """
    factors, share = _factors(beta), 1 + alpha
    b = smaller(pressure_parameter, 0.8)
    for _ in range(60):
        y, root = b * b, sqrt(1 + b * b)
        s, s_turn = b / root, 1 / (root * root * root)
        (g, g_turn), (m, m_turn) = factors.stiffness(s, s_turn), factors.mean(s, s_turn)
        k, k_turn = factors.middle(s, s_turn)
        length, length_turn = log1p(y) + 2 * y * y, 2 * b / (1 + y) + 8 * b * y
        # P and lambda times 2*pi*y*(1 + y)
        middle = 4 * y * b * root + 2 * atanh(b / root)
        middle_turn = 12 * y * root + 4 * y * y / root + 2 / root
        stiff = 2 * g - share * m * length
        stiff_turn = 2 * g_turn - share * (m * length_turn + m_turn * length)
        value = pressure_parameter * stiff - k * middle
        slope = pressure_parameter * stiff_turn - k * middle_turn - k_turn * middle
        following = larger(smaller(b - value / slope, 1.0), b / 8)
        moved, b = abs(following - b), following
        if every(moved <= 64 * ROUNDING * b):
            break
    y = b * b
    s = b / sqrt(1 + y)
    g, m = factors.stiffness(s)[0], factors.mean(s)[0]
    return (2 * g - share * m * (log1p(y) + 2 * y * y)) / (2 * math.pi * y * (1 + y))


def local_approach(*, contact: ConformalContact, alpha: Number = 0.0, beta: Number = 0.0) -> Number:
    """Approach of pin and hole since they touched, times E*/Q, without the rigid movement.

    The approach is the part of all harmonics of the pressure except the first, and grows as
    ``-2/pi*ln(eps)`` in narrow contacts. In the middle of the contact Michell's series is
    ``(1 + alpha)*P_0 + 2/pi*(J - 1/4 - pi*P_0 + beta*(1/4 - K))`` with
    ``J = -int p*cos(angle)*ln(2*sin(angle/2))`` and ``K = 1/2*int p*sin(angle)*(pi - angle)``; for
    beta = 0 it is ``(1 + alpha)*P_0 + (s^4 - 1 - 4*ln(s))/(2*pi)``, ``s = sin(eps/2)``.

    >>> contact = conformal_contact(load_parameter=9.878227160229889, alpha=0.96526, beta=0.20999)
    >>> round(local_approach(contact=contact, alpha=0.96526, beta=0.20999), 4)
    1.2674
    """
    b = contact.tangent
    s = b / sqrt(1 + b * b)
    found = _closed_approach(s) + _factors(beta).approach(s) / math.pi
    return found + (1 + alpha) * contact.mean_pressure


def closed_pressure(*, position: Number, tangent: Number) -> Number:
    """Pressure ``p*R_m/Q`` for beta = 0 at ``y = tan(angle/2)``; source: Persson 1964; Ciavarella
    and Decuzzi 2001, The state of stress induced by the plane frictionless cylindrical contact, I.
    """
    b, y = tangent, position
    inner, outer = sqrt((b - y) * (b + y)), sqrt(1 + b * b)
    ends = 2 * inner / (math.pi * outer * (1 + y * y))
    return ends + atanh(inner / outer) / (math.pi * b * b * outer * outer)


def pressure_over_angle(*, angles: FloatArray, tangent: float, beta: float) -> FloatArray:
    """Pressure over that in the middle of a contact, at angles from the middle, rad, shape (n,)."""
    places = np.minimum(np.tan(np.abs(angles) / 2), tangent)
    if beta == 0:
        middle = closed_pressure(position=0.0, tangent=tangent)
        return np.asarray(closed_pressure(position=places, tangent=tangent) / middle)
    s = np.array([tangent / math.sqrt(1 + tangent * tangent)])
    weights = integral_equation(s=s, beta=np.array([beta]), terms=4 * TERMS)[-1][0, 0]
    phi = np.arccos(places / tangent)
    odd = 2 * np.arange(len(weights)) + 1
    return np.asarray((np.sin(np.outer(phi, odd)) @ weights) / (np.sin(odd * np.pi / 2) @ weights))


def disc_error(distance: float) -> float:
    """Relative error of the pressure of a conformal contact because the disc ends near the hole.

    The distance is from the hole's axis to the nearest edge of the disc, over the hole's radius.

    >>> disc_error(3.5), disc_error(6.0)
    (0.08, 0.0)
    """
    return next((error for below, error in DISC_ERRORS if distance < below), 0.0)


def edge_tension(*, mean_pressure: Number, tangent: Number, poissons_ratio: Number) -> Number:
    """Hoop tension in the rim of the hole at the ends of the contact, over Q/R_m.

    On the rim ``s_tt = -p + 2*p_0 + 2*K/(K + 1)*Q/(pi*R_m)*cos(angle)``, ``K = 3 - 4*nu`` of the
    hole's material: exact in the plane, from Michell's stresses of each harmonic of the pressure.
    The mean pressure is given as ``p_0*R_m/Q``.
    """
    kolosov = 3 - 4 * poissons_ratio
    cosine = (1 - tangent * tangent) / (1 + tangent * tangent)
    return 2 * mean_pressure + 2 * kolosov / (math.pi * (kolosov + 1)) * cosine


def first_yield_factor(*, half_angle: Number, poissons_ratio: Number, beta: Number = 0.0) -> Number:
    """Largest pressure at first yield of the hole over the yield strength (Mises).

    Michell's stresses of each harmonic are summed in closed form along the axis of the load, which
    has the largest stress: below the surface of narrow contacts, on the rim from about 45 degrees
    on and for nu < 0.15. The pin, whose load is balanced inside its section, yields later. The
    half-angle eps of the contact goes from 0 (Hertz) to `WIDEST`, Poisson's ratio is that of the
    hole's material. Dundurs' beta is left out below the surface: an error of 1.4 % at most, 0.3 %
    for |beta| = 0.2.

    >>> [round(first_yield_factor(half_angle=math.radians(each), poissons_ratio=0.3), 2)
    ...  for each in (0.0, 20.0, 60.0)]
    [1.79, 1.54, 1.04]
    """
    eps = larger(smaller(half_angle, WIDEST), 1e-6)
    b, nu = np.tan(eps / 2), poissons_ratio
    share = 2 / math.pi * (3 - 4 * nu) / (4 - 4 * nu)
    middle, mean = closed_pressure(position=0.0 * b, tangent=b), _closed_mean(b * b)
    along, around = _axis_stresses(eps, nu)
    below = _mises(along, around, np.asarray(nu)[..., None]).max(axis=-1)
    factors, s = _factors(beta), np.sin(eps / 2)
    mean, middle = mean * factors.mean(s)[0], middle * factors.middle(s)[0]
    rim = _mises(-1.0, (2 * mean + share) / middle - 1, nu)
    found = 1 / np.maximum(below, rim)
    return found if np.ndim(found) else float(found)


def _mises(one: Number, other: Number, nu: Number) -> Number:
    """Mises stress of two principal stresses in plane strain."""
    both = (1 - nu + nu * nu) * (one * one + other * other)
    return np.sqrt(both - (1 + 2 * nu - 2 * nu * nu) * one * other)


def _axis_stresses(eps: Number, nu: Number) -> tuple[FloatArray, FloatArray]:
    """Radial and hoop stress along the load, over the largest pressure (beta = 0), at 59 depths of
    0.05 to 1.5 half-widths, on the last axis.

    A harmonic ``p_n*cos(n*angle)``, n >= 2, makes ``rho^n*p_n*((rho^2 - 1)*n/2 - 1)`` and
    ``rho^n*p_n*((1 - rho^2)*n/2 - 1)``, with rho = R over the distance from the hole's centre.
    """
    eps, nu = np.asarray(eps, float)[..., None, None], np.asarray(nu, float)[..., None]
    b = np.tan(eps / 2)
    phi = (np.arange(64) + 0.5) * math.pi / 128
    place = b * np.sin(phi)  # tan(angle/2)
    middle = closed_pressure(position=0.0 * b, tangent=b)
    weight = b * np.cos(phi) / (1 + place * place) / 32  # both sides, over pi
    shape = closed_pressure(position=place, tangent=b) / middle * weight
    sine = place * place / (1 + place * place)  # sin(angle/2)^2
    depth = eps * np.linspace(0.05, 1.5, 59)[:, None]
    rho = 1 / (1 + depth)
    left = depth * rho  # 1 - rho
    apart = left * left + 4 * rho * sine  # 1 - 2*rho*cos + rho^2
    cosine = 1 - 2 * sine
    plain = ((rho * (left - 2 * sine) / apart - rho * cosine) * shape).sum(-1)
    turning = (left * left - 2 * sine * (1 + rho * rho)) / (apart * apart) - cosine
    turning = (rho * turning * shape).sum(-1)
    rho, left, mean = rho[..., 0], left[..., 0], shape.sum(-1) / 2
    first = 1 / (math.pi * middle[..., 0])  # p_1
    twice = first * (1 - 2 * nu) / (4 - 4 * nu)  # keeps the displacement of the force single-valued
    bent = left * (1 + rho) / 2 * turning
    along = -bent - plain - mean * rho**2 - first * rho + twice * (rho - rho**3)
    around = bent - plain + mean * rho**2 + twice * (rho + rho**3)
    return along, around


def _closed_mean(y: Number) -> Number:
    """P_0 for beta = 0, by y = b^2."""
    return (log1p(y) + 2 * y * y) / (2 * math.pi * y * (1 + y))


def _closed_approach(s: Number) -> Number:
    """``local_approach - (1 + alpha)*P_0`` for beta = 0."""
    square = s * s
    return (square * square - 1 - 2 * log(square)) / (2 * math.pi)


def _at(s: Number) -> Number:
    """Variable of the powers: -1 to 1 over the half-angles from 0 to `WIDEST`."""
    return 2 * s / _HALF_SINE - 1


def _powers(coefficients: list[Number], s: Number) -> tuple[Number, Number]:
    """Sum of powers of `_at(s)` and its derivative by s, by Horner's rule."""
    t = _at(s)
    value = turn = 0.0 * t
    for coefficient in coefficients[::-1]:
        turn = turn * t + value
        value = value * t + coefficient
    return value, turn * (2 / _HALF_SINE)


def _factors(beta: Number) -> _Factors:
    """Factors for a beta, or for an array of beta."""
    if isinstance(beta, float):
        return _factors_of(float(beta)) if beta else _CLOSED
    return _factors_at(beta) if some(beta != 0) else _CLOSED


@lru_cache(maxsize=256)
def _factors_of(beta: float) -> _Factors:
    return _factors_at(beta)


def _factors_at(beta: Number) -> _Factors:
    found = ([*(beta * chebyshev.chebval(2 * beta, table))] for table in _tables())
    if isinstance(beta, float):
        found = ([float(each) for each in row] for row in found)
    return _Factors(*found)


@cache
def _tables() -> tuple[FloatArray, ...]:
    """Chebyshev coefficients in 2*beta of the coefficients of the powers, by factor."""
    depths, widths = (
        np.cos((np.arange(number) + 0.5) * math.pi / number) for number in (_DEPTHS, _WIDTHS)
    )
    beta, s = depths / 2, _HALF_SINE * (widths + 1) / 2
    y = s * s / (1 - s * s)
    mean, middle = _closed_mean(y), closed_pressure(position=0.0 * y, tangent=np.sqrt(y))
    fine, coarse = (integral_equation(s=s, beta=beta, terms=each) for each in (TERMS, TERMS // 2))
    # the error of both falls with the fourth power of their terms
    stiffness, *others, approach = (
        one + (one - other) / 15 for one, other in zip(fine[:4], coarse[:4], strict=True)
    )
    added = [2 * math.pi * stiffness * s * s - (1 - s * s) ** 2]
    added += [other / known - 1 for other, known in zip(others, (mean, middle), strict=True)]
    added += [math.pi * (approach - _closed_approach(s))]
    tables = []
    for each in added:
        over_s = chebyshev.chebfit(widths, (each / beta[:, None]).T, _WIDTHS - 1)
        powers = np.stack([chebyshev.cheb2poly(row) for row in over_s.T])
        tables.append(chebyshev.chebfit(depths, powers, _DEPTHS - 1))
    return tuple(tables)


def integral_equation(
    *, s: FloatArray, beta: FloatArray, terms: int
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]:
    """Solution of the equation of the pressure for m values of beta and n of s = sin(eps/2).

    Returns G, P_0, P and ``local_approach - (1 + alpha)*P_0``, each of shape (m, n), and the
    weights of the odd sines of phi, ``x = b*cos(phi)``, in the pressure, shape (m, n, terms). The
    equation holds at ``phi_j = j*pi/(2*terms + 1)``. Integrals over the contact use the midpoint
    rule, with the series of ``abs(cos(phi))`` and ``ln(2*abs(cos(phi)))`` as far as the rule
    resolves them.
    """
    b = s / np.sqrt(1 - s * s)
    odd = 2 * np.arange(terms) + 1
    phi = (np.arange(terms) + 1) * math.pi / (2 * terms + 1)
    x2 = np.multiply.outer(b * b, np.cos(phi) ** 2)
    turned = (1 + x2) / (2 * np.multiply.outer(b, np.sin(phi)))
    left = np.sin(np.outer(phi, odd)) * (turned[..., None] * odd + beta[:, None, None, None])
    right = np.stack([np.ones_like(x2), (1 - x2) / (1 + x2)], axis=-1)
    parts = np.linalg.solve(left, np.broadcast_to(right, (*left.shape[:-1], 2)))
    middles = (np.arange(2 * terms) + 0.5) * math.pi / (4 * terms)
    x2 = np.multiply.outer(b * b, np.cos(middles) ** 2)
    weight = np.multiply.outer(b, np.sin(middles)) / (1 + x2) * (math.pi / terms)
    sines = np.sin(np.outer(middles, odd))
    around = np.einsum("sp,pk,bskr->bsr", weight, sines, parts, optimize=True)
    along = np.einsum("sp,pk,bskr->bsr", weight * (1 - x2) / (1 + x2), sines, parts, optimize=True)
    share = ((1 + beta) / math.pi)[:, None]
    stiffness = (1 - share * along[..., 1]) / along[..., 0]
    weights = stiffness[..., None] * parts[..., 0] + share[..., None] * parts[..., 1]
    mean = (stiffness * around[..., 0] + share * around[..., 1]) / (2 * math.pi)
    waves = np.arange(1, 2 * terms)
    even = (-1.0) ** waves * np.cos(2 * np.outer(middles, waves))
    size = 2 / math.pi * (1 + 2 * (even / (1 - 4.0 * waves * waves)).sum(axis=1))
    depth = np.log(b)[:, None] - (even / waves).sum(axis=1) - np.log1p(x2) / 2
    sine, angle = 2 * b[:, None] / (1 + x2) * size, 2 * np.arctan(np.sqrt(x2))
    load = (weights @ sines.T) * weight
    pull = -(load * (1 - x2) / (1 + x2) * depth).sum(axis=-1)
    turn = (load * (math.pi * sine - angle * np.sin(angle))).sum(axis=-1) / 2
    approach = pull - 0.25 - math.pi * mean + beta[:, None] * (0.25 - turn)
    pressure = weights @ np.sin(odd * math.pi / 2)
    return stiffness, mean, pressure, approach * (2 / math.pi), weights
