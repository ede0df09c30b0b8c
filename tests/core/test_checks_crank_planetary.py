"""Checks of cranks, fit and walls by hand, at, below and above their limits."""

import math
from dataclasses import replace
from operator import attrgetter
from typing import Any

import pytest

from core.checks.crank_planetary import CRANK_CHECKS, crank_checks, crank_codes
from core.checks.walls import pins_apart
from core.design.real_forces import RealForces
from core.design.results import Results
from core.design.ring import CycloidRing, InvoluteRing
from core.design.sections import SeatedBearing
from core.errors import NotKnown
from core.output.contact_force import ContactForce
from core.output.room import Deviations
from core.precision import EXACT, SAME
from tests.inputs.checks import REF, WHOLE, check_of, having, says


@pytest.mark.parametrize("clearance", [-3e-5, -2e-11, -5e-12, 0.0, 5e-15, 5e-12, 3e-5])
def test_fit(clearance: float) -> None:
    design = having(REF, hole_radius=0.010 + clearance)
    # rounding of that size is none, nor what parts that just fit may press
    real = 0.0 if -1e-11 < clearance < 1e-14 else clearance
    fit = check_of("interference", design)
    assert fit.status == ("fail" if real < 0 else "pass")
    assert fit.value == pytest.approx(real, rel=1e-3) and fit.limit == 0
    assert fit.utilisation is None and fit.torque_reserve is None
    # 20 pm are taken elastically, 0.03 mm are not
    assert fit.reason == {-3e-5: "cannot_assemble", -2e-11: "pressed_without_load"}.get(real, "")
    assert fit.impossible == (fit.status == "fail")
    loose = check_of("clearance", design)
    assert loose.status == "pass"
    assert loose.value == pytest.approx(max(real, 0.0) / 0.002, rel=1e-3)
    found = check_of("contact_pressure_pin", design)
    assert found.status == "pass"
    assert isinstance(Results(design).judged_forces, RealForces if real > 0 else ContactForce)


@pytest.mark.parametrize("code", ["interference", "clearance"])
def test_no_fit_without_the_eccentricity(code: str) -> None:
    unknown = {"status": "not_checked", "value": None, "reason": "eccentricity_assumed"}
    found = check_of(code, having(REF, eccentricity=None))
    says(found, missing=("contact.eccentricity",), **unknown)
    assert check_of("contact_pressure_pin", having(REF, eccentricity=None)).status == "pass"


def test_no_fit_of_deviations_without_a_load() -> None:
    """The circle of the pins stands in the load."""
    made = Deviations(pin_tangential=(1e-4, -1e-4) * 3)
    for clearance in (0.0, 1e-5):
        design = having(REF, deviations=made, hole_radius=0.010 + clearance)
        still = having(design, load=None)
        missing = {"reason": "section_missing", "missing": ("load",)}
        says(check_of("interference", still), status="not_checked", value=None, **missing)
    assert check_of("interference", having(REF, deviations=made)).status == "fail"


WALLS: dict[str, tuple[dict[str, Any], str, float, bool]] = {
    # changes, check, width in m, whether the wall that is asked counts
    "holes": ({}, "wall_holes", 0.030, True),
    "eight holes": ({"pins": 8}, "wall_holes", 0.1 * math.sin(math.pi / 8) - 0.020, True),
    "pins": ({}, "pins_apart", 0.034, False),
    "axis": ({}, "holes_off_centre", 0.040, False),
    "root": ({"root_radius": 0.063}, "wall_rim", 0.003, True),
    "rim and root": ({"outer_radius": 0.065, "root_radius": 0.063}, "wall_rim", 0.003, True),
    "root and rim": ({"outer_radius": 0.063, "root_radius": 0.065}, "wall_rim", 0.003, True),
    "bore": ({"bore_radius": 0.035}, "wall_bore", 0.005, True),
}


