"""Equilibrium of any stage: output pins, a ring, both in series, discs and pins that give."""

import math
from collections.abc import Callable
from dataclasses import fields, replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, reject
from hypothesis import strategies as st

from core.drive import engine
from core.errors import ImpossibleMechanism
from core.output.elasticity import (
    CrankSupport,
    ElasticMesh,
    LinearLaw,
    PalmgrenLaw,
    PinSupport,
    PowerLaw,
    Shares,
    Supports,
)
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.stage import Stage
from core.precision import EXACT, JUDGED
from core.ring.series import MeshesInSeries, series_position
from core.ring.sharing import CycloidMesh, mesh_position
from tests.inputs import ring_meshes, series
from tests.inputs.classes import force_error, lag_error
from tests.inputs.real_mechanisms import STEEL, crank_angles, design, held, reals, torques
from tests.oracles.seeds import seeds

Case = tuple[Stage, float, float]


def position(stage: Any, angle: float, torque: float) -> Any:
    """Position of a stage of any kind."""
    at = {"crank_angle": angle, "output_torque": torque}
    if isinstance(stage, MeshesInSeries):
        return series_position(real=stage, **at)
    return (
        mesh_position(mesh=stage, **at)
        if isinstance(stage, CycloidMesh)
        else loaded_position(real=stage, **at)
    )


def lag(found: Any) -> float:
    """Lag of the output, that of its first disc in a ring alone."""
    return found.rotation[0] if isinstance(found.rotation, tuple) else found.rotation


def disc_torques(found: Any) -> tuple[float, ...]:
    """Torque of each disc."""
    return found.disc_torque if hasattr(found, "disc_torque") else found.satellite_torque


def force_rows(found: Any) -> list[np.ndarray]:
    """Forces of the output pins and of those of the ring, N, each of shape (K, N)."""
    parts = [found, *([found.ring] if hasattr(found, "ring") else [])]
    return [np.array(part.force) for part in parts]


def size(stage: Any) -> float:
    """Radius at which forces turn the output, m."""
    own = stage.output if isinstance(stage, MeshesInSeries) else stage
    ring = isinstance(own, CycloidMesh)
    return own.disc.ring_pin_circle_radius if ring else own.pin_circle_radius


def ratio(stage: Any) -> float:
    """Turns of the crank for one of the output."""
    return stage.disc.satellite_teeth if isinstance(stage, CycloidMesh) else stage.mechanism.ratio


def soft(stage: Any) -> bool:
    """True if a law of the stage gives much under a little load."""
    parts = (stage.ring, stage.output) if isinstance(stage, MeshesInSeries) else (stage,)
    return any(isinstance(each.law, PowerLaw) and each.law.exponent > 2 for each in parts)


def holds_the_torque_and_does_not_pull(stage: Any, angle: float, torque: float) -> None:
    found = position(stage, angle, torque)
    forces = np.concatenate([rows.ravel() for rows in force_rows(found)])
    assert forces.min() >= 0 and found.stiffness > 0
    error = (1e-13 * forces.max() + force_error(found)) * size(stage)
    torques = disc_torques(found)
    if isinstance(stage, MeshesInSeries):  # whose discs are balanced about their own centres
        room = stage.solved([stage.wave(angle)], torque)
        pins = room.contacts(engine.PIN)
        torques = room.work.grad[pins, 0] * room.forces[0, pins]
    elif isinstance(stage.support, Shares):
        own = [share * torque for share in stage.support.shares]
        assert torques == pytest.approx(own, rel=0, abs=error)
    assert math.fsum(torques) == pytest.approx(torque, rel=0, abs=error)


def turns_further_under_more(stage: Any, angle: float, torque: float) -> None:
    """Under next to nothing the output is at the ends of its play."""
    del torque
    lags = [lag(position(stage, angle, each)) for each in (-100.0, -1.0, 1.0, 100.0)]
    assert lags == sorted(lags)
    ends = [position(stage, angle, each) for each in (-1e-5, 1e-5)]
    play = ends[1].play
    if play is not None:
        near = 1e-4 if soft(stage) else 1e-5
        assert [lag(each) for each in ends] == pytest.approx(play, rel=0, abs=near)


