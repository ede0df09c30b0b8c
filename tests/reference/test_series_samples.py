"""Forces of both meshes over the turn, against 40 digits of statics, and over walks.

The sums of a position are those of points in the plane; that pins which are alike change places,
after how much of a turn, is held against forces there and against turns that are walked whole.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries, series_position
from core.ring.series_samples import sampled_in_series
from core.ring.series_teeth import TeethInSeries
from core.ring.series_turn import SeriesTurn, series_over_turn
from core.ring.sharing import CycloidMesh, RingDeviations
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.series import drawn
from tests.oracles.series import exact_series


def bare(seed: int, *, ring: bool = False, pins: bool = False, **given: Any) -> tuple[Any, float]:
    """Drawn meshes whose ring, or whose pins and holes, have no errors, and a torque."""
    series, _, torque = drawn(seed, **given)
    shared = {
        name: getattr(series.ring.deviations, name)
        for name in ("eccentricity", "crank_phase", "disc_phase")
    }
    teeth, output = series.ring, series.output
    if ring:
        teeth = replace(teeth, deviations=RingDeviations(**shared))
    if pins:
        output = replace(output, deviations=Deviations(**shared))
    return MeshesInSeries(teeth, output), torque


@pytest.mark.parametrize(("seed", "alike"), [(1, True), (2, False), (5, True)])
def test_samples_are_the_forces_of_their_places(seed: int, alike: bool) -> None:
    series, torque = bare(seed, ring=True, pins=alike)
    found = sampled_in_series(SeriesTurn(series, torque))
    own = series.mechanism
    assert found.error < 1e-3 and found.waves == 1
    for k in range(3, len(found.wave), len(found.wave) // 3):
        angle = float(found.wave[k] - own.initial_crank_angle) / own.waves_per_turn
        near = series_position(real=series, crank_angle=angle, output_torque=torque)
        exact = exact_series(series, angle, torque, (near.rotation, [*near.ring.rotation]))
        most = float(max(exact.force + exact.ring_force))
        crank = [complex(-float(out), float(across)) for out, across in exact.on_crank]
        both = found.of_ring[:, k] + found.on_satellites[:, k]
        assert np.abs(both - crank).max() < 1e-8 * most
        ring = [complex(a, b) for a, b in zip(exact.along, exact.across, strict=True)]
        assert np.abs(found.of_ring[:, k] - ring).max() < 1e-8 * most
        on_pins = np.abs(found.on_pins[:, :, k]).ravel() - np.array(exact.force, dtype=float)
        assert np.abs(on_pins).max() < 1e-8 * most
        couple = np.array(exact.torques, dtype=float)
        assert np.abs(found.couple[:, k] - couple).max() < 1e-7 * abs(torque)
        if alike:  # about the axis, by the parts along the circle of the pins
            turned = series.output.pin_circle_radius * found.on_pins[:, :, k].real.sum()
            assert turned == pytest.approx(torque, rel=EXACT)


@pytest.mark.parametrize("lobes_and_pins", [(20, 8), (12, 6), (9, 7)])
@pytest.mark.parametrize("errors", ["none", "of the ring", "of the output"])
def test_pins_that_are_alike_change_places(lobes_and_pins: tuple[int, int], errors: str) -> None:
    """After a period, and after no prime part of it."""
    series, torque = meshes(*lobes_and_pins, errors), 60.0
    turn = SeriesTurn(series, torque)
    pins, satellites = lobes_and_pins[1], series.mechanism.satellites
    first, later = turn.poses([0.37, 0.37 + turn.period])["forces"]
    moved = np.roll(first.reshape(satellites, pins), -turn.step, axis=1).ravel()
    assert np.abs(moved - later).max() < 1e-9 * first.max()
    count = turn.pitches
    for prime in {each for each in (2, 3, 5, 7) if count % each == 0}:
        sooner = np.sort(turn.poses([0.37 + turn.period / prime])["forces"])
        assert np.abs(sooner - np.sort(first)).max() > 1e-5 * first.max()
    whole = 2 * math.pi * lobes_and_pins[0]
    assert round(whole / turn.period, 9) == round(whole / turn.period)


def meshes(lobes: int, pins: int, errors: str) -> MeshesInSeries:
    """Two discs of a number of lobes, on so many pins."""
    own = Mechanism.evenly_spaced(pins=pins, satellites=2, ratio=float(lobes))
    e, law = 0.03 / (lobes + 1), LinearLaw(1e8)
    off = [1e-6 * ((7 * k * k) % 11 - 5) for k in range(lobes + 1)]
    ring = CycloidMesh(
        disc=CycloidDisc(lobes, e, 0.05, 0.003, Modification(1e-5)),
        crank_angles=own.crank_angles,
        contact_length=0.01,
        law=law,
        deviations=RingDeviations(tuple(off)) if errors == "of the ring" else RingDeviations(),
        pin_material=STEEL,
        disc_material=STEEL,
    )
    output = RealMechanism(
        mechanism=own,
        pin_circle_radius=0.03,
        pin_radius=0.004,
        eccentricity=e,
        contact_length=0.01,
        clearance=1e-5,
        law=law,
        deviations=Deviations(tuple(off[:pins])) if errors == "of the output" else Deviations(),
        pin_material=STEEL,
        hole_material=STEEL,
    )
    return MeshesInSeries(ring, output)


@pytest.mark.parametrize(
    ("errors", "unlike"), [("none", 3), ("of the ring", 3), ("of the output", 6)]
)
def test_over_a_period_crank_and_unlike_pins_have_all_that_there_is(
    errors: str, unlike: int
) -> None:
    """The crank its part of the load, the first pins what any other has."""
    series, torque = meshes(8, 6, errors), 60.0
    turn = SeriesTurn(series, torque)
    found = sampled_in_series(turn)
    assert found.waves == (9 if errors == "of the ring" else 1)
    near, far = found.on_pins
    most = np.abs(near + 2 * far).max(axis=1)  # as the moment of a pin
    assert most == pytest.approx(np.tile(most[:unlike], 6 // unlike), rel=EXACT)
    assert found.unlike == unlike and len({round(each, 3) for each in most}) == unlike
    across = found.mean((found.of_ring + found.on_satellites).imag).sum()
    assert across * series.output.eccentricity * 8 == pytest.approx(torque, rel=1e-4)
    assert found.wave[-1] - found.wave[0] < found.period <= found.wave[-1] - found.wave[0] + 0.1


def test_the_teeth_in_series_are_those_of_a_walk() -> None:
    series, torque = meshes(9, 6, "none"), 60.0
    over = series_over_turn(real=series, output_torque=torque)
    teeth = TeethInSeries(over)
    turn, disc = SeriesTurn(series, torque), series.ring.disc
    angles = (np.arange(2003) + 0.5) * (2 * math.pi * 9 / 2003)  # all turns, not a period alone
    rows = turn.poses(angles.tolist())
    assert teeth.peak_force == pytest.approx(rows["mesh_force"].max(), rel=1e-3)
    assert teeth.peak_force >= rows["mesh_force"].max() * (1 - 1e-9)
    assert over.peak_force == pytest.approx(rows["force"].max(), rel=1e-3)
    unit = torque / (2 * 9 * disc.eccentricity)
    along = rows["along"] / unit
    assert teeth.radial_force_ratio_max == pytest.approx(along.max(), abs=2e-3)
    assert teeth.radial_force_ratio_min == pytest.approx(along.min(), abs=2e-3)
    loss, hardest = [], 0.0
    for angle in angles[::40]:
        there = series_position(real=series, crank_angle=float(angle), output_torque=torque)
        for j, row in enumerate(there.ring.force):
            crank = angle + series.mechanism.crank_angles[j]
            for k, force in enumerate(row):
                # From the pin's centre to the pitch point, in the ring's frame.
                pin = 1j * np.exp(2j * math.pi * k / 10) * disc.ring_pin_circle_radius
                pole = 1j * np.exp(-1j * crank) * disc.eccentricity * 10
                far = abs(abs(pin - pole) - disc.ring_pin_radius)
                loss.append(force * far / torque)
                hardest = max(hardest, force * far)
    assert teeth.sliding_loss == pytest.approx(sum(loss) / len(angles[::40]), rel=5e-3)
    assert hardest * (1 - 1e-9) <= teeth.hardest_rub <= hardest * 1.02
