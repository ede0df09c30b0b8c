"""Invariants, refusals and notices of the shaft."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.precession.shaft import ShaftSection, shaft_diagram
from core.precession.shaft_deflection import shaft_deflection

LOAD: dict[str, Any] = {
    "force": (168.756146705, -337.606954169, 0.0),
    "moment": (-0.0316199045437, -0.0724918335263, 10.0),
}
SHAFT: dict[str, Any] = {"bearing_distance": 0.03, "overhang": 0.05, "youngs_modulus": 210e9}
STEPPED = [ShaftSection(0.02, 0.01), ShaftSection(0.04, 0.014), ShaftSection(0.02, 0.02)]
LENGTHS = st.floats(1e-3, 1.0)
DIAMETERS = st.floats(1e-3, 0.2)


def loaded(b: float, c: float, a: float) -> dict[str, Any]:
    """Mesh loads that press on the shaft with b at B and c at C, in x."""
    return {"force": (b + c, 0.0, 0.0), "moment": (0.0, b * a, 0.0)}


@given(
    lengths=st.lists(LENGTHS, min_size=1, max_size=5),
    diameters=st.lists(DIAMETERS, min_size=5, max_size=5),
    part=st.floats(0.05, 0.95),
)
def test_maxwells_reciprocity(lengths: list[float], diameters: list[float], part: float) -> None:
    total = math.fsum(lengths)
    a = part * total
    shaft = {
        "bearing_distance": a,
        "overhang": total - a,
        "youngs_modulus": 210e9,
        "shaft_sections": [
            ShaftSection(*pair) for pair in zip(lengths, diameters[: len(lengths)], strict=True)
        ],
    }
    c_under_b = shaft_deflection(**loaded(1.0, 0.0, a), **shaft).deflection_C.x
    b_under_c = shaft_deflection(**loaded(0.0, 1.0, a), **shaft).deflection_B.x
    assert c_under_b == pytest.approx(b_under_c, rel=1e-12)


@given(size=st.floats(1e-2, 1e2), factor=st.floats(1e-3, 1e3))
def test_scaling(size: float, factor: float) -> None:
    base = shaft_deflection(**LOAD, **SHAFT, shaft_sections=STEPPED)
    scaled = shaft_deflection(
        force=tuple(factor * f for f in LOAD["force"]),
        moment=tuple(factor * size * m for m in LOAD["moment"]),
        bearing_distance=size * 0.03,
        overhang=size * 0.05,
        youngs_modulus=210e9,
        shaft_sections=[ShaftSection(size * s.length, size * s.diameter) for s in STEPPED],
    )
    assert scaled.deflection_C.total * size / factor == pytest.approx(
        base.deflection_C.total, rel=1e-12
    )
    assert scaled.deflection_B.x * size / factor == pytest.approx(base.deflection_B.x, rel=1e-12)
    assert scaled.reaction_C == pytest.approx([factor * c for c in base.reaction_C], rel=1e-12)


def test_one_diameter_in_pieces_is_one_diameter() -> None:
    whole = shaft_deflection(**LOAD, **SHAFT, shaft_diameter=0.02)
    pieces = shaft_deflection(
        **LOAD,
        **SHAFT,
        shaft_sections=[ShaftSection(length, 0.02) for length in (0.01, 0.02, 0.05)],
    )
    assert pieces.deflection_B.total == pytest.approx(whole.deflection_B.total, rel=1e-14)
    assert pieces.deflection_C.total == pytest.approx(whole.deflection_C.total, rel=1e-14)
    assert whole.simplified_deflection_C is None
    assert whole.simplification_error_B is None


def test_the_smallest_diameter_everywhere_exaggerates() -> None:
    result = shaft_deflection(**LOAD, **SHAFT, shaft_sections=STEPPED)
    simplified = shaft_deflection(**LOAD, **SHAFT, shaft_diameter=0.01)
    assert result.simplified_deflection_B == simplified.deflection_B
    assert result.simplified_deflection_C == simplified.deflection_C
    assert result.simplification_error_C == pytest.approx(
        simplified.deflection_C.total / result.deflection_C.total - 1, rel=1e-13
    )
    assert result.simplification_error_B is not None
    assert result.simplification_error_B > 0


def test_the_error_of_the_load_is_passed_on() -> None:
    exact = shaft_deflection(**LOAD, **SHAFT, shaft_diameter=0.02).accuracy.relative_error
    rough = shaft_deflection(
        **LOAD, **SHAFT, shaft_diameter=0.02, force_error=1e-6, moment_error=1e-9
    ).accuracy.relative_error
    assert exact < 1e-14
    assert 1e-9 < rough < 1e-8


def test_diagram() -> None:
    result = shaft_deflection(**LOAD, **SHAFT, shaft_sections=STEPPED)
    diagram = shaft_diagram(**LOAD, **SHAFT, shaft_sections=STEPPED, samples=801)
    x = diagram.position
    assert x[0] == 0
    assert x[-1] == 0.08
    assert np.all(np.diff(x) >= 0)
    (jump,) = np.flatnonzero(np.diff(x) == 0)
    assert x[jump] == 0.03
    # at the clamp everything that the satellite passes on arrives
    assert diagram.shear_force[-1] == pytest.approx(LOAD["force"][:2], rel=1e-12)
    assert diagram.deflection[-1] == pytest.approx([0, 0], abs=1e-20)
    step = diagram.shear_force[jump + 1] - diagram.shear_force[jump]
    assert step == pytest.approx([-b for b in result.reaction_B], rel=1e-12)
    for place, at in ((0, result.deflection_C), (jump, result.deflection_B)):
        assert diagram.deflection[place] == pytest.approx([at.x, at.y], rel=1e-12)
    # dM/dx = Q, and E*I*w'' = M away from steps
    dx = np.diff(x)
    smooth = dx > 1e-6
    slope = np.diff(diagram.bending_moment, axis=0)[smooth] / dx[smooth, None]
    assert slope == pytest.approx(diagram.shear_force[:-1][smooth], rel=1e-6)
    inside = (x > 0.041) & (x < 0.059)
    h = x[inside][1] - x[inside][0]
    curvature = np.diff(diagram.deflection[inside], 2, axis=0) / h**2
    rigidity = 210e9 * math.pi * 0.014**4 / 64
    assert rigidity * curvature == pytest.approx(diagram.bending_moment[inside][1:-1], rel=1e-3)


@pytest.mark.parametrize(
    ("parameter", "changes"),
    [
        ("bearing_distance", {"bearing_distance": 0.0}),
        ("overhang", {"overhang": 0.0}),
        ("youngs_modulus", {"youngs_modulus": 0.0}),
        ("shaft_diameter", {"shaft_diameter": 0.0}),
        ("shaft_diameter", {"shaft_diameter": None}),
        ("shaft_sections", {"shaft_sections": STEPPED}),
        ("shaft_sections", {"shaft_sections": STEPPED[:2], "shaft_diameter": None}),
        ("shaft_sections", {"shaft_sections": [], "shaft_diameter": None}),
        (
            "shaft_sections[1].diameter",
            {"shaft_sections": [STEPPED[0], ShaftSection(0.06, 0.0)], "shaft_diameter": None},
        ),
        (
            "shaft_sections[0].length",
            {"shaft_sections": [ShaftSection(-0.01, 0.1)], "shaft_diameter": None},
        ),
    ],
)
def test_refusals(parameter: str, changes: dict[str, Any]) -> None:
    with pytest.raises(InvalidInput) as caught:
        shaft_deflection(**LOAD, **SHAFT | {"shaft_diameter": 0.02} | changes)
    assert caught.value.parameter == parameter


def test_notices() -> None:
    def codes(diameter: float) -> list[str]:
        result = shaft_deflection(**LOAD, **SHAFT, shaft_diameter=diameter)
        return [notice.code for notice in result.notices]

    assert codes(0.02) == []
    assert codes(0.03) == ["short_shaft"]
    assert codes(0.002) == ["large_deflection"]
