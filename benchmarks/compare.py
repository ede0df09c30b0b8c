"""Comparison of the answers of this revision with those of another: `make compare BASE=rev`.

Both revisions answer a corpus of requests (tests/corpus), the other one in a work tree of its own.
Codes, verdicts, pointers and all other values that are no numbers have to be equal, numbers agree
within the class of their field, whatever error is stated; texts for people are only counted. A code
equals the one that its `was` names, and a warning may become a check of the answer: both are
counted. A table has the numbers compared and the processor times by case. Differences of the API's
description are printed. The status is 1 if anything differs.
"""

import argparse
import asyncio
import difflib
import json
import math
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
CORPUS = ROOT / "tests" / "corpus" / "requests.json"

LEFT_OUT = {
    *("run_time_us", "evaluations", "relative_error", "sampling_error", "angle_grid_error"),
    *("angle_error_arcmin", "conformal_error", "force_error_N", "loss_error"),
    *("pair_error", "peak_error", "play_error_arcmin", "ratio_error", "ripple_error_Nm"),
    *("room_error_mm", "rotation_error_arcmin", "stiffness_error"),
}
"""Fields of cost and stated error, which are not compared."""

TEXTS = {"detail", "title", "why", "formula", "source", "method"}
"""Texts for people; differences are only counted."""

NAMED = {"params", "pointer"}
"""Values that a text names; counted if only one answer has them beside its text."""

POSITION, EXTREME, DRAWN, PLACE = 1e-9, 1e-6, 1e-5, 1e-3
"""Largest relative differences of numbers: of a position and by default; of extremes over a turn
and results from them; of numbers rounded to six digits; of the crank angle of an extreme, which is
known to the root of the precision of the extreme."""

CLASSES = {
    **dict.fromkeys(
        (
            *("over_turn", "load_sharing", "efficiency", "fit", "loaded_deg", "loaded_count"),
            *("quantities", "contributions", "fit_contributions", "cannot_assemble", "shares"),
            *("checks", "fixes", "torque_reserve", "largest_torque_Nm", "cold_yield", "worked"),
            *("usual_fit", "usual_modification", "combined", "hertz", "pin_strength", "rollers"),
            *("output_efficiency", "satellite_bearing", "crankshaft", "/solve", "/pin-strength"),
            *("/output-efficiency", "/satellite-bearing", "/crankshaft", "ratio", "params"),
        ),
        EXTREME,
    ),
    "ring_drawing": DRAWN,
    **dict.fromkeys(
        ("peak_crank_angle_deg", "least_room_crank_angle_deg", "blocked_crank_deg", "at"), PLACE
    ),
}
"""Fields, sections with their contents, and paths of requests whose numbers are not of a position.
The widest class counts of all in which a number stands."""

FLOOR = 1e-4
"""Size below which a number, or the largest of its list, counts as one of this size."""

COLUMNS = ("requests", "answered", "numbers", "texts", "before", "after")
"""Columns of the table: numbers compared, texts that differ, processor times, s."""

SHOWN = 12
"""Largest number of differences printed of a request, and of lines of the description."""


async def _answers(requests: list[dict[str, Any]]) -> dict[str, Any]:
    import httpx

    from app.main import create_app
    from app.settings import Settings

    transport = httpx.ASGITransport(app=create_app(Settings(max_seconds=600)))
    async with httpx.AsyncClient(
        transport=transport, base_url="http://service/api/v1/", timeout=None
    ) as client:
        found, spent = [], _spent()
        for each in requests:
            kind = {"content-type": "application/json"}
            sent = json.dumps(each["body"])
            answer = await client.post(each["path"], content=sent, headers=kind)
            before, spent = spent, _spent()
            told = {"status": answer.status_code, "answer": answer.json()}
            found.append({"told": told, "seconds": spent - before})
        description = (await client.get("openapi.json")).json()
        words = (await client.get("words")).json()
    was = words.get("was", {}).get("warnings", {})
    return {"answers": found, "description": description, "was": was}


def _spent() -> float:
    """Processor time of all processes of this session, s."""
    ticks, session = 0, os.getsid(0)
    for file in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            row = [int(each) for each in file.read_text().rpartition(")")[2].split()[1:15]]
            ticks += sum(row[10:]) if row[2] == session else 0
    return ticks / os.sysconf("SC_CLK_TCK")


def ask(requests: str) -> None:
    """Answer requests by the revision in the current folder, as JSON on standard output."""
    print(json.dumps(asyncio.run(_answers(json.loads(Path(requests).read_text())))))


def answers(folder: Path, requests: Path) -> dict[str, Any]:
    """Result of a revision in its work tree: `answers`, each with what was `told` and its
    `seconds`, the API's `description`, and earlier codes of warnings, `was`.
    """
    run = partial(
        subprocess.run,
        cwd=folder,
        env={"PYTHONPATH": str(folder), "PATH": "/usr/bin:/bin"},
        stdout=subprocess.PIPE,
        check=True,
        text=True,
        start_new_session=True,
    )
    run([sys.executable, "-m", "app.compiled"])  # studies say if loops are not compiled
    done = run([sys.executable, __file__, "--ask", str(requests)])
    found: dict[str, Any] = json.loads(done.stdout)
    return found


