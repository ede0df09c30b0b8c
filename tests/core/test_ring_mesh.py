"""Load sharing of a cycloid mesh: what has to hold of any, closed forms, refusals, the turn."""

import math
import random
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.drive import engine
from core.errors import ImpossibleMechanism, InvalidInput, is_known
from core.output.elasticity import (
    CrankSupport,
    HertzLaw,
    LinearLaw,
    PinSupport,
    Shares,
    pin_compliance,
)
from core.output.stage import Solved
from core.output.turn import Turn
from core.precision import EXACT, JUDGED, SAME, SEARCHED
from core.ring.loss import RingFriction, ring_loss
from core.ring.mesh_curves import MeshCurves
from core.ring.profile import CycloidDisc, Modification
from core.ring.sharing import (
    CycloidMesh,
    MeshPosition,
    RingDeviations,
    ideal_mesh,
    mesh_gaps,
    mesh_over_turn,
    mesh_position,
)
from tests.inputs.classes import play_error
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.ring_meshes import drawn
from tests.inputs.valleys import narrow
from tests.oracles.ring_distance import Distances
from tests.oracles.seeds import seeds

DISC = CycloidDisc(11, 2.5e-3, 0.05, 0.005, Modification(2e-5, -1e-5))
PERFECT = replace(DISC, modification=Modification())


def mesh_of(**changes: Any) -> CycloidMesh:
    given: dict[str, Any] = {
        "disc": DISC,
        "crank_angles": (0.0, math.pi),
        "contact_length": 0.01,
        "law": LinearLaw(1e8),
        "pin_material": STEEL,
        "disc_material": STEEL,
    }
    return CycloidMesh(**given | changes)


def at(mesh: CycloidMesh, angle: float, torque: float) -> MeshPosition:
    return mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)


def flat(found: MeshPosition) -> list[float]:
    return [each for row in found.force for each in row]


@pytest.mark.parametrize("seed", seeds(4))
@pytest.mark.parametrize("exact", [True, False])
def test_what_overlaps_presses(seed: int, exact: bool) -> None:
    """By a linear law as much as the gaps at the lags say."""
    mesh, angle, torque = drawn(seed, exact=exact, law=LinearLaw(1e8))
    found = at(mesh, angle, torque)
    gaps = np.array(mesh_gaps(mesh=mesh, crank_angle=angle, rotation=found.rotation))
    force = np.array(found.force)
    assert force == pytest.approx(1e8 * np.maximum(-gaps, 0.0), abs=1e-6 * force.max())


def nearly_round(seed: int) -> CycloidMesh:
    """A mesh of a disc whose valleys are hardly hollow, or not at all."""
    r = random.Random(seed)
    lobes = r.randint(3, 9)
    eccentricity = r.uniform(0.3, 1.2) * 0.05 / (lobes + 1) ** 2
    return mesh_of(disc=replace(PERFECT, satellite_teeth=lobes, eccentricity=eccentricity))


@pytest.mark.parametrize("seed", seeds(24))
def test_gaps_at_any_lag_are_those_of_the_nearest_points(seed: int) -> None:
    """In narrow valleys and wide ones, and of discs that are turned further than a lobe."""
    meshes = (
        drawn(seed)[0], narrow(seed, "equidistant")[0], narrow(seed, "errors")[0],
        nearly_round(seed),
    )  # fmt: skip
    mesh, r = meshes[seed % 4], random.Random(seed)
    count, size = len(mesh.crank_angles), mesh.disc.ring_pin_circle_radius
    for part in np.geomspace(1e-4, 1.6, 12).tolist():
        angle, half = r.uniform(0, 2 * math.pi), math.pi / mesh.disc.satellite_teeth
        lag = r.choice((-1, 1)) * part * half
        gaps = np.array(mesh_gaps(mesh=mesh, crank_angle=angle, rotation=(lag,) * count))
        approach, _ = Distances(mesh, angle).at(lag)
        assert gaps == pytest.approx(-approach, rel=0, abs=SAME * size)


