"""Requests whose worked steps are looked at: all kinds of pins, rings, bearings and loads."""

from typing import Any

STEEL = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3, "allowable_pressure_MPa": 900.0}
PIN_STEEL = {
    "youngs_modulus_GPa": 210.0,
    "poissons_ratio": 0.3,
    "yield_strength_MPa": 800.0,
    "tensile_strength_MPa": 1000.0,
}
BARE: dict[str, Any] = {
    "pin": {
        "support": "cantilever",
        "satellite_positions_mm": [15.0, 37.0],
        "material": PIN_STEEL,
    },
    "fatigue": {
        "surface": "machined",
        "notch": {"theoretical_factor": 2.0, "radius_mm": 0.5},
        "reliability_percent": 99.0,
    },
    "friction": {"coefficient": 0.08, "wear_rate_mm3_per_Nm": 1e-8},
    "gear": {"kind": "involute", "module_mm": 1.75, "teeth_difference": 2},
    "bearing": {
        "kind": "roller",
        "dynamic_rating_N": 60000.0,
        "static_rating_N": 40000.0,
        "reliability_percent": 95.0,
        "weibull_slope": 1.1,
    },
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
        "satellite_mass_kg": 1.5,
        "bearings": [
            {"kind": "ball", "dynamic_rating_N": 30000.0},
            {"kind": "roller", "dynamic_rating_N": 20000.0},
        ],
    },
}
SLEEVED: dict[str, Any] = BARE | {
    "pin": BARE["pin"] | {"support": "supported", "span_mm": 52.0, "diameter_mm": 11.0},
    "friction": BARE["friction"] | {"sleeve": True},
    "fatigue": {"endurance_limit_MPa": 300.0, "criterion": "soderberg"},
    "gear": {"kind": "cycloid", "ring_pin_circle_radius_mm": 60.0},
    "bearing": {"kind": "ball"},
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
    },
}
BUILT_IN: dict[str, Any] = SLEEVED | {
    "pin": BARE["pin"]
    | {
        "support": "fixed",
        "satellite_positions_mm": [12.0, 34.0, 56.0],
        "span_mm": 70.0,
        "diameter_mm": 12.0,
    },
    "bearing": BARE["bearing"] | {"kind": "ball", "ring_factor": 1.2},
    "crankshaft": BARE["crankshaft"] | {"satellite_positions_mm": [20.0, 42.0, 64.0]},
}
TYPED: dict[str, Any] = BARE | {
    "gear": {"radial_force_ratio": 0.4},
    "fatigue": {"surface_factor": 0.8, "fatigue_notch_factor": 1.3, "criterion": "gerber"},
}
CONTACT = {
    "contact_length_mm": 20.0,
    "pin_radius_mm": 8.0,
    "eccentricity_mm": 2.0,
    "hole_radius_mm": 10.0,
}


def _design(parts: dict[str, Any], hours: float, **load: Any) -> dict[str, Any]:
    """A whole design of six pins and two satellites."""
    given = {
        "output_torque_Nm": 500.0,
        "pin_circle_radius_mm": 50.0,
        "input_speed_rpm": 1500.0,
        "application_factor": 1.25,
    }
    return {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": given | load,
        "contact": CONTACT,
        "requirements": {"life_h": hours},
        **parts,
    }


