"""Checks of the play of the output: backlash and lost motion against what is asked."""

from core.checks.check import Check, Measure, asked
from core.checks.design_check import Judge
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown


def _backlash(design: Design, results: Results) -> Check:
    def play() -> Measure:
        of_fit = design.known_eccentricity and 0.0  # no clearance, or interference
        return Measure(results.loading.turn.backlash_max if results.solved else of_fit)

    return asked("backlash", design.requirements.max_backlash, play, name="max_backlash")


def _lost_motion(design: Design, results: Results) -> Check:
    limit = design.requirements.max_lost_motion

    def motion() -> Measure:
        """At the torque itself, of which it takes a share; not solved for where nobody asks."""
        solved = results.solved and design.load_factor == 1
        if not (design.known_eccentricity and (solved or limit is not None)):
            raise NotKnown("no_limit")
        return Measure(results.real_forces.turn.lost_motion)

    return asked("lost_motion", limit, motion, name="max_lost_motion")


PLAY: dict[str, Judge] = {
    "backlash": _backlash,
    "lost_motion": _lost_motion,
}
"""Checks of the play of the output, by code."""
