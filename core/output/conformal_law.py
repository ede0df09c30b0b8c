"""Contact law of a hole that wraps around its pin (conformal contact): one curve for two materials.

The approach has two parts. `core.conformal.local_approach` is the part beside the contact, and
`far_approach` is the part by the load as a whole. The hole moves against a circle of radius L
around it, by Kolosov's functions of a hole in a plane whose rim bears a pressure of one wave. The
pin's rim moves against the pin's section, by the plane stresses of a disc under a body force, or
under any load of one wave, that holds this pressure. With E1, v1 of the pin and E2, v2 of the hole,
both together are, times E* and over the load per length Q,

    E*/pi*((1 + v2)/E2*(1/4 + (3 - 4*v2)/(4 - 4*v2)*ln(L/R)) + (1 + v1)*(1 - 2*v1)/(2*E1)).

The whole approach over the load therefore depends on ``Q/(E* dR)`` alone, dR being the difference
of the radii: by its logarithm, and smoothly besides.
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from core.arrays import FloatArray, Number, log, smaller, sqrt
from core.conformal import ConformalContact, conformal_contact, local_approach, widest_load
from core.hertz import HERTZ_TOLERANCE, ElasticMaterial, effective_modulus, mismatch
from core.numerics.inverse import edge

BEND = 0.4
"""Curves of conformal contacts are smooth in the width ``sqrt(x/(1 + BEND*x))`` of the load
``x = Q/(E* dR)``, from no load to the largest."""


class Curve(NamedTuple):
    """Approach over force of a conformal contact, for all pairs of a design.

    Under the load ``x = Q/(E* dR)`` the approach is ``Delta/dR = x*(P - 2/pi*ln(width))`` with a
    polynomial P of ``2*width/widest - 1``.
    """

    modulus: float  # b*E*, N/m
    widest: float  # largest known width; beyond it the approach is proportional to the load
    powers: tuple[float, ...]  # coefficients of P, highest power first; `DEGREE` + 1 for any law


class Wrap(NamedTuple):
    """Largest pressure of a conformal contact over Hertz's, for all pairs of a design.

    Under the load ``x = Q/(E* dR)`` the ratio is ``P*sqrt(1 + BEND*x)`` with a polynomial P of
    ``2*width/widest - 1``.
    """

    modulus: float  # b*E*, N/m; infinite where not known: then Hertz's pressure stands
    since: float  # load x from which this pressure replaces Hertz's
    widest: float  # largest known width; beyond it P is constant
    powers: tuple[float, ...]  # coefficients of P, highest power first


FAR = 3.0
"""Radius over the hole's of the circle in the satellite against whose mean displacement the
approach is counted. A plane has no scale of its own: the approach depends on this ratio by its
logarithm."""

DEGREE = 10
"""Degree of the curve's polynomial."""

ERROR = 1e-6
"""Relative error of the approach by the polynomial, for any two materials."""

NO_CURVE = Curve(1.0, 1.0, (0.0,) * (DEGREE + 1))
"""Placeholder for laws other than the conformal one."""

NO_WRAP = Wrap(math.inf, math.inf, 1.0, (0.0,) * (DEGREE + 1))
"""Placeholder where materials are not known: Hertz's pressure stands."""

PRESSURE_ERROR = 3e-6
"""Relative error of the largest pressure by its polynomial, for any two materials."""


def far_approach(*, pin: ElasticMaterial, hole: ElasticMaterial, far: float = FAR) -> float:
    """Approach by the load as a whole, times ``E*`` over the load per length, dimensionless,
    counted to a circle of `far` times the hole's radius; the module's docstring has the formula.
    """
    nu, own = hole.poissons_ratio, pin.poissons_ratio
    around = (1 + nu) / hole.youngs_modulus
    around *= 1 / 4 + (3 - 4 * nu) / (4 - 4 * nu) * math.log(far)
    within = (1 + own) * (1 - 2 * own) / (2 * pin.youngs_modulus)
    return float(effective_modulus(first=pin, second=hole) * (around + within) / math.pi)


def conformal_curve(*, contact_length: float, pin: ElasticMaterial, hole: ElasticMaterial) -> Curve:
    """Approach over force of pins in holes of any radii, for a contact length in m."""
    modulus = float(effective_modulus(first=pin, second=hole))
    alpha, beta = map(float, mismatch(first=pin, second=hole))
    widest, powers = _polynomial(alpha, beta, far_approach(pin=pin, hole=hole))
    return Curve(modulus * contact_length, widest, powers)


