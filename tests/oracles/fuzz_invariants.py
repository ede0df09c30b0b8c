"""Invariants of every answer of 200, by mechanics and not by the code's numbers.

Each check takes the request's body, the answer, and `ask`, which sends another request.
"""

import math
from collections.abc import Awaitable, Callable, Iterator
from itertools import pairwise
from typing import Any

Body = dict[str, Any]
Ask = Callable[[str, Body], Awaitable[Body | None]]

ROUNDING = 1e-13
"""Relative room for the rounding of the checks' own sums."""

CURVE_ROUNDING = 5e-12
"""Half of the last of the 12 digits to which forces of curves are given, at most."""


def expect(true: bool, what: str, *numbers: object) -> None:
    """Say which invariant broke."""
    if not true:
        raise AssertionError(f"{what}: {', '.join(map(repr, numbers))}")


def equal(a: float, b: float, what: str, error: float = 0.0, size: float = 0.0) -> None:
    """Two numbers are one up to an error, relative to them or to the size of what cancels."""
    room = (error + ROUNDING) * max(abs(a), abs(b), size) + 1e-300
    expect(abs(a - b) <= room, what, a, b, error)


def accuracies(answer: Any) -> Iterator[Body]:
    """Every statement of accuracy in an answer."""
    if isinstance(answer, dict):
        if "accuracy" in answer:
            yield answer["accuracy"]
        for value in answer.values():
            yield from accuracies(value)


def check_accuracy(answer: Body) -> None:
    """Stated errors and costs are numbers that make sense."""
    for stated in accuracies(answer):
        expect(0 <= stated["relative_error"] < math.inf, "stated error", stated)
        expect(stated["evaluations"] >= 0 and stated["run_time_us"] >= 0, "cost", stated)


def crank_angles(body: Body) -> list[float]:
    """Crank angle of every satellite, degrees."""
    if body.get("crank_angles_deg") is not None:
        return list(body["crank_angles_deg"])
    satellites = body.get("satellites", 2)
    spacing = body.get("crank_spacing_deg")
    spacing = 360 / satellites if spacing is None else spacing
    return [j * spacing for j in range(satellites)]


def ratio(body: Body) -> float:
    """Ratio, given or from the teeth."""
    if body.get("ratio") is not None:
        return float(body["ratio"])
    return body["satellite_teeth"] / (body["ring_teeth"] - body["satellite_teeth"])


def cosines(body: Body, crank_deg: float) -> list[list[float]]:
    """Cosine of the angle between force and tangent, -sin(psi + theta), of every pair."""
    psi = crank_deg * (1 + 1 / ratio(body)) + body.get("initial_crank_angle_deg", 0.0)
    return [
        [
            -math.sin(math.radians(math.fmod(psi + angle + 360 * n / body["pins"], 360)))
            for n in range(body["pins"])
        ]
        for angle in crank_angles(body)
    ]


async def cyclogram(body: Body, answer: Body, ask: Ask) -> None:
    """Counts lie between least and most; the intervals of the pairs add up to the counts."""
    counts = answer["driving_count"]
    least, most, mean = (answer[f"{name}_driving"] for name in ("min", "max", "mean"))
    pairs = body["pins"] * len(crank_angles(body))
    expect(least <= mean <= most, "least <= mean <= most", least, mean, most)
    expect(mean == pairs / 2, "half of the pairs drive on average", mean, pairs)
    expect(all(least <= each["pairs"] <= most for each in counts), "counts", least, most)
    total = 360 * body.get("revolutions", 1.0)
    edges = [counts[0]["from_deg"], *(each["to_deg"] for each in counts)]
    expect(edges[0] == 0 and edges == sorted(edges), "counts from 0 on", edges[:4])
    joined = all(a["to_deg"] == b["from_deg"] for a, b in pairwise(counts))
    expect(joined, "counts without holes")
    equal(edges[-1], total, "counts over the range")
    driven = sum(b - a for pair in answer["pairs"] for a, b in pair["driving_deg"])
    counted = sum((each["to_deg"] - each["from_deg"]) * each["pairs"] for each in counts)
    intervals = len(counts) + sum(len(pair["driving_deg"]) for pair in answer["pairs"])
    error = answer["accuracy"]["relative_error"] + 2e-16 * intervals
    equal(driven, counted, "lengths of the driving intervals", error, total * pairs)
    if body.get("revolutions", 1.0) == 1.0:
        period = answer["period_deg"]
        slack = pairs * min(period, total)
        expect(abs(driven - mean * total) <= slack / 2, "mean", driven, mean * total)
    centres = answer["dead_centres_deg"]
    expect(all(0 <= each <= total * (1 + 1e-15) for each in centres), "dead centres", centres[:4])
    expect(
        least > 0 or bool(centres) or "dead_zones_deg" in answer or total < 360, "no dead centre"
    )


