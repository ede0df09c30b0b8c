"""Mass of the parts and inertia at the input: outlines by polygons, moments by brute sums."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.bearings import BEARINGS
from core.design.document import Design
from core.design.mass import CLOSED, TEETH_ERROR, mass
from core.design.sections import RollingBearing, SeatedBearing
from core.design.stated import design_of, section
from core.errors import InvalidInput
from core.precision import SAME
from core.ring.profile import CycloidDisc, Modification, outline_points
from tests.inputs.checks import STATED

STEEL = 7850.0
NAMED = {"name": "6004"}  # 20 x 42 x 12, 69 g
SEATED = tuple(section(kind=SeatedBearing, stated={"name": "6003"}) for _ in "AB")  # 17 x 35 x 10
GRID = 1200
"""Cells of a brute sum along the diameter of a part."""


def drive(**sections: Any) -> Design:
    """Cycloid reducer with bearings by name; None for a section that is not stated."""
    stated: dict[str, Any] = STATED | {"bearing": NAMED, "crankshaft": {"bearings": SEATED}}
    stated |= {name: stated.get(name, {}) | (each or {}) for name, each in sections.items()}
    return design_of(
        {name: each for name, each in stated.items() if sections.get(name, 1) is not None}
    )


def masses(design: Design) -> dict[str, float | None]:
    return {each.code: each.mass for each in mass(design).parts}


def polygon(points: Any) -> tuple[float, float]:
    """Area and polar moment of a polygon by its triangles with the centre."""
    x, y = points.T
    x2, y2 = np.roll(x, -1), np.roll(y, -1)
    cross = x * y2 - x2 * y
    moment = (cross * (x * x + x * x2 + x2 * x2 + y * y + y * y2 + y2 * y2)).sum() / 12
    return abs(cross.sum()) / 2, abs(moment)


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"satellite_teeth": 9, "eccentricity": 0.004},
        {"modification": Modification(equidistant=1e-4, pin_circle=-2e-4)},
        {"ring_pin_radius": 1e-5},
        {"satellite_teeth": 2, "eccentricity": 0.001},
        {"eccentricity": 0.0029, "ring_pin_radius": 0.0002},
    ],
)
def test_area_and_moment_of_a_disc_are_those_of_a_fine_polygon(changes: dict[str, Any]) -> None:
    sizes = {"satellite_teeth": 20, "eccentricity": 0.002}
    ring = {"ring_pin_circle_radius": 0.065, "ring_pin_radius": 0.004}
    disc = CycloidDisc(**(sizes | ring | changes))
    drawn = outline_points(disc=disc, chord_error=5e-9)
    area, moment = polygon(drawn.points)
    length = np.abs(np.diff(drawn.points, axis=0)).sum()
    error = length * drawn.chord_error / area
    assert disc.moments[0] == pytest.approx(area, rel=error)
    assert disc.moments[1] == pytest.approx(moment, rel=3 * error)


def test_the_area_is_that_of_the_parallel_curve() -> None:
    """Steiner: the path's area less r_m times its length, an elliptic integral, plus pi*r_m^2."""
    special = pytest.importorskip("scipy.special")
    disc = drive().cycloid.disc(satellite_teeth=20, eccentricity=0.002)
    k, big, small = disc.shortening, disc.tool_circle_radius, disc.tool_radius
    length = 4 * big * (1 + k) * special.ellipe(4 * k / (1 + k) ** 2)
    path = math.pi * (big**2 + 21 * 0.002**2)
    area = path - small * length + math.pi * small**2
    assert disc.moments[0] == pytest.approx(area, rel=SAME)


def cells(radius: float) -> tuple[Any, float]:
    """Middles of the cells of a square about the centre, x + i*y, and the area of each."""
    side = 2 * radius / GRID
    along = (np.arange(GRID) + 0.5) * side - radius
    return along[:, None] + 1j * along[None, :], side * side


def holes(at: Any, circle: float, radius: float, count: int) -> Any:
    """True in the holes."""
    found = np.zeros(at.shape, bool)
    for n in range(count):
        found |= np.abs(at - circle * np.exp(2j * math.pi * n / count)) < radius
    return found


def plate(outer: float, bore: float, hole: float) -> tuple[float, float]:
    """Area and polar moment of a plate with six holes, by cells."""
    at, each = cells(outer)
    solid = (np.abs(at) < outer) & (np.abs(at) > bore) & ~holes(at, 0.036, hole, 6)
    return solid.sum() * each, (np.abs(at[solid]) ** 2).sum() * each


