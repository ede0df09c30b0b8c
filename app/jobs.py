"""Jobs in processes of their own: bounded, cancellable, replaced; the standard library only.

A job is a function of a module; what it tells its first argument comes back part by part. Each
process has one socket to it and does one job at a time. A job that nobody waits for any more, or
that takes too long, costs its process, which is replaced in the background; so does one whose
process is killed.

Children come from a fork server, which has imported what they need: one is there within about a
tenth of a second. To close a child's socket is to end it, so that none outlives its owner.
"""

import asyncio
import logging
import math
import multiprocessing
import multiprocessing.util
import os
import pickle
import select
import signal
import socket
import threading
import time
import weakref
from collections import deque
from collections.abc import AsyncGenerator, Callable, Iterable
from contextlib import suppress
from multiprocessing import forkserver
from multiprocessing.process import BaseProcess
from typing import Any, Self

LOG = logging.getLogger("khv.jobs")

CONTEXT = multiprocessing.get_context("forkserver")  # a process with threads is not to be forked

START_S = 60.0
"""Time after which a process that has been forked and says nothing counts as one that cannot."""

CHECK_S = 1.0
"""How often idle processes are looked after, seconds."""

PAUSE_S = 0.005
"""How often parts are fetched that come one after the other."""

Job = Callable[..., None]


class Busy(Exception):
    """As many jobs are waiting as may.

    Attributes
    ----------
    retry_after_s : int
        When there may be room, seconds.
    """

    def __init__(self, retry_after_s: int) -> None:
        self.retry_after_s = retry_after_s


class CannotRun(Exception):
    """No process can be started."""


class TooLong(Exception):
    """A job took longer than allowed.

    Attributes
    ----------
    limit_s : float
        What was allowed, seconds.
    """

    def __init__(self, limit_s: float) -> None:
        self.limit_s = limit_s


class Stopped(Exception):
    """The process of a job was stopped by something else."""


