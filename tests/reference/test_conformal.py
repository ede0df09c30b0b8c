"""The conformal contact against plane elasticity itself, and against other methods.

The solution of identical materials is not taken on trust: its pressure is put into the
displacements of a disc and of a hole (Michell's series for each harmonic of the pressure), and the
gap that they leave has to be closed over the contact and open beside it. Those of other materials
are held against that series solved for the pressure (`tests.oracles.dissimilar`), against the
integral equation with many terms (`tests.oracles.conformal`), and against numbers in which both
agreed with each other and with finite elements of both bodies (`conformal_cases.json`).
"""

import json
import math
import random
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from core.conformal import (
    ERROR,
    closed_pressure,
    conformal_contact,
    edge_tension,
    first_yield_factor,
    load_under_pressure,
    pressure_over_angle,
    widest_load,
)
from core.hertz import HERTZ_TOLERANCE, ElasticMaterial, hertz, mismatch
from core.precision import EXACT, SAME, SEARCHED
from tests.oracles import conformal, dissimilar
from tests.oracles.hertz import exact_pressure, exact_tangent
from tests.oracles.seeds import seeds

CASES = json.loads((Path(conformal.__file__).parent / "conformal_cases.json").read_text())
HELD = 1e-5
"""Relative error of the numbers of the cases."""


def over_hertz(load_parameter: float) -> float:
    """The pressure over Hertz's, of identical materials and Persson's parameter ``2*E* dR/Q``."""
    contact = conformal_contact(load_parameter=load_parameter / 2)
    return float(contact.pressure / math.sqrt(load_parameter / (2 * math.pi)))


LOAD_PARAMETERS = [1e-12, 1e-6, 1e-3, 0.03, 0.3, 1.0, 3.0, 30.0, 300.0, 1e4, 1e8, 1e14]


@pytest.mark.parametrize("load_parameter", LOAD_PARAMETERS)
def test_conformal_half_angle_and_peak_pressure(load_parameter: float) -> None:
    b = conformal_contact(load_parameter=load_parameter / 2).tangent
    exact = exact_tangent(load_parameter)
    assert abs(mpf(b) / exact - 1) < 1e-15
    ratio = over_hertz(load_parameter)
    exact_ratio = exact_pressure(mpf(0), exact) / mp.sqrt(mpf(load_parameter) / (2 * mp.pi))
    assert abs(mpf(ratio) / exact_ratio - 1) < 3e-15


@pytest.mark.parametrize("load_parameter", [0.0, *LOAD_PARAMETERS])
def test_conformal_pressure_carries_the_load(load_parameter: float) -> None:
    # Q = integral of p*cos(angle)*R over the contact
    b = conformal_contact(load_parameter=load_parameter / 2).tangent
    end = 2 * mp.atan(mpf(b))

    def share(t: mpf) -> mpf:
        # angle = end*sin(t) takes the square roots at the ends away
        angle = end * mp.sin(t)
        y = min(float(mp.tan(abs(angle) / 2)), b)
        pressure = closed_pressure(position=y, tangent=b)
        return mpf(pressure) * mp.cos(angle) * end * mp.cos(t)

    with mp.workdps(18):
        carried = mp.quad(share, [-mp.pi / 2, 0, mp.pi / 2], maxdegree=6)
    assert float(carried) == pytest.approx(1.0, abs=1e-11)


