"""The precessional gear, from its mesh to its shaft: N, mm, MPa, and N·mm within."""

import json
import math
from decimal import Decimal
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

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
from tests.oracles.answers.hertz import MATERIALS, material
from tests.oracles.precession import length_by_z, load_integrals, scale, z_of_angle
from tests.oracles.shaft import exact_deflection


def gear(r: Draw) -> Body:
    """Practical gears; or u12 near cos(theta), flat and steep nutation, rollers of any size."""
    circle = r.size(20, 100)
    if not r.extreme:
        teeth = r.randint(15, 60)
        return {
            "roller_circle_radius_mm": circle,
            "roller_radius_mm": r.rounded(circle * r.uniform(0.03, 0.12)),
            "nutation_angle_deg": r.decimal(1, 8),
            "ratio_u12": r.choice((r.decimal(0.8, 0.97), round(1 - 1 / teeth, 4), 1.05)),
        }
    angle = r.power(1e-4, 85)
    difference = r.sign() * 10 ** r.uniform(-9, 0)
    return {
        "roller_circle_radius_mm": circle,
        "roller_radius_mm": r.rounded(circle * 10 ** r.uniform(-3, -0.01)),
        "nutation_angle_deg": angle,
        "ratio_u12": r.choice((1.0, math.cos(math.radians(angle)) - difference)),
    }


def curve_scale(body: Body) -> mpf:
    """A, mm; negative where u12 > cos(theta)."""
    angle = mp.radians(typed(body["nutation_angle_deg"]))
    return scale(typed(body["roller_circle_radius_mm"]), angle, typed(body["ratio_u12"]))


def mesh(r: Draw) -> Body:
    """Rollers one by one, with limits in z or in phi, or a wheel; none across z = 0."""
    body = gear(r)
    if r.chance(0.25):
        total = r.randint(1, 60)
        low, high = by_length(r, body, mpf("0.5"))
        mesh = r.randint(1, min(total, 5))
        first = position(r)
        while not r.extreme and without_arm(first, total, mesh):
            first = position(r)
        wheel = {"rollers_total": total, "rollers_in_mesh": mesh, "position_angle_deg": first}
        wheel |= {"z_min_mm": low, "z_max_mm": high}
        return body | {"wheel": wheel}
    rollers = []
    for _ in range(r.choice((1, 1, 2, 3, 5))):
        angle = position(r)
        if r.chance(0.6):
            low, high = by_length(r, body, mp.radians(typed(angle)))
            roller = {"z_min_mm": low, "z_max_mm": high}
        else:
            low, high = by_angle(r, angle)
            roller = {"phi_min_deg": low, "phi_max_deg": high}
        rollers.append({"position_angle_deg": angle} | roller)
    return body | {"rollers": rollers}


def without_arm(first: float, total: int, in_mesh: int) -> bool:
    """True if a roller of a wheel lies at a multiple of half a turn, where it has no arm."""
    places = (typed(first) + mpf(360) * index / total for index in range(in_mesh))
    return any(abs(place / 180 - mp.nint(place / 180)) < mpf("1e-30") for place in places)


def position(r: Draw) -> float:
    """Position angle of a roller, degrees."""
    if not r.extreme:
        return r.decimal(5, 175)
    small = r.rounded(10 ** r.uniform(-5, math.log10(90)))
    place = r.sign() * r.choice((small, 180 - small)) + 360 * r.choice((0, 0, 1, -9))
    return float(f"{place:.14g}")


def by_length(r: Draw, body: Body, angle: mpf) -> tuple[float, float]:
    """Ends in z on one side of 0; extremes around the steepest place, narrow, or very wide."""
    circle = body["roller_circle_radius_mm"]
    if not r.extreme:
        start = r.decimal(5, 50)
        low, high = start, start + r.choice((1.0, 5.0, 10.0, r.decimal(1, 20)))
    else:
        a = float(curve_scale(body))
        steep, width = -a * float(mp.cos(angle)), abs(a * float(mp.sin(angle)))
        anywhere = circle * 10 ** r.uniform(-9, 2)
        low = r.choice((circle * r.random(), anywhere, steep + width * r.uniform(-9, 3)))
        narrow = abs(low) * 10 ** r.uniform(-11, -1)
        usual, wide = circle * 10 ** r.uniform(-3, 0.3), width * 10 ** r.uniform(-1, 3)
        high = low + r.choice((usual, narrow, wide))
    low, high = (min(max(float(f"{each:.15g}"), -1e6), 1e6) for each in (low, high))
    if low < 0 < high:
        low = high / 1024 if high > -low else low
        high = high if low > 0 else low / 1024
    return (low, high) if r.chance(0.8) else (-high, -low)


