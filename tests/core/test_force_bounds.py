"""Bounds of the force over stretches against what dense samples of the stretch show."""

import math
import random
from itertools import pairwise

import pytest

from core.output.driving_set import segments
from core.output.force_bounds import Look, least_total, most_summits
from core.output.force_laws import force_law
from core.output.mechanism import Mechanism
from tests.oracles.seeds import seeds


def stretches(seed: int) -> tuple[float, list[list[Look]]]:
    """A random exponent, and looks along random stretches of the segments of a random design."""
    r = random.Random(seed)
    angles = tuple(r.uniform(0, 2 * math.pi) for _ in range(r.randint(1, 4)))
    mechanism = Mechanism(pins=r.randint(3, 8), crank_angles=angles, ratio=20.0)
    exponent = r.choice([1e-6, 0.3, 0.9, 1.1, 1.5, 3.0, 4.09, 30.0])
    parts = list(segments(mechanism.phases))
    law = force_law(parts=parts, exponent=exponent)
    found = []
    for index, part in enumerate(parts):
        low, high = (math.tan(2 * math.pi * place) for place in (part.low, part.high))
        start, stop = sorted(r.uniform(low, high) for _ in range(2))
        places = [start + (stop - start) * i / 200 for i in range(201)]
        found.append([law.look(index, place) for place in places])
    return exponent, found


@pytest.mark.parametrize("seed", seeds(12))
def test_bounds_hold_all_along(seed: int) -> None:
    exponent, found = stretches(seed)
    for looks in found:
        left, right = looks[0], looks[-1]
        least = least_total(left, right, exponent)
        assert least <= min(look.total for look in looks) * (1 + 1e-12)
        highest = max(look.force for look in looks)
        ends = max(left.force, right.force)
        # An inner summit above what is held for the highest may not be passed over.
        if highest > ends * (1 + 1e-9):
            assert most_summits(left, right, exponent, ends, least) > 0
        # Where one summit is promised there is no second one, as where one has parted in two.
        turns = sum(a.slope > 0 >= b.slope for a, b in pairwise(looks))
        if most_summits(left, right, exponent, 0.0, least) == 1:
            assert turns <= 1


def test_a_summit_that_parts_in_two_is_not_taken_for_one() -> None:
    parts = list(segments(Mechanism(pins=5, crank_angles=(0.3,), ratio=20.0).phases))
    law = force_law(parts=parts, exponent=4.088)
    parted = 0
    for index, part in enumerate(parts):
        low, high = (math.tan(2 * math.pi * place) for place in (part.low, part.high))
        looks = [law.look(index, low + (high - low) * i / 2000) for i in range(2001)]
        if sum(a.slope > 0 >= b.slope for a, b in pairwise(looks)) > 1:
            parted += 1
            least = least_total(looks[0], looks[-1], 4.088)
            assert most_summits(looks[0], looks[-1], 4.088, 0.0, least) == 2
    assert parted