def disc_by_cells() -> tuple[float, float]:
    """Area and polar moment of a disc of the drive, by cells within its outline."""
    disc = drive().cycloid.disc(satellite_teeth=20, eccentricity=0.002)
    points = outline_points(disc=disc, chord_error=1e-7).points @ np.array([1, 1j])
    order = np.argsort(np.angle(points))
    at, each = cells(0.064)
    rim = np.interp(np.angle(at), np.angle(points)[order], np.abs(points)[order], period=2 * np.pi)
    solid = (np.abs(at) < rim) & (np.abs(at) > 0.021) & ~holes(at, 0.036, 0.00802, 6)
    return solid.sum() * each, (np.abs(at[solid]) ** 2).sum() * each


def test_masses_by_brute_sums() -> None:
    """Plates of 14.4 and a span of 46; housing 152 wide 46, its ring pins half in their seats."""
    found = masses(drive())
    area, _ = disc_by_cells()
    assert found["discs"] == pytest.approx(2 * STEEL * 0.020 * area, rel=1e-4)
    carrier, _ = plate(0.048, 0.0175, 0.006)
    for name in ("carrier", "second_carrier"):
        assert found[name] == pytest.approx(STEEL * 0.0144 * carrier, rel=1e-4)
    assert found["pins"] == pytest.approx(6 * STEEL * math.pi * 0.006**2 * 0.0748)
    assert found["ring_pins"] == pytest.approx(21 * STEEL * math.pi * 0.004**2 * 0.046)
    ring = math.pi * (0.076**2 - 0.065**2) - 10.5 * math.pi * 0.004**2
    assert found["housing"] == pytest.approx(STEEL * 0.046 * ring)
    eccentrics = 2 * 0.012 * 0.010**2
    between = (0.0604 + 0.010 - 0.024) * 0.0085**2  # bearings in the middles of the plates
    assert found["shaft"] == pytest.approx(STEEL * math.pi * (eccentrics + between))
    assert found["satellite_bearings"] == 2 * BEARINGS["6004"].mass
    assert found["bearing_a"] == found["bearing_b"] == BEARINGS["6003"].mass
    whole = mass(drive())
    assert whole.mass == pytest.approx(sum(each or 0.0 for each in found.values()), rel=SAME)
    marked = {each.code for each in whole.parts if each.estimate}
    assert marked == {"pins", "ring_pins", "shaft", "housing", "carrier", "second_carrier"}


def energy(*, turned: float, moment: float, whole: float, circle: float = 0.0) -> float:
    """Twice the kinetic energy at a speed of 1 of the crank of four points with a moment of inertia
    about their middle, which moves on a circle: by differences of their places.
    """
    radius, step = math.sqrt(moment / whole), 1e-4
    own = np.exp(0.5j * math.pi * np.arange(4)) * radius
    ways = [circle * np.exp(1j * t) + own * np.exp(1j * turned * t) for t in (-step, step)]
    return float((np.abs(ways[1] - ways[0]) ** 2).sum() / (2 * step) ** 2 * whole / 4)


@pytest.mark.parametrize(
    ("output", "carrier", "ring"), [("pins", -1 / 20, 0.0), ("ring", 0.0, 1 / 21)]
)
def test_inertia_by_the_motion_of_points(output: str, carrier: float, ring: float) -> None:
    design = drive(mechanism={"pins": 6, "ratio": 20.0, "output": output})
    found = {each.code: each.mass or 0.0 for each in mass(design).parts}
    (_, disc), (_, held) = disc_by_cells(), plate(0.048, 0.0175, 0.006)
    pins, pin, ball = found["pins"], 0.036**2 + 0.006**2 / 2, found["satellite_bearings"]
    thick, total = 2 * STEEL * math.pi * 0.010**2 * 0.012, found["shaft"]
    edge = STEEL * 0.046 * math.pi
    round_ring = edge / 2 * (0.076**4 - 0.065**4) - edge * 10.5 * 0.004**2 * (
        0.065**2 + 0.004**2 / 2
    )
    seats = found["ring_pins"] * (0.065**2 + 0.004**2 / 2)
    turning = {
        "discs": energy(
            turned=carrier, moment=2 * STEEL * 0.020 * disc, whole=found["discs"], circle=0.002
        ),
        "plates": energy(turned=carrier, moment=2 * STEEL * 0.0144 * held, whole=1.0),
        "pins": energy(turned=carrier, moment=pins * pin, whole=pins),
        "eccentrics": energy(turned=1.0, moment=thick * 0.010**2 / 2, whole=thick, circle=0.002),
        "between": (total - thick) * 0.0085**2 / 2,
        "ring": energy(turned=ring, moment=round_ring + seats, whole=1.0),
        "balls": ball * 0.002**2 + ball / 2 * (0.010**2 + 0.0155**2) / 2,
        "supports": 2 * found["bearing_a"] / 2 * (0.0085**2 + 0.013**2) / 2,
    }
    assert mass(design).inertia == pytest.approx(sum(turning.values()), rel=1e-4)


