"""Worked steps of the satellites' bearings, of the crankshaft and of its balance."""

from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.crank.balance import Balance, carried
from core.crank.bearing_life import EXPONENTS
from core.crank.satellite_bearing import SatelliteBearings, made_parts
from core.design.results import Results
from core.errors import NotKnown, if_known
from core.numerics.extremes import first_largest
from core.precision import AS_TYPED
from core.worked.members import take_speed, take_torque
from core.worked.pins import static_step
from core.worked.step import Sheet, Step

MOST_SATELLITES = 4
"""Satellites whose forces on the crankshaft are worked."""

LOADS = "T R e u K_alpha rho F_c"
"""Numbers from which the loads of the cranks follow over the turn."""

IN_RADIANS = {"note": "turns_in_radians"}


def _sheet(results: Results, found: object, at: int | None = None) -> Sheet:
    """Sheet on which torque, sizes, ratio and speed are known."""
    sheet, design = Sheet(found, at), results.design
    take_torque(sheet, members=design.members, output_torque=design.output_torque)
    sheet.read(design, R="pin_circle_radius")
    sheet.read(design.contact, e="eccentricity")
    sheet.read(design.mechanism, u="ratio")
    sheet.take("K_alpha", "distribution_factor", design.disc_factor)
    return sheet


def _centrifugal(sheet: Sheet, results: Results, speed: str) -> None:
    """Add the centrifugal force of a satellite, if its mass is known, by the speed of the crank."""
    if results.crank.centrifugal:
        sheet.read(results.design.crankshaft, m="satellite_mass")
        formula, force = f"m*e*{speed}^2", results.crank.centrifugal
        sheet.work("centrifugal_force", "F_c", formula, force, **IN_RADIANS)


def _life(sheet: Sheet, rating: float | None, value: float | None, load: str, speed: str) -> None:
    """Add the basic life of a bearing of exponent p under its equivalent load."""
    sheet.take("C", "dynamic_rating", rating)
    formula = f"1000000*2*pi/{speed}*(C/{load})^p"
    sheet.work("basic_life", "L_10", formula, value, source="iso281", **IN_RADIANS)


def _ring(sheet: Sheet, results: Results, found: SatelliteBearings) -> None:
    """Add the ring's force along the crank over that across it."""
    gear, ratio = results.design.gear, float(found.radial_force_ratio)
    ideal = float(results.ring.force.radial_force_ratio)
    if abs(ratio - ideal) > AS_TYPED * abs(ideal):
        sheet.state("radial_force_ratio", "rho", "mean_of_mesh", value=ratio)
    elif gear.kind == "cycloid":
        sheet.read(gear, R_p="ring_pin_circle_radius")
        known = sheet.known
        k = known["e"].value * (known["u"].value + 1) / known["R_p"].value
        sheet.work("shortening", "k", "e*(u+1)/R_p", k)
        sheet.state("radial_force_ratio", "rho", "shortened", "k", ratio)
    elif gear.kind == "involute":
        sheet.read(gear, m="module", z_d="teeth_difference", alpha="reference_pressure_angle")
        sheet.work("operating_pressure_angle", "alpha_w", "acos(m*z_d*cos(alpha)/(2*e))")
        formula = "sqrt((2*e/(m*z_d*cos(alpha)))^2-1)"
        sheet.work("radial_force_ratio", "rho", formula, ratio)
    else:
        sheet.state("radial_force_ratio", "rho", "given", value=ratio)


def bearing_steps(results: Results) -> list[Step]:
    """Steps of the bearing that is loaded most."""
    design, found = results.design, results.crank.bearings
    bearing, j = design.bearing, first_largest(found.equivalent_load)
    sheet, where = _sheet(results, found, j), {"params": {"satellite": j + 1}}
    take_speed(sheet, results=results)
    sheet.work("relative_speed", "n", "n_1*(1+1/u)", found.given_speed)
    _ring(sheet, results, found)
    turning = design.members.output in ("pins", "coupling")
    _centrifugal(sheet, results, "n_1" if turning else "n_in")
    sheet.state("peak_load", "Q_max", "bearing_load", LOADS, **where)
    sheet.state("min_load", "Q_min", "bearing_load", LOADS, **where)
    sheet.state("peak_ring_force", "F_r", "ring_load", "T e u K_alpha rho", **where)
    sheet.take("p", "exponent", EXPONENTS[bearing.kind])
    sheet.state("equivalent_load", "P", "equivalent_load", "Q_min Q_max p", **where)
    with suppress(NotKnown):
        _life(sheet, bearing.dynamic_rating, found.basic_life[j], "P", "n")
        percent = {"params": {"percent": bearing.reliability_percent}}
        sheet.state("life", "L_n", "reliable", "L_10", **percent)
    sheet.read(bearing, C_0="static_rating")
    safety = if_known(lambda: found.static_safety_factor[j])
    said: dict[str, Any] = {
        "code": "static_rating_safety",
        "symbol": "S_0",
        "source": "iso76",
        "value": safety,
    }
    if results.crank.centrifugal:  # which the load at rest has none of
        sheet.state(method="under_peak", of="C_0", **said)
    else:
        share = design.static_torque / design.pin_torque
        static_step(sheet, results=results, over=("C_0", "Q_max"), share=share, **said)
    sheet.state("system_life", "L_s", "together", "L_n")
    return sheet.steps


