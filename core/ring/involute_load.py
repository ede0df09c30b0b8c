"""Load of an involute planet's teeth: force, Hertz pressure, root stress, friction.

One pair is assumed to carry the whole torque of a planet. With a contact ratio below 2 that is true
on a part of the path; at the start of the path, where pressure is largest, it is on the safe side.
"""

import math
from dataclasses import asdict, dataclass

import numpy as np

from core.arrays import Number, check_positive
from core.errors import Accuracy, NotKnown
from core.fields import answer
from core.hertz import ElasticMaterial, effective_modulus
from core.precision import ROUNDING
from core.ring.involute import InvolutePair
from core.ring.loss import RingLoss

ROOT_ANGLE = math.pi / 3
"""Constant T of ISO 6336-3 for external teeth, rad: 90 degrees less the 30 degrees between the
tangent at the critical section and the middle line of the tooth."""

NOTCHES = (1.0, 8.0)
"""Range of root chord over twice the fillet radius in which the stress correction holds; the upper
end is excluded."""


@dataclass(frozen=True)
class PairForce:
    """Force between one pair of flanks that carries the whole torque of a planet."""

    normal_force: float = answer("N", "F_bn")
    """Force along the line of action."""
    tangential_force: float = answer("N")
    """Component of the force across the crank."""
    radial_force: float = answer("N")
    """Component of the force along the crank, towards the axis."""


@dataclass(frozen=True, kw_only=True)
class RootStress:
    """Bending stress in the root of the planet's teeth with the force at the tip (ISO 6336-3)."""

    root_chord: float = answer("mm", "s_Fn")
    """Chord of the critical section."""
    fillet_radius: float = answer("mm", "ρ_F")
    """Radius of the fillet at the critical section."""
    moment_arm: float = answer("mm", "h_Fe")
    """Lever arm of the force about the critical section."""
    load_angle: float = answer("deg", "α_Fen")
    """Angle of the force against the tooth."""
    form_factor: float = answer("", "Y_F")
    """Form factor, from lever arm and chord."""
    stress_correction: float = answer("", "Y_S")
    """Stress correction factor, from the notch."""
    root_stress_one_pair: float = answer("MPa", "σ_F")
    """Root stress if one pair carries the whole load."""


@dataclass(frozen=True, kw_only=True)
class InvoluteLoad(PairForce):
    """Force without the load factor and Hertz pressures of a planet's teeth under its torque."""

    pressure_one_pair_start: float | None = answer("MPa", "p_0")
    """Largest contact pressure, at the start of the path of contact; absent if the path does not
    start on an involute."""
    pressure_one_pair_end: float | None = answer("MPa", "p_0")
    """Contact pressure at the end of the path of contact."""
    iso_pressure_at_pitch_point: float | None = answer("MPa")
    """Contact pressure at the pitch point by ISO 6336-2, for comparison, as the pitch point need
    not lie on the path of contact."""
    accuracy: Accuracy


def pair_force(*, pair: InvolutePair, torque: float) -> PairForce:
    """Force of one pair that carries the torque T_j of a planet, ``F_bn = T_j/r_bs``."""
    normal = torque / pair.line.satellite_base
    return PairForce(normal, normal * math.cos(pair.line.angle), normal * math.sin(pair.line.angle))


def pressure_along(
    *,
    pair: InvolutePair,
    torque: float,
    contact_length: float,
    satellite_material: ElasticMaterial,
    ring_material: ElasticMaterial,
    roll: Number,
    load_factor: float = 1.0,
) -> Number:
    """Hertz pressure of one pair along the line of action, Pa; NaN if the planet has no involute.

    ``p = sqrt(K*F_bn*E*/(pi*b*rho))``, ``rho = rho_1*(rho_1 + e*sin(alpha_w))/(e*sin(alpha_w))``,
    ``rho_1 = r_bs*tau``. The torque T_j, N*m, is that of the planet about its own centre, b the
    contact length, m, and K the application factor times the face load factor, all > 0; tau are
    roll angles of the planet, rad.
    """
    check_positive(torque=torque, contact_length=contact_length, load_factor=load_factor)
    modulus = effective_modulus(first=satellite_material, second=ring_material)
    line, force = pair.line, pair_force(pair=pair, torque=torque).normal_force
    reduced = line.reduced_radius(np.where(np.greater(roll, 0), roll, np.nan))
    return np.sqrt(load_factor * force / contact_length * modulus / (math.pi * reduced))


def involute_load(
    *,
    pair: InvolutePair,
    torque: float,
    contact_length: float,
    satellite_material: ElasticMaterial,
    ring_material: ElasticMaterial,
    load_factor: float = 1.0,
) -> InvoluteLoad:
    """Force of one pair, and its Hertz pressure at the ends of the path and at the pitch point.

    With few teeth of difference the pitch point may lie off the path; ISO 6336-2 looks there and
    finds less pressure than there is at the start of the path. Arguments are those of
    `pressure_along`.
    """
    rolls = (pair.start_roll_satellite, pair.end_roll, pair.line.pitch_roll)
    found = pressure_along(
        pair=pair,
        torque=torque,
        contact_length=contact_length,
        satellite_material=satellite_material,
        ring_material=ring_material,
        roll=np.array(rolls),
        load_factor=load_factor,
    )
    start, end, at_pitch = (None if math.isnan(each) else float(each) for each in found)
    rounded = pair.accuracy.relative_error
    error = rounded + 4 * ROUNDING / max(pair.start_roll_satellite, ROUNDING)
    return InvoluteLoad(
        **asdict(pair_force(pair=pair, torque=torque)),
        pressure_one_pair_start=start,
        pressure_one_pair_end=end,
        iso_pressure_at_pitch_point=at_pitch,
        accuracy=Accuracy("closed_form", error, 1),
    )