def test_curves_of_given_shares_are_of_the_lags_of_each_disc() -> None:
    made = RingDeviations(pin_radial=(1e-5, -2e-5, 0.0) * 4)
    mesh = mesh_of(support=Shares((0.7, 0.3)), deviations=made, exact=False)
    curves = MeshCurves.over_period(mesh_over_turn(mesh=mesh, output_torque=50.0), 7)
    assert curves.force.shape == curves.gap.shape == (2, 12, 8)
    for i, angle in enumerate(curves.crank_angle.tolist()):
        found = at(mesh, angle, 50.0)
        gaps = np.array(mesh_gaps(mesh=mesh, crank_angle=angle, rotation=found.rotation))
        assert curves.force[..., i] == pytest.approx(np.array(found.force), abs=1e-6)
        assert curves.gap[..., i] == pytest.approx(np.maximum(gaps, 0.0), abs=1e-12)
        mean = np.dot((0.7, 0.3), found.rotation)
        assert curves.rotation[i] == pytest.approx(mean, rel=EXACT)
        assert found.rotation[0] != found.rotation[1]


@pytest.mark.parametrize("seed", seeds(4))
def test_larger_pins_in_a_larger_cut_change_nothing_but_curvatures(seed: int) -> None:
    mesh, angle, torque = drawn(4 * seed, law=LinearLaw(1e8))
    more, own = 7e-6, mesh.disc.modification
    wider = replace(mesh.disc, modification=replace(own, equidistant=own.equidistant + more))
    radii = tuple(each + more for each in mesh.deviations.pin_radius)
    other = replace(mesh, disc=wider, deviations=replace(mesh.deviations, pin_radius=radii))
    found, same = at(mesh, angle, torque), at(other, angle, torque)
    assert flat(same) == pytest.approx(flat(found), rel=EXACT, abs=1e-9)
    assert (same.play is None) == (found.play is None)
    if found.play is not None:
        assert same.play == pytest.approx(found.play, rel=EXACT)
    assert same.max_pressure != pytest.approx(found.max_pressure, rel=SEARCHED)


@pytest.mark.parametrize("z", [11, 29, 59])
@pytest.mark.parametrize("k", [0.5, 0.75])
def test_perfect_parts_are_near_their_closed_forms(z: int, k: float) -> None:
    """Within what few pins make of sums: 1 to 5 % of 12 pins, nothing of 60."""
    radius = 0.08
    disc = CycloidDisc(z, k * radius / (z + 1), radius, radius * (1 - k) * 0.1)
    mesh = mesh_of(disc=disc, exact=False, crank_angles=(0.0,))
    turn, ideal = (
        mesh_over_turn(mesh=mesh, output_torque=100.0),
        ideal_mesh(disc=disc, disc_torque=100.0),
    )
    near = {11: 0.04, 29: 0.01, 59: 3e-3}[z]
    assert turn.peak_force == pytest.approx(ideal.peak_force, rel=near)
    sums = turn.turn.fine["forces"].sum(axis=1)
    assert sums.max() == pytest.approx(ideal.mean_sum_force, rel=2 * near)
    loss = ring_loss(turn=turn, friction=RingFriction(0.06))
    assert loss.loss_ratio == pytest.approx(loss.ideal_loss_ratio, rel=near)
    assert ideal.backlash == 0 and turn.backlash_max == pytest.approx(0, abs=1e-12)
    assert turn.backlash_max >= 0 and turn.lag_max == pytest.approx(turn.lag_min, rel=0.1)


@pytest.mark.parametrize(
    "change",
    [
        Modification(3e-5, 0.0),
        Modification(0.0, -3e-5),
        Modification(2e-5, -2e-5),
        Modification(3e-5, 2.5e-5),
        Modification(-1e-5, -4e-5),
        Modification(3e-5, 1.0e-5, 1e-4),
    ],
)
def test_the_backlash_of_many_pins_in_closed_form(change: Modification) -> None:
    """Against the least of twice gap over lever over all angles."""
    disc = CycloidDisc(59, 1e-3, 0.09, 0.004, change)
    k = disc.shortening_coefficient
    a = np.linspace(1e-4, math.pi, 400_001)
    slope = np.sqrt(1 + k * k - 2 * k * np.cos(a))
    lever = disc.eccentricity * disc.satellite_teeth * np.sin(a) / slope
    gap = change.equidistant - change.pin_circle * (1 - k * np.cos(a)) / slope
    expected = 2 * ((gap / np.maximum(lever, 1e-12)).min() + change.rotation)
    assert ideal_mesh(disc=disc, disc_torque=1.0).backlash == pytest.approx(expected, rel=SEARCHED)
    mesh = mesh_of(disc=disc, exact=False, crank_angles=(0.0,))
    turn = mesh_over_turn(mesh=mesh, output_torque=1.0)
    assert expected * (1 - 1e-9) <= turn.backlash_min <= turn.backlash_max < 1.03 * expected


