"""Stopping, several workers, logs and metrics of a running service."""

import os
import signal
import socket
import threading
from contextlib import suppress

import httpx
import pytest

from tests.running_service import eventually, family, lives, nothing_is_calculated

LOAD = {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0}
LONG = {"pins": 100, "satellites": 15, "ratio": 20.0, "force_exponent": 30.5, **LOAD}
"""A force whose peak is calculated in a process of its own, and is there at once."""


def stops_without_loss(service, whole_group):
    """Stopping loses no request in flight and leaves no process."""
    with nothing_is_calculated(service, service.workers) as go_on:
        answers = []
        client = service.client()

        def ask():
            answers.append(client.post("/api/v1/contact-force", json=LONG))

        asking = [threading.Thread(target=ask) for _ in range(4)]
        for each in asking:
            each.start()
        while "khv_requests_in_flight 5.0" not in client.get("/metrics").text:
            assert not answers
        started = family(service.process.pid)
        for pid in started if whole_group else [service.process.pid]:
            os.kill(pid, signal.SIGTERM)
        go_on()
        for each in asking:
            each.join()
        client.close()
        service.process.wait(30)
        lost = [line for line in service.log() if line.get("status", 200) != 200]
        assert [each.status_code for each in answers] == [200] * 4, lost
        family_of_it = socket.AF_UNIX if service.uds else socket.AF_INET
        with socket.socket(family_of_it) as late, pytest.raises(OSError):
            late.connect(service.uds or ("127.0.0.1", service.port))
        assert eventually(lambda: not any(map(lives, started)))


def test_a_worker_alone_stops_without_loss_at_a_socket_that_was_left_behind(serve, left_socket):
    with serve(unix_socket=left_socket, processes=1, max_seconds=60) as service:
        stops_without_loss(service, whole_group=True)


def test_a_stopping_service_waits_only_so_long(serve):
    endless = {"calculation": "contact_force", "requests": [LONG]}
    with (
        serve(processes=1, max_seconds=60, stop_seconds=1) as service,
        nothing_is_calculated(service, 1),
    ):
        broken = []

        def ask():
            try:
                broken.append(
                    httpx.post(f"{service.url}/api/v1/batch", json=endless, timeout=60).status_code
                )
            except httpx.TransportError as error:
                broken.append(error)

        asking = threading.Thread(target=ask)
        asking.start()
        while "khv_requests_in_flight 2.0" not in httpx.get(f"{service.url}/metrics").text:
            assert not broken
        service.process.send_signal(signal.SIGTERM)
        service.process.wait(60)
        asking.join(60)
        assert len(broken) == 1
        assert broken[0] == 503 or isinstance(broken[0], httpx.TransportError)


def test_no_process_outlives_a_worker_that_is_killed(serve):
    """Not even one that has something to do."""
    with serve(processes=1) as service, nothing_is_calculated(service, 1) as go_on:
        started = family(service.process.pid)
        asking = threading.Thread(target=ask_for_long, args=(service.url,))
        asking.start()
        while "khv_requests_in_flight 2.0" not in httpx.get(f"{service.url}/metrics").text:
            assert asking.is_alive()
        service.process.kill()
        asking.join()
        go_on()
        assert len(started) >= 3
        assert eventually(lambda: not any(map(lives, started)))


def ask_for_long(url):
    with suppress(httpx.TransportError):
        httpx.post(f"{url}/api/v1/contact-force", json=LONG, timeout=30)


def test_a_killed_worker_is_replaced_and_two_stop_without_loss(serve):
    with serve(workers=2, processes=1, max_seconds=60) as service:
        started = family(service.process.pid)[1:]
        worker = next(pid for pid in started if len(family(pid)) > 1)
        for pid in family(worker):
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        service.wait_until_ready(starts=3)
        assert httpx.get(f"{service.url}/api/v1/health").status_code == 200
        stops_without_loss(service, whole_group=False)


def test_each_request_is_one_line_without_its_body(service):
    with httpx.Client(base_url=service.url, timeout=60) as client:
        client.get("/livez", headers={"x-request-id": "first"})
        assert eventually(lambda: any(line.get("id") == "first" for line in service.log()))
        before = len(service.log())  # with all that was asked before
        client.post("/api/v1/contact-force", json=LONG, headers={"x-request-id": "abc-1"})
        client.get("/static/main.js")
        client.get("/api/v1/health", headers={"x-request-id": "bad id"})
        client.get("/secret-path/zebra")
        client.get("/problems/zebra")

    def asked():
        lines = [line for line in service.log()[before:] if "route" in line]
        return sorted(lines, key=lambda line: (line["method"], line["route"]))

    assert eventually(lambda: len(asked()) >= 5)
    assert [(line["method"], line["route"], line["status"]) for line in asked()] == [
        ("GET", "/api/v1/health", 200),
        ("GET", "/problems", 404),
        ("GET", "/static", 200),
        ("GET", "unknown", 404),
        ("POST", "/api/v1/contact-force", 200),
    ]
    health, *_, first = asked()
    assert first["id"] == "abc-1"
    parts = first["read_ms"] + first["calculation_ms"] + first["encode_ms"]
    assert 0 < parts <= first["total_ms"]
    assert health["id"] != "bad id" and len(health["id"]) == 24
    assert "zebra" not in "".join(service.lines[before:])
    assert "force_exponent" not in "".join(service.lines[before:])


def test_metrics_of_all_workers_are_added_up(two_workers):
    def metrics():
        with two_workers.client() as client:
            return client.get("/metrics").text

    for _ in range(20):
        with two_workers.client() as client:
            client.post("/api/v1/cyclogram", json={"pins": 3, "ratio": 20})
    labels = 'method="POST",route="/api/v1/cyclogram",status="200"'
    for counted in (
        f"khv_requests_total{{{labels}}} 20.0",
        'khv_calculation_seconds_count{route="/api/v1/cyclogram"} 20.0',
        'khv_request_seconds_bucket{le="+Inf",route="/api/v1/cyclogram"} 20.0',
        "khv_requests_in_flight 1.0",
    ):  # which happens after the answer
        assert eventually(lambda: counted in metrics())  # noqa: B023
