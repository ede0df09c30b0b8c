"""Each check by hand: value, limit, status and what else it says, at, below and above its limit."""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from core.checks.check import Check, Verdict, judged, verdict, wall
from core.checks.crank_design import CrankDesign
from core.checks.crank_planetary import CRANK, crank_checks, crank_tables
from core.checks.rollers import roller_checks
from core.checks.shaft import shaft_checks
from core.materials import ContactLimit, ElasticMaterial
from core.rollers.roller_strength import roller_strength

PIN = ElasticMaterial(210e9, 0.3, ContactLimit("given", 900e6), yield_strength=300e6)
HOLE = ElasticMaterial(210e9, 0.3, ContactLimit("given", 600e6), yield_strength=200e6)
REF = CrankDesign(
    pins=6,
    satellites=2,
    ratio=20.0,
    output_torque=500.0,
    pin_circle_radius=0.05,
    contact_length=0.02,
    pin_radius=0.008,
    hole_radius=0.010,
    eccentricity=0.002,
    pin_material=PIN,
    hole_material=HOLE,
    has_body=True,
)
# the peak is 4/(2*6) of 10 kN; E* = 210 GPa/(2*0.91); 1/r - 1/R = 25 per metre
LINE_LOAD, MODULUS = 1e4 / 3 / 0.02, 210e9 / 1.82
PRESSURE = math.sqrt(LINE_LOAD * MODULUS * 25 / math.pi)
RATIO = math.sqrt(4 * LINE_LOAD / (math.pi * MODULUS * 25)) / 0.008
SOFT = ElasticMaterial(3e9, 0.35, ContactLimit("given", 60e6), yield_strength=60e6)


def says(check: Check, **expected: Any) -> None:
    """What a check says; what is not named has its default."""
    plain = {"limit": None, "utilisation": None, "torque_reserve": None, "keep": "below"}
    plain |= {"impossible": False, "warning": False, "reason": "", "missing": ()}
    for name, value in (plain | expected).items():
        found = getattr(check, name)
        if isinstance(value, float) and value:
            assert found == pytest.approx(value, rel=1e-12), name
        else:
            assert found == value, name


def contact(limit: float, **more: Any) -> dict[str, Any]:
    """What a check of the reference's pressure says."""
    status = "pass" if limit > PRESSURE * math.sqrt(1.1) else "marginal"
    return {
        "status": status if limit > PRESSURE else "fail",
        "value": PRESSURE,
        "limit": limit,
        "utilisation": PRESSURE / limit,
        "torque_reserve": (limit / PRESSURE) ** 2,
        "margin": limit - PRESSURE,
    } | more


@pytest.mark.parametrize("safety", [0.5, 1.2, 1.5, 2.0])
def test_pressure(safety: float) -> None:
    design = replace(REF, pitting_safety=safety)
    for body, limit in (("pin", 900e6), ("hole", 600e6)):
        found = CRANK[f"contact_pressure_{body}"](design)
        says(found, **contact(limit / safety, criterion="given", verified="", limit_source=""))
        assert design.force is not None
        assert found.at == design.peak
        assert {*found.at} == {"satellite", "pin", "crank_angle"}


def test_pressure_says_where_its_limit_is_from() -> None:
    limit = ContactLimit("endurance", 600e6, "iso_281")
    found = CRANK["contact_pressure_hole"](replace(REF, hole_material=replace(HOLE, limit=limit)))
    assert (found.limit_source, found.criterion) == ("iso_281", "endurance")
    assert found.verified == limit.verified != ""


