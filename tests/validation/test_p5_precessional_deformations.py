"""Paper values: Khatetovsky, Dokonov, Galyuzhin 2020 (P5), UDC 621.833, and why its eqs (1), (5),
(10), (22), (24), C_x and (33)-(36) cannot be right as printed.

P5 gives no numbers: the checked case was evaluated from its formulas to 40 digits elsewhere.
"""

import math
from typing import Any

import numpy as np
import pytest

from core.precession.contact_line import contact_lines, contact_points
from core.precession.meshing_load import meshing_load
from core.precession.rollers import RollerByLength, wheel_rollers
from core.precession.shaft import ShaftSection, bearing_reactions
from core.precession.shaft_deflection import shaft_deflection
from core.precision import CONVERGED, EXACT, SAME

R_C, RHO, M1 = 0.05, 0.004, 10.0
GEAR: dict[str, Any] = {
    "roller_circle_radius": R_C,
    "roller_radius": RHO,
    "nutation_angle": math.radians(6),
    "ratio_u12": 24 / 25,
    "rollers": [RollerByLength(math.radians(p), 0.015, 0.025) for p in (30, 60, 90, 120)],
}


def test_checked_case() -> None:
    load = meshing_load(**GEAR, torque=M1, reference_z=0.02)
    assert load.total_length == pytest.approx(40.2196026288e-3, rel=SAME)
    assert load.force == pytest.approx((168.756146705, -337.606954169, 0.0), rel=SAME)
    assert load.moment == pytest.approx((-0.0316199045437, -0.0724918335263, 10.0), rel=SAME)
    b, c = bearing_reactions(force=load.force, moment=load.moment, bearing_distance=0.03)
    assert b == pytest.approx((2.41639445088, -1.05399681812), rel=10 * SAME)
    assert c == pytest.approx((-171.172541156, 338.660950987), rel=10 * SAME)
    assert load.accuracy.relative_error < 1e-12


def test_the_wheel_gives_the_same_rollers() -> None:
    rollers = wheel_rollers(
        rollers_total=12,
        rollers_in_mesh=4,
        position_angle=math.radians(30),
        z_min=0.015,
        z_max=0.025,
    )
    load = meshing_load(**GEAR | {"rollers": rollers}, torque=M1, reference_z=0.02)
    assert load.force == pytest.approx((168.756146705, -337.606954169, 0.0), rel=SAME)


@pytest.mark.parametrize(("phi", "phi_1"), [(-0.4, 0.5), (-0.9, 2.0), (0.3, -1.1)])
def test_errata_1_and_5(phi: float, phi_1: float) -> None:
    angle = GEAR["nutation_angle"]
    factor = R_C * (math.cos(angle) - GEAR["ratio_u12"]) / math.sin(angle)

    def z(x: float) -> float:
        """P5 (1) without its "= 0", over the arc x = rho*phi."""
        return -factor * math.sin(x / RHO) / math.sin(x / RHO + phi_1)

    x = RHO * phi
    # "= 0" would put every contact point in the plane z = 0
    assert abs(z(x)) > 1e-3
    line = contact_lines(**GEAR | {"rollers": [RollerByLength(phi_1, z(x), z(x) + 1e-3)]}).lines[0]
    assert contact_points(line=line, samples=2).z[0] == z(x)
    # (5) is the derivative of (1) with the other sign; (4), (12)-(17) use its square
    printed = (
        factor
        / RHO
        * (
            math.cos(phi) / math.sin(phi_1 + phi)
            - math.sin(phi) * math.cos(phi_1 + phi) / math.sin(phi_1 + phi) ** 2
        )
    )
    step = 1e-6 * RHO
    slope = (z(x + step) - z(x - step)) / (2 * step)
    assert slope == pytest.approx(-printed, rel=EXACT)
    assert slope == pytest.approx(-factor * math.sin(phi_1) / (RHO * math.sin(phi + phi_1) ** 2))


def frame_1(phi: float, sign: float) -> tuple[float, float, float, float]:
    """Point (2), (3) and normal (9), (10) on the roller, n_y = sign*cos(phi)."""
    return RHO * math.sin(phi), R_C - RHO * math.cos(phi), math.sin(phi), sign * math.cos(phi)


