"""Quadrature rules as an engineer would pick them, for integrands with several components."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from core.arrays import FloatArray
from core.work_precision.study import Method, Setting

Integrand = Callable[[FloatArray], FloatArray]


@dataclass(frozen=True, slots=True)
class Rule:
    """A quadrature rule at one setting."""

    code: str  # which rule
    setting: Setting  # number of points, or level
    nodes: FloatArray  # places on [-1, 1], shape (n,)
    weights: FloatArray  # shape (n,)

    def integral(self, integrand: Integrand, start: float, end: float) -> FloatArray:
        """Integral of every component, shape (m,), of an integrand from places, shape (n,), to its
        components there, shape (m, n).
        """
        half = (end - start) / 2
        result: FloatArray = half * (
            integrand((start + end) / 2 + half * self.nodes) @ self.weights
        )
        return result


def _gauss_legendre(count: int) -> tuple[FloatArray, FloatArray]:
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return nodes, weights


def _clenshaw_curtis(count: int) -> tuple[FloatArray, FloatArray]:
    angles = np.pi * np.arange(count + 1) / count
    weights = np.ones(count + 1)
    for k in range(1, count // 2 + 1):
        factor = 1.0 if 2 * k == count else 2.0
        weights -= factor * np.cos(2 * k * angles) / (4 * k * k - 1)
    weights *= 2 / count
    weights[[0, -1]] /= 2
    return np.cos(angles), weights


def _trapezoid(count: int) -> tuple[FloatArray, FloatArray]:
    weights = np.full(count, 2.0 / (count - 1))
    weights[[0, -1]] /= 2
    return np.linspace(-1.0, 1.0, count), weights


def _simpson(count: int) -> tuple[FloatArray, FloatArray]:
    weights = np.full(count, 2.0 / (count - 1))
    weights[1:-1:2] *= 4 / 3
    weights[2:-1:2] *= 2 / 3
    weights[[0, -1]] /= 3
    return np.linspace(-1.0, 1.0, count), weights


def _tanh_sinh(level: int) -> tuple[FloatArray, FloatArray]:
    step = 2.0**-level
    t = np.arange(-3.2, 3.2 + step / 2, step)
    inner = np.pi / 2 * np.sinh(t)
    return np.tanh(inner), step * np.pi / 2 * np.cosh(t) / np.cosh(inner) ** 2


def _rules() -> Iterator[Rule]:
    for count in (9, 33, 129, 513, 2049):
        yield Rule("trapezoid", ("points", count), *_trapezoid(count))
        yield Rule("simpson", ("points", count), *_simpson(count))
    for count in (2, 4, 8, 16, 32, 64, 128):
        yield Rule("gauss_legendre", ("points", count), *_gauss_legendre(count))
    for count in (4, 8, 16, 32, 64, 128):
        yield Rule("clenshaw_curtis", ("points", count), *_clenshaw_curtis(count))
    for level in (1, 2, 3, 4, 5):
        yield Rule("tanh_sinh", ("level", level), *_tanh_sinh(level))


@cache
def rules() -> tuple[Rule, ...]:
    """All rules at all their settings."""
    return tuple(_rules())


def by_rule(
    *, rule: Rule, code: str, value: Callable[[Rule], float | Sequence[float]], intervals: int = 1
) -> Method:
    """Method of a rule at its setting.

    Parameters
    ----------
    rule : Rule
        The rule.
    code : str
        Code of the method, a key of `core.errors.METHODS`.
    value : callable
        Value, or components of a vector, by the rule.
    intervals : int
        How many intervals it is used on.

    Returns
    -------
    Method
    """
    return Method(code, [rule.setting], lambda _: (value(rule), intervals * len(rule.nodes)))
