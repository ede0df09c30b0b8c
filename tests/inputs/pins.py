"""Random pins whose summits over the turn are hard to tell apart: cranks that are nearly even, many
satellites, two supports; every third one of a mechanism that is pressed or has clearance.
"""

import math
import random
from functools import cache
from typing import Any

from core.output.elasticity import (
    RIGID_PINS,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    PinSupport,
    PowerLaw,
)
from core.output.mechanism import Mechanism
from core.output.pin_fatigue import FatigueStrength
from core.output.real_mechanism import RealMechanism
from core.output.real_turn import sampled
from core.output.room import Deviations
from core.output.turn import Turn
from tests.inputs.real_mechanisms import PIN_STEEL

SOLVED_ONE_IN = 3
EXPONENTS = (0.0, 0.3, 0.5, 1.0, 1.0, 10 / 9, 10 / 9, 1.5, 2.0, 2.5, 3.0, 6.0, 20.0, 40.0)
LAWS = (LinearLaw(5e7), LinearLaw(5e8), PowerLaw(1.5, 1000.0, 1e-5), PalmgrenLaw(), HertzLaw())
CLEARANCES = (-2e-5, -1e-5, -3e-6, 0.0, 1e-5, 3e-5)
CRITERIA = ("goodman", "gerber", "soderberg", "fkm_haigh")


def solved(seed: int) -> bool:
    """True if the forces of a design are solved."""
    return seed % SOLVED_ONE_IN == SOLVED_ONE_IN - 1


def pin_design(seed: int) -> dict[str, Any]:
    """Arguments of `core.output.pin_strength.pin_strength`."""
    r = random.Random(seed)
    if solved(seed):
        pins, satellites = r.randint(3, 8), r.randint(1, 4)
    else:
        satellites = r.choice((1, 2, 2, 3, 3, 4, 4, 5, 6))
        pins = r.randint(3, 12) if r.random() < 0.93 else r.randint(13, 60)
    off, kind = 10 ** r.uniform(-7, -2), r.random()
    angles = [2 * math.pi * j / satellites for j in range(satellites)]
    if 0.2 <= kind < 0.7:
        angles = [angle + (off * r.uniform(-1, 1) if angle else 0.0) for angle in angles]
    elif kind >= 0.7:
        angles = [0.0, *(r.uniform(0, 2 * math.pi) for _ in angles[1:])]
    length, end, places = r.uniform(0.005, 0.03), 0.0, []
    for _ in angles:
        end += length * (1.01 if places else 0.51) * r.uniform(1.0, 1.8)
        places.append(end)
    support = r.choice(("cantilever", "supported", "fixed"))
    span = None if support == "cantilever" else end + length * r.uniform(0.55, 2)
    exponent, diameter = r.choice(EXPONENTS), r.uniform(0.006, 0.03)
    strength = FatigueStrength(
        r.uniform(200e6, 500e6), r.uniform(700e6, 2000e6), 600e6, r.choice(CRITERIA)
    )
    mechanism = Mechanism(pins=pins, crank_angles=tuple(angles), ratio=20.0)
    design: dict[str, Any] = {
        "mechanism": mechanism,
        "force_exponent": exponent,
        "output_torque": 500.0,
        "pin_circle_radius": 0.05,
        "diameter": diameter,
        "contact_length": length,
        "satellite_positions": tuple(places),
        "material": PIN_STEEL,
        "support": support,
        "span": span,
        "fatigue": strength,
    }
    if not solved(seed):
        return design

    def row(count: int) -> tuple[float, ...]:
        return tuple(r.uniform(-1e-5, 1e-5) for _ in range(count))

    alike = r.random() < 0.3
    real = RealMechanism(
        mechanism=mechanism,
        pin_circle_radius=0.05,
        pin_radius=min(diameter / 2, 0.008),
        eccentricity=0.002,
        contact_length=length,
        law=r.choice(LAWS),
        clearance=r.choice(CLEARANCES),
        pin_material=PIN_STEEL,
        hole_material=PIN_STEEL,
        pin=PinSupport(support, diameter, tuple(places), PIN_STEEL, span)
        if r.random() < 0.4
        else RIGID_PINS,
        deviations=Deviations()
        if alike
        else Deviations(
            pin_radial=row(pins),
            hole_tangential=tuple(row(pins) for _ in angles),
            disc_phase=tuple(each / 0.05 for each in row(satellites)),
        ),
        exact=r.random() < 0.5,
    )
    torque = 10 ** r.uniform(1, 3)
    made = cache(lambda torque: sampled(Turn(real, torque)))
    return design | {"output_torque": torque, "made": made}
