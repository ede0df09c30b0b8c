"""A floating tie ring: held numbers, a frame of finite elements, limits, invariants, refusals."""

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.errors import InvalidInput
from core.hertz import ElasticMaterial
from core.output.contact_force import force_ratios
from core.output.elasticity import LinearLaw, PinSupport, PowerLaw, ring_of
from core.output.loaded_position import LoadedPosition, loaded_position
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam
from core.output.pin_strength import PinStrength
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.tie_ring import RingForces, RingJoint, TieRing, ring_forces
from core.output.tied_pin import TiedPin
from core.precision import EXACT, JUDGED, SEARCHED
from tests.inputs.loads import pin_strength
from tests.inputs.real_mechanisms import STEEL, made
from tests.oracles import tie_ring as oracle

CASES = {
    case["name"]: case
    for case in json.loads((Path(oracle.__file__).parent / "tie_ring_cases.json").read_text())
}
JOINTS: tuple[RingJoint, ...] = ("pinned", "clamped")
PLACES, SPAN = (0.015, 0.037), 0.052
TWO = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
STRONG = replace(STEEL, yield_strength=800e6)


def named(start: str) -> list[Any]:
    return [pytest.param(case, id=name) for name, case in CASES.items() if name.startswith(start)]


def ring(joint: RingJoint, diameter: float = 0.016, places: Any = PLACES) -> TieRing:
    return ring_of(PinSupport("tie_ring", diameter, places, STEEL, SPAN, ring_joint=joint))


def ring_of_case(pin: dict[str, Any]) -> TieRing:
    """The ring on a pin of a case, which may be a tube: by its own sections."""
    outer, inner = pin["diameter_mm"] / 1e3, pin.get("bore_diameter_mm", 0.0) / 1e3
    wide = 1 + (inner / outer) ** 2
    shear = 10 / 9 * (8.8 * wide**2 + 23.6 * (wide - 1)) / (8.8 * wide**2)  # Cowper's, 0.3
    moment = math.pi * (outer**4 - inner**4) / 64
    area = math.pi * (outer**2 - inner**2) / 4
    rigidity = 210e9 * moment
    return TieRing(
        pin["ring_joint"],
        pin["span_mm"] / 1e3,
        rigidity,
        shear * rigidity / (210e9 / 2.6 * area),
    )


def local(mechanism: Mechanism, crank_angle: float, unit: float) -> np.ndarray:
    """Ideal forces on the pins, tangential + i*radial, shape (K, N, 1)."""
    ratios = force_ratios(mechanism=mechanism, crank_angles=np.array([crank_angle]))
    psi = mechanism.wave_angle(crank_angle)
    crank = 1j * np.exp(-1j * (psi + np.array(mechanism.crank_angles)))[:, None, None]
    tangential = -np.exp(2j * np.pi * np.arange(mechanism.pins) / mechanism.pins)[:, None]
    return np.asarray(np.conj(unit * ratios.transpose(1, 2, 0) * crank / tangential))


def root_moments(own: TieRing, places: Any, forces: np.ndarray, found: RingForces) -> np.ndarray:
    arms = np.array([z + own.end_moment(z) for z in places])
    by_ring = own.span + own.end_moment(own.span)
    return np.asarray(np.tensordot(arms, forces, axes=1) + by_ring * found.forces)


