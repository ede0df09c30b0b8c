"""Bodies and clients that mean harm: small answers, little memory, a loop that is free for others.

What is measured are bytes, memory and processor time of the worker, not how long anything takes.
"""

import json
import os
import random
import re
import socket
import threading
import time
from contextlib import ExitStack
from pathlib import Path

import httpx
import pytest

from tests.running_service import calculators, eventually, family

MOST_BYTES = 100_000
MOST_MB = 500
MOST_LOOP_S = 0.05

BODY, BATCH = 262_144, 1_048_576  # the default limits
HERTZ = {"force_N": 5000, "contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}
FORCE = b'"pins":3,"ratio":20,"output_torque_Nm":500,"pin_circle_radius_mm":50'


def many(item, size):
    """List of the given size."""
    return b",".join([item] * (size // (len(item) + 1)))


def names(size):
    """Object of the given size with unknown names, all different."""
    return b",".join(b'"%d":0' % (10**6 + n) for n in range(size // 12))


def force(field):
    return b"{" + FORCE + b"," + field + b"}"


def batch(requests, rest=b""):
    return b'{"calculation":"hertz","requests":[' + requests + b"]" + rest + b"}"


FLOODS = {
    "include": ("contact-force", force(b'"include":[' + many(b"0", BODY - 200) + b"]")),
    "angles": ("contact-force", force(b'"crank_angles_deg":[' + many(b'""', BODY - 200) + b"]")),
    "unknown names": ("contact-force", force(names(BODY - 200))),
    "a long name": ("contact-force", force(b'"' + b"x" * (BODY - 200) + b'":0')),
    "long names": ("contact-force", force(many(b'"' + b"\\u0001" * 600 + b'":0', BODY - 4000))),
    "gaps": ("roller-strength", b'{"gaps_mm":[' + many(b"[]", BODY - 50) + b"]}"),
    "rollers": ("precession/contact-line", b'{"rollers":[' + many(b"{}", BODY - 50) + b"]}"),
    "names in rollers": (
        "precession/contact-line",
        b'{"rollers":[' + many(b"{" + many(b'"":0', 500) + b"}", BODY - 600) + b"]}",
    ),
    "brackets": ("contact-force", b"[" * BODY),
    "no requests": ("batch", batch(many(b"1", BATCH - 100))),
    "empty requests": ("batch", batch(many(b"{}", BATCH - 100))),
    "names in a batch": ("batch", batch(b"{}", b"," + names(BATCH - 100))),
    "lists in a request": ("batch", batch(b'{"a":[' + many(b"[]", BATCH - 100) + b"]}")),
    "objects in a request": ("batch", batch(b'{"a":[' + many(b"{}", BATCH - 100) + b"]}")),
    "no JSON": ("batch", b"[" * BATCH),
}


def loop_s(pid):
    """Seconds that a worker's event loop, its first thread, has calculated."""
    return int(Path(f"/proc/{pid}/task/{pid}/schedstat").read_text().split()[0]) / 1e9


def cheaply(pid, ask):
    """An answer that costs a worker's loop little, the first of three times at last."""
    for _ in range(3):
        before = loop_s(pid)
        answer = ask()
        if (spent := loop_s(pid) - before) <= MOST_LOOP_S:
            return answer
    raise AssertionError(f"{spent:.3f} s of the loop")


def peak_mb(pid):
    (line,) = [
        line for line in Path(f"/proc/{pid}/status").read_text().splitlines() if "VmHWM" in line
    ]
    return int(line.split()[1]) / 1024


@pytest.fixture(scope="module")
def running(served):
    with httpx.Client(base_url=f"{served.url}/api/v1/", timeout=240) as client:
        yield served.process.pid, client


def post(client, path, content):
    headers = {"content-type": "application/json"}
    return client.post(path, content=content, headers=headers, timeout=240)


@pytest.mark.parametrize("flood", FLOODS)
def test_a_flood_is_refused_in_few_words_and_costs_the_worker_little(running, flood):
    pid, client = running
    path, content = FLOODS[flood]
    assert len(content) <= (BATCH if path == "batch" else BODY)
    answer = cheaply(pid, lambda: post(client, path, content))
    assert len(answer.content) <= MOST_BYTES
    assert answer.status_code == 422 or "problem" in answer.json()["results"][0]
    assert peak_mb(pid) <= MOST_MB


def test_a_small_request_for_a_large_answer_costs_the_loop_little(running):
    pid, client = running
    body = {"pins": 50, "ratio": 20, "output_torque_Nm": 500, "pin_circle_radius_mm": 50}
    asked = body | {"include": ["curves"], "samples": 10000}
    answer = cheaply(pid, lambda: client.post("contact-force", json=asked))
    assert answer.headers["content-encoding"] == "gzip"
    assert len(answer.content) > 8_000_000


def test_answers_that_nobody_takes_are_bounded(running):
    """60 clients ask for 9 MB each and read nothing; whoever reads is answered."""
    pid, client = running
    metric = r'(?m)^khv_requests_total{method="POST",route="/api/v1/contact-force",.*} (\S+)$'

    def ended():
        metrics = client.get(client.base_url.join("/metrics")).text
        return sum(map(float, re.findall(metric, metrics))) - before

    before = 0
    before = ended()
    body = {"pins": 50, "ratio": 20, "output_torque_Nm": 500, "pin_circle_radius_mm": 50}
    large = json.dumps(body | {"include": ["curves"], "samples": 10000}).encode()
    head = (
        b"POST /api/v1/contact-force HTTP/1.1\r\nhost: x\r\naccept-encoding: gzip\r\n"
        b"content-type: application/json\r\ncontent-length: %d\r\n\r\n" % len(large)
    )
    with ExitStack() as idle:
        for _ in range(60):
            connection = socket.socket()
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            connection.connect((client.base_url.host, client.base_url.port))
            idle.enter_context(connection).sendall(head + large)
        while ended() < 60:
            assert client.post("hertz", json=HERTZ).status_code == 200
            time.sleep(0.1)
    assert peak_mb(pid) <= MOST_MB


def test_a_batch_of_wrong_requests_names_a_few_of_their_errors(running):
    pid, client = running
    wrong = {f"unknown field {n}": 0 for n in range(30)}
    asked = {"calculation": "hertz", "requests": [wrong] * 1000}
    results = client.post("batch", json=asked).json()["results"]
    assert len(results) == 1000
    named = [each["problem"].pop("errors") for each in results]
    assert sum(map(len, named)) == 100
    assert len(json.dumps(named)) <= MOST_BYTES
    assert all(each["problem"]["more"] == 34 for each in results[3:])
    assert peak_mb(pid) <= MOST_MB


def test_a_batch_of_large_answers_is_not_kept_in_memory(running):
    """400 MB of answers, as one object and as lines."""
    pid, client = running
    large = {
        "pins": 100,
        "ratio": 20,
        "output_torque_Nm": 500,
        "pin_circle_radius_mm": 50,
        "include": ["curves"],
        "samples": 2500,
    }
    asked = {"calculation": "contact_force", "requests": [large] * 50}
    for accept in ("application/json", "application/x-ndjson"):
        received = 0
        headers = {"accept": accept, "accept-encoding": "identity"}
        with client.stream("POST", "batch", json=asked, headers=headers) as answer:
            for part in answer.iter_raw():
                received += len(part)
        assert received > 200e6
        assert peak_mb(pid) <= MOST_MB


STUDY = json.dumps(
    {
        "calculation": "peak_force",
        "input": {
            "pins": 6,
            "satellites": 3,
            "ratio": 20,
            "crank_angles_deg": [0, 100, 200],
            "output_torque_Nm": 500,
            "pin_circle_radius_mm": 50,
            "force_exponent": 1.5,
        },
    }
).encode()
"""Some tenths of a second."""


def test_clients_that_leave_leave_nothing_behind(two_workers):
    """300 times, within 0 to 200 ms."""
    head = b"POST /api/v1/work-precision HTTP/1.1\r\nhost: x\r\ncontent-type: application/json\r\n"
    request = head + b"content-length: %d\r\n\r\n" % len(STUDY) + STUDY

    def leave_soon(seed):
        r = random.Random(seed)
        for _ in range(100):
            with socket.socket(socket.AF_UNIX) as connection:
                connection.settimeout(30)
                connection.connect(two_workers.uds)
                connection.sendall(request)
                time.sleep(r.uniform(0, 0.2))

    first = two_workers.process.pid
    asked = [pid for pid in family(first) if b"spawn_main" in command_line(pid)]

    def started():
        return len(family(first)), sum(len(os.listdir(f"/proc/{pid}/fd")) for pid in asked)

    def answered():
        with two_workers.client() as client:
            return post(client, "/api/v1/work-precision", STUDY).status_code == 200

    assert eventually(lambda: all(len(calculators(pid)) == 2 for pid in asked))
    assert answered()
    for _ in range(40):  # each worker opens its last file with its first answer
        with two_workers.client() as client:
            assert client.get("/livez").status_code == 200
    before = started()
    leaving = [threading.Thread(target=leave_soon, args=(seed,)) for seed in range(3)]
    for each in leaving:
        each.start()
    for each in leaving:
        each.join()
    assert answered()
    assert eventually(lambda: started()[0] <= before[0] and started()[1] <= before[1])
    assert all(len(calculators(pid)) == 2 for pid in asked)
    assert all(line["level"] == "info" for line in two_workers.log())


def command_line(pid):
    return Path(f"/proc/{pid}/cmdline").read_bytes()