def shaft_steps(results: Results) -> list[Step]:
    """Steps of the crankshaft: reactions, lives, balance."""
    design, found = results.design, results.crank.shaft
    shaft, speeds, sheet = design.crankshaft, design.known_speeds, _sheet(results, found)
    sheet.take("n_1", "input_speed", speeds.crank)
    sheet.read(results.ring.on_crank, rho="radial_force_ratio")
    for letter, place in zip("AB", shaft.bearing_positions, strict=True):
        sheet.take(f"z_{letter}", "bearing_position", place)
    for j, place in enumerate(shaft.satellite_positions, 1):
        sheet.take(f"z_{j}", "satellite_position", place)
    _centrifugal(sheet, results, "n_1")
    for i, letter in enumerate("AB"):
        _reaction(sheet, results, i)
        of, peak = f"X_{letter} Y_{letter} z_A z_B", found.peak_reaction[i]
        sheet.state("peak", f"R_{letter}", "reaction", of, peak)
        kind = shaft.bearings[i].kind if shaft.bearings else "ball"
        sheet.take("p", "exponent", EXPONENTS[kind])
        load, equivalent = f"P_{letter}", found.equivalent_reaction[i]
        sheet.state("equivalent", load, "equivalent_reaction", f"R_{letter} p", equivalent)
        if shaft.bearings:
            bearing, speed = shaft.bearings[i], "n_1"
            if bearing.seat != "housing":
                speed = f"n_{letter}"
                sheet.take(speed, "bearing_speed", speeds.against(bearing.seat))
            life = found.basic_life.get(i)
            _life(sheet, bearing.dynamic_rating, life, load, speed)
    if found.balance:
        _balance(sheet, results, found.balance)
    return sheet.steps


def _take_cranks(sheet: Sheet, angles: Sequence[float]) -> None:
    """Let the angles of the cranks be known."""
    for j, angle in enumerate(angles, 1):
        sheet.take(f"alpha_{j}", "crank_angle", angle)


def _reaction(sheet: Sheet, results: Results, i: int) -> None:
    """Add the parts of the largest reaction of a bearing, by moments about the other."""
    design, balance = results.design, results.crank.shaft.balance
    if design.disc_factor != 1 or design.mechanism.satellites > MOST_SATELLITES:
        return
    shaft, still = design.crankshaft, balance.reaction[i] if balance else 0j
    bearings = shaft.places["bearing_positions"]
    arms = carried(positions=shaft.satellite_positions, bearings=bearings)[i]
    cranks, loads = _loads(results, arms, still)
    whole = complex(arms * np.exp(1j * np.array(cranks)) @ loads) + still
    _take_cranks(sheet, cranks)
    letter, x, y = "AB"[i], [], []
    for j, load in enumerate(loads.tolist(), 1):
        said = {"params": {"satellite": j, "letter": letter}}
        sheet.state("across_force", f"W_{j}", "crank_load", "T e u", load.imag, **said)
        sheet.state("along_force", f"Q_{j}", "crank_load", f"T R W_{j} rho", load.real, **said)
        arm = f"(z_B-z_{j})" if i == 0 else f"(z_{j}-z_A)"
        x.append(f"{arm}*(Q_{j}*cos(alpha_{j})-W_{j}*sin(alpha_{j}))")
        y.append(f"{arm}*(Q_{j}*sin(alpha_{j})+W_{j}*cos(alpha_{j}))")
    for axis, own, part, terms in (
        ("X", still.real, whole.real, x),
        ("Y", still.imag, whole.imag, y),
    ):
        formula = f"({'+'.join(terms)})/(z_B-z_A)"
        if balance:
            sheet.state("reaction_part", f"U_{axis}", "unbalanced", "m e n_1", own)
            formula += f"+U_{axis}"
        sheet.work("reaction_part", f"{axis}_{letter}", formula, part, note="equilibrium")


def _loads(
    results: Results, arms: FloatArray, still: complex
) -> tuple[tuple[float, ...], ComplexArray]:
    """Angles of the cranks, and their loads, N, along + i*across, where a reaction is largest."""
    design, rho = results.design, float(results.ring.on_crank.radial_force_ratio)
    lever, largest = design.known_eccentricity * design.mechanism.ratio, []
    for turn in results.pin_load.turns(design.pin_torque):
        load = made_parts(turn=turn, arm=lever, radial_force_ratio=rho).load
        held = np.abs(arms * np.exp(1j * np.array(turn.crank_angles)) @ load + still)
        at = int(held.argmax())
        largest.append((float(held[at]), turn.crank_angles, load[:, at]))
    return max(largest, key=lambda each: each[0])[1:]


def _balance(sheet: Sheet, results: Results, balance: Balance) -> None:
    """Add unbalance, force and couple of what turns, and what balances it in A and B."""
    sheet.read(results.design.crankshaft, m="satellite_mass")
    _take_cranks(sheet, results.design.built.crank_angles)
    for index, weight in enumerate(results.design.crankshaft.counterweights, 1):
        sheet.take(f"U_w{index}", "unbalance", weight.unbalance)
        sheet.take(f"alpha_w{index}", "angle", weight.angle)
        sheet.take(f"z_w{index}", "counterweight_position", weight.position)
    of = "m e " + " ".join(name for name in sheet.known if name.startswith(("U_w", "alpha_")))
    sheet.state("unbalance", "U", "vectors", of, balance.unbalance)
    sheet.work("balance_force", "F", "U*n_1^2", balance.force, **IN_RADIANS)
    of += " " + " ".join(name for name in sheet.known if name.startswith("z_"))
    sheet.state("couple", "M", "vectors_couple", f"{of} n_1", balance.couple)
    sheet.take("M_r", "rotor_mass", results.design.rotor_mass)
    sheet.work("grade", "G", "U*n_1/M_r", balance.grade, **IN_RADIANS)
    for letter, each in zip("AB", balance.corrections, strict=True):
        said = {"params": {"letter": letter}}
        sheet.state("unbalance", f"U_{letter}", "carried", of, each.unbalance, **said)
        sheet.state("angle", f"alpha_{letter}", "opposite", f"U_{letter}", each.angle)