@pytest.mark.parametrize("case", [*named("C1"), *named("C2"), *named("C3"), *named("C4")])
def test_ideal_forces_at_an_angle(case: dict[str, Any]) -> None:
    body, expected = case["body"], case["expect"]
    pin, load = body["pin"], body["load"]
    mechanism = Mechanism.evenly_spaced(**body["mechanism"])
    unit = load["output_torque_Nm"] / load["pin_circle_radius_mm"] * 1e3
    places = [z / 1e3 for z in pin["satellite_positions_mm"]]
    (angle,) = map(math.radians, body["crank_angle_deg"])
    forces, own = local(mechanism, angle, unit), ring_of_case(pin)
    found = ring_forces(rings=[own] * mechanism.pins, positions=places, forces=forces)
    moments = root_moments(own, places, forces, found)
    close = case["tolerance"]["relative"]
    for n in range(mechanism.pins):
        moment, force = (expected[f"at.{name}[{n}]"] for name in ("root_moment_Nm", "ring_force_N"))
        assert abs(moments[n, 0]) == pytest.approx(moment, rel=close)
        assert abs(found.forces[n, 0]) == pytest.approx(force, rel=close)
    radius = load["pin_circle_radius_mm"]
    assert abs(found.shift[0]) * 1e3 == pytest.approx(expected["at.ring_shift_mm"], rel=close)
    turn = abs(found.along[0]) / radius * 1e6
    assert turn == pytest.approx(expected["at.ring_turn_mrad"], rel=close)
    cranks = np.linspace(0, mechanism.crank_angle_per_wave, 2881)
    over = [local(mechanism, phi, unit) for phi in cranks]
    turned = np.concatenate(over, axis=2)
    rings = ring_forces(rings=[own] * mechanism.pins, positions=places, forces=turned)
    peak = np.abs(root_moments(own, places, turned, rings)).max()
    assert peak == pytest.approx(expected["over_turn.peak_root_moment_Nm"], rel=JUDGED)


@cache
def strength(joint: RingJoint | None, support: Any = "tie_ring", **more: Any) -> PinStrength:
    """The reference design: six pins of 16 mm, two satellites, 500 N*m."""
    given = {"output_torque": 500.0, "contact_length": 0.02, "diameter": 0.016} | more
    return pin_strength(
        mechanism=TWO,
        pin_circle_radius=0.05,
        satellite_positions=PLACES,
        material=STRONG,
        support=support,
        span=None if support == "cantilever" else SPAN,
        ring_joint=joint or "pinned",
        **given,
    )


@pytest.mark.parametrize("case", [*named("C1"), *named("C2")])
def test_largest_root_moment_over_the_turn(case: dict[str, Any]) -> None:
    found = strength(case["body"]["pin"]["ring_joint"])
    peak = case["expect"]["over_turn.peak_root_moment_Nm"]
    assert found.peak_moment == pytest.approx(peak, rel=case["tolerance"]["relative"])
    assert found.peak_moment_position == 0
    assert found.tie_ring is not None
    assert (found.tie_ring.peak_end_moment > 0) == (case["body"]["pin"]["ring_joint"] == "clamped")


def test_largest_root_moment_of_twelve_pins() -> None:
    (case,) = (each.values[0] for each in named("C4"))
    found = pin_strength(
        mechanism=Mechanism.evenly_spaced(pins=12, satellites=1, ratio=20.0),
        output_torque=300.0,
        pin_circle_radius=0.045,
        diameter=0.012,
        contact_length=0.014,
        satellite_positions=(0.020,),
        material=STEEL,
        support="tie_ring",
        span=0.045,
    )
    peak = case["expect"]["over_turn.peak_root_moment_Nm"]
    assert found.peak_moment == pytest.approx(peak, rel=EXACT)


@pytest.mark.parametrize("case", [*named("C5"), *named("C6")])
def test_one_loaded_pin(case: dict[str, Any]) -> None:
    pin, expected = case["body"]["pin"], case["expect"]
    own, forces = ring_of_case(pin), np.zeros((1, 6, 1), dtype=complex)
    forces[0, 0] = 1000.0 * (1 if case["body"]["direction"] == "tangential" else 1j)
    found = ring_forces(rings=[own] * 6, positions=(0.037,), forces=forces)
    close = case["tolerance"]["relative"]
    assert abs(found.forces[0, 0]) == pytest.approx(expected["ring_force_N"], rel=close)
    moments = root_moments(own, (0.037,), forces, found)
    assert abs(moments[0, 0]) == pytest.approx(expected["root_moment_Nm"], rel=close)
    bent = own.flexibility(0.037, 0.037) * forces[0, 0] + own.end(0.037) * found.forces[0]
    assert abs(bent[0]) * 1e3 == pytest.approx(expected["deflection_mm"], rel=close)


