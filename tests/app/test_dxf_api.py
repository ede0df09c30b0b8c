"""Parts of a design as DXF files over REST, read again by the library: what is drawn is where the
design says it is, to its stated error; what is not known is not drawn.
"""

import io
import itertools
import json
import math
import os
import sys
import zipfile
from copy import deepcopy
from functools import partial
from typing import NamedTuple

import ezdxf
import numpy as np
import pytest
from ezdxf.math import Vec2, bulge_to_arc

from app import VERSION
from app.endpoint import calculated, read_body
from app.examples import EXAMPLES, REQUESTS
from app.exports.drawn import MOST_CIRCLES
from app.exports.dxf import DXF, LAYERS, ZIP, DxfRequest, write
from app.problems import Problem
from app.registry import EXPORTS
from app.settings import Settings
from core.output.elasticity import LinearLaw
from core.ring.sharing import mesh_gaps
from tests.inputs.children import ran
from tests.inputs.drawings import UNEVEN, distance

pytestmark = pytest.mark.anyio

PATH = "export/dxf"

ALL = ["satellite_1", "satellite_2", "satellite_3", "ring_pins"]


def changed(body, path, value):
    """A body with another value at a pointer, None for none."""
    body = deepcopy(body)
    *above, name = path.strip("/").split("/")
    place = body
    for each in above:
        place = place.setdefault(each, {})
    if value is None:
        del place[name]
    else:
        place[name] = value
    return body


def read(content):
    return ezdxf.read(io.StringIO(content.decode()))


def files(design, *, parts=ALL, chord_error_mm=0.01, **more):
    """Drawings of parts, by their names; of all for no parts."""
    more |= {"parts": parts} if parts else {}
    body = DxfRequest(design=design, chord_error_mm=chord_error_mm, **more)
    file = write(body)
    if file.media_type == DXF:
        return body, {file.name.removesuffix(".dxf"): read(file.content)}
    with zipfile.ZipFile(io.BytesIO(file.content)) as bundle:
        assert bundle.testzip() is None
        return body, {
            name.removesuffix(".dxf"): read(bundle.read(name))
            for name in bundle.namelist()
            if name.endswith(".dxf")
        }


def circles(drawing, layer):
    """Centres, X + iY, and radii of the circles of a layer, in the order of the file."""
    found = drawing.modelspace().query(f'CIRCLE[layer=="{layer}"]')
    centres = [complex(each.dxf.center.x, each.dxf.center.y) for each in found]
    return np.array(centres), [each.dxf.radius for each in found]


def polylines(drawing):
    """X + iY of the points of closed polylines, and the bulges of their sides."""
    found = drawing.modelspace().query('LWPOLYLINE[layer=="OUTLINE"]')
    assert all(each.closed for each in found)
    rows = [np.array(each.get_points("xyb")) for each in found]
    return [(each[:, :2] @ np.array([1, 1j]), each[:, 2]) for each in rows]


def outline(drawing):
    ((points, bulges),) = polylines(drawing)
    assert not bulges.any()
    return points


def sections(drawing):
    """Rectangles of the view from the left: least and largest Z from the first end, and Y."""
    some = [points for points, _ in polylines(drawing) if len(points) == 4]
    first = min(points.real.min() for points in some)
    return sorted(
        tuple(
            round(each, 9) + 0.0
            for axis in (points.real - first, points.imag)
            for each in (axis.min(), axis.max())
        )
        for points in some
    )


def texts(drawing):
    return [each.dxf.text for each in drawing.modelspace().query("TEXT")]


def rows(drawing, *titles):
    """Cells of the table with these titles, row by row."""
    found = texts(drawing)
    first = next(n for n in range(len(found)) if found[n : n + len(titles)] == [*titles])
    cells = found[first + len(titles) :]
    return [tuple(cells[n : n + len(titles)]) for n in range(0, len(cells), len(titles))]


def said(drawing, name):
    return float(drawing.header.custom_vars.get(name))


def centre(drawing):
    return complex(said(drawing, "centre_x_mm"), said(drawing, "centre_y_mm"))


def gaps_mm(design, angle):
    """Smallest gap of each satellite to the ring's pins as the mesh is calculated, mm."""
    mesh = design.gear.cycloid_mesh(
        disc=design.gear.disc(satellite_teeth=11, eccentricity=2.5e-3),
        crank_angles=design.built.crank_angles,
        contact_length=design.ring_length,
        disc_material=design.disc_material,
        law=LinearLaw(1e8),
    )
    return 1e3 * np.array(mesh_gaps(mesh=mesh, crank_angle=math.radians(angle)))