@pytest.mark.parametrize(
    "change", [Modification(-1e-5), Modification(1e-5, 1e-5), Modification(1e-5, 2e-5)]
)
def test_a_modification_that_jams_has_no_backlash(change: Modification) -> None:
    disc = replace(DISC, modification=change)
    assert ideal_mesh(disc=disc, disc_torque=1.0).backlash is None
    if change.equidistant < 0:
        found = at(mesh_of(disc=disc), 0.3, 10.0)
        assert found.play is None and found.interference == pytest.approx(1e-5, rel=0.2)
        assert "pressed_without_load" in [each.code for each in found.notices]
        turn = mesh_over_turn(mesh=mesh_of(disc=disc), output_torque=10.0)
        assert turn.pressed_without_load and turn.backlash_max == 0


def test_discs_that_share_evenly_cancel_what_turns_with_the_pins() -> None:
    """Two perfect discs on an even number of pins have equal forces at any angle."""
    one = mesh_over_turn(mesh=mesh_of(disc=PERFECT, crank_angles=(0.0,)), output_torque=100.0)
    two = mesh_over_turn(mesh=mesh_of(disc=PERFECT), output_torque=200.0)
    assert two.peak_force == pytest.approx(one.peak_force, rel=EXACT)
    assert two.transmission_error == pytest.approx(one.transmission_error, rel=SEARCHED)


def test_what_seats_and_bent_pins_give() -> None:
    rigid = mesh_of(disc=PERFECT)
    seated = mesh_of(disc=PERFECT, seat_stiffness=1e8)
    assert at(seated, 0.3, 50.0).rotation[0] == pytest.approx(
        2 * at(rigid, 0.3, 50.0).rotation[0], rel=1e-2
    )
    assert [each.code for each in at(rigid, 0.3, 50.0).notices] == ["seat_rigid"]
    assert at(seated, 0.3, 50.0).notices == ()
    pin = PinSupport("fixed", 0.01, (0.01, 0.03), STEEL, 0.04)
    bent = mesh_of(pin=pin)
    assert bent.compliance == list(pin_compliance(pin))
    softer = 1 / (1 / 1e8 + pin_compliance(pin)[0])
    one = mesh_of(disc=PERFECT, pin=replace(pin, satellite_positions=(0.01,)), crank_angles=(0.0,))
    same = mesh_of(disc=PERFECT, law=LinearLaw(softer), crank_angles=(0.0,))
    assert at(one, 0.3, 50.0).rotation == pytest.approx(at(same, 0.3, 50.0).rotation, rel=SAME)
    with pytest.raises(InvalidInput, match="satellite_positions"):
        at(mesh_of(pin=replace(pin, satellite_positions=(0.01,))), 0.3, 50.0)


def test_the_reference_depth_is_the_pin_s_radius() -> None:
    own = at(mesh_of(law=HertzLaw()), 0.3, 100.0)
    same = at(mesh_of(law=HertzLaw(reference_depth=0.005)), 0.3, 100.0)
    deeper = at(mesh_of(law=HertzLaw(reference_depth=0.010)), 0.3, 100.0)
    assert own.rotation == same.rotation
    assert own.rotation[0] < deeper.rotation[0] < 1.1 * own.rotation[0]


