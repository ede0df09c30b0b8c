"""Rolling bearings by name: sizes, and load ratings as several makers state them."""

import re
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Literal

MAKERS = {
    "FBJ": "FBJ catalogue",
    "ISB": "ISB catalogue, kN to 0.01",
    "Koyo": "Koyo standard bearings, kN to 0.01",
    "NMB": "NMB ball bearings catalogue, by their own names",
    "NSK": "NSK Rolling Bearings, CAT. No. E1102e",
    "NTN": "NTN deep groove ball bearings",
    "ZEN": "ZEN standard catalogue, V.10/12",
}
"""Catalogue that the ratings of each maker were read in."""

SUFFIXES = r"(ZZ|Z|2Z|RS|2RS|2RS1|2RSR|2RSH|DD|VV|DDU|LLU|LLB|OPEN)?"
"""Suffixes of bearing names for shields and seals, which change no rating here."""

NEAR, ALIKE = 5, 0.5
"""Most names offered in place of an unknown one, and their least similarity (difflib)."""


@dataclass(frozen=True, slots=True)
class Ratings:
    """Load ratings of a bearing by one maker, N."""

    maker: str  # a key of `MAKERS`
    shielded: bool  # True if the ratings hold for shielded bearings only
    dynamic_rating: float  # C
    static_rating: float  # C0


@dataclass(frozen=True, slots=True)
class NamedBearing:
    """Sizes and load ratings of a named bearing."""

    name: str  # without the suffix of shields or seals
    kind: Literal["ball", "roller"]  # rolling elements
    bore_diameter: float  # d, m
    outer_diameter: float  # D, m
    width: float  # B of the shielded bearing, m; open ones may be narrower
    makers: tuple[Ratings, ...]  # ratings of each maker

    @property
    def dynamic_rating(self) -> float:
        """Lowest dynamic load rating C of all makers, N."""
        return min(each.dynamic_rating for each in self.makers)

    @property
    def static_rating(self) -> float:
        """Lowest static load rating C0 of all makers, N."""
        return min(each.static_rating for each in self.makers)


def _ball(name: str, bore: float, outer: float, width: float, rated: str) -> NamedBearing:
    """Deep groove ball bearing of sizes in mm; `rated` lists maker, C and C0 in N."""
    ratings = []
    for each in rated.split(", "):
        maker, dynamic, static = each.split()
        own, _, shielded = maker.partition("-")
        ratings.append(Ratings(own, bool(shielded), float(dynamic), float(static)))
    return NamedBearing(name, "ball", bore / 1e3, outer / 1e3, width / 1e3, tuple(ratings))


