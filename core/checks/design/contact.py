"""Contact of pin and hole under the forces, at the end of its length where the pin slopes."""

import math
from collections.abc import Callable
from functools import cached_property
from typing import get_args

import numpy as np

from core.checks.design.given import Body
from core.checks.design.pins import DesignPins
from core.checks.real_forces import RealForces
from core.derived import derived
from core.exploration.solve import edge
from core.hertz import HALF_WIDTH_RATIO_LIMIT, HertzContact, hertz
from core.materials import FIRST_YIELD
from core.output.edge_load import EdgeLoad, SlopingContacts
from core.output.moving_sharing import torque_factors
from core.results import ROUNDING

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength: the largest orthogonal shear, a
quarter of it, is the shear yield strength ``Re/sqrt(3)``."""


class DesignContact(DesignPins):
    """The contact with the largest pressure."""

    @derived
    def contact(self) -> HertzContact:
        """The contact with the largest pressure: at the end of the length where the pin slopes."""
        return self.contact_at(self.line_load_factor)

    @derived
    def line_load_factor(self) -> float:
        """Largest line load of a contact over the mean one of the largest force: where pins bend,
        by the worse of equal and stiffness sharing, and by their slope at that angle.
        """
        judged, edge = self.judged_forces, self.edge
        if edge is None:
            return 1.0
        if isinstance(judged, RealForces):
            return edge.force / judged.force
        return edge.force / (self.dynamic_factor * judged.peak_force)

    @derived
    def _sloping(self) -> SlopingContacts | None:
        """The contacts of pins that slope; None without pins."""
        if self.pin is None:
            return None
        stresses = self._pin_stresses
        assert self.contact_length is not None
        return SlopingContacts(stresses.pin, stresses.loads, self.contact_length, self.compliance)

    @derived
    def edge(self) -> EdgeLoad | None:
        """The contact with that line load; None without pins."""
        return None if self._sloping is None else self._sloping.largest()

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times its force."""
        force = self.judged_forces
        if isinstance(force, RealForces):
            return force.contact_at(factor)
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        pin, hole = self.lasting["pin"], self.lasting["hole"]
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

    @cached_property
    def pressure_limits(self) -> dict[str, float]:
        """Limits of the largest pressure, Pa, by the code of their check."""
        found: dict[str, float] = {}
        for body in get_args(Body):
            material = self.lasting[body]
            assert material is not None
            if material.limit is not None:
                allowed = float(material.limit.allowable) / self.pitting_safety
                found[f"contact_pressure_{body}"] = allowed
            if material.yield_governs and material.yield_strength is not None:
                found[f"contact_shakedown_{body}"] = SHAKEDOWN * material.yield_strength
                found[f"contact_yield_{body}"] = FIRST_YIELD * material.yield_strength
        return found

    @derived
    def contact_reserves(self) -> dict[str, float]:
        """Factors on the torque under which the contact is at its limits, by the code of their
        check, where its pressure is known.
        """
        contact = self.contact
        factors = {
            "contact_conformity": float(HALF_WIDTH_RATIO_LIMIT / contact.half_width_ratio) ** 2
        }
        if contact.governing_pressure is not None:
            largest = self.line_load_factor
            for code, limit in self.pressure_limits.items():
                factors[code] = force_factor(
                    contact=contact,
                    contact_at=lambda factor: self.contact_at(factor * largest),
                    limit=limit,
                )
        on_forces, forces = self._on_forces(list(factors.values())), self.judged_forces
        if isinstance(forces, RealForces):
            on_forces = [forces.torque_factor(factor) for factor in on_forces]
        return dict(zip(factors, on_forces, strict=True))

    def _on_forces(self, factors: list[float]) -> list[float]:
        """Factors on the torque, or on all real forces, under which the largest line load is so
        many times as large.
        """
        edge, contacts = self.edge, self._sloping
        if edge is None or contacts is None:
            return factors
        start = [
            contacts.growth(edge, factor) if 0 < factor < math.inf else factor for factor in factors
        ]  # where it is largest hardly moves with the forces
        found: list[float] = torque_factors(
            targets=np.array(factors),
            start=np.array(start),
            value=lambda each: contacts.under(factors=each, sharing=self.sharing),
        ).tolist()
        return found

    @derived
    def peak(self) -> dict[str, float]:
        """Where the largest pressure is reached."""
        force = self.judged_forces
        if edge := self.edge:
            at: dict[str, float] = {"satellite": edge.satellite}
            if edge.pin is not None:
                at["pin"] = edge.pin
            if isinstance(force, RealForces) and at.items() <= force.place.items():
                return force.place
            return at
        if isinstance(force, RealForces):
            return force.place
        return {
            "satellite": force.peak_pair.satellite,
            "pin": force.peak_pair.pin,
            "crank_angle": force.peak_crank_angle,
        }


def force_factor(
    *, contact: HertzContact, contact_at: Callable[[float], HertzContact], limit: float
) -> float:
    """Factor on the force at which the governing pressure of a contact is at a limit.

    Hertz's pressure grows with the root of the force, Persson's faster, up to the force itself;
    where Persson's takes over, the governing pressure jumps by a per cent.

    Parameters
    ----------
    contact : HertzContact
        The contact, of a known governing pressure.
    contact_at : callable
        The contact under so many times the force.
    limit : float
        The limit, Pa, > 0.

    Returns
    -------
    float
    """
    by_hertz = float((limit / contact.max_pressure) ** 2)
    if contact_at(by_hertz).conformal_pressure is None:
        # where no theory holds any more, that is the end
        return min(by_hertz, float(contact.half_width_ratio**-2))

    def left(factor: float) -> float:
        there = contact_at(factor).governing_pressure
        return math.nan if there is None else float(limit - there)

    assert contact.governing_pressure is not None
    ratio = float(limit / contact.governing_pressure)
    met, _ = edge(
        inside=0.97 * min(ratio, ratio * ratio),
        outside=1.03 * max(ratio, ratio * ratio),
        excess=left,
    )
    return met * (1 - 512 * ROUNDING)  # not beyond the jump by the rounding of forces
