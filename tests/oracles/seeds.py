"""How many random cases are tried: few in `make test`, many in `make accuracy`."""

import os

TIMES = int(os.environ.get("TIMES_AS_MANY_CASES", "1"))


def seeds(few: int) -> range:
    """Seeds of random cases: so many in `make test`."""
    return range(few * TIMES)
