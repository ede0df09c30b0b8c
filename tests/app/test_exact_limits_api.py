"""Sizes on the very limit of what a ring or its pins can be, and a rounding beside it: what cannot
be is refused, and nothing fails.
"""

import math
import random

import pytest

from tests.oracles.seeds import seeds

pytestmark = pytest.mark.anyio


def ring(r, limit, ulps):
    """A request of `/ring-mesh`."""
    lobes, radius = r.choice((4, 9, 20)), round(r.uniform(15, 80), 2)
    pins, e = lobes + 1, round(r.uniform(0.3, 0.9) * radius / (lobes + 1), 3)
    pin, gap = 0.02 * radius, 0.01
    if limit == "K1 = 1":
        radius, pin = e * pins * (1 + ulps * 2**-52), 1e-3
    elif limit == "pins touch":
        e, pin = 0.1 * radius / pins, radius * math.sin(math.pi / pins) * (1 + ulps * 2**-52)
    elif limit == "straight valley":
        e = radius / pins**2 * (1 + ulps * 2**-52)
    elif limit == "no root":
        pin = (radius - e - gap) * (1 + ulps * 2**-52)
    return "ring-mesh", {
        "mechanism": {"satellites": 1, "satellite_teeth": lobes, "ring_teeth": pins},
        "load": {"output_torque_Nm": 1.0},
        "contact": {"eccentricity_mm": e},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": radius,
            "ring_pin_radius_mm": pin,
            "contact_length_mm": 5.0,
            "modification": {"equidistant_mm": gap},
        },
    }


def output(r, limit, ulps):
    """A request of `/load-sharing`."""
    circle, pins = round(r.uniform(15, 60), 2), r.choice((3, 6, 8))
    e, near = round(r.uniform(0.5, 2), 3), 1 + ulps * 2**-52
    pin = round(0.3 * circle * math.sin(math.pi / pins), 3)
    contact = {"pin_radius_mm": pin, "eccentricity_mm": e, "hole_clearance_mm": 0.01}
    if limit == "hole is pin":
        contact = {"pin_radius_mm": pin, "hole_radius_mm": pin * near, "eccentricity_mm": e}
    elif limit == "no clearance":
        contact = {"pin_radius_mm": pin, "hole_radius_mm": (pin + e) * near, "eccentricity_mm": e}
    elif limit == "pins touch":
        contact["pin_radius_mm"] = circle * math.sin(math.pi / pins) * near
    elif limit == "crank is circle":
        contact["eccentricity_mm"] = circle * near
    return "load-sharing", {
        "mechanism": {"pins": pins, "satellites": 1, "ratio": 20},
        "load": {"output_torque_Nm": 10.0, "pin_circle_radius_mm": circle},
        "contact": contact | {"contact_length_mm": 5.0},
    }


@pytest.mark.parametrize("seed", seeds(4))
@pytest.mark.parametrize(
    ("make", "limit"),
    [(ring, name) for name in ("K1 = 1", "pins touch", "straight valley", "no root")]
    + [(output, name) for name in ("hole is pin", "no clearance", "pins touch", "crank is circle")],
)
async def test_nothing_fails_at_an_exact_limit(api, make, limit, seed):
    for ulps in (-1, 0, 1):
        path, body = make(random.Random(seed), limit, ulps)
        answer = await api.post(path, json=body)
        assert answer.status_code in (200, 422), body
