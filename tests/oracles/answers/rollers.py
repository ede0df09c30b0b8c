"""Swinging rollers: N, mm, MPa."""

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
from tests.oracles.answers.fatigue import CYCLES, Strength, basis
from tests.oracles.rollers import exact_compliance, exact_forces


def request(r: Draw) -> Body:
    """Rollers with a tolerance or with gaps, of both signs, far from zero, nearly alike."""
    d = r.size(5, 40)
    count = r.choice((1, 2, 3, r.randint(1, 200))) if r.extreme else r.randint(3, 16)

    def part(low: float, high: float) -> float:
        return r.rounded(d * 10 ** (r.uniform(-3, 3) if r.extreme else r.uniform(low, high)))

    body: Body = {
        "output_torque_Nm": r.size(1, 1e4),
        "hole_circle_radius_mm": part(0.3, 1),
        "rollers": count,
        "diameter_mm": d,
        "cylinder_length_mm": part(-0.3, 0.7),
        "sphere_width_mm": part(-0.5, 0.2),
        "sphere_diameter_mm": part(0, 0.4),
        "friction_coefficient": r.choice((0.0, 0.16, r.decimal(0, 1))),
        "youngs_modulus_GPa": r.size(50, 220),
        "stress_concentration": r.decimal(1, 5),
    }
    if r.chance(0.5):
        body["poissons_ratio"] = r.decimal(0, 0.49)
    else:
        body["shear_modulus_GPa"] = r.size(20, 90)
    spread = min(r.power(1e-9, 1e3) if r.extreme else r.power(1e-3, 0.2), 1e6)
    if r.chance(0.4):
        body["position_tolerance_mm"] = r.choice((0.0, spread))
    else:
        base = r.choice((0.0, spread, -1e3 * spread, 1e6 * spread)) if r.extreme else 0.0
        low = r.choice((0.0, -spread))
        gaps = [r.rounded(base + r.uniform(low, spread)) for _ in range(count)]
        body["gaps_mm"] = [0.0 if abs(gap) < 1e-12 else max(min(gap, 1e6), -1e6) for gap in gaps]
    return body


def numbers(body: Body, answer: Any) -> Numbers:
    """The definition: one displacement, forces where it exceeds the gap."""
    lengths = ("cylinder_length", "sphere_width", "sphere_diameter", "diameter")
    case = {name: typed(body[f"{name}_mm"]) for name in lengths}
    case["friction_coefficient"] = typed(body["friction_coefficient"])
    case["youngs_modulus"] = 1000 * typed(body["youngs_modulus_GPa"])
    if "poissons_ratio" in body:
        case["poissons_ratio"] = typed(body["poissons_ratio"])
    else:
        shear = 1000 * typed(body["shear_modulus_GPa"])
        case["poissons_ratio"] = case["youngs_modulus"] / (2 * shear) - 1
    stiffness = 1 / exact_compliance(case)
    count = body["rollers"]
    total = 1000 * typed(body["output_torque_Nm"]) / (2 * typed(body["hole_circle_radius_mm"]))
    if "gaps_mm" in body:
        gaps = [typed(gap) for gap in body["gaps_mm"]]
    else:
        gaps = [mpf(0)] + [4 * typed(body["position_tolerance_mm"])] * (count - 1)
    forces = exact_forces(total, stiffness, gaps)
    mean, largest = total / count, max(forces)
    displacement = min(gaps) + largest / stiffness
    lever = case["cylinder_length"] + case["sphere_width"] / 2
    moment = (lever + case["friction_coefficient"] * case["sphere_diameter"] / 2) * largest
    # a tolerance with the same mean gap: 4*chi for all rollers but one
    wide = mp.fsum(gap - min(gaps) for gap in gaps)
    tolerance = wide / (4 * (count - 1)) if count > 1 else mpf(0)
    concentration = typed(body["stress_concentration"])
    own = {
        "stiffness_N_per_mm": stiffness,
        "relative_stiffness": stiffness / (case["sphere_width"] * case["youngs_modulus"]),
        "mean_force_N": mean,
        "relative_position_error": stiffness * tolerance / mean,
        "load_nonuniformity": largest / mean,
        "max_force_N": largest,
        "centre_force_N": 2 * largest,
        "bending_moment_Nm": moment / 1000,
        "bending_stress_MPa": concentration * moment * 32 / (mp.pi * case["diameter"] ** 3),
    }
    own["relative_stress"] = own["bending_stress_MPa"] / case["youngs_modulus"]
    if "position_tolerance_mm" in body and count == 1:
        own["relative_position_error"] = stiffness * typed(body["position_tolerance_mm"]) / mean
    found = {f"/{name}": Number(answer[name], value) for name, value in own.items()}
    delta = own["relative_position_error"]
    by_largest = max(delta, stiffness * max(map(abs, gaps)) / mean)
    sent = answer["relative_position_error"]
    found["/relative_position_error"] = Number(sent, delta, by_largest)
    for index, force in enumerate(forces):
        found[f"/forces_N/{index}"] = Number(answer["forces_N"][index], force, largest)
    size = max(abs(displacement), *map(abs, gaps))
    found["/displacement_mm"] = Number(answer["displacement_mm"], displacement, size)
    return found


def tired(r: Draw) -> Body:
    """Rollers of steel, and what their fatigue is judged by: a notch counts once."""
    body, fatigue = request(r), basis(r)
    body |= {
        "youngs_modulus_GPa": r.decimal(195, 215),
        "tensile_strength_MPa": r.decimal(700, 1400),
        "yield_strength_MPa": r.decimal(300, 690),
        "roller_rotates": r.chance(0.5),
        "fatigue": fatigue,
    }
    if "surface" in fatigue:
        if r.chance(0.5):
            fatigue.pop("notch", None)
            fatigue.pop("fatigue_notch_factor", None)
        else:
            body["stress_concentration"] = 1.0
    return body


def tired_numbers(body: Body, answer: Any) -> Numbers:
    """Numbers of the rollers, with their stress as a cycle."""
    found = numbers(body, answer)
    top = found["/bending_stress_MPa"].exact
    named = {"notch", "fatigue_notch_factor", "endurance_limit_MPa"} & {*body["fatigue"]}
    if not named and body["stress_concentration"] == 1:  # the notch is unknown
        assert "fatigue" not in answer
        return found
    if "endurance_limit_MPa" in body["fatigue"]:  # in which the notch is
        top /= typed(body["stress_concentration"])
    tensile, yields = (typed(body[f"{name}_strength_MPa"]) for name in ("tensile", "yield"))
    strength = Strength(body["fatigue"], typed(body["diameter_mm"]), tensile, yields)
    bottom = -top if body["roller_rotates"] else mpf(0)
    cycle = strength.cycle(answer["fatigue"], top, bottom)
    return found | {f"/fatigue{pointer}": each for pointer, each in cycle.items()}


ROLLER_FATIGUE = Calculation(
    "Fatigue of the rollers",
    "roller-strength",
    tired,
    tired_numbers,
    unbounded={"/loaded_rollers": GIVEN, "/fatigue/cycles": CYCLES},
)
ROLLER_STRENGTH = Calculation(
    "Swinging rollers",
    "roller-strength",
    request,
    numbers,
    unbounded={"/loaded_rollers": GIVEN},
)
