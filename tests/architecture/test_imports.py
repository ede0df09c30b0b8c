"""Tests and benchmarks import oracles, each other only to be tested; exact answers know no core."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent
FILES = sorted([*ROOT.glob("tests/**/*.py"), *ROOT.glob("benchmarks/*.py")])
ORACLES = "tests.oracles"
EXACT = {f"{ORACLES}.{name}" for name in ("balls", "crank_planetary", "hertz", "precession")}
EXACT |= {f"{ORACLES}.{name}" for name in ("rollers", "shaft")}


def imported(source: str) -> Iterator[str]:
    """Every module that a source imports, and every name that it takes from one."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports name the whole module"
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def belongs(name: str, importer: str) -> bool:
    """Whether a module may import this name."""
    top = name.split(".")[0]
    if importer in EXACT:
        return top not in {"app", "core"} and (top != "tests" or name.startswith(ORACLES))
    if any(part.startswith("test_") for part in name.split(".")):
        return False
    if importer.startswith((ORACLES, "benchmarks")) and top == "tests":
        return name.startswith(ORACLES)
    return top != "benchmarks" or importer.startswith(("benchmarks", "tests.benchmarks"))


def module(file: Path) -> str:
    return ".".join(file.relative_to(ROOT).with_suffix("").parts)


@pytest.mark.parametrize("file", FILES, ids=module)
def test_a_file_imports_what_it_may(file: Path) -> None:
    names = imported(file.read_text(encoding="utf-8"))
    assert [name for name in names if not belongs(name, module(file))] == []


def test_the_exact_answers_are_there() -> None:
    assert {module(file) for file in FILES} >= EXACT


@pytest.mark.parametrize(
    ("importer", "source"),
    [
        ("tests.core.test_hertz", "from benchmarks.honesty import judge"),
        ("tests.core.test_hertz", "import benchmarks"),
        ("tests.oracles.fuzz", "import benchmarks.fuzz"),
        ("tests.core.test_hertz", "from tests.reference.test_hertz import exact_pressure"),
        ("tests.core.test_hertz", "from tests.reference import test_hertz"),
        ("benchmarks.page", "from tests.browser.conftest import browser"),
        ("tests.oracles.fuzz", "from tests.running_service import running_service"),
        ("tests.oracles.hertz", "def f():\n    import core.hertz"),
    ],
)
def test_the_check_sees_what_is_wrong(importer: str, source: str) -> None:
    assert not any(belongs(name, importer) for name in imported(source))
