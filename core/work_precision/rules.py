"""Quadrature rules as an engineer would pick them, for integrands with several components."""

import math
from collections.abc import Callable, Iterator
from functools import cache

import numpy as np

from core.arrays import FloatArray
from core.work_precision.study import Setting

Integrand = Callable[[FloatArray], FloatArray]


@cache
def _gauss_legendre(count: int) -> tuple[FloatArray, FloatArray]:
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return nodes, weights


@cache
def _clenshaw_curtis(count: int) -> tuple[FloatArray, FloatArray]:
    angles = np.pi * np.arange(count + 1) / count
    weights = np.ones(count + 1)
    for k in range(1, count // 2 + 1):
        factor = 1.0 if 2 * k == count else 2.0
        weights -= factor * np.cos(2 * k * angles) / (4 * k * k - 1)
    weights *= 2 / count
    weights[[0, -1]] /= 2
    return np.cos(angles), weights


@cache
def _newton_cotes(count: int, simpson: bool) -> tuple[FloatArray, FloatArray]:
    weights = np.full(count, 2.0 / (count - 1))
    if simpson:
        weights[1:-1:2] *= 4 / 3
        weights[2:-1:2] *= 2 / 3
        weights[[0, -1]] /= 3
    else:
        weights[[0, -1]] /= 2
    return np.linspace(-1.0, 1.0, count), weights


@cache
def _tanh_sinh(level: int) -> tuple[FloatArray, FloatArray]:
    step = 2.0**-level
    t = np.arange(-3.2, 3.2 + step / 2, step)
    inner = np.pi / 2 * np.sinh(t)
    return np.tanh(inner), step * np.pi / 2 * np.cosh(t) / np.cosh(inner) ** 2


def fixed_rules() -> Iterator[tuple[str, Setting, FloatArray, FloatArray]]:
    """Every fixed rule: code, setting, nodes and weights on [-1, 1]."""
    for count in (9, 33, 129, 513, 2049):
        yield ("trapezoid", ("points", count), *_newton_cotes(count, simpson=False))
        yield ("simpson", ("points", count), *_newton_cotes(count, simpson=True))
    for count in (2, 4, 8, 16, 32, 64, 128):
        yield ("gauss_legendre", ("points", count), *_gauss_legendre(count))
    for count in (4, 8, 16, 32, 64, 128):
        yield ("clenshaw_curtis", ("points", count), *_clenshaw_curtis(count))
    for level in (1, 2, 3, 4, 5):
        yield ("tanh_sinh", ("level", level), *_tanh_sinh(level))


def integrate(
    *, integrand: Integrand, start: float, end: float, nodes: FloatArray, weights: FloatArray
) -> FloatArray:
    """Integral of every component by a rule on [-1, 1].

    Parameters
    ----------
    integrand : callable
        From places, shape (n,), to components there, shape (m, n).
    start, end : float
        Ends of the interval.
    nodes, weights : array, shape (n,)
        The rule.

    Returns
    -------
    array, shape (m,)
    """
    half = (end - start) / 2
    result: FloatArray = half * (integrand((start + end) / 2 + half * nodes) @ weights)
    return result


def finite_sum(parts: list[FloatArray]) -> list[float]:
    """Sum of the parts, component by component.

    Parameters
    ----------
    parts : list of array, shape (m,)
        The parts.

    Returns
    -------
    list of float
    """
    return [math.fsum(part[i] for part in parts) for i in range(len(parts[0]))]
