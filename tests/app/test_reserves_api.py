"""A check's reserve is its own, and none stands beside what cannot exist."""

import copy

import pytest

pytestmark = pytest.mark.anyio

BENT = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 400, "pin_circle_radius_mm": 50},
    "contact": {
        "contact_length_mm": 20,
        "pin_radius_mm": 8,
        "hole_radius_mm": 10.03,
        "eccentricity_mm": 2.0,
        "pin_material": "steel_bearing",
        "hole_material": {
            "youngs_modulus_GPa": 210,
            "poissons_ratio": 0.3,
            "yield_strength_MPa": 345,
            "allowable_pressure_MPa": 2000,
        },
    },
    "pin": {
        "satellite_positions_mm": [15, 40],
        "support": "cantilever",
        "material": "steel_through_hardened",
    },
    "include": ["checks"],
}


def changed(**sections):
    body = copy.deepcopy(BENT)
    for name, fields in sections.items():
        if fields is None:
            del body[name]
        else:
            body[name] = body.get(name, {}) | fields
    return body


DESIGNS = {
    "bent pins with clearance": changed(),
    "bent pins without": changed(contact={"hole_radius_mm": 10.0, "hole_clearance_mm": 0.0}),
    "clearance": changed(pin=None),
    "ideal": changed(pin=None, contact={"hole_radius_mm": 10.0, "hole_clearance_mm": 0.0}),
    "deviations": changed(pin=None, deviations={"pin_tangential_mm": [0.01, 0, 0, -0.01, 0, 0]}),
}


async def answered(api, body):
    answer = await api.post("crank-planetary", json=body)
    assert answer.status_code == 200, answer.text
    return answer.json()


async def checks_of(api, body):
    return {each["code"]: each for each in (await answered(api, body))["checks"]}


@pytest.mark.parametrize("name", DESIGNS)
async def test_at_its_reserve_each_contact_check_is_at_its_limit(api, name):
    body = DESIGNS[name]
    found = await checks_of(api, body)
    solved, first = name != "ideal", (await answered(api, body))["torque_reserve"]
    reserves = {
        code: each["torque_reserve"]
        for code, each in found.items()
        if code.startswith("contact_") and "torque_reserve" in each
    }
    assert {"contact_yield_hole", "contact_shakedown_hole", "contact_pressure_pin"} <= {*reserves}
    for code, reserve in reserves.items():
        there = copy.deepcopy(body)
        there["load"]["output_torque_Nm"] *= reserve
        check = (await checks_of(api, there))[code]
        exact = reserve == first or not solved  # the others are looked at nearby
        assert check["value"] == pytest.approx(check["limit"], rel=1e-4 if exact else 0.05), code
    assert first in reserves.values()


@pytest.mark.parametrize("name", DESIGNS)
async def test_what_is_beyond_its_limit_has_a_reserve_below_1(api, name):
    for code, each in (await checks_of(api, DESIGNS[name])).items():
        if "torque_reserve" in each and each.get("utilisation", 0) > 1:
            assert each["torque_reserve"] < 1, code


@pytest.mark.parametrize(
    "impossible",
    [
        {"contact": {"pin_radius_mm": 26, "hole_radius_mm": 28.03}},  # pins overlap
        {"contact": {"hole_radius_mm": 9.0}},  # too small a hole
        {"deviations": {"disc_phase_deg": [0, 5]}},  # discs out of phase
    ],
)
async def test_no_reserve_beside_what_cannot_exist(api, impossible):
    body = changed(pin=None, **impossible)
    answer = (await api.post("crank-planetary", json=body)).json()
    assert answer["verdict"] == "fail"
    assert not {"torque_reserve", "largest_torque_Nm"} & {*answer}
    assert all("torque_reserve" not in each for each in answer["checks"])
    assert any(each.get("impossible") for each in answer["checks"])


async def test_a_cycloid_that_is_none_is_refused_with_the_number(api):
    body = changed(pin=None, gear={"kind": "cycloid", "ring_pin_circle_radius_mm": 40})
    body |= {"mechanism": {"pins": 4, "satellites": 1, "satellite_teeth": 19, "ring_teeth": 20}}
    (error,) = (await api.post("crank-planetary", json=body)).json()["errors"]
    assert error["code"] == "no_cycloid" and error["params"]["limit"] == pytest.approx(40)
    assert "40" in error["detail"]
