"""Contact lines of the precessional gear's rollers: their course and their length."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import Accuracy, ImpossibleMechanism, InvalidInput, Notice, poorly_known
from core.fields import answer, answered
from core.numerics.quadrature import TRUNCATION
from core.precession.contact_curve import ContactCurve, Limits, LinePoint, Places, axial_scale
from core.precession.rollers import (
    ANGLE_ROUNDING,
    SAME,
    Roller,
    RollerByAngle,
    RollerByLength,
    stands_in_line,
)
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactLine:
    """Contact line of one roller."""

    curve: ContactCurve  # curve that contains the line
    limits: Limits
    places: Places  # nodes of quadrature along the line
    phi_min: float = answer("deg", "φ_min", "2020, eq. 6")
    """Polar angle of the first end."""
    phi_max: float = answer("deg", "φ_max", "2020, eq. 7")
    """Polar angle of the last end."""
    length: float = answer("mm", "s_i", "2020, eq. 4")
    """Length of the line."""
    relative_error: float = answer()
    """Bound of the relative error of the line's length."""
    arm_sign: int  # sign of the arm -R_C*sin(phi) about the axis; 0 if the line reaches phi = 0
    flank: int  # half-turns added to the polar angle of the curve

    @property
    @answered("deg", "φ_1", "2020, eq. 1")
    def position_angle(self) -> float:
        """Position angle of the roller."""
        return self.curve.position_angle

    @property
    @answered("mm", "z_min", "2020, eq. 1")
    def z_min(self) -> float:
        """Lower end of the line along the axis of the wheel."""
        return self.limits.start.z

    @property
    @answered("mm", "z_max", "2020, eq. 1")
    def z_max(self) -> float:
        """Upper end of the line along the axis of the wheel."""
        return self.limits.end.z


@dataclass(frozen=True, slots=True)
class ContactLines:
    """Contact lines of the rollers."""

    lines: tuple[ContactLine, ...] = answer()
    """The lines, in the order of the rollers."""
    total_length: float = answer("mm", "Σs", "2020, eq. 8")
    """Length of all lines together."""
    accuracy: Accuracy = answer()  # accuracy of `total_length`; each line states its own error
    notices: tuple[Notice, ...] = answer()


def contact_lines(
    *,
    roller_circle_radius: float,
    roller_radius: float,
    nutation_angle: float,
    ratio_u12: float,
    rollers: Sequence[Roller],
    torque_sign: int | None = None,
) -> ContactLines:
    """Contact lines of rollers: ``z = -A*sin(phi)/sin(phi + phi1)`` and their lengths.

    Every z has two contact points, phi and phi + pi, on the two flanks of the roller, with lines of
    equal length. Limits in z with a `torque_sign` select the loaded flank, whose arm
    ``-R_C*sin(phi)`` about the axis has the sign of the torque. `InvalidInput` is raised if
    sin(phi1) = 0, or if limits lie at or across a pole ``phi + phi1 = 0, pi, ...``;
    `ImpossibleMechanism` if cos(theta) = u12, and with a torque sign if a line reaches z = 0, where
    phi and the arm are zero and the loaded flank changes.

    Source: Khatetovsky et al. 2020, eqs (1)-(7). Errata: (1) ends in "= 0"; the slope (5) has the
    sign opposite to the derivative ``dz/dphi = -A*sin(phi1)/sin(phi + phi1)^2`` and cancels digits.
    R_C is the radius of the circle of roller axes, rho < R_C that of a roller, m, theta the
    nutation angle, rad, 0 < theta < pi/2, u12 the ratio with the input shaft held. Without the sign
    of the torque on the central wheel, 1 or -1, limits in z give the flank
    ``phi = atan2(-z*sin(phi1), A + z*cos(phi1))``.

    >>> from math import radians
    >>> result = contact_lines(
    ...     roller_circle_radius=0.05, roller_radius=0.004, nutation_angle=radians(6),
    ...     ratio_u12=24/25, rollers=[RollerByLength(radians(angle), 0.015, 0.025)
    ...                               for angle in (30, 60, 90, 120)])
    >>> round(result.total_length*1e3, 10)
    40.2196026288
    """
    scale, scale_error = axial_scale(
        roller_circle_radius=roller_circle_radius,
        nutation_angle=nutation_angle,
        ratio_u12=ratio_u12,
    )
    if not 0 < roller_radius < roller_circle_radius:
        than = {"field": "roller_circle_radius", "limit": roller_circle_radius}
        raise InvalidInput("roller_radius", roller_radius, "smaller_than", **than)
    if not rollers:
        raise InvalidInput("rollers", rollers, "too_short", limit=1)
    if torque_sign not in (None, 1, -1):
        raise InvalidInput("torque_sign", torque_sign, "not_zero")
    lines = []
    for index, roller in enumerate(rollers):
        if stands_in_line(roller.position_angle):
            raise InvalidInput(
                f"rollers[{index}].position_angle",
                roller.position_angle,
                "no_arm",
            )
        curve = ContactCurve(
            roller_circle_radius=roller_circle_radius,
            roller_radius=roller_radius,
            position_angle=roller.position_angle,
            angle_error=ANGLE_ROUNDING * abs(roller.position_angle) + roller.position_error,
            scale=scale,
            scale_error=scale_error,
        )
        lines.append(_contact_line(curve, roller, index, torque_sign))
    total = math.fsum(line.length for line in lines)
    accuracy = Accuracy(
        method="graded_quadrature",
        relative_error=math.fsum(line.relative_error * line.length for line in lines) / total,
        evaluations=sum(len(line.places.ds) - 2 for line in lines),
    )
    return ContactLines(
        lines=tuple(lines), total_length=total, accuracy=accuracy, notices=poorly_known(accuracy)
    )


