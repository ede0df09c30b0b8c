"""Reactions and balance of the crankshaft: reference numbers, balance, limits and refusals."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.crank.balance import Balance, balance
from core.crank.crankshaft import reaction_curves
from core.crank.ring_mesh import RingMesh, involute_mesh
from core.crank.satellite_bearing import bearing_curves
from core.errors import ImpossibleMechanism, InvalidInput
from core.output.mechanism import Mechanism
from core.precision import CONVERGED, SAME, SEARCHED
from tests.inputs.loads import crankshaft, satellite_bearings
from tests.inputs.satellites import mechanisms
from tests.oracles.satellites import forces

LOAD = {"output_torque": 500.0, "pin_circle_radius": 0.05, "eccentricity": 2e-3}
MESH = involute_mesh(
    module=3.5e-3, teeth_difference=1, pressure_angle=math.radians(20), eccentricity=2e-3
)
PLACES = {"satellite_positions": (0.02, 0.042), "bearing_positions": (0.0, 0.062)}


def spaced(pins: int, satellites: int) -> Mechanism:
    return Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)


REF = LOAD | PLACES | {"mesh": MESH, "mechanism": spaced(6, 2)}


def test_the_reference_design() -> None:
    found = crankshaft(**REF)
    assert [f"{each:.3f}" for each in found.peak_reaction] == ["4487.098"] * 2
    assert found.accuracy.relative_error < 2e-6 and found.balance is None


def test_loads_stand_still_in_the_crank() -> None:
    """Rotating bending would go from plus to minus the largest; here it keeps its direction."""
    pins, shares = forces(spaced(6, 2), 1.0, np.linspace(0, 2 * np.pi, 5000))
    across, along = 12_500 * shares, MESH.radial_force_ratio * 12_500 * shares + 10_000 * pins
    assert along.min() > 0.9 * along.max() > 0
    assert across.min() > 0


def test_curves_are_the_reactions() -> None:
    design = LOAD | PLACES | {"mechanism": spaced(3, 2)}
    angles = np.linspace(0, 2 * math.pi, 20_001)
    loaded = LOAD | {"mechanism": design["mechanism"]}
    loads = bearing_curves(**loaded, radial_force_ratio=-0.3, crank_angle=angles)
    cranks = design["mechanism"].crank_angles
    curves = reaction_curves(loads=loads, crank_angles=cranks, **PLACES)
    found = crankshaft(**design, mesh=RingMesh(-0.3))
    sizes = np.abs(curves.reaction)
    assert sizes.max(axis=0) == pytest.approx(found.peak_reaction, rel=SEARCHED)


def test_life() -> None:
    found = crankshaft(**REF, dynamic_ratings=(30e3, None), bearing_speeds=(50 * math.pi, 0.0))
    millions = (30e3 / found.equivalent_reaction[0]) ** 3
    assert found.basic_life[0] / 3600 == pytest.approx(millions * 1e6 / (60 * 1500), rel=CONVERGED)
    assert 1 not in found.basic_life


def test_far_places_cost_digits_and_the_error_says_so() -> None:
    """Shaft moved by 100 km along its axis, where doubles are some 1e-11 m apart."""
    near = crankshaft(**REF)
    far = {name: tuple(1e5 + each for each in places) for name, places in PLACES.items()}
    found = crankshaft(**REF | far)
    off = np.abs(found.peak_reaction / near.peak_reaction - 1).max()
    more = found.accuracy.relative_error - near.accuracy.relative_error
    assert 0 < off < more < 1e3 * off


def test_a_satellite_beside_a_far_bearing() -> None:
    """A tenth of a millimetre of 62 from A: what B holds is known as well as that distance is."""
    one = LOAD | {"mesh": MESH, "mechanism": spaced(6, 1)}
    near = crankshaft(**one, satellite_positions=(1e-4,), bearing_positions=(0.0, 0.062))
    for start in (1e5, -1e5):
        found = crankshaft(
            **one,
            satellite_positions=(start + 1e-4,),
            bearing_positions=(start, start + 0.062),
        )
        off = abs(found.peak_reaction[1] / near.peak_reaction[1] - 1)
        assert 1e-9 < off < found.accuracy.relative_error < 1e3 * off


@pytest.mark.parametrize("rho", [0.7, -0.3])
def test_the_error_of_the_ring_is_in_that_of_the_reactions(rho: float) -> None:
    own = REF | {"mesh": RingMesh(rho, error=1e-6)}
    moved = crankshaft(**REF | {"mesh": RingMesh(rho + 1e-6)}).peak_reaction
    found = crankshaft(**own)
    off = np.abs(moved / found.peak_reaction - 1).max()
    assert off <= found.accuracy.relative_error < 20 * off
    lasting = crankshaft(**own, dynamic_ratings=(30e3, 30e3), bearing_speeds=(100.0, 100.0))
    error = lasting.accuracy.relative_error
    assert error == pytest.approx(3 * found.accuracy.relative_error, rel=SEARCHED)


def test_curves_have_the_direction_of_the_reactions() -> None:
    """Along the first crank's zero and ahead of it, from the law of the forces itself."""
    mechanism = Mechanism(pins=5, crank_angles=(0.4, 1.9), ratio=20.0, initial_crank_angle=0.2)
    angles = np.array([0.1, 1.0, 2.7])
    loads = bearing_curves(**LOAD, mechanism=mechanism, radial_force_ratio=0.7, crank_angle=angles)
    curves = reaction_curves(loads=loads, crank_angles=mechanism.crank_angles, **PLACES)
    pins, shares = forces(mechanism, 1.0, angles * 21 / 20)
    inwards, back = 12_500 * 0.7 * shares + 10_000 * pins, 12_500 * shares
    for bearing, held in enumerate(((42 / 62, 20 / 62), (20 / 62, 42 / 62))):
        x = y = 0.0
        for alpha, part, inward, tangential in zip((0.4, 1.9), held, inwards, back, strict=True):
            x = x + part * (inward * math.cos(alpha) - tangential * math.sin(alpha))
            y = y + part * (inward * math.sin(alpha) + tangential * math.cos(alpha))
        assert curves.reaction[:, bearing].real == pytest.approx(x, rel=SAME)
        assert curves.reaction[:, bearing].imag == pytest.approx(y, rel=SAME)


