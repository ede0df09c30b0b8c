"""Oracle test: what gives besides the contacts, in exact geometry, by stored energy with plain
vectors: pins that several discs bend at once, bearings on cranks, meshes with the ring.
"""

import math

import numpy as np
import pytest

from core.output.elasticity import (
    LinearLaw,
    PinSupport,
)
from core.output.mechanism import Mechanism
from core.output.pin_beam import Support
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT
from tests.inputs.load_sharing_cases import CASES, mechanism
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.load_sharing import law_of
from tests.oracles.pin_flexibility import pin_gives
from tests.oracles.seeds import seeds

SUPPORTS: tuple[Support, ...] = "cantilever", "supported", "fixed"
TORQUE, ANGLE = 150.0, 0.7


def drawn(seed: int) -> RealMechanism:
    r = np.random.default_rng(seed)
    pins, discs = int(r.integers(4, 9)), int(r.integers(2, 4))
    deviations = Deviations(
        pin_tangential=tuple(r.normal(0, 4e-6, pins)),
        hole_radial=tuple(tuple(r.normal(0, 4e-6, pins)) for _ in range(discs)),
        disc_phase=tuple(r.normal(0, 1e-4, discs)),
    )
    places = tuple(0.012 + 0.014 * j for j in range(discs))
    return RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=pins, satellites=discs, ratio=20.0),
        pin_circle_radius=0.04,
        pin_radius=0.005,
        eccentricity=1.5e-3,
        contact_length=0.01,
        clearance=float(r.uniform(0, 2e-5)),
        law=LinearLaw(float(10 ** r.uniform(8, 9))),
        pin_material=STEEL,
        hole_material=STEEL,
        pin=PinSupport(SUPPORTS[seed % 3], 0.01, places, STEEL, 0.06),
        deviations=deviations,
    )


def energy(real: RealMechanism, lag: float, bends: np.ndarray) -> float:
    """Stored less the torque's work; bends in the plane, along the radius of each pin and as the
    output turns, shape (N, K, 2).
    """
    own, made = real.mechanism, real.deviations
    stiff = np.linalg.inv(np.array(pin_gives(real.pin)).astype(float))
    total = sum(b.T @ stiff @ b for pin in bends for b in pin.T) / 2 - TORQUE * lag
    psi = own.wave_angle(ANGLE)
    for n in range(own.pins):
        out = 1j * np.exp(2j * math.pi * n / own.pins)
        pin = out * (real.pin_circle_radius + 1j * made.pin_tangential[n]) * np.exp(-1j * lag)
        for j, phase in enumerate(own.crank_angles):
            crank = 1j * np.exp(-1j * (psi + phase))
            turned = out * (real.pin_circle_radius + made.hole_radial[j][n])
            hole = real.eccentricity * crank + turned * np.exp(1j * made.disc_phase[j])
            bent = out * complex(*bends[n, j])
            room = real.eccentricity + real.clearance
            approach = abs(pin + bent - hole) - room
            total += real.law.stiffness / 2 * max(approach, 0.0) ** 2
    return float(total)


@pytest.mark.parametrize("seed", seeds(9))
def test_pins_that_several_discs_bend_rest_where_energy_is_least(seed: int) -> None:
    real = drawn(seed)
    room = real.solved([real.wave(ANGLE)], TORQUE)
    bends = room.work.b.reshape(real.mechanism.pins, real.mechanism.satellites, 2)
    rest = np.concatenate([room.lags[0, :1], bends.ravel()])

    def at(x: np.ndarray) -> float:
        return energy(real, float(x[0]), x[1:].reshape(bends.shape))

    length = np.array([real.pin_circle_radius, *[1.0] * bends.size])
    top = room.forces.max()
    for way in np.diag(1e-9 / length):
        assert abs(at(rest + way) - at(rest - way)) / 2e-9 < 1e-6 * top
    assert at(rest) < at(rest * (1 + 1e-3))
    together = [(each > 0).sum() for each in room.forces.reshape(real.mechanism.satellites, -1).T]
    assert max(together) > 0


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
