"""The force at which a contact is at a limit of its pressure."""

import math
from collections.abc import Callable

from core.hertz import HertzContact
from core.numerics.inverse import edge
from core.precision import ROUNDING

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength, without friction: the largest
orthogonal shear, a quarter of it, is the shear yield strength ``Re/sqrt(3)``."""

SLIDING, SLIDING_SHAKEDOWN = 0.1, 2.06
"""The largest friction for which it is known, and what it is there (Johnson 1985: 3.565 times the
shear yield strength)."""


def shakedown(friction: float) -> float:
    """Largest pressure of elastic shakedown over the yield strength, with friction.

    Parameters
    ----------
    friction : float
        Friction coefficient of the pair that slides, >= 0.

    Returns
    -------
    float
        In between by a straight line; beyond, the last known one, above which it fails for certain,
        as friction only lowers it.

    Examples
    --------
    >>> [round(shakedown(mu), 3) for mu in (0.0, 0.05, 0.1, 0.5)]
    [2.309, 2.185, 2.06, 2.06]
    """
    part = min(friction / SLIDING, 1.0)
    return SHAKEDOWN + part * (SLIDING_SHAKEDOWN - SHAKEDOWN)


def force_factor(
    *, contact: HertzContact, contact_at: Callable[[float], HertzContact], limit: float
) -> float:
    """Factor on the force at which the governing pressure of a contact is at a limit.

    Hertz's pressure grows with the root of the force, Persson's faster, up to the force itself;
    where Persson's takes over, the governing pressure jumps by a per cent.

    Parameters
    ----------
    contact : HertzContact
        The contact, of a known governing pressure.
    contact_at : callable
        The contact under so many times the force.
    limit : float
        The limit, Pa, > 0.

    Returns
    -------
    float
    """
    by_hertz = float((limit / contact.max_pressure) ** 2)
    if contact_at(by_hertz).conformal_pressure is None:
        # where no theory holds any more, that is the end
        return min(by_hertz, float(contact.half_width_ratio**-2))

    def left(factor: float) -> float:
        there = contact_at(factor).governing_pressure
        return math.nan if there is None else float(limit - there)

    assert contact.governing_pressure is not None
    ratio = float(limit / contact.governing_pressure)
    met, _ = edge(
        inside=0.97 * min(ratio, ratio * ratio),
        outside=1.03 * max(ratio, ratio * ratio),
        excess=left,
    )
    return met * (1 - 512 * ROUNDING)  # not beyond the jump by the rounding of forces
