"""Strength of the precessional shaft and pressure of its contact lines, against other ways to them.

The checked case of the theory: 18 932.51 N*mm at the clamp, 24.1056 MPa with 20 mm.
"""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from core.errors import InvalidInput, is_known
from core.fatigue import EnduranceFactors, FatigueStrength, endurance_limit, size_factor
from core.hertz import ContactLimit, ElasticMaterial, hertz
from core.precession.line_contact import line_contact
from core.precession.shaft import ShaftSection, bearing_reactions
from core.precession.shaft_strength import ShaftStrength, shaft_strength
from core.precision import EXACT, JUDGED, SAME

FORCE = (168.756146705, -337.606954169, 0.0)
MOMENT = (-0.0316199045437, -0.0724918335263, 10.0)


def strength(*sections: tuple[float, float], **more) -> ShaftStrength:
    reaction_b, reaction_c = bearing_reactions(force=FORCE, moment=MOMENT, bearing_distance=0.03)
    return shaft_strength(
        reaction_B=reaction_b,
        reaction_C=reaction_c,
        bearing_distance=0.03,
        overhang=0.02,
        sections=[ShaftSection(*each) for each in sections],
        **more,
    )


def limit(diameter: float) -> FatigueStrength:
    factors = EnduranceFactors(0.8, size_factor(diameter=diameter), 1.0, 1.5)
    tensile = 900e6
    return FatigueStrength(endurance_limit(tensile_strength=tensile, factors=factors), tensile)


def test_the_checked_case() -> None:
    found = strength((0.05, 0.02), yield_strength=300e6)
    assert f"{found.bending_moment_clamp * 1e3:.2f}" == "18932.51"
    assert f"{found.peak_stress / 1e6:.4f}" == "24.1056"
    assert found.peak_stress_position == 0.05
    own = 0.03 * math.hypot(171.172541156, 338.660950987)
    assert found.bending_moment_B == pytest.approx(own, rel=SAME)
    assert found.static_safety_factor == pytest.approx(300 / 24.1056, rel=JUDGED)
    assert found.worst is None
    assert not is_known(lambda: strength((0.05, 0.02)).static_safety_factor)


def test_a_load_that_turns_round_the_shaft_reverses_its_bending() -> None:
    found = strength((0.05, 0.02), fatigue=limit)
    assert found.fatigue.max_stress == -found.fatigue.min_stress == found.peak_stress
    assert (found.fatigue.mean, found.cycle_position) == (0, 0.05)
    # 0.8*1.24*20^-0.107*450/1.5 MPa
    limited = 0.8 * 1.24 * 20**-0.107 * 300e6
    assert found.fatigue.safety_factor == pytest.approx(limited / found.peak_stress, rel=SAME)
    steady = strength((0.05, 0.02), fatigue=limit, load_rotates_with_shaft=True)
    assert steady.worst is None


@given(
    cuts=st.lists(st.floats(0.05, 0.95), min_size=1, max_size=4, unique=True),
    diameters=st.lists(st.floats(0.01, 0.04), min_size=5, max_size=5),
)
def test_stepped_shafts_by_many_sections(cuts: list[float], diameters: list[float]) -> None:
    """Moments from force and moment of the mesh, not from reactions: F*s - M*min(s/a, 1)."""
    ends = np.array([0.0, *sorted(cuts), 1.0]) * 0.05
    lengths = np.diff(ends)
    sections = [*zip(lengths.tolist(), diameters, strict=False)]
    if abs(math.fsum(lengths) - 0.05) > 1e-17:
        return
    found = strength(*sections, fatigue=limit)
    stress, use = 0.0, 0.0
    for start, length, d in zip(ends, lengths, diameters, strict=False):
        s = np.linspace(start, start + length, 400)
        s = np.append(s, np.clip(0.03, start, start + length))
        held = np.minimum(s / 0.03, 1)
        x, y = FORCE[0] * s - MOMENT[1] * held, FORCE[1] * s + MOMENT[0] * held
        own = np.hypot(x, y).max() * 32 / (np.pi * d**3)
        stress = max(stress, own)
        use = max(use, own / limit(d).endurance_limit)
    assert found.peak_stress == pytest.approx(stress, rel=JUDGED)
    assert found.fatigue.safety_factor == pytest.approx(1 / use, rel=JUDGED)


