"""Checks of cranks, fit and walls by hand, at, below and above their limits."""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.check import wall
from core.checks.crank_design import CrankDesign
from core.checks.crank_planetary import (
    CRANK,
    SATELLITE,
    SECTIONS,
    crank_checks,
    crank_tables,
)
from core.checks.real_forces import RealForces
from core.checks.sections import Ring
from core.errors import NotKnown
from core.output.contact_force import ContactForce
from core.output.real_mechanism import Deviations
from tests.inputs.checks import REF, WHOLE, says


@pytest.mark.parametrize("clearance", [-3e-5, -2e-11, -5e-12, 0.0, 5e-12, 2e-11, 3e-5])
def test_fit(clearance: float) -> None:
    design = replace(REF, hole_radius=0.010 + clearance)
    # rounding of a decimal of that size is none
    real = clearance if abs(clearance) > 1e-11 else 0.0
    fit = CRANK["interference"](design)
    assert fit.status == ("fail" if real < 0 else "pass")
    assert fit.value == pytest.approx(real, rel=1e-3) and fit.limit == 0
    assert fit.utilisation is None and fit.torque_reserve is None
    # 20 pm are taken elastically, 0.03 mm are not
    assert fit.reason == {-3e-5: "cannot_assemble", -2e-11: "pressed_without_load"}.get(real, "")
    assert fit.impossible == (fit.reason == "cannot_assemble")
    loose = CRANK["clearance"](design)
    assert loose.status == "pass"
    assert loose.value == pytest.approx(max(real, 0.0) / 0.002, rel=1e-3)
    found = CRANK["contact_pressure_pin"](design)
    assert found.status == "pass"
    assert isinstance(design.judged_forces, RealForces if real > 0 else ContactForce)


@pytest.mark.parametrize("code", ["interference", "clearance"])
def test_no_fit_without_the_eccentricity(code: str) -> None:
    unknown = {"status": "not_checked", "value": None, "reason": "eccentricity_assumed"}
    found = CRANK[code](replace(REF, eccentricity=None))
    says(found, missing=("eccentricity",), **unknown)
    assert CRANK["contact_pressure_pin"](replace(REF, eccentricity=None)).status == "pass"


