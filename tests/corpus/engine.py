"""Requests of every case of the load sharing: what an engine for them has to answer alike.

Each case with every law that it takes, perfect and with deviations, in both directions and in
alternating ones; one in four as a whole design with what follows from its forces; and studies.
"""

import random
from itertools import product
from typing import Any

SEED = 55

Body = dict[str, Any]

DIRECTIONS = ("driving", "reverse", "alternating")

IN_SERIES, RING = "both meshes", "ring alone"

GIVING = {
    "rigid": {},
    "crank support": {"crank_support"},
    "elastic mesh": {"satellite_coupling"},
    "given shares": {"satellite_coupling"},
    "bent pins": {"pin"},
    "tie ring": {"pin"},
    IN_SERIES: {"satellite_coupling", "gear"},
}
"""Cases of the output's pins, with what they say beside the others; some also bend their pins."""

CASES = (RING, *GIVING)

STUDIES = dict.fromkeys(GIVING, 5) | {IN_SERIES: 10}
"""Studies of each case."""

QUANTITIES = (
    ["peak_force_N", "backlash_max_arcmin"],
    ["max_pressure_MPa", "lost_motion_arcmin"],
    ["transmission_error_arcmin"],
    ["stiffness_min_Nm_per_arcmin", "peak_force_N"],
    ["backlash_max_arcmin"],
)

STRENGTH = {
    "youngs_modulus_GPa": 210.0,
    "poissons_ratio": 0.3,
    "tensile_strength_MPa": 1000.0,
    "yield_strength_MPa": 800.0,
}


class Draw(random.Random):
    """Sizes of a design, and what its parts deviate by."""

    def size(self, low: float, high: float) -> float:
        """A size as it stands on a drawing."""
        return round(self.uniform(low, high), 3)

    def row(self, count: int, most: float) -> list[float]:
        return [round(self.uniform(-most, most), 5) for _ in range(count)]

    def law(self, kind: str) -> Body:
        if kind == "linear":
            return {"kind": kind, "stiffness_N_per_mm": round(10 ** self.uniform(4.5, 5.5))}
        if kind == "power":
            known = {"reference_force_N": 1000.0, "reference_approach_mm": self.size(0.005, 0.02)}
            return {"kind": kind, "exponent": self.choice((10 / 9, 1.5))} | known
        return {"kind": kind}


def laws(case: str) -> tuple[str, ...]:
    """Laws of contact that a case takes: the teeth do not wrap around the pins."""
    return ("linear", "power", "hertz", "palmgren" if case == RING else "conformal")


def teeth(r: Draw) -> Body:
    lobes = r.randint(5, 10)
    return {"satellite_teeth": lobes, "ring_teeth": lobes + 1, "satellites": r.choice((1, 2, 2, 3))}


def ring(r: Draw, eccentricity: float, lobes: int, kind: str) -> Body:
    """Pins of a ring, and discs whose teeth are neither too pointed nor undercut."""
    circle = eccentricity * (lobes + 1) / r.uniform(0.5, 0.75)
    return {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": round(circle, 3),
        "ring_pin_radius_mm": round(circle * r.uniform(0.5, 0.9) / (lobes + 1), 3),
        "contact_length_mm": r.size(8, 20),
        "modification": {"equidistant_mm": r.size(0.01, 0.03), "pin_circle_mm": -r.size(0, 0.008)},
        "contact_law": r.law(kind),
    }


def of_cranks(r: Draw, satellites: int) -> Body:
    return {
        "eccentricity_mm": r.row(satellites, 0.003),
        "crank_phase_deg": r.row(satellites, 0.01),
        "disc_phase_deg": r.row(satellites, 0.01),
    }


def of_ring(r: Draw, pins: int) -> Body:
    names = ("radial", "tangential", "radius")
    return {f"ring_pin_{name}_mm": r.row(pins, 0.003) for name in names}


def of_pins(r: Draw, pins: int, satellites: int) -> Body:
    names = ("radial", "tangential", "radius")
    found: Body = {f"pin_{name}_mm": r.row(pins, 0.004) for name in names}
    holes = {f"hole_{name}_mm": [r.row(pins, 0.004) for _ in range(satellites)] for name in names}
    return found | holes


