"""Where involute teeth of satellite and ring touch: on the line that touches both base circles.

All of it hangs on the numbers of teeth, the base circles and the eccentricity alone; tips come as
radii. A place on the line has a roll angle tau of the satellite: the tangent of the pressure angle
there, the distance from the satellite's base point over its base radius. Arrays may have any axes.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.arrays import Number
from core.crank.ring_mesh import involute_mesh


def involute(angle: Number) -> Number:
    """The involute function ``tan(angle) - angle``.

    Parameters
    ----------
    angle : float or array
        Pressure angle, rad.

    Returns
    -------
    float or array
        rad.

    Examples
    --------
    >>> round(float(involute(math.radians(20))), 9)
    0.014904384
    """
    return np.tan(angle) - angle


class TipCrossing(NamedTuple):
    """How teeth pass where the tip circles cross, beside the path of contact."""

    # G, rad times teeth: the gap there over the ring's angular pitch, times 2*pi; NaN where the
    # circles do not cross.
    interference: Number
    overlap: Number  # whether the satellite's circle has the ring's in it: no tooth can pass


@dataclass(frozen=True)
class LineOfAction:
    """The line of action of a satellite in a ring, and what tips make of it."""

    satellite_teeth: int  # z_s
    ring_teeth: int  # z_r, more
    module: float  # m, m
    pressure_angle: float  # alpha of the rack, rad
    eccentricity: float  # e, m
    angle: float  # alpha_w, operating pressure angle, rad
    error: float  # relative, of that by rounding

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
        """The line of action at an eccentricity.

        Parameters
        ----------
        satellite_teeth, ring_teeth : int
            Teeth z_s and z_r > z_s.
        module : float
            Module m, m.
        pressure_angle : float
            Reference pressure angle alpha, rad.
        eccentricity : float
            Eccentricity e, m.

        Returns
        -------
        LineOfAction

        Raises
        ------
        InvalidInput
            If the base circles do not leave room for the eccentricity.
        """
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
        """Teeth of the ring less those of the satellite."""
        return self.ring_teeth - self.satellite_teeth

    @cached_property
    def satellite_base(self) -> float:
        """r_bs, m."""
        return self.module * self.satellite_teeth * math.cos(self.pressure_angle) / 2

    @cached_property
    def ring_base(self) -> float:
        """r_br, m."""
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
        """By how much the ring's profile shift is larger than the satellite's without backlash."""
        turned = float(involute(self.angle) - involute(self.pressure_angle))
        return self.difference * turned / (2 * math.tan(self.pressure_angle))

    def end_roll(self, satellite_tip: Number) -> Number:
        """Roll angle at the end of the path, where the satellite's tip leaves the line.

        Parameters
        ----------
        satellite_tip : float or array
            Tip radius r_as, m; NaN within the base circle.

        Returns
        -------
        float or array
        """
        return roll(satellite_tip, base=self.satellite_base)

    def start_roll(self, ring_tip: Number) -> Number:
        """Roll angle at the start of the path, where the ring's tip comes to the line.

        ``tan(alpha_1) = (z_r*tan(alpha_ar) - dz*tan(alpha_w))/z_s``.

        Parameters
        ----------
        ring_tip : float or array
            Tip radius r_ar, m; NaN within the base circle.

        Returns
        -------
        float or array
        """
        at_tip = roll(ring_tip, base=self.ring_base)
        reached = self.ring_teeth * at_tip - self.difference * self.pitch_roll
        return reached / self.satellite_teeth

    def on_ring(self, satellite_roll: Number) -> Number:
        """Roll angle of the ring where the satellite has another.

        Parameters
        ----------
        satellite_roll : float or array
            That of the satellite.

        Returns
        -------
        float or array
        """
        whole = self.satellite_teeth * satellite_roll + self.difference * self.pitch_roll
        return whole / self.ring_teeth

    def contact_ratio(self, *, start: Number, end: Number) -> Number:
        """Length of the path over the base pitch.

        Parameters
        ----------
        start, end : float or array
            Roll angles of its ends.

        Returns
        -------
        float or array
        """
        return self.satellite_teeth * (end - start) / (2 * math.pi)

    def reduced_radius(self, satellite_roll: Number) -> Number:
        """Radius of curvature of the gap between the flanks, ``rho_1*rho_2/(rho_2 - rho_1)``.

        Parameters
        ----------
        satellite_roll : float or array
            Where on the line.

        Returns
        -------
        float or array
            m.
        """
        convex = self.satellite_base * satellite_roll
        return convex * (1 + convex / self.base_distance)

    def crossing(self, *, satellite_tip: Number, ring_tip: Number) -> TipCrossing:
        """Whether tips pass each other where the tip circles cross, beside the path of contact.

        ``G = z_s*(inv(alpha_as) + delta_s) - z_r*(inv(alpha_ar) + delta_r) + dz*inv(alpha_w)``, at
        least 0, ``cos(delta_s) = (r_ar^2 - r_as^2 - e^2)/(2*r_as*e)``,
        ``cos(delta_r) = (r_ar^2 - r_as^2 + e^2)/(2*r_ar*e)``, for the flank in contact: the other
        one has the backlash besides.

        Parameters
        ----------
        satellite_tip, ring_tip : float or array
            Tip radii r_as, r_ar, m.

        Returns
        -------
        TipCrossing

        Notes
        -----
        The arccosine has no value where the tips overlap all round: that is no room, though a
        formula that takes it for none of the interference would pass.
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
    """Roll angle of an involute at a radius, the tangent of its pressure angle there.

    Parameters
    ----------
    radius : float or array
        The radius, m; NaN within the base circle.
    base : float
        Radius of the base circle, m.

    Returns
    -------
    float or array
    """
    with np.errstate(invalid="ignore"):
        return np.sqrt((radius - base) * (radius + base)) / base


def radius_at(roll_angle: Number, *, base: float) -> Number:
    """Radius at which an involute has a roll angle.

    Parameters
    ----------
    roll_angle : float or array
        The roll angle.
    base : float
        Radius of the base circle, m.

    Returns
    -------
    float or array
        m.
    """
    return base * np.hypot(1, roll_angle)


def _tip(radius: Number, base: float) -> Number:
    """Involute function at a radius."""
    tangent = roll(radius, base=base)
    return tangent - np.arctan(tangent)
