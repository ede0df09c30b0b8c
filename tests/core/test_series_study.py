"""Studies of both meshes in series: their pieces, drawn by hand and solved one by one."""

import math
from dataclasses import replace
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest

from core.errors import InvalidInput
from core.output.elasticity import PinSupport
from core.output.room import Deviations
from core.output.stage import Solved
from core.precision import EXACT
from core.ring.profile import Modification
from core.ring.series import MeshesInSeries, series_position
from core.ring.series_study import SeriesStudy
from core.ring.sharing import RingDeviations, mesh_position
from core.tolerance.contributions import contributions
from core.tolerance.draws import Spread
from core.tolerance.study import QUANTITIES, Evaluation, tolerance_study
from core.tolerance.tolerances import Tolerances
from tests.inputs.plain_engine import plain
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.series import drawn

SEED, POSITIONS = 11, 5

WIDE = Tolerances(
    pin_position=2e-6,
    hole_position=3e-6,
    pin_radius=Spread(-1e-6, 2e-6),
    hole_radius=Spread(0.0, 3e-6, "uniform"),
    eccentricity=Spread(-1e-6, 1e-6),
    crank_phase=Spread(-1e-4, 1e-4),
    disc_phase=Spread(-2e-5, 2e-5),
    ring_pin_position=4e-6,
    ring_pin_radius=Spread(-3e-6, 1e-6),
    equidistant=Spread(-1e-6, 3e-6),
    modification_pin_circle=Spread(-2e-6, 1e-6, "uniform"),
)


def bare(seed: int, **changes: Any) -> tuple[MeshesInSeries, float]:
    """Both meshes without errors, with play, and a torque."""
    series, _, torque = drawn(seed, **changes)
    none = {"deviations": RingDeviations()}
    output = replace(series.output, deviations=Deviations(), clearance=2e-5)
    change = Modification(2e-5, -5e-6)
    disc = replace(series.ring.disc, modification=change)
    places = tuple(0.01 + 0.013 * j for j in range(series.mechanism.satellites))
    pin = PinSupport("fixed", 0.006, places, STEEL, 0.06)
    ring = replace(series.ring, disc=disc, pin=pin, seat_stiffness=4e8, **none)
    return MeshesInSeries(ring, output), torque


def word(kind: int, index: int, sample: int) -> float:
    """A number between 0 and 1 of a stream, by the generator that is named."""
    bits = np.random.Philox(key=np.array([SEED, kind * 2**32 + index], dtype=np.uint64))
    raw = int(bits.random_raw(sample + 1)[sample])
    return (raw >> 11) * 2.0**-53 + 2.0**-54


def value(spread: Spread, uniform: float) -> float:
    """A deviation of it."""
    if spread.distribution == "uniform":
        return spread.lower + uniform * (spread.upper - spread.lower)
    tail = NormalDist().cdf(-3)
    sigma = (spread.upper - spread.lower) / 6
    middle = (spread.upper + spread.lower) / 2
    return middle + sigma * NormalDist().inv_cdf(tail + uniform * (1 - 2 * tail))


def piece_by_hand(series: MeshesInSeries, sample: int) -> MeshesInSeries:
    """One piece of `WIDE`, every part of it by its own stream."""
    own, given = series.mechanism, WIDE
    teeth = series.ring.disc.pins

    def places(zone: float, kind: int, indices: range) -> list[complex]:
        return [
            zone / 2 * math.sqrt(word(kind, i, sample))
            * complex(math.cos(turn := 2 * math.pi * word(kind + 1, i, sample)), math.sin(turn))
            for i in indices
        ]  # fmt: skip

    def sizes(spread: Spread, kind: int, indices: range) -> tuple[float, ...]:
        return tuple(value(spread, word(kind, i, sample)) for i in indices)

    def parts(row: list[complex]) -> tuple[tuple[float, ...], tuple[float, ...]]:
        return tuple(z.real for z in row), tuple(z.imag for z in row)

    discs = [range(j * own.pins, (j + 1) * own.pins) for j in range(own.satellites)]
    holes = [parts(places(given.hole_position, 3, indices)) for indices in discs]
    every = range(own.satellites)
    shared = (
        sizes(given.eccentricity, 6, every),
        sizes(given.crank_phase, 7, every),
        sizes(given.disc_phase, 8, every),
    )
    output = Deviations(
        *parts(places(given.pin_position, 0, range(own.pins))),
        sizes(given.pin_radius, 2, range(own.pins)),
        tuple(radial for radial, _ in holes),
        tuple(tangential for _, tangential in holes),
        tuple(sizes(given.hole_radius, 5, indices) for indices in discs),
        *shared,
    )
    ring = RingDeviations(
        *parts(places(given.ring_pin_position, 9, range(teeth))),
        sizes(given.ring_pin_radius, 11, range(teeth)),
        *shared,
    )
    before = series.ring.disc.modification
    cut = Modification(
        before.equidistant + value(given.equidistant, word(12, 0, sample)),
        before.pin_circle + value(given.modification_pin_circle, word(13, 0, sample)),
    )
    disc = replace(series.ring.disc, modification=cut)
    return MeshesInSeries(
        replace(series.ring, disc=disc, deviations=ring), replace(series.output, deviations=output)
    )


