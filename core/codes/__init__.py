"""Codes of all messages of the service, one for each fact, with a kind and English words.

A fact has one code and one text as a refusal, as a warning and as the reason of a check. A code
comes with parameters, so that clients can state it in other languages and with other names.
Parameters here have core names and SI units (mm in warnings); `field` and `other` are names of core
parameters. Titles and reasons of checks are in their records in `core.checks`.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
code                a code and its words
refusals            wrong parameters, and mechanisms that cannot exist
reasons             reasons for the status of a check
given               warnings about unusual or missing inputs
limits              warnings about results that strain a limit
checks              checks made by calculations that have no verdict
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
"""All codes, without those of checks that appear in verdicts of designs only."""

WARNINGS = {code: each for code, each in CODES.items() if each.title}
"""Codes that warnings use."""

REFUSALS = {
    code: each for code, each in CODES.items() if each.kind != "unknown" and code not in WARNINGS
}
"""Codes that refusals use."""

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
        "not_stable": "no_balance",
        "overflow": "no_balance",
        "smaller_than": "no_balance",
        "too_many_pairs": "too_large",
    },
}
"""Former code that a code of a refusal, warning, check or reason replaces, for one release."""
