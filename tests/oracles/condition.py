"""Change of a result by rounding of the input alone: oracles for stated errors.

`condition` needs no exact answer and knows nothing of how the errors are stated.
"""

import math
import random
from collections.abc import Callable, Mapping, Sequence

from mpmath import mpf

Result = float | Sequence[float]


def _vector(result: Result) -> tuple[float, ...]:
    return (result,) if isinstance(result, float) else tuple(result)


def condition(
    calculate: Callable[..., Result],
    inputs: Mapping[str, float],
    roundings: Mapping[str, float],
    *,
    size: float | None = None,
    step: float = 1e-7,
) -> float:
    """Change of a result, over its size or the one given, if every input is off by a rounding.

    Parameters
    ----------
    calculate : callable
        From the inputs as keyword arguments to a number or a vector.
    inputs : mapping of str to float
        The inputs.
    roundings : mapping of str to float
        How many units of rounding each may be off; 1 where not named.
    size : float, optional
        What the change is referred to; the size of the result by default.
    step : float
        Relative step of the differences.

    Returns
    -------
    float
        In units of rounding.
    """
    total = 0.0
    for name, value in inputs.items():
        ends = [
            _vector(calculate(**{**inputs, name: value * (1 + sign * step)})) for sign in (1, -1)
        ]
        total += math.dist(*ends) / (2 * step) * roundings.get(name, 1.0)
    return total / (math.hypot(*_vector(calculate(**inputs))) if size is None else size)


def meant(r: random.Random, value: float) -> mpf:
    """A number of any digits that rounds to this double: what a user may have meant by it."""
    return mpf(value) * (1 + mpf(r.uniform(-1, 1)) / 2**54)
