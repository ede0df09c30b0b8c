"""Worked steps of the contact of pin and hole."""

import math
from contextlib import suppress
from typing import Any

from core.contact_life import CURVES
from core.design.real_forces import RealForces
from core.design.results import Results
from core.errors import NotKnown, if_known, required
from core.hertz import SHEAR_DEPTH, SHEAR_RATIO, ElasticMaterial, HertzContact, LimitLife
from core.precision import AS_TYPED
from core.worked.step import Sheet, Step

PAPER = {"source": "yanchevsky2018", "equation": "2"}
JOHNSON = {"source": "johnson"}
PERSSON = {"source": "persson"}

MODULUS = "1/((1-nu_1^2)/E_1+(1-nu_2^2)/E_2)"


def take_materials(sheet: Sheet, *, first: ElasticMaterial, second: ElasticMaterial) -> None:
    """Let E_1, nu_1 and E_2, nu_2 be known.

    Parameters
    ----------
    sheet : Sheet
        Where.
    first, second : ElasticMaterial
        The materials.
    """
    for index, each in ((1, first), (2, second)):
        sheet.take(f"E_{index}", "youngs_modulus", float(each.youngs_modulus))
        sheet.take(f"nu_{index}", "poissons_ratio", float(each.poissons_ratio))


def hertz_steps(
    *,
    found: HertzContact,
    force: float,
    contact_length: float,
    pin_radius: float,
    hole_radius: float,
    pin_material: ElasticMaterial,
    hole_material: ElasticMaterial,
    dynamic_factor: float = 1.0,
    distribution_factor: float = 1.0,
    line_load_factor: float = 1.0,
    turning: tuple[float | None, float, float] = (None, math.inf, math.inf),
) -> list[Step]:
    """Steps of the contact.

    Parameters
    ----------
    found : HertzContact
        The contact.
    force, contact_length, pin_radius, hole_radius : float
        F, N, b, r_in and r_out, m.
    pin_material, hole_material : ElasticMaterial
        Materials, their limits wanted for the loads over the life.
    dynamic_factor, distribution_factor, line_load_factor : float
        K_A, K_alpha, and K_b of pins that bend.
    turning : tuple of float, optional
        Speed of the crank, rad/s, life, s, and ratio, where limits fall over the life.
    """
    sheet = Sheet()
    sheet.take("F", "force", force)
    sheet.take("b", "contact_length", contact_length)
    sheet.take("K_A", "dynamic_factor", dynamic_factor)
    sheet.take("K_alpha", "distribution_factor", distribution_factor)
    load, formula = force / contact_length * dynamic_factor * distribution_factor, "F/b*K_A*K_alpha"
    if line_load_factor != 1.0:
        sheet.state("line_load_factor", "K_b", line_load_factor, "edge")
        load, formula = load * line_load_factor, formula + "*K_b"
    sheet.work("line_load", "w", load, formula, **PAPER)
    sheet.take("r_in", "pin_radius", pin_radius)
    sheet.take("r_out", "hole_radius", hole_radius)
    formula = "r_out*r_in/(r_out-r_in)"
    sheet.work("reduced_radius", "rho", found.reduced_radius, formula, **PAPER)
    take_materials(sheet, first=pin_material, second=hole_material)
    sheet.work("effective_modulus", "E_star", found.effective_modulus, MODULUS, **PAPER)
    sheet.work("max_pressure", "p_0", found.max_pressure, "sqrt(w*E_star/(pi*rho))", **PAPER)
    sheet.take("k_m", "factor", math.pi / 4)
    sheet.work("mean_pressure", "p_m", found.mean_pressure, "k_m*p_0", **JOHNSON)
    sheet.work("half_width", "a", found.half_width, "sqrt(4*w*rho/(pi*E_star))", **JOHNSON)
    sheet.work("half_width_ratio", "a_r", found.half_width_ratio, "a/r_in", note="narrow")
    sheet.take("k_tau", "factor", SHEAR_RATIO)
    sheet.work("max_shear", "tau", found.max_shear, "k_tau*p_0", **JOHNSON)
    sheet.take("k_z", "factor", SHEAR_DEPTH)
    sheet.work("max_shear_depth", "z", found.max_shear_depth, "k_z*a", **JOHNSON)
    with suppress(NotKnown):
        _conformal(sheet, found)
    with suppress(NotKnown):
        _safety(sheet, found, turning)
    return sheet.steps


