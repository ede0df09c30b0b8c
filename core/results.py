"""What every result carries besides its numbers: its accuracy, and the limits it strained."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from core.arrays import Number
from core.codes import CODES
from core.precision import HARDLY_KNOWN

METHODS = {
    "approximation": "approximation (2018, eq. 5)",
    "arcs_zoomed": "lags of each pair in closed form, extremes over the turn narrowed",
    "bisection": "bisection",
    "bracketing": "sampling, then brackets narrowed to neighbouring numbers",
    "clenshaw_curtis_phi": "Clenshaw-Curtis in phi",
    "clenshaw_curtis_shaft": "Clenshaw-Curtis along the shaft",
    "clenshaw_curtis_z": "Clenshaw-Curtis in z",
    "closed_form": "closed form",
    "closed_form_even": "closed form: evenly spaced pairs",
    "closed_form_gaps": "closed form, contacts closed in the order of their gaps",
    "closed_form_newton": "closed form, Newton's method",
    "equal_sharing": "equal sharing (Zyl)",
    "gauss_legendre_phi": "Gauss-Legendre in phi",
    "gauss_legendre_shaft": "Gauss-Legendre along the shaft",
    "gauss_legendre_z": "Gauss-Legendre in z",
    "golden_section": "sampling, golden section",
    "graded_quadrature": "Gauss-Legendre quadrature along z, panels graded to the known "
    "singularities",
    "graded_z": "graded Gauss-Legendre in z",
    "hertz": "Hertz, of a narrow contact",
    "identical_materials": "conformal contact of identical materials",
    "integral_equation": "integral equation at Chebyshev nodes, Newton's method",
    "integral_equation_finest": "integral equation with 128 and 256 terms, extrapolated",
    "integral_equation_terms": "integral equation",
    "locus_support": "locus of the moment: sampled by segments, extremes narrowed",
    "mohr": "Mohr's integral in closed form",
    "monte_carlo": "random pieces, percentiles by order statistics",
    "monte_carlo_double": "random pieces, twice the crank angles",
    "monte_carlo_finest": "scatter of the pieces, four times the crank angles",
    "monte_carlo_half": "random pieces, half the crank angles",
    "monte_carlo_quarter": "random pieces, a quarter of the crank angles",
    "multiple_closed_form": "closed form in multiple precision",
    "multiple_peak": "peak refined in multiple precision",
    "multiple_sorting": "sorting in multiple precision",
    "multiple_tanh_sinh": "tanh-sinh quadrature in multiple precision",
    "newton": "Newton",
    "newton_bracket": "Newton's method in a bracket",
    "sampling": "sampling",
    "sampling_dense": "four times as many samples, every summit narrowed by golden section",
    "sampling_zoomed": "sampling, every summit narrowed by golden section",
    "segment_exact": "segment-exact",
    "segments_cubic": "segment-exact, roots of a cubic",
    "segments_equal": "segment-exact, equal sharing: largest at a switching angle",
    "segments_gauss": "segment-exact, Gauss-Legendre quadrature",
    "segments_roots": "segment-exact, bracketed roots",
    "segments_sampled": "sampled by segments, every summit narrowed",
    "segments_tanh_sinh": "segment-exact, tanh-sinh quadrature",
    "simpson_phi": "Simpson in phi",
    "simpson_shaft": "Simpson along the shaft",
    "simpson_z": "Simpson in z",
    "sorting": "sorting",
    "tanh_sinh_phi": "tanh-sinh in phi",
    "tanh_sinh_shaft": "tanh-sinh along the shaft",
    "tanh_sinh_z": "tanh-sinh in z",
    "trapezoid_phi": "trapezoid in phi",
    "trapezoid_shaft": "trapezoid along the shaft",
    "trapezoid_z": "trapezoid in z",
}
"""Methods of the calculations and of their studies in English, by code."""


class Accuracy(NamedTuple):
    """How a number was got, how wrong it may be, and what it took.

    Of all numbers of the result that carries it, where that says nothing else.
    """

    method: str  # how, a key of `METHODS`
    # Bound or honest estimate of the relative error against the exact value for the input as given:
    # rounding, truncation and the input's own condition together.
    relative_error: Number
    evaluations: int  # how often the function behind the method was evaluated; 1 for a formula


@dataclass(frozen=True)
class Notice:
    """A limit of validity that the result strains; the number is given all the same."""

    code: str  # of the limit, a key of `core.codes.CODES`
    # What its text names: dimensionless numbers, and names of core parameters.
    params: dict[str, Any] = field(default_factory=dict)

    @property
    def detail(self) -> str:
        """What is strained and what it means, in English, with the core's names."""
        return CODES[self.code].text.format(**self.params)


def poorly_known(accuracy: Accuracy) -> tuple[Notice, ...]:
    """Notice that hardly anything is known of a result, where its stated error says so.

    Parameters
    ----------
    accuracy : Accuracy
        Of one design.

    Returns
    -------
    tuple of Notice
        One, or none.

    Examples
    --------
    >>> poorly_known(Accuracy("closed_form", 1e-15, 1))
    ()
    >>> [notice.code for notice in poorly_known(Accuracy("closed_form", 0.5, 1))]
    ['hardly_known']
    """
    error = float(accuracy.relative_error)
    return (Notice("hardly_known", {"error": error}),) if error > HARDLY_KNOWN else ()
