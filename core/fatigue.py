"""Fatigue of a steel part: endurance limit by factors, safety by a criterion, finite life.

Source: Shigley's Mechanical Engineering Design; the edition is named where editions differ. The
rule of the endurance limit holds for steels; other materials need a given limit.
"""

import math
from dataclasses import dataclass
from typing import Literal

from core.arrays import Number, check_not_negative, check_positive, larger, smaller, where
from core.errors import InvalidInput, Notice
from core.fields import answer

Surface = Literal["ground", "machined", "hot_rolled", "forged"]
Edition = Literal["shigley_9", "shigley_11"]
Criterion = Literal["goodman", "gerber", "soderberg", "fkm_haigh"]

SURFACES: dict[str, dict[str, tuple[float, float]]] = {
    "shigley_9": {
        "ground": (1.58, -0.085),
        "machined": (4.51, -0.265),
        "hot_rolled": (57.7, -0.718),
        "forged": (272.0, -0.995),
    },
    "shigley_11": {
        "ground": (1.38, -0.067),
        "machined": (3.04, -0.217),
        "hot_rolled": (38.6, -0.650),
        "forged": (54.9, -0.758),
    },
}
"""Constants a and b of the surface factor ``a*Rm^b``, Rm in MPa, by edition; cold-drawn surfaces
count as machined."""

RELIABILITIES = {50.0: 1.0, 90.0: 0.897, 95.0: 0.868, 99.0: 0.814, 99.9: 0.753, 99.99: 0.702}
"""Factor ke by reliability in percent (Shigley, 9th edition, table 6-5)."""

LOW_CYCLES = 1e3
"""Cycles at which the line of finite life begins."""

ENDURING = 1e6
"""Cycles at which the line of finite life ends, at the endurance limit."""

KPSI = 6.894757293168361e6
"""1000 pounds per square inch, Pa."""

NOTCH_STRENGTHS = 340.0, 1700.0
"""Range of tensile strength of the fit of the notch factor, MPa."""

SIZES = 2.79, 254.0
"""Range of diameters of the size factor, mm."""

LINE_STRENGTHS = 70 * KPSI / 1e6, 200 * KPSI / 1e6
"""Range of tensile strength of the fit of the line of finite life, MPa."""


def beyond_range(*, code: str, value: float, ends: tuple[float, float]) -> tuple[Notice, ...]:
    """Notice of a value outside the range `ends` of a formula; empty inside the range."""
    low, high = ends
    if low <= value <= high:
        return ()
    return (Notice(code, {"value": value, "low": low, "high": high}),)


@dataclass(frozen=True, slots=True)
class EnduranceFactors:
    """Factors between the endurance limit of a part and that of a polished specimen."""

    surface: Number = answer("", "k_a")
    """Factor of the surface."""
    size: Number = answer("", "k_b")
    """Factor of the size."""
    reliability: Number = answer("", "k_e")
    """Factor of the reliability."""
    notch: Number = answer("", "K_f")
    """Fatigue notch factor."""

    @property
    def product(self) -> Number:
        """Product of the factors, ``ka*kb*ke/Kf``."""
        return self.surface * self.size * self.reliability / self.notch


def surface_factor(
    *, tensile_strength: Number, surface: Surface, edition: Edition = "shigley_11"
) -> Number:
    """Surface factor ka of the endurance limit: ``a*Rm^b``, at most 1, tensile strength Rm in Pa.

    Factors of the 11th edition are 4 to 10 % lower for machined surfaces than those of the 9th, and
    higher for forged and mostly for hot-rolled ones.
    Source: Shigley, eq. (6-19) of the 9th, (6-18) of the 11th edition.

    >>> round(surface_factor(tensile_strength=690e6, surface="machined", edition="shigley_9"), 6)
    0.797777
    """
    check_positive(tensile_strength=tensile_strength)
    scale, power = SURFACES[edition][surface]
    return smaller(scale * (tensile_strength / 1e6) ** power, 1.0)


