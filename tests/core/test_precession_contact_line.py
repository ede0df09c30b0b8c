"""Invariants, refusals and points of the contact lines."""

import math
from typing import Any

import numpy as np
import pytest
from mpmath import mpf

from core.errors import CalculationError, ImpossibleMechanism, InvalidInput
from core.numerics.quadrature import NODES
from core.precession.contact_line import ContactLine, contact_lines, contact_points
from core.precession.rollers import RollerByAngle, RollerByLength, wheel_rollers
from core.precision import EXACT, HARDLY_KNOWN, JUDGED, ROUNDING, SAME
from tests.oracles.condition import condition
from tests.oracles.precession import z_of_angle

GEAR: dict[str, Any] = {
    "roller_circle_radius": 0.05,
    "roller_radius": 0.004,
    "nutation_angle": math.radians(6),
    "ratio_u12": 24 / 25,
}


@pytest.mark.parametrize("half_turns", [-2, -1, 0, 1, 3])
@pytest.mark.parametrize("phi_1", [0.3, 1.2, -2.0, 16.0])
def test_points_satisfy_eq_1_on_either_flank(phi_1: float, half_turns: int) -> None:
    (line,) = contact_lines(**GEAR, rollers=[RollerByLength(phi_1, -0.02, 0.025)]).lines
    roller = RollerByAngle(
        phi_1, line.phi_min + half_turns * math.pi, line.phi_max + half_turns * math.pi
    )
    (flank,) = contact_lines(**GEAR, rollers=[roller]).lines
    assert flank.flank == half_turns
    assert flank.length == pytest.approx(line.length, rel=SAME)
    assert -math.pi <= line.phi_max and line.phi_min <= math.pi
    points = contact_points(line=flank, samples=41)
    scale = line.curve.scale
    assert points.z == pytest.approx(
        -scale * np.sin(points.phi) / np.sin(points.phi + phi_1), abs=1e-12
    )
    assert sorted((points.phi[0], points.phi[-1])) == pytest.approx(
        [roller.phi_min, roller.phi_max], abs=1e-12
    )
    assert np.all(np.diff(points.phi) > 0) or np.all(np.diff(points.phi) < 0)
    # on the roller: at its radius from its axis
    axis = 0.05 * np.array([-math.sin(phi_1), math.cos(phi_1)])
    distance = np.hypot(*(points.position[:, :2] - axis).T)
    assert distance == pytest.approx(0.004, rel=SAME)
    assert points.x == pytest.approx(0.004 * points.phi)
    # the polyline of many points is as long as the line
    fine = contact_points(line=flank, samples=4001)
    steps = np.hypot(np.diff(fine.z), np.diff(fine.x))
    assert steps.sum() == pytest.approx(flank.length, rel=JUDGED)


@pytest.mark.parametrize("torque_sign", [1, -1])
@pytest.mark.parametrize(("z_min", "z_max"), [(0.01, 0.02), (-0.02, -0.01)])
def test_the_loaded_flank_has_an_arm_of_the_torques_sign(
    torque_sign: int, z_min: float, z_max: float
) -> None:
    sizes = {"rollers_total": 24, "rollers_in_mesh": 24, "position_angle": 0.1}
    rollers = wheel_rollers(**sizes, z_min=z_min, z_max=z_max)
    assert len(rollers) == 24
    result = contact_lines(**GEAR, rollers=rollers, torque_sign=torque_sign)
    assert result.accuracy.evaluations % len(NODES) == 0
    for line in result.lines:
        arms = -np.sin(contact_points(line=line).phi)
        assert np.all(arms * torque_sign > 0)
        assert line.arm_sign == torque_sign and isinstance(line.arm_sign, int)
        assert -2 * math.pi < line.phi_min < line.phi_max < 2 * math.pi
        assert abs(line.phi_min + line.phi_max) / 2 <= math.pi or line.flank == 0


ANGLES = dict.fromkeys(("nutation_angle", "position_angle", "phi_min", "phi_max"), 1.5)
NEARLY = math.cos(math.radians(6)) - 1e-4
"""A ratio u12 that leaves A only the last digits of cos(theta)."""
STEEPEST = 0.05 * (math.cos(math.radians(6)) - 24 / 25) / math.sin(math.radians(6))


def one_line(**inputs: float) -> ContactLine:
    """The line of one roller, whose inputs stand beside those of the gear."""
    names = [name for name in inputs if name not in GEAR]
    kind = RollerByAngle if "phi_min" in names else RollerByLength
    roller = kind(**{name: inputs[name] for name in names})
    return contact_lines(**{name: inputs[name] for name in GEAR}, rollers=[roller]).lines[0]