@pytest.mark.parametrize("load_parameter", [0.0, 0.05, 0.3, 1.0, 3.0, 20.0])
def test_conformal_pressure_closes_the_gap_between_disc_and_hole(load_parameter: float) -> None:
    """Michell's series: for a pressure p_n*cos(n*t) on both rims (plane strain, one material)

    u_hole - u_disc = 4*R/E1* * p_n * n/(n^2 - 1) * cos(n*t),  n >= 2;  2*R/E1* * p_0,  n = 0

    (n = 1 is a rigid motion of the disc). Contact: u_hole - u_disc + dR = C*cos(t).
    """
    harmonics, points = 700, 4001
    b = conformal_contact(load_parameter=load_parameter / 2).tangent
    end = 2 * math.atan(b)
    t = np.linspace(-np.pi / 2, np.pi / 2, points)
    weight = end * np.cos(t) * (t[1] - t[0])
    angle = end * np.sin(t)
    y = np.minimum(np.abs(np.tan(angle / 2)), b)
    pressure = np.array([closed_pressure(position=float(p), tangent=b) for p in y])
    load = pressure * weight
    # the middle of the contact, two places nearer its edge, and two outside it
    places = np.array([0.0, 0.3, 0.6, 0.85, 1.3, 1.7]) * end
    approach = np.full(len(places), 2 * load.sum() / (2 * math.pi))
    for n in range(2, harmonics):
        p_n = float((load * np.cos(n * angle)).sum()) / math.pi
        approach += 4 * p_n * n / (n * n - 1) * np.cos(n * places)
    # in units of Q/E1*: approach + load_parameter = C*cos(t)
    gap = approach + load_parameter
    rigid = gap[0] / math.cos(places[0])
    error = gap - rigid * np.cos(places)
    scale = float(np.abs(approach).max())
    assert np.abs(error[:4]).max() < 2e-6 * scale
    # beside the contact the disc has not reached the hole
    assert (error[4:] > 0.1 * scale).all()


def test_without_clearance_the_contact_angle_is_the_known_limit() -> None:
    # Persson's limit: dR = 0, 2 = ln(b^2 + 1) + 2*b^4, whatever the load
    b = conformal_contact(load_parameter=0.0).tangent
    assert abs(mpf(b) / exact_tangent(0.0) - 1) < 1e-15
    assert 2 * math.degrees(math.atan(b)) == pytest.approx(85.0, abs=0.5)


def test_hertz_is_the_limit_of_a_narrow_contact() -> None:
    # b -> 0: the first correction falls as b^2 ~ 1/load_parameter
    errors = [abs(over_hertz(p) - 1) for p in (1e2, 1e3, 1e4, 1e5, 1e6)]
    for wide, narrow in pairwise(errors):
        assert narrow == pytest.approx(wide / 10, rel=0.05)
    b = conformal_contact(load_parameter=5e9).tangent
    assert b == pytest.approx(math.sqrt(2 / (math.pi * 1e10)), rel=EXACT)


@pytest.mark.parametrize("degrees", [5, 10, 20, 40, 60, 75, 78, 83, 84.5])
def test_the_series_of_a_disc_in_a_hole_gives_persson(degrees: float) -> None:
    half_angle = math.radians(degrees)
    load, pressure = dissimilar.contact(half_angle, 0.0, 0.0)
    b = math.tan(half_angle / 2)
    expected = closed_pressure(position=0.0, tangent=b)
    assert pressure / load == pytest.approx(expected, rel=dissimilar.ERROR)
    parameter = 2.0 / load  # the load is in units of E*/2
    assert conformal_contact(load_parameter=parameter).tangent == pytest.approx(
        b, rel=dissimilar.ERROR
    )


def materials_of(case: dict[str, Any]) -> tuple[ElasticMaterial, ElasticMaterial]:
    return (
        ElasticMaterial(case["E1_MPa"] * 1e6, case["nu1"]),
        ElasticMaterial(case["E2_MPa"] * 1e6, case["nu2"]),
    )


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['pin']} in {case['hole']}")
def test_pressure_angle_and_edge_tension_are_those_of_the_cases(case: dict[str, Any]) -> None:
    pin, hole = materials_of(case)
    alpha, beta = mismatch(first=pin, second=hole)
    found = conformal_contact(load_parameter=case["load_parameter"], alpha=alpha, beta=beta)
    radius = math.sqrt(case["r_mm"] * (case["r_mm"] + case["dR_mm"]))
    load = case["Q_N_per_mm"] / radius
    assert found.pressure * load == pytest.approx(case["p_max_MPa"], rel=HELD)
    degrees = 2 * math.degrees(math.atan(found.tangent))
    assert degrees == pytest.approx(case["half_angle_deg"], rel=HELD)
    tension = edge_tension(
        mean_pressure=found.mean_pressure,
        tangent=found.tangent,
        poissons_ratio=hole.poissons_ratio,
    )
    assert tension * load == pytest.approx(case["hoop_tension_hole_MPa"], rel=HELD)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['pin']} in {case['hole']}")
