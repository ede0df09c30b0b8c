"""What a calculation can refuse, and why.

A refusal is a code with parameters, so that whoever shows it can say it in another language and
with other names; here it is worded in English, with the core's names and SI units. The parameters
`field` and `other` are names of core parameters.
"""

REFUSALS = {
    "at_most": "must be at most {field}, {limit:.9g}",
    "below_working": "must be at least {limit:g}, the torque times its factor",
    "beyond_support": "must be at most {limit:.9g}, half a contact length from the end of {field}",
    "different_length": "must have {expected} entries, has {actual}",
    "different_sum": "must have lengths that add up to {field} and {other}, {needed_length:g} m, "
    "not {given_length:g} m",
    "exclusive": "and {field} exclude each other",
    "finite_number": "must be a finite number",
    "first_order_only": "must be of first order beside {field}: what satellites give is not known "
    "in exact geometry",
    "greater_than": "must be larger than {limit:g}",
    "greater_than_equal": "must be at least {limit:g}",
    "in_carrier": "must be at least half of {field}, {limit:.9g}: the contact would reach into the "
    "carrier",
    "infinite_line": "must not lie at a pole, a multiple of half a turn less {field}: the line is "
    "infinitely long there",
    "larger_than": "must be larger than {field}, {limit:.9g}",
    "less_than": "must be smaller than {limit:g}",
    "less_than_equal": "must be at most {limit:g}",
    "no_cycloid": "must be larger than the eccentricity times 1 more than {field}, {limit:.9g}: "
    "there is no such cycloid",
    "no_class": "must be an ISO 286 class of the table, such as m6 or H7",
    "needed": "or {field} must be given",
    "no_arm": "must not be a multiple of half a turn: there the contact has no arm",
    "no_conformal_pressure": "must have a conformal pressure",
    "no_mesh": "must be at least {limit:.9g}: teeth of this {field} do not mesh any nearer",
    "no_reaction": "must leave the bearings a load: the forces of the satellites cancel",
    "no_sleeve": "must be smaller than twice {field}, {limit:.9g}: there is no room for a sleeve",
    "not_in_table": "must be one of {values}",
    "not_single": "must be one number, not an array",
    "not_zero": "must not be 0",
    "other_pitch": "must be {limit:.9g} from the place of the first satellite, as on the pins",
    "other_branch": "must lie on the same side of the pole, a multiple of half a turn less "
    "{other}, as {field}: the line is infinitely long there",
    "right_angle": "must be smaller than a right angle",
    "roller_without_arm": "puts roller {roller} at a multiple of half a turn: there its "
    "contact has no arm",
    "smaller_than": "must be smaller than {field}, {limit:.9g}",
    "sum_not_one": "must add up to 1, not to {sum:.15g}",
    "too_near": "must be at least {field}, {limit:.9g}, from the places of the other satellites",
    "too_few": "needs a sample of at least {limit:d}",
    "too_many_pairs": "must be at most {limit:d}, with {satellites} satellites",
    "too_many_phases": "must be smaller: there would be more than {limit:d} driving phases",
    "too_short": "must have at least {limit:d} entries",
    "too_short_range": "must be larger than {limit:.3g}: no driving phase is that short",
    "too_thick": "must be at most twice {field}, {limit:.9g}: thicker, the pin itself would touch "
    "the hole",
}
"""What is wrong with one parameter, by code: the rest of a sentence that starts with its name."""

IMPOSSIBLE = {
    "beyond_first_order": "The output would turn by more than a radian, of which first order says "
    "nothing: the contacts are too soft or the position is a dead centre",
    "beyond_hertz": "The contact of satellite {satellite} and pin {pin} would be as wide as the "
    "pin: Hertz's law of contact does not reach so far",
    "cannot_assemble": "Pins and holes press: pin {pin} does not fit into its hole of satellite "
    "{satellite}, and no force of the contacts makes it",
    "dead_centre": "The mechanism cannot transmit torque: no pair drives",
    "no_contact_line": "There is no contact line: the cosine of {field} equals {other}",
    "no_lever": "The contact line of roller {roller} cannot carry a torque: it reaches phi = 0, "
    "at z = 0, where the load has no arm about the axis; keep both its ends on one side of it",
    "no_mechanism": "The holes do not hold their pins, which could pass from one into the next: "
    "they are too large",
    "no_room_in_hole": "The hole of satellite {satellite} is not larger than pin {pin}, or a "
    "deviation leaves nothing of a radius",
    "not_balanced": "The forces cannot be balanced within the range of numbers",
    "not_stable": "The forces do not hold the output: its torque falls as it turns on",
    "overflow": "The numbers given leave the range of numbers: {names} would not be finite",
}
"""What cannot be, by code: a sentence without its full stop."""


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
        What is wrong with it: a key of `REFUSALS`, or of whoever calls.
    **params : object
        What its text names.
    """

    def __init__(self, parameter: str, value: object, code: str, **params: object) -> None:
        super().__init__(f"{parameter} = {value!r} {REFUSALS.get(code, code).format(**params)}")
        self.parameter = parameter
        self.value = value
        self.code = code
        self.params = params


class NotKnown(CalculationError):
    """A result that a design does not have: too little of it is given, or it is too large.

    Parameters
    ----------
    code : str
        Why, a key of `core.checks.kinds.REASONS`.
    *missing : str
        Core names of inputs that would have to be given.
    refusal : InvalidInput, optional
        What is wrong with a request that asks for this result, where nothing is missing.
    """

    def __init__(self, code: str, *missing: str, refusal: InvalidInput | None = None) -> None:
        super().__init__(", ".join((code, *missing)))
        self.code = code
        self.missing = missing
        self.refusal = refusal


class ImpossibleMechanism(CalculationError):
    """Every parameter is allowed, and yet the mechanism cannot exist or cannot work.

    Parameters
    ----------
    code : str
        What cannot be, a key of `IMPOSSIBLE`.
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
        what = IMPOSSIBLE[code].format(**self.where | params)
        place = ", ".join(f"{PLACES[name]} = {value!r}" for name, value in self.where.items())
        super().__init__(f"{what} at {place}" if place else what)
