"""Worked steps of the strength of the pins."""

from contextlib import suppress

import numpy as np

from core.arrays import FloatArray
from core.design.results import Results
from core.errors import UNKNOWN, if_known, required
from core.output.pin_strength import PinDeflection, PinStrength
from core.worked.fatigue import cycle_steps, finite_life
from core.worked.members import take_speed, take_torque
from core.worked.sharing import Shares, beam_of, ideal_turn, take_beam, unit_steps
from core.worked.step import Sheet, Step
from core.worked.turn import IdealTurn, Position, is_at


def static_step(
    sheet: Sheet,
    *,
    results: Results,
    code: str,
    symbol: str,
    value: float | None,
    limit: str,
    load: str,
    share: float,
    **said: str,
) -> None:
    """Step of a static safety: a limit over a load, under the torque of static strength.

    Parameters
    ----------
    sheet : Sheet
        With limit and load.
    results : Results
        Results of the design.
    code, symbol : str
        What is worked out.
    value : float or None
        The safety; no step without.
    limit, load : str
        Their symbols.
    share : float
        The torque of static strength over that of the load.
    **said
        Other fields of the step.
    """
    if share == 1:
        sheet.work(code, symbol, value, f"{limit}/{load}", **said)
    elif results.solved or results.design.bolted:  # a squeeze does not grow
        sheet.state(code, symbol, value, "under_peak", **said)
    else:
        sheet.take("k", "torque_share", share)
        sheet.work(code, symbol, value, f"{limit}/(k*{load})", note="peak_torque", **said)


def strength_steps(*, results: Results, found: PinStrength, deflection: bool) -> list[Step]:
    """Steps of the strength of the pins.

    Parameters
    ----------
    results : Results
        Results of a design with a pin.
    found : PinStrength
        Its strength.
    deflection : bool
        Whether its deflection is wanted.
    """
    sheet, pin = Sheet(), results.bent_pin
    sheet.take("d", "diameter", pin.diameter)
    sheet.take("d_i", "bore_diameter", pin.bore_diameter or None)
    sheet.state("peak_force", "F_max", found.peak_force, "shared")
    sheet.state("peak_moment_position", "x", found.peak_moment_position, "section")
    sheet.state("peak_moment", "M", found.peak_moment, "section")
    formula, sheared = "32*M/(pi*d^3)", "16*V/(3*pi*d^2)"
    if pin.bore_diameter:
        formula = "32*M*d/(pi*(d^4-d_i^4))"
        sheared = "16*V/(3*pi*(d^2-d_i^2))*(1+d*d_i/(d^2+d_i^2))"
    sheet.work("peak_bending_stress", "sigma_b", found.peak_bending_stress, formula)
    sheet.state("peak_shear_force", "V", found.peak_shear_force, "section")
    sheet.work("peak_shear_stress", "tau", found.peak_shear_stress, sheared)
    sheet.state("peak_equivalent_stress", "sigma_v", found.peak_equivalent_stress, "equivalent")
    sheet.take("R_e", "yield_strength", pin.material.yield_strength)
    static_step(
        sheet,
        results=results,
        code="static_safety_factor",
        symbol="S",
        value=if_known(lambda: found.static_safety_factor),
        limit="R_e",
        load="sigma_v",
        share=results.design.static_share,
    )
    if results.design.fatigue:
        with suppress(*UNKNOWN):
            _fatigue(sheet, results, found)
    if deflection:
        _deflection(sheet, results, found.deflection)
    return sheet.steps


def _fatigue(sheet: Sheet, results: Results, found: PinStrength) -> None:
    cycle, pin, basis = found.fatigue, results.bent_pin, results.design.fatigue
    sheet.state("position", "x", cycle.position, "worst_cycle")
    sheet.state("direction", "chi", cycle.direction, "worst_cycle")
    sheet.state("max_stress", "sigma_max", cycle.max_stress, "worst_cycle")
    sheet.state("min_stress", "sigma_min", cycle.min_stress, "worst_cycle")
    ratio = results.design.mechanism.ratio

    def finite() -> None:
        life = results.design.life_of(basis)
        take_speed(sheet, results=results)
        cycles = results.design.loads_over(life)
        finite_life(sheet, cycle=cycle, ratio=ratio, life=life, cycles=cycles)

    cycle_steps(
        sheet,
        cycle=cycle,
        basis=basis,
        diameter=pin.diameter,
        tensile_strength=required(pin.tensile_strength, "endurance_unknown"),
        yield_strength=pin.material.yield_strength,
        finite=finite,
    )
    if cycle.life is not None:
        wave = sheet.take_ratio(ratio)
        take_speed(sheet, results=results)
        formula = f"2*pi*N/(n_1{wave})"
        sheet.work("fatigue_life", "L", cycle.life, formula, note="turns_in_radians")