@pytest.mark.parametrize("own", [True, False])
def test_a_limit_that_is_not_known(own: bool) -> None:
    names = ("pin_material", "hole_material") if own else ()
    unknown = ElasticMaterial(210e9, 0.3)
    design = replace(REF, hole_material=unknown, own_limits=names)
    says(
        CRANK["contact_pressure_hole"](design),
        status="not_checked",
        value=PRESSURE,
        reason="limit_unknown",
        missing=("hole_material.allowable_pressure" if own else "hole_material",),
        at=design.peak,
    )
    for code in ("contact_shakedown_hole", "contact_yield_hole"):
        says(
            CRANK[code](design),
            status="not_asked" if own else "not_checked",
            value=None,
            reason="yield_unknown",
            missing=("hole_material.yield_strength" if own else "hole_material",),
        )
    assert CRANK["contact_pressure_hole"](replace(design, pins=2, satellites=1)).value is None
    tested = replace(REF, hole_material=replace(HOLE, yield_governs=False))
    for code in ("contact_shakedown_hole", "contact_yield_hole"):
        says(CRANK[code](tested), status="not_applicable", value=None, reason="tested_limit")


@pytest.mark.parametrize("factor", [0.5, 1.0, 2.0])
def test_shakedown_and_first_yield(factor: float) -> None:
    for body, strength in (("pin", 300e6), ("hole", 200e6)):
        bodies = {"pin": PIN, "hole": HOLE}
        material = replace(bodies[body], yield_strength=strength * factor)
        design = replace(REF, **{f"{body}_material": material})
        says(
            CRANK[f"contact_shakedown_{body}"](design),
            **contact(4 / math.sqrt(3) * strength * factor, at=design.peak),
        )
        first = contact(1.79 * strength * factor, warning=True)
        if first["status"] == "fail":
            first |= {"status": "marginal", "reason": "plastic_first"}
        elif first["status"] == "marginal":
            first |= {"status": "pass"}
        says(CRANK[f"contact_yield_{body}"](design), **first)


def test_width_of_the_contact() -> None:
    found = CRANK["contact_conformity"](REF)
    reserve = (0.159 / RATIO) ** 2
    expected = {"value": RATIO, "limit": 0.159, "utilisation": RATIO / 0.159, "warning": True}
    says(found, status="pass", torque_reserve=reserve, **expected)
    # too different for Persson, too wide for Hertz: a rough guide
    soft = replace(REF, pin_material=SOFT, output_torque=5e3)
    wide = CRANK["contact_conformity"](soft)
    assert (wide.status, wide.reason, wide.warning) == ("marginal", "rough_guide", True)
    assert wide.torque_reserve is not None and wide.torque_reserve < 1
    # Persson's holds
    tight = CRANK["contact_conformity"](replace(REF, hole_radius=0.00802, eccentricity=2e-5))
    assert (tight.status, tight.reason) == ("not_applicable", "conformal_solution")
    assert tight.limit == 0.159 and tight.value is not None and tight.value > 0.159
    # no theory holds
    none = replace(soft, output_torque=1e7)
    for code in ("contact_pressure_pin", "contact_shakedown_hole"):
        unknown = CRANK[code](none)
        assert (unknown.status, unknown.reason) == ("not_checked", "no_pressure")
        assert unknown.limit is not None and unknown.value is None
    # the pressure of Hertz, up to a limit within his reach
    for limit in (60e6, 20e6):
        hertz = replace(soft, pin_material=replace(SOFT, limit=ContactLimit("given", limit)))
        reserve = CRANK["contact_pressure_pin"](hertz).torque_reserve
        assert soft.contact is not None and soft.contact.half_width_ratio > 0.2
        expected = (limit / 1.2 / float(soft.contact.max_pressure)) ** 2
        assert reserve == pytest.approx(expected, rel=1e-12) and expected < 2
    # of steel it may end before the pressure reaches a limit: there the width is the pin's radius
    strong = replace(SOFT, limit=ContactLimit("given", 1e12))
    ended = CRANK["contact_pressure_pin"](replace(soft, pin_material=strong))
    assert soft.contact is not None
    assert ended.torque_reserve == pytest.approx(soft.contact.half_width_ratio**-2, rel=1e-12)