def turned(x: float, y: float, angle: float) -> tuple[float, float]:
    """P5 (20)."""
    sine, cosine = math.sin(angle), math.cos(angle)
    return x * cosine - y * sine, x * sine + y * cosine


def arm_in_wheel_frame(phi: float, phi_1: float, sign: float) -> float:
    """Arm with the place (21) and the normal printed in (25), (26), or (10)'s in frame 1."""
    x, y, n_x, n_y = frame_1(phi, sign)
    r_x, r_y = turned(x, y, phi_1)
    n_x, n_y = turned(n_x, n_y, phi_1)
    return r_x * n_y - r_y * n_x


@pytest.mark.parametrize(("phi", "phi_1"), [(-0.4, 0.5), (-0.9, 2.0), (0.3, -1.1)])
def test_errata_10_and_22_contradict_25_and_26(phi: float, phi_1: float) -> None:
    n_x_25 = math.sin(phi) * math.cos(phi_1) + math.cos(phi) * math.sin(phi_1)
    n_y_26 = math.sin(phi) * math.sin(phi_1) - math.cos(phi) * math.cos(phi_1)
    printed = turned(math.sin(phi), math.cos(phi), phi_1)  # as the middle step of (22) has it
    derived = turned(math.sin(phi), -math.cos(phi), phi_1)
    assert derived == pytest.approx((n_x_25, n_y_26), abs=1e-15)
    assert abs(printed[0] - n_x_25) > 0.1
    # the arm of (8) is that of the load about the axis, so it is the same in every frame: (8)
    # with (10) as printed against the integrals' denominator with (23)-(26)
    x, y, n_x, n_y = frame_1(phi, 1.0)
    with_10 = x * n_y - y * n_x
    r_x, r_y = turned(x, y, phi_1)
    with_25_26 = r_x * n_y_26 - r_y * n_x_25
    assert with_25_26 == pytest.approx(-R_C * math.sin(phi), rel=SAME)
    assert abs(with_10 / with_25_26 - 1) > 0.05
    assert arm_in_wheel_frame(phi, phi_1, -1.0) == pytest.approx(with_25_26, rel=SAME)
    # with the derived sign the normal points from the roller's axis to the contact point
    assert derived == pytest.approx(
        ((r_x + R_C * math.sin(phi_1)) / RHO, (r_y - R_C * math.cos(phi_1)) / RHO), abs=1e-13
    )


def test_erratum_24_contradicts_21() -> None:
    line = contact_lines(**GEAR).lines[1]
    points = contact_points(line=line, samples=5)
    across, inward = RHO * np.sin(points.phi), R_C - RHO * np.cos(points.phi)
    sine, cosine = math.sin(line.position_angle), math.cos(line.position_angle)
    r_x = across * cosine - inward * sine  # (23)
    printed = across * sine - inward * cosine  # (24)
    distance = np.hypot(across, inward)  # of the contact point from the axis, (2), (3)
    assert np.hypot(points.position[:, 0], points.position[:, 1]) == pytest.approx(distance)
    assert np.all(np.abs(np.hypot(r_x, printed) / distance - 1) > 1e-3)


def test_erratum_c_x_breaks_the_equilibrium_28() -> None:
    load = meshing_load(**GEAR, torque=M1, reference_z=0.02)
    a = 0.03
    b, c = bearing_reactions(force=load.force, moment=load.moment, bearing_distance=a)
    printed = load.force[0] + load.moment[1] / a
    assert abs(b[0] + printed + load.force[0]) > 100
    for plane in (0, 1):
        assert b[plane] + c[plane] + load.force[plane] == pytest.approx(0, abs=1e-12)
    assert b[0] * a + load.moment[1] == pytest.approx(0, abs=1e-15)  # (30)
    assert -b[1] * a + load.moment[0] == pytest.approx(0, abs=1e-15)  # (31)


