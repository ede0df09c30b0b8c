"""Batches: in order, each request with its own answer or problem, whole or line by line."""

import asyncio
import json
import os
import signal
from functools import partial

import httpx
import pytest

from app.batch import answers
from app.endpoint import LINES
from app.examples import REQUESTS
from app.jobs import Jobs
from app.main import PRELOAD, create_app
from app.middleware import PART_BYTES
from app.record import Record
from app.settings import Settings
from core.precision import CONVERGED, SAME
from tests.app import jobs_to_run

pytestmark = pytest.mark.anyio

PATHS = {
    "cyclogram": "cyclogram",
    "contact_force": "contact-force",
    "hertz": "hertz",
    "crank_planetary": "crank-planetary",
    "roller_strength": "roller-strength",
    "contact_line": "precession/contact-line",
    "meshing_load": "precession/meshing-load",
    "shaft_deflection": "precession/shaft-deflection",
}


def same(one, other, name=""):
    """True if answers agree but for the last digits and the accuracy."""
    if isinstance(one, dict):
        return set(one) == set(other) and all(
            each == "accuracy" or same(one[each], other[each], each) for each in one
        )
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, float):  # a smooth peak is known much better than its place
        place = 1e-8 if name == "peak_crank_angle_deg" else 1e-13
        return one == pytest.approx(other, rel=CONVERGED, abs=place)
    return one == other


@pytest.mark.parametrize("calculation", PATHS)
async def test_a_batch_gives_what_each_request_would_get_alone(api, calculation):
    request = REQUESTS[PATHS[calculation]]
    wrong = dict(request) | {"no_such_field": 1}
    asked = [request, wrong, {}, request]
    batch = await api.post("batch", json={"calculation": calculation, "requests": asked})
    assert batch.status_code == 200
    results = batch.json()["results"]
    assert len(results) == len(asked)
    for each, body in zip(results, asked, strict=True):
        alone = await api.post(PATHS[calculation], json=body)
        kind = "result" if alone.status_code == 200 else "problem"
        assert same(each, {kind: alone.json()})
        if kind == "result" and "accuracy" in alone.json():
            stated = each["result"]["accuracy"]
            assert set(stated) == set(alone.json()["accuracy"])
            assert 0 < stated["relative_error"] < 1e-9


async def test_a_mechanism_that_cannot_work_fails_alone(api):
    good = {"pins": 3, "satellites": 2, "ratio": 20, **LOAD}
    dead = {"pins": 2, "satellites": 1, "ratio": 20, **LOAD}
    body = {"calculation": "contact_force", "requests": [good, dead, good]}
    first, second, third = (await api.post("batch", json=body)).json()["results"]
    assert same(first, third)
    assert second["problem"]["type"] == "/problems/impossible-mechanism"
    assert "crank_angle_deg" in second["problem"]["where"]


LOAD = {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0}


async def test_answers_come_line_by_line_where_that_is_asked(api):
    requests = [REQUESTS["hertz"] | {"force_N": float(force)} for force in range(1, 401)]
    body = {"calculation": "hertz", "requests": requests}
    lines = []
    async with api.stream(
        "POST", "batch", json=body, headers={"accept": "application/x-ndjson"}
    ) as answer:
        assert answer.headers["content-type"] == "application/x-ndjson"
        async for line in answer.aiter_lines():
            lines.append(json.loads(line))
    assert [line["index"] for line in lines] == list(range(400))
    pressures = [line["result"]["max_pressure_MPa"] for line in lines]
    assert len(pressures) == 400
    # p0 grows with the root of the force
    assert pressures[-1] / pressures[0] == pytest.approx(20, rel=SAME)


async def test_names_of_requests_come_back_with_their_answers(api):
    ids = ['a "b"', "é" * 64, "", "a"]
    body = {"calculation": "hertz", "requests": [REQUESTS["hertz"], {}] * 2, "ids": ids}
    results = (await api.post("batch", json=body)).json()["results"]
    assert [[*each] for each in results] == [["id", "result"], ["id", "problem"]] * 2
    assert [each["id"] for each in results] == ids
    by_lines = await api.post("batch", json=body, headers={"accept": "application/x-ndjson"})
    for place, line in enumerate(map(json.loads, by_lines.text.splitlines())):
        assert [*line][:2] == ["index", "id"]
        assert (line["index"], line["id"]) == (place, ids[place])
    for wrong in (ids[1:], ["x" * 65, *ids[1:]], [1, *ids[1:]], []):
        refused = await api.post("batch", json=body | {"ids": wrong})
        assert refused.status_code == 422
        assert refused.json()["errors"][0]["pointer"].startswith("/ids")


