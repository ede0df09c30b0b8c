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


def _surface(sheet: Sheet, basis: FatigueBasis, factor: float) -> None:
    if basis.surface is None:
        sheet.state("surface", "k_a", factor, "given")
        return
    scale, power = SURFACES[basis.edition][basis.surface]
    sheet.take("a", "fit_scale", scale)
    sheet.take("b", "fit_exponent", power)
    sheet.work("surface", "k_a", factor, "min(1,a*(R_m/R_0)^b)", **SHIGLEY)


def _notch(sheet: Sheet, basis: FatigueBasis, factor: float, *, in_stress: bool) -> None:
    if basis.notch is None:
        sheet.state("notch", "K_f", factor, "in_stress" if in_stress else "given")
        return
    theoretical, radius = basis.notch
    strength, name = sheet.known["R_m"].value, "R_m"
    low, high = (each * 1e6 for each in NOTCH_STRENGTHS)
    held = min(max(strength, low), high)
    if held != strength:
        name = "R_n"
        sheet.take("R_1", "tensile_strength", low)
        sheet.take("R_2", "tensile_strength", high)
        sheet.work("notch_strength", name, held, "min(max(R_m,R_1),R_2)", **SHIGLEY)
    sheet.take("K_t", "theoretical_factor", theoretical)
    sheet.take("r", "radius", radius)
    sheet.take("r_0", "radius", 1e-3)
    part = held / 1e6
    root = 1.24 - 2.25e-3 * part + 1.6e-6 * part**2 - 4.11e-10 * part**3
    sheet.work(
        "neuber_root",
        "s",
        root,
        f"1.24-0.00225*{name}/R_0+0.0000016*({name}/R_0)^2-0.000000000411*({name}/R_0)^3",
        **SHIGLEY,
    )
    sheet.work("notch", "K_f", factor, "1+(K_t-1)/(1+s/sqrt(r/r_0))", **SHIGLEY)


def _factors(
    sheet: Sheet,
    factors: EnduranceFactors,
    basis: FatigueBasis,
    diameter: float,
    *,
    in_stress: bool,
) -> None:
    sheet.take("R_0", "tensile_strength", 1e6)
    _surface(sheet, basis, float(factors.surface))
    size = 1.51, -0.157
    if diameter * 1e3 <= 51.0:
        size = 1.24, -0.107
    sheet.take("c", "fit_scale", size[0])
    sheet.take("k", "fit_exponent", size[1])
    sheet.take("d", "diameter", diameter)
    sheet.take("d_0", "diameter", 1e-3)
    sheet.work("size", "k_b", factors.size, "min(1,c*(d/d_0)^k)", **SHIGLEY)
    sheet.state("reliability", "k_e", factors.reliability, "tabled")
    _notch(sheet, basis, float(factors.notch), in_stress=in_stress)


def finite_life(
    sheet: Sheet,
    *,
    cycle: CycleFatigue,
    ratio: float,
    life: float,
    cycles: float,
) -> None:
    """Steps of the strength over a life so short that it is above the endurance limit.

    Parameters
    ----------
    sheet : Sheet
        With tensile strength, endurance limit and the speed of the crank against the ring.
    cycle : CycleFatigue
        The cycle; no step where its strength is the endurance limit.
    ratio, life : float
        Ratio u and time, s.
    cycles : float
        Turns of a satellite against its crank in that time.
    """
    if not cycle.short:
        return
    wave = sheet.take_ratio(ratio)
    sheet.take("L", "life", life)
    sheet.work(
        "life_cycles",
        "N_L",
        max(cycles, LOW_CYCLES),
        f"max(1000,n_1{wave}*L/(2*pi))",
        note="turns_over_life",
    )
    sheet.take("R_k", "tensile_strength", KPSI)
    strength = sheet.known["R_m"].value
    sheet.work(
        "strength_fraction",
        "f",
        strength_fraction(tensile_strength=strength),
        "1.06-0.0028*min(max(R_m/R_k,70),200)+0.0000069*min(max(R_m/R_k,70),200)^2",
        **SHIGLEY,
        note="in_kpsi",
    )
    left = math.log(ENDURING / max(cycles, LOW_CYCLES)) / math.log(ENDURING / LOW_CYCLES)
    sheet.state("decades_left", "x", left, "decades_left", **SHIGLEY)
    sheet.work("finite_strength", "S_f", cycle.finite_strength, "S_e*(f*R_m/S_e)^x", **SHIGLEY)


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
    """Steps from the ends of a cycle to its safety.

    Parameters
    ----------
    sheet : Sheet
        With the largest and the least stress, sigma_max and sigma_min.
    cycle : CycleFatigue
        The cycle.
    basis : FatigueBasis
        What it is judged by.
    diameter : float
        Of the section, m.
    tensile_strength, yield_strength : float or None
        Of the material, Pa.
    in_stress : bool
        Whether the stress has the notch in it already.
    finite : callable
        Adds the steps of the strength over a life that is short.
    """
    sheet.take("R_m", "tensile_strength", tensile_strength)
    sheet.take("R_e", "yield_strength", yield_strength)
    sheet.work("amplitude", "sigma_a", cycle.amplitude, "(sigma_max-sigma_min)/2")
    sheet.work("mean", "sigma_m", cycle.mean, "(sigma_max+sigma_min)/2")
    if cycle.factors is None:
        sheet.state("endurance_limit", "S_e", cycle.endurance_limit, "given")
    else:
        _factors(sheet, cycle.factors, basis, diameter, in_stress=in_stress)
        sheet.take("S", "endurance_limit", 700e6)
        formula = "k_a*k_b*k_e*min(R_m/2,S)/K_f"
        sheet.work("endurance_limit", "S_e", cycle.endurance_limit, formula, **SHIGLEY)
    finite()
    lasting = "S_f" if cycle.short else "S_e"
    if basis.criterion in STRAIGHT:
        bears = STRAIGHT[basis.criterion]
        formula = f"1/(sigma_a/{lasting}+max(sigma_m,0)/{bears})"
        sheet.work("fatigue_safety_factor", "n", cycle.safety_factor, formula, **SHIGLEY)
    else:
        sheet.state("fatigue_safety_factor", "n", cycle.safety_factor, "criterion")
    sheet.state("cycles", "N", cycle.cycles, "finite_life")
