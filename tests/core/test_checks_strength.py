"""Checks of pins, friction, ring, bearings and crankshaft by hand, and what they need.

Six pins, two satellites, 500 N*m: the peak is 10000/3 N. A cantilever of 16 mm, its forces at 15
and 37 mm; satellites on one position share alike.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_check, crank_checks
from core.checks.records import CHECKS
from core.checks.reserve import crank_verdict
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing, InvoluteRing, OtherRing
from core.design.sections import Build, SeatedBearing, Shaft
from core.errors import InvalidInput
from core.fixes.changes import value_of, vary
from core.hertz import ElasticMaterial
from core.material_table import MATERIALS
from core.output.room import Deviations
from core.precision import EXACT, JUDGED, SAME, SEARCHED
from tests.inputs.checks import REF, WHOLE, check_of, fixes_of, having, says

PEAK = 1e4 / 3
MODULUS = math.pi * 0.016**3 / 32
ONE = having(WHOLE, satellites=1, output_torque=250.0)
"""Of one satellite, which has nobody to share with."""
EVENLY = {"support": "supported", "span": 0.062, "satellite_positions": (0.02, 0.042)}
EVEN = having(WHOLE, pin=replace(WHOLE.pin, **EVENLY))  # type: ignore[arg-type, type-var]
"""Of two satellites that share alike."""
NO_RING = {"gear": None, "bearing": None, "crankshaft": None}
RINGLESS = having(EVEN, **NO_RING)
"""The same without a ring, whose friction would have to be known."""


def equally(code: str, design: Design) -> Check:
    """A check by ideal forces that the satellites share equally."""
    return crank_check(code, Results(design, equal=True))


def part(design: Design, section: str, **changes: Any) -> Design:
    """A design with changes in a section."""
    changed = replace(getattr(design, section), **changes)
    return having(design, **{section: changed})


def one_at(z: float, **changes: Any) -> Design:
    """One satellite, whose peak is as that of two under twice the torque: 10/3 kN."""
    pin = replace(WHOLE.pin, satellite_positions=(z,))  # type: ignore[type-var]
    shaft = replace(WHOLE.crankshaft, satellite_positions=(0.02,))  # type: ignore[type-var]
    return having(ONE, pin=pin, crankshaft=shaft, **changes)


STRESS = PEAK * 0.037 / MODULUS


def test_static_strength() -> None:
    found = equally("pin_static", one_at(0.037))
    assert found.value == pytest.approx(STRESS, rel=SAME)
    limit = 800e6 / 1.5
    says(
        found._replace(value=STRESS, torque_reserve=limit / STRESS, utilisation=STRESS / limit),
        status="pass", value=STRESS, limit=limit,
        utilisation=STRESS / limit, torque_reserve=limit / STRESS,
    )  # fmt: skip
    assert found.torque_reserve == pytest.approx(limit / STRESS, rel=SAME)
    for safety, status in ((800e6 / STRESS * 1.001, "fail"), (800e6 / STRESS / 1.05, "marginal")):
        assert equally("pin_static", one_at(0.037, bending_safety=safety)).status == status
    # K_A and the peak torque
    more = equally("pin_static", one_at(0.037, application_factor=1.25))
    assert more.value == pytest.approx(1.25 * STRESS, rel=SAME)
    peak = equally("pin_static", one_at(0.037, application_factor=1.25, peak_torque=500.0))
    assert peak.value == pytest.approx(2 * STRESS, rel=SAME)


def test_of_two_satellites_that_share_equally_the_far_one_bends_the_pin() -> None:
    found = equally("pin_static", WHOLE)
    assert found.value == pytest.approx(STRESS, rel=SAME)


def test_fatigue() -> None:
    """0 to the peak: 1/n = (1/2)/Se + (1/2)/Rm."""
    safety = 1 / (STRESS / 2 / 300e6 + STRESS / 2 / 1000e6)
    found = equally("pin_fatigue", one_at(0.037))
    assert found.value == pytest.approx(safety, rel=SAME)
    assert found.value == pytest.approx(1.504829, abs=5e-7)  # F13
    assert (found.status, found.limit) == ("marginal", 1.5)
    assert found.torque_reserve == pytest.approx(safety / 1.5, rel=SAME)
    assert equally("pin_fatigue", one_at(0.037, fatigue_safety=1.2)).status == "pass"
    assert equally("pin_fatigue", one_at(0.037, fatigue_safety=1.6)).status == "fail"
    both = equally("pin_fatigue", one_at(0.037, torque_direction="alternating"))
    assert both.value == pytest.approx(300e6 / STRESS, rel=SAME)


def test_fatigue_over_the_life() -> None:
    """Few turns: the strength on the line from f*Rm at 1000 cycles to Se at a million."""
    f = 1.06 - 2.8e-3 * 145.0377377 + 6.9e-6 * 145.0377377**2
    turns = 1575 / 60  # a second: 1500 a minute, ratio 20
    for cycles, share in ((1e6, 0.0), (1e5, 1 / 3), (1e3, 1.0), (10.0, 1.0), (4e8, 0.0)):
        limit = 300e6 * (f * 1000e6 / 300e6) ** share
        safety = 1 / (STRESS / 2 / limit + STRESS / 2 / 1000e6)
        design = one_at(0.037, life=cycles / turns)
        found = equally("pin_fatigue", design)
        assert found.value == pytest.approx(safety, rel=EXACT)
        assert found.torque_reserve == pytest.approx(safety / 1.5, rel=EXACT)
        assert found.reason == ("finite_life" if share else "")
        # what counts no cycles, or has no such line, is judged by the endurance limit
        for other in (
            having(design, input_speed=None),
            part(design, "pin", steel=False),
        ):
            lasting = equally("pin_fatigue", other)
            assert lasting.value == pytest.approx(1.504829, abs=5e-7) and not lasting.reason
        rotating = equally("pin_fatigue", part(design, "pin", rotates=True))
        assert rotating.value == pytest.approx(300e6 / STRESS, rel=EXACT)
        assert "pin.rotates" in rotating.kind.inputs


UNKNOWN: dict[str, tuple[dict[str, Any], dict[str, Any], str, tuple[str, ...]]] = {
    # changes of pin, of fatigue, reason, missing
    "no tensile strength": (
        {"tensile_strength": None}, {},
        "endurance_unknown", ("pin.material.tensile_strength",),
    ),
    "no steel": (
        {"steel": False}, {"endurance_limit": None, "surface": "ground"},
        "endurance_unknown", ("fatigue.endurance_limit",),
    ),
    "no notch": (
        {}, {"endurance_limit": None, "surface": "ground"},
        "notch_unknown", ("fatigue.fatigue_notch_factor",),
    ),
    "no yield strength": (
        {"material": ElasticMaterial(210e9, 0.3)},
        {"criterion": "soderberg"},
        "yield_unknown", ("pin.material.yield_strength",),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", UNKNOWN)
def test_what_fatigue_needs(name: str) -> None:
    pin, fatigue, reason, missing = UNKNOWN[name]
    design = part(part(WHOLE, "pin", **pin), "fatigue", **fatigue)
    unknown = check_of("pin_fatigue", design)
    says(unknown, status="not_checked", value=None, reason=reason, missing=missing)
    assert crank_checks(Results(design)).verdict in ("incomplete", "fail")
    alone = check_of("pin_fatigue", having(WHOLE, pin=None))
    says(alone, status="not_checked", value=None, reason="section_missing", missing=("pin",))


def test_what_static_strength_needs() -> None:
    material = MATERIALS["steel_bearing"].material
    soft = part(WHOLE, "pin", material=material, tensile_strength=None)
    unknown = check_of("pin_static", soft)
    assert unknown.status == "not_checked" and unknown.value is not None
    assert (unknown.reason, unknown.missing) == ("yield_unknown", ("pin.material.yield_strength",))
    hard = part(WHOLE, "pin", material=material, tensile_strength=1800e6)
    assert check_of("pin_static", hard).limit == 1800e6 / 1.5
    many = having(REF, pin=WHOLE.pin, pins=251)
    for code in ("pin_static", "contact_pressure_pin"):
        found = check_of(code, many)
        assert (found.status, found.reason) == ("not_checked", "too_many_pairs")


def test_slope_and_deflection() -> None:
    """One satellite at 37 mm, F10: 3.4185221273 mrad, 0.0912803795 mm."""
    design = one_at(0.037)
    for code, value in (("slope", 3.4185221273e-3), ("deflection", 0.0912803795e-3)):
        nobody = equally(f"pin_{code}", design)
        assert (nobody.status, nobody.missing) == ("not_asked", (f"requirements.max_{code}",))
        assert nobody.value == pytest.approx(value, rel=EXACT)
        for share, status in ((1.2, "pass"), (1.05, "marginal"), (0.99, "fail")):
            limit = share * value
            found = equally(f"pin_{code}", having(design, **{f"max_{code}": limit}))
            assert (found.status, found.limit) == (status, limit)
            assert found.torque_reserve == pytest.approx(share, rel=EXACT)
            assert found.at == {"satellite": 1}


def test_friction() -> None:
    """REF of the theory: 336 W of 3926.99, 0.329867 m/s, 0.118125 mm after 3000 h."""
    efficiency = 1 / (1 + 336 / (500 * 50 * math.pi / 20))
    values = {
        "efficiency": (efficiency, "min_efficiency"),
        "sliding_speed": (0.002 * 52.5 * math.pi, "max_sliding_speed"),
        "wear": (0.118125e-3, "max_wear"),
    }
    for code, (value, limit) in values.items():
        nobody = equally(code, RINGLESS)
        assert (nobody.status, nobody.missing) == ("not_asked", (f"requirements.{limit}",))
        assert nobody.value == pytest.approx(value, rel=EXACT)
        keep = "above" if code == "efficiency" else "below"
        for share, status in ((1.2, "pass"), (0.99, "fail")):
            asked = value / share if keep == "above" else share * value
            if keep == "above" and asked >= 1:
                asked = 0.95
            found = equally(code, having(RINGLESS, **{limit: asked}))
            assert (found.status, found.limit) == (status, asked)
        unknown = equally(code, having(RINGLESS, **{limit: asked}, input_speed=None))
        assert (unknown.status, unknown.reason) == ("not_checked", "speed_missing")
        assert unknown.missing == ("load.input_speed",)
        unknown = equally(code, having(RINGLESS, **{limit: asked}, eccentricity=None))
        assert (unknown.reason, unknown.missing) == (
            "eccentricity_assumed",
            ("contact.eccentricity",),
        )
    used = equally("efficiency", having(RINGLESS, min_efficiency=0.9))
    assert used.utilisation == pytest.approx((1 - efficiency) / 0.1)
    assert used.torque_reserve is None
    rate = part(having(RINGLESS, max_wear=1e-4), "friction", wear_rate=None)
    assert equally("wear", rate).missing == ("friction.wear_rate",)


def test_wear_over_the_required_life() -> None:
    design = part(having(EVEN, max_wear=1e-3, life=6000 * 3600.0), "friction", life=None)
    assert equally("wear", design).value == pytest.approx(2 * 0.118125e-3, rel=EXACT)


def test_pv_is_that_of_a_bush() -> None:
    bare = equally("pv", having(EVEN, max_pv=1e6))
    assert (bare.status, bare.reason) == ("not_applicable", "no_bush")
    sleeved = part(part(EVEN, "pin", diameter=0.011), "friction", sleeve=True)
    value = 3.4361169648638348e6
    for limit, status in ((1.2 * value, "pass"), (0.9 * value, "fail")):
        found = equally("pv", having(sleeved, max_pv=limit))
        assert (found.status, found.value) == (status, pytest.approx(value, rel=EXACT))
        assert found.torque_reserve == pytest.approx(limit / value, rel=EXACT)
    assert equally("pv", sleeved).status == "not_asked"


def rigid(**changes: Any) -> Design:
    """Without bending pins: the satellites share alike."""
    return having(WHOLE, pin=None, fatigue=None, **changes)


def light(**changes: Any) -> Design:
    """Design without centrifugal forces."""
    given = {"crankshaft": replace(WHOLE.crankshaft, satellite_mass=None)}  # type: ignore[type-var]
    return rigid(**given | changes)


def test_bearings() -> None:
    """P 12390.148 N, Q 12645.46 N of each; ball bearings of 60 and 40 kN at 1575 rpm."""
    life = 1e6 * (60e3 / 12390.148) ** 3 / 1575 * 60  # s
    for asked, status in ((0.7, "pass"), (0.99, "marginal"), (1.01, "fail")):
        found = check_of("bearing_life", light(life=asked * life))
        assert found.value == pytest.approx(life, rel=SEARCHED)
        assert (found.status, found.limit) == (status, asked * life)
        assert found.torque_reserve == pytest.approx(asked ** (-1 / 3), rel=SEARCHED)
        assert found.utilisation == pytest.approx(asked, rel=SEARCHED)
    safe = part(light(life=0.7 * life), "bearing", reliability_percent=95.0)
    assert check_of("bearing_life", safe).value == pytest.approx(0.64 * life, rel=SEARCHED)
    static = check_of("bearing_static", light(application_factor=1.5, peak_torque=1000.0))
    assert static.value == pytest.approx(40e3 / 12645.46 / 2, rel=SEARCHED)
    assert (static.limit, static.status) == (1.5, "marginal")
    assert static.limit_source == "static_guide"
    stop = light(application_factor=1.5, peak_torque=1000.0, peak_kind="emergency")
    assert check_of("bearing_static", stop).limit == 1.0
    for kind, usual in (("ball", 1.0), ("roller", 1.5)):  # without a peak torque
        assert check_of("bearing_static", part(light(), "bearing", kind=kind)).limit == usual
    roller = check_of("bearing_static", part(light(peak_torque=1000.0), "bearing", kind="roller"))
    assert roller.value == pytest.approx(40e3 / 12645.46 / 2, rel=SEARCHED)
    assert (roller.limit, roller.status) == (1.5, "marginal")
    # a load at rest needs no speed
    still = crank_checks(Results(light(peak_torque=1000.0, input_speed=None)))
    assert still["bearing_static"] == check_of("bearing_static", light(peak_torque=1000.0))
    assert still["bearing_life"].reason == "speed_missing"
    many = light(input_speed=None, pins=2001, crankshaft=None)
    assert check_of("bearing_static", many).reason == "too_many_pairs"
    static = check_of("bearing_static", light(application_factor=1.5, static_safety=3.0))
    assert static.value == pytest.approx(40e3 / 12645.46 / 1.5, rel=SEARCHED)
    assert (static.status, static.limit_source) == ("fail", "")
    together = part(light(life=0.3 * life), "bearing", weibull_slope=10 / 9)
    found = check_of("system_life", together)
    assert found.value == pytest.approx(life / 2**0.9, rel=SEARCHED)
    surer = check_of("system_life", part(together, "bearing", reliability_percent=99.0))
    assert surer.value == pytest.approx(0.25 * life / 2**0.9, rel=SEARCHED)
    assert surer.status == "fail"
    assert check_of("system_life", light()).missing == ("bearing.weibull_slope",)
    alone = having(together, satellites=1)
    assert check_of("system_life", alone).reason == "one_only"


@pytest.mark.parametrize("ahead", [1, 2])
def test_the_bearing_that_is_judged_is_that_of_the_satellite_ahead(ahead: int) -> None:
    """One satellite's holes are 0.2 mrad ahead: its pins carry nearly the whole load."""
    turned = Deviations(disc_phase=(0.0, 2e-4 if ahead == 2 else -2e-4))
    hole = WHOLE.contact.hole_radius + 1e-5  # type: ignore[union-attr, operator]
    results = Results(rigid(deviations=turned, hole_radius=hole))
    first, second = results.crank.bearings.life
    assert (first < second / 100) == (ahead == 1)
    for code in ("bearing_life", "bearing_static"):
        assert crank_check(code, results).at == {"satellite": ahead}


