"""What the calculations cost, as ratios in one run: machines differ, ratios much less.

The unit is one call of `hertz`, plain arithmetic of a dozen operations; for arrays of designs the
ratio is how many times faster than sampling 361 angles they are, a design.
"""

import math
import timeit
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from core.crank_planetary import contact_force
from core.cyclogram import cyclogram
from core.designs.hertz import Solids, hertz_contacts
from core.designs.peak_force import peak_forces
from core.designs.roller_strength import roller_strengths
from core.hertz import hertz
from core.materials import ElasticMaterial
from core.mechanism import Mechanism
from core.peak_force import peak_force
from core.precession.contact_line import contact_lines
from core.precession.rollers import RollerByLength
from core.roller_strength import roller_strength

STEEL = ElasticMaterial(210e9, 0.3)


def _mechanism(spacing: float = math.pi) -> Mechanism:
    return Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0, crank_spacing=spacing)


def _hertz() -> object:
    return hertz(
        force=1e3, contact_length=0.02, pin_radius=0.008, hole_radius=0.01,
        pin_material=STEEL, hole_material=STEEL,
    )  # fmt: skip


def _rollers() -> object:
    return roller_strength(
        output_torque=210.0, hole_circle_radius=0.03, rollers=4, cylinder_length=0.02,
        sphere_width=0.008, sphere_diameter=0.015, diameter=0.01, friction_coefficient=0.16,
        youngs_modulus=210e9, poissons_ratio=0.3, position_tolerance=2e-6,
    )  # fmt: skip


def _line() -> object:
    return contact_lines(
        roller_circle_radius=0.05, roller_radius=0.004, nutation_angle=0.105, ratio_u12=0.96,
        rollers=[RollerByLength(0.5, 0.015, 0.025)],
    )  # fmt: skip


CALLS: dict[str, Callable[[], object]] = {
    "hertz": _hertz,
    "cyclogram": lambda: cyclogram(mechanism=_mechanism()),
    "peak, evenly spaced": lambda: peak_force(mechanism=_mechanism()),
    "peak, v = 1": lambda: peak_force(mechanism=_mechanism(math.pi / 2)),
    "peak, v = 1.1": lambda: peak_force(mechanism=_mechanism(math.pi / 2), force_exponent=1.1),
    "peak by 361 samples": lambda: contact_force(
        mechanism=_mechanism(), output_torque=1.0, pin_circle_radius=1.0, curve_samples=361
    ).curves.force.max(),  # type: ignore[union-attr]
    "roller strength": _rollers,
    "contact line": _line,
}


DESIGNS = 100_000


def _arrays() -> dict[str, Callable[[], object]]:
    """Calls for arrays of designs: random cranks of K = 2, N = 3; contacts; four rollers."""
    random = np.random.default_rng(1)
    one = np.ones(DESIGNS)
    cranks = random.uniform(0, 2 * math.pi, (DESIGNS, 2))
    steel = Solids(210e9 * one, 0.3 * one, 1.5e9 * one)

    def peaks(exponent: float) -> Callable[[], object]:
        return lambda: peak_forces(
            pins=3, crank_angles=cranks, ratio=20 * one, force_exponent=exponent * one,
            initial_crank_angle=0 * one,
        )  # fmt: skip

    return {
        "peaks by 361 samples": lambda: _sampled(cranks),
        "peaks, v = 1": peaks(1.0),
        "peaks, v = 1.1": peaks(1.1),
        "contacts": lambda: hertz_contacts(
            force=random.uniform(1, 1e4, DESIGNS), contact_length=0.02 * one,
            pin_radius=0.008 * one, hole_radius=0.01 * one, pin_material=steel,
            hole_material=steel, dynamic_factor=one, distribution_factor=one,
        ),
        "rollers": lambda: roller_strengths(
            output_torque=210.0 * one, hole_circle_radius=0.03 * one, cylinder_length=0.02 * one,
            sphere_width=0.008 * one, sphere_diameter=0.015 * one, diameter=0.01 * one,
            friction_coefficient=0.16 * one, youngs_modulus=210e9 * one, modulus_ratio=2.6 * one,
            stress_concentration=one, gaps=random.uniform(0, 1e-5, (DESIGNS, 4)),
        ),
    }  # fmt: skip


def _sampled(cranks: NDArray[np.float64]) -> NDArray[np.float64]:
    """Peaks for v = 1 on 361 angles, as fast as sampling is: pressure angles, no names."""
    wave = np.linspace(0, 2 * math.pi, 361) * 1.05
    pins = 2 * math.pi * np.arange(3) / 3
    peaks = np.empty(len(cranks))
    for first in range(0, len(cranks), 20):
        phase = (cranks[first : first + 20, :, None] + pins).reshape(-1, 6, 1)
        cosines = np.maximum(-np.sin(wave + phase), 0.0)
        sums = (cosines * cosines).sum(axis=1)
        peaks[first : first + 20] = (cosines.max(axis=1) / sums).max(axis=1)
    return peaks


def main() -> None:
    """Print the tables."""
    times = {}
    for name, call in CALLS.items():
        call()
        count = max(1, round(0.02 / max(timeit.timeit(call, number=1), 1e-6)))
        times[name] = float(np.median(timeit.repeat(call, number=count, repeat=7))) / count
    unit = times["hertz"]
    print(f"{'calculation':24s} {'ratio':>8s} {'us':>8s}")
    for name, each in times.items():
        print(f"{name:24s} {each / unit:8.1f} {each * 1e6:8.1f}")
    print(f"\n{'arrays of designs':24s} {'ratio':>8s} {'us each':>8s}")
    arrays = {
        name: min(timeit.repeat(call, number=1, repeat=3)) / DESIGNS
        for name, call in _arrays().items()
    }
    for name, each in arrays.items():
        ratio = arrays["peaks by 361 samples"] / each
        print(f"{name:24s} {ratio:8.1f} {each * 1e6:8.3f}")


if __name__ == "__main__":
    main()
