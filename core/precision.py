"""What methods promise, and what is one number: the classes of precision.

A class is what a method promises, relative to what it calculates, for inputs that are no rounding
error away from where a result ceases to be. What is stated is smaller: a measured difference (of
two rules, two grids, a second look), and `ROUNDING` times the condition of the input. That grows
beyond the class only with the condition, beside a dead centre, a pole, or a difference of nearly
equal radii; `make accuracy` holds practical cases to it.
"""

ROUNDING = 2.0**-52
"""Spacing of the doubles next to 1: the unit in which rounding errors are counted."""

CONVERGED = 1e-14
"""Where what converges ends, as a part of its value: two rules of a mean, or what a search may have
missed. Below it there is rounding."""

EXACT = 1e-9
"""Of closed forms, of what converges, and of exact searches: rounding alone is left."""

SEARCHED = 1e-6
"""Of what is looked for by evaluating it: extremes over the turn by scan, zoom and a second scan,
ends by bisection, inputs by secants."""

JUDGED = 1e-5
"""Where what checks are judged by ends: how far a sample of solved forces lies off the line between
its neighbours, over the largest, and a torque off that at which a check is at its limit."""

HARDLY_KNOWN = 1e-2
"""Relative error above which a number is no guide."""

SAME = 1e-12
"""Difference that rounding makes of what is one number, as a part of it; of phases in turns, 4e-10
degrees, finer than any part is made."""

AS_TYPED = 1e-9
"""Difference of two sizes that would be one had people not to type decimals, as a part of them: a
clearance, a wall, what parts that just fit may press, summits that are one peak."""

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
"""What the methods of results promise, by their codes (`core.errors.METHODS`)."""