@pytest.mark.parametrize("limit", [30e6, 60e6, 600e6, 2400e6])
def test_the_reserve_of_a_conformal_contact_is_where_its_pressure_reaches_the_limit(
    limit: float,
) -> None:
    material = replace(HOLE, limit=ContactLimit("given", limit))
    design = replace(REF, hole_radius=0.00802, eccentricity=2e-5, hole_material=material)
    reserve = CRANK["contact_pressure_hole"](design).torque_reserve
    assert reserve is not None
    assert CRANK["contact_conformity"](design).status == "not_applicable"
    there = replace(design, output_torque=500.0 * reserve)
    assert CRANK["contact_pressure_hole"](there).utilisation == pytest.approx(1, rel=1e-12)


def test_a_pressure_within_rounding_of_its_limit_is_marginal() -> None:
    assert REF.contact is not None
    pressure, error = float(REF.contact.max_pressure), REF.contact.accuracy.relative_error
    for part, status in ((7.5, "marginal"), (8.5, "fail")):
        limit = ContactLimit("given", 1.2 * pressure * (1 - part * float(error)))
        design = replace(REF, hole_material=replace(HOLE, limit=limit))
        assert CRANK["contact_pressure_hole"](design).status == status


def test_within_the_error_of_different_materials_the_pressure_is_marginal() -> None:
    bronze = ElasticMaterial(88.3e9, 0.35, ContactLimit("given", 1e9))
    tight = replace(REF, hole_radius=0.00802, eccentricity=2e-5, hole_material=bronze)
    assert tight.contact is not None and tight.contact.governing_pressure is not None
    pressure, error = float(tight.contact.governing_pressure), tight.contact.conformal_error
    assert error is not None and 0.01 < error < 0.05
    for part, status in ((0.9, "marginal"), (-0.9, "marginal"), (-1.1, "fail")):
        limit = ContactLimit("given", 1.2 * pressure * (1 + part * float(error)))
        design = replace(tight, hole_material=replace(bronze, limit=limit))
        found = CRANK["contact_pressure_hole"](design)
        assert (found.status, found.reason == "pressure_error") == (status, status == "marginal")


@pytest.mark.parametrize("clearance", [-3e-5, -2e-11, -5e-12, 0.0, 5e-12, 2e-11, 3e-5])
def test_fit(clearance: float) -> None:
    design = replace(REF, hole_radius=0.010 + clearance)
    # rounding of a decimal of that size is none
    real = clearance if abs(clearance) > 1e-11 else 0.0
    hole = 0.010 + clearance
    says(
        CRANK["interference"](design),
        status="fail" if real < 0 else "pass",
        value=hole,
        limit=0.010 if real else hole,
        keep="above",
        utilisation=0.010 / hole if real else 1.0,
        impossible=real < 0,
    )
    loose = CRANK["clearance"](design)
    assert loose.status == ("marginal" if real > 0 else "pass")
    assert loose.value == pytest.approx(max(real, 0.0), rel=1e-6)
    assert (loose.limit, loose.warning) == (0.0, True)
    assert loose.reason == ("force_law" if real > 0 else "")
    for code in ("contact_pressure_pin", "contact_yield_hole", "contact_conformity"):
        found = CRANK[code](design)
        assert (found.status == "not_checked") == (real > 0), code
        assert (found.reason == "force_law") == (real > 0), code
        assert bool(found.at) == (real <= 0 and code != "contact_conformity"), code


@pytest.mark.parametrize("code", ["interference", "clearance"])
def test_no_fit_without_the_eccentricity(code: str) -> None:
    unknown = {"status": "not_checked", "value": None, "reason": "eccentricity_missing"}
    found = CRANK[code](replace(REF, eccentricity=None))
    says(found, missing=("eccentricity",), **unknown)
    assert CRANK["contact_pressure_pin"](replace(REF, eccentricity=None)).status == "pass"


