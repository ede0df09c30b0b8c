"""Parts of a reducer: what each comes to, what opens it, and the verdict of all."""

import itertools
import re
from dataclasses import replace
from typing import Any, get_args

import pytest

from core.checks.check import PartStatus, PartVerdict, whole
from core.checks.crank_planetary import CRANK_CHECKS, PARTS, crank_checks
from core.checks.reserve import crank_verdict
from core.checks.usual_fit import usual_fit
from core.codes import REFUSALS
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing, OtherRing
from core.design.sections import PART_NAMES, RollingBearing, SeatedBearing
from core.design.tolerances import ToleranceSection
from core.hertz import ContactLimit, ElasticMaterial
from core.material_table import MATERIALS
from core.precision import EXACT, SAME
from core.ring.profile import Modification
from core.tolerance.iso286 import CLASSES, fit_clearance
from tests.inputs.checks import HOLE, PIN, REF, WHOLE, check_of, having

CATALOGUE = {
    "kind": "ball",
    "dynamic_rating": 18e3,
    "bore_diameter": 0.03,
    "outer_diameter": 0.062,
    "width": 0.016,
}
BEARING = RollingBearing(**CATALOGUE, static_rating=11e3)
SHAFT = replace(
    WHOLE.crankshaft,
    bearings=(SeatedBearing(**CATALOGUE),) * 2,
)
SOUND = having(
    WHOLE,
    hole_radius=0.01002,
    output_torque=60.0,
    gear=CycloidRing(
        ring_pin_circle_radius=0.1,
        ring_pin_radius=0.004,
        modification=Modification(equidistant=5e-6),
        pin_material=PIN,
        friction_coefficient=0.02,
    ),
    bearing=BEARING,
    crankshaft=SHAFT,
    min_efficiency=0.5,
    satellite_body=replace(REF.satellite_body, root_radius=0.09, bore_radius=0.0325),
    tolerances=ToleranceSection(ring_pin_position=0.0),
)
"""All of its parts hold."""
UNMODIFIED = having(SOUND, gear=replace(SOUND.gear, modification=None))  # type: ignore[type-var]
"""The same where nothing is known of the modification of its discs."""


def statuses(design: Design) -> dict[str, str]:
    return {each.code: each.status for each in crank_verdict(Results(design)).parts}


def reasons(design: Design) -> dict[str, str]:
    return {each.code: each.reason for each in crank_verdict(Results(design)).parts if each.reason}


def test_all_parts_of_a_sound_design_pass() -> None:
    found = crank_verdict(Results(SOUND))
    assert {each.status for each in found.parts} == {"pass"}, found.parts
    assert found.verdict == "pass" and "teeth" in found.largest_torque_of


def test_teeth_whose_modification_is_not_known_are_open() -> None:
    found = crank_verdict(Results(UNMODIFIED))
    opened = {each.code: each.status for each in found.parts}
    # What the teeth load is not known either, and losses are of teeth too.
    unknown = ("teeth", "satellite_bearing", "crank_bearings", "losses")
    assert opened == dict.fromkeys(PARTS, "pass") | dict.fromkeys(unknown, "open"), found.parts
    assert reasons(UNMODIFIED) == dict.fromkeys(unknown, "modification_unknown")
    assert found.verdict == "incomplete"
    judged = having(UNMODIFIED, scope=tuple(part for part in PART_NAMES if part not in unknown))
    alone = crank_verdict(Results(judged))
    assert alone.verdict == "pass" and statuses(judged)["teeth"] == "left_out"
    assert {*alone.largest_torque_of} == {"contact", "pins"}
    assert "teeth" in alone.not_considered and "body" not in alone.not_considered


@pytest.mark.parametrize("part", PART_NAMES)
def test_a_part_by_itself(part: str) -> None:
    """Only the part's checks are made, and the verdict follows from them."""
    design = having(SOUND, scope=(part,))
    found = crank_verdict(Results(design))
    assert found.verdict == "pass"
    assert {each.kind.part for each in found.checks} == {part}
    assert [each.code for each in found.parts if each.status != "left_out"] == [part]


