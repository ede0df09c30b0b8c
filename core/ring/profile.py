"""The outline of a cycloid disc that runs on ring pins, as it is cut.

What is left by a tool of the radius ``r_m = r + equidistant`` whose centre runs on the path that a
pin of the circle ``R_m = R + pin_circle`` has in the disc's frame. In that frame, with the crank's
direction up at the crank angle 0, z_p pins and z = z_p - 1 lobes:

    W(t) = i*(R_m*exp(-i*t) - e*exp(-i*z_p*t)),  K = e*z_p/R_m,  S = |1 - K*exp(-i*z*t)|
    n(t) = i*exp(-i*t)*(1 - K*exp(-i*z*t))/S,    C(t) = W(t) - r_m*n(t)

A valley lies at t = 0, and the disc is passed clockwise.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_finite, check_positive, check_single
from core.errors import Accuracy, InvalidInput
from core.precision import AS_TYPED, ROUNDING

MOST_POINTS = 200_000
"""Most points of an outline."""

LEAST_POINTS = 4
"""Least points of a lobe."""

LOOKED = 2000
"""Places of a lobe at which its sharpest bend, and its distance from chords, is looked for."""

BETWEEN = 1.001
"""What the sharpest bend may be above that of these places."""

ALONG = 4
"""Least parts of a chord between which the distance of the outline from it is measured."""


@dataclass(frozen=True, slots=True)
class Modification:
    """By what the tool is set off from the ring's pins: what gives the mesh its play."""

    equidistant: float = 0.0  # of its radius, m; positive makes the disc smaller
    pin_circle: float = 0.0  # of the radius of its circle, m; negative makes the disc smaller
    rotation: float = 0.0  # by which the flanks are turned against each other, rad, >= 0