@pytest.mark.parametrize(
    ("changes", "name", "code"),
    [
        ({"contact_length": 0.0}, "contact_length", "greater_than"),
        ({"seat_stiffness": -1.0}, "seat_stiffness", "greater_than"),
        ({"disc": replace(DISC, ring_pin_radius=0.016)}, "ring_pin_radius", "undercut"),
        ({"law": HertzLaw(0.002)}, "reference_depth", "greater_than_equal"),
        ({"law": HertzLaw(0.011)}, "reference_depth", "less_than_equal"),
        ({"support": Shares((1.0,))}, "shares", "different_length"),
        ({"support": CrankSupport(1e8), "exact": False}, "support", "not_in_table"),
        ({"deviations": RingDeviations(pin_radial=(1e-6,))}, "pin_radial", "different_length"),
        ({"deviations": RingDeviations(crank_phase=(0.0,))}, "crank_phase", "different_length"),
    ],
)  # fmt: skip
def test_what_is_out_of_range_is_refused(changes: dict[str, Any], name: str, code: str) -> None:
    with pytest.raises(InvalidInput) as caught:
        at(mesh_of(**changes), 0.3, 10.0)
    assert (caught.value.parameter, caught.value.code) == (name, code)


@pytest.mark.parametrize("torque", [0.0, math.nan])
def test_a_torque_has_to_be_one(torque: float) -> None:
    with pytest.raises(InvalidInput, match="output_torque"):
        at(mesh_of(), 0.0, torque)


def test_deviations_that_leave_nothing_are_impossible() -> None:
    for deviations in (
        RingDeviations(pin_radius=(*(0.0,) * 11, -0.006)),
        RingDeviations(eccentricity=(0.0, -0.003)),
    ):
        with pytest.raises(ImpossibleMechanism) as caught:
            at(mesh_of(deviations=deviations), 0.3, 10.0)
        assert caught.value.code == "no_radius_left"


@pytest.mark.parametrize("seed", seeds(20))
def test_at_the_limit_of_undercut_a_disc_is_refused_and_no_number_fails(seed: int) -> None:
    """By rounding its sharpest place may lie on either side of it."""
    r = random.Random(seed)
    lobes, radius = r.randint(4, 40), r.uniform(0.02, 0.1)
    disc = CycloidDisc(lobes, r.uniform(0.1, 0.95) * radius / (lobes + 1), radius, 1e-6)
    places = np.linspace(0, 2 * math.pi / lobes, 40_001)
    sharpest = lobes * float(places[disc.path_curvature(places).argmax()])
    parts = [1 + k * 2.0**-52 for k in (-4, -1, 0, 1)] + [1 - 1e-12, 1 - 9e-10, 1 - 1.1e-9]
    for part in parts:
        made = replace(disc, ring_pin_radius=disc.min_path_radius * part)
        if part > 1 - 1e-9:
            with pytest.raises(InvalidInput, match="ring_pin_radius") as caught:
                mesh_of(disc=made)
            assert caught.value.code == "undercut"
            continue
        mesh = mesh_of(disc=made, law=HertzLaw(), crank_angles=(0.0,))
        for k in range(-3, 4):
            room = unloaded(mesh, sharpest * (1 + k * 2.0**-52))
            for i in range(disc.pins):
                engine.bend_lobe(i, 0, room.drive, room.work.w)
            curved = room.work.w[:, engine.BENT]
            assert np.isfinite(curved).all() and curved.min() > 0


def test_a_pin_that_just_touches_at_its_dead_angle_has_a_known_play() -> None:
    """The pin has no lever: the exactness of the play depends on the curvature of the path."""
    disc = CycloidDisc(20, 2e-3, 0.066, 0.004, Modification(1.5e-5, -5e-6))

    def play(inward: float) -> tuple[tuple[float, float] | None, float]:
        deviations = RingDeviations(pin_radial=(-inward, *[0.0] * 20))
        found = at(mesh_of(disc=disc, deviations=deviations), 0.0, 200.0)
        return found.play, play_error(found)

    (least, most), error = play(2e-5)  # type: ignore[misc]
    assert least == pytest.approx(0, abs=error) and most == pytest.approx(0, abs=error)
    wider, _ = play(math.nextafter(2e-5, 0))
    assert wider == pytest.approx((least, most), abs=1e-7)