def balanced(design: dict[str, Any], speed: float = 50 * math.pi, mass: float = 1.5) -> Balance:
    """Balance of the satellites of a shaft."""
    given = ("eccentricity", "satellite_positions", "bearing_positions")
    return balance(
        **{name: design[name] for name in given},
        satellite_mass=mass,
        crank_angles=design["mechanism"].crank_angles,
        input_speed=speed,
    )


def test_the_couple_of_two_and_of_three_satellites() -> None:
    """REF of the theory: 1.628485 N*m of two satellites, the root of three times it of three."""
    two = balanced(REF)
    assert two.force == pytest.approx(0, abs=1e-12)
    assert f"{two.couple:.6f}" == "1.628485"
    three = REF | {"mechanism": spaced(6, 3), "satellite_positions": (0.009, 0.031, 0.053)}
    found = balanced(three)
    assert found.couple == pytest.approx(1.628485 * math.sqrt(3), rel=SEARCHED)
    assert found.force == pytest.approx(0, abs=1e-12)


def test_a_bearing_that_holds_nothing() -> None:
    """The satellite on one bearing leaves nothing for the other: no load, no life, no failure."""
    one = LOAD | {"mesh": MESH, "mechanism": spaced(6, 1), "dynamic_ratings": (30e3, 30e3)}
    for place, held in ((0.0, 0), (0.062, 1)):
        shaft = one | {"satellite_positions": (place,), "bearing_positions": (0.0, 0.062)}
        found = crankshaft(**shaft, balance=balanced(shaft), bearing_speeds=(157.0, 157.0))
        alone = satellite_bearings(
            **LOAD,
            mesh=MESH,
            mechanism=spaced(6, 1),
            centrifugal=1.5 * 2e-3 * (50 * math.pi) ** 2,
            kind="ball",
        )
        loaded, other = found.peak_reaction[held], found.peak_reaction[1 - held]
        assert (loaded, other) == (pytest.approx(alone.peak_load[0], rel=CONVERGED), 0)
        assert found.equivalent_reaction[1 - held] == 0
        assert (found.basic_life[held] > 0, 1 - held in found.basic_life) == (True, False)
        assert found.accuracy.relative_error < 4e-6
        corrections = found.balance.corrections
        assert (corrections[1 - held].unbalance, corrections[1 - held].angle) == (0, 0)


