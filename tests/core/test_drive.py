"""The engine of a drive: as it is and compiled, and what a turn's positions owe to each other."""

import importlib.util
import math
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from core.drive import compiled, engine
from core.precision import EXACT, SAME
from core.ring.drive_turn import DriveStage, DriveTurn, Solved
from core.ring.series_turn import SeriesTurn
from tests.inputs import ring_meshes, series
from tests.oracles.seeds import seeds


@pytest.fixture
def plain() -> ModuleType:
    """The engine as its source is."""
    spec = importlib.util.spec_from_file_location("plain_engine", engine.__file__)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def drawn(seed: int, **changes: Any) -> tuple[DriveStage, float, float]:
    return (series if seed % 2 else ring_meshes).drawn(seed, **changes)


def solved(of: ModuleType, real: DriveStage, places: list[float], torque: float) -> Solved:
    """Positions by an engine."""
    room = Solved.of(real.drive, len(places))
    given = np.array(places), torque, True, room.drive, room.work
    of.positions(*given, room.rows, room.lags, room.forces, room.wrench, room.play)
    return room


@pytest.mark.parametrize("seed", seeds(8))
def test_as_it_is_the_engine_gives_what_it_gives_compiled(plain: ModuleType, seed: int) -> None:
    assert engine.positions is not compiled.PLAIN["positions"]
    real, angle, torque = drawn(seed, exact=seed % 4 < 2)
    places = [angle + 0.01 * k for k in range(3)]
    one, other = (solved(of, real, places, torque) for of in (engine, plain))
    top = one.forces.max()
    assert other.forces == pytest.approx(one.forces, rel=0, abs=EXACT * top)
    assert other.lags == pytest.approx(one.lags, rel=EXACT)
    names = engine.STIFFNESS, engine.LOW, engine.HIGH, engine.INPUT_TORQUE, engine.RUB
    for name in names:
        assert other.rows[:, name] == pytest.approx(one.rows[:, name], rel=EXACT)
    given = engine.LAG, 1, places[0], places[0] + 1e-3, torque, 0.1
    tops = [
        of.narrow(*given, room.drive, room.work, room.rows[0])
        for of, room in ((engine, one), (plain, other))
    ]
    assert tops[0][1] == pytest.approx(tops[1][1], rel=EXACT)


@pytest.mark.parametrize("seed", seeds(8))
def test_a_position_does_not_hang_on_those_before_it(seed: int) -> None:
    """Each begins where the two before it lead."""
    real, angle, torque = drawn(seed)
    turn = (SeriesTurn if seed % 2 else DriveTurn)(real, torque)
    places = [angle + 0.02 * k * k for k in range(12)]
    rows = turn.poses(places)
    for k, angle in enumerate(places):
        alone = turn.poses([angle])
        for name in ("forces", "lag", "stiffness", "low", "high", "input_torque"):
            near = SAME * np.abs(rows[name]).max()
            assert alone[name][0] == pytest.approx(rows[name][k], rel=0, abs=4 * near), name


@pytest.mark.parametrize("seed", seeds(6))
def test_what_presses_a_disc_turns_its_crank(seed: int) -> None:
    """By statics in exact geometry; the mean over a turn carries the load."""
    real, _, torque = ring_meshes.drawn(seed, law=ring_meshes.LAWS[0])
    count, ratio = 2400, real.disc.satellite_teeth
    places = np.arange(count) * 2 * math.pi / count
    room = Solved.of(real.drive, count)
    assert room.at(places, torque, play=False) < 0
    across = room.by_ring[:, :, 1] @ room.drive.gf[: len(real.crank_angles), engine.ECC]
    assert across == pytest.approx(room.rows[:, engine.INPUT_TORQUE], rel=EXACT)
    assert across.mean() == pytest.approx(torque / ratio, rel=1e-4)