class Difference:
    """Differences of two answers; `was` names the earlier code of each renamed warning."""

    def __init__(self, was: dict[str, str] | None = None) -> None:
        self.now = {old: code for code, old in (was or {}).items()}
        self.differences: list[str] = []  # parts that should be equal and are not, by place
        self.numbers = self.worded = 0  # numbers compared, texts that differ
        self._said: set[str] = set()
        # Codes with a new name, and warnings that checks say now.
        self.renamed, self.left_to_checks = Counter[str](), Counter[str]()

    def compare(
        self,
        before: Any,
        after: Any,
        place: str = "",
        error: float = POSITION,
        largest: float = FLOOR,
    ) -> None:
        """Compare two parts of answers at a place, with a relative error of their numbers;
        ``largest`` is the largest number of their list.
        """
        if isinstance(before, dict) and isinstance(after, dict):
            after = self._as_before(before, after)
            before = self._unrepeated(before, after)
            for name in {**before, **after}:
                if name in LEFT_OUT:
                    continue
                if name in NAMED and "detail" in before and (name in before) != (name in after):
                    self.worded += 1
                elif name not in before or name not in after:
                    where = "after" if name in after else "before"
                    self.differences.append(f"{place}/{name}: only {where}")
                elif name in TEXTS and isinstance(before[name], str):
                    self.worded += before[name] != after[name]
                else:
                    allowed = max(error, CLASSES.get(name, error))
                    self.compare(before[name], after[name], f"{place}/{name}", allowed)
        elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
            largest = max(largest, _largest(before))
            for index, each in enumerate(zip(before, after, strict=True)):
                self.compare(*each, f"{place}/{index}", error, largest)
        elif _number(before) and _number(after):
            self.numbers += 1
            if not math.isclose(before, after, rel_tol=error, abs_tol=error * largest):
                self.differences.append(f"{place}: {before!r} -> {after!r}")
        elif before != after:
            self.differences.append(f"{place}: {before!r} -> {after!r}"[:300])

    def _as_before(self, before: Any, after: Any) -> Any:
        """Coded part under its earlier code, if it names one."""
        if "was" not in after or "was" in before:
            return after
        known = {name: value for name, value in after.items() if name != "was"}
        if before.get("code") == after["was"]:
            self.renamed[f"{after['was']} -> {after['code']}"] += 1
            known["code"] = after["was"]
        return known

    def _unrepeated(self, before: Any, after: Any) -> Any:
        """Answer, or section of one, without warnings that checks of the other say."""
        for each in after.get("checks") or ():
            self._said |= {each["code"], each.get("reason", each)["code"]}
        warnings = before.get("warnings")
        if not isinstance(warnings, list):
            return before
        left = {each.get("was", each["code"]) for each in after.get("warnings", ())}
        kept = []
        for each in warnings:
            code = each["code"]
            if code not in left and self.now.get(code, code) in self._said:
                self.left_to_checks[code] += 1
            else:
                kept.append(each)
        others = {name: value for name, value in before.items() if name != "warnings"}
        return others | ({"warnings": kept} if kept else {})


def _number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _largest(value: Any) -> float:
    """Largest size of a number in a list, lists in it included."""
    if isinstance(value, list):
        return max(map(_largest, value), default=0.0)
    return abs(value) if _number(value) else 0.0


def described(before: Any, after: Any) -> Iterator[str]:
    """Lines of the API's description that differ."""
    pages = (json.dumps(each, indent=1, sort_keys=True).split("\n") for each in (before, after))
    for line in difflib.unified_diff(*pages, "before", "after", n=0, lineterm=""):
        if not line.startswith("@@"):
            yield line


def main(base: str, smallest: bool = False) -> int:
    """Compare both revisions and print differences; 1 if there are any."""
    requests = json.loads(CORPUS.read_text(encoding="utf-8"))
    if smallest:
        requests = requests[::40]
    with tempfile.TemporaryDirectory() as temporary:
        file, other = Path(temporary) / "requests.json", Path(temporary) / "base"
        file.write_text(json.dumps(requests), encoding="utf-8")
        after = answers(ROOT, file)
        if smallest:
            before = after
        else:
            git = ["git", "-C", str(ROOT), "worktree"]
            subprocess.run([*git, "add", "--quiet", "--detach", str(other), base], check=True)
            try:
                before = answers(other, file)
            finally:
                subprocess.run([*git, "remove", "--force", str(other)], check=True)
    different = 0
    renamed, left_to_checks = Counter[str](), Counter[str]()
    table: dict[str, Counter[str]] = {}
    pairs = zip(requests, before["answers"], after["answers"], strict=True)
    for index, (request, one, two) in enumerate(pairs):
        path, found = request["path"], Difference(after["was"])
        found.compare(one["told"], two["told"], "", CLASSES.get(f"/{path}", POSITION))
        row = table.setdefault(request.get("case", path), Counter())
        row.update(requests=1, answered=two["told"]["status"] == 200)
        row.update(numbers=found.numbers, texts=found.worded)
        row.update(before=one["seconds"], after=two["seconds"])
        renamed, left_to_checks = renamed + found.renamed, left_to_checks + found.left_to_checks
        if found.differences:
            different += 1
            print(f"{index} {path}: {len(found.differences)} differences")
            for each in found.differences[:SHOWN]:
                print(f"    {each}")
    lines = [*described(before["description"], after["description"])]
    for line in lines[:SHOWN]:
        print(line)
    table["all"] = sum(table.values(), Counter())
    print(f"{'case':>27}" + "".join(f"{name:>10}" for name in COLUMNS))
    for case, row in table.items():
        print(f"{case:>27}" + "".join(f"{round(row[name], 1):10,}" for name in COLUMNS))
    print(f"{len(lines)} lines of the description differ")
    print(f"renamed: {dict(renamed) or 'none'}; warnings that checks say: {dict(left_to_checks)}")
    print(f"{different} requests answered otherwise")
    return 1 if different else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("base", nargs="?", default="HEAD", help="the revision to compare with")
    parser.add_argument("--ask", help="requests that are only answered")
    parser.add_argument("--smallest", action="store_true", help="a few, of this revision alone")
    given = parser.parse_args()
    if given.ask:
        ask(given.ask)
    else:
        sys.exit(main(given.base, given.smallest))
