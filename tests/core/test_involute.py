"""Involute teeth of satellite and ring: held pairs, what stays, what is refused."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.errors import ImpossibleMechanism, InvalidInput, NotKnown
from core.hertz import ElasticMaterial
from core.precision import CONVERGED, EXACT, SAME, SEARCHED
from core.ring.involute import Cutter, InvoluteTeeth, Rack, angle_of, involute_pair, usual_rack
from core.ring.involute_load import (
    involute_load,
    loss_ratio,
    mean_loss_ratio,
    pressure_along,
    root_stress,
)
from core.ring.line_of_action import involute
from core.ring.shared_pairs import PAIR_STIFFNESS, pairs_that_carry, shared_torque, touching
from tests.inputs.involute import CASES, drawn, given

STEEL = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)


POSES = [(case, pose) for case in CASES for pose in case.get("poses", ())]


@pytest.mark.parametrize(("case", "pose"), POSES, ids=lambda each: each.get("name", ""))
def test_held_onsets_and_forces(case, pose):
    teeth, eccentricity = given(case)
    pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
    width = case["body"]["gear"]["contact_length_mm"] / 1e3
    angle = 2 * math.pi * pose["satellite_angle_pitches"] / teeth.satellite_teeth
    found = touching(pair=pair, angle=np.array([angle]))
    shared = shared_torque(
        found=found,
        torque=case["body"]["load"]["output_torque_Nm"],
        stiffness=PAIR_STIFFNESS * width,
    )
    row = {int(tooth): column for column, tooth in enumerate(found.pair)}
    for tooth, expected in pose["onset_urad"].items():
        column = row[int(tooth)]
        assert found.onset[0, column] == pytest.approx(
            1e-6 * expected["value"], rel=EXACT, abs=1e-15
        )
        assert found.lever[0, column] == pytest.approx(1e-3 * expected["lever_mm"], rel=EXACT)
        assert found.at_corner[0, column] == (expected["kind"] != "path")
    carried = {str(tooth): force for tooth, force in zip(found.pair, shared.force[0], strict=True)}
    carried = {tooth: force for tooth, force in carried.items() if force}
    assert carried == pytest.approx(pose["force_N"], rel=EXACT)
    assert shared.rotation[0] == pytest.approx(1e-6 * pose["rotation_urad"], rel=EXACT)


@pytest.mark.parametrize("seed", range(12))
def test_ratios_hang_on_no_size_and_backlash_vanishes_where_it_should(seed):
    teeth, _ = drawn(seed)
    pair = involute_pair(teeth=teeth)
    larger = involute_pair(teeth=replace(teeth, module=7 * teeth.module))
    assert larger.contact_ratio == pytest.approx(pair.contact_ratio, rel=EXACT, abs=1e-9)
    if pair.tip_interference is not None:
        assert larger.tip_interference == pytest.approx(pair.tip_interference, abs=1e-9)
    assert larger.line.eccentricity == pytest.approx(7 * pair.line.eccentricity, rel=SAME)
    without = pair.eccentricity_without_backlash
    again = involute_pair(teeth=teeth, eccentricity=without)
    assert abs(again.normal_backlash) < 1e-12 * teeth.module * teeth.ring_teeth
    room = 1e-4 * (
        without - teeth.module * teeth.difference / 2 * math.cos(teeth.rack.pressure_angle)
    )
    assert involute_pair(teeth=teeth, eccentricity=without - room).backlash > 0
    assert involute_pair(teeth=teeth, eccentricity=without + room).backlash < 0


def test_tips_that_overlap_all_round_have_no_crossing_and_are_no_room():
    """A formula that takes what has no arccosine for no interference would let these pass."""
    teeth, _ = given(CASES[0])
    high = replace(teeth, ring_profile_shift=1e-3, satellite_addendum=0.9, ring_addendum=0.6)
    pair = involute_pair(teeth=high)
    assert pair.tips_overlap_all_round
    assert pair.start_roll_satellite >= pair.form_roll_satellite >= 0
    assert not pair.on_involutes
    assert pair.tip_interference is None
    assert pair.tip_gap is None
    apart = involute_pair(teeth=replace(high, satellite_addendum=-0.9, ring_addendum=-0.9))
    assert apart.tip_interference is None
    assert not apart.tips_overlap_all_round
    assert apart.contact_ratio < 0


def test_flanks_touch_on_involutes_of_both_as_far_as_their_tools_go():
    teeth, _ = given(CASES[4])
    assert involute_pair(teeth=teeth).on_involutes
    low = involute_pair(teeth=replace(teeth, cutter=Cutter(30, addendum=0.9)))
    assert low.form_roll_ring < low.end_roll_ring
    assert not low.on_involutes
    deep = involute_pair(teeth=replace(teeth, ring_addendum=1.0))
    assert deep.start_roll_satellite < deep.form_roll_satellite
    assert not deep.on_involutes
    assert involute_pair(teeth=replace(teeth, cutter=None)).form_roll_ring is None


def test_a_root_beyond_the_method_is_not_known():
    """A sharp fillet, and a tooth without a section."""
    loaded = {"torque": 100.0, "contact_length": 0.02}
    teeth, _ = given(CASES[6])
    assert root_stress(pair=involute_pair(teeth=teeth), **loaded).root_stress_one_pair > 0
    shifted = {"satellite_profile_shift": 0.8, "ring_profile_shift": 1.4}
    few = {"satellite_teeth": 2, "ring_teeth": 10, "satellite_profile_shift": 0.78}
    few |= {"ring_profile_shift": 2.76, "satellite_addendum": 0.9, "ring_addendum": 1.07}
    for beyond in (replace(teeth, rack=Rack(tip_radius=0.01), **shifted), replace(teeth, **few)):
        with pytest.raises(NotKnown, match="root_unknown"):
            root_stress(pair=involute_pair(teeth=beyond), **loaded)


def test_tip_circles_that_just_touch_are_not_taken_for_apart():
    """The satellite's tip circle exceeds the ring's by twice the eccentricity but for rounding."""
    for module in (1e-3, 2e-3, 3e-3, 3.5e-3):
        teeth = InvoluteTeeth(
            satellite_teeth=40,
            ring_teeth=42,
            module=module,
            satellite_profile_shift=0.0,
            ring_profile_shift=0.0,
            satellite_addendum=1.0,
            ring_addendum=1.0,
        )
        pair = involute_pair(teeth=teeth)
        assert pair.tips_overlap_all_round or pair.tip_interference < 0


def test_the_torque_reserve_of_pressure_is_its_square_and_that_of_the_root_is_linear():
    pair = involute_pair(teeth=given(CASES[1])[0])
    loaded = {"pair": pair, "contact_length": 0.02}
    steel = {"satellite_material": STEEL, "ring_material": STEEL}
    once = involute_load(**loaded, **steel, torque=100.0)
    twice = involute_load(**loaded, **steel, torque=100.0, load_factor=4.0)
    assert twice.pressure_one_pair_start == pytest.approx(
        2 * once.pressure_one_pair_start, rel=CONVERGED
    )
    assert twice.normal_force == once.normal_force
    roots = [
        root_stress(**loaded, torque=100.0, load_factor=k).root_stress_one_pair for k in (1.0, 4.0)
    ]
    assert roots[1] == pytest.approx(4 * roots[0], rel=CONVERGED)


def test_pressure_falls_along_the_path_and_is_that_of_its_ends():
    pair = involute_pair(teeth=given(CASES[4])[0])
    loaded = {"pair": pair, "torque": 300.0, "contact_length": 0.02}
    loaded |= {"satellite_material": STEEL, "ring_material": STEEL}
    rolls = np.linspace(pair.start_roll_satellite, pair.end_roll, 33)
    along, ends = pressure_along(**loaded, roll=rolls), involute_load(**loaded)
    assert (np.diff(along) < 0).all()
    assert along[0] == pytest.approx(ends.pressure_one_pair_start)
    assert along[-1] == pytest.approx(ends.pressure_one_pair_end)
    assert (
        ends.pressure_one_pair_end < ends.iso_pressure_at_pitch_point < ends.pressure_one_pair_start
    )
    assert np.isnan(pressure_along(**loaded, roll=np.array([-0.1]))[0])


def test_a_path_that_starts_below_the_base_circle_has_no_pressure_there():
    teeth = replace(given(CASES[4])[0], ring_addendum=2.42)
    pair = involute_pair(teeth=teeth)
    assert pair.start_roll_satellite < 0
    assert pair.reduced_radius_start is None
    load = involute_load(
        pair=pair,
        torque=100.0,
        contact_length=0.02,
        satellite_material=STEEL,
        ring_material=STEEL,
    )
    assert load.pressure_one_pair_start is None
    assert load.pressure_one_pair_end > 0


def test_flanks_slide_by_their_speeds_at_the_point_of_contact():
    """Velocities of the material points by differences, about their centres."""
    for case in (CASES[0], CASES[4]):
        pair = involute_pair(teeth=given(case)[0])
        line, step = pair.line, 1e-6
        normal = np.exp(-1j * line.angle) * 1j  # of the line, base points at right angles to it
        for roll in (pair.start_roll_satellite, pair.end_roll):
            centre = line.eccentricity
            place = centre + line.satellite_base * np.exp(-1j * line.angle) * (1 + 1j * roll)
            speed = line.ring_teeth / line.satellite_teeth  # satellite's, ring turning by 1
            turned = centre + (place - centre) * np.exp(1j * speed * step)
            relative = (turned - place * np.exp(1j * step)) / step
            along_flank = abs((relative * np.conj(1j * normal)).real)
            # work of friction over that of the torque about the satellite's centre, both turned
            # against each other by speed - 1, while the output turns by that less the crank's
            torque = line.satellite_base
            found = loss_ratio(pair=pair, friction=1.0, roll=roll)
            assert abs((relative * np.conj(normal)).real) < 1e-5
            assert along_flank / (torque * (speed - 1)) == pytest.approx(found, rel=1e-4)


def test_the_mean_loss_is_that_along_the_path():
    for case in CASES:
        pair = involute_pair(teeth=given(case)[0])
        rolls = np.linspace(pair.start_roll_satellite, pair.end_roll, 20_001)
        each = [loss_ratio(pair=pair, friction=0.06, roll=roll) for roll in rolls]
        mean = np.trapezoid(each, dx=1 / 20_000)
        assert mean_loss_ratio(pair=pair, friction=0.06) == pytest.approx(mean, rel=SEARCHED)


def test_more_pairs_carry_than_the_contact_ratio_says():
    found = {}
    for case in CASES:
        teeth, eccentricity = given(case)
        pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
        torque = case["body"]["load"]["output_torque_Nm"]
        width = case["body"]["gear"]["contact_length_mm"] / 1e3
        if case["name"] == "B6":  # whose tips meet
            with pytest.raises(ImpossibleMechanism, match="run into each other"):
                pairs_that_carry(pair=pair, torque=torque, contact_length=width)
            continue
        found[case["name"]] = pairs_that_carry(pair=pair, torque=torque, contact_length=width)
    assert (found["B7"].loaded_pairs_min, found["B7"].loaded_pairs_max) == (5, 6)
    assert found["B7"].largest_share == pytest.approx(0.278, abs=1e-3)
    assert (found["B1"].loaded_pairs_min, found["B1"].loaded_pairs_max) == (2, 3)
    assert all(each.edge_contact for each in found.values())


def test_the_involute_function_is_inverted():
    for angle in (1e-4, 0.01, 0.35, 1.0, 1.4, 1.57):
        assert angle_of(float(involute(angle))) == pytest.approx(angle, rel=EXACT)


@pytest.mark.parametrize(
    ("changed", "name"),
    [
        ({"ring_teeth": 40}, "ring_teeth"),
        ({"ring_teeth": 49}, "ring_teeth"),
        ({"satellite_addendum": -1.3}, "satellite_addendum"),
        ({"ring_addendum": 1.9}, "ring_addendum"),
        ({"ring_profile_shift": -0.1}, "ring_profile_shift"),
        ({"rack": Rack(tip_radius=0.5)}, "rack_tip_radius"),
        ({"module": 0.0}, "module"),
        ({"ring_addendum": math.nan}, "ring_addendum"),
        ({"cutter": Cutter(41)}, "cutter_teeth"),
        ({"cutter": Cutter(38, profile_shift=2.0)}, "cutter_profile_shift"),
        ({"cutter": Cutter(20, addendum=-1.0)}, "cutter_addendum"),
    ],
)
def test_what_cannot_be_is_refused_by_its_name(changed, name):
    teeth, _ = given(CASES[0])
    with pytest.raises(InvalidInput) as refused:
        involute_pair(teeth=replace(teeth, **changed))
    assert refused.value.parameter == name


def test_an_eccentricity_within_the_base_circles_is_refused():
    with pytest.raises(InvalidInput, match="do not mesh any nearer"):
        involute_pair(teeth=given(CASES[0])[0], eccentricity=1.1e-3)


def test_a_steep_rack_has_a_sharper_tip():
    for degrees in (14.5, 20, 25, 30):
        rack = usual_rack(pressure_angle=math.radians(degrees))
        assert 0 < rack.tip_radius <= min(0.38, rack.most_round)
