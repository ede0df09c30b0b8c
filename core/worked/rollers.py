"""Worked steps of swinging rollers."""

import math
from typing import Any

from core.design.sections import FatigueBasis
from core.fatigue import CycleFatigue
from core.rollers.roller_strength import (
    SHEAR_FACTOR,
    ByShearModulus,
    PositionTolerance,
    RollerStrength,
    Shear,
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
    output_torque: float,
    hole_circle_radius: float,
    rollers: int,
    cylinder_length: float,
    sphere_width: float,
    sphere_diameter: float,
    diameter: float,
    friction_coefficient: float,
    youngs_modulus: float,
    shear: Shear,
    stress_concentration: float = 1.0,
    spacing: Spacing,
    cycle: CycleFatigue | None = None,
    judged: dict[str, Any] | None = None,
) -> list[Step]:
    """Steps of the strength of rollers; other arguments are those of `core.rollers`.

    Parameters
    ----------
    cycle : CycleFatigue, optional
        Fatigue of the rollers.
    judged : dict, optional
        Arguments of the fatigue: `basis`, `tensile_strength`, `yield_strength`, `rotates`.
    """
    sheet = Sheet(found)
    for symbol, quantity, value in (
        ("l", "cylinder_length", cylinder_length),
        ("b", "sphere_width", sphere_width),
        ("D", "sphere_diameter", sphere_diameter),
        ("d", "diameter", diameter),
        ("k", "friction_coefficient", friction_coefficient),
        ("n", "rollers", rollers),
        ("E", "youngs_modulus", youngs_modulus),
        ("T", "output_torque", output_torque),
        ("R", "hole_circle_radius", hole_circle_radius),
        ("K_sigma", "stress_concentration", stress_concentration),
        ("n_d", "sides", 2),
    ):
        sheet.take(symbol, quantity, value)
    modulus = youngs_modulus / shear.modulus_ratio(youngs_modulus)
    if isinstance(shear, ByShearModulus):
        sheet.read(shear, G="shear_modulus")
    else:
        sheet.read(shear, mu="poissons_ratio")
        sheet.work("shear_modulus", "G", "E/(2*(1+mu))", modulus, source=SOURCE)
    end = friction_coefficient * sphere_diameter + sphere_width
    bent = end * cylinder_length / 4 + cylinder_length**2 / 3
    bent += sphere_width * (cylinder_length + end) / 4
    bending = 64 * cylinder_length / (math.pi * youngs_modulus * diameter**4) * bent
    formula = "64*l/(pi*E*d^4)*((k*D+b)*l/4+l^2/3+b*(l+k*D+b)/4)"
    sheet.work("bending_compliance", "s_M", formula, bending, **_by("9", "compliance"))
    sheared = 4 * SHEAR_FACTOR / (math.pi * modulus * diameter**2)
    sheared *= cylinder_length + sphere_width / 2
    formula = f"4*{SHEAR_FACTOR}/(pi*G*d^2)*(l+b/2)"
    sheet.work("shear_compliance", "s_Q", formula, sheared, **_by("9", "compliance"))
    sheet.work("stiffness", "c", "1/(s_M+s_Q)", **_by("9"))
    sheet.work("relative_stiffness", "c_r", "c/(b*E)", **_by("10"))
    sheet.work("mean_force", "F_m", "T/(2*R*n)", **_by("2"))
    _sharing(sheet, spacing, rollers)
    sheet.work("centre_force", "F_0", "n_d*F_1", **_by("1, 2"))
    sheet.work("bending_moment", "M", "(l+b/2+k*D/2)*F_1", **_by("3, 4"))
    sheet.work("bending_stress", "sigma", "K_sigma*32*M/(pi*d^3)", **_by("12", "compliance"))
    sheet.work("relative_stress", "sigma_r", "sigma/E", **_by("12"))
    if cycle and judged:
        _fatigue(sheet, cycle, diameter, stress_concentration, **judged)
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


def _fatigue(
    sheet: Sheet,
    cycle: CycleFatigue,
    diameter: float,
    concentration: float,
    *,
    basis: FatigueBasis,
    tensile_strength: float,
    yield_strength: float | None,
    rotates: bool,
) -> None:
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
    cycle_steps(
        sheet,
        cycle=cycle,
        basis=basis,
        diameter=diameter,
        tensile_strength=tensile_strength,
        yield_strength=yield_strength,
        in_stress=concentration > 1,
    )
