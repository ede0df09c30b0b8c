"""Load sharing of rollers: sorting against iterations for the displacement."""

from collections.abc import Sequence
from typing import Any

from core.load_sharing import share_load
from core.work_precision.study import (
    DEFAULT,
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)


def roller_sharing_study(*, total: float, stiffness: float, gaps: Sequence[float]) -> WorkPrecision:
    """Error against run time of the forces of unilateral contacts.

    Parameters
    ----------
    total : float
        Sum of the forces, N.
    stiffness : float
        Stiffness of one contact, N/m.
    gaps : sequence of float
        Gaps, m.

    Returns
    -------
    WorkPrecision
    """
    first = min(gaps)

    def forces(displacement: float) -> list[float]:
        return [stiffness * max(0.0, displacement - gap) for gap in gaps]

    def bisection(steps: int) -> Outcome:
        low, high = first, max(gaps) + total / stiffness
        for _ in range(steps):
            middle = (low + high) / 2
            low, high = (middle, high) if sum(forces(middle)) < total else (low, middle)
        return forces((low + high) / 2), steps

    def newton(steps: int) -> Outcome:
        displacement = max(gaps) + total / stiffness
        for _ in range(steps):
            loaded = [gap for gap in gaps if gap < displacement]
            if not loaded:
                break
            off = sum(forces(displacement)) - total
            displacement -= off / (stiffness * len(loaded))
        return forces(displacement), steps

    def sorting(_: float) -> Outcome:
        return [*share_load(total=total, stiffness=stiffness, gaps=gaps).forces], 1

    return work_precision(
        reference=Reference("multiple_sorting"),
        exact=_exact_forces(total, stiffness, gaps),
        methods=[
            Method("bisection", [("steps", n) for n in (10, 20, 30, 40, 50, 60)], bisection),
            Method("newton", [("steps", n) for n in (1, 2, 3, 4, 6, 8)], newton),
            Method("sorting", DEFAULT, sorting, chosen=True),
        ],
    )


def _exact_forces(total: float, stiffness: float, gaps: Sequence[float]) -> list[Any]:
    """Forces in multiple precision: the number of loaded contacts is found by trying each."""
    import mpmath as mp

    with mp.workdps(REFERENCE_DIGITS):
        ordered = sorted(mp.mpf(gap) for gap in gaps)
        displacement = ordered[0]
        for loaded in range(1, len(ordered) + 1):
            displacement = (mp.mpf(total) / mp.mpf(stiffness) + sum(ordered[:loaded])) / loaded
            if loaded == len(ordered) or displacement <= ordered[loaded]:
                break
        return [mp.mpf(stiffness) * max(mp.mpf(0), displacement - mp.mpf(gap)) for gap in gaps]
