"""Load sharing with clearance and errors at one position: mm, N, degrees, arc minutes."""

import math
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
from tests.oracles.answers.crank_planetary import angles, ratio
from tests.oracles.load_sharing import exact_position

LAG = 5e-11
"""Class of a lag, over the largest."""

PLAY = 1e-13, 1e-14
"""Class of the ends of a play: over them, and rad at least."""

ROUNDED = 32 * 2.0**-52
"""Part of the torque of all forces that its sum may lose."""

STEEL = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3}


def request(r: Draw) -> Body:
    """A design with clearance, any law, deviations in half; extremes differ in load and clearance
    by decades. Satellites may give, or share the torque as they are told; the pins of a single one
    may bend. A clearance that is not given is none.
    """
    pins, satellites = r.randint(3, 6), r.randint(1, 2)
    contact = {
        "contact_length_mm": r.decimal(8, 20),
        "pin_radius_mm": r.decimal(3, 8),
        "eccentricity_mm": r.decimal(1, 3),
        "hole_clearance_mm": r.power(1e-6, 0.3) if r.extreme else r.choice((0.0, 0.01, 0.03)),
        "pin_material": STEEL,
        "hole_material": STEEL,
    }
    law: Body = {"kind": r.choice(("hertz", "palmgren", "linear", "power"))}
    if law["kind"] == "linear":
        law["stiffness_N_per_mm"] = r.power(5e4, 1e6)
    if law["kind"] == "power":
        law |= {"exponent": r.choice((1.0, 1.5, 3.0)), "reference_force_N": 1000.0}
        law["reference_approach_mm"] = r.decimal(0.005, 0.02)
    body: Body = {
        "mechanism": {"pins": pins, "satellites": satellites, "ratio": r.decimal(5, 90)},
        "load": {
            "output_torque_Nm": r.power(1e-6, 500) if r.extreme else r.decimal(10, 300),
            "pin_circle_radius_mm": r.decimal(30, 60),
            "torque_direction": r.choice(("driving", "reverse")),
        },
        "contact": contact,
        "contact_law": law,
        "crank_angle_deg": [r.decimal(0, 360)],
    }
    if r.chance(0.3):
        body |= _giving(r, satellites)
    if r.chance(0.5):
        body["deviations"] = {
            "pin_radial_mm": [r.decimal(-0.01, 0.01) for _ in range(pins)],
            "pin_radius_mm": [r.decimal(-0.003, 0.003) for _ in range(pins)],
            "hole_tangential_mm": [
                [r.decimal(-0.01, 0.01) for _ in range(pins)] for _ in range(satellites)
            ],
            "eccentricity_mm": [r.decimal(-0.005, 0.005) for _ in range(satellites)],
            "crank_phase_deg": [r.decimal(-0.01, 0.01) for _ in range(satellites)],
        }
    if r.chance(0.15):
        del contact["hole_clearance_mm"]
    if satellites == 1 and r.chance(0.5):
        body["pin"] = _bending(r, contact)
    return body


def _bending(r: Draw, contact: Body) -> Body:
    """A pin under one satellite, held in three ways, perhaps in a sleeve."""
    length, diameter = contact["contact_length_mm"], 2 * contact["pin_radius_mm"]
    place = r.rounded(length * r.uniform(0.6, 1.5))
    pin = {
        "diameter_mm": r.choice((diameter, min(r.rounded(diameter * r.uniform(0.6, 1)), diameter))),
        "satellite_positions_mm": [place],
        "support": r.choice(("cantilever", "supported", "fixed")),
    }
    if pin["support"] != "cantilever":
        pin["span_mm"] = r.rounded(place + length * r.uniform(0.6, 2))
    return pin


def _giving(r: Draw, satellites: int) -> Body:
    """Elasticity of the satellites."""
    kind = r.choice(("bearings", "elastic", "shares"))
    if kind == "bearings":
        stiffness = r.power(1e3, 1e12) if r.extreme else r.power(1e5, 1e6)
        return {
            "crank_support": {
                "stiffness_N_per_mm": stiffness,
                "radial_clearance_mm": r.choice((0.0, r.decimal(0, 0.03))),
            }
        }
    coupling: Body = {"kind": kind}
    if kind == "elastic":
        stiffness = r.power(0.1, 1e12) if r.extreme else r.power(3, 300)
        coupling["stiffness_Nm_per_arcmin"] = stiffness
    else:
        first = r.choice((0.3, 0.45, 0.5, 0.625))
        coupling["shares"] = [1.0] if satellites == 1 else [first, 1 - first]
    return {"satellite_coupling": coupling}


