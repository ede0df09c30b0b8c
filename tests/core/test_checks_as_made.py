"""Checks under the forces with clearance, deviations and elasticity.

Design A: 8 pins, one satellite, 0.02 mm of clearance, linear contacts. Its peak, 943.4911197529 N,
and its backlash, 7.431963784', were calculated with 40 digits by vectors and bisection.
"""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_checks
from core.checks.reserve import NEAR, crank_verdict
from core.design.document import Design
from core.design.real_forces import RealForces
from core.design.results import MOST_REAL_PAIRS, Results
from core.design.sections import DesignPin, Friction
from core.fixes.changes import vary
from core.fixes.fix import WHOLE
from core.hertz import ContactLimit
from core.output.contact_force import ContactForce
from core.output.elasticity import LinearLaw
from core.output.pin_strength import PinStrength
from core.output.room import Deviations
from core.precision import CONVERGED, EXACT, SAME
from tests.inputs.checks import HOLE, PIN, REF, check_of, design_of, fixes_of, having, says
from tests.oracles.checks import MODULUS

A = design_of(
    pins=8,
    satellites=1,
    ratio=18.0,
    output_torque=30.0,
    pin_circle_radius=0.02,
    contact_length=0.01,
    pin_radius=0.003,
    hole_radius=0.00452,
    eccentricity=0.0015,
    pin_material=PIN,
    hole_material=HOLE,
    contact_law=LinearLaw(stiffness=5e7),
)
PEAK, BACKLASH = 943.4911197529, math.radians(7.431963784 / 60)
PRESSURE = math.sqrt(PEAK / 0.01 * MODULUS / math.pi * (1 / 0.003 - 1 / 0.00452))
UNEVEN = Deviations(pin_radial=(1e-5, 0, 0, 0, -1e-5, 0, 0, 0), pin_radius=(2e-6, *[0.0] * 7))
ONE_SIDED = Deviations(pin_tangential=(-1e-5, *[0.0] * 7))


def limited(design: Design, limit: float) -> Design:
    """With another allowable pressure of the hole."""
    return having(design, hole_material=replace(HOLE, limit=ContactLimit("given", limit)))


def limited_alone(limit: float) -> Design:
    """Design as made that nothing but the given limit restricts."""
    hard = {"yield_strength": 1e12, "limit": ContactLimit("given", 1e12)}
    hole = replace(HOLE, yield_strength=1e12, limit=ContactLimit("given", limit))
    return having(A, pin_material=replace(PIN, **hard), hole_material=hole)


@pytest.mark.parametrize(("part", "status"), [(2.0, "pass"), (1.01, "marginal"), (0.999, "fail")])
def test_the_pressure_is_that_of_the_real_peak(part: float, status: str) -> None:
    found = check_of("contact_pressure_hole", limited(A, 1.2 * part * PRESSURE))
    assert found.value == pytest.approx(PRESSURE, rel=SAME)
    assert (found.status, found.limit) == (status, pytest.approx(part * PRESSURE))
    assert {*found.at} == {"satellite", "pin", "crank_angle"}
    ideal = having(A, hole_radius=0.0045, contact_law=None)
    assert check_of("contact_pressure_hole", ideal).value < 0.9 * PRESSURE  # type: ignore[operator]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("design", "limit"),
    [
        (A, 400e6),
        (A, 2400e6),
        (having(A, torque_direction="reverse"), 400e6),
        (having(A, deviations=UNEVEN), 2400e6),
        (having(A, deviations=ONE_SIDED, torque_direction="alternating"), 2400e6),
        (having(A, contact_law=None, application_factor=1.25), 400e6),
        (having(A, hole_radius=0.0045, contact_law=LinearLaw(stiffness=5e7)), 400e6),
    ],
    ids=["less", "more", "reverse", "errors", "alternating", "dynamic", "no clearance"],
)
def test_under_the_torque_of_the_reserve_the_pressure_is_at_its_limit(
    design: Design, limit: float
) -> None:
    design = limited(design, limit)
    found = crank_verdict(Results(design), largest=True)
    reserve = found.torque_reserve
    assert reserve is not None
    first = found["contact_pressure_hole"].torque_reserve == reserve
    assert first or limit > 400e6
    code = "contact_pressure_hole" if first else found.governing
    used = [
        check_of(code, having(design, output_torque=design.load.output_torque * each)).utilisation
        for each in (reserve, NEAR * reserve)
    ]
    assert used[0] <= 1 < used[1]


