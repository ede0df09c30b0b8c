"""Worked steps of the mechanism: cyclogram, contact force, clearance."""

import math

import numpy as np

from core.output.contact_force import ContactForce, Cyclogram
from core.output.mechanism import Mechanism, Members, assembly_angles, pressure_cosines
from core.precision import CONVERGED, SAME
from core.worked.members import take_torque
from core.worked.step import Sheet, Step

EQUATION_6 = {"source": "yanchevskiy2021", "equation": "6"}
EQUATION_11 = {"source": "yanchevskiy2021", "equation": "11"}

LAWS = {
    0.0: {"source": "zyl", "equation": "1"},
    1.0: {"source": "yanchevsky2018", "equation": "4", "erratum": "arcsin"},
}
"""Source of the peak force by its exponent; of others eq. (10) of 2021."""

MOST_SATELLITES = 6
"""Satellites whose assembly angle is worked."""

TURN = 2 * math.pi


def cyclogram_steps(
    *,
    mechanism: Mechanism,
    found: Cyclogram,
    teeth: tuple[int, int] | None = None,
    satellite_teeth: int | None = None,
) -> list[Step]:
    """Steps of the cyclogram. `teeth` are those of satellite and ring, if the ratio is given by
    them; `satellite_teeth` are for the angles of assembly.
    """
    sheet = Sheet(found)
    slower = sheet.take_ratio(mechanism.ratio).replace("*", "/")
    if teeth is not None:
        sheet.take("z_2", "satellite_teeth", teeth[0])
        sheet.take("z_3", "ring_teeth", teeth[1])
        formula = "z_2/(z_3-z_2)"
        sheet.work("ratio", "u", formula, mechanism.ratio, source="yanchevsky2018")
    sheet.take("h", "half_turn", TURN / 2)
    sheet.take("t", "full_turn", TURN)
    sheet.work("working_phase", "phi_w", f"h{slower}", **EQUATION_6, note="working")
    sheet.work("period", "phi_T", f"t{slower}", **EQUATION_6)
    sheet.read(mechanism, N="pins", K="satellites")
    sheet.take("m", "repeats", mechanism.phases.symmetry)
    sheet.work("pattern_period", "phi_P", "phi_T/(N*m)", note="repeats")
    sheet.state("min_driving", "n_min", "counted", "N K", **EQUATION_6)
    sheet.state("max_driving", "n_max", "counted", "N K", **EQUATION_6)
    sheet.work("mean_driving", "n_m", "K*N/2", note="half")
    if satellite_teeth is not None:
        _assembly(sheet, mechanism, satellite_teeth)
    return sheet.steps


def _assembly(sheet: Sheet, mechanism: Mechanism, satellite_teeth: int) -> None:
    """Add the angles by which holes of other satellites are turned against those of the first."""
    angles = assembly_angles(mechanism=mechanism, satellite_teeth=satellite_teeth)
    first = mechanism.crank_angles[0]
    sheet.take("alpha_1", "crank_angle", first)
    sheet.take("z_2", "satellite_teeth", satellite_teeth)
    said = {"source": "yanchevskiy2021", "equation": "after 11", "erratum": "assembly"}
    for each in angles[1:MOST_SATELLITES]:
        j = each.satellite
        angle = mechanism.crank_angles[j - 1]
        turned = (angle - first) / mechanism.ratio
        sheet.take(f"alpha_{j}", "crank_angle", angle)
        sheet.take("k", "pitches", round(turned / (TURN / satellite_teeth)))
        formula = f"abs((alpha_{j}-alpha_1)/u-k*t/z_2)"
        sheet.work("hole_rotation", f"psi_{j}", formula, each.hole_rotation, **said)


