"""Cost of the calculations, as ratios in one run: machines differ, ratios much less.

The unit is one call of `hertz`, plain arithmetic of a dozen operations.
"""

import itertools
import math
import timeit
from collections.abc import Callable
from typing import Any

import numpy as np

from app.calculations.crank_planetary import solve
from app.calculations.crank_planetary_sections import STRENGTH as STRENGTH_SECTIONS
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import REQUESTS
from benchmarks.options import options
from core.checks.crank_planetary import crank_checks
from core.conformal import conformal_contact
from core.crank.bearing_life import rating_life
from core.crank.ring_mesh import RingMesh
from core.design.contact import Contact
from core.design.document import Design, changed
from core.design.results import Results
from core.design.sections import Load, MechanismSection
from core.fatigue import size_factor, utilisation
from core.fixes.changes import Search
from core.fixes.crank import crank_fixes
from core.hertz import ElasticMaterial, hertz
from core.material_table import MATERIALS
from core.numerics.inverse import solve_for
from core.output.contact_force import contact_force, cyclogram, peak_force
from core.output.losses import BarePins
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, face_load_factor
from core.output.pin_fatigue import FatigueStrength
from core.precession.contact_line import contact_lines
from core.precession.rollers import RollerByLength
from core.rollers.roller_strength import ByPoissonsRatio, PositionTolerance, roller_strength
from tests.inputs.loads import crankshaft, pin_losses, pin_strength, satellite_bearings

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
        youngs_modulus=210e9, shear=ByPoissonsRatio(0.3), spacing=PositionTolerance(2e-6),
    )  # fmt: skip


def _line() -> object:
    return contact_lines(
        roller_circle_radius=0.05, roller_radius=0.004, nutation_angle=0.105, ratio_u12=0.96,
        rollers=[RollerByLength(0.5, 0.015, 0.025)],
    )  # fmt: skip


REF = Design(
    mechanism=MechanismSection(pins=6, satellites=2, ratio=20.0),
    load=Load(output_torque=500.0, pin_circle_radius=0.05),
    contact=Contact(
        contact_length=0.02,
        pin_radius=0.008,
        hole_radius=0.01,
        eccentricity=0.002,
        pin_material=MATERIALS["steel_bearing"].material,
        hole_material=MATERIALS["steel_through_hardened"].material,
    ),
)


def _checks() -> object:
    """All checks of a design; each call solves anew."""
    return crank_checks(Results(REF))


def _fixes() -> object:
    """All six fixes of the governing check."""
    results = Results(changed(REF, {"load.output_torque": 1500.0}))
    search = Search(results, crank_checks(results))
    return crank_fixes(search=search, codes=["contact_pressure_hole"])


MECHANISM = _mechanism()
STRENGTH = FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6)
LOADED = {"mechanism": MECHANISM, "output_torque": 500.0, "pin_circle_radius": 0.05}
CRANKED = LOADED | {"eccentricity": 0.002, "mesh": RingMesh(0.69)}


PARTS = ("pin-strength", "output-efficiency", "satellite-bearing", "crankshaft")
SECTIONS: dict[str, Any] = {}
for part in PARTS:
    for section, fields in REQUESTS[part].items():
        if section not in ("include", "rollers"):
            SECTIONS[section] = SECTIONS.get(section, {}) | fields
CALLED = itertools.count(1)


def _whole(**pin: Any) -> object:
    """Whole design with all sections and checks, from request to answer; each call has another
    mechanism, so that no result is kept.
    """
    off = next(CALLED) * 1e-7
    sections = [name for name in STRENGTH_SECTIONS if name != "rollers"]
    request = SECTIONS | {
        "mechanism": SECTIONS["mechanism"] | {"ratio": 20.0 + off},
        "pin": SECTIONS["pin"] | pin,
        "include": ["checks", "cyclogram", "contact_force", "hertz", *sections],
    }
    return solve(CrankPlanetaryRequest.model_validate(request))


def _losses(radius: Any) -> object:
    return pin_losses(
        **LOADED | {"pin_circle_radius": radius}, input_speed=157.0, output_power=3925.0,
        eccentricity=0.002, pin_radius=0.008, contact_length=0.02, friction_coefficient=0.08,
        rubbing=BarePins(0.01),
    )  # fmt: skip


