"""Outer sizes of a reducer: carrier, ring housing, discs and bearings along the axis, mm."""

from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers, typed
from tests.oracles.answers.crank_planetary import mechanism, ratio


def request(r: Draw) -> Body:
    """Sizes of the section stated at random, places of the shaft typed in half of all cases."""
    pin, width = r.size(2, 20), r.size(5, 40)
    body: Body = {
        "mechanism": mechanism(r),
        "load": {"output_torque_Nm": 100.0, "pin_circle_radius_mm": r.size(20, 200)},
        "contact": {
            "contact_length_mm": width,
            "pin_radius_mm": pin,
            "eccentricity_mm": r.size(0.5, 5),
            "hole_clearance_mm": 0.01,
        },
        "include": ["envelope"],
    }
    kind, own = r.choice(("cycloid", "involute", "body")), body["mechanism"]
    if kind == "cycloid":
        least = body["contact"]["eccentricity_mm"] * float(ratio(own) + 1)
        circle = r.rounded(least * r.uniform(1.3, 2.5))
        sizes = {"ring_pin_circle_radius_mm": circle, "ring_pin_radius_mm": r.size(2, 10)}
        body["gear"] = {"kind": kind, **sizes}
    elif kind == "involute":
        difference = (
            r.randint(1, 4) if "ratio" in own else own["ring_teeth"] - own["satellite_teeth"]
        )
        module = r.size(0.5, 5)
        body["gear"] = {"kind": kind, "module_mm": module, "teeth_difference": difference}
        body["contact"]["eccentricity_mm"] = r.rounded(module * difference * r.uniform(0.5, 0.6))
        if r.chance(0.5):
            body["gear"]["ring_profile_shift"] = r.rounded(r.uniform(-0.5, 1))
    else:
        body["satellite_body"] = {"outer_radius_mm": r.size(20, 300)}
    support = r.choice(("cantilever", "supported", "fixed", "tie_ring"))
    if r.chance(0.7):
        body["pin"] = {"support": support}
    names = ["gap", "carrier_width", "housing_width"]
    if "pin" in body and support != "cantilever":
        names.append("second_carrier_width")
    body["build"] = {f"{name}_mm": r.size(1, 30) for name in names if r.chance(0.4)}
    if r.chance(0.6):
        body["crankshaft"] = shaft(r, body["mechanism"]["satellites"], width, body["build"])
    return body


def shaft(r: Draw, satellites: int, width: float, build: Body) -> Body:
    """Bearings of the crankshaft, of which the second may have no width."""
    own: Body = {}
    if r.chance(0.5):
        pitch = width + build.setdefault("gap_mm", 2.0)
        first, way = r.decimal(-100, 100), r.sign()
        own["satellite_positions_mm"] = [first + way * pitch * j for j in range(satellites)]
        if r.chance(0.5):
            places = first - r.size(10, 100), first + r.size(10, 200)
            own["bearing_positions_mm"] = [r.rounded(each) for each in places]
    if r.chance(0.7):
        own["bearings"] = [{"kind": "ball"}, {"kind": "ball"}]
        own["bearings"][0]["width_mm"] = r.size(3, 40)
        if r.chance(0.5):
            own["bearings"][1]["width_mm"] = r.size(3, 40)
    return own


def numbers(body: Body, answer: Any) -> Numbers:
    """Each part by its faces, from the plate that holds the pins."""
    build = {name: typed(value) for name, value in body["build"].items()}
    contact, load = body["contact"], body["load"]
    count, b = body["mechanism"]["satellites"], typed(contact["contact_length_mm"])
    d = 2 * typed(contact["pin_radius_mm"])
    gap = build.get("gap_mm", min(max(b / 10, mpf("0.5")), mpf(2)))
    room = count * b + (count + 1) * gap
    crank = body.get("crankshaft", {})
    widths = [typed(each.get("width_mm", 0.0)) for each in crank.get("bearings", ({}, {}))]
    two = body.get("pin", {}).get("support", "cantilever") != "cantilever"
    plates = [max(mpf("1.2") * d, mpf(3), width) for width in widths]
    first = build.get("carrier_width_mm", plates[0])
    second = build.get("second_carrier_width_mm", plates[1]) if two else mpf(0)
    housing = build.get("housing_width_mm", room)
    faces = [(-first, mpf(0)), (room, room + second) if two else (gap, room - gap)]
    faces.append(((room - housing) / 2, (room + housing) / 2))
    beside = second or widths[1] or first
    ends = [-first / 2, room + beside / 2]
    if "crankshaft" in body and crank.get("satellite_positions_mm"):
        on_shaft = [typed(each) for each in crank["satellite_positions_mm"]]
        way = -1 if on_shaft[-1] < on_shaft[0] else 1
        if "bearing_positions_mm" in crank:
            at = [typed(each) - on_shaft[0] for each in crank["bearing_positions_mm"]]
            ends = [gap + b / 2 + way * each for each in at]
        elif way < 0:
            ends.reverse()
    faces += [(z - w / 2, z + w / 2) for z, w in zip(ends, widths, strict=True) if w]
    reach = ring_reach(body)
    outer = mp.ceil(2 * max(mpf("1.1") * reach, reach + 3) * (1 - mpf("1e-9")))
    carrier = 2 * (typed(load["pin_circle_radius_mm"]) + d)
    length = max(high for _, high in faces) - min(low for low, _ in faces)
    return {
        "/outer_diameter_mm": Number(answer["outer_diameter_mm"], max(outer, carrier)),
        "/length_mm": Number(answer["length_mm"], length),
    }


def ring_reach(body: Body) -> mpf:
    """Radius of the ring at its pins or roots, or of the space of the satellites."""
    gear = body.get("gear")
    if not gear:
        sizes = body["satellite_body"]["outer_radius_mm"], body["contact"]["eccentricity_mm"]
        return typed(sizes[0]) + typed(sizes[1])
    if gear["kind"] == "cycloid":
        return typed(gear["ring_pin_circle_radius_mm"]) + typed(gear["ring_pin_radius_mm"])
    u = ratio(body["mechanism"])
    heights = mpf("1.25") + typed(gear.get("ring_profile_shift", 0.0))
    return typed(gear["module_mm"]) * (gear["teeth_difference"] * (u + 1) / 2 + heights)


ENVELOPE = Calculation("Outer sizes", "crank-planetary", request, numbers, part=("envelope",))
