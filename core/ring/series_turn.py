"""Ring mesh and output mechanism in series, over the turns of the crank after which all repeats.

The ring's forces repeat with the crank, those of the output with the wave, which makes ``z + 1``
turns where the crank makes z: together with z turns of the crank, one of the output. Where pins are
alike they repeat before, with other pins in their places: the ring's with each of its ``z + 1``
pitches, the output's with each of its N.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_finite, check_single
from core.drive import engine
from core.errors import InvalidInput, Notice, derived, poorly_known
from core.output.contact_force import PairNumber
from core.output.loaded_position import notices
from core.output.over_turn import OverTurn, Peak
from core.output.real_turn import refined
from core.output.sampled_turn import off_straight
from core.output.summits import Summit, highest
from core.output.turn import LOOKED_AGAIN, POSITIONS, Rows, Turn
from core.ring.series import MeshesInSeries

LEAST_A_TURN = 48
"""Positions of a turn of the crank at least."""

OF_A_PITCH = 4
"""And over a pitch of the ring's pins, where that makes no more than `MOST`."""

MOST = 2000
"""Positions of all turns above which a pitch has fewer."""

LEAST = 120
"""Positions of a shorter period at least."""

NEAR = 5e-5
"""How far forces may lie off the straight lines between samples, as a part of the largest, and of
as many turns of the wave so many times as far.
"""


