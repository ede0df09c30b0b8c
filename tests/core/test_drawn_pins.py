"""Pins under ideal forces that are drawn, beside dense scans of turn, sections and directions."""

import pytest

from core.precision import SEARCHED
from tests.inputs.loads import pin_strength
from tests.inputs.pins import pin_design, solved
from tests.oracles.pin_scan import pin_extremes
from tests.oracles.seeds import TIMES

SEEDS = [
    seed
    for seed in range(12 if TIMES == 1 else 40)
    if not solved(seed) and pin_design(seed)["mechanism"].pins < 20
]


@pytest.mark.parametrize("seed", SEEDS[: 5 if TIMES == 1 else 20])
def test_all_numbers_of_a_pin_are_those_of_a_dense_scan(seed: int) -> None:
    design = pin_design(seed)
    found = pin_strength(**design)
    parts = found.deflection, found.fatigue, found
    scanned = pin_extremes(design)
    assert len(scanned) == 7
    for name, exact in scanned.items():
        value = next(getattr(part, name) for part in parts if hasattr(part, name))
        assert value == pytest.approx(float(exact), rel=SEARCHED), name
