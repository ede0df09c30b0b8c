"""The engine as it is compiled, whose cache is made once an installation.

Run as a module it makes the cache, as `make run`, `make test` and the image do. Processes for
calculations read it as they start; where there is none, or a broken one, the first of them makes
it, and the others wait for that.
"""

import fcntl
import logging

LOG = logging.getLogger("khv.compiled")


def load() -> None:
    """Calculate with the compiled engine from now on: read from its cache or compiled now, in
    memory where it cannot be written; without numba with the engine as it is.
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
