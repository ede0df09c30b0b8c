"""Batches: in order, each request with its own answer or problem, whole or line by line."""

import asyncio
import json

import httpx
import pytest

from app import batches
from app.examples import REQUESTS
from app.main import create_app
from app.problems import unavailable
from app.settings import Settings

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
    """Whether answers agree, but for the last digits and for how they were got."""
    if isinstance(one, dict):
        return set(one) == set(other) and all(
            each == "accuracy" or same(one[each], other[each], each) for each in one
        )
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, float):  # a smooth peak is known much better than its place
        place = 1e-8 if name == "peak_crank_angle_deg" else 1e-13
        return one == pytest.approx(other, rel=1e-13, abs=place)
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
    pressures = [line["result"]["max_pressure_MPa"] for line in lines]
    assert len(pressures) == 400
    # p0 grows with the root of the force
    assert pressures[-1] / pressures[0] == pytest.approx(20, rel=1e-12)


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


async def test_one_request_that_takes_too_long_does_not_fail_the_others(api, monkeypatch):
    light = {"pins": 3, "ratio": 20, **LOAD}
    heavy = light | {"pins": 5}

    async def in_process(job, batched, requests, settings, *, record):
        if heavy in requests:
            raise unavailable("The calculation was not done in time")
        return job(batched, requests, settings)

    monkeypatch.setattr(batches, "in_process", in_process)
    body = {"calculation": "contact_force", "requests": [light, heavy, light]}
    first, second, third = (await api.post("batch", json=body)).json()["results"]
    assert same(first, third) and "result" in first
    assert second["problem"]["status"] == 503


async def test_the_service_answers_others_while_a_batch_runs(api):
    body = {"calculation": "contact_force", "requests": [REQUESTS["contact-force"]] * 3000}
    asked = asyncio.create_task(api.post("batch", json=body))
    answered = 0
    while not asked.done():
        assert (await api.get("health")).status_code == 200
        answered += 1
        await asyncio.sleep(0.01)
    assert answered > 3
    assert len((await asked).json()["results"]) == 3000