@pytest.mark.parametrize("start", [0.0, 25.0, 180.0])
def test_each_ring_pin_is_as_far_from_the_outline_as_the_gap_says(start):
    """Satellites put back to their centres stand in the ring as the mesh is calculated."""
    design = changed(UNEVEN, "/mechanism/initial_crank_angle_deg", start)
    body, drawn = files(design, chord_error_mm=0.002)
    pins, radii = circles(drawn["ring_pins"], "PINS")
    assert radii == [5.0] * 12
    gaps = gaps_mm(body.design.design, angle=0.0)
    assert np.ptp(gaps) > 0.01  # those of a tooth aside differ by more than the error
    for gap, name in zip(gaps, ALL[:3], strict=True):
        drawing = drawn[name]
        found = distance(pins, outline(drawing) + centre(drawing)) - 5.0
        assert found == pytest.approx(gap, abs=said(drawing, "chord_error_mm") + 1e-9)


async def test_holes_and_cranks_are_where_the_answer_has_them(api):
    """In the order of its numbers: nothing is mirrored."""
    answer = (await api.post("crank-planetary", json=UNEVEN | {"include": ["geometry"]})).json()
    holes = {}
    for pair in answer["geometry"]["pairs"]:
        holes.setdefault(f"satellite_{pair['satellite']}", []).append(
            complex(*pair["hole_centre_mm"])
        )
    _, drawn = files(UNEVEN)
    for name, expected in holes.items():
        centres, radii = circles(drawn[name], "HOLES")
        assert centres + centre(drawn[name]) == pytest.approx(np.array(expected), abs=1e-9)
        assert radii == pytest.approx([6.5] * 5, abs=1e-9)  # of a fit, whose clearance is between
        assert circles(drawn[name], "BORE") == (0j, [14.0])
    pins, _ = circles(drawn["ring_pins"], "PINS")
    turns = np.angle(np.roll(pins, -1) / pins)
    assert turns == pytest.approx([2 * math.pi / 12] * 12)  # anticlockwise
    ahead = np.angle([pins[0] / centre(drawn[name]) for name in ALL[:3]], deg=True)
    assert ahead % 360 == pytest.approx([10.0, 95.0, 250.0])  # cranks turn clockwise


@pytest.mark.parametrize("error", [0.3, 0.01, 1e-4])
def test_the_chord_error_that_is_said_is_that_of_the_outline(error):
    """The curve is made here from the tool's path, with 200 places on each side of a lobe."""
    _, drawn = files(UNEVEN, parts=["satellite_1"], chord_error_mm=error)
    polygon, stated = outline(drawn["satellite_1"]), said(drawn["satellite_1"], "chord_error_mm")
    assert stated <= error
    each, left = divmod(len(polygon), 11)
    assert left == 0
    t = np.linspace(0, 2 * math.pi / 11, 200 * each, endpoint=False)
    path = 49.8j * np.exp(-1j * t) - 2.5j * np.exp(-12j * t)
    along = 49.8 * np.exp(-1j * t) - 30 * np.exp(-12j * t)
    curve = path - 5.05j * along / np.abs(along)
    turn = math.radians(10 / 11 - 25)
    ends = np.append(polygon, polygon[0])[: each + 1] * np.exp(-1j * turn)
    sides = np.diff(ends).repeat(200)
    aside = np.abs(((curve - ends[:-1].repeat(200)) / sides).imag) * np.abs(sides)
    assert aside.max() == pytest.approx(stated, rel=1e-3, abs=1e-9)
    assert f"{stated:.4g} mm from the outline at most" in "".join(
        text.dxf.text for text in drawn["satellite_1"].modelspace().query("TEXT")
    )


