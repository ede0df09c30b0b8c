"""Oracle test: bearings of cranks, elastic meshes, both meshes in series and tie rings at once,
against stored energy by plain vectors; and their limits.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.drive import engine
from core.output.elasticity import (
    CrankSupport,
    ElasticMesh,
    PinSupport,
    SatelliteSupport,
    Shares,
    Supports,
)
from core.output.loaded_position import loaded_position
from core.output.real_mechanism import RealMechanism
from core.output.stage import Solved, Stage
from core.precision import EXACT
from core.ring.series import MeshesInSeries, series_position
from tests.inputs import series
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.seeds import seeds
from tests.oracles.stored import Network, Stored

NEAR = 1e-7
"""Part of the largest force by which forces may differ: of differences of lengths in doubles."""

FLOATS = CrankSupport(2e8, 1.6e-5)
SOFT = CrankSupport(1.5e8)


def unknowns(stage: Stage, room: Solved, network: Network) -> np.ndarray:
    """Solution of the product in the oracle's unknowns, as a start and not an answer."""
    count, (own, off) = network.discs, room.discs
    x = np.zeros(len(network.sizes))
    x[0], x[1 : 1 + count] = room.lags[0, 0], own[0] - network.late
    x[1 + count : 1 + 2 * count], x[1 + 2 * count : 1 + 3 * count] = off[0].real, off[0].imag
    if network.bent:
        b = room.work.b.reshape(network.pins, count, 2)
        plane = network.out[:, None] * (b[..., 0] + 1j * b[..., 1])
        flat = np.stack([plane.real, plane.imag], axis=-1).ravel()
        x[1 + 3 * count : 1 + 3 * count + len(flat)] = flat
    if network.tied:
        x[-3:] = room.lags[0, -3:] / network.sizes[-3:]
    return x + np.random.default_rng(1).normal(0, 1e-7, len(x)) / network.sizes


def compared(real: Stage, output: RealMechanism, ring: Any, angle: float, torque: float) -> Stored:
    """The oracle's equilibrium, whose forces are those of the product."""
    room = real.solved([real.wave(angle)], torque)
    network = Network(output, ring, angle, torque)
    there = network.rest(unknowns(real, room, network))
    top = max(float(there.force.max()), *(float(each.max()) for each in there.ring_force), 0.0)
    forces = room.forces[0, room.contacts(engine.PIN)].reshape(there.force.shape)
    assert forces == pytest.approx(there.force, rel=0, abs=NEAR * top)
    teeth = room.forces[0, room.contacts(engine.LOBE)]
    if ring:
        assert teeth == pytest.approx(there.ring_force.ravel(), rel=0, abs=NEAR * top)
    return there


@pytest.mark.parametrize("seed", seeds(3))
@pytest.mark.parametrize("tie", ["", "pinned", "clamped"])
@pytest.mark.parametrize("clearance", [0.0, 1.2e-5])
def test_a_bearing_and_an_elastic_mesh_together(seed: int, tie: str, clearance: float) -> None:
    support = Supports(CrankSupport(2e8, clearance), ElasticMesh(3e4))
    real, _, angle, torque = series.supported(seed, support, tie)
    compared(real, real, None, angle, torque)
    found = loaded_position(real=real, crank_angle=angle, output_torque=torque)
    assert sum(found.satellite_torque) == pytest.approx(torque, rel=EXACT)


@pytest.mark.parametrize("seed", seeds(4))
@pytest.mark.parametrize("tie", ["", "pinned", "clamped"])
@pytest.mark.parametrize("support", [SOFT, FLOATS, Supports(CrankSupport(), SatelliteSupport())])
def test_discs_between_both_meshes_on_bearings_that_give(
    seed: int, tie: str, support: SatelliteSupport
) -> None:
    output, ring, angle, torque = series.supported(seed, support, tie)
    both = MeshesInSeries(ring, output)
    there = compared(both, output, ring, angle, torque)
    found = series_position(real=both, crank_angle=angle, output_torque=torque)
    room = both.solved([both.wave(angle)], torque)
    pins = room.contacts(engine.PIN)
    levers = room.work.grad[pins, 0] @ room.forces[0, pins]
    assert levers == pytest.approx(torque, rel=EXACT)
    top = max(float(there.force.max()), float(there.ring_force.max()))
    if support.bearing:
        bearing = np.abs(there.journal)
        assert found.crank_force == pytest.approx(bearing.tolist(), rel=0, abs=1e-6 * top)


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