def by_angle(r: Draw, position: float) -> tuple[float, float]:
    """Ends in phi between a pole and phi = 0, or between that and the next pole."""
    pole, zero = -(position % 180), 0.0
    below = r.chance(0.5)  # between the pole and 0, or between 0 and the next pole
    start, end = (pole, zero) if below else (zero, pole + 180)
    room = end - start
    if r.extreme:
        inset = [room * 10 ** r.uniform(-10, -0.4) for _ in range(2)]
    else:
        inset = [room * r.uniform(0.1, 0.4) for _ in range(2)]
    low, high = start + inset[0], end - inset[1]
    if r.extreme and r.chance(0.3):
        high = low + (high - low) * 10 ** r.uniform(-9, -1)
    turn = r.choice((0, 0, 180, -360))
    digits = 15 if r.extreme else 4
    return float(f"{low + turn:.{digits}g}"), float(f"{high + turn:.{digits}g}")


class Line(NamedTuple):
    """A contact line: place of its roller, rad; its ends, mm; its length, mm."""

    angle: mpf
    z_min: mpf
    z_max: mpf
    length: mpf


class Mesh(NamedTuple):
    """Exact lines, force, N, moment about C, N·mm, and largest line load, N/mm."""

    lines: list[Line]
    force: tuple[mpf, mpf]
    moment: tuple[mpf, mpf, mpf]
    line_load: mpf


GEAR = (
    "roller_circle_radius_mm", "roller_radius_mm", "nutation_angle_deg", "ratio_u12", "rollers",
    "wheel",
)  # fmt: skip


def lines(body: Body) -> list[Line]:
    """Exact contact lines, each mesh calculated once."""
    return _lines(json.dumps({name: body[name] for name in GEAR if name in body}))


@lru_cache(4)
def _lines(text: str) -> list[Line]:
    body = json.loads(text)
    a, radius = curve_scale(body), typed(body["roller_radius_mm"])
    ends = []
    if "wheel" in body:
        wheel = body["wheel"]
        for index in range(wheel["rollers_in_mesh"]):
            angle = typed(wheel["position_angle_deg"]) + mpf(360) * index / wheel["rollers_total"]
            z = typed(wheel["z_min_mm"]), typed(wheel["z_max_mm"])
            ends.append((mp.radians(angle), *z))
    for roller in body.get("rollers", ()):
        angle = mp.radians(typed(roller["position_angle_deg"]))
        if "z_min_mm" in roller:
            ends.append((angle, typed(roller["z_min_mm"]), typed(roller["z_max_mm"])))
        else:
            phi = (mp.radians(typed(roller[name])) for name in ("phi_min_deg", "phi_max_deg"))
            ends.append((angle, *sorted(z_of_angle(a, angle, each) for each in phi)))
    return [Line(*each, length_by_z(a, each[0], radius, *each[1:])) for each in ends]


def exact_mesh(body: Body) -> Mesh:
    """Exact load of a mesh, calculated once."""
    wanted = (*GEAR, "torque_Nm", "reference_z_mm")
    return _mesh(json.dumps({name: body[name] for name in wanted if name in body}))


