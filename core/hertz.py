"""Hertz line contact of a pin in its hole, and the conformal contact where Hertz fails.

Hertz replaces both bodies by half-planes, which asks for a contact much narrower than the pin.
A pin in a hole only a little larger is nearly conformal: the contact wraps around the pin, and
Persson's solution for a disc in a hole of the same material takes over.
"""

import math
from typing import Any, Literal, NamedTuple

import numpy as np

from core.arrays import (
    FloatArray,
    Number,
    atan,
    atanh,
    check_not_negative,
    check_positive,
    every,
    known_where,
    larger,
    log1p,
    refuse,
    smaller,
    some,
    sqrt,
    where,
)
from core.errors import InvalidInput
from core.materials import ContactLimit, ElasticMaterial, effective_modulus, mismatch
from core.precision import ROUNDING
from core.results import Accuracy, Notice, poorly_known

SHEAR_DEPTH = math.sqrt((math.sqrt(5) - 1) / 2)
"""Depth of the largest shear stress over the half-width, 0.786."""

SHEAR_RATIO = SHEAR_DEPTH * (1 - SHEAR_DEPTH**2)
"""Largest shear stress over the largest pressure, 0.300."""

HERTZ_TOLERANCE = 0.01
"""Error of the Hertz pressure above which the conformal pressure is given beside it."""

CONFORMAL_LOAD = 100.38207120009
"""Load parameter ``E1**dR/Q`` at which Persson's pressure (1964) is by just that above Hertz's:
root found at 40 digits. Smaller loads have a larger one, and are off by less."""

HALF_WIDTH_RATIO_LIMIT = 0.159
"""Half-width over pin radius at which Hertz is off by `HERTZ_TOLERANCE` (identical materials)."""

MISMATCH_TOLERANCE = 0.05
"""Error of the conformal pressure by different materials up to which it is given: that of steel and
bronze, not that of steel and plastic."""

MISMATCH_SHARES = (0.07, 0.25)
"""Bounds of the relative change of the conformal pressure over Dundurs' alpha and beta, at any
width of the contact, by a series solution of disc and hole (see the tests)."""


class BodySafety(NamedTuple):
    """One body of a contact, judged by the limit of its own material."""

    body: Literal["pin", "hole"]  # which one
    limit: ContactLimit  # of its contact pressure
    # Limit over the governing pressure: a ratio of pressures, so the load may grow with its square.
    # NaN in an array where it is not known.
    safety_factor: Number


