"""Satellites on bending pins share the load otherwise under another torque: the torque reserve of
each check is the factor under which the whole design, asked again, is at its limit.
"""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_checks
from core.derived import if_known
from core.design.document import Design
from core.design.results import Results
from core.design.sections import DesignPin, FatigueBasis, Friction, RollingBearing, Shaft
from core.output.mechanism import Mechanism
from core.output.moving_sharing import MovingSharing, SharedPinTurn, torque_factors
from core.output.pin_turn import PinTurn, SatelliteTurn
from tests.inputs.checks import WHOLE, check_of, having
from tests.oracles.seeds import seeds

CLOSE = 1e-6
SUPPORTS = ("cantilever", "supported", "fixed")


def drawn(support: str, seed: int) -> Design:
    """A design with all sections and limits, of some size, under some torque."""
    draw = random.Random(f"{support} {seed}")

    def spread(low: float, high: float) -> float:
        return low * (high / low) ** draw.random()

    satellites, radius = draw.choice((1, 2, 2, 3, 3)), 0.008
    width, first = spread(0.008, 0.03), spread(1.0, 1.5) / 2
    places = tuple(width * (first + 1.2 * j) for j in range(satellites))
    eccentricity, torque = spread(0.0005, 0.003), spread(5.0, 1000.0)
    size = radius * spread(0.6, 0.95) if draw.random() < 0.3 else radius
    assert WHOLE.pin is not None and WHOLE.gear is not None
    kinds = (draw.choice(("ball", "roller")), draw.choice(("ball", "roller")))
    return having(
        WHOLE,
        pins=draw.randint(2, 8),
        satellites=satellites,
        crank_spacing=draw.choice((None, math.radians(spread(40.0, 200.0)))),
        output_torque=torque,
        peak_torque=draw.choice((None, 2 * torque)),
        torque_direction=draw.choice(("driving", "reverse", "alternating")),
        force_exponent=draw.choice((1.0, 1.0, 0.0, 10 / 9, 1.5)),
        contact_length=width,
        eccentricity=eccentricity,
        hole_radius=radius + eccentricity,
        pin=DesignPin(
            support=support,  # type: ignore[arg-type]
            diameter=2 * size,
            satellite_positions=places,
            span=None if support == "cantilever" else places[-1] + width * spread(0.6, 1.0),
            material=WHOLE.pin.material,
            tensile_strength=1000e6,
            rotates=draw.random() < 0.2,
        ),
        fatigue=FatigueBasis(
            endurance_limit=spread(50e6, 500e6),
            criterion=draw.choice(("goodman", "gerber", "fkm_haigh")),
        ),
        friction=Friction(coefficient=0.08, wear_rate=1e-17, sleeve=size < radius),
        gear=replace(WHOLE.gear, kind="none", module=None, teeth_difference=None),
        bearing=RollingBearing(
            kind=kinds[0],
            dynamic_rating=spread(10e3, 300e3),
            static_rating=spread(2e3, 100e3),
            weibull_slope=10 / 9,
        ),
        crankshaft=Shaft(
            satellite_positions=tuple(0.02 + z for z in places),
            bearing_positions=(0.0, 0.05 + places[-1]),
            bearings=(
                RollingBearing(kind=kinds[0], dynamic_rating=spread(10e3, 300e3)),
                RollingBearing(kind=kinds[1], dynamic_rating=spread(10e3, 300e3)),
            ),
        ),
        max_pv=spread(1e5, 1e8),
        max_wear=spread(1e-5, 1e-2),
        max_slope=spread(1e-4, 1e-2),
        max_deflection=spread(1e-6, 1e-3),
    )


def under(design: Design, factor: float) -> Design:
    torque, peak = design.load.output_torque, design.load.peak_torque
    assert torque is not None
    return having(design, output_torque=torque * factor, peak_torque=peak and peak * factor)


def meets(design: Design, check: Check) -> bool:
    """Whether a check is at its limit under its reserve, or would jump over it beyond."""
    reserve = check.torque_reserve
    assert reserve is not None
    there = check_of(check.code, under(design, reserve)).utilisation
    if there is None or abs(there - 1) <= CLOSE:  # no ratio of widths where Persson's holds
        return True
    beyond = check_of(check.code, under(design, reserve * (1 + CLOSE))).utilisation
    return there < 1 and (beyond is None or beyond > 1)


def judged(design: Design) -> list[Check]:
    return [
        each
        for each in crank_checks(Results(design)).checks
        if 0.05 < (each.torque_reserve or 0.0) < 100
    ]


def missing(support: str, seeds: range) -> list[tuple[int, str]]:
    return [
        (seed, check.code)
        for seed in seeds
        for design in (drawn(support, seed),)
        for check in judged(design)
        if not meets(design, check)
    ]


@pytest.mark.parametrize("support", SUPPORTS)
def test_under_its_reserve_each_check_is_at_its_limit(support: str) -> None:
    assert missing(support, seeds(4)) == []


