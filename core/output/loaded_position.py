"""One position of the mechanism as it is made: forces, lag, play, stiffness, pressures."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from core.arrays import FloatArray, check_finite, check_single
from core.errors import Accuracy, ImpossibleMechanism, InvalidInput, Notice, poorly_known
from core.hertz import HertzContact
from core.output.elasticity import RIGID_SUPPORT, HertzLaw
from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import at, pressing

LARGE_ROTATION = 0.1
"""Movement of the pins over the eccentricity above which the position is a strange one."""

DEPTHS = 0.5, 1.5
"""Reference depths over the hole's radius within which a half-space stands for a hole."""


@dataclass(frozen=True, slots=True)
class LoadedPosition:
    """The mechanism at one crank angle under load."""

    crank_angle: float  # as asked, rad
    rotation: float  # lag of the output behind its ideal angle, rad; negative in reverse
    force: tuple[tuple[float, ...], ...]  # of each pair, N, K x N
    # Share of each satellite in the torque, N*m, K values; negative where others drag it.
    satellite_torque: tuple[float, ...]
    # Lag of the output behind each satellite, rad, K values, where these turn against each other.
    satellite_rotation: tuple[float, ...] | None
    loaded_pairs: int  # number of pairs with a force
    # Least and largest lag of the unloaded output, rad; None where pairs press without load.
    play: tuple[float, float] | None
    # Smallest possible worst approach of the unloaded pairs, m, where they press.
    interference: float | None
    stiffness: float  # dT/dtheta, N*m/rad
    contacts: tuple[HertzContact, ...]  # that are pressed most, one in each direction of the torque
    rotation_error: float  # bound, rad
    play_error: float  # bound, rad
    force_error: float  # bound, of each force, N
    accuracy: Accuracy  # of the forces, over the largest
    notices: tuple[Notice, ...]

    @property
    def max_pressure(self) -> float:
        """The largest pressure, Pa."""
        return float(max(each.governing_pressure for each in self.contacts))


def loaded_position(
    *, real: RealMechanism, crank_angle: float, output_torque: float
) -> LoadedPosition:
    """Forces of all pairs, lag, play and stiffness at one crank angle.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    crank_angle : float
        Crank angle, rad.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    LoadedPosition

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        See `RealMechanism.solved`.

    Notes
    -----
    Left out: friction, speed, tilting and edge load, deformation of discs and carrier, a second
    flange, growth by heat, play and compliance of mesh and bearings. First order, no clearance:
    Yanchevskiy and Niekhoroshykh 2021, eq. (10), with the law's exponent.

    Examples
    --------
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
    check_single(crank_angle=crank_angle, output_torque=output_torque)
    check_finite(crank_angle=crank_angle, output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    direction = math.copysign(1.0, output_torque)
    setup, room = real.setup(direction), real.room()
    psi = real.wave(crank_angle)
    # The wave angle of a far crank angle is as rough as that.
    found = real.solved(psi, abs(output_torque), setup, room)
    pins = setup.pins
    rows = range(0, pins * setup.satellites, pins)
    force = np.array(room.force)
    largest = float(force.max())
    pressed = found.low > found.high + found.play_error
    contact = real.hardest(room.force)
    play = tuple(sorted((direction * found.low + 0.0, direction * found.high + 0.0)))
    torques = [
        direction * math.fsum(room.force[k] * room.lever[k] for k in range(i, i + pins))
        for i in rows
    ]
    own_lags = None
    if real.support.turning:
        own_lags = tuple(direction * lag for lag in room.own_lag)
    asked = {"crank_angle": crank_angle, "output_torque": output_torque}
    rough = first_order_error(
        real=real, forces=lambda rigid: loaded_position(real=rigid, **asked).force
    )
    error = found.force_error / largest
    accuracy = Accuracy("newton_bracket", error + rough, found.steps)
    return LoadedPosition(
        crank_angle=crank_angle,
        rotation=direction * found.lag,
        force=real.rows(room.force),
        satellite_torque=tuple(torques),
        satellite_rotation=own_lags,
        loaded_pairs=int((force > 0).sum()),
        play=None if pressed else (play[0], play[1]),
        interference=least_interference(real=real, psi=psi) if pressed else None,
        stiffness=found.stiffness,
        contacts=(contact,),
        rotation_error=found.lag_error,
        play_error=found.play_error,
        force_error=found.force_error,
        accuracy=accuracy,
        notices=(
            *notices(real=real, lag=abs(found.lag), pressed=pressed, contact=contact),
            *in_first_order(real=real, error=rough),
            *bent_together(real=real, force=force.reshape(-1, pins)),
            *poorly_known(accuracy._replace(relative_error=error)),
        ),
    )


def first_order_error(*, real: RealMechanism, forces: Callable[[RealMechanism], Any]) -> float:
    """By how much first order is off, where what satellites give is solved in no other.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    forces : callable
        Forces of a mechanism.

    Returns
    -------
    float
        Largest difference of the forces of rigid satellites in both geometries, over the largest of
        them in exact one: 0 where nothing gives, 1 where these cannot be solved.
    """
    if not real.support.first_order:
        return 0.0
    loose = real.roller_play + real.support.loose
    rigid = replace(real, support=RIGID_SUPPORT, roller_play=loose)
    try:
        first, exact = (np.array(forces(replace(rigid, exact=way))) for way in (False, True))
    except ImpossibleMechanism:
        return 1.0
    return float(abs(first - exact).max() / exact.max())


def in_first_order(*, real: RealMechanism, error: float) -> tuple[Notice, ...]:
    """Notice that forces are solved in first order, and how far that is off.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    error : float
        Difference of both geometries over the largest force.

    Returns
    -------
    tuple of Notice
    """
    percent = {"percent": 100 * error}
    return (Notice("first_order_geometry", percent),) if real.support.first_order else ()


def least_interference(*, real: RealMechanism, psi: float) -> float:
    """Smallest possible worst approach of the unloaded pairs at a wave angle, m.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    psi : float
        Wave angle, rad.

    Returns
    -------
    float
        Positive where pairs press without load.
    """
    if real.exact:
        least, _ = real.rooms.rooms(np.array([psi]))
        return -float(least[0])
    setup, room = real.setup(1.0), real.room()
    at(psi, setup, real.pairs, room)
    far = real.eccentricity / real.pin_circle_radius
    return pressing(-far, far, setup, real.pairs, room)


def notices(
    *, real: RealMechanism, lag: float, pressed: bool, contact: HertzContact
) -> tuple[Notice, ...]:
    """Limits that a position strains.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    lag : float
        Size of the lag, rad.
    pressed : bool
        Whether pairs press without load.
    contact : HertzContact
        The contact with the largest pressure.

    Returns
    -------
    tuple of Notice
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


def bent_together(*, real: RealMechanism, force: FloatArray) -> tuple[Notice, ...]:
    """Notice that pins are loaded by several satellites, whose bending is taken one by one.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    force : array, K x N
        Force of each pair, N.

    Returns
    -------
    tuple of Notice
    """
    together = real.pin.bends and ((force > 0).sum(axis=0) > 1).any()
    return (Notice("pin_bending_uncoupled"),) if together else ()
