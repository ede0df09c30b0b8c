"""A pin that is a bolt through a spacer: while its preload holds the spacer to the carrier both
bend, else the bolt bends alone.
"""

from dataclasses import dataclass

from core.arrays import check_positive
from core.errors import InvalidInput
from core.hertz import ElasticMaterial
from core.output.pin_section import PinSection

NUT_FACTOR, THREAD = 0.2, 1.25
"""Of a tightening torque ``K*F*d``, and the diameter d of a thread over that of its core, which no
thread of M2.5 and larger has: the preload is not less."""

SLIP_SAFETY = 1.2
"""Safety of the spacer against slipping on the carrier."""


@dataclass(frozen=True, slots=True)
class PinBolt:
    """A bolt through a spacer, from the carrier to its head or nut."""

    core_diameter: float  # of the thread, m, > 0
    preload: float | None = None  # F_v as it is tightened, N, > 0; unknown where not given
    preload_scatter: float = 1.8  # largest over least preload of the way it is tightened, >= 1
    friction_coefficient: float = 0.15  # mu of the spacer on the carrier, > 0
    material: ElasticMaterial | None = None  # of its core, with Re; that of the spacer without
    tensile_strength: float | None = None  # Rm of that, Pa
    steel: bool = False  # whether it is a steel, as `DesignPin` says it
    valid_diameter: float | None = None  # largest one that these strengths hold for, m

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
    """Preload of a bolt by the torque of its wrench, ``F = T/(K*d)``.

    Parameters
    ----------
    tightening_torque : float
        Torque T, N*m.
    core_diameter : float
        Of the thread, m; the thread is taken to be `THREAD` times as thick.

    Returns
    -------
    float
        N.

    Notes
    -----
    The nut factor K = 0.2 of bolts as they come; lubricated ones are drawn tighter.

    Examples
    --------
    >>> round(bolt_preload(tightening_torque=1.2, core_diameter=0.002459))
    1952
    """
    return tightening_torque / (NUT_FACTOR * THREAD * core_diameter)


@dataclass(frozen=True, slots=True)
class Grip:
    """A bolt and its spacer under the largest loads of the root; of no preload that is known, under
    which nothing is known to open, to slip or to hold.
    """

    moment: float  # M of the root, N*m
    shear_force: float  # V of the root, N
    bending_amplitude: float  # of the bolt while the spacer holds, Pa
    alone_stress: float  # bending stress of the bolt where it bends alone, Pa
    opening_moment: float | None = None  # at which the spacer opens, N*m
    slip_force: float | None = None  # at which it slips, N
    squeeze: float = 0.0  # of the spacer by the preload, Pa

    @property
    def opens(self) -> bool:
        """Whether the spacer opens at its root."""
        return False

    @property
    def slips(self) -> bool:
        """Whether it slips there, with its safety."""
        return False

    @property
    def holds(self) -> bool:
        """Whether the spacer carries: it neither opens nor slips under a preload that is known."""
        return False


@dataclass(frozen=True, slots=True, kw_only=True)
class PreloadedGrip(Grip):
    """The same under a preload."""

    opening_moment: float  # N*m
    slip_force: float  # N

    @property
    def opens(self) -> bool:
        """Beyond the opening moment."""
        return self.moment > self.opening_moment

    @property
    def slips(self) -> bool:
        """Beyond the slip force over its safety."""
        return self.shear_force > self.slip_force / SLIP_SAFETY

    @property
    def holds(self) -> bool:
        """Where it does neither."""
        return not (self.opens or self.slips)


def grip(
    *,
    bolt: PinBolt,
    diameter: float,
    bore: float,
    moment: float,
    shear_force: float,
    modulus_ratio: float = 1.0,
) -> Grip:
    """What a bolt and its spacer bear at their root.

    Parameters
    ----------
    bolt : PinBolt
        The bolt.
    diameter, bore : float
        Outer and inner diameter of the spacer, m.
    moment, shear_force : float
        Largest ones of the root, as the spacer carries them, N*m and N.
    modulus_ratio : float
        Young's modulus E_b of the bolt over E_s of the spacer.

    Returns
    -------
    Grip

    Notes
    -----
    With the least preload ``F_min``, preload over scatter: the face of the spacer is pressed
    everywhere up to ``M = F_min*(d^2 + d_i^2)/(8*d)``, and does not slip up to ``mu*F_min``.
    While it is closed the bolt takes ``E_b*I_b/(E_b*I_b + E_s*I_s)`` of the moment. Derived.

    Examples
    --------
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
    return PreloadedGrip(
        **found,
        opening_moment=least * (diameter**2 + bore**2) / (8 * diameter),
        slip_force=bolt.friction_coefficient * least,
        squeeze=bolt.preload / spacer.area,
    )
