"""Fatigue of a pin: what it is judged by, and the verdict on a cycle of stress."""

import math
from dataclasses import dataclass

from core.arrays import Number
from core.errors import InvalidInput
from core.fatigue import Criterion, EnduranceFactors, cycles_to_failure, utilisation


@dataclass(frozen=True, slots=True)
class FatigueStrength:
    """What the fatigue of a pin is judged by.

    Attributes
    ----------
    endurance_limit : float
        Endurance limit Se, Pa.
    tensile_strength : float
        Tensile strength Rm, Pa.
    yield_strength : float or None
        Yield strength Re, Pa.
    criterion : {"goodman", "gerber", "soderberg", "fkm_haigh"}
        How the mean stress counts.
    factors : EnduranceFactors or None
        What the limit was made of; None where it was given.
    """

    endurance_limit: float
    tensile_strength: float
    yield_strength: float | None = None
    criterion: Criterion = "goodman"
    factors: EnduranceFactors | None = None

    def __post_init__(self) -> None:
        for name in ("endurance_limit", "tensile_strength"):
            if not getattr(self, name) > 0:
                raise InvalidInput(name, getattr(self, name), "greater_than", limit=0)
        if self.criterion == "soderberg" and self.yield_strength is None:
            raise InvalidInput("yield_strength", None, "needed", field="criterion")

    def utilisation(self, amplitude: Number, mean: Number) -> Number:
        """Share of the strength that a cycle takes."""
        return utilisation(
            amplitude=amplitude,
            mean=mean,
            endurance=self.endurance_limit,
            tensile_strength=self.tensile_strength,
            yield_strength=self.yield_strength,
            criterion=self.criterion,
        )


@dataclass(frozen=True, slots=True)
class PinFatigue:
    """The worst stress cycle of a pin.

    Attributes
    ----------
    direction : float or None
        Direction chi of the point of the section's edge from the tangential one, towards growing
        pressure angles, rad, 0 to 2*pi; None where the pin rotates and all are alike.
    position : float
        Distance of the section from the carrier's face, m.
    max_stress, min_stress : float
        Largest and least stress there over the turn, Pa.
    amplitude, mean : float
        Of the cycle, Pa.
    endurance_limit : float
        Endurance limit Se, Pa.
    factors : EnduranceFactors or None
        What the limit was made of.
    safety_factor : float
        By the criterion: all stresses may grow by this factor.
    cycles : float or None
        Cycles that it stands, one a turn of the crank against the output; None within the
        endurance limit: as many as there are.
    life : float or None
        The same as time, s, where it is finite and the speed is known.
    """

    direction: float | None
    position: float
    max_stress: float
    min_stress: float
    amplitude: float
    mean: float
    endurance_limit: float
    factors: EnduranceFactors | None
    safety_factor: float
    cycles: float | None
    life: float | None


def judged(
    *,
    strength: FatigueStrength,
    direction: float | None,
    position: float,
    largest: float,
    least: float,
) -> PinFatigue:
    """The fatigue of a cycle of stress.

    Parameters
    ----------
    strength : FatigueStrength
        What it is judged by.
    direction : float or None
        Direction of the point of the section's edge, rad; None where all are alike.
    position : float
        Distance of the section from the carrier's face, m.
    largest, least : float
        Ends of the cycle, Pa.

    Returns
    -------
    PinFatigue
        Without a life as time.
    """
    amplitude, mean = (largest - least) / 2, (largest + least) / 2
    cycles = cycles_to_failure(
        amplitude=amplitude,
        mean=mean,
        endurance=strength.endurance_limit,
        tensile_strength=strength.tensile_strength,
    )
    return PinFatigue(
        direction=direction,
        position=position,
        max_stress=largest,
        min_stress=least,
        amplitude=amplitude,
        mean=mean,
        endurance_limit=strength.endurance_limit,
        factors=strength.factors,
        safety_factor=1 / float(strength.utilisation(amplitude, mean)),
        cycles=cycles if cycles < math.inf else None,
        life=None,
    )
