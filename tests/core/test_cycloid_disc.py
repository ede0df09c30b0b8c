"""The outline of a cycloid disc: by the tool that cuts it, by scans, by its points."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest
from mpmath import mpf, sqrt, workdps

from core.errors import InvalidInput
from core.precision import CONVERGED, EXACT, SAME, SEARCHED
from core.ring import profile
from core.ring.profile import CycloidDisc, Modification, outline_points
from tests.inputs.ring_meshes import disc_of
from tests.oracles.seeds import seeds

GOLDEN = (math.sqrt(5) - 1) / 2

DISC = CycloidDisc(11, 2.5e-3, 0.05, 0.005)


def path(disc: CycloidDisc, t: np.ndarray) -> np.ndarray:
    """The tool's centre in the disc's frame, while the crank turns clockwise by z*t, and the disc
    the other way by t.
    """
    tool = 1j * (disc.ring_pin_circle_radius + disc.modification.pin_circle)
    centre = 1j * disc.eccentricity * np.exp(-1j * disc.satellite_teeth * t)
    return (tool - centre) * np.exp(-1j * t)


@pytest.mark.parametrize("seed", seeds(12))
def test_the_tool_touches_the_outline_and_cuts_nothing_off(seed: int) -> None:
    """The distance of each point from the tool's path is the tool's radius, by a search."""
    disc = disc_of(random.Random(seed), kind=seed % 4)
    t = 2 * math.pi / disc.satellite_teeth * np.linspace(0, 1, 37)
    centres = np.linspace(-0.5, 1.5, 4001) * 2 * math.pi / disc.satellite_teeth
    step = centres[1] - centres[0]
    for point in disc.outline(t):
        apart = np.abs(path(disc, centres) - point)
        low, high = centres[apart.argmin()] - step, centres[apart.argmin()] + step
        for _ in range(80):  # golden section
            a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
            one, other = np.abs(path(disc, np.array([a, b])) - point)
            low, high = (low, b) if one < other else (a, high)
        least = abs(path(disc, np.array([low]))[0] - point)
        assert least == pytest.approx(disc.tool_radius, abs=1e-15)


@pytest.mark.parametrize("seed", seeds(12))
def test_radii_of_curvature_by_a_scan(seed: int) -> None:
    disc = disc_of(random.Random(seed), kind=seed % 4)
    t = math.pi / disc.satellite_teeth * np.linspace(0, 1, 20_001)
    step = 1e-3 / disc.satellite_teeth
    low, here, high = (path(disc, t + off) for off in (-step, 0, step))
    first, second = (high - low) / (2 * step), (high - 2 * here + low) / step**2
    bend = -(first.conj() * second).imag / np.abs(first) ** 3
    assert np.allclose(disc.path_curvature(t), bend, rtol=1e-4, atol=1e-2)
    exact = disc.path_curvature(t)
    assert disc.min_path_radius == pytest.approx(1 / exact.max(), rel=SEARCHED)
    assert disc.min_path_radius <= 1 / exact.max() * (1 + 1e-14)
    assert disc.undercut_margin == disc.min_path_radius / disc.tool_radius
    own = disc.curvature(t)
    assert np.allclose(own * (1 / exact - disc.tool_radius), 1, rtol=EXACT)
    if own.min() < 0:
        assert disc.min_concave_radius == pytest.approx(-1 / own.min(), rel=SAME)


def sizes_at_40_digits(disc: CycloidDisc) -> dict[str, mpf]:
    """Radii by the sizes as they are typed."""
    e, own = mpf(disc.eccentricity), disc.modification
    radius = mpf(disc.ring_pin_circle_radius) + mpf(own.pin_circle)
    tool, lobes = mpf(disc.ring_pin_radius) + mpf(own.equidistant), disc.satellite_teeth
    k, pins = e * (lobes + 1) / radius, lobes + 1
    flank = radius * sqrt(27 * (1 - k * k) * lobes / mpf(pins + 1) ** 3)
    tip = radius * (1 + k) ** 2 / (1 + pins * k)
    bend = flank if k > mpf(pins - 2) / (2 * pins - 1) else tip
    found = {"min_path_radius": bend, "undercut_margin": bend / tool}
    found |= {"tip_radius": radius + e - tool, "root_radius": radius - e - tool}
    if pins * k > 1:
        found["min_concave_radius"] = tool + radius * (1 - k) ** 2 / (pins * k - 1)
    return found


@pytest.mark.parametrize("seed", seeds(40))
def test_sizes_are_as_good_as_they_say(seed: int) -> None:
    """Also where the path nearly has a cusp, hardly bends inwards, or where no root is left."""
    rng = random.Random(seed)
    lobes, radius = rng.randint(2, 120), rng.uniform(0.01, 0.3)
    near = 10 ** -rng.uniform(1, 14)
    k = {0: 1 - near, 1: (1 + near) / (lobes + 1)}.get(seed % 4, rng.uniform(0.01, 0.99))
    e = k * radius / (lobes + 1)
    tool = (radius - e) * (1 - near) if seed % 4 == 2 else rng.uniform(1e-4, 0.1) * radius
    disc = CycloidDisc(lobes, e, radius, tool, Modification(rng.uniform(-1e-5, 1e-5)))
    with workdps(40):
        for name, exact in sizes_at_40_digits(disc).items():
            off = abs(mpf(getattr(disc, name)) / exact - 1)
            assert off <= disc.accuracy.relative_error, name


def test_a_disc_with_a_short_crank_is_convex_all_around() -> None:
    disc = CycloidDisc(11, 0.3e-3, 0.05, 0.005)
    assert disc.min_concave_radius is None and disc.valley_radius == math.inf
    assert (disc.curvature(np.linspace(0, 1, 999)) > 0).all()
    low = (1 + disc.shortening) ** 2 / (1 + disc.pins * disc.shortening)
    assert disc.min_path_radius == pytest.approx(0.05 * low, rel=SAME)


def test_radii_of_tips_and_roots() -> None:
    disc = replace(DISC, modification=Modification(2e-5, -1e-5))
    radii = np.abs(disc.outline(2 * math.pi * np.arange(24) / 22))
    assert disc.tip_radius == pytest.approx(radii.max(), rel=CONVERGED)
    assert disc.root_radius == pytest.approx(radii.min(), rel=CONVERGED)
    assert disc.root_radius == pytest.approx(0.05 - 2.5e-3 - 0.005 - 3e-5, rel=SAME)


@pytest.mark.parametrize("seed", seeds(6))
@pytest.mark.parametrize("error", [1e-3, 1e-4, 1e-6, 1e-7])
def test_points_are_as_near_as_is_said(seed: int, error: float) -> None:
    disc = disc_of(random.Random(seed), kind=seed % 4)
    found = outline_points(disc=disc, chord_error=error)
    points = found.points @ np.array([1, 1j])
    each, left = divmod(len(points), disc.satellite_teeth)
    assert left == 0 and each >= 4
    assert points[0] == pytest.approx(1j * disc.root_radius, abs=1e-15)
    assert abs(points[0] - points[-1]) > 1e-9
    lobes = points.reshape(disc.satellite_teeth, each)
    turned = (
        lobes
        * np.exp(2j * math.pi / disc.satellite_teeth * np.arange(disc.satellite_teeth))[:, None]
    )
    k, z = disc.shortening, disc.satellite_teeth  # angles up to 2*pi, z times as large, are rounded
    rounded = 2 * 2**-52 * 2 * math.pi * (disc.tip_radius + disc.tool_radius * z * k / (1 - k))
    assert turned == pytest.approx(np.broadcast_to(lobes[0], lobes.shape), abs=rounded)
    assert found.chord_error <= error
    count = len(points)
    ends = np.append(points, points[0])[: each + 1]
    fine = disc.outline(2 * math.pi / count * np.linspace(0, each, 64 * each + 1))
    chords = np.diff(ends).repeat(64)
    aside = np.abs(((fine[:-1] - ends[:-1].repeat(64)) * chords.conj()).imag) / np.abs(chords)
    assert aside.max() <= found.chord_error * (1 + 1e-5)
    assert aside.max() >= found.chord_error * (1 - 1e-3)
    fewer = outline_points(disc=disc, chord_error=4 * error)
    assert len(fewer.points) == pytest.approx(count / 2, abs=2 * disc.satellite_teeth)


def test_too_many_points_are_refused_with_the_least_error_that_is_possible() -> None:
    with pytest.raises(InvalidInput) as caught:
        outline_points(disc=DISC, chord_error=1e-16)
    assert (caught.value.parameter, caught.value.code) == ("chord_error", "greater_than_equal")
    least = float(caught.value.params["limit"])
    found = outline_points(disc=DISC, chord_error=least)
    assert profile.MOST_POINTS - DISC.satellite_teeth <= len(found.points) <= profile.MOST_POINTS
    assert found.chord_error <= least * (1 + 1e-6)


@pytest.mark.parametrize(
    ("changes", "name", "code"),
    [
        ({"satellite_teeth": 1}, "satellite_teeth", "greater_than_equal"),
        ({"eccentricity": 0.0}, "eccentricity", "greater_than"),
        ({"ring_pin_radius": math.inf}, "ring_pin_radius", "finite_number"),
        ({"eccentricity": 0.005}, "ring_pin_circle_radius", "no_cycloid"),
        ({"modification": Modification(pin_circle=-0.03)}, "pin_circle", "greater_than"),
        ({"modification": Modification(equidistant=-0.006)}, "equidistant", "greater_than"),
        ({"modification": Modification(rotation=-0.1)}, "rotation", "greater_than_equal"),
    ],
)
def test_what_cannot_be_is_refused(changes: dict, name: str, code: str) -> None:
    with pytest.raises(InvalidInput) as caught:
        replace(DISC, **changes)
    assert (caught.value.parameter, caught.value.code) == (name, code)


def test_an_undercut_disc_has_no_outline() -> None:
    wide = replace(DISC, ring_pin_radius=DISC.min_path_radius)
    with pytest.raises(InvalidInput) as caught:
        outline_points(disc=wide, chord_error=1e-5)
    assert (caught.value.parameter, caught.value.code) == ("ring_pin_radius", "undercut")
    assert caught.value.params["limit"] == DISC.min_path_radius
    near = replace(DISC, ring_pin_radius=DISC.min_path_radius * (1 - 1.1e-9))
    assert outline_points(disc=near, chord_error=1e-5).chord_error <= 1e-5
