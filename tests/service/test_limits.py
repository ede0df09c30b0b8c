"""Clients that send too slowly, too much, too many, or that do not take their answer."""

import socket
import time
from contextlib import ExitStack

import httpx

from tests.running_service import eventually

CYCLOGRAM = b'{"pins": 3, "ratio": 20}'
POST = (
    b"POST /api/v1/cyclogram HTTP/1.1\r\nhost: x\r\ncontent-type: application/json\r\n"
    b"content-length: %d\r\n\r\n"
)


def connect(service):
    return socket.create_connection(("127.0.0.1", service.port), timeout=10)


def rest(connection):
    """All that comes until the service closes the connection."""
    received = b""
    while part := connection.recv(65536):
        received += part
    return received


def closes_as_too_slow(connection, start, sent):
    received = rest(connection)
    assert time.perf_counter() - start > 1
    assert received.startswith(b"HTTP/1.1 408 ") is sent
    if sent:
        assert b"content-type: application/problem+json" in received
        assert b"connection: close" in received
    else:
        assert received == b""


def test_headers_that_do_not_come_to_an_end(service):
    start = time.perf_counter()
    with connect(service) as silent, connect(service) as half:
        half.sendall(b"GET / HTTP/1.1\r\nhost: x\r\n")
        assert httpx.get(f"{service.url}/api/v1/health").status_code == 200
        closes_as_too_slow(silent, start, sent=True)
        closes_as_too_slow(half, start, sent=True)


def test_headers_that_trickle_gain_no_time(service):
    start = time.perf_counter()
    with connect(service) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nhost: x\r\n")
        connection.settimeout(0.2)
        received = b""
        while not received and time.perf_counter() - start < 20:
            connection.sendall(b"x-more: y\r\n")
            try:
                received = connection.recv(1000)
            except TimeoutError:
                continue
    assert received.startswith(b"HTTP/1.1 408 ")


def test_a_body_that_does_not_come_to_an_end(service):
    start = time.perf_counter()
    with connect(service) as connection:
        connection.sendall(POST % 1000 + b'{"pins": ')
        closes_as_too_slow(connection, start, sent=True)


def test_a_second_request_has_its_own_time_and_the_first_its_answer(service):
    with connect(service) as connection:
        connection.sendall(POST % len(CYCLOGRAM) + CYCLOGRAM)
        time.sleep(1)
        start = time.perf_counter()
        connection.sendall(POST % 1000)
        received = rest(connection)
    assert time.perf_counter() - start > 1
    first, second = received.split(b"HTTP/1.1 ")[1:]
    assert first.startswith(b"200 ") and b"working_phase_deg" in first
    assert second.startswith(b"408 ")


def test_a_body_refused_for_its_size_gets_one_answer_only(service):
    with connect(service) as connection:
        connection.sendall(POST % 10**9 + b"[")
        received = rest(connection)
    assert received.startswith(b"HTTP/1.1 413 ")
    assert received.count(b"HTTP/1.1 ") == 1


def test_headers_without_end_are_refused_by_their_size(service):
    with connect(service) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nhost: x\r\nx-long: " + b"y" * 66_000)
        assert connection.recv(1000).startswith(b"HTTP/1.1 431 ")


def test_a_client_that_goes_before_its_body_is_whole_is_no_failure(service):
    with connect(service) as connection:
        head = (POST % 1000).replace(b"host: x", b"host: x\r\nx-request-id: gone")
        connection.sendall(head + b'{"pins": ')

    def logged():
        return [line for line in service.log() if line.get("id") == "gone"]

    assert eventually(logged)
    assert [(line["status"], line["level"]) for line in logged()] == [(499, "info")]


def test_an_answer_that_nobody_takes_is_dropped(service):
    """Pipelined requests for a large file, and a client that reads nothing."""
    ask = b"GET /static/vendor/plotly/plotly-basic.min.js HTTP/1.1\r\nhost: x\r\n%b\r\n"
    with socket.socket() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(10)
        connection.connect(("127.0.0.1", service.port))
        connection.sendall(ask % b"x-request-id: untaken\r\n" + ask % b"" * 19)
        # The first ones fit into the buffers; of the others none is under way any more.
        assert eventually(lambda: any(line.get("id") == "untaken" for line in service.log()))
        metrics = f"{service.url}/metrics"
        assert eventually(lambda: "khv_requests_in_flight 1.0" in httpx.get(metrics).text)
        received = 0
        try:
            while part := connection.recv(1 << 20):
                received += len(part)
        except ConnectionResetError:
            pass
    assert received < 12_000_000  # half of it


def test_too_many_connections_are_told_when_to_come_again(service):
    answers = []

    def full():
        """Idle connections are closed after a while, which a slow test may come too late for."""
        with ExitStack() as idle:
            for _ in range(41):
                idle.enter_context(connect(service))
            paths = ("readyz", "api/v1/health", "livez")
            answers[:] = (httpx.get(f"{service.url}/{path}") for path in paths)
        return [each.status_code for each in answers] == [503, 503, 200]

    assert eventually(full)
    refused = answers[1]
    assert refused.headers["content-type"] == "application/problem+json"
    assert int(refused.headers["retry-after"]) > 0
    assert refused.headers["connection"] == "close"
    assert eventually(lambda: httpx.get(f"{service.url}/readyz").status_code == 200)
    assert httpx.get(f"{service.url}/api/v1/health").status_code == 200
