"""Friction and wear of the pins under the forces.

Of bending pins the largest force, and pv and wear by it, are those of the worse of equal and
stiffness sharing, as of the pins themselves; the means, loss and efficiency are those of equal
sharing.
"""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.checks.design.contact import DesignContact
from core.checks.design.refusals import named
from core.checks.sections import Friction
from core.derived import derived
from core.errors import NotKnown
from core.output.losses import LossCurves, PinLosses, loss_curves, pin_losses
from core.output.moving_sharing import shared_largest
from core.output.sampled_turn import WAYS, SampledTurn
from core.results import Accuracy, Notice


class DesignLosses(DesignContact):
    """Losses of ideal forces, or of those of the mechanism as it is made."""

    @derived
    def losses(self) -> PinLosses:
        """Friction and wear of the pins under the torque; of bending pins, of so many pairs as of
        the pins themselves.
        """
        friction = self.friction
        if friction is None:
            raise NotKnown("section_missing", "friction")
        inside = self.pin.diameter if friction.sleeve and self.pin else None
        life = self.life if friction.life is None else friction.life
        return named(section="pin", calculation=lambda: self._losses(friction, inside, life))

    def _losses(self, friction: Friction, inside: float | None, life: float) -> PinLosses:
        """Losses of the ideal forces, or of those of the mechanism as it is made."""
        eccentricity, speed, turn = self.known_eccentricity, self.known_speed, self.lossy_turn
        loads = self.pin_loads if self.pair_stiffness else None
        assert self.output_torque is not None and self.pin_circle_radius is not None
        found = pin_losses(
            mechanism=self.driven,
            force_exponent=self.force_exponent,
            output_torque=self.output_torque,
            pin_circle_radius=self.pin_circle_radius,
            input_speed=speed,
            eccentricity=eccentricity,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            contact_length=self.contact_length,
            friction_coefficient=friction.coefficient,
            diameter=inside,
            wear_rate=friction.wear_rate,
            life=None if friction.wear_rate is None else life,
        )
        bare = self.sleeved and not friction.sleeve
        if bare and self.pin is not None and self.pin.diameter < 2 * (self.pin_radius or 0.0):
            found = replace(found, notices=(*found.notices, Notice("thin_without_sleeve")))
        if turn is not None:
            reference = self.output_torque / self.pin_circle_radius
            largest = max(float(np.abs(turn.on_pins).max()) for turn in self._lossy_turns)
            return made_losses(losses=found, turn=turn, reference=reference, largest=largest)
        if loads is None:
            return found
        peak = loads.peak_force / (self.dynamic_factor * float(found.peak_force))
        return peaking(losses=found, peak=peak, error=loads.accuracy.relative_error)

    def moved_peak(self, factors: FloatArray) -> FloatArray:
        """Largest force under so many times the torque over F0, where the sharing moves with it."""
        sharing = self.sharing
        assert sharing is not None
        _, forces = np.split(np.eye(2 * self.satellites), 2)

        def peaks(stiffness: FloatArray) -> FloatArray:
            return shared_largest(
                turn=sharing.pin_turn, sharing=stiffness, arms=(forces,), measure=np.abs
            )

        return np.asarray(sharing.worse(factors=factors, of=peaks).max(axis=1))

    @derived
    def _lossy_turns(self) -> list[SampledTurn]:
        """Forces of the mechanism as it is made, in each direction of the torque; none where the
        ideal ones are judged.
        """
        if self.made is None:
            return []
        assert self.output_torque is not None
        return [self.made(way * self.output_torque) for way in WAYS[self.torque_direction]]

    @derived
    def lossy_turn(self) -> SampledTurn | None:
        """Of these the ones with the larger losses."""
        return max(self._lossy_turns, key=lambda turn: float(turn.mean(turn.total)), default=None)

    def loss_curves(self, losses: PinLosses, crank_angle: FloatArray) -> LossCurves:
        """Loss and efficiency at crank angles.

        Parameters
        ----------
        losses : PinLosses
            Those of this design.
        crank_angle : array, shape (n,)
            Crank angles, rad.

        Returns
        -------
        LossCurves
        """
        turn, mechanism = self.lossy_turn, self.driven
        if turn is None:
            return loss_curves(
                losses=losses,
                mechanism=mechanism,
                force_exponent=self.force_exponent,
                crank_angle=crank_angle,
            )
        wave = self.mechanism.wave_angle(crank_angle)
        loss = (
            losses.mean_loss
            * turn.at(wave=wave, values=turn.total[None])[0]
            / turn.mean(turn.total)
        )
        return LossCurves(crank_angle, loss, 1 / (1 + loss / losses.output_power))


def peaking(*, losses: PinLosses, peak: float, error: float) -> PinLosses:
    """Losses whose largest force is so many times as large, and pv and wear with it.

    Parameters
    ----------
    losses : PinLosses
        The losses.
    peak : float
        Largest force over that of the losses.
    error : float
        Relative error of the forces.

    Returns
    -------
    PinLosses
    """
    pin, hole = (
        None if each is None else each * peak for each in (losses.pin_wear, losses.hole_wear)
    )
    return replace(
        losses,
        peak_force=losses.peak_force * peak,
        peak_pv=losses.peak_pv * peak,
        pin_wear=pin,
        hole_wear=hole,
        accuracy=losses.accuracy._replace(relative_error=error + losses.accuracy.relative_error),
    )


def made_losses(
    *, losses: PinLosses, turn: SampledTurn, reference: float, largest: float
) -> PinLosses:
    """Losses of a mechanism as it is made, by the sum of its forces.

    Parameters
    ----------
    losses : PinLosses
        Those of the ideal forces.
    turn : SampledTurn
        Forces under the torque.
    reference : float
        ``F0 = T/R``, N.
    largest : float
        Largest force of a contact in any direction of the torque, N.

    Returns
    -------
    PinLosses
    """
    total = turn.total / reference
    mean, least, most = float(turn.mean(total)), float(total.min()), float(total.max())
    peak = largest / float(losses.peak_force)
    part = mean / float(losses.mean_total_force_ratio)
    share = (1 / float(losses.efficiency) - 1) / float(losses.mean_total_force_ratio)
    peaks = peaking(losses=losses, peak=peak, error=turn.error)
    error = peaks.accuracy.relative_error
    return replace(
        peaks,
        mean_total_force_ratio=mean,
        mean_loss=losses.mean_loss * part,
        efficiency=1 / (1 + share * mean),
        min_efficiency=1 / (1 + share * most),
        max_efficiency=1 / (1 + share * least),
        mean_pv=losses.mean_pv * part,
        friction_couple=losses.friction_couple * part,
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )
