"""Checks of involute teeth in their ring, against points, circles and outlines, held numbers, and
what a design does to their load.
"""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_checks
from core.contact_life import life_factor
from core.design.document import Design
from core.design.results import Results
from core.design.ring import InvoluteRing, OtherRing
from core.design.sections import Friction
from core.errors import NotKnown
from core.hertz import ContactLimit, ElasticMaterial
from core.output.elasticity import Shares
from core.output.room import Deviations
from core.precision import EXACT, SAME
from core.ring.involute import HEIGHTS
from tests.inputs.checks import REF, check_of, design_of, having
from tests.oracles import involute as oracle

STEEL = ElasticMaterial(210e9, 0.3, ContactLimit("given", 1500e6))
FORTY = oracle.Pair(40, 42, 3.0, 0.0, 0.365, 0.8, 0.8, e=3.68)
"""40 in 42 teeth of a module of 3 mm, in millimetres."""


def of(pair: oracle.Pair, **more: Any) -> Design:
    """A design of one satellite with these teeth; other values by their names."""
    assert pair.e is not None
    cutter = {} if pair.cutter is None else {"cutter_teeth": pair.cutter}
    ring = InvoluteRing(
        module=pair.m / 1e3,
        teeth_difference=pair.z_r - pair.z_s,
        reference_pressure_angle=pair.alpha,
        satellite_profile_shift=pair.x_s,
        ring_profile_shift=pair.x_r,
        satellite_addendum=pair.h_as,
        ring_addendum=pair.h_ar,
        dedendum=pair.h_f,
        rack_tip_radius=pair.rho_f,
        ring_material=STEEL,
        **cutter,
    )
    design = design_of(
        pins=8,
        satellites=1,
        ratio=pair.z_s / (pair.z_r - pair.z_s),
        output_torque=200.0,
        pin_circle_radius=0.037,
        contact_length=0.022,
        pin_radius=0.007,
        hole_radius=0.007 + pair.e / 1e3,
        eccentricity=pair.e / 1e3,
        pin_material=STEEL,
        hole_material=STEEL,
        gear=ring,
    )
    return having(design, **more)


def geared(design: Design, /, **changes: Any) -> Design:
    """A design with another ring."""
    return having(design, gear=replace(design.gear, **changes))  # type: ignore[type-var]


LOW = oracle.Pair(40, 42, 3.0, -0.95, -0.8694, 0.325, 0.325, e=3.2)
"""Of an eccentricity at which no usual teeth mesh."""

PAIRS = (
    FORTY,
    LOW,
    replace(FORTY, cutter=20, h_as=0.75, x_s=0.1, x_r=0.48),
    replace(FORTY, h_ar=0.9, h_f=1.3, rho_f=0.3, e=3.62),
    oracle.Pair(40, 41, 2.5, 0.0, 0.6, 0.8, 0.75, e=2.003),
    oracle.Pair(60, 64, 2.0, 0.2, 0.4, 0.8, 0.8, e=4.3, cutter=30),
    oracle.Pair(30, 31, 3.0, 0.3, 0.95, 0.9, 0.85, alpha=math.radians(25), rho_f=0.3, e=2.6),
)


@pytest.mark.parametrize("pair", PAIRS)
def test_values_are_those_of_points_and_circles(pair: oracle.Pair) -> None:
    own = {name: float(value) for name, value in oracle.geometry(pair).items()}
    design, m = of(pair), pair.m
    root = m * (pair.z_r / 2 + pair.x_r + pair.h_f)
    clearance = (
        own.get("ring_root_radius", root) - pair.e - float(pair.tips[0]),
        float(pair.tips[1]) - pair.e - m * (pair.z_s / 2 + pair.x_s - pair.h_f),
    )
    room = own["start_roll_satellite"] - own["form_roll_satellite"]
    if pair.cutter is not None:
        room = min(room, own["form_roll_ring"] - own["end_roll_ring"])
    backlash = own["normal_backlash"] / (m * pair.z_s / 2 * math.cos(pair.alpha))
    for code, value in (
        ("mesh_contact_ratio", own["contact_ratio"]),
        ("mesh_tips", own["tip_interference"]),
        ("mesh_involute", room),
        ("mesh_undercut", own["form_roll_satellite"]),
        ("mesh_tip_clearance", min(clearance) / m),
        (
            "mesh_tip_thickness",
            min(own["satellite_tip_thickness"], own["ring_tip_thickness"]) / m,
        ),
        ("ring_pressed", max(-own["normal_backlash"] / 1e3, 0.0)),
        ("ring_backlash", max(backlash, 0.0)),
    ):
        assert check_of(code, design).value == pytest.approx(value, rel=EXACT, abs=1e-13), code
    ring = check_of("ring_backlash", having(design, output="ring")).value
    u = design.mechanism.ratio
    assert ring == pytest.approx(max(backlash, 0.0) * u / (u + 1), rel=EXACT)


