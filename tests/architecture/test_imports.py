"""Tests and benchmarks import oracles and inputs, each other only to be tested; `make lint` holds
that oracles import nothing of app and core.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent
FILES = sorted([*ROOT.glob("tests/**/*.py"), *ROOT.glob("benchmarks/*.py")])
ORACLES = "tests.oracles"
INPUTS = "tests.inputs"


def imported(source: str) -> Iterator[str]:
    """Every module that a source imports, and every name that it takes from one."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports name the whole module"
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def belongs(name: str, importer: str) -> bool:
    """True if a module may import the name."""
    top = name.split(".")[0]
    if any(part.startswith("test_") for part in name.split(".")):
        return False
    if importer.startswith(ORACLES) and top == "tests":
        return name.startswith(ORACLES)
    if importer.startswith((INPUTS, "benchmarks")) and top == "tests":
        return name.startswith((ORACLES, INPUTS))
    return top != "benchmarks" or importer.startswith(("benchmarks", "tests.benchmarks"))


def module(file: Path) -> str:
    return ".".join(file.relative_to(ROOT).with_suffix("").parts)


@pytest.mark.slow
def test_a_file_imports_what_it_may() -> None:
    wrong = [
        (module(file), name)
        for file in FILES
        for name in imported(file.read_text(encoding="utf-8"))
        if not belongs(name, module(file))
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("importer", "source"),
    [
        ("tests.core.test_hertz", "from benchmarks.honesty import judge"),
        ("tests.core.test_hertz", "import benchmarks"),
        ("tests.inputs.fuzz", "import benchmarks.fuzz"),
        ("tests.oracles.hertz", "def f():\n    from tests.inputs.checks import REF"),
        ("tests.core.test_hertz", "from tests.reference.test_hertz import exact_pressure"),
        ("tests.core.test_hertz", "from tests.reference import test_hertz"),
        ("benchmarks.page", "from tests.browser.conftest import browser"),
        ("tests.inputs.fuzz", "from tests.running_service import running_service"),
    ],
)
def test_the_check_sees_what_is_wrong(importer: str, source: str) -> None:
    assert not any(belongs(name, importer) for name in imported(source))


def test_processes_of_tests_are_started_by_what_ends_their_groups() -> None:
    started = re.compile(r"subprocess\.(run|Popen|call|check_\w+)\(|os\.(system|spawn\w+|popen)\(")
    own = [each for each in FILES if "tests" in each.parts and started.search(each.read_text())]
    assert [each.name for each in own] == ["children.py"]
