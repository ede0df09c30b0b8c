"""Long calculations: they hold nobody up, end in time, and end when their client has gone."""

import asyncio
import gzip
import json
import os
import random
import signal
import time
from contextlib import suppress
from copy import deepcopy
from functools import partial

import httpx
import pytest
from pydantic import TypeAdapter

from app import endpoint, jobs
from app.calculations.contact_force import ContactForceRequest
from app.calculations.gear import ROLLER_POINTS
from app.calculations.mechanism import PAIR_POINTS, STEEP
from app.endpoint import LIGHT_BYTES, LIGHT_COST, read_body
from app.examples import REQUESTS
from app.main import create_app
from app.problems import Problem
from app.registry import CALCULATIONS
from app.settings import Settings
from core.errors import ImpossibleMechanism
from tests.inputs.loop_requests import largest_in_the_loop
from tests.oracles.seeds import seeds
from tests.oracles.work import steps
from tests.running_service import lives

pytestmark = pytest.mark.anyio

LOAD = {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0}
angles = random.Random(6)
SLOW = {
    "pins": 100,
    "satellites": 100,
    "ratio": 20.0,
    "crank_angles_deg": [angles.uniform(0, 360) for _ in range(100)],
    "force_exponent": 30.5,
    "include": ["curves"],
    "samples": 100,
    **LOAD,
}
"""A force that takes seconds: 10,000 pairs, none like another."""

MANY = {"pins": 270, "satellites": 10, "ratio": 20.0, "crank_spacing_deg": 7.0}
"""A cyclogram long enough for a process, and quick enough for a test."""


def client(app):
    return httpx.AsyncClient(
        transport=httpx.ASGITransport(app=app), base_url="http://service/api/v1/"
    )


def service(**limits):
    return client(create_app(Settings(**{"max_seconds": 300.0} | limits)))  # a busy machine


def processes_of(app):
    """Process ids of what calculates for a service."""
    return {child.pid for child in app.state.jobs._children}


async def until(holds):
    """Wait for what has to come."""
    while not holds():
        await asyncio.sleep(0.02)


async def test_health_is_answered_while_a_long_calculation_runs(held):
    async with service() as api:
        slow = asyncio.create_task(api.post("cyclogram", json=MANY))
        await until(lambda: held.came() == 1)
        for _ in range(10):
            assert (await api.get("health")).status_code == 200
            assert not slow.done()
        held.let()
        assert (await slow).status_code == 200


async def test_what_takes_too_long_is_stopped_and_refused(held, clock):
    app = create_app(Settings(max_seconds=0.9, processes=1))
    async with client(app) as api:
        asked = asyncio.create_task(api.post("cyclogram", json=MANY))
        await until(lambda: held.came() == 1)
        (killed,) = processes_of(app)
        clock.run_out()
        response = await asked
        assert response.status_code == 503
        assert response.headers["content-type"] == "application/problem+json"
        problem = response.json()
        assert problem["type"] == "/problems/too-long"
        assert "retry-after" not in response.headers  # it would take as long again
        assert "0.9 s" in problem["detail"]
        await until(lambda: not lives(killed))
        held.let()
        assert (await api.post("cyclogram", json=MANY)).status_code == 200
        assert len(processes_of(app)) == 1


async def test_where_too_many_wait_all_that_is_long_is_refused_at_once(held):
    batch = {"calculation": "contact_force", "requests": [{"pins": 3, "ratio": 20.0, **LOAD}]}
    app = create_app(Settings(max_seconds=300.0, processes=1, max_waiting=4))

    def queued():
        return sum(map(len, app.state.jobs._waiting.values()))

    async with client(app) as api:
        waiting = [asyncio.create_task(api.post("cyclogram", json=MANY))]
        await until(lambda: held.came() == 1)
        waiting += [asyncio.create_task(api.post("cyclogram", json=MANY)) for _ in range(2)]
        await until(lambda: queued() == 2)
        for path, body in (("cyclogram", MANY), ("batch", batch)):
            refused = await api.post(path, json=body)
            assert refused.status_code == 503
            assert "waiting" in refused.json()["detail"]
            assert 1 <= int(refused.headers["retry-after"]) <= 60
        assert (await api.post("cyclogram", json={"pins": 3, "ratio": 20})).status_code == 200
        assert not any(each.done() for each in waiting)
        held.let()
        assert [each.status_code for each in await asyncio.gather(*waiting)] == [200] * 3
        assert (await api.post("batch", json=batch)).status_code == 200


@pytest.mark.parametrize(
    ("path", "body"),
    [
        ("cyclogram", MANY),
        ("batch", {"calculation": "cyclogram", "requests": [MANY] * 5}),
    ],
)
async def test_a_calculation_stops_when_its_client_has_gone(held, path, body):
    """Told by the ASGI message alone: the process is killed, as it would wait for ever."""
    app = create_app(Settings(max_seconds=60, processes=1))
    content = json.dumps(body).encode()
    messages = iter([{"type": "http.request", "body": content, "more_body": False}])
    sent, busy = [], []

    async def receive():
        for message in messages:
            return message
        await until(lambda: held.came() == 1)
        busy.extend(processes_of(app))
        return {"type": "http.disconnect"}

    async def send(message):
        sent.append(message)

    scope = {
        "type": "http",
        "method": "POST",
        "path": f"/api/v1/{path}",
        "raw_path": f"/api/v1/{path}".encode(),
        "query_string": b"",
        "headers": [(b"content-type", b"application/json")],
    }
    await app(scope, receive, send)
    assert not sent
    assert len(busy) >= 1
    await until(lambda: not any(map(lives, busy)))


