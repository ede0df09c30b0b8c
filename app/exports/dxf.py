"""Satellites and their ring, with pins or teeth, as DXF files for drawing and cutting."""

import io
import re
import zipfile
from typing import TYPE_CHECKING, NamedTuple, Self

import numpy as np
from pydantic import Field, model_validator

from app.calculations.mechanism import MAX_SATELLITES
from app.exports.drawn import MADE_BY, DrawnRequest, refuse_many_pins
from app.model import Export, File, quantity
from app.rules import field_error
from app.units import from_si, to_si
from core.arrays import FloatArray
from core.design.document import Design
from core.design.drawings import (
    DrawnRing,
    DrawnRingPins,
    DrawnSatellite,
    drawn_disc,
    drawn_ring,
    drawn_ring_pins,
    drawn_satellites,
)
from core.errors import NotKnown

if TYPE_CHECKING:
    from ezdxf.layouts import Modelspace

DXF, ZIP = "image/vnd.dxf", "application/zip"

RING, RING_PINS = "ring", "ring_pins"

PART = r"satellite_([1-9]\d{0,2})|ring_pins|ring"
"""Names of parts."""

FORMAT = "R2010"
"""Version of the files; newer ones have nothing that they need."""

LAYERS = {"OUTLINE": 7, "HOLES": 5, "BORE": 3, "PINS": 1, "CENTRE": 4, "TITLE": 8}
"""Layers of each file, with their colours by number."""

CENTRE_LINE = (50.8, 31.75, -6.35, 6.35, -6.35)
"""Long and short dashes of centre lines: length of a repeat, and its pieces."""

DASHES = 40.0
"""Number of repeats of the dash pattern along a drawing."""

BEYOND = 1.15
"""Length of centre lines over the diameter that they cross."""

LINES = 60.0
"""Height of a part in lines of text."""

DIGITS = 12
"""Decimals of millimetres that exceed rounding."""

EARLIEST = (1980, 1, 1, 0, 0, 0)
"""Date of files in a ZIP, the earliest possible, so that equal requests give equal files."""


class DxfRequest(DrawnRequest, group="drawing"):
    """Design, and the parts that are drawn."""

    parts: list[str] = Field(
        min_length=1,
        max_length=MAX_SATELLITES + 1,
        description="Parts to draw: satellite_1 up to the number of satellites, and ring_pins, or"
        " ring for involute teeth. One part gives a DXF file, several give a ZIP with"
        " one file each.",
        json_schema_extra={"items": {"type": "string", "pattern": f"^({PART})$"}},
    )
    chord_error_mm: float = quantity("Chord error", "ε", default=0.001, step=0.001, ge=1e-6, le=1)
    """Largest distance of the outline from the polygon of its points."""

    @model_validator(mode="after")
    def _has_the_parts(self) -> Self:
        satellites = self.design.mechanism.satellites
        ring, other = (RING, RING_PINS) if self.involute else (RING_PINS, RING)
        for index, name in enumerate(self.parts):
            found = re.fullmatch(PART, name)
            if not found or int(found[1] or 1) > satellites or name == other:
                own = "satellite_1" if satellites == 1 else f"satellite_1 … satellite_{satellites}"
                raise field_error(f"parts/{index}", "no_such_part", parts=f"{own}, {ring}")
        return self

    @property
    def satellites(self) -> tuple[int, ...]:
        """Numbers of the requested satellites, each once."""
        found = (re.fullmatch(PART, name) for name in dict.fromkeys(self.parts))
        return tuple(int(each[1]) for each in found if each and each[1])

    def drawn(self) -> list["_Part"]:
        """Requested parts in their order, each once."""
        design, error = self.design.design, to_si("chord_error_mm", self.chord_error_mm)
        parts = {}
        if not self.involute:
            pins = drawn_ring_pins(design=design)
            refuse_many_pins(len(pins.centres))
            parts = {RING_PINS: _ring_pins(pins)}
        elif RING in self.parts:
            parts = {RING: _ring(drawn_ring(design=design, chord_error=error), design)}
        if numbers := self.satellites:
            some = drawn_satellites(design=design, numbers=numbers, chord_error=error)
            parts |= {f"satellite_{each.number}": _satellite(each, design) for each in some}
        return [parts[name] for name in dict.fromkeys(self.parts)]


