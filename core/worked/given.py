"""What the worked steps of a crank-planetary design take from it: the one place that reads it."""

import math
from dataclasses import dataclass
from typing import Any

from core.checks.crank_design import CrankDesign
from core.checks.real_forces import RealForces
from core.checks.sections import DesignPin, FatigueBasis, Friction, Ring, RollingBearing, Shaft
from core.derived import if_known
from core.materials import ElasticMaterial
from core.output.mechanism import Mechanism
from core.output.sampled_turn import Direction

SAME = 1e-9
"""Difference of radii that is rounding, as a part of them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Given:
    """Inputs of a design with a load, and how its pins share an ideal one.

    Attributes
    ----------
    mechanism : Mechanism
        Pins and cranks.
    output_torque, pin_circle_radius, force_exponent, torque_direction : float, str
        The load.
    input_speed : float or None
        Speed of the crank, rad/s.
    contact_length, pin_length, pin_radius, hole_radius, eccentricity : float or None
        Sizes of pin and hole, m; the second is the length over which a pin is loaded.
    pin_material, hole_material : ElasticMaterial or None
        Materials of the contact.
    dynamic_factor, static_share, static_torque : float
        K_A, the torque of static strength over the one with it, and that torque, N*m.
    life : float
        Required life, s; infinite where none is asked.
    pin, fatigue, friction, gear, bearing, crankshaft : object or None
        Sections.
    real : bool
        Whether the forces are those of the mechanism as it is made.
    peak_force : float or None
        Largest ideal force, N.
    pair_stiffness : tuple of float or None
        Stiffness of the pairs of each satellite by which bending pins share the load; None where
        all are alike.
    """

    mechanism: Mechanism
    output_torque: float
    pin_circle_radius: float
    force_exponent: float
    torque_direction: Direction
    input_speed: float | None
    contact_length: float | None
    pin_length: float | None
    pin_radius: float | None
    hole_radius: float | None
    eccentricity: float | None
    pin_material: ElasticMaterial | None
    hole_material: ElasticMaterial | None
    dynamic_factor: float
    static_share: float
    static_torque: float
    life: float
    pin: DesignPin | None
    fatigue: FatigueBasis | None
    friction: Friction | None
    gear: Ring | None
    bearing: RollingBearing | None
    crankshaft: Shaft | None
    real: bool
    peak_force: float | None
    pair_stiffness: tuple[float, ...] | None

    @property
    def pairs(self) -> int:
        """Number of pairs."""
        return self.mechanism.pins * self.mechanism.satellites


def given_of(design: CrankDesign) -> Given:
    """Inputs of a design.

    Parameters
    ----------
    design : CrankDesign
        A design with a load.

    Returns
    -------
    Given
    """
    assert design.output_torque is not None and design.pin_circle_radius is not None
    force = if_known(lambda: design.force)
    return Given(
        mechanism=design.mechanism,
        output_torque=design.output_torque,
        pin_circle_radius=design.pin_circle_radius,
        force_exponent=design.force_exponent,
        torque_direction=design.torque_direction,
        input_speed=design.input_speed,
        contact_length=design.contact_length,
        pin_length=None if design.pin is None else design.pin_length,
        pin_radius=design.pin_radius,
        hole_radius=design.hole_radius,
        eccentricity=design.eccentricity,
        pin_material=design.pin_material,
        hole_material=design.hole_material,
        dynamic_factor=design.dynamic_factor,
        static_share=design.static_share,
        static_torque=design.static_torque,
        life=design.life,
        pin=design.pin,
        fatigue=design.fatigue,
        friction=design.friction,
        gear=design.gear,
        bearing=design.bearing,
        crankshaft=design.crankshaft,
        real=design.as_made,
        peak_force=None if force is None else force.peak_force,
        pair_stiffness=if_known(lambda: design.pair_stiffness),
    )


def pressed_of(design: CrankDesign) -> dict[str, Any]:
    """The contact of a design that is judged, as `core.worked.hertz.hertz_steps` takes it.

    Parameters
    ----------
    design : CrankDesign
        A design with a load and a contact.

    Returns
    -------
    dict
    """
    found, force = design.contact, design.judged_forces
    real = isinstance(force, RealForces)
    radius, hole = design.pin_radius, design.hole_radius
    assert radius is not None and hole is not None
    if real:  # with what deviates of them
        own = float(found.half_width / found.half_width_ratio)
        wide = float(found.reduced_radius * own / (found.reduced_radius - own))
        radius = radius if math.isclose(radius, own, rel_tol=SAME) else own
        hole = hole if math.isclose(hole, wide, rel_tol=SAME) else wide
    turning = None
    if design.input_speed is not None and math.isfinite(design.life):
        turning = design.input_speed, design.life, design.mechanism.ratio
    return {
        "found": found,
        "force": force.force if isinstance(force, RealForces) else force.peak_force,
        "contact_length": design.contact_length,
        "pin_radius": radius,
        "hole_radius": hole,
        "pin_material": design.lasting["pin"],
        "hole_material": design.lasting["hole"],
        "dynamic_factor": 1.0 if real else design.dynamic_factor,
        "distribution_factor": 1.0 if real else design.distribution_factor,
        "line_load_factor": design.line_load_factor if design.pin else 1.0,
        "turning": turning,
    }