PARTS: dict[str, tuple[dict[str, Any], str]] = {
    "sleeves": ({"pin": {"diameter": 0.008}}, "sleeves"),
    "bored": ({"pin": {"bore_diameter": 0.004}}, "pins"),
    "every second pin": (
        {"mechanism": {"ratio": 21.0}, "gear": {"every_second_pin": True}},
        "ring_pins",
    ),
    "cantilever": ({"pin": {"support": "cantilever"}}, "pins"),
    "supported ring pins": (
        {"gear": {"pin_support": "supported", "span": 0.05, "satellite_positions": (0.01, 0.04)}},
        "housing",
    ),
    "no ring": ({"gear": None, "satellite_body": {"outer_radius": 0.060}}, "discs"),
    "aluminium": ({"contact": {"hole_material": "aluminium_7075_t6"}}, "discs"),
}
"""Designs, and a part of each."""

EXPECTED = {
    "sleeves": 12 * STEEL * math.pi * (0.006**2 - 0.004**2) * 0.020,
    "bored": 6 * STEEL * math.pi * (0.006**2 - 0.002**2) * 0.0748,
    "every second pin": 11 * STEEL * math.pi * 0.004**2 * 0.046,
    "cantilever": 6 * STEEL * math.pi * 0.006**2 * 0.0584,
    "supported ring pins": STEEL * math.pi * (0.076**2 - 0.069**2) * 0.046,
    "no ring": 2 * STEEL * math.pi * (0.060**2 - 0.021**2 - 6 * 0.00802**2) * 0.020,
    "aluminium": 2810.0,
}


@pytest.mark.parametrize("name", PARTS)
def test_parts_of_other_designs(name: str) -> None:
    changes, part = PARTS[name]
    found = masses(drive(**changes))[part]
    expected = EXPECTED[name]
    if name == "aluminium":
        expected *= (masses(drive())["discs"] or 0.0) / STEEL
    assert found == pytest.approx(expected)


def test_involute_discs_are_those_of_their_outline() -> None:
    """By the polygon that the drawing has; without shifts a plain disc of the reference circle."""
    from core.design.drawings import drawn_satellites

    teeth = {"kind": "involute", "module": 3e-3}
    shifts = {"satellite_profile_shift": 0.1, "ring_profile_shift": 0.46}
    heights = {"satellite_addendum": 0.8, "ring_addendum": 0.8}
    own: dict[str, Any] = {
        "mechanism": {"pins": 6, "satellites": 2, "satellite_teeth": 40, "ring_teeth": 42},
        "load": STATED["load"],
        "contact": STATED["contact"] | {"eccentricity": 0.00368},
        "pin": {"support": "supported"},
        "bearing": NAMED,
        "crankshaft": {"bearings": SEATED},
        "build": {},
    }
    design = design_of(own | {"gear": teeth | shifts | heights})
    (drawn,) = drawn_satellites(design=design, numbers=(1,), chord_error=5e-9)
    area, moment = polygon(drawn.outline)
    area -= math.pi * (0.021**2 + 6 * 0.0097**2)
    moment -= math.pi * (0.021**4 / 2 + 6 * 0.0097**2 * (0.036**2 + 0.0097**2 / 2))
    (discs, *_, housing, _, _) = mass(design).parts
    assert discs.mass == pytest.approx(2 * STEEL * 0.020 * area, rel=TEETH_ERROR)
    assert discs.solid and discs.solid.moment == pytest.approx(
        2 * STEEL * 0.020 * moment, rel=TEETH_ERROR
    )
    assert (discs.estimate, housing.estimate) == (False, True)
    inner = 0.063 + 0.46 * 3e-3  # reference circle of the ring and its shift
    outer = design.housing_diameter / 2
    assert housing.mass == pytest.approx(STEEL * math.pi * (outer**2 - inner**2) * 0.046)
    brass = design_of(own | {"gear": teeth | shifts | heights | {"ring_material": "brass"}})
    assert mass(brass).parts[-3].missing == ("gear.ring_material",)
    for own_shift in (0.0, 0.2):
        shifted = teeth | ({"satellite_profile_shift": own_shift} if own_shift else {})
        plain, *_, ring, _, _ = mass(design_of(own | {"gear": shifted})).parts
        outer = design_of(own | {"gear": shifted}).housing_diameter / 2
        assert ring.mass == pytest.approx(STEEL * math.pi * (outer**2 - 0.063**2) * 0.046)
        area = math.pi * ((0.060 + own_shift * 3e-3) ** 2 - 0.021**2 - 6 * 0.0097**2)
        assert (plain.mass, plain.estimate) == (pytest.approx(2 * STEEL * 0.020 * area), True)


