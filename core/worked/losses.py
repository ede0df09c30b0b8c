"""Worked steps of friction and wear of the pins."""

from core.design.results import Results
from core.output.losses import BarePins
from core.worked.members import OUTPUT_POWER, take_speed, take_torque
from core.worked.step import Sheet, Step


def loss_steps(results: Results) -> list[Step]:
    """Steps of friction and wear."""
    found, design = results.losses.pins, results.design
    contact, friction = design.contact, design.output_friction
    radius, slow = ("r_in", "") if isinstance(found.rubbing, BarePins) else ("r_s", "*r_p/r_s")
    sheet = Sheet(found)
    wave = sheet.take_ratio(design.mechanism.ratio)
    take_speed(sheet, results=results)
    take_torque(sheet, members=design.members, output_torque=design.output_torque)
    sheet.read(design, R="pin_circle_radius")
    sheet.read(contact, e="eccentricity", b="contact_length", r_out="hole_radius")
    sheet.read(contact, **{radius: "pin_radius"})
    if design.rollers:
        sheet.take("r_p", "bolt_radius", design.rollers.bore_diameter / 2)
    elif design.pin:
        sheet.take("r_p", "bolt_radius", design.pin.diameter / 2)
    sheet.read(friction, mu="coefficient", k="wear_rate")
    sheet.read(design.mechanism, N="pins", K="satellites")
    sheet.take("t", "life", design.life_of(friction))
    turns = {"note": "turns_in_radians"}
    sheet.work("relative_speed", "n", f"n_1{wave}")
    sheet.work("sliding_speed", "v", f"e*n{slow}", **turns)
    sheet.work("sleeve_speed", "n_s", f"n*e/{radius}")
    sheet.state("peak_force", "F", "search", "T R")
    sheet.state("mean_total_force_ratio", "f", "mean_of_turn")
    if power := OUTPUT_POWER.get(design.members.output):
        sheet.work("output_power", "P_2", power, **turns)
    else:
        sheet.state("output_power", "P_2", "powers_out")
    sheet.work("mean_loss", "P", "mu*v*f*T/R")
    sheet.work("efficiency", "eta", "P_2/(P_2+P)")
    sheet.state("min_efficiency", "eta_min", "over_turn", "mu")
    sheet.state("max_efficiency", "eta_max", "over_turn", "mu")
    sheet.work("peak_pv", "p_v", f"F/(2*{radius}*b)*e*n")
    sheet.work("mean_pv", "p_m", f"f*T/(R*N*K)/(2*{radius}*b)*e*n")
    worn = {"source": "archard", **turns}
    sheet.work("pin_wear", "h_in", f"k*F/(b*{radius})*e*n*t/(2*pi)", **worn)
    sheet.work("hole_wear", "h_out", "k*F/(b*r_out)*e*n*t/(2*pi)", **worn)
    sheet.work("friction_couple", "c", f"mu*f*{radius}/R{slow}", note="couple")
    return sheet.steps
