"""The table of materials and the names by which they are found.

`material_tables/materials.csv` has a material in each row: E in GPa, strengths in MPa up to a size
in mm, density in kg/m^3. Its limits of the contact pressure are criterion, MPa and source of each
(a key of `core.hertz.LIMIT_SOURCES`), its names those by which it is found besides its own.
`material_tables/facts.csv` has properties with one source only (`seen`), or on which sources
differ: moduli in GPa, strengths in MPa. A limit or a strength is listed if its standard was read or
two independent secondary sources give it; otherwise it is unknown.
"""

import csv
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from core.contact_life import LifeCurve
from core.hertz import ContactLimit, Criterion
from core.materials import ELASTIC, Fact, Range, Seen, Strength, TableMaterial

TABLES = Path(__file__).parent / "material_tables"
"""Folder of the tables."""

LIFE_CURVES: dict[str, LifeCurve] = {
    "iso_6336_5": "hardened",
    "iso_6336_5_hardness": "hardened",
    "iso_6336_5_normalized": "hardened",
}
"""Life curves of limits for many loads, by the source of the limit."""

UNITS = {
    "youngs_modulus": 1e9,
    "yield_strength": 1e6,
    "strength_in_plane": 1e6,
    "strength_across": 1e6,
}
"""Units of the facts that are not in SI units, by name."""


def _rows(table: str) -> Iterator[dict[str, str]]:
    with open(TABLES / table, newline="", encoding="utf-8") as rows:
        yield from csv.DictReader(rows)


def _number(said: str, unit: float = 1.0) -> float | None:
    return float(said) * unit if said else None


def _fact(row: dict[str, str]) -> Fact:
    unit, seen = UNITS.get(row["fact"], 1.0), cast(Seen, row["seen"])
    value, source = float(row["value"]) * unit, row["source"]
    if not row["low"]:
        return Fact(value, source, seen=seen)
    return Range(value, source, float(row["low"]) * unit, float(row["high"]) * unit, seen=seen)


def _limits(said: str) -> Iterator[ContactLimit]:
    each: Any = zip(*[iter(said.split())] * 3, strict=True)
    for criterion, pressure, source in each:
        yield ContactLimit(
            cast(Criterion, criterion), float(pressure) * 1e6, source, LIFE_CURVES.get(source)
        )


def _material(row: dict[str, str], facts: dict[str, Fact]) -> TableMaterial:
    """Material of a row; a strength of a printed plastic with one source only is for reference."""
    moduli = _number(row["E_GPa"], 1e9), _number(row["v"])
    strength = Strength(
        _number(row["Rm_MPa"], 1e6),
        _number(row["Re_MPa"], 1e6),
        _number(row["size_mm"], 1e-3),
        row["strength_source"],
    )
    printed = facts.get("strength_in_plane")
    if printed and printed.seen == "two":
        strength = Strength(yield_strength=printed.spread.low, source=printed.source)
    return TableMaterial(
        row["name"],
        row["title"],
        row["group"],
        {name: each for name, each in zip(ELASTIC, moduli, strict=True) if each is not None},
        row["source"],
        tuple(_limits(row["limits"])),
        strength,
        _number(row["kg_m3"]),
        row["density_source"],
        hardened=row["hardened"] == "yes",
        layered=row["layered"] == "yes",
        facts=facts,
    )


_FACTS: dict[str, dict[str, Fact]] = {}
for _row in _rows("facts.csv"):
    _FACTS.setdefault(_row["material"], {})[_row["fact"]] = _fact(_row)

MATERIALS: dict[str, TableMaterial] = {}
"""Materials by name."""

ALIASES: dict[str, tuple[str, ...]] = {}
"""Other names by which materials are found."""

for _row in _rows("materials.csv"):
    MATERIALS[_row["name"]] = _material(_row, _FACTS.get(_row["name"], {}))
    if _row["names"]:
        ALIASES[_row["name"]] = tuple(_row["names"].split(", "))

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
