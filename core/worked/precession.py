"""Worked steps of the precessional gear: contact lines, load of the mesh, shaft."""

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any

from core.design.sections import FatigueBasis
from core.errors import UNKNOWN
from core.hertz import ElasticMaterial
from core.precession.contact_line import ContactLine, ContactLines
from core.precession.line_contact import LineContact
from core.precession.meshing_load import MeshingLoad
from core.precession.shaft import ShaftSection
from core.precession.shaft_deflection import Deflection, ShaftDeflection
from core.precession.shaft_strength import ShaftStrength
from core.precision import AS_TYPED
from core.worked.fatigue import cycle_steps
from core.worked.hertz import JOHNSON, MODULUS, take_materials
from core.worked.step import Sheet, Step


def _by(equation: str = "", erratum: str = "") -> dict[str, str]:
    """Number of an equation of the source."""
    return {"source": "khatetovsky2020", "equation": equation, "erratum": erratum}


def _sheet(gear: dict[str, float], line: ContactLine, found: object) -> Sheet:
    """Sheet on which the gear's sizes are known, and the length A of its contact lines."""
    sheet = Sheet(found)
    sheet.read(gear, R_C="roller_circle_radius", rho="roller_radius")
    sheet.read(gear, theta="nutation_angle", u_12="ratio_u12")
    formula = "R_C*(cos(theta)-u_12)/sin(theta)"
    sheet.work("scale", "A", formula, line.curve.scale, **_by("1"))
    return sheet


def line_steps(*, gear: dict[str, float], found: ContactLines, by_angle: bool) -> list[Step]:
    """Steps of the contact line of the first roller; the others go the same way. `gear` has
    `roller_circle_radius`, `roller_radius`, `nutation_angle`, `ratio_u12`; `by_angle` is True if
    the line is given by its polar angles.
    """
    line = found.lines[0]
    sheet = _sheet(gear, line, found)
    sheet.take("phi_1", "position_angle", line.position_angle)
    ends = _ends_by_angle if by_angle else _ends_by_length
    of = f"A rho phi_1 {ends(sheet, line)}"
    sheet.state("length", "s_1", "quadrature", of, line.length, **_by("4, 5", "slope"))
    sheet.state("total_length", "S", "others", "s_1", **_by("8"))
    return sheet.steps


def _ends_by_length(sheet: Sheet, line: ContactLine) -> str:
    """Add polar angles of the ends: half-turns lead to the flank that carries; symbols of the ends
    along the axis.
    """
    scale, angle = line.curve.scale, line.position_angle
    sheet.take("h", "half_turn", math.pi)
    for code, polar in (("phi_min", line.phi_min), ("phi_max", line.phi_max)):
        places = {}
        for z in (line.z_min, line.z_max):
            flat = math.atan(-z * math.sin(angle) / (scale + z * math.cos(angle)))
            places[abs(math.sin(polar - flat))] = z, flat
        z, flat = places[min(places)]
        symbol = f"z_{code[4:]}"
        sheet.take(symbol, "z", z)
        sheet.take("k", "half_turns", round((polar - flat) / math.pi))
        formula = f"atan(-{symbol}*sin(phi_1)/(A+{symbol}*cos(phi_1)))+k*h"
        sheet.work(code, code, formula, polar, **_by("1"), note="flank")
    return "z_min z_max"


def _ends_by_angle(sheet: Sheet, line: ContactLine) -> str:
    """Add places of the ends along the axis by their polar angles; symbols of these places."""
    scale, angle = line.curve.scale, line.position_angle
    for code, symbol, end in (("z_min", "z_a", line.z_min), ("z_max", "z_b", line.z_max)):
        polar = min(
            (line.phi_min, line.phi_max),
            key=lambda phi: abs(-scale * math.sin(phi) / math.sin(phi + angle) - end),
        )
        sheet.take("phi", "polar_angle", polar)
        sheet.work(code, symbol, "-A*sin(phi)/sin(phi+phi_1)", end, **_by("1"))
    return "z_a z_b"


