"""Check of the largest stress of pins over the turn by dense scans of random pins.

The ideal forces of these pins have summits that are hard to tell apart (`tests.inputs.pins`). A
scan of the turn, the pin and all directions, which shares nothing with the search
(`tests.oracles.pin_scan`), judges each number of their strength: a number is missed if the scan
finds more, by more than the stated error. A scan that ends below says nothing. `make accuracy`
writes the table to docs/accuracy.md; the number may be given: `python -m benchmarks.pins 100`.
"""

import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from benchmarks.options import options
from core.output.pin_strength import PinStrength
from tests.inputs.loads import pin_strength
from tests.inputs.pins import pin_design, solved
from tests.oracles.pin_scan import pin_extremes

PINS = 1334

REPORT = Path(__file__).parent.parent / "docs" / "accuracy.md"
TITLE = "\n## Largest stresses of pins\n"
NEXT = "\n## Peaks over the turn\n"
HEAD = """
Made by `benchmarks/pins.py`: random pins under ideal forces, most with cranks nearly even, so
that many summits over the turn are nearly as high, beside dense scans of turn, sections and
directions. Missed is what a scan finds beyond the stated error; relative:

| number | pins | missed | most below the scan |
|---|---|---|---|
"""
NAMES = (
    "peak_force",
    "peak_moment",
    "peak_shear_force",
    "peak_equivalent_stress",
    "deflection",
    "slope",
    "safety_factor",
)


@dataclass(frozen=True, slots=True)
class Compared:
    """Numbers of a pin below those of a scan, relative, on the unsafe side; stated error."""

    seed: int
    below: dict[str, float]
    stated: float

    def missed(self, name: str) -> bool:
        """True if a number lies further below than is stated."""
        return self.below[name] > self.stated


def number(found: PinStrength, name: str) -> float:
    """Number of the strength by its name."""
    parts = found.deflection, found.fatigue, found
    return float(next(getattr(part, name) for part in parts if hasattr(part, name)))


def compared(seed: int) -> Compared:
    """Comparison of one pin with its scan."""
    design = pin_design(seed)
    found, below = pin_strength(**design), {}
    for name, exact in pin_extremes(design).items():
        value = number(found, name)
        off = float((exact - value) / exact)
        below[name] = -off if name == "safety_factor" else off
    if design["span"] is not None:
        # between supports a slope may be next to nothing
        places = design["satellite_positions"]
        near = max(min(z, design["span"] - z) for z in places)
        below["slope"] *= min(1.0, found.deflection.slope * near / found.deflection.deflection)
    return Compared(seed, below, found.accuracy.relative_error)


def row(name: str, found: list[Compared]) -> str:
    """Row of the table."""
    return (
        f"| {name} | {len(found)} | {sum(each.missed(name) for each in found)} | "
        f"{max(each.below[name] for each in found):.1e} |\n"
    )


def main(pins: int, smallest: bool = False) -> int:
    """Compare all pins and print the result; 1 if any number was missed."""
    start = time.perf_counter()
    seeds = [seed for seed in range(pins * 3 // 2) if not solved(seed)]
    with ProcessPoolExecutor(2) as pool:
        found = list(pool.map(compared, seeds))
    for each in found:
        if wrong := [name for name in NAMES if each.missed(name)]:
            print(f"BELOW pin {each.seed}: {wrong}, stated {each.stated:.1e}")
    table = "".join(row(name, found) for name in NAMES)
    print(table)
    if not smallest:
        before, following, after = REPORT.read_text(encoding="utf-8").partition(NEXT)
        text = before.split(TITLE)[0] + TITLE + HEAD + table + following + after
        REPORT.write_text(text, encoding="utf-8")
    missed = sum(each.missed(name) for each in found for name in NAMES)
    print(f"{missed} numbers missed")
    print(f"{time.perf_counter() - start:.0f} s")
    return 1 if missed else 0


if __name__ == "__main__":
    asked = options(__doc__, pins=PINS)
    sys.exit(main(3, smallest=True) if asked.smallest else main(asked.pins))