def test_a_ring_that_turns_with_its_pins_carries_nothing() -> None:
    (case,) = (each.values[0] for each in named("C7"))
    own = ring("pinned")
    forces = np.full((1, 6, 1), case["body"]["equal_tangential_force_N"], dtype=complex)
    found = ring_forces(rings=[own] * 6, positions=(0.037,), forces=forces)
    assert np.abs(found.forces).max() < 1e-9
    moments = root_moments(own, (0.037,), forces, found)
    assert np.abs(moments) == pytest.approx(case["expect"]["root_moment_Nm"], rel=EXACT)
    turn = found.along[0] / 0.05 * 1e3
    assert turn == pytest.approx(case["expect"]["ring_turn_mrad"], rel=EXACT)


def real(joint: RingJoint = "pinned", **more: Any) -> RealMechanism:
    pin = PinSupport("tie_ring", 0.016, PLACES, STEEL, SPAN, ring_joint=joint)
    given: dict[str, Any] = {"mechanism": TWO, "law": LinearLaw(1e8), "clearance": 2e-5}
    return RealMechanism(
        **given | {"pin": pin, "exact": False} | more,
        pin_circle_radius=0.05,
        pin_radius=0.008,
        eccentricity=0.002,
        contact_length=0.02,
        pin_material=STEEL,
        hole_material=STEEL,
    )


def at(mechanism: RealMechanism, degrees: float = 10.0, torque: float = 500.0) -> LoadedPosition:
    angle = math.radians(degrees)
    return loaded_position(real=mechanism, crank_angle=angle, output_torque=torque)


@pytest.mark.parametrize("case", named("C8"))
def test_load_sharing_with_the_ring(case: dict[str, Any]) -> None:
    found, expected = at(real(case["body"]["pin"]["ring_joint"])), case["expect"]
    close = case["tolerance"]["relative"]
    lag = math.degrees(found.rotation) * 60
    assert lag == pytest.approx(expected["rotation_arcmin"], rel=close)
    for name, value in expected.items():
        if name.startswith("force"):
            j, n = int(name[8]), int(name[11])
            assert found.force[j][n] == pytest.approx(value, rel=close)
        if name.startswith("satellite"):
            assert found.satellite_torque[int(name[-2])] == pytest.approx(value, rel=close)
    carried = sum(name.startswith("force") for name in expected)
    assert found.loaded_pairs == carried


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize("pins", [2, 3, 5])
def test_forces_of_the_ring_are_those_of_a_frame(joint: RingJoint, pins: int) -> None:
    rng = np.random.default_rng(pins)
    sizes = rng.uniform(0.010, 0.020, pins)
    frame = oracle.Frame([oracle.Pin(size) for size in sizes], joint, SPAN, PLACES)
    rings = [ring(joint, size) for size in sizes]
    forces = 1e3 * (rng.normal(size=(2, pins)) + 1j * rng.normal(size=(2, pins)))
    along = -np.exp(2j * np.pi * np.arange(pins) / pins)
    fixed = along * np.conj(forces)
    found = ring_forces(rings=rings, positions=PLACES, forces=forces[..., None])
    expected = frame.under(fixed)
    assert along * np.conj(found.forces[:, 0]) == pytest.approx(expected.ring_forces, rel=EXACT)
    assert found.shift[0] == pytest.approx(expected.shift, rel=EXACT)
    assert found.along[0] == pytest.approx(expected.along, rel=EXACT)
    for n, own in enumerate(rings):
        moment = root_moments(
            own, PLACES, forces[:, [n]], RingForces(found.forces[[n]], *found[1:])
        )
        assert abs(moment[0, 0]) == pytest.approx(abs(expected.root_moments[n]), rel=EXACT)
        end = sum(own.end_moment(z) * f for z, f in zip(PLACES, forces[:, n], strict=True))
        end += own.end_moment(SPAN) * found.forces[n, 0]
        assert abs(end) == pytest.approx(abs(expected.end_moments[n]), rel=EXACT, abs=1e-8)


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize(("pins", "degrees", "uneven"), [(6, 37.0, 0.0), (5, 200.0, 1e-5)])
def test_load_sharing_is_that_of_a_frame(
    joint: RingJoint, pins: int, degrees: float, uneven: float
) -> None:
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=2, ratio=20.0)
    smaller = tuple(uneven * math.sin(3 * n) for n in range(pins))
    design = real(joint, mechanism=mechanism, deviations=Deviations(pin_radius=smaller))
    found = at(design, degrees)
    expected = oracle.shared(
        frame=oracle.Frame([oracle.Pin(0.016)] * pins, joint, SPAN, PLACES),
        radius=0.05,
        cranks=mechanism.crank_angles,
        gaps=2e-5 - np.array([smaller, smaller]),
        stiffness=1e8,
        torque=500.0,
        psi=mechanism.wave_angle(math.radians(degrees)),
    )
    largest = expected.forces.max()
    assert found.rotation == pytest.approx(expected.lag, rel=EXACT)
    assert np.array(found.force) == pytest.approx(expected.forces, abs=1e-8 * largest)


