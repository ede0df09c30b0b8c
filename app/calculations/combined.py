"""Several inputs of a reducer changed together, if no single change lets it pass."""

from collections import ChainMap
from dataclasses import replace
from functools import partial
from typing import Any

from pydantic import Field

from app.calculations.checks import FixOut, codes_to_fix, fix_values
from app.calculations.reducer_fixes import fixes_of, reposted
from app.model import ResponseModel, Values
from core.checks.check import Outcome, Verdict
from core.checks.reserve import crank_verdict
from core.fixes.changes import Search
from core.fixes.crank import NAMED
from core.fixes.fix import Fix

MOST = 4
"""Largest number of successive changes."""

KEPT = {"load.output_torque", "load.input_speed"}
"""Requested properties of a design, which are not changed."""

CHEAP = (
    "contact.fit",
    "contact.pin_material",
    "contact.hole_material",
    "contact.hole_radius",
    *NAMED,
    "bearing.dynamic_rating",
    "bearing.static_rating",
    "rollers.dynamic_rating",
    "rollers.static_rating",
    "crankshaft.bearings.dynamic_rating",
)
"""Inputs that are changed before sizes of parts: the fit, and the rating of bearings."""


class CombinedOut(ResponseModel):
    """Inputs changed one after the other, each for the check that governs at that step."""

    sets: dict[str, float | str] = Field(
        description="Values that all changes set, by JSON pointer."
    )
    steps: list[FixOut] = Field(
        description="Changes in their order; each applies to the design with those before it and "
        "states the verdict that is reached."
    )
    verdict: Outcome = Field(description="Verdict of the whole design with all changes.")


def combined(request: Any, search: Search, fixes: list[Fix]) -> Values | None:
    """Values of `CombinedOut`, or None if one change is enough or some check still fails at the
    end.

    The governing check is cured by the fix that leaves the fewest other failures, until no check
    fails or is marginal or none can be cured. No input is changed twice. `fixes` are those of the
    governing check, or more.
    """
    steps: list[Values] = []
    kept, verdict = set(KEPT), search.current
    reached: str = verdict.verdict
    while reached in ("fail", "marginal") and len(steps) < MOST:
        if steps:  # the given design is judged already
            request = reposted(request, steps[-1]["sets"])
            verdict = crank_verdict(request.results)
            search = replace(search, results=request.results, current=verdict)
            fixes = fixes_of(request, codes_to_fix(verdict, "governing"), search)
        cures = [
            each
            for each in fixes
            if (each.code, each.status) == (verdict.governing, "solved")
            and each.variable not in kept
        ]
        if not cures:
            break
        best = min(cures, key=partial(_rank, verdict))
        steps.append(fix_values(best, request))
        kept.add(best.variable)
        reached = best.verdict
    if len(steps) < 2 or reached == "fail":
        return None
    sets = dict(ChainMap(*(step["sets"] for step in reversed(steps))))
    return {"sets": sets, "steps": steps, "verdict": reached}


def _rank(verdict: Verdict, fix: Fix) -> tuple[int, bool, float]:
    """Number of failures with a fix, True if it changes sizes of parts, extent of the change."""
    failing = {each.code for each in verdict.checks if each.status == "fail"} - {fix.code}
    for each in fix.side_effects:
        (failing.add if each.after.status == "fail" else failing.discard)(each.code)
    return len(failing), fix.variable not in CHEAP, fix.extent
