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
    for i, (held, bearing) in enumerate(zip(arms, given, strict=True)):
        p = mpf(3) if bearing["kind"] == "ball" else mpf(10) / 3
        peak, equivalent, sum_of_sizes = turn.reaction(held, across, along, rho, p)
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
        own_exact, own_sizes = balance(answer["balance"], shaft, e, cranks, arms, speed)
        exact |= own_exact
        sizes |= own_sizes
    found: Numbers = {}
    for pointer, value in exact.items():
        sent = answer
        for name in pointer[1:].split("/"):
            sent = sent[int(name) if name.isdigit() else name]
        found[pointer] = Number(sent, value, sizes.get(pointer))
    return found


def balance(
    sent: Any, shaft: Body, e: mpf, cranks: list[mpf], arms: list[list[mpf]], speed: mpf
) -> tuple[dict[str, mpf], dict[str, mpf]]:
    """Numbers of the balance, and the sums of sizes that they are made of."""
    unbalances = [typed(shaft["satellite_mass_kg"]) * e * mp.expj(crank) for crank in cranks]
    first, last = (typed(each) for each in shaft["bearing_positions_mm"])
    per_kg_mm = (speed * mp.pi / 30) ** 2 / 1000
    lever = [typed(z) - (first + last) / 2 for z in shaft["satellite_positions_mm"]]
    left, size = abs(mp.fsum(unbalances)), mp.fsum(map(abs, unbalances))
    couple = abs(mp.fsum(u * z for u, z in zip(unbalances, lever, strict=True)))
    couples = mp.fsum(
        abs(u) * sum(abs(arm[j]) for arm in arms) * (last - first) / 2
        for j, u in enumerate(unbalances)
    )
    exact = {
        "/balance/unbalance_kg_mm": left,
        "/balance/force_N": left * per_kg_mm,
        "/balance/couple_Nm": couple * per_kg_mm / 1000,
    }
    sizes = {
        "/balance/unbalance_kg_mm": size,
        "/balance/force_N": size * per_kg_mm,
        "/balance/couple_Nm": couples * per_kg_mm / 1000,
    }
    for i, held in enumerate(arms):
        needed = -mp.fsum(arm * u for arm, u in zip(held, unbalances, strict=True))
        every = mp.fsum(abs(arm * u) for arm, u in zip(held, unbalances, strict=True))
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
