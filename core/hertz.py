"""Hertz line contact of a pin in its hole, and the conformal contact where Hertz fails.

Hertz replaces both bodies by half-planes, which asks for a contact much narrower than the pin.
A pin in a hole only a little larger is nearly conformal: the contact wraps around the pin, and
Persson's solution for a disc in a hole of the same material takes over.
"""

import math
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.materials import ElasticMaterial, effective_modulus, lower_allowable_pressure
from core.results import ROUNDING, Accuracy, Notice

Either = TypeVar("Either", float, FloatArray)

SHEAR_DEPTH = math.sqrt((math.sqrt(5) - 1) / 2)
"""Depth of the largest shear stress over the half-width, 0.786."""

SHEAR_RATIO = SHEAR_DEPTH * (1 - SHEAR_DEPTH**2)
"""Largest shear stress over the largest pressure, 0.300."""

HERTZ_TOLERANCE = 0.01
"""Error of the Hertz pressure above which the conformal pressure is given beside it."""

HALF_WIDTH_RATIO_LIMIT = 0.159
"""Half-width over pin radius at which Hertz is off by `HERTZ_TOLERANCE` (identical materials)."""


@dataclass(frozen=True, slots=True)
class HertzContact:
    """Stress of the line contact of pin and hole.

    Attributes
    ----------
    max_pressure : float
        Hertz pressure p0 in the middle, Pa.
    mean_pressure : float
        Mean pressure ``pi/4*p0``, Pa.
    half_width : float
        Half-width a of the contact, m.
    half_width_ratio : float
        Half-width over pin radius a/r, dimensionless: Hertz asks for a/r << 1.
    max_shear : float
        Largest shear stress below the surface ``0.300*p0``, Pa.
    max_shear_depth : float
        Its depth ``0.786*a``, m.
    reduced_radius : float
        Reduced radius of curvature rho, m.
    effective_modulus : float
        Effective modulus E*, Pa.
    conformal_pressure : float or None
        Largest pressure of the conformal contact, Pa; None unless it applies (see `hertz`).
    conformal_half_angle : float or None
        Half of the angle over which the conformal contact extends, rad; None as before.
    safety_factor : float or None
        Smaller allowable pressure over the largest pressure (the conformal one where it
        applies); None where no allowable pressure is known, or no theory gives the pressure.
    accuracy : Accuracy
        Of the pressures.
    notices : tuple of Notice
        Limits of validity that the contact strains.
    """

    max_pressure: float
    mean_pressure: float
    half_width: float
    half_width_ratio: float
    max_shear: float
    max_shear_depth: float
    reduced_radius: float
    effective_modulus: float
    conformal_pressure: float | None
    conformal_half_angle: float | None
    safety_factor: float | None
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def hertz(
    *,
    force: float,
    contact_length: float,
    pin_radius: float,
    hole_radius: float,
    pin_material: ElasticMaterial,
    hole_material: ElasticMaterial,
    dynamic_factor: float = 1.0,
    distribution_factor: float = 1.0,
) -> HertzContact:
    """Line contact of a pin in a hole.

    ``w = F/b*K_A*K_alpha``, ``rho = R*r/(R - r)``, ``p0 = sqrt(w*E*/(pi*rho))``,
    ``a = sqrt(4*w*rho/(pi*E*))``.

    Parameters
    ----------
    force : float
        Contact force F, N, >= 0.
    contact_length : float
        Length b of the contact along the pin, m.
    pin_radius : float
        Radius r of the pin, m.
    hole_radius : float
        Radius R of the hole, m, larger than `pin_radius`.
    pin_material, hole_material : ElasticMaterial
        Materials of pin and satellite.
    dynamic_factor : float
        Factor K_A of the dynamic load, > 0.
    distribution_factor : float
        Factor K_alpha of uneven load sharing between the pairs, > 0.

    Returns
    -------
    HertzContact

    Raises
    ------
    InvalidInput
        If a length or factor is not positive, the force negative, or the hole not larger than
        the pin: a pin that fills its hole has no line contact.

    Notes
    -----
    Source: Yanchevsky et al. 2018, eq. (2); half-width, mean pressure and shear: Johnson,
    Contact Mechanics, 4.2. The conformal pressure (identical materials, R - r << r) is given
    where it differs from Hertz by more than `HERTZ_TOLERANCE`; see `conformal_pressure_ratio`.

    Examples
    --------
    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> contact = hertz(force=1000.0, contact_length=0.02, pin_radius=0.006, hole_radius=0.008,
    ...                 pin_material=steel, hole_material=steel)
    >>> round(contact.max_pressure/1e6, 3)
    276.617
    """
    if not force >= 0:
        raise InvalidInput("force", force, "must not be negative")
    for name, value in (
        ("contact_length", contact_length),
        ("pin_radius", pin_radius),
        ("dynamic_factor", dynamic_factor),
        ("distribution_factor", distribution_factor),
    ):
        if not value > 0:
            raise InvalidInput(name, value, "must be larger than 0")
    if not hole_radius > pin_radius:
        raise InvalidInput("hole_radius", hole_radius, "must be larger than {pin_radius}")
    modulus = effective_modulus(first=pin_material, second=hole_material)
    difference = hole_radius - pin_radius
    reduced_radius = hole_radius / difference * pin_radius
    line_load = force / contact_length * dynamic_factor * distribution_factor
    max_pressure, half_width = narrow_contact(
        line_load=line_load, reduced_radius=reduced_radius, modulus=modulus
    )
    ratio = half_width / pin_radius

    conformal = half_angle = None
    evaluations = 1
    if line_load > 0 and _identical(pin_material, hole_material):
        load_parameter = pin_material.plane_modulus * (difference / line_load)
        factor, tangent, evaluations = conformal_pressure_ratio(load_parameter=load_parameter)
        if abs(factor - 1) > HERTZ_TOLERANCE:
            conformal = factor * max_pressure
            half_angle = 2 * math.atan(tangent)
    governing = max_pressure if conformal is None else conformal
    allowable = lower_allowable_pressure(pin_material, hole_material)
    if conformal is None and ratio > 1:
        allowable = None  # no pressure to compare with: Hertz's is none here
    return HertzContact(
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
        safety_factor=allowable / governing if allowable and governing > 0 else None,
        accuracy=Accuracy(
            method="closed form" if conformal is None else "closed form, Newton's method",
            relative_error=rounding_error(pin_radius=pin_radius, hole_radius=hole_radius),
            evaluations=evaluations,
        ),
        notices=validity(half_width_ratio=ratio, conformal=conformal is not None),
    )


