"""Designs that fail, of sizes that people build, as requests: what fixes are tried with."""

import math
import random
from typing import Any

SEED = 20261125

PINS = ("steel_bearing", "steel_case_hardened", "steel_through_hardened")
HOLES = (*PINS, "steel_s355", "bronze_tin_centrifugal")
TENSILE = {"steel_through_hardened": 900.0, "steel_case_hardened": 1200.0, "steel_bearing": 1900.0}
"""Tensile strength of the pins, MPa."""


def failing(count: int, seed: int = SEED) -> list[dict[str, Any]]:
    """Designs whose contact bears less than is asked: by Hertz, of a third of the pins sharing
    alike, 1.3 to 2.5 times what their hole allows. Every second one has a clearance, two of three
    have pins that bend, every third one bearings; one to three satellites in turn.
    """
    draw = random.Random(seed)
    return [_design(draw, index) for index in range(count)]


def _design(draw: random.Random, index: int) -> dict[str, Any]:
    satellites, pins = 1 + index % 3, draw.randint(5, 12)
    circle = draw.uniform(30.0, 80.0)
    pin = round(circle * math.sin(math.pi / pins) * draw.uniform(0.3, 0.45), 1)
    eccentricity = round(draw.uniform(0.1, 0.25) * pin, 2)
    width = round(draw.uniform(1.0, 2.5) * pin, 1)
    ratio = draw.choice([15, 19, 21, 35])
    pin_material, hole_material = draw.choice(PINS), draw.choice(HOLES)
    pressure = {"steel_s355": 350.0, "bronze_tin_centrifugal": 425.0}.get(hole_material, 800.0)
    modulus = 210e3 / 2 / (1 - 0.3**2)
    radius = pin * (pin + eccentricity) / eccentricity
    force = (pressure * draw.uniform(1.3, 2.5)) ** 2 * math.pi * width * radius / modulus
    torque = force * circle * 1e-3 * pins * satellites / 4
    clearance = round(draw.uniform(0.01, 0.05), 3) if index % 2 else 0.0
    body: dict[str, Any] = {
        "mechanism": {"pins": pins, "satellites": satellites, "ratio": ratio},
        "load": {
            "output_torque_Nm": float(f"{torque:.3g}"),
            "pin_circle_radius_mm": round(circle, 1),
            "input_speed_rpm": draw.choice([300.0, 1500.0, 3000.0]),
        },
        "contact": {
            "contact_length_mm": width,
            "pin_radius_mm": pin,
            "eccentricity_mm": eccentricity,
            "hole_clearance_mm": clearance,
            "pin_material": pin_material,
            "hole_material": hole_material,
        },
        "requirements": {"life_h": 5000.0, "min_wall_mm": 1.0},
    }
    places = [round((1.1 * k + 0.6) * width, 2) for k in range(satellites)]
    if index % 3 or index % 2:
        body["pin"] = {"support": "cantilever", "satellite_positions_mm": places}
        if draw.random() < 0.5:
            far = round(places[-1] + places[0], 2)
            body["pin"] |= {"support": draw.choice(["supported", "fixed"]), "span_mm": far}
        material = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3}
        strength = TENSILE[pin_material]
        body["pin"]["material"] = material | {
            "yield_strength_MPa": 0.75 * strength,
            "tensile_strength_MPa": strength,
        }
        body["fatigue"] = {"surface": "ground", "fatigue_notch_factor": 1.5}
    if index % 3 == 2:
        rating = round(torque / (eccentricity * 1e-3 * ratio) / satellites, -2)
        body["gear"] = {"radial_force_ratio": 0.8}
        body["bearing"] = {"kind": "roller", "dynamic_rating_N": 6 * rating}
        body["bearing"]["static_rating_N"] = 6 * rating
    return body
