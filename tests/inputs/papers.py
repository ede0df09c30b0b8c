"""Swinging rollers and a precessional gear of the papers, as requests."""

from typing import Any

ROLLERS: dict[str, Any] = {
    "output_torque_Nm": 210,
    "hole_circle_radius_mm": 30,
    "rollers": 4,
    "position_tolerance_mm": 0.002,
    "diameter_mm": 10,
    "cylinder_length_mm": 20,
    "sphere_width_mm": 8,
    "sphere_diameter_mm": 15,
    "friction_coefficient": 0.16,
    "youngs_modulus_GPa": 210,
    "poissons_ratio": 0.3,
    "stress_concentration": 2,
}
"""Figure 6 of 2019 with d = 10 mm: T = 0.001*E*d^3, chi = 2e-4*d."""

GEAR: dict[str, Any] = {
    "roller_circle_radius_mm": 50,
    "roller_radius_mm": 4,
    "nutation_angle_deg": 6,
    "ratio_u12": 24 / 25,
    "rollers": [
        {"position_angle_deg": angle, "z_min_mm": 15, "z_max_mm": 25} for angle in (30, 60, 90, 120)
    ],
}
MESH: dict[str, Any] = {**GEAR, "torque_Nm": 10, "reference_z_mm": 20}
SHAFT: dict[str, Any] = {
    **MESH,
    "bearing_distance_mm": 30,
    "overhang_mm": 40,
    "shaft_diameter_mm": 20,
}
