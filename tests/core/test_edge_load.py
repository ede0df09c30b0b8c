"""The line load at the end of a contact, where its pin slopes, by all angles of a fine grid.

The forces are as printed, the pin is one of finite elements, the approach Hertz's as in the theory.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from core.checks.crank_planetary import crank_check
from core.design.results import Results
from core.hertz import ElasticMaterial
from core.output.edge_load import SlopingContacts
from core.output.elasticity import (
    ContactLaw,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PowerLaw,
    contact_compliance,
)
from core.output.mechanism import Mechanism
from core.output.pin_strength import PinStresses
from core.precision import EXACT, SAME
from tests.inputs.checks import WHOLE, having
from tests.inputs.loads import pin_stresses
from tests.inputs.real_mechanisms import UNLIKE, made
from tests.oracles.checks import PRESSURE, compliance
from tests.oracles.pin import bend

LENGTH, PIN, HOLE, E, NU = 0.02, 0.008, 0.010, 210e9, 0.3
PEAK = 1e4 / 3
GRID = 2 * np.pi * np.arange(72_000) / 72_000


def unit_forces_do(what: str, positions: tuple[float, ...], **held: Any) -> NDArray[Any]:
    """To the pin in the middle of each satellite by that on each, (K, K)."""
    bents = [
        bend(
            support=held.get("support", "cantilever"),
            diameter=0.016,
            contact_length=LENGTH,
            youngs_modulus=E,
            poissons_ratio=NU,
            span=held.get("span"),
            loads=[(other, int(other == z)) for other in positions],
        )
        for z in positions
    ]
    return np.array([[float(getattr(bent, what)[bent.at(z)]) for bent in bents] for z in positions])


def even_force(forces: NDArray[Any], positions: tuple[float, ...], **held: Any) -> NDArray[Any]:
    """Forces of the satellites on pins, (K, ...), to those that would load the edge evenly."""
    slopes = np.tensordot(unit_forces_do("slope", positions, **held), forces, 1)
    size = np.abs(forces)
    felt = np.where(size > 0, size, 1.0)
    steep = np.abs((slopes * forces.conj()).real) / felt * LENGTH / (felt * compliance(felt))
    return size * np.where(steep < 2, 1 + steep / 2, np.sqrt(2 * steep))


def ideal_forces(mechanism: Mechanism, exponent: float) -> NDArray[Any]:
    """On one pin over the turn, N, shape (K, n)."""
    pins = mechanism.pins
    angles = np.array(mechanism.crank_angles)[:, None] + 2 * np.pi * np.arange(pins) / pins
    cosines = np.maximum(np.cos(GRID + angles[..., None]), 0)
    shares = np.where(cosines > 0, cosines**exponent, 0)
    force = 1e4 * shares / (shares * cosines).sum(axis=(0, 1))
    return force[:, 0] * np.exp(1j * (GRID + angles[:, :1]))


def stressed(mechanism: Mechanism, positions: tuple[float, ...], **others: Any) -> PinStresses:
    """Stressed pins as a design requests them."""
    loaded = {"output_torque": 500.0, "pin_circle_radius": 0.05, "diameter": 0.016}
    return pin_stresses(
        mechanism=mechanism,
        **loaded,
        contact_length=LENGTH,
        satellite_positions=positions,
        material=ElasticMaterial(E, NU),
        **others,
    )


TWO = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
THREE = Mechanism.evenly_spaced(pins=5, satellites=3, ratio=20.0)
APART = Mechanism(pins=3, crank_angles=(0.0, math.radians(80)), ratio=20.0)
NEAR = (0.015, 0.037)
CASES: dict[str, tuple[Mechanism, tuple[float, ...], float, dict[str, Any]]] = {
    "far": (TWO, NEAR, 1.0, {}),
    "near": (TWO, (0.015, 0.019), 1.0, {}),
    "three at once": (THREE, (0.015, 0.037, 0.059), 1.0, {}),
    "across each other": (APART, NEAR, 0.5, {}),
    "a power": (THREE, (0.012, 0.014, 0.016), 1.5, {}),
    "supported": (TWO, NEAR, 1.0, {"support": "supported", "span": 0.06}),
    "fixed": (THREE, (0.01, 0.03, 0.05), 1.0, {"support": "fixed", "span": 0.08}),
}


HELD: dict[str, Any] = {"contact_length": LENGTH, "compliance": compliance}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_force_counts_with_the_slope_at_its_angle(case: Any) -> None:
    mechanism, positions, exponent, held = case
    stresses = stressed(mechanism, positions, force_exponent=exponent, **held)
    found = SlopingContacts(stresses.pin, stresses.loads, **HELD).largest()
    by_grid = even_force(ideal_forces(mechanism, exponent), positions, **held).max(axis=1)
    assert by_grid.max() * (1 - 1e-12) <= found.force <= by_grid.max() * (1 + 1e-4)
    assert by_grid[found.satellite - 1] == pytest.approx(by_grid.max(), rel=EXACT)
    assert found.pin is None


@pytest.mark.parametrize(
    ("law", "approach"),
    [
        (LinearLaw(1e8), 4e-5),
        (PowerLaw(1.5, 500.0, 2e-5), 2e-5 * 8 ** (2 / 3)),
        (PalmgrenLaw(), 3.84e-8 * 4000**0.9 / 20**0.8),
        (HertzLaw(), 4000 * compliance(4000.0)),
    ],
)
def test_the_approach_under_4_kN(law: ContactLaw, approach: float) -> None:
    steel = ElasticMaterial(E, NU)
    bodies: dict[str, Any] = {"pin": steel, "hole": steel, "contact_length": LENGTH}
    bodies |= {"pin_radius": PIN, "hole_radius": HOLE}
    found = contact_compliance(law=law, **bodies)
    assert 4000 * found(4000.0) == pytest.approx(approach)
    many = found(np.array([4000.0, 1.0]))
    assert 4000 * many[0] == pytest.approx(approach) and many.shape == (2,)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_deflection_and_slope_are_each_the_largest_of_all_satellites(case: Any) -> None:
    mechanism, positions, exponent, held = case
    stresses = stressed(mechanism, positions, force_exponent=exponent, **held)
    found = stresses.strength().deflection
    assert found is not None
    forces = ideal_forces(mechanism, exponent)
    for what, satellite, value in (
        ("deflection", found.satellite, found.deflection),
        ("slope", found.slope_satellite, found.slope),
    ):
        arms = unit_forces_do(what, positions, **held)
        by_grid = np.abs(np.tensordot(arms, forces, 1)).max(axis=1)
        assert value == pytest.approx(by_grid.max(), rel=10 * EXACT)
        assert by_grid[satellite - 1] == pytest.approx(by_grid.max(), rel=EXACT)


def test_of_pins_made_unlike_the_worst_counts() -> None:
    """All samples of all pins."""
    real = made(UNLIKE)
    stresses = stressed(UNLIKE.mechanism, NEAR, made=real)
    found = SlopingContacts(stresses.pin, stresses.loads, **HELD).largest()
    each = even_force(real(500.0).on_pins, NEAR).max(axis=2)
    satellite, pin = np.unravel_index(each.argmax(), each.shape)
    assert found.force == pytest.approx(each.max(), rel=SAME)
    assert (found.satellite, found.pin) == (satellite + 1, pin + 1)


def test_the_pressure_of_the_reference_design() -> None:
    """Shared equally one satellite at a time loads a pin, the far one with a slope of
    3.4185221273 mrad (F10).
    """
    far = math.sqrt(2 * 3.4185221273e-3 * LENGTH / (PEAK * compliance(PEAK)))
    equal = Results(WHOLE, equal=True)
    assert equal.line_load_factor == pytest.approx(far, rel=EXACT)
    found = crank_check("contact_pressure_hole", equal)
    assert found.value == pytest.approx(PRESSURE * math.sqrt(far), rel=EXACT)
    assert found.at == {"satellite": 2}
    more = Results(having(WHOLE, application_factor=1.25), equal=True)
    steep = math.sqrt(2 * 3.4185221273e-3 * LENGTH / (PEAK * compliance(1.25 * PEAK)))
    assert more.line_load_factor == pytest.approx(steep, rel=EXACT)
    assert crank_check("contact_pressure_hole", more).value == pytest.approx(
        PRESSURE * math.sqrt(1.25 * steep), rel=EXACT
    )


def test_the_place_of_the_pressure_of_pins_made_unlike() -> None:
    """The larger force is in the middle between two supports, where the pin has hardly a slope."""
    between = replace(
        WHOLE.pin, satellite_positions=(0.05, 0.015), diameter=0.03, support="supported", span=0.1
    )  # type: ignore[type-var]
    design = having(
        WHOLE, pins=4, deviations=UNLIKE.deviations, contact_law=UNLIKE.law, pin_radius=0.015,
        hole_radius=0.01703, pin=between, crankshaft=None,
    )  # fmt: skip
    largest = Results(design).judged_forces.place  # type: ignore[union-attr]
    assert (largest["satellite"], largest["pin"]) == (1, 4) and "crank_angle" in largest
    assert Results(design).peak == {"satellite": 2, "pin": 1}
    near = having(design, pin=replace(between, satellite_positions=(0.015, 0.05)))  # type: ignore[type-var]
    largest = Results(near).judged_forces.place  # type: ignore[union-attr]
    assert Results(near).peak == largest and "crank_angle" in largest
