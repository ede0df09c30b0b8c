"""Cycloid meshes, drawn by a seed or as requests say them."""

import math
import random
from typing import Any

from core.hertz import ElasticMaterial
from core.output.elasticity import (
    RIGID_SUPPORT,
    ContactLaw,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PowerLaw,
    Shares,
)
from core.ring.profile import CycloidDisc, Modification
from core.ring.sharing import CycloidMesh, RingDeviations
from tests.inputs.real_mechanisms import STEEL

ARCMIN = math.pi / 180 / 60

LAWS: list[ContactLaw] = [
    LinearLaw(1e8),
    PowerLaw(1.5, 1000.0, 1e-5),
    PalmgrenLaw(),
    HertzLaw(),
]


def disc_of(r: random.Random, *, kind: int = 0, modified: bool = True) -> CycloidDisc:
    """A disc: of few pins, with a large shortening coefficient, nearly undercut, or any."""
    lobes = r.randint(4, 11) if kind == 1 else r.randint(8, 40)
    k = r.uniform(0.9, 0.95) if kind == 2 else r.uniform(0.35, 0.85)
    radius = r.uniform(0.03, 0.1)
    e = k * radius / (lobes + 1)
    plain = CycloidDisc(lobes, e, radius, radius * 1e-3)
    size = min(radius * 1e-4, 0.05 * plain.valley_radius)  # in valleys nothing is lost
    change = Modification(r.uniform(0.5, 3) * size, r.uniform(-1, 0.2) * size)
    if not modified:
        change = Modification()
    sharp = plain.min_path_radius
    room = radius * math.sin(math.pi / (lobes + 1))
    margin = r.uniform(1.005, 1.05) if kind == 3 else r.uniform(1.2, 3)
    pin = min(sharp / margin - change.equidistant - size, 0.9 * room)
    return CycloidDisc(lobes, e, radius, pin, change)


def drawn(seed: int, **changes: Any) -> tuple[CycloidMesh, float, float]:
    """A mesh, a crank angle, and a torque that its contacts bear."""
    r = random.Random(seed)
    disc = disc_of(r, kind=seed % 4)
    count, pins = r.randint(1, 4), disc.pins
    size = min(disc.ring_pin_circle_radius * 5e-5, 0.05 * disc.valley_radius)

    def row(n: int, most: float) -> tuple[float, ...]:
        return tuple(r.uniform(-most, most) for _ in range(n))

    deviations = RingDeviations(
        row(pins, size),
        row(pins, size),
        row(pins, size / 4),
        row(count, size / 4),
        row(count, 3e-4),
        row(count, 3e-5),
    )
    given: dict[str, Any] = {
        "disc": disc,
        "crank_angles": tuple(2 * math.pi * j / count for j in range(count)),
        "contact_length": 0.25 * disc.ring_pin_circle_radius,
        "law": LAWS[seed // 4 % 4],
        "pin_material": STEEL,
        "disc_material": STEEL,
        "deviations": deviations,
        "exact": True,
    }
    torque = (
        r.choice((1, -1))
        * 10 ** r.uniform(0, 2.5)
        * count
        * (disc.ring_pin_circle_radius / 0.05) ** 3
    )
    return CycloidMesh(**given | changes), r.uniform(0, 2 * math.pi), torque


def of_request(body: dict[str, Any]) -> tuple[CycloidMesh, float, float]:
    """The mesh of a request, its first crank angle and its torque."""
    gear, count = body["gear"], body["mechanism"]["satellites"]
    own = {name: value / 1e3 for name, value in gear.get("modification", {}).items()}
    law, kind = gear["contact_law"], gear["contact_law"]["kind"]
    laws: dict[str, Any] = {
        "linear": lambda: LinearLaw(law["stiffness_N_per_mm"] * 1e3),
        "power": lambda: PowerLaw(
            law["exponent"], law["reference_force_N"], law["reference_approach_mm"] / 1e3
        ),
        "palmgren": PalmgrenLaw,
        "hertz": HertzLaw,
    }
    materials = [
        ElasticMaterial(each["youngs_modulus_GPa"] * 1e9, each["poissons_ratio"])
        for each in (gear["pin_material"], gear["disc_material"])
    ]
    deviations = {}
    for name, values in body.get("deviations", {}).items():
        plain, _, unit = name.rpartition("_")
        scale = 1e-3 if unit == "mm" else math.pi / 180
        deviations[plain.removeprefix("ring_")] = tuple(scale * value for value in values)
    shares = body.get("satellite_coupling", {}).get("shares")
    mesh = CycloidMesh(
        disc=CycloidDisc(
            body["mechanism"]["satellite_teeth"],
            body["contact"]["eccentricity_mm"] / 1e3,
            gear["ring_pin_circle_radius_mm"] / 1e3,
            gear["ring_pin_radius_mm"] / 1e3,
            Modification(own.get("equidistant_mm", 0.0), own.get("pin_circle_mm", 0.0)),
        ),
        crank_angles=tuple(2 * math.pi * j / count for j in range(count)),
        contact_length=gear["contact_length_mm"] / 1e3,
        law=laws[kind](),
        pin_material=materials[0],
        disc_material=materials[1],
        deviations=RingDeviations(**deviations),
        exact="geometry" not in body,
        support=Shares(tuple(shares)) if shares else RIGID_SUPPORT,
    )
    way = -1 if body["load"].get("torque_direction") == "reverse" else 1
    angle = math.radians(body["crank_angle_deg"][0])
    return mesh, angle, way * body["load"]["output_torque_Nm"]
