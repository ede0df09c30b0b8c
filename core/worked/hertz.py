"""Worked steps of the contact of pin and hole."""

import math
from contextlib import suppress
from typing import Any

from core.contact_life import CURVES
from core.design.real_forces import RealForces
from core.design.results import Results
from core.errors import NotKnown, if_known
from core.hertz import (
    SHEAR_DEPTH,
    SHEAR_RATIO,
    BodySafety,
    ElasticMaterial,
    HertzContact,
    LimitLife,
)
from core.precision import AS_TYPED
from core.worked.step import Sheet, Step

PAPER = {"source": "yanchevsky2018", "equation": "2"}
JOHNSON = {"source": "johnson"}
PERSSON = {"source": "persson"}

BODIES = {"pin": (1, "safety_pin"), "hole": (2, "safety_hole")}
"""Number of each body, and the code of its safety."""

MODULUS = "1/((1-nu_1^2)/E_1+(1-nu_2^2)/E_2)"


def take_materials(sheet: Sheet, *materials: ElasticMaterial) -> None:
    """Let E_1, nu_1 and E_2, nu_2 be known."""
    for index, each in enumerate(materials, 1):
        names = {f"E_{index}": "youngs_modulus", f"nu_{index}": "poissons_ratio"}
        sheet.read(each, **names)


def hertz_steps(
    *,
    found: HertzContact,
    line_load_factor: float = 1.0,
    turning: tuple[float | None, float, float] = (None, math.inf, math.inf),
    **pressed: Any,
) -> list[Step]:
    """Steps of the contact; `pressed` has the arguments of `core.hertz.hertz`. `line_load_factor`
    is K_b of pins that bend; `turning` are speed of the crank, rad/s, life, s, and ratio, if limits
    fall over the life.
    """
    sheet = Sheet(found)
    given = {"dynamic_factor": 1.0, "distribution_factor": 1.0} | pressed
    sheet.read(given, F="force", b="contact_length", r_in="pin_radius", r_out="hole_radius")
    sheet.read(given, K_A="dynamic_factor", K_alpha="distribution_factor")
    take_materials(sheet, given["pin_material"], given["hole_material"])
    force, length, *factors = (sheet.known[name].value for name in ("F", "b", "K_A", "K_alpha"))
    load, formula = force / length * factors[0] * factors[1], "F/b*K_A*K_alpha"
    if line_load_factor != 1.0:
        sheet.state("line_load_factor", "K_b", "edge", value=line_load_factor)
        load, formula = load * line_load_factor, formula + "*K_b"
    sheet.work("line_load", "w", formula, load, **PAPER)
    sheet.work("reduced_radius", "rho", "r_out*r_in/(r_out-r_in)", **PAPER)
    sheet.work("effective_modulus", "E_star", MODULUS, **PAPER)
    sheet.work("max_pressure", "p_0", "sqrt(w*E_star/(pi*rho))", **PAPER)
    sheet.take("k_m", "factor", math.pi / 4)
    sheet.work("mean_pressure", "p_m", "k_m*p_0", **JOHNSON)
    sheet.work("half_width", "a", "sqrt(4*w*rho/(pi*E_star))", **JOHNSON)
    sheet.work("half_width_ratio", "a_r", "a/r_in", note="narrow")
    sheet.take("k_tau", "factor", SHEAR_RATIO)
    sheet.work("max_shear", "tau", "k_tau*p_0", **JOHNSON)
    sheet.take("k_z", "factor", SHEAR_DEPTH)
    sheet.work("max_shear_depth", "z", "k_z*a", **JOHNSON)
    if found.is_conformal:
        _conformal(sheet, found, load, given["hole_radius"] - given["pin_radius"])
    with suppress(NotKnown):
        pressure = found.governing_pressure
        by = "governs_conformal" if found.is_conformal else "governs_hertz"
        sheet.state("governing_pressure", "p_g", by, value=pressure)
        for each in found.safety:
            _safety(sheet, each, turning)
        sheet.work("safety_factor", "S", "min(S_1,S_2)", note="smaller")
    return sheet.steps


def _conformal(sheet: Sheet, found: HertzContact, load: float, difference: float) -> None:
    """Add the conformal contact: its pressures are solved by the load and both materials."""
    value = float(found.effective_modulus) * difference / load
    sheet.work("load_parameter", "lambda", "E_star*(r_out-r_in)/w", value, **PERSSON)
    alpha, beta = found.mismatch
    formula = "E_star*((1-nu_2^2)/E_2-(1-nu_1^2)/E_1)"
    sheet.work("mismatch_alpha", "alpha", formula, alpha, **JOHNSON)
    formula = "E_star/2*((1-2*nu_2)*(1+nu_2)/E_2-(1-2*nu_1)*(1+nu_1)/E_1)"
    sheet.work("mismatch_beta", "beta", formula, beta, **JOHNSON)
    of = "lambda alpha beta"
    sheet.state("conformal_half_angle", "eps", "integral_equation", of, **PERSSON)
    of = "eps alpha beta w r_in r_out"
    sheet.state("conformal_pressure", "p_c", "integral_equation", of, **PERSSON)
    sheet.work("conformal_half_angle_pin", "eps_pin", "eps*sqrt(r_out/r_in)")
    sheet.work("conformal_half_angle_hole", "eps_hole", "eps*sqrt(r_in/r_out)")
    sheet.work("conformal_half_length", "s_arc", "eps*sqrt(r_out*r_in)")
    sheet.state("edge_tension", "sigma_t", "edge_tension", f"{of} nu_2")


def _safety(sheet: Sheet, body: BodySafety, turning: tuple[float | None, float, float]) -> None:
    """Add the safety of a body by its own limit, under the pressure that governs."""
    (index, code), limit = BODIES[body.body], body.limit
    formula = f"p_P{index}/p_g"
    if life := if_known(lambda: limit.life):
        _life(sheet, index, life, turning)
        formula = f"p_P{index}*Z_NT{index}/p_g"
    sheet.take(f"p_P{index}", "limit", float(limit.pressure))
    said: dict[str, Any] = {"note": "limit_given"}
    if limit.source:
        said = {"note": "limit", "params": {"criterion": limit.criterion, "source": limit.source}}
    sheet.work(code, f"S_{index}", formula, body.safety_factor, **said)


def _life(
    sheet: Sheet, index: int, life: LimitLife, turning: tuple[float | None, float, float]
) -> None:
    """Add the factor by which the limit of a body falls over the life."""
    speed, time, ratio = turning
    if speed is None:
        sheet.take("N_L", "loads", life.loads)
    else:
        sheet.take("n_1", "turning_speed", speed)
        sheet.take("L", "life", time)
        formula = f"n_1{sheet.take_ratio(ratio)}*L/(2*pi)"
        sheet.work("loads", "N_L", formula, life.loads, note="turns_over_life")
    line = CURVES[life.curve]
    sheet.take("Z_m", "factor", line.most)
    sheet.take("N_k", "loads", line.knee)
    sheet.take("m", "exponent", line.before if life.loads < line.knee else line.beyond)
    said = {"source": "iso6336", "note": "life_of_teeth"}
    sheet.work("life_factor", f"Z_NT{index}", "min(Z_m,(N_k/N_L)^m)", life.factor, **said)


def judged_steps(results: Results) -> list[Step]:
    """Steps of the contact of a design that is judged."""
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