@lru_cache(maxsize=256)
def _polynomial(alpha: float, beta: float, far: float) -> tuple[float, tuple[float, ...]]:
    """Largest width, and coefficients of the curve's polynomial, highest power first."""
    width, contact = _contacts(alpha, beta)
    given = local_approach(contact=contact, alpha=alpha, beta=beta) + far
    return _widest(alpha, beta), _powers(given + 2 / math.pi * np.log(width))


def conformal_wrap(*, contact_length: float, pin: ElasticMaterial, hole: ElasticMaterial) -> Wrap:
    """Largest pressures of pins in holes of any radii, for a contact length in m. From
    `HERTZ_TOLERANCE` above Hertz's pressure on these replace it, as in `core.hertz`.
    """
    modulus = float(effective_modulus(first=pin, second=hole))
    found = _pressures(*map(float, mismatch(first=pin, second=hole)))
    return found._replace(modulus=modulus * contact_length)


@lru_cache(maxsize=256)
def _pressures(alpha: float, beta: float) -> Wrap:
    """Largest pressure over Hertz's as a `Wrap` with ``b*E* = 1``, by Dundurs' constants."""
    width, contact = _contacts(alpha, beta)
    powers = _powers(contact.pressure * math.sqrt(math.pi) * width)
    wrap = Wrap(1.0, 0.0, _widest(alpha, beta), powers)

    def below(load: float) -> float:
        return (1 + HERTZ_TOLERANCE) ** 2 - excess(load=load, wrap=wrap)

    since, _ = edge(inside=1e-3, outside=0.7, excess=below)
    return wrap._replace(since=since)


def excess(*, load: float, wrap: Wrap) -> float:
    """Square of the largest pressure over Hertz's, under a load ``Q/(E* dR)`` >= 0."""
    width = math.sqrt(load / (1 + BEND * load))
    place, value = 2 * min(width / wrap.widest, 1.0) - 1, 0.0
    for power in wrap.powers:
        value = value * place + power
    return value * value * (1 + BEND * load)


def _widest(alpha: float, beta: float) -> float:
    """Width of the widest known contact."""
    return 1 / math.sqrt(max(float(widest_load(alpha=alpha, beta=beta)), 0.0) + BEND)


def _contacts(alpha: float, beta: float) -> tuple[FloatArray, ConformalContact]:
    """Widths at the nodes of the polynomial, and the contacts there."""
    width = _widest(alpha, beta) * (_PLACES + 1) / 2
    parameter = 1 / width**2 - BEND
    return width, conformal_contact(load_parameter=parameter, alpha=alpha, beta=beta)


_PLACES = np.cos((np.arange(DEGREE + 1) + 0.5) * math.pi / (DEGREE + 1))


def _powers(values: FloatArray) -> tuple[float, ...]:
    """Coefficients, highest power first, of the polynomial through values at the nodes."""
    fitted = chebyshev.chebfit(_PLACES, values, DEGREE)
    return tuple(map(float, chebyshev.cheb2poly(fitted)[::-1]))


def end(curve: Curve) -> float:
    """Load ``Q/(E* dR)`` of the widest contact, half of the pin's circumference; infinite where no
    load makes a contact as wide.
    """
    rest = 1 / curve.widest**2 - BEND
    return 1 / rest if rest > 1e-12 else math.inf


def table_of(*, curve: Curve, wrap: Wrap) -> FloatArray:
    """Constants of conformal contacts for the engine, shape (6 + 2*n,) for polynomials of n
    coefficients; `core.drive.engine.over_width` lists them.
    """
    given = curve.modulus, curve.widest, len(curve.powers), *curve.powers
    return np.array([*given, wrap.modulus, wrap.since, wrap.widest, *wrap.powers])


def approach_over_load(*, load: Number, curve: Curve) -> Number:
    """Approach ``Delta/dR`` over the load ``Q/(E* dR)`` > 0."""
    width = smaller(sqrt(load / (1 + BEND * load)), curve.widest)
    place, value = 2 * width / curve.widest - 1, 0.0
    for power in curve.powers:
        value = value * place + power
    return value - 2 / math.pi * log(width)
