"""Bending strength of the precessional gear's input shaft."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from core.errors import NotKnown, required
from core.fatigue import CycleFatigue, FatigueStrength, judge_cycle
from core.fields import answer, answered
from core.precession.shaft import Plane, ShaftSection, shaft_pieces


@dataclass(frozen=True, slots=True, kw_only=True)
class ShaftStrength:
    """Bending stress of the shaft, without torsion."""

    bending_moment_B: float = answer("Nm", "M_B", "|C|·a")
    """Bending moment at B."""
    bending_moment_clamp: float = answer("Nm", "M", "|C·(a + b) + B·b|")
    """Bending moment at the clamp."""
    peak_stress: float = answer("MPa", "σ")
    """Largest bending stress, 32·M/(π·d³)."""
    peak_stress_position: float = answer("mm", "x")
    """Position of the largest stress, from C towards the clamp."""
    yield_strength: float | None  # Re, Pa, where known
    # Cycle and place, m from C, of the section of least safety; None if no cycle is judged.
    worst: tuple[CycleFatigue, float] | None

    @property
    @answered("", "S", optional=True)
    def static_safety_factor(self) -> float:
        """Yield strength over the largest bending stress, if the yield strength is given."""
        if not self.peak_stress:
            raise NotKnown("unloaded")
        return required(self.yield_strength, "yield_unknown") / self.peak_stress

    @property
    @answered(optional=True)
    def fatigue(self) -> CycleFatigue:
        """Stress cycle of the section of least safety; absent for a steady load."""
        return required(self.worst, "steady_load")[0]

    @property
    @answered("mm", "x", optional=True)
    def cycle_position(self) -> float:
        """Position of the worst stress cycle, from C towards the clamp."""
        return required(self.worst, "steady_load")[1]


def shaft_strength(
    *,
    reaction_B: Plane,
    reaction_C: Plane,
    bearing_distance: float,
    overhang: float,
    sections: Sequence[ShaftSection],
    yield_strength: float | None = None,
    fatigue: Callable[[float], FatigueStrength] | None = None,
    load_rotates_with_shaft: bool = False,
) -> ShaftStrength:
    """Bending stress of the shaft under the mesh, static safety and fatigue.

    With the forces P_C and P_B on the shaft, opposite to the reactions (Khatetovsky et al. 2020,
    eqs (28)-(31)), ``M(s) = |P_C*s + P_B*max(s - a, 0)|`` as vectors, ``M_B = |P_C|*a`` and
    ``M_clamp = |P_C*(a + b) + P_B*b|``; the stress is ``32*M/(pi*d^3)``. The moment is linear
    between steps and loads, so that the largest one is at an end of such a stretch. a is the
    distance of the bearings, b that from B to the clamp, m; `fatigue` gives the strength of the
    shaft by its diameter, m. A load that turns with the shaft bends it one way all the time;
    another one turns around the shaft, and the stress is fully reversed.

    >>> found = shaft_strength(
    ...     reaction_B=(2.41639445088, -1.05399681812), reaction_C=(-171.172541156, 338.660950987),
    ...     bearing_distance=0.03, overhang=0.02, sections=[ShaftSection(0.05, 0.02)])
    >>> round(found.bending_moment_clamp*1e3, 2), round(found.peak_stress/1e6, 4)
    (18932.51, 24.1056)
    """
    a = bearing_distance

    def moment(place: float, beyond: float) -> float:
        x, y = (c * place + b * beyond for c, b in zip(reaction_C, reaction_B, strict=True))
        return math.hypot(x, y)

    places = []
    for piece in shaft_pieces(sections=sections, bearing_distance=a, overhang=overhang):
        start = a if piece.behind_b else 0.0
        for end in (piece.near, piece.far):
            bent = moment(start + end, end if piece.behind_b else 0.0)
            stress = bent * 32 / math.pi / piece.diameter**3
            places.append((stress, start + end, piece.diameter))
    stress, worst_bent, _ = max(places)
    cycles: list[tuple[CycleFatigue, float]] = []
    if fatigue is not None and not load_rotates_with_shaft:
        cycles = [
            (judge_cycle(strength=fatigue(diameter), largest=each, least=-each), place)
            for each, place, diameter in places
            if each > 0
        ]
    return ShaftStrength(
        bending_moment_B=moment(a, 0.0),
        bending_moment_clamp=moment(a + overhang, overhang),
        peak_stress=stress,
        peak_stress_position=worst_bent,
        yield_strength=yield_strength,
        worst=min(cycles, key=lambda cycle: cycle[0].safety_factor, default=None),
    )
