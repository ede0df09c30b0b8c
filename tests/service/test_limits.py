"""Clients that send too slowly, too much, too many, two at a time, or do not take their answer."""

import json
import socket
import time
from contextlib import ExitStack

import httpx

from app.examples import REQUESTS
from tests.running_service import eventually, nothing_is_calculated

CYCLOGRAM = b'{"pins": 3, "ratio": 20}'
POST = (
    b"POST /api/v1/cyclogram HTTP/1.1\r\nhost: x\r\ncontent-type: application/json\r\n"
    b"content-length: %d\r\n\r\n"
)
LONG = json.dumps({"pins": 270, "satellites": 10, "ratio": 20.0, "crank_spacing_deg": 7.0}).encode()
"""A cyclogram that is calculated in a process."""

CURVES = REQUESTS["contact-force"] | {"pins": 50, "include": ["curves"], "samples": 10_000}
"""A small request for some 10 MB."""


def connect(service):
    return socket.create_connection(("127.0.0.1", service.port), timeout=10)


def rest(connection):
    """All that comes until the service closes the connection."""
    received = b""
    while part := connection.recv(65536):
        received += part
    return received


def lines_of(service, request_id):
    return [line for line in service.log() if line.get("id") == request_id]


def test_a_connection_that_brings_nothing_is_closed_without_a_word(service):
    with connect(service) as silent:
        assert rest(silent) == b""


def test_a_body_that_does_not_come_to_an_end(service):
    """However it trickles: it has one time for all of it."""
    start = time.perf_counter()
    with connect(service) as connection:
        connection.sendall(POST % 1000)
        connection.settimeout(0.2)
        received = b""
        while not received and time.perf_counter() - start < 20:
            connection.sendall(b" ")
            try:
                received = connection.recv(1000)
            except TimeoutError:
                continue
    assert time.perf_counter() - start > 1
    assert received.startswith(b"HTTP/1.1 408 ")
    assert b"content-type: application/problem+json" in received
    assert b"connection: close" in received


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


def test_a_second_request_in_the_pipe_is_not_read_and_ends_the_connection(service):
    """The first request is answered, or not yet; any number may follow."""
    errors = service.said('"level":"error"')
    ask = b"GET /livez HTTP/1.1\r\nhost: x\r\nx-request-id: %b\r\n\r\n"
    with connect(service) as connection:
        connection.sendall(ask % b"piped" + ask % b"unread" * 3000)
        received = rest(connection)
    assert received.count(b"HTTP/1.1 200 ") == 1 and received.endswith(b"alive")
    with connect(service) as connection:
        connection.sendall(POST % len(CYCLOGRAM) + CYCLOGRAM + POST % len(CYCLOGRAM))
        assert rest(connection).count(b"HTTP/1.1 ") == 1
    assert eventually(lambda: lines_of(service, "piped"))
    assert not lines_of(service, "unread") and service.said('"level":"error"') == errors


def test_a_client_with_a_second_request_in_the_pipe_can_go(narrow):
    """The request that the client gave up ends, and the next one's turn comes."""
    with nothing_is_calculated(narrow, 1) as go_on:
        with connect(narrow) as connection:
            head = (POST % len(LONG)).replace(b"host: x", b"host: x\r\nx-request-id: gone")
            connection.sendall(head + LONG + POST % len(LONG) + LONG)
            metrics = f"{narrow.url}/metrics"
            assert eventually(lambda: "khv_requests_in_flight 2.0" in httpx.get(metrics).text)
        assert eventually(lambda: lines_of(narrow, "gone"))
        (line,) = lines_of(narrow, "gone")
        assert (line["status"], line["level"]) == (499, "info")
        go_on()
    answer = httpx.post(f"{narrow.url}/api/v1/cyclogram", content=LONG, headers=JSON, timeout=60)
    assert answer.status_code == 200
    assert not [line for line in narrow.log() if line["level"] == "error"]


