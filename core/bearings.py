"""Rolling bearings by name: sizes, mass, and load ratings as several makers state them.

Each series has a table in `bearing_tables`. The first column names the bearings and is headed by
their series; two that share their ratings stand in one row. `d`, `D` and `B` are in mm, `kg` is the
mass by the maker in `of`. The column of a maker has C and C0 in N; `-ZZ` after the maker says that
they hold for shielded bearings only.
"""

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Literal

from core.fields import answer, answered

TABLES = Path(__file__).parent / "bearing_tables"
"""Folder of the tables."""

MAKERS = {
    "FBJ": "FBJ catalogue",
    "INA": "INA Machined needle roller bearings, TPI 117, April 2005",
    "ISB": "ISB catalogue, kN to 0.01",
    "Koyo": "Koyo standard bearings, CAT. NO. B2001, kN to 0.01",
    "NKE": "NKE General Catalogue, 2018/10",
    "NMB": "NMB ball bearings catalogue, by their own names",
    "NSK": "NSK Rolling Bearings, CAT. No. E1102e",
    "NTN": "NTN Ball and Roller Bearings, CAT. NO. 2202; Needle Roller Bearings, CAT. NO. 2300",
    "SKF": "SKF Rolling bearings, PUB BU/P1 17000/1 EN, October 2018",
    "ZEN": "ZEN standard catalogue, V.10/12",
}
"""Catalogue that the ratings of each maker were read in."""

SUFFIXES = r"(?:ZZ|Z|2Z|RS|2RS|2RS1|2RSR|2RSH|DD|VV|DDU|LLU|LLB|OPEN)?"
"""Suffixes of bearing names for shields and seals, which change no rating here."""

SPELLINGS = (
    (rf"((?:MR)?\d+(?:/\d\d)?)[- ]?{SUFFIXES}", r"\1"),
    (rf"6(?:1([89])([01]\d)|1(9)/([3-9]))[- ]?{SUFFIXES}", r"6\1\2\3\4"),
    (r"(N[UJ]) ?(\d{3})", r"\1\2"),
    (r"(N[UJ]) ?(\d{3})[- ]?(?:E[A-Z\d-]*|R)", r"\1\2E"),
    (r"(R?NA|HK) ?(\d+(?:/\d\d)?(?:-XL)?)", r"\1\2"),
)
"""Names of makers as patterns, and those of the tables: 61805 is 6805, NU205ECP is NU205E."""

ELEMENTS: dict[str, Literal["cylindrical", "needle"]] = {
    "NU": "cylindrical",
    "NJ": "cylindrical",
    "NA": "needle",
    "RN": "needle",
    "HK": "needle",
}
"""Rolling elements by the first letters of a series; others have balls."""

Rating = Literal["dynamic_rating", "static_rating"]

NEAR = 5
"""Names offered in place of an unknown one."""


@dataclass(frozen=True, slots=True)
class Ratings:
    """Load ratings of a bearing by one maker."""

    maker: str = answer()
    """Maker of the bearing."""
    shielded: bool = answer()
    """True if the ratings hold for shielded bearings only."""
    dynamic_rating: float = answer("N")
    """Basic dynamic load rating C."""
    static_rating: float = answer("N")
    """Basic static load rating C₀."""

    @property
    @answered()
    def source(self) -> str:
        """Catalogue in which the ratings are stated."""
        return MAKERS[self.maker]


