"""Contents of drawings, one sheet for each part: outlines, circles, tables, notes; lengths in mm.

Front views are seen from the side of the discs, z towards the eye, with X and Y of
`core.design.solids`. Beside them stand views from the left, z to the right (first-angle
projection): of the shaft from outside, of all other parts cut along X = 0.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from app.units import from_si
from core.arrays import FloatArray
from core.design.diameters import Diameter, Sizes, diameter_of
from core.design.document import Design
from core.design.drawings import DrawnRing, DrawnRingPins, DrawnSatellite, drawn_disc
from core.design.solids import Body, Lobes, Solids, Stretch
from core.errors import if_known

BEYOND = 1.15
"""Length of centre lines over the diameter that they cross."""

APART = 1.5
"""Place of a view from the left over the reach of the front view."""

DIGITS = 12
"""Decimals of millimetres that exceed rounding."""

HATCHED = {"satellite": 1.0, "housing": 1.5, "carrier": 2.0, "second_carrier": 2.0}
"""Spacing of the hatching of parts that are cut, which differs where they are beside each other."""

BEHIND = ("carrier", "bearing_a", "bearing_b")
"""Parts behind others in the front view of the assembly."""

HOLE_TITLES = ("No.", "X", "Y", "D", "Limits")
STEP_TITLES = ("Step", "Z from", "Z to", "D", "X", "Y")
PART_TITLES = ("Part", "Pieces", "Z from", "Z to", "X", "Y")


class Circle(NamedTuple):
    """Circle of a view."""

    layer: str
    x: float
    y: float
    radius: float
    label: str = ""  # text beside its centre, which is marked then
    hidden: bool = False  # True if it is behind other parts


class Outline(NamedTuple):
    """Closed outline of a view."""

    points: FloatArray  # X, Y and the bulge of the arc to the next point, shape (n, 3)
    hidden: bool = False  # True if it is behind other parts
    hatched: float = 0.0  # spacing of the hatching of a cut, 0 without
    crossed: bool = False  # True with diagonals, as in a bearing


class Sheet(NamedTuple):
    """Drawing of a part."""

    name: str
    title: str
    reach: float  # largest distance of the front view from the origin
    notes: Sequence[str]  # lines of text
    outlines: Sequence[Outline] = ()
    circles: Sequence[Circle] = ()
    pitch: float | None = None  # radius of the circle of numbered centres
    axes: Sequence[tuple[float, float]] = ()  # ends of the axis in views from the left
    table: Sequence[Sequence[str]] = ()  # rows of texts, the first one of titles
    said: Sequence[tuple[str, str]] = ()  # properties for other programs, by name


def of_satellite(drawn: DrawnSatellite, design: Design, sizes: Sizes) -> Sheet:
    """Satellite about its own centre."""
    outline, error = from_si("points_mm", drawn.outline), from_si("length_mm", drawn.chord_error)
    bore = from_si("radius_mm", drawn.bore_radius)
    x, y = (round(from_si("centre_mm", each), DIGITS) + 0.0 for each in drawn.centre)
    circles, table, pitch, holes = [], [], None, "Without holes"
    if drawn.holes:
        circles = _numbered("HOLES", drawn.holes.centres, drawn.holes.radius)
        pitch = from_si("radius_mm", drawn.holes.circle_radius)
        of = diameter_of(design, part="hole")
        table, holes = _hole_table(circles, of), f"{len(circles)} holes of {_said(of, sizes)}"
    if bore is not None:
        circles.append(Circle("BORE", 0.0, 0.0, bore))
    if design.gear.kind == "involute":
        form = _teeth(design, design.lobes, design.involute.satellite_profile_shift)
    else:
        own, disc = design.cycloid.changed, drawn_disc(design=design)
        tool, circle = (from_si("length_mm", each) for each in (own.equidistant, own.pin_circle))
        form = (
            f"{disc.satellite_teeth} lobes",
            f"Equidistant modification {tool:+.6g} mm, of the circle {circle:+.6g} mm",
        )
    width = if_known(lambda: design.pin_length)
    return Sheet(
        name=f"satellite_{drawn.number}",
        title=f"Satellite {drawn.number} of {design.mechanism.satellites}, {form[0]}",
        reach=float(np.hypot(*outline.T).max()),
        notes=[
            f"Closed polyline of {len(outline)} points, {error:.4g} mm from the outline at most",
            form[1],
            holes,
            "Bore not given" if bore is None else f"Bore {2 * bore:.9g} mm",
            "Width not given" if width is None else f"Width {_mm(width)}",
            f"At the crank angle 0 this centre is at X {x:.6f}, Y {y:.6f} mm",
        ],
        outlines=[_polygon(outline)],
        circles=circles,
        pitch=pitch,
        table=table,
        said=[
            ("chord_error_mm", repr(error)),
            ("centre_x_mm", repr(x)),
            ("centre_y_mm", repr(y)),
        ],
    )


def of_ring(drawn: DrawnRing, design: Design) -> Sheet:
    """Teeth of an involute ring."""
    outline, error = from_si("points_mm", drawn.outline), from_si("length_mm", drawn.chord_error)
    count, rack = _teeth(design, drawn.teeth, design.involute.ring_profile_shift)
    return Sheet(
        name="ring",
        title=f"Ring, {count}",
        reach=float(np.hypot(*outline.T).max()),
        notes=[
            f"Closed polyline of {len(outline)} points, {error:.4g} mm from the outline at most",
            rack,
            "No cutter given: flanks go on to the roots, whose circle is assumed"
            if drawn.root_assumed
            else "Roots as the cutter leaves them",
            "A crank of the angle 0 faces a space at the crank angle 0",
        ],
        outlines=[_polygon(outline)],
        pitch=from_si("length_mm", drawn.reference_radius),
        said=[("chord_error_mm", repr(error))],
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


def of_ring_pins(drawn: DrawnRingPins, design: Design, sizes: Sizes) -> Sheet:
    """Pins of the ring about the axis."""
    pitch, of = from_si("length_mm", drawn.circle_radius), diameter_of(design, part="ring_pin")
    circles = _numbered("PINS", drawn.centres, drawn.radius)
    return Sheet(
        name="ring_pins",
        title="Pins of the ring",
        reach=pitch + circles[0].radius,
        notes=[
            f"{len(circles)} pins of {_said(of, sizes)}",
            "Numbered anticlockwise; a crank of the angle 0 faces the first at the crank angle 0",
        ],
        circles=circles,
        pitch=pitch,
        table=_hole_table(circles, of),
    )


def of_plate(body: Body, design: Design) -> Sheet:
    """Plate of the carrier with its section."""
    outlines, (outer, *circles), axes = _views(body)
    holes = [each for each in circles if each.layer == "HOLES"]
    bores = [each for each in circles if each.layer == "BORE"]
    second = body.name == "second_carrier"
    return Sheet(
        name=body.name,
        title="Second plate of the carrier" if second else "Plate of the carrier",
        reach=outer.radius,
        notes=[
            *_round(body, outer),
            f"{len(holes)} holes of diameter {2 * holes[0].radius:.9g} mm for "
            + ("the bolts" if design.bolted and not second else "the pins"),
            f"Seat of a bearing of diameter {2 * bores[0].radius:.9g} mm"
            if bores
            else "No bearing of the crankshaft given: without its seat",
            *_usual(design, f"{body.name}_width", "carrier_diameter"),
        ],
        outlines=outlines,
        circles=[*holes, *bores, outer],
        pitch=from_si("radius_mm", design.pin_circle_radius),
        axes=axes,
        table=_hole_table([*holes, *bores]),
    )


def of_housing(body: Body, design: Design) -> Sheet:
    """Ring housing with its section, and the seats of its pins or its teeth."""
    outlines, (outer, *circles), axes = _views(body)
    seats = [each for each in circles if each.layer == "HOLES"]
    (housing,) = body.stretches
    inside = "Free inside for pins that are held at their ends"
    if seats:
        inside = (
            f"{len(seats)} seats of pins of diameter {2 * seats[0].radius:.9g} mm, on their own"
            " layer as they are drilled"
        )
    if housing.opening:
        inside = f"{housing.opening.lobes} teeth"
    return Sheet(
        name=body.name,
        title="Ring housing",
        reach=outer.radius,
        notes=[
            *_round(body, outer),
            inside,
            *_usual(design, "housing_width", "housing_diameter"),
        ],
        outlines=outlines,
        circles=[*seats, *(each for each in circles if each.layer == "BORE"), outer],
        pitch=from_si("radius_mm", design.cycloid.ring_pin_circle_radius) if seats else None,
        axes=axes,
        table=_hole_table(seats),
    )


def of_shaft(body: Body, design: Design) -> Sheet:
    """Crankshaft from its end and from the left, with a table of its steps."""
    body = body._replace(stretches=tuple(sorted(body.stretches, key=lambda each: each.low)))
    outlines, circles, axes = _views(body, cut=False)
    steps = list(zip(map(str, range(1, len(circles) + 1)), body.stretches, circles, strict=True))
    shown = [each._replace(label=name if each.x or each.y else "") for name, _, each in steps]
    bearings = design.crankshaft.bearings or (None, None)
    return Sheet(
        name=body.name,
        title="Crankshaft",
        reach=max(math.hypot(each.x, each.y) + each.radius for each in circles),
        notes=[
            f"Eccentricity {_mm(design.known_eccentricity)}",
            "Z from the inner face of the plate that holds the pins towards the discs",
            *(
                f"Width of bearing {name} not given: it has no room at its end"
                for name, each in zip("AB", bearings, strict=True)
                if each is None or each.width is None
            ),
        ],
        outlines=outlines,
        circles=list(dict.fromkeys(shown)),
        axes=axes,
        table=[
            STEP_TITLES,
            *(
                (name, *_places(*_ends(step), 2 * at.radius, at.x, at.y))
                for name, step, at in steps
            ),
        ],
    )


def of_assembly(found: Solids, lacking: Mapping[str, str], crank_angle_deg: float) -> Sheet:
    """All parts together; the front view has no second plate."""
    outlines, circles, rows = [], [], [[*PART_TITLES]]
    nearest = max(_nearest(body) for body in found.bodies if body.name.startswith("satellite"))
    for body in found.bodies:
        z = [end for each in body.stretches for end in _ends(each)]
        single = len(body.stretches) == len(body.places) == 1
        at = from_si("points_mm", np.array(body.stretches[0].centre)).tolist()
        where = _places(*at) if single else ["", ""]
        rows.append(
            [body.name.replace("_", " "), str(len(body.places)), *_places(min(z), max(z)), *where]
        )
        if body.name == "second_carrier":
            continue
        own, rounds = _front(body)
        hidden = body.name in BEHIND or (body.name[-1].isdigit() and _nearest(body) < nearest)
        outlines += [each._replace(hidden=hidden) for each in own]
        pins = body.name.startswith(("pin", "ring_pin", "sleeve", "bolt"))
        drilled = body.name in BEHIND or body.name == "housing"  # where pins are drawn
        for each in rounds:
            if not (drilled and each.layer == "HOLES"):
                layer = "PINS" if pins else each.layer
                circles.append(each._replace(layer=layer, label="", hidden=hidden))
    reach = max(math.hypot(each.x, each.y) + each.radius for each in circles)
    section, axes = _from_left(found.bodies, reach)
    return Sheet(
        name="assembly",
        title="Assembly",
        reach=reach,
        notes=[
            f"At the crank angle {crank_angle_deg:.9g} deg, by which cranks have turned clockwise",
            "Front view without the second plate; what stands behind is dashed",
            "Shapes that the design does not state are plain plates, rings and cylinders",
            *(
                f"Left out: {name.replace('_', ' ')}; {what} is not known"
                for name, what in lacking.items()
            ),
        ],
        outlines=[*outlines, *section],
        circles=list(dict.fromkeys(circles)),
        axes=axes,
        table=rows,
        said=[("crank_angle_deg", repr(crank_angle_deg))],
    )


def _nearest(body: Body) -> float:
    return max(each.high for each in body.stretches)


def _views(
    body: Body, *, cut: bool = True
) -> tuple[list[Outline], list[Circle], list[tuple[float, float]]]:
    """Outlines, circles and axes of a body from its front and from the left."""
    outlines, circles = _front(body)
    reach = max(math.hypot(each.x, each.y) + each.radius for each in circles)
    section, axes = _from_left([body], reach, cut=cut)
    return [*outlines, *section], circles, axes


def _front(body: Body) -> tuple[list[Outline], list[Circle]]:
    """Outlines and circles of a body, those outside first, then its numbered holes."""
    outlines, circles = [], []
    for stretch in body.stretches:
        holes = _holes(stretch)
        seats = [each for each in holes if each.layer == "HOLES"]
        if body.name == "housing" and seats:
            bore = next(each.radius for each in holes if each.layer == "BORE")
            outlines.append(_between_seats(bore, seats))
            holes = seats
        faces = [
            _polygon(_whole(face))
            for face in (stretch.outline, stretch.opening)
            if isinstance(face, Lobes)
        ]
        x, y = from_si("points_mm", np.array(stretch.centre)).tolist()
        if not isinstance(stretch.outline, Lobes):
            holes = [Circle("OUTLINE", 0.0, 0.0, from_si("radius_mm", stretch.outline)), *holes]
        for dx, dy in from_si("points_mm", np.array(body.places)).tolist():
            outlines += [_moved(each, x + dx, y + dy) for each in faces]
            circles += [each._replace(x=each.x + x + dx, y=each.y + y + dy) for each in holes]
    return outlines, circles


def _holes(stretch: Stretch) -> list[Circle]:
    """Holes about the centre of a stretch, those off it with numbers."""
    found: list[Circle] = []
    for x, y, radius in from_si("points_mm", np.array(stretch.holes)).reshape(-1, 3).tolist():
        off = x != 0 or y != 0
        label = str(1 + sum(each.layer == "HOLES" for each in found)) if off else ""
        found.append(Circle("HOLES" if off else "BORE", x, y, radius, label))
    return found


def _between_seats(bore: float, seats: list[Circle]) -> Outline:
    """Inside of a housing: arcs of its bore, between seats whose centres are on it, and of seats;
    anticlockwise.
    """
    radius, first, count = seats[0].radius, seats[0], len(seats)
    half = 2 * math.asin(radius / (2 * bore))
    middles = math.atan2(first.y, first.x) + 2 * math.pi * np.arange(count) / count
    ends = np.column_stack((middles - half, middles + half)).ravel()
    of_seat = math.tan((math.pi - math.acos(radius / (2 * bore))) / 2)
    of_bore = math.tan((math.pi / count - half) / 2)
    bulges = np.tile((of_seat, of_bore), count)
    return Outline(np.column_stack((bore * np.cos(ends), bore * np.sin(ends), bulges)))


def _from_left(
    bodies: Iterable[Body], reach: float, *, cut: bool = True
) -> tuple[list[Outline], list[tuple[float, float]]]:
    """Rectangles of bodies, cut along X = 0 or seen from the left, beside a front view, and the
    ends of their axis.
    """
    bodies = list(bodies)
    ends = [end for body in bodies for each in body.stretches for end in _ends(each)]
    away = APART * reach - min(ends)
    found = []
    for body in bodies:
        name = body.name.rstrip("0123456789").rstrip("_")
        crossed = "bearing" in name
        for stretch in body.stretches:
            low, high = (away + each for each in _ends(stretch))
            for place in body.places:
                for y in _pieces(stretch, place, cut=cut):
                    corners = [(low, y[0]), (high, y[0]), (high, y[1]), (low, y[1])]
                    rectangle = _polygon(np.array(corners))
                    found.append(
                        rectangle._replace(hatched=HATCHED.get(name, 0.0), crossed=crossed)
                    )
    beyond = (BEYOND - 1) * reach
    return found, [(away + min(ends) - beyond, away + max(ends) + beyond)]


def _pieces(
    stretch: Stretch, place: tuple[float, float], *, cut: bool
) -> list[tuple[float, float]]:
    """Least and largest Y of the pieces of a stretch along X = 0, or of all of it."""
    x, y = from_si("points_mm", np.array(stretch.centre) + place).tolist()
    if not cut:
        assert not isinstance(stretch.outline, Lobes)
        radius = from_si("radius_mm", stretch.outline)
        return [(y - radius, y + radius)]
    inside = [
        span for hole in _holes(stretch) for span in _chord(hole.radius, hole.x + x, hole.y + y)
    ]
    if stretch.opening:
        inside += _chord(stretch.opening, x, y)
    left = _chord(
        stretch.outline
        if isinstance(stretch.outline, Lobes)
        else from_si("radius_mm", stretch.outline),
        x,
        y,
    )
    for low, high in inside:
        left = [
            piece
            for start, end in left
            for piece in ((start, min(end, low)), (max(start, high), end))
            if piece[1] > piece[0]
        ]
    return left


def _chord(face: Lobes | float, x: float, y: float) -> list[tuple[float, float]]:
    """Least and largest Y of a circle of a radius, or of an outline, about X and Y along X = 0."""
    if not isinstance(face, Lobes):
        half = math.sqrt(max(face**2 - x**2, 0.0))
        return [(y - half, y + half)] if half else []
    across, along = np.add(_whole(face), (x, y)).T
    following, there = np.roll(across, -1), np.roll(along, -1)
    passing = (across < 0) != (following < 0)
    share = across[passing] / (across[passing] - following[passing])
    ends = np.sort(along[passing] + share * (there[passing] - along[passing]))
    return list(zip(ends[::2].tolist(), ends[1::2].tolist(), strict=True))


def _whole(face: Lobes) -> FloatArray:
    """Points of all lobes."""
    points: FloatArray = from_si("points_mm", face.points)
    turns = np.exp(-2j * math.pi * np.arange(face.lobes) / face.lobes)
    around = np.multiply.outer(turns, points @ np.array([1, 1j])).ravel()
    return np.column_stack((around.real, around.imag))


def _polygon(points: FloatArray) -> Outline:
    return Outline(np.column_stack((points, np.zeros(len(points)))))


def _moved(outline: Outline, x: float, y: float) -> Outline:
    return outline._replace(points=np.add(outline.points, (x, y, 0.0)))


def _numbered(layer: str, centres: FloatArray, radius: float) -> list[Circle]:
    """Circles of one size, numbered from 1, of lengths in m."""
    size = from_si("radius_mm", radius)
    places = from_si("points_mm", centres).tolist()
    return [Circle(layer, x, y, size, str(number)) for number, (x, y) in enumerate(places, 1)]


def _hole_table(circles: Iterable[Circle], of: Diameter | None = None) -> list[Sequence[str]]:
    """Table of holes or pins, empty without any; `of` has their limits."""
    limits = _limits(of) if of else "not given"
    rows = [
        (each.label or "bore", *_places(each.x, each.y, 2 * each.radius), limits)
        for each in circles
    ]
    return [HOLE_TITLES, *rows] if rows else []


def _limits(of: Diameter) -> str:
    """Limits of a diameter, by its class and deviations."""
    if of.limits is None:
        return "not given"
    both = (from_si("length_mm", each) for each in (of.limits.upper, of.limits.lower))
    words = "/".join(f"{each:+.6g}" if each else "0" for each in both)
    return f"{of.tolerance_class or ''} {words}".lstrip()


def _said(of: Diameter, sizes: Sizes) -> str:
    """Words about a diameter."""
    nominal, drawn = (_mm(each) for each in (of.nominal, of.drawn(sizes)))
    if of.limits is None:
        return f"diameter {drawn}"
    middle = f", the middle of its limits, {drawn}" if sizes == "mean" else ""
    return f"diameter {nominal} {_limits(of)}{middle}"


def _round(body: Body, outer: Circle) -> list[str]:
    """Words about the size of a round part."""
    (low, high) = _ends(body.stretches[0])
    return [f"Diameter {2 * outer.radius:.9g} mm, width {high - low:.9g} mm"]


def _usual(design: Design, *names: str) -> list[str]:
    """Words about sizes that are not given, but usual."""
    usual = [name for name in names if f"build.{name}" in design.usual_build]
    words = ", ".join(name.rpartition("_")[2] for name in usual)
    return [f"Not given, but usual: {words}"] if usual else []


def _ends(stretch: Stretch) -> tuple[float, float]:
    """Both ends of a stretch along the axis, mm."""
    return from_si("length_mm", stretch.low), from_si("length_mm", stretch.high)


def _places(*lengths: float) -> list[str]:
    """Texts of a table, to 1e-6 mm."""
    return [f"{round(each, 6) + 0.0:.6f}".rstrip("0").rstrip(".") for each in lengths]


def _mm(length: float) -> str:
    return f"{from_si('length_mm', length):.9g} mm"
