"""What follows from a design: worked out when it is asked for, and kept, or why it is not known."""

from collections.abc import Callable
from typing import Any, Generic, Self, TypeVar, overload

from core.errors import CalculationError, ImpossibleMechanism, NotKnown

Value = TypeVar("Value")

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
