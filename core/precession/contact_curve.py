"""The curve of all contact points of one roller, and quadrature along it.

In the coordinate ``y = z + A*cos(phi1)`` along the roller, with ``w = |A*sin(phi1)|``, the
direction of the contact point from the roller's axis is the direction of the point (y, w) turned
by phi1: ``cot(phi + phi1) = y/(A*sin(phi1))``. So the curve has no pole in z, the slope of the
unrolled curve is ``rho*dphi/dz = rho*w/(y^2 + w^2)``, and its length

    s = integral sqrt(1 + (rho*w/(y^2 + w^2))^2) dy

is integrated on panels graded to the nearest singularities, which are known: ``y = +-i*w`` and
``y^2 = -w^2 +- i*rho*w``; for loads also z = 0, where the arm about the axis is zero.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.errors import ImpossibleMechanism, InvalidInput
from core.quadrature import NODES, WEIGHTS, resolves_complex_poles, resolves_real_pole
from core.results import ROUNDING


class LinePoint(NamedTuple):
    """A place on a contact line: y from its steepest place, z from the precession centre, m."""

    y: float
    z: float


@dataclass(frozen=True, slots=True)
class ContactCurve:
    """The curve of all contact points of one roller.

    Attributes
    ----------
    roller_circle_radius, roller_radius : float
        R_C and rho, m.
    position_angle : float
        phi1, rad.
    scale : float
        ``A = R_C*(cos(theta) - u12)/sin(theta)``, m.
    scale_error : float
        Relative error of A, the condition of the input included.
    """

    roller_circle_radius: float
    roller_radius: float
    position_angle: float
    scale: float
    scale_error: float

    @property
    def sine(self) -> float:
        """sin(phi1)."""
        return math.sin(self.position_angle)

    @property
    def offset(self) -> float:
        """``A*cos(phi1)`` = y - z, m."""
        return self.scale * math.cos(self.position_angle)

    @property
    def width(self) -> float:
        """``A*sin(phi1)``, m, with its sign: the half-width w of the steep part of the line."""
        return self.scale * math.sin(self.position_angle)

    @property
    def width_error(self) -> float:
        """Relative error of `width`."""
        angle = self.position_angle
        return self.scale_error + ROUNDING * (1 + abs(angle / math.tan(angle)))

    @property
    def offset_error(self) -> float:
        """Absolute error of `offset`, m."""
        angle = self.position_angle
        sine, cosine = abs(math.sin(angle)), abs(math.cos(angle))
        return abs(self.scale) * (
            cosine * (self.scale_error + ROUNDING) + ROUNDING * abs(angle) * sine
        )

    def slope(self, y: FloatArray) -> FloatArray:
        """Slope ``|rho*dphi/dz|`` of the unrolled line at y."""
        width = abs(self.width)
        return (self.roller_radius / width) / (1 + (y / width) ** 2)

    def steepest_stretch(self, y: float, error: float) -> float:
        """Largest ds/dz within an error of y."""
        width = abs(self.width)
        nearest = max(abs(y) - error, 0.0) / width
        return math.hypot(1.0, self.roller_radius / width / (1 + nearest * nearest))

    def stretch_variation(self, start: float, end: float, error: float) -> float:
        """Total variation of ds/dz from `start` to `end`, widened by an error of both.

        Times that error it bounds the change of the length when the curve moves along z.
        """
        width = abs(self.width)
        far = [(abs(y) + error) / width for y in (start, end)]
        low = [math.hypot(1.0, self.roller_radius / width / (1 + y * y)) for y in far]
        if start - error <= 0 <= end + error:
            return 2 * self.steepest_stretch(0.0, 0.0) - low[0] - low[1]
        return self.steepest_stretch(min(abs(start), abs(end)), error) - min(low)

    def polar_angle(self, z: FloatArray) -> FloatArray:
        """Polar angle phi at z, rad: continuous along the line, in (-pi, pi] somewhere on it."""
        angle = self.position_angle
        principal: FloatArray = np.arctan2(-z * math.sin(angle), self.scale + z * math.cos(angle))
        continuous = np.arctan2(self.width, z + self.offset) - angle
        return principal + 2 * np.pi * np.rint((continuous - principal) / (2 * np.pi))

    def nodes(
        self, *, start: LinePoint, end: LinePoint, extent: float, loaded: bool = False
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Nodes and weights of the quadrature along z from `start` to `end`.

        Parameters
        ----------
        start, end : LinePoint
            Ends of the interval, z growing.
        extent : float
            Its length, m.
        loaded : bool
            Whether the integrand also has a pole at z = 0 outside the interval.

        Returns
        -------
        y, z, weight : array, shape (number of nodes,)
            Places, m, and weights, m.
        """
        height = abs(self.width)
        panels = []
        waiting = [(start, end, extent)]
        if start.y < 0 < end.y:
            # a panel ends at y = 0, from where all others are reached without cancellation
            middle = LinePoint(0.0, -self.offset)
            waiting = [(middle, end, end.y), (start, middle, -start.y)]
        while waiting:
            left, right, width = waiting.pop()
            if resolves_complex_poles(
                start=left.y, end=right.y, width=width, height=height
            ) and not (loaded and not resolves_real_pole(start=left.z, end=right.z, width=width)):
                panels.append((left.y, left.z, width))
                continue
            middle = LinePoint((left.y + right.y) / 2, (left.z + right.z) / 2)
            waiting += [(middle, right, width / 2), (left, middle, width / 2)]
        origin_y, origin_z, widths = (
            np.array(column)[:, None] for column in zip(*panels, strict=True)
        )
        along = widths * NODES
        return (origin_y + along).ravel(), (origin_z + along).ravel(), (widths * WEIGHTS).ravel()


