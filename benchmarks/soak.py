"""Twenty minutes of mixed traffic on the running service, and growth of its memory and processes.

Clients of four kinds ask at once, each as fast as it is answered: extreme and hostile bodies
(tests/inputs/fuzz_requests.py), figures, batches by lines, and requests that are given up within
0.3 s. Two workers answer. Every second processes, memory and descriptors of the service are
counted; docs/soak.svg shows them, the output has tables. The status is 1 if the last third has more
processes, or more than 10 % more memory or descriptors, than the third before, or if an answer was
500. `make soak`; minutes may be given: `python -m benchmarks.soak 3`.
"""

import asyncio
import contextlib
import os
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

import httpx

from app.examples import EXAMPLES, REQUESTS
from benchmarks.load import service
from benchmarks.options import options
from tests.inputs.fuzz_requests import Draw, random_request

MINUTES = 20
DRAWN = Path(__file__).parent.parent / "docs" / "soak.svg"

Answers = Counter[tuple[str, str]]


@dataclass(frozen=True, slots=True)
class Sample:
    """Processes, proportional memory and descriptors of the service at a time."""

    minutes: float
    processes: int
    memory_mb: float
    descriptors: int


def family(pid: int) -> list[int]:
    """Process ids of a process and of all its descendants."""
    with contextlib.suppress(FileNotFoundError):
        threads = Path(f"/proc/{pid}/task").iterdir()
        started = [
            int(child) for each in threads for child in (each / "children").read_text().split()
        ]
        return [pid, *(one for child in started for one in family(child))]
    return []


def sample(pid: int, minutes: float) -> Sample:
    """Sample of the service now; processes that end meanwhile are not counted."""
    count, memory, descriptors = 0, 0.0, 0
    for each in family(pid):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            rolled = Path(f"/proc/{each}/smaps_rollup").read_text()
            memory += sum(
                int(line.split()[1]) for line in rolled.splitlines() if line.startswith("Pss:")
            )
            descriptors += len(os.listdir(f"/proc/{each}/fd"))
            count += 1
    return Sample(minutes, count, memory / 1024, descriptors)


async def _ask(client: httpx.AsyncClient, kind: str, r: Draw) -> httpx.Response:
    """Send one request of a kind."""
    if kind == "batch":
        name = r.choice(["hertz", "contact-force", "cyclogram", "crank-planetary"])
        body = {"calculation": name, "requests": [REQUESTS[name]] * r.randint(1, 2000)}
        return await client.post("batch", json=body, headers={"accept": "application/x-ndjson"})
    if kind == "chart":
        example = r.choice(EXAMPLES)
        return await client.post(f"{example['calculation']}/chart", json=example["input"])
    if kind == "cancel":
        study = client.post("work-precision", json=REQUESTS["work-precision"])
        return await asyncio.wait_for(study, r.uniform(0, 0.3))
    asked = random_request(r)
    return await client.request(
        asked.method,
        asked.endpoint.lstrip("/"),
        content=asked.body(),
        params=asked.query,
        headers={name: text.encode("latin-1") for name, text in asked.headers.items()},
    )


async def traffic(url: str, kind: str, seed: int, end: float, answers: Answers) -> None:
    """Send requests of a kind, one after another, until the end."""
    r = Draw(seed)
    async with httpx.AsyncClient(base_url=f"{url}/api/v1/", timeout=60) as client:
        while time.monotonic() < end:
            try:
                answers[kind, str((await _ask(client, kind, r)).status_code)] += 1
            except TimeoutError:
                answers[kind, "given up"] += 1
            except httpx.TransportError as error:
                answers[kind, type(error).__name__] += 1


async def run(service_pid: int, url: str, minutes: float) -> tuple[list[Sample], Answers]:
    """Samples of the service under traffic, and its answers."""
    answers: Answers = Counter()
    start = time.monotonic()
    end, samples = start + 60 * minutes, []
    kinds = ["fuzz", "fuzz", "chart", "batch", "cancel", "cancel"]
    async with asyncio.TaskGroup() as group:
        for seed, kind in enumerate(kinds):
            group.create_task(traffic(url, kind, seed, end, answers))
        while time.monotonic() < end or len(samples) < 3:
            minute = (time.monotonic() - start) / 60
            samples.append(await asyncio.to_thread(sample, service_pid, minute))
            await asyncio.sleep(min(1, 12 * minutes))
    return samples, answers


def drawn(samples: list[Sample]) -> str:
    """SVG of memory, processes and descriptors over time, each from 0 to its largest."""
    width, height = 640, 120
    last = max(each.minutes for each in samples)
    rows = []
    for place, (name, title) in enumerate(
        (("memory_mb", "memory, MB"), ("processes", "processes"), ("descriptors", "descriptors"))
    ):
        values = [getattr(each, name) for each in samples]
        most, top = max(values), 20 + place * (height + 40)
        line = " ".join(
            f"{50 + width * each.minutes / last:.1f},{top + height * (1 - value / most):.1f}"
            for each, value in zip(samples, values, strict=True)
        )
        rows.append(
            f'<text x="50" y="{top - 5}">{title}: at most {most:.0f}</text>'
            f'<path d="M50 {top}v{height}h{width}" fill="none" stroke="#888"/>'
            f'<polyline points="{line}" fill="none" stroke="#1f5fa8"/>'
        )
    foot = f'<text x="50" y="{3 * (height + 40) + 15}">0 to {last:.1f} minutes</text>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width + 100} {3 * height + 160}" '
        f'font-family="sans-serif" font-size="13">{"".join(rows)}{foot}</svg>\n'
    )


def main(minutes: float, write: bool, asked_of: Sequence[int] | None) -> int:
    """Run the traffic, draw, and print the result; 1 if something grew or failed."""
    with service("app.serve", running=asked_of) as running:
        url = f"http://127.0.0.1:{running.port}"
        samples, answers = asyncio.run(run(running.pid, url, minutes))
    failed = sum(count for (_, status), count in answers.items() if status == "500")
    print("| kind | what came of it |\n|---|---|")
    for kind in dict.fromkeys(kind for kind, _ in sorted(answers)):
        counts = sorted((status, n) for (one, status), n in answers.items() if one == kind)
        print(f"| {kind} | {', '.join(f'{status}: {n}' for status, n in counts)} |")
    print("\n| third | memory, MB | most processes | descriptors |\n|---|---|---|---|")
    third = len(samples) // 3
    parts = [samples[n * third : (n + 1) * third] for n in range(3)]
    figures = [
        (
            mean(each.memory_mb for each in part),
            max(each.processes for each in part),
            mean(each.descriptors for each in part),
        )
        for part in parts
    ]
    for number, (memory, processes, descriptors) in enumerate(figures, 1):
        print(f"| {number} | {memory:.0f} | {processes} | {descriptors:.0f} |")
    if write:
        DRAWN.write_text(drawn(samples))
    (memory, processes, descriptors), last = figures[1], figures[2]
    grown = last[0] > 1.1 * memory or last[1] > processes or last[2] > 1.1 * descriptors
    return int(failed > 0 or (grown and write))


if __name__ == "__main__":
    asked = options(__doc__, asks=True, minutes=MINUTES)
    minutes = 0.01 if asked.smallest else asked.minutes
    sys.exit(main(minutes, not asked.smallest, asked.service))
