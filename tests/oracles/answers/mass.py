"""Masses of the parts of a cycloid reducer and its inertia at the input, from its sizes in mm.

The disc is the parallel curve of its tool's path: Steiner's formula has the area, and the moment is
the integral over the angle of the outline's points.
"""

from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers, typed

STEEL, DENSITIES = "7850e-9", {"aluminium_7075_t6": "2810e-9", "bronze_tin": "8700e-9"}  # kg/mm^3

BEARINGS = {
    "6003": ("17", "35", "10", "0.039"),
    "6004": ("20", "42", "12", "0.069"),
    "6205": ("25", "52", "15", "0.128"),
}
"""Bore, outer diameter and width, mm, and mass, kg, by Koyo."""


def request(r: Draw) -> Body:
    """Discs that are far from undercut, bearings by name, all else at random."""
    lobes, satellites = r.randint(8, 30), r.randint(1, 3)
    circle = r.rounded(r.uniform(70, 120))
    eccentricity = r.rounded(circle / (lobes + 1) * r.uniform(0.3, 0.7))
    body: Body = {
        "mechanism": {
            "pins": r.randint(4, 8),
            "satellites": satellites,
            "satellite_teeth": lobes,
            "ring_teeth": lobes + 1,
            "output": r.choice(("pins", "ring")),
        },
        "load": {"output_torque_Nm": 100.0, "pin_circle_radius_mm": r.rounded(circle * 0.6)},
        "contact": {
            "contact_length_mm": r.rounded(r.uniform(8, 30)),
            "pin_radius_mm": r.rounded(r.uniform(2, 4)),
            "eccentricity_mm": eccentricity,
            "hole_clearance_mm": 0.01,
            "hole_material": r.choice((*DENSITIES, "steel_c45")),
        },
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": circle,
            "ring_pin_radius_mm": r.rounded(eccentricity * r.uniform(0.3, 0.7)),
            "modification": {"equidistant_mm": r.rounded(r.uniform(0.01, 0.1))},
        },
        "pin": {"support": "supported"},
        "bearing": {"name": r.choice(("6003", "6004"))},
        "crankshaft": {"bearings": [{"name": r.choice([*BEARINGS])} for _ in "AB"]},
        "build": {
            "gap_mm": r.rounded(r.uniform(0.5, 4)),
            "carrier_width_mm": r.rounded(r.uniform(16, 30)),
            "second_carrier_width_mm": r.rounded(r.uniform(16, 30)),
            "carrier_diameter_mm": r.rounded(circle * r.uniform(1.5, 1.8)),
            "housing_diameter_mm": r.rounded(circle * r.uniform(2.4, 2.8)),
            "housing_width_mm": r.rounded(r.uniform(30, 200)),
        },
        "include": ["mass"],
    }
    return body


def tube(outer: mpf, inner: mpf, length: mpf, density: mpf) -> tuple[mpf, mpf]:
    """Mass and moment of inertia about its own axis, of diameters."""
    whole = density * mp.pi * (outer**2 - inner**2) * length / 4
    return whole, whole * (outer**2 + inner**2) / 8


def around(piece: tuple[mpf, mpf], count: mpf | int, circle: mpf) -> tuple[mpf, mpf]:
    """Pieces on a circle, about its centre."""
    return count * piece[0], count * (piece[1] + piece[0] * circle**2)


def outline(body: Body) -> tuple[mpf, mpf]:
    """Area and polar moment of a disc without holes."""
    gear, lobes = body["gear"], body["mechanism"]["satellite_teeth"]
    big, e = typed(gear["ring_pin_circle_radius_mm"]), typed(body["contact"]["eccentricity_mm"])
    small = typed(gear["ring_pin_radius_mm"]) + typed(gear["modification"]["equidistant_mm"])
    k = e * (lobes + 1) / big
    length = 4 * big * (1 + k) * mp.ellipe(4 * k / (1 + k) ** 2)
    area = mp.pi * (big**2 + (lobes + 1) * e**2) - small * length + mp.pi * small**2

    def swept(t: mpf) -> mpf:
        """Fourth power of the radius over four, by the angle that the radius turns."""
        path = big * mp.expj(-t) - e * mp.expj(-(lobes + 1) * t)
        first = -1j * (big * mp.expj(-t) - e * (lobes + 1) * mp.expj(-(lobes + 1) * t))
        second = -(big * mp.expj(-t) - e * (lobes + 1) ** 2 * mp.expj(-(lobes + 1) * t))
        speed = abs(first)
        normal = 1j * first / speed
        turn = (mp.conj(first) * second).imag / speed**2
        point, moved = path - small * normal, first - small * 1j * turn * normal
        return -(mp.conj(point) * moved).imag * abs(point) ** 2 / 4

    pitch = 2 * mp.pi / lobes
    return area, lobes * mp.quad(swept, mp.linspace(0, pitch, 9))


