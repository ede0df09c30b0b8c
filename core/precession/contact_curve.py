"""Curve of all contact points of one roller, and quadrature along it.

In the plane of ``y = z + A*cos(phi1)`` and ``w = A*sin(phi1)`` the point (y, w) lies from the
origin at the distance ``D = hypot(y, w)``, in the direction of the contact point turned by phi1:
``cot(phi + phi1) = y/w`` and ``sin(phi) = -z*sin(phi1)/D``. The curve thus has no pole in z, the
slope of the unrolled curve is ``rho*dphi/dz = -rho*w/D^2``, and the length

    s = integral sqrt(1 + (rho*w/(y^2 + w^2))^2) dy

is integrated on panels graded to the nearest singularities, which are known: ``y = +-i*w`` and
``y^2 = -w^2 +- i*rho*w``; for loads also z = 0, where the arm about the axis is zero.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, check_finite, check_positive
from core.errors import ImpossibleMechanism, InvalidInput
from core.numerics.quadrature import NODES, WEIGHTS, resolves_complex_poles, resolves_real_pole
from core.precision import ROUNDING


class LinePoint(NamedTuple):
    """End of a contact line."""

    y: float  # from the steepest point of the curve, m
    z: float  # from the precession centre, m
    error: float  # bound of the error of z on the curve as given, m


class Limits(NamedTuple):
    """Ends of a contact line."""

    start: LinePoint  # end with the smaller z
    end: LinePoint  # end with the larger z
    extent: float  # z_max - z_min, m, to more digits than the difference has
    # True if the limits are given in phi, so that all nodes move with the error of the curve; else
    # the nodes keep their z.
    in_phi: bool


@dataclass(frozen=True, slots=True)
class Places:
    """Nodes along a contact line: ``sum g*ds`` is the integral of a smooth g along it.

    The first and the last node are the ends, with ds = 0; their ds_error is the length by which an
    end may move. The error of an integral is ``sum |g|*ds_error`` plus the error of g.
    """

    y: FloatArray  # from the steepest point of the curve, m, shape (n,)
    z: FloatArray  # from the precession centre, m, shape (n,)
    ds: FloatArray  # length of the line that a place stands for, m, shape (n,)
    ds_error: FloatArray  # bound of its error, m, shape (n,)
    z_error: FloatArray  # error of z along the curve, m, shape (n,)
    direction_error: FloatArray  # relative error of the vector (y, w)/sin(phi1), shape (n,)


@dataclass(frozen=True, slots=True)
class ContactCurve:
    """Curve of all contact points of one roller."""

    roller_circle_radius: float  # R_C, m
    roller_radius: float  # rho, m
    position_angle: float  # phi1, rad
    angle_error: float  # bound of the error of phi1, rad
    scale: float  # A = R_C*(cos(theta) - u12)/sin(theta), m
    scale_error: float  # relative error of A, the condition of the input included

    @property
    def sine(self) -> float:
        """sin(phi1)."""
        return math.sin(self.position_angle)

    @property
    def sine_error(self) -> float:
        """Relative error of `sine`."""
        return ROUNDING + self.angle_error / abs(math.tan(self.position_angle))

    @property
    def offset(self) -> float:
        """``A*cos(phi1)`` = y - z, m."""
        return self.scale * math.cos(self.position_angle)

    @property
    def width(self) -> float:
        """``w = A*sin(phi1)``, m, with its sign: half the width of the steep part of the line."""
        return self.scale * math.sin(self.position_angle)

    @property
    def width_error(self) -> float:
        """Relative error of `width`."""
        return self.scale_error + self.sine_error + 2 * ROUNDING

    @property
    def point_error(self) -> float:
        """Error of the point (y, w) at a given z, m."""
        return abs(self.scale) * (self.scale_error + self.angle_error + 2 * ROUNDING)

    def slope(self, y: FloatArray) -> FloatArray:
        """Slope ``|rho*dphi/dz|`` of the unrolled line at y."""
        width = abs(self.width)
        return (self.roller_radius / width) / (1 + (y / width) ** 2)

    def polar_angle(self, z: FloatArray) -> FloatArray:
        """Polar angle phi at z, rad, continuous along the line."""
        angle = math.remainder(self.position_angle, 2 * math.pi)
        principal: FloatArray = np.arctan2(-z * math.sin(angle), self.scale + z * math.cos(angle))
        continuous = np.arctan2(self.width, z + self.offset) - angle
        return principal + 2 * np.pi * np.rint((continuous - principal) / (2 * np.pi))

    def places(self, limits: Limits, *, loaded: bool = False) -> Places:
        """Nodes of quadrature along a line; `loaded` grades them to the pole at z = 0 too."""
        y, z, dz = self._nodes(limits, loaded)
        ds = dz * np.hypot(1.0, self.slope(y))
        stretch, stretch_error, z_error, direction_error = (
            self._errors_in_phi(y) if limits.in_phi else self._errors_in_z(y)
        )
        ds_error = 4 * ROUNDING * ds + dz * stretch_error
        ds_error[[0, -1]] = stretch[[0, -1]] * (limits.start.error, limits.end.error)
        z_error[[0, -1]] += (limits.start.error, limits.end.error)
        return Places(y, z, ds, ds_error, z_error, direction_error)

    def _errors_in_z(self, y: FloatArray) -> tuple[FloatArray, ...]:
        """Largest ds/dz at nodes fixed in z; errors of ds/dz, of z and of the direction of (y, w).

        The steep part of the curve may be nearer to a node by the error of (y, w).
        """
        y = np.maximum(np.abs(y) - self.point_error, 0.0)
        direction_error = self.point_error / np.hypot(y, self.width)
        slope = self.slope(y)
        stretch = np.hypot(1.0, slope)
        slope_error = slope * (self.width_error + 2 * direction_error)
        turned = direction_error + self.sine_error
        return stretch, slope / stretch * slope_error, np.zeros_like(y), turned

    def _errors_in_phi(self, y: FloatArray) -> tuple[FloatArray, ...]:
        """Values of `_errors_in_z` at nodes fixed in phi, which move with A and phi1."""
        stretch = np.hypot(1.0, self.slope(y))
        z_error = self.angle_error * np.hypot(y, self.width) / abs(self.sine)
        return stretch, self.width_error / stretch, z_error, np.zeros_like(y)

    def _nodes(self, limits: Limits, loaded: bool) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Coordinates y and z of ends and quadrature nodes, and weights along z, m."""
        start, end, extent, _ = limits
        height = abs(self.width)
        panels = []
        waiting = [(start.y, start.z, end.y, end.z, extent)]
        if start.y < 0 < end.y:
            # a panel ends at y = 0, from where all others are reached without cancellation
            middle = (0.0, -self.offset)
            waiting = [(*middle, end.y, end.z, end.y), (start.y, start.z, *middle, -start.y)]
        while waiting:
            y, z, far_y, far_z, width = waiting.pop()
            if resolves_complex_poles(start=y, end=far_y, width=width, height=height) and not (
                loaded and not resolves_real_pole(start=z, end=far_z, width=width)
            ):
                panels.append((y, z, width))
                continue
            middle = ((y + far_y) / 2, (z + far_z) / 2)
            waiting += [(*middle, far_y, far_z, width / 2), (y, z, *middle, width / 2)]
        near_y, near_z, widths = (np.array(column)[:, None] for column in zip(*panels, strict=True))
        along = widths * NODES
        return (
            np.concatenate(([start.y], (near_y + along).ravel(), [end.y])),
            np.concatenate(([start.z], (near_z + along).ravel(), [end.z])),
            np.concatenate(([0.0], (widths * WEIGHTS).ravel(), [0.0])),
        )


