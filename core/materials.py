"""Elastic materials of pins, holes, rollers and shafts, and what two of them make together."""

from dataclasses import dataclass

from core.errors import InvalidInput


@dataclass(frozen=True, slots=True)
class ElasticMaterial:
    """Isotropic elastic material.

    Attributes
    ----------
    youngs_modulus : float
        Young's modulus E, Pa, > 0.
    poissons_ratio : float
        Poisson's ratio, 0 <= v < 0.5.
    allowable_pressure : float, optional
        Allowable contact pressure, Pa, where a source gives one.
    """

    youngs_modulus: float
    poissons_ratio: float
    allowable_pressure: float | None = None

    def __post_init__(self) -> None:
        if not self.youngs_modulus > 0:
            raise InvalidInput("youngs_modulus", self.youngs_modulus, "must be larger than 0")
        if not 0 <= self.poissons_ratio < 0.5:
            raise InvalidInput(
                "poissons_ratio", self.poissons_ratio, "must be at least 0 and below 0.5"
            )

    @property
    def plane_modulus(self) -> float:
        """Modulus in plane strain ``E/(1 - v^2)``, Pa."""
        return self.youngs_modulus / ((1 - self.poissons_ratio) * (1 + self.poissons_ratio))

    @property
    def shear_modulus(self) -> float:
        """Shear modulus ``G = E/(2*(1 + v))``, Pa."""
        return self.youngs_modulus / (2 * (1 + self.poissons_ratio))


def effective_modulus(*, first: ElasticMaterial, second: ElasticMaterial) -> float:
    """Effective modulus of two bodies in contact: ``1/E* = (1 - v1^2)/E1 + (1 - v2^2)/E2``.

    Parameters
    ----------
    first, second : ElasticMaterial
        The two materials.

    Returns
    -------
    float
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


def lower_allowable_pressure(*materials: ElasticMaterial) -> float | None:
    """Smallest allowable contact pressure that is known of some materials.

    Parameters
    ----------
    *materials : ElasticMaterial
        The materials.

    Returns
    -------
    float or None
        Allowable pressure, Pa; None where none is known.
    """
    known = [each.allowable_pressure for each in materials if each.allowable_pressure is not None]
    return min(known, default=None)


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
        Its values at room temperature.
    source : str
        Where the values come from, and what an allowable pressure allows.
    """

    name: str
    title: str
    group: str
    material: ElasticMaterial
    source: str


def _entry(
    name: str,
    title: str,
    group: str,
    moduli: tuple[float, float],
    source: str,
    allowable_MPa: float | None = None,
) -> TableMaterial:
    modulus_GPa, ratio = moduli
    pressure = None if allowable_MPa is None else allowable_MPa * 1e6
    return TableMaterial(
        name, title, group, ElasticMaterial(modulus_GPa * 1e9, ratio, pressure), source
    )


_ISO_6336_2 = "E and v: ISO 6336-2, table of elasticity factors"
_WORM = "ISO/TR 14521 (DIN 3996), worm wheel materials; pitting strength against hardened steel"

MATERIALS: dict[str, TableMaterial] = {
    entry.name: entry
    for entry in (
        _entry(
            "steel_structural",
            "Structural steel (S235, S355)",
            "Steel",
            (210.0, 0.3),
            "E and v: EN 1993-1-1, 3.2.6",
        ),
        _entry(
            "steel_through_hardened",
            "Through-hardened alloy steel (42CrMo4, 300 HV)",
            "Steel",
            (206.0, 0.3),
            f"{_ISO_6336_2}; pitting strength: ISO 6336-5, grade MQ, 1.313*HV + 373 at 300 HV",
            1.313 * 300 + 373,
        ),
        _entry(
            "steel_case_hardened",
            "Case-hardened steel (18CrNiMo7-6)",
            "Steel",
            (206.0, 0.3),
            f"{_ISO_6336_2}; pitting strength: ISO 6336-5, grade MQ",
            1500.0,
        ),
        _entry(
            "steel_bearing",
            "Bearing steel (100Cr6, hardened)",
            "Steel",
            (207.0, 0.3),
            "E and v: ISO/TS 16281; static contact pressure of roller bearings: ISO 76",
            4000.0,
        ),
        _entry("iron_grey", "Grey cast iron (EN-GJL-250)", "Cast iron", (118.0, 0.3), _ISO_6336_2),
        _entry(
            "iron_nodular",
            "Nodular cast iron (EN-GJS-400-15)",
            "Cast iron",
            (173.0, 0.3),
            _ISO_6336_2,
        ),
        _entry("bronze_tin", "Tin bronze (CuSn12-C)", "Bronze", (88.3, 0.35), _WORM, 425.0),
        _entry(
            "bronze_tin_nickel",
            "Tin-nickel bronze (CuSn12Ni2-C)",
            "Bronze",
            (98.1, 0.35),
            _WORM,
            520.0,
        ),
        _entry(
            "bronze_aluminium",
            "Aluminium bronze (CuAl10Fe5Ni5-C)",
            "Bronze",
            (122.6, 0.35),
            _WORM,
            660.0,
        ),
        _entry(
            "brass",
            "Brass (CuZn39Pb3)",
            "Brass",
            (97.0, 0.34),
            "E and v: Copper Development Association, data sheet of CW614N",
        ),
        _entry(
            "plastic_pom",
            "Acetal (POM-C)",
            "Plastic",
            (2.8, 0.35),
            "E and v: typical of data sheets, 23 degrees C, short time",
        ),
        _entry(
            "plastic_pa66",
            "Polyamide 66, conditioned",
            "Plastic",
            (1.7, 0.4),
            "E and v: typical of data sheets, 23 degrees C, 50 % humidity, short time",
        ),
        _entry(
            "plastic_pa66_gf30",
            "Polyamide 66, 30 % glass, conditioned",
            "Plastic",
            (7.0, 0.36),
            "E and v: typical of data sheets, 23 degrees C, 50 % humidity",
        ),
        _entry(
            "plastic_peek",
            "PEEK, unfilled",
            "Plastic",
            (3.7, 0.38),
            "E and v: typical of data sheets, 23 degrees C",
        ),
    )
}
"""The table of materials by name."""
