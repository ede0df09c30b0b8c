"""Involute teeth against points and circles at 40 digits, outlines, and the rack that cuts them."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.precision import EXACT, SAME
from core.ring.involute import InvolutePair, involute_pair
from core.ring.involute_load import root_stress
from core.ring.shared_pairs import pairs_that_carry, shared_torque, touching
from tests.inputs.involute import CASES, as_pair, drawn, given
from tests.oracles.involute import carried, flank_scan, geometry, least_gap, root
from tests.oracles.seeds import seeds


def size_of(name: str, pair: InvolutePair, exact: float) -> float:
    """Size to which the error of a number is relative; the larger term of a difference."""
    teeth = pair.teeth
    if name == "tip_interference":
        return 0.1 * teeth.ring_teeth
    if "thickness" in name or name == "normal_backlash":
        return teeth.module
    if name in ("contact_ratio", "start_roll_satellite", "form_roll_satellite"):
        return max(1.0, abs(exact))
    return abs(exact) / (
        min(1.0, pair.start_roll_satellite) if name == "reduced_radius_start" else 1.0
    )


@pytest.mark.parametrize("seed", seeds(24, 60))
def test_sizes_are_within_their_stated_errors(seed: int) -> None:
    teeth, eccentricity = drawn(seed)
    pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
    stated = float(pair.accuracy.relative_error)
    assert stated < 1e-9
    for name, exact in geometry(as_pair(teeth, eccentricity)).items():
        found = pair.line.angle if name == "angle" else getattr(pair, name)
        assert abs(found - exact) <= stated * size_of(name, pair, abs(exact)), name


@pytest.mark.parametrize("seed", seeds(12))
def test_the_root_is_that_which_the_rack_leaves(seed: int) -> None:
    teeth, _ = drawn(seed)
    found = root_stress(pair=involute_pair(teeth=teeth), torque=1.0, contact_length=1.0)
    for name, exact in root(as_pair(teeth, None)).items():
        assert getattr(found, name) == pytest.approx(float(exact), rel=EXACT)


@pytest.mark.parametrize("seed", seeds(16, 40))
def test_tips_run_into_each_other_where_the_interference_says_so(seed: int) -> None:
    teeth, eccentricity = drawn(seed)
    pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
    gap = least_gap(as_pair(teeth, eccentricity), e=pair.line.eccentricity)
    free = pair.backlash / 2
    if pair.tips_overlap_all_round:
        assert gap < 0
    elif pair.tip_interference is not None:
        # each flank has half of the backlash besides; between two positions some is missed
        room = pair.tip_interference / teeth.satellite_teeth + free
        if room < -2e-3:
            assert gap < 0
        elif room > 0 and pair.start_roll_satellite > max(0.0, pair.form_roll_satellite):
            assert gap > -1e-9


@pytest.mark.parametrize("case", CASES[:3], ids=lambda case: case["name"])
def test_the_gap_of_outlines_changes_its_sign_with_the_interference(case: dict) -> None:
    """Addenda are raised until the interference vanishes; on either side of that."""
    teeth, eccentricity = given(case)

    def at(height: float) -> InvolutePair:
        higher = replace(teeth, satellite_addendum=height, ring_addendum=height)
        return involute_pair(teeth=higher, eccentricity=eccentricity)

    low, high = 0.5, 1.5
    for _ in range(60):
        middle = (low + high) / 2
        inside = at(middle).tip_interference
        low, high = (middle, high) if inside is not None and inside > 0 else (low, middle)
    for off, sign in ((-0.01, 1), (-0.002, 1), (0.002, -1), (0.01, -1)):
        pair = at(low + off)
        near = as_pair(pair.teeth, eccentricity)
        gap = least_gap(near, e=pair.line.eccentricity, positions=20_000)
        touched = gap if sign > 0 else gap - pair.backlash / 2
        assert touched > -1e-9 if sign > 0 else touched < -1e-9


GOOD = [
    seed
    for seed in seeds(60)
    for pair in (involute_pair(teeth=drawn(seed)[0], eccentricity=drawn(seed)[1]),)
    if pair.contact_ratio > 1
    and pair.start_roll_satellite > pair.form_roll_satellite > 0
    and (pair.tip_interference or -1) > 0
]


def test_there_are_random_teeth_that_mesh() -> None:
    assert len(GOOD) >= 5


@pytest.mark.parametrize("seed", GOOD[: max(4, len(seeds(4)))])
def test_pairs_touch_where_a_scan_of_the_rings_flank_finds_them(seed: int) -> None:
    teeth, eccentricity = drawn(seed)
    pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
    angle = 2 * math.pi / teeth.satellite_teeth * 0.37
    found = touching(pair=pair, angle=np.array([angle]))
    own = as_pair(teeth, eccentricity)
    scanned = flank_scan(own, angle=angle, e=pair.line.eccentricity)
    onsets, levers = {}, {}
    for column, tooth in enumerate(found.pair.tolist()):
        onset, expected = float(found.onset[0, column]), scanned[tooth]
        if expected < 0.01:
            # the scan looks at points of the flank alone: a little late, never early
            assert onset <= expected + 1e-13
            assert onset == pytest.approx(expected, abs=2e-7)
            onsets[tooth], levers[tooth] = onset, float(found.lever[0, column])
        else:
            assert onset > 0.009
    forces = carried(onsets, levers, torque=100.0, stiffness=2e8)
    shared = shared_torque(found=found, torque=100.0, stiffness=2e8)
    for column, tooth in enumerate(found.pair.tolist()):
        assert shared.force[0, column] == pytest.approx(forces.get(tooth, 0.0), abs=1e-6)


@pytest.mark.parametrize("case", [CASES[0], CASES[3], CASES[7]], ids=lambda case: case["name"])
def test_no_pair_carries_more_than_is_said_at_any_of_many_positions(case: dict) -> None:
    teeth, eccentricity = given(case)
    pair = involute_pair(teeth=teeth, eccentricity=eccentricity)
    torque = case["body"]["load"]["output_torque_Nm"]
    width = case["body"]["gear"]["contact_length_mm"] / 1e3
    said = pairs_that_carry(pair=pair, torque=torque, contact_length=width)
    angles = np.linspace(0, 2 * math.pi / teeth.satellite_teeth, 3001)
    found = touching(pair=pair, angle=angles)
    force = shared_torque(found=found, torque=torque, stiffness=14e9 * width).force
    share = force.max() * pair.line.satellite_base / torque
    assert said.largest_share >= share * (1 - float(said.accuracy.relative_error))
    assert said.largest_share == pytest.approx(share, abs=1e-4)
    assert (force * found.lever).sum(axis=1) == pytest.approx(torque, rel=SAME)
    loaded = (force > 0).sum(axis=1)
    assert (loaded.min(), loaded.max()) == (said.loaded_pairs_min, said.loaded_pairs_max)
