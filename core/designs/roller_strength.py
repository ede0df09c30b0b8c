"""Strength of swinging rollers for arrays of designs; see `core.roller_strength`."""

import math
from dataclasses import dataclass

import numpy as np

from core.contact_force import FloatArray, IntArray
from core.designs.checks import check_finite, check_not_negative, check_positive
from core.results import ROUNDING
from core.roller_curves import relative_stiffness


@dataclass(frozen=True, slots=True)
class RollerStrengths:
    """Load sharing and strength of rollers, arrays of shape (n,).

    Attributes
    ----------
    stiffness, relative_stiffness : array
        Stiffness c of one end of a roller, N/m, and ``c/(b*E)``, dimensionless.
    mean_force : array
        Mean force on one end of a roller, N.
    relative_position_error, load_nonuniformity : array
        delta, that of the tolerance with the same mean gap, and Psi, dimensionless.
    max_force, centre_force : array
        Largest force F_1 on one end of a roller and ``2*F_1`` on its middle, N.
    forces : array, shape (n, rollers)
        Force on one end of each roller, N.
    displacement : array
        Displacement of the disc's holes from the zero of the gaps, m.
    bending_moment, bending_stress : array
        Of the most loaded roller beside its middle sphere, N*m and Pa.
    loaded_rollers : array of int
        Number of rollers that carry a force.
    deflection_ratio : array
        Deflection of the most loaded roller over its length, dimensionless: above
        `core.roller_strength.LARGE_DEFLECTION` the beam is bent too much for the formulas.
    relative_error : array
        Of every number against its own size, of single forces against the largest.
    """

    stiffness: FloatArray
    relative_stiffness: FloatArray
    mean_force: FloatArray
    relative_position_error: FloatArray
    load_nonuniformity: FloatArray
    max_force: FloatArray
    centre_force: FloatArray
    forces: FloatArray
    displacement: FloatArray
    bending_moment: FloatArray
    bending_stress: FloatArray
    loaded_rollers: IntArray
    deflection_ratio: FloatArray
    relative_error: FloatArray


def roller_strengths(
    *,
    output_torque: FloatArray,
    hole_circle_radius: FloatArray,
    cylinder_length: FloatArray,
    sphere_width: FloatArray,
    sphere_diameter: FloatArray,
    diameter: FloatArray,
    friction_coefficient: FloatArray,
    youngs_modulus: FloatArray,
    modulus_ratio: FloatArray,
    stress_concentration: FloatArray,
    gaps: FloatArray,
) -> RollerStrengths:
    """Forces, displacement and bending stress of the swinging rollers of many designs.

    Parameters
    ----------
    output_torque : array, shape (n,)
        Output torque T, N*m, > 0.
    hole_circle_radius, cylinder_length, sphere_width, sphere_diameter, diameter : array, (n,)
        Sizes R, l, b, D, d, m, > 0.
    friction_coefficient : array, shape (n,)
        Friction coefficient k of sphere and hole, >= 0.
    youngs_modulus : array, shape (n,)
        Young's modulus E, Pa, > 0.
    modulus_ratio : array, shape (n,)
        E/G, dimensionless: ``2*(1 + mu)``, > 0.
    stress_concentration : array, shape (n,)
        Stress concentration factor K_sigma, > 0.
    gaps : array, shape (n, rollers)
        Gap of each roller, m; ``0, 4*chi, ..., 4*chi`` for a position tolerance chi.

    Returns
    -------
    RollerStrengths

    Raises
    ------
    InvalidInput
        If an entry is out of range; its index is named.

    Notes
    -----
    Source: as `core.roller_strength.roller_strength`.

    Examples
    --------
    The source's fig. 6 at l/d = 2, chi/d = 2e-4: sigma/E.

    >>> one = np.ones(1)
    >>> found = roller_strengths(
    ...     output_torque=0.001*210e9*0.01**3*one, hole_circle_radius=0.03*one,
    ...     cylinder_length=0.02*one, sphere_width=0.008*one, sphere_diameter=0.015*one,
    ...     diameter=0.01*one, friction_coefficient=0.16*one, youngs_modulus=210e9*one,
    ...     modulus_ratio=2.6*one, stress_concentration=2*one,
    ...     gaps=np.array([[0, 8e-6, 8e-6, 8e-6]]))
    >>> (found.bending_stress/210e9).round(13).tolist()
    [0.0024213655009]
    """
    check_positive(
        output_torque=output_torque,
        hole_circle_radius=hole_circle_radius,
        cylinder_length=cylinder_length,
        sphere_width=sphere_width,
        sphere_diameter=sphere_diameter,
        diameter=diameter,
        youngs_modulus=youngs_modulus,
        modulus_ratio=modulus_ratio,
        stress_concentration=stress_concentration,
    )
    check_not_negative(friction_coefficient=friction_coefficient)
    check_finite(gaps=gaps)
    relative = relative_stiffness(
        relative_length=cylinder_length / diameter,
        relative_width=sphere_width / diameter,
        relative_sphere=sphere_diameter / diameter,
        friction_coefficient=friction_coefficient,
        modulus_ratio=modulus_ratio,
    )
    stiffness = relative * sphere_width * youngs_modulus
    total = output_torque / hole_circle_radius / 2
    rollers = gaps.shape[1]
    mean_force = total / rollers
    forces, displacement, closed = _shared(total, stiffness, gaps)
    max_force = forces.max(axis=1)
    spread = (gaps - gaps.min(axis=1, keepdims=True)).sum(axis=1)
    arm = cylinder_length + sphere_width / 2 + friction_coefficient * sphere_diameter / 2
    moment = arm * max_force
    return RollerStrengths(
        stiffness=stiffness,
        relative_stiffness=relative,
        mean_force=mean_force,
        relative_position_error=stiffness * spread / (4 * max(rollers - 1, 1)) / mean_force,
        load_nonuniformity=max_force / mean_force,
        max_force=max_force,
        centre_force=2 * max_force,
        forces=forces,
        displacement=displacement,
        bending_moment=moment,
        bending_stress=stress_concentration * 32 / math.pi * (moment / diameter**2 / diameter),
        loaded_rollers=(forces > 0).sum(axis=1),
        deflection_ratio=max_force / stiffness / cylinder_length,
        relative_error=ROUNDING * (19 + closed.astype(np.float64)),
    )


def _shared(
    total: FloatArray, stiffness: FloatArray, gaps: FloatArray
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Forces, displacement and number of closed contacts; as `core.load_sharing.share_load`."""
    closing = np.sort(gaps, axis=1)
    remaining = total / stiffness
    closed = np.ones(len(total), dtype=np.intp)
    going = np.ones(len(total), dtype=np.bool_)
    for contact in range(1, gaps.shape[1]):
        used = contact * (closing[:, contact] - closing[:, contact - 1])
        going &= (used <= 0) | (used < remaining)
        if not going.any():
            break
        remaining = np.where(going, remaining - used, remaining)
        closed += going
    last = np.take_along_axis(closing, closed[:, None] - 1, axis=1)
    rest = remaining / closed
    open_ = gaps > last
    forces = stiffness[:, None] * (rest[:, None] + (last - gaps))
    forces[open_] = 0.0
    return forces, last[:, 0] + rest, closed
