"""Published values: Shigley's Mechanical Engineering Design, fatigue of steel.

The factors of example 6-9 are printed to three digits; ours use the SI form of the size factor,
which differs from theirs in the third.
"""

import math

import pytest

from core.fatigue import (
    EnduranceFactors,
    cycles_to_failure,
    endurance_limit,
    notch_factor,
    reliability_factor,
    size_factor,
    strength_fraction,
    surface_factor,
    utilisation,
)

KPSI = 6.894757293168361e6


def test_example_6_9_factors() -> None:
    surface = surface_factor(tensile_strength=690e6, surface="machined", edition="shigley_9")
    size = size_factor(diameter=0.032)
    factors = EnduranceFactors(surface, size, reliability_factor(percent=50.0), 1.0)
    assert f"{surface:.3f}" == "0.798" and f"{surface:.6f}" == "0.797777"
    assert f"{size:.6f}" == "0.855797"
    assert size == pytest.approx(0.858, abs=2.5e-3)
    limit = endurance_limit(tensile_strength=690e6, factors=factors)
    assert f"{limit / 1e6:.3f}" == "235.544" and limit == pytest.approx(236e6, rel=2e-3)
    notch = notch_factor(theoretical_factor=1.65, radius=0.003, tensile_strength=690e6)
    assert f"{notch:.2f}" == "1.55" and f"{notch:.6f}" == "1.550182"


def test_example_6_10_criteria() -> None:
    cycle = {"amplitude": 8.38, "mean": 8.38, "endurance": 33.9, "tensile_strength": 100.0}
    assert f"{1 / utilisation(**cycle, criterion='gerber'):.6f}" == "3.663974"
    assert f"{1 / utilisation(**cycle):.4f}" == "3.0212"


def test_example_6_3_finite_life() -> None:
    cycle = {"amplitude": 70 * KPSI, "mean": 0.0, "endurance": 60 * KPSI}
    found = cycles_to_failure(**cycle, tensile_strength=120 * KPSI, fraction=0.82)
    assert round(found) == 116193
    assert found == pytest.approx(117_000, rel=0.01)
    assert f"{strength_fraction(tensile_strength=120 * KPSI):.2f}" == "0.82"


def test_example_7_1_diameter() -> None:
    """DE-Goodman of a shaft, kpsi and inches: d = 1.073 in."""
    a, b = 2920.0, 2391.0
    used = utilisation(amplitude=a, mean=b, endurance=30e3, tensile_strength=100e3)
    assert (16 * 2.0 / math.pi * used) ** (1 / 3) == pytest.approx(1.072883, abs=1e-6)


def test_the_editions_differ() -> None:
    """Machined and ground surfaces are lower in the newer one, hot-rolled and forged ones not."""

    def change(surface: str, strength: float) -> str:
        older, newer = (
            surface_factor(tensile_strength=strength, surface=surface, edition=edition)
            for edition in ("shigley_9", "shigley_11")
        )
        return f"{newer / older - 1:+.3f}"

    assert [change("machined", s) for s in (500e6, 1000e6, 1400e6)] == [
        "-0.092",
        "-0.061",
        "-0.046",
    ]
    assert change("forged", 1000e6).startswith("+")
    assert change("hot_rolled", 500e6).startswith("+")
