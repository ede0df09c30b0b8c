"""Table of bearings: sizes by the standards, ratings that run evenly over a series and a maker."""

import math
from statistics import median

import pytest

from core.bearings import BEARINGS, MAKERS, NamedBearing, named_bearing, names_like
from core.crank.envelope import HIGH, largest_ratings

# ISO 15: bores of 3 to 9 mm and bore codes 00 to 12 (10, 12, 15, 17, then 5 mm each).
SMALL = {f"{bore}": bore for bore in range(3, 10)}
CODES = {"00": 10, "01": 12, "02": 15, "03": 17} | {f"{i:02}": 5 * i for i in range(4, 13)}

# ISO 15: outer diameter and width for bores of 22, 28, 32 mm.
BETWEEN = {"60": "44 12 52 12 58 13", "62": "50 14 58 16 65 17", "63": "56 16 68 18 75 20"}

# ISO 15: outer diameters D of the diameter series 8, 9, 0, 2, 3 over SMALL and CODES.
OUTER = {
    "68": "7 9 11 13 14 16 17 19 21 24 26 32 37 42 47 52 58 65 72 78",
    "69": "8 11 13 15 17 19 20 22 24 28 30 37 42 47 55 62 68 72 80 85",
    "60": "9 12 14 17 19 22 24 26 28 32 35 42 47 55 62 68 75 80 90 95",
    "62": "10 13 16 19 22 24 26 30 32 35 40 47 52 62 72 80 85 90 100 110",
    "63": "13 16 19 22 26 28 30 35 37 42 47 52 62 72 80 90 100 110 120 130",
}
# ISO 15: widths B of the dimension series 18, 19, 10, 02, 03; below 10 mm those of shielded
# bearings, which may be wider (28 or 38 for 18).
WIDTH = {
    "68": "3 4 5 5 5 5 5 5 5 5 5 7 7 7 7 7 7 7 9 10",
    "69": "4 4 4 5 5 6 6 6 6 7 7 9 9 9 10 12 12 12 13 13",
    "60": "5 4 5 6 6 7 7 8 8 9 10 12 12 13 14 15 16 16 18 18",
    "62": "4 5 5 6 7 8 8 9 10 11 12 14 15 16 17 18 19 20 21 22",
    "63": "5 5 6 7 9 9 10 11 12 13 14 15 17 19 21 23 25 27 29 31",
}
# ISO 15 and ISO 1206, dimension series 49: bore d, diameter of the shaft F_w of RNA, D, B.
NEEDLES = """4900 10 14 22 13, 4901 12 16 24 13, 4902 15 20 28 13, 4903 17 22 30 13,
4904 20 25 37 17, 49/22 22 28 39 17, 4905 25 30 42 17, 49/28 28 32 45 17, 4906 30 35 47 17,
49/32 32 40 52 20, 4907 35 42 55 20, 4908 40 48 62 22, 4909 45 52 68 22, 4910 50 58 72 22,
4911 55 63 80 25, 4912 60 68 85 25"""
# ISO 3245: outer diameters of drawn cups over F_w; HK1210 alone has the lighter series.
CUPS = """4 8, 5 9, 6 10, 7 11, 8 12, 9 13, 10 14, 12 18, 13 19, 14 20, 15 21, 16 22, 17 23, 18 24,
20 26, 22 28, 25 32, 28 35, 30 37, 35 42, 40 47, 45 52, 50 58, 55 63, 60 68"""
# Miniature bearings: bore and outside are in the name.
MINIATURE = {"MR63": 2.5, "MR74": 2.5, "MR84": 3, "MR85": 2.5, "MR95": 3, "MR105": 4, "MR106": 3}


