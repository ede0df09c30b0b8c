"""Room to work in for the search of peaks: records that are filled in design by design."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.contact_force import FloatArray, IntArray
from core.force_bounds import HALVINGS, Look

ComplexArray = NDArray[np.complex128]
Records = np.recarray[Any, np.dtype[np.void]]

TURN = 2 * math.pi

PHASE = np.dtype(
    [
        ("satellite", float),  # phase of the satellite's pair with pin 1, turns, in [0, 1)
        ("sector", float),  # the same within a sector [0, 1/N)
        ("ordered", float),  # the k-th of these, ascending
        ("nearest", float),  # in a segment: phase of the pin nearest to the best place, turns
        ("step", float),  # that pin's number against the satellite's own phase
    ]
)
SEGMENT = np.dtype(
    [
        ("start", float),  # wave position, turns
        ("origin", float),  # wave position at which the best placed pair's pressure angle is 0
        ("left", float),  # tangent of that angle at the start
        ("right", float),  # and at the end
        ("number", float),  # of driving pairs
        ("squares", float),  # sum of sin(d)^2 over them, for v = 1
        ("products", float),  # sum of sin(d)*cos(d)
    ]
)
PLACE = np.dtype(
    [(name, float) for name in Look._fields]
    + [("halvings", np.int64)]  # of the stretch that ends here
)
CANDIDATE = np.dtype([("force", float), ("tangent", float), ("segment", np.int64)])


class Room(NamedTuple):
    """Room to work in, for designs with the same numbers of pairs; S driving pairs at most."""

    order: IntArray  # shape (K,): of the phases within their cells
    phases: Records  # shape (K,)
    relative: ComplexArray  # shape (K, K): exp(i*d) of each sector phase against the others
    roots: ComplexArray  # shape (N,): exp(i*d) of the pins
    segments: Records  # shape (G,)
    candidates: Records  # shape (C,)
    cosines: FloatArray  # shape (G, S): cos(d) of the driving pairs but the best placed
    sines: FloatArray  # shape (G, S): sin(d)
    places: Records  # shape (P,)


class Peaks(NamedTuple):
    """Peaks of designs, arrays of shape (n,) to be filled in.

    Attributes
    ----------
    ratio : array
        Largest force over F0, dimensionless.
    place : array
        First wave position within the sector at which it is reached, turns.
    satellite, pin : array of int
        Numbers of the pair that carries it there, from 1.
    error : array
        Bound of the relative error of the ratio.
    evaluations : array of int
        Places at which the force was calculated.
    """

    ratio: FloatArray
    place: FloatArray
    satellite: IntArray
    pin: IntArray
    error: FloatArray
    evaluations: IntArray


def room(*, pins: int, satellites: int, powers: bool) -> Room:
    """Room to work in.

    Parameters
    ----------
    pins, satellites : int
        Numbers N and K.
    powers : bool
        Whether there are exponents other than 1.

    Returns
    -------
    Room
    """
    most = 3 * satellites
    driving = satellites * ((pins + 1) // 2) if powers else 0
    places = 2 * most + HALVINGS + 2
    return Room(
        order=np.empty(satellites, np.int64),
        phases=np.recarray(satellites, PHASE),
        relative=np.empty((satellites, satellites), np.complex128),
        roots=np.exp(1j * TURN * np.arange(pins) / pins),
        segments=np.recarray(most, SEGMENT),
        candidates=np.recarray(4 * most + 64, CANDIDATE),
        cosines=np.empty((most, driving)),
        sines=np.empty((most, driving)),
        places=np.recarray(places, PLACE),
    )
