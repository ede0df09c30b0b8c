"""Ring mesh and output mechanism in series, as requests say them or drawn by a seed."""

import math
import random
from dataclasses import replace
from typing import Any

import numpy as np

from core.output.elasticity import (
    ContactLaw,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PinSupport,
    PowerLaw,
    SatelliteSupport,
)
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries
from core.ring.sharing import CycloidMesh, RingDeviations
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.ring_meshes import of_request as ring_of

LAWS: list[ContactLaw] = [
    LinearLaw(1e8),
    PowerLaw(1.4, 1000.0, 1e-5),
    PalmgrenLaw(),
    HertzLaw(),
]


def _law(given: dict[str, Any]) -> ContactLaw:
    if given["kind"] == "linear":
        return LinearLaw(given["stiffness_N_per_mm"] * 1e3)
    assert given["kind"] == "power"
    approach = given["reference_approach_mm"] / 1e3
    return PowerLaw(given["exponent"], given["reference_force_N"], approach)


def of_request(body: dict[str, Any]) -> tuple[MeshesInSeries, float, float]:
    """Both meshes of a request, its first crank angle and its torque."""
    own, contact, load = body["mechanism"], body["contact"], body["load"]
    given, errors = body.get("deviations", {}), {}
    of_ring = {name: rows for name, rows in given.items() if not name.startswith(("pin", "hole"))}
    rings = body | {"contact_law": body["gear"]["contact_law"], "deviations": of_ring}
    ring, angle, torque = ring_of(rings | {"satellite_coupling": {}})
    for name, rows in given.items():
        plain, _, unit = name.rpartition("_")
        scale = 1e-3 if unit == "mm" else math.pi / 180
        if not name.startswith("ring"):
            errors[plain] = tuple(
                tuple(scale * x for x in row) if isinstance(row, list) else scale * row
                for row in rows
            )
    output = RealMechanism(
        mechanism=Mechanism.evenly_spaced(
            pins=own["pins"], satellites=own["satellites"], ratio=float(own["satellite_teeth"])
        ),
        pin_circle_radius=load["pin_circle_radius_mm"] / 1e3,
        pin_radius=contact["pin_radius_mm"] / 1e3,
        eccentricity=contact["eccentricity_mm"] / 1e3,
        contact_length=contact["contact_length_mm"] / 1e3,
        clearance=contact["hole_clearance_mm"] / 1e3,
        law=_law(body["contact_law"]),
        pin_material=STEEL,
        hole_material=STEEL,
        deviations=Deviations(**errors),
        exact="geometry" not in body,
    )
    return MeshesInSeries(ring, output), angle, torque


def drawn(seed: int, **changes: Any) -> tuple[MeshesInSeries, float, float]:
    """Both meshes with errors of every kind, a crank angle, and a torque that they bear."""
    r = random.Random(seed)
    lobes, count, pins = r.randint(6, 24), r.randint(1, 3), r.randint(4, 8)
    radius = r.uniform(0.03, 0.1)
    e = r.uniform(0.4, 0.8) * radius / (lobes + 1)
    size = radius * 5e-5

    def row(n: int, most: float) -> tuple[float, ...]:
        return tuple(r.uniform(-most, most) for _ in range(n))

    change = Modification(r.uniform(1, 3) * size, r.uniform(-1, 0.2) * size)
    sharp = CycloidDisc(lobes, e, radius, radius * 1e-3).min_path_radius
    pin = min(0.6 * sharp, 0.8 * radius * math.sin(math.pi / (lobes + 1)))
    both = {
        "eccentricity": row(count, size / 4),
        "crank_phase": row(count, 3e-4),
        "disc_phase": row(count, 3e-5),
    }
    exact = changes.pop("exact", True)
    given: dict[str, Any] = {
        "crank_angles": tuple(2 * math.pi * j / count for j in range(count)),
        "contact_length": 0.25 * radius,
    }
    ring = CycloidMesh(
        disc=CycloidDisc(lobes, e, radius, pin, change),
        law=LAWS[seed % 4],
        pin_material=STEEL,
        disc_material=STEEL,
        deviations=RingDeviations(
            row(lobes + 1, size / 2), row(lobes + 1, size / 2), row(lobes + 1, size / 4), **both
        ),
        exact=exact,
        **given,
    )
    holes = [tuple(row(pins, size / 4) for _ in range(count)) for _ in range(3)]
    angles = given["crank_angles"]
    output = RealMechanism(
        mechanism=Mechanism(pins, angles, float(lobes), r.uniform(0, 6)),
        pin_circle_radius=0.55 * radius,
        pin_radius=0.08 * radius,
        eccentricity=e,
        contact_length=0.25 * radius,
        law=LAWS[seed // 4 % 4],
        clearance=r.uniform(0.5, 2) * size,
        pin_material=STEEL,
        hole_material=STEEL,
        deviations=Deviations(*(row(pins, size / 4) for _ in range(3)), *holes, **both),
        exact=exact,
    )
    torque = r.choice((1, -1)) * 10 ** r.uniform(0.5, 2.3) * count * (radius / 0.05) ** 3
    series = MeshesInSeries(
        replace(ring, **changes.pop("ring", {})), replace(output, **changes.pop("output", {}))
    )
    return series, r.uniform(0, 20), torque


Supported = tuple[RealMechanism, CycloidMesh, float, float]


def supported(seed: int, support: SatelliteSupport, pins: str = "") -> Supported:
    """Output and ring with errors of every kind, linear contacts, and pins that bend, by their
    support or by their joint to a tie ring.
    """
    both, angle, torque = drawn(4 * seed)
    r = np.random.default_rng(seed)
    output = replace(both.output, law=LinearLaw(10 ** r.uniform(7.5, 9)), support=support)
    if pins:
        places = tuple(0.012 + 0.014 * j for j in range(output.mechanism.satellites))
        sizes: tuple[Any, ...] = 1.9 * output.pin_radius, places, STEEL, places[-1] + 0.011
        tied = pins in ("pinned", "clamped")
        pin = PinSupport("tie_ring", *sizes, ring_joint=pins) if tied else PinSupport(pins, *sizes)  # type: ignore[arg-type]
        output = replace(output, contact_length=0.01, pin=pin)
    ring = replace(both.ring, law=LinearLaw(10 ** r.uniform(8, 9)))
    return output, ring, angle, torque
