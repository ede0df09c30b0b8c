"""Ring mesh and output mechanism in series: both let the output lag, and discs find their own lag.

Neither stage holds the other's half of a disc: its teeth give in the ring, its holes on the pins,
and each disc turns to where both torques on it are equal. Errors of crank and disc phases are
counted once, in the teeth.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from core.arrays import FloatArray, check_finite, check_single
from core.drive import engine
from core.drive.model import Pieces
from core.errors import Accuracy, InvalidInput, Notice, poorly_known
from core.hertz import HertzContact
from core.output.loaded_position import notices
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations, Rooms
from core.output.stage import Solved, Stage
from core.precision import SAME
from core.ring.drives import series_drive
from core.ring.sharing import CycloidMesh

HALVINGS = 60
"""How often the interference of parts that press is halved."""

PRESSES = 60
"""Crank angles at which is looked whether the ring has play for its discs."""

SHARED = "eccentricity", "crank_phase", "disc_phase"
"""Deviations that both stages have."""


def each_alone(ring: CycloidMesh) -> tuple[CycloidMesh, ...]:
    """Each disc by itself in its ring.

    Parameters
    ----------
    ring : CycloidMesh
        The ring with all discs.

    Returns
    -------
    tuple of CycloidMesh, K
    """
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
    """Pins in the holes of discs that turn in their ring as far as its pins let each.

    Parameters
    ----------
    rooms : Rooms
        Pins in the holes of discs that are held.
    ring : CycloidMesh
        The ring, with the deviations of cranks and discs.

    Returns
    -------
    Rooms
        Their room is the largest that is left as each disc turns within its play in the ring.
    """
    if rooms.deviations == Deviations() and ring.pins_alike:
        return rooms
    discs = each_alone(replace(ring, deviations=replace(ring.deviations, disc_phase=())))
    # Holes are ahead with a crank that is: of that the ring turns them too.
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
    if (low == high).any():  # pins of the ring press without load, and hold the discs
        return rooms
    turns = 1 if ring.pins_alike else ring.disc.pins
    return replace(rooms, ring=turned, turns=turns)


@dataclass(frozen=True)
class MeshesInSeries(Stage):
    """Cycloid discs between the pins of their ring and those of the output."""

    ring: CycloidMesh  # with the phases' deviations, without given shares
    # Of the same discs, cranks and deviations of these; its bearings and pins may give.
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
        """What both stages say, each by its name."""
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
        """Pins and cranks of the output."""
        return self.output.mechanism

    @property
    def phases(self) -> list[float]:
        """Angles of the cranks with their errors, rad."""
        return self.output.phases

    @property
    def pins_alike(self) -> bool:
        """Whether all pins of the ring are alike, those of the output, and all holes of a disc."""
        return self.ring.pins_alike and self.output.pins_alike

    @cached_property
    def teeth(self) -> tuple[CycloidMesh, ...]:
        """Each disc by itself in its ring."""
        return each_alone(self.ring)

    @cached_property
    def drive(self) -> Pieces:
        """Both meshes as the engine takes them."""
        assert self.ring.drive and self.output.drive  # refuse what has no size, by its own number
        return series_drive(self)

    def wave(self, crank_angle: float) -> float:
        """Crank angle, rad, within half of the turns after which everything repeats.

        Parameters
        ----------
        crank_angle : float
            Crank angle, rad.
        """
        return math.remainder(crank_angle, 2 * math.pi * self.mechanism.ratio)

    def crank_angle(self, psi: float) -> float:
        """The same counted from 0.

        Parameters
        ----------
        psi : float
            What `wave` says, rad.
        """
        return psi % (2 * math.pi * self.mechanism.ratio)

    def with_wider_gaps(self, closer: float) -> "MeshesInSeries":
        """The same with all gaps so much wider.

        Parameters
        ----------
        closer : float
            By how much, m.

        Returns
        -------
        MeshesInSeries
        """
        return replace(
            self,
            ring=self.ring.with_thinner_pins(closer),
            output=replace(self.output, clearance=self.output.clearance + closer),
        )

    def notices(self, *, pressed: bool) -> tuple[Notice, ...]:
        """Limits that the ring strains.

        Parameters
        ----------
        pressed : bool
            Whether pairs press without load.

        Returns
        -------
        tuple of Notice
        """
        return self.ring.notices(pressed=pressed)


@dataclass(frozen=True, slots=True)
class RingPart:
    """The ring's part of a position of both meshes."""

    rotation: tuple[float, ...]  # lag of the holes of each disc, rad, K values
    force: tuple[tuple[float, ...], ...]  # of each pair, N, K x z_p
    disc_torque: tuple[float, ...]  # of the forces about each disc's centre, N*m, K values
    crank_across: tuple[float, ...]  # force of the ring on each disc against the crank, N, K values
    crank_along: tuple[float, ...]  # and along it, to the axis, N, K values
    loaded_pairs: int  # number of pairs with a force
    max_pressure: float  # largest Hertz pressure, Pa
    # From where to where each disc can turn in the ring alone, rad, K values; where its pins press
    # the lag at which they do not turn it, twice.
    play: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class SeriesPosition:
    """Both meshes at one crank angle under load."""

    crank_angle: float  # as asked, rad
    rotation: float  # lag of the output behind its ideal angle, rad; negative in reverse
    force: tuple[tuple[float, ...], ...]  # of each pin of the output, N, K x N
    satellite_torque: tuple[float, ...]  # that each disc hands on, about its centre, N*m, K values
    satellite_rotation: tuple[float, ...]  # lag of the output behind each disc, rad, K values
    loaded_pairs: int  # number of pairs of output pins with a force
    # Least and largest lag of the unloaded output, rad; None where pairs press without load.
    play: tuple[float, float] | None
    # Smallest possible worst approach of the unloaded pairs, m, where they press.
    interference: float | None
    stiffness: float  # dT/dtheta of both, N*m/rad
    # Of the pins of the output that are pressed most, one in each direction of the torque.
    contacts: tuple[HertzContact, ...]
    ring: RingPart  # what the ring does
    crank_force: tuple[float, ...]  # of ring and pins together on each crank, N, K values
    # Across each crank, against its turning, of ring and pins together, N, K values: times the
    # eccentricities what turns the crank, in exact geometry, of discs that do not float.
    across: tuple[float, ...]
    input_torque: float  # that turns the crank without friction, N*m
    accuracy: Accuracy  # of the forces, over the largest
    notices: tuple[Notice, ...]

    @property
    def max_pressure(self) -> float:
        """The largest pressure of the pins of the output, Pa."""
        return float(max(each.governing_pressure for each in self.contacts))


