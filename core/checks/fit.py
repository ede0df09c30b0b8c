"""Checks of pins in their holes: the room over the turn, and the play it leaves the output, against
what is asked.
"""

from functools import partial

from core.checks.check import (
    Check,
    Measure,
    Status,
    design_check,
    judged,
    make_check,
    not_checked,
)
from core.checks.inputs import HOLE, RING_GIVES, SHARING
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown

MOST_PLAY = 0.75
"""Clearance over the eccentricity above which a design is marginal: the play is a large part of
what the mechanism moves by."""

OF_TEETH = (
    "gear.kind",
    "gear.ring_pin_circle_radius",
    "gear.teeth_difference",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "gear.modification.rotation",
)
"""Of the play of teeth that are in series."""

_check = partial(design_check, part="contact", fixes=("contact.hole_radius", "contact.fit"))
_of_room = partial(_check, group="geometry", needs=("touching",))
_of_play = partial(
    _check, group="play", unit="arcmin", source="load_sharing", needs=("touching", "load")
)


@_of_room(
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
    at |= fit.room.where
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


def of_both(results: Results) -> str | None:
    """Why a value is of both meshes, where it is.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    str or None
        The reason.
    """
    return "both_meshes" if results.in_series else None


@_of_play(
    "backlash",
    title="Backlash of the output mechanism",
    formula="max(θ₊ − θ₋) ≤ Δφ",
    why="Otherwise the unloaded output turns by more than is asked.",
    inputs=(
        "mechanism.pins",
        "mechanism.satellites",
        "mechanism.crank_spacing",
        "mechanism.crank_angles",
        "mechanism.ratio",
        "load.pin_circle_radius",
        *HOLE,
        "contact.eccentricity",
        "deviations",
        "crank_support",
        "rollers.radial_clearance",
        "requirements.max_backlash",
        "contact.distribution_factor",  # which no meshes in series have
        *OF_TEETH,
    ),
    asks="max_backlash",
)
def backlash(design: Design, results: Results) -> Measure:
    of_fit = design.known_clearance and 0.0  # none, or interference
    play = results.loading.turn.backlash_max if results.solved else of_fit
    return Measure(design.members.angle_at_output(play), reason=of_both(results))


@_of_play(
    "lost_motion",
    title="Lost motion of the output mechanism",
    formula="θ(+3 % T) − θ(−3 % T) ≤ Δφ",
    why="Otherwise the output gives way by more than is asked when the torque turns.",
    inputs=tuple(
        dict.fromkeys(
            (
                "load.output_torque",
                "contact.distribution_factor",  # which no meshes in series have
                "load.pin_circle_radius",
                "mechanism.pins",
                "mechanism.satellites",
                "mechanism.crank_spacing",
                "mechanism.crank_angles",
                "mechanism.ratio",
                *SHARING,
                "requirements.max_lost_motion",
                *RING_GIVES,
                "gear.modification.rotation",
            )
        )
    ),
    asks="max_lost_motion",
)
def lost_motion(design: Design, results: Results) -> Measure:
    """At the torque itself, of which it takes a share; not solved for where nobody asks. Asked, it
    is that of the softest material that sources allow.
    """
    solved = results.solved and design.load_factor == 1
    asked, _ = design.requirements.asked("max_lost_motion"), design.known_clearance
    if not (solved or asked):
        raise NotKnown("no_limit")
    made = results.softest if asked else results
    lost = made.real_forces.turn.lost_motion
    return Measure(design.members.angle_at_output(lost), reason=of_both(results))


@_of_room(
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
PLAY = (backlash, lost_motion)