@lru_cache(4)
def _mesh(text: str) -> Mesh:
    body = json.loads(text)
    a, found = curve_scale(body), lines(body)
    circle, radius = typed(body["roller_circle_radius_mm"]), typed(body["roller_radius_mm"])
    torque, reference = 1000 * typed(body["torque_Nm"]), typed(body["reference_z_mm"])
    shares = [load_integrals(a, circle, radius, *line[:3], reference) for line in found]
    factor = torque / mp.fsum(line.length for line in found)
    x, y, about_x, about_y, _ = (factor * mp.fsum(each) for each in zip(*shares, strict=True))
    # R_C over the arm is largest at an end
    inverse = max(
        mp.hypot(z + a * mp.cos(line.angle), a * mp.sin(line.angle)) / abs(z * mp.sin(line.angle))
        for line in found
        for z in (line.z_min, line.z_max)
    )
    return Mesh(found, (x, y), (about_x, about_y, torque), abs(factor) / circle * inverse)


def line_numbers(body: Body, answer: Any) -> Numbers:
    """Each line by the error that it states, or the answer's; the total by the answer's."""
    exact = lines(body)
    total = mp.fsum(line.length for line in exact)
    found = {"/total_length_mm": Number(answer["total_length_mm"], total)}
    for index, (line, sent) in enumerate(zip(exact, answer["lines"], strict=True)):
        pointer = f"/lines/{index}/length_mm"
        found[pointer] = Number(sent["length_mm"], line.length, None, sent.get("relative_error"))
    return found


def load(r: Draw) -> Body:
    body = mesh(r)
    reference = r.choice((0.0, r.decimal(-50, 50)))
    return body | {"torque_Nm": r.sign() * r.size(1, 1000), "reference_z_mm": reference}


def load_numbers(body: Body, answer: Any) -> Numbers:
    """Components over the size of their vector; forces that cancel over M1/R_C."""
    exact = exact_mesh(body)
    circle = typed(body["roller_circle_radius_mm"])
    force = max(mp.hypot(*exact.force), abs(exact.moment[2]) / circle)
    moment = mp.sqrt(mp.fsum(each**2 for each in exact.moment)) / 1000
    total = mp.fsum(line.length for line in exact.lines)
    found = {
        "/max_line_load_N_per_mm": Number(answer["max_line_load_N_per_mm"], exact.line_load),
        "/total_length_mm": Number(answer["total_length_mm"], total),
    }
    for axis, value in enumerate((*exact.force, mpf(0))):
        found[f"/force_N/{axis}"] = Number(answer["force_N"][axis], value, force)
    for axis, value in enumerate(exact.moment):
        found[f"/moment_Nm/{axis}"] = Number(answer["moment_Nm"][axis], value / 1000, moment)
    return found


def shaft(r: Draw) -> Body:
    """A plain or a stepped shaft, whose lengths are decimals that add up, the overhang any."""
    body = load(r)
    a = r.size(10, 100, decades=3)
    b = r.rounded(a * 10 ** (r.uniform(-6, 3) if r.extreme else r.uniform(-1, 0.3)))
    a, b = (float(f"{each:.4g}") for each in (a, b))
    body |= {"bearing_distance_mm": a, "overhang_mm": b, "youngs_modulus_GPa": r.size(70, 220)}
    if r.chance(0.4):
        return body | {"shaft_diameter_mm": r.size(5, 50)}
    total = Decimal(repr(a)) + Decimal(repr(b))
    last = Decimal(10) ** (total.adjusted() - 13)
    cuts = {Decimal(0), total}
    for _ in range(r.randint(0, 4)):
        near_b = Decimal(repr(a)) + Decimal(r.uniform(-1, 1)) * Decimal(repr(min(a, b)))
        place = r.choice((near_b, Decimal(repr(a)), total * Decimal(r.random())))
        cuts.add(min(max(place.quantize(last), last), total - last))
    places = sorted(cuts)
    sections = [
        {"length_mm": float(far - near), "diameter_mm": r.size(5, 50, decades=2)}
        for near, far in pairwise(places)
    ]
    return body | {"shaft_sections": sections}


def stretches(body: Body) -> list[tuple[mpf, mpf]]:
    """Lengths and diameters of the shaft from C to the clamp."""
    if "shaft_sections" in body:
        given = ((each["length_mm"], each["diameter_mm"]) for each in body["shaft_sections"])
        return [(typed(length), typed(diameter)) for length, diameter in given]
    length = typed(body["bearing_distance_mm"]) + typed(body["overhang_mm"])
    return [(length, typed(body["shaft_diameter_mm"]))]


