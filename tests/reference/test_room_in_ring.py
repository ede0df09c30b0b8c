"""Room of the pins in holes of discs that turn in their ring, against plain complex numbers."""

import random
from dataclasses import replace

import numpy as np
import pytest

from core.drive.engine import HIGH, LOW
from core.output.real_mechanism import RealMechanism
from core.output.room import ELSEWHERE
from core.ring.series import MeshesInSeries, in_their_ring
from core.ring.sharing import CycloidMesh
from tests.inputs.series import drawn
from tests.oracles.ring_distance import Distances
from tests.oracles.room import Sizes, room_in_ring
from tests.oracles.seeds import seeds


def out_of_phase(seed: int, most: float) -> MeshesInSeries:
    """Both meshes whose holes are off their teeth by up to so much."""
    found, _, _ = drawn(seed)
    rng = random.Random(seed)
    phase = tuple(rng.uniform(-most, most) for _ in range(found.mechanism.satellites))
    ring, output = found.ring, found.output
    return MeshesInSeries(
        replace(ring, deviations=replace(ring.deviations, disc_phase=phase)),
        replace(output, deviations=replace(output.deviations, disc_phase=phase)),
    )


def turned(ring: CycloidMesh, ratio: float, crank: float) -> list[tuple[float, float]]:
    """From where to where each disc turns in the ring alone, by points of its path."""
    found, own = [], ring.deviations
    for j, angle in enumerate(ring.crank_angles):
        ahead = own.crank_phase[j]
        alone = replace(
            own, eccentricity=own.eccentricity[j : j + 1], crank_phase=(ahead,), disc_phase=()
        )
        teeth = Distances(replace(ring, crank_angles=(angle,), deviations=alone), crank)
        low, high = teeth.play() or (teeth.freest()[0],) * 2
        found.append((low + ahead / ratio, high + ahead / ratio))
    return found


def sizes_of(real: RealMechanism) -> Sizes:
    own, made = real.mechanism, real.deviations
    off = {name: getattr(made, name) for name in made.__slots__ if "ring" not in name}
    hole = real.pin_radius + real.eccentricity + real.clearance
    sizes = own.pins, own.crank_angles, own.ratio, real.pin_circle_radius, real.pin_radius
    return Sizes(*sizes, real.eccentricity, hole, off)


def most_room(series: MeshesInSeries, crank: float) -> tuple[float, list[tuple[float, float]]]:
    """The room at a crank angle by the oracle, and how far each disc turns."""
    free = turned(series.ring, series.mechanism.ratio, crank)
    wave = float(series.mechanism.wave_angle(np.array([crank]))[0])
    return room_in_ring(sizes_of(series.output), wave, free, 0.02), free


@pytest.mark.parametrize("seed", seeds(3, 20))
def test_the_room_is_the_largest_that_discs_find_in_their_ring(seed: int) -> None:
    series = out_of_phase(seed, 2e-3)
    ring, output = series.ring, series.output
    found = in_their_ring(rooms=output.rooms, ring=ring)
    crank = random.Random(seed).uniform(0, 2 * np.pi * series.mechanism.ratio)
    wave = series.mechanism.wave_angle(np.array([crank]))
    (room,), _ = found.rooms(wave)
    exact, free = most_room(series, crank)
    assert exact - ELSEWHERE < room < exact + 1e-10
    (held,), _ = output.rooms.rooms(wave)
    assert held < room + 1e-10
    if len(free) > 1:
        assert held < room - 1e-7
    low, high = (float(each[0]) for each in found.windows(wave))
    assert (low <= high) == (room >= 0)
    if low <= high:
        play = series.unloaded(np.array([crank]))[0]
        assert (low, high) == pytest.approx((play[LOW], play[HIGH]), abs=1e-9)


def test_the_least_room_is_that_of_all_turns() -> None:
    """Pins of the ring deviate: it repeats with all turns of the crank, not with one wave."""
    series = out_of_phase(20, 2e-3)
    found = in_their_ring(rooms=series.output.rooms, ring=series.ring)
    least = found.over_turn()
    assert found.turns == series.ring.disc.pins
    places = np.random.default_rng(3).uniform(0, 2 * np.pi * found.turns, 2000)
    heights, _ = found.rooms(places)
    assert heights.min() >= least.least - least.error
    crank = least.crank_angle
    assert crank is not None
    assert most_room(series, crank)[0] == pytest.approx(least.least, abs=ELSEWHERE)
