"""Jobs in processes of their own: bounded, cancellable, replaceable; by the standard library only.

A job is a function of a module whose first argument takes the parts of its result. Each process has
one socket and does one job at a time. A job that is abandoned or takes too long is ended with its
process, which is replaced in the background; so is a process that is killed.

Processes come from a fork server (`app.forkserver`) that has imported all modules they need, which
takes about a tenth of a second. A process ends once its socket is closed, so that none outlives its
owner.
"""

import asyncio
import logging
import math
import os
import pickle
import signal
import socket
import subprocess
import sys
import time
import weakref
from collections import deque
from collections.abc import AsyncGenerator, Callable, Iterable
from contextlib import suppress
from functools import cache
from typing import Any, Self

LOG = logging.getLogger("khv.jobs")

START_S = 600.0
"""Time after which a process that has not started counts as unable to, s; the fork server may
compile the engine first."""

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
        self._server = _server(tuple(preload))
        self.processes = processes or os.cpu_count() or 1
        self._most_waiting = waiting
        self._children: set[_Child] = set()
        self._free: list[_Child] = []
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
            self._server.end()  # it does not react while it imports
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
        child = None
        try:
            child = self._server.fork()
            async with asyncio.timeout(START_S):
                (child.pid,) = await child.receive()
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
    end of a job. The first one is the process's id.
    """

    def __init__(self, ours: socket.socket) -> None:
        self.pid, self.socket = 0, ours
        self.received = bytearray()
        weakref.finalize(self, ours.close)

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
        """True if the process has ended."""
        try:
            return not self.socket.recv(1, socket.MSG_PEEK)
        except BlockingIOError:
            return False
        except OSError:
            return True

    def kill(self) -> None:
        with suppress(OSError):  # the process may have ended itself
            if self.pid and not self.gone():
                os.killpg(self.pid, signal.SIGKILL)
            self.socket.shutdown(socket.SHUT_RDWR)

    def end(self) -> None:
        """End the process without waiting for an answer."""
        self.kill()
        self.socket.close()


class _Server:
    """Fork server with some modules, started with the first process and anew if it has ended."""

    def __init__(self, preload: tuple[str, ...]) -> None:
        self.preload = preload
        self.process: subprocess.Popen[bytes] | None = None

    def fork(self) -> _Child:
        """Ask for a process, which starts once the server has imported its modules."""
        if self.process is None or self.process.poll() is not None:
            self._start()
        ours, theirs = socket.socketpair()
        ours.setblocking(False)
        with theirs:
            socket.send_fds(self.socket, [b"."], [theirs.fileno()])
        return _Child(ours)

    def _start(self) -> None:
        self.end()
        self.socket, theirs = socket.socketpair()
        with theirs:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "app.forkserver", str(theirs.fileno()), *self.preload],
                stdin=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)},
            )

    def end(self) -> None:
        """End the server; its processes live on."""
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.socket.close()


_server = cache(_Server)
