"""Checks of the balance: what turns with the crankshaft against what is asked, or is usual."""

from core.checks import inputs as of
from core.checks.check import Check, Element, Kind, asked_of
from core.design.document import Design
from core.design.results import Results

GRADE = 16e-3
"""Usual speed of the centre of what turns about the axis, m/s: G 16 of ISO 21940-11."""

_GRADE, _SHARE = "balance_grade", "max_unbalance_share"
_OF_FORCE, _OF_COUPLE = ("max_unbalance", _GRADE, _SHARE), ("max_unbalance_couple", _SHARE)

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
    *of.OF_DISCS,  # of a share of what the mechanism does
    "load.input_speed",
    "crankshaft.satellite_mass",
    "crankshaft.satellite_positions",
    "crankshaft.bearing_positions",
    "crankshaft.counterweights",
    "crankshaft.rotor_mass",
    "requirements.max_unbalance_share",
    "requirements.balance_grade",
)


def _limit(results: Results, value: float, demand: str, asked: float) -> float:
    """Limit of a value by what is asked: of a grade the force of a centre of what turns that is so
    fast, N; of a share where what is not balanced may load each bearing by a share of the most that
    the mechanism does there: both grow together.
    """
    if demand == _GRADE:
        return asked * results.design.rotor_mass * results.design.known_speed
    if demand != _SHARE:
        return asked
    peaks = results.crank.still_shaft.peak_reaction.tolist()
    sizes = zip(results.crank.balance.bearing_force, peaks, strict=True)
    return asked * value * min((peak / force for force, peak in sizes if force), default=0.0)


def _against(kind: Kind, results: Results, value: float, *demands: str) -> Check:
    """What is not balanced, against the least limit that is asked; without one a force against the
    usual grade, and a couple, of which no grade says anything, against nothing.
    """
    asked = asked_of(results.design, *demands)
    limits = [_limit(results, value, *each) for each in asked.items()]
    if limits:
        return kind.judged(value, min(limits))._replace(limit_source="user")
    if kind is unbalance_couple:
        return Check(kind, "not_asked", value=value, reason="no_limit")
    limit = _limit(results, value, _GRADE, GRADE)
    return kind.judged(value, limit, warning="unbalanced", limit_source="balance_guide")


@_check(
    "unbalance_force",
    title="Unbalanced force of the crankshaft",
    unit="N",
    formula="|Σ U|·ω² ≤ F_U, G·M·ω",
    inputs=(_INPUTS, "requirements.max_unbalance"),
    demands=tuple(f"requirements.{name}" for name in _OF_FORCE),
)
def unbalance_force(kind: Kind, design: Design, results: Results) -> Check:
    return _against(kind, results, float(results.crank.balance.force), *_OF_FORCE)


@_check(
    "unbalance_couple",
    title="Unbalanced couple of the crankshaft",
    unit="Nm",
    formula="|Σ U·(z − z_m)|·ω² ≤ M_U",
    inputs=(_INPUTS, "requirements.max_unbalance_couple"),
    demands=tuple(f"requirements.{name}" for name in _OF_COUPLE),
)
def unbalance_couple(kind: Kind, design: Design, results: Results) -> Check:
    return _against(kind, results, float(results.crank.balance.couple), *_OF_COUPLE)


BALANCE = (unbalance_force, unbalance_couple)