def test_a_bolt_and_its_spacer() -> None:
    bolt = {"core_diameter": 0.005}
    found = masses(drive(pin={"bore_diameter": 0.0055, "bolt": section_of_bolt(bolt)}))
    spacer = STEEL * math.pi * (0.006**2 - 0.00275**2) * 0.0604
    assert found["pins"] == pytest.approx(6 * spacer)
    assert found["bolts"] == pytest.approx(6 * STEEL * math.pi * 0.0025**2 * 0.0748)


def section_of_bolt(stated: dict[str, Any]) -> Any:
    from core.output.pin_bolt import PinBolt

    return section(kind=PinBolt, stated=stated)


@pytest.mark.parametrize(
    ("changes", "part", "reason", "missing"),
    [
        ({"bearing": None}, "satellite_bearings", "section_missing", "bearing"),
        ({"crankshaft": {"bearings": ()}}, "bearing_a", "bearing_unnamed", "crankshaft.bearings"),
        (
            {"contact": {"hole_material": "brass"}},
            "discs",
            "density_unknown",
            "contact.hole_material",
        ),
        ({"gear": {"pin_material": "brass"}}, "ring_pins", "density_unknown", "gear.pin_material"),
        ({"pin": {"material": "brass"}}, "pins", "density_unknown", "pin.material"),
        (
            {"crankshaft": {"bearings": (SEATED[0], replace(SEATED[1], name=None))}},
            "bearing_b",
            "bearing_unnamed",
            "crankshaft.bearings[1].name",
        ),
    ],
)
def test_a_part_that_is_not_known_makes_the_mass_unknown(
    changes: dict[str, Any], part: str, reason: str, missing: str
) -> None:
    found = mass(drive(**changes))
    assert (found.mass, found.inertia) == (None, None)
    (lacks,) = (each for each in found.parts if each.code == part)
    assert (lacks.mass, lacks.reason, lacks.missing) == (None, reason, (missing,))


def test_counterweights_have_no_mass() -> None:
    from core.crank.balance import Counterweight

    weights = {"counterweights": (Counterweight(0.001, 0.0),), "satellite_mass": 1.0}
    found = mass(drive(crankshaft={"bearings": SEATED} | weights))
    reasons = {each.code: each.reason for each in found.parts if each.reason}
    assert reasons == {"counterweights": "counterweight_unknown"} and found.mass is None


def test_what_cannot_be_has_no_mass() -> None:
    """A bore wider than the carrier; a disc that its tool undercuts is refused."""
    wide = tuple(replace(each, outer_diameter=0.100) for each in SEATED)
    reasons = {each.code: each.reason for each in mass(drive(crankshaft={"bearings": wide})).parts}
    assert reasons["carrier"] == "cannot_be"
    with pytest.raises(InvalidInput, match="ring_pin_radius"):
        mass(drive(gear={"ring_pin_radius": 0.030}))


def test_both_outputs_need_their_speeds() -> None:
    both = drive(mechanism={"pins": 6, "ratio": 20.0, "output": "both"}, load={"ring_speed": 0.0})
    assert mass(both).inertia == pytest.approx(mass(drive()).inertia)
    unknown = mass(replace(both, load=replace(both.load, input_speed=None)))
    assert unknown.mass is not None and unknown.inertia is None


def test_a_coupling_has_no_cranks() -> None:
    sections: dict[str, Any] = dict.fromkeys(("gear", "bearing", "crankshaft", "pin"))
    body = {"outer_radius": 0.060, "bore_radius": 0.010}
    own = {"pins": 6, "output": "coupling", "satellites": 1}
    stated = {name: each for name, each in STATED.items() if name not in sections}
    found = mass(design_of(stated | {"mechanism": own, "satellite_body": body}))
    assert [each.code for each in found.parts] == ["discs", "pins", "housing", "carrier"]
    assert found.mass is not None and found.inertia is None


