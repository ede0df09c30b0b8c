"""The engine of a drive: compiled and interpreted, its equilibrium against energy by plain vectors,
and positions of a turn that hang on no others.
"""

import math
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from core.drive import compiled, engine
from core.drive.model import work_for
from core.numerics.extremes import about
from core.output.stage import Solved, Stage
from core.output.turn import Turn
from core.precision import EXACT, SAME
from core.ring.series_turn import SeriesTurn
from tests.inputs import ring_meshes, series
from tests.inputs.plain_engine import plain
from tests.oracles.seeds import seeds


def drawn(seed: int, **changes: Any) -> tuple[Stage, float, float]:
    return (series if seed % 2 else ring_meshes).drawn(seed, **changes)


def solved(of: ModuleType, real: Stage, places: list[float], torque: float) -> Solved:
    """Positions by an engine."""
    room = Solved.of(real.drive, len(places))
    given = np.array(places), torque, True, room.drive, room.work
    of.positions(*given, room.rows, room.lags, room.forces, room.wrench, room.plays)
    return room


@pytest.mark.parametrize("seed", seeds(8))
def test_as_it_is_the_engine_gives_what_it_gives_compiled(seed: int) -> None:
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
    grid = Turn(real, torque).values(engine.LAG, np.linspace(0, 2 * math.pi, 120, endpoint=False))
    tops = []
    for of, room in ((engine, one), (plain, other)):
        top = int(grid.heights.argmax())
        near = about(places=grid.places, heights=grid.heights, top=top, period=2 * math.pi)
        given = engine.LAG, 1, *near, -math.inf, math.nan, torque, 0.1
        tops.append(of.narrow(*given, room.drive, room.work, room.rows[0]))
    assert tops[0][1] == pytest.approx(tops[1][1], rel=EXACT)


@pytest.mark.parametrize("seed", seeds(8))
def test_a_position_does_not_hang_on_those_before_it(seed: int) -> None:
    """Each begins where the two before it lead, which may be at its own place."""
    real, angle, torque = drawn(seed)
    turn = (SeriesTurn if seed % 2 else Turn)(real, torque)
    places = [angle + 0.02 * k * k for k in (0, 1, 2, 2, 2, *range(3, 12))]
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


PINS, DISCS = 6, 2
TORQUE, ANGLE = 40.0, 0.3


def floating(seed: int) -> engine.Drive:
    """Two discs that float on cranks with clearance, held by springs, on pins that bend, whose ends
    a ring joins. Displacements: the output's lag; of each disc its lag, its shift along its crank
    and across it; three of the ring.
    """
    r = np.random.default_rng(seed)
    count = DISCS * (PINS + 1)
    gi, gf = np.full((2 * DISCS, 10), -1), np.zeros((2 * DISCS, 16))
    ci, cf = np.full((count, 3), -1), np.zeros((count, 13))
    for j in range(DISCS):
        holes, journal = slice(j * PINS, (j + 1) * PINS), DISCS * PINS + j
        own = 1 + 3 * j
        gi[j] = engine.PIN, engine.LINEAR, holes.start, holes.stop, 0, own, own + 1, own + 2, 1, -1
        gi[DISCS + j] = gi[j]
        gi[DISCS + j, [engine.START, engine.STOP]] = journal, journal + 1
        gi[DISCS + j, engine.KIND] = engine.JOURNAL
        gi[DISCS + j, [engine.TURN, engine.OWN]] = -1
        gf[[j, DISCS + j], engine.PHASE] = j * math.pi
        gf[j, [engine.RATE, engine.ECC, engine.CIRCLE]] = 1.1, 2e-3, 0.04
        beta = 2 * math.pi * np.arange(PINS) / PINS
        cf[holes, engine.CB], cf[holes, engine.SB] = np.cos(beta), np.sin(beta)
        cf[holes, engine.PX] = 0.04 + r.normal(0, 5e-6, PINS)
        cf[holes, engine.PY] = r.normal(0, 5e-6, PINS)
        cf[holes, engine.EX], cf[holes, engine.EY] = r.normal(0, 1e-5, (2, PINS))
        cf[holes, engine.GAP] = r.uniform(0, 2e-5, PINS)
        cf[holes, engine.A] = 1 / r.uniform(5e7, 1e8)
        ci[holes, engine.BLOCK], ci[holes, engine.PLANE] = range(PINS), j
        cf[journal, [engine.CB, engine.GAP, engine.A]] = 1.0, 5e-6, 1 / 3e8
    cf[:, engine.LIMIT] = math.inf
    bodies = 1 + 3 * DISCS + 3
    kgg = np.diag([0.0, *[2e5, 1e6, 1e6] * DISCS, 1e5, 3e8, 3e8])
    beam = np.array([[6e8, -2e8], [-2e8, 2e8]])
    ends = r.normal(0, 1e7, (PINS, 2 * DISCS, bodies))
    ends[:, :, :-3] = 0.0
    ends[:, :, -3] *= 0.04
    weight = np.ones(bodies)
    weight[[0, 1, 4, 7]] = 0.04**2
    return engine.Drive(
        gi=gi,
        gf=gf,
        ci=ci,
        cf=cf,
        table=np.zeros(8),
        kgg=kgg,
        kbb=np.kron(beam, np.eye(2)),
        kbg=ends,
        share=np.eye(bodies)[0],
        weight=weight,
    )