def test_a_satellite_relieves_its_bearing() -> None:
    """74.022 N of 1.5 kg outwards along the crank, of a load of 12 kN; a static load is at rest."""
    spinning = check_of("bearing_life", rigid())
    still = check_of("bearing_life", light())
    assert spinning.value is not None and still.value is not None
    assert 1 < spinning.value / still.value < (1 - 74.022 / 11877) ** -3
    assert (spinning.solved, still.solved) == (True, False)
    asked = rigid(life=spinning.value * 0.999)
    assert crank_verdict(Results(asked))["bearing_life"].status == "marginal"
    static = [check_of("bearing_static", each(peak_torque=1000.0)) for each in (rigid, light)]
    assert static[0].value == static[1].value
    heavy = rigid(crankshaft=replace(WHOLE.crankshaft, satellite_mass=1e4))  # type: ignore[type-var]
    turned = check_of("bearing_static", heavy).value
    pull = 1e4 * 2e-3 * (50 * math.pi) ** 2
    assert turned is not None and 40e3 / turned == pytest.approx(pull, rel=0.05)
    assert check_of("bearing_life", heavy).value < still.value


def test_bearings_that_nothing_presses() -> None:
    """Four cranks, 0, 180, 180 and 0 degrees, even along the shaft: forces and couples cancel."""
    balls = (SeatedBearing(kind="ball", dynamic_rating=20e3),) * 2
    even = having(
        rigid(satellites=4, crank_angles=(0.0, math.pi, math.pi, 0.0)),
        crankshaft=Shaft(
            satellite_positions=(0.010, 0.032, 0.054, 0.076),
            bearing_positions=(0.0, 0.086),
            bearings=balls,
        ),
    )
    found = check_of("crank_bearing_life", even)
    says(found, status="not_applicable", limit=5000 * 3600, reason="unloaded")