def found(code: str, pair: oracle.Pair) -> tuple[str, bool, str]:
    check = check_of(code, of(pair))
    return check.status, check.impossible, check.reason


USUAL = ("marginal", False, "less_than_usual")


def test_low_teeth_mesh_where_usual_ones_fail() -> None:
    """With hardly any room at tips and roots, which a little more height of the ring takes."""
    assert found("mesh_tips", LOW) == USUAL
    for code in ("mesh_contact_ratio", "mesh_undercut", "mesh_involute"):
        assert found(code, LOW)[0] == "pass"
    higher = replace(LOW, h_ar=0.36)
    for other in (higher, replace(LOW, x_s=0.0, x_r=0.0806, h_as=0.8, h_ar=0.8)):
        assert found("mesh_tips", other) == ("fail", True, "")
    assert found("mesh_involute", higher) == ("fail", False, "")


def between(name: str, ends: tuple[float, float], code: str, wanted: float) -> float:
    """Value of a field of the pair at which a check has a value, by halving."""
    low, high = ends
    rising = (check_of(code, of(replace(FORTY, **{name: high}))).value or 0) > wanted
    for _ in range(60):
        middle = (low + high) / 2
        above = (check_of(code, of(replace(FORTY, **{name: middle}))).value or 0) > wanted
        low, high = (low, middle) if above == rising else (middle, high)
    return (low + high) / 2


@pytest.mark.parametrize(
    ("code", "name", "ends", "guide", "least", "beyond"),
    [
        ("mesh_contact_ratio", "h_as", (0.31, 0.8), 1.05, 1.0, ("fail", False, "")),
        ("mesh_tips", "x_r", (0.3, 0.4), 0.05, 0.0, ("fail", True, "")),
        ("mesh_tip_clearance", "h_f", (0.5, 1.25), 0.15, 0.0, ("fail", True, "")),
    ],
)
def test_below_its_guide_a_value_is_marginal_and_below_what_must_be_it_fails(
    code: str,
    name: str,
    ends: tuple[float, float],
    guide: float,
    least: float,
    beyond: tuple[str, bool, str],
) -> None:
    at = {wanted: between(name, ends, code, wanted) for wanted in (guide, least)}
    good = ("pass", False, "ring_root_assumed" if code == "mesh_tip_clearance" else "")
    step = 1e-6
    for wanted, above, below in ((guide, good, USUAL), (least, USUAL, beyond)):
        for away, expected in ((step, above), (-step, below)):
            pair = replace(FORTY, **{name: at[wanted] + away})
            check = check_of(code, of(pair))
            assert (check.status, check.impossible, check.reason) == expected
            assert check.limit == guide and check.value == pytest.approx(wanted, abs=1e-4)


def test_thin_tips_are_marginal_and_pointed_ones_impossible() -> None:
    """20 teeth, whose tips get pointed as they are moved outwards."""

    def at(shift: float) -> Check:
        slim = oracle.Pair(20, 22, 3.0, shift, shift + 0.365, 1.2, 0.5, e=3.68)
        return check_of("mesh_tip_thickness", of(slim))

    for wanted, above, below in ((0.25, "pass", "marginal"), (0.0, "marginal", "fail")):
        low, high = 0.0, 2.5
        for _ in range(50):
            middle = (low + high) / 2
            low, high = (middle, high) if (at(middle).value or -1) > wanted else (low, middle)
        assert (at(low - 1e-6).status, at(high + 1e-6).status) == (above, below)
    assert at(high + 0.1).impossible


def test_tips_that_overlap_all_round_fail() -> None:
    """r_as > r_ar + e: the arccosine has no value there, and that is no room."""
    tall = oracle.Pair(40, 41, 2.5, 0.0, 0.0, 1.0, 1.0, e=1.2)
    check = check_of("mesh_tips", of(tall))
    assert (check.status, check.impossible, check.reason) == ("fail", True, "tips_overlap")
    assert oracle.least_gap(tall, e=1.2) < 0
    far = oracle.Pair(40, 42, 3.0, 0.0, 1.0, 0.3, 0.3, e=3.0)
    assert float(far.tips[1]) > float(far.tips[0]) + 3.0
    assert check_of("mesh_tips", of(far)).reason == "no_crossing"
    assert check_of("mesh_contact_ratio", of(far)).status == "fail"


