"""The API in the same process; what is slow there, is slow as long as a test says."""

import asyncio
import os
from functools import partial

import httpx
import pytest

from app import main, processes
from app.main import create_app
from app.settings import Settings
from tests.app import jobs_to_run
from tests.inputs.bodies import applied

APP = create_app(Settings(max_seconds=300))  # a busy machine is no reason to fail


@pytest.fixture(scope="session", autouse=True)
def described_when_asked():
    """No thread describes the API beside a test: warnings that FastAPI ignores meanwhile are errors
    as soon as the filters of a test are set.
    """
    main.DESCRIBED_S = 3600.0


@pytest.fixture
def anyio_backend():
    return "asyncio"


class Api(httpx.AsyncClient):
    """Client of the API in the same process, below /api/v1/."""

    def __init__(self):
        super().__init__(transport=httpx.ASGITransport(app=APP), base_url="http://service/api/v1/")

    async def answer(self, path, body, status=200):
        """Answer to a body."""
        response = await self.post(path, json=body)
        assert response.status_code == status, response.text
        return response.json()

    async def judged(self, path, body):
        """Answer to a body, and its checks by code."""
        answer = await self.answer(path, body)
        return answer, {each["code"]: each for each in answer.get("checks", ())}

    async def reposted(self, path, body, fix):
        """Answer after a fix, whose check passes where it is solved."""
        after, checks = await self.judged(
            path, applied(body, fix["sets"]) | {"include": ["checks"]}
        )
        assert after["verdict"] == fix["verdict"], fix
        if fix["status"] == "solved":
            check = checks[fix["code"]]
            unsourced = check.get("reason", {}).get("code") == "no_sourced_limit"
            assert check["status"] == "pass" or unsourced, fix
        return after

    async def refusal(self, path, body):
        """Pointer and code of the only error of a body."""
        (error,) = (await self.answer(path, body, 422))["errors"]
        return error["pointer"], error["code"]


@pytest.fixture
async def api():
    """Client of the API in the same process."""
    async with Api() as client:
        yield client


class Gate:
    """Gate at which jobs in processes wait until a test lets them pass. Of its two files, which
    reach every process, one grows with each job that arrives, and the size of the other is the
    number of jobs that may pass.
    """

    def __init__(self, folder):
        self.path = folder / "gate"

    def came(self):
        """How many have come to it."""
        return self.path.stat().st_size if self.path.exists() else 0

    def let(self, count=1_000_000):
        """Let so many pass in all."""
        let = self.path.with_suffix(jobs_to_run.LET)
        let.touch()
        os.truncate(let, count)

    @property
    def held(self):
        """A job that waits at it."""
        return partial(jobs_to_run.held, self.path)


@pytest.fixture
def gate(tmp_path):
    """A gate that is closed; what waits there at the end passes."""
    closed = Gate(tmp_path)
    yield closed
    closed.let()


@pytest.fixture
def held(gate, monkeypatch):
    """A closed gate before all that services in this process hand to others."""
    monkeypatch.setattr(processes, "told", partial(jobs_to_run.told_when_let, gate.path))
    return gate


class Clock:
    """The limits of jobs, which are over when a test says so."""

    def __init__(self):
        self.ends, self._timeout_at = [], asyncio.timeout_at

    def timeout_at(self, end):
        """Stands in for that of asyncio: notes the end, and waits for ever."""
        self.ends.append(end)
        self.last = self._timeout_at(None)
        return self.last

    def run_out(self):
        """The time of the job that was last waited for is over."""
        self.last.reschedule(0.0)


@pytest.fixture
def clock(monkeypatch):
    """The clock of jobs."""
    stopped = Clock()
    monkeypatch.setattr(asyncio, "timeout_at", stopped.timeout_at)
    return stopped