def test_static_strength_of_pins_is_that_under_the_forces_of_the_peak_torque() -> None:
    """With clearance these are not in the ratio of the torques: more pairs carry."""
    pin = DesignPin("cantilever", 0.006, (0.01,), replace(PIN, yield_strength=800e6))
    design = having(A, pin=pin, peak_torque=90.0)
    found = check_of("pin_static", design).value
    there = check_of("pin_static", having(design, output_torque=90.0)).value
    plain = check_of("pin_static", having(design, peak_torque=None)).value
    assert found is not None and there is not None and plain is not None
    assert found == pytest.approx(there, rel=SAME)
    assert found < 0.95 * 3 * plain
    strength = Results(design).pin_strength
    assert isinstance(strength, PinStrength)
    assert strength.static_safety_factor == pytest.approx(800e6 / found, rel=CONVERGED)


def test_the_reserve_is_not_the_square_of_the_pressures() -> None:
    """With more torque more pairs carry."""
    found = crank_verdict(Results(limited_alone(3.0 * 1.2 * PRESSURE)), largest=True)
    assert found.torque_reserve is not None and found.torque_reserve > 9.2


def test_the_largest_torque_ends_where_forces_cannot_be_solved() -> None:
    """No contact reaches the limit, so nothing is known to fail and no torque is stated."""
    design, held = limited_alone(1e12), 30.0
    found = crank_verdict(Results(design), largest=True)
    assert found.torque_reserve is None and not found.largest_torque_known

    def opens(torque: float) -> bool:
        made = crank_checks(Results(having(design, output_torque=torque)))
        assert not made.counts["fail"]
        return any(each.opens for each in made.checks)

    while not opens(1.05 * held):
        held *= 1.05
    near = having(design, output_torque=held)  # a tenth more is not known to hold
    judged = crank_verdict(Results(near))
    assert judged["contact_pressure_hole"].status == "marginal"
    assert crank_verdict(Results(design))["contact_pressure_hole"].status == "pass"


def test_wear_and_pv_are_of_the_largest_force_of_both_directions() -> None:
    """The direction of the largest force need not be that of the larger losses."""
    worn = having(
        A,
        input_speed=100.0,
        friction=Friction(coefficient=0.08, sleeve=True, wear_rate=1e-17),
        max_wear=1.0,
        max_pv=1e12,
    )
    larger = []
    for made in (ONE_SIDED, Deviations(pin_tangential=(1e-5, *[0.0] * 7)), UNEVEN):
        design = having(worn, deviations=made)
        for code in ("wear", "pv"):
            one, other, both = (
                check_of(code, having(design, torque_direction=way)).value
                for way in ("driving", "reverse", "alternating")
            )
            assert one is not None and other is not None
            assert both == pytest.approx(max(one, other), rel=SAME)
            larger.append(one > other)
        losses = [
            Results(having(design, torque_direction=way)).losses.pins.mean_loss
            for way in ("driving", "reverse", "alternating")
        ]
        assert losses[2] == pytest.approx(max(losses), rel=SAME)
    assert len({*larger}) == 2


def test_of_both_directions_the_worse_is_judged() -> None:
    pressures = {
        way: check_of(
            "contact_pressure_hole", having(A, deviations=ONE_SIDED, torque_direction=way)
        ).value
        for way in ("driving", "reverse", "alternating")
    }
    one, other, both = pressures.values()
    assert one is not None and other is not None and abs(one / other - 1) > 0.01
    assert both == max(one, other)


