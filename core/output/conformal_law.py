"""The law of contact of a pin that wraps: approach over force of any two materials, one curve."""

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
"""Curves of contacts that wrap are smooth in the width ``sqrt(x/(1 + BEND*x))`` of the load
``x = Q/(E* dR)``, from none to the largest."""


class Curve(NamedTuple):
    """What a contact that wraps gives, for all pairs of a design: over the load ``x = Q/(E* dR)``
    the approach ``Delta/dR = x*(P - 2/pi*ln(width))``, P a polynomial of ``2*width/widest - 1``.
    """

    modulus: float  # b*E*, N/m
    widest: float  # width up to which it is known; beyond it goes on as a straight line
    powers: tuple[float, ...]  # of the polynomial, from the highest; as many for any law


class Wrap(NamedTuple):
    """The largest pressure of contacts that wrap, of all pairs: over Hertz's it is
    ``P*sqrt(1 + BEND*x)``, P a polynomial as that of `Curve`.
    """

    modulus: float  # b*E*, N/m; infinite where it is not known: then Hertz's pressure stands
    since: float  # load from which it governs in the place of Hertz's
    widest: float  # width up to which it is known; beyond it P stays
    powers: tuple[float, ...]  # of the polynomial, from the highest


FAR = 3.0
"""Radius of the circle in the satellite, over the hole's, against whose mean displacement the
approach is counted: a plane has no scale of its own, and the approach depends on it by its
logarithm."""

DEGREE = 10
"""Of the curve's polynomial."""

ERROR = 1e-6
"""Relative error of the approach that the polynomial leaves, for any two materials."""

NO_CURVE = Curve(1.0, 1.0, (0.0,) * (DEGREE + 1))
"""What stands in its place for other laws."""

NO_WRAP = Wrap(math.inf, math.inf, 1.0, (0.0,) * (DEGREE + 1))
"""What stands for largest pressures where materials are not known."""

PRESSURE_ERROR = 3e-6
"""Relative error of a largest pressure by its polynomial, for any two materials."""


def far_approach(*, pin: ElasticMaterial, hole: ElasticMaterial, far: float = FAR) -> float:
    """What the load as a whole moves: the hole against a circle around it, the pin's rim against
    its section.

    Parameters
    ----------
    pin, hole : ElasticMaterial
        The materials.
    far : float
        Radius L of the circle over the hole's.

    Returns
    -------
    float
        ``E*`` times the approach over the load per length, dimensionless.

    Notes
    -----
    By Kolosov's functions of a hole in a plane with the pressure of one wave on its rim, and by the
    plane stresses of a disc under a body force that holds that pressure, or under any load of one
    wave, ``E*/pi*((1 + v2)/E2*(1/4 + (3 - 4*v2)/(4 - 4*v2)*ln(L/R)) +
    (1 + v1)*(1 - 2*v1)/(2*E1))``.
    """
    nu, own = hole.poissons_ratio, pin.poissons_ratio
    around = (1 + nu) / hole.youngs_modulus
    around *= 1 / 4 + (3 - 4 * nu) / (4 - 4 * nu) * math.log(far)
    within = (1 + own) * (1 - 2 * own) / (2 * pin.youngs_modulus)
    return float(effective_modulus(first=pin, second=hole) * (around + within) / math.pi)


def conformal_curve(*, contact_length: float, pin: ElasticMaterial, hole: ElasticMaterial) -> Curve:
    """Approach over force of pins in holes of a design, whatever their radii.

    Parameters
    ----------
    contact_length : float
        Length b of the contact, m.
    pin, hole : ElasticMaterial
        The materials.

    Returns
    -------
    Curve

    Notes
    -----
    ``E*/Q`` times the approach after touching is that of `core.conformal.local_approach` and
    `far_approach`: of the load ``Q/(E* dR)`` alone, by its logarithm and smooth besides.
    """
    modulus = float(effective_modulus(first=pin, second=hole))
    alpha, beta = map(float, mismatch(first=pin, second=hole))
    widest, powers = _polynomial(alpha, beta, far_approach(pin=pin, hole=hole))
    return Curve(modulus * contact_length, widest, powers)


@lru_cache(maxsize=256)
def _polynomial(alpha: float, beta: float, far: float) -> tuple[float, tuple[float, ...]]:
    """The largest width, and the powers."""
    width, contact = _contacts(alpha, beta)
    given = local_approach(contact=contact, alpha=alpha, beta=beta) + far
    return _widest(alpha, beta), _powers(given + 2 / math.pi * np.log(width))


