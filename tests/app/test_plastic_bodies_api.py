"""Random bodies of plastic over REST: of their contacts nothing passes but by an own limit."""

from random import Random
from typing import Any

import pytest

from core.material_table import MATERIALS
from tests.oracles.seeds import seeds

pytestmark = pytest.mark.anyio

OF_CONTACT = ("contact_", "temperature", "creep", "fatigue_plastic")
OWN_LIMIT = "allowable_pressure_MPa"

NAMES = [
    name
    for name, each in MATERIALS.items()
    if each.group.startswith("plastic") and not each.missing
]


def plastic(r: Random) -> Any:
    """By name or by values, at times with a strength, at times with a limit of an own test."""
    if r.random() < 0.3:
        return r.choice(NAMES)
    own: dict[str, Any] = {
        "youngs_modulus_GPa": round(r.uniform(0.5, 19), 2),
        "poissons_ratio": round(r.uniform(0.3, 0.45), 2),
    }
    if r.random() < 0.5:
        own["yield_strength_MPa"] = round(r.uniform(5, 200), 1)
    if r.random() < 0.3:
        own[OWN_LIMIT] = round(10 ** r.uniform(0, 4), 1)
    return own


def drawn(r: Random) -> dict[str, Any]:
    """A drive with a plastic hole, pin or both, as people type them."""
    pin, eccentricity = round(r.uniform(1, 8), 2), round(r.uniform(0.3, 3), 2)
    bodies = r.choice([("hole",), ("pin",), ("pin", "hole")])
    contact: dict[str, Any] = {
        f"{body}_material": plastic(r) if body in bodies else "steel_bearing"
        for body in ("pin", "hole")
    }
    contact |= {
        "pin_radius_mm": pin,
        "eccentricity_mm": eccentricity,
        "contact_length_mm": round(r.uniform(3, 20), 1),
    }
    if r.random() < 0.8:
        contact["hole_clearance_mm"] = r.choice([0, 0.05, 0.1, 0.25])
    else:
        contact["hole_radius_mm"] = round(pin + eccentricity, 2)
    body: dict[str, Any] = {
        "mechanism": {"pins": r.randint(4, 8), "satellites": r.randint(1, 2), "ratio": 20},
        "load": {
            "output_torque_Nm": round(10 ** r.uniform(-2, 1.5), 4),
            "pin_circle_radius_mm": round(r.uniform(20, 60), 1),
        },
        "contact": contact,
        "include": ["checks"],
    }
    if r.random() < 0.5:
        body["friction"] = {"coefficient": round(r.uniform(0, 1), 2)}
    if r.random() < 0.3:
        body["requirements"] = {"scope": ["contact"]}
    return body


@pytest.mark.parametrize("seed", seeds(8))
async def test_no_check_of_a_plastic_contact_passes_but_by_an_own_limit(
    api: Any, seed: int
) -> None:
    body = drawn(Random(seed))
    response = await api.post("crank-planetary", json=body)
    assert response.status_code == 200, response.text
    answer = response.json()
    contact = body["contact"]
    materials = {name: contact[f"{name}_material"] for name in ("pin", "hole")}
    soft = {name for name, each in materials.items() if each != "steel_bearing"}
    limited = {name for name in soft if OWN_LIMIT in materials[name]}
    passing = {
        check["code"]
        for check in answer["checks"]
        if check["status"] in ("pass", "marginal")
        and check["code"].startswith(OF_CONTACT)
        and check["code"].rpartition("_")[2] not in {"pin", "hole"} - soft
    }
    assert passing <= {f"contact_pressure_{name}" for name in limited}, (passing, body)
    (part,) = (each for each in answer["parts"] if each["code"] == "contact")
    assert part["status"] in ("open", "fail")
    assert answer["verdict"] in ("incomplete", "fail")
    assert "largest_torque_Nm" not in answer
