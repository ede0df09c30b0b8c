"""Limits of the pressure of a contact, and how far off it is by the size of the disc."""

import math

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


OVALS = 2.0
"""Distance of the hole's axis from the nearest edge of the disc, over its radius, below which the
disc gives as a ring around the pin: nothing is known of the pressure of a contact that wraps."""

DISC_ERRORS = ((3.0, 0.15), (4.0, 0.08), (5.0, 0.05))
"""That distance, and how far the pressure is off below it that is of an infinite plane: finite
elements of a hole in a disc around it, its rim free or clamped, docs/theory.md, section 4."""


def disc_error(distance: float) -> float:
    """How far the pressure of a conformal contact may be off because the disc ends.

    Parameters
    ----------
    distance : float
        Of the hole's axis from the nearest edge of the disc, over the radius of the hole.

    Returns
    -------
    float
        Relative error.

    Examples
    --------
    >>> disc_error(3.5), disc_error(6.0)
    (0.08, 0.0)
    """
    return next((error for below, error in DISC_ERRORS if distance < below), 0.0)
