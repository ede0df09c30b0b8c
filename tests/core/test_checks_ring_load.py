"""Checks of the teeth on the pins of a ring: against published and closed numbers, positions of the
mesh that are looked at one by one, and statics by hand.
"""

import math
from dataclasses import replace
from itertools import chain
from random import Random
from typing import Any

import numpy as np
import pytest

from core.checks.crank_planetary import crank_checks
from core.checks.reserve import NEAR, crank_verdict
from core.contact_life import life_factor
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing, OtherRing
from core.design.ring_results import MOST_RING_PAIRS
from core.design.sections import FatigueBasis, Friction
from core.design.tolerances import ToleranceSection
from core.errors import InvalidInput
from core.hertz import ContactLimit, ElasticMaterial
from core.output.elasticity import RingInSeries, Shares
from core.output.room import Deviations
from core.precision import EXACT, SAME, SEARCHED
from core.ring.profile import Modification
from core.ring.sharing import NORMALS, RingDeviations, mesh_position
from tests.inputs.checks import check_of, design_of, having

ARCMIN = math.radians(1) / 60
HARD = ElasticMaterial(210e9, 0.3, ContactLimit("given", 1800e6, curve="hardened"))
SOFT = ElasticMaterial(210e9, 0.3, ContactLimit("given", 1500e6), yield_strength=900e6)
A7 = design_of(
    pins=6,
    satellites=1,
    ratio=39.0,
    output_torque=400.0,
    pin_circle_radius=0.04,
    contact_length=0.015,
    pin_radius=0.006,
    hole_radius=0.0075,
    eccentricity=0.0015,
    pin_material=HARD,
    hole_material=SOFT,
    gear=CycloidRing(
        ring_pin_circle_radius=0.082,
        ring_pin_radius=0.005,
        modification=Modification(equidistant=2e-5, pin_circle=-1e-5),
        pin_material=HARD,
    ),
)
"""The discs of a published case, pressed to 1208.519 MPa at 33.3 degrees under 400 N*m."""


FEW = design_of(
    pins=6,
    satellites=1,
    ratio=11.0,
    output_torque=100.0,
    pin_circle_radius=0.03,
    contact_length=0.01,
    eccentricity=0.0025,
    gear=CycloidRing(
        ring_pin_circle_radius=0.05,
        ring_pin_radius=0.005,
        modification=Modification(equidistant=6e-5),
        pin_material=HARD,
        disc_material=HARD,
    ),
)


def geared(design: Design = A7, /, **changes: Any) -> Design:
    """A design with another ring."""
    return having(design, gear=replace(design.gear, **changes))  # type: ignore[type-var]


def test_the_mesh_is_that_of_the_published_case() -> None:
    mesh = Results(A7).ring.mesh
    found = mesh_position(mesh=mesh, crank_angle=math.radians(33.3), output_torque=400.0)
    assert found.max_pressure == pytest.approx(1208.519e6, rel=SEARCHED)
    assert found.rotation[0] / ARCMIN == pytest.approx(1.7777511833, rel=EXACT)


@pytest.mark.parametrize("design", [A7, FEW])
def test_the_bearing_feels_the_mean_of_the_mesh(design: Design) -> None:
    """Normals are exact at 60 positions; A7 lags far, which turns them."""
    results = Results(design)
    mesh, turn = results.ring.mesh, results.ring.working[0]
    places = [
        mesh_position(mesh=mesh, crank_angle=angle, output_torque=turn.turn.torque)
        for angle in np.linspace(0, 2 * math.pi, 60, endpoint=False)
    ]
    along, across = (
        math.fsum(chain.from_iterable(getattr(each, name) for each in places))
        for name in ("crank_along", "crank_across")
    )
    found = turn.mean_radial_force_ratio
    assert NORMALS / 10 < abs(found - along / across) < NORMALS  # which is no more than needed


