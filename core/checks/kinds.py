"""What is checked, why and by which formula; sources and what is left out, by code."""

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Kind:
    """What a check is.

    Attributes
    ----------
    title : str
        Its name in English.
    group : str
        What it is about, a key of `GROUPS`.
    unit : str
        Unit of value and limit as names end in it; empty for plain numbers.
    formula : str
        What has to hold.
    why : str
        What is wrong where it does not hold, in English.
    inputs : tuple of str
        Core names of the inputs that it depends on.
    source : str
        Where the formula comes from, a key of `CHECK_SOURCES`.
    keep : {"below", "above"}
        On which side of the limit the value has to stay.
    """

    title: str
    group: str
    unit: str
    formula: str
    why: str
    inputs: tuple[str, ...]
    source: str = "geometry"
    keep: Literal["below", "above"] = "below"


GROUPS = {
    "mechanism": "Mechanism",
    "contact": "Contact of pin and hole",
    "geometry": "Pins and holes",
    "play": "Play of the output",
    "pin": "Strength of the pins",
    "friction": "Friction and wear",
    "gear": "Ring",
    "bearing": "Bearings of the satellites",
    "crankshaft": "Crankshaft",
    "body": "Satellite",
    "rollers": "Rollers",
    "lines": "Contact lines",
    "shaft": "Bending of the shaft",
    "room": "Room for rollers and shaft",
}
"""What checks are about, in English, by code."""

CHECK_SOURCES = {
    "archard_1953": "Archard 1953, with the wear coefficient that was given",
    "balance": "statics of rotating masses",
    "beam": "beam theory (Mohr)",
    "geometry": "geometry",
    "hertz": "Johnson, Contact Mechanics, 4.2: Hertz asks for a narrow contact",
    "iso_281_life": "ISO 281:2007, with the ratings that were given",
    "iso_76_rating": "ISO 76: the rating is the load that dents by 1e-4 of a rolling element",
    "johnson_yield": "Johnson, Contact Mechanics, 4.2 and 9.1; recomputed: p = 1.79*Re (Mises)",
    "johnson_shakedown": "Melan's theorem, as in Johnson, Contact Mechanics, 9.2; recomputed: "
    "p = 2.31*Re (Mises)",
    "load_sharing": "solved over the turn with clearance, deviations and elasticity, as by "
    "load sharing",
    "ovsyannikov_2019": "Ovsyannikov et al. 2019",
    "ovsyannikov_2019_length": "Ovsyannikov et al. 2019, before fig. 3: usually rollers are at "
    "least ten times as long as the centre distance, tilted by about 12°",
    "pin_beam": "beam theory, the true locus of the moment; yield strength of the material",
    "roots": "geometry; where no root radius is given: of a cycloid disc r_f = R_p − e − r_p, of "
    "involute teeth r_f = m·(z₂/2 − 1.25 + x) by the basic rack of ISO 53, with a profile shift "
    "taken as 0 ≤ x ≤ 1.25",
    "shigley": "Shigley, Mechanical Engineering Design, 6; or the endurance limit that was given",
    "static_guide": "guide values for running as usual, 1 for balls and 1.5 for rollers: "
    "catalogues of SKF and IKO, after ISO 76",
    "steep": "derived: above 55° the ring presses the satellite along the crank far more than it "
    "turns it",
    "user": "the limit that was asked",
    "wang_2016": "Wang, Luo, Su 2016, eqs 32, 33, and the wall that was asked",
    "yanchevskiy_2021": "Yanchevskiy, Niekhoroshykh 2021",
    "yanchevsky_2018": "Yanchevsky et al. 2018, eq. 2",
}
"""Where the formulas of checks come from, in English, by code."""

NOT_CONSIDERED = {
    "bearing": "bearings of the satellites",
    "clearance": "load sharing with clearance and deviations",
    "contact": "pins and holes",
    "contact_life_hole": "life of the holes under their contact pressure",
    "contact_life_pin": "life of the pins under their contact pressure",
    "crankshaft": "crankshaft and balance of masses",
    "deflection": "deflection of the shaft, of which no limit is asked",
    "fatigue": "fatigue",
    "friction": "friction, wear and efficiency",
    "gear": "teeth of satellite and ring",
    "line_pressure": "pressure along the contact lines",
    "load": "load",
    "pin": "bending of the pins",
    "roller_contact": "contact of spheres and holes",
    "satellite_body": "body of the satellite",
    "shaft_strength": "strength of the shaft",
    "slope": "slope of the shaft, of which no limit is asked",
}
"""What a verdict does not consider, in English, by code."""

