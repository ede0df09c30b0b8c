"""Worked steps of the satellites' bearings, of the crankshaft and of its balance."""

import math
from contextlib import suppress
from typing import Literal

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.crank.balance import Balance
from core.crank.bearing_life import EXPONENTS, Bearing
from core.crank.satellite_bearing import SatelliteBearings
from core.design.results import Results
from core.errors import NotKnown, if_known
from core.output.sampled_turn import WAYS
from core.precision import AS_TYPED
from core.worked.members import take_speed, take_torque
from core.worked.pins import static_step
from core.worked.sharing import Shares, ideal_turn
from core.worked.step import MOST_TERMS, Sheet, Step, total
from core.worked.turn import IdealTurn, Measure, Position, first_largest, is_at

MOST_SATELLITES = 4
"""Satellites whose forces on the crankshaft are worked."""

LETTERS: tuple[Literal["A"], Literal["B"]] = ("A", "B")


def _take(sheet: Sheet, results: Results) -> None:
    """Let the load and what turns be known."""
    take_torque(
        sheet, members=results.design.members, output_torque=results.design.load.output_torque
    )
    sheet.take("R", "pin_circle_radius", results.design.load.pin_circle_radius)
    sheet.take("e", "eccentricity", results.design.contact.eccentricity)
    sheet.take("u", "ratio", results.design.mechanism.ratio)
    sheet.take("K_alpha", "distribution_factor", results.design.disc_factor)


def _centrifugal(sheet: Sheet, results: Results, speed: str) -> None:
    """Centrifugal force of a satellite, where its mass is known, by the speed of the crank."""
    if results.crank.centrifugal:
        sheet.take("m", "satellite_mass", results.design.crankshaft.satellite_mass)
        said = {"note": "turns_in_radians"}
        sheet.work("centrifugal_force", "F_c", results.crank.centrifugal, f"m*e*{speed}^2", **said)


def _life(
    sheet: Sheet, kind: Bearing, rating: float | None, value: float | None, load: str, speed: str
) -> None:
    """Basic life of a bearing of some rolling elements under its equivalent load."""
    sheet.take("C", "dynamic_rating", rating)
    sheet.take("p", "exponent", EXPONENTS[kind])
    formula = f"1000000*2*pi/{speed}*(C/{load})^p"
    sheet.work("basic_life", "L_10", value, formula, source="iso281", note="turns_in_radians")


class _Loads:
    """What the ideal forces do at the satellites: W across the crank, S of the pins, N."""

    def __init__(self, results: Results) -> None:
        design, torque = results.design, results.design.pin_torque
        self.across = torque / (design.known_eccentricity * design.mechanism.ratio)
        self.along = torque / design.load.pin_circle_radius
        self.factor, self.relief = design.disc_factor, results.crank.centrifugal

    def of(self, at: Position, satellite: int) -> tuple[FloatArray, FloatArray]:
        """W and S of a satellite, shape (n,): of the one that carries most."""
        across, along = self.factor * self.across, self.factor * self.along
        return across * at.share(satellite), along * at.pins(satellite)

    @property
    def inwards(self) -> str:
        """What a satellite presses along its crank, by its mark."""
        return "rho*W_#+S_#-F_c" if self.relief else "rho*W_#+S_#"

    def steps(self, sheet: Sheet, shares: Shares, satellite: int, torque: float) -> None:
        """Steps to W and S of a satellite at a position."""
        across, pins = (float(each[0]) for each in self.of(shares.at, satellite))
        index = satellite + 1
        share = float(shares.at.share(satellite)[0])
        sheet.work(
            "satellite_torque",
            f"T_{index}",
            self.factor * torque * share,
            f"K_alpha*T*{shares.share(satellite)}",
            note="alike",
        )
        sheet.work("across_force", f"W_{index}", across, f"T_{index}/(e*u)")
        formula = f"K_alpha*T/R*{shares.pins(satellite)}"
        sheet.work("pins_force", f"S_{index}", pins, formula, note="alike")