def pressed(force: float, angle: float) -> float:
    """Hertz pressure of a pin of these discs at an angle from the crank, by its path's bend."""
    tool, circle, length, modulus = 0.005 + 2e-5, 0.082 - 1e-5, 0.015, 210e9 / 0.91 / 2
    k = 0.0015 * 40 / circle
    slope = math.sqrt(1 + k * k - 2 * k * math.cos(angle))
    bend = (1 + 40 * k * k - 41 * k * math.cos(angle)) / (circle * slope**3)
    curved = 1 / 0.005 + bend / (1 - tool * bend)
    return math.sqrt(force * modulus * curved / (math.pi * length))


@pytest.mark.slow
@pytest.mark.parametrize("factor", [1.0, 1.5])
def test_the_pressure_is_the_largest_of_all_positions(factor: float) -> None:
    """Under the torque times its factor; where it is said to be, it is."""
    design = having(A7, application_factor=factor)
    check = check_of("ring_pressure_pin", design)
    mesh, torque = Results(design).ring.mesh, 400.0 * factor
    pitch = 2 * math.pi / 40
    places = [*np.linspace(0, pitch, 60), check.at["crank_angle"]]
    found = [mesh_position(mesh=mesh, crank_angle=a, output_torque=torque) for a in places]
    pressures = [each.max_pressure or 0.0 for each in found]
    assert check.value == pytest.approx(pressures[-1], rel=EXACT)
    assert max(pressures[:-1]) <= pressures[-1] * (1 + 1e-12)
    assert max(pressures[:-1]) == pytest.approx(pressures[-1], rel=1e-3)
    own = [pressed(f, places[-1] + k * pitch) for k, f in enumerate(found[-1].force[0])]
    assert (check.at["satellite"], check.at["pin"]) == (1, 1 + own.index(max(own)))
    assert check.value == pytest.approx(max(own), rel=EXACT)
    other = check_of("ring_pressure_disc", design)
    assert other.value == check.value and other.at == check.at


@pytest.mark.parametrize("zone", [0.0, 1e-5, 4e-5])
def test_a_ring_pin_stands_out_by_half_its_zone(zone: float) -> None:
    """The pin is moved along its normal, which passes through the pitch point; deviations count as
    the output turns, against the crank.
    """
    design = having(A7, tolerances=ToleranceSection(ring_pin_position=zone))
    check, mesh = check_of("ring_pieces", design), Results(design).ring.mesh
    pitch_point = mesh.eccentricity * mesh.disc.pins
    pressures = []
    for angle in np.linspace(0, 2 * math.pi, 12 * mesh.disc.pins, endpoint=False):
        way = pitch_point * np.exp(-1j * angle) - mesh.disc.ring_pin_circle_radius
        off, still = way / abs(way) * zone / 2, [0.0] * (mesh.disc.pins - 1)
        made = RingDeviations(pin_radial=(off.real, *still), pin_tangential=(off.imag, *still))
        moved = replace(mesh, deviations=made)
        found = mesh_position(mesh=moved, crank_angle=float(angle), output_torque=400.0)
        pressures.append(found.max_pressure or 0.0)
    assert check.value == pytest.approx(max(pressures), rel=2e-3)
    assert check.status == ("marginal" if zone else "pass")
    assert check.reason == ("pin_stands_out" if zone else "")
    placed = Deviations(ring_pin_radial=(0.0,) * mesh.disc.pins)
    assert check_of("ring_pieces", having(design, deviations=placed)).status == "not_applicable"