async def contact_force(body: Body, answer: Body, ask: Ask) -> None:
    """Equilibrium of the torque, curves below the peak, twice the torque twice the peak."""
    error = answer["accuracy"]["relative_error"]
    peak, reference = answer["peak_force_N"], answer["reference_force_N"]
    torque = body.get("output_torque_Nm")
    if torque is None:
        torque = body["input_torque_Nm"] * body["efficiency"] * ratio(body)
    elif body.get("output") == "ring":  # of which the pins bear so much
        torque *= ratio(body) / (ratio(body) + 1)
    equal(reference, torque / (body["pin_circle_radius_mm"] / 1e3), "F0 = T/R")
    equal(peak, reference * answer["peak_force_ratio"], "peak = F0 * ratio")
    pairs = body["pins"] * len(crank_angles(body))
    expect(peak >= reference / pairs * (1 - error - ROUNDING), "peak below even sharing", peak)
    if "curves" in answer:
        exponent = body.get("force_exponent", 1.0)
        curves = answer["curves"]
        for i, angle in enumerate(curves["crank_angle_deg"]):
            forces = [curve[i] for curve in curves["force_N"]]
            expect(min(forces) >= 0, "force below 0", angle, min(forces))
            highest = peak * (1 + error + CURVE_ROUNDING)
            expect(max(forces) <= highest, "force above the peak", angle,
                   max(forces), peak)  # fmt: skip
            flat = [each for row in cosines(body, angle) for each in row]
            moment = sum(force * cosine for force, cosine in zip(forces, flat, strict=True))
            turns = angle * (1 + 1 / ratio(body)) + 7200
            noise = 2e-16 * turns * (1 + exponent) * sum(forces) / reference
            noise += CURVE_ROUNDING * peak * len(forces) / reference
            equal(moment, reference, "torque of the pins", noise)
    if torque < 1e11 and "output_torque_Nm" in body:
        plain = {key: value for key, value in body.items() if key != "include"}
        twice = await ask(
            "contact-force", plain | {"output_torque_Nm": 2 * body["output_torque_Nm"]}
        )
        expect(twice is not None, "twice the torque is refused")
        equal(twice["peak_force_N"], 2 * peak, "twice the torque")


async def hertz(body: Body, answer: Body, ask: Ask) -> None:
    """The pressure carries the force; it grows with the root of the force."""
    error = answer["accuracy"]["relative_error"]
    load = body["force_N"] / body["contact_length_mm"]
    load *= body.get("dynamic_factor", 1.0) * body.get("distribution_factor", 1.0)
    pressure, half_width = answer["max_pressure_MPa"], answer["half_width_mm"]
    equal(load, math.pi / 2 * pressure * half_width, "force of the pressure", 4 * error)
    equal(answer["mean_pressure_MPa"], math.pi / 4 * pressure, "mean pressure")
    equal(answer["half_width_ratio"], half_width / body["pin_radius_mm"], "a/r")
    if 0 < body["force_N"] <= 2.5e14:
        four = await ask("hertz", body | {"force_N": 4 * body["force_N"]})
        expect(four is not None, "four times the force is refused")
        equal(four["max_pressure_MPa"], 2 * pressure, "pressure ~ sqrt(F)", error)
        equal(four["half_width_mm"], 2 * half_width, "half-width ~ sqrt(F)", error)