def force_steps(
    *,
    mechanism: Mechanism,
    found: ContactForce,
    members: Members,
    output_torque: float,
    pin_circle_radius: float,
    force_exponent: float,
    driven_by: tuple[float, float] | None = None,
    judged: bool = True,
) -> list[Step]:
    """Steps of the contact force. The mechanism has the pairs that drive, or those that carry, if
    they do not all. `driven_by` are the torque of the crank, N*m, and the efficiency, if the torque
    is given by these; `judged` is False if other forces are solved and judged.
    """
    sheet = Sheet(found)
    wave = sheet.take_ratio(mechanism.ratio)
    if driven_by is None:
        take_torque(sheet, members=members, output_torque=output_torque)
    else:  # on the pins alike, whichever is the output
        sheet.take("T_in", "input_torque", driven_by[0])
        sheet.take("eta", "efficiency", driven_by[1])
        formula = "T_in*u*eta" if wave else "T_in*eta"
        code = "output_torque" if members.pin_share == 1 else "pin_torque"
        pins = output_torque * members.pin_share
        sheet.work(code, "T", formula, pins, source="yanchevskiy2021")
    sheet.take("R", "pin_circle_radius", pin_circle_radius)
    note = "" if judged else "ideal_beside_solved"
    sheet.work("reference_force", "F_0", "T/R", **EQUATION_11, note=note)
    sheet.state("peak_crank_angle", "phi", "search")
    _peak(sheet, mechanism, found, force_exponent, wave)
    sheet.work("peak_force_ratio", "f", "F/F_0", **EQUATION_11, erratum="below1")
    said = {"source": "zyl", "equation": "1", "erratum": "zyl"}
    sheet.state("equal_sharing_peak", "F_e", "least_support", "F_0", **said)
    said = {"source": "yanchevsky2018", "equation": "5", "erratum": "approximation"}
    sheet.read(mechanism, K="satellites")
    sheet.work("approximate_peak", "F_a", "(0.8+0.05*N)^(2-K)*4*F_0/(K*N)", **said)
    sheet.work("approximate_peak_error", "epsilon_a", "F_a/F-1")
    return sheet.steps


def _peak(
    sheet: Sheet, mechanism: Mechanism, found: ContactForce, exponent: float, faster: str
) -> None:
    """Add the pressure angle of the pair of the peak, and its force."""
    satellite, pin = found.peak_pair
    crank, place = mechanism.crank_angles[satellite - 1], found.peak_crank_angle
    wave = float(mechanism.wave_angle(place))
    angle = wave + crank + TURN * (pin - 1) / mechanism.pins + TURN / 4
    sheet.read(mechanism, N="pins", phi_0="initial_crank_angle")
    sheet.take(f"alpha_{satellite}", "crank_angle", crank)
    sheet.take("n", "pin", pin)
    sheet.take("k", "turns", round(angle / TURN))
    formula = f"phi{faster}+phi_0+alpha_{satellite}+2*pi*(n-1)/N+pi/2-2*pi*k"
    own = {"note": "pressure_angle", "params": {"satellite": satellite, "pin": pin}}
    value = math.remainder(angle, TURN)
    sheet.work("pressure_angle", "gamma_p", formula, value, **EQUATION_6, **own)
    cosines = pressure_cosines(mechanism=mechanism, crank_angles=np.array([place]))
    driving = cosines[cosines > SAME]
    sheet.take("v", "force_exponent", exponent)
    params = {"count": len(driving)}
    total = float((driving ** (1 + exponent)).sum())
    sheet.state("support", "S", "driving", "v", total, params=params)
    said = LAWS.get(exponent, {"source": "yanchevskiy2021", "equation": "10"})
    sheet.work("peak_force", "F", "F_0*cos(gamma_p)^v/S", **said)


def clearance_steps(
    *, clearance: float, hole_radius: float, pin_radius: float, eccentricity: float
) -> list[Step]:
    """Steps of the clearance of pin and hole; all sizes in m."""
    sheet = Sheet()
    sheet.take("r_out", "hole_radius", hole_radius)
    sheet.take("r_in", "pin_radius", pin_radius)
    sheet.take("e", "eccentricity", eccentricity)
    said = {"source": "yanchevskiy2021", "erratum": "intersection"}
    if clearance == 0 and abs(hole_radius - pin_radius - eccentricity) > CONVERGED * hole_radius:
        sheet.state("clearance", "c", "felt", "r_out r_in e", clearance, **said)
    else:
        sheet.work("clearance", "c", "r_out-r_in-e", clearance, **said)
    return sheet.steps