@pytest.mark.parametrize("requests", [[], [1], "no list", [{}] * 11])
async def test_what_is_no_batch_is_refused(requests):
    transport = httpx.ASGITransport(create_app(Settings(max_batch=10)))
    async with httpx.AsyncClient(transport=transport, base_url="http://service") as client:
        body = {"calculation": "hertz", "requests": requests}
        answer = await client.post("/api/v1/batch", json=body)
    assert answer.status_code == 422
    assert answer.json()["errors"][0]["pointer"].startswith("/requests")


async def test_a_batch_may_be_larger_than_a_request_but_not_too_large():
    settings = Settings(max_body_bytes=2000, max_batch_bytes=20_000)
    transport = httpx.ASGITransport(create_app(settings))
    async with httpx.AsyncClient(transport=transport, base_url="http://service") as client:
        for count, status in ((20, 200), (200, 413)):
            body = {"calculation": "hertz", "requests": [REQUESTS["hertz"]] * count}
            answer = await client.post("/api/v1/batch", json=body)
            assert answer.status_code == status


async def evaluated(forces, solve, **limits):
    """Answers to Hertz requests of these forces, and which of them came together."""
    requests = [json.dumps(REQUESTS["hertz"] | {"force_N": force}).encode() for force in forces]
    record = Record(Settings(**limits))
    async with Jobs(processes=1, waiting=1, preload=PRELOAD) as jobs:
        job = partial(jobs_to_run.lines_of, solve=solve)
        slices = [some async for some in answers(jobs, job, requests, record)]
    return [json.loads(line) for some in slices for line in some], slices


def noted(file):
    return [float(line) for line in file.read_text().split()]


async def test_each_request_is_calculated_once_however_often_the_time_of_a_slice_is_over(tmp_path):
    forces = [*range(100, 160)]
    file = tmp_path / "evaluations"
    done, slices = await evaluated(forces, partial(jobs_to_run.noted, file))
    assert [each["result"]["force_N"] for each in done] == forces
    assert noted(file) == forces
    assert len(slices) == len(forces)


async def test_a_request_that_takes_too_long_is_refused_alone_and_nothing_is_done_twice(
    tmp_path, clock
):
    forces = [*range(100, 160), 666, *range(200, 260), 666, 300]
    file = tmp_path / "evaluations"
    asked = asyncio.create_task(
        evaluated(forces, partial(jobs_to_run.endless, file), max_seconds=1.5)
    )
    for count in (1, 2):
        while not file.exists() or noted(file).count(666) < count:
            await asyncio.sleep(0.01)
        clock.run_out()
    done, _ = await asked
    assert noted(file) == forces
    for force, each in zip(forces, done, strict=True):
        if force == 666:
            assert each["problem"]["status"] == 503
            assert "1.5 s" in each["problem"]["detail"]
        else:
            assert each["result"]["force_N"] == force


async def test_a_request_whose_process_dies_is_tried_once_more_alone(tmp_path):
    forces = [1, 2, 13, 3, 4]
    file = tmp_path / "evaluations"
    done, _ = await evaluated(forces, partial(jobs_to_run.noted, file))
    assert noted(file) == [1, 2, 13, 13, 3, 4]
    assert [each.get("problem", {}).get("status") for each in done] == [None, None, 503, None, None]


async def test_a_batch_that_is_under_way_is_not_refused_for_a_full_queue(held):
    """The batch waits for another process while the queue is full, as its own was killed."""
    body = {"calculation": "contact_force", "requests": [REQUESTS["contact-force"]] * 60}
    single = {"pins": 270, "satellites": 10, "ratio": 20.0, "crank_spacing_deg": 7.0}
    app = create_app(Settings(processes=1, max_waiting=1))
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://s/api/v1/") as client:
        asked = asyncio.create_task(client.post("batch", json=body, timeout=300))
        held.let(1)
        while held.came() < 2:  # it is read; its first requests are held
            await asyncio.sleep(0.01)
        singles = [asyncio.create_task(client.post("cyclogram", json=single)) for _ in range(4)]
        refused, _ = await asyncio.wait(singles, return_when=asyncio.FIRST_COMPLETED)
        while len(refused) < 3:
            refused, _ = await asyncio.wait(singles, return_when=asyncio.FIRST_COMPLETED)
            await asyncio.sleep(0.01)
        (child,) = app.state.jobs._children
        os.kill(child.pid, signal.SIGKILL)
        held.let()
        results = (await asked).json()["results"]
        statuses = [each.status_code for each in await asyncio.gather(*singles)]
    assert sorted(statuses) == [200, 503, 503, 503]
    assert len(results) == 60
    assert all("result" in each for each in results)


async def test_a_batch_names_so_many_wrong_fields_only(api):
    wrong = [{f"field {field}": 0 for field in range(45)}] * 20
    good = REQUESTS["hertz"]
    body = {"calculation": "hertz", "requests": [*wrong, good, good | {"force_N": -1}]}
    results = (await api.post("batch", json=body)).json()["results"]
    problems = [each["problem"] for each in results if "problem" in each]
    assert len(problems) == 21
    assert [len(each["errors"]) for each in problems] == [49, 49, 2] + 18 * [0]
    assert "more" not in problems[0]
    assert [each["more"] for each in problems[2:]] == [47, *17 * [49], 1]
    assert problems[-1]["detail"] == "1 field is wrong"
    assert "result" in results[20]


