"""Worked steps of the precessional gear: contact lines, load of the mesh, shaft."""

import math
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from core.design.sections import FatigueBasis
from core.errors import UNKNOWN, if_known
from core.hertz import ElasticMaterial
from core.precession.contact_line import ContactLine, ContactLines
from core.precession.line_contact import LineContact
from core.precession.meshing_load import MeshingLoad
from core.precession.shaft import ShaftSection, shaft_pieces
from core.precession.shaft_deflection import Deflection, ShaftDeflection
from core.precession.shaft_strength import ShaftStrength
from core.precision import AS_TYPED
from core.worked.fatigue import cycle_steps
from core.worked.hertz import JOHNSON, MODULUS, take_materials
from core.worked.step import MOST_TERMS, Sheet, Step, total

SOURCE = "khatetovsky2020"


def _gear(sheet: Sheet, gear: dict[str, float], line: ContactLine) -> None:
    """The gear's sizes, and the length A of its contact lines."""
    sheet.take("R_C", "roller_circle_radius", gear["roller_circle_radius"])
    sheet.take("rho", "roller_radius", gear["roller_radius"])
    sheet.take("theta", "nutation_angle", gear["nutation_angle"])
    sheet.take("u_12", "ratio_u12", gear["ratio_u12"])
    formula = "R_C*(cos(theta)-u_12)/sin(theta)"
    sheet.work("scale", "A", line.curve.scale, formula, source=SOURCE, equation="1")


def line_steps(*, gear: dict[str, float], found: ContactLines, by_angle: bool) -> list[Step]:
    """Steps of the contact lines: the first is worked, the others go the same way.

    Parameters
    ----------
    gear : dict
        `roller_circle_radius`, `roller_radius`, `nutation_angle`, `ratio_u12`.
    found : ContactLines
        The lines.
    by_angle : bool
        Whether the first roller's line is given by its polar angles.
    """
    sheet, line = Sheet(), found.lines[0]
    _gear(sheet, gear, line)
    sheet.take("phi_1", "position_angle", line.position_angle)
    said = {"source": SOURCE, "equation": "1"}
    if by_angle:
        _ends_by_angle(sheet, line, said)
    else:
        _ends_by_length(sheet, line, said)
    sheet.state(
        "length", "s_1", line.length, "quadrature", source=SOURCE, equation="4, 5", erratum="slope"
    )
    marks = [str(i + 1) for i in range(len(found.lines))]
    eight = {"source": SOURCE, "equation": "8"}
    for mark, each in zip(marks, found.lines, strict=True):
        sheet.take(f"s_{mark}", "length", each.length)
    if 1 < len(marks) <= MOST_TERMS:
        formula = total("s_#", marks=marks)[1:-1]
        sheet.work("total_length", "S", found.total_length, formula, **eight, note="others")
    else:
        sheet.state("total_length", "S", found.total_length, "others", **eight)
    return sheet.steps


def _ends_by_length(sheet: Sheet, line: ContactLine, said: dict[str, str]) -> None:
    """Polar angles of the ends: half-turns lead to the flank that carries."""
    scale, angle = line.curve.scale, line.position_angle
    sheet.take("h", "half_turn", math.pi)
    for code, symbol, polar in (
        ("phi_min", "phi_min", line.phi_min),
        ("phi_max", "phi_max", line.phi_max),
    ):
        places = {}
        for z in (line.z_min, line.z_max):
            flat = math.atan(-z * math.sin(angle) / (scale + z * math.cos(angle)))
            places[abs(math.sin(polar - flat))] = z, flat
        z, flat = places[min(places)]
        sheet.take("z", "z", z)
        sheet.take("k", "half_turns", round((polar - flat) / math.pi))
        formula = "atan(-z*sin(phi_1)/(A+z*cos(phi_1)))+k*h"
        sheet.work(code, symbol, polar, formula, **said, note="flank")


def _ends_by_angle(sheet: Sheet, line: ContactLine, said: dict[str, str]) -> None:
    scale, angle = line.curve.scale, line.position_angle
    for code, symbol, end in (("z_min", "z_a", line.z_min), ("z_max", "z_b", line.z_max)):
        polar = min(
            (line.phi_min, line.phi_max),
            key=lambda phi: abs(-scale * math.sin(phi) / math.sin(phi + angle) - end),
        )
        sheet.take("phi", "polar_angle", polar)
        sheet.work(code, symbol, end, "-A*sin(phi)/sin(phi+phi_1)", **said)