def root_stress(
    *, pair: InvolutePair, torque: float, contact_length: float, load_factor: float = 1.0
) -> RootStress:
    """Bending stress in the planet's roots with the whole force at the tip of one tooth.

    ``sigma_F = F_t/(b*m)*Y_F*Y_S*K``, ``F_t = T_j/(m*z_s/2)``. Method B of ISO 6336-3 for a fillet
    that a rack generates, as it is commonly printed; the standard itself was not at hand. At large
    operating pressure angles a part of the force compresses the root, which is on the safe side.
    The root of the ring is not calculated. Raises NotKnown if the root is not that of a usual
    tooth, or its notch is out of `NOTCHES`. Arguments are those of `pressure_along`.
    """
    check_positive(torque=torque, contact_length=contact_length, load_factor=load_factor)
    teeth, line = pair.teeth, pair.line
    rack, z, m = teeth.rack, teeth.satellite_teeth, teeth.module
    alpha = rack.pressure_angle
    shift, rounded = teeth.satellite_profile_shift, rack.tip_radius
    half_space = math.pi / 4 - rack.dedendum * math.tan(alpha)
    half_space -= (1 - math.sin(alpha)) * rounded / math.cos(alpha)
    below = rounded - rack.dedendum + shift  # G of ISO 6336-3, in modules
    offset = 2 / z * (math.pi / 2 - half_space) - ROOT_ANGLE
    theta = _tangent(2 * below / z, offset)
    fillet = below / math.cos(theta) - rounded
    chord = z * math.sin(ROOT_ANGLE - theta) + math.sqrt(3) * fillet
    bent = math.cos(theta) * (z * math.cos(theta) ** 2 - 2 * below)
    radius = rounded + 2 * below**2 / bent
    tip = math.atan(pair.end_roll)
    leaning = teeth.satellite_half_angle - (pair.end_roll - tip)  # half angle of the tip
    load_angle = tip - leaning
    reach = (math.cos(leaning) - math.sin(leaning) * math.tan(load_angle)) * teeth.satellite_tip / m
    arm = reach - (z * math.cos(ROOT_ANGLE - theta) + fillet) / 2
    form = 6 * arm * math.cos(load_angle) / (chord**2 * math.cos(alpha))
    usual = min(chord, arm, radius, leaning) > 0 and load_angle < math.pi / 2
    if not (usual and NOTCHES[0] <= chord / (2 * radius) < NOTCHES[1]):
        raise NotKnown("root_unknown")
    slender, notch = chord / arm, chord / (2 * radius)
    correction = (1.2 + 0.13 * slender) * notch ** (1 / (1.21 + 2.3 / slender))
    nominal = load_factor * torque / (line.module * z / 2) / (contact_length * m)
    return RootStress(
        root_chord=chord * m,
        fillet_radius=radius * m,
        moment_arm=arm * m,
        load_angle=load_angle,
        form_factor=form,
        stress_correction=correction,
        root_stress_one_pair=nominal * form * correction,
    )


def loss_ratio(*, pair: InvolutePair, friction: float, roll: float) -> float:
    """Power lost over power put out while one pair carries at a place, ``mu*|tau - tan(alpha_w)|``.

    The sliding speed is the distance to the pitch point times the relative speed of both bodies.
    tau is the roll angle of the planet, rad.
    """
    return friction * abs(roll - pair.line.pitch_roll)


def mean_loss_ratio(*, pair: InvolutePair, friction: float) -> float:
    """Mean of `loss_ratio` over the path of contact."""
    start, end = (
        each - pair.line.pitch_roll for each in (pair.start_roll_satellite, pair.end_roll)
    )
    if not end > start:
        return friction * abs(start)
    return friction * (end * abs(end) - start * abs(start)) / (2 * (end - start))


def involute_loss(
    *,
    pair: InvolutePair,
    friction: float,
    output_torque: float,
    input_speed: float | None = None,
) -> RingLoss:
    """Friction of the flanks of all planets, mean over the path with one pair of each carrying. The
    torque is that of all planets, N*m, the speed that of the eccentric against the ring, rad/s.
    """
    each = mean_loss_ratio(pair=pair, friction=1.0)
    lost, teeth = friction * each, pair.teeth
    return RingLoss(
        loss_per_friction=each,
        loss_ratio=lost,
        efficiency=1 / (1 + lost),
        lost_torque=lost * output_torque * teeth.difference / teeth.satellite_teeth,
        input_speed=input_speed,
    )


def _tangent(factor: float, offset: float) -> float:
    """Root theta, rad, of ``theta = factor*tan(theta) - offset``, by Newton; needs a factor < 0."""
    theta = ROOT_ANGLE / 2
    for _ in range(50):
        excess = theta - factor * math.tan(theta) + offset
        closer = theta - excess / (1 - factor / math.cos(theta) ** 2)
        if abs(closer - theta) <= 4 * ROUNDING:
            return closer
        theta = closer
    return theta