SECTIONS: dict[str, tuple[str, ...]] = {
    "pin": ("pins",),
    "gear": ("teeth", "satellite_bearing", "crank_bearings"),
    "bearing": ("satellite_bearing",),
    "crankshaft": ("crank_bearings",),
    "satellite_body": ("body",),
}


@pytest.mark.parametrize("section", SECTIONS)
def test_a_section_that_is_not_given_opens_its_parts(section: str) -> None:
    fatigue = {"fatigue": None} if section == "pin" else {}
    found = crank_verdict(Results(having(SOUND, **{section: None}, **fatigue)))
    opened = {each.code: each for each in found.parts if each.status == "open"}
    assert {*opened} == {*SECTIONS[section]}
    for part in SECTIONS[section]:
        assert opened[part].reason == "section_missing" and section in opened[part].missing


def test_losses_that_nobody_asks_for_open_nothing() -> None:
    nobody = having(SOUND, friction=None, min_efficiency=None)
    assert statuses(nobody)["losses"] == "not_asked"
    assert statuses(having(SOUND, friction=None))["losses"] == "open"
    unjudged = crank_checks(Results(having(SOUND, min_efficiency=None)))
    (losses,) = (each for each in unjudged.parts if each.code == "losses")
    assert (losses.status, losses.reason) == ("not_asked", "")  # friction alone asks nothing


NEEDED: dict[str, tuple[str, str, str]] = {
    # what is taken away, its part, why that is open
    "fatigue": ("fatigue", "pins", "section_missing"),
    "bore": ("satellite_body.bore_radius", "body", "size_missing"),
    "speed": ("load.input_speed", "satellite_bearing", "speed_missing"),
    "static rating": ("bearing.static_rating", "satellite_bearing", "rating_unknown"),
    "crank bearings": ("crankshaft.bearings", "crank_bearings", "rating_unknown"),
}


@pytest.mark.parametrize("name", NEEDED)
def test_what_a_part_needs_opens_it(name: str) -> None:
    path, part, reason = NEEDED[name]
    bearing = replace(BEARING, outer_diameter=None) if name == "bore" else SOUND.bearing
    design = having(SOUND, bearing=bearing)
    nothing = () if name == "crank bearings" else None
    found = crank_verdict(Results(having(design, **{path: nothing})))
    (opened,) = (each for each in found.parts if each.code == part)
    assert (opened.status, opened.reason) == ("open", reason)
    assert found.verdict == "incomplete"


def test_a_material_without_a_limit_opens_the_contact() -> None:
    unknown = having(SOUND, hole_material=ElasticMaterial(118e9, 0.3, yield_strength=500e6))
    assert reasons(unknown)["contact"] == "limit_unknown"
    found = crank_verdict(Results(unknown))
    assert (found.torque_reserve, found.largest_torque_of) == (None, ())
    worse = having(unknown, output_torque=5000.0)  # open never hides a fail
    assert statuses(worse)["contact"] == "fail"


def test_a_ring_without_teeth_leaves_them_out_and_opens_the_bearings() -> None:
    toothless = having(SOUND, gear=OtherRing(kind="none"))
    assert statuses(toothless)["teeth"] == "left_out"
    bearings = {"satellite_bearing": "no_ring_force", "crank_bearings": "no_ring_force"}
    assert reasons(toothless) == bearings
    assert reasons(having(SOUND, gear=OtherRing(radial_force_ratio=0.3))) == {
        "teeth": "teeth_not_judged",
        "losses": "ring_friction_unknown",
    }


BY_FORCES = {part.code for part in PARTS.values() if part.by_forces}


def unknown(design: Design) -> Design:
    """Design of equal sizes without a stated clearance."""
    return having(design, hole_radius=0.010, clearance_stated=False)