_FORCE = (
    "load.output_torque",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "load.force_exponent",
)
_HOLE = ("contact.pin_radius", "contact.hole_radius", "contact.hole_clearance")
_FACTORS = ("contact.dynamic_factor", "load.application_factor")
_LOADS = ("load.input_speed", "mechanism.ratio", "requirements.life")
_BEAM = (
    "pin.diameter",
    "pin.satellite_positions",
    "pin.support",
    "pin.span",
    "pin.contact_length",
    "pin.material",
)
"""Of pins, by whose bending satellites share the load and contacts press on their edges."""
_SHARING = (
    "contact.contact_length",
    *_HOLE,
    "contact.eccentricity",
    "contact.pin_material",
    "contact.hole_material",
    *_BEAM,
    "contact_law",
    "deviations",
    "crank_support",
    "satellite_coupling",
)
"""Of pins and holes as they are made: how satellites and pins share the load."""
_FORCES = (*_FORCE, *_FACTORS, *_SHARING)
_CONTACT = (*_FORCES, "contact.distribution_factor")
_PIN = _FORCES
_FATIGUE = (
    "fatigue.surface",
    "fatigue.surface_factor",
    "fatigue.reliability_percent",
    "fatigue.reliability_factor",
    "fatigue.fatigue_notch_factor",
    "fatigue.notch",
    "fatigue.endurance_limit",
    "fatigue.criterion",
)
_TURNING = ("load.input_speed", "mechanism.ratio", "contact.eccentricity")
_RING = (
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.reference_pressure_angle",
    "gear.ring_pin_circle_radius",
    "gear.radial_force_ratio",
)
_ROOTS = (
    "satellite_body.outer_radius",
    "satellite_body.root_radius",
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.ring_pin_circle_radius",
    "gear.ring_pin_radius",
    "mechanism.ratio",
    "contact.eccentricity",
)
"""Of where the roots of a satellite's teeth are."""
_BEARING = (*_FORCES, "mechanism.ratio", *_RING, "bearing.kind")
_LIFE = ("load.input_speed", "requirements.life")
_BALANCE = (
    "load.input_speed",
    "contact.eccentricity",
    "crankshaft.satellite_mass",
    "crankshaft.satellite_positions",
    "mechanism.crank_spacing",
    "mechanism.crank_angles",
)
_PLAY = (
    "mechanism.pins",
    "mechanism.satellites",
    "load.pin_circle_radius",
    *_HOLE,
    "contact.eccentricity",
)
_ROLLER = (
    "output_torque",
    "hole_circle_radius",
    "rollers",
    "diameter",
    "cylinder_length",
    "sphere_width",
    "position_tolerance",
    "gaps",
)
_SHAFT = ("torque", "bearing_distance", "overhang", "shaft_diameter", "shaft_sections")


def _contact_kinds(body: str) -> dict[str, Kind]:
    """Checks of the surface of pin or hole."""
    inputs = _CONTACT
    return {
        f"contact_pressure_{body}": Kind(
            f"Contact pressure of the {body}", "contact", "MPa", "p ≤ p_all·Z_NT/S",
            f"Above it the surface of the {body} pits within the life.",
            (*inputs, *_LOADS, "requirements.pitting_safety"), "yanchevsky_2018",
        ),
        f"contact_shakedown_{body}": Kind(
            f"Shakedown of the {body}", "contact", "MPa", "p ≤ 2.31·R_e",
            f"Above it the surface of the {body} flows on with every turn.",
            inputs, "johnson_shakedown",
        ),
        f"contact_yield_{body}": Kind(
            f"First yield of the {body}", "contact", "MPa", "p ≤ 1.79·R_e",
            f"Above it the {body} yields below its surface in the first turns.",
            inputs, "johnson_yield",
        ),
    }  # fmt: skip


