"""The largest torque of a design as it is made: it holds, and a hundredth above a check fails."""

from dataclasses import replace

import pytest

from core.checks import reserve
from core.checks.check import MARGIN, Verdict
from core.checks.crank_planetary import crank_checks
from core.checks.reserve import NEAR, crank_verdict
from core.design.document import Design
from core.design.results import Results
from core.design.sections import DesignPin, FatigueBasis
from core.material_table import MATERIALS
from core.output.elasticity import LinearLaw
from core.output.room import Deviations
from tests.inputs.checks import design_of, having

PIN = DesignPin(
    "cantilever",
    0.016,
    (0.015,),
    MATERIALS["steel_bearing"].material,
    tensile_strength=1.9e9,
    steel=True,
)
IDEAL = design_of(
    pins=4, satellites=1, ratio=20.0, output_torque=300.0, pin_circle_radius=0.05,
    contact_length=0.02, pin_radius=0.008, hole_radius=0.010, eccentricity=0.002,
    pin_material=MATERIALS["steel_bearing"].material,
    hole_material=MATERIALS["steel_bearing"].material,
    pin=PIN, fatigue=FatigueBasis(surface="ground", fatigue_notch_factor=1.5), max_deflection=3e-5,
)  # fmt: skip
MADE = having(
    IDEAL,
    hole_radius=0.01002,
    contact_law=LinearLaw(3e7),
    deviations=Deviations(pin_radial=(8e-6, 0.0, -5e-6, 0.0)),
)


def under(design: Design, factor: float) -> Verdict:
    assert design.load.output_torque is not None
    return crank_checks(Results(having(design, output_torque=design.load.output_torque * factor)))


def fails(design: Design, factor: float) -> set[str]:
    return {each.code for each in under(design, factor).checks if each.status == "fail"}


@pytest.mark.parametrize("times", [0.2, 1.0, 60.0])
def test_a_reserve_lies_between_a_torque_that_holds_and_one_that_fails(times: float) -> None:
    assert MADE.load.output_torque is not None
    design = having(MADE, output_torque=MADE.load.output_torque * times)
    found = crank_verdict(Results(design), largest=True)
    held = found.torque_reserve
    assert held is not None and found.largest_torque_known
    assert not fails(design, held)
    (first,) = (each for each in found.checks if each.by_torque and not each.solved)
    assert first.code in fails(design, NEAR * held) and first.torque_reserve == held
    assert found.governing == first.code


@pytest.fixture
def looked(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Factors on the torque at which designs are solved again."""
    seen, solved = list[float](), list[Results]()
    more = Results.under

    def look(results: Results, factor: float) -> Results:
        made = more(results, factor)
        if all(made is not each for each in solved):
            solved.append(made)
            seen.append(factor)
        return made

    monkeypatch.setattr(Results, "under", look)
    return seen


def test_without_the_largest_torque_one_more_is_solved(looked: list[float]) -> None:
    found = crank_verdict(Results(MADE))
    assert looked == [MARGIN]
    assert found.torque_reserve is None and not found.largest_torque_known
    asked = crank_verdict(Results(MADE), largest=True)
    assert [each.status for each in asked.checks] == [each.status for each in found.checks]
    assert len(looked) <= 2 + 6


def test_what_jumps_between_two_torques_has_no_reserve(monkeypatch: pytest.MonkeyPatch) -> None:
    """No torques closer together than these two are examined."""
    monkeypatch.setattr(reserve, "LOOKS", 3)
    found = crank_verdict(Results(having(MADE, output_torque=18000.0)), largest=True)
    assert found.verdict == "fail"
    assert found.torque_reserve is None and not found.largest_torque_known


@pytest.mark.parametrize(("stiffness", "torque"), [(1.26e6, 777.0), (3e5, 100.0)])
def test_beside_a_torque_at_which_forces_cannot_be_solved_there_is_no_reserve(
    stiffness: float, torque: float, looked: list[float]
) -> None:
    """Nothing fails there, and nothing is known to hold."""
    law = LinearLaw(stiffness)
    design = having(MADE, output_torque=torque, hole_radius=0.0102, contact_law=law)
    alone = having(design, pin=None, fatigue=None, max_deflection=None)
    strong = replace(MATERIALS["steel_bearing"].material, limit=None, yield_strength=1e12)
    held = having(alone, pin_material=strong, hole_material=strong, scope=("contact",))
    found = crank_verdict(Results(held), largest=True)
    assert found.torque_reserve is None and not found.largest_torque_known
    assert len(looked) <= reserve.LOOKS


@pytest.mark.parametrize("torque", [280.0, 300.0, 320.0, 340.0])
def test_a_check_is_marginal_where_it_fails_under_a_tenth_more(torque: float) -> None:
    design = having(MADE, output_torque=torque)
    found, more = crank_verdict(Results(design)), under(design, 1.1)
    judged = [each for each in found.checks if each.solved or each.torque_reserve]
    assert len(judged) >= 5
    for check in judged:
        if check.status != "fail" and not check.warning:
            assert (check.status == "marginal") == (more[check.code].status == "fail")


def test_an_overload_without_forces_fails_as_it_does_on_the_way() -> None:
    design = having(MADE, output_torque=300.0 * 1e5)
    unknown = crank_checks(Results(design))
    assert unknown.verdict == "incomplete" and not unknown.counts["fail"]
    found = crank_verdict(Results(design), largest=True)
    assert found.verdict == "fail" and found.governing == "pin_fatigue"
    assert found["pin_fatigue"].reason == unknown["pin_fatigue"].reason == "not_stable"
    assert found["pin_fatigue"].value is None
    assert found.torque_reserve is not None and not fails(design, found.torque_reserve)
    assert "pin_fatigue" in fails(design, NEAR * found.torque_reserve)


def test_what_holds_up_to_where_forces_end_does_not_fail() -> None:
    soft = having(MADE, contact_law=LinearLaw(1e5), hole_radius=0.0102, output_torque=3000.0)
    found = crank_verdict(Results(soft))
    assert found["contact_pressure_pin"].reason == "not_stable"
    assert found.verdict == "incomplete" and not found.counts["fail"]


def test_ideal_forces_are_not_solved_again(monkeypatch: pytest.MonkeyPatch) -> None:
    ideal = Results(having(IDEAL, pin=None, fatigue=None, max_deflection=None))
    monkeypatch.setattr(Results, "under", None)
    found = crank_verdict(ideal, largest=True)
    assert found.torque_reserve and found.checks == crank_checks(ideal).checks


@pytest.mark.parametrize("change", [{"hole_radius": 0.0095}, {"pin_circle_radius": 0.013}])
def test_no_torque_is_sought_where_less_of_it_cures_nothing(
    change: dict[str, float], looked: list[float]
) -> None:
    design = having(MADE, output_torque=3000.0, contact_law=None, **change)
    assert crank_checks(Results(design)).impossible
    found = crank_verdict(Results(design), largest=True)
    assert found.verdict == "fail" and not found.largest_torque_known
    assert not looked