def solved_one_by_one(
    piece: MeshesInSeries, torque: float, places: list[float]
) -> dict[str, float]:
    """Quantities of a piece, by positions solved one by one."""

    def at(angle: float, times: float = 1.0) -> Any:
        return series_position(real=piece, crank_angle=angle, output_torque=times * torque)

    found = [at(angle) for angle in places]
    lost = [at(angle, 0.03).rotation - at(angle, -0.03).rotation for angle in places]
    plays = [each.play for each in found]
    lags = [each.rotation for each in found]
    return {
        "peak_force": max(max(map(max, each.force)) for each in found),
        "max_pressure": max(each.max_pressure for each in found),
        "transmission_error": max(lags) - min(lags),
        "backlash_max": max(high - low for low, high in plays),
        "lost_motion": max(map(abs, lost)),
        "stiffness_min": min(each.stiffness for each in found),
        "ring_peak_force": max(max(map(max, each.ring.force)) for each in found),
        "ring_max_pressure": max(each.ring.max_pressure for each in found),
    }


@pytest.mark.parametrize(("seed", "exact", "gap"), [(3, True, 0), (3, True, 2), (8, False, 0)])
def test_pieces_are_those_of_their_streams_solved_one_by_one(
    seed: int, exact: bool, gap: int
) -> None:
    """Also where pins stand so many times as far off as the valleys are round."""
    series, torque = bare(seed, exact=exact)
    if gap:
        disc = series.ring.disc
        wide = replace(disc, modification=Modification(gap * disc.valley_radius))
        series = replace(series, ring=replace(series.ring, disc=wide))
    names = (*QUANTITIES, "ring_peak_force", "ring_max_pressure")
    asked = Evaluation(names, torque, POSITIONS)
    study = SeriesStudy(series, WIDE, asked, samples=3, seed=SEED)
    values, fits = study.values(study.pieces())
    assert fits.tolist() == [2, 2, 2]
    places = study.places(POSITIONS)
    for sample, row in enumerate(values):
        expected = solved_one_by_one(piece_by_hand(series, sample), torque, places)
        assert dict(zip(names, row, strict=True)) == pytest.approx(expected, rel=EXACT)
        own = solved_one_by_one(study.piece(study.pieces(), sample), torque, places)
        assert own == pytest.approx(expected, rel=EXACT)


def test_a_piece_hangs_on_no_other_and_on_no_other_tolerance() -> None:
    """To the bit, also where the one before left the room."""
    series, torque = bare(6, exact=False)
    asked = Evaluation(("peak_force", "transmission_error"), torque, 3)
    study = SeriesStudy(series, WIDE, asked, samples=10, seed=SEED)
    whole, _ = study.values(study.pieces())
    part, _ = study.values(study.pieces().part(5, 10))
    assert part.tobytes() == whole[5:].tobytes()
    alone = Tolerances(ring_pin_position=WIDE.ring_pin_position)
    for one in (alone, WIDE):
        rows = replace(study.pieces(tolerances=one), samples=range(2, 3)).ring_rows()
        kept = study.pieces().ring_rows()
        assert rows.ring_pin_radial.tolist() == kept.ring_pin_radial[2:3].tolist()
    other = study.pieces(other=("equidistant",)).ring_rows()
    changed = [name for name in kept._fields if (getattr(kept, name) != getattr(other, name)).any()]
    assert changed == ["equidistant"]


def test_pieces_fit_alike_whether_forces_are_asked_or_not() -> None:
    """Pins that a piece bends are straight again when the next one is put together."""
    series, torque = bare(16)
    pin = PinSupport("supported", 0.006, (0.01, 0.023), STEEL, 0.033)
    bent = replace(series.output, pin=pin)
    assert bent.mechanism.satellites == 2
    for name in ("backlash_max", "peak_force"):
        asked = Evaluation((name,), 20 * torque, 3)
        study = SeriesStudy(MeshesInSeries(series.ring, bent), WIDE, asked, samples=6, seed=SEED)
        assert study.values(study.pieces())[1].tolist() == [2] * 6


