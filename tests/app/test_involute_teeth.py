"""The hob of involute teeth as a request leaves it out."""

import pytest

from app.calculations.ring import RingFields
from core.design.ring import InvoluteRing
from tests.inputs.involute import CASES


def test_a_hob_that_is_not_given_is_as_round_as_there_is_room_for():
    body = CASES[0]["body"]
    teeth = {name: body["mechanism"][name] for name in ("satellite_teeth", "ring_teeth")}
    difference = teeth["ring_teeth"] - teeth["satellite_teeth"]

    def rack(angle):
        given = body["gear"] | {"reference_pressure_angle_deg": angle}
        ring = RingFields.model_validate(given).to_core() | {"teeth_difference": difference}
        return InvoluteRing(**ring).involute_teeth(**teeth).rack

    assert rack(20.0).tip_radius == 0.38
    assert rack(25.0).tip_radius == pytest.approx(rack(25.0).most_round)
