"""The parallel-crank mechanism: pins of the output link in the holes of satellites on cranks.

Everything about it follows from one angle. With the wave angle ``psi = crank_angle*(1 + 1/ratio)
+ initial_crank_angle`` the pair of satellite j and pin n has the pressure angle

    cos(gamma_jn) = cos(pi/2 + psi + alpha_j + 2*pi*(n - 1)/N)

(Yanchevskiy and Niekhoroshykh 2021, eq. 6) and drives where that is positive: exactly half of
each turn of psi, at known angles.

Angles of the wave are counted in turns, so that pins an N-th of a turn apart stay so exactly, and
phases closer than `SAME` are one phase: rounding invents no slivers.

Crank, pins and ring are the members of one gear. All calculations of pins and satellites look at
the mechanism from its ring: under the torque on the pins, the crank turning against the ring.
`Members` takes what is typed of an output to that problem, and what is found there back to the
output.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from core.arrays import FloatArray, Number
from core.errors import InvalidInput, required
from core.precision import ROUNDING, SAME
from core.results import Accuracy


@dataclass(frozen=True)
class Mechanism:
    """Parallel-crank mechanism: pins of the output link in the holes of satellites on cranks.

    Raises
    ------
    InvalidInput
        If there is no pin, no satellite, or the ratio is not a positive number.
    """

    pins: int  # N, at least 1
    crank_angles: tuple[float, ...]  # alpha_j, rad: one for each of the K satellites
    # u = z2/(z3 - z2) > 0, crank speed over that of the pins; infinite of two shafts that pins
    # couple, where satellites never turn.
    ratio: float
    # Wave angle at crank angle 0, rad. Half a turn gives the sign of Yanchevsky et al. 2018, and is
    # also what reversing the torque does.
    initial_crank_angle: float = 0.0

    def __post_init__(self) -> None:
        if self.pins < 1:
            raise InvalidInput("pins", self.pins, "greater_than_equal", limit=1)
        if not self.crank_angles:
            raise InvalidInput("satellites", 0, "greater_than_equal", limit=1)
        if not self.ratio > 0:
            raise InvalidInput("ratio", self.ratio, "greater_than", limit=0)
        for index, angle in enumerate(self.crank_angles):
            if not math.isfinite(angle):
                raise InvalidInput(f"crank_angles[{index}]", angle, "finite_number")
        if not math.isfinite(self.initial_crank_angle):
            raise InvalidInput("initial_crank_angle", self.initial_crank_angle, "finite_number")

    @classmethod
    def evenly_spaced(
        cls,
        *,
        pins: int,
        satellites: int,
        ratio: float,
        crank_spacing: float | None = None,
        initial_crank_angle: float = 0.0,
    ) -> "Mechanism":
        """Mechanism whose cranks follow each other at one angle.

        Parameters
        ----------
        pins, satellites : int
            Numbers N of pins and K of satellites, each at least 1.
        ratio : float
            Ratio u > 0.
        crank_spacing : float, optional
            Angle alpha between neighbouring cranks, rad; 2*pi/K where not given.
        initial_crank_angle : float
            Wave angle at crank angle 0, rad.

        Returns
        -------
        Mechanism
        """
        if satellites < 1:
            raise InvalidInput("satellites", satellites, "greater_than_equal", limit=1)
        spacing = 2 * math.pi / satellites if crank_spacing is None else crank_spacing
        return cls(
            pins=pins,
            crank_angles=tuple([j * spacing for j in range(satellites)]),
            ratio=ratio,
            initial_crank_angle=initial_crank_angle,
        )

    @property
    def satellites(self) -> int:
        """Number K of satellites."""
        return len(self.crank_angles)

    @property
    def waves_per_turn(self) -> float:
        """Turns of the wave in one of the crank against the ring: 1 + 1/u."""
        return 1.0 if math.isinf(self.ratio) else (1 + self.ratio) / self.ratio

    @property
    def crank_angle_per_wave(self) -> float:
        """Crank angle in which the wave angle makes one turn, rad: 2*pi/(1 + 1/u)."""
        turn = 2 * math.pi
        return turn if math.isinf(self.ratio) else turn * self.ratio / (1 + self.ratio)

    def wave_angle(self, crank_angle: Number) -> Number:
        """Wave angle at a crank angle, rad: ``phi*(1 + 1/u)`` and the initial one."""
        return crank_angle * (1 + 1 / self.ratio) + self.initial_crank_angle

    @cached_property
    def phases(self) -> "WavePhases":
        """Phases of all pairs on the wave, coincident ones merged."""
        return WavePhases.of(self)


@dataclass(frozen=True)
class WavePhases:
    """Phases of the pairs in turns of the wave, `initial_crank_angle` included.

    The pins make the set of phases repeat every N-th of a turn, so it is enough to know the
    satellites' phases within one such sector.
    """

    pins: int  # N
    # Phase of the pair (satellite j, pin 1), in turns, in [0, 1), snapped to `sector_phases`.
    satellite_phase: tuple[float, ...]
    sector_phases: tuple[float, ...]  # the different ones within [0, 1/N), in turns, ascending
    multiplicity: tuple[int, ...]  # how many satellites share each of them
    symmetry: int  # repeats of the pattern within a sector
    # Largest distance by which merging, symmetry or the rounding of angles beyond a turn takes a
    # phase to be elsewhere, in turns.
    error: float

    @classmethod
    def of(cls, mechanism: Mechanism) -> "WavePhases":
        """Phases of a mechanism.

        Parameters
        ----------
        mechanism : Mechanism
            The mechanism.

        Returns
        -------
        WavePhases
        """
        pins = mechanism.pins
        # Driving starts half a turn before it ends. For even N half a turn is a whole number of
        # sectors; for odd N starts and ends coincide on a grid of half sectors. Snapping on that
        # grid makes coincident starts and ends coincide exactly.
        cells = pins if pins % 2 == 0 else 2 * pins
        start = math.fmod(mechanism.initial_crank_angle, 2 * math.pi) / (2 * math.pi)
        furthest = 0.0
        places = []
        for j, angle in enumerate(mechanism.crank_angles):
            scaled = (math.fmod(angle, 2 * math.pi) / (2 * math.pi) + start) * cells
            whole = math.floor(scaled)
            places.append((scaled - whole, j, whole))
            furthest = max(furthest, abs(angle))
        places.sort()
        tolerance = SAME * cells
        per_sector = cells // pins
        lowest = places[0][0]
        snapped, representative = 0.0, -math.inf
        satellite_phase = [0.0] * len(places)
        counts: dict[float, int] = {}
        for part, j, whole in places:
            if part > 1 - tolerance and lowest <= tolerance:
                snapped = max(snapped, 1 - part + lowest)
                whole, part = whole + 1, lowest
            elif part - representative <= tolerance:
                snapped = max(snapped, part - representative)
                part = representative
            else:
                representative = part
            satellite_phase[j] = (whole % cells + part) / cells
            phase = (whole % per_sector + part) / cells
            counts[phase] = counts.get(phase, 0) + 1
        sector_phases = tuple(sorted(counts))
        multiplicity = tuple([counts[phase] for phase in sector_phases])
        symmetry, off = _symmetry(sector_phases, multiplicity, 1 / pins)
        return cls(
            pins=pins,
            satellite_phase=tuple(satellite_phase),
            sector_phases=sector_phases,
            multiplicity=multiplicity,
            symmetry=symmetry,
            error=snapped / cells
            + off
            + far_angle_error(furthest + abs(mechanism.initial_crank_angle)),
        )

    def switching(self) -> list[tuple[float, int]]:
        """Wave positions in [0, 1/N) at which pairs start or stop driving, ascending, in turns;
        and by how much the number of driving pairs grows at each.
        """
        sector = 1 / self.pins
        # Half a turn is a whole number of sectors for even N: as one pair starts another stops.
        changes = ((0.0, 0),) if self.pins % 2 == 0 else ((0.0, -1), (sector / 2, 1))
        switches = []
        for phase, count in zip(self.sector_phases, self.multiplicity, strict=True):
            for shift, sign in changes:
                position = sector * (1 + (phase + shift > sector)) - phase - shift
                switches.append((position if position < sector else 0.0, sign * count))
        switches.sort()
        merged: list[tuple[float, int]] = []
        for position, growth in switches:
            if merged and position - merged[-1][0] <= SAME:
                merged[-1] = merged[-1][0], merged[-1][1] + growth
            else:
                merged.append((position, growth))
        if len(merged) > 1 and merged[0][0] + sector - merged[-1][0] <= SAME:
            merged[0] = merged[0][0], merged[0][1] + merged.pop()[1]
        return merged

    def dead_zones(self) -> list[tuple[float, float]]:
        """Wave positions at which no pair drives, ``(from, to)`` in turns, from in [0, 1).

        A dead centre exists exactly where neighbouring phases lie half a turn or more apart;
        where it is just half a turn, from equals to.
        """
        if self.pins > 2:
            return []
        sectors = range(self.pins)
        phases = [sector / self.pins + phase for sector in sectors for phase in self.sector_phases]
        zones = []
        for index, upper in enumerate(phases):
            gap = upper - phases[index - 1] if index else 1 - phases[-1] + upper
            if gap >= 0.5 - SAME:
                start = (1 - upper) % 1.0
                length = gap - 0.5
                zones.append((start, start + (length if length > SAME else 0.0)))
        return sorted(zones)


def _symmetry(
    phases: Sequence[float], multiplicity: tuple[int, ...], sector: float
) -> tuple[int, float]:
    """How many times the pattern of phases repeats within a sector, and how far it is off that."""
    size = len(phases)
    for repeats in range(size, 1, -1):
        step, remainder = divmod(size, repeats)
        if remainder or (*multiplicity[step:], *multiplicity[:step]) != multiplicity:
            continue
        off = 0.0
        for i in range(size):
            turn, other = divmod(i + step, size)
            off = max(off, abs(phases[other] + sector * turn - phases[i] - sector / repeats))
        if off <= SAME:
            return repeats, off * repeats
    return 1, 0.0


def far_angle_error(angle: float) -> float:
    """Error of the phase of an angle beyond a turn: that much coarser is its last digit, once where
    it was made of degrees and once here.

    Parameters
    ----------
    angle : float
        Size of the angle, rad, or sum of sizes.

    Returns
    -------
    float
        In turns; 0 up to a turn.
    """
    return 2 * ROUNDING * max(angle / (2 * math.pi) - 1, 0.0)


def pressure_cosines(*, mechanism: Mechanism, crank_angles: FloatArray) -> FloatArray:
    """Cosine of the pressure angle of every pair, 0 where the pair does not drive.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    crank_angles : array, shape (n,)
        Crank angles phi, rad.

    Returns
    -------
    array, shape (n, K, N)
        ``max(0, cos(gamma))``.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (6). Counted in turns, so that a pair on its
    switching angle has the cosine 0 and not a rounding error of either sign.
    """
    turns = np.asarray(crank_angles, dtype=np.float64) / mechanism.crank_angle_per_wave
    satellite = np.array(mechanism.phases.satellite_phase)
    pin = np.arange(mechanism.pins) / mechanism.pins
    phase = satellite[:, None] + pin[None, :] - 0.75
    # The angles are the last axis while it is calculated, as the longest.
    from_switching = (turns - np.floor(turns)) + phase[:, :, None]
    from_switching -= np.rint(from_switching)
    np.abs(from_switching, out=from_switching)
    np.subtract(0.25, from_switching, out=from_switching)
    drives = from_switching > 8 * ROUNDING * (1 + np.abs(turns))
    from_switching *= 2 * np.pi
    cosines = np.zeros_like(from_switching)
    np.sin(from_switching, out=cosines, where=drives)
    return cosines.transpose(2, 0, 1)


@dataclass(frozen=True, slots=True)
class AssemblyAngle:
    """How far the holes of one satellite are turned against its teeth."""

    satellite: int  # from 1
    hole_rotation: float  # smallest, of the holes against the teeth, relative to satellite 1, rad
    identical: bool  # whether it is the same part as satellite 1


def assembly_angles(*, mechanism: Mechanism, satellite_teeth: int) -> tuple[AssemblyAngle, ...]:
    """Rotation of each satellite's holes against its teeth so that the reducer can be assembled.

    ``psi_j = min over k of |alpha_j/u + k*2*pi/z2|``, with alpha_j counted from crank 1.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    satellite_teeth : int
        Number of teeth z2 of a satellite, at least 1.

    Returns
    -------
    tuple of AssemblyAngle
        One for each satellite.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, after eq. (11). Erratum: printed there with
    ``j*alpha/u``, which would turn satellite 1 against itself; ``(j - 1)*alpha`` is meant.
    Whether a satellite is the same part also allows for the pins' own pitch 2*pi/N: turning
    the holes by a whole number of pitches changes nothing.

    Examples
    --------
    z2 = 40, u = 20, cranks at 180 degrees: 9 degrees is just one tooth pitch.

    >>> m = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0)
    >>> [a.identical for a in assembly_angles(mechanism=m, satellite_teeth=40)]
    [True, True]
    """
    if satellite_teeth < 1:
        raise InvalidInput("satellite_teeth", satellite_teeth, "greater_than_equal", limit=1)
    pitch = 2 * math.pi / satellite_teeth
    first = mechanism.crank_angles[0]
    angles = []
    for index, angle in enumerate(mechanism.crank_angles):
        rotation = abs(math.remainder((angle - first) / mechanism.ratio, pitch))
        # Teeth and holes coincide again on the grid of both pitches.
        common = 2 * math.pi / math.lcm(satellite_teeth, mechanism.pins)
        off = abs(math.remainder((angle - first) / mechanism.ratio, common))
        rounding = 8 * ROUNDING * (abs(angle - first) / mechanism.ratio + pitch)
        angles.append(
            AssemblyAngle(
                satellite=index + 1,
                hole_rotation=rotation if rotation > rounding else 0.0,
                identical=off <= rounding,
            )
        )
    return tuple(angles)


def ratio_from_teeth(*, satellite_teeth: int, ring_teeth: int) -> float:
    """Ratio of the reducer from its numbers of teeth: ``u = z2/(z3 - z2)``.

    Parameters
    ----------
    satellite_teeth : int
        Teeth z2 of a satellite, at least 1.
    ring_teeth : int
        Teeth z3 of the ring, more than `satellite_teeth`.

    Returns
    -------
    float
        Ratio u, dimensionless.

    Raises
    ------
    InvalidInput
        If the ring has not more teeth than the satellite.

    Notes
    -----
    Source: Yanchevsky et al. 2018, section on the method (Willis).

    Examples
    --------
    >>> ratio_from_teeth(satellite_teeth=40, ring_teeth=42)
    20.0
    """
    if satellite_teeth < 1:
        raise InvalidInput("satellite_teeth", satellite_teeth, "greater_than_equal", limit=1)
    if ring_teeth <= satellite_teeth:
        than = {"field": "satellite_teeth", "limit": satellite_teeth}
        raise InvalidInput("ring_teeth", ring_teeth, "larger_than", **than)
    return satellite_teeth / (ring_teeth - satellite_teeth)


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
