"""The table of materials and the names by which they are found."""

import re
from dataclasses import replace

from core.contact_life import LifeCurve
from core.hertz import ContactLimit, Criterion
from core.materials import ELASTIC, Fact, Range, Seen, Strength, TableMaterial

LIFE_CURVES: dict[str, LifeCurve] = {
    "iso_6336_5": "hardened",
    "iso_6336_5_hardness": "hardened",
    "iso_6336_5_normalized": "hardened",
}
"""Life curves of limits for many loads, by the source of the limit."""


def _limit(criterion: Criterion, pressure_MPa: float, source: str) -> ContactLimit:
    return ContactLimit(criterion, pressure_MPa * 1e6, source, LIFE_CURVES.get(source))


def _strength(source: str, **known: float) -> Strength:
    """Strength from `tensile_MPa`, `yield_MPa` and the `size_mm` up to which both hold."""
    units = {
        "tensile_MPa": ("tensile", 1e6),
        "yield_MPa": ("yield_strength", 1e6),
        "size_mm": ("valid_diameter", 1e-3),
    }
    own = {name: known[given] * unit for given, (name, unit) in units.items() if given in known}
    return Strength(**own, source=source)


def _entry(
    name: str,
    title: str,
    group: str,
    moduli: tuple[float, ...],
    source: str,
    *limits: ContactLimit,
    strength: Strength | None = None,
    density: tuple[float, str] | None = None,
    hardened: bool = False,
    **facts: Fact,
) -> TableMaterial:
    units = zip(ELASTIC, moduli, (1e9, 1.0), strict=False)
    density_kg_m3, weighed = density or (None, "")
    return TableMaterial(
        name,
        title,
        group,
        {name: value * unit for name, value, unit in units},
        source,
        limits,
        strength or Strength(),
        density_kg_m3,
        weighed,
        hardened,
        facts=facts,
    )


def _printed(
    name: str,
    title: str,
    moduli: tuple[float, ...],
    source: str,
    *,
    density: tuple[float, str],
    strength_in_plane: Fact,
    layered: bool = True,
    **facts: Fact,
) -> TableMaterial:
    """Printed plastic; a strength with one source only is for reference."""
    sure, strength = strength_in_plane.seen == "two", Strength()
    if sure:
        least, source = strength_in_plane.spread.low, strength_in_plane.source
        strength = Strength(yield_strength=least, source=source)
    entry = _entry(
        name, title, "plastic_printed", moduli, source, strength=strength, density=density
    )
    return replace(entry, layered=layered, facts={"strength_in_plane": strength_in_plane, **facts})


def _GPa(value: float, low: float, high: float, source: str, seen: Seen = "two") -> Range:  # noqa: N802
    return Range(value * 1e9, source, low * 1e9, high * 1e9, seen=seen)


