"""Parts that a shop makes and buys: processes with their materials, clearances and modifications of
the teeth; diameters of pins; bearings by name.
"""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from core.arrays import FloatArray
from core.bearings import BEARINGS, NamedBearing
from core.fields import answer
from core.tolerance.processes import PROCESSES

ShopName = Literal["ground", "precise", "milled", "fdm", "sls"]

PINS = (3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0)
"""Diameters of hardened and ground parallel pins of ISO 8734, mm."""

SLEEVED, SLEEVE = 8.0, 0.2
"""Least diameter of output pins with sleeves, mm, and wall of a sleeve over it."""

SERIES = ("60", "62", "63", "68", "69", "NU2", "NU3")
"""Series of bearings with two rings."""


@dataclass(frozen=True, slots=True)
class Shop:
    """Parts as a process makes them."""

    code: ShopName = answer()
    """Process whose tolerances the parts have."""
    disc: str = answer()
    """Material of the discs."""
    clearance: float = answer("mm")
    """Radial clearance of pins in their holes: nearly all pieces go together."""
    least_gap: float = answer("mm")
    """Least equidistant modification of the teeth."""
    relative_gap: float = answer()
    """Equidistant modification of the teeth over the radius of the ring pin circle."""
    friction: float = answer()
    """Coefficient of friction: of metals in oil, of plastics dry on steel."""
    pin: str = answer(default="steel_bearing")
    """Material of output pins, sleeves and ring pins."""
    pin_class: str = answer(default="h6")
    """ISO 286 class of the diameters of pins and sleeves, which are bought."""

    @property
    def zone(self) -> float:
        """Diameter of the zone in which the centre of a pin or a hole lies, m."""
        return PROCESSES[self.code].position

    def modification(self, circle: Any) -> Any:
        """Equidistant modification of the teeth by the radius of the ring pin circle, m, to
        0.001 mm.
        """
        return np.round(np.maximum(self.relative_gap * circle, self.least_gap) * 1e6) / 1e6


SHOPS: dict[ShopName, Shop] = {
    each.code: each
    for each in (
        Shop("ground", "steel_case_hardened", 0.012e-3, 8e-6, 1e-4, 0.05, pin_class="h5"),
        Shop("precise", "steel_through_hardened", 0.03e-3, 20e-6, 2e-4, 0.05),
        Shop("milled", "steel_through_hardened", 0.1e-3, 60e-6, 4e-4, 0.05),
        Shop("fdm", "plastic_pla_printed", 0.4e-3, 0.2e-3, 0.0, 0.2),
        Shop("sls", "plastic_pa12_sintered", 0.36e-3, 0.2e-3, 0.0, 0.3),
    )
}
"""Shops by the code of their process."""

NOTCH, RELIABILITY = 1.5, 99.0
"""Notch factor of pins at their seats, and reliability of their fatigue strength, %."""


def pin_sizes() -> FloatArray:
    """Diameters of pins, and radii of what touches their holes, m, as rows: sleeves on pins of 8 mm
    or more.
    """
    rows = [(d, d / 2 if d < SLEEVED else math.ceil((0.5 + SLEEVE) * d * 2) / 2) for d in PINS]
    return np.array(rows) / 1e3


@lru_cache(maxsize=16)
def bought(*, widest: float, most: float) -> tuple[NamedBearing, ...]:
    """Bearings up to a width and an outer diameter, m, in ascending order of their dynamic ratings:
    those of which no other one is smaller outside, narrower, wider in its bore and carries more.
    """
    fitting = [
        each
        for each in BEARINGS.values()
        if each.series in SERIES and each.width <= widest and each.outer_diameter <= most
    ]
    sizes = [(each.outer_diameter, each.width, -each.bore_diameter) for each in fitting]
    size = np.array(sizes).reshape(-1, 3)
    rating = np.array([each.dynamic_rating for each in fitting])
    as_small = (size[:, None] <= size).all(axis=2)
    better = as_small & (rating[:, None] > rating)  # the first of each pair than the second
    best = [fitting[index] for index in np.flatnonzero(~better.any(axis=0))]
    return tuple(sorted(best, key=lambda each: each.dynamic_rating))