def test_limits_are_those_of_each_body_over_its_own_loads() -> None:
    """A pin of the ring is loaded once a turn of the crank, a lobe once a turn against the disc."""
    speed, life = 100.0, 3e7
    design = having(
        geared(disc_material=replace(HARD, limit=ContactLimit("given", 2e9, curve="nitrided"))),
        input_speed=speed,
        life=life,
        pitting_safety=1.25,
    )
    loads = speed * life / (2 * math.pi)
    pin, disc = (check_of(f"ring_pressure_{body}", design) for body in ("pin", "disc"))
    factors = [
        life_factor(curve="hardened", loads=loads),
        life_factor(curve="nitrided", loads=loads * (1 + 1 / 39)),
    ]
    assert pin.limit == pytest.approx(1800e6 * factors[0] / 1.25, rel=SAME)
    assert disc.limit == pytest.approx(2e9 * factors[1] / 1.25, rel=SAME)
    assert (pin.reason, pin.life_factor) == ("life_of_teeth", pytest.approx(factors[0]))
    plain = check_of("ring_pressure_disc", A7)
    assert (plain.limit, plain.reason) == (pytest.approx(1500e6 / 1.2), "no_life_curve")
    still = check_of("ring_pressure_pin", A7)
    assert (still.reason, still.missing) == ("life_without_speed", ("load.input_speed",))
    assert still.limit == pytest.approx(1800e6 * (5e7 / 1e10) ** 0.0306 / 1.2, rel=SAME)


def test_the_peak_torque_is_held_against_static_limits() -> None:
    """A static limit of the material, or what it bears for ever; of the torque without a factor."""
    assert check_of("ring_static_pin", A7).status == "not_asked"
    dents = replace(HARD, static_pressure=4e9)
    design = having(geared(pin_material=dents), peak_torque=700.0, application_factor=1.5)
    pin, disc = (check_of(f"ring_static_{body}", design) for body in ("pin", "disc"))
    alone = check_of("ring_pressure_pin", having(A7, output_torque=700.0))
    assert pin.value == disc.value == pytest.approx(alone.value, rel=SAME)
    assert (pin.limit, pin.status) == (4e9, "pass")
    assert (disc.status, disc.reason) == ("not_checked", "static_limit_unknown")  # above 1500 MPa
    less = having(geared(), peak_torque=450.0)
    assert check_of("ring_static_disc", less).limit == 1500e6


def test_the_reserve_is_the_torque_at_which_the_limit_is_reached() -> None:
    guess = check_of("ring_pressure_disc", A7)
    assert guess.solved and guess.limit is not None and guess.value is not None
    assert guess.torque_reserve == pytest.approx((guess.limit / guess.value) ** 2)
    verdict = crank_verdict(Results(having(A7, scope=("teeth",))), largest=True)
    check = verdict["ring_pressure_disc"]
    assert check.torque_reserve is not None and check.limit is not None
    pressures = [
        check_of("ring_pressure_disc", having(A7, output_torque=400.0 * each)).value
        for each in (check.torque_reserve, NEAR * check.torque_reserve)
    ]
    assert pressures[0] <= check.limit < pressures[1]
    assert verdict.largest_torque_of == ("teeth",)


@pytest.mark.slow
def test_of_both_directions_the_worse_is_judged() -> None:
    """Pins that are off their places make them differ."""
    off = tuple(2e-5 * math.sin(1.0 + 2.0 * k) for k in range(12))
    design = having(FEW, deviations=Deviations(ring_pin_tangential=off))
    ways = ("driving", "reverse", "alternating")
    each = [having(design, torque_direction=way) for way in ways]
    driving, back, both = (check_of("ring_pressure_pin", one).value or 0.0 for one in each)
    assert both == max(driving, back) and driving != pytest.approx(back, rel=1e-3)
    lags = [Results(one).ring.working for one in each]
    asked = having(each[2], max_transmission_error=1.0)
    most = max(turns[0].transmission_error for turns in lags[:2])
    assert check_of("ring_transmission_error", asked).value == most
    mesh = Results(design).ring.mesh
    assert mesh.exact and mesh.deviations.pin_tangential == off
    turned = geared(design, modification=Modification(rotation=1e-4))
    assert Results(turned).ring.mesh.exact


def test_shares_that_are_given_are_those_of_the_mesh() -> None:
    even = having(FEW, satellites=2)
    two = having(even, satellite_coupling=Shares((0.7, 0.3)))
    given, equal = (check_of("ring_pressure_pin", each).value for each in (two, even))
    mesh = Results(two).ring.mesh
    found = mesh_position(mesh=mesh, crank_angle=0.4, output_torque=100.0)
    assert found.disc_torque == pytest.approx((70.0, 30.0), rel=EXACT)
    assert given is not None and equal is not None and given > 1.1 * equal


