"""A cycloid disc on the pins of its ring at one position: mm, N, degrees, arc minutes."""

from types import SimpleNamespace
from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import (
    GIVEN,
    Body,
    Calculation,
    Draw,
    Number,
    Numbers,
    typed,
)
from tests.oracles.answers.load_sharing import lag_class, play_class
from tests.oracles.ring_mesh import exact_mesh

STEEL = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3}

LAWS = {
    "linear": ("LinearLaw", {"stiffness": ("stiffness_N_per_mm", 1000)}),
    "power": (
        "PowerLaw",
        {
            "exponent": ("exponent", 1),
            "reference_force": ("reference_force_N", 1),
            "reference_approach": ("reference_approach_mm", mpf("0.001")),
        },
    ),
    "palmgren": ("PalmgrenLaw", {}),
    "hertz": ("HertzLaw", {}),
}
"""Each law: what it is called where it is calculated, and what it takes, in which unit."""


def request(r: Draw) -> Body:
    """Discs of few lobes with a modification, any law, deviations in half; extremes are nearly
    undercut, or differ in load by decades. Pins in holes move nothing, whatever is given of them.
    """
    lobes, discs = r.randint(5, 11), r.randint(1, 2)
    radius = r.decimal(30, 80)
    k = r.decimal(0.4, 0.9) if r.extreme else r.decimal(0.5, 0.75)
    ratio, pins = float(k), lobes + 1
    if ratio > (pins - 2) / (2 * pins - 1):
        sharp = radius * (27 * (1 - ratio**2) * lobes) ** 0.5 / (pins + 1) ** 1.5
    else:
        sharp = radius * (1 + ratio) ** 2 / (1 + pins * ratio)
    margin = r.choice((1.01, 1.3)) if r.extreme else 1.5
    law: Body = {"kind": r.choice((*LAWS,))}
    if law["kind"] == "linear":
        law["stiffness_N_per_mm"] = r.power(5e4, 1e6)
    if law["kind"] == "power":
        law |= {"exponent": r.choice((1.0, 1.5, 3.0)), "reference_force_N": 1000.0}
        law["reference_approach_mm"] = r.decimal(0.005, 0.02)
    body: Body = {
        "mechanism": {"satellite_teeth": lobes, "ring_teeth": pins, "satellites": discs},
        "load": {
            "output_torque_Nm": r.power(1e-4, 200) if r.extreme else r.decimal(10, 100),
            "torque_direction": r.choice(("driving", "reverse")),
        },
        "contact": {"eccentricity_mm": float(f"{ratio * radius / pins:.3f}")},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": radius,
            "ring_pin_radius_mm": float(f"{min(sharp / margin, 0.2 * radius) - 0.05:.2f}"),
            "contact_length_mm": r.decimal(8, 20),
            "pin_material": STEEL,
            "disc_material": STEEL,
            "modification": {
                "equidistant_mm": r.decimal(0, 0.03),
                "pin_circle_mm": -r.decimal(0, 0.01),
            },
            "contact_law": law,
        },
        "crank_angle_deg": [r.decimal(0, 360)],
    }
    if r.chance(0.5):
        body["deviations"] = {
            "ring_pin_radial_mm": [r.decimal(-0.005, 0.005) for _ in range(pins)],
            "ring_pin_tangential_mm": [r.decimal(-0.005, 0.005) for _ in range(pins)],
            "ring_pin_radius_mm": [r.decimal(-0.001, 0.001) for _ in range(pins)],
            "eccentricity_mm": [r.decimal(-0.002, 0.002) for _ in range(discs)],
            "crank_phase_deg": [r.decimal(-0.01, 0.01) for _ in range(discs)],
            "disc_phase_deg": [r.decimal(-0.002, 0.002) for _ in range(discs)],
        }
    if r.chance(0.3):
        body["mechanism"]["pins"] = holes = r.randint(3, 8)
        body["load"]["pin_circle_radius_mm"] = r.decimal(0.4, 0.6) * radius
        body["contact"] |= {
            "pin_radius_mm": r.decimal(2, 4),
            "contact_length_mm": r.decimal(8, 20),
            "hole_clearance_mm": r.choice((0.0, 0.02)),
            "hole_material": STEEL,
        }
        del body["gear"]["disc_material"]  # which is that of the holes
        if "deviations" in body:
            body["deviations"]["pin_radial_mm"] = [r.decimal(-0.01, 0.01) for _ in range(holes)]
    return body


