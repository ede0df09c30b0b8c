"""Long work of a request that is cut into blocks: over processes of its own, or over the cluster.

Blocks are numbered, and their results keep this order, so that bits do not hang on the cut.
"""

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from threading import Thread
from typing import Any

from app.cluster import Block, Cut, Lost, on_cluster
from app.problems import unavailable


def _end_with_owner() -> None:
    """End this process once its owner has ended, even within a block."""
    owner = parent_process()
    assert owner is not None

    def end() -> None:
        owner.join()
        os._exit(1)

    Thread(target=end, daemon=True).start()


def in_processes(count: int) -> Cut:
    """Function that calculates blocks in processes, which are copies of this one; a problem if one
    is stopped from outside.
    """

    def mapped(block: Block, blocks: Sequence[Any]) -> Iterator[Any]:
        most = min(count, len(blocks))
        if most < 2:
            yield from map(block, blocks)
            return
        with ProcessPoolExecutor(most, get_context("fork"), _end_with_owner) as pool:
            try:
                yield from pool.map(block, blocks)
            except BrokenProcessPool:
                raise unavailable("A process of the calculation was stopped") from None

    return mapped


def over_all(address: str, processes: int) -> Cut:
    """Function that calculates blocks on the cluster at an address, if there is one; otherwise, and
    if it is lost, in processes, 0 for one to a processor.
    """
    here = in_processes(processes or len(os.sched_getaffinity(0)))

    def lost(_: Lost) -> Cut:
        return here

    return on_cluster(address, lost, least=1) if address else here
