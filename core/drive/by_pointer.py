"""Named tuples of arrays that compiled functions pass to each other by one pointer, and elements of
arrays by indices that are not negative.

Numba passes a tuple of arrays as its numbers one by one, some three hundred for those of the
engine, at each call. The arrays of a tuple stay where they are during a call, so that the compiler
may read their places once. Arrays are contiguous. Numba would look at each index whether it counts
from the end.
"""

import operator
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba.core import cgutils, types
from numba.core.datamodel import models
from numba.core.typing.templates import AttributeTemplate
from numba.extending import (
    NativeValue,
    infer_getattr,
    lower_builtin,
    lower_getattr_generic,
    register_model,
    typeof_impl,
    unbox,
)


class Held(types.Type):
    """Pointer to a named tuple of arrays."""

    def __init__(self, held: Any):
        self.held = held
        super().__init__(f"Held({held})")


@register_model(Held)
class HeldModel(models.PrimitiveModel):  # type: ignore[misc]
    """Machine's type of a pointer to a named tuple."""

    def __init__(self, manager: Any, of: Held):
        super().__init__(manager, of, ir.PointerType(manager[of.held].get_value_type()))


@infer_getattr
class HeldFields(AttributeTemplate):  # type: ignore[misc]
    """Types of the fields of a named tuple."""

    key = Held

    def generic_resolve(self, of: Held, name: str) -> Any:
        """Type of a field."""
        return of.held[of.held.fields.index(name)]


@lower_getattr_generic(Held)  # type: ignore[untyped-decorator]
def _field(context: Any, builder: Any, of: Held, pointer: Any, name: str) -> Any:
    """Read an array by its numbers, which nothing changes during a call."""
    index = of.held.fields.index(name)
    place = cgutils.gep_inbounds(builder, pointer, 0, index)
    return _read(builder, place, context.get_value_type(of.held[index]))


def _read(builder: Any, place: Any, kind: Any) -> Any:
    if not isinstance(kind, ir.Aggregate):
        read = builder.load(place)
        read.set_metadata("invariant.load", builder.module.add_metadata([]))
        return read
    whole = ir.Constant(kind, ir.Undefined)
    for index, part in enumerate(kind.elements):
        each = _read(builder, cgutils.gep_inbounds(builder, place, 0, index), part)
        whole = builder.insert_value(whole, each, index)
    return whole


@unbox(Held)  # type: ignore[untyped-decorator]
def _unboxed(of: Held, given: Any, context: Any) -> NativeValue:
    """Take a named tuple of Python apart and hold it on the stack."""
    native = context.unbox(of.held, given)
    place = cgutils.alloca_once_value(context.builder, native.value)
    return NativeValue(place, is_error=native.is_error, cleanup=native.cleanup)


def hold(*, kind: type, held: Any) -> Held:
    """Type of a pointer to a class of named tuples, by which these are passed from now on."""
    found = Held(held)
    typeof_impl.register(kind)(lambda *_: found)
    return found


PLACE = types.Array, types.UniTuple  # type: ignore[attr-defined]
"""Types of an array and of the indices of an element."""


def _element(context: Any, builder: Any, array: Any, given: Any, index: Any) -> Any:
    """Pointer to an element of a contiguous array."""
    model = context.data_model_manager[array]
    sizes = cgutils.unpack_tuple(builder, model.get(builder, given, "shape"))
    place, *further = cgutils.unpack_tuple(builder, index)
    for size, each in zip(sizes[1:], further, strict=True):
        place = builder.add(builder.mul(place, size), each)
    return cgutils.gep_inbounds(builder, model.get(builder, given, "data"), place)


@lower_builtin(operator.getitem, *PLACE)  # type: ignore[untyped-decorator]
def _read_element(context: Any, builder: Any, signature: Any, args: Any) -> Any:
    """Read an element of an array of several axes."""
    return builder.load(_element(context, builder, signature.args[0], *args))


@lower_builtin(operator.setitem, *PLACE, types.Float)  # type: ignore[untyped-decorator]
def _set_element(context: Any, builder: Any, signature: Any, args: Any) -> None:
    """Set an element of an array of several axes."""
    array, _, kind = signature.args
    number = context.cast(builder, args[2], kind, array.dtype)
    builder.store(number, _element(context, builder, array, *args[:2]))
