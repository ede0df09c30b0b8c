"""How the service starts and what it starts in: settings, sockets, limits, disks, logs."""

import os
import re
import socket
import sys
from contextlib import ExitStack

import httpx
import pytest

from tests.inputs.children import ran
from tests.running_service import eventually, family


@pytest.mark.parametrize(
    ("setting", "text", "said"),
    [
        ("KHV_MAX_BODY_BYTES", "-1", "greater than or equal to 1"),
        ("KHV_MAX_SECONDS", "nan", "finite"),
        ("KHV_MAX_BODY_BYTE", "5", "KHV_MAX_BODY_BYTES is"),
        ("KHV_WORKERS", "0", "greater than or equal to 1"),
        ("KHV_ROOT_PATH", "/reducers/..", "match pattern"),
        ("KHV_HOST", "192.0.2.1", "192.0.2.1"),  # of no machine (RFC 5737)
        ("KHV_HOST", "no host..", "no host.."),
        ("KHV_UNIX_SOCKET", "/proc/nowhere/socket", "/proc/nowhere/socket"),
        ("KHV_UNIX_SOCKET", "/tmp/" + "x" * 200, "too long"),
    ],
)
def test_what_cannot_be_set_ends_the_start_with_one_line(setting, text, said):
    environment = os.environ | {"PYTHONPATH": ".", setting: text}
    ended = ran(sys.executable, "-m", "app.serve", env=environment, check=False)
    assert ended.returncode == 1 and ended.stdout == ""
    (line,) = ended.stderr.splitlines()
    assert line.startswith(setting) and said in line


def test_a_port_that_is_taken_ends_the_start_with_one_line(service):
    environment = os.environ | {"PYTHONPATH": ".", "KHV_PORT": str(service.port)}
    ended = ran(sys.executable, "-m", "app.serve", env=environment, check=False)
    assert ended.returncode == 1 and ended.stdout == ""
    (line,) = ended.stderr.splitlines()
    assert line.startswith("KHV_HOST, KHV_PORT: ") and str(service.port) in line


def test_the_effective_settings_are_the_first_line(service):
    first = service.log()[0]
    assert first["message"] == "settings"
    assert (first["max_connections"], first["log_level"], first["port"]) == (40, "INFO", 0)


def test_a_unix_socket_and_the_addresses_that_its_proxy_names(two_workers):
    """One that was left behind is taken; where one worker listens, test_operation.py says."""
    with two_workers.client() as client:
        for prefix, names in (
            ("/reducers", {"x-forwarded-for": "192.0.2.7"}),
            ("", {"x-forwarded-for": "203.0.113.9, 192.0.2.7"}),  # the first the client wrote
            ("", {"x-forwarded-for": "y" * 50_000}),
            ("", {}),
        ):
            assert client.get(f"{prefix}/api/v1/health", headers=names).status_code == 200

    def clients():
        lines = [line for line in two_workers.log() if line.get("route") == "/api/v1/health"]
        return sorted(line["client"] for line in lines)

    assert eventually(lambda: len(clients()) == 4)
    assert clients() == [*["192.0.2.7"] * 2, "unix", "y" * 45]


@pytest.mark.parametrize("what", ["file", "link to a file", "directory", "live socket"])
def test_what_is_no_socket_and_what_answers_is_not_listened_at(tmp_path, what):
    path, file = tmp_path / "socket", tmp_path / "file"
    file.write_text("kept")
    with socket.socket(socket.AF_UNIX) as other:
        if what == "file":
            path = file
        elif what == "directory":
            path.mkdir()
        elif what == "live socket":
            other.bind(str(path))
            other.listen(1)
        else:
            path.symlink_to(file)
        environment = os.environ | {"PYTHONPATH": ".", "KHV_UNIX_SOCKET": str(path)}
        ended = ran(sys.executable, "-m", "app.serve", env=environment, check=False)
    assert ended.returncode == 1 and ended.stdout == ""
    (line,) = ended.stderr.splitlines()
    assert line.startswith("KHV_UNIX_SOCKET: ") and str(path) in line
    assert path.exists() and file.read_text() == "kept"


def test_only_a_trusted_proxy_names_the_client(served, service):
    names = {"x-forwarded-for": "192.0.2.7", "x-request-id": "proxied"}
    for running, client in ((served, "192.0.2.7"), (service, "127.0.0.1")):
        httpx.get(f"{running.url}/api/v1/health", headers=names)

        def clients(running=running):
            return [line["client"] for line in running.log() if line.get("id") == "proxied"]

        assert eventually(clients) and clients() == [client]


