"""Shares of the satellites: springs by hand, symmetries, cases with and without an answer."""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.reserve import crank_verdict
from core.checks.shares import DiscShares, disc_shares
from core.design.document import Design
from core.design.results import Results
from core.output.elasticity import CrankSupport, LinearLaw, Shares
from core.output.room import Deviations
from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.checks import REF, WHOLE, having

BENT = having(REF, input_speed=50 * math.pi, pin=WHOLE.pin)
LOOSE = having(REF, hole_radius=0.01002)


def shares_of(design: Design) -> DiscShares | None:
    results = Results(design)
    return disc_shares(results=results, found=crank_verdict(results))


def bent_by(z: float) -> float:
    """Deflection of a steel cantilever of 16 mm by 1 N at z, in mm: bending, and shear by 10/9."""
    inertia, area = math.pi * 16**4 / 64, math.pi * 16**2 / 4
    return z**3 / (3 * 210e3 * inertia) + 10 / 9 * z / (210e3 / 2.6 * area)


@pytest.mark.parametrize("stiffness", [5e4, 2e5])
def test_pins_that_bend_share_by_their_springs(stiffness: float) -> None:
    """Contact and pin in series, N/mm: of an even number of phases the lever's part is alike."""
    found = shares_of(having(BENT, contact_law=LinearLaw(stiffness * 1e3)))
    assert found is not None
    near, far = (1 / (1 / stiffness + bent_by(z)) for z in (15, 37))
    assert [each.share for each in found.discs] == pytest.approx(
        [near / (near + far), far / (near + far)], rel=2e-3
    )
    assert [each.torque for each in found.discs] == pytest.approx(
        [500 * each.share for each in found.discs]
    )
    assert (found.model, found.reason) == ("real", "pin_bending")
    assert found.largest.satellite == 1 and found.largest.share_at_peak > 0.5


def test_satellites_that_are_alike_say_nothing() -> None:
    three = having(LOOSE, satellites=3)
    single = having(BENT, satellites=1, pin=replace(BENT.pin, satellite_positions=(0.015,)))
    for design in (REF, LOOSE, three, single, having(LOOSE, crank_support=CrankSupport(1e8))):
        assert shares_of(design) is None


def test_cranks_that_are_not_even_share_by_their_clearance() -> None:
    angles = tuple(math.radians(each) for each in (0, 90, 180))
    found = shares_of(having(LOOSE, satellites=3, crank_angles=angles, hole_radius=0.0101))
    assert found is not None and found.reason == "clearance"
    first, middle, last = (each.share for each in found.discs)
    assert abs(first - last) < 0.01 < abs(middle - first)
    assert first + middle + last == pytest.approx(1, rel=EXACT)


def test_shares_that_are_stated_are_those() -> None:
    found = shares_of(having(LOOSE, satellite_coupling=Shares((0.3, 0.7))))
    assert found is not None and (found.model, found.reason) == ("given", "given")
    assert [each.share for each in found.discs] == pytest.approx([0.3, 0.7], rel=SEARCHED)
    assert found.largest.satellite == 2


def turned(by: float) -> Deviations:
    return Deviations(disc_phase=(0.0, by))


def test_the_larger_cause_is_named() -> None:
    """A disc that is turned ahead carries more, whatever the pins do."""
    alone = shares_of(having(LOOSE, deviations=turned(1e-4)))
    assert alone is not None and alone.reason == "deviations"
    ahead = alone.largest.satellite
    bent = having(BENT, hole_radius=0.0102)
    little = shares_of(having(bent, deviations=turned(1e-7)))
    assert little is not None and little.reason == "pin_bending"
    for by in (3e-3, -3e-3):
        much = shares_of(having(bent, deviations=turned(by)))
        assert much is not None
        assert much.largest.satellite == (ahead if by > 0 else 3 - ahead)
        assert much.reason == ("pin_bending" if much.largest.satellite == 1 else "deviations")


@pytest.mark.parametrize(
    ("factor", "said", "warned"),
    [(1.0, False, False), (1.0099, False, False), (1.0101, True, False), (1.0999, True, False),
     (1.1001, True, True), (2.0, True, True)],
)  # fmt: skip
def test_what_is_said_of_a_factor(factor: float, said: bool, warned: bool) -> None:
    found = shares_of(having(REF, distribution_factor=factor))
    assert (found is not None) == said
    if found is None:
        return
    assert (found.model, found.reason) == ("factor", "given")
    assert found.largest.share == pytest.approx(factor / 2, rel=SAME)
    assert sum(each.share for each in found.discs) == pytest.approx(1, rel=SAME)
    assert bool(found.notices) == warned
    if warned:
        (notice,) = found.notices
        assert notice.params["satellite"] == found.largest.satellite
        assert (notice.params["share"], notice.params["even"]) == (factor / 2, 0.5)


def test_a_factor_of_pins_is_no_share_of_discs() -> None:
    assert shares_of(having(REF, distribution_factor=1.5, distribution_of="pins")) is None


def test_numbers_of_even_shares_are_said_where_they_are_known() -> None:
    """Perfect parts have the numbers of the papers; clearance would need another solution."""
    found = shares_of(WHOLE)
    assert found is not None
    assert "bearing_life" in {each.check.code for each in found.governs}
    even = Results(WHOLE, equal=True)
    for each in found.governs:
        assert each.even is not None
        if each.check.code == "bearing_life":
            assert each.even.value == pytest.approx(even.crank.bearings.life.min(), rel=SAME)
            assert each.check.value < each.even.value
    still = replace(WHOLE.crankshaft, satellite_mass=None)  # type: ignore[type-var]
    factor = shares_of(having(WHOLE, crankshaft=still, distribution_factor=1.5))
    assert factor is not None
    values: dict[str, Any] = {each.check.code: each for each in factor.governs}
    life = values["bearing_life"]
    assert life.even.value / life.check.value == pytest.approx(1.5**3, rel=EXACT)
    loose = shares_of(having(WHOLE, hole_radius=0.01002))
    assert loose is not None and loose.governs
    assert all(each.even is None for each in loose.governs)


def test_what_no_torque_moves_is_not_governed() -> None:
    found = shares_of(having(WHOLE, min_efficiency=0.9, max_outer_diameter=0.3))
    assert found is not None
    assert not {"efficiency", "outer_diameter"} & {each.check.code for each in found.governs}


def test_the_directions_are_those_that_are_judged() -> None:
    """In reverse the disc that lay behind comes first."""
    ahead = having(LOOSE, deviations=turned(1e-4))
    for direction, other in (("driving", "reverse"), ("reverse", "driving")):
        one, two = (shares_of(having(ahead, torque_direction=each)) for each in (direction, other))
        assert one is not None and two is not None
        assert one.largest.satellite != two.largest.satellite
        assert one.largest.torque > 250
