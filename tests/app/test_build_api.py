"""Carrier and housing over REST: places that follow, usual values, envelope, checks, mass."""

from typing import Any

import pytest

from core.precision import EXACT, SAME
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
REDUCER: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {"output_torque_Nm": 200.0, "pin_circle_radius_mm": 36.0, "input_speed_rpm": 1500.0},
    "contact": {
        "contact_length_mm": 20.0,
        "pin_radius_mm": 6.0,
        "eccentricity_mm": 2.0,
        "hole_clearance_mm": 0.02,
    },
    "pin": {"support": "supported"},
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 65.0,
        "ring_pin_radius_mm": 4.0,
        "modification": {"equidistant_mm": 0.02},
    },
    "crankshaft": {},
    "build": {},
}
ENVELOPE = ("outer_diameter_mm", "length_mm", "of")
FOLLOWED = {
    "/pin/satellite_positions_mm": [12.0, 34.0],
    "/pin/span_mm": 46.0,
    "/crankshaft/satellite_positions_mm": [12.0, 34.0],
    "/crankshaft/bearing_positions_mm": [-7.2, 53.2],
}
USUAL = {
    "/build/gap_mm": 2.0,
    "/build/carrier_width_mm": 14.4,
    "/build/second_carrier_width_mm": 14.4,
    "/build/carrier_diameter_mm": 96.0,
    "/build/housing_diameter_mm": 152.0,
    "/build/housing_width_mm": 46.0,
}


def assumed(answer: dict[str, Any]) -> dict[str, Any]:
    return {each["pointer"]: each["value"] for each in answer["assumed"]}


async def test_places_follow_and_are_said(api: Any) -> None:
    answer = await api.answer(PATH, REDUCER)
    said = assumed(answer)
    assert {pointer: said[pointer] for pointer in USUAL | FOLLOWED} == USUAL | FOLLOWED
    assert {name: answer["envelope"][name] for name in ENVELOPE} == {
        "outer_diameter_mm": 152.0,
        "length_mm": pytest.approx(74.8, rel=EXACT),
        "of": ["housing", "carrier", "second_carrier"],
    }
    typed = changed(
        REDUCER,
        build=None,
        pin={"satellite_positions_mm": [12.0, 34.0], "span_mm": 46.0},
        crankshaft={
            "satellite_positions_mm": [12.0, 34.0],
            "bearing_positions_mm": [-7.2, 53.2],
        },
    )
    typed.pop("build", None)
    other = await api.answer(PATH, typed)
    assert "envelope" not in other and not any("/build" in each for each in assumed(other))
    for section, name in (("pin_strength", "peak_moment_Nm"), ("load_sharing", "peak_force_N")):
        assert answer[section][name] == pytest.approx(other[section][name], rel=SAME)
    for one, two in zip(*(each["crankshaft"]["bearings"] for each in (answer, other)), strict=True):
        assert one == pytest.approx(two, rel=SAME)


async def test_what_is_typed_is_not_assumed(api: Any) -> None:
    body = changed(REDUCER, build={"gap_mm": 3.0}, pin={"span_mm": 50.0}, include=["envelope"])
    answer = await api.answer(PATH, body)
    said = assumed(answer)
    assert not {"/build/gap_mm", "/pin/span_mm"} & {*said}
    assert said["/pin/satellite_positions_mm"] == [13.0, 36.0]
    assert answer["envelope"]["length_mm"] == pytest.approx(50 + 2 * 14.4, rel=EXACT)


@pytest.mark.parametrize("path", ["pin-strength", "crankshaft", "load-sharing"])
async def test_other_views_place_their_parts_too(api: Any, path: str) -> None:
    parts = {
        "load-sharing": ("pin",),
        "pin-strength": ("pin",),
        "crankshaft": ("pin", "crankshaft"),
    }
    answer = await api.answer(path, REDUCER)
    assert "build" not in answer.get("not_used", [])
    said = assumed(answer)
    for part in parts[path]:
        for pointer, value in FOLLOWED.items():
            assert not pointer.startswith(f"/{part}/") or said[pointer] == value


async def test_the_envelope_without_a_section(api: Any) -> None:
    """One plate of 19.2, no bearing: −19.2 to 46; housing 2·1.1·(66 + 2) = 149.6."""
    body: dict[str, Any] = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0},
        "contact": REDUCER["contact"] | {"pin_radius_mm": 8.0},
        "satellite_body": {"outer_radius_mm": 66.0},
        "include": ["envelope"],
    }
    answer = await api.answer(PATH, body)
    assert {name: answer["envelope"][name] for name in ENVELOPE} == {
        "outer_diameter_mm": 150.0,
        "length_mm": pytest.approx(65.2, rel=EXACT),
        "of": ["housing", "carrier", "housing"],
    }
    assert assumed(answer)["/build/carrier_width_mm"] == pytest.approx(19.2, rel=EXACT)
    refused = await api.post(PATH, json=changed(body, satellite_body=None))
    assert refused.status_code == 422
    assert [(each["pointer"], each["code"]) for each in refused.json()["errors"]] == [
        ("/satellite_body/outer_radius_mm", "missing")
    ]


