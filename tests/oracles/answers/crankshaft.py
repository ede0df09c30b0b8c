"""Crankshaft: reactions by moments about the bearings, mm, N, and rpm; kg*mm."""

from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.bearings import request as bearing_request
from tests.oracles.answers.bearings import ring_ratio
from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers, typed
from tests.oracles.answers.crank_planetary import angles, ratio
from tests.oracles.satellite_turn import ShaftTurn


def request(r: Draw) -> Body:
    """The satellites between the bearings, beyond them, at one, or all in one place."""
    body = bearing_request(r)
    bearing = body.pop("bearing")
    count = body["mechanism"]["satellites"]
    pitch = r.size(5, 50, 2)
    first = r.choice((0.0, r.decimal(-100, 100)))
    places = [r.rounded(first + pitch * (j + r.uniform(0.5, 1))) for j in range(count)]
    last = r.rounded(first + pitch * (count + r.uniform(0.5, 3)))
    if r.chance(0.2):
        places = [r.rounded(place + r.sign() * 2 * count * pitch) for place in places]
    if r.extreme and r.chance(0.3):
        places = [r.choice((first, last, places[0]))] * count
    shaft: Body = {"satellite_positions_mm": places, "bearing_positions_mm": [first, last]}
    if r.chance(0.5):
        shaft["satellite_mass_kg"] = r.size(0.1, 10)
        if r.chance(0.5):
            shaft["counterweights"] = [
                {
                    "unbalance_kg_mm": r.size(0.1, 100),
                    "position_mm": r.rounded(first + pitch * r.uniform(-1, count + 1)),
                    "angle_deg": r.choice((180.0, r.decimal(0, 360))),
                }
                for _ in range(r.randint(1, 2))
            ]
        if r.chance(0.5):
            shaft["rotor_mass_kg"] = r.size(0.1, 100)
    if r.chance(0.7):
        shaft["bearings"] = [{"kind": r.choice(("ball", "roller"))} for _ in range(2)]
        if "dynamic_rating_N" in bearing:
            shaft["bearings"][r.randint(0, 1)]["dynamic_rating_N"] = bearing["dynamic_rating_N"]
    return body | {"crankshaft": shaft}


def numbers(body: Body, answer: Any) -> Numbers:
    """Each bearing from the moments about the other; the turn narrowed and integrated."""
    own, load, shaft = (body[name] for name in ("mechanism", "load", "crankshaft"))
    u, e = ratio(own), typed(body["contact"]["eccentricity_mm"])
    rho, _ = ring_ratio(body["gear"], e, u)
    torque, speed = 1000 * typed(load["output_torque_Nm"]), typed(load["input_speed_rpm"])
    cranks = [mp.radians(each) for each in angles(own)]
    places = [typed(each) for each in shaft["satellite_positions_mm"]]
    first, last = (typed(each) for each in shaft["bearing_positions_mm"])
    arms = [
        [(other - z) / (other - here) for z in places]
        for here, other in ((first, last), (last, first))
    ]
    turn = ShaftTurn(own["pins"], cranks, typed(load["force_exponent"]))
    across, along = torque / (e * u), torque / typed(load["pin_circle_radius_mm"])
    exact: dict[str, mpf] = {}
    sizes: dict[str, mpf] = {}
    given = shaft.get("bearings") or [{"kind": "ball"}] * 2
    pulls = unbalances(shaft, e, cranks) if "satellite_mass_kg" in shaft else []
    for i, (held, bearing) in enumerate(zip(arms, given, strict=True)):
        other, here = (first, last) if i else (last, first)
        pull = -mp.fsum(u * (other - z) / (other - here) for u, z in pulls)
        pull *= (speed * mp.pi / 30) ** 2 / 1000
        p = mpf(3) if bearing["kind"] == "ball" else mpf(10) / 3
        peak, equivalent, sum_of_sizes = turn.reaction(
            held, across, along, rho, p, (pull.real, pull.imag)
        )
        place, sent = f"/bearings/{i}", answer["bearings"][i]
        exact |= {f"{place}/peak_N": peak, f"{place}/equivalent_N": equivalent}
        if not sent["peak_N"]:  # nothing but rounding
            sizes |= dict.fromkeys((f"{place}/peak_N", f"{place}/equivalent_N"), sum_of_sizes)
        elif "dynamic_rating_N" in bearing:
            million = 1_000_000 / (60 * speed)
            exact[f"{place}/basic_life_h"] = (
                million * (typed(bearing["dynamic_rating_N"]) / equivalent) ** p
            )
    if "satellite_mass_kg" in shaft:
        own_exact, own_sizes = balance(answer["balance"], shaft, e, cranks, speed)
        exact |= own_exact
        sizes |= own_sizes
    found: Numbers = {}
    for pointer, value in exact.items():
        sent = answer
        for name in pointer[1:].split("/"):
            sent = sent[int(name) if name.isdigit() else name]
        found[pointer] = Number(sent, value, sizes.get(pointer))
    return found