WALLS: dict[str, tuple[dict[str, Any], str, float, bool]] = {
    # changes, check, width in m, whether the wall that is asked counts
    "holes": ({}, "wall_holes", 0.030, True),
    "eight holes": ({"pins": 8}, "wall_holes", 0.1 * math.sin(math.pi / 8) - 0.020, True),
    "pins": ({}, "pins_apart", 0.034, False),
    "axis": ({}, "holes_off_centre", 0.040, False),
    "rim": ({"outer_radius": 0.065}, "wall_rim", 0.005, True),
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
    says(found, status="pass", value=found.value, limit=0.0, keep="above", utilisation=0.0)
    assert found.margin == found.value
    for part in (0.99, 1.01):
        least = CRANK[code](replace(design, min_wall=width * part))
        says(
            least,
            status="fail" if asked and part > 1 else "pass",
            value=width,
            limit=width * part if asked else 0.0,
            keep="above",
            utilisation=part if asked else 0.0,
        )


def test_walls_that_are_not_there() -> None:
    for changes, code in (
        ({"hole_radius": 0.025}, "wall_holes"),  # they touch
        ({"pins": 16}, "wall_holes"),
        ({"pins": 24}, "pins_apart"),
        ({"pin_circle_radius": 0.010}, "holes_off_centre"),
        ({"outer_radius": 0.060}, "wall_rim"),
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
    assert {*crank_tables(REF)} == {*CRANK}
    assert {*crank_tables(no_body)} == {*CRANK} - {"wall_rim", "wall_bore"}
    assert {*crank_tables(no_load)} == mechanism | fit
    assert {*crank_tables(no_contact)} == mechanism
    later = ("clearance", "pin", "friction", "gear", "bearing", "crankshaft")
    assert crank_checks(REF).not_considered == later
    assert crank_checks(no_body).not_considered == ("satellite_body", *later)
    assert crank_checks(no_load).not_considered == ("load", *later)
    bare = replace(no_contact, output_torque=None, has_body=False)
    assert no_load.force is None and no_load.contact is None
    assert not CrankDesign(pins=3, satellites=1, ratio=20.0).has_body
    assert crank_checks(bare).not_considered == ("load", "contact", "satellite_body", *later)


def rollers(count: int = 4, **changes: Any) -> Verdict:
    """Checks of the rollers of the 2019 paper's fig. 6, d = 10 mm."""
    sizes: dict[str, Any] = {
        "output_torque": 210.0,
        "hole_circle_radius": 0.03,
        "rollers": count,
        "sphere_diameter": 0.015,
        "cylinder_length": 0.02,
        "sphere_width": 0.008,
        "position_tolerance": changes.pop("position_tolerance", 2e-6),
    }
    result = roller_strength(
        **sizes,
        diameter=0.01,
        friction_coefficient=0.16,
        youngs_modulus=210e9,
        poissons_ratio=0.3,
        stress_concentration=2.0,
    )
    return roller_checks(result=result, **sizes, **changes)


def test_rollers_that_do_not_carry_have_no_share_in_the_reserve() -> None:
    """Two alike carry, one is far behind: the stress is proportional to the torque."""
    sizes: dict[str, Any] = {
        "output_torque": 210.0,
        "hole_circle_radius": 0.03,
        "rollers": 3,
        "sphere_diameter": 0.015,
        "cylinder_length": 0.02,
        "sphere_width": 0.008,
        "gaps": (1e-3, 3e-4, 3e-4),
    }
    more = {"diameter": 0.01, "friction_coefficient": 0.16, "youngs_modulus": 210e9}
    result = roller_strength(**sizes, **more, poissons_ratio=0.3)
    assert result.loaded_rollers == 2
    stress = float(result.bending_stress)
    found = roller_checks(result=result, **sizes, yield_strength=1.8 * stress)["roller_stress"]
    assert found.torque_reserve == pytest.approx(1.2, rel=1e-12)
    # a stress known to 0.1 %: within four times that of its limit it is marginal
    doubtful = replace(result, accuracy=replace(result.accuracy, relative_error=1e-3))
    for part, status in ((0.9965, "marginal"), (0.9955, "fail")):
        limit = {"yield_strength": 1.5 * part * stress}
        assert roller_checks(result=doubtful, **sizes, **limit)["roller_stress"].status == status


STRESS = 0.0024213655009 * 210e9  # sigma/E of fig. 6 at l/d = 2, chi/d = 2e-4


def test_stress_of_rollers() -> None:
    unknown = rollers()["roller_stress"]
    assert (unknown.status, unknown.reason) == ("not_checked", "yield_unknown")
    assert unknown.missing == ("yield_strength",)
    assert unknown.value == pytest.approx(STRESS, rel=1e-10)
    for strength, safety, status in (
        (STRESS * 1.5 * 1.2, 1.5, "pass"),
        (STRESS * 1.5 * 1.01, 1.5, "marginal"),
        (STRESS * 1.5 * 0.99, 1.5, "fail"),
        (STRESS * 2.0 * 0.99, 2.0, "fail"),
    ):
        found = rollers(yield_strength=strength, bending_safety=safety)["roller_stress"]
        assert (found.status, found.keep) == (status, "below")
        assert found.value == pytest.approx(STRESS, rel=1e-10)
        assert found.limit == pytest.approx(strength / safety, rel=1e-12)
        assert found.utilisation == pytest.approx(STRESS * safety / strength, rel=1e-9)
    # without errors of position the stress is proportional to the torque
    even = rollers(yield_strength=1e9, position_tolerance=0.0)["roller_stress"]
    assert even.torque_reserve == pytest.approx(even.limit / even.value, rel=1e-12)  # type: ignore[operator]
    default = rollers(yield_strength=900e6)["roller_stress"]
    assert default.limit == pytest.approx(600e6)


def test_rollers_that_carry() -> None:
    says(
        rollers()["roller_sharing"],
        status="pass", value=4.0, limit=4.0, keep="above", utilisation=1.0, warning=True,
    )  # fmt: skip
    says(
        rollers(position_tolerance=5e-5)["roller_sharing"],
        status="marginal", value=1.0, limit=4.0, keep="above", utilisation=4.0, warning=True,
        reason="uneven",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("count", "status"), [(1, "not_applicable"), (2, "pass"), (12, "pass"), (13, "fail")]
)
def test_room_of_rollers(count: int, status: str) -> None:
    found = rollers(count)["roller_spacing"]
    assert (found.status, found.impossible) == (status, status == "fail")
    if count > 1:
        assert found.value == pytest.approx(0.06 * math.sin(math.pi / count) - 0.015, rel=1e-12)
    else:
        assert found.reason == "one_only"
    assert rollers(count)["roller_room"].value == pytest.approx(0.0225, rel=1e-12)


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
        keep="above",
        utilisation=10 * eccentricity / 0.064,
        warning=True,
        reason="" if long else "tilted",
    )


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
    return shaft_checks(result=result, positions=positions, **(sizes | changes))  # type: ignore[arg-type]


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
    assert found.value == pytest.approx(0.1 * math.sin(apart / 2) - 0.008, rel=1e-9)
    assert found.status == "pass"


def test_room_of_a_wheel_and_its_shaft() -> None:
    for positions in ((1.0,), (1.0, 1.0), (1.0, 1.0 + 2 * math.pi)):
        alone = shaft(positions)["line_spacing"]
        assert (alone.status, alone.reason) == ("not_applicable", "one_only")
    assert shaft((0.0, 0.16))["line_spacing"].impossible  # 8 mm apart, and that wide
    room = shaft()["shaft_in_circle"]
    assert room.value == pytest.approx(0.05 - 0.004 - 0.015, rel=1e-12)
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
        says(check, status="not_asked", value=2e-5, reason="no_limit", missing=(f"max_{which}",))
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


@pytest.mark.parametrize(
    ("changes", "status", "reason"),
    [
        # value 1: limit, sense, reserve, error, warning
        ({"limit": 1.0}, "pass", ""),  # a size that is asked for is there
        ({"limit": 1.0, "reserve": 1.0}, "marginal", ""),
        ({"limit": 1.0, "reserve": 1.0, "error": 2e-9}, "marginal", "pressure_error"),
        ({"limit": 1.0, "reserve": 1.0, "error": 1e-10}, "marginal", ""),
        ({"limit": 0.99, "reserve": 0.98}, "fail", ""),
        ({"limit": 0.99}, "fail", ""),
        ({"limit": 0.99, "warning": "uneven"}, "marginal", "uneven"),
        ({"limit": 1.01, "warning": "uneven", "reserve": 1.01}, "pass", ""),
        ({"limit": 1.01, "reserve": 1.0201}, "marginal", ""),
        ({"limit": 1.01}, "pass", ""),
        ({"limit": 1.01, "keep": "above"}, "fail", ""),
        ({"limit": 0.99, "keep": "above"}, "pass", ""),
        ({"limit": 0.95, "reserve": 0.9, "error": 0.06}, "marginal", "pressure_error"),
        ({"limit": 0.95, "reserve": 0.9, "error": 0.04}, "fail", ""),
        ({"limit": 1.2, "reserve": 1.1}, "pass", ""),
        ({"limit": 1.2, "reserve": 1.0999}, "marginal", ""),
    ],
)
def test_judging(changes: dict[str, Any], status: str, reason: str) -> None:
    limit = changes.pop("limit")
    found = judged("contact_pressure_pin", 1.0, limit, **changes)
    changes["limit"] = limit
    assert (found.status, found.reason) == (status, reason)
    assert found.utilisation == pytest.approx(
        limit if changes.get("keep") == "above" else 1 / limit, rel=1e-15
    )
    assert found.torque_reserve == changes.get("reserve")
    assert found.warning == ("warning" in changes)


def test_utilisation_needs_something_to_use() -> None:
    for value, limit, keep, used in (
        (1.0, 0.0, "below", None),
        (0.0, 1.0, "below", 0.0),
        (-1.0, 1.0, "below", None),
        (0.0, 1.0, "above", None),
        (-1.0, 1.0, "above", None),
        (1.0, 0.0, "above", 0.0),
    ):
        found = judged("wall_holes", value, limit, keep=keep)  # type: ignore[arg-type]
        assert found.utilisation == used
        assert found.margin == (limit - value if keep == "below" else value - limit)
    assert Check(code="wall_holes", status="not_checked", value=1.0).margin is None
    assert Check(code="wall_holes", status="not_checked", limit=1.0).margin is None


def test_the_order_of_what_is_not_judged_and_of_equals() -> None:
    unknown = [
        Check(code="wall_rim", status="not_applicable"),
        Check(code="assembly", status="not_asked"),
        Check(code="clearance", status="not_checked"),
    ]
    half, most = (judged("wall_holes", 1.0, part, keep="above") for part in (0.5, 0.9))
    found = verdict([*unknown, half, most])
    assert [each.utilisation for each in found.checks[:2]] == [0.9, 0.5]
    assert [each.status for each in found.checks[2:]] == [
        "not_checked",
        "not_asked",
        "not_applicable",
    ]
    assert found["assembly"].status == "not_asked"
    # what warns before what passes, and that before what is not known, whatever their reserves
    warned = judged("crank_balance", 1.0, 0.0, warning="unbalanced")
    room = judged("line_spacing", 1.0, 0.0, keep="above")
    stressed = judged("roller_stress", 1.0, 2.0, reserve=1.5)
    order = [warned, stressed, room, *reversed(unknown)]
    assert verdict(reversed(order)).checks == tuple(order)
    # an impossible part that is not there is none
    passing = replace(half, impossible=True)
    stress = judged("roller_stress", 1.0, 2.0, reserve=2.0)
    assert [each.code for each in verdict([passing, stress]).checks] == [stress.code, "wall_holes"]
    assert verdict([stress]).largest_torque_known
    assert not verdict([stress, replace(half, status="fail")]).largest_torque_known
    # the worst of those that no torque cures: more of the limit used
    two = [replace(each, status="fail") for each in (half, most)]
    assert verdict(two).checks[0].utilisation == 0.9
