"""Largest stresses of pins that a search has missed: of many summits over the turn nearly as high
the highest was not followed, as it was lower where the search began.
"""

import json
from pathlib import Path
from typing import Any

import pytest

from core.output.mechanism import Mechanism
from core.output.pin_fatigue import FatigueStrength
from tests.inputs.loads import pin_strength
from tests.inputs.real_mechanisms import PIN_STEEL

HIDDEN = json.loads(
    (Path(__file__).parent.parent / "oracles" / "hidden_pin_summits.json").read_text("utf-8")
)
"""Designs, and what `tests.oracles.pin_scan` says is largest; the last one was an error of the
program, as arcs of 2e-8 rad gave 0/0.
"""


def found(name: str, design: dict[str, Any]) -> tuple[float, float]:
    """A number of the strength of a pin, and its stated error."""
    own = dict(design)
    mechanism = Mechanism(
        pins=own.pop("pins"), crank_angles=tuple(own.pop("crank_angles")), ratio=20.0
    )
    limit, tensile, criterion = (
        own.pop(each) for each in ("endurance_limit", "tensile_strength", "criterion")
    )
    strength = pin_strength(
        mechanism=mechanism,
        output_torque=500.0,
        pin_circle_radius=0.05,
        material=PIN_STEEL,
        fatigue=FatigueStrength(limit, tensile, 600e6, criterion),
        **own | {"satellite_positions": tuple(own["satellite_positions"])},
    )
    of = strength.fatigue if name == "safety_factor" else strength
    return getattr(of, name), strength.accuracy.relative_error


@pytest.mark.parametrize("case", HIDDEN)
def test_summits_that_are_lower_where_the_search_begins(case: dict[str, Any]) -> None:
    value, error = found(case["name"], case["design"])
    assert error < 2e-6
    assert value == pytest.approx(case["value"], rel=error)