async def crank_planetary(body: Body, answer: Body, ask: Ask) -> None:
    """Every section is what its own endpoint gives; forces at an angle carry the torque."""
    usual = ["cyclogram"]
    if "load" in body:
        usual += ["contact_force", *(["hertz"] if "contact" in body else [])]
    asked = {*body.get("include", usual)}
    verdict = {"verdict", "governing", "torque_reserve", "largest_torque_Nm", "counts"}
    said = {"warnings", "assumed", "fit", "not_considered", *verdict}
    said |= {"parts", "model", "largest_torque_of", "shares", "cold_yield"}
    if "include" not in body:
        said |= {"load_sharing", "pin_strength", "output_efficiency", "satellite_bearing"}
        said |= {"crankshaft", "rollers", "members", "ring_mesh"}
    unknown = (
        asked - set(answer) - {"largest_torque"}
    )  # a section that nobody named, of forces that cannot be solved
    unsolved = unknown == {"hertz"} and "include" not in body and answer["verdict"] != "pass"
    # Forces of parts that cannot be put together are not stated.
    if unknown and answer["verdict"] == "fail":
        judged = await ask("crank-planetary", body | {"include": ["checks"]}) or {"checks": []}
        unsolved |= "cannot_be" in {each.get("reason", {}).get("code") for each in judged["checks"]}
    expect(set(answer) - said <= asked and (unsolved or not unknown), "sections", list(answer))
    if "cyclogram" in answer:
        await cyclogram(body["mechanism"], answer["cyclogram"], ask)
    mechanism = {key: value for key, value in body["mechanism"].items() if key != "revolutions"}
    if "contact_force" in answer:
        force, load = answer["contact_force"], dict(body["load"])
        if load.pop("torque_direction", "driving") == "reverse":  # what would brake drives
            start = mechanism.get("initial_crank_angle_deg", 0.0)
            mechanism["initial_crank_angle_deg"] = start + (180 if start < 0 else -180)
        plain = {name: value for name, value in load.items() if name not in DESIGN_LOAD}
        await contact_force(mechanism | plain, force, ask)
        ideal = answer["model"] == "ideal"
        if ideal and "hertz" in answer and 1e-12 <= force["peak_force_N"] <= 1e15:
            apart = ("eccentricity_mm", "hole_clearance_mm")
            contact = {key: val for key, val in body["contact"].items() if key not in apart}
            given = body["contact"]
            if "hole_radius_mm" not in contact:  # of perfect parts
                hole = given["pin_radius_mm"] + given["eccentricity_mm"]
                contact["hole_radius_mm"] = hole + given.get("hole_clearance_mm", 0.0)
            alone = await ask("hertz", contact | {"force_N": force["peak_force_N"]})
            expect(alone is not None, "Hertz alone is refused")
            equal(alone["max_pressure_MPa"], answer["hertz"]["max_pressure_MPa"], "Hertz alone")
    for check in answer.get("checks", ()):
        judged = check["status"] in ("pass", "marginal", "fail")
        expect(("value" in check and "limit" in check) or not judged, "check", check)
        expect("reason" in check or check["status"] != "not_checked", "why not", check)
    if "checks" in answer and answer["verdict"] in ("pass", "marginal"):
        needed = [check for check in answer["checks"] if check.get("needed", True)]
        statuses = {check["status"] for check in needed}
        expect(not statuses & {"fail", "not_checked"}, "verdict", answer["verdict"])
    for pair in answer.get("geometry", {}).get("pairs", ()):
        expect(pair["force_N"] >= 0 and (pair["driving"] or not pair["force_N"]), "force", pair)


DESIGN_LOAD = (
    "input_speed_rpm",
    "torque_direction",
    "application_factor",
    "peak_torque_Nm",
    "peak_kind",
)
"""Fields of a load that only a design takes."""


