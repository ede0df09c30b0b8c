"""Paper values: Yanchevskiy, Niekhoroshykh 2021 (P2), doi 10.20535/kpissn.2021.4.245103.

P2's numbers are those of N = 3 pins and u = 20 unless said otherwise; its figures give counts
and symmetries, which are exact, and no force to more than the eye reads.
"""

import math

import numpy as np
import pytest

from core.output.contact_force import cyclogram, force_ratios, peak_force
from core.output.mechanism import Mechanism, assembly_angles, pin_geometry
from core.precision import CONVERGED, SAME

RATIO = 20.0


def p2_mechanism(pins: int, satellites: int, spacing_deg: float, ratio: float = RATIO) -> Mechanism:
    return Mechanism.evenly_spaced(
        pins=pins, satellites=satellites, ratio=ratio, crank_spacing=math.radians(spacing_deg)
    )


FIGURE_6 = [
    pytest.param(3, 2, 180.0, {3}, id="a"),
    pytest.param(3, 2, 120.0, {2, 4}, id="b"),
    pytest.param(3, 2, 90.0, {2, 3, 4}, id="c"),
    pytest.param(3, 3, 120.0, {3, 6}, id="d"),
    pytest.param(4, 3, 120.0, {6}, id="e"),
    pytest.param(3, 4, 90.0, {6}, id="f"),
]


@pytest.mark.parametrize(("pins", "satellites", "spacing", "counts"), FIGURE_6)
def test_figure_6_numbers_of_driving_pairs(
    pins: int, satellites: int, spacing: float, counts: set[int]
) -> None:
    result = cyclogram(mechanism=p2_mechanism(pins, satellites, spacing))
    assert {interval.pairs for interval in result.driving_count} == counts
    assert (result.min_driving, result.max_driving) == (min(counts), max(counts))
    assert result.mean_driving == pins * satellites / 2


@pytest.mark.parametrize(("pins", "satellites", "spacing", "counts"), FIGURE_6)
@pytest.mark.parametrize("start", [0.1, math.pi, 5.0])
def test_figure_6_does_not_depend_on_where_the_crank_starts(
    pins: int, satellites: int, spacing: float, counts: set[int], start: float
) -> None:
    mechanism = Mechanism.evenly_spaced(
        pins=pins,
        satellites=satellites,
        ratio=RATIO,
        crank_spacing=math.radians(spacing),
        initial_crank_angle=start,
    )
    result = cyclogram(mechanism=mechanism, revolutions=2.3)
    assert {interval.pairs for interval in result.driving_count} == counts


TABLE = [
    # N, K, alpha, peak at v = 1, peak at v = 0, numbers of driving pairs; re-derived to 40 digits
    (3, 1, 0, 1.24923321121593, 1.15470053837925, {1, 2}),
    (3, 2, 180, 2 / 3, 0.577350269189626, {3}),
    (3, 2, 120, 0.624616605607963, 0.577350269189626, {2, 4}),
    (3, 2, 90, 0.694199805443736, 0.535898384862245, {2, 3, 4}),
    (3, 3, 120, 0.416411070405309, 0.384900179459751, {3, 6}),
    (4, 3, 120, 1 / 3, 0.267949192431123, {6}),
    (3, 4, 90, 1 / 3, 0.267949192431123, {6}),
    (5, 1, 0, 0.839642543409072, 0.649839392465813, {2, 3}),
    (2, 2, 90, 1.0, 1.0, {2}),
]


@pytest.mark.parametrize(("pins", "satellites", "spacing", "linear", "equal", "counts"), TABLE)
def test_peaks_and_counts_of_the_configurations(
    pins: int, satellites: int, spacing: float, linear: float, equal: float, counts: set[int]
) -> None:
    # 15 digits are written down: half a unit of the last is 5e-15 of the largest
    mechanism = p2_mechanism(pins, satellites, spacing)
    at_v1 = peak_force(mechanism=mechanism, force_exponent=1.0).peak_force_ratio
    at_v0 = peak_force(mechanism=mechanism, force_exponent=0.0).peak_force_ratio
    assert at_v1 == pytest.approx(linear, rel=CONVERGED)
    assert at_v0 == pytest.approx(equal, rel=CONVERGED)
    found = cyclogram(mechanism=mechanism)
    assert {interval.pairs for interval in found.driving_count} == counts