def _contact_line(
    curve: ContactCurve, roller: Roller, index: int, torque_sign: int | None
) -> ContactLine:
    """Contact line of one roller, on the loaded flank or on the flank that its limits name."""
    limits = (
        _limits_in_z(curve, roller, index)
        if isinstance(roller, RollerByLength)
        else _limits_in_phi(curve, roller, index)
    )
    loaded = torque_sign is not None
    start, end, *_ = limits
    angles = curve.polar_angle(np.array([start.z, end.z])).tolist()
    arm_sign, flank = 1 if start.z * curve.sine > 0 else -1, 0
    if isinstance(roller, RollerByAngle):
        flank = round((roller.phi_min + roller.phi_max - sum(angles)) / (2 * math.pi))
        angles = [roller.phi_min, roller.phi_max]
    elif torque_sign == -arm_sign:
        flank = -1 if sum(angles) > 0 else 1
        angles = [angle + flank * math.pi for angle in angles]
    arm_sign *= -1 if flank % 2 else 1
    if start.z <= start.error and end.z >= -end.error:
        if loaded:
            raise ImpossibleMechanism("no_lever", {"roller": index + 1, "z": 0.0})
        arm_sign = 0
    places = curve.places(limits, loaded=loaded)
    length = math.fsum(places.ds.tolist())
    return ContactLine(
        curve=curve,
        limits=limits,
        places=places,
        phi_min=min(angles),
        phi_max=max(angles),
        length=length,
        relative_error=TRUNCATION + float(places.ds_error.sum()) / length,
        arm_sign=arm_sign,
        flank=flank,
    )


def _limits_in_z(curve: ContactCurve, roller: RollerByLength, index: int) -> Limits:
    z_min, z_max = roller.z_min, roller.z_max
    if not z_max - z_min > SAME * max(abs(z_min), abs(z_max)):
        than = {"field": "z_min", "limit": z_min}
        raise InvalidInput(f"rollers[{index}].z_max", z_max, "larger_than", **than)
    start, end = (LinePoint(z + curve.offset, z, ROUNDING * abs(z)) for z in (z_min, z_max))
    return Limits(start, end, z_max - z_min, in_phi=False)