def test_the_static_load_of_crank_bearings() -> None:
    """4487.098 N on each bearing under 500 N*m; the worse of a weak ball and a strong roller."""
    bearings = (
        SeatedBearing(kind="ball", static_rating=13e3),
        SeatedBearing(kind="roller", static_rating=16e3),
    )
    shaft = Shaft(
        satellite_positions=(0.020, 0.042), bearing_positions=(0.0, 0.062), bearings=bearings
    )
    found = check_of("crank_bearing_static", light(crankshaft=shaft))
    assert (found.status, found.limit, found.at) == ("pass", 1.5, {"bearing": 2})
    assert found.limit_source == "static_guide"
    assert found.value == pytest.approx(16e3 / 4487.098, rel=SEARCHED)
    stopped = light(crankshaft=shaft, peak_torque=1500.0, peak_kind="emergency")
    found = check_of("crank_bearing_static", stopped)
    assert (found.status, found.limit, found.at) == ("fail", 1.0, {"bearing": 1})
    assert found.value == pytest.approx(13e3 / (3 * 4487.098), rel=SEARCHED)
    assert found.torque_reserve == pytest.approx(found.value, rel=SAME)
    unknown = replace(shaft, bearings=(bearings[0], SeatedBearing(kind="ball")))
    found = check_of("crank_bearing_static", light(crankshaft=unknown))
    says(found, status="not_checked", reason="rating_unknown", missing=("crankshaft.bearings",))
    for mass, rests in ((100.0, True), (1000.0, False)):  # which the shaft may do without its pull
        heavy = replace(shaft, satellite_mass=mass)
        spun = check_of("crank_bearing_static", light(crankshaft=heavy)).value
        assert (spun == pytest.approx(16e3 / 4487.098, rel=SEARCHED)) == rests
        assert rests or spun < 1.5


