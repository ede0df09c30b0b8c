"""How pins and holes fit, and where they and their contact points lie at a crank angle.

The hole of satellite j is the circle around the pin's centre moved by the eccentricity towards
the satellite's crank. With hole radius = pin radius + eccentricity the pin touches the hole at
every crank angle; with a larger hole there is clearance, with a smaller one interference.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, check_positive, check_single
from core.errors import InvalidInput
from core.output.mechanism import Mechanism, pressure_cosines
from core.precision import AS_TYPED, ROUNDING
from core.results import Accuracy, Notice


def felt(*, clearance: float, hole_radius: float) -> float:
    """A clearance, or interference below 0, as calculations take it: 0 within `AS_TYPED`.

    Parameters
    ----------
    clearance : float
        By the sizes, m.
    hole_radius : float
        Radius of the hole, in the same unit.

    Returns
    -------
    float

    Examples
    --------
    >>> felt(clearance=0.01 - 0.008 - 0.002, hole_radius=0.01)
    0.0
    """
    return 0.0 if abs(clearance) <= AS_TYPED * hole_radius else clearance


@dataclass(frozen=True, slots=True)
class PinFit:
    """How pins and holes fit by their sizes alone, at any crank angle."""

    eccentricity: float  # e, m: the given one, or what leaves no clearance
    clearance: float  # r_out - r_in - e, m; < 0 interference, 0 within `AS_TYPED`
    notices: tuple[Notice, ...]  # clearance, interference, parts that overlap, assumed eccentricity


def pin_fit(
    *,
    pins: int,
    pin_radius: float,
    hole_radius: float,
    eccentricity: float | None = None,
    pin_circle_radius: float = math.inf,
) -> PinFit:
    """How pins and holes fit: clearance ``r_out - r_in - e``, and what is left between neighbours.

    Neighbouring centres lie ``2*R*sin(pi/N)`` apart; what is left of that between two holes of a
    satellite or between two pins must be more than nothing.

    Parameters
    ----------
    pins : int
        Number N of pins.
    pin_radius, hole_radius : float
        Radii r_in of the pins and r_out of the holes, m, r_out > r_in.
    eccentricity : float, optional
        Eccentricity e of the cranks, m; the difference of the radii where not given.
    pin_circle_radius : float, optional
        Radius R of the circle of pin centres, m; without it neighbours are not checked.

    Returns
    -------
    PinFit

    Raises
    ------
    InvalidInput
        If a length is not positive or the hole not larger than the pin.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, r_out = r_in + e where pin and hole touch at every
    crank angle.

    Examples
    --------
    >>> fit = pin_fit(pins=12, pin_radius=0.008, hole_radius=0.010, eccentricity=0.0025,
    ...               pin_circle_radius=0.010)
    >>> [notice.code for notice in fit.notices]
    ['interference', 'wall_holes', 'pins_apart']
    """
    check_single(
        pin_radius=pin_radius,
        hole_radius=hole_radius,
        eccentricity=eccentricity,
        pin_circle_radius=pin_circle_radius,
    )
    check_positive(pin_radius=pin_radius)
    if not hole_radius > pin_radius:
        than = {"field": "pin_radius", "limit": pin_radius}
        raise InvalidInput("hole_radius", hole_radius, "larger_than", **than)
    assumed = False
    if eccentricity is None:
        assumed, eccentricity = True, hole_radius - pin_radius
    check_positive(eccentricity=eccentricity)
    tolerance = AS_TYPED * hole_radius
    clearance = felt(clearance=hole_radius - pin_radius - eccentricity, hole_radius=hole_radius)
    check_positive(pin_circle_radius=pin_circle_radius)
    apart = 2 * pin_circle_radius * math.sin(math.pi / pins) if pins > 1 else math.inf
    between_holes, between_pins = apart - 2 * hole_radius, apart - 2 * pin_radius

    strained = {
        "eccentricity_assumed": assumed,
        "clearance": clearance > 0,
        "interference": clearance < 0,
        "wall_holes": between_holes <= tolerance,
        "pins_apart": between_pins <= tolerance,
    }
    needed = {"limit": 1e3 * (pin_radius + eccentricity)}
    notices = tuple(
        Notice(code, needed if code in ("clearance", "interference") else {})
        for code, holds in strained.items()
        if holds
    )
    if not assumed:  # what was meant comes before what follows from it
        notices = (
            *slip_notices(
                pin_radius=pin_radius, hole_radius=hole_radius, eccentricity=eccentricity
            ),
            *notices,
        )
    return PinFit(eccentricity=eccentricity, clearance=clearance, notices=notices)


SLIPPED = ("pin_radius", "hole_radius", "eccentricity")
"""Sizes that `slip_notices` asks about."""

LIKE_ECCENTRICITY = 0.5
"""Clearance over the eccentricity from which on it is said: mechanisms have a hundredth."""


def slip_notices(
    *, pin_radius: float, hole_radius: float, eccentricity: float | None
) -> tuple[Notice, ...]:
    """What sizes look like that leave a clearance, or interfere, in the order of the eccentricity:
    the usual slips, each with what would have been meant, where that fits.

    Parameters
    ----------
    pin_radius, hole_radius : float
        Radii r_in and r_out, m.
    eccentricity : float or None
        Eccentricity e, m; without it nothing is said.

    Returns
    -------
    tuple of Notice
        Their numbers are in mm.

    Notes
    -----
    The bands about each slip are no limits of mechanics: they leave room for the clearance that was
    meant (0 to 0.3 of the eccentricity), and nothing is offered that would not fit.

    Examples
    --------
    Pin 24 mm and hole 29 mm in diameter, typed as radii:

    >>> found = slip_notices(pin_radius=0.012, hole_radius=0.0145, eccentricity=0.00125)
    >>> [notice.code for notice in found]
    ['clearance_like_eccentricity', 'diameters_as_radii', 'twice_the_eccentricity']
    """
    if eccentricity is None:
        return ()
    pin, hole, e = pin_radius, hole_radius, eccentricity
    clearance = hole - pin - e
    tolerance = AS_TYPED * hole
    found = []
    if clearance >= LIKE_ECCENTRICITY * e - tolerance:
        found.append(Notice("clearance_like_eccentricity", {"ratio": clearance / e}))
    slips = (
        ("diameters_as_radii", 0.9 * e <= clearance <= 2 * e, pin / 2, hole / 2, e),
        ("twice_the_eccentricity", 0.9 * e <= clearance <= 1.5 * e, pin, hole - e, e),
        ("hole_diameter_as_radius", abs(hole / 2 - pin - e) <= e / 2, pin, hole / 2, e),
        ("pin_diameter_as_radius", abs(hole - pin / 2 - e) <= e / 2, pin / 2, hole, e),
        ("eccentricity_doubled", abs(hole - pin - e / 2) <= 0.15 * e, pin, hole, e / 2),
        ("eccentricity_forgotten", abs(hole - pin) <= 0.3 * e, pin, hole + e, e),
    )
    strange = not -0.3 * e <= clearance <= LIKE_ECCENTRICITY * e - tolerance
    for code, alike, meant_pin, meant_hole, meant_e in slips:
        if strange and alike and meant_hole - meant_pin - meant_e >= -tolerance:
            meant = {"pin": meant_pin, "hole": meant_hole, "eccentricity": meant_e}
            found.append(Notice(code, {name: each * 1e3 for name, each in meant.items()}))
    return tuple(found)


@dataclass(frozen=True, slots=True)
class PinGeometry:
    """Pins and holes at one crank angle, in the fixed frame (Y up through pin 1, X right)."""

    pin_centres: FloatArray  # M_n, m, shape (N, 2)
    hole_centres: FloatArray  # B_jn, m, shape (K, N, 2)
    # Points E_jn of the pins nearest to the wall of their hole, m, shape (K, N, 2): the contact
    # points where there is no clearance.
    contact_points: FloatArray
    # Pressure angles gamma_jn, rad, from -pi to pi, shape (K, N); a pair drives within +-pi/2.
    pressure_angles: FloatArray
    driving: NDArray[np.bool_]  # whether the pair drives, shape (K, N)
    clearance: float  # as that of `PinFit`, m
    accuracy: Accuracy  # of the coordinates over R + r_in + e
    notices: tuple[Notice, ...]  # those of `pin_fit`


def pin_geometry(
    *,
    mechanism: Mechanism,
    crank_angle: float,
    pin_circle_radius: float,
    pin_radius: float,
    hole_radius: float,
    eccentricity: float,
) -> PinGeometry:
    """Centres of pins and holes, contact points and pressure angles at a crank angle.

    ``M_n = R*(-sin(phi/u + 2*pi*(n-1)/N), cos(...))``,
    ``B_jn = M_n + e*(sin(phi + alpha_j), cos(phi + alpha_j))``,
    ``E_jn = M_n - r_in*(B_jn - M_n)/e``.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio. An initial crank angle turns all cranks.
    crank_angle : float
        Crank angle phi, rad.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m.
    pin_radius, hole_radius : float
        Radii r_in of the pins and r_out of the holes, m, r_out > r_in.
    eccentricity : float
        Eccentricity e of the cranks, m.

    Returns
    -------
    PinGeometry

    Raises
    ------
    InvalidInput
        If a length is not positive or the hole not larger than the pin.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, the equations before (6). Their C1, the square
    root in the intersection of the two circles, cancels to zero just where pin and hole touch
    and is not evaluated: which case it is follows from the sign of r_out - r_in - e.

    Examples
    --------
    >>> m = Mechanism.evenly_spaced(pins=4, satellites=1, ratio=20.0)
    >>> g = pin_geometry(mechanism=m, crank_angle=0.0, pin_circle_radius=0.05,
    ...                  pin_radius=0.006, hole_radius=0.008, eccentricity=0.002)
    >>> g.contact_points[0, 0].round(9).tolist(), g.clearance
    ([0.0, 0.044], 0.0)
    """
    if not math.isfinite(crank_angle):
        raise InvalidInput("crank_angle", crank_angle, "finite_number")
    fit = pin_fit(
        pins=mechanism.pins,
        pin_radius=pin_radius,
        hole_radius=hole_radius,
        eccentricity=eccentricity,
        pin_circle_radius=pin_circle_radius,
    )
    pin_angle = (
        math.fmod(crank_angle, 2 * math.pi * mechanism.ratio) / mechanism.ratio
        + 2 * math.pi * np.arange(mechanism.pins) / mechanism.pins
    )
    pin_centres = pin_circle_radius * np.stack((-np.sin(pin_angle), np.cos(pin_angle)), axis=-1)
    crank = (
        math.fmod(crank_angle, 2 * math.pi)
        + mechanism.initial_crank_angle
        + np.array(mechanism.crank_angles)
    )
    direction = np.stack((np.sin(crank), np.cos(crank)), axis=-1)[:, None, :]
    wave = np.add.outer(crank, pin_angle) + math.pi / 2
    pressure_angles = np.remainder(wave + math.pi, 2 * math.pi) - math.pi
    turned = abs(crank_angle) * (1 + 1 / mechanism.ratio) + abs(mechanism.initial_crank_angle)
    furthest = max(map(abs, mechanism.crank_angles))
    # Adding 0.0 turns the zero of a negative sine into a plain zero.
    return PinGeometry(
        pin_centres=pin_centres + 0.0,
        hole_centres=pin_centres + eccentricity * direction + 0.0,
        contact_points=pin_centres - pin_radius * direction + 0.0,
        pressure_angles=pressure_angles,
        driving=pressure_cosines(mechanism=mechanism, crank_angles=np.array([crank_angle]))[0] > 0,
        clearance=fit.clearance,
        accuracy=Accuracy(
            method="closed_form",
            relative_error=ROUNDING * (4 + turned + furthest + 2 * math.pi),
            evaluations=mechanism.pins * mechanism.satellites,
        ),
        notices=fit.notices,
    )
