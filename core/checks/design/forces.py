"""Forces of a reducer: of the ideal mechanism, or of the one that is made."""

from functools import cached_property

from core.checks.design.given import GivenDesign
from core.checks.real_forces import RealForces
from core.errors import ImpossibleMechanism
from core.output.contact_force import ContactForce, contact_force
from core.output.contact_law import HertzLaw
from core.output.fit import Fit
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.real_turn import made
from core.output.sampled_turn import Made

MOST_REAL_PAIRS, MOST_GIVING_PAIRS = 100, 25
"""Most pairs of a mechanism whose real forces are solved: over the turn that takes seconds; of one
whose satellites give."""

UNSOLVED = {
    "cannot_assemble": "cannot_assemble",
    "dead_centre": "dead_centre",
    "beyond_hertz": "no_pressure",
}
"""Why forces are not known, as the reason of a check, where there is one of its own."""

Forces = RealForces | ContactForce | ImpossibleMechanism | None
"""Forces, or why there are none; None where they are not asked, or of too many pairs."""


class DesignForces(GivenDesign):
    """Where clearance, deviations or elasticity are stated, the forces that are judged are those of
    the mechanism as it is made; else those of the ideal one.
    """

    @cached_property
    def force(self) -> ContactForce | ImpossibleMechanism | None:
        """The ideal contact force; why there is none at a dead centre; None without a load."""
        if self.output_torque is None or self.pin_circle_radius is None:
            return None
        try:
            return contact_force(
                mechanism=self.driven,
                output_torque=self.output_torque,
                pin_circle_radius=self.pin_circle_radius,
                force_exponent=self.force_exponent,
            )
        except ImpossibleMechanism as refusal:
            return refusal

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

    @cached_property
    def real(self) -> RealMechanism | None:
        """The mechanism as it is made; None where too little of it is given, or the forces cannot
        be solved: of more than `most_real_pairs`, or of holes around the centre.
        """
        if not (self.loaded and self.touching) or self.pairs > self.most_real_pairs:
            return None
        assert self.pin_circle_radius is not None and self.contact_length is not None
        assert self.pin_radius is not None and self.hole_radius is not None
        eccentricity = self.eccentricity
        if eccentricity is None:
            eccentricity = self.hole_radius - self.pin_radius
        if eccentricity >= self.pin_circle_radius:
            return None
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

    @cached_property
    def fit(self) -> Fit | None:
        """How pins and holes fit; None where too little of them is given, or they are so many."""
        return None if self.real is None else Fit(self.real)

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
        assert self.real is not None and self.output_torque is not None and self.fit is not None
        if self.fit.impossible:
            raise self.fit.refusal()
        return RealForces.solved(
            real=self.real,
            torque=self.output_torque * factor,
            direction=self.torque_direction,
        )

    @cached_property
    def real_forces(self) -> RealForces | ImpossibleMechanism | None:
        """Those forces under the torque; why there are none; None where the mechanism is not known
        or has too many pairs.
        """
        if self.real is None:
            return None
        try:
            return self.real_forces_at(1.0)
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def loading(self) -> RealForces | ImpossibleMechanism | None:
        """The same under the dynamic load: the forces that are judged."""
        if self.real is None or self.dynamic_factor == 1:
            return self.real_forces
        try:
            return self.real_forces_at(self.dynamic_factor)
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def judged_forces(self) -> RealForces | ContactForce | None:
        """The forces that are judged, where they are known."""
        force = self.loading if self.as_made else self.force
        return None if isinstance(force, ImpossibleMechanism) else force

    @cached_property
    def made(self) -> Made | None:
        """The forces of the mechanism as it is made under any torque, where they are judged."""
        return made(self.real) if self.as_made and self.real is not None else None

    @property
    def unmade(self) -> bool:
        """Whether the forces of the mechanism as it is made are wanted and cannot be solved."""
        return self.as_made and self.real is None

    def why_unknown(self, forces: Forces) -> str:
        """Why forces are not known, as the reason of a check.

        Parameters
        ----------
        forces : ImpossibleMechanism or None
            What there is instead of them.

        Returns
        -------
        str
        """
        if isinstance(forces, ImpossibleMechanism):
            return UNSOLVED.get(forces.code, "no_balance")
        many = self.pairs > self.most_real_pairs
        return "too_many_pairs" if many else "no_balance"

    @property
    def unsolved(self) -> str:
        """Why the forces that are judged are not known."""
        if self.judged_forces is not None:
            return "too_large"  # for what bends
        return self.why_unknown(self.loading if self.as_made else self.force)

    def unturned(self, found: object, *, speed: bool = True) -> tuple[str, tuple[str, ...]]:
        """Why what turns is not known, as the reason of a check, and which inputs are missing;
        `speed` whether it needs one.
        """
        if isinstance(found, ImpossibleMechanism):
            return self.why_unknown(found), ()
        if self.eccentricity is None:
            return "eccentricity_missing", ("eccentricity",)
        if speed and self.input_speed is None:
            return "speed_missing", ("input_speed",)
        return (self.why_unknown(None) if self.unmade else "too_large"), ()