@dataclass(frozen=True, slots=True, kw_only=True)
class NamedBearing:
    """Sizes, mass and load ratings of a named bearing."""

    name: str = answer()
    """Name of the bearing in requests."""
    series: str = answer()
    """Series of the bearing."""
    bore_diameter: float = answer("mm")
    """Bore d; without an inner ring the diameter of the shaft."""
    outer_diameter: float = answer("mm")
    """Outer diameter D."""
    width: float = answer("mm")
    """Width B of the shielded bearing; open bearings may be narrower."""
    mass: float = answer("kg")
    """Mass."""
    mass_maker: str  # a key of `MAKERS`
    makers: tuple[Ratings, ...] = answer()
    """Ratings as each maker states them."""

    @property
    @answered()
    def mass_source(self) -> str:
        """Catalogue in which the mass is stated."""
        return MAKERS[self.mass_maker]

    @property
    @answered()
    def elements(self) -> Literal["ball", "cylindrical", "needle"]:
        """Rolling elements: ball, cylindrical or needle."""
        return ELEMENTS.get(self.series[:2], "ball")

    @property
    @answered()
    def kind(self) -> Literal["ball", "roller"]:
        """Kind of rolling elements: ball or roller."""
        return "ball" if self.elements == "ball" else "roller"

    @property
    @answered()
    def inner_ring(self) -> bool:
        """False if the shaft is the raceway of the bearing; the ratings then hold for a shaft of at
        least 58 HRC.
        """
        return self.series not in ("RNA49", "HK")

    @property
    @answered("N")
    def dynamic_rating(self) -> float:
        """Lowest basic dynamic load rating C of all makers; calculations by the bearing's name use
        it.
        """
        return min(each.dynamic_rating for each in self.makers)

    @property
    @answered("N")
    def static_rating(self) -> float:
        """Lowest basic static load rating C₀ of all makers; calculations by the bearing's name use
        it.
        """
        return min(each.static_rating for each in self.makers)


def _read(table: Path) -> Iterator[NamedBearing]:
    """Bearings of the table of a series."""
    with table.open(encoding="utf-8", newline="") as lines:
        head, *rows = csv.reader(lines)
    kinds = head[0].split()
    for names, d, outer, width, kg, weighed, *rated in rows:
        makers = []
        for maker, said in zip(head[6:], rated, strict=True):
            if said:
                own, _, shielded = maker.partition("-")
                dynamic, static = said.split()
                makers.append(Ratings(own, bool(shielded), float(dynamic), float(static)))
        bores, masses = (each.split() * len(kinds) for each in (d, kg))
        for series, name, bore, mass in zip(kinds, names.split(), bores, masses, strict=False):
            yield NamedBearing(
                name=name,
                series=series,
                bore_diameter=float(bore) / 1e3,
                outer_diameter=float(outer) / 1e3,
                width=float(width) / 1e3,
                mass=float(mass),
                mass_maker=weighed,
                makers=tuple(makers),
            )


BEARINGS: dict[str, NamedBearing] = {
    each.name: each for table in sorted(TABLES.glob("*.csv")) for each in _read(table)
}
"""Bearings by name. Ratings of makers differ by up to a factor of two; the lowest are safe."""


def named_bearing(name: str) -> NamedBearing | None:
    """Bearing by its name, such as 686ZZ, NU 205 ECP or HK1512; None if no table has it.

    >>> named_bearing("686-2rs").dynamic_rating
    830.0
    """
    said = name.strip().upper()
    for pattern, plain in SPELLINGS:
        if (found := re.fullmatch(pattern, said)) and (own := found.expand(plain)) in BEARINGS:
            return BEARINGS[own]
    return None


def exchanges(*, present: NamedBearing, rating: Rating, least: float) -> list[str]:
    """Names of other bearings with the bore of one and at least a rating, N: those of the same
    rolling elements first, then in ascending order of their outer diameters and masses.

    >>> exchanges(present=BEARINGS["6205"], rating="dynamic_rating", least=20e3)[:3]
    ['6305', 'NA4905', 'NA4905-XL']
    """
    others = [
        each
        for each in BEARINGS.values()
        if (each.bore_diameter, each.inner_ring) == (present.bore_diameter, present.inner_ring)
        and each.name != present.name
        and getattr(each, rating) >= least
    ]
    others.sort(key=lambda one: (one.elements != present.elements, one.outer_diameter, one.mass))
    return [each.name for each in others]


def names_like(name: str) -> list[str]:
    """`NEAR` names of the tables that resemble an unknown one most, the most similar first.

    >>> names_like("6805ab")[:2]
    ['6805', '685']
    """
    return get_close_matches(name.strip().upper().replace(" ", ""), BEARINGS, n=NEAR, cutoff=0)
