"""Rolling bearings as rollers on the pins: loads, ratings, clearance, losses, checks."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.checks.usual_fit import usual_clearance
from core.crank.pin_rollers import UNKNOWN_ELEMENTS, PinRollers, unsupported_shares
from core.design.document import Design
from core.design.results import Results
from core.design.sections import Friction, Rollers
from core.errors import InvalidInput
from core.output.contact_force import force_ratios, reference_force
from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.pin_beam import PinBeam
from core.output.turn import Turn
from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.checks import WHOLE, check_of, fixes_of, having
from tests.inputs.loads import pin_rollers
from tests.oracles.pin_rollers import ring_speed, shares

SMALL: dict[str, Any] = {
    "mechanism": Mechanism.evenly_spaced(pins=6, satellites=2, ratio=15.0),
    "output_torque": 4.05,
    "pin_circle_radius": 0.024,
    "eccentricity": 1.5e-3,
    "pin_radius": 6.5e-3,
    "input_speed": 10 * math.pi,
    "kind": "ball",
    "dynamic_rating": 1080.0,
    "static_rating": 440.0,
    "rolling_elements": 8,
}
"""Bearings 686 on the pins of a printed drive of 15:1."""
NEEDLES: dict[str, Any] = {
    "mechanism": Mechanism.evenly_spaced(pins=8, satellites=1, ratio=20.0),
    "output_torque": 60.0,
    "pin_circle_radius": 0.040,
    "eccentricity": 2e-3,
    "pin_radius": 8e-3,
    "input_speed": 1000 * math.pi / 30,
    "kind": "needle",
    "dynamic_rating": 5000.0,
    "static_rating": 5500.0,
    "rolling_elements": 16,
}


def says(found: PinRollers, **wanted: float) -> None:
    """Numbers in the units of the API, to the 0.8 % of tabled load zones."""
    sizes = {"speed": math.pi / 30, "life": 3600.0}
    for name, value in wanted.items():
        assert getattr(found, name) / sizes.get(name, 1.0) == pytest.approx(value, rel=8e-3), name


def test_ball_bearings_on_six_pins() -> None:
    says(
        pin_rollers(**SMALL),
        speed=73.84615384615384,
        peak_load=56.25,
        equivalent_load=33.55125858523685,
        dynamic_rating_as_roller=815.737158933016,
        static_rating_as_roller=275.0,
        life=3243733.4417519434,
        static_safety_factor=4.888888888888889,
    )


def test_needles_on_eight_pins_of_one_disc() -> None:
    says(
        pin_rollers(**NEEDLES),
        speed=262.5,
        peak_load=750.0,
        equivalent_load=464.7983826888655,
        dynamic_rating_as_roller=1991.9651726041973,
        static_rating_as_roller=1718.75,
        life=8117.891038396406,
        static_safety_factor=2.2916666666666665,
    )


@pytest.mark.parametrize(("given", "power"), [(SMALL, 3.0), (NEEDLES, 10 / 3)])
def test_the_equivalent_load_is_that_of_gamma_functions(given: Any, power: float) -> None:
    """Ideal forces have v = 1 and an even number of phases."""
    found = pin_rollers(**given)
    closed = math.gamma((power + 1) / 2) / (2 * math.sqrt(math.pi) * math.gamma(power / 2 + 1))
    ratio = found.equivalent_load / found.peak_load
    assert ratio == pytest.approx(closed ** (1 / power), rel=SAME)
    assert found.accuracy.relative_error < 2e-6


@pytest.mark.parametrize("exponent", [0.0, 0.6, 1.5])
@pytest.mark.parametrize("pins", [3, 5])
def test_the_equivalent_load_is_the_mean_over_the_turn(exponent: float, pins: int) -> None:
    own = Mechanism.evenly_spaced(pins=pins, satellites=1, ratio=15.0)
    found = pin_rollers(**SMALL | {"mechanism": own, "force_exponent": exponent})
    places = (np.arange(36_000) + 0.5) / 36_000 * own.crank_angle_per_wave
    forces = force_ratios(mechanism=own, crank_angles=places, force_exponent=exponent)
    sampled = (forces[:, 0, 0] ** 3).mean() ** (1 / 3)
    reference = reference_force(output_torque=4.05, pin_circle_radius=0.024)
    assert found.equivalent_load == pytest.approx(reference * sampled, rel=2e-4)


def test_the_ring_rolls_without_slip() -> None:
    crank, ratio = SMALL["input_speed"], 15.0
    wanted = ring_speed(
        eccentricity=1.5e-3, ring=6.5e-3, hole=8e-3, crank=crank, turn=-crank / ratio
    )
    assert pin_rollers(**SMALL).speed == pytest.approx(wanted, rel=SAME)


@pytest.mark.parametrize("elements", [6, 8, 12, 30])
@pytest.mark.parametrize("kind", ["ball", "roller"])
def test_two_elements_carry_what_no_seat_does(kind: Any, elements: int) -> None:
    found, wanted = (
        unsupported_shares(kind=kind, elements=elements),
        shares(kind=kind, elements=elements),
    )
    assert found == pytest.approx(wanted, rel=2e-3)


def test_no_share_of_a_rating_is_above_all_of_it() -> None:
    assert unsupported_shares(kind="ball", elements=3) == (1.0, 1.0)
    assert unsupported_shares(kind="roller", elements=None) == UNKNOWN_ELEMENTS["roller"]
    for kind, counts in (("ball", range(7, 13)), ("roller", range(16, 22))):
        unknown = UNKNOWN_ELEMENTS[kind]  # type: ignore[index]
        usual = [unsupported_shares(kind=kind, elements=each) for each in counts]  # type: ignore[arg-type]
        assert min(dynamic for dynamic, _ in usual) < unknown[0] < max(each[0] for each in usual)


def test_ratings_of_a_roller_are_taken_as_they_are() -> None:
    found = pin_rollers(**SMALL | {"ratings": "roller"})
    assert found.dynamic_rating_as_roller == 1080 and found.static_rating_as_roller == 440
    assert found.notices == ()
    (notice,) = pin_rollers(**SMALL).notices
    assert notice.code == "outer_ring_not_supported"
    assert notice.params["dynamic"] == pytest.approx(815.7 / 1080, rel=1e-3)


def test_rollers_side_by_side_share_the_force() -> None:
    one, two = pin_rollers(**SMALL), pin_rollers(**SMALL | {"per_satellite": 2})
    assert two.peak_load == one.peak_load / 2
    assert two.life == pytest.approx(8 * one.life)
    assert two.static_safety_factor == pytest.approx(2 * one.static_safety_factor)


def test_the_peak_torque_is_for_the_static_safety_alone() -> None:
    one, more = pin_rollers(**SMALL), pin_rollers(**SMALL | {"peak_torque": 8.1})
    assert (more.peak_load, more.life) == (one.peak_load, one.life)
    assert more.static_load == 2 * one.static_load
    assert more.static_safety_factor == one.static_safety_factor / 2


def test_the_slope_of_a_pin_under_a_force_at_a_point() -> None:
    """6 mm of steel, 56.25 N at 11 mm."""
    beam = PinBeam.round(
        support="cantilever", diameter=0.006, contact_length=1e-9, youngs_modulus=210e9,
        poissons_ratio=0.3,
    )  # fmt: skip
    assert 56.25 * beam.slope(0.011, 0.011) * 1e3 == pytest.approx(0.2547321179116314, rel=SAME)


ROLLERS = Rollers(
    kind="ball",
    bore_diameter=0.010,
    width=0.018,
    dynamic_rating=90e3,
    static_rating=30e3,
    rolling_elements=8,
)


def rolled(rollers: Rollers = ROLLERS, **values: Any) -> Design:
    pin = replace(WHOLE.pin, diameter=rollers.bore_diameter)  # type: ignore[type-var]
    return having(WHOLE, **{"pin": pin, "friction": None, "rollers": rollers} | values)


def test_the_clearance_of_rollers_adds_half_of_itself() -> None:
    """To that of pins and holes, in play and forces, but not to the radii that touch."""
    loose = replace(ROLLERS, radial_clearance=4e-5)
    own = Results(rolled(loose, hole_radius=0.01001))
    alike = Results(rolled(hole_radius=0.01003))
    assert own.real.roller_play == 2e-5
    assert own.loading.turn.backlash_max == pytest.approx(
        alike.loading.turn.backlash_max, rel=EXACT
    )
    peak = alike.loading.turn.peak_force
    assert own.loading.turn.peak_force == pytest.approx(peak, rel=1e-4)
    assert own.rooms.room.least == pytest.approx(alike.rooms.room.least, rel=EXACT)
    one, other = own.real.contact(0, 1e3), alike.real.contact(0, 1e3)
    assert one and other and one.reduced_radius > other.reduced_radius * 1.003
    nearly = [
        replace(each.real, exact=False, law=LinearLaw(stiffness=1e8)) for each in (own, alike)
    ]
    first, second = (OverTurn(Turn(each, 500.0)) for each in nearly)
    assert first.peak_force == pytest.approx(second.peak_force, rel=EXACT)


def test_a_clearance_that_is_not_known_stays_so() -> None:
    loose = replace(ROLLERS, radial_clearance=4e-5)
    design = rolled(loose, clearance_stated=False)
    assert design.clearance_unknown and not design.as_made
    stated = having(design, clearance_stated=True)
    assert stated.as_made and not stated.clearance_unknown
    codes = [each.code for each in Results(rolled()).roller_loads.notices]
    assert "roller_clearance_unknown" in codes
    assert "roller_clearance_unknown" not in [
        each.code for each in Results(stated).roller_loads.notices
    ]


def test_the_usual_fit_of_rings_is_that_of_bearings() -> None:
    name, clearance = usual_clearance(rolled())
    assert name == "H7/h6"
    assert 0 < clearance < usual_clearance(having(rolled(), rollers=None))[1]


def test_a_contact_is_no_longer_than_its_rollers() -> None:
    short = Results(rolled(replace(ROLLERS, width=0.005)))
    both = Results(rolled(replace(ROLLERS, width=0.005, per_satellite=2)))
    assert (short.design.pair.contact_length, both.design.pair.contact_length) == (0.005, 0.010)
    assert Results(rolled()).design.pair.contact_length == 0.018
    assert short.hertz.max_pressure > both.hertz.max_pressure


def test_the_loss_is_that_of_the_bearings() -> None:
    """Report and sheet use the sleeve's formula with the bore and the bearing's friction."""
    design = rolled(input_speed=50 * math.pi, hole_radius=0.010, pin=None)
    losses = Results(design).losses.pins
    friction = having(
        WHOLE, friction=Friction(coefficient=0.0015, sleeve=True), hole_radius=0.010,
        pin=replace(WHOLE.pin, diameter=0.010),
        distribution_factor=1.000001,
    )  # fmt: skip
    sleeves = Results(friction).losses.pins
    assert losses.mean_loss == pytest.approx(sleeves.mean_loss, rel=SAME)
    given = rolled(replace(ROLLERS, friction_coefficient=0.003), pin=None)
    assert Results(given).losses.pins.mean_loss == pytest.approx(2 * losses.mean_loss)
    said = rolled(friction=Friction(coefficient=0.003, wear_rate=1e-17), pin=None)
    assert Results(said).losses.pins.mean_loss == pytest.approx(2 * losses.mean_loss)
    for code in ("sliding_speed", "pv", "wear"):
        check = check_of(code, having(said, max_pv=1.0, max_wear=1e-9, max_sliding_speed=1e-9))
        assert (check.status, check.reason) == ("not_applicable", "rollers_roll")
    asked = check_of("efficiency", rolled(min_efficiency=0.5, gear=None))
    assert (asked.status, asked.reason) == ("pass", "losses_left_out")
    toothed = check_of("efficiency", rolled(min_efficiency=0.5))
    assert (toothed.status, toothed.reason) == ("not_checked", "ring_friction_unknown")


def test_the_small_drive_loses_milliwatts() -> None:
    small = having(
        WHOLE, ratio=15.0, output_torque=4.05, pin_circle_radius=0.024, input_speed=10 * math.pi,
        pin_radius=6.5e-3, hole_radius=8e-3, eccentricity=1.5e-3, contact_length=5e-3, gear=None,
        pin=None, friction=None, bearing=None, crankshaft=None, fatigue=None,
        rollers=Rollers(kind="ball", bore_diameter=6e-3, friction_coefficient=0.0015),
    )  # fmt: skip
    assert Results(small).losses.pins.mean_loss == pytest.approx(0.00747692331, rel=SEARCHED)


CODES = ("life", "static", "max_load", "min_load", "speed", "fits", "tilt")


def test_what_is_not_given_is_not_judged() -> None:
    bare = rolled(Rollers(kind="ball", bore_diameter=0.010))
    found = {code: check_of(f"pin_roller_{code}", bare) for code in CODES}
    assert {code: each.reason for code, each in found.items() if each.reason} == {
        "life": "rating_unknown",
        "static": "rating_unknown",
        "max_load": "no_limit",
        "min_load": "rating_unknown",
        "speed": "no_limit",
        "fits": "size_missing",
        "tilt": "roller_tilted",
    }
    assert found["life"].limit == bare.life and found["life"].opens
    assert found["static"].limit == 1.0 and found["static"].opens
    assert not found["min_load"].opens and not found["speed"].opens and found["fits"].opens
    still = having(rolled(), input_speed=None)
    assert check_of("pin_roller_life", still).reason == "speed_missing"


def test_each_limit_is_where_it_says() -> None:
    design = rolled(
        replace(ROLLERS, max_radial_load=5e3, max_static_radial_load=8e3, limiting_speed=100.0)
    )
    loads = Results(design).roller_loads
    life = check_of("pin_roller_life", design)
    assert life.value == loads.life and life.limit == design.life
    assert life.torque_reserve == pytest.approx((life.value / life.limit) ** (1 / 3))
    static = check_of("pin_roller_static", design)
    assert static.value == loads.static_safety_factor == 30e3 * 5 / 8 / loads.static_load
    most = check_of("pin_roller_max_load", design)
    assert most.value == pytest.approx(max(loads.peak_load / 5e3, loads.static_load / 8e3))
    least = check_of("pin_roller_min_load", design)
    assert (least.value, least.limit) == (loads.peak_load, pytest.approx(0.0167 * 30e3))
    speed = check_of("pin_roller_speed", design)
    assert speed.value == pytest.approx(loads.speed) and speed.limit == 100.0
    assert check_of("pin_roller_fits", design).value == pytest.approx(0.002)
    tilt = check_of("pin_roller_tilt", design)
    assert tilt.value == Results(design).pin_loads.deflection.slope and tilt.limit == 1e-3
    for kind, limit in (("cylindrical", 0.4e-3), ("needle", 0.1e-3)):
        other = rolled(replace(ROLLERS, kind=kind, ratings="roller"))
        found = check_of("pin_roller_tilt", other)
        assert (found.limit, found.status) == (limit, "marginal")


def test_the_largest_load_has_the_application_factor_in_it() -> None:
    light = rolled(replace(ROLLERS, max_radial_load=1e3), pin=None, application_factor=1.25)
    most = check_of("pin_roller_max_load", light)
    assert most.value == pytest.approx(1.25 * Results(light).roller_loads.peak_load / 1e3)
    assert most.torque_reserve == pytest.approx(1 / most.value)


def test_the_static_safety_that_is_usual_is_that_of_bearings() -> None:
    for kind, peak, kinds, usual in (
        ("ball", None, "start", 1.0),
        ("needle", None, "start", 1.5),
        ("ball", 800.0, "start", 1.5),
        ("needle", 800.0, "emergency", 1.0),
    ):
        own = replace(ROLLERS, kind=kind, ratings="roller")
        design = rolled(own, peak_torque=peak, peak_kind=kinds)
        assert check_of("pin_roller_static", design).limit == usual
    asked = rolled(static_safety=3.0)
    assert check_of("pin_roller_static", asked).limit == 3.0


def test_rollers_of_neighbours_do_not_lie_in_each_other() -> None:
    wide = check_of("pin_roller_fits", rolled(replace(ROLLERS, width=0.021)))
    assert (wide.status, wide.reason) == ("marginal", "wider_than_satellite")
    both = check_of("pin_roller_fits", rolled(replace(ROLLERS, width=0.012, per_satellite=2)))
    assert both.status == "fail" and both.impossible
    assert both.value == pytest.approx(0.022 - 0.024)
    assert check_of("pin_roller_fits", rolled(pin=None)).status == "pass"


def test_a_light_load_only_warns() -> None:
    light = check_of("pin_roller_min_load", rolled(output_torque=5.0))
    assert (light.status, light.reason) == ("marginal", "bearing_slips")


@pytest.mark.slow
def test_a_larger_rating_cures_the_life() -> None:
    weak = rolled(replace(ROLLERS, dynamic_rating=20e3), life=5000 * 3600.0)
    assert check_of("pin_roller_life", weak).status == "fail"
    (fix,) = (
        each
        for each in fixes_of(weak, ["pin_roller_life"])
        if each.variable == "rollers.dynamic_rating"
    )
    cured = rolled(replace(ROLLERS, dynamic_rating=fix.after))
    assert check_of("pin_roller_life", cured).status in ("pass", "marginal")
    assert not [
        each for each in fixes_of(weak, ["pin_roller_life"]) if "pin_radius" in each.variable
    ]


REFUSED = {
    "another ring": (replace(ROLLERS, outer_diameter=0.015), "rollers.outer_diameter", "only_one"),
    "no ring": (replace(ROLLERS, bore_diameter=0.016), "rollers.bore_diameter", "smaller_than"),
    "no ring of its own": (
        replace(ROLLERS, outer_diameter=0.016, bore_diameter=0.017),
        "rollers.bore_diameter",
        "smaller_than",
    ),
    "a cage of needles": (replace(ROLLERS, kind="needle"), "rollers.ratings", "drawn_cup"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_rollers_that_cannot_be_are_refused(name: str) -> None:
    rollers, parameter, code = REFUSED[name]
    with pytest.raises(InvalidInput) as refused:
        rolled(rollers)
    assert (refused.value.parameter, refused.value.code) == (parameter, code)


def test_pins_are_as_thick_as_their_rollers_are_bored_and_have_no_sleeves() -> None:
    with pytest.raises(InvalidInput) as refused:
        rolled(pin=WHOLE.pin)
    assert (refused.value.parameter, refused.value.code) == ("pin.diameter", "only_one")
    with pytest.raises(InvalidInput) as refused:
        rolled(friction=Friction(coefficient=0.1, sleeve=True))
    assert (refused.value.parameter, refused.value.code) == ("friction.sleeve", "only_one")
    needles = replace(ROLLERS, kind="needle", outer_diameter=0.016)
    assert rolled(needles).rollers.kind == "needle"
