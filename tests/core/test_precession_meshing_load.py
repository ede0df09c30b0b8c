"""Invariants, refusals and notices of the meshing load."""

import itertools
import math
from typing import Any

import pytest

from core.errors import ImpossibleMechanism, InvalidInput
from core.precession.contact_line import contact_points
from core.precession.meshing_load import MeshingLoad, line_load, meshing_load
from core.precession.rollers import RollerByAngle, RollerByLength
from core.precision import CONVERGED, ROUNDING, SAME
from tests.oracles.condition import condition

GEAR: dict[str, Any] = {
    "roller_circle_radius": 0.05,
    "roller_radius": 0.004,
    "nutation_angle": math.radians(6),
    "ratio_u12": 24 / 25,
}
ROLLER = RollerByLength(1.0, 0.015, 0.025)


def test_the_flank_does_not_change_the_force() -> None:
    by_z = meshing_load(**GEAR, rollers=[ROLLER], torque=10.0, reference_z=0.02)
    (line,) = by_z.lines
    for half_turns, codes in ((0, []), (1, ["unloaded_flank"]), (2, [])):
        turned = RollerByAngle(
            1.0, line.phi_min + half_turns * math.pi, line.phi_max + half_turns * math.pi
        )
        load = meshing_load(**GEAR, rollers=[turned], torque=10.0, reference_z=0.02)
        assert load.force == pytest.approx(by_z.force, rel=SAME)
        assert load.moment == pytest.approx(by_z.moment, rel=SAME)
        assert [notice.code for notice in load.notices] == codes


def test_largest_line_load_lies_at_an_end() -> None:
    load = meshing_load(**GEAR, rollers=[ROLLER], torque=10.0, reference_z=0.02)
    (line,) = load.lines
    q = line_load(load=load, line=line, z=contact_points(line=line, samples=1001).z)
    assert max(q) == pytest.approx(load.max_line_load, rel=CONVERGED)


MESH = GEAR | {"torque": 10.0, "reference_z": 0.02}
ANGLES = dict.fromkeys(("nutation_angle", "position_angle", "phi_min", "phi_max"), 1.5)
NEARLY = math.cos(math.radians(6)) - 1e-4
"""A ratio u12 that leaves A only the last digits of cos(theta)."""
STEEPEST = 0.05 * (math.cos(math.radians(6)) - 24 / 25) / math.sin(math.radians(6))


def one_roller(**inputs: float) -> MeshingLoad:
    """The load on one roller, whose inputs stand beside those of the mesh."""
    names = [name for name in inputs if name not in MESH]
    kind = RollerByAngle if "phi_min" in names else RollerByLength
    roller = kind(**{name: inputs[name] for name in names})
    return meshing_load(**{name: inputs[name] for name in MESH}, rollers=[roller])