def test_no_fit_of_deviations_without_a_load() -> None:
    """The circle of the pins stands in the load."""
    made = Deviations(pin_tangential=(1e-4, -1e-4) * 3)
    for clearance in (0.0, 1e-5):
        design = replace(REF, deviations=made, hole_radius=0.010 + clearance)
        still = replace(design, output_torque=None, pin_circle_radius=None)
        missing = {"reason": "section_missing", "missing": ("load",)}
        says(CRANK["interference"](still), status="not_checked", value=None, **missing)
    assert CRANK["interference"](replace(REF, deviations=made)).status == "fail"


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
    design = replace(REF, **changes)
    found = CRANK[code](design)
    assert found.value == pytest.approx(width, rel=1e-12)
    says(found, status="pass", value=found.value, limit=0.0, utilisation=0.0)
    assert found.margin == found.value
    for part in (0.99, 1.01):
        least = CRANK[code](replace(design, min_wall=width * part))
        says(
            least,
            status="fail" if asked and part > 1 else "pass",
            value=width,
            limit=width * part if asked else 0.0,
            utilisation=part if asked else 0.0,
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
        found = CRANK[code](replace(REF, **changes))  # type: ignore[arg-type]
        assert (found.status, found.impossible) == ("fail", True), code
        assert found.value is not None and found.value <= 0
    assert CRANK["wall_rim"](REF).missing == ("outer_radius",)
    assert CRANK["wall_bore"](REF).missing == ("bore_radius",)
    for code in ("wall_rim", "wall_bore"):
        assert CRANK[code](REF).status == "not_asked"
    for code in ("wall_holes", "pins_apart"):
        one = CRANK[code](replace(REF, pins=1))
        says(one, status="not_applicable", value=None, reason="one_only")
        assert CRANK[code](replace(REF, pins=2)).status == "pass"


def test_a_wall_to_teeth_of_which_only_the_tips_are_known() -> None:
    """R + r_out = 60 mm: holes beyond the tips cut the rim, those within them may cut the teeth."""
    tips = replace(REF, outer_radius=0.065)
    assert CRANK["wall_rim"](replace(tips, outer_radius=0.0599)).status == "fail"
    unknown = {"value": None, "reason": "roots_unknown", "missing": ("satellite_body.root_radius",)}
    says(CRANK["wall_rim"](tips), status="not_checked", limit=0.0, **unknown)
    thin = replace(tips, min_wall=0.0051)
    says(CRANK["wall_rim"](thin), status="fail", value=0.005, limit=0.0051, utilisation=1.02)
    thick = replace(tips, min_wall=0.0049)
    says(CRANK["wall_rim"](thick), status="not_checked", limit=0.0049, **unknown)
    # or as the ring leaves them: 42 teeth of 3 mm, 63 - 3.75 mm, and a cycloid disc's
    involute = Ring(kind="involute", module=3e-3, teeth_difference=2)
    for ratio, status in ((21.0, "not_checked"), (22.0, "pass"), (20.0, "fail")):
        found = CRANK["wall_rim"](replace(tips, gear=involute, ratio=ratio, outer_radius=None))
        assert found.status == status
    pins = Ring(kind="cycloid", ring_pin_circle_radius=0.070, ring_pin_radius=0.004)
    found = CRANK["wall_rim"](replace(tips, gear=pins, min_wall=0.0041))
    assert (found.status, found.limit_source) == ("fail", "roots")
    assert found.value == pytest.approx(0.064 - 0.060, rel=1e-12)


def test_a_wall_of_the_size_of_rounding_is_none() -> None:
    for width, status in ((2e-12, "pass"), (0.9e-12, "fail"), (-1e-3, "fail")):
        found = wall("wall_holes", width=width, size=1e-3)
        assert (found.status, found.impossible) == (status, status == "fail")
        assert found.value == (width if status == "pass" else min(width, 0.0))


def test_dead_centres() -> None:
    says(CRANK["dead_centre"](REF), status="pass", value=0.0, limit=0.0)
    stuck = replace(REF, pins=2, satellites=1)
    found = CRANK["dead_centre"](stuck)
    says(found, status="fail", value=2.0, limit=0.0, impossible=True)
    # phases 0 and 180: sin(psi) and -sin(psi) are 0 together at psi = 0; phi = psi/(1 + 1/u)
    place = found.at["crank_angle"] * 1.05
    assert math.sin(place) == pytest.approx(0, abs=1e-9)
    assert 0 <= place < 2 * math.pi + 1e-9
    for code in ("contact_pressure_pin", "contact_shakedown_hole", "contact_conformity"):
        unknown = CRANK[code](stuck)
        assert (unknown.status, unknown.reason, unknown.value) == (
            "not_checked",
            "dead_centre",
            None,
        )
    # the first dead centre, wherever it is
    turned = CRANK["dead_centre"](replace(stuck, initial_crank_angle=1.0))
    assert math.sin(turned.at["crank_angle"] * 1.05 + 1.0) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize(
    ("changes", "off"),
    [
        ({}, 0.0),
        ({"satellites": 3}, 0.0),
        ({"satellites": 1}, 1.0),
        ({"crank_spacing": math.pi / 2}, math.sqrt(0.5)),
        ({"satellites": 3, "crank_spacing": math.pi}, 1 / 3),
        ({"crank_angles": (0.0, math.pi + 1e-6)}, 5e-7),
        ({"crank_angles": (0.0, math.pi + 1e-9)}, 0.0),  # rounding
    ],
)
def test_balance_of_cranks(changes: dict[str, Any], off: float) -> None:
    found = CRANK["crank_balance"](replace(REF, **changes))
    assert found.value == pytest.approx(off, rel=1e-9)
    status, reason = ("marginal", "unbalanced") if off else ("pass", "")
    says(found, status=status, value=found.value, limit=0.0, warning=True, reason=reason)


def test_satellites_that_differ() -> None:
    says(CRANK["assembly"](REF), status="not_asked", value=None, missing=("satellite_teeth",))
    # u = 20: 180/20 degrees = 9 = one pitch of 40 teeth; of 29 teeth it is none
    for teeth, different in ((40, 0.0), (29, 1.0)):
        found = CRANK["assembly"](replace(REF, satellite_teeth=teeth))
        status, reason = ("marginal", "different_parts") if different else ("pass", "")
        says(found, status=status, value=different, limit=0.0, warning=True, reason=reason)
    three = replace(REF, satellites=3, satellite_teeth=29)
    assert CRANK["assembly"](three).value == 2.0


def test_what_is_checked_hangs_on_the_sections() -> None:
    mechanism = {"dead_centre", "crank_balance", "assembly"}
    fit = {"interference", "clearance"}
    no_body = replace(REF, has_body=False)
    no_load = replace(REF, output_torque=None)
    no_contact = replace(REF, pin_radius=None)
    assert {*crank_tables(WHOLE)} == {*CRANK}
    for section, table in SECTIONS.items():
        without = replace(WHOLE, **{section: None})  # type: ignore[arg-type]
        assert {*crank_tables(without)} == {*CRANK} - {*table}
        name = "satellite_body" if section == "has_body" else section
        assert crank_checks(replace(without, has_body=section != "has_body")).not_considered == (
            *(["satellite_body"] if section == "has_body" else []),
            "clearance",
            "contact_life_pin",
            "contact_life_hole",
            *([] if section == "has_body" else [name]),
        )
    no_sections = {*CRANK}.difference(*SECTIONS.values())
    assert {*crank_tables(REF)} == no_sections | {*SATELLITE}
    assert {*crank_tables(no_body)} == no_sections
    assert {*crank_tables(no_load)} == mechanism | fit
    assert {*crank_tables(no_contact)} == mechanism
    later = ("clearance", "pin", "fatigue", "friction", "gear", "bearing", "crankshaft")
    loaded = ("clearance", "contact_life_pin", "contact_life_hole", *later[1:])
    assert crank_checks(REF).not_considered == loaded
    assert crank_checks(no_body).not_considered == ("satellite_body", *loaded)
    assert crank_checks(no_load).not_considered == ("load", *later)
    bare = replace(no_contact, output_torque=None, has_body=False)
    for result in (
        "force",
        "contact",
        "real_forces",
        "pin_strength",
        "losses",
        "bearings",
        "shaft",
    ):
        with pytest.raises(NotKnown, match="section_missing"):
            getattr(no_load, result)
    assert not CrankDesign(pins=3, satellites=1, ratio=20.0).has_body
    assert crank_checks(bare).not_considered == ("load", "contact", "satellite_body", *later)
