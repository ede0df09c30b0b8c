"""Parts of a reducer and their assembly as DXF files for drawing and cutting."""

import io
import re
import textwrap
import zipfile
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Self

import numpy as np
from pydantic import Field, model_validator

from app.calculations.mechanism import MAX_SATELLITES
from app.exports.drawn import DIAMETERS, MADE_BY, DrawnRequest, refuse_many_pins
from app.exports.sheets import (
    BEYOND,
    Circle,
    Outline,
    Sheet,
    of_assembly,
    of_housing,
    of_plate,
    of_ring,
    of_ring_pins,
    of_satellite,
    of_shaft,
)
from app.model import Export, File, Maybe, RequestModel, quantity
from app.rules import field_error
from app.units import to_si
from core.design.drawings import drawn_ring, drawn_ring_pins, drawn_satellites
from core.design.solids import Solids, solids
from core.errors import NotKnown, if_known

if TYPE_CHECKING:
    from ezdxf.layouts import Modelspace

DXF, ZIP = "image/vnd.dxf", "application/zip"

RING, RING_PINS, ASSEMBLY = "ring", "ring_pins", "assembly"

WITH_SECTIONS = {
    "carrier": (of_plate, "contact"),
    "second_carrier": (of_plate, "build.second_carrier_width"),
    "housing": (of_housing, "gear"),
    "shaft": (of_shaft, "crankshaft"),
}
"""Parts with views from the left: their sheets, and the input that a design without them lacks."""

OTHERS = (*WITH_SECTIONS, ASSEMBLY)

PART = rf"satellite_([1-9]\d{{0,2}})|ring_pins|ring|{'|'.join(OTHERS)}"
"""Names of parts."""

FORMAT = "R2010"
"""Version of the files; newer ones have nothing that they need."""

LAYERS = {"OUTLINE": 7, "HOLES": 5, "BORE": 3, "PINS": 1, "CENTRE": 4, "HATCH": 8, "TITLE": 8}
"""Layers of each file, with their colours by number."""

BEHIND = 8
"""Colour of what is behind other parts."""

LINES = {
    "CENTER": ("Center ____ _ ____ _ ____", (50.8, 31.75, -6.35, 6.35, -6.35)),
    "HIDDEN": ("Hidden __ __ __ __ __ __", (19.05, 12.7, -6.35)),
}
"""Lines of axes and of what is behind: length of a repeat, its dashes and gaps."""

DASHED_ON = 128
"""Flag of polylines whose dashes go on past their points."""

DASHES = 40.0
"""Number of repeats of the dashes of an axis along a front view."""

LETTERS = 90.0
"""Width of the views in heights of text."""

WIDE = 1.0
"""Width of a letter over its height, at most."""

ROWS = 40
"""Number of rows of a table, which goes on beside them."""

SCREEN = 1.5
"""Width of a window over its height."""

LINK_LETTERS = 160
"""Letters in a line of a link, which has half the height of others."""

FONT = "arial.ttf"
"""Font of texts, with the letters of all languages of the page."""

LEFT_OUT = "left_out.txt"
"""File in the ZIP that says what is not known of parts without a drawing."""

Point = tuple[float, float]

EARLIEST = (1980, 1, 1, 0, 0, 0)
"""Date of files in a ZIP, the earliest possible, so that equal requests give equal files."""

Words = Annotated[str, Field(max_length=80, pattern=r"^[^\x00-\x1f\x7f-\x9f]*$")]
"""Text in one line."""


class TitleBlock(RequestModel, group="drawing"):
    """Title block of a document, as the client states it."""

    title: Words = ""
    """Name of the design."""
    date: Words = ""
    """Date of the document."""
    author: Words = ""
    """Name of who made it."""
    revision: Words = ""
    """Revision of the design."""
    link: Annotated[str, Field(max_length=8000, pattern=r"^[!-~]*$")] = ""
    """Link to the design."""


