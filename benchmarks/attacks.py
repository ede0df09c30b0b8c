"""Attacks that once held or broke the service, in variants, against a running one.

Each attack comes in 20 variants that a seed draws: names, exponents, sizes, sample counts,
percentiles. Each request first runs alone, to measure how long it holds the event loop, by the
processor time of the workers' first threads. Then eight clients send all of them while another
client asks for `/livez` and for an idle empty endpoint on the same machine. Bodies in unknown
codings have to be refused, and large bodies from one address have to leave places to others. Slow
clients have to get the whole of a large batch, and a file or a live socket has to stay as it is.
Bodies that do not end, answers that nobody takes, requests one behind the other and long names must
not fill memory. The status is 1 if the loop is held for more than 0.1 s, or 0.03 s by a request
that is let in, if the 99th percentile of `/livez` is above 20 times that of the empty endpoint, if
memory grows by more than 300 MB, or if anything is cut short, deleted or taken.
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
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, suppress
from copy import deepcopy
from pathlib import Path
from statistics import median, quantiles
from typing import Any
from urllib.request import urlopen

import httpx

from app.examples import REQUESTS
from app.registry import CALCULATIONS
from benchmarks.load import Service, service
from benchmarks.options import options
from benchmarks.soak import sample
from tests.inputs.loop_requests import largest_in_the_loop

VARIANTS, CLIENTS = 20, 8

HELD_S, ADMITTED_S, LIVEZ_TIMES = 0.1, 0.03, 20.0
"""Longest time for which a request may hold the loop, and one that is let in; largest ratio of the
99th percentile of `/livez` to that of an idle empty endpoint."""

RECEIVE_S = 4
"""Time for a part of an answer, s: long for 256 kB, short for a slice of a batch."""

TIMES = 3
"""Number of times that each request is sent alone; the least time counts, as load only adds."""

SHORT = ("exponents: contact-force", "exponents: satellite-bearing")
"""Attacks of the smallest form."""

MOST_MB = 300
"""Largest growth of the memory of all processes, MB."""

BODY, BATCH = 262_144, 1_048_576
"""Limits of a body and of a batch, bytes."""

Body = dict[str, Any]


def named(r: random.Random, body: Body) -> Body:
    """Body with an unknown field one time in three, for which it is refused."""
    if r.random() < 1 / 3:
        body["".join(r.choices(string.ascii_letters, k=r.randint(1, 60)))] = 0
    return body


def study(r: random.Random) -> Body:
    """Tolerance study of many samples and percentiles."""
    body = deepcopy(REQUESTS["tolerance-study"])
    body |= {"samples": int(10 ** r.uniform(4, 5.14)), "crank_angles": 12}
    body["mechanism"] |= {"pins": 3, "satellites": 1}  # more pairs would be refused
    highest = r.choice([99.0, 99.9, 99.99])
    body["percentiles"] = [round(r.uniform(1, highest), 2) for _ in range(20)]
    return named(r, body)


def by_exponent(name: str) -> Callable[[random.Random], Body]:
    """Function that draws a request with a large force exponent and many pairs."""

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


def largest(name: str) -> Callable[[random.Random], Body]:
    """Function that draws the largest request that the event loop answers."""

    def drawn(r: random.Random) -> Body:
        body = largest_in_the_loop(CALCULATIONS[name], r)
        assert body is not None
        return body

    return drawn


def target(r: random.Random) -> Body:
    """Inverse problem for a result that no answer has."""
    name = "".join(r.choices(string.ascii_lowercase, k=r.randint(1, 60)))
    above = r.choice(["", "/checks", "/load_sharing", "/checks/pin_static", "/hertz/half_width_mm"])
    sense = r.choice(["at_least", "at_most", "equals"])
    return deepcopy(REQUESTS["solve"]) | {"target": {"pointer": f"{above}/{name}", sense: 1.0}}


ATTACKS: dict[str, tuple[str, Callable[[random.Random], Body]]] = {
    "studies of many samples": ("tolerance-study", study),
    "targets that are nowhere": ("solve", target),
    **{
        f"largest: {name}": (name, largest(name))
        for name in (
            "contact-force",
            "crank-planetary",
            "output-efficiency",
            "satellite-bearing",
            "precession/contact-line",
            "precession/shaft-deflection",
        )
    },
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
    """Processor time of the event loops, which are the workers' first threads, s."""
    return sum(
        int(Path(f"/proc/{pid}/task/{pid}/schedstat").read_text().split()[0]) / 1e9
        for pid in running.workers()
    )


def held_s(
    running: Service, client: httpx.Client, path: str, body: Body, times: int
) -> tuple[float, int]:
    """Least time for which a request holds the loop, s, and its status."""
    least = float("inf")
    for _ in range(times):
        before = loop_s(running)
        status = client.post(path, json=body).status_code
        least = min(least, loop_s(running) - before)
    return least, status


