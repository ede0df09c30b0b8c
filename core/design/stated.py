"""Design of what a document states: values in SI by section, nested as its JSON is. A value that is
not stated follows from others, from a name in a table, or is the usual one.
"""

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import fields
from functools import cache, partial
from typing import Any

from core.arrays import check_count
from core.bearings import BEARINGS, named_bearing, names_like
from core.design.contact import Contact
from core.design.document import KINDS, Design
from core.design.layout import PLACED
from core.design.ring import CycloidRing, InvoluteRing
from core.design.sections import MAX_PAIRS, USUAL_SATELLITES, MechanismSection, Rollers
from core.errors import InvalidInput, NotKnown, required, within
from core.fields import Variants
from core.hertz import ElasticMaterial
from core.material_table import MATERIALS
from core.materials import in_bending
from core.output.contact_force import output_torque_from_input
from core.output.elasticity import HertzLaw, RingInSeries, usual_law
from core.output.mechanism import Members, ratio_from_teeth
from core.output.pin_bolt import PinBolt, bolt_preload
from core.output.room import OF_RING_PINS

Values = Mapping[str, Any]
"""Values of a section, by the names of its fields and of those from which they follow; a material
may be a name in the table."""

RING_PIN_MATERIAL, RING_MATERIAL = "steel_bearing", "steel_structural"
"""Materials of ring pins, and of a ring with involute teeth, if none are stated."""

USUAL_MATERIALS: dict[Any, dict[str, str]] = {
    Contact: {"pin_material": "steel_bearing", "hole_material": "steel_through_hardened"},
    CycloidRing: {"pin_material": RING_PIN_MATERIAL},
    InvoluteRing: {"ring_material": RING_MATERIAL},
    PinBolt: {"bolt_material": "steel_bolt"},
}
"""Names of materials that are taken if none are stated."""

NO_COUPLING = ("crank_support", "satellite_coupling", "gear", "bearing", "crankshaft")
"""Sections that a coupling of two shafts does not have."""

OF_BOTH = "ring_speed", "carrier_speed"
"""Speeds of which one is given if ring and pins are both outputs."""

PROFILE_SHIFTS = {"satellite_profile_shift", "ring_profile_shift"}
"""Fields of involute teeth whose form is given."""

OF_SUPPORTS = ("span", "satellite_positions")
"""Fields of ring pins that bend."""

TOUCHING = ("pin_radius", "contact_length")
"""Sizes of pins that touch their holes."""


def material(stated: str | ElasticMaterial) -> ElasticMaterial:
    """Material that is named or given."""
    return MATERIALS[stated].material if isinstance(stated, str) else stated


@cache
def fills(kind: Any) -> bool:
    """True if a kind of section has values that are taken where they are not stated."""
    return "name" in _names(kind) or kind in USUAL_MATERIALS


def filled(*, kind: Any, stated: Values) -> dict[str, Any]:
    """Values that are taken for those that are not stated: of a bearing's name, and materials."""
    usual: dict[str, Any] = {}
    if stated.get("name") is not None:
        usual = _catalogued(kind, stated["name"])
    if kind is not InvoluteRing or stated.keys() >= PROFILE_SHIFTS:
        usual |= USUAL_MATERIALS.get(kind, {})
    return {name: each for name, each in usual.items() if stated.get(name) is None}


def _catalogued(kind: Any, name: str) -> dict[str, Any]:
    """Values of a bearing of the table that its section has."""
    bearing = named_bearing(name)
    if bearing is None:
        near = ", ".join(names_like(name) or BEARINGS)
        raise InvalidInput("name", name, "no_such_bearing", near=near)
    sizes = ("bore_diameter", "outer_diameter", "width", "dynamic_rating", "static_rating")
    found = {size: getattr(bearing, size) for size in sizes if size in _names(kind)}
    if kind is not Rollers:
        return found | {"kind": bearing.kind}
    if bearing.series == "HK":  # a drawn cup has the diameter of a housing that holds it
        del found["outer_diameter"]
    return found | {"kind": bearing.elements}