def test_an_uneven_share_that_is_stated_is_on_the_torque() -> None:
    two = having(A7, satellites=2)
    stated = having(two, distribution_factor=1.3)
    alone = having(two, output_torque=520.0)
    found = check_of("ring_pressure_pin", stated).value
    assert found == pytest.approx(check_of("ring_pressure_pin", alone).value, rel=EXACT)


@pytest.mark.parametrize(("equidistant", "interference"), [(-5e-6, 5e-6), (0.0, 0.0), (5e-6, 0.0)])
def test_what_is_cut_too_large_presses_all_around(equidistant: float, interference: float) -> None:
    design = geared(modification=Modification(equidistant=equidistant))
    found = check_of("ring_pressed", design)
    assert found.value == pytest.approx(interference, abs=1e-12)
    assert found.status == ("fail" if interference else "pass") and found.torque_reserve is None


@pytest.mark.slow
def test_what_presses_is_looked_for_over_the_turn() -> None:
    """A pin that is too thick presses most where its lever is shortest."""
    thick = Deviations(ring_pin_radius=(4e-5, *[0.0] * 11))
    design = having(geared(FEW, modification=Modification(equidistant=1e-5)), deviations=thick)
    found = check_of("ring_pressed", design).value
    mesh = Results(design).ring.mesh
    each = [
        mesh_position(mesh=mesh, crank_angle=float(a), output_torque=100.0).interference or 0.0
        for a in np.linspace(0, 2 * math.pi, 73)
    ]
    assert min(each) < 0.7 * max(each)
    assert found == pytest.approx(max(each), rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("torque", "reason"), [(4e4, "beyond_hertz"), (4e7, "not_stable")])
def test_what_presses_fails_where_no_force_is_known(torque: float, reason: str) -> None:
    off = -1e-4
    made = Deviations(ring_pin_radial=(off, *[0.0] * 39))
    design = having(A7, satellites=2, deviations=made)
    held = check_of("ring_pressed", design)
    assert (held.status, held.reason) == ("fail", "")
    design = having(design, output_torque=torque)
    found = check_of("ring_pressed", design)
    assert (found.status, found.reason) == ("fail", reason)
    disc, deep = Results(design).ring.mesh.disc, []
    for crank in (found.at["crank_angle"], found.at["crank_angle"] + math.pi):
        turned = np.exp(1j * crank / 39) * disc.outline(np.linspace(0, 2 * math.pi, 400_001))
        pin = 1j * (disc.ring_pin_circle_radius + off)
        far = np.abs(turned + 1j * disc.eccentricity * np.exp(-1j * crank) - pin).min()
        deep.append(disc.ring_pin_radius - far)
    assert found.value == pytest.approx(max(deep), rel=2e-3)
    assert check_of("ring_pressure_pin", design).reason == reason


@pytest.mark.slow
def test_the_largest_torque_of_discs_in_series() -> None:
    """The torque holds and a hundredth more fails, with deviating pins too."""
    coupled = {"satellites": 2, "satellite_coupling": RingInSeries()}
    bodies = {"pin_material": replace(HARD, yield_strength=1200e6), "hole_material": SOFT}
    design = having(FEW, pin_radius=0.004, hole_radius=0.00652, **coupled, **bodies)
    assert Results(design).in_series
    off = having(design, deviations=Deviations(ring_pin_radial=(2e-6, *[0.0] * 11)))
    for made in (design, off):
        found, torque = crank_verdict(Results(made), largest=True), made.load.output_torque
        assert found.torque_reserve and torque
        held, failed = (
            crank_checks(Results(having(made, output_torque=torque * each)))
            for each in (found.torque_reserve, NEAR * found.torque_reserve)
        )
        assert not held.counts["fail"]
        assert any(
            each.status == "fail" or each.reason == "range_decides" for each in failed.checks
        )


