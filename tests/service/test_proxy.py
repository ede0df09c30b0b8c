"""The service behind nginx as deploy/ sets it up: prefix, TLS, limits, addresses of clients."""

import re
import shutil
import socket
import ssl
from contextlib import ExitStack
from pathlib import Path
from subprocess import DEVNULL

import httpx
import pytest

from app.model import StudyCalculation
from app.registry import CALCULATIONS
from tests.inputs.children import ran, started
from tests.running_service import eventually

DEPLOY = Path(__file__).parent.parent.parent / "deploy"


def free_port():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


@pytest.fixture(scope="module")
def proxied(serve, tmp_path_factory):
    """A running service, and a client that asks through nginx."""
    if not shutil.which("nginx"):
        pytest.skip("needs nginx")
    place, port = tmp_path_factory.mktemp("nginx"), free_port()
    request = "openssl req -x509 -nodes -newkey rsa:2048 -days 2 -subj /CN=reducers.example"
    written = ["-keyout", place / "key.pem", "-out", place / "certificate.pem"]
    ran(*request.split(), *written)
    with serve(root_path="/reducers") as service:
        text = (DEPLOY / "nginx.conf").read_text()
        for found, put in (
            ("/etc/nginx/tls", str(place)),
            ("listen 443", f"listen 127.0.0.1:{port}"),
            ("listen 80", f"listen 127.0.0.1:{free_port()}"),
            ("server khv:8000", f"server 127.0.0.1:{service.port}"),
        ):
            assert found in text
            text = text.replace(found, put)
        (place / "nginx.conf").write_text(text)
        here = f"daemon off; pid {place}/pid; error_log {place}/error;"
        url = f"https://127.0.0.1:{port}/reducers/"
        with (
            started("nginx", "-p", place, "-c", "nginx.conf", "-g", here, stderr=DEVNULL),
            httpx.Client(base_url=url, verify=False, timeout=30) as client,
        ):
            assert eventually(lambda: accepts(port))
            yield service, client


def accepts(port):
    with socket.socket() as connection:
        return connection.connect_ex(("127.0.0.1", port)) == 0


def test_page_and_api_below_the_prefix(proxied):
    _, client = proxied
    page = client.get("")
    assert page.status_code == 200 and "strict-transport-security" in page.headers
    assert page.headers["server"].startswith("khv-calc/")
    for path in re.findall(r'(?:href|src)="([^"#]+)"', page.text)[:20]:
        assert client.get(path).status_code == 200
    assert client.post("api/v1/cyclogram", json={"pins": 3, "ratio": 20}).status_code == 200
    refused = client.post("api/v1/cyclogram", json={}).json()
    assert client.get(client.base_url.join(refused["type"])).status_code == 200
    assert client.get("metrics").status_code == 404


def test_the_log_has_the_address_that_the_proxy_sees(proxied):
    service, client = proxied
    client.get("api/v1/materials", headers={"x-forwarded-for": "192.0.2.7"})

    def clients():
        return {line["client"] for line in service.log() if "materials" in line.get("route", "")}

    assert eventually(lambda: clients() == {"127.0.0.1"})


def test_bodies_beyond_the_limits_end_at_the_proxy(proxied):
    _, client = proxied
    for path, size, status in (
        ("api/v1/cyclogram", 300_000, 413),
        ("api/v1/batch", 300_000, 422),
        ("api/v1/batch", 1_100_000, 413),
    ):
        assert client.post(path, json={"a": "x" * size}).status_code == status


@pytest.mark.parametrize(
    ("head", "status"),
    [
        ("GET / HTTP/1.1\r\nhost: x\r\nx-long: " + "y" * 20_000, 400),
        ("GET /" + "y" * 20_000 + " HTTP/1.1\r\nhost: x", 414),
        ("POST /reducers/api/v1/hertz HTTP/1.1\r\nhost: x\r\ntransfer-encoding: gzip", 501),
        ("NOTHING", 400),
    ],
)
def test_what_is_no_request_ends_at_the_proxy(proxied, head, status):
    service, client = proxied
    before = len(service.lines)
    with connected(client.base_url) as connection:
        connection.sendall(f"{head}\r\n\r\n".encode())
        assert connection.recv(1000).startswith(b"HTTP/1.1 %d " % status)
    assert len(service.lines) == before


def test_requests_one_behind_the_other_reach_the_service_one_after_the_other(proxied):
    _, client = proxied
    ask = b"GET /reducers/livez HTTP/1.1\r\nhost: x\r\n\r\n"
    received = b""
    with connected(client.base_url) as connection:
        connection.sendall(ask * 50)
        while received.count(b"\r\n\r\nalive") < 50:
            received += connection.recv(65536)
    assert received.count(b"HTTP/1.1 200 ") == 50


def test_a_batch_comes_through_line_by_line(proxied):
    _, client = proxied
    hertz = {"force_N": 9, "contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}
    asked = {"calculation": "hertz", "requests": [hertz] * 500}
    with client.stream(
        "POST", "api/v1/batch", json=asked, headers={"accept": "application/x-ndjson"}
    ) as answer:
        assert sum(1 for _ in answer.iter_lines()) == 500


def test_all_that_is_long_is_limited_as_such():
    (named,) = re.findall(r"/api/v1/\(([^)]*)\)", (DEPLOY / "nginx.conf").read_text())
    told = {name for name, each in CALCULATIONS.items() if isinstance(each, StudyCalculation)}
    assert {*named.split("|")} == told | {"batch", "solve", "work-precision"}


@pytest.mark.parametrize("path", ["api/v1/batch", "api/v1/tolerance-study"])
def test_a_client_that_asks_for_too_much_is_told_so(proxied, path):
    """Eight that send their requests by and by, and one more, however fast they come."""
    _, client = proxied
    assert eventually(lambda: client.post(path, json={}).status_code == 422)
    with ExitStack() as asking:
        for _ in range(8):
            asking.enter_context(sending(client.base_url))
        assert eventually(lambda: client.post(path, json={}).status_code == 429)
    assert eventually(lambda: client.post(path, json={}).status_code == 422)


def connected(url):
    """A connection to the proxy."""
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    return context.wrap_socket(socket.create_connection((url.host, url.port), timeout=30))


def sending(url):
    """A connection over which a part of a batch has been sent."""
    connection = connected(url)
    connection.sendall(
        b"POST /reducers/api/v1/batch HTTP/1.1\r\nhost: x\r\ncontent-length: 100\r\n\r\n"
    )
    return connection
