"""Worked steps of cycloid discs on the pins of their ring, and of involute teeth in theirs."""

import math
from contextlib import suppress

import numpy as np
from numpy.typing import ArrayLike

from core.design.results import Results
from core.errors import UNKNOWN
from core.hertz import effective_modulus
from core.ring.involute import InvolutePair
from core.ring.loss import RingLoss
from core.ring.profile import CycloidDisc
from core.ring.sharing import CycloidMesh, ideal_mesh
from core.worked.hertz import MODULUS, take_materials
from core.worked.step import Sheet, Step

FELT = 1e-6
"""Backlash over the radius of the base circle below which it is what decimals leave."""


def _sheet(disc: CycloidDisc, found: object = None) -> Sheet:
    """Sheet on which sizes of discs and ring are known."""
    sheet = Sheet(found or disc)
    sheet.read(disc, z="satellite_teeth", e="eccentricity")
    sheet.read(disc, R_p="ring_pin_circle_radius", r_p="ring_pin_radius")
    sheet.read(disc.modification, Delta_e="equidistant", Delta_p="pin_circle", delta_r="rotation")
    sheet.take("z_p", "ring_teeth", disc.pins)
    value = disc.shortening_coefficient
    sheet.work("shortening_coefficient", "K_1", "e*z_p/R_p", value)
    return sheet


def _tool(sheet: Sheet, disc: CycloidDisc) -> None:
    """Add the sizes of the tool."""
    sheet.work("tool_circle_radius", "R_m", "R_p+Delta_p", disc.tool_circle_radius)
    sheet.work("tool_radius", "r_m", "r_p+Delta_e", disc.tool_radius)
    sheet.work("tool_shortening", "K_m", "e*z_p/R_m", disc.shortening)


def disc_steps(disc: CycloidDisc) -> list[Step]:
    """Steps of the sizes of cycloid discs."""
    sheet, pins = _sheet(disc), disc.pins
    _tool(sheet, disc)
    formula = "R_m*(1+K_m)^2/(1+z_p*K_m)"
    if disc.shortening > (pins - 2) / (2 * pins - 1):
        formula = "R_m*sqrt(27*(1-K_m^2)*z)/(z_p+1)^1.5"
    sheet.work("min_path_radius", "rho_min", formula, note="sharpest")
    sheet.work("undercut_margin", "S_u", "rho_min/r_m")
    sheet.work("tip_radius", "r_a", "R_m+e-r_m")
    sheet.work("root_radius", "r_f", "R_m-e-r_m")
    sheet.work("min_concave_radius", "rho_v", "R_m*(1-K_m)^2/(z_p*K_m-1)+r_m")
    return sheet.steps


def ideal_ring_steps(*, disc: CycloidDisc, output_torque: float, satellites: int) -> list[Step]:
    """Steps of the forces of perfect discs on many pins, and of their play. The torque is that of
    all discs, N*m.
    """
    change, each = disc.modification, output_torque / satellites
    sheet = _sheet(disc, ideal_mesh(disc=disc, disc_torque=each))
    sheet.take("T", "output_torque", output_torque)
    sheet.take("K", "satellites", satellites)
    sheet.work("satellite_torque", "T_j", "T/K", each)
    sheet.work("peak_force", "F_max", "4*T_j/(e*z*z_p)", note="many_ring_pins")
    sheet.work("mean_sum_force", "F_sum", "4*T_j/(pi*e*z)")
    root = math.sqrt(1 - disc.shortening_coefficient**2)
    formula = "2*(Delta_e-Delta_p*sqrt(1-K_1^2))/(e*z)+2*delta_r"
    if change.equidistant > 0 and change.pin_circle > root * change.equidistant:
        formula = "2*K_1*sqrt(Delta_e^2-Delta_p^2)/(e*z)+2*delta_r"
    sheet.work("backlash", "j", formula, note="many_ring_pins")
    return sheet.steps


