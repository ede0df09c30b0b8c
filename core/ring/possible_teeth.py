"""Search for involute teeth that mesh, given module, numbers of teeth and eccentricity only.

A grid of shifts and addenda without backlash is searched. For one shift and addendum of the planet,
the contact ratio falls and the gap between the tips grows as the ring's tip moves outwards. A
contact ratio is therefore within reach if the tips pass each other with the ring's tip at the place
where that ratio is reached, which one formula decides.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.ring.involute import TIPS_APART, InvoluteTeeth, Rack
from core.ring.line_of_action import LineOfAction, involute, radius_at

USUAL_SHIFTS, USUAL_ADDENDA = (-0.5, 1.0), (0.25, 1.25)
"""Ranges of the planet's profile shift and of both addenda for usual teeth, in modules; the tips of
usual teeth are `TIPS_APART`."""

SHIFTS, ADDENDA = (-1.0, 2.0), (0.1, 1.5)
"""Ranges of the planet's profile shift and of both addenda for teeth whose tips just pass."""

STEP = 0.025
"""Step of the grid of shifts and addenda, in modules."""

MISSED = 0.05
"""Largest gain of contact ratio that teeth between the points of the grid may have."""

SPARSE = 16
"""Step of the sparse selection of teeth that is searched first."""

ROUGHLY, HALVINGS = 10, 20
"""Numbers of bisections of the largest contact ratio, for the sparse selection and for the rest."""


@dataclass(frozen=True)
class PossibleTeeth:
    """Result of the search for involute teeth that mesh."""

    contact_ratio: float  # largest contact ratio of usual teeth; 0 if no usual teeth mesh
    teeth: InvoluteTeeth | None  # usual teeth with this contact ratio, of module 1
    any_mesh: bool  # true if any teeth reach a contact ratio of 1 less `MISSED`


def possible_teeth(
    *,
    satellite_teeth: int,
    ring_teeth: int,
    module: float,
    eccentricity: float,
    rack: Rack,
) -> PossibleTeeth:
    """Largest contact ratio of usual teeth, and whether any other teeth mesh.

    Teeth count if their tips pass each other, they touch on involutes, and the planet's are neither
    undercut nor pointed. The contact ratio may be too small by `MISSED`, for teeth between the
    points of the grid. Raises InvalidInput if the base circles leave no room for the eccentricity.
    The rack is that of the hob that cuts the planet; sizes are in m.

    One tooth of difference needs an eccentricity of 0.66 to 0.8 modules:

    >>> from core.ring.involute import usual_rack
    >>> rack = usual_rack(pressure_angle=math.radians(20))
    >>> teeth = {"satellite_teeth": 20, "ring_teeth": 21, "rack": rack}
    >>> ratios = [possible_teeth(**teeth, module=3.5e-3, eccentricity=each).contact_ratio
    ...           for each in (2e-3, 2.8e-3)]
    >>> [round(each, 1) for each in ratios]
    [0.5, 1.5]
    """
    line = LineOfAction.of(
        satellite_teeth=satellite_teeth,
        ring_teeth=ring_teeth,
        module=1.0,
        pressure_angle=rack.pressure_angle,
        eccentricity=eccentricity / module,
    )
    return _possible(line, rack)