def numbers(body: Body, answer: Any) -> Numbers:
    """Each part about the axis that it turns about, the sum of all, and of what the crank moves."""
    own, contact, build = body["mechanism"], body["contact"], body["build"]
    count, pins, lobes = own["satellites"], own["pins"], own["satellite_teeth"]
    b, e = typed(contact["contact_length_mm"]), typed(contact["eccentricity_mm"])
    circle, radius = typed(body["load"]["pin_circle_radius_mm"]), typed(contact["pin_radius_mm"])
    size = {name.removesuffix("_mm"): typed(each) for name, each in build.items()}
    steel = mpf(STEEL)
    soft = mpf(DENSITIES.get(contact["hole_material"], STEEL))
    room = count * b + (count + 1) * size["gap"]
    inside = body["bearing"]["name"]
    held = [each["name"] for each in body["crankshaft"]["bearings"]]
    bore, outer, width, _ = map(mpf, BEARINGS[inside])
    area, polar = outline(body)
    hole = radius + e + mpf("0.01")
    disc = soft * b * area, soft * b * polar
    lost = tube(outer, mpf(0), b, soft), around(tube(2 * hole, mpf(0), b, soft), pins, circle)
    kept = [count * (whole - one - other) for whole, one, other in zip(disc, *lost, strict=True)]
    parts: dict[str, tuple[mpf, mpf]] = {"discs": (kept[0], kept[1])}
    length = size["carrier_width"] + room + size["second_carrier_width"]
    parts["pins"] = around(tube(2 * radius, mpf(0), length, steel), pins, circle)
    ring, r_p = typed(body["gear"]["ring_pin_circle_radius_mm"]), body["gear"]["ring_pin_radius_mm"]
    wide, thick = size["housing_width"], 2 * typed(r_p)
    parts["ring_pins"] = around(tube(thick, mpf(0), wide, steel), lobes + 1, ring)
    whole = tube(size["housing_diameter"], 2 * ring, wide, soft)
    seats = around(tube(thick, mpf(0), wide, soft), mpf(lobes + 1) / 2, ring)
    parts["housing"] = whole[0] - seats[0], whole[1] - seats[1]
    for name, end in (("carrier", 0), ("second_carrier", 1)):
        plate = size[f"{name}_width"]
        solid = tube(size["carrier_diameter"], mpf(BEARINGS[held[end]][1]), plate, soft)
        cut = around(tube(2 * radius, mpf(0), plate, soft), pins, circle)
        parts[name] = solid[0] - cut[0], solid[1] - cut[1]
    ends = [size[name] / 2 for name in ("carrier_width", "second_carrier_width")]
    shaft = ends[0] + room + ends[1] + sum(mpf(BEARINGS[each][2]) / 2 for each in held)
    thin = max(mpf(BEARINGS[each][0]) for each in held)
    eccentric = around(tube(bore, mpf(0), width, steel), count, e)
    between = tube(thin, mpf(0), shaft - count * width, steel)
    parts["shaft"] = eccentric[0] + between[0], eccentric[1] + between[1]
    names = {"satellite_bearings": inside, "bearing_a": held[0], "bearing_b": held[1]}
    sent = {each["code"]: each["mass_kg"] for each in answer["parts"]}
    for code, name in names.items():
        inner, around_it, _, kg = map(mpf, BEARINGS[name])
        kg *= count if code == "satellite_bearings" else 1
        parts[code] = kg, kg / 2 * (inner**2 + ((inner + around_it) / 2) ** 2) / 8
    speeds = (1 / mpf(lobes), mpf(0)) if own["output"] == "pins" else (mpf(0), 1 / mpf(lobes + 1))
    of = {"discs": 0, "pins": 0, "carrier": 0, "second_carrier": 0, "ring_pins": 1, "housing": 1}
    inertia = sum(
        moment * (speeds[of[code]] ** 2 if code in of else 1)
        + (kg * e**2 if code in ("discs", "satellite_bearings") else 0)
        for code, (kg, moment) in parts.items()
    )
    counts = {"discs": count, "pins": pins, "ring_pins": lobes + 1, "satellite_bearings": count}
    places = {each["code"]: f"/parts/{i}" for i, each in enumerate(answer["parts"])}
    found = {f"{places[code]}/mass_kg": Number(sent[code], kg) for code, (kg, _) in parts.items()}
    for each in answer["parts"]:
        place = f"{places[each['code']]}/count"
        found[place] = Number(each["count"], mpf(counts.get(each["code"], 1)))
    return found | {
        "/mass_kg": Number(answer["mass_kg"], sum(kg for kg, _ in parts.values())),
        "/inertia_kg_m2": Number(answer["inertia_kg_m2"], inertia * mpf("1e-6")),
    }


MASS = Calculation("Mass and inertia", "crank-planetary", request, numbers, part=("mass",))
