"""Are the stated errors true? Random cases, extremes included, against multiple precision.

Writes docs/accuracy.md: for each calculation how often the stated error holds, by how much it
overstates, the largest error measured. Run by `make accuracy`; the number of cases may be given:
`python -m benchmarks.honesty 1000`.
"""

import math
import random
import statistics
import sys
import time
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from mpmath import mp, mpf

from benchmarks.options import options
from core.errors import CalculationError
from core.hertz import hertz
from core.materials import ElasticMaterial
from core.output.cyclogram import cyclogram
from core.output.mechanism import Mechanism
from core.output.peak_force import peak_force
from core.precession.contact_line import contact_lines
from core.precession.meshing_load import meshing_load
from core.precession.rollers import RollerByLength
from core.precession.shaft import ShaftSection
from core.precession.shaft_deflection import shaft_deflection
from core.rollers.roller_strength import roller_strength
from tests.oracles.cases import (
    curve_scale,
    random_crank_angles,
    random_gear,
    random_interval,
    random_mechanism,
    random_position,
    random_rollers,
)
from tests.oracles.crank_planetary import peak
from tests.oracles.hertz import exact_pressure, exact_tangent
from tests.oracles.precession import length_by_z, load_integrals
from tests.oracles.rollers import exact_compliance, exact_forces
from tests.oracles.shaft import exact_deflection

CASES = 10_000
HALF_ULP = 2.0**-54
"""Smaller measured errors count as this: no double can be nearer on average."""

REPORT = Path(__file__).parent.parent / "docs" / "accuracy.md"

Pair = tuple[float, float]


def _blurred(r: random.Random, value: float) -> mpf:
    """A number that rounds to this double: what the user may have meant by it."""
    return mpf(value) * (1 + mpf(r.uniform(-1, 1)) * mpf(2) ** -53)


def _relative(value: float, exact: mpf) -> float:
    return float(abs(mpf(value) - exact) / abs(exact))


def _cyclogram(seed: int) -> Pair:
    """The worst of all angles at which pairs or their number change, dead centres included."""
    r = random.Random(seed)
    pins = r.randint(1, 12)
    mechanism = Mechanism(
        pins=pins,
        crank_angles=random_crank_angles(r, r.randint(1, 6), pins),
        ratio=r.choice([20.0, 10 ** r.uniform(-1, 4)]),
        initial_crank_angle=r.choice([0.0, math.pi, r.uniform(-60, 60)]),
    )
    turns = r.choice([1.0, 10 ** r.uniform(-3, 1)])
    found = cyclogram(mechanism=mechanism, revolutions=turns)
    end, ratio = 2 * mp.pi * mpf(turns), _blurred(r, mechanism.ratio)
    period = 2 * mp.pi * ratio / (1 + ratio)
    start = _blurred(r, mechanism.initial_crank_angle)
    phases = [(_blurred(r, each) + start) / (2 * mp.pi) for each in mechanism.crank_angles]
    shifts = [mpf(pin) / pins for pin in range(pins)]

    def off(angle: float, phase: mpf) -> mpf:
        """How far a pair of this phase is from starting or stopping to drive, over the range."""
        position = 2 * (angle / period + phase)
        return abs(position - mp.nint(position)) / 2 * period / end

    def inside(angle: float) -> bool:
        return 0 < angle < end * (1 - mpf(10) ** -15)

    changes = [*(each.start for each in found.driving_count), *found.dead_centres]
    errors = [
        min(off(angle, phase + shift) for phase in phases for shift in shifts)
        for angle in filter(inside, changes)
    ]
    for pair in found.pairs:
        phase = phases[pair.satellite - 1] + shifts[pair.pin - 1]
        errors += [off(angle, phase) for angle in filter(inside, sum(pair.driving, ()))]
    return found.accuracy.relative_error, float(max(errors, default=mpf(0)))


def _peak_force(seed: int) -> Pair:
    mechanism, exponent = random_mechanism(10**6 + seed, largest_pins=6)
    found = peak_force(mechanism=mechanism, force_exponent=exponent)
    exact = peak(mechanism.pins, mechanism.crank_angles, exponent, screened=True).ratio
    return found.accuracy.relative_error, _relative(found.peak_force_ratio, exact)


