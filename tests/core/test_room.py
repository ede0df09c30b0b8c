"""The room of pins in their holes, before any force."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from core.design.results import Results
from core.errors import ImpossibleMechanism
from core.hertz import ElasticMaterial, hertz
from core.material_table import MATERIALS
from core.output.elasticity import CrankSupport, HertzLaw, Shares
from core.output.fit import Fit, solvable
from core.output.mechanism import Mechanism, slip_notices
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations, Rooms
from core.precision import AS_TYPED, EXACT, SAME
from tests.inputs.checks import REF, having
from tests.inputs.misfits import drawn
from tests.oracles.room import highest, room
from tests.oracles.seeds import seeds

MM = 1e-3


def rooms(
    pins=4, satellites=2, ratio=20.0, radius=30.0, pin=2.0, eccentricity=1.5, clearance=0.5, **more
) -> Rooms:
    """Lengths in mm, as the cases are stated."""
    return Rooms(
        mechanism=Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=ratio),
        pin_circle_radius=radius * MM,
        pin_radius=pin * MM,
        eccentricity=eccentricity * MM,
        clearance=clearance * MM,
        **more,
    )


def fit_of(real: RealMechanism) -> Fit:
    return Fit(real.rooms, real)


def turned(degrees: float) -> Deviations:
    return Deviations(disc_phase=(0.0, math.radians(degrees)))


@pytest.mark.parametrize("seed", range(12))
def test_arcs_are_plain_distances(seed: int) -> None:
    """Room, and its sign, at each position for any misfit."""
    rng = random.Random(seed)
    own, sizes = drawn(rng)
    for wave in (rng.uniform(0, 2 * math.pi) for _ in range(3)):
        (found,), _ = own.rooms(np.array([wave]))
        assert found == pytest.approx(room(sizes, wave, 1.0), abs=3e-8)
        low, high = (float(each[0]) for each in own.windows(np.array([wave])))
        assert (low <= high) == (found >= 0) or abs(found) < 1e-9
        if low <= high < math.inf:
            inside, outside = (low + high) / 2, high + 1e-6
            assert sizes.left(wave, inside) >= -1e-12 > sizes.left(wave, outside)


@pytest.mark.parametrize("seed", seeds(1, 2))
def test_the_least_room_is_that_of_a_scan(seed: int) -> None:
    own, sizes = drawn(random.Random(100 + seed))
    found = own.over_turn()
    _, least = highest(lambda wave: -room(sizes, wave, 0.7), 0.0, 2 * math.pi, 25, 5)
    assert found.least <= -least + 1e-6
    if found.crank_angle is not None:
        wave = own.mechanism.wave_angle(found.crank_angle)
        assert room(sizes, wave, 1.0) == pytest.approx(found.least, abs=3e-8)


@pytest.mark.parametrize("seed", seeds(4))
def test_extremes_hold_over_closer_places(seed: int) -> None:
    """Rooms of no place lie beyond the extremes by more than their class, nor windows by more than
    so much of room changes.
    """
    own, _ = drawn(random.Random(200 + seed))
    found, play = own.over_turn(), own.play()
    rng = np.random.default_rng(seed)
    wave = rng.uniform(0, 2 * math.pi, 4000)
    if found.crank_angle is not None:
        least = own.mechanism.wave_angle(found.crank_angle)
        wave = np.concatenate((wave, least + rng.uniform(-1, 1, 1000) * 1e-4))
        wave = np.concatenate((wave, least + rng.uniform(-1, 1, 1000) * 1e-7))
    heights, _ = own.rooms(wave)
    error = 1e-11
    assert found.least - error <= heights.min() and heights.max() <= own.greatest() + error
    wider, closer = (replace(own, clearance=own.clearance + way * error) for way in (1, -1))
    low, high = wider.windows(wave)
    assert play.least <= (high - low).min()
    low, high = closer.windows(wave)
    assert (high - low).max() <= play.greatest


def test_a_disc_that_is_turned_by_a_pitch_goes_onto_the_next_holes() -> None:
    own = rooms()
    for degrees, further in ((90, 1), (-90, 3), (180, 2), (44, 0)):
        deviations, holes = turned(degrees).at_next_holes(own.mechanism)
        assert holes == (0, further)
        if degrees != 44:
            found = replace(own, deviations=deviations).over_turn()
            assert found.least / MM == pytest.approx(0.5, abs=1e-9)
    moved, _ = replace(
        turned(90), hole_radius=((0.0,) * 4, (1e-5, 2e-5, 3e-5, 4e-5))
    ).at_next_holes(own.mechanism)
    # hole 1 has gone from pin 1 to pin 2
    assert moved.hole_radius[1] == (4e-5, 1e-5, 2e-5, 3e-5)


STEEL = ElasticMaterial(210e9, 0.3, yield_strength=800e6)
PRESSED = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    pin_circle_radius=0.05,
    pin_radius=0.008,
    eccentricity=0.002,
    contact_length=0.02,
    law=HertzLaw(),
    clearance=-2e-5,
    pin_material=STEEL,
    hole_material=STEEL,
)


def test_pressed_or_impossible() -> None:
    """Every pair is pressed by exactly the misfit; where that is more than its bodies stand at rest
    nothing goes together.
    """
    fit = fit_of(PRESSED)
    assert fit.elastic.limit == pytest.approx(0.035671122444567e-3, rel=EXACT)
    assert fit.forces_at_limit[0] == pytest.approx(45027.03351387924, rel=EXACT)
    assert fit.misfit == "pressed_without_load" and not fit.impossible
    assert fit.rooms.needed_hole_radius == pytest.approx(0.010, rel=SAME)
    beyond = fit_of(replace(PRESSED, clearance=-3.6e-5))
    assert beyond.misfit == "cannot_assemble" and beyond.impossible
    with pytest.raises(ImpossibleMechanism) as refusal:
        solvable(real=beyond.real)
    assert refusal.value.code == "cannot_assemble" and refusal.value.parameter == "hole_radius"
    unknown = replace(PRESSED, clearance=-3.6e-5, pin_material=replace(STEEL, yield_strength=None),
                      hole_material=replace(STEEL, yield_strength=None))  # fmt: skip
    assert solvable(real=unknown).misfit == "pressed_without_load"  # nothing is proven


def test_the_force_at_the_limit_is_that_of_the_weaker_body() -> None:
    soft = replace(STEEL, yield_strength=400e6)
    fit = fit_of(replace(PRESSED, hole_material=soft, clearance=1e-5))
    contact = hertz(force=fit.forces_at_limit[0], contact_length=0.02, pin_radius=0.008,
                    hole_radius=0.01001, pin_material=STEEL, hole_material=soft)  # fmt: skip
    assert contact.governing_pressure == pytest.approx(1.79 * 400e6, rel=SAME)
    assert MATERIALS["steel_bearing"].material.elastic_pressure == 4000e6


def test_discs_out_of_phase_and_bearings_that_give_way() -> None:
    out = replace(PRESSED, clearance=1e-5, deviations=Deviations(disc_phase=(0.0, 0.005)))
    assert fit_of(out).misfit == "discs_out_of_phase"
    given = replace(PRESSED, clearance=-1e-6, exact=False, support=CrankSupport(1e9, 3e-6))
    assert fit_of(given).misfit == "fits_by_bearing_clearance"
    assert fit_of(replace(given, support=CrankSupport(1e9, 1e-6))).misfit == "pressed_without_load"


def test_satellites_that_turn_for_themselves_have_each_its_own_room() -> None:
    out = replace(PRESSED, clearance=1e-5, deviations=Deviations(disc_phase=(0.0, 0.005)))
    apart = replace(out, exact=False, support=Shares((0.5, 0.5)))
    assert out.rooms.room.state == "does_not_fit"
    assert apart.rooms.room.least == pytest.approx(1e-5, rel=AS_TYPED)
    design = having(REF, hole_radius=0.01001, deviations=out.deviations)
    coupled = having(design, satellite_coupling=Shares((0.5, 0.5)))
    assert Results(design).rooms.room.state == "does_not_fit"
    assert Results(coupled).rooms.room.least == pytest.approx(1e-5, rel=AS_TYPED)


def test_holes_that_do_not_hold_their_pins() -> None:
    apart = 0.05 * math.sin(math.pi / 6)
    limit = math.hypot(0.008, apart)
    solvable(real=replace(PRESSED, clearance=limit - 0.010 - 1e-9))
    with pytest.raises(ImpossibleMechanism) as refusal:
        solvable(real=replace(PRESSED, clearance=limit - 0.010))
    assert refusal.value.code == "no_mechanism"
    assert refusal.value.params["limit_length"] == limit


@pytest.mark.parametrize(
    ("pin", "hole", "eccentricity", "codes"),
    [
        (8, 10.02, 2, []),
        (8, 10.9, 2, []),
        (8, 11.1, 2, ["clearance_like_eccentricity"]),
        (12, 14.5, 1.25,
         ["clearance_like_eccentricity", "diameters_as_radii", "twice_the_eccentricity"]),
        (6, 12, 3, ["clearance_like_eccentricity", "diameters_as_radii",
                    "twice_the_eccentricity"]),
        (3, 9, 1.5, ["clearance_like_eccentricity", "hole_diameter_as_radius"]),
        (6, 5, 1.5, ["pin_diameter_as_radius"]),
        (6, 7.5, 3, ["pin_diameter_as_radius", "eccentricity_doubled"]),
        (6, 6.1, 1.5, ["eccentricity_forgotten"]),
        (8, 9.99, 2, []),
    ],
)  # fmt: skip
def test_slips_are_asked_about(pin: float, hole: float, eccentricity: float, codes: list) -> None:
    found = slip_notices(pin_radius=pin * MM, hole_radius=hole * MM, eccentricity=eccentricity * MM)
    assert [notice.code for notice in found] == codes
    for notice in found[1:]:
        meant = notice.params
        assert meant["hole"] >= meant["pin"] + meant["eccentricity"] - 1e-9  # what is offered fits