TEETH = {
    "mechanism": {
        "pins": 5,
        "satellites": 2,
        "satellite_teeth": 41,
        "ring_teeth": 43,
        "crank_angles_deg": [0.0, 170.0],
        "initial_crank_angle_deg": 33.0,
    },
    "load": {
        "input_torque_Nm": 25.0,
        "efficiency": 0.9,
        "pin_circle_radius_mm": 40.0,
        "force_exponent": 1.5,
        "application_factor": 1.2,
    },
    "contact": {
        "contact_length_mm": 10.0,
        "pin_radius_mm": 5.0,
        "hole_radius_mm": 5.02,
        "eccentricity_mm": 0.02,
        "pin_material": STEEL,
        "hole_material": STEEL,
    },
}
LOOSE = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
    "load": {
        "output_torque_Nm": 200.0,
        "pin_circle_radius_mm": 40.0,
        "application_factor": 1.25,
    },
    "contact": {
        "contact_length_mm": 12.0,
        "pin_radius_mm": 5.0,
        "hole_radius_mm": 7.03,
        "eccentricity_mm": 2.0,
    },
    "include": ["cyclogram", "contact_force", "hertz", "geometry"],
}
EQUAL = {
    "mechanism": {"pins": 7, "satellites": 3, "ratio": 9.5},
    "load": {
        "output_torque_Nm": 80.0,
        "pin_circle_radius_mm": 44.0,
        "force_exponent": 0.0,
        "include": ["equal_sharing", "approximation"],
    },
}
RING = _design(BARE, 4000.0) | {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0, "output": "ring"},
    "crankshaft": BARE["crankshaft"]
    | {"bearings": [each | {"in": "ring"} for each in BARE["crankshaft"]["bearings"]]},
}
BOTH = _design(BARE, 4000.0, ring_speed_rpm=-40.0) | {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0, "output": "both"}
}
BY_PINS = _design(BARE, 4000.0, carrier_speed_rpm=30.0) | {"mechanism": BOTH["mechanism"]}
COUPLING = {
    "mechanism": {"pins": 5, "output": "coupling"},
    "load": {"output_torque_Nm": 40.0, "pin_circle_radius_mm": 30.0, "input_speed_rpm": 600.0},
    "contact": CONTACT,
    "friction": BARE["friction"],
    "requirements": {"life_h": 2000.0},
}
THREE = _design(BUILT_IN, 4000.0, torque_direction="reverse") | {
    "mechanism": {"pins": 5, "satellites": 3, "ratio": 20.0}
}
SKEW = _design(TYPED, 4000.0, torque_direction="alternating", force_exponent=1.5) | {
    "mechanism": {"pins": 5, "satellites": 2, "ratio": 20.0, "crank_angles_deg": [0.0, 100.0]}
}
ROLLERS = {
    "output_torque_Nm": 150.0,
    "hole_circle_radius_mm": 28.0,
    "rollers": 5,
    "gaps_mm": [0.01, 0.0, 0.2, 0.015, 0.004],
    "diameter_mm": 9.0,
    "cylinder_length_mm": 16.0,
    "sphere_width_mm": 7.0,
    "sphere_diameter_mm": 12.0,
    "friction_coefficient": 0.12,
    "youngs_modulus_GPa": 206.0,
    "poissons_ratio": 0.29,
    "yield_strength_MPa": 700.0,
}
TENSILE = {"tensile_strength_MPa": 950.0}
GEAR: dict[str, Any] = {
    "roller_circle_radius_mm": 60.0,
    "roller_radius_mm": 5.0,
    "nutation_angle_deg": 5.0,
    "ratio_u12": 0.95,
    "rollers": [
        {"position_angle_deg": 40.0, "phi_min_deg": -70.0, "phi_max_deg": -55.0},
        {"position_angle_deg": 75.0, "z_min_mm": 12.0, "z_max_mm": 30.0},
    ],
}
MESH: dict[str, Any] = GEAR | {"torque_Nm": -12.0, "reference_z_mm": 25.0}
SHAFT: dict[str, Any] = MESH | {
    "bearing_distance_mm": 35.0,
    "overhang_mm": 45.0,
    "youngs_modulus_GPa": 200.0,
}
STEPPED = {
    "shaft_sections": [
        {"length_mm": 50.0, "diameter_mm": 12.0},
        {"length_mm": 30.0, "diameter_mm": 16.0},
    ]
}
TOOTH = STEEL | {"youngs_modulus_GPa": 118.0, "poissons_ratio": 0.34}

