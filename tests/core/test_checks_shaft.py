"""Checks of the precessional gear and its shaft by hand, at, below and above their limits."""

import math
from types import SimpleNamespace
from typing import Any

import pytest

from core.checks.check import Verdict
from core.checks.plain import LINE_MATERIALS, ShaftDesign, shaft_checks
from core.errors import Notice
from core.fatigue import FatigueStrength, judge_cycle
from core.precision import EXACT, SAME
from tests.inputs.checks import says, with_requirements


def shaft(
    positions: tuple[float, ...] = (0.0, 0.5, 2.0),
    deflections: tuple[float, float] = (1e-5, 2e-5),
    slopes: tuple[float, float] = (2e-4, 1e-4),
    **changes: Any,
) -> Verdict:
    """Checks of a shaft with these deflections and slopes at B and C."""
    totals = [SimpleNamespace(total=each) for each in (*deflections, *slopes)]
    names = ("deflection_B", "deflection_C", "slope_B", "slope_C")
    accuracy = SimpleNamespace(relative_error=changes.pop("error", 1e-12))
    result: Any = SimpleNamespace(**dict(zip(names, totals, strict=True)), accuracy=accuracy)
    sizes = {"roller_circle_radius": 0.05, "roller_radius": 0.004, "diameters": [0.02, 0.03]}
    asked = with_requirements(sizes | changes)
    return shaft_checks(ShaftDesign(result=result, positions=positions, **asked))


@pytest.mark.parametrize(
    ("positions", "apart"),
    [
        ((0.0, 0.5, 2.0), 0.5),
        ((2.0, 0.0, 0.5), 0.5),
        ((0.1, 6.2), 0.1 - 6.2 + 2 * math.pi),
        ((0.1, 0.1 + math.pi), math.pi),
        ((1.0, 1.0, 2.5), 1.5),  # the same one twice
        ((1.0, 1.0 + 2 * math.pi, 2.5), 1.5),
        ((1.0, 1.0 + 1e-10, 2.5), 1.5),
        ((-0.1, 0.1), 0.2),
        ((0.1, 3.0, 6.2), 0.1 - 6.2 + 2 * math.pi),
    ],
)
def test_space_between_rollers_of_a_wheel(positions: tuple[float, ...], apart: float) -> None:
    found = shaft(positions)["line_spacing"]
    assert found.value == pytest.approx(0.1 * math.sin(apart / 2) - 0.008, rel=EXACT)
    assert found.status == "pass"


def test_room_of_a_wheel_and_its_shaft() -> None:
    for positions in ((1.0,), (1.0, 1.0), (1.0, 1.0 + 2 * math.pi)):
        alone = shaft(positions)["line_spacing"]
        assert (alone.status, alone.reason) == ("not_applicable", "one_only")
    assert shaft((0.0, 0.16))["line_spacing"].impossible  # 8 mm apart, and that wide
    room = shaft()["shaft_in_circle"]
    assert room.value == pytest.approx(0.05 - 0.004 - 0.015, rel=SAME)
    tight = shaft(diameters=[0.01, 0.092])["shaft_in_circle"]
    assert (tight.status, tight.impossible) == ("fail", True)


@pytest.mark.parametrize("which", ["deflection", "slope"])
@pytest.mark.parametrize(
    ("limit", "status"),
    [(None, "not_asked"), (3e-5, "pass"), (2.1e-5, "marginal"), (1.9e-5, "fail")],
)
@pytest.mark.parametrize("order", [1, -1])
def test_bending_of_a_shaft(which: str, limit: float | None, status: str, order: int) -> None:
    found = shaft(**{f"{which}s": (1e-5, 2e-5)[::order], f"max_{which}": limit})
    check = found[f"shaft_{which}"]
    other = {"deflection": "slope", "slope": "deflection"}[which]
    considered = ("line_pressure", "shaft_strength", "bearing", "friction")
    if limit is None:
        missing = (f"requirements.max_{which}",)
        says(check, status="not_asked", value=2e-5, reason="no_limit", missing=missing)
        assert found.not_considered == ("deflection", "slope", *considered)
        assert found.verdict == "incomplete"
        return
    says(
        check,
        status=status,
        value=2e-5,
        limit=limit,
        utilisation=2e-5 / limit,
        torque_reserve=limit / 2e-5,
    )
    assert found.not_considered == (other, *considered)
    assert found.verdict == status
    assert found.torque_reserve == check.torque_reserve


