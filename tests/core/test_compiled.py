"""The loops over pairs, compiled: the same bits as they give as they are, for any split."""

import math
from dataclasses import replace
from itertools import cycle, product
from typing import Any

import numpy as np
import pytest

from core.errors import ImpossibleMechanism, derived
from core.output import compiled
from core.output.elasticity import RIGID_SUPPORT, CrankSupport, ElasticMesh, PinSupport, Shares
from core.output.loop_rows import FORCE
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn, over_turn
from core.output.real_mechanism import RealMechanism
from core.output.turn import Turn
from core.ring.series_study import SeriesStudy
from core.tolerance.draws import Spread
from core.tolerance.study import QUANTITIES, Evaluation, Study
from core.tolerance.tolerances import Tolerances
from tests.inputs.real_mechanisms import LAWS, STEEL, design
from tests.inputs.series import drawn as both_meshes
from tests.oracles.seeds import TIMES


@pytest.fixture(autouse=True)
def found_as_before(monkeypatch):
    """Other tests find the loops that they had."""
    monkeypatch.setattr(compiled, "_at_hand", compiled._at_hand)


KINDS = range(8)
WIDE = Tolerances(
    pin_position=1e-5,
    hole_position=2e-5,
    pin_radius=Spread(-8e-6, 8e-6),
    hole_radius=Spread(0.0, 9e-6),
    eccentricity=Spread(-5e-6, 5e-6),
    crank_phase=Spread(-3e-4, 3e-4),
    disc_phase=Spread(-3e-4, 3e-4),
)
PIN = PinSupport("fixed", 0.006, (0.01, 0.03), STEEL, 0.04)
"""How a pin is held is nothing but a number to the loops."""


def pair_of_discs(**changes: object) -> RealMechanism:
    return design(
        mechanism=Mechanism.evenly_spaced(pins=5, satellites=2, ratio=18.0),
        pin_material=STEEL,
        hole_material=STEEL,
        **changes,
    )


def both(calculate):
    """What comes out as it is, and compiled."""
    compiled._at_hand = compiled.plain
    plain = calculate()
    compiled.load()
    return plain, calculate()


def looked_at(real: RealMechanism, torque: float) -> list[float]:
    """All that the loops give of a mechanism over the turn."""
    turn = Turn(real, torque, 0.05)
    places = [0.1 + 0.7 * k for k in range(9)]
    rows = [
        *map(np.ravel, turn.poses(places).values()),
        *[turn.values(kind, places).heights for kind in KINDS],
    ]
    narrowed = [turn.narrow(kind, sign)(0.3, 0.34) for kind, sign in product(KINDS, (1, -1))]
    return [*np.concatenate(rows).tolist(), *[x for each in narrowed for x in each]]


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{type(law).__name__}")
def test_both_give_the_same_bits(law, exact):
    same_bits(pair_of_discs(law=law, pin=PIN, exact=exact))


SUPPORTS = CrankSupport(1e8, 1e-5), ElasticMesh(1e4), Shares((0.6, 0.4))
GIVING = [*product(LAWS, SUPPORTS)] if TIMES > 1 else [*zip(LAWS, cycle(SUPPORTS), strict=False)]


@pytest.mark.parametrize(("law", "support"), GIVING, ids=lambda each: f"{type(each).__name__}")
def test_both_give_the_same_bits_of_satellites_that_give(law, support):
    same_bits(pair_of_discs(law=law, support=support, exact=False))


def same_bits(real: RealMechanism) -> None:
    for torque, clearance in ((30.0, 2e-5), (-30.0, 2e-5), (0.1, -5e-6)):
        study = Study(
            replace(real, clearance=clearance),
            WIDE,
            Evaluation(QUANTITIES, torque, positions=9),
            samples=4,
        )
        pieces = study.pieces()
        plain, fast = both(lambda study=study, pieces=pieces: study.values(pieces))
        assert (plain[0].tobytes(), plain[1].tolist()) == (fast[0].tobytes(), fast[1].tolist())
        piece = study.piece(pieces, 0)
        plain, fast = both(lambda piece=piece, torque=torque: looked_at(piece, torque))
        assert plain == fast