def test_strengths_of_thinner_pins_only_fail() -> None:
    """A pin of 16 mm of a material whose strengths hold up to a diameter."""
    for valid, strength in ((0.016, "pass"), (0.0159, "not_checked")):
        design = part(one_at(0.015, bending_safety=1.0), "pin", valid_diameter=valid)
        for code in ("pin_static", "pin_fatigue"):
            found = check_of(code, having(design, fatigue_safety=1.0))
            assert found.status == strength
            if strength == "not_checked":
                assert (found.reason, found.missing) == ("beyond_size", ("pin.material",))
        for code in ("pin_static", "pin_fatigue"):
            worse = having(design, bending_safety=20.0, fatigue_safety=20.0)
            failing = check_of(code, worse)
            assert failing.status == "fail"
            known = failing.torque_reserve is not None  # by how much it fails
            assert known == (strength == "pass")


MISSING: dict[str, tuple[Design, tuple[str, ...], tuple[str, ...]]] = {
    # design, checks, missing
    "ring": (having(WHOLE, gear=None), ("bearing_life", "bearing_static"), ("gear",)),
    "speed": (
        having(part(WHOLE, "bearing", weibull_slope=1.1), input_speed=None),
        ("bearing_life", "system_life"),
        ("load.input_speed",),
    ),
    "eccentricity": (
        having(WHOLE, eccentricity=None),
        ("bearing_life", "pressure_angle", "mesh_possible"),
        ("contact.eccentricity",),
    ),
    "eccentricity of a cycloid disc": (
        having(
            WHOLE,
            eccentricity=None,
            gear=CycloidRing(ring_pin_circle_radius=0.084, ring_pin_radius=0.004),
        ),
        ("gear_room", "ring_undercut"),
        ("contact.eccentricity",),
    ),
    "rating": (
        part(WHOLE, "bearing", dynamic_rating=None), ("bearing_life",), ("bearing.dynamic_rating",)
    ),
    "static rating": (
        part(WHOLE, "bearing", static_rating=None), ("bearing_static",), ("bearing.static_rating",)
    ),
    "mass": (
        part(having(WHOLE, max_unbalance=1.0), "crankshaft", satellite_mass=None),
        ("unbalance_force",),
        ("crankshaft.satellite_mass",),
    ),
    "ratings of the shaft": (
        part(WHOLE, "crankshaft", bearings=(SeatedBearing(kind="ball"),) * 2),
        ("crank_bearing_life",),
        ("crankshaft.bearings",),
    ),
    "size": (
        having(REF, max_outer_diameter=0.1), ("outer_diameter",), ("satellite_body.outer_radius",)
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MISSING)
def test_nothing_passes_by_absence(name: str) -> None:
    design, codes, missing = MISSING[name]
    found = crank_checks(Results(design))
    for code in codes:
        assert (found[code].status, found[code].missing) == ("not_checked", missing)
        assert found[code].reason
    assert found.verdict in ("incomplete", "fail")
    part_of = {each.code: each for each in found.parts}[found[codes[0]].kind.part]
    assert part_of.status == "fail" or (part_of.status == "open" and missing[0] in part_of.missing)


PINNED = ("ring_undercut", "ring_valley_tool", "ring_pin_room")


def test_ring() -> None:
    angle = check_of("pressure_angle", WHOLE)
    assert angle.value == pytest.approx(math.radians(34.6912426), rel=EXACT)
    assert angle.status == "pass"
    steep = check_of("pressure_angle", part(WHOLE, "gear", module=1.15e-3))
    assert (steep.status, steep.reason) == ("marginal", "steep_mesh")
    for ring, codes in (
        (OtherRing(kind="none"), ("pressure_angle", "mesh_possible", "gear_room", *PINNED)),
        (
            OtherRing(radial_force_ratio=0.3),
            ("pressure_angle", "mesh_possible", "gear_room", *PINNED),
        ),
        (WHOLE.gear, PINNED),
        (
            CycloidRing(ring_pin_circle_radius=0.084),
            ("pressure_angle", "mesh_possible"),
        ),
    ):
        for code in codes:
            assert check_of(code, having(WHOLE, gear=ring)).status == "not_applicable"


def test_teeth_that_can_mesh() -> None:
    """By module, teeth and eccentricity alone; never a green word of the teeth."""

    def teeth(module: float, difference: int, eccentricity: float, degrees: float = 20) -> Design:
        ring = InvoluteRing(
            module=module,
            teeth_difference=difference,
            reference_pressure_angle=math.radians(degrees),
        )
        return having(REF, gear=ring, eccentricity=eccentricity, hole_radius=0.008 + eccentricity)

    for design, status, ratio in (
        (teeth(3.5e-3, 1, 2e-3), "fail", 0.53),  # 20 in 21
        (teeth(3e-3, 2, 3.2e-3), "marginal", 0.84),  # 40 in 42
        (teeth(3e-3, 2, 3.68e-3), "pass", 1.6),
        (teeth(3.5e-3, 1, 2.8e-3), "pass", 1.48),
        (teeth(3e-3, 2, 9e-3), "fail", 0.1),  # so far apart that they hardly reach each other
    ):
        found = check_of("mesh_possible", design)
        assert (found.status, found.limit) == (status, 1.0)
        assert found.value == pytest.approx(ratio, abs=0.1)
        assert found.reason == ("unusual_teeth" if status == "marginal" else "")
        (judged,) = (part for part in crank_checks(Results(design)).parts if part.code == "teeth")
        assert judged.status == ("fail" if status == "fail" else "open")
        assert found.impossible == (status == "fail")
    for beyond in (teeth(1e-3, 9, 6e-3), teeth(3e-3, 2, 3.68e-3, 14), teeth(3e-3, 2, 3.68e-3, 31)):
        found = check_of("mesh_possible", beyond)
        assert (found.status, found.reason) == ("not_checked", "outside_method")
    unknown = check_of("mesh_possible", having(teeth(3e-3, 2, 3.68e-3), eccentricity=None))
    assert (unknown.status, unknown.missing) == ("not_checked", ("contact.eccentricity",))


def test_holes_within_the_teeth() -> None:
    """40 teeth of 1.75 mm, R + r_out = 60 mm: this design has no room for its teeth."""
    found = check_of("gear_room", WHOLE)
    says(found, status="fail", value=-0.025, limit=0.0, impossible=True)
    assert crank_checks(Results(WHOLE)).verdict == "fail"
    # 40 teeth of 3.5 mm: roots from 65.625 to 70 mm
    pair = part(having(WHOLE, eccentricity=4e-3, hole_radius=0.012), "gear", module=3.5e-3)
    for circle, width in ((0.0535, 1.25e-4), (0.0537, None), (0.0579, None), (0.0581, -1e-4)):
        found = check_of("gear_room", having(pair, pin_circle_radius=circle))
        if width is None:
            missing = ("satellite_body.root_radius",)
            unknown = {"value": None, "reason": "roots_unknown", "missing": missing}
            says(found, status="not_checked", limit=0.0, **unknown)
            continue
        assert (found.status, found.impossible) == ("pass" if width > 0 else "fail", width < 0)
        assert found.value == pytest.approx(width, abs=1e-12) and found.limit_source == "roots"
    # a root radius that is given is believed, also beyond and within the reference circle
    within = having(pair, root_radius=0.065, pin_circle_radius=0.054)
    for design, width in ((having(WHOLE, root_radius=0.0605), 5e-4), (within, -1e-3)):
        found = check_of("gear_room", design)
        assert (found.status, found.limit_source) == ("pass" if width > 0 else "fail", "")
        assert found.value == pytest.approx(width, abs=1e-12)


def test_holes_within_a_cycloid_disc() -> None:
    """The 21 ring pins limit the roots of a disc whose centre moves on a circle of 2 mm."""
    rolled = np.linspace(0, 2 * math.pi, 21 * 100, endpoint=False)[:, None]
    places = 0.084 * np.exp(2j * math.pi * np.arange(21) / 21)
    nearest = float(np.abs(places - 2e-3 * np.exp(1j * rolled)).min())
    ring = CycloidRing(ring_pin_circle_radius=0.084, teeth_difference=1)
    own = part(having(WHOLE, gear=ring), "gear", ring_pin_radius=0.005)
    for width in (1e-4, -1e-4):
        design = having(own, pin_circle_radius=nearest - 0.005 - 0.010 - width)
        found = check_of("gear_room", design)
        status = "pass" if width > 0 else "fail"
        assert (found.status, found.impossible) == (status, width < 0)
        assert found.value == pytest.approx(width, abs=1e-12)
        given = having(design, root_radius=0.0771)  # which is believed
        assert check_of("gear_room", given).value == pytest.approx(width + 1e-4, abs=1e-12)
    unknown = {"value": None, "reason": "roots_unknown", "missing": ("gear.ring_pin_radius",)}
    for radius, status in ((0.084, "not_checked"), (0.0621, "not_checked"), (0.0619, "fail")):
        found = check_of(
            "gear_room", part(own, "gear", ring_pin_circle_radius=radius, ring_pin_radius=None)
        )
        if status == "fail":
            says(found, status=status, value=-1e-4, limit=0.0, impossible=True)
        else:
            says(found, status=status, limit=0.0, **unknown)


def test_crankshaft() -> None:
    """Loads of 4396.504 N of balls; without the masses."""
    assert check_of("crank_bearing_life", WHOLE).missing == ("crankshaft.bearings",)
    bearings = (
        SeatedBearing(kind="ball", dynamic_rating=20e3),
        SeatedBearing(kind="roller", dynamic_rating=25e3),
    )
    rated = part(light(life=1000 * 3600.0), "crankshaft", bearings=bearings)
    found = check_of("crank_bearing_life", rated)
    life = 1e6 * (20e3 / 4396.504) ** 3 / 1500 * 60
    assert found.value == pytest.approx(life, rel=JUDGED)
    assert found.at == {"bearing": 1}
    reserve = min((life / 3600 / 1000) ** (1 / 3), 25e3 / 4396.6 * (1e6 / 60 / 1500 / 1000) ** 0.3)
    assert found.torque_reserve == pytest.approx(reserve, rel=1e-3)


def test_the_forces_that_are_judged_are_solved_where_pins_bend() -> None:
    """Shared by elasticity the far satellite bends the pins less; with clearance fewer pairs carry,
    each more: wear, pins and bearings feel it.
    """
    asked = part(having(WHOLE, max_wear=1e-3), "crankshaft", satellite_mass=None)
    equal, perfect, loose = (
        crank_checks(Results(asked, equal=True)),
        crank_checks(Results(asked)),
        crank_checks(Results(having(asked, hole_radius=0.01002))),
    )
    for code in ("wear", "pin_static", "bearing_life"):
        values = [each[code].value for each in (equal, perfect, loose)]
        assert len({f"{value:.3g}" for value in values}) == 3
        assert [each[code].solved for each in (equal, perfect, loose)] == [False, True, True]
    for each in (perfect, loose):
        assert each["pin_static"].value < equal["pin_static"].value  # type: ignore[operator]
    assert loose["wear"].value > 2 * 0.118125e-3  # of equal sharing


def test_the_perfect_parts_of_the_reference_design() -> None:
    """Stresses recalculated apart from this program: 306.70 MPa shared equally; 180.08 MPa by
    elasticity without clearance, as satellites bend each other's pins (219.88 MPa if each bends
    them alone); 284.71 MPa with 0.02 mm of clearance, which separates them.
    """
    design = having(WHOLE, contact_law=None)
    loose = having(design, hole_radius=0.01002)
    for results, stress in (
        (Results(design, equal=True), 306.70e6),
        (Results(design), 180.08e6),
        (Results(loose), 284.71e6),
        (Results(loose, equal=True), 284.71e6),  # clearance is solved, however it is asked
    ):
        assert results.pin_strength.static_stress == pytest.approx(stress, rel=3e-5)


def test_a_sharing_that_is_stated_is_not_solved() -> None:
    for design, solved in (
        (WHOLE, True),
        (having(WHOLE, distribution_factor=1.5), False),
        (having(WHOLE, pin=None, fatigue=None), False),
        (having(WHOLE, pin=None, fatigue=None, hole_radius=0.01002), True),
    ):
        assert Results(design).solved == solved


ON_PINS = having(WHOLE, gear=CycloidRing(ring_pin_circle_radius=0.084, ring_pin_radius=0.005))

FAILING: dict[str, Design] = {
    "contact_pressure_hole": WHOLE,
    "pin_static": having(WHOLE, output_torque=1800.0),
    "pin_fatigue": having(WHOLE, output_torque=1000.0),
    "pin_slope": having(WHOLE, max_slope=6e-4),
    "pin_deflection": having(WHOLE, max_deflection=2e-5),
    "efficiency": having(WHOLE, **NO_RING, min_efficiency=0.95),
    "sliding_speed": having(WHOLE, max_sliding_speed=0.2),
    "pv": part(
        part(having(WHOLE, max_pv=2e6), "pin", diameter=0.011), "friction", sleeve=True
    ),
    "wear": having(WHOLE, max_wear=5e-5),
    "pressure_angle": part(WHOLE, "gear", module=1.1e-3),
    "mesh_possible": part(WHOLE, "gear", module=2e-3),
    "gear_room": WHOLE,
    "ring_undercut": part(ON_PINS, "gear", ring_pin_circle_radius=0.0436, ring_pin_radius=0.003),
    "ring_pin_room": part(ON_PINS, "gear", ring_pin_radius=0.013),
    "bearing_life": rigid(life=5000 * 3600.0),
    "bearing_static": rigid(static_safety=2.0, peak_torque=1000.0),
    "system_life": part(rigid(), "bearing", weibull_slope=1.1),
    "crank_bearing_life": part(
        rigid(), "crankshaft", bearings=(SeatedBearing(kind="roller", dynamic_rating=15e3),) * 2
    ),
    "unbalance_force": one_at(0.015, max_unbalance=50.0),
    "unbalance_couple": having(WHOLE, max_unbalance_couple=1.0),
    "outer_diameter": having(REF, outer_radius=0.08, max_outer_diameter=0.15),
    "length": having(REF, build=Build(carrier_width=0.02), max_length=0.06),
}  # fmt: skip

FIXED = {
    "contact_pressure_hole": {"contact.pin_radius", "load.pin_circle_radius", "load.output_torque"},
    "pin_static": {"contact.pin_radius", "load.pin_circle_radius", "load.output_torque"},
    "pin_fatigue": {"contact.pin_radius", "load.pin_circle_radius", "load.output_torque"},
    "pin_slope": {"contact.pin_radius", "load.pin_circle_radius", "load.output_torque"},
    "pin_deflection": {"contact.pin_radius", "load.pin_circle_radius", "load.output_torque"},
    "efficiency": {"friction.coefficient", "load.pin_circle_radius"},
    "sliding_speed": {"load.input_speed"},
    "pv": {"load.pin_circle_radius", "load.input_speed", "load.output_torque"},
    "wear": {
        "friction.wear_rate", "load.pin_circle_radius", "load.input_speed", "load.output_torque",
    },
    "pressure_angle": {"gear.module"},
    "mesh_possible": {"gear.module"},
    "gear_room": {"load.pin_circle_radius"},
    "ring_undercut": {
        "gear.ring_pin_radius", "gear.ring_pin_circle_radius", "contact.eccentricity",
    },
    "ring_pin_room": {"gear.ring_pin_radius", "gear.ring_pin_circle_radius"},
    "bearing_life": {"bearing.dynamic_rating", "load.input_speed", "load.output_torque"},
    "bearing_static": {"bearing.static_rating", "load.peak_torque"},
    "system_life": {"bearing.dynamic_rating", "load.input_speed", "load.output_torque"},
    "crank_bearing_life": {
        "crankshaft.bearings.dynamic_rating", "load.input_speed", "load.output_torque",
    },
    "unbalance_force": {"crankshaft.satellite_mass", "load.input_speed"},
    "unbalance_couple": {"crankshaft.satellite_mass", "load.input_speed"},
    "outer_diameter": {"satellite_body.outer_radius"},
    "length": {"build.carrier_width", "contact.contact_length"},
}  # fmt: skip


def judged(code: str, design: Design) -> Check:
    """A check as the verdict on its part of the reducer has it."""
    return crank_verdict(Results(having(design, scope=(CHECKS[code].part,))))[code]


@pytest.mark.parametrize("code", FAILING)
def test_fixes_cure(code: str) -> None:
    design = FAILING[code]
    before = judged(code, design)
    assert before.status == ("marginal" if before.warning else "fail")
    fixes = fixes_of(design, [code])
    solved = [fix for fix in fixes if fix.status == "solved"]
    assert {fix.variable for fix in solved} >= FIXED[code]
    for fix in solved:
        there = vary(design=design, variable=fix.variable, value=fix.after)
        cured = judged(code, there)
        assert cured.status == "pass", fix
        start = value_of(design=design, variable=fix.variable)
        assert start is not None
        if fix.variable in ("mechanism.pins", "satellites") or not cured.torque_reserve:
            continue
        short = fix.exact + (start - fix.exact) * 1e-3  # no more than needed
        there = vary(design=design, variable=fix.variable, value=short)
        assert judged(code, there).status != "pass", fix


def test_a_longer_contact_has_to_stay_off_the_carrier() -> None:
    """The first satellite is at 15 mm: its contact may be 30 mm long, and as long as the pitch."""
    apart = part(having(WHOLE, crankshaft=None), "pin", satellite_positions=(0.015, 0.047))
    for given, limit, allowed in (
        (apart, 1.6e-4, False),
        (apart, 2.0e-4, True),
        (WHOLE, 2.0e-4, False),
    ):
        design = having(given, max_wear=limit)
        fixes = fixes_of(design, ["wear"])
        assert ("contact.contact_length" in {fix.variable for fix in fixes}) == allowed


def test_pins_come_in_standard_sizes() -> None:
    design = FAILING["pin_static"]
    (fix,) = [
        each for each in fixes_of(design, ["pin_static"]) if each.variable == "contact.pin_radius"
    ]
    assert fix.standard and fix.after == 0.010
    sleeved = part(design, "pin", diameter=0.012)
    fixes = {each.variable: each for each in fixes_of(sleeved, ["pin_static"])}
    assert "contact.pin_radius" not in fixes  # that of the sleeve
    assert "pin.diameter" not in fixes  # it would be thicker than the sleeve
    wide = having(sleeved, pin_radius=0.011, hole_radius=0.013)
    fixes = {each.variable: each for each in fixes_of(wide, ["pin_static"])}
    assert fixes["pin.diameter"].standard and fixes["pin.diameter"].after == 0.020


def test_no_pin_is_thicker_than_what_touches_the_hole() -> None:
    with pytest.raises(InvalidInput) as refusal:
        part(WHOLE, "pin", diameter=0.01601)
    assert (refusal.value.parameter, refusal.value.code) == ("pin.diameter", "too_thick")


def test_a_larger_pin_without_sleeve_is_larger_itself() -> None:
    assert vary(design=WHOLE, variable="contact.pin_radius", value=0.01).pin.diameter == 0.02  # type: ignore[union-attr]
    sleeved = part(WHOLE, "pin", diameter=0.011)
    assert vary(design=sleeved, variable="contact.pin_radius", value=0.01).pin == sleeved.pin
    assert vary(design=sleeved, variable="pin.diameter", value=0.01).pin.diameter == 0.01  # type: ignore[union-attr]


def test_a_thicker_pin_in_its_sleeve_lowers_the_pressure() -> None:
    """A thicker pin slopes less; the next standard size leaves no room for the sleeve."""
    sleeved = part(part(WHOLE, "pin", diameter=0.011), "friction", sleeve=True)
    code, design = "contact_pressure_hole", having(sleeved, output_torque=135.0)
    fixes = {each.variable: each for each in fixes_of(design, [code])}
    fix, sleeve = fixes["pin.diameter"], fixes["contact.pin_radius"]
    assert fix.status == "solved" and 0.012 < fix.after < 0.016 and not fix.standard
    assert not sleeve.standard  # it is the sleeve's
    assert sleeve.after == pytest.approx(sleeve.exact, rel=0.01)
    for value, met in ((fix.after, True), (fix.exact * 0.999, False)):
        there = vary(design=design, variable="pin.diameter", value=value)
        assert (crank_verdict(Results(there))[code].status == "pass") == met
    # without the rest of the design that needs the sleeve a standard pin does
    plain = having(design, friction=None)
    (fix,) = (each for each in fixes_of(plain, [code]) if each.variable == "pin.diameter")
    assert fix.standard and fix.after == 0.016
