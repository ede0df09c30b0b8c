"""Jobs in processes: bounded, cancelled, replaced, under the event loop of the service too."""

import asyncio
import gc
import os
import random
import signal
import socket
import sys
from collections import Counter
from pathlib import Path

import pytest

from app import jobs as module
from app.jobs import Busy, CannotRun, Jobs, Stopped, TooLong
from app.main import PRELOAD
from tests.app import jobs_to_run
from tests.inputs.children import ran
from tests.running_service import calculators, lives

pytestmark = pytest.mark.anyio


@pytest.fixture(params=[False, True], ids=["asyncio", "uvloop"])
def anyio_backend(request):
    return "asyncio", {"use_uvloop": request.param}


@pytest.fixture
async def started():
    async with Jobs(processes=2, waiting=8, preload=PRELOAD) as jobs:
        await until(lambda: len(pids(jobs)) == 2)
        assert jobs.ready
        yield jobs


def pids(jobs):
    return {child.pid for child in jobs._children}


async def all_of(jobs, *asked, told=None, **limits):
    """All that a job tells."""
    told = [] if told is None else told
    async for part in jobs.run(*asked, **limits):
        told.append(part)
    return told


async def until(holds):
    """Wait for what has to come."""
    while not holds():
        await asyncio.sleep(0.02)


async def test_parts_come_in_their_order_however_many_or_large(started):
    for count in (0, 1, 2, 5000):
        assert await all_of(started, jobs_to_run.counts, count, limit_s=60) == list(range(count))
    assert await all_of(started, jobs_to_run.large, 30_000_000, limit_s=60) == [bytes(30_000_000)]
    assert await all_of(started, jobs_to_run.length, bytes(30_000_000), limit_s=60) == [30_000_000]


async def test_no_more_processes_than_there_are_to_be_and_all_are_used(started):
    used = await asyncio.gather(
        *(all_of(started, jobs_to_run.pid_of, limit_s=60) for _ in range(5))
    )
    assert {pid for (pid,) in used} == pids(started)
    assert len(pids(started)) == 2


async def test_waiting_is_not_counted(started, gate, clock):
    """The time of what waits begins with its turn, when others have been let pass."""
    running = [
        asyncio.create_task(all_of(started, gate.held, limit_s=2, admitted=True)) for _ in range(12)
    ]
    await until(lambda: gate.came() == 2)
    let = asyncio.get_running_loop().time()
    assert max(clock.ends) < let + 2
    gate.let()
    assert len(await asyncio.gather(*running)) == 12
    # of each of the ten others as it is sent, and as it is waited for
    assert sum(end >= let + 2 for end in clock.ends) >= 20


async def test_a_full_queue_refuses_at_once_and_says_when_to_come_again(started, gate):
    running = []
    for _ in range(6):
        running.append(asyncio.create_task(all_of(started, gate.held, limit_s=60)))
        await asyncio.sleep(0)
    for refused in (all_of(started, gate.held, limit_s=60) for _ in range(3)):
        with pytest.raises(Busy) as busy:
            await refused
        assert 1 <= busy.value.retry_after_s <= 3
    assert not any(each.done() for each in running)
    part_of_more = all_of(started, gate.held, limit_s=60, admitted=True)
    gate.let()
    await asyncio.gather(*running, part_of_more)
    started.admit()


async def test_clients_take_turns_and_none_takes_all_the_room(gate):
    done = []
    jobs = Jobs(processes=1, waiting=9, preload=PRELOAD)

    async def ask(client, job):
        await all_of(jobs, gate.held, limit_s=60, client=client)
        done.append((client, job))

    def refused(client):
        try:
            jobs.admit(client)
        except Busy:
            return True
        return False

    async with jobs:
        await until(lambda: jobs.ready)
        asking = []
        for client, job in [*((1, n) for n in range(6)), (2, 0), (2, 1), (3, 0)]:
            assert not refused(client)
            asking.append(asyncio.create_task(ask(client, job)))
            await asyncio.sleep(0)
        assert [refused(client) for client in (1, 2, 3, 4)] == [True, True, True, False]
        gate.let()
        await asyncio.gather(*asking)
    assert done[:6] == [(1, 0), (1, 1), (2, 0), (3, 0), (1, 2), (2, 1)]
    assert done[6:] == [(1, 3), (1, 4), (1, 5)]
    assert not jobs._waiting


