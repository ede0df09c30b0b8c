"""Checks of the fit of pin and hole: room over the turn, clearance."""

from functools import partial

from core.checks.check import Check, Status, design_check, judged, make_check, not_checked
from core.checks.inputs import HOLE
from core.checks.play import backlash, lost_motion
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown

MOST_PLAY = 0.75
"""Clearance over the eccentricity above which a design is marginal: the play is a large part of
what the mechanism moves by."""

_check = partial(
    design_check,
    group="geometry",
    part="contact",
    fixes=("contact.hole_radius", "contact.fit"),
    needs=("touching",),
)


@_check(
    "interference",
    title="Room of the pins in their holes",
    unit="mm",
    formula="min(C − |P·exp(−iθ) − H|) ≥ 0",
    why="Otherwise the parts cannot be put together, jam, or press without load.",
    inputs=(*HOLE, "contact.eccentricity", "deviations", "rollers.radial_clearance"),
    keep="above",
)
def interference(design: Design, results: Results) -> Check:
    """By geometry, before any force: the room over the turn."""
    clearance = design.known_clearance
    try:
        fit = results.fit
    except NotKnown as why:
        if clearance >= 0 and not design.deviations:  # the room is the clearance
            return judged(interference, clearance, 0.0)._replace(utilisation=None)
        if not design.load:
            raise
        if clearance < 0:  # of all pairs alike
            lacking = {
                "satellite": 1,
                "pin": 1,
                "missing_length": -clearance,
                "needed_length": design.contact.pair.hole_radius - clearance,
            }
            found = Check(interference, "fail", value=clearance, limit=0.0, impossible=True)
            return found._replace(reason="cannot_assemble", params=lacking)
        return not_checked(interference, why)._replace(limit=0.0)
    at: dict[str, float] = {}
    if fit.room.binding:
        pair = fit.room.binding[0]
        at = {"satellite": pair.satellite, "pin": pair.pin}
    if fit.room.crank_angle is not None:
        at["crank_angle"] = fit.room.crank_angle
    misfit = fit.misfit
    status: Status = "fail"
    if not misfit or misfit == "fits_by_bearing_clearance":
        status = "marginal" if misfit else "pass"
    return Check(
        interference,
        status,
        value=0.0 if status == "pass" and fit.room.least < 0 else fit.room.least,
        limit=0.0,
        reason=misfit,
        params=fit.refusal().params if misfit == "cannot_assemble" else {},
        impossible=status == "fail" and misfit != "pressed_without_load",
        at=at,
    )


@_check(
    "clearance",
    title="Clearance over eccentricity",
    formula="(r_out − r_in − e)/e ≤ 0.75",
    why="Otherwise the play is a large part of what the mechanism moves by.",
    inputs=(*HOLE, "contact.eccentricity"),
    source="yanchevskiy_2021",
)
def clearance(design: Design, results: Results) -> Check:
    share = max(design.known_clearance, 0.0) / design.known_eccentricity
    wanted = [
        make_check(play, design, results).status == "pass"
        for play in (backlash, lost_motion)
        if share > MOST_PLAY and design.requirements.asked(play.asks)
    ]
    if wanted and all(wanted):  # as much play as is asked for
        return Check(clearance, "pass", value=share, limit=MOST_PLAY)
    ratio = {"ratio": share}
    return judged(clearance, share, MOST_PLAY, warning="clearance_like_eccentricity", params=ratio)


FIT = (interference, clearance)
