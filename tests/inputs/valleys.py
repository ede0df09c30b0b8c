"""Cycloid discs of large shortening whose pins stand further off than their valleys are round."""

import math
import random
from typing import Literal

from core.output.elasticity import LinearLaw
from core.ring.profile import CycloidDisc, Modification
from core.ring.sharing import CycloidMesh, RingDeviations
from tests.inputs.real_mechanisms import STEEL

Kind = Literal["equidistant", "pin_circle", "both", "errors", "pressed", "wide_pin"]


def narrow(seed: int, kind: Kind) -> tuple[CycloidMesh, float, float]:
    """A mesh of one disc, a crank angle and a torque. Of `pressed` and `wide_pin` pins are wider
    than the tool by more than the valleys are round, so that they press both flanks of one.
    """
    r = random.Random(seed)
    lobes, shortening, radius = r.randint(7, 36), r.uniform(0.7, 0.95), r.uniform(0.015, 0.06)
    plain = CycloidDisc(lobes, shortening * radius / (lobes + 1), radius, 1e-6)
    valley, root = plain.valley_radius, math.sqrt(1 - shortening**2)
    room = radius * math.sin(math.pi / (lobes + 1))
    pin = min(0.6 * plain.min_path_radius, 0.8 * room) * r.uniform(0.5, 1)
    gap = valley * r.uniform(1.2, 10)
    change, made = Modification(gap), RingDeviations()
    places = 2 * math.pi / (lobes + 1)
    angle = r.uniform(0, 2 * math.pi)

    def row(most: float) -> tuple[float, ...]:
        return tuple(r.uniform(-most, most) for _ in range(lobes + 1))

    if kind == "pin_circle":
        change = Modification(pin_circle=-gap)
    elif kind == "both":
        change = Modification(-gap, -gap / root * r.uniform(1, 1.3))
    elif kind == "errors":
        made = RingDeviations(row(gap / 2), row(gap / 2), row(gap / 2))
    elif kind == "pressed":
        change = Modification(-gap, -gap * r.uniform(0.9, 1.05))
    elif kind == "wide_pin":
        change, angle = Modification(), r.uniform(-0.1, 0.1) * places
        others = (0.0,) * lobes
        made = RingDeviations((0.9 * gap, *others), (), (gap, *others))
    mesh = CycloidMesh(
        disc=CycloidDisc(lobes, plain.eccentricity, radius, pin, change),
        crank_angles=(0.0,),
        contact_length=0.01,
        law=LinearLaw(10 ** r.uniform(6, 8)),
        pin_material=STEEL,
        disc_material=STEEL,
        deviations=made,
    )
    return mesh, angle, r.uniform(5, 50) * radius