@pytest.mark.parametrize("name", WALLS)
def test_walls(name: str) -> None:
    changes, code, width, asked = WALLS[name]
    design = having(REF, **changes)
    found = check_of(code, design)
    assert found.value == pytest.approx(width, rel=SAME)
    nobody = (
        {"status": "not_checked", "reason": "no_sourced_limit"} if asked else {"status": "pass"}
    )
    if "root_radius" in changes:  # 0.03 of the diameter that the roots sweep: a guide
        guide = 0.06 * (min(changes["root_radius"], changes.get("outer_radius", 1.0)) + 0.002)
        nobody = {"status": "marginal", "reason": "thin_wall", "warning": True}
        nobody |= {"limit": guide, "utilisation": guide / width}  # type: ignore[dict-item]
    says(found, **({"value": found.value, "limit": 0.0} | nobody))
    assert found.margin == pytest.approx(width - nobody.get("limit", 0.0))  # type: ignore[operator]
    for part in (0.99, 1.01):
        least = check_of(code, having(design, min_wall=width * part))
        says(
            least,
            status="fail" if asked and part > 1 else "pass",
            value=width,
            limit=width * part if asked else 0.0,
            utilisation=part if asked else None,
        )


def test_walls_that_are_not_there() -> None:
    for changes, code in (
        ({"hole_radius": 0.025}, "wall_holes"),  # they touch
        ({"pins": 16}, "wall_holes"),
        ({"pins": 24}, "pins_apart"),
        ({"pin_circle_radius": 0.010}, "holes_off_centre"),
        ({"outer_radius": 0.060}, "wall_rim"),
        ({"root_radius": 0.060}, "wall_rim"),
        ({"bore_radius": 0.041}, "wall_bore"),
    ):
        found = check_of(code, having(REF, **changes))  # type: ignore[arg-type]
        assert (found.status, found.impossible) == ("fail", True), code
        assert found.value is not None and found.value <= 0
    assert check_of("wall_rim", REF).missing == ("satellite_body.outer_radius",)
    assert check_of("wall_bore", REF).missing == ("satellite_body.bore_radius",)
    for code in ("wall_rim", "wall_bore"):
        unknown = check_of(code, REF)
        assert (unknown.status, unknown.reason, unknown.opens) == (
            "not_checked",
            "size_missing",
            True,
        )
    for code, status in (("wall_holes", "not_checked"), ("pins_apart", "pass")):
        one = check_of(code, having(REF, pins=1))
        says(one, status="not_applicable", value=None, reason="one_only")
        two = check_of(code, having(REF, pins=2))
        assert (two.status, two.opens) == (status, False)


def test_walls_are_as_thick_as_usual_where_nobody_asks() -> None:
    """0.03 of the diameter of the ring's pin circle, of the roots with the eccentricity, or 2.7
    modules below involute roots; as a demand the same numbers fail.
    """
    cycloid = CycloidRing(ring_pin_circle_radius=0.080, ring_pin_radius=0.004)
    involute = InvoluteRing(module=3e-3, teeth_difference=2, reference_pressure_angle=0.35)
    for code, changes, width, guide in (
        ("wall_holes", {"gear": cycloid}, 0.030, 0.0048),
        ("wall_holes", {"gear": cycloid, "hole_radius": 0.0228}, 0.0044, 0.0048),
        ("wall_holes", {"root_radius": 0.068}, 0.030, 0.0042),
        ("wall_bore", {"gear": cycloid, "bore_radius": 0.036}, 0.004, 0.0048),
        ("wall_rim", {"gear": cycloid}, 0.014, 0.0048),
        ("wall_rim", {"gear": involute, "ratio": 25.0}, 0.01125, 0.0081),
        ("wall_rim", {"gear": involute, "ratio": 22.0, "root_radius": 0.067}, 0.007, 0.0081),
    ):
        design = having(REF, **changes)  # type: ignore[arg-type]
        found, asked = check_of(code, design), check_of(code, having(design, min_wall=guide))
        thin = width < guide
        assert found.value == asked.value == pytest.approx(width, rel=EXACT)
        assert found.limit == pytest.approx(guide) and found.limit_source == "guide"
        for each in (found, asked):
            assert each.utilisation == pytest.approx(guide / width)
        assert (found.status, found.reason) == (("marginal", "thin_wall") if thin else ("pass", ""))
        assert asked.status == ("fail" if thin else "pass")
        assert found.torque_reserve is None