def test_what_a_program_for_drawing_reads():
    _, drawn = files(UNEVEN)
    assert list(drawn) == ALL
    for name, drawing in drawn.items():
        found = drawing.audit()
        assert not found.errors and not found.fixes
        assert drawing.dxfversion == "AC1024" and drawing.units == 4
        assert drawing.header["$INSUNITS"] == 4 and drawing.header["$MEASUREMENT"] == 1
        assert drawing.header.custom_vars.get("part") == name
        assert drawing.header.custom_vars.get("made_by") == f"KHV Calc {VERSION}"
        assert {*LAYERS} <= {layer.dxf.name for layer in drawing.layers}
        assert drawing.layers.get("CENTRE").dxf.linetype == "CENTER"
        kinds = {(each.dxftype(), each.dxf.layer) for each in drawing.modelspace()}
        own = {("CIRCLE", "PINS")}
        if name != "ring_pins":
            own = {("LWPOLYLINE", "OUTLINE"), ("CIRCLE", "HOLES"), ("CIRCLE", "BORE")}
        lines = {("CIRCLE", "CENTRE"), ("LINE", "CENTRE")}
        assert kinds == own | lines | {("TEXT", "TITLE"), ("LINE", "TITLE")}
        assert texts(drawing)[:5] == ["1", "2", "3", "4", "5"]


async def test_a_part_is_a_file_and_several_are_a_zip(api):
    body = REQUESTS[PATH]
    single = await api.post(PATH, json=body | {"parts": ["satellite_2", "satellite_2"]})
    assert single.status_code == 200, single.text
    assert single.headers["content-type"] == DXF
    assert single.headers["content-disposition"] == 'attachment; filename="satellite_2.dxf"'
    assert single.headers["content-encoding"] == "gzip"
    assert "Bore 36 mm" in single.text
    bundle = await api.post(PATH, json=body)
    assert bundle.headers["content-type"] == ZIP
    assert bundle.headers["content-disposition"] == 'attachment; filename="parts.zip"'
    with zipfile.ZipFile(io.BytesIO(bundle.content)) as packed:
        assert packed.namelist() == ["satellite_1.dxf", "satellite_2.dxf", "ring_pins.dxf"]
        assert packed.read("satellite_2.dxf") == single.content
    refused = await api.post(PATH, json=body | {"parts": ["lid"]})
    assert refused.status_code == 422
    assert refused.headers["content-type"] == "application/problem+json"


WRITE = """
import sys
from app.examples import REQUESTS
from app.exports.dxf import DxfRequest, write
body = DxfRequest(**REQUESTS["export/dxf"])
before = "ezdxf" in sys.modules
sys.stdout.buffer.write(write(body).content if not before else b"")
"""


def test_the_same_bytes_in_another_process_and_no_library_before_a_file_is_asked():
    """Seconds later, and where sets of texts have another order."""
    env = os.environ | {"PYTHONHASHSEED": "4"}
    there = ran(sys.executable, "-c", WRITE, env=env, text=False).stdout
    assert there == write(DxfRequest(**REQUESTS[PATH])).content


BODY = {"design": UNEVEN, "parts": ALL}


def asked(body):
    """The file of a request, as the service reads and writes it."""
    export = EXPORTS[PATH]
    request = read_body(export, json.dumps(body).encode(), Settings())
    return calculated(request, partial(export.write, request))


def refused(body):
    """Problem of the one wrong field of a request."""
    with pytest.raises(Problem) as caught:
        asked(body)
    (error,) = caught.value.errors
    return error


@pytest.mark.parametrize(
    ("path", "value", "pointer", "code"),
    [
        ("/design/gear/ring_pin_radius_mm", 15.0, None, "undercut"),
        ("/design/gear/ring_pin_circle_radius_mm", 29.9, None, "no_cycloid"),
        ("/design/gear/modification/rotation_arcmin", 1.0, None, "flanks_not_drawn"),
        ("/design/gear/modification", None, None, "needed_to_draw"),
        ("/design/gear/ring_pin_radius_mm", None, None, "needed_to_draw"),
        ("/design/gear", None, None, "needed_to_draw"),
        ("/design/gear", {"radial_force_ratio": 0.3}, "/design/gear/kind", "no_tooth_form"),
        ("/design/contact/fit", None, "/design/contact/hole_clearance_mm", "needed_to_draw"),
        ("/design/load", None, None, "needed_to_draw"),
        ("/design/load/pin_circle_radius_mm", 37.0, None, "less_than"),
        ("/design/load/pin_circle_radius_mm", 11.0, None, "greater_than"),
        ("/design/satellite_body/bore_radius_mm", 21.0, None, "less_than"),
        ("/design/mechanism/ring_teeth", 13, None, "not_this_cycloid"),
        ("/design/mechanism/pins", MOST_CIRCLES, None, "too_many_pairs"),
        ("/design/deviations/ring_pin_radial_mm", [0.01], None, "different_length"),
        ("/parts/1", "lid", None, "no_such_part"),
        ("/parts/1", "second_carrier", "/design/build/second_carrier_width_mm", "needed_to_draw"),
        ("/parts/1", "shaft", "/design/crankshaft", "needed_to_draw"),
        ("/crank_angle_deg", 1.1e6, None, "less_than_equal"),
        ("/sizes", "largest", None, "literal_error"),
        ("/title_block", {"title": "two\nlines"}, "/title_block/title", "not_valid"),
        ("/parts/1", "satellite_4", None, "no_such_part"),
        ("/parts/1", "ring", None, "no_such_part"),
        ("/parts/1", "satellite_01", None, "no_such_part"),
        ("/chord_error_mm", 0.0, None, "greater_than_equal"),
        ("/chord_error_mm", 1.5, None, "less_than_equal"),
        ("/profile", "spline", None, "extra_forbidden"),
    ],
)  # fmt: skip
def test_what_cannot_be_drawn_is_refused_by_its_field(path, value, pointer, code):
    whole = path.startswith("/parts")
    error = refused(BODY | {"parts": ["ring_pins", value]} if whole else changed(BODY, path, value))
    assert (error.pointer, error.code) == (pointer or path, code)


