"""Script of the solids of a reducer, run with a recorder in the place of build123d: volumes are
those of the masses, parts are where the drawings have them and do not meet.

`make office` runs such scripts with build123d itself.
"""

import cmath
import math
import sys
from copy import deepcopy
from dataclasses import dataclass, field, replace
from types import ModuleType

import numpy as np
import pytest

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import EXAMPLES, REQUESTS
from app.exports.build123d import SolidsRequest, write
from app.problems import Problem
from core.design.drawings import drawn_disc
from core.design.mass import mass
from core.material_table import MATERIALS
from core.output.elasticity import LinearLaw
from core.precision import EXACT
from core.ring.sharing import mesh_gaps
from tests.inputs.drawings import UNEVEN, distance

STEEL = MATERIALS["steel_structural"].material.density * 1e-9  # kg/mm^3


INPUTS = {each["id"]: each["input"] for each in EXAMPLES}


@dataclass
class Face:
    """Area, mm^2, with the circles that bound it: X + iY, radius, and points of an outline."""

    area: float
    circles: list = field(default_factory=list)
    points: np.ndarray = ()

    def __sub__(self, other):
        return Face(self.area - other.area, [*self.circles, *other.circles], self.points)


@dataclass
class Solid:
    """Volume, mm^3, of faces between two places along the axis."""

    volume: float
    stretches: list
    label: str = ""

    def __add__(self, other):
        return Solid(self.volume + other.volume, [*self.stretches, *other.stretches])


@dataclass
class Pos:
    x: float
    y: float
    z: float = 0.0

    def __mul__(self, other):
        at = complex(self.x, self.y)
        if isinstance(other, Face):
            return replace(other, circles=[(at + place, r) for place, r in other.circles])
        moved = [
            (face, low + self.z, high + self.z, at + place)
            for face, low, high, place in other.stretches
        ]
        return Solid(other.volume, moved)


@dataclass
class Curve:
    points: np.ndarray

    def rotate(self, axis, degrees):
        return Curve(self.points * np.exp(1j * math.radians(degrees)))

    def edges(self):
        return [self]


def curve(*points):
    return Curve(np.array(points) @ np.array([1, 1j]))


def make_face(edges):
    """Face within edges, each of which begins where the one before ends."""
    following = [*edges[1:], edges[0]]
    assert all(
        abs(a.points[-1] - b.points[0]) < 1e-8 for a, b in zip(edges, following, strict=True)
    )
    points = np.concatenate([each.points[:-1] for each in edges])
    area = (np.conj(np.roll(points, -1)) * points).imag.sum() / 2
    return Face(abs(float(area)), [], points)


def run(text):
    """Solids by name, and all pieces, as a script makes them with the recorder."""
    recorder = ModuleType("build123d")
    recorder.__dict__.update(
        Axis=type("Axis", (), {"Z": "z"}),
        Circle=lambda radius: Face(math.pi * radius**2, [(0j, radius)]),
        Compound=lambda label, children: children,
        Polyline=curve,
        Spline=curve,
        Pos=Pos,
        make_face=make_face,
        extrude=lambda face, height: Solid(face.area * height, [(face, 0.0, height, 0j)]),
        export_step=None,
    )
    before = sys.modules.get("build123d")
    sys.modules["build123d"] = recorder
    try:
        names = {"__name__": "script"}
        exec(compile(text, "reducer.py", "exec"), names)
        return names["bodies"](), names["reducer"]()
    finally:
        sys.modules.pop("build123d")
        if before:
            sys.modules["build123d"] = before


def made(design, sizes="nominal"):
    file = write(SolidsRequest(design=design, sizes=sizes))
    assert (file.name, file.media_type) == ("reducer.py", "text/x-python")
    return file.content.decode()


def test_volumes_are_those_of_the_masses():
    design = INPUTS["cycloid"]
    bodies, pieces = run(made(design))
    weights: dict[str, float] = {}
    for each in pieces:
        part = each.label.rstrip("0123456789").rstrip("_")
        weights[part] = weights.get(part, 0.0) + each.volume * STEEL
    known = mass(CrankPlanetaryRequest(**design).design)
    of_mass = {each.code: each.mass for each in known.parts}
    alike = {"pin": "pins", "carrier": "carrier", "second_carrier": "second_carrier"}
    for name, code in (alike | {"shaft": "shaft"}).items():
        assert weights[name] == pytest.approx(of_mass[code], rel=EXACT), name
    # Outlines are polygons here, and ring pins are of bearing steel.
    assert weights["satellite"] == pytest.approx(of_mass["discs"], rel=1e-4)
    bearing_steel = MATERIALS["steel_bearing"].material.density * 1e-9
    assert weights["ring_pin"] / STEEL * bearing_steel == pytest.approx(of_mass["ring_pins"])
    # The inner edge of the housing, by angles: the seat of a pin where there is one.
    ((housing, low, high, _),) = bodies["housing"][0].stretches
    outer, (_, circle), *seats = housing.circles
    angles = 2 * math.pi * (np.arange(200_000) + 0.5) / 200_000
    edge = np.full(len(angles), circle)
    for place, radius in seats:
        off = angles - cmath.phase(place)
        root = radius**2 - (abs(place) * np.sin(off)) ** 2
        far = abs(place) * np.cos(off) + np.sqrt(np.maximum(root, 0.0))
        edge = np.where((root > 0) & (np.cos(off) > 0), np.maximum(edge, far), edge)
    volume = math.pi * (outer[1] ** 2 - np.mean(edge**2)) * (high - low)
    assert volume * STEEL == pytest.approx(of_mass["housing"], rel=2e-3)  # there, half of each pin
    assert len(seats) == len(bodies["ring_pin"][1]) == 21


