"""Swinging rollers of the output mechanism: stiffness, load sharing and bending stress.

A roller has a sphere in the middle, in the satellite, and one at each end, in the discs, joined
by two cylinders. Each half is a cantilever of length l, clamped at the middle sphere; the disc
presses on the end sphere, b/2 beyond the cylinder, and its friction turns the end.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from core.errors import InvalidInput
from core.load_sharing import share_load
from core.results import ROUNDING, Accuracy, Notice
from core.rollers.roller_curves import relative_stiffness

SHORT_ROLLER = 1.0
"""Length over diameter below which the shear and the clamping outweigh beam bending."""

LARGE_DEFLECTION = 0.1
"""Deflection over length above which the small-deflection beam is off by about 1 %."""


@dataclass(frozen=True, slots=True)
class RollerStrength:
    """Load sharing and strength of the swinging rollers.

    Attributes
    ----------
    stiffness : float
        Stiffness c of one end of a roller, N/m.
    relative_stiffness : float
        ``c/(b*E)``, dimensionless.
    mean_force : float
        Mean force F_avg on one end of a roller, N.
    relative_position_error : float
        delta, dimensionless: ``c*chi/F_avg``; for a list of gaps, that of the tolerance with
        the same mean gap.
    load_nonuniformity : float
        Psi: largest force over the mean one, from 1 to the number of rollers.
    max_force : float
        Largest force F_1 on one end of a roller, N.
    centre_force : float
        Force ``F_0 = 2*F_1`` on the middle of that roller, N.
    forces : tuple of float
        Force on one end of each roller, N. With a tolerance the first is the roller ahead.
    displacement : float
        Displacement Delta of the disc's holes against the satellite's, m, from the zero of the
        gaps; with a tolerance, from the first contact.
    bending_moment : float
        Bending moment of the most loaded roller beside its middle sphere, N*m.
    bending_stress : float
        Stress there, Pa.
    loaded_rollers : int
        Number of rollers that carry a force.
    accuracy : Accuracy
        Of every number against its own size, of single forces against the largest.
    notices : tuple of Notice
        Assumptions that the rollers strain.
    """

    stiffness: float
    relative_stiffness: float
    mean_force: float
    relative_position_error: float
    load_nonuniformity: float
    max_force: float
    centre_force: float
    forces: tuple[float, ...]
    displacement: float
    bending_moment: float
    bending_stress: float
    loaded_rollers: int
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def roller_strength(
    *,
    output_torque: float,
    hole_circle_radius: float,
    rollers: int,
    cylinder_length: float,
    sphere_width: float,
    sphere_diameter: float,
    diameter: float,
    friction_coefficient: float,
    youngs_modulus: float,
    poissons_ratio: float | None = None,
    shear_modulus: float | None = None,
    stress_concentration: float = 1.0,
    position_tolerance: float | None = None,
    gaps: Sequence[float] | None = None,
) -> RollerStrength:
    """Forces, displacement and bending stress of swinging rollers.

    ``F_i = c*max(0, Delta - g_i)`` with ``sum F_i = T/(2*R)``; the worst case of a position
    tolerance chi is one roller ahead of the others by ``4*chi``, for which
    ``Psi = min(n, 1 + 4*(n - 1)/n*delta)``. ``M = (l + b/2 + k*D/2)*F_1``,
    ``sigma = K_sigma*M/(pi*d^3/32)``.

    Parameters
    ----------
    output_torque : float
        Output torque T, N*m, > 0.
    hole_circle_radius : float
        Radius R of the circle of holes, m.
    rollers : int
        Number n of rollers, >= 1.
    cylinder_length : float
        Length l of the cylinder between two spheres, m.
    sphere_width : float
        Width b of a sphere, m.
    sphere_diameter : float
        Diameter D of a sphere, m.
    diameter : float
        Diameter d of the cylinder, m.
    friction_coefficient : float
        Friction coefficient k of sphere and hole, >= 0.
    youngs_modulus : float
        Young's modulus E, Pa.
    poissons_ratio : float, optional
        Poisson's ratio mu, 0 <= mu < 0.5; this or `shear_modulus`.
    shear_modulus : float, optional
        Shear modulus G, Pa; this or `poissons_ratio`.
    stress_concentration : float
        Stress concentration factor K_sigma, > 0.
    position_tolerance : float, optional
        Position tolerance chi of the holes, m, >= 0: the source's worst case. This or `gaps`.
    gaps : sequence of float, optional
        Gap g_i of each roller, m; only differences matter. This or `position_tolerance`.

    Returns
    -------
    RollerStrength

    Raises
    ------
    InvalidInput
        If a size is not positive, or not exactly one of each pair of alternatives is given.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, eqs (1)-(9). Errata: (11)-(13) print the number of rollers
    only before the bending part of the compliance; by (6) with (9) it multiplies the shear part
    too. As printed the stress is up to 9 % too high for short rollers. The source's limit for
    one roller carrying everything, delta = 1, is ``n/4`` for its n = 4.

    Examples
    --------
    The source's fig. 6 at l/d = 2, chi/d = 2e-4: sigma/E.

    >>> result = roller_strength(
    ...     output_torque=0.001*210e9*0.01**3, hole_circle_radius=0.03, rollers=4,
    ...     cylinder_length=0.02, sphere_width=0.008, sphere_diameter=0.015, diameter=0.01,
    ...     friction_coefficient=0.16, youngs_modulus=210e9, poissons_ratio=0.3,
    ...     stress_concentration=2.0, position_tolerance=2e-6)
    >>> round(result.bending_stress/210e9, 13)
    0.0024213655009
    """
    for name, value in (
        ("output_torque", output_torque),
        ("hole_circle_radius", hole_circle_radius),
        ("cylinder_length", cylinder_length),
        ("sphere_width", sphere_width),
        ("sphere_diameter", sphere_diameter),
        ("diameter", diameter),
        ("youngs_modulus", youngs_modulus),
        ("stress_concentration", stress_concentration),
    ):
        if not value > 0:
            raise InvalidInput(name, value, "must be larger than 0")
    if rollers < 1:
        raise InvalidInput("rollers", rollers, "must be at least 1")
    if not friction_coefficient >= 0:
        raise InvalidInput("friction_coefficient", friction_coefficient, "must not be negative")
    ratio = modulus_ratio(
        youngs_modulus=youngs_modulus, poissons_ratio=poissons_ratio, shear_modulus=shear_modulus
    )
    relative = relative_stiffness(
        relative_length=cylinder_length / diameter,
        relative_width=sphere_width / diameter,
        relative_sphere=sphere_diameter / diameter,
        friction_coefficient=friction_coefficient,
        modulus_ratio=ratio,
    )
    stiffness = relative * sphere_width * youngs_modulus
    total = output_torque / hole_circle_radius / 2
    mean_force = total / rollers
    closing = roller_gaps(rollers=rollers, position_tolerance=position_tolerance, gaps=gaps)
    sharing = share_load(total=total, stiffness=stiffness, gaps=closing)
    max_force = max(sharing.forces)
    if position_tolerance is not None:
        delta = stiffness * position_tolerance / mean_force
    else:
        first = min(closing)
        spread = math.fsum(gap - first for gap in closing)
        delta = stiffness * spread / (4 * max(rollers - 1, 1)) / mean_force
    arm = cylinder_length + sphere_width / 2 + friction_coefficient * sphere_diameter / 2
    moment = arm * max_force
    return RollerStrength(
        stiffness=stiffness,
        relative_stiffness=relative,
        mean_force=mean_force,
        relative_position_error=delta,
        load_nonuniformity=max_force / mean_force,
        max_force=max_force,
        centre_force=2 * max_force,
        forces=sharing.forces,
        displacement=sharing.displacement,
        bending_moment=moment,
        bending_stress=stress_concentration * 32 / math.pi * (moment / diameter**2 / diameter),
        loaded_rollers=sharing.loaded,
        accuracy=Accuracy(
            method="closed form, contacts closed in the order of their gaps",
            # products of positive sums: the roundings, and those of the input, add up
            relative_error=sharing.relative_error + 16 * ROUNDING,
            evaluations=1,
        ),
        notices=strained_assumptions(
            length_ratio=cylinder_length / diameter,
            sphere_ratio=sphere_diameter / diameter,
            width_ratio=sphere_width / sphere_diameter,
            deflection_ratio=max_force / stiffness / cylinder_length,
        ),
    )


def modulus_ratio(
    *, youngs_modulus: float, poissons_ratio: float | None, shear_modulus: float | None
) -> float:
    """Ratio ``E/G``: ``2*(1 + mu)``, or from a shear modulus of its own.

    Parameters
    ----------
    youngs_modulus : float
        Young's modulus E, Pa.
    poissons_ratio : float or None
        Poisson's ratio mu, 0 <= mu < 0.5.
    shear_modulus : float or None
        Shear modulus G, Pa.

    Returns
    -------
    float
        Dimensionless.

    Raises
    ------
    InvalidInput
        If not exactly one of the two is given, or it is out of range.
    """
    if shear_modulus is None and poissons_ratio is None:
        raise InvalidInput("poissons_ratio", None, "or {shear_modulus} must be given")
    if shear_modulus is None and poissons_ratio is not None:
        if not 0 <= poissons_ratio < 0.5:
            raise InvalidInput("poissons_ratio", poissons_ratio, "must be at least 0 and below 0.5")
        return 2 * (1 + poissons_ratio)
    if poissons_ratio is not None or shear_modulus is None:
        raise InvalidInput(
            "shear_modulus", shear_modulus, "and {poissons_ratio} exclude each other"
        )
    if not shear_modulus > 0:
        raise InvalidInput("shear_modulus", shear_modulus, "must be larger than 0")
    return youngs_modulus / shear_modulus


def roller_gaps(
    *, rollers: int, position_tolerance: float | None, gaps: Sequence[float] | None
) -> Sequence[float]:
    """Gap of each roller: as given, or those of the worst case of a position tolerance chi, one
    roller ahead of the others by ``4*chi``.

    Parameters
    ----------
    rollers : int
        Number n of rollers.
    position_tolerance : float or None
        Position tolerance chi of the holes, m, >= 0; this or `gaps`.
    gaps : sequence of float or None
        Gap g_i of each roller, m; this or `position_tolerance`.

    Returns
    -------
    sequence of float
        n gaps, m.

    Raises
    ------
    InvalidInput
        If not exactly one of the two is given, or there is not one gap for each roller.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, before eq. (5).
    """
    if gaps is not None:
        if position_tolerance is not None:
            raise InvalidInput("gaps", gaps, "and {position_tolerance} exclude each other")
        if len(gaps) != rollers:
            raise InvalidInput("gaps", gaps, "must have one entry for each of the {rollers}")
        return gaps
    if position_tolerance is None:
        raise InvalidInput("position_tolerance", None, "or {gaps} must be given")
    if not position_tolerance >= 0:
        raise InvalidInput("position_tolerance", position_tolerance, "must not be negative")
    return [0.0] + [4 * position_tolerance] * (rollers - 1)


def strained_assumptions(
    *, length_ratio: float, sphere_ratio: float, width_ratio: float, deflection_ratio: float
) -> tuple[Notice, ...]:
    """Assumptions that rollers strain.

    Parameters
    ----------
    length_ratio, sphere_ratio : float
        Length of the cylinder and diameter of the sphere over the cylinder's diameter.
    width_ratio : float
        Width of the sphere over its diameter.
    deflection_ratio : float
        Deflection of the most loaded roller over its length.

    Returns
    -------
    tuple of Notice
    """
    found = []
    if length_ratio < SHORT_ROLLER:
        found.append(
            Notice(
                code="short_roller",
                detail="{cylinder_length} is shorter than {diameter}: a beam that short deforms "
                "mostly by shear and at its clamping, so the stiffness is a rough guide.",
                value=length_ratio,
                limit=SHORT_ROLLER,
            )
        )
    if sphere_ratio < 1:
        found.append(
            Notice(
                code="sphere_below_roller",
                detail="{sphere_diameter} is smaller than {diameter}: the formulas take the "
                "sphere for rigid and the cylinder for the weak section.",
                value=sphere_ratio,
                limit=1.0,
            )
        )
    if width_ratio > 1:
        found.append(
            Notice(
                code="sphere_too_wide",
                detail="{sphere_width} exceeds {sphere_diameter}: no sphere is wider than that.",
                value=width_ratio,
                limit=1.0,
            )
        )
    if deflection_ratio > LARGE_DEFLECTION:
        found.append(
            Notice(
                code="large_deflection",
                detail="The most loaded roller bends by more than a tenth of {cylinder_length}: "
                "the formulas are those of small deflections.",
                value=deflection_ratio,
                limit=LARGE_DEFLECTION,
            )
        )
    return tuple(found)
