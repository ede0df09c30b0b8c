"""The whole OpenAPI description against the service: its examples, the edges of every limit,
random bodies good and bad, wrong methods; each answer is what the description promises.
"""

import re

import pytest
import schemathesis

from app.main import create_app
from core.codes import CODES
from tests.oracles.seeds import TIMES

OTHER_VIEWS = "" if TIMES > 1 else "|output-efficiency|load-sharing"

CONFIG = schemathesis.Config.from_dict(
    {
        "seed": 1,
        "request-timeout": 300,
        "generation": {
            "deterministic": True,
            "max-examples": 10 if TIMES > 1 else 5,
            "database": "none",
        },
        "analysis": {"constants": {"enabled": False}},  # numbers of the source are no inputs
        # A description cannot say which mechanisms exist: fields that are right one by one may
        # be refused together.
        # A study takes a second, and the edges of each of its many limits would take hundreds;
        # figures and files take what their calculations take: of those one figure is enough.
        # All views of the design document have its fields by one class (`test_views.py`): edges of
        # their limits are tried of one, and by `make accuracy` of three, whose examples give unlike
        # fields.
        "operations": [
            {
                "include-path-regex": "/tolerance-study|/propose|/sweep|/sensitivity"
                f"|/(ring-mesh|crankshaft|satellite-bearing|pin-strength|fit{OTHER_VIEWS})$",
                "phases": {"coverage": {"enabled": False}},
            },
            {
                "include-path-regex": "/export/|/(?!cyclogram|work-precision)[^/]*/chart",
                "phases": {"coverage": {"enabled": False}, "fuzzing": {"enabled": TIMES > 1}},
            },
        ],
        "checks": {"positive_data_acceptance": {"expected-statuses": ["200", "422"]}},
    }
)


@pytest.fixture
def description(request):
    """The service's description: cases are made where the test runs, not where it is collected."""
    request.node._nodeid = request.node.nodeid  # schemathesis 4.32 looks for it there
    return schemathesis.openapi.from_asgi("/openapi.json", create_app(), config=CONFIG)


schema = schemathesis.pytest.from_fixture("description")


PHYSICAL = {code for code, each in CODES.items() if each.kind == "impossible"} | {
    "dead_centre",
    "at_most",
    "below_working",
    "beyond_support",
    "different_length",
    "different_sum",
    "discs_disagree",
    "drawn_cup",
    "dust",
    "elastomer",
    "greater_than",
    "hole_disagrees",
    "in_carrier",
    "ratio_of_teeth",
    "infinite_line",
    "larger_than",
    "less_than",
    "no_arm",
    "no_class_of_size",
    "no_cycloid",
    "no_mesh",
    "more_than_whole",
    "no_sleeve",
    "no_such_bearing",
    "not_in_table",
    "not_sourced",
    "not_there",
    "not_this_cycloid",
    "not_this_mechanism",
    "not_zero",
    "one_of_coupling",
    "other_branch",
    "outside_method",
    "other_pitch",
    "right_angle",
    "roller_without_arm",
    "service_limit",
    "several_materials",
    "sign_of_ring",
    "smaller_than",
    "sum_not_one",
    "teeth_disagree",
    "to_be_drawn",
    "too_few",
    "too_near",
    "undercut",
    "too_thick",
    "too_many_pairs",
    "too_many_phases",
    "too_short_range",
    "with_real_forces",
    "with_rollers",
}
"""Codes with which a request may be refused that its schema admits: what cannot exist, does not fit
together, is too much, or too little to be meant."""

UNDESCRIBED = re.compile("/input/|/requests/")
"""Of another calculation, which the body names."""

BETWEEN_FIELDS = {
    "flanks_not_drawn",
    "follows_nothing",
    "missing",
    "moved_to",
    "needed_for",
    "needed_to_draw",
    "no_such_part",
    "no_tooth_form",
    "odd_ring_pins",
    "of_another_kind",
    "of_other_output",
}
"""Codes of rules between fields, which stand in their validators only."""

NEEDED = {"needed", "needed_beside", "only_one"}
"""Codes of what another field needs or excludes."""

OF_OTHER_FIELDS = (
    "/contact",
    "/contact/contact_length_mm",
    "/contact/pin_radius_mm",
    "/crankshaft/satellite_mass_kg",
    "/fatigue/fatigue_notch_factor",
    "/fatigue/notch",
    "/gear",
    "/gear/teeth_difference",
    "/load/application_factor",
    "/load/input_speed_rpm",
    "/load/ring_speed_rpm",
    "/pin",
    "/pin/contact_length_mm",
    "/pin/diameter_mm",
    "/pin/material",
    "/pin/span_mm",
    "/pin/support",
    "/satellite_coupling",
    "/tolerances/hole_diameter",
    "/tolerances/pin_diameter",
)
"""What another field of the request needs or excludes, by such a rule."""

OF_OTHER_SIZES = (
    "/build/carrier_diameter_mm",
    "/build/housing_diameter_mm",
    "/chord_error_mm",
    "/contact_law/reference_depth_mm",
    "/gear/dedendum",
    "/gear/rack_tip_radius",
    "/gear/ring_tip_radius_mm",
    "/gear/satellite_tip_radius_mm",
    "/mechanism/ring_teeth",
    "/mechanism/satellite_teeth",
    "/ratio_to",
)
"""What has limits that follow from other sizes."""


@schema.parametrize()
def test_the_service_does_what_its_description_says(case):
    response = case.call()
    if response.status_code == 503 and response.json()["type"] == "/problems/too-long":
        return  # fixes of 423 rollers and the like: when the time is over hangs on the machine
    if response.status_code == 501 and case.path.endswith("/export/step"):
        return  # the extra is not installed
    case.validate_response(response)
    described = case.meta.generation.mode.is_positive and isinstance(case.body, dict)
    if response.status_code != 422 or not described:  # 0 stands for a body that was not found
        return
    for error in response.json()["errors"]:
        if not UNDESCRIBED.match(error["pointer"]):
            place = error["pointer"].removeprefix("/design")  # of files, a request within
            there = NEEDED if place in OF_OTHER_FIELDS else set()
            if place == "/friction/coefficient":  # rollers have their own, in another section
                there = {"only_one"}
            if place in OF_OTHER_SIZES:
                there = {"greater_than_equal", "less_than_equal"}
            assert error["code"] in PHYSICAL | BETWEEN_FIELDS | there, error
