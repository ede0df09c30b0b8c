"""Involute teeth as a request has them, and their sizes and stresses as an answer says them."""

import pytest
from pydantic import ValidationError

from app.calculations.involute_teeth import (
    InvoluteGeometryOut,
    InvoluteStressesOut,
    RootStressOut,
)
from app.calculations.ring import RingFields
from core.design.ring import InvoluteRing
from core.hertz import ElasticMaterial
from core.precision import CONVERGED
from core.ring.involute import involute_pair
from core.ring.involute_load import involute_load, root_stress
from tests.inputs.involute import CASES

STEEL = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)


def gear_of(case):
    """Tooth data of a case."""
    return dict(case["body"]["gear"])


def teeth_of(gear, case):
    mechanism = case["body"]["mechanism"]
    numbers = {name: mechanism[name] for name in ("satellite_teeth", "ring_teeth")}
    difference = {"teeth_difference": numbers["ring_teeth"] - numbers["satellite_teeth"]}
    given = RingFields.model_validate({"reference_pressure_angle_deg": 20.0} | gear).to_core()
    ring = InvoluteRing(**given | difference)
    return ring.involute_teeth(**numbers)


def pair_of(case):
    eccentricity = case["body"].get("contact", {}).get("eccentricity_mm")
    given = None if eccentricity is None else eccentricity / 1e3
    return involute_pair(teeth=teeth_of(gear_of(case), case), eccentricity=given)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_the_answer_has_the_held_numbers_by_their_names(case):
    pair, expected = pair_of(case), case["expect"]
    found = InvoluteGeometryOut.values(pair)
    InvoluteGeometryOut.model_validate(found)
    approximate = {"rel": case["rtol"], "abs": 1e-12}
    for name, value in expected["geometry"].items():
        assert found[name] == (
            value if isinstance(value, bool) else pytest.approx(value, **approximate)
        )
    width = case["body"]["gear"]["contact_length_mm"] / 1e3
    loaded = {"pair": pair, "contact_length": width}
    loaded["torque"] = case["body"]["load"]["output_torque_Nm"]
    root = RootStressOut.values(root_stress(**loaded))
    load = involute_load(**loaded, satellite_material=STEEL, ring_material=STEEL)
    stresses = InvoluteStressesOut.values(load, root=root)
    InvoluteStressesOut.model_validate(stresses)
    held = dict(expected["stresses"])
    assert root == pytest.approx(held.pop("root"), **approximate)
    stresses.pop("root")
    assert stresses == pytest.approx(held, **approximate)


def test_tip_radii_stand_for_addenda():
    case = CASES[1]
    gear, pair = gear_of(case), pair_of(case)
    for name in ("satellite", "ring"):
        del gear[f"{name}_addendum"]
    gear |= {"satellite_tip_radius_mm": 62.4, "ring_tip_radius_mm": 61.68}
    found = teeth_of(gear, case)
    for name in ("satellite_tip", "ring_tip"):
        assert getattr(found, name) == pytest.approx(getattr(pair.teeth, name), rel=CONVERGED)
    with pytest.raises(ValidationError, match="only_one"):
        teeth_of(gear | {"ring_addendum": 0.8}, case)


def test_a_hob_that_is_not_given_is_as_round_as_there_is_room_for():
    gear = gear_of(CASES[0])
    assert teeth_of(gear, CASES[0]).rack.tip_radius == 0.38
    steep = teeth_of(gear | {"reference_pressure_angle_deg": 25}, CASES[0]).rack
    assert steep.tip_radius == pytest.approx(steep.most_round)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("satellite_profile_shift", -2.1),
        ("ring_profile_shift", 3.1),
        ("satellite_addendum", 0.2),
        ("ring_addendum", 1.3),
        ("module_mm", 0),
        ("teeth", 3),
    ],
)
def test_what_is_beyond_the_limits_is_refused(name, value):
    with pytest.raises(ValidationError):
        RingFields.model_validate(gear_of(CASES[0]) | {name: value})