JSON = {"content-type": "application/json"}


def test_a_body_refused_for_its_size_gets_one_answer_only(service):
    with connect(service) as connection:
        connection.sendall(POST % 10**9 + b"[")
        received = rest(connection)
    assert received.startswith(b"HTTP/1.1 413 ")
    assert received.count(b"HTTP/1.1 ") == 1


def test_heads_are_refused_by_their_size(service):
    """Without an end, in one packet, and in the address."""
    for sent in (
        b"GET / HTTP/1.1\r\nhost: x\r\nx-long: " + b"y" * 66_000,
        b"GET / HTTP/1.1\r\nhost: x\r\nx-long: " + b"y" * 70_000 + b"\r\n\r\n",
        b"GET /" + b"y" * 70_000 + b" HTTP/1.1\r\nhost: x\r\n\r\n",
    ):
        with connect(service) as connection:
            connection.sendall(sent)
            received = rest(connection)
        assert received.startswith(b"HTTP/1.1 400 ") and received.count(b"HTTP/1.1 ") == 1


def test_a_client_that_goes_before_its_body_is_whole_is_no_failure(service):
    with connect(service) as connection:
        head = (POST % 1000).replace(b"host: x", b"host: x\r\nx-request-id: gone")
        connection.sendall(head + b'{"pins": ')

    assert eventually(lambda: lines_of(service, "gone"))
    assert [(line["status"], line["level"]) for line in lines_of(service, "gone")] == [
        (499, "info")
    ]


def test_an_answer_that_nobody_takes_is_dropped(service):
    """A large answer, and a client that reads nothing."""
    content = json.dumps(CURVES).encode()
    head = (POST % len(content)).replace(b"cyclogram", b"contact-force")
    with socket.socket() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(10)
        connection.connect(("127.0.0.1", service.port))
        connection.sendall(head.replace(b"host: x", b"host: x\r\nx-request-id: untaken") + content)
        # What fits into the buffers is sent; of the rest nothing is under way any more.
        assert eventually(lambda: lines_of(service, "untaken"))
        received = 0
        try:
            while part := connection.recv(1 << 20):
                received += len(part)
        except ConnectionResetError:
            pass
    assert received < 6_000_000  # half of it


def test_what_is_large_has_few_places_and_what_is_small_needs_none(narrow):
    """A client holds one of two places while its body is not complete, and another finds the other
    one; a batch with a small body has none before it is complete. A client without a place is told
    to come again.
    """
    large = POST % 20_000 + b" " * 17_000
    batch = (POST % 1000).replace(b"cyclogram", b"batch") + b"{"

    def sent(place, content, client):
        opened = place.enter_context(
            socket.create_connection(
                ("127.0.0.1", narrow.port), timeout=10, source_address=(client, 0)
            )
        )
        opened.sendall(content)

    def asked(path, content, client="127.0.0.1"):
        with httpx.Client(transport=httpx.HTTPTransport(local_address=client)) as http:
            return http.post(f"{narrow.url}/api/v1/{path}", content=content, headers=JSON)

    def full(client):
        return asked("batch", b"{}", client).status_code == 503

    with ExitStack() as held:
        sent(held, batch, "127.0.0.2")
        sent(held, large, "127.0.0.1")
        assert eventually(lambda: full("127.0.0.1"))
        assert int(asked("batch", b"{}").headers["retry-after"]) > 0
        assert asked("cyclogram", CYCLOGRAM + b" " * 17_000).status_code == 503
        small = json.dumps(CURVES).encode()
        assert asked("contact-force", small).status_code == 503  # for its answer
        assert asked("cyclogram", CYCLOGRAM).status_code == 200
        assert not full("127.0.0.2")
        sent(held, large, "127.0.0.2")
        assert eventually(lambda: full("127.0.0.3"))
        held.close()
        assert eventually(lambda: not full("127.0.0.1"))


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
