"""A whole reducer as solids: a script of Python that builds them with build123d, for STEP files."""

from collections.abc import Iterable

from app.exports.drawn import DIAMETERS, MADE_BY, DrawnRequest, refuse_many_pins
from app.model import Export, File
from app.units import from_si
from core.design.diameters import Sizes
from core.design.solids import Body, Lobes, Solids, Stretch, solids
from core.errors import NotKnown

PYTHON = "text/x-python"

CHORD_ERROR = 5e-6
"""Largest distance of an outline from the polygon of its points, m."""

DIGITS = 9
"""Decimals of millimetres."""

SCRIPT = '''"""Solids of a reducer, by {made_by}; lengths in mm.

Diameters are {sizes}.

    pip install build123d
    python reducer.py          # writes reducer.step

X points to the right, Y up through the first output pin, Z from the carrier to the discs; the crank
angle is 0. Shapes that the design does not state are plain plates, rings and cylinders.
{outlines}
{left_out}
"""

import cmath
import sys

from build123d import Axis, Circle, Compound, Polyline, Pos, Spline
from build123d import export_step, extrude, make_face


def lobes(points, count, smooth):
    """Face within equal lobes: of one, clockwise, all points but the last are given."""
    first = cmath.exp(-2j * cmath.pi / count) * complex(*points[0])
    points = [*points, (first.real, first.imag)]
    lobe = Spline(*points) if smooth else Polyline(*points)
    turned = [lobe.rotate(Axis.Z, -360 * k / count) for k in range(count)]
    return make_face([edge for each in turned for edge in each.edges()])


def stretch(face, low, high, at=(0.0, 0.0), holes=(), opening=None):
    """Solid of a face from low to high, with round holes: X and Y about its centre, radius."""
    for x, y, radius in holes:
        face -= Pos(x, y) * Circle(radius)
    if opening is not None:
        face -= opening
    return Pos(*at, low) * extrude(face, high - low)


def bodies():
    """Solids by name."""
{shapes}

    return {{
{bodies}
    }}


def copies(name, solid, places):
    """Equal solids at their places, of one name."""
    for x, y in places:
        copy = Pos(x, y) * solid
        copy.label = name
        yield copy


def reducer():
    """All solids together."""
    made = bodies().items()
    parts = [part for name, (solid, places) in made for part in copies(name, solid, places)]
    return Compound(label="reducer", children=parts)


if __name__ == "__main__":
    export_step(reducer(), sys.argv[1] if len(sys.argv) > 1 else "reducer.step")
'''


class SolidsRequest(DrawnRequest, group="drawing"):
    """Design whose solids are built."""


def write(body: SolidsRequest) -> File:
    """Script of Python that builds discs, ring, pins, sleeves, carrier, crankshaft and bearings of
    a design with build123d, and writes them as a STEP file.

    Lengths are in millimetres, at crank angle 0, diameters as `sizes` says. Shapes that the design
    does not state are plain: plates of the carrier, the ring of the housing, cylinders of the
    crankshaft, rings in the place of bearings. A part whose sizes are not known is left out and
    named in the script.
    """
    try:
        found = solids(body.design.design, chord_error=CHORD_ERROR, sizes=body.sizes)
    except NotKnown as error:
        body.refuse_unknown(error)
    for each in found.bodies:
        if each.name == "ring_pin":
            refuse_many_pins(len(each.places))
    text = script(found, body.lacking(found.left_out), body.sizes)
    return File("reducer.py", PYTHON, text.encode())


def script(found: Solids, lacking: dict[str, str], sizes: Sizes) -> str:
    """Text of the script; `lacking` says for each part that is left out what is not known."""
    stretches = [each for body in found.bodies for each in body.stretches]
    faces = [face for each in stretches for face in (each.outline, each.opening)]
    outlines = [face for face in faces if isinstance(face, Lobes)]
    shapes = {id(each): f"shape_{number}" for number, each in enumerate(outlines, 1)}
    error = from_si("length_mm", found.chord_error)
    smooth = all(each.smooth for each in outlines)
    kind = "Discs are curves through points" if smooth else "Teeth are polygons of points"
    left = "".join(f"\n    {name}: {what} is not known" for name, what in lacking.items())
    return SCRIPT.format(
        made_by=MADE_BY,
        sizes=DIAMETERS[sizes],
        outlines=f"{kind} whose polygon is within {error:.2g} mm of the outline.",
        left_out=f"Left out:{left}" if left else "No part is left out.",
        shapes="\n".join(
            f"    {shapes[id(each)]} = lobes({_rows(each.points)}, {each.lobes}, {each.smooth})"
            for each in outlines
        ),
        bodies="\n".join(_body(each, shapes) for each in found.bodies),
    )


def _body(body: Body, shapes: dict[int, str]) -> str:
    solid = " + ".join(_stretch(each, shapes) for each in body.stretches)
    return f'        "{body.name}": ({solid}, {_rows(body.places)}),'


def _stretch(each: Stretch, shapes: dict[int, str]) -> str:
    outline = each.outline
    face = shapes[id(outline)] if isinstance(outline, Lobes) else f"Circle({_mm(outline)})"
    given = [face, _mm(each.low), _mm(each.high)]
    if any(each.centre):
        given.append(f"at=({', '.join(map(_mm, each.centre))})")
    if each.holes:
        given.append(f"holes={_rows(each.holes)}")
    if each.opening:
        given.append(f"opening={shapes[id(each.opening)]}")
    return f"stretch({', '.join(given)})"


def _rows(rows: Iterable[Iterable[float]]) -> str:
    """Rows of lengths as a list of tuples."""
    texts = (", ".join(_mm(each) for each in row) for row in rows)
    return "[" + ", ".join(f"({text})" for text in texts) + "]"


def _mm(length: float) -> str:
    """Length in m as digits of mm."""
    return repr(round(from_si("length_mm", float(length)), DIGITS) + 0.0)


EXPORT = Export(
    name="export/build123d",
    title="Solids of the reducer as a script of build123d",
    request=SolidsRequest,
    write=write,
    media_types=(PYTHON,),
)
