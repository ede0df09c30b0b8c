"""Several inputs of a reducer changed together, where no change of one lets it pass."""

from collections import ChainMap
from functools import partial
from typing import Any

from pydantic import Field

from app.calculations.checks import FixOut, codes_to_fix, fix_values
from app.calculations.reducer_fixes import fixes_of, reposted
from app.model import ResponseModel, Values
from core.checks.check import Outcome, Verdict
from core.checks.reserve import crank_verdict
from core.fixes.fix import Fix

MOST = 4
"""Most changes, one after the other."""

KEPT = {"load.output_torque", "load.input_speed"}
"""What is asked of a design: not changed."""

CHEAP = (
    "contact.fit",
    "contact.pin_material",
    "contact.hole_material",
    "contact.hole_radius",
    "bearing.dynamic_rating",
    "bearing.static_rating",
    "rollers.dynamic_rating",
    "rollers.static_rating",
    "crankshaft.bearings.dynamic_rating",
)
"""Inputs that are changed before sizes of parts: the fit, and the rating of bearings."""


class CombinedOut(ResponseModel):
    """Inputs changed one after the other, each for the check that decides then."""

    sets: dict[str, float | str] = Field(description="All that they set, by JSON pointer.")
    steps: list[FixOut] = Field(
        description="The changes in their order: each is of the design with those before it, and "
        "says the verdict that is reached with it."
    )
    verdict: Outcome = Field(description="Of the whole design with all of them.")


def combined(request: Any, verdict: Verdict, fixes: list[Fix]) -> Values | None:
    """Values of `CombinedOut`: the check that decides is cured by what leaves the fewest others
    that fail, until none fails or is marginal, or none is cured; no input is changed twice.

    Parameters
    ----------
    request : CrankPlanetaryRequest
        The reducer.
    verdict : Verdict
        Of it.
    fixes : list of Fix
        Of the check that decides, others too.

    Returns
    -------
    dict or None
        None where one change is enough, or checks still fail with the most that are looked for.
    """
    steps: list[Values] = []
    kept = set(KEPT)
    reached: str = verdict.verdict
    while reached in ("fail", "marginal") and len(steps) < MOST:
        if steps:  # the design as it is has been judged, and looked through
            request = reposted(request, steps[-1]["sets"])
            verdict = crank_verdict(request.results)
            codes = codes_to_fix(verdict, "governing")
            fixes = fixes_of(request, codes, verdict)
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
    """How many checks fail with a fix, whether it changes sizes of parts, and how much."""
    failing = {each.code for each in verdict.checks if each.status == "fail"} - {fix.code}
    for each in fix.side_effects:
        (failing.add if each.after.status == "fail" else failing.discard)(each.code)
    return len(failing), fix.variable not in CHEAP, fix.extent
