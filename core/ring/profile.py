"""Outline of a cycloid disc that runs on ring pins, as it is cut.

A tool of radius ``r_m = r + equidistant`` cuts the disc. The centre of the tool runs on the path
that a pin of a circle ``R_m = R + pin_circle`` has in the frame of the disc. In that frame, with
the crank up at the crank angle 0, z_p pins and z = z_p - 1 lobes:

    W(t) = i*(R_m*exp(-i*t) - e*exp(-i*z_p*t)),  K = e*z_p/R_m,  S = |1 - K*exp(-i*z*t)|
    n(t) = i*exp(-i*t)*(1 - K*exp(-i*z*t))/S,    C(t) = W(t) - r_m*n(t)

A valley lies at t = 0, and t passes the disc clockwise.
"""

import math
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_finite, check_positive, check_single
from core.errors import Accuracy, InvalidInput
from core.fields import answered, quantity
from core.precision import AS_TYPED, ROUNDING

MOST_POINTS = 200_000
"""Largest number of points of an outline."""

LEAST_POINTS = 4
"""Least number of points of a lobe."""

LOOKED = 2000
"""Number of places on a lobe at which its sharpest bend and its distance from chords are sought."""

BETWEEN = 1.001
"""Allowance for a bend between the `LOOKED` places that is sharper than at them."""

ALONG = 4
"""Least number of parts into which a chord is divided to measure the outline's distance from it."""


_offset = partial(quantity, unit="mm", default=0.0, step=0.005, ge=-0.5, le=0.5, or_zero=True)
"""Offset of the tool, positive or negative."""


@dataclass(frozen=True, slots=True)
class Modification:
    """Offsets of the tool that cuts the discs from the ring pins."""

    equidistant: float = _offset("Equidistant modification", "Δ_e")
    """Radius of the tool less that of the ring pins; a positive value makes the disc smaller all
    around."""
    pin_circle: float = _offset("Modification of the circle", "Δ_p")
    """Radius of the tool's circle less that of the ring pins; a negative value makes the disc
    smaller."""
    rotation: float = quantity(
        "Modification by rotation",
        "δ_r",
        "arcmin",
        default=0.0,
        step=0.5,
        ge=0,
        le=30,
        or_zero=True,
    )
    """Angle by which the flanks are turned to either side; tips and roots are left out."""


