"""Compilation of the engine: each function once, for the array types of its annotations.

Numba keeps compiled functions beside the source, or in ``NUMBA_CACHE_DIR``, for a generic processor
of the kind; the cache may be moved to another machine, and read where it cannot be written.
"""

import functools
import os
import types
from collections.abc import Callable
from contextlib import suppress
from typing import Any, get_type_hints

from core.drive import engine

PLAIN = {
    name: each
    for name, each in vars(engine).items()
    if isinstance(each, types.FunctionType) and each.__module__ == engine.__name__
}
"""Functions of the engine before they are compiled."""

CALLED = "positions", "narrow", "unloaded", "gaps", "goes_together", "pieces"
"""Functions of the engine that are called from outside of it."""

INLINED = {
    *("touch", "pin", "lobe", "slopes", "press", "turned", "moved", "law", "disc_at", "bent"),
    *("turn_to", "window", "torque_at", "law_alone", "lay"),
}
"""Functions that are called at each contact, and inlined for speed."""

MADE = "compiling, once an installation: half a minute or more"

UNUSABLE = "the cache of what is compiled is broken, or cannot be read or written"

Say = Callable[[str], None] | None
"""Function that is called once with `MADE` before a compilation, and once with `UNUSABLE`."""


def kind(annotation: Any) -> Any:
    """Numba's type for an annotation of the engine."""
    from numba import types as of

    kinds = {
        float: of.float64,
        int: of.int64,
        bool: of.boolean,
        type(None): of.void,
        engine.Row: of.float64[::1],
        engine.Table: of.float64[:, ::1],
        engine.Block: of.float64[:, :, ::1],
        engine.Whole: of.int64[:, ::1],
    }
    if annotation in kinds:
        return kinds[annotation]
    if hasattr(annotation, "_fields"):
        hints = get_type_hints(annotation, include_extras=True)
        return of.NamedTuple([kind(each) for each in hints.values()], annotation)
    return of.Tuple([kind(each) for each in annotation.__args__])


@functools.cache
def _cache_of(say: Say) -> Any:
    """Class of numba's cache that compiles what it cannot read and tolerates failures to write."""
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_OPT", "1")  # higher takes a fifth longer and runs no faster
    from numba.core import caching, config

    config.reload_config()  # numba may have been imported before the environment was set
    told = functools.cache(say or str)

    class Place:
        """Folder beside the source or in ``NUMBA_CACHE_DIR``, writable or not."""

        @staticmethod
        def from_function(function: types.FunctionType, file: str) -> Any:
            beside = caching.InTreeCacheLocator, caching.UserProvidedCacheLocator
            return beside[bool(config.CACHE_DIR)](function, file)

    class Results(caching.CompileResultCacheImpl):  # type: ignore[misc]
        _locator_classes = (Place,)

    class Kept(caching.FunctionCache):  # type: ignore[misc]
        _impl_class = Results

        def load_overload(self, *asked: Any) -> Any:
            found = self._found(asked)
            if found is None:
                told(MADE)  # the function told may have waited until another process has compiled
                found = self._found(asked)
            return found

        def _found(self, asked: Any) -> Any:
            try:
                return super().load_overload(*asked)
            except Exception:  # a broken file may raise anything
                told(UNUSABLE)
                with suppress(OSError):
                    self.flush()
                return None

        def save_overload(self, *made: Any) -> None:
            try:
                super().save_overload(*made)
            except OSError:
                told(UNUSABLE)

    return Kept


def dispatcher(*, plain: Any, say: Say, inlined: bool, called: bool) -> Any:
    """Function that numba compiles; reference counting is off, as callers hold all arrays.

    Parameters
    ----------
    plain : function
    say : callable, optional, as in `load`
    inlined, called : bool, if inlined into its callers, and if called from plain Python
    """
    kept = _cache_of(say)
    import numba

    options = {"nogil": True, "error_model": "numpy", "_nrt": False, "no_cfunc_wrapper": True}
    ways = {"forceinline": inlined, "no_cpython_wrapper": not called}
    found = numba.njit(**options, **ways)(plain)
    found._cache = kept(plain)
    return found


def load(say: Say = None) -> None:
    """Compile the engine, or read it from numba's cache, and put the result into its module;
    ``say`` is called once if something is compiled, and once if a cache cannot be used.
    """
    for name in PLAIN:
        _make(name, say)


def _make(name: str, say: Say) -> None:
    """Compile a function of the engine after the functions that it calls."""
    plain = PLAIN[name]
    if vars(engine)[name] is not plain:
        return
    for called in plain.__code__.co_names:
        if called in PLAIN:
            _make(called, say)
    found = dispatcher(plain=plain, say=say, inlined=name in INLINED, called=name in CALLED)
    hints = get_type_hints(plain, include_extras=True)
    gives = kind(hints.pop("return"))
    found.compile(gives(*(kind(each) for each in hints.values())))
    found.disable_compile()
    setattr(engine, name, found)