def _hertz(seed: int) -> Pair:
    r = random.Random(seed)
    steel = ElasticMaterial(10 ** r.uniform(8, 12), r.choice([0.0, 0.3, 0.4999999]))
    other = (
        steel if r.random() < 0.5 else ElasticMaterial(10 ** r.uniform(8, 12), r.uniform(0, 0.49))
    )
    radius = 10 ** r.uniform(-4, 0)
    hole = radius * (1 + 10 ** r.uniform(-12, 6))
    # The page asks for the pressure of any peak force, those beside dead centres included.
    force, length = 10 ** r.uniform(-12, r.choice([12, 12, 50])), 10 ** r.uniform(-4, 0)
    found = hertz(
        force=force,
        contact_length=length,
        pin_radius=radius,
        hole_radius=hole,
        pin_material=steel,
        hole_material=other,
    )
    moduli = [
        mpf(each.youngs_modulus) / (1 - mpf(each.poissons_ratio) ** 2) for each in (steel, other)
    ]
    modulus = 1 / (1 / moduli[0] + 1 / moduli[1])
    pin, wall = _blurred(r, radius), _blurred(r, hole)
    load, gap = mpf(force) / mpf(length), wall - pin
    exact = mp.sqrt(load * modulus * gap / (mp.pi * wall * pin))
    error = _relative(found.max_pressure, exact)
    if found.conformal_pressure is not None:
        parameter = moduli[0] * gap / load
        b = exact_tangent(parameter)
        factor = exact_pressure(mpf(0), b) / mp.sqrt(parameter / (2 * mp.pi))
        error = max(error, _relative(found.conformal_pressure, exact * factor))
    return found.accuracy.relative_error, error


def _roller_strength(seed: int) -> Pair:
    case = random_rollers(seed)
    r = random.Random(-seed - 1)
    rollers = case["rollers"] = min(case["rollers"], 30)
    delta = r.choice([0.0, rollers / 4, 10 ** r.uniform(-6, 12)])
    stiffness = 1 / exact_compliance(case)
    total = mpf(case["output_torque"]) / (2 * mpf(case["hole_circle_radius"]))
    tolerance = float(delta * total / rollers / stiffness)
    found = roller_strength(**case, position_tolerance=tolerance)
    gaps = [mpf(0)] + [4 * mpf(tolerance)] * (rollers - 1)
    exact = exact_forces(total, stiffness, gaps)[0]
    return found.accuracy.relative_error, max(
        _relative(found.max_force, exact), _relative(found.stiffness, stiffness)
    )


def _contact_line(seed: int) -> Pair:
    r = random.Random(seed)
    gear, angle = random_gear(r), random_position(r)
    start, end = random_interval(r, gear, angle)
    found = contact_lines(**gear, rollers=[RollerByLength(angle, start, end)])
    meant = {name: _blurred(r, value) for name, value in gear.items()}
    exact = length_by_z(
        curve_scale(meant),
        _blurred(r, angle),
        meant["roller_radius"],
        _blurred(r, start),
        _blurred(r, end),
    )
    return found.accuracy.relative_error, _relative(found.total_length, exact)


def _meshing_load(seed: int) -> Pair:
    r = random.Random(seed)
    gear, angle = random_gear(r), random_position(r)
    circle, torque = gear["roller_circle_radius"], 10 ** r.uniform(-3, 4)
    near = circle * 10 ** r.uniform(-6, 0.3)
    start, end = near, near + circle * 10 ** r.uniform(-3, 0.3)
    found = meshing_load(
        **gear, rollers=[RollerByLength(angle, start, end)], torque=torque, reference_z=circle
    )
    meant = {name: _blurred(r, value) for name, value in gear.items()}
    scale, rho = curve_scale(meant), meant["roller_radius"]
    angle_meant, *ends = (_blurred(r, value) for value in (angle, start, end))
    shares = load_integrals(scale, meant["roller_circle_radius"], rho, angle_meant, *ends, circle)
    length = length_by_z(scale, angle_meant, rho, *ends)
    x, y, about_x, about_y, _ = (mpf(torque) / length * share for share in shares)
    size = max(float(mp.hypot(x, y)), torque / circle)
    force = float(mp.hypot(mpf(found.force[0]) - x, mpf(found.force[1]) - y)) / size
    moment = mp.hypot(mpf(found.moment[0]) - about_x, mpf(found.moment[1]) - about_y)
    return found.accuracy.relative_error, max(
        force,
        float(moment) / math.hypot(*found.moment),
        _relative(found.total_length, length),
    )


