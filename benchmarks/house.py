"""What the code weighs: the numbers that every larger change reports, before and after.

None of them is aimed at; what grows is asked about.
"""

import ast
import asyncio
import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
ROOMS = ("core", "app", "static", "tests", "benchmarks", "clients", "docs")
KINDS = (".py", ".js", ".mjs", ".css", ".html", ".md")
LARGE = 500
"""Lines of code from which a file is named."""

MECHANISM = {"mechanism": {"pins": 6, "ratio": 20}}
"""The smallest request of the whole reducer that is answered."""

STRESSED = MECHANISM | {
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0,
    },
}
"""The smallest one whose contacts are judged."""


def files(room: str) -> Iterator[Path]:
    for path in sorted((ROOT / room).rglob("*")):
        if path.suffix in KINDS and "vendor" not in path.parts and "__pycache__" not in path.parts:
            yield path


def lines(path: Path) -> int:
    return len(path.read_text().splitlines())


def code_lines(path: Path) -> int:
    """Lines of a Python file that are neither empty nor words."""
    text = path.read_text()
    tree, words = ast.parse(text), set[int]()
    for node in ast.walk(tree):
        said = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if said and isinstance(node.value.value, str):  # type: ignore[attr-defined]
            words |= {*range(node.lineno, (node.end_lineno or node.lineno) + 1)}  # type: ignore[attr-defined]
    return sum(
        bool(line.strip()) and not line.strip().startswith("#") and number not in words
        for number, line in enumerate(text.splitlines(), 1)
    )


def optionals() -> tuple[int, int]:
    """How often something is asked whether it is None, and is said that it may be."""
    asked = said = 0
    for room in ("core", "app"):
        for path in files(room):
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
    """Most types that a function or a property of core may return."""
    widest = (1, "")
    for path in files("core"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef) and node.returns is not None:
                count = ast.unparse(node.returns).count(" | ") + 1
                widest = max(widest, (count, f"{path.relative_to(ROOT)}: {node.name}"))
    return widest


def entered(request: dict[str, Any]) -> tuple[int, int]:
    """Files and functions of this project that a request enters, once all is loaded."""
    from pydantic import TypeAdapter

    from app.endpoint import answered, encoded, read_body
    from app.registry import CALCULATIONS
    from app.settings import Settings

    calculation, sent = CALCULATIONS["crank-planetary"], json.dumps(request).encode()
    settings = Settings()  # which the service reads once
    assert TypeAdapter(calculation.request).validate_json(sent)

    def answer() -> bytes:
        return encoded(answered(calculation, read_body(calculation, sent, settings)))

    seen: Counter[tuple[str, str, int]] = Counter()

    def trace(frame: Any, event: str, _: Any) -> None:
        code = frame.f_code
        if event == "call" and code.co_filename.startswith((f"{ROOT}/app", f"{ROOT}/core")):
            seen[code.co_filename, code.co_qualname, code.co_firstlineno] += 1

    answer()
    sys.setprofile(trace)
    answer()
    sys.setprofile(None)
    return len({file for file, *_ in seen}), len(seen)


def codes() -> tuple[int, list[str]]:
    """Codes that the service may say, and those that stand in several tables."""
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


def main() -> None:
    print("| lines | |\n|---|---|")
    for room in ROOMS:
        print(f"| {room} | {sum(map(lines, files(room))):,} |")
    asked, said = optionals()
    width, place = widest_union()
    number, twice = codes()
    print()
    for name, request in {"of a mechanism": MECHANISM, "of its stress": STRESSED}.items():
        many, functions = entered(request)
        print(f"files entered by the smallest request {name}: {many}, functions: {functions}")
    print(f"`is None` in core and app: {asked}, `| None`: {said}")
    print(f"types in the widest union of a result: {width} ({place})")
    print(f"codes of refusals, notices, reasons, checks: {number}, in two tables: {twice}")
    print(f"circles of imports in the page: {page_circles() or 0}")
    python = [path for room in ("core", "app") for path in files(room)]
    largest = sorted(((code_lines(path), path) for path in python), reverse=True)[:10]
    print("largest files, lines of code:")
    for count, path in largest:
        print(f"  {count:5d} {path.relative_to(ROOT)}{'  (large)' if count > LARGE else ''}")


if __name__ == "__main__":
    main()
