"""Carrier and housing: usual sizes, places that follow, outer sizes, their checks."""

from dataclasses import replace
from typing import Any

import pytest

from core.design.document import Design, changed
from core.design.results import Results
from core.design.ring import CycloidRing
from core.design.sections import Build, SatelliteBody, SeatedBearing
from core.design.stated import design_of
from core.errors import InvalidInput, NotKnown
from core.precision import EXACT
from tests.inputs.checks import REF, STATED, WHOLE, check_of, having


def built(**sections: Any) -> Design:
    """Design of these sections with values of others beside them; None for a section that is not
    stated.
    """
    stated = STATED | {name: STATED.get(name, {}) | (each or {}) for name, each in sections.items()}
    return design_of(
        {name: each for name, each in stated.items() if sections.get(name, 1) is not None}
    )


def bearings(*widths: float | None) -> dict[str, Any]:
    return {"bearings": tuple(SeatedBearing(kind="ball", width=width) for width in widths)}


def test_places_follow_from_the_gap() -> None:
    """Gap 2, b = 20: 2 + 10 = 12, 12 + 22 = 34, plates 46 apart; plates of 1.2·12 = 14.4."""
    found = built()
    assert found.pin.satellite_positions == pytest.approx((0.012, 0.034), rel=EXACT)
    assert found.pin.span == pytest.approx(0.046, rel=EXACT)
    assert found.crankshaft.satellite_positions == found.pin.satellite_positions
    assert found.crankshaft.bearing_positions == pytest.approx((-0.0072, 0.0532), rel=EXACT)
    wide = built(build={"gap": 0.003, "carrier_width": 0.010, "second_carrier_width": 0.008})
    assert wide.pin.satellite_positions == pytest.approx((0.013, 0.036), rel=EXACT)
    assert wide.pin.span == pytest.approx(0.049, rel=EXACT)
    assert wide.crankshaft.bearing_positions == pytest.approx((-0.005, 0.053), rel=EXACT)


def test_they_follow_what_is_changed_afterwards() -> None:
    found = changed(built(), {"contact.contact_length": 0.010, "build.carrier_width": 0.004})
    assert found.pin.satellite_positions == pytest.approx((0.006, 0.017), rel=EXACT)
    assert found.pin.span == pytest.approx(0.023, rel=EXACT)
    assert found.crankshaft.bearing_positions == pytest.approx((-0.002, 0.0302), rel=EXACT)


def test_what_is_typed_stays() -> None:
    pins = built(pin={"satellite_positions": (0.020, 0.050), "span": 0.080})
    assert (pins.pin.satellite_positions, pins.pin.span) == ((0.020, 0.050), 0.080)
    assert pins.crankshaft.satellite_positions == (0.020, 0.050)
    assert pins.crankshaft.bearing_positions == pytest.approx((-0.0072, 0.0872), rel=EXACT)
    shaft = built(crankshaft={"satellite_positions": (0.022, 0.0)})  # which points the other way
    assert shaft.crankshaft.satellite_positions == (0.022, 0.0)
    assert shaft.crankshaft.bearing_positions == pytest.approx((-0.0192, 0.0412), rel=EXACT)


def test_a_cantilever_has_no_second_plate() -> None:
    """The second bearing lies beside the last disc: 46 and half the plate, or half its width."""
    found = built(pin={"support": "cantilever"})
    assert found.second_carrier_width == 0 and found.pin.span is None
    assert found.crankshaft.bearing_positions == pytest.approx((-0.0072, 0.0532), rel=EXACT)
    known = built(pin={"support": "cantilever"}, crankshaft=bearings(0.016, 0.012))
    assert known.carrier_width == 0.016
    assert known.crankshaft.bearing_positions == pytest.approx((-0.008, 0.052), rel=EXACT)
    assert built(pin=None).second_carrier_width == 0
    with pytest.raises(InvalidInput, match=r"build\.second_carrier_width .*cantilever"):
        built(pin={"support": "cantilever"}, build={"second_carrier_width": 0.01})


def test_the_span_of_a_tie_ring_ends_in_its_middle() -> None:
    found = built(pin={"support": "tie_ring"}, build={"second_carrier_width": 0.006})
    assert found.pin.span == pytest.approx(0.049, rel=EXACT)
    assert found.ends["second_carrier"] == pytest.approx((0.046, 0.052), rel=EXACT)


@pytest.mark.parametrize(
    ("length", "gap"), [(0.004, 0.0005), (0.008, 0.0008), (0.020, 0.002), (0.060, 0.002)]
)
def test_the_usual_gap(length: float, gap: float) -> None:
    assert built(contact={"contact_length": length}).gap == pytest.approx(gap, rel=EXACT)