@pytest.mark.parametrize("end", ["too_long", "left", "closed"])
async def test_what_a_job_has_started_ends_with_it(clock, end):
    """If its time is over, its client has left, or its owner has gone."""
    told = []
    async with Jobs(processes=1, waiting=1, preload=PRELOAD) as jobs:
        asked = asyncio.create_task(all_of(jobs, jobs_to_run.starts_another, limit_s=1, told=told))
        await until(lambda: told)
        assert lives(told[0])
        if end == "too_long":
            clock.run_out()
            with pytest.raises(TooLong):
                await asked
        elif end == "left":
            asked.cancel()
        else:
            for child in jobs._children:  # as if this process had died
                child.pid = 0
                child.socket.shutdown(socket.SHUT_RDWR)
            with pytest.raises(Stopped):
                await asked
        await until(lambda: not lives(told[0]))


async def test_what_takes_too_long_ends_and_what_it_had_done_is_kept(started, clock):
    before = pids(started)
    told = []
    blocked = all_of(started, jobs_to_run.tells_then_blocks, 100, limit_s=1, told=told)
    asked = asyncio.create_task(blocked)
    await until(lambda: len(told) == 100)
    clock.run_out()
    with pytest.raises(TooLong):
        await asked
    assert told == list(range(100))
    await until(lambda: len(pids(started)) == 2)
    (killed,) = before - pids(started)
    await until(lambda: not lives(killed))


async def test_a_process_that_dies_costs_its_own_job_only(started, gate):
    other = asyncio.create_task(all_of(started, gate.held, limit_s=60))
    await until(lambda: gate.came() == 1)
    told = []
    with pytest.raises(Stopped):
        await all_of(started, jobs_to_run.tells_then_dies, 100, limit_s=60, told=told)
    assert told == list(range(100))
    gate.let()
    assert len(await other) == 1
    await until(lambda: len(pids(started)) == 2)


async def test_a_process_that_dies_idle_is_replaced(started):
    before = pids(started)
    for pid in before:
        os.kill(pid, signal.SIGKILL)
    await until(lambda: len(pids(started) - before) == 2)
    assert await all_of(started, jobs_to_run.counts, 1, limit_s=60) == [0]


async def test_cancelled_jobs_leave_nothing_behind(started):
    """At any time: before, while and after they are done, whichever a machine makes of it."""
    descriptors = len(os.listdir("/proc/self/fd"))
    r = random.Random(1)
    for _ in range(50):
        job = asyncio.create_task(all_of(started, jobs_to_run.pid_of, limit_s=60))
        await asyncio.sleep(r.choice([0, 1e-3, 0.1]) * r.random())
        job.cancel()
        assert len(pids(started)) <= 2
    assert len(await all_of(started, jobs_to_run.pid_of, limit_s=60)) == 1
    await until(lambda: len(pids(started)) == 2)
    await until(lambda: pids(started) <= calculators(os.getpid()))
    await until(lambda: len(os.listdir("/proc/self/fd")) <= descriptors)


async def test_jobs_that_are_cancelled_while_they_wait_leave_the_queue(started, gate):
    running = [asyncio.create_task(all_of(started, gate.held, limit_s=60)) for _ in range(6)]
    await asyncio.sleep(0)
    with pytest.raises(Busy):
        started.admit()
    running[-1].cancel()
    await asyncio.sleep(0)
    started.admit()
    gate.let()
    assert len(await asyncio.gather(*running[:-1])) == 5


async def test_signals_to_the_group_do_not_end_a_job(started, gate):
    job = asyncio.create_task(all_of(started, gate.held, limit_s=60))
    await until(lambda: gate.came() == 1)
    for pid in pids(started):
        os.kill(pid, signal.SIGTERM)
        os.kill(pid, signal.SIGINT)
    gate.let()
    ((pid,),) = [await job]
    assert pid in pids(started)


