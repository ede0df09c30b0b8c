"""Checks of bending pins of output and ring: static strength, fatigue, deflection, slope, wall
about the bore, and bolts that hold pins.

Each sort of check is written once, as common fields of its records and a method of `BentPins`; a
row for each place has the codes.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from core.checks import inputs as of
from core.checks.check import (
    Check,
    Element,
    Kind,
    Measure,
    asked_of,
    judged_by,
    over_range,
)
from core.checks.inputs import Paths, paths
from core.checks.teeth import not_cycloid
from core.design.document import Design
from core.design.results import Results
from core.design.sections import DesignPin
from core.output.pin_bolt import SLIP_SAFETY
from core.output.pin_strength import PinStrength
from core.output.tied_pin import section_of

HARDENED = 1400e6
"""Tensile strength above which a steel hardly yields before it breaks, Pa."""


_SORTS: dict[str, dict[str, Any]] = {
    "static": {
        "title": "Static strength of {pins}",
        "unit": "MPa",
        "formula": "σ_v ≤ R_e/S_F",
        "why": "Above it {pins} bend for good.",
        "source": "pin_beam",
    },
    "fatigue": {
        "title": "Fatigue of {pins}",
        "formula": "n ≥ S_D",
        "why": "Below it {pins} break after some time where they bend most.",
        "source": "shigley",
        "keep": "above",
    },
    "deflection": {
        "title": "Deflection of {pins}",
        "unit": "mm",
        "formula": "w ≤ Δ_max",
        "why": "Above it the satellites share the load unevenly.",
        "source": "beam",
        "asks": "max_deflection",
    },
    "slope": {
        "title": "Slope of {pins} in the satellites",
        "unit": "mrad",
        "formula": "θ ≤ θ_max",
        "why": "Above it the {contacts} carry on their edges.",
        "source": "beam",
        "asks": "max_slope",
    },
}


def _of_size(pin: DesignPin, check: Check) -> Check:
    """Check by the strengths of a material, which are lower but unknown for thicker pins."""
    if not pin.thick:
        return check
    (thick,) = pin.thick
    if check.status == "fail":
        return check._replace(torque_reserve=None)
    return check._replace(
        status="not_checked",
        torque_reserve=None,
        reason=thick.code,
        params=thick.params,
        missing=(pin.material_path,),
    )


def _of_plastic(pin: DesignPin, by: Callable[[float], Check]) -> Check:
    """Check of a plastic pin by its strength across the layers, the lowest one."""
    material, path = pin.material, pin.material_path
    strengths = {name: each for name, each in material.usual(path).items() if "strength" in name}
    return over_range(
        least=lambda: by(material.known_strength("pin", path)),
        most=lambda: by(material.most_strength),
        values=strengths,
    )


@dataclass(frozen=True, slots=True)
class BentPins:
    """Bending pins of the output or of the ring, as they are judged."""

    found: PinStrength  # stresses and deflections
    pin: DesignPin  # one of the pins
    at: Callable[[float], Mapping[str, Any]]  # place of a section at a position along the pin, m
    solved: bool  # True if forces are not proportional to the torque

    @property
    def error(self) -> float:
        """Relative error of stresses, deflection and slope."""
        return 4 * float(self.found.accuracy.relative_error)

    def judged(self, kind: Kind, value: float, limit: float, **more: Any) -> Check:
        """Check of a stress or safety, whose reserve is the reserve of the torque."""
        reserve = limit / value if kind.keep == "below" else value / limit
        return kind.judged(
            value, limit, reserve=reserve, error=self.error, solved=self.solved, **more
        )

    def static(self, kind: Kind, safety: float) -> Check:
        """Check of static strength with a required safety at the largest moment; only necessary for
        a plastic pin, whose strength counts across its layers unless stated otherwise.
        """
        at = self.at(self.found.peak_moment_position)
        stress, pin, material = self.found.static_stress, self.pin, self.pin.material
        if material.plastic:
            return _of_plastic(
                pin, lambda strength: self.judged(kind, stress, strength / safety, at=at)
            )
        strength, tensile = material.yield_strength, pin.tensile_strength
        if strength is None and tensile is not None and tensile > HARDENED:
            strength = tensile
        lacks = ("yield_unknown", f"{pin.material_path}.yield_strength")
        limit = judged_by(strength, *lacks, value=stress) / safety
        return _of_size(pin, self.judged(kind, stress, limit, at=at))

    def fatigue(self, kind: Kind, safety: float) -> Check:
        """Check of fatigue with a required safety, at the section of least safety."""
        cycle = self.found.fatigue
        check = self.judged(kind, cycle.safety_factor, safety, at=self.at(cycle.position))
        short = cycle.short and not check.reason
        return _of_size(self.pin, check._replace(reason="finite_life") if short else check)

    def bent(self, name: str, at: str) -> Measure:
        """Largest deflection or slope in a satellite; `at` names the attribute of its place."""
        deflection = self.found.deflection
        return Measure(
            float(getattr(deflection, name)),
            error=self.error,
            at={"satellite": getattr(deflection, at)},
            reserve=lambda growth: growth,
            solved=self.solved,
        )


def _section(design: Design, position: float) -> dict[str, Any]:
    """End section of a pin with a tie ring at a position, m; empty elsewhere."""
    if not design.tied:
        return {}
    end = section_of(position=position, span=design.pin.known_span)
    return {"section": end} if end else {}


def _output(results: Results) -> BentPins:
    """Output pins, or the bolts through them."""
    at = partial(_section, results.design)
    return BentPins(results.pin_strength, results.bent_pin, at, solved=results.solved)


def _ring(results: Results) -> BentPins:
    """Ring pins, whose forces are solved."""
    found = results.ring.pin_strength
    return BentPins(found, results.ring.pin, lambda _: {"pin": found.pin}, True)


def _tired_output(results: Results) -> BentPins:
    """Output pins with their fatigue; raises if it is not known."""
    pins, _ = _output(results), results.fatigue_strength
    return pins


def _tired_ring(results: Results) -> BentPins:
    """Ring pins with their fatigue; raises if it is not known."""
    _, pins = results.ring.pin_fatigue_strength, _ring(results)
    return pins


def _not_bent(design: Design, results: Results) -> str:
    """Code of the reason why a check of bending ring pins does not apply; empty if it does."""
    if other := not_cycloid(design, results):
        return other
    return "pins_in_seats" if design.cycloid.pin_support == "seat" else ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Place:
    """Row of a place of bending pins."""

    row: Element
    of: Callable[[Results], BentPins]  # pins without fatigue
    tired: Callable[[Results], BentPins]  # pins with fatigue
    loaded: Paths  # inputs of their forces
    turns: str  # input that is true if they turn
    thicker: tuple[str, ...]  # inputs that a fix may change
    at_peak: str = ""  # further inputs of the static strength


_OUTPUT = _Place(
    row=Element(
        "pin",
        "pins",
        "touching load pin",
        codes=(
            "static=pin_static fatigue=pin_fatigue deflection=pin_deflection slope=pin_slope",
            "wall=pin_wall",
        ),
        sorts=_SORTS,
        words={"pins": "the pins", "contacts": "contacts"},
    ),
    of=_output,
    tired=_tired_output,
    loaded=of.LOADED,
    turns="pin.rotates",
    thicker=paths(
        "pin.diameter contact.pin_radius load.pin_circle_radius mechanism.pins load.output_torque"
    ),
    at_peak="load.peak_torque",
)
_RING = _Place(
    row=Element(
        "gear",
        "teeth",
        "load contact gear",
        codes="static=ring_pin_stress fatigue=ring_pin_fatigue slope=ring_pin_slope",
        sorts=_SORTS,
        words={"pins": "the pins of the ring", "contacts": "teeth"},
        not_of=_not_bent,
    ),
    of=_ring,
    tired=_tired_ring,
    loaded=of.RING_LOADED,
    turns="gear.rotates",
    thicker=paths("gear.ring_pin_radius gear.sleeve_bore_radius gear.span load.output_torque"),
)

ROWS = (_OUTPUT.row, _RING.row)


def _static(place: _Place) -> Kind:
    @place.row.check(
        "static",
        inputs=(place.loaded, "load.peak_torque requirements.bending_safety"),
        fixes=(place.thicker, place.at_peak),
    )
    def static(kind: Kind, design: Design, results: Results) -> Check:
        return place.of(results).static(kind, design.requirements.bending_safety)

    return static


def _fatigue(place: _Place) -> Kind:
    @place.row.check(
        "fatigue",
        inputs=(place.loaded, place.turns, of.FATIGUE, of.LIFE, "requirements.fatigue_safety"),
        fixes=place.thicker,
    )
    def fatigue(kind: Kind, design: Design, results: Results) -> Check:
        return place.tired(results).fatigue(kind, design.requirements.fatigue_safety)

    return fatigue


def _bent(place: _Place, sort: str, *names: str) -> Kind:
    """Check of deflection or slope; a requested limit is judged with the least known moduli."""
    asks = _SORTS[sort]["asks"]

    @place.row.check(
        sort,
        inputs=(place.loaded, f"requirements.{asks}"),
        fixes=tuple(each for each in place.thicker if each != "gear.span"),
    )
    def bent(kind: Kind, design: Design, results: Results) -> Measure:
        made = results.softest if asked_of(design, asks) else results
        return place.of(made).bent(*names)

    return bent


@_OUTPUT.row.check(
    "wall",
    title="Wall about the bore of the pins",
    unit="MPa",
    formula="σ_w(T_max) ≤ R_e/S_F",
    why="Above it the pin is squeezed flat under the satellite.",
    inputs=(of.LOADED, "load.peak_torque requirements.bending_safety"),
    fixes=("pin.bore_diameter", _OUTPUT.thicker, _OUTPUT.at_peak),
    source="pin_wall",
)
def pin_wall(kind: Kind, design: Design, results: Results) -> Check:
    pin = design.pin
    if not pin.section.walled:
        return Check(kind, "not_applicable", reason="solid_pin")
    stress = results.wall_stress
    error = 4 * results.pin_loads.accuracy.relative_error

    def by(strength: float) -> Check:
        limit = strength / design.requirements.bending_safety
        return kind.judged(
            stress, limit, reserve=limit / stress, error=error, solved=results.solved
        )

    if pin.material.plastic:
        return _of_plastic(pin, by)
    yields, unknown = pin.material.yield_strength, "pin.material.yield_strength"
    strength = judged_by(yields, "yield_unknown", unknown, value=stress)
    return _of_size(pin, by(strength))


_bolt_check = Element(
    "pin",
    "pins",
    "touching load pin bolted",
    inputs=(of.LOADED, "load.peak_torque"),
    source="beam",
    needed=False,
)


def _gripped(
    kind: Kind, results: Results, value: float, most: float | None, safety: float = 1.0
) -> Check:
    """Check of a load of the root against the preload; beyond it the bolt is judged alone."""
    said = {"value": value, "status": "not_applicable"}
    limit = judged_by(most, "bolt_alone", **said) / safety
    return kind.judged(
        value, limit, reserve=limit / value, warning="bolt_alone", solved=results.solved
    )


@_bolt_check(
    "bolt_opens",
    title="Spacers of bolted pins stay closed",
    unit="Nm",
    formula="M ≤ F_min·(d² + d_i²)/(8·d)",
    why="Beyond it the spacer gapes at the carrier, and the bolt bends alone.",
)
def bolt_opens(kind: Kind, design: Design, results: Results) -> Check:
    found = results.grip
    return _gripped(kind, results, found.moment, found.opening_moment)


@_bolt_check(
    "bolt_slips",
    title="Spacers of bolted pins do not slip",
    unit="N",
    formula="V ≤ μ·F_min/1.2",
    why="Beyond it the spacer slips on the carrier, and the bolt bends alone.",
)
def bolt_slips(kind: Kind, design: Design, results: Results) -> Check:
    found = results.grip
    return _gripped(kind, results, found.shear_force, found.slip_force, SLIP_SAFETY)


BENDING = (
    _static(_OUTPUT),
    _bent(_OUTPUT, "deflection", "deflection", "satellite"),
    _bent(_OUTPUT, "slope", "slope", "slope_satellite"),
    _fatigue(_OUTPUT),
)
HOLLOW = (pin_wall, bolt_opens, bolt_slips)
RING_BENDING = (
    _static(_RING),
    _fatigue(_RING),
    _bent(_RING, "slope", "slope", "slope_satellite"),
)