def load_steps(
    *, gear: dict[str, float], found: MeshingLoad, torque: float, reference_z: float
) -> list[Step]:
    """Steps of the load of the mesh. `gear` is as in `line_steps`; the torque M1 is in N*m, the
    place l of C in m.
    """
    sheet = _sheet(gear, found.lines[0], found)
    sheet.take("M_1", "torque", torque)
    sheet.take("S", "total_length", found.total_length)
    sheet.take("l", "reference_z", reference_z)
    full = torque / found.total_length / gear["roller_circle_radius"]
    sheet.work("full_arm_load", "q_C", "M_1/(S*R_C)", full, **_by("8"))
    for code, symbol, value, method, of, equation, erratum in (
        ("force", "F_x", found.force[0], "along_x", "q_C A", "12", "normal"),
        ("force", "F_y", found.force[1], "along_y", "q_C A", "13", "normal"),
        ("force", "F_z", found.force[2], "no_axial", "", "14", ""),
        ("moment", "M_Cx", found.moment[0], "about_x", "q_C A l", "15", "normal"),
        ("moment", "M_Cy", found.moment[1], "about_y", "q_C A l", "16", "normal"),
        ("moment", "M_Cz", found.moment[2], "own_torque", "M_1", "17", ""),
    ):
        sheet.state(code, symbol, method, of, value, **_by(equation, erratum))
    ends = [phi for line in found.lines for phi in (line.phi_min, line.phi_max)]
    sheet.take("phi", "polar_angle", min(ends, key=lambda phi: abs(math.sin(phi))))
    formula = "abs(M_1)/(S*R_C*abs(sin(phi)))"
    sheet.work("max_line_load", "q", formula, **_by("8"), note="least_arm")
    return sheet.steps


ONE_DIAMETER = {
    "B": "-64/(pi*E*d^4)*(C_#*(b^3/3+a*b^2/2)+B_#*b^3/3)",
    "C": "-64/(pi*E*d^4)*(C_#*(a+b)^3/3+B_#*(b^3/3+a*b^2/2))",
}
"""Mohr's integrals of one diameter in closed form."""


def shaft_steps(
    *,
    load: MeshingLoad,
    found: ShaftDeflection,
    shaft: Mapping[str, Any],
    strength: ShaftStrength | None = None,
    judged: dict[str, Any] | None = None,
    contact: tuple[LineContact, dict[str, Any]] | None = None,
) -> list[Step]:
    """Steps of the shaft: reactions, deflections, strength, and the contact of the lines.

    `shaft` has `shaft_sections` from C to the clamp, `bearing_distance`, `overhang`,
    `youngs_modulus`; `judged` the arguments of the strength: `basis`, `tensile_strength`,
    `yield_strength`; `contact` the contact along the lines, and its `roller_radius`,
    `mating_radius`, `materials`.
    """
    sheet, sections = Sheet(found), shaft["shaft_sections"]
    sheet.read(shaft, a="bearing_distance", b="overhang", E="youngs_modulus")
    sheet.take("d", "diameter", min(each.diameter for each in sections))
    for axis, force, moment in zip("xy", load.force, load.moment, strict=False):
        sheet.take(f"F_{axis}", "force", force)
        sheet.take(f"M_C{axis}", "moment", moment)
    (b_x, b_y), (c_x, c_y) = found.reaction_B, found.reaction_C
    sheet.work("reaction_B", "B_x", "-M_Cy/a", b_x, **_by("30"))
    sheet.work("reaction_B", "B_y", "M_Cx/a", b_y, **_by("31"))
    sheet.work("reaction_C", "C_x", "-F_x-B_x", c_x, **_by("28", "reaction"))
    sheet.work("reaction_C", "C_y", "-F_y-B_y", c_y, **_by("29"))
    for at in "BC":
        simple: Deflection | None = getattr(found, f"simplified_deflection_{at}")
        _deflection(sheet, at, getattr(found, f"deflection_{at}"), stepped=simple is not None)
        if simple is not None:
            _deflection(sheet, at, simple, "simplified_", "_prime", note="smallest")
            formula = f"Delta_prime_{at}/Delta_{at}-1"
            sheet.work(f"simplification_error_{at}", f"epsilon_{at}", formula)
    if strength:
        _strength(sheet, strength, sections, judged or {})
    if contact:
        _contact(sheet, load, contact[0], **contact[1])
    return sheet.steps


