"""Refusals of calculations, results that may be unknown, and the stated error of results.

Refusals and notices carry a code and parameters; the texts of the codes are in `core.codes`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Generic, NamedTuple, Self, TypeVar, overload

from core.codes import CODES
from core.precision import HARDLY_KNOWN

Value = TypeVar("Value")

PLACES = {
    "crank_angle": "crank angle",
    "nutation_angle": "nutation angle",
    "ratio_u12": "ratio u12",
    "roller": "roller",
    "z": "position along the roller, z",
}
"""English names of the quantities that say where a mechanism is impossible."""


class CalculationError(Exception):
    """Base of every refusal of a calculation."""


class InvalidInput(CalculationError):
    """Refusal of one parameter that lies outside the range of a formula or a part.

    `parameter` is a core name, or a path in a list (``rollers[2].z_max``); `value` is in SI units;
    `code` is a key of `CODES` or a code of the caller; `params` fill in the code's text.
    """

    def __init__(self, parameter: str, value: object, code: str, **params: object) -> None:
        what = CODES[code].text.format(**params) if code in CODES else code
        super().__init__(f"{parameter} = {value!r} {what}")
        self.parameter = parameter
        self.value = value
        self.code = code
        self.params = params


class NotKnown(CalculationError):
    """Refusal of a result, because too little of the design is given or a value is too large.

    `code` is a key of `CODES`; `missing` are the core names of the inputs that have to be given;
    `refusal`, of equal code, answers a request for a result that lacks no input; `params` fill in
    the code's text.
    """

    def __init__(
        self, code: str, *missing: str, refusal: InvalidInput | None = None, **params: object
    ) -> None:
        super().__init__(", ".join((code, *missing)))
        self.code = code
        self.missing = missing
        self.refusal = refusal
        self.params = params


class ImpossibleMechanism(CalculationError):
    """Refusal of a mechanism that cannot exist or work although every parameter is in range.

    `where` maps core quantities (keys of `PLACES`) to their values in SI units at which the
    mechanism fails; `parameter` is the core name of the parameter to change, if there is a single
    one; `params` fill in the code's text.
    """

    def __init__(
        self,
        code: str,
        where: dict[str, float] | None = None,
        *,
        parameter: str = "",
        **params: object,
    ) -> None:
        self.code = code
        self.parameter = parameter
        self.where = where or {}
        self.params = params
        what = CODES[code].text.format(**self.where | params)
        place = ", ".join(f"{PLACES[name]} = {value!r}" for name, value in self.where.items())
        super().__init__(f"{what} at {place}" if place else what)


def required(value: Value | None, code: str, *missing: str) -> Value:
    """Return a value, or raise `NotKnown` with the code and the missing core names if it is None.

    >>> required(None, "speed_missing", "load.input_speed")
    Traceback (most recent call last):
    core.errors.NotKnown: speed_missing, load.input_speed
    """
    if value is None:
        raise NotKnown(code, *missing)
    return value


def within(path: str, make: Callable[[], Value], /) -> Value:
    """Part that is made for a place of a document; a refusal names the place."""
    try:
        return make()
    except InvalidInput as error:
        own = error.parameter
        if not own.startswith(f"{path}."):
            error.parameter = f"{path}{own}" if own.startswith("[") else f"{path}.{own}"
        raise


UNKNOWN = (NotKnown, ImpossibleMechanism)
"""Exceptions that leave a result of a design unknown."""


class derived(Generic[Value]):  # noqa: N801 - it is used as `property` is
    """A property that is calculated once; a refusal is kept like a value and raised again."""

    def __init__(self, calculate: Callable[[Any], Value]) -> None:
        self.calculate = calculate
        self.__doc__ = calculate.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name, self.refused = name, f"{name} refused"

    @overload
    def __get__(self, instance: None, owner: type) -> Self: ...

    @overload
    def __get__(self, instance: object, owner: type) -> Value: ...

    def __get__(self, instance: object | None, owner: type) -> Self | Value:
        if instance is None:
            return self
        # Python looks into the instance's __dict__ first: a kept value never comes here again.
        kept: dict[str, Any] = instance.__dict__
        if self.refused in kept:
            raise kept[self.refused].with_traceback(None)
        try:
            value = kept[self.name] = self.calculate(instance)
        except CalculationError as why:
            kept[self.refused] = why
            raise
        return value


def if_known(calculate: Callable[[], Value]) -> Value | None:
    """Result of a calculation, or None if it raises one of `UNKNOWN`."""
    try:
        return calculate()
    except UNKNOWN:
        return None


def is_known(calculate: Callable[[], object]) -> bool:
    """True if a calculation raises none of `UNKNOWN`."""
    try:
        calculate()
    except UNKNOWN:
        return False
    return True


def known_equal(*calculations: Callable[[], object]) -> bool:
    """True if the results of two calculations are known and equal."""
    try:
        one, other = (calculate() for calculate in calculations)
    except CalculationError:
        return False
    return one == other


METHODS = {
    "approximation": "approximation (2018, eq. 5)",
    "arcs_zoomed": "lags of each pair in closed form, extremes over the turn narrowed",
    "bisection": "bisection",
    "bracketing": "sampling, then brackets narrowed to neighbouring numbers",
    "closed_form": "closed form",
    "closed_form_even": "closed form: evenly spaced pairs",
    "closed_form_gaps": "closed form, contacts closed in the order of their gaps",
    "closed_form_newton": "closed form, Newton's method",
    "gauss_legendre_shaft": "Gauss-Legendre along the shaft",
    "gauss_legendre_z": "Gauss-Legendre in z",
    "golden_section": "sampling, golden section",
    "graded_quadrature": "Gauss-Legendre quadrature along z, panels graded to the known "
    "singularities",
    "integral_equation": "integral equation at Chebyshev nodes, Newton's method",
    "mohr": "Mohr's integral in closed form",
    "monte_carlo": "random pieces, percentiles by order statistics",
    "monte_carlo_double": "random pieces, twice the crank angles",
    "monte_carlo_finest": "scatter of the pieces, four times the crank angles",
    "monte_carlo_quarter": "random pieces, a quarter of the crank angles",
    "multiple_closed_form": "closed form in multiple precision",
    "multiple_peak": "peak refined in multiple precision",
    "multiple_tanh_sinh": "tanh-sinh quadrature in multiple precision",
    "newton_bracket": "Newton's method in a bracket",
    "sampling": "sampling",
    "sampling_dense": "four times as many samples, every summit narrowed",
    "sampling_zoomed": "sampling, every summit narrowed",
    "segments_cubic": "segment-exact, roots of a cubic",
    "segments_equal": "segment-exact, equal sharing: largest at a switching angle",
    "segments_roots": "segment-exact, bracketed roots",
    "segments_tanh_sinh": "segment-exact, tanh-sinh quadrature",
    "simpson_phi": "Simpson in phi",
    "simpson_shaft": "Simpson along the shaft",
}
"""Methods of the calculations and of their studies in English, by code."""


class Accuracy(NamedTuple):
    """Method, relative error and effort of a result.

    An `Accuracy` covers all numbers of the result that carries it, unless its field says otherwise.
    """

    method: str  # a key of `METHODS`
    # Bound or estimate of the relative error against the exact value for the input as given:
    # rounding, truncation and the input's own condition together; a float, or an array of designs.
    relative_error: Any
    evaluations: int  # evaluations of the function behind the method; 1 for a formula


@dataclass(frozen=True)
class Notice:
    """A limit of validity that a result exceeds; the number is given all the same."""

    code: str  # a key of `core.codes.CODES`
    # Values that the code's text names: dimensionless numbers and names of core parameters.
    params: dict[str, Any] = field(default_factory=dict)

    @property
    def detail(self) -> str:
        """Text of the notice in English, with the core's names."""
        return CODES[self.code].text.format(**self.params)


def poorly_known(accuracy: Accuracy) -> tuple[Notice, ...]:
    """Notice that hardly anything is known of a result of one design, if its error is above 1 %.

    >>> poorly_known(Accuracy("closed_form", 1e-15, 1))
    ()
    >>> [notice.code for notice in poorly_known(Accuracy("closed_form", 0.5, 1))]
    ['hardly_known']
    """
    error = float(accuracy.relative_error)
    return (Notice("hardly_known", {"error": error}),) if error > HARDLY_KNOWN else ()