def numbers(body: Body, answer: Any) -> Numbers:
    """Forces, lag, play by bisection over vectors."""
    position = answer["positions"][0]
    exact = exact_position(*real_of(body))
    arcmin = mp.pi / 10800
    pins = body["mechanism"]["pins"]
    largest = max(exact.force)
    found = {
        f"/positions/0/force_N/{i // pins}/{i % pins}": Number(
            position["force_N"][i // pins][i % pins], force, largest
        )
        for i, force in enumerate(exact.force)
    }
    lag = exact.rotation / arcmin
    found["/positions/0/rotation_arcmin"] = Number(
        position["rotation_arcmin"],
        lag,
        None,
        lag_class(position, body["load"]["pin_circle_radius_mm"], lag),
    )
    if exact.play is not None and "play_arcmin" in position:
        size = max(map(abs, exact.play)) / arcmin
        size = size if size > 1e-20 else mpf(1)  # of none, to the digits of the oracle
        for i, limit in enumerate(exact.play):
            sent, stated = position["play_arcmin"][i], play_class(size)
            found[f"/positions/0/play_arcmin/{i}"] = Number(sent, limit / arcmin, size, stated)
    return found


def lag_class(position: Any, radius_mm: float, lag: mpf) -> float:
    """How well a lag is known, over it: by the class of the method, and by what rounding of the
    torque of all forces turns, which counts where parts press each other.
    """
    held = sum(map(sum, position["force_N"])) * radius_mm / 1000
    turned = ROUNDED * held / position["stiffness_Nm_per_arcmin"]
    return float(LAG + turned / abs(lag)) if lag else 1.0


def play_class(size: mpf) -> float:
    """How well the ends of a play are known, over the larger one, arc minutes."""
    part, least = PLAY
    return float(part + math.degrees(least) * 60 / size) + 2e-16


def real_of(body: Body) -> tuple[Any, mpf, mpf]:
    """The mechanism in decimals, SI units; its crank angle and torque."""
    mechanism, load, contact = (body[name] for name in ("mechanism", "load", "contact"))
    law, given = body["contact_law"], body.get("deviations", {})

    def mm(value: Any) -> Any:
        return [*map(mm, value)] if isinstance(value, list) else typed(value) / 1000

    match law["kind"]:
        case "linear":
            own = SimpleNamespace(stiffness=typed(law["stiffness_N_per_mm"]) * 1000)
        case "power":
            own = SimpleNamespace(
                exponent=typed(law["exponent"]),
                reference_force=typed(law["reference_force_N"]),
                reference_approach=mm(law["reference_approach_mm"]),
            )
        case "palmgren":
            own = SimpleNamespace()
        case _:
            own = SimpleNamespace(reference_depth=None)
    steel = SimpleNamespace(youngs_modulus=mpf("210e9"), poissons_ratio=mpf("0.3"))
    phases = [mp.radians(typed(each)) for each in given.get("crank_phase_deg", ())]
    deviations = {
        name: mm(given.get(f"{name}_mm", []))
        for name in ("pin_radial", "pin_tangential", "pin_radius", "hole_radial",
                     "hole_tangential", "hole_radius", "eccentricity")
    }  # fmt: skip
    real = SimpleNamespace(
        mechanism=SimpleNamespace(
            pins=mechanism["pins"],
            satellites=mechanism["satellites"],
            ratio=ratio(mechanism),
            initial_crank_angle=mpf(0),
            crank_angles=[mp.radians(angle) for angle in angles(mechanism)],
        ),
        pin_circle_radius=mm(load["pin_circle_radius_mm"]),
        pin_radius=mm(contact["pin_radius_mm"]),
        eccentricity=mm(contact["eccentricity_mm"]),
        contact_length=mm(contact["contact_length_mm"]),
        clearance=mm(contact.get("hole_clearance_mm", 0.0)),
        law=own,
        pin=None,
        pin_material=steel,
        hole_material=steel,
        exact=True,
        deviations=SimpleNamespace(**deviations, crank_phase=phases, disc_phase=[]),
    )
    torque = typed(load["output_torque_Nm"])
    sign = -1 if load["torque_direction"] == "reverse" else 1
    real.support = _support(body)
    if pin := body.get("pin"):
        real.pin = SimpleNamespace(
            diameter=mm(pin["diameter_mm"]),
            satellite_positions=mm(pin["satellite_positions_mm"]),
            support=pin["support"],
            span=mm(pin.get("span_mm", 0.0)),
            material=steel,
        )
    return real, mp.radians(typed(body["crank_angle_deg"][0])), sign * torque


def _support(body: Body) -> SimpleNamespace | None:
    """Elasticity of the satellites, in decimals."""
    if bearings := body.get("crank_support"):
        loose = typed(bearings["radial_clearance_mm"]) / 1000
        stiffness = typed(bearings["stiffness_N_per_mm"]) * 1000
        return SimpleNamespace(stiffness=stiffness, radial_clearance=loose)
    coupling = body.get("satellite_coupling", {"kind": "rigid"})
    if coupling["kind"] == "elastic":
        stiffness = typed(coupling["stiffness_Nm_per_arcmin"]) * 10800 / mp.pi
        return SimpleNamespace(stiffness=stiffness)
    if coupling["kind"] == "shares":
        return SimpleNamespace(shares=[*map(typed, coupling["shares"])])
    return None


LOAD_SHARING = Calculation(
    "Load sharing with clearance",
    "load-sharing",
    request,
    numbers,
    unbounded={
        "/positions/*/crank_angle_deg": GIVEN,
        "/positions/*/loaded_pairs": GIVEN,
        "/positions/*/satellite_torque_Nm/*": "sums of forces times levers",
        "/positions/*/satellite_rotation_arcmin/*": "tests/core/test_satellite_support.py",
        "/positions/*/stiffness_Nm_per_arcmin": "jumps where pairs take up",
        "/positions/*/max_pressure_MPa": "that of /hertz, by its force",
        "/positions/*/interference_mm": "tests/core/test_real_mechanism.py",
    },
)