def load_steps(
    *, gear: dict[str, float], found: MeshingLoad, torque: float, reference_z: float
) -> list[Step]:
    """Steps of the load of the mesh.

    Parameters
    ----------
    gear : dict
        As of `line_steps`.
    found : MeshingLoad
        The load.
    torque, reference_z : float
        Torque M1, N*m, and place l of C, m.
    """
    sheet = Sheet()
    _gear(sheet, gear, found.lines[0])
    sheet.take("M_1", "torque", torque)
    sheet.take("S", "total_length", found.total_length)
    sheet.take("l", "reference_z", reference_z)
    full = torque / found.total_length / gear["roller_circle_radius"]
    eight = {"source": SOURCE, "equation": "8"}
    sheet.work("full_arm_load", "q_C", full, "M_1/(S*R_C)", **eight)
    said = {"source": SOURCE, "erratum": "normal"}
    (x, y, z), (about_x, about_y, about_z) = found.force, found.moment
    sheet.state("force", "F_x", x, "along_x", **said, equation="12")
    sheet.state("force", "F_y", y, "along_y", **said, equation="13")
    sheet.state("force", "F_z", z, "no_axial", source=SOURCE, equation="14")
    sheet.state("moment", "M_Cx", about_x, "about_x", **said, equation="15")
    sheet.state("moment", "M_Cy", about_y, "about_y", **said, equation="16")
    sheet.state("moment", "M_Cz", about_z, "own_torque", source=SOURCE, equation="17")
    ends = [phi for line in found.lines for phi in (line.phi_min, line.phi_max)]
    sheet.take("phi", "polar_angle", min(ends, key=lambda phi: abs(math.sin(phi))))
    formula = "abs(M_1)/(S*R_C*abs(sin(phi)))"
    sheet.work("max_line_load", "q", found.max_line_load, formula, **eight, note="least_arm")
    return sheet.steps


ONE_DIAMETER = {
    "B": "-64/(pi*E*d^4)*(C_#*(b^3/3+a*b^2/2)+B_#*b^3/3)",
    "C": "-64/(pi*E*d^4)*(C_#*(a+b)^3/3+B_#*(b^3/3+a*b^2/2))",
}
"""Mohr's integrals of one diameter in closed form."""


class _Shaft:
    """Stretches of one diameter, from C on, cut at B."""

    def __init__(
        self, sections: Sequence[ShaftSection], bearing_distance: float, overhang: float
    ) -> None:
        self.stretches: list[tuple[float, float, float, bool]] = []
        self.distance, self.overhang = bearing_distance, overhang
        for piece in shaft_pieces(
            sections=sections, bearing_distance=bearing_distance, overhang=overhang
        ):
            start = bearing_distance if piece.behind_b else 0.0
            near, far = start + piece.near, start + piece.far
            self.stretches.append((min(near, far), max(near, far), piece.diameter, piece.behind_b))
        self.stretches.sort()

    @property
    def least(self) -> float:
        """The smallest diameter, m."""
        return min(each[2] for each in self.stretches)

    @property
    def stepped(self) -> bool:
        """Whether there are several diameters."""
        return len({each[2] for each in self.stretches}) > 1

    def diameter_at(self, place: float) -> float:
        """The diameter at a place, m; where two meet the smaller."""
        return min(
            diameter
            for start, end, diameter, _ in self.stretches
            if start <= place * (1 + AS_TYPED) and place <= end * (1 + AS_TYPED)
        )

    def take(self, sheet: Sheet) -> None:
        """Let ends and diameters be known."""
        for i, (start, end, diameter, _) in enumerate(self.stretches):
            sheet.take(f"x_{i}", "position", start)
            sheet.take(f"x_{i + 1}", "position", end)
            sheet.take(f"d_{i + 1}", "diameter", diameter)

    def integral(self, at: str, axis: str) -> str:
        """Mohr's integral over the stretches."""
        cubes, mixed, behind = [], [], []
        for i, (*_, loaded) in enumerate(self.stretches):
            s, t, d = f"x_{i}", f"x_{i + 1}", f"d_{i + 1}"
            cubes.append(f"({t}^3-{s}^3)/(3*{d}^4)")
            if loaded:
                mixed.append(f"(({t}^3-{s}^3)/3-a*({t}^2-{s}^2)/2)/{d}^4")
                behind.append(f"(({t}-a)^3-({s}-a)^3)/(3*{d}^4)")
        first, second = (cubes, mixed) if at == "C" else (mixed, behind)
        return f"-64/(pi*E)*(C_{axis}*({'+'.join(first)})+B_{axis}*({'+'.join(second)}))"