def _pin(**support: Any) -> object:
    return pin_strength(
        **LOADED, diameter=0.016, contact_length=0.02, satellite_positions=(0.015, 0.037),
        material=STEEL, fatigue=STRENGTH, **support,
    )  # fmt: skip


DESIGNS = 1_000_000


def _algebra(size: Any) -> object:
    """Losses, endurance limit, safety of a cycle, life, slope and edge load, without a search."""
    beam = PinBeam.round(
        support="cantilever", diameter=size, contact_length=0.02, youngs_modulus=210e9,
        poissons_ratio=0.3,
    )  # fmt: skip
    slope = 3e3 * beam.slope(0.037, 0.037)
    face_load_factor(slope=slope, contact_length=0.02, approach=4e-6)
    limit = 0.8 * size_factor(diameter=size) * 500e6
    utilisation(amplitude=150e6, mean=150e6, endurance=limit, tensile_strength=1e9)
    return rating_life(load=1e6 * size, rating=6e4, kind="ball")


def _inverse() -> object:
    return solve_for(function=lambda x: x * x, low=1.0, high=9.0, target=2.0, log=True)


def _conformal(load: Any) -> object:
    """Steel in PLA, from half-planes to no clearance."""
    return conformal_contact(load_parameter=load, alpha=0.965, beta=0.21)


CALLS: dict[str, Callable[[], object]] = {
    "hertz": _hertz,
    "conformal contact": lambda: _conformal(2.0),
    "conformal, a thousand": lambda: _conformal(np.geomspace(0.05, 1e4, 1000)),
    "conformal, 1e5": lambda: _conformal(np.geomspace(0.05, 1e4, 100_000)),
    "cyclogram": lambda: cyclogram(mechanism=_mechanism()),
    "peak, evenly spaced": lambda: peak_force(mechanism=_mechanism()),
    "peak, v = 1": lambda: peak_force(mechanism=_mechanism(math.pi / 2)),
    "peak, v = 1.1": lambda: peak_force(mechanism=_mechanism(math.pi / 2), force_exponent=1.1),
    "peak by 361 samples": lambda: contact_force(
        mechanism=_mechanism(), output_torque=1.0, pin_circle_radius=1.0, curve_samples=361
    ).curves.force.max(),  # type: ignore[union-attr]
    "roller strength": _rollers,
    "contact line": _line,
    "checks of a design": _checks,
    "six fixes": _fixes,
    "whole design, cantilever": _whole,
    "whole design, supported": lambda: _whole(support="supported", span_mm=52.0),
    "whole design, fixed": lambda: _whole(support="fixed", span_mm=52.0),
    "pin strength": _pin,
    "pin strength, fixed": lambda: _pin(support="fixed", span=0.052),
    "satellite bearings": lambda: satellite_bearings(**CRANKED, input_speed=157.0, kind="ball"),
    "crankshaft": lambda: crankshaft(
        **CRANKED, satellite_positions=(0.02, 0.042), bearing_positions=(0.0, 0.062)
    ),
    "pin losses": lambda: _losses(0.05),
    "losses, a million": lambda: _losses(np.linspace(0.05, 0.06, DESIGNS)),
    "closed algebra": lambda: _algebra(0.016),
    "algebra, a million": lambda: _algebra(np.linspace(0.015, 0.02, DESIGNS)),
    "solve x^2": _inverse,
}


def main(smallest: bool) -> None:
    """Print the table."""
    times = {}
    for name, call in CALLS.items():
        call()
        count = 1 if smallest else max(1, round(0.02 / max(timeit.timeit(call, number=1), 1e-6)))
        took = timeit.repeat(call, number=count, repeat=1 if smallest else 7)
        times[name] = float(np.median(took)) / count
    unit = times["hertz"]
    print(f"{'calculation':24s} {'ratio':>8s} {'us':>8s}")
    for name, each in times.items():
        print(f"{name:24s} {each / unit:8.1f} {each * 1e6:8.1f}")


if __name__ == "__main__":
    main(options(__doc__).smallest)
