"""Mass of a reducer, without motor and bearing of the output, and its inertia at the input.

Discs, sleeves and bearings have the shapes or masses of the design. A part marked as an estimate is
a plain cylinder, ring or plate: pins reach through the plates of the carrier, ring pins through the
housing, the crankshaft from the outside of one bearing to that of the other, with an eccentric in
each disc's bearing. Housing and carrier are of the material of the discs, a housing with involute
teeth of that of the ring if it is known, the crankshaft of `SHAFT`.

The kinetic energy is ``J*w_1^2/2`` with ``J = sum(I*(w/w_1)^2 + m*e^2)``: each part turns with the
moment of inertia I at its speed w, and discs with their bearings move on the circle of radius e.
Half of the mass of a crank's bearing, the one inside, turns with the crank.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from core.bearings import named_bearing
from core.design.document import Design
from core.design.refusals import named
from core.design.results import Results
from core.design.ring import DEDENDUM, CycloidRing, InvoluteRing
from core.design.sections import CatalogueBearing
from core.errors import UNKNOWN, Accuracy, NotKnown, if_known, required
from core.fields import answer
from core.hertz import ElasticMaterial
from core.material_table import MATERIALS
from core.precision import ROUNDING
from core.ring.profile import LOOKED
from core.ring.tooth_outline import satellite_outline

SHAFT = "steel_structural"
"""Material of the table that the crankshaft is taken to be of."""

CHORD, TEETH_ERROR = 1e-5, 1e-5
"""Distance of the outline of involute teeth from its polygon, in modules, and the relative error of
the area of such a disc without its holes."""

CLOSED = 100 * ROUNDING
"""Relative error of a cylinder."""

MassPart = Literal[
    "discs",
    "pins",
    "bolts",
    "sleeves",
    "pin_bearings",
    "ring_pins",
    "shaft",
    "counterweights",
    "satellite_bearings",
    "bearing_a",
    "bearing_b",
    "housing",
    "carrier",
    "second_carrier",
]


class Solid(NamedTuple):
    """Pieces of one part."""

    pieces: int  # number of pieces
    mass: float  # of all pieces, kg
    moment: float  # moment of inertia of all pieces about the axis that they turn about, kg*m^2
    turns: Literal["crank", "carrier", "ring"]  # member whose speed they have, discs the carrier's
    on_circle: bool = False  # True if they move on the circle of the eccentricity
    estimate: bool = True  # True if the shape is not stated
    error: float = CLOSED  # relative error of mass and moment


@dataclass(frozen=True, slots=True)
class PartMass:
    """Mass of one part of a reducer."""

    code: MassPart = answer()
    """Part of the reducer, by code."""
    count: int | None = answer()
    """Number of pieces; absent if the mass is not known."""
    mass: float | None = answer("kg", "m")
    """Mass of all pieces together; absent if it is not known."""
    estimate: bool | None = answer()
    """True if the shape is not stated: the part is a plain cylinder, ring or plate."""
    solid: Solid | None = None
    reason: str = ""  # code of the reason why the mass is not known
    params: Mapping[str, Any] = field(default_factory=dict)  # values in the reason's text, SI
    missing: tuple[str, ...] = ()  # paths of the inputs that are lacking
    refusal: None = None  # the reason is no refusal of an input


@dataclass(frozen=True, slots=True)
class Mass:
    """Mass of a reducer without motor and bearing of the output, and its inertia."""

    mass: float | None = answer("kg", "M")
    """Mass of all parts; absent if that of one part is not known."""
    inertia: float | None = answer("kg_m2", "J")
    """Moment of inertia at the input, of all that the crankshaft moves; absent without the mass, of
    a coupling, and if ring and pins are both outputs of unknown speed."""
    parts: tuple[PartMass, ...] = answer()
    """Parts of the reducer."""
    accuracy: Accuracy = answer()


def mass(design: Design) -> Mass:
    """Mass of each part of a design, of all together, and the inertia at its input.

    A part whose size, density or bearing is not known has a reason instead of a mass, and makes the
    mass of the reducer unknown. `InvalidInput` is raised for discs that cannot exist.
    """
    parts = tuple(_part(design, code) for code in _codes(design))
    solids = [each.solid for each in parts if each.solid]
    whole = math.fsum(each.mass for each in solids) if len(solids) == len(parts) else None
    inertia = None if whole is None else if_known(lambda: _inertia(design, solids))
    error = max((each.error for each in solids), default=CLOSED)
    return Mass(whole, inertia, parts, Accuracy("closed_form", error, 1))


def _codes(design: Design) -> list[MassPart]:
    """Parts that the design has."""
    cranked = design.members.output != "coupling"
    has: dict[MassPart, object] = {
        "bolts": design.bolted,
        "sleeves": design.sleeved,
        "pin_bearings": design.rollers,
        "ring_pins": design.gear and design.gear.kind == "cycloid",
        "counterweights": design.crankshaft and design.crankshaft.counterweights,
        **dict.fromkeys(("shaft", "satellite_bearings", "bearing_a", "bearing_b"), cranked),
        "second_carrier": design.build.second_carrier_width
        or (design.pin and design.pin.support != "cantilever"),
    }
    return [code for code in PARTS if has.get(code, True)]


def _part(design: Design, code: MassPart) -> PartMass:
    """Mass of a part, or the reason why it is not known."""
    try:
        solid = PARTS[code](design)
        if not solid.mass > 0:
            raise NotKnown("cannot_be")
    except UNKNOWN as why:
        missing = why.missing if isinstance(why, NotKnown) else ()
        return PartMass(code, None, None, None, reason=why.code, params=why.params, missing=missing)
    return PartMass(code, solid.pieces, solid.mass, solid.estimate, solid)


def _inertia(design: Design, solids: list[Solid]) -> float:
    """Moment of inertia at the input, kg*m^2; `NotKnown` if speeds are not."""
    members = design.members
    if members.output == "coupling":
        raise NotKnown("section_missing", "crankshaft")
    speeds = design.known_speeds if members.output == "both" else members.speeds(crank=1.0)
    circle = design.known_eccentricity**2
    return math.fsum(
        each.moment * (getattr(speeds, each.turns) / speeds.crank) ** 2
        + each.on_circle * each.mass * circle
        for each in solids
    )


def _density(material: ElasticMaterial | None, path: str) -> float:
    """Density of a material, kg/m^3; `NotKnown` with its path if it has none."""
    known = required(material, "section_missing", path).density
    return required(known, "density_unknown", path)


def _round(
    *,
    count: float = 1,
    density: float,
    outer: float,
    inner: float = 0.0,
    length: float,
    circle: float = 0.0,
    turns: Literal["crank", "carrier", "ring"] = "carrier",
    on_circle: bool = False,
    estimate: bool = True,
) -> Solid:
    """Cylinders or tubes of an outer and an inner diameter, m, on a circle of a radius, m."""
    whole = count * density * math.pi / 4 * (outer**2 - inner**2) * length
    moment = whole * ((outer**2 + inner**2) / 8 + circle**2)
    return Solid(round(count), whole, moment, turns, on_circle, estimate)


def _less(whole: Solid, *others: Solid) -> Solid:
    """Solid without others, in its own place."""
    left = [
        getattr(whole, name) - sum(getattr(each, name) for each in others)
        for name in ("mass", "moment")
    ]
    kept = min(left[0] / whole.mass, left[1] / whole.moment)
    error = whole.error * 2 / kept if kept > 0 else math.inf
    return whole._replace(mass=left[0], moment=left[1], error=error)


def _teeth(design: Design) -> tuple[float, float]:
    """Area, m^2, and polar moment, m^4, of a disc with involute teeth by its polygon."""
    pair = Results(design).ring.pair
    error = CHORD * design.involute.module
    points = satellite_outline(pair=pair, chord_error=error).whole
    others = np.roll(points, 1)  # points run clockwise
    cross = (np.conj(points) * others).imag
    inner = np.abs(points) ** 2 + (np.conj(points) * others).real + np.abs(others) ** 2
    return float(cross.sum()) / 2, float((cross * inner).sum()) / 12


def _blank(design: Design) -> tuple[float, float, float | None]:
    """Area, m^2, and polar moment, m^4, of a disc without holes, and the relative error of both;
    None for a plain disc in the place of an unknown outline.
    """
    gear = design.gear
    if gear and gear.kind == "cycloid" and (gear.teeth_difference or 1) == 1:
        lobes, eccentricity = design.lobes, design.known_eccentricity
        disc = named(
            design, "gear", lambda: gear.disc(satellite_teeth=lobes, eccentricity=eccentricity)
        )
        named(design, "gear", disc.refuse_undercut)
        k = disc.shortening
        return *disc.moments, CLOSED + k**LOOKED / (1 - k)
    radius = design.satellite_body.outer_radius if design.satellite_body else None
    if isinstance(gear, InvoluteRing):
        if known := if_known(lambda: _teeth(design)):
            return *known, TEETH_ERROR
        shift = gear.satellite_profile_shift or 0.0
        radius = gear.module * (gear.teeth_difference * design.mechanism.ratio / 2 + shift)
    radius = required(radius, "size_missing", "satellite_body.outer_radius")
    return math.pi * radius**2, math.pi * radius**4 / 2, None


def _of_discs(design: Design) -> float:
    """Density of the discs, kg/m^3."""
    own = design.gear.of_satellites if design.gear else None
    return _density(own or design.contact.hole_material, "contact.hole_material")


def _discs(design: Design) -> Solid:
    """Outline of each disc less its holes and bore, times its width."""
    count, width, weight = design.mechanism.satellites, design.pin_length, _of_discs(design)
    area, moment, error = _blank(design)
    each = count * weight * width
    blank = Solid(
        count, each * area, each * moment, "carrier", True, error is None, error or CLOSED
    )
    of_all: Any = {"density": weight, "length": width * count}
    bore = _round(outer=2 * design.bore_radius, **of_all)
    holes = _round(
        count=design.pin_count,
        outer=2 * design.nominal_pair.hole_radius,
        circle=design.pin_circle_radius,
        **of_all,
    )
    return _less(blank, bore, holes)


def far_end(design: Design) -> float:
    """Place of the far ends of the pins, m: the second plate's outer face, or the last disc's."""
    second = design.second_carrier_width
    return design.second_face + second if second else design.room[1] - design.gap


def _on_pins(design: Design, **sizes: Any) -> Solid:
    """Cylinders or tubes on the circle of the pins."""
    return _round(circle=design.pin_circle_radius, **sizes)


def _pins(design: Design) -> Solid:
    """Output pins through the plates; spacers on bolts end at the plate that holds them."""
    pin, path = design.pin, "pin.material" if design.pin else "contact.pin_material"
    return _on_pins(
        design,
        count=design.pin_count,
        density=_density(pin.material if pin else design.contact.pin_material, path),
        outer=design.pin_diameter,
        inner=pin.bore_diameter if pin else 0.0,
        length=far_end(design) + (0.0 if design.bolted else design.carrier_width),
    )


def _bolts(design: Design) -> Solid:
    """Cores of the bolts through the pins, without their heads."""
    bolt = design.pin.bolt
    assert bolt
    return _on_pins(
        design,
        count=design.pin_count,
        density=_density(bolt.material or design.pin.material, "pin.bolt.bolt_material"),
        outer=bolt.core_diameter,
        length=far_end(design) + design.carrier_width,
    )


def _sleeves(design: Design) -> Solid:
    """Sleeves on the pins, one in each hole."""
    return _on_pins(
        design,
        count=design.pairs,
        density=_density(design.contact.pin_material, "contact.pin_material"),
        outer=2 * design.nominal_pair.pin_radius,
        inner=design.pin_diameter,
        length=design.pin_length,
        estimate=False,
    )


def _catalogued(bearing: CatalogueBearing | Any, path: str) -> float:
    """Mass of a bearing by its name, kg."""
    known = named_bearing(required(bearing.name, "bearing_unnamed", f"{path}.name"))
    return required(known, "bearing_unnamed", f"{path}.name").mass


def _pin_bearings(design: Design) -> Solid:
    """Bearings on the pins."""
    count = design.pairs * design.rollers.per_satellite
    whole = count * _catalogued(design.rollers, "rollers")
    moment = whole * design.pin_circle_radius**2
    return Solid(count, whole, moment, "carrier", estimate=False)


def _bearing(bearing: CatalogueBearing, path: str, count: int = 1, **more: Any) -> Solid:
    """Bearings of the crank, of which half of the mass inside turns with it."""
    whole = count * _catalogued(bearing, path)
    bore = required(bearing.bore_diameter, "size_missing", f"{path}.bore_diameter")
    outer = required(bearing.outer_diameter, "size_missing", f"{path}.outer_diameter")
    moment = whole / 2 * (bore**2 + ((bore + outer) / 2) ** 2) / 8
    return Solid(count, whole, moment, "crank", estimate=False, **more)


def _satellite_bearings(design: Design) -> Solid:
    """Bearings of the discs on their cranks."""
    count = design.mechanism.satellites
    _ = design.bearing.kind  # raises `NotKnown` without a bearing
    return _bearing(design.bearing, "bearing", count, on_circle=True)


def _crank_bearing(design: Design, end: int) -> Solid:
    """Bearing of the crankshaft."""
    bearings = design.crankshaft.bearings
    if not bearings:
        raise NotKnown("bearing_unnamed", "crankshaft.bearings")
    return _bearing(bearings[end], f"crankshaft.bearings[{end}]")


def _ring_pins(design: Design) -> Solid:
    """Ring pins with their sleeves, as long as the housing is wide."""
    return _on_ring(
        design,
        count=_held(design),
        density=_density(design.cycloid.pin_material, "gear.pin_material"),
        length=design.housing_width,
        turns="ring",
    )


def _on_ring(design: Design, **sizes: Any) -> Solid:
    """Cylinders in the places of the ring pins."""
    ring = design.cycloid
    return _round(outer=2 * ring.known_pin_radius, circle=ring.ring_pin_circle_radius, **sizes)


def _held(design: Design) -> int:
    """Number of pins in the ring."""
    return design.ring_pins // (2 if design.cycloid.every_second_pin else 1)


def _housing(design: Design) -> Solid:
    """Ring of the housing, to the circle of ring pins less the half of each in its seat, to the
    outside of ring pins without seats, or to the middle of the teeth.
    """
    gear, outer, inner = design.gear, design.housing_diameter, 2 * design.ring_reach
    sizes: Any = {"length": design.housing_width, "turns": "ring"}
    if isinstance(gear, InvoluteRing):
        own = gear.ring_material
        sizes["density"] = _density(own, "gear.ring_material") if own else _of_discs(design)
        return _round(outer=outer, inner=inner - 2 * DEDENDUM * gear.module, **sizes)
    sizes["density"] = _of_discs(design)
    if not isinstance(gear, CycloidRing) or gear.pin_support != "seat":
        return _round(outer=outer, inner=inner, **sizes)
    ring = _round(outer=outer, inner=2 * gear.ring_pin_circle_radius, **sizes)
    return _less(ring, _on_ring(design, count=_held(design) / 2, **sizes))


def plate_holes(*, design: Design, end: int) -> tuple[float, float]:
    """Diameters in a plate of the carrier, m: of the seat of the crankshaft's bearing, 0 if there
    is none, and of the holes for pins or their bolts.
    """
    bearings = design.crankshaft.bearings if design.crankshaft else ()
    seat = (bearings[end].outer_diameter if bearings else None) or 0.0
    bolt = design.pin.bolt if design.bolted and not end else None
    return seat, bolt.core_diameter if bolt else design.pin_diameter


def _plate(design: Design, end: int) -> Solid:
    """Plate of the carrier, with the holes of the pins and that of the crankshaft's bearing."""
    width = design.second_carrier_width if end else design.carrier_width
    sizes: Any = {"density": _of_discs(design), "length": width}
    bore, hole = plate_holes(design=design, end=end)
    plate = _round(outer=design.carrier_diameter, inner=bore, **sizes)
    return _less(plate, _on_pins(design, count=design.pin_count, outer=hole, **sizes))


