"""Deflection of a stepped shaft with an overhang, by Mohr's integral."""

from collections.abc import Sequence
from itertools import pairwise

from mpmath import mp, mpf


def exact_deflection(
    sections: Sequence[tuple[float, float]],
    a: float,
    b: float,
    modulus: float,
    load_b: mpf,
    load_c: mpf,
    place: mpf,
    slope: bool = False,
) -> mpf:
    """Mohr's integral over x from C, with quadrature that is exact for its cubics: the deflection
    of a place, or its slope.

    Sections are (length, diameter), from C; the last reaches to the clamp, a + b.
    """
    total, start = mpf(0), mpf(0)
    for index, (length, diameter) in enumerate(sections):
        end = start + mpf(length) if index < len(sections) - 1 else mpf(a) + mpf(b)
        cuts = sorted({start, end, *(c for c in (mpf(a), place) if start < c < end)})
        rigidity = mpf(modulus) * mp.pi * mpf(diameter) ** 4 / 64
        for p, q in pairwise(cuts):
            values = []
            for x in (p, (p + q) / 2, q):
                moment = load_c * x + load_b * max(x - mpf(a), mpf(0))
                arm = mpf(p >= place) if slope else max(x - place, mpf(0))
                values.append(moment * arm)
            total += (q - p) * (values[0] + 4 * values[1] + values[2]) / (6 * rigidity)
        start = end
    return total
