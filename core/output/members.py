"""Crank, pins and ring as the members of one gear: who is the output, what that does to torques,
speeds and angles.

All calculations of pins and satellites look at the mechanism from its ring: under the torque on
the pins, the crank turning against the ring. `Members` takes what is typed of an output to that
problem, and what is found there back to the output.
"""

import math
from dataclasses import dataclass
from typing import Literal

from core.arrays import Number
from core.errors import required
from core.precision import ROUNDING
from core.results import Accuracy

Output = Literal["pins", "ring", "both", "coupling"]
"""Which member is driven: that of the pins while the ring stands still, the ring while the pins do,
or both; or two shafts that pins couple, an eccentricity apart, without a ring."""

CLOSED = Accuracy("closed_form", 8 * ROUNDING, 1)
"""How exact they are: their numbers follow in a few steps."""


@dataclass(frozen=True, slots=True)
class MemberSpeeds:
    """Speeds of the members, positive in the sense of the crank, rad/s."""

    crank: float  # w_1
    carrier: float  # w_c, of the pins, and of the satellites, which never turn against them
    ring: float  # w_r

    @property
    def relative(self) -> float:
        """Speed of the crank against the pins, rad/s: of sliding, rolling bearings, load cycles."""
        return self.crank - self.carrier

    @property
    def crank_to_ring(self) -> float:
        """Speed of the crank against the ring, rad/s: ``u/(u + 1)`` of that."""
        return self.crank - self.ring

    @property
    def turning(self) -> float:
        """Its size: the speed of the input where the ring stands still."""
        return abs(self.crank_to_ring)

    def against(self, part: str) -> float:
        """Size of the crank's speed against the part that its bearing sits in, rad/s.

        Parameters
        ----------
        part : {"housing", "carrier", "ring"}
            The part; the housing stands still.

        Returns
        -------
        float
        """
        speeds = {"carrier": self.carrier, "ring": self.ring}
        return abs(self.crank - speeds.get(part, 0.0))


@dataclass(frozen=True, slots=True)
class MemberLoads:
    """Torques on the members from outside, and the power that enters by each, without losses; under
    the torque in its driving sense. Without speeds the powers raise `NotKnown`.
    """

    output_ratio: float | None  # i = w_1/w_out, negative where they turn apart; None of both
    pin_torque: float  # T_c, N*m, as all torques positive in the sense of the crank
    crank_torque: float  # T_1, N*m
    ring_torque: float  # T_r, N*m
    given_speeds: MemberSpeeds | None = None  # of all members, where one is known
    accuracy: Accuracy = CLOSED

    @property
    def speeds(self) -> MemberSpeeds:
        """Those of the members."""
        return required(self.given_speeds, "speed_missing", "load.input_speed")

    @property
    def crank_power(self) -> float:
        """By the crank, W."""
        return self.crank_torque * self.speeds.crank

    @property
    def carrier_power(self) -> float:
        """By the pins, W, negative where it leaves."""
        return self.pin_torque * self.speeds.carrier

    @property
    def ring_power(self) -> float:
        """By the ring, W."""
        return self.ring_torque * self.speeds.ring

    @property
    def power_balance(self) -> float:
        """Sum of the powers, W: 0 but for rounding."""
        return math.fsum(self._powers)

    @property
    def output_power(self) -> float:
        """That leaves, W."""
        return -math.fsum(min(each, 0.0) for each in self._powers)

    @property
    def _powers(self) -> tuple[float, float, float]:
        return self.crank_power, self.carrier_power, self.ring_power


