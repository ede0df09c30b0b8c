"""Geometry of a ring of pins: undercut and room, against sampled paths and places of pins."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_checks
from core.design.document import Design
from core.design.drawings import drawn_ring_pins
from core.design.results import Results
from core.design.ring import CycloidRing
from core.errors import InvalidInput
from core.precision import CONVERGED, JUDGED, SAME
from core.ring.profile import CycloidDisc, Modification
from tests.inputs.checks import REF, check_of, having
from tests.oracles.teeth import cycloid_margin

CIRCLE = 0.084
CODES = ("ring_undercut", "ring_pin_room")


def on_pins(
    *, lobes: int, shortening: float, radius: float | None = 0.005, difference: int | None = None
) -> Design:
    """A design whose ring has pins on 84 mm."""
    ring = CycloidRing(
        ring_pin_circle_radius=CIRCLE,
        ring_pin_radius=radius,
        teeth_difference=difference,
    )
    ratio = lobes / (difference or 1)
    eccentricity = shortening * CIRCLE / (ratio + 1)
    return having(
        REF, gear=ring, ratio=ratio, eccentricity=eccentricity, hole_radius=0.008 + eccentricity
    )


def judged(code: str, design: Design) -> tuple[str, str]:
    found = check_of(code, design)
    return found.status, found.reason


def teeth_of(design: Design) -> str:
    (teeth,) = (each for each in crank_checks(Results(design)).parts if each.code == "teeth")
    return teeth.status


def test_a_path_that_crosses_itself_is_refused() -> None:
    design = on_pins(lobes=11, shortening=1 + 1e-9)
    with pytest.raises(InvalidInput) as refusal:
        check_of("ring_undercut", design)
    where = refusal.value.parameter, refusal.value.code
    assert where == ("gear.ring_pin_circle_radius", "no_cycloid")


@pytest.mark.parametrize(
    ("lobes", "shortening"),
    # the sharpest bend at the tip, and on the flanks
    [(2, 0.2), (9, 0.3), (20, 0.1), (11, 0.6), (29, 0.9), (87, 0.5)],
)
def test_the_undercut_is_that_of_the_sampled_path(lobes: int, shortening: float) -> None:
    """The status changes at a radius equal to the least bend of the path, and at 1.1 times it."""
    eccentricity = shortening * CIRCLE / (lobes + 1)
    bend = 1e-6 * cycloid_margin(
        ring_pins=lobes + 1, circle_radius=CIRCLE, eccentricity=eccentricity, pin_radius=1e-6
    )
    for part, expected in (
        (1.001, ("fail", "")),
        (0.999, ("marginal", "near_undercut")),
        (1.001 / 1.1, ("marginal", "near_undercut")),
        (0.999 / 1.1, ("pass", "")),
    ):
        design = on_pins(lobes=lobes, shortening=shortening, radius=part * bend)
        found = check_of("ring_undercut", design)
        assert found.value == pytest.approx(1 / part, rel=3e-4)
        assert (found.status, found.reason) == expected
        assert found.impossible == (expected[0] == "fail")
        assert (found.limit, found.limit_source) == (1.1, "" if found.impossible else "guide")


def test_a_flank_that_is_left_by_rounding_alone_is_none() -> None:
    plain = check_of("ring_undercut", on_pins(lobes=29, shortening=0.9, radius=1e-3))
    assert plain.value is not None
    for off, status in ((1e-9, "fail"), (-1e-8, "marginal")):
        radius = 1e-3 * plain.value * (1 + off)
        found = check_of("ring_undercut", on_pins(lobes=29, shortening=0.9, radius=radius))
        assert found.status == ("fail" if off > 0 else status)
    touching = on_pins(lobes=29, shortening=0.9, radius=1e-3 * plain.value)
    assert judged("ring_undercut", touching) == ("fail", "")


def pitch(pins: int) -> float:
    """Distance of neighbours, by their places."""
    places = CIRCLE * np.exp(2j * math.pi * np.arange(pins) / pins)
    return float(np.abs(np.diff(places)).min())


@pytest.mark.parametrize(("lobes", "difference"), [(20, None), (20, 1), (40, 2), (41, 2)])
def test_the_room_is_what_neighbours_leave(lobes: int, difference: int | None) -> None:
    apart = pitch(lobes + (difference or 1))
    for radius, status in (
        (apart / 2 * (1 + 1e-6), "fail"),
        (apart / 2 * (1 - 1e-6), "marginal"),
        (apart / 2.2 * (1 + 1e-6), "marginal"),
        (apart / 2.2 * (1 - 1e-6), "pass"),
    ):
        design = on_pins(lobes=lobes, shortening=0.5, radius=radius, difference=difference)
        found = check_of("ring_pin_room", design)
        assert found.value == pytest.approx(min(apart - 2 * radius, apart), abs=1e-12)
        assert found.limit == pytest.approx(0.2 * radius)
        assert found.limit_source == ("" if status == "fail" else "guide")
        assert (found.status, found.impossible) == (status, status == "fail")
        assert found.reason == ("thin_wall" if status == "marginal" else "")


def test_teeth_on_pins_fail_or_stay_open() -> None:
    """Pressure and modification are not judged: none is green."""
    sound = on_pins(lobes=20, shortening=0.5)
    assert {judged(code, sound) for code in CODES} == {("pass", "")}
    assert teeth_of(sound) == "open"
    assert teeth_of(on_pins(lobes=20, shortening=0.2)) == "open"
    for bad in (
        on_pins(lobes=20, shortening=0.5, radius=0.013),
        on_pins(lobes=20, shortening=0.95, radius=0.008),
    ):
        assert teeth_of(bad) == "fail" and crank_checks(Results(bad)).impossible


def unknown(code: str, design: Design) -> Check:
    found = check_of(code, design)
    assert found.status == "not_checked"
    return found


def test_what_is_not_known_is_not_judged() -> None:
    design = on_pins(lobes=20, shortening=0.5, radius=None)
    for code in ("ring_undercut", "ring_pin_room"):
        found = unknown(code, design)
        assert (found.reason, found.missing) == ("size_missing", ("gear.ring_pin_radius",))
    uneven = having(on_pins(lobes=20, shortening=0.5), ratio=20.25)
    for code in ("ring_undercut", "ring_pin_room"):
        found = unknown(code, uneven)
        assert (found.reason, found.params) == ("ratio_not_whole", {"ratio": 20.25})
    crossed = on_pins(lobes=40, shortening=0.5, radius=0.001, difference=2)
    found = unknown("ring_undercut", crossed)
    assert (found.reason, found.params) == ("cycloid_difference", {"difference": 2})
    assert judged("ring_pin_room", crossed) == ("pass", "")
    one = on_pins(lobes=1, shortening=0.5)
    assert judged("ring_undercut", one) == ("not_applicable", "one_only")


def test_roots_are_those_of_the_outline() -> None:
    design = on_pins(lobes=20, shortening=0.5)
    disc = CycloidDisc(
        satellite_teeth=20,
        eccentricity=design.contact.eccentricity or 0.0,
        ring_pin_circle_radius=CIRCLE,
        ring_pin_radius=0.005,
    )
    bare = having(design, satellite_body=replace(design.satellite_body, root_radius=None))
    assert bare.roots == pytest.approx((disc.root_radius, disc.root_radius), rel=CONVERGED)


def test_roots_and_undercut_are_those_of_the_tool() -> None:
    """A tool that is larger than the pins, on a smaller circle, cuts deeper, and more sharply."""
    design = on_pins(lobes=29, shortening=0.9, radius=2e-3)
    change = Modification(equidistant=3e-4, pin_circle=-2e-4)
    cut = having(
        design,
        gear=replace(design.gear, modification=change),  # type: ignore[type-var]
        root_radius=None,
    )
    eccentricity = design.contact.eccentricity or 0.0
    deep = CIRCLE - 2e-4 - eccentricity - 2.3e-3
    assert cut.roots == pytest.approx((deep, deep), rel=CONVERGED)
    margin = cycloid_margin(
        ring_pins=30, circle_radius=CIRCLE - 2e-4, eccentricity=eccentricity, pin_radius=2.3e-3
    )
    assert check_of("ring_undercut", cut).value == pytest.approx(margin, rel=3e-4)


def test_the_tool_reaches_the_bottom_of_the_valleys() -> None:
    """The circle through three points of the path there, and the pin's radius."""
    design = on_pins(lobes=11, shortening=0.6)
    t, e = np.array([-1e-4, 0.0, 1e-4]), 0.6 * CIRCLE / 12
    a, b, c = CIRCLE * np.exp(-1j * t) - e * np.exp(-12j * t)
    area = ((b - a) * np.conj(c - a)).imag / 2
    bottom = abs((b - a) * (c - b) * (a - c) / (4 * area)) + 0.005
    for part, status in ((0.999, "pass"), (1.001, "fail")):
        tool = having(design, gear=replace(design.gear, tool_radius=part * bottom))
        found = check_of("ring_valley_tool", tool)
        assert (found.value, found.status) == (pytest.approx(bottom, rel=JUDGED), status)
    assert judged("ring_valley_tool", design) == ("not_asked", "no_tool")
    flat = on_pins(lobes=11, shortening=0.08)
    flat = having(flat, gear=replace(flat.gear, tool_radius=0.01))
    assert judged("ring_valley_tool", flat) == ("not_applicable", "no_valley")


def test_of_every_second_pin_the_others_have_the_room() -> None:
    design = on_pins(lobes=11, shortening=0.6, radius=0.0225)
    assert judged("ring_pin_room", design)[0] == "fail"
    places = CIRCLE * np.exp(2j * np.pi * np.arange(0, 12, 2) / 12)
    half = having(design, gear=replace(design.gear, every_second_pin=True))
    found = check_of("ring_pin_room", half)
    assert found.value == pytest.approx(abs(places[1] - places[0]) - 0.045, rel=SAME)
    assert found.status == "pass"
    made = replace(half.gear, ring_pin_radius=0.005, modification=Modification())
    drawn = drawn_ring_pins(design=having(half, gear=made))
    centres = drawn.centres @ [1, 1j]
    assert len(centres) == 6
    assert np.allclose(np.abs(centres - np.roll(centres, 1)), abs(places[1] - places[0]))
