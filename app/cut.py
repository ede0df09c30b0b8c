"""Long work of a request that is cut into blocks: over processes of its own, or over the cluster.

Blocks are numbered, and their results keep this order, so that bits do not hang on the cut.
"""

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context, parent_process
from threading import Thread
from typing import Any

from app.cluster import Cut, Lost, on_cluster


def _end_with_owner() -> None:
    """End this process once its owner has ended, even within a block."""
    owner = parent_process()
    assert owner is not None

    def end() -> None:
        owner.join()
        os._exit(1)

    Thread(target=end, daemon=True).start()


def in_processes(count: int) -> Cut:
    """Function that calculates blocks in processes, which are copies of this one."""

    def mapped(block: Callable[[Any], Any], blocks: Sequence[Any]) -> Iterator[Any]:
        if min(count, len(blocks)) < 2:
            yield from map(block, blocks)
            return
        most = min(count, len(blocks))
        with ProcessPoolExecutor(most, get_context("fork"), _end_with_owner) as pool:
            yield from pool.map(block, blocks)

    return mapped


def over_all(address: str, processes: int) -> Cut:
    """Function that calculates blocks on the cluster at an address, if there is one; otherwise, and
    if it is lost, in processes, 0 for one to a processor.
    """
    here = in_processes(processes or len(os.sched_getaffinity(0)))

    def lost(_: Lost) -> Cut:
        return here

    return on_cluster(address, lost, least=1) if address else here
