"""Invariants of the swinging rollers, refusals, notices, and the curves against the design."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.rollers.roller_curves import (
    load_nonuniformity,
    relative_stiffness,
    relative_stress,
    single_roller_limit,
)
from core.rollers.roller_strength import roller_strength

DESIGN: dict[str, Any] = {
    "output_torque": 210.0,
    "hole_circle_radius": 0.03,
    "rollers": 4,
    "cylinder_length": 0.02,
    "sphere_width": 0.008,
    "sphere_diameter": 0.015,
    "diameter": 0.01,
    "friction_coefficient": 0.16,
    "youngs_modulus": 210e9,
    "poissons_ratio": 0.3,
    "stress_concentration": 2.0,
    "position_tolerance": 2e-6,
}
LENGTHS = ("hole_circle_radius", "cylinder_length", "sphere_width", "sphere_diameter", "diameter")


def without(*names: str) -> dict[str, Any]:
    return {name: value for name, value in DESIGN.items() if name not in names}


@given(
    rollers=st.integers(1, 200),
    tolerance=st.floats(0, 1e-2),
    torque=st.floats(1e-3, 1e6),
    length_ratio=st.floats(1e-3, 1e3),
)
def test_equilibrium(rollers: int, tolerance: float, torque: float, length_ratio: float) -> None:
    result = roller_strength(
        **DESIGN
        | {
            "rollers": rollers,
            "position_tolerance": tolerance,
            "output_torque": torque,
            "cylinder_length": length_ratio * DESIGN["diameter"],
        }
    )
    assert math.fsum(result.forces) == pytest.approx(torque / (2 * 0.03), rel=1e-12)
    assert 1 - 1e-13 <= result.load_nonuniformity <= rollers * (1 + 1e-13)
    assert result.centre_force == 2 * result.max_force
    assert result.load_nonuniformity == pytest.approx(
        load_nonuniformity(relative_position_error=result.relative_position_error, rollers=rollers),
        rel=1e-12,
    )
    # the most loaded roller bends by the whole displacement, (5)
    assert result.max_force == pytest.approx(result.stiffness * result.displacement, rel=1e-12)


@given(st.lists(st.floats(-1e-4, 1e-4), min_size=1, max_size=30))
def test_any_gaps(gaps: list[float]) -> None:
    result = roller_strength(**without("position_tolerance") | {"rollers": len(gaps), "gaps": gaps})
    assert math.fsum(result.forces) == pytest.approx(210.0 / (2 * 0.03), rel=1e-12)
    assert result.max_force == result.forces[gaps.index(min(gaps))]
    bound = 1 + 4 * (len(gaps) - 1) / len(gaps) * result.relative_position_error
    if result.loaded_rollers == len(gaps):
        assert result.load_nonuniformity == pytest.approx(bound, rel=1e-9)
    else:
        assert result.load_nonuniformity <= bound * (1 + 1e-12)


def test_the_tolerance_is_one_case_of_gaps() -> None:
    by_tolerance = roller_strength(**DESIGN)
    by_gaps = roller_strength(
        **without("position_tolerance") | {"gaps": [1e-3 + g for g in (8e-6, 0.0, 8e-6, 8e-6)]}
    )
    assert by_gaps.forces[1] == pytest.approx(by_tolerance.forces[0], rel=1e-10)
    assert by_gaps.relative_position_error == pytest.approx(
        by_tolerance.relative_position_error, rel=1e-10
    )
    assert by_gaps.bending_stress == pytest.approx(by_tolerance.bending_stress, rel=1e-10)


@pytest.mark.parametrize("rollers", [1, 2, 3, 4, 7, 200])
def test_psi_is_continuous_where_one_roller_remains(rollers: int) -> None:
    base = roller_strength(**DESIGN | {"rollers": rollers})
    limit = single_roller_limit(rollers=rollers) * base.mean_force / base.stiffness
    below, above = (
        roller_strength(**DESIGN | {"rollers": rollers, "position_tolerance": limit * (1 + side)})
        for side in (-1e-9, 1e-9)
    )
    assert below.load_nonuniformity == pytest.approx(rollers, rel=1e-8)
    assert above.load_nonuniformity == pytest.approx(rollers, rel=1e-13)
    assert below.loaded_rollers == rollers
    assert above.loaded_rollers == 1


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e3))
def test_scaling(size: float, load: float) -> None:
    base = roller_strength(**DESIGN)
    scaled = roller_strength(
        **DESIGN
        | {name: size * DESIGN[name] for name in LENGTHS}
        | {
            "output_torque": load * size * DESIGN["output_torque"],
            "position_tolerance": load / size * DESIGN["position_tolerance"],
        }
    )
    assert scaled.load_nonuniformity == pytest.approx(base.load_nonuniformity, rel=1e-12)
    assert scaled.max_force == pytest.approx(load * base.max_force, rel=1e-12)
    assert scaled.stiffness == pytest.approx(size * base.stiffness, rel=1e-12)
    assert scaled.displacement == pytest.approx(load / size * base.displacement, rel=1e-12)
    assert scaled.bending_stress == pytest.approx(load / size**2 * base.bending_stress, rel=1e-12)


def test_curves_go_through_the_design() -> None:
    result = roller_strength(**DESIGN)
    shape: dict[str, Any] = {
        "relative_width": 0.8,
        "relative_sphere": 1.5,
        "friction_coefficient": 0.16,
        "modulus_ratio": 2.6,
    }
    lengths = np.array([0.5, 2.0, 5.0])
    stiffness = relative_stiffness(relative_length=lengths, **shape)
    assert stiffness[1] == pytest.approx(result.relative_stiffness, rel=1e-14)
    assert np.all(np.diff(stiffness) < 0)
    stress = relative_stress(
        relative_length=lengths,
        rollers=4,
        relative_torque=0.001,
        relative_radius=3.0,
        relative_tolerance=2e-4,
        stress_concentration=2.0,
        **shape,
    )
    assert stress[1] == pytest.approx(result.bending_stress / 210e9, rel=1e-13)
    psi = load_nonuniformity(relative_position_error=np.array([0.0, 0.5, 1.0, 9.0]), rollers=4)
    assert psi.tolist() == [1.0, 2.5, 4.0, 4.0]


def test_shear_modulus_or_poissons_ratio() -> None:
    by_shear = roller_strength(**without("poissons_ratio") | {"shear_modulus": 210e9 / 2.6})
    assert by_shear.stiffness == pytest.approx(roller_strength(**DESIGN).stiffness, rel=1e-14)


@pytest.mark.parametrize(
    ("parameter", "changes"),
    [
        *[(name, {name: 0.0}) for name in (*LENGTHS, "output_torque", "youngs_modulus")],
        ("output_torque", {"output_torque": math.nan}),
        ("stress_concentration", {"stress_concentration": -1.0}),
        ("rollers", {"rollers": 0}),
        ("friction_coefficient", {"friction_coefficient": -0.1}),
        ("poissons_ratio", {"poissons_ratio": 0.5}),
        ("poissons_ratio", {"poissons_ratio": None}),
        ("shear_modulus", {"shear_modulus": 78e9}),
        ("shear_modulus", {"shear_modulus": -1.0, "poissons_ratio": None}),
        ("position_tolerance", {"position_tolerance": -1e-6}),
        ("position_tolerance", {"position_tolerance": None}),
        ("gaps", {"gaps": [0.0] * 4}),
        ("gaps", {"gaps": [0.0] * 3, "position_tolerance": None}),
        ("gaps[2]", {"gaps": [0.0, 0.0, math.nan, 0.0], "position_tolerance": None}),
    ],
)
def test_refusals(parameter: str, changes: dict[str, Any]) -> None:
    with pytest.raises(InvalidInput) as caught:
        roller_strength(**DESIGN | changes)
    assert caught.value.parameter == parameter


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("short_roller", {"cylinder_length": 0.009}),
        ("sphere_below_roller", {"sphere_diameter": 0.009}),
        ("sphere_too_wide", {"sphere_width": 0.016}),
        ("large_deflection", {"output_torque": 210e3}),
    ],
)
def test_notices(code: str, changes: dict[str, Any]) -> None:
    assert not roller_strength(**DESIGN).notices
    (notice,) = roller_strength(**DESIGN | changes).notices
    assert notice.code == code
