"""Ring mesh and output mechanism in series: both let the output lag, and discs find their own lag.

Neither stage holds the disc of the other: the teeth of a disc give in the ring, its holes on the
pins, and each disc turns to where both torques on it are equal. Errors of crank phases and disc
phases are counted once, in the teeth.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.model import Pieces
from core.errors import Accuracy, InvalidInput, Notice, poorly_known
from core.fields import answer
from core.output.loaded_position import LoadedPosition, notices
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations, Rooms
from core.output.stage import Solved, Stage, check_torque
from core.precision import SAME
from core.ring.drives import series_drive
from core.ring.sharing import CycloidMesh

HALVINGS = 60
"""Number of bisections of the interference of parts that press."""

PRESSES = 60
"""Number of crank angles at which the backlash of the discs in the ring is checked."""

SHARED = "eccentricity", "crank_phase", "disc_phase"
"""Deviations that ring and output mechanism have in common."""


def each_alone(ring: CycloidMesh) -> tuple[CycloidMesh, ...]:
    """Ring meshes of each disc by itself, K of them."""
    own, found = ring.deviations, []
    for j in range(len(ring.crank_angles)):
        alone = {name: getattr(own, name)[j : j + 1] for name in SHARED}
        found.append(
            replace(
                ring,
                crank_angles=ring.crank_angles[j : j + 1],
                pin=ring.pin.at(j),
                deviations=replace(own, **alone),
            )
        )
    return tuple(found)


def in_their_ring(*, rooms: Rooms, ring: CycloidMesh) -> Rooms:
    """Room of output pins in the holes of discs that turn in the ring within their backlash.

    The room is the largest one over the turning of each disc. Discs are held, and ``rooms`` is
    returned, if ring pins press without load. `rooms` are of discs that are held; the ring has the
    deviations of cranks and discs.
    """
    if rooms.deviations == Deviations() and ring.pins_alike:
        return rooms
    discs = each_alone(replace(ring, deviations=replace(ring.deviations, disc_phase=())))
    # A crank that is ahead turns its disc, and its holes, by phase over ratio.
    ahead = ring.deviations.crank_phase or (0.0,) * len(discs)
    more = [phase / rooms.mechanism.ratio for phase in ahead]

    pieces = [disc.drive for disc in discs]

    def turned(crank: FloatArray) -> tuple[FloatArray, FloatArray]:
        ends = np.empty((2, len(crank), len(discs)))
        for j, each in enumerate(pieces):
            room = Solved.of(each, len(crank))
            engine.unloaded(crank, 1.0, False, room.drive, room.work, room.rows, room.plays)
            ends[:, :, j] = room.plays[:, 0].T + more[j]
        presses = ends[0] > ends[1]
        ends[:, presses] = ends[:, presses].mean(axis=0)
        return ends[0], ends[1]

    low, high = turned(np.linspace(0.0, 2 * np.pi, PRESSES, endpoint=False))
    if (low == high).any():  # ring pins press without load and hold the discs
        return rooms
    turns = 1 if ring.pins_alike else ring.disc.pins
    return replace(rooms, ring=turned, turns=turns)


@dataclass(frozen=True)
class MeshesInSeries(Stage):
    """Cycloid discs between ring pins and output pins."""

    ring: CycloidMesh  # ring mesh with the phase deviations, without given shares
    # Output mechanism of equal discs, cranks and deviations; bearings and pins may be elastic.
    output: RealMechanism

    def __post_init__(self) -> None:
        ring, output = self.ring, self.output
        for name, one, other in self._twice():
            if abs(one - other) > SAME * abs(other):
                raise InvalidInput(name, one, "stages_differ", other=other)
        for support in (ring.support, output.support):
            if support.turning:
                raise InvalidInput("support", support, "only_one", field="ring")

    def _twice(self) -> Iterator[tuple[str, float, float]]:
        """Name, ring's value and output's value of each quantity that both stages have."""
        ring, output = self.ring, self.output
        yield "satellites", len(ring.crank_angles), output.mechanism.satellites
        yield "ratio", ring.disc.satellite_teeth, output.mechanism.ratio
        yield "eccentricity", ring.eccentricity, output.eccentricity
        yield "exact", ring.exact, output.exact
        lists = {"crank_angles": (ring.crank_angles, output.mechanism.crank_angles)}
        zeros = (0.0,) * output.mechanism.satellites
        for name in SHARED:
            both = getattr(ring.deviations, name), getattr(output.deviations, name)
            lists[name] = both[0] or zeros, both[1] or zeros
        for name, (rows, others) in lists.items():
            for j, (one, other) in enumerate(zip(rows, others, strict=False)):
                yield f"{name}[{j}]", one, other

    @property
    def mechanism(self) -> Mechanism:  # type: ignore[override] # not set
        """Output pins and cranks."""
        return self.output.mechanism

    @property
    def phases(self) -> Sequence[float]:
        """Angles of the cranks with their errors, rad."""
        return self.output.phases

    @property
    def pins_alike(self) -> bool:
        """True if all ring pins are alike, all output pins are, and all holes of each disc are."""
        return self.ring.pins_alike and self.output.pins_alike

    @cached_property
    def teeth(self) -> tuple[CycloidMesh, ...]:
        """Ring meshes of each disc by itself."""
        return each_alone(self.ring)

    @cached_property
    def drive(self) -> Pieces:
        """Both meshes as the engine takes them."""
        assert self.ring.drive and self.output.drive  # raises for parts without a size
        return series_drive(self)

    def wave(self, crank_angle: float) -> float:
        """Crank angle reduced to within z/2 turns of 0, rad; the period is z turns."""
        return math.remainder(crank_angle, 2 * math.pi * self.mechanism.ratio)

    def crank_angle(self, psi: float) -> float:
        """Crank angle reduced to between 0 and z turns, rad, from an angle of `wave`."""
        return psi % (2 * math.pi * self.mechanism.ratio)

    def with_wider_gaps(self, closer: float) -> "MeshesInSeries":
        """Both meshes with all gaps wider by a length in m."""
        return replace(
            self,
            ring=self.ring.with_thinner_pins(closer),
            output=replace(self.output, clearance=self.output.clearance + closer),
        )

    def notices(self, *, pressed: bool) -> tuple[Notice, ...]:
        """Notices on limits that the ring strains; ``pressed``: pairs press without load."""
        return self.ring.notices(pressed=pressed)


@dataclass(frozen=True, slots=True)
class RingPart:
    """Ring's part of a position of both meshes."""

    rotation: tuple[float, ...] = answer("arcmin", "λ_j")
    """Lag of each disc's holes behind their ideal angle: the part of the output's lag that the
    teeth cause. The rest is the lag of the pins."""
    force: tuple[tuple[float, ...], ...] = answer("N", "F_jk")
    """Force of each pin of the ring, a list for each satellite."""
    disc_torque: tuple[float, ...] = answer("Nm", "T_j", "ΣF·h")
    """Torque of the forces about each disc's centre."""
    crank_across: tuple[float, ...] = answer("N", "W_j")
    """Force of the ring on each disc against the turning of its crank."""
    crank_along: tuple[float, ...] = answer("N")
    """Force of the ring on each disc along its crank, to the axis."""
    loaded_pairs: int = answer()
    """Number of pairs with a force."""
    max_pressure: float = answer("MPa", "p_0", "Johnson 4.2")
    """Largest Hertz pressure of the pairs."""
    play: tuple[tuple[float, float], ...] = answer("arcmin", "λ₋, λ₊")
    """Angles between which each disc can turn in the ring alone; if its pins press without load,
    twice the lag at which they exert no torque on it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SeriesPosition(LoadedPosition):
    """Both meshes at one crank angle under load; forces and contacts are those of output pins.

    The interference is the length by which all gaps have to grow until no pair presses.
    """

    ring: RingPart  # forces and deflections of the ring mesh
    crank_force: tuple[float, ...]  # force of ring and pins on each crank, N, K values
    # Force of ring and pins across each crank, against its turning, N, K values. The eccentricities
    # times these forces sum to the crank's torque in exact geometry if discs do not float.
    across: tuple[float, ...]
    input_torque: float  # torque that turns the crank without friction, N*m


def series_position(
    *, real: MeshesInSeries, crank_angle: float, output_torque: float
) -> SeriesPosition:
    """Forces of both meshes, angular deflections, backlash and stiffness at one crank angle.

    With one disc, in first order, lags and backlashes of both stages add; with several discs they
    do not, since each disc depends on both stages. Friction, speed, tilting and edge load,
    deformation of discs, ring and carrier, and errors of single lobes are left out. Raises
    ImpossibleMechanism if there is no stable equilibrium, see `Stage.solved`. The torque on the
    output link, N*m, is not 0 and negative in reverse.

    With one disc the angular deflection is the sum of both stages.
    """
    check_torque(output_torque, crank_angle=crank_angle)
    way, angle = math.copysign(1.0, output_torque), real.wave(crank_angle)
    discs = slice(1, 1 + real.mechanism.satellites)
    room = real.solved([angle], output_torque)
    row, own_lags = room.rows[0], room.lags[0, discs]
    behind = room.lags[0, 0] - own_lags
    force, on_teeth = (room.forces[0, room.contacts(kind)] for kind in (engine.PIN, engine.LOBE))
    by_ring, by_pins = room.by_ring[0], room.on_discs(engine.PIN)[0]
    torques = tuple((by_ring[:, 2] + 0.0).tolist())
    on_cranks = by_ring + by_pins
    presses = bool(room.pressed[0])
    play = sorted((way * room.play[0] + 0.0).tolist())
    contact = real.output.hardest(force.tolist())
    most = max(float(force.max()), float(on_teeth.max()))
    accuracy = Accuracy("newton_bracket", float(room.error[0]) / most, room.steps)
    known = (
        *notices(
            real=real.output,
            lag=float(np.abs(behind).max()),
            pressed=False,
            contact=contact,
        ),
        *real.notices(pressed=presses),
        *poorly_known(accuracy),
    )
    return SeriesPosition(
        crank_angle=crank_angle,
        rotation=way * float(room.lag[0]),
        force=real.rows(force.tolist()),
        satellite_torque=torques,
        satellite_rotation=tuple(behind.tolist()),
        loaded_pairs=int((force > 0).sum()),
        play=None if room.jammed[0] else (play[0], play[1]),
        interference=_interference(real, angle) if presses else None,
        stiffness=float(room.stiffness[0]),
        contacts=(contact,),
        ring=RingPart(
            rotation=tuple(own_lags.tolist()),
            force=real.ring.rows(on_teeth.tolist()),
            disc_torque=torques,
            crank_across=tuple(by_ring[:, 1].tolist()),
            crank_along=tuple(by_ring[:, 0].tolist()),
            loaded_pairs=int((on_teeth > 0).sum()),
            max_pressure=real.ring.pressure(float(row[engine.LOBE_PRESSED])),
            play=tuple((low + 0.0, high + 0.0) for low, high in room.plays[0, discs].tolist()),
        ),
        crank_force=tuple(np.hypot(on_cranks[:, 0], on_cranks[:, 1]).tolist()),
        across=tuple(on_cranks[:, 1].tolist()),
        input_torque=float(row[engine.INPUT_TORQUE]),
        accuracy=accuracy,
        notices=tuple({each.code: each for each in known}.values()),
    )


def _interference(series: MeshesInSeries, angle: float) -> float:
    """Length by which all gaps have to grow until no pair presses without load, m."""

    def presses(closer: float) -> bool:
        row = series.with_wider_gaps(closer).unloaded(np.array([angle]))[0]
        return bool(row[engine.PRESSED])

    low, high = 0.0, 1e-6
    while presses(high):
        low, high = high, 2 * high
    for _ in range(HALVINGS):
        between = (low + high) / 2
        if between in (low, high):
            break
        low, high = (between, high) if presses(between) else (low, between)
    return high