def standard() -> dict[str, tuple[float, float, float]]:
    """Bore, outer diameter and width of the standards, mm, by name."""
    sizes: dict[str, tuple[float, float, float]] = {}
    bores = {**SMALL, **CODES}
    for series, outer in OUTER.items():
        rows = zip(bores.items(), outer.split(), WIDTH[series].split(), strict=True)
        for (code, bore), wide, width in rows:
            sizes[series + code] = (bore, float(wide), float(width))
            if series[1] in "23" and bore >= 15:
                for name in (f"{kind}{series[1]}{code}" for kind in ("NU", "NJ")):
                    sizes[name] = sizes[name + "E"] = sizes[series + code]
    for series, said in BETWEEN.items():
        wide, width = said.split()[::2], said.split()[1::2]
        for bore, *size in zip((22, 28, 32), map(float, wide), map(float, width), strict=True):
            sizes[f"{series}/{bore}"] = (bore, *size)
    for row in NEEDLES.split(","):
        name, *d = row.split()
        bore, shaft, wide, width = map(float, d)
        sizes["NA" + name] = sizes[f"NA{name}-XL"] = (bore, wide, width)
        sizes["RNA" + name] = sizes[f"RNA{name}-XL"] = (shaft, wide, width)
    cups = dict(each.split() for each in CUPS.split(","))
    for name in (each for each in BEARINGS if each.startswith("HK")):
        shaft, width = int(name[2:4]), int(name[4:])
        sizes[name] = (shaft, 16.0 if name == "HK1210" else float(cups[str(shaft)]), width)
    for name, width in MINIATURE.items():
        sizes[name] = (int(name[-1]), int(name[2:-1]), width)
    return sizes


def test_sizes_are_those_of_the_standards() -> None:
    sizes = standard()
    for name, each in BEARINGS.items():
        said = (each.bore_diameter, each.outer_diameter, each.width)
        assert [round(1e3 * size, 6) for size in said] == list(sizes[name]), name
    for series in OUTER:
        assert {series + code for code in (*SMALL, *CODES)} <= {*BEARINGS}


def test_each_row_names_its_makers_and_its_series() -> None:
    assert len(BEARINGS) > 250
    for name, each in BEARINGS.items():
        assert name == each.name and name.startswith(each.series)
        assert {each.mass_maker, *(maker.maker for maker in each.makers)} <= {*MAKERS}
        own = each.series == "HK" or name.endswith("-XL")
        assert own or len({maker.maker for maker in each.makers}) > 1
        assert each.dynamic_rating == min(maker.dynamic_rating for maker in each.makers)
        assert each.kind == ("ball" if each.elements == "ball" else "roller")
        assert each.inner_ring == (each.series not in ("RNA49", "HK"))
    kinds = {each.series: each.elements for each in BEARINGS.values()}
    assert [*kinds.values()].count("ball") == 6 and kinds["NJ3"] == "cylindrical"
    assert {kinds[each] for each in ("NA49", "RNA49", "HK")} == {"needle"}


def per_envelope(each: NamedBearing, dynamic: float, static: float) -> tuple[float, float]:
    """C and C0 over what they are proportional to in bearings of one design (ISO 281, ISO 76)."""
    gap = (each.outer_diameter - each.bore_diameter) / 2
    middle = (each.outer_diameter + each.bore_diameter) / 2
    if each.elements == "ball":
        return dynamic / (gap**1.2 * middle**0.6), static / (gap * middle)
    long = each.width
    return dynamic / (long**0.78 * gap**0.32 * middle**0.75), static / (long * middle)


def run(series: list[NamedBearing], maker: str) -> list[tuple[float, float]]:
    """Ratings of one maker over a series, each by its envelope."""
    return [
        per_envelope(each, rated.dynamic_rating, rated.static_rating)
        for each in series
        for rated in each.makers
        if (rated.maker, rated.shielded) == (maker, False)
    ]


def unevenness(values: list[float]) -> float:
    """Largest factor between a value and the geometric mean of its neighbours."""
    off = [b / math.sqrt(a * c) for a, b, c in zip(values, values[1:], values[2:], strict=False)]
    return max((max(each, 1 / each) for each in off), default=1.0)


def families() -> dict[str, list[NamedBearing]]:
    """Bearings of one design in the order of their sizes; MR bearings are of one design each."""
    found: dict[str, list[NamedBearing]] = {}
    for name, each in BEARINGS.items():
        if each.series == "MR":
            continue
        small = " small" if each.elements == "ball" and each.bore_diameter < 0.01 else ""
        design = next((each for each in ("E", "-XL") if name.endswith(each)), "")
        found.setdefault(each.series + design + small, []).append(each)
    return found


def within(family: str) -> float:
    """Factor within which ratings run; designs differ more below 10 mm, widths more in HK."""
    return 1.5 if family.endswith("small") or family == "HK" else 1.3


