"""Checks of the play of the output: backlash and lost motion against what is asked."""

from functools import partial

from core.checks.check import Measure, design_check
from core.checks.inputs import HOLE, RING_GIVES, SHARING
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown

OF_TEETH = (
    "gear.kind",
    "gear.ring_pin_circle_radius",
    "gear.teeth_difference",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "gear.modification.rotation",
)
"""Of the play of teeth that are in series."""

_check = partial(
    design_check,
    group="play",
    part="contact",
    unit="arcmin",
    fixes=("contact.hole_radius", "contact.fit"),
    source="load_sharing",
    needs=("touching", "load"),
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


@_check(
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


@_check(
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


PLAY = (backlash, lost_motion)
