"""Worked steps of an answer: steps of the core with API names and units."""

import math

from app.model import Values
from app.units import core_name, field_of, from_si, shown_unit
from core.worked.step import Step

VALUES = {
    "ratio": "Ratio",
    "output_torque_Nm": "Output torque",
    "pin_torque_Nm": "Torque on the pins",
    "turning_speed_rpm": "Speed of the crank against the ring",
    "pressure_angle_deg": "Pressure angle of the pair of the peak",
    "support": "Sum over the pairs that drive there",
    "line_load_N_per_mm": "Line load",
    "load_parameter": "Load parameter",
    "loads": "Loads over the life",
    "life_factor": "Life factor",
    "life_cycles": "Cycles over the life",
    "strength_fraction": "Share of the tensile strength at 1000 cycles",
    "shear_modulus_GPa": "Shear modulus",
    "bending_compliance_mm_per_N": "Compliance in bending",
    "shear_compliance_mm_per_N": "Compliance in shear",
    "scale_mm": "Length A of the contact lines",
    "full_arm_load_N_per_mm": "Line load where the arm is R_C",
    "centrifugal_force_N": "Centrifugal force of a satellite",
    "neuber_root": "Root of Neuber's length, in √mm",
    "satellite_torque_Nm": "Torque of the satellite",
    "across_force_N": "Load of the crank across it",
    "along_force_N": "Load of the crank along it",
    "notch_strength_MPa": "Tensile strength within the range of the fit",
    "decades_left": "Part of the decades left to a million cycles",
    "mismatch_alpha": "Dundurs' α",
    "mismatch_beta": "Dundurs' β",
    "shortening": "Shortening of the cycloid",
    "reaction_part_N": "Part of the reaction",
    "tool_circle_radius_mm": "Radius of the tool's circle",
    "tool_radius_mm": "Radius of the tool",
    "tool_shortening": "Shortening coefficient of the tool's path",
    "pin_angle_deg": "Angle from the crank to the pin",
    "path_slope": "Slope of the path over its circle",
    "path_radius_mm": "Radius of curvature of the path",
    "ring_pin_force_N": "Force on the pin of the ring",
    "base_radius_mm": "Base radius of the satellite",
    "eccentricity_without_backlash_mm": "Eccentricity without backlash",
    "normal_backlash_mm": "Backlash along the normal",
    "contact_ratio": "Contact ratio",
    "start_roll_satellite": "Tangent of the satellite's pressure angle at the start of the path",
    "satellite_tip_radius_mm": "Tip radius of the satellite",
    "ring_tip_radius_mm": "Tip radius of the ring",
    "end_roll_satellite": "Tangent of the satellite's pressure angle at the end of the path",
}
"""Values on the way to a result, by the API's names of their steps."""

OTHERS = (
    "balance_force_N bearing_position_mm bearing_speed_rpm bolt_radius_mm "
    "counterweight_position_mm deflection_mm fatigue_life_h fatigue_safety_factor fit_exponent "
    "fit_scale full_turn_deg half_turn_deg half_turns life_h limit_MPa mean_MPa pins pitches "
    "polar_angle_deg rating_share repeats safety_hole safety_pin satellite_position_mm sides size "
    "static_rating_safety stiffness_N_per_mm stress_ratio torque_share turns"
)
"""API's names of other quantities, which no field has, or several with units of their own."""

_NAMES = {core_name(name): name for name in (*VALUES, *OTHERS.split())}


def api_name(quantity: str) -> str:
    """API name of a core quantity, with its unit at the end.

    >>> api_name("line_load"), api_name("ratio")
    ('line_load_N_per_mm', 'ratio')
    """
    return _NAMES.get(quantity) or field_of(quantity)


def step_values(section: str, step: Step) -> Values:
    """Values of a step of a section."""
    code = api_name(step.code)
    names = {symbol: api_name(amount.quantity) for symbol, amount in step.values.items()}
    values: Values = {
        "section": section,
        "code": code,
        "symbol": step.symbol,
        "names": names,
        "values": {
            symbol: from_si(names[symbol], amount.value) for symbol, amount in step.values.items()
        },
        "result": from_si(code, step.result),
        "unit": shown_unit(code),
    }
    for name in ("formula", "method", "source", "equation", "erratum", "note"):
        if text := getattr(step, name):
            values[name] = text
    if step.params:
        values["params"] = dict(step.params)
    return values


def worked(**sections: list[Step]) -> list[Values]:
    """Steps of an answer, section after section, without those of infinite results."""
    return [
        step_values(section, step)
        for section, steps in sections.items()
        for step in steps
        if math.isfinite(step.result)
    ]


def stated(section: str, values: Values, method: str) -> list[Values]:
    """Steps of the numbers of a section's answer that all follow by one method."""
    return [
        {
            "section": section,
            "code": name,
            "symbol": core_name(name),
            "names": {},
            "values": {},
            "result": float(value),
            "unit": shown_unit(name),
            "method": method,
        }
        for name, value in values.items()
        if isinstance(value, (int, float)) and not isinstance(value, bool)
    ]