def _deflection(sheet: Sheet, results: Results, found: PinDeflection) -> None:
    """Deflection and slope in the middle of satellites, by unit forces of those that load the pin
    there.
    """
    parts = {
        "deflection": ("w", found.satellite - 1, found.deflection),
        "slope": ("theta", found.slope_satellite - 1, found.slope),
    }
    turn = None if results.design.tied else ideal_turn(sheet, results=results)
    if turn is None:
        for code, (symbol, satellite, value) in parts.items():
            sheet.state(code, symbol, value, "deflected", params={"satellite": satellite + 1})
        return
    take_beam(sheet, results=results)
    sheet.take("K_A", "dynamic_factor", results.design.load_factor)
    sheet.take("K_alpha", "distribution_factor", results.design.distribution_factor)
    take_torque(
        sheet, members=results.design.members, output_torque=results.design.load.output_torque
    )
    sheet.take("R", "pin_circle_radius", results.design.load.pin_circle_radius)
    for code, (symbol, satellite, value) in parts.items():
        _bent(sheet, results, turn, code, symbol, satellite, value)


def _bent(
    sheet: Sheet,
    results: Results,
    turn: IdealTurn,
    code: str,
    symbol: str,
    satellite: int,
    value: float,
) -> None:
    pin, beam = results.bent_pin, beam_of(results)
    x, places = pin.satellite_positions[satellite], np.array(pin.satellite_positions)
    effect = np.array([getattr(beam, code)(x, z) for z in places])

    def on_pins(position: Position) -> FloatArray:
        """What each pin suffers, shape (n, N)."""
        parts = effect[position.satellite] * position.force * np.exp(1j * position.angle)
        own = np.zeros((len(parts), results.design.mechanism.pins), dtype=complex)
        for column, n in enumerate(position.pin.tolist()):
            own[:, n] += parts[:, column]
        return np.abs(own)

    def most(position: Position) -> FloatArray:
        found: FloatArray = on_pins(position).max(axis=1)
        return found

    at = turn.worst(most)
    if not is_at(at, measure=most, value=value):
        sheet.state(code, symbol, value, "deflected", params={"satellite": satellite + 1})
        return
    n = int(on_pins(at)[0].argmax())
    shares = Shares(sheet, turn, at)
    pairs = [pair for pair in shares.pairs if pair[1] == n]
    letter = "c" if code == "deflection" else "s"
    units, forces = [], []
    for j, _, angle in pairs:
        units.append(
            unit_steps(sheet, results=results, at=satellite, by=j)[0 if letter == "c" else 1]
        )
        forces.append(f"F_{j + 1}")
        column = shares.pairs.index((j, n, angle))
        load = results.design.load
        torque = results.design.load_factor * results.design.pin_torque
        force = torque / load.pin_circle_radius * results.design.distribution_factor
        sheet.work(
            "pin_force",
            forces[-1],
            force * float(at.force[0, column]),
            f"K_A*K_alpha*T/R*{shares.one(shares.pairs[column])}",
            note="alike",
        )
    if len(pairs) == 1:
        sheet.work(code, symbol, value, f"abs({units[0]})*{forces[0]}")
        return
    terms = [
        (unit, force, f"gamma_{j + 1}_{n + 1}")
        for unit, force, (j, _, _) in zip(units, forces, pairs, strict=True)
    ]
    along, across = (
        "+".join(f"{unit}*{force}*{way}({angle})" for unit, force, angle in terms)
        for way in ("cos", "sin")
    )
    sheet.work(code, symbol, value, f"sqrt(({along})^2+({across})^2)")
