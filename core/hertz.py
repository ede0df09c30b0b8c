"""Elastic bodies in line contact: their materials and what two of them make together; Hertz's
pressure of a pin in its hole against its limits, and the conformal one where Hertz fails; by which
pressure a sliding contact first yields, and shakes down.

Hertz replaces both bodies by half-planes, which asks for a contact much narrower than the pin.
A pin in a hole only a little larger is nearly conformal: the contact wraps around the pin, and
`core.conformal` takes over. Hertz's pressure and its friction ``q = mu*p`` stress a half-plane in
plane strain. Without friction it yields first below the surface; from a friction of some 0.3 on at
the surface, under less.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal, NamedTuple, Self

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
from core.contact_life import MOST_LOADS, LifeCurve, life_factor
from core.errors import Accuracy, Notice, NotKnown, if_known, poorly_known, required
from core.numerics.inverse import edge
from core.precision import ROUNDING

Criterion = Literal["endurance", "endurance_mean", "static", "given"]
"""What a limit of the contact pressure guards against: pitting in the long run (judged by the mean
pressure of a mesh: then the largest one is on the safe side), a permanent set under a load at rest,
or what whoever gave it has in mind."""

CRITERIA: dict[Criterion, str] = {
    "endurance": "endurance",
    "endurance_mean": "endurance, mean pressure",
    "static": "static",
    "given": "given",
}
"""The same in English."""

Verified = Literal["standard", "secondary"]
"""Whether a value was read in its standard, or in two independent secondary sources."""

VERIFIED: dict[Verified, str] = {
    "standard": "standard",
    "secondary": "secondary sources",
}
"""The same in English."""

FIRST_YIELD = 1.79
"""Largest pressure at first yield without friction over the yield strength (v = 0.3), below which
parts that press go together elastically; that of each material is `first_yield`."""

Body = Literal["pin", "hole"]
"""The two bodies of a contact; the hole is that of the satellite."""

Layers = Literal["flat", "upright"]
"""How the layers of a printed part lie: across the axis of the pins, or along it."""

LIMIT_SOURCES = {
    "iso_14521": "ISO/TR 14521 (DIN 3996), worm wheel materials: pitting against hardened steel, "
    "of the mean pressure, so that the largest one is on the safe side; as in KISSsoft and MITCalc",
    "iso_281": "ISO 281:2007, fatigue load limit; clean and well lubricated; as in Zaretsky 2010 "
    "and bearing calculations after ISO/TR 1281-2",
    "iso_6336_5": "ISO 6336-5, pitting, grade MQ; as in KISSsoft and Roloff/Matek",
    "iso_6336_5_normalized": "ISO 6336-5, pitting, normalized steel: HBW + 190; as in a table of "
    "ISO 6336-5:2016 and in Roloff/Matek",
    "iso_6336_5_hardness": "ISO 6336-5, pitting, grade ML: 1.313*HV + 188; as in a table of "
    "ISO 6336-5:2016 and in Roloff/Matek",
    "iso_6336_5_static": "ISO 6336-5 and ISO 6336-2, 1.6 times the pitting limit for few loads; as "
    "in Autodesk Inventor and MITCalc",
    "iso_76": "ISO 76:2006, 3.3, roller bearings: permanent set of 1e-4*D",
}
"""Where limits of the contact pressure come from, in English, by code."""

LIMITS_VERIFIED: dict[str, Verified] = {"iso_76": "standard"}
"""Sources of limits that were read in the standard itself; of the others two secondary ones."""


class LimitLife(NamedTuple):
    """How a limit of the contact pressure falls over the life."""

    curve: LifeCurve  # whose curve
    loads: float  # over the life
    factor: float  # Z_NT of so many loads


@dataclass(frozen=True, slots=True)
class ContactLimit:
    """Limit of the contact pressure of a material, by one criterion."""

    criterion: Criterion
    pressure: Number  # the limit, Pa, > 0; NaN in an array where none is known
    source: str = ""  # a key of `LIMIT_SOURCES`; empty where it is given
    curve: LifeCurve | None = None  # how it falls with the number of loads; None where not known
    loads: float | None = None  # over the life that it is wanted for; infinite where not known

    @property
    def life(self) -> LimitLife:
        """How it falls over the life, by `MOST_LOADS` where nobody knows how many they are;
        `NotKnown` without its curve or a life.
        """
        curve: LifeCurve = required(self.curve, "no_life_curve")
        wanted: float = required(self.loads, "life_without_speed", "load.input_speed")
        loads = wanted if math.isfinite(wanted) else MOST_LOADS
        return LimitLife(curve, loads, float(life_factor(curve=curve, loads=loads)))

    @property
    def life_factor(self) -> float | None:
        """Factor Z_NT of the loads over the life; None where no life is wanted, no curve known."""
        return if_known(lambda: self.life.factor)

    @property
    def allowable(self) -> Number:
        """The limit over the life, Pa: as it stands where no life factor is known."""
        if self.loads is None:
            return self.pressure
        return self.pressure * (self.life_factor or 1.0)

    @property
    def verified(self) -> Verified | None:
        """How its source was seen; None where the limit is given."""
        return LIMITS_VERIFIED.get(self.source, "secondary") if self.source else None


class Spread(NamedTuple):
    """A value of a material whose sources differ, or that is given."""

    usual: float  # what is shown where it is not given
    low: float  # the least
    high: float  # the largest

    @classmethod
    def of(cls, value: float) -> Self:
        """One that is given."""
        return cls(value, value, value)


STRONGEST, STRONGEST_FILLED, FILLED = 97e6, 190e6, 5e9
"""Largest strength that a source gives of a thermoplastic, Pa: of PEEK (Victrex 450G), and of one
with fibres (PA66 with 30 % glass, dry: Academic Press Encyclopedia), stiffer than the third.
"""


@dataclass(frozen=True, slots=True)
class Plastic:
    """What a plastic is judged by, as far as it is known: it creeps, and has no shakedown."""

    layered: bool = True  # whether it may be printed in layers, across which it is weaker
    layers: Layers | None = None  # how they lie, where that is said
    strength_across: float | None = None  # strength across them, Pa
    friction: Spread | None = None  # friction coefficient of what slides on it
    softening: Spread | None = None  # temperature at which it goes soft, degrees Celsius
    long_term_factor: float | None = None  # strength in the long run over that of a short test


@dataclass(frozen=True, slots=True)
class ElasticMaterial:
    """Isotropic elastic material, of one body or of an array of them; None is not known."""

    youngs_modulus: Number  # E, Pa, > 0
    poissons_ratio: Number  # v, 0 <= v < 0.5
    limit: ContactLimit | None = None  # what its contact pressure is judged by, where known
    yield_strength: float | None = None  # Re, Pa
    # Whether yield below the surface says anything: not of hardened surfaces, whose core it is the
    # strength of, nor of bronzes, whose tested limits lie above it.
    yield_governs: bool = True
    # Contact pressure under a load at rest up to which nothing is set for good, Pa.
    static_pressure: float | None = None
    # Least modulus, Pa, where sources differ: then E is the largest one, for pressures and forces.
    least_modulus: float | None = None
    plastic: Plastic | None = None  # None of metals
    strengths: Spread | None = None  # of a plastic whose sources differ, Pa: Re is the least

    def __post_init__(self) -> None:
        check_positive(youngs_modulus=self.youngs_modulus)
        check_poissons_ratio(self.poissons_ratio)
        if self.yield_strength is not None:
            check_positive(yield_strength=self.yield_strength)

    def lasting(self, loads: float) -> Self:
        """The material, its limit wanted for so many loads."""
        if self.limit is None:
            return self
        return replace(self, limit=replace(self.limit, loads=loads))

    @property
    def known_limit(self) -> ContactLimit:
        """What its contact pressure is judged by."""
        return required(self.limit, "limit_unknown")

    @property
    def elastic_pressure(self) -> float:
        """Contact pressure up to which nothing is set for good, Pa: the static limit, else first
        yield below the surface; not known of plastics, of which the least strength is no proof.
        """
        if self.plastic or self.static_pressure is not None:
            return required(self.static_pressure, "plastic_rules")
        return FIRST_YIELD * required(self.yield_strength, "yield_unknown")

    @property
    def softest(self) -> Self:
        """The material with its least modulus, by which deflections are judged."""
        if self.least_modulus is None:
            return self
        return replace(self, youngs_modulus=self.least_modulus, least_modulus=None)

    def loaded_strength(self, body: Body) -> float | None:
        """The strength in the direction in which a body is loaded, Pa: of a printed pin across its
        layers, where these are not said to lie otherwise; None where it is not known.
        """
        if self.plastic is None or not self.plastic.layered:
            return self.yield_strength
        usual: Layers = "flat" if body == "hole" else "upright"
        flat = (self.plastic.layers or usual) == "flat"
        return self.yield_strength if flat else self.plastic.strength_across

    @property
    def most_strength(self) -> float:
        """A strength that a plastic does not exceed in any direction, Pa: where none is known the
        largest of its kind.
        """
        if self.strengths is not None:
            return self.strengths.high
        filled = float(self.youngs_modulus) > FILLED
        return self.yield_strength or (STRONGEST_FILLED if filled else STRONGEST)

    def most_pressure(self, friction: float | None) -> float:
        """A pressure at which a plastic yields for certain, Pa: that of shakedown where nothing is
        known of its strength.

        Parameters
        ----------
        friction : float or None
            Least friction coefficient; None where it is not known.

        Returns
        -------
        float
        """
        if self.yield_strength is None:
            return SHAKEDOWN * self.most_strength
        ratio = float(self.poissons_ratio)
        return self.most_strength * first_yield(poissons_ratio=ratio, friction=friction or 0.0)

    def usual(self, path: str) -> dict[str, Spread]:
        """Values of a plastic that are not given and whose sources differ.

        Parameters
        ----------
        path : str
            Of the material in its design.

        Returns
        -------
        dict
            By their paths.
        """
        found = {f"{path}.yield_strength": self.strengths} if self.strengths else {}
        if self.least_modulus is not None:
            modulus = float(self.youngs_modulus)
            found[f"{path}.youngs_modulus"] = Spread(modulus, self.least_modulus, modulus)
        return found

    def known_strength(self, body: Body, name: str) -> float:
        """That strength, Pa, which has to be known.

        Parameters
        ----------
        body : {"pin", "hole"}
            The body.
        name : str
            Core name of the material.

        Returns
        -------
        float

        Raises
        ------
        NotKnown
            If it, or the direction in which the layers lie, is not given.
        """
        strength = self.loaded_strength(body)
        if strength is None:
            upright = self.plastic is not None and self.plastic.layers == "upright"
            known = None if upright else self.yield_strength
            required(known, "yield_unknown", f"{name}.yield_strength", name)
            raise NotKnown("direction_unknown", f"{name}.layers", name)
        return strength

    @property
    def plane_modulus(self) -> Number:
        """Modulus in plane strain ``E/(1 - v^2)``, Pa."""
        return self.youngs_modulus / ((1 - self.poissons_ratio) * (1 + self.poissons_ratio))

    @property
    def shear_modulus(self) -> Number:
        """Shear modulus ``G = E/(2*(1 + v))``, Pa."""
        return self.youngs_modulus / (2 * (1 + self.poissons_ratio))


def check_poissons_ratio(poissons_ratio: Number) -> None:
    """Refuse a Poisson's ratio outside ``0 <= v < 0.5``.

    Parameters
    ----------
    poissons_ratio : float or array
        Poisson's ratio.

    Raises
    ------
    InvalidInput
        If it is; of an array the first such entry is named.
    """
    check_not_negative(poissons_ratio=poissons_ratio)
    allowed = poissons_ratio < 0.5
    if not every(allowed):
        refuse("poissons_ratio", poissons_ratio, allowed, "less_than", limit=0.5)


def effective_modulus(*, first: ElasticMaterial, second: ElasticMaterial) -> Number:
    """Effective modulus of two bodies in contact: ``1/E* = (1 - v1^2)/E1 + (1 - v2^2)/E2``.

    Parameters
    ----------
    first, second : ElasticMaterial
        The two materials.

    Returns
    -------
    float or array
        E*, Pa.

    Notes
    -----
    Source: Yanchevsky et al. 2018, eq. (2), where ``Z_E = sqrt(E*/pi)``.

    Examples
    --------
    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> round(effective_modulus(first=steel, second=steel)/1e9, 6)
    115.384615
    """
    return 1 / (1 / first.plane_modulus + 1 / second.plane_modulus)


def mismatch(*, first: ElasticMaterial, second: ElasticMaterial) -> tuple[Number, Number]:
    """Dundurs' constants of two bodies in contact: how different they are elastically.

    ``alpha = (E1' - E2')/(E1' + E2')`` with ``E' = E/(1 - v^2)``, and
    ``beta = E*/2*((1 - 2*v2)*(1 + v2)/E2 - (1 - 2*v1)*(1 + v1)/E1)``.

    Parameters
    ----------
    first, second : ElasticMaterial
        The two materials.

    Returns
    -------
    alpha, beta : float or array
        Dimensionless; both 0 for identical materials.

    Notes
    -----
    Source: Dundurs 1969, in Johnson, Contact Mechanics, 5.1.
    """
    one, other = first.plane_modulus, second.plane_modulus
    shear = [
        (1 - 2 * each.poissons_ratio) * (1 + each.poissons_ratio) / each.youngs_modulus
        for each in (first, second)
    ]
    modulus = effective_modulus(first=first, second=second)
    return (one - other) / (one + other), modulus / 2 * (shear[1] - shear[0])


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
            # rho has the difference of two radii that are known to rounding; beta is in a factor
            relative_error=ROUNDING * (8 + (hole_radius + pin_radius) / difference)
            + where(wide["governing"] == max_pressure, 0.0, 2 * abs(constants[1]) * ERROR),
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


PLACES, ZOOMS, CLOSER = 25, 9, 6
"""Places along each side of the field that is searched, how often it is narrowed, and how far."""

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength, without friction: the largest
orthogonal shear, a quarter of it, is the shear yield strength ``Re/sqrt(3)``."""

