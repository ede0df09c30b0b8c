"""Worked steps of rolling bearings as rollers on the pins."""

from core.crank.bearing_life import EXPONENTS
from core.crank.pin_rollers import KINDS, UNKNOWN_ELEMENTS
from core.design.results import Results
from core.worked.members import take_speed
from core.worked.pins import static_step
from core.worked.step import Sheet, Step

LEFT = {
    "ball": "min(1,(13*Z/6)^0.3/(0.3894*Z))",
    "roller": "min(1,(2.75*Z)^(2/9)/(0.3637*Z))",
}
"""Share of the dynamic rating that is left, by the rolling elements."""


def roller_steps(results: Results) -> list[Step]:
    """Steps of the roller that is loaded most."""
    design, found = results.design, results.roller_loads
    own, elements, sheet = design.rollers, KINDS[design.rollers.kind], Sheet(found)
    wave = sheet.take_ratio(design.mechanism.ratio)
    take_speed(sheet, results=results)
    sheet.read(design.contact, e="eccentricity")
    sheet.read(design.pair, r_s="pin_radius")
    sheet.read(own, C="dynamic_rating", C_0="static_rating", Z="rolling_elements")
    sheet.take("p", "exponent", EXPONENTS[elements])
    sheet.work("speed", "n_s", f"n_1{wave}*e/r_s")
    sheet.state("peak_load", "F", "shared")
    where = {"params": {"satellite": found.satellite}}
    sheet.state("equivalent_load", "P", "equivalent_load", "F p", **where)
    left = (LEFT[elements], "min(1,5/Z)")
    if own.rolling_elements is None:
        left = ("s", "s_0")
        for symbol, part in zip(left, UNKNOWN_ELEMENTS[elements], strict=True):
            sheet.take(symbol, "rating_share", part)
    for code, symbol, rating, share in (
        ("dynamic_rating_as_roller", "C_w", "C", left[0]),
        ("static_rating_as_roller", "C_0w", "C_0", left[1]),
    ):
        if own.ratings == "roller":
            sheet.state(code, symbol, "given")
        else:
            sheet.work(code, symbol, f"{rating}*{share}")
    said = {"source": "iso281", "note": "turns_in_radians"}
    sheet.work("life", "L", "2*pi*10^6*(C_w/P)^p/n_s", **said)
    static_step(
        sheet,
        results=results,
        code="static_safety_factor",
        symbol="S_0",
        over=("C_0w", "F"),
        share=design.static_torque / design.pin_torque,
        source="iso76",
    )
    return sheet.steps
