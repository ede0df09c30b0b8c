"""The mechanism as it is made, over the turn: peak, backlash, lost motion, transmission error.

Everything depends on the wave angle alone and repeats with its turn; with deviations of pins or
holes it has no shorter period. Forces have kinks and play has cusps where pairs take over from each
other, and extremes like to sit there: summits are narrowed to where the lines from both sides meet.
"""

import math
from typing import NamedTuple

import numpy as np

from core.arrays import check_finite, check_single
from core.drive.engine import HIGH, INPUT_TORQUE, LAG, LOST, PLAY, STIFFNESS
from core.errors import Accuracy, InvalidInput, Notice, derived, poorly_known
from core.hertz import HertzContact
from core.numerics.extremes import second_look
from core.output.contact_force import PairNumber
from core.output.loaded_position import notices
from core.output.real_mechanism import RealMechanism
from core.output.summits import Grid, Summit, all_summits, summits
from core.output.turn import Rows, Turn
from core.precision import AS_TYPED, SAME

HALVINGS = 16
"""How often a step of the grid in which pairs take over from each other is halved."""

FELT = 2.0
"""How many times its own error a force is there at least, where it is looked for."""

FLAT = 1e-7
"""How far the place of a smooth summit may be off by the rounding of its height, rad."""


class Peak(NamedTuple):
    """The largest force over the turn, and that of each pair."""

    force: float  # N
    crank_angle: float  # first one >= 0 where it is, rad
    pair: int  # index of the pair that carries it there
    pair_force: list[float]  # largest force of each pair, N
    relative_error: float  # estimate of the error of the peak
    evaluations: int  # positions solved for it


