"""Line contact of pin and hole: elastic materials, pressure against its limits, first yield.

Hertz replaces both bodies by half-planes and so needs a contact much narrower than the pin. A pin
in a hole that is only a little larger is nearly conformal, the contact wraps around the pin, and
`core.conformal` takes over. First yield and shakedown are those of a half-plane in plane strain
under Hertz's pressure p and the friction ``q = mu*p``: without friction the half-plane yields first
below the surface, from mu of about 0.3 on at the surface and under a lower pressure.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Annotated, Literal, NamedTuple, Self

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
from core.contact_life import CURVES, MOST_LOADS, LifeCurve, life_factor
from core.errors import Accuracy, Notice, NotKnown, if_known, poorly_known, required
from core.fields import Output, answered
from core.numerics.inverse import edge
from core.precision import ROUNDING

Criterion = Literal["endurance", "endurance_mean", "static", "given"]
"""Criterion of a limit of the contact pressure: "endurance" is pitting in the long run,
"endurance_mean" judges pitting by the mean pressure of a mesh (the largest pressure is then on the
safe side), "static" is a permanent set under a load at rest, "given" is a value of the user."""

CRITERIA: dict[Criterion, str] = {
    "endurance": "endurance",
    "endurance_mean": "endurance, mean pressure",
    "static": "static",
    "given": "given",
}
"""English words of the criteria."""

Verified = Literal["standard", "secondary"]
"""Origin of a value: read in its standard, or in two independent secondary sources."""

VERIFIED: dict[Verified, str] = {
    "standard": "standard",
    "secondary": "secondary sources",
}
"""English words of the origins."""

FIRST_YIELD = 1.79
"""Largest pressure at first yield without friction over the yield strength (v = 0.3), below which
parts pressed together stay elastic; `first_yield` has the value of each material."""

Body = Literal["pin", "hole"]
"""Bodies of a contact; the hole is in the satellite."""

Layers = Literal["flat", "upright"]
"""Direction of the layers of a printed part: across the axis of the pins (flat) or along it."""

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
"""Sources of limits of the contact pressure in English, by code."""

LIMITS_VERIFIED: dict[str, Verified] = {"iso_76": "standard"}
"""Sources of limits read in the standard itself; the others were read in two secondary sources."""


class LimitLife(NamedTuple):
    """Life curve of a limit, with its factor at the number of loads."""

    curve: Annotated[LifeCurve, Output()]
    """Material group whose life curve is used; the curves are those of gear teeth in ISO 6336-2."""
    loads: Annotated[float, Output("", "N_L")]
    """Number of loads over the life: turns of a satellite relative to its crank."""
    factor: Annotated[float, Output("", "Z_NT", "ISO 6336-2")]
    """Life factor."""

    @property
    @answered("", "N_k")
    def knee_loads(self) -> float:
        """Number of loads at which the limit is that of the material."""
        return CURVES[self.curve].knee

    @property
    @answered("", "m")
    def exponent(self) -> float:
        """Exponent of the line on this side of the knee."""
        line = CURVES[self.curve]
        return line.before if self.loads < line.knee else line.beyond

    @property
    @answered("", "Z_m")
    def largest_factor(self) -> float:
        """Largest life factor, for few loads."""
        return CURVES[self.curve].most


@dataclass(frozen=True, slots=True)
class ContactLimit:
    """Limit of the contact pressure of a material, by one criterion."""

    criterion: Criterion
    pressure: Number  # the limit, Pa, > 0; NaN in an array where none is known
    source: str = ""  # a key of `LIMIT_SOURCES`; empty where it is given
    curve: LifeCurve | None = None  # life curve; None where not known
    loads: float | None = None  # over the required life; infinite where not known

    @property
    def life(self) -> LimitLife:
        """Life at `loads`, or at `MOST_LOADS` if infinite; `NotKnown` without curve or loads."""
        curve: LifeCurve = required(self.curve, "no_life_curve")
        wanted: float = required(self.loads, "life_without_speed", "load.input_speed")
        loads = wanted if math.isfinite(wanted) else MOST_LOADS
        return LimitLife(curve, loads, float(life_factor(curve=curve, loads=loads)))

    @property
    def life_factor(self) -> float | None:
        """Life factor Z_NT at the number of loads; None without a life or a curve."""
        return if_known(lambda: self.life.factor)

    @property
    def allowable(self) -> Number:
        """Limit times its life factor, Pa; the limit itself where no factor is known."""
        if self.loads is None:
            return self.pressure
        return self.pressure * (self.life_factor or 1.0)

    @property
    def verified(self) -> Verified | None:
        """Origin of the limit; None where the limit is given."""
        return LIMITS_VERIFIED.get(self.source, "secondary") if self.source else None


class Spread(NamedTuple):
    """Usual, least and largest value of a material property."""

    usual: float  # value that is shown where none is given
    low: float  # the least
    high: float  # the largest

    @classmethod
    def of(cls, value: float) -> Self:
        """Spread of a single value that is given."""
        return cls(value, value, value)


STRONGEST, STRONGEST_FILLED, FILLED = 97e6, 190e6, 5e9
"""Largest strength that a source gives of a thermoplastic, Pa: PEEK (Victrex 450G); with fibres:
PA66 with 30 % glass, dry (Academic Press Encyclopedia); and the modulus, Pa, above which a
plastic counts as one with fibres."""


@dataclass(frozen=True, slots=True)
class Plastic:
    """Properties of a plastic as far as they are known; a plastic creeps and has no shakedown."""

    layered: bool = True  # True if it may be printed in layers, across which it is weaker
    layers: Layers | None = None  # direction of the layers, where given
    strength_across: float | None = None  # strength across the layers, Pa
    friction: Spread | None = None  # friction coefficient of a part that slides on it
    softening: Spread | None = None  # temperature at which it softens, degrees Celsius
    long_term_factor: float | None = None  # long-term strength over that of a short test


@dataclass(frozen=True, slots=True)
class BulkStrength:
    """Strength of a body in bending, as far as it is known: that of the core if it is hardened."""

    tensile_strength: float | None = None  # Rm, Pa
    yield_strength: float | None = None  # Re or Rp0.2, Pa; None where it is that of the material
    steel: bool = False  # True if a rule of the endurance limit exists for the material
    valid_diameter: float | None = None  # largest diameter that the strengths hold for, m


@dataclass(frozen=True, slots=True)
class ElasticMaterial:
    """Isotropic elastic material of one body or of an array of bodies; None is an unknown value."""

    youngs_modulus: Number  # E, Pa, > 0
    poissons_ratio: Number  # v, 0 <= v < 0.5
    limit: ContactLimit | None = None  # limit of its contact pressure, where known
    yield_strength: float | None = None  # Re, Pa
    # True if yield below the surface is judged: not for hardened surfaces, as the strength is that
    # of their core, nor for bronzes, as their tested limits lie above first yield.
    yield_governs: bool = True
    # Contact pressure without permanent set under a load at rest, Pa.
    static_pressure: float | None = None
    # Least modulus, Pa, where sources differ: then E is the largest one, for pressures and forces.
    least_modulus: float | None = None
    plastic: Plastic | None = None  # None for metals
    strengths: Spread | None = None  # if sources of a plastic differ, Pa; Re is the least
    bulk: BulkStrength = field(default=BulkStrength(), compare=False)  # strength in bending
    density: float | None = field(default=None, compare=False)  # kg/m^3, where a source gives it

    def __post_init__(self) -> None:
        check_positive(youngs_modulus=self.youngs_modulus)
        check_poissons_ratio(self.poissons_ratio)
        if self.yield_strength is not None:
            check_positive(yield_strength=self.yield_strength)

    def lasting(self, loads: float) -> Self:
        """Copy of the material with its limit asked for a number of loads over the life."""
        if self.limit is None:
            return self
        return replace(self, limit=replace(self.limit, loads=loads))

    @property
    def known_limit(self) -> ContactLimit:
        """Limit of the contact pressure; `NotKnown` without one."""
        return required(self.limit, "limit_unknown")

    @property
    def elastic_pressure(self) -> float:
        """Contact pressure at rest without permanent set, Pa: the static limit, else first yield
        below the surface. A plastic needs its static limit, as its least strength proves nothing.
        """
        if self.plastic or self.static_pressure is not None:
            return required(self.static_pressure, "plastic_rules")
        return FIRST_YIELD * required(self.yield_strength, "yield_unknown")

    @property
    def softest(self) -> Self:
        """Material with its least modulus, for deflections."""
        if self.least_modulus is None:
            return self
        return replace(self, youngs_modulus=self.least_modulus, least_modulus=None)

    def loaded_strength(self, body: Body) -> float | None:
        """Strength in the loaded direction, Pa, or None if unknown; a printed pin is loaded across
        its layers and a printed hole along them, unless `plastic.layers` says otherwise.
        """
        if self.plastic is None or not self.plastic.layered:
            return self.yield_strength
        usual: Layers = "flat" if body == "hole" else "upright"
        flat = (self.plastic.layers or usual) == "flat"
        return self.yield_strength if flat else self.plastic.strength_across

    @property
    def most_strength(self) -> float:
        """Upper bound of a plastic's strength, Pa; by the strongest of its kind if unknown."""
        if self.strengths is not None:
            return self.strengths.high
        filled = float(self.youngs_modulus) > FILLED
        return self.yield_strength or (STRONGEST_FILLED if filled else STRONGEST)

    def most_pressure(self, friction: float | None) -> float:
        """Pressure at which a plastic yields for certain, Pa, at its least friction coefficient
        (None: 0); shakedown pressure of `most_strength` if the yield strength is unknown.
        """
        if self.yield_strength is None:
            return SHAKEDOWN * self.most_strength
        ratio = float(self.poissons_ratio)
        return self.most_strength * first_yield(poissons_ratio=ratio, friction=friction or 0.0)

    def usual(self, path: str) -> dict[str, Spread]:
        """Spreads of a plastic's values that are not given, by path below the material's `path`."""
        found = {f"{path}.yield_strength": self.strengths} if self.strengths else {}
        if self.least_modulus is not None:
            modulus = float(self.youngs_modulus)
            found[f"{path}.youngs_modulus"] = Spread(modulus, self.least_modulus, modulus)
        return found

    def known_strength(self, body: Body, name: str) -> float:
        """Strength in the loaded direction, Pa; `NotKnown` has the missing input of `name`."""
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
    """Refuse a Poisson's ratio outside ``0 <= v < 0.5``; the first such entry is named."""
    check_not_negative(poissons_ratio=poissons_ratio)
    allowed = poissons_ratio < 0.5
    if not every(allowed):
        refuse("poissons_ratio", poissons_ratio, allowed, "less_than", limit=0.5)


