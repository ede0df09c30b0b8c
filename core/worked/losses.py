"""Worked steps of friction and wear of the pins."""

from core.design.results import Results
from core.errors import if_known
from core.output.losses import BarePins
from core.worked.members import output_power_of, take_speed, take_torque
from core.worked.step import Sheet, Step


def loss_steps(results: Results) -> list[Step]:
    """Steps of friction and wear.

    Parameters
    ----------
    results : Results
        Results of a design with friction, or with rollers.
    """
    sheet, found, design = Sheet(), results.losses.pins, results.design
    load, contact, friction = design.load, design.contact, design.output_friction
    radius, slow = ("r_in", "") if isinstance(found.rubbing, BarePins) else ("r_s", "*r_p/r_s")
    wave = sheet.take_ratio(design.mechanism.ratio)
    take_speed(sheet, results=results)
    sheet.take("e", "eccentricity", contact.eccentricity)
    sheet.take("R", "pin_circle_radius", load.pin_circle_radius)
    take_torque(sheet, members=design.members, output_torque=load.output_torque)
    sheet.take("b", "contact_length", contact.contact_length)
    sheet.take(radius, "pin_radius", contact.pin_radius)
    if design.rollers:
        sheet.take("r_p", "bolt_radius", design.rollers.bore_diameter / 2)
    elif design.pin:
        sheet.take("r_p", "bolt_radius", design.pin.diameter / 2)
    sheet.take("r_out", "hole_radius", contact.hole_radius)
    sheet.take("mu", "coefficient", friction.coefficient)
    sheet.take("N", "pins", design.mechanism.pins)
    sheet.take("K", "satellites", design.mechanism.satellites)
    sheet.take("k", "wear_rate", friction.wear_rate)
    sheet.take("t", "life", design.life_of(friction))
    turns = {"note": "turns_in_radians"}
    sheet.work_wave("relative_speed", "n", found.relative_speed, f"n_1{wave}")
    sheet.work("sliding_speed", "v", found.sliding_speed, f"e*n{slow}", **turns)
    sheet.work("sleeve_speed", "n_s", found.sleeve_speed, f"n*e/{radius}")
    sheet.state("peak_force", "F", found.peak_force, "search")
    sheet.state("mean_total_force_ratio", "f", found.mean_total_force_ratio, "mean_of_turn")
    power = output_power_of(results)
    if power:
        sheet.work("output_power", "P_2", found.output_power, power, **turns)
    else:
        sheet.state("output_power", "P_2", found.output_power, "powers_out")
    sheet.work("mean_loss", "P", found.mean_loss, "mu*v*f*T/R")
    sheet.work("efficiency", "eta", found.efficiency, "P_2/(P_2+P)")
    sheet.state("min_efficiency", "eta_min", found.min_efficiency, "over_turn")
    sheet.state("max_efficiency", "eta_max", found.max_efficiency, "over_turn")
    sheet.work("peak_pv", "p_v", found.peak_pv, f"F/(2*{radius}*b)*e*n")
    sheet.work("mean_pv", "p_m", found.mean_pv, f"f*T/(R*N*K)/(2*{radius}*b)*e*n")
    worn = {"source": "archard", **turns}
    for code, symbol, depth, swept in (
        ("pin_wear", "h_in", lambda: found.pin_wear, radius),
        ("hole_wear", "h_out", lambda: found.hole_wear, "r_out"),
    ):
        sheet.work(code, symbol, if_known(depth), f"k*F/(b*{swept})*e*n*t/(2*pi)", **worn)
    couple = f"mu*f*{radius}/R{slow}"
    sheet.work("friction_couple", "c", found.friction_couple, couple, note="couple")
    return sheet.steps
