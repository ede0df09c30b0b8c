"""Friction of cycloid discs on the pins of their ring: sliding, loss, efficiency, pv.

A disc turns about the pitch point, from which the centre of a pin is ``R*S``: on a pin that stands
still it slides by ``w_out*|R*S - r|``. A sleeve that rolls on the disc slides on its pin instead,
as much slower as its bore is smaller; rolling elements in its bore resist that by a moment, which
their coefficient has at the bore. Friction does not change the forces here.
"""

import math
from dataclasses import dataclass
from typing import Any

from core.arrays import check_positive, check_single
from core.errors import InvalidInput, NotKnown, required
from core.ring.profile import CycloidDisc
from core.ring.sharing import MeshTurn


@dataclass(frozen=True, slots=True)
class RingFriction:
    """What slides on the ring's pins."""

    coefficient: float  # mu, >= 0; of rolling elements theirs, at the bore
    sleeve_bore_radius: float = 0.0  # r_i of sleeves on the pins, m, < r; 0: r, which loses most
    rolling: bool = False  # whether rolling elements carry the sleeves, which have no pv


def sliding_part(*, disc: CycloidDisc, friction: RingFriction) -> float:
    """Part of the sliding on pins that stand still which is left: of sleeves, on rolling elements
    too, their bore's.

    Parameters
    ----------
    disc : CycloidDisc
        The disc.
    friction : RingFriction
        What slides.

    Returns
    -------
    float

    Raises
    ------
    InvalidInput
        If the coefficient is negative, or a bore is not smaller than its pin.
    """
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


@dataclass(frozen=True, slots=True)
class RingLoss:
    """Friction of a ring's mesh over the turn."""

    loss_per_friction: float  # loss over output for mu = 1
    loss_ratio: float  # loss over output, mean over the turn
    efficiency: float  # of the mesh alone
    lost_torque: float  # loss over the speed of the crank, N*m
    input_speed: float | None  # of the crank, rad/s, where it is known
    ideal_loss_ratio: float | None = None  # on many perfect pins, none of which reaches its pole

    @property
    def speed(self) -> float:
        """That speed, which has to be known, whatever its sign."""
        return abs(required(self.input_speed, "speed_missing"))

    @property
    def mean_loss(self) -> float:
        """Power that friction takes, W."""
        return self.lost_torque * self.speed

    @property
    def peak_pv(self) -> float:
        """Largest product of pressure and sliding speed, Pa*m/s; not known of flanks, and of
        sleeves that roll.
        """
        raise NotKnown("no_bush")


@dataclass(frozen=True, slots=True, kw_only=True)
class SlidingLoss(RingLoss):
    """The same of discs that slide on the pins, or whose sleeves do."""

    turn: MeshTurn  # the mesh
    friction: RingFriction  # what slides

    @property
    def peak_pv(self) -> float:
        """By the projected area of a sleeve's bore, or of a contact by the mean of its Hertz
        pressure.
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

    Parameters
    ----------
    turn : MeshTurn
        The mesh under its torque.
    friction : RingFriction
        What slides.
    input_speed : float, optional
        Of the crank, rad/s; its sign does not matter.

    Returns
    -------
    RingLoss

    Raises
    ------
    InvalidInput
        See `sliding_part`.

    Notes
    -----
    ``loss/output = mu*c*sum F*|R*S - r|/T``, c being `sliding_part`; of perfect parts on many pins
    ``4*mu*c*(R - r)/(pi*e*z)`` where ``r < R*(1 - K1)``. Derived.

    Examples
    --------
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.sharing import CycloidMesh, mesh_over_turn
    >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
    ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005)
    >>> from core.materials import ElasticMaterial
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(1e8), exact=False,
    ...     pin_material=steel, disc_material=steel)
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