def narrow_contact(
    *, line_load: Either, reduced_radius: Either, modulus: Either
) -> tuple[Either, Either]:
    """Largest pressure and half-width of a Hertz line contact.

    Parameters
    ----------
    line_load : float or array
        Load per length w, N/m.
    reduced_radius : float or array
        Reduced radius of curvature rho, m.
    modulus : float or array
        Effective modulus E*, Pa.

    Returns
    -------
    max_pressure, half_width : float or array
        ``sqrt(w*E*/(pi*rho))``, Pa, and ``sqrt(4*w*rho/(pi*E*))``, m.
    """
    sqrt = _functions(line_load).sqrt
    return (
        sqrt(line_load / reduced_radius) * sqrt(modulus / math.pi),
        2 * sqrt(line_load / math.pi / modulus) * sqrt(reduced_radius),
    )


def rounding_error(*, pin_radius: Either, hole_radius: Either) -> Either:
    """Relative error of the pressures.

    Parameters
    ----------
    pin_radius, hole_radius : float or array
        Radii r and R, m: known to rounding; their difference magnifies that.

    Returns
    -------
    float or array
        Dimensionless.
    """
    return ROUNDING * (8 + (hole_radius + pin_radius) / (2 * (hole_radius - pin_radius)))


def _functions(value: object) -> Any:
    """The module of functions for a number or an array."""
    return np if isinstance(value, np.ndarray) else math


