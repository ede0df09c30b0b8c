"""The law of contact of a pin that wraps, against plane elasticity by other ways.

What each harmonic of the pressure does is held against Michell's series solved for the pressure
(`tests.oracles.dissimilar`), what the load as a whole moves against finite elements
(`tests.oracles.rims`), the curve against the equation with eight times as many terms.
"""

import math
from collections.abc import Iterator

import numpy as np
import pytest

from core.conformal import conformal_contact, integral_equation, local_approach, widest_load
from core.hertz import ElasticMaterial, effective_modulus, mismatch
from core.output.conformal_law import (
    ERROR,
    FAR,
    PRESSURE_ERROR,
    approach_over_load,
    conformal_curve,
    conformal_wrap,
    end,
    excess,
    far_approach,
)
from core.output.elasticity import RIGID_PINS, ConformalLaw, PinSupport, contact_compliance
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT
from tests.inputs.classes import force_error
from tests.oracles import dissimilar, rims
from tests.oracles.load_sharing import exact_position
from tests.oracles.seeds import seeds

STEEL, PLA = ElasticMaterial(207e9, 0.3), ElasticMaterial(3.5e9, 0.36)
POM = ElasticMaterial(2.8e9, 0.38)
PAIRS = [(STEEL, PLA), (PLA, STEEL), (STEEL, STEEL), (POM, PLA), (STEEL, ElasticMaterial(1e9, 0.0))]


def drawn(count: int) -> Iterator[tuple[ElasticMaterial, ElasticMaterial]]:
    """Pairs of materials, from alike to as different as can be."""
    for seed in seeds(count):
        r = np.random.default_rng(seed)
        first, second = (
            ElasticMaterial(float(10 ** r.uniform(8.5, 11.5)), float(r.uniform(0, 0.48)))
            for _ in range(2)
        )
        yield first, second


@pytest.mark.parametrize("degrees", [3, 10, 30, 50, 65])
@pytest.mark.parametrize(("pin", "hole"), PAIRS)
def test_harmonics_move_the_pin_as_in_michells_series(
    pin: ElasticMaterial, hole: ElasticMaterial, degrees: float
) -> None:
    alpha, beta = mismatch(first=pin, second=hole)
    half_angle = math.radians(degrees)
    load, _ = dissimilar.contact(half_angle, float(alpha), float(beta))
    moved = dissimilar.approach(half_angle, float(alpha), float(beta)) * 2 / load
    contact = conformal_contact(load_parameter=2 / load, alpha=alpha, beta=beta)
    found = local_approach(contact=contact, alpha=alpha, beta=beta)
    assert found == pytest.approx(moved, rel=4 * dissimilar.ERROR)


@pytest.mark.parametrize(("pin", "hole"), PAIRS)
def test_the_load_as_a_whole_moves_rims_as_in_finite_elements(
    pin: ElasticMaterial, hole: ElasticMaterial
) -> None:
    ours = far_approach(pin=pin, hole=hole)
    around = rims.hole(hole.youngs_modulus, hole.poissons_ratio, FAR)
    within = rims.disc(pin.youngs_modulus, pin.poissons_ratio)
    modulus = effective_modulus(first=pin, second=hole)
    assert ours == pytest.approx(modulus * (around + within), rel=rims.ERROR)


def test_the_stated_error_of_the_curve_is_true() -> None:
    """Against the equation with more terms, over all widths: none is further off."""
    worst = 0.0
    for pin, hole in [*PAIRS, *drawn(20)]:
        alpha, beta = map(float, mismatch(first=pin, second=hole))
        curve = conformal_curve(contact_length=1.0, pin=pin, hole=hole)
        s = np.sin(np.radians([0.05, 0.5, 2.0, 9.0, 17.0, 33.0, 51.0, 64.0, 77.0, 89.0]) / 2)
        fine, coarse = (
            integral_equation(s=s, beta=np.array([beta]), terms=terms) for terms in (128, 64)
        )
        stiffness, mean, _, moved = (
            (one + (one - other) / 15)[0] for one, other in zip(fine[:4], coarse[:4], strict=True)
        )
        parameter = 2 * stiffness - (1 + alpha) * mean
        exact = (moved + (1 + alpha) * mean + far_approach(pin=pin, hole=hole))[parameter > 1e-6]
        found = approach_over_load(load=1 / parameter[parameter > 1e-6], curve=curve)
        worst = max(worst, float(np.abs(found / exact - 1).max()))
    assert ERROR / 1000 < worst < ERROR