def _ring(sheet: Sheet, results: Results, found: SatelliteBearings) -> None:
    """The ring's force along the crank over that across it."""
    gear, ratio = results.design.gear, float(found.radial_force_ratio)
    ideal = float(results.ring.force.radial_force_ratio)
    if not math.isclose(ratio, ideal, rel_tol=AS_TYPED):
        sheet.state("radial_force_ratio", "rho", ratio, "mean_of_mesh")
        return
    if gear.kind == "cycloid":
        sheet.take("R_p", "ring_pin_circle_radius", gear.ring_pin_circle_radius)
        k = sheet.known["e"].value * (results.design.mechanism.ratio + 1) / sheet.known["R_p"].value
        sheet.work("shortening", "k", k, "e*(u+1)/R_p")
        sheet.state("logarithm", "l", 2 * math.atanh(k), "logarithm_of_shortening")
        # The series of small k loses no digits; the closed form is the same.
        closed = -(2 - (1 - k * k) / k * 2 * math.atanh(k)) / (math.pi * k)
        formula = "-(2-(1-k^2)/k*l)/(pi*k)"
        if math.isclose(closed, ratio, rel_tol=AS_TYPED):
            sheet.work("radial_force_ratio", "rho", ratio, formula, note="shortened")
        else:
            sheet.state("radial_force_ratio", "rho", ratio, "shortened")
        return
    if gear.kind != "involute":
        sheet.state("radial_force_ratio", "rho", ratio, "given")
        return
    sheet.take("m", "module", gear.module)
    sheet.take("z_d", "teeth_difference", gear.teeth_difference)
    sheet.take("alpha", "reference_pressure_angle", gear.reference_pressure_angle)
    angle, formula = found.operating_pressure_angle, "acos(m*z_d*cos(alpha)/(2*e))"
    sheet.work("operating_pressure_angle", "alpha_w", angle, formula)
    formula = "sqrt((2*e/(m*z_d*cos(alpha)))^2-1)"
    sheet.work("radial_force_ratio", "rho", ratio, formula)


def worst_bearing(found: SatelliteBearings) -> int:
    """The satellite, from 0, whose bearing has the largest equivalent load.

    Parameters
    ----------
    found : SatelliteBearings
        The bearings of one design.
    """
    most, loads = 0, found.equivalent_load.tolist()
    for index, load in enumerate(loads):
        if load > loads[most] * (1 + AS_TYPED):
            most = index
    return most


def bearing_steps(results: Results) -> list[Step]:
    """Steps of the bearing that is loaded most.

    Parameters
    ----------
    results : Results
        Results of a design with bearings.
    """
    sheet, bearing, found = Sheet(), results.design.bearing, results.crank.bearings
    _take(sheet, results)
    take_speed(sheet, results=results)
    sheet.work("relative_speed", "n", found.given_speed, "n_1*(1+1/u)")
    _ring(sheet, results, found)
    turning = results.design.members.output in ("pins", "coupling")
    _centrifugal(sheet, results, "n_1" if turning else "n_in")
    j = worst_bearing(found)
    where = {"params": {"satellite": j + 1}}
    turn = ideal_turn(sheet, results=results)
    peak, ring = float(found.peak_load[j]), float(found.peak_ring_force[j])
    if turn:
        _peak_load(sheet, results, turn, j, peak)
    else:
        sheet.state("peak_load", "Q_max", peak, "bearing_load", **where)
    sheet.state("min_load", "Q_min", found.min_load[j], "bearing_load", **where)
    if turn:
        _ring_force(sheet, results, turn, j, ring)
    else:
        sheet.state("peak_ring_force", "F_r", ring, "bearing_load", **where)
    sheet.state("equivalent_load", "P", found.equivalent_load[j], "equivalent_load", **where)
    with suppress(NotKnown):
        basic = float(found.basic_life[j])
        _life(sheet, bearing.kind, bearing.dynamic_rating, basic, "P", "n")
        percent = {"params": {"percent": bearing.reliability_percent}}
        sheet.state("life", "L_n", found.life[j], "reliable", **percent)
    sheet.take("C_0", "static_rating", bearing.static_rating)
    safety, said = if_known(lambda: float(found.static_safety_factor[j])), {"source": "iso76"}
    if results.crank.centrifugal:  # which the load at rest has none of
        sheet.state("static_rating_safety", "S_0", safety, "under_peak", **said)
    else:
        static_step(
            sheet,
            results=results,
            code="static_rating_safety",
            symbol="S_0",
            value=safety,
            limit="C_0",
            load="Q_max",
            share=results.design.static_torque / results.design.pin_torque,
            **said,
        )
    sheet.state("system_life", "L_s", if_known(lambda: found.system_life), "together")
    return sheet.steps


def _peak_load(sheet: Sheet, results: Results, turn: IdealTurn, j: int, peak: float) -> None:
    """The largest load of a bearing, of pins and ring together."""
    loads, rho = _Loads(results), sheet.known["rho"].value

    def size(at: Position) -> FloatArray:
        across, pins = loads.of(at, j)
        found: FloatArray = np.hypot(across, rho * across + pins - loads.relief)
        return found

    at, where = turn.worst(size), {"params": {"satellite": j + 1}}
    if not is_at(at, measure=size, value=peak):
        sheet.state("peak_load", "Q_max", peak, "bearing_load", **where)
        return
    loads.steps(sheet, Shares(sheet, turn, at), j, results.design.pin_torque)
    formula = f"sqrt(W_#^2+({loads.inwards})^2)".replace("#", str(j + 1))
    sheet.work("peak_load", "Q_max", peak, formula, note="bearing_load", **where)


