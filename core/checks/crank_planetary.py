"""All checks of a crank-planetary reducer, and its verdict."""

from functools import cache

from core.checks.check import Check, Verdict, make_check, verdict
from core.checks.crank import CRANK
from core.checks.cranks import CRANKS
from core.checks.fit import FIT
from core.checks.friction import FRICTION
from core.checks.pin_contact import CONTACT, life_considered
from core.checks.pins import PINS
from core.checks.play import PLAY
from core.checks.space import SPACE
from core.derived import if_known
from core.design.document import Design
from core.design.real_forces import RealForces
from core.design.results import Results

CRANK_CHECKS = {
    kind.code: kind for kind in (*CRANKS, *FIT, *CONTACT, *PLAY, *SPACE, *PINS, *FRICTION, *CRANK)
}
"""By code."""

_NEEDS = tuple(dict.fromkeys(need for kind in CRANK_CHECKS.values() for need in kind.needs))
_ASKED_ALONE = tuple(kind.asks for kind in CRANK_CHECKS.values() if kind.asked_alone)

SECTIONS = tuple(need for need in _NEEDS if need not in ("touching", "load"))
"""Sections of a design that have checks of their own, besides load and contact."""


def crank_check(code: str, results: Results) -> Check:
    """One check of a crank-planetary reducer; it says why where it could not be made.

    Parameters
    ----------
    code : str
        Which.
    results : Results
        Results of a design.

    Returns
    -------
    Check
    """
    return make_check(CRANK_CHECKS[code], results.design, results)


def crank_codes(design: Design) -> tuple[str, ...]:
    """The checks that the sections of a design allow.

    Parameters
    ----------
    design : Design
        The design.

    Returns
    -------
    tuple of str
        Their codes, first of those that need less.
    """
    there = [need for need in _NEEDS if getattr(design, need)]
    asked = [each for each in _ASKED_ALONE if getattr(design.requirements, each) is not None]
    return _codes(frozenset((*there, *asked)))


@cache
def _codes(given: frozenset[str]) -> tuple[str, ...]:
    needed = {code: kind.needed(given) for code, kind in CRANK_CHECKS.items()}
    made = [code for code, needs in needed.items() if given.issuperset(needs)]
    return tuple(sorted(made, key=lambda code: len(needed[code])))


def crank_checks(results: Results) -> Verdict:
    """All checks of a crank-planetary reducer.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    Verdict
    """
    design = results.design
    pressed = bool(design.load) and design.touching
    forces = if_known(lambda: results.judged_forces) if pressed else None
    fit = if_known(lambda: results.fit)
    solved = design.as_made and isinstance(forces, RealForces)
    solved = solved or (fit is not None and fit.impossible)
    absent = {
        "load": not design.load,
        "contact": not design.touching,
        "satellite_body": not design.satellite_body,
        "clearance": not solved,
        "contact_life_pin": pressed and not life_considered(design=design, body="pin"),
        "contact_life_hole": pressed and not life_considered(design=design, body="hole"),
        **{name: not getattr(design, name) for name in SECTIONS},
    }
    return verdict(
        [crank_check(code, results) for code in crank_codes(design)],
        tuple(name for name, so in absent.items() if so),
    )