class Jobs:
    """A fixed number of processes, for which clients wait in turn, in queues of bounded length.

    Processes start ahead within ``async with``; outside of it, with the first job.

    Parameters
    ----------
    processes : int
        How many; 0 for one to a processor.
    waiting : int
        Most jobs that may wait. Of one client no more are admitted than there is room besides, so
        that others find room too: half of it where it is alone. For who has none waiting there is
        as much room again.
    preload : iterable of str
        Modules that the jobs need.
    """

    def __init__(self, *, processes: int, waiting: int, preload: Iterable[str] = ()) -> None:
        CONTEXT.set_forkserver_preload(list(preload))
        self.processes = processes or os.cpu_count() or 1
        self._most_waiting = waiting
        self._children: set[_Child] = set()
        self._free: list[_Child] = []
        self._ended: list[BaseProcess] = []
        self._starting: set[asyncio.Task[None]] = set()
        self._waiting: dict[str, deque[asyncio.Future[_Child]]] = {}
        self._keeper: asyncio.Task[None] | None = None
        self._able = self._closed = False
        self._turn_s = 1.0

    @property
    def ready(self) -> bool:
        """Whether jobs are run: processes start ahead, and one at least has, and still could."""
        return self._keeper is not None and self._able

    async def __aenter__(self) -> Self:
        self._closed = False
        self._keeper = asyncio.create_task(self._keep())
        return self

    async def __aexit__(self, *_: object) -> None:
        """End all processes, whatever they are doing."""
        assert self._keeper is not None
        for task in (self._keeper, *self._starting):
            task.cancel()
        self._keeper, self._closed = None, True
        while self._free:
            self._replace(self._free.pop())
        for child in self._children:
            child.kill()  # whoever runs a job in it sees that
        if self._starting and not self._able:
            _end_server()
        self._refuse_waiting()

    def admit(self, client: str = "") -> None:
        """Refuse a new job of a client where too many are waiting.

        Raises
        ------
        Busy
            If there are; when there may be room is estimated from what jobs took of late.
        """
        waiting = sum(map(len, self._waiting.values()))
        own = len(self._waiting.get(client, ()))
        room = self._most_waiting if own else 2 * self._most_waiting
        if own >= room - waiting:
            turns = (waiting + 1) / self.processes
            raise Busy(math.ceil(turns * self._turn_s))

    async def run(
        self, job: Job, *args: Any, limit_s: float, admitted: bool = False, client: str = ""
    ) -> AsyncGenerator[Any]:
        """What a job tells, as it comes; to cancel or close this ends the job.

        Parameters
        ----------
        job : callable
            Function of a module; what it raises ends its process.
        *args
            Its arguments but the first; they are pickled, as is what it tells.
        limit_s : float
            Longest time from its start to its end, seconds; waiting for a process is not counted.
        admitted : bool
            Whether it may wait however many do: a part of work that has been admitted as a whole.
        client : str
            Who asks: clients take turns.

        Raises
        ------
        Busy
            If too many are waiting.
        TooLong, Stopped
            If it does not come to its end.
        CannotRun
            If there is no process and none can be started.
        """
        if not admitted:
            self.admit(client)
        child = await self._next_free(client)
        count, begun, ended = 0, time.monotonic(), False
        end = asyncio.get_running_loop().time() + limit_s
        try:
            async with asyncio.timeout_at(end):
                await child.send((job, args))
            while not ended:
                async with asyncio.timeout_at(end):
                    message = await child.receive(PAUSE_S if count > 1 else 0.0)
                count, ended = count + len(message), not message
                for part in message:
                    yield part
        except TimeoutError:
            raise TooLong(limit_s) from None
        except ConnectionError:
            LOG.warning("a process for calculations was stopped")
            raise Stopped from None
        finally:
            self._turn_s += 0.1 * (time.monotonic() - begun - self._turn_s)
            if ended:
                self._give(child)
            else:
                self._replace(child)

    async def _next_free(self, client: str) -> "_Child":
        """A process for a job of a client."""
        while self._free:
            child = self._free.pop()
            if not child.gone():
                return child
            self._replace(child)
        if self._closed:
            raise CannotRun
        turn: asyncio.Future[_Child] = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(client, deque()).append(turn)
        self._start_missing()
        try:
            return await turn
        except asyncio.CancelledError:
            if turn.done() and not turn.cancelled() and turn.exception() is None:
                self._give(turn.result())
            raise
        finally:
            with suppress(KeyError, ValueError):
                self._waiting[client].remove(turn)
                if not self._waiting[client]:
                    del self._waiting[client]

    def _give(self, child: "_Child") -> None:
        """Hand a process to who waits longest of the client whose turn it is."""
        while turn := self._next_turn():
            if not turn.done():
                turn.set_result(child)
                return
        self._free.append(child)

    def _next_turn(self) -> "asyncio.Future[_Child] | None":
        """Take the next one out of its client's queue; that client's turn comes again last."""
        if not self._waiting:
            return None
        client = next(iter(self._waiting))
        turns = self._waiting.pop(client)
        turn = turns.popleft()
        if turns:
            self._waiting[client] = turns
        return turn

    def _replace(self, child: "_Child") -> None:
        """End a process; another one is started in the background."""
        self._children.discard(child)
        child.end()
        self._ended.append(child.process)
        self._start_missing()

    def _refuse_waiting(self) -> None:
        """Nobody is going to hand over a process."""
        self._able = False
        while turn := self._next_turn():
            if not turn.done():
                turn.set_exception(CannotRun())

    def _start_missing(self) -> None:
        missing = self.processes - len(self._children) - len(self._starting)
        for _ in range(0 if self._closed else missing):
            task = asyncio.create_task(self._start_one())
            self._starting.add(task)
            task.add_done_callback(self._starting.discard)

    async def _start_one(self) -> None:
        """Start a process, in the place of one that has been ended where there is one."""
        former, child = self._ended.pop() if self._ended else None, None
        try:
            # Its server may compile the engine before it forks: that is waited for.
            child = await asyncio.to_thread(_started, former)
            async with asyncio.timeout(START_S):
                await child.receive()
        except Exception as error:
            LOG.warning("a process for calculations could not be started: %r", error)
            if not self._children:
                self._refuse_waiting()
        else:
            self._able = True
            self._children.add(child)
            self._give(child)
            child = None
        finally:
            if child is not None:
                child.end()
                self._ended.append(child.process)

    async def _keep(self) -> None:
        """Start what is missing, and what dies while it has nothing to do."""
        while True:
            for child in [child for child in self._free if child.gone()]:
                self._free.remove(child)
                self._replace(child)
            self._start_missing()
            await asyncio.sleep(CHECK_S)