@dataclass(frozen=True)
class CycloidDisc:
    """A cycloid disc with one lobe less than the ring has pins."""

    satellite_teeth: int  # z, >= 2
    eccentricity: float  # e, m, > 0
    ring_pin_circle_radius: float  # R of the ring's pins, m, > 0
    ring_pin_radius: float  # r of the ring's pins, m, > 0
    modification: Modification = field(default_factory=Modification)

    def __post_init__(self) -> None:
        sizes = {
            name: getattr(self, name)
            for name in ("eccentricity", "ring_pin_circle_radius", "ring_pin_radius")
        }
        own = self.modification
        changes = {"equidistant": own.equidistant, "pin_circle": own.pin_circle}
        check_single(
            satellite_teeth=self.satellite_teeth, **sizes, **changes, rotation=own.rotation
        )
        check_finite(**sizes, **changes, rotation=own.rotation)
        check_positive(**sizes)
        if not self.satellite_teeth >= 2:
            raise InvalidInput(
                "satellite_teeth", self.satellite_teeth, "greater_than_equal", limit=2
            )
        if not own.rotation >= 0:
            raise InvalidInput("rotation", own.rotation, "greater_than_equal", limit=0)
        least = self.eccentricity * self.pins
        radius = self.ring_pin_circle_radius
        if not radius > least:
            than = {"field": "satellite_teeth", "limit": least}
            raise InvalidInput("ring_pin_circle_radius", radius, "no_cycloid", **than)
        if not self.tool_circle_radius > least:
            raise InvalidInput("pin_circle", own.pin_circle, "greater_than", limit=least - radius)
        if not self.tool_radius > 0:
            limit = -self.ring_pin_radius
            raise InvalidInput("equidistant", own.equidistant, "greater_than", limit=limit)

    @property
    def pins(self) -> int:
        """Number z_p of the ring's pins."""
        return self.satellite_teeth + 1

    @property
    def tool_circle_radius(self) -> float:
        """R_m, m."""
        return self.ring_pin_circle_radius + self.modification.pin_circle

    @property
    def tool_radius(self) -> float:
        """r_m, m."""
        return self.ring_pin_radius + self.modification.equidistant

    @property
    def shortening(self) -> float:
        """K of the tool's path."""
        return self.eccentricity * self.pins / self.tool_circle_radius

    @property
    def shortening_coefficient(self) -> float:
        """K1 of the ring's pins."""
        return self.eccentricity * self.pins / self.ring_pin_circle_radius

    @property
    def tip_radius(self) -> float:
        """Largest radius of the disc, m."""
        return self.tool_circle_radius + self.eccentricity - self.tool_radius

    @property
    def root_radius(self) -> float:
        """Least radius of the disc, m."""
        return self.tool_circle_radius - self.eccentricity - self.tool_radius

    @property
    def min_path_radius(self) -> float:
        """Least convex radius of curvature of the tool's path, m.

        Notes
        -----
        ``R_m*sqrt(27*(1 - K^2)*z)/(z_p + 1)^1.5`` where ``K > (z_p - 2)/(2*z_p - 1)``, on the
        flank; else ``R_m*(1 + K)^2/(1 + z_p*K)``, at the tip. Where the curvature is stationary
        over the lobe; derived.

        Examples
        --------
        >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
        ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005)
        >>> round(disc.min_path_radius, 9)
        0.014706969
        """
        k, pins, radius = self.shortening, self.pins, self.tool_circle_radius
        if k > (pins - 2) / (2 * pins - 1):
            return float(
                radius
                * math.sqrt(27 * (1 - k) * (1 + k) * self.satellite_teeth)
                / (pins + 1) ** 1.5
            )
        return float(radius * (1 + k) ** 2 / (1 + pins * k))

    @property
    def undercut_margin(self) -> float:
        """That radius over the tool's: at 1 and below, the tool cuts a loop off the flank."""
        return self.min_path_radius / self.tool_radius

    @property
    def undercut(self) -> bool:
        """Whether a flank is undercut, or ends in a cusp, as at a margin of 1 within rounding."""
        return not self.undercut_margin > 1 + AS_TYPED

    @property
    def valley_radius(self) -> float:
        """Radius of curvature of the tool's path in the middle of a valley, m; infinite where the
        path bends nowhere inwards.
        """
        k, pins = self.shortening, self.pins
        if not pins * k > 1:
            return math.inf
        return self.tool_circle_radius * (1 - k) ** 2 / (pins * k - 1)

    @property
    def min_concave_radius(self) -> float | None:
        """Least concave radius of the disc, m, in the middle of its valleys; what grinds it has to
        be smaller. None where it is nowhere concave.
        """
        radius = self.valley_radius + self.tool_radius
        return radius if math.isfinite(radius) else None

    @property
    def accuracy(self) -> Accuracy:
        """Of these sizes: rounding, of which more is left where the tool's path nearly has a cusp
        in its valleys, hardly bends there, or where hardly anything is left of the disc.
        """
        k, bends = self.shortening, self.shortening * self.pins
        lost = 1 / (1 - k) + self.tool_circle_radius / abs(self.root_radius or math.inf)
        if bends > 1:
            lost += bends / (bends - 1)
        return Accuracy("closed_form", 8 * ROUNDING * lost, 1)

    def refuse_undercut(self) -> None:
        """Refuse a disc whose tool cuts off a part of its flanks.

        Raises
        ------
        InvalidInput
            If it does.
        """
        if self.undercut:
            limit = self.min_path_radius - self.modification.equidistant
            raise InvalidInput("ring_pin_radius", self.ring_pin_radius, "undercut", limit=limit)

    def slope(self, t: FloatArray) -> FloatArray:
        """S at parameters: a pin's centre is ``R_m*S`` from the pitch point.

        Parameters
        ----------
        t : array, shape (n,)
            Parameters, rad.

        Returns
        -------
        array, shape (n,)
        """
        k = self.shortening
        half = np.sin(self.satellite_teeth * t / 2)
        return np.asarray(np.sqrt((1 - k) ** 2 + 4 * k * half * half))

    def path_curvature(self, t: FloatArray) -> FloatArray:
        """Curvature of the tool's path, convex positive.

        Parameters
        ----------
        t : array, shape (n,)
            Parameters, rad.

        Returns
        -------
        array, shape (n,)
            In 1/m.
        """
        k, pins = self.shortening, self.pins
        # 1 + z_p*K^2 - (z_p + 1)*K*cos(z*t), which is a difference of its terms in the valley
        bend = (1 - k) * (1 - pins * k) + 2 * (pins + 1) * k * np.sin(
            self.satellite_teeth * t / 2
        ) ** 2
        return np.asarray(bend / (self.tool_circle_radius * self.slope(t) ** 3))

    def curvature(self, t: FloatArray) -> FloatArray:
        """Curvature of the disc, convex positive.

        Parameters
        ----------
        t : array, shape (n,)
            Parameters, rad.

        Returns
        -------
        array, shape (n,)
            In 1/m.
        """
        path = self.path_curvature(t)
        return np.asarray(path / (1 - self.tool_radius * path))

    def outline(self, t: FloatArray) -> ComplexArray:
        """Points of the disc.

        Parameters
        ----------
        t : array, shape (n,)
            Parameters, rad.

        Returns
        -------
        complex array, shape (n,)
            In the disc's frame, about its centre, m.
        """
        k, radius = self.shortening, self.tool_circle_radius
        turned, lobe = np.exp(-1j * t), np.exp(-1j * self.satellite_teeth * t)
        normal = (1 - k * lobe) / self.slope(t)
        found: ComplexArray = (
            1j * turned * (radius - self.eccentricity * lobe - self.tool_radius * normal)
        )
        return found


