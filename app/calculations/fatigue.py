"""Fatigue of a part: basis of its strength, and stress cycle."""

from typing import Any, ClassVar

from app.model import Maybe, PartFields, RequestModel, ResponseModel, Size, quantity, result
from app.rules import Forms
from app.units import to_si
from core.design.sections import FatigueBasis
from core.fatigue import Criterion, Edition, Surface

STEEL_GPA = 190.0, 220.0
"""Range of Young's moduli of steels, for which alone a rule of the endurance limit exists."""


class NotchFields(PartFields, group="fatigue"):
    """Notch of the part at its largest bending stress."""

    theoretical_factor: float = quantity("Stress concentration", "K_t", step=0.1, ge=1, le=100)
    """Elastic stress concentration factor of the notch."""
    radius_mm: Size = quantity("Notch radius", "r", step=0.1)
    """Radius of the notch."""

    def section(self) -> tuple[float, float]:
        """Notch factor, and radius in SI units."""
        return self.theoretical_factor, to_si("radius_mm", self.radius_mm)


class FatigueFields(RequestModel, group="fatigue"):
    """Basis of the fatigue strength of a part."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("surface",), ("surface_factor",), ("endurance_limit_MPa",)),
        (("reliability_percent",), ("reliability_factor",), ()),
        (("fatigue_notch_factor",), ("notch",), ()),
    )

    surface: Maybe[Surface] = quantity("Surface")
    """Finish of the surface; cold-drawn counts as machined."""
    surface_factor: Maybe[float] = quantity("Surface factor", "k_a", step=0.05, ge=0.01, le=1)
    """Surface factor, given instead of the finish of the surface."""
    edition: Edition = quantity("Edition", default="shigley_11", advanced=True)
    """Edition of Shigley from which the constants of the surface factor are taken."""
    reliability_percent: Maybe[float] = quantity("Reliability", ge=50, le=99.99)
    """Reliability of 50, 90, 95, 99, 99.9 or 99.99 %; 50 % if neither the reliability nor its
    factor is given."""
    reliability_factor: Maybe[float] = quantity(
        "Reliability factor", "k_e", step=0.05, ge=0.01, le=1
    )
    """Reliability factor, given instead of the reliability."""
    fatigue_notch_factor: Maybe[float] = quantity(
        "Fatigue notch factor", "K_f", step=0.1, ge=1, le=100
    )
    """Fatigue notch factor of the seat or of any notch at the place of the largest bending; 1 means
    no notch."""
    notch: Maybe[NotchFields] = None
    endurance_limit_MPa: Maybe[Size] = quantity("Endurance limit", "S_e", step=10)
    """Endurance limit of the part itself, with all factors included."""
    criterion: Criterion = quantity("Criterion", default="goodman")
    """Criterion for the mean stress: Goodman, Gerber, Soderberg, or Haigh as in FKM."""

    def section(self, _: Any = None) -> FatigueBasis:
        """Basis in SI units."""
        return FatigueBasis(**self.to_core())


class PinFatigueFields(FatigueFields, group="fatigue"):
    """Basis of the fatigue strength of a pin, loaded once a turn of the crank against the pins."""

    life_h: Maybe[Size] = quantity("Life", "L", step=500)
    """Required life of the pins, of the requirements if not given; for fewer than a million cycles
    their strength is above the endurance limit."""


class FactorsOut(ResponseModel):
    """Factors of the endurance limit: k_a·k_b·k_e·S_e′/K_f."""

    surface: float = result("Factor of the surface.", symbol="k_a")
    size: float = result("Factor of the size.", symbol="k_b")
    reliability: float = result("Factor of the reliability.", symbol="k_e")
    notch: float = result("Fatigue notch factor.", symbol="K_f")


class CycleOut(ResponseModel):
    """Stress cycle of a part with its safety."""

    max_stress_MPa: float = result("Largest stress.", symbol="σ_max")
    min_stress_MPa: float = result("Least stress.", symbol="σ_min")
    amplitude_MPa: float = result("Amplitude of the cycle.", symbol="σ_a")
    mean_MPa: float = result("Mean of the cycle.", symbol="σ_m")
    endurance_limit_MPa: float = result("Endurance limit of the part.", symbol="S_e")
    factors: Maybe[FactorsOut] = None
    safety_factor: float = result(
        "Safety factor by the criterion: factor by which all stresses may grow.", symbol="n"
    )
    cycles: Maybe[float] = result(
        "Number of cycles to failure; absent below the endurance limit.", symbol="N"
    )