def conformal_wrap(*, contact_length: float, pin: ElasticMaterial, hole: ElasticMaterial) -> Wrap:
    """Largest pressures of contacts of a design that wrap, whatever their radii.

    Parameters
    ----------
    contact_length : float
        Length b of the contact, m.
    pin, hole : ElasticMaterial
        The materials.

    Returns
    -------
    Wrap
        That governs as in `core.hertz`: from `HERTZ_TOLERANCE` above Hertz's pressure on.
    """
    modulus = float(effective_modulus(first=pin, second=hole))
    found = _pressures(*map(float, mismatch(first=pin, second=hole)))
    return found._replace(modulus=modulus * contact_length)


@lru_cache(maxsize=256)
def _pressures(alpha: float, beta: float) -> Wrap:
    """The same of a modulus of 1."""
    width, contact = _contacts(alpha, beta)
    powers = _powers(contact.pressure * math.sqrt(math.pi) * width)
    wrap = Wrap(1.0, 0.0, _widest(alpha, beta), powers)

    def below(load: float) -> float:
        return (1 + HERTZ_TOLERANCE) ** 2 - excess(load=load, wrap=wrap)

    since, _ = edge(inside=1e-3, outside=0.7, excess=below)
    return wrap._replace(since=since)


def excess(*, load: float, wrap: Wrap) -> float:
    """Square of the largest pressure under a load over Hertz's.

    Parameters
    ----------
    load : float
        ``Q/(E* dR)``, >= 0.
    wrap : Wrap
        Largest pressures.

    Returns
    -------
    float
    """
    width = math.sqrt(load / (1 + BEND * load))
    place, value = 2 * min(width / wrap.widest, 1.0) - 1, 0.0
    for power in wrap.powers:
        value = value * place + power
    return value * value * (1 + BEND * load)


def _widest(alpha: float, beta: float) -> float:
    """Width of the widest contact that is known."""
    return 1 / math.sqrt(max(float(widest_load(alpha=alpha, beta=beta)), 0.0) + BEND)


def _contacts(alpha: float, beta: float) -> tuple[FloatArray, ConformalContact]:
    """Widths at the places of a polynomial, and the contacts."""
    width = _widest(alpha, beta) * (_PLACES + 1) / 2
    parameter = 1 / width**2 - BEND
    return width, conformal_contact(load_parameter=parameter, alpha=alpha, beta=beta)


_PLACES = np.cos((np.arange(DEGREE + 1) + 0.5) * math.pi / (DEGREE + 1))


def _powers(values: FloatArray) -> tuple[float, ...]:
    """Of the polynomial through values at the places, from the highest."""
    fitted = chebyshev.chebfit(_PLACES, values, DEGREE)
    return tuple(map(float, chebyshev.cheb2poly(fitted)[::-1]))


def end(curve: Curve) -> float:
    """Load ``Q/(E* dR)`` of the widest contact: half of the pin.

    Parameters
    ----------
    curve : Curve
        The curve.

    Returns
    -------
    float
        Infinite where no load makes the contact as wide.
    """
    rest = 1 / curve.widest**2 - BEND
    return 1 / rest if rest > 1e-12 else math.inf


def table_of(*, curve: Curve, wrap: Wrap) -> FloatArray:
    """Constants of contacts that wrap as the engine takes them, see
    `core.drive.engine.over_width`.

    Parameters
    ----------
    curve : Curve
        Approach over force.
    wrap : Wrap
        Largest pressures.

    Returns
    -------
    array, shape (6 + 2*n,)
    """
    given = curve.modulus, curve.widest, len(curve.powers), *curve.powers
    return np.array([*given, wrap.modulus, wrap.since, wrap.widest, *wrap.powers])


def approach_over_load(*, load: Number, curve: Curve) -> Number:
    """``Delta/dR`` over the load, as the engine has it.

    Parameters
    ----------
    load : float or array
        ``Q/(E* dR)``, > 0.
    curve : Curve
        The curve.

    Returns
    -------
    float or array
    """
    width = smaller(sqrt(load / (1 + BEND * load)), curve.widest)
    place, value = 2 * width / curve.widest - 1, 0.0
    for power in curve.powers:
        value = value * place + power
    return value - 2 / math.pi * log(width)
