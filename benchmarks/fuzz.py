"""Attempts to break the service: 100,000 designs, hostile numbers and broken bodies.

Every answer is checked (tests/inputs/fuzz.py). Run by `make fuzz`; the number of requests and the
seed may be given: `python -m benchmarks.fuzz 5000 7`.
"""

import asyncio
import random
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat

from benchmarks.options import options
from tests.inputs.fuzz import SLOW_S, Fuzz, Report

REQUESTS = 100_000
PROCESSES = 2


def run(requests: int, seed: int) -> Report:
    """Send random requests to a new service, one after another."""
    return asyncio.run(Fuzz().run(requests, seed))


def main(requests: int, seed: int | None) -> int:
    """Run the fuzz in several processes and print a report; 1 if anything broke."""
    seed = random.randrange(10**6) if seed is None else seed
    print(f"{requests} requests, seed {seed}", flush=True)
    report, start = Report(), time.perf_counter()
    parts = min(requests, 4 * PROCESSES)
    shares = repeat(-(-requests // parts)), range(seed, seed + parts)
    with ProcessPoolExecutor(PROCESSES) as pool:
        for part in map(run, *shares) if parts == 1 else pool.map(run, *shares):
            report.add(part)
    for endpoint in sorted({endpoint for endpoint, _ in report.answers}):
        counts = {status: n for (name, status), n in report.answers.items() if name == endpoint}
        print(f"{endpoint:36}", *(f"{status}: {n:6}" for status, n in sorted(counts.items())))
    print(f"{report.answers.total()} answers in {time.perf_counter() - start:.0f} s")
    print(f"{len(report.slow)} above {SLOW_S} s")
    for took, endpoint, body in sorted(report.slow, reverse=True)[:10]:
        print(f"  {took:.1f} s {endpoint} {body}")
    print(f"{len(report.failures)} failures")
    for failure in report.failures[:20]:
        print(failure)
    return bool(report.failures)


if __name__ == "__main__":
    asked = options(__doc__, requests=REQUESTS, seed=None)
    sys.exit(main(1, 0) if asked.smallest else main(asked.requests, asked.seed))