def pressure_steps(
    *, mesh: CycloidMesh, crank_angle: float, force: ArrayLike, pressure: float
) -> list[Step]:
    """Steps of the largest pressure of a mesh at a crank angle. `force` are the forces of all pairs
    there, N, K x z_p; `pressure` is in Pa.
    """
    disc = mesh.disc
    sheet = _sheet(disc)
    _tool(sheet, disc)
    k, phases = disc.shortening, np.array(mesh.phases)[:, None]
    angle = crank_angle + phases + 2 * math.pi * np.arange(disc.pins) / disc.pins
    slope = np.sqrt(1 + k**2 - 2 * k * np.cos(angle))
    bend = 1 + disc.pins * k**2 - (disc.pins + 1) * k * np.cos(angle)
    path = disc.tool_circle_radius * slope**3 / bend
    size = np.broadcast_to(mesh.pin_radii, angle.shape)
    reduced = 1 / (1 / size + 1 / (path - disc.tool_radius))
    carried = np.array(force)
    at = np.unravel_index(int((carried / reduced).argmax()), carried.shape)
    satellite, pin = (int(each) for each in at)
    sheet.take("phi", "crank_angle", crank_angle)
    sheet.take("alpha_j", "crank_angle", float(phases[satellite, 0]))
    sheet.take("k", "pin", pin + 1)
    said = {"note": "hardest_pin", "params": {"satellite": satellite + 1, "pin": pin + 1}}
    sheet.work("pin_angle", "a", "phi+alpha_j+2*pi*(k-1)/z_p", angle[at], **said)
    sheet.work("path_slope", "S", "sqrt(1+K_m^2-2*K_m*cos(a))", slope[at])
    formula = "R_m*S^3/(1+z_p*K_m^2-(z_p+1)*K_m*cos(a))"
    sheet.work("path_radius", "rho_W", formula, path[at])
    sheet.take("r_p", "ring_pin_radius", size[at])
    sheet.work("reduced_radius", "rho", "1/(1/r_p+1/(rho_W-r_m))", reduced[at])
    materials = mesh.pin_material, mesh.disc_material
    take_materials(sheet, *materials)
    modulus = effective_modulus(first=materials[0], second=materials[1])
    sheet.work("effective_modulus", "E_m", MODULUS, modulus)
    sheet.read(mesh, b="contact_length")
    sheet.state("ring_pin_force", "F", "solved", value=carried[at])
    sheet.work("max_pressure", "p_0", "sqrt(F*E_m/(pi*b*rho))", pressure, source="johnson")
    return sheet.steps


def ring_loss_steps(
    *, loss: RingLoss, coefficient: float, torque: float, teeth: int, input_speed: float | None
) -> list[Step]:
    """Steps of the friction of a mesh. The torque on the output is in N*m, `teeth` are the lobes of
    a disc, the speed of the crank is in rad/s.
    """
    sheet = Sheet(loss)
    sheet.take("mu", "friction_coefficient", coefficient)
    sheet.take("T", "output_torque", torque)
    sheet.take("z", "satellite_teeth", teeth)
    sheet.take("n_1", "input_speed", input_speed)
    sheet.state("loss_per_friction", "q", "over_turn")
    sheet.work("loss_ratio", "L", "mu*q")
    sheet.work("efficiency", "eta", "1/(1+mu*q)")
    sheet.work("mean_loss", "P", "L*T*n_1/z", note="turns_in_radians")
    return sheet.steps


def involute_steps(pair: InvolutePair) -> list[Step]:
    """Steps of how involute teeth of satellite and ring mesh."""
    sheet, teeth, line = Sheet(pair), pair.teeth, pair.line
    sheet.read(teeth, z_s="satellite_teeth", z_r="ring_teeth", m="module")
    sheet.read(teeth, x_s="satellite_profile_shift", x_r="ring_profile_shift")
    sheet.read(teeth, h_s="satellite_addendum", h_r="ring_addendum")
    sheet.read(line, e="eccentricity")
    sheet.take("alpha", "reference_pressure_angle", line.pressure_angle)
    angle = "acos(m*(z_r-z_s)*cos(alpha)/(2*e))"
    sheet.work("operating_pressure_angle", "alpha_w", angle, line.angle)
    sheet.state("eccentricity_without_backlash", "e_0", "root", "m z_s z_r x_s x_r alpha")
    base = line.satellite_base
    sheet.work("base_radius", "r_b", "m*z_s*cos(alpha)/2", base)
    if abs(pair.normal_backlash) > FELT * base:
        sheet.work(
            "normal_backlash",
            "j_n",
            "m*cos(alpha)*(2*(x_r-x_s)*tan(alpha)"
            "+(z_r-z_s)*((tan(alpha)-alpha)-(tan(alpha_w)-alpha_w)))",
        )
        sheet.work("backlash", "j", "j_n/r_b")
    else:
        sheet.state("normal_backlash", "j_n", "felt")
    sheet.work("satellite_tip_radius", "r_s", "m*(z_s/2+x_s+h_s)", teeth.satellite_tip)
    sheet.work("ring_tip_radius", "r_r", "m*(z_r/2+x_r-h_r)", teeth.ring_tip)
    start = "(z_r*sqrt((2*r_r/(m*z_r*cos(alpha)))^2-1)-(z_r-z_s)*tan(alpha_w))/z_s"
    sheet.work("start_roll_satellite", "tau_1", start, pair.start_roll_satellite)
    sheet.work("end_roll_satellite", "tau_2", "sqrt((r_s/r_b)^2-1)", pair.end_roll)
    sheet.work("contact_ratio", "epsilon", "z_s*(tau_2-tau_1)/(2*pi)")
    return sheet.steps


def ring_steps(results: Results) -> list[Step]:
    """Steps of the mesh of a design with its ring: sizes; of cycloid discs pressure and friction
    under the torque.
    """
    if results.design.gear.kind == "involute":
        return involute_steps(results.ring.pair)
    turn, design = results.ring.working[0], results.design
    steps, place = disc_steps(turn.mesh.disc), turn.hardest_place[1]
    pressed = pressure_steps(
        mesh=turn.mesh,
        crank_angle=place,
        force=turn.forces_at(place),
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
