"""Parts of a reducer along its axis, its outer sizes, and sizes that are usual.

The axis has one datum: z = 0 is the inner face of the plate of the carrier that holds the pins, and
z grows towards the discs. Usual sizes are rules of thumb for a first drawing; no standard has them.
"""

import math
from dataclasses import dataclass, fields
from functools import partial
from itertools import chain
from typing import Any, Literal

from core.design.contact import Contact
from core.design.ring import Ring
from core.design.sections import Build, DesignPin, Load, MechanismSection, SatelliteBody, Shaft
from core.errors import Accuracy, if_known, required
from core.fields import answer
from core.precision import AS_TYPED, ROUNDING

GAP, GAPS = 0.1, (0.5e-3, 2e-3)
"""Usual gap beside a disc over the width of the disc, and its least and largest value, m."""

PLATE, LEAST_PLATE = 1.2, 3e-3
"""Usual width of a plate of the carrier over the diameter of the pins, and its least value, m."""

HOUSING, LEAST_WALL = 1.1, 3e-3
"""Usual radius of the ring housing over that of the ring in it, and its least wall, m."""

Place = tuple[float, float]
"""Both ends of a part along the axis, m."""

PLACED = {
    "pin.satellite_positions": "even_places",
    "pin.span": "usual_span",
    "crankshaft.satellite_positions": "disc_places",
    "crankshaft.bearing_positions": "usual_bearing_places",
}
"""Properties of `Layout` by the paths of the places that follow from `build`; each needs those
before."""

BuildPart = Literal["housing", "carrier", "second_carrier", "discs", "bearing_a", "bearing_b"]


@dataclass(frozen=True, slots=True)
class Envelope:
    """Outer sizes of a reducer, without motor, bearing of the output and seals."""

    outer_diameter: float = answer("mm", "D")
    """Diameter of ring housing or carrier, the larger one."""
    length: float = answer("mm", "L")
    """Length from the outermost face to the outermost face of carrier plates, ring housing, discs
    and those bearings of the crankshaft whose width is given."""
    of: tuple[BuildPart, ...] = answer()
    """Parts that state the diameter, the end at the carrier and the other end, in this order."""
    accuracy: Accuracy = answer()