def size_factor(*, diameter: Number) -> Number:
    """Size factor kb of a round section in bending, at most 1; diameter d in m, within `SIZES`.

    ``1.24*d^-0.107`` to 51 mm, then ``1.51*d^-0.157``, d in mm; the whole diameter counts, as the
    bending of a pin turns around it.
    Source: Shigley, eq. (6-20) of the 9th edition.

    >>> round(size_factor(diameter=0.032), 6)
    0.855797
    """
    check_positive(diameter=diameter)
    size = diameter * 1e3
    factor = where(size <= 51.0, 1.24 * size**-0.107, 1.51 * size**-0.157)
    return smaller(factor, 1.0)


def reliability_factor(*, percent: float) -> float:
    """Reliability factor ke; `InvalidInput` for a percentage that is not in `RELIABILITIES`."""
    if percent not in RELIABILITIES:
        raise InvalidInput("reliability_percent", percent, "not_in_table", values=[*RELIABILITIES])
    return RELIABILITIES[percent]


def notch_factor(*, theoretical_factor: Number, radius: Number, tensile_strength: Number) -> Number:
    """Fatigue notch factor ``Kf = 1 + (Kt - 1)/(1 + sqrt(a/r))`` (Neuber) of steel in bending.

    ``sqrt(a) = 1.24 - 2.25e-3*Rm + 1.60e-6*Rm^2 - 4.11e-10*Rm^3``, sqrt(mm), Rm in MPa. Source:
    Shigley, eqs. (6-33), (6-35) of the 11th edition. Kt, the factor of the elastic stress, is at
    least 1; the radius r is in m, Rm in Pa, clipped to `NOTCH_STRENGTHS`.

    >>> round(notch_factor(theoretical_factor=1.65, radius=0.003, tensile_strength=690e6), 6)
    1.550182
    """
    check_positive(radius=radius, tensile_strength=tensile_strength)
    check_not_negative(theoretical_factor=theoretical_factor - 1)
    low, high = NOTCH_STRENGTHS
    strength = smaller(larger(tensile_strength / 1e6, low), high)
    root = 1.24 + strength * (-2.25e-3 + strength * (1.60e-6 - 4.11e-10 * strength))
    return 1 + (theoretical_factor - 1) / (1 + root / (radius * 1e3) ** 0.5)


def endurance_limit(*, tensile_strength: Number, factors: EnduranceFactors) -> Number:
    """Endurance limit ``Se = ka*kb*ke*Se'/Kf`` of a steel part, Pa.

    ``Se' = 0.5*Rm``, at most 700 MPa. Source: Shigley, eqs. (6-8), (6-18) of the 9th edition.

    >>> factors = EnduranceFactors(surface=0.797777, size=0.855797, reliability=1.0, notch=1.0)
    >>> round(endurance_limit(tensile_strength=690e6, factors=factors)/1e6, 3)
    235.544
    """
    return factors.product * smaller(0.5 * tensile_strength, 700e6)


def utilisation(
    *,
    amplitude: Number,
    mean: Number,
    endurance: Number,
    tensile_strength: Number,
    yield_strength: Number | None = None,
    criterion: Criterion = "goodman",
) -> Number:
    """Utilisation 1/n of the fatigue strength by a stress cycle, with the safety factor n.

    The criteria for amplitude sa, mean sm, endurance limit Se, Rm and Re are: "goodman"
    ``sa/Se + max(sm, 0)/Rm``; "gerber" ``n*sa/Se + (n*sm/Rm)^2 = 1``, sm > 0; "soderberg"
    ``sa/Se + max(sm, 0)/Re``, which needs Re; "fkm_haigh" ``(sa + M*sm)/Se`` up to a stress ratio
    of 0, with ``M = 0.35e-3*Rm - 0.1`` (Rm in MPa) of steel, a third of the slope from there to
    0.5, then constant, and constant if both stresses are compressive. A utilisation never falls if
    the largest stress rises or the least one falls, so that both stresses suffice to find the worst
    direction. Sources: Shigley, eqs. (6-40), (6-45) to (6-47) of the 9th edition; FKM guideline,
    2.4.2.

    Shigley, example 6-10 (kpsi), has 3.66 by Gerber.

    >>> cycle = {"amplitude": 8.38, "mean": 8.38, "endurance": 33.9, "tensile_strength": 100.0}
    >>> [round(1/utilisation(**cycle, criterion=each), 4) for each in ("gerber", "goodman")]
    [3.664, 3.0212]
    """
    share = amplitude / endurance
    pulls = larger(mean, 0.0)
    if criterion == "goodman":
        return share + pulls / tensile_strength
    if criterion == "gerber":
        return (share + (share * share + 4 * (pulls / tensile_strength) ** 2) ** 0.5) / 2
    if criterion == "soderberg":
        if yield_strength is None:
            raise InvalidInput("yield_strength", None, "needed", field="criterion")
        return share + pulls / yield_strength
    slope = larger(0.35e-9 * tensile_strength - 0.1, 0.0)
    held = larger(smaller(mean, amplitude), -amplitude)
    beyond = larger(smaller(mean, 3 * amplitude) - amplitude, 0.0)
    third = slope / 3
    return (amplitude + slope * held + third * (1 + slope) / (1 + third) * beyond) / endurance


