"""A design whose drawing shows if it is mirrored, and distances from outlines."""

import numpy as np

UNEVEN = {
    "mechanism": {
        "pins": 5, "satellites": 3, "satellite_teeth": 11, "ring_teeth": 12,
        "crank_angles_deg": [10.0, 95.0, 250.0], "initial_crank_angle_deg": 25.0,
    },
    "load": {"output_torque_Nm": 100.0, "pin_circle_radius_mm": 27.0},
    "contact": {
        "contact_length_mm": 10.0, "pin_radius_mm": 4.0, "eccentricity_mm": 2.5, "fit": "H7/f7",
    },
    "gear": {
        "kind": "cycloid", "ring_pin_circle_radius_mm": 50.0, "ring_pin_radius_mm": 5.0,
        "modification": {"equidistant_mm": 0.05, "pin_circle_mm": -0.2},
    },
    "bearing": {
        "kind": "ball", "dynamic_rating_N": 9000.0, "static_rating_N": 7000.0,
        "bore_diameter_mm": 15.0, "outer_diameter_mm": 28.0, "width_mm": 9.0,
    },
}  # fmt: skip
"""Cranks at uneven angles, none of them at 0, and an initial wave angle: a mirror shows."""


def distance(points, polygon):
    """How far points are from a closed polygon."""
    sides = np.roll(polygon, -1) - polygon
    from_ends = points[:, None] - polygon
    along = np.clip((from_ends / sides).real, 0, 1)
    return np.abs(from_ends - along * sides).min(axis=1)
