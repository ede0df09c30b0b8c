"""Bearings of the satellites: mm, N, and rpm."""

from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers, typed
from tests.oracles.answers.crank_planetary import (
    EXPONENTS,
    EXTREME_EXPONENTS,
    angles,
    mechanism,
    ratio,
)
from tests.oracles.answers.losses import by_a_hair
from tests.oracles.satellite_turn import SatelliteTurn

LIFE_FACTORS = {90: 1, 95: 0.64, 96: 0.55, 97: 0.47, 98: 0.37, 99: 0.25}


def request(r: Draw) -> Body:
    """A design with at most 16 pairs, and any ring."""
    own = mechanism(r)
    while by_a_hair(own) or own["pins"] * own["satellites"] > 16:
        own = mechanism(r)
    load: Body = {"pin_circle_radius_mm": r.size(10, 200), "input_speed_rpm": r.size(10, 3000)}
    load["output_torque_Nm"] = r.size(1, 1e4)
    load["force_exponent"] = r.choice(EXTREME_EXPONENTS if r.extreme else EXPONENTS)
    e = r.size(0.5, 5)
    kind = r.choice(("involute", "cycloid", "none", "ratio"))
    gear: Body = {"kind": kind}
    if kind == "involute":
        cosine = mpf(r.uniform(0.4, 0.99)) / mp.cos(mp.radians(20))
        difference = own["ring_teeth"] - own["satellite_teeth"] if "ring_teeth" in own else 1
        module = float(2 * e * cosine) / difference
        gear |= {"module_mm": max(r.rounded(module), 1e-12), "teeth_difference": difference}
    elif kind == "cycloid":
        radius = e * float(ratio(own) + 1) / r.uniform(0.01, 0.99)
        gear["ring_pin_circle_radius_mm"] = max(r.rounded(radius), 1e-12)
    elif kind == "ratio":
        gear = {"radial_force_ratio": r.decimal(-2, 2)}
    bearing: Body = {"kind": r.choice(("ball", "roller"))}
    if r.chance(0.7):
        bearing |= {"dynamic_rating_N": r.size(1e3, 1e6), "static_rating_N": r.size(1e3, 1e6)}
        bearing["reliability_percent"] = r.choice(list(LIFE_FACTORS))
        bearing["ring_factor"] = r.choice((1.0, 1.2))
        if r.chance(0.5):
            bearing["weibull_slope"] = r.decimal(1, 2)
    if r.chance(0.3):
        load["application_factor"] = r.decimal(0.5, 3)
    if r.chance(0.3):
        working = load["output_torque_Nm"] * load.get("application_factor", 1.0)
        load["peak_torque_Nm"] = r.rounded(working * r.uniform(1.1, 4))
    return {
        "mechanism": own,
        "load": load,
        "contact": {"eccentricity_mm": e},
        "gear": gear,
        "bearing": bearing,
    }


def numbers(body: Body, answer: Any) -> Numbers:
    """By definition; the turn narrowed and integrated from the law of the forces."""
    own, load, gear, bearing = (body[name] for name in ("mechanism", "load", "gear", "bearing"))
    u, e = ratio(own), typed(body["contact"]["eccentricity_mm"])
    rho, angle = ring_ratio(gear, e, u)
    torque, speed = 1000 * typed(load["output_torque_Nm"]), typed(load["input_speed_rpm"])
    factor = typed(load.get("application_factor", 1.0))
    static = 1000 * typed(load["peak_torque_Nm"]) / torque if "peak_torque_Nm" in load else factor
    across = torque / (e * u)
    relative = speed * (1 + 1 / u)
    exact = {"/relative_speed_rpm": relative, "/radial_force_ratio": rho}
    if angle is not None:
        exact["/operating_pressure_angle_deg"] = mp.degrees(angle)
    p = mpf(3) if bearing["kind"] == "ball" else mpf(10) / 3
    cranks = [mp.radians(each) for each in angles(own)]
    along = e * u / typed(load["pin_circle_radius_mm"])
    lives = []
    for j in range(len(cranks)):
        turn = SatelliteTurn(own["pins"], cranks, typed(load["force_exponent"]), j)
        least, most, mean, ring = turn.loads(rho, along, p)
        equivalent = across * mean * typed(bearing.get("ring_factor", 1.0))
        own_numbers = {
            "peak_load_N": across * most,
            "min_load_N": across * least,
            "equivalent_load_N": equivalent,
            "peak_ring_force_N": across * ring * mp.sqrt(1 + rho**2),
        }
        if "dynamic_rating_N" in bearing:
            million = 1_000_000 / (60 * relative)
            life = million * (typed(bearing["dynamic_rating_N"]) / equivalent) ** p
            own_numbers["basic_life_h"] = life
            own_numbers["life_h"] = life * typed(LIFE_FACTORS[bearing["reliability_percent"]])
            lives.append(own_numbers["life_h"])
            own_numbers["static_safety_factor"] = typed(bearing["static_rating_N"]) / (
                static * across * most
            )
        sent = answer["satellites"][j]  # lives are of what carries something
        exact |= {
            f"/satellites/{j}/{name}": own_numbers[name] for name in own_numbers if name in sent
        }
    if "weibull_slope" in bearing:
        slope = typed(bearing["weibull_slope"])
        exact["/system_life_h"] = mp.fsum(life**-slope for life in lives) ** (-1 / slope)
    found: Numbers = {}
    for pointer, value in exact.items():
        sent = answer
        for name in pointer[1:].split("/"):
            sent = sent[int(name) if name.isdigit() else name]
        # a least load may be next to nothing beside the largest
        size = exact[pointer.replace("min", "peak")] if pointer.endswith("min_load_N") else None
        found[pointer] = Number(sent, value, size)
    return found


def ring_ratio(gear: Body, e: mpf, u: mpf) -> tuple[mpf, mpf | None]:
    """rho, and alpha_w."""
    if "radial_force_ratio" in gear:
        return typed(gear["radial_force_ratio"]), None
    if gear["kind"] == "involute":
        angle = mp.acos(
            typed(gear["module_mm"]) * gear["teeth_difference"] * mp.cos(mp.radians(20)) / (2 * e)
        )
        return mp.tan(angle), angle
    if gear["kind"] == "cycloid":
        k = e * (u + 1) / typed(gear["ring_pin_circle_radius_mm"])
        with mp.workdps(80):
            closed = (2 - (1 - k**2) / k * mp.log((1 + k) / (1 - k))) / (mp.pi * k)
        return -closed, None
    return mpf(0), None


SATELLITE_BEARING = Calculation(
    "Bearings of the satellites", "satellite-bearing", request, numbers, one_in=20
)