@pytest.mark.parametrize(
    ("pins", "satellites", "spacing", "phases", "shared"),
    [
        (3, 2, 180, 6, 1),
        (4, 3, 120, 12, 1),
        (3, 4, 90, 12, 1),
        (4, 1, 0, 4, 1),
        (4, 2, 180, 4, 2),
        (4, 4, 90, 4, 4),
        (8, 1, 0, 8, 1),
        (6, 2, 180, 6, 2),
        (3, 6, 60, 6, 3),
        (2, 2, 90, 4, 1),
    ],
)
def test_even_numbers_of_evenly_spaced_phases_have_a_constant_sum(
    pins: int, satellites: int, spacing: float, phases: int, shared: int
) -> None:
    # sum cos^2 = c*m/4 throughout, so the peak is 4/(c*m); m phases with c pairs on each
    mechanism = p2_mechanism(pins, satellites, spacing)
    peak = peak_force(mechanism=mechanism)
    assert peak.peak_force_ratio == pytest.approx(4 / (shared * phases), rel=CONVERGED)
    angles = np.linspace(0.003, 6.2, 57)
    forces = force_ratios(mechanism=mechanism, crank_angles=angles)
    squares = (forces**2).sum(axis=(1, 2))
    # sum F^2 = sum cos^2/(c*m/4)^2 = 4/(c*m)
    assert squares == pytest.approx(4 / (shared * phases), rel=SAME)


def test_figure_7_four_satellites_halve_the_force_of_two() -> None:
    # "doubling the number of driving pairs halves the largest contact force"
    two = peak_force(mechanism=p2_mechanism(3, 2, 180)).peak_force_ratio
    four = peak_force(mechanism=p2_mechanism(3, 4, 90)).peak_force_ratio
    assert four == pytest.approx(two / 2, rel=CONVERGED)


def test_figure_7_curve_of_a_constant_number_of_pairs_is_a_cosine() -> None:
    # "with a constant number of driving pairs the curve is like a parabola": 2/3*cos(gamma)
    mechanism = p2_mechanism(3, 2, 180)
    speed = 1 + 1 / RATIO
    phi = np.linspace(0.01, 6.2, 201)
    curve = force_ratios(mechanism=mechanism, crank_angles=phi)[:, 0, 0]
    assert curve == pytest.approx(2 / 3 * np.maximum(0, -np.sin(phi * speed)), abs=1e-14)


def test_figure_7_three_satellites_peak_above_four_but_below_two() -> None:
    peaks = [
        peak_force(mechanism=p2_mechanism(3, k, a)).peak_force_ratio
        for k, a in ((2, 180), (3, 120), (4, 90))
    ]
    assert peaks[0] > peaks[1] > peaks[2]


def test_erratum_force_ratio_is_not_always_below_one() -> None:
    # P2 after eq. (11): "f < 1". With one satellite and three pins one pair alone carries the
    # whole torque over part of the turn, at an arm R*cos(gamma) < R: equilibrium asks for more
    # than F0.
    mechanism = p2_mechanism(3, 1, 0)
    assert peak_force(mechanism=mechanism).peak_force_ratio > 1.249
    phi = math.radians(260) / (1 + 1 / RATIO)
    rows = force_ratios(mechanism=mechanism, crank_angles=np.array([phi]))[0]
    assert np.count_nonzero(rows) == 1
    arm = -math.sin(math.radians(260))
    assert rows[0, 0] * arm == pytest.approx(1.0, rel=CONVERGED)
    assert rows[0, 0] > 1