@pytest.mark.parametrize(
    "inputs",
    [
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.025},
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.025, "reference_z": 2.0},
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.015001, "reference_z": 0.0150005},
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.015003},
        {"position_angle": 0.5, "z_min": 1e-7, "z_max": 0.02},
        {"position_angle": 0.5, "z_min": -0.02, "z_max": -1e-7, "torque": -3.0},
        {"position_angle": 3.1, "z_min": 0.999 * STEEPEST, "z_max": 1.02 * STEEPEST},
        {"position_angle": 3.1, "z_min": 1.01 * STEEPEST, "z_max": 1.02 * STEEPEST},
        {"position_angle": 2.5, "z_min": 1e-4, "z_max": 2e-4, "ratio_u12": NEARLY},
        {"position_angle": 2.5, "z_min": 1e-8, "z_max": 2e-7, "ratio_u12": NEARLY},
        {"position_angle": 0.5, "phi_min": -0.35, "phi_max": -0.2},
        {"position_angle": 0.5, "phi_min": -0.499, "phi_max": -0.2},
        {"position_angle": 0.5, "phi_min": -0.3, "phi_max": -0.2999},
        {"position_angle": 0.5, "phi_min": 200 * math.pi - 0.3, "phi_max": 200 * math.pi - 0.2},
        {"position_angle": 1.5, "phi_min": 0.3, "phi_max": 1.2, "ratio_u12": NEARLY},
        {"position_angle": 20.5 * math.pi, "z_min": 0.015, "z_max": 0.025},
        {
            "position_angle": 0.5,
            "phi_min": 200 * math.pi - 0.3,
            "phi_max": 200 * math.pi - 0.2999,
            "reference_z": STEEPEST * math.sin(0.29995) / math.sin(0.20005),
        },
        {
            "position_angle": 0.5,
            "phi_min": -0.3,
            "phi_max": -0.2999,
            "reference_z": 0.0029 * STEEPEST * math.sin(0.29995) / math.sin(0.20005),
            "ratio_u12": NEARLY,
        },
        {"position_angle": 10 * math.pi + 0.01, "z_min": 0.015, "z_max": 0.025},
    ],
)
def test_the_stated_error_is_the_condition_of_the_input(inputs: dict[str, float]) -> None:
    """Not less than what rounding of every input may do, and not many times more."""
    inputs = MESH | inputs
    load = one_roller(**inputs)
    unit = abs(inputs["torque"]) / inputs["roller_circle_radius"]
    sizes = {
        "force": max(math.hypot(*load.force), unit),
        "moment": math.hypot(*load.moment),
        "max_line_load": load.max_line_load,
    }
    needed = {
        name: condition(
            lambda name=name, **each: getattr(one_roller(**each), name),
            inputs,
            {**ANGLES, "ratio_u12": 0.5},
            size=size,
        )
        for name, size in sizes.items()
    }
    stated = load.accuracy.relative_error / ROUNDING
    assert max(needed.values()) + 2 <= stated <= 12 * max(needed.values())
    assert load.force_error >= needed["force"] * ROUNDING * sizes["force"]
    # about the axis the moment is the torque, which is as exact as it is given
    beside_torque = needed["moment"] - abs(inputs["torque"]) / sizes["moment"]
    assert load.moment_error >= beside_torque * ROUNDING * sizes["moment"]


@pytest.mark.parametrize("phi_1", [0.5, 2.5])
def test_a_line_cut_in_pieces_is_loaded_alike(phi_1: float) -> None:
    """However near it comes to z = 0, where the load has a pole."""
    cuts = [1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.02]
    whole, pieces = (
        meshing_load(
            **GEAR,
            rollers=[RollerByLength(phi_1, *ends) for ends in itertools.pairwise(places)],
            torque=10.0,
            reference_z=0.02,
        )
        for places in ([cuts[0], cuts[-1]], cuts)
    )
    assert math.dist(whole.force, pieces.force) <= whole.force_error + pieces.force_error
    assert math.dist(whole.moment, pieces.moment) <= whole.moment_error + pieces.moment_error
    assert pieces.max_line_load == pytest.approx(whole.max_line_load, rel=CONVERGED)


def test_a_load_that_is_hardly_known_is_noticed() -> None:
    narrow = RollerByLength(1.0, 0.02, 0.02 * (1 + 2e-14))
    load = meshing_load(**GEAR, rollers=[narrow], torque=10.0, reference_z=0.02)
    assert [notice.code for notice in load.notices] == ["hardly_known"]
    assert load.notices[0].params == {"error": load.accuracy.relative_error}


def test_small_arm_is_noticed() -> None:
    near = RollerByLength(1.0, 1e-5, 0.01)
    load = meshing_load(**GEAR, rollers=[near], torque=10.0, reference_z=0.02)
    assert [notice.code for notice in load.notices] == ["small_arm"]


def test_refusals() -> None:
    for torque in (0.0, math.nan, math.inf):
        with pytest.raises(InvalidInput) as caught:
            meshing_load(**GEAR, rollers=[ROLLER], torque=torque, reference_z=0.0)
        assert caught.value.parameter == "torque"
    with pytest.raises(InvalidInput) as caught:
        meshing_load(**GEAR, rollers=[ROLLER], torque=1.0, reference_z=math.nan)
    assert caught.value.parameter == "reference_z"
    for roller in (
        RollerByLength(1.0, -0.01, 0.01),
        RollerByLength(1.0, 0.0, 0.01),
        RollerByAngle(1.0, -0.5, 0.5),
        RollerByAngle(1.0, 0.0, 0.5),
        RollerByAngle(-1.0, math.pi, 3.5),
    ):
        with pytest.raises(ImpossibleMechanism) as impossible:
            meshing_load(**GEAR, rollers=[ROLLER, roller], torque=1.0, reference_z=0.0)
        assert impossible.value.where == {"roller": 2.0, "z": 0.0}