def numbers(body: Body, answer: Any) -> Numbers:
    """Forces, lags and play by points in the plane."""
    position, arcmin = answer["positions"][0], mp.pi / 10800
    exact = exact_mesh(*_mesh(body))
    pins, largest = body["mechanism"]["ring_teeth"], max(exact.force)
    found = {
        f"/positions/0/force_N/{i // pins}/{i % pins}": Number(
            position["force_N"][i // pins][i % pins], force, largest
        )
        for i, force in enumerate(exact.force)
    }
    circle = body["gear"]["ring_pin_circle_radius_mm"]
    for j, lag in enumerate(exact.rotation):
        sent = position["rotation_arcmin"][j]
        found[f"/positions/0/rotation_arcmin/{j}"] = Number(
            sent, lag / arcmin, None, lag_class(position, circle, lag / arcmin)
        )
    if exact.play is not None and "play_arcmin" in position:
        size = max(max(map(abs, exact.play)) / arcmin, mpf("1e-9"))
        for i, limit in enumerate(exact.play):
            sent, stated = position["play_arcmin"][i], play_class(size)
            found[f"/positions/0/play_arcmin/{i}"] = Number(sent, limit / arcmin, size, stated)
    return found


def _mesh(body: Body) -> tuple[Any, mpf, mpf]:
    """The mesh in decimals, SI units; its crank angle and torque."""
    gear, law = body["gear"], body["gear"]["contact_law"]
    given = body.get("deviations", {})

    def mm(value: Any) -> Any:
        return [*map(mm, value)] if isinstance(value, list) else typed(value) / 1000

    def deg(name: str) -> list[mpf]:
        return [mp.radians(typed(each)) for each in given.get(name, ())]

    name, sizes = LAWS[law["kind"]]
    own = {key: typed(law[field]) * unit for key, (field, unit) in sizes.items()}
    steel = SimpleNamespace(youngs_modulus=mpf("210e9"), poissons_ratio=mpf("0.3"))
    discs = body["mechanism"]["satellites"]
    mesh = SimpleNamespace(
        disc=SimpleNamespace(
            satellite_teeth=body["mechanism"]["satellite_teeth"],
            eccentricity=mm(body["contact"]["eccentricity_mm"]),
            ring_pin_circle_radius=mm(gear["ring_pin_circle_radius_mm"]),
            ring_pin_radius=mm(gear["ring_pin_radius_mm"]),
            modification=SimpleNamespace(
                equidistant=mm(gear["modification"]["equidistant_mm"]),
                pin_circle=mm(gear["modification"]["pin_circle_mm"]),
            ),
        ),
        crank_angles=[2 * mp.pi * j / discs for j in range(discs)],
        contact_length=mm(gear["contact_length_mm"]),
        law=type(name, (SimpleNamespace,), {"reference_depth": None})(**own),
        pin_material=steel,
        disc_material=steel,
        support=None,
        deviations=SimpleNamespace(
            **{
                each: mm(given.get(f"ring_{each}_mm", []))
                for each in ("pin_radial", "pin_tangential", "pin_radius")
            },
            eccentricity=mm(given.get("eccentricity_mm", [])),
            crank_phase=deg("crank_phase_deg"),
            disc_phase=deg("disc_phase_deg"),
        ),
    )
    way = -1 if body["load"]["torque_direction"] == "reverse" else 1
    angle = mp.radians(typed(body["crank_angle_deg"][0]))
    return mesh, angle, way * typed(body["load"]["output_torque_Nm"])


RING_MESH = Calculation(
    "Cycloid disc on ring pins",
    "ring-mesh",
    request,
    numbers,
    one_in=5,
    unbounded={
        **{
            f"/geometry/{name}": "tests/core/test_cycloid_disc.py"
            for name in (
                "shortening_coefficient",
                "min_path_radius_mm",
                "undercut_margin",
                "tip_radius_mm",
                "root_radius_mm",
                "min_concave_radius_mm",
            )
        },
        "/positions/*/crank_angle_deg": GIVEN,
        "/positions/*/loaded_pairs": GIVEN,
        "/positions/*/disc_torque_Nm/*": "sums of forces times levers",
        "/positions/*/crank_across_N/*": "sums of forces",
        "/positions/*/crank_along_N/*": "sums of forces",
        "/positions/*/stiffness_Nm_per_arcmin": "jumps where pairs take up",
        "/positions/*/max_pressure_MPa": "that of /hertz, by its force",
        "/positions/*/loss_per_friction": "sums of forces times distances",
        "/positions/*/interference_mm": "tests/core/test_ring_mesh.py",
    },
)