CHECKS = {
    "dead_centre": Kind(
        "Dead centres", "mechanism", "", "Δθ < 180°",
        "There no pair drives, and no torque is transmitted.",
        ("mechanism.pins", "mechanism.satellites", "mechanism.crank_spacing",
         "mechanism.crank_angles"), "yanchevskiy_2021",
    ),
    "crank_balance": Kind(
        "Static balance of the crank spacing", "mechanism", "", "|Σ e^(i·α_j)|/K = 0",
        "Otherwise the satellites shake the reducer with every turn of the crank.",
        ("mechanism.satellites", "mechanism.crank_spacing", "mechanism.crank_angles"),
    ),
    "assembly": Kind(
        "Satellites that differ", "mechanism", "", "ψ_j = 0",
        "Otherwise they are different parts that can be exchanged by mistake.",
        ("mechanism.satellite_teeth", "mechanism.ring_teeth", "mechanism.pins",
         "mechanism.crank_spacing", "mechanism.crank_angles"),
        "yanchevskiy_2021",
    ),
    **_contact_kinds("pin"),
    **_contact_kinds("hole"),
    "contact_conformity": Kind(
        "Width of the contact", "contact", "", "a/r ≤ 0.159",
        "Above it the pressure by Hertz is off by more than 1 %.",
        _CONTACT, "hertz",
    ),
    "interference": Kind(
        "Room of the pins in their holes", "geometry", "mm", "min(C − |P·exp(−iθ) − H|) ≥ 0",
        "Otherwise the parts cannot be put together, jam, or press without load.",
        (*_HOLE, "contact.eccentricity", "deviations"), "geometry", keep="above",
    ),
    "clearance": Kind(
        "Clearance over eccentricity", "geometry", "", "(r_out − r_in − e)/e ≤ 0.75",
        "Otherwise the play is a large part of what the mechanism moves by.",
        (*_HOLE, "contact.eccentricity"), "yanchevskiy_2021",
    ),
    "backlash": Kind(
        "Backlash of the output mechanism", "play", "arcmin", "max(θ₊ − θ₋) ≤ Δφ",
        "Otherwise the unloaded output turns by more than is asked.",
        (*_PLAY, "deviations", "crank_support", "requirements.max_backlash"), "load_sharing",
    ),
    "lost_motion": Kind(
        "Lost motion of the output mechanism", "play", "arcmin", "θ(+3 % T) − θ(−3 % T) ≤ Δφ",
        "Otherwise the output gives way by more than is asked when the torque turns.",
        ("load.output_torque", "load.pin_circle_radius", "mechanism.pins", "mechanism.satellites",
         *_SHARING,
         "requirements.max_lost_motion"), "load_sharing",
    ),
    "wall_holes": Kind(
        "Wall between holes", "geometry", "mm", "2·R·sin(π/N) − 2·r_out ≥ w",
        "Otherwise the holes overlap, or the satellite is weak between them.",
        ("mechanism.pins", "load.pin_circle_radius", "contact.hole_radius",
         "requirements.min_wall"), "wang_2016", keep="above",
    ),
    "pins_apart": Kind(
        "Space between pins", "geometry", "mm", "2·R·sin(π/N) − 2·r_in > 0",
        "Otherwise the pins overlap.", ("mechanism.pins", "load.pin_circle_radius",
         "contact.pin_radius"), keep="above",
    ),
    "holes_off_centre": Kind(
        "Holes beside the centre", "geometry", "mm", "R − r_out > 0",
        "Otherwise the holes reach the axis.", ("load.pin_circle_radius", "contact.hole_radius"),
        keep="above",
    ),
    "wall_rim": Kind(
        "Wall to the rim", "body", "mm", "r_f − R − r_out ≥ w",
        "Otherwise the holes break through the rim of the satellite.",
        (*_ROOTS, "load.pin_circle_radius", "contact.hole_radius", "requirements.min_wall"),
        "wang_2016", keep="above",
    ),
    "wall_bore": Kind(
        "Wall to the bore", "body", "mm", "R − r_out − r_b ≥ w",
        "Otherwise the holes break into the bore of the satellite.",
        ("satellite_body.bore_radius", "load.pin_circle_radius", "contact.hole_radius",
         "requirements.min_wall"), "wang_2016", keep="above",
    ),
    "outer_diameter": Kind(
        "Diameter of the space of the satellites", "body", "mm", "2·(r_o + e) ≤ D_max",
        "Otherwise the satellites do not fit into the space that is asked.",
        ("satellite_body.outer_radius", "contact.eccentricity", "requirements.max_outer_diameter"),
    ),
    "pin_static": Kind(
        "Static strength of the pins", "pin", "MPa", "σ_v ≤ R_e/S_F",
        "Above it the pins bend for good.",
        (*_PIN, "load.peak_torque", "requirements.bending_safety"), "pin_beam",
    ),
    "pin_fatigue": Kind(
        "Fatigue of the pins", "pin", "", "n ≥ S_D",
        "Below it the pins break after some time where they bend most.",
        (*_PIN, *_FATIGUE, *_LOADS, "requirements.fatigue_safety"), "shigley", keep="above",
    ),
    "pin_deflection": Kind(
        "Deflection of the pins", "pin", "mm", "w ≤ Δ_max",
        "Above it the satellites share the load unevenly.", (*_PIN, "requirements.max_deflection"),
        "beam",
    ),
    "pin_slope": Kind(
        "Slope of the pins in the satellites", "pin", "mrad", "θ ≤ θ_max",
        "Above it the contacts carry on their edges.", (*_PIN, "requirements.max_slope"), "beam",
    ),
    "efficiency": Kind(
        "Efficiency of the output mechanism", "friction", "", "η ≥ η_min",
        "Below it more is lost than is asked.",
        (*_FORCE, *_SHARING, "mechanism.ratio", "friction.coefficient", "friction.sleeve",
         "requirements.min_efficiency"), "user", keep="above",
    ),
    "sliding_speed": Kind(
        "Sliding speed", "friction", "m_per_s", "v ≤ v_max",
        "Above it the surfaces get hot.",
        (*_TURNING, "friction.sleeve", "pin.diameter", "contact.pin_radius",
         "requirements.max_sliding_speed"), "user",
    ),
    "pv": Kind(
        "Pressure times sliding speed", "friction", "MPa_m_per_s", "p·v ≤ (pv)_all",
        "Above it the surfaces get hot and wear fast.",
        (*_FORCES, "load.input_speed", "mechanism.ratio", "friction.sleeve", "requirements.max_pv"),
        "user",
    ),
    "wear": Kind(
        "Wear of pins and holes", "friction", "mm", "h ≤ h_max",
        "Above it the output has more play than is asked before the end of its life.",
        (*_FORCES, *_LIFE, "mechanism.ratio", "friction.wear_rate", "friction.life",
         "requirements.max_wear"),
        "archard_1953",
    ),
    "pressure_angle": Kind(
        "Operating pressure angle", "gear", "deg", "α_w ≤ 55°",
        "Above it the ring loads the bearings far more than the torque needs.",
        (*_RING, "contact.eccentricity"), "steep",
    ),
    "gear_room": Kind(
        "Holes within the teeth", "gear", "mm", "r_f − R − r_out > 0",
        "Otherwise the holes lie in the teeth of the satellite, or beyond.",
        (*_ROOTS, "load.pin_circle_radius", "contact.hole_radius"), keep="above",
    ),
    "bearing_life": Kind(
        "Life of the satellites' bearings", "bearing", "h", "L_nh ≥ L",
        "Otherwise a bearing of a satellite fails before the life that is asked.",
        (*_BEARING, *_LIFE, "bearing.ring_factor", "bearing.dynamic_rating",
         "bearing.reliability_percent"),
        "iso_281_life", keep="above",
    ),
    "bearing_static": Kind(
        "Static load of the satellites' bearings", "bearing", "", "C₀/Q_max ≥ S_0",
        "Otherwise rolling elements dent their tracks.",
        (*_BEARING, "load.peak_torque", "bearing.static_rating", "requirements.static_safety"),
        "iso_76_rating",
        keep="above",
    ),
    "system_life": Kind(
        "Life of all satellites' bearings together", "bearing", "h", "(Σ L_j^−β)^(−1/β) ≥ L",
        "Otherwise one of the bearings fails before the life that is asked.",
        (*_BEARING, *_LIFE, "bearing.ring_factor", "bearing.dynamic_rating",
         "bearing.reliability_percent", "bearing.weibull_slope"),
        "iso_281_life", keep="above",
    ),
    "crank_bearing_life": Kind(
        "Life of the crankshaft's bearings", "crankshaft", "h", "L_10h ≥ L",
        "Otherwise a bearing of the crankshaft fails before the life that is asked.",
        (*_FORCES, *_LIFE, "mechanism.ratio", *_RING, "crankshaft.bearings",
         "crankshaft.satellite_positions", "crankshaft.bearing_positions",
         "mechanism.crank_spacing", "mechanism.crank_angles"),
        "iso_281_life", keep="above",
    ),
    "unbalance_force": Kind(
        "Unbalanced force of the satellites", "crankshaft", "N", "|Σ m·e·ω²| ≤ F_U",
        "Above it the satellites shake the reducer more than is asked.",
        (*_BALANCE, "requirements.max_unbalance"), "balance",
    ),
    "unbalance_couple": Kind(
        "Unbalanced couple of the satellites", "crankshaft", "Nm", "|Σ m·e·z·ω²| ≤ M_U",
        "Above it the satellites shake the reducer more than is asked.",
        (*_BALANCE, "requirements.max_unbalance_couple"), "balance",
    ),
    "roller_stress": Kind(
        "Bending stress of the rollers", "rollers", "MPa", "σ ≤ R_e/S",
        "Above it the rollers bend for good.",
        (*_ROLLER, "stress_concentration", "yield_strength", "bending_safety"),
        "ovsyannikov_2019",
    ),
    "roller_fatigue": Kind(
        "Fatigue of the rollers", "rollers", "", "n ≥ S_D",
        "Below it the rollers break after some time beside the middle sphere.",
        (*_ROLLER, "stress_concentration", "roller_rotates", "tensile_strength", *_FATIGUE,
         "fatigue_safety"), "shigley", keep="above",
    ),
    "roller_sharing": Kind(
        "Rollers that carry", "rollers", "", "n_c = n",
        "Otherwise few rollers carry all of the load.", _ROLLER, "ovsyannikov_2019", keep="above",
    ),
    "roller_spacing": Kind(
        "Space between rollers", "rollers", "mm", "2·R·sin(π/n) − D > 0",
        "Otherwise the spheres overlap.", ("rollers", "hole_circle_radius", "sphere_diameter"),
        keep="above",
    ),
    "roller_room": Kind(
        "Rollers beside the centre", "rollers", "mm", "R − D/2 > 0",
        "Otherwise the rollers reach the axis.", ("hole_circle_radius", "sphere_diameter"),
        keep="above",
    ),
    "roller_tilt": Kind(
        "Length of the rollers", "rollers", "mm", "2·l + 3·b ≥ 10·e",
        "Shorter ones tilt too much against the discs.",
        ("cylinder_length", "sphere_width", "eccentricity"), "ovsyannikov_2019_length",
        keep="above",
    ),
    "line_spacing": Kind(
        "Space between rollers", "room", "mm", "2·R_C·sin(Δφ/2) − 2·ρ > 0",
        "Otherwise the rollers overlap.", ("roller_circle_radius", "roller_radius", "wheel"),
        keep="above",
    ),
    "shaft_in_circle": Kind(
        "Shaft within the rollers", "room", "mm", "R_C − ρ − d/2 > 0",
        "Otherwise the shaft reaches the rollers.",
        ("roller_circle_radius", "roller_radius", "shaft_diameter", "shaft_sections"), keep="above",
    ),
    "shaft_deflection": Kind(
        "Deflection of the shaft", "shaft", "mm", "max(Δ_B, Δ_C) ≤ Δ_max",
        "Above it the mesh is off its place.", (*_SHAFT, "max_deflection"), "beam",
    ),
    "shaft_slope": Kind(
        "Slope of the shaft in its bearings", "shaft", "mrad", "max(θ_B, θ_C) ≤ θ_max",
        "Above it the bearings carry on their edges.", (*_SHAFT, "max_slope"), "beam",
    ),
    "shaft_static": Kind(
        "Static strength of the shaft in bending", "shaft", "MPa", "σ ≤ R_e/S_F",
        "Above it the shaft bends for good.",
        (*_SHAFT, "yield_strength", "bending_safety"), "beam",
    ),
    "shaft_fatigue": Kind(
        "Fatigue of the shaft in bending", "shaft", "", "n ≥ S_D",
        "Below it the shaft breaks after some time where it bends most.",
        (*_SHAFT, "load_rotates_with_shaft", "tensile_strength", *_FATIGUE, "fatigue_safety"),
        "shigley", keep="above",
    ),
    "line_pressure": Kind(
        "Pressure along the contact lines", "lines", "MPa", "p₀ ≤ p_all/S_H",
        "Above it rollers or teeth pit in the long run.",
        ("torque", "roller_radius", "line_contact.mating_radius", "line_contact.roller_material",
         "line_contact.mating_material", "pitting_safety"), "hertz",
    ),
}  # fmt: skip
"""Every check by code."""
