"""Both meshes over all turns of the crank: known turns of one stage, a dense walk, refusals."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest

from core.drive.engine import LOST
from core.errors import InvalidInput
from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT, SEARCHED
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries
from core.ring.series_turn import SeriesTurn, series_over_turn
from core.ring.sharing import CycloidMesh, RingDeviations, mesh_over_turn
from tests.inputs.real_mechanisms import STEEL

DISC = CycloidDisc(7, 2.5e-3, 0.04, 0.004, Modification(2e-5, -1e-5))
RING = RingDeviations(
    (2e-6, 0.0, -3e-6, 1e-6, 0.0, -2e-6, 4e-6, 0.0), (0.0, 3e-6, 0.0, -2e-6, 1e-6, 0.0, 0.0, -1e-6)
)
HOLES = Deviations((1e-6, 0.0, -2e-6, 3e-6, 0.0), (0.0, -2e-6, 0.0, 1e-6, 2e-6))
PHASES: dict[str, Any] = {"disc_phase": (2e-5, -3e-5), "eccentricity": (1e-6, -2e-6)}


def series_of(*, discs: int, exact: bool, **phases: Any) -> MeshesInSeries:
    angles = tuple(2 * math.pi * j / discs for j in range(discs))
    given: dict[str, Any] = {"contact_length": 0.01, "law": LinearLaw(1e8), "exact": exact}
    ring = CycloidMesh(
        disc=DISC,
        crank_angles=angles,
        pin_material=STEEL,
        disc_material=STEEL,
        deviations=replace(RING, **phases),
        **given,
    )
    output = RealMechanism(
        mechanism=Mechanism(5, angles, 7.0, 0.4),
        pin_circle_radius=0.022,
        pin_radius=0.003,
        eccentricity=2.5e-3,
        clearance=1e-5,
        pin_material=STEEL,
        hole_material=STEEL,
        deviations=replace(HOLES, **phases),
        **given,
    )
    return MeshesInSeries(ring, output)


def test_of_one_disc_in_first_order_each_stage_has_its_own_peaks() -> None:
    """Found over other turns, by other grids; lags that both add are no larger than their sums."""
    series = series_of(discs=1, exact=False)
    turn = series_over_turn(real=series, output_torque=80.0)
    teeth = mesh_over_turn(mesh=series.ring, output_torque=80.0)
    holes = over_turn(real=series.output, output_torque=80.0)
    near = turn.accuracy.relative_error + holes.accuracy.relative_error
    assert turn.peak_force == pytest.approx(holes.peak_force, rel=near + 1e-12) and near < 1e-4
    assert turn.peak_pair == holes.peak_pair
    assert turn.ring.peak_force == pytest.approx(
        teeth.peak_force, rel=SEARCHED + teeth.accuracy.relative_error
    )
    assert turn.ring.peak_pair == teeth.peak_pair
    assert turn.ring.max_pressure == pytest.approx(teeth.max_pressure, rel=1e-4)
    for name in (
        "backlash_max",
        "transmission_error",
        "unloaded_transmission_error",
        "lost_motion",
    ):
        whole, parts = getattr(turn, name), getattr(teeth, name) + getattr(holes, name)
        assert 0.5 * parts < whole <= parts * (1 + 1e-9)
    assert turn.backlash_min >= (teeth.backlash_min + holes.backlash_min) * (1 - 1e-9)
    softest = 1 / (1 / teeth.stiffness_min + 1 / holes.stiffness_min)
    assert softest * (1 - 1e-9) <= turn.stiffness_min <= turn.stiffness_max
    assert turn.loaded_pairs_min >= 1 and turn.ring.loaded_pairs_max >= 2
    assert turn.max_pressure == pytest.approx(holes.max_pressure, rel=1e-4)


@pytest.mark.parametrize(("exact", "torque"), [(True, 160.0), (False, -160.0)])
def test_the_summits_against_a_dense_walk(exact: bool, torque: float) -> None:
    """On places of its own, many times as many: nothing is higher there, and hardly less."""
    series = series_of(discs=2, exact=exact, **PHASES)
    turn = series_over_turn(real=series, output_torque=torque)
    walk = SeriesTurn(series, torque)
    count = 8_009
    places = (np.arange(count) + 0.3) * (walk.period / count)
    rows = walk.poses(places.tolist())
    lost = walk.values(LOST, places[::4].tolist()).heights
    play = rows["high"] - rows["low"]
    rough = 0.01  # of kinks and cusps, which a walk does not meet
    for found, there, near in (
        (turn.peak_force, rows["force"], 1e-4),
        (turn.ring.peak_force, rows["mesh_force"], 1e-3),
        (turn.backlash_max, play, 1e-3),
        (turn.lost_motion, lost, 1e-3),
        (turn.transmission_error, np.array([np.ptp(rows["lag"])]), rough),
        (turn.unloaded_transmission_error, np.array([np.ptp(rows["high"])]), rough),
        (turn.input_torque_ripple, np.array([np.ptp(rows["input_torque"])]), rough),
    ):
        most = there.max()
        assert most * (1 - 1e-9) <= found <= most * (1 + near)
    assert play.min() * (1 - 1e-3) <= turn.backlash_min <= play.min() * (1 + 1e-9)
    stiff, unsure = rows["stiffness"], 1e-9
    assert stiff.max() * (1 - unsure) <= turn.stiffness_max <= stiff.max() * (1 + rough)
    assert stiff.min() * (1 - rough) <= turn.stiffness_min <= stiff.min() * (1 + unsure)
    for place, name, most in (
        (turn.peak_crank_angle, "force", turn.peak_force),
        (turn.ring.peak_crank_angle, "mesh_force", turn.ring.peak_force),
    ):
        assert walk.poses([place])[name][0] == pytest.approx(most, rel=EXACT)
    assert turn.accuracy.relative_error < 1e-3
    for name in ("mesh_force", "lag"):  # after all turns, and not before
        one, whole, again = walk.poses([0.2, 0.2 + 2 * math.pi, 0.2 + walk.period])[name]
        assert again == pytest.approx(one, rel=EXACT) and whole != pytest.approx(one, rel=1e-3)


def test_parts_that_press_have_no_backlash() -> None:
    tight = series_of(discs=1, exact=False)
    tight = replace(tight, output=replace(tight.output, clearance=-1e-5))
    turn = series_over_turn(real=tight, output_torque=80.0)
    assert turn.pressed_without_load and turn.unloaded_transmission_error == 0
    assert "pressed_without_load" in [each.code for each in turn.notices]


@pytest.mark.parametrize("stage", ["output pins", "ring alone", "both meshes"])
@pytest.mark.parametrize(
    ("torque", "share", "name"),
    [
        (0.0, 0.03, "output_torque"),
        (math.nan, 0.03, "output_torque"),
        (1.0, 0.0, "lost_motion_share"),
        (1.0, 1.1, "lost_motion_share"),
    ],
)
def test_what_is_out_of_range_is_refused(
    stage: str, torque: float, share: float, name: str
) -> None:
    series = series_of(discs=1, exact=False)
    solve: Callable[..., Any] = {
        "output pins": partial(over_turn, real=series.output),
        "ring alone": partial(mesh_over_turn, mesh=series.ring),
        "both meshes": partial(series_over_turn, real=series),
    }[stage]
    with pytest.raises(InvalidInput, match=name):
        solve(output_torque=torque, lost_motion_share=share)
