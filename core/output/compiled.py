"""The loops over pairs, compiled from their own source, where that is wanted.

Nothing is imported and nothing compiled before `load`; without it, or without numba, the loops run
as they are and give the same bits.
"""

import functools
import os
import types
from collections.abc import Callable
from contextlib import suppress
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


def load() -> None:
    """Have the loops and the engine compiled from now on: each loop with its first call, or read
    from numba's cache.

    The cache is numba's, beside the source or in ``NUMBA_CACHE_DIR``; it is compiled for any
    processor of its kind, and may be moved to another machine.

    Raises
    ------
    ImportError
        If numba is not installed.
    """
    load_loops()
    drive.load()


def load_loops() -> None:
    """Those of pins in holes alone."""
    global _at_hand
    _compiled()
    _at_hand = _compiled


@functools.cache
def _compiled() -> types.SimpleNamespace:
    names = _dispatchers()
    return types.SimpleNamespace(
        **{name: names[name] for name in CALLED},
        row=functools.partial(np.array, dtype=float),
        table=np.ascontiguousarray,
        threads=len(os.sched_getaffinity(0)),
    )


@functools.cache
def _dispatchers() -> dict[str, Any]:
    """The functions of all sources, each of which numba compiles with its first call."""
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_CACHE_LOCATOR_CLASSES", f"{__name__}.{Place.__name__}")
    import numba

    numba.config.reload_config()  # which reads it as it is imported, by whoever does so first

    def made(copy: Any) -> Any:
        # The loops make no arrays: what they are given is held by who calls them, not counted here.
        options = {"cache": True, "nogil": True, "error_model": "numpy", "_nrt": False}
        options |= {"no_cpython_wrapper": copy.__name__ not in CALLED, "no_cfunc_wrapper": True}
        return numba.njit(forceinline=copy.__name__ in INLINED, **options)(copy)

    return _copies(made, {})


class Place:
    """Where numba keeps what it has compiled; it may be read where it cannot be written."""

    @staticmethod
    def from_function(function: types.FunctionType, file: str) -> Any:
        """What numba asks for the place of a function.

        Parameters
        ----------
        function : function
            To be compiled.
        file : str
            Its source.

        Returns
        -------
        locator
        """
        from numba.core import caching, config

        beside = caching.InTreeCacheLocator(function, file)
        own = caching.UserProvidedCacheLocator(function, file) if config.CACHE_DIR else beside
        read = [os.stat(each) for each in function.__globals__.get("SOURCES", (file,))]
        own.get_source_stamp = lambda: [(each.st_mtime, each.st_size) for each in read]
        with suppress(OSError):
            own.ensure_cache_path()
        return own
