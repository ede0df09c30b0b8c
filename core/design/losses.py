"""Results about friction and wear of the output pins."""

from dataclasses import replace

import numpy as np

from core.design.output_forces import OutputForces
from core.design.refusals import named
from core.design.ring_results import RingResults
from core.errors import Accuracy, Notice, NotKnown, derived
from core.output.losses import BarePins, PinLosses, Sleeves, pin_losses
from core.output.sampled_turn import SampledTurn


def made_losses(
    *, losses: PinLosses, turn: SampledTurn, reference: float, largest: float
) -> PinLosses:
    """Losses of solved forces, scaled from losses of the ideal forces by the sum of the forces.

    `reference` is ``F0 = T/R``, N; `largest` the largest contact force in any direction, N.
    """
    total = turn.total / reference
    mean, least, most = float(turn.mean(total)), float(total.min()), float(total.max())
    peak = largest / float(losses.peak_force)
    part = mean / float(losses.mean_total_force_ratio)
    share = (1 / float(losses.efficiency) - 1) / float(losses.mean_total_force_ratio)
    error = turn.error + losses.accuracy.relative_error
    return replace(
        losses,
        peak_force=losses.peak_force * peak,
        peak_pv=losses.peak_pv * peak,
        mean_total_force_ratio=mean,
        mean_loss=losses.mean_loss * part,
        efficiency=1 / (1 + share * mean),
        min_efficiency=1 / (1 + share * most),
        max_efficiency=1 / (1 + share * least),
        mean_pv=losses.mean_pv * part,
        friction_couple=losses.friction_couple * part,
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )


class LossResults:
    """Results of a design about friction of its pins in SI units."""

    def __init__(self, output: OutputForces, ring: RingResults) -> None:
        self.design, self.output, self.ring = output.design, output, ring

    @derived
    def pins(self) -> PinLosses:
        """Friction and wear of the pins under the working torque, by the judged forces."""
        if not self.design.rubs:
            raise NotKnown("section_missing", "friction")
        return named(self.design, "pin", self._of_pins)

    @property
    def total_efficiency(self) -> float:
        """Efficiency of the output, and of the ring too if friction on its pins is given."""
        output, gear = float(self.pins.efficiency), self.design.gear
        if not gear or gear.friction_coefficient is None:
            return output
        lost, power = self.ring.loss.mean_loss, self.output.member_loads.output_power
        return output / (1 + output * lost / power)

    @property
    def input_torque(self) -> float | None:
        """Torque at the input that the output torque needs with these losses, N*m; None if ring and
        pins are both outputs.
        """
        design = self.design
        if design.members.output_ratio is None:
            return None
        return design.output_torque / (design.members.torque_ratio * self.total_efficiency)

    @property
    def _rubbing(self) -> BarePins | Sleeves:
        """Sliding surfaces: rollers or sleeves on their pins, or pins in their holes."""
        design = self.design
        if design.rollers:
            return Sleeves(design.rollers.bore_diameter)
        if design.friction.sleeve and design.pin:
            return Sleeves(design.pin.diameter)
        return BarePins(design.contact.hole_radius)

    def _of_pins(self) -> PinLosses:
        design, friction = self.design, self.design.output_friction
        eccentricity, turns = design.known_eccentricity, self._turns
        speeds = design.known_speeds
        found = pin_losses(
            load=replace(self.output.pin_load, mechanism=design.driven),
            input_speed=speeds.turning,
            output_power=self.output.member_loads.output_power,
            eccentricity=eccentricity,
            pin_radius=design.contact.pin_radius,
            contact_length=design.contact.contact_length,
            friction_coefficient=friction.coefficient,
            distribution_factor=design.distribution_factor,
            rubbing=self._rubbing,
            wear_rate=friction.wear_rate,
            life=design.life_of(friction),
        )
        bare = design.sleeved and not friction.sleeve
        if bare and design.pin.diameter < 2 * design.nominal_pair.pin_radius:
            found = replace(found, notices=(*found.notices, Notice("thin_without_sleeve")))
        if not turns:
            return found
        reference = design.pin_torque / design.pin_circle_radius
        largest = max(float(np.abs(turn.on_pins).max()) for turn in turns)
        return made_losses(losses=found, turn=self.turn, reference=reference, largest=largest)

    @derived
    def _turns(self) -> list[SampledTurn]:
        """Solved forces in each direction of the torque; empty if ideal forces are judged."""
        if not self.output.solved:
            return []
        return self.output.pin_load.turns(self.design.pin_torque)

    @derived
    def turn(self) -> SampledTurn:
        """Solved forces in the direction with the larger losses."""
        return max(self._turns, key=lambda turn: float(turn.mean(turn.total)))
