"""Pairs that carry under real forces: ends of ranges against positions solved one by one."""

import math

import numpy as np
import pytest

from core.output.elasticity import ContactLaw, LinearLaw, PowerLaw
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.real_cyclogram import RealCyclogram, carried_forces, real_cyclogram
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.turn import Turn
from core.precision import EXACT
from tests.inputs.real_mechanisms import STEEL

TORQUE = 120.0


LINEAR = LinearLaw(stiffness=5e7)


def made(
    *, clearance: float = 2e-5, law: ContactLaw = LINEAR, **deviations: tuple[float, ...]
) -> RealMechanism:
    return RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=12.0, crank_spacing=math.pi),
        pin_circle_radius=0.04,
        pin_radius=0.005,
        eccentricity=0.0015,
        contact_length=0.012,
        clearance=clearance,
        law=law,
        deviations=Deviations(**deviations),
        pin_material=STEEL,
        hole_material=STEEL,
    )


SOFT = made(law=PowerLaw(exponent=3.0, reference_force=1000.0, reference_approach=1e-5))
DEVIATED = made(pin_tangential=(0.0, 1e-5, 0.0, -8e-6, 0.0, 3e-6))


def forces(real: RealMechanism, angle: float, torque: float) -> list[float]:
    found = loaded_position(real=real, crank_angle=angle, output_torque=torque)
    return [force for row in found.force for force in row]


@pytest.mark.parametrize("torque", [TORQUE, -TORQUE])
@pytest.mark.parametrize("real", [made(), DEVIATED, SOFT], ids=["clearance", "deviations", "soft"])
def test_a_pair_carries_within_its_ends_and_nothing_beside_them(
    real: RealMechanism, torque: float
) -> None:
    found = real_cyclogram(turn=Turn(real, torque), revolutions=1.5)
    end, beside = found.loaded_count[-1].end, 3e-7
    assert end == pytest.approx(3 * math.pi)
    seen = 0
    for index, pair in enumerate(found.pairs):
        for start, stop in pair.driving:
            assert forces(real, (start + stop) / 2, torque)[index] > 0
            for place, inward in ((start, 1), (stop, -1)):
                if 0 < place < end:
                    seen += 1
                    assert forces(real, place + inward * beside, torque)[index] > 0
                    assert forces(real, place - inward * beside, torque)[index] == 0
    assert seen > 12


@pytest.mark.parametrize("real", [made(), DEVIATED], ids=["clearance", "deviations"])
def test_as_many_carry_as_over_the_turn_and_at_each_place(real: RealMechanism) -> None:
    turn = Turn(real, TORQUE)
    found, over = real_cyclogram(turn=turn, revolutions=2.0), OverTurn(turn)
    assert (found.min_loaded, found.max_loaded) == (over.loaded_pairs_min, over.loaded_pairs_max)
    ends = [0.0, *(each.end for each in found.loaded_count)]
    assert [each.start for each in found.loaded_count] == ends[:-1]
    for each in found.loaded_count:
        carrying = sum(force > 0 for force in forces(real, (each.start + each.end) / 2, TORQUE))
        assert carrying == each.pairs


def test_a_handover_shorter_than_the_grid_is_counted() -> None:
    turn = Turn(made(), 1e-3)
    found, over = real_cyclogram(turn=turn), OverTurn(turn)
    seen = set(turn.fine["loaded"].astype(int).tolist())
    assert (found.min_loaded, found.max_loaded) == (over.loaded_pairs_min, over.loaded_pairs_max)
    assert {over.loaded_pairs_min, over.loaded_pairs_max} - seen


def test_all_pairs_carry_always_where_they_are_pressed() -> None:
    found = real_cyclogram(turn=Turn(made(clearance=-2e-4), 1.0))
    assert all(pair.driving == ((0.0, 2 * math.pi),) for pair in found.pairs)
    assert [(each.start, each.end) for each in found.loaded_count] == [(0.0, 2 * math.pi)]


def test_the_drawn_forces_are_those_of_the_positions_and_zero_beside_the_ends() -> None:
    turn = Turn(DEVIATED, TORQUE)
    carried: RealCyclogram = real_cyclogram(turn=turn)
    angles, drawn = carried_forces(turn=turn, carried=carried, places=[1.0], samples=31)
    assert (np.diff(angles) > 0).all() and angles[0] == 0 and 1.0 in angles
    for index in range(0, len(angles), 7):
        assert drawn[:, index] == pytest.approx(
            forces(DEVIATED, angles[index], TORQUE), rel=EXACT, abs=1e-9
        )
    for index, pair in enumerate(carried.pairs):
        within = [start <= angle <= stop for angle in angles for start, stop in pair.driving[:1]]
        assert (drawn[index] > 0).sum() >= sum(within) - 2
