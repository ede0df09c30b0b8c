"""Worked steps of rolling bearings as rollers on the pins."""

import math

from core.crank.bearing_life import EXPONENTS
from core.crank.pin_rollers import KINDS, UNKNOWN_ELEMENTS
from core.design.results import Results
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

    Returns
    -------
    list of Step
    """
    sheet, own, beside = Sheet(), results.design.rollers, results.rollers_on_pins
    design, found, elements = results.design, beside.loads, KINDS[own.kind]
    sheet.take("n_1", "input_speed", design.load.input_speed)
    sheet.take("u", "ratio", design.mechanism.ratio)
    sheet.take("e", "eccentricity", design.contact.eccentricity)
    sheet.take("r_s", "pin_radius", design.pair.pin_radius)
    sheet.take("C", "dynamic_rating", own.dynamic_rating)
    sheet.take("C_0", "static_rating", own.static_rating)
    sheet.take("Z", "rolling_elements", own.rolling_elements)
    sheet.take("G_r", "radial_clearance", own.radial_clearance)
    sheet.work("speed", "n_s", found.speed, "n_1*(1+1/u)*e/r_s")
    sheet.state("peak_load", "F", found.peak_load, "shared")
    where = {"params": {"satellite": found.satellite}}
    sheet.state("equivalent_load", "P", found.equivalent_load, "equivalent_load", **where)
    dynamic, still = "1", "1"
    if own.ratings == "bearing":
        dynamic, still = LEFT[elements], "min(1,5/Z)"
        if own.rolling_elements is None:
            dynamic, still = (f"{share:g}" for share in UNKNOWN_ELEMENTS[elements])
    for code, symbol, rating, formula in (
        ("dynamic_rating_as_roller", "C_w", found.dynamic_rating_as_roller, f"C*{dynamic}"),
        ("static_rating_as_roller", "C_0w", found.static_rating_as_roller, f"C_0*{still}"),
    ):
        sheet.work(code, symbol, rating, formula)
    power = "10/3" if math.isclose(EXPONENTS[elements], 10 / 3) else "3"
    formula = f"2*pi*10^6*(C_w/P)^({power})/n_s"
    sheet.work("life", "L", found.life, formula, source="iso281", note="turns_in_radians")
    static_step(
        sheet,
        results=results,
        code="static_safety_factor",
        symbol="S_0",
        value=found.static_safety_factor,
        limit="C_0w",
        load="F",
        share=design.static_torque / design.load.output_torque,
        source="iso76",
    )
    if own.radial_clearance is not None:
        sheet.work("added_clearance", "c_b", beside.added_clearance, "G_r/2")
    return sheet.steps
