"""Invariants of the swinging rollers, refusals, notices, and the curves against the design."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.precision import CONVERGED, EXACT, SAME
from core.rollers.roller_curves import roller_curves
from core.rollers.roller_strength import (
    RollerStrength,
    roller_arguments,
    roller_strength,
    single_roller_limit,
)

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


def strength(**inputs: Any) -> RollerStrength:
    return roller_strength(**roller_arguments(**inputs))


@given(st.lists(st.floats(-1e-4, 1e-4), min_size=1, max_size=30))
def test_any_gaps(gaps: list[float]) -> None:
    result = strength(**without("position_tolerance") | {"rollers": len(gaps), "gaps": gaps})
    assert math.fsum(result.forces) == pytest.approx(210.0 / (2 * 0.03), rel=SAME)
    assert result.max_force == result.forces[gaps.index(min(gaps))]
    bound = 1 + 4 * (len(gaps) - 1) / len(gaps) * result.relative_position_error
    if result.loaded_rollers == len(gaps):
        assert result.load_nonuniformity == pytest.approx(bound, rel=EXACT)
    else:
        assert result.load_nonuniformity <= bound * (1 + 1e-12)


def test_the_tolerance_is_one_case_of_gaps() -> None:
    by_tolerance = strength(**DESIGN)
    by_gaps = strength(
        **without("position_tolerance") | {"gaps": [1e-3 + g for g in (8e-6, 0.0, 8e-6, 8e-6)]}
    )
    assert by_gaps.forces[1] == pytest.approx(by_tolerance.forces[0], rel=SAME)
    assert by_gaps.relative_position_error == pytest.approx(
        by_tolerance.relative_position_error, rel=SAME
    )
    assert by_gaps.bending_stress == pytest.approx(by_tolerance.bending_stress, rel=SAME)


@pytest.mark.parametrize("rollers", [1, 2, 3, 4, 7, 200])
def test_psi_is_continuous_where_one_roller_remains(rollers: int) -> None:
    base = strength(**DESIGN | {"rollers": rollers})
    limit = single_roller_limit(rollers=rollers) * base.mean_force / base.stiffness
    below, above = (
        strength(**DESIGN | {"rollers": rollers, "position_tolerance": limit * (1 + side)})
        for side in (-1e-9, 1e-9)
    )
    assert below.load_nonuniformity == pytest.approx(rollers, rel=EXACT)
    assert above.load_nonuniformity == pytest.approx(rollers, rel=CONVERGED)
    assert below.loaded_rollers == rollers
    assert above.loaded_rollers == 1


@pytest.mark.parametrize("sharing", [{}, {"position_tolerance": 0.0}, {"gaps": [0, 3e-6, 0, 1e-5]}])
def test_curves_go_through_the_design(sharing: dict[str, Any]) -> None:
    design = (without("position_tolerance") if "gaps" in sharing else DESIGN) | sharing
    curves, own = roller_curves(**roller_arguments(**design)), strength(**design)
    assert curves.design == own
    place = own.shape.length
    assert np.interp(place, curves.length_ratio, curves.relative_stiffness) == pytest.approx(
        own.relative_stiffness, rel=1e-3
    )
    assert np.all(np.diff(curves.relative_stiffness) < 0)
    assert curves.scales_gaps == ("gaps" in sharing)
    own_curve = curves.stress[1.0 if curves.scales_gaps else design["position_tolerance"]]
    assert np.interp(place, curves.length_ratio, own_curve) == pytest.approx(
        own.bending_stress, rel=1e-3
    )


@pytest.mark.parametrize(
    ("length", "first", "last"), [(0.004, 0.2, 4.0), (0.02, 0.5, 4.0), (0.05, 0.5, 7.5)]
)
def test_short_and_long_rollers_have_room_on_both_sides(
    length: float, first: float, last: float
) -> None:
    curves = roller_curves(**roller_arguments(**DESIGN | {"cylinder_length": length}))
    assert curves.length_ratio[[0, -1]] == pytest.approx([first, last], rel=CONVERGED)


def test_equal_gaps_have_the_curves_of_tolerances() -> None:
    gaps = {"gaps": [1e-5] * DESIGN["rollers"]}
    curves = roller_curves(**roller_arguments(**without("position_tolerance"), **gaps))
    assert not curves.scales_gaps
    assert np.interp(
        curves.design.shape.length, curves.length_ratio, curves.stress[0.0]
    ) == pytest.approx(curves.design.bending_stress, rel=1e-3)
    assert curves.nonuniformity[4][-1] == 4.0
    assert curves.position_error[-1] >= curves.limit == 1.0


@given(st.integers(0, 2**32), st.integers(1, 8), st.booleans())
def test_rollers_of_an_array_are_those_one_by_one(seed: int, rollers: int, worst: bool) -> None:
    random, count = np.random.default_rng(seed), 5
    designs: dict[str, Any] = {
        "output_torque": 10.0 ** random.uniform(-2, 4, count),
        "hole_circle_radius": random.uniform(0.01, 1, count),
        "cylinder_length": random.uniform(0.001, 0.1, count),
        "sphere_width": random.uniform(0.001, 0.03, count),
        "sphere_diameter": random.uniform(0.001, 0.03, count),
        "diameter": random.uniform(0.001, 0.03, count),
        "friction_coefficient": random.uniform(0, 1, count),
        "youngs_modulus": random.uniform(1e9, 3e11, count),
        "poissons_ratio": random.uniform(0.0, 0.49, count),
        "stress_concentration": random.uniform(1, 3, count),
    }
    spread = 10.0 ** random.uniform(-8, -4)
    gaps = spread * random.integers(-2, 6, (rollers, count))
    several = {"position_tolerance": abs(gaps[0])} if worst else {"gaps": [*gaps]}
    together = strength(**designs, rollers=rollers, **several)
    for index in range(count):
        one = strength(
            **{name: float(values[index]) for name, values in designs.items()},
            rollers=rollers,
            **(
                {"position_tolerance": float(abs(gaps[0, index]))}
                if worst
                else {"gaps": gaps[:, index].tolist()}
            ),
        )
        for name in RollerStrength.__slots__:
            got, expected = getattr(together, name), getattr(one, name)
            if name == "accuracy":
                got, expected = got.relative_error, expected.relative_error
            if name == "shape":
                got, expected = got.length, expected.length
            if name == "forces":
                got = [force[index] for force in got]
                assert got == pytest.approx(expected, rel=CONVERGED, abs=1e-14 * one.max_force)
            else:
                assert np.broadcast_to(got, count)[index] == pytest.approx(
                    expected, rel=CONVERGED
                ), name


def test_shear_modulus_or_poissons_ratio() -> None:
    by_shear = strength(**without("poissons_ratio") | {"shear_modulus": 210e9 / 2.6})
    assert by_shear.stiffness == pytest.approx(strength(**DESIGN).stiffness, rel=CONVERGED)


@pytest.mark.parametrize(
    ("parameter", "changes"),
    [
        *[(name, {name: 0.0}) for name in (*LENGTHS, "output_torque", "youngs_modulus")],
        ("output_torque", {"output_torque": math.nan}),
        ("stress_concentration", {"stress_concentration": -1.0}),
        ("rollers", {"rollers": 0}),
        ("friction_coefficient", {"friction_coefficient": -0.1}),
        ("poissons_ratio", {"poissons_ratio": 0.5}),
        ("shear_modulus", {"shear_modulus": -1.0}),
        ("position_tolerance", {"position_tolerance": -1e-6}),
        ("gaps", {"gaps": [0.0] * 3}),
        ("gaps[2]", {"gaps": [0.0, 0.0, math.nan, 0.0]}),
    ],
)
def test_refusals(parameter: str, changes: dict[str, Any]) -> None:
    with pytest.raises(InvalidInput) as caught:
        roller_strength(**roller_arguments(**DESIGN) | roller_arguments(**changes))
    assert caught.value.parameter == parameter


def test_one_of_a_kind_is_given() -> None:
    for more in ({"gaps": [0.0] * 4}, {"shear_modulus": 80e9}):
        with pytest.raises(InvalidInput) as caught:
            strength(**DESIGN | more)
        assert caught.value.code == "only_one" and caught.value.parameter in more


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
    assert not strength(**DESIGN).notices
    (notice,) = strength(**DESIGN | changes).notices
    assert notice.code == code


@pytest.mark.parametrize(("base", "codes"), [(1e-3, []), (1e12, ["hardly_known"])])
def test_gaps_that_differ_only_by_rounding_say_that_hardly_anything_is_known(
    base: float, codes: list[str]
) -> None:
    gaps = [base, base, base * (1 + 2.0**-50), base]
    result = strength(**without("position_tolerance") | {"gaps": gaps})
    assert [notice.code for notice in result.notices] == codes