def test_backlash_is_that_of_the_published_disc() -> None:
    """Largest over the turn 2.56426736 arcmin, in first order; by the ring as output a part."""
    design = having(
        A7,
        ratio=18.0,
        eccentricity=0.0015,
        max_ring_backlash=3 * ARCMIN,
        gear=CycloidRing(
            ring_pin_circle_radius=0.034,
            ring_pin_radius=0.0025,
            modification=Modification(equidistant=1e-5),
            pin_material=HARD,
        ),
    )
    found = check_of("ring_backlash", design)
    assert (found.value or 0) / ARCMIN == pytest.approx(2.56426736, rel=3e-4)
    assert (found.status, found.limit) == ("pass", 3 * ARCMIN)
    assert (
        check_of("ring_backlash", having(design, max_ring_backlash=2.5 * ARCMIN)).status == "fail"
    )
    of_ring = check_of("ring_backlash", having(design, output="ring")).value
    assert of_ring == pytest.approx((found.value or 0) * 18 / 19, rel=EXACT)
    plain = check_of("ring_backlash", A7)
    assert (plain.status, plain.value) == ("not_asked", None)


SPAN, PLACE, THIN = 0.06, 0.02, 1e-4
BENT = having(
    geared(pin_support="supported", span=SPAN, satellite_positions=(PLACE,)), contact_length=THIN
)
"""Loads of no width, one third along pins that are free to tilt."""


def test_a_pin_of_the_ring_is_a_beam() -> None:
    """M = F*a*b/L under the load; slope there F*a*b*(b - a)/(3*E*I*L)."""
    found = check_of("ring_pin_stress", BENT)
    force = Results(BENT).ring.loading.peak_force
    rest = SPAN - PLACE
    bending = force * PLACE * rest / SPAN / (math.pi * 0.01**3 / 32)
    assert found.value == pytest.approx(bending, rel=3e-3)  # the load is 0.1 mm long
    assert found.status == "not_checked" and found.reason == "yield_unknown"
    steel = replace(HARD, yield_strength=800e6)
    judged = check_of("ring_pin_stress", geared(BENT, pin_material=steel))
    assert judged.limit == pytest.approx(800e6 / 1.5)
    slope = check_of("ring_pin_slope", having(BENT, max_slope=1.0)).value
    inertia = math.pi * 0.01**4 / 64
    tilt = force * PLACE * rest * (rest - PLACE) / (3 * 210e9 * inertia * SPAN)
    assert slope == pytest.approx(tilt, rel=3e-3)
    sleeved = Results(geared(BENT, sleeve_bore_radius=0.004)).ring.mesh.pin
    assert sleeved is not None and sleeved.diameter == 0.008
    peak = having(BENT, peak_torque=800.0, max_slope=1.0)
    assert (check_of("ring_pin_stress", peak).value or 0) > 1.9 * bending
    assert check_of("ring_pin_slope", peak).value == slope


def moment(x: float, z: float, width: float) -> float:
    """Moment at x of a beam free to tilt under a load of 1 N, even over a width about z."""
    into = min(max(x - z + width / 2, 0.0), width)
    return (SPAN - z) / SPAN * x - into / width * (x - z + width / 2 - into / 2)


@pytest.mark.slow
def test_discs_bend_a_pin_together() -> None:
    """Two of three discs press a pin at once, each along its normal, position by position."""
    places, width = (0.012, 0.028, 0.047), 0.012
    design = geared(
        having(A7, satellites=3, contact_length=width),
        pin_support="supported",
        span=SPAN,
        satellite_positions=places,
        modification=Modification(),
    )
    mesh = Results(design).ring.mesh
    sections = np.linspace(0, SPAN, 121)
    arms = np.array([[moment(float(x), z, width) for x in sections] for z in places])
    most, k1 = 0.0, 0.0015 * 40 / 0.082
    for angle in np.linspace(0, 2 * math.pi / 40, 41):
        found = mesh_position(mesh=mesh, crank_angle=float(angle), output_torque=400.0)
        for k in range(40):
            bent = np.zeros((2, 121))
            for j, arm in enumerate(arms):
                a = angle + 2 * math.pi * (j / 3 + k / 40)
                s = math.sqrt(1 + k1 * k1 - 2 * k1 * math.cos(a))
                normal = np.array([1 - k1 * math.cos(a), k1 * math.sin(a)]) / s
                bent += found.force[j][k] * normal[:, None] * arm
            most = max(most, float(np.hypot(*bent).max()))
    stress = check_of("ring_pin_stress", design).value
    assert stress == pytest.approx(most / (math.pi * 0.01**3 / 32), rel=2e-3)


