"""How well positions are known, of the output's pins, of a ring, or of both.

Forces by what is stated of them; lags by the class of the method and by what rounding of the torque
of all forces turns, which counts where parts press each other; play by its class.
"""

from typing import Any

from tests.oracles.answers.load_sharing import LAG, PLAY, ROUNDED


def _forces(found: Any) -> list[float]:
    """All forces, N, those of a ring beside the output's too."""
    parts = [found, *([found.ring] if hasattr(found, "ring") else [])]
    return [force for part in parts for row in part.force for force in row]


def force_error(found: Any) -> float:
    """Error of each force, N."""
    return float(found.accuracy.relative_error) * max(_forces(found))


def lag_error(radius: float, *found: Any) -> float:
    """Error of each lag, rad, times the pin circle radius, m; the sum for several positions."""
    error = 0.0
    for each in found:
        lags = each.rotation if isinstance(each.rotation, tuple) else (each.rotation,)
        error += LAG * max(map(abs, lags))
        error += ROUNDED * sum(_forces(each)) * radius / each.stiffness
    return error


def play_error(found: Any) -> float:
    """Error of both ends of the play, rad."""
    part, least = PLAY
    return part * max(map(abs, found.play)) + least
