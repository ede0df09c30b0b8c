"""A bolt through a spacer as the pin.

Both bend together while the preload holds the spacer to the carrier; otherwise the bolt bends
alone. With the least preload ``F_min``, the preload over its scatter, the spacer's face is pressed
everywhere up to ``M = F_min*(d^2 + d_i^2)/(8*d)`` and does not slip up to ``mu*F_min``. A closed
spacer leaves ``E_b*I_b/(E_b*I_b + E_s*I_s)`` of the moment to the bolt. Derived.
"""

from dataclasses import dataclass
from typing import Any, ClassVar

from core.arrays import check_positive
from core.errors import InvalidInput
from core.fields import Forms, answer, answered, optional_size, quantity, size
from core.hertz import ElasticMaterial
from core.output.pin_section import PinSection

NUT_FACTOR, THREAD = 0.2, 1.25
"""Nut factor K of the tightening torque ``K*F*d``, for bolts without special lubrication, and
thread diameter d over core diameter. No thread from M2.5 on has a larger ratio, so that the preload
is not less than calculated.
"""

SLIP_SAFETY = 1.2
"""Safety of the spacer against slipping on the carrier."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StatedBolt:
    """Inputs from which preload and strength of a bolt follow."""

    tightening_torque: float | None = optional_size("Tightening torque", "T_A", "Nm", step=0.5)
    """Tightening torque, given instead of the preload, which is T_A/(0.2·d)."""
    bolt_material: ElasticMaterial | None = quantity("Material of the bolt", default=None)
    """Name in the table of materials, or values; steel of class 8.8 if not given."""


@dataclass(frozen=True, slots=True)
class PinBolt:
    """Bolt through a spacer, from the carrier to its head or nut."""

    FOLLOWS_FROM: ClassVar[Any] = StatedBolt
    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("preload",), ("tightening_torque",), ()),)

    core_diameter: float = size("Core of the bolt", "d_3", "mm", step=0.1)
    """Core diameter of the bolt's thread: 2.46 mm for M3, 3.24 for M4, 4.13 for M5, 4.92 for M6,
    6.65 for M8."""
    preload: float | None = optional_size("Preload", "F_v", "N", step=100)
    """Preload of the bolt after tightening; without a preload the bolt alone counts as the pin."""
    preload_scatter: float = quantity(
        "Scatter of the preload", "α_A", default=1.8, step=0.1, ge=1, le=10
    )
    """Largest over least preload by the way of tightening; 1.6 to 2 with a torque wrench."""
    friction_coefficient: float = quantity(
        "Friction on the carrier", "μ", default=0.15, step=0.01, ge=0.01, le=1
    )
    """Friction coefficient of the spacer on the carrier, which keeps the spacer from slipping."""
    material: ElasticMaterial | None = None  # material of the core, with Re; or the spacer's
    tensile_strength: float | None = None  # Rm of that material, Pa
    steel: bool = False  # True for a steel, as `DesignPin` defines it
    valid_diameter: float | None = None  # largest diameter for which the strengths hold, m

    def __post_init__(self) -> None:
        check_positive(
            core_diameter=self.core_diameter, friction_coefficient=self.friction_coefficient
        )
        if self.preload is not None:
            check_positive(preload=self.preload)
        if not self.preload_scatter >= 1:
            scatter = self.preload_scatter
            raise InvalidInput("preload_scatter", scatter, "greater_than_equal", limit=1)


def bolt_preload(*, tightening_torque: float, core_diameter: float) -> float:
    """Preload of a bolt by its tightening torque, ``F = T/(K*d)``, N; d is `THREAD` core diameters.

    Lubricated bolts reach a higher preload.

    >>> round(bolt_preload(tightening_torque=1.2, core_diameter=0.002459))
    1952
    """
    return tightening_torque / (NUT_FACTOR * THREAD * core_diameter)


@dataclass(frozen=True, slots=True, kw_only=True)
class Grip:
    """Bolt and spacer under the largest loads of the root.

    Without a preload nothing is known to open, to slip or to hold.
    """

    moment: float = answer("Nm", "M")
    """Largest bending moment of the spacer."""
    shear_force: float = answer("N", "V")
    """Largest shear force of the spacer."""
    bending_amplitude: float = answer("MPa")
    """Bending stress of the bolt while the spacer holds; the thread is not judged."""
    alone_stress: float = answer("MPa")
    """Bending stress of the bolt if it carries the largest moment alone."""
    opening_moment: float | None = answer("Nm", default=None)
    """Moment at which the joint opens under the least preload; absent without a preload."""
    slip_force: float | None = answer("N", default=None)
    """Force at which the spacer slips under the least preload; absent without a preload."""
    squeeze: float = 0.0  # pressure of the spacer by the preload, Pa

    @property
    def opens(self) -> bool:
        """True if the spacer opens at its root."""
        return self.opening_moment is not None and self.moment > self.opening_moment

    @property
    def slips(self) -> bool:
        """True if the spacer slips at its root, with the safety against slipping."""
        return self.slip_force is not None and self.shear_force > self.slip_force / SLIP_SAFETY

    @property
    @answered()
    def holds(self) -> bool:
        """True if the preload holds the spacer, which then bends as the pin; otherwise the bolt
        alone is the pin.
        """
        return self.opening_moment is not None and not (self.opens or self.slips)


def grip(
    *,
    bolt: PinBolt,
    diameter: float,
    bore: float,
    moment: float,
    shear_force: float,
    modulus_ratio: float = 1.0,
) -> Grip:
    """State of a bolt and its spacer of two diameters, m, under the loads of their root.

    Moment, N*m, and shear force, N, are those of the spacer alone; `modulus_ratio` is E_b/E_s.

    >>> found = grip(
    ...     bolt=PinBolt(0.002459, 2000.0, 1.6), diameter=0.007, bore=0.0032, moment=1.65,
    ...     shear_force=366.8)
    >>> found.holds, round(found.opening_moment, 4), round(found.alone_stress/1e6, 1)
    (False, 1.3223, 1130.3)
    """
    spacer, core = PinSection(diameter, bore), PinSection(bolt.core_diameter)
    stiffness = modulus_ratio * core.inertia
    shared = moment * stiffness / (stiffness + spacer.inertia)
    found = {
        "moment": moment,
        "shear_force": shear_force,
        "bending_amplitude": shared / core.modulus,
        "alone_stress": moment / core.modulus,
    }
    if bolt.preload is None:
        return Grip(**found)
    least = bolt.preload / bolt.preload_scatter
    return Grip(
        **found,
        opening_moment=least * (diameter**2 + bore**2) / (8 * diameter),
        slip_force=bolt.friction_coefficient * least,
        squeeze=bolt.preload / spacer.area,
    )
