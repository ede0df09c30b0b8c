"""What the loops of the load sharing take and leave: sizes, rows of pairs, results, limits.

Rules of all modules named kernel, which run as they are and are compiled as well
(`core.output.compiled`): floats, ints, `math`, flat rows, named tuples and functions of these
modules only, since a change elsewhere would leave a stale cache; no allocation (callers bring the
room); no exceptions (a status is returned). SI units.
"""

import math
from collections.abc import MutableSequence
from typing import Generic, NamedTuple, TypeVar

Row = MutableSequence[float]
R = TypeVar("R")

LINEAR, POWER, HERTZ, CONFORMAL = 0, 1, 2, 3
RIGID, CRANK, MESH, TIED, SHARES = 0, 1, 2, 3, 4
"""What of the satellites gives: nothing, the bearings on their cranks, their mesh with the ring. Or
that a tie ring joins the pins, each of which then gives under the forces on all; or that each
satellite turns for itself until it has its given share of the torque."""

SOLVED, NOT_SOLVED, NO_DRIVE, NOT_STABLE, TOO_WIDE, TOO_FAR = range(6)
FORCE, PRESSURE, LAG, STIFFNESS, PLAY_END, BACKLASH, LOST_MOTION, INPUT_TORQUE = range(8)
"""What is looked at over the turn; of the pressure what `hardest` says."""

EPS = 2.0**-52
TINY = 1e-100
"""Stands for what is positive, but for deviations as large as the mechanism."""

NO_LEVER = 16 * EPS
"""Lever and approach over the radius that are no more than rounding."""

STEPS = 200
HALVINGS = 8
"""How often a step of Newton is halved that leads away from the balance of joined pins."""

AS_GOOD = 1e-11
"""What may be left of their balance where no part of a step makes it less: rounding."""

NEWTON_ALONE = 20
"""Steps of Newton after which the stretch is halved too."""

HERTZ_END = 1.2
"""Where the logarithm of the Hertz law ends, in ``approach/(b*force)``: its stiffness would grow
beyond bounds at 1. It goes on as a straight line; what lies there is refused afterwards."""


BEND = 0.4
"""Curves of contacts that wrap are smooth in the width ``sqrt(x/(1 + BEND*x))`` of the load
``x = Q/(E* dR)``, from none to the largest."""

SAME_FORCE = 1e-14
"""Relative change of a force at which Newton's steps end: what its stiffness is off by."""

FITS, BINDS, NOWHERE = 2, 1, 0
"""Whether a piece has room at all positions of the turn, at some, or at none."""

FIT_POSITIONS = 720
"""Positions of the turn at which that is looked at. Its least room is a smooth minimum, which they
miss by no more than the eccentricity times (pi/720)^2/2, 1e-5 of it."""

RADIAN = 1.0
"""Lag beyond which first order says nothing; by exact geometry pins would be in the next holes."""

CLOSE = 1e-8
"""Last step of Newton, over the lag, that studies take along the tangents."""

JUST = 1e-9
"""Part of the eccentricity by which parts that just fit may press: their sizes are rounded."""

SURE = 1e-9
"""Part that bounds of the play are wider than their terms, for rounding: a thousand times that."""

NEAR = 1e-3
"""Lever over its largest, below which a pair is near its dead angle and bounds no play."""

PLACE = 1e-10
"""Width to which a summit is narrowed, rad."""

GOLDEN = (math.sqrt(5) - 1) / 2


class Curve(NamedTuple):
    """What a contact that wraps gives, for all pairs of a design: over the load ``x = Q/(E* dR)``
    the approach ``Delta/dR = x*(P - 2/pi*ln(width))``, P a polynomial of ``2*width/widest - 1``.
    """

    modulus: float  # b*E*, N/m
    widest: float  # width up to which it is known; beyond it goes on as a straight line
    powers: tuple[float, ...]  # of the polynomial, from the highest; as many for any law


class Wrap(NamedTuple):
    """The largest pressure of contacts that wrap, of all pairs: over Hertz's it is
    ``P*sqrt(1 + BEND*x)``, P a polynomial as that of `Curve`.
    """

    modulus: float  # b*E*, N/m; infinite where it is not known: then Hertz's pressure stands
    since: float  # load from which it governs in the place of Hertz's
    widest: float  # width up to which it is known; beyond it P stays
    powers: tuple[float, ...]


class Setup(NamedTuple):
    """What a design is, without its errors."""

    pins: int
    satellites: int
    ratio: float
    exact: bool  # geometry; else first order
    radius: float  # of the pin circle
    pin_radius: float
    eccentricity: float
    clearance: float  # radial; not as a difference of radii, which loses two digits
    direction: float  # of the torque: 1, or -1 in reverse
    law: int  # LINEAR, POWER, HERTZ, CONFORMAL
    # Of the force over the approach; about 10/9 for HERTZ and CONFORMAL, for start and steps.
    exponent: float
    curve: Curve  # CONFORMAL
    wrap: Wrap
    support: int  # RIGID, CRANK, MESH, TIED, SHARES
    gives: float  # compliance of that, m/N or rad/(N*m)
    loose: float  # what the clearance of bearings, on cranks or pins, adds to every gap


