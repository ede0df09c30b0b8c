"""Contact lines of the precessional gear's rollers: where they run and how long they are."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import ImpossibleMechanism, InvalidInput
from core.precession.contact_curve import ContactCurve, LinePoint, axial_scale
from core.precession.rollers import SAME, Roller, RollerByAngle, RollerByLength, stands_in_line
from core.quadrature import TRUNCATION
from core.results import ROUNDING, Accuracy


@dataclass(frozen=True, slots=True)
class ContactLine:
    """Contact line of one roller.

    Attributes
    ----------
    position_angle : float
        Position angle phi1 of the roller, rad.
    z_min, z_max : float
        Ends of the line along the axis, m.
    phi_min, phi_max : float
        Smallest and largest polar angle, rad, reached at its two ends.
    length : float
        Length s, m.
    relative_error : float
        Of the length.
    arm_sign : int
        Sign of the arm ``-R_C*sin(phi)`` about the axis; 0 where the line reaches phi = 0.
    flank : int
        Half-turns by which this flank lies from the one that the curve's polar angle gives.
    start, end : LinePoint
        Ends of the line, z growing.
    extent : float
        ``z_max - z_min``, m, to more digits than the difference has.
    end_errors : tuple of float
        Bounds of the error of z at the two ends, m: rounding of the limits as given.
    curve : ContactCurve
        The curve that the line is a part of.
    """

    position_angle: float
    z_min: float
    z_max: float
    phi_min: float
    phi_max: float
    length: float
    relative_error: float
    arm_sign: int
    flank: int
    start: LinePoint
    end: LinePoint
    extent: float
    end_errors: tuple[float, float]
    curve: ContactCurve


@dataclass(frozen=True, slots=True)
class ContactLines:
    """Contact lines of the rollers.

    Attributes
    ----------
    lines : tuple of ContactLine
        One for each roller, in their order.
    total_length : float
        Sum of the lengths, m.
    accuracy : Accuracy
        Of `total_length`.
    """

    lines: tuple[ContactLine, ...]
    total_length: float
    accuracy: Accuracy


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

    Every z has two contact points, phi and phi + pi, on the two flanks of the roller. The
    lengths of both are equal. Limits in z with a `torque_sign` choose the loaded flank, the one
    whose arm ``-R_C*sin(phi)`` about the axis has the torque's sign.

    Parameters
    ----------
    roller_circle_radius : float
        Radius R_C of the circle of roller axes, m.
    roller_radius : float
        Radius rho of a roller, m, below R_C.
    nutation_angle : float
        Nutation angle theta, rad, 0 < theta < pi/2.
    ratio_u12 : float
        Ratio u12 with the input shaft held, dimensionless.
    rollers : sequence of RollerByLength or RollerByAngle
        The rollers, at least one.
    torque_sign : int, optional
        1 or -1: sign of the torque on the central wheel. Without it limits in z give the flank
        ``phi = atan2(-z*sin(phi1), A + z*cos(phi1))``.

    Returns
    -------
    ContactLines

    Raises
    ------
    InvalidInput
        If a size is out of range, sin(phi1) = 0, a working length is not positive, limits lie
        at or across a pole ``phi + phi1 = 0, pi, ...``.
    ImpossibleMechanism
        If cos(theta) = u12: then there is no contact line. Or if, with a torque sign, a line
        reaches z = 0: phi = 0 there, the arm is zero and the loaded flank changes.

    Notes
    -----
    Source: Khatetovsky et al. 2020, eqs (1)-(7). Their slope (5) is a difference that cancels;
    simplified it is ``dz/dphi = -A*sin(phi1)/sin(phi + phi1)^2``.

    Examples
    --------
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
        raise InvalidInput(
            "roller_radius", roller_radius, "must be larger than 0 and below {roller_circle_radius}"
        )
    if not rollers:
        raise InvalidInput("rollers", rollers, "must name at least one roller")
    if torque_sign not in (None, 1, -1):
        raise InvalidInput("torque_sign", torque_sign, "must be 1 or -1")
    lines = []
    evaluations = 0
    for index, roller in enumerate(rollers):
        if stands_in_line(roller.position_angle):
            raise InvalidInput(
                f"rollers[{index}].position_angle",
                roller.position_angle,
                "must not be a multiple of half a turn: there the contact has no arm",
            )
        curve = ContactCurve(
            roller_circle_radius=roller_circle_radius,
            roller_radius=roller_radius,
            position_angle=roller.position_angle,
            scale=scale,
            scale_error=scale_error,
        )
        if isinstance(roller, RollerByLength):
            line, nodes = _line_by_length(curve, roller, index, torque_sign)
        else:
            line, nodes = _line_by_angle(curve, roller, index)
        if torque_sign is not None and line.arm_sign == 0:
            raise ImpossibleMechanism(
                f"the contact line of roller {index + 1} cannot carry a torque, because it "
                "reaches phi = 0, where the load has no arm about the axis",
                where={"roller": float(index + 1), "z": 0.0},
            )
        lines.append(line)
        evaluations += nodes
    total = math.fsum(line.length for line in lines)
    return ContactLines(
        lines=tuple(lines),
        total_length=total,
        accuracy=Accuracy(
            method="Gauss-Legendre quadrature along z, panels graded to the known singularities",
            relative_error=math.fsum(line.relative_error * line.length for line in lines) / total,
            evaluations=evaluations,
        ),
    )


def _line_by_length(
    curve: ContactCurve, roller: RollerByLength, index: int, torque_sign: int | None
) -> tuple[ContactLine, int]:
    z_min, z_max = roller.z_min, roller.z_max
    extent = z_max - z_min
    if not extent > SAME * max(abs(z_min), abs(z_max)):
        raise InvalidInput(f"rollers[{index}].z_max", z_max, "must be larger than {z_min}")
    offset = curve.offset
    start, end = LinePoint(z_min + offset, z_min), LinePoint(z_max + offset, z_max)
    length, curved, nodes = _length(curve, start, end, extent)
    shift = curve.offset_error + ROUNDING * max(abs(start.y), abs(end.y))
    stretches = [curve.steepest_stretch(point.y, shift) for point in (start, end)]
    end_errors = (ROUNDING / 2 * abs(z_min), ROUNDING / 2 * abs(z_max))
    error = (
        (4 * ROUNDING + TRUNCATION) * length
        + curve.width_error * curved
        + shift * curve.stretch_variation(start.y, end.y, shift)
        + end_errors[0] * stretches[0]
        + end_errors[1] * stretches[1]
    )
    angles = curve.polar_angle(np.array([z_min, z_max])).tolist()
    principal = 0 if z_min <= 0 <= z_max else (1 if z_min * curve.sine > 0 else -1)
    flank = 0
    if torque_sign is not None and principal != torque_sign:
        flank = -1 if sum(angles) > 0 else 1
    phi_min, phi_max = sorted(angle + flank * math.pi for angle in angles)
    line = ContactLine(
        position_angle=roller.position_angle,
        z_min=z_min,
        z_max=z_max,
        phi_min=phi_min,
        phi_max=phi_max,
        length=length,
        relative_error=error / length,
        arm_sign=-principal if flank else principal,
        flank=flank,
        start=start,
        end=end,
        extent=extent,
        end_errors=end_errors,
        curve=curve,
    )
    return line, nodes


def _line_by_angle(
    curve: ContactCurve, roller: RollerByAngle, index: int
) -> tuple[ContactLine, int]:
    phi_min, phi_max = roller.phi_min, roller.phi_max
    phi_1 = roller.position_angle
    span = phi_max - phi_min
    if not span > SAME * max(abs(phi_min), abs(phi_max)):
        raise InvalidInput(f"rollers[{index}].phi_max", phi_max, "must be larger than {phi_min}")
    width = curve.width
    sines, errors, points = [], [], []
    for name, phi in (("phi_min", phi_min), ("phi_max", phi_max)):
        sine, cosine = _sine_and_cosine_of_sum(phi, phi_1)
        error = ROUNDING * (abs(phi) + abs(phi_1))
        if abs(sine) <= 4 * error:
            raise InvalidInput(
                f"rollers[{index}].{name}",
                phi,
                "must not lie at a pole, a multiple of half a turn less {position_angle}: "
                "the line is infinitely long there",
            )
        sines.append(sine)
        errors.append(error)
        points.append(LinePoint(width * cosine / sine, -curve.scale * math.sin(phi) / sine))
    if span >= math.pi or sines[0] * sines[1] < 0:
        raise InvalidInput(
            f"rollers[{index}].phi_max",
            phi_max,
            "must lie on the same side of the pole, a multiple of half a turn less "
            "{position_angle}, as {phi_min}: the line is infinitely long there",
        )
    start, end = sorted(points, key=lambda point: point.z)
    extent = abs(width * math.sin(span) / (sines[0] * sines[1]))
    length, curved, nodes = _length(curve, start, end, extent)
    error = (6 * ROUNDING + TRUNCATION) * length + curve.width_error * (length - curved)
    ends = []
    for point, sine, angle_error in zip(points, sines, errors, strict=True):
        slope = abs(width) / (abs(sine) - angle_error) ** 2
        error += 2 * angle_error * math.hypot(curve.roller_radius, slope)
        ends.append((point.z, 2 * angle_error * slope + 3 * ROUNDING * abs(point.z)))
    end_errors = (min(ends)[1], max(ends)[1])
    touches = start.z <= end_errors[0] and end.z >= -end_errors[1]
    phi_start = phi_min if points[0] == start else phi_max
    half_turns = (phi_start - float(curve.polar_angle(np.array(start.z)))) / math.pi
    line = ContactLine(
        position_angle=phi_1,
        z_min=start.z,
        z_max=end.z,
        phi_min=phi_min,
        phi_max=phi_max,
        length=length,
        relative_error=error / length,
        arm_sign=0 if touches else int(math.copysign(1, -math.sin(phi_min))),
        flank=round(half_turns),
        start=start,
        end=end,
        extent=extent,
        end_errors=end_errors,
        curve=curve,
    )
    return line, nodes


def _sine_and_cosine_of_sum(first: float, second: float) -> tuple[float, float]:
    """Sine and cosine of a sum of angles without the rounding of the sum."""
    total = first + second
    part = total - first
    lost = (first - (total - part)) + (second - part)
    sine, cosine = math.sin(total), math.cos(total)
    return sine + lost * cosine, cosine - lost * sine


def _length(
    curve: ContactCurve, start: LinePoint, end: LinePoint, extent: float
) -> tuple[float, float, int]:
    """Length, its change per relative change of the curve's width, and the number of nodes."""
    y, _, weight = curve.nodes(start=start, end=end, extent=extent)
    slope = curve.slope(y)
    stretch = np.hypot(1.0, slope)
    curved = weight * (slope * (slope / stretch))
    return math.fsum((weight * stretch).tolist()), float(curved.sum()), len(y)


