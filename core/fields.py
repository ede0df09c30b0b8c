"""Fields of the design document: an input says at its dataclass what a form, a description of the
API and a reader of core have to know of it. The text below a field is its help.

Values are SI in core. Title, limits and step are those of the document as users write it, in the
unit that ends the name there: `pin_radius` with the unit ``mm`` is ``pin_radius_mm``.
"""

import ast
import inspect
import sys
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field
from functools import cache, partial
from itertools import pairwise
from typing import Any, Literal, NamedTuple

SMALLEST = 1e-12
LARGEST = 1e12
"""Limits of a positive quantity in its unit: within these limits no result leaves the range of
numbers, and none loses digits at its lower end."""

Forms = tuple[tuple[str, ...], ...]
"""Forms of which exactly one has to be given, by names of fields; an empty form makes all
optional."""

Kinds = Mapping[Any, tuple[tuple[str, ...], tuple[str, ...]]]
"""Needed and optional fields of each kind; None for no kind. Fields in no kind belong to all."""


class Rule(NamedTuple):
    """Rule between two fields, by their paths, read as a sentence: the field that is refused if the
    rule fails, and the other field that the refusal names.
    """

    field: str  # field that is refused
    rule: Literal["only_one", "needed_beside", "needed"]  # relation that has to hold
    other: str  # field that the refusal names


@dataclass(frozen=True, slots=True, kw_only=True)
class Input:
    """Words, unit and limits of an input of the document."""

    title: str  # name, as engineers write it; none for a part with fields of its own
    symbol: str  # symbol in formulas
    unit: str  # end of the name in the document, a key of `app.units.UNITS`
    limits: Mapping[str, Any]  # `ge`, `gt`, `le`, `lt` of a number, or of each in a list
    # Least and largest length of a list, and of the lists in it; None for no limit.
    lengths: tuple[tuple[int | None, int | None], ...] = ()
    step: float | None = None  # change by the arrow keys
    advanced: bool = False  # True if the form may hide the field
    options: tuple[str, ...] = ()  # names that the form offers
    alias: str = ""  # name in the document, if it is no name in Python
    pattern: str = ""  # form of a text, which its dataclass checks
    # True if small values other than 0 are refused, as they lose digits.
    or_zero: bool = False
    # True if the document may leave a needed value out, as another one gives it.
    filled: bool = False
    # True if the document leaves the default out, so that it counts as not given.
    silent: bool = False


def quantity(
    title: str = "",
    symbol: str = "",
    unit: str = "",
    *,
    default: Any = MISSING,
    ge: float | None = None,
    gt: float | None = None,
    le: float | None = None,
    lt: float | None = None,
    **more: Any,
) -> Any:
    """Field of a dataclass with its `Input`, to which `more` adds."""
    limits = {"ge": ge, "gt": gt, "le": le, "lt": lt}
    given = {name: limit for name, limit in limits.items() if limit is not None}
    own = Input(title=title, symbol=symbol, unit=unit, limits=given, **more)
    return field(default=default, metadata={"input": own})


size = partial(quantity, ge=SMALLEST, le=LARGEST)
"""Positive quantity."""

optional_size = partial(size, default=None)
"""Positive quantity that may be absent."""


def help_of(kind: type) -> dict[str, str]:
    """Texts below the fields of a dataclass and of those that it extends, in one line each."""
    own: dict[str, str] = {}
    for each in reversed(kind.__mro__[:-1]):
        own |= _texts(each.__module__).get(each.__name__, {})
    return own


@cache
def _texts(module: str) -> dict[str, dict[str, str]]:
    """Texts below the fields of the classes of a module, by class and field."""
    found: dict[str, dict[str, str]] = {}
    for node in ast.parse(inspect.getsource(sys.modules[module])).body:
        if isinstance(node, ast.ClassDef):
            own = found.setdefault(node.name, {})
            for each in pairwise(node.body):
                match each:
                    case ast.AnnAssign(target=ast.Name(name)), ast.Expr(ast.Constant(str(text))):
                        own[name] = " ".join(text.split())
    return found
