"""A ring as such rings usually are: its draws by raw words of Philox, its numbers by turns of the
meshes that are drawn, each solved with its summits.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from core.checks.usual_fit import usual_clearance
from core.checks.usual_modification import (
    UsualModification,
    ring_places,
    usual_clearance_too,
    usual_modification,
)
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing, OtherRing, usual_sizes
from core.hertz import ContactLimit, ElasticMaterial
from core.output.room import Deviations
from core.precision import SAME
from core.ring.profile import Modification
from core.ring.sharing import RingDeviations, mesh_over_turn
from tests.inputs.checks import design_of, having

HARD = ElasticMaterial(210e9, 0.3, ContactLimit("given", 2500e6))
FEW = design_of(
    pins=6,
    satellites=1,
    ratio=11.0,
    output_torque=100.0,
    application_factor=1.2,
    pin_circle_radius=0.03,
    contact_length=0.01,
    eccentricity=0.0025,
    scope=("teeth",),
    gear=CycloidRing(
        ring_pin_circle_radius=0.06,
        ring_pin_radius=0.005,
        pin_material=HARD,
        disc_material=HARD,
    ),
)
PINS, U = 12, 6e-6


def ringed(design: Design = FEW, /, **changes: Any) -> Design:
    """A design with another ring."""
    return having(design, gear=replace(design.gear, **changes))  # type: ignore[type-var]


def usual(design: Design) -> UsualModification:
    found = usual_modification(design)
    assert found is not None
    return found


def drawn(kind: int, pin: int) -> np.ndarray:
    """The first 64 words of a stream, of the seed 0."""
    bits = np.random.Philox(key=np.array([0, kind * 2**32 + pin], dtype=np.uint64))
    return ((bits.random_raw(64) >> np.uint64(11)).astype(float) + 0.5) / 2.0**53


def places(sample: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Places of ring pins, spread evenly over discs with a radius of 3 um."""
    polar = [
        U / 2 * math.sqrt(drawn(9, k)[sample]) * np.exp(2j * math.pi * drawn(10, k)[sample])
        for k in range(PINS)
    ]
    return tuple(each.real for each in polar), tuple(each.imag for each in polar)


@pytest.fixture(scope="module")
def few() -> UsualModification:
    return usual(FEW)


def test_rings_are_drawn_by_streams_of_their_own() -> None:
    rings = ring_places(pins=PINS, radius=U / 2, samples=64)
    for sample in (0, 1, 63):
        assert np.allclose(rings[sample], places(sample), rtol=SAME, atol=0)


def test_half_and_nine_tenths_of_the_rings_have_no_more(few: UsualModification) -> None:
    """The 32nd and the 58th of 64, of a modification of a ten-thousandth of the circle's radius;
    the grid of 720 positions misses some 3e-4 of a summit of 12 pins. The 58th is judged.
    """
    mesh = Results(ringed(modification=Modification(equidistant=U))).ring.mesh
    turns = [
        mesh_over_turn(
            mesh=replace(mesh, deviations=RingDeviations(*places(sample))), output_torque=120.0
        )
        for sample in range(64)
    ]
    assert (few.samples, few.ring_class) == (64, "ground")
    assert (few.equidistant, few.pin_zone_diameter) == (pytest.approx(U), pytest.approx(U))
    for name, spread, missed in (
        ("peak_force", few.peak_force, 5e-4),
        ("max_pressure", few.max_pressure, 5e-4),
        ("backlash_max", few.backlash, 2e-3),  # whose summits are cusps
    ):
        ascending = sorted(getattr(turn, name) for turn in turns)
        assert spread == pytest.approx((ascending[31], ascending[57]), rel=missed)
    assert few.cannot_assemble == 0
    pressures = [turn.max_pressure or 0.0 for turn in turns]
    worst = pressures.index(sorted(pressures)[57])
    made = few.results.design.deviations
    assert made is not None and np.allclose(made.ring_pin_radial, places(worst)[0], rtol=SAME)
    check = few.verdict["ring_pressure_pin"]
    assert check.value == pytest.approx(few.max_pressure.percent_90, rel=5e-4)