def test_a_deflection_that_is_hardly_known_and_one_that_is_none() -> None:
    for limit, status in ((1.9931e-5, "marginal"), (1.9911e-5, "fail")):  # off by 0.35, 0.45 %
        assert shaft(error=1e-3, max_deflection=limit)["shaft_deflection"].status == status
    still = shaft(deflections=(0.0, 0.0), max_deflection=1e-5)["shaft_deflection"]
    says(still, status="pass", value=0.0, limit=1e-5, utilisation=0.0)


def bent(**changes: Any) -> Any:
    own = {"peak_stress": 100e6, "fatigue": None} | changes
    return SimpleNamespace(**own)


def test_strength_of_the_shaft_is_judged_where_asked() -> None:
    alone = shaft()
    assert {"shaft_strength", "line_pressure"} <= {*alone.not_considered}
    unknown = shaft(strength=bent())
    assert "fatigue" in unknown.not_considered and "shaft_strength" not in unknown.not_considered
    static = unknown["shaft_static"]
    assert (static.status, static.reason) == ("not_checked", "yield_unknown")
    for strength, status in ((180e6, "pass"), (151e6, "marginal"), (149e6, "fail")):
        static = shaft(strength=bent(), yield_strength=strength)["shaft_static"]
        assert (static.status, static.value, static.limit) == (status, 100e6, strength / 1.5)
        assert static.torque_reserve == pytest.approx(strength / 150e6)


def test_fatigue_of_the_shaft() -> None:
    for safety, status in ((1.8, "pass"), (1.51, "marginal"), (1.49, "fail")):
        endurance = FatigueStrength(100e6 * safety, 1e9)
        cycle = judge_cycle(strength=endurance, largest=100e6, least=-100e6)
        verdict = shaft(strength=bent(fatigue=cycle), fatigue_asked=True)
        found = verdict["shaft_fatigue"]
        assert (found.status, found.limit) == (status, 1.5)
        assert found.value == pytest.approx(safety) and "fatigue" not in verdict.not_considered
        assert found.torque_reserve == pytest.approx(safety / 1.5)
    steady = shaft(strength=bent(), fatigue_asked=True)["shaft_fatigue"]
    assert (steady.status, steady.reason) == ("not_applicable", "steady_load")
    unknown = {"fatigue_asked": True, "no_fatigue": Notice("notch_unknown")}
    found = shaft(strength=bent(), **unknown)["shaft_fatigue"]
    assert (found.status, found.reason) == ("not_checked", "notch_unknown")


def test_pressure_along_the_lines() -> None:
    accuracy = SimpleNamespace(relative_error=1e-14)
    contact: Any = SimpleNamespace(max_pressure=1000e6, accuracy=accuracy)
    roller, mating = LINE_MATERIALS
    for lower, status in ((1400e6, "pass"), (1210e6, "marginal"), (1190e6, "fail")):
        for limits in ({roller: lower, mating: 2000e6}, {roller: 2000e6, mating: lower}):
            verdict = shaft(contact=contact, pressure_limits=limits)
            found = verdict["line_pressure"]
            assert (found.status, found.limit) == (status, lower / 1.2)
            assert found.torque_reserve == pytest.approx((lower / 1200e6) ** 2)
            assert "line_pressure" not in verdict.not_considered
    for limits, missing in (
        ({roller: 1.3e9}, (mating,)), ({mating: 1.3e9}, (roller,)), ({}, (roller, mating))
    ):  # fmt: skip
        unknown = shaft(contact=contact, pressure_limits=limits)["line_pressure"]
        assert (unknown.status, unknown.reason) == ("not_checked", "limit_unknown")
        assert (unknown.value, unknown.missing) == (1000e6, missing)
    for limits in ({roller: 1.1e9}, {mating: 1.1e9}):  # too much for the one that is known
        assert shaft(contact=contact, pressure_limits=limits)["line_pressure"].status == "fail"
