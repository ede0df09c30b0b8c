"""A bolt through a spacer: held numbers, the press of its face by points, limits, refusals."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from core.errors import InvalidInput
from core.output.pin_bolt import PinBolt, bolt_preload, grip
from core.precision import SEARCHED
from tests.oracles import tie_ring as oracle

(CASE,) = (
    case
    for case in json.loads((Path(oracle.__file__).parent / "tie_ring_cases.json").read_text())
    if case["name"].startswith("B6")
)
M3 = PinBolt(core_diameter=0.002459, preload=2000.0, preload_scatter=1.6)
SPACER = {"diameter": 0.007, "bore": 0.0032}


def test_a_spacer_of_seven_millimetres_on_m3() -> None:
    body, expected = CASE["body"], CASE["expect"]
    bolt = body["pin"]["bolt"]
    found = grip(
        bolt=PinBolt(
            bolt["core_diameter_mm"] / 1e3,
            bolt["preload_N"],
            bolt["preload_scatter"],
            bolt["friction_coefficient"],
        ),
        diameter=body["pin"]["diameter_mm"] / 1e3,
        bore=body["pin"]["bore_diameter_mm"] / 1e3,
        moment=body["root_moment_Nmm"] / 1e3,
        shear_force=body["root_force_N"],
    )
    close = CASE["tolerance"]["relative"]
    assert found.opening_moment == pytest.approx(expected["bolt.opening_moment_Nm"], rel=close)
    assert found.slip_force == pytest.approx(expected["bolt.slip_force_N"], rel=close)
    amplitude = expected["bolt.bending_amplitude_MPa"] * 1e6
    assert found.bending_amplitude == pytest.approx(amplitude, rel=close)
    assert found.alone_stress == pytest.approx(expected["bolt.alone_stress_MPa"] * 1e6, rel=close)
    assert found.opens and found.slips and not found.holds


@pytest.mark.parametrize("bore", [0.0, 0.0032, 0.006])
def test_at_its_opening_moment_an_edge_of_the_face_is_free(bore: float) -> None:
    """The press of the face summed over its points: the force, the moment, none at one edge."""
    found = grip(bolt=M3, diameter=0.007, bore=bore, moment=1.0, shear_force=1.0)
    radii = np.linspace(bore / 2, 0.0035, 4001)
    middle, wide = (radii[1:] + radii[:-1]) / 2, np.diff(radii)
    angle = (np.arange(720) + 0.5) * math.pi / 360
    area = (middle * wide)[:, None] * np.full(720, math.pi / 360)
    along = middle[:, None] * np.cos(angle)
    mean = 2000 / 1.6 / area.sum()
    assert found.opening_moment is not None
    slope = found.opening_moment / (area * along**2).sum()
    assert slope * 0.0035 == pytest.approx(mean, rel=SEARCHED)


@pytest.mark.parametrize(
    ("moment", "shear_force", "holds"),
    [(1.32, 156.0, True), (1.33, 1.0, False), (0.1, 157.0, False)],
)
def test_it_holds_up_to_both_limits(moment: float, shear_force: float, holds: bool) -> None:
    found = grip(bolt=M3, **SPACER, moment=moment, shear_force=shear_force)
    assert found.holds == holds
    assert found.squeeze == pytest.approx(2000 / (math.pi / 4 * (0.007**2 - 0.0032**2)))


def test_without_a_preload_nothing_is_held() -> None:
    found = grip(bolt=PinBolt(0.002459), **SPACER, moment=1e-6, shear_force=1e-6)
    assert not (found.holds or found.opens or found.slips)
    assert found.opening_moment is None and found.slip_force is None and found.squeeze == 0


def test_a_preload_by_torque_is_not_more_than_that_of_the_thread() -> None:
    """Threads over their cores: ISO 724, coarse."""
    for thread, core in ((2.5, 2.013), (3, 2.459), (4, 3.242), (6, 4.917), (10, 8.376)):
        found = bolt_preload(tightening_torque=1.0, core_diameter=core / 1e3)
        assert 0.9 < found / (1 / (0.2 * thread / 1e3)) <= 1


@pytest.mark.parametrize(
    "wrong",
    [{"core_diameter": 0.0}, {"preload": -1.0}, {"preload_scatter": 0.9}, {"preload": 0.0}],
)
def test_what_cannot_be_is_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(InvalidInput):
        PinBolt(**({"core_diameter": 0.003} | wrong))
