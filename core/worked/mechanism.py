"""Worked steps of the mechanism: cyclogram, contact force, clearance."""

import math

import numpy as np

from core.arrays import FloatArray
from core.output.contact_force import ContactForce, Cyclogram
from core.output.mechanism import Mechanism, Members, assembly_angles, pressure_cosines
from core.precision import CONVERGED, SAME
from core.worked.members import take_torque
from core.worked.step import MOST_TERMS, Sheet, Step, total
from core.worked.turn import IdealTurn, Position, is_at

EQUATION_6 = {"source": "yanchevskiy2021", "equation": "6"}
EQUATION_11 = {"source": "yanchevskiy2021", "equation": "11"}

MOST_SATELLITES = 6
"""Satellites whose assembly angle is worked."""

MOST_PAIRS = 500
"""Pairs up to which the position of least support is looked for."""

HALF, TURN = math.pi, 2 * math.pi


def _ratio(sheet: Sheet, mechanism: Mechanism, teeth: tuple[int, int] | None) -> str:
    """The ratio from the teeth of satellite and ring, where it follows from these; the factor of
    the wave.
    """
    wave = sheet.take_ratio(mechanism.ratio)
    if teeth is not None:
        sheet.take("z_2", "satellite_teeth", teeth[0])
        sheet.take("z_3", "ring_teeth", teeth[1])
        formula = "z_2/(z_3-z_2)"
        sheet.work("ratio", "u", mechanism.ratio, formula, source="yanchevsky2018")
    return wave


def cyclogram_steps(
    *,
    mechanism: Mechanism,
    found: Cyclogram,
    teeth: tuple[int, int] | None = None,
    satellite_teeth: int | None = None,
) -> list[Step]:
    """Steps of the cyclogram.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism.
    found : Cyclogram
        Its cyclogram.
    teeth : tuple of int, optional
        Teeth of satellite and ring, where the ratio is given by them.
    satellite_teeth : int, optional
        Teeth of a satellite, for the angles of assembly.
    """
    sheet = Sheet()
    slower = _ratio(sheet, mechanism, teeth).replace("*", "/")
    sheet.take("h", "half_turn", HALF)
    sheet.take("t", "full_turn", TURN)
    formula = f"h{slower}"
    sheet.work_wave(
        "working_phase", "phi_w", found.working_phase, formula, **EQUATION_6, note="working"
    )
    sheet.work_wave("period", "phi_T", found.period, f"t{slower}", **EQUATION_6)
    sheet.take("N", "pins", mechanism.pins)
    sheet.take("K", "satellites", mechanism.satellites)
    sheet.take("m", "repeats", mechanism.phases.symmetry)
    sheet.work("pattern_period", "phi_P", found.pattern_period, "phi_T/(N*m)", note="repeats")
    phases = sorted(
        sector / mechanism.pins + phase
        for sector in range(mechanism.pins)
        for phase in mechanism.phases.sector_phases
    )
    gaps = np.diff([*phases, phases[0] + 1])
    counted = {"params": {"gap_angle": TURN * float(gaps.max())}, **EQUATION_6}
    sheet.state("min_driving", "n_min", found.min_driving, "counted", **counted)
    sheet.state("max_driving", "n_max", found.max_driving, "counted", **counted)
    sheet.work("mean_driving", "n_m", found.mean_driving, "K*N/2", note="half")
    if satellite_teeth is not None:
        _assembly(sheet, mechanism, satellite_teeth)
    return sheet.steps


def _assembly(sheet: Sheet, mechanism: Mechanism, satellite_teeth: int) -> None:
    angles = assembly_angles(mechanism=mechanism, satellite_teeth=satellite_teeth)
    first = mechanism.crank_angles[0]
    sheet.take("alpha_1", "crank_angle", first)
    sheet.take("z_2", "satellite_teeth", satellite_teeth)
    for each in angles[1:MOST_SATELLITES]:
        j = each.satellite
        angle = mechanism.crank_angles[j - 1]
        turned = (angle - first) / mechanism.ratio
        sheet.take(f"alpha_{j}", "crank_angle", angle)
        sheet.take("k", "pitches", round(turned / (TURN / satellite_teeth)))
        sheet.work(
            "hole_rotation",
            f"psi_{j}",
            each.hole_rotation,
            f"abs((alpha_{j}-alpha_1)/u-k*t/z_2)",
            source="yanchevskiy2021",
            equation="after 11",
            erratum="assembly",
        )


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
    """Steps of the contact force.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism whose pairs drive where those that carry do.
    found : ContactForce
        Its force.
    members : Members
        Which member is the output.
    output_torque, pin_circle_radius, force_exponent : float
        T, N*m, R, m, and v.
    driven_by : tuple of float, optional
        Torque of the crank, N*m, and efficiency, where the torque is given by these.
    judged : bool, optional
        Whether these forces are those that are judged, not others that are solved.
    """
    sheet = Sheet()
    wave = sheet.take_ratio(mechanism.ratio)
    if driven_by is None:
        take_torque(sheet, members=members, output_torque=output_torque)
    else:  # on the pins alike, whichever is the output
        sheet.take("T_in", "input_torque", driven_by[0])
        sheet.take("eta", "efficiency", driven_by[1])
        pins, by = output_torque * members.pin_share, "*u" if wave else ""
        code = "output_torque" if members.pin_share == 1 else "pin_torque"
        sheet.work(code, "T", pins, f"T_in{by}*eta", source="yanchevskiy2021")
    sheet.take("R", "pin_circle_radius", pin_circle_radius)
    note = "" if judged else "ideal_beside_solved"
    sheet.work("reference_force", "F_0", found.reference_force, "T/R", **EQUATION_11, note=note)
    sheet.state("peak_crank_angle", "phi", found.peak_crank_angle, "search")
    _peak(sheet, mechanism, found, force_exponent, wave)
    sheet.work("peak_force_ratio", "f", found.peak_force_ratio, "F/F_0",
               **EQUATION_11, erratum="below1")  # fmt: skip
    if found.equal_sharing_peak is not None:
        _equal_sharing(sheet, mechanism, found.equal_sharing_peak)
    sheet.take("N", "pins", mechanism.pins)
    sheet.take("K", "satellites", mechanism.satellites)
    sheet.work(
        "approximate_peak",
        "F_a",
        found.approximate_peak,
        "(0.8+0.05*N)^(2-K)*4*F_0/(K*N)",
        source="yanchevsky2018",
        equation="5",
        erratum="approximation",
    )
    sheet.work("approximate_peak_error", "epsilon_a", found.approximate_peak_error, "F_a/F-1")
    return sheet.steps