class ShaftSizes(NamedTuple):
    """Sizes of a crankshaft with its eccentrics; places are its own, along its axis."""

    thick: float  # diameter of an eccentric, m
    thin: float  # diameter beside the eccentrics, m
    long: float  # length of an eccentric, m
    low: float  # place of its first end, m
    high: float  # place of its last end, m


def shaft_sizes(design: Design) -> ShaftSizes:
    """Sizes of the crankshaft, from the outside of one bearing to that of the other."""
    shaft, own, places = design.crankshaft, design.bearing or None, design.crankshaft.places
    thick = shaft.eccentric_diameter or (own and own.bore_diameter)
    thick = required(thick, "size_missing", "crankshaft.eccentric_diameter")
    bores = [each.bore_diameter or 0.0 for each in shaft.bearings]
    thin = shaft.shaft_diameter or max(bores, default=0.0) or None
    thin = required(thin, "size_missing", "crankshaft.shaft_diameter")
    long = (own and own.width) or design.pin_length
    on_shaft, held = places["satellite_positions"], places["bearing_positions"]
    first, last = [(each.width or 0.0) / 2 for each in shaft.bearings] or (0.0, 0.0)
    low = min(held[0] - first, min(on_shaft) - long / 2)
    high = max(held[1] + last, max(on_shaft) + long / 2)
    return ShaftSizes(thick, thin, long, low, high)