INVOLUTE = next(each["input"] for each in EXAMPLES if each["id"] == "involute")


def test_involute_teeth_are_drawn_with_their_ring():
    """Between roots and tips, as many as there are; that they mesh is the core's test."""
    body, drawn = files(INVOLUTE, parts=["satellite_2", "ring"], chord_error_mm=0.002)
    pair = body.design.results.ring.pair
    for name, ends, teeth in (
        ("satellite_2", (pair.teeth.satellite_root, pair.teeth.satellite_tip), 40),
        ("ring", (pair.teeth.ring_tip, pair.ring_root_radius), 42),
    ):
        points = outline(drawn[name])
        assert (abs(points).min(), abs(points).max()) == pytest.approx([1e3 * e for e in ends])
        pitch = len(points) // teeth
        turned = np.exp(-2j * math.pi / teeth)
        assert points[pitch : 2 * pitch] == pytest.approx(points[:pitch] * turned)
        assert 0 < said(drawn[name], "chord_error_mm") <= 0.002
    assert len(circles(drawn["satellite_2"], "HOLES")[1]) == 8
    assert not circles(drawn["ring"], "HOLES")[1]


@pytest.mark.parametrize(
    ("path", "value", "pointer", "code"),
    [
        ("/design/gear/ring_profile_shift", None, None, "needed_to_draw"),
        ("/parts/0", "ring_pins", None, "no_such_part"),
        ("/design/gear/reference_pressure_angle_deg", 31.0, "/design/gear/kind", "outside_method"),
    ],
)
def test_involute_teeth_that_cannot_be_drawn_are_refused(path, value, pointer, code):
    body = {"design": INVOLUTE, "parts": ["satellite_1", "ring"]}
    if path == "/parts/0":
        body["parts"] = [value]
    else:
        body = changed(body, path, value)
    error = refused(body)
    assert (error.pointer, error.code) == (path if pointer is None else pointer, code)


def test_a_typed_ratio_is_drawn_where_it_is_whole():
    typed = {**UNEVEN["mechanism"], "ratio": 11.0}
    del typed["satellite_teeth"], typed["ring_teeth"]
    design = UNEVEN | {"mechanism": typed}
    assert asked(BODY | {"design": design}) == asked(BODY)
    typed["ratio"] = 11.5
    assert refused(BODY | {"design": design}).pointer == "/design/mechanism/satellite_teeth"
    typed["ratio"] = 2000.0
    wide = changed(design, "/gear/ring_pin_circle_radius_mm", 9000.0)
    error = refused(BODY | {"design": wide})
    assert (error.pointer, error.params) == ("/design/mechanism/ring_teeth", {"limit": 1000})


def test_the_smallest_chord_error_that_is_said_is_drawn():
    """All satellites of a request share the points."""
    body = {"design": UNEVEN, "parts": ALL, "chord_error_mm": 1e-6}
    limit = refused(body).params["limit"]
    parts, _ = DxfRequest(**body | {"chord_error_mm": limit}).drawn()
    assert 190_000 < sum(len(part.outlines[0].points) for part in parts[:3]) <= 200_000
    ((alone,), _) = DxfRequest(**body | {"parts": ALL[2:3]}).drawn()
    assert len(alone.outlines[0].points) > 70_000


