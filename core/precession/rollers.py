"""Rollers of the precessional gear, given one by one or as a wheel."""

import math
from dataclasses import dataclass

from core.errors import InvalidInput
from core.precision import ROUNDING

SAME = 8 * ROUNDING
"""Relative difference below which two doubles count as equal."""


ANGLE_ROUNDING = 1.5 * ROUNDING
"""Relative error of an angle given in degrees: one rounding and two in the conversion."""


@dataclass(frozen=True, slots=True)
class RollerByLength:
    """Roller with a working length."""

    position_angle: float  # phi1, rad
    z_min: float  # ends of the working length, m from the precession centre
    z_max: float  # m
    # Error of phi1 besides its own rounding, rad: rounding of the terms that were added.
    position_error: float = 0.0


@dataclass(frozen=True, slots=True)
class RollerByAngle:
    """Roller with the polar angles of the ends of its contact line."""

    position_angle: float  # phi1, rad
    phi_min: float  # polar angles of the ends, rad
    phi_max: float  # rad
    position_error: float = 0.0  # error of phi1 besides its own rounding, rad


Roller = RollerByLength | RollerByAngle


def stands_in_line(position_angle: float) -> bool:
    """True if sin(phi1) = 0 within the rounding of the position angle phi1, rad."""
    return abs(math.sin(position_angle)) <= SAME * max(1.0, abs(position_angle))


def wheel_rollers(
    *,
    rollers_total: int,
    position_angle: float,
    z_min: float,
    z_max: float,
    rollers_in_mesh: int,
) -> tuple[RollerByLength, ...]:
    """Evenly spaced rollers of a wheel: ``phi1 = position_angle + 2*pi*i/rollers_total``.

    The sign of the torque selects the loaded flank of each, see `contact_lines`. `InvalidInput` is
    raised if one of the rollers in mesh stands where sin(phi1) = 0. Rollers in mesh count from the
    first one, at `position_angle`, rad; the working length goes from z_min to z_max, m from the
    precession centre.
    """
    if rollers_total < 1:
        raise InvalidInput("rollers_total", rollers_total, "greater_than_equal", limit=1)
    if not 1 <= rollers_in_mesh <= rollers_total:
        most = {"field": "rollers_total", "limit": rollers_total}
        raise InvalidInput("rollers_in_mesh", rollers_in_mesh, "at_most", **most)
    if not z_min < z_max:
        raise InvalidInput("z_max", z_max, "larger_than", field="z_min", limit=z_min)
    turns = [2 * math.pi * (i / rollers_total) for i in range(rollers_in_mesh)]
    for i, turn in enumerate(turns):
        if stands_in_line(position_angle + turn):
            raise InvalidInput("position_angle", position_angle, "roller_without_arm", roller=i + 1)
    return tuple(
        RollerByLength(
            position_angle + turn, z_min, z_max, ANGLE_ROUNDING * (abs(position_angle) + turn)
        )
        for turn in turns
    )
