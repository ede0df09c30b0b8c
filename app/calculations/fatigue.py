"""Fatigue of a part: basis of its strength, and stress cycle."""

from app.fields import SectionFields
from app.model import Maybe, ResponseModel, result
from core.design.sections import FatigueBasis

STEEL_GPA = 190.0, 220.0
"""Range of Young's moduli of steels, for which alone a rule of the endurance limit exists."""


class FatigueFields(SectionFields, of=FatigueBasis, without=("life",), group="fatigue"):
    """Basis of the fatigue strength of a part."""


class PinFatigueFields(SectionFields, of=FatigueBasis, group="fatigue"):
    """Basis of the fatigue strength of a pin, loaded once a turn of the crank against the pins."""


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