async def output_efficiency(body: Body, answer: Body, ask: Ask) -> None:
    """Energy, order of the efficiencies, curves between their extremes, the force of its own."""
    error = answer["accuracy"]["relative_error"]
    loss, power, efficiency = (
        answer[name] for name in ("mean_loss_W", "output_power_W", "efficiency")
    )
    equal(efficiency, power / (power + loss), "output over output and loss", error)
    least, largest = answer["min_efficiency"], answer["max_efficiency"]
    room = error + ROUNDING
    expect(0 < least <= efficiency * (1 + room), "least efficiency", least, efficiency)
    expect(efficiency <= largest * (1 + room) <= 1 + 2 * room, "largest", efficiency, largest)
    real = answer["forces"] == "real"
    expect(real or answer["mean_total_force_ratio"] >= 1 - room, "no pair has a lever above R")
    expect(answer["mean_pv_MPa_m_per_s"] <= answer["peak_pv_MPa_m_per_s"] * (1 + room), "pv")
    sleeve = body["friction"].get("sleeve", False)
    expect(("sleeve_speed_rpm" in answer) == sleeve, "sleeves")
    expect(("pin_wear_mm" in answer) == ("life_h" in body["friction"]), "wear")
    if "hole_wear_mm" in answer:
        sizes = body["contact"]
        hole, pin = sizes.get("hole_radius_mm"), sizes["pin_radius_mm"]
        if hole is None:
            hole = pin + sizes["eccentricity_mm"] + sizes.get("hole_clearance_mm", 0.0)
        equal(answer["hole_wear_mm"] * hole, answer["pin_wear_mm"] * pin, "wear")
    drawn = answer.get("curves", {}).get("efficiency", ())
    for value in drawn if body["load"].get("force_exponent", 1.0) else ():
        # equal sharing jumps where pairs switch, and just there neither of them drives
        expect(least * (1 - 1e-6) <= value <= largest * (1 + 1e-6), "curve", least, value, largest)
    if not real:
        load = {name: value for name, value in body["load"].items() if name not in DESIGN_LOAD}
        alone = await ask("contact-force", body["mechanism"] | load)
        expect(alone is not None, "the force alone is refused")
        peak = body["contact"].get("distribution_factor", 1.0) * alone["peak_force_N"]
        equal(peak, answer["peak_force_N"], "peak force", error)
    if loss > 0:
        slower = {
            **body["load"],
            "input_speed_rpm": max(1e-12, body["load"]["input_speed_rpm"] / 2),
        }
        half = await ask("output-efficiency", {**body, "load": slower})
        expect(half is not None, "half the speed is refused")
        equal(half["efficiency"], efficiency, "efficiency at half the speed", error)


async def satellite_bearing(body: Body, answer: Body, ask: Ask) -> None:
    """Order of the loads, their lives, and half of the loads under half of the torque."""
    error = answer["accuracy"]["relative_error"] + ROUNDING
    bearing = body["bearing"]
    p, rating = 3 if bearing["kind"] == "ball" else 10 / 3, bearing.get("dynamic_rating_N")
    for each in answer["satellites"]:
        least, most, mean = (each[f"{name}_load_N"] for name in ("min", "peak", "equivalent"))
        expect(0 <= least <= mean * (1 + error) <= most * (1 + 2 * error), "order", least, most)
        expect(("basic_life_h" in each) == (rating is not None), "life")
        if rating is not None:
            # may be too long or too short for a double
            millions = p * (math.log(rating) - math.log(mean)) + math.log(1e6 / 60)
            life = millions - math.log(answer["relative_speed_rpm"])
            expect(abs(math.log(each["basic_life_h"]) - life) < 1e-9 + 2 * error, "life", life)
    halved = await _halved("satellite-bearing", body, ask)
    if halved is not None and answer["forces"] == "ideal":
        for one, other in zip(answer["satellites"], halved["satellites"], strict=True):
            equal(one["equivalent_load_N"], 2 * other["equivalent_load_N"], "half torque", error)