def test_without_deviations_both_directions_are_alike() -> None:
    for design in (A, having(A, hole_radius=0.0045, contact_law=None)):
        one, other = (
            check_of("contact_pressure_hole", having(design, torque_direction=way))
            for way in ("driving", "reverse")
        )
        assert one.value == pytest.approx(other.value, rel=EXACT)


@pytest.mark.parametrize(("part", "status"), [(1.0001, "pass"), (0.9999, "fail")])
def test_backlash(part: float, status: str) -> None:
    limit = part * BACKLASH
    says(
        replaced(check_of("backlash", having(A, max_backlash=limit))),
        status=status, value=BACKLASH, limit=limit, utilisation=1 / part,
    )  # fmt: skip


def replaced(check: Check) -> Check:
    """With the backlash as it was printed, where it is that to all its digits."""
    assert check.value == pytest.approx(BACKLASH, rel=EXACT)
    assert check.utilisation is not None and check.limit is not None
    return check._replace(value=BACKLASH, utilisation=BACKLASH / check.limit)


def test_lost_motion_is_backlash_and_what_gives() -> None:
    lost = check_of("lost_motion", A).value
    assert lost is not None
    # 0.9 N*m on 5e7 N/m at 20 mm, of one pair at least, of four at most
    assert 2 * 0.9 / (4 * 5e7 * 4e-4) < lost - BACKLASH < 2 * 0.9 / (5e7 * 4e-4) * 1.1
    for part, status in ((1.001, "pass"), (0.999, "fail")):
        check = check_of("lost_motion", having(A, max_lost_motion=part * lost))
        assert (check.status, check.utilisation) == (status, pytest.approx(1 / part))
    # it is that at the torque itself, not at the dynamic one
    dynamic = having(A, application_factor=1.5)
    assert check_of("lost_motion", dynamic).value is None
    asked = check_of("lost_motion", having(dynamic, max_lost_motion=1.0))
    assert asked.value == pytest.approx(lost, rel=SAME)


def test_play_that_nobody_asks_for() -> None:
    for code in ("backlash", "lost_motion"):
        found = check_of(code, A)
        assert (found.status, found.reason) == ("not_asked", "no_limit")
        assert found.missing == (f"requirements.max_{code}",) and found.value is not None
        assert check_of(code, having(A, eccentricity=None)).status == "not_asked"
        assert check_of(code, REF).value == (0.0 if code == "backlash" else None)


def test_play_without_clearance() -> None:
    asked = having(REF, max_backlash=1e-6, max_lost_motion=1e-3)
    says(check_of("backlash", asked), status="pass", value=0.0, limit=1e-6, utilisation=0.0)
    lost = check_of("lost_motion", asked)
    assert lost.status == "pass" and lost.value is not None and 0 < lost.value < 1e-4
    tight = having(asked, hole_radius=0.00999)
    assert check_of("backlash", tight).value == 0.0
    for code, limit in (("backlash", 1e-6), ("lost_motion", 1e-3)):
        unknown = check_of(code, having(asked, eccentricity=None))
        says(
            unknown, status="not_checked", value=None, limit=limit, reason="eccentricity_assumed",
            missing=("contact.eccentricity",),
        )  # fmt: skip


UNSOLVED: dict[str, tuple[dict[str, Any], str]] = {
    "too many pairs": ({"pins": MOST_REAL_PAIRS + 1, "pin_circle_radius": 0.5}, "too_many_pairs"),
    "too soft": ({"contact_law": LinearLaw(stiffness=1e3)}, "not_stable"),
    "too wide": ({"contact_law": None, "output_torque": 1e5}, "beyond_hertz"),
    "holes around the centre": ({"eccentricity": 0.021, "hole_radius": 0.0245}, "smaller_than"),
}


