"""Swinging rollers against 40-digit arithmetic of the definition, random and extreme input."""

import random

import pytest
from mpmath import mp, mpf

from core.load_sharing import share_load
from core.rollers.roller_strength import roller_arguments, roller_strength
from tests.inputs.cases import random_rollers
from tests.oracles.rollers import exact_compliance, exact_forces
from tests.oracles.seeds import seeds


def error(value: float, exact: mpf, scale: mpf) -> float:
    return float(abs(mpf(value) - exact) / abs(scale))


@pytest.mark.parametrize("seed", seeds(20))
def test_every_number_by_tolerance(seed: int) -> None:
    case = random_rollers(seed)
    r = random.Random(-seed - 1)
    n = case["rollers"]
    delta = r.choice([0.0, n / 4, n / 4 * (1 + 1e-9), 10 ** r.uniform(-6, 6)])
    stiffness = 1 / exact_compliance(case)
    total = mpf(case["output_torque"]) / (2 * mpf(case["hole_circle_radius"]))
    mean = total / n
    tolerance = float(delta * mean / stiffness)
    result = roller_strength(**roller_arguments(**case, position_tolerance=tolerance))
    stated = result.accuracy.relative_error
    assert stated < 1e-13

    gaps = [mpf(0)] + [4 * mpf(tolerance)] * (n - 1)
    forces = exact_forces(total, stiffness, gaps)
    length, width = mpf(case["cylinder_length"]), mpf(case["sphere_width"])
    friction, sphere = mpf(case["friction_coefficient"]), mpf(case["sphere_diameter"])
    moment = (length + width / 2 + friction * sphere / 2) * forces[0]
    stress = mpf(case["stress_concentration"]) * moment * 32 / (mp.pi * mpf(case["diameter"]) ** 3)
    for value, exact in (
        (result.stiffness, stiffness),
        (result.relative_stiffness, stiffness / (width * mpf(case["youngs_modulus"]))),
        (result.mean_force, mean),
        (result.max_force, forces[0]),
        (result.load_nonuniformity, forces[0] / mean),
        (result.displacement, forces[0] / stiffness),
        (result.bending_moment, moment),
        (result.bending_stress, stress),
    ):
        assert error(value, exact, exact) <= stated
    if tolerance > 0:
        exact_delta = stiffness * mpf(tolerance) / mean
        assert error(result.relative_position_error, exact_delta, exact_delta) <= stated
    for value, exact in zip(result.forces, forces, strict=True):
        assert error(value, exact, forces[0]) <= stated


@pytest.mark.parametrize("seed", seeds(20))
def test_load_sharing_of_any_gaps(seed: int) -> None:
    r = random.Random(seed)
    n = r.choice([1, 2, 3, r.randint(1, 200)])
    total, stiffness = 10 ** r.uniform(-9, 9), 10 ** r.uniform(0, 12)
    spread = total / stiffness * 10 ** r.uniform(-6, 6)
    base = r.choice([0.0, spread, -1e3 * spread, 1e6 * spread])
    kind = r.choice(["any", "equal", "powers", "two"])
    gaps = [
        base
        + {
            "any": r.uniform(0, spread),
            "equal": 0.0,
            "powers": spread * 10 ** r.uniform(-12, 6),
            "two": r.choice([0.0, spread]),
        }[kind]
        for _ in range(n)
    ]
    sharing = share_load(total=total, stiffness=stiffness, gaps=gaps)
    exact = exact_forces(mpf(total), mpf(stiffness), [mpf(gap) for gap in gaps])
    for value, true in zip(sharing.forces, exact, strict=True):
        assert error(value, true, max(exact)) <= sharing.relative_error
    displacement = min(mpf(gap) for gap in gaps) + max(exact) / mpf(stiffness)
    size = max(abs(displacement), mpf(max(abs(gap) for gap in gaps)))
    assert error(sharing.displacement, displacement, size) <= sharing.relative_error
