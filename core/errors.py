"""What a calculation can refuse, and why.

Both errors speak of core parameters by name, in SI units; whoever shows them to a user puts in
that user's own field names and units.
"""


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
    limit : str
        What it has to be, as the rest of a sentence. Other parameters are named in braces:
        ``"must be larger than {pin_radius}"``.
    """

    def __init__(self, parameter: str, value: object, limit: str) -> None:
        super().__init__(f"{parameter} = {value!r} {limit}")
        self.parameter = parameter
        self.value = value
        self.limit = limit


class ImpossibleMechanism(CalculationError):
    """Every parameter is allowed, and yet the mechanism cannot exist or cannot work.

    Parameters
    ----------
    what : str
        What cannot be, as a sentence without its full stop.
    where : dict of str to float, optional
        Position at which it happens: name of a core quantity to its value in SI units.
    """

    def __init__(self, what: str, where: dict[str, float] | None = None) -> None:
        self.what = what
        self.where = where or {}
        place = ", ".join(f"{name} = {value!r}" for name, value in self.where.items())
        super().__init__(f"{what} at {place}" if place else what)