@pytest.mark.parametrize(("pin", "hole"), PAIRS)
def test_the_law_of_any_radii_is_that_of_the_contact(
    pin: ElasticMaterial, hole: ElasticMaterial
) -> None:
    """From Michell's series and finite elements to the approach under a force, in metres."""
    alpha, beta = map(float, mismatch(first=pin, second=hole))
    modulus = float(effective_modulus(first=pin, second=hole))
    moved = rims.hole(hole.youngs_modulus, hole.poissons_ratio, 3.0)
    moved += rims.disc(pin.youngs_modulus, pin.poissons_ratio)
    for degrees, radius, larger, length in ((8, 5e-3, 1e-4, 0.01), (40, 0.02, 2e-3, 0.006)):
        load, _ = dissimilar.contact(math.radians(degrees), alpha, beta)
        per_length = load * modulus / 2 * larger
        local = dissimilar.approach(math.radians(degrees), alpha, beta) * larger
        law = contact_compliance(
            law=ConformalLaw(),
            contact_length=length,
            pin_radius=radius,
            hole_radius=radius + larger,
            pin=pin,
            hole=hole,
        )
        force = per_length * length
        expected = local + moved * per_length
        assert law(force) * force == pytest.approx(expected, rel=4 * dissimilar.ERROR)


@pytest.mark.parametrize(("pin", "hole"), [*PAIRS, *drawn(10)])
def test_the_curve_ends_where_the_contact_is_half_of_the_pin(
    pin: ElasticMaterial, hole: ElasticMaterial
) -> None:
    alpha, beta = map(float, mismatch(first=pin, second=hole))
    least = float(widest_load(alpha=alpha, beta=beta))
    last = end(conformal_curve(contact_length=1.0, pin=pin, hole=hole))
    assert last == (math.inf if least <= 0 else pytest.approx(1 / least, rel=EXACT))


def test_the_stated_error_of_pressures_by_their_polynomial_is_true() -> None:
    worst = 0.0
    for pin, hole in [*PAIRS, *drawn(20)]:
        alpha, beta = map(float, mismatch(first=pin, second=hole))
        wrap = conformal_wrap(contact_length=1.0, pin=pin, hole=hole)
        s = np.sin(np.radians([0.5, 5.0, 9.0, 17.0, 33.0, 51.0, 64.0, 77.0, 89.0]) / 2)
        fine, coarse = (
            integral_equation(s=s, beta=np.array([beta]), terms=terms) for terms in (128, 64)
        )
        stiffness, mean, pressure = (
            (one + (one - other) / 15)[0] for one, other in zip(fine[:3], coarse[:3], strict=True)
        )
        parameter = 2 * stiffness - (1 + alpha) * mean
        for each, most in zip(parameter, pressure, strict=True):
            if each > 1e-6:
                found = math.sqrt(excess(load=1 / each, wrap=wrap) * each / math.pi)
                worst = max(worst, abs(found / most - 1))
    assert PRESSURE_ERROR / 1000 < worst < PRESSURE_ERROR


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("bends", [True, False])
def test_forces_of_a_mechanism_are_those_of_false_position(exact: bool, bends: bool) -> None:
    """With pins whose bending is in series, deviations, and holes of several radii."""
    satellites = 1 if bends else 2
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=5, satellites=satellites, ratio=15.0),
        pin_circle_radius=0.025,
        pin_radius=0.004,
        eccentricity=4e-4,
        contact_length=0.008,
        law=ConformalLaw(),
        clearance=5e-5,
        pin_material=STEEL,
        hole_material=PLA,
        pin=PinSupport("cantilever", 0.008, (0.006,), STEEL) if bends else RIGID_PINS,
        deviations=Deviations(pin_radius=(1e-5, -1e-5, 0.0, 2e-5, 0.0)),
        exact=exact,
    )
    found = loaded_position(real=real, crank_angle=0.7, output_torque=15.0)
    expected = exact_position(real, 0.7, 15.0)
    forces = [force for row in found.force for force in row]
    for force, other in zip(forces, expected.force, strict=True):
        assert abs(force - float(other)) <= force_error(found)
    assert found.loaded_pairs >= (1 if bends else 3)
