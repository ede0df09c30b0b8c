"""Fields of the design document and of answers: an input, or a quantity of a result, says at its
dataclass what a form, a description of the API and a reader of core have to know of it. The text
below a field is its help, or the meaning of the quantity.

Values are SI in core. Title, limits and step are those of the document as users write it, in the
unit that ends the name there: `pin_radius` with the unit ``mm`` is ``pin_radius_mm``.
"""

import inspect
import re
import sys
from collections.abc import Callable, Collection, Mapping
from dataclasses import MISSING, dataclass, field
from functools import cache, partial
from itertools import chain
from typing import Any, Literal, NamedTuple, TypeVar, get_type_hints

SMALLEST = 1e-12
LARGEST = 1e12
"""Limits of a positive quantity in its unit: within these limits no result leaves the range of
numbers, and none loses digits at its lower end."""

Forms = tuple[tuple[str, ...], ...]
"""Forms of which exactly one has to be given, by names of fields; an empty form makes all
optional."""

Kinds = Mapping[Any, tuple[tuple[str, ...], tuple[str, ...]]]
"""Needed and optional fields of each kind; None for no kind. Fields in no kind belong to all. The
field of the kind is `KIND` of the dataclass."""


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
    least: float | None = None  # least amount of a number of either sign, which core checks
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


class Output(NamedTuple):
    """Unit, symbol and source of a quantity of a result, as answers have it; in a NamedTuple it
    stands in the type of the field.
    """

    unit: str = ""  # end of the name in answers, a key of `app.units.UNITS`
    symbol: str = ""  # symbol in the nomenclature
    equation: str = ""  # source with the number of the equation, or the formula
    depth: int = 1  # number of axes of an array
    optional: bool = False  # True for a property that raises `NotKnown` without its data


def answer(
    unit: str = "", symbol: str = "", equation: str = "", *, default: Any = MISSING, depth: int = 1
) -> Any:
    """Field of a result that answers have."""
    return field(default=default, metadata={"output": Output(unit, symbol, equation, depth)})


Method = TypeVar("Method", bound=Callable[[Any], Any])


def answered(
    unit: str = "", symbol: str = "", equation: str = "", **more: Any
) -> Callable[[Method], Method]:
    """Decorator of the method of a property that answers have; `more` is of `Output`."""

    def marked(method: Method) -> Method:
        vars(method)["output"] = Output(unit, symbol, equation, **more)
        return method

    return marked


class Quantity(NamedTuple):
    """Quantity of a result with its words."""

    name: str  # name in core
    output: Output
    hint: Any  # type of its values
    meaning: str  # text below the field, or that of the property; empty for none


def quantities_of(kind: Any) -> Collection[Quantity]:
    """Quantities of a result that answers have: fields first, then properties."""
    hints, helps = get_type_hints(kind), help_of(kind)
    outputs = {
        name: each.metadata.get("output")
        for name, each in getattr(kind, "__dataclass_fields__", {}).items()
    } or {
        name: next(iter(getattr(each, "__metadata__", ())), None)
        for name, each in kind.__annotations__.items()
    }
    found = {
        name: Quantity(name, output, hints[name], helps.get(name, ""))
        for name, output in outputs.items()
        if output
    }
    for name, each in chain.from_iterable(vars(owner).items() for owner in reversed(kind.__mro__)):
        method = getattr(each, "fget", None) or getattr(each, "calculate", None)
        if output := getattr(method, "output", None):
            meaning = " ".join((method.__doc__ or "").split())
            found[name] = Quantity(name, output, get_type_hints(method)["return"], meaning)
    return found.values()


class Variants(dict[Any, Any]):
    """Dataclasses of a section by its kind, where None stands for none, with the field `kind`; the
    text `about` stands for a docstring.
    """

    def __init__(
        self,
        kinds: Mapping[Any, Any],
        *,
        title: str,
        help: str,
        default: str | None = None,
        about: str = "",
    ) -> None:
        super().__init__(kinds)
        self.title, self.help, self.default, self.__doc__ = title, help, default, about


def help_of(kind: type) -> dict[str, str]:
    """Texts below the fields of a dataclass and of those that it extends, in one line each."""
    own: dict[str, str] = {}
    for each in reversed(kind.__mro__):
        if each.__module__ != "builtins":
            own |= _texts(each.__module__).get(each.__name__, {})
    return own


CLASS = re.compile(r"^class (\w+)(.*?)(?=^[^\s)]|\Z)", re.MULTILINE | re.DOTALL)
"""A class of a module, and its body."""

STATEMENT = re.compile(r'^    (?:(\w+): |"""(.*?)"""$|[^\s#)\]}])', re.MULTILINE | re.DOTALL)
"""Begin of a statement in the body of a class: the name of a field, or a text."""


@cache
def _texts(module: str) -> dict[str, dict[str, str]]:
    """Texts below the fields of the classes of a module, by class and field."""
    found: dict[str, dict[str, str]] = {}
    for kind, body in CLASS.findall(inspect.getsource(sys.modules[module])):
        own, field = found.setdefault(kind, {}), ""
        for name, text in STATEMENT.findall(body):
            if field and text:
                own[field] = " ".join(text.split())
            field = name
    return found
