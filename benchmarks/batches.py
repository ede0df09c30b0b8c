"""Cost of one batch of 1,000 requests over ten of 100, for every calculation, in one run.

The service runs in a process of its own and takes both in turn, in rounds; the quickest of each
counts. The requests are the example of each calculation, one position of the load sharing, answers
with curves, and requests that are all refused.
"""

import sys
import time
from collections.abc import Sequence
from contextlib import ExitStack
from typing import Any

import httpx

from app.about import API
from app.batch import BATCHED
from app.examples import REQUESTS
from benchmarks.options import options
from benchmarks.service import CURVES, running

TOGETHER, PARTS, ROUNDS = 1000, 10, 5

MOST = 1.2
"""Largest ratio that counts as no more expensive than small batches."""

SHAPES: dict[str, tuple[str, dict[str, Any]]] = {name: (name, REQUESTS[name]) for name in BATCHED}
SHAPES["load-sharing"] = ("load-sharing", REQUESTS["load-sharing"] | {"include": ["positions"]})
SHAPES |= {"curves": ("contact-force", CURVES | {"samples": 100}), "refused": ("hertz", {})}


def main(together: int, parts: int, rounds: int, asked_of: Sequence[int] | None) -> int:
    """Print the table; 1 if a large batch costs more than it may."""
    dearer = []
    with ExitStack() as stack:
        port = asked_of[1] if asked_of else stack.enter_context(running("app.serve")).port
        url = f"http://127.0.0.1:{port}{API}"
        client = stack.enter_context(httpx.Client(base_url=url, timeout=600))

        def seconds(calculation: str, request: dict[str, Any], size: int, times: int) -> float:
            batch = {"calculation": calculation, "requests": [request] * size}
            started = time.perf_counter()
            for _ in range(times):
                answer = client.post("batch", json=batch)
                if answer.status_code != 200 or len(answer.json()["results"]) != size:
                    raise RuntimeError(answer.text)
            return time.perf_counter() - started

        print(f"{'batch of':26s} {f'{parts} x':>9s} {'1 x, ms':>9s} {'ratio':>6s}")
        for shape, (calculation, request) in SHAPES.items():
            took = [
                (
                    seconds(calculation, request, together // parts, parts),
                    seconds(calculation, request, together, 1),
                )
                for _ in range(rounds + 1)
            ][1:]
            small, large = (min(each) for each in zip(*took, strict=True))
            print(f"{shape:26s} {small * 1e3:9.0f} {large * 1e3:9.0f} {large / small:6.2f}")
            if large > MOST * small:
                dearer.append(shape)
    print(f"more than {MOST} times: {', '.join(dearer) or 'none'}")
    return bool(dearer)


if __name__ == "__main__":
    asked = options(__doc__, asks=True, rounds=ROUNDS)
    if asked.smallest:
        main(2, 2, 1, asked.service)
    else:
        sys.exit(main(TOGETHER, PARTS, asked.rounds, asked.service))