def _shaft(design: Design) -> Solid:
    """Crankshaft with its eccentrics."""
    count, (thick, thin, long, low, high) = design.mechanism.satellites, shaft_sizes(design)
    weight: Any = {"density": _density(MATERIALS[SHAFT].material, SHAFT), "turns": "crank"}
    between = _round(outer=thin, length=max(high - low - count * long, 0.0), **weight)
    circle = design.known_eccentricity
    eccentrics = _round(count=count, outer=thick, length=long, circle=circle, **weight)
    whole, moment = between.mass + eccentrics.mass, between.moment + eccentrics.moment
    error = CLOSED * max(abs(low), abs(high), high - low) / (high - low)
    return Solid(1, whole, moment, "crank", error=error)


def _counterweights(design: Design) -> Solid:
    """Counterweights, of which only mass times distance is stated."""
    raise NotKnown("counterweight_unknown", "crankshaft.counterweights")


PARTS: dict[MassPart, Callable[[Design], Solid]] = {
    "discs": _discs,
    "pins": _pins,
    "bolts": _bolts,
    "sleeves": _sleeves,
    "pin_bearings": _pin_bearings,
    "ring_pins": _ring_pins,
    "shaft": _shaft,
    "counterweights": _counterweights,
    "satellite_bearings": _satellite_bearings,
    "bearing_a": lambda design: _crank_bearing(design, 0),
    "bearing_b": lambda design: _crank_bearing(design, 1),
    "housing": _housing,
    "carrier": lambda design: _plate(design, 0),
    "second_carrier": lambda design: _plate(design, 1),
}
"""Solids of the parts, in their order."""