@dataclass(frozen=True, slots=True)
class ContactPoints:
    """Points of a contact line, for drawing.

    Attributes
    ----------
    z : array, shape (samples,)
        Along the axis, m, growing.
    phi : array, shape (samples,)
        Polar angle on the roller, rad.
    x : array, shape (samples,)
        Arc ``rho*phi`` of the unrolled roller, m.
    position : array, shape (samples, 3)
        Place in the wheel's frame, m: the roller's axis stands at ``R_C*(-sin, cos)(phi1)``.
    """

    z: FloatArray
    phi: FloatArray
    x: FloatArray
    position: FloatArray


def contact_points(*, line: ContactLine, samples: int = 61) -> ContactPoints:
    """Points of a contact line, denser where it is steep.

    Parameters
    ----------
    line : ContactLine
        The line.
    samples : int
        Number of points, at least 2.

    Returns
    -------
    ContactPoints

    Notes
    -----
    Source: Khatetovsky et al. 2020, eqs (1)-(3) and (21). Erratum: their (24) prints
    ``- (R_C - rho*cos(phi))*cos(phi1)`` in r_1y where their own (21) has a plus sign; with the
    minus the distance from the axis would depend on the frame.
    """
    curve = line.curve
    width = abs(curve.width)
    ends = [math.asinh(point.y / width) for point in (line.start, line.end)]
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
