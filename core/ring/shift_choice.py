"""Profile shifts for involute teeth of given heights that keep tips apart with the most contact."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from core.arrays import check_finite
from core.errors import InvalidInput, NotKnown
from core.numerics.inverse import edge
from core.ring.involute import TIPS_APART, InvolutePair, InvoluteTeeth, involute_pair
from core.ring.line_of_action import LineOfAction, involute
from core.ring.possible_teeth import USUAL_SHIFTS

STEEPEST = math.radians(75)
"""Largest operating pressure angle that is tried, rad."""

TRIED = 128
"""Number of operating pressure angles that are tried."""

SHIFT_STEP = 0.01
"""Step of the planet's profile shifts that are tried."""


def nearest_ring(*, teeth: InvoluteTeeth, room: float = TIPS_APART) -> InvolutePair:
    """Ring's profile shift, and eccentricity without backlash, that leave a given gap of the tips.

    The least operating pressure angle with this gap is taken, as it has the largest contact ratio;
    it is at least the reference pressure angle. Raises NotKnown if no angle to `STEEPEST` does. The
    profile shift of the ring in `teeth` is not used; `room` is the interference G of the tips that
    has to remain.

    >>> teeth = InvoluteTeeth(satellite_teeth=40, ring_teeth=41, module=2.5e-3,
    ...                       satellite_profile_shift=0.0, ring_profile_shift=0.0,
    ...                       satellite_addendum=0.8, ring_addendum=0.8)
    >>> found = nearest_ring(teeth=teeth)
    >>> round(math.degrees(found.line.angle), 1), round(found.contact_ratio, 2)
    (53.6, 1.11)
    """
    check_finite(room=room)
    alpha, difference = teeth.rack.pressure_angle, teeth.difference
    own, tan = float(involute(alpha)), math.tan(alpha)

    def at(angle: float) -> InvolutePair:
        turned = difference * (float(involute(angle)) - own) / (2 * tan)
        shift = teeth.satellite_profile_shift + turned
        return involute_pair(teeth=replace(teeth, ring_profile_shift=shift))

    def spare(angle: float) -> float:
        try:
            return float(at(angle).crossing.interference) - room
        except InvalidInput as why:
            if why.parameter == "ring_addendum":  # the ring's tip lies within its base circle
                return math.nan
            raise

    angles = np.linspace(alpha, STEEPEST, TRIED).tolist()
    if spare(alpha) >= 0:
        return at(alpha)
    for before, angle in pairwise(angles):
        if spare(angle) >= 0:
            inside, _ = edge(inside=angle, outside=before, excess=spare)
            return at(inside)
    raise NotKnown("tips_overlap")


def shifts_at(
    *, teeth: InvoluteTeeth, eccentricity: float, room: float = TIPS_APART
) -> InvoluteTeeth:
    """Teeth with usual profile shifts, without backlash, with the largest contact ratio at an
    eccentricity; tips stay apart, the path lies on involutes, and no tooth is pointed.

    Raises NotKnown if no usual shifts do, InvalidInput if base circles leave no room for e. Profile
    shifts in `teeth` are not used; `room` is the interference G of the tips that has to remain.
    """
    line = LineOfAction.of(
        satellite_teeth=teeth.satellite_teeth,
        ring_teeth=teeth.ring_teeth,
        module=teeth.module,
        pressure_angle=teeth.rack.pressure_angle,
        eccentricity=eccentricity,
    )
    fitting: list[InvolutePair] = []
    low, high = USUAL_SHIFTS
    for shift in np.linspace(low, high, round((high - low) / SHIFT_STEP) + 1).tolist():
        shifted = replace(
            teeth, satellite_profile_shift=shift, ring_profile_shift=shift + line.wider
        )
        try:
            pair = involute_pair(teeth=shifted, eccentricity=eccentricity)
        except InvalidInput:  # a tip lies within its base circle
            continue
        blunt = min(pair.satellite_tip_thickness, pair.ring_tip_thickness) > 0
        if pair.tips_apart(room) and blunt and pair.on_involutes:
            fitting.append(pair)
    if not fitting:
        raise NotKnown("unusual_teeth")
    return max(fitting, key=lambda pair: pair.contact_ratio).teeth