def _peak(
    sheet: Sheet, mechanism: Mechanism, found: ContactForce, exponent: float, faster: str
) -> None:
    """The pressure angle of the pair of the peak, and its force."""
    satellite, pin = found.peak_pair
    start = mechanism.initial_crank_angle
    crank = mechanism.crank_angles[satellite - 1]
    wave = float(mechanism.wave_angle(found.peak_crank_angle))
    angle = wave + crank + TURN * (pin - 1) / mechanism.pins + HALF / 2
    sheet.take("phi_0", "initial_crank_angle", start)
    sheet.take(f"alpha_{satellite}", "crank_angle", crank)
    sheet.take("n", "pin", pin)
    sheet.take("N", "pins", mechanism.pins)
    sheet.take("t", "full_turn", TURN)
    sheet.take("r", "right_angle", HALF / 2)
    sheet.take("k", "turns", round(angle / TURN))
    sheet.work(
        "pressure_angle",
        "gamma_p",
        math.remainder(angle, TURN),
        f"phi{faster}+phi_0+alpha_{satellite}+t*(n-1)/N+r-k*t",
        **EQUATION_6,
        note="pressure_angle",
        params={"satellite": satellite, "pin": pin},
    )
    cosines = pressure_cosines(
        mechanism=mechanism, crank_angles=np.array([found.peak_crank_angle])
    )[0]
    said = {
        0.0: {"source": "zyl", "equation": "1"},
        1.0: {"source": "yanchevsky2018", "equation": "4", "erratum": "arcsin"},
    }.get(exponent, {"source": "yanchevskiy2021", "equation": "10"})
    pairs = np.argwhere(cosines > SAME)
    params = {"params": {"count": len(pairs)}}
    if len(pairs) > MOST_TERMS:
        sheet.state("peak_force", "F", found.peak_force, "many", **said, **params)
        return
    marks = []
    for j, n in pairs.tolist():
        marks.append(f"{j + 1}_{n + 1}")
        own = wave + mechanism.crank_angles[j] + TURN * n / mechanism.pins + HALF / 2
        sheet.take(f"gamma_{marks[-1]}", "pressure_angle", math.remainder(own, TURN))
    sheet.take("v", "force_exponent", exponent)
    top, term = {0.0: ("", ""), 1.0: ("*cos(gamma_p)", "^2")}.get(
        exponent, ("*cos(gamma_p)^v", "^(1+v)")
    )
    formula = f"F_0{top}/{total(f'cos(gamma_#){term}', marks=marks)}"
    sheet.work("peak_force", "F", found.peak_force, formula, **said, note="driving", **params)


def _equal_sharing(sheet: Sheet, mechanism: Mechanism, peak: float) -> None:
    """Zyl's force, at the position where the pairs support least."""
    said = {"source": "zyl", "equation": "1", "erratum": "zyl"}
    if mechanism.pins * mechanism.satellites > MOST_PAIRS:
        sheet.state("equal_sharing_peak", "F_e", peak, "least_support", **said)
        return
    turn = IdealTurn(mechanism, 0.0)

    def most(position: Position) -> FloatArray:
        found: FloatArray = reference * position.force.max(axis=1)
        return found

    reference = sheet.known["F_0"].value
    at = turn.worst(most)
    angles = [each for each in at.angle[0].tolist() if math.cos(each) > SAME]
    if not is_at(at, measure=most, value=peak):
        sheet.state("equal_sharing_peak", "F_e", peak, "least_support", **said)
        return
    marks = [str(i + 1) for i in range(len(angles))]
    for mark, angle in zip(marks, angles, strict=True):
        sheet.take(f"gamma_{mark}", "pressure_angle", angle)
    formula = f"F_0/{total('cos(gamma_#)', marks=marks)}"
    sheet.work("equal_sharing_peak", "F_e", peak, formula, **said, note="least_support")


def clearance_steps(
    *, clearance: float, hole_radius: float, pin_radius: float, eccentricity: float
) -> list[Step]:
    """Steps of the clearance of pin and hole.

    Parameters
    ----------
    clearance : float
        The clearance, m.
    hole_radius, pin_radius, eccentricity : float
        Sizes, m.
    """
    sheet = Sheet()
    sheet.take("r_out", "hole_radius", hole_radius)
    sheet.take("r_in", "pin_radius", pin_radius)
    sheet.take("e", "eccentricity", eccentricity)
    said = {"source": "yanchevskiy2021", "erratum": "intersection"}
    if clearance == 0 and abs(hole_radius - pin_radius - eccentricity) > CONVERGED * hole_radius:
        sheet.state("clearance", "c", clearance, "felt", **said)
    else:
        sheet.work("clearance", "c", clearance, "r_out-r_in-e", **said)
    return sheet.steps
