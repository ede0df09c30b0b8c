"""How many random cases are tried: few in `make test`, many in `make accuracy`."""

import os

TIMES = int(os.environ.get("TIMES_AS_MANY_CASES", "1"))


def seeds(few: int, often: int = 0) -> range:
    """Seeds of random cases: so many in `make test`, and in `make accuracy` a multiple of them, or
    of as many as are said to be tried often, where cases take long.
    """
    return range(few if TIMES == 1 else (often or few) * TIMES)