BEARINGS: dict[str, NamedBearing] = {
    each.name: each
    for each in (
        _ball(
            "MR63", 3, 6, 2.5,
            "NSK 208 74, NMB 206 73, FBJ 206 74, ZEN 209 74, Koyo 190 60, ISB 160 60",
        ),
        _ball(
            "683", 3, 7, 3,
            "NSK 390 130, NMB 384 129, FBJ 314 108, ZEN 311 112, Koyo 310 110, ISB 240 100",
        ),
        _ball(
            "623", 3, 10, 4,
            "NSK 630 218, NMB 641 226, FBJ 628 216, ZEN 631 219, Koyo 640 230, ISB 530 180",
        ),
        _ball(
            "MR74", 4, 7, 2.5,
            "NSK-ZZ 255 107, NSK 310 115, NMB 252 106, FBJ-ZZ 255 108, "
            "FBJ 314 118, ZEN 255 108, Koyo 260 110",
        ),
        _ball(
            "MR84", 4, 8, 3,
            "NSK 395 139, NMB 384 140, FBJ 392 137, ZEN 395 141, Koyo 400 140, ISB 300 120",
        ),
        _ball(
            "684", 4, 9, 4,
            "NSK 640 225, NMB 641 226, FBJ 638 226, ZEN 641 227, Koyo 640 230, ISB 490 220",
        ),
        _ball(
            "624", 4, 13, 5,
            "NSK 1300 485, NMB 1306 487, FBJ 1305 490.5, ZEN 1301 488, Koyo 1300 490, ISB 920 290",
        ),
        _ball(
            "MR85", 5, 8, 2.5,
            "NSK-ZZ 278 131, NSK 310 120, NMB 274 130, FBJ-ZZ 216 88, "
            "FBJ 304 118, ZEN 218 90, Koyo 260 120, ISB 210 100",
        ),
        _ball(
            "MR95", 5, 9, 3,
            "NSK 430 168, NMB 495 207, FBJ 432 167, ZEN 431 169, Koyo 470 190, ISB 330 140",
        ),
        _ball(
            "MR105", 5, 10, 4,
            "NSK 430 168, NMB 714 276, FBJ 432 167, ZEN 431 169, Koyo 500 210, ISB 330 140",
        ),
        _ball(
            "685", 5, 11, 5,
            "NSK 715 281, NMB 714 276, FBJ 716 294, ZEN 716 282, Koyo 970 360, ISB 550 250",
        ),
        _ball(
            "625", 5, 16, 5,
            "NSK 1730 670, NMB 1735 671, FBJ 1727 676.9, ZEN 1729 675, Koyo 1750 670",
        ),
        _ball(
            "MR106", 6, 10, 3,
            "NSK 495 218, NMB 457 194, FBJ 500 216, ZEN 496 218, Koyo 500 220, ISB 380 180",
        ),
        _ball(
            "686", 6, 13, 5,
            "NSK 1080 440, NMB 1083 438, FBJ 1079 441, ZEN 1082 442, Koyo 1100 440, ISB 830 400",
        ),
        _ball(
            "626", 6, 19, 6,
            "NSK 2340 885, NMB 2614 1053, FBJ 2335 892.7, ZEN 2336 896, "
            "Koyo 2600 1050, ISB 1820 920",
        ),
        _ball(
            "687", 7, 14, 5,
            "NSK 1170 510, NMB 1175 511, FBJ 1177 510, ZEN 1173 513, Koyo 1150 510, ISB 910 450",
        ),
        _ball(
            "688", 8, 16, 5,
            "NSK 1610 710, NMB 1606 712, FBJ 1256 589, ZEN 1252 592, Koyo 1600 710, ISB 970 500",
        ),
        _ball(
            "608", 8, 22, 7,
            "NSK 3300 1370, NMB 3297 1368, FBJ 3296 1383, ZEN 3293 1379, Koyo 3300 1350",
        ),
        _ball(
            "6800", 10, 19, 5,
            "NSK 1720 840, NTN 1830 925, Koyo 1700 840, NMB 2123 985, FBJ 1380 585, ISB 1400 580",
        ),
        _ball(
            "6801", 12, 21, 5,
            "NSK 1920 1040, NTN 1920 1040, Koyo 1900 1050, NMB 1917 1042, FBJ 1430 670",
        ),
        _ball("6802", 15, 24, 5, "NSK 2070 1260, Koyo 2100 1250, NMB 2076 1258, FBJ 1560 800"),
        _ball("6803", 17, 26, 5, "NSK 2630 1570, Koyo 2600 1550, FBJ 1680 930"),
        _ball("6804", 20, 32, 7, "NSK 4000 2470, Koyo 4000 2450, FBJ 2700 1500"),
        _ball("6805", 25, 37, 7, "NSK 4500 3150, Koyo 4300 2950, FBJ 4360 2600, ISB 4280 2600"),
        _ball("6806", 30, 42, 7, "NSK 4700 3650, Koyo 4550 3400, FBJ 4490 2900"),
    )
}  # fmt: skip
"""Bearings by name. Ratings of makers differ by up to a factor of two; the lowest are safe."""


def named_bearing(name: str) -> NamedBearing | None:
    """Bearing by its name, such as 686, 686ZZ or MR105-2RS; None if the table lacks it.

    >>> named_bearing("686-2rs").dynamic_rating
    830.0
    """
    found = re.fullmatch(rf"((?:MR)?\d+)[- ]?{SUFFIXES}", name.strip().upper())
    return None if found is None else BEARINGS.get(found[1])


def names_like(name: str) -> list[str]:
    """At most `NEAR` names of the table that resemble an unknown one, the most similar first.

    >>> names_like("689")[:2]
    ['688', '687']
    """
    return get_close_matches(name.strip().upper(), BEARINGS, n=NEAR, cutoff=ALIKE)