async def test_a_disc_without_pins_is_drawn_without_holes(api):
    body = {"design": deepcopy(UNEVEN), "parts": ["satellite_1"]}
    whole = ezdxf.read(io.StringIO((await api.post(PATH, json=body)).text)).modelspace()
    design = body["design"]
    del design["load"], design["mechanism"]["pins"]
    design["contact"] = {"eccentricity_mm": 2.5}
    answer = await api.post(PATH, json=body)
    assert answer.status_code == 200, answer.text
    plain = ezdxf.read(io.StringIO(answer.text)).modelspace()
    assert len(whole.query('CIRCLE[layer=="HOLES"]')) == 5
    assert not plain.query('CIRCLE[layer=="HOLES"]')
    outlines = [
        [*each.query('LWPOLYLINE[layer=="OUTLINE"]').first.vertices()] for each in (whole, plain)
    ]
    assert outlines[0] == outlines[1]
    design["contact"] |= {"pin_radius_mm": 4.0, "contact_length_mm": 10.0, "fit": "H7/f7"}
    (error,) = (await api.post(PATH, json=body)).json()["errors"]
    assert error["pointer"] in ("/design/load/pin_circle_radius_mm", "/design/load")


WHOLE = UNEVEN | {
    "pin": {"support": "fixed", "diameter_mm": 8.0, "material": "steel_through_hardened"},
    "crankshaft": {"bearings": [
        {"kind": "ball", "bore_diameter_mm": 12.0, "outer_diameter_mm": 24.0, "width_mm": 6.0},
        {"kind": "ball", "bore_diameter_mm": 12.0, "outer_diameter_mm": 24.0, "width_mm": 6.0},
    ]},
    "build": {
        "gap_mm": 1.0, "carrier_width_mm": 9.0, "second_carrier_width_mm": 7.0,
        "carrier_diameter_mm": 72.0, "housing_diameter_mm": 124.0, "housing_width_mm": 32.0,
    },
}  # fmt: skip
"""All parts of the uneven reducer: discs from 1, 12 and 23 mm on."""

HOLES = ("No.", "X", "Y", "D", "Limits")
STEPS = ("Step", "Z from", "Z to", "D", "X", "Y")
PARTS = ("Part", "Pieces", "Z from", "Z to", "X", "Y")


async def drawn_at(api, angle):
    """Pins and holes, X + iY, as the service has them at a crank angle, deg."""
    body = WHOLE | {"include": ["geometry"], "crank_angle_deg": angle}
    geometry = (await api.post("crank-planetary", json=body)).json()["geometry"]
    pins = [complex(*each["centre_mm"]) for each in geometry["pins"]]
    holes = [complex(*each["hole_centre_mm"]) for each in geometry["pairs"]]
    return np.array(pins), np.array(holes).reshape(3, 5)


@pytest.mark.parametrize(("name", "seat"), [("carrier", 24.0), ("second_carrier", 24.0)])
async def test_plates_are_drilled_where_the_pins_are(api, name, seat):
    pins, _ = await drawn_at(api, 0.0)
    _, drawn = files(WHOLE, parts=[name])
    centres, radii = circles(drawn[name], "HOLES")
    assert centres == pytest.approx(pins, abs=1e-9)
    assert radii == pytest.approx([4.0] * 5, abs=1e-9)
    assert circles(drawn[name], "BORE") == (0j, [seat / 2])
    assert circles(drawn[name], "OUTLINE") == (0j, [36.0])
    width = 9.0 if name == "carrier" else 7.0
    # The first hole is cut at 27 mm, the two below are not.
    spans = [(-36.0, -12.0), (12.0, 23.0), (31.0, 36.0)]
    assert sections(drawn[name]) == [(0.0, width, *each) for each in spans]
    table = rows(drawn[name], *HOLES)
    assert [each[0] for each in table] == ["1", "2", "3", "4", "5", "bore"]
    listed = np.array([complex(float(x), float(y)) for _, x, y, *_ in table[:5]])
    assert listed == pytest.approx(pins, abs=1e-6)
    assert {each[3:] for each in table[:5]} == {("8", "not given")}
    assert table[5][1:] == ("0", "0", "24", "not given")


