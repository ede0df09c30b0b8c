"""The engine compiled: each function once, for the arrays that its annotations say."""

import types
from typing import Any, get_type_hints

from core.drive import engine

PLAIN = {
    name: each
    for name, each in vars(engine).items()
    if isinstance(each, types.FunctionType) and each.__module__ == engine.__name__
}
"""Its functions as they are."""

CALLED = "positions", "narrow", "unloaded", "gaps", "goes_together"
"""Functions that are called from outside of it."""

INLINED = "touch", "pin", "lobe", "slopes", "press", "turned", "moved", "law", "disc_at", "bent"
"""Functions that are called at each contact."""


def kind(annotation: Any) -> Any:
    """Numba's type of an annotation of the engine."""
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


def load() -> None:
    """Have the engine compiled from now on: read from numba's cache, or made now.

    Raises
    ------
    ImportError
        If numba is not installed.
    """
    for name in PLAIN:
        make(name)


def make(name: str) -> None:
    """Compile a function of the engine after those that it calls."""
    import numba

    plain = PLAIN[name]
    if vars(engine)[name] is not plain:
        return
    for called in plain.__code__.co_names:
        if called in PLAIN:
            make(called)
    hints = get_type_hints(plain, include_extras=True)
    gives = kind(hints.pop("return"))
    signature = gives(*(kind(each) for each in hints.values()))
    # The engine makes no arrays: what it is given is held by who calls it, not counted here.
    options = {"cache": True, "nogil": True, "error_model": "numpy", "_nrt": False}
    options |= {"forceinline": name in INLINED}
    options |= {"no_cpython_wrapper": name not in CALLED, "no_cfunc_wrapper": True}
    setattr(engine, name, numba.njit(signature, **options)(plain))
