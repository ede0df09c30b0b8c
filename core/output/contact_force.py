"""The load of the pins as one job: reference force, exact peak, and what is asked besides."""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, check_single
from core.errors import InvalidInput
from core.output.mechanism import Mechanism
from core.output.peak_force import PeakForce, peak_force
from core.output.pin_forces import (
    approximate_peak_ratio,
    approximation_notices,
    force_ratios,
    reference_force,
)
from core.precision import ROUNDING
from core.results import Accuracy, Notice, poorly_known


class PairNumber(NamedTuple):
    """A pair of hole and pin."""

    satellite: int  # from 1
    pin: int  # from 1


@dataclass(frozen=True, slots=True)
class ForceCurves:
    """Contact force of every pair over the turn."""

    pairs: tuple[PairNumber, ...]  # satellite by satellite
    crank_angle: FloatArray  # rad, shape (n,)
    force: FloatArray  # N, shape (K*N, n), in the order of the pairs


@dataclass(frozen=True, slots=True)
class ContactForce:
    """Contact force of the pairs."""

    reference_force: float  # F0 = T/R, N
    peak_force: float  # F_max over the turn, exact, N
    peak_force_ratio: float  # F_max/F0
    peak_crank_angle: float  # smallest one >= 0, rad
    peak_pair: PairNumber  # the one that carries it there
    curves: ForceCurves | None  # where asked, like the three that follow
    equal_sharing_peak: float | None  # if all driving pairs carried the same (Zyl), N
    approximate_peak: float | None  # Yanchevsky et al. 2018, eq. (5), N
    approximate_peak_error: float | None  # relative to the exact peak, signed
    # Of the forces and their ratio; `approximate_peak_error` is known to that, absolutely, and a
    # smooth peak's angle to its root.
    accuracy: Accuracy
    notices: tuple[Notice, ...]  # limits that the approximation breaks; hardly anything known


@lru_cache(maxsize=1024)
def force_peak(mechanism: Mechanism, force_exponent: float) -> PeakForce:
    """The peak of a mechanism, searched for once: sizes and loads vary far more often.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    PeakForce
    """
    return peak_force(mechanism=mechanism, force_exponent=force_exponent)


def contact_force(
    *,
    mechanism: Mechanism,
    output_torque: float,
    pin_circle_radius: float,
    force_exponent: float = 1.0,
    curve_samples: int | None = None,
    equal_sharing: bool = False,
    approximation: bool = False,
) -> ContactForce:
    """Contact force of the pairs: the exact peak, and what else is asked.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    output_torque : float
        Torque T on the output link, N*m.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m.
    force_exponent : float
        Exponent v of the force over the approach.
    curve_samples : int, optional
        Number of evenly spaced crank angles from 0 to a full turn at which the force of every
        pair is wanted, at least 2.
    equal_sharing, approximation : bool
        Whether the peaks of Zyl and of Yanchevsky et al. 2018, eq. (5), are wanted.

    Returns
    -------
    ContactForce

    Raises
    ------
    InvalidInput
        If the exponent, the radius or the number of samples is out of range.
    ImpossibleMechanism
        If the mechanism has a dead centre.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (10); Yanchevsky et al. 2018, eq. (5); Zyl,
    eq. (1), which is the exponent 0 of the former.

    Examples
    --------
    Zyl's example: T = 50 N*m, R = 32.5 mm, six pins, one satellite: 888.23 N.

    >>> m = Mechanism.evenly_spaced(pins=6, satellites=1, ratio=20.0)
    >>> force = contact_force(mechanism=m, output_torque=50.0, pin_circle_radius=0.0325,
    ...                       equal_sharing=True)
    >>> round(force.equal_sharing_peak, 2), round(force.peak_force, 2)
    (888.23, 1025.64)
    """
    reference = reference_force(output_torque=output_torque, pin_circle_radius=pin_circle_radius)
    check_single(
        force_exponent=force_exponent,
        output_torque=output_torque,
        pin_circle_radius=pin_circle_radius,
    )
    peak = force_peak(mechanism, force_exponent)
    curves = None
    if curve_samples is not None:
        if curve_samples < 2:
            raise InvalidInput("samples", curve_samples, "greater_than_equal", limit=2)
        curves = force_curves(
            mechanism=mechanism,
            crank_angle=np.linspace(0.0, 2 * math.pi, curve_samples),
            reference=reference,
            force_exponent=force_exponent,
        )
    error = peak.accuracy.relative_error
    equal_peak = approximate_peak = approximate_error = None
    notices: tuple[Notice, ...] = ()
    if equal_sharing:
        equal = force_peak(mechanism, 0.0)
        equal_peak = reference * equal.peak_force_ratio
        error = max(error, equal.accuracy.relative_error)
    if approximation:
        ratio = approximate_peak_ratio(pins=mechanism.pins, satellites=mechanism.satellites)
        approximate_peak = reference * ratio
        approximate_error = ratio / peak.peak_force_ratio - 1
        notices = approximation_notices(mechanism=mechanism, force_exponent=force_exponent)
    # T, u, eta and R as given, their products, and the units they came in
    error += 5 * ROUNDING
    accuracy = Accuracy(peak.accuracy.method, error, peak.accuracy.evaluations)
    return ContactForce(
        reference_force=reference,
        peak_force=reference * peak.peak_force_ratio,
        peak_force_ratio=peak.peak_force_ratio,
        peak_crank_angle=peak.peak_crank_angle,
        peak_pair=PairNumber(peak.peak_satellite, peak.peak_pin),
        curves=curves,
        equal_sharing_peak=equal_peak,
        approximate_peak=approximate_peak,
        approximate_peak_error=approximate_error,
        accuracy=accuracy,
        notices=notices + poorly_known(accuracy),
    )


def force_curves(
    *, mechanism: Mechanism, crank_angle: FloatArray, reference: float, force_exponent: float
) -> ForceCurves:
    """Force of every pair at given crank angles.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    crank_angle : array, shape (n,)
        Crank angles, rad.
    reference : float
        Reference force F0, N.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    ForceCurves
    """
    ratios = force_ratios(
        mechanism=mechanism, crank_angles=crank_angle, force_exponent=force_exponent
    )
    pairs = tuple(
        PairNumber(satellite + 1, pin + 1)
        for satellite in range(mechanism.satellites)
        for pin in range(mechanism.pins)
    )
    return ForceCurves(
        pairs=pairs,
        crank_angle=crank_angle,
        force=reference * ratios.transpose(1, 2, 0).reshape(len(pairs), len(crank_angle)),
    )


def drawing_angles(*, mechanism: Mechanism, samples: int = 361) -> tuple[FloatArray, FloatArray]:
    """Crank angles that show forces over the turn faithfully, and the switching angles among them.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    samples : int
        Number of evenly spaced angles.

    Returns
    -------
    angles, switching : array
        Evenly spaced angles with both sides of every switching angle between them, and the
        switching angles, rad; over one turn, or over 12 periods of a pair where the turn has
        more than 60.
    """
    period = mechanism.crank_angle_per_wave
    end = 2 * math.pi if period >= 2 * math.pi / 60 else 12 * period
    sector = period / mechanism.pins
    first = period * np.array([position for position, _ in mechanism.phases.switching()])
    switching = np.add.outer(sector * np.arange(math.ceil(end / sector)), first).ravel()
    switching = switching[switching <= end]
    beside = 1e-9 * period
    before, after = np.maximum(switching - beside, 0.0), np.minimum(switching + beside, end)
    angles = np.concatenate((np.linspace(0.0, end, samples), before, after))
    angles.sort()
    return angles, switching