@dataclass(frozen=True, slots=True)
class OutlinePoints:
    """A disc's outline as a closed polygon of its points."""

    points: FloatArray  # about the disc's centre, m, shape (n, 2); the first is not repeated
    chord_error: float  # how far the outline is from the polygon at most, m


def outline_points(
    *, disc: CycloidDisc, chord_error: float, most: int = MOST_POINTS
) -> OutlinePoints:
    """Points of a disc so close that its outline is near their polygon; as many on every lobe, the
    first in the valley that faces the crank at the crank angle 0, clockwise.

    Parameters
    ----------
    disc : CycloidDisc
        The disc.
    chord_error : float
        How far the outline may be from the polygon, m, > 0.
    most : int
        Most points.

    Returns
    -------
    OutlinePoints

    Raises
    ------
    InvalidInput
        If the disc is undercut, or that would take more points, or its lobes do.

    Notes
    -----
    Between points that are dt apart the outline bends away from its chord by
    ``|C'|^2*|curvature|*dt^2/8`` at most, in the limit of close points; what is stated is measured
    along each chord, and at the vertex of a parabola through the largest distance there.

    Examples
    --------
    >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
    ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005)
    >>> found = outline_points(disc=disc, chord_error=1e-6)
    >>> len(found.points) % 11, found.chord_error <= 1e-6
    (0, True)
    """
    disc.refuse_undercut()
    check_single(chord_error=chord_error)
    check_positive(chord_error=chord_error)
    lobe = 2 * math.pi / disc.satellite_teeth
    places = np.linspace(0, lobe, LOOKED, endpoint=False)
    path = disc.path_curvature(places)
    bends = (disc.tool_circle_radius * disc.slope(places)) ** 2
    bends = bends * np.abs((1 - disc.tool_radius * path) * path)
    bend = BETWEEN * float(bends.max())
    each = max(math.ceil(lobe / math.sqrt(8 * chord_error / bend)), LEAST_POINTS)
    if each * disc.satellite_teeth > most:
        fit = most // disc.satellite_teeth
        if fit < LEAST_POINTS:
            lobes = disc.satellite_teeth
            limit = most // LEAST_POINTS
            raise InvalidInput("satellite_teeth", lobes, "less_than_equal", limit=limit)
        least = bend * (lobe / fit) ** 2 / 8
        raise InvalidInput("chord_error", chord_error, "greater_than_equal", limit=least)
    count = each * disc.satellite_teeth
    t = 2 * math.pi * np.arange(count) / count
    points = disc.outline(t)
    error = _farthest(disc, points[: each + 1]) + 4 * ROUNDING * disc.tip_radius
    return OutlinePoints(np.column_stack((points.real, points.imag)), error)


def _farthest(disc: CycloidDisc, ends: ComplexArray) -> float:
    """How far a lobe is from the chords between its points, which are even in t, m."""
    each, lobe = len(ends) - 1, 2 * math.pi / disc.satellite_teeth
    parts = max(ALONG, math.ceil(LOOKED / each))
    t = np.linspace(0, lobe, each * parts, endpoint=False)
    starts, chords = ends[:-1, None], np.diff(ends)[:, None]
    along = disc.outline(t).reshape(each, parts)
    aside = ((along - starts) * np.conj(chords)).imag / np.abs(chords)
    aside = np.column_stack((aside, np.zeros(each)))
    best = np.abs(aside[:, 1:-1]).argmax(axis=1) + 1
    before, most, after = (aside[np.arange(each), best + way] for way in (-1, 0, 1))
    # 0 below the vertex where the three lie on a line
    bend = before - 2 * most + after
    vertex = most - (after - before) ** 2 / np.where(bend == 0, np.inf, 8 * bend)
    return float(np.abs(vertex).max())
