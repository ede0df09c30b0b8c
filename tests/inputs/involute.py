"""Involute teeth of satellite and ring: held cases, and random ones."""

import json
import math
import random
from pathlib import Path
from typing import Any

from core.ring.involute import Cutter, InvoluteTeeth, Rack, usual_rack
from tests.oracles.involute import Pair

CASES = json.loads((Path(__file__).parent / "involute_cases.json").read_text())
"""Held pairs, in millimetres, degrees, newtons: request, numbers of the answer, positions."""


def given(case: dict[str, Any]) -> tuple[InvoluteTeeth, float | None]:
    """Teeth and eccentricity of a held case, in metres."""
    body, gear = case["body"], case["body"]["gear"]
    rack = Rack(
        math.radians(gear.get("reference_pressure_angle_deg", 20)),
        gear.get("dedendum", 1.25),
        gear.get("rack_tip_radius", 0.38),
    )
    eccentricity = body.get("contact", {}).get("eccentricity_mm")
    teeth = InvoluteTeeth(
        satellite_teeth=body["mechanism"]["satellite_teeth"],
        ring_teeth=body["mechanism"]["ring_teeth"],
        module=gear["module_mm"] / 1e3,
        satellite_profile_shift=gear["satellite_profile_shift"],
        ring_profile_shift=gear["ring_profile_shift"],
        satellite_addendum=gear["satellite_addendum"],
        ring_addendum=gear["ring_addendum"],
        rack=rack,
        cutter=Cutter(gear["cutter_teeth"]) if "cutter_teeth" in gear else None,
    )
    return teeth, None if eccentricity is None else eccentricity / 1e3


def drawn(seed: int) -> tuple[InvoluteTeeth, float | None]:
    """Random teeth that have a path of contact, of one to eight teeth of difference, and an
    eccentricity that leaves backlash, or none.
    """
    rng = random.Random(seed)
    while True:
        difference, z_s = rng.choice((1, 1, 1, 2, 2, 3, 4, 6, 8)), rng.randint(12, 130)
        alpha = math.radians(rng.choice((14.5, 20.0, 20.0, 22.5, 25.0, 30.0)))
        working = math.radians(rng.uniform(math.degrees(alpha), 62))
        wider = math.tan(working) - working - math.tan(alpha) + alpha
        x_s = rng.uniform(-0.5, 1.0)
        teeth = InvoluteTeeth(
            satellite_teeth=z_s,
            ring_teeth=z_s + difference,
            module=1e-3 * rng.uniform(0.3, 12),
            satellite_profile_shift=x_s,
            ring_profile_shift=x_s + difference * wider / (2 * math.tan(alpha)),
            satellite_addendum=rng.uniform(0.3, 1.2),
            ring_addendum=rng.uniform(0.3, 1.2),
            rack=usual_rack(pressure_angle=alpha),
            cutter=Cutter(z_s // 2) if z_s > 40 and rng.random() < 0.5 else None,
        )
        least = teeth.module * difference * math.cos(alpha) / 2
        without = least / math.cos(working)
        if teeth.ring_tip > least * teeth.ring_teeth / difference * 1.001:
            close = rng.uniform(max(0.97, 1.001 * least / without), 1.0)
            return teeth, None if rng.random() < 0.4 else close * without


def as_pair(teeth: InvoluteTeeth, eccentricity: float | None) -> Pair:
    """Pair of teeth for the oracle."""
    return Pair(
        z_s=teeth.satellite_teeth,
        z_r=teeth.ring_teeth,
        m=teeth.module,
        x_s=teeth.satellite_profile_shift,
        x_r=teeth.ring_profile_shift,
        h_as=teeth.satellite_addendum,
        h_ar=teeth.ring_addendum,
        alpha=teeth.rack.pressure_angle,
        h_f=teeth.rack.dedendum,
        rho_f=teeth.rack.tip_radius,
        e=eccentricity,
        cutter=None if teeth.cutter is None else teeth.cutter.teeth,
    )