def test_a_pin_that_does_not_let_a_disc_in_presses_as_deep_as_it_stands_within() -> None:
    """Stiff contacts hold; of what soft ones cannot hold the pin is not said to be the cause."""
    disc = CycloidDisc(19, 2e-3, 0.06, 0.005, Modification(2e-5, -1e-5))
    inward = RingDeviations(pin_radial=(-1e-4, *[0.0] * 19))
    mesh, angle = mesh_of(disc=disc, deviations=inward), 0.0044
    found, crank = at(mesh, angle, 300.0), angle + math.pi
    turned = np.exp(1j * crank / 19) * disc.outline(np.linspace(0, 2 * math.pi, 400_001))
    far = np.abs(turned + 2e-3j * np.exp(-1j * crank) - 1j * (0.06 - 1e-4)).min()
    assert found.interference == pytest.approx(0.005 - far, rel=1e-3)
    assert found.force[1][0] > 1e8 * 7e-5 * 0.99 and found.play is None
    with pytest.raises(ImpossibleMechanism) as caught:
        at(replace(mesh, law=LinearLaw(1e3)), angle, 1e4)
    assert caught.value.code == "not_stable" and caught.value.where == {"crank_angle": angle}


def test_contacts_that_are_too_soft_hold_nothing() -> None:
    with pytest.raises(ImpossibleMechanism) as caught:
        at(mesh_of(law=LinearLaw(1e3)), 0.3, 1e4)
    assert caught.value.code == "not_stable"


@pytest.mark.parametrize("seed", seeds(2))
def test_the_summits_of_a_turn_against_a_dense_walk(seed: int) -> None:
    mesh, _, torque = drawn(4 * seed + 1)
    turn = mesh_over_turn(mesh=mesh, output_torque=torque)
    walk = Turn(mesh, torque)
    rows = walk.poses(np.linspace(0, 2 * math.pi, 20_000, endpoint=False).tolist())
    most = rows["force"].max()
    assert most * (1 - 1e-12) <= turn.peak_force <= most * (1 + 1e-3)
    lags = rows["lag"] if torque > 0 else -rows["lag"]
    assert turn.lag_max >= lags.max() - 1e-12 and turn.lag_min <= lags.min() + 1e-12
    assert turn.transmission_error == pytest.approx(np.ptp(lags), rel=1e-3)
    backlash = np.maximum(rows["high"] - rows["low"], 0)
    assert turn.backlash_max == pytest.approx(backlash.max(), rel=1e-3)
    pressure = mesh.pressure(float(rows["pressure"].max()))
    assert pressure * (1 - 1e-12) <= turn.max_pressure <= pressure * (1 + 1e-3)
    along = [
        each
        for angle in np.linspace(0, 2 * math.pi, 60, endpoint=False)
        for each in at(mesh, float(angle), torque).crank_along
    ]
    across = (
        abs(torque) / len(mesh.crank_angles) / (mesh.disc.eccentricity * mesh.disc.satellite_teeth)
    )
    assert turn.radial_force_ratio_max >= max(along) / across - 1e-9
    assert turn.radial_force_ratio_min <= min(along) / across + 1e-9
    rub = np.mean(
        [
            at(mesh, float(angle), torque).sliding_loss
            for angle in np.linspace(0, 2 * math.pi, 240, endpoint=False)
        ]
    )
    assert turn.sliding_loss == pytest.approx(rub, rel=1e-2)


def test_a_contact_is_at_most_as_wide_as_its_pin() -> None:
    """A growing torque stops at the half-width that equals the pin's radius."""
    disc = replace(PERFECT, ring_pin_radius=2e-4, modification=Modification(5e-5))
    mesh = mesh_of(disc=disc, law=HertzLaw(), crank_angles=(0.0,))
    angle, low, high, codes = -math.acos(0.6) + 2 * math.pi / 24, 1.0, 1e5, set()
    for _ in range(60):
        torque = math.sqrt(low * high)
        try:
            at(mesh, angle, torque)
        except ImpossibleMechanism as refusal:
            codes.add(refusal.code)
            high = torque
        else:
            low = torque
    assert codes == {"beyond_hertz"}
    found = at(mesh, angle, low)
    pressure = found.max_pressure
    modulus = 210e9 / (1 - 0.3**2) / 2
    widths = [2 * force / (math.pi * mesh.contact_length * pressure) for force in found.force[0]]
    assert pressure is not None and max(widths) == pytest.approx(2e-4, rel=0.05)
    assert max(widths) <= 2e-4 * (1 + 1e-9) and pressure < modulus


