"""Check of the peak force over the turn by scans of 60,000 positions.

The random mechanisms have clearance, deviations and any law; half have small loads and pins whose
errors nearly use up the clearance, which makes spikes narrower than any grid. Every fifth has
satellites that give, for which a tenth of the positions serve. No position may carry more than the
peak and its stated error. `make accuracy` appends the table to docs/accuracy.md; designs and
positions may be given: `python -m benchmarks.peaks 20 5000`.
"""

import math
import random
import statistics
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path

from benchmarks.options import options
from core.drive.compiled import load
from core.errors import ImpossibleMechanism
from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    ElasticMesh,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PowerLaw,
    SatelliteSupport,
    Shares,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.turn import Turn
from tests.inputs.real_mechanisms import STEEL

DESIGNS, POSITIONS = 250, 60_000

REPORT = Path(__file__).parent.parent / "docs" / "accuracy.md"
TITLE = "\n## Peaks over the turn\n"
HEAD = """
Made by `benchmarks/peaks.py`: the largest force over the turn of random mechanisms with clearance
and deviations, half of them with spikes narrower than any grid, beside scans of the whole turn. A
peak is missed where any position carries more than it and its stated error. Relative to the peak:

| satellites | designs | positions each | peaks missed | highest position above the peak | \
median below | stated, median | stated, largest |
|---|---|---|---|---|---|---|---|
"""
LAWS = (LinearLaw(5e7), LinearLaw(5e8), PowerLaw(1.5, 1000.0, 1e-5), PalmgrenLaw(), HertzLaw())


@dataclass(frozen=True, slots=True)
class Scan:
    """Result of a scan: its highest force less the peak, relative, and the peak's stated error."""

    seed: int
    above: float
    stated: float
    gives: bool
    positions: int

    @property
    def missed(self) -> bool:
        """True if a position carries more than the peak and its error."""
        return self.above > self.stated


def design(seed: int) -> tuple[RealMechanism, float]:
    """Random mechanism and its torque."""
    r = random.Random(seed)
    pins, satellites = r.randint(3, 8), r.randint(1, 3)
    hard = seed % 2 == 1
    clearance = 10 ** r.uniform(-6, -4.3)
    size = clearance * r.choice((0.3, 0.9)) if hard else 1e-5

    def row(count: int) -> tuple[float, ...]:
        return tuple(r.uniform(-size, size) for _ in range(count))

    radial = list(row(pins))
    if hard:  # two pins have next to no clearance left
        for pin in r.sample(range(pins), 2):
            radial[pin] = -clearance * (1 - 10 ** r.uniform(-4, -1))
    support: SatelliteSupport = RIGID_SUPPORT
    if seed % 5 == 0:
        shares = (0.5, 0.3, 0.2)[:satellites]
        support = r.choice(
            (
                CrankSupport(10 ** r.uniform(7.5, 9), clearance / 2),
                ElasticMesh(10 ** r.uniform(4, 6)),
                Shares(tuple(share / sum(shares) for share in shares)),
            )
        )
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0),
        pin_circle_radius=0.040,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        law=r.choice(LAWS),
        clearance=clearance,
        pin_material=STEEL,
        hole_material=STEEL,
        deviations=Deviations(
            pin_radial=tuple(radial),
            hole_tangential=tuple(row(pins) for _ in range(satellites)),
            disc_phase=tuple(each / 0.040 for each in row(satellites)),
        ),
        exact=not support.gives and r.random() < 0.5,
        support=support,
    )
    return real, 10 ** (r.uniform(-3, 1) if hard else r.uniform(1, 2.5))


def scan(seed: int, positions: int) -> Scan | None:
    """Scan of one design; None if the mechanism cannot work."""
    real, torque = design(seed)
    try:
        turn = over_turn(real=real, output_torque=torque)
        places = [2 * math.pi * (k + 0.5) / positions for k in range(positions)]
        made = Turn(real, torque)
        highest = made.values(made.force, places).heights.max()
    except ImpossibleMechanism:
        return None
    above = float(highest) / turn.peak_force - 1
    gives = real.support is not None
    return Scan(seed, above, turn.accuracy.relative_error, gives, positions)


def row(name: str, found: list[Scan]) -> str:
    """Row of the table."""
    above, stated = ([getattr(each, key) for each in found] for key in ("above", "stated"))
    missed = sum(each.missed for each in found)
    return (
        f"| {name} | {len(found)} | {found[0].positions} | {missed} | {max(above):.1e} | "
        f"{-statistics.median(above):.1e} | {statistics.median(stated):.1e} | {max(stated):.1e} |\n"
    )


def main(designs: int, positions: int, smallest: bool = False) -> int:
    """Scan all designs and print the result; 1 if any peak was missed."""
    start, found = time.perf_counter(), []
    with ProcessPoolExecutor(2, initializer=load) as pool:
        for each in pool.map(scan, range(designs), repeat(positions)):
            if each is None:
                continue
            found.append(each)
            if each.missed:
                print(f"ABOVE design {each.seed}: {each.above:.2e}, stated {each.stated:.2e}")
            if len(found) % 20 == 0:
                print(f"{len(found)} in {time.perf_counter() - start:.0f} s", flush=True)
    kinds = {"rigid": False, "giving": True}
    rows = {name: [each for each in found if each.gives is gives] for name, gives in kinds.items()}
    table = "".join(row(name, own) for name, own in rows.items() if own)
    print(table)
    if not smallest:
        before = REPORT.read_text(encoding="utf-8").split(TITLE)[0]
        REPORT.write_text(before + TITLE + HEAD + table, encoding="utf-8")
    missed = sum(each.missed for each in found)
    print(f"{missed} peaks missed in {time.perf_counter() - start:.0f} s")
    return 1 if missed else 0


if __name__ == "__main__":
    asked = options(__doc__, designs=DESIGNS, positions=POSITIONS)
    small = (4, 200, True)
    sys.exit(main(*small) if asked.smallest else main(asked.designs, asked.positions))
