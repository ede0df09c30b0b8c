"""Every design that is shown has teeth that exist: found here, with nothing of the service."""

import json
import math
import re
from pathlib import Path

import pytest

from app.examples import EXAMPLES, REQUESTS

TUTORIAL = (Path(__file__).parent.parent.parent / "docs" / "tutorial.md").read_text()
ASKED = [json.loads(each) for each in re.findall(r"ask \S+ '(.*?)'\n", TUTORIAL, re.DOTALL)]
BODIES = [each["input"] for each in EXAMPLES] + list(REQUESTS.values()) + ASKED
DESIGNS = {
    json.dumps([body["mechanism"], body["gear"], body["contact"]["eccentricity_mm"]]): body
    for body in BODIES
    if body.get("gear", {}).get("kind") == "involute"
}

DEDENDUM, RACK_TIP, MARGIN = 1.25, 0.38, 0.05


def involute(angle: float) -> float:
    return math.tan(angle) - angle


def contact_ratio(*, small: int, large: int, module: float, centre: float, shift: float,
                  addendum: float, ring_addendum: float) -> float:  # fmt: skip
    """Contact ratio of an internal pair without backlash at a centre distance; 0 where tips meet,
    the path leaves the involutes or there is none.
    """
    angle = math.radians(20)
    base, ring_base = (module * z * math.cos(angle) / 2 for z in (small, large))
    working = math.acos((ring_base - base) / centre)
    difference = large - small
    shifts = difference * (involute(working) - involute(angle)) / (2 * math.tan(angle))
    tip = module * (small / 2 + shift + addendum)
    ring_tip = module * (large / 2 + shift + shifts - ring_addendum)
    if ring_tip <= ring_base or tip > ring_tip + centre:
        return 0.0
    at_tip, at_ring_tip = math.acos(base / tip), math.acos(ring_base / ring_tip)
    if tip + centre > ring_tip:  # the tip circles cross: the tips must pass each other
        own = math.acos((ring_tip**2 - tip**2 - centre**2) / (2 * tip * centre))
        other = math.acos((ring_tip**2 - tip**2 + centre**2) / (2 * ring_tip * centre))
        past = small * (involute(at_tip) + own) - large * (involute(at_ring_tip) + other)
        if past + difference * involute(working) < MARGIN:
            return 0.0
    start = (large * math.tan(at_ring_tip) - difference * math.tan(working)) / small
    straight = DEDENDUM - RACK_TIP * (1 - math.sin(angle))
    form = math.tan(angle) - 4 * (straight - shift) / (small * math.sin(2 * angle))
    if start < max(form, 0.0):
        return 0.0
    return (
        small * (math.tan(at_tip) - math.tan(working))
        + large * (math.tan(working) - math.tan(at_ring_tip))
    ) / (2 * math.pi)


def best_contact_ratio(small: int, large: int, module: float, centre: float) -> float:
    """Of teeth as they are usually cut: shifts -0.5 to 1, addenda 0.5 to 1.25."""
    usual = [0.5 + 0.05 * k for k in range(16)]
    return max(
        contact_ratio(small=small, large=large, module=module, centre=centre,
                      shift=-0.5 + 0.1 * k, addendum=own, ring_addendum=other)
        for k in range(16) for own in usual for other in usual
    )  # fmt: skip


def test_the_measure_knows_what_meshes() -> None:
    assert best_contact_ratio(40, 42, 3.0, 3.68) > 1.2
    assert best_contact_ratio(40, 42, 3.0, 3.2) == 0  # the tips meet
    assert best_contact_ratio(20, 21, 3.5, 2.0) < 1


@pytest.mark.parametrize("name", DESIGNS)
def test_shown_designs_have_teeth(name: str) -> None:
    body = DESIGNS[name]
    gear, mechanism = body["gear"], body["mechanism"]
    eccentricity = body["contact"]["eccentricity_mm"]
    difference = gear.get("teeth_difference", 1)
    small = mechanism.get("satellite_teeth") or mechanism["ratio"] * difference
    assert best_contact_ratio(int(small), int(small) + difference, gear["module_mm"],
                              eccentricity) >= 1.05  # fmt: skip


def test_there_are_such_designs() -> None:
    assert len(DESIGNS) >= 3
