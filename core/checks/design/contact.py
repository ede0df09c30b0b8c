"""Contact of pin and hole under the forces, at the end of its length where the pin slopes."""

import math
from functools import cached_property

from core.checks.design.pins import DesignPins
from core.checks.real_forces import RealForces
from core.hertz import HertzContact, hertz
from core.output.pin_strength import EdgeLoad, PinStresses

LOOKS, ALIKE = 50, 1e-6
"""Most looks for the largest line load under other forces, and how near to those of the last they
are where it does for them too."""


class DesignContact(DesignPins):
    """The contact with the largest pressure."""

    @cached_property
    def contact(self) -> HertzContact | None:
        """The contact with the largest pressure, where the forces are known: at the end of the
        length where the pin slopes.
        """
        if self.judged_forces is None:
            return None
        if self.pin is not None and not isinstance(self._pin_stresses, PinStresses):
            return None
        return self.contact_at(self.edge_factor(1.0))

    def edge_factor(self, factor: float) -> float:
        """Largest line load of a contact over the mean one of the largest force: where pins bend,
        by the worse of equal and stiffness sharing, and by their slope at that angle.

        Parameters
        ----------
        factor : float
            Factor on the forces and the slopes.

        Returns
        -------
        float
        """
        edge = self.edge if factor == 1 else self._edge(factor)
        judged = self.judged_forces
        if edge is None or judged is None:
            return 1.0
        if isinstance(judged, RealForces):
            return edge.force / (factor * judged.force)
        return edge.force / (factor * self.dynamic_factor * judged.peak_force)

    @cached_property
    def edge(self) -> EdgeLoad | None:
        """The contact with that line load; None without pins."""
        return self._edge(1.0)

    def _edge(self, factor: float) -> EdgeLoad | None:
        """The same under so many times the forces."""
        if not isinstance(self._pin_stresses, PinStresses):
            return None
        assert self.contact_length is not None
        return self._pin_stresses.edge_load(
            contact_length=self.contact_length, compliance=self._compliance, factor=factor
        )

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times its force."""
        force = self.judged_forces
        if isinstance(force, RealForces):
            return force.contact_at(factor)
        assert force is not None
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        pin, hole = self.lasting("pin"), self.lasting("hole")
        assert pin is not None and hole is not None
        return hertz(
            force=force.peak_force * factor,
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin_material=pin,
            hole_material=hole,
            dynamic_factor=self.dynamic_factor,
            distribution_factor=self.distribution_factor,
        )

    def torque_factor(self, factor: float) -> float:
        """Factor on the torque under which the largest line load is so many times as large."""
        force, on_force, edge = self.judged_forces, factor, self.edge
        if edge is not None and 0 < factor < math.inf:
            assert self.contact_length is not None
            wanted, on_force = factor * edge.force, 1.0
            for _ in range(LOOKS):
                growth = edge.growth_to(
                    wanted, contact_length=self.contact_length, compliance=self._compliance
                )
                on_force *= growth
                if abs(growth - 1) <= ALIKE:  # where it is largest hardly moves with the forces
                    break
                edge = self._edge(on_force)
                assert edge is not None
        return force.torque_factor(on_force) if isinstance(force, RealForces) else on_force

    @cached_property
    def peak(self) -> dict[str, float]:
        """Where the largest pressure is reached."""
        force = self.judged_forces
        if edge := self.edge:
            at: dict[str, float] = {"satellite": edge.satellite}
            if edge.pin is not None:
                at["pin"] = edge.pin
            known = isinstance(force, RealForces) and at.items() <= force.place.items()
            return force.place if known else at  # type: ignore[union-attr]
        if isinstance(force, RealForces):
            return force.place
        if force is None:
            return {}
        return {
            "satellite": force.peak_pair.satellite,
            "pin": force.peak_pair.pin,
            "crank_angle": force.peak_crank_angle,
        }