def axial_scale(
    *, roller_circle_radius: float, nutation_angle: float, ratio_u12: float
) -> tuple[float, float]:
    """``A = R_C*(cos(theta) - u12)/sin(theta)``: the z at which the pitch cone has radius R_C.

    Parameters
    ----------
    roller_circle_radius : float
        R_C, m.
    nutation_angle : float
        Nutation angle theta, rad.
    ratio_u12 : float
        Ratio u12, dimensionless.

    Returns
    -------
    scale : float
        A, m, with its sign.
    relative_error : float
        Of A: that of the input's rounding, which the difference magnifies.

    Raises
    ------
    InvalidInput
        If the radius or the angle is out of range.
    ImpossibleMechanism
        If cos(theta) = u12.

    Notes
    -----
    cos(theta) - 1 is taken as ``-2*sin(theta/2)^2``, which keeps the digits of a small angle. A
    whole number as the ratio is taken to be meant exactly.
    """
    if not roller_circle_radius > 0:
        raise InvalidInput("roller_circle_radius", roller_circle_radius, "must be larger than 0")
    if not 0 < nutation_angle < math.pi / 2:
        raise InvalidInput(
            "nutation_angle", nutation_angle, "must be larger than 0 and below a right angle"
        )
    if not math.isfinite(ratio_u12):
        raise InvalidInput("ratio_u12", ratio_u12, "must be a finite number")
    versine = 2 * math.sin(nutation_angle / 2) ** 2
    difference = (1 - ratio_u12) - versine
    magnitudes = (
        2 * versine
        + abs(1 - ratio_u12)
        + (0.0 if ratio_u12.is_integer() else abs(ratio_u12))
        + nutation_angle * math.sin(nutation_angle)
    )
    if abs(difference) <= ROUNDING * magnitudes:
        raise ImpossibleMechanism(
            "there is no contact line, because cos(nutation_angle) equals ratio_u12",
            where={"nutation_angle": nutation_angle, "ratio_u12": ratio_u12},
        )
    scale = roller_circle_radius * difference / math.sin(nutation_angle)
    return scale, ROUNDING * (3 + magnitudes / abs(difference))