def _MPa(value: float, low: float, high: float, source: str, seen: Seen = "two") -> Range:  # noqa: N802
    return Range(value * 1e6, source, low * 1e6, high * 1e6, seen=seen)


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
            strength=_strength(
                "EN 10025-2; as in readle.co.uk and Five Steel Pipe",
                tensile_MPa=360,
                yield_MPa=225,
                size_mm=40,
            ),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_s355",
            "Structural steel (S355J2)",
            "steel",
            (210.0, 0.3),
            "EN 1993-1-1, 3.2.6",
            _limit("endurance", 160 + 190, "iso_6336_5_normalized"),
            strength=_strength(
                "EN 10025-2; as in readle.co.uk and Five Steel Pipe",
                tensile_MPa=470,
                yield_MPa=345,
                size_mm=40,
            ),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_through_hardened",
            "Through-hardened alloy steel (42CrMo4, 300 HV)",
            "steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _limit("endurance", 1.313 * 300 + 188, "iso_6336_5_hardness"),
            strength=_strength(
                "EN 10083-3; as in Saarstahl and Key to Metals",
                tensile_MPa=900,
                yield_MPa=650,
                size_mm=100,
            ),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_c45",
            "Carbon steel, normalized (C45 +N)",
            "steel",
            (206.0, 0.3),
            _ISO_6336_2,
            _limit("endurance", 175 + 190, "iso_6336_5_normalized"),
            strength=_strength(
                "EN 10083-2; as in Saarstahl and Lucefin",
                tensile_MPa=580,
                yield_MPa=305,
                size_mm=100,
            ),
            density=_STEEL_DENSITY,
        ),
        _entry(
            "steel_bolt",
            "Bolt steel, class 8.8",
            "steel",
            (206.0, 0.3),
            _ISO_6336_2,
            strength=_strength(
                "ISO 898-1; as in BBS Halmstad and usefastener.com",
                tensile_MPa=800,
                yield_MPa=640,
                size_mm=16,
            ),
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
            strength=_strength(
                "Lucefin 100Cr6, tempered at 150 to 200 degrees C, 2420 to 2500; Metals 15 (2025) "
                "931, 2600",
                tensile_MPa=2400,
                size_mm=17,
            ),
            density=_STEEL_DENSITY,
            hardened=True,
        ),
        _entry(
            "iron_grey",
            "Grey cast iron (EN-GJL-250)",
            "cast_iron",
            (118.0, 0.3),
            _ISO_6336_2,
            strength=_strength(
                "EN 1561; as in modelleriazuin.it, iron-foundry.com", tensile_MPa=195, size_mm=40
            ),
            density=(7200.0, "two public tables, 7200 and 7250"),
            youngs_modulus=_GPa(118, 98, 118, f"{_ISO_6336_2}; MITCalc has 98"),
        ),
        _entry(
            "iron_nodular",
            "Nodular cast iron (EN-GJS-400-15)",
            "cast_iron",
            (173.0, 0.3),
            _ISO_6336_2,
            strength=_strength(
                "EN 1563; as in iron-foundry.com and MITCalc",
                tensile_MPa=400,
                yield_MPa=250,
                size_mm=30,
            ),
        ),
        _entry(
            "aluminium_6061_t6",
            "Aluminium 6061-T6",
            "aluminium",
            (68.9, 0.33),
            "Aluminum Association, as in MatWeb",
            strength=_strength(
                "least, 38 and 35 ksi: 49 CFR 178.46, table 2", tensile_MPa=262, yield_MPa=241
            ),
            density=(2700.0, "Aluminum Association, as in MatWeb"),
            yield_strength=_MPa(241, 241, 276, "49 CFR 178.46; usual: Aluminum Association"),
        ),
        _entry(
            "aluminium_6082_t6",
            "Aluminium 6082-T6",
            "aluminium",
            (70.0, 0.33),
            "MakeItFrom and DIN 1725 tables, 69 to 71 GPa",
            strength=_strength(
                "guaranteed, walls below 5 mm: APAC; DIN 1725", tensile_MPa=290, yield_MPa=250
            ),
            density=(2700.0, "MakeItFrom and APAC"),
            youngs_modulus=_GPa(70, 69, 71, "MakeItFrom and DIN 1725 tables"),
            yield_strength=_MPa(250, 250, 260, "APAC: below and above 5 mm of wall; DIN 1725"),
        ),
        _entry(
            "aluminium_7075_t6",
            "Aluminium 7075-T6",
            "aluminium",
            (71.7, 0.33),
            "Wikipedia and ASM tables",
            strength=_strength(
                "least: Wikipedia 7075, 510 to 540 and 430 to 480", tensile_MPa=510, yield_MPa=430
            ),
            density=(2810.0, "Wikipedia, SubsTech and ASM tables"),
            yield_strength=_MPa(430, 430, 503, "Wikipedia; usual: SubsTech and ASM tables"),
        ),
        _entry(
            "bronze_c93200",
            "Bearing bronze C93200 (SAE 660, CC493K, Rg7)",
            "bronze",
            (),
            "no source of two was found",
            strength=_strength(
                "least: Dura-Bar Metals and Diversified Bronze", tensile_MPa=241, yield_MPa=138
            ),
            density=(8910.0, "Dura-Bar Metals and Diversified Bronze"),
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
            strength=_strength(
                "EN 1982; as in MITCalc and Metalurgija", tensile_MPa=280, yield_MPa=150
            ),
            density=(8700.0, "Finkelstein Metals CC483K and public tables"),
        ),
        _entry(
            "bronze_tin_nickel",
            "Tin-nickel bronze, centrifugally cast (CuSn12Ni2-C-GZ)",
            "bronze",
            (98.1, 0.35),
            _WORM,
            strength=_strength(
                "EN 1982, table 21; as in symetal.kr and MITCalc", tensile_MPa=300, yield_MPa=180
            ),
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
            strength=_strength(
                "R410: Aurubis and EN 12164 tables, the lower yield",
                tensile_MPa=410,
                yield_MPa=200,
                size_mm=14,
            ),
        ),
        _entry(
            "plastic_pom",
            "Acetal (POM-C)",
            "plastic",
            (2.8, 0.35),
            f"{_DATA_SHEETS}, short time",
            strength=_strength("TECAFORM AH and Penn Fibre, 23 degrees C", yield_MPa=61),
            density=(1400.0, "TECAFORM AH and Delrin data sheets, 1390 to 1410"),
            youngs_modulus=_GPa(2.8, 2.6, 3.1, "TECAFORM AH, Penn Fibre and Delrin data sheets"),
            yield_strength=_MPa(61, 61, 67, "TECAFORM AH and Penn Fibre, 61 to 67"),
            friction=Fact(0.2, "VDI 2736, dry on steel, as in GEARpie", seen="one"),
        ),
        _entry(
            "plastic_pa66",
            "Polyamide 66, conditioned",
            "plastic",
            (1.4, 0.4),
            "Zytel 103HSL, 23 degrees C, 50 % humidity, short time: one data sheet only",
            density=(1140.0, "Academic Press Encyclopedia; public gear material tables"),
            friction=Fact(0.2, "VDI 2736, dry on steel, as in GEARpie", seen="one"),
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
            strength=_strength("Victrex 450G and MakeItFrom, 23 degrees C", tensile_MPa=97),
            density=(1300.0, "Victrex 450G and Wikipedia, 1300 to 1320"),
            youngs_modulus=_GPa(3.7, 3.6, 4.0, "Victrex 450G, Wikipedia and MakeItFrom"),
            yield_strength=_MPa(97, 97, 100, "Victrex 450G and MakeItFrom, 97 to 100"),
        ),
        _printed(
            "plastic_pla_printed",
            "PLA, printed",
            (3.0, 0.36),
            "PolyTerra (Polymaker 2023), Stratasys, CR-3D, Flexiwire data sheets; "
            "Poisson's ratio: SD3D, as in FreeCAD",
            density=(1240.0, "CR-3D and SD3D data sheets; filled up to 1310"),
            youngs_modulus=_GPa(
                3.0, 1.6, 3.6, "PolyTerra 1.6 and 2.0, Stratasys 2.5 to 3.0, CR-3D 3.5, SD3D 3.6"
            ),
            poissons_ratio=Fact(0.36, "SD3D, as in FreeCAD", seen="one"),
            strength_in_plane=_MPa(
                45,
                23,
                65,
                "PolyTerra (Polymaker 2023) 23.2; Stratasys 26, 45; Flexiwire 60; "
                "additive.tools 50–65",
            ),
            strength_across=_MPa(12, 12, 45, "PolyTerra (Polymaker 2023) 12.2", "one"),
            softening=Range(51.0, "Stratasys 51, PolyTerra 52: HDT under 1.8 MPa", 51.0, 52.0),
            friction=Range(
                0.2,
                "running pairs: three printed drives, efficiencies of 66, 61.8 and 70 %, by their "
                "losses",
                0.15,
                0.35,
            ),
            dry_friction=Range(
                0.76, "Materials Science-Poland 43 (2025), dry", 0.62, 0.76, seen="one"
            ),
            wear_rate=Range(
                4.4e-13, "from Materials Science-Poland 43 (2025), dry", 1e-13, 4.4e-13, seen="one"
            ),
        ),
        _printed(
            "plastic_petg_printed",
            "PETG, printed",
            (2.1,),
            "CR-3D, designerdata.nl; no source of Poisson's ratio was found",
            density=(1270.0, "CR-3D and Polydx"),
            youngs_modulus=_GPa(2.1, 2.0, 3.0, "designerdata.nl 2.0, CR-3D 3.0"),
            strength_in_plane=_MPa(44, 44, 56, "additive.tools, a compilation", "one"),
            strength_across=_MPa(25, 25, 38, "additive.tools, a compilation", "one"),
            softening=Range(69.0, "Polydx 69: HDT under 1.8 MPa; CR-3D 78", 69.0, 78.0),
        ),
        _printed(
            "plastic_abs_printed",
            "ABS, printed",
            (2.4, 0.37),
            "Stratasys ABS-M30, CR-3D, Kimya; Poisson's ratio: MatWeb, as in FreeCAD",
            density=(1050.0, "CR-3D and CCT Precision"),
            youngs_modulus=_GPa(2.4, 1.4, 2.5, "Kimya 1.4, CR-3D 2.4, Stratasys ABS-M30 2.4"),
            poissons_ratio=Fact(0.37, "MatWeb, as in FreeCAD", seen="one"),
            strength_in_plane=_MPa(
                35, 33, 40, "Stratasys ABS-M30 33 and 36, Kimya 34.5 and 35.3, CR-3D 40"
            ),
            softening=Range(90.0, "hyiger FDM 90 to 98, CR-3D 95, CCT Precision 104", 90.0, 104.0),
            friction=Fact(0.35, "CCT Precision, moulded, dry on steel", seen="one"),
        ),
        _printed(
            "plastic_pc_printed",
            "Polycarbonate, printed",
            (2.2, 0.37),
            "additive.tools, Wohlers 2011 (moulded); Poisson's ratio: Wikipedia, as in FreeCAD",
            density=(1200.0, "additive.tools; Wikipedia, as in FreeCAD"),
            youngs_modulus=_GPa(2.2, 2.0, 3.0, "additive.tools 2 to 3, Wohlers 2.3, FreeCAD 2.2"),
            poissons_ratio=Fact(0.37, "Wikipedia, as in FreeCAD", seen="one"),
            strength_in_plane=_MPa(58, 58, 75, "additive.tools, a compilation", "one"),
            strength_across=_MPa(35, 35, 52, "additive.tools, a compilation", "one"),
        ),
        _printed(
            "plastic_pa12_sintered",
            "Polyamide 12, sintered (MJF, SLS)",
            (1.7, 0.43),
            "HP 3D High Reusability PA 12, 3D Systems; Poisson's ratio: HP",
            density=(1000.0, "HP 1010, additive.tools 880 to 1010"),
            layered=False,
            youngs_modulus=_GPa(1.7, 1.4, 1.8, "3D Systems 1.4, HP 1.8"),
            poissons_ratio=Range(0.43, "HP: 0.43 to 0.47", 0.43, 0.47, seen="one"),
            strength_in_plane=_MPa(
                48, 43, 54, "3D Systems 43, HP 48 in either direction, additive.tools 44 to 54"
            ),
        ),
        _printed(
            "plastic_pa_cf_printed",
            "Polyamide with carbon fibres, printed (PA6-CF, PA12-CF)",
            (7.5,),
            "CR-3D 2022 and 2025, which differ; no source of Poisson's ratio was found",
            density=(1190.0, "CR-3D, PA6-CF; PA12-CF 1080"),
            youngs_modulus=_GPa(7.5, 7.4, 14.2, "CR-3D: 7.5 in 2025, 14.2 in 2022", "one"),
            strength_in_plane=_MPa(90, 90, 105, "CR-3D, of the filament's material", "one"),
            strength_across=_MPa(36, 36, 36, "one private test of PA612-CF", "one"),
            softening=Range(140.0, "CR-3D: 140 in 2025, 190 in 2022", 140.0, 190.0, seen="one"),
        ),
    )
}
"""Materials by name. A limit or a strength is listed if its standard was read or two independent
secondary sources give it; otherwise it is unknown."""