@dataclass(frozen=True)
class _Looked:
    """Teeth of module 1 in the search: planets, and the range of the ring's tip, as arrays."""

    shift: FloatArray  # x_s
    tip: FloatArray  # tip radius of the planet
    end: FloatArray  # roll angle at the planet's tip
    first: FloatArray  # least roll angle at which the path may start
    outmost: FloatArray  # largest tip radius of the ring

    def chosen(self, which: BoolArray | slice) -> "_Looked":
        """Selection of the teeth."""
        return _Looked(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    def ring_tip(self, line: LineOfAction, ratio: float) -> FloatArray:
        """Largest tip radius of the ring with which the teeth have at least a contact ratio."""
        start = np.maximum(self.end - 2 * math.pi * ratio / line.satellite_teeth, self.first)
        return np.minimum(radius_at(line.on_ring(start), base=line.ring_base), self.outmost)

    def reach(self, line: LineOfAction, ratio: float, room: float) -> BoolArray:
        """True for teeth whose contact ratio can be `ratio` with tips that pass by at least `room`.

        The room is an angle times teeth, see `LineOfAction.crossing`.
        """
        ring = self.ring_tip(line, ratio)
        tips = line.crossing(satellite_tip=self.tip, ring_tip=ring).interference
        there = self.end - self.first >= 2 * math.pi * ratio / line.satellite_teeth
        return np.asarray(there & (tips >= room))


@lru_cache(maxsize=4096)
def _possible(line: LineOfAction, rack: Rack) -> PossibleTeeth:
    ratio, best = _best(line, _looked(line, rack, USUAL_SHIFTS, USUAL_ADDENDA), TIPS_APART)
    return PossibleTeeth(
        contact_ratio=ratio,
        teeth=_teeth(line, rack, best, ratio) if best.shift.size else None,
        any_mesh=ratio >= 1
        or bool(_looked(line, rack, SHIFTS, ADDENDA).reach(line, 1 - MISSED, 0.0).any()),
    )


def _teeth(line: LineOfAction, rack: Rack, best: _Looked, ratio: float) -> InvoluteTeeth:
    """First of the best teeth, with the ring's tip that gives a contact ratio."""
    shift, ring_shift = float(best.shift[0]), float(best.shift[0]) + line.wider
    return InvoluteTeeth(
        satellite_teeth=line.satellite_teeth,
        ring_teeth=line.ring_teeth,
        module=line.module,
        satellite_profile_shift=shift,
        ring_profile_shift=ring_shift,
        satellite_addendum=float(best.tip[0]) - line.satellite_teeth / 2 - shift,
        ring_addendum=line.ring_teeth / 2 + ring_shift - float(best.ring_tip(line, ratio)[0]),
        rack=rack,
    )


def _looked(
    line: LineOfAction, rack: Rack, shifts: tuple[float, float], addenda: tuple[float, float]
) -> _Looked:
    """Teeth of the grid whose planets are neither undercut nor pointed."""
    shift, height = np.meshgrid(*(_grid(ends) for ends in (shifts, addenda)), indexing="ij")
    shift, height = shift.ravel(), height.ravel()
    tan, own = math.tan(line.pressure_angle), float(involute(line.pressure_angle))
    tip = line.satellite_teeth / 2 + shift + height
    end = line.end_roll(tip)  # NaN within the base circle
    half = (math.pi / 2 + 2 * shift * tan) / line.satellite_teeth + own
    form = rack.form_roll(teeth=line.satellite_teeth, shift=shift)
    ring_shift = shift + line.wider
    inmost = line.ring_teeth / 2 + ring_shift - addenda[1]
    first = np.maximum(form, line.start_roll(np.maximum(inmost, line.ring_base)))
    outmost = line.ring_teeth / 2 + ring_shift - addenda[0]
    blunt = half >= end - np.arctan(end)
    farthest = radius_at(line.on_ring(first), base=line.ring_base)
    looked = _Looked(shift, tip, end, first, outmost)
    return looked.chosen((form >= 0) & blunt & (farthest <= outmost))


def _grid(ends: tuple[float, float]) -> FloatArray:
    return np.linspace(*ends, round((ends[1] - ends[0]) / STEP) + 1)


def _best(line: LineOfAction, looked: _Looked, room: float) -> tuple[float, _Looked]:
    """Largest contact ratio of teeth whose tips are apart, and the teeth that have it."""
    most = line.contact_ratio(start=looked.first, end=looked.end)
    high = float(np.max(most, initial=0.0))
    few = looked.chosen(slice(None, None, SPARSE))
    low, _ = _halved(line, few, room, (0.0, high), ROUGHLY)
    left = looked.chosen(looked.reach(line, low, room))
    return _halved(line, left, room, (low, high), HALVINGS)


def _halved(
    line: LineOfAction, looked: _Looked, room: float, ends: tuple[float, float], times: int
) -> tuple[float, _Looked]:
    """Largest contact ratio between two ends by bisection, and the teeth that have it."""
    low, high = ends
    for _ in range(times if looked.shift.size else 0):
        middle = (low + high) / 2
        reached = looked.reach(line, middle, room)
        if reached.any():
            looked, low = looked.chosen(reached), middle
        else:
            high = middle
    return low, looked