def series_position(
    *, real: MeshesInSeries, crank_angle: float, output_torque: float
) -> SeriesPosition:
    """Forces of both meshes, lags, play and stiffness at one crank angle.

    Parameters
    ----------
    real : MeshesInSeries
        Ring mesh and output mechanism.
    crank_angle : float
        Crank angle, rad.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    SeriesPosition

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        See `Stage.solved`.

    Notes
    -----
    Of one disc in first order lags and plays of both stages add; of more they do not, since each
    disc hangs on both. Left out: friction, speed, tilting and edge load, deformation of discs, ring
    and carrier, errors of single lobes.

    Examples
    --------
    One disc: what the output lags is the sum of both stages.

    >>> from core.output.elasticity import LinearLaw
    >>> from core.output.loaded_position import loaded_position
    >>> from core.ring.profile import CycloidDisc
    >>> from core.ring.sharing import mesh_position
    >>> disc = CycloidDisc(satellite_teeth=18, eccentricity=1.5e-3,
    ...                    ring_pin_circle_radius=0.034, ring_pin_radius=2.5e-3)
    >>> from core.materials import ElasticMaterial
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> ring = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(5e7), exact=False,
    ...     pin_material=steel, disc_material=steel)
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False,
    ...     pin_material=steel, hole_material=steel)
    >>> found = series_position(real=MeshesInSeries(ring, real), crank_angle=0.3,
    ...                         output_torque=30.0)
    >>> alone = [mesh_position(mesh=ring, crank_angle=0.3, output_torque=30.0).rotation[0],
    ...          loaded_position(real=real, crank_angle=0.3, output_torque=30.0).rotation]
    >>> round(found.rotation/sum(alone), 12)
    1.0
    """
    check_single(crank_angle=crank_angle, output_torque=output_torque)
    check_finite(crank_angle=crank_angle, output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
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
    """Smallest possible worst approach without load where pairs press: by how much all gaps have to
    be wider, so that nothing does.
    """

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