ALIASES: dict[str, tuple[str, ...]] = {
    "steel_structural": ("S235", "S235JR"),
    "steel_s355": ("S355", "S355J2"),
    "steel_through_hardened": ("42CrMo4", "4140"),
    "steel_c45": ("C45", "1045"),
    "steel_bolt": ("8.8",),
    "steel_case_hardened": ("18CrNiMo7-6", "16MnCr5", "20MnCr5"),
    "steel_bearing": ("100Cr6", "GCr15", "SUJ2", "52100"),
    "iron_grey": ("GJL-250",),
    "iron_nodular": ("GJS-400-15",),
    "aluminium_6061_t6": ("6061", "6061-T6"),
    "aluminium_6082_t6": ("6082", "6082-T6"),
    "aluminium_7075_t6": ("7075", "7075-T6"),
    "bronze_c93200": ("C93200", "SAE 660", "CC493K", "Rg7"),
    "brass": ("CuZn39Pb3",),
    "plastic_pom": ("POM", "POM-C", "acetal"),
    "plastic_pa66": ("PA66",),
    "plastic_pa66_gf30": ("PA66-GF30",),
    "plastic_peek": ("PEEK",),
    "plastic_pla_printed": ("PLA", "plastic_pla"),
    "plastic_petg_printed": ("PETG", "plastic_petg"),
    "plastic_abs_printed": ("ABS", "plastic_abs"),
    "plastic_pc_printed": ("PC", "plastic_pc"),
    "plastic_pa12_sintered": ("PA12", "MJF PA12", "SLS PA12"),
    "plastic_pa_cf_printed": ("PA-CF", "PA6-CF", "PA12-CF", "Onyx"),
}
"""Other names by which materials are found."""

