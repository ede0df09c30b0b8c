"""The law of contact of a pin that wraps: shape, limits, and the mechanism that it balances."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.conformal import conformal_contact, local_approach
from core.errors import ImpossibleMechanism
from core.hertz import ElasticMaterial, effective_modulus, mismatch
from core.output.conformal_law import (
    NO_WRAP,
    Curve,
    approach_over_load,
    conformal_curve,
    end,
    far_approach,
    table_of,
)
from core.output.elasticity import (
    ConformalLaw,
    HertzLaw,
    approach_under,
    contact_compliance,
    usual_law,
)
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.precision import CONVERGED, SAME
from tests.inputs.plain_engine import plain

STEEL, PLA = ElasticMaterial(207e9, 0.3), ElasticMaterial(3.5e9, 0.36)
NEAR_LIMIT = ElasticMaterial(20e9, 0.3)
PAIRS = [(STEEL, PLA), (PLA, STEEL), (STEEL, STEEL), (PLA, PLA)]

PRINTED = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=15.0),
    pin_circle_radius=0.025,
    pin_radius=0.004,
    eccentricity=0.0015,
    contact_length=0.008,
    law=ConformalLaw(),
    clearance=1e-4,
    pin_material=STEEL,
    hole_material=PLA,
    exact=False,
)


def curve_of(pin: ElasticMaterial, hole: ElasticMaterial) -> Curve:
    """For a length of 10 mm."""
    return conformal_curve(contact_length=0.01, pin=pin, hole=hole)


def alone(force: float, a: float, bending: float, curve: Curve) -> float:
    """Approach under a force."""
    under = approach_under(law=ConformalLaw(), curve=curve, force=force, a=a, b=bending)
    return float(under)


def given_over(load: float, curve: Curve) -> tuple[float, float]:
    """Approach over a load, and its derivative, as the engine has them."""
    found: tuple[float, float] = plain.over_width(load, table_of(curve=curve, wrap=NO_WRAP))
    return found


def law(d: float, a: float, bending: float, near: float, curve: Curve) -> tuple[float, float]:
    """Force and stiffness of an approach, as the engine finds them."""
    found: tuple[float, float] = plain.wrapped(
        d, a, bending, near, table_of(curve=curve, wrap=NO_WRAP)
    )
    return found


@pytest.mark.parametrize(("pin", "hole"), PAIRS)
def test_force_grows_steadily_with_the_approach_also_beyond_the_end(
    pin: ElasticMaterial, hole: ElasticMaterial
) -> None:
    """Continuous with its derivative, which grows while the law holds."""
    curve = curve_of(pin, hole)
    a, last = curve.modulus * 1e-4, min(end(curve), 1e3)
    loads = np.concatenate((np.geomspace(1e-12, last, 400), last * np.geomspace(1 + 1e-9, 100, 20)))
    approach = [alone(a * x, a, 0.0, curve) for x in loads]
    stiffness = [law(d, a, 0.0, 0.0, curve)[1] for d in approach]
    assert (np.diff(approach) > 0).all() and (np.diff(stiffness[:380]) > 0).all()
    secants = np.diff(a * loads) / np.diff(approach)
    low, high = np.minimum(stiffness[:-1], stiffness[1:]), np.maximum(stiffness[:-1], stiffness[1:])
    inside = slice(0, 398)
    assert (secants[inside] > low[inside] * (1 - 1e-6)).all()
    assert (secants[inside] < high[inside] * (1 + 1e-6)).all()


@pytest.mark.parametrize("bending", [0.0, 0.4, 30.0])
@pytest.mark.parametrize(("pin", "hole"), PAIRS)
def test_force_and_approach_are_each_others_inverse(
    pin: ElasticMaterial, hole: ElasticMaterial, bending: float
) -> None:
    """With what bends in series, from any force nearby or none."""
    curve = curve_of(pin, hole)
    a = curve.modulus * 2e-4
    for x in (1e-30, 1e-9, 1e-3, 0.1, 1.0, 8.0, 300.0):
        approach = alone(a * x, a, bending, curve)
        bent = a * x * bending / curve.modulus
        contact = alone(a * x, a, 0.0, curve)
        assert approach == pytest.approx(contact + bent, rel=CONVERGED)
        for near in (0.0, a * x * 0.3, a * x * 50):
            force, stiffness = law(approach, a, bending, near, curve)
            assert force == pytest.approx(a * x, rel=CONVERGED)
            secant, tangent = given_over(x, curve)
            assert stiffness == pytest.approx(curve.modulus / (tangent + bending), rel=SAME)
            assert tangent <= secant


def test_narrow_contacts_give_as_two_cylinders_do() -> None:
    """Near Hertz's law, which counts to other depths, and with its growth by the logarithm."""
    size = {"contact_length": 0.01, "pin_radius": 4e-3, "hole_radius": 5.5e-3}
    for pin, hole in PAIRS:
        wraps, flat = (
            contact_compliance(law=each, **size, pin=pin, hole=hole)
            for each in (ConformalLaw(), HertzLaw())
        )
        force = effective_modulus(first=pin, second=hole) * 1.5e-3 * 0.01 * 1e-7
        assert wraps(force) == pytest.approx(flat(force), rel=0.15)
        grown = flat(force / 10) - flat(force)
        assert wraps(force / 10) - wraps(force) == pytest.approx(grown, rel=1e-3)


