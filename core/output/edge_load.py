"""Line load at the ends of contacts whose pins slope: each force with the slope at that moment."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray, Number
from core.output.loaded_pin import LoadedPin, PinLoads
from core.output.pin_beam import face_load_factor
from core.output.pin_search import Measure, largest

IDLE = 1e-12
"""Forces below this part of the largest bear no line load that counts."""


@dataclass(frozen=True, slots=True)
class EdgeLoad:
    """The contact with the largest line load at an end of its length, where the pins slope."""

    # Even force that would have this line load, N: the contact's own times its
    # `core.output.pin_beam.face_load_factor`.
    force: float
    satellite: int  # from 1
    pin: int | None  # from 1; None where all are alike
    own: float  # the contact's own force, N
    slope: float  # rotation of its pin in the plane of the force, rad


@dataclass(frozen=True, slots=True)
class SlopingContacts:
    """Contacts of pins that slope.

    The slope that counts is that in the plane of the force; the pin's turn across it skews the
    contact, which moves its ends apart by the second order only.
    """

    pin: LoadedPin  # as a beam
    loads: list[PinLoads]  # of a pin where all are alike, else of each
    contact_length: float  # b, m, > 0
    # Approach of a level contact over its force, m/N, as a function of the force, N.
    compliance: Callable[[Number], Number]

    def even(self, force: Number, slope: Number) -> Number:
        """Even force on a contact that would have the line load of its edge.

        Parameters
        ----------
        force, slope : float or array
            Its own force, N, > 0, and the rotation of its pin, rad.

        Returns
        -------
        float or array
        """
        approach = force * self.compliance(force)
        return force * face_load_factor(
            slope=slope, contact_length=self.contact_length, approach=approach
        )

    def largest(self) -> EdgeLoad:
        """The contact with the largest line load."""
        worst = (0.0, 0.0, 0.0)

        def even(force: FloatArray, slope: FloatArray) -> FloatArray:
            nonlocal worst
            found = np.asarray(self.even(force, slope))
            top = np.unravel_index(int(np.argmax(found)), found.shape)
            worst = max(worst, (float(found[top]), float(force[top]), float(slope[top])))
            return found

        found = self._each(even)
        case, satellite = np.unravel_index(int(found.argmax()), found.shape)
        alike = all(each.pin == self.loads[0].pin for each in self.loads)
        force, own, slope = worst
        pin = None if alike else self.loads[case].pin
        return EdgeLoad(force=force, satellite=int(satellite) + 1, pin=pin, own=own, slope=slope)

    def _each(self, even: Callable[..., Number]) -> FloatArray:
        """The largest of a function of force and slope, by load and satellite."""
        slopes = self.pin.slopes
        forces = np.eye(*slopes.shape)
        measure = _of_sums(even)
        found = [
            largest(turn=each.turn, arms=(each.unit * forces, each.unit * slopes), measure=measure)
            for each in self.loads
        ]
        return np.array(found)


def _of_sums(even: Callable[..., Number]) -> Measure:
    """A function of force and slope, by the sums of forces and of slopes."""

    def edge(forces: ComplexArray, turned: ComplexArray) -> FloatArray:
        force = np.abs(forces)
        felt = np.maximum(force, IDLE * (float(force.max()) or 1.0))
        return np.asarray(even(felt, np.abs((turned * forces.conj()).real) / felt))

    return edge
