"""Swinging rollers of the output mechanism: stiffness, load sharing and bending stress.

A roller has a sphere in the middle, in the disc, and a sphere at each end, in the satellites; two
cylinders join the spheres. Each half is a cantilever of length l, clamped at the middle sphere. The
satellite presses on the end sphere, b/2 beyond the cylinder, and its friction turns the end.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from core.arrays import (
    IntArray,
    Number,
    ascending,
    check_count,
    check_not_negative,
    check_positive,
    smaller,
)
from core.errors import Accuracy, InvalidInput, Notice, poorly_known
from core.fatigue import CycleFatigue, FatigueStrength, judge_cycle
from core.fields import answer, answered
from core.hertz import check_poissons_ratio
from core.load_sharing import share_load
from core.precision import ROUNDING

SHEAR_FACTOR = 1.11
"""Shear factor of a round section, which the source rounds from 10/9."""

SHORT_ROLLER = 1.0
"""Length over diameter below which the shear and the clamping outweigh beam bending."""

LARGE_DEFLECTION = 0.1
"""Deflection over length above which the small-deflection beam is off by about 1 %."""


@dataclass(frozen=True, slots=True)
class PositionTolerance:
    """Tolerance chi of hole positions; in the worst case one roller is ahead by ``4*chi``."""

    tolerance: Number  # chi, m, >= 0

    def gaps(self, rollers: int) -> Sequence[Number]:
        """Gap of each roller in the worst case, m (Ovsyannikov et al. 2019, before eq. (5))."""
        check_not_negative(position_tolerance=self.tolerance)
        return [0.0] + [4 * self.tolerance] * (rollers - 1)

    def relative_error(self, *, stiffness: Number, mean_force: Number) -> Number:
        """Relative position error ``delta = c*chi/F_avg``."""
        return stiffness * self.tolerance / mean_force


@dataclass(frozen=True, slots=True)
class GivenGaps:
    """Measured gaps of the rollers."""

    each: Sequence[Number]  # gap g_i of each roller, m; only differences matter

    def gaps(self, rollers: int) -> Sequence[Number]:
        """Gap of each roller, m; InvalidInput is raised if there is not one for each."""
        check_count(rollers, gaps=self.each)
        return self.each

    def relative_error(self, *, stiffness: Number, mean_force: Number) -> Number:
        """Relative position error delta of the tolerance with an equal mean gap."""
        first = ascending(self.each)[0]
        spread = sum([gap - first for gap in self.each])
        return stiffness * spread / (4 * max(len(self.each) - 1, 1)) / mean_force


Spacing = PositionTolerance | GivenGaps
"""Position errors of the rollers' holes."""


@dataclass(frozen=True, slots=True)
class ByPoissonsRatio:
    """Shear of a material by its Poisson's ratio mu, 0 <= mu < 0.5."""

    poissons_ratio: Number  # mu

    def modulus_ratio(self, youngs_modulus: Number) -> Number:
        """Ratio of moduli ``E/G = 2*(1 + mu)``."""
        check_poissons_ratio(self.poissons_ratio)
        return 2 * (1 + self.poissons_ratio)


@dataclass(frozen=True, slots=True)
class ByShearModulus:
    """Shear of a material by its shear modulus."""

    shear_modulus: Number  # G, Pa

    def modulus_ratio(self, youngs_modulus: Number) -> Number:
        """Ratio of moduli E/G."""
        check_positive(shear_modulus=self.shear_modulus)
        return youngs_modulus / self.shear_modulus


Shear = ByPoissonsRatio | ByShearModulus
"""Material constant that gives the shear."""

KINDS: dict[str, dict[str, Callable[[Any], Spacing | Shear]]] = {
    "spacing": {"position_tolerance": PositionTolerance, "gaps": GivenGaps},
    "shear": {"poissons_ratio": ByPoissonsRatio, "shear_modulus": ByShearModulus},
}
"""Classes for an argument of `roller_strength`, by argument and by the input's name."""


def roller_arguments(**given: Any) -> dict[str, Any]:
    """Arguments of `roller_strength` from named inputs; InvalidInput for two of one kind."""
    made = dict(given)
    for argument, kinds in KINDS.items():
        for name in kinds:
            if name in given and argument in made:
                (other,) = kinds.keys() - {name}
                raise InvalidInput(name, given[name], "only_one", field=other)
            if name in given:
                made[argument] = kinds[name](made.pop(name))
    return made