@pytest.mark.parametrize("spacing", [180.0, 120.0, 90.0, 37.0])
@pytest.mark.parametrize("phi", [0.0, 0.7, 2.9, 5.5])
def test_equation_6_follows_from_the_contact_points(spacing: float, phi: float) -> None:
    # cos(gamma) = (M - E).dM/dphi/(|M - E|*|dM/dphi|), the velocity from the pins' own motion
    mechanism = p2_mechanism(3, 2, spacing, ratio=7.5)
    sizes = {
        "pin_circle_radius": 0.05,
        "pin_radius": 0.006,
        "hole_radius": 0.008,
        "eccentricity": 0.002,
    }
    found = pin_geometry(mechanism=mechanism, crank_angle=phi, **sizes)
    step = 1e-5
    after = pin_geometry(mechanism=mechanism, crank_angle=phi + step, **sizes).pin_centres
    before = pin_geometry(mechanism=mechanism, crank_angle=phi - step, **sizes).pin_centres
    velocity = after - before
    velocity /= np.linalg.norm(velocity, axis=1)[:, None]
    normal = (found.pin_centres - found.contact_points) / 0.006
    cosine = (normal * velocity).sum(axis=2)
    n, j = np.meshgrid(np.arange(3), np.arange(2))
    wave = phi * (1 + 1 / 7.5) + math.radians(spacing) * j + 2 * math.pi * n / 3
    # the difference quotient is good to rounding over step
    assert cosine == pytest.approx(np.cos(math.pi / 2 + wave), abs=1e-9)
    assert np.cos(found.pressure_angles) == pytest.approx(cosine, abs=1e-9)
    assert (found.driving == (cosine > 0)).all() or np.abs(cosine).min() < 1e-9


def test_assembly_with_40_teeth() -> None:
    # z = 40, u = 20, 180 degrees: 180/20 = 9 degrees is one pitch, identical satellites fit
    first, second = assembly_angles(mechanism=p2_mechanism(3, 2, 180), satellite_teeth=40)
    assert (first.hole_rotation, second.hole_rotation) == (0.0, 0.0)
    assert first.identical
    assert second.identical


@pytest.mark.parametrize(
    ("teeth", "ratio", "spacing", "rotation_deg"),
    [
        (40, 20.0, 120.0, 3.0),  # 6 degrees, pitch 9
        (40, 20.0, 90.0, 4.5),  # half a pitch
        (39, 39.0, 180.0, 180 / 39),  # z3 = 40: half a pitch
        (60, 60.0, 180.0, 3.0),
        (60, 30.0, 180.0, 0.0),
    ],
)
def test_assembly_angle_of_the_second_satellite(
    teeth: int, ratio: float, spacing: float, rotation_deg: float
) -> None:
    mechanism = p2_mechanism(3, 2, spacing, ratio=ratio)
    second = assembly_angles(mechanism=mechanism, satellite_teeth=teeth)[1]
    assert math.degrees(abs(second.hole_rotation)) == pytest.approx(rotation_deg, abs=1e-13)


def test_erratum_assembly_angle_counts_from_the_first_satellite() -> None:
    # P2 prints psi_j = min(j*alpha/u +- k*2*pi/z). For j = 1 that turns the satellite that all
    # others are measured against: with z = 40, u = 20, alpha = 120 degrees by 3 degrees.
    spacing, pitch = 120.0, 9.0
    printed = [abs(math.remainder(j * spacing / RATIO, pitch)) for j in (1, 2)]
    assert printed[0] == pytest.approx(3.0)
    derived = assembly_angles(mechanism=p2_mechanism(3, 2, spacing), satellite_teeth=40)
    assert derived[0].hole_rotation == 0.0
    assert derived[0].identical
    # and only the difference between two satellites matters, which the print has right
    assert math.degrees(derived[1].hole_rotation) == pytest.approx(
        abs(math.remainder(spacing / RATIO, pitch)), abs=1e-13
    )