def energy(drive: engine.Drive, x: Any) -> float:
    """Energy of the drive by vectors of the carrier's plane as complex numbers, from the sizes of
    holes, pins and cranks: a pin stands off its hole's centre by more than both have room.
    """
    bodies = len(drive.share)
    q, b = x[:bodies], x[bodies:].reshape(PINS, 2 * DISCS)
    total = q @ drive.kgg @ q / 2 - TORQUE * q[0]
    total += sum(
        own @ drive.kbb @ own / 2 + own @ k @ q for own, k in zip(b, drive.kbg, strict=True)
    )
    for g, row in enumerate(drive.gi.tolist()):
        crank = np.exp(-1j * (drive.gf[g, engine.RATE] * ANGLE + drive.gf[g, engine.PHASE]))
        shift = q[row[engine.ALONG]] + 1j * q[row[engine.ACROSS]]
        disc = (drive.gf[g, engine.ECC] + shift) * crank
        for i in range(row[engine.START], row[engine.STOP]):
            place = drive.cf[i, engine.CB] + 1j * drive.cf[i, engine.SB]
            pin = hole = 0j
            if drive.ci[i, engine.BLOCK] >= 0:
                pin = complex(*drive.cf[i, [engine.PX, engine.PY]])
                hole = place * (pin - complex(*drive.cf[i, [engine.EX, engine.EY]]))
                pin = place * pin * np.exp(-1j * q[0])
                at = 2 * drive.ci[i, engine.PLANE]
                pin += place * complex(*b[drive.ci[i, engine.BLOCK], at : at + 2])
                hole *= np.exp(-1j * q[row[engine.OWN]])
            room = drive.gf[g, engine.ECC] + drive.cf[i, engine.GAP]
            approach = abs(pin - hole - disc) - room
            total += max(approach, 0.0) ** 2 / drive.cf[i, engine.A] / 2
    return float(total)


@pytest.mark.parametrize("seed", seeds(6))
def test_discs_that_float_on_joined_pins_rest_where_energy_is_least(seed: int) -> None:
    drive = floating(seed)
    work = work_for(drive)
    work.q[:] = np.random.default_rng(seed).normal(0, 1e-5, len(work.q))
    plain.place(ANGLE, drive, work)
    plain.straighten(work)
    assert plain.solve(TORQUE, engine.REACH, drive, work) > 0
    rest = np.concatenate([work.q, work.b.ravel()])
    length = np.sqrt([*drive.weight, *[1.0] * work.b.size])
    assert (work.w[:, engine.FORCE] > 0).sum() >= DISCS * 2
    top = work.w[:, engine.FORCE].max()
    for way in np.diag(1e-9 / length):
        slope = (energy(drive, rest + way) - energy(drive, rest - way)) / 2e-9
        assert abs(slope) < 1e-6 * top
    for _ in range(20):
        way = np.random.default_rng(_).normal(0, 1e-6, len(rest)) / length
        assert energy(drive, rest + way) > energy(drive, rest)