def shaft_steps(
    *,
    load: MeshingLoad,
    found: ShaftDeflection,
    shaft_sections: Sequence[ShaftSection],
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    strength: ShaftStrength | None = None,
    judged: dict[str, Any] | None = None,
    contact: tuple[LineContact, dict[str, Any]] | None = None,
) -> list[Step]:
    """Steps of the shaft: reactions, deflections, strength, and the contact of the lines.

    Parameters
    ----------
    load : MeshingLoad
        The load of the mesh.
    found : ShaftDeflection
        Reactions and deflections.
    shaft_sections : sequence of ShaftSection
        The shaft from C to the clamp.
    bearing_distance, overhang, youngs_modulus : float
        a and b, m, and E, Pa.
    strength : ShaftStrength, optional
        Its strength.
    judged : dict, optional
        What the strength is judged by: `basis`, `tensile_strength`, `yield_strength`.
    contact : tuple, optional
        Contact along the lines, and `roller_radius`, `mating_radius`, `materials` of it.
    """
    sheet, shaft = Sheet(), _Shaft(shaft_sections, bearing_distance, overhang)
    sheet.take("a", "bearing_distance", bearing_distance)
    sheet.take("b", "overhang", overhang)
    sheet.take("E", "youngs_modulus", youngs_modulus)
    for axis, force, moment in zip("xy", load.force, load.moment, strict=False):
        sheet.take(f"F_{axis}", "force", force)
        sheet.take(f"M_C{axis}", "moment", moment)
    said = {"source": SOURCE}
    (b_x, b_y), (c_x, c_y) = found.reaction_B, found.reaction_C
    sheet.work("reaction_B", "B_x", b_x, "-M_Cy/a", **said, equation="30")
    sheet.work("reaction_B", "B_y", b_y, "M_Cx/a", **said, equation="31")
    sheet.work("reaction_C", "C_x", c_x, "-F_x-B_x", **said, equation="28", erratum="reaction")
    sheet.work("reaction_C", "C_y", c_y, "-F_y-B_y", **said, equation="29")
    for at, each in (("B", found.deflection_B), ("C", found.deflection_C)):
        _deflection(sheet, shaft, at, each)
    for at, simple, error in (
        ("B", found.simplified_deflection_B, found.simplification_error_B),
        ("C", found.simplified_deflection_C, found.simplification_error_C),
    ):
        if simple:
            _deflection(sheet, shaft, at, simple, simplified=True)
            code, formula = f"simplification_error_{at}", f"Delta_prime_{at}/Delta_{at}-1"
            sheet.work(code, f"epsilon_{at}", error, formula)
    if strength:
        _strength(sheet, shaft, strength, judged or {})
    if contact:
        _contact(sheet, load, contact[0], **contact[1])
    return sheet.steps


def _deflection(
    sheet: Sheet, shaft: _Shaft, at: str, found: Deflection, *, simplified: bool = False
) -> None:
    """Deflection at B or C: both parts, and their size."""
    stepped = shaft.stepped and not simplified
    prime = "_prime" if simplified else ""
    code = f"simplified_deflection_{at}" if simplified else f"deflection_{at}"
    if stepped:
        shaft.take(sheet)
    sheet.take("d", "diameter", shaft.least)
    note = {"note": "stretches"} if stepped else {"note": "smallest"} if simplified else {}
    for axis, value, equation in (("x", found.x, "35, 36"), ("y", found.y, "33, 34")):
        formula = shaft.integral(at, axis) if stepped else ONE_DIAMETER[at].replace("#", axis)
        said = {"source": SOURCE, "equation": equation, "erratum": "mohr", **note}
        if stepped and len(shaft.stretches) > MOST_TERMS:
            sheet.state(code, f"{axis}{prime}_{at}", value, "stretches", source=SOURCE)
        else:
            sheet.work(code, f"{axis}{prime}_{at}", value, formula, **said)
    formula = f"sqrt(x{prime}_{at}^2+y{prime}_{at}^2)"
    sheet.work(code, f"Delta{prime}_{at}", found.total, formula, source=SOURCE, equation="32")


