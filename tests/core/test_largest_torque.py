"""The largest torque of a design as it is made: at that torque its first check is at its limit."""

from itertools import pairwise

import pytest

from core.checks import crank_planetary
from core.checks.check import Verdict
from core.checks.crank_planetary import crank_checks, crank_verdict
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


@pytest.mark.parametrize("times", [0.2, 60.0])
def test_at_the_largest_torque_the_first_check_is_at_its_limit(times: float) -> None:
    assert MADE.load.output_torque is not None
    design = having(MADE, output_torque=MADE.load.output_torque * times)
    rough = crank_checks(Results(design))
    found = crank_verdict(Results(design), every=True)
    assert rough.largest_torque_estimated and not found.largest_torque_estimated
    assert rough.torque_reserve is not None and found.torque_reserve is not None
    assert under(design, found.torque_reserve).torque_reserve == pytest.approx(1.0, abs=1e-4)
    # The estimate itself is well off.
    assert under(design, rough.torque_reserve).torque_reserve != pytest.approx(1.0, abs=1e-3)
    assert (
        min(
            each.torque_reserve for each in found.checks if each.torque_reserve and not each.warning
        )
        == found.torque_reserve
    )
    ranked = [each.torque_reserve for each in found.checks if each.status == "fail"]
    assert all(one <= other for one, other in pairwise(each for each in ranked if each))
    borne = [each for each in found.checks if each.torque_reserve and not each.warning]
    assert len(borne) == 5 and not any(each.rough for each in borne)
    for check in borne:  # what is not said to be an estimate was looked at nearby
        there = under(design, check.reserve)[check.code].torque_reserve
        assert there == pytest.approx(1.0, abs=1e-3)


def test_a_reserve_that_was_not_looked_at_nearby_is_an_estimate() -> None:
    found = crank_verdict(Results(MADE))
    assert not found.largest_torque_estimated
    off = {
        check.code: abs(under(MADE, check.reserve)[check.code].reserve - 1)
        for check in found.checks
        if check.by_torque and not check.warning
    }
    assert len(off) == 5
    assert {code for code in off if found[code].rough} == {code for code in off if off[code] > 0.01}


@pytest.mark.parametrize(("stiffness", "torque"), [(1.26e6, 777.0), (3e5, 100.0)])
def test_no_reserve_is_far_beyond_the_torque_up_to_which_forces_can_be_solved(
    stiffness: float, torque: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    law = LinearLaw(stiffness)
    design = having(MADE, output_torque=torque, hole_radius=0.0102, contact_law=law)
    solved, unsolved = 3.0, 30.0
    while unsolved > 1.05 * solved:
        between = (solved * unsolved) ** 0.5
        if under(design, between)["pin_static"].by_torque:
            solved = between
        else:
            unsolved = between
    looked: list[float] = []
    look = crank_planetary.under

    def seen(*, design: Design, factor: float) -> Design:
        looked.append(factor)
        return look(design=design, factor=factor)

    monkeypatch.setattr(crank_planetary, "under", seen)
    found = crank_verdict(Results(design), every=True)
    with_others = len(looked)
    late = [each for each in found.checks if each.by_torque and each.reserve > solved]
    assert late and all(each.rough and each.reserve < 1.25 * unsolved for each in late)
    crank_verdict(Results(design))
    assert with_others - (len(looked) - with_others) <= crank_planetary.FURTHER


@pytest.mark.parametrize("torque", [280.0, 300.0, 320.0, 340.0])
def test_a_check_is_marginal_where_it_fails_under_a_tenth_more(torque: float) -> None:
    design = having(MADE, output_torque=torque)
    found, more = crank_verdict(Results(design)), under(design, 1.1)
    judged = [each for each in found.checks if each.rough or each.torque_reserve]
    assert len(judged) >= 5
    for check in judged:
        if check.status != "fail" and not check.warning:
            assert (check.status == "marginal") == (more[check.code].status == "fail")


def test_under_the_largest_torque_nothing_breaks() -> None:
    design = having(MADE, output_torque=3000.0)
    found = crank_verdict(Results(design))
    assert found.verdict == "fail" and found.torque_reserve is not None
    assert not under(design, 0.9999 * found.torque_reserve).counts["fail"]
    assert under(design, 1.0001 * found.torque_reserve).counts["fail"]


@pytest.mark.parametrize("times", [1e3, 1e5])
def test_an_overload_without_forces_fails_as_it_does_on_the_way(times: float) -> None:
    design = having(MADE, output_torque=300.0 * times)
    unknown = crank_checks(Results(design))
    assert unknown.verdict == "incomplete" and not unknown.counts["fail"]
    found = crank_verdict(Results(design))
    assert found.verdict == "fail" and found.governing == "pin_fatigue"
    assert found["pin_fatigue"].reason == unknown["pin_fatigue"].reason == "not_stable"
    assert found["pin_fatigue"].value is None
    assert found.torque_reserve is not None and not found.largest_torque_estimated
    assert under(design, found.torque_reserve).torque_reserve == pytest.approx(1.0, abs=1e-4)


def test_what_holds_up_to_where_forces_end_does_not_fail() -> None:
    soft = having(MADE, contact_law=LinearLaw(1e5), hole_radius=0.0102, output_torque=3000.0)
    found = crank_verdict(Results(soft))
    assert found["contact_pressure_pin"].reason == "not_stable"
    assert found.verdict == "incomplete" and not found.counts["fail"]


def test_ideal_forces_are_not_solved_again(monkeypatch: pytest.MonkeyPatch) -> None:
    ideal = Results(having(IDEAL, pin=None, fatigue=None, max_deflection=None))
    monkeypatch.setattr("core.checks.crank_planetary.under", None)
    found = crank_verdict(ideal)
    assert found.torque_reserve and found.checks == crank_checks(ideal).checks


def test_where_looking_ends_the_largest_torque_that_holds_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    design = having(MADE, output_torque=2400.0)
    monkeypatch.setattr("core.checks.crank_planetary.JUDGED", 0.0)
    found = crank_verdict(Results(design))
    assert found.largest_torque_estimated and found.torque_reserve is not None
    assert not under(design, found.torque_reserve * (1 - 1e-12)).counts["fail"]
    monkeypatch.setattr("core.checks.crank_planetary.LOOKS", 0)  # none was seen that holds
    found = crank_verdict(Results(design))
    assert found.torque_reserve is None and not found.largest_torque_known


@pytest.mark.parametrize(
    ("change", "looks"), [({"hole_radius": 0.0095}, 0), ({"pin_circle_radius": 0.013}, 1)]
)
def test_no_torque_is_sought_where_less_of_it_cures_nothing(
    change: dict[str, float], looks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    design = having(MADE, output_torque=3000.0, contact_law=None, **change)
    assert crank_checks(Results(design)).impossible
    seen: list[float] = []

    def looked(*, design: Design, factor: float) -> Design:
        seen.append(factor)
        return having(design, output_torque=3000.0 * factor)

    monkeypatch.setattr("core.checks.crank_planetary.under", looked)
    found = crank_verdict(Results(design))
    assert found.verdict == "fail" and not found.largest_torque_known
    assert len(seen) == looks