def test_where_the_conformal_pressure_governs_on_a_sloping_pin() -> None:
    """The limit is reached by the line load at the edge, 8.7 times the mean one."""
    design = having(WHOLE, hole_radius=0.00805, eccentricity=5e-5, output_torque=1000.0)
    check = check_of("contact_pressure_hole", design)
    assert (
        Results(design).hertz is not None and Results(design).hertz.conformal_pressure is not None
    )
    assert Results(design).line_load_factor > 8
    assert check.torque_reserve is not None and abs(check.torque_reserve - 1) > 0.1
    there = check_of("contact_pressure_hole", under(design, check.torque_reserve))
    assert there.utilisation == pytest.approx(1, abs=CLOSE)


@pytest.mark.parametrize("support", SUPPORTS)
def test_static_strength_is_that_of_a_design_under_the_peak_torque(support: str) -> None:
    """The satellites share the peak torque as they would if it were there all the time."""
    moved = set()
    for design in (having(drawn(support, seed), peak_torque=None) for seed in range(8)):
        assert design.load.output_torque is not None
        peak = having(design, peak_torque=10 * design.load.output_torque)
        for code, power in (("pin_static", 1), ("bearing_static", -1)):
            values = [check_of(code, each).value for each in (design, peak, under(design, 10.0))]
            plain, found, there = (each or 0.0 for each in values)
            assert found == pytest.approx(there, rel=1e-12)
            if plain and abs(found / (10**power * plain) - 1) > 1e-3:  # there is no dead centre
                moved.add(code)
    assert moved >= ({"pin_static", "bearing_static"} if support == "fixed" else {"bearing_static"})


def test_these_designs_have_what_moves() -> None:
    designs = [drawn(support, seed) for support in SUPPORTS for seed in range(24)]
    assert (
        sum(
            if_known(lambda each=design: Results(each).pair_stiffness) is not None
            for design in designs
        )
        > 48
    )
    found = {check.code for design in designs[:12] for check in judged(design)}
    assert found >= {
        "contact_pressure_pin", "contact_pressure_hole", "contact_shakedown_hole", "pin_static",
        "pin_fatigue", "pin_deflection", "pin_slope", "wear", "bearing_life", "bearing_static",
        "system_life", "crank_bearing_life",
    }  # fmt: skip


MECHANISM = Mechanism.evenly_spaced(pins=5, satellites=3, ratio=20.0, crank_spacing=1.3)


@pytest.mark.parametrize("exponent", [0.0, 1.0, 1.5])
def test_one_turn_tells_the_forces_of_another_sharing(exponent: float) -> None:
    one, other = (3.0, 1.0, 2.0), (5.0, 0.5, 2.5)
    own = PinTurn(MECHANISM, exponent, one), SatelliteTurn(MECHANISM, exponent, one)
    turn, direct = SharedPinTurn(*own), PinTurn(MECHANISM, exponent, other)
    samples = np.tile(turn.nodes, (len(turn.arcs), 1))
    assert np.allclose(turn.forces, turn.at(turn.arcs)(samples).swapaxes(0, 1), rtol=1e-14)
    way = np.tile([0.0, 0.2, 0.7, 1.0], (len(direct.arcs), 1))
    shares, forces = np.split(turn.at(direct.arcs)(way), 2, axis=1)
    assert np.allclose(shares.sum(axis=1), 1, rtol=1e-14)
    grown = (np.array(other) / one)[:, None]
    moved = grown * forces / (grown * shares).sum(axis=1, keepdims=True)
    assert np.allclose(moved, direct.at(direct.arcs)(way), rtol=1e-12, atol=1e-14)


def test_the_contact_in_series_gets_stiffer_with_the_force() -> None:
    """Of pins that give 3 and 1 um/kN, and contacts that give 2 less 0.1 at each doubling."""
    moving = MovingSharing(
        stiffness=(1 / 5e-9, 1 / 3e-9),
        compliance=lambda force: 2e-9 - 0.1e-9 * np.log2(force / 1e3),
        force=1e3,
        mechanism=MECHANISM,
        force_exponent=1.0,
    )
    by_hand = [[5 / 5, 3 / 3], [5 / 4.9, 3 / 2.9], [5 / 5.1, 3 / 3.1]]
    assert moving.under(np.array([1.0, 2.0, 0.5])) == pytest.approx(np.array(by_hand), rel=1e-12)
    assert moving.equal * moving.stiffness == pytest.approx(np.full(2, 1 / 5e-9), rel=1e-12)


def test_factors_of_what_grows_about_with_the_torque() -> None:
    looks = []

    def value(factors: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
        looks.append(factors)
        return np.asarray(7.0 * factors ** (1 + 0.02 * np.log(factors)))

    targets = np.array([0.1, 0.99, 1.0, 1.3, 80.0, 0.0, np.inf])
    found = torque_factors(targets=targets, value=value)
    grown = found[:5] ** (1 + 0.02 * np.log(found[:5]))
    assert grown == pytest.approx(targets[:5], rel=1e-9)
    assert found[5:].tolist() == [0.0, math.inf] and len(looks) <= 4


def test_what_does_not_grow_is_out_of_reach() -> None:
    found = torque_factors(targets=np.array([2.0]), value=np.ones_like)
    assert 1e6 < found[0] < math.inf
