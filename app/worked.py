"""Worked steps of an answer: steps of the core with API names and units."""

import math
from collections.abc import Iterable
from functools import cache
from typing import Any

from app.model import Values
from app.units import core_name, from_si, shown_unit
from core.worked.step import Step

QUANTITIES: dict[str, str] = {
    "mm": "arm bearing_distance bearing_position bolt_radius bore_diameter clearance "
    "conformal_half_length contact_length counterweight_position couple_arm cycle_position "
    "cylinder_length deflection deflection_B deflection_C diameter displacement eccentricity gap "
    "half_width hole_circle_radius hole_radius hole_wear length mating_radius max_shear_depth "
    "module overhang peak_moment_position peak_stress_position pin_circle_radius pin_radius "
    "pin_wear position position_tolerance radius reduced_radius reference_z "
    "ring_pin_circle_radius ring_pin_radius equidistant pin_circle tool_circle_radius tool_radius "
    "min_path_radius tip_radius root_radius min_concave_radius path_radius base_radius "
    "satellite_tip_radius ring_tip_radius eccentricity_without_backlash normal_backlash "
    "roller_circle_radius roller_radius satellite_position scale "
    "simplified_deflection_B simplified_deflection_C span sphere_diameter sphere_width "
    "total_length unit_moment z z_max z_min",
    "deg": "angle conformal_half_angle conformal_half_angle_hole conformal_half_angle_pin "
    "crank_angle direction full_turn half_turn hole_rotation initial_crank_angle nutation_angle "
    "operating_pressure_angle pattern_period peak_crank_angle period phi_max phi_min polar_angle "
    "pin_angle position_angle pressure_angle reference_pressure_angle right_angle working_phase",
    "arcmin": "backlash rotation",
    "N": "across_force approximate_peak balance_force centre_force centrifugal_force "
    "dynamic_rating dynamic_rating_as_roller equal_sharing_peak equivalent equivalent_load force "
    "max_force mean_force mean_sum_force min_load peak peak_force peak_load peak_ring_force "
    "peak_shear_force pin_force pins_force reaction_B reaction_C reaction_part reference_force "
    "ring_pin_force static_rating static_rating_as_roller",
    "Nm": "bending_moment bending_moment_B bending_moment_clamp couple crank_torque input_torque "
    "moment output_torque peak_moment pin_torque ring_torque satellite_torque torque",
    "MPa": "amplitude bending_stress conformal_pressure edge_tension endurance_limit "
    "finite_strength governing_pressure limit max_pressure max_shear max_stress mean "
    "mean_pressure min_stress notch_strength peak_bending_stress peak_equivalent_stress "
    "peak_shear_stress peak_stress tensile_strength yield_strength",
    "GPa": "effective_modulus shear_modulus youngs_modulus",
    "N_per_mm": "full_arm_load line_load max_line_load stiffness",
    "mm_per_N": "bending_compliance shear_compliance unit_deflection",
    "mrad_per_N": "unit_slope",
    "mrad": "slope",
    "rpm": "bearing_speed carrier_speed crank_to_ring_speed input_speed relative_speed ring_speed "
    "sleeve_speed speed turning_speed",
    "h": "basic_life fatigue_life life system_life",
    "W": "carrier_power crank_power mean_loss output_power ring_power",
    "kg": "rotor_mass satellite_mass",
    "kg_mm": "unbalance",
    "m_per_s": "sliding_speed",
    "MPa_m_per_s": "mean_pv peak_pv",
    "mm3_per_Nm": "wear_rate",
    "mm_per_s": "grade",
    "": "shortening_coefficient undercut_margin tool_shortening path_slope contact_ratio "
    "start_roll_satellite end_roll_satellite satellite_profile_shift ring_profile_shift "
    "satellite_addendum ring_addendum loss_per_friction loss_ratio "
    "approximate_peak_error coefficient cycles decades_left distribution_factor "
    "dynamic_factor "
    "efficiency exponent factor fatigue_safety_factor fit_exponent fit_scale force_exponent "
    "friction_coefficient friction_couple half_turns half_width_ratio life_cycles life_factor "
    "line_load_factor load_nonuniformity load_parameter load_parameter_again loaded_rollers loads "
    "logarithm mating_safety max_driving max_efficiency mean_driving mean_rim_pressure "
    "mean_total_force_ratio middle_pressure min_driving min_efficiency mismatch_alpha "
    "mismatch_beta neuber_root notch output_ratio peak_force_ratio pin pins pitches "
    "poissons_ratio radial_force_ratio rating_share ratio ratio_u12 relative_position_error "
    "relative_stiffness relative_stress reliability repeats ring_teeth roller_safety rollers "
    "rolling_elements safety_factor safety_hole safety_pin satellite_teeth satellites "
    "shear_coefficient shortening sides simplification_error_B simplification_error_C size "
    "static_rating_safety static_safety_factor strength_fraction stress_concentration "
    "stress_ratio surface teeth_difference theoretical_factor torque_share turns unit_shear",
}
"""Quantities of steps by core names, with the suffix of their unit."""

_SUFFIX = {name: unit for unit, names in QUANTITIES.items() for name in names.split()}


@cache
def api_name(quantity: str) -> str:
    """API name of a core quantity, with its unit at the end.

    Examples
    --------
    >>> api_name("pin_radius"), api_name("ratio")
    ('pin_radius_mm', 'ratio')
    """
    return f"{quantity}_{_SUFFIX[quantity]}".removesuffix("_")


def _params(params: Iterable[tuple[str, Any]]) -> Values:
    """Parameters of a step's texts, numbers in the unit of their name."""
    found: Values = {}
    for name, value in params:
        field = "gap_deg" if name == "gap_angle" else name
        found[field] = from_si(field, value) if isinstance(value, float) else value
    return found


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
        values["params"] = _params(step.params.items())
    return values


def worked(**sections: list[Step]) -> list[Values]:
    """Steps of an answer, section after section, without those whose result is infinite."""
    return [
        step_values(section, step)
        for section, steps in sections.items()
        for step in steps
        if math.isfinite(step.result)
    ]


def stated(section: str, values: Values, method: str) -> list[Values]:
    """Steps of numbers in a section that no formula derives; `method` is a key of
    `core.worked.words.NOTES`. Values that are not numbers have no step.
    """
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