BORED = _design({"pin": BARE["pin"] | {"bore_diameter_mm": 9.0}}, 4000.0)
BORED_BUILT_IN = _design(
    {"pin": BARE["pin"] | {"bore_diameter_mm": 5.0, "support": "fixed", "span_mm": 52.0}}, 4000.0
)
RATED = {"dynamic_rating_N": 30000.0, "static_rating_N": 20000.0}
ROLLED = _design(
    {"rollers": {"kind": "ball", "bore_diameter_mm": 10.0, "rolling_elements": 8, **RATED}}, 4000.0
)
ROLLED_BY_NEEDLES = _design(
    {
        "pin": BARE["pin"],
        "rollers": {
            "kind": "needle",
            "bore_diameter_mm": 10.0,
            "outer_diameter_mm": 16.0,
            "radial_clearance_mm": 0.02,
            "ratings": "bearing",
            **RATED,
        },
    },
    4000.0,
    peak_torque_Nm=900.0,
)
BARE_4000, SLEEVED_4000 = _design(BARE, 4000.0), _design(SLEEVED, 4000.0, peak_torque_Nm=900.0)

WEIGHTED: dict[str, Any] = BARE["crankshaft"] | {
    "counterweights": [
        {"unbalance_kg_mm": 1.2, "position_mm": 5.0, "angle_deg": 170.0},
        {"unbalance_kg_mm": 0.8, "position_mm": 70.0, "angle_deg": 40.0},
    ],
    "rotor_mass_kg": 5.0,
}
UNEVEN: dict[str, Any] = BARE_4000 | {
    "contact": CONTACT | {"distribution_factor": 1.3},
    "include": ["pin_strength", "satellite_bearing", "crankshaft", "hertz", "output_efficiency"],
}

_WORN = {"life_h": 4000.0}


def _single(design: dict[str, Any], *parts: str, **more: Any) -> dict[str, Any]:
    """The request of a single calculation."""
    return {name: design[name] for name in ("mechanism", "load", "contact", *parts)} | more


DISCS: dict[str, Any] = {
    "mechanism": {"satellite_teeth": 11, "ring_teeth": 12, "satellites": 2},
    "load": {"output_torque_Nm": 100.0, "input_speed_rpm": 1500.0},
    "contact": {"eccentricity_mm": 2.5},
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 50.0,
        "ring_pin_radius_mm": 5.0,
        "contact_length_mm": 12.0,
        "modification": {"equidistant_mm": 0.02, "pin_circle_mm": -0.01},
        "friction_coefficient": 0.06,
    },
    "crank_angle_deg": [17.0],
    "include": ["positions", "over_turn", "ideal"],
}
"""Cycloid discs on the pins of their ring."""

TOUCHING_TWICE = DISCS | {
    "contact": {"eccentricity_mm": 1.0},
    "gear": DISCS["gear"] | {"modification": {"equidistant_mm": 0.02, "pin_circle_mm": 0.0197}},
    "deviations": {"ring_pin_radius_mm": [0.001, -0.001, 0.002] * 4},
    "include": ["positions", "ideal"],
}
"""Of which two pins touch at once, and flanks bend most at the tip."""

INVOLUTE: dict[str, Any] = {
    "mechanism": {"satellite_teeth": 40, "ring_teeth": 42, "satellites": 2},
    "load": {"output_torque_Nm": 400.0},
    "contact": {"eccentricity_mm": 3.68},
    "gear": {
        "kind": "involute",
        "module_mm": 3.0,
        "satellite_profile_shift": 0.1,
        "ring_profile_shift": 0.46,
        "satellite_addendum": 0.8,
        "ring_addendum": 0.8,
        "contact_length_mm": 20.0,
    },
}
"""Involute teeth with a little backlash."""

