"""One position of the real mechanism: forces, lag, play, stiffness and pressures."""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import Accuracy, Notice, poorly_known
from core.fields import answer, answered
from core.hertz import HertzContact
from core.output.elasticity import HertzLaw
from core.output.real_mechanism import RealMechanism
from core.output.stage import Solved, check_torque

LARGE_ROTATION = 0.1
"""Movement of the pins over the eccentricity above which a notice says that the lag is large."""

DEPTHS = 0.5, 1.5
"""Range of the reference depth, over the hole's radius, in which a half-space stands for a hole."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadedPosition:
    """Mechanism at one crank angle under load."""

    crank_angle: float = answer("deg", "φ")
    """Crank angle."""
    rotation: float = answer("arcmin", "θ")
    """Lag of the output behind its ideal angle, including clearance; negative in reverse."""
    force: tuple[tuple[float, ...], ...] = answer("N", "F_jn", "ΣF·h = T")
    """Force of each pair, as one list per satellite."""
    satellite_torque: tuple[float, ...] = answer("Nm", "T_j")
    """Torque that each satellite contributes; negative if other satellites drag it."""
    satellite_rotation: tuple[float, ...] | None = answer("arcmin", "θ_j")
    """Lag of the output behind each satellite, if satellites turn relative to each other."""
    loaded_pairs: int = answer()
    """Number of pairs with a force."""
    play: tuple[float, float] | None = answer("arcmin", "θ₋, θ₊")
    """Least and largest lag of the unloaded output; absent if pairs press without load."""
    interference: float | None = answer("mm", "δ")
    """Least possible value of the largest approach of the unloaded pairs, if pairs press without
    load."""
    stiffness: float = answer("Nm_per_arcmin", "dT/dθ")
    """Torque over rotation of the output mechanism alone, or of both meshes in series."""
    contacts: tuple[HertzContact, ...]  # hardest contact in each direction of the torque
    accuracy: Accuracy  # error of the forces over the largest force
    notices: tuple[Notice, ...]

    @property
    @answered("MPa", "p_0", "Johnson 4.2", optional=True)
    def max_pressure(self) -> float:
        """Largest pressure of the pairs as it is judged, by Hertz or by the conformal contact; with
        an alternating torque the largest of both directions. The value is absent if it is not
        known.
        """
        return float(max(each.governing_pressure for each in self.contacts))


def loaded_position(
    *, real: RealMechanism, crank_angle: float, output_torque: float
) -> LoadedPosition:
    """Forces of all pairs, lag, play and stiffness at one crank angle, rad.

    Left out are friction, speed, tilt of the discs, deformation of discs, carrier and crankshaft,
    and heat. Without clearance, bending and deviations and with ``exact=False`` the forces of a
    power law are those of Yanchevskiy and Niekhoroshykh 2021, eq. (10), with the law's exponent.
    The torque T on the output link, N*m, is not 0 and negative in reverse; `ImpossibleMechanism` is
    raised as by `Stage.solved`.

    Eight pins, 0.02 mm of clearance: three pairs carry, and ``F = T/2R + k*c*(sqrt(2) - 1)/2``.

    >>> from core.output.elasticity import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> from core.materials import ElasticMaterial
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False,
    ...     pin_material=steel, hole_material=steel)
    >>> found = loaded_position(real=real, crank_angle=0.0, output_torque=30.0)
    >>> found.loaded_pairs, round(max(found.force[0]), 4)
    (3, 957.1068)
    """
    check_torque(output_torque, crank_angle=crank_angle)
    direction = math.copysign(1.0, output_torque)
    room = real.solved([real.wave(crank_angle)], output_torque)
    force = room.forces[0]
    pressed, lag = bool(room.jammed[0]), float(room.lag[0])
    contact = real.hardest(force.tolist())
    play = sorted((direction * room.play[0] + 0.0).tolist())
    levers = room.work.grad[:, 0] * force
    own_lags = tuple(_behind(real, room).tolist()) if real.support.turning else None
    accuracy = Accuracy("newton_bracket", float(room.error[0] / force.max()), room.steps)
    return LoadedPosition(
        crank_angle=crank_angle,
        rotation=direction * lag,
        force=real.rows(force.tolist()),
        satellite_torque=tuple(levers.reshape(real.mechanism.satellites, -1).sum(axis=1).tolist()),
        satellite_rotation=own_lags,
        loaded_pairs=int((force > 0).sum()),
        play=None if pressed else (play[0], play[1]),
        interference=least_interference(real=real, psi=real.wave(crank_angle)) if pressed else None,
        stiffness=float(room.stiffness[0]),
        contacts=(contact,),
        accuracy=accuracy,
        notices=(
            *notices(real=real, lag=abs(lag), pressed=pressed, contact=contact),
            *poorly_known(accuracy),
        ),
    )


def _behind(real: RealMechanism, room: Solved) -> FloatArray:
    """Lag of the output behind each satellite, rad, shape (K,)."""
    lags, count = room.lags[0], real.mechanism.satellites
    behind: FloatArray = np.zeros(count) + lags[0]
    if real.support.given_shares:
        behind = lags[:count]
    elif real.support.mesh:
        behind = lags[0] - lags[1 : count + 1]
    return behind


def least_interference(*, real: RealMechanism, psi: float) -> float:
    """Smallest possible worst approach of unloaded pairs, m; positive where pairs press."""
    apart = range(real.mechanism.satellites) if real.support.given_shares else (None,)
    least = min(float(real.rooms.rooms(np.array([psi]), disc)[0][0]) for disc in apart)
    return -least - real.support.loose


def notices(
    *, real: RealMechanism, lag: float, pressed: bool, contact: HertzContact
) -> tuple[Notice, ...]:
    """Notices of a position: a large lag (its size in rad), pairs that press without load,
    clearance of tie ring joints that is left out, an unusual reference depth, and the hardest
    contact's own.
    """
    found = []
    if lag * real.pin_circle_radius > LARGE_ROTATION * real.eccentricity:
        share = lag * real.pin_circle_radius / real.eccentricity
        found.append(Notice("large_rotation", {"share": share}))
    if pressed:
        found.append(Notice("pressed_without_load"))
    if real.pin.loosely_tied:
        found.append(Notice("ring_clearance_left_out"))
    if isinstance(real.law, HertzLaw):
        hole = real.pin_radius + real.eccentricity + real.clearance
        ratio = real.law.depth(hole) / hole
        if not DEPTHS[0] <= ratio <= DEPTHS[1]:
            low, high = DEPTHS
            found.append(Notice("reference_depth", {"ratio": ratio, "low": low, "high": high}))
    return (*found, *contact.notices)
