"""Line contact of pin and hole for arrays of designs; see `core.hertz` for the formulas."""

import math
from dataclasses import dataclass

import numpy as np

from core.contact_force import FloatArray, IntArray
from core.designs.checks import check_not_negative, check_positive, first_where
from core.errors import InvalidInput
from core.hertz import (
    HERTZ_TOLERANCE,
    SHEAR_DEPTH,
    SHEAR_RATIO,
    middle_over_hertz,
    narrow_contact,
    newton_step,
    rounding_error,
)
from core.results import ROUNDING


@dataclass(frozen=True, slots=True)
class Solids:
    """Elastic materials of one of the bodies, arrays of shape (n,).

    Attributes
    ----------
    youngs_modulus : array
        Young's modulus E, Pa.
    poissons_ratio : array
        Poisson's ratio, dimensionless.
    allowable_pressure : array
        Allowable contact pressure, Pa; NaN where none is known.
    """

    youngs_modulus: FloatArray
    poissons_ratio: FloatArray
    allowable_pressure: FloatArray

    @property
    def plane_modulus(self) -> FloatArray:
        """Modulus in plane strain ``E/(1 - v^2)``, Pa."""
        return self.youngs_modulus / ((1 - self.poissons_ratio) * (1 + self.poissons_ratio))


@dataclass(frozen=True, slots=True)
class HertzContacts:
    """Stress of the line contacts, arrays of shape (n,).

    Attributes
    ----------
    max_pressure, mean_pressure : array
        Hertz pressure p0 in the middle and ``pi/4*p0``, Pa.
    half_width, half_width_ratio : array
        Half-width a, m, and a/r, dimensionless.
    max_shear, max_shear_depth : array
        ``0.300*p0``, Pa, and its depth ``0.786*a``, m.
    reduced_radius, effective_modulus : array
        rho, m, and E*, Pa.
    conformal_pressure, conformal_half_angle : array
        Largest pressure of the conformal contact, Pa, and its half-angle, rad; NaN where it does
        not apply.
    safety_factor : array
        Smaller allowable pressure over the largest; NaN where one of them is not known.
    relative_error : array
        Of the pressures.
    evaluations : array of int
        1, or the steps of Newton's method.
    """

    max_pressure: FloatArray
    mean_pressure: FloatArray
    half_width: FloatArray
    half_width_ratio: FloatArray
    max_shear: FloatArray
    max_shear_depth: FloatArray
    reduced_radius: FloatArray
    effective_modulus: FloatArray
    conformal_pressure: FloatArray
    conformal_half_angle: FloatArray
    safety_factor: FloatArray
    relative_error: FloatArray
    evaluations: IntArray


def hertz_contacts(
    *,
    force: FloatArray,
    contact_length: FloatArray,
    pin_radius: FloatArray,
    hole_radius: FloatArray,
    pin_material: Solids,
    hole_material: Solids,
    dynamic_factor: FloatArray,
    distribution_factor: FloatArray,
) -> HertzContacts:
    """Line contacts of pins in holes.

    Parameters
    ----------
    force : array, shape (n,)
        Contact force F, N, >= 0.
    contact_length, pin_radius, hole_radius : array, shape (n,)
        Length b of the contact and radii r and R of pin and hole, m; the hole is the larger.
    pin_material, hole_material : Solids
        Materials of pin and satellite.
    dynamic_factor, distribution_factor : array, shape (n,)
        Factors K_A and K_alpha, > 0.

    Returns
    -------
    HertzContacts

    Raises
    ------
    InvalidInput
        If an entry is out of range; its index is named.

    Notes
    -----
    Source: as `core.hertz.hertz`.

    Examples
    --------
    >>> steel = Solids(*(np.array([each]) for each in (210e9, 0.3, np.nan)))
    >>> one = np.ones(1)
    >>> contacts = hertz_contacts(force=1000*one, contact_length=0.02*one, pin_radius=0.006*one,
    ...     hole_radius=0.008*one, pin_material=steel, hole_material=steel,
    ...     dynamic_factor=one, distribution_factor=one)
    >>> (contacts.max_pressure/1e6).round(3).tolist()
    [276.617]
    """
    check_not_negative(force=force)
    check_positive(
        contact_length=contact_length,
        pin_radius=pin_radius,
        dynamic_factor=dynamic_factor,
        distribution_factor=distribution_factor,
    )
    if (index := first_where(~(hole_radius > pin_radius))) is not None:
        raise InvalidInput(
            f"hole_radius[{index}]", hole_radius[index], "must be larger than {pin_radius}"
        )
    modulus = 1 / (1 / pin_material.plane_modulus + 1 / hole_material.plane_modulus)
    difference = hole_radius - pin_radius
    reduced_radius = hole_radius / difference * pin_radius
    line_load = force / contact_length * dynamic_factor * distribution_factor
    max_pressure, half_width = narrow_contact(
        line_load=line_load, reduced_radius=reduced_radius, modulus=modulus
    )
    ratio = half_width / pin_radius
    identical = (pin_material.youngs_modulus == hole_material.youngs_modulus) & (
        pin_material.poissons_ratio == hole_material.poissons_ratio
    )
    conformal, half_angle, evaluations = _conformal(
        np.flatnonzero(identical & (line_load > 0)),
        max_pressure,
        pin_material.plane_modulus * difference / np.where(line_load > 0, line_load, 1.0),
    )
    governing = np.where(np.isnan(conformal), max_pressure, conformal)
    allowable = np.fmin(pin_material.allowable_pressure, hole_material.allowable_pressure)
    known = ~((ratio > 1) & np.isnan(conformal)) & (governing > 0)
    return HertzContacts(
        max_pressure=max_pressure,
        mean_pressure=math.pi / 4 * max_pressure,
        half_width=half_width,
        half_width_ratio=ratio,
        max_shear=SHEAR_RATIO * max_pressure,
        max_shear_depth=SHEAR_DEPTH * half_width,
        reduced_radius=reduced_radius,
        effective_modulus=modulus,
        conformal_pressure=conformal,
        conformal_half_angle=half_angle,
        safety_factor=np.divide(allowable, governing, out=np.full(len(force), np.nan), where=known),
        relative_error=rounding_error(pin_radius=pin_radius, hole_radius=hole_radius),
        evaluations=evaluations,
    )


def _conformal(
    rows: IntArray, max_pressure: FloatArray, load_parameter: FloatArray
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Conformal pressure and half-angle of some designs, where they differ from Hertz; steps."""
    conformal = np.full(len(max_pressure), np.nan)
    half_angle = conformal.copy()
    steps = np.ones(len(max_pressure), dtype=np.intp)
    if not len(rows):
        return conformal, half_angle, steps
    parameter = load_parameter[rows]
    y = np.fmin(0.84, 2 / (math.pi * parameter))
    taken, going = np.zeros(len(rows), dtype=np.intp), np.arange(len(rows))
    for _ in range(60):
        step = newton_step(square=y[going], load_parameter=parameter[going])
        y[going] -= step
        taken[going] += 1
        going = going[np.abs(step) > 2 * ROUNDING * y[going]]
        if not len(going):
            break
    tangent = np.sqrt(y)
    factor = middle_over_hertz(half_angle_tangent=tangent, load_parameter=parameter)
    apart = np.abs(factor - 1) > HERTZ_TOLERANCE
    conformal[rows[apart]] = (factor * max_pressure[rows])[apart]
    half_angle[rows[apart]] = 2 * np.atan(tangent[apart])
    steps[rows] = taken
    return conformal, half_angle, steps
