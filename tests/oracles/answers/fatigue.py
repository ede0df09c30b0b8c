"""Fatigue of steel parts: endurance limit and criteria as printed in the sources, MPa and mm."""

from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracles.answers.calculation import Body, Draw, Number, Numbers, typed
from tests.oracles.pin_turn import long

CRITERIA = ("goodman", "gerber", "soderberg", "fkm_haigh")
SURFACES = {"ground": (1.38, -0.067), "machined": (3.04, -0.217), "forged": (54.9, -0.758)}
KPSI = mpf("4.4482216152605") / mpf("0.0254") ** 2 / 1000
"""1000 pounds per square inch, MPa."""

RELIABILITIES = {50: 1.0, 90: 0.897, 99: 0.814, 99.9: 0.753}


def basis(r: Draw) -> Body:
    """Basis of the fatigue strength of a part: a limit, or factors."""
    fatigue: Body = {"criterion": r.choice(CRITERIA)}
    if r.chance(0.5):
        return fatigue | {"endurance_limit_MPa": r.decimal(50, 400)}
    fatigue |= {
        "surface": r.choice(list(SURFACES)),
        "reliability_percent": r.choice(list(RELIABILITIES)),
    }
    if r.chance(0.5):
        return fatigue | {"fatigue_notch_factor": r.decimal(1, 3)}
    return fatigue | {"notch": {"theoretical_factor": r.decimal(1, 4), "radius_mm": r.size(0.1, 5)}}


class Strength:
    """Endurance limit of a part of a diameter, strength for a number of cycles, and criterion."""

    def __init__(
        self, given: Body, d: mpf, tensile: mpf, yields: mpf, cycles: mpf | None = None
    ) -> None:
        self.tensile, self.yields = tensile, yields
        self.criterion = given["criterion"]
        self.factors: dict[str, mpf] = {}
        self.limit = self._endurance(given, d)
        self.finite = None if cycles is None else self._stood(cycles)

    def _stood(self, cycles: mpf) -> mpf | None:
        """Reversed stress a*N^b that steel stands; None where it is the endurance limit.

        Source: Shigley, 11th edition, eqs. (6-11) to (6-15): f*Rm for 1000 cycles, the limit for a
        million.
        """
        strength = min(max(self.tensile / KPSI, mpf(70)), mpf(200))
        share = typed(1.06) - typed(2.8e-3) * strength + typed(6.9e-6) * strength**2
        short = share * self.tensile
        if cycles >= 1_000_000 or short <= self.limit:
            return None
        scale, power = short**2 / self.limit, -mp.log10(short / self.limit) / 3
        return scale * max(cycles, mpf(1000)) ** power

    def _endurance(self, given: Body, d: mpf) -> mpf:
        """Endurance limit as given, or by its factors."""
        if "endurance_limit_MPa" in given:
            return typed(given["endurance_limit_MPa"])
        scale, power = SURFACES[given["surface"]]
        size = typed(1.24) * d ** typed(-0.107) if d <= 51 else typed(1.51) * d ** typed(-0.157)
        notch = typed(given.get("fatigue_notch_factor", 1.0))
        if "notch" in given:
            s = min(max(self.tensile, mpf(340)), mpf(1700))
            terms = (1.24, -2.25e-3, 1.60e-6, -4.11e-10)
            root = mp.fsum(typed(term) * s**i for i, term in enumerate(terms))
            theoretical, radius = (
                typed(given["notch"][name]) for name in ("theoretical_factor", "radius_mm")
            )
            notch = 1 + (theoretical - 1) / (1 + root / mp.sqrt(radius))
        self.factors = {
            "surface": min(typed(scale) * self.tensile ** typed(power), mpf(1)),
            "size": min(size, mpf(1)),
            "reliability": typed(RELIABILITIES[given["reliability_percent"]]),
            "notch": notch,
        }
        product = self.factors["surface"] * self.factors["size"] * self.factors["reliability"]
        return product / notch * min(self.tensile / 2, mpf(700))

    def use(self, top: Any, bottom: Any) -> Any:
        """1/n."""
        stood = self.limit if self.finite is None else self.finite
        limit, tensile, yields = (long(each) for each in (stood, self.tensile, self.yields))
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

    def cycle(self, sent: Any, top: mpf, bottom: mpf) -> Numbers:
        """Numbers of a cycle of stress between two ends."""
        exact = {
            "/max_stress_MPa": top,
            "/min_stress_MPa": bottom,
            "/amplitude_MPa": (top - bottom) / 2,
            "/mean_MPa": (top + bottom) / 2,
            "/endurance_limit_MPa": self.limit,
            "/safety_factor": 1 / mpf(str(self.use(long(top), long(bottom)))),
        }
        found = {pointer: Number(sent[pointer[1:]], value) for pointer, value in exact.items()}
        for name, value in self.factors.items():
            found[f"/factors/{name}"] = Number(sent["factors"][name], value)
        return found


CYCLES = "the error of the safety times the slope of its line"
"""What is known of the cycles that a part stands."""