class OverTurn:
    """Extremes over the turn of the wave, each looked for when it is asked for.

    Parameters
    ----------
    turn : Turn
        The mechanism under a torque.
    """

    def __init__(self, turn: Turn) -> None:
        self.turn = turn
        self.real: RealMechanism = turn.real

    def _grid(self, rows: Rows, name: str, sign: int = 1) -> Grid:
        heights = rows["high"] - rows["low"] if name == "backlash" else rows[name]
        if name == "backlash":
            heights = np.maximum(heights, 0.0)
        return Grid(rows["wave"], sign * heights, self.turn.period)

    def _above(self, looked: Grid, kind: int, top: Summit, sign: int = 1) -> tuple[Summit, float]:
        """The higher one of a summit and what a second look finds, and by how much it is."""
        place, height, error = second_look(
            places=looked.places,
            heights=looked.heights,
            known=top.height,
            narrow=self.turn.narrow(kind, sign),
            period=looked.period,
        )
        if not height > top.height:
            return top, 0.0
        return Summit(place, height, error, (place,)), height - top.height

    @derived
    def _peak(self) -> Peak:
        turn = self.turn
        coarse, fine, again = (
            self._grid(rows, "force") for rows in (turn.coarse, turn.fine, turn.again)
        )
        before = turn.evaluations
        found, top, rough = all_summits(coarse=coarse, fine=fine, narrow=turn.narrow(turn.force))
        top, missed = self._above(again, turn.force, top)
        found.append(top)
        peak, first = top.height, turn.first
        offs = [
            (psi - first) % turn.period
            for summit in found
            if summit.height >= peak * (1 - AS_TYPED)
            for psi in summit.alike
        ]
        off = min(0.0 if each > turn.period - FLAT else each for each in offs)
        places = sorted({psi for summit in found for psi in summit.alike})
        there = turn.poses([first + off, *places])["forces"]
        all_forces = turn.fine["forces"], turn.again["forces"], there
        most = turn.of_pairs(np.max([each.max(axis=0) for each in all_forces], axis=0))
        unsure = float(turn.fine["error"].max())
        return Peak(
            force=peak,
            crank_angle=off / (1 + 1 / self.real.mechanism.ratio),
            pair=int(there[0].argmax()),
            pair_force=most.tolist(),
            relative_error=(abs(peak - rough) + missed + top.error + unsure) / peak,
            evaluations=len(fine.places) + len(again.places) + turn.evaluations - before,
        )

    @property
    def peak_force(self) -> float:
        """F_max of all pairs, N."""
        return self._peak.force

    @property
    def peak_force_ratio(self) -> float:
        """F_max/F0, F0 = T/R."""
        return self.peak_force * self.real.pin_circle_radius / abs(self.turn.torque)

    @property
    def peak_crank_angle(self) -> float:
        """First crank angle >= 0 at which it occurs, rad."""
        return self._peak.crank_angle

    @property
    def peak_pair(self) -> PairNumber:
        """The pair that carries it there."""
        satellite, pin = divmod(self._peak.pair, self.real.mechanism.pins)
        return PairNumber(satellite + 1, pin + 1)

    @property
    def pair_force(self) -> tuple[tuple[float, ...], ...]:
        """Largest force of each pair, N, K x N."""
        return self.real.rows(self._peak.pair_force)

    @derived
    def _contact(self) -> HertzContact:
        """Contact of the pair with the peak force."""
        return self.real.contact(self._peak.pair, self.peak_force)

    @derived
    def _curved_alike(self) -> bool:
        """Whether all pairs are, so that the largest pressure is at the peak of the force."""
        curved = self.real.curved
        return not bool(curved.max() > curved.min() * (1 + SAME))

    @derived
    def _pressed(self) -> Summit:
        """Where the largest pressure is."""
        grid = self._grid(self.turn.fine, "pressure")
        tops = summits(grid=grid, narrow=self.turn.narrow(self.turn.pressure))
        top = max(tops, key=lambda summit: summit.height)
        return self._above(self._grid(self.turn.again, "pressure"), self.turn.pressure, top)[0]

    @derived
    def _wraps(self) -> bool:
        """Whether the largest pressure is not Hertz's."""
        return self.real.wraps(self._peak.pair_force)

    @derived
    def hardest(self) -> tuple[int, float]:
        """The pair with the largest pressure, and its force then, N."""
        if self._wraps:
            if self._curved_alike:
                return self._peak.pair, self.peak_force
            forces = self.turn.poses([self._pressed.place])["forces"][0].tolist()
            pair = self.real.hardest_pair(forces)
            return pair, forces[pair]
        most = [*self._peak.pair_force]
        most[self._peak.pair] *= 1 + AS_TYPED  # of pairs alike that one
        pair = self.real.hardest_pair(most)
        force = self._peak.pair_force[pair]
        contact = self.real.contact(pair, force)
        return pair, force * float(self._hertz_pressure / contact.max_pressure) ** 2

    @derived
    def max_pressure(self) -> float:
        """Largest pressure, Pa."""
        if self._wraps:
            return float(self.real.contact(*self.hardest).governing_pressure)
        return self._hertz_pressure

    @derived
    def _hertz_pressure(self) -> float:
        """Largest of Hertz's pressures."""
        pressure = float(self._contact.max_pressure)
        if not self._curved_alike:
            at_peak = self.peak_force * self.real.curved[self._peak.pair]
            pressure *= math.sqrt(self._pressed.height / at_peak)
        return pressure

    def _highest(self, fine: Grid, again: Grid, kind: int, sign: int = 1) -> Summit:
        """Where a value is largest over the turn, by a grid and a second look at other places."""
        narrow = self.turn.narrow(kind, sign)
        top = max(summits(grid=fine, narrow=narrow, top=True), key=lambda each: each.height)
        return self._above(again, kind, top, sign)[0]

    def _extreme(self, name: str, kind: int, sign: int = 1) -> float:
        """Largest value of the positions over the turn, or least for the sign -1."""
        fine, again = (self._grid(rows, name, sign) for rows in (self.turn.fine, self.turn.again))
        return sign * self._highest(fine, again, kind, sign).height

    def _spread(self, name: str, kind: int) -> float:
        """Largest less least value over the turn."""
        return self._extreme(name, kind) - self._extreme(name, kind, -1)

    @derived
    def backlash_max(self) -> float:
        """Largest play of the unloaded output, rad; 0 where pairs press."""
        return self._extreme("backlash", PLAY)

    @derived
    def backlash_min(self) -> float:
        """Least play, rad."""
        return self._extreme("backlash", PLAY, -1) + 0.0

    def _by_values(self, kind: int, sign: int = 1) -> float:
        """Largest value over the turn, or least for the sign -1, of what positions do not have."""
        turn = self.turn
        looked = turn.positions()[0], turn.again["wave"]
        found = (turn.values(kind, places, turn.period) for places in looked)
        fine, again = (Grid(each.places, sign * each.heights, each.period) for each in found)
        return sign * self._highest(fine, again, kind, sign).height

    @derived
    def lost_motion(self) -> float:
        """Largest difference of lags under a share of the torque both ways, rad."""
        return self._by_values(LOST)

    @derived
    def lags(self) -> tuple[float, float]:
        """Largest and least lag under load, rad, counted as the torque turns."""
        return self._extreme("lag", LAG), self._extreme("lag", LAG, -1)

    @property
    def transmission_error(self) -> float:
        """Largest less least lag under load, rad."""
        high, low = self.lags
        return high - low

    @property
    def pressed_without_load(self) -> bool:
        """Whether pairs press so anywhere."""
        return bool(self.turn.fine["pressed"].any())

    @derived
    def unloaded_transmission_error(self) -> float:
        """The same of the lag at which the first pair touches, rad."""
        return 0.0 if self.pressed_without_load else self._spread("high", HIGH)

    @derived
    def stiffness_max(self) -> float:
        """Largest torsional stiffness, N*m/rad."""
        return self._extreme("stiffness", STIFFNESS)

    @derived
    def stiffness_min(self) -> float:
        """Least torsional stiffness, N*m/rad."""
        return self._extreme("stiffness", STIFFNESS, -1)

    @derived
    def _loaded(self) -> tuple[int, int]:
        """Least and largest number of pairs that carry, on the grid and where, between two of its
        positions, some take up and others leave: there it is halved until they are apart.
        """
        turn, rows = self.turn, self.turn.fine
        first = turn.poses([float(rows["wave"][0]) + turn.period])
        low, high = rows["wave"], np.append(rows["wave"][1:], first["wave"])
        here, there = rows["forces"] > 0, np.concatenate((rows["forces"][1:], first["forces"])) > 0
        least, most = int(rows["loaded"].min()), int(rows["loaded"].max())
        for _ in range(HALVINGS):
            handed = (here & ~there).any(axis=1) & (there & ~here).any(axis=1)
            if not handed.any():
                break
            low, high, here, there = low[handed], high[handed], here[handed], there[handed]
            middle = (low + high) / 2
            between = turn.between(middle.tolist())
            carries = between["forces"] > 0
            felt = between["forces"] > FELT * between["error"][:, None]
            least = min(least, int(carries.sum(axis=1).min()))
            most = max(most, int(felt.sum(axis=1).max()))
            low, high = np.concatenate((low, middle)), np.concatenate((middle, high))
            here, there = np.concatenate((here, carries)), np.concatenate((carries, there))
        return least, most

    @property
    def loaded_pairs_min(self) -> int:
        """Least number of pairs that carry."""
        return self._loaded[0]

    @property
    def loaded_pairs_max(self) -> int:
        """Largest number of pairs that carry; who carries for less than the grid's step only may
        not be counted.
        """
        return self._loaded[1]

    @derived
    def input_torque_ripple(self) -> float:
        """Largest less least torque of the crank, without friction, N*m."""
        return self._spread("input_torque", INPUT_TORQUE)

    @property
    def accuracy(self) -> Accuracy:
        """Of the peak force: what twice as many positions change, what a second look at other
        positions found above, and rounding. An honest estimate, no proof.
        """
        return Accuracy("sampling_zoomed", self._peak.relative_error, self._peak.evaluations)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What to know besides."""
        position = notices(
            real=self.real,
            lag=float(np.abs(self.turn.fine["lag"]).max()),
            pressed=self.pressed_without_load,
            contact=self.real.contact(*self.hardest) if self._wraps else self._contact,
        )
        return (*position, *poorly_known(self.accuracy))


def over_turn(
    *, real: RealMechanism, output_torque: float, lost_motion_share: float = 0.03
) -> OverTurn:
    """Peak force, backlash, lost motion, transmission error and stiffness over the turn.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken, 0 < share <= 1.

    Returns
    -------
    OverTurn

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        See `RealMechanism.solved`: where a position of the even grid cannot be, or, as its numbers
        are read, one between.

    Notes
    -----
    Two pins whose errors nearly use up the clearance make the force a row of spikes narrower than
    any grid, so every summit of the grid is narrowed, and the grid is dense where pairs take up.
    Where many summits are nearly as high, a second look at positions that the first did not have
    narrows those that may be higher; what it finds above is in the stated error.

    Examples
    --------
    >>> from core.output.elasticity import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> from core.materials import ElasticMaterial
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False,
    ...     pin_material=steel, hole_material=steel)
    >>> turn = over_turn(real=real, output_torque=30.0)
    >>> round(turn.peak_force, 4), round(turn.backlash_max, 10), round(turn.backlash_min, 10)
    (957.1068, 0.0021647844, 0.002)
    """
    check_single(output_torque=output_torque, lost_motion_share=lost_motion_share)
    check_finite(output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    if not lost_motion_share > 0:
        raise InvalidInput("lost_motion_share", lost_motion_share, "greater_than", limit=0)
    if not lost_motion_share <= 1:
        raise InvalidInput("lost_motion_share", lost_motion_share, "less_than_equal", limit=1)
    found = OverTurn(Turn(real, output_torque, lost_motion_share))
    assert found.turn.coarse  # refuses what cannot be
    return found
