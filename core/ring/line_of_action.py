"""Line of action of an involute planet in its ring: the tangent to both base circles.

The line depends on numbers of teeth, base circles and eccentricity only; tips are given as radii. A
place on the line is given by the roll angle tau of the planet: the tangent of the pressure angle
there, which is the distance from the planet's base point over the base radius. Arrays have any
axes.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.arrays import Number
from core.crank.ring_mesh import involute_mesh


def involute(angle: Number) -> Number:
    """Involute function ``tan(angle) - angle`` of a pressure angle, rad.

    >>> round(float(involute(math.radians(20))), 9)
    0.014904384
    """
    return np.tan(angle) - angle


class TipCrossing(NamedTuple):
    """Passage of the teeth where the tip circles cross, beside the path of contact."""

    # G, rad times teeth: gap between the tips over the ring's angular pitch, times 2*pi; NaN if the
    # tip circles do not cross.
    interference: Number
    overlap: Number  # true if the planet's tip circle encloses the ring's, so no tooth can pass


@dataclass(frozen=True)
class LineOfAction:
    """Line of action of a planet in a ring, and the ends that tips give it."""

    satellite_teeth: int  # z_s
    ring_teeth: int  # z_r > z_s
    module: float  # m, m
    pressure_angle: float  # alpha of the rack, rad
    eccentricity: float  # e, m
    angle: float  # alpha_w, operating pressure angle, rad
    error: float  # relative rounding error of alpha_w

    @classmethod
    def of(
        cls,
        *,
        satellite_teeth: int,
        ring_teeth: int,
        module: float,
        pressure_angle: float,
        eccentricity: float,
    ) -> "LineOfAction":
        """Line of action at an eccentricity; InvalidInput if base circles leave no room for it."""
        mesh = involute_mesh(
            module=module,
            teeth_difference=ring_teeth - satellite_teeth,
            pressure_angle=pressure_angle,
            eccentricity=eccentricity,
        )
        angle = mesh.operating_pressure_angle
        return cls(
            satellite_teeth, ring_teeth, module, pressure_angle, eccentricity, angle, mesh.error
        )

    @property
    def difference(self) -> int:
        """Number of teeth of the ring less that of the planet."""
        return self.ring_teeth - self.satellite_teeth

    @cached_property
    def satellite_base(self) -> float:
        """Base radius r_bs of the planet, m."""
        return self.module * self.satellite_teeth * math.cos(self.pressure_angle) / 2

    @cached_property
    def ring_base(self) -> float:
        """Base radius r_br of the ring, m."""
        return self.module * self.ring_teeth * math.cos(self.pressure_angle) / 2

    @cached_property
    def pitch_roll(self) -> float:
        """Roll angle of the pitch point, ``tan(alpha_w)``."""
        return math.tan(self.angle)

    @property
    def base_distance(self) -> float:
        """Distance of the base points of both circles along the line, ``e*sin(alpha_w)``, m."""
        return self.eccentricity * math.sin(self.angle)

    @property
    def wider(self) -> float:
        """Difference ``x_r - x_s`` of the profile shifts without backlash."""
        turned = float(involute(self.angle) - involute(self.pressure_angle))
        return self.difference * turned / (2 * math.tan(self.pressure_angle))

    def end_roll(self, satellite_tip: Number) -> Number:
        """Roll angle at the path's end from the planet's tip radius, m; NaN if below the base."""
        return roll(satellite_tip, base=self.satellite_base)

    def start_roll(self, ring_tip: Number) -> Number:
        """Roll angle at the start of the path from the ring's tip radius, m; NaN within the base
        circle. ``tan(alpha_1) = (z_r*tan(alpha_ar) - dz*tan(alpha_w))/z_s``.
        """
        at_tip = roll(ring_tip, base=self.ring_base)
        reached = self.ring_teeth * at_tip - self.difference * self.pitch_roll
        return reached / self.satellite_teeth

    def on_ring(self, satellite_roll: Number) -> Number:
        """Roll angle of the ring at the place where the planet has a roll angle."""
        whole = self.satellite_teeth * satellite_roll + self.difference * self.pitch_roll
        return whole / self.ring_teeth

    def contact_ratio(self, *, start: Number, end: Number) -> Number:
        """Contact ratio from the roll angles at start and end of the path."""
        return self.satellite_teeth * (end - start) / (2 * math.pi)

    def reduced_radius(self, satellite_roll: Number) -> Number:
        """Reduced radius of curvature at a roll angle, ``rho_1*rho_2/(rho_2 - rho_1)``, m."""
        convex = self.satellite_base * satellite_roll
        return convex * (1 + convex / self.base_distance)

    def crossing(self, *, satellite_tip: Number, ring_tip: Number) -> TipCrossing:
        """Passage of the tips where the tip circles with the radii r_as, r_ar (m) cross.

        ``G = z_s*(inv(alpha_as) + delta_s) - z_r*(inv(alpha_ar) + delta_r) + dz*inv(alpha_w)`` has
        to be at least 0; ``cos(delta_s) = (r_ar^2 - r_as^2 - e^2)/(2*r_as*e)``,
        ``cos(delta_r) = (r_ar^2 - r_as^2 + e^2)/(2*r_ar*e)``. G is for the flank in contact; the
        other flank has the backlash besides. An arccosine without a value is no absence of
        interference: if one tip circle encloses the other, no tooth can pass.
        """
        e, satellite, ring = self.eccentricity, satellite_tip, ring_tip
        with np.errstate(invalid="ignore"):
            apart = (ring - satellite) * (ring + satellite)
            on_satellite = np.arccos((apart - e * e) / (2 * satellite * e))
            on_ring = np.arccos((apart + e * e) / (2 * ring * e))
            beside = np.isnan(on_satellite) | np.isnan(on_ring)
            turned = self.satellite_teeth * (_tip(satellite, self.satellite_base) + on_satellite)
            turned = turned - self.ring_teeth * (_tip(ring, self.ring_base) + on_ring)
        gap = turned + self.difference * involute(self.angle)
        return TipCrossing(gap, beside & (satellite > ring))


def roll(radius: Number, *, base: float) -> Number:
    """Roll angle of an involute at a radius: tangent of the pressure angle, NaN below the base."""
    with np.errstate(invalid="ignore"):
        return np.sqrt((radius - base) * (radius + base)) / base


def radius_at(roll_angle: Number, *, base: float) -> Number:
    """Radius at which an involute has a roll angle, m."""
    return base * np.hypot(1, roll_angle)


def _tip(radius: Number, base: float) -> Number:
    """Involute function of the pressure angle at a radius."""
    tangent = roll(radius, base=base)
    return tangent - np.arctan(tangent)
