"""The mesh of the ring in the design document over REST: what is refused, and that it is what
`/ring-mesh` answers.
"""

from copy import deepcopy

import pytest

from app.examples import REQUESTS

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
ALONE = REQUESTS["ring-mesh"]
DESIGN = {
    "mechanism": {"pins": 6, **ALONE["mechanism"]},
    "load": {**ALONE["load"], "pin_circle_radius_mm": 32.0},
    "contact": {
        **ALONE["contact"],
        "pin_radius_mm": 5.0,
        "contact_length_mm": 12.0,
        "hole_clearance_mm": 0.02,
    },
    "gear": ALONE["gear"],
    "include": ["checks"],
}
"""The example of `/ring-mesh` with the pins of an output."""


def changed(**sections):
    """The design with other fields; None takes one away."""
    body = deepcopy(DESIGN)
    for section, fields in sections.items():
        if not isinstance(fields, dict):
            body[section] = fields
            continue
        inner = body.setdefault(section, {})
        inner |= fields
        for name in [name for name, value in inner.items() if value is None]:
            del inner[name]
    return body


@pytest.mark.parametrize(
    ("sections", "pointer", "code"),
    [
        ({"gear": {"disc_material": "steel_structural"}}, "/gear/disc_material", "discs_disagree"),
        ({"gear": {"span_mm": 40.0}}, "/gear/span_mm", "of_another_kind"),
        ({"gear": {"pin_support": "fixed"}}, "/gear/span_mm", "needed_beside"),
        (
            {
                "gear": {
                    "pin_support": "fixed",
                    "span_mm": 40.0,
                    "satellite_positions_mm": [20.0],
                }
            },
            "/gear/satellite_positions_mm",
            "different_length",
        ),
        (
            {
                "gear": {
                    "pin_support": "fixed",
                    "span_mm": 40.0,
                    "satellite_positions_mm": [20.0, 31.0],
                }
            },
            "/gear/satellite_positions_mm/1",
            "too_near",
        ),
        ({"gear": {"sleeve_bore_radius_mm": 5.0}}, "/gear/sleeve_bore_radius_mm", "smaller_than"),
        (
            {"deviations": {"ring_pin_radius_mm": [0.001] * 19}},
            "/deviations/ring_pin_radius_mm",
            "different_length",
        ),
        (
            {
                "gear": {"kind": "none", **dict.fromkeys(set(ALONE["gear"]) - {"kind"})},
                "deviations": {"ring_pin_radial_mm": [0.001] * 20},
            },
            "/gear",
            "needed_beside",
        ),
        ({"gear": {"kind": "none"}}, "/gear/ring_pin_circle_radius_mm", "of_another_kind"),
    ],
)
async def test_what_does_not_fit_together_is_refused(api, sections, pointer, code):
    response = await api.post(PATH, json=changed(**sections))
    (error,) = response.json()["errors"]
    assert (error["pointer"], error["code"]) == (pointer, code)


async def test_pins_of_the_ring_leave_those_of_the_output_alone(api):
    """Where only the ring's pins deviate, nothing is said of the parts of the output."""
    perfect = {"contact": {"hole_clearance_mm": 0.0}}
    made = {"deviations": {"ring_pin_radial_mm": [0.001] * 20}}
    for sections, model in ((made, "ideal"), ({"deviations": {}}, "real")):
        answer = (await api.post(PATH, json=changed(**perfect, **sections))).json()
        assert answer["model"] == model


async def test_the_discs_may_be_named_as_their_holes_are(api):
    named = {"gear": {"disc_material": "steel_through_hardened"}}
    assert (await api.post(PATH, json=changed(**named))).status_code == 200
