"""A Dask cluster on loopback, as an operator starts it."""

import os
import re
import subprocess
import sys

from tests.inputs.children import end, start


class Cluster:
    """A scheduler and its workers, each a process."""

    def __init__(self, workers: int = 2) -> None:
        self.processes: list[subprocess.Popen[str]] = []
        self.scheduler = self._started("scheduler", "--port", "0", "--host", "127.0.0.1")
        self.address = self._said(self.scheduler, r"Scheduler at:\s+(tcp://\S+)")
        self.workers = [
            self._started("worker", self.address, "--nthreads", "1", "--no-nanny")
            for _ in range(workers)
        ]
        for worker in self.workers:
            self._said(worker, r"Registered to:\s+(\S+)")

    def _started(self, kind: str, *arguments: str) -> subprocess.Popen[str]:
        command = sys.executable, "-m", f"distributed.cli.dask_{kind}", *arguments
        found = start(
            *(*command, "--no-dashboard"),
            env=os.environ | {"PYTHONPATH": "."},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        self.processes.append(found)
        return found

    @staticmethod
    def _said(process: subprocess.Popen[str], pattern: str) -> str:
        assert process.stdout is not None
        lines = []
        for line in process.stdout:
            lines.append(line)
            if found := re.search(pattern, line):
                return found[1]
        raise AssertionError("".join(lines))

    def stop(self) -> None:
        for process in self.processes:
            end(process)
            process.communicate()