def _strength(sheet: Sheet, shaft: _Shaft, found: ShaftStrength, judged: dict[str, Any]) -> None:
    formula = "sqrt(C_x^2+C_y^2)*a"
    sheet.work("bending_moment_B", "M_B", found.bending_moment_B, formula)
    formula = "sqrt((C_x*(a+b)+B_x*b)^2+(C_y*(a+b)+B_y*b)^2)"
    sheet.work("bending_moment_clamp", "M_A", found.bending_moment_clamp, formula)
    place = found.peak_stress_position
    sheet.state("peak_stress_position", "x", place, "most_bent")
    if shaft.stepped:
        sheet.state("peak_stress", "sigma", found.peak_stress, "most_bent")
    else:
        sheet.take("d", "diameter", shaft.least)
        formula = "32*max(M_B,M_A)/(pi*d^3)"
        sheet.work("peak_stress", "sigma", found.peak_stress, formula)
    sheet.take("R_e", "yield_strength", judged.get("yield_strength"))
    safety = if_known(lambda: found.static_safety_factor)
    sheet.work("static_safety_factor", "S", safety, "R_e/sigma")
    if isinstance(judged.get("basis"), FatigueBasis):
        with suppress(*UNKNOWN):
            _fatigue(sheet, shaft, found, **judged)


def _fatigue(
    sheet: Sheet,
    shaft: _Shaft,
    found: ShaftStrength,
    *,
    basis: FatigueBasis,
    tensile_strength: float,
    yield_strength: float | None,
) -> None:
    """The cycle of the section of least safety."""
    cycle = found.fatigue
    sheet.state("cycle_position", "x", found.cycle_position, "worst_section")
    sheet.state("max_stress", "sigma_max", cycle.max_stress, "worst_section")
    sheet.take("r_s", "stress_ratio", -1.0)
    sheet.work("min_stress", "sigma_min", cycle.min_stress, "r_s*sigma_max")
    cycle_steps(
        sheet,
        cycle=cycle,
        basis=basis,
        diameter=shaft.diameter_at(found.cycle_position),
        tensile_strength=tensile_strength,
        yield_strength=yield_strength,
    )


def _contact(
    sheet: Sheet,
    load: MeshingLoad,
    found: LineContact,
    *,
    roller_radius: float,
    mating_radius: float,
    materials: tuple[ElasticMaterial, ElasticMaterial],
) -> None:
    """Hertz contact of roller and tooth where the line load is largest."""
    sheet.take("q", "max_line_load", load.max_line_load)
    sheet.take("r_m", "mating_radius", mating_radius)
    sheet.take("rho", "roller_radius", roller_radius)
    take_materials(sheet, first=materials[0], second=materials[1])
    formula = "r_m*rho/(r_m+rho)"
    sheet.work("reduced_radius", "rho_c", found.reduced_radius, formula, **JOHNSON)
    sheet.work("effective_modulus", "E_star", found.effective_modulus, MODULUS, **JOHNSON)
    sheet.work("max_pressure", "p_0", found.max_pressure, "sqrt(q*E_star/(pi*rho_c))", **JOHNSON)
    sheet.work("half_width", "a_c", found.half_width, "sqrt(4*q*rho_c/(pi*E_star))", **JOHNSON)
    for index, code in enumerate(("roller_safety", "mating_safety"), 1):
        if limit := materials[index - 1].limit:
            sheet.take(f"p_P{index}", "limit", float(limit.pressure))
            sheet.work(code, f"S_{index}", getattr(found, code), f"p_P{index}/p_0")
