"""Elastic materials of pins, holes, rollers and shafts, and what two of them make together."""

from dataclasses import dataclass
from typing import Literal

from core.arrays import Number, check_positive, every, refuse

Criterion = Literal["endurance", "static", "given"]
"""What a limit of the contact pressure guards against: pitting in the long run, a permanent set
under a load at rest, or what whoever gave it has in mind."""


@dataclass(frozen=True, slots=True)
class ContactLimit:
    """Limit of the contact pressure of a material, by one criterion.

    Attributes
    ----------
    criterion : Criterion
        What it guards against.
    pressure : float or array
        The limit, Pa, > 0; NaN in an array where none is known.
    source : str
        Where it comes from.
    """

    criterion: Criterion
    pressure: Number
    source: str = ""


@dataclass(frozen=True, slots=True)
class ElasticMaterial:
    """Isotropic elastic material, of one body or of an array of them.

    Attributes
    ----------
    youngs_modulus : float or array
        Young's modulus E, Pa, > 0.
    poissons_ratio : float or array
        Poisson's ratio, 0 <= v < 0.5.
    limit : ContactLimit, optional
        What its contact pressure is judged by; None where nothing is known.
    """

    youngs_modulus: Number
    poissons_ratio: Number
    limit: ContactLimit | None = None

    def __post_init__(self) -> None:
        check_positive(youngs_modulus=self.youngs_modulus)
        check_poissons_ratio(self.poissons_ratio)

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
    allowed = (poissons_ratio >= 0) & (poissons_ratio < 0.5)
    if not every(allowed):
        refuse("poissons_ratio", poissons_ratio, allowed, "must be at least 0 and below 0.5")


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


@dataclass(frozen=True, slots=True)
class TableMaterial:
    """A material of the table.

    Attributes
    ----------
    name : str
        Stable name, for programs.
    title : str
        Name for people.
    group : str
        Kind of material.
    material : ElasticMaterial
        Its values at room temperature, judged by its endurance limit where it has one.
    limits : tuple of ContactLimit
        Limits of its contact pressure, at most one for each criterion.
    source : str
        Where the elastic values come from.
    """

    name: str
    title: str
    group: str
    material: ElasticMaterial
    limits: tuple[ContactLimit, ...]
    source: str


def _entry(
    name: str,
    title: str,
    group: str,
    moduli: tuple[float, float],
    source: str,
    *limits: ContactLimit,
) -> TableMaterial:
    modulus_GPa, ratio = moduli
    endurance = next((each for each in limits if each.criterion == "endurance"), None)
    material = ElasticMaterial(modulus_GPa * 1e9, ratio, endurance)
    return TableMaterial(name, title, group, material, limits, source)


def _endurance(pressure_MPa: float, source: str) -> ContactLimit:
    return ContactLimit("endurance", pressure_MPa * 1e6, source)


_ISO_6336_2 = "ISO 6336-2, table of elasticity factors"
_WORM = "ISO/TR 14521 (DIN 3996), worm wheel materials"
_WORM_PITTING = f"{_WORM}: pitting against hardened steel, of the mean pressure"

MATERIALS: dict[str, TableMaterial] = {
    entry.name: entry
    for entry in (
        _entry(
            "steel_structural",
            "Structural steel (S235, S355)",
            "Steel",
            (210.0, 0.3),
            "EN 1993-1-1, 3.2.6",
        ),
        _entry(
            "steel_through_hardened",
            "Through-hardened alloy steel (42CrMo4, 300 HV)",
            "Steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _endurance(1.313 * 300 + 373, "ISO 6336-5, pitting, grade MQ: 1.313*HV + 373"),
        ),
        _entry(
            "steel_case_hardened",
            "Case-hardened steel (18CrNiMo7-6)",
            "Steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _endurance(1500.0, "ISO 6336-5, pitting, grade MQ"),
        ),
        _entry(
            "steel_bearing",
            "Bearing steel (100Cr6, hardened)",
            "Steel",
            (207.0, 0.3),
            "ISO/TS 16281",
            _endurance(1500.0, "ISO 281:2007, fatigue load limit; clean and well lubricated"),
            ContactLimit("static", 4000e6, "ISO 76, roller bearings: permanent set of 1e-4*D"),
        ),
        _entry("iron_grey", "Grey cast iron (EN-GJL-250)", "Cast iron", (118.0, 0.3), _ISO_6336_2),
        _entry(
            "iron_nodular",
            "Nodular cast iron (EN-GJS-400-15)",
            "Cast iron",
            (173.0, 0.3),
            _ISO_6336_2,
        ),
        _entry(
            "bronze_tin",
            "Tin bronze, centrifugally cast (CuSn12-C-GZ)",
            "Bronze",
            (88.3, 0.35),
            _WORM,
            _endurance(425.0, _WORM_PITTING),
        ),
        _entry(
            "bronze_tin_nickel",
            "Tin-nickel bronze, centrifugally cast (CuSn12Ni2-C-GZ)",
            "Bronze",
            (98.1, 0.35),
            _WORM,
            _endurance(520.0, _WORM_PITTING),
        ),
        _entry(
            "bronze_aluminium",
            "Aluminium bronze, centrifugally cast (CuAl10Fe5Ni5-C-GZ)",
            "Bronze",
            (122.6, 0.35),
            _WORM,
            _endurance(660.0, _WORM_PITTING),
        ),
        _entry(
            "brass",
            "Brass (CuZn39Pb3)",
            "Brass",
            (97.0, 0.34),
            "Copper Development Association, data sheet of CW614N",
        ),
        _entry(
            "plastic_pom",
            "Acetal (POM-C)",
            "Plastic",
            (2.8, 0.35),
            "typical of data sheets, 23 degrees C, short time",
        ),
        _entry(
            "plastic_pa66",
            "Polyamide 66, conditioned",
            "Plastic",
            (1.7, 0.4),
            "typical of data sheets, 23 degrees C, 50 % humidity, short time",
        ),
        _entry(
            "plastic_pa66_gf30",
            "Polyamide 66, 30 % glass, conditioned",
            "Plastic",
            (7.0, 0.36),
            "typical of data sheets, 23 degrees C, 50 % humidity",
        ),
        _entry(
            "plastic_peek",
            "PEEK, unfilled",
            "Plastic",
            (3.7, 0.38),
            "typical of data sheets, 23 degrees C",
        ),
    )
}
"""The table of materials by name."""