def test_a_sleeve_is_as_thick_as_usual() -> None:
    for diameter, status in ((0.014, "marginal"), (0.0145, "marginal"), (0.013, "pass")):
        design = having(WHOLE, pin=replace(WHOLE.pin, diameter=diameter))
        found = check_of("wall_sleeve", design)
        width = 0.008 - diameter / 2
        assert (found.status, found.value) == (status, pytest.approx(width, rel=EXACT))
        assert found.limit == pytest.approx(0.1 * diameter)
    says(
        check_of("wall_sleeve", WHOLE), status="not_applicable", value=None, reason="without_sleeve"
    )


def test_a_wall_to_teeth_of_which_only_the_tips_are_known() -> None:
    """R + r_out = 60 mm: holes beyond the tips cut the rim, those within them may cut the teeth."""
    tips = having(REF, outer_radius=0.065)
    assert check_of("wall_rim", having(tips, outer_radius=0.0599)).status == "fail"
    unknown = {"value": None, "reason": "roots_unknown", "missing": ("satellite_body.root_radius",)}
    guide = 0.06 * 0.067  # of what the tips sweep
    says(check_of("wall_rim", tips), status="not_checked", limit=guide, **unknown)
    thin = having(tips, min_wall=0.0051)
    says(check_of("wall_rim", thin), status="fail", value=0.005, limit=0.0051, utilisation=1.02)
    thick = having(tips, min_wall=0.0049)
    says(check_of("wall_rim", thick), status="not_checked", limit=0.0049, **unknown)
    # or as the ring leaves them: 42 teeth of 3 mm, 63 - 3.75 mm, and a cycloid disc's
    involute = InvoluteRing(module=3e-3, teeth_difference=2, reference_pressure_angle=0.35)
    for ratio, status in ((21.0, "not_checked"), (24.0, "pass"), (20.0, "fail")):
        found = check_of("wall_rim", having(tips, gear=involute, ratio=ratio, outer_radius=None))
        assert found.status == status
    pins = CycloidRing(ring_pin_circle_radius=0.070, ring_pin_radius=0.004)
    found = check_of("wall_rim", having(tips, gear=pins, min_wall=0.0041))
    assert (found.status, found.limit_source) == ("fail", "roots")
    assert found.value == pytest.approx(0.064 - 0.060, rel=SAME)


def test_a_wall_of_the_size_of_rounding_is_none() -> None:
    for width, status in ((2e-12, "pass"), (0.9e-12, "fail"), (-1e-3, "fail")):
        found = pins_apart.gap(width, size=1e-3)
        assert (found.status, found.impossible) == (status, status == "fail")
        assert found.value == (width if status == "pass" else min(width, 0.0))


def test_dead_centres() -> None:
    says(check_of("dead_centre", REF), status="pass", value=0.0, limit=0.0)
    stuck = having(REF, pins=2, satellites=1)
    found = check_of("dead_centre", stuck)
    says(found, status="fail", value=2.0, limit=0.0, impossible=True)
    # phases 0 and 180: sin(psi) and -sin(psi) are 0 together at psi = 0; phi = psi/(1 + 1/u)
    place = found.at["crank_angle"] * 1.05
    assert math.sin(place) == pytest.approx(0, abs=1e-9)
    assert 0 <= place < 2 * math.pi + 1e-9
    for code in ("contact_pressure_pin", "contact_shakedown_hole", "contact_yield_pin"):
        unknown = check_of(code, stuck)
        assert (unknown.status, unknown.reason, unknown.value) == (
            "not_checked",
            "dead_centre",
            None,
        )
    # the first dead centre, wherever it is
    turned = check_of("dead_centre", having(stuck, initial_crank_angle=1.0))
    assert math.sin(turned.at["crank_angle"] * 1.05 + 1.0) == pytest.approx(0, abs=1e-9)


