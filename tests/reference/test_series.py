"""Ring and output in series against 40 digits of statics in the plane, and held numbers."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from core.precision import EXACT
from core.ring.series import series_position
from tests.inputs.classes import force_error, lag_error, play_error
from tests.inputs.ring_meshes import ARCMIN
from tests.inputs.series import drawn, of_request
from tests.oracles.seeds import seeds
from tests.oracles.series import exact_play, exact_series

CASES = json.loads((Path(__file__).parent.parent / "oracles/series_cases.json").read_text())


def flat(rows: Any) -> list[float]:
    return [each for row in rows for each in row]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"][:2])
def test_held_numbers(case: dict[str, Any]) -> None:
    """Numbers of another program in 40 digits, in first order too."""
    series, angle, torque = of_request(case["body"])
    found = series_position(real=series, crank_angle=angle, output_torque=torque)
    expected, near = case["expect"]["positions"][0], case["rtol"]
    ring = expected["ring"]
    for rows, known in ((found.force, expected), (found.ring.force, ring)):
        most = max(flat(known["force_N"]))
        assert flat(rows) == pytest.approx(flat(known["force_N"]), abs=near * most)
    assert found.rotation / ARCMIN == pytest.approx(expected["rotation_arcmin"], rel=near)
    lags = [each / ARCMIN for each in found.ring.rotation]
    assert lags == pytest.approx(ring["rotation_arcmin"], rel=near)
    assert found.satellite_torque == pytest.approx(expected["satellite_torque_Nm"], rel=near)
    assert found.ring.disc_torque == pytest.approx(ring["disc_torque_Nm"], rel=near)
    assert found.ring.crank_across == pytest.approx(ring["crank_across_N"], rel=near)
    assert found.ring.crank_along == pytest.approx(ring["crank_along_N"], rel=near)
    stiffness = expected["stiffness_Nm_per_arcmin"]
    assert found.stiffness * ARCMIN == pytest.approx(stiffness, rel=near)
    limits = [each / ARCMIN for each in (*found.play, *flat(found.ring.play))]
    known = [*expected["play_arcmin"], *flat(ring["play_arcmin"])]
    assert limits == pytest.approx(known, rel=near)
    counts = found.loaded_pairs, found.ring.loaded_pairs
    assert counts == (expected["loaded_pairs"], ring["loaded_pairs"])


@pytest.mark.parametrize("seed", seeds(3, 8))
def test_forces_and_lags_are_within_their_stated_errors(seed: int) -> None:
    series, angle, torque = drawn(seed)
    found = series_position(real=series, crank_angle=angle, output_torque=torque)
    exact = exact_series(series, angle, torque, (found.rotation, [*found.ring.rotation]))
    for lag, known in zip(
        (found.rotation, *found.ring.rotation), (exact.rotation, *exact.lags), strict=True
    ):
        assert abs(lag - known) <= lag_error(series.output.pin_circle_radius, found)
    forces, known = flat(found.force) + flat(found.ring.force), exact.force + exact.ring_force
    for force, each in zip(forces, known, strict=True):
        assert abs(force - each) <= force_error(found)
    size = abs(torque)
    assert found.satellite_torque == pytest.approx([*map(float, exact.torques)], abs=1e-9 * size)
    assert found.input_torque == pytest.approx(
        float(exact.input_torque), rel=EXACT * series.mechanism.ratio
    )
    most = float(max(known))
    assert found.ring.crank_across == pytest.approx([*map(float, exact.across)], abs=1e-9 * most)
    assert found.ring.crank_along == pytest.approx([*map(float, exact.along)], abs=1e-9 * most)
    crank = [math.hypot(*each) for each in exact.on_crank]
    assert found.crank_force == pytest.approx(crank, abs=1e-9 * most)
    for limit, known in zip(found.play, exact_play(series, angle), strict=True):
        assert abs(limit - known) <= play_error(found)


def test_a_small_load_on_contacts_that_only_just_touch() -> None:
    """Contacts are so soft there that a step of Newton would lead turns away."""
    series, _, _ = of_request(CASES[2]["body"])
    angle, torque = 121.05603691832671, 12.6
    found = series_position(real=series, crank_angle=angle, output_torque=torque)
    exact = exact_series(series, angle, torque, (found.rotation, [*found.ring.rotation]))
    assert abs(found.rotation - exact.rotation) <= lag_error(series.output.pin_circle_radius, found)
    assert found.play[1] < found.rotation < 2 * found.play[1]
