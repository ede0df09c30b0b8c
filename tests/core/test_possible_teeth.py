"""Involute teeth that mesh, and their profile shifts."""

import math
import random

import numpy as np
import pytest

from core.errors import InvalidInput, NotKnown
from core.ring.involute import TIPS_APART, InvoluteTeeth, involute_pair, usual_rack
from core.ring.possible_teeth import (
    MISSED,
    SHIFTS,
    USUAL_ADDENDA,
    PossibleTeeth,
    possible_teeth,
)
from core.ring.shift_choice import nearest_ring, shifts_at
from tests.oracles.seeds import seeds
from tests.oracles.teeth import contact_ratio

ANY = {"shifts": np.arange(*SHIFTS, 0.05), "addenda": np.arange(0.1, 1.501, 0.05), "apart": 0.0}


def found(satellite: int, ring: int, closeness: float, degrees: float = 20.0) -> PossibleTeeth:
    """Teeth found for an eccentricity in modules."""
    return possible_teeth(
        satellite_teeth=satellite,
        ring_teeth=ring,
        module=1.0,
        eccentricity=closeness,
        rack=usual_rack(pressure_angle=math.radians(degrees)),
    )


def test_what_meshes_only_with_unusual_teeth_is_told_from_what_never_does():
    reference = found(20, 21, 2.0 / 3.5)
    assert reference.contact_ratio == pytest.approx(0.52, abs=0.03)
    assert not reference.any_mesh
    unusual = found(40, 42, 3.2 / 3)
    assert unusual.contact_ratio == pytest.approx(0.83, abs=0.03)
    assert unusual.any_mesh
    assert found(40, 42, 3.68 / 3).contact_ratio == pytest.approx(1.59, abs=0.03)
    assert found(40, 41, 2.003027 / 2.5).any_mesh


def test_one_tooth_of_difference_needs_more_than_half_a_module():
    """With shifts and stub teeth at will; usual ones need two thirds at least."""
    for satellite in (20, 40, 100):
        mesh = [found(satellite, satellite + 1, 0.01 * e).any_mesh for e in range(53, 72)]
        assert not mesh[0]
        assert mesh[-1]
        assert mesh == sorted(mesh)
        usual = [found(satellite, satellite + 1, 0.01 * e).contact_ratio for e in range(60, 80, 2)]
        assert usual[0] < 1 < usual[-1]
        assert usual == sorted(usual)


def test_it_hangs_on_no_size():
    rack = usual_rack(pressure_angle=math.radians(20))
    given = {"satellite_teeth": 30, "ring_teeth": 32, "rack": rack}
    small = possible_teeth(**given, module=0.5e-3, eccentricity=0.6e-3)
    large = possible_teeth(**given, module=5e-3, eccentricity=6e-3)
    assert small.contact_ratio == pytest.approx(large.contact_ratio, abs=1e-5)
    with pytest.raises(InvalidInput, match="do not mesh any nearer"):
        possible_teeth(**given, module=5e-3, eccentricity=4e-3)


@pytest.mark.parametrize("seed", seeds(25))
def test_the_best_is_that_of_all_that_are_tried_and_exists(seed: int) -> None:
    rng = random.Random(seed)
    satellite, difference = rng.randint(6, 140), rng.choice((1, 1, 2, 3, 4, 6, 8))
    degrees = rng.choice((14.5, 20.0, 20.0, 25.0, 30.0))
    working = math.radians(rng.uniform(0.9 * degrees, 66))
    closeness = difference * math.cos(math.radians(degrees)) / 2 / math.cos(working)
    best = found(satellite, satellite + difference, closeness, degrees)
    given = {"satellite_teeth": satellite, "ring_teeth": satellite + difference}
    given |= {"module": 1.0, "eccentricity": closeness, "angle": degrees}
    tried = contact_ratio(**given)  # a part of what is looked at
    assert tried - 1e-5 <= best.contact_ratio <= tried + 0.25
    tried = contact_ratio(**given, **ANY)
    assert best.any_mesh or tried < 1 - MISSED
    assert not best.any_mesh or tried > 1 - MISSED - 0.25
    if not best.teeth:
        assert best.contact_ratio == 0
        return
    pair = involute_pair(teeth=best.teeth, eccentricity=closeness)
    assert pair.contact_ratio == pytest.approx(best.contact_ratio, abs=1e-5) or (
        pair.contact_ratio > best.contact_ratio  # where the ring's tip goes no farther
    )
    assert abs(pair.normal_backlash) < 1e-12
    assert pair.tip_interference > TIPS_APART - 1e-9
    assert pair.start_roll_satellite >= pair.form_roll_satellite - 1e-12 >= -1e-9
    assert min(pair.satellite_tip_thickness, pair.ring_tip_thickness) > -1e-9
    for height in (best.teeth.satellite_addendum, best.teeth.ring_addendum):
        assert USUAL_ADDENDA[0] - 1e-9 <= height <= USUAL_ADDENDA[1] + 1e-9


