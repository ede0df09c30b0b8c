"""Relative errors that methods promise, and tolerances within which two numbers count as one.

A class (`EXACT`, `SEARCHED`, ...) is the relative error that a method promises for inputs well away
from where the result ceases to exist. The error stated with a result is usually smaller: a measured
difference (of two rules, of two grids, of a second search) plus `ROUNDING` times the condition of
the input. Only the condition can raise it above the class: near a dead centre, a pole, or a
difference of nearly equal radii. `make accuracy` checks practical cases against the classes.
"""

ROUNDING = 2.0**-52
"""Spacing of the doubles next to 1: the unit in which rounding errors are counted."""

CONVERGED = 1e-14
"""Relative difference at which iterations end, such as that of two quadrature rules for a mean;
smaller differences are rounding."""

EXACT = 1e-9
"""Relative error of closed forms, of converged iterations and of exact searches: rounding alone."""

SEARCHED = 1e-6
"""Relative error of values found by evaluation: extremes over the turn by scan, zoom and a second
scan, ends by bisection, inputs by secants."""

JUDGED = 1e-5
"""Largest distance of a sampled force from the straight line between its neighbours, over the
largest force, at which the sampling of a turn ends."""

HARDLY_KNOWN = 1e-2
"""Relative error above which a number is no guide."""

SAME = 1e-12
"""Relative difference by which rounding parts equal numbers; of phases, the difference in turns
(4e-10 degrees, finer than any part is made)."""

AS_TYPED = 1e-9
"""Relative difference of two sizes that would be equal if people did not type rounded decimals:
clearances, walls, interference of parts that just fit, summits that are one peak."""

CLASSES = {
    "arcs_zoomed": SEARCHED,
    "bisection": SEARCHED,
    "closed_form": EXACT,
    "closed_form_even": EXACT,
    "closed_form_gaps": EXACT,
    "closed_form_newton": EXACT,
    "graded_quadrature": EXACT,
    "integral_equation": SEARCHED,
    "mohr": EXACT,
    "newton_bracket": EXACT,
    "sampling": 10 * JUDGED,
    "sampling_zoomed": SEARCHED,
    "segments_cubic": EXACT,
    "segments_equal": EXACT,
    "segments_roots": EXACT,
    "segments_tanh_sinh": EXACT,
}
"""Relative error that each method promises, by its code (`core.errors.METHODS`)."""