def test_a_bearing_without_sizes_is_asked_for() -> None:
    bare = RollingBearing(name="6004", kind="ball")
    (lacks,) = (each for each in mass(replace(drive(), bearing=bare)).parts if each.code == "discs")
    assert lacks.missing == ("satellite_body.bore_radius",)


def test_bearings_on_the_pins() -> None:
    """Each roller is 686ZZ, on pins of 6 mm."""
    rollers = {"name": "686", "per_satellite": 2}
    found = mass(drive(rollers=rollers, contact={"pin_radius": 0.0065}, pin={"diameter": 0.006}))
    (bearings,) = (each for each in found.parts if each.code == "pin_bearings")
    assert (bearings.count, bearings.estimate) == (24, False)
    assert bearings.mass == pytest.approx(24 * BEARINGS["686"].mass)


def solid(design: Design, code: str) -> Any:
    """Solid of a part."""
    (found,) = (each.solid for each in mass(design).parts if each.code == code)
    return found


def test_moments_of_parts_that_no_inertia_shows() -> None:
    rollers = drive(
        rollers={"name": "686"}, contact={"pin_radius": 0.0065}, pin={"diameter": 0.006}
    )
    bearings = solid(rollers, "pin_bearings")
    assert bearings.moment == pytest.approx(bearings.mass * 0.036**2)
    plain = solid(drive(gear=None, satellite_body={"outer_radius": 0.060}), "discs")
    hole = 0.00802
    moment = (0.060**4 - 0.021**4) / 2 - 6 * hole**2 * (0.036**2 + hole**2 / 2)
    assert plain.moment == pytest.approx(2 * STEEL * 0.020 * math.pi * moment)


def test_little_that_is_left_is_less_exact() -> None:
    """The error grows as the difference falls, here that of the mass below that of the moment."""
    body = {"outer_radius": 0.060, "bore_radius": 0.0275}
    left = 1 - (0.0275**2 + 6 * 0.00802**2) / 0.060**2
    found = drive(gear=None, satellite_body=body)
    assert solid(found, "discs").error == pytest.approx(2 * CLOSED / left)
    assert mass(found).accuracy.relative_error >= 2 * CLOSED / left


def test_plates_by_their_own_sizes() -> None:
    sizes = {"carrier_width": 0.010, "second_carrier_width": 0.016}
    bolt = section_of_bolt({"core_diameter": 0.005})
    found = masses(drive(build=sizes, pin={"bore_diameter": 0.0055, "bolt": bolt}))
    bored = 0.048**2 - 0.0175**2
    assert found["carrier"] == pytest.approx(STEEL * math.pi * 0.010 * (bored - 6 * 0.0025**2))
    second = STEEL * math.pi * 0.016 * (bored - 6 * 0.006**2)
    assert found["second_carrier"] == pytest.approx(second)


def test_a_shaft_of_its_own_sizes_and_satellites_beyond_its_bearings() -> None:
    """Eccentrics of 12 at −40 and −18, bearings of 10 at 0 and 60: 111 from −46 to 65."""
    places = {"satellite_positions": (-0.040, -0.018), "bearing_positions": (0.0, 0.060)}
    sizes = {"eccentric_diameter": 0.018, "shaft_diameter": 0.012}
    found = masses(drive(crankshaft={"bearings": SEATED} | places | sizes))
    round_ones = 0.024 * 0.009**2 + (0.111 - 0.024) * 0.006**2
    assert found["shaft"] == pytest.approx(STEEL * math.pi * round_ones)
    turned = {"satellite_positions": (0.100, 0.078), "bearing_positions": (0.0, 0.060)}
    found = masses(drive(crankshaft={"bearings": SEATED} | turned | sizes))
    round_ones = 0.024 * 0.009**2 + (0.106 + 0.005 - 0.024) * 0.006**2
    assert found["shaft"] == pytest.approx(STEEL * math.pi * round_ones)


def test_discs_with_two_lobes_less_are_not_those_of_one() -> None:
    teeth = {"pins": 6, "ratio": None, "satellite_teeth": 40, "ring_teeth": 42}
    mechanism = {name: each for name, each in teeth.items() if each is not None}
    stated = STATED | {"mechanism": mechanism | {"satellites": 2}, "bearing": NAMED}
    bare = mass(design_of(stated)).parts[0]
    assert bare.missing == ("satellite_body.outer_radius",)
    (discs, *_) = mass(design_of(stated | {"satellite_body": {"outer_radius": 0.060}})).parts
    assert discs.estimate
