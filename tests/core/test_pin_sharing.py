"""Pins under several cases of load: what is told is the worst of them, each number for itself."""

import numpy as np
import pytest

from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam
from core.output.pin_fatigue import FatigueStrength
from core.output.sampled_turn import SampledTurn
from core.precision import CONVERGED, EXACT, SAME, SEARCHED
from tests.inputs.loads import pin_strength
from tests.inputs.real_mechanisms import REFERENCE, UNLIKE, made

EQUAL = 10000 / 3
"""N: T/R over the sum of cos^2, which is 3/2 a satellite."""


@pytest.mark.parametrize("places", [(5e-6, 2e-5), (0.06 - 2e-5, 0.06 - 5e-6)])
def test_beside_a_support_the_deflection_is_known_less(places: tuple[float, float]) -> None:
    """If all satellites are near a support, the deflection is a difference of parts larger by the
    cube of 3000.
    """
    thin = REFERENCE | {"contact_length": 1e-5, "support": "supported", "span": 0.06}
    errors = [
        pin_strength(**thin | {"satellite_positions": each}).accuracy.relative_error
        for each in (places, (0.03, 0.04), tuple(sorted((0.03, places[0]))))
    ]
    assert 1e-16 * 3000**3 < errors[0] < 1e-15 * 3000**3
    assert errors[1] == pytest.approx(SEARCHED, rel=SEARCHED)
    assert errors[2] == pytest.approx(errors[1], rel=0.1)


def test_the_locus_of_the_root_over_a_turn_of_the_wave() -> None:
    """Only where asked; at the root of the reference design two circles, of F0*z."""
    assert pin_strength(**REFERENCE).locus is None
    locus = pin_strength(**REFERENCE, locus=True).locus
    assert locus.crank_angle[0] == pytest.approx(0, abs=1e-12)
    assert locus.crank_angle[-1] == pytest.approx(2 * np.pi / 1.05, rel=SAME)
    # half a turn of the wave each satellite, F = F0*cos(driving angle)
    wave = locus.crank_angle * 1.05
    inside = np.abs(np.sin(wave)) > 1e-9
    arm = np.where(np.sin(wave) > 0, 0.037, 0.015)
    moment = np.hypot(locus.tangential, locus.radial)
    assert (moment - EQUAL * arm * np.abs(np.sin(wave)))[inside] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("factor", [0.01, 100.0])
def test_the_worst_case_is_the_same_at_any_torque(factor: float) -> None:
    """By Goodman all is linear."""
    cranks = tuple(np.radians((0, 180, 60)).tolist())
    design = REFERENCE | {
        "mechanism": Mechanism(pins=3, crank_angles=cranks, ratio=20.0),
        "satellite_positions": (0.015, 0.037, 0.059),
    }
    one, other = (
        pin_strength(**design | {"output_torque": 500.0 * each}) for each in (1.0, factor)
    )
    assert other.fatigue.safety_factor == pytest.approx(
        one.fatigue.safety_factor / factor, rel=EXACT
    )
    assert other.peak_equivalent_stress == pytest.approx(factor * one.peak_equivalent_stress)


def test_the_peak_torque_bears_on_the_worst_pin() -> None:
    """Pins that differ have the results of that design under the peak torque itself."""
    real = made(UNLIKE)
    design = REFERENCE | {"mechanism": UNLIKE.mechanism, "made": real}
    found = pin_strength(**design, peak_torque=1000.0)
    again = pin_strength(**design | {"output_torque": 1000.0})
    assert found.static_safety_factor == pytest.approx(again.static_safety_factor, rel=CONVERGED)
    plain = pin_strength(**design)
    assert found.static_safety_factor < plain.static_safety_factor
    assert found.peak_equivalent_stress == plain.peak_equivalent_stress


@pytest.mark.parametrize("support", ["supported", "fixed"])
def test_the_worst_section_of_pins_made_unlike(support: str) -> None:
    """All samples of all pins at many sections."""
    real, z = made(UNLIKE), np.array([0.015, 0.037])
    held = {"support": support, "span": 0.052}
    design = REFERENCE | {"mechanism": UNLIKE.mechanism, "made": real} | held
    found = pin_strength(**design)
    beam = PinBeam.round(
        diameter=0.016, contact_length=0.02, youngs_modulus=210e9, poissons_ratio=0.3, **held
    )
    x = np.linspace(0, 0.052, 261)[:, None]
    forces = real(500.0).on_pins.reshape(2, -1)
    moments = np.abs(beam.moment(x, z) @ forces).max(axis=1)
    assert moments.max() <= found.peak_moment * (1 + 1e-12)
    assert found.peak_moment == pytest.approx(moments.max(), rel=1e-4)
    assert found.peak_moment_position == pytest.approx(x[moments.argmax(), 0], abs=3e-4)
    shear = np.abs(beam.shear(x, z) @ forces).max()
    assert found.peak_shear_force == pytest.approx(shear, rel=SAME)
    bent = found.peak_moment * 32 / (np.pi * 0.016**3)
    assert found.peak_equivalent_stress >= bent * (1 - 1e-5)


