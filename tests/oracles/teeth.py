"""Existence of teeth with a small difference: all shifts and addenda of a grid are tried.

Lengths are in millimetres, angles in degrees.
"""

import math

import numpy as np

DEDENDUM = 1.25
TIP_RADIUS = 0.38
"""Of the basic rack that makes the satellite (ISO 53 A), in modules."""

USUAL_SHIFTS = np.arange(-0.5, 1.001, 0.05)
USUAL_ADDENDA = np.arange(0.25, 1.251, 0.05)
"""Profile shifts of the satellite, and addenda of both, in modules."""

TIPS_APART = 0.05
"""Least margin between tips that pass each other outside of the path of contact, in radians times
the number of teeth.
"""


def _inv(angle):
    return np.tan(angle) - angle


def contact_ratio(
    *,
    satellite_teeth: int,
    ring_teeth: int,
    module: float,
    eccentricity: float,
    angle: float = 20,
    shifts: np.ndarray = USUAL_SHIFTS,
    addenda: np.ndarray = USUAL_ADDENDA,
    apart: float = TIPS_APART,
) -> float:
    """Largest contact ratio of teeth without backlash, usual ones where nothing is said, whose tips
    do not meet outside of the path of contact, and whose path is one of involutes on satellite and
    ring, and which are not pointed; 0 where none exist.
    """
    z_s, z_r, m, e = satellite_teeth, ring_teeth, module, eccentricity
    difference, alpha = z_r - z_s, math.radians(angle)
    cosine = m * difference * math.cos(alpha) / (2 * e)
    if cosine >= 1:
        return 0.0
    working = math.acos(cosine)
    wider = difference * (_inv(working) - _inv(alpha)) / (2 * math.tan(alpha))
    x_s, h_s, h_r = np.meshgrid(shifts, addenda, addenda)
    tip_s, tip_r = m * (z_s / 2 + x_s + h_s), m * (z_r / 2 + x_s + wider - h_r)
    with np.errstate(invalid="ignore"):  # no involute at a tip within the base circle: no number
        at_tip_s = np.arccos(m * z_s * math.cos(alpha) / (2 * tip_s))
        at_tip_r = np.arccos(m * z_r * math.cos(alpha) / (2 * tip_r))
        # where the tip circles cross: never where the ring's is outside, and no number where the
        # tips overlap all round
        across_s = np.minimum(1, (tip_r**2 - tip_s**2 - e**2) / (2 * tip_s * e))
        across_r = np.minimum(1, (tip_r**2 - tip_s**2 + e**2) / (2 * tip_r * e))
        turned = z_s * (_inv(at_tip_s) + np.arccos(across_s))
        turned -= z_r * (_inv(at_tip_r) + np.arccos(across_r))
    free = (across_s == 1) | (turned + difference * _inv(working) >= apart)
    reference = math.pi / 2 * m, 2 * m * math.tan(alpha)  # thickness without a shift, and with one
    tooth = (reference[0] + reference[1] * x_s) / (m * z_s) + _inv(alpha) - _inv(at_tip_s)
    gap = (reference[0] - reference[1] * (x_s + wider)) / (m * z_r) - _inv(alpha) + _inv(at_tip_r)
    free &= (tooth >= 0) & (gap >= 0)
    start = (z_r * np.tan(at_tip_r) - difference * math.tan(working)) / z_s
    round_most = (math.pi / 4 - DEDENDUM * math.tan(alpha)) * math.cos(alpha)
    rounded = min(TIP_RADIUS, round_most / (1 - math.sin(alpha)))
    straight = DEDENDUM - rounded * (1 - math.sin(alpha))
    form = math.tan(alpha) - 4 * (straight - x_s) / (z_s * math.sin(2 * alpha))
    on_involutes = (start >= form) & (form >= 0)  # else they reach below one, or it is undercut
    path = z_s * (np.tan(at_tip_s) - math.tan(working))
    path += z_r * (math.tan(working) - np.tan(at_tip_r))
    return float(np.max(path[free & on_involutes], initial=0) / (2 * math.pi))


def cycloid_margin(
    *,
    ring_pins: int,
    circle_radius: float,
    pin_radius: float,
    eccentricity: float,
    difference: int = 1,
) -> float:
    """Smallest radius of curvature of the path of a ring pin in the disc, where it is convex, over
    the radius of the pin: below 1 the profile has a loop. 0 where there is no such disc, or the
    pins overlap. With a difference above 1 the path crosses itself, and every second lobe is cut.
    """
    turns = ring_pins / difference
    overlap = pin_radius >= circle_radius * math.sin(math.pi / ring_pins)
    if overlap or eccentricity * turns >= circle_radius:
        return 0.0
    t = np.linspace(0, 2 * math.pi / (turns - 1), 20_001)
    path = circle_radius * np.exp(-1j * t) - eccentricity * np.exp(-1j * turns * t)
    first, second = np.gradient(path, t), np.gradient(np.gradient(path, t), t)
    curvature = -(np.conj(first) * second).imag[2:-2] / np.abs(first[2:-2]) ** 3
    return 1 / (curvature.max() * pin_radius)