def _identical(first: ElasticMaterial, second: ElasticMaterial) -> bool:
    return (
        first.youngs_modulus == second.youngs_modulus
        and first.poissons_ratio == second.poissons_ratio
    )


def validity(*, half_width_ratio: float, conformal: bool) -> tuple[Notice, ...]:
    """Limits of validity that a contact strains.

    Parameters
    ----------
    half_width_ratio : float
        Half-width over the pin's radius a/r.
    conformal : bool
        Whether its conformal pressure is given.

    Returns
    -------
    tuple of Notice
    """
    ratio = half_width_ratio
    if ratio <= HALF_WIDTH_RATIO_LIMIT:
        return ()
    if conformal:
        cure = "use {conformal_pressure}"
    elif ratio <= 1:
        cure = "no conformal solution is known for different materials: take it as a rough guide"
    else:
        cure = "wider than the pin, it does not apply at all, and for different materials no "
        cure += "conformal solution is known: make the hole larger or the load smaller"
    return (
        Notice(
            code="hertz_half_width" if conformal or ratio <= 1 else "hertz_impossible",
            detail=f"The contact is {2 * ratio:.3g} times as wide as the pin's radius; Hertz "
            f"assumes a narrow contact and is off by more than 1 %: {cure}.",
            value=ratio,
            limit=HALF_WIDTH_RATIO_LIMIT,
        ),
    )


def conformal_half_angle_tangent(*, load_parameter: float) -> tuple[float, int]:
    """Tangent ``b = tan(eps/2)`` of half the half-angle of a conformal contact.

    Solves ``E1**dR/Q = (2 - ln(b^2 + 1) - 2*b^4)/(pi*b^2*(b^2 + 1))``.

    Parameters
    ----------
    load_parameter : float
        ``E1**dR/Q``, dimensionless, >= 0: plane-strain modulus E/(1 - v^2) of one body times the
        difference of the radii, over the load per length.

    Returns
    -------
    b : float
        Tangent of a quarter of the angle of the contact, dimensionless.
    iterations : int
        Newton steps taken.

    Notes
    -----
    Source: Persson 1964, On the stress distribution of cylindrical elastic bodies in contact;
    identical materials. In y = b^2 the equation is concave and falling, so that Newton's method
    from the Hertz value (or from the limit of no clearance, whichever is smaller) converges
    from one side.
    """
    y = min(0.84, 2 / (math.pi * load_parameter)) if load_parameter > 0 else 0.84
    step, iterations = y, 0
    while abs(step) > 2 * ROUNDING * y and iterations < 60:
        step = newton_step(square=y, load_parameter=load_parameter)
        y -= step
        iterations += 1
    return math.sqrt(y), iterations


def newton_step(*, square: Either, load_parameter: Either) -> Either:
    """Newton's step of the equation of `conformal_half_angle_tangent` in ``y = b^2``.

    Parameters
    ----------
    square : float or array
        ``b^2``.
    load_parameter : float or array
        ``E1**dR/Q``, dimensionless.

    Returns
    -------
    float or array
        What to take off the square.
    """
    y = square
    logarithm = _functions(y).log1p(y)
    value = 2 - logarithm - 2 * y * y - load_parameter * math.pi * y * (1 + y)
    slope = -1 / (1 + y) - 4 * y - load_parameter * math.pi * (1 + 2 * y)
    step: Either = value / slope
    return step


def conformal_pressure_ratio(*, load_parameter: float) -> tuple[float, float, int]:
    """Largest pressure of a conformal contact over the Hertz pressure of the same load.

    Parameters
    ----------
    load_parameter : float
        ``E1**dR/Q``, dimensionless, > 0, as in `conformal_half_angle_tangent`.

    Returns
    -------
    ratio : float
        Dimensionless; 1 in the Hertz limit of a large `load_parameter`.
    half_angle_tangent : float
        ``b = tan(eps/2)`` of the contact.
    iterations : int
        Newton steps taken.

    Notes
    -----
    Source: Persson 1964. The Hertz pressure of the same contact is
    ``Q/R*sqrt(E1**dR/Q/(2*pi))``.

    Examples
    --------
    >>> round(conformal_pressure_ratio(load_parameter=1e6)[0], 5)
    1.0
    """
    b, iterations = conformal_half_angle_tangent(load_parameter=load_parameter)
    return middle_over_hertz(half_angle_tangent=b, load_parameter=load_parameter), b, iterations