@pytest.mark.parametrize(
    "inputs",
    [
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.025},
        {"position_angle": 0.5, "z_min": 0.015, "z_max": 0.015003},
        {"position_angle": -3.1, "z_min": 0.999 * STEEPEST, "z_max": 1.02 * STEEPEST},
        {"position_angle": 3.1, "z_min": 1.01 * STEEPEST, "z_max": 1.02 * STEEPEST},
        {"position_angle": 2.5, "z_min": 1e-4, "z_max": 2e-4, "ratio_u12": NEARLY},
        {
            "position_angle": 10 * math.pi + 6e-5,
            "z_min": 1e-5 - STEEPEST,
            "z_max": 1e-3 - STEEPEST,
        },
        {"position_angle": 10 * math.pi + 6e-5, "phi_min": 0.001, "phi_max": 0.3},
        {"position_angle": 0.5, "phi_min": -0.35, "phi_max": -0.2},
        {"position_angle": 0.5, "phi_min": -0.499, "phi_max": -0.2},
        {"position_angle": 0.5, "phi_min": -0.3, "phi_max": -0.2999},
        {"position_angle": 0.5, "phi_min": 200 * math.pi - 0.3, "phi_max": 200 * math.pi - 0.2},
        {"position_angle": 1.5, "phi_min": -0.3, "phi_max": 1.2, "ratio_u12": NEARLY},
    ],
)
def test_the_stated_error_is_the_condition_of_the_input(inputs: dict[str, float]) -> None:
    """Not less than what rounding of every input may do, and not many times more."""
    inputs = GEAR | inputs
    needed = condition(
        lambda **each: one_line(**each).length,
        inputs,
        {**ANGLES, "ratio_u12": 0.5},
        step=1e-7 if inputs["position_angle"] < 4 else 1e-9,
    )
    stated = one_line(**inputs).relative_error / ROUNDING
    # besides the rounding of the input that of the calculation, 2 units at least
    assert needed + 2 <= stated <= 5 * needed + 10


@pytest.mark.parametrize("phi_1", [3.0, 0.1])
def test_limits_in_phi_keep_the_digits_of_their_sum_near_a_pole(phi_1: float) -> None:
    phi = math.pi - phi_1 - 1e-6
    (line,) = contact_lines(**GEAR, rollers=[RollerByAngle(phi_1, phi - 0.1, phi)]).lines
    found = max((line.z_min, line.z_max), key=abs)
    exact = z_of_angle(mpf(line.curve.scale), mpf(phi_1), mpf(phi))
    assert abs(mpf(found) / exact - 1) < 4 * ROUNDING


def test_a_curve_whose_steep_place_is_not_known_to_lie_beside_the_line() -> None:
    """One rounding of u12 moves the steep place into the line, which half the roller lengthens."""
    z_min = 0.05 * 1e-4 / math.sin(math.radians(6)) + 2e-17
    inputs = GEAR | {"position_angle": math.pi - 1.2e-14, "z_max": z_min + 1e-3, "z_min": z_min}
    ratios = [math.nextafter(NEARLY, end) for end in (0.0, 2.0)] + [NEARLY]
    lines = [one_line(**inputs | {"ratio_u12": ratio}) for ratio in ratios]
    lengths = [line.length for line in lines]
    assert max(lengths) > 1e-3 + 0.9 * math.pi * 0.004
    assert min(lengths) < 1.1e-3
    for line in lines:
        assert max(lengths) - min(lengths) <= line.relative_error * line.length


def test_every_line_states_its_own_error() -> None:
    """A short line of which nothing is known beside a long one that is known well."""
    narrow = 0.02 * (1 + 1e-13)
    rollers = [RollerByLength(0.5, 0.015, 0.025), RollerByLength(0.5, 0.02, narrow)]
    result = contact_lines(**GEAR, rollers=rollers)
    known, unknown = result.lines
    assert result.accuracy.relative_error < 1e-14
    assert known.relative_error < 1e-14
    assert 2 * ROUNDING / 1e-13 <= unknown.relative_error < 1e-2


def test_a_length_that_is_hardly_known_is_noticed() -> None:
    for extent, codes in ((1e-12, []), (2e-14, ["hardly_known"])):
        roller = RollerByLength(0.5, 0.02, 0.02 * (1 + extent))
        result = contact_lines(**GEAR, rollers=[roller])
        assert [notice.code for notice in result.notices] == codes
        for notice in result.notices:
            assert notice.params == {"error": result.accuracy.relative_error}
            assert result.accuracy.relative_error > HARDLY_KNOWN == 1e-2
            assert f"{result.accuracy.relative_error:.2g}" in notice.detail