def test_room_of_the_tips_ends_where_outlines_touch() -> None:
    """Least gap of all pairs over a turn, without backlash: of one sign with G."""
    for x_r in (0.25, 0.45):
        pair = replace(FORTY, x_r=x_r, e=None)
        e = float(oracle.geometry(pair)["eccentricity_without_backlash"])
        check = check_of("mesh_tips", of(replace(pair, e=e)))
        assert check.value is not None
        assert (check.value > 0) == (oracle.least_gap(pair, e=e) > -1e-9)


def test_flanks_that_are_no_involutes_fail() -> None:
    early = replace(FORTY, h_ar=0.95, x_r=0.2)
    assert found("mesh_involute", early) == ("fail", False, "")
    assert found("mesh_involute", FORTY) == ("pass", False, "ring_flank_unknown")
    assert check_of("mesh_involute", of(FORTY)).missing == ("gear.cutter_teeth",)
    sharp = replace(FORTY, cutter=20)
    assert found("mesh_involute", sharp) == ("pass", False, "")
    assert found("mesh_tip_clearance", FORTY) == ("pass", False, "ring_root_assumed")
    assert check_of("mesh_tip_clearance", of(FORTY)).missing == ("gear.cutter_teeth",)
    assert found("mesh_tip_clearance", sharp) == ("pass", False, "")
    worn = geared(of(sharp), cutter_addendum=0.5)  # which does not reach so far
    assert check_of("mesh_involute", worn).status == "fail"
    few = oracle.Pair(12, 14, 3.0, 0.0, 0.365, 0.8, 0.35, e=3.68)
    assert found("mesh_undercut", few) == ("fail", False, "")
    assert found("mesh_undercut", FORTY) == ("pass", False, "")


@pytest.mark.parametrize(
    ("changes", "code", "reason"),
    [
        ({"ring_addendum": 1.15, "ring_profile_shift": -0.2}, "mesh_involute", "less_than"),
        ({"ring_profile_shift": -0.9, "ring_addendum": 0.3}, "ring_pressed", "greater_than"),
    ],
)
def test_teeth_that_cannot_be_fail(changes: dict[str, Any], code: str, reason: str) -> None:
    """A tip within its base circle; spaces that are too narrow at any eccentricity."""
    check = check_of(code, geared(of(replace(FORTY, h_as=0.3)), **changes))
    assert (check.status, check.impossible, check.reason) == ("fail", True, reason)


def test_teeth_press_beyond_the_eccentricity_at_which_they_fill_their_spaces() -> None:
    free = float(oracle.geometry(FORTY)["eccentricity_without_backlash"])
    for e, status in ((free - 1e-3, "pass"), (free, "pass"), (free + 1e-3, "fail")):
        check = check_of("ring_pressed", of(replace(FORTY, e=e)))
        assert check.status == status and check.torque_reserve is None
        assert ((check.value or 0) > 0) == (status == "fail")
    assert check_of("ring_backlash", of(replace(FORTY, e=free + 1e-3))).value == 0.0


B1 = having(
    of(oracle.Pair(40, 41, 2.5, 0.0, 0.58, 0.8, 0.8, e=2.003027285823322)),
    output_torque=150.0,
    contact_length=0.015,
)
"""A held pair: 237.18 MPa at the start of its path, 294.37 MPa in its root."""


def test_pressure_is_that_of_the_held_pair() -> None:
    for code in ("ring_pressure_pin", "ring_pressure_disc"):
        check = check_of(code, B1)
        assert check.value == pytest.approx(237.1761915902869e6, rel=EXACT)
        assert not check.solved and check.limit == pytest.approx(1500e6 / 1.2)
        assert check.torque_reserve == pytest.approx((1250 / 237.1761915902869) ** 2, rel=EXACT)
    factors = having(geared(B1, face_load_factor=1.3), application_factor=1.5)
    worse = check_of("ring_pressure_pin", factors).value
    assert worse == pytest.approx(math.sqrt(1.95) * 237.1761915902869e6, rel=EXACT)
    narrow = check_of("ring_pressure_pin", geared(B1, contact_length=0.015 / 4)).value
    assert narrow == pytest.approx(2 * 237.1761915902869e6, rel=EXACT)


