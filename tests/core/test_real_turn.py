"""Forces by which pins, bearings and crankshaft are judged: energy, limits, reference numbers.

Forces of the mechanism as it is made are held against the torque that turns its crank, which comes
from the energy of the contacts; without clearance against the ideal law; with bending pins against
the sharing by their stiffness. Each of these is computed another way.
"""

import math

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from core.crank.crankshaft import reaction_curves
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import bearing_curves, made_parts
from core.errors import ImpossibleMechanism, InvalidInput
from core.hertz import ElasticMaterial
from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    LinearLaw,
    PinSupport,
    PowerLaw,
    pin_compliance,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.pin_beam import face_load_factor
from core.output.pin_fatigue import FatigueStrength
from core.output.real_curves import real_curves
from core.output.real_mechanism import RealMechanism
from core.output.real_turn import refined
from core.output.room import Deviations
from core.precision import CONVERGED, EXACT, JUDGED, SAME
from tests.inputs.loads import crankshaft, pin_strength, satellite_bearings
from tests.inputs.real_mechanisms import UNLIKE, design, made, real_turn, reals

STEEL = ElasticMaterial(210e9, 0.3, yield_strength=800e6)
STRENGTH = FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6)
MESH = RingMesh(0.6922)
LOAD = {"output_torque": 500.0, "pin_circle_radius": 0.05}
PIN = LOAD | {
    "diameter": 0.016,
    "contact_length": 0.02,
    "material": STEEL,
    "fatigue": STRENGTH,
}
BEARING = LOAD | {
    "eccentricity": 2e-3,
    "mesh": MESH,
    "input_speed": 50 * math.pi,
    "kind": "ball",
    "static_rating": 1e5,
}
SHAFT = LOAD | {"eccentricity": 2e-3, "mesh": MESH, "bearing_positions": (0.0, 0.1)}


def spaced(pins: int, satellites: int) -> Mechanism:
    return Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)


def as_made(mechanism: Mechanism, **changes: object) -> RealMechanism:
    kept: dict = {
        "mechanism": mechanism,
        "pin_circle_radius": 0.05,
        "pin_radius": 0.008,
        "eccentricity": 2e-3,
        "contact_length": 0.02,
        "law": LinearLaw(1e8),
        "pin_material": STEEL,
        "hole_material": STEEL,
        "exact": False,
    }
    return RealMechanism(**kept | changes)


def places(mechanism: Mechanism) -> tuple[float, ...]:
    return tuple(0.015 + 0.022 * j for j in range(mechanism.satellites))