def test_over_a_turn_friction_costs_what_slides() -> None:
    turn = mesh_over_turn(mesh=mesh_of(), output_torque=100.0)
    plain = ring_loss(turn=turn, friction=RingFriction(0.05), input_speed=-100.0)
    assert plain.efficiency == pytest.approx(1 / (1 + 0.05 * turn.sliding_loss))
    assert plain.mean_loss == pytest.approx(plain.loss_ratio * 100.0 * 100.0 / 11)
    sleeved = ring_loss(turn=turn, friction=RingFriction(0.05, 0.003), input_speed=100.0)
    assert sleeved.loss_ratio == pytest.approx(0.6 * plain.loss_ratio)

    def far(a: float) -> float:
        return abs(0.05 * math.sqrt(1.36 - 1.2 * math.cos(a)) - 0.005)

    largest = [
        force * far(float(angle) + 2 * math.pi * k / 12 + j * math.pi)
        for angle in np.linspace(0, 2 * math.pi, 300)
        for j, row in enumerate(at(mesh_of(), float(angle), 100.0).force)
        for k, force in enumerate(row)
    ]  # fmt: skip
    speed = 100.0 / 11
    assert sleeved.peak_pv == pytest.approx(max(largest) * speed / (0.01 * 0.01), rel=1e-3)
    rolling = ring_loss(
        turn=turn, friction=RingFriction(0.05, 0.003, rolling=True), input_speed=9.0
    )
    assert plain.peak_pv > 0 and not is_known(lambda: rolling.peak_pv)
    for friction, name in (
        (RingFriction(-0.1), "coefficient"),
        (RingFriction(0.1, 0.005), "sleeve_bore_radius"),
    ):
        with pytest.raises(InvalidInput) as caught:
            ring_loss(turn=turn, friction=friction)
        assert caught.value.parameter == name


def test_sliding_is_what_a_point_of_the_disc_does_on_its_pin() -> None:
    """Reference: velocity of the touching point by differences, with the crank at 1 rad/s."""
    disc, angle, step = PERFECT, 0.7, 1e-6
    found = at(mesh_of(disc=disc, crank_angles=(0.0,)), angle, 1e-3)
    speeds = []
    for k, force in enumerate(found.force[0]):
        if not force:
            continue
        a = angle + 2 * math.pi * k / 12
        pin = 1j * np.exp(2j * math.pi * k / 12) * disc.ring_pin_circle_radius
        pitch = 1j * np.exp(-1j * angle) * disc.eccentricity * 12
        contact = pin + (pitch - pin) / abs(pitch - pin) * disc.ring_pin_radius
        crank = 1j * disc.eccentricity * np.exp(-1j * angle)
        moved = 1j * disc.eccentricity * np.exp(-1j * (angle + step))
        material = moved + (contact - crank) * np.exp(1j * step / disc.satellite_teeth)
        speeds.append(abs(material - contact) / step)
        assert abs(contact - pin) == pytest.approx(disc.ring_pin_radius) and a > 0
    assert found.sliding_distance / disc.satellite_teeth == pytest.approx(max(speeds), rel=JUDGED)


@pytest.mark.parametrize("seed", seeds(24))
def test_no_pin_that_presses_is_passed_over(seed: int) -> None:
    """Reference for very soft contacts: a search of the nearest point for each pin. Refused cases
    are those in which other lobes come before the pins hold.
    """
    r = random.Random(seed)
    stiffness = 10 ** r.uniform(4.5, 6.5)
    mesh, angle, torque = drawn(seed, law=LinearLaw(stiffness))
    sought, way = Distances(mesh, angle), math.copysign(1.0, torque)
    try:
        found, code = at(mesh, angle, torque), ""
    except ImpossibleMechanism as refusal:
        found, code = None, refusal.code
    if found is None:
        assert code == "not_stable"
        turned = np.linspace(0, math.pi / mesh.disc.satellite_teeth, 100)
        most = max(way * sought.torque(way * float(lag), stiffness) for lag in turned)
        assert most < abs(torque)
        return
    approach_there, _ = sought.at(found.rotation[0])
    expected = stiffness * np.maximum(approach_there, 0.0)
    assert np.array(found.force) == pytest.approx(expected, abs=1e-9 * expected.max())
    assert sought.torque(found.rotation[0], stiffness) == pytest.approx(torque, rel=EXACT)