def ring_alone(r: Draw, kind: str, deviating: bool, direction: str) -> Body:
    """Discs on the pins of their ring."""
    own, eccentricity = teeth(r), r.size(1, 2.5)
    gear = ring(r, eccentricity, own["satellite_teeth"], kind) | {"friction_coefficient": 0.06}
    body: Body = {
        "mechanism": own,
        "load": {"output_torque_Nm": r.size(50, 300), "input_speed_rpm": 1500.0},
        "contact": {"eccentricity_mm": eccentricity},
        "gear": gear,
        "crank_angle_deg": [0.0, *(r.size(0, 360) for _ in range(3))],
        "include": ["positions", "over_turn", "stiffness_curve", "ideal"],
    }
    if direction == "reverse":
        body["load"]["torque_direction"] = direction
    if deviating:
        body["deviations"] = of_cranks(r, own["satellites"]) | of_ring(r, own["ring_teeth"])
    if direction == "alternating":  # which this ring has none of
        shares = [r.uniform(0.5, 1) for _ in range(own["satellites"])]
        body["satellite_coupling"] = {"kind": "shares", "shares": [x / sum(shares) for x in shares]}
    return body


def pins_on(r: Draw, satellites: int, length: float, support: str) -> Body:
    """Pins, and where the discs are on them."""
    places = [round(length * (0.75 + 1.1 * j), 3) for j in range(satellites)]
    pin: Body = {"support": support, "satellite_positions_mm": places, "material": STRENGTH}
    if support != "cantilever":
        pin["span_mm"] = round(places[-1] + 0.75 * length, 3)
    if support == "tie_ring" and r.random() < 0.5:
        pin["ring_joint"] = "clamped"
    return pin


def design(r: Draw, case: str, kind: str) -> Body:
    """Pins in holes of discs that give as the case says, without deviations."""
    own, eccentricity, length = teeth(r), r.size(1, 2.5), r.size(8, 20)
    lobes, satellites = own["satellite_teeth"], own["satellites"]
    own["pins"] = pins = r.randint(4, 8)
    if case != IN_SERIES:
        own = {"pins": pins, "satellites": satellites, "ratio": float(r.randint(8, 40))}
    contact = {
        "contact_length_mm": length,
        "pin_radius_mm": r.size(3, 6),
        "eccentricity_mm": eccentricity,
        "hole_clearance_mm": r.choice((0.0, r.size(0.005, 0.04), r.size(0.01, 0.1))),
    }
    torque = {"output_torque_Nm": r.size(50, 300), "pin_circle_radius_mm": r.size(25, 45)}
    body: Body = {"mechanism": own, "load": torque, "contact": contact, "contact_law": r.law(kind)}
    if case == "crank support":
        support = {"stiffness_N_per_mm": round(10 ** r.uniform(4.5, 6))}
        body["crank_support"] = support | {"radial_clearance_mm": r.choice((0.0, 0.01, 0.02))}
    elif case == "elastic mesh":
        gives = {"kind": "elastic", "stiffness_Nm_per_arcmin": r.size(5, 80)}
        body["satellite_coupling"] = gives
    elif case == "given shares":
        weights = [r.uniform(0.5, 1) for _ in range(satellites)]
        shares = [weight / sum(weights) for weight in weights]
        body["satellite_coupling"] = {"kind": "shares", "shares": shares}
    elif case == IN_SERIES:
        body["satellite_coupling"] = {"kind": "ring"}
        body["gear"] = ring(r, eccentricity, lobes, r.choice(laws(RING)))
    support = "tie_ring" if case == "tie ring" else r.choice(("cantilever", "supported", "fixed"))
    if "pin" in GIVING[case] or (case != "rigid" and r.random() < 0.3):
        body["pin"] = pins_on(r, satellites, length, support)
    return body


def with_deviations(r: Draw, body: Body, case: str) -> Body:
    own = body["mechanism"]
    found = of_pins(r, own["pins"], own["satellites"]) | of_cranks(r, own["satellites"])
    if case == IN_SERIES:
        found |= of_ring(r, own["ring_teeth"])
    return body | {"deviations": found}


