"""Pins of a reducer under its forces: how they share the load, and how strong they are."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from core.arrays import FloatArray, Number
from core.checks.design.forces import DesignForces
from core.checks.design.refusals import named
from core.derived import derived
from core.errors import InvalidInput, NotKnown
from core.output.contact_law import HertzLaw, contact_compliance
from core.output.moving_sharing import MovingSharing, torque_factors
from core.output.pin_beam import PinBeam
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, PinStresses, pin_stresses
from core.results import ROUNDING, Notice

MOST_PIN_PAIRS = 500
"""Most pairs of which the locus of a pin's moment is looked at."""

NEAR_CYCLE = 0.8
"""Part of the largest bending stress from which a cycle by the other sharing may be the worse one:
it may be reversed further. Such cycles of smaller ones, which are rare, are not followed."""

ALIKE = 64 * ROUNDING
"""Difference of stiffnesses that only rounding makes, as a part of them."""


class DesignPins(DesignForces):
    """Forces that bending pins share, and the strength of these."""

    @cached_property
    def compliance(self) -> Callable[[Number], Number]:
        """Approach of a contact over its force, m/N, of forces, N."""
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        if not self.hole_radius > self.pin_radius:
            than = {"field": "pin_radius", "limit": self.pin_radius}
            raise InvalidInput("hole_radius", self.hole_radius, "larger_than", **than)
        return contact_compliance(
            law=self.law or HertzLaw(),
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    @derived
    def pair_stiffness(self) -> tuple[float, ...] | None:
        """Stiffness of the pairs of each satellite, by which bending pins share an ideal load; None
        where all are alike.
        """
        return self._stiffness(self.dynamic_factor)

    @derived
    def static_stiffness(self) -> tuple[float, ...] | None:
        """The same under the torque of static strength."""
        if self.pair_stiffness is None or self.static_share == 1:
            return self.pair_stiffness
        return self._stiffness(self.dynamic_factor * self.static_share)

    def _stiffness(self, factor: float) -> tuple[float, ...] | None:
        """The same under so many times the torque."""
        pin = self.pin
        if pin is None or not self.touching or self.as_made:
            return None
        length = self.pin_length
        far = math.inf if pin.support == "cantilever" else (pin.span or 0.0)
        held = all(length / 2 <= z <= far - length / 2 for z in pin.satellite_positions)
        if not held or len(pin.satellite_positions) != self.satellites or self.satellites == 1:
            return None
        beam = PinBeam.round(
            support=pin.support,
            diameter=pin.diameter,
            contact_length=length,
            youngs_modulus=pin.material.youngs_modulus,
            poissons_ratio=pin.material.poissons_ratio,
            span=pin.span,
        )
        found = beam.pair_stiffness(
            positions=pin.satellite_positions,
            contact_compliance=float(self.compliance(self.force.peak_force * factor)),
        )
        return None if max(found) - min(found) <= ALIKE * max(found) else found

    @derived
    def sharing(self) -> MovingSharing | None:
        """How bending pins share an ideal load under other torques; None where that stays."""
        if self.pair_stiffness is None:
            return None
        return MovingSharing(
            stiffness=self.pair_stiffness,
            compliance=self.compliance,
            force=self.force.peak_force * self.dynamic_factor,
            mechanism=self.mechanism,
            force_exponent=self.force_exponent,
        )

    def reserve(self, growth: float, value: Callable[[FloatArray], FloatArray]) -> float:
        """Factor on the torque under which what grows with it is so many times as large.

        Parameters
        ----------
        growth : float
            How many times.
        value : callable
            What grows, of factors on the torque, where the sharing moves with it.

        Returns
        -------
        float
        """
        if self.sharing is None:
            return growth
        return float(torque_factors(targets=np.array([growth]), value=value)[0])

    @property
    def _forced(self) -> dict[str, Any]:
        """What the forces follow from, as arguments."""
        return {
            "mechanism": self.mechanism,
            "force_exponent": self.force_exponent,
            "output_torque": self.output_torque,
            "pin_circle_radius": self.pin_circle_radius,
            "torque_direction": self.torque_direction,
            "pair_stiffness": self.pair_stiffness,
            "made": self.made,
        }

    @property
    def _turning(self) -> dict[str, Any]:
        """The same, with what turns."""
        moving = {"eccentricity": self.eccentricity, "input_speed": self.input_speed}
        return self._forced | moving

    @cached_property
    def fatigue_strength(self) -> FatigueStrength | Notice | None:
        """What the fatigue of the pins is judged by; why it is not known; None without it."""
        if self.fatigue is None or self.pin is None:
            return None
        pin, basis = self.pin, self.fatigue
        if basis.criterion == "soderberg" and pin.material.yield_strength is None:
            return Notice("endurance_unknown")
        found = named(section="fatigue", calculation=lambda: basis.strength(pin))
        if isinstance(found, Notice) or not pin.steel or pin.rotates:  # then no cycles are counted
            return found
        return replace(
            found, cycles=self.loads_over(self.life if basis.life is None else basis.life)
        )

    @property
    def loaded_pins(self) -> dict[str, Any]:
        """The pins and what loads them, as arguments of `pin_stresses`."""
        pin = self.pin
        assert pin is not None
        return self._forced | {
            "application_factor": self.dynamic_factor,
            "peak_torque": self.static_torque,
            "static_stiffness": self.static_stiffness,
            "diameter": pin.diameter,
            "contact_length": self.pin_length,
            "satellite_positions": pin.satellite_positions,
            "material": pin.material,
            "support": pin.support,
            "span": pin.span,
        }

    @derived
    def _pin_stresses(self) -> PinStresses:
        """Stresses of the pins under the dynamic load, of at most `MOST_PIN_PAIRS`."""
        if self.pin is None:
            raise NotKnown("section_missing", "pin")
        if self.made is None and self.pairs > MOST_PIN_PAIRS:
            raise self.too_many(MOST_PIN_PAIRS)
        return named(section="pin", calculation=lambda: pin_stresses(**self.loaded_pins))

    def pin_reserve(
        self,
        growth: float,
        value: Callable[[PinStrength], float],
        *,
        near: float = 1.0,
        share: float = 1.0,
    ) -> float:
        """Factor on the torque under which a value of the pins is so many times as large.

        Parameters
        ----------
        growth : float
            How many times.
        value : callable
            What grows with the torque.
        near : float
            From which part of the stress by equal sharing that by stiffness may count.
        share : float
            Torque under which it is over the one with the factor.

        Returns
        -------
        float
        """
        if not 0 < growth < math.inf or not self._pins_move((share, growth * share), near):
            return growth

        def under(factor: float) -> float:
            torques = {"output_torque": self.output_torque, "peak_torque": self.peak_torque}
            more = {name: each and each * factor for name, each in torques.items()}
            return value((self if factor == 1 else replace(self, **more)).pin_strength)  # type: ignore[arg-type]

        return self.reserve(growth, lambda factors: np.array([*map(under, factors.tolist())]))

    def _pins_move(self, factors: tuple[float, ...], near: float) -> bool:
        """Whether stiffness sharing, as it is under so many times the torque, may load pins more
        than equal sharing, which does not move: by the force that each satellite may take more.
        """
        if self.sharing is None:
            return False
        stiff = self.sharing.under(np.array(factors))
        more = 1 + self.satellites * float((stiff.max(axis=1) / stiff.min(axis=1) - 1).max())
        one, other = self._pin_stresses.cases
        arms = np.abs(self._pin_stresses.pin.slopes)  # what cancels, cancels less with other shares
        return bool(
            more * other.bent >= near * one.bent
            or more * other.equivalent >= one.equivalent
            or more * other.deflections.max() >= one.deflections.max()
            or (other.slopes + (more - 1) * (arms @ other.forces)).max() >= one.slopes.max()
        )

    @derived
    def pin_loads(self) -> PinStrength:
        """Strength of the pins without their fatigue, with their deflection."""
        return self._pin_stresses.strength(deflection=True)

    @derived
    def pin_strength(self) -> PinStrength:
        """Strength of the pins under the dynamic load, its static safety under the peak torque."""
        return self.judged_pins()

    def judged_pins(self, *, locus: bool = False) -> PinStrength:
        """The same, at will with the locus of the moment."""
        judged, pin, found = self.fatigue_strength, self.pin, self.pin_loads
        if pin is not None and (locus or isinstance(judged, FatigueStrength)):
            found = self._pin_stresses.strength(
                rotates=pin.rotates,
                fatigue=judged if isinstance(judged, FatigueStrength) else None,
                input_speed=self.input_speed,
                deflection=True,
                locus=locus,
            )
        notices: tuple[Notice, ...] = (judged,) if isinstance(judged, Notice) else ()
        return replace(found, notices=notices + self.size_notices + found.notices)

    @property
    def size_notices(self) -> tuple[Notice, ...]:
        """Whether the pin is thicker than its material's strengths hold for."""
        valid = None if self.pin is None else self.pin.valid_diameter
        if self.pin is None or valid is None or self.pin.diameter <= valid:
            return ()
        return (Notice("beyond_size", {"limit": valid * 1e3}),)