def has_the_slope_of_the_torque(stage: Any, angle: float, torque: float) -> None:
    step = 1e-4
    less, found, more = (position(stage, angle, torque * (1 + off)) for off in (-step, 0, step))
    slopes = [each.stiffness for each in (less, found, more)]
    if max(slopes) > 1.01 * min(slopes):
        return  # a pair takes up
    moved = lag(more) - lag(less)
    unsure = lag_error(size(stage), less, more) / abs(moved)
    assert found.stiffness == pytest.approx(2 * step * torque / moved, rel=1e-3 + unsure)


def mirrored(stage: Any) -> Any:
    """The stage in a mirror: angles and tangential errors change their sign, pins their order."""
    if isinstance(stage, MeshesInSeries):
        return MeshesInSeries(mirrored(stage.ring), mirrored(stage.output))
    own, changes = stage.deviations, {}
    for name in (each.name for each in fields(own)):
        sign = -1 if name.endswith(("tangential", "phase")) else 1

        def back(row: tuple[Any, ...], sign: int = sign, name: str = name) -> tuple[Any, ...]:
            if row and isinstance(row[0], tuple):
                return tuple(map(back, row))
            order = (
                range(len(row))
                if name.endswith(("phase", "eccentricity"))
                else (-k for k in range(len(row)))
            )
            return tuple(sign * row[k] for k in order)

        changes[name] = back(getattr(own, name))
    turned = {"deviations": replace(own, **changes)}
    if isinstance(stage, CycloidMesh):
        return replace(stage, crank_angles=tuple(-each for each in stage.crank_angles), **turned)
    mechanism = replace(
        stage.mechanism,
        crank_angles=tuple(-each for each in stage.mechanism.crank_angles),
        initial_crank_angle=-stage.mechanism.initial_crank_angle,
    )
    return replace(stage, mechanism=mechanism, **turned)


def is_turned_back_in_a_mirror(stage: Any, angle: float, torque: float) -> None:
    found, other = position(stage, angle, torque), position(mirrored(stage), -angle, -torque)
    near = lag_error(size(stage), found, other)
    assert lag(other) == pytest.approx(-lag(found), rel=EXACT, abs=near)
    error = 1e-14 * max(rows.max() for rows in force_rows(found))
    error += force_error(found) + force_error(other)
    for rows, others in zip(force_rows(found), force_rows(other), strict=True):
        assert np.roll(others[:, ::-1], 1, axis=1) == pytest.approx(rows, rel=0, abs=error)
    if found.play is not None:
        ends = [-each for each in reversed(found.play)]
        assert other.play == pytest.approx(ends, rel=EXACT, abs=1e-15)


RULES = (
    holds_the_torque_and_does_not_pull,
    turns_further_under_more,
    has_the_slope_of_the_torque,
    is_turned_back_in_a_mirror,
)

OUTPUTS = st.tuples(st.one_of(reals(), held()), crank_angles, torques)
"""Any mechanism with rigid discs, or with discs that give or have given shares."""


@example(  # pressed by two pairs, while a third is at its dead angle
    case=(
        design(
            mechanism=Mechanism(pins=4, crank_angles=(0.0,), ratio=2.0),
            law=LinearLaw(1e8),
            clearance=0.0,
            deviations=Deviations(hole_tangential=((0.0, 0.0, -9.2e-6, 1e-5),)),
            exact=False,
        ),
        0.0,
        1.0,
    )
)
@example(  # beside a dead angle by next to nothing: a contact of 1e-193 m, whose square is none
    case=(
        design(
            mechanism=Mechanism(3, (0.0,), 2.0),
            law=PowerLaw(0.5, 1000.0, 1e-5),
            clearance=0.0,
            pin=PinSupport("cantilever", 0.010, (0.025,), STEEL),
            support=ElasticMesh(1e4),
            exact=False,
        ),
        5e-191,
        -20.0,
    )
)
@pytest.mark.parametrize("rule", RULES)
@given(case=OUTPUTS)
def test_an_output(rule: Callable[..., None], case: Case) -> None:
    rule(*case)


