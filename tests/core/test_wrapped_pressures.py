"""Largest pressures of mechanisms whose contacts wrap: over the turn, at positions, of pieces."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.errors import ImpossibleMechanism, NotKnown
from core.hertz import ElasticMaterial, HertzContact, hertz
from core.output.alternating import WorseTurn
from core.output.conformal_law import PRESSURE_ERROR, conformal_wrap, excess
from core.output.elasticity import ConformalLaw, HertzLaw, LinearLaw
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import CONVERGED, SAME
from core.tolerance.study import Evaluation, Study
from core.tolerance.tolerances import Tolerances

STEEL, PLA = ElasticMaterial(207e9, 0.3), ElasticMaterial(3.5e9, 0.36)

TIGHT = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=5, satellites=2, ratio=15.0),
    pin_circle_radius=0.025,
    pin_radius=0.004,
    eccentricity=8e-5,
    contact_length=0.008,
    law=ConformalLaw(),
    clearance=2e-5,
    pin_material=STEEL,
    hole_material=PLA,
)
UNLIKE = replace(
    TIGHT,
    deviations=Deviations(
        pin_radius=(8e-6, -8e-6, 0.0, 1.2e-5, -1.5e-5),
        pin_tangential=(4e-6, 0.0, 6e-6, -9e-6, 0.0),
    ),
)
THIN = replace(
    TIGHT,
    deviations=Deviations(
        pin_radius=(7e-6, -1e-6, 2e-6, 7e-6, -1.6e-5),
        pin_tangential=(4e-6, 1.2e-5, 1.1e-5, 2e-6, -1e-5),
    ),
)
"""The last pin is the thinnest; by a linear law it is pressed hardest, and does not carry most."""

TORQUE = 40.0


def governing(real: RealMechanism, pair: int, force: float) -> float:
    """The pressure that is judged, of one pair, by its own sizes."""
    own = real.deviations.pin_radius or (0.0,) * real.mechanism.pins
    larger = own[pair % real.mechanism.pins]
    found = hertz(
        force=force,
        contact_length=real.contact_length,
        pin_radius=real.pin_radius + larger,
        hole_radius=real.pin_radius + real.eccentricity + real.clearance,
        pin_material=real.pin_material,
        hole_material=real.hole_material,
    )
    return float(found.governing_pressure)


def highest(real: RealMechanism, count: int) -> float:
    """Over so many positions of the turn, all pairs one by one."""
    turn = 2 * math.pi / (1 + 1 / real.mechanism.ratio)
    most = 0.0
    for angle in np.arange(count) / count * turn:
        found = loaded_position(real=real, crank_angle=float(angle), output_torque=TORQUE)
        forces = [force for row in found.force for force in row]
        here = [governing(real, pair, force) for pair, force in enumerate(forces)]
        assert found.max_pressure == pytest.approx(max(here), rel=SAME)
        most = max(most, *here)
    return most


def test_at_the_peak_the_pressure_is_the_one_that_is_judged() -> None:
    turn = over_turn(real=TIGHT, output_torque=TORQUE)
    judged = governing(TIGHT, 0, turn.peak_force)
    contact = TIGHT.contact(0, turn.peak_force)
    assert contact is not None
    assert turn.max_pressure == pytest.approx(judged, rel=CONVERGED)
    assert judged > 1.03 * contact.max_pressure
    assert contact.conformal_pressure == pytest.approx(judged, rel=CONVERGED)


@pytest.mark.parametrize(
    ("made", "law"),
    [(UNLIKE, ConformalLaw()), (UNLIKE, LinearLaw(3e6)), (THIN, LinearLaw(3e6))],
    ids=["conformal", "linear", "thin"],
)
def test_of_unlike_pairs_the_hardest_pressed_is_found(
    made: RealMechanism, law: ConformalLaw | LinearLaw
) -> None:
    """The one with the largest force among narrower radii need not be it."""
    real = replace(made, law=law)
    turn = over_turn(real=real, output_torque=TORQUE)
    sampled = highest(real, 180)
    assert turn.max_pressure is not None
    assert sampled <= turn.max_pressure * (1 + 1e-9)
    assert turn.max_pressure == pytest.approx(sampled, rel=5e-3)
    pair, force = turn.hardest
    assert governing(real, pair, force) == pytest.approx(turn.max_pressure, rel=SAME)
    largest = max(range(10), key=lambda each: turn.pair_force[each // 5][each % 5])
    assert made is UNLIKE or (pair % 5, largest % 5) == (4, 3)


def test_pieces_of_a_study_have_the_pressures_of_their_positions() -> None:
    asked = Evaluation(("max_pressure", "peak_force"), TORQUE, positions=24)
    study = Study(TIGHT, Tolerances(pin_position=8e-6), asked, samples=4)
    pieces = study.pieces()
    values, _ = study.values(pieces)
    for index, (pressure, force) in enumerate(values):
        piece = study.piece(pieces, index)
        turn = 2 * math.pi / (1 + 1 / piece.mechanism.ratio)
        expected = 0.0
        for angle in np.arange(24) / 24 * turn:
            there = loaded_position(real=piece, crank_angle=float(angle), output_torque=TORQUE)
            assert there.max_pressure is not None
            expected = max(expected, there.max_pressure)
        assert pressure == pytest.approx(expected, rel=PRESSURE_ERROR)
        contact = piece.contact(0, force)
        assert contact is not None and pressure > 1.02 * contact.max_pressure


def contact_under(load: float, pin: ElasticMaterial, hole: ElasticMaterial) -> HertzContact:
    """A contact under a load Q/(E* dR)."""
    modulus = conformal_wrap(contact_length=1.0, pin=pin, hole=hole).modulus
    return hertz(
        force=load * modulus * 1e-4,
        contact_length=1.0,
        pin_radius=5e-3,
        hole_radius=5.1e-3,
        pin_material=pin,
        hole_material=hole,
    )


@pytest.mark.parametrize(("pin", "hole"), [(STEEL, PLA), (PLA, STEEL), (STEEL, STEEL), (PLA, PLA)])
def test_the_law_lets_the_same_pressure_govern(pin: ElasticMaterial, hole: ElasticMaterial) -> None:
    """From the same load on, by the same factor."""
    wrap = conformal_wrap(contact_length=1.0, pin=pin, hole=hole)
    assert contact_under(wrap.since * (1 - 1e-5), pin, hole).conformal_pressure is None
    for load in (wrap.since * (1 + 1e-5), 3 * wrap.since, 1.0):
        found = contact_under(load, pin, hole)
        assert found.conformal_pressure is not None
        factor = float(found.conformal_pressure / found.max_pressure)
        assert math.sqrt(excess(load=load, wrap=wrap)) == pytest.approx(factor, rel=PRESSURE_ERROR)


def test_what_wraps_further_than_is_known_has_no_pressure() -> None:
    """By a law without an end: neither at a position nor over the turn, with the reason."""
    real = replace(TIGHT, law=LinearLaw(1e10), pin_material=PLA, hole_material=STEEL)
    real = replace(real, pin_circle_radius=0.5)
    found = loaded_position(real=real, crank_angle=0.0, output_torque=6e5)
    turn = over_turn(real=real, output_torque=6e5)
    both = WorseTurn(turn, over_turn(real=real, output_torque=-6e5))
    little = over_turn(real=real, output_torque=-600.0)
    assert little.max_pressure > 0
    for each in (found, turn, both, WorseTurn(turn, little), WorseTurn(little, turn)):
        with pytest.raises(NotKnown, match="contact_wraps"):
            _ = each.max_pressure
        assert "contact_wraps" in {notice.code for notice in each.notices}
    assert real.pressures(found.force) is None


def test_narrow_contacts_keep_hertz_to_the_last_digit() -> None:
    real = replace(TIGHT, eccentricity=2e-3, hole_material=STEEL, law=HertzLaw())
    for each in (real, replace(real, deviations=UNLIKE.deviations)):
        found = loaded_position(real=each, crank_angle=0.3, output_torque=TORQUE)
        contacts = [
            each.contact(pair, force)
            for pair, force in enumerate(force for row in found.force for force in row)
        ]
        pressures = [contact.max_pressure for contact in contacts if contact is not None]
        assert found.max_pressure == max(pressures)
        assert each.pressures(found.force) == each.rows(pressures)


def test_a_mechanism_that_cannot_be_is_refused_as_before() -> None:
    real = replace(TIGHT, law=HertzLaw())
    with pytest.raises(ImpossibleMechanism, match="as wide"):
        over_turn(real=real, output_torque=1e4)