@pytest.mark.parametrize("exact", [True, False])
def test_both_give_the_same_bits_of_pieces_in_series(exact: bool) -> None:
    real, _, torque = both_meshes(6, exact=exact)
    wide = replace(
        WIDE,
        ring_pin_position=1e-5,
        ring_pin_radius=Spread(-3e-6, 3e-6),
        equidistant=Spread(1e-5, 2e-5),
        modification_pin_circle=Spread(-3e-6, 3e-6),
    )
    names = (*QUANTITIES, "ring_peak_force", "ring_max_pressure")
    asked = Evaluation(names, torque, positions=4)
    study = SeriesStudy(real, wide, asked, samples=4)
    plain, fast = both(lambda: study.values(study.pieces()))
    assert (plain[0].tobytes(), plain[1].tolist()) == (fast[0].tobytes(), fast[1].tolist())
    assert 2 in plain[1]


READ = [name for name, value in vars(OverTurn).items() if isinstance(value, property | derived)]


def test_both_give_the_same_turn() -> None:
    def looked_for() -> list[Any]:
        turn = over_turn(real=pair_of_discs(law=LAWS[2]), output_torque=-30.0)
        return [getattr(turn, name) for name in READ]

    plain, fast = both(looked_for)
    assert plain == fast and len(plain) > 20


def test_pieces_that_cannot_work_are_none_in_both() -> None:
    wide = replace(WIDE, eccentricity=Spread(-2e-3, 2e-3))
    study = Study(pair_of_discs(), wide, Evaluation(("peak_force",), 30.0, 6), samples=40)
    pieces = study.pieces()
    plain, fast = both(lambda: study.values(pieces)[0])
    assert plain.tobytes() == fast.tobytes()
    assert 0 < np.isnan(plain).sum() < 40


def test_any_split_gives_the_same_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    study = Study(pair_of_discs(), WIDE, Evaluation(QUANTITIES, 30.0, 6), samples=50)
    values = []
    for block, threads in ((64, 1), (64, 2), (7, 1), (7, 3), (1, 2)):
        monkeypatch.setattr("core.tolerance.study.BLOCK", block)
        values.append(replace(study, threads=threads).values(study.pieces())[0].tobytes())
    assert len({*values}) == 1
    fewer = replace(study, samples=9)
    assert fewer.values(fewer.pieces())[0].tobytes() == values[0][: 9 * 8 * len(QUANTITIES)]


@pytest.mark.parametrize("loaded", [False, True])
def test_a_refusal_says_why_in_both(loaded: bool) -> None:
    if not loaded:
        compiled._at_hand = compiled.plain
    soft = replace(pair_of_discs(), law=replace(LAWS[0], stiffness=1e3))
    for calculate in (
        lambda: over_turn(real=soft, output_torque=30.0),
        lambda: Turn(soft, 30.0).narrow(0)(0.0, math.pi),
    ):
        with pytest.raises(ImpossibleMechanism) as caught:
            calculate()
        assert caught.value.code == "not_stable"


def test_a_study_of_satellites_that_give_is_that_of_its_pieces() -> None:
    support = CrankSupport(stiffness=1e8, radial_clearance=1e-5)
    real = pair_of_discs(exact=False, support=support)
    study = Study(real, WIDE, Evaluation(("peak_force",), 30.0, 6), samples=3)
    pieces = study.pieces()
    places = [2 * math.pi * k / 6 for k in range(6)]
    peaks = [
        Turn(study.piece(pieces, i), 30.0).values(FORCE, places).heights.max() for i in range(3)
    ]
    assert study.values(pieces)[0][:, 0].tolist() == peaks
    rigid = replace(study, real=replace(real, support=RIGID_SUPPORT))
    assert rigid.values(pieces)[0][:, 0].tolist() != peaks
