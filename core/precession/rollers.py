"""Rollers of the precessional gear, one by one or as a wheel."""

import math
from dataclasses import dataclass

from core.errors import InvalidInput
from core.precision import ROUNDING

SAME = 8 * ROUNDING
"""Relative difference below which two doubles stand for the same number."""


ANGLE_ROUNDING = 1.5 * ROUNDING
"""Relative error of an angle given in degrees: it is rounded, and twice on its way to radians."""


@dataclass(frozen=True, slots=True)
class RollerByLength:
    """A roller and its working length."""

    position_angle: float  # phi1, rad
    z_min: float  # ends of the working length, m from the precession centre
    z_max: float  # m
    # Error of phi1 besides its own rounding, rad: that of the terms that it is the sum of.
    position_error: float = 0.0


@dataclass(frozen=True, slots=True)
class RollerByAngle:
    """A roller and the polar angles at which its contact line begins and ends."""

    position_angle: float  # phi1, rad
    phi_min: float  # polar angles of the ends, rad
    phi_max: float  # rad
    position_error: float = 0.0  # as that of `RollerByLength`


Roller = RollerByLength | RollerByAngle


def stands_in_line(position_angle: float) -> bool:
    """Whether sin(phi1) = 0, within the rounding of the angle.

    Parameters
    ----------
    position_angle : float
        Position angle phi1, rad.

    Returns
    -------
    bool
    """
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

    Which flank of each is loaded follows from the torque's sign, see `contact_lines`.

    Parameters
    ----------
    rollers_total : int
        Number z1 of rollers of the wheel, >= 1.
    position_angle : float
        Position angle phi1 of the first roller, rad.
    z_min, z_max : float
        Ends of the working length, m.
    rollers_in_mesh : int
        How many of them touch the satellite, from the first one on.

    Returns
    -------
    tuple of RollerByLength

    Raises
    ------
    InvalidInput
        If a number is below 1, more rollers are in mesh than there are, the working length is
        not positive, or one of the rollers in mesh stands where sin(phi1) = 0.
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
