"""Hertz line contact of a pin in its hole, and the conformal contact where Hertz fails.

Hertz replaces both bodies by half-planes, which asks for a contact much narrower than the pin.
A pin in a hole only a little larger is nearly conformal: the contact wraps around the pin, and
`core.conformal` takes over.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.arrays import (
    FloatArray,
    Number,
    atan,
    check_not_negative,
    check_positive,
    every,
    known_where,
    refuse,
    smaller,
    some,
    sqrt,
    where,
)
from core.conformal import (
    ERROR,
    conformal_contact,
    edge_tension,
    load_under_pressure,
    pressure_over_angle,
)
from core.errors import Accuracy, Notice, NotKnown, poorly_known, required
from core.materials import Body, ContactLimit, ElasticMaterial, effective_modulus, mismatch
from core.numerics.inverse import edge
from core.precision import ROUNDING

SHEAR_DEPTH = math.sqrt((math.sqrt(5) - 1) / 2)
"""Depth of the largest shear stress over the half-width, 0.786."""

SHEAR_RATIO = SHEAR_DEPTH * (1 - SHEAR_DEPTH**2)
"""Largest shear stress over the largest pressure, 0.300."""

HERTZ_TOLERANCE = 0.01
"""Excess of the conformal pressure over Hertz's from which it is given beside it, and governs."""

HALF_WIDTH_RATIO_LIMIT = 0.159
"""Half-width over pin radius at which Hertz is off by `HERTZ_TOLERANCE` (identical materials)."""

STRAIN_LIMIT = 0.02
"""Largest pressure over E* up to which strains are small."""


class BodySafety(NamedTuple):
    """One body of a contact, judged by the limit of its own material."""

    body: Body  # which one
    limit: ContactLimit  # of its contact pressure
    # Limit over the governing pressure: a ratio of pressures, so the load may grow with its square.
    # NaN in an array where it is not known.
    safety_factor: Number


