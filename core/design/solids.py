"""Parts of a design as solids: outlines with round holes, each along a stretch of the axis.

X and Y are those of `core.design.drawings`, z that of `core.design.layout`. At a crank angle phi
the cranks have turned clockwise by it, and discs, pins and carrier anticlockwise by ``phi/u``; the
ring is at rest. Shapes that a design does not state are those whose mass `core.design.mass`
estimates: plain plates, rings and cylinders.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.design.diameters import Sizes, diameter_of
from core.design.document import Design
from core.design.drawings import DrawnSatellite, drawn_ring, drawn_ring_pins, drawn_satellites
from core.design.layout import BuildPart
from core.design.mass import far_end, plate_holes, shaft_sizes
from core.errors import UNKNOWN, NotKnown, required

Point = tuple[float, float]

ORIGIN: Point = (0.0, 0.0)


class Lobes(NamedTuple):
    """Closed outline of equal lobes or teeth."""

    points: FloatArray  # points of one lobe without its end, clockwise, m, shape (n, 2)
    lobes: int  # number of them
    smooth: bool  # True if a smooth curve runs through the points, False for their polygon


class Stretch(NamedTuple):
    """Solid between two places along the axis, m."""

    outline: Lobes | float  # about the centre; a radius if round
    low: float  # where it begins, m
    high: float  # where it ends, m
    centre: Point = ORIGIN  # X and Y of its centre, m
    holes: tuple[tuple[float, float, float], ...] = ()  # X and Y about the centre, and radius
    opening: Lobes | None = None  # inner outline of a ring


class Body(NamedTuple):
    """Part of one or more stretches, and where equal ones are."""

    name: str  # name of the part, with the number of its satellite
    stretches: tuple[Stretch, ...]  # its pieces along the axis, which are one solid
    places: tuple[Point, ...] = (ORIGIN,)  # shift of each piece, m


class Solids(NamedTuple):
    """Solids of a design."""

    bodies: tuple[Body, ...]  # all parts
    chord_error: float  # largest distance of outlines from the polygon of their points, m
    left_out: dict[str, str]  # path of an input that a part lacks, or "", by the part's name


def solids(
    design: Design, *, chord_error: float, crank_angle: float = 0.0, sizes: Sizes = "nominal"
) -> Solids:
    """Solids of all parts of a design whose sizes are known.

    Raises what `drawn_satellites` and `drawn_ring` or `drawn_ring_pins` raise. Other parts whose
    sizes are not known are left out. The chord error is that of an outline's polygon, m, > 0; the
    crank angle is in rad; pins and holes have nominal diameters or the middle of their limits.
    """
    made = _Maker(design, chord_error, crank_angle, sizes)
    bodies, left_out = [*made.discs, *made.ring], {}
    for name, of_part in made.others.items():
        try:
            bodies += of_part()
        except UNKNOWN as why:
            missing = why.missing if isinstance(why, NotKnown) else ()
            left_out[name] = missing[0] if missing else ""
    return Solids(tuple(bodies), made.error, left_out)


class _Maker:
    """Solids of one design, part by part."""

    def __init__(
        self, design: Design, chord_error: float, crank_angle: float, sizes: Sizes
    ) -> None:
        numbers = tuple(range(1, design.mechanism.satellites + 1))
        self.design, self.chord_error, self.sizes = design, chord_error, sizes
        drawn = drawn_satellites(
            design=design, numbers=numbers, chord_error=chord_error, sizes=sizes
        )
        self.drawn = tuple(_turned(each, crank_angle, design.mechanism.ratio) for each in drawn)
        self.error = max(each.chord_error for each in self.drawn)

    @property
    def touching(self) -> float:
        """Radius of what touches the holes, m."""
        return diameter_of(self.design, part="pin").drawn(self.sizes) / 2

    @property
    def others(self) -> dict[str, Callable[[], Iterator[Body]]]:
        """Solids besides discs and ring, by the names of the parts."""
        design = self.design
        own: dict[str, Callable[[], Iterator[Body]]] = {
            "pins": self.pins,
            "carrier": partial(self.plate, 0),
        }
        if design.sleeved or design.rollers:
            name = "pin_bearing" if design.rollers else "sleeve"
            own[f"{name}s"] = partial(self.sleeves, name)
        if design.bolted:
            own["bolts"] = self.bolts
        if design.second_carrier_width:
            own["second_carrier"] = partial(self.plate, 1)
        if design.members.output != "coupling":
            own |= {"shaft": self.shaft, "satellite_bearings": self.satellite_bearings}
            own |= {f"bearing_{'ab'[end]}": partial(self.bearing, end) for end in (0, 1)}
        if design.crankshaft and design.crankshaft.counterweights:
            own["counterweights"] = self.counterweights
        return own

    @property
    def pin_centres(self) -> tuple[Point, ...]:
        """Centres of the output pins about the axis, those of the holes about a disc's, m."""
        holes = required(self.drawn[0].holes, "section_missing", "contact")
        return _points(holes.centres)

    @property
    def discs(self) -> Iterator[Body]:
        """Satellites with their holes and bores."""
        design = self.design
        half, count = design.pin_length / 2, design.lobes
        for each, place in zip(self.drawn, design.disc_places, strict=True):
            holes = [(x, y, each.holes.radius) for x, y in each.holes.centres] if each.holes else []
            if each.bore_radius:
                holes.append((*ORIGIN, each.bore_radius))
            lobe = each.outline[: len(each.outline) // count]
            outline = Lobes(lobe, count, design.gear.kind == "cycloid")
            at = (place - half, place + half, each.centre, tuple(holes))
            yield Body(f"satellite_{each.number}", (Stretch(outline, *at),))

    @property
    def ring(self) -> Iterator[Body]:
        """Housing with the seats of its pins and the pins, or with its teeth."""
        design = self.design
        ends, outer = design.ends["housing"], design.housing_diameter / 2
        if design.gear.kind == "involute":
            drawn = drawn_ring(design=design, chord_error=self.chord_error)
            self.error = max(self.error, drawn.chord_error)
            lobe = drawn.outline[: len(drawn.outline) // drawn.teeth]
            teeth = Lobes(lobe, drawn.teeth, False)
            yield Body("housing", (Stretch(outer, *ends, opening=teeth),))
            return
        pins = drawn_ring_pins(design=design, sizes=self.sizes)
        seated = design.cycloid.pin_support == "seat"
        holes = [(*ORIGIN, pins.circle_radius if seated else design.ring_reach)]
        if seated:
            seat = design.cycloid.known_pin_radius
            holes += [(x, y, seat) for x, y in pins.centres]
        yield Body("housing", (Stretch(outer, *ends, holes=tuple(holes)),))
        yield Body("ring_pin", (Stretch(pins.radius, *ends),), _points(pins.centres))

    def pins(self) -> Iterator[Body]:
        """Output pins through the plates that hold them."""
        design = self.design
        low = 0.0 if design.bolted else -design.carrier_width
        bore = design.pin.bore_diameter if design.pin else 0.0
        holes = ((*ORIGIN, bore / 2),) if bore else ()
        bare = not (design.sleeved or design.rollers)
        radius = self.touching if bare else design.pin_diameter / 2
        pin = Stretch(radius, low, far_end(design), holes=holes)
        yield Body("pin", (pin,), self.pin_centres)

    def bolts(self) -> Iterator[Body]:
        """Cores of the bolts through the pins and the plates, without their heads."""
        design, bolt = self.design, self.design.pin.bolt
        assert bolt
        core = Stretch(bolt.core_diameter / 2, -design.carrier_width, far_end(design))
        yield Body("bolt", (core,), self.pin_centres)

    def counterweights(self) -> Iterator[Body]:
        """Raise NotKnown, as only mass times distance is stated."""
        raise NotKnown("counterweight_unknown", "crankshaft.counterweights")

    def sleeves(self, name: str) -> Iterator[Body]:
        """Sleeves on the output pins, or bearings as rings, one in each hole."""
        design, half = self.design, self.design.pin_length / 2
        hole = ((*ORIGIN, design.pin_diameter / 2),)
        for number, place in enumerate(design.disc_places, 1):
            sleeve = Stretch(self.touching, place - half, place + half, holes=hole)
            yield Body(f"{name}_of_satellite_{number}", (sleeve,), self.pin_centres)

    def plate(self, end: int) -> Iterator[Body]:
        """Plate of the carrier with the holes of the pins and of the crankshaft's bearing."""
        design = self.design
        name: BuildPart = "second_carrier" if end else "carrier"
        seat, hole = plate_holes(design=design, end=end)
        holes = [(x, y, hole / 2) for x, y in self.pin_centres]
        if seat:
            holes.append((*ORIGIN, seat / 2))
        outer = design.carrier_diameter / 2
        yield Body(name, (Stretch(outer, *design.ends[name], holes=tuple(holes)),))

    def shaft(self) -> Iterator[Body]:
        """Crankshaft from end to end of what it carries, with an eccentric in each disc."""
        design = self.design
        own, first = shaft_sizes(design), design.crankshaft.places["satellite_positions"][0]
        ends = (
            design.disc_places[0] + design.shaft_way * (end - first) for end in (own.low, own.high)
        )
        low, high = sorted(ends)
        half = own.long / 2
        places = sorted(zip(design.disc_places, (each.centre for each in self.drawn), strict=True))
        eccentrics = [Stretch(own.thick / 2, z - half, z + half, centre) for z, centre in places]
        edges = [low, *(edge for each in eccentrics for edge in each[1:3]), high]
        between = zip(edges[::2], edges[1::2], strict=True)
        journals = [Stretch(own.thin / 2, *both) for both in between if both[1] > both[0]]
        yield Body("shaft", (*journals, *eccentrics))

    def satellite_bearings(self) -> Iterator[Body]:
        """Bearings of the discs on their eccentrics, as rings."""
        own = self.design.bearing
        for drawn, place in zip(self.drawn, self.design.disc_places, strict=True):
            ring = self._ring_of(own, "bearing", place)
            yield Body(f"satellite_bearing_{drawn.number}", (ring._replace(centre=drawn.centre),))

    def bearing(self, end: int) -> Iterator[Body]:
        """Bearing of the crankshaft, as a ring."""
        bearings, path = self.design.crankshaft.bearings, f"crankshaft.bearings[{end}]"
        own = required(bearings or None, "bearing_unnamed", "crankshaft.bearings")[end]
        required(own.width, "size_missing", f"{path}.width")
        name: BuildPart = "bearing_b" if end else "bearing_a"
        yield Body(name, (self._ring_of(own, path, sum(self.design.ends[name]) / 2),))

    def _ring_of(self, bearing: object, path: str, place: float) -> Stretch:
        names = ("bore_diameter", "outer_diameter", "width")
        bore, outer, width = (
            required(getattr(bearing, name), "size_missing", f"{path}.{name}") for name in names
        )
        ends = place - width / 2, place + width / 2
        return Stretch(outer / 2, *ends, holes=((*ORIGIN, bore / 2),))


def _turned(drawn: DrawnSatellite, crank_angle: float, ratio: float) -> DrawnSatellite:
    """Satellite at a crank angle, rad."""
    of_disc, of_crank = (
        np.array([[math.cos(by), math.sin(by)], [-math.sin(by), math.cos(by)]])
        for by in (crank_angle / ratio, -crank_angle)
    )
    x, y = (np.array(drawn.centre) @ of_crank).tolist()
    return replace(
        drawn,
        centre=(x, y),
        turn=drawn.turn + crank_angle / ratio,
        outline=drawn.outline @ of_disc,
        holes=drawn.holes and replace(drawn.holes, centres=drawn.holes.centres @ of_disc),
    )


def _points(centres: FloatArray) -> tuple[Point, ...]:
    return tuple((x, y) for x, y in np.asarray(centres).tolist())