@dataclass(frozen=True)
class CycloidDisc:
    """Cycloid disc with one lobe less than the ring has pins."""

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
        """Number z_p of ring pins."""
        return self.satellite_teeth + 1

    @property
    def tool_circle_radius(self) -> float:
        """Circle radius R_m of the tool's path, m."""
        return self.ring_pin_circle_radius + self.modification.pin_circle

    @property
    def tool_radius(self) -> float:
        """Tool radius r_m, m."""
        return self.ring_pin_radius + self.modification.equidistant

    @property
    def shortening(self) -> float:
        """Shortening coefficient K of the tool's path."""
        return self.eccentricity * self.pins / self.tool_circle_radius

    @property
    @answered("", "K₁")
    def shortening_coefficient(self) -> float:
        """Shortening coefficient e·z₃/R_p of the ring pins."""
        return self.eccentricity * self.pins / self.ring_pin_circle_radius

    @property
    @answered("mm", "", "R_m + e − r_m")
    def tip_radius(self) -> float:
        """Largest radius of a disc."""
        return self.tool_circle_radius + self.eccentricity - self.tool_radius

    @property
    @answered("mm", "", "R_m − e − r_m")
    def root_radius(self) -> float:
        """Least radius of a disc."""
        return self.tool_circle_radius - self.eccentricity - self.tool_radius

    @property
    @answered("mm", "ρ_min")
    def min_path_radius(self) -> float:
        """Least convex radius of curvature of the tool's path."""
        k, pins, radius = self.shortening, self.pins, self.tool_circle_radius
        if k > (pins - 2) / (2 * pins - 1):
            return float(
                radius
                * math.sqrt(27 * (1 - k) * (1 + k) * self.satellite_teeth)
                / (pins + 1) ** 1.5
            )
        return float(radius * (1 + k) ** 2 / (1 + pins * k))

    @property
    @answered("", "ρ_min/r_m")
    def undercut_margin(self) -> float:
        """Least convex radius of the tool's path over the radius of the tool; at 1 or below the
        tool cuts off a part of the flanks.
        """
        return self.min_path_radius / self.tool_radius

    @property
    def undercut(self) -> bool:
        """True if a flank is undercut or ends in a cusp, which is a margin of 1 within rounding."""
        return not self.undercut_margin > 1 + AS_TYPED

    @property
    def valley_radius(self) -> float:
        """Radius of curvature of the tool's path in a valley, m; infinite if nowhere concave."""
        k, pins = self.shortening, self.pins
        if not pins * k > 1:
            return math.inf
        return self.tool_circle_radius * (1 - k) ** 2 / (pins * k - 1)

    @property
    @answered("mm")
    def min_concave_radius(self) -> float | None:
        """Least concave radius of curvature of a disc; the wheel that grinds the valleys has to be
        smaller.
        """
        radius = self.valley_radius + self.tool_radius
        return radius if math.isfinite(radius) else None

    @property
    def accuracy(self) -> Accuracy:
        """Rounding error of the sizes, larger near a cusp or a straight valley of the tool's path,
        and if hardly anything is left of the disc.
        """
        k, bends = self.shortening, self.shortening * self.pins
        lost = 1 / (1 - k) + self.tool_circle_radius / abs(self.root_radius or math.inf)
        if bends > 1:
            lost += bends / (bends - 1)
        return Accuracy("closed_form", 8 * ROUNDING * lost, 1)

    def refuse_undercut(self) -> None:
        """Raise InvalidInput if the tool undercuts the flanks."""
        if self.undercut:
            limit = self.min_path_radius - self.modification.equidistant
            raise InvalidInput("ring_pin_radius", self.ring_pin_radius, "undercut", limit=limit)

    def slope(self, t: FloatArray) -> FloatArray:
        """S at parameters t, rad, shape (n,); a pin's centre is ``R_m*S`` from the pitch point."""
        k = self.shortening
        half = np.sin(self.satellite_teeth * t / 2)
        return np.asarray(np.sqrt((1 - k) ** 2 + 4 * k * half * half))

    def path_curvature(self, t: FloatArray) -> FloatArray:
        """Curvature of the tool's path at parameters t (rad), 1/m, convex positive, shape (n,)."""
        k, pins = self.shortening, self.pins
        # 1 + z_p*K^2 - (z_p + 1)*K*cos(z*t), written without cancellation in the valley
        bend = (1 - k) * (1 - pins * k) + 2 * (pins + 1) * k * np.sin(
            self.satellite_teeth * t / 2
        ) ** 2
        return np.asarray(bend / (self.tool_circle_radius * self.slope(t) ** 3))

    def curvature(self, t: FloatArray) -> FloatArray:
        """Curvature of the disc at parameters t (rad), 1/m, convex positive, shape (n,)."""
        path = self.path_curvature(t)
        return np.asarray(path / (1 - self.tool_radius * path))

    def outline(self, t: FloatArray) -> ComplexArray:
        """Points x + i*y of the disc about its centre, in its frame, at t (rad), m, shape (n,)."""
        k, radius = self.shortening, self.tool_circle_radius
        turned, lobe = np.exp(-1j * t), np.exp(-1j * self.satellite_teeth * t)
        normal = (1 - k * lobe) / self.slope(t)
        found: ComplexArray = (
            1j * turned * (radius - self.eccentricity * lobe - self.tool_radius * normal)
        )
        return found

    @property
    def moments(self) -> tuple[float, float]:
        """Area, m^2, and its polar moment about the centre, m^4, of a disc without undercut.

        With the distance p of the tangent from the centre the outline has ``A = ∮p*ds/2`` and
        ``I = ∮|C|^2*p*ds/4``, which even places on one lobe integrate to rounding.
        """
        k, radius, lobes = self.shortening, self.tool_circle_radius, self.satellite_teeth
        t = np.linspace(0, 2 * math.pi / lobes, LOOKED, endpoint=False)
        slope = self.slope(t)
        # p = Re(W*conj(n)) - r_m with the normal n that points outwards
        tangent = (1 + self.eccentricity * k / radius) - (k + self.eccentricity / radius) * np.cos(
            lobes * t
        )
        along = radius * slope * (1 - self.tool_radius * self.path_curvature(t))
        swept = (radius * tangent / slope - self.tool_radius) * along * (2 * math.pi / LOOKED)
        return float(swept.sum()) / 2, float((np.abs(self.outline(t)) ** 2 * swept).sum()) / 4


@dataclass(frozen=True, slots=True)
class OutlinePoints:
    """Outline of a disc as a closed polygon of points."""

    points: FloatArray  # points about the disc's centre, m, shape (n, 2); the first is not repeated
    chord_error: float  # largest distance of the outline from the polygon, m


def outline_points(
    *, disc: CycloidDisc, chord_error: float, most: int = MOST_POINTS
) -> OutlinePoints:
    """Points of a disc, close enough that its outline is near their polygon.

    Every lobe has equally many points; they run clockwise from the valley that faces the crank at
    the crank angle 0. Points dt apart leave a distance of at most ``|C'|^2*|curvature|*dt^2/8``
    from the chord in the limit of close points; the stated error is measured along each chord and
    at the vertex of a parabola through the largest distance there. Raises InvalidInput if the disc
    is undercut, or the chord error or the number of lobes needs more points. The chord error, m,
    > 0, is the largest distance of the outline from the polygon, which has at most `most` points.

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
    """Largest distance of a lobe from the chords between its points, which are even in t, m."""
    each, lobe = len(ends) - 1, 2 * math.pi / disc.satellite_teeth
    parts = max(ALONG, math.ceil(LOOKED / each))
    t = np.linspace(0, lobe, each * parts, endpoint=False)
    starts, chords = ends[:-1, None], np.diff(ends)[:, None]
    along = disc.outline(t).reshape(each, parts)
    aside = ((along - starts) * np.conj(chords)).imag / np.abs(chords)
    aside = np.column_stack((aside, np.zeros(each)))
    best = np.abs(aside[:, 1:-1]).argmax(axis=1) + 1
    before, most, after = (aside[np.arange(each), best + way] for way in (-1, 0, 1))
    # avoids a division by 0 if the three lie on a line
    bend = before - 2 * most + after
    vertex = most - (after - before) ** 2 / np.where(bend == 0, np.inf, 8 * bend)
    return float(np.abs(vertex).max())