def test_a_wheel_knows_its_rollers_no_better_than_its_first_one() -> None:
    """The position of a roller is a small difference of large angles."""
    (*_, last) = wheel_rollers(
        rollers_total=4,
        rollers_in_mesh=4,
        position_angle=-1.5 * math.pi + 1e-6,
        z_min=0.015,
        z_max=0.025,
    )
    assert last.position_angle == pytest.approx(1e-6, rel=EXACT)
    (of_wheel,) = contact_lines(**GEAR, rollers=[last]).lines
    (alone,) = contact_lines(
        **GEAR, rollers=[RollerByLength(last.position_angle, 0.015, 0.025)]
    ).lines
    assert of_wheel.curve.sine_error >= 1.5 * ROUNDING * 3 * math.pi / 1e-6
    assert alone.curve.sine_error < 4 * ROUNDING


def refusal(kind: type[CalculationError], **changes: Any) -> Any:
    valid: dict[str, Any] = GEAR | {"rollers": [RollerByLength(0.5, 0.015, 0.025)]}
    with pytest.raises(kind) as caught:
        contact_lines(**valid | changes)
    return caught.value


@pytest.mark.parametrize(
    ("parameter", "changes"),
    [
        ("roller_circle_radius", {"roller_circle_radius": 0.0}),
        ("roller_radius", {"roller_radius": 0.05}),
        ("roller_radius", {"roller_radius": 0.0}),
        ("roller_radius", {"roller_radius": math.nan}),
        ("nutation_angle", {"nutation_angle": 0.0}),
        ("nutation_angle", {"nutation_angle": math.pi / 2}),
        ("ratio_u12", {"ratio_u12": math.nan}),
        ("rollers", {"rollers": []}),
        ("torque_sign", {"torque_sign": 0}),
    ],
)
def test_refusals_of_the_gear(parameter: str, changes: dict[str, Any]) -> None:
    assert refusal(InvalidInput, **changes).parameter == parameter


@pytest.mark.parametrize(
    ("field", "roller"),
    [
        ("position_angle", RollerByLength(0.0, 0.015, 0.025)),
        ("position_angle", RollerByLength(math.pi, 0.015, 0.025)),
        ("position_angle", RollerByAngle(-7 * math.pi, 0.1, 0.2)),
        ("z_max", RollerByLength(0.5, 0.02, 0.02)),
        ("z_max", RollerByLength(0.5, 0.02, 0.01)),
        ("z_max", RollerByLength(0.5, 0.02, math.nan)),
        ("phi_max", RollerByAngle(0.5, 0.2, 0.2)),
        ("phi_max", RollerByAngle(0.5, 99.9 * math.pi, 99.9 * math.pi + 2e-13)),  # rounding
        ("phi_max", RollerByAngle(0.5, -1.0, -0.1)),  # across phi = -phi1
        ("phi_max", RollerByAngle(0.5, -0.4, 2.8)),  # across phi = pi - phi1
        ("phi_max", RollerByAngle(0.5, -0.4, 6.0)),  # across both: the sines agree in sign
        ("phi_min", RollerByAngle(0.5, -0.5, 0.1)),  # at the pole
        ("phi_max", RollerByAngle(0.5, 0.1, math.pi - 0.5)),
    ],
)
def test_refusals_of_a_roller(field: str, roller: Any) -> None:
    first = RollerByLength(1.0, 0.015, 0.025)
    caught = refusal(InvalidInput, rollers=[first, roller])
    assert caught.parameter == f"rollers[1].{field}"


def test_no_line_where_cos_theta_is_u12() -> None:
    angle = math.radians(60)
    caught = refusal(ImpossibleMechanism, nutation_angle=angle, ratio_u12=0.5)
    assert caught.where == {"nutation_angle": angle, "ratio_u12": 0.5}


@pytest.mark.parametrize(("z_min", "z_max"), [(-0.01, 0.02), (0.0, 0.02), (-0.02, 0.0)])
def test_a_torque_needs_an_arm(z_min: float, z_max: float) -> None:
    roller = RollerByLength(0.5, z_min, z_max)
    caught = refusal(ImpossibleMechanism, rollers=[roller], torque_sign=1)
    assert caught.where == {"roller": 1.0, "z": 0.0}
    assert contact_lines(**GEAR, rollers=[roller]).lines[0].arm_sign == 0


@pytest.mark.parametrize(
    ("parameter", "changes"),
    [
        ("rollers_total", {"rollers_total": 0}),
        ("rollers_in_mesh", {"rollers_in_mesh": 13}),
        ("rollers_in_mesh", {"rollers_in_mesh": 0}),
        ("z_max", {"z_max": 0.01}),
        ("position_angle", {"position_angle": math.radians(30)}),
    ],
)
def test_refusals_of_a_wheel(parameter: str, changes: dict[str, Any]) -> None:
    sizes = {"rollers_total": 12, "rollers_in_mesh": 12, "position_angle": 0.1}
    valid = sizes | {"z_min": 0.01, "z_max": 0.02}
    with pytest.raises(InvalidInput) as caught:
        wheel_rollers(**valid | changes)
    assert caught.value.parameter == parameter
