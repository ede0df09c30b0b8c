"""Inputs of a crank-planetary reducer, and the reducer with another value of one."""

from dataclasses import replace
from typing import Any

from core.checks.crank_design import CrankDesign
from core.fixes.inputs import WHOLE
from core.output.satellite_support import Shares


def vary(*, design: CrankDesign, variable: str, value: float) -> CrankDesign:
    """A design with another value of an input; the hole follows pin and eccentricity.

    Parameters
    ----------
    design : CrankDesign
        The design.
    variable : str
        Its attribute.
    value : float
        The value, SI.

    Returns
    -------
    CrankDesign
    """
    if variable in WHOLE:
        return replace(design, **{variable: round(value)})  # type: ignore[arg-type]
    if variable == "crankshaft.dynamic_rating":
        return _rated(design, value)
    section, _, name = variable.rpartition(".")
    if section:
        part = replace(getattr(design, section), **{name: value})
        return replace(design, **{section: part})
    changed: dict[str, float] = {variable: value}
    if variable in ("pin_radius", "eccentricity") and design.hole_radius is not None:
        changed["hole_radius"] = design.hole_radius + value - (getattr(design, variable) or 0.0)
    made = replace(design, **changed)  # type: ignore[arg-type]
    if variable == "pin_radius" and design.pin and not design.sleeved:
        made = replace(made, pin=replace(design.pin, diameter=2 * value))
    return made


def _rated(design: CrankDesign, rating: float) -> CrankDesign:
    """With both bearings of the crankshaft of a rating."""
    shaft = design.crankshaft
    assert shaft is not None and shaft.bearings is not None
    one, other = (replace(each, dynamic_rating=rating) for each in shaft.bearings)
    return replace(design, crankshaft=replace(shaft, bearings=(one, other)))


def value_of(*, design: CrankDesign, variable: str) -> float | None:
    """An input of a design.

    Parameters
    ----------
    design : CrankDesign
        The design.
    variable : str
        Its attribute, with its section's name before a dot.

    Returns
    -------
    float or None
        None where it is not given, or no input of its own: the diameter of a pin without a sleeve
        is that of the contact, with one the contact is not the pin's.
    """
    if variable == "crankshaft.dynamic_rating":
        bearings = design.crankshaft and design.crankshaft.bearings
        ratings = [each.dynamic_rating for each in bearings or ()]
        return None if not ratings or None in ratings else min(ratings)  # type: ignore[type-var]
    if variable == "pin.diameter" and not design.sleeved:
        return None
    found: Any = design
    for name in variable.split("."):
        found = None if found is None else getattr(found, name)
    return found  # type: ignore[no-any-return]


def count_may_change(design: CrankDesign) -> bool:
    """Whether the number of satellites may change: nothing is listed for each of them.

    Parameters
    ----------
    design : CrankDesign
        The design.

    Returns
    -------
    bool
    """
    listed = (design.crank_angles, design.crank_spacing, design.pin, design.crankshaft)
    shares = isinstance(design.support, Shares)
    return not shares and all(each is None for each in (*listed, design.deviations))