class DxfRequest(DrawnRequest, group="drawing"):
    """Design, and the parts that are drawn."""

    parts: Maybe[list[str]] = Field(
        min_length=1,
        max_length=MAX_SATELLITES + 1 + len(OTHERS),
        description="Parts to draw: satellite_1 up to the number of satellites, ring_pins, or ring"
        " for involute teeth, carrier, second_carrier, housing, shaft, assembly; all whose sizes"
        " are known if not given. One part gives a DXF file, several give a ZIP of one file each.",
        json_schema_extra={"items": {"type": "string", "pattern": f"^({PART})$"}},
    )
    crank_angle_deg: float = quantity("Crank angle", "φ", default=0.0, step=5, ge=-1e6, le=1e6)
    """Crank angle of the assembly; all other parts are drawn at crank angle 0."""
    chord_error_mm: float = quantity("Chord error", "ε", default=0.001, step=0.001, ge=1e-6, le=1)
    """Largest distance of the outline from the polygon of its points."""
    title_block: TitleBlock = Field(default=TitleBlock(), description="Title block of each sheet.")

    @model_validator(mode="after")
    def _has_the_parts(self) -> Self:
        satellites = self.design.mechanism.satellites
        ring, other = (RING, RING_PINS) if self.involute else (RING_PINS, RING)
        for index, name in enumerate(self.parts or ()):
            found = re.fullmatch(PART, name)
            if not found or int(found[1] or 1) > satellites or name == other:
                own = "satellite_1" if satellites == 1 else f"satellite_1 … satellite_{satellites}"
                said = ", ".join((own, ring, *OTHERS))
                raise field_error(f"parts/{index}", "no_such_part", parts=said)
        return self

    def drawn(self) -> tuple[list[Sheet], dict[str, str]]:
        """Sheets of the requested parts in their order, each once; if none are named, those of
        parts whose sizes are known, and what is not known of others.
        """
        names = list(dict.fromkeys(self.parts or self._all_parts))
        sheets, left_out = self._teeth(names), {}
        for name in names:
            try:
                sheets[name] = sheets.get(name) or self._other(name)
            except NotKnown as why:
                if self.parts:
                    raise
                left_out[name] = why.missing[0] if why.missing else ""
        return [sheets[name] for name in names if name in sheets], self.lacking(left_out)

    @property
    def _all_parts(self) -> list[str]:
        """Names of the parts that the design has."""
        design = self.design.design
        satellites = [f"satellite_{n}" for n in range(1, design.mechanism.satellites + 1)]
        lacks = {
            "second_carrier": not if_known(lambda: design.second_carrier_width),
            "shaft": design.members.output == "coupling",
        }
        others = [name for name in OTHERS if not lacks.get(name)]
        return [*satellites, RING if self.involute else RING_PINS, *others]

    def _teeth(self, names: list[str]) -> dict[str, Sheet]:
        """Sheets of satellites and ring by their names."""
        design, sizes = self.design.design, self.sizes
        error = to_si("chord_error_mm", self.chord_error_mm)
        sheets = []
        if not self.involute:
            pins = drawn_ring_pins(design=design, sizes=sizes)
            refuse_many_pins(len(pins.centres))
            sheets = [of_ring_pins(pins, design, sizes)]
        elif RING in names:
            sheets = [of_ring(drawn_ring(design=design, chord_error=error), design)]
        matches = (re.fullmatch(PART, name) for name in names)
        if numbers := tuple(int(each[1]) for each in matches if each and each[1]):
            some = drawn_satellites(design=design, numbers=numbers, chord_error=error, sizes=sizes)
            sheets += [of_satellite(each, design, sizes) for each in some]
        return {each.name: each for each in sheets}

    def _other(self, name: str) -> Sheet:
        """Sheet of another part or of the assembly; `NotKnown` names what it lacks."""
        angle = self.crank_angle_deg if name == ASSEMBLY else 0.0
        found = self._solids(angle)
        if name == ASSEMBLY:
            return of_assembly(found, self.lacking(found.left_out), angle)
        sheet, absent = WITH_SECTIONS[name]
        body = next((each for each in found.bodies if each.name == name), None)
        if body is None:
            raise NotKnown("size_missing", *filter(None, [found.left_out.get(name, absent)]))
        return sheet(body, self.design.design)

    def _solids(self, crank_angle_deg: float) -> Solids:
        return solids(
            self.design.design,
            chord_error=to_si("chord_error_mm", self.chord_error_mm),
            crank_angle=to_si("crank_angle_deg", crank_angle_deg),
            sizes=self.sizes,
        )