def test_satellites_that_differ() -> None:
    says(
        check_of("assembly", REF),
        status="not_asked",
        value=None,
        missing=("mechanism.satellite_teeth",),
    )
    # u = 20: 180/20 degrees = 9 = one pitch of 40 teeth; of 29 teeth it is none
    for teeth, different in ((40, 0.0), (29, 1.0)):
        found = check_of("assembly", having(REF, satellite_teeth=teeth))
        status, reason = ("marginal", "different_parts") if different else ("pass", "")
        says(found, status=status, value=different, limit=0.0, warning=True, reason=reason)
    three = having(REF, satellites=3, satellite_teeth=29)
    assert check_of("assembly", three).value == 2.0


def test_what_is_checked_hangs_on_the_sections() -> None:
    mechanism = {"dead_centre", "assembly"}
    fit = {"interference", "clearance"}
    no_body = having(REF, satellite_body=None)
    no_load = having(REF, load=None)
    no_contact = having(REF, contact=None)
    every = {*crank_codes(WHOLE)}
    sections = ("pin", "friction", "gear", "bearing", "crankshaft", "satellite_body")
    of = {
        section: {code for code, kind in CRANK_CHECKS.items() if section in kind.needs}
        for section in sections
    }
    of["friction"] = {code for code, kind in CRANK_CHECKS.items() if "rubs" in kind.needs}
    bent = {"pin_static", "pin_deflection", "pin_slope", "pin_fatigue"}
    assert of["pin"] == bent | {
        "wall_sleeve",
        "pin_wall",
        "pin_roller_tilt",
        "bolt_opens",
        "bolt_slips",
    }
    for section, table in of.items():
        assert {*crank_codes(having(WHOLE, **{section: None}))} == every - table
    no_sections = every.difference(*of.values())
    assert {*crank_codes(REF)} == no_sections | of["satellite_body"]
    assert {*crank_codes(no_body)} == no_sections
    assert {*crank_codes(no_load)} == mechanism | fit
    assert {*crank_codes(no_contact)} == mechanism
    bare = having(no_contact, load=None, satellite_body=None)
    for result in (
        "contact_force",
        "hertz",
        "real_forces",
        "pin_strength",
        "losses.pins",
        "crank.bearings",
        "crank.shaft",
    ):
        with pytest.raises(NotKnown, match="section_missing"):
            attrgetter(result)(Results(no_load))
    assert {each.status for each in crank_checks(Results(bare)).parts} == {"open", "not_asked"}


def test_the_limit_of_a_check_is_known_without_its_value() -> None:
    """Designs that lack only the speed, or only the static rating, have the limit."""
    rated = having(
        WHOLE,
        input_speed=None,
        bearing=replace(WHOLE.bearing, static_rating=None, weibull_slope=10 / 9),
        crankshaft=replace(
            WHOLE.crankshaft, bearings=(SeatedBearing(kind="ball"), SeatedBearing(kind="ball"))
        ),
    )
    found = crank_checks(Results(rated))
    for code in ("bearing_life", "system_life", "crank_bearing_life"):
        assert found[code].status == "not_checked"
        assert found[code].limit == WHOLE.life, code
    assert (found["bearing_static"].status, found["bearing_static"].limit) == ("not_checked", 1.0)


def test_outer_sizes_are_checked_of_any_design_where_they_are_asked() -> None:
    mechanism = having(REF, contact=None, load=None, satellite_body=None)
    assert "outer_diameter" not in crank_codes(mechanism)
    codes = crank_codes(having(mechanism, max_outer_diameter=0.3))
    assert codes == (*crank_codes(mechanism), "outer_diameter")
    asked = crank_codes(having(WHOLE, max_outer_diameter=0.3))
    assert {*asked} == {*crank_codes(WHOLE)}
    assert asked.index("outer_diameter") < asked.index("contact_pressure_pin")