@pytest.mark.parametrize("seed", seeds(8))
def test_pins_that_are_not_looked_at_are_free(seed: int) -> None:
    """Exact geometry leaves out pins that are far off in first order."""
    mesh, angle, torque = drawn(seed)
    places, found = np.array([angle]), []
    for hollow in (None, math.inf):
        room = Solved.of(mesh.drive)
        if hollow:
            room.drive.gf[:, engine.HOLLOW] = hollow
        assert room.at(places, torque) < 0
        found.append((room.rows[0, [engine.LOW, engine.HIGH, engine.LAG]], room.forces[0]))
    (lags, force), (others, whole) = found
    assert lags == pytest.approx(others, rel=SAME)
    assert force == pytest.approx(whole, rel=0, abs=1e-12 * max(whole))


def rough(seed: int) -> tuple[CycloidMesh, float]:
    """A mesh of one disc on pins that stand nearly as far off as its valleys are round, and a crank
    angle at or beside which some pin is at its dead angle.
    """
    r = random.Random(seed)
    mesh, _, _ = drawn(seed, law=LinearLaw(1e8))
    disc, kind = mesh.disc, r.choice(["tighter", "few", "any"])
    least = min(disc.valley_radius, disc.min_path_radius / 4, disc.eccentricity / 4)
    size = r.uniform(0.8, 0.99) * least
    change = {"tighter": -size, "few": 0.3 * size, "any": 0.0}[kind]
    most = {"tighter": 0.0, "few": 0.5 * size, "any": 0.8 * size}[kind]
    made = [
        tuple(r.uniform(-most, most) * r.choice((0, 1)) for _ in range(disc.pins)) for _ in "rt"
    ]
    pin = min(disc.ring_pin_radius, 0.8 * disc.min_path_radius - max(change, 0.0))
    return replace(
        mesh,
        disc=replace(disc, modification=Modification(change), ring_pin_radius=pin),
        crank_angles=(0.0,),
        deviations=RingDeviations(*made),
    ), math.pi / disc.pins * r.randrange(2 * disc.pins) + r.choice((0.0, 1e-4, 0.01, 0.05))


def unloaded(mesh: CycloidMesh, angle: float) -> Solved:
    """A position without load."""
    room, places = Solved.of(mesh.drive), np.array([angle])
    engine.unloaded(places, 1.0, False, room.drive, room.work, room.rows, room.plays)
    return room


def played(mesh: CycloidMesh, angle: float) -> tuple[float, float] | None:
    """Lags at which pins touch; None where some press."""
    row = unloaded(mesh, mesh.wave(angle)).rows[0]
    return None if row[engine.PRESSED] else (float(row[engine.LOW]), float(row[engine.HIGH]))


@pytest.mark.parametrize("seed", [0, 1, 2, 6, 25, 37])
def test_play_and_interference_of_rough_parts(seed: int) -> None:
    """Against a search of the nearest point of the path for each pin, at any lag."""
    mesh, angle = rough(seed)
    sought, found = Distances(mesh, angle), played(mesh, angle)
    _, least = sought.freest()
    assert mesh.pressing_at(mesh.wave(angle)) == pytest.approx(least, rel=SEARCHED, abs=1e-15)
    assert (found is None) == (least > 0)
    if found is not None:
        expected = sought.play()
        assert found == pytest.approx(expected, abs=1e-9 * (expected[1] - expected[0]))


@pytest.mark.parametrize("angle", [0.0, 1e-4, -3e-3])
@pytest.mark.parametrize("pin", [0, 6])
def test_the_only_pin_that_is_near_limits_the_play(angle: float, pin: int) -> None:
    """In a valley, where it has no lever before the disc turns, and on a lobe."""
    off = tuple(0.0 if k == pin else 3e-4 for k in range(12))
    mesh = mesh_of(crank_angles=(0.0,), deviations=RingDeviations(pin_radial=off))
    expected = Distances(mesh, angle).play()
    assert played(mesh, angle) == pytest.approx(expected, rel=EXACT)
    position = at(mesh, angle, 1.0)
    for limit, known in zip(position.play, expected, strict=True):
        assert abs(limit - known) <= play_error(position) + 1e-9 * abs(known)