class ContactArc(NamedTuple):
    """A contact that is wide for Hertz, along its arc."""

    pressure: Number  # largest, Pa
    half_angle: Number  # eps, half of the angle over which it extends, rad
    half_length: Number  # half of its length along the arc, m


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
    mismatch: tuple[Number, Number]  # Dundurs' alpha and beta, positive where the pin is stiffer
    conformity: Number  # w/(E*(R - r)) of the line load w: how closely pin and hole fit under it
    # Of the conformal contact, where it is wide enough to apply (see `hertz`):
    conformal_pressure: Number | None  # its largest pressure, Pa
    conformal_half_angle: Number | None  # eps, half of the angle over which it extends, rad
    conformal_half_angle_pin: Number | None  # the same seen from the pin's axis, rad
    conformal_half_angle_hole: Number | None  # and from the hole's axis, rad
    conformal_half_length: Number | None  # half of its length along the arc, m
    edge_tension: Number | None  # hoop tension in the hole's rim at its ends, Pa
    conformal_error: Number | None  # relative error of these by their method: 0 for beta = 0
    # The pressure to be judged, Pa: the conformal one where it applies, else Hertz's; NaN where it
    # is not known, as the contact would wrap around more than half of the pin.
    governing: Number
    safety: tuple[BodySafety, ...]  # bodies whose limit is known, under the governing pressure
    safety_factor: Number | None  # the smaller one of both bodies, where both are known
    accuracy: Accuracy

    @property
    def is_conformal(self) -> bool:
        """Whether the contact is wide enough for the conformal one to apply."""
        return self.conformal_pressure is not None

    @property
    def arc(self) -> ContactArc:
        """The contact along the arc, where it is wide enough to apply."""
        return ContactArc(
            required(self.conformal_pressure, "no_conformal_pressure"),
            required(self.conformal_half_angle, "no_conformal_pressure"),
            required(self.conformal_half_length, "no_conformal_pressure"),
        )

    @property
    def governing_pressure(self) -> Number:
        """The pressure to be judged, Pa, which has to be known of one contact."""
        if isinstance(self.governing, float) and math.isnan(self.governing):
            raise NotKnown("contact_wraps")
        return self.governing

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Limits of validity that one contact (not an array of them) strains."""
        unknown, strain = (
            poorly_known(self.accuracy),
            float(self.governing / self.effective_modulus),
        )
        if math.isnan(strain):
            return (Notice("contact_wraps"), *unknown)
        if strain > STRAIN_LIMIT:
            return (Notice("finite_strain", {"strain": strain}), *unknown)
        return unknown


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
    Contact Mechanics, 4.2. The conformal contact is given where its pressure lies more than
    `HERTZ_TOLERANCE` above Hertz's.

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
    constants = mismatch(first=pin_material, second=hole_material)
    reduced_radius = hole_radius / difference * pin_radius
    line_load = force / contact_length * dynamic_factor * distribution_factor
    max_pressure = _max_pressure(line_load, reduced_radius, modulus)
    half_width = 2 * sqrt(line_load / math.pi / modulus) * sqrt(reduced_radius)
    ratio = half_width / pin_radius

    wide = _NARROW | {"governing": max_pressure}
    method, evaluations = "closed_form", 1
    if some(line_load * narrow_load(constants[1]) > modulus * difference):
        wide, method, evaluations = _conformal(
            line_load, pin_radius, hole_radius, modulus, constants, hole_material.poissons_ratio
        )
    safety = _safety(wide["governing"], pin=pin_material, hole=hole_material)
    return HertzContact(
        max_pressure=max_pressure,
        mean_pressure=math.pi / 4 * max_pressure,
        half_width=half_width,
        half_width_ratio=ratio,
        max_shear=SHEAR_RATIO * max_pressure,
        max_shear_depth=SHEAR_DEPTH * half_width,
        reduced_radius=reduced_radius,
        effective_modulus=modulus,
        mismatch=constants,
        conformity=line_load / modulus / difference,
        **wide,
        safety=safety,
        safety_factor=(
            smaller(safety[0].safety_factor, safety[1].safety_factor) if len(safety) == 2 else None
        ),
        accuracy=Accuracy(
            method=method,
            # rho has the difference of two radii that are known to rounding
            relative_error=ROUNDING * (8 + (hole_radius + pin_radius) / difference),
            evaluations=evaluations,
        ),
    )


def narrow_load(beta: Number) -> Number:
    """Load parameter ``E* dR/Q`` above which the conformal pressure is within `HERTZ_TOLERANCE` of
    Hertz's: wider contacts have a smaller one.

    Parameters
    ----------
    beta : float or array
        Dundurs' beta.

    Returns
    -------
    float or array
        A bound for any alpha, by a line over the root of what is needed, which for alpha = 1 and
        beta = 0 is 57.9, for -1 and -1/2 777.4.
    """
    root = 7.65 - 41.0 * smaller(beta, 0.0)
    return root * root


def _max_pressure(line_load: Number, reduced_radius: Number, modulus: Number) -> Number:
    """Hertz's pressure in the middle."""
    return sqrt(line_load / reduced_radius) * sqrt(modulus / math.pi)


_NARROW = dict.fromkeys(
    (
        "conformal_pressure",
        "conformal_half_angle",
        "conformal_half_angle_pin",
        "conformal_half_angle_hole",
        "conformal_half_length",
        "edge_tension",
        "conformal_error",
    )
)