def floating(seed: int) -> Case:
    """Both meshes with discs that float in their bearings."""
    output, ring, angle, torque = series.supported(seed, CrankSupport(2e8, 1.6e-5))
    return MeshesInSeries(ring, output), angle, torque


def tied(seed: int) -> Case:
    """Discs on bearings and in elastic meshes, whose pins a ring joins."""
    support = Supports(CrankSupport(2e8), ElasticMesh(3e4))
    output, _, angle, torque = series.supported(seed, support, ("pinned", "clamped")[seed % 2])
    return replace(output, law=series.LAWS[seed % 4]), angle, torque


def turned(seed: int) -> Case:
    """A ring of discs with turned flanks, in first order."""
    mesh, angle, torque = ring_meshes.drawn(seed, exact=False)
    cut = replace(mesh.disc.modification, rotation=1e-4)
    return replace(mesh, disc=replace(mesh.disc, modification=cut)), angle, torque


MADE: dict[str, Callable[[int], Case]] = {
    "ring": ring_meshes.drawn,
    "ring, first order": partial(ring_meshes.drawn, exact=False),
    "ring, turned flanks": turned,
    "series": series.drawn,
    "series, first order": partial(series.drawn, exact=False),
    "floating": floating,
    "tied": tied,
}


def linear(stage: Any) -> Any:
    """The stage with linear contacts, of which is known what they store."""
    if isinstance(stage, MeshesInSeries):
        return MeshesInSeries(linear(stage.ring), linear(stage.output))
    return replace(stage, law=LinearLaw(1e8))


def potential(stage: Any, angle: float, torque: float) -> tuple[float, float]:
    """Energy of contacts, springs and bent pins less the work of the load; torque on the crank."""
    room = stage.solved([stage.wave(angle)], torque, play=False)
    drive, q = room.drive, room.lags[0]
    stored = (room.forces[0] ** 2 * drive.cf[:, engine.A]).sum() + q @ drive.kgg @ q
    for own, k in zip(room.work.b, drive.kbg, strict=False):
        stored += own @ drive.kbb @ own + 2 * own @ k @ q
    return float(stored / 2 - abs(torque) * room.lag[0]), float(room.input_torque[0])


def gives_the_crank_what_it_takes(stage: Any, angle: float, torque: float) -> None:
    """The crank has its part of the load and what the stage stores as it turns, by differences."""
    stage, step = linear(stage), 1e-6
    before, after = (potential(stage, angle + off, torque)[0] for off in (-step, step))
    expected = torque / ratio(stage) + (after - before) / (2 * step)
    on_crank = potential(stage, angle, torque)[1]
    assert on_crank == pytest.approx(expected, rel=0, abs=1e-7 * abs(torque))


@pytest.mark.parametrize("seed", seeds(6))
@pytest.mark.parametrize("made", MADE.values(), ids=MADE)
@pytest.mark.parametrize("rule", [*RULES, gives_the_crank_what_it_takes])
def test_a_stage_that_is_drawn(
    rule: Callable[..., None], made: Callable[[int], Case], seed: int
) -> None:
    rule(*made(seed))


UNEVEN = design(deviations=Deviations(pin_tangential=(-1e-5, *[0.0] * 7)))
AHEAD = design(
    mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    deviations=Deviations(disc_phase=(0.0, 3e-4)),
    exact=False,
)
GIVES = (CrankSupport(5e7, 1e-5), ElasticMesh(2e4), Shares((0.6, 0.4)))


@pytest.mark.parametrize("torque", [30.0, -30.0])
@pytest.mark.parametrize(
    "stage",
    [UNEVEN, replace(UNEVEN, exact=False), *(replace(AHEAD, support=each) for each in GIVES),
     tied(2)[0], ring_meshes.drawn(5)[0], series.drawn(4)[0], series.drawn(4, exact=False)[0],
     floating(1)[0]],
)  # fmt: skip
def test_what_contacts_store_they_give_back(stage: Any, torque: float) -> None:
    """Over the turns after which all repeats the crank has its part of the load."""
    stage, part = linear(stage), torque / ratio(stage)
    per_wave = 2 * math.pi / stage.mechanism.waves_per_turn
    turns = 2 * math.pi * ratio(stage) if isinstance(stage, MeshesInSeries) else per_wave
    count = 720 if turns == per_wave else round(60 * ratio(stage))
    places = [stage.wave(turns * k / count) for k in range(count)]
    on_crank = stage.solved(places, torque, play=False).input_torque
    assert on_crank.mean() == pytest.approx(part, rel=JUDGED)
    assert np.ptp(on_crank) > 1e-4 * abs(part)


