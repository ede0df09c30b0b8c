"""Worked steps of crank, pins and ring: ratio, torques, speeds, powers; and how the calculations of
the pins come to their torque and speed.
"""

from contextlib import suppress

from core.design.results import Results
from core.errors import UNKNOWN
from core.output.mechanism import Members
from core.worked.step import Sheet, Step

TURNING = {
    "ring": "n_in*u/(u+1)",
    "ring_speed": "abs(n_in-n_r)",
    "carrier_speed": "abs(n_in-n_c)*u/(u+1)",
}
"""Speed of the crank against the ring: of the ring as output, or of both by the one that is given.
"""

OUTPUT_POWER = {"pins": "T*n_1/u", "ring": "T_r*n_in/(u+1)", "coupling": "T*n_1"}
"""Power of the output, if it is one member."""


def take_torque(sheet: Sheet, *, members: Members, output_torque: float) -> None:
    """Let the torque T on the pins be known, by that of the output."""
    if members.pin_share == 1:
        sheet.take("T", "output_torque", output_torque)
        return
    sheet.take("T_r", "output_torque", output_torque)
    sheet.take("u", "ratio", members.ratio)
    sheet.work("pin_torque", "T", "T_r*u/(u+1)", output_torque * members.pin_share)


def take_speed(sheet: Sheet, *, results: Results) -> None:
    """Let the speed n_1 of the crank against the ring be known, if there is one."""
    design, load = results.design, results.design.load
    speeds, output = design.speeds, design.members.output
    if not speeds:
        return
    if output in ("pins", "coupling"):
        sheet.take("n_1", "input_speed", load.input_speed)
        return
    sheet.read(load, n_in="input_speed", n_r="ring_speed", n_c="carrier_speed")
    sheet.take("u", "ratio", design.members.ratio)
    given = "ring_speed" if load.by_ring else "carrier_speed"
    formula = TURNING["ring" if output == "ring" else given]
    sheet.work("turning_speed", "n_1", formula, speeds.turning)


def member_steps(results: Results) -> list[Step]:
    """Steps of ratio, torques, speeds and powers of crank, pins and ring."""
    found, design = results.member_loads, results.design
    members = design.members
    if members.output == "coupling":
        return []
    sheet = Sheet(found)
    sheet.take_ratio(members.ratio)
    take_torque(sheet, members=members, output_torque=design.output_torque)
    sheet.work("crank_torque", "T_1", "T/u")
    sheet.work("ring_torque", "T_3", "-(T+T_1)")
    sheet.work("output_ratio", "i", "-T/T_1" if members.output == "pins" else "-T_3/T_1")
    with suppress(*UNKNOWN):
        speeds, turns = found.speeds, {"note": "turns_in_radians"}
        for symbol, quantity, value in (
            ("n_in", "input_speed", speeds.crank),
            ("n_r", "ring_speed", speeds.ring),
            ("n_c", "carrier_speed", speeds.carrier),
        ):
            sheet.take(symbol, quantity, value)
        if members.output == "pins" or design.load.by_ring:
            formula = "((u+1)*n_r-n_in)/u"
            sheet.work("carrier_speed", "n_c", formula, speeds.carrier, note="willis")
        else:
            sheet.work("ring_speed", "n_r", "(n_in+u*n_c)/(u+1)", speeds.ring, note="willis")
        sheet.work("relative_speed", "n", "n_in-n_c", speeds.relative)
        sheet.work("crank_to_ring_speed", "n_1", "n_in-n_r", speeds.crank_to_ring)
        sheet.work("crank_power", "P_1", "T_1*n_in", **turns)
        sheet.work("carrier_power", "P_c", "T*n_c", **turns)
        sheet.work("ring_power", "P_r", "T_3*n_r", **turns)
    return sheet.steps
