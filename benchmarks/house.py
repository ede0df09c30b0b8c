"""Weight of the code: numbers that every larger change reports, before and after.

The numbers are lines by room, lengths of functions, the way of requests through the code, and the
processor time of the page's cycloid design, also over that of a loop of Python that runs beside it.
Functions are counted as Python 3.11 enters them, without comprehensions. `--start` also measures
the first start.
"""

import argparse
import ast
import asyncio
import json
import os
import platform
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any, NamedTuple, get_args

from app import compiled
from app.examples import EXAMPLES
from core.output.turn import Turn

ROOT = Path(__file__).parent.parent
ROOMS = ("core", "app", "static", "tests", "benchmarks", "clients", "docs")
OWN = (f"{ROOT}/app/", f"{ROOT}/core/")
"""Folders of the product's Python code."""
KINDS = (".py", ".js", ".mjs", ".css", ".html", ".md")
LARGE, LONG, WIDE = 500, 60, 100
"""Lines of code from which a file is named and a function is counted; characters of a line."""

COMPREHENSIONS = {"<listcomp>", "<setcomp>", "<dictcomp>", "<genexpr>"}

ROUNDS = 3
"""Number of times that a request is timed."""

MECHANISM = {"mechanism": {"pins": 6, "ratio": 20}}
"""Smallest request of the whole reducer that is answered."""

STRESSED = MECHANISM | {
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0,
    },
}
"""Smallest request of the whole reducer whose contacts are judged."""


def files(room: str) -> Iterator[Path]:
    for path in sorted((ROOT / room).rglob("*")):
        if path.suffix in KINDS and "vendor" not in path.parts and "__pycache__" not in path.parts:
            yield path


def documented(tree: ast.AST) -> set[int]:
    """Numbers of the lines of docstrings and of strings below constants."""
    found = set[int]()
    for node in ast.walk(tree):
        match node:
            case ast.Expr(ast.Constant(str())):
                found |= {*range(node.lineno, (node.end_lineno or node.lineno) + 1)}
    return found


def code_lines(path: Path) -> set[int]:
    """Numbers of the lines that are not empty and, in Python, neither words nor comments."""
    text, python = path.read_text(), path.suffix == ".py"
    words = documented(ast.parse(text)) if python else set[int]()
    return {
        number
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not (python and line.strip().startswith("#")) and number not in words
    }


def weight(room: str) -> str:
    """Row of a room: all lines, lines of code, of docstrings, and too wide ones of Python."""
    total = code = words = wide = 0
    for path in files(room):
        text = path.read_text()
        total, code = total + len(text.splitlines()), code + len(code_lines(path))
        if path.suffix == ".py":
            words += len(documented(ast.parse(text)))
            wide += sum(len(line) > WIDE for line in text.splitlines())
    return f"| {room} | {total:,} | {code:,} | {words:,} | {wide:,} |"


def lengths(room: str) -> list[tuple[int, str]]:
    """Lines of code of each function of a room, and the place of the function."""
    found = []
    for path in files(room):
        code = code_lines(path)
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                own = code & {*range(node.lineno, (node.end_lineno or node.lineno) + 1)}
                found.append((len(own), f"{path.relative_to(ROOT)}: {node.name}"))
    return sorted(found)


def optionals() -> tuple[int, int]:
    """Number of comparisons with None, and of annotations with None, in core and app."""
    asked = said = 0
    for room in ("core", "app"):
        for path in files(room):
            if path.suffix != ".py":
                continue
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.Compare):
                    pairs = zip(node.ops, node.comparators, strict=True)
                    asked += sum(
                        isinstance(op, ast.Is | ast.IsNot) and none(to) for op, to in pairs
                    )
                elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr):
                    said += none(node.right) or none(node.left)
    return asked, said