def effective_modulus(*, first: ElasticMaterial, second: ElasticMaterial) -> Number:
    """Effective modulus E*, Pa, of two bodies: ``1/E* = (1 - v1^2)/E1 + (1 - v2^2)/E2``.

    Source: Yanchevsky et al. 2018, eq. (2), where ``Z_E = sqrt(E*/pi)``.

    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> round(effective_modulus(first=steel, second=steel)/1e9, 6)
    115.384615
    """
    return 1 / (1 / first.plane_modulus + 1 / second.plane_modulus)


def mismatch(*, first: ElasticMaterial, second: ElasticMaterial) -> tuple[Number, Number]:
    """Dundurs' constants alpha and beta of two bodies; both are 0 for identical materials.

    ``alpha = (E1' - E2')/(E1' + E2')`` with ``E' = E/(1 - v^2)``, and
    ``beta = E*/2*((1 - 2*v2)*(1 + v2)/E2 - (1 - 2*v1)*(1 + v1)/E1)``.
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
"""Relative excess of the conformal pressure over Hertz's above which the conformal one governs."""

HALF_WIDTH_RATIO_LIMIT = 0.159
"""Half-width over pin radius at which Hertz is off by `HERTZ_TOLERANCE` (identical materials)."""

STRAIN_LIMIT = 0.02
"""Largest pressure over E* up to which strains are small."""


