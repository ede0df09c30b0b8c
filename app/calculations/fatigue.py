"""Fatigue of a part: basis of its strength, and stress cycle."""

from collections.abc import Mapping
from typing import Any

from app.fields import SectionFields
from app.model import ResponseModel
from core.design.sections import FatigueBasis
from core.fatigue import CycleFatigue, EnduranceFactors, FatigueStrength
from core.materials import like_steel


class FatigueFields(SectionFields, of=FatigueBasis, without=("life",), group="fatigue"):
    """Basis of the fatigue strength of a part."""


def strength_of(basis: FatigueBasis, own: Mapping[str, Any], diameter: float) -> FatigueStrength:
    """Fatigue strength of a round part of a diameter, m, by inputs of its material; NotKnown if a
    value lacks.
    """
    return basis.of(
        diameter=diameter,
        tensile_strength=own.get("tensile_strength"),
        yield_strength=own.get("yield_strength"),
        steel=like_steel(own["youngs_modulus"]),
    )


class PinFatigueFields(SectionFields, of=FatigueBasis, group="fatigue"):
    """Basis of the fatigue strength of a pin, loaded once a turn of the crank against the pins."""


class FactorsOut(ResponseModel, of=EnduranceFactors):
    """Factors of the endurance limit: k_a·k_b·k_e·S_e′/K_f."""


class CycleOut(ResponseModel, of=CycleFatigue, without=("finite_strength",)):
    """Stress cycle of a part with its safety."""
