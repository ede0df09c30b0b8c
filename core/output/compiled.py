"""The loops over pairs, compiled from their own source, where that is wanted.

Nothing is imported and nothing compiled before `load`; without it, or without numba, the loops run
as they are and give the same bits.
"""

import functools
import os
import sys
import types
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

import numpy as np

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
    *("reach", "part", "between", "pins_at", "held", "linked"),
}
"""Functions that take more rows than a call should hand on: it takes a third of a microsecond."""


def _copies(
    made: Callable[[Any], Any], others: dict[str, Any], over: types.ModuleType | None
) -> dict[str, Any]:
    """The sources' functions, and over them those of another module, made anew: they see each other
    and the others, not the plain ones.
    """
    sources = [*SOURCES] if over is None else [*SOURCES, over]
    names = {name: each for one in sources for name, each in vars(one).items()} | others
    names["SOURCES"] = tuple(dict.fromkeys([__file__, *(one.__file__ for one in _read(over))]))
    for one in sources:
        for name, plain in vars(one).items():
            own = isinstance(plain, types.FunctionType) and plain.__module__ == one.__name__
            if own and name not in others:
                copy = types.FunctionType(plain.__code__, names, name, plain.__defaults__)
                copy.__module__ = plain.__module__
                copy.__qualname__ = name if over is None else f"{name}_{over.__name__}"
                names[name] = made(copy)
    return names


def _borrowed(over: types.ModuleType | None) -> Iterator[tuple[str, types.FunctionType]]:
    """Functions that a module has of others of these loops, by its names for them."""
    if over is None:
        return
    for name, plain in vars(over).items():
        others = isinstance(plain, types.FunctionType) and plain.__module__ != over.__name__
        if others and plain.__module__.startswith("core."):
            yield name, plain


def _read(over: types.ModuleType | None) -> Iterator[types.ModuleType]:
    """Modules whose change changes what a module becomes: what it borrows may be inlined."""
    yield from SOURCES
    if over is not None:
        yield over
        for borrowed in sorted({each.__module__ for _, each in _borrowed(over)}):
            yield from _read(sys.modules[borrowed])


def in_place_of(over: types.ModuleType | None = None, **others: Callable[..., Any]) -> Any:
    """The loops, interpreted, with other functions in the place of some.

    Parameters
    ----------
    over : module, optional
        Loops over the same pairs whose functions stand for those of the same names.
    **others : callable
        By the names of those that they stand for.

    Returns
    -------
    namespace
        As `at_hand` gives it.
    """
    names = _copies(lambda copy: copy, others, over)
    return types.SimpleNamespace(**names, row=list, table=np.ndarray.tolist, threads=1)


PLAIN = in_place_of()

_at_hand: types.SimpleNamespace = PLAIN


def at_hand(over: types.ModuleType | None = None) -> Any:
    """The functions of all `SOURCES`: compiled once `load` was called, else as they
    are.

    Parameters
    ----------
    over : module, optional
        As `in_place_of` takes it.

    Returns
    -------
    namespace
        Its `row` and `table` make what they take, lists or arrays; `threads` says how many can
        run at once.
    """
    if over is None:
        return _at_hand
    return plain(over) if _at_hand is PLAIN else _compiled(over)


plain = functools.cache(in_place_of)
"""The loops with another module over them, interpreted."""


def load() -> None:
    """Have the loops compiled from now on: each with its first call, or read from numba's cache.

    The cache is numba's, beside the source or in ``NUMBA_CACHE_DIR``; it is compiled for any
    processor of its kind, and may be moved to another machine.

    Raises
    ------
    ImportError
        If numba is not installed.
    """
    global _at_hand
    _at_hand = _compiled(None)


@functools.cache
def _compiled(over: types.ModuleType | None) -> types.SimpleNamespace:
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_CACHE_LOCATOR_CLASSES", f"{__name__}.{Place.__name__}")
    import numba

    of_others = {
        name: getattr(_of(plain.__module__), plain.__name__) for name, plain in _borrowed(over)
    }

    def made(copy: Any) -> Any:
        # The loops make no arrays: what they are given is held by who calls them, not counted here.
        options = {"cache": True, "nogil": True, "error_model": "numpy", "_nrt": False}
        return numba.njit(forceinline=copy.__name__ in INLINED, **options)(copy)

    names = _copies(made, of_others, over)
    return types.SimpleNamespace(
        **names,
        row=functools.partial(np.array, dtype=float),
        table=np.ascontiguousarray,
        threads=len(os.sched_getaffinity(0)),
    )


def _of(module: str) -> types.SimpleNamespace:
    """The compiled functions of a module."""
    return _compiled(None if sys.modules[module] in SOURCES else sys.modules[module])


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