class BodySafety(NamedTuple):
    """Safety of one body of a contact against the limit of its own material."""

    body: Annotated[Body, Output()]
    """Body that is judged."""
    limit: ContactLimit  # limit of its contact pressure
    safety_factor: Annotated[Number, Output()]
    """Limit over governing pressure, with the life factor if there is one. The factor is a ratio of
    pressures; the reserve of the load is its square as long as Hertz's pressure governs."""


class HertzContact(NamedTuple):
    """Stress of the line contact of pin and hole, or of an array of contacts.

    Values that do not apply or are unknown are None; in an array NaN, or None if all are.
    """

    max_pressure: Annotated[Number, Output("MPa", "p_0", "2018, eq. 2")]
    """Largest pressure by Hertz."""
    mean_pressure: Annotated[Number, Output("MPa", "p_m", "Johnson 4.2")]
    """Mean pressure, π/4 of the largest."""
    half_width: Annotated[Number, Output("mm", "a", "Johnson 4.2")]
    """Half-width of the contact."""
    half_width_ratio: Annotated[Number, Output("", "a/r")]
    """Half-width over the radius of the pin."""
    max_shear: Annotated[Number, Output("MPa", "τ_max", "Johnson 4.2")]
    """Largest shear stress, below the surface."""
    max_shear_depth: Annotated[Number, Output("mm", "z", "Johnson 4.2")]
    """Depth of the largest shear stress."""
    reduced_radius: Annotated[Number, Output("mm", "ρ", "2018, eq. 2")]
    """Radius of relative curvature."""
    effective_modulus: Annotated[Number, Output("GPa", "E*", "2018, eq. 2")]
    """Contact modulus of both bodies."""
    mismatch: tuple[Number, Number]  # Dundurs' alpha and beta, positive where the pin is stiffer
    conformity: Number  # w/(E*(R - r)) of the line load w; large where pin and hole fit closely
    conformal_pressure: Annotated[Number | None, Output("MPa", "p_c", "Persson 1964")]
    """Largest pressure of a contact that wraps around the pin, of any two materials; absent where
    it lies less than 1 % above Hertz's."""
    conformal_half_angle: Annotated[Number | None, Output("deg", "ε", "Persson 1964")]
    """Half of the conformal contact's angle, seen from the middle between both axes."""
    conformal_half_angle_pin: Annotated[Number | None, Output("deg", "ε·√(R/r)")]
    """Half of the conformal contact's angle on the pin."""
    conformal_half_angle_hole: Annotated[Number | None, Output("deg", "ε·√(r/R)")]
    """Half of the conformal contact's angle on the hole."""
    conformal_half_length: Annotated[Number | None, Output("mm", "ε·√(r·R)")]
    """Half of the conformal contact's length along the arc."""
    edge_tension: Annotated[Number | None, Output("MPa", "σ_t")]
    """Hoop tension in the rim of the hole at the ends of the conformal contact."""
    # Pressure to be judged, Pa: the conformal one where it applies, else Hertz's; NaN where the
    # contact would wrap around more than half of the pin.
    governing: Number
    safety: Annotated[tuple[BodySafety, ...], Output()]
    """Safety of each body whose limit is known; absent if neither is known."""
    safety_factor: Annotated[Number | None, Output("", "S")]
    """Smaller of both bodies' safety factors; absent if one is not known. The factor is a ratio of
    pressures; the reserve of the load is its square as long as Hertz's pressure governs."""
    accuracy: Annotated[Accuracy, Output()]

    @property
    def is_conformal(self) -> bool:
        """True if the contact is so wide that the conformal pressure applies."""
        return self.conformal_pressure is not None

    @property
    @answered("MPa", "p_g", optional=True)
    def governing_pressure(self) -> Number:
        """Pressure that is judged: the conformal pressure if it is given, else Hertz's; absent if
        the contact would wrap around more than half of the pin.
        """
        if isinstance(self.governing, float) and math.isnan(self.governing):
            raise NotKnown("contact_wraps")
        return self.governing

    @property
    @answered()
    def notices(self) -> tuple[Notice, ...]:
        """Limits of validity that a single contact (no array) exceeds."""
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
    """Line contact of a pin in a hole; arrays hold one contact in each place.

    ``w = F/b*K_A*K_alpha``, ``rho = R*r/(R - r)``, ``p0 = sqrt(w*E*/(pi*rho))``,
    ``a = sqrt(4*w*rho/(pi*E*))``. The conformal contact is added where its pressure is more than
    `HERTZ_TOLERANCE` above Hertz's. Source: Yanchevsky et al. 2018, eq. (2); half-width, mean
    pressure and shear: Johnson, Contact Mechanics, 4.2.

    The force F, N, is not negative; the contact length b, m, the application factor K_A and the
    load-sharing factor K_alpha of the pairs are > 0. The radius R of the hole has to be larger than
    r of the pin, as a pin that fills its hole has no line contact.

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
            # rho contains a difference of rounded radii; the factors of beta have their own error
            relative_error=ROUNDING * (8 + (hole_radius + pin_radius) / difference)
            + where(wide["governing"] > max_pressure, 2 * abs(constants[1]) * ERROR, 0.0),
            evaluations=evaluations,
        ),
    )


def narrow_load(beta: Number) -> Number:
    """Load parameter ``E* dR/Q`` above which Hertz is within `HERTZ_TOLERANCE`, a bound for any
    alpha; exact are 57.9 for alpha = 1 and beta = 0, and 777.4 for -1 and -1/2.
    """
    root = 7.65 - 41.0 * smaller(beta, 0.0)
    return root * root


def _max_pressure(line_load: Number, reduced_radius: Number, modulus: Number) -> Number:
    """Hertz's pressure in the middle of the contact, Pa."""
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
    """Conformal and governing pressure as fields of a `HertzContact`, method, number of steps."""
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
    """Safety of each body whose limit is known, under a governing pressure that is known."""
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
    """Factor on the force at which the governing pressure of a contact reaches a limit.

    Hertz's pressure grows with the root of the force, a conformal one faster, up to the force
    itself. The governing pressure jumps by one per cent where the conformal one takes over. The
    load per length is found from ``P/lambda = p*R_m/(E* dR)``, which grows with it. `contact_at`
    gives the contact under a multiple of the force. If the widest known contact stays below the
    limit, Pa, the factor of that contact is returned.
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
    # a margin, so that rounding of forces does not exceed the limit or the widest contact
    factor = float(1 / (parameter * contact.conformity)) * (1 - 512 * ROUNDING)
    if contact_at(factor).is_conformal:
        return factor

    def left(factor: float) -> float:
        return float(limit - contact_at(factor).governing)

    met, _ = edge(inside=factor, outside=by_hertz, excess=left)  # the limit lies within the jump
    return met * (1 - 512 * ROUNDING)


def pressure_profile(*, contact: HertzContact, samples: int = 81) -> tuple[FloatArray, FloatArray]:
    """Places across the contact, m, and Hertz pressure there, Pa, each of shape (samples,)."""
    angle = np.linspace(-math.pi / 2, math.pi / 2, samples)
    return contact.half_width * np.sin(angle), contact.max_pressure * np.cos(angle)


def conformal_profile(*, contact: HertzContact, samples: int = 81) -> tuple[FloatArray, FloatArray]:
    """Places along the arc, m, and conformal pressure there, Pa, shape (samples,), samples >= 2.

    `NotKnown` is raised for a contact without conformal pressure.
    """
    pressure = required(contact.conformal_pressure, "no_conformal_pressure")
    half_angle: Number = contact.conformal_half_angle
    half_length: Number = contact.conformal_half_length
    places = np.sin(np.linspace(-math.pi / 2, math.pi / 2, samples))
    shape = pressure_over_angle(
        angles=half_angle * places, tangent=math.tan(half_angle / 2), beta=contact.mismatch[1]
    )
    return half_length * places, pressure * shape


PLACES, ZOOMS, CLOSER = 25, 9, 6
"""Places along each side of the searched field, number of zooms, and factor of each zoom."""

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength, without friction: the largest
orthogonal shear, a quarter of the pressure, is the shear yield strength ``Re/sqrt(3)``."""

