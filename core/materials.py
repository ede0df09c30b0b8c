"""Elastic materials of pins, holes, rollers and shafts, and what two of them make together."""

from dataclasses import dataclass, replace
from typing import Literal, Self

from core.arrays import Number, check_not_negative, check_positive, every, refuse
from core.contact_life import LifeCurve, life_factor

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
"""Largest pressure at first yield below the surface over the yield strength (Mises, v = 0.3)."""

GROUPS = {
    "steel": "Steel",
    "cast_iron": "Cast iron",
    "bronze": "Bronze",
    "brass": "Brass",
    "plastic": "Plastic",
}
"""Kinds of materials in English, by code."""

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

LIFE_CURVES: dict[str, LifeCurve] = {
    "iso_6336_5": "hardened",
    "iso_6336_5_hardness": "hardened",
    "iso_6336_5_normalized": "hardened",
}
"""Sources of limits for many loads that say how these fall with their number."""

LIMITS_VERIFIED: dict[str, Verified] = {"iso_76": "standard"}
"""Sources of limits that were read in the standard itself; of the others two secondary ones."""


@dataclass(frozen=True, slots=True)
class ContactLimit:
    """Limit of the contact pressure of a material, by one criterion."""

    criterion: Criterion
    pressure: Number  # the limit, Pa, > 0; NaN in an array where none is known
    source: str = ""  # a key of `LIMIT_SOURCES`; empty where it is given
    curve: LifeCurve | None = None  # how it falls with the number of loads; None where not known
    loads: float | None = None  # over the life that it is wanted for; None where not known

    @property
    def life_factor(self) -> float | None:
        """Factor Z_NT of the loads over the life; None where they or the curve are not known."""
        if self.curve is None or self.loads is None:
            return None
        return float(life_factor(curve=self.curve, loads=self.loads))

    @property
    def allowable(self) -> Number:
        """The limit over the life, Pa: as it stands where no life factor is known."""
        factor = self.life_factor
        return self.pressure if factor is None else self.pressure * factor

    @property
    def verified(self) -> Verified | None:
        """How its source was seen; None where the limit is given."""
        return LIMITS_VERIFIED.get(self.source, "secondary") if self.source else None


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

    def __post_init__(self) -> None:
        check_positive(youngs_modulus=self.youngs_modulus)
        check_poissons_ratio(self.poissons_ratio)
        if self.yield_strength is not None:
            check_positive(yield_strength=self.yield_strength)

    def lasting(self, loads: float | None) -> Self:
        """The material, its limit wanted for so many loads."""
        if self.limit is None:
            return self
        return replace(self, limit=replace(self.limit, loads=loads))

    @property
    def elastic_pressure(self) -> float | None:
        """Contact pressure up to which nothing is set for good, Pa: the static limit, else first
        yield below the surface; None where neither is known.
        """
        if self.static_pressure is not None or self.yield_strength is None:
            return self.static_pressure
        return FIRST_YIELD * self.yield_strength

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


@dataclass(frozen=True, slots=True)
class Strength:
    """Strength of a material, as far as it is known."""

    tensile: float | None = None  # Rm, Pa
    yield_strength: float | None = None  # Re or Rp0.2, Pa
    # Largest diameter or wall that they hold for, m; None where their source names none.
    valid_diameter: float | None = None
    source: str = ""  # where they come from


@dataclass(frozen=True, slots=True)
class TableMaterial:
    """A material of the table."""

    name: str  # for programs, stable
    title: str  # name for people
    group: str  # a key of `GROUPS`
    material: ElasticMaterial  # at room temperature, judged by its endurance limit where it has one
    limits: tuple[ContactLimit, ...]  # of its contact pressure, at most one for each criterion
    source: str  # where the elastic values come from
    strength: Strength
    density: float | None  # kg/m^3
    density_source: str  # where that comes from


def _entry(
    name: str,
    title: str,
    group: str,
    moduli: tuple[float, float],
    source: str,
    *limits: ContactLimit,
    strength: Strength = Strength(),
    density: tuple[float, str] | None = None,
    hardened: bool = False,
) -> TableMaterial:
    modulus_GPa, ratio = moduli
    lasting = next((each for each in limits if each.criterion != "static"), None)
    static = next((float(each.pressure) for each in limits if each.criterion == "static"), None)
    material = ElasticMaterial(
        modulus_GPa * 1e9,
        ratio,
        lasting,
        None if hardened else strength.yield_strength,
        yield_governs=not hardened and group != "bronze",
        static_pressure=static,
    )
    density_kg_m3, weighed = density or (None, "")
    return TableMaterial(
        name, title, group, material, limits, source, strength, density_kg_m3, weighed
    )


def _limit(criterion: Criterion, pressure_MPa: float, source: str) -> ContactLimit:
    return ContactLimit(criterion, pressure_MPa * 1e6, source, LIFE_CURVES.get(source))


def _strength(
    tensile_MPa: float | None, yield_MPa: float | None, size_mm: float | None, source: str
) -> Strength:
    return Strength(
        tensile=None if tensile_MPa is None else tensile_MPa * 1e6,
        yield_strength=None if yield_MPa is None else yield_MPa * 1e6,
        valid_diameter=None if size_mm is None else size_mm / 1e3,
        source=source,
    )


_ISO_6336_2 = "ISO 6336-2, table of elasticity factors"
_WORM = "ISO/TR 14521 (DIN 3996), worm wheel materials"
_DATA_SHEETS = "typical of data sheets, 23 degrees C"
_STEEL_DENSITY = (7850.0, "KISSsoft and MITCalc tables, 7830 to 7870")