async def crankshaft(body: Body, answer: Body, ask: Ask) -> None:
    """No reaction is above what the satellites put on it; half of it under half of the torque."""
    error = answer["accuracy"]["relative_error"] + ROUNDING
    shaft = body["crankshaft"]
    first, last = shaft["bearing_positions_mm"]
    loads = await ask(
        "satellite-bearing",
        {name: each for name, each in body.items() if name != "crankshaft"}
        | {"bearing": {"kind": "ball"}},
    )
    expect(loads is not None, "the loads alone are refused")
    spinning = "satellite_mass_kg" in shaft  # whose force no torque changes
    for each, other in zip(answer["bearings"], (last, first), strict=True):
        expect(each["equivalent_N"] <= each["peak_N"] * (1 + error), "equivalent", each)
        held = math.fsum(
            abs(other - z) / (last - first) * satellite["peak_load_N"]
            for z, satellite in zip(
                shaft["satellite_positions_mm"], loads["satellites"], strict=True
            )
        )
        room = 1 + 2 * error + loads["accuracy"]["relative_error"]
        if not spinning:
            expect(each["peak_N"] <= held * room, "reaction", each, held)
    expect(("balance" in answer) == ("satellite_mass_kg" in shaft), "balance")
    for each in answer.get("balance", {}).get("corrections", ()):
        expect(0 <= each["angle_deg"] < 360, "angle", each)
    halved = None if spinning else await _halved("crankshaft", body, ask)
    if halved is not None and answer["forces"] == "ideal":
        for one, other in zip(answer["bearings"], halved["bearings"], strict=True):
            equal(one["peak_N"], 2 * other["peak_N"], "half of the torque", error)


async def _halved(endpoint: str, body: Body, ask: Ask) -> Body | None:
    """The answer to half of the torque, where that is a torque."""
    torque = body["load"].get("output_torque_Nm", 0.0) / 2
    if torque < 1e-12:
        return None
    halved = await ask(endpoint, {**body, "load": {**body["load"], "output_torque_Nm": torque}})
    expect(halved is not None, "half of the torque is refused")
    return halved


async def load_sharing(body: Body, answer: Body, ask: Ask) -> None:
    """The forces carry the torque and push; the turn has the positions between its extremes."""
    load, radius = body["load"], body["load"]["pin_circle_radius_mm"] / 1e3
    torque = load.get("output_torque_Nm")
    if torque is None:
        torque = load["input_torque_Nm"] * load["efficiency"] * ratio(body["mechanism"])
    way = load.get("torque_direction", "driving")
    turn = answer.get("over_turn")
    for position in answer["positions"]:
        forces = [force for row in position["force_N"] for force in row]
        chosen = position.get("torque_direction", way)
        expect(chosen in ("driving", "reverse"), "direction", chosen)
        expect((way == "alternating") == ("torque_direction" in position), "which direction", way)
        largest, count = max(forces), sum(force > 0 for force in forces)
        expect(min(forces) >= 0 and position["loaded_pairs"] == count, "loaded", count)
        room = count * answer["accuracy"]["relative_error"] * largest * radius
        held = sum(position["satellite_torque_Nm"])
        signed = -torque if chosen == "reverse" else torque
        equal(held, signed, "torque", size=sum(forces) * radius + room / ROUNDING)
        expect(position["stiffness_Nm_per_arcmin"] > 0, "stiffness")
        if "play_arcmin" in position:
            low, high = position["play_arcmin"]
            expect(low <= high + 1e-10, "play", low, high)
        else:
            expect("interference_mm" in position, "pressed")
        if turn:
            room = 1 + answer["accuracy"]["relative_error"] + 1e-6
            expect(largest <= turn["peak_force_N"] * room, "peak", largest, turn["peak_force_N"])
    if turn:
        expect(0 <= turn["backlash_min_arcmin"] <= turn["backlash_max_arcmin"], "backlash")
        expect(turn["loaded_pairs_min"] <= turn["loaded_pairs_max"], "loaded pairs")


async def fit(body: Body, answer: Body, ask: Ask) -> None:
    """The state is that of the extremes, positions lie between them, discs alone have more room."""
    own = answer["fit"]
    if own["state"] == "no_bound":
        expect("least_room_mm" not in own and "positions" not in answer, "bound", own)
        return
    least, greatest = own["least_room_mm"], own["greatest_room_mm"]
    error = 1e-9 * hole_of(body)
    nothing = 1e-8 * (body["contact"]["pin_radius_mm"] + body["contact"]["eccentricity_mm"])
    expect(least <= greatest + error, "extremes", least, greatest)
    if own["state"] == "fits":
        expect(least >= -nothing, "fits", least)
    else:
        expect(least < 0, "does not fit", least)
        needed = own["needed_hole_radius_mm"]
        equal(needed + least, hole_of(body), "hole", 1e-9, size=needed)
        jams = own["state"] == "binds_in_turning"
        expect((greatest >= -nothing) if jams else (greatest < 0), own["state"], greatest)
    for position in answer["positions"]:
        room = position["room_mm"]
        expect(least - error <= room <= greatest + error, "room", least, room, greatest)
        expect(("window_arcmin" in position) == (room >= 0), "window", room)
        low, high = position.get("window_arcmin", (0, 0))
        expect(low <= high, "window", low, high)
    for disc in own.get("discs", ()):
        expect(disc["least_room_mm"] >= least - 2 * error, "disc", disc, least)