@pytest.mark.parametrize("name", UNSOLVED)
def test_where_the_forces_are_not_known_nothing_passes(name: str) -> None:
    changes, reason = UNSOLVED[name]
    design = having(A, **changes, max_backlash=1.0, max_lost_motion=1.0)
    found = crank_checks(Results(design))
    for code in ("contact_pressure_pin", "contact_yield_hole", "backlash"):
        check = found[code]
        assert (check.status, check.value) == ("not_checked", None), code
        assert check.reason in (reason, "cannot_be"), code
        assert check.torque_reserve is None
    assert found["lost_motion"].status == "not_checked"
    assert found["clearance"].status in ("pass", "marginal")  # which is geometry
    assert found.verdict in ("incomplete", "fail") and found.torque_reserve is None
    contact = found.parts[0]
    assert (contact.code, contact.status) == ("contact", "open") or contact.status == "fail"


def test_deviations_that_press_are_interference() -> None:
    large = Deviations(pin_radial=(2.2e-5, 0, 0, 0, 2.2e-5, 0, 0, 0))
    found = crank_checks(Results(having(A, deviations=large)))
    fit = found["interference"]
    assert (fit.status, fit.reason, fit.impossible) == ("fail", "pressed_without_load", True)
    assert found.verdict == "fail"
    assert check_of("interference", having(A, deviations=UNEVEN)).status == "pass"
    worse = having(A, deviations=replace(large, pin_radial=(1e-3, *[0.0] * 7)))
    jams = check_of("interference", worse)
    assert (jams.status, jams.reason, jams.impossible) == ("fail", "jams", True)
    assert jams.value == pytest.approx(worse.clearance - 1e-3, rel=SAME)
    assert check_of("contact_pressure_hole", worse).reason == "cannot_assemble"


def test_which_forces_are_judged() -> None:
    ideal = having(A, hole_radius=0.0045, contact_law=None)
    for design, kind in (
        (ideal, ContactForce),
        (having(ideal, hole_radius=0.0045 + 4e-15), ContactForce),  # rounding
        (having(ideal, hole_radius=0.0044), ContactForce),  # fails as interference
        (having(ideal, eccentricity=None), ContactForce),
        (having(ideal, hole_radius=0.0045 + 1e-11), RealForces),
        (having(ideal, contact_law=A.contact_law), RealForces),
        (having(ideal, deviations=Deviations()), RealForces),
    ):
        assert isinstance(Results(design).judged_forces, kind)


def test_fixes_cure() -> None:
    design = limited(A, PRESSURE)
    design = having(design, max_backlash=0.5 * BACKLASH, max_lost_motion=0.6 * BACKLASH)
    fixes = fixes_of(design, ["contact_pressure_hole", "backlash", "lost_motion"])
    assert {(each.code, each.variable) for each in fixes} == {
        ("backlash", "contact.hole_radius"),
        ("lost_motion", "contact.hole_radius"),
        *(
            ("contact_pressure_hole", name)
            for name in (
                "contact.contact_length",
                "contact.pin_radius",
                "load.pin_circle_radius",
                "load.output_torque",
                "mechanism.satellites",
            )
        ),
    }
    for fix in fixes:
        assert fix.status == "solved"
        there = vary(design=design, variable=fix.variable, value=fix.after)
        cured = crank_verdict(Results(there))
        assert cured[fix.code].status == "pass" and cured.verdict == fix.verdict, fix
        if fix.variable in WHOLE:
            continue
        step = 1.1e-7 if fix.variable == "contact.hole_radius" else (fix.before - fix.exact) * 1e-3
        short = fix.exact + step  # of the hole a tenth of a micrometre, as it is rounded
        there = vary(design=design, variable=fix.variable, value=short)
        assert crank_verdict(Results(there))[fix.code].status != "pass", fix


def test_a_larger_pin_without_sleeve_is_stiffer() -> None:
    bent = having(A, pin=DesignPin("cantilever", 0.006, (0.01,), PIN))
    assert vary(design=bent, variable="contact.pin_radius", value=0.004).pin.diameter == 0.008  # type: ignore[union-attr]
    sleeve = having(bent, pin=DesignPin("cantilever", 0.004, (0.01,), PIN))
    assert vary(design=sleeve, variable="contact.pin_radius", value=0.004).pin == sleeve.pin