def write(body: DxfRequest) -> File:
    """Parts of a reducer as DXF files, in millimetres: satellites, the pins or teeth of their ring,
    plates of the carrier, crankshaft, housing, and the assembly at a crank angle.

    Outlines of cycloid discs or involute teeth are closed polylines with the measured chord error;
    holes, bore and pins are circles, which a table lists with their limits. One part makes a DXF
    file, several make a ZIP. Parts are at crank angle 0, satellites about their own centres.
    """
    try:
        sheets, left_out = body.drawn()
    except NotKnown as error:
        body.refuse_unknown(error)
    files = {f"{each.name}.dxf": _file(each, body) for each in sheets}
    if len(files) == 1:
        ((name, content),) = files.items()
        return File(name, DXF, content)
    if left_out:
        lines = (f"{name}: {what} is not known\n" for name, what in left_out.items())
        files[LEFT_OUT] = "".join(lines).encode()
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as bundle:
        for name, content in files.items():
            bundle.writestr(zipfile.ZipInfo(name, EARLIEST), content, zipfile.ZIP_DEFLATED)
    return File("parts.zip", ZIP, packed.getvalue())


def _file(sheet: Sheet, body: DxfRequest) -> bytes:
    """A sheet as the bytes of a DXF file."""
    import ezdxf  # slow import, needed for files only
    from ezdxf import units

    ezdxf.options.write_fixed_meta_data_for_testing = True  # neither times nor ids by chance
    drawing = ezdxf.new(FORMAT, units=units.MM)
    for name, (words, dashes) in LINES.items():
        drawing.linetypes.add(name, dashes, description=words)
    for name, color in LAYERS.items():
        line = "CENTER" if name == "CENTRE" else "CONTINUOUS"
        drawing.layers.add(name, color=color, linetype=line)
    drawing.header["$LTSCALE"] = 2 * sheet.reach / (DASHES * LINES["CENTER"][1][0])
    stated = {name: text for name, text in body.title_block.model_dump().items() if text}
    said = {"part": sheet.name, **dict(sheet.said), "unit": "mm", "sizes": body.sizes}
    for tag, value in (said | {"made_by": MADE_BY} | stated).items():
        drawing.header.custom_vars.append(tag, value)
    drawing.styles.get("Standard").dxf.font = FONT
    writer = _Writer(sheet, drawing.modelspace())
    (left, low), (right, high) = writer.drawn(_block(sheet, body), body.title_block.link)
    drawing.modelspace().reset_extents((left, low, 0), (right, high, 0))
    middle = ((left + right) / 2, (low + high) / 2)
    drawing.set_modelspace_vport(max(high - low, (right - left) / SCREEN), middle)
    # Sorted by name, as the order of a set of texts differs between processes.
    for kind in sorted(drawing.entitydb.dxf_types_in_use()):
        drawing.classes.add_class(kind)
    text = io.StringIO()
    drawing.write(text)
    return drawing.encode(text.getvalue())


def _block(sheet: Sheet, body: DxfRequest) -> list[tuple[str, str]]:
    """Rows of the title block."""
    own = body.title_block
    rows = [
        ("Title", own.title),
        ("Part", sheet.title),
        ("Date", own.date),
        ("Author", own.author),
        ("Revision", own.revision),
        ("Sizes", f"mm, diameters {DIAMETERS[body.sizes]}"),
        ("Projection", "first angle"),
        ("Made by", MADE_BY),
    ]
    return [row for row in rows if row[1]]