SEVERAL: dict[str, tuple[str, ...]] = {
    "nylon": ("plastic_pa12_sintered", "plastic_pa66"),
    "polyamide": ("plastic_pa12_sintered", "plastic_pa66"),
    "PLA+": ("plastic_pla_printed",),
    "Delrin": ("plastic_pom",),
    "resin": (),
    "steel": ("steel_structural", "steel_through_hardened", "steel_bearing"),
    "aluminium": ("aluminium_6061_t6", "aluminium_6082_t6", "aluminium_7075_t6"),
    "aluminum": ("aluminium_6061_t6", "aluminium_6082_t6", "aluminium_7075_t6"),
    "stainless": (),
}
"""Names that are too general, with the materials of the table that they may stand for."""

ELASTOMERS = ("TPU", "TPE", "rubber")
"""Names of materials whose contact is not calculated, as they stretch by their own length."""


def plain_name(name: str) -> str:
    """Name without case, blanks, underscores and dashes, for comparison.

    >>> plain_name("6061-T6"), plain_name("SAE 660")
    ('6061t6', 'sae660')
    """
    return re.sub(r"[\s_-]+", "", name.casefold())


NAMES = {plain_name(each): name for name in MATERIALS for each in (name, *ALIASES.get(name, ()))}
"""Names in the table, by every name as `plain_name` has it."""