@dataclass(frozen=True, slots=True)
class RollerShape:
    """Sizes of a roller over the diameter of its cylinder."""

    length: Number  # l/d of the cylinder between two spheres
    width: Number  # b/d of a sphere
    sphere: Number  # D/d of a sphere

    def relative_stiffness(self, *, friction_coefficient: Number, modulus_ratio: Number) -> Number:
        """Relative stiffness ``c/(b*E)`` of one end of a roller, dimensionless.

        With l, b, D for l/d, b/d, D/d the compliance is the sum of
        ``64*b*l/pi*((k*D + b)*l/4 + l^2/3 + b*(l + k*D + b)/4)`` and
        ``4*1.11*b*(E/G)/pi*(l + b/2)``. Source: Ovsyannikov et al. 2019, eq. (10), fig. 4. k is the
        friction coefficient, E/G the ratio of moduli.

        >>> shape = RollerShape(length=2.0, width=0.8, sphere=1.5)
        >>> round(shape.relative_stiffness(friction_coefficient=0.16, modulus_ratio=210/78), 9)
        0.011424309
        """
        length, width = self.length, self.width
        end = friction_coefficient * self.sphere + width
        bending = end * length / 4 + length * length / 3 + width * (length + end) / 4
        shear = SHEAR_FACTOR * modulus_ratio * (length + width / 2)
        return math.pi / (width * (64 * length * bending + 4 * shear))


@dataclass(frozen=True, slots=True, kw_only=True)
class RollerStrength:
    """Load sharing and strength of swinging rollers of one design or of an array of designs."""

    stiffness: Number = answer("N_per_mm", "c", "2019, eq. 9")
    """Stiffness of a roller."""
    relative_stiffness: Number = answer("", "c/(bE)", "2019, eq. 10")
    """Stiffness over width of the sphere and modulus."""
    mean_force: Number = answer("N", "F_avg", "2019, eq. 2")
    """Mean force of a roller."""
    relative_position_error: Number = answer("", "δ", "2019, eq. 6")
    """Stiffness times position tolerance over mean force."""
    load_nonuniformity: Number = answer("", "Ψ", "2019, eq. 6")
    """Largest force over mean force."""
    max_force: Number = answer("N", "F_1", "2019, eq. 2, 11")
    """Largest force of a roller."""
    centre_force: Number = answer("N", "F_0", "2019, eq. 2")
    """Force on the middle sphere of the roller with the largest force."""
    forces: tuple[Number, ...] = answer("N", "F_i", "2019, eq. 5")
    """Force of each roller."""
    displacement: Number = answer("mm", "Δ", "2019, eq. 5")
    """Displacement of the disc's holes against the satellites'."""
    bending_moment: Number = answer("Nm", "M", "2019, eq. 4")
    """Bending moment at the middle sphere."""
    bending_stress: Number = answer("MPa", "σ", "2019, eq. 12")
    """Bending stress at the middle sphere."""
    relative_stress: Number = answer("", "σ/E", "2019, fig. 6")
    """Bending stress over the modulus of elasticity."""
    loaded_rollers: int | IntArray = answer()
    """Number of rollers that carry."""
    shape: RollerShape  # relative sizes
    deflection_ratio: Number  # deflection of the most loaded roller over its length
    # Error relative to each number; for single forces relative to the largest force; for the
    # displacement and the relative position error relative to the largest gap's, if that is more.
    accuracy: Accuracy = answer()

    @property
    @answered()
    def notices(self) -> tuple[Notice, ...]:
        """Notices on assumptions that one design (not an array) strains."""
        strained = {
            "short_roller": self.shape.length < SHORT_ROLLER,
            "sphere_below_roller": self.shape.sphere < 1,
            "sphere_too_wide": self.shape.width > self.shape.sphere,
            "large_deflection": self.deflection_ratio > LARGE_DEFLECTION,
        }
        assumptions = tuple(Notice(code) for code, holds in strained.items() if holds)
        return assumptions + poorly_known(self.accuracy)


