"""The crankshaft over REST."""

from copy import deepcopy

import pytest

from app.examples import REQUESTS

pytestmark = pytest.mark.anyio

PATH = "crankshaft"


def changed(**fields):
    body = deepcopy(REQUESTS[PATH])
    body["crankshaft"] |= fields
    return body


async def test_only_what_is_known_is_answered(api):
    body = changed()
    del body["crankshaft"]["satellite_mass_kg"], body["crankshaft"]["bearings"]
    answer = (await api.post(PATH, json=body)).json()
    assert "balance" not in answer and "basic_life_h" not in answer["bearings"][0]


async def test_the_limit_of_a_place_is_in_its_unit(api):
    refused = await api.post(PATH, json=changed(bearing_positions_mm=[62.0, 0.0]))
    (error,) = refused.json()["errors"]
    assert (error["params"], error["detail"]) == ({"limit": 62}, "must be greater than 62")


async def test_the_figure_shows_both_bearings(api):
    figure = (await api.post(f"{PATH}/chart", json=REQUESTS[PATH])).json()
    assert [each["name"] for each in figure["data"]] == [*["Bearing A"] * 2, *["Bearing B"] * 2]


ALONE = {
    "mechanism": {"pins": 6, "satellites": 1, "ratio": 20, "crank_angles_deg": [0]},
    "load": {"input_speed_rpm": 1500, "output_torque_Nm": 250, "pin_circle_radius_mm": 50},
    "contact": {"eccentricity_mm": 2},
    "gear": {"radial_force_ratio": 0.7},
    "crankshaft": {
        "satellite_mass_kg": 1.5,
        "satellite_positions_mm": [31],
        "bearing_positions_mm": [0, 62],
    },
}


def weighted(*weights, **shaft):
    body = deepcopy(ALONE)
    names = ("unbalance_kg_mm", "position_mm", "angle_deg")
    given = [dict(zip(names, each, strict=False)) for each in weights]
    body["crankshaft"] |= {"counterweights": given} | shaft
    return body


async def test_what_corrects_it_leaves_nothing(api):
    first = (await api.post(PATH, json=weighted())).json()["balance"]["corrections"]
    weights = [
        (each["unbalance_kg_mm"], place, each["angle_deg"])
        for each, place in zip(first, (0, 62), strict=True)
    ]
    left = (await api.post(PATH, json=weighted(*weights))).json()["balance"]
    assert (left["force_N"], left["couple_Nm"]) == (0, 0)
    assert [each["unbalance_kg_mm"] for each in left["corrections"]] == [0, 0]


PUBLISHED = {
    "mechanism": {"pins": 8, "satellites": 1, "satellite_teeth": 15, "ring_teeth": 16},
    "load": {
        "input_torque_Nm": 1.55,
        "efficiency": 1.0,
        "pin_circle_radius_mm": 40,
        "input_speed_rpm": 1500,
    },
    "contact": {
        "contact_length_mm": 10,
        "pin_radius_mm": 5,
        "hole_clearance_mm": 0.02,
        "eccentricity_mm": 3,
        "pin_material": {
            "youngs_modulus_GPa": 200,
            "poissons_ratio": 0.3,
            "allowable_pressure_MPa": 400,
        },
        "hole_material": {
            "youngs_modulus_GPa": 200,
            "poissons_ratio": 0.3,
            "allowable_pressure_MPa": 400,
        },
    },
    "gear": {"radial_force_ratio": 0.3},
    "crankshaft": {
        "satellite_positions_mm": [20],
        "bearing_positions_mm": [0, 40],
        "satellite_mass_kg": 0.8,
        "bearings": [
            {
                "kind": "ball",
                "dynamic_rating_N": 4000,
                "bore_diameter_mm": 10,
                "outer_diameter_mm": 26,
                "width_mm": 8,
            }
        ]
        * 2,
    },
    "requirements": {"scope": ["contact", "crank_bearings"], "life_h": 1000},
    "include": ["checks"],
}
"""The single disc of a published optimisation, with a shaft."""


@pytest.mark.parametrize(
    ("shaft", "asked", "status"),
    [
        ({}, {}, "marginal"),
        ({"counterweights": [{"unbalance_kg_mm": 2.4, "position_mm": 20}]}, {}, "pass"),
        ({}, {"max_unbalance_N": 60.0}, "pass"),
        ({}, {"max_unbalance_N": 59.0}, "fail"),
        ({}, {"balance_grade_mm_per_s": 500.0}, "pass"),
        ({}, {"balance_grade_mm_per_s": 400.0}, "fail"),
        ({}, {"max_unbalance_share": 0.5}, "pass"),
        ({}, {"max_unbalance_share": 0.01}, "fail"),
        ({"satellite_mass_kg": None}, {}, "not_asked"),
    ],
)
async def test_a_single_disc_may_pass(api, shaft, asked, status):
    """0.8 kg at 3 mm and 1500 rpm pull with 59.2 N."""
    body = deepcopy(PUBLISHED)
    body["crankshaft"] = {
        name: value for name, value in (body["crankshaft"] | shaft).items() if value is not None
    }
    body["requirements"] |= asked
    answer = (await api.post("crank-planetary", json=body)).json()
    checks = {each["code"]: each for each in answer["checks"]}
    force = checks["unbalance_force"]
    assert force["status"] == status and force["was"] == "crank_balance"
    assert "crank_balance" not in checks
    if status == "not_asked":
        assert force["reason"]["code"] == "mass_unknown"
        assert force["missing"] == ["/crankshaft/satellite_mass_kg"]
        return
    assert force["unit"] == "N"
    parts = {each["code"]: each["status"] for each in answer["parts"]}
    assert parts["crank_bearings"] == status
    assert force["source_code"] == ("user" if asked else "balance_guide")
    assert (force.get("reason", {}).get("code") == "unbalanced") == (status == "marginal")