def _ring_force(sheet: Sheet, results: Results, turn: IdealTurn, j: int, ring: float) -> None:
    """The largest force of the ring on the satellite."""
    loads, rho = _Loads(results), sheet.known["rho"].value

    def size(at: Position) -> FloatArray:
        return loads.of(at, j)[0] * math.hypot(1, rho)

    at = turn.worst(size)
    if not is_at(at, measure=size, value=ring):
        sheet.state("peak_ring_force", "F_r", ring, "bearing_load", params={"satellite": j + 1})
        return
    shares = Shares(sheet, turn, at)
    formula = f"K_alpha*T/(e*u)*{shares.share(j)}*sqrt(1+rho^2)"
    sheet.work("peak_ring_force", "F_r", ring, formula, note="alike")


def shaft_steps(results: Results) -> list[Step]:
    """Steps of the crankshaft: reactions, lives, balance.

    Parameters
    ----------
    results : Results
        Results of a design with a crankshaft.
    """
    sheet, shaft, found = Sheet(), results.design.crankshaft, results.crank.shaft
    _take(sheet, results)
    speeds = results.design.known_speeds
    sheet.take("n_1", "input_speed", speeds.crank)
    sheet.take("rho", "radial_force_ratio", results.ring.on_crank.radial_force_ratio)
    for letter, place in zip(LETTERS, shaft.bearing_positions, strict=True):
        sheet.take(f"z_{letter}", "bearing_position", place)
    _centrifugal(sheet, results, "n_1")
    turn = ideal_turn(sheet, results=results)
    for i, letter in enumerate(LETTERS):
        peak, equivalent = float(found.peak_reaction[i]), float(found.equivalent_reaction[i])
        if not turn or not _reaction(sheet, results, turn, i, peak):
            sheet.state("peak", f"R_{letter}", peak, "reaction")
        load = f"P_{letter}"
        sheet.state("equivalent", load, equivalent, "equivalent_reaction")
        if shaft.bearings:
            bearing, speed = shaft.bearings[i], "n_1"
            if bearing.seat != "housing":
                speed = f"n_{letter}"
                sheet.take(speed, "bearing_speed", speeds.against(bearing.seat))
            rating, life = bearing.dynamic_rating, found.basic_life.get(i)
            _life(sheet, bearing.kind, rating, life, load, speed)
    if found.balance:
        _balance(sheet, results, found.balance)
    return sheet.steps


def _summed(
    loads: _Loads, at: Position, arms: ComplexArray, rho: float, way: float, still: complex
) -> ComplexArray:
    """Reaction along and across the first crank: what the satellites do, each by its arm, and what
    counterweights do.
    """
    reaction = np.zeros(len(at.angle), dtype=complex)
    for j, arm in enumerate(arms):
        across, pins = loads.of(at, j)
        reaction += arm * (rho * across + pins - loads.relief + 1j * way * across)
    return reaction + still