def hole_of(body: Body) -> float:
    """Radius of the holes, mm."""
    own = body["contact"]
    if own.get("hole_radius_mm") is not None:
        return float(own["hole_radius_mm"])
    return float(own["pin_radius_mm"] + own["eccentricity_mm"] + own.get("hole_clearance_mm", 0.0))


async def pin_strength(body: Body, answer: Body, ask: Ask) -> None:
    """Stresses of one section, the cycle within its largest moment, the force of its own."""
    error = answer["accuracy"]["relative_error"]
    room = 1 + error + 1e-9
    bending, shear = answer["peak_bending_stress_MPa"], answer["peak_shear_stress_MPa"]
    most = answer["peak_equivalent_stress_MPa"]
    expect(most * room >= bending, "equivalent below bending", most, bending)
    expect(most <= math.hypot(bending, math.sqrt(3) * shear) * room, "equivalent above the sum")
    if "fatigue" in answer:
        cycle = answer["fatigue"]
        expect(cycle["max_stress_MPa"] <= bending * room, "stress above the largest", cycle)
        expect(-cycle["min_stress_MPa"] <= bending * room, "stress below the largest", cycle)
        expect(cycle["safety_factor"] > 0, "safety", cycle)
    if answer["forces"] == "real":
        return
    torque = {key: val for key, val in body["load"].items() if key not in DESIGN_LOAD}
    force = await ask("contact-force", body["mechanism"] | torque)
    expect(force is not None, "the force alone is refused")
    factor = body["load"].get(
        "application_factor", body.get("contact", {}).get("dynamic_factor", 1)
    )
    own = force["peak_force_N"] * factor
    equal(own, answer["peak_force_N"], "force of its own", error)


async def tolerance_study(body: Body, answer: Body, ask: Ask) -> None:
    """Shares are shares, percentiles lie within their intervals, in order."""
    samples, fits = answer["samples"], answer["fits"]
    expect(samples == body.get("samples", 200) and 0 <= fits <= samples, "pieces", fits, samples)
    equal(answer["cannot_assemble"]["value"], 1 - fits / samples, "cannot be assembled")
    limits = body.get("limits") or {}
    wanted = dict.fromkeys([*body.get("quantities", answer["quantities"]), *limits])
    expect(list(answer["quantities"]) == list(wanted), "quantities", list(wanted))
    shares = [answer["cannot_assemble"]]
    for name, quantity in answer["quantities"].items():
        nothing = {"nominal": 0.0, "mean": 0.0}  # where it does not fit, or none does
        below = any((nothing | quantity)[each] < 0 for each in nothing)
        expect(not below and (fits == 0) == ("mean" not in quantity), "below 0", name)
        values = [each["value"] for each in sorted(quantity["percentiles"], key=_percent)]
        expect(values == sorted(values), "percentiles in order", name, values)
        for each in quantity["percentiles"]:
            expect(each["low"] <= each["value"] <= each["high"], "interval", name, each)
        if "yield" in quantity:
            shares.append(quantity["yield"])
            expect(quantity["yield"]["value"] <= fits / samples + ROUNDING, "yield", name)
    for each in shares:
        expect(0 <= each["low"] <= each["value"] <= each["high"] <= 1, "share", each)
    if samples <= 3:
        again = await ask("tolerance-study", body)
        expect(again is not None and again["quantities"] == answer["quantities"], "the same")


def _percent(percentile: Body) -> float:
    number: float = percentile["percent"]
    return number


