"""Cost of this revision over that of another one, as ratios in one run.

`make ratios BASE=rev` runs the service of both revisions and sends both the same requests, in turn
and in rounds: small ones, curves and figures, whole designs, batches of 1,000, and the page in
Chromium until its first figure is drawn. Services count by the processor time of all their
processes, the page by elapsed time. The status is 1 if the median of all ratios is above 1.05, or
one of them above 1.2.
"""

import argparse
import itertools
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx

from app.about import API
from app.examples import REQUESTS
from benchmarks.batches import TOGETHER
from benchmarks.load import service
from benchmarks.options import add_service
from benchmarks.page import first_figure
from benchmarks.revision import ROOT, extract
from benchmarks.service import BODIES, CURVES
from benchmarks.soak import family
from benchmarks.speed import SECTIONS
from tests.inputs import chromium

MEDIAN, WORST = 1.05, 1.2
"""Largest median of all ratios, and largest single ratio."""

ROUNDS, FEW = 15, 5
"""Rounds of each request, and of one that takes more than a second."""

AT_LEAST_S = 0.1
"""Least processor time of a round, s, that is no matter of chance."""

BATCHES = ("hertz", "contact-force", "cyclogram", "crank-planetary", "roller-strength")
WHOLE = SECTIONS | {
    "include": ["checks", "cyclogram", "contact_force", "hertz", "pin_strength",
                "output_efficiency", "satellite_bearing", "crankshaft"],
}  # fmt: skip

Asked = dict[str, tuple[str, Callable[[int], dict[str, Any]]]]


def whole(number: int) -> dict[str, Any]:
    """Whole design that differs from all before, so that no result of it is kept."""
    return WHOLE | {"mechanism": SECTIONS["mechanism"] | {"ratio": 20 + 1e-7 * number}}


def batch(calculation: str, size: int) -> tuple[str, Callable[[int], dict[str, Any]]]:
    body = {"calculation": calculation, "requests": [REQUESTS[calculation]] * size}
    return "batch", lambda _: body


def requests(together: int) -> Asked:
    """Path of each request, and its body by the number of the request."""
    small = {name: (name, lambda _, name=name: BODIES[name]) for name in BODIES}
    asked: Asked = small | {
        "curves": ("contact-force", lambda _: CURVES),
        "figure": ("contact-force/chart", lambda _: BODIES["contact-force"]),
        "load sharing": ("load-sharing", lambda _: REQUESTS["load-sharing"]),
        "crank-planetary": ("crank-planetary", lambda _: REQUESTS["crank-planetary"]),
        "whole design": ("crank-planetary", whole),
    }
    return asked | {f"batch of {name}": batch(name, together) for name in BATCHES}


class Running:
    """Running service of a revision."""

    def __init__(self, folder: Path, pid: int, port: int) -> None:
        self.folder, self.pid, self.url = folder, pid, f"http://127.0.0.1:{port}"
        self.client = httpx.Client(base_url=f"{self.url}{API}/", timeout=600)
        while self.client.get(f"{self.url}/readyz").status_code != 200:
            time.sleep(0.1)

    def seconds(self) -> float:
        """Processor time of all processes of the service, s."""
        spent = 0
        for pid in family(self.pid):
            with suppress(FileNotFoundError, ProcessLookupError):
                for task in Path(f"/proc/{pid}/task").iterdir():
                    spent += int((task / "schedstat").read_text().split()[0])
        return spent / 1e9

    def cost(self, path: str, bodies: list[bytes]) -> float:
        """Processor time of requests, each of which has to be answered, s."""
        before = self.seconds()
        for body in bodies:
            answer = self.client.post(
                path, content=body, headers={"content-type": "application/json"}
            )
            if answer.status_code != 200:
                raise RuntimeError(f"{self.folder}: {path}: {answer.text[:300]}")
        return self.seconds() - before


@contextmanager
def running(folder: Path, asked_of: Sequence[int] | None = None) -> Iterator[Running]:
    """Yield the service of a revision: a running one, by its process and port, or a new one."""
    if not asked_of:
        environment = os.environ | {"PYTHONPATH": "."}
        subprocess.run([sys.executable, "-m", "app.compiled"], cwd=folder, env=environment)
    with service("app.serve", running=asked_of, workers=1, folder=folder) as started:
        asked = Running(folder, started.pid, started.port)
        yield asked
        asked.client.close()


def measured(both: list[Running], asked: Asked, rounds: int) -> Iterator[tuple[str, float, float]]:
    """Name of each request, its cost in the first service, and the median ratio of the second."""
    numbers = itertools.count()
    for name, (path, body) in asked.items():

        def bodies(times: int, body: Callable[[int], Any] = body) -> list[bytes]:
            return [json.dumps(body(next(numbers))).encode() for _ in range(times)]

        once = max(both[0].cost(path, bodies(3)) / 3, both[1].cost(path, bodies(3)) / 3, 1e-5)
        times = 1 if rounds == 1 else max(1, round(AT_LEAST_S / once))
        took = []
        for number in range(rounds if once < 1 else min(rounds, FEW)):
            sent = bodies(times)
            order = (0, 1) if number % 2 else (1, 0)
            costs = {place: both[place].cost(path, sent) / times for place in order}
            took.append((costs[0], costs[1]))
        first = statistics.median(each[0] for each in took)
        yield name, first, statistics.median(new / old for old, new in took)


def until_the_figure(both: list[Running], rounds: int) -> tuple[str, float, float]:
    """Name, time and ratio of the first figure on the page, both services in turn."""
    with chromium.started() as browser:
        took = [[first_figure(browser, each.url, 1) / 1e3 for each in both] for _ in range(rounds)]
    first = statistics.median(each[0] for each in took)
    return "first figure", first, statistics.median(new / old for old, new in took)


def main(base: str, smallest: bool, asked_of: Sequence[int] | None) -> int:
    """Print the table; 1 if this revision takes longer than it may."""
    rounds = 1 if smallest else ROUNDS
    with tempfile.TemporaryDirectory() as temporary, ExitStack() as stack:
        other = Path(temporary)
        if not smallest:
            extract(base, other)
        own = stack.enter_context(running(ROOT, asked_of))
        both = [own if smallest else stack.enter_context(running(other)), own]
        asked = requests(10 if smallest else TOGETHER)
        if smallest:
            asked = {name: asked[name] for name in ("hertz", "whole design", "batch of hertz")}
        print(f"{'asked':26s} {'before, ms':>10s} {'ratio':>6s}")
        ratios = []
        found = measured(both, asked, rounds)
        pages = [until_the_figure] if chromium.path() and not smallest else []
        for name, before, ratio in itertools.chain(found, (page(both, rounds) for page in pages)):
            print(f"{name:26s} {1e3 * before:10.3f} {ratio:6.3f}", flush=True)
            ratios.append(ratio)
    median, worst = statistics.median(ratios), max(ratios)
    print(f"median {median:.3f} (at most {MEDIAN}), worst {worst:.3f} (at most {WORST})")
    return int(not smallest and (median > MEDIAN or worst > WORST))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("base", nargs="?", default="HEAD", help="the revision to compare with")
    parser.add_argument("--smallest", action="store_true", help="a few, of this revision alone")
    add_service(parser)  # a running service is one of this revision
    given = parser.parse_args()
    sys.exit(main(given.base, given.smallest, given.service))