def _reaction(sheet: Sheet, results: Results, turn: IdealTurn, i: int, peak: float) -> bool:
    """Reaction of a bearing by moments about the other; whether it is written out."""
    if peak == 0 or results.design.disc_factor != 1:  # which satellite carries most is chosen
        return False
    shaft, mechanism = results.design.crankshaft, results.design.built
    first, last = shaft.bearing_positions
    places = np.array(shaft.satellite_positions)
    carried = (last - places if i == 0 else places - first) / (last - first)
    cranks: ComplexArray = np.exp(1j * np.array(mechanism.crank_angles))
    loads, rho = _Loads(results), sheet.known["rho"].value
    weights = shaft.counterweights if loads.relief else ()
    still = 0j
    for each in weights:
        part = last - each.position if i == 0 else each.position - first
        pull = results.design.known_speed**2 * each.unbalance * part / (last - first)
        still -= pull * complex(math.cos(each.angle), math.sin(each.angle))

    def measure(way: float) -> Measure:
        return lambda at: np.abs(_summed(loads, at, carried * cranks, rho, way, still))

    ways = WAYS[results.design.load.torque_direction]
    tops = ((way, turn.worst(measure(way))) for way in ways)
    way, at = first_largest((float(measure(way)(at)[0]), (way, at)) for way, at in tops)
    written = is_at(at, measure=measure(way), value=peak)
    if not written or mechanism.satellites > MOST_SATELLITES:
        return False
    shares = Shares(sheet, turn, at)
    minus, plus = ("-", "+") if way > 0 else ("+", "-")
    along, across = [], []
    for j in range(mechanism.satellites):
        loads.steps(sheet, shares, j, results.design.pin_torque)
        n = j + 1
        sheet.take(f"z_{n}", "satellite_position", places[j])
        sheet.take(f"alpha_{n}", "crank_angle", mechanism.crank_angles[j])
        share = f"(z_B-z_{n})/(z_B-z_A)" if i == 0 else f"(z_{n}-z_A)/(z_B-z_A)"
        own, w, angle = f"({loads.inwards})".replace("#", str(n)), f"W_{n}", f"alpha_{n}"
        along.append(f"{share}*({own}*cos({angle}){minus}{w}*sin({angle}))")
        across.append(f"{share}*({own}*sin({angle}){plus}{w}*cos({angle}))")
    for mark in _weights(sheet, results) if weights else ():
        share = f"(z_B-z_{mark})/(z_B-z_A)" if i == 0 else f"(z_{mark}-z_A)/(z_B-z_A)"
        along.append(f"-{share}*U_{mark}*n_1^2*cos(alpha_{mark})")
        across.append(f"-{share}*U_{mark}*n_1^2*sin(alpha_{mark})")
    letter, whole = LETTERS[i], _summed(loads, at, carried * cranks, rho, way, still)
    reaction = complex(whole[0])
    for axis, part, terms in (("X", reaction.real, along), ("Y", reaction.imag, across)):
        formula = "+".join(terms).replace("+-", "-")
        sheet.work("reaction_part", f"{axis}_{letter}", part, formula, note="equilibrium")
    sheet.work("peak", f"R_{letter}", peak, f"sqrt(X_{letter}^2+Y_{letter}^2)")
    return True


def _weights(sheet: Sheet, results: Results) -> list[str]:
    """Let the counterweights be known; their marks."""
    marks = []
    for index, each in enumerate(results.design.crankshaft.counterweights, 1):
        marks.append(f"w{index}")
        sheet.take(f"U_w{index}", "unbalance", each.unbalance)
        sheet.take(f"alpha_w{index}", "angle", each.angle)
        sheet.take(f"z_w{index}", "counterweight_position", each.position)
    return marks


def _balance(sheet: Sheet, results: Results, balance: Balance) -> None:
    """Unbalance of what turns, force and couple, and what balances it in A and B."""
    shaft, cranks = results.design.crankshaft, results.design.built.crank_angles
    sheet.take("m", "satellite_mass", shaft.satellite_mass)
    marks = [str(j + 1) for j in range(len(cranks))]
    for mark, angle, place in zip(marks, cranks, shaft.satellite_positions, strict=True):
        sheet.take(f"alpha_{mark}", "crank_angle", angle)
        sheet.take(f"z_{mark}", "satellite_position", place)
    weights = _weights(sheet, results)
    many = len(cranks) + len(weights) > MOST_TERMS

    def vector(term: str) -> str:
        parts = []
        for way in ("cos", "sin"):
            part = f"m*e*{total(f'{term}{way}(alpha_#)', marks=marks)}"
            for mark in weights:
                part += f"+U_#*{term}{way}(alpha_#)".replace("#", mark)
            parts.append(part)
        return f"sqrt(({parts[0]})^2+({parts[1]})^2)"

    turns = {"note": "turns_in_radians"}
    if many:
        sheet.state("unbalance", "U", balance.unbalance, "many_satellites")
    else:
        sheet.work("unbalance", "U", balance.unbalance, vector(""))
    sheet.work("balance_force", "F", balance.force, "U*n_1^2", **turns)
    if many:
        sheet.state("couple", "M", balance.couple, "many_satellites")
    else:
        formula = f"n_1^2*{vector('(z_#-(z_A+z_B)/2)*')}"
        sheet.work("couple", "M", balance.couple, formula, **turns)
    sheet.take("M_r", "rotor_mass", results.design.rotor_mass)
    sheet.work("grade", "G", balance.grade, "U*n_1/M_r", **turns)
    for letter, term, correction in zip(
        LETTERS,
        ("(z_B-z_#)/(z_B-z_A)*", "(z_#-z_A)/(z_B-z_A)*"),
        balance.corrections,
        strict=True,
    ):
        said = {"params": {"letter": letter}}
        symbol = f"U_{letter}"
        if many:
            sheet.state("unbalance", symbol, correction.unbalance, "carried", **said)
        else:
            value, formula = correction.unbalance, vector(term)
            sheet.work("unbalance", symbol, value, formula, note="carried", **said)
        sheet.state("angle", f"alpha_{letter}", correction.angle, "opposite")