BASIS = FatigueBasis(endurance_limit=400e6)
STRONG = replace(HARD, yield_strength=1200e6)


def tired(design: Design, **ring: Any) -> Design:
    """A design whose ring pins may break after some time."""
    own = geared(design, pin_material=STRONG, pin_tensile_strength=1500e6, **ring)
    return having(own, fatigue=BASIS, output_torque=50.0)


def goodman(largest: float, least: float) -> float:
    """Safety of a cycle by its line, Re beside it as Rm."""
    amplitude, mean = (largest - least) / 2, (largest + least) / 2
    return 1 / (amplitude / 400e6 + max(mean, 0.0) / 1500e6)


@pytest.mark.parametrize("direction", ["driving", "alternating"])
def test_the_cycle_of_a_ring_pin_is_the_worst_around_it(direction: str) -> None:
    """The force on a pin turns as a disc passes: stress by stress around the section under it."""
    design = having(tired(BENT), torque_direction=direction)
    mesh, k1 = Results(design).ring.mesh, 0.0015 * 40 / 0.082
    forces = []
    for way in (1, -1) if direction == "alternating" else (1,):
        for angle in np.linspace(0, 2 * math.pi / 40, 41):
            found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=50.0 * way)
            a = angle + 2 * math.pi * np.arange(40) / 40
            normal = (1 - k1 * np.exp(-1j * a)) / np.abs(1 - k1 * np.exp(-1j * a))
            forces += [*(np.array(found.force[0]) * normal)]
    arm = PLACE * (SPAN - PLACE) / SPAN / (math.pi * 0.01**3 / 32)
    around = np.exp(-1j * np.radians(np.arange(0, 360, 1)))[:, None]
    stress = arm * (np.array(forces) * around).real
    worst = min(goodman(*each) for each in zip(stress.max(1), stress.min(1), strict=True))
    check = check_of("ring_pin_fatigue", design)
    assert check.value == pytest.approx(worst, rel=4e-3)
    assert check.limit == 1.5 and check.solved


def test_a_ring_pin_that_turns_is_bent_both_ways() -> None:
    still, turning = tired(BENT), tired(BENT, rotates=True)
    stress = check_of("ring_pin_stress", still).value or 0.0
    found = check_of("ring_pin_fatigue", turning).value or 0.0
    assert found == pytest.approx(400e6 / stress, rel=SEARCHED)
    assert found < 0.9 * (check_of("ring_pin_fatigue", still).value or 0.0)
    factored, more = having(still, application_factor=1.2), having(still, output_torque=60.0)
    fatigues = [check_of("ring_pin_fatigue", each).value for each in (factored, more)]
    assert fatigues[0] == pytest.approx(fatigues[1], rel=EXACT)