ERRORS = "radial", "tangential", "radius"
PINS = [f"{part}_{error}" for part in ("pin", "hole") for error in ERRORS]


def renumbered(stage: Any) -> tuple[Any, float]:
    """The stage whose second pin is the first, with its errors, and the crank angle to it."""
    own = stage.deviations

    def turned(row: tuple[Any, ...]) -> tuple[Any, ...]:
        return tuple(map(turned, row)) if row and isinstance(row[0], tuple) else row[1:] + row[:1]

    pins = {name: turned(getattr(own, name)) for name in PINS if hasattr(own, name)}
    pitch = 2 * math.pi / stage.mechanism.pins / stage.mechanism.waves_per_turn
    return replace(stage, deviations=replace(own, **pins)), pitch


def is_the_same_from_another_pin(stage: Any, angle: float, torque: float) -> None:
    other, pitch = renumbered(stage)
    found, again = position(stage, angle, torque), position(other, angle + pitch, torque)
    ((rows,), (others,)) = force_rows(found), force_rows(again)
    error = 1e-14 * rows.max() + force_error(found) + force_error(again)
    assert np.roll(others, 1, axis=1) == pytest.approx(rows, rel=0, abs=error)


@given(case=OUTPUTS)
def test_output_pins_renumbered(case: Case) -> None:
    try:
        position(*case)
    except ImpossibleMechanism:  # a dead centre within rounding
        reject()
    is_the_same_from_another_pin(*case)


@pytest.mark.parametrize("seed", seeds(8))
@pytest.mark.parametrize("made", ["ring", "ring, first order", "tied"])
def test_drawn_pins_renumbered(seed: int, made: str) -> None:
    is_the_same_from_another_pin(*MADE[made](seed))


def scaled(values: Any, scale: float) -> Any:
    """Lengths of errors times a number; angles of cranks as they are."""
    if isinstance(values, tuple):
        return tuple(scaled(each, scale) for each in values)
    return values * scale


def grows_with_its_gaps(stage: Any, angle: float, torque: float, scale: float) -> None:
    """In first order: gaps times s and torque times s^n give forces times s^n; a crank that is
    ahead turns the lines of action as well.
    """
    own = replace(stage.deviations, crank_phase=())
    stage = replace(stage, deviations=own)
    larger = replace(
        own, **{each.name: scaled(getattr(own, each.name), scale) for each in fields(own)}
    )
    change: dict[str, Any] = {"deviations": larger}
    if isinstance(stage, CycloidMesh):
        cut = stage.disc.modification
        cut = replace(cut, equidistant=scale * cut.equidistant, pin_circle=scale * cut.pin_circle)
        change["disc"] = replace(stage.disc, modification=cut)
    else:
        change["clearance"] = stage.clearance * scale
    exponent = {LinearLaw: 1.0, PalmgrenLaw: 10 / 9}.get(type(stage.law))
    grown = scale ** (exponent or stage.law.exponent)
    found, again = (
        position(stage, angle, torque),
        position(replace(stage, **change), angle, torque * grown),
    )
    ((rows,), (others,)) = force_rows(found), force_rows(again)
    error = 1e-14 * others.max() + grown * force_error(found) + force_error(again)
    assert others == pytest.approx(grown * rows, rel=0, abs=error)


@given(reals(exact=False, powers=True), crank_angles, st.floats(0.5, 2.0))
def test_scaled_gaps_of_an_output(real: RealMechanism, angle: float, scale: float) -> None:
    grows_with_its_gaps(real, angle, 20.0, scale)


@pytest.mark.parametrize("seed", [0, 1, 2, 4, 5, 8, 9])
def test_scaled_gaps_of_a_ring(seed: int) -> None:
    mesh, angle, torque = ring_meshes.drawn(seed, exact=False)
    grows_with_its_gaps(mesh, angle, torque, 3.0)
