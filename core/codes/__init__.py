"""All codes that the service says, one for each fact, with one kind and its words in English.

Where a refusal, a warning and the reason of a check are the same fact, they have the same code and
the same words. A code comes with parameters, so that whoever shows it can say it in another
language and with other names; here it has the core's names and SI units (in warnings, mm). The
parameters `field` and `other` are names of core parameters. What a check is called and why it is
made stands at the check (`core.checks`).

Modules, in reading order (each may use those above it)
-------------------------------------------------------
code                a code, and what is said under it
refusals            of one parameter that is wrong, and of what cannot be
reasons             why a check stands as it does
given               warnings of what is given, oddly or not at all
limits              warnings of results that strain a limit
checks              checks that calculations without checks make
"""

from core.codes.checks import CHECKS
from core.codes.code import Code
from core.codes.given import OF_INPUT
from core.codes.limits import OF_RESULTS
from core.codes.reasons import UNKNOWN
from core.codes.refusals import IMPOSSIBLE, INVALID

__all__ = ["CODES", "REFUSALS", "WARNINGS", "WAS", "Code"]

CODES: dict[str, Code] = {
    **{code: Code("invalid", text) for code, text in INVALID.items()},
    **{code: Code("impossible", text) for code, text in IMPOSSIBLE.items()},
    **{code: Code("unknown", text) for code, text in UNKNOWN.items()},
    **OF_INPUT,
    **OF_RESULTS,
    **CHECKS,
}
"""Every code, but for checks that are said by their design alone."""

WARNINGS = {code: each for code, each in CODES.items() if each.title}
"""Of these, what warnings say."""

REFUSALS = {
    code: each for code, each in CODES.items() if each.kind != "unknown" and code not in WARNINGS
}
"""And what refusals say."""

WAS = {
    "errors": {
        "only_one": "exclusive",
        "unloaded": "no_reaction",
    },
    "warnings": {
        "beyond_size": "strength_beyond_size",
        "contact_wraps": "hertz_impossible",
        "endurance_unknown": "fatigue_no_basis",
        "notch_unknown": "fatigue_no_notch",
        "pins_apart": "pins_overlap",
        "wall_holes": "holes_overlap",
    },
    "checks": {
        "unbalance_force": "crank_balance",
    },
    "reasons": {
        "beyond_hertz": "no_pressure",
        "eccentricity_assumed": "eccentricity_missing",
        "contact_wraps": "hertz_impossible",
        "no_mechanism": "no_balance",
        "no_room_in_hole": "no_balance",
        "not_balanced": "no_balance",
        "not_stable": "no_balance",
        "overflow": "no_balance",
        "smaller_than": "no_balance",
        "too_many_pairs": "too_large",
    },
}
"""Which code of refusals, of warnings, of checks and of their reasons a code replaces; for one
release."""