def test_ring_pins_last_by_the_turns_of_the_crank() -> None:
    """Steel pins have one cycle a turn of the crank; the life follows from given fatigue data, or
    the reason is stated.
    """
    basis = FatigueBasis(surface="ground", fatigue_notch_factor=1.5)
    steel = having(
        tired(BENT, pin_steel=True), fatigue=basis, input_speed=100.0, output_torque=150.0
    )
    turns = [1e5, 1e9]
    few, many = (
        check_of("ring_pin_fatigue", having(steel, life=2 * math.pi * each / 100.0))
        for each in turns
    )
    assert few.reason == "finite_life" and not many.reason
    strength = Results(having(steel, life=2 * math.pi * 1e5 / 100.0)).ring.pin_fatigue_strength
    assert strength.cycles == pytest.approx(1e5)
    assert few.value is not None and many.value is not None and few.value > 1.1 * many.value
    without = having(steel, fatigue=FatigueBasis(surface="ground"))
    for design, reason, missing in (
        (without, "notch_unknown", "fatigue.fatigue_notch_factor"),
        (
            geared(steel, pin_tensile_strength=None),
            "endurance_unknown",
            "gear.pin_material.tensile_strength",
        ),
        (having(steel, fatigue=None), "section_missing", "fatigue"),
    ):
        check = check_of("ring_pin_fatigue", design)
        assert (check.status, check.reason, check.missing) == ("not_checked", reason, (missing,))


def test_seats_are_pressed_by_the_largest_force() -> None:
    design = having(A7, max_seat_pressure=1e9, application_factor=1.2)
    check, turn = check_of("ring_seat_pressure", design), Results(design).ring.loading
    assert check.value == pytest.approx(turn.peak_force / (2 * 0.005 * 0.015), rel=SAME)
    there = mesh_position(
        mesh=turn.mesh, crank_angle=check.at["crank_angle"], output_torque=400.0 * 1.2
    )
    assert there.force[0][check.at["pin"] - 1] == pytest.approx(turn.peak_force, rel=EXACT)
    assert check_of("ring_seat_pressure", A7).status == "not_asked"
    bent = having(BENT, max_seat_pressure=1e9)
    assert check_of("ring_seat_pressure", bent).reason == "pins_bend"


def test_the_efficiency_of_the_teeth_is_theirs_alone() -> None:
    asked = having(geared(friction_coefficient=0.06), min_ring_efficiency=0.9)
    check, turn = check_of("ring_efficiency", asked), Results(asked).ring.working[0]
    assert check.value == pytest.approx(1 / (1 + 0.06 * turn.sliding_loss), rel=SAME)
    assert check.utilisation == pytest.approx((1 - (check.value or 0)) / 0.1, rel=EXACT)
    assert check_of("ring_efficiency", geared(friction_coefficient=0.06)).status == "not_asked"
    unknown = geared(asked, friction_coefficient=None)
    assert check_of("ring_efficiency", unknown).reason == "ring_friction_unknown"


def test_a_ring_of_every_second_pin_is_not_solved() -> None:
    half = geared(every_second_pin=True)
    assert teeth_of(half) == ("open", "every_second_pin")
    with pytest.raises(InvalidInput) as refusal:
        having(half, ratio=40.0)
    assert refusal.value.code == "odd_ring_pins"


@pytest.mark.parametrize(("eccentricity", "told"), [(0.6, True), (0.75, False), (1.9, True)])
def test_an_unusual_shortening_is_told(eccentricity: float, told: bool) -> None:
    """K1 = e*41/82: 0.3, 0.375, 0.95."""
    plain = geared(modification=Modification(), ring_pin_radius=0.001)
    design = having(plain, eccentricity=eccentricity * 1e-3, ratio=40.0)
    codes = [notice.code for notice in Results(design).ring.working[0].notices]
    assert ("unusual_shortening" in codes) is told


def test_what_slides_on_the_ring_lowers_the_efficiency() -> None:
    design = having(A7, friction=Friction(coefficient=0.05), input_speed=100.0, min_efficiency=0.5)
    rubbing = geared(design, friction_coefficient=0.06)
    alone, both = (check_of("efficiency", each).value or 0.0 for each in (design, rubbing))
    turn = Results(rubbing).ring.working[0]
    assert 1 / both == pytest.approx(1 / alone + 0.06 * turn.sliding_loss, rel=SAME)
    unknown = geared(rubbing, modification=None)
    assert check_of("efficiency", unknown).reason == "modification_unknown"


