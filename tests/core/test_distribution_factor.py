"""A stated uneven share: a factor on the force, once, wherever that force goes."""

import math
from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.crank.ring_mesh import RingMesh
from core.design.document import Design
from core.design.results import Results
from core.errors import InvalidInput
from core.output.elasticity import CrankSupport, HertzLaw
from core.output.mechanism import Mechanism
from core.output.room import Deviations
from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.checks import REF, WHOLE, check_of, having
from tests.inputs.loads import crankshaft, satellite_bearings
from tests.inputs.satellites import mechanisms
from tests.oracles.satellites import forces

LOAD = {"output_torque": 500.0, "pin_circle_radius": 0.05, "eccentricity": 2e-3}


@pytest.mark.parametrize(
    ("factor", "pressure", "bending"),
    [(1.5, 479.11418126604605, 460.05725737500995), (2.0, 553.2334030530377, 613.4096765000133)],
)
def test_of_two_discs_one_carries_more(factor: float, pressure: float, bending: float) -> None:
    """Pressure by its root, bending straight; the slope of the pins besides it."""
    found = Results(having(WHOLE, distribution_factor=factor))
    level = found.hertz.max_pressure / math.sqrt(found.line_load_factor)
    assert level / 1e6 == pytest.approx(pressure, rel=EXACT)
    assert found.pin_strength.peak_bending_stress / 1e6 == pytest.approx(bending, rel=EXACT)
    assert found.pin_strength.peak_force == pytest.approx(factor * 1e4 / 3, rel=SAME)
    alone = Results(having(REF, distribution_factor=factor))
    assert alone.hertz.max_pressure / 1e6 == pytest.approx(pressure, rel=EXACT)


def test_the_edge_has_the_line_load_of_the_whole_force() -> None:
    """The factor counts once: the result equals that of a larger, evenly shared torque."""
    uneven = Results(having(WHOLE, distribution_factor=1.5))
    more = Results(having(WHOLE, output_torque=750.0), equal=True)
    assert uneven.line_load_factor == pytest.approx(more.line_load_factor, rel=SAME)
    assert uneven.hertz.max_pressure == pytest.approx(more.hertz.max_pressure, rel=SAME)
    for name in ("peak_equivalent_stress", "static_stress", "peak_shear_stress"):
        values = [getattr(each.pin_strength, name) for each in (uneven, more)]
        assert values[0] == pytest.approx(values[1], rel=SAME), name
    assert uneven.pin_strength.fatigue.safety_factor == pytest.approx(
        more.pin_strength.fatigue.safety_factor, rel=SAME
    )


Change = Callable[[float], float]
MOVES: dict[str, Change] = {
    "contact_pressure_hole": lambda k: k**0.5,
    "pin_static": lambda k: k,
    "pin_deflection": lambda k: k,
    "pin_fatigue": lambda k: 1 / k,
    "wear": lambda k: k,
    "pv": lambda k: k,
    "efficiency": lambda k: 1.0,
    "bearing_life": lambda k: k**-3,
    "bearing_static": lambda k: 1 / k,
    "bearing_min_load": lambda k: 2 - k,
}
"""What a factor of one of two discs does to a check of perfect parts without a slope of pins."""


@pytest.mark.parametrize("code", MOVES)
@pytest.mark.parametrize("of", [None, "pins"])
def test_what_the_force_reaches(code: str, of: str | None) -> None:
    level: Design = having(WHOLE, crankshaft=None)  # whose masses do not grow with the torque
    if "contact" in code:
        level = having(level, pin=None, fatigue=None)
    even = check_of(code, having(level, distribution_factor=1 + 1e-12))
    uneven = check_of(code, having(level, distribution_factor=1.4, distribution_of=of))
    felt = 1.0 if of == "pins" and code.startswith("bearing") else MOVES[code](1.4)
    assert uneven.value == pytest.approx(even.value * felt, rel=EXACT)


def test_all_bearings_together_do_not_outlast_one() -> None:
    """The one that carries more, and the other as it lasts with what is left."""
    bearing = having(WHOLE, pin=None, fatigue=None).bearing
    slope = 1.2
    own = {
        "mechanism": WHOLE.built,
        "mesh": RingMesh(0.7),
        "kind": bearing.kind,
        "dynamic_rating": bearing.dynamic_rating,
        "input_speed": 100.0,
        "weibull_slope": slope,
    }
    even = satellite_bearings(**LOAD, **own)
    found = satellite_bearings(**LOAD, **own, distribution_factor=1.4)
    lives = np.array([even.life[0] / 1.4**3, even.life[0] / 0.6**3])
    assert found.system_life == pytest.approx((lives**-slope).sum() ** (-1 / slope), rel=SAME)
    assert found.system_life < found.life.min()
    alone = satellite_bearings(**LOAD, **own, distribution_factor=2.0)
    assert alone.system_life == pytest.approx(even.life[0] / 8, rel=SAME)


