"""Studies on a Dask cluster whose scheduler the operator names; without one nothing of Dask is
installed, imported or started.

A task is some blocks of pieces, calculated by the same function as here: what travels is the
study, its draws are made there, and the bits are the same however many workers there are.
"""

import hashlib
import logging
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from app.compiled import load
from core.errors import CalculationError
from core.tolerance.study import Block, Mapped, Pieces
from core.tolerance.tolerances import Drawn

LOG = logging.getLogger("khv.cluster")

PIECES = 2048
"""Pieces of a task at least: a tenth of a second and more."""

CONNECT_S = 3
"""Time after which a scheduler that does not answer counts as lost: less than a study may take."""

LOOK_S = 1
"""How often a study that waits for its workers looks whether there are any."""

CORE = Path(__file__).parent.parent / "core"


class Lost(Exception):
    """The cluster cannot be reached, has no workers, or runs another version; why, is its text."""


@cache
def version() -> str:
    """What the numbers depend on: the sources of the core that this process has."""
    found = hashlib.sha256()
    for path in sorted(CORE.rglob("*.py")):
        found.update(path.relative_to(CORE).as_posix().encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


@cache
def _prepared() -> str:
    """Version of these sources, once the compiled engine is there."""
    load()
    return version()


def task(block: Block, blocks: Sequence[Drawn]) -> tuple[str, list[Pieces]]:
    """Some blocks, at a worker, and by which sources."""
    return _prepared(), [block(each) for each in blocks]


@cache
def _client(address: str) -> Any:
    """A connection to the scheduler, one a process."""
    import dask
    from distributed import Client

    dask.config.set({"distributed.comm.timeouts.connect": f"{CONNECT_S}s"})
    client: Any = Client(  # type: ignore[no-untyped-call]
        address, timeout=CONNECT_S, set_as_default=False
    )
    return client


def _result(client: Any, future: Any) -> Any:
    """Result of a task, waited for as long as the cluster has workers."""
    while True:
        try:
            return future.result(timeout=LOOK_S)
        except TimeoutError:
            client.wait_for_workers(1, timeout=LOOK_S)


def _there(address: str, block: Block, blocks: Sequence[Drawn]) -> Iterator[Pieces]:
    """Blocks at the workers, in their order.

    Raises
    ------
    Lost
        If they cannot be, or not any more.
    """
    many = -(-PIECES // len(blocks[0]))
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
    except Exception as error:  # whatever Dask and the network raise
        _client.cache_clear()
        raise Lost(f"{type(error).__name__}: {error}") from error


def on_cluster(address: str, lost: Callable[[Lost], Mapped]) -> Mapped:
    """Where blocks are calculated on a cluster.

    Parameters
    ----------
    address : str
        Of its scheduler.
    lost : callable
        Called when it is lost: says where they are calculated that it does not, or raises.

    Returns
    -------
    callable
    """
    elsewhere: Mapped | None = None  # once the cluster is lost, which is not waited for again

    def mapped(block: Block, blocks: Sequence[Drawn]) -> Iterator[Pieces]:
        nonlocal elsewhere
        done = 0
        if not elsewhere:
            try:
                for results in _there(address, block, blocks):
                    done += 1
                    yield results
                return
            except Lost as why:
                LOG.warning("the cluster is lost: %s", why)
                elsewhere = lost(why)
        yield from elsewhere(block, blocks[done:])

    return mapped