def _shaft_deflection(seed: int) -> Pair:
    r = random.Random(seed)
    force = (r.uniform(-1, 1) * 10 ** r.uniform(-3, 4), r.uniform(-1, 1) * 10 ** r.uniform(-3, 4))
    moment = (r.uniform(-1, 1) * 10 ** r.uniform(-6, 3), r.uniform(-1, 1) * 10 ** r.uniform(-6, 3))
    modulus = 10 ** r.uniform(9, 12)
    lengths = [r.randint(1, 1000) / 4096 for _ in range(r.randint(1, 4))]
    sections = [(length, 10 ** r.uniform(-4, 0)) for length in lengths]
    distance = sum(lengths) * r.randint(1, 63) / 64
    overhang = sum(lengths) - distance
    found = shaft_deflection(
        force=(*force, 0.0),
        moment=(*moment, 5.0),
        bearing_distance=distance,
        overhang=overhang,
        youngs_modulus=modulus,
        shaft_sections=[ShaftSection(*section) for section in sections],
    )
    exact = []
    for plane in (0, 1):
        lever = (mpf(moment[1]), -mpf(moment[0]))[plane] / mpf(distance)
        exact.append(
            exact_deflection(
                sections, distance, overhang, modulus, lever, mpf(force[plane]) - lever, mpf(0)
            )
        )
    got = found.deflection_C
    size = mp.hypot(*exact)
    error = float(mp.hypot(mpf(got.x) - exact[0], mpf(got.y) - exact[1]) / size)
    return found.accuracy.relative_error, error


CALCULATIONS: dict[str, Callable[[int], Pair]] = {
    "cyclogram": _cyclogram,
    "peak force": _peak_force,
    "Hertz and conformal pressure": _hertz,
    "roller strength": _roller_strength,
    "contact-line length": _contact_line,
    "meshing load": _meshing_load,
    "shaft deflection": _shaft_deflection,
}


@dataclass(frozen=True)
class Verdict:
    """How the stated errors of a calculation held."""

    name: str
    cases: int
    refused: int
    held: float
    overstated: float
    largest: float
    largest_stated: float


def _chunk(task: tuple[str, int, int]) -> list[Pair | None]:
    name, start, stop = task
    calculate = CALCULATIONS[name]
    pairs: list[Pair | None] = []
    for seed in range(start, stop):
        try:
            pairs.append(calculate(seed))
        except CalculationError:
            pairs.append(None)
    return pairs


def judge(name: str, pairs: Iterable[Pair | None]) -> Verdict:
    """Verdict over the pairs of stated and measured error; None is a refusal."""
    every = list(pairs)
    kept = [pair for pair in every if pair is not None]
    assert all(math.isfinite(stated) and math.isfinite(error) for stated, error in kept)
    return Verdict(
        name=name,
        cases=len(kept),
        refused=len(every) - len(kept),
        held=sum(stated >= error for stated, error in kept) / len(kept),
        overstated=statistics.median(stated / max(error, HALF_ULP) for stated, error in kept),
        largest=max(error for _, error in kept),
        largest_stated=max(stated for stated, _ in kept),
    )


def main(cases: int, smallest: bool = False) -> int:
    """Run all, write the report, and return 1 if a statement is not honest."""
    verdicts = []
    with ProcessPoolExecutor(2) as pool:
        for name in CALCULATIONS:
            began, size = time.perf_counter(), max(1, cases // 40)
            tasks = [(name, start, min(start + size, cases)) for start in range(0, cases, size)]
            pairs = [pair for chunk in pool.map(_chunk, tasks) for pair in chunk]
            verdicts.append(judge(name, pairs))
            print(f"{verdicts[-1]} in {time.perf_counter() - began:.0f} s", flush=True)
    lines = [
        "# Are the stated errors true?",
        "",
        "Made by `make accuracy` (`benchmarks/honesty.py`): random cases, extremes included, each",
        "against 40-digit arithmetic by another way. Where the input's own rounding is magnified",
        "(nearly equal radii, angles near a pole, narrow working lengths) the exact value is that",
        "of a random input that rounds to the doubles given. An answer's `relative_error` holds",
        "where it is not below the error measured; errors below 2^-54 count as that.",
        "",
        "| calculation | cases | refused | stated error holds | median stated/measured | largest "
        "error measured | largest stated |",
        "|---|---|---|---|---|---|---|",
    ]
    lines += [
        f"| {v.name} | {v.cases} | {v.refused} | {100 * v.held:.2f} % | {v.overstated:.0f} | "
        f"{v.largest:.1e} | {v.largest_stated:.1e} |"
        for v in verdicts
    ]
    if smallest:
        print("\n".join(lines))
    else:
        REPORT.write_text("\n".join([*lines, ""]), encoding="utf-8")
    honest = all(v.held >= 0.999 and (smallest or v.overstated < 100) for v in verdicts)
    print("honest" if honest else "NOT HONEST")
    return 0 if honest else 1


if __name__ == "__main__":
    asked = options(__doc__, cases=CASES)
    sys.exit(main(10, smallest=True) if asked.smallest else main(asked.cases))
