"""Pin in hole: N, mm, MPa."""

from typing import Any

from mpmath import mp, mpf

from tests.oracles import conformal
from tests.oracles.answers.calculation import (
    GIVEN,
    Body,
    Calculation,
    Draw,
    Number,
    Numbers,
    typed,
)
from tests.oracles.hertz import axis_shear, exact_mean, exact_pressure, exact_tangent

MATERIALS = {
    name: {"youngs_modulus_GPa": modulus, "poissons_ratio": ratio}
    for name, modulus, ratio in (
        ("steel_bearing", 207.0, 0.3),  # ISO/TS 16281
        ("steel_through_hardened", 206.0, 0.3),  # ISO 6336-2
        ("iron_grey", 118.0, 0.3),  # ISO 6336-2
        ("bronze_tin", 88.3, 0.35),  # DIN 3996
        ("plastic_pom", 3.1, 0.35),  # the stiffest of three data sheets
    )
}
MATERIALS["steel_bearing"]["allowable_pressure_MPa"] = 1500.0  # ISO 281
MATERIALS["steel_through_hardened"]["allowable_pressure_MPa"] = 1.313 * 300 + 188  # ISO 6336-5, ML
"""As their sources print them."""


def request(r: Draw) -> Body:
    """Radii from far apart to nearly equal, materials by name or by values, alike or not."""
    pin = r.size(0.5, 100)
    apart = pin * (10 ** r.uniform(-15, 6) if r.extreme else 10 ** r.uniform(-4, 0.5))
    body: Body = {
        "force_N": r.size(1, 1e5, decades=40),
        "contact_length_mm": r.size(1, 100),
        "pin_radius_mm": pin,
        # the sum of two decimals, as people type it
        "hole_radius_mm": float(f"{pin + float(f'{apart:.1e}'):.15g}"),
        "pin_material": material(r),
        "hole_material": material(r),
    }
    if r.chance(0.5):
        body["hole_material"] = body["pin_material"]
    for factor in ("dynamic_factor", "distribution_factor"):
        if r.chance(0.3):
            body[factor] = r.size(1, 3)
    return body


def material(r: Draw) -> Any:
    if r.chance(0.5):
        return r.choice([*MATERIALS])
    body = {"youngs_modulus_GPa": r.size(1, 300), "poissons_ratio": r.decimal(0, 0.49)}
    return body | ({"allowable_pressure_MPa": r.size(10, 2000)} if r.chance(0.5) else {})


def numbers(body: Body, answer: Any) -> Numbers:
    """Hertz from the difference of the decimals; the conformal contact where the answer has it:
    Persson's of materials alike, else that of the integral equation.
    """
    r, R = typed(body["pin_radius_mm"]), typed(body["hole_radius_mm"])
    load = typed(body["force_N"]) / typed(body["contact_length_mm"])
    for factor in ("dynamic_factor", "distribution_factor"):
        load *= typed(body.get(factor, 1.0))
    given = [
        MATERIALS[each] if isinstance(each, str) else each
        for each in (body["pin_material"], body["hole_material"])
    ]
    moduli = [
        1000 * typed(each["youngs_modulus_GPa"]) / (1 - typed(each["poissons_ratio"]) ** 2)
        for each in given
    ]
    modulus = 1 / (1 / moduli[0] + 1 / moduli[1])
    rho = R * r / (R - r)
    peak, half_width = (
        mp.sqrt(load * modulus / (mp.pi * rho)),
        mp.sqrt(4 * load * rho / (mp.pi * modulus)),
    )
    depth = mp.sqrt((mp.sqrt(5) - 1) / 2)
    exact: dict[str, mpf] = {
        "/max_pressure_MPa": peak,
        "/mean_pressure_MPa": mp.pi / 4 * peak,
        "/half_width_mm": half_width,
        "/half_width_ratio": half_width / r,
        "/max_shear_MPa": axis_shear(depth) * peak,
        "/max_shear_depth_mm": depth * half_width,
        "/reduced_radius_mm": rho,
        "/effective_modulus_GPa": modulus / 1000,
    }
    governing = peak
    if "conformal_pressure_MPa" in answer:
        ratios = [typed(each["poissons_ratio"]) for each in given]
        parameter, radius = modulus * (R - r) / load, mp.sqrt(R * r)
        if given[0] == given[1]:
            b = exact_tangent(2 * parameter)
            pressure, mean = exact_pressure(mpf(0), b), exact_mean(b)
            angle = 2 * mp.atan(b)
        else:
            shear = [(1 - v / (1 - v)) / each for v, each in zip(ratios, moduli, strict=True)]
            alpha = (moduli[0] - moduli[1]) / (moduli[0] + moduli[1])
            beta = modulus / 2 * (shear[1] - shear[0])
            angle, _, mean, pressure = map(
                mpf, conformal.of_load(float(parameter), float(alpha), float(beta))
            )
        governing = pressure * load / radius
        share = (3 - 4 * ratios[1]) / (2 * mp.pi * (1 - ratios[1]))
        exact |= {
            "/conformal_pressure_MPa": governing,
            "/conformal_half_angle_deg": mp.degrees(angle),
            "/conformal_half_angle_pin_deg": mp.degrees(angle) * mp.sqrt(R / r),
            "/conformal_half_angle_hole_deg": mp.degrees(angle) * mp.sqrt(r / R),
            "/conformal_half_length_mm": angle * radius,
            "/edge_tension_MPa": (2 * mean + share * mp.cos(angle)) * load / radius,
        }
    if "governing_pressure_MPa" in answer:
        exact["/governing_pressure_MPa"] = governing
    factors = [typed(each["limit_MPa"]) / governing for each in answer.get("safety", ())]
    if factors and "safety_factor" in answer:
        exact["/safety_factor"] = min(factors)
    found = {pointer: Number(answer[pointer[1:]], value) for pointer, value in exact.items()}
    for index, factor in enumerate(factors):
        sent = answer["safety"][index]["safety_factor"]
        found[f"/safety/{index}/safety_factor"] = Number(sent, factor)
    return found


HERTZ = Calculation(
    "Hertz and conformal contact",
    "hertz",
    request,
    numbers,
    unbounded={"/safety/*/limit_MPa": GIVEN},
)