async def test_outer_sizes_are_checked(api: Any) -> None:
    limits = {"max_outer_diameter_mm": 151.0, "max_length_mm": 75.0}
    body = changed(REDUCER, requirements=limits, include=["checks", "fixes"], fixes_for="failed")
    answer = await api.answer(PATH, body)
    checks = {each["code"]: each for each in answer["checks"]}
    assert (checks["outer_diameter"]["status"], checks["outer_diameter"]["value"]) == (
        "fail",
        152.0,
    )
    assert checks["length"]["status"] == "pass"
    for fix in answer["fixes"]:
        if fix["code"] == "outer_diameter":
            await api.reposted(PATH, body, fix)


@pytest.mark.parametrize(
    ("changes", "pointer", "code"),
    [
        ({"build": None}, "/crankshaft/satellite_positions_mm", "missing"),
        ({"build": None, "crankshaft": None}, "/pin/satellite_positions_mm", "missing"),
        (
            {"build": None, "crankshaft": None, "pin__satellite_positions_mm": [12.0, 34.0]},
            "/pin/span_mm",
            "needed_beside",
        ),
        ({"build__housing_diameter_mm": 137.0}, "/build/housing_diameter_mm", "greater_than_equal"),
        ({"build__carrier_diameter_mm": 83.0}, "/build/carrier_diameter_mm", "greater_than_equal"),
        (
            {"pin__support": "cantilever", "build__second_carrier_width_mm": 9.0},
            "/build/second_carrier_width_mm",
            "of_another_kind",
        ),
    ],
)
async def test_what_is_refused(api: Any, changes: dict[str, Any], pointer: str, code: str) -> None:
    body = changed(REDUCER, **changes)
    problem = (await api.post(PATH, json=body)).json()
    assert [(each["pointer"], each["code"]) for each in problem["errors"]] == [(pointer, code)]


BEARINGS: dict[str, Any] = {
    "bearing": {"name": "6004"},
    "crankshaft": {"bearings": [{"name": "6003"}, {"name": "6003"}]},
}


async def test_mass_and_inertia_are_answered_where_they_are_named(api: Any) -> None:
    """Pins 6·π·6²·74.8 mm³ of 7,850 kg/m³; usual sizes are said."""
    body = REDUCER | BEARINGS
    assert "mass" not in await api.answer(PATH, body)
    answer = await api.answer(PATH, body | {"include": ["mass"]})
    found = answer["mass"]
    parts = {each["code"]: each for each in found["parts"]}
    assert found["mass_kg"] == pytest.approx(sum(each["mass_kg"] for each in parts.values()))
    assert parts["pins"] == {
        "code": "pins",
        "count": 6,
        "mass_kg": pytest.approx(0.3984509608563),
        "estimate": True,
    }
    assert found["inertia_kg_m2"] == pytest.approx(5.6e-5, rel=1e-3)
    assert {*USUAL} <= {*assumed(answer)} and "verdict" not in answer
    without = {name: each for name, each in body.items() if name != "build"}
    typed = changed(
        without,
        pin={"satellite_positions_mm": [12.0, 34.0], "span_mm": 46.0},
        crankshaft={
            "satellite_positions_mm": [12.0, 34.0],
            "bearing_positions_mm": [-7.2, 53.2],
        },
        include=["mass"],
    )
    alike = await api.answer(PATH, typed)
    assert alike["mass"]["mass_kg"] == pytest.approx(found["mass_kg"], rel=SAME)
    assert {*USUAL} <= {*assumed(alike)}


async def test_what_the_mass_lacks_is_said(api: Any) -> None:
    body = changed(REDUCER | BEARINGS, contact={"hole_material": "brass"}, include=["mass"])
    body["crankshaft"] = {
        "bearings": [{"name": "6003"}, {"kind": "ball", "outer_diameter_mm": 35.0}]
    }
    found = (await api.answer(PATH, body))["mass"]
    assert "mass_kg" not in found and "inertia_kg_m2" not in found
    lacks = {
        each["code"]: (each["reason"]["code"], each["missing"])
        for each in found["parts"]
        if "reason" in each
    }
    of_discs = ("density_unknown", ["/contact/hole_material"])
    assert lacks == {
        **dict.fromkeys(("discs", "housing", "carrier", "second_carrier"), of_discs),
        "bearing_b": ("bearing_unnamed", ["/crankshaft/bearings/1/name"]),
    }
    assert all("count" not in each for each in found["parts"] if "reason" in each)


async def test_values_beside_a_name_keep_its_density(api: Any) -> None:
    masses = []
    for own in ("steel_c45", {"name": "steel_c45", "yield_strength_MPa": 400.0}):
        body = changed(REDUCER | BEARINGS, contact={"hole_material": own}, include=["mass"])
        masses.append((await api.answer(PATH, body))["mass"]["mass_kg"])
    assert masses[0] == masses[1]
