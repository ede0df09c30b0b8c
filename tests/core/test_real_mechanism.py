"""Clearance, deviations and elasticity: limits, invariants, extremes, refusals."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from core.drive.engine import PIN_FORCE
from core.errors import ImpossibleMechanism, InvalidInput
from core.load_sharing import share_load
from core.output.contact_force import force_peak
from core.output.elasticity import (
    HertzLaw,
    LinearLaw,
    PinSupport,
    PowerLaw,
)
from core.output.loaded_position import LoadedPosition
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.real_turn import sampled
from core.output.room import Deviations
from core.output.summits import summits
from core.output.turn import Turn
from core.precision import CONVERGED, EXACT, JUDGED, SEARCHED
from tests.inputs.classes import lag_error
from tests.inputs.real_mechanisms import (
    STEEL,
    crank_angles,
    design,
    flat,
    reals,
    solved,
)


def same_forces(found: LoadedPosition, forces: list[float], error: float) -> None:
    largest = max(forces)
    assert flat(found) == pytest.approx(forces, rel=0, abs=(1e-14 + error) * largest)


@example(  # pressed pins and infinite stiffness at each touch: Newton alone goes back and forth
    real=RealMechanism(
        mechanism=Mechanism(pins=6, crank_angles=(0.0,), ratio=9.0),
        pin_circle_radius=0.04,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        law=PowerLaw(exponent=0.5, reference_force=1000.0, reference_approach=1e-05),
        clearance=0.0,
        deviations=Deviations(
            pin_radial=(0.0, 0.0, 0.0, 0.0, -9.5e-06, -5.3e-06),
            pin_tangential=(0.0, 0.0, -9.963e-06, 0.0, 0.0, 0.0),
            pin_radius=(0.0, 0.0, 0.0, -1e-05, 0.0, 0.0),
            hole_radial=((4.184e-06, -6.72e-06, 3.695e-06, 0.0, 0.0, 1e-05),),
            hole_tangential=((4.184e-06, 0.0, 3.695e-06, 0.0, 0.0, 1e-05),),
            hole_radius=((0.0, 0.0, 0.0, 0.0, 0.0, 1.084e-06),),
            eccentricity=(0.0,),
            crank_phase=(0.0,),
            disc_phase=(0.00030183,),
        ),
        exact=False,
        pin_material=STEEL,
        hole_material=STEEL,
    ),
    angle=2.0,
    moved=0.0,
)
@given(reals(exact=False), crank_angles, st.floats(-1e-5, 1e-5))
def test_all_pins_moved_along_the_circle(real: RealMechanism, angle: float, moved: float) -> None:
    """First order: the same forces, the lag larger by the shift over R."""
    pins = real.mechanism.pins
    tangential = real.deviations.pin_tangential or (0.0,) * pins
    shifted = replace(real.deviations, pin_tangential=tuple(x + moved for x in tangential))
    found = solved(real, angle, 20.0)
    again = solved(replace(real, deviations=shifted), angle, 20.0)
    error = found.accuracy.relative_error + again.accuracy.relative_error
    same_forces(again, flat(found), error)
    expected = found.rotation + moved / real.pin_circle_radius
    assert abs(again.rotation - expected) <= 2 * lag_error(real.pin_circle_radius, found, again)


@given(st.integers(3, 9), st.integers(1, 3), st.sampled_from([1.0, 10 / 9, 1.5]))
def test_the_ideal_law_is_the_limit_of_no_clearance(
    pins: int, satellites: int, exponent: float
) -> None:
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)
    real = RealMechanism(
        mechanism=mechanism,
        pin_circle_radius=0.040,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        law=PowerLaw(exponent, 1000.0, 1e-6),
        exact=False,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    peak = force_peak(mechanism, exponent)
    found = solved(real, peak.peak_crank_angle, 200.0)
    assert max(flat(found)) == pytest.approx(peak.peak_force_ratio * 5000, rel=CONVERGED)


@pytest.mark.parametrize("torque", [0.5, 3.0, 40.0, 1e4])
def test_rollers_with_gaps_are_the_limit_of_one_lever(torque: float) -> None:
    """Satellites on cranks at one angle, one pin that touches: gaps on one lever."""
    gaps = (0.0, 3e-6, 1e-6, 8e-6)
    real = RealMechanism(
        mechanism=Mechanism(pins=1, crank_angles=(0.0,) * 4, ratio=20.0),
        pin_circle_radius=0.040,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        law=LinearLaw(1e8),
        deviations=Deviations(hole_radius=tuple((gap,) for gap in gaps)),
        exact=False,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    quarter = -math.pi / 2 / (1 + 1 / 20)
    found = solved(real, quarter, torque)
    share = share_load(total=torque / 0.040, stiffness=1e8, gaps=gaps)
    assert flat(found) == pytest.approx(list(share.forces), rel=0, abs=1e-12 * share.largest_force)


def test_wide_clearance_leaves_one_pair() -> None:
    found = solved(design(clearance=3e-4, exact=False), 0.0, 0.01)
    assert found.loaded_pairs == 1
    assert max(flat(found)) == pytest.approx(0.01 / 0.020, rel=CONVERGED)


def test_exact_geometry_comes_to_the_ideal_as_the_load_vanishes() -> None:
    pins = Mechanism.evenly_spaced(pins=3, satellites=1, ratio=18.0)
    off = []
    for stiffness in (1e8, 1e10, 1e12):
        real = design(mechanism=pins, clearance=0.0, law=LinearLaw(stiffness))
        ideal = solved(replace(real, exact=False), 0.3, 30.0)
        off.append(max(flat(solved(real, 0.3, 30.0))) / max(flat(ideal)) - 1)
    assert abs(off[0]) > 50 * abs(off[1]) > 2500 * abs(off[2])


def test_two_pins_at_their_dead_centre() -> None:
    """Exact geometry has an answer, with a warning; first order has none."""
    two = design(mechanism=Mechanism.evenly_spaced(pins=2, satellites=1, ratio=18.0))
    two = replace(two, clearance=1e-5)
    found = solved(two, 0.0, 30.0)
    assert found.rotation == pytest.approx(0.0219720143379281, rel=CONVERGED)
    assert sorted(flat(found)) == pytest.approx([2420.11128568, 2883.392639], rel=EXACT)
    assert [notice.code for notice in found.notices] == ["large_rotation"]
    with pytest.raises(ImpossibleMechanism) as refusal:
        solved(replace(two, exact=False), 0.0, 30.0)
    assert refusal.value.code in {"dead_centre", "not_stable"}


@pytest.mark.parametrize("exact", [False, True])
def test_one_pin(exact: bool) -> None:
    one = design(mechanism=Mechanism(1, (0.0,), 18.0), exact=exact)
    quarter = -math.pi / 2 / (1 + 1 / 18)
    assert max(flat(solved(one, quarter, 1.0))) == pytest.approx(50, rel=1e-2)
    if exact:  # it swings to the other side of its hole
        assert solved(one, -quarter, 1.0).rotation == pytest.approx(2 * 0.0015 / 0.020, rel=1e-2)
        return
    with pytest.raises(ImpossibleMechanism):
        solved(one, -quarter, 1.0)


@pytest.mark.parametrize(
    ("changes", "torque", "code"),
    [
        ({"clearance": -0.0016}, 30.0, "no_room_in_hole"),
        ({"law": LinearLaw(1e3)}, 30.0, "not_stable"),
        ({"law": LinearLaw(1e3), "exact": False}, 30.0, "not_stable"),
        (
            {"law": HertzLaw(), "pin_material": STEEL, "hole_material": STEEL},
            5e4,
            "beyond_hertz",
        ),
    ],
)
def test_what_cannot_be(changes: dict, torque: float, code: str) -> None:
    with pytest.raises(ImpossibleMechanism) as refusal:
        solved(design(**changes), 0.1, torque)
    assert refusal.value.code == code


@pytest.mark.parametrize(
    ("changes", "parameter"),
    [
        ({"law": PowerLaw(0.4, 1000.0, 1e-5)}, "exponent"),
        ({"law": PowerLaw(3.1, 1000.0, 1e-5)}, "exponent"),
        ({"law": LinearLaw(0.0)}, "stiffness"),
        ({"eccentricity": 0.0}, "eccentricity"),
        ({"eccentricity": 0.020}, "eccentricity"),
        ({"deviations": Deviations(pin_radial=(1e-6,) * 7)}, "pin_radial"),
        ({"deviations": Deviations(hole_radius=((1e-6,) * 7,))}, "hole_radius[0]"),
        ({"deviations": Deviations(crank_phase=(math.nan,))}, "crank_phase[0]"),
        ({"pin": PinSupport("fixed", 0.006, (0.01,), STEEL)}, "span"),
        ({"pin": PinSupport("fixed", 0.006, (0.01,), STEEL, 0.01)}, "satellite_positions[0]"),
    ],
)
def test_what_is_refused(changes: dict, parameter: str) -> None:
    with pytest.raises(InvalidInput) as refusal:
        solved(design(**changes), 0.1, 30.0)
    assert refusal.value.parameter == parameter


def test_equal_pressing_is_seen_over_the_turn() -> None:
    found = over_turn(real=design(clearance=-1e-5, exact=False), output_torque=1.0)
    assert found.pressed_without_load
    assert found.backlash_max == found.backlash_min == found.unloaded_transmission_error == 0


def test_spikes_are_not_between_the_positions() -> None:
    """A scan of other positions finds no force above the peak that is stated."""
    errors = Deviations(pin_radial=(0.0, -1.9e-5, 0.0, -1.2e-5, 7e-6, 0.0, -1.95e-5, 0.0))
    real = design(deviations=errors)
    found = over_turn(real=real, output_torque=0.01)
    highest = max(
        max(flat(solved(real, real.mechanism.crank_angle_per_wave * (i + 0.5) / 2000, 0.01)))
        for i in range(2000)
    )
    assert highest <= found.peak_force * (1 + found.accuracy.relative_error)
    assert highest > 0.9 * found.peak_force


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-5, 0.5])
def test_pressed_pairs_beside_their_dead_angle_have_an_answer(angle: float) -> None:
    found = solved(design(clearance=-1e-5), angle, 1e-4)
    assert found.play is None and abs(found.rotation) < 1e-6


@pytest.mark.parametrize("start", [0.0, 0.3, math.pi / 6])
def test_summits_of_a_whole_turn_of_pins_that_are_alike(start: float) -> None:
    """One pitch is solved, but summits may be searched over the whole turn."""
    mechanism = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    real = loose_pins(replace(mechanism, initial_crank_angle=start))
    turn = Turn(real, 400.0)
    grid = turn.values(PIN_FORCE, [start + 2 * math.pi * k / 90 for k in range(90)])
    found = summits(grid=grid, narrow=turn.narrow(PIN_FORCE))
    assert max(each.height for each in found) == pytest.approx(
        over_turn(real=real, output_torque=400.0).peak_force, rel=EXACT
    )
    for each in found:
        assert np.abs(np.exp(1j * each.place) - np.exp(1j * grid.places)).min() < 2 * math.pi / 90


def test_the_turn_of_pins_that_are_alike_is_that_of_pins_that_hardly_differ() -> None:
    """One pitch repeated, and all of it: a pin a femtometre out of place has all solved."""
    mechanism = Mechanism.evenly_spaced(pins=5, satellites=2, ratio=20.0)
    one = loose_pins(mechanism)
    other = replace(one, deviations=Deviations(pin_tangential=(1e-15, 0.0, 0.0, 0.0, 0.0)))
    turns = [over_turn(real=each, output_torque=400.0) for each in (one, other)]
    assert [each.turn.repeats for each in turns] == [5, 1]
    for name in ("peak_force", "backlash_max", "lost_motion", "stiffness_min", "stiffness_max",
                 "transmission_error", "input_torque_ripple", "max_pressure"):  # fmt: skip
        values = [getattr(each, name) for each in turns]
        assert values[0] == pytest.approx(values[1], rel=SEARCHED), name
    forces = [np.array(each.pair_force) for each in turns]
    assert forces[0] == pytest.approx(forces[1], rel=SEARCHED)
    samples = [sampled(each.turn) for each in turns]
    assert samples[0].mean(samples[0].total) == pytest.approx(
        samples[1].mean(samples[1].total), rel=JUDGED
    )
    wave = np.linspace(0, 2 * math.pi, 200)
    loads = [each.at(wave=wave, values=each.on_satellites) for each in samples]
    assert np.abs(loads[0] - loads[1]).max() < 1e-4 * np.abs(loads[1]).max()


def loose_pins(mechanism: Mechanism) -> RealMechanism:
    return RealMechanism(
        mechanism=mechanism, pin_circle_radius=0.05, pin_radius=0.006, eccentricity=0.002,
        contact_length=0.02, law=HertzLaw(), clearance=2e-5, pin_material=STEEL,
        hole_material=STEEL,
    )  # fmt: skip
