"""A random case asked of the service, and its answer held against the exact one."""

from dataclasses import dataclass, field
from functools import cache
from typing import Any

from core.precision import CLASSES
from tests.inputs.in_process import Service
from tests.oracles.answers.calculation import Calculation, Draw

HALF_ULP = 2.0**-54
"""Smaller measured errors count as this: no double can be nearer on average."""


NOTHING_KNOWN = 1.0
"""A stated error from here on says that nothing is known, which no number can make false."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """Result of a case.

    Attributes
    ----------
    extreme : bool
        Of which half it is.
    body : dict
        The request.
    refused : bool
        Whether there was no answer.
    margin : float
        Least ratio of stated to measured error of all numbers.
    measured, stated : float
        Largest errors.
    false : dict of str to (float, float)
        Numbers that are further off than is stated: stated and measured error by pointer.
    unknown : set of str
        Numbers that nothing is known of.
    beyond : bool
        Whether more is stated than the method promises.
    """

    extreme: bool
    body: dict[str, Any]
    refused: bool = False
    margin: float = 0.0
    measured: float = 0.0
    stated: float = 0.0
    false: dict[str, tuple[float, float]] = field(default_factory=dict)
    unknown: frozenset[str] = frozenset()
    beyond: bool = False


@cache
def service() -> Service:
    """The service of this process."""
    return Service()


def outcome(calculation: Calculation, seed: int) -> Outcome:
    """Ask a random case, and hold the answer against the exact one."""
    extreme = bool(seed % 2)
    body = calculation.request(Draw(seed, extreme))
    status, answer = service().post(calculation.path, body)
    if status == 422:
        return Outcome(extreme, body, refused=True)
    assert status == 200, (status, answer, body)
    for part in calculation.part:
        answer = answer[part]
    numbers = calculation.numbers(body, answer)
    whole = answer["accuracy"]["relative_error"]
    errors = {
        pointer: (whole if number.stated is None else number.stated, number.error)
        for pointer, number in numbers.items()
    }
    return Outcome(
        extreme=extreme,
        body=body,
        margin=min(stated / max(error, HALF_ULP) for stated, error in errors.values()),
        measured=max(error for _, error in errors.values()),
        stated=max(stated for stated, _ in errors.values()),
        false={
            pointer: (stated, error)
            for pointer, (stated, error) in errors.items()
            if stated < NOTHING_KNOWN and not error <= stated
        },
        unknown=frozenset(calculation.not_checked(answer, numbers)),
        beyond=whole > CLASSES[answer["accuracy"]["method_code"]],
    )