@pytest.mark.parametrize(
    ("degrees", "places"),
    [((0, 180), (0.02, 0.02)), ((0, 180, 180, 0), (0.01, 0.02, 0.03, 0.04))],
)
def test_forces_that_cancel_leave_nothing(
    degrees: tuple[float, ...], places: tuple[float, ...]
) -> None:
    angles = tuple(math.radians(each) for each in degrees)
    mechanism = Mechanism(pins=6, crank_angles=angles, ratio=20.0)
    shaft = LOAD | {
        "mesh": MESH,
        "mechanism": mechanism,
        "satellite_positions": places,
        "bearing_positions": (-0.013, 0.062),
        "dynamic_ratings": (30e3, 30e3),
        "bearing_speeds": (157.0, 157.0),
    }
    found = crankshaft(**shaft, balance=balanced(shaft))
    assert found.peak_reaction.tolist() == found.equivalent_reaction.tolist() == [0, 0]
    assert found.basic_life == {}
    assert (found.balance.force, found.balance.couple) == (0, 0)
    assert all((each.unbalance, each.angle) == (0, 0) for each in found.balance.corrections)
    assert found.notices == () and 0 < found.accuracy.relative_error < 1e-14


@given(mechanism=mechanisms, speed=st.floats(1, 1e3))
def test_corrections_balance(mechanism: Mechanism, speed: float) -> None:
    places = tuple(0.01 + 0.022 * j for j in range(mechanism.satellites))
    design = LOAD | {"mechanism": mechanism, "satellite_positions": places}
    found = balanced(design | {"bearing_positions": (-0.01, 0.09)}, speed)
    sizes = [1.5 * 2e-3] * len(places) + [each.unbalance for each in found.corrections]
    angles = [*mechanism.crank_angles, *(each.angle for each in found.corrections)]
    vectors = np.array(sizes) * np.exp(1j * np.array(angles))
    assert abs(vectors.sum()) < 1e-15
    assert abs((vectors * np.array([*places, -0.01, 0.09])).sum()) < 1e-16
    own = vectors[: len(places)]
    assert found.force == pytest.approx(abs(own.sum()) * speed**2, abs=1e-12 * speed**2)
    couple = abs((own * (np.array(places) - 0.04)).sum()) * speed**2
    assert found.couple == pytest.approx(couple, abs=1e-14 * speed**2)


def test_what_cannot_be_is_refused() -> None:
    for change, name in (
        ({"satellite_positions": (0.02,)}, "satellite_positions"),
        ({"bearing_positions": (0.06, 0.0)}, "bearing_positions[1]"),
        ({"bearing_positions": (0.06, 0.06)}, "bearing_positions[1]"),
        ({"eccentricity": 0.0}, "eccentricity"),
    ):
        with pytest.raises(InvalidInput) as refused:
            crankshaft(**REF | change)
        assert refused.value.parameter == name
    for still, name in (({"mass": 0.0}, "satellite_mass"), ({"speed": 0.0}, "input_speed")):
        with pytest.raises(InvalidInput) as refused:
            balanced(REF, **still)
        assert refused.value.parameter == name
    one = {"mechanism": spaced(2, 1), "satellite_positions": (0.02,)}
    with pytest.raises(ImpossibleMechanism):
        crankshaft(**REF | one)
