"""Worked steps of cycloid discs on the pins of their ring, and of involute teeth in theirs."""

import math
from contextlib import suppress

import numpy as np
from numpy.typing import ArrayLike

from core.design.results import Results
from core.errors import UNKNOWN, NotKnown
from core.hertz import effective_modulus
from core.ring.involute import InvolutePair
from core.ring.loss import RingLoss
from core.ring.profile import CycloidDisc
from core.ring.sharing import CycloidMesh, ideal_mesh
from core.worked.hertz import MODULUS, take_materials
from core.worked.step import Sheet, Step

FELT = 1e-6
"""Backlash over the radius of the base circle below which it is what decimals leave."""


def _disc(sheet: Sheet, disc: CycloidDisc) -> None:
    """Sizes of discs and ring, and of the tool."""
    change = disc.modification
    for symbol, quantity, value in (
        ("z", "satellite_teeth", disc.satellite_teeth),
        ("z_p", "ring_teeth", disc.pins),
        ("e", "eccentricity", disc.eccentricity),
        ("R_p", "ring_pin_circle_radius", disc.ring_pin_circle_radius),
        ("r_p", "ring_pin_radius", disc.ring_pin_radius),
        ("Delta_e", "equidistant", change.equidistant),
        ("Delta_p", "pin_circle", change.pin_circle),
        ("delta_r", "rotation", change.rotation),
    ):
        sheet.take(symbol, quantity, value)
    sheet.work("shortening_coefficient", "K_1", disc.shortening_coefficient, "e*z_p/R_p")


def _tool(sheet: Sheet, disc: CycloidDisc) -> None:
    sheet.work("tool_circle_radius", "R_m", disc.tool_circle_radius, "R_p+Delta_p")
    sheet.work("tool_radius", "r_m", disc.tool_radius, "r_p+Delta_e")
    sheet.work("tool_shortening", "K_m", disc.shortening, "e*z_p/R_m")


def disc_steps(disc: CycloidDisc) -> list[Step]:
    """Steps of the sizes of cycloid discs.

    Parameters
    ----------
    disc : CycloidDisc
        The discs.
    """
    sheet, pins = Sheet(), disc.pins
    _disc(sheet, disc)
    _tool(sheet, disc)
    formula = "R_m*(1+K_m)^2/(1+z_p*K_m)"
    if disc.shortening > (pins - 2) / (2 * pins - 1):
        formula = "R_m*sqrt(27*(1-K_m^2)*z)/(z_p+1)^1.5"
    sheet.work("min_path_radius", "rho_min", disc.min_path_radius, formula, note="sharpest")
    sheet.work("undercut_margin", "S_u", disc.undercut_margin, "rho_min/r_m")
    sheet.work("tip_radius", "r_a", disc.tip_radius, "R_m+e-r_m")
    sheet.work("root_radius", "r_f", disc.root_radius, "R_m-e-r_m")
    formula = "R_m*(1-K_m)^2/(z_p*K_m-1)+r_m"
    sheet.work("min_concave_radius", "rho_v", disc.min_concave_radius, formula)
    return sheet.steps


def ideal_ring_steps(*, disc: CycloidDisc, output_torque: float, satellites: int) -> list[Step]:
    """Steps of the forces of perfect discs on many pins, and of their play.

    Parameters
    ----------
    disc : CycloidDisc
        The discs.
    output_torque : float
        Torque of all discs, N*m.
    satellites : int
        How many there are.
    """
    sheet, change = Sheet(), disc.modification
    each = output_torque / satellites
    found = ideal_mesh(disc=disc, disc_torque=each)
    _disc(sheet, disc)
    sheet.take("T", "output_torque", output_torque)
    sheet.take("K", "satellites", satellites)
    sheet.work("satellite_torque", "T_j", each, "T/K")
    sheet.work("peak_force", "F_max", found.peak_force, "4*T_j/(e*z*z_p)", note="many_ring_pins")
    sheet.work("mean_sum_force", "F_sum", found.mean_sum_force, "4*T_j/(pi*e*z)")
    root = math.sqrt(1 - disc.shortening_coefficient**2)
    formula = "2*(Delta_e-Delta_p*sqrt(1-K_1^2))/(e*z)+2*delta_r"
    if change.equidistant > 0 and change.pin_circle > root * change.equidistant:
        formula = "2*K_1*sqrt(Delta_e^2-Delta_p^2)/(e*z)+2*delta_r"
    sheet.work("backlash", "j", found.backlash, formula, note="many_ring_pins")
    return sheet.steps