class HertzContact(NamedTuple):
    """Stress of the line contact of pin and hole, or of an array of them.

    What does not apply or is not known is None; in an array it is NaN, or None where it is so
    for all.
    """

    max_pressure: Number  # Hertz pressure p0 in the middle, Pa
    mean_pressure: Number  # pi/4*p0, Pa
    half_width: Number  # a of the contact, m
    half_width_ratio: Number  # a/r, r the pin radius: Hertz asks for a/r << 1
    max_shear: Number  # largest shear stress below the surface, 0.300*p0, Pa
    max_shear_depth: Number  # 0.786*a, m
    reduced_radius: Number  # rho of the curvatures, m
    effective_modulus: Number  # E*, Pa
    # Largest pressure of the conformal contact, Pa, where it applies (see `hertz`).
    conformal_pressure: Number | None
    conformal_half_angle: Number | None  # half of the angle over which that contact extends, rad
    # Bound of the relative error of the conformal pressure by the difference of the two materials:
    # 0 for identical ones.
    conformal_error: Number | None
    # The pressure to be judged, Pa: the conformal one where it applies, else Hertz's; not known
    # where neither theory holds.
    governing_pressure: Number | None
    safety: tuple[BodySafety, ...]  # bodies whose limit is known, under the governing pressure
    safety_factor: Number | None  # the smaller one of both bodies, where both are known
    accuracy: Accuracy

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Limits of validity that one contact (not an array of them) strains."""
        ratio = self.half_width_ratio
        unknown = poorly_known(self.accuracy)
        if ratio <= HALF_WIDTH_RATIO_LIMIT:
            return unknown
        possible = self.conformal_pressure is not None or ratio <= 1
        code = "contact_conformity" if possible else "hertz_impossible"
        return (Notice(code, {"ratio": float(ratio)}), *unknown)


def hertz(
    *,
    force: Number,
    contact_length: Number,
    pin_radius: Number,
    hole_radius: Number,
    pin_material: ElasticMaterial,
    hole_material: ElasticMaterial,
    dynamic_factor: Number = 1.0,
    distribution_factor: Number = 1.0,
) -> HertzContact:
    """Line contact of a pin in a hole; of arrays, one in each place.

    ``w = F/b*K_A*K_alpha``, ``rho = R*r/(R - r)``, ``p0 = sqrt(w*E*/(pi*rho))``,
    ``a = sqrt(4*w*rho/(pi*E*))``.

    Parameters
    ----------
    force : float or array
        Contact force F, N, >= 0.
    contact_length : float or array
        Length b of the contact along the pin, m.
    pin_radius : float or array
        Radius r of the pin, m.
    hole_radius : float or array
        Radius R of the hole, m, larger than `pin_radius`.
    pin_material, hole_material : ElasticMaterial
        Materials of pin and satellite.
    dynamic_factor : float or array
        Factor K_A of the dynamic load, > 0.
    distribution_factor : float or array
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
    Contact Mechanics, 4.2. The conformal pressure (R - r << r) is given where it differs from
    Hertz by more than `HERTZ_TOLERANCE`; see `conformal_pressure_ratio`. It is that of identical
    materials with twice the effective modulus; other materials change it by less than
    `MISMATCH_SHARES` of Dundurs' constants.

    Examples
    --------
    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> contact = hertz(force=1000.0, contact_length=0.02, pin_radius=0.006, hole_radius=0.008,
    ...                 pin_material=steel, hole_material=steel)
    >>> round(contact.max_pressure/1e6, 3)
    276.617
    """
    check_not_negative(force=force)
    check_positive(
        contact_length=contact_length,
        pin_radius=pin_radius,
        dynamic_factor=dynamic_factor,
        distribution_factor=distribution_factor,
    )
    difference = hole_radius - pin_radius
    if not every(difference > 0):
        than = {"field": "pin_radius", "limit": pin_radius}
        refuse("hole_radius", hole_radius, difference > 0, "larger_than", **than)

    modulus = effective_modulus(first=pin_material, second=hole_material)
    reduced_radius = hole_radius / difference * pin_radius
    line_load = force / contact_length * dynamic_factor * distribution_factor
    max_pressure = sqrt(line_load / reduced_radius) * sqrt(modulus / math.pi)
    half_width = 2 * sqrt(line_load / math.pi / modulus) * sqrt(reduced_radius)
    ratio = half_width / pin_radius

    conformal = half_angle = conformal_error = None
    governing, known, evaluations = max_pressure, ratio <= 1, 1
    applies = line_load / (2 * modulus) * CONFORMAL_LOAD > difference
    if some(applies):
        mismatch_error = _mismatch_error(pin_material, hole_material)
        applies = applies & (mismatch_error <= MISMATCH_TOLERANCE)
        if some(applies):
            load = where(applies, line_load, 1.0)
            factor, tangent, evaluations = conformal_pressure_ratio(
                load_parameter=2 * modulus * (difference / load)
            )
            conformal = known_where(applies, factor * max_pressure)
            half_angle = known_where(applies, 2 * atan(tangent))
            conformal_error = known_where(applies, mismatch_error)
            governing, known = where(applies, conformal, max_pressure), known | applies
    governing = known_where(known, governing)
    safety = _safety(governing, pin=pin_material.limit, hole=hole_material.limit)
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
        conformal_error=conformal_error,
        governing_pressure=governing,
        safety=safety,
        safety_factor=(
            smaller(safety[0].safety_factor, safety[1].safety_factor) if len(safety) == 2 else None
        ),
        accuracy=Accuracy(
            method="closed_form" if conformal is None else "closed_form_newton",
            # rho has the difference of two radii that are known to rounding
            relative_error=ROUNDING * (8 + (hole_radius + pin_radius) / difference),
            evaluations=evaluations,
        ),
    )


def _mismatch_error(first: ElasticMaterial, second: ElasticMaterial) -> Any:
    """Bound of the error of Persson's pressure by the difference of two materials."""
    alpha, beta = mismatch(first=first, second=second)
    return MISMATCH_SHARES[0] * abs(alpha) + MISMATCH_SHARES[1] * abs(beta)