HELD = """
import asyncio
from app.jobs import Jobs

async def ended_while_its_server_imports():
    async with Jobs(processes=1, waiting=1, preload=["held"]):
        await asyncio.to_thread(lambda: open("came").read())

if __name__ == "__main__":
    asyncio.run(ended_while_its_server_imports())
"""


def test_a_server_that_is_still_importing_is_not_waited_for(tmp_path):
    """A server may compile loops for minutes; here it never answers."""
    for name in ("came", "never"):
        os.mkfifo(tmp_path / name)
    (tmp_path / "held.py").write_text("open('came', 'w').close(), open('never').read()")
    (tmp_path / "main.py").write_text(HELD)
    paths = os.pathsep.join((str(tmp_path), str(Path(module.__file__).parent.parent)))
    environment = os.environ | {"PYTHONPATH": paths}
    ran(sys.executable, "main.py", cwd=tmp_path, env=environment)


async def test_a_server_that_is_killed_is_started_anew(started):
    before, server = pids(started), started._server.process.pid
    for pid in (server, *before):
        os.kill(pid, signal.SIGKILL)
    await until(lambda: len(pids(started) - before) == 2)
    assert await all_of(started, jobs_to_run.counts, 1, limit_s=60) == [0]
    assert started._server.process.pid != server and not lives(server)


async def test_where_no_process_can_be_started_jobs_are_refused_until_one_can(monkeypatch):
    def fails(server):
        raise OSError("no more processes")

    with monkeypatch.context() as patched:
        patched.setattr(module._Server, "fork", fails)
        async with Jobs(processes=2, waiting=8, preload=PRELOAD) as jobs:
            waiting = [
                asyncio.create_task(all_of(jobs, jobs_to_run.counts, 1, limit_s=60))
                for _ in range(3)
            ]
            for each in waiting:
                with pytest.raises(CannotRun):
                    await each
            assert not jobs.ready
            patched.undo()
            await until(lambda: jobs.ready)
            assert await all_of(jobs, jobs_to_run.counts, 1, limit_s=60) == [0]
    assert not jobs.ready


async def test_processes_end_with_their_jobs(gate):
    async with Jobs(processes=2, waiting=8, preload=PRELOAD) as jobs:
        await until(lambda: len(pids(jobs)) == 2)
        running = asyncio.create_task(all_of(jobs, gate.held, limit_s=7200))
        await until(lambda: gate.came() == 1)
        before = pids(jobs)
    await until(lambda: not any(map(lives, before)))
    with pytest.raises(Stopped):
        await running
    assert not pids(jobs)
    with pytest.raises(CannotRun):
        await all_of(jobs, jobs_to_run.counts, 1, limit_s=60)


async def test_without_being_started_ahead_processes_start_with_the_first_job():
    jobs = Jobs(processes=1, waiting=4, preload=PRELOAD)
    assert not pids(jobs)
    assert await all_of(jobs, jobs_to_run.counts, 3, limit_s=60) == [0, 1, 2]
    (pid,) = pids(jobs)
    del jobs
    gc.collect()
    await until(lambda: not lives(pid))


async def test_who_has_nothing_waiting_finds_room(gate):
    """However many addresses others have: eight fill the queue, which has as much room again."""
    jobs = Jobs(processes=1, waiting=8, preload=PRELOAD)
    asking, waiting = [], Counter()

    async def asked(client):
        try:
            jobs.admit(client)
        except Busy:
            return False
        job = all_of(jobs, gate.held, limit_s=60, client=client)
        asking.append(asyncio.create_task(job))
        await asyncio.sleep(0)
        waiting[client] += 1
        return True

    async with jobs:
        await until(lambda: jobs.ready)
        for _ in range(20):
            for client in range(8):
                await asked(client)
        held = waiting.total() - 1  # one is done
        assert 8 <= held < 16 and not await asked(0)
        others = [await asked(f"other {each}") for each in range(20)]
        assert others == [True] * (16 - held) + [False] * (4 + held)
        gate.let()
        await asyncio.gather(*asking)
