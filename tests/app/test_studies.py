"""Studies that tell how much of them is done, line by line: progress before the end, the same
result, refusals, and nothing left running where the client goes.
"""

import asyncio
import json
from functools import partial

import pytest

from app import endpoint, processes
from app.calculations.tolerance_study import ToleranceStudyRequest, reporting
from app.endpoint import LINES
from app.examples import REQUESTS
from app.jobs import Jobs, Stopped, TooLong
from app.main import PRELOAD, create_app
from app.problems import problem_of
from app.processes import in_parts
from app.record import Record
from app.settings import Settings
from tests.app import jobs_to_run
from tests.running_service import lives

pytestmark = pytest.mark.anyio

PATH = "tolerance-study"
STUDY = REQUESTS[PATH]
HEADERS = {"accept": LINES, "content-type": "application/json"}


class Client:
    """One request to an ASGI application, whose answer is read line by line as it comes."""

    def __init__(self, app, body, **headers):
        self.app, self.gone, self.lines = app, asyncio.Event(), asyncio.Queue()
        self.status, self.asked = 0, False
        self.content = json.dumps(body).encode()
        self.headers = [(k.encode(), v.encode()) for k, v in (HEADERS | headers).items()]
        self.answering = asyncio.create_task(app(self.scope, self.receive, self.send))

    @property
    def scope(self):
        path = f"/api/v1/{PATH}"
        return {
            "type": "http",
            "method": "POST",
            "path": path,
            "raw_path": path.encode(),
            "query_string": b"",
            "headers": self.headers,
        }

    async def receive(self):
        if not self.asked:
            self.asked = True
            return {"type": "http.request", "body": self.content, "more_body": False}
        await self.gone.wait()
        return {"type": "http.disconnect"}

    async def send(self, message):
        if message["type"] == "http.response.start":
            self.status = message["status"]
            self.kind = dict(message["headers"])[b"content-type"].decode()
        for line in message.get("body", b"").splitlines():
            self.lines.put_nowait(json.loads(line))


def processes_of(app):
    return {child.pid for child in app.state.jobs._children}


async def test_progress_comes_before_the_end_and_leaving_ends_the_study(gate, monkeypatch):
    app = create_app(Settings(processes=1, max_study_seconds=300))
    half_way = partial(jobs_to_run.told_half_way, gate.path)
    with monkeypatch.context() as patched:
        patched.setattr(processes, "told", half_way)
        client = Client(app, STUDY)
        first = await client.lines.get()
    assert first == {"progress": 0.5} and not client.answering.done()
    assert (client.status, client.kind) == (200, LINES)
    (busy,) = processes_of(app)
    client.gone.set()
    await asyncio.gather(client.answering, return_exceptions=True)
    while lives(busy):
        await asyncio.sleep(0.02)
    # and the next one is served
    short = Client(app, STUDY)
    await short.answering
    assert "result" in last_of(short)


def last_of(client):
    lines = []
    while not client.lines.empty():
        lines.append(client.lines.get_nowait())
    assert all([*line] == ["progress"] for line in lines[:-1])
    return lines[-1]


async def test_the_result_is_that_without_progress(api):
    whole = (await api.post(PATH, json=STUDY)).json()
    by_lines = await api.post(PATH, json=STUDY, headers={"accept": LINES})
    assert by_lines.headers["content-type"] == LINES
    result = json.loads(by_lines.text.splitlines()[-1])["result"]
    for answer in (whole, result):
        del answer["accuracy"]["run_time_us"]
    assert result == whole


@pytest.mark.parametrize("include", [[], ["contributions"]])
def test_all_of_it_is_done_at_the_end(include):
    body = STUDY | {"include": include, "samples": 20, "crank_angles": 12, "percentiles": [50.0]}
    told = []
    reporting(ToleranceStudyRequest.model_validate(body), told.append)
    assert told == sorted(told) and told[-1] == 1
    assert len(told) == (15 if include else 1)  # all pieces at once, each time


@pytest.mark.parametrize(
    ("change", "pointer"),
    [
        ({"samples": 0}, "/samples"),
        ({"samples": 1_000_000}, "/samples"),
        ({"percentiles": [99.9]}, "/percentiles/0"),
        ({"x": 1}, "/x"),
    ],
)
async def test_what_is_wrong_is_refused_as_a_whole(api, change, pointer):
    answer = await api.post(PATH, json=STUDY | change, headers={"accept": LINES})
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.json()["errors"][0]["pointer"] == pointer


async def test_what_cannot_work_is_the_last_line(api):
    soft = STUDY | {"contact_law": {"kind": "linear", "stiffness_N_per_mm": 1.0}}
    answer = await api.post(PATH, json=soft, headers={"accept": LINES})
    assert answer.status_code == 200
    problem = json.loads(answer.text.splitlines()[-1])["problem"]
    assert (problem["status"], problem["errors"][0]["code"]) == (422, "not_stable")


async def test_more_time_is_given_than_to_an_answer_at_once(api):
    at_once = await api.post(PATH, json=STUDY | {"samples": 1_000_000})
    limit = at_once.json()["errors"][0]["params"]["limit"]
    by_lines = await api.post(PATH, json=STUDY | {"samples": 1_000_000}, headers={"accept": LINES})
    # 300 s of the tests' own service, 60 s by default
    assert by_lines.json()["errors"][0]["params"]["limit"] == limit // 5


@pytest.mark.parametrize(
    ("job", "said"), [("tells_then_blocks", "2 s"), ("tells_then_dies", "stopped")]
)
async def test_what_does_not_come_to_its_end_has_given_what_it_had(clock, job, said):
    got = []
    async with Jobs(processes=1, waiting=1, preload=PRELOAD) as jobs:
        record = Record()
        parts = in_parts(jobs, getattr(jobs_to_run, job), 3, record=record, limit_s=2)

        async def take():
            async for part in parts:
                got.append(part)

        taking = asyncio.create_task(take())
        while len(got) < 3 and not taking.done():
            await asyncio.sleep(0.02)
        if job == "tells_then_blocks":
            clock.run_out()
        with pytest.raises((TooLong, Stopped)) as error:
            await taking
    problem = problem_of(error.value)
    assert got == [0, 1, 2]
    assert problem.status == 503 and said in problem.detail


def test_so_much_is_told_only_as_anyone_can_see(monkeypatch):
    content = json.dumps(STUDY | {"samples": 640, "crank_angles": 12}).encode()

    def lines():
        told = []
        endpoint.told_progress(told.append, PATH, content, Settings())
        assert told[0] == b""
        return [json.loads(line) for line in told[1:]]

    monkeypatch.setattr(endpoint, "PROGRESS_S", 1e9)
    assert [[*line] for line in lines()] == [["result"]]
    monkeypatch.setattr(endpoint, "PROGRESS_S", 0.0)
    *shares, last = lines()
    assert [*last] == ["result"]
    assert len(shares) > 1 and shares[-1] == {"progress": 1.0}