STEEL = ElasticMaterial(207e9, 0.292, ContactLimit("given", 1500e6))
BRONZE = ElasticMaterial(111e9, 0.349, ContactLimit("given", 400e6))


@given(q=st.floats(1e2, 1e6), r=st.floats(1e-3, 0.1), other=st.floats(1e-3, 1.0))
@example(q=3.1e6, r=1e-3, other=1e-3)  # nearly too wide
@example(q=3.3e6, r=1e-3, other=1e-3)
def test_two_cylinders_as_shigley_has_them(q: float, r: float, other: float) -> None:
    """Eqs (3-73), (3-74), with diameters: half-width first, pressure from it."""
    found = line_contact(
        line_load=q,
        roller_radius=r,
        mating_radius=other,
        roller_material=STEEL,
        mating_material=BRONZE,
    )
    yields = (1 - 0.292**2) / 207e9 + (1 - 0.349**2) / 111e9
    width = math.sqrt(2 * q / math.pi * yields / (1 / (2 * r) + 1 / (2 * other)))
    assert found.half_width == pytest.approx(width, rel=SAME)
    assert found.max_pressure == pytest.approx(2 * q / (math.pi * width), rel=SAME)
    assert found.roller_safety == pytest.approx(1500e6 / found.max_pressure, rel=SAME)
    assert found.mating_safety == pytest.approx(400e6 / found.max_pressure, rel=SAME)
    assert [each.code for each in found.notices] == ["hertz_line_width"] * (width / r > 0.159)
    for notice in found.notices:
        assert notice.params == {"ratio": pytest.approx(width / r, rel=SAME)}


def test_a_hollow_is_a_hole() -> None:
    own = {"roller_material": STEEL, "mating_material": STEEL}
    found = line_contact(line_load=1e5, roller_radius=0.008, mating_radius=-0.012, **own)
    hole = hertz(
        force=1e5,
        contact_length=1.0,
        pin_radius=0.008,
        hole_radius=0.012,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    for name in ("max_pressure", "half_width", "reduced_radius", "effective_modulus"):
        assert getattr(found, name) == pytest.approx(getattr(hole, name), rel=SAME)
    unlimited = ElasticMaterial(207e9, 0.292)
    found = line_contact(
        line_load=1e5,
        roller_radius=0.008,
        mating_radius=1e9,
        roller_material=unlimited,
        mating_material=unlimited,
    )
    assert not is_known(lambda: found.roller_safety) and not is_known(lambda: found.mating_safety)
    assert found.reduced_radius == pytest.approx(0.008, rel=EXACT)
    for radius in (0.0, -0.008, -0.001):
        with pytest.raises(InvalidInput):
            line_contact(line_load=1e5, roller_radius=0.008, mating_radius=radius, **own)
    sizes = {"line_load": 1e5, "roller_radius": 0.008, "mating_radius": 0.012}
    for name in ("line_load", "roller_radius"):
        with pytest.raises(InvalidInput) as refused:
            line_contact(**sizes | {name: 0.0}, **own)
        assert refused.value.parameter == name


@pytest.mark.parametrize("apart", [1.0, 1e-3, 1e-6])
def test_what_a_hollow_nearly_as_wide_as_the_roller_is_known_to(apart: float) -> None:
    """Radii that are a rounding off change the contact by no more than it states."""
    own = {"line_load": 1e5, "roller_material": STEEL, "mating_material": BRONZE}
    hollow = -0.008 * (1 + apart)
    found = line_contact(roller_radius=0.008, mating_radius=hollow, **own)
    off = line_contact(
        roller_radius=math.nextafter(0.008, 1), mating_radius=math.nextafter(hollow, -1), **own
    )
    error = found.accuracy.relative_error
    for name in ("max_pressure", "half_width", "reduced_radius"):
        assert abs(getattr(off, name) / getattr(found, name) - 1) <= error
    assert 1e-16 / apart < error < 1e-14 / apart
    loose = line_contact(roller_radius=0.008, mating_radius=hollow, **own, load_error=1e-3)
    assert loose.accuracy.relative_error == pytest.approx(error + 5e-4, rel=SAME)
