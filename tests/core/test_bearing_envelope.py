"""The largest ratings of bearings by hand, and the checks of bearings as they are bought.

Formulas of ISO 281 and ISO 76 for full complements, recalculated apart from this program with
tables of the factor f_c; catalogue ratings of three bearings are below them.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.checks.check import Check
from core.crank.bearing_life import Bearing
from core.crank.envelope import largest_ratings, largest_ratings_of_room
from core.crank.satellite_bearing import SatelliteBearings
from core.design.document import Design
from core.design.results import Results
from core.design.sections import SeatedBearing
from core.errors import InvalidInput
from core.precision import SAME
from tests.inputs.checks import WHOLE, check_of, having

BOUNDS: dict[str, tuple[Bearing, tuple[float, float, float], float, float]] = {
    "20x47x14": ("roller", (20, 47, 14), 49754.969914502704, 37604.14877964108),
    "6205": ("ball", (25, 52, 15), 31123.916089401275, 29935.450998),
    "NU205": ("roller", (25, 52, 15), 62661.23761112498, 50734.48005345552),
    "needles": ("roller", (20, 26, 20), 36373.32339576025, 55134.485568612334),
}


@pytest.mark.parametrize("name", BOUNDS)
def test_bounds_by_hand(name: str) -> None:
    kind, sizes, dynamic, static = BOUNDS[name]
    bore, outer, width = (each / 1e3 for each in sizes)
    found = largest_ratings(kind=kind, bore_diameter=bore, outer_diameter=outer, width=width)
    assert found.dynamic == pytest.approx(dynamic, rel=SAME)
    assert found.static == pytest.approx(static, rel=10 * SAME)


@pytest.mark.parametrize("kind", ["ball", "roller"])
def test_bounds_grow_with_the_room(kind: Bearing) -> None:
    sizes = {"bore_diameter": 0.02, "outer_diameter": 0.05, "width": 0.015}

    def bounds(times: float = 1.0, **more: float) -> Any:
        scaled = {name: value * times for name, value in (sizes | more).items()}
        return largest_ratings(kind=kind, **scaled)

    plain = bounds()
    for more in ({"outer_diameter": 0.055}, {"width": 0.02}):
        assert bounds(**more).dynamic > plain.dynamic
    assert bounds(width=0.02).static == pytest.approx(4 / 3 * plain.static)
    assert bounds(2.0).static == pytest.approx(4 * plain.static)
    if kind == "roller":
        power = 7 / 9 + 29 / 27
        assert bounds(2.0).dynamic == pytest.approx(2**power * plain.dynamic)
    thin = bounds(bore_diameter=0.0499)
    assert thin.dynamic < 0.2 * plain.dynamic
    least = 0.012
    room = largest_ratings_of_room(kind=kind, least_bore=least, outer_diameter=0.05, width=0.015)
    bores = np.linspace(least, 0.0499, 400)
    each = [bounds(bore_diameter=float(bore)) for bore in bores]
    assert room.dynamic == pytest.approx(max(b.dynamic for b in each), rel=1e-2)
    assert room.static == pytest.approx(max(b.static for b in each), rel=1e-2)
    with pytest.raises(InvalidInput, match="outer_diameter"):
        bounds(bore_diameter=0.05)


def of_rows(rows: int, bore: float, outer: float, width: float) -> float:
    """Dynamic rating of a full complement of so many rows of balls of at most 25.4 mm, N; mm."""
    ball, middle = min((outer - bore) / 2, width / rows), (outer + bore) / 2
    g = ball / middle
    reduced = 1 + (1.04 * ((1 - g) / (1 + g)) ** 1.72) ** (10 / 3)
    factor = g**0.3 * (1 - g) ** 1.39 / (1 + g) ** (1 / 3) / reduced**0.3
    count = np.pi / np.arcsin(g)
    return 1.3 * 37.905 * 26**0.41 * factor * rows**0.7 * count ** (2 / 3) * ball**1.8


@pytest.mark.parametrize(
    ("bore", "outer", "width", "most"),
    [(25, 52, 15, 60), (49.9, 50, 15, 400), (3, 40, 200, 60), (49.9, 50, 0.03, 3)],
)
def test_the_rows_that_carry_most(bore: float, outer: float, width: float, most: int) -> None:
    found = largest_ratings(
        kind="ball", bore_diameter=bore / 1e3, outer_diameter=outer / 1e3, width=width / 1e3
    )
    best = max(of_rows(i, bore, outer, width) for i in range(1, most + 1))
    assert found.dynamic == pytest.approx(best, rel=SAME)


def test_a_ring_as_thin_as_numbers_are() -> None:
    # as many rows as there is room for would be ten million million
    found = largest_ratings(
        kind="ball",
        bore_diameter=float(np.nextafter(0.05, 0)),
        outer_diameter=0.05,
        width=1e-3,
    )
    assert 0 < found.dynamic < 1e-3


def bearing(**changes: Any) -> Design:
    return having(WHOLE, contact_law=None, bearing=replace(WHOLE.bearing, **changes))


SIZES = {"bore_diameter": 0.025, "outer_diameter": 0.052, "width": 0.015}


@pytest.mark.parametrize(
    ("kind", "share", "status", "reason", "impossible"),
    [
        ("ball", 1.51, "fail", "", True),
        ("ball", 1.49, "marginal", "rating_high", False),
        ("ball", 1.19, "pass", "", False),
        ("roller", 1.21, "fail", "", True),
        ("roller", 1.01, "marginal", "rating_high", False),
        ("roller", 0.99, "pass", "", False),
        ("roller", 0.06, "pass", "", False),
        ("roller", 0.04, "marginal", "rating_low", False),  # kN typed as N
    ],
)
@pytest.mark.parametrize("rating", ["dynamic", "static"])
def test_a_bearing_must_be_possible(
    kind: Bearing, share: float, status: str, reason: str, impossible: bool, rating: str
) -> None:
    bounds = largest_ratings(kind=kind, **SIZES)
    values = {f"{rating}_rating": share * getattr(bounds, rating)}
    other = {"dynamic": "static", "static": "dynamic"}[rating]
    values[f"{other}_rating"] = 0.01 * getattr(bounds, other)
    found = check_of("bearing_rating", bearing(kind=kind, **SIZES, **values))
    assert (found.status, found.reason, found.impossible) == (status, reason, impossible)
    assert found.value == pytest.approx(share) and found.torque_reserve is None
    if rating == "static":
        return  # bearings of the crankshaft have none
    shaft = replace(
        WHOLE.crankshaft,
        bearings=(
            SeatedBearing(kind=kind, **SIZES, dynamic_rating=values["dynamic_rating"]),
            SeatedBearing(kind="ball", dynamic_rating=1e4, **SIZES),
        ),
    )
    crank = check_of("crank_bearing_rating", having(WHOLE, crankshaft=shaft))
    assert (crank.status, crank.reason) == (status, reason)


def test_a_rating_by_the_room_where_no_sizes_are_given() -> None:
    open_ = check_of("bearing_rating", bearing())
    assert (open_.status, open_.reason, open_.opens) == ("not_checked", "envelope_unknown", True)
    assert "bearing.outer_diameter" in open_.missing
    body = replace(WHOLE.satellite_body, bore_radius=0.035)
    for rating, status in ((60e3, "pass"), (1e6, "fail")):
        design = having(bearing(dynamic_rating=rating), satellite_body=body)
        found = check_of("bearing_rating", design)
        assert found.status == status, found
    assert check_of("bearing_rating", bearing(dynamic_rating=None, static_rating=None)).reason


def fits(design: Design) -> Check:
    return check_of("bearing_fits", design)


def test_the_room_of_a_bearing() -> None:
    """An eccentricity of 2 mm: the bore is at least 4 mm wider than the shaft."""
    design = bearing(**SIZES)
    assert fits(design).status == "pass" and not fits(bearing()).opens
    shaft = WHOLE.crankshaft
    for diameter, status in ((0.0209, "pass"), (0.0211, "fail")):
        found = fits(having(design, crankshaft=replace(shaft, shaft_diameter=diameter)))
        assert (found.status, found.impossible) == (status, status == "fail")
    for diameter, status in ((0.025, "pass"), (0.0251, "fail")):
        found = fits(having(design, crankshaft=replace(shaft, eccentric_diameter=diameter)))
        assert found.status == status
    for radius, status in ((0.026, "pass"), (0.0259, "fail")):
        body = replace(WHOLE.satellite_body, bore_radius=radius)
        assert fits(having(design, satellite_body=body)).status == status
    wide = fits(bearing(**(SIZES | {"width": 0.021})))
    assert (wide.status, wide.reason) == ("marginal", "wider_than_satellite")
    for diameter, status in ((0.025, "pass"), (0.0251, "fail")):
        of_shaft = replace(
            shaft,
            shaft_diameter=diameter,
            bearings=(SeatedBearing(kind="ball", dynamic_rating=1e4, **SIZES),) * 2,
        )
        assert check_of("crank_bearing_fits", having(WHOLE, crankshaft=of_shaft)).status == status


def test_speeds_of_bearings() -> None:
    """1500 a minute at the crank, 1575 between the rings of the satellites' bearings."""
    for limit, status in ((1576.0, "pass"), (1574.0, "fail")):
        found = check_of("bearing_speed", bearing(limiting_speed=limit * np.pi / 30))
        assert found.status == status
        assert found.value == pytest.approx(1575 * np.pi / 30)
    assert check_of("bearing_speed", bearing()).status == "not_asked"
    for limit, status in ((1501.0, "pass"), (1499.0, "fail")):
        pair = (
            SeatedBearing(kind="ball", dynamic_rating=1e4, limiting_speed=limit * np.pi / 30),
            SeatedBearing(kind="ball", dynamic_rating=1e4, limiting_speed=1e4),
        )
        shaft = replace(WHOLE.crankshaft, bearings=pair)
        assert check_of("crank_bearing_speed", having(WHOLE, crankshaft=shaft)).status == status