class _Child:
    """A process that does one job after another, and the socket to it.

    A message is a pickled tuple behind the eight bytes of its length: parts of what the job tells;
    an empty one where it has come to its end, and at the start.
    """

    def __init__(self, process: BaseProcess, ours: socket.socket) -> None:
        self.process, self.socket = process, ours
        self.received = bytearray()
        weakref.finalize(self, ours.close)
        # Before multiprocessing waits for its children at exit, in processes that it forked too.
        multiprocessing.util.Finalize(self, _kill, (process,), exitpriority=0)

    async def send(self, message: object) -> None:
        await asyncio.get_running_loop().sock_sendall(self.socket, pickle.dumps(message))

    async def receive(self, pause_s: float = 0.0) -> tuple[Any, ...]:
        if pause_s and not self.received:
            await asyncio.sleep(pause_s)
        size = int.from_bytes(await self._next_bytes(8), "big")
        message: tuple[Any, ...] = pickle.loads(await self._next_bytes(size))
        return message

    async def _next_bytes(self, count: int) -> bytes:
        loop = asyncio.get_running_loop()
        while len(self.received) < count:
            if not (more := await loop.sock_recv(self.socket, 1 << 18)):
                raise ConnectionResetError
            self.received += more
        taken = bytes(memoryview(self.received)[:count])
        del self.received[:count]
        return taken

    def gone(self) -> bool:
        """Whether the process of an idle child has ended."""
        try:
            return not self.socket.recv(1, socket.MSG_PEEK)
        except BlockingIOError:
            return False
        except OSError:
            return True

    def kill(self) -> None:
        with suppress(OSError):  # it may have gone itself
            self.socket.shutdown(socket.SHUT_RDWR)
        self.process.kill()

    def end(self) -> None:
        """The same where nobody waits for its answer any more."""
        self.kill()
        self.socket.close()


STARTING = threading.Lock()
"""To start a process multiprocessing goes through all that there are: none may be closed then."""


def _started(former: BaseProcess | None) -> _Child:
    """A new process, once the one before has ended."""
    if former is not None:
        with suppress(ValueError):  # it is closed already
            former.join(START_S)
            with STARTING:
                former.close()
    ours, theirs = socket.socketpair()
    with theirs:
        ours.setblocking(False)
        process = CONTEXT.Process(target=_serve, args=(theirs,), daemon=True)
        child = _Child(process, ours)
        with STARTING:
            process.start()
    return child


def _end_server() -> None:
    """End the fork server, which answers nobody while it imports: another one starts if wanted,
    which multiprocessing sees once this one has ended.
    """
    if pid := forkserver._forkserver._forkserver_pid:  # type: ignore[attr-defined]
        with suppress(ProcessLookupError, ChildProcessError):  # it is waited for elsewhere
            os.kill(pid, signal.SIGKILL)
            os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)


def _kill(process: BaseProcess) -> None:
    with suppress(AttributeError, ValueError):  # not started yet, or closed already
        process.kill()


def _serve(pipe: socket.socket) -> None:
    """Do jobs until the other end of the pipe is closed.

    Signals are left to the owner: those to its whole group would lose jobs that are to be finished.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(pipe,), daemon=True).start()

    def tell(*parts: Any) -> None:
        content = pickle.dumps(parts)
        pipe.sendall(len(content).to_bytes(8, "big") + content)

    owner_gone = suppress(EOFError, pickle.UnpicklingError, ConnectionError)
    with owner_gone, pipe.makefile("rb") as jobs:
        tell()
        while True:
            job, args = pickle.load(jobs)
            job(tell, *args)
            tell()


def _end_with(pipe: socket.socket) -> None:
    """End this process once the other end of the pipe is closed, also within a job."""
    hang_up = select.poll()
    hang_up.register(pipe, 0)  # that it is closed is always told
    hang_up.poll()
    os._exit(1)