async def roller_strength(body: Body, answer: Body, ask: Ask) -> None:
    """The rollers' forces carry the torque and follow from one displacement."""
    error = answer["accuracy"]["relative_error"]
    forces, stiffness = answer["forces_N"], answer["stiffness_N_per_mm"]
    total = body["output_torque_Nm"] / (2 * body["hole_circle_radius_mm"] / 1e3)
    equal(math.fsum(forces), total, "sum of the forces", error)
    equal(answer["mean_force_N"] * body["rollers"], total, "mean force")
    equal(answer["max_force_N"], max(forces), "largest force")
    equal(answer["load_nonuniformity"] * answer["mean_force_N"], max(forces), "Psi", error)
    expect(min(forces) >= 0, "force below 0", min(forces))
    expect(answer["loaded_rollers"] == sum(force > 0 for force in forces), "loaded rollers", forces)
    cycle = answer.get("fatigue")
    if cycle is not None:
        expect("fatigue" in body and cycle["safety_factor"] > 0, "fatigue where asked", cycle)
        least = -cycle["max_stress_MPa"] if body.get("roller_rotates", False) else 0.0
        expect(cycle["min_stress_MPa"] == least, "cycle", cycle)
    if body.get("gaps_mm") is not None:
        for gap, force in zip(body["gaps_mm"], forces, strict=True):
            expected = stiffness * max(0.0, answer["displacement_mm"] - gap)
            size = stiffness * max(abs(answer["displacement_mm"]), abs(gap))
            equal(force, expected, "force = c*(displacement - gap)", error, size)
    if body["output_torque_Nm"] <= 5e11 and not any(body.get("gaps_mm") or [body.get("gaps_mm")]):
        twice = await ask(
            "roller-strength", body | {"output_torque_Nm": 2 * body["output_torque_Nm"]}
        )
        expect(twice is not None, "twice the torque is refused")
        expect(twice["max_force_N"] >= max(forces), "more torque, less force", twice["max_force_N"])


async def contact_line(body: Body, answer: Body, ask: Ask) -> None:
    """Lengths add up, are at least the working length, and those of two halves are the whole."""
    error = answer["accuracy"]["relative_error"]
    lines = answer["lines"]
    equal(answer["total_length_mm"], math.fsum(each["length_mm"] for each in lines), "total")
    for line in lines:
        along = abs(line["z_max_mm"] - line["z_min_mm"])
        size = max(abs(line["z_max_mm"]), abs(line["z_min_mm"]), along)
        room = line["length_mm"] * error + 1e-15 * size
        expect(line["length_mm"] >= along - room, "shorter than straight", line)
        if "points" in line:
            drawn = {len(values) for values in line["points"].values()}
            expect(drawn == {body.get("samples", 61)}, "samples", drawn)
    first = (body.get("rollers") or [{}])[0]
    if first.get("z_min_mm") is None:
        return
    low, high = first["z_min_mm"], first["z_max_mm"]
    middle = low + (high - low) * 0.375
    if high - low <= 1e-14 * max(-low, high) or 0 < abs(middle) < 1e-12:
        return  # nothing is left between the ends, or an end would be too small
    halves = [first | {"z_max_mm": middle}, first | {"z_min_mm": middle}]
    parts = await ask("precession/contact-line", body | {"rollers": halves, "include": []})
    expect(parts is not None, "half a line is refused", low, middle, high)
    both = error + parts["accuracy"]["relative_error"]
    equal(parts["total_length_mm"], lines[0]["length_mm"], "two halves", both * len(lines))


async def meshing_load(body: Body, answer: Body, ask: Ask) -> None:
    """The moment about the axis is the torque; no force along it; all grows with the torque."""
    error = answer["accuracy"]["relative_error"]
    equal(answer["moment_Nm"][2], body["torque_Nm"], "M_Cz = M1", error)
    expect(answer["force_N"][2] == 0, "force along the axis", answer["force_N"])
    if 0 < abs(body["torque_Nm"]) <= 5e11:
        twice = await ask("precession/meshing-load", body | {"torque_Nm": 2 * body["torque_Nm"]})
        expect(twice is not None, "twice the torque is refused")
        equal(twice["max_line_load_N_per_mm"], 2 * answer["max_line_load_N_per_mm"], "line load")
        for name in ("force_N", "moment_Nm"):
            for double, single in zip(twice[name], answer[name], strict=True):
                equal(double, 2 * single, f"twice the {name}")