def test_too_little_and_too_much_load() -> None:
    results = Results(having(WHOLE, contact_law=None)).crank.bearings
    least = float(np.min(results.min_load))
    for kind, share in (("ball", 0.01), ("roller", 0.02)):
        for times, status in ((0.99, "pass"), (1.01, "marginal")):
            found = check_of(
                "bearing_min_load", bearing(kind=kind, dynamic_rating=times * least / share)
            )
            assert found.status == status and found.warning
    equivalent = float(np.max(results.equivalent_load))
    for times, status in ((1.01, "pass"), (0.99, "marginal")):
        rated = bearing(dynamic_rating=2 * equivalent * times, static_rating=1e9)
        assert check_of("bearing_overload", rated).status == status
    peak = float(np.max(results.peak_load))
    for times, status in ((1.01, "pass"), (0.99, "marginal")):
        rated = bearing(dynamic_rating=1e9, static_rating=peak * times)
        assert check_of("bearing_overload", rated).status == status


@pytest.mark.parametrize("code", ["bearing_life", "system_life"])
def test_a_life_that_its_loads_leave_in_doubt_is_marginal(
    code: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An error of the loads by 0.001 is one of the life by 0.01 at least, of its power."""
    bearing = replace(WHOLE.bearing, weibull_slope=1.5)
    found = Results(having(WHOLE, bearing=bearing)).crank.bearings
    rough = found.accuracy._replace(relative_error=1e-3)
    monkeypatch.setattr(SatelliteBearings, "accuracy", rough)
    lived = float(found.life.min()) if code == "bearing_life" else float(found.system_life)
    for more, status in ((1.005, "marginal"), (1.05, "fail"), (0.5, "pass")):
        assert check_of(code, having(WHOLE, bearing=bearing, life=lived * more)).status == status
