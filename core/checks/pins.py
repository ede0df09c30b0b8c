"""Checks of the pins as beams: static strength, fatigue, deflection, slope."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from core.checks.check import (
    Check,
    Kind,
    Measure,
    asked_of,
    design_check,
    judged,
    judged_by,
    over_range,
    wall,
)
from core.checks.inputs import FATIGUE, LIFE, LOADED
from core.design.document import Design
from core.design.results import Results
from core.design.sections import DesignPin
from core.output.pin_bolt import SLIP_SAFETY
from core.output.pin_fatigue import PinFatigue
from core.output.pin_strength import PinStrength
from core.output.tied_pin import section_of

HARDENED = 1400e6
"""Tensile strength above which a steel hardly yields before it breaks, Pa."""

_FIXES = (
    "pin.diameter",
    "contact.pin_radius",
    "load.pin_circle_radius",
    "mechanism.pins",
    "load.output_torque",
)
_check = partial(
    design_check, group="pin", part="pins", fixes=_FIXES, needs=("touching", "load", "pin")
)


def _of_size(pin: DesignPin, check: Check) -> Check:
    """A check by the strengths of the material: of thicker pins these are less than known, so that
    only what fails is certain, but not by how much.
    """
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
    """A check of a plastic pin, by a strength: across its layers, which is no more than in them."""
    material, path = pin.material, pin.material_path
    strengths = {name: each for name, each in material.usual(path).items() if "strength" in name}
    return over_range(
        least=lambda: by(material.known_strength("pin", path)),
        most=lambda: by(material.most_strength),
        values=strengths,
    )


@dataclass(frozen=True, slots=True)
class BentPins:
    """Pins that bend, of the output or of the ring, as they are judged."""

    found: PinStrength  # what they bear
    pin: DesignPin  # one of them
    solved: bool  # whether their forces do not grow with the torque
    model_error: float = 0.0  # relative, of these forces, besides that of the numbers

    @property
    def error(self) -> float:
        """Relative error of stresses, deflection and slope."""
        return 4 * float(self.found.accuracy.relative_error) + self.model_error

    def judged(self, kind: Kind, value: float, limit: float, **more: Any) -> Check:
        """A stress or a safety against its limit: the torque has the reserve that it has."""
        reserve = limit / value if kind.keep == "below" else value / limit
        return judged(
            kind, value, limit, reserve=reserve, error=self.error, solved=self.solved, **more
        )

    def static(self, kind: Kind, *, safety: float, at: Mapping[str, Any]) -> Check:
        """Static strength, with a safety that is required, where they bear most; of a plastic pin
        across its layers, unless they are said to lie otherwise: necessary only.
        """
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

    @property
    def cycle(self) -> PinFatigue:
        """The cycle of their fatigue, whose strength is known."""
        return self.found.fatigue

    def fatigue(self, kind: Kind, *, safety: float, at: Mapping[str, Any]) -> Check:
        """Fatigue, of which there is a cycle, with a safety that is required, where it is least."""
        cycle = self.cycle
        check = self.judged(kind, cycle.safety_factor, safety, at=at)
        short = cycle.short and not check.reason
        return _of_size(self.pin, check._replace(reason="finite_life") if short else check)

    def bent(self, name: str, at: str) -> Measure:
        """The largest deflection or slope in a satellite, by the names of these and of where that
        is.
        """
        deflection = self.found.deflection
        return Measure(
            float(getattr(deflection, name)),
            error=self.error,
            at={"satellite": getattr(deflection, at)},
            reserve=lambda growth: growth,
            solved=self.solved,
        )


@_check(
    "pin_static",
    title="Static strength of the pins",
    unit="MPa",
    formula="σ_v ≤ R_e/S_F",
    why="Above it the pins bend for good.",
    inputs=(LOADED, "load.peak_torque requirements.bending_safety"),
    fixes=(_FIXES, "load.peak_torque"),
    source="pin_beam",
)
def pin_static(kind: Kind, design: Design, results: Results) -> Check:
    pins, safety = _bent(results), design.requirements.bending_safety
    return pins.static(kind, safety=safety, at=_section(design, pins.found.peak_moment_position))


def _section(design: Design, position: float) -> dict[str, str]:
    """Which end of a pin that a tie ring holds a section is, where it is one."""
    if not design.tied:
        return {}
    end = section_of(position=position, span=design.pin.known_span)
    return {"section": end} if end else {}


def _bent(results: Results) -> BentPins:
    """The pins of the output, or the bolts through them."""
    return BentPins(results.pin_strength, results.bent_pin, solved=results.solved)


def _softest(results: Results, asked: str) -> BentPins:
    """The same, where a limit is asked, of the softest material that sources allow."""
    return _bent(results.softest if asked_of(results.design, asked) else results)


@_check(
    "pin_deflection",
    title="Deflection of the pins",
    unit="mm",
    formula="w ≤ Δ_max",
    why="Above it the satellites share the load unevenly.",
    inputs=(LOADED, "requirements.max_deflection"),
    source="beam",
    asks="max_deflection",
)
def pin_deflection(kind: Kind, design: Design, results: Results) -> Measure:
    return _softest(results, "max_deflection").bent("deflection", "satellite")


@_check(
    "pin_slope",
    title="Slope of the pins in the satellites",
    unit="mrad",
    formula="θ ≤ θ_max",
    why="Above it the contacts carry on their edges.",
    inputs=(LOADED, "requirements.max_slope"),
    source="beam",
    asks="max_slope",
)
def pin_slope(kind: Kind, design: Design, results: Results) -> Measure:
    return _softest(results, "max_slope").bent("slope", "slope_satellite")


@_check(
    "pin_fatigue",
    title="Fatigue of the pins",
    formula="n ≥ S_D",
    why="Below it the pins break after some time where they bend most.",
    inputs=(LOADED, "pin.rotates", FATIGUE, LIFE, "requirements.fatigue_safety"),
    source="shigley",
    keep="above",
)
def pin_fatigue(kind: Kind, design: Design, results: Results) -> Check:
    pins, _ = _bent(results), results.fatigue_strength  # which is known, or raises
    at = _section(design, pins.cycle.position)
    return pins.fatigue(kind, safety=design.requirements.fatigue_safety, at=at)


@_check(
    "pin_wall",
    title="Wall about the bore of the pins",
    unit="MPa",
    formula="σ_w(T_max) ≤ R_e/S_F",
    why="Above it the pin is squeezed flat under the satellite.",
    inputs=(LOADED, "load.peak_torque requirements.bending_safety"),
    fixes=("pin.bore_diameter", _FIXES, "load.peak_torque"),
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
        return judged(
            kind, stress, limit, reserve=limit / stress, error=error, solved=results.solved
        )

    if pin.material.plastic:
        return _of_plastic(pin, by)
    yields, unknown = pin.material.yield_strength, "pin.material.yield_strength"
    strength = judged_by(yields, "yield_unknown", unknown, value=stress)
    return _of_size(pin, by(strength))


SLEEVE = 0.1
"""Least wall of a sleeve over the diameter of its pin: tables of cycloid drives have 0.18 to 0.27,
wrapped bushes 0.1."""


@_check(
    "wall_sleeve",
    title="Wall of the sleeves",
    unit="mm",
    formula="r_in − d/2 ≥ 0.1·d",
    why="Thinner sleeves break or run out of round.",
    inputs="contact.pin_radius pin.diameter",
    fixes="contact.pin_radius",
    source="geometry",
    keep="above",
)
def wall_sleeve(kind: Kind, design: Design, results: Results) -> Check:
    if not design.sleeved:
        return Check(kind, "not_applicable", reason="without_sleeve")
    radius, diameter = design.nominal_pair.pin_radius, design.pin.diameter
    width, guide = radius - diameter / 2, SLEEVE * diameter
    return wall(kind, width=width, size=radius, guide=guide)


_bolt_check = partial(
    design_check,
    group="pin",
    part="pins",
    needed=False,
    needs=("touching", "load", "pin", "bolted"),
)


def _gripped(
    kind: Kind, results: Results, value: float, most: float | None, safety: float = 1.0
) -> Check:
    """A load of the root that the preload has to hold; beyond it the bolt is judged alone."""
    said = {"value": value, "status": "not_applicable"}
    limit = judged_by(most, "bolt_alone", **said) / safety
    return judged(
        kind, value, limit, reserve=limit / value, warning="bolt_alone", solved=results.solved
    )


@_bolt_check(
    "bolt_opens",
    title="Spacers of bolted pins stay closed",
    unit="Nm",
    formula="M ≤ F_min·(d² + d_i²)/(8·d)",
    why="Beyond it the spacer gapes at the carrier, and the bolt bends alone.",
    inputs=(LOADED, "load.peak_torque"),
    source="beam",
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
    inputs=(LOADED, "load.peak_torque"),
    source="beam",
)
def bolt_slips(kind: Kind, design: Design, results: Results) -> Check:
    found = results.grip
    return _gripped(kind, results, found.shear_force, found.slip_force, SLIP_SAFETY)


PINS = (
    pin_static,
    pin_deflection,
    pin_slope,
    pin_fatigue,
    wall_sleeve,
    pin_wall,
    bolt_opens,
    bolt_slips,
)
