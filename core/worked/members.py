"""Worked steps of crank, pins and ring: ratio, torques, speeds, powers; and how the calculations of
the pins come to their torque and speed.
"""

from contextlib import suppress

from core.design.results import Results
from core.errors import UNKNOWN
from core.output.mechanism import MemberLoads, Members
from core.worked.step import Sheet, Step

TURNING = {
    "ring": "n_in*u/(u+1)",
    "ring_speed": "abs(n_in-n_r)",
    "carrier_speed": "abs(n_in-n_c)*u/(u+1)",
}
"""Speed of the crank against the ring: of the ring as output, or of both by the one that is given.
"""


def take_torque(sheet: Sheet, *, members: Members, output_torque: float) -> None:
    """Let the torque T on the pins be known, by that of the output.

    Parameters
    ----------
    sheet : Sheet
        Where.
    members : Members
        Which is the output.
    output_torque : float
        Its torque, N*m.
    """
    if members.pin_share == 1:
        sheet.take("T", "output_torque", output_torque)
        return
    sheet.take("T_r", "output_torque", output_torque)
    sheet.take("u", "ratio", members.ratio)
    sheet.work("pin_torque", "T", output_torque * members.pin_share, "T_r*u/(u+1)")


def take_speed(sheet: Sheet, *, results: Results) -> None:
    """Let the speed n_1 of the crank against the ring be known, where there is one.

    Parameters
    ----------
    sheet : Sheet
        Where.
    results : Results
        Of a design.
    """
    design = results.design
    speeds, load, output = design.speeds, design.load, design.members.output
    if not speeds:
        return
    if output in ("pins", "coupling"):
        sheet.take("n_1", "input_speed", load.input_speed)
        return
    sheet.take("n_in", "input_speed", load.input_speed)
    sheet.take("n_r", "ring_speed", load.ring_speed)
    sheet.take("n_c", "carrier_speed", load.carrier_speed)
    sheet.take("u", "ratio", design.members.ratio)
    given = "ring_speed" if load.by_ring else "carrier_speed"
    formula = TURNING["ring" if output == "ring" else given]
    sheet.work("turning_speed", "n_1", speeds.turning, formula)


def output_power_of(results: Results) -> str:
    """Formula of the power of the output, by what is known of torque and speeds.

    Parameters
    ----------
    results : Results
        Of a design.

    Returns
    -------
    str
        Empty where both are the output: what leaves by either is added.
    """
    formulas = {"pins": "T*n_1/u", "ring": "T_r*n_in/(u+1)", "coupling": "T*n_1"}
    return formulas.get(results.design.members.output, "")


def member_steps(results: Results) -> list[Step]:
    """Steps of ratio, torques, speeds and powers of crank, pins and ring.

    Parameters
    ----------
    results : Results
        Results of a design with a load.
    """
    sheet, found, design = Sheet(), results.member_loads, results.design
    members, load = design.members, design.load
    if members.output == "coupling":
        return []
    sheet.take_ratio(members.ratio)
    take_torque(sheet, members=members, output_torque=load.output_torque)
    sheet.work("crank_torque", "T_1", found.crank_torque, "T/u")
    sheet.work("ring_torque", "T_3", found.ring_torque, "-(T+T_1)")
    ratio = {"pins": "-T/T_1", "ring": "-T_3/T_1"}.get(members.output, "")
    sheet.work("output_ratio", "i", found.output_ratio, ratio)
    with suppress(*UNKNOWN):
        _turning(sheet, found, by_ring=members.output == "pins" or load.by_ring)
    return sheet.steps


def _turning(sheet: Sheet, found: MemberLoads, *, by_ring: bool) -> None:
    """Speeds and powers, by the speed of the ring or by that of the pins."""
    speeds = found.speeds
    sheet.take("n_in", "input_speed", speeds.crank)
    sheet.take("n_r", "ring_speed", speeds.ring)
    sheet.take("n_c", "carrier_speed", speeds.carrier)
    if by_ring:
        sheet.work("carrier_speed", "n_c", speeds.carrier, "((u+1)*n_r-n_in)/u", note="willis")
    else:
        sheet.work("ring_speed", "n_r", speeds.ring, "(n_in+u*n_c)/(u+1)", note="willis")
    sheet.work("relative_speed", "n", speeds.relative, "n_in-n_c")
    sheet.work("crank_to_ring_speed", "n_1", speeds.crank_to_ring, "n_in-n_r")
    turns = {"note": "turns_in_radians"}
    for code, symbol, power, formula in (
        ("crank_power", "P_1", found.crank_power, "T_1*n_in"),
        ("carrier_power", "P_c", found.carrier_power, "T*n_c"),
        ("ring_power", "P_r", found.ring_power, "T_3*n_r"),
    ):
        sheet.work(code, symbol, power, formula, **turns)