def test_a_clearance_that_is_not_known_opens_what_reads_forces() -> None:
    assert {each for each in PARTS if each not in ("teeth", "body")} == BY_FORCES
    found = crank_verdict(Results(unknown(SOUND)))
    assert reasons(unknown(UNMODIFIED)) == dict.fromkeys(BY_FORCES, "clearance_unknown") | {
        "teeth": "modification_unknown"
    }
    assert not found.largest_torque_known and found.largest_torque_of == ()
    assert found.torque_reserve is None
    perfect = having(unknown(SOUND), clearance_stated=True)
    assert statuses(perfect)["contact"] == "pass"
    alone = having(unknown(SOUND), eccentricity=None)
    assert reasons(alone)["contact"] == "clearance_unknown"
    for code in ("interference", "clearance", "backlash"):
        check = check_of(code, having(unknown(SOUND), max_backlash=1.0))
        assert (check.status, check.missing) == ("not_checked", ("contact.hole_clearance",))


def test_a_part_of_an_unknown_clearance_fails_where_it_fails_both_ways() -> None:
    """By pins that bend and by equal sharing: the far satellite's pin breaks by the one alone."""
    bent = unknown(having(WHOLE, contact_law=None))
    torque = 500.0
    seen = set()
    for times in (0.3, 1.0, 1.65, 2.0, 4.0):
        design = having(bent, output_torque=torque * times)
        found = crank_verdict(Results(design))["pin_static"]
        solved = check_of("pin_static", design).status
        equal = Results(design).equal
        assert equal.design is design
        other = CRANK_CHECKS["pin_static"].of(design, equal).status
        seen.add((solved, other))
        if solved == other:
            assert found.status == solved
        elif "fail" in (solved, other):
            assert (found.status, found.reason) == ("not_checked", "clearance_unknown")
        else:
            assert found.status == other
    assert len(seen) >= 3 and any("fail" in each and len({*each}) == 2 for each in seen), seen


def test_the_verdict_of_parts() -> None:
    names: tuple[PartStatus, ...] = get_args(PartStatus)
    for one, other in itertools.product(names, repeat=2):
        found = whole(PartVerdict(code="pins", status=each) for each in (one, other))
        order = ("fail", "open", "marginal", "pass")
        first = next((each for each in order if each in (one, other)), "open")
        assert found == {"open": "incomplete"}.get(first, first), (one, other)


def test_every_check_of_a_reducer_belongs_to_a_part() -> None:
    assert {kind.part for kind in CRANK_CHECKS.values()} == {*PARTS} == {*PART_NAMES}


@pytest.mark.parametrize("share", [0.9, 1.1])
def test_the_contact_at_the_peak_torque_by_the_static_limit(share: float) -> None:
    """Hertz's pressure grows with the root of the torque: 8 times, of 5.3 times the pressure at
    the working torque with its factor.
    """
    steel = MATERIALS["steel_case_hardened"].material
    plain = having(REF, pin_material=steel, hole_material=steel, application_factor=1.5)
    pressure = check_of("contact_pressure_pin", plain).value
    assert pressure is not None
    at_peak = pressure * (8 / 1.5) ** 0.5
    design = having(plain, peak_torque=8 * 500.0)
    limited = replace(steel, static_pressure=share * at_peak)
    for body in ("pin", "hole"):
        judged = having(design, **{f"{body}_material": limited})
        found = check_of(f"contact_static_{body}", judged)
        assert found.value == pytest.approx(at_peak, rel=EXACT)
        assert found.status == ("fail" if share < 1 else "pass")
        assert found.torque_reserve == pytest.approx(share**2, rel=EXACT)
        nobody = check_of(f"contact_static_{body}", plain)
        assert (nobody.status, nobody.missing) == ("not_asked", ("load.peak_torque",))
        # what a material without a static limit bears for many loads it bears once
        lasting = replace(PIN, limit=ContactLimit("given", share * at_peak))
        found = check_of(f"contact_static_{body}", having(design, **{f"{body}_material": lasting}))
        if share > 1:
            assert (found.status, found.criterion) == ("pass", "given")
            assert found.limit == pytest.approx(share * at_peak, rel=SAME)
        else:
            assert (found.status, found.reason) == ("not_checked", "static_limit_unknown")
        limitless = having(design, **{f"{body}_material": replace(PIN, limit=None)})
        assert check_of(f"contact_static_{body}", limitless).reason == "limit_unknown"
    # with clearance the forces are those that are solved at the peak
    loose = having(design, hole_radius=0.01003)
    there = having(loose, output_torque=8 * 500.0 / 1.5, peak_torque=None)
    assert check_of("contact_static_pin", loose).value == pytest.approx(
        check_of("contact_pressure_pin", there).value, rel=EXACT
    )