SLIDING, SLIDING_SHAKEDOWN = 0.1, 2.06
"""The largest friction for which it is known, and what it is there (Johnson 1985: 3.565 times the
shear yield strength)."""


def squared_stress(
    *, poissons_ratio: float, friction: float, x: FloatArray, z: FloatArray
) -> FloatArray:
    """Square of the equivalent stress (Mises) below a sliding line contact.

    ``(1 - 2*v)^2/4*(sx + sz)^2 + 3/4*(sx - sz)^2 + 3*t^2``, as ``sy = v*(sx + sz)``.

    Parameters
    ----------
    poissons_ratio : float
        v, dimensionless.
    friction : float
        Friction coefficient mu, >= 0.
    x, z : array
        Place along the surface and depth over the half-width of the contact, z > 0.

    Returns
    -------
    array
        Over the square of the largest pressure.

    Notes
    -----
    Source: McEwen 1949, in Johnson, Contact Mechanics, (4.49) of the pressure and (7.8) of the
    friction.
    """
    inner = 1 - x**2 + z**2
    root = np.sqrt(inner**2 + 4 * x**2 * z**2)
    m, n = np.sqrt((root + inner) / 2), np.copysign(np.sqrt((root - inner) / 2), x)
    q, r = (z**2 + n**2) / (m**2 + n**2), (m**2 - z**2) / (m**2 + n**2)
    together = 2 * (z - m) + 2 * friction * (n - x)
    apart = 2 * (z - m * q) + 2 * friction * (n * (1 + r) - x)
    shear = -n * r - friction * (m * (1 + q) - 2 * z)
    squared = (0.5 - poissons_ratio) ** 2 * together**2 + 0.75 * apart**2 + 3 * shear**2
    return np.asarray(squared, np.float64)