def crowd(url: str, empty: str, asked: list[tuple[str, Body]]) -> tuple[list[float], list[float]]:
    """Times of `/livez` and of an idle empty endpoint while clients send all requests, s."""
    took: tuple[list[float], list[float]] = ([], [])
    done = threading.Event()

    def watch() -> None:
        while not done.is_set():
            for each, times in zip((f"{url}/livez", empty), took, strict=True):
                start = time.perf_counter()
                with urlopen(each, timeout=60) as answer:  # httpx alone takes about as long
                    answer.read()
                times.append(time.perf_counter() - start)
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
    """True if a client of some MB a second gets a whole large batch, or status 503."""
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


def post(path: str, content: bytes, announced: int = 0) -> bytes:
    """Request, or the beginning of one whose header announces more bytes."""
    head = f"POST /api/v1/{path} HTTP/1.1\r\nhost: x\r\ncontent-type: application/json\r\n"
    return f"{head}content-length: {announced or len(content)}\r\n\r\n".encode() + content


def answered(port: int, content: bytes, client: str = "127.0.0.1") -> int:
    """Status of the answer to what a client sends from an address."""
    with socket.create_connection(("127.0.0.1", port), 60, (client, 0)) as connection:
        connection.sendall(content)
        return int(connection.recv(1 << 16).split(b" ", 2)[1] or 0)


def uncoded(port: int, r: random.Random) -> bool:
    """True if a body in an unknown coding, or by HTTP/1.0 in any coding, is refused."""
    old = r.random() < 0.3
    name = "chunked" if old else "".join(r.choices(string.ascii_lowercase, k=r.randint(1, 20)))
    codings = name if old or r.random() < 0.3 else f"{name}{r.choice([', ', ',', ' , '])}chunked"
    head = f"POST /api/v1/hertz HTTP/1.{0 if old else 1}\r\nhost: x\r\ntransfer-encoding: {codings}"
    status = answered(port, f"{head}\r\n\r\n2\r\n{{}}\r\n0\r\n\r\n".encode())
    return status in (400, 501)


def shared(port: int, r: random.Random) -> bool:
    """True if another address has a place beside one that fills all its places with bodies."""
    with ExitStack() as opened:
        for _ in range(r.randint(30, 60)):
            connection = opened.enter_context(socket.create_connection(("127.0.0.1", port), 60))
            connection.sendall(unfinished(r))
        time.sleep(1)
        other = f"127.0.0.{r.randint(2, 250)}"
        return answered(port, post("hertz", b" " * r.randint(17_000, BODY)), other) == 422