def test_a_contact_that_wraps_is_judged_by_the_pressure_of_the_cases(case: dict[str, Any]) -> None:
    pin, hole = materials_of(case)
    r, R = case["r_mm"] / 1e3, (case["r_mm"] + case["dR_mm"]) / 1e3
    found = hertz(
        force=case["Q_N_per_mm"] * 20,
        contact_length=0.02,
        pin_radius=r,
        hole_radius=R,
        pin_material=pin,
        hole_material=hole,
    )
    pressure, angle = case["p_max_MPa"] * 1e6, math.radians(case["half_angle_deg"])
    if pressure <= (1 + HERTZ_TOLERANCE) * found.max_pressure:
        assert found.conformal_pressure is None
        assert found.governing_pressure == found.max_pressure
        assert found.governing_pressure >= pressure * 0.99
        return
    assert found.governing_pressure == found.conformal_pressure
    expected = {
        "conformal_pressure": pressure,
        "conformal_half_angle": angle,
        "conformal_half_angle_pin": angle * math.sqrt(R / r),
        "conformal_half_angle_hole": angle * math.sqrt(r / R),
        "conformal_half_length": angle * math.sqrt(r * R),
        "edge_tension": case["hoop_tension_hole_MPa"] * 1e6,
    }
    for name, value in expected.items():
        assert getattr(found, name) == pytest.approx(value, rel=HELD), name


def draw(seed: int) -> tuple[float, float, float]:
    """Dundurs' constants of two random materials, and a load parameter down to no clearance."""
    r = random.Random(seed)
    bodies = [ElasticMaterial(10 ** r.uniform(9, 11.4), r.uniform(0.0, 0.49)) for _ in range(2)]
    alpha, beta = mismatch(first=bodies[0], second=bodies[1])
    least = max(widest_load(alpha=alpha, beta=beta), 0.0)
    return alpha, beta, least + 10 ** r.uniform(-2, 2.5)


@pytest.mark.parametrize("seed", seeds(12))
def test_any_two_materials_agree_with_the_series_of_a_disc_in_a_hole(seed: int) -> None:
    alpha, beta, load_parameter = draw(seed)
    found = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
    angle = 2 * math.atan(found.tangent)
    load, pressure = dissimilar.contact(angle, alpha, beta)
    twice = load_parameter + (1 + alpha) * found.mean_pressure  # 2*G, of which it is a part
    assert 2 / load == pytest.approx(load_parameter, abs=4 * dissimilar.ERROR * twice)
    assert pressure / load == pytest.approx(found.pressure, rel=dissimilar.ERROR)
    tension = edge_tension(
        mean_pressure=found.mean_pressure, tangent=found.tangent, poissons_ratio=0.36
    )
    expected = dissimilar.hoop_tension(angle, alpha, beta, 0.36)
    assert tension == pytest.approx(expected, rel=2 * dissimilar.ERROR)


@pytest.mark.parametrize("seed", seeds(12))
def test_any_two_materials_are_within_the_stated_error(seed: int) -> None:
    alpha, beta, load_parameter = draw(seed)
    found = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
    exact = conformal.of_load(load_parameter, alpha, beta)
    stated = 2 * abs(beta) * ERROR + conformal.ERROR
    assert found.pressure == pytest.approx(exact.pressure, rel=stated)
    assert 2 * math.atan(found.tangent) == pytest.approx(exact.half_angle, rel=stated)
    assert found.mean_pressure == pytest.approx(exact.mean, rel=stated)


@pytest.mark.parametrize(
    ("alpha", "beta"),
    [(1.0, 0.5), (-1.0, -0.5), (0.0, 0.25), (0.0, -0.25), (0.97, 0.21), (0.5, 0.0)],
)
@pytest.mark.parametrize("degrees", [0.1, 3, 20, 45, 70, 80, 90])
def test_the_corners_of_all_materials_are_within_the_stated_error(
    alpha: float, beta: float, degrees: float
) -> None:
    exact = conformal.of_angle(math.radians(degrees), beta)
    load_parameter = exact.load_parameter(alpha)
    if degrees == 90:
        assert widest_load(alpha=alpha, beta=beta) == pytest.approx(load_parameter, abs=2e-9)
        return
    if load_parameter < 0.01:
        return
    found = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
    stated = 2 * abs(beta) * ERROR + conformal.ERROR
    assert found.pressure == pytest.approx(exact.pressure, rel=stated)
    assert 2 * math.atan(found.tangent) == pytest.approx(exact.half_angle, rel=stated)


