"""Mutation test: a seed draws changes of formulas in core, and each should make a test fail.

`make mutations BASE=rev SEED=number` changes one operator, constant, comparison or sign of that
revision at a time, and runs the tests that reach it, the quickest first, until the first fails. A
change that is drawn once is drawn again in a later revision if its function still has it.

Tests of a server and of a page are left out, as the code that they reach is not seen. A run that is
stopped goes on where it was, in ``build/mutations``. This file is also the plugin by which pytest
notes what each test reaches.
"""

import argparse
import ast
import faulthandler
import functools
import gc
import hashlib
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import hypothesis
import pytest

ROOT = Path(__file__).parent.parent
COUNT, SEED, FIRST = 60, 33, 40
"""Number of mutations, seed, and number of tests that run before the files of others are read."""

BESIDE_CORE = ("app/model.py", "app/units.py")
ELSEWHERE = ("architecture", "benchmarks", "browser", "service")
ASKS_OTHERS = "tests/app/"
"""Tests for mutations that no test reaches in its own process: other processes may reach them."""

COMPILED = "engine.py"
ITS_DOOR = "core/drive/model.py", "[each for each in (pins, journals, lobes) if each]"
"""Line at which tests of the compiled file are noted, since compiled code notes nothing."""

OTHER: dict[type, type] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
    ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult, ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE,
    ast.GtE: ast.Lt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip
SKIPPED = (ast.Assert, ast.Raise, ast.JoinedStr, ast.pattern, ast.arguments)


class Mutation(NamedTuple):
    """Change of an expression between two bytes of a file."""

    file: str
    line: int
    function: str
    before: str
    after: str
    start: int
    end: int
    rank: str


def changed(node: ast.AST) -> ast.expr | None:
    """Expression with one thing changed in it; None if nothing can be."""
    match node:
        case ast.BinOp(left, operation, right) if type(operation) in OTHER:
            texts = (ast.JoinedStr, ast.List, ast.Tuple)
            if any(isinstance(each, texts) or _text(each) for each in (left, right)):
                return None
            return ast.BinOp(left, OTHER[type(operation)](), right)
        case ast.Compare(left, [operation], others):
            return ast.Compare(left, [OTHER[type(operation)]()], others)
        case ast.BoolOp(operation, values):
            return ast.BoolOp(OTHER[type(operation)](), values)
        case ast.UnaryOp(ast.USub() | ast.Not(), operand):
            return operand
        case ast.Constant(bool(value)):
            return ast.Constant(not value)
        case ast.Constant(int(value) | float(value)):
            return ast.Constant(2 * value or 1)
    return None