async def test_the_housing_has_its_pins_seats_and_arcs_between_them(api):
    _, drawn = files(WHOLE, parts=["housing", "ring_pins"])
    pins, _ = circles(drawn["ring_pins"], "PINS")
    seats, radii = circles(drawn["housing"], "HOLES")
    assert seats == pytest.approx(pins, abs=1e-9)
    assert radii == pytest.approx([5.0] * 12, abs=1e-9)
    assert circles(drawn["housing"], "OUTLINE") == (0j, [62.0])
    (points, bulges), *_ = polylines(drawn["housing"])
    arcs = []
    for start, end, bulge in zip(points, np.roll(points, -1), bulges, strict=True):
        corners = (Vec2(each.real, each.imag) for each in (start, end))
        place, *_, radius = bulge_to_arc(*corners, bulge)
        arcs.append((complex(place.x, place.y), radius))
        assert bulge > 0  # anticlockwise about the axis, seats outside
    assert np.array([place for place, _ in arcs[::2]]) == pytest.approx(pins, abs=1e-9)
    assert [radius for _, radius in arcs] == pytest.approx([5.0, 50.0] * 12, abs=1e-9)
    assert np.array([place for place, _ in arcs[1::2]]) == pytest.approx(0, abs=1e-9)
    middles = points[::2] + 0.5 * (points[1::2] - points[::2])
    assert (abs(middles) < 50.0).all() and (abs(bulges[::2]) > 1).all()
    # No pin is cut: the first ones are 25 and 5 degrees off the plane.
    bore = math.sqrt(5.0**2 - (50 * math.sin(math.radians(5))) ** 2) + 50 * math.cos(
        math.radians(5)
    )
    (z0, z1, _, high), (_, _, low, top) = sections(drawn["housing"])
    assert (z0, z1, top) == (0.0, 32.0, 62.0)
    assert (-high, low) == pytest.approx((bore, bore), abs=1e-8)


def test_the_housing_of_involute_teeth_has_those_of_the_ring():
    _, drawn = files(INVOLUTE, parts=["ring", "housing"], chord_error_mm=0.01)
    ((teeth, _), *cut) = polylines(drawn["housing"])
    assert teeth == pytest.approx(outline(drawn["ring"]), abs=1e-9)
    assert circles(drawn["housing"], "OUTLINE")[1][0] > abs(teeth).max()
    assert len(cut) == 2


def test_the_crankshaft_has_its_steps_and_eccentrics():
    """Cranks of 10, 95 and 250 degrees, 25 more at first, point clockwise from Y."""
    _, drawn = files(WHOLE, parts=["shaft"])
    turned = np.radians(25.0 + np.array([10.0, 95.0, 250.0]))
    cranks = 2.5 * (np.sin(turned) + 1j * np.cos(turned))
    found = dict(zip(*circles(drawn["shaft"], "OUTLINE")[::-1], strict=False))
    assert found[6.0] == 0
    centres, radii = circles(drawn["shaft"], "OUTLINE")
    assert radii == [6.0, 7.5, 7.5, 7.5]
    assert centres[1:] == pytest.approx(cranks, abs=1e-9)
    # Bearings of the satellites are 9 mm wide, those of the shaft 6 mm in the middle of plates.
    edges = [-7.5, 1.5, 10.5, 12.5, 21.5, 23.5, 32.5, 40.5]
    steps = [(float(z0), float(z1)) for _, z0, z1, *_ in rows(drawn["shaft"], *STEPS)]
    assert steps == [*itertools.pairwise(edges)]
    wide = [12.0, 15.0, 12.0, 15.0, 12.0, 15.0, 12.0]
    at = [0.0, cranks[0].imag, 0.0, cranks[1].imag, 0.0, cranks[2].imag, 0.0]
    views = [
        (low + 7.5, high + 7.5, y - d / 2, y + d / 2)
        for (low, high), d, y in zip(steps, wide, at, strict=True)
    ]
    assert np.array(sections(drawn["shaft"])) == pytest.approx(np.array(views), abs=1e-8)


