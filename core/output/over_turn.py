"""Extremes of the mechanism as made over the turn: peak, backlash, lost motion, transmission error.

Everything depends on the wave angle alone and repeats with its turn; with deviations of pins or
holes there is no shorter period. Forces have kinks and play has cusps where pairs take over from
each other, and extremes often lie there. Two pins whose errors nearly use up the clearance make the
force a row of spikes narrower than any grid. Every summit of the grid is therefore narrowed to
where the lines from both sides meet, and the grid is dense where pairs take up. A second look at
other positions narrows summits that may be higher, and the stated error includes what it finds.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np

from core.arrays import check_positive
from core.drive.engine import HIGH, INPUT_TORQUE, LAG, LOST, PLAY, STIFFNESS
from core.errors import Accuracy, InvalidInput, Notice, derived, poorly_known
from core.fields import answered
from core.hertz import HertzContact
from core.numerics.extremes import first_largest, second_look
from core.output.contact_force import PairNumber
from core.output.loaded_position import notices
from core.output.real_mechanism import RealMechanism
from core.output.stage import Stage, check_torque
from core.output.summits import Grid, Summit, height_of, summits
from core.output.turn import Rows, Turn
from core.precision import AS_TYPED, SAME

HALVINGS = 16
"""Number of halvings of a step of the grid in which pairs take over from each other."""

FELT = 2.0
"""Least force of a pair that counts as carrying, over the error of the force."""

FLAT = 1e-7
"""Error of the place of a smooth summit by the rounding of its height, rad."""


class Peak(NamedTuple):
    """Largest force over the turn, and largest force of each pair."""

    force: float  # N
    crank_angle: float  # first crank angle >= 0 of the peak, rad
    pair: int  # index of the pair with the peak
    pair_force: list[float]  # largest force of each pair, N
    relative_error: float  # estimate of the error of the peak
    evaluations: int  # number of solved positions


class OverTurn:
    """Extremes over the turn of the wave, each calculated when it is first asked for."""

    TURN: ClassVar[Callable[..., Turn]] = Turn
    """Turn of the stage."""

    def __init__(self, turn: Any) -> None:
        self.turn: Turn = turn
        self.real: RealMechanism = turn.real

    @classmethod
    def of(cls, real: Stage, output_torque: float, lost_motion_share: float) -> Self:
        """Extremes of a stage under a torque; positions that cannot be are refused here."""
        check_torque(output_torque, lost_motion_share=lost_motion_share)
        check_positive(lost_motion_share=lost_motion_share)
        if not lost_motion_share <= 1:
            raise InvalidInput("lost_motion_share", lost_motion_share, "less_than_equal", limit=1)
        found = cls(cls.TURN(real, output_torque, lost_motion_share))
        assert found.turn.coarse
        return found

    def _grid(self, rows: Rows, name: str, sign: int = 1) -> Grid:
        backlash = name == "backlash"
        heights = np.maximum(rows["high"] - rows["low"], 0.0) if backlash else rows[name]
        return Grid(rows["wave"], sign * heights, self.turn.period)

    def _above(
        self, looked: Grid, kind: int, found: Sequence[Summit], sign: int = 1
    ) -> tuple[Summit, float]:
        """Highest of the first look's summits or of the second's, and the difference of both."""
        top = max(found, key=height_of)
        place, height, error = second_look(
            places=looked.places,
            heights=looked.heights,
            known=top.height,
            narrow=self.turn.narrow(kind, sign, found),
            period=looked.period,
        )
        if height - top.height <= AS_TYPED * abs(top.height):
            return top, max(height - top.height, 0.0)
        return Summit(place, height, error, (place,)), height - top.height

    @derived
    def _peak(self) -> Peak:
        turn = self.turn
        coarse, fine, again = (
            self._grid(rows, "force") for rows in (turn.coarse, turn.fine, turn.again)
        )
        before = turn.evaluations
        narrow = turn.narrow(turn.force)
        found = summits(grid=coarse, narrow=narrow)
        rough = max(map(height_of, found))
        found += summits(grid=fine, narrow=narrow, known=found)
        top, missed = self._above(again, turn.force, found)
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
            pair=first_largest(there[0]),
            pair_force=most.tolist(),
            relative_error=(abs(peak - rough) + missed + top.error + unsure) / peak,
            evaluations=len(fine.places) + len(again.places) + turn.evaluations - before,
        )

    @property
    @answered("N", "F_max")
    def peak_force(self) -> float:
        """Largest force of all pairs over the turn."""
        return self._peak.force

    @property
    @answered("", "f")
    def peak_force_ratio(self) -> float:
        """Largest force of all pairs over F₀ = T/R."""
        return self.peak_force * self.real.pin_circle_radius / abs(self.turn.torque)

    @property
    @answered("deg", "φ")
    def peak_crank_angle(self) -> float:
        """First crank angle with the largest force."""
        return self._peak.crank_angle

    @property
    @answered()
    def peak_pair(self) -> PairNumber:
        """Pair with the largest force at that crank angle."""
        satellite, pin = divmod(self._peak.pair, self.real.mechanism.pins)
        return PairNumber(satellite + 1, pin + 1)

    @property
    def pair_force(self) -> tuple[tuple[float, ...], ...]:
        """Largest force of each pair over the turn, N, K x N."""
        return self.real.rows(self._peak.pair_force)

    @derived
    def _contact(self) -> HertzContact:
        """Contact of the pair with the largest force."""
        return self.real.contact(self._peak.pair, self.peak_force)

    @derived
    def _curved_alike(self) -> bool:
        """True if all pairs have one curvature, so that the largest force presses hardest."""
        curved = self.real.curved
        return not bool(curved.max() > curved.min() * (1 + SAME))

    @derived
    def _pressed(self) -> Summit:
        """Summit of the pressure over the turn."""
        grid = self._grid(self.turn.fine, "pressure")
        tops = summits(grid=grid, narrow=self.turn.narrow(self.turn.pressure))
        return self._above(self._grid(self.turn.again, "pressure"), self.turn.pressure, tops)[0]

    @derived
    def _wraps(self) -> bool:
        """True if the largest pressure is not Hertz's."""
        return self.real.wraps(self._peak.pair_force)

    @derived
    def hardest(self) -> tuple[int, float]:
        """Pair with the largest pressure and the force at that pressure, N."""
        if self._wraps:
            if self._curved_alike:
                return self._peak.pair, self.peak_force
            forces = self.turn.poses([self._pressed.place])["forces"][0].tolist()
            pair = self.real.hardest_pair(forces)
            return pair, forces[pair]
        most = [*self._peak.pair_force]
        most[self._peak.pair] *= 1 + 2 * AS_TYPED  # pair with the peak first among equals
        pair = self.real.hardest_pair(most)
        force = self._peak.pair_force[pair]
        contact = self.real.contact(pair, force)
        return pair, force * float(self._hertz_pressure / contact.max_pressure) ** 2

    @derived
    @answered("MPa", "p_0", "Johnson 4.2", optional=True)
    def max_pressure(self) -> float:
        """Largest pressure over the turn as it is judged, by Hertz or by the conformal contact. The
        value is absent if it is not known.
        """
        if self._wraps:
            return float(self.real.contact(*self.hardest).governing_pressure)
        return self._hertz_pressure

    @derived
    def _hertz_pressure(self) -> float:
        """Largest Hertzian pressure over the turn, Pa."""
        pressure = float(self._contact.max_pressure)
        if not self._curved_alike:
            at_peak = self.peak_force * self.real.curved[self._peak.pair]
            pressure *= math.sqrt(self._pressed.height / at_peak)
        return pressure

    def _highest(self, fine: Grid, again: Grid, kind: int, sign: int = 1) -> Summit:
        """Highest summit over the turn, by a grid and a second look at other places."""
        narrow = self.turn.narrow(kind, sign)
        found = summits(grid=fine, narrow=narrow, top=True)
        return self._above(again, kind, found, sign)[0]

    def _extreme(self, name: str, kind: int, sign: int = 1) -> float:
        """Largest value of a quantity of the positions over the turn, or least for the sign -1."""
        fine, again = (self._grid(rows, name, sign) for rows in (self.turn.fine, self.turn.again))
        return sign * self._highest(fine, again, kind, sign).height

    def _spread(self, name: str, kind: int) -> float:
        """Largest less least value over the turn."""
        return self._extreme(name, kind) - self._extreme(name, kind, -1)

    @derived
    @answered("arcmin", "θ₊ − θ₋")
    def backlash_max(self) -> float:
        """Largest play of the unloaded output over the turn, 0 if pairs press without load. For one
        satellite, a uniform clearance c much smaller than the eccentricity and an even number of
        pins it is about 2c/(R·cos(π/N)).
        """
        return self._extreme("backlash", PLAY)

    @derived
    @answered("arcmin", "θ₊ − θ₋")
    def backlash_min(self) -> float:
        """Least play of the unloaded output over the turn."""
        return self._extreme("backlash", PLAY, -1) + 0.0

    def _by_values(self, kind: int, sign: int = 1) -> float:
        """Largest (sign 1) or least value (-1) of a read-out that positions do not keep."""
        turn = self.turn
        looked = turn.positions()[0], turn.again["wave"]
        found = (turn.values(kind, places, turn.period) for places in looked)
        fine, again = (Grid(each.places, sign * each.heights, each.period) for each in found)
        return sign * self._highest(fine, again, kind, sign).height

    @derived
    @answered("arcmin", "", "θ(+3 % T) − θ(−3 % T)")
    def lost_motion(self) -> float:
        """Largest rotation of the output between the two directions of a share of the torque."""
        return self._by_values(LOST)

    @derived
    def lags(self) -> tuple[float, float]:
        """Largest and least angular deflection under load, positive in the torque's sense, rad."""
        return self._extreme("lag", LAG), self._extreme("lag", LAG, -1)

    @property
    @answered("arcmin", "TE")
    def transmission_error(self) -> float:
        """Transmission error under load: largest less least lag over the turn."""
        high, low = self.lags
        return high - low

    @property
    @answered()
    def pressed_without_load(self) -> bool:
        """True if pairs press without load at any crank angle."""
        return bool(self.turn.fine["pressed"].any())

    @derived
    @answered("arcmin", "TE₀")
    def unloaded_transmission_error(self) -> float:
        """Transmission error without load: largest less least lag over the turn at which the first
        pair touches.
        """
        return 0.0 if self.pressed_without_load else self._spread("high", HIGH)

    @derived
    @answered("Nm_per_arcmin", "dT/dθ")
    def stiffness_max(self) -> float:
        """Largest torsional stiffness over the turn."""
        return self._extreme("stiffness", STIFFNESS)

    @derived
    @answered("Nm_per_arcmin", "dT/dθ")
    def stiffness_min(self) -> float:
        """Least torsional stiffness over the turn."""
        return self._extreme("stiffness", STIFFNESS, -1)

    @derived
    def _loaded(self) -> tuple[int, int]:
        """Least and largest number of pairs that carry.

        Steps of the grid in which some pairs take up and others leave are halved until both are
        apart.
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
            between = turn.poses(middle.tolist(), play=False)
            carries = between["forces"] > 0
            felt = between["forces"] > FELT * between["error"][:, None]
            least = min(least, int(carries.sum(axis=1).min()))
            most = max(most, int(felt.sum(axis=1).max()))
            low, high = np.concatenate((low, middle)), np.concatenate((middle, high))
            here, there = np.concatenate((here, carries)), np.concatenate((carries, there))
        return least, most

    @property
    @answered()
    def loaded_pairs_min(self) -> int:
        """Least number of pairs with a force."""
        return self._loaded[0]

    @property
    @answered()
    def loaded_pairs_max(self) -> int:
        """Largest number of pairs with a force."""
        return self._loaded[1]

    @derived
    @answered("Nm", "", "T/u + (1 + 1/u)·ΣF·∂δ/∂ψ")
    def input_torque_ripple(self) -> float:
        """Ripple of the input torque without friction: largest less least torque that turns the
        crank.
        """
        return self._spread("input_torque", INPUT_TORQUE)

    @property
    def accuracy(self) -> Accuracy:
        """Accuracy of the peak force; an estimate, no proof.

        The error is the change by twice as many positions, the rise that a second look at other
        positions finds, and rounding.
        """
        return Accuracy("sampling_zoomed", self._peak.relative_error, self._peak.evaluations)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Notices on the mechanism, the contact and the accuracy."""
        own = self._of_output(pressed=self.pressed_without_load)
        return (*own, *poorly_known(self.accuracy))

    def _of_output(self, *, pressed: bool) -> tuple[Notice, ...]:
        """Notices on the output mechanism and its hardest contact."""
        return notices(
            real=self.real,
            lag=float(np.abs(self.turn.fine["lag"]).max()),
            pressed=pressed,
            contact=self.real.contact(*self.hardest) if self._wraps else self._contact,
        )


def over_turn(
    *, real: RealMechanism, output_torque: float, lost_motion_share: float = 0.03
) -> OverTurn:
    """Peak force, backlash, lost motion, transmission error and stiffness over the turn.

    The output torque, N*m, is not 0 and negative in reverse. The lost motion is taken under
    `lost_motion_share` of it, in (0, 1]. ImpossibleMechanism is raised if a position cannot be, see
    `Stage.solved`: on the even grid at once, between its places when a number is read.
    """
    return OverTurn.of(real, output_torque, lost_motion_share)