@given(mechanism=mechanisms, part=st.floats(0, 1), rho=st.floats(-1, 1))
def test_reactions_by_statics_with_vectors(mechanism: Mechanism, part: float, rho: float) -> None:
    """Each satellite in turn carries K_alpha/K: moments by cross products about the bearings."""
    count = mechanism.satellites
    factor = 1 + part * (count - 1)
    z = 0.01 + 0.022 * np.arange(count)
    found = crankshaft(
        **LOAD,
        mechanism=mechanism,
        mesh=RingMesh(rho),
        distribution_factor=factor,
        satellite_positions=tuple(z.tolist()),
        bearing_positions=(-0.01, 0.09),
        torque_direction="alternating",
    )
    psi = (np.arange(20_000) + 0.5) * 2 * np.pi / 20_000
    pins, shares = forces(mechanism, 1.0, psi)
    ahead = np.array(mechanism.crank_angles)
    out = np.array([np.cos(ahead), np.sin(ahead), 0 * ahead]).T
    across = np.cross([0, 0, 1], out)
    peak = np.zeros(2)
    for one, way in product(range(count), (1, -1)):
        carries = np.full(count, (count - factor) / (count - 1) if count > 1 else 1.0)
        carries[one] = factor
        force = np.zeros((len(psi), 3))
        moment = np.zeros((len(psi), 3))
        for j in range(count):
            w, s = carries[j] * 12_500 * shares[j], carries[j] * 10_000 * pins[j]
            own = -np.outer(way * w, across[j]) - np.outer(rho * w + s, out[j])
            force += own
            moment += np.cross([0, 0, z[j] + 0.01], own)
        last = np.cross([0, 0, 1], moment) / 0.1  # (0, 0, L) x R_B + moment = 0
        peak = np.maximum(peak, np.linalg.norm([-force - last, last], axis=2).max(axis=1))
    assert found.peak_reaction == pytest.approx(peak, rel=1e-3)
    assert (peak <= found.peak_reaction * (1 + SEARCHED)).all()


@pytest.mark.parametrize(
    "solved",
    [
        {"hole_radius": 0.01002},
        {"deviations": Deviations(eccentricity=(1e-5, 0.0))},
        {"crank_support": CrankSupport(stiffness=2e8)},
        {"contact_law": HertzLaw()},
    ],
    ids=["clearance", "deviations", "elasticity", "law"],
)
def test_a_factor_is_refused_beside_solved_forces(solved: dict[str, Any]) -> None:
    design = having(REF, **solved)
    assert design.as_made
    assert having(design, distribution_factor=1.0).distribution_factor == 1
    with pytest.raises(InvalidInput) as refused:
        having(design, distribution_factor=1.4)
    assert refused.value.parameter == "contact.distribution_factor"
    assert refused.value.code == "with_real_forces"


def test_a_factor_stays_beside_deviations_of_the_ring_alone() -> None:
    """Ring pins that deviate concern the ring's mesh, and leave the factor to pins in holes."""
    made = Deviations(ring_pin_radial=(1e-5, *[0.0] * 20))
    assert having(REF, deviations=made, distribution_factor=1.4).distribution_factor == 1.4


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"distribution_factor": 2.0000001}, "more_than_whole"),
        ({"distribution_factor": 0.99}, "greater_than_equal"),
        ({"distribution_factor": 1.1, "satellites": 1, "distribution_of": "discs"},
         "more_than_whole"),
    ],
)  # fmt: skip
def test_no_disc_carries_more_than_all(changes: dict[str, float], code: str) -> None:
    with pytest.raises(InvalidInput) as refused:
        having(REF, **changes)
    assert refused.value.parameter == "contact.distribution_factor"
    assert refused.value.code == code


def test_of_one_disc_the_factor_is_of_its_pins() -> None:
    alone = having(REF, satellites=1, distribution_factor=3.0)
    assert (alone.distribution_of, alone.disc_factor) == ("pins", 1.0)
    assert having(REF, distribution_factor=2.0).distribution_of == "discs"
    many = having(REF, distribution_factor=3.0, distribution_of="pins")
    assert (many.distribution_factor, many.disc_factor) == (3.0, 1.0)