def _text(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def expressions(node: ast.AST, function: str = "") -> Iterator[tuple[str, ast.expr, ast.expr]]:
    """Name of the function, expression and changed expression of each possible change."""
    for name, value in ast.iter_fields(node):
        for each in value if isinstance(value, list) else [value]:
            outside = name in ("annotation", "returns", "decorator_list")
            if not isinstance(each, ast.AST) or isinstance(each, SKIPPED) or outside:
                continue
            if isinstance(each, (ast.FunctionDef, ast.ClassDef)):
                yield from expressions(each, f"{function}.{each.name}".lstrip("."))
                continue
            if isinstance(node, ast.ClassDef):
                continue  # fields and their defaults
            if function and isinstance(each, ast.AugAssign):
                yield function, each.value, ast.UnaryOp(ast.USub(), each.value)
            other = changed(each)
            if function and other:
                yield function, each, other  # type: ignore[misc]
            yield from expressions(each, function)


def mutations(tree: Path, seed: int) -> Iterator[Mutation]:
    """All mutations of a revision, each with its rank in the draw."""
    for path in sorted([*(tree / "core").rglob("*.py"), *(tree / name for name in BESIDE_CORE)]):
        source = path.read_bytes()
        lines = [0, *itertools.accumulate(map(len, source.splitlines(keepends=True)))]
        seen = Counter[str]()
        for function, old, new in expressions(ast.parse(source)):
            before, after = ast.unparse(old), ast.unparse(ast.fix_missing_locations(new))
            key = f"{function}: {before} -> {after}"
            seen[key] += 1
            rank = hashlib.sha256(f"{seed} {key} {seen[key]}".encode()).hexdigest()
            assert old.end_lineno and old.end_col_offset
            start = lines[old.lineno - 1] + old.col_offset
            end = lines[old.end_lineno - 1] + old.end_col_offset
            file = str(path.relative_to(tree))
            yield Mutation(file, old.lineno, function, before, after, start, end, rank)


def drawn(all_of_them: list[Mutation], count: int) -> list[Mutation]:
    """First mutations by rank: one of each room (a package or module), then of all others."""
    ranked = sorted(all_of_them, key=lambda each: each.rank)
    rooms = {"/".join(each.file.split("/")[:2]): each for each in reversed(ranked)}
    first = sorted(rooms.values(), key=lambda each: each.rank)
    return [*first, *(each for each in ranked if each not in first)][:count]


def changed_file(tree: Path, each: Mutation) -> bytes:
    source = (tree / each.file).read_bytes()
    return source[: each.start] + f"({each.after})".encode() + source[each.end :]


def noting(tree: Path, chosen: list[Mutation]) -> dict[str, bytes]:
    """Files of the mutations, with code that notes when each place is reached."""
    note, files = '(__import__("reached").SEEN.update({}) or (', dict[str, bytes]()
    inserted = list[tuple[str, int, str]]()
    for index, each in enumerate(chosen):
        if Path(each.file).name != COMPILED:
            inserted += (each.file, each.start, note.format([index])), (each.file, each.end, "))")
    loops = [n for n, each in enumerate(chosen) if Path(each.file).name == COMPILED]
    if loops:
        file, door = ITS_DOOR
        at = (tree / file).read_bytes().index(door.encode())
        inserted += (file, at, note.format(loops)), (file, at + len(door), "))")
    for file, at, text in sorted(inserted, key=lambda each: -each[1]):
        source = files.get(file) or (tree / file).read_bytes()
        files[file] = source[:at] + text.encode() + source[at:]
    return files


class Trial:
    """Copy of a revision, in which files are changed and put back."""

    def __init__(self, folder: Path, revision: str | None) -> None:
        self.folder, self.tree = folder, folder / "tree"
        if revision:  # also a second time: a stopped run may have left a changed file
            from benchmarks.revision import extract  # absent in the plugin

            extract(revision, self.tree)
        else:
            self.tree.mkdir(parents=True)
            ignored = shutil.ignore_patterns("__pycache__")
            for part in ("app", "core"):
                shutil.copytree(ROOT / part, self.tree / part, ignore=ignored)
            shutil.copy(ROOT / "pyproject.toml", self.tree)
        if revision and not (folder / "ready").exists():
            self.run("-m", "app.compiled")
            # a file changed twice in a second is another file, whatever its time says
            compile_all = ("compileall", "-qf", "--invalidation-mode=checked-hash")
            self.run("-m", *compile_all, "app", "core")
            (folder / "ready").touch()
        shutil.copy(__file__, self.tree / "reached.py")

    def run(self, *command: str, **environment: str) -> subprocess.CompletedProcess[str]:
        environment |= {"PYTHONPATH": ".", "PYTHONDONTWRITEBYTECODE": "1"}
        return subprocess.run(
            [sys.executable, *command], cwd=self.tree, env=os.environ | environment, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip

    def pytest(
        self, files: dict[str, bytes], *asked: str, **environment: str
    ) -> subprocess.CompletedProcess[str]:
        """Run tests with some files changed."""
        kept = {file: (self.tree / file).read_bytes() for file in files}
        times = {file: (self.tree / file).stat().st_mtime_ns for file in files}
        shutil.rmtree(self.tree / ".hypothesis", ignore_errors=True)
        command = (
            "-m", "pytest", "-q", "-p", "reached", "-p", "no:schemathesis",
            "-W", "ignore::pytest.PytestUnraisableExceptionWarning",  # from loops of other tests
        )  # fmt: skip
        try:
            for file, source in files.items():
                (self.tree / file).write_bytes(source)
            return self.run(*command, *asked, **environment)
        finally:
            for file, source in kept.items():
                (self.tree / file).write_bytes(source)
                os.utime(self.tree / file, ns=(times[file], times[file]))

    def reached(self, chosen: list[Mutation], tests: list[str]) -> dict[str, Any]:
        """Seconds of each test that passes, and the mutations that it reaches."""
        noted = self.folder / "reached.json"
        if not noted.exists():
            ignored = [f"--ignore=tests/{name}" for name in ELSEWHERE]
            said = self.pytest(
                noting(self.tree, chosen), *ignored, "-m", "not browser", *tests,
                MUTATIONS_NOTED=str(noted),
            )  # fmt: skip
            print(said.stdout[-3000:])
        found: dict[str, Any] = json.loads(noted.read_text())
        return found

    def killed_by(self, each: Mutation, tests: dict[str, float]) -> str | None:
        """First test that fails with a mutation; None if the mutation survives."""
        order, asked = sorted(tests, key=lambda test: tests[test]), self.folder / "asked.json"
        cache = self.folder / "numba"
        shutil.rmtree(cache, ignore_errors=True)
        kernel = {"NUMBA_CACHE_DIR": str(cache)} if Path(each.file).name == COMPILED else {}
        for some in filter(None, (order[:FIRST], order[FIRST:])):
            asked.write_text(json.dumps({test: tests[test] for test in some}))
            files = sorted({test.split("::")[0] for test in some})
            source = {each.file: changed_file(self.tree, each)}
            done = self.pytest(source, "-x", *files, MUTATIONS_ASKED=str(asked), **kernel)
            if done.returncode:
                failed = re.search(r"^(?:FAILED|ERROR) (\S+::.*?)(?: - |$)", done.stdout, re.M)
                return failed[1] if failed else f"no end, or none of {len(some)} tests starts"
        return None


def main(base: str, seed: int, smallest: bool) -> None:
    """Draw the mutations of a revision, run its tests, and print what survives."""
    short = ["git", "rev-parse", "--short", base]
    name = subprocess.run(short, stdout=-1, text=True, cwd=ROOT).stdout.strip()
    folder = ROOT / "build" / "mutations" / f"{'smallest' if smallest else name}-{seed}"
    if smallest:
        shutil.rmtree(folder, ignore_errors=True)
    trial = Trial(folder, None if smallest else name)
    all_of_them = [*mutations(trial.tree, seed)]
    if smallest:
        all_of_them = [each for each in all_of_them if each.file == "core/numerics/quadrature.py"]
    chosen = drawn(all_of_them, 1 if smallest else COUNT)
    reached = trial.reached(chosen, ["core/numerics/quadrature.py"] if smallest else [])
    record = folder / "found.json"
    found: dict[str, str | None] = json.loads(record.read_text()) if record.exists() else {}
    for index, each in enumerate(chosen):
        if each.rank not in found:
            asked = [test for test, (_, seen) in reached.items() if index in seen]
            asked = asked or [test for test in reached if test.startswith(ASKS_OTHERS)]
            tests = {test: reached[test][0] for test in asked}
            found[each.rank] = trial.killed_by(each, tests)
            record.write_text(json.dumps(found))
        by = found[each.rank]
        print(f"{each.file}:{each.line} {each.function}: {each.before} -> {each.after}")
        print(f"    killed by {by}" if by else "    SURVIVED", flush=True)
    killed = sum(map(bool, found.values()))
    print(f"{name}, seed {seed}: {killed} of {len(chosen)} mutations killed")
    if smallest:
        shutil.rmtree(folder)


# The plugin: notes what is reached (MUTATIONS_NOTED), or runs what is asked (MUTATIONS_ASKED).

SEEN = set[int]()
IMPORTING = set[int]()
BY_FIXTURE: defaultdict[Any, set[int]] = defaultdict(set)
TESTS: dict[str, set[int]] = {}
SECONDS: dict[str, float] = {}
PASSED = Counter[str]()
CACHES: list[Any] = []


def pytest_sessionstart() -> None:
    """Fix the random cases of hypothesis, without a search for simpler failures."""
    hypothesis.settings.register_profile(
        "mutations", deadline=None, derandomize=True, database=None,
        max_examples=hypothesis.settings().max_examples,
        phases=[hypothesis.Phase.explicit, hypothesis.Phase.generate],
    )  # fmt: skip
    hypothesis.settings.load_profile("mutations")


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    IMPORTING.update(SEEN)
    if asked := os.environ.get("MUTATIONS_ASKED"):
        SECONDS.update(json.loads(Path(asked).read_text()))
        order = {test: index for index, test in enumerate(SECONDS)}
        items[:] = [item for item in items if item.nodeid in order]
        items.sort(key=lambda item: order[item.nodeid])
        return
    CACHES.extend(
        each for each in gc.get_objects()
        if isinstance(each, functools._lru_cache_wrapper) and each.__module__.startswith("core.")
    )  # fmt: skip


@pytest.hookimpl(wrapper=True)
def pytest_fixture_setup(fixturedef: Any) -> Iterator[None]:
    outside = {*SEEN}
    SEEN.clear()
    try:
        return (yield)
    finally:
        BY_FIXTURE[fixturedef] |= SEEN
        SEEN.update(outside)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    SEEN.clear()
    for each in CACHES:  # values kept from another test would hide code
        each.cache_clear()
    if item.nodeid in SECONDS:
        faulthandler.dump_traceback_later(60 + 10 * SECONDS[item.nodeid], exit=True)
    try:
        return (yield)
    finally:
        faulthandler.cancel_dump_traceback_later()
        fixtures = getattr(getattr(item, "_fixtureinfo", None), "name2fixturedefs", {}).values()
        also = [BY_FIXTURE[each] for each in itertools.chain(*fixtures)]
        TESTS[item.nodeid] = SEEN.union(*also)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if "MUTATIONS_NOTED" in os.environ:
        SECONDS[report.nodeid] = SECONDS.get(report.nodeid, 0.0) + report.duration
        PASSED[report.nodeid] += report.passed


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish() -> None:
    if noted := os.environ.get("MUTATIONS_NOTED"):
        beside = IMPORTING.difference(*TESTS.values())  # reached by imports, so for any test
        passed = {
            test: (SECONDS[test], sorted(seen | beside))
            for test, seen in TESTS.items()
            if PASSED[test] == 3
        }
        Path(noted).write_text(json.dumps(passed))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("base", nargs="?", default="HEAD", help="the revision to change")
    parser.add_argument("seed", nargs="?", type=int, default=SEED, help="of the draw")
    parser.add_argument("--smallest", action="store_true", help="one, of a small file")
    asked = parser.parse_args()
    main(asked.base, asked.seed, asked.smallest)
