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
from tests.oracles.answers.crank_planetary import EXPONENTS, angles, mechanism
from tests.oracles.answers.losses import by_a_hair
from tests.oracles.crank_planetary import peak
from tests.oracles.pin import bend
from tests.oracles.pin_turn import Turn, largest, long, worst_cycle

CRITERIA = ("goodman", "gerber", "soderberg", "fkm_haigh")
SURFACES = {"ground": (1.38, -0.067), "machined": (3.04, -0.217), "forged": (54.9, -0.758)}
RELIABILITIES = {50: 1.0, 90: 0.897, 99: 0.814, 99.9: 0.753}


def request(r: Draw) -> Body:
    """A design with at most 16 pairs, held in three ways."""
    own = mechanism(r)
    while by_a_hair(own) or own["pins"] * own["satellites"] > 16:
        own = mechanism(r)
    exponents = (*EXPONENTS, 0.5, 6.0, 40.0) if not r.extreme else (1e-3, 3.3, 300.0, 1e4, 1e6)
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
    fatigue: Body = {"criterion": r.choice(CRITERIA)}
    if r.chance(0.5):
        fatigue["endurance_limit_MPa"] = r.decimal(50, 400)
    else:
        fatigue |= {
            "surface": r.choice(list(SURFACES)),
            "reliability_percent": r.choice(list(RELIABILITIES)),
        }
        if r.chance(0.5):
            fatigue["fatigue_notch_factor"] = r.decimal(1, 3)
        else:
            fatigue["notch"] = {"theoretical_factor": r.decimal(1, 4), "radius_mm": r.size(0.1, 5)}
    return {
        "mechanism": own,
        "load": load,
        "pin": pin,
        "fatigue": fatigue,
        "include": ["deflection"],
    }


def numbers(body: Body, answer: Any) -> Numbers:
    """The beam by finite elements, the turn by climbing, the rest by definition."""
    own, load, pin = (body[name] for name in ("mechanism", "load", "pin"))
    cranks = [mp.radians(angle) for angle in angles(own)]
    exponent = typed(load["force_exponent"])
    reference = 1000 * typed(load["output_torque_Nm"]) / typed(load["pin_circle_radius_mm"])
    turn = Turn(own["pins"], cranks, exponent)
    beam = _Beam(pin)
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
        "/static_safety_factor": typed(pin["material"]["yield_strength_MPa"]) / most,
    }
    satellite = answer["deflection"]["satellite"] - 1

    def sunk(arms: list[mpf]) -> mpf:
        size = max(map(abs, arms)) or mpf(1)
        own = np.array([[long(arm / size) for arm in arms]])
        zero = np.zeros(1, np.longdouble)
        found = largest(turn, lambda forces, _: np.abs(own @ forces), zero)
        return reference * size * mpf(str(found))

    exact["/deflection/deflection_mm"] = max(sunk(arms) for arms in beam.deflections)
    exact["/deflection/slope_mrad"] = 1000 * sunk(beam.slopes[satellite])
    strength = _Strength(body)
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
    exact |= {f"/fatigue/factors/{name}": each for name, each in strength.factors.items()}
    found: Numbers = {}
    for pointer, value in exact.items():
        sent = answer
        for name in pointer[1:].split("/"):
            sent = sent[name]
        found[pointer] = Number(sent, value)
    if "span_mm" in pin:
        # between supports a slope may be next to nothing
        z = typed(pin["satellite_positions_mm"][satellite])
        near = min(z, typed(pin["span_mm"]) - z)
        slope = "/deflection/slope_mrad"
        size = max(exact[slope], 1000 * exact["/deflection/deflection_mm"] / near)
        found[slope] = Number(found[slope].sent, exact[slope], size)
    return found


class _Beam:
    """What the satellites' unit forces do to the pin, by finite elements and statics."""

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
        sections = [mpf(0)]
        if span is not None:
            ends = {mpf(0), span}
            for z in self.places:
                ends |= {z - self.half, z + self.half}
            stops = sorted(x for x in ends if 0 <= x <= span)
            for start, stop in pairwise(stops):
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


class _Strength:
    """Endurance limit and criterion, as printed in the sources."""

    def __init__(self, body: Body) -> None:
        given, material = body["fatigue"], body["pin"]["material"]
        self.tensile = typed(material["tensile_strength_MPa"])
        self.yields = typed(material["yield_strength_MPa"])
        self.criterion = given["criterion"]
        self.factors: dict[str, mpf] = {}
        if "endurance_limit_MPa" in given:
            self.limit = typed(given["endurance_limit_MPa"])
            return
        scale, power = SURFACES[given["surface"]]
        d = typed(body["pin"]["diameter_mm"])
        size = typed(1.24) * d ** typed(-0.107) if d <= 51 else typed(1.51) * d ** typed(-0.157)
        notch = given.get("fatigue_notch_factor")
        if notch is None:
            s = min(max(self.tensile, mpf(340)), mpf(1700))
            terms = (1.24, -2.25e-3, 1.60e-6, -4.11e-10)
            root = mp.fsum(typed(term) * s**i for i, term in enumerate(terms))
            theoretical, radius = (
                typed(given["notch"][name]) for name in ("theoretical_factor", "radius_mm")
            )
            notch = 1 + (theoretical - 1) / (1 + root / mp.sqrt(radius))
        else:
            notch = typed(notch)
        self.factors = {
            "surface": min(typed(scale) * self.tensile ** typed(power), mpf(1)),
            "size": min(size, mpf(1)),
            "reliability": typed(RELIABILITIES[given["reliability_percent"]]),
            "notch": notch,
        }
        product = self.factors["surface"] * self.factors["size"] * self.factors["reliability"]
        self.limit = product / notch * min(self.tensile / 2, mpf(700))

    def use(self, top: Any, bottom: Any) -> Any:
        """1/n."""
        limit, tensile, yields = (long(each) for each in (self.limit, self.tensile, self.yields))
        a, m = (top - bottom) / 2, (top + bottom) / 2
        pull = np.maximum(m, 0)
        if self.criterion in ("goodman", "soderberg"):
            return a / limit + pull / (tensile if self.criterion == "goodman" else yields)
        if self.criterion == "gerber":
            q = a / limit
            # n*q + (n*m/Rm)^2 = 1
            return (q + (q * q + 4 * (pull / tensile) ** 2) ** 0.5) / 2
        slope = long(max(typed(0.35e-3) * self.tensile - typed(0.1), 0))
        flatter = (1 + slope) / (1 + slope / 3)  # from R = 0 on
        return (
            np.select(
                [m <= -a, m <= a, m <= 3 * a],
                [a * (1 - slope), a + slope * m, (a + slope / 3 * m) * flatter],
                a * (1 + slope) * flatter,
            )
            / limit
        )


PIN_STRENGTH = Calculation(
    "Strength of the pins",
    "pin-strength",
    request,
    numbers,
    unbounded={
        "/peak_moment_position_mm": "where it is; known to the root of its error",
        "/deflection/satellite": GIVEN,
        "/fatigue/position_mm": "where it is; known to the root of its error",
        "/fatigue/direction_deg": "1e-4: the utilisation is flat there",
        "/fatigue/max_stress_MPa": "1e-4: the utilisation is flat there",
        "/fatigue/min_stress_MPa": "1e-4 of the largest: the utilisation is flat there",
        "/fatigue/amplitude_MPa": "1e-4: the utilisation is flat there",
        "/fatigue/mean_MPa": "1e-4 of the largest: the utilisation is flat there",
        "/fatigue/cycles": "the error of the safety times the slope of its line",
    },
    one_in=50,
)
