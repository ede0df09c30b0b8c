"""Design of cycloid discs with a usual modification, or usual places of ring pins, if they are not
known.

Pieces are sampled with every ring pin somewhere in a round tolerance zone. Results are an upper
estimate, as only the contacts of the mesh are elastic.
"""

from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from core.checks.check import Verdict
from core.checks.reserve import crank_verdict
from core.checks.usual_fit import UsualFit, usual_clearance, usual_fit, with_usual_clearance
from core.design.document import Design, changed
from core.design.results import Results
from core.design.ring import RingClass, usual_sizes
from core.errors import UNKNOWN, ImpossibleMechanism
from core.fields import answer
from core.output.room import Deviations
from core.output.sampled_turn import WAYS
from core.output.turn import Turn
from core.ring.profile import Modification
from core.ring.sharing import CycloidMesh
from core.tolerance.draws import KINDS, uniforms, zone_places

SAMPLES, SEED = 64, 0
"""Number of sampled pieces, and seed."""

POSITIONS = 720
"""Number of crank angles of each piece, evenly over the turn."""

MEDIAN, OF_90 = 32, 58
"""Ranks, in ascending order, of the values taken as median and 90 %."""


class Spread(NamedTuple):
    """Values that half and nine tenths of the pieces keep."""

    median: float  # x_(32) of 64
    percent_90: float  # x_(58)

    @classmethod
    def of(cls, values: list[float]) -> "Spread":
        """Spread of values of the pieces."""
        ascending, count = sorted(values), len(values)
        ranks = (-(-count * each // SAMPLES) - 1 for each in (MEDIAN, OF_90))
        return cls(*(ascending[rank] for rank in ranks))


@dataclass(frozen=True, slots=True, kw_only=True)
class UsualModification:
    """Results of a design with usual ring parts."""

    ring_class: RingClass
    equidistant: float = answer("mm", "Δ_e")
    """Equidistant modification of the discs."""
    pin_zone_diameter: float = answer("mm")
    """Diameter of the round tolerance zone of each ring pin's centre; 0 if the places of the pins
    are given."""
    samples: int = answer()
    """Number of pieces drawn."""
    crank_angles: int = answer()
    """Number of crank angles at which each piece is calculated."""
    peak_force: Spread  # over the turn, N, under the dynamic load
    max_pressure: Spread  # over the turn, Pa, under the dynamic load
    backlash: Spread  # backlash of the discs, rad
    cannot_assemble: float = answer()
    """Share of the pieces that press without load."""
    results: Results  # results of the piece with the pressure of 90 %
    verdict: Verdict  # verdict with that piece, and with a usual clearance if none is known


def ring_places(*, pins: int, radius: float, samples: int) -> list[tuple[tuple[float, ...], ...]]:
    """Radial and tangential deviations of ring pins, m, sampled evenly over round zones of a
    radius, m, for each of `samples` rings.
    """
    of_radius, of_angle = (
        uniforms(seed=SEED, streams=[(kind, k) for k in range(pins)], samples=samples).T
        for kind in KINDS["ring_pin_position"]
    )
    places = zone_places(diameter=2 * radius, radius_uniform=of_radius, angle_uniform=of_angle)
    return [tuple(tuple(row.tolist()) for row in rows) for rows in zip(*places, strict=True)]


@dataclass(frozen=True, slots=True)
class _Piece:
    """Results of one piece."""

    peak_force: float  # N
    max_pressure: float  # Pa
    backlash: float  # rad
    presses: bool  # True if pairs press without load


def _looked_at(mesh: CycloidMesh, torques: list[float]) -> _Piece:
    """Results of a piece under torques, N*m."""
    places = np.linspace(0.0, 2 * np.pi, POSITIONS, endpoint=False).tolist()
    rows = [Turn(mesh, torque).poses(places) for torque in torques]
    play = rows[0]["high"] - rows[0]["low"]
    pressure = mesh.pressure(max(float(each["pressure"].max()) for each in rows))
    return _Piece(
        peak_force=max(float(each["force"].max()) for each in rows),
        max_pressure=pressure,
        backlash=max(float(play.max()), 0.0),
        presses=bool(rows[0]["pressed"].any()),
    )


def usual_modification(design: Design, *, largest: bool = False) -> UsualModification | None:
    """Results with a usual modification if none is known, and usual places of ring pins if none are
    stated. None if both are known, teeth are out of scope, or the ring mesh cannot be solved. True
    for `largest` searches for the largest torque too.
    """
    gear, made = design.gear, design.deviations or Deviations()
    placed = bool(made.ring_pin_radial or made.ring_pin_tangential)
    if not gear or gear.kind != "cycloid" or "teeth" not in design.scope:
        return None
    known = gear.modification is not None
    if known and placed:
        return None
    circle, ring_class = gear.ring_pin_circle_radius, design.ring_class
    equidistant, _ = usual_sizes(ring_class=ring_class, circle_radius=circle)
    zone = design.ring_zone / 2
    if not known:
        design = changed(design, {"gear.modification": Modification(equidistant=equidistant)})
    try:
        mesh = Results(design).ring.mesh
    except UNKNOWN:
        return None
    if not design.load:
        return None
    places = [] if placed else ring_places(pins=design.ring_pins, radius=zone, samples=SAMPLES)
    pieces = [
        replace(made, ring_pin_radial=outward, ring_pin_tangential=along)
        for outward, along in places
    ] or [made]
    factor = design.load_factor * design.ring_factor
    torques = [way * design.pin_torque * factor for way in WAYS[design.load.torque_direction]]
    works = list[tuple[_Piece, Deviations]]()
    for piece in pieces:
        own = changed(design, {"deviations": piece}).ring_deviations
        with suppress(ImpossibleMechanism):
            works.append((_looked_at(replace(mesh, deviations=own), torques), piece))
    if not works:
        return None
    pressed = len(pieces) - sum(not each.presses for each, _ in works)
    works.sort(key=lambda each: (each[0].presses, each[0].max_pressure))
    rank = min(-(-len(pieces) * OF_90 // SAMPLES), len(works)) - 1
    results = Results(changed(with_usual_clearance(design), {"deviations": works[rank][1]}))
    return UsualModification(
        ring_class=ring_class,
        equidistant=mesh.disc.modification.equidistant,
        pin_zone_diameter=0.0 if placed else 2 * zone,
        samples=len(pieces),
        crank_angles=POSITIONS,
        peak_force=Spread.of([each.peak_force for each, _ in works]),
        max_pressure=Spread.of([each.max_pressure for each, _ in works]),
        backlash=Spread.of([each.backlash for each, _ in works]),
        cannot_assemble=pressed / len(pieces),
        results=results,
        verdict=crank_verdict(results, largest=largest),
    )


def usual_clearance_too(
    *, design: Design, ring: UsualModification | None, largest: bool = False
) -> UsualFit | None:
    """Design with a usual clearance, and with the usual modification of `ring` if none is known;
    None as in `core.checks.usual_fit.usual_fit`.
    """
    if ring is None or design.cycloid.modification is not None:
        return usual_fit(design, largest=largest)
    if design.clearance_unknown and ring.results.design.play:
        return UsualFit(usual_clearance(design)[0], ring.results, ring.verdict)
    made = ring.results.design
    own = {"gear.modification": made.cycloid.modification, "deviations": made.deviations}
    return usual_fit(changed(design, own), largest=largest)