MATERIALS: dict[str, TableMaterial] = {
    entry.name: entry
    for entry in (
        _entry(
            "steel_structural",
            "Structural steel (S235JR)",
            "steel",
            (210.0, 0.3),
            "EN 1993-1-1, 3.2.6",
            _limit("endurance", 120 + 190, "iso_6336_5_normalized"),
            strength=_strength(360, 225, 40, "EN 10025-2; as in readle.co.uk and Five Steel Pipe"),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_s355",
            "Structural steel (S355J2)",
            "steel",
            (210.0, 0.3),
            "EN 1993-1-1, 3.2.6",
            _limit("endurance", 160 + 190, "iso_6336_5_normalized"),
            strength=_strength(470, 345, 40, "EN 10025-2; as in readle.co.uk and Five Steel Pipe"),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_through_hardened",
            "Through-hardened alloy steel (42CrMo4, 300 HV)",
            "steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _limit("endurance", 1.313 * 300 + 188, "iso_6336_5_hardness"),
            strength=_strength(900, 650, 100, "EN 10083-3; as in Saarstahl and Key to Metals"),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_case_hardened",
            "Case-hardened steel (18CrNiMo7-6)",
            "steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _limit("endurance", 1500.0, "iso_6336_5"),
            _limit("static", 1.6 * 1500.0, "iso_6336_5_static"),
            density=_STEEL_DENSITY,
            hardened=True,
        ),
        _entry(
            "steel_bearing",
            "Bearing steel (100Cr6, hardened)",
            "steel",
            (207.0, 0.3),
            "ISO/TS 16281",
            _limit("endurance", 1500.0, "iso_281"),
            _limit("static", 4000.0, "iso_76"),
            density=_STEEL_DENSITY,
            hardened=True,
        ),
        _entry(
            "iron_grey",
            "Grey cast iron (EN-GJL-250)",
            "cast_iron",
            (118.0, 0.3),
            _ISO_6336_2,
            strength=_strength(195, None, 40, "EN 1561; as in modelleriazuin.it, iron-foundry.com"),
            density=(7200.0, "two public tables, 7200 and 7250"),
        ),
        _entry(
            "iron_nodular",
            "Nodular cast iron (EN-GJS-400-15)",
            "cast_iron",
            (173.0, 0.3),
            _ISO_6336_2,
            strength=_strength(400, 250, 30, "EN 1563; as in iron-foundry.com and MITCalc"),
        ),
        _entry(
            "bronze_tin",
            "Tin bronze, sand cast (CuSn12-C-GS)",
            "bronze",
            (88.3, 0.35),
            _WORM,
            density=(8700.0, "Finkelstein Metals CC483K and public tables"),
        ),
        _entry(
            "bronze_tin_centrifugal",
            "Tin bronze, centrifugally cast (CuSn12-C-GZ)",
            "bronze",
            (88.3, 0.35),
            _WORM,
            _limit("endurance_mean", 425.0, "iso_14521"),
            strength=_strength(280, 150, None, "EN 1982; as in MITCalc and Metalurgija"),
            density=(8700.0, "Finkelstein Metals CC483K and public tables"),
        ),
        _entry(
            "bronze_tin_nickel",
            "Tin-nickel bronze, centrifugally cast (CuSn12Ni2-C-GZ)",
            "bronze",
            (98.1, 0.35),
            _WORM,
            strength=_strength(300, 180, None, "EN 1982, table 21; as in symetal.kr and MITCalc"),
            density=(8600.0, "Kemper, CuSn12Ni2-C; MakeItFrom, within 2 %"),
        ),
        _entry(
            "bronze_aluminium",
            "Aluminium bronze, centrifugally cast (CuAl10Fe5Ni5-C-GZ)",
            "bronze",
            (122.6, 0.35),
            _WORM,
            density=(7600.0, "two public tables"),
        ),
        _entry(
            "brass",
            "Brass (CuZn39Pb3)",
            "brass",
            (97.0, 0.34),
            "Copper Development Association, data sheet of CW614N",
            strength=_strength(410, 200, 14, "R410: Aurubis and EN 12164 tables, the lower yield"),
        ),
        _entry(
            "plastic_pom",
            "Acetal (POM-C)",
            "plastic",
            (2.8, 0.35),
            f"{_DATA_SHEETS}, short time",
            strength=_strength(None, 61, None, "TECAFORM AH and Penn Fibre, 23 degrees C"),
            density=(1400.0, "TECAFORM AH and Delrin data sheets, 1390 to 1410"),
        ),
        _entry(
            "plastic_pa66",
            "Polyamide 66, conditioned",
            "plastic",
            (1.4, 0.4),
            "Zytel 103HSL, 23 degrees C, 50 % humidity, short time: one data sheet only",
            density=(1140.0, "Academic Press Encyclopedia; public gear material tables"),
        ),
        _entry(
            "plastic_pa66_gf30",
            "Polyamide 66, 30 % glass, conditioned",
            "plastic",
            (7.0, 0.36),
            f"{_DATA_SHEETS}, 50 % humidity",
        ),
        _entry(
            "plastic_peek",
            "PEEK, unfilled",
            "plastic",
            (3.7, 0.38),
            _DATA_SHEETS,
            strength=_strength(97, None, None, "Victrex 450G and MakeItFrom, 23 degrees C"),
            density=(1300.0, "Victrex 450G and Wikipedia, 1300 to 1320"),
        ),
    )
}
"""The table of materials by name. A limit or a strength stands here where its standard was read or
two independent secondary sources give it; else it is not known."""
