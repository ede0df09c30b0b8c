"""Gauss-Legendre quadrature on panels short enough for the error to vanish beside rounding, and the
tanh-sinh rule for integrands without derivatives at the ends.

The error of the n-point rule falls like ``p^(-2*n)`` for an integrand that is analytic inside a
Bernstein ellipse of parameter p with foci at the panel's ends. Panels that leave all known
singularities outside a fixed ellipse have an error known beforehand, without comparing two rules.
"""

import math
from functools import cache

import numpy as np

from core.arrays import FloatArray

_HALF_RULE = (
    # distance of the node from the middle of a panel of length 1; weight
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
"""Sum of a singularity's distances from both ends of a panel, over the panel's length, at least."""

TRUNCATION = 1e-17
"""Bound of the rule's relative error on accepted panels: p = 3.29, so that p^-40 is far
below it.
"""


def resolves_real_pole(*, start: float, end: float, width: float) -> bool:
    """True if a panel is short enough for a pole at 0 on the panel's line, outside the panel.

    `start` and `end` are distances from the pole, of one sign. `width` > 0 is the panel's length,
    which may be known more exactly than ``end - start``.

    >>> resolves_real_pole(start=1.0, end=3.0, width=2.0)
    True
    >>> resolves_real_pole(start=1.0, end=4.0, width=3.0)
    False
    """
    return abs(start + end) >= ELLIPSE_AXIS * width


def resolves_complex_poles(*, start: float, end: float, width: float, height: float) -> bool:
    """True if a panel is short enough for singularities with ``|Im| >= max(height, |Re|)``.

    `start` and `end` are of one sign or 0. `width` > 0 is the panel's length, which may be known
    more exactly than ``end - start``. The smallest ellipse that touches the height, > 0, has the
    semi-axes ``height`` and ``hypot(height, width/2)``. The smallest one that touches the cone
    ``|Im| = |Re|`` has the sum of distances ``hypot(start, end)``, as reflection of one end in the
    cone shows.

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
    """Nodes and weights of one half of the tanh-sinh rule on [0, 1]; the other half mirrors it.

    Nodes are distances from the nearer end, ascending; the weights' sum is 1/2. Each level doubles
    the number of nodes: ``x = 1/(1 + exp(-pi*sinh(t)))`` at ``t = (k + 1/2)*2^-level``, up to t =
    3.4, beyond which all weights together are below 1e-18. Nodes crowd at the ends, so that a
    singularity of a finite integrand there does no harm. Source: Takahasi and Mori 1974, Double
    exponential formulas for numerical integration.

    >>> x, w = tanh_sinh_rule(4)
    >>> round(float(w @ np.sqrt(x) + w @ np.sqrt(1 - x)), 14)
    0.66666666666667
    """
    step = 2.0**-level
    t = step * (np.arange(math.ceil(3.4 / step))[::-1] + 0.5)
    nodes = 1 / (1 + np.exp(np.pi * np.sinh(t)))
    weights = step * np.pi * np.cosh(t) * nodes * (1 - nodes)
    return nodes, weights / (2 * weights.sum())
