"""What has held or broken the service once, in variants, against a running one: does it hold now?

Each attack is repeated in 20 variants that a seed draws: names, exponents, sizes, sample counts,
percentiles. First each by itself: how long it holds the event loop, as processor time of the
workers' first threads. Then eight clients send all of them while another one asks for `/livez`.
Slow clients have to get the whole of a large batch, and what is no free socket has to stay as it
is. Ends with 1 where the loop is held for more than 0.1 s, or 0.03 s by what is let in, where the
99th percentile of `/livez` is above 0.25 s, or where anything is cut short, deleted or taken.
`make attacks`; variants and seed may be given: `python -m benchmarks.attacks 50 7`.
"""

import json
import os
import random
import socket
import string
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from pathlib import Path
from statistics import median, quantiles
from typing import Any
from urllib.request import urlopen

import httpx

from app.examples import REQUESTS
from benchmarks.load import Service, service
from benchmarks.options import options

VARIANTS, CLIENTS = 20, 8

HELD_S, ADMITTED_S, LIVEZ_S = 0.1, 0.03, 0.25
"""Longest that the loop may be held, by what is let in, and slowest `/livez` of a hundred."""

RECEIVE_S = 4
"""Time for a part of an answer: long for 256 kB, short for a slice of a batch."""

TIMES = 3
"""How often each is sent alone: the least counts, as a busy machine only adds."""

Body = dict[str, Any]


def named(r: random.Random, body: Body) -> Body:
    """The same, every third time with a field that nobody knows: refused."""
    if r.random() < 1 / 3:
        body["".join(r.choices(string.ascii_letters, k=r.randint(1, 60)))] = 0
    return body


def study(r: random.Random) -> Body:
    """Many samples and percentiles."""
    body = deepcopy(REQUESTS["tolerance-study"])
    body |= {"samples": int(10 ** r.uniform(4, 5.14)), "crank_angles": 12}
    body["mechanism"] |= {"pins": 3, "satellites": 1}  # else so many are refused for their pairs
    highest = r.choice([99.0, 99.9, 99.99])
    body["percentiles"] = [round(r.uniform(1, highest), 2) for _ in range(20)]
    return named(r, body)


def by_exponent(name: str) -> Callable[[random.Random], Body]:
    """Forces by a large exponent, of many pairs."""

    def drawn(r: random.Random) -> Body:
        body = deepcopy(REQUESTS[name])
        mechanism, load = body.get("mechanism", body), body.get("load", body)
        satellites = len(body.get("crankshaft", {}).get("satellite_positions_mm", ())) or None
        satellites = satellites or r.choice([1, 2, 3, 7])
        mechanism |= {"pins": r.randint(6, 120), "satellites": satellites}
        if "pin" in body:
            body["pin"]["satellite_positions_mm"] = [30.0 * (1 + k) for k in range(satellites)]
        load["force_exponent"] = 10 ** r.uniform(-0.5, 6)
        return named(r, body)

    return drawn


ATTACKS: dict[str, tuple[str, Callable[[random.Random], Body]]] = {
    "studies of many samples": ("tolerance-study", study),
    **{
        f"exponents: {name}": (name, by_exponent(name))
        for name in (
            "contact-force",
            "crank-planetary",
            "crankshaft",
            "output-efficiency",
            "pin-strength",
            "satellite-bearing",
        )
    },
}


def loop_s(running: Service) -> float:
    """Seconds that the event loops have calculated: the first threads of the workers."""
    return sum(
        int(Path(f"/proc/{pid}/task/{pid}/schedstat").read_text().split()[0]) / 1e9
        for pid in running.workers()
    )


def held_s(running: Service, client: httpx.Client, path: str, body: Body) -> tuple[float, int]:
    """How long a request holds the loop, and what it is answered."""
    least = float("inf")
    for _ in range(TIMES):
        before = loop_s(running)
        status = client.post(path, json=body).status_code
        least = min(least, loop_s(running) - before)
    return least, status


def crowd(url: str, asked: list[tuple[str, Body]]) -> list[float]:
    """How long `/livez` takes while clients send all of it, seconds."""
    took: list[float] = []
    done = threading.Event()

    def watch() -> None:
        while not done.is_set():
            start = time.perf_counter()
            with urlopen(f"{url}/livez", timeout=60) as answer:  # httpx takes as long as it does
                answer.read()
            took.append(time.perf_counter() - start)
            time.sleep(0.005)

    def send(each: tuple[str, Body]) -> None:
        httpx.post(f"{url}/api/v1/{each[0]}", json=each[1], timeout=240)

    watching = threading.Thread(target=watch)
    watching.start()
    with ThreadPoolExecutor(CLIENTS) as clients:
        [*clients.map(send, asked)]
    done.set()
    watching.join()
    return took


