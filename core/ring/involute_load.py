"""What the torque of a satellite does to its involute teeth: forces, pressure, root, friction.

One pair is taken to carry all of it. With a contact ratio below 2 that is so on a part of the path,
and at its start, where the pressure is largest, on the safe side.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import Number, check_positive
from core.errors import Accuracy, NotKnown
from core.hertz import ElasticMaterial, effective_modulus
from core.precision import ROUNDING
from core.ring.involute import InvolutePair
from core.ring.loss import RingLoss

ROOT_ANGLE = math.pi / 3
"""Angle of the tangent at the root's critical section to the tooth's middle line, less a right one:
30 degrees, as ISO 6336-3 has it."""

NOTCHES = (1.0, 8.0)
"""Root chord over twice the fillet's radius, from and below, for which the stress correction is."""


@dataclass(frozen=True)
class PairForce:
    """The force between one pair of flanks that carries the torque of a satellite."""

    normal: float  # F_bn along the line of action, N
    tangential: float  # across the crank, N
    radial: float  # along the crank, to the reducer's axis, N


@dataclass(frozen=True)
class RootStress:
    """Bending stress in the root of the satellite's teeth, the force at the tip."""

    chord: float  # s_Fn, m
    fillet_radius: float  # rho_F, m
    moment_arm: float  # h_Fe, m
    load_angle: float  # alpha_Fen of the force, rad
    form_factor: float  # Y_F
    stress_correction: float  # Y_S
    stress: float  # sigma_F, Pa


@dataclass(frozen=True)
class InvoluteLoad:
    """What the torque of a satellite does to its teeth."""

    force: PairForce  # without the load factor
    # Hertz's pressure of one pair. Where the satellite has no involute there is none, None.
    pressure_start: float | None  # at the start of the path, Pa: the largest
    pressure_end: float | None  # at its end, Pa
    pressure_at_pitch_point: float | None  # ISO 6336-2's, Pa: wherever the path is, to compare
    accuracy: Accuracy


def pair_force(*, pair: InvolutePair, torque: float) -> PairForce:
    """The force of one pair that carries a satellite's torque, ``F_bn = T_j/r_bs``.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    torque : float
        Torque T_j of the satellite about its own centre, N*m.

    Returns
    -------
    PairForce
    """
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
    """Hertz's pressure of one pair at places of the line of action.

    ``p = sqrt(K*F_bn*E*/(pi*b*rho))``, ``rho = rho_1*(rho_1 + e*sin(alpha_w))/(e*sin(alpha_w))``,
    ``rho_1 = r_bs*tau``.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    torque : float
        Torque T_j of the satellite about its own centre, N*m, > 0.
    contact_length : float
        Width b, m, > 0.
    satellite_material, ring_material : ElasticMaterial
        Their materials.
    roll : float or array
        Roll angles tau of the satellite there.
    load_factor : float
        Factor K on the force, of the application and along the width, > 0.

    Returns
    -------
    float or array
        Pa; NaN where the satellite has no involute.

    Raises
    ------
    InvalidInput
        If torque, width or factor are not positive.
    """
    check_positive(torque=torque, contact_length=contact_length, load_factor=load_factor)
    modulus = effective_modulus(first=satellite_material, second=ring_material)
    line, force = pair.line, pair_force(pair=pair, torque=torque).normal
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
    """Forces of one pair, and its pressure at the ends of the path, as `pressure_along` has it.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    torque : float
        Torque T_j of the satellite about its own centre, N*m, > 0.
    contact_length : float
        Width b, m, > 0.
    satellite_material, ring_material : ElasticMaterial
        Their materials.
    load_factor : float
        Factor K on the force, of the application and along the width, > 0.

    Returns
    -------
    InvoluteLoad

    Raises
    ------
    InvalidInput
        If torque, width or factor are not positive.

    Notes
    -----
    The pitch point need not lie on the path of so few teeth of difference; ISO 6336-2 looks there,
    and finds less than there is at the start of the path.
    """
    rolls = (pair.start_roll, pair.end_roll, pair.line.pitch_roll)
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
    error = rounded + 4 * ROUNDING / max(pair.start_roll, ROUNDING)
    return InvoluteLoad(
        force=pair_force(pair=pair, torque=torque),
        pressure_start=start,
        pressure_end=end,
        pressure_at_pitch_point=at_pitch,
        accuracy=Accuracy("closed_form", error, 1),
    )