@pytest.mark.parametrize(
    ("design", "sizes", "share"),
    [(UNEVEN, "mean", 1.0), (UNEVEN, "nominal", 0.0), (INPUTS["cycloid"], "nominal", 1.0)],
    ids=["middle-of-a-fit", "nominal-of-a-fit", "clearance"],
)
def test_parts_touch_as_in_the_design(design, sizes, share):
    """Output pins are off their holes by the clearance, ring pins off the discs by their gaps. A
    fit has its clearance in the middle of its limits, and none in its nominal sizes.
    """
    text = made(design, sizes)
    said = {"nominal": "nominal", "mean": "the middle of their limits"}
    assert f"Diameters are {said[sizes]}." in text
    bodies, _ = run(text)
    core = CrankPlanetaryRequest(**design).design
    mesh = core.gear.cycloid_mesh(
        disc=drawn_disc(design=core),
        crank_angles=core.built.crank_angles,
        contact_length=core.ring_length,
        disc_material=core.disc_material,
        law=LinearLaw(1e8),
    )
    gaps = 1e3 * np.array(mesh_gaps(mesh=mesh, crank_angle=0.0))
    (ring_pin, around), (pin, places) = bodies["ring_pin"], bodies["pin"]
    ((tool, *_),), ((shank, *_),) = ring_pin.stretches, pin.stretches
    centres = np.array(around) @ np.array([1, 1j])
    for number, gap in enumerate(gaps, 1):
        ((face, low, high, centre),) = bodies[f"satellite_{number}"][0].stretches
        assert (low + high) / 2 == pytest.approx(1e3 * core.disc_places[number - 1], abs=1e-8)
        for x, y in places:
            at = complex(x, y) - centre
            hole, radius = min(face.circles, key=lambda each: abs(each[0] - at))
            room = radius - abs(at - hole) - shank.circles[0][1]
            assert room == pytest.approx(share * 1e3 * core.known_clearance, abs=1e-6)
        found = distance(centres - centre, face.points) - tool.circles[0][1]
        assert found == pytest.approx(gap, abs=0.005)


def test_involute_teeth_are_an_opening_of_the_housing():
    bodies, _ = run(made(INPUTS["involute"]))
    assert not [name for name in bodies if name.startswith("ring_pin")]
    ((housing, *_),) = bodies["housing"][0].stretches
    ((disc, *_, centre),) = bodies["satellite_1"][0].stretches
    assert np.abs(disc.points + centre).max() > housing.circles[0][1] * 0.5
    assert housing.area > 0


def test_a_part_of_unknown_size_is_left_out_and_named():
    text = made(REQUESTS["export/build123d"]["design"])
    assert "Left out:\n    shaft: design.crankshaft is not known\n" in text
    bodies, _ = run(text)
    assert {*bodies} == {"satellite_1", "satellite_2", "housing", "ring_pin", "pin", "carrier"}

    design = deepcopy(INPUTS["cycloid"])
    for bearing in design["crankshaft"]["bearings"]:
        del bearing["width_mm"]
    design["crankshaft"] |= {
        "satellite_mass_kg": 1.3,
        "counterweights": [{"position_mm": 70.0, "unbalance_kg_mm": 0.1}],
    }
    text = made(design)
    for name in ("bearings.0.width_mm", "bearings.1.width_mm", "counterweights"):
        assert f"design.crankshaft.{name} is not known" in text
    journal, *_ = run(text)[0]["shaft"][0].stretches
    # From the place of the bearing, as far before the first disc as on the crankshaft.
    assert journal[1] == pytest.approx(13.0 - 30.0, abs=1e-8)


def test_bearings_and_bolts_on_the_pins_are_there():
    design = deepcopy(REQUESTS["export/build123d"]["design"])
    pin = {"support": "cantilever", "diameter_mm": 6.0, "material": "steel_through_hardened"}
    bearing = {"kind": "ball", "bore_diameter_mm": 6.0, "outer_diameter_mm": 10.0, "width_mm": 3.0}
    bodies, _ = run(made(design | {"pin": pin, "rollers": bearing}))
    ((ring, low, high, _),) = bodies["pin_bearing_of_satellite_1"][0].stretches
    assert [radius for _, radius in ring.circles] == [5.0, 3.0]
    assert high - low == pytest.approx(12.0)
    pin |= {"diameter_mm": 10.0, "bolt": {"core_diameter_mm": 4.0}}
    bodies, pieces = run(made(design | {"pin": pin}))
    bolts = [each for each in pieces if each.label.startswith("bolt")]
    core = SolidsRequest(design=design | {"pin": pin}).design.design
    of_mass = {each.code: each.mass for each in mass(core).parts}["bolts"]
    assert len(bolts) == 6
    assert STEEL * sum(each.volume for each in bolts) == pytest.approx(of_mass, rel=EXACT)


def test_a_shape_that_is_not_known_is_refused_at_its_field():
    design = deepcopy(REQUESTS["export/build123d"]["design"])
    del design["gear"]["modification"]
    with pytest.raises(Problem) as refused:
        made(design)
    (error,) = refused.value.errors
    assert (error.pointer, error.code) == ("/design/gear/modification", "needed_to_draw")
