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

MM, ARCMIN = 1e-3, math.pi / 10_800


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


# State, least and greatest room in mm, least and greatest play in arcmin: found twice, by arcs and
# by distances that were scanned, when this was specified.
HELD = {
    "clearance of 0.9 e": (
        rooms(satellites=1, ratio=29, radius=33.875, pin=3, eccentricity=1.25, clearance=1.125),
        ("fits", 1.125, 1.125, 228.364493624, 266.020460992),
    ),
    "clearance of 5 e": (
        rooms(satellites=1, clearance=7.5),
        ("fits", 7.5, 7.5, 1725.653806634, 1786.640609953),
    ),
    "two equal discs 9 degrees out": (
        rooms(deviations=turned(9)),
        ("does_not_fit", -1.854882345, -1.603144030, -425.195139277, -399.906893799),
    ),
    "1.5 degrees out": (
        rooms(deviations=turned(1.5)),
        ("fits", 0.107310388, 0.199267041, 24.593857593, 55.287568038),
    ),
    "one hole 2 mm off outward": (
        rooms(pins=6, satellites=1, clearance=0.1,
             deviations=Deviations(hole_radial=((2e-3, *[0.0] * 5),))),
        ("binds_in_turning", -1.9, 0.1, None, None),
    ),
    "one pin": (
        rooms(pins=1, satellites=1, ratio=10, radius=20, pin=3, clearance=0.1),
        ("fits", 0.1, 1.6, 184.613537474, 550.627888294),
    ),
    "two pins, whose ideal mechanism has a dead centre": (
        rooms(pins=2, satellites=1, ratio=10, radius=20, pin=3, clearance=0.05),
        ("fits", 0.05, 0.05, 17.188751326, 129.567340509),
    ),
    "one pin behind": (
        rooms(pins=3, satellites=1, ratio=10, radius=20, pin=3, clearance=0.05,
             deviations=Deviations(pin_tangential=(-1.2e-4, 0.0, 0.0))),
        ("binds_in_turning", -0.002294954, 0.088873156, -0.902804926, 45.648799625),
    ),
    "hole smaller than pin and eccentricity": (
        rooms(satellites=1, ratio=30, radius=17, pin=3.5, eccentricity=0.8, clearance=-0.35),
        ("does_not_fit", -0.35, -0.35, None, None),
    ),
    "holes farther out than any pin reaches": (
        rooms(pins=6, satellites=1, ratio=10, pin=3, clearance=0.3,
             deviations=Deviations(hole_radial=((5e-4,) * 6,))),
        ("does_not_fit", -0.2, -0.149112133, None, None),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HELD)
def test_held_numbers(name: str) -> None:
    own, (state, least, greatest, shortest, longest) = HELD[name]
    found = own.over_turn()
    assert found.state == state
    assert found.least / MM == pytest.approx(least, abs=1e-8)
    assert own.greatest() / MM == pytest.approx(greatest, abs=1e-8)
    if shortest is not None:
        assert [each / ARCMIN for each in own.play()[:2]] == pytest.approx(
            [shortest, longest], abs=1e-5
        )


def test_where_it_binds_and_is_blocked() -> None:
    found = rooms(deviations=turned(9)).over_turn()
    assert math.degrees(found.crank_angle) == pytest.approx(81.428571404, abs=1e-3)
    assert [(each.satellite, each.pin, each.side) for each in found.binding] == [
        (1, 1, "reverse"), (2, 1, "driving")]  # fmt: skip
    radial = HELD["one hole 2 mm off outward"][0]
    assert [each.side for each in radial.over_turn().binding] == ["radial"]
    (blocked,) = radial.blocked()
    assert [math.degrees(each) for each in blocked] == pytest.approx(
        [223.910024772, 461.804260942], abs=1e-6
    )
    behind = HELD["one pin behind"][0].blocked()
    assert [math.degrees(end) for each in behind for end in each] == pytest.approx(
        [205.717509001, 230.397320825, 260.468113318, 284.737915994], abs=1e-6
    )


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


@pytest.mark.parametrize("seed", seeds(2))
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


def test_thinner_pins_have_as_much_more_room() -> None:
    own, _ = drawn(random.Random(7))
    before = own.over_turn()
    thinner = replace(own, pin_radius=own.pin_radius - 1e-4, clearance=own.clearance + 1e-4)
    after = thinner.over_turn()
    assert after.least == pytest.approx(before.least + 1e-4, abs=1e-12)


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


def test_a_spike_of_the_play_is_found_between_places() -> None:
    """Two pins that leave next to nothing: 720 places read 1.24 arcmin."""
    off = (0.0, 0.0, 0.0, 0.0, -1.997556539047208e-5, 0.0, -1.999650934149601e-5)
    spiked = rooms(
        pins=7, satellites=1, ratio=18, radius=20, pin=3, clearance=0.02,
        deviations=Deviations(pin_radial=off),
    )  # fmt: skip
    play = spiked.play()
    assert play.least / ARCMIN == pytest.approx(1.0806301812388652, abs=1e-7)


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
