"""Worked steps of a stress cycle: what the endurance limit is made of, and the safety factor."""

import math
from collections.abc import Callable

from core.design.sections import FatigueBasis
from core.fatigue import (
    ENDURING,
    KPSI,
    LOW_CYCLES,
    NOTCH_STRENGTHS,
    SURFACES,
    Criterion,
    CycleFatigue,
    EnduranceFactors,
    strength_fraction,
)
from core.worked.step import Sheet

SHIGLEY = {"source": "shigley"}

STRAIGHT: dict[Criterion, str] = {"goodman": "R_m", "soderberg": "R_e"}
"""Strengths at which the mean stress ends, of criteria by which both add up."""


def _notch(sheet: Sheet, basis: FatigueBasis, factor: float, in_stress: bool) -> None:
    """Add the fatigue notch factor, with Neuber's length for a notch that is given."""
    if basis.notch is None:
        sheet.state("notch", "K_f", "in_stress" if in_stress else "given", value=factor)
        return
    strength, name = sheet.known["R_m"].value, "R_m"
    low, high = (each * 1e6 for each in NOTCH_STRENGTHS)
    held = min(max(strength, low), high)
    if held != strength:
        name = "R_n"
        sheet.take("R_1", "tensile_strength", low)
        sheet.take("R_2", "tensile_strength", high)
        sheet.work("notch_strength", name, "min(max(R_m,R_1),R_2)", held, **SHIGLEY)
    sheet.take("K_t", "theoretical_factor", basis.notch.theoretical_factor)
    sheet.take("r", "radius", basis.notch.radius)
    sheet.take("r_0", "radius", 1e-3)
    part = held / 1e6
    root = 1.24 - 2.25e-3 * part + 1.6e-6 * part**2 - 4.11e-10 * part**3
    ratio = f"({name}/R_0)"
    formula = f"1.24-0.00225*{ratio}+0.0000016*{ratio}^2-0.000000000411*{ratio}^3"
    sheet.work("neuber_root", "s", formula, root, **SHIGLEY)
    sheet.work("notch", "K_f", "1+(K_t-1)/(1+s/sqrt(r/r_0))", factor, **SHIGLEY)


def _factors(
    sheet: Sheet, factors: EnduranceFactors, basis: FatigueBasis, diameter: float, in_stress: bool
) -> None:
    """Add the factors of the endurance limit."""
    sheet.take("R_0", "tensile_strength", 1e6)
    surface = float(factors.surface)
    if basis.surface is None:
        sheet.state("surface", "k_a", "given", value=surface)
    else:
        scale, power = SURFACES[basis.edition][basis.surface]
        sheet.take("a", "fit_scale", scale)
        sheet.take("b", "fit_exponent", power)
        sheet.work("surface", "k_a", "min(1,a*(R_m/R_0)^b)", surface, **SHIGLEY)
    scale, power = (1.24, -0.107) if diameter * 1e3 <= 51.0 else (1.51, -0.157)
    sheet.take("c", "fit_scale", scale)
    sheet.take("k", "fit_exponent", power)
    sheet.take("d", "diameter", diameter)
    sheet.take("d_0", "diameter", 1e-3)
    sheet.work("size", "k_b", "min(1,c*(d/d_0)^k)", factors.size, **SHIGLEY)
    sheet.state("reliability", "k_e", "tabled", value=factors.reliability)
    _notch(sheet, basis, float(factors.notch), in_stress)


def finite_life(
    sheet: Sheet, *, cycle: CycleFatigue, wave: str, life: float, cycles: float
) -> None:
    """Add the strength over a life, s, so short that it is above the endurance limit."""
    if not cycle.short:
        return
    cycles = max(cycles, LOW_CYCLES)
    sheet.take("L", "life", life)
    formula = f"max(1000,n_1{wave}*L/(2*pi))"
    sheet.work("life_cycles", "N_L", formula, cycles, note="turns_over_life")
    sheet.take("R_k", "tensile_strength", KPSI)
    fraction = strength_fraction(tensile_strength=sheet.known["R_m"].value)
    held = "min(max(R_m/R_k,70),200)"
    formula = f"1.06-0.0028*{held}+0.0000069*{held}^2"
    sheet.work("strength_fraction", "f", formula, fraction, **SHIGLEY, note="in_kpsi")
    left = math.log(ENDURING / cycles) / math.log(ENDURING / LOW_CYCLES)
    sheet.state("decades_left", "x", "decades_left", "N_L", left, **SHIGLEY)
    formula = "S_e*(f*R_m/S_e)^x"
    sheet.work("finite_strength", "S_f", formula, cycle.finite_strength, **SHIGLEY)


def cycle_steps(
    sheet: Sheet,
    *,
    cycle: CycleFatigue,
    basis: FatigueBasis,
    diameter: float,
    tensile_strength: float,
    yield_strength: float | None,
    in_stress: bool = False,
    finite: Callable[[], None] = lambda: None,
) -> None:
    """Add steps from the ends of a cycle, sigma_max and sigma_min, to its safety.

    `in_stress`: the stress has the notch in it already; `finite` adds the strength over a life.
    """
    sheet.take("R_m", "tensile_strength", tensile_strength)
    sheet.take("R_e", "yield_strength", yield_strength)
    sheet.work("amplitude", "sigma_a", "(sigma_max-sigma_min)/2", cycle.amplitude)
    sheet.work("mean", "sigma_m", "(sigma_max+sigma_min)/2", cycle.mean)
    if cycle.factors is None:
        sheet.state("endurance_limit", "S_e", "given", value=cycle.endurance_limit)
    else:
        _factors(sheet, cycle.factors, basis, diameter, in_stress)
        sheet.take("S", "endurance_limit", 700e6)
        formula = "k_a*k_b*k_e*min(R_m/2,S)/K_f"
        sheet.work("endurance_limit", "S_e", formula, cycle.endurance_limit, **SHIGLEY)
    finite()
    lasting = "S_f" if cycle.short else "S_e"
    code, safety = "fatigue_safety_factor", cycle.safety_factor
    if bears := STRAIGHT.get(basis.criterion):
        formula = f"1/(sigma_a/{lasting}+max(sigma_m,0)/{bears})"
        sheet.work(code, "n", formula, safety, **SHIGLEY)
    else:
        sheet.state(code, "n", "criterion", f"sigma_a sigma_m {lasting} R_m", safety)
    sheet.state("cycles", "N", "finite_life", "sigma_a sigma_m S_e R_m", cycle.cycles)
