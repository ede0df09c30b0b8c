"""Checks of swinging rollers by hand, at, below and above their limits."""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.check import Verdict
from core.checks.plain import RollerDesign, roller_checks
from core.errors import Notice
from core.fatigue import CycleFatigue, FatigueStrength
from core.precision import EXACT, SAME
from core.rollers.roller_strength import (
    ByPoissonsRatio,
    GivenGaps,
    roller_arguments,
    roller_fatigue,
    roller_strength,
)
from tests.inputs.checks import says, with_requirements

DESIGN: dict[str, Any] = {
    "output_torque": 210.0,
    "hole_circle_radius": 0.03,
    "rollers": 4,
    "sphere_diameter": 0.015,
    "cylinder_length": 0.02,
    "sphere_width": 0.008,
    "position_tolerance": 2e-6,
    "diameter": 0.01,
    "friction_coefficient": 0.16,
    "youngs_modulus": 210e9,
    "poissons_ratio": 0.3,
    "stress_concentration": 2.0,
}


def rollers(count: int = 4, **changes: Any) -> Verdict:
    """Checks of the rollers of the 2019 paper's fig. 6, d = 10 mm."""
    design = DESIGN | {"rollers": count}
    if "position_tolerance" in changes:
        design["position_tolerance"] = changes.pop("position_tolerance")
    design = roller_arguments(**design)
    result = roller_strength(**design)
    names = ("output_torque", "hole_circle_radius", "rollers", "sphere_diameter")
    names += ("cylinder_length", "sphere_width", "spacing")
    sizes = {name: design[name] for name in names}
    return roller_checks(RollerDesign(result=result, **sizes, **with_requirements(changes)))


def test_rollers_that_do_not_carry_have_no_share_in_the_reserve() -> None:
    """Two alike carry, one is far behind: the stress is proportional to the torque."""
    sizes: dict[str, Any] = {
        "output_torque": 210.0,
        "hole_circle_radius": 0.03,
        "rollers": 3,
        "sphere_diameter": 0.015,
        "cylinder_length": 0.02,
        "sphere_width": 0.008,
        "spacing": GivenGaps((1e-3, 3e-4, 3e-4)),
    }
    more = {"diameter": 0.01, "friction_coefficient": 0.16, "youngs_modulus": 210e9}
    result = roller_strength(**sizes, **more, shear=ByPoissonsRatio(0.3))
    assert result.loaded_rollers == 2
    stress = float(result.bending_stress)
    design = RollerDesign(result=result, **sizes, yield_strength=1.8 * stress)
    found = roller_checks(design)["roller_stress"]
    assert found.torque_reserve == pytest.approx(1.2, rel=SAME)
    # a stress known to 0.1 %: within four times that of its limit it is marginal
    doubtful = replace(result, accuracy=result.accuracy._replace(relative_error=1e-3))
    for part, status in ((0.9965, "marginal"), (0.9955, "fail")):
        near = replace(design, result=doubtful, yield_strength=1.5 * part * stress)
        assert roller_checks(near)["roller_stress"].status == status


STRESS = 0.0024213655009 * 210e9  # sigma/E of fig. 6 at l/d = 2, chi/d = 2e-4


def test_stress_of_rollers() -> None:
    unknown = rollers()["roller_stress"]
    assert (unknown.status, unknown.reason) == ("not_checked", "yield_unknown")
    assert unknown.missing == ("yield_strength",)
    assert unknown.value == pytest.approx(STRESS, rel=EXACT)
    for strength, safety, status in (
        (STRESS * 1.5 * 1.2, 1.5, "pass"),
        (STRESS * 1.5 * 1.01, 1.5, "marginal"),
        (STRESS * 1.5 * 0.99, 1.5, "fail"),
        (STRESS * 2.0 * 0.99, 2.0, "fail"),
    ):
        found = rollers(yield_strength=strength, bending_safety=safety)["roller_stress"]
        assert found.status == status
        assert found.value == pytest.approx(STRESS, rel=EXACT)
        assert found.limit == pytest.approx(strength / safety, rel=SAME)
        assert found.utilisation == pytest.approx(STRESS * safety / strength, rel=EXACT)
    # without errors of position the stress is proportional to the torque
    even = rollers(yield_strength=1e9, position_tolerance=0.0)["roller_stress"]
    assert even.torque_reserve == pytest.approx(even.limit / even.value, rel=SAME)  # type: ignore[operator]
    default = rollers(yield_strength=900e6)["roller_stress"]
    assert default.limit == pytest.approx(600e6)