def test_a_lobe_that_presses_is_left_on_either_side() -> None:
    """To the side on which others press less."""
    made = RingDeviations(pin_radial=(*(0.0,) * 6, -2e-4, 0.0, 0.0, -5e-5, 0.0, 0.0))
    for way in (1, -1):
        own = made if way > 0 else replace(made, pin_radial=(0.0, *made.pin_radial[:0:-1]))
        mesh = mesh_of(crank_angles=(0.0,), deviations=own)
        _, expected = Distances(mesh, 0.0).freest()
        assert mesh.pressing_at(0.0) == pytest.approx(expected, rel=SEARCHED)


def test_given_shares_over_the_turn() -> None:
    errors = RingDeviations(disc_phase=(1e-4, -1e-4))
    shared = mesh_of(support=Shares((0.6, 0.4)), deviations=errors, exact=False)
    turn = mesh_over_turn(mesh=shared, output_torque=100.0)
    alone = [
        mesh_over_turn(
            mesh=mesh_of(
                crank_angles=(angle,),
                deviations=RingDeviations(disc_phase=(phase,)),
                exact=False,
            ),
            output_torque=torque,
        )
        for angle, phase, torque in ((0.0, 1e-4, 60.0), (math.pi, -1e-4, 40.0))
    ]
    assert turn.peak_force == pytest.approx(max(each.peak_force for each in alone), rel=EXACT)
    assert turn.max_pressure == pytest.approx(max(each.max_pressure for each in alone), rel=EXACT)
    assert turn.radial_force_ratio_min < 0 < turn.sliding_loss


@pytest.mark.parametrize("angle", [0.0, 1e-5, -1e-5])
def test_a_pressed_pin_at_its_dead_angle_is_seen(angle: float) -> None:
    """The pin has no lever, but presses at any lag."""
    errors = RingDeviations(pin_radial=(*(0.0,) * 6, -5e-5, *(0.0,) * 5))
    found = at(mesh_of(crank_angles=(0.0,), deviations=errors), angle, 10.0)
    assert found.play is None
    assert found.interference == pytest.approx(5e-5 - 3e-5, rel=1e-2)
    assert found.force[0][6] == pytest.approx(1e8 * 2e-5, rel=1e-2)


def test_rolling_elements_of_a_ring_lose_by_the_turning_of_their_sleeves() -> None:
    """A sleeve turns on its pin by what the disc turns it: the disc's velocity at the contact, by
    differences of two positions, over the sleeve's radius. Its bearing resists by mu*F at its bore.
    """
    mesh, mu, bore, crank_speed, step = mesh_of(), 0.0015, 0.003, 100.0, 1e-7
    disc, power = mesh.disc, []

    def centre(crank: float, j: int) -> complex:
        return 1j * disc.eccentricity * np.exp(-1j * (crank + math.pi * j))

    for crank in np.linspace(0, 2 * math.pi, 300, endpoint=False).tolist():
        lost = 0.0
        for j, row in enumerate(at(mesh, crank, 100.0).force):
            pole = centre(crank, j) * (1 + disc.satellite_teeth)  # where the disc stands still
            for k, force in enumerate(row):
                pin = 1j * disc.ring_pin_circle_radius * np.exp(2j * math.pi * k / 12)
                normal = (pole - pin) / abs(pole - pin)
                touch = pin + disc.ring_pin_radius * normal
                arm = touch - centre(crank, j)
                turned = arm * np.exp(1j * step / disc.satellite_teeth)
                velocity = (centre(crank + step, j) + turned - touch) / step * crank_speed
                along = abs((velocity * np.conj(1j * normal)).real)
                lost += mu * force * bore * along / disc.ring_pin_radius
        power.append(lost)
    turn = mesh_over_turn(mesh=mesh, output_torque=100.0)
    rolls = RingFriction(mu, bore, rolling=True)
    found = ring_loss(turn=turn, friction=rolls, input_speed=crank_speed)
    assert found.mean_loss == pytest.approx(float(np.mean(power)), rel=1e-4) and power[0] > 0
    unknown = ring_loss(turn=turn, friction=replace(rolls, sleeve_bore_radius=0.0))
    assert unknown.loss_ratio == pytest.approx(found.loss_ratio * disc.ring_pin_radius / bore)