@pytest.mark.parametrize("joint", JOINTS)
def test_a_bored_pin_of_the_ring_is_a_tube_with_a_wall(joint: RingJoint) -> None:
    bored = PinSupport("tie_ring", 0.016, PLACES, STEEL, SPAN, 0.010, joint)
    around = (1 + 0.625**2) ** 2  # as Cowper writes it of a tube, with v = 0.3
    kappa = 7.8 * around / (8.8 * around + 23.6 * 0.625**2)
    tube = oracle.Pin(0.016, 0.010, shear_factor=10 / 9 * (7.8 / 8.8) / kappa)
    expected = oracle.shared(
        frame=oracle.Frame([tube] * 6, joint, SPAN, PLACES),
        radius=0.05,
        cranks=TWO.crank_angles,
        gaps=np.full((2, 6), 2e-5),
        stiffness=1 / (1e-8 + 1.136128576e-9),  # with the wall in series
        torque=500.0,
        psi=TWO.wave_angle(math.radians(37.0)),
    )
    found = at(real(pin=bored), 37.0)
    assert found.rotation == pytest.approx(expected.lag, rel=EXACT)
    largest = expected.forces.max()
    assert np.array(found.force) == pytest.approx(expected.forces, abs=1e-7 * largest)


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize("way", [1, 1j])
def test_one_loaded_pin_of_many_has_its_end_held(joint: RingJoint, way: complex) -> None:
    own, many = ring(joint), 4000
    forces = np.zeros((1, many, 1), dtype=complex)
    forces[0, 0] = way
    found = ring_forces(rings=[own] * many, positions=(0.037,), forces=forces)
    propped = own.end(0.037) / own.end(SPAN)
    assert -found.forces[0, 0] / way == pytest.approx(propped, rel=1e-3)


def test_a_ring_far_away_is_none() -> None:
    far = replace(real().pin, span=50.0)  # type: ignore[type-var]
    alone = replace(far, support="cantilever", span=None)
    found, expected = at(real(pin=far)), at(real(pin=alone))
    assert np.array(found.force) == pytest.approx(np.array(expected.force), abs=1.0)
    nearer = at(real(pin=replace(far, span=5.0)))
    off = [np.abs(np.array(each.force) - expected.force).max() for each in (found, nearer)]
    assert off[1] > 5 * off[0] > 0


def test_a_ring_evens_out_and_does_not_hold() -> None:
    """A plate that held the pins' ends would promise much more."""
    alone, fixed = strength(None, "cantilever"), strength(None, "fixed")
    loose, tight = strength("pinned"), strength("clamped")
    assert alone.peak_moment == pytest.approx(123.3333, rel=JUDGED)
    assert loose.peak_moment / alone.peak_moment == pytest.approx(0.6428, abs=1e-4)
    assert tight.peak_moment / fixed.peak_moment == pytest.approx(2.27, abs=0.01)
    supported = strength(None, "supported")
    assert loose.peak_moment / supported.peak_moment == pytest.approx(2.76, abs=0.01)