@pytest.mark.parametrize("angle", [0.0, 37.0, -130.0, 3500.0])
async def test_the_assembly_is_that_of_the_crank_angle(api, angle):
    """Pins and all holes are where the answer has them, discs are off ring pins by the gaps."""
    pins, holes = await drawn_at(api, angle)
    body, drawn = files(WHOLE, parts=["assembly"], crank_angle_deg=angle, chord_error_mm=0.002)
    drawing = drawn["assembly"]
    assert said(drawing, "crank_angle_deg") == angle
    centres, radii = circles(drawing, "PINS")
    ring, own = centres[np.array(radii) == 5.0], centres[np.array(radii) == 4.0]
    assert own == pytest.approx(pins, abs=1e-9)
    turns = math.radians(25.0) - 2 * math.pi * np.arange(12) / 12
    assert ring == pytest.approx(50 * (np.sin(turns) + 1j * np.cos(turns)), abs=1e-9)
    drilled, radii = circles(drawing, "HOLES")
    assert drilled == pytest.approx(holes.ravel(), abs=1e-9)
    assert radii == pytest.approx([6.5] * 15, abs=1e-9)

    gaps = gaps_mm(body.design.design, angle)
    discs = [points for points, _ in polylines(drawing) if len(points) > 100]
    for gap, disc in zip(gaps, discs, strict=True):
        assert distance(ring, disc) - 5.0 == pytest.approx(gap, abs=0.002 + 1e-9)

    hidden = {
        name: [each.dxf.linetype for each in drawing.modelspace().query(f'CIRCLE[layer=="{name}"]')]
        for name in ("HOLES", "PINS")
    }
    assert hidden == {"HOLES": ["HIDDEN"] * 10 + ["BYLAYER"] * 5, "PINS": ["BYLAYER"] * 17}
    table = {part: cells for part, *cells in rows(drawing, *PARTS)}
    assert table["satellite 2"][:3] == ["1", "12", "22"]
    assert table["ring pin"] == ["12", "1", "33", "", ""]
    assert table["second carrier"][:3] == ["1", "34", "41"]
    place = complex(*map(float, table["satellite 3"][3:]))
    assert place == pytest.approx(np.mean(holes[2] - pins), abs=1e-6)


def test_the_cut_assembly_is_that_along_the_axis():
    """At the crank angle 0, where each piece of a disc at X = 0 is between outline, hole, bore."""
    _, drawn = files(WHOLE, parts=[*ALL[:3], "assembly"], chord_error_mm=0.001)
    cuts = sections(drawn["assembly"])
    first = -9.0  # the outer face of the carrier
    for name, low in zip(ALL[:3], (1.0, 12.0, 23.0), strict=True):
        at = centre(drawn[name])
        own = [each[2:] for each in cuts if each[:2] == (low - first, low + 10 - first)]
        inside, around = Path(outline(drawn[name]) + at), circles(drawn[name], "HOLES")[0] + at
        for y in np.arange(-52, 52, 0.37):
            solid = inside.has(1j * y) and abs(1j * y - at) > 14.0
            solid = solid and (abs(1j * y - around) > 6.5).all()
            assert solid == any(start < y < end for start, end in own), (name, y)
    pin = [each for each in cuts if each[2:] == (23.0, 31.0)]
    assert pin == [(0.0, 50.0, 23.0, 31.0)]
    crossed = drawn["assembly"].modelspace().query('LINE[layer=="HATCH"]')
    assert len(crossed) == 2 * 2 * 5  # both halves of five bearings


class Path(NamedTuple):
    """Closed polygon."""

    points: np.ndarray

    def has(self, place):
        """True if a place is within it."""
        sides = np.roll(self.points, -1) - place, self.points - place
        return abs(np.angle(sides[0] / sides[1]).sum()) > 3


@pytest.mark.parametrize(
    ("changes", "hole", "pin", "words"),
    [
        # H7 of 13 mm: 0 to 18, f7 of 8 mm: -28 to -13 micrometres
        ({}, 13.009, 7.9795, ("13", "H7 +0.018/0")),
        (
            {"/contact/fit": None, "/contact/hole_clearance_mm": 0.02,
             "/tolerances": {"hole_diameter": {"lower_mm": -0.01, "upper_mm": 0.03},
                             "pin_diameter": {"class": "m6"}}},
            13.05, 8.0105, ("13.04", "+0.03/-0.01"),
        ),
        ({"/contact/fit": None, "/contact/hole_clearance_mm": 0.02}, 13.04, 8.0,
         ("13.04", "not given")),
    ],
)  # fmt: skip
def test_sizes_are_nominal_or_the_middle_of_their_limits(changes, hole, pin, words):
    design = {name: each for name, each in WHOLE.items() if name != "pin"}
    for path, value in changes.items():
        design = changed(design, path, value)
    parts = ["satellite_1", "assembly", "carrier"]
    _, nominal = files(design, parts=parts)
    _, mean = files(design, parts=parts, sizes="mean")
    assert 2 * circles(mean["satellite_1"], "HOLES")[1][0] == pytest.approx(hole, abs=1e-9)
    assert rows(nominal["satellite_1"], *HOLES)[0][3:] == words
    assert 2 * circles(nominal["satellite_1"], "HOLES")[1][0] == float(words[0])
    for drawn, diameter in ((mean, pin), (nominal, 8.0)):
        pins = [r for r in circles(drawn["assembly"], "PINS")[1] if r != 5.0]
        assert pins == pytest.approx([diameter / 2] * 5, abs=1e-9)
        assert circles(drawn["carrier"], "HOLES")[1] == [4.0] * 5  # the fit there is not known