def sharing(r: Draw, body: Body, _: str) -> Body:
    """Positions, turn and curves of a design."""
    angles = {"crank_angle_deg": [0.0, *(r.size(0, 360) for _ in range(3))]}
    asked = ["positions", "over_turn", "curves", "stiffness_curve", "pressure", "ideal"]
    return body | angles | {"samples": 13, "include": asked}


def whole(r: Draw, body: Body, case: str) -> Body:
    """A design with all that is judged by its forces."""
    satellites, length = body["mechanism"]["satellites"], body["contact"]["contact_length_mm"]
    places = [round(length * (0.75 + 1.1 * j), 3) for j in range(satellites)]
    ends = [0.0, round(places[-1] + 0.75 * length, 3)]
    body = body | {
        "load": body["load"] | {"input_speed_rpm": r.size(300, 1500)},
        "friction": {"coefficient": 0.08},
        "fatigue": {"surface": "ground", "fatigue_notch_factor": 1.4},
        "bearing": {"kind": "roller", "dynamic_rating_N": 40000.0, "static_rating_N": 42000.0},
        "crankshaft": {"satellite_positions_mm": places, "bearing_positions_mm": ends},
        "requirements": {"life_h": 2000.0},
    }
    body.setdefault("pin", pins_on(r, satellites, length, "supported"))
    body.setdefault("gear", {"radial_force_ratio": 0.4})
    asked = ["load_sharing", "pin_strength", "output_efficiency", "satellite_bearing", "crankshaft"]
    ring_too = ["ring_mesh"] if case == IN_SERIES else []
    return body | {"include": [*asked, *ring_too, "checks"]}


def study(r: Draw, case: str, kind: str, quantities: list[str]) -> Body:
    """A few pieces of a design, at few angles."""
    body = design(r, case, kind)
    body["contact"]["hole_clearance_mm"] = r.size(0.03, 0.08)
    tolerances: Body = {
        "pin_position_mm": 0.01,
        "hole_position_mm": 0.015,
        "pin_diameter": {"lower_mm": -0.006, "upper_mm": 0.0},
        "hole_diameter": {"class": "H7"},
        "eccentricity_mm": 0.004,
        "disc_phase_deg": 0.01,
    }
    if case == IN_SERIES:
        tolerances |= {"ring_pin_position_mm": 0.004, "equidistant_mm": 0.003}
        quantities = [*quantities, r.choice(("ring_peak_force_N", "ring_max_pressure_MPa"))]
    body["load"]["torque_direction"] = r.choice(DIRECTIONS[:2])
    asked = {"quantities": quantities, "samples": 24, "crank_angles": 12, "percentiles": [50.0]}
    return body | {"tolerances": tolerances} | asked | {"seed": r.randrange(1000)}


def designs(case: str) -> list[tuple[str, Body]]:
    """Twenty requests of a case, each with its path."""
    r, found = Draw(f"{SEED} {case}"), []
    kinds = [*product(laws(case), (False, True), DIRECTIONS[:2])]
    kinds += [(kind, deviating, DIRECTIONS[2]) for kind, deviating in zip(
        laws(case), (True, False, True, False), strict=True
    )]  # fmt: skip
    for number, (kind, deviating, direction) in enumerate(kinds):
        if case == RING:
            found.append(("ring-mesh", ring_alone(r, kind, deviating, direction)))
            continue
        body = design(r, case, kind)
        body["load"]["torque_direction"] = direction
        if deviating:
            body = with_deviations(r, body, case)
        as_whole = number % 5 == 4 or (case == IN_SERIES and number % 5 == 2)
        path, asked = ("crank-planetary", whole) if as_whole else ("load-sharing", sharing)
        found.append((path, asked(r, body, case)))
    return found


def studies(case: str) -> list[tuple[str, Body]]:
    """Studies of a case, each with its path."""
    r = Draw(f"{SEED} studies {case}")
    return [
        ("tolerance-study", study(r, case, r.choice(laws(case)), QUANTITIES[number % 5]))
        for number in range(STUDIES[case])
    ]


def engine() -> list[dict[str, Any]]:
    """All requests, each with its path and its case."""
    found = [(case, *each) for case in CASES for each in designs(case)]
    found += [(f"study of {case}", *each) for case in GIVING for each in studies(case)]
    return [{"case": case, "path": path, "body": body} for case, path, body in found]
