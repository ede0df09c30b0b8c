"""Usual tolerances of manufacturing processes, as guides if nothing better is known.

Limits of diameters and position tolerances are for holes and pins of some tens of millimetres on
the finished part, by services and makers who publish them. Sources differ by a factor of two; none
of these numbers is a standard.
"""

from dataclasses import dataclass
from typing import Literal, get_args

from core.fields import answer, answered
from core.tolerance.iso286 import Limits

ProcessName = Literal["fdm", "sla", "sls", "mjf", "laser_cut", "milled", "precise", "ground"]

Size = Limits | str | None
"""Limit deviations or ISO 286 class of a diameter; None if the process makes no such part."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Process:
    """Usual tolerances of a process."""

    code: ProcessName = answer()
    """Name of the process in requests."""
    title: str = answer()
    """Designation of the process."""
    hole: Size  # size of hole diameters
    pin: Size  # size of pin diameters
    position: float = answer("mm")
    """Diameter of the round tolerance zone of each centre."""
    clearance: float = answer("mm")
    """Radial clearance with which such parts usually run; for information, as no request uses
    it."""
    clearances: tuple[float, float]  # range in the sources, m
    source: str = answer()
    """Source of the numbers."""

    @property
    @answered("mm")
    def least_clearance(self) -> float:
        """Least radial clearance in the sources."""
        return self.clearances[0]

    @property
    @answered("mm")
    def largest_clearance(self) -> float:
        """Largest radial clearance in the sources."""
        return self.clearances[1]

    def size(self, of: Literal["hole", "pin"]) -> Size:
        """Limits or class of hole or pin diameters."""
        return self.hole if of == "hole" else self.pin


def _mm(lower: float, upper: float) -> Limits:
    return Limits(lower / 1000, upper / 1000)


PROCESSES = {
    each.code: each
    for each in (
        Process(
            code="fdm",
            title="Printed from filament",
            hole=_mm(-0.40, 0.0),
            pin=_mm(0.0, 0.20),
            position=0.3e-3,
            clearance=0.25e-3,
            clearances=(0.15e-3, 0.5e-3),
            source="Layer X (holes 0.1 to 0.3 mm under size, ±0.3 mm); Makelab (±0.2 mm); Rigid "
            "Prints (±0.2 to ±0.4 mm by material); Forge Labs (moving parts 0.5 mm all round)",
        ),
        Process(
            code="sla",
            title="Printed from resin",
            hole=_mm(-0.10, 0.10),
            pin=_mm(-0.10, 0.10),
            position=0.2e-3,
            clearance=0.15e-3,
            clearances=(0.125e-3, 0.25e-3),
            source="Makelab (±0.1 mm, ±0.15 mm at 100 mm); Forge Labs (±0.25 % or ±0.25 mm); "
            "Additive3D Asia (±0.2 mm)",
        ),
        Process(
            code="sls",
            title="Sintered powder (SLS)",
            hole=_mm(-0.30, 0.10),
            pin=_mm(-0.20, 0.20),
            position=0.3e-3,
            clearance=0.25e-3,
            clearances=(0.15e-3, 0.3e-3),
            source="Brisk (moving parts 0.3 mm at least, 0.5 to 0.6 mm); Protolabs (±0.25 mm); "
            "Materialise (0.5 to 0.6 mm)",
        ),
        Process(
            code="mjf",
            title="Fused powder (MJF)",
            hole=_mm(-0.30, 0.30),
            pin=_mm(-0.30, 0.30),
            position=0.4e-3,
            clearance=0.25e-3,
            clearances=(0.25e-3, 0.25e-3),
            source="Tronix3D and HP (±0.30 mm and 0.002 mm/mm; 0.5 mm); Protolabs (±0.305 mm); "
            "Makelab (±0.3 mm)",
        ),
        Process(
            code="laser_cut",
            title="Cut by laser",
            hole=_mm(-0.25, 0.25),
            pin=None,
            position=0.25e-3,
            clearance=0.15e-3,
            clearances=(0.15e-3, 0.15e-3),
            source="Big Blue Saw (holes ±0.25 mm, places 0.13 mm); Snijlab by ISO 9013-1 (sheet to "
            "3 mm ±0.2 mm, to 6 mm ±0.3 to ±0.4 mm); kerf and taper not compensated",
        ),
        Process(
            code="milled",
            title="Milled, holes reamed, drawn pins",
            hole=_mm(-0.025, 0.025),
            pin="h6",
            position=0.1e-3,
            clearance=0.03e-3,
            clearances=(0.03e-3, 0.03e-3),
            source="FOB Proto (reamed ±0.025 mm; drilled +0.1 to +0.3 mm); Protolabs (±0.127 mm in "
            "general); ISO 2768-f (±0.1 mm to 30 mm)",
        ),
        Process(
            code="precise",
            title="Milled precisely, ground pins",
            hole="H7",
            pin="h6",
            position=0.03e-3,
            clearance=0.015e-3,
            clearances=(0.01e-3, 0.02e-3),
            source="FOB Proto (precision reamed ±0.015 mm, bored ±0.010 mm); the zone of places is "
            "an estimate",
        ),
        Process(
            code="ground",
            title="Jig bored or ground",
            hole="H6",
            pin="h5",
            position=0.01e-3,
            clearance=0.005e-3,
            clearances=(0.005e-3, 0.005e-3),
            source="FOB Proto (jig bored ±0.005 mm, places ±0.003 mm; ground ±0.003 mm); "
            "ChinaMachPro (IT6 by grinding)",
        ),
    )
}
"""Processes by code, from coarse to fine."""

assert {*PROCESSES} == {*get_args(ProcessName)}