def test_limits_that_leave_nothing_are_refused():
    small = {"lower_mm": -8.0, "upper_mm": 0.0}
    body = BODY | {
        "design": WHOLE | {"tolerances": {"ring_pin_diameter": small | {"lower_mm": -10.0}}}
    }
    error = refused(body)
    assert error.pointer == "/design/tolerances/ring_pin_diameter/lower_mm"
    assert (error.code, error.params) == ("greater_than", {"limit": -10.0})


def test_all_parts_are_drawn_if_none_are_named():
    """Parts of unknown sizes are named instead, but no second plate that the design has not."""
    whole = [*ALL, "carrier", "second_carrier", "housing", "shaft", "assembly"]
    _, drawn = files(WHOLE, parts=None)
    assert [*drawn] == whole
    for drawing in drawn.values():
        found = drawing.audit()
        assert not found.errors and not found.fixes
    with zipfile.ZipFile(io.BytesIO(asked({"design": UNEVEN}).content)) as bundle:
        names = [f"{name}.dxf" for name in whole if name not in ("second_carrier", "shaft")]
        assert bundle.namelist() == [*names, "left_out.txt"]
        assert bundle.read("left_out.txt") == b"shaft: design.crankshaft is not known\n"
        assembly = texts(read(bundle.read("assembly.dxf")))
    assert "Left out: bearing a; design.crankshaft is not known" in assembly
    body = {"design": deepcopy(UNEVEN)}
    del body["design"]["load"], body["design"]["mechanism"]["pins"]
    body["design"]["contact"] = {"eccentricity_mm": 2.5}
    with zipfile.ZipFile(io.BytesIO(asked(body).content)) as bundle:
        assert bundle.namelist() == [*(f"{name}.dxf" for name in ALL), "left_out.txt"]
        assert b"housing: design.contact is not known" in bundle.read("left_out.txt")
    error = refused(body | {"parts": ["carrier"]})
    assert (error.pointer, error.code) == ("/design/contact", "needed_to_draw")


def test_bolts_bearings_and_open_ends_are_drawn():
    """The first plate has the bolts' holes, and what touches the holes of discs are sleeves."""
    pin = {"support": "fixed", "diameter_mm": 7.0, "material": "steel_through_hardened",
           "bolt": {"core_diameter_mm": 3.0}}  # fmt: skip
    design = deepcopy(WHOLE | {"pin": pin})
    del design["crankshaft"]["bearings"][0]["width_mm"]
    _, drawn = files(design, parts=["carrier", "second_carrier", "shaft", "assembly"])
    assert circles(drawn["carrier"], "HOLES")[1] == [1.5] * 5
    assert circles(drawn["second_carrier"], "HOLES")[1] == [3.5] * 5
    assert {*circles(drawn["assembly"], "PINS")[1]} == {5.0, 4.0, 3.5, 1.5}
    open_end = "Width of bearing A not given: it has no room at its end"
    assert open_end in texts(drawn["shaft"])
    assert float(rows(drawn["shaft"], *STEPS)[0][1]) == -4.5  # the middle of the plate
    left = "Left out: bearing a; design.crankshaft.bearings.0.width_mm is not known"
    assert left in texts(drawn["assembly"])


def test_the_title_block_is_the_clients():
    link = "http://localhost:8000/?calculator=crank-planetary&" + "mechanism.pins=5&" * 20
    block = {"title": "Шарнір 3", "date": "2026-11-28", "author": "N. N.", "revision": "B"}
    _, drawn = files(WHOLE, parts=["shaft"], title_block=block | {"link": link}, sizes="mean")
    found = texts(drawn["shaft"])
    for name, text in (block | {"made by": f"KHV Calc {VERSION}", "part": "Crankshaft"}).items():
        assert found[found.index(name.capitalize()) + 1] == text
    assert "mm, diameters the middle of their limits" in found
    first = next(n for n, text in enumerate(found) if text.startswith("http"))
    lines = -(-len(link) // 160)
    assert "".join(found[first : first + lines]) == link
    kept = drawn["shaft"].header.custom_vars
    assert {name: kept.get(name) for name in (*block, "link")} == block | {"link": link}
