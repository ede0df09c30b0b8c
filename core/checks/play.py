"""Checks of the play of the output: backlash and lost motion against what is asked."""

from collections.abc import Callable

from core.checks.check import Check, Measure, asked
from core.checks.crank_design import CrankDesign
from core.errors import NotKnown


def _backlash(design: CrankDesign) -> Check:
    def play() -> Measure:
        of_fit = design.known_eccentricity and 0.0  # no clearance, or interference
        return Measure(design.loading.turn.backlash_max if design.as_made else of_fit)

    return asked("backlash", design.max_backlash, play, name="max_backlash")


def _lost_motion(design: CrankDesign) -> Check:
    limit = design.max_lost_motion

    def motion() -> Measure:
        """At the torque itself, of which it takes a share; not solved for where nobody asks."""
        solved = design.as_made and design.dynamic_factor == 1
        if not (design.known_eccentricity and (solved or limit is not None)):
            raise NotKnown("no_limit")
        return Measure(design.real_forces.turn.lost_motion)

    return asked("lost_motion", limit, motion, name="max_lost_motion")


PLAY: dict[str, Callable[[CrankDesign], Check]] = {
    "backlash": _backlash,
    "lost_motion": _lost_motion,
}
"""Checks of the play of the output, by code."""
