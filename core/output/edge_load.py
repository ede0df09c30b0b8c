"""Line load at the ends of contacts whose pins slope, by each force and the slope at that
moment.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, Number
from core.output.loaded_pin import LoadedPin, PinLoads
from core.output.pin_beam import face_load_factor

IDLE = 1e-12
"""Part of the largest force below which a force bears no line load that counts."""


@dataclass(frozen=True, slots=True)
class EdgeLoad:
    """Contact with the largest line load at an end of its length, where the pins slope."""

    # Even force that would have this line load, N: the contact's own force times
    # `core.output.pin_beam.face_load_factor`.
    force: float
    satellite: int  # from 1
    pin: int | None  # from 1; None where all pins are alike


@dataclass(frozen=True, slots=True)
class SlopingContacts:
    """Contacts of pins that slope.

    Only the slope in the plane of the force counts: a turn of the pin across that plane skews the
    contact, which moves its ends apart by the second order only.
    """

    pin: LoadedPin  # pin as a beam
    loads: list[PinLoads]  # loads of one pin where all are alike, else of every pin
    contact_length: float  # b, m, > 0
    # Approach of a level contact over its force, m/N, as a function of the force, N.
    compliance: Callable[[Number], Number]

    def even(self, force: Number, slope: Number) -> Number:
        """Even force, N, that has the line load at the edge of a contact with a force > 0, N, and a
        pin's slope, rad.
        """
        approach = force * self.compliance(force)
        return force * face_load_factor(
            slope=slope, contact_length=self.contact_length, approach=approach
        )

    def largest(self) -> EdgeLoad:
        """Contact with the largest line load."""
        found = np.array([self._of_pin(each) for each in self.loads])
        case, satellite = np.unravel_index(int(found.argmax()), found.shape)
        pin = None if len(self.loads) == 1 else self.loads[case].pin
        return EdgeLoad(float(found.max()), int(satellite) + 1, pin)

    def _of_pin(self, loads: PinLoads) -> FloatArray:
        """Largest even force of each satellite on a pin, N, shape (K,)."""
        turn, slopes = loads.turn, self.pin.slopes
        forces = turn.forces[: len(slopes)]
        size = np.abs(forces)
        felt = np.maximum(size, IDLE * (float(size.max()) or 1.0))
        slope = np.abs((turn.sums(slopes) * forces.conj()).real) / felt
        return turn.largest(np.asarray(self.even(felt, slope)))
