"""Elastic materials of pins, holes, rollers and shafts, what two of them make together; and what is
known of a material of the table, from where, or of one that is given by values; by which pressure
a sliding line contact of a material first yields, and shakes down.

Hertz's pressure and its friction ``q = mu*p`` stress a half-plane in plane strain. Without friction
it yields first below the surface; from a friction of some 0.3 on at the surface, under less.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Literal, NamedTuple, Self, TypedDict, Unpack, cast

import numpy as np

from core.arrays import FloatArray, Number, check_not_negative, check_positive, every, refuse
from core.contact_life import LifeCurve, life_factor
from core.errors import InvalidInput, NotKnown, if_known, required

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
    loads: float = math.inf  # over the life that it is wanted for; infinite where not known

    @property
    def life(self) -> LimitLife:
        """How it falls over the life; `NotKnown` without its curve or the loads."""
        curve: LifeCurve = required(self.curve, "no_life_curve")
        if math.isinf(self.loads):
            raise NotKnown("life_without_speed", "load.input_speed")
        factor = float(life_factor(curve=curve, loads=self.loads))
        return LimitLife(curve, self.loads, factor)

    @property
    def life_factor(self) -> float | None:
        """Factor Z_NT of the loads over the life; None where they or the curve are not known."""
        return if_known(lambda: self.life.factor)

    @property
    def allowable(self) -> Number:
        """The limit over the life, Pa: as it stands where no life factor is known."""
        if math.isinf(self.loads):
            return self.pressure
        return self.pressure * (self.life_factor or 1.0)

    @property
    def verified(self) -> Verified | None:
        """How its source was seen; None where the limit is given."""
        return LIMITS_VERIFIED.get(self.source, "secondary") if self.source else None


@dataclass(frozen=True, slots=True)
class Plastic:
    """What a plastic is judged by, as far as it is known: it creeps, and has no shakedown."""

    layered: bool = True  # whether it may be printed in layers, across which it is weaker
    layers: Layers | None = None  # how they lie, where that is said
    strength_across: float | None = None  # strength across them, Pa
    friction: float | None = None  # largest friction coefficient seen, dry
    softening: float | None = None  # temperature at which it goes soft, degrees Celsius
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
            required(self.yield_strength, "yield_unknown", f"{name}.yield_strength", name)
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


GROUPS = {
    "steel": "Steel",
    "cast_iron": "Cast iron",
    "aluminium": "Aluminium",
    "bronze": "Bronze",
    "brass": "Brass",
    "plastic": "Plastic",
    "plastic_printed": "Printed plastic",
}
"""Kinds of materials in English, by code."""

PLASTICS = ("plastic", "plastic_printed")
"""Groups that are judged by the rules of plastics."""

SOFT = 20e9
"""Young's modulus below which a material that is given by values is a plastic, Pa: metals of pins
and holes lie above 40 GPa, filled plastics below 15 GPa."""

Seen = Literal["one", "two"]
"""In how many independent sources a value was read."""

SEEN: dict[Seen, str] = {"one": "one source, for reference", "two": "two sources"}
"""The same in English."""


@dataclass(frozen=True, slots=True)
class Strength:
    """Strength of a material, as far as it is known."""

    tensile: float | None = None  # Rm, Pa
    yield_strength: float | None = None  # Re or Rp0.2, Pa; of a printed plastic in its layers
    # Largest diameter or wall that they hold for, m; None where their source names none.
    valid_diameter: float | None = None
    source: str = ""  # where they come from


@dataclass(frozen=True, slots=True)
class Fact:
    """A value of which there is one source only, or on which all agree."""

    value: float  # SI, temperatures in degrees Celsius
    source: str  # where it was seen
    seen: Seen = field(default="two", kw_only=True)  # one: for reference


@dataclass(frozen=True, slots=True)
class Range(Fact):
    """A value whose sources differ."""

    low: float  # the least that was seen
    high: float  # the largest


ELASTIC = ("youngs_modulus", "poissons_ratio")
"""Names of E and v."""


class Moduli(TypedDict, total=False):
    """E and v, as far as they are given."""

    youngs_modulus: float  # E, Pa
    poissons_ratio: float  # v


@dataclass(frozen=True)
class TableMaterial:
    """A material of the table."""

    name: str  # for programs, stable
    title: str  # name for people
    group: str  # a key of `GROUPS`
    moduli: Mapping[str, float] = field(hash=False)  # E, Pa, and v, as far as a source has them
    source: str  # where these come from
    limits: tuple[ContactLimit, ...] = ()  # of its contact pressure, at most one by each criterion
    strength: Strength = Strength()
    density: float | None = None  # kg/m^3
    density_source: str = ""  # where that comes from
    hardened: bool = False  # whether its strengths are those of the core
    layered: bool = False  # whether it is printed in layers
    facts: Mapping[str, Fact] = field(default_factory=dict, hash=False)  # by the name of the value

    @property
    def reference(self) -> tuple[str, ...]:
        """Values that the material has from one source only."""
        used = ("youngs_modulus", "poissons_ratio", "density")
        return tuple(name for name in used if name in self.facts and self.facts[name].seen == "one")

    @property
    def missing(self) -> tuple[str, ...]:
        """Of E and v, what no source has."""
        return tuple(name for name in ELASTIC if name not in self.moduli)

    @cached_property
    def material(self) -> ElasticMaterial:
        """The material at room temperature, judged by its endurance limit where it has one.

        Raises
        ------
        InvalidInput
            If no source has its modulus or its Poisson's ratio.
        """
        return self.having()

    def having(self, **given: Unpack[Moduli]) -> ElasticMaterial:
        """The material with a modulus, Pa, or a Poisson's ratio that is given.

        Parameters
        ----------
        **given : float
            `youngs_modulus` or `poissons_ratio` instead of those of the table.

        Returns
        -------
        ElasticMaterial
            Where sources differ, its modulus is the largest.

        Raises
        ------
        InvalidInput
            If one is not given that no source has.
        """
        known, least = {**self.moduli}, {}
        match self.facts.get("youngs_modulus"):
            case Range(low=low, high=high) if "youngs_modulus" not in given:
                known["youngs_modulus"], least = high, {"least_modulus": low}
        known |= cast(dict[str, float], given)
        for name in ELASTIC:
            if name not in known:
                raise InvalidInput(name, None, "not_sourced", material=self.name)
        static = [float(each.pressure) for each in self.limits if each.criterion == "static"]
        return ElasticMaterial(
            **known,
            limit=next((each for each in self.limits if each.criterion != "static"), None),
            yield_strength=None if self.hardened else self._strength,
            yield_governs=not self.hardened and self.group != "bronze",
            static_pressure=next(iter(static), None),
            **least,
            plastic=self._plastic if self.group in PLASTICS else None,
        )

    @property
    def _strength(self) -> float | None:
        """Yield strength; of a plastic of which none is known its tensile strength."""
        if self.group in PLASTICS and self.strength.yield_strength is None:
            return self.strength.tensile
        return self.strength.yield_strength

    @property
    def _plastic(self) -> Plastic:
        values = {name: each.value for name, each in self.facts.items()}
        sure = {name: each.value for name, each in self.facts.items() if each.seen == "two"}
        return Plastic(
            layered=self.layered, friction=values.get("friction"), softening=sure.get("softening")
        )


NOT_LISTED = TableMaterial("", "", "", {}, "", layered=True)
"""A material that is given by values alone."""


def by_values(
    *,
    base: TableMaterial = NOT_LISTED,
    limit: ContactLimit | None = None,
    tensile_strength: float | None = None,
    yield_strength: float | None = None,
    layers: Layers | None = None,
    long_term_factor: float | None = None,
    **moduli: Unpack[Moduli],
) -> ElasticMaterial:
    """A material by values.

    Parameters
    ----------
    base : TableMaterial
        Whose values are taken where none are given; of one that is not listed it is a plastic where
        its modulus is below `SOFT`.
    limit : ContactLimit, optional
        What its contact pressure is judged by.
    tensile_strength, yield_strength : float, optional
        Rm and Re, Pa; of a plastic the smaller one counts, in the direction that `layers` says.
    layers : {"flat", "upright"}, optional
        How the layers of a printed plastic lie.
    long_term_factor : float, optional
        Strength in the long run over that of a short test.
    **moduli : float
        `youngs_modulus` E, Pa, and `poissons_ratio` v.

    Returns
    -------
    ElasticMaterial

    Raises
    ------
    InvalidInput
        If E or v is not known.

    Examples
    --------
    >>> own = by_values(youngs_modulus=2.5e9, poissons_ratio=0.38, tensile_strength=44e6)
    >>> own.loaded_strength("hole"), own.loaded_strength("pin")
    (44000000.0, None)
    """
    made = base.having(**moduli)
    plastic = made.plastic
    if base is NOT_LISTED and made.youngs_modulus < SOFT:
        plastic = Plastic()
    strength = yield_strength
    if plastic is not None:
        given = [each for each in (yield_strength, tensile_strength) if each is not None]
        strength = min(given, default=None)
        plastic = replace(
            plastic,
            layers=layers,
            strength_across=strength if layers == "upright" else None,
            long_term_factor=long_term_factor,
        )
    return replace(
        made,
        limit=limit or made.limit,
        yield_strength=made.yield_strength if strength is None else strength,
        plastic=plastic,
    )


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
