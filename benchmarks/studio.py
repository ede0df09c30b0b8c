"""Rate of studies over that of cycloidal-studio, in samples a second on one core, in one run.

The `physics.js` of SHKinsem/cycloidal-studio (MIT) runs under node, from the folder that
`CYCLOIDAL_STUDIO` names. For each sample, eight pins with a clearance of their own at 60 positions,
it solves forces alone, by bisection, with linear contacts in first order. Our samples have the same
sizes and all tolerances drawn; times are those of the processor, the rounds alternate.
"""

import os
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np

from benchmarks.options import options
from benchmarks.sharing import STEEL, TOLERANCES
from core.drive import compiled
from core.output.elasticity import (
    RIGID_PINS,
    ContactLaw,
    HertzLaw,
    LinearLaw,
    Pins,
    PinSupport,
    PowerLaw,
)
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.tolerance.study import Evaluation, Study

BENT = PinSupport("cantilever", 0.006, (0.008,), STEEL)
CASES: dict[str, tuple[ContactLaw, Pins, str, float]] = {
    "linear": (LinearLaw(5e7), RIGID_PINS, "peak_force", 3.5),
    "10/9": (PowerLaw(10 / 9, 1000.0, 1e-5), RIGID_PINS, "peak_force", 2.5),
    "Hertz, bent pins": (HertzLaw(), BENT, "peak_force", 1.2),
    "backlash alone": (LinearLaw(5e7), RIGID_PINS, "backlash_max", 30.0),
}
"""Law, pins, quantity, and wanted ratio to the rate of cycloidal-studio."""

OTHER = """
import {{ windup }} from '{folder}/physics.js';
function sample(random) {{
  const own = Array.from({{ length: 8 }}, () => 0.02 + 0.02 * (random() - 0.5));
  let most = 0;
  for (let i = 0; i < 60; i++) {{
    const phi = 2 * Math.PI * i / 60, arms = new Array(8);
    for (let j = 0; j < 8; j++) arms[j] = 20 * Math.sin(phi - 2 * Math.PI * j / 8);
    for (const force of windup(own, arms, 30).F) if (force > most) most = force;
  }}
  return most;
}}
let sum = 0;
for (let i = 0; i < {samples} / 4; i++) sum += sample(Math.random);
const begun = process.cpuUsage();
for (let i = 0; i < {samples}; i++) sum += sample(Math.random);
const used = process.cpuUsage(begun);
console.log({samples} / (used.user + used.system) * 1e6);
"""


def _other(folder: Path, samples: int) -> float:
    """Samples of cycloidal-studio in a second of the processor."""
    script = OTHER.format(folder=folder.resolve(), samples=samples)
    command = ["node", "--input-type=module", "-e", script]
    return float(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def study(case: str, samples: int) -> Study:
    """Study of these sizes with all tolerances."""
    law, pin, quantity, _ = CASES[case]
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
        pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
        clearance=2e-5, law=law, pin=pin, pin_material=STEEL, hole_material=STEEL,
    )  # fmt: skip
    asked = Evaluation((quantity,), 30.0)
    return Study(real, TOLERANCES, asked, samples=samples, seed=7, threads=1)


def _ours(case: str, samples: int) -> float:
    """Samples of this project in a second of the processor."""
    made = study(case, samples)
    pieces = made.pieces()
    begun = time.process_time()
    made.values(pieces)
    return samples / (time.process_time() - begun)


def main(smallest: bool) -> None:
    """Print the table."""
    samples, rounds = (64, 1) if smallest else (4096, 9)
    compiled.load()
    named = os.environ.get("CYCLOIDAL_STUDIO", "")
    there = bool(named) and (Path(named) / "physics.js").is_file() and shutil.which("node")
    if not there:
        print("cycloidal-studio is absent: CYCLOIDAL_STUDIO names no folder of it, or no node")
    for case in CASES:
        _ours(case, 64)
    rates: dict[str, list[float]] = {case: [] for case in CASES}
    others = []
    for _ in range(rounds):
        others.append(_other(Path(named), samples) if there else np.nan)
        for case, found in rates.items():
            found.append(_ours(case, samples))
    print(f"{'one core, 60 positions a sample':32s} {'times its rate':>14s} {'wanted':>7s}")
    for case, found in rates.items():
        ratio = float(np.median(np.array(found) / np.array(others)))
        print(f"{case:32s} {ratio:14.2f} {CASES[case][3]:7.1f}")
    ours = ", ".join(f"{case} {np.median(found):.0f}" for case, found in rates.items())
    print(f"samples a second: its {np.median(others):.0f}; ours {ours}")


if __name__ == "__main__":
    main(options(__doc__).smallest)
