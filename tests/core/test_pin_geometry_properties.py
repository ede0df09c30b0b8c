"""Invariants of pins, holes and contact points."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.output.mechanism import Mechanism, PinGeometry, pin_fit, pin_geometry

angles = st.one_of(st.floats(-20.0, 20.0), st.integers(-48, 48).map(lambda k: math.radians(15 * k)))

OF_THE_CIRCLE = {"wall_holes", "pins_apart", "pins_like_crankshafts"}
"""Notices that the circle of the pins is needed for."""


@st.composite
def mechanisms(draw: st.DrawFn) -> Mechanism:
    return Mechanism(
        pins=draw(st.integers(1, 13)),
        crank_angles=tuple(draw(st.lists(angles, min_size=1, max_size=6))),
        ratio=draw(st.one_of(st.just(20.0), st.floats(0.1, 1000.0))),
        initial_crank_angle=draw(angles),
    )


@st.composite
def sizes(draw: st.DrawFn) -> dict[str, float]:
    """Radii that fit: the hole as large as pin and eccentricity need."""
    eccentricity = draw(st.floats(1e-4, 5e-3))
    pin_radius = draw(st.floats(1e-3, 2e-2))
    return {
        "pin_circle_radius": draw(st.floats(0.03, 0.3)),
        "pin_radius": pin_radius,
        "hole_radius": pin_radius + eccentricity,
        "eccentricity": eccentricity,
    }


@given(mechanisms(), st.floats(-50.0, 50.0), sizes())
def test_pressure_angle_is_that_between_force_and_velocity(
    mechanism: Mechanism, phi: float, size: dict[str, float]
) -> None:
    found = pin_geometry(mechanism=mechanism, crank_angle=phi, **size)
    # the pins turn against the crank, from Y towards -X: velocity (-y, x) of a left turn
    radius = size["pin_circle_radius"]
    velocity = np.stack((-found.pin_centres[:, 1], found.pin_centres[:, 0]), axis=-1) / radius
    push = (found.pin_centres - found.contact_points) / size["pin_radius"]
    cosine = (push * velocity).sum(axis=2)
    assert np.cos(found.pressure_angles) == pytest.approx(cosine, abs=1e-12)
    assert (np.abs(found.pressure_angles) <= math.pi + 1e-15).all()
    sure = np.abs(cosine) > 1e-10
    assert (found.driving == (cosine > 0))[sure].all()
    psi = phi * (1 + 1 / mechanism.ratio) + mechanism.initial_crank_angle
    pin = 2 * math.pi * np.arange(mechanism.pins) / mechanism.pins
    wave = psi + np.add.outer(mechanism.crank_angles, pin)
    # phi up to 50 rad at ratios down to 0.1: 550 rad of wave, 1e-13 of it rounding
    assert cosine == pytest.approx(-np.sin(wave), abs=5e-12)


def fitted(pin_radius: float, hole_radius: float, eccentricity: float) -> PinGeometry:
    return pin_geometry(
        mechanism=Mechanism.evenly_spaced(pins=4, satellites=2, ratio=20.0),
        crank_angle=0.3,
        pin_circle_radius=0.05,
        pin_radius=pin_radius,
        hole_radius=hole_radius,
        eccentricity=eccentricity,
    )


@given(st.integers(1000, 20000), st.integers(100, 5000), st.sampled_from([-50, -2, -1, 1, 2, 50]))
def test_fit_in_whole_micrometres_is_told_apart(pin: int, e: int, off: int) -> None:
    # radii as a drawing gives them: whole micrometres, a decimal rounding away from a double
    exact = fitted(pin * 1e-6, (pin + e) * 1e-6, e * 1e-6)
    assert exact.clearance == 0.0
    codes = {n.code for n in exact.notices}
    assert not codes & {"clearance", "interference"}
    other = fitted(pin * 1e-6, (pin + e + off) * 1e-6, e * 1e-6)
    assert other.clearance == pytest.approx(off * 1e-6, abs=1e-16)
    codes = {n.code for n in other.notices}
    assert ("clearance" in codes) == (off > 0)
    assert ("interference" in codes) == (off < 0)


@given(mechanisms(), st.floats(-5.0, 5.0), sizes(), st.floats(1e-6, 1e-3))
def test_clearance_leaves_the_pin_off_the_wall(
    mechanism: Mechanism, phi: float, size: dict[str, float], clearance: float
) -> None:
    size = size | {"hole_radius": size["hole_radius"] + clearance}
    found = pin_geometry(mechanism=mechanism, crank_angle=phi, **size)
    assert found.clearance == pytest.approx(clearance, abs=1e-16)
    # the nearest point of the pin keeps just the clearance from the wall
    from_hole = np.linalg.norm(found.contact_points - found.hole_centres, axis=2)
    assert size["hole_radius"] - from_hole == pytest.approx(clearance, abs=1e-14)


@pytest.mark.parametrize(
    ("parameter", "value"),
    [
        ("pin_radius", 0.0),
        ("pin_radius", -1e-3),
        ("pin_radius", math.nan),
        ("eccentricity", 0.0),
        ("pin_circle_radius", 0.0),
        ("hole_radius", 0.006),
        ("hole_radius", 0.004),
        ("hole_radius", math.nan),
        ("crank_angle", math.inf),
        ("crank_angle", math.nan),
    ],
)
def test_sizes_that_cannot_be_are_refused_by_name(parameter: str, value: float) -> None:
    size = {
        "crank_angle": 0.0,
        "pin_circle_radius": 0.05,
        "pin_radius": 0.006,
        "hole_radius": 0.008,
        "eccentricity": 0.002,
    }
    mechanism = Mechanism.evenly_spaced(pins=4, satellites=2, ratio=20.0)
    with pytest.raises(InvalidInput) as refusal:
        pin_geometry(mechanism=mechanism, **(size | {parameter: value}))
    assert refusal.value.parameter == parameter


@given(mechanisms(), sizes(), st.floats(-1e-3, 1e-3))
def test_the_fit_needs_no_crank_angle(
    mechanism: Mechanism, size: dict[str, float], off: float
) -> None:
    size = size | {"eccentricity": max(size["eccentricity"] + off, 1e-6)}
    fit = pin_fit(pins=mechanism.pins, **size)
    found = pin_geometry(mechanism=mechanism, crank_angle=1.0, **size)
    assert (fit.clearance, fit.notices) == (found.clearance, found.notices)
    # without the circle, and without the eccentricity, what these would say is not said
    del size["pin_circle_radius"]
    alone = pin_fit(pins=mechanism.pins, **size)
    assert alone.notices == tuple(n for n in fit.notices if n.code not in OF_THE_CIRCLE)
    del size["eccentricity"]
    assumed = pin_fit(pins=mechanism.pins, **size)
    assert assumed.clearance == 0.0
    assert [n.code for n in assumed.notices] == ["eccentricity_assumed"]


@given(st.integers(2, 60), st.integers(20, 400), st.sampled_from([-20, -2, 0, 2, 20]))
def test_neighbours_overlap_from_touching_on(pins: int, radius: int, off: int) -> None:
    # circles whose centres lie 2*radius + off micrometres apart touch at off = 0
    circle = (2 * radius + off) * 1e-6 / 2 / math.sin(math.pi / pins)
    size = {"pin_circle_radius": circle, "eccentricity": 1e-6}
    radius_m = radius * 1e-6
    holes = pin_fit(pins=pins, pin_radius=radius_m / 2, hole_radius=radius_m, **size)
    assert ("wall_holes" in {n.code for n in holes.notices}) == (off <= 0)
    both = pin_fit(pins=pins, pin_radius=radius_m, hole_radius=radius_m * 1.5, **size)
    assert ("pins_apart" in {n.code for n in both.notices}) == (off <= 0)
