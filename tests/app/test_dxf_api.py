"""Parts of a design as DXF files over REST, read again by the library: what is drawn is where the
design says it is, to its stated error; what is not known is not drawn.
"""

import io
import json
import math
import os
import sys
import zipfile
from copy import deepcopy
from functools import partial

import ezdxf
import numpy as np
import pytest

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


def files(design, *, parts=ALL, chord_error_mm=0.01):
    """Drawings of parts, by their names."""
    body = DxfRequest(design=design, parts=parts, chord_error_mm=chord_error_mm)
    file = write(body)
    if file.media_type == DXF:
        return body, {file.name.removesuffix(".dxf"): read(file.content)}
    with zipfile.ZipFile(io.BytesIO(file.content)) as bundle:
        assert bundle.testzip() is None
        return body, {
            name.removesuffix(".dxf"): read(bundle.read(name)) for name in bundle.namelist()
        }


def circles(drawing, layer):
    """Centres, X + iY, and radii of the circles of a layer, in the order of the file."""
    found = drawing.modelspace().query(f'CIRCLE[layer=="{layer}"]')
    centres = [complex(each.dxf.center.x, each.dxf.center.y) for each in found]
    return np.array(centres), [each.dxf.radius for each in found]


def outline(drawing):
    (polyline,) = drawing.modelspace().query('LWPOLYLINE[layer=="OUTLINE"]')
    assert polyline.closed
    return np.array(polyline.get_points("xy")) @ np.array([1, 1j])


def said(drawing, name):
    return float(drawing.header.custom_vars.get(name))


def centre(drawing):
    return complex(said(drawing, "centre_x_mm"), said(drawing, "centre_y_mm"))


@pytest.mark.parametrize("start", [0.0, 25.0, 180.0])
def test_each_ring_pin_is_as_far_from_the_outline_as_the_gap_says(start):
    """Satellites put back to their centres stand in the ring as the mesh is calculated."""
    design = changed(UNEVEN, "/mechanism/initial_crank_angle_deg", start)
    body, drawn = files(design, chord_error_mm=0.002)
    made = body.design.design
    pins, radii = circles(drawn["ring_pins"], "PINS")
    assert radii == [5.0] * 12
    mesh = made.gear.cycloid_mesh(
        disc=made.gear.disc(satellite_teeth=11, eccentricity=2.5e-3),
        crank_angles=made.built.crank_angles,
        contact_length=made.ring_length,
        disc_material=made.disc_material,
        law=LinearLaw(1e8),
    )
    gaps = 1e3 * np.array(mesh_gaps(mesh=mesh, crank_angle=0.0))
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
        assert radii == pytest.approx([6.5 + answer["geometry"]["clearance_mm"]] * 5, abs=1e-9)
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
        assert kinds == own | {("CIRCLE", "CENTRE"), ("LINE", "CENTRE"), ("TEXT", "TITLE")}
        numbers = [text.dxf.text for text in drawing.modelspace().query("TEXT")]
        assert numbers[:5] == ["1", "2", "3", "4", "5"]


async def test_a_part_is_a_file_and_several_are_a_zip(api):
    body = REQUESTS[PATH]
    single = await api.post(PATH, json=body | {"parts": ["satellite_2", "satellite_2"]})
    assert single.status_code == 200, single.text
    assert single.headers["content-type"] == DXF
    assert single.headers["content-disposition"] == 'attachment; filename="satellite_2.dxf"'
    assert single.headers["content-encoding"] == "gzip"
    assert "bore 36 mm" in single.text
    bundle = await api.post(PATH, json=body)
    assert bundle.headers["content-type"] == ZIP
    assert bundle.headers["content-disposition"] == 'attachment; filename="parts.zip"'
    with zipfile.ZipFile(io.BytesIO(bundle.content)) as packed:
        assert packed.namelist() == ["satellite_1.dxf", "satellite_2.dxf", "ring_pins.dxf"]
        assert packed.read("satellite_2.dxf") == single.content
    refused = await api.post(PATH, json=body | {"parts": ["carrier"]})
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
        ("/parts/1", "carrier", None, "no_such_part"),
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
    parts = DxfRequest(**body | {"chord_error_mm": limit}).drawn()
    assert 190_000 < sum(len(part.outline) for part in parts[:3]) <= 200_000
    (alone,) = DxfRequest(**body | {"parts": ALL[2:3]}).drawn()
    assert len(alone.outline) > 70_000


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
