"""Strength of the pins: mm, N, MPa."""

from itertools import pairwise
from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracles.answers.calculation import (
    GIVEN,
    Body,
    Calculation,
    Draw,
    Number,
    Numbers,
    typed,
)
from tests.oracles.answers.crank_planetary import EXPONENTS, angles, mechanism, ratio
from tests.oracles.answers.fatigue import CYCLES, Strength, basis
from tests.oracles.answers.losses import USUAL_LIFE, by_a_hair
from tests.oracles.crank_planetary import peak
from tests.oracles.pin import bend
from tests.oracles.pin_turn import Turn, largest, long, worst_cycle


def request(r: Draw) -> Body:
    """A design with at most 16 pairs, held in three ways, of a life that has an end in half."""
    own = mechanism(r)
    while by_a_hair(own) or own["pins"] * own["satellites"] > 16:
        own = mechanism(r)
    exponents = (*EXPONENTS, 0.5, 6.0, 40.0) if not r.extreme else (3.3, 20.0, 300.0, 500.0)
    load: Body = {
        "pin_circle_radius_mm": r.size(10, 200),
        "output_torque_Nm": r.size(1, 1e4),
        "force_exponent": r.choice(exponents),
    }
    length = r.size(5, 50, 2)
    place, places = 0.0, []
    for _ in range(own["satellites"]):
        place = r.rounded(place + length * (0.51 if not places else 1.01) * r.uniform(1.1, 1.6))
        places.append(place)
    pin: Body = {
        "diameter_mm": r.size(5, 40, 2),
        "contact_length_mm": length,
        "satellite_positions_mm": places,
        "support": r.choice(
            ("cantilever", "supported", "fixed")[: 3 if own["satellites"] < 3 else 1]
        ),
        "rotates": r.chance(0.1),
        "material": {
            "youngs_modulus_GPa": r.decimal(195, 215),
            "poissons_ratio": r.decimal(0.2, 0.35),
            "tensile_strength_MPa": r.decimal(700, 1400),
            "yield_strength_MPa": r.decimal(300, 690),
        },
    }
    if pin["support"] != "cantilever":
        pin["span_mm"] = r.rounded(place + length * r.uniform(0.6, 2))
    fatigue = basis(r)
    if r.chance(0.3):
        load["application_factor"] = r.decimal(0.5, 3)
    if r.chance(0.3):
        working = load["output_torque_Nm"] * load.get("application_factor", 1.0)
        load["peak_torque_Nm"] = r.rounded(working * r.uniform(1.1, 4))
    body: Body = {
        "mechanism": own,
        "load": load,
        "pin": pin,
        "fatigue": fatigue,
        "include": ["deflection"],
    }
    if r.chance(0.5):
        load["input_speed_rpm"] = r.size(10, 3000)
        if r.chance(0.8):
            body["requirements"] = {"life_h": r.size(0.1, 1e3)}
        if r.chance(0.2):
            fatigue["life_h"] = r.size(0.1, 1e3)
    return body


def loads(body: Body) -> mpf | None:
    """Loads on a pin that stands still over its life, one a turn of the crank against the pins:
    its own life, the required one, or the usual one; None without an end.
    """
    if "input_speed_rpm" not in body["load"] or body["pin"]["rotates"]:
        return None
    required = body.get("requirements", {}).get("life_h", USUAL_LIFE)
    life = typed(body["fatigue"].get("life_h", required))
    return 60 * typed(body["load"]["input_speed_rpm"]) * (1 + 1 / ratio(body["mechanism"])) * life