def pressure_steps(
    *, mesh: CycloidMesh, crank_angle: float, force: ArrayLike, pressure: float
) -> list[Step]:
    """Steps of the largest pressure of a mesh at a crank angle.

    Parameters
    ----------
    mesh : CycloidMesh
        The mesh.
    crank_angle : float
        Crank angle, rad.
    force : array, K x z_p
        Forces of all pairs there, N.
    pressure : float
        The pressure, Pa.
    """
    first, second = mesh.pin_material, mesh.disc_material
    sheet, disc = Sheet(), mesh.disc
    _disc(sheet, disc)
    _tool(sheet, disc)
    k, pins = disc.shortening, np.arange(disc.pins)
    phases = np.array(mesh.phases)[:, None]
    angle = crank_angle + phases + 2 * math.pi * pins / disc.pins
    slope = np.sqrt(1 + k**2 - 2 * k * np.cos(angle))
    bend = 1 + disc.pins * k**2 - (disc.pins + 1) * k * np.cos(angle)
    path = disc.tool_circle_radius * slope**3 / bend
    size = np.broadcast_to(mesh.pin_radii, angle.shape)
    reduced = 1 / (1 / size + 1 / (path - disc.tool_radius))
    carried = np.array(force)
    at = np.unravel_index(int((carried / reduced).argmax()), carried.shape)
    satellite, pin = (int(each) for each in at)
    where = {"params": {"satellite": satellite + 1, "pin": pin + 1}}
    sheet.take("phi", "crank_angle", crank_angle)
    sheet.take("alpha_j", "crank_angle", float(phases[satellite, 0]))
    sheet.take("k", "pin", pin + 1)
    sheet.work(
        "pin_angle", "a", angle[at], "phi+alpha_j+2*pi*(k-1)/z_p", note="hardest_pin", **where
    )
    sheet.work("path_slope", "S", slope[at], "sqrt(1+K_m^2-2*K_m*cos(a))")
    formula = "R_m*S^3/(1+z_p*K_m^2-(z_p+1)*K_m*cos(a))"
    sheet.work("path_radius", "rho_W", path[at], formula)
    if size[at] != disc.ring_pin_radius:
        sheet.take("r_p", "ring_pin_radius", size[at])
    sheet.work("reduced_radius", "rho", reduced[at], "1/(1/r_p+1/(rho_W-r_m))")
    take_materials(sheet, first=first, second=second)
    modulus = effective_modulus(first=first, second=second)
    sheet.work("effective_modulus", "E_m", modulus, MODULUS)
    sheet.take("b", "contact_length", mesh.contact_length)
    sheet.state("ring_pin_force", "F", carried[at], "solved")
    sheet.work("max_pressure", "p_0", pressure, "sqrt(F*E_m/(pi*b*rho))", source="johnson")
    return sheet.steps


def ring_loss_steps(
    *, loss: RingLoss, coefficient: float, torque: float, teeth: int, input_speed: float | None
) -> list[Step]:
    """Steps of the friction of a mesh.

    Parameters
    ----------
    loss : RingLoss
        The loss.
    coefficient : float
        Friction coefficient.
    torque : float
        On the output, N*m.
    teeth : int
        Lobes of a disc.
    input_speed : float or None
        Of the crank, rad/s.
    """
    sheet = Sheet()
    sheet.take("mu", "friction_coefficient", coefficient)
    sheet.take("T", "output_torque", torque)
    sheet.take("z", "satellite_teeth", teeth)
    sheet.take("n_1", "input_speed", input_speed)
    sheet.state("loss_per_friction", "q", loss.loss_per_friction, "over_turn")
    sheet.work("loss_ratio", "L", loss.loss_ratio, "mu*q")
    sheet.work("efficiency", "eta", loss.efficiency, "1/(1+mu*q)")
    with suppress(NotKnown):
        sheet.work("mean_loss", "P", loss.mean_loss, "L*T*n_1/z", note="turns_in_radians")
    return sheet.steps


