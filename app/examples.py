"""The papers' figures and numbers as ready requests.

The papers print no torque and no sizes for the figures that show ratios; where a request needs
them, the example takes round numbers and its title says what to look at.
"""

from typing import Any

YANCHEVSKY_2018 = (
    "Yanchevsky, Komada, Stelmakh, Lytvynenko 2018, doi 10.20535/1810-0546.2018.1.121166"
)
YANCHEVSKIY_2021 = "Yanchevskiy, Niekhoroshykh 2021, doi 10.20535/kpissn.2021.4.245103"
ZYL = "Zyl, Belarusian-Russian University: forces in the parallel-crank mechanism"

_CONTACT = {
    "contact_length_mm": 20.0,
    "pin_radius_mm": 8.0,
    "hole_radius_mm": 10.0,
    "pin_material": "steel_bearing",
    "hole_material": "steel_through_hardened",
}
_LOAD = {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0}


def _crank_planetary(
    name: str,
    title: str,
    source: str,
    mechanism: dict[str, Any],
    load: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """One example of the crank-planetary calculator."""
    return {
        "id": name,
        "title": title,
        "source": source,
        "calculation": "crank-planetary",
        "input": {"mechanism": mechanism, "load": _LOAD | (load or {}), "contact": _CONTACT},
    }


def _figure_6(letter: str, title: str, **mechanism: float) -> dict[str, Any]:
    """A cyclogram of fig. 6 of the 2021 paper (u = 20)."""
    return _crank_planetary(
        f"yanchevskiy-2021-fig-6{letter}",
        f"{title} (2021, fig. 6 {letter})",
        f"{YANCHEVSKIY_2021}, fig. 6 {letter}",
        {"ratio": 20.0, **mechanism},
    )


EXAMPLES: list[dict[str, Any]] = [
    _figure_6(
        "a",
        "3 pins, 2 satellites at 180°: always 3 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=180.0,
    ),
    _figure_6(
        "b",
        "3 pins, 2 satellites at 120°: 2 or 4 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "c",
        "3 pins, 2 satellites at 90°: 2, 3 or 4 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=90.0,
    ),
    _figure_6(
        "d",
        "3 pins, 3 satellites at 120°: 3 or 6 pairs",
        pins=3,
        satellites=3,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "e",
        "4 pins, 3 satellites at 120°: always 6 pairs",
        pins=4,
        satellites=3,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "f",
        "3 pins, 4 satellites at 90°: always 6 pairs",
        pins=3,
        satellites=4,
        crank_spacing_deg=90.0,
    ),
    _crank_planetary(
        "yanchevskiy-2021-fig-7",
        "Force curve of 3 satellites: complex over the turn (2021, fig. 7)",
        f"{YANCHEVSKIY_2021}, fig. 7",
        {"pins": 3, "satellites": 3, "crank_spacing_deg": 120.0, "ratio": 20.0},
    ),
    _crank_planetary(
        "yanchevsky-2018-fig-4a",
        "3 pins, 1 satellite: 1 or 2 pairs (2018, fig. 4 a and 6 a)",
        f"{YANCHEVSKY_2018}, fig. 4 a, 6 a",
        {"pins": 3, "satellites": 1, "ratio": 20.0, "initial_crank_angle_deg": 180.0},
    ),
    _crank_planetary(
        "yanchevsky-2018-fig-4b",
        "3 pins, 2 satellites: always 3 pairs (2018, fig. 4 b and 6 b)",
        f"{YANCHEVSKY_2018}, fig. 4 b, 6 b",
        {"pins": 3, "satellites": 2, "ratio": 20.0, "initial_crank_angle_deg": 180.0},
    ),
    _crank_planetary(
        "zyl-6-pins",
        "Equal sharing, 6 pins: 888.2 N (Zyl)",
        f"{ZYL}, text",
        {"pins": 6, "satellites": 1, "ratio": 20.0},
        {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 32.5, "force_exponent": 0.0},
    ),
    _crank_planetary(
        "zyl-4-pins",
        "Equal sharing, 4 pins: 1538 N (Zyl)",
        f"{ZYL}, text",
        {"pins": 4, "satellites": 1, "ratio": 20.0},
        {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 32.5, "force_exponent": 0.0},
    ),
]
"""Ready requests, in the order in which the page offers them; the first is what it opens with."""
