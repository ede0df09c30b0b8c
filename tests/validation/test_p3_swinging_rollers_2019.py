"""Paper values: Ovsyannikov, Perminov, Glavatskikh, Saltykova 2019 (P3), doi
10.22213/2413-1172-2019-2-39-46, and why its eqs (8), (9), (11)-(13) cannot be right as printed.

Numbers are the paper's formulas (9), (6), (4) evaluated to 10 digits or more elsewhere.
"""

import math

import pytest

from core.precision import CONVERGED, SAME
from core.rollers.roller_strength import (
    ByPoissonsRatio,
    PositionTolerance,
    RollerShape,
    RollerStrength,
    load_nonuniformity,
    roller_strength,
)

FIG_4 = {"friction_coefficient": 0.16, "modulus_ratio": 2.1e11 / 7.8e10}
E, D, R, T, N, K, MU, K_SIGMA = 210e9, 0.01, 0.03, 0.001 * 210e9 * 0.01**3, 4, 0.16, 0.3, 2.0
B, SPHERE = 0.8 * D, 1.5 * D


def fig_6(length_ratio: float, tolerance_ratio: float) -> RollerStrength:
    return roller_strength(
        output_torque=T,
        hole_circle_radius=R,
        rollers=N,
        cylinder_length=length_ratio * D,
        sphere_width=B,
        sphere_diameter=SPHERE,
        diameter=D,
        friction_coefficient=K,
        youngs_modulus=E,
        shear=ByPoissonsRatio(MU),
        stress_concentration=K_SIGMA,
        spacing=PositionTolerance(tolerance_ratio * D),
    )


@pytest.mark.parametrize(
    ("length", "stiffness"), [(1.0, 0.048588913), (2.0, 0.011424309), (3.0, 0.0042613394)]
)
def test_fig_4(length: float, stiffness: float) -> None:
    found = RollerShape(length=length, width=0.8, sphere=1.5).relative_stiffness(**FIG_4)
    assert found == pytest.approx(stiffness, abs=5e-10)


def test_fig_5_ends_where_one_roller_carries_everything() -> None:
    # P3: delta above 1 means one roller, for n = 4
    assert load_nonuniformity(relative_position_error=1.0, rollers=4) == 4.0
    assert load_nonuniformity(relative_position_error=0.5, rollers=4) == 2.5
    # for other n the limit is n/4: with 6 rollers all still carry at delta = 1
    assert load_nonuniformity(relative_position_error=1.0, rollers=6) < 6


def test_fig_6() -> None:
    assert fig_6(2.0, 2e-4).relative_stress == pytest.approx(0.0024213655, abs=1e-10)


def test_one_roller_stress_is_eq_14() -> None:
    result = fig_6(2.0, 1.0)
    arm = 2 * 2 * D + B + K * SPHERE
    assert result.loaded_rollers == 1
    assert result.bending_stress == pytest.approx(
        K_SIGMA * arm * 8 * T / (R * math.pi * D**3), rel=CONVERGED
    )


def bending_and_shear(length: float) -> tuple[float, float]:
    """The two parts of the compliance in P3 (9)."""
    inertia, area, shear_modulus = math.pi * D**4 / 64, math.pi * D**2 / 4, E / (2 * (1 + MU))
    bracket = (K * SPHERE + B) * length / 4 + length**2 / 3 + B * (length + K * SPHERE + B) / 4
    return length / (E * inertia) * bracket, 1.11 / (shear_modulus * area) * (length + B / 2)


def printed_force(length: float, tolerance: float) -> float:
    """P3 (11) as printed: n before the bending part only."""
    bending, shear = bending_and_shear(length)
    return T / (2 * R * N) + 4 * tolerance * (N - 1) / (N * bending + shear)