def middle_over_hertz(*, half_angle_tangent: Either, load_parameter: Either) -> Either:
    """Pressure in the middle of a conformal contact over the Hertz pressure of the same load.

    Parameters
    ----------
    half_angle_tangent : float or array
        ``b = tan(eps/2)``, > 0.
    load_parameter : float or array
        ``E1**dR/Q``, dimensionless, that it belongs to.

    Returns
    -------
    float or array
        Dimensionless.
    """
    sqrt = _functions(load_parameter).sqrt
    middle = conformal_pressure(
        position=0.0 * half_angle_tangent, half_angle_tangent=half_angle_tangent
    )
    ratio: Either = middle / sqrt(load_parameter / (2 * math.pi))
    return ratio


def conformal_pressure(*, position: Either, half_angle_tangent: Either) -> Either:
    """Pressure of a conformal contact, over Q/R.

    Parameters
    ----------
    position : float or array
        ``y = tan(angle/2)`` of the place on the pin, from 0 in the middle to b at the end.
    half_angle_tangent : float or array
        ``b = tan(eps/2)``, > 0.

    Returns
    -------
    float or array
        ``p*R/Q``, dimensionless.

    Notes
    -----
    Source: Persson 1964; Ciavarella and Decuzzi 2001, The state of stress induced by the plane
    frictionless cylindrical contact, I, identical materials.
    """
    b, y, functions = half_angle_tangent, position, _functions(half_angle_tangent)
    inner = functions.sqrt((b - y) * (b + y))
    outer = functions.hypot(b, 1.0)
    logarithm = 2 * functions.atanh(inner / outer)
    pressure: Either = 2 * inner / (math.pi * outer * (1 + y * y)) + logarithm / (
        2 * math.pi * b * b * outer * outer
    )
    return pressure


def pressure_profile(*, contact: HertzContact, samples: int = 81) -> tuple[FloatArray, FloatArray]:
    """Hertz pressure over the width of the contact: ``p0*sqrt(1 - (x/a)^2)``.

    Parameters
    ----------
    contact : HertzContact
        The contact.
    samples : int
        Either of places, at least 2.

    Returns
    -------
    x, pressure : array, shape (samples,)
        Places across the contact, m, and pressure there, Pa.
    """
    angle = np.linspace(-math.pi / 2, math.pi / 2, samples)
    return contact.half_width * np.sin(angle), contact.max_pressure * np.cos(angle)


def conformal_profile(*, contact: HertzContact, samples: int = 81) -> tuple[FloatArray, FloatArray]:
    """Pressure of the conformal contact over the arc of the pin.

    Parameters
    ----------
    contact : HertzContact
        A contact to which the conformal pressure applies.
    samples : int
        Either of places, at least 2.

    Returns
    -------
    arc, pressure : array, shape (samples,)
        Places along the arc, m, and pressure there, Pa.

    Raises
    ------
    InvalidInput
        If the contact has no conformal pressure.
    """
    if contact.conformal_pressure is None or contact.conformal_half_angle is None:
        raise InvalidInput("contact", contact, "must have a conformal pressure")
    tangent = math.tan(contact.conformal_half_angle / 2)
    middle = conformal_pressure(position=0.0, half_angle_tangent=tangent)
    angles = contact.conformal_half_angle * np.sin(np.linspace(-math.pi / 2, math.pi / 2, samples))
    pressures = [
        conformal_pressure(
            position=min(abs(math.tan(angle / 2)), tangent), half_angle_tangent=tangent
        )
        for angle in angles
    ]
    radius = contact.half_width / contact.half_width_ratio
    return radius * angles, contact.conformal_pressure / middle * np.array(pressures)