class Law(NamedTuple):
    """Law of contact of all pairs."""

    a: float  # LINEAR 1/k; POWER k; CONFORMAL b*E*
    first: float  # HERTZ: (1 - nu^2)/E of pin and hole
    second: float
    quarter: float  # pi*b*E*/4
    around: float  # pi*b
    depth: float
    ratio: float  # nu/(1 - nu) of the hole
    end: float  # CONFORMAL: load Q/(E* dR) at which it ends


class Errors(NamedTuple, Generic[R]):
    """Deviations of one piece, rows of [N], [K*N] or [K]; of many, a table of each."""

    pin_radial: R
    pin_tangential: R
    pin_radius: R
    hole_radial: R
    hole_tangential: R
    hole_radius: R
    eccentricity: R
    crank_phase: R
    disc_phase: R


class Pairs(NamedTuple):
    """What of the pairs does not change over the turn, [K*N]; [K] where said, by which it is known
    how many satellites there are.
    """

    arm: Row  # [K] -2*eccentricity of the satellite's own crank; 1 in first order
    phase: Row  # [K] crank angles with their errors
    share: Row  # [K] of the torque: SHARES
    x: Row  # factors of the crank's direction in u and v
    y: Row
    ex: Row  # and in q
    ey: Row
    k0: Row  # constant parts of q, u, v
    k1: Row
    k2: Row
    distance: Row  # of the centres in contact; in first order that of the radii
    size: Row  # of the terms that make q: times the rounding, its error
    a: Row  # law: LINEAR 1/k + C; POWER k; HERTZ A + C; CONFORMAL b*E*dR
    b: Row  # POWER C; HERTZ B; CONFORMAL b*E*C
    limit: Row  # force at which the law ends
    curved: Row  # difference of the curvatures
    # Of pins that a tie ring joins: compliances between all pairs, [K*N, K*N], but for what is in
    # their laws and for what the ring turns; by which each turns it, over its lever.
    give: Row
    ends: Row


class Room(NamedTuple):
    """Results of one position, [K*N]."""

    q: Row
    u: Row
    v: Row
    unsure: Row  # size of the terms that make q at the onset
    force: Row
    lever: Row
    stiffness: Row  # of the contact
    own_lag: Row  # [K] of the satellites, where they give; their unknown while it is sought
    own_moves: Row  # [K] their unknown by the lag of the output, see `Disc`, and its error
    own_error: Row  # [K]
    approach: Row  # of pins that a tie ring joins: while it is sought, its last one, and its step
    before: Row
    moved: Row
    system: Row  # [K*N, 2*K*N] room for equations of these


class Around(NamedTuple):
    """Even positions of the wave, and how wide the play can be there, rad."""

    sine: Row  # of their wave angles
    cosine: Row
    front: Row  # where the play ends at the latest, and where it begins, counted backwards
    back: Row
    width: Row


class Poses(NamedTuple):
    """Positions under load, and their play; lags count in the torque's direction."""

    forces: Row  # of all pairs, position by position
    lag: Row
    stiffness: Row
    force: Row  # largest
    pressure: Row  # the largest, as `hardest`
    loaded: Row  # number of pairs with a force
    low: Row  # play
    high: Row
    lag_error: Row
    play_error: Row
    force_error: Row
    input_torque: Row


class Pieces(NamedTuple):
    """Quantities of pieces; not a number where one cannot work."""

    peak_force: Row
    max_pressure: Row  # as `hardest`
    transmission_error: Row
    backlash_max: Row
    lost_motion: Row
    stiffness_min: Row
    fits: Row  # FITS, BINDS or NOWHERE


class Position(NamedTuple):
    """Lag of a position (counted in the direction of the torque), and what belongs to it."""

    lag: float
    stiffness: float
    low: float  # play
    high: float
    play_error: float
    lag_error: float
    force_error: float
    status: int
    steps: int


class Freed(NamedTuple):
    """A position without load, and where its lag under load is looked for."""

    low: float  # play
    high: float
    error: float  # of its ends
    pressed: bool
    zero: float  # from where the lag is counted
    lag: float  # to begin with; infinite where no pair can drive


class Carried(NamedTuple):
    """What the pairs carry at a lag, as `carry` left the room."""

    lag: float
    torque: float
    slope: float
    gross: float
    change: float  # next step of Newton
    status: int
    steps: int


class Load(NamedTuple):
    """Load of a turn, and the share of it under which the lost motion is taken."""

    torque: float
    share: float
    setup: Setup  # with the torque's direction
    back: Setup  # with the other one
