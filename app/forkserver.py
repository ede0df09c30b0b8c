"""Fork server of `app.jobs`: ``python -m app.forkserver SOCKET MODULE ...``.

It imports modules once, and then forks a process for each socket that its owner sends. Processes
with threads must not fork; therefore the service does not do it itself.
"""

import os
import pickle
import select
import signal
import socket
import sys
import threading
from contextlib import suppress
from importlib import import_module
from typing import Any


def main(number: str, *modules: str) -> None:
    """Import modules, and fork until the owner has gone. Signals are ignored, as a signal to the
    whole group would lose jobs that the owner wants to finish.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    for module in modules:
        import_module(module)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # ended processes leave nothing behind
    owner = socket.socket(fileno=int(number))
    while descriptors := socket.recv_fds(owner, 1, 1)[1]:
        with socket.socket(fileno=descriptors[0]) as pipe:
            if os.fork() == 0:
                os.setpgid(0, 0)  # what a job starts ends with it
                owner.close()
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                serve(pipe)
                return


def serve(pipe: socket.socket) -> None:
    """Do jobs until the other end of the pipe is closed."""
    threading.Thread(target=_end_with, args=(pipe,), daemon=True).start()

    def tell(*parts: Any) -> None:
        content = pickle.dumps(parts)
        pipe.sendall(len(content).to_bytes(8, "big") + content)

    owner_gone = suppress(EOFError, pickle.UnpicklingError, ConnectionError)
    with owner_gone, pipe.makefile("rb") as jobs:
        tell(os.getpid())
        while True:
            job, args = pickle.load(jobs)
            job(tell, *args)
            tell()


def _end_with(pipe: socket.socket) -> None:
    """End this process and what it started once the other end of the pipe is closed, even within a
    job.
    """
    hang_up = select.poll()
    hang_up.register(pipe, 0)  # an event mask of 0 still reports a closed pipe
    hang_up.poll()
    os.killpg(0, signal.SIGKILL)


if __name__ == "__main__":
    main(*sys.argv[1:])
