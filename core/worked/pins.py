"""Worked steps of the strength of the pins."""

from contextlib import suppress
from typing import Any

from core.design.results import Results
from core.errors import UNKNOWN, required
from core.output.pin_strength import PinStrength
from core.worked.fatigue import cycle_steps, finite_life
from core.worked.members import take_speed
from core.worked.step import Sheet, Step


def static_step(
    sheet: Sheet,
    *,
    results: Results,
    code: str,
    symbol: str,
    over: tuple[str, str],
    share: float,
    **said: Any,
) -> None:
    """Add a static safety: a limit over a load that grows by `share` to the peak torque."""
    limit, load = over
    if share == 1:
        sheet.work(code, symbol, f"{limit}/{load}", **said)
    elif results.solved or results.design.bolted:  # a squeeze does not grow
        sheet.state(code, symbol, "under_peak", limit, **said)
    else:
        sheet.take("k", "torque_share", share)
        sheet.work(code, symbol, f"{limit}/(k*{load})", note="peak_torque", **said)


def strength_steps(*, results: Results, found: PinStrength, deflection: bool) -> list[Step]:
    """Steps of the strength of the pins. True for `deflection` adds deflection and slope."""
    sheet, pin, design = Sheet(found), results.bent_pin, results.design
    sheet.read(pin, d="diameter")
    sheet.take("d_i", "bore_diameter", pin.bore_diameter or None)
    sheet.take("b", "contact_length", design.pin_length)
    sheet.take("L", "span", None if pin.support == "cantilever" else pin.span)
    formula, sheared = "32*M/(pi*d^3)", "16*V/(3*pi*d^2)"
    if pin.bore_diameter:
        formula = "32*M*d/(pi*(d^4-d_i^4))"
        sheared = "16*V/(3*pi*(d^2-d_i^2))*(1+d*d_i/(d^2+d_i^2))"
    sheet.state("peak_force", "F_max", "shared")
    sheet.state("peak_moment_position", "x", "section", "b L")
    sheet.state("peak_moment", "M", "section", "F_max x b L")
    sheet.work("peak_bending_stress", "sigma_b", formula)
    sheet.state("peak_shear_force", "V", "section", "F_max b L")
    sheet.work("peak_shear_stress", "tau", sheared)
    sheet.state("peak_equivalent_stress", "sigma_v", "equivalent", "sigma_b tau")
    sheet.read(pin.material, R_e="yield_strength")
    static_step(
        sheet,
        results=results,
        code="static_safety_factor",
        symbol="S",
        over=("R_e", "sigma_v"),
        share=design.static_share,
    )
    if design.fatigue:
        with suppress(*UNKNOWN):
            _fatigue(sheet, results, found)
    if deflection:
        sheet.read(pin.material, E="youngs_modulus", nu="poissons_ratio")
        bent = found.deflection
        for code, symbol, value, satellite in (
            ("deflection", "w", bent.deflection, bent.satellite),
            ("slope", "theta", bent.slope, bent.slope_satellite),
        ):
            where = {"params": {"satellite": satellite}}
            sheet.state(code, symbol, "deflected", "F_max d d_i b L E nu", value, **where)
    return sheet.steps


def _fatigue(sheet: Sheet, results: Results, found: PinStrength) -> None:
    """Add the worst stress cycle of the pins, its safety and life."""
    cycle, pin, design = found.fatigue, results.bent_pin, results.design
    basis, ratio = design.fatigue, design.mechanism.ratio
    sheet.state("position", "x", "worst_cycle", value=cycle.position)
    sheet.state("direction", "chi", "worst_cycle", value=cycle.direction)
    sheet.state("max_stress", "sigma_max", "worst_cycle", value=cycle.max_stress)
    sheet.state("min_stress", "sigma_min", "worst_cycle", value=cycle.min_stress)
    if cycle.short or cycle.life is not None:
        take_speed(sheet, results=results)
    wave = sheet.take_ratio(ratio)

    def finite() -> None:
        life = design.life_of(basis)
        cycles = design.loads_over(life)
        finite_life(sheet, cycle=cycle, wave=wave, life=life, cycles=cycles)

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
        said = {"note": "turns_in_radians"}
        sheet.work("fatigue_life", "L", f"2*pi*N/(n_1{wave})", cycle.life, **said)