SLIDING, SLIDING_SHAKEDOWN = 0.1, 2.06
"""Largest friction coefficient with a known shakedown pressure, and that pressure over the yield
strength (Johnson 1985: 3.565 times the shear yield strength)."""


def squared_stress(
    *, poissons_ratio: float, friction: float, x: FloatArray, z: FloatArray
) -> FloatArray:
    """Square of Mises' stress below a sliding line contact, over that of the largest pressure.

    ``(1 - 2*v)^2/4*(sx + sz)^2 + 3/4*(sx - sz)^2 + 3*t^2``, as ``sy = v*(sx + sz)``; x along the
    surface and depth z > 0 are over the half-width of the contact.
    Source: McEwen 1949, in Johnson, Contact Mechanics, (4.49) for pressure and (7.8) for friction.
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

    At the surface ``1/sqrt(3*mu^2 + (1 - 2*v)^2*(1 + mu^2))``; below it the largest Mises stress is
    searched. Poisson's ratio 0 <= v < 0.5 is that of the body, the friction coefficient mu >= 0
    that of the sliding pair.

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
    """Largest pressure of elastic shakedown over the yield strength, by the friction coefficient.

    Linear between 0 and `SLIDING`. Beyond, the last value is an upper bound, as friction lowers it.

    >>> [round(shakedown(mu), 3) for mu in (0.0, 0.05, 0.1, 0.5)]
    [2.309, 2.185, 2.06, 2.06]
    """
    part = min(friction / SLIDING, 1.0)
    return SHAKEDOWN + part * (SLIDING_SHAKEDOWN - SHAKEDOWN)
