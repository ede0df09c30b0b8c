"""Check that the default method of ideal calculations is on the front of error against run time.

A method beats the default over random designs of ordinary size if its largest error and its median
run time are both less than half of the default's. Errors below a rounding error count as one. `make
accuracy` runs it and adds its table to docs/numerics.md.
"""

import math
import random
import statistics
import sys
from collections import defaultdict
from collections.abc import Callable

from benchmarks.options import options
from benchmarks.stability import REPORT
from core.output.mechanism import Mechanism
from core.precession.rollers import RollerByLength
from core.precession.shaft import ShaftSection
from core.precision import ROUNDING
from core.work_precision.peaks import peak_force_study
from core.work_precision.precession import Given, contact_line_study, shaft_deflection_study
from core.work_precision.study import WorkPoint, WorkPrecision

DESIGNS = 24
HEADING = "## Is the default on the front?"


def _mechanism(r: random.Random) -> Mechanism:
    satellites = r.choice([2, 3])
    return Mechanism(
        pins=r.randint(3, 12),
        crank_angles=tuple(r.uniform(0, 2 * math.pi) for _ in range(satellites)),
        ratio=r.uniform(8, 60),
    )


def _peak_force(r: random.Random) -> WorkPrecision:
    return peak_force_study(mechanism=_mechanism(r), force_exponent=r.choice([1.0, 10 / 9, 1.5]))


def _gear(r: random.Random) -> tuple[Given, list[RollerByLength]]:
    gear = Given(
        roller_circle_radius=r.uniform(0.03, 0.1),
        roller_radius=r.uniform(0.002, 0.006),
        nutation_angle=math.radians(r.uniform(2, 10)),
        ratio_u12=1 - 1 / r.randint(15, 40),
    )
    rollers = [
        RollerByLength(math.radians(r.uniform(10, 170)), 0.015, r.uniform(0.02, 0.03))
        for _ in range(r.randint(2, 6))
    ]
    return gear, rollers


def _contact_line(r: random.Random) -> WorkPrecision:
    gear, rollers = _gear(r)
    return contact_line_study(gear=gear, rollers=rollers)


def _shaft_deflection(r: random.Random) -> WorkPrecision:
    sections = [ShaftSection(0.02, r.uniform(0.01, 0.03)) for _ in range(r.randint(1, 4))]
    length = sum(section.length for section in sections)
    shaft = {
        "force": (168.0, -337.0, 0.0),
        "moment": (-0.03, -0.07, 10.0),
        "bearing_distance": length / 2,
        "overhang": length / 2,
        "youngs_modulus": 210e9,
        "shaft_sections": sections,
    }
    return shaft_deflection_study(shaft=shaft)


STUDIES: dict[str, Callable[[random.Random], WorkPrecision]] = {
    "peak force": _peak_force,
    "contact-line length": _contact_line,
    "shaft deflection": _shaft_deflection,
}


def _measured(points: list[WorkPoint]) -> tuple[float, float]:
    """Largest error and median run time, us, of a method over the designs."""
    error = max(max(point.relative_error, ROUNDING) for point in points)
    return error, 1e6 * statistics.median(point.run_time for point in points)


def main(designs: int = DESIGNS) -> int:
    """Add the table to the report, or print that of fewer designs; 1 if a default is beaten."""
    lines = [
        HEADING,
        "",
        f"`benchmarks/front.py`, {designs} designs of ordinary size each: largest error and",
        "median run time of the default, and of the fastest method about as accurate (its error",
        "known only here, where the exact value is). A default is off the front where another is",
        "twice as fast and twice as accurate.",
        "",
        "| calculation | default | largest error | run time, us | fastest as accurate | largest "
        "error | run time, us | off the front |",
        "|---|---|---|---|---|---|---|---|",
    ]
    beaten = 0
    for name, study in STUDIES.items():
        found: dict[str, list[WorkPoint]] = defaultdict(list)
        chosen: list[WorkPoint] = []
        for seed in range(designs):
            result = study(random.Random(seed))
            chosen.append(result.chosen)
            for point in result.points:
                if point != result.chosen:
                    found[f"{point.method}, {point.value:g}"].append(point)
        error, cost = _measured(chosen)
        others = {key: _measured(points) for key, points in found.items() if len(points) == designs}
        better = [key for key, (e, t) in others.items() if e < error / 2 and t < cost / 2]
        rivals = {key: (e, t) for key, (e, t) in others.items() if e <= error * 2}
        beaten += bool(better)
        line = f"| {name} | {chosen[0].method} | {error:.1e} | {cost:.0f} | "
        if rivals:
            key, (e, t) = min(rivals.items(), key=lambda item: item[1][1])
            line += f"{key} | {e:.1e} | {t:.0f} | "
        else:
            line += "none | - | - | "
        lines.append(line + ("; ".join(better) or "no") + " |")
    print("\n".join(lines[7:]))
    if designs < DESIGNS:  # too few for run times
        return 0
    before = REPORT.read_text(encoding="utf-8").partition(HEADING)[0].rstrip()
    REPORT.write_text("\n".join([before, "", *lines, ""]), encoding="utf-8")
    return bool(beaten)


if __name__ == "__main__":
    sys.exit(main(1) if options(__doc__).smallest else main())