@cache
def _names(kind: Any) -> frozenset[str]:
    return frozenset(each.name for each in fields(kind))


def section(*, kind: Any, stated: Values) -> Any:
    """Section of a kind from what is stated of it; values that it does not have are left out."""
    own = {**stated, **filled(kind=kind, stated=stated)}
    names, made = _names(kind), kind
    if kind is Contact:
        names, made = names | {"hole_clearance", "fit"}, Contact.sized
    elif kind in FOLLOWING:
        own |= FOLLOWING[kind](own)
    return made(
        **{
            name: material(each) if name.endswith("material") else each
            for name, each in own.items()
            if name in names
        }
    )


def satellites_of(mechanism: Values) -> int:
    """Number of satellites of a mechanism, by its cranks if it is not stated."""
    if mechanism.get("output") == "coupling":
        return 1
    angles = mechanism.get("crank_angles", ())
    return mechanism.get("satellites") or len(angles) or USUAL_SATELLITES


def _mechanism(own: Values) -> dict[str, Any]:
    """Ratio u and number of satellites of a mechanism."""
    output, pins = own.get("output", "pins"), own.get("pins")
    if output == "crankshafts":
        raise InvalidInput("output", output, "not_this_mechanism")
    ratio, count = _ratio(own), own.get("satellites")
    angles = own.get("crank_angles") or ()
    if angles and count is not None:
        check_count(count, crank_angles=angles)
    if output == "coupling" and (count or 1) > 1:
        raise InvalidInput("satellites", count, "one_of_coupling", limit=1)
    satellites = satellites_of(own)
    if (pins or 0) * satellites > MAX_PAIRS:
        most = {"limit": MAX_PAIRS // satellites, "satellites": satellites}
        raise InvalidInput("pins", pins, "too_many_pairs", **most)
    return {"ratio": ratio, "satellites": satellites}


def _ratio(own: Values) -> float:
    """Ratio u, stated directly, by the ring, or by teeth; infinite for a coupling."""
    match own:
        case {"ratio": 0}:
            raise InvalidInput("ratio", 0, "not_zero")
        case {"ratio": ratio} if abs(ratio) < 1:
            raise InvalidInput("ratio", ratio, "ratio_below_one", limit=1, offered=1 / ratio)
        case {"ratio": ratio, "output": "ring"} if ratio < 0:
            raise InvalidInput("ratio", ratio, "sign_of_ring", offered=-ratio)
        case {"ratio": ratio}:
            return float(abs(ratio))
        case {"output_ratio": ratio}:
            return float(ratio - 1)
        case {"satellite_teeth": lobes, "ring_teeth": teeth} if teeth > 2 * lobes:
            more = {"limit": 2 * lobes, "field": "satellite_teeth"}
            raise InvalidInput("ring_teeth", teeth, "ratio_of_teeth", **more)
        case {"satellite_teeth": lobes, "ring_teeth": teeth}:
            return ratio_from_teeth(satellite_teeth=lobes, ring_teeth=teeth)
        case {"output": "coupling"}:
            return math.inf
    raise InvalidInput("ratio", None, "needed", field="satellite_teeth")


def teeth_difference(mechanism: Values) -> int | None:
    """Teeth of the ring less those of a satellite; None unless both are stated."""
    match mechanism:
        case {"satellite_teeth": satellite, "ring_teeth": ring}:
            return int(ring - satellite)
    return None


def _bolt(own: Values) -> dict[str, Any]:
    """Material of a bolt, and its preload by the tightening torque."""
    found = in_bending(material(own["bolt_material"]))
    if torque := own.get("tightening_torque"):
        core = own["core_diameter"]
        found["preload"] = bolt_preload(tightening_torque=torque, core_diameter=core)
    return found


def _ring_pins(own: Values) -> dict[str, Any]:
    """Strength of ring pins."""
    held = in_bending(material(own["pin_material"]))
    return {"pin_material": held.pop("material")} | {f"pin_{name}": held[name] for name in held}


FOLLOWING: dict[Any, Callable[[Values], dict[str, Any]]] = {
    MechanismSection: _mechanism,
    PinBolt: _bolt,
    CycloidRing: _ring_pins,
}
"""Functions of the values that follow from others of a section."""


def output_torque(*, load: Values, members: Members) -> float | None:
    """Torque of the output, N*m, as stated or by that of the crankshaft; None if neither is."""
    if "input_torque" not in load:
        return load.get("output_torque")
    return output_torque_from_input(
        input_torque=load["input_torque"],
        ratio=members.torque_ratio,
        efficiency=load["efficiency"],
    )


def _pin(pin: Values, made: Mapping[str, Any]) -> dict[str, Any]:
    """Pin with diameter and material of what surrounds it, the rollers first."""
    rollers, contact = made.get("rollers"), made.get("contact")
    diameter, chosen = pin.get("diameter"), pin.get("material")
    if rollers:
        diameter = diameter or rollers.bore_diameter
    if contact:
        diameter = diameter or (contact.pin_radius and 2 * contact.pin_radius)
        chosen = chosen or contact.pin_material
    diameter = required(diameter, "size_missing", "pin.diameter")
    held = in_bending(material(required(chosen, "size_missing", "pin.material")))
    usual = {"support": "cantilever", "satellite_positions": ()}
    return {**usual, **pin, **held, "diameter": diameter}


def _law(contact: Contact | None) -> Any:
    """Contact law by the materials; any law without a contact, which is refused later."""
    if contact is None:
        return HertzLaw()
    pin, hole = contact.pin_material, contact.hole_material
    assert pin and hole  # usual ones if none are stated
    return usual_law(pin=pin, hole=hole)


def _follows(stated: Mapping[str, Values]) -> tuple[str, ...]:
    """Paths of the places that follow from `build`, as they are not stated."""
    places = [(path, *path.split(".")) for path in PLACED]
    found = [path for path, name, field in places if name in stated and field not in stated[name]]
    ends = stated.get("pin", {}).get("support", "cantilever") != "cantilever"
    return tuple(path for path in found if ends or path != "pin.span")


def _of_design(name: str, stated: Mapping[str, Values], made: Mapping[str, Any]) -> Any:
    """Section of the design, with what follows from other sections, of which some are made."""
    own, kind = {**stated[name]}, KINDS[name]
    if name == "contact_law" and not own:
        return _law(made.get("contact"))
    if name == "load":
        mechanism = made["mechanism"]
        own["output_torque"] = output_torque(
            load=own, members=Members(mechanism.output, mechanism.ratio)
        )
    if name == "pin":
        own = _pin(own, made)
    if name == "build":
        own["follows"] = _follows(stated)
    difference = teeth_difference(stated["mechanism"])
    if name == "gear" and difference is not None:
        own["teeth_difference"] = difference
    if isinstance(kind, Variants):
        kind = kind[own.get("kind", kind.default)]
    return within(name, partial(section, kind=kind, stated=own))


def design_of(
    stated: Mapping[str, Values], *, used: Collection[str] = (*KINDS,), pin_alone: bool = False
) -> Design:
    """Design of the used sections of a document. Other sections are checked by themselves, and
    supply what follows from them: pins take diameter and material of rollers and contact, teeth
    their difference of the mechanism, and both meshes are in series if the sharing between
    satellites is not stated.

    Parameters
    ----------
    stated : mapping
        Values of each stated section.
    used : collection of str
        Names of sections that the design has.
    pin_alone : bool
        True if the design has its pin also without a contact that loads it.
    """
    _refuse_contradictions(stated)
    if not pin_alone and not ("contact" in stated and "contact" in used):
        used = {*used} - {"pin"}
    made: dict[str, Any] = {}
    given = [each for each in KINDS if each in stated]
    for name in sorted(given, key="pin".__eq__):  # pins last, as they take values of rollers
        try:
            made[name] = _of_design(name, stated, made)
        except NotKnown:
            if name in used:
                raise
    sections = {name: each for name, each in made.items() if name in used}
    if "gear" in sections and "satellite_coupling" in used:
        sections.setdefault("satellite_coupling", RingInSeries())
    return Design(**sections)


def _refuse_contradictions(stated: Mapping[str, Values]) -> None:
    """Raise InvalidInput if sections contradict each other, or one lacks a value of another."""
    nothing: Values = {}
    contact, friction = stated.get("contact", nothing), stated.get("friction", nothing)
    if "rollers" in stated and "pin_radius" not in contact:
        raise InvalidInput("contact.pin_radius", None, "needed_beside", field="rollers")
    if friction and "friction_coefficient" in stated.get("rollers", nothing):
        more = {"field": "friction_coefficient"}
        raise InvalidInput("friction.coefficient", None, "only_one", **more)
    for hole in ("hole_radius", "hole_clearance", "fit"):
        for size in TOUCHING if hole in contact else ():
            if size not in contact:
                raise InvalidInput(f"contact.{size}", None, "needed_beside", field=hole)
    if friction.get("sleeve") and "pin" not in stated:
        raise InvalidInput("pin", None, "needed_beside", field="sleeve")
    second = stated.get("build", nothing).get("second_carrier_width")
    pin = stated.get("pin")
    if second and pin is not None and pin.get("support", "cantilever") == "cantilever":
        more = {"kind": "cantilever"}
        raise InvalidInput("build.second_carrier_width", second, "of_another_kind", **more)
    _refuse_members(stated)
    _refuse_ring(stated)


def _refuse_members(stated: Mapping[str, Values]) -> None:
    """Refuse sections and speeds that the output does not have."""
    output, load = stated["mechanism"].get("output", "pins"), stated.get("load", {})
    if output == "coupling":
        for name in NO_COUPLING:
            if name in stated:
                raise InvalidInput(name, None, "of_other_output", output=output)
    given = [name for name in OF_BOTH if name in load]
    driven, both = "input_speed" in load, output == "both"
    if given and not both:
        raise InvalidInput(f"load.{given[0]}", None, "of_other_output", output=output)
    if given and not driven:
        raise InvalidInput("load.input_speed", None, "needed_beside", field=given[0])
    if both and driven and not given:
        raise InvalidInput(f"load.{OF_BOTH[0]}", None, "needed_beside", field="input_speed")


def _refuse_ring(stated: Mapping[str, Values]) -> None:
    """Refuse a ring that contradicts mechanism or discs, and what needs a ring with pins."""
    gear, contact = stated.get("gear", {}), stated.get("contact", {})
    kind, difference = gear.get("kind"), teeth_difference(stated["mechanism"])
    if kind == "involute":
        given, name = gear.get("teeth_difference"), "gear.teeth_difference"
        if difference is None and given is None:
            raise InvalidInput(name, None, "needed_beside", field="ratio")
        # a ring without more teeth than its satellites is refused by itself
        if given and difference and difference > 0 and given != difference:
            raise InvalidInput(name, given, "teeth_disagree", expected=difference)
    if "pin_radius" in contact or "hole_material" in contact:
        of_holes = material((filled(kind=Contact, stated=contact) | {**contact})["hole_material"])
        for name in ("disc_material", "satellite_material"):
            if name in gear and material(gear[name]) != of_holes:
                more = {"field": "hole_material"}
                raise InvalidInput(f"gear.{name}", None, "discs_disagree", **more)
    seats = gear.get("pin_support", "seat") == "seat"
    for name in OF_SUPPORTS:
        if seats and name in gear:
            raise InvalidInput(f"gear.{name}", gear[name], "of_another_kind", kind="seat")
        if not seats and name not in gear:
            raise InvalidInput(f"gear.{name}", None, "needed_beside", field="pin_support")
    listed = [name for name in OF_RING_PINS if name in stated.get("deviations", {})]
    if listed and kind != "cycloid":
        raise InvalidInput("gear", None, "needed_beside", field=listed[0])
    if stated.get("satellite_coupling", {}).get("kind") == "ring":
        if not gear:
            raise InvalidInput("gear", None, "needed_beside", field="satellite_coupling")
        if kind != "cycloid":
            raise InvalidInput("gear.kind", kind, "outside_method")
        if contact.get("distribution_factor", 1) > 1:
            raise InvalidInput("contact.distribution_factor", None, "with_real_forces")
