"""One design document for all calculations of a drive: what one takes the others take, with the
numbers that the whole design has.
"""

from copy import deepcopy

import pytest

from app.calculations.document import DocumentFields
from app.examples import EXAMPLES, REQUESTS
from app.registry import CALCULATIONS

pytestmark = pytest.mark.anyio

VIEWS = [
    name
    for name, each in CALCULATIONS.items()
    if isinstance(each.request, type) and issubclass(each.request, DocumentFields)
]
"""Calculations whose request is the document with what is asked."""

SECTIONS = DocumentFields.model_fields.keys()

TOLERANCES = {"pin_position_mm": 0.01}


def document(body):
    """Sections of a request, without what is asked."""
    return {name: each for name, each in deepcopy(body).items() if name in SECTIONS}


def test_all_calculations_of_a_drive_are_views():
    assert {*VIEWS} == {
        "crank-planetary",
        "crankshaft",
        "fit",
        "load-sharing",
        "output-efficiency",
        "pin-strength",
        "ring-mesh",
        "satellite-bearing",
        "tolerance-study",
    }


@pytest.mark.parametrize("view", VIEWS)
async def test_what_one_takes_all_take(api, view):
    """A document lacks at most what the view needs, and sections that it does not use are named."""
    asked = {"samples": 40, "percentiles": []} if view == "tolerance-study" else {}
    bodies = [REQUESTS[name] for name in VIEWS]
    bodies += [each["input"] for each in EXAMPLES if each["calculation"] in VIEWS]
    taken = 0
    for body in bodies:
        given = document(body) | ({"tolerances": TOLERANCES} if asked else {})
        answer = await api.post(view, json=given | asked)
        if answer.status_code == 200:
            taken += 1
            uses = CALCULATIONS[view].request.model_validate(given | asked).uses
            idle = [name for name in SECTIONS if name in given and name not in uses]
            assert answer.json().get("not_used", []) == idle and "mechanism" in uses
            continue
        (error,) = answer.json()["errors"]
        assert error["code"] == "missing", answer.text
    assert taken > 1


async def test_what_a_view_needs_is_described_and_refused(api):
    described = (await api.get("openapi.json")).json()["components"]["schemas"]
    needs = described["LoadSharingRequest"]["x-needs"]
    assert needs[0] == "/mechanism/pins" and "/load/output_torque_Nm" in needs
    for pointer in needs:
        section, name = pointer[1:].split("/")
        body = document(REQUESTS["load-sharing"])
        del body[section][name]
        (error,) = (await api.post("load-sharing", json=body)).json()["errors"]
        assert error["pointer"] == pointer and error["code"] in ("missing", "needed_beside")
