"""Worked steps of rolling bearings as rollers on the pins."""

import math

from core.crank.bearing_life import EXPONENTS
from core.crank.pin_rollers import KINDS, UNKNOWN_ELEMENTS
from core.design.results import Results
from core.errors import if_known
from core.worked.members import take_speed
from core.worked.pins import static_step
from core.worked.step import Sheet, Step

LEFT = {
    "ball": "min(1,(13*Z/6)^0.3/(0.3894*Z))",
    "roller": "min(1,(2.75*Z)^(2/9)/(0.3637*Z))",
}
"""Share of the dynamic rating that is left, by the rolling elements."""


def roller_steps(results: Results) -> list[Step]:
    """Steps of the roller that is loaded most.

    Parameters
    ----------
    results : Results
        Results of a design with rollers.
    """
    sheet, design, found = Sheet(), results.design, results.roller_loads
    own, elements = design.rollers, KINDS[design.rollers.kind]
    wave = sheet.take_ratio(design.mechanism.ratio)
    take_speed(sheet, results=results)
    sheet.take("e", "eccentricity", design.contact.eccentricity)
    sheet.take("r_s", "pin_radius", design.pair.pin_radius)
    sheet.take("C", "dynamic_rating", own.dynamic_rating)
    sheet.take("C_0", "static_rating", own.static_rating)
    sheet.take("Z", "rolling_elements", own.rolling_elements)
    sheet.work("speed", "n_s", if_known(lambda: found.speed), f"n_1{wave}*e/r_s")
    sheet.state("peak_load", "F", found.peak_load, "shared")
    where = {"params": {"satellite": found.satellite}}
    sheet.state("equivalent_load", "P", found.equivalent_load, "equivalent_load", **where)
    left = (LEFT[elements], "min(1,5/Z)")
    if own.rolling_elements is None:
        left = ("s", "s_0")
        for symbol, share in zip(left, UNKNOWN_ELEMENTS[elements], strict=True):
            sheet.take(symbol, "rating_share", share)
    for code, symbol, rating, formula in (
        ("dynamic_rating_as_roller", "C_w", lambda: found.dynamic_rating_as_roller, f"C*{left[0]}"),
        (
            "static_rating_as_roller",
            "C_0w",
            lambda: found.static_rating_as_roller,
            f"C_0*{left[1]}",
        ),
    ):
        if own.ratings == "roller":
            sheet.state(code, symbol, if_known(rating), "given")
        else:
            sheet.work(code, symbol, if_known(rating), formula)
    power = "10/3" if math.isclose(EXPONENTS[elements], 10 / 3) else "3"
    formula = f"2*pi*10^6*(C_w/P)^({power})/n_s"
    said = {"source": "iso281", "note": "turns_in_radians"}
    sheet.work("life", "L", if_known(lambda: found.life), formula, **said)
    static_step(
        sheet,
        results=results,
        code="static_safety_factor",
        symbol="S_0",
        value=if_known(lambda: found.static_safety_factor),
        limit="C_0w",
        load="F",
        share=design.static_torque / design.pin_torque,
        source="iso76",
    )
    return sheet.steps
