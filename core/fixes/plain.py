"""Fixes of rollers and the precessional gear, whose inputs do not depend on each other."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import partial
from re import sub
from typing import Any

from core.checks.check import Check, Verdict
from core.fixes.fix import WHOLE, Cure, Fix, NoFix, fix_of, in_order

_plain_name = partial(sub, r"\[\d+\]", "")
"""Name of an input of one of several equal parts, without its number."""


def plain_fixes(
    *,
    design: Mapping[str, Any],
    codes: Iterable[str],
    current: Verdict,
    checks: Callable[[dict[str, Any]], Verdict],
) -> list[Fix]:
    """Fixes of the checks `codes` of a design whose inputs do not depend on each other, best first.

    `design` has the inputs by core names, SI; `checks` makes all checks of changed inputs.
    """
    fixes = []
    for code in codes:
        named = current[code].kind.fixes
        for variable in (each for name in named for each in design if _plain_name(each) == name):
            before = design[variable]
            if not before or (variable == "rollers" and "gaps" in design):
                continue

            def whole_list(value: float, variable: str = variable) -> Verdict:
                changed = round(value) if variable in WHOLE else value
                return checks({**design, variable: changed})

            def change(
                value: float, code: str = code, all_of: Callable[[float], Verdict] = whole_list
            ) -> Check:
                return all_of(value)[code]

            cure = Cure(code, variable, float(before), whole_list, current)
            with suppress(NoFix):
                fixes.append(fix_of(cure=cure, change=change))
    return in_order(fixes)