def test_pieces_that_bind_in_either_mesh_are_seen() -> None:
    """Fitting pieces have play at every examined angle, binding ones lack it somewhere."""
    series, torque = bare(3, exact=False)
    tight = Modification(3e-6, 0.0)
    disc = replace(series.ring.disc, modification=tight)
    asked = Evaluation(("backlash_max",), torque, 4)
    wide = Tolerances(ring_pin_position=8e-6)
    study = SeriesStudy(replace_ring(series, disc=disc), wide, asked, samples=12)
    values, fits = study.values(study.pieces())
    assert {1, 2} <= {*fits.tolist()} and np.isnan(values[fits != 2]).all()
    for sample in (int(np.flatnonzero(fits == 2)[0]), int(np.flatnonzero(fits == 1)[0])):
        piece = study.piece(study.pieces(), sample)
        plays = [
            mesh_position(mesh=piece.ring, crank_angle=angle, output_torque=torque).play
            for angle in study.places(16 * study.ring_pins)
        ]
        assert (None in plays) == (fits[sample] != 2)
    pressed = replace(disc, modification=Modification(-2e-5, 0.0))
    jammed = replace(study, real=replace_ring(series, disc=pressed))
    assert jammed.values(jammed.pieces().part(0, 2))[1].tolist() == [0, 0]
    crossed = Tolerances(disc_phase=Spread(-5e-3, 5e-3))  # discs that disagree, none is pressed
    apart = replace(study, real=series, tolerances=crossed)
    assert apart.values(apart.pieces().part(0, 1))[1].tolist() == [0]
    tight_pins = replace(series, output=replace(series.output, clearance=-2e-5))
    assert replace(study, real=tight_pins).values(study.pieces().part(0, 2))[1].tolist() == [0, 0]


@pytest.mark.parametrize(("seed", "exact"), [(3, True), (8, False), (16, True)])
def test_pieces_whose_errors_are_smaller_than_their_gaps_are_free_at_all_places(
    seed: int, exact: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    series, torque = bare(seed, exact=exact)
    study = SeriesStudy(series, WIDE, Evaluation(("backlash_max",), torque, 3), samples=30)
    looked, seen = study.looked[::40], set[tuple[bool, int]]()
    large = (
        Tolerances(eccentricity=Spread(-2e-4, 2e-4)),
        Tolerances(disc_phase=Spread(-1e-3, 1e-3)),
        Tolerances(pin_position=8e-5, ring_pin_position=8e-5),
    )
    for tolerances in (WIDE, *large):
        drives = study.drives(study.pieces(tolerances=tolerances))
        room = Solved.of(drives, 3)
        for drive in map(drives.drive, range(study.samples)):
            sure = plain.free_everywhere(drive)
            with monkeypatch.context() as looking:
                looking.setattr(plain, "free_everywhere", lambda drive: False)
                fits = plain.goes_together(looked, drive, room.work, room.rows[0])
            seen.add((sure, fits))
    assert {(True, 2), (False, 2)} <= seen and not {(True, 0), (True, 1)} & seen


def replace_ring(series: MeshesInSeries, **changes: Any) -> MeshesInSeries:
    return replace(series, ring=replace(series.ring, **changes))


def test_a_study_says_what_its_positions_miss_and_which_tolerance_does_most() -> None:
    series, torque = bare(8, exact=False)
    alone = Tolerances(ring_pin_position=6e-6, equidistant=Spread(-1e-7, 1e-7))
    asked = Evaluation(("ring_peak_force", "max_pressure"), torque, 3)
    study = SeriesStudy(series, alone, asked, samples=8)
    found = tolerance_study(study)
    finer = replace(study, asked=replace(asked, positions=8 * 3 + 1))
    fine, _ = finer.values(finer.pieces())
    for index, name in enumerate(asked.quantities):
        off = np.abs(fine - found.values)[:, index].sum() / fine[:, index].sum()
        assert found.angle_grid_error[name] == pytest.approx(off)
    middle = solved_one_by_one(series, torque, list(study.places(3)))
    assert found.nominal == pytest.approx({name: middle[name] for name in asked.quantities})
    ranked = contributions(study=study, percent=50)
    assert [each.source for each in ranked] == ["ring_pin_position", "equidistant"]


def test_limits_that_leave_no_flank_are_refused() -> None:
    """Not by pieces that happen to be drawn."""
    series, torque = bare(3, exact=True)
    asked, disc = Evaluation(("peak_force",), torque, 4), series.ring.disc
    sharp = disc.min_path_radius
    with pytest.raises(InvalidInput, match="ring_pin_radius"):
        SeriesStudy(series, Tolerances(equidistant=Spread(0.0, sharp)), asked)


def test_pieces_without_a_size_are_none_and_what_is_not_asked_is_not_solved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def none(*given: Any, **_: Any) -> None:
        raise AssertionError(given)

    series, torque = bare(8, exact=False)
    asked = Evaluation(("backlash_max",), torque, 2)
    monkeypatch.setattr("core.output.stage.Solved.at", none)
    play = Tolerances(ring_pin_position=1e-6)
    study = SeriesStudy(series, play, asked, samples=2)
    assert np.isfinite(study.values(study.pieces())[0]).all()
    for part, radius in (
        ("ring_pin_radius", series.ring.disc.ring_pin_radius),
        ("pin_radius", series.output.pin_radius),
    ):
        gone = Tolerances(**{part: Spread(-1.01 * radius, -radius)})  # type: ignore[arg-type]
        values, fits = replace(study, tolerances=gone).values(study.pieces(tolerances=gone))
        assert np.isnan(values).all() and not fits.any()
    with pytest.raises(AssertionError):
        replace(study, asked=replace(asked, quantities=("ring_peak_force",))).values(study.pieces())