class Layout:
    """Sizes of a design along its axis and around it, in m; `NotKnown` if one that is needed is not
    given.
    """

    mechanism: MechanismSection
    load: Load
    contact: Contact
    pin: DesignPin
    gear: Ring
    crankshaft: Shaft
    satellite_body: SatelliteBody
    build: Build

    @property
    def pin_length(self) -> float:
        """Contact length along the pin, m."""
        length = self.pin.contact_length if self.pin else None
        if length is None:
            length = required(self.contact.contact_length, "section_missing", "contact")
        return length

    @property
    def pin_circle_radius(self) -> float:
        """Radius of the circle of pin centres, m; `NotKnown` if it is not given."""
        return required(self.load.pin_circle_radius, "size_missing", "load.pin_circle_radius")

    @property
    def known_eccentricity(self) -> float:
        """Eccentricity, m; `NotKnown` if it is not given."""
        given = self.contact.eccentricity if self.contact else None
        return required(given, "eccentricity_assumed", "contact.eccentricity")

    @property
    def pin_diameter(self) -> float:
        """Diameter of the pins, m; that of what touches the holes if no other is given."""
        if self.pin:
            return self.pin.diameter
        return 2 * required(self.contact.pin_radius, "size_missing", "contact.pin_radius")

    @property
    def gap(self) -> float:
        """Gap between two discs, and between a disc and a plate, m."""
        least, most = GAPS
        return self.build.gap or min(max(GAP * self.pin_length, least), most)

    @property
    def carrier_width(self) -> float:
        """Width of the plate that holds the pins, m."""
        return self.build.carrier_width or self._usual_plate(0)

    @property
    def second_carrier_width(self) -> float:
        """Width of the second plate, m; 0 if there is none."""
        if self.build.second_carrier_width:
            return self.build.second_carrier_width
        return self._usual_plate(1) if self.pin and self.pin.support != "cantilever" else 0.0

    def _usual_plate(self, end: int) -> float:
        return max(PLATE * self.pin_diameter, LEAST_PLATE, self._bearing_width(end))

    def _bearing_width(self, end: int) -> float:
        """Width of the crankshaft's bearing at an end, m; 0 if it is not given."""
        bearings = self.crankshaft.bearings if self.crankshaft else ()
        return (bearings[end].width if bearings else None) or 0.0

    @property
    def carrier_diameter(self) -> float:
        """Outer diameter of the carrier, m."""
        given = self.build.carrier_diameter
        return given or 2 * (self.pin_circle_radius + self.pin_diameter)

    @property
    def ring_reach(self) -> float:
        """Radius that the ring takes, m: that of its pins or roots, or of the space in which
        satellites of unknown teeth move.
        """
        reach = self.gear.reach(self.mechanism.ratio) if self.gear else None
        if reach is not None:
            return reach
        outer = self.satellite_body.outer_radius if self.satellite_body else None
        name = "satellite_body.outer_radius"
        return required(outer, "size_missing", name) + self.known_eccentricity

    @property
    def housing_diameter(self) -> float:
        """Outer diameter of the ring housing, m."""
        if self.build.housing_diameter:
            return self.build.housing_diameter
        reach = self.ring_reach
        diameter = 2e3 * max(HOUSING * reach, reach + LEAST_WALL)
        return math.ceil(diameter * (1 - AS_TYPED)) / 1e3

    @property
    def housing_width(self) -> float:
        """Width of the ring housing, m."""
        low, high = self.room
        return self.build.housing_width or high - low

    @property
    def even_places(self) -> tuple[float, ...]:
        """Middle plane of each disc with equal gaps, m: ``g + b/2 + (j - 1)*(b + g)``."""
        width, gap = self.pin_length, self.gap
        return tuple(gap + width / 2 + j * (width + gap) for j in range(self.mechanism.satellites))

    @property
    def disc_places(self) -> tuple[float, ...]:
        """Middle plane of each disc, m: as on the pins, or with equal gaps."""
        return (self.pin.satellite_positions if self.pin else ()) or self.even_places

    @property
    def room(self) -> Place:
        """Ends of the discs with a gap beside them, m."""
        beside = self.pin_length / 2 + self.gap
        return min(self.disc_places) - beside, max(self.disc_places) + beside

    @property
    def usual_span(self) -> float:
        """Distance of the plates, or of the carrier and the middle of a tie ring, m."""
        tied = self.pin and self.pin.support == "tie_ring"
        return self.room[1] + (self.second_carrier_width / 2 if tied else 0.0)

    @property
    def second_face(self) -> float:
        """Inner face of the second plate, m."""
        if not self.pin or self.pin.span is None:
            return self.room[1]
        return self.pin.span - (self.second_carrier_width / 2 if self.pin.tied else 0.0)

    @property
    def shaft_way(self) -> float:
        """1 if the crankshaft's axis points from the carrier to the discs, else -1."""
        places, on_shaft = self.disc_places, self.crankshaft.satellite_positions
        return math.copysign(1.0, (on_shaft[-1] - on_shaft[0]) * (places[-1] - places[0]))

    @property
    def usual_bearing_places(self) -> tuple[float, ...]:
        """Places of the crankshaft's bearings on its own axis, m, ascending: in the middle of each
        plate, or beside the last disc if there is no second one.
        """
        wide, second = self.carrier_width, self.second_carrier_width
        far = self.second_face + second / 2
        if not second:
            far = self.room[1] + (self._bearing_width(1) or wide) / 2
        first, way = self.crankshaft.satellite_positions[0], self.shaft_way
        return tuple(sorted(first + way * (z - self.disc_places[0]) for z in (-wide / 2, far)))

    @property
    def usual_build(self) -> dict[str, Any]:
        """Known sizes of carrier and housing that are not given, and what follows, by path in SI
        units.
        """
        names = [each.name for each in fields(Build) if getattr(self.build, each.name) is None]
        known = {f"build.{name}": if_known(partial(getattr, self, name)) for name in names}
        followed = {
            path: getattr(getattr(self, section), field)
            for path in self.build.follows
            for section, field in (path.split("."),)
            if getattr(self, section)
        }
        return {path: value for path, value in (known | followed).items() if value}

    @property
    def ends(self) -> dict[BuildPart, Place]:
        """Both ends of each part along the axis, m; bearings without a width are left out."""
        low, high = self.room
        middle, half = (low + high) / 2, self.housing_width / 2
        found: dict[BuildPart, Place] = {
            "housing": (middle - half, middle + half),
            "carrier": (-self.carrier_width, 0.0),
        }
        if second := self.second_carrier_width:
            found["second_carrier"] = (self.second_face, self.second_face + second)
        found["discs"] = (low + self.gap, high - self.gap)
        names: tuple[BuildPart, BuildPart] = ("bearing_a", "bearing_b")
        for end, name in enumerate(names):
            if half := self._bearing_width(end) / 2:
                places = self.crankshaft.places
                away = places["bearing_positions"][end] - places["satellite_positions"][0]
                at = self.disc_places[0] + self.shaft_way * away
                found[name] = (at - half, at + half)
        return found

    @property
    def outermost(self) -> tuple[float, BuildPart]:
        """Outer diameter, m, and the part that states it."""
        sizes: dict[BuildPart, float] = {
            "housing": self.housing_diameter,
            "carrier": self.carrier_diameter,
        }
        part = max(sizes, key=lambda each: sizes[each])
        return sizes[part], part

    @property
    def extent(self) -> tuple[float, BuildPart, BuildPart]:
        """Length, m, and the parts that state the end at the carrier and the other end."""
        ends = self.ends
        lows, highs = zip(*ends.values(), strict=True)
        # parts are compared in nm, so that rounding names no bearing that is flush with its plate
        first = min(ends, key=lambda each: round(ends[each][0], 9))
        last = max(ends, key=lambda each: round(ends[each][1], 9))
        return max(highs) - min(lows), first, last

    @property
    def envelope(self) -> Envelope:
        """Outer sizes of the reducer."""
        diameter, part = self.outermost
        length, *of = self.extent
        on_shaft = self.crankshaft.satellite_positions if self.crankshaft else ()
        farthest = max(map(abs, (*on_shaft, *chain(*self.ends.values()))))
        error = 8 * ROUNDING * max(farthest / length, 1.0)
        return Envelope(diameter, length, (part, *of), Accuracy("closed_form", error, 1))