def test_both_directions_count(few: UsualModification) -> None:
    back = usual(having(FEW, torque_direction="reverse"))
    both = usual(having(FEW, torque_direction="alternating"))
    each = (few.max_pressure.median, back.max_pressure.median)
    assert each[0] != each[1] and both.max_pressure.median > max(each)


def test_a_share_that_is_stated_is_on_the_torque() -> None:
    two = having(FEW, satellites=2)
    stated = usual(having(two, distribution_factor=1.3))
    assert stated.peak_force == pytest.approx(usual(having(two, output_torque=130.0)).peak_force)


def test_how_rings_are_made() -> None:
    """Ground, at least 5 um; machined and printed ones by the sizes of guides; soft discs are
    printed, unless it is said otherwise.
    """
    assert usual_sizes(ring_class="ground", circle_radius=0.03) == (5e-6, 2.5e-6)
    assert usual_sizes(ring_class="machined", circle_radius=0.1) == (3e-5, 2.5e-5)
    assert usual_sizes(ring_class="printed", circle_radius=0.1) == (2.2e-4, 1.5e-4)
    soft = ringed(disc_material=ElasticMaterial(19e9, 0.35))
    assert (FEW.ring_class, soft.ring_class) == ("ground", "printed")
    assert ringed(soft, ring_class="machined").ring_class == "machined"


def test_what_is_known_stays() -> None:
    """A modification, or places of the pins; of both nothing is drawn."""
    stated = usual(ringed(modification=Modification()))
    assert (stated.equidistant, stated.pin_zone_diameter) == (0.0, pytest.approx(U))
    assert stated.cannot_assemble == 1.0 and stated.verdict.verdict == "fail"
    off = Deviations(ring_pin_radial=(1e-6,) * PINS)
    placed = usual(having(FEW, deviations=off))
    assert (placed.samples, placed.pin_zone_diameter) == (1, 0.0)
    assert placed.results.design.deviations == off
    modified = ringed(modification=Modification(equidistant=U))
    assert usual_modification(having(modified, deviations=off)) is None
    assert usual_modification(ringed(ring_pin_radius=None)) is None
    assert usual_modification(having(FEW, scope=("contact",))) is None
    assert usual_modification(having(FEW, gear=OtherRing(kind="none"))) is None


def test_each_takes_the_usual_value_of_the_other() -> None:
    """Cases: unknown clearance; unknown modification with a clearance stated to be 0."""
    holed = having(FEW, pin_radius=0.006, hole_radius=0.0085, scope=("teeth", "contact"))
    holed = having(holed, pin_material=HARD, hole_material=HARD)
    unknown = having(holed, clearance_stated=False)
    ring = usual(unknown)
    name, clearance = usual_clearance(unknown)
    assert ring.results.design.clearance == pytest.approx(clearance)
    found = usual_clearance_too(design=unknown, ring=ring)
    assert found is not None
    assert (found.name, found.results, found.judged) == (name, ring.results, ring.verdict)
    perfect = usual(holed)
    assert perfect.results.design.clearance == 0
    beside = usual_clearance_too(design=holed, ring=perfect)
    assert beside is not None
    made = beside.results.design
    assert made.clearance == pytest.approx(clearance)
    assert made.gear.modification == Modification(equidistant=pytest.approx(U))
    assert made.deviations == perfect.results.design.deviations


def test_discs_that_stand_off_their_valleys_are_judged() -> None:
    """Printed ones are modified by more than the path of a pin is round there."""
    sharp = having(FEW, eccentricity=0.0045)
    printed = usual(ringed(sharp, ring_class="printed", ring_pin_radius=0.001))
    mesh = printed.results.ring.mesh
    assert mesh.exact and mesh.disc.modification.equidistant > 2 * mesh.disc.valley_radius
    found = mesh_over_turn(mesh=mesh, output_torque=120.0)
    assert found.max_pressure == pytest.approx(
        printed.max_pressure.percent_90, rel=0.01
    )  # 720 places
    teeth = next(part for part in printed.verdict.parts if part.code == "teeth")
    assert teeth.status != "open"