def numbers(body: Body, answer: Any) -> Numbers:
    """The beam by finite elements, the turn by climbing, the rest by definition."""
    own, load, pin = (body[name] for name in ("mechanism", "load", "pin"))
    cranks = [mp.radians(angle) for angle in angles(own)]
    exponent = typed(load["force_exponent"])
    torque = typed(load["output_torque_Nm"]) * typed(load.get("application_factor", 1.0))
    reference = 1000 * torque / typed(load["pin_circle_radius_mm"])
    static = typed(load["peak_torque_Nm"]) / torque if "peak_torque_Nm" in load else 1
    turn = Turn(own["pins"], cranks, exponent)
    beam = Beam(pin)
    d = typed(pin["diameter_mm"])
    area, modulus = mp.pi * d**2 / 4, mp.pi * d**3 / 32

    def measured(value: Any) -> mpf:
        return mpf(str(largest(turn, value, beam.sections)))

    def bent(forces: Any, x: Any) -> Any:
        return beam.moments(x).T @ forces / long(modulus)

    def sheared(forces: Any, x: Any) -> Any:
        return beam.shears(x).T @ forces / long(area)

    def both(forces: Any, x: Any) -> Any:
        """On the edge of the section, at the worst of all places."""
        s, t = bent(forces, x), long(mp.sqrt(3) * 4 / 3) * sheared(forces, x)
        # s^2*cos^2(phi - a) + t^2*sin^2(phi - b) is largest by its mean and its swing
        return np.sqrt((np.abs(s) ** 2 + np.abs(t) ** 2 + np.abs(s * s - t * t)) / 2)

    moment = reference * modulus * measured(lambda *at: np.abs(bent(*at)))
    shear = reference * area * measured(lambda *at: np.abs(sheared(*at)))
    most = reference * measured(both)
    exact = {
        "/peak_force_N": reference * peak(own["pins"], cranks, exponent, screened=True).ratio,
        "/peak_moment_Nm": moment / 1000,
        "/peak_bending_stress_MPa": moment / modulus,
        "/peak_shear_force_N": shear,
        "/peak_shear_stress_MPa": shear * 4 / 3 / area,
        "/peak_equivalent_stress_MPa": most,
        "/static_safety_factor": typed(pin["material"]["yield_strength_MPa"]) / (static * most),
    }

    def sunk(arms: list[mpf]) -> mpf:
        size = max(map(abs, arms)) or mpf(1)
        own = np.array([[long(arm / size) for arm in arms]])
        zero = np.zeros(1, np.longdouble)
        found = largest(turn, lambda forces, _: np.abs(own @ forces), zero)
        return reference * size * mpf(str(found))

    exact["/deflection/deflection_mm"] = max(sunk(arms) for arms in beam.deflections)
    exact["/deflection/slope_mrad"] = 1000 * max(sunk(arms) for arms in beam.slopes)
    material = pin["material"]
    tensile, yields = (typed(material[f"{each}_strength_MPa"]) for each in ("tensile", "yield"))
    strength = Strength(body["fatigue"], d, tensile, yields, loads(body))
    unit = reference / modulus
    if pin["rotates"]:
        use = mpf(str(strength.use(long(moment / modulus), -long(moment / modulus))))
    else:
        scale = long(unit)
        use = worst_cycle(
            turn,
            beam.moments,
            beam.sections,
            lambda top, bottom: strength.use(scale * top, scale * bottom),
        )
        use = mpf(str(use))
    exact["/fatigue/safety_factor"] = 1 / use
    exact["/fatigue/endurance_limit_MPa"] = strength.limit
    if strength.finite is not None:
        exact["/fatigue/finite_strength_MPa"] = strength.finite
    exact |= {f"/fatigue/factors/{name}": each for name, each in strength.factors.items()}
    found: Numbers = {}
    for pointer, value in exact.items():
        sent = answer
        for name in pointer[1:].split("/"):
            sent = sent[name]
        found[pointer] = Number(sent, value)
    if "span_mm" in pin:
        # between supports a slope may be next to nothing
        satellite = answer["deflection"]["slope_satellite"]
        z = typed(pin["satellite_positions_mm"][satellite - 1])
        near = min(z, typed(pin["span_mm"]) - z)
        slope = "/deflection/slope_mrad"
        size = max(exact[slope], 1000 * exact["/deflection/deflection_mm"] / near)
        found[slope] = Number(found[slope].sent, exact[slope], size)
    return found


class Beam:
    """Effects of the satellites' unit forces on the pin, by finite elements and statics."""

    def __init__(self, pin: Body) -> None:
        self.places = [typed(z) for z in pin["satellite_positions_mm"]]
        self.half = typed(pin["contact_length_mm"]) / 2
        span = typed(pin["span_mm"]) if "span_mm" in pin else None
        material = pin["material"]
        bents = [
            bend(
                support=pin["support"],
                diameter=typed(pin["diameter_mm"]),
                contact_length=2 * self.half,
                youngs_modulus=1000 * typed(material["youngs_modulus_GPa"]),
                poissons_ratio=typed(material["poissons_ratio"]),
                span=span,
                loads=[(other, int(other == z)) for other in self.places],  # to the pin's end
            )
            for z in self.places
        ]
        self.start = [(bent.shear[0], bent.moment[0]) for bent in bents]
        self.deflections, self.slopes = (
            [[getattr(bent, name)[bent.at(z)] for bent in bents] for z in self.places]
            for name in ("deflection", "slope")
        )
        ends = {mpf(0), *([] if span is None else [span])}
        for z in self.places:
            ends |= {z - self.half, z + self.half}
        sections = [mpf(0)]
        for start, stop in pairwise(sorted(x for x in ends if 0 <= x <= (span or max(ends)))):
            sections += [start + (stop - start) * i / 6 for i in range(1, 7)]
        self.sections = np.array([long(x) for x in sections])

    def moments(self, x: Any) -> Any:
        """Shape (K, m)."""
        found = []
        for z, (shear, moment) in zip(self.places, self.start, strict=True):
            before, half = long(z - self.half), long(self.half)
            into = np.clip(x - before, 0, 2 * half)
            found.append(
                long(moment) - long(shear) * x + into / (2 * half) * (x - before - into / 2)
            )
        return np.array(found)

    def shears(self, x: Any) -> Any:
        """Shape (K, m)."""
        return np.array(
            [
                long(shear) - np.clip((x - long(z - self.half)) / long(2 * self.half), 0, 1)
                for z, (shear, _) in zip(self.places, self.start, strict=True)
            ]
        )


PIN_STRENGTH = Calculation(
    "Strength of the pins",
    "pin-strength",
    request,
    numbers,
    unbounded={
        "/peak_moment_position_mm": "where it is; known to the root of its error",
        "/deflection/satellite": GIVEN,
        "/deflection/slope_satellite": GIVEN,
        "/fatigue/position_mm": "where it is; known to the root of its error",
        "/fatigue/direction_deg": "1e-4: the utilisation is flat there",
        "/fatigue/max_stress_MPa": "1e-4: the utilisation is flat there",
        "/fatigue/min_stress_MPa": "1e-4 of the largest: the utilisation is flat there",
        "/fatigue/amplitude_MPa": "1e-4: the utilisation is flat there",
        "/fatigue/mean_MPa": "1e-4 of the largest: the utilisation is flat there",
        "/fatigue/cycles": CYCLES,
        "/fatigue/life_h": CYCLES,
    },
    one_in=20,
)