@given(real=reals(exact=True), torque=st.sampled_from([200.0, -200.0, 20.0]))
@example(real=UNLIKE, torque=200.0)
@example(real=UNLIKE, torque=-200.0)
@settings(max_examples=3)
def test_the_crank_carries_what_pins_and_ring_press(real: RealMechanism, torque: float) -> None:
    """Across the crank: what turns it by the energy of the contacts. Along it: nothing turns."""
    try:
        turn = real_turn(real=real, output_torque=torque)
    except ImpossibleMechanism:
        assume(False)
    ratio = real.mechanism.ratio
    own = real.deviations.eccentricity or (0.0,) * real.mechanism.satellites
    arms = np.array(own)[:, None] + real.eccentricity
    some = slice(None, None, len(turn.wave) // 7)
    parts = made_parts(turn=turn, arm=1.0, radial_force_ratio=0.0)
    across = turn.on_satellites.imag + parts.ring.imag / (arms * ratio)
    angles = (turn.wave - real.mechanism.initial_crank_angle) / (1 + 1 / ratio)
    curves = real_curves(real=real, crank_angle=angles[some], output_torque=torque)
    on_crank = (arms * across).sum(axis=0)[some]
    size = float(np.abs(curves.force).max()) * real.eccentricity
    assert on_crank == pytest.approx(curves.input_torque, abs=1e-10 * size)
    # the pins turn the output: of all forces about its axis
    about_axis = (turn.couple - arms * turn.on_satellites.imag).sum(axis=0)
    assert about_axis == pytest.approx(torque, abs=1e-9 * size / real.eccentricity * 0.05)
    if real.deviations == Deviations():
        return  # one pin stands for all
    pins = 1j * np.exp(2j * np.pi * np.arange(real.mechanism.pins) / real.mechanism.pins)
    fixed = (np.conj(turn.on_pins) * (1j * pins)[:, None]).sum(axis=1)
    cranks = np.array(turn.crank_angles)[:, None]
    crank = 1j * np.exp(-1j * (turn.wave + cranks))
    turned = np.conj(turn.on_satellites) * crank
    largest = np.abs(turn.on_pins).max()
    # the pins' own directions lag a little behind
    assert np.abs(np.abs(fixed) - np.abs(turned)).max() < 1e-9 * largest


@pytest.mark.parametrize("torque", [500.0, 5.0])
@pytest.mark.parametrize("exact", [True, False])
def test_the_peak_is_that_over_the_turn(exact: bool, torque: float) -> None:
    row = (4e-6, -2e-6, 5e-6, 0.0, -6e-6, 3e-6)
    deviations = Deviations(pin_radial=row, pin_tangential=row[::-1], eccentricity=(4e-6, 1e-6))
    real = as_made(spaced(6, 2), clearance=2e-5, deviations=deviations, exact=exact)
    turn = real_turn(real=real, output_torque=torque)
    peak = over_turn(real=real, output_torque=torque).peak_force
    assert turn.error < 1e-4
    assert np.abs(turn.on_pins).max() == pytest.approx(peak, rel=turn.error)


def test_the_stated_error_is_that_of_closer_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    rough = made(UNLIKE)
    pin = PIN | {"mechanism": UNLIKE.mechanism, "satellite_positions": (0.015, 0.037)}
    bearing = BEARING | {"mechanism": UNLIKE.mechanism}
    shaft = SHAFT | {"mechanism": UNLIKE.mechanism, "satellite_positions": (0.015, 0.037)}
    calls = (
        (lambda of: pin_strength(**pin, made=of), ("peak_force", "peak_equivalent_stress")),
        (lambda of: satellite_bearings(**bearing, made=of), ("peak_load", "equivalent_load")),
        (lambda of: crankshaft(**shaft, made=of), ("peak_reaction", "equivalent_reaction")),
    )
    found = [call(rough) for call, _ in calls]
    monkeypatch.setitem(refined.__kwdefaults__, "near", 1e-6)
    close = made(UNLIKE)
    assert len(close(500.0).wave) > 2 * len(rough(500.0).wave)
    for one, (call, names) in zip(found, calls, strict=True):
        other = call(close)
        error = one.accuracy.relative_error
        assert 3 * other.accuracy.relative_error < error < 2e-4
        for name in names:
            off = np.abs(np.asarray(getattr(one, name)) / getattr(other, name) - 1)
            assert 0 < off.max() < error


def test_spikes_are_not_between_the_samples() -> None:
    """The two pins of the real mechanism's own test whose errors nearly use up the clearance."""
    radial = (0.0, 0.0, 0.0, 0.0, -1.997556539047208e-05, 0.0, -1.999650934149601e-05)
    real = design(
        mechanism=Mechanism.evenly_spaced(pins=7, satellites=1, ratio=18.0),
        law=LinearLaw(5e7),
        exact=False,
        deviations=Deviations(pin_radial=radial),
    )
    turn = real_turn(real=real, output_torque=0.01)
    assert np.abs(turn.on_pins).max() == pytest.approx(24.90392279, rel=max(1e-3, turn.error))


@pytest.mark.parametrize(
    ("pins", "satellites", "exponent"), [(6, 2, 1.0), (5, 3, 1.0), (3, 2, 1.5)]
)
def test_without_clearance_they_are_the_ideal_ones(
    pins: int, satellites: int, exponent: float
) -> None:
    mechanism = spaced(pins, satellites)
    law = LinearLaw(1e8) if exponent == 1 else PowerLaw(exponent, 1000.0, 1e-5)
    real = made(as_made(mechanism, law=law))
    ideal = {"mechanism": mechanism, "force_exponent": exponent}
    for direction in ("driving", "reverse", "alternating"):
        same = ideal | {"torque_direction": direction}
        given_places = {"satellite_positions": places(mechanism)}
        one, other = (
            pin_strength(**same, **PIN, **given_places, made=each) for each in (None, real)
        )
        room = {"rel": 2e-5}
        for name in ("peak_force", "peak_moment", "peak_equivalent_stress", "peak_shear_stress"):
            assert getattr(other, name) == pytest.approx(getattr(one, name), **room)
        assert other.fatigue.safety_factor == pytest.approx(one.fatigue.safety_factor, **room)
        assert other.deflection.slope == pytest.approx(one.deflection.slope, **room)
        assert other.accuracy.relative_error < 2e-5
        one, other = (satellite_bearings(**same, **BEARING, made=each) for each in (None, real))
        for name in ("peak_load", "min_load", "equivalent_load", "peak_ring_force"):
            assert getattr(other, name) == pytest.approx(getattr(one, name), **room)
        one, other = (
            crankshaft(**same, **SHAFT, **given_places, made=each) for each in (None, real)
        )
        assert other.peak_reaction == pytest.approx(one.peak_reaction, **room)
        assert other.equivalent_reaction == pytest.approx(one.equivalent_reaction, **room)
        assert other.accuracy.relative_error < 1e-4


@pytest.mark.parametrize(("pins", "satellites"), [(6, 2), (3, 2)])
def test_bending_pins_share_by_their_stiffness(pins: int, satellites: int) -> None:
    """The load sharing of pins that bend, in first order: one more way to the same forces."""
    mechanism = spaced(pins, satellites)
    held = PinSupport("cantilever", 0.016, places(mechanism), STEEL)
    real = as_made(mechanism, pin=held)
    stiffness = tuple(1 / (1e-8 + each) for each in pin_compliance(held))
    turn = real_turn(real=real, output_torque=500.0)
    angles = np.array(mechanism.crank_angles)[:, None] + 2 * np.pi * np.arange(pins) / pins
    cosines = np.maximum(-np.sin(turn.wave + angles[..., None]), 0)  # (K, N, n)
    shares = np.array(stiffness)[:, None, None] * cosines
    force = 10_000 * shares / (shares * cosines).sum(axis=(0, 1))
    assert np.abs(turn.on_pins[:, 0]) == pytest.approx(force[:, 0], abs=1e-1)
    torque = 0.05 * (force * cosines).sum(axis=1)
    assert turn.couple == pytest.approx(torque, abs=5e-3)


def test_reverse_and_alternating() -> None:
    mechanism = spaced(3, 1)
    reference = PIN | {"mechanism": mechanism, "satellite_positions": (0.015,)}
    there, back, both = (
        pin_strength(**reference, torque_direction=each, locus=True)
        for each in ("driving", "reverse", "alternating")
    )
    assert back.fatigue.safety_factor == pytest.approx(there.fatigue.safety_factor, rel=SAME)
    turned = abs(back.fatigue.direction - there.fatigue.direction) % (2 * math.pi)
    # chi and its mirror image are as bad
    mirrored = (back.fatigue.direction + there.fatigue.direction) % (2 * math.pi)
    assert min(abs(turned - math.pi), abs(mirrored - math.pi)) < 1e-4
    assert both.fatigue.mean == 0
    assert both.fatigue.amplitude == pytest.approx(there.peak_bending_stress, rel=EXACT)
    assert (np.diff(back.locus.crank_angle) >= -1e-12).all()
    turn = mechanism.crank_angle_per_wave
    later = np.interp(
        there.locus.crank_angle + turn / 2,
        back.locus.crank_angle,
        back.locus.tangential,
        period=turn,
    )
    straight = 1e-4 * there.peak_moment  # between samples, which lie at other places
    assert later == pytest.approx(-there.locus.tangential, abs=straight)
    # at one crank angle a pin feels one direction or the other
    now = np.interp(
        there.locus.crank_angle, back.locus.crank_angle, back.locus.tangential, period=turn
    )
    assert np.abs(now * there.locus.tangential).max() < 1e-6 * there.peak_moment**2
    reference |= {"mechanism": spaced(6, 2), "satellite_positions": (0.015, 0.037)}
    both = pin_strength(**reference, torque_direction="alternating").fatigue
    assert f"{both.safety_factor:.3f}" == "0.978"


def test_the_crankshaft_in_reverse() -> None:
    """Cranks ahead become cranks behind: as of the mirrored mechanism, driving."""
    three = Mechanism(pins=5, crank_angles=(0.0, 2.0, 3.5), ratio=20.0)
    mirrored = Mechanism(pins=5, crank_angles=(0.0, -2.0, -3.5), ratio=20.0)
    shaft = SHAFT | {"satellite_positions": (0.015, 0.037, 0.059)}
    back = crankshaft(**shaft, mechanism=three, torque_direction="reverse")
    other = crankshaft(**shaft, mechanism=mirrored)
    assert back.peak_reaction == pytest.approx(other.peak_reaction, rel=SAME)
    there = crankshaft(**shaft, mechanism=three)
    assert abs(there.peak_reaction / back.peak_reaction - 1).max() > 1e-3
    worse = crankshaft(**shaft, mechanism=three, torque_direction="alternating")
    for name in ("peak_reaction", "equivalent_reaction"):
        most = np.maximum(getattr(there, name), getattr(back, name))
        assert getattr(worse, name) == pytest.approx(most, rel=CONVERGED)


def test_curves_in_reverse() -> None:
    shaft = {"mechanism": Mechanism(pins=5, crank_angles=(0.0, 2.0, 3.5), ratio=20.0)} | LOAD
    shaft |= {"eccentricity": 2e-3, "torque_direction": "reverse"}
    angles = np.linspace(0, 6.0, 20_001)
    ring = {"radial_force_ratio": 0.6922, "crank_angle": angles}
    loads = bearing_curves(**shaft, **ring)
    found = satellite_bearings(**BEARING | shaft)
    assert loads.load.max(axis=0) == pytest.approx(found.peak_load, rel=JUDGED)
    assert 2e-3 * 20 * loads.across.sum(axis=1) == pytest.approx(-500.0, rel=SAME)
    # those pairs carry that would brake, at the same crank angle
    real = real_turn(real=as_made(shaft["mechanism"]), output_torque=-500.0)
    psi = angles[1000] * (1 + 1 / 20)
    order = np.argsort(real.wave % (2 * math.pi))
    own = [np.interp(psi, (real.wave % (2 * math.pi))[order], row[order]) for row in real.couple]
    assert loads.across[1000] * 0.04 == pytest.approx(own, abs=0.02)
    places = {"satellite_positions": (0.015, 0.037, 0.059), "bearing_positions": (0.0, 0.1)}
    cranks = shaft["mechanism"].crank_angles
    curves = reaction_curves(loads=loads, crank_angles=cranks, **places)
    shaft |= places
    reactions = crankshaft(**SHAFT | shaft).peak_reaction
    assert np.abs(curves.reaction).max(axis=0) == pytest.approx(reactions, rel=JUDGED)


def test_a_larger_torque_and_a_peak_torque() -> None:
    mechanism = spaced(6, 2)
    reference = PIN | {"mechanism": mechanism, "satellite_positions": (0.015, 0.037)}
    plain = pin_strength(**reference)
    harder = pin_strength(**reference | {"output_torque": 750.0})
    doubled = pin_strength(**reference, peak_torque=1000.0)
    assert harder.peak_force == pytest.approx(1.5 * plain.peak_force, rel=CONVERGED)
    assert harder.fatigue.safety_factor == pytest.approx(
        plain.fatigue.safety_factor / 1.5, rel=EXACT
    )
    assert harder.static_safety_factor == pytest.approx(plain.static_safety_factor / 1.5, rel=SAME)
    assert doubled.static_safety_factor == pytest.approx(
        plain.static_safety_factor / 2, rel=CONVERGED
    )
    assert doubled.fatigue == plain.fatigue
    real = made(as_made(mechanism, clearance=2e-5))
    found = pin_strength(**reference, made=real, peak_torque=1000.0)
    again = pin_strength(**reference | {"output_torque": 1000.0}, made=real)
    assert found.static_safety_factor == pytest.approx(again.static_safety_factor, rel=CONVERGED)
    assert found.peak_force < again.peak_force
    bearing = BEARING | {"mechanism": mechanism}
    plain = satellite_bearings(**bearing)
    peak = satellite_bearings(**bearing, peak_torque=1000.0)
    assert peak.static_safety_factor == pytest.approx(plain.static_safety_factor / 2, rel=CONVERGED)
    assert (peak.equivalent_load == plain.equivalent_load).all()
    loose = satellite_bearings(**bearing, made=real, peak_torque=1000.0)
    again = satellite_bearings(**bearing | {"output_torque": 1000.0}, made=real)
    assert loose.static_safety_factor == pytest.approx(again.static_safety_factor, rel=CONVERGED)


def test_of_both_directions_the_worse_counts() -> None:
    real = made(UNLIKE)
    every = {"mechanism": UNLIKE.mechanism, "made": real}
    two = {"satellite_positions": (0.015, 0.037)}
    ways = ("driving", "reverse", "alternating")
    pins = [pin_strength(**PIN, **every, **two, torque_direction=way) for way in ways]
    bearings = [satellite_bearings(**BEARING, **every, torque_direction=way) for way in ways]
    shafts = [crankshaft(**SHAFT, **every, **two, torque_direction=way) for way in ways]
    for found, names in (
        (pins, ("peak_force", "peak_moment", "peak_shear_force", "peak_equivalent_stress")),
        (bearings, ("peak_load", "equivalent_load", "peak_ring_force")),
        (shafts, ("peak_reaction", "equivalent_reaction")),
    ):
        for name in names:
            there, back, both = (np.asarray(getattr(each, name)) for each in found)
            assert abs(there / back - 1).max() > 1e-4
            assert both == pytest.approx(np.maximum(there, back), rel=SAME)
    assert (bearings[2].min_load <= bearings[0].min_load).all()
    there, back, both = (each.fatigue.safety_factor for each in pins)
    assert both < 0.8 * min(there, back)  # each cycle has both directions


def test_the_worst_pin_counts() -> None:
    """One pin 20 um ahead of all others carries more than they do."""
    ahead = (0.0, 0.0, 2e-5, 0.0, 0.0, 0.0)
    mechanism = spaced(6, 2)
    reference = PIN | {"mechanism": mechanism, "satellite_positions": (0.015, 0.037)}
    # a pin behind its place in the driving sense is met first by its hole
    behind = Deviations(pin_tangential=tuple(-each for each in ahead))
    found = pin_strength(**reference, made=made(as_made(mechanism, deviations=behind)))
    assert found.pin == 3
    assert found.peak_force > 1.05 * pin_strength(**reference).peak_force


@pytest.mark.parametrize("rho", [0.7, -0.3, 3.0])
def test_the_error_of_the_ring_counts_beside_that_of_the_samples(rho: float) -> None:
    """Reference: ideal forces with a ratio that is off by its stated error."""
    mechanism = spaced(6, 2)
    own = {"mechanism": mechanism, "made": made(as_made(mechanism, clearance=1e-5))}
    moved = rho + 1e-3 * max(1.0, abs(rho))
    meshes = (RingMesh(rho), RingMesh(moved), RingMesh(rho, error=1e-3))
    held = SHAFT | {"satellite_positions": places(mechanism)}
    bearings = [satellite_bearings(**BEARING | own | {"mesh": each}) for each in meshes]
    shafts = [crankshaft(**held | own | {"mesh": each}) for each in meshes]
    for found, name, least in ((bearings, "peak_load", 1e-3), (shafts, "peak_reaction", 0.0)):
        exact, other, told = found
        off = np.abs(getattr(other, name) / getattr(exact, name) - 1).max()
        added = told.accuracy.relative_error - exact.accuracy.relative_error
        assert max(off, least) <= added * (1 + 1e-9) < 20 * max(off, least)


def test_clearance_of_crank_bearings_counts() -> None:
    mechanism = spaced(6, 2)
    bearing = BEARING | {"mechanism": mechanism}
    rigid, soft = (
        satellite_bearings(**bearing, made=made(as_made(mechanism, clearance=1e-5, support=each)))
        for each in (RIGID_SUPPORT, CrankSupport(1e8, 1e-5))
    )
    assert abs(soft.peak_load / rigid.peak_load - 1).max() > 1e-4


@given(slope=st.floats(1e-6, 0.02), approach=st.floats(1e-6, 1e-4))
def test_the_face_load_factor_by_slices(slope: float, approach: float) -> None:
    """Slices along the contact, each with a load in proportion to its own approach."""
    length, slices = 0.02, 20_000
    x = (np.arange(slices) + 0.5) / slices * length
    low, high = -slope * length, approach + slope * length
    for _ in range(80):
        middle = (low + high) / 2
        mean = np.maximum(middle + slope * x, 0).mean()
        low, high = (middle, high) if mean < approach else (low, middle)
    by_slices = (low + slope * length) / approach
    factor = face_load_factor(slope=slope, contact_length=length, approach=approach)
    assert factor == pytest.approx(by_slices, rel=1e-3)


def test_the_face_load_factor_takes_arrays() -> None:
    slopes, approaches = np.meshgrid(np.linspace(0, 5e-3, 6), np.linspace(3e-6, 2e-5, 5))
    many = face_load_factor(slope=slopes, contact_length=0.02, approach=approaches)
    for index in np.ndindex(many.shape):
        slope, approach = float(slopes[index]), float(approaches[index])
        one = face_load_factor(slope=slope, contact_length=0.02, approach=approach)
        assert many[index] == pytest.approx(one, rel=CONVERGED)
    with pytest.raises(InvalidInput):
        face_load_factor(slope=-1e-3, contact_length=0.02, approach=1e-5)


@pytest.mark.parametrize("torque", [1e-3, 1e-5])
def test_samples_of_a_torque_that_vanishes_are_few(torque: float) -> None:
    """More samples do not straighten forces as small as their error."""
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=8, satellites=2, ratio=43.0),
        pin_circle_radius=0.05,
        pin_radius=0.007,
        eccentricity=1.5e-3,
        contact_length=0.02,
        clearance=2e-5,
        law=LinearLaw(5e8),
        pin_material=STEEL,
        hole_material=STEEL,
    )
    assert real_turn(real=real, output_torque=torque).wave.size < 5_000
