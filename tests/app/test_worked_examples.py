"""The answers that the worked steps are tested against, in static tests without the service."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from app.examples import EXAMPLES

pytestmark = pytest.mark.anyio

FILE = Path(__file__).parent.parent / "static" / "worked_examples.json"
PATHS = {
    "crank-planetary": "crank-planetary",
    "roller-strength": "rollers",
    "precession/shaft-deflection": "precession",
}
GEAR = ("roller_circle_radius_mm", "roller_radius_mm", "nutation_angle_deg", "ratio_u12")
STEEL = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3, "allowable_pressure_MPa": 900.0}

PIN_STEEL = STEEL | {"yield_strength_MPa": 800.0, "tensile_strength_MPa": 1000.0}
BARE: dict[str, Any] = {
    "strength": {"on": "on", "surface": "bare"},
    "pin": {
        "support": "cantilever",
        "satellite_positions_mm": [15.0, 37.0],
        "rotates": False,
        "material": PIN_STEEL,
    },
    "fatigue": {
        "surface": "machined",
        "notch": {"theoretical_factor": 2.0, "radius_mm": 0.5},
        "reliability_percent": 99.0,
    },
    "losses": {"on": "on"},
    "friction": {"coefficient": 0.08, "wear_rate_mm3_per_Nm": 1e-8},
    "bearings": {"on": "on"},
    "gear": {"kind": "involute", "module_mm": 3.5, "teeth_difference": 1},
    "bearing": {
        "kind": "roller",
        "dynamic_rating_N": 60000.0,
        "static_rating_N": 40000.0,
        "reliability_percent": 95.0,
        "weibull_slope": 1.1,
    },
    "crank": {"on": "on"},
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
        "satellite_mass_kg": 1.5,
        "bearings": [
            {"kind": "ball", "dynamic_rating_N": 30000.0},
            {"kind": "roller", "dynamic_rating_N": 20000.0},
        ],
    },
}
SLEEVED: dict[str, Any] = BARE | {
    "strength": {"on": "on", "surface": "sleeved"},
    "pin": BARE["pin"] | {"support": "supported", "span_mm": 52.0, "diameter_mm": 11.0},
    "fatigue": {"endurance_limit_MPa": 300.0, "criterion": "soderberg"},
    "gear": {"kind": "cycloid", "ring_pin_circle_radius_mm": 60.0},
    "bearing": {"kind": "ball"},
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
    },
}
BUILT_IN: dict[str, Any] = SLEEVED | {
    "pin": BARE["pin"]
    | {
        "support": "fixed",
        "satellite_positions_mm": [12.0, 34.0, 56.0],
        "span_mm": 70.0,
        "diameter_mm": 12.0,
    },
    "bearing": BARE["bearing"] | {"kind": "ball", "ring_factor": 1.2},
    "crankshaft": BARE["crankshaft"] | {"satellite_positions_mm": [20.0, 42.0, 64.0]},
}
REVERSING: dict[str, Any] = BARE | {"gear": {"radial_force_ratio": 0.4}}
MACHINED = BARE["fatigue"]
TENSILE = {"tensile_strength_MPa": 950.0}
STEPPED = [{"length_mm": 50.0, "diameter_mm": 12.0}, {"length_mm": 30.0, "diameter_mm": 16.0}]
SECTIONS = {
    "pin": "pin_strength",
    "friction": "output_efficiency",
    "bearing": "satellite_bearing",
    "crankshaft": "crankshaft",
}

MORE: list[dict[str, Any]] = [
    {
        "calculation": "crank-planetary",
        "input": {
            "mechanism": {
                "pins": 5,
                "satellites": 2,
                "satellite_teeth": 41,
                "ring_teeth": 43,
                "crank_angles_deg": [0.0, 170.0],
                "initial_crank_angle_deg": 33.0,
            },
            "load": {
                "input_torque_Nm": 25.0,
                "efficiency": 0.9,
                "pin_circle_radius_mm": 40.0,
                "force_exponent": 1.5,
            },
            "contact": {
                "contact_length_mm": 10.0,
                "pin_radius_mm": 5.0,
                "hole_radius_mm": 5.02,
                "eccentricity_mm": 0.02,
                "pin_material": STEEL,
                "hole_material": STEEL,
                "dynamic_factor": 1.2,
            },
        },
    },
    {
        "calculation": "crank-planetary",
        "input": {
            "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
            "load": {"output_torque_Nm": 200.0, "pin_circle_radius_mm": 40.0},
            "contact": {
                "contact_length_mm": 12.0,
                "pin_radius_mm": 5.0,
                "hole_radius_mm": 7.03,
                "eccentricity_mm": 2.0,
                "dynamic_factor": 1.25,
            },
        },
    },
    {
        "calculation": "crank-planetary",
        "input": {
            "mechanism": {"pins": 7, "satellites": 3, "ratio": 9.5},
            "load": {
                "output_torque_Nm": 80.0,
                "pin_circle_radius_mm": 44.0,
                "force_exponent": 0.0,
            },
            "contact": {
                "contact_length_mm": 12.0,
                "pin_radius_mm": 5.0,
                "eccentricity_mm": 1.25,
                "hole_radius_mm": 6.25,
            },
        },
    },
    *(
        {
            "calculation": "crank-planetary",
            "input": {
                "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
                "load": {
                    "output_torque_Nm": 500.0,
                    "pin_circle_radius_mm": 50.0,
                    "input_speed_rpm": 1500.0,
                    **({"peak_torque_Nm": 900.0} if besides is SLEEVED else {}),
                },
                "contact": {
                    "contact_length_mm": 20.0,
                    "pin_radius_mm": 8.0,
                    "eccentricity_mm": 2.0,
                    "hole_radius_mm": 10.0,
                    "dynamic_factor": 1.25,
                },
                "requirements": {"life_h": hours},
                "besides": besides,
            },
        }
        for besides, hours in ((BARE, 4000.0), (SLEEVED, 4000.0), (BARE, 5.0))
    ),
    *(
        {
            "calculation": "crank-planetary",
            "input": {
                "mechanism": {"pins": 5, "ratio": 20.0} | turned,
                "load": {
                    "output_torque_Nm": 300.0,
                    "pin_circle_radius_mm": 50.0,
                    "input_speed_rpm": 1500.0,
                    "torque_direction": direction,
                    "force_exponent": exponent,
                },
                "contact": {
                    "contact_length_mm": 20.0,
                    "pin_radius_mm": 8.0,
                    "eccentricity_mm": 2.0,
                    "hole_radius_mm": 10.0,
                },
                "requirements": {"life_h": 4000.0},
                "besides": besides,
            },
        }
        for besides, direction, exponent, turned in (
            (BUILT_IN, "reverse", 1.0, {"satellites": 3}),
            (REVERSING, "alternating", 1.5, {"satellites": 2, "crank_angles_deg": [0.0, 100.0]}),
        )
    ),
    *(
        {
            "calculation": "roller-strength",
            "input": {
                "output_torque_Nm": 150.0,
                "hole_circle_radius_mm": 28.0,
                "rollers": 5,
                "gaps_mm": [0.01, 0.0, 0.2, 0.015, 0.004],
                "diameter_mm": 9.0,
                "cylinder_length_mm": 16.0,
                "sphere_width_mm": 7.0,
                "sphere_diameter_mm": 12.0,
                "friction_coefficient": 0.12,
                "youngs_modulus_GPa": 206.0,
                "poissons_ratio": 0.29,
                "yield_strength_MPa": 700.0,
            }
            | own,
        }
        for own in (
            {"stress_concentration": 1.7},
            {
                "stress_concentration": 1.7,
                "besides": {"fatigue": {"endurance_limit_MPa": 320.0}} | TENSILE,
            },
            {"besides": {"fatigue": MACHINED, "roller_rotates": True} | TENSILE},
        )
    ),
    *(
        {
            "calculation": "precession/shaft-deflection",
            "input": {
                "roller_circle_radius_mm": 60.0,
                "roller_radius_mm": 5.0,
                "nutation_angle_deg": 5.0,
                "ratio_u12": 0.95,
                "torque_Nm": -12.0,
                "reference_z_mm": 25.0,
                "bearing_distance_mm": 35.0,
                "overhang_mm": 45.0,
                "youngs_modulus_GPa": 200.0,
                "rollers": [
                    {"position_angle_deg": 40.0, "phi_min_deg": -70.0, "phi_max_deg": -55.0},
                    {"position_angle_deg": 75.0, "z_min_mm": 12.0, "z_max_mm": 30.0},
                ],
            }
            | own,
        }
        for own in (
            {"shaft_sections": STEPPED},
            {
                "shaft_sections": STEPPED,
                "yield_strength_MPa": 600.0,
                "besides": {"fatigue": MACHINED} | TENSILE,
            },
            {
                "shaft_diameter_mm": 16.0,
                "yield_strength_MPa": 600.0,
                "besides": {
                    "line_contact": {
                        "mating_radius_mm": -40.0,
                        "roller_material": STEEL,
                        "mating_material": STEEL
                        | {"youngs_modulus_GPa": 118.0, "poissons_ratio": 0.34},
                    },
                },
            },
        )
    ),
]


async def _answer(api: Any, calculation: str, given: dict[str, Any]) -> dict[str, Any]:
    """What the page asks of the service for these inputs."""

    async def post(path: str, body: dict[str, Any]) -> dict[str, Any]:
        reply = await api.post(path, json=body)
        assert reply.status_code == 200, reply.text
        answer: dict[str, Any] = reply.json()
        return answer

    if calculation == "crank-planetary":
        sections = ["cyclogram", "contact_force", "hertz"]
        if "eccentricity_mm" in given["contact"]:
            sections.append("geometry")
            contact = given["contact"]
            play = contact["hole_radius_mm"] - contact["pin_radius_mm"]
            if play - contact["eccentricity_mm"] > 1e-9:
                sections.append("load_sharing")
        besides = given.get("besides", {})
        sections += [section for part, section in SECTIONS.items() if part in besides]
        parts = {name: besides[name] for name in ("fatigue", "gear", *SECTIONS) if name in besides}
        if besides:
            sleeved = besides["strength"]["surface"] == "sleeved"
            parts["friction"] = besides["friction"] | {"sleeve": sleeved}
        own = {name: part for name, part in given.items() if name != "besides"}
        load = given["load"] | {"include": ["equal_sharing", "approximation"]}
        body = own | parts | {"load": load, "include": sections}
        answer = {name: part for name, part in (await post(calculation, body)).items() if part}
        if "load_sharing" in answer:  # whose errors are estimates, not the same on all machines
            answer["load_sharing"] = {
                name: answer["load_sharing"][name] for name in ("judged_force_N", "peak_force_N")
            }
            del answer["hertz"]["accuracy"]
        return answer
    whole = {name: part for name, part in given.items() if name != "besides"}
    whole |= given.get("besides", {})
    if calculation == "roller-strength":
        return {"roller_strength": await post(calculation, whole)}
    gear = {name: given[name] for name in GEAR} | {
        name: given[name] for name in ("rollers", "wheel") if name in given
    }
    sign = math.copysign(1, given["torque_Nm"])
    load = gear | {name: given[name] for name in ("torque_Nm", "reference_z_mm")}
    return {
        "contact_line": await post("precession/contact-line", gear | {"torque_sign": int(sign)}),
        "meshing_load": await post("precession/meshing-load", load),
        "shaft_deflection": await post(calculation, whole),
    }


def _without_times(part: Any) -> Any:
    """An answer without what differs from run to run and what no worked step reads."""
    if isinstance(part, dict):
        left = ("run_time_us", "pairs", "pins", "driving_count")
        return {name: _without_times(one) for name, one in part.items() if name not in left}
    return [_without_times(one) for one in part] if isinstance(part, list) else part


def _same(found: Any, kept: Any) -> bool:
    if isinstance(found, dict) and isinstance(kept, dict):
        return found.keys() == kept.keys() and all(_same(found[key], kept[key]) for key in found)
    if isinstance(found, list) and isinstance(kept, list):
        return len(found) == len(kept) and all(map(_same, found, kept))
    if isinstance(found, float) and isinstance(kept, float | int):
        return math.isclose(found, kept, rel_tol=1e-9, abs_tol=1e-12)
    return bool(found == kept)


async def test_the_kept_answers_are_the_services(api: Any, tmp_path: Path) -> None:
    """The static tests evaluate every worked step against these."""
    cases = []
    for example in [*EXAMPLES, *MORE]:
        answer = await _answer(api, example["calculation"], example["input"])
        cases.append(
            {
                "calculator": PATHS[example["calculation"]],
                "input": example["input"],
                "answer": _without_times(answer),
            }
        )
    materials = (await api.get("materials")).json()["materials"]
    found = {"materials": materials, "cases": cases}
    made = tmp_path / FILE.name
    made.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    kept = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else None
    assert _same(json.loads(made.read_text(encoding="utf-8")), kept), f"put {made} to {FILE}"
