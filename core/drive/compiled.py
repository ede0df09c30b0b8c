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

OPTIONS = {
    "nogil": True,
    "error_model": "numpy",
    "_nrt": False,
    "no_cfunc_wrapper": True,
    "no_rewrites": True,
}
"""Options of numba; reference counting is off, as callers hold all arrays, and so are rewrites of
array expressions, as the engine has none.
"""

MADE = "compiling, once an installation: half a minute or more"

UNUSABLE = "the cache of what is compiled is broken, or cannot be read or written"

Say = Callable[[str], None] | None
"""Function that is called once with `MADE` before a compilation, and once with `UNUSABLE`."""


def kind(annotation: Any) -> Any:
    """Numba's type for an annotation of the engine."""
    from numba import types as of

    from core.drive.by_pointer import hold

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
        held = of.NamedTuple([kind(each) for each in hints.values()], annotation)
        return hold(kind=annotation, held=held)
    return of.Tuple([kind(each) for each in annotation.__args__])


@functools.cache
def _cache_of(say: Say) -> Any:
    """Class of numba's cache that compiles what it cannot read and tolerates failures to write."""
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_OPT", "1")  # higher takes a fifth longer and runs no faster
    for unneeded in ("NUMBA_LOOP_VECTORIZE", "NUMBA_LLVM_REFPRUNE_PASS"):  # loops are short
        os.environ.setdefault(unneeded, "0")
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
            if found is None:
                _take_in(self._py_func)
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


@functools.cache
def _linked() -> type:
    """Pipeline of numba that makes no machine code: its functions become a part of each function
    that calls them, and are optimised there.
    """
    from numba.core.codegen import JITCodeLibrary
    from numba.core.compiler import Compiler

    class Part(JITCodeLibrary):  # type: ignore[misc]
        @property
        def codegen(self) -> "Part":
            return self

        def set_env(self, *_: Any) -> None:
            """Set nothing: the engine has no objects of Python."""

        def get_pointer_to_function(self, _: str) -> int:
            return 0

        def _optimize_final_module(self) -> None:
            pass

        def _finalize_final_module(self) -> None:
            self._finalized = True

    class Linked(Compiler):  # type: ignore[misc]
        def __init__(self, typing: Any, target: Any, _: None, *rest: Any) -> None:
            super().__init__(typing, target, Part(target.codegen(), "part"), *rest)

    return Linked


def load(say: Say = None) -> None:
    """Compile the engine, or read it from numba's cache, and put the result into its module;
    ``say`` is called once if something is compiled, and once if a cache cannot be used.
    """
    import numba

    kept = _cache_of(say)
    made = {}
    for name in CALLED:
        made[name] = numba.njit(**OPTIONS)(PLAIN[name])
        made[name]._cache = kept(PLAIN[name])
        _compile(made[name])
    vars(engine).update(PLAIN | made)


def _compile(found: Any) -> None:
    """Compile a function as its annotations say."""
    hints = get_type_hints(found.py_func, include_extras=True)
    gives = kind(hints.pop("return"))
    found.compile(gives(*(kind(each) for each in hints.values())))
    found.disable_compile()


def _take_in(plain: Any) -> None:
    """Compile what a function calls, and have it found there."""
    import numba

    for name in plain.__code__.co_names:
        if name in PLAIN and vars(engine)[name] is PLAIN[name]:
            _take_in(PLAIN[name])
            options = OPTIONS | {"no_cpython_wrapper": True, "forceinline": name in INLINED}
            part = numba.njit(**options, pipeline_class=_linked())(PLAIN[name])
            _compile(part)
            setattr(engine, name, part)
