"""Line load of the contact lines, and the force and moment that the satellite passes on.

With ``arm = -R_C*sin(phi)`` the direction of the load over its arm is free of angles:

    n_x/arm = A/(R_C*z),   n_y/arm = -y/(R_C*z*sin(phi1)),   y = z + A*cos(phi1)

Force and moment are thus integrals of rational functions of z times ds/dz, equal for both flanks of
a roller and smooth except at z = 0.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, Vector, check_finite
from core.errors import Accuracy, InvalidInput, Notice, poorly_known
from core.fields import answer
from core.precession.contact_line import ContactLine, contact_lines
from core.precession.rollers import Roller
from core.precision import ROUNDING

SMALL_ARM = 0.1
"""Arm over R_C below which the line load grows so steeply that real lines share it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MeshingLoad:
    """Load of the precessional gear's mesh."""

    force: Vector = answer("N", "F", "2020, eq. 12 to 14")
    """Force on the wheel, X, Y, Z."""
    moment: Vector = answer("Nm", "M_C", "2020, eq. 15 to 17")
    """Moment about the point C, X, Y, Z."""
    max_line_load: float = answer("N_per_mm", "q", "2020, eq. 8")
    """Largest force per length of the contact lines."""
    total_length: float = answer("mm", "Σs", "2020, eq. 4")
    """Length of all contact lines together."""
    lines: tuple[ContactLine, ...]  # lines on their loaded flanks
    force_error: float  # bound of the error of `force`, N
    moment_error: float  # bound of the error of `moment`, N*m
    # Largest relative error of `moment`, `max_line_load`, `total_length` and `force`; the error of
    # the force is over M1/R_C if that is larger, as the rollers' forces may cancel.
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer()


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
    """Line load ``q = M1/(sum s)/arm`` on every contact line, and force and moment of the mesh.

    Parameters not listed and refusals are those of `contact_lines`; a line must not reach z = 0,
    where its load is unbounded. Source: Khatetovsky et al. 2020, eqs (8)-(27). Erratum: (10) and
    the middle step of (22) print ``n_y = cos(phi)``; the outward normal, also that of (25) and
    (26), has ``-cos(phi)``, with which the arm is ``-R_C*sin(phi)`` in every frame turned about the
    axis. Limits in z mean the loaded flank, limits in phi name a flank; the sign of the torque M1
    on the central wheel, N*m, selects the loaded flanks; C lies on the axis at l = `reference_z`, m
    from the precession centre.

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
        raise InvalidInput("torque", torque, "not_zero")
    check_finite(reference_z=reference_z)
    contacts = contact_lines(
        roller_circle_radius=roller_circle_radius,
        roller_radius=roller_radius,
        nutation_angle=nutation_angle,
        ratio_u12=ratio_u12,
        rollers=rollers,
        torque_sign=1 if torque > 0 else -1,
    )
    factor = torque / contacts.total_length / roller_circle_radius
    integrals = [_integrals(line, reference_z) for line in contacts.lines]
    *sums, force_error, moment_error = map(math.fsum, zip(*integrals, strict=True))
    x, y, about_x, about_y = (factor * each for each in sums)
    force, moment = (x, y, 0.0), (about_x, about_y, torque)
    arms = [_inverse_arms(line) for line in contacts.lines]
    peak = max(float(inverse.max()) for inverse, _ in arms)

    factor_error = float(contacts.accuracy.relative_error) + 4 * ROUNDING
    force_error = factor_error * math.hypot(x, y) + abs(factor) * force_error
    moment_error = factor_error * math.hypot(about_x, about_y) + abs(factor) * moment_error
    peak_error = max(float((inverse * error).max()) for inverse, error in arms)
    accuracy = Accuracy(
        method=contacts.accuracy.method,
        relative_error=max(
            force_error / max(math.hypot(x, y), abs(torque) / roller_circle_radius),
            moment_error / math.hypot(*moment),
            factor_error + peak_error / peak,
        ),
        evaluations=contacts.accuracy.evaluations,
    )
    return MeshingLoad(
        force=force,
        moment=moment,
        max_line_load=abs(factor) * peak,
        total_length=contacts.total_length,
        lines=contacts.lines,
        force_error=force_error,
        moment_error=moment_error,
        accuracy=accuracy,
        notices=_notices(contacts.lines, torque, 1 / peak) + poorly_known(accuracy),
    )


def line_load(*, load: MeshingLoad, line: ContactLine, z: FloatArray) -> FloatArray:
    """Line load, N/m, at places z, m, of a contact line: ``q = M1/(sum s)/(R_C*|sin(phi)|)``."""
    curve = line.curve
    factor = abs(load.moment[2]) / load.total_length / curve.roller_circle_radius
    q: FloatArray = factor * np.hypot(z + curve.offset, curve.width) / np.abs(z * curve.sine)
    return q


def _inverse_arms(line: ContactLine) -> tuple[FloatArray, FloatArray]:
    """``R_C/|arm| = 1/|sin(phi)|`` at a line's nodes, largest at an end, and its relative error."""
    curve, at = line.curve, line.places
    distance, z = np.hypot(at.y, curve.width), np.abs(at.z)
    place_error = at.z_error / z + at.z_error / distance
    return distance / (z * abs(curve.sine)), at.direction_error + place_error + 4 * ROUNDING


def _integrals(line: ContactLine, reference_z: float) -> list[float]:
    """Integrals of ``R_C*(n_x, n_y, -n_y*(z - l), n_x*(z - l))/arm`` over ds, eqs (12) to (16),
    then the error of the first two together and of the other two together.
    """
    curve, at = line.curve, line.places
    n_x, n_y = curve.scale / at.z, -at.y / (at.z * curve.sine)
    lever = at.z - reference_z

    size, error = _inverse_arms(line)  # size of (n_x, n_y)
    force_error = size * (at.ds_error + error * at.ds)
    growth_error = curve.scale_error if line.limits.in_phi else 0.0
    lever_error = at.z_error + growth_error * np.abs(at.z) + ROUNDING * abs(reference_z)
    moment_error = force_error * np.abs(lever) + size * lever_error * at.ds
    rows = (n_x * at.ds, n_y * at.ds, -n_y * lever * at.ds, n_x * lever * at.ds)
    return [math.fsum(row) for row in np.stack((*rows, force_error, moment_error)).tolist()]


def _notices(lines: tuple[ContactLine, ...], torque: float, least_arm: float) -> tuple[Notice, ...]:
    found = [
        Notice("unloaded_flank", {"roller": index + 1})
        for index, line in enumerate(lines)
        if line.arm_sign * torque < 0
    ]
    if least_arm < SMALL_ARM:
        found.append(Notice("small_arm"))
    return tuple(found)