def _safety(
    governing: Number | None, *, pin: ContactLimit | None, hole: ContactLimit | None
) -> tuple[BodySafety, ...]:
    """Each body by its own limit; none where the pressure is not known, or there is none."""
    if governing is None or not some(governing > 0):
        return ()
    pressure = where(governing > 0, governing, math.nan)
    found = []
    if pin is not None:
        found.append(BodySafety("pin", pin, pin.allowable / pressure))
    if hole is not None:
        found.append(BodySafety("hole", hole, hole.allowable / pressure))
    return tuple(found)


def conformal_half_angle_tangent(*, load_parameter: Number) -> tuple[Number, int]:
    """Tangent ``b = tan(eps/2)`` of half the half-angle of a conformal contact.

    Solves ``E1**dR/Q = (2 - ln(b^2 + 1) - 2*b^4)/(pi*b^2*(b^2 + 1))``.

    Parameters
    ----------
    load_parameter : float or array
        ``E1**dR/Q``, dimensionless, >= 0: plane-strain modulus E/(1 - v^2) of one body times the
        difference of the radii, over the load per length.

    Returns
    -------
    b : float or array
        Tangent of a quarter of the angle of the contact, dimensionless.
    iterations : int
        Newton steps taken, of an array by the slowest.

    Notes
    -----
    Source: Persson 1964, On the stress distribution of cylindrical elastic bodies in contact;
    identical materials. In y = b^2 the equation is concave and falling, so that Newton's method
    from the Hertz value (or from the limit of no clearance, whichever is smaller) converges
    from one side.
    """
    load = math.pi * load_parameter
    y = 2 / larger(load, 2 / 0.84)
    iterations = 0
    while iterations < 60:
        value = 2 - log1p(y) - 2 * y * y - load * y * (1 + y)
        slope = -1 / (1 + y) - 4 * y - load * (1 + 2 * y)
        step = value / slope
        y = y - step
        iterations += 1
        if every(abs(step) <= 2 * ROUNDING * y):
            break
    return sqrt(y), iterations


def conformal_pressure_ratio(*, load_parameter: Number) -> tuple[Number, Number, int]:
    """Largest pressure of a conformal contact over the Hertz pressure of the same load.

    Parameters
    ----------
    load_parameter : float or array
        ``E1**dR/Q``, dimensionless, > 0, as in `conformal_half_angle_tangent`.

    Returns
    -------
    ratio : float or array
        Dimensionless; 1 in the Hertz limit of a large `load_parameter`.
    half_angle_tangent : float or array
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
    middle = conformal_pressure(position=0.0 * b, half_angle_tangent=b)
    return middle / sqrt(load_parameter / (2 * math.pi)), b, iterations


def conformal_pressure(*, position: Number, half_angle_tangent: Number) -> Number:
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
    b, y = half_angle_tangent, position
    inner, outer = sqrt((b - y) * (b + y)), sqrt(1 + b * b)
    ends = 2 * inner / (math.pi * outer * (1 + y * y))
    return ends + atanh(inner / outer) / (math.pi * b * b * outer * outer)


def pressure_profile(*, contact: HertzContact, samples: int = 81) -> tuple[FloatArray, FloatArray]:
    """Hertz pressure over the width of the contact: ``p0*sqrt(1 - (x/a)^2)``.

    Parameters
    ----------
    contact : HertzContact
        The contact.
    samples : int
        Number of places, at least 2.

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
        Number of places, at least 2.

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
        raise InvalidInput("contact", contact, "no_conformal_pressure")
    angles = contact.conformal_half_angle * np.sin(np.linspace(-math.pi / 2, math.pi / 2, samples))
    places = np.tan(np.abs(angles) / 2)
    end = places[0]
    shape = conformal_pressure(position=places, half_angle_tangent=end)
    middle = conformal_pressure(position=0.0, half_angle_tangent=end)
    radius = contact.half_width / contact.half_width_ratio
    return radius * angles, contact.conformal_pressure / middle * shape