def roller_strength(
    *,
    output_torque: Number,
    hole_circle_radius: Number,
    rollers: int,
    cylinder_length: Number,
    sphere_width: Number,
    sphere_diameter: Number,
    diameter: Number,
    friction_coefficient: Number,
    youngs_modulus: Number,
    shear: Shear,
    stress_concentration: Number = 1.0,
    spacing: Spacing,
) -> RollerStrength:
    """Forces, displacement and bending stress of swinging rollers.

    ``F_i = c*max(0, Delta - g_i)`` with ``sum F_i = T/(2*R)``; with a position tolerance chi one
    roller is ahead of the others by ``4*chi`` and ``Psi = min(n, 1 + 4*(n - 1)/n*delta)``.
    ``M = (l + b/2 + k*D/2)*F_1``, ``sigma = K_sigma*M/(pi*d^3/32)``.

    Source: Ovsyannikov et al. 2019, eqs (1)-(9). Errata: (11)-(13) print the number of rollers only
    before the bending part of the compliance; by (6) with (9) it multiplies the shear part too. The
    printed form makes the stress too high, by 9 % at l/d = 1, chi/d = 4e-4. In (13) l/d is missing
    before the first term as well. (9) carries the shear angle of (8) over b/2, though shear does
    not turn a section; this is kept because the source's figures are made with it. Without it the
    compliance is 6 % smaller at l/d = 1. One roller carries everything from delta = n/4, which for
    the source's n = 4 is its limit of 1.

    T is in N*m, > 0, the circle's radius R in m, n >= 1; l is the length of a cylinder between two
    spheres, b and D are width and diameter of a sphere, d is the diameter of the cylinder, m; k is
    the friction coefficient of sphere and hole, >= 0, E in Pa, K_sigma > 0.

    sigma/E of the source's fig. 6 at l/d = 2, chi/d = 2e-4:

    >>> result = roller_strength(
    ...     output_torque=0.001*210e9*0.01**3, hole_circle_radius=0.03, rollers=4,
    ...     cylinder_length=0.02, sphere_width=0.008, sphere_diameter=0.015, diameter=0.01,
    ...     friction_coefficient=0.16, youngs_modulus=210e9, shear=ByPoissonsRatio(0.3),
    ...     stress_concentration=2.0, spacing=PositionTolerance(2e-6))
    >>> round(result.bending_stress/210e9, 13)
    0.0024213655009
    """
    check_positive(
        output_torque=output_torque,
        hole_circle_radius=hole_circle_radius,
        cylinder_length=cylinder_length,
        sphere_width=sphere_width,
        sphere_diameter=sphere_diameter,
        diameter=diameter,
        youngs_modulus=youngs_modulus,
        stress_concentration=stress_concentration,
    )
    check_not_negative(friction_coefficient=friction_coefficient)
    if rollers < 1:
        raise InvalidInput("rollers", rollers, "greater_than_equal", limit=1)
    sizes = cylinder_length, sphere_width, sphere_diameter
    shape = RollerShape(*(size / diameter for size in sizes))
    relative = shape.relative_stiffness(
        friction_coefficient=friction_coefficient,
        modulus_ratio=shear.modulus_ratio(youngs_modulus),
    )
    stiffness = relative * sphere_width * youngs_modulus
    total = output_torque / hole_circle_radius / 2
    mean_force = total / rollers
    sharing = share_load(total=total, stiffness=stiffness, gaps=spacing.gaps(rollers))
    delta = spacing.relative_error(stiffness=stiffness, mean_force=mean_force)
    arm = cylinder_length + sphere_width / 2 + friction_coefficient * sphere_diameter / 2
    moment = arm * sharing.largest_force
    stress = stress_concentration * 32 / math.pi * (moment / diameter**2 / diameter)
    return RollerStrength(
        stiffness=stiffness,
        relative_stiffness=relative,
        mean_force=mean_force,
        relative_position_error=delta,
        load_nonuniformity=sharing.largest_force / mean_force,
        max_force=sharing.largest_force,
        centre_force=2 * sharing.largest_force,
        forces=sharing.forces,
        displacement=sharing.displacement,
        bending_moment=moment,
        bending_stress=stress,
        relative_stress=stress / youngs_modulus,
        loaded_rollers=sharing.loaded,
        shape=shape,
        deflection_ratio=sharing.largest_force / stiffness / cylinder_length,
        # roundings of products of positive sums add up, with those of the input
        accuracy=Accuracy("closed_form_gaps", sharing.relative_error + 16 * ROUNDING, 1),
    )


def roller_fatigue(
    *, bending_stress: float, strength: FatigueStrength, rotates: bool = False
) -> CycleFatigue:
    """Fatigue of a roller at its middle sphere.

    The stress goes from 0 to the largest, ``sigma_a = sigma_m = sigma/2``, and is fully reversed if
    the roller rotates in its seat. The cycle is derived from the static stress of Ovsyannikov et
    al. 2019, eq. (12). The bending stress, Pa, > 0, is the largest one, with the notch factor if
    `strength` has none.

    >>> strength = FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6)
    >>> round(roller_fatigue(bending_stress=300e6, strength=strength).safety_factor, 6)
    1.538462
    """
    check_positive(bending_stress=bending_stress)
    least = -bending_stress if rotates else 0.0
    return judge_cycle(strength=strength, largest=bending_stress, least=least)


def load_nonuniformity(*, relative_position_error: Number, rollers: int) -> Number:
    """Load-sharing factor, largest over mean force, ``Psi = min(n, 1 + 4*(n - 1)/n*delta)``.

    Source: Ovsyannikov et al. 2019, eq. (6), fig. 5, up to n, where one roller carries all.
    """
    return smaller(float(rollers), 1 + 4 * (rollers - 1) / rollers * relative_position_error)


def single_roller_limit(*, rollers: int) -> float:
    """Relative position error delta from which one roller of n carries everything, ``n/4``."""
    return rollers / 4