def unfinished(r: random.Random) -> bytes:
    """Request with a large body whose last byte does not come."""
    path, most = r.choice([("hertz", BODY), ("batch", BATCH)])
    size = r.randint(most // 2, most)
    return post(path, b" " * (size - 1), size)


def untaken(r: random.Random) -> bytes:
    """Request for a large answer, alone or many in a batch."""
    large = REQUESTS["contact-force"] | {"pins": 50, "include": ["curves"]}
    large |= {"samples": r.randint(1000, 10_000)}
    if r.random() < 0.3:
        return post("contact-force", json.dumps(large).encode())
    batch = {"calculation": "contact-force", "requests": [large] * r.randint(20, 200)}
    return post("batch", json.dumps(batch).encode())


def piped(r: random.Random) -> bytes:
    """Many small requests, one behind the other."""
    path = r.choice(["/livez", "/", "/api/v1/health", "/static/main.js"])
    one = f"GET {path} HTTP/1.1\r\nhost: {'x' * r.randint(1, 20)}\r\n\r\n".encode()
    return one * (252_000 // len(one))


def long_head(r: random.Random) -> bytes:
    """Request with a head that is too long, in one packet."""
    name = "".join(r.choices(string.ascii_letters, k=r.randint(1, 60)))
    return (
        f"GET / HTTP/1.1\r\nhost: x\r\n{name}: {'y' * r.randint(66_000, 99_000)}\r\n\r\n".encode()
    )


def long_name(r: random.Random) -> bytes:
    """Batch of a request with a field name of nearly its size."""
    name = "".join(r.choices(string.ascii_letters, k=20)) + "x" * r.randint(BODY, BATCH - 1000)
    return post("batch", json.dumps({"calculation": "hertz", "requests": [{name: 0}]}).encode())


CROWDS: dict[str, tuple[int, bool, Callable[[random.Random], bytes]]] = {
    "bodies without an end": (150, False, unfinished),
    "answers that nobody takes": (40, False, untaken),
    "requests one behind the other": (40, False, piped),
    "heads of 66 kB and more": (40, True, long_head),
    "names of 1 MB": (50, True, long_name),
}
"""Attacks on memory and loop: number of connections, True if they wait for an answer, content."""


def crowded(
    running: Service, connections: int, waits: bool, sent: list[bytes], looks: int
) -> tuple[float, float]:
    """Growth of memory while all connections are open, MB, and loop time of each, s."""
    before, held = memory_mb(running), loop_s(running)
    most = before
    with ExitStack() as opened:
        for content in sent:
            connection = opened.enter_context(socket.socket())
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 12)
            connection.settimeout(0.5)
            connection.connect(("127.0.0.1", running.port))
            with suppress(OSError):  # the service may refuse it early or not read it
                connection.sendall(content)
                if waits:
                    connection.settimeout(60)
                    connection.recv(1 << 16)
            most = max(most, memory_mb(running))
        for _ in range(looks):
            time.sleep(0.1)
            most = max(most, memory_mb(running))
        held = loop_s(running) - held
    return most - before, held / connections


def memory_mb(running: Service) -> float:
    """Memory of all processes of the service, each shared page counted once, MB."""
    return sample(running.pid, 0.0).memory_mb


def first_with_clearance(client: httpx.Client) -> float:
    """Time by which the first design with clearance takes longer than the next, s."""
    took = []
    for _ in range(2):
        start = time.perf_counter()
        client.post("load-sharing", json=REQUESTS["load-sharing"]).raise_for_status()
        took.append(time.perf_counter() - start)
    return took[0] - took[1]


def kept(r: random.Random) -> bool:
    """True if the service refuses to start on a file or a live socket and leaves it alone."""
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


def faults(
    variants: int, seed: int, smallest: bool, asked_of: Sequence[int] | None
) -> Iterator[str]:
    """Send all attacks and print their results; yield each fault."""
    r = random.Random(seed)
    with service("app.serve", running=asked_of) as running:
        url = f"http://127.0.0.1:{running.port}"
        asked = []
        with httpx.Client(base_url=f"{url}/api/v1/", timeout=240) as client:
            while client.get(f"{url}/readyz").status_code != 200:
                time.sleep(0.1)
            print(f"first design with clearance: {1e3 * first_with_clearance(client):.0f} ms more")
            for attack in SHORT if smallest else ATTACKS:
                path, draw = ATTACKS[attack]
                bodies = [draw(r) for _ in range(variants)]
                asked += [(path, body) for body in bodies]
                times = 1 if smallest else TIMES
                found = [held_s(running, client, path, body, times) for body in bodies]
                held = max(each for each, _ in found)
                let_in = max((each for each, status in found if status == 200), default=0.0)
                answers = sorted({status for _, status in found})
                ms = f"held {1e3 * held:6.1f} ms, by what is let in {1e3 * let_in:6.1f} ms"
                print(f"{attack:34} {ms}, {answers}", flush=True)
                if held > HELD_S or let_in > ADMITTED_S:
                    yield f"{attack} hold the loop"
        r.shuffle(asked)
        with service("uvicorn", "benchmarks.load:hello", "--log-level", "error", workers=1) as idle:
            took = crowd(url, f"http://127.0.0.1:{idle.port}/hello", asked)
        last, empty = (quantiles(each, n=100)[98] if len(each) > 1 else each[0] for each in took)
        print(
            f"/livez: p50 {1e3 * median(took[0]):.1f} ms, p99 {1e3 * last:.1f} ms, which is "
            f"{last / empty:.1f} times that of an idle empty endpoint, {len(took[0])} each"
        )
        if last > LIVEZ_TIMES * empty:
            yield "/livez is slow"
        for what, holds, times in (
            ("bodies in other codings: {} of {} refused", uncoded, variants),
            ("places: {} of {} left to another address", shared, 1 if smallest else 3),
        ):
            got = [holds(running.port, r) for _ in range(times)]
            print(what.format(sum(got), len(got)), flush=True)
            if not all(got):
                yield what.format(sum(got), len(got))
        for attack, (connections, waits, send) in CROWDS.items():
            sent = [send(r) for _ in range(1 if smallest else connections)]
            grown, held = crowded(running, connections, waits, sent, 1 if smallest else 20)
            print(
                f"{attack:34} memory +{grown:4.0f} MB, held {1e3 * held:6.1f} ms each", flush=True
            )
            if grown > MOST_MB:
                yield f"{attack} take memory"
            if held > HELD_S:
                yield f"{attack} hold the loop"
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


def main(
    variants: int, seed: int, smallest: bool = False, asked_of: Sequence[int] | None = None
) -> int:
    """Run the attacks; 1 if the service did not hold."""
    print(f"{variants} variants, seed {seed}", flush=True)
    if asked_of is None:
        os.environ["KHV_RECEIVE_SECONDS"] = str(RECEIVE_S)
    found = [*faults(variants, seed, smallest, asked_of)]
    for fault in found:
        print(f"FAULT: {fault}")
    return bool(found) and not smallest


if __name__ == "__main__":
    given = options(__doc__, asks=True, variants=VARIANTS, seed=None)
    seed = random.randrange(10**6) if given.seed is None else given.seed
    drawn = (1, 0) if given.smallest else (given.variants, seed)
    sys.exit(main(*drawn, given.smallest, given.service))