def _conformal(sheet: Sheet, found: HertzContact) -> None:
    """The conformal contact: its angle is the root of an equation, and of materials whose beta is
    not 0 its pressure follows from another.
    """
    pressure, angle = found.arc.pressure, float(found.arc.half_angle)
    tension = required(found.edge_tension, "conformal_solution")
    known = {name: each.value for name, each in sheet.known.items()}
    difference, load, modulus = known["r_out"] - known["r_in"], known["w"], known["E_star"]
    formula = "E_star*(r_out-r_in)/w"
    sheet.work("load_parameter", "lambda", modulus * difference / load, formula, **PERSSON)
    alpha, beta = found.mismatch
    formula = "E_star*((1-nu_2^2)/E_2-(1-nu_1^2)/E_1)"
    sheet.work("mismatch_alpha", "alpha", alpha, formula, **JOHNSON)
    formula = "E_star/2*((1-2*nu_2)*(1+nu_2)/E_2-(1-2*nu_1)*(1+nu_1)/E_1)"
    sheet.work("mismatch_beta", "beta", beta, formula, **JOHNSON)
    radius = math.sqrt(known["r_in"] * known["r_out"])
    share = (3 - 4 * known["nu_2"]) / (2 * math.pi * (1 - known["nu_2"]))
    mean = (tension / load * radius - share * math.cos(angle)) / 2
    method = "integral_equation" if beta else "conformal_angle"
    sheet.state("conformal_half_angle", "eps", angle, method, **PERSSON)
    t, b = "tan(eps/2)", math.tan(angle / 2)
    if beta == 0:
        sheet.state("logarithm", "l_1", math.log1p(b * b), "conformal_logarithm", **PERSSON)
        bent = math.log1p(b * b) + 2 * b**4
        again = (2 - (1 + alpha) * bent) / (2 * math.pi * b * b * (1 + b * b))
        formula = f"(2-(1+alpha)*(l_1+2*{t}^4))/(2*pi*{t}^2*(1+{t}^2))"
        sheet.work("load_parameter_again", "lambda", again, formula, **PERSSON)
        second = 2 * math.atanh(b / math.sqrt(1 + b * b))
        sheet.state("logarithm", "l_2", second, "conformal_logarithm_of_pressure", **PERSSON)
        formula = f"w/sqrt(r_out*r_in)*(2*{t}/(pi*sqrt(1+{t}^2))+l_2/(2*pi*{t}^2*(1+{t}^2)))"
        sheet.work("conformal_pressure", "p_c", pressure, formula, **PERSSON)
        formula = f"(l_1+2*{t}^4)/(2*pi*{t}^2*(1+{t}^2))"
        sheet.work("mean_rim_pressure", "P_0", mean, formula, **PERSSON)
    else:
        sheet.state("middle_pressure", "P_m", pressure / load * radius, "integral_equation")
        sheet.work("conformal_pressure", "p_c", pressure, "w/sqrt(r_out*r_in)*P_m", **PERSSON)
        sheet.state("mean_rim_pressure", "P_0", mean, "integral_equation")
    for name, symbol, formula in (
        ("half_angle_pin", "eps_pin", "eps*sqrt(r_out/r_in)"),
        ("half_angle_hole", "eps_hole", "eps*sqrt(r_in/r_out)"),
        ("half_length", "s_arc", "eps*sqrt(r_out*r_in)"),
    ):
        code = f"conformal_{name}"
        sheet.work(code, symbol, getattr(found, code), formula)
    formula = "w/sqrt(r_out*r_in)*(2*P_0+(3-4*nu_2)/(2*pi*(1-nu_2))*cos(eps))"
    sheet.work("edge_tension", "sigma_t", found.edge_tension, formula, note="edge_tension")


def _safety(
    sheet: Sheet,
    found: HertzContact,
    turning: tuple[float | None, float, float],
) -> None:
    """Each body with a limit by this, under the pressure that governs; the smaller of both."""
    pressure = found.governing_pressure
    by = "governs_conformal" if found.is_conformal else "governs_hertz"
    sheet.state("governing_pressure", "p_g", pressure, by)
    for each in found.safety:
        index, limit = (1 if each.body == "pin" else 2), each.limit
        formula = f"p_P{index}/p_g"
        if life := if_known(lambda limit=limit: limit.life):  # type: ignore[misc]
            _life(sheet, index, life, turning)
            formula = f"p_P{index}*Z_NT{index}/p_g"
        sheet.take(f"p_P{index}", "limit", float(limit.pressure))
        said: dict[str, Any] = {"note": "limit_given"}
        if limit.source:
            params = {"criterion": limit.criterion, "source": limit.source}
            said = {"note": "limit", "params": params}
        sheet.work(f"safety_{each.body}", f"S_{index}", each.safety_factor, formula, **said)
    sheet.work("safety_factor", "S", found.safety_factor, "min(S_1,S_2)", note="smaller")


def _life(
    sheet: Sheet, index: int, life: LimitLife, turning: tuple[float | None, float, float]
) -> None:
    """How the limit of a body falls over the life."""
    speed, time, ratio = turning
    if speed is None:
        sheet.take("N_L", "loads", life.loads)
    else:
        sheet.take("n_1", "turning_speed", speed)
        sheet.take("L", "life", time)
        formula = f"n_1{sheet.take_ratio(ratio)}*L/(2*pi)"
        sheet.work("loads", "N_L", life.loads, formula, note="turns_over_life")
    line = CURVES[life.curve]
    sheet.take("Z_m", "factor", line.most)
    sheet.take("N_k", "loads", line.knee)
    sheet.take("m", "exponent", line.before if life.loads < line.knee else line.beyond)
    sheet.work(
        "life_factor",
        f"Z_NT{index}",
        life.factor,
        "min(Z_m,(N_k/N_L)^m)",
        source="iso6336",
        note="life_of_teeth",
    )


def judged_steps(results: Results) -> list[Step]:
    """Steps of the contact of a design that is judged.

    Parameters
    ----------
    results : Results
        Results of a design with a load and a contact.
    """
    design, found, force = results.design, results.hertz, results.judged_forces
    length, radius, hole = design.nominal_pair
    real = isinstance(force, RealForces)
    if real:  # with what deviates of them
        own = float(found.half_width / found.half_width_ratio)
        wide = float(found.reduced_radius * own / (found.reduced_radius - own))
        radius = radius if math.isclose(radius, own, rel_tol=AS_TYPED) else own
        hole = hole if math.isclose(hole, wide, rel_tol=AS_TYPED) else wide
    return hertz_steps(
        found=found,
        force=force.force if isinstance(force, RealForces) else force.peak_force,
        contact_length=length,
        pin_radius=radius,
        hole_radius=hole,
        pin_material=design.lasting["pin"],
        hole_material=design.lasting["hole"],
        dynamic_factor=1.0 if real else design.load_factor,
        distribution_factor=1.0 if real else design.distribution_factor,
        line_load_factor=results.line_load_factor if design.pin else 1.0,
        turning=(design.turning_speed, design.life, design.mechanism.ratio),
    )
