"""Bored pins: section, shear, wall, held against frames, flexure functions and scans."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.errors import InvalidInput
from core.hertz import ElasticMaterial
from core.output.elasticity import PinSupport, pin_compliance
from core.output.pin_beam import PinBeam, section_stress
from core.output.pin_section import GIVES, UNDER_LOAD, WALL_BORE, PinSection
from core.precision import EXACT
from tests.inputs.checks import WHOLE, check_of, having
from tests.oracles.hollow import cowper, frame_ring, scanned

STEEL = ElasticMaterial(210e9, 0.3, yield_strength=800e6)
FORCE = 1e4 / 3

TUBES = {
    "16/10 at 37": (0.010, 0.037, 122.5221135, 340.7646281, 1.7130145031, 3.589783221e-5,
                    361.9311488, 52.57783580, 361.9311488),
    "16/14 at 37": (0.014, 0.037, 47.12388980, 166.4062359, 1.8429339997, 7.831087781e-5,
                    741.1581224, 141.0537418, 741.1581224),
    "16/12 at 10": (0.012, 0.010, 87.96459430, 274.8893572, 1.7976565657, 3.251979608e-6,
                    121.2609090, 74.77756056, 129.5185342),
}  # fmt: skip
"""Bore and place, m; then area, modulus, shear coefficient, compliance in mm/N, and the stresses by
bending and shear and the equivalent one, MPa, of a pin of 16 mm under 10 kN/3."""


@pytest.mark.parametrize("name", TUBES)
def test_a_bored_pin_bends_as_a_tube(name: str) -> None:
    bore, place, area, modulus, coefficient, compliance, bent, sheared, equivalent = TUBES[name]
    pin = PinSupport("cantilever", 0.016, (place,), STEEL, None, bore)
    section = pin.section
    assert section.area * 1e6 == pytest.approx(area, rel=EXACT)
    assert section.modulus * 1e9 == pytest.approx(modulus, rel=EXACT)
    assert section.shear_coefficient(0.3) == pytest.approx(coefficient, rel=EXACT)
    assert pin_compliance(pin)[0] * 1e3 == pytest.approx(compliance, rel=EXACT)
    bending, mean = FORCE * place / section.modulus, FORCE / section.shear_area
    assert bending / 1e6 == pytest.approx(bent, rel=EXACT)
    assert 4 / 3 * mean / 1e6 == pytest.approx(sheared, rel=EXACT)
    found = section_stress(bending=bending, mean_shear=mean)
    assert found / 1e6 == pytest.approx(equivalent, rel=EXACT)


@pytest.mark.parametrize(
    ("bore", "moment", "stress", "compliance"),
    [(0.010, 258.6267825, 203.6735095, 1.136128576e-6),
     (0.014, 298.4155183, 1873.478440, 4.712322096e-5)],
)  # fmt: skip
def test_the_wall_of_a_bored_pin(
    bore: float, moment: float, stress: float, compliance: float
) -> None:
    section, line = PinSection(0.016, bore), FORCE / 0.020
    middle = (0.016 + bore) / 4
    assert UNDER_LOAD * line * middle == pytest.approx(moment, rel=EXACT)
    assert section.wall_stress(line_load=line) / 1e6 == pytest.approx(stress, rel=EXACT)
    pin = PinSupport("cantilever", 0.016, (0.037,), STEEL, None, bore)
    assert pin.wall_compliance(0.020) * 1e3 == pytest.approx(compliance, rel=EXACT)


def test_the_wall_is_a_ring_held_by_shear() -> None:
    under, _, gives = frame_ring(radius=1.0, rigidity=1.0, elements=1440)
    assert -under == pytest.approx(UNDER_LOAD, rel=2e-5)
    assert gives == pytest.approx(GIVES, rel=1e-4)


@pytest.mark.parametrize("share", [1e-3, 0.2, 0.5, 0.8, 0.95])
@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.5])
def test_the_shear_coefficient_is_that_of_the_flexure_of_a_tube(share: float, ratio: float) -> None:
    solid = 6 * (1 + ratio) / (7 + 6 * ratio)
    wanted = 10 / 9 * solid / cowper(bore=share, poissons_ratio=ratio)
    assert PinSection(2.0, 2 * share).shear_coefficient(ratio) == pytest.approx(wanted, rel=EXACT)


@pytest.mark.parametrize("share", [0.0, 0.3, 0.6, 0.9, 0.97])
@pytest.mark.parametrize("arm", [0.05, 0.3, 0.6, 1.0, 3.0, 20.0])
def test_the_larger_of_two_points_is_the_largest_of_a_tube(share: float, arm: float) -> None:
    """Fibre or axis, whatever bore and arm."""
    section = PinSection(2.0, 2 * share)
    found = section_stress(bending=arm / section.modulus, mean_shear=1 / section.shear_area)
    wanted = scanned(diameter=2.0, bore=2 * share, moment=arm, shear=1.0)
    assert found == pytest.approx(wanted, rel=2e-5)


def test_a_solid_pin_keeps_its_digits() -> None:
    d, length = 0.0137, 0.021
    section = PinSection(d)
    assert section.area == math.pi * d**2 / 4 and section.modulus == math.pi * d**3 / 32
    assert section.shear_area == section.area and section.shear_coefficient(0.29) == 10 / 9
    steel = {"youngs_modulus": 210e9, "poissons_ratio": 0.3}
    solid = {"support": "cantilever", "diameter": d, "contact_length": length, **steel}
    beam = PinBeam.round(**solid)  # type: ignore[arg-type]
    assert beam == PinBeam.round(**solid, bore_diameter=0.0)  # type: ignore[arg-type]
    assert beam.rigidity == 210e9 * (math.pi * d**4 / 64)
    assert beam.shear_area == 10 / 9 * 1.3 * d**2 / 8


def test_the_wall_counts_from_a_bore_of_three_tenths_on() -> None:
    near = {"contact_length": 0.02, "youngs_modulus": 210e9, "poissons_ratio": 0.3}
    below, above = (PinSection(1.0, WALL_BORE * (1 + e)) for e in (-1e-9, 1e-9))
    assert not below.walled and below.wall_compliance(**near) == 0
    assert above.walled and above.wall_compliance(**near) > 0
    both = PinSection(np.array([1.0, 1.0]), np.array([0.2, 0.5]))
    assert (both.wall_compliance(**near) > 0).tolist() == [False, True]


def bored(share: float, **values: object):
    pin = replace(WHOLE.pin, bore_diameter=share * WHOLE.pin.diameter)
    return having(WHOLE, pin=pin, **values)


def test_the_wall_is_judged_where_the_bore_is_large() -> None:
    assert check_of("pin_wall", bored(0.2)).reason == "solid_pin"
    design = bored(10 / 16, distribution_factor=1.000001)  # forces of the papers: 10 kN/3
    check = check_of("pin_wall", design)
    assert check.value == pytest.approx(1.000001 * 203.67350954e6, rel=EXACT)
    assert check.limit == pytest.approx(800e6 / 1.5) and check.status == "pass"
    assert check.torque_reserve == pytest.approx(check.limit / check.value)
    twice = having(design, peak_torque=2 * 500.0)
    assert check_of("pin_wall", twice).value == pytest.approx(2 * check.value)
    thin = check_of("pin_wall", bored(14 / 16, distribution_factor=1.000001))
    assert thin.status == "fail" and thin.value == pytest.approx(1.000001 * 1873.47844e6, rel=EXACT)
    soft = replace(WHOLE.pin, bore_diameter=0.010, material=ElasticMaterial(210e9, 0.3))
    assert check_of("pin_wall", having(WHOLE, pin=soft)).reason == "yield_unknown"


def test_a_bore_as_wide_as_the_pin_is_refused() -> None:
    bored(0.95)
    with pytest.raises(InvalidInput, match="at most"):
        bored(0.951)
    with pytest.raises(InvalidInput):
        pin_compliance(PinSupport("cantilever", 0.016, (0.037,), STEEL, None, 0.0153))
    with pytest.raises(InvalidInput):
        pin_compliance(PinSupport("cantilever", 0.016, (0.037,), STEEL, None, -1e-3))
