"""What a calculation refuses, by a code with parameters, whose words are in `core.codes`; and what
follows from a design: worked out when it is asked for, and kept, or why it is not known.
"""

from collections.abc import Callable
from typing import Any, Generic, Self, TypeVar, overload

from core.codes import CODES

Value = TypeVar("Value")

PLACES = {
    "crank_angle": "crank angle",
    "nutation_angle": "nutation angle",
    "ratio_u12": "ratio u12",
    "roller": "roller",
    "z": "position along the roller, z",
}
"""Names of what says where something cannot be, in English."""


class CalculationError(Exception):
    """Base of every refusal of a calculation."""


class InvalidInput(CalculationError):
    """One parameter lies outside what the formula or the part allows.

    Parameters
    ----------
    parameter : str
        Name of the core parameter, a path where it sits in a list (``rollers[2].z_max``).
    value : object
        The value given, in SI units.
    code : str
        What is wrong with it: a key of `CODES`, or of whoever calls.
    **params : object
        What its text names.
    """

    def __init__(self, parameter: str, value: object, code: str, **params: object) -> None:
        what = CODES[code].text.format(**params) if code in CODES else code
        super().__init__(f"{parameter} = {value!r} {what}")
        self.parameter = parameter
        self.value = value
        self.code = code
        self.params = params


class NotKnown(CalculationError):
    """A result that a design does not have: too little of it is given, or it is too large.

    Parameters
    ----------
    code : str
        Why, a key of `CODES`; that of the refusal, where there is one.
    *missing : str
        Core names of inputs that would have to be given.
    refusal : InvalidInput, optional
        What is wrong with a request that asks for this result, where nothing is missing.
    **params : object
        What its text names.
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
    """Every parameter is allowed, and yet the mechanism cannot exist or cannot work.

    Parameters
    ----------
    code : str
        What cannot be, a key of `CODES`.
    where : dict of str to float, optional
        Position at which it happens: name of a core quantity, a key of `PLACES`, to its value in SI
        units.
    parameter : str
        Name of the core parameter that would have to change, where it is one.
    **params : object
        What its text names besides.
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
    """A value that has to be given.

    Parameters
    ----------
    value : object or None
        The value; None where it is not given.
    code : str
        Why nothing is known without it, a key of `CODES`.
    *missing : str
        Its core name; of several, those of all.

    Returns
    -------
    object

    Raises
    ------
    NotKnown
        If it is not given.

    Examples
    --------
    >>> required(None, "speed_missing", "load.input_speed")
    Traceback (most recent call last):
    core.errors.NotKnown: speed_missing, load.input_speed
    """
    if value is None:
        raise NotKnown(code, *missing)
    return value


UNKNOWN = (NotKnown, ImpossibleMechanism)
"""Why something is not known of a design."""


class derived(Generic[Value]):  # noqa: N801 - it is used as `property` is
    """A property that is worked out once. A refusal is kept like a value: what cannot be solved is
    not solved again for each that asks.
    """

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
        kept: dict[str, Any] = instance.__dict__  # which is looked at before this is
        if self.refused in kept:
            raise kept[self.refused].with_traceback(None)
        try:
            value = kept[self.name] = self.calculate(instance)
        except CalculationError as why:
            kept[self.refused] = why
            raise
        return value


def if_known(calculate: Callable[[], Value]) -> Value | None:
    """What is known, or None.

    Parameters
    ----------
    calculate : callable
        What works it out.

    Returns
    -------
    object or None
        Its result; None where that is not known.
    """
    try:
        return calculate()
    except UNKNOWN:
        return None


def is_known(calculate: Callable[[], object]) -> bool:
    """Whether something is known.

    Parameters
    ----------
    calculate : callable
        What works it out.

    Returns
    -------
    bool
    """
    try:
        calculate()
    except UNKNOWN:
        return False
    return True