@pytest.mark.parametrize(
    ("changes", "width"),
    [
        ({}, 0.0144),
        ({"contact": {"pin_radius": 0.001}}, 0.003),
        ({"pin": {"diameter": 0.010}}, 0.012),
        ({"pin": None}, 0.0144),
        ({"crankshaft": bearings(0.015, None)}, 0.015),
        ({"crankshaft": bearings(0.014, 0.020)}, 0.0144),
        ({"build": {"carrier_width": 0.002}}, 0.002),
    ],
)
def test_the_usual_plate(changes: dict[str, Any], width: float) -> None:
    assert built(**changes).carrier_width == pytest.approx(width, rel=EXACT)


@pytest.mark.parametrize(
    ("changes", "diameter"),
    [
        ({}, 0.152),  # 2·1.1·69 = 151.8
        ({"gear": {"ring_pin_circle_radius": 0.021}}, 0.056),  # 2·(25 + 3)
        ({"gear": {"ring_pin_circle_radius": 0.046}}, 0.110),  # 2·1.1·50, no more by rounding
        ({"build": {"housing_diameter": 0.139}}, 0.139),
        ({"gear": None, "satellite_body": {"outer_radius": 0.066}}, 0.150),  # 2·1.1·68 = 149.6
    ],
)
def test_the_usual_housing(changes: dict[str, Any], diameter: float) -> None:
    assert built(**changes).housing_diameter == pytest.approx(diameter, rel=EXACT)


def test_the_housing_of_involute_teeth() -> None:
    """Roots of the ring at 1.75·(42/2 + 1.25) = 38.9375, with a shift of 0.4 at 39.6375."""
    stated = {"kind": "involute", "module": 1.75e-3, "teeth_difference": 2}
    gear = having(WHOLE, pin=None, crankshaft=None).gear
    assert gear.reach(20.0) == pytest.approx(0.0389375, rel=EXACT)
    assert design_of(STATED | {"gear": stated}).housing_diameter == 0.086  # 85.66
    assert (
        design_of(STATED | {"gear": stated | {"ring_profile_shift": 0.4}}).housing_diameter == 0.088
    )


def test_the_envelope_of_a_cycloid_reducer() -> None:
    """Housing 152, carrier 2·(36 + 12) = 96; from −14.4 to 46 + 14.4."""
    found = built().envelope
    assert found.outer_diameter == pytest.approx(0.152, rel=EXACT)
    assert found.length == pytest.approx(0.0748, rel=EXACT)
    assert found.of == ("housing", "carrier", "second_carrier")
    sizes = {"carrier_diameter": 0.160, "housing_width": 0.090}
    outer = built(build=sizes, crankshaft=bearings(None, 0.040)).envelope  # plate B is 40 wide
    assert outer.outer_diameter == pytest.approx(0.160, rel=EXACT)
    assert outer.length == pytest.approx(0.086 + 0.022, rel=EXACT)
    assert outer.of == ("carrier", "housing", "second_carrier")


def test_bearings_are_brought_to_the_datum_by_the_first_satellite() -> None:
    """First satellite at 12 is 100 on the shaft: a bearing at 60 is at −28, at 160 at 72."""
    places = {"satellite_positions": (0.100, 0.122), "bearing_positions": (0.060, 0.160)}
    found = built(crankshaft=places | bearings(0.010, 0.008))
    assert found.ends["bearing_a"] == pytest.approx((-0.033, -0.023), rel=EXACT)
    assert found.ends["bearing_b"] == pytest.approx((0.068, 0.076), rel=EXACT)
    assert found.envelope.length == pytest.approx(0.109, rel=EXACT)
    assert found.envelope.of == ("housing", "bearing_a", "bearing_b")
    turned = {"satellite_positions": (0.100, 0.078), "bearing_positions": (0.040, 0.140)}
    back = built(crankshaft=turned | bearings(0.008, 0.010))
    assert back.ends["bearing_b"] == pytest.approx(found.ends["bearing_a"], rel=EXACT)
    assert "bearing_b" not in built(crankshaft=places | bearings(0.010, None)).ends


MUTATIONS: dict[str, tuple[dict[str, Any], float, float]] = {
    "gap": ({"build": {"gap": 0.003}}, 0.152, 0.0778),
    "carrier": ({"build": {"carrier_width": 0.010}}, 0.152, 0.0704),
    "second plate": ({"build": {"second_carrier_width": 0.010}}, 0.152, 0.0704),
    "carrier diameter": ({"build": {"carrier_diameter": 0.160}}, 0.160, 0.0748),
    "housing": ({"build": {"housing_diameter": 0.170}}, 0.170, 0.0748),
    "housing width": ({"build": {"housing_width": 0.080}}, 0.152, 0.080),
    "disc": ({"contact": {"contact_length": 0.010}}, 0.152, 0.0518),
    "discs": ({"mechanism": {"satellites": 3}}, 0.152, 0.0968),
    "pins": ({"contact": {"pin_radius": 0.005}}, 0.152, 0.070),
    "pin": ({"pin": {"diameter": 0.010}}, 0.152, 0.070),
    "pin circle": ({"load": {"pin_circle_radius": 0.070}}, 0.164, 0.0748),
    "ring": ({"gear": {"ring_pin_radius": 0.005}}, 0.154, 0.0748),
    "span": ({"pin": {"span": 0.050}}, 0.152, 0.0788),
    "bearing": ({"crankshaft": bearings(0.020, None)}, 0.152, 0.0804),
}
"""Changes of one size each, with diameter and length by hand."""


