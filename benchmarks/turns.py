"""Check of the stated errors of extremes over the turn by an independent oracle.

The random mechanisms have deviations, from loose to pressed. Scans by bisection, narrowed about
their highest summits, give the peak force, the largest play, lost motion and transmission error
beside those of `over_turn`. A case is missed if the oracle finds more than a number and its stated
error, or if a stated error exceeds its class. `make accuracy` runs it after the peaks and appends
the table to docs/accuracy.md; cases may be given: `python -m benchmarks.turns 2000`.
"""

import random
import statistics
import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.options import options
from core.drive.compiled import load
from core.errors import ImpossibleMechanism
from core.output.elasticity import LinearLaw, PowerLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import CLASSES
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.turns import Made, largest

REPORT = Path(__file__).parent.parent / "docs" / "accuracy.md"
TITLE = "\n## The turn beside an oracle\n"
HEAD = """
Made by `benchmarks/turns.py`: peak force and angles (play, lost motion, transmission error, over
the lost motion) of random mechanisms with deviations, loose and pressed, beside scans by bisection
that share nothing with them. Missed: where the scan finds more than the number and its stated
error.

| of the turn | cases | missed | most above | stated over measured, median | largest stated |
|---|---|---|---|---|---|
"""
CASES, POSITIONS, SHARE = 600, 6007, 0.03
ROUNDING = 1e-10
"""Relative error of bisection and of differences of lags."""


def design(seed: int) -> tuple[Made, RealMechanism, float]:
    """Random mechanism, as the oracle and as the core take it, and its torque."""
    r = random.Random(seed)
    pins, satellites = r.choice((4, 6, 8, 12, 20, 40)), r.randint(1, 4)
    while pins * satellites > 48:
        satellites -= 1
    radius, e = r.uniform(0.02, 0.2), r.uniform(1e-3, 4e-3)
    clearance = r.choice((0.0, 1e-5, 3e-5, 1e-4))
    size = r.choice((1e-7, 1e-6, 1e-5, 2e-5))
    draw = np.random.default_rng(seed)
    pin = [draw.normal(0, size, pins) for _ in range(3)]
    hole = [draw.normal(0, size, (satellites, pins)) for _ in range(3)]
    turned = draw.normal(0, size / radius, satellites)
    exponent = r.choice((1.0, 1.0, 10 / 9, 1.5))
    stiffness = 1000.0 / 1e-5**exponent
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)
    made = Made(
        pins, mechanism.crank_angles, 20.0, radius, e, clearance, stiffness, exponent,
        *pin, *hole, turned,
    )  # fmt: skip
    law = LinearLaw(stiffness) if exponent == 1.0 else PowerLaw(exponent, 1000.0, 1e-5)
    names = ("pin_radial", "pin_tangential", "pin_radius")
    tables = ("hole_radial", "hole_tangential", "hole_radius")
    real = RealMechanism(
        mechanism=mechanism,
        pin_circle_radius=radius,
        pin_radius=0.005,
        eccentricity=e,
        contact_length=0.012,
        law=law,
        clearance=clearance,
        exact=False,
        deviations=Deviations(
            **{name: tuple(each.tolist()) for name, each in zip(names, pin, strict=True)},
            **{
                name: tuple(map(tuple, each.tolist()))
                for name, each in zip(tables, hole, strict=True)
            },
            disc_phase=tuple(turned.tolist()),
        ),
        pin_material=STEEL,
        hole_material=STEEL,
    )
    return made, real, 10 ** r.uniform(0, 3)


def measured(seed: int) -> dict[str, tuple[float, float]] | None:
    """Stated and true relative errors by quantity; None if the mechanism cannot work."""
    made, real, torque = design(seed)
    try:
        found = over_turn(real=real, output_torque=torque, lost_motion_share=SHARE)
    except ImpossibleMechanism:
        return None
    peak = largest(lambda psi: made.force(psi, torque), POSITIONS)
    lost = largest(lambda psi: made.lost_motion(psi, SHARE * torque), POSITIONS)
    play = largest(made.play, POSITIONS)
    lag = largest(lambda psi: made.lag(psi, torque)[0], POSITIONS)
    less = largest(lambda psi: -made.lag(psi, torque)[0], POSITIONS)
    angles = (
        lost - found.lost_motion,
        play - found.backlash_max,
        lag + less - found.transmission_error,
    )
    return {
        "peak force": (found.accuracy.relative_error, peak / found.peak_force - 1),
        "angles": (CLASSES["sampling_zoomed"], max(angles, key=abs) / lost),
    }


def main(cases: int, smallest: bool = False) -> int:
    """Compare all cases and print what is missed; 1 if anything is."""
    load()
    start, rows, missed = time.perf_counter(), dict[str, list[tuple[float, float]]](), 0
    promised = CLASSES["sampling_zoomed"]
    for seed in range(cases):
        for name, (stated, true) in (measured(seed) or {}).items():
            rows.setdefault(name, []).append((stated, true))
            if true > stated + ROUNDING:
                missed += 1
                print(f"MISSED design {seed}: {name} {true:.2e} above, stated {stated:.2e}")
            if stated > promised:
                missed += 1
                print(f"BEYOND ITS CLASS design {seed}: {name} states {stated:.2e}")
    table = ""
    for name, found in rows.items():
        over = statistics.median(stated / max(abs(true), 2.0**-54) for stated, true in found)
        most = max(true for _, true in found)
        wrong = sum(true > stated + ROUNDING for stated, true in found)
        stated = max(stated for stated, _ in found)
        table += f"| {name} | {len(found)} | {wrong} | {most:.1e} | {over:.2g} | {stated:.1e} |\n"
    print(table)
    if not smallest:
        before = REPORT.read_text(encoding="utf-8").split(TITLE)[0]
        REPORT.write_text(before + TITLE + HEAD + table, encoding="utf-8")
    print(f"{missed} missed in {time.perf_counter() - start:.0f} s")
    return 1 if missed else 0


if __name__ == "__main__":
    asked = options(__doc__, cases=CASES)
    sys.exit(main(4, True) if asked.smallest else main(asked.cases))
