"""Searches and solvers take one design: an array is refused by the name of its parameter."""

import inspect
from collections.abc import Callable
from typing import Any, get_type_hints

import numpy as np
import pytest

from core.crank.ring_mesh import RingMesh
from core.errors import InvalidInput
from core.output.contact_force import contact_force
from core.output.loaded_position import loaded_position
from core.output.mechanism import pin_fit
from core.output.over_turn import over_turn
from core.output.real_curves import real_curves, stiffness_curve
from core.output.real_mechanism import RealMechanism
from tests.inputs.loads import crankshaft, pin_strength, pin_stresses, satellite_bearings
from tests.inputs.real_mechanisms import REFERENCE, UNLIKE, made

REAL = {"real": UNLIKE, "output_torque": 200.0}
MECHANISM = {"mechanism": REFERENCE["mechanism"]}
SHAFT = MECHANISM | {"output_torque": 500.0, "pin_circle_radius": 0.05, "eccentricity": 2e-3}
FORCE = MECHANISM | {"force_exponent": 1.0, "output_torque": 500.0, "pin_circle_radius": 0.05}
SHAFT |= {"mesh": RingMesh(0.5)}

SINGLE: list[tuple[Callable[..., Any], dict[str, Any]]] = [
    (pin_stresses, REFERENCE | {"span": 0.1, "support": "fixed", "peak_torque": 900.0}),
    (over_turn, REAL | {"lost_motion_share": 0.03}),
    (loaded_position, REAL | {"crank_angle": 0.1}),
    (real_curves, REAL | {"crank_angle": np.zeros(1)}),
    (stiffness_curve, {"real": UNLIKE, "crank_angle": 0.1, "torques": [1.0]}),
    (pin_fit, {"pins": 6, "pin_radius": 0.008, "hole_radius": 0.01, "eccentricity": 2e-3}),
    (contact_force, FORCE),
    (
        crankshaft,
        SHAFT
        | {
            "satellite_positions": (0.015, 0.037),
            "bearing_positions": (0.0, 0.05),
        },
    ),
    (
        RealMechanism,
        {each: getattr(UNLIKE, each) for each in RealMechanism.__dataclass_fields__},
    ),
]

LOADED = ("output_torque", "pin_circle_radius", "peak_torque")
"""Numbers of a load on pins."""


def numbers(function: Callable[..., Any]) -> set[str]:
    """Parameters that are one number."""
    hints = get_type_hints(function if inspect.isfunction(function) else function.__init__)
    own = {name for name, hint in hints.items() if hint in (float, float | None)}
    return own | ({*LOADED} if "load" in hints else set())


@pytest.mark.parametrize(
    ("function", "given"), SINGLE, ids=lambda each: getattr(each, "__name__", "")
)
def test_an_array_is_refused_by_name(function: Callable[..., Any], given: dict[str, Any]) -> None:
    given = {name: each for name, each in given.items() if name not in ("fatigue",)}
    asked = numbers(function) & {*given}
    assert asked
    for name in asked:
        for size in (1, 2):
            with pytest.raises(InvalidInput) as refusal:
                function(**given | {name: np.full(size, given[name])})
            assert (refusal.value.parameter, refusal.value.code) == (name, "not_single")


def test_two_radii_are_not_the_smaller_one() -> None:
    with pytest.raises(InvalidInput, match=r"pin_circle_radius = .* must be one number"):
        pin_strength(**REFERENCE | {"pin_circle_radius": np.array([0.05, 0.06])})


def test_the_bearings_of_a_mechanism_as_made_are_of_one_torque() -> None:
    given = SHAFT | {"mechanism": UNLIKE.mechanism, "made": made(UNLIKE), "kind": "ball"}
    with pytest.raises(InvalidInput, match=r"output_torque = .* must be one number"):
        satellite_bearings(**given | {"output_torque": np.array([200.0, 300.0])})
