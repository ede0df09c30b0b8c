"""What a calculation can refuse: by a code with parameters, whose words are in `core.codes`."""

from typing import TypeVar

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