def root_stress(
    *, pair: InvolutePair, torque: float, contact_length: float, load_factor: float = 1.0
) -> RootStress:
    """Bending stress in the root of the satellite's teeth, the whole force at the tip of one.

    ``sigma_F = F_t/(b*m)*Y_F*Y_S*K``, ``F_t = T_j/(m*z_s/2)``.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    torque : float
        Torque T_j of the satellite about its own centre, N*m, > 0.
    contact_length : float
        Width b, m, > 0.
    load_factor : float
        Factor K on the force.

    Returns
    -------
    RootStress

    Raises
    ------
    InvalidInput
        If torque, width or factor are not positive.
    NotKnown
        If the root is not one of a usual tooth, or its notch beyond `NOTCHES`.

    Notes
    -----
    Method B of ISO 6336-3 for a fillet that a rack generates, as it is commonly printed; the
    standard itself was not at hand. Of large operating pressure angles a part of the force presses
    on the root, which is on the safe side. The ring's root is not looked at.
    """
    check_positive(torque=torque, contact_length=contact_length, load_factor=load_factor)
    teeth, line = pair.teeth, pair.line
    rack, z, m = teeth.rack, teeth.satellite_teeth, teeth.module
    alpha = rack.pressure_angle
    shift, rounded = teeth.satellite_profile_shift, rack.tip_radius
    half_space = math.pi / 4 - rack.dedendum * math.tan(alpha)
    half_space -= (1 - math.sin(alpha)) * rounded / math.cos(alpha)
    below = rounded - rack.dedendum + shift  # of the reference circle: centre of the tip's arc
    offset = 2 / z * (math.pi / 2 - half_space) - ROOT_ANGLE
    theta = _tangent(2 * below / z, offset)
    fillet = below / math.cos(theta) - rounded
    chord = z * math.sin(ROOT_ANGLE - theta) + math.sqrt(3) * fillet
    bent = math.cos(theta) * (z * math.cos(theta) ** 2 - 2 * below)
    radius = rounded + 2 * below**2 / bent
    tip = math.atan(pair.end_roll)
    leaning = teeth.satellite_half_angle - (pair.end_roll - tip)  # half of the tip's angle
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
        chord=chord * m,
        fillet_radius=radius * m,
        moment_arm=arm * m,
        load_angle=load_angle,
        form_factor=form,
        stress_correction=correction,
        stress=nominal * form * correction,
    )


def loss_ratio(*, pair: InvolutePair, friction: float, roll: float) -> float:
    """Power lost over power put out while one pair carries at a place of the path.

    ``mu*|tau - tan(alpha_w)|``: the flanks slide by the distance to the pitch point times the speed
    at which satellite and ring turn against each other.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    friction : float
        Coefficient mu of friction.
    roll : float
        Roll angle tau of the satellite there.

    Returns
    -------
    float
    """
    return friction * abs(roll - pair.line.pitch_roll)


def mean_loss_ratio(*, pair: InvolutePair, friction: float) -> float:
    """The mean of `loss_ratio` over the path.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    friction : float
        Coefficient mu of friction.

    Returns
    -------
    float
    """
    start, end = (each - pair.line.pitch_roll for each in (pair.start_roll, pair.end_roll))
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
    """Friction of the flanks of all satellites, mean over the path, one pair of each carrying.

    Parameters
    ----------
    pair : InvolutePair
        The teeth.
    friction : float
        Coefficient mu of friction.
    output_torque : float
        Torque of all satellites, N*m.
    input_speed : float, optional
        Of the crank against the ring, rad/s.

    Returns
    -------
    RingLoss
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
    """Angle theta of ``theta = factor*tan(theta) - offset``, for factors below 0: of one sign."""
    theta = ROOT_ANGLE / 2
    for _ in range(50):
        excess = theta - factor * math.tan(theta) + offset
        closer = theta - excess / (1 - factor / math.cos(theta) ** 2)
        if abs(closer - theta) <= 4 * ROUNDING:
            return closer
        theta = closer
    return theta
