"""Invariants, refusals and notices of the shaft."""

import itertools
import math
import random
import statistics
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from core.errors import InvalidInput
from core.precession.shaft import ShaftSection, shaft_diagram
from core.precession.shaft_deflection import ShaftDeflection, shaft_deflection
from core.precision import CONVERGED, ROUNDING, SAME, SEARCHED
from tests.oracles.condition import meant
from tests.oracles.shaft import exact_deflection

LOAD: dict[str, Any] = {
    "force": (168.756146705, -337.606954169, 0.0),
    "moment": (-0.0316199045437, -0.0724918335263, 10.0),
}
SHAFT: dict[str, Any] = {"bearing_distance": 0.03, "overhang": 0.05, "youngs_modulus": 210e9}
STEPPED = [ShaftSection(0.02, 0.01), ShaftSection(0.04, 0.014), ShaftSection(0.02, 0.02)]


def plain(diameter: float) -> list[ShaftSection]:
    return [ShaftSection(SHAFT["bearing_distance"] + SHAFT["overhang"], diameter)]


def test_what_acts_along_the_shaft_bends_nothing_and_blurs_nothing() -> None:
    base = shaft_deflection(**LOAD, **SHAFT, shaft_sections=STEPPED)
    along = {"force": (*LOAD["force"][:2], 1e9), "moment": (*LOAD["moment"][:2], -1e9)}
    found = shaft_deflection(**along, **SHAFT, shaft_sections=STEPPED)
    assert (found.deflection_B, found.deflection_C) == (base.deflection_B, base.deflection_C)
    assert found.accuracy == base.accuracy


def test_the_smallest_diameter_everywhere_exaggerates() -> None:
    result = shaft_deflection(**LOAD, **SHAFT, shaft_sections=STEPPED)
    simplified = shaft_deflection(**LOAD, **SHAFT, shaft_sections=plain(0.01))
    assert result.simplified_deflection_B == simplified.deflection_B
    assert result.simplified_deflection_C == simplified.deflection_C
    assert result.simplification_error_C == pytest.approx(
        simplified.deflection_C.total / result.deflection_C.total - 1, rel=CONVERGED
    )
    assert result.simplification_error_B is not None
    assert result.simplification_error_B > 0


def numbers(result: ShaftDeflection) -> list[tuple[float, float]]:
    """All vectors of an answer."""
    places = [
        result.deflection_B,
        result.deflection_C,
        result.simplified_deflection_B,
        result.simplified_deflection_C,
    ]
    deflections = [(place.x, place.y) for place in places if place is not None]
    return [result.reaction_B, result.reaction_C, *deflections]


@pytest.mark.parametrize("errors", [(1e-6, 0.0), (0.0, 1e-8), (1e-5, 1e-8), (0.0, 1e-3)])
@pytest.mark.parametrize("moment", [(-0.03, -0.07), (3.0, 40.0)])
def test_the_error_of_the_load_is_passed_on(
    errors: tuple[float, float], moment: tuple[float, float]
) -> None:
    """The stated error covers the number that changes most."""
    load = {"force": (16.0, -33.0, 0.0), "moment": (*moment, 10.0)}
    plain = shaft_deflection(**load, **SHAFT, shaft_sections=STEPPED)
    stated = shaft_deflection(
        **load, **SHAFT, shaft_sections=STEPPED, force_error=errors[0], moment_error=errors[1]
    ).accuracy.relative_error
    worst = 0.0
    # of force and moment so turned that their changes add up at one place or another
    for turn, side in itertools.product(np.linspace(0, 2 * math.pi, 181), (1, -1)):
        cosine, sine = math.cos(turn), math.sin(turn)
        changed = shaft_deflection(
            force=(16.0 + errors[0] * cosine, -33.0 + errors[0] * sine, 0.0),
            moment=(moment[0] + side * errors[1] * sine, moment[1] - side * errors[1] * cosine, 10),
            **SHAFT,
            shaft_sections=STEPPED,
        )
        worst = max(
            worst,
            *(
                math.dist(one, other) / math.hypot(*one)
                for one, other in zip(numbers(plain), numbers(changed), strict=True)
            ),
        )
    assert stated - plain.accuracy.relative_error == pytest.approx(worst, rel=1e-4)


def overstatement(result: ShaftDeflection, true: dict[str, Any]) -> float:
    """Stated over measured error of what was meant by the numbers of a request."""
    a, b, modulus = true["a"], true["b"], true["modulus"]
    loads_b = [each / a for each in (true["moment"][1], -true["moment"][0])]
    loads_c = [each - load for each, load in zip(true["force"], loads_b, strict=True)]
    exact = [[-load for load in loads_b], [-load for load in loads_c]]
    plain = [(a + b, min(diameter for _, diameter in true["sections"]))]
    for sections in (true["sections"], plain)[: 1 + (result.simplified_deflection_B is not None)]:
        for place in (a, mpf(0)):
            exact.append(
                [
                    exact_deflection(sections, a, b, modulus, *loads, place)
                    for loads in zip(loads_b, loads_c, strict=True)
                ]
            )
    worst = max(
        mp.hypot(*(x - y for x, y in zip(found, wanted, strict=True))) / mp.hypot(*wanted)
        for found, wanted in zip(numbers(result), exact, strict=True)
    )
    return result.accuracy.relative_error / max(float(worst), ROUNDING / 4)