def test_connections_stay_within_the_limit_of_descriptors(narrow):
    """More idle connections than there are descriptors: the probes are answered."""
    assert "room for 56 connections" in narrow.log()[0]["message"]
    assert narrow.log()[1]["max_connections"] == 56
    with ExitStack() as idle:
        for _ in range(300):
            idle.enter_context(socket.create_connection(("127.0.0.1", narrow.port)))
        assert eventually(lambda: httpx.get(f"{narrow.url}/readyz").status_code == 503)
        assert httpx.get(f"{narrow.url}/livez").status_code == 200
    assert eventually(lambda: httpx.get(f"{narrow.url}/readyz").status_code == 200)


def test_too_few_descriptors_end_the_start_with_one_line():
    command = f'ulimit -n 64; exec "{sys.executable}" -m app.serve'
    ended = ran("sh", "-c", command, check=False)
    assert ended.returncode == 1 and ended.stdout == ""
    (line,) = ended.stderr.splitlines()
    assert "descriptors is 64" in line


def test_without_standard_files_no_line_of_the_log_goes_into_another():
    """Files that are opened first would take the numbers of the standard files."""
    code = "import os; from app.serve import open_standard_files; os.closerange(0, 3); "
    code += "open_standard_files(); print(*map(os.readlink, map('/proc/self/fd/{}'.format, "
    code += "range(3))), os.open('.', 0), file=open('/proc/%d/fd/%d' % (os.getpid(), FD), 'w'))"
    reading, writing = os.pipe()
    ran(sys.executable, "-c", code.replace("FD", str(writing)), pass_fds=(writing,))
    os.close(writing)
    with open(reading) as told:
        *standard, free = told.read().split()
    assert standard == ["/dev/null"] * 3 and int(free) > 2


@pytest.fixture
def tiny(tmp_path):
    """A file system of 48 kB."""
    mounted = ran("mount", "-t", "tmpfs", "-o", "size=48k", "tmpfs", tmp_path, check=False)
    if mounted.returncode:
        pytest.skip("file systems can only be mounted as root")
    yield tmp_path
    ran("umount", "--lazy", tmp_path)


@pytest.mark.parametrize("full", [False, True])
def test_a_full_tmp_kills_no_worker(serve, tiny, monkeypatch, full):
    if full:
        (tiny / "file").write_bytes(b"x" * 49_152)
    monkeypatch.setenv("TMPDIR", str(tiny))
    with serve(workers=2, processes=1) as service:
        started = family(service.process.pid)
        for path in ("/nothing", "/api/v1/hertz", "/metrics", "/api/v1/health"):
            for _ in range(4):
                assert httpx.get(service.url + path).status_code in (200, 404, 405)
        assert httpx.post(f"{service.url}/api/v1/hertz", json={}).status_code == 422
        assert set(family(service.process.pid)) >= set(started)  # one may have started since
    assert not [line for line in service.log() if line["level"] == "error"]


def test_a_log_that_nobody_reads_stops_nothing(narrow):
    before = len(narrow.lines)
    narrow.hold()
    with narrow.client() as client:
        for _ in range(1800):
            assert client.get("/livez").status_code == 200
        dropped = re.search(r"(?m)^khv_log_lines_dropped_total (\S+)", client.get("/metrics").text)
    assert float(dropped[1]) > 100
    narrow.go_on()
    assert eventually(lambda: len(narrow.lines) > before + 1000)


def test_what_is_no_http_is_refused(service):
    for sent in (b"NOTHING\r\n\r\n", b"GET / HTTP/1.1\r\ncontent-length: x\r\n\r\n"):
        with socket.create_connection(("127.0.0.1", service.port), timeout=10) as connection:
            connection.sendall(sent)
            received = b""
            while part := connection.recv(65536):
                received += part
        assert received.startswith(b"HTTP/1.1 400 ") and received.count(b"HTTP/1.1 ") == 1


@pytest.mark.parametrize(
    ("version", "codings", "status"),
    [
        ("1.1", ["gzip, chunked"], 400),
        ("1.1", ["gzip", "chunked"], 400),
        ("1.1", ["chunked, chunked"], 400),
        ("1.1", ["x-none"], 400),
        ("1.0", ["chunked"], 400),
        ("1.1", [" Chunked "], 200),
    ],
)
def test_a_body_in_another_coding_than_chunked_is_not_read(service, version, codings, status):
    """RFC 9112, 6.1: its end is not known, so that nothing behind it is read either."""
    body = b'{"pins": 3, "ratio": 20}'
    head = f"POST /api/v1/cyclogram HTTP/{version}\r\nhost: x\r\ncontent-type: application/json\r\n"
    head += "".join(f"transfer-encoding: {each}\r\n" for each in codings)
    with socket.create_connection(("127.0.0.1", service.port), timeout=10) as connection:
        connection.sendall(f"{head}\r\n{len(body):x}\r\n".encode() + body + b"\r\n0\r\n\r\n")
        received = b""
        while part := connection.recv(65536):
            received += part
    assert received.startswith(b"HTTP/1.1 %d " % status) and received.count(b"HTTP/1.1 ") == 1