def test_the_approach_hangs_on_the_load_over_the_difference_of_the_radii_alone() -> None:
    size = {"law": ConformalLaw(), "pin": STEEL, "hole": PLA, "contact_length": 0.01}
    one = contact_compliance(**size, pin_radius=4e-3, hole_radius=4.2e-3)
    other = contact_compliance(**size, pin_radius=9e-3, hole_radius=9.6e-3)
    for force in (1.0, 30.0, 800.0):
        assert other(3 * force) == pytest.approx(one(force), rel=SAME)
    forces = np.array([1.0, 30.0, 800.0])
    assert one(forces).tolist() == pytest.approx([one(each) for each in forces], rel=CONVERGED)


def test_the_usual_law_is_by_the_materials_alone() -> None:
    just = replace(NEAR_LIMIT, youngs_modulus=20e9 * (1 - 1e-12))
    assert usual_law(pin=STEEL, hole=NEAR_LIMIT) == HertzLaw()
    for pin, hole in ((STEEL, just), (just, STEEL), (PLA, PLA)):
        assert usual_law(pin=pin, hole=hole) == ConformalLaw()


@pytest.mark.parametrize("torque", [1e-4, 0.3, 4.0, 12.0])
def test_forces_of_a_printed_mechanism_balance_by_the_exact_contact(torque: float) -> None:
    """Each force at its approach by the contact itself, not its curve; together the torque."""
    real, angle = PRINTED, 0.4
    found = loaded_position(real=real, crank_angle=angle, output_torque=torque)
    larger = real.eccentricity + real.clearance
    modulus = float(effective_modulus(first=STEEL, second=PLA))
    alpha, beta = map(float, mismatch(first=STEEL, second=PLA))
    carried, loaded = 0.0, 0
    psi = real.mechanism.wave_angle(angle)
    for phase, row in zip(real.mechanism.crank_angles, found.force, strict=True):
        for n, force in enumerate(row):
            lever = -real.pin_circle_radius * math.sin(psi + phase + 2 * math.pi * n / 6)
            approach = found.rotation * lever - real.clearance
            assert (force > 0) == (approach > 0)
            if force == 0:
                continue
            line_load = force / real.contact_length
            contact = conformal_contact(
                load_parameter=modulus * larger / line_load, alpha=alpha, beta=beta
            )
            gives = local_approach(contact=contact, alpha=alpha, beta=beta)
            gives += far_approach(pin=STEEL, hole=PLA)
            tolerance = 2e-6 * gives * line_load / modulus + 4e-16
            assert abs(approach - gives * line_load / modulus) < tolerance
            carried, loaded = carried + force * lever, loaded + 1
    assert carried == pytest.approx(torque, rel=SAME)
    assert loaded == found.loaded_pairs >= 2


def test_a_contact_of_more_than_half_of_the_pin_is_refused() -> None:
    """A pin of plastic in steel: half of it is reached under a finite load."""
    wide = replace(PRINTED, pin_material=PLA, hole_material=STEEL, pin_circle_radius=0.5)
    curve = conformal_curve(contact_length=0.008, pin=PLA, hole=STEEL)
    force = curve.modulus * 1.6e-3 * end(curve)
    torque = force * wide.pin_circle_radius
    found = loaded_position(real=wide, crank_angle=0.4, output_torque=0.5 * torque)
    assert max(map(max, found.force)) < force
    with pytest.raises(ImpossibleMechanism, match="as wide"):
        loaded_position(real=wide, crank_angle=0.4, output_torque=20 * torque)


def test_numbers_of_arrays_are_those_of_the_engine() -> None:
    curve = curve_of(STEEL, PLA)
    loads = np.geomspace(1e-20, 1e8, 50)
    one = [given_over(float(each), curve)[0] for each in loads]
    assert approach_over_load(load=loads, curve=curve).tolist() == pytest.approx(one, rel=CONVERGED)


def test_beyond_its_end_the_law_goes_on_as_a_straight_line() -> None:
    curve = curve_of(PLA, STEEL)
    at_end, _ = given_over(end(curve) * (1 + 1e-12), curve)
    for factor in (1.5, 10.0, 1e4):
        secant, tangent = given_over(end(curve) * factor, curve)
        assert secant == tangent == pytest.approx(at_end, rel=SAME)
        load = end(curve) * factor
        assert approach_over_load(load=load, curve=curve) == pytest.approx(secant, rel=CONVERGED)