def random_shaft(r: random.Random, practical: bool) -> tuple[dict[str, Any], dict[str, Any]]:
    """A request in doubles, and what was meant by it."""
    spread = (-0.5, 0.5) if practical else (-4, 4)
    a, b = (meant(r, 0.05 * 10 ** r.uniform(*spread)) for _ in range(2))
    cuts = {a} if r.random() < 0.5 else set()
    for _ in range(0 if r.random() < 0.3 else r.randint(1, 5)):
        near = r.choice((mpf(0), a, a, a + b))
        size = float(a + b) * r.random() if practical else float(min(a, b)) * 10 ** r.uniform(-9, 0)
        cuts.add(near + r.choice((1, -1)) * meant(r, size))
    places = [mpf(0), *sorted(c for c in cuts if 0 < c < a + b), a + b]
    thick = (-2.3, -1.3) if practical else (-5, 0)
    sections = [
        (far - near, meant(r, 10 ** r.uniform(*thick))) for near, far in itertools.pairwise(places)
    ]
    true = {
        "a": a,
        "b": b,
        "modulus": meant(r, 10 ** r.uniform(9, 12)),
        "force": [meant(r, r.uniform(-1, 1) * 10 ** r.uniform(-3, 4)) for _ in range(2)],
        "moment": [meant(r, r.uniform(-1, 1) * 10 ** r.uniform(-6, 3)) for _ in range(2)],
        "sections": sections,
    }
    request = {
        "force": (*map(float, true["force"]), 0.0),
        "moment": (*map(float, true["moment"]), 5.0),
        "bearing_distance": float(a),
        "overhang": float(b),
        "youngs_modulus": float(true["modulus"]),
        "shaft_sections": [ShaftSection(*map(float, section)) for section in sections],
    }
    return request, true


@pytest.mark.parametrize("practical", [True, False])
def test_stated_errors_of_random_shafts(practical: bool) -> None:
    """Stated errors hold for all numbers of an answer, and do not exaggerate."""
    r = random.Random(practical)
    ratios = []
    for _ in range(200):
        request, true = random_shaft(r, practical)
        ratios.append(overstatement(shaft_deflection(**request), true))
    assert min(ratios) >= 1
    assert statistics.median(ratios) < 40


def test_an_overhang_far_shorter_than_the_bearing_distance_keeps_its_digits() -> None:
    """B's deflection hangs on the overhang alone, which places counted from C lose."""
    true = {
        "a": mpf("449.7"),
        "b": mpf("1.173354954874685e-08"),
        "modulus": mpf("21.3403"),
        "force": [mpf("2e12"), mpf("-3e12")],
        "moment": [mpf("5"), mpf("7")],
        "sections": [
            (mpf("390.5"), mpf("0.0043")),
            (mpf("59.20000001173354954874685"), mpf("0.04104196752757515")),
        ],
    }
    result = shaft_deflection(
        force=(2e12, -3e12, 0.0),
        moment=(5.0, 7.0, 3e11),
        bearing_distance=449.7,
        overhang=1.173354954874685e-08,
        youngs_modulus=21.3403,
        shaft_sections=[ShaftSection(*map(float, section)) for section in true["sections"]],
    )
    assert overstatement(result, true) >= 1
    assert result.accuracy.relative_error < 1e-14


def test_a_deflection_that_is_hardly_known_is_noticed() -> None:
    for error, codes in ((1.0, []), (10.0, ["hardly_known"])):
        result = shaft_deflection(**LOAD, **SHAFT, shaft_sections=plain(0.02), force_error=error)
        assert [notice.code for notice in result.notices] == codes


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
    assert diagram.shear_force[-1] == pytest.approx(LOAD["force"][:2], rel=SAME)
    assert diagram.deflection[-1] == pytest.approx([0, 0], abs=1e-20)
    step = diagram.shear_force[jump + 1] - diagram.shear_force[jump]
    assert step == pytest.approx([-b for b in result.reaction_B], rel=SAME)
    for place, at in ((0, result.deflection_C), (jump, result.deflection_B)):
        assert diagram.deflection[place] == pytest.approx([at.x, at.y], rel=SAME)
    # dM/dx = Q, and E*I*w'' = M away from steps
    dx = np.diff(x)
    smooth = dx > 1e-6
    slope = np.diff(diagram.bending_moment, axis=0)[smooth] / dx[smooth, None]
    assert slope == pytest.approx(diagram.shear_force[:-1][smooth], rel=SEARCHED)
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
        ("shaft_sections[0].diameter", {"shaft_sections": [ShaftSection(0.1, 0.0)]}),
        ("shaft_sections", {"shaft_sections": STEPPED[:2]}),
        ("shaft_sections", {"shaft_sections": []}),
        (
            "shaft_sections[1].diameter",
            {"shaft_sections": [STEPPED[0], ShaftSection(0.06, 0.0)]},
        ),
        (
            "shaft_sections[0].length",
            {"shaft_sections": [ShaftSection(-0.01, 0.1)]},
        ),
    ],
)
def test_refusals(parameter: str, changes: dict[str, Any]) -> None:
    with pytest.raises(InvalidInput) as caught:
        shaft_deflection(**LOAD, **SHAFT | {"shaft_sections": STEPPED} | changes)
    assert caught.value.parameter == parameter


def test_notices() -> None:
    def codes(diameter: float) -> list[str]:
        result = shaft_deflection(**LOAD, **SHAFT, shaft_sections=plain(diameter))
        return [notice.code for notice in result.notices]

    assert codes(0.02) == []
    assert codes(0.03) == ["short_shaft"]
    assert codes(0.002) == ["large_deflection"]
