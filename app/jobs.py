"""Jobs in processes of their own: bounded, cancellable, replaceable; by the standard library only.

A job is a function of a module whose first argument takes the parts of its result. Each process has
one socket and does one job at a time. A job that is abandoned or takes too long is ended with its
process, which is replaced in the background; so is a process that is killed.

Processes come from a fork server that has imported all modules they need, which takes about a tenth
of a second. A process ends once its socket is closed, so that none outlives its owner.
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

CONTEXT = multiprocessing.get_context("forkserver")  # processes with threads must not fork

START_S = 60.0
"""Time after which a forked process that does not answer counts as unable to start, s."""

CHECK_S = 1.0
"""Interval at which idle processes are checked, s."""

PAUSE_S = 0.005
"""Interval at which successive parts are fetched, s."""

Job = Callable[..., None]


class Busy(Exception):
    """Refusal as too many jobs are waiting; `retry_after_s` estimates when there is room, s."""

    def __init__(self, retry_after_s: int) -> None:
        self.retry_after_s = retry_after_s


class CannotRun(Exception):
    """Failure to start any process."""


class TooLong(Exception):
    """Job that took longer than `limit_s`, s."""

    def __init__(self, limit_s: float) -> None:
        self.limit_s = limit_s


class Stopped(Exception):
    """Job whose process was stopped from outside."""


class Jobs:
    """Fixed number of processes, for which clients wait in turn in queues of bounded length.

    Processes start in advance within ``async with``, otherwise with the first job.

    Parameters
    ----------
    processes : int
        Number of processes; 0 for one per processor.
    waiting : int
        Largest number of waiting jobs. A client may have at most as many as stay free for others,
        half of them for a single client; a client without a waiting job has twice the room.
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
        """True if processes started in advance, and at least one has started and still could."""
        return self._keeper is not None and self._able

    async def __aenter__(self) -> Self:
        self._closed = False
        self._keeper = asyncio.create_task(self._keep())
        return self

    async def __aexit__(self, *_: object) -> None:
        """End all processes at once."""
        assert self._keeper is not None
        for task in (self._keeper, *self._starting):
            task.cancel()
        self._keeper, self._closed = None, True
        while self._free:
            self._replace(self._free.pop())
        for child in self._children:
            child.kill()  # a running job gets an error
        if self._starting and not self._able:
            _end_server()
        self._refuse_waiting()

    def admit(self, client: str = "") -> None:
        """Raise `Busy` if too many jobs of a client are waiting."""
        waiting = sum(map(len, self._waiting.values()))
        own = len(self._waiting.get(client, ()))
        room = self._most_waiting if own else 2 * self._most_waiting
        if own >= room - waiting:
            turns = (waiting + 1) / self.processes
            raise Busy(math.ceil(turns * self._turn_s))

    async def run(
        self, job: Job, *args: Any, limit_s: float, admitted: bool = False, client: str = ""
    ) -> AsyncGenerator[Any]:
        """Parts of a job's result as they come; cancelling or closing the generator ends the job.

        Parameters
        ----------
        job : callable
            Function of a module; an exception in it ends its process.
        *args
            Further arguments of the job; arguments and parts are pickled.
        limit_s : float
            Longest time from the start of the job to its end, s, without waiting for a process.
        admitted : bool
            True lets the job wait in any case, as part of work that was admitted as a whole.
        client : str
            Client, as clients take turns.

        Raises
        ------
        Busy
            If too many jobs are waiting.
        TooLong, Stopped
            If the job does not end properly.
        CannotRun
            If no process exists and none can be started.
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
        """Free process for a job of a client."""
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
        """Give a process to the client whose turn it is, for its oldest job."""
        while turn := self._next_turn():
            if not turn.done():
                turn.set_result(child)
                return
        self._free.append(child)

    def _next_turn(self) -> "asyncio.Future[_Child] | None":
        """Take the next job out of its client's queue, and put the client last."""
        if not self._waiting:
            return None
        client = next(iter(self._waiting))
        turns = self._waiting.pop(client)
        turn = turns.popleft()
        if turns:
            self._waiting[client] = turns
        return turn

    def _replace(self, child: "_Child") -> None:
        """End a process, and start another one in the background."""
        self._children.discard(child)
        child.end()
        self._ended.append(child.process)
        self._start_missing()

    def _refuse_waiting(self) -> None:
        """Refuse all waiting jobs, as no process will come."""
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
        """Start a process, in place of an ended one if there is one."""
        former, child = self._ended.pop() if self._ended else None, None
        try:
            # The fork server may compile the engine before it forks, which has to be waited for.
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
        """Start missing processes, and replace idle ones that died."""
        while True:
            for child in [child for child in self._free if child.gone()]:
                self._free.remove(child)
                self._replace(child)
            self._start_missing()
            await asyncio.sleep(CHECK_S)


class _Child:
    """Process that does one job after another, with its socket.

    A message is a pickled tuple after eight bytes of its length: parts of a result, or empty at the
    end of a job and at the start.
    """

    def __init__(self, process: BaseProcess, ours: socket.socket) -> None:
        self.process, self.socket = process, ours
        self.received = bytearray()
        weakref.finalize(self, ours.close)
        # At exit this runs before multiprocessing waits for children, in forked processes too.
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
        """True if the process of an idle child has ended."""
        try:
            return not self.socket.recv(1, socket.MSG_PEEK)
        except BlockingIOError:
            return False
        except OSError:
            return True

    def kill(self) -> None:
        with suppress(OSError):  # the process may have ended itself
            self.socket.shutdown(socket.SHUT_RDWR)
        self.process.kill()

    def end(self) -> None:
        """End the process without waiting for an answer."""
        self.kill()
        self.socket.close()


STARTING = threading.Lock()
"""Lock for starting processes: multiprocessing walks through all of them, and none may be closed
then."""


def _started(former: BaseProcess | None) -> _Child:
    """New process, started after the previous one ended."""
    if former is not None:
        with suppress(ValueError):  # closed already
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
    """End the fork server, which does not react while it imports; multiprocessing starts another
    one on demand once this one has ended.
    """
    if pid := forkserver._forkserver._forkserver_pid:  # type: ignore[attr-defined]
        with suppress(ProcessLookupError, ChildProcessError):  # another place waits for it
            os.kill(pid, signal.SIGKILL)
            os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)


def _kill(process: BaseProcess) -> None:
    with suppress(AttributeError, ValueError):  # not started yet, or closed already
        process.kill()


def _serve(pipe: socket.socket) -> None:
    """Do jobs until the other end of the pipe is closed. Signals are ignored, as a signal to the
    whole group would lose jobs that the owner wants to finish.
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
    """End this process once the other end of the pipe is closed, even within a job."""
    hang_up = select.poll()
    hang_up.register(pipe, 0)  # an event mask of 0 still reports a closed pipe
    hang_up.poll()
    os._exit(1)
