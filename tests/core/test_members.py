"""Crank, pins and ring: against velocities at the pitch point and the statics of a satellite, and
limits in which one member is as good as another.
"""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.checks.crank_planetary import crank_check
from core.design.document import changed
from core.design.results import Results
from core.design.sections import SeatedBearing
from core.errors import NotKnown, is_known
from core.output.mechanism import Members, Output
from core.precision import CONVERGED, EXACT, SAME, SEARCHED
from tests.inputs.checks import WHOLE, having

RATIOS = st.floats(1.0, 200.0)
SPEEDS = st.floats(-400.0, 400.0)
DRIVEN: tuple[Output, ...] = ("pins", "ring", "both")


@given(RATIOS, SPEEDS, SPEEDS, st.sampled_from(DRIVEN))
def test_the_teeth_roll_on_each_other_at_the_pitch_point(
    ratio: float, crank: float, ring: float, output: Output
) -> None:
    """The satellite turns with the pins, its centre with the crank: at the pitch point it is as
    fast as the ring there."""
    speeds = Members(output, ratio).speeds(crank=crank, ring=ring if output == "both" else None)
    e, to_pitch = 1.0, ratio + 1.0  # the pitch point is u + 1 eccentricities from the axis
    of_satellite = speeds.crank * e + speeds.carrier * (to_pitch - e)
    scale = abs(speeds.crank) + (ratio + 1) * (abs(speeds.carrier) + abs(speeds.ring))
    assert of_satellite == pytest.approx(speeds.ring * to_pitch, abs=1e-13 * (1 + scale))
    assert speeds.crank == crank
    if output != "both":
        assert 0.0 in (speeds.ring, speeds.carrier)


@given(RATIOS, SPEEDS, SPEEDS)
def test_both_by_the_ring_and_by_the_pins_are_the_same_motion(
    ratio: float, crank: float, ring: float
) -> None:
    both = Members("both", ratio)
    by_ring = both.speeds(crank=crank, ring=ring)
    assert by_ring is not None
    by_pins = both.speeds(crank=crank, carrier=by_ring.carrier)
    assert by_pins is not None and by_pins.ring == pytest.approx(ring, abs=1e-11)
    with pytest.raises(NotKnown):
        both.speeds(crank=crank)


@given(RATIOS, SPEEDS, SPEEDS, st.floats(1.0, 1e4), st.sampled_from(DRIVEN))
def test_torques_and_powers_close(
    ratio: float, crank: float, ring: float, torque: float, output: Output
) -> None:
    members = Members(output, ratio)
    speeds = members.speeds(crank=crank, ring=ring if output == "both" else None)
    found = members.loads(output_torque=torque, speeds=speeds)
    # moments of the pins' couple and of the ring's force, u eccentricities away, on a satellite
    across = found.pin_torque / ratio
    assert found.crank_torque == pytest.approx(across, rel=CONVERGED)
    assert found.ring_torque == pytest.approx(-across * (ratio + 1), rel=CONVERGED)
    total = found.crank_torque + found.pin_torque + found.ring_torque
    assert abs(total) <= 1e-14 * abs(found.ring_torque)
    moved = max(map(abs, (found.crank_power, found.carrier_power, 1e-9)))
    assert abs(found.power_balance) <= 1e-12 * (moved + abs(found.ring_power))
    typed = -found.ring_torque if output == "ring" else found.pin_torque
    assert typed == pytest.approx(torque, rel=CONVERGED)


@pytest.mark.parametrize("output", ["pins", "ring"])
def test_the_ratio_is_that_of_the_speeds_and_of_the_torques(output: Output) -> None:
    members = Members(output, 20.0)
    speeds = members.speeds(crank=150.0)
    assert members.output_ratio is not None
    driven = speeds.carrier if output == "pins" else speeds.ring
    assert speeds.crank / driven == pytest.approx(members.output_ratio, rel=CONVERGED)
    found = members.loads(output_torque=500.0, speeds=speeds)
    assert 500.0 / found.crank_torque == pytest.approx(members.torque_ratio, rel=CONVERGED)
    assert found.output_power == pytest.approx(500.0 * abs(driven), rel=CONVERGED)


def test_a_coupling_drives_without_a_crank() -> None:
    coupling = Members("coupling", math.inf)
    found = coupling.loads(output_torque=20.0, speeds=coupling.speeds(crank=100.0))
    assert (found.speeds.turning, abs(found.speeds.relative)) == (100.0, 100.0)
    assert (found.output_ratio, found.output_power) == (1.0, 2000.0)
    assert (found.crank_torque, found.power_balance) == (0.0, 0.0)
    assert found.pin_torque + found.ring_torque == 0.0
    assert (
        coupling.input_torque(0.5, 20.0) == 20.5 and Members("pins", 5.0).input_torque(4, 20) == 4
    )


