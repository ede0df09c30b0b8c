"""Checks of unbalance of the parts turning with the crankshaft, by requested or usual limits."""

from typing import Any

from core.checks import inputs as of
from core.checks.check import Check, Element, Kind, asked_of
from core.design.document import Design
from core.design.results import Results

GRADE = 16e-3
"""Usual speed of the centre of mass about the axis, m/s: G 16 of ISO 21940-11."""

_GRADE, _SHARE = "balance_grade", "max_unbalance_share"

_check = Element(
    "crankshaft",
    "crank_bearings",
    "touching load",
    requires={"crankshaft.satellite_mass": "mass_unknown"},
    fixes="crankshaft.satellite_mass load.input_speed",
    source="balance",
    why="Above it the reducer shakes with every turn of the crank.",
)
_INPUTS = (
    of.OF_DISCS,  # inputs of the load that `max_unbalance_share` refers to
    "load.input_speed crankshaft.satellite_mass crankshaft.satellite_positions",
    "crankshaft.bearing_positions crankshaft.counterweights crankshaft.rotor_mass",
    "requirements.max_unbalance_share requirements.balance_grade",
)


def _limit(results: Results, value: float, demand: str, asked: float) -> float:
    """Limit of an unbalanced force, N, or couple, N*m, by one requirement. A grade limits the force
    of a centre of mass at that speed; a share limits each bearing's unbalanced load over the
    largest working load there, as both are proportional.
    """
    if demand == _GRADE:
        return asked * results.design.rotor_mass * results.design.known_speed
    if demand != _SHARE:
        return asked
    peaks = results.crank.still_shaft.peak_reaction.tolist()
    sizes = zip(results.crank.balance.bearing_force, peaks, strict=True)
    return asked * value * min((peak / force for force, peak in sizes if force), default=0.0)


def _unbalanced(name: str, code: str, *demands: str, usual: bool, **said: Any) -> Kind:
    """Check of an unbalanced force or couple against the least requested limit. Without one a force
    is judged by the usual grade, and a couple, for which no grade exists, is not.
    """
    paths = tuple(f"requirements.{each}" for each in demands)

    @_check(code, inputs=(_INPUTS, paths[0]), demands=paths, **said)
    def unbalanced(kind: Kind, design: Design, results: Results) -> Check:
        value = float(getattr(results.crank.balance, name))
        limits = [_limit(results, value, *each) for each in asked_of(design, *demands).items()]
        if limits:
            return kind.judged(value, min(limits), limit_source="user")
        if not usual:
            return Check(kind, "not_asked", value=value, reason="no_limit")
        limit = _limit(results, value, _GRADE, GRADE)
        return kind.judged(value, limit, warning="unbalanced", limit_source="balance_guide")

    return unbalanced


BALANCE = (
    _unbalanced(
        "force",
        "unbalance_force",
        *("max_unbalance", _GRADE, _SHARE),
        usual=True,
        title="Unbalanced force of the crankshaft",
        unit="N",
        formula="|Σ U|·ω² ≤ F_U, G·M·ω",
    ),
    _unbalanced(
        "couple",
        "unbalance_couple",
        *("max_unbalance_couple", _SHARE),
        usual=False,
        title="Unbalanced couple of the crankshaft",
        unit="Nm",
        formula="|Σ U·(z − z_m)|·ω² ≤ M_U",
    ),
)
