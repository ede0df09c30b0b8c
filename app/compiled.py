"""Compiled engine, whose cache is made once per installation.

Run as a module, it makes the cache, as `make run`, `make test` and the image do. Processes for
calculations read the cache at their start. If it is missing or broken, the first process makes it,
and the others wait for it.
"""

import fcntl
import logging

LOG = logging.getLogger("khv.compiled")


def load() -> None:
    """Use the compiled engine from now on: read from its cache, or compiled now, in memory if the
    cache cannot be written; without numba use the interpreted engine.
    """
    from core.drive import compiled

    with open(__file__) as lock:

        def say(text: str) -> None:
            LOG.warning(text)
            fcntl.flock(lock, fcntl.LOCK_EX)

        try:
            compiled.load(say)
        except ImportError:
            LOG.warning("numba is not installed: the load sharing is calculated fifty times slower")


if __name__ == "__main__":
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    load()