def system_residual(force: float, length: float, tolerance: float) -> float:
    """Relative residual of P3 (5) if the first roller carries `force`."""
    stiffness = 1 / sum(bending_and_shear(length))  # (9)
    others = force - stiffness * 4 * tolerance
    return (force + (N - 1) * others) / (T / (2 * R)) - 1


@pytest.mark.parametrize("length", [1.0 * D, 2.0 * D, 3.0 * D])
def test_erratum_11_breaks_the_equilibrium_5(length: float) -> None:
    tolerance = 1e-4 * D
    assert abs(system_residual(printed_force(length, tolerance), length, tolerance)) > 5e-4
    derived = fig_6(length / D, 1e-4)
    assert abs(system_residual(derived.max_force, length, tolerance)) < 1e-12


@pytest.mark.parametrize(
    ("length", "tolerance", "excess"),
    [(1.0, 4e-4, 0.0943), (0.5, 1e-4, 0.184), (0.5, 3e-4, 0.289), (2.0, 4e-4, 0.0135)],
)
def test_erratum_12_contradicts_4_and_6(length: float, tolerance: float, excess: float) -> None:
    # (12) is (11) times the arm of (4) over W: compare with (6), whose stiffness is (9)
    derived = fig_6(length, tolerance)
    arm = length * D + B / 2 + K * SPHERE / 2
    printed = K_SIGMA * arm * printed_force(length * D, tolerance * D) / (math.pi * D**3 / 32)
    by_6 = T / (2 * R * N) + 4 * (N - 1) / N * derived.stiffness * tolerance * D
    assert derived.max_force == pytest.approx(by_6, rel=CONVERGED)
    assert printed / derived.bending_stress - 1 == pytest.approx(excess, abs=5e-4)


def relative_stress(length: float, tolerance: float, first: float, before_shear: int) -> float:
    """P3 (13): the first term of its bracket, and the factor before the shear part, given."""
    b, sphere, torque, radius = 0.8, 1.5, 0.001, 3.0
    bracket = first + length**2 / 3 + b * (length + K * sphere + b) / 4
    compliance = 16 * N * length * bracket + before_shear * 2.22 * (1 + MU) * (length + b / 2)
    load = 8 * torque / (radius * N * math.pi) + 16 * tolerance * (N - 1) / compliance
    return K_SIGMA * (2 * length + b + K * sphere) * load


@pytest.mark.parametrize(
    ("length", "tolerance", "excess", "of_n"),
    [(1.0, 1e-4, 0.0391, 0.0391), (1.5, 4e-4, 0.064, 0.0336)],
)
def test_erratum_13_contradicts_6_and_10(
    length: float, tolerance: float, excess: float, of_n: float
) -> None:
    # (13) leaves out n before the shear part, and l/d in the first term, which (10) has
    first = (K * 1.5 + 0.8) * length / 4
    derived = fig_6(length, tolerance).bending_stress / E
    assert derived == pytest.approx(relative_stress(length, tolerance, first, N), rel=SAME)
    printed = relative_stress(length, tolerance, first / length, 1)
    assert printed / derived - 1 == pytest.approx(excess, abs=5e-4)
    without_n = relative_stress(length, tolerance, first, 1)
    assert without_n / derived - 1 == pytest.approx(of_n, abs=5e-4)


def test_note_on_8_and_9_shear_does_not_turn_the_end() -> None:
    # Theta(l) of (8) is the slope of the elastic line. (9) carries the shear angle over b/2 too,
    # as if the end section turned by it: the program keeps (9), the paper's figures are made so
    bending, shear = bending_and_shear(D)
    assert fig_6(1.0, 1e-4).stiffness == pytest.approx(1 / (bending + shear), rel=CONVERGED)
    modulus_ratio = FIG_4["modulus_ratio"] / (2 * (1 + MU))  # fig. 4 gives G, not mu
    shear *= modulus_ratio
    section_stays = bending + shear * D / (D + B / 2)
    assert 1 - section_stays / (bending + shear) == pytest.approx(0.059, abs=5e-4)
