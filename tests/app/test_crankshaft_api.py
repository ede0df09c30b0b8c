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


async def test_the_reference_design(api):
    teeth = {"kind": "involute", "module_mm": 3.5, "teeth_difference": 1}
    answer = (await api.post(PATH, json=REQUESTS[PATH] | {"gear": teeth})).json()
    first, last = answer["bearings"]
    assert f"{first['peak_N']:.3f}" == f"{last['peak_N']:.3f}" == "4487.098"
    life = (30_000 / first["equivalent_N"]) ** 3 * 1e6 / 60 / 1500
    assert first["basic_life_h"] == pytest.approx(life, rel=1e-12)
    balance = answer["balance"]
    assert f"{balance['couple_Nm']:.6f}" == "1.628485"
    assert balance["unbalance_kg_mm"] == pytest.approx(0, abs=1e-12)
    sizes = [each["unbalance_kg_mm"] for each in balance["corrections"]]
    assert sizes == pytest.approx([3 * 22 / 62] * 2, rel=1e-12)
    angles = [each["angle_deg"] for each in balance["corrections"]]
    assert abs(angles[0] - angles[1]) == pytest.approx(180, rel=1e-12)


async def test_only_what_is_known_is_answered(api):
    body = changed()
    del body["crankshaft"]["satellite_mass_kg"], body["crankshaft"]["bearings"]
    answer = (await api.post(PATH, json=body)).json()
    assert "balance" not in answer and "basic_life_h" not in answer["bearings"][0]


@pytest.mark.parametrize(
    ("fields", "pointer", "code"),
    [
        (
            {"satellite_positions_mm": [20.0]},
            "/crankshaft/satellite_positions_mm",
            "different_length",
        ),
        (
            {"bearing_positions_mm": [62.0, 0.0]},
            "/crankshaft/bearing_positions_mm/1",
            "greater_than",
        ),
        (
            {"satellite_positions_mm": [20.0, "x"]},
            "/crankshaft/satellite_positions_mm/1",
            "float_type",
        ),
    ],
)
async def test_what_cannot_be_is_refused(api, fields, pointer, code):
    refused = await api.post(PATH, json=changed(**fields))
    assert refused.status_code == 422
    assert [(each["pointer"], each["code"]) for each in refused.json()["errors"]] == [
        (pointer, code)
    ]


async def test_the_limit_of_a_place_is_in_its_unit(api):
    refused = await api.post(PATH, json=changed(bearing_positions_mm=[62.0, 0.0]))
    (error,) = refused.json()["errors"]
    assert (error["params"], error["detail"]) == ({"limit": 62}, "must be greater than 62")


async def test_the_figure_shows_both_bearings(api):
    figure = (await api.post(f"{PATH}/chart", json=REQUESTS[PATH])).json()
    assert [each["name"] for each in figure["data"]] == [*["Bearing A"] * 2, *["Bearing B"] * 2]
