"""Ring mesh and output mechanism in series: sums, limits, mirrors, what presses, refusals."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.errors import ImpossibleMechanism, InvalidInput
from core.output.elasticity import (
    CrankSupport,
    ElasticMesh,
    LinearLaw,
    PinSupport,
    Shares,
    Supports,
)
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT, JUDGED, SAME, SEARCHED
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries, SeriesPosition, series_position
from core.ring.sharing import CycloidMesh, RingDeviations, mesh_position
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.series import drawn
from tests.oracles.ring_distance import Distances
from tests.oracles.seeds import seeds

DISC = CycloidDisc(11, 2.5e-3, 0.05, 0.005, Modification(2e-5, -1e-5))
STIFF = LinearLaw(1e14)
PHASE = (1e-5, -2e-5)


def series_of(
    ring: dict[str, Any] | None = None, output: dict[str, Any] | None = None, **both: Any
) -> MeshesInSeries:
    count = len(both.pop("crank_angles", (0.0, math.pi)))
    angles, exact = tuple(2 * math.pi * j / count for j in range(count)), both.pop("exact", True)
    mesh: dict[str, Any] = {
        "disc": DISC,
        "crank_angles": angles,
        "contact_length": 0.01,
        "law": LinearLaw(1e8),
        "pin_material": STEEL,
        "disc_material": STEEL,
        "exact": exact,
        "deviations": RingDeviations(**both),
    }
    real: dict[str, Any] = {
        "mechanism": Mechanism(6, angles, 11.0),
        "pin_circle_radius": 0.03,
        "pin_radius": 0.004,
        "eccentricity": DISC.eccentricity,
        "contact_length": 0.01,
        "law": LinearLaw(1e8),
        "pin_material": STEEL,
        "hole_material": STEEL,
        "clearance": 1e-5,
        "exact": exact,
        "deviations": Deviations(**both),
    }
    return MeshesInSeries(
        CycloidMesh(**mesh | (ring or {})), RealMechanism(**real | (output or {}))
    )


def at(series: MeshesInSeries, angle: float, torque: float) -> SeriesPosition:
    return series_position(real=series, crank_angle=angle, output_torque=torque)


def flat(rows: Any) -> list[float]:
    return [each for row in rows for each in row]


@pytest.mark.parametrize("seed", seeds(6))
def test_of_one_disc_in_first_order_lags_and_plays_of_both_stages_add(seed: int) -> None:
    series, angle, torque = drawn(3 * seed, exact=False)
    ring, output = series.teeth[0], on_pins_alone(series, 0)
    series = MeshesInSeries(ring, replace(output, deviations=with_phases(ring, output)))
    found = at(series, angle, torque)
    teeth = mesh_position(mesh=ring, crank_angle=angle, output_torque=torque)
    holes = loaded_position(real=output, crank_angle=angle, output_torque=torque)
    assert found.rotation == pytest.approx(teeth.rotation[0] + holes.rotation, rel=SAME)
    assert found.play == pytest.approx(
        [sum(each) for each in zip(teeth.play, holes.play, strict=True)], rel=SAME
    )
    gives = 1 / teeth.stiffness + 1 / holes.stiffness
    assert found.stiffness == pytest.approx(1 / gives, rel=SAME)
    assert flat(found.force) == pytest.approx(flat(holes.force), rel=EXACT, abs=1e-9)
    assert flat(found.ring.force) == pytest.approx(flat(teeth.force), rel=EXACT, abs=1e-9)


def on_pins_alone(series: MeshesInSeries, j: int) -> RealMechanism:
    """A disc by itself on the output pins, whose phases its lag has."""
    output, own = series.output, series.mechanism
    errors = output.rooms.numbered[0]
    one = {
        name: getattr(errors, name)[j : j + 1]
        for name in ("hole_radial", "hole_tangential", "hole_radius", "eccentricity", "crank_phase")
    }
    phase = one["crank_phase"][0] if one["crank_phase"] else 0.0
    return replace(
        output,
        mechanism=replace(own, crank_angles=own.crank_angles[j : j + 1]),
        pin=output.pin.at(j),
        deviations=replace(errors, **one, disc_phase=(-phase / own.ratio,)),
    )


def with_phases(ring: CycloidMesh, output: RealMechanism) -> Deviations:
    """Deviations of an output whose discs have the phases of those in the ring."""
    own = ring.deviations
    return replace(output.deviations, disc_phase=own.disc_phase, crank_phase=own.crank_phase)


PHASES = {"disc_phase": (3e-5, -2e-5), "crank_phase": (2e-4, -3e-4)}
BENT = PinSupport("cantilever", 0.006, (0.01, 0.025), STEEL)


@pytest.mark.parametrize("exact", [True, False])
def test_on_a_stiff_ring_it_is_the_output_mechanism(exact: bool) -> None:
    """Errors of the phases are in the teeth there, and in the holes here."""
    perfect = replace(DISC, modification=Modification())
    series = series_of(
        {"disc": perfect, "law": STIFF, "deviations": RingDeviations(**PHASES)},
        {"pin": BENT, "deviations": Deviations(**PHASES)},
        exact=exact,
    )
    found = at(series, 1.3, -120.0)
    same = loaded_position(real=series.output, crank_angle=1.3, output_torque=-120.0)
    assert found.rotation == pytest.approx(same.rotation, rel=JUDGED)
    assert flat(found.force) == pytest.approx(flat(same.force), abs=1e-4 * max(flat(same.force)))
    assert found.play == pytest.approx(same.play, rel=EXACT)
    assert found.stiffness == pytest.approx(same.stiffness, rel=1e-4)
    assert found.input_torque == pytest.approx(input_torque(series.output, 1.3, -120.0), rel=1e-4)


def input_torque(real: RealMechanism, angle: float, torque: float) -> float:
    return float(real.solved([real.wave(angle)], torque).input_torque[0])


@pytest.mark.parametrize("exact", [True, False])
def test_on_stiff_pins_it_is_the_ring_mesh(exact: bool) -> None:
    rings = RingDeviations(pin_radial=tuple(1e-6 * (k % 5 - 2) for k in range(12)), **PHASES)
    series = series_of(
        {"deviations": rings, "pin": PinSupport("fixed", 0.008, (0.01, 0.025), STEEL, 0.035)},
        {"law": STIFF, "clearance": 0.0, "deviations": Deviations(**PHASES)},
        exact=exact,
    )
    found = at(series, 1.3, 120.0)
    same = mesh_position(mesh=series.ring, crank_angle=1.3, output_torque=120.0)
    assert found.rotation == pytest.approx(same.rotation[0], rel=JUDGED)
    assert found.ring.rotation == pytest.approx(same.rotation, rel=JUDGED)
    most = max(flat(same.force))
    assert flat(found.ring.force) == pytest.approx(flat(same.force), abs=1e-4 * most)
    assert found.ring.crank_along == pytest.approx(same.crank_along, abs=1e-4 * most)
    assert found.stiffness == pytest.approx(same.stiffness, rel=1e-4)
    assert found.ring.max_pressure == pytest.approx(same.max_pressure, rel=1e-4)


@pytest.mark.parametrize("exact", [True, False])
def test_a_disc_that_carries_nothing_lies_in_the_middle(exact: bool) -> None:
    series = series_of(exact=exact, disc_phase=(0.0, -4e-4))
    found = at(series, 0.4, 5.0)
    assert found.satellite_torque[0] > 0 == found.satellite_torque[1]
    low, high = found.ring.play[1]
    holes = replace(on_pins_alone(series, 1), exact=False)
    slack = loaded_position(real=holes, crank_angle=0.4, output_torque=1.0).play
    ends = max(low, found.rotation - slack[1]), min(high, found.rotation - slack[0])
    assert found.ring.rotation[1] == pytest.approx(sum(ends) / 2, rel=1e-2 if exact else 1e-9)
    assert not any(found.force[1]) and not any(found.ring.force[1])


@pytest.mark.parametrize("exact", [True, False])
def test_parts_that_press(exact: bool) -> None:
    """Pins in holes too small by themselves, teeth by themselves, and discs against each other."""
    tight = series_of(output={"clearance": -2e-6}, exact=exact)
    found = at(tight, 0.4, 100.0)
    assert found.interference == pytest.approx(2e-6, rel=1e-2) and found.play is not None
    narrow = replace(DISC, modification=Modification(-3e-6))
    found = at(series_of({"disc": narrow}, exact=exact), 0.4, 100.0)
    assert found.interference == pytest.approx(3e-6, rel=1e-2)
    assert all(low == high for low, high in found.ring.play)
    turned = at(series_of(exact=exact, disc_phase=(0.0, 4e-3)), 0.4, 100.0)
    assert turned.play is None and turned.interference > 1e-6
    for each in (found, turned):
        assert "pressed_without_load" in [notice.code for notice in each.notices]
    free = at(series_of(exact=exact), 0.4, 100.0)
    assert free.interference is None and free.play is not None


def test_a_disc_turned_by_a_hole_goes_onto_the_next_pins() -> None:
    turned = at(series_of(disc_phase=(0.0, math.pi / 3)), 0.4, 100.0)
    plain = at(series_of(disc_phase=(0.0, 0.0)), 0.4, 100.0)
    assert turned.rotation == pytest.approx(plain.rotation, rel=EXACT)
    assert flat(turned.ring.force) == pytest.approx(flat(plain.ring.force), rel=SEARCHED, abs=1e-6)


def of_output(**change: Any) -> dict[str, Any]:
    return {"output": change}


@pytest.mark.parametrize(
    ("change", "name", "code"),
    [
        (of_output(mechanism=Mechanism(6, (0.0,), 11.0)), "satellites", "stages_differ"),
        (of_output(mechanism=Mechanism(6, (0.0, 3.0), 11.0)), "crank_angles[1]", "stages_differ"),
        (of_output(mechanism=Mechanism(6, (0.0, math.pi), 12.0)), "ratio", "stages_differ"),
        (of_output(eccentricity=2.6e-3), "eccentricity", "stages_differ"),
        (of_output(exact=False), "exact", "stages_differ"),
        (of_output(deviations=Deviations(disc_phase=PHASE)), "disc_phase[0]", "stages_differ"),
        ({"ring": {"support": Shares((0.5, 0.5))}}, "support", "only_one"),
        (of_output(support=ElasticMesh(1e5)), "support", "only_one"),
        (of_output(support=Supports(CrankSupport(1e8), ElasticMesh(1e5))), "support", "only_one"),
    ],
)
def test_stages_of_different_discs_are_refused(
    change: dict[str, Any], name: str, code: str
) -> None:
    with pytest.raises(InvalidInput) as caught:
        series_of(**change)
    assert (caught.value.parameter, caught.value.code) == (name, code)


def test_what_cannot_be_is_refused() -> None:
    for torque in (0.0, math.nan):
        with pytest.raises(InvalidInput, match="output_torque"):
            at(series_of(), 0.4, torque)
    soft = {"law": LinearLaw(1e3)}
    with pytest.raises(ImpossibleMechanism) as caught:
        at(series_of(soft, soft), 25.0, 1e4)
    assert caught.value.code == "not_stable"
    assert caught.value.where["crank_angle"] == pytest.approx(25.0)
    tight = {"disc": replace(DISC, modification=Modification())}
    one_pin = {"mechanism": Mechanism(1, (0.0,), 11.0), "clearance": 0.0}
    with pytest.raises(ImpossibleMechanism) as caught:
        at(series_of(tight, one_pin, crank_angles=(0.0,)), 0.0, 10.0)
    assert caught.value.code in {"dead_centre", "not_stable"}


@pytest.mark.parametrize("seed", [*seeds(8)])
def test_soft_teeth_touch_where_the_nearest_points_of_their_paths_are(seed: int) -> None:
    """However far a disc lags; half a pitch of its lobes and more, its teeth do not hold it."""
    series, angle, torque = drawn(seed, ring={"law": LinearLaw(1e6)})
    sought, pitch = Distances(series.ring, angle), 2 * math.pi / series.ring.disc.satellite_teeth
    for times in (0.1, 1.0, 10.0, 100.0):
        try:
            found = at(series, angle, times * torque)
        except ImpossibleMechanism:
            break
        for j, lag in enumerate(found.ring.rotation):
            expected = 1e6 * np.maximum(sought.at(lag)[0][j], 0.0)
            force = np.array(found.ring.force[j])
            assert force == pytest.approx(expected, abs=1e-9 * max(expected.max(), 1.0))
            assert abs(lag) < pitch / 2
    assert times > 0.1