def none(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value is None


def widest_union() -> tuple[int, str]:
    """Largest number of types that a function of core returns, and its place."""
    widest = (1, "")
    for path in files("core"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef) and node.returns is not None:
                count = ast.unparse(node.returns).count(" | ") + 1
                widest = max(widest, (count, f"{path.relative_to(ROOT)}: {node.name}"))
    return widest


def asked(request: dict[str, Any]) -> Callable[[], bytes]:
    """Function that answers a request of the whole reducer, from bytes to bytes."""
    from app.content import encoded
    from app.endpoint import answered, read_body
    from app.registry import CALCULATIONS
    from app.settings import Settings

    calculation, sent = CALCULATIONS["crank-planetary"], json.dumps(request).encode()
    settings = Settings(max_seconds=600)  # the service reads them once
    return lambda: encoded(answered(calculation, read_body(calculation, sent, settings)))


class Way(NamedTuple):
    """Product's code that a request enters, once all is loaded."""

    files: int
    functions: int
    calls: int
    jumps: int  # calls into another file than the caller's
    positions: int  # positions that turns solve


def way(request: dict[str, Any]) -> Way:
    """Way of a request through the code."""
    answer = asked(request)
    seen: Counter[tuple[str, str, int]] = Counter()
    within: list[str] = []
    turns: list[Turn] = []
    jumps = 0

    def trace(frame: Any, event: str, _: Any) -> None:
        nonlocal jumps
        code = frame.f_code
        file = code.co_filename
        if not file.startswith(OWN) or code.co_name in COMPREHENSIONS:
            return
        if event == "call":
            seen[file, code.co_qualname, code.co_firstlineno] += 1
            jumps += bool(within) and within[-1] != file
            within.append(file)
            if code is Turn.__init__.__code__:
                turns.append(frame.f_locals["self"])
        elif event == "return":
            within.pop()

    answer()
    sys.setprofile(trace)
    answer()
    sys.setprofile(None)
    solved = sum(turn.evaluations for turn in turns)
    return Way(len({file for file, *_ in seen}), len(seen), seen.total(), jumps, solved)


def beside() -> float:
    """Processor time of a loop of Python, s."""
    began = time.process_time()
    total = 0
    for number in range(2_000_000):
        total += number & 7
    return time.process_time() - began


def cost(request: dict[str, Any], rounds: int) -> tuple[float, float]:
    """Processor time of a request, s, and over that of the loop; medians of rounds."""
    answer, seconds, ratios = asked(request), list[float](), list[float]()
    answer()
    for _ in range(rounds):
        loop, began = beside(), time.process_time()
        answer()
        seconds.append(time.process_time() - began)
        ratios.append(seconds[-1] / ((loop + beside()) / 2))
    return statistics.median(seconds), statistics.median(ratios)


def costly() -> dict[str, dict[str, Any]]:
    """Requests that are timed: the page's cycloid design in its forms."""
    from app.calculations.crank_planetary_sections import Section

    whole = next(each["input"] for each in EXAMPLES if each["id"] == "cycloid")
    heavy = whole | {"load": whole["load"] | {"output_torque_Nm": 500.0}}
    found = {
        "forces alone": whole | {"include": ["load_sharing"]},
        "as it is typed": whole,
        "all checks": whole | {"include": ["checks"]},
    }
    if "largest_torque" in get_args(Section):  # an older revision has it in each answer
        found["all checks, largest torque"] = whole | {"include": ["checks", "largest_torque"]}
    return found | {"fixes at 500 N*m": heavy | {"include": ["checks", "fixes"]}}


def first_start() -> tuple[float, float]:
    """Processor time from an empty cache of compiled loops to the first answer with clearance, s,
    and over that of the loop.
    """
    code = (
        "from app import compiled; compiled.load();"
        "from benchmarks.house import asked, costly; asked(costly()['forces alone'])()"
    )
    loop = beside()
    with tempfile.TemporaryDirectory() as empty:
        environment = os.environ | {"NUMBA_CACHE_DIR": empty, "PYTHONPATH": str(ROOT)}
        subprocess.run([sys.executable, "-c", code], cwd=ROOT, env=environment, check=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = used.ru_utime + used.ru_stime
    return seconds, seconds / ((loop + beside()) / 2)


def codes() -> tuple[int, list[str]]:
    """Number of codes that the service may say, and codes that stand in several tables."""
    import httpx

    from app.main import app

    async def ask() -> dict[str, dict[str, Any]]:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://service") as client:
            said: dict[str, dict[str, Any]] = (await client.get("/api/v1/words")).json()
            return said

    words = asyncio.run(ask())
    said = Counter(
        code for table in ("refusals", "notices", "reasons", "checks") for code in words[table]
    )
    return len(said), sorted(code for code, count in said.items() if count > 1)


def page_circles() -> list[str]:
    """Modules of the page that import each other in a circle."""
    imports = {}
    for path in (ROOT / "static").rglob("*.js"):
        if "vendor" not in path.parts:
            named = re.findall(r'^(?:import|export)[^;]*?from "(\.[^"]+)"', path.read_text(), re.M)
            imports[path] = {(path.parent / each).resolve() for each in named}
    try:
        [*TopologicalSorter(imports).static_order()]
    except CycleError as circle:
        return [path.name for path in circle.args[1]]
    return []


def print_lines(smallest: bool) -> None:
    """Print lines by room, in the smallest form of one, and lengths of core's functions."""
    print("| lines of | all | code | docstrings | above 100 |\n|---|---|---|---|---|")
    tests = [f"tests/{path.name}" for path in sorted((ROOT / "tests").iterdir()) if path.is_dir()]
    for room in ["clients"] if smallest else (*ROOMS, *tests):
        if any(files(room)):
            print(weight(room))
    core = lengths("core")
    median, (longest, where) = core[len(core) // 2][0], core[-1]
    long = sum(each > LONG for each, _ in core)
    print(f"\nfunctions of core: {len(core):,}, median {median} lines of code, {long} above {LONG}")
    print(f"the longest: {longest} ({where})")


def print_requests(smallest: bool, start: bool) -> None:
    """Print way and cost of requests, with compiled loops."""
    timed = costly()
    ways = {"of a mechanism": MECHANISM, "of its stress": STRESSED}
    ways["of the cycloid design"] = timed["as it is typed"]
    if smallest:
        del ways["of the cycloid design"]
        timed = {"forces alone": timed["forces alone"]}
    compiled.load()
    print(f"\n| request | {' | '.join(Way._fields)} |\n|---|{'---|' * len(Way._fields)}")
    for name, request in ways.items():
        print(f"| {name} | {' | '.join(f'{each:,}' for each in way(request))} |")
    print("\n| cycloid design | processor, s | over the loop |\n|---|---|---|")
    for name, request in timed.items():
        seconds, ratio = cost(request, 1 if smallest else ROUNDS)
        print(f"| {name} | {seconds:.3f} | {ratio:.2f} |", flush=True)
    if start:
        seconds, ratio = first_start()
        print(f"| first start: loops compiled, forces alone | {seconds:.1f} | {ratio:.0f} |")
    print(f"\na loop takes {beside():.3f} s; Python {platform.python_version()}")


def main(smallest: bool = False, start: bool = False) -> None:
    print_lines(smallest)
    print_requests(smallest, start)
    asked, said = optionals()
    width, place = widest_union()
    number, twice = codes()
    print()
    print(f"`is None` in core and app: {asked}, `| None`: {said}")
    print(f"types in the widest union of a result: {width} ({place})")
    print(f"codes of refusals, notices, reasons, checks: {number}, in two tables: {twice}")
    print(f"circles of imports in the page: {page_circles() or 0}")
    python = [
        path for room in (["clients"] if smallest else ["core", "app"]) for path in files(room)
    ]
    largest = sorted(((len(code_lines(path)), path) for path in python), reverse=True)[:10]
    print("largest files, lines of code:")
    for count, path in largest:
        print(f"  {count:5d} {path.relative_to(ROOT)}{'  (large)' if count > LARGE else ''}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--smallest", action="store_true", help="little of the cycloid design")
    parser.add_argument("--start", action="store_true", help="the first start too: minutes")
    given = parser.parse_args()
    main(given.smallest, given.start)