REQUESTS: dict[str, tuple[str, dict[str, Any]]] = {
    "discs": ("ring-mesh", DISCS),
    "discs that touch twice": ("ring-mesh", TOUCHING_TWICE),
    "involutes": ("ring-mesh", INVOLUTE),
    "involutes without backlash": (
        "ring-mesh",
        {name: part for name, part in INVOLUTE.items() if name != "contact"},
    ),
    "teeth": ("crank-planetary", TEETH),
    "loose": (
        "crank-planetary",
        LOOSE
        | {
            "satellite_body": {"outer_radius_mm": 60.0},
            "include": [*LOOSE["include"], "envelope", "mass"],
        },
    ),
    "equal": ("crank-planetary", EQUAL),
    "bare": ("crank-planetary", BARE_4000),
    "short life": ("crank-planetary", _design(BARE, 5.0)),
    "sleeved": ("crank-planetary", SLEEVED_4000),
    "three": ("crank-planetary", THREE),
    "ring": ("crank-planetary", RING),
    "ring's members": ("crank-planetary", RING | {"include": ["members"]}),
    "members": ("crank-planetary", BARE_4000 | {"include": ["members"]}),
    "both": ("crank-planetary", BOTH | {"include": ["members", "output_efficiency"]}),
    "both by the pins": (
        "crank-planetary",
        BY_PINS | {"include": ["members", "satellite_bearing"]},
    ),
    "coupling": ("crank-planetary", COUPLING),
    "coupling driven": (
        "contact-force",
        COUPLING["mechanism"]
        | {"input_torque_Nm": 40.0, "efficiency": 0.9, "pin_circle_radius_mm": 30.0},
    ),
    "skew": ("crank-planetary", SKEW),
    "cyclogram": ("cyclogram", TEETH["mechanism"]),
    "force": ("contact-force", EQUAL["mechanism"] | EQUAL["load"]),
    "hertz": (
        "hertz",
        {name: each for name, each in CONTACT.items() if name != "eccentricity_mm"}
        | {"force_N": 5000.0},
    ),
    "pins": (
        "pin-strength",
        _single(BARE_4000, "pin", fatigue=BARE["fatigue"] | _WORN, include=["deflection"]),
    ),
    "bored": ("pin-strength", _single(BORED, "pin", include=["deflection"])),
    "bored, built in": ("pin-strength", _single(BORED_BUILT_IN, "pin", include=["deflection"])),
    "rolled": ("crank-planetary", ROLLED),
    "rolled by needles": ("crank-planetary", ROLLED_BY_NEEDLES),
    "losses of rollers": ("output-efficiency", _single(ROLLED, "rollers")),
    "losses": ("output-efficiency", _single(BARE_4000, friction=BARE["friction"] | _WORN)),
    "bearing": ("satellite-bearing", _single(BARE_4000, "pin", "gear", "bearing")),
    "shaft": ("crankshaft", _single(BARE_4000, "pin", "gear", "crankshaft")),
    "weighted": ("crankshaft", _single(BARE_4000, "gear", crankshaft=WEIGHTED)),
    "uneven": ("crank-planetary", UNEVEN),
    "rollers": ("roller-strength", ROLLERS | {"stress_concentration": 1.7}),
    "rollers given": (
        "roller-strength",
        ROLLERS
        | TENSILE
        | {"stress_concentration": 1.7, "fatigue": {"endurance_limit_MPa": 320.0}},
    ),
    "rollers turning": (
        "roller-strength",
        ROLLERS | TENSILE | {"fatigue": BARE["fatigue"], "roller_rotates": True},
    ),
    "lines": ("precession/contact-line", GEAR),
    "mesh": ("precession/meshing-load", MESH),
    "stepped": ("precession/shaft-deflection", SHAFT | STEPPED),
    "tired": (
        "precession/shaft-deflection",
        SHAFT | STEPPED | TENSILE | {"yield_strength_MPa": 600.0, "fatigue": BARE["fatigue"]},
    ),
    "touching": (
        "precession/shaft-deflection",
        SHAFT
        | {
            "shaft_diameter_mm": 16.0,
            "yield_strength_MPa": 600.0,
            "line_contact": {
                "mating_radius_mm": -40.0,
                "roller_material": STEEL,
                "mating_material": TOOTH,
            },
        },
    ),
}
"""By a word for each: the calculation, and its request without what is asked."""