def test_limits_are_those_of_each_body_over_its_own_loads() -> None:
    """A tooth of the ring is loaded once a turn of the crank, one of the satellite once a turn
    against it.
    """
    speed, life = 100.0, 3e6
    cured = replace(STEEL, limit=ContactLimit("given", 1e9, curve="hardened"))
    nitrided = replace(STEEL, limit=ContactLimit("given", 2e9, curve="nitrided"))
    design = having(
        geared(B1, ring_material=cured),
        hole_material=nitrided,
        input_speed=speed,
        life=life,
        pitting_safety=1.25,
    )
    loads = speed * life / (2 * math.pi)
    pin, disc = (check_of(f"ring_pressure_{body}", design) for body in ("pin", "disc"))
    cycles = (("hardened", 1e9, loads, pin), ("nitrided", 2e9, loads * (1 + 1 / 40), disc))
    for curve, limit, often, check in cycles:
        factor = life_factor(curve=curve, loads=often)  # type: ignore[arg-type]
        assert check.limit == pytest.approx(limit * factor / 1.25, rel=SAME)
    unknown = check_of("ring_pressure_pin", geared(B1, ring_material=replace(STEEL, limit=None)))
    assert unknown.missing == ("gear.ring_material.allowable_pressure",)
    given = geared(B1, satellite_material=replace(nitrided, limit=ContactLimit("given", 2e9)))
    assert check_of("ring_pressure_disc", given).limit == pytest.approx(2e9 / 1.2)


def test_the_peak_torque_is_held_against_static_limits() -> None:
    assert check_of("ring_static_pin", B1).status == "not_asked"
    dents = replace(STEEL, static_pressure=4e9)
    design = having(geared(B1, ring_material=dents, face_load_factor=1.2), peak_torque=600.0)
    pin, disc = (check_of(f"ring_static_{body}", design) for body in ("pin", "disc"))
    assert pin.value == pytest.approx(math.sqrt(4 * 1.2) * 237.1761915902869e6, rel=EXACT)
    assert (pin.limit, disc.limit) == (4e9, 1500e6)


def test_the_root_is_held_against_the_strength_that_is_given() -> None:
    check = check_of("mesh_root_stress", B1)
    stress = 294.3710721324621e6
    assert check.value == pytest.approx(stress, rel=EXACT)
    assert (check.status, check.reason) == ("not_checked", "root_strength_unknown")
    assert not check.needed and check.missing == ("gear.root_strength",)
    strong = having(geared(B1, root_strength=600e6, face_load_factor=1.1), application_factor=1.2)
    judged = check_of("mesh_root_stress", strong)
    assert judged.value == pytest.approx(1.32 * stress, rel=EXACT)
    assert (judged.limit, judged.status) == (600e6 / 1.5, "marginal")
    assert judged.torque_reserve == pytest.approx(400e6 / (1.32 * stress), rel=EXACT)
    weak = having(strong, fatigue_safety=1.6)
    assert check_of("mesh_root_stress", weak).status == "fail"
    ring = check_of("mesh_ring_root", strong)
    assert (ring.status, ring.reason, ring.needed) == ("not_checked", "internal_root", False)


def test_satellites_carry_on_their_teeth_what_their_pins_do() -> None:
    """Evenly of perfect parts; by what is stated or solved else."""
    one = check_of("ring_pressure_pin", B1).value or 0.0
    two = having(B1, satellites=2)
    assert check_of("ring_pressure_pin", two).value == pytest.approx(one / math.sqrt(2), rel=EXACT)
    stated = check_of("ring_pressure_pin", having(two, distribution_factor=1.3)).value
    assert stated == pytest.approx(one * math.sqrt(0.65), rel=EXACT)
    given = having(two, satellite_coupling=Shares((0.7, 0.3)))
    found = check_of("ring_pressure_pin", given)
    assert found.value == pytest.approx(one * math.sqrt(0.7), rel=1e-3) and found.solved
    loose = having(
        two,
        hole_radius=two.nominal_pair.hole_radius + 2e-5,
        deviations=Deviations(disc_phase=(2e-4, 0.0)),
    )
    results = Results(loose)
    assert results.solved
    most = abs(results.made(150.0).couple).max()
    found = check_of("ring_pressure_pin", loose)
    assert found.value == pytest.approx(one * math.sqrt(most / 150.0), rel=EXACT)
    assert most > 1.02 * 75.0
    more = having(loose, application_factor=2.0)
    most = abs(results.made(300.0).couple).max()
    there = check_of("ring_pressure_pin", more).value
    assert there == pytest.approx(one * math.sqrt(most / 150.0), rel=EXACT)
    back = check_of("ring_pressure_pin", having(loose, torque_direction="reverse")).value
    both = check_of("ring_pressure_pin", having(loose, torque_direction="alternating")).value
    assert both == max(found.value or 0.0, back or 0.0)


