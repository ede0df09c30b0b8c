"""Ideal contact forces in multiple precision, by their law alone."""

from typing import Any

from core.output.mechanism import Mechanism


def pair_phases(mechanism: Mechanism) -> list[list[Any]]:
    """Phases of the pairs, rad, a list for each satellite; within the caller's precision.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.

    Returns
    -------
    list of list of mpmath numbers, shape (K, N)
    """
    import mpmath

    start, pitch = mpmath.mpf(mechanism.initial_crank_angle), 2 * mpmath.pi / mechanism.pins
    cranks = [mpmath.mpf(angle) + start for angle in mechanism.crank_angles]
    return [[crank + n * pitch for n in range(mechanism.pins)] for crank in cranks]


def pair_forces(
    *, phases: list[list[Any]], force_exponent: float, wave_angle: Any
) -> tuple[list[list[Any]], list[list[Any]]]:
    """Forces of pairs over F0, ``c^v / sum c^(1 + v)``, and cosines of their pressure angles; of
    pairs that do not drive both are 0.

    Parameters
    ----------
    phases : list of list of mpmath numbers, shape (K, n)
        Phases of the pairs that may drive, rad, a list for each satellite.
    force_exponent : float
        Exponent v of the force over the approach.
    wave_angle : mpmath number
        Angle of the crank against the pins, rad.

    Returns
    -------
    forces, cosines : list of list of mpmath numbers, shape (K, n)

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (10).
    """
    import mpmath

    zero, power = mpmath.mpf(0), mpmath.mpf(force_exponent)
    cosines = [[max(zero, -mpmath.sin(wave_angle + phase)) for phase in own] for own in phases]
    best = max(map(max, filter(None, cosines)))
    shares = [[(c / best) ** power if c else zero for c in own] for own in cosines]
    total = mpmath.fsum(map(mpmath.fdot, shares, cosines))
    return [[share / total for share in own] for own in shares], cosines