def printed_deflections(
    a: float, b: float, load_b: tuple[float, float], load_c: tuple[float, float], plane: int
) -> tuple[float, float]:
    """E*I times (y_B, y_C) of (33), (34), or (35), (36) for plane 0, by Simpson's rule (exact)."""

    def simpson(function: Any, end: float) -> float:
        return float(end * (function(0.0) + 4 * function(end / 2) + function(end)) / 6)

    p_b, p_c = load_b[plane], load_c[plane]
    at_c = simpson(lambda s: (-p_c * (a + s) - p_b * s) * s, b)
    at_b = simpson(lambda s: (-load_c[0] * s) * (-s), a) + simpson(
        lambda s: (-p_c * ((a + s) + s) - p_b * s) * -(a + s), b
    )
    return at_b, at_c


def derived_deflections(
    a: float, b: float, load_b: tuple[float, float], load_c: tuple[float, float], plane: int
) -> tuple[float, float]:
    """E*I times (y_B, y_C) of the program for forces B and C on the shaft."""
    modulus, diameter = 210e9, 0.02
    result = shaft_deflection(
        # forces of the mesh that give these bearing loads
        force=(load_b[0] + load_c[0], load_b[1] + load_c[1], 0.0),
        moment=(-load_b[1] * a, load_b[0] * a, 0.0),
        bearing_distance=a,
        overhang=b,
        shaft_sections=[ShaftSection(a + b, diameter)],
        youngs_modulus=modulus,
    )
    rigidity = modulus * math.pi * diameter**4 / 64
    at_b, at_c = result.deflection_B, result.deflection_C
    name = ("x", "y")[plane]
    return rigidity * getattr(at_b, name), rigidity * getattr(at_c, name)


@pytest.mark.parametrize("plane", [0, 1])
def test_errata_33_to_36_break_maxwells_reciprocity(plane: int) -> None:
    a, b = 0.03, 0.05
    unit, none = (1.0, 1.0), (0.0, 0.0)
    for deflections, holds in ((derived_deflections, True), (printed_deflections, False)):
        b_under_c = deflections(a, b, none, unit, plane)[0]
        c_under_b = deflections(a, b, unit, none, plane)[1]
        # the printed unit loads differ in sign as well: compare sizes
        assert (abs(b_under_c) == pytest.approx(abs(c_under_b), rel=SAME)) is holds
    # a force on the free end bends the free end more than the place behind it
    assert np.abs(printed_deflections(a, b, none, unit, plane)[0]) > np.abs(
        printed_deflections(a, b, none, unit, plane)[1]
    )
    at_b, at_c = derived_deflections(a, b, none, unit, plane)
    assert at_c > at_b > 0
    assert at_c == pytest.approx((a + b) ** 3 / 3, rel=CONVERGED)
    assert at_b == pytest.approx(b**3 / 3 + a * b**2 / 2, rel=CONVERGED)
    assert derived_deflections(a, b, unit, none, plane)[0] == pytest.approx(b**3 / 3, rel=CONVERGED)


def test_erratum_34_mixes_the_planes() -> None:
    # a force in x alone must not bend the shaft in y
    none, along_x = (0.0, 0.0), (1.0, 0.0)
    assert printed_deflections(0.03, 0.05, none, along_x, 1)[0] != 0
    assert derived_deflections(0.03, 0.05, none, along_x, 1) == (0.0, 0.0)


def test_errata_33_and_35_have_the_sign_opposite_to_34_and_36() -> None:
    # (33) is minus the deflection of B; (34) without its misprints is plus that of C
    a, b, load_b, load_c = 30.0, 40.0, (2.0, 2.0), (3.0, 3.0)
    at_b, at_c = derived_deflections(a, b, load_b, load_c, 1)
    printed_b, _ = printed_deflections(a, b, load_b, load_c, 1)
    assert at_b == pytest.approx(536000 / 3, rel=CONVERGED)
    assert printed_deflections(a, b, load_b, load_c, 1)[1] == pytest.approx(-at_b, rel=CONVERGED)

    def amended_34(s: float) -> float:
        return (-load_c[1] * (a + s) - load_b[1] * s) * -(a + s)

    amended = load_c[1] * a**3 / 3 + b * (amended_34(0) + 4 * amended_34(b / 2) + amended_34(b)) / 6
    assert amended == pytest.approx(at_c, rel=CONVERGED)
    assert printed_b > 0