def _deflection(
    sheet: Sheet,
    at: str,
    found: Deflection,
    kind: str = "",
    prime: str = "",
    *,
    stepped: bool = False,
    **said: str,
) -> None:
    """Add both parts of the deflection at B or C, and its size."""
    code = f"{kind}deflection_{at}"
    for axis, value, equation in (("x", found.x, "35, 36"), ("y", found.y, "33, 34")):
        symbol, by = f"{axis}{prime}_{at}", _by(equation, "mohr")
        if stepped:
            of = f"a b E B_{axis} C_{axis}"
            sheet.state(code, symbol, "stretches", of, value, **by)
        else:
            formula = ONE_DIAMETER[at].replace("#", axis)
            sheet.work(code, symbol, formula, value, **by, **said)
    formula = f"sqrt(x{prime}_{at}^2+y{prime}_{at}^2)"
    sheet.work(code, f"Delta{prime}_{at}", formula, found.total, **_by("32"))


def _strength(
    sheet: Sheet,
    found: ShaftStrength,
    sections: Sequence[ShaftSection],
    judged: dict[str, Any],
) -> None:
    """Add bending moments, stress and safety of the shaft."""
    sheet.found = found
    sheet.work("bending_moment_B", "M_B", "sqrt(C_x^2+C_y^2)*a")
    formula = "sqrt((C_x*(a+b)+B_x*b)^2+(C_y*(a+b)+B_y*b)^2)"
    sheet.work("bending_moment_clamp", "M_A", formula)
    sheet.state("peak_stress_position", "x", "most_bent")
    if len({each.diameter for each in sections}) > 1:
        sheet.state("peak_stress", "sigma", "most_bent", "M_B M_A x")
    else:
        sheet.work("peak_stress", "sigma", "32*max(M_B,M_A)/(pi*d^3)")
    sheet.take("R_e", "yield_strength", judged.get("yield_strength"))
    sheet.work("static_safety_factor", "S", "R_e/sigma")
    if isinstance(judged.get("basis"), FatigueBasis):
        with suppress(*UNKNOWN):
            _fatigue(sheet, found, sections, judged)


def _fatigue(
    sheet: Sheet, found: ShaftStrength, sections: Sequence[ShaftSection], judged: dict[str, Any]
) -> None:
    """Add the cycle of the section of least safety."""
    cycle, place = found.fatigue, found.cycle_position
    sheet.state("cycle_position", "x", "worst_section")
    sheet.state("max_stress", "sigma_max", "worst_section", "x", cycle.max_stress)
    sheet.take("r_s", "stress_ratio", -1.0)
    sheet.work("min_stress", "sigma_min", "r_s*sigma_max", cycle.min_stress)
    start, touching = 0.0, []
    for each in sections:  # if two meet there, the smaller one
        if start <= place * (1 + AS_TYPED) and place <= (start + each.length) * (1 + AS_TYPED):
            touching.append(each.diameter)
        start += each.length
    cycle_steps(sheet, cycle=cycle, diameter=min(touching), **judged)


def _contact(
    sheet: Sheet,
    load: MeshingLoad,
    found: LineContact,
    *,
    roller_radius: float,
    mating_radius: float,
    materials: tuple[ElasticMaterial, ElasticMaterial],
) -> None:
    """Add the Hertz contact of roller and tooth where the line load is largest."""
    sheet.found = found
    sheet.read(load, q="max_line_load")
    sheet.take("r_m", "mating_radius", mating_radius)
    sheet.take("rho", "roller_radius", roller_radius)
    take_materials(sheet, *materials)
    sheet.work("reduced_radius", "rho_c", "r_m*rho/(r_m+rho)", **JOHNSON)
    sheet.work("effective_modulus", "E_star", MODULUS, **JOHNSON)
    sheet.work("max_pressure", "p_0", "sqrt(q*E_star/(pi*rho_c))", **JOHNSON)
    sheet.work("half_width", "a_c", "sqrt(4*q*rho_c/(pi*E_star))", **JOHNSON)
    for index, code in enumerate(("roller_safety", "mating_safety"), 1):
        if limit := materials[index - 1].limit:
            sheet.take(f"p_P{index}", "limit", float(limit.pressure))
            sheet.work(code, f"S_{index}", f"p_P{index}/p_0")