def strength_fraction(*, tensile_strength: float) -> float:
    """Share f of the tensile strength that steel stands for 1000 cycles.

    ``f = 1.06 - 2.8e-3*S + 6.9e-6*S^2`` with the strength S in kpsi, clipped to 70 to 200
    (`LINE_STRENGTHS`).
    Source: Shigley, eq. (6-11) of the 11th edition, a fit of the curve in earlier ones.

    >>> round(strength_fraction(tensile_strength=120*6.894757e6), 3)
    0.823
    """
    strength = min(max(tensile_strength / KPSI, 70.0), 200.0)
    return 1.06 - 2.8e-3 * strength + 6.9e-6 * strength**2


def cycles_to_failure(
    *,
    amplitude: float,
    mean: float,
    endurance: float,
    tensile_strength: float,
    fraction: float,
) -> float:
    """Cycles to failure of a steel part: ``(sigma_rev/a)^(1/B)`` with f of `strength_fraction`.

    ``a = (f*Rm)^2/Se``, ``B = -log10(f*Rm/Se)/3``, ``sigma_rev = sa/(1 - max(sm, 0)/Rm)``. Infinite
    up to the endurance limit; 0 if the mean alone breaks the part, or if ``Se >= f*Rm`` and Se is
    exceeded. The line does not hold below `LOW_CYCLES`. Source: Shigley, eqs. (6-13) to (6-16) of
    the 9th edition; example 6-3 of the 11th (kpsi) has 117 000 with rounded numbers.

    >>> round(cycles_to_failure(amplitude=70.0, mean=0.0, endurance=60.0,
    ...                         tensile_strength=120.0, fraction=0.82))
    116193
    """
    left = 1 - max(mean, 0.0) / tensile_strength
    if left <= 0:
        return 0.0
    reversed_stress = amplitude / left
    if reversed_stress <= endurance:
        return math.inf
    short = fraction * tensile_strength
    if short <= endurance:
        return 0.0
    # N = 10^6*(sigma/Se)^(1/B) is another form of the line
    power = -3 / math.log10(short / endurance)
    exponent = 6 + power * math.log10(reversed_stress / endurance)
    return float(10.0**exponent)


def finite_strength(
    *,
    endurance: float,
    tensile_strength: float,
    cycles: float,
    fraction: float,
) -> float:
    """Reversed stress that a steel part stands for a number of cycles, Pa: ``a*N^B``.
    The line is that of `cycles_to_failure`: ``f*Rm`` up to 1000 cycles, Se from a million on or if
    ``Se >= f*Rm``.

    >>> round(finite_strength(endurance=60.0, tensile_strength=120.0, cycles=116193,
    ...                       fraction=0.82), 3)
    70.0
    """
    short = fraction * tensile_strength
    if short <= endurance or cycles >= ENDURING:
        return endurance
    left = math.log(ENDURING / max(cycles, LOW_CYCLES)) / math.log(ENDURING / LOW_CYCLES)
    return float(endurance * (short / endurance) ** left)


