"""The torque at which the mechanism as it is made reaches a pressure for the first time."""

from core.arrays import check_single
from core.output.contact_law import law_kind
from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import LIMIT_TORQUE, alone
from core.output.summits import Grid, summits
from core.output.turn import Turn


def limit_torque(*, real: RealMechanism, direction: float, pair: int, force: float) -> float:
    """Least torque over the turn under which a pair is pressed as a given one is by a force.

    Where the lag is what brings the first pair to its limit, the torque of all pairs is known
    without a search: the least of these over the turn is the largest torque that may be asked.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    direction : float
        Of the torque: 1, or -1 in reverse.
    pair : int
        Index of the pair whose force is given, satellite by satellite.
    force : float
        Its force at the limit, N, > 0. Pairs of other radii have theirs at the same Hertz pressure.

    Returns
    -------
    float
        Size of the torque, N*m; 0 where pairs press as hard without load. Where the output would
        lag by the eccentricity before, the torque that brings it there.

    Notes
    -----
    The inverse of the peak: under this torque `over_turn` has this pressure as its largest. A pair
    reaches the approach d at the lag where ``|P*exp(-i*lag) - H| = C + d``, which is the closed
    form of the play with ``2*C*d + d^2`` less in its constant term.

    Examples
    --------
    Eight pins, 0.02 mm of clearance: the peak under 30 N*m is 957.1068 N.

    >>> from core.output.contact_law import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False)
    >>> round(limit_torque(real=real, direction=1.0, pair=0, force=957.1067811865), 9)
    30.0
    """
    check_single(direction=direction, force=force)
    setup, pairs = real.setup(direction), real.pairs
    kind, exponent = law_kind(real.law)
    less = []
    for i, curved in enumerate(pairs.curved):
        approach = alone(
            kind, force * pairs.curved[pair] / curved, pairs.a[i], pairs.b[i], exponent
        )
        whole = 2 * pairs.distance[i] + approach if setup.exact else 1.0
        less.append(approach * whole)

    turn = Turn(real, direction)
    turn.pairs = turn.pairs._replace(allowed=turn.kernel.row(less))
    even, near = turn.positions()
    torques = turn.values(LIMIT_TORQUE, sorted({*even, *near}))
    least = Grid(torques.places, -torques.heights, turn.period)
    return -max(each.height for each in summits(grid=least, narrow=turn.narrow(LIMIT_TORQUE, -1)))
