"""The loops over pairs, compiled from their own source, where that is wanted.

Nothing is imported and nothing compiled before `load`; without it, or without numba, the loops run
as they are and give the same bits.
"""

import functools
import os
import types
from contextlib import suppress
from typing import Any

import numpy as np

from core.output import sharing_kernel as source

PLAIN = types.SimpleNamespace(**vars(source), row=list, table=np.ndarray.tolist, threads=1)

_at_hand: types.SimpleNamespace = PLAIN


def at_hand() -> Any:
    """The functions of `core.output.sharing_kernel`: compiled once `load` was called, else as they
    are.

    Returns
    -------
    namespace
        Its `row` and `table` make what they take, lists or arrays; `threads` says how many can
        run at once.
    """
    return _at_hand


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
    _at_hand = _compiled()


@functools.cache
def _compiled() -> types.SimpleNamespace:
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_CACHE_LOCATOR_CLASSES", f"{__name__}.{Place.__name__}")
    import numba

    names = vars(source).copy()  # they see each other, not the plain ones
    for name, plain in vars(source).items():
        if isinstance(plain, types.FunctionType) and plain.__module__ == source.__name__:
            copy = types.FunctionType(plain.__code__, names, name, plain.__defaults__)
            copy.__module__, copy.__qualname__ = plain.__module__, plain.__qualname__
            names[name] = numba.njit(cache=True, nogil=True, error_model="numpy")(copy)
    return types.SimpleNamespace(
        **names,
        row=functools.partial(np.array, dtype=float),
        table=np.ascontiguousarray,
        threads=len(os.sched_getaffinity(0)),
    )


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
        with suppress(OSError):
            own.ensure_cache_path()
        return own