def _limits_in_phi(curve: ContactCurve, roller: RollerByAngle, index: int) -> Limits:
    """Ends ``z = -A*sin(phi)/sin(phi + phi1)``, ``y = w*cot(phi + phi1)`` and their distance."""
    span = roller.phi_max - roller.phi_min
    if not span > SAME * max(abs(roller.phi_min), abs(roller.phi_max)):
        than = {"field": "phi_min", "limit": roller.phi_min}
        raise InvalidInput(f"rollers[{index}].phi_max", roller.phi_max, "larger_than", **than)
    sines, points = [], []
    for name, phi in (("phi_min", roller.phi_min), ("phi_max", roller.phi_max)):
        sine, cosine = _sine_and_cosine_of_sum(phi, roller.position_angle)
        rounding = ROUNDING * (abs(phi) + abs(roller.position_angle))
        if abs(sine) <= 4 * rounding:
            raise InvalidInput(
                f"rollers[{index}].{name}",
                phi,
                "infinite_line",
                field="position_angle",
            )
        y, z = curve.width * cosine / sine, -curve.scale * math.sin(phi) / sine
        dz_dphi = abs(curve.width) / (abs(sine) - 2 * rounding) ** 2
        error = ANGLE_ROUNDING * abs(phi) + curve.angle_error
        sines.append(sine)
        points.append(LinePoint(y, z, error * dz_dphi + 3 * ROUNDING * abs(z)))
    if span >= math.pi or sines[0] * sines[1] < 0:
        raise InvalidInput(
            f"rollers[{index}].phi_max",
            roller.phi_max,
            "other_branch",
            field="phi_min",
            other="position_angle",
        )
    start, end = sorted(points, key=lambda point: point.z)
    extent = abs(curve.width * math.sin(span) / (sines[0] * sines[1]))
    return Limits(start, end, extent, in_phi=True)


def _sine_and_cosine_of_sum(first: float, second: float) -> tuple[float, float]:
    """Sine and cosine of a sum of angles, corrected for the rounding of the sum."""
    total = first + second
    part = total - first
    lost = (first - (total - part)) + (second - part)
    sine, cosine = math.sin(total), math.cos(total)
    return sine + lost * cosine, cosine - lost * sine


@dataclass(frozen=True, slots=True)
class ContactPoints:
    """Points of a contact line, for drawing."""

    z: FloatArray = answer("mm", "z", "2020, eq. 1")
    """Coordinate along the axis of the wheel, from the centre of precession."""
    phi: FloatArray = answer("deg", "φ", "2020, eq. 1")
    """Polar angle on the roller."""
    x: FloatArray = answer("mm", "x")
    """Arc on the developed roller, ρφ."""
    position: FloatArray = answer("mm", "r_1", "2020, eq. 21, 23, 24")
    """Points in space, X, Y, Z."""


def contact_points(*, line: ContactLine, samples: int = 61) -> ContactPoints:
    """Points of a contact line, at least 2, denser where the line is steep.

    Source: Khatetovsky et al. 2020, eqs (1)-(3) and (21). Erratum: r_1y in (24) has
    ``- (R_C - rho*cos(phi))*cos(phi1)`` instead of the plus sign of (21), so that the distance from
    the axis would depend on the frame.
    """
    curve = line.curve
    width = abs(curve.width)
    ends = [math.asinh(point.y / width) for point in line.limits[:2]]
    z = np.clip(
        width * np.sinh(np.linspace(ends[0], ends[1], samples)) - curve.offset,
        line.z_min,
        line.z_max,
    )
    z[0], z[-1] = line.z_min, line.z_max
    phi = curve.polar_angle(z) + line.flank * math.pi
    circle, radius, angle = curve.roller_circle_radius, curve.roller_radius, line.position_angle
    across, inward = radius * np.sin(phi), circle - radius * np.cos(phi)
    sine, cosine = math.sin(angle), math.cos(angle)
    return ContactPoints(
        z=z,
        phi=phi,
        x=radius * phi,
        position=np.stack(
            (across * cosine - inward * sine, across * sine + inward * cosine, z), axis=-1
        ),
    )
