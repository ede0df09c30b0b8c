"""Cost of studies and turns of the load sharing, compiled and uncompiled, as ratios in one run.

The unit U is the cosine law in NumPy, 361 angles of 12 pairs. Times are those of the processor,
except for several threads, which are compared with one thread.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from benchmarks.options import options
from core.drive import compiled
from core.hertz import ElasticMaterial
from core.output.elasticity import (
    RIGID_PINS,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PinSupport,
    PowerLaw,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.tolerance.draws import Spread
from core.tolerance.study import Evaluation, Study
from core.tolerance.tolerances import Tolerances

STEEL = ElasticMaterial(210e9, 0.3)
BENT = PinSupport("cantilever", 0.010, (0.008, 0.022), STEEL)
LAWS = {
    "linear, first order": (LinearLaw(1e8), RIGID_PINS, False),
    "linear": (LinearLaw(1e8), RIGID_PINS, True),
    "10/9": (PowerLaw(10 / 9, 1000.0, 1e-5), RIGID_PINS, True),
    "Palmgren, pin": (PalmgrenLaw(), BENT, True),
    "Hertz, pin": (HertzLaw(), BENT, True),
    "1/2, pin": (PowerLaw(0.5, 1000.0, 1e-5), BENT, True),
    "3, pin": (PowerLaw(3.0, 1000.0, 1e-5), BENT, True),
}
TOLERANCES = Tolerances(
    pin_position=1e-5,
    hole_position=2e-5,
    pin_radius=Spread(3e-6, 7.5e-6),
    hole_radius=Spread(0.0, 9e-6),
    eccentricity=Spread(-5e-6, 5e-6),
    disc_phase=Spread(-1.7e-4, 1.7e-4),
)
COLD = """
import time
begun = time.process_time()
from app.compiled import load
from core.tolerance.study import tolerance_study
ready = time.process_time()
load()
print(time.process_time() - ready)
"""
ANGLES = np.linspace(0, 2 * np.pi, 361)[:, None] + np.arange(12) * np.pi / 6


def _cosine_law() -> object:
    cosines = np.maximum(np.cos(ANGLES), 0.0)
    return cosines / (cosines * cosines).sum(axis=1, keepdims=True)


def _units(call: Callable[[], object], repeats: int, clock: Callable[[], float]) -> float:
    """Cost of a call in units U, the median of ratios side by side."""
    ratios = []
    for _ in range(repeats):
        begun = clock()
        for _ in range(50):
            _cosine_law()
        unit = (clock() - begun) / 50
        begun = clock()
        call()
        ratios.append((clock() - begun) / unit)
    return float(np.median(ratios))


def study_of(law: str, samples: int, threads: int = 1, quantity: str = "peak_force") -> Study:
    contact, pin, exact = LAWS[law]
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
        pin_circle_radius=0.040, pin_radius=0.005, eccentricity=0.002, contact_length=0.012,
        clearance=2e-5, law=contact, exact=exact, pin=pin, pin_material=STEEL, hole_material=STEEL,
    )  # fmt: skip
    asked = Evaluation((quantity,), 200.0)
    return Study(real, TOLERANCES, asked, samples=samples, seed=7, threads=threads)


def _per_sample(law: str, samples: int, repeats: int) -> float:
    study = study_of(law, samples)
    pieces = study.pieces()
    return _units(lambda: study.values(pieces), repeats, time.process_time) / samples


def _fresh(place: str) -> float:
    """Processor time until all is compiled, or read from a cache, in a process of its own."""
    environment = os.environ | {"NUMBA_CACHE_DIR": place, "PYTHONPATH": "."}
    command = [sys.executable, "-c", COLD]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return float(done.stdout)


def main(smallest: bool) -> None:
    """Print the tables."""
    repeats, few, many = (1, 2, 64) if smallest else (7, 8, 512)
    laws = [*LAWS][1:2] if smallest else [*LAWS]
    plain = {law: _per_sample(law, few, 1) for law in laws}
    plain_turn = _units(lambda: over_turn(real=study_of("10/9", 1).real, output_torque=200.0), 1,
                        time.process_time)  # fmt: skip
    compiled.load()
    over_turn(real=study_of("10/9", 1).real, output_torque=200.0)
    _per_sample("linear", 2, 1)
    print(f"{'one sample, 60 positions':26s} {'U, as it is':>12s} {'compiled':>9s} {'times':>6s}")
    for law in laws:
        fast = _per_sample(law, many, repeats)
        print(f"{law:26s} {plain[law]:12.0f} {fast:9.2f} {plain[law] / fast:6.0f}")
    turn = _units(lambda: over_turn(real=study_of("10/9", 1).real, output_torque=200.0), repeats,
                  time.process_time)  # fmt: skip
    print(f"{'a turn, 10/9':26s} {plain_turn:12.0f} {turn:9.0f} {plain_turn / turn:6.0f}")
    study = study_of("10/9", many)
    pieces = study.pieces()
    walls = [
        _units(lambda n=n: replace(study, threads=n).values(pieces), repeats, time.perf_counter)
        for n in (1, 2)
    ]
    print(f"two threads: {walls[0] / walls[1]:.2f} times one, of {os.cpu_count()} processors")
    draws = _units(pieces.rows, repeats, time.process_time) / many
    print(f"draws: {draws:.3f} U a sample")
    play = study_of("10/9", many, quantity="backlash_max")
    alone = _units(lambda: play.values(pieces), repeats, time.process_time) / many
    print(f"backlash alone: {alone:.2f} U a sample")
    if smallest:
        print("compiling is not timed")
        return
    with tempfile.TemporaryDirectory() as place:
        cold, cached = _fresh(place), _fresh(place)
    print(f"compiling: {cold:.1f} s of a processor, from the cache {cached:.1f} s")


if __name__ == "__main__":
    main(options(__doc__).smallest)