def positions_in_series(*, lobes: int, pitches: int) -> int:
    """Positions of the even grid over a period: as many in each pitch of the ring's pins.

    Parameters
    ----------
    lobes : int
        Of a disc; as many turns of the crank, with one pin of the ring more.
    pitches : int
        Of the period: of all turns ``lobes*(lobes + 1)``.

    Returns
    -------
    int

    Examples
    --------
    >>> positions_in_series(lobes=20, pitches=420), positions_in_series(lobes=59, pitches=3540)
    (1680, 3540)
    >>> positions_in_series(lobes=20, pitches=5)
    120
    """
    least = math.ceil(max(LEAST_A_TURN, POSITIONS / lobes) / (lobes + 1))
    return pitches * max(least, min(OF_A_PITCH, MOST // pitches), math.ceil(LEAST / pitches))


def of_ring(rows: Rows) -> ComplexArray:
    """Force of the ring on each disc along its crank, and i times that across it.

    Parameters
    ----------
    rows : dict of array
        Positions.

    Returns
    -------
    array, shape (n, K)
        N.
    """
    found: ComplexArray = rows["along"] + 1j * rows["across"]
    return found


class SeriesTurn(Turn):
    """Both meshes under a torque, over the turns of the crank; refusals as `Stage.solved`.

    Parameters
    ----------
    real : MeshesInSeries
        Both meshes.
    torque : float
        On the output link, N*m, not 0; negative in reverse.
    share : float
        Share of the torque under which the lost motion is taken.
    """

    def __init__(self, real: MeshesInSeries, torque: float, share: float = 0.03) -> None:
        super().__init__(real, torque, share)
        lobes, pins = real.ring.disc.satellite_teeth, real.mechanism.pins
        self.first = 0.0
        self.repeats = math.gcd(lobes, pins) if real.output.pins_alike else 1
        whole = lobes if real.ring.pins_alike else lobes * (lobes + 1)
        self.pitches = whole // self.repeats
        """Of the ring, in a period."""
        self.period = 2 * math.pi * self.pitches / (lobes + 1)
        self.waves = 1 if real.ring.pins_alike else lobes + 1
        self.step = self.waves * pins // self.repeats % pins

    def at_waves(self, places: FloatArray) -> Rows:
        """Positions at wave angles of the output, rad."""
        own = self.real.mechanism
        return self.poses(((places - own.initial_crank_angle) / own.waves_per_turn).tolist())

    def of_pairs(self, largest: FloatArray) -> FloatArray:
        """Largest values of all pairs, by those over a period."""
        own = largest.reshape(self.real.mechanism.satellites, self.repeats, -1)
        return np.broadcast_to(own.max(axis=1, keepdims=True), own.shape).ravel()

    def positions(self) -> tuple[list[float], list[float]]:
        """Crank angles of an even grid; none is near where a pair takes up or leaves more than
        elsewhere.
        """
        lobes = self.real.ring.disc.satellite_teeth
        count = positions_in_series(lobes=lobes, pitches=self.pitches)
        return [self.period * k / count for k in range(count)], []

    @derived
    def close(self) -> Rows:
        """Positions of a period, as closely as the forces on the pins of the output and of the ring
        on the discs need.
        """
        near = NEAR * max(1.0, self.pitches / self.real.ring.disc.satellite_teeth)
        return refined(turn=self, near=near, besides=self._ring_off)

    def _ring_off(self, rows: Rows) -> FloatArray:
        """How far those of the ring lie off the line between their neighbours, as parts of the
        largest.
        """
        parts, wave = of_ring(rows), rows["wave"]
        angles = np.concatenate(([wave[-1] - self.period], wave, [wave[0] + self.period]))
        around = np.concatenate((parts[-1:], parts, parts[:1])).T
        off: FloatArray = off_straight(wave=angles, values=around).max(axis=0) / np.abs(parts).max()
        return off

    @property
    def looked_again(self) -> int:
        """As many for each of the grid's as of one stage."""
        return round(len(self.positions()[0]) * LOOKED_AGAIN / POSITIONS) | 1


@dataclass(frozen=True, slots=True)
class RingTurn:
    """What the ring does over the turns."""

    peak_force: float  # largest on a pin of the ring, N
    peak_crank_angle: float  # crank angle at which it occurs, rad, of all turns
    peak_pair: PairNumber  # satellite, and the pin that carries it there, from 1
    max_pressure: float  # largest Hertz pressure, Pa
    loaded_pairs_min: int  # least number of pairs with a force, on the grid
    loaded_pairs_max: int  # largest number


class SeriesOverTurn(OverTurn):
    """Extremes of both meshes over the turns, each looked for when it is asked for. What is said of
    forces and pairs is of the pins of the output, `ring` of those of the ring.

    Parameters
    ----------
    turn : SeriesTurn
        Both meshes under a torque.
    """

    def __init__(self, turn: SeriesTurn) -> None:
        super().__init__(turn)
        self.series: MeshesInSeries = turn.real
        self.real = self.series.output

    @derived
    def ring_pressed(self) -> tuple[Summit, float]:
        """Where the force over reduced radius is largest on the ring, and what of it may be
        missed.
        """
        return self._known("mesh_pressure", engine.LOBE_PRESSED)

    def _known(self, name: str, kind: int) -> tuple[Summit, float]:
        """Where a value of the positions is largest, and by how much half of them or a second look
        say otherwise.
        """
        turn = self.turn
        coarse, fine, again = (
            self._grid(rows, name) for rows in (turn.coarse, turn.fine, turn.again)
        )
        top, missed = highest(coarse=coarse, fine=fine, narrow=turn.narrow(kind))
        top, more = self._above(again, kind, top)
        return top, missed + more

    @derived
    def _peak(self) -> Peak:
        turn = self.turn
        before = turn.evaluations
        top, missed = self._known("force", turn.force)
        place = min(each % turn.period for each in top.alike)
        there = turn.poses([place])["forces"]
        fine, again = turn.fine["forces"], turn.again["forces"]
        most = turn.of_pairs(np.max([fine.max(axis=0), again.max(axis=0), there[0]], axis=0))
        unsure = float(turn.fine["error"].max())
        return Peak(
            force=top.height,
            crank_angle=place,
            pair=int(there[0].argmax()),
            pair_force=most.tolist(),
            relative_error=(missed + top.error + unsure) / top.height,
            evaluations=len(fine) + len(again) + turn.evaluations - before,
        )

    @derived
    def ring(self) -> RingTurn:
        """What the ring does."""
        turn, series = self.turn, self.series
        top, _ = self._known("mesh_force", engine.LOBE_FORCE)
        place = min(each % turn.period for each in top.alike)
        pair = int(turn.poses([place])["teeth"].argmax())
        satellite, pin = divmod(pair, series.ring.disc.pins)
        loaded = turn.fine["mesh_loaded"]
        return RingTurn(
            peak_force=top.height,
            peak_crank_angle=place,
            peak_pair=PairNumber(satellite + 1, pin + 1),
            max_pressure=self.ring_pressure,
            loaded_pairs_min=int(loaded.min()),
            loaded_pairs_max=int(loaded.max()),
        )

    @property
    def ring_pressure(self) -> float:
        """Largest Hertz pressure of its pairs, Pa."""
        return self.series.ring.pressure(self.ring_pressed[0].height)

    @property
    def pressed_without_load(self) -> bool:
        """Whether pairs press so anywhere, in either stage too."""
        return bool(self.turn.fine["pressed"].any())

    @derived
    def _pressed(self) -> Summit:
        return self._known("pressure", self.turn.pressure)[0]

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What to know besides."""
        of_output = notices(
            real=self.real,
            lag=float(np.abs(self.turn.fine["lag"]).max()),
            pressed=False,
            contact=self.real.contact(*self.hardest) if self._wraps else self._contact,
        )
        of_ring = self.series.notices(pressed=self.pressed_without_load)
        return (*of_output, *of_ring, *poorly_known(self.accuracy))


def series_over_turn(
    *, real: MeshesInSeries, output_torque: float, lost_motion_share: float = 0.03
) -> SeriesOverTurn:
    """Peak forces, backlash, lost motion, transmission error and stiffness of both meshes.

    Parameters
    ----------
    real : MeshesInSeries
        Both meshes.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken, 0 < share <= 1.

    Returns
    -------
    SeriesOverTurn

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        Where a position cannot be, see `Stage.solved`.

    Examples
    --------
    >>> from core.output.elasticity import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> from core.output.real_mechanism import RealMechanism
    >>> from core.ring.profile import CycloidDisc
    >>> from core.ring.sharing import CycloidMesh
    >>> disc = CycloidDisc(satellite_teeth=5, eccentricity=1e-3,
    ...                    ring_pin_circle_radius=0.02, ring_pin_radius=2e-3)
    >>> from core.materials import ElasticMaterial
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> ring = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(5e7), exact=False,
    ...     pin_material=steel, disc_material=steel)
    >>> output = RealMechanism(mechanism=Mechanism(3, (0.0,), 5.0), pin_circle_radius=0.01,
    ...                        pin_radius=2e-3, eccentricity=1e-3, contact_length=0.01,
    ...                        law=LinearLaw(5e7), exact=False,
    ...     pin_material=steel, hole_material=steel)
    >>> found = series_over_turn(real=MeshesInSeries(ring, output), output_torque=5.0)
    >>> round(found.peak_force, 6), round(found.ring.peak_force, 4)
    (624.616606, 686.7476)
    """
    check_single(output_torque=output_torque, lost_motion_share=lost_motion_share)
    check_finite(output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    if not 0 < lost_motion_share <= 1:
        code, limit = ("greater_than", 0) if lost_motion_share <= 0 else ("less_than_equal", 1)
        raise InvalidInput("lost_motion_share", lost_motion_share, code, limit=limit)
    found = SeriesOverTurn(SeriesTurn(real, output_torque, lost_motion_share))
    assert found.turn.coarse  # refuses what cannot be
    return found
