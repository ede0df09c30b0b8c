"""Check of the room of pins in their holes by plain distances: `make accuracy` runs it.

The random mechanisms have misfits from 1 um to 10 mm.
"""

import math
import random
import sys

import numpy as np

from benchmarks.options import options
from tests.inputs.misfits import drawn
from tests.oracles.room import room

TOLERANCE = 3e-8
"""Largest difference of the room, m; the scan of the distances is no finer."""


def misses(mechanisms: int, seed: int = 20261125) -> list[str]:
    """Wrong rooms and wrong windows at one position of each random mechanism, in words."""
    found = []
    for index in range(mechanisms):
        rng = random.Random(seed + index)
        own, sizes = drawn(rng)
        wave = rng.uniform(0, 2 * math.pi)
        (ours,), _ = own.rooms(np.array([wave]))
        known = room(sizes, wave, 1.0)
        (low,), (high,) = own.windows(np.array([wave]))
        if abs(ours - known) > TOLERANCE:
            found.append(f"{index}: room {ours:.9e} m, by distances {known:.9e} m")
        if (low <= high) != (ours >= 0) and abs(ours) > 1e-9:
            found.append(f"{index}: a window of {high - low:.3e} rad, a room of {ours:.3e} m")
    return found


def main(mechanisms: int) -> int:
    """Print every miss and their number; 1 if there is one."""
    found = misses(mechanisms)
    for each in found:
        print(each)
    print(f"fit: {len(found)} misses in {mechanisms} random mechanisms")
    return 1 if found else 0


if __name__ == "__main__":
    asked = options(__doc__, mechanisms=2000)
    sys.exit(main(20 if asked.smallest else asked.mechanisms))