async def shaft_deflection(body: Body, answer: Body, ask: Ask) -> None:
    """Reactions hold force and moment of the mesh."""
    own = {
        "bearing_distance_mm", "overhang_mm", "shaft_diameter_mm", "shaft_sections",
        "youngs_modulus_GPa", "yield_strength_MPa", "tensile_strength_MPa",
        "load_rotates_with_shaft", "fatigue", "line_contact",
    }  # fmt: skip
    mesh = await ask(
        "precession/meshing-load", {key: value for key, value in body.items() if key not in own}
    )
    expect(mesh is not None, "the load alone is refused")
    first, second = answer["reaction_B_N"], answer["reaction_C_N"]
    distance = body["bearing_distance_mm"] / 1e3
    for axis, (other, sign) in enumerate(((1, -1), (0, 1))):
        moment = mesh["moment_Nm"][other]
        equal(first[axis] * distance, sign * moment, "moment about C")
        size = max(abs(first[axis]), abs(mesh["force_N"][axis]))
        equal(first[axis] + second[axis], -mesh["force_N"][axis], "sum of forces", size=size)
    for name in ("deflection_B_mm", "deflection_C_mm"):
        equal(answer[name]["total"], math.hypot(answer[name]["x"], answer[name]["y"]), name)
    asked = {"yield_strength_MPa", "tensile_strength_MPa", "fatigue"} & {*body}
    expect(("strength" in answer) == bool(asked), "strength where asked", asked)
    expect(("line_contact" in answer) == ("line_contact" in body), "contact where asked")
    if "strength" in answer:
        held = math.hypot(*second) * distance
        equal(answer["strength"]["bending_moment_B_Nm"], held, "moment at B", 1e-12)
        cycle = answer["strength"].get("fatigue")
        if cycle is not None:
            expect(cycle["min_stress_MPa"] == -cycle["max_stress_MPa"], "reversed", cycle)


async def work_precision(body: Body, answer: Body, ask: Ask) -> None:
    """The default is among the methods, and no error or time is below 0."""
    expect(answer["chosen"] in answer["points"], "chosen")
    expect(all(each["relative_error"] >= 0 < each["run_time_us"] for each in answer["points"]),
           "points")  # fmt: skip


async def batch(body: Body, answer: Body, ask: Ask) -> None:
    """Every answer is what the request gets alone: refused, or the same numbers."""
    path = body["calculation"].replace("_", "-")
    if path in ("contact-line", "meshing-load", "shaft-deflection"):
        path = f"precession/{path}"
    expect(len(answer["results"]) == len(body["requests"]), "number of answers")
    for request, item in zip(body["requests"], answer["results"], strict=True):
        alone = await ask(path, request)
        expect(("result" in item) == (alone is not None), "refused alone or in the batch", request)
        if alone is None or "accuracy" not in alone:
            continue
        result = item["result"]
        expect(set(result) == set(alone), "names", set(result) ^ set(alone))
        error = result["accuracy"]["relative_error"] + alone["accuracy"]["relative_error"]
        for name, number in alone.items():
            if isinstance(number, float) and not name.endswith("_deg"):
                equal(number, result[name], f"{name} alone and in the batch", 2 * error)


INVARIANTS: dict[str, Callable[[Body, Body, Ask], Awaitable[None]]] = {
    "cyclogram": cyclogram,
    "contact-force": contact_force,
    "hertz": hertz,
    "crank-planetary": crank_planetary,
    "output-efficiency": output_efficiency,
    "fit": fit,
    "load-sharing": load_sharing,
    "pin-strength": pin_strength,
    "satellite-bearing": satellite_bearing,
    "crankshaft": crankshaft,
    "tolerance-study": tolerance_study,
    "roller-strength": roller_strength,
    "precession/contact-line": contact_line,
    "precession/meshing-load": meshing_load,
    "precession/shaft-deflection": shaft_deflection,
    "work-precision": work_precision,
    "batch": batch,
}