@pytest.mark.parametrize("joint", JOINTS)
def test_solved_and_ideal_forces_agree_where_contacts_are_soft(joint: RingJoint) -> None:
    """Pins that hardly bend beside their contacts share as the papers say."""
    soft = real(joint, law=LinearLaw(1e5), clearance=0.0)
    ideal, solved = strength(joint), strength(joint, made=made(soft))
    assert solved.peak_moment == pytest.approx(ideal.peak_moment, rel=3e-3)
    assert solved.tie_ring is not None and ideal.tie_ring is not None
    for name in ("peak_force", "shift", "turn"):
        close = pytest.approx(getattr(ideal.tie_ring, name), rel=2e-2)
        assert getattr(solved.tie_ring, name) == close


@pytest.mark.parametrize("joint", JOINTS)
def test_deflection_and_slope_are_those_of_a_frame(joint: RingJoint) -> None:
    """Short loads at two places, and the ring's force as a third; shear forces by balance."""
    own = ring(joint)
    beam = PinBeam("tie_ring", 1e-10, own.rigidity, own.shear_area, SPAN)
    pin = TiedPin(beam, 0.016, np.array(PLACES), ring=own)
    frame = oracle.Frame([oracle.Pin(0.016)] * 4, joint, SPAN, PLACES)
    fixed = np.zeros((2, 4), dtype=complex)
    fixed[0, 0], fixed[1, 0] = 700 + 400j, 300j - 900
    expected = frame.under(fixed)
    loads = np.array([*fixed[:, 0], expected.ring_forces[0]])
    bent = pin.by_unit("deflection", np.array(PLACES)) @ loads
    assert bent == pytest.approx(expected.deflections[:, 0], rel=EXACT)
    near = 1e-7
    for place, slope in zip(PLACES, pin.by_unit("slope", np.array(PLACES)) @ loads, strict=True):
        sides = pin.by_unit("deflection", np.array([place - near, place + near])) @ loads
        bend = (sides[1] - sides[0]) / (2 * near)
        shear = pin.by_unit("shear", np.array([place])) @ loads
        sheared = shear[0] * own.shear_area / own.rigidity
        assert slope + sheared == pytest.approx(bend, rel=1e-4)
    shears = pin.by_unit("shear", np.array([0.0, 0.02, SPAN])) @ loads
    assert shears == pytest.approx([loads.sum(), loads[1:].sum(), loads[2]], rel=EXACT)
    ends = pin.by_unit("moment", np.array([0.0, SPAN])) @ loads
    assert ends == pytest.approx(
        [expected.root_moments[0], expected.end_moments[0]], rel=EXACT, abs=1e-7
    )


def test_both_ways_bend_the_pins_alike() -> None:
    driving, both = strength("clamped"), strength("clamped", torque_direction="alternating")
    assert both.peak_moment == pytest.approx(driving.peak_moment, rel=SEARCHED)
    assert both.tie_ring is not None and driving.tie_ring is not None
    assert both.tie_ring.shift == pytest.approx(driving.tie_ring.shift, rel=JUDGED)


def test_what_cannot_be_is_refused() -> None:
    short = PinSupport("tie_ring", 0.016, PLACES, STEEL, 0.036)
    with pytest.raises(InvalidInput, match=r"satellite_positions\[1\].*smaller than.*span"):
        at(real(pin=short))
    with pytest.raises(InvalidInput, match="span"):
        at(real(pin=replace(short, span=None)))


def test_a_power_law_with_steep_touches_is_solved() -> None:
    found = at(real("clamped", law=PowerLaw(0.5, 1000.0, 1e-6), clearance=-1e-6), 61.0, 1.0)
    assert math.fsum(found.satellite_torque) == pytest.approx(1.0, rel=EXACT)


def test_pins_of_brass_move_more() -> None:
    brass = ElasticMaterial(100e9, 0.34)
    soft = replace(real().pin, material=brass)  # type: ignore[type-var]
    assert at(real(pin=soft)).rotation > at(real()).rotation
