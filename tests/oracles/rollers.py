"""Swinging rollers: compliance and load sharing from their definitions."""

from typing import Any

from mpmath import mp, mpf


def exact_compliance(case: dict[str, Any]) -> mpf:
    """P3 (8) for a unit force: bending, shear, and the end's rotation over b/2."""
    length, width, sphere, d, k, e = (
        mpf(case[name])
        for name in (
            "cylinder_length",
            "sphere_width",
            "sphere_diameter",
            "diameter",
            "friction_coefficient",
            "youngs_modulus",
        )
    )
    shear_modulus = e / (2 * (1 + mpf(case["poissons_ratio"])))
    rigidity = e * mp.pi * d**4 / 64
    end_moment = (k * sphere + width) / 2
    shear_angle = mpf("1.11") / (shear_modulus * mp.pi * d**2 / 4)
    sag = end_moment * length**2 / (2 * rigidity) + length**3 / (3 * rigidity)
    rotation = (end_moment * length + length**2 / 2) / rigidity + shear_angle
    return sag + shear_angle * length + rotation * width / 2


def exact_forces(total: mpf, stiffness: mpf, gaps: list[mpf]) -> list[mpf]:
    """Bisection on the number of closed contacts, in any order: the definition itself."""
    order = sorted(gaps)
    for closed in range(len(gaps), 0, -1):
        displacement = (total / stiffness + mp.fsum(order[:closed])) / closed
        if displacement > order[closed - 1] or closed == 1:
            return [stiffness * max(mpf(0), displacement - gap) for gap in gaps]
    raise AssertionError