async def test_a_process_that_dies_is_no_server_error(held):
    app = create_app(Settings(processes=1))

    def kill():
        (pid,) = processes_of(app)
        os.kill(pid, signal.SIGKILL)
        return pid

    async with client(app) as api:
        slow = asyncio.create_task(api.post("cyclogram", json=MANY))
        for begun in (1, 2):  # the first to die is replaced, so the second has to die too
            await until(lambda: held.came() == begun)  # noqa: B023
            kill()
        assert (await slow).status_code == 503
        held.let()
        # one that has nothing to do is missed when it is given something
        assert (await api.post("cyclogram", json=MANY)).status_code == 200
        dead = kill()
        await until(lambda: not lives(dead))
        assert (await api.post("cyclogram", json=MANY)).status_code == 200


@pytest.mark.parametrize(
    ("path", "body"),
    [
        ("cyclogram", MANY),
        ("cyclogram/chart?theme=dark", MANY | {"pins": 20}),
        ("contact-force", MANY | LOAD | {"include": ["curves"], "force_exponent": 1.5}),
        ("contact-force", MANY | LOAD | {"include": ["curves"], "samples": 9999}),
        ("contact-force", MANY | LOAD | {"force_exponent": 0.5, "pins": 1, "satellites": 1}),
    ],
)
async def test_a_process_gives_the_same_answer_as_the_event_loop(monkeypatch, path, body):
    async with service() as api:
        monkeypatch.setattr(endpoint, "LIGHT_COST", float("inf"))
        inline = await api.post(path, json=body)
        monkeypatch.setattr(endpoint, "LIGHT_COST", -1.0)
        apart = await api.post(path, json=body)
    assert apart.status_code == inline.status_code
    assert apart.headers["content-type"] == inline.headers["content-type"]
    first, second = inline.json(), apart.json()
    for answer in (first, second):
        answer.get("accuracy", {}).pop("run_time_us", None)
    assert first == second
    if inline.status_code == 200 and "chart" not in path:
        assert "calculation;dur=" in apart.headers["server-timing"]


@pytest.mark.parametrize("exponent", [0.0, 1.0, 1.5])
@pytest.mark.parametrize("include", [[], ["curves"]])
def test_usual_designs_run_at_once(exponent, include):
    request = ContactForceRequest(
        pins=6, satellites=3, ratio=20.0, force_exponent=exponent, include=include, **LOAD
    )
    assert request.cost() <= LIGHT_COST


def test_long_calculations_are_known_beforehand():
    assert ContactForceRequest(**SLOW).cost() > 100 * LIGHT_COST
    study = TypeAdapter(CALCULATIONS["work-precision"].request)
    asked = study.validate_python(REQUESTS["work-precision"])
    assert asked.cost() == float("inf")


MOST_STEPS = 3_000_000
"""Calls, and numbers in arrays, of what is calculated in the event loop: some 30 ms."""


def largest(name, satellites, exponent):
    """An example with as many pins or rollers as the event loop takes, and at an exponent."""
    body = deepcopy(REQUESTS[name])
    for other in ("pin", "deviations", "tolerances"):
        body.pop(other, None)
    mechanism, load = body.get("mechanism", body), body.get("load", body)
    if "pins" in mechanism:
        mechanism.pop("crank_spacing_deg", None)
        mechanism["satellites"] = satellites
        mechanism["crank_angles_deg"] = [97.3 * each for each in range(satellites)]
        sharp = STEEP if 0 < exponent < 1 else max(1.0, exponent)
        sharp = sharp if "output_torque_Nm" in load else 1.0
        most = LIGHT_COST / (PAIR_POINTS * satellites**2 * sharp)
        mechanism["pins"] = max(1, int(most))
        if "output_torque_Nm" in load:
            load["force_exponent"] = exponent
    if "wheel" in body:
        body["wheel"]["rollers_total"] = int(LIGHT_COST / ROLLER_POINTS)
    return body