@lru_cache(maxsize=1024)
def first_yield(*, poissons_ratio: float, friction: float = 0.0) -> float:
    """Largest pressure of a line contact at first yield over the yield strength (Mises).

    At the surface ``1/sqrt(3*mu^2 + (1 - 2*v)^2*(1 + mu^2))``; below it the largest equivalent
    stress is searched.

    Parameters
    ----------
    poissons_ratio : float
        v of the body, 0 <= v < 0.5.
    friction : float
        Friction coefficient mu of the sliding pair, >= 0.

    Returns
    -------
    float
        f, dimensionless: p0 = f*Re.

    Examples
    --------
    >>> [round(first_yield(poissons_ratio=v), 4) for v in (0.3, 0.36, 0.43)]
    [1.7937, 1.8582, 1.9063]
    >>> [round(first_yield(poissons_ratio=0.36, friction=mu), 3) for mu in (0.1, 0.3, 0.6)]
    [1.831, 1.626, 0.918]
    """
    at_surface = 3 * friction**2 + (1 - 2 * poissons_ratio) ** 2 * (1 + friction**2)
    x, z, wide, deep = 0.0, 0.8, 1.2, 0.8
    below = 0.0
    for _ in range(ZOOMS):
        across = np.linspace(x - wide, x + wide, PLACES)
        down = np.linspace(max(z - deep, 1e-9), z + deep, PLACES)
        stress = squared_stress(
            poissons_ratio=poissons_ratio,
            friction=friction,
            x=across[:, None],
            z=down[None, :],
        )
        i, j = np.unravel_index(np.argmax(stress), stress.shape)
        below, x, z = max(below, float(stress[i, j])), float(across[i]), float(down[j])
        wide, deep = wide / CLOSER, deep / CLOSER
    return 1 / math.sqrt(max(at_surface, below))


def shakedown(friction: float) -> float:
    """Largest pressure of elastic shakedown over the yield strength, with friction.

    Parameters
    ----------
    friction : float
        Friction coefficient of the pair that slides, >= 0.

    Returns
    -------
    float
        In between by a straight line; beyond, the last known one, above which it fails for certain,
        as friction only lowers it.

    Examples
    --------
    >>> [round(shakedown(mu), 3) for mu in (0.0, 0.05, 0.1, 0.5)]
    [2.309, 2.185, 2.06, 2.06]
    """
    part = min(friction / SLIDING, 1.0)
    return SHAKEDOWN + part * (SLIDING_SHAKEDOWN - SHAKEDOWN)