class _Writer:
    """Drawing of a sheet in the space of a file."""

    def __init__(self, sheet: Sheet, space: "Modelspace") -> None:
        self.sheet, self.space = sheet, space
        ends = [end for _, end in sheet.axes]
        self.right = max(ends, default=BEYOND * sheet.reach)
        self.height = (self.right + BEYOND * sheet.reach) / LETTERS

    def drawn(self, block: Sequence[Sequence[str]], link: str) -> tuple[Point, Point]:
        """Draw everything, and return the lower left and the upper right corner."""
        sheet, reach = self.sheet, BEYOND * self.sheet.reach
        for outline in sheet.outlines:
            self._outline(outline)
        self._circles()
        for start, end in sheet.axes:
            self._line((start, 0.0), (end, 0.0), "CENTRE")
        low = -reach
        for line in sheet.notes:
            low -= 2 * self.height
            self._text(line, (-sheet.reach, low))
        corners = [self._table(block, (-sheet.reach, low - 2 * self.height))]
        for line in textwrap.wrap(link, LINK_LETTERS):
            corners.append((self.right, corners[-1][1] - self.height))
            self._text(line, (-sheet.reach, corners[-1][1]), self.height / 2)
        rows = list(sheet.table)
        at = self.right + 2 * self.height
        for first in range(1, len(rows), ROWS):
            part = [rows[0], *rows[first : first + ROWS]]
            corners.append(self._table(part, (at, reach)))
            at = corners[-1][0] + 2 * self.height
        xs, ys = zip(*corners, strict=True)
        return (-reach, min(ys) - self.height), (max(xs) + self.height, reach)

    def _outline(self, outline: Outline) -> None:
        polygon = self.space.add_lwpolyline((), close=True, dxfattribs=_on("OUTLINE", outline))
        polygon.dxf.flags |= DASHED_ON
        points = outline.points
        # All points at once, as each single addition would copy all points before.
        rows = (points[:, :2], np.zeros((len(points), 2)), points[:, 2:])
        polygon.lwpoints.extend(np.column_stack(rows))
        corners = [(x, y) for x, y, _ in points.tolist()]
        if outline.hatched:
            hatch = self.space.add_hatch(dxfattribs={"layer": "HATCH"})
            hatch.set_pattern_fill("ANSI31", scale=outline.hatched * self.height / 3)
            hatch.paths.add_polyline_path(corners, is_closed=True)
        if outline.crossed:
            self._line(corners[0], corners[2], "HATCH")
            self._line(corners[1], corners[3], "HATCH")

    def _circles(self) -> None:
        sheet, crosses = self.sheet, [(0.0, 0.0, self.sheet.reach)]
        if sheet.pitch:
            self.space.add_circle((0, 0), sheet.pitch, dxfattribs={"layer": "CENTRE"})
        for each in sheet.circles:
            at = each.x, each.y
            self.space.add_circle(at, each.radius, dxfattribs=_on(each.layer, each))
            if each.label:
                small = min(self.height, each.radius / 2)
                self._text(each.label, (each.x + small / 2, each.y + small / 2), small)
                crosses.append((*at, each.radius))
        for x, y, half in crosses:
            arm = BEYOND * half
            self._line((x - arm, y), (x + arm, y), "CENTRE")
            self._line((x, y - arm), (x, y + arm), "CENTRE")

    def _table(self, rows: Sequence[Sequence[str]], corner: Point) -> Point:
        """Draw a table from its upper left corner, and return the lower right one."""
        (x, top), height = corner, self.height
        widths = [height * (1 + WIDE * max(map(len, column))) for column in zip(*rows, strict=True)]
        edges = [x + sum(widths[:count]) for count in range(len(widths) + 1)]
        low = top - 2 * height * len(rows)
        for number, row in enumerate(rows):
            base = top - (2 * number + 1.5) * height
            for text, start in zip(row, edges, strict=False):
                self._text(text, (start + height / 2, base))
        for number in range(len(rows) + 1):
            y = top - 2 * number * height
            self._line((x, y), (edges[-1], y), "TITLE")
        for edge in edges:
            self._line((edge, top), (edge, low), "TITLE")
        return edges[-1], low

    def _line(self, start: Point, end: Point, layer: str) -> None:
        self.space.add_line(start, end, dxfattribs={"layer": layer})

    def _text(self, text: str, at: Point, height: float | None = None) -> None:
        line = self.space.add_text(
            text, height=height or self.height, dxfattribs={"layer": "TITLE"}
        )
        line.set_placement(at)


def _on(layer: str, shape: Circle | Outline) -> dict[str, str | int]:
    """Layer and line of a shape."""
    return {"layer": layer, **({"linetype": "HIDDEN", "color": BEHIND} if shape.hidden else {})}


EXPORT = Export(
    name="export/dxf",
    title="Parts and assembly as DXF files",
    request=DxfRequest,
    write=write,
    media_types=(DXF, ZIP),
)