def test_golden_numbers() -> None:
    """2*G, P_0, P of a beta and a half-angle, from a solution with 800 terms."""
    for beta, degrees, twice, mean, pressure in (
        (0.21, 40, 2.342854012227, 0.169289202566, 0.967842633175),
        (0.21, 80, 0.372208979269, 0.202674417501, 0.608728315630),
        (-0.21, 40, 1.899800600849, 0.169129867041, 0.980378181885),
        (0.5, 40, 2.647015474708, 0.169388664712, 0.960194997748),
    ):
        alpha = -1.0  # of which alone the load parameter is 2*G
        found = conformal_contact(load_parameter=twice, alpha=alpha, beta=beta)
        assert 2 * math.degrees(math.atan(found.tangent)) == pytest.approx(degrees, rel=ERROR)
        assert found.pressure == pytest.approx(pressure, rel=ERROR)
        assert found.mean_pressure == pytest.approx(mean, rel=ERROR)


@pytest.mark.parametrize(("alpha", "beta"), [(0.97, 0.21), (-0.9, -0.4), (0.3, 0.0)])
@pytest.mark.parametrize("degrees", [5, 40, 70])
def test_the_pressure_over_the_angle_carries_the_load(
    alpha: float, beta: float, degrees: float
) -> None:
    half_angle = math.radians(degrees)
    angles = half_angle * np.sin(np.linspace(-np.pi / 2, np.pi / 2, 20001))
    b = math.tan(half_angle / 2)
    shape = pressure_over_angle(angles=angles, tangent=b, beta=beta)
    load = np.trapezoid(shape * np.cos(angles), angles)
    assert 1 / load == pytest.approx(conformal.of_angle(half_angle, beta).pressure, rel=SEARCHED)
    assert shape[[0, 10000, -1]] == pytest.approx([0, 1, 0], abs=1e-7)


@pytest.mark.parametrize("poissons_ratio", [0.05, 0.3, 0.45])
@pytest.mark.parametrize(("beta", "off"), [(0.0, 2e-4), (0.2, 4e-3), (-0.45, 1.5e-2)])
@pytest.mark.parametrize("degrees", [2, 15, 35, 55, 80])
def test_first_yield_is_that_of_the_stresses_around_the_hole(
    degrees: float, beta: float, off: float, poissons_ratio: float
) -> None:
    half_angle = math.radians(degrees)
    expected = dissimilar.yield_factor(half_angle, -1.0, beta, poissons_ratio)
    found = first_yield_factor(half_angle=half_angle, poissons_ratio=poissons_ratio, beta=beta)
    assert found == pytest.approx(expected, rel=off)


@pytest.mark.parametrize(
    ("poissons_ratio", "factors"),
    [
        (0.33, (1.83, 1.70, 1.63, 1.57, 1.49, 1.39, 1.21, 1.06, 0.95)),
        (0.36, (1.86, 1.73, 1.65, 1.59, 1.52, 1.41, 1.24, 1.07, 0.96)),
        (0.38, (1.88, 1.74, 1.67, 1.61, 1.53, 1.43, 1.26, 1.09, 0.97)),
        (0.40, (1.89, 1.75, 1.68, 1.62, 1.55, 1.45, 1.28, 1.10, 0.99)),
    ],
)
def test_first_yield_is_that_of_the_table(
    poissons_ratio: float, factors: tuple[float, ...]
) -> None:
    """Printed from a solution of its own, steel in PLA: to its last digit but one."""
    degrees = np.array([0.0, 6.0, 12.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0])
    found = first_yield_factor(
        half_angle=np.radians(degrees), poissons_ratio=poissons_ratio, beta=0.21
    )
    assert found == pytest.approx(np.array(factors), abs=0.03)


@pytest.mark.parametrize("seed", seeds(12))
def test_the_load_under_a_pressure_is_the_inverse(seed: int) -> None:
    alpha, beta, load_parameter = draw(seed)
    found = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
    parameter = found.pressure / load_parameter
    again = load_under_pressure(pressure_parameter=parameter, alpha=alpha, beta=beta)
    assert again == pytest.approx(load_parameter, rel=SAME)
