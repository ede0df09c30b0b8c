"""Oracle test: pins that several discs bend at once, by Hertz's law, balanced by plain vectors."""

import math

import numpy as np
import pytest

from core.precision import EXACT
from tests.inputs.load_sharing_cases import CASES, mechanism
from tests.oracles.load_sharing import law_of
from tests.oracles.pin_flexibility import pin_gives


def test_case_s13_of_three_discs_with_all_deviations_is_balanced() -> None:
    """By Hertz's law at 40 digits, forces on each pin by its stiffness, and the torque."""
    (case,) = (each for each in CASES if each["name"].startswith("S13 "))
    real, torque = mechanism(case["body"])
    own, made = real.mechanism, real.deviations
    stiff = np.linalg.inv(np.array(pin_gives(real.pin)).astype(float))
    angle = math.radians(case["expect"]["positions"][0]["crank_angle_deg"])
    room = real.solved([real.wave(angle)], torque)
    lag, bends = room.lags[0, 0], room.work.b.reshape(own.pins, own.satellites, 2)
    forces, moment, top = room.forces.reshape(own.satellites, -1), 0.0, room.forces.max()
    for n in range(own.pins):
        out = 1j * np.exp(2j * math.pi * n / own.pins)
        place = real.pin_circle_radius + made.pin_radial[n] + 1j * made.pin_tangential[n]
        pin, on_pin = out * place * np.exp(-1j * lag), []
        for j, phase in enumerate(own.crank_angles):
            crank = own.wave_angle(angle) + phase + made.crank_phase[j]
            place = (
                real.pin_circle_radius + made.hole_radial[j][n] + 1j * made.hole_tangential[j][n]
            )
            turned = made.disc_phase[j] + made.crank_phase[j] / own.ratio
            hole = out * place * np.exp(1j * turned)
            hole += (real.eccentricity + made.eccentricity[j]) * 1j * np.exp(-1j * crank)
            off = pin + out * complex(*bends[n, j]) - hole
            larger = made.hole_radius[j][n] - made.pin_radius[n]
            apart = abs(off) - (real.eccentricity + real.clearance + larger)
            radius = real.pin_radius + made.pin_radius[n]
            law = law_of(real, radius, real.eccentricity + real.clearance + larger)
            assert float(law(apart)) == pytest.approx(forces[j, n], rel=0, abs=EXACT * top)
            pushed = -forces[j, n] * off / abs(off)
            moment += (np.conj(pin) * pushed).imag
            on_pin.append(pushed / out)
        parts = stiff @ (bends[n, :, 0] + 1j * bends[n, :, 1])
        assert parts == pytest.approx(np.array(on_pin), rel=0, abs=EXACT * top)
    assert abs(moment) == pytest.approx(torque, rel=EXACT)