def axial_scale(
    *, roller_circle_radius: float, nutation_angle: float, ratio_u12: float
) -> tuple[float, float]:
    """Signed ``A = R_C*(cos(theta) - u12)/sin(theta)``, m, and its relative error by rounding.

    A is the z at which the pitch cone has the radius R_C; `ImpossibleMechanism` is raised for
    cos(theta) = u12. The difference uses ``-2*sin(theta/2)^2`` for cos(theta) - 1, which keeps the
    digits of small angles. A whole number as the ratio counts as exact.
    """
    check_positive(roller_circle_radius=roller_circle_radius, nutation_angle=nutation_angle)
    if not nutation_angle < math.pi / 2:
        raise InvalidInput("nutation_angle", nutation_angle, "right_angle")
    check_finite(ratio_u12=ratio_u12)
    versine = 2 * math.sin(nutation_angle / 2) ** 2
    difference = (1 - ratio_u12) - versine
    exact = ratio_u12.is_integer()
    condition = (abs(1 - ratio_u12) + (0 if exact else abs(ratio_u12))) / 2 + 2 * (
        versine + nutation_angle * math.sin(nutation_angle)
    )
    if abs(difference) <= ROUNDING * condition:
        raise ImpossibleMechanism(
            "no_contact_line",
            {"nutation_angle": nutation_angle, "ratio_u12": ratio_u12},
            field="nutation_angle",
            other="ratio_u12",
        )
    scale = roller_circle_radius * difference / math.sin(nutation_angle)
    return scale, ROUNDING * (5 + condition / abs(difference))
