"""The crank-planetary reducer as one job: request, answer, figure."""

from functools import partial

from app.calculations.checks import codes_to_fix, fix_values, judgement
from app.calculations.combined import combined
from app.calculations.crank_planetary_answer import ColdYieldOut, CrankPlanetaryResponse
from app.calculations.crank_planetary_figure import figure
from app.calculations.crank_planetary_request import CrankPlanetaryRequest
from app.calculations.crank_planetary_sections import ANSWERS
from app.calculations.crank_planetary_worked import work
from app.calculations.fit_answer import FitOut
from app.calculations.hertz import entry_of
from app.calculations.reducer_fixes import fixes_of
from app.calculations.shares_answer import SharesOut, shares_warnings
from app.model import Calculation, Values, notices_of, present, warning
from app.sources import (
    ARCHARD_1953,
    HARRIS,
    ISO_281,
    ISO_6336,
    JOHNSON_1985,
    PERSSON_1964,
    SHIGLEY,
    WANG_2016,
    YANCHEVSKIY_2021,
    YANCHEVSKY_2018,
    ZYL,
)
from core.checks.cold_yield import ColdYield, cold_yield
from core.checks.shares import disc_shares
from core.design.results import MOST_IN_SERIES
from core.errors import if_known
from core.fixes.fix import Fix
from core.materials import NOT_LISTED
from core.results import Notice


def _judged(body: CrankPlanetaryRequest) -> Values:
    """Verdict, and checks and fixes, of one input and of several, where asked."""
    found = body.verdict
    fixes: list[Fix] = []
    if {"fixes", "combined"} & {*body.sections}:
        codes = codes_to_fix(found, body.fixes_for)
        fixes = fixes_of(body, codes, found)
    values: Values = {}
    judged = partial(cold_yield, results=body.results, found=found)
    if body.design.plastics and (cold := if_known(judged)):
        values["cold_yield"] = _cold_values(body, cold)
    values |= judgement(
        found,
        body,
        torque=body.design.load.output_torque if body.design.load else 0.0,
        checks="checks" in body.sections,
    )
    if "fixes" in body.sections:
        values["fixes"] = [fix_values(each, body) for each in fixes]
    if "combined" in body.sections:
        values["combined"] = combined(body, found, fixes)
    return present(values)


def _cold_values(body: CrankPlanetaryRequest, cold: ColdYield) -> Values:
    """When a plastic contact yields at once, and where its strength comes from."""
    given = getattr(body.given["contact"], f"{cold.body}_material")
    own = not isinstance(given, str) and (given.yield_strength_MPa or given.tensile_strength_MPa)
    entry = NOT_LISTED if own else entry_of(given)
    return ColdYieldOut.values(cold, source=entry.strength.source or None)


def _notices(body: CrankPlanetaryRequest) -> tuple[Notice, ...]:
    """What is to be said of the design, whichever sections are asked."""
    results, found = body.results, notices_of(if_known(body.solve_fit))
    if body.contact is not None:
        found += body.contact.material_notices()
    if results.in_series:
        found += (Notice("both_meshes"),)
    elif forces := results.forces_in_series:
        found += (Notice("meshes_apart", {"forces": forces, "limit": MOST_IN_SERIES}),)
    found += notices_of(if_known(lambda: results.disc_of(results.hertz)))
    if "pin_strength" not in body.sections:  # which tells it itself
        found += results.size_notices
    return found


def solve(body: CrankPlanetaryRequest) -> Values:
    """Cyclogram, contact force, load sharing, Hertz stress, pins, efficiency, bearings, crankshaft,
    geometry: the sections that are asked.

    Verdict and warnings are there whichever sections are asked.
    """
    asked, results = body.sections, body.results
    sections = present({name: answer(body) for name, answer in ANSWERS.items() if name in asked})
    warnings = [warning(each) for each in _notices(body)]
    if fit := if_known(lambda: results.fit):
        sections["fit"] = FitOut.values(fit)
    judged = _judged(body)
    if results.uneven and (shares := disc_shares(results=results, found=body.verdict)):
        sections["shares"] = SharesOut.of(shares)
        warnings += shares_warnings(shares)
    if warnings:
        sections["warnings"] = warnings
    return judged | {"model": body.forces} | sections


CALCULATION = Calculation(
    name="crank-planetary",
    title="Crank-planetary reducer",
    tag="crank-planetary",
    request=CrankPlanetaryRequest,
    answer=CrankPlanetaryResponse,
    solve=solve,
    worked=work,
    figure=figure,
    sources=(
        YANCHEVSKIY_2021,
        YANCHEVSKY_2018,
        ZYL,
        JOHNSON_1985,
        PERSSON_1964,
        HARRIS,
        ISO_6336,
        SHIGLEY,
        WANG_2016,
        ARCHARD_1953,
        ISO_281,
    ),
    neglects=(
        "bodies_rigid",
        "body_strength",
        "centrifugal_forces",
        "edge_pressure",
        "fretting",
        "friction_on_forces",
        "heat",
        "lubricant_film",
        "seals",
        "seat_compliance",
        "shaft_bearings",
        "tilt",
    ),
)
