"""Compilation of the engine: each function once, for the array types of its annotations.

Numba keeps compiled functions beside the source, or in ``NUMBA_CACHE_DIR``, for a generic processor
of the kind; the cache may be moved to another machine, and read where it cannot be written.
"""

import functools
import os
import types
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
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
    *("turn_to", "window", "torque_at", "law_alone", "lay", "pose", "stops_at"),
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


def _cache_of(told: Callable[[str], Any]) -> Any:
    """Class of numba's cache that reads nothing that is broken and tolerates failures to write."""
    os.environ.setdefault("NUMBA_CPU_NAME", "generic")
    os.environ.setdefault("NUMBA_OPT", "1")  # higher takes a fifth longer and runs no faster
    for unneeded in ("NUMBA_LOOP_VECTORIZE", "NUMBA_LLVM_REFPRUNE_PASS"):  # loops are short
        os.environ.setdefault(unneeded, "0")
    from numba.core import caching, config

    config.reload_config()  # numba may have been imported before the environment was set

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
    """Pipeline of numba that makes no machine code: all functions become one library, and are
    optimised there.
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
    from numba.core.registry import cpu_target

    told = functools.cache(say or str)
    kept, target = _cache_of(told), cpu_target.target_context
    caches = [(kept(PLAIN[name]), _signature(PLAIN[name])) for name in CALLED]

    def read() -> list[Any]:
        return [cache.load_overload(signature, target) for cache, signature in caches]

    found = read()
    if None in found:
        told(MADE)  # the function told may have waited until another process has compiled
        found = read()
    if None in found:
        found = _made(target)
        for (cache, signature), each in zip(caches, found, strict=True):
            cache.save_overload(signature, each)
    vars(engine).update(PLAIN)
    for name, each in zip(CALLED, found, strict=True):
        called = numba.njit(**OPTIONS)(PLAIN[name])
        called.add_overload(each)
        called.disable_compile()
        setattr(engine, name, called)


def _signature(plain: Any) -> Any:
    """Numba's signature of a function by its annotations."""
    hints = get_type_hints(plain, include_extras=True)
    gives = kind(hints.pop("return"))
    return gives(*(kind(each) for each in hints.values()))


def _made(target: Any) -> list[Any]:
    """Results of numba for the functions that are called, all in one library."""
    from numba.core.compiler_lock import global_compiler_lock

    library, results = target.codegen().create_library("engine"), []
    library.enable_object_caching()
    with global_compiler_lock:
        with _types_kept(target.typing_context):
            parts = [_part(name, no_cpython_wrapper=False) for name in CALLED]
        for each in parts:
            each.library.finalize()
            library._final_module.link_in(each.library._final_module, preserve=True)
        library.finalize()
        for each in parts:
            entry = target.get_executable(library, each.fndesc, each.environment)
            results.append(each._replace(library=library, entry_point=entry))
    return results


@contextmanager
def _types_kept(context: Any) -> Iterator[None]:
    """Have numba keep the types of operations, for each of which it tries dozens of templates."""
    asked = context.resolve_function_type
    kept = functools.cache(lambda function, args: asked(function, args, {}))
    context.resolve_function_type = lambda function, args, named: (
        asked(function, args, named) if named else kept(function, args)
    )
    try:
        yield
    finally:
        del context.resolve_function_type


def _part(name: str, no_cpython_wrapper: bool = True) -> Any:
    """Compile a function after those that it calls, which are found in the engine's module."""
    import numba

    for called in PLAIN[name].__code__.co_names:
        if called in PLAIN and vars(engine)[called] is PLAIN[called]:
            _part(called)
    options = OPTIONS | {"no_cpython_wrapper": no_cpython_wrapper, "forceinline": name in INLINED}
    part = numba.njit(**options, pipeline_class=_linked())(PLAIN[name])
    part.compile(signature := _signature(PLAIN[name]))
    part.disable_compile()
    setattr(engine, name, part)
    return part.overloads[signature.args]
