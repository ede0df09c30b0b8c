"""Exports of core are documented, and the documentation names things that exist."""

import ast
import dataclasses
import importlib
import inspect
import pkgutil
import re
import tomllib
from pathlib import Path
from types import FunctionType, ModuleType

import pytest

import core
from core.fields import help_of

ROOT = Path(__file__).parent.parent.parent
MODULES = [
    importlib.import_module(found.name) for found in pkgutil.walk_packages(core.__path__, "core.")
]


def own(module: ModuleType, kind: type) -> list:
    """Public functions or classes that the module itself defines."""
    return [
        member
        for name, member in vars(module).items()
        if isinstance(member, kind)
        and member.__module__ == module.__name__
        and not name.startswith("_")
    ]


def methods(cls: type) -> list[FunctionType]:
    """Public methods that the class writes itself."""
    plain = [getattr(member, "__func__", member) for member in vars(cls).values()]
    return [
        each
        for each in plain
        if isinstance(each, FunctionType) and not each.__name__.startswith("_")
    ]


ORDERED = {
    "core.arrays.larger",
    "core.arrays.smaller",
    "core.arrays.where",
    "core.arrays.known_where",
    "core.arrays.refuse",
    "core.checks.check.judged_by",
    "core.checks.check.verdict",
    "core.checks.crank_planetary.crank_check",
    "core.design.document.changed",
    "core.design.document.value_at",
    "core.design.refusals.named",
    "core.errors.required",
    "core.fields.answer",
    "core.fields.answered",
    "core.fields.quantity",
    "core.output.force_laws.depressed_cubic_roots",
    "core.output.force_bounds.least_total",
    "core.output.force_bounds.most_summits",
    "core.output.force_bounds.next_place",
}
"""Functions whose arguments have an order of their own: a polynomial's coefficients, the ends of a
stretch, what NumPy's `where` takes, a check's value and limit, a field's title, symbol and unit."""

KERNELS = {
    "core.drive.engine",
}
"""Loops that are compiled as well, which knows no arguments by keyword; not for other packages."""

CLASSES = [cls for module in MODULES for cls in own(module, type)]
FUNCTIONS = [function for module in MODULES for function in own(module, FunctionType)]
DATACLASSES = [cls for cls in CLASSES if "__dataclass_fields__" in vars(cls)]  # their own fields
RECORDS = [cls for cls in CLASSES if "_fields" in vars(cls) and cls.__module__ not in KERNELS]
CALLABLES = FUNCTIONS + [method for cls in CLASSES for method in methods(cls)]


def identity(documented) -> str:
    return f"{documented.__module__}.{documented.__qualname__}"


def section(documented, title: str) -> list[str]:
    """Names that a numpydoc section lists, in order; empty where there is no such section."""
    text = inspect.getdoc(documented) or ""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^[^\n]+\n-{{3,}}$|\Z)", text, re.M | re.S)
    if found is None:
        return []
    heads = re.findall(r"^(\*{0,2}\w[\w, *]*?)(?: :|$)", found[1], re.M)
    return [name.strip("* ") for head in heads for name in head.split(",")]


def commented(cls: type) -> set[str]:
    """Fields with a comment behind or above them, or whose type has their name and says it."""
    lines = inspect.getsource(cls).splitlines()
    found = set()
    for field in ast.parse("\n".join(lines)).body[0].body:
        if isinstance(field, ast.AnnAssign):
            name = field.target.id
            types = re.sub(r"\B(?=[A-Z])", "_", ast.unparse(field.annotation)).lower()
            behind = lines[field.end_lineno - 1][field.end_col_offset :]
            above = lines[field.lineno - 2].strip()
            if re.search(rf"\b{name.removesuffix('s')}s?\b", types) or (
                behind.startswith("  # ") or above.startswith("# ")
            ):
                found.add(name)
    return found


def test_every_public_name_has_a_docstring():
    every = [*MODULES, *CLASSES, *CALLABLES]
    assert [each for each in every if not (each.__doc__ or "").strip()] == []
    # the signature is no description
    assert [each for each in every if each.__doc__.strip().startswith(f"{each.__name__}(")] == []


HANGING = set(
    re.findall(
        r"\w+",
        "and as but else he it its likewise of so such that them these they this those what where "
        "whether which whose",
    )
)
"""First words of texts that hang on others or are no sentence, in lower case."""


def hangs(text: str) -> bool:
    """True if a docstring begins with a word of `HANGING`, or with "The same"."""
    first, second, *_ = [*(word.strip(",.:").lower() for word in text.split()), "", ""]
    return first in HANGING or (first, second) == ("the", "same")


@pytest.mark.parametrize("place", ["core", "app", "clients", "benchmarks", "tests"])
def test_no_docstring_begins_as_if_it_went_on(place):
    kinds = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    found = [
        f"{path.relative_to(ROOT)} {getattr(node, 'name', '')}: {text.splitlines()[0]}"
        for path in sorted((ROOT / place).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, kinds) and hangs(text := ast.get_docstring(node) or "")
    ]
    assert found == []


def test_documented_parameters_are_those_of_the_signature():
    wrong = {}
    for function in CALLABLES:
        documented = section(function, "Parameters")
        actual = list(inspect.signature(function).parameters)
        if documented != [name for name in actual if name in documented]:
            wrong[identity(function)] = documented, actual
    assert wrong == {}


@pytest.mark.slow
def test_every_field_of_a_record_says_what_it_is():
    wrong = {}
    for cls in DATACLASSES + RECORDS:
        documented = section(cls, "Attributes") + section(cls, "Parameters")
        fields = getattr(cls, "_fields", None) or [each.name for each in dataclasses.fields(cls)]
        said = {*documented, *commented(cls), *help_of(cls)}
        silent = {name for name in inspect.get_annotations(cls) if not name.isupper()} - said
        if silent or documented != [name for name in fields if name in documented]:
            wrong[identity(cls)] = documented, silent
    assert wrong == {}


def test_inputs_and_results_are_frozen():
    assert [cls for cls in DATACLASSES if not cls.__dataclass_params__.frozen] == []


def test_several_arguments_are_given_by_keyword():
    """Two floats in the wrong order would pass unseen."""
    wrong = {}
    for function in FUNCTIONS:
        positional = [
            parameter.name
            for parameter in inspect.signature(function).parameters.values()
            if parameter.kind is parameter.POSITIONAL_OR_KEYWORD
        ]
        free = identity(function) in ORDERED or function.__module__ in KERNELS
        if len(positional) > 1 and not free:
            wrong[identity(function)] = positional
    assert wrong == {}


CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"][
    "contracts"
]
ROOMS = {
    room: contract["layers"]
    for contract in CONTRACTS
    for room in contract.get("containers", ())
    if room.startswith("core")
}


@pytest.mark.parametrize("room", ROOMS)
def test_the_module_map_is_the_order_of_the_layers(room):
    text = importlib.import_module(room).__doc__ or ""
    names = re.findall(r"^(\w+)  +\S", text.split("Modules, in reading order")[1], re.M)
    assert names == list(reversed(ROOMS[room]))


def test_every_room_has_a_map():
    packages = {
        found.name for found in pkgutil.walk_packages(core.__path__, "core.") if found.ispkg
    }
    assert packages | {"core"} == set(ROOMS)