def test_pv_is_that_of_sleeves() -> None:
    """F/(2*r_i*b) of the force and sliding that are hardest, v*r_i/r at the output's speed."""
    design = having(geared(friction_coefficient=0.06), input_speed=100.0, max_pv=1e12)
    assert check_of("ring_pv", design).reason == "no_bush"
    sleeved = geared(design, sleeve_bore_radius=0.003)
    found = check_of("ring_pv", sleeved).value
    turn = Results(sleeved).ring.working[0]
    assert found == pytest.approx(turn.hardest_rub * 100 / 39 / (2 * 0.005 * 0.015), rel=EXACT)
    assert check_of("ring_pv", geared(sleeved, rolling=True)).reason == "no_bush"
    unknown = geared(sleeved, friction_coefficient=None)
    assert check_of("ring_pv", unknown).reason == "ring_friction_unknown"
    uneven = check_of("ring_pv", having(sleeved, satellites=2, distribution_factor=1.4))
    more = check_of("ring_pv", having(sleeved, satellites=2, output_torque=1.4 * 400.0))
    assert uneven.value == pytest.approx(more.value, rel=EXACT)


@pytest.mark.slow
def test_pv_is_that_of_the_harder_direction() -> None:
    """The direction with the larger pv need not lose more: sleeves at places that deviate."""
    random = Random(8)
    places = tuple(random.uniform(-2e-5, 2e-5) for _ in range(40))
    design = having(
        geared(friction_coefficient=0.06, sleeve_bore_radius=0.003),
        input_speed=100.0,
        max_pv=1e12,
        deviations=Deviations(ring_pin_tangential=places),
    )
    each = [having(design, torque_direction=way) for way in ("driving", "reverse")]
    both = having(design, torque_direction="alternating")
    pv = [check_of("ring_pv", one).value or 0.0 for one in each]
    lost = [Results(one).ring.loss.loss_ratio for one in each]
    assert pv.index(max(pv)) != lost.index(max(lost))
    assert check_of("ring_pv", both).value == pytest.approx(max(pv), rel=SAME)


def test_the_slope_is_that_of_the_softest_pins() -> None:
    """A requested slope is that of the least modulus in the sources, as for output pins."""
    soft = replace(HARD, youngs_modulus=100e9)
    unsure = replace(HARD, least_modulus=100e9)
    least, found, stiff = (
        check_of("ring_pin_slope", having(geared(BENT, pin_material=each), max_slope=1.0)).value
        for each in (soft, unsure, HARD)
    )
    assert found == least and least > 1.5 * stiff  # type: ignore[operator]
    softest = Results(geared(disc_material=unsure)).softest.design.gear
    assert softest.disc_material == soft


def teeth_of(design: Design) -> tuple[str, str]:
    parts = crank_checks(Results(design)).parts
    return next((each.status, each.reason) for each in parts if each.code == "teeth")


def test_teeth_are_judged_by_all_that_they_need() -> None:
    assert teeth_of(A7)[0] in ("pass", "marginal")
    for open_, reason in (
        (geared(modification=None), "modification_unknown"),
        (geared(pin_material=replace(HARD, limit=None)), "limit_unknown"),
        (having(BENT, contact_length=0.015), "yield_unknown"),
        (having(A7, load=None), "section_missing"),
        (having(A7, eccentricity=None), "eccentricity_assumed"),
        (having(A7, ratio=39.5), "ratio_not_whole"),
        (geared(ring_pin_radius=None), "size_missing"),
        (having(A7, satellites=1 + MOST_RING_PAIRS // 40), "too_many_ring_pairs"),
    ):
        assert teeth_of(open_) == ("open", reason)
    assert teeth_of(geared(modification=Modification(equidistant=-5e-6)))[0] == "fail"
    assert teeth_of(having(A7, output_torque=4000.0))[0] == "fail"


def test_only_a_ring_of_pins_has_these() -> None:
    other = having(A7, gear=OtherRing(kind="none"))
    for check in crank_checks(Results(other)).checks:
        assert not check.code.startswith("ring_") or check.status == "not_applicable"
    for code in ("ring_pin_stress", "ring_pin_slope", "ring_pin_fatigue"):
        assert check_of(code, A7).reason == "pins_in_seats"
