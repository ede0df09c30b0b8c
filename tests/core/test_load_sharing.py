"""Load sharing against its definition in rational numbers; limits and refusals."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.load_sharing import share_load
from core.precision import CONVERGED

GAPS = st.lists(st.floats(-1e-3, 1e-3), min_size=1, max_size=40)
LOADS = st.floats(1e-6, 1e6)
STIFFNESSES = st.floats(1e3, 1e12)


def exact_forces(total: float, stiffness: float, gaps: list[float]) -> list[Fraction]:
    """The definition, in rational numbers, by trying every number of closed contacts."""
    load, c, g = Fraction(total), Fraction(stiffness), [Fraction(gap) for gap in gaps]
    for closed in range(1, len(g) + 1):
        first = sorted(g)[:closed]
        displacement = (load / c + sum(first)) / closed
        forces = [c * max(Fraction(0), displacement - gap) for gap in g]
        if sum(forces) == load:
            return forces
    raise AssertionError("no equilibrium found")


@given(total=LOADS, stiffness=STIFFNESSES, gaps=GAPS)
def test_forces_are_the_exact_ones(total: float, stiffness: float, gaps: list[float]) -> None:
    sharing = share_load(total=total, stiffness=stiffness, gaps=gaps)
    exact = exact_forces(total, stiffness, gaps)
    largest = max(exact)
    for force, true in zip(sharing.forces, exact, strict=True):
        assert abs(Fraction(force) - true) <= sharing.relative_error * largest
    assert sharing.loaded == sum(force > 0 for force in sharing.forces)
    assert sharing.largest_force == pytest.approx(max(sharing.forces), rel=CONVERGED)
    moved = largest / Fraction(stiffness) + Fraction(min(gaps))
    size = max(abs(sharing.displacement), *map(abs, gaps))
    assert abs(Fraction(sharing.displacement) - moved) <= sharing.relative_error * size


@pytest.mark.parametrize("base", [0.0, 1.0, -1e3, 1e6])
def test_only_differences_of_gaps_matter(base: float) -> None:
    step = 2.0**-20  # exact beside every base
    gaps = [base + i * step for i in (0, 1, 3, 8)]
    shifted = share_load(total=7.0, stiffness=1e6, gaps=gaps)
    assert (
        shifted.forces
        == share_load(total=7.0, stiffness=1e6, gaps=[i * step for i in (0, 1, 3, 8)]).forces
    )


def test_a_tiny_load_closes_one_contact_of_a_huge_spread() -> None:
    sharing = share_load(total=1e-200, stiffness=1e9, gaps=[3e-4, -1e300, 1e300, 1e-4])
    assert sharing.forces == (0.0, 1e-200, 0.0, 0.0)
    assert sharing.loaded == 1


def test_no_load() -> None:
    sharing = share_load(total=0.0, stiffness=1.0, gaps=[2.0, 1.0])
    assert sharing.forces == (0.0, 0.0)
    assert sharing.loaded == 0
    assert sharing.displacement == 1.0


@pytest.mark.parametrize(
    ("parameter", "arguments"),
    [
        ("total", {"total": -1.0}),
        ("total", {"total": math.nan}),
        ("stiffness", {"stiffness": 0.0}),
        ("gaps", {"gaps": []}),
        ("gaps[1]", {"gaps": [0.0, math.inf]}),
    ],
)
def test_refusals(parameter: str, arguments: dict[str, object]) -> None:
    valid: dict[str, object] = {"total": 1.0, "stiffness": 1.0, "gaps": [0.0]}
    with pytest.raises(InvalidInput) as caught:
        share_load(**(valid | arguments))  # type: ignore[arg-type]
    assert caught.value.parameter == parameter