@dataclass(frozen=True, slots=True)
class FatigueStrength:
    """Fatigue strength of a part and the criterion by which cycles are judged."""

    endurance_limit: float  # Se, Pa
    tensile_strength: float  # Rm, Pa
    yield_strength: float | None = None  # Re, Pa
    criterion: Criterion = "goodman"
    factors: EnduranceFactors | None = None  # factors of the limit; None where the limit is given
    cycles: float = math.inf  # cycles that the part has to stand
    notices: tuple[Notice, ...] = ()  # formulas of the limit used outside their ranges

    def __post_init__(self) -> None:
        check_positive(endurance_limit=self.endurance_limit, tensile_strength=self.tensile_strength)
        if self.criterion == "soderberg" and self.yield_strength is None:
            raise InvalidInput("yield_strength", None, "needed", field="criterion")

    @property
    def line(self) -> dict[str, float]:
        """Arguments of `cycles_to_failure` that fix the line of finite life."""
        tensile = self.tensile_strength
        fraction = strength_fraction(tensile_strength=tensile)
        ends = {"endurance": self.endurance_limit, "fraction": fraction}
        return ends | {"tensile_strength": tensile}

    @property
    def lasting(self) -> float:
        """Strength for the required cycles, Pa: at least the endurance limit."""
        return finite_strength(cycles=self.cycles, **self.line)

    def utilisation(self, amplitude: Number, mean: Number) -> Number:
        """Utilisation of the strength by a cycle of amplitude and mean, Pa."""
        return utilisation(
            amplitude=amplitude,
            mean=mean,
            endurance=self.lasting,
            tensile_strength=self.tensile_strength,
            yield_strength=self.yield_strength,
            criterion=self.criterion,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class CycleFatigue:
    """Fatigue of a part under one stress cycle."""

    max_stress: float = answer("MPa", "σ_max")
    """Largest stress."""
    min_stress: float = answer("MPa", "σ_min")
    """Least stress."""
    amplitude: float = answer("MPa", "σ_a")
    """Amplitude of the cycle."""
    mean: float = answer("MPa", "σ_m")
    """Mean of the cycle."""
    endurance_limit: float = answer("MPa", "S_e")
    """Endurance limit of the part."""
    finite_strength: float | None = answer("MPa", "S_f")
    """Strength for the cycles of the required life, if these are fewer than a million; it replaces
    the endurance limit in the safety factor."""
    factors: EnduranceFactors | None = answer()
    """Factors of the endurance limit; absent if the limit is given."""
    safety_factor: float = answer("", "n")
    """Safety factor by the criterion: factor by which all stresses may grow."""
    cycles: float | None = answer("", "N")
    """Number of cycles to failure; absent below the endurance limit."""
    notices: tuple[Notice, ...] = ()  # formulas used outside their ranges
    short: bool = False  # True if the required cycles are so few that the strength is above Se


def judge_cycle(*, strength: FatigueStrength, largest: float, least: float) -> CycleFatigue:
    """Fatigue of a part under a stress cycle from `least` to `largest`, Pa, which must differ.

    A cycle from 0 to 300 MPa by Goodman:

    >>> strength = FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6)
    >>> round(judge_cycle(strength=strength, largest=300e6, least=0.0).safety_factor, 6)
    1.538462
    """
    amplitude, mean = (largest - least) / 2, (largest + least) / 2
    cycles = cycles_to_failure(amplitude=amplitude, mean=mean, **strength.line)
    short = strength.lasting > strength.endurance_limit
    notices = strength.notices
    if short or cycles < math.inf:  # the line of finite life is used
        tensile = strength.tensile_strength / 1e6
        notices += beyond_range(code="life_beyond_strength", value=tensile, ends=LINE_STRENGTHS)
    return CycleFatigue(
        max_stress=largest,
        min_stress=least,
        amplitude=amplitude,
        mean=mean,
        endurance_limit=strength.endurance_limit,
        finite_strength=strength.lasting if short else None,
        factors=strength.factors,
        safety_factor=1 / float(strength.utilisation(amplitude, mean)),
        cycles=cycles if cycles < math.inf else None,
        notices=notices,
        short=short,
    )