def whole(port: int, r: random.Random, quick: bool) -> bool:
    """Whether a client that takes some MB a second gets the whole of a large batch, or is told to
    come again.
    """
    large = REQUESTS["contact-force"] | {"pins": 50, "include": ["curves"]}
    requests = [large | {"samples": r.randint(1000, 2000)} for _ in range(r.randint(5, 15))]
    content = json.dumps({"calculation": "contact-force", "requests": requests}).encode()
    rate = 5e7 if quick else r.uniform(1e6, 3e6)
    received = b""
    with socket.socket() as slow:
        slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 16)
        slow.settimeout(60)
        slow.connect(("127.0.0.1", port))
        slow.sendall(
            b"POST /api/v1/batch HTTP/1.1\r\nhost: x\r\nconnection: close\r\n"
            b"content-type: application/json\r\ncontent-length: %d\r\n\r\n" % len(content) + content
        )
        while part := slow.recv(1 << 16):
            received += part
            time.sleep(len(part) / rate)
    return received.startswith(b"HTTP/1.1 503") or received.endswith(b"0\r\n\r\n")


def kept(r: random.Random) -> bool:
    """Whether a file and a live socket are left as they are."""
    with tempfile.TemporaryDirectory() as place, socket.socket(socket.AF_UNIX) as live:
        name = "".join(r.choices(string.ascii_letters + " .", k=r.randint(1, 40)))
        path = Path(place, f"{name}x")
        content = r.randbytes(r.randint(0, 100))
        if is_live := r.random() < 0.5:
            live.bind(str(path))
            live.listen()
        else:
            path.write_bytes(content)
        ended = subprocess.run(
            [sys.executable, "-m", "app.serve"],
            env=os.environ | {"KHV_UNIX_SOCKET": str(path)},
            capture_output=True,
        )
        there = path.exists() and (is_live or path.read_bytes() == content)
        return there and ended.returncode == 1


def faults(variants: int, seed: int, smallest: bool) -> Iterator[str]:
    """Send all, say what came of it, and what did not hold."""
    r = random.Random(seed)
    with service("app.serve") as running:
        url = f"http://127.0.0.1:{running.port}"
        asked = []
        with httpx.Client(base_url=f"{url}/api/v1/", timeout=240) as client:
            for attack, (path, draw) in ATTACKS.items():
                bodies = [draw(r) for _ in range(variants)]
                asked += [(path, body) for body in bodies]
                found = [held_s(running, client, path, body) for body in bodies]
                held = max(each for each, _ in found)
                let_in = max((each for each, status in found if status == 200), default=0.0)
                answers = sorted({status for _, status in found})
                ms = f"held {1e3 * held:6.1f} ms, by what is let in {1e3 * let_in:6.1f} ms"
                print(f"{attack:34} {ms}, {answers}", flush=True)
                if held > HELD_S or let_in > ADMITTED_S:
                    yield f"{attack} hold the loop"
        r.shuffle(asked)
        took = crowd(url, asked)
        last = quantiles(took, n=100)[98] if len(took) > 1 else took[0]
        print(f"/livez: p50 {1e3 * median(took):.1f} ms, p99 {1e3 * last:.1f} ms of {len(took)}")
        if last > LIVEZ_S:
            yield "/livez is slow"
        slow = [random.Random(r.random()) for _ in range(variants)]
        with ThreadPoolExecutor(CLIENTS) as clients:
            got = [*clients.map(lambda each: whole(running.port, each, smallest), slow)]
        print(f"slow clients: {sum(got)} of {len(got)} batches whole")
        if not all(got):
            yield "batches are cut short"
    left = [kept(r) for _ in range(variants)]
    print(f"files and sockets: {sum(left)} of {len(left)} left as they are")
    if not all(left):
        yield "a file or a socket was taken"


def main(variants: int, seed: int, smallest: bool = False) -> int:
    """Run the attacks; 1 if the service did not hold."""
    print(f"{variants} variants, seed {seed}", flush=True)
    os.environ["KHV_RECEIVE_SECONDS"] = str(RECEIVE_S)
    found = [*faults(variants, seed, smallest)]
    for fault in found:
        print(f"FAULT: {fault}")
    return bool(found) and not smallest


if __name__ == "__main__":
    given = options(__doc__, variants=VARIANTS, seed=None)
    seed = random.randrange(10**6) if given.seed is None else given.seed
    sys.exit(main(1, 0, smallest=True) if given.smallest else main(given.variants, seed))