def shaft_numbers(body: Body, answer: Any) -> Numbers:
    """Components over the size of their vector; the simplification's error over itself and 1.

    With digits enough that a step at B stays there: sections may differ 1e52-fold in stiffness.
    """
    exact = exact_mesh(body)
    with mp.workdps(120):
        return _shaft_numbers(body, answer, exact)


def _shaft_numbers(body: Body, answer: Any, exact: Mesh) -> Numbers:
    a, b = typed(body["bearing_distance_mm"]), typed(body["overhang_mm"])
    modulus = 1000 * typed(body["youngs_modulus_GPa"])
    sections = stretches(body)
    plain = [(a + b, min(diameter for _, diameter in sections))]
    at_b = (-exact.moment[1] / a, exact.moment[0] / a)
    at_c = tuple(-force - own for force, own in zip(exact.force, at_b, strict=True))
    found: Numbers = {}
    for name, value in (("reaction_B_N", at_b), ("reaction_C_N", at_c)):
        for axis in (0, 1):
            found[f"/{name}/{axis}"] = Number(answer[name][axis], value[axis], mp.hypot(*value))

    def deflection(
        stretches: list[tuple[mpf, mpf]], place: mpf, slope: bool = False
    ) -> tuple[mpf, mpf, mpf]:
        size = 1000 if slope else 1  # mrad
        x, y = (
            size
            * exact_deflection(stretches, a, b, modulus, -at_b[axis], -at_c[axis], place, slope)
            for axis in (0, 1)
        )
        return x, y, mp.hypot(x, y)

    for name, place in (("B", a), ("C", mpf(0))):
        true = deflection(sections, place)
        shapes = {
            f"deflection_{name}_mm": true,
            f"slope_{name}_mrad": deflection(sections, place, slope=True),
        }
        if f"simplified_deflection_{name}_mm" in answer:
            simple = shapes[f"simplified_deflection_{name}_mm"] = deflection(plain, place)
            error = simple[2] / true[2] - 1
            pointer = f"simplification_error_{name}"
            found[f"/{pointer}"] = Number(answer[pointer], error, 1 + abs(error))
        for shape, values in shapes.items():
            for axis, value in zip(("x", "y", "total"), values, strict=True):
                found[f"/{shape}/{axis}"] = Number(answer[shape][axis], value, values[2])
    return found


def strong(r: Draw) -> Body:
    """A shaft of steel, and what its strength is judged by."""
    return shaft(r) | {
        "youngs_modulus_GPa": r.decimal(195, 215),
        "tensile_strength_MPa": r.decimal(700, 1400),
        "yield_strength_MPa": r.decimal(300, 690),
        "load_rotates_with_shaft": r.chance(0.2),
        "fatigue": basis(r),
    }


def strong_numbers(body: Body, answer: Any) -> Numbers:
    """Numbers of the shaft and its stresses at all steps, at B and at the clamp, from force and
    moment of the mesh: ``F*s - M*min(s/a, 1)``.
    """
    found, mesh, sent = shaft_numbers(body, answer), exact_mesh(body), answer["strength"]
    tensile, yields = (typed(body[f"{name}_strength_MPa"]) for name in ("tensile", "yield"))
    with mp.workdps(120):
        a, start, ends = typed(body["bearing_distance_mm"]), mpf(0), []
        for length, diameter in stretches(body):
            inside = [a] if start < a < start + length else []
            ends += [(place, diameter) for place in (start, *inside, start + length)]
            start += length

        def bent(place: mpf) -> mpf:
            held = min(place / a, 1)
            x = mesh.force[0] * place - mesh.moment[1] * held
            return mp.hypot(x, mesh.force[1] * place + mesh.moment[0] * held)

        stresses = [bent(place) * 32 / (mp.pi * diameter**3) for place, diameter in ends]
        most, clamp = max(stresses), typed(body["overhang_mm"]) + a
        exact = {
            "bending_moment_B_Nm": bent(a) / 1000,
            "bending_moment_clamp_Nm": bent(clamp) / 1000,
            "peak_stress_MPa": most,
            "static_safety_factor": yields / most,
        }
    for name, value in exact.items():
        found[f"/strength/{name}"] = Number(sent[name], value)
    if not body["load_rotates_with_shaft"]:
        judged = [Strength(body["fatigue"], diameter, tensile, yields) for _, diameter in ends]
        stresses = [+stress for stress in stresses]  # to the digits of the rest
        uses = [stress / own.limit for stress, own in zip(stresses, judged, strict=True)]
        worst = uses.index(max(uses))
        cycle = judged[worst].cycle(sent["fatigue"], stresses[worst], -stresses[worst])
        found |= {f"/strength/fatigue{pointer}": each for pointer, each in cycle.items()}
    return found


