"""The precessional gear against 40-digit oracles, over random and extreme input.

Position angles from 1e-6 to pi - 1e-6, nutation angles from 1e-4 to 1.5 rad, u12 on both sides
of cos(theta) down to a difference of 1e-9; working lengths across the steepest place of the
line, a few widths around it, far away from it, and down to 1e-13 of their distance from 0. The
exact answer is that of numbers of any digits that round to the doubles given.
"""

import math
import random

import pytest
from mpmath import mp, mpf

from core.errors import InvalidInput
from core.precession.contact_line import contact_lines
from core.precession.rollers import RollerByAngle, RollerByLength
from core.precession.shaft import ShaftSection, shaft_diagram
from core.precession.shaft_deflection import shaft_deflection
from tests.inputs.cases import curve_scale, random_gear, random_position
from tests.oracles.condition import meant
from tests.oracles.precession import (
    length_by_angle,
    length_by_z,
    z_of_angle,
)
from tests.oracles.seeds import seeds
from tests.oracles.shaft import exact_deflection


@pytest.mark.parametrize("seed", seeds(12))
def test_length_by_angle(seed: int) -> None:
    r = random.Random(seed)
    gear = random_gear(r)
    phi_1 = random_position(r)
    # ends anywhere on one branch, down to 1e-14 rad from a pole; the branch may be any
    turn = r.choice([0, 0, 1, -1, 5]) * math.pi
    ends = [
        turn + r.choice([p, math.pi - p]) - phi_1
        for p in (10 ** r.uniform(-14, math.log10(math.pi / 2)) for _ in range(2))
    ]
    if r.random() < 0.3:
        ends[1] = ends[0] * (1 + 10 ** r.uniform(-13, -2))
    roller = RollerByAngle(phi_1, min(ends), max(ends))
    refusal = None
    try:
        result = contact_lines(**gear, rollers=[roller])
    except InvalidInput as caught:
        refusal = caught
    if refusal is not None:
        # only where the angles' own rounding decides on which side of the pole they lie
        assert refusal.parameter.startswith("rollers[0].phi_m")
        angles = [mp.sin(mpf(end) + mpf(phi_1)) for end in ends]
        near = min(abs(angle) for angle in angles) < 1e-14 * max(1, abs(turn))
        assert near or angles[0] * angles[1] < 0 or abs(ends[0] - ends[1]) < 1e-14
        return
    true = {name: meant(r, value) for name, value in gear.items()}
    exact = length_by_angle(
        curve_scale(true),
        meant(r, phi_1),
        true["roller_radius"],
        meant(r, roller.phi_min),
        meant(r, roller.phi_max),
    )
    error = float(abs(mpf(result.total_length) - exact) / exact)
    assert error <= result.accuracy.relative_error
    (line,) = result.lines
    for z, phi, bound in zip(
        (line.z_min, line.z_max),
        sorted(ends, key=lambda end: z_of_angle(curve_scale(gear), phi_1, end)),
        (point.error for point in line.limits[:2]),
        strict=True,
    ):
        true = z_of_angle(curve_scale(gear), phi_1, phi)
        assert abs(mpf(z) - true) <= bound + line.curve.scale_error * abs(true)


@pytest.mark.parametrize("seed", seeds(10))
def test_length_where_nothing_magnifies_the_input(seed: int) -> None:
    """Practical gears: 1e-14 reached and not more than 2e-13 stated."""
    r = random.Random(seed)
    teeth = r.randint(10, 60)
    gear = {
        "roller_circle_radius": 0.05,
        "roller_radius": 0.004,
        "nutation_angle": math.radians(r.uniform(1, 10)),
        "ratio_u12": r.choice([(teeth - 1) / teeth, (teeth + 1) / teeth]),
    }
    phi_1 = r.uniform(0.05, 3.09)
    result = contact_lines(**gear, rollers=[RollerByLength(phi_1, 0.015, 0.025)])
    exact = length_by_z(curve_scale(gear), phi_1, 0.004, mpf(0.015), mpf(0.025))
    assert float(abs(mpf(result.total_length) - exact) / exact) <= 1e-14
    assert result.accuracy.relative_error <= 2e-13


@pytest.mark.parametrize("seed", seeds(12))
def test_shaft_deflection(seed: int) -> None:
    r = random.Random(seed)
    force = tuple(r.uniform(-1, 1) * 10 ** r.uniform(-3, 4) for _ in range(2))
    moment = tuple(r.uniform(-1, 1) * 10 ** r.uniform(-6, 3) for _ in range(2))
    modulus = 10 ** r.uniform(9, 12)
    number = r.randint(1, 6)
    lengths = [r.randint(1, 1000) / 4096 for _ in range(number)]  # exact sums
    sections = [(length, 10 ** r.uniform(-3, -1)) for length in lengths]
    total = sum(lengths)
    a = r.choice([total * r.randint(1, 63) / 64, lengths[0] if number > 1 else total / 2])
    b = total - a
    result = shaft_deflection(
        force=(*force, 0.0),
        moment=(*moment, 5.0),
        bearing_distance=a,
        overhang=b,
        youngs_modulus=modulus,
        shaft_sections=[ShaftSection(*section) for section in sections],
    )
    stated = result.accuracy.relative_error
    diagram = shaft_diagram(
        force=(*force, 0.0),
        moment=(*moment, 5.0),
        bearing_distance=a,
        overhang=b,
        youngs_modulus=modulus,
        shaft_sections=[ShaftSection(*section) for section in sections],
        samples=7,
    )
    for plane, name in enumerate(("x", "y")):
        lever = (-mpf(moment[1]), mpf(moment[0]))[plane]
        reaction_b = lever / mpf(a)
        reaction_c = -mpf(force[plane]) - reaction_b
        loads = (-reaction_b, -reaction_c)
        for place, found in ((mpf(a), result.deflection_B), (mpf(0), result.deflection_C)):
            exact = exact_deflection(sections, a, b, modulus, *loads, place)
            assert abs(mpf(getattr(found, name)) - exact) <= stated * found.total
        sag = [
            exact_deflection(sections, a, b, modulus, *loads, mpf(float(place)))
            for place in diagram.position
        ]
        size = max(abs(value) for value in sag)
        for value, exact in zip(diagram.deflection[:, plane], sag, strict=True):
            assert abs(mpf(float(value)) - exact) <= 1e-10 * size
