"""Worked steps of swinging rollers."""

import math
from collections.abc import Mapping
from typing import Any

from core.fatigue import CycleFatigue
from core.rollers.roller_strength import (
    SHEAR_FACTOR,
    ByShearModulus,
    PositionTolerance,
    RollerStrength,
    Spacing,
)
from core.worked.fatigue import cycle_steps
from core.worked.step import Sheet, Step

SOURCE = "ovsyannikov2019"


def _by(equation: str, erratum: str = "") -> dict[str, str]:
    """Number of an equation of the source."""
    return {"source": SOURCE, "equation": equation, "erratum": erratum}


def roller_steps(
    *,
    found: RollerStrength,
    design: Mapping[str, Any],
    cycle: CycleFatigue | None = None,
    judged: dict[str, Any] | None = None,
) -> list[Step]:
    """Steps of the strength of rollers. `design` has the arguments of
    `core.rollers.roller_strength.roller_strength`, `judged` those of the fatigue: `basis`,
    `tensile_strength`, `yield_strength`, `rotates`.
    """
    sheet, shear = Sheet(found), design["shear"]
    sheet.read(design, l="cylinder_length", b="sphere_width", D="sphere_diameter", d="diameter")
    sheet.read(design, k="friction_coefficient", n="rollers", E="youngs_modulus")
    sheet.read(design, T="output_torque", R="hole_circle_radius")
    sheet.take("K_sigma", "stress_concentration", design.get("stress_concentration", 1.0))
    sheet.take("n_d", "sides", 2)
    length, b, sphere, d, k, young = (sheet.known[name].value for name in "lbDdkE")
    modulus = young / shear.modulus_ratio(young)
    if isinstance(shear, ByShearModulus):
        sheet.read(shear, G="shear_modulus")
    else:
        sheet.read(shear, mu="poissons_ratio")
        sheet.work("shear_modulus", "G", "E/(2*(1+mu))", modulus, source=SOURCE)
    end = k * sphere + b
    bending = end * length / 4 + length**2 / 3 + b * (length + end) / 4
    bending *= 64 * length / (math.pi * young * d**4)
    formula = "64*l/(pi*E*d^4)*((k*D+b)*l/4+l^2/3+b*(l+k*D+b)/4)"
    sheet.work("bending_compliance", "s_M", formula, bending, **_by("9", "compliance"))
    sheared = 4 * SHEAR_FACTOR / (math.pi * modulus * d**2) * (length + b / 2)
    formula = f"4*{SHEAR_FACTOR}/(pi*G*d^2)*(l+b/2)"
    sheet.work("shear_compliance", "s_Q", formula, sheared, **_by("9", "compliance"))
    sheet.work("stiffness", "c", "1/(s_M+s_Q)", **_by("9"))
    sheet.work("relative_stiffness", "c_r", "c/(b*E)", **_by("10"))
    sheet.work("mean_force", "F_m", "T/(2*R*n)", **_by("2"))
    _sharing(sheet, design["spacing"], design["rollers"])
    sheet.work("centre_force", "F_0", "n_d*F_1", **_by("1, 2"))
    sheet.work("bending_moment", "M", "(l+b/2+k*D/2)*F_1", **_by("3, 4"))
    sheet.work("bending_stress", "sigma", "K_sigma*32*M/(pi*d^3)", **_by("12", "compliance"))
    sheet.work("relative_stress", "sigma_r", "sigma/E", **_by("12"))
    if cycle and judged:
        _fatigue(sheet, cycle, **judged)
    return sheet.steps


def _sharing(sheet: Sheet, spacing: Spacing, rollers: int) -> None:
    """Add displacement and forces: the contacts close one after the other."""
    sheet.state("loaded_rollers", "m", "sharing", "n F_m c", **_by("5"))
    sheet.state("displacement", "Delta", "gaps", "n F_m c m", **_by("5, 7"))
    if isinstance(spacing, PositionTolerance):
        sheet.take("chi", "position_tolerance", float(spacing.tolerance))
        sheet.work("relative_position_error", "delta", "c*chi/F_m", source=SOURCE)
        formula = "min(n,1+4*(n-1)/n*delta)"
        sheet.work("load_nonuniformity", "Psi", formula, **_by("6", "single"))
        sheet.work("max_force", "F_1", "Psi*F_m", **_by("6"))
        return
    sheet.take("g_min", "gap", min(spacing.gaps(rollers)))
    sheet.state("relative_position_error", "delta", "mean_gap", "n F_m c g_min", **_by("6"))
    sheet.work("max_force", "F_1", "c*(Delta-g_min)", **_by("5"))
    sheet.work("load_nonuniformity", "Psi", "F_1/F_m", **_by("6"))


def _fatigue(sheet: Sheet, cycle: CycleFatigue, *, rotates: bool, **judged: Any) -> None:
    """Add the cycle at the middle sphere; the stress concentration counts once, in the stress or in
    the limit.
    """
    if cycle.factors is None:
        sheet.work("max_stress", "sigma_max", "sigma/K_sigma", cycle.max_stress)
    else:
        sheet.state("max_stress", "sigma_max", "of_bending", "sigma", cycle.max_stress)
    if rotates:
        sheet.take("r_s", "stress_ratio", -1.0)
        sheet.work("min_stress", "sigma_min", "r_s*sigma_max", cycle.min_stress)
    else:
        sheet.state("min_stress", "sigma_min", "comes_and_goes", value=cycle.min_stress)
    in_stress = sheet.known["K_sigma"].value > 1
    diameter = sheet.known["d"].value
    cycle_steps(sheet, cycle=cycle, diameter=diameter, in_stress=in_stress, **judged)