def involute_steps(pair: InvolutePair) -> list[Step]:
    """Steps of how involute teeth of satellite and ring mesh.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    """
    sheet, teeth, line = Sheet(), pair.teeth, pair.line
    for symbol, quantity, value in (
        ("z_s", "satellite_teeth", teeth.satellite_teeth),
        ("z_r", "ring_teeth", teeth.ring_teeth),
        ("m", "module", teeth.module),
        ("alpha", "reference_pressure_angle", line.pressure_angle),
        ("e", "eccentricity", line.eccentricity),
        ("x_s", "satellite_profile_shift", teeth.satellite_profile_shift),
        ("x_r", "ring_profile_shift", teeth.ring_profile_shift),
        ("h_s", "satellite_addendum", teeth.satellite_addendum),
        ("h_r", "ring_addendum", teeth.ring_addendum),
    ):
        sheet.take(symbol, quantity, float(value))
    angle = "acos(m*(z_r-z_s)*cos(alpha)/(2*e))"
    sheet.work("operating_pressure_angle", "alpha_w", line.angle, angle)
    sheet.state("eccentricity_without_backlash", "e_0", pair.eccentricity_without_backlash, "root")
    formula = (
        "m*cos(alpha)*(2*(x_r-x_s)*tan(alpha)"
        "+(z_r-z_s)*((tan(alpha)-alpha)-(tan(alpha_w)-alpha_w)))"
    )
    base = line.satellite_base
    sheet.work("base_radius", "r_b", base, "m*z_s*cos(alpha)/2")
    if abs(pair.normal_backlash) > FELT * base:
        sheet.work("normal_backlash", "j_n", pair.normal_backlash, formula)
        sheet.work("backlash", "j", pair.backlash, "j_n/r_b")
    else:
        sheet.state("normal_backlash", "j_n", pair.normal_backlash, "felt")
    sheet.work("satellite_tip_radius", "r_s", teeth.satellite_tip, "m*(z_s/2+x_s+h_s)")
    sheet.work("ring_tip_radius", "r_r", teeth.ring_tip, "m*(z_r/2+x_r-h_r)")
    start = "(z_r*sqrt((2*r_r/(m*z_r*cos(alpha)))^2-1)-(z_r-z_s)*tan(alpha_w))/z_s"
    sheet.work("start_roll_satellite", "tau_1", pair.start_roll, start)
    sheet.work("end_roll_satellite", "tau_2", pair.end_roll, "sqrt((r_s/r_b)^2-1)")
    sheet.work("contact_ratio", "epsilon", pair.contact_ratio, "z_s*(tau_2-tau_1)/(2*pi)")
    return sheet.steps


def ring_steps(results: Results) -> list[Step]:
    """Steps of the mesh of a design with its ring: sizes; of cycloid discs pressure and friction
    under the torque.

    Parameters
    ----------
    results : Results
        Results of a design of which it is solved.
    """
    if results.design.gear.kind == "involute":
        return involute_steps(results.ring.pair)
    turn, design = results.ring.working[0], results.design
    steps = disc_steps(turn.mesh.disc)
    pressed = pressure_steps(
        mesh=turn.mesh,
        crank_angle=turn.hardest_place[1],
        force=turn.forces_at(turn.hardest_place[1]),
        pressure=turn.max_pressure,
    )
    steps += [each for each in pressed if each not in steps]
    with suppress(*UNKNOWN):
        steps += ring_loss_steps(
            loss=results.ring.loss,
            coefficient=design.gear.friction.coefficient,
            torque=abs(design.pin_torque),
            teeth=turn.mesh.disc.satellite_teeth,
            input_speed=design.turning_speed and abs(design.turning_speed),
        )
    return steps