def _conformal(
    line_load: Number,
    pin_radius: Number,
    hole_radius: Number,
    modulus: Number,
    constants: tuple[Number, Number],
    poissons_ratio: Number,
) -> tuple[dict[str, Number | None], str, int]:
    """What a `HertzContact` has of the conformal contact, where that applies, and which pressure
    governs; the method and its steps.
    """
    alpha, beta = constants
    difference = hole_radius - pin_radius
    max_pressure = _max_pressure(line_load, hole_radius / difference * pin_radius, modulus)
    narrowest = modulus * difference / narrow_load(beta)
    near = line_load > narrowest
    load = where(near, line_load, narrowest)
    parameter = modulus * (difference / load)
    contact = conformal_contact(load_parameter=parameter, alpha=alpha, beta=beta)
    factor = contact.pressure / sqrt(parameter / math.pi)
    pressure = factor * max_pressure
    known = factor == factor
    applies = near & (factor > 1 + HERTZ_TOLERANCE)
    governing = where(known, where(applies, pressure, max_pressure), math.nan)
    if not some(applies):
        return _NARROW | {"governing": governing}, "closed_form", contact.evaluations
    radius, eps = sqrt(pin_radius * hole_radius), 2 * atan(contact.tangent)
    tension = edge_tension(
        mean_pressure=contact.mean_pressure,
        tangent=contact.tangent,
        poissons_ratio=poissons_ratio,
    )
    found = {
        "conformal_pressure": pressure,
        "conformal_half_angle": eps,
        "conformal_half_angle_pin": eps * sqrt(hole_radius / pin_radius),
        "conformal_half_angle_hole": eps * sqrt(pin_radius / hole_radius),
        "conformal_half_length": eps * radius,
        "edge_tension": tension * load / radius,
        "conformal_error": 2 * abs(beta) * ERROR,
    }
    found = {name: known_where(applies, each) for name, each in found.items()}
    method = "integral_equation" if some(beta != 0) else "closed_form_newton"
    return found | {"governing": governing}, method, contact.evaluations


def _safety(
    governing: Number, *, pin: ElasticMaterial, hole: ElasticMaterial
) -> tuple[BodySafety, ...]:
    """Each body by the limit of its own material, where the pressure and that are known."""
    if not some(governing > 0):
        return ()
    pressure = where(governing > 0, governing, math.nan)
    bodies: tuple[tuple[Body, ElasticMaterial], ...] = (("pin", pin), ("hole", hole))
    return tuple(
        BodySafety(body, limit, limit.allowable / pressure)
        for body, material in bodies
        if (limit := material.limit)
    )


def force_factor(
    *, contact: HertzContact, contact_at: Callable[[float], HertzContact], limit: float
) -> float:
    """Factor on the force at which the governing pressure of a contact is at a limit.

    Hertz's pressure grows with the root of the force, that of a conformal contact faster, up to
    the force itself; where it takes over, the governing pressure jumps by a per cent.

    Parameters
    ----------
    contact : HertzContact
        The contact, under a force.
    contact_at : callable
        The contact under so many times the force.
    limit : float
        The limit, Pa, > 0.

    Returns
    -------
    float
        That of the widest contact of which the pressure is known, where this is below the limit.

    Notes
    -----
    The load per length is the root of ``P/lambda = p*R_m/(E* dR)``, which grows with it.
    """
    ratio = float(limit / contact.max_pressure)
    by_hertz = ratio**2
    there = contact_at(by_hertz)
    if there.governing == there.max_pressure:
        return by_hertz
    alpha, beta = contact.mismatch
    parameter = load_under_pressure(
        pressure_parameter=ratio * math.sqrt(contact.conformity / math.pi), alpha=alpha, beta=beta
    )
    # not beyond the limit, or the widest contact, by the rounding of forces
    factor = float(1 / (parameter * contact.conformity)) * (1 - 512 * ROUNDING)
    if contact_at(factor).is_conformal:
        return factor

    def left(factor: float) -> float:
        return float(limit - contact_at(factor).governing)

    met, _ = edge(inside=factor, outside=by_hertz, excess=left)  # within the jump
    return met * (1 - 512 * ROUNDING)


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
    """Pressure of the conformal contact over its arc.

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
    NotKnown
        If the contact has no conformal pressure.
    """
    pressure, half_angle, half_length = contact.arc
    places = np.sin(np.linspace(-math.pi / 2, math.pi / 2, samples))
    shape = pressure_over_angle(
        angles=half_angle * places, tangent=math.tan(half_angle / 2), beta=contact.mismatch[1]
    )
    return half_length * places, pressure * shape
