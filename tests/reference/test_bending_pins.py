"""Oracle test: pins that bend share their torque by what gives, also where no clearance is given.

Strength of the pins and efficiency of the output take the largest force over the turn: that of
exact positions, narrowed from the best of a scan.
"""

from typing import Any

import pytest
from mpmath import mpf

from tests.inputs.outcome import service
from tests.oracles.answers.load_sharing import exact_position, real_of

STEEL = {"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3}
BODY: dict[str, Any] = {
    "mechanism": {"pins": 4, "satellites": 1, "ratio": 12.5},
    "load": {
        "output_torque_Nm": 180.0,
        "pin_circle_radius_mm": 42.0,
        "torque_direction": "driving",
        "input_speed_rpm": 900.0,
    },
    "contact": {
        "contact_length_mm": 11.0,
        "pin_radius_mm": 5.5,
        "eccentricity_mm": 1.6,
        "pin_material": STEEL,
        "hole_material": STEEL,
    },
    "pin": {"diameter_mm": 11.0, "satellite_positions_mm": [9.5], "support": "cantilever"},
}
USES = {
    "pin-strength": {},
    "output-efficiency": {"friction": {"coefficient": 0.06}},
}
"""Calculations that state the largest force, with what else they need."""

SCAN, ROUNDS = 24, 24
"""Angles of a scan over a quarter of a turn of the wave, and narrowings of three places each."""


def largest(body: dict[str, Any]) -> float:
    """Largest force of a pin over the turn, N."""
    real, _, torque = real_of(body | {"contact_law": {"kind": "hertz"}, "crank_angle_deg": [0.0]})
    turn = 2 * mpf("3.14159265358979323846") / (1 + 1 / real.mechanism.ratio)

    def force(angle: mpf) -> float:
        return float(max(exact_position(real, angle, torque).force))

    places = [turn * i / (4 * SCAN) for i in range(SCAN)]
    middle, width = max(places, key=force), turn / (4 * SCAN)
    found = force(middle)
    for _ in range(ROUNDS):
        width /= 2
        found, middle = max(
            (force(each), each) for each in (middle - width, middle, middle + width)
        )
    return found


@pytest.mark.parametrize("support", ["cantilever", "fixed"])
def test_the_largest_force_is_that_of_solved_positions(support: str) -> None:
    pin = BODY["pin"] | {"support": support, "span_mm": 19.0}
    if support == "cantilever":
        del pin["span_mm"]
    exact = largest(BODY | {"pin": pin})
    for path, more in USES.items():
        status, answer = service().post(path, BODY | more | {"pin": pin})
        assert status == 200, answer
        assert answer["forces"] == "real"
        stated = answer["accuracy"]["relative_error"]
        assert answer["peak_force_N"] == pytest.approx(exact, rel=stated), path
        assert "clearance_unknown" in {each["code"] for each in answer["warnings"]}


def test_forces_of_pins_that_do_not_bend_are_ideal() -> None:
    body = {name: each for name, each in BODY.items() if name != "pin"}
    status, answer = service().post("output-efficiency", body | USES["output-efficiency"])
    assert status == 200, answer
    assert answer["forces"] == "ideal"
    assert answer["peak_force_N"] != pytest.approx(largest(BODY), rel=1e-4)  # all of 9e-6 known