@dataclass(frozen=True, slots=True)
class Members:
    """Which member is the output of a mechanism of some ratio.

    With the ring at rest the crank turns u times as fast as the pins and the other way, so that for
    any speeds ``w_1 + u*w_c - (u + 1)*w_r = 0``; torques on the members are ``T_1 : T_c : T_r =
    1 : u : -(u + 1)``, whichever of them stands still.

    Notes
    -----
    Derived from the velocities at the pitch point and from statics (Willis).

    Examples
    --------
    Of 500 N*m at the ring the pins carry 476 N*m.

    >>> ring = Members("ring", 20.0)
    >>> round(500*ring.pin_share, 3), ring.output_ratio
    (476.19, 21.0)
    """

    output: Output = "pins"
    ratio: float = math.inf  # u > 0; infinite of a coupling, whose discs have no ring

    @property
    def output_ratio(self) -> float | None:
        """Speed of the crank over that of the output; None where both are, as that hangs on their
        speeds. Of a coupling the shafts turn alike.
        """
        ratios = {"pins": -self.ratio, "ring": self.ratio + 1, "coupling": 1.0}
        return ratios.get(self.output)

    @property
    def pin_share(self) -> float:
        """Torque on the pins over that of the output; angles of the output over those that the
        satellites turn against the pins: ``u/(u + 1)`` where the ring is the output, else 1.
        """
        return self.ratio / (self.ratio + 1) if self.output == "ring" else 1.0

    def torque_at_output(self, on_pins: Number) -> Number:
        """Torque of the output, of a torque on the pins."""
        return on_pins / self.pin_share

    def input_torque(self, of_crank: Number, output_torque: Number) -> Number:
        """Torque that drives, of that of the crank; of a coupling, whose crank stands still, that
        of the output besides.
        """
        return of_crank + output_torque if self.output == "coupling" else of_crank

    def angle_at_output(self, at_pins: Number) -> Number:
        """Angle of the output, of an angle of the satellites against the pins."""
        return at_pins * self.pin_share

    def stiffness_at_output(self, at_pins: Number) -> Number:
        """Torque of the output over its angle, of that on the pins over theirs."""
        return at_pins / self.pin_share**2

    @property
    def torque_ratio(self) -> float:
        """Torque of the output over that of the crank, of both that on the pins, without losses."""
        ratios = {"ring": self.ratio + 1, "coupling": 1.0}
        return ratios.get(self.output, self.ratio)

    def speeds(
        self, *, crank: float, ring: float | None = None, carrier: float | None = None
    ) -> MemberSpeeds:
        """Speeds of all members.

        Parameters
        ----------
        crank : float
            Speed of the crank, of a coupling that of its shafts, rad/s.
        ring, carrier : float, optional
            Speed of the ring or of the pins, rad/s, where both are the output: one of them.

        Returns
        -------
        MemberSpeeds

        Raises
        ------
        NotKnown
            Where both are the output and no speed of them is given.

        Examples
        --------
        >>> Members("both", 20.0).speeds(crank=1500.0, ring=7.0).carrier
        -67.65
        """
        u = self.ratio
        if self.output == "coupling":  # about a crank that stands still
            return MemberSpeeds(0.0, crank, crank)
        if self.output == "pins":
            ring = 0.0
        elif self.output == "ring":
            carrier = 0.0
        if ring is not None:
            return MemberSpeeds(crank, ((u + 1) * ring - crank) / u, ring)
        own = required(carrier, "speed_missing", "load.ring_speed")
        return MemberSpeeds(crank, own, (crank + u * own) / (u + 1))

    def loads(self, *, output_torque: float, speeds: MemberSpeeds | None = None) -> MemberLoads:
        """Torques and powers of all members.

        Parameters
        ----------
        output_torque : float
            Torque of the output, N*m; where both are, that on the pins.
        speeds : MemberSpeeds, optional
            Their speeds.

        Returns
        -------
        MemberLoads

        Examples
        --------
        >>> ring = Members("ring", 20.0)
        >>> found = ring.loads(output_torque=500.0, speeds=ring.speeds(crank=1500.0))
        >>> round(found.crank_torque, 3), round(found.ring_torque, 9), round(found.speeds.ring, 6)
        (23.81, -500.0, 71.428571)
        """
        pins = output_torque * self.pin_share
        if self.output == "coupling":  # driven by the disc, in the sense in which it turns
            pins = -pins
        crank = pins / self.ratio
        ring = -(pins + crank)
        return MemberLoads(self.output_ratio, pins, crank, ring, speeds)