def test_what_slides_on_the_flanks_lowers_the_efficiency() -> None:
    design = having(B1, friction=Friction(coefficient=0.05), input_speed=100.0, min_efficiency=0.5)
    alone, both = (
        check_of("efficiency", each).value or 0.0
        for each in (design, geared(design, friction_coefficient=0.06))
    )
    # by the slopes of a straight line over the path: from 6.5 to 5.4 % of the output
    own = oracle.geometry(oracle.Pair(40, 41, 2.5, 0.0, 0.58, 0.8, 0.8, e=2.003027285823322))
    middle = (float(own["start_roll_satellite"]) + float(own["end_roll"])) / 2
    lost = 0.06 * (math.tan(float(own["angle"])) - middle)
    assert 1 / both == pytest.approx(1 / alone + lost, rel=EXACT)
    rubbing = having(geared(design, friction_coefficient=0.06), min_ring_efficiency=0.95)
    teeth = check_of("ring_efficiency", rubbing)
    assert teeth.value == pytest.approx(1 / (1 + lost), rel=EXACT) and teeth.status == "fail"
    unknown = geared(design, friction_coefficient=0.06, ring_profile_shift=None)
    assert check_of("efficiency", unknown).reason == "teeth_not_judged"


def teeth_of(design: Design) -> tuple[str, str, tuple[str, ...]]:
    (part,) = (each for each in crank_checks(Results(design)).parts if each.code == "teeth")
    return part.status, part.reason, part.missing


def test_teeth_are_judged_where_all_that_they_need_is_known() -> None:
    good = having(of(FORTY), scope=("teeth",))
    assert teeth_of(good) == ("pass", "", ())
    for name in ("satellite_profile_shift", "ring_profile_shift", "ring_addendum"):
        lacks = geared(good, **{name: None})
        assert teeth_of(lacks) == ("open", "teeth_not_judged", (f"gear.{name}",))
        assert check_of("mesh_possible", lacks).status == "pass"
    assert check_of("mesh_possible", good).reason == "teeth_given"
    for open_, reason in (
        (geared(good, reference_pressure_angle=math.radians(14)), "outside_method"),
        (having(good, ratio=20.25), "ratio_not_whole"),
        (geared(good, ring_material=replace(STEEL, limit=None)), "limit_unknown"),
        (having(good, max_transmission_error=1.0), "tooth_errors_unknown"),
        (having(good, satellites=2, clearance_stated=False), "clearance_unknown"),
    ):
        assert teeth_of(open_)[:2] == ("open", reason)
    alone = having(good, clearance_stated=False)  # carries all of the torque, whatever its pins do
    assert teeth_of(alone)[0] == "pass"
    for bad in (
        geared(good, ring_addendum=1.0),
        geared(good, ring_profile_shift=0.3),
        having(good, output_torque=9000.0),
    ):
        assert teeth_of(bad)[0] == "fail"
    slim = geared(good, satellite_addendum=0.65, ring_addendum=0.65)
    assert teeth_of(slim)[0] == "marginal"


def test_a_path_that_starts_off_the_involute_has_no_pressure() -> None:
    early = of(oracle.Pair(20, 22, 3.0, 0.0, 0.365, 0.3, 1.0, e=3.68))
    assert Results(early).ring.pair.start_roll_satellite < 0
    check = check_of("ring_pressure_pin", early)
    assert (check.status, check.reason) == ("not_checked", "off_involutes")
    assert teeth_of(having(early, scope=("teeth",)))[0] == "fail"


@pytest.mark.parametrize(
    ("addendum", "code", "limit"), [(0.1, "greater_than_equal", 0), (9.0, "less_than_equal", 1)]
)
def test_heights_that_no_tooth_has_are_refused(addendum: float, code: str, limit: int) -> None:
    with pytest.raises(NotKnown) as refusal:
        _ = Results(geared(of(FORTY), ring_addendum=addendum)).ring.pair
    assert refusal.value.refusal is not None
    assert (refusal.value.code, refusal.value.refusal.parameter) == (code, "gear.ring_addendum")
    assert refusal.value.refusal.params == {"limit": HEIGHTS[limit]}


def test_only_involute_teeth_have_these() -> None:
    other = having(REF, gear=OtherRing(kind="none"), load=REF.load)
    for check in crank_checks(Results(other)).checks:
        assert not check.code.startswith("mesh_") or check.status == "not_applicable"


def test_roots_are_where_the_shift_puts_them() -> None:
    design = of(replace(FORTY, x_s=0.2, h_f=1.3))
    assert design.roots == (pytest.approx(3e-3 * (20 + 0.2 - 1.3)),) * 2