@pytest.mark.parametrize("name", MUTATIONS)
def test_each_size_moves_the_envelope(name: str) -> None:
    changes, diameter, length = MUTATIONS[name]
    found = built(**changes).envelope
    assert found.outer_diameter == pytest.approx(diameter, rel=EXACT)
    assert found.length == pytest.approx(length, rel=EXACT)


def test_what_is_too_small_for_what_it_holds_is_refused() -> None:
    with pytest.raises(InvalidInput, match=r"build\.housing_diameter .*0\.138"):
        built(build={"housing_diameter": 0.137})
    with pytest.raises(InvalidInput, match=r"build\.carrier_diameter .*0\.084"):
        built(build={"carrier_diameter": 0.083})


def test_what_is_usual_is_said() -> None:
    usual = built(build={"gap": 0.003}, pin={"span": 0.050}).usual_build
    assert {*usual} == {
        *(
            f"build.{name}"
            for name in ("carrier_width", "second_carrier_width", "carrier_diameter")
        ),
        *("build.housing_diameter", "build.housing_width", "pin.satellite_positions"),
        *("crankshaft.satellite_positions", "crankshaft.bearing_positions"),
    }
    assert usual["build.housing_width"] == pytest.approx(0.049, rel=EXACT)
    few = {"build.gap", "build.housing_width"}  # neither plates nor teeth are known
    assert {*design_of({"mechanism": STATED["mechanism"], "build": {}}).usual_build} == set()
    contact = {"contact_length": 0.02, "eccentricity": 0.002}
    assert {
        *built(
            contact=contact | {"pin_radius": None}, pin=None, crankshaft=None, gear=None
        ).usual_build
    } >= few


def test_places_that_are_not_known_are_asked_for() -> None:
    shaft = design_of({"mechanism": STATED["mechanism"], "crankshaft": {}, "build": {}}).crankshaft
    with pytest.raises(NotKnown) as lacks:
        _ = shaft.places
    assert lacks.value.missing == ("crankshaft.satellite_positions",)


def test_places_that_follow_are_solved_with() -> None:
    """The results are those of typed places."""
    typed = built(
        build=None,
        pin={"satellite_positions": (0.012, 0.034), "span": 0.046},
        crankshaft={"satellite_positions": (0.012, 0.034), "bearing_positions": (-0.0072, 0.0532)},
    )
    one, other = Results(built()), Results(typed)
    assert one.crank.shaft.peak_reaction == pytest.approx(other.crank.shaft.peak_reaction)
    assert one.pin_strength.peak_moment == pytest.approx(other.pin_strength.peak_moment)


def test_outer_sizes_are_checked_where_they_are_asked() -> None:
    for code, asked, value in (
        ("outer_diameter", "max_outer_diameter", 0.152),
        ("length", "max_length", 0.0748),
    ):
        assert check_of(code, built()).status == "not_asked"
        for limit, status in ((value, "pass"), (value - 1e-6, "fail")):
            found = check_of(code, having(built(), **{asked: limit}))
            assert (found.status, found.limit) == (status, limit)
            assert found.value == pytest.approx(value, rel=EXACT)


def test_outer_sizes_of_parts_that_are_not_known_are_not_checked() -> None:
    wide = having(REF, max_outer_diameter=0.2, max_length=0.1)
    assert check_of("outer_diameter", wide).missing == ("satellite_body.outer_radius",)
    assert check_of("length", wide).status == "pass"  # −19.2 to 46: one plate, no bearing
    assert check_of("length", wide).value == pytest.approx(0.0652, rel=EXACT)
    bare = having(wide, pin_radius=None, hole_radius=None, build=Build(housing_diameter=0.19))
    found = check_of("length", bare)
    assert (found.status, found.missing) == ("not_checked", ("contact.pin_radius",))
    ringed = having(wide, gear=CycloidRing(ring_pin_circle_radius=0.08))
    assert check_of("outer_diameter", ringed).missing == ("gear.ring_pin_radius",)
    body = replace(SatelliteBody(), outer_radius=0.08)
    free = having(wide, satellite_body=body, eccentricity=None)
    assert check_of("outer_diameter", free).missing == ("contact.eccentricity",)
