"""The loops over pairs, compiled from their own source, where that is wanted.

Nothing is imported and nothing compiled before `load`; without it, or without numba, the loops run
as they are and give the same bits.
"""

import functools
import os
import types
from collections.abc import Callable
from typing import Any

import numpy as np

from core.drive import compiled as drive
from core.output import (
    contact_kernel,
    giving_kernel,
    loop_rows,
    sharing_kernel,
    tied_kernel,
    turn_kernel,
)

SOURCES = (loop_rows, contact_kernel, giving_kernel, tied_kernel, sharing_kernel, turn_kernel)
"""The loops, each of which uses those before it."""

INLINED = {
    *("at", "play", "played", "touch_error", "shift", "start", "balance", "freed", "carry"),
    *("carried_errors", "judged", "largest", "hardest", "close_by", "fitting", "ahead", "clear"),
    *("place", "press", "widest", "at_most", "piece"),
    "part",
}
"""Functions that take more rows than a call should hand on: it takes a third of a microsecond."""

CALLED = ("poses", "values", "narrow", "pieces")
"""Functions that are called from outside of the loops. The others have no way in from Python, each
of which would be compiled with all that the function calls.
"""


def _copies(made: Callable[[Any], Any], others: dict[str, Any]) -> dict[str, Any]:
    """The sources' functions, made anew: they see each other and the others, not the plain ones."""
    names = {name: each for one in SOURCES for name, each in vars(one).items()} | others
    names["SOURCES"] = (__file__, *(one.__file__ for one in SOURCES))
    for one in SOURCES:
        for name, plain in vars(one).items():
            own = isinstance(plain, types.FunctionType) and plain.__module__ == one.__name__
            if own and name not in others:
                copy = types.FunctionType(plain.__code__, names, name, plain.__defaults__)
                copy.__module__ = plain.__module__
                names[name] = made(copy)
    return names


def in_place_of(**others: Callable[..., Any]) -> Any:
    """The loops, interpreted, with other functions in the place of some.

    Parameters
    ----------
    **others : callable
        By the names of those that they stand for.

    Returns
    -------
    namespace
        As `at_hand` gives it.
    """
    names = _copies(lambda copy: copy, others)
    return types.SimpleNamespace(**names, row=list, table=np.ndarray.tolist, threads=1)


plain = functools.cache(in_place_of)
"""The loops, interpreted."""

PLAIN = plain()

_at_hand: Callable[..., Any] = plain


def at_hand() -> Any:
    """The functions of all `SOURCES`: compiled once `load` was called, else as they are.

    Returns
    -------
    namespace
        Its `row` and `table` make what they take, lists or arrays; `threads` says how many can
        run at once.
    """
    return _at_hand()


def load(say: drive.Say = None) -> None:
    """Have the loops and the engine compiled from now on: each loop with its first call, or read
    from numba's cache.

    Parameters
    ----------
    say : callable, optional
        As `core.drive.compiled.load` takes it.

    Raises
    ------
    ImportError
        If numba is not installed.
    """
    global _at_hand
    drive.load(say)
    _at_hand = functools.partial(_compiled, say)


@functools.cache
def _compiled(say: drive.Say) -> types.SimpleNamespace:
    def made(copy: Any) -> Any:
        inlined, called = copy.__name__ in INLINED, copy.__name__ in CALLED
        return drive.dispatcher(plain=copy, say=say, inlined=inlined, called=called)

    names = _copies(made, {})
    return types.SimpleNamespace(
        **{name: names[name] for name in CALLED},
        row=functools.partial(np.array, dtype=float),
        table=np.ascontiguousarray,
        threads=len(os.sched_getaffinity(0)),
    )