def test_beyond_a_static_limit_that_is_not_known_no_reserve_is_stated() -> None:
    strong = {"pin.material": ElasticMaterial(210e9, 0.3, yield_strength=5e9)}
    design = having(SOUND, scope=("contact", "pins"), **strong)
    assert crank_verdict(Results(design), largest=True).torque_reserve is not None
    found = crank_verdict(Results(having(design, peak_torque=60.0 * 30)), largest=True)
    assert [each.reason for each in found.parts if each.code == "contact"] == [
        "static_limit_unknown"
    ]
    assert (found.torque_reserve, found.largest_torque_of) == (None, ())


def test_the_usual_fit_is_the_design_with_its_clearance() -> None:
    design = unknown(SOUND)
    found = usual_fit(design)
    assert found is not None
    results, judged = found.results, found.judged
    # H7 of 20 mm 0..21 um, f7 of 16 mm -34..-16 um: (10.5 + 25)/2 um
    assert found.name == "H7/f7"
    assert results.design.clearance == pytest.approx(17.75e-6, rel=EXACT)
    stated: dict[str, Any] = {"hole_radius": 0.010 + 17.75e-6, "clearance_stated": True}
    same, usual = (
        crank_verdict(each, largest=True) for each in (Results(having(design, **stated)), results)
    )
    assert usual.torque_reserve == pytest.approx(same.torque_reserve, rel=EXACT)
    assert judged.verdict == same.verdict == usual.verdict
    soft = having(design, hole_material=replace(HOLE, youngs_modulus=3e9))
    printed = usual_fit(soft)
    assert printed is not None and printed.name == "printed"
    assert printed.hole_clearance == pytest.approx(0.25e-3, rel=EXACT)
    assert usual_fit(having(design, hole_radius=0.01001)) is None
    limit = ContactLimit("given", 600e6)
    assert usual_fit(having(design, hole_material=replace(HOLE, limit=limit))) is not None


@pytest.mark.parametrize(
    ("fit", "hole", "pin", "clearance"),
    [  # by the tables of ISO 286-1 in micrometres, half of the difference of the middles
        ("H7/f7", 24e-3, 18e-3, (21 / 2 + (16 + 34) / 2) / 2),
        ("H7/g6", 24e-3, 18e-3, (21 / 2 + (6 + 17) / 2) / 2),
        ("H8/h7", 52e-3, 48e-3, (46 / 2 + 25 / 2) / 2),
        ("F8/h6", 12e-3, 10e-3, ((16 + 43) / 2 + 9 / 2) / 2),
        ("H7/m6", 14e-3, 10e-3, (18 / 2 - (6 + 15) / 2) / 2),
    ],
)
def test_the_mean_clearance_of_a_fit(fit: str, hole: float, pin: float, clearance: float) -> None:
    found = fit_clearance(fit=fit, hole_diameter=hole, pin_diameter=pin)
    assert found == pytest.approx(clearance * 1e-6, rel=EXACT)


def test_a_fit_that_is_not_known_is_told_which_are() -> None:
    """H8/e8 is a class of ISO 286, too."""
    assert {*CLASSES} <= {*re.findall(r"\w+", REFUSALS["no_fit"].text)}