RUNS = [
    (family, maker)
    for family, series in families().items()
    for maker in sorted({rated.maker for each in series for rated in each.makers})
]


@pytest.mark.parametrize(("family", "maker"), RUNS)
def test_ratings_run_evenly_over_a_series(family: str, maker: str) -> None:
    for values in zip(*run(families()[family], maker), strict=True):
        assert unevenness([*values]) < within(family)


def test_a_lost_digit_stands_out() -> None:
    for family, maker in RUNS:
        series = families()[family]
        dynamic = [value for value, _ in run(series, maker)]
        rated = [r.dynamic_rating for each in series for r in each.makers if r.maker == maker]
        if len(dynamic) < 3:
            continue
        for index, value in enumerate(rated):
            digits = f"{value / 1e3:.3g}"  # catalogues state three digits, kN
            for lost in range(2):
                left = float("0" + digits[:lost] + digits[lost + 1 :])
                if left and abs(math.log(left / value * 1e3)) > 1:
                    changed = [*dynamic]
                    changed[index] *= left / value * 1e3
                    assert unevenness(changed) > within(family), (family, maker, digits, left)


def test_makers_agree() -> None:
    """From 10 mm of bore ratings are within 20 % of those of most makers, but of thin sections."""
    for each in BEARINGS.values():
        small = each.elements == "ball" and each.bore_diameter < 0.01
        factor = 2.0 if small else 1.65 if each.series == "68" else 1.2
        for quantity in ("dynamic_rating", "static_rating"):
            usual = median(getattr(maker, quantity) for maker in each.makers)
            for maker in each.makers:
                share = getattr(maker, quantity) / usual
                assert 1 / factor < share < factor, (each.name, maker)


def test_ratings_fit_their_envelope_and_masses_are_those_of_steel() -> None:
    for each in BEARINGS.values():
        bore, outer, width = each.bore_diameter, each.outer_diameter, each.width
        bounds = largest_ratings(
            kind=each.kind, bore_diameter=bore, outer_diameter=outer, width=width
        )
        for maker in each.makers:
            assert 0.05 < maker.dynamic_rating / bounds.dynamic < HIGH[each.kind], each.name
            assert 0.05 < maker.static_rating / bounds.static < HIGH[each.kind], each.name
        filled = each.mass / (math.pi / 4 * (outer**2 - bore**2) * width) / 7850
        assert 0.45 < filled < 0.9, each.name


def test_heavier_series_of_a_bore_carry_more() -> None:
    for code in CODES:
        rated = [BEARINGS[series + code].dynamic_rating for series in OUTER]
        assert rated == sorted(rated), code


@pytest.mark.parametrize(
    ("said", "name"),
    [
        *((each, "686") for each in ("686", " 686 ", "686ZZ", "686-2RS", "686 2rs", "686zz")),
        *((each, "NU205E") for each in ("NU 205 ECP", "NU205-E-TVP2", "nu205r", "NU205 ET")),
        ("NU 205", "NU205"),
        ("61805-2RS1", "6805"),
        ("62/22-2RS1", "62/22"),
        ("61912", "6912"),
        ("619/8", "698"),
        ("NA 49/22", "NA49/22"),
        ("RNA4905", "RNA4905"),
        ("NA 4904-XL", "NA4904-XL"),
        ("hk 1512", "HK1512"),
    ],
)
def test_a_name_says_a_bearing_as_makers_do(said: str, name: str) -> None:
    assert named_bearing(said) is BEARINGS[name]


@pytest.mark.parametrize(
    "name",
    [
        "",
        "68",
        "6866",
        "686XY",
        "MR686",
        "six",
        "618/8",
        "NA4904.2RS",
        "HK1512.2RS",
        "NU2205",
        "7205",
    ],
)
def test_other_names_are_none(name: str) -> None:
    assert named_bearing(name) is None
    assert len({*names_like(name)} & {*BEARINGS}) == 5


def test_ratings_of_before_stand() -> None:
    found = BEARINGS["MR105"]
    assert (found.dynamic_rating, found.static_rating, found.width) == (330, 140, 0.004)
    assert (BEARINGS["686"].dynamic_rating, BEARINGS["686"].outer_diameter) == (830, 0.013)
