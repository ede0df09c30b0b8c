"""Code of a message and its words."""

from dataclasses import dataclass
from functools import partial
from typing import Literal

Kind = Literal["invalid", "impossible", "limit", "unknown", "check"]


@dataclass(frozen=True, slots=True)
class Code:
    """English words of one code; values in the texts stand in braces."""

    # `invalid`: a parameter is wrong. `impossible`: parameters are allowed, but no such mechanism
    # exists. `limit`: a result strains a limit of validity or has no limit to be judged by, and is
    # given all the same. `unknown`: reason for the status of a check. `check`: a check of designs
    # that calculations without a verdict report.
    kind: Kind
    text: str  # a sentence without full stop; if `invalid`, the part after the parameter's name
    title: str = ""  # name of a warning
    tests: str = ""  # condition under which it is not given
    why: str = ""  # consequence
    mend: str = ""  # remedy


limit, check = partial(Code, "limit"), partial(Code, "check")
