"""The held cases of load sharing as mechanisms."""

import json
import math
from pathlib import Path
from typing import Any

from core.hertz import ElasticMaterial
from core.output.elasticity import (
    RIGID_PINS,
    ContactLaw,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    Pins,
    PinSupport,
    PowerLaw,
)
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from tests.inputs.real_mechanisms import STEEL

CASES = json.loads((Path(__file__).parent.parent / "oracles/load_sharing_cases.json").read_text())
ARCMIN = math.pi / 180 / 60
UNITS = {"mm": 1e-3, "deg": math.pi / 180}


def _material(given: dict[str, float] | None) -> ElasticMaterial:
    if given is None:  # its pressures are not looked at
        return STEEL
    return ElasticMaterial(
        youngs_modulus=given["youngs_modulus_GPa"] * 1e9, poissons_ratio=given["poissons_ratio"]
    )


def _law(given: dict[str, Any]) -> ContactLaw:
    match given["kind"]:
        case "linear":
            return LinearLaw(given["stiffness_N_per_mm"] * 1e3)
        case "power":
            approach = given["reference_approach_mm"] * 1e-3
            return PowerLaw(given["exponent"], given["reference_force_N"], approach)
        case "palmgren":
            return PalmgrenLaw()
    return HertzLaw()


def _deviations(given: dict[str, list[Any]]) -> Deviations:
    values = {}
    for name, entries in given.items():
        name, unit = name.rsplit("_", 1)
        size = UNITS[unit]
        values[name] = tuple(
            tuple(x * size for x in each) if isinstance(each, list) else each * size
            for each in entries
        )
    return Deviations(**values)


def mechanism(body: dict[str, Any]) -> tuple[RealMechanism, float]:
    """Mechanism of a request, and its torque."""
    sizes, contact, load = body["mechanism"], body["contact"], body["load"]
    spacing = sizes.get("crank_spacing_deg")
    pin: Pins = RIGID_PINS
    if "pin" in body:
        given = body["pin"]
        pin = PinSupport(
            given["support"],
            2e-3 * contact["pin_radius_mm"],
            tuple(z * 1e-3 for z in given["satellite_positions_mm"]),
            _material(given["material"]),
            given["span_mm"] * 1e-3 if "span_mm" in given else None,
        )
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(
            pins=sizes["pins"],
            satellites=sizes["satellites"],
            ratio=sizes["ratio"],
            crank_spacing=None if spacing is None else math.radians(spacing),
        ),
        pin_circle_radius=load["pin_circle_radius_mm"] * 1e-3,
        pin_radius=contact["pin_radius_mm"] * 1e-3,
        eccentricity=contact["eccentricity_mm"] * 1e-3,
        contact_length=contact["contact_length_mm"] * 1e-3,
        law=_law(body["contact_law"]),
        clearance=contact["hole_clearance_mm"] * 1e-3,
        pin_material=_material(contact.get("pin_material")),
        hole_material=_material(contact.get("hole_material")),
        pin=pin,
        deviations=_deviations(body.get("deviations", {})),
        exact="geometry" not in body,
    )
    reverse = load.get("torque_direction") == "reverse"
    return real, load["output_torque_Nm"] * (-1 if reverse else 1)
