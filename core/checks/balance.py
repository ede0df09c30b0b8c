"""Checks of the balance: what turns with the crankshaft against what is asked, or is usual."""

from typing import Any

from core.checks import inputs as of
from core.checks.check import Check, Element, Kind, asked_of
from core.design.document import Design
from core.design.results import Results

GRADE = 16e-3
"""Usual speed of the centre of what turns about the axis, m/s: G 16 of ISO 21940-11."""

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
    of.OF_DISCS,  # of a share of what the mechanism does
    "load.input_speed crankshaft.satellite_mass crankshaft.satellite_positions",
    "crankshaft.bearing_positions crankshaft.counterweights crankshaft.rotor_mass",
    "requirements.max_unbalance_share requirements.balance_grade",
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


def _unbalanced(name: str, code: str, *demands: str, usual: bool, **said: Any) -> Kind:
    """An unbalanced force or couple against the least limit that is asked; without one the force
    against the usual grade, and the couple, of which no grade says anything, against nothing.
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