def touching(r: Draw) -> Body:
    """A shaft, and teeth hollow or convex, up to a hair wider than the roller."""
    body = shaft(r)
    radius = body["roller_radius_mm"]
    apart = radius * 10 ** (r.uniform(-9, 3) if r.extreme else r.uniform(-2, 1))
    hollow = -float(f"{radius + float(f'{apart:.1e}'):.15g}")
    return body | {
        "line_contact": {
            "mating_radius_mm": r.choice((r.rounded(apart), hollow)),
            "roller_material": material(r),
            "mating_material": material(r),
        }
    }


def touching_numbers(body: Body, answer: Any) -> Numbers:
    """Two cylinders under the largest line load: Johnson, by the sum of the curvatures."""
    given = body["line_contact"]
    bodies = [
        MATERIALS[each] if isinstance(each, str) else each
        for each in (given["roller_material"], given["mating_material"])
    ]
    soft = mp.fsum(
        (1 - typed(each["poissons_ratio"]) ** 2) / typed(each["youngs_modulus_GPa"])
        for each in bodies
    )
    curved = 1 / typed(body["roller_radius_mm"]) + 1 / typed(given["mating_radius_mm"])
    load, modulus = exact_mesh(body).line_load, 1000 / soft
    pressure = mp.sqrt(load * modulus * curved / mp.pi)
    exact = {
        "max_pressure_MPa": pressure,
        "half_width_mm": mp.sqrt(4 * load / (mp.pi * modulus * curved)),
        "reduced_radius_mm": 1 / curved,
        "effective_modulus_GPa": 1 / soft,
    }
    for name, each in zip(("roller_safety", "mating_safety"), bodies, strict=True):
        if name in answer:
            exact[name] = typed(each["allowable_pressure_MPa"]) / pressure
    return {f"/{name}": Number(answer[name], value) for name, value in exact.items()}


CONTACT_LINE = Calculation(
    "Contact line",
    "precession/contact-line",
    mesh,
    line_numbers,
    unbounded={
        "/lines/*/relative_error": GIVEN,
        "/lines/*/position_angle_deg": "as given, or that of the wheel; no bound is stated",
        "/lines/*/z_min_mm": "as given, or of the angle given; no bound is stated",
        "/lines/*/z_max_mm": "as given, or of the angle given; no bound is stated",
        "/lines/*/phi_min_deg": "as given, or of the z given; no bound is stated",
        "/lines/*/phi_max_deg": "as given, or of the z given; no bound is stated",
    },
)
MESHING_LOAD = Calculation("Meshing load", "precession/meshing-load", load, load_numbers)
SHAFT_DEFLECTION = Calculation(
    "Shaft deflection", "precession/shaft-deflection", shaft, shaft_numbers
)
SHAFT_STRENGTH = Calculation(
    "Strength of the shaft",
    "precession/shaft-deflection",
    strong,
    strong_numbers,
    unbounded={
        "/strength/peak_stress_position_mm": "a place of the shaft, B or a step",
        "/strength/cycle_position_mm": "a place of the shaft, B or a step",
        "/strength/fatigue/cycles": CYCLES,
    },
    one_in=5,
)
LINE_CONTACT = Calculation(
    "Pressure of the contact line",
    "precession/shaft-deflection",
    touching,
    touching_numbers,
    part=("line_contact",),
    one_in=5,
)
