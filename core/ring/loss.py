"""Friction of cycloid discs on their ring pins: sliding, loss, efficiency, pv.

A disc turns about the pitch point, from which the centre of a pin is ``R*S`` away. On a fixed pin
the disc slides at ``w_out*|R*S - r|``. A sleeve that rolls on the disc slides on its pin instead,
slower by bore radius over pin radius. Rolling elements in the bore resist by a moment that their
coefficient has at the bore radius. Friction does not change the forces here.
"""

import math
from dataclasses import dataclass
from typing import Any

from core.arrays import check_positive, check_single
from core.errors import InvalidInput, NotKnown, required
from core.fields import answer, answered
from core.ring.profile import CycloidDisc
from core.ring.sharing import MeshTurn


@dataclass(frozen=True, slots=True)
class RingFriction:
    """Friction of the ring pins, with or without sleeves."""

    coefficient: float  # mu, >= 0; with rolling elements their own, at the bore
    sleeve_bore_radius: float = 0.0  # r_i of sleeves on the pins, m, < r; 0 stands for no sleeve
    rolling: bool = False  # true if rolling elements carry the sleeves; there is no pv then


def sliding_part(*, disc: CycloidDisc, friction: RingFriction) -> float:
    """Sliding speed over that on fixed pins: 1 without sleeves, otherwise r_i/r."""
    check_single(coefficient=friction.coefficient)
    if not 0 <= friction.coefficient < math.inf:
        raise InvalidInput("coefficient", friction.coefficient, "greater_than_equal", limit=0)
    bore = friction.sleeve_bore_radius
    if bore == 0:
        return 1.0
    check_positive(sleeve_bore_radius=bore)
    if not bore < disc.ring_pin_radius:
        than = {"field": "ring_pin_radius", "limit": disc.ring_pin_radius}
        raise InvalidInput("sleeve_bore_radius", bore, "smaller_than", **than)
    return bore / disc.ring_pin_radius


@dataclass(frozen=True, slots=True, kw_only=True)
class RingLoss:
    """Friction loss of a ring's mesh over the turn."""

    loss_per_friction: float = answer(
        "", "", "ΣF·|R_p·S − r|·c/T; |τ − tan α_w| of involute teeth, over the path"
    )
    """Power loss over output power for a friction coefficient of 1, mean over the turn."""
    loss_ratio: float = answer()
    """Power loss over output power, mean over the turn."""
    efficiency: float = answer("", "η")
    """Efficiency of the mesh with the ring alone."""
    lost_torque: float  # lost power over the speed of the crank, N*m
    input_speed: float | None  # speed of the crank, rad/s; None if unknown
    ideal_loss_ratio: float | None = answer("", "", "4μ(R_p − r)/(π·e·z₂)", default=None)
    """Power loss over output power of perfect parts with many pins."""

    @property
    def speed(self) -> float:
        """Absolute speed of the crank, rad/s; NotKnown is raised if it is not given."""
        return abs(required(self.input_speed, "speed_missing"))

    @property
    @answered("W", optional=True)
    def mean_loss(self) -> float:
        """Mean power loss, if the speed is known."""
        return self.lost_torque * self.speed

    @property
    @answered("MPa_m_per_s", "pv", optional=True)
    def peak_pv(self) -> float:
        """Largest product of pressure and sliding speed, if the speed is known: of sleeves in their
        bores, else of the contact with π/4 of its Hertz pressure, for comparison only.
        """
        raise NotKnown("no_bush")


@dataclass(frozen=True, slots=True, kw_only=True)
class SlidingLoss(RingLoss):
    """Friction loss of discs that slide on the ring pins, or whose sleeves slide there."""

    turn: MeshTurn  # mesh under its torque
    friction: RingFriction  # friction of its ring pins

    @property
    def peak_pv(self) -> float:
        """Largest pv, Pa*m/s, by the projected bore area of a sleeve, or without one by the mean
        Hertz pressure of the contact.
        """
        turn, mesh = self.turn, self.turn.mesh
        speed = self.speed / mesh.disc.satellite_teeth
        if self.friction.sleeve_bore_radius > 0:
            return turn.hardest_rub * speed / (2 * mesh.disc.ring_pin_radius * mesh.contact_length)
        return math.pi / 4 * turn.hardest_pressed_rub * speed


def ring_loss(
    *, turn: MeshTurn, friction: RingFriction, input_speed: float | None = None
) -> RingLoss:
    """Loss, efficiency and pv of a ring's mesh.

    ``loss/output = mu*c*sum F*|R*S - r|/T`` with c from `sliding_part`; for perfect parts on many
    pins ``4*mu*c*(R - r)/(pi*e*z)`` if ``r < R*(1 - K1)``. Derived. The speed of the crank, rad/s,
    may have either sign.

    >>> from core.materials import ElasticMaterial
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.sharing import CycloidMesh, mesh_over_turn
    >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
    ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005)
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01, exact=False,
    ...                    law=LinearLaw(1e8), pin_material=steel, disc_material=steel)
    >>> found = ring_loss(turn=mesh_over_turn(mesh=mesh, output_torque=100.0),
    ...                   friction=RingFriction(0.06))
    >>> round(found.efficiency, 4), round(found.ideal_loss_ratio, 4)
    (0.8889, 0.125)
    """
    mu, disc = friction.coefficient, turn.mesh.disc
    part = sliding_part(disc=disc, friction=friction)
    each = part * turn.sliding_loss
    ratio = mu * each
    ideal = None
    if disc.ring_pin_radius < disc.ring_pin_circle_radius * (1 - disc.shortening_coefficient):
        ideal = 4 * (disc.ring_pin_circle_radius - disc.ring_pin_radius) / math.pi
        ideal *= mu * part / (disc.eccentricity * disc.satellite_teeth)
    found: dict[str, Any] = {
        "loss_per_friction": each,
        "loss_ratio": ratio,
        "efficiency": 1 / (1 + ratio),
        "lost_torque": ratio * abs(turn.turn.torque) / disc.satellite_teeth,
        "input_speed": input_speed,
        "ideal_loss_ratio": ideal,
    }
    if friction.rolling:
        return RingLoss(**found)
    return SlidingLoss(**found, turn=turn, friction=friction)