def loaded_one_by_one(forces: np.ndarray) -> SampledTurn:
    """Each satellite once presses a pin alone; then none does."""
    return SampledTurn(
        wave=np.array([0.0, 2.0, 4.0]),
        on_pins=np.column_stack((np.diag(forces), np.zeros(2)))[:, None] + 0j,
        on_satellites=np.zeros((2, 3), complex),
        total=np.append(forces, 0.0),
        couple=np.zeros((2, 3)),
        crank_angles=(0.0, np.pi),
        error=1e-13,
        evaluations=3,
        unlike=1,
    )


@pytest.mark.parametrize(("degrees", "lower"), [((32.5, 90), 1), ((30, 92.5), 0)])
def test_of_two_directions_that_are_nearly_alike_the_worse_one(
    degrees: tuple[float, float], lower: int
) -> None:
    """The worse one lies half way between directions that are looked at, each 5 degrees."""
    z = np.array([0.015, 0.037])
    forces = 50 / z * np.exp(1j * np.radians(degrees))
    forces[lower] *= 1 - 5e-5
    turn = loaded_one_by_one(forces)
    found = pin_strength(**REFERENCE | {"made": lambda torque: turn}).fatigue
    stress = 50 * 32 / (np.pi * 0.016**3)
    assert found.max_stress == pytest.approx(stress, rel=EXACT)
    assert found.safety_factor == pytest.approx(2 / (stress / 300e6 + stress / 1000e6), rel=EXACT)
    assert np.degrees(found.direction) == pytest.approx(degrees[1 - lower], abs=4e-3)


@pytest.mark.parametrize(("places", "lower"), [((52.5, 20), 1), ((52, 19.5), 0)])
def test_of_two_tops_that_are_nearly_alike_the_higher_one(
    places: tuple[float, float], lower: int
) -> None:
    """A millionth apart, the higher one half way between places that are looked at, 72nds of a
    load's length. Under a load that starts at a the moment is a parabola with its top at the part
    ``s = (L - z)/L`` of its length: ``M = F*(a*s + b*s^2/2)``.
    """
    span, length = 0.048, 0.02
    s = np.array(places) / 72
    z = span * (1 - s)
    force = 1000 / ((z - length / 2) * s + length * s**2 / 2)
    force[lower] *= 1 - 1e-6
    turn = loaded_one_by_one(force)
    held = {"satellite_positions": tuple(z.tolist()), "support": "supported", "span": span}
    found = pin_strength(**REFERENCE | held, made=lambda torque: turn)
    assert found.peak_moment == pytest.approx(1000, rel=EXACT)


@pytest.mark.parametrize("criterion", ["goodman", "fkm_haigh"])
@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_a_pin_loaded_in_the_middle_of_two_supports(criterion: str, exponent: float) -> None:
    """``M = F*(L/4 - b/8)`` there, under the load; at its ends ``F*(L - b)/4`` only."""
    strength = FatigueStrength(300e6, 1000e6, criterion=criterion)
    design = REFERENCE | {"mechanism": Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)}
    design |= {"fatigue": strength, "force_exponent": exponent}
    held = {"satellite_positions": (0.026,), "support": "supported", "span": 0.052}
    found = pin_strength(**design | held)
    arm = 0.052 / 4 - 0.02 / 8
    assert found.peak_moment == pytest.approx(found.peak_force * arm, rel=SAME)
    assert found.peak_moment_position == pytest.approx(0.026, abs=1e-7)
    single = pin_strength(**design | {"satellite_positions": (0.015,)}).fatigue
    assert found.fatigue.safety_factor == pytest.approx(
        single.safety_factor * 0.015 / arm, rel=EXACT
    )
    assert found.fatigue.position == pytest.approx(0.026, abs=1e-7)


@pytest.mark.parametrize("direction", ["driving", "reverse"])
@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_a_pin_loaded_beside_a_support(direction: str, exponent: float) -> None:
    """``M = F*(a*s + b*s^2/2)`` at the part ``s = 1 - z/L`` of a load that starts at a."""
    design = REFERENCE | {"mechanism": Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)}
    design |= {"force_exponent": exponent, "torque_direction": direction}
    held = {"satellite_positions": (0.0113,), "support": "supported", "span": 0.1}
    found = pin_strength(**design | held)
    s = 1 - 0.0113 / 0.1
    arm = 0.0013 * s + 0.02 * s**2 / 2
    assert found.peak_moment == pytest.approx(found.peak_force * arm, rel=SAME)
    assert found.peak_moment_position == pytest.approx(0.0013 + 0.02 * s, abs=1e-7)
    assert found.peak_shear_force == pytest.approx(found.peak_force * s, rel=SAME)


def test_a_stout_pin_is_sheared_at_its_supports() -> None:
    """There ``tau = 4/3*F/2/A`` in the middle of the section is worse than all bending."""
    design = REFERENCE | {"mechanism": Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)}
    held = {"satellite_positions": (0.01,), "support": "supported", "span": 0.02, "diameter": 0.03}
    found = pin_strength(**design | held)
    shear = 4 / 3 * found.peak_force / 2 / (np.pi * 0.03**2 / 4)
    assert found.peak_equivalent_stress == pytest.approx(3**0.5 * shear, rel=SAME)
    assert found.peak_bending_stress < 0.6 * found.peak_equivalent_stress
