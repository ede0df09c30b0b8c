"""Line load of the contact lines, and the force and moment that the satellite passes on.

With ``arm = -R_C*sin(phi)`` the direction of the load over its arm is free of angles:

    n_x/arm = A/(R_C*z),   n_y/arm = -y/(R_C*z*sin(phi1)),   y = z + A*cos(phi1)

so that force and moment are integrals of rational functions of z times ds/dz, the same for both
flanks of a roller, and smooth but for z = 0.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, Vector
from core.errors import InvalidInput
from core.precession.contact_line import ContactLine, contact_lines
from core.precession.rollers import Roller
from core.quadrature import TRUNCATION
from core.results import ROUNDING, Accuracy, Notice

SMALL_ARM = 0.1
"""Arm over R_C below which the line load grows so steeply that lines in truth share it."""


@dataclass(frozen=True, slots=True)
class MeshingLoad:
    """Load of the precessional gear's mesh.

    Attributes
    ----------
    force : tuple of float, shape (3,)
        Force F on the satellite and, through it, on the input shaft, N.
    moment : tuple of float, shape (3,)
        Its moment M_C about the point ``z = reference_z`` of the axis, N*m; its z is M1.
    max_line_load : float
        Largest load per length, N/m.
    total_length : float
        Sum of the lengths of the contact lines, m.
    lines : tuple of ContactLine
        The lines, on their loaded flanks.
    force_error, moment_error : float
        Bounds of the error of `force` and `moment`, N and N*m.
    accuracy : Accuracy
        Of `force` over its size, or over M1/R_C where that is larger because the rollers'
        forces cancel out; and of `moment` over its size.
    notices : tuple of Notice
        Assumptions that the load strains.
    """

    force: Vector
    moment: Vector
    max_line_load: float
    total_length: float
    lines: tuple[ContactLine, ...]
    force_error: float
    moment_error: float
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def meshing_load(
    *,
    roller_circle_radius: float,
    roller_radius: float,
    nutation_angle: float,
    ratio_u12: float,
    rollers: Sequence[Roller],
    torque: float,
    reference_z: float,
) -> MeshingLoad:
    """Line load, force and moment of the mesh: ``q = M1/(sum s)/arm`` on every contact line.

    Parameters
    ----------
    roller_circle_radius : float
        Radius R_C of the circle of roller axes, m.
    roller_radius : float
        Radius rho of a roller, m.
    nutation_angle : float
        Nutation angle theta, rad.
    ratio_u12 : float
        Ratio u12 with the input shaft held, dimensionless.
    rollers : sequence of RollerByLength or RollerByAngle
        The rollers in mesh. Limits in z mean the loaded flank; limits in phi name a flank.
    torque : float
        Torque M1 on the central wheel, N*m, not 0; its sign chooses the flanks.
    reference_z : float
        Place l of the point C on the axis, m from the precession centre.

    Returns
    -------
    MeshingLoad

    Raises
    ------
    InvalidInput
        As `contact_lines`; if the torque is 0.
    ImpossibleMechanism
        As `contact_lines`; if a line reaches phi = 0 (z = 0), where its load is unbounded.

    Notes
    -----
    Source: Khatetovsky et al. 2020, eqs (8)-(27). Erratum: (10) prints ``n_y = cos(phi)``; the
    outward normal, and the one of their own (22), (25), (26), has ``-cos(phi)``, with which the
    arm is ``-R_C*sin(phi)`` in every frame turned about the axis.

    Examples
    --------
    >>> from math import radians
    >>> from core.precession.rollers import RollerByLength
    >>> load = meshing_load(
    ...     roller_circle_radius=0.05, roller_radius=0.004, nutation_angle=radians(6),
    ...     ratio_u12=24/25, torque=10.0, reference_z=0.02,
    ...     rollers=[RollerByLength(radians(angle), 0.015, 0.025) for angle in (30, 60, 90, 120)])
    >>> [round(component, 7) for component in load.force]
    [168.7561467, -337.6069542, 0.0]
    >>> [round(component, 10) for component in load.moment]
    [-0.0316199045, -0.0724918335, 10.0]
    """
    if not (torque != 0 and math.isfinite(torque)):
        raise InvalidInput("torque", torque, "must not be 0")
    if not math.isfinite(reference_z):
        raise InvalidInput("reference_z", reference_z, "must be a finite number")
    contacts = contact_lines(
        roller_circle_radius=roller_circle_radius,
        roller_radius=roller_radius,
        nutation_angle=nutation_angle,
        ratio_u12=ratio_u12,
        rollers=rollers,
        torque_sign=1 if torque > 0 else -1,
    )
    factor = torque / contacts.total_length / roller_circle_radius
    shares = [_line_integrals(line, reference_z) for line in contacts.lines]
    integrals = np.array([share[0] for share in shares])
    errors = np.array([share[1] for share in shares])
    x, y, moment_x, moment_y = (factor * math.fsum(column) for column in integrals.T)
    force = (x, y, 0.0)
    moment = (moment_x, moment_y, torque)
    error_x, error_y, error_mx, error_my = (
        abs(factor) * np.sum(errors, axis=0)
        + (contacts.accuracy.relative_error + 3 * ROUNDING) * np.abs([x, y, moment_x, moment_y])
    ).tolist()
    force_error = math.hypot(error_x, error_y)
    moment_error = math.hypot(error_mx, error_my)
    least_arm = min(
        _arm_ratio(line, z) for line in contacts.lines for z in (line.z_min, line.z_max)
    )
    return MeshingLoad(
        force=force,
        moment=moment,
        max_line_load=abs(factor) / least_arm,
        total_length=contacts.total_length,
        lines=contacts.lines,
        force_error=force_error,
        moment_error=moment_error,
        accuracy=Accuracy(
            method=contacts.accuracy.method,
            relative_error=max(
                force_error / max(math.hypot(x, y), abs(torque) / roller_circle_radius),
                moment_error / math.hypot(*moment),
                contacts.accuracy.relative_error,
            ),
            evaluations=contacts.accuracy.evaluations + sum(share[2] for share in shares),
        ),
        notices=_notices(contacts.lines, torque, least_arm),
    )


def line_load(*, load: MeshingLoad, line: ContactLine, z: FloatArray) -> FloatArray:
    """Load per length along a contact line: ``q = M1/(sum s)/(R_C*|sin(phi)|)``.

    Parameters
    ----------
    load : MeshingLoad
        The load.
    line : ContactLine
        One of its lines.
    z : array
        Places along the axis, m.

    Returns
    -------
    array
        N/m, as `z`.
    """
    curve = line.curve
    factor = abs(load.moment[2]) / load.total_length / curve.roller_circle_radius
    q: FloatArray = factor * np.hypot(z + curve.offset, curve.width) / np.abs(z * curve.sine)
    return q


def _arm_ratio(line: ContactLine, z: float) -> float:
    """Arm over R_C, |sin(phi)|: along a line it is least at one of the ends."""
    curve = line.curve
    return abs(z * curve.sine) / math.hypot(z + curve.offset, curve.width)


def _directions(line: ContactLine, y: FloatArray, z: FloatArray, reference_z: float) -> FloatArray:
    """``R_C*(n_x, n_y, -n_y*(z - l), n_x*(z - l))/arm`` at places of a line, shape (4, n)."""
    along = line.curve.scale / z
    across = -y / (z * line.curve.sine)
    lever = z - reference_z
    return np.stack((along, across, -across * lever, along * lever))


def _line_integrals(line: ContactLine, reference_z: float) -> tuple[FloatArray, FloatArray, int]:
    """Integrals of `_directions` over a line, their absolute errors, and the number of nodes.

    The errors are those of rounding, of the curve's width, of the line's limits and of the
    curve's place: where the stretch f = ds/dz moves along z under the rest h of the integrand,
    the integral changes by ``[h*f] - integral h'*f``.
    """
    curve = line.curve
    y, z, weight = curve.nodes(start=line.start, end=line.end, extent=line.extent, loaded=True)
    slope = curve.slope(y)
    stretch = np.hypot(1.0, slope)
    length = weight * stretch
    directions = _directions(line, y, z, reference_z)
    integrals = np.array([math.fsum(row) for row in (directions * length).tolist()])

    size = np.abs(directions)
    total = size @ length
    curved = size @ (weight * slope * (slope / stretch))
    shift = curve.offset_error + ROUNDING * max(abs(line.start.y), abs(line.end.y))
    place_y, place_z = np.array((line.start, line.end)).T
    ends = np.abs(_directions(line, place_y, place_z, reference_z))
    steepest = np.array(
        [curve.steepest_stretch(point.y, shift) for point in (line.start, line.end)]
    )

    inverse = float(length @ (1 / np.abs(z)))
    inverse_square = float(length @ (1 / (z * z)))
    scale, sine, offset, level = (
        abs(value) for value in (curve.scale, curve.sine, curve.offset, reference_z)
    )
    # h' and, of the terms with y, the change of y itself, which moves with the curve
    moving = np.array(
        [
            scale * inverse_square,
            (offset * inverse_square + inverse) / sine,
            (2 * line.length + level * inverse + offset * level * inverse_square) / sine,
            scale * level * inverse_square,
        ]
    )
    # the lever z - l carries a rounding of its own
    lever_error = ROUNDING * max(abs(line.z_min), abs(line.z_max), level)
    lever = lever_error * np.array([0.0, 0.0, total[1], scale * inverse])
    sine_error = ROUNDING * abs(curve.position_angle / math.tan(curve.position_angle))
    factor_error = np.array([curve.scale_error, sine_error, sine_error, curve.scale_error])
    errors = (
        (6 * ROUNDING + TRUNCATION + factor_error) * total
        + curve.width_error * curved
        + shift * (ends @ steepest + moving)
        + lever
        + ends @ (steepest * np.array(line.end_errors))
    )
    return integrals, errors, len(y)


def _notices(lines: tuple[ContactLine, ...], torque: float, least_arm: float) -> tuple[Notice, ...]:
    found = [
        Notice(
            code="unloaded_flank",
            detail=f"The limits of roller {index + 1} lie on the flank that the torque unloads: "
            "the loaded one is half a turn of phi further, with the same force.",
            value=float(line.arm_sign),
            limit=math.copysign(1.0, torque),
        )
        for index, line in enumerate(lines)
        if line.arm_sign * torque < 0
    ]
    if least_arm < SMALL_ARM:
        found.append(
            Notice(
                code="small_arm",
                detail="A contact line comes close to phi = 0, where the load has no arm: the "
                "line load is concentrated there, more than elastic rollers would let it be.",
                value=least_arm,
                limit=SMALL_ARM,
            )
        )
    return tuple(found)
