"""The law of contact over REST, by the materials where none is named, and pressures as judged."""

from typing import Any

import pytest

from app.examples import REQUESTS
from core.precision import EXACT, SAME

pytestmark = pytest.mark.anyio

PLA = {"youngs_modulus_GPa": 3.5, "poissons_ratio": 0.36}
BASE: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 15},
    "load": {"output_torque_Nm": 30, "pin_circle_radius_mm": 25},
    "contact": {
        "pin_radius_mm": 4,
        "eccentricity_mm": 1.5,
        "hole_clearance_mm": 0.1,
        "contact_length_mm": 8,
        "pin_material": "steel_bearing",
        "hole_material": PLA,
    },
}
WRAPS = {"eccentricity_mm": 0.08, "hole_clearance_mm": 0.02}


def body(material: Any = PLA, law: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
    """A design, the material of its holes and its law of contact."""
    contact = BASE["contact"] | {"hole_material": material} | more.pop("contact", {})
    given = {} if law is None else {"contact_law": law}
    return BASE | {"contact": contact} | given | more


async def forces(api: Any, **given: Any) -> Any:
    answer = await api.answer("load-sharing", body(**given))
    return answer["positions"][0]["force_N"]


@pytest.mark.parametrize(
    ("material", "usual"),
    [
        (PLA, "conformal"),
        ("plastic_pom", "conformal"),
        (PLA | {"youngs_modulus_GPa": 19.999}, "conformal"),
        (PLA | {"youngs_modulus_GPa": 20}, "hertz"),
        ("aluminium_6082_t6", "hertz"),
        ("steel_bearing", "hertz"),
    ],
)
async def test_the_law_is_that_of_the_materials_where_none_is_named(
    api: Any, material: Any, usual: str
) -> None:
    other = "hertz" if usual == "conformal" else "conformal"
    absent = await forces(api, material=material)
    assert absent == await forces(api, material=material, law={})
    assert absent == await forces(api, material=material, law={"kind": usual})
    assert absent != await forces(api, material=material, law={"kind": other})
    turned = body(material=BASE["contact"]["pin_material"], contact={"pin_material": material})
    answer = await api.answer("load-sharing", turned)
    named = await api.answer("load-sharing", turned | {"contact_law": {"kind": usual}})
    assert answer["positions"][0]["force_N"] == named["positions"][0]["force_N"]


async def test_a_reference_depth_alone_is_one_of_hertz(api: Any) -> None:
    depth = {"reference_depth_mm": 4}
    assert await forces(api, law=depth) == await forces(api, law=depth | {"kind": "hertz"})


@pytest.mark.parametrize("contact", [{}, WRAPS])
@pytest.mark.parametrize("law", [None, {"kind": "linear", "stiffness_N_per_mm": 3000}])
async def test_forces_and_pressures_are_those_of_the_whole_design(
    api: Any, contact: dict[str, Any], law: dict[str, Any] | None
) -> None:
    """Over the turn, at a position, of one piece without tolerances, and as it is judged."""
    given = body(contact=contact, law=law)
    asked = {"include": ["over_turn", "positions", "pressure"], "crank_angle_deg": [0.0]}
    sharing = await api.answer("load-sharing", given | asked)
    turn, (position,) = sharing["over_turn"], sharing["positions"]
    whole = await api.answer("crank-planetary", given | {"include": ["load_sharing", "hertz"]})
    assert whole["load_sharing"]["peak_force_N"] == pytest.approx(turn["peak_force_N"], rel=SAME)
    judged = whole["hertz"].get("conformal_pressure_MPa", whole["hertz"]["max_pressure_MPa"])
    assert turn["max_pressure_MPa"] == pytest.approx(judged, rel=EXACT)
    assert ("conformal_pressure_MPa" in whole["hertz"]) == (contact == WRAPS)
    pressures = [each for row in position["pressure_MPa"] for each in row]
    assert position["max_pressure_MPa"] == pytest.approx(max(pressures), rel=SAME)
    study = await api.answer(
        "tolerance-study",
        given
        | {
            "tolerances": {"pin_position_mm": 1e-9},
            "quantities": ["max_pressure_MPa", "peak_force_N"],
            "samples": 40,
            "crank_angles": 720,
            "percentiles": [50],
        },
    )
    for name in ("max_pressure_MPa", "peak_force_N"):
        nominal = study["quantities"][name]["nominal"]
        assert nominal == pytest.approx(turn[name], rel=5e-3)  # at some positions
        assert nominal <= turn[name] * (1 + 1e-6)


async def test_a_wide_contact_of_metals_has_the_pressure_that_is_judged(api: Any) -> None:
    """Forces keep their values; the pressure was Hertz's before."""
    metal = body(material="steel_bearing", contact=WRAPS, load=BASE["load"] | {
        "output_torque_Nm": 2000
    })  # fmt: skip
    turn = (await api.answer("load-sharing", metal | {"include": ["over_turn"]}))["over_turn"]
    contact = await api.answer(
        "hertz",
        {
            "force_N": turn["peak_force_N"],
            "pin_radius_mm": 4,
            "hole_radius_mm": 4.1,
            "contact_length_mm": 8,
            "pin_material": "steel_bearing",
            "hole_material": "steel_bearing",
        },
    )
    assert contact["conformal_pressure_MPa"] > 1.01 * contact["max_pressure_MPa"]
    assert turn["max_pressure_MPa"] == pytest.approx(contact["conformal_pressure_MPa"], rel=EXACT)


async def test_a_pressure_that_is_not_known_is_left_out_and_said(api: Any) -> None:
    soft = body(
        law={"kind": "linear", "stiffness_N_per_mm": 1e7},
        contact=WRAPS | {"pin_material": PLA, "hole_material": "steel_bearing"},
        load={"output_torque_Nm": 3e5, "pin_circle_radius_mm": 500},
        include=["positions", "over_turn", "pressure"],
    )
    answer = await api.answer("load-sharing", soft)
    for part in (answer["over_turn"], answer["positions"][0]):
        assert not {"max_pressure_MPa", "pressure_MPa"} & {*part}
    assert "contact_wraps" in {each["code"] for each in answer["warnings"]}


async def test_the_page_is_told_that_no_law_need_be_named(api: Any) -> None:
    schema = (await api.get("openapi.json")).json()["components"]["schemas"]["ContactLawFields"]
    kind = schema["properties"]["kind"]
    assert "default" not in kind and "conformal" in str(kind)
    assert REQUESTS["load-sharing"]


async def test_a_law_without_a_contact_is_no_error_of_the_program(api: Any) -> None:
    given = {name: BASE[name] for name in ("mechanism", "load")} | {"contact_law": {}}
    response = await api.post("crank-planetary", json=given)
    assert response.status_code in (200, 422), response.text
