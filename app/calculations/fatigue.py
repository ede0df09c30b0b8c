"""Fatigue of a part: basis of its strength, and stress cycle."""

from app.fields import SectionFields
from app.model import ResponseModel
from core.design.sections import FatigueBasis
from core.fatigue import CycleFatigue, EnduranceFactors


class FatigueFields(SectionFields, of=FatigueBasis, without=("life",), group="fatigue"):
    """Basis of the fatigue strength of a part."""


class PinFatigueFields(SectionFields, of=FatigueBasis, group="fatigue"):
    """Basis of the fatigue strength of a pin, loaded once a turn of the crank against the pins."""


class FactorsOut(ResponseModel, of=EnduranceFactors):
    """Factors of the endurance limit: k_a·k_b·k_e·S_e′/K_f."""


class CycleOut(ResponseModel, of=CycleFatigue, without=("finite_strength",)):
    """Stress cycle of a part with its safety."""