@pytest.mark.parametrize("exponent", [0.0, 0.3, 0.9, 1.0, 1.5, 4.3, 30.5, 500.0])
@pytest.mark.parametrize("name", CALCULATIONS)
def test_what_stays_in_the_event_loop_is_little_work_whatever_the_exponent_is(name, exponent):
    calculation, admitted = CALCULATIONS[name], 0
    for satellites in (1, 3, 9):
        content = json.dumps(largest(name, satellites, exponent)).encode()
        try:
            if read_body(calculation, content, Settings()).cost() > LIGHT_COST:
                continue
        except Problem:
            assert name in ("pin-strength", "crankshaft", "tolerance-study")  # never there
            continue
        admitted += 1
        for theme in (None, "light") if calculation.figure else (None,):

            def answer(content=content, theme=theme):
                with suppress(Problem, ImpossibleMechanism):
                    body = read_body(calculation, content, Settings())
                    gzip.compress(endpoint.content_of(calculation, body, theme), 3)

            assert steps(answer) < MOST_STEPS
    by_exponent = {"contact-force", "crank-planetary", "output-efficiency", "satellite-bearing"}
    if name in by_exponent:
        assert admitted == (3 if exponent in (0, 1) else 2 if exponent < 10 else exponent < 100)


@pytest.fixture(scope="module")
def thirty_ms():
    """Work that takes a quiet machine 30 ms: packing a megabyte of digits."""
    digits = random.Random(1)
    return partial(gzip.compress, ",".join(str(digits.random()) for _ in range(50_000)).encode(), 3)


@pytest.mark.parametrize("name", CALCULATIONS)
def test_the_largest_answer_of_the_event_loop_holds_it_for_less_than_30_ms(name, thirty_ms):
    """Read, calculated, written and packed, in processor time: variants by a seed."""
    calculation, held = CALCULATIONS[name], 0.0
    for seed in seeds(8, 20):
        asked = largest_in_the_loop(calculation, random.Random(seed))
        if asked is None:
            continue
        sent = json.dumps(asked).encode()
        for theme in (None, "light") if calculation.figure else (None,):

            def answer(sent=sent, theme=theme):
                with suppress(Problem, ImpossibleMechanism):
                    body = read_body(calculation, sent, Settings())
                    body.cost()
                    gzip.compress(endpoint.content_of(calculation, body, theme), 3)

            if (once := spent_s(answer)) > held:
                held = max(held, min(once, spent_s(answer)))
    assert held < min(spent_s(thirty_ms) for _ in range(3))


def spent_s(work):
    """Seconds that this thread calculates for it."""
    before = time.thread_time()
    work()
    return time.thread_time() - before


@pytest.mark.parametrize("name", ["pin-strength", "crankshaft"])
def test_what_is_searched_over_the_turn_leaves_the_event_loop(name):
    read = TypeAdapter(CALCULATIONS[name].request).validate_python(REQUESTS[name])
    assert read.cost() > LIGHT_COST


def test_less_than_one_turn_is_no_less_work():
    request = TypeAdapter(CALCULATIONS["cyclogram"].request)
    many = {"pins": 16, "satellites": 100, "ratio": 20.0}
    assert request.validate_python(many | {"revolutions": 1e-8}).cost() > LIGHT_COST


async def test_a_large_body_is_read_in_a_process(monkeypatch):
    """With the same refusals as a small one."""

    def unused(*_):
        raise AssertionError("read in the event loop")

    monkeypatch.setattr(endpoint, "read_body", unused)
    async with service() as api:
        for body in ({"pins": 3, "ratio": 20}, {"pins": 3}, {"pins": 3, "ratio": 20, "a": 1}):
            sent = json.dumps(body) + " " * LIGHT_BYTES
            answer = await api.post("cyclogram", content=sent, headers=JSON_HEADERS)
            assert answer.status_code == (200 if len(body) == 2 and "ratio" in body else 422)


JSON_HEADERS = {"content-type": "application/json"}


async def test_the_operator_limits_pairs_and_samples():
    async with service(max_pairs=12, max_curve_samples=100) as api:
        job = {"pins": 7, "satellites": 2, "ratio": 20.0}
        for path, body, pointer in (
            ("cyclogram", job, "/pins"),
            ("crank-planetary", {"mechanism": job, "include": ["cyclogram"]}, "/mechanism/pins"),
            ("contact-force", job | LOAD | {"pins": 6, "samples": 101}, "/samples"),
        ):
            response = await api.post(path, json=body)
            assert response.status_code == 422
            assert [each["pointer"] for each in response.json()["errors"]] == [pointer]
        assert (await api.post("cyclogram", json=job | {"pins": 6})).status_code == 200


async def test_the_service_is_ready_as_long_as_jobs_can_run(monkeypatch):
    def fails(server):
        raise OSError("no more processes")

    app = create_app(Settings(processes=1))
    async with client(app) as api:

        async def ready():
            return (await api.get("http://service/readyz")).status_code == 200

        assert not await ready()
        async with app.router.lifespan_context(app):
            while not await ready():
                await asyncio.sleep(0.02)
            with monkeypatch.context() as patched:
                patched.setattr(jobs._Server, "fork", fails)
                for pid in processes_of(app):
                    os.kill(pid, signal.SIGKILL)
                while await ready():
                    await asyncio.sleep(0.02)
                assert (await api.post("cyclogram", json=MANY)).status_code == 503
                assert (await api.get("http://service/livez")).status_code == 200
            while not await ready():
                await asyncio.sleep(0.02)
            assert (await api.post("cyclogram", json=MANY)).status_code == 200
        assert not await ready()
