"""Oracle test: bearings of cranks, elastic meshes, both meshes in series, pins that bend and tie
rings at once, against stored energy at 30 digits by plain vectors; and their limits.
"""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest

from core.drive import engine
from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    ElasticMesh,
    PinSupport,
    SatelliteSupport,
    Shares,
    Supports,
)
from core.output.loaded_position import loaded_position
from core.output.stage import Stage
from core.precision import EXACT
from core.ring.series import MeshesInSeries, series_position
from tests.inputs import series
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.seeds import seeds
from tests.oracles.stored import Network

LOOSE, FLOATS = CrankSupport(2e8, 1.2e-5), CrankSupport(2e8, 1.6e-5)
SOFT, MESH = CrankSupport(1.5e8), ElasticMesh(3e4)

ALONE = RIGID_SUPPORT, SOFT, LOOSE, MESH, Supports(SOFT, MESH), Supports(LOOSE, MESH)
IN_RING = RIGID_SUPPORT, SOFT, FLOATS
PINS = "", "cantilever", "supported", "fixed", "pinned", "clamped"
CASES = [*product([False], ALONE, PINS), *product([True], IN_RING, PINS)]
"""In a ring or not, what holds the discs, and the pins."""


@pytest.mark.parametrize("seed", seeds(len(CASES)))
def test_forces_lags_and_shifts(seed: int) -> None:
    """Another drive for each seed; forces are within their stated error."""
    inside, support, pins = CASES[seed % len(CASES)]
    output, ring, angle, torque = series.supported(seed, support, pins)
    real = MeshesInSeries(ring, output) if inside else output
    room = real.solved([real.wave(angle)], torque)
    network = Network(output, ring if inside else None, angle, torque)
    near = network.unknowns(room.lags[0, 0], *(each[0] for each in room.discs))
    there = network.rest(near)
    known = np.concatenate([there.force.ravel(), there.ring_force.ravel()])
    forces = [room.forces[0, room.contacts(kind)] for kind in (engine.PIN, engine.LOBE)]
    assert np.abs(np.concatenate(forces) - known).max() <= room.error[0]
    size = network.sizes[: len(near)]
    moved = there.x[: len(near)] * size
    assert np.abs(near * size - moved).max() <= EXACT * np.abs(moved).max()
    if not inside:
        found = loaded_position(real=output, crank_angle=angle, output_torque=torque)
        assert sum(found.satellite_torque) == pytest.approx(torque, rel=EXACT)
    elif support.bearing:
        found = series_position(real=real, crank_angle=angle, output_torque=torque)
        assert np.abs(found.crank_force - np.abs(there.journal)).max() <= EXACT * there.top


@pytest.mark.parametrize("seed", seeds(6))
def test_limits_are_those_of_either_alone(seed: int) -> None:
    """Bearings that are hard and tight leave the series of both meshes; a hard mesh leaves
    bearings; pins that hardly bend are as if rigid, joined or not.
    """

    def forces(real: Stage, angle: float, torque: float) -> np.ndarray:
        return real.solved([real.wave(angle)], torque).forces[0]

    both, angle, torque = series.drawn(seed)

    def held(support: SatelliteSupport, **more: Any) -> MeshesInSeries:
        return replace(both, output=replace(both.output, support=support, **more))

    plain = forces(both, angle, torque)
    count, top = len(plain), plain.max()
    for hard in (CrankSupport(1e17), CrankSupport(1e15, 1e-10), CrankSupport()):
        near = forces(held(hard), angle, torque)
        near = near[: len(both.output.pin_radii)]
        assert near == pytest.approx(plain[: len(near)], rel=0, abs=1e-4 * top)
    assert forces(held(CrankSupport(1e17)), angle, torque)[:count] == pytest.approx(
        plain, rel=0, abs=1e-6 * top
    )
    output = both.output
    alone = replace(output, support=FLOATS)
    stiff = replace(output, support=Supports(FLOATS, ElasticMesh(1e14)))
    assert forces(stiff, angle, torque) == pytest.approx(
        forces(alone, angle, torque), rel=0, abs=1e-6 * top
    )
    tight = replace(output, support=Supports(CrankSupport(1e17), ElasticMesh(3e4)))
    elastic = replace(output, support=ElasticMesh(3e4))
    assert forces(tight, angle, torque) == pytest.approx(
        forces(elastic, angle, torque), rel=0, abs=1e-6 * top
    )
    shares = tuple(w / 6 for w in (1, 2, 3))[: output.mechanism.satellites]
    of = Shares(tuple(w / sum(shares) for w in shares))
    given = [replace(output, support=each) for each in (of, Supports(CrankSupport(1e17), of))]
    one, other = (forces(each, angle, torque) for each in given)
    assert one == pytest.approx(other, rel=0, abs=1e-6 * top)
    hard = replace(STEEL, youngs_modulus=STEEL.youngs_modulus * 1e9)
    places = tuple(0.02 + 0.03 * j for j in range(output.mechanism.satellites))
    pin = PinSupport("tie_ring", 1.9 * output.pin_radius, places, hard, places[-1] + 0.02)
    tied = forces(held(SOFT, pin=pin), angle, torque)
    assert tied == pytest.approx(forces(held(SOFT), angle, torque), rel=0, abs=1e-6 * top)


@pytest.mark.parametrize("seed", seeds(6))
def test_play_of_discs_that_float_is_where_parts_first_touch(seed: int) -> None:
    """Under less and less torque the output comes to the ends of its play; a wider bearing leaves
    more of it, and one that is only tight none more than its crank held it.
    """
    output, ring, angle, torque = series.supported(seed, FLOATS)
    both = MeshesInSeries(ring, output)
    low, high = series_position(real=both, crank_angle=angle, output_torque=torque).play
    for way, end in ((1, high), (-1, low)):
        lags = [
            series_position(real=both, crank_angle=angle, output_torque=way * abs(torque) * part)
            for part in (1e-5, 1e-7)
        ]
        off = [abs(each.rotation - end) for each in lags]
        assert off[1] < 0.02 * off[0] and off[1] < 1e-5 * abs(end)
    plays = []
    for loose in (0.0, 4e-6, 1.6e-5):
        given = MeshesInSeries(ring, replace(output, support=CrankSupport(2e8, loose)))
        found = series_position(real=given, crank_angle=angle, output_torque=torque).play
        plays.append(found[1] - found[0])
    assert plays[0] < plays[1] < plays[2]