def test_rollers_that_carry() -> None:
    says(
        rollers()["roller_sharing"],
        status="pass", value=4.0, limit=4.0, utilisation=1.0, warning=True,
    )  # fmt: skip
    says(
        rollers(position_tolerance=5e-5)["roller_sharing"],
        status="marginal", value=1.0, limit=4.0, utilisation=4.0, warning=True,
        reason="uneven",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("count", "status"), [(1, "not_applicable"), (2, "pass"), (12, "pass"), (13, "fail")]
)
def test_room_of_rollers(count: int, status: str) -> None:
    found = rollers(count)["roller_spacing"]
    assert (found.status, found.impossible) == (status, status == "fail")
    if count > 1:
        assert found.value == pytest.approx(0.06 * math.sin(math.pi / count) - 0.015, rel=SAME)
    else:
        assert found.reason == "one_only"
    assert rollers(count)["roller_room"].value == pytest.approx(0.0225, rel=SAME)


@pytest.mark.parametrize("eccentricity", [None, 0.002, 0.0064, 0.0065])
def test_length_of_rollers(eccentricity: float | None) -> None:
    found = rollers(eccentricity=eccentricity)["roller_tilt"]
    if eccentricity is None:
        says(found, status="not_asked", value=0.064, missing=("eccentricity",))
        return
    long = eccentricity <= 0.0064
    says(
        found,
        status="pass" if long else "marginal",
        value=0.064,
        limit=10 * eccentricity,
        utilisation=10 * eccentricity / 0.064,
        warning=True,
        reason="" if long else "tilted",
    )


def tired(result: Any, **more: Any) -> CycleFatigue:
    strength = FatigueStrength(endurance_limit=400e6, tensile_strength=1200e6)
    return roller_fatigue(bending_stress=result.bending_stress, strength=strength, **more)


def test_fatigue_of_rollers() -> None:
    """Shigley, example 6-10: amplitude and mean of 8.38 kpsi, 3.66 by Gerber."""
    strength = FatigueStrength(33.9, 100.0, criterion="gerber")
    found = roller_fatigue(bending_stress=2 * 8.38, strength=strength)
    assert (found.amplitude, found.mean, found.min_stress) == (8.38, 8.38, 0.0)
    assert f"{found.safety_factor:.2f}" == "3.66"
    spun = roller_fatigue(bending_stress=2 * 8.38, strength=strength, rotates=True)
    assert (spun.amplitude, spun.mean) == (16.76, 0.0)
    assert spun.safety_factor == pytest.approx(33.9 / 16.76, rel=SAME)


def test_fatigue_of_rollers_is_judged_where_asked() -> None:
    assert "fatigue" in rollers().not_considered
    for code, missing in (
        ("endurance_unknown", ("tensile_strength",)),
        ("notch_unknown", ("fatigue.fatigue_notch_factor",)),
    ):
        verdict = rollers(fatigue=Notice(code))
        assert "fatigue" not in verdict.not_considered
        unknown = verdict["roller_fatigue"]
        assert (unknown.status, unknown.reason, unknown.missing) == ("not_checked", code, missing)
    cycle = tired(roller_strength(**roller_arguments(**DESIGN)))
    use = STRESS / 2 / 400e6 + STRESS / 2 / 1200e6
    for safety, status in ((0.9 / use, "pass"), (0.99 / use, "marginal"), (1.01 / use, "fail")):
        found = rollers(fatigue=cycle, fatigue_safety=safety)["roller_fatigue"]
        assert (found.status, found.limit) == (status, safety)
        assert found.value == pytest.approx(1 / use, rel=EXACT)
        # at the torque named the safety is the one that is asked
        torque = DESIGN["output_torque"] * found.torque_reserve
        at_limit = tired(roller_strength(**roller_arguments(**DESIGN | {"output_torque": torque})))
        assert at_limit.safety_factor == pytest.approx(safety, rel=SAME)
