"""Worked steps of swinging rollers."""

import math
from typing import Any

from core.design.sections import FatigueBasis
from core.fatigue import CycleFatigue
from core.rollers.roller_strength import (
    SHEAR_FACTOR,
    ByPoissonsRatio,
    ByShearModulus,
    PositionTolerance,
    RollerStrength,
    Shear,
    Spacing,
)
from core.worked.fatigue import cycle_steps
from core.worked.step import MOST_TERMS, Sheet, Step, total

SOURCE = "ovsyannikov2019"


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
    """Steps of the strength of rollers.

    Parameters
    ----------
    found : RollerStrength
        Their strength.
    output_torque, hole_circle_radius, rollers, cylinder_length, sphere_width, sphere_diameter, \
diameter, friction_coefficient, youngs_modulus, shear, stress_concentration, spacing : as of \
`core.rollers.roller_strength`
    cycle : CycleFatigue, optional
        Their fatigue.
    judged : dict, optional
        What that is judged by: `basis`, `tensile_strength`, `yield_strength`, and whether the
        roller `rotates`.
    """
    sheet = Sheet()
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
    ):
        sheet.take(symbol, quantity, value)
    match shear:
        case ByShearModulus(modulus):
            sheet.take("G", "shear_modulus", float(modulus))
        case ByPoissonsRatio(mu):
            sheet.take("mu", "poissons_ratio", float(mu))
            sheared = youngs_modulus / (2 * (1 + mu))
            sheet.work("shear_modulus", "G", sheared, "E/(2*(1+mu))", source=SOURCE)
    _compliance(sheet, found)
    sheet.work("mean_force", "F_m", found.mean_force, "T/(2*R*n)", source=SOURCE, equation="2")
    sheet.state("loaded_rollers", "m", found.loaded_rollers, "sharing", source=SOURCE, equation="5")
    _sharing(sheet, found, spacing)
    sheet.take("n_d", "sides", 2)
    equation = {"source": SOURCE, "equation": "1, 2"}
    sheet.work("centre_force", "F_0", found.centre_force, "n_d*F_1", **equation)
    sheet.work("bending_moment", "M", found.bending_moment, "(l+b/2+k*D/2)*F_1",
               source=SOURCE, equation="3, 4")  # fmt: skip
    sheet.work(
        "bending_stress",
        "sigma",
        found.bending_stress,
        "K_sigma*32*M/(pi*d^3)",
        source=SOURCE,
        equation="12",
        erratum="compliance",
    )
    equation = {"source": SOURCE, "equation": "12"}
    sheet.work("relative_stress", "sigma_r", found.relative_stress, "sigma/E", **equation)
    if cycle and judged:
        _fatigue(sheet, cycle, diameter, stress_concentration, **judged)
    return sheet.steps


def _compliance(sheet: Sheet, found: RollerStrength) -> None:
    """Stiffness of a roller from bending and shear."""
    (length, width, sphere, diameter, friction, young, shear) = (
        sheet.known[symbol].value for symbol in ("l", "b", "D", "d", "k", "E", "G")
    )
    end = friction * sphere + width
    bent = end * length / 4 + length**2 / 3 + width * (length + end) / 4
    bending = 64 * length / (math.pi * young * diameter**4) * bent
    sheared = 4 * SHEAR_FACTOR / (math.pi * shear * diameter**2) * (length + width / 2)
    said = {"source": SOURCE, "equation": "9", "erratum": "compliance"}
    formula = "64*l/(pi*E*d^4)*((k*D+b)*l/4+l^2/3+b*(l+k*D+b)/4)"
    sheet.work("bending_compliance", "s_M", bending, formula, **said)
    formula = f"4*{SHEAR_FACTOR}/(pi*G*d^2)*(l+b/2)"
    sheet.work("shear_compliance", "s_Q", sheared, formula, **said)
    equation = {"source": SOURCE, "equation": "9"}
    sheet.work("stiffness", "c", found.stiffness, "1/(s_M+s_Q)", **equation)
    equation = {"source": SOURCE, "equation": "10"}
    sheet.work("relative_stiffness", "c_r", found.relative_stiffness, "c/(b*E)", **equation)


def _sharing(sheet: Sheet, found: RollerStrength, spacing: Spacing) -> None:
    """Displacement and forces: the contacts close one after the other."""
    n = round(sheet.known["n"].value)
    own = spacing.gaps(n)
    loaded, first = int(found.loaded_rollers), min(own)
    carrying = sorted(own)[:loaded]
    marks = [str(i + 1) for i in range(loaded)]
    for mark, gap in zip(marks, carrying, strict=True):
        sheet.take(f"g_{mark}", "gap", gap)
    said = {"source": SOURCE, "equation": "5, 7"}
    if loaded > MOST_TERMS:
        sheet.state("displacement", "Delta", found.displacement, "gaps", **said)
    else:
        formula = f"(n*F_m/c+{total('g_#', marks=marks)})/m"
        sheet.work("displacement", "Delta", found.displacement, formula, **said, note="gaps")
    delta, six = found.relative_position_error, {"source": SOURCE, "equation": "6"}
    if isinstance(spacing, PositionTolerance):
        sheet.take("chi", "position_tolerance", float(spacing.tolerance))
        sheet.work("relative_position_error", "delta", delta, "c*chi/F_m", source=SOURCE)
        formula = "min(n,1+4*(n-1)/n*delta)"
        psi = found.load_nonuniformity
        sheet.work("load_nonuniformity", "Psi", psi, formula, **six, erratum="single")
        sheet.work("max_force", "F_1", found.max_force, "Psi*F_m", **six)
        return
    sheet.take("g_min", "gap", first)
    all_marks = [str(i + 1) for i in range(n)]
    for mark, gap in zip(all_marks, own, strict=True):
        sheet.take(f"g_{mark}", "gap", gap)
    if n > MOST_TERMS:
        sheet.state("relative_position_error", "delta", delta, "mean_gap", **six)
    else:
        over = "4*(n-1)" if n > 1 else "4"
        formula = f"c*{total('(g_#-g_min)', marks=all_marks)}/({over})/F_m"
        sheet.work("relative_position_error", "delta", delta, formula, **six, note="mean_gap")
    five = {"source": SOURCE, "equation": "5"}
    sheet.work("max_force", "F_1", found.max_force, "c*(Delta-g_min)", **five)
    sheet.work("load_nonuniformity", "Psi", found.load_nonuniformity, "F_1/F_m", **six)


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
    """The cycle at the middle sphere; the stress concentration counts once, in the stress or in the
    limit.
    """
    if cycle.factors is None:
        sheet.work("max_stress", "sigma_max", cycle.max_stress, "sigma/K_sigma")
    else:
        sheet.state("max_stress", "sigma_max", cycle.max_stress, "of_bending")
    if rotates:
        sheet.take("r_s", "stress_ratio", -1.0)
        sheet.work("min_stress", "sigma_min", cycle.min_stress, "r_s*sigma_max")
    else:
        sheet.state("min_stress", "sigma_min", cycle.min_stress, "comes_and_goes")
    cycle_steps(
        sheet,
        cycle=cycle,
        basis=basis,
        diameter=diameter,
        tensile_strength=tensile_strength,
        yield_strength=yield_strength,
        in_stress=concentration > 1,
    )
