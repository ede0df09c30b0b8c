"""A code, and what is said under it."""

from dataclasses import dataclass
from functools import partial
from typing import Literal

Kind = Literal["invalid", "impossible", "limit", "unknown", "check"]


@dataclass(frozen=True, slots=True)
class Code:
    """What is said under one code, in English.

    Attributes
    ----------
    kind : Kind
        `invalid`: one parameter is wrong. `impossible`: all are allowed, and yet there is no such
        mechanism. `limit`: a result strains a limit of validity, or lacks what it is judged by; it
        is given all the same. `unknown`: why a check stands as it does, where numbers do not say
        it. `check`: a check of designs, of which calculations that have no checks warn or refuse.
    text : str
        Of what is invalid the rest of a sentence that starts with the parameter's name; of what is
        impossible or unknown a sentence without its full stop. What a text names stands in braces.
    title, tests, why, mend : str
        Of a warning its name, what is looked at, why it matters, and what to do about it.
    """

    kind: Kind
    text: str
    title: str = ""
    tests: str = ""
    why: str = ""
    mend: str = ""


limit, check = partial(Code, "limit"), partial(Code, "check")