def test_a_ring_is_the_design_of_pins_under_its_share_of_torque_and_speed() -> None:
    """Parts are those of the pins' problem; values at the ring follow by virtual work."""
    u = WHOLE.mechanism.ratio
    share = u / (u + 1)
    ring = Results(changed(WHOLE, {"mechanism.output": "ring"}))
    load = WHOLE.load
    assert load and load.input_speed is not None
    pins = Results(
        changed(
            WHOLE,
            {
                "load.output_torque": load.output_torque * share,
                "load.input_speed": load.input_speed * share,
                "load.peak_torque": load.peak_torque and load.peak_torque * share,
            },
        )
    )
    close = {"rel": 1e-12}
    assert ring.contact_force.peak_force == pytest.approx(pins.contact_force.peak_force, **close)
    assert ring.hertz.max_pressure == pytest.approx(pins.hertz.max_pressure, **close)
    light = {"crankshaft.satellite_mass": None}  # what a satellite weighs its bearing feels
    bearings = [Results(changed(each.design, light)).crank.bearings for each in (ring, pins)]
    for name in ("relative_speed", "equivalent_load", "life", "peak_load"):
        one, two = (getattr(each, name) for each in bearings)
        assert one == pytest.approx(two, **close), name
    for name in ("sliding_speed", "mean_loss", "pin_wear", "peak_pv"):
        one, two = (getattr(each.losses.pins, name) for each in (ring, pins))
        assert one == pytest.approx(two, **close), name
    lost = [1 / each.losses.pins.efficiency - 1 for each in (ring, pins)]
    assert lost[0] == pytest.approx(lost[1] * share, **close)
    # the crank's own speed is what it is: bearings in the housing, centrifugal forces
    assert ring.crank.centrifugal == pytest.approx(pins.crank.centrifugal / share**2, **close)
    balance = [each.crank.shaft.balance for each in (ring, pins)]
    assert balance[0] and balance[1]
    assert balance[0].couple == pytest.approx(balance[1].couple / share**2, **close)


def test_speeds_of_crank_bearings_are_those_against_their_seat() -> None:
    lives = {}
    ball = SeatedBearing(kind="ball", dynamic_rating=50e3)
    for seat in ("housing", "carrier", "ring"):
        seated = replace(ball, seat=seat)
        shaft = replace(WHOLE.crankshaft, bearings=(seated, ball))
        design = changed(WHOLE, {"mechanism.output": "ring", "crankshaft": shaft})
        lives[seat] = Results(design).crank.shaft.basic_life[0]
    u = WHOLE.mechanism.ratio
    assert lives["housing"] and lives["carrier"] and lives["ring"]
    assert lives["carrier"] == pytest.approx(lives["housing"], rel=CONVERGED)  # which stands still
    assert lives["ring"] == pytest.approx(lives["housing"] * (u + 1) / u, rel=CONVERGED)


@pytest.mark.parametrize("code", ["backlash", "lost_motion"])
def test_play_is_seen_at_the_output(code: str) -> None:
    made = having(WHOLE, hole_radius=0.01002, max_backlash=1.0, max_lost_motion=1.0)
    u = made.mechanism.ratio
    torque = made.load.output_torque
    pins = crank_check(code, Results(changed(made, {"load.output_torque": torque * u / (u + 1)})))
    ring = crank_check(code, Results(changed(made, {"mechanism.output": "ring"})))
    assert pins.value and ring.value
    assert ring.value == pytest.approx(pins.value * u / (u + 1), rel=EXACT)


def test_where_the_ratio_grows_ring_and_pins_are_alike() -> None:
    """Forces and losses differ by 1/u."""
    for ratio in (1e3, 1e6):
        found = [
            Results(
                changed(
                    having(WHOLE, gear=None, pin=None, crankshaft=None),
                    {"mechanism.output": each, "mechanism.ratio": ratio},
                )
            )
            for each in ("pins", "ring")
        ]
        forces = [each.contact_force.peak_force for each in found]
        lost = [1 / each.losses.pins.efficiency - 1 for each in found]
        assert forces[0] / forces[1] - 1 == pytest.approx(1 / ratio, rel=SEARCHED)
        assert lost[0] / lost[1] - 1 == pytest.approx(1 / ratio, rel=1e-2)


def test_members_that_turn_as_one_neither_slide_nor_roll() -> None:
    speed = WHOLE.load.input_speed
    locked = {"mechanism.output": "both", "load.ring_speed": speed}
    results = Results(changed(WHOLE, locked))
    losses = results.losses.pins
    assert (losses.mean_loss, losses.sliding_speed, losses.efficiency) == (0.0, 0.0, 1.0)
    assert not is_known(lambda: results.crank.bearings.life)
    check = crank_check("bearing_life", results)
    assert (check.status, check.reason) == ("not_applicable", "members_locked")
    assert results.design.loads_over(3600.0) == math.inf


def test_the_peak_torque_is_that_of_the_output_too() -> None:
    """Static safety hangs on it alone: of the ring by its share on the pins."""
    u = WHOLE.mechanism.ratio
    torque = WHOLE.load.output_torque
    safeties = []
    for output, more in (("pins", 1.0), ("ring", (u + 1) / u)):
        values = {"load.output_torque": torque * more, "load.peak_torque": 2 * torque * more}
        results = Results(changed(WHOLE, {"mechanism.output": output} | values))
        safeties.append(results.crank.bearings.static_safety_factor)
    assert safeties[1] == pytest.approx(safeties[0], rel=EXACT)


def test_bearings_turn_by_the_members_speeds() -> None:
    crank = WHOLE.load.input_speed
    assert crank
    u = WHOLE.mechanism.ratio
    for output, speed in (("pins", crank * (u + 1) / u), ("ring", crank)):
        results = Results(changed(WHOLE, {"mechanism.output": output}))
        assert crank_check("bearing_speed", results).value == pytest.approx(speed, rel=SAME)
    ball = SeatedBearing(kind="ball", dynamic_rating=50e3, limiting_speed=2 * crank)
    for seat, speed in (("housing", crank), ("ring", crank * u / (u + 1))):
        shaft = replace(WHOLE.crankshaft, bearings=(replace(ball, seat=seat),) * 2)
        design = changed(WHOLE, {"mechanism.output": "ring", "crankshaft": shaft})
        found = crank_check("crank_bearing_speed", Results(design))
        assert (found.value, found.limit) == (pytest.approx(speed, rel=SAME), 2 * crank)
