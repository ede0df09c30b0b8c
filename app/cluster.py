"""Studies on a Dask cluster whose scheduler the operator names.

Without a scheduler nothing of Dask is installed, imported or started. A task is some blocks, of
pieces or of a sweep's points, calculated by the function that local processes use: the study is
sent, the worker draws the samples, and results are bit for bit independent of the number of
workers.
"""

import hashlib
import logging
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from app.compiled import load
from core.errors import CalculationError

LOG = logging.getLogger("khv.cluster")

PIECES = 2048
"""Least number of pieces in a task: a tenth of a second and more."""

CONNECT_S = 3
"""Time after which a silent scheduler counts as lost, s; less than a study may take."""

LOOK_S = 1
"""Interval at which a study that waits for workers looks for them, s."""

ROOT = Path(__file__).parent.parent

Block = Callable[[Any], Any]
"""Function that calculates a block; a study's can be pickled."""

Cut = Callable[[Block, Sequence[Any]], Iterator[Any]]
"""Function that calculates blocks and yields their results in their order."""


class Lost(Exception):
    """Loss of the cluster: unreachable, without workers, or of another version."""


@cache
def version() -> str:
    """Hash of the sources in this process, on which the numbers depend."""
    found = hashlib.sha256()
    for path in sorted(each for room in ("app", "core") for each in (ROOT / room).rglob("*.py")):
        found.update(path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


@cache
def _prepared() -> str:
    """Version of the sources, once the compiled engine is loaded."""
    load()
    return version()


def task(block: Block, blocks: Sequence[Any]) -> tuple[str, list[Any]]:
    """Version of a worker's sources, and results of some blocks there."""
    return _prepared(), [block(each) for each in blocks]


@cache
def _client(address: str) -> Any:
    """Connection to the scheduler, one per process."""
    import dask
    from distributed import Client

    dask.config.set({"distributed.comm.timeouts.connect": f"{CONNECT_S}s"})
    client: Any = Client(  # type: ignore[no-untyped-call]
        address, timeout=CONNECT_S, set_as_default=False
    )
    return client


def _result(client: Any, future: Any) -> Any:
    """Result of a task; waits as long as the cluster has workers."""
    while True:
        try:
            return future.result(timeout=LOOK_S)
        except TimeoutError:
            client.wait_for_workers(1, timeout=LOOK_S)


def _there(address: str, block: Block, blocks: Sequence[Any], least: int) -> Iterator[Any]:
    """Results of blocks from the workers, in order; raises `Lost`."""
    many = -(-least // len(blocks[0]))
    tasks = [blocks[first : first + many] for first in range(0, len(blocks), many)]
    try:
        client = _client(address)
        futures = client.map(task, [block] * len(tasks), tasks, pure=False)
        for future in futures:
            theirs, results = _result(client, future)
            if theirs != version():
                raise Lost("its workers run another version")
            yield from results
    except (CalculationError, Lost):
        raise
    except Exception as error:  # Dask and the network raise many kinds
        _client.cache_clear()
        raise Lost(f"{type(error).__name__}: {error}") from error


def on_cluster(address: str, lost: Callable[[Lost], Cut], least: int = PIECES) -> Cut:
    """Function that calculates blocks on the cluster with a scheduler at an address.

    `lost` is called once if the cluster is lost; it returns the function to use instead, or raises.
    A task has at least so many entries of blocks.
    """
    elsewhere: Cut | None = None  # replacement once the cluster is lost

    def mapped(block: Block, blocks: Sequence[Any]) -> Iterator[Any]:
        nonlocal elsewhere
        done = 0
        if not elsewhere:
            try:
                for results in _there(address, block, blocks, least):
                    done += 1
                    yield results
                return
            except Lost as why:
                LOG.warning("the cluster is lost: %s", why)
                elsewhere = lost(why)
        yield from elsewhere(block, blocks[done:])

    return mapped
