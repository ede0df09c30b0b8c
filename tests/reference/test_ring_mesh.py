"""A cycloid mesh against points in the plane at 40 digits, its own energy, and held numbers."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.output.elasticity import HertzLaw, LinearLaw, Shares
from core.precision import EXACT, JUDGED, SAME, SEARCHED
from core.ring.profile import outline_points
from core.ring.sharing import mesh_over_turn, mesh_position
from tests.inputs.classes import force_error, lag_error, play_error
from tests.inputs.ring_meshes import ARCMIN, LAWS, drawn, of_request
from tests.oracles.ring_mesh import Teeth, exact_mesh, virtual_work
from tests.oracles.seeds import seeds

CASES = json.loads((Path(__file__).parent.parent / "oracles/cycloid_mesh_cases.json").read_text())


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"][:3])
def test_held_numbers(case: dict[str, Any]) -> None:
    """Numbers of another program in 40 digits; A4 and A5 are also those of a public program."""
    mesh, angle, torque = of_request(case["body"])
    found, near = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque), case["rtol"]
    expected, ideal = case["expect"]["positions"][0], case["expect"]["geometry"]
    assert mesh.disc.shortening_coefficient == pytest.approx(
        ideal["shortening_coefficient"], rel=near
    )
    assert mesh.disc.min_path_radius * 1e3 == pytest.approx(ideal["min_path_radius_mm"], rel=near)
    assert mesh.disc.undercut_margin == pytest.approx(ideal["undercut_margin"], rel=near)
    most = max(map(max, expected["force_N"]))
    for row, known in zip(found.force, expected["force_N"], strict=True):
        assert row == pytest.approx(known, abs=near * most)
    lags = [each / ARCMIN for each in found.rotation]
    assert lags == pytest.approx(expected["rotation_arcmin"], rel=near)
    assert found.disc_torque == pytest.approx(expected["disc_torque_Nm"], rel=near)
    assert found.crank_across == pytest.approx(expected["crank_across_N"], rel=near)
    assert found.crank_along == pytest.approx(expected["crank_along_N"], rel=near)
    assert found.max_pressure / 1e6 == pytest.approx(expected["max_pressure_MPa"], rel=near)
    if "loaded_pairs" in expected:
        assert found.loaded_pairs == expected["loaded_pairs"]
    if "stiffness_Nm_per_arcmin" in expected:
        stiffness = expected["stiffness_Nm_per_arcmin"]
        assert found.stiffness * ARCMIN == pytest.approx(stiffness, rel=near)
    if "pressed_without_load" in expected:
        assert found.play is None and found.interference == pytest.approx(5e-6, rel=EXACT)
    else:
        limits = [each / ARCMIN for each in found.play]
        assert limits == pytest.approx(expected["play_arcmin"], rel=near, abs=1e-12)


@pytest.mark.parametrize(
    ("name", "peak", "error", "backlash", "angle"),
    [
        ("A2", 1211.06229, 0.03845608, None, None),
        ("A4", 333.54715, 0.05062923, (2.55460087, 2.56426736), 258.6950),
        ("A10", 5958.13936, 0.138003211, None, None),
        ("A12", 1943.59576, None, None, None),
        ("A16", 4255.12905, None, (6.01993, 10.5073), None),
    ],
)
def test_held_numbers_over_the_turn(
    name: str,
    peak: float,
    error: float | None,
    backlash: tuple[float, float] | None,
    angle: float | None,
) -> None:
    """In first order, of grids and zooms of another program."""
    case = next(each for each in CASES if each["name"].split()[0] == name)
    mesh, _, torque = of_request(case["body"])
    found = mesh_over_turn(mesh=replace(mesh, exact=False), output_torque=torque)
    assert found.peak_force == pytest.approx(peak, rel=SEARCHED)
    assert found.accuracy.relative_error < 1e-7
    if error is not None:
        assert found.transmission_error / ARCMIN == pytest.approx(error, rel=SEARCHED)
    if backlash is not None:
        limits = found.backlash_min / ARCMIN, found.backlash_max / ARCMIN
        assert limits == pytest.approx(backlash, rel=JUDGED)
    if angle is not None:  # of equal summits the first
        pitch = 2 * math.pi / mesh.disc.pins
        off = (math.radians(angle) - found.peak_crank_angle) / pitch
        assert off == pytest.approx(round(off), abs=1e-4)


def test_the_peak_of_real_parts_is_many_times_the_ideal_one() -> None:
    case = next(each for each in CASES if each["name"] == "A10")
    mesh, _, torque = of_request(case["body"])
    found = mesh_over_turn(mesh=replace(mesh, exact=False), output_torque=torque)
    assert found.peak_force_ratio == pytest.approx(11.7177, rel=1e-4)


@pytest.mark.parametrize("seed", seeds(4, 8))
def test_forces_lag_and_crank_are_within_their_stated_errors(seed: int) -> None:
    mesh, angle, torque = drawn(seed)
    found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
    exact = exact_mesh(mesh, angle, torque)
    for lag, known in zip(found.rotation, exact.rotation, strict=True):
        assert abs(lag - known) <= lag_error(mesh.disc.ring_pin_circle_radius, found)
    force = [each for row in found.force for each in row]
    for each, known in zip(force, exact.force, strict=True):
        assert abs(each - known) <= force_error(found)
    most = float(max(exact.force))
    assert found.crank_across == pytest.approx([*map(float, exact.across)], abs=1e-9 * most)
    assert found.crank_along == pytest.approx([*map(float, exact.along)], abs=1e-9 * most)
    assert (found.play is None) == (exact.play is None)
    if found.play is not None:
        for limit, known in zip(found.play, exact.play, strict=True):
            assert abs(limit - known) <= play_error(found)


@pytest.mark.parametrize("seed", seeds(2))
def test_given_shares_are_each_disc_by_itself(seed: int) -> None:
    mesh, angle, torque = drawn(4 * seed + 1)
    count = len(mesh.crank_angles)
    weights = [1 + 0.1 * j for j in range(count)]
    shares = Shares(tuple(w / sum(weights) for w in weights))
    mesh = replace(mesh, support=shares)
    found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
    exact = exact_mesh(mesh, angle, torque)
    assert found.rotation == pytest.approx([*map(float, exact.rotation)], rel=SAME)
    force = [each for row in found.force for each in row]
    assert force == pytest.approx([*map(float, exact.force)], abs=1e-9 * max(force))
    assert found.crank_across == pytest.approx([*map(float, exact.across)], rel=EXACT)


@pytest.mark.parametrize("seed", seeds(2, 4))
def test_virtual_work(seed: int) -> None:
    """The torque is the derivative of the stored energy; what the crank gives is its part of the
    torque, and the derivative of the energy by its angle.
    """
    mesh, angle, torque = drawn(100 + seed)
    found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
    by_lag, by_crank = virtual_work(mesh, angle, torque)
    assert float(by_lag) == pytest.approx(torque, rel=EXACT)
    errors = mesh.deviations.eccentricity
    work = sum(
        (mesh.disc.eccentricity + off) * across
        for off, across in zip(errors, found.crank_across, strict=True)
    )
    expected = torque / mesh.disc.satellite_teeth + float(by_crank)
    scale = abs(torque) / mesh.disc.satellite_teeth
    assert work == pytest.approx(expected, abs=1e-8 * scale)
    on_crank = float(mesh.solved([mesh.wave(angle)], torque).input_torque[0])
    assert on_crank == pytest.approx(expected, abs=1e-8 * scale)


@pytest.mark.parametrize("seed", seeds(4))
def test_first_order_is_off_by_squares(seed: int) -> None:
    """Squares of errors, gaps and lag together, so that no sign of any is wrong."""
    mesh, angle, _ = drawn(4 * seed + 200, law=LinearLaw(1e8))
    off = []
    for scale in (1.0, 0.1, 0.01):
        own = mesh.disc.modification
        change = replace(
            own, equidistant=scale * own.equidistant, pin_circle=scale * own.pin_circle
        )
        errors = {
            name: tuple(scale * each for each in getattr(mesh.deviations, name))
            for name in mesh.deviations.__slots__
        }
        less = replace(
            mesh,
            disc=replace(mesh.disc, modification=change),
            deviations=replace(mesh.deviations, **errors),
        )
        lags = [
            mesh_position(
                mesh=replace(less, exact=exact), crank_angle=angle, output_torque=scale * 100.0
            ).rotation[0]
            for exact in (True, False)
        ]
        off.append(abs(lags[0] - lags[1]) / scale)
    assert off[1] < 0.25 * off[0] and off[2] < 0.25 * off[1]
    assert off[0] < 0.2 * abs(lags[0]) / 0.01


@pytest.mark.parametrize("seed", seeds(3))
def test_pins_are_as_far_from_the_drawn_outline_as_is_calculated(seed: int) -> None:
    """The points of the outline, turned onto the ring in the fixed frame."""
    mesh, angle, _ = drawn(300 + 4 * seed, law=LinearLaw(1e8))
    found = outline_points(disc=mesh.disc, chord_error=2e-8)
    points = found.points @ np.array([1, 1j])
    lag = 1e-4
    for j in range(len(mesh.crank_angles)):
        teeth = Teeth(mesh, j, angle)
        turned = np.exp(1j * float(teeth.angle / teeth.z - lag - teeth.late))
        there = points * turned + complex(teeth.centre)
        chord = np.roll(there, -1) - there
        for k in range(mesh.disc.pins):
            pin = complex(teeth.pins[k][0])
            along = np.clip(((pin - there) * chord.conj()).real / abs(chord) ** 2, 0, 1)
            gap = abs(there + along * chord - pin).min() - float(teeth.pins[k][1])
            assert gap == pytest.approx(-float(teeth.pin(k, lag)[0]), abs=2 * found.chord_error)


def test_the_drawn_seeds_are_of_all_kinds() -> None:
    drawn_discs = [drawn(seed) for seed in range(16)]
    assert {type(mesh.law) for mesh, _, _ in drawn_discs} == {type(law) for law in LAWS}
    assert any(mesh.disc.undercut_margin < 1.06 for mesh, _, _ in drawn_discs)
    assert any(mesh.disc.shortening_coefficient > 0.9 for mesh, _, _ in drawn_discs)
    assert any(mesh.disc.pins <= 12 for mesh, _, _ in drawn_discs)
    assert any(isinstance(mesh.law, HertzLaw) for mesh, _, _ in drawn_discs)