def unbalances(shaft: Body, e: mpf, cranks: list[mpf]) -> list[tuple[mpf, mpf]]:
    """Mass times radius of all that is off the axis, as complex numbers, kg*mm, and its place."""
    places = [typed(each) for each in shaft["satellite_positions_mm"]]
    found = [
        (typed(shaft["satellite_mass_kg"]) * e * mp.expj(crank), z)
        for crank, z in zip(cranks, places, strict=True)
    ]
    for each in shaft.get("counterweights", []):
        way = mp.expj(mp.radians(typed(each["angle_deg"])))
        found.append((typed(each["unbalance_kg_mm"]) * way, typed(each["position_mm"])))
    return found


def balance(
    sent: Any, shaft: Body, e: mpf, cranks: list[mpf], speed: mpf
) -> tuple[dict[str, mpf], dict[str, mpf]]:
    """Numbers of the balance, and the sums of sizes that they are made of."""
    masses = unbalances(shaft, e, cranks)
    first, last = (typed(each) for each in shaft["bearing_positions_mm"])
    per_kg_mm = (speed * mp.pi / 30) ** 2 / 1000
    left, size = abs(mp.fsum(u for u, _ in masses)), mp.fsum(abs(u) for u, _ in masses)
    couple = abs(mp.fsum(u * (z - (first + last) / 2) for u, z in masses))
    couples = mp.fsum(abs(u) * (abs(z - first) + abs(last - z)) / 2 for u, z in masses)
    rotor = typed(shaft.get("rotor_mass_kg", 0)) or len(cranks) * typed(shaft["satellite_mass_kg"])
    exact = {
        "/balance/unbalance_kg_mm": left,
        "/balance/force_N": left * per_kg_mm,
        "/balance/couple_Nm": couple * per_kg_mm / 1000,
        "/balance/grade_mm_per_s": left * speed * mp.pi / 30 / rotor,
    }
    sizes = {
        "/balance/unbalance_kg_mm": size,
        "/balance/force_N": size * per_kg_mm,
        "/balance/couple_Nm": couples * per_kg_mm / 1000,
        "/balance/grade_mm_per_s": size * speed * mp.pi / 30 / rotor,
    }
    for i, (here, other) in enumerate(((first, last), (last, first))):
        held = [(other - z) / (other - here) for _, z in masses]
        needed = -mp.fsum(arm * u for arm, (u, _) in zip(held, masses, strict=True))
        every = mp.fsum(abs(arm * u) for arm, (u, _) in zip(held, masses, strict=True))
        exact[f"/balance/bearing_force_N/{i}"] = abs(needed) * per_kg_mm
        sizes[f"/balance/bearing_force_N/{i}"] = every * per_kg_mm
        place = f"/balance/corrections/{i}"
        exact[f"{place}/unbalance_kg_mm"], sizes[f"{place}/unbalance_kg_mm"] = abs(needed), every
        # the angle nearest to that sent; off by the part of the sum at a right angle to it
        angle, turned = mp.degrees(mp.arg(needed)), typed(sent["corrections"][i]["angle_deg"])
        exact[f"{place}/angle_deg"] = angle + 360 * mp.nint((turned - angle) / 360)
        sizes[f"{place}/angle_deg"] = mp.degrees(every / abs(needed)) if needed else mp.inf
        if not sent["corrections"][i]["unbalance_kg_mm"]:
            sizes[f"{place}/angle_deg"] = mp.inf
    return exact, sizes


CRANKSHAFT = Calculation("Crankshaft", "crankshaft", request, numbers, one_in=20)
