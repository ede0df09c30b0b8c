"""Nothing happens to a design where its pins stand as far off as its valleys are round: checks of
teeth, contacts and pins use as much of their limits a hundredth below as above.
"""

import math
import random

import pytest

from core.checks.crank_planetary import crank_checks
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing
from core.design.sections import DesignPin, Friction
from core.hertz import ContactLimit, ElasticMaterial
from core.precision import SAME
from core.ring.profile import CycloidDisc, Modification
from core.ring.sharing import mesh_position
from tests.inputs.checks import design_of
from tests.oracles.seeds import seeds

HARD = ElasticMaterial(210e9, 0.3, ContactLimit("given", 1500e6), yield_strength=900e6)


def drawn(seed: int, share: float) -> Design:
    """A drive of both meshes whose pins stand off the valleys by so much of their radius."""
    r = random.Random(seed)
    lobes, shortening, radius = r.randint(9, 30), r.uniform(0.7, 0.95), r.uniform(0.03, 0.06)
    eccentricity = shortening * radius / (lobes + 1)
    disc = CycloidDisc(lobes, eccentricity, radius, 1e-6)
    room = radius * math.sin(math.pi / (lobes + 1))
    pin = min(0.5 * disc.min_path_radius, 0.8 * room)
    holes = min(3 * eccentricity, 0.1 * radius)  # six of them are 0.55 of the radius apart
    gap, satellites = share * disc.valley_radius, r.randint(1, 2)
    change = r.choice([Modification(gap), Modification(pin_circle=-gap)])
    return design_of(
        pins=6,
        satellites=satellites,
        ratio=float(lobes),
        output_torque=10 ** r.uniform(0, 2.5),
        pin_circle_radius=0.55 * radius,
        contact_length=0.01,
        pin_radius=holes,
        hole_radius=holes + eccentricity + 1e-5,
        eccentricity=eccentricity,
        pin_material=HARD,
        hole_material=HARD,
        friction=Friction(coefficient=0.1),
        pin=DesignPin(
            support="fixed",
            diameter=2 * holes,
            satellite_positions=tuple(0.01 + 0.012 * j for j in range(satellites)),
            span=0.05,
            material=HARD,
        ),
        gear=CycloidRing(
            ring_pin_circle_radius=radius,
            ring_pin_radius=pin,
            modification=change,
            pin_material=HARD,
        ),
    )


def test_a_step_that_is_less_than_rounding_is_taken() -> None:
    """If a pin just takes up, the force of another is only as exact as the torque balance."""
    design = drawn(4, 0.99)
    mesh, angle = Results(design).ring.mesh, 0.19269685498545294
    found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=design.pin_torque)
    assert sum(found.disc_torque) == pytest.approx(design.pin_torque, rel=SAME)


@pytest.mark.slow
@pytest.mark.parametrize("seed", seeds(8, 20))
def test_checks_use_as_much_on_either_side(seed: int) -> None:
    below, above = (
        {
            check.code: check.utilisation
            for check in crank_checks(Results(drawn(seed, share))).checks
            if check.code.startswith(("contact_", "ring_", "pin_"))
        }
        for share in (0.99, 1.01)
    )
    used = {code: each for code, each in above.items() if each is not None}
    assert {"contact_pressure_hole", "ring_pressure_disc", "pin_static"} <= {*used}
    assert used == pytest.approx({code: below[code] for code in used}, rel=0.02)
