"""Gauss-Legendre quadrature on panels short enough for its error to vanish beside rounding, and
the tanh-sinh rule for integrands that have no derivatives at the ends.

The error of the n-point rule on an integrand that is analytic inside a Bernstein ellipse of
parameter p (foci at the panel's ends) falls like ``p^(-2*n)``. So where the singularities are
known, the panels are made short enough for all of them to lie outside a fixed ellipse, and the
error is known beforehand; nothing has to be estimated from differences.
"""

import math
from functools import cache

import numpy as np

from core.arrays import FloatArray

_HALF_RULE = (
    # distance of the node from the middle of a panel of length 1, weight
    (0.038263260566748666877, 0.076376693565362925349),
    (0.11389292557082253904, 0.074586493236301873394),
    (0.18685304435770978034, 0.071048054659191025665),
    (0.255433500975413549, 0.065844319224588313449),
    (0.31802684036325751273, 0.059097265980759208656),
    (0.37316595323007539631, 0.050965059908620217518),
    (0.4195584859111094117, 0.041638370788352374362),
    (0.45611721412566295293, 0.031336024167054531785),
    (0.48198596363895689563, 0.020300714900193470666),
    (0.49656429959254746239, 0.0088070035695760591559),
)

NODES = np.array([0.5 - x for x, _ in reversed(_HALF_RULE)] + [0.5 + x for x, _ in _HALF_RULE])
"""Nodes of the 20-point rule on [0, 1], shape (20,)."""

WEIGHTS = np.array([w for _, w in reversed(_HALF_RULE)] + [w for _, w in _HALF_RULE])
"""Weights of the 20-point rule on [0, 1], shape (20,); their sum is 1."""

ELLIPSE_AXIS = 1.8
"""Sum of the distances from the panel's ends, over its length, beyond which singularities lie."""

TRUNCATION = 1e-17
"""Relative error of the rule on panels that the functions below accept: ``p = 3.29``, p^-40."""


def resolves_real_pole(*, start: float, end: float, width: float) -> bool:
    """Whether a panel is short enough for a pole at 0 on its own line, outside the panel.

    Parameters
    ----------
    start, end : float
        Distances of the panel's ends from the pole, of one sign.
    width : float
        Length of the panel, > 0, which may be known better than ``end - start``.

    Returns
    -------
    bool

    Examples
    --------
    >>> resolves_real_pole(start=1.0, end=3.0, width=2.0)
    True
    >>> resolves_real_pole(start=1.0, end=4.0, width=3.0)
    False
    """
    return abs(start + end) >= ELLIPSE_AXIS * width


def resolves_complex_poles(*, start: float, end: float, width: float, height: float) -> bool:
    """Whether a panel is short enough for singularities above and below the point 0.

    They may lie anywhere with ``|Im| >= max(height, |Re|)``: at the given height or farther out
    in the right-angled cones above and below 0.

    Parameters
    ----------
    start, end : float
        Places of the panel's ends, of one sign or 0.
    width : float
        Length of the panel, > 0, which may be known better than ``end - start``.
    height : float
        Least distance of the singularities from the line, > 0.

    Returns
    -------
    bool

    Notes
    -----
    The smallest ellipse that touches the height has the semi-axes ``height`` and
    ``hypot(height, width/2)``; the smallest one that touches the cone has the sum of distances
    ``hypot(start, end)``, by reflection of one end in the cone's side.

    Examples
    --------
    >>> resolves_complex_poles(start=0.0, end=1.0, width=1.0, height=0.75)
    True
    >>> resolves_complex_poles(start=0.0, end=1.0, width=1.0, height=0.7)
    False
    """
    return 2 * math.hypot(height, width / 2) >= ELLIPSE_AXIS * width or (
        math.hypot(start, end) >= ELLIPSE_AXIS * width
    )


@cache
def tanh_sinh_rule(level: int) -> tuple[FloatArray, FloatArray]:
    """Half of the nodes and weights of the tanh-sinh rule on [0, 1]; the other half mirrors it.

    ``x = 1/(1 + exp(-pi*sinh(t)))`` at ``t = (k + 1/2)*h``, ``h = 2^-level``: the nodes crowd at
    the ends so that a singularity there does no harm, as long as the integrand stays finite.

    Parameters
    ----------
    level : int
        Each level has twice the nodes of the one before.

    Returns
    -------
    nodes, weights : array
        Distances from the nearer end, ascending, and weights, whose sum is 1/2.

    Notes
    -----
    Source: Takahasi and Mori 1974, Double exponential formulas for numerical integration. Beyond
    ``t = 3.4`` all weights together are below 1e-18.

    Examples
    --------
    The integral of the square root of x over [0, 1] is 2/3.

    >>> x, w = tanh_sinh_rule(4)
    >>> round(float(w @ np.sqrt(x) + w @ np.sqrt(1 - x)), 14)
    0.66666666666667
    """
    step = 2.0**-level
    t = step * (np.arange(math.ceil(3.4 / step))[::-1] + 0.5)
    nodes = 1 / (1 + np.exp(np.pi * np.sinh(t)))
    weights = step * np.pi * np.cosh(t) * nodes * (1 - nodes)
    return nodes, weights / (2 * weights.sum())
