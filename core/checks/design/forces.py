"""Forces of a reducer: of the ideal mechanism, or of the one that is made."""

from functools import cached_property

from core.checks.design.given import GivenDesign
from core.checks.real_forces import RealForces
from core.derived import derived
from core.errors import InvalidInput, NotKnown
from core.output.contact_force import ContactForce, contact_force
from core.output.contact_law import HertzLaw
from core.output.fit import Fit
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.real_turn import made
from core.output.sampled_turn import Made

MOST_REAL_PAIRS, MOST_GIVING_PAIRS = 100, 25
"""Most pairs of a mechanism whose real forces are solved: over the turn that takes seconds; of one
whose satellites give."""


class DesignForces(GivenDesign):
    """Where clearance, deviations or elasticity are stated, the forces that are judged are those of
    the mechanism as it is made; else those of the ideal one.
    """

    @derived
    def force(self) -> ContactForce:
        """The ideal contact force."""
        if self.output_torque is None or self.pin_circle_radius is None:
            raise NotKnown("section_missing", "load")
        return contact_force(
            mechanism=self.driven,
            output_torque=self.output_torque,
            pin_circle_radius=self.pin_circle_radius,
            force_exponent=self.force_exponent,
        )

    @cached_property
    def as_made(self) -> bool:
        """Whether clearance, deviations, a law of contact or satellites that give are stated.
        Bending pins alone leave the ideal forces.
        """
        stated = (self.law, self.deviations, self.support)
        return (self.clearance or 0.0) > 0 or any(each is not None for each in stated)

    @property
    def most_real_pairs(self) -> int:
        """Most pairs of which the forces of the mechanism as it is made are solved."""
        return MOST_REAL_PAIRS if self.support is None else MOST_GIVING_PAIRS

    @derived
    def real(self) -> RealMechanism:
        """The mechanism as it is made, of at most `most_real_pairs`."""
        if not (self.loaded and self.touching):
            raise NotKnown("section_missing", "contact" if self.loaded else "load")
        if self.pairs > self.most_real_pairs:
            raise self.too_many(self.most_real_pairs)
        assert self.pin_circle_radius is not None and self.contact_length is not None
        assert self.pin_radius is not None and self.hole_radius is not None
        eccentricity = self.eccentricity
        if eccentricity is None:
            eccentricity = self.hole_radius - self.pin_radius
        if eccentricity >= self.pin_circle_radius:  # holes around the centre
            than = {"field": "pin_circle_radius", "limit": self.pin_circle_radius}
            refusal = InvalidInput("eccentricity", None, "smaller_than", **than)
            raise NotKnown(refusal.code, refusal=refusal)
        return RealMechanism(
            mechanism=self.mechanism,
            pin_circle_radius=self.pin_circle_radius,
            pin_radius=self.pin_radius,
            eccentricity=eccentricity,
            contact_length=self.contact_length,
            law=self.law or HertzLaw(),
            clearance=self.clearance or 0.0,
            pin_material=self.lasting["pin"],
            hole_material=self.lasting["hole"],
            pin=self.pin if self.pin and self.pin.satellite_positions else None,
            deviations=self.deviations or Deviations(),
            exact=self.support is None,
            support=self.support,
        )

    @derived
    def fit(self) -> Fit:
        """How pins and holes fit."""
        return Fit(self.real)

    def real_forces_at(self, factor: float) -> RealForces:
        """Forces of the mechanism as it is made under so many times the torque.

        Parameters
        ----------
        factor : float
            Factor on the torque, > 0.

        Returns
        -------
        RealForces

        Raises
        ------
        ImpossibleMechanism
            See `core.output.real_mechanism.RealMechanism.solved`.
        """
        if self.fit.impossible:
            raise self.fit.refusal()
        assert self.output_torque is not None
        return RealForces.solved(
            real=self.real,
            torque=self.output_torque * factor,
            direction=self.torque_direction,
        )

    @derived
    def real_forces(self) -> RealForces:
        """Those forces under the torque."""
        return self.real_forces_at(1.0)

    @derived
    def loading(self) -> RealForces:
        """The same under the dynamic load: the forces that are judged."""
        if self.dynamic_factor == 1:
            return self.real_forces
        return self.real_forces_at(self.dynamic_factor)

    @derived
    def judged_forces(self) -> RealForces | ContactForce:
        """The forces that are judged."""
        return self.loading if self.as_made else self.force

    @derived
    def made(self) -> Made | None:
        """The forces of the mechanism as it is made under any torque; None where the ideal ones are
        judged.
        """
        return made(self.real) if self.as_made else None