@pytest.mark.parametrize("seed", seeds(6))
def test_what_lies_between_is_no_better_than_is_said(seed: int, monkeypatch) -> None:
    rng = random.Random(seed)
    satellite, difference = rng.randint(12, 120), rng.choice((1, 2, 4))
    working = math.radians(rng.uniform(30, 60))
    closeness = difference * math.cos(math.radians(20)) / 2 / math.cos(working)
    coarse = found(satellite, satellite + difference, closeness).contact_ratio
    monkeypatch.setattr("core.ring.possible_teeth.STEP", 0.005)
    beside = closeness * (1 + 1e-12)  # not the one that is kept
    finer = found(satellite, satellite + difference, beside).contact_ratio
    assert coarse - 1e-5 <= finer <= coarse + MISSED


def forty(ring_teeth: int, addendum: float, **more: float) -> InvoluteTeeth:
    """Satellite of 40 teeth in a ring, without shifts unless `more` has them."""
    usual = {"module": 2e-3, "satellite_profile_shift": 0.0, "ring_profile_shift": 0.0}
    return InvoluteTeeth(
        satellite_teeth=40,
        ring_teeth=ring_teeth,
        satellite_addendum=addendum,
        ring_addendum=addendum,
        **usual | more,
    )


LEAST = {
    1.0: [(57.9, 1.28), (44.3, 1.58), (36.7, 1.76), (31.6, 1.87), (25.1, 2.01), (21.0, 2.09)],
    0.8: [(53.7, 1.11), (40.2, 1.34), (32.8, 1.47), (28.0, 1.54), (22.0, 1.62), (20.0, 1.64)],
    0.7: [(51.1, 1.01), (37.8, 1.21), (30.7, 1.31), (26.1, 1.37), (20.3, 1.42), (20.0, 1.42)],
    0.6: [(48.2, 0.91), (35.1, 1.07), (28.3, 1.15), (23.9, 1.19), (20.0, 1.21), (20.0, 1.21)],
}
"""Of 40 teeth without a shift, by addendum, for differences of 1, 2, 3, 4, 6, 8: the least tenth of
a degree that leaves the tips apart, and the contact ratio there; held numbers."""


@pytest.mark.parametrize("addendum", LEAST)
def test_the_least_angle_that_leaves_tips_apart(addendum):
    for difference, (degrees, ratio) in zip((1, 2, 3, 4, 6, 8), LEAST[addendum], strict=True):
        pair = nearest_ring(teeth=forty(40 + difference, addendum))
        assert degrees - 0.1 < math.degrees(pair.line.angle) <= degrees + 1e-6
        assert pair.contact_ratio == pytest.approx(ratio, abs=0.011)
        if degrees > 20:
            assert pair.tip_interference == pytest.approx(TIPS_APART, abs=1e-9)
        else:
            assert pair.tip_interference > TIPS_APART


def test_no_angle_is_found_for_tips_that_never_pass():
    teeth = forty(41, 3.0)
    with pytest.raises(NotKnown, match="tips_overlap"):
        nearest_ring(teeth=teeth)


def test_the_shifts_at_an_eccentricity_have_the_most_contact_that_leaves_tips_apart():
    teeth = forty(42, 0.8, module=3e-3)
    chosen = shifts_at(teeth=teeth, eccentricity=3.68e-3)
    pair = involute_pair(teeth=chosen, eccentricity=3.68e-3)
    assert pair.on_involutes
    assert pair.tip_interference >= TIPS_APART
    assert abs(pair.normal_backlash) < 1e-15
    closer = -0.01 + chosen.satellite_profile_shift, 0.01 + chosen.satellite_profile_shift
    for shift in closer:
        other = forty(
            42,
            0.8,
            module=3e-3,
            satellite_profile_shift=shift,
            ring_profile_shift=shift + pair.line.wider,
        )
        beside = involute_pair(teeth=other, eccentricity=3.68e-3)
        worse = beside.contact_ratio < pair.contact_ratio
        assert worse or beside.tip_interference < TIPS_APART
    with pytest.raises(NotKnown, match="unusual_teeth"):
        shifts_at(teeth=teeth, eccentricity=3.2e-3)


def test_shifts_are_taken_that_keep_the_path_on_involutes():
    """40 teeth of an addendum of 1 without a shift would touch below their involutes."""
    teeth = forty(44, 1.0)
    nearest = nearest_ring(teeth=teeth)
    assert nearest.start_roll_satellite < nearest.form_roll_satellite
    eccentricity = 1.02 * nearest.line.eccentricity
    chosen = shifts_at(teeth=teeth, eccentricity=eccentricity)
    pair = involute_pair(teeth=chosen, eccentricity=eccentricity)
    assert pair.on_involutes
    assert (
        pair.start_roll_satellite - pair.form_roll_satellite < 0.01
    )  # as near to their end as it goes
