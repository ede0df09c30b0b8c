"""Usual tolerances of manufacturing processes, as guides if nothing better is known.

Limits of diameters and position tolerances are for holes and pins of some tens of millimetres on
the finished part, by services and makers who publish them. Sources differ by a factor of two; none
of these numbers is a standard.
"""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, get_args

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


def _length(mm: str) -> float:
    """Length in m, to the last digit that is written in mm."""
    return float(f"{mm}e-3")


def _size(said: str) -> Size:
    """Size of a table's entry: limits in mm, a class, or none."""
    lower, _, upper = said.partition(" ")
    return Limits(_length(lower), _length(upper)) if upper else said or None


def _read() -> Iterator[Process]:
    """Processes of the table, whose lengths are in mm."""
    with Path(__file__).with_suffix(".csv").open(encoding="utf-8", newline="") as lines:
        for row in csv.DictReader(lines):
            code: Any = row["code"]
            yield Process(
                code=code,
                title=row["title"],
                hole=_size(row["hole"]),
                pin=_size(row["pin"]),
                position=_length(row["position"]),
                clearance=_length(row["clearance"]),
                clearances=(_length(row["least"]), _length(row["most"])),
                source=row["source"],
            )


PROCESSES = {each.code: each for each in _read()}
"""Processes by code, from coarse to fine."""

assert {*PROCESSES} == {*get_args(ProcessName)}