class _Circles(NamedTuple):
    """Circles of one size on a pitch circle about the origin, numbered from 1; mm."""

    layer: str
    pitch: float  # radius of the circle of their centres
    centres: FloatArray  # X and Y of each circle
    radius: float


class _Part(NamedTuple):
    """Drawing of a part; mm."""

    reach: float  # largest distance from the origin
    outline: FloatArray | None  # X and Y of the points of a closed polygon
    circles: _Circles | None
    bore: float | None  # radius
    said: dict[str, str]  # properties for other programs, by name
    title: list[str]  # lines of text


def _satellite(drawn: DrawnSatellite, design: Design) -> _Part:
    outline, error = from_si("points_mm", drawn.outline), from_si("length_mm", drawn.chord_error)
    holes, circles = "without holes", None
    if own_holes := drawn.holes:
        centres = from_si("points_mm", own_holes.centres)
        radius, pitch = (
            from_si("length_mm", each) for each in (own_holes.radius, own_holes.circle_radius)
        )
        circles = _Circles("HOLES", pitch, centres, radius)
        holes = f"{len(centres)} holes of diameter {2 * radius:.9g} mm"
    bore = from_si("radius_mm", drawn.bore_radius)
    x, y = (round(from_si("centre_mm", each), DIGITS) + 0.0 for each in drawn.centre)
    if design.gear.kind == "involute":
        form = _teeth(design, design.lobes, design.involute.satellite_profile_shift)
    else:
        own, disc = design.cycloid.changed, drawn_disc(design=design)
        tool, circle = (from_si("length_mm", each) for each in (own.equidistant, own.pin_circle))
        form = (
            f"{disc.satellite_teeth} lobes",
            f"Equidistant modification {tool:+.6g} mm, of the circle {circle:+.6g} mm",
        )
    return _Part(
        reach=float(np.hypot(*outline.T).max()),
        outline=outline,
        circles=circles,
        bore=bore,
        said={
            "part": f"satellite_{drawn.number}",
            "chord_error_mm": repr(error),
            "centre_x_mm": repr(x),
            "centre_y_mm": repr(y),
        },
        title=[
            f"Satellite {drawn.number} of {design.mechanism.satellites}, {form[0]}",
            f"Closed polyline of {len(outline)} points, {error:.4g} mm from the outline at most",
            form[1],
            f"{holes}, " + ("bore not given" if bore is None else f"bore {2 * bore:.9g} mm"),
            f"At the crank angle 0 this centre is at X {x:.6f}, Y {y:.6f} mm",
        ],
    )


def _teeth(design: Design, teeth: int, shift: float | None) -> tuple[str, str]:
    """Texts about involute teeth."""
    own = design.involute
    module = from_si("module_mm", own.module)
    angle = from_si("angle_deg", own.reference_pressure_angle)
    return (
        f"{teeth} involute teeth of module {module:.9g} mm",
        f"Pressure angle {angle:.9g} deg, profile shift {shift or 0.0:+.6g}",
    )


def _ring(drawn: DrawnRing, design: Design) -> _Part:
    outline, error = from_si("points_mm", drawn.outline), from_si("length_mm", drawn.chord_error)
    count, rack = _teeth(design, drawn.teeth, design.involute.ring_profile_shift)
    return _Part(
        reach=float(np.hypot(*outline.T).max()),
        outline=outline,
        circles=_Circles(
            "CENTRE", from_si("length_mm", drawn.reference_radius), np.empty((0, 2)), 1.0
        ),
        bore=None,
        said={"part": RING, "chord_error_mm": repr(error)},
        title=[
            f"Ring, {count}",
            f"Closed polyline of {len(outline)} points, {error:.4g} mm from the outline at most",
            rack,
            "No cutter given: flanks go on to the roots, whose circle is assumed"
            if drawn.root_assumed
            else "Roots as the cutter leaves them",
            "A crank of the angle 0 faces a space at the crank angle 0",
        ],
    )


def _ring_pins(drawn: DrawnRingPins) -> _Part:
    centres = from_si("centres_mm", drawn.centres)
    pitch, radius = (from_si("length_mm", each) for each in (drawn.circle_radius, drawn.radius))
    return _Part(
        reach=pitch + radius,
        outline=None,
        circles=_Circles("PINS", pitch, centres, radius),
        bore=None,
        said={"part": RING_PINS},
        title=[
            f"Pins of the ring: {len(centres)} of diameter {2 * radius:.9g} mm",
            "Numbered anticlockwise; a crank of the angle 0 faces the first at the crank angle 0",
        ],
    )


