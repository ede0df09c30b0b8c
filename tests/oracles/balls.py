"""Between mpmath's numbers and Arb's balls: the same digits, tens of times faster in long sums.

A ball carries a bound of its own error, so an answer that lost its digits shows it.
"""

from flint import arb, ctx
from mpmath import mp, mpf


def to_ball(value: mpf | float) -> arb:
    """A number as a ball of the digits that mpmath works with, exact where they hold it."""
    ctx.prec = max(ctx.prec, mp.prec + 64)  # for sums that cancel
    return arb(value)


def from_ball(ball: arb) -> mpf:
    """Middle of a ball, which must know it to 25 digits or to 1e-60."""
    assert ball.rel_accuracy_bits() > 83 or abs(ball) < 1e-60, f"the oracle lost its digits: {ball}"
    mantissa, exponent = ball.mid().man_exp()
    return mpf((int(mantissa), int(exponent)))