async def test_what_is_too_large_alone_is_too_large_in_a_batch():
    settings = Settings(max_body_bytes=2000, max_batch_bytes=20_000)
    transport = httpx.ASGITransport(create_app(settings))
    async with httpx.AsyncClient(transport=transport, base_url="http://service") as client:
        requests = [REQUESTS["hertz"], {"x": "y" * 2000}, REQUESTS["hertz"]]
        body = {"calculation": "hertz", "requests": requests}
        results = (await client.post("/api/v1/batch", json=body)).json()["results"]
    assert ["result" in each for each in results] == [True, False, True]
    assert results[1]["problem"]["status"] == 413


@pytest.mark.parametrize("accept", ["application/json", "application/x-ndjson"])
async def test_batches_travel_compressed_where_the_client_takes_that(api, accept):
    body = {"calculation": "hertz", "requests": [REQUESTS["hertz"]] * 300}
    sizes = {}
    for coding in ("gzip", "identity"):
        headers = {"accept": accept, "accept-encoding": coding}
        async with api.stream("POST", "batch", json=body, headers=headers) as answer:
            assert answer.headers.get("content-encoding", "identity") == coding
            assert answer.headers["vary"].lower() == "accept-encoding"
            sizes[coding] = len(b"".join([part async for part in answer.aiter_raw()]))
        assert answer.status_code == 200
    assert sizes["gzip"] < sizes["identity"] / 5


@pytest.mark.parametrize(
    ("content", "pointer", "detail"),
    [
        (b'{"calculation": "hertz", "requests": [', "", "is not valid JSON: EOF"),
        (b'{"calculation": "hertz"}', "/requests", "is needed"),
        (b'{"calculation": "x", "requests": [{}]}', "/calculation", "must be one of"),
        (b'{"calculation": "hertz", "requests": [{}], "x": 0}', "/x", "is not a known field"),
        (b'{"calculation": "hertz", "requests": [{}, 1, 2]}', "/requests/1", "must be an object"),
        (b"[]", "", "must be an object"),
    ],
)
async def test_what_is_wrong_with_a_batch_is_said(api, content, pointer, detail):
    answer = await api.post("batch", content=content, headers={"content-type": "application/json"})
    assert answer.status_code == 422
    (error,) = answer.json()["errors"]
    assert error["pointer"] == pointer
    assert error["detail"].startswith(detail)


async def test_the_service_answers_others_while_a_batch_runs(api, held):
    body = {"calculation": "contact_force", "requests": [REQUESTS["contact-force"]] * 300}
    asked = asyncio.create_task(api.post("batch", json=body))
    held.let(1)
    while held.came() < 2:
        await asyncio.sleep(0.01)
    for _ in range(10):
        assert (await api.get("health")).status_code == 200
    assert not asked.done()
    held.let()
    assert len((await asked).json()["results"]) == 300


async def test_a_slow_client_is_sent_small_parts_one_after_the_other():
    """Each has its own time: none is sent before the client has taken the one before."""
    large = REQUESTS["contact-force"] | {"pins": 20, "include": ["curves"], "samples": 2000}
    content = json.dumps({"calculation": "contact-force", "requests": [large] * 8}).encode()
    messages, taken, waiting = [{"type": "http.request", "body": content}], [], []

    async def receive():
        if messages:
            return messages.pop()
        await asyncio.Event().wait()

    async def send(message):
        assert not waiting
        waiting.append(message)
        await asyncio.sleep(0)  # as a connection that is not written to any more
        taken.append(waiting.pop().get("body", b""))

    path = "/api/v1/batch"
    scope = {
        "type": "http",
        "method": "POST",
        "path": path,
        "raw_path": path.encode(),
        "query_string": b"",
        "headers": [(b"content-type", b"application/json")],
    }
    app = create_app(Settings(processes=1))
    for sent in (scope, scope | {"path": "/static/vendor/plotly/plotly-basic.min.js"}):
        taken.clear()
        await app(sent | ({} if sent is scope else {"method": "GET"}), receive, send)
        assert max(map(len, taken)) == PART_BYTES
        assert len(b"".join(taken)) > 4 * PART_BYTES
        if sent is scope:
            assert len(json.loads(b"".join(taken))["results"]) == 8


@pytest.mark.parametrize("path", ["batch", "tolerance-study"])
async def test_no_proxy_waits_for_the_whole_of_what_is_sent_as_it_is_done(api, path):
    answer = await api.post(path, json=REQUESTS[path], headers={"accept": LINES})
    assert answer.status_code == 200 and answer.headers["x-accel-buffering"] == "no"