def write(body: DxfRequest) -> File:
    """Satellites and the pins or teeth of their ring as DXF files, in millimetres, by nominal
    sizes.

    Outlines of cycloid discs or involute teeth are closed polylines with the measured chord error;
    holes, bore and pins are circles. One part makes a DXF file, several make a ZIP. All parts are
    at crank angle 0, satellites about their own centres.
    """
    try:
        parts = body.drawn()
    except NotKnown as error:
        body.refuse_unknown(error)
    files = {part.said["part"]: _file(part) for part in parts}
    if len(files) == 1:
        ((name, content),) = files.items()
        return File(f"{name}.dxf", DXF, content)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as bundle:
        for name, content in files.items():
            bundle.writestr(zipfile.ZipInfo(f"{name}.dxf", EARLIEST), content, zipfile.ZIP_DEFLATED)
    return File("parts.zip", ZIP, packed.getvalue())


def _file(part: _Part) -> bytes:
    """A part as the bytes of a DXF file."""
    import ezdxf  # slow import, needed for files only
    from ezdxf import units

    ezdxf.options.write_fixed_meta_data_for_testing = True  # neither times nor ids by chance
    drawing = ezdxf.new(FORMAT, units=units.MM)
    drawing.linetypes.add("CENTER", CENTRE_LINE, description="Center ____ _ ____ _ ____")
    for name, color in LAYERS.items():
        line = "CENTER" if name == "CENTRE" else "CONTINUOUS"
        drawing.layers.add(name, color=color, linetype=line)
    drawing.header["$LTSCALE"] = 2 * part.reach / (DASHES * CENTRE_LINE[0])
    for tag, value in (part.said | {"unit": "mm", "made_by": MADE_BY}).items():
        drawing.header.custom_vars.append(tag, value)
    low = _draw(part, drawing.modelspace())
    high = BEYOND * part.reach
    drawing.modelspace().reset_extents((-high, low, 0), (high, high, 0))
    drawing.set_modelspace_vport(high - low, (0, (high + low) / 2))
    # Sorted by name, as the order of a set of texts differs between processes.
    for kind in sorted(drawing.entitydb.dxf_types_in_use()):
        drawing.classes.add_class(kind)
    text = io.StringIO()
    drawing.write(text)
    return drawing.encode(text.getvalue())


def _draw(part: _Part, space: "Modelspace") -> float:
    """Draw a part, and return its lowest place."""
    on = {name: {"layer": name} for name in LAYERS}
    if part.outline is not None:
        polygon = space.add_lwpolyline((), close=True, dxfattribs=on["OUTLINE"])
        # All points at once, as each single addition would copy all points before.
        polygon.lwpoints.extend(np.column_stack((part.outline, np.zeros((len(part.outline), 3)))))
    if part.bore is not None:
        space.add_circle((0, 0), part.bore, dxfattribs=on["BORE"])
    height = 2 * part.reach / LINES
    crosses = [((0.0, 0.0), part.reach)]
    if part.circles:
        layer, pitch, centres, radius = part.circles
        small = min(height, radius / 2)
        space.add_circle((0, 0), pitch, dxfattribs=on["CENTRE"])
        for number, (x, y) in enumerate(centres.tolist(), 1):
            space.add_circle((x, y), radius, dxfattribs=on[layer])
            label = space.add_text(str(number), height=small, dxfattribs=on["TITLE"])
            label.set_placement((x + small / 2, y + small / 2))
            crosses.append(((x, y), radius))
    for (x, y), half in crosses:
        arm = BEYOND * half
        space.add_line((x - arm, y), (x + arm, y), dxfattribs=on["CENTRE"])
        space.add_line((x, y - arm), (x, y + arm), dxfattribs=on["CENTRE"])
    low = -BEYOND * part.reach
    for line in (*part.title, f"{MADE_BY}, nominal sizes in mm"):
        low -= 2 * height
        text = space.add_text(line, height=height, dxfattribs=on["TITLE"])
        text.set_placement((-part.reach, low))
    return low - height


EXPORT = Export(
    name="export/dxf",
    title="Satellites and their ring as DXF files",
    request=DxfRequest,
    write=write,
    media_types=(DXF, ZIP),
)
