"""Peak force with clearance and errors: sampling against narrowed summits."""

import math
from functools import partial

import numpy as np

from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import FORCE
from core.output.summits import Grid, all_summits, summits
from core.output.turn import Turn
from core.work_precision.study import (
    Reference,
    WorkPoint,
    WorkPrecision,
    measured,
    refuse_many_pairs,
)

MAX_PAIRS = 36
"""Most pairs of a study: it solves some twenty thousand positions."""

MAX_PAIRS_GIVING = 9
"""The same where the satellites give, which takes four times as long."""

POSITIONS = (24, 60, 120, 360, 720, 1440, 2880)
ZOOMED = (24, 60, 120, 360, 720)
DENSE = 4
"""How many times as many positions as the calculator's the reference has."""

REFERENCE_DIGITS = 12


def real_peak_study(*, real: RealMechanism, output_torque: float) -> WorkPrecision:
    """Error against run time of the peak force over the turn.

    Samples miss the peak, always downwards: a bias, not a scatter. One summit narrowed is a
    summit, and not always the highest.

    Parameters
    ----------
    real : RealMechanism
        The mechanism, of at most `MAX_PAIRS` pairs, or `MAX_PAIRS_GIVING`.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    WorkPrecision
        Against four times as many positions as the calculator takes, every summit narrowed.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        See `RealMechanism.solved`.
    """
    own = real.mechanism
    most = MAX_PAIRS if real.support is None else MAX_PAIRS_GIVING
    refuse_many_pairs(mechanism=own, limit=most)
    turn = Turn(real, output_torque)
    start = own.initial_crank_angle

    narrow = turn.narrow(FORCE)

    def grid(count: int) -> Grid:
        step = 2 * math.pi / count
        return turn.values(FORCE, [start + step * i for i in range(count)])

    def sampled(count: int) -> float:
        return float(grid(count).heights.max())

    def narrowed(count: int) -> float:
        return summits(grid=grid(count), narrow=narrow, most=1)[0].height

    def chosen() -> float:
        even, near = turn.positions()
        step = even[1] - even[0]
        coarse = turn.values(FORCE, sorted({*even, *near}))
        between = turn.values(FORCE, {psi + step / 2 for psi in even} - {*coarse.places.tolist()})
        places = np.concatenate([coarse.places, between.places])
        order = np.argsort(places)
        fine = Grid(places[order], np.concatenate([coarse.heights, between.heights])[order])
        return all_summits(coarse=coarse, fine=fine, narrow=narrow)[1].height

    def dense() -> float:
        even, near = turn.positions()
        step = (even[1] - even[0]) / DENSE
        places = {psi + step * i for psi in even for i in range(DENSE)} | {*near}
        values = turn.values(FORCE, sorted(places))
        return all_summits(coarse=values, fine=values, narrow=narrow)[1].height

    exact = [dense()]

    def point(method: str, count: int, calculate: partial[float]) -> WorkPoint | None:
        return measured(
            method=method,
            setting=("positions", count),
            calculate=calculate,
            exact=exact,
            evaluations=count,
        )

    points = [point("sampling", count, partial(sampled, count)) for count in POSITIONS]
    points += [point("golden_section", count, partial(narrowed, count)) for count in ZOOMED]
    before = turn.evaluations
    chosen()
    best = measured(
        method="sampling_zoomed",
        calculate=chosen,
        exact=exact,
        evaluations=turn.evaluations - before,
    )
    assert best is not None
    points.append(best)
    return WorkPrecision(
        reference=Reference("sampling_dense", REFERENCE_DIGITS),
        points=tuple(each for each in points if each is not None),
        chosen=best,
    )
