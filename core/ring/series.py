"""Ring mesh and output mechanism in series: both let the output lag, and discs find their own lag.

Neither stage holds the other's half of a disc: its teeth give in the ring, its holes on the pins,
and each disc turns to where both torques on it are equal. Errors of crank and disc phases are
counted once, in the teeth.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from core.arrays import check_finite, check_single
from core.errors import Accuracy, InvalidInput, Notice, poorly_known
from core.hertz import HertzContact
from core.output.compiled import at_hand, plain
from core.output.loaded_position import bent_together, notices
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.sharing_kernel import too_wide
from core.output.stage import Stage, divisible, in_floats
from core.precision import SAME
from core.ring import series_kernel
from core.ring.series_disc import SeriesPairs, SeriesRoom, SeriesSetup
from core.ring.sharing import CycloidMesh

HALVINGS = 60
"""How often the interference of parts that press is halved."""


def _joined(discs: tuple[Any, ...]) -> Any:
    """Rows of all discs, of which parts are rows too."""
    return type(discs[0])(*[divisible(chain(*rows)) for rows in zip(*discs, strict=True)])


@dataclass(frozen=True)
class MeshesInSeries(Stage):
    """Cycloid discs between the pins of their ring and those of the output."""

    ring: CycloidMesh  # with the phases' deviations, without given shares
    output: RealMechanism  # of the same discs, cranks and deviations of these; nothing else gives

    def __post_init__(self) -> None:
        ring, output = self.ring, self.output
        for name, one, other in self._twice():
            if abs(one - other) > SAME * abs(other):
                raise InvalidInput(name, one, "stages_differ", other=other)
        for support in (ring.support, output.support):
            if support.first_order:
                raise InvalidInput("support", support, "only_one", field="ring")
        if output.pin.tied:
            raise InvalidInput("pin.support", "tie_ring", "only_one", field="ring")

    def _twice(self) -> Iterator[tuple[str, float, float]]:
        """What both stages say, each by its name."""
        ring, output = self.ring, self.output
        yield "satellites", len(ring.crank_angles), output.mechanism.satellites
        yield "ratio", ring.disc.satellite_teeth, output.mechanism.ratio
        yield "eccentricity", ring.eccentricity, output.eccentricity
        yield "exact", ring.exact, output.exact
        lists = {"crank_angles": (ring.crank_angles, output.mechanism.crank_angles)}
        zeros = (0.0,) * output.mechanism.satellites
        for name in ("eccentricity", "crank_phase", "disc_phase"):
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
    def support(self) -> None:
        """Nothing else gives."""

    @property
    def pins_alike(self) -> bool:
        """Whether all pins of the ring are alike, those of the output, and all holes of a disc."""
        return self.ring.pins_alike and self.output.pins_alike

    def setup(self, direction: float) -> SeriesSetup:
        """The design as the loops take it.

        Parameters
        ----------
        direction : float
            Of the torque: 1, or -1 in reverse.

        Returns
        -------
        SeriesSetup
        """
        own = self.mechanism
        return in_floats(
            SeriesSetup(
                pins=own.pins,
                satellites=own.satellites,
                direction=direction,
                ratio=own.ratio,
                start=own.initial_crank_angle,
                mesh=self.ring.setup(direction)._replace(satellites=1),
                output=self.output.setup(direction)._replace(satellites=1),
            )
        )

    @cached_property
    def discs(self) -> tuple[tuple[CycloidMesh, RealMechanism], ...]:
        """Each disc by itself in its ring, and on the pins of the output. Discs are put onto these
        by the holes that lie next to them.
        """
        ring, output, own = self.ring, self.output, self.mechanism
        assert ring.pairs and output.pairs  # refuse what has no size, by its own number
        errors, found = output.rooms.numbered[0], []
        for j, angle in enumerate(own.crank_angles):

            def of(values: tuple[Any, ...], j: int = j) -> tuple[Any, ...]:
                return values[j : j + 1]

            phase = of(errors.crank_phase) or (0.0,)
            shared = {"eccentricity": of(errors.eccentricity), "crank_phase": phase}
            found.append(
                (
                    replace(
                        ring,
                        crank_angles=(angle,),
                        pin=ring.pin.at(j),
                        deviations=replace(
                            ring.deviations, **shared, disc_phase=of(errors.disc_phase)
                        ),
                    ),
                    replace(
                        output,
                        mechanism=replace(own, crank_angles=(angle,)),
                        pin=output.pin.at(j),
                        deviations=Deviations(
                            errors.pin_radial,
                            errors.pin_tangential,
                            errors.pin_radius,
                            of(errors.hole_radial),
                            of(errors.hole_tangential),
                            of(errors.hole_radius),
                            **shared,
                            # The disc's lag has it: a crank ahead turns its disc there.
                            disc_phase=(-phase[0] / own.ratio,),
                        ),
                    ),
                )
            )
        return tuple(found)

    @cached_property
    def pairs(self) -> SeriesPairs:
        """Constants of the pairs."""
        teeth, holes = zip(*[(one.pairs, other.pairs) for one, other in self.discs], strict=True)
        return SeriesPairs(_joined(teeth), _joined(holes))

    def room(self) -> SeriesRoom:
        """Room for the results of one position."""
        count = self.mechanism.satellites
        rooms = [(one.room(), other.room()) for one, other in self.discs]
        teeth, holes = zip(*rooms, strict=True)
        rows = ([0.0] * count for _ in SeriesRoom._fields[2:])
        return SeriesRoom(_joined(teeth), _joined(holes), *rows)

    @property
    def loops_of_turns(self) -> Any:
        """The same, compiled where they can be."""
        return at_hand(series_kernel)

    @cached_property
    def loops(self) -> Any:
        """The functions of `core.output.sharing_kernel` over `core.ring.series_kernel`."""
        return plain(series_kernel)

    def forces(self, room: SeriesRoom) -> list[float]:
        """Forces of the pins of the output, N.

        Parameters
        ----------
        room : SeriesRoom
            Of a position.
        """
        return [*room.holes.force]

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

    def beyond_law(self, room: SeriesRoom) -> dict[str, Any]:
        """The pair whose force is beyond its law: satellite, and pin of the ring or the output.

        Parameters
        ----------
        room : SeriesRoom
            A position in which one is.
        """
        stages = (
            (self.pairs.teeth, room.teeth, self.ring.disc.pins),
            (self.pairs.holes, room.holes, self.mechanism.pins),
        )
        found = [(too_wide(pairs, own), pins) for pairs, own, pins in stages]
        j, n = next(divmod(pair, pins) for pair, pins in found if pair >= 0)
        return {"satellite": j + 1, "pin": n + 1}

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
    # eccentricities what turns the crank, in exact geometry.
    across: tuple[float, ...]
    input_torque: float  # that turns the crank without friction, N*m
    rotation_error: float  # bound, of the lags of output and discs, rad
    play_error: float  # bound, rad
    force_error: float  # bound, of each force, N
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
    and carrier, clearance and compliance of the crank's bearings, errors of single lobes.

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
    way, torque = math.copysign(1.0, output_torque), abs(output_torque)
    setup, room, angle = real.setup(way), real.room(), real.wave(crank_angle)
    found = real.solved(angle, torque, setup, room)
    own_lags = [way * each for each in room.lag]
    behind = [way * found.lag - each for each in own_lags]
    every = range(setup.satellites)
    cranks = [series_kernel.on_crank(j, angle, found.lag, setup, real.pairs, room) for j in every]
    force, on_teeth = np.array(real.forces(room)), np.array(room.teeth.force)
    torques = tuple(way * each + 0.0 for each in room.torque)
    curved = np.array(real.pairs.teeth.curved)
    presses = bool(room.pressed[0])
    pressed = found.low > found.high + found.play_error
    play = sorted((way * found.low + 0.0, way * found.high + 0.0))
    contact = real.output.hardest(force.tolist())
    most = max(float(force.max()), float(on_teeth.max()))
    accuracy = Accuracy("newton_bracket", found.force_error / most, found.steps)
    input_torque = series_kernel.input_torque(angle, torque, found.lag, setup, real.pairs, room)
    known = (
        *notices(
            real=real.output,
            lag=max(map(abs, behind)),
            pressed=False,
            contact=contact,
        ),
        *bent_together(real=real.output, force=force.reshape(-1, setup.pins)),
        *real.notices(pressed=presses),
        *poorly_known(accuracy),
    )
    return SeriesPosition(
        crank_angle=crank_angle,
        rotation=way * found.lag,
        force=real.rows(force.tolist()),
        satellite_torque=torques,
        satellite_rotation=tuple(behind),
        loaded_pairs=int((force > 0).sum()),
        play=None if pressed else (play[0], play[1]),
        interference=_interference(real, angle) if presses else None,
        stiffness=found.stiffness,
        contacts=(contact,),
        ring=RingPart(
            rotation=tuple(own_lags),
            force=real.ring.rows(on_teeth.tolist()),
            disc_torque=torques,
            crank_across=tuple(across for _, across, _, _ in cranks),
            crank_along=tuple(along for along, *_ in cranks),
            loaded_pairs=int((on_teeth > 0).sum()),
            max_pressure=real.ring.pressure(float((on_teeth * curved).max())),
            play=tuple(
                (min(way * low, way * high) + 0.0, max(way * low, way * high) + 0.0)
                for low, high in zip(room.low, room.high, strict=True)
            ),
        ),
        crank_force=tuple(math.hypot(a + c, b + d) for a, b, c, d in cranks),
        across=tuple(b + d for _, b, _, d in cranks),
        input_torque=input_torque,
        rotation_error=max(found.lag_error, *(each + found.play_error for each in room.error)),
        play_error=found.play_error,
        force_error=found.force_error,
        accuracy=accuracy,
        notices=tuple({each.code: each for each in known}.values()),
    )


def _interference(series: MeshesInSeries, angle: float) -> float:
    """Smallest possible worst approach without load where pairs press: by how much all gaps have to
    be wider, so that nothing does.
    """

    def presses(closer: float) -> bool:
        wider = series.with_wider_gaps(closer)
        low, high, _, held = series_kernel.placed(
            angle, wider.setup(1.0), wider.pairs, wider.room()
        )
        return held or low > high

    low, high = 0.0, 1e-6
    while presses(high):
        low, high = high, 2 * high
    for _ in range(HALVINGS):
        between = (low + high) / 2
        if between in (low, high):
            break
        low, high = (between, high) if presses(between) else (low, between)
    return high
