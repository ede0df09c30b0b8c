"""The pin as a beam: against finite elements of its own, a scan of the section, printed numbers."""

import math
import random

import numpy as np
import pytest

from core.output.pin_beam import PinBeam, section_stress
from core.precision import EXACT, SAME
from tests.oracles.pin import bend


def test_a_section_in_bending_and_shear() -> None:
    assert f"{section_stress(bending=50.0, mean_shear=40.0):.4f}" == "92.3760"
    r = random.Random(1)
    angle = np.linspace(0, 2 * np.pi, 200_001)
    for _ in range(50):
        bending = r.uniform(0, 2) * np.exp(1j * r.uniform(0, 7))
        shear = r.uniform(0, 2) * np.exp(1j * r.uniform(0, 7))
        edge = np.exp(-1j * angle)
        along = (bending * edge).real
        sheared = 4 / 3 * (shear * edge).imag
        most = np.sqrt(along**2 + 3 * sheared**2).max()
        assert section_stress(bending=bending, mean_shear=shear) == pytest.approx(most, rel=EXACT)
    assert section_stress(bending=3.0, mean_shear=0.0) == 3


@pytest.mark.parametrize("support", ["cantilever", "supported", "fixed"])
def test_against_finite_elements(support: str) -> None:
    """A hundred random pins each: deflection, slope, moment and shear in every node."""
    r = random.Random(support)
    for _ in range(100):
        satellites = r.randint(1, 4)
        length = 10 ** r.uniform(-4, -1)
        gaps = [length * 10 ** r.uniform(-3, 1) for _ in range(satellites + 1)]
        places = [sum(gaps[: i + 1]) + length * (i + 0.5) for i in range(satellites)]
        pin = {
            "support": support,
            "diameter": length * 10 ** r.uniform(-1, 1),
            "contact_length": length,
            "youngs_modulus": 10 ** r.uniform(9, 12),
            "poissons_ratio": r.uniform(0, 0.49),
            "span": None if support == "cantilever" else sum(gaps) + length * satellites,
        }
        forces = [10 ** r.uniform(0, 5) for _ in places]
        inside = [r.uniform(0, places[-1]) for _ in range(3)]
        exact = bend(**pin, loads=list(zip(places, forces, strict=True)), looked_at=inside)
        beam = PinBeam.round(**pin | {"span": pin["span"] or math.inf})
        x = np.array(exact.places, dtype=float)[:, None]
        for name in ("deflection", "slope", "moment", "shear"):
            true = np.array(getattr(exact, name), dtype=float)
            found = (getattr(beam, name)(x, np.array(places)) * forces).sum(axis=1)
            assert found == pytest.approx(true, rel=SAME, abs=1e-12 * np.abs(true).max()), name


def test_two_loads_as_published_nowhere_but_checked_twice() -> None:
    """Deflections of a cantilever, reactions of two supports, by quadrature and finite elements."""
    sizes = {"diameter": 0.016, "contact_length": 0.02}
    steel = {"youngs_modulus": 210e9, "poissons_ratio": 0.3}
    loads = ((0.015, 3000.0), (0.037, 2000.0))

    def total(beam: PinBeam, name: str, x: float) -> float:
        return sum(force * getattr(beam, name)(x, z) for z, force in loads)

    beam = PinBeam.round(support="cantilever", **sizes, **steel)
    bent = [f"{total(beam, 'deflection', x) * 1e3:.10f}" for x, _ in loads]
    assert bent == ["0.0203643427", "0.0754619229"]
    turned = [f"{total(beam, 'slope', x) * 1e3:.9f}" for x, _ in loads]
    assert turned == ["1.846594043", "2.624704612"]
    beam = PinBeam.round(support="supported", span=0.052, **sizes, **steel)
    reactions = [f"{total(beam, 'shear', x):.7f}" for x in (0.0, 0.052)]
    assert reactions == ["2711.5384615", "-2288.4615385"]
    assert f"{total(beam, 'moment', 0.0230769) * -1e3:.3f}" == "38065.828"
    beam = PinBeam.round(support="fixed", span=0.052, **sizes, **steel)
    assert f"{total(beam, 'shear', 0.0):.7f}" == "2770.6117021"
    clamped = [f"{total(beam, 'moment', x) * 1e3:.4f}" for x in (0.0, 0.052)]
    assert clamped == ["26616.0325", "23544.2239"]
