"""Parallel-crank mechanism: output pins in the holes of discs on eccentrics (cranks).

One angle determines the whole mechanism. With the wave angle
``psi = crank_angle*(1 + 1/ratio) + initial_crank_angle`` the pair of disc j and pin n has the
pressure angle

    cos(gamma_jn) = cos(pi/2 + psi + alpha_j + 2*pi*(n - 1)/N)

(Yanchevskiy and Niekhoroshykh 2021, eq. 6). The pair drives where the cosine is positive, which is
exactly half of each turn of psi.

Wave angles are counted in turns, so that pins 1/N of a turn apart stay exactly so. Phases closer
than `SAME` are merged, so that rounding makes no slivers.

Crank, pins and ring are the members of one gear. All calculations look at the mechanism from its
ring, under the torque on the pins. `Members` converts the given quantities of an output to that
view, and the results back to the output.

The hole of disc j is a circle around the pin's centre moved by the eccentricity towards the disc's
crank. A hole with the radius of the pin plus the eccentricity touches the pin at every crank angle;
a larger hole has clearance, a smaller one interference.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, Number, check_finite, check_positive, check_single
from core.errors import Accuracy, InvalidInput, Notice, required
from core.fields import answer, answered
from core.precision import AS_TYPED, ROUNDING, SAME

MAX_SATELLITES = 100
"""Largest number of satellites of a mechanism."""


@dataclass(frozen=True)
class Mechanism:
    """Parallel-crank mechanism: output pins in the holes of discs on eccentrics (cranks)."""

    pins: int  # N, at least 1
    crank_angles: tuple[float, ...]  # alpha_j, rad: one for each of the K satellites
    # u = z2/(z3 - z2) > 0, crank speed over that of the pins; infinite for a coupling, whose
    # satellites never turn.
    ratio: float
    # Wave angle at crank angle 0, rad. Half a turn gives the sign of Yanchevsky et al. 2018, and
    # describes a reversed torque.
    initial_crank_angle: float = 0.0

    def __post_init__(self) -> None:
        if self.pins < 1:
            raise InvalidInput("pins", self.pins, "greater_than_equal", limit=1)
        if not self.crank_angles:
            raise InvalidInput("satellites", 0, "greater_than_equal", limit=1)
        check_positive(ratio=self.ratio)
        check_finite(**{f"crank_angles[{i}]": angle for i, angle in enumerate(self.crank_angles)})
        check_finite(initial_crank_angle=self.initial_crank_angle)

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
        """Mechanism whose cranks follow each other at one angle, rad, 2*pi/K by default."""
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
        """Turns of the wave in one turn of the crank against the ring: 1 + 1/u."""
        return 1.0 if math.isinf(self.ratio) else (1 + self.ratio) / self.ratio

    @property
    def crank_angle_per_wave(self) -> float:
        """Crank angle in which the wave angle makes one turn, rad: 2*pi/(1 + 1/u)."""
        turn = 2 * math.pi
        return turn if math.isinf(self.ratio) else turn * self.ratio / (1 + self.ratio)

    def wave_angle(self, crank_angle: Number) -> Number:
        """Wave angle at a crank angle phi, rad: ``phi*(1 + 1/u) + initial_crank_angle``."""
        return crank_angle * (1 + 1 / self.ratio) + self.initial_crank_angle

    @cached_property
    def phases(self) -> "WavePhases":
        """Phases of all pairs on the wave, coincident ones merged."""
        return WavePhases.of(self)


@dataclass(frozen=True)
class WavePhases:
    """Phases of the pairs in turns of the wave, `initial_crank_angle` included.

    The set of phases repeats every N-th of a turn, so the record keeps one such sector.
    """

    pins: int  # N
    # Phase of the pair (satellite j, pin 1), in turns, in [0, 1), snapped to `sector_phases`.
    satellite_phase: tuple[float, ...]
    sector_phases: tuple[float, ...]  # different phases within [0, 1/N), in turns, ascending
    multiplicity: tuple[int, ...]  # number of satellites that share each phase
    symmetry: int  # repeats of the pattern within a sector
    # Largest shift of a phase by merging, by symmetry and by the rounding of angles beyond a turn,
    # in turns.
    error: float

    @classmethod
    def of(cls, mechanism: Mechanism) -> "WavePhases":
        """Phases of a mechanism."""
        pins = mechanism.pins
        # Driving starts half a turn before it ends. For even N half a turn is a whole number of
        # sectors; for odd N starts and ends coincide on a grid of half sectors. Snapping on that
        # grid makes coincident starts and ends coincide exactly.
        cells = pins if pins % 2 == 0 else 2 * pins
        start = math.fmod(mechanism.initial_crank_angle, 2 * math.pi) / (2 * math.pi)
        furthest = abs(mechanism.initial_crank_angle) + max(map(abs, mechanism.crank_angles))
        places = []
        for j, angle in enumerate(mechanism.crank_angles):
            scaled = (math.fmod(angle, 2 * math.pi) / (2 * math.pi) + start) * cells
            whole = math.floor(scaled)
            places.append((scaled - whole, j, whole))
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
            # The last digit of an angle beyond a turn is coarser, in degrees and again here.
            error=snapped / cells + off + 2 * ROUNDING * max(furthest / (2 * math.pi) - 1, 0.0),
        )

    def switching(self) -> list[tuple[float, int]]:
        """Wave positions in [0, 1/N) where pairs start or stop driving, in turns, ascending, each
        with the growth of the number of driving pairs.
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

        A dead centre exists exactly where neighbouring phases lie half a turn or more apart; if
        they lie just half a turn apart, from equals to.
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
    """Number of repeats of the pattern of phases in a sector, and deviation from it, turns."""
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


def pressure_cosines(*, mechanism: Mechanism, crank_angles: FloatArray) -> FloatArray:
    """Cosine of the pressure angle of every pair, ``max(0, cos(gamma))``, shape (n, K, N).

    `crank_angles` has the shape (n,), rad. Source: Yanchevskiy and Niekhoroshykh 2021, eq. (6).
    Angles are counted in turns, so that a pair at its switching angle has the cosine 0 and no
    rounding error of either sign.
    """
    turns = np.asarray(crank_angles, dtype=np.float64) / mechanism.crank_angle_per_wave
    satellite = np.array(mechanism.phases.satellite_phase)
    pin = np.arange(mechanism.pins) / mechanism.pins
    phase = satellite[:, None] + pin[None, :] - 0.75
    # The crank angles are the last axis during the calculation, as they are the longest.
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
    """Rotation of the holes of one satellite against its teeth."""

    satellite: int = answer("", "j")
    """Number of the satellite, from 1."""
    hole_rotation: float = answer("deg", "ψ_j", "2021, after eq. 11")
    """Rotation of the satellite's holes relative to its teeth."""
    identical: bool = answer()
    """True if the satellite may be identical to the first one."""


def assembly_angles(*, mechanism: Mechanism, satellite_teeth: int) -> tuple[AssemblyAngle, ...]:
    """Rotation of each satellite's holes against its teeth with which the reducer can be assembled.

    ``psi_j = min over k of |alpha_j/u + k*2*pi/z2|``, with alpha_j counted from crank 1 and the
    number of teeth z2 of a satellite, at least 1.

    Source: Yanchevskiy and Niekhoroshykh 2021, after eq. (11). Erratum: the paper prints
    ``j*alpha/u``, which would turn satellite 1 against itself; ``(j - 1)*alpha`` is meant. Two
    satellites are also the same part if their holes differ by a whole number of pitches 2*pi/N.

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
    """Ratio of the reducer from the teeth of satellite and ring, ``u = z2/(z3 - z2)``, z3 > z2.

    Source: Yanchevsky et al. 2018, section on the method (Willis).

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
"""Driven member: the pins while the ring stands still, the ring while the pins do, or both. A
coupling has no ring: pins couple two shafts that are an eccentricity apart.
"""

CLOSED = Accuracy("closed_form", 8 * ROUNDING, 1)
"""Accuracy of speeds and torques of the members, which follow in a few steps."""


@dataclass(frozen=True, slots=True)
class MemberSpeeds:
    """Speeds of the members, positive in the sense of the crank, rad/s."""

    crank: float  # w_1
    carrier: float  # w_c, of pins and satellites, which turn together
    ring: float  # w_r

    @property
    def relative(self) -> float:
        """Speed of the crank against the pins, rad/s, for sliding, bearings and load cycles."""
        return self.crank - self.carrier

    @property
    def crank_to_ring(self) -> float:
        """Speed of the crank against the ring, rad/s: ``u/(u + 1)`` of `relative`."""
        return self.crank - self.ring

    @property
    def turning(self) -> float:
        """Absolute speed of the crank against the ring, rad/s; input speed of a fixed ring."""
        return abs(self.crank_to_ring)

    def against(self, part: str) -> float:
        """Absolute speed of the crank, rad/s, against the part that holds its bearing.

        The part is "housing", which stands still, "carrier" or "ring".
        """
        speeds = {"carrier": self.carrier, "ring": self.ring}
        return abs(self.crank - speeds.get(part, 0.0))


@dataclass(frozen=True, slots=True)
class MemberLoads:
    """Torques on the members from outside, and the power that enters by each, without losses.

    The torque acts in its driving sense. Powers raise `NotKnown` if no speed is given.
    """

    output_ratio: float | None = answer("", "i")
    """Speed of the crank over that of the output, negative if they turn in opposite directions;
    ratio of the shafts of a coupling; absent if ring and pins are both outputs."""
    pin_torque: float = answer("Nm", "T")
    """Torque on the pins."""
    crank_torque: float = answer("Nm", "T₁", "T/u")
    """Torque on the crank of a reducer without losses; the motor has to supply the losses as
    well."""
    ring_torque: float = answer("Nm", "T_r", "−T·(1 + 1/u)")
    """Torque on the ring."""
    given_speeds: MemberSpeeds | None = None  # speeds of all members, if one is known
    accuracy: Accuracy = answer(default=CLOSED)

    @property
    def speeds(self) -> MemberSpeeds:
        """Speeds of the members."""
        return required(self.given_speeds, "speed_missing", "load.input_speed")

    @property
    @answered("rpm", "n₁", optional=True)
    def crank_speed(self) -> float:
        """Speed of the crank."""
        return self.speeds.crank

    @property
    @answered("rpm", "n_c", "n₁ + u·n_c = (u + 1)·n_r", optional=True)
    def carrier_speed(self) -> float:
        """Speed of the pins, and of the satellites, which turn with them."""
        return self.speeds.carrier

    @property
    @answered("rpm", "n_r", optional=True)
    def ring_speed(self) -> float:
        """Speed of the ring."""
        return self.speeds.ring

    @property
    @answered("rpm", "n", optional=True)
    def relative_speed(self) -> float:
        """Speed of the crank relative to the pins, which is the speed of the satellites' bearings,
        of sliding and of load cycles.
        """
        return self.speeds.relative

    @property
    @answered("rpm", "n₁ − n_r", optional=True)
    def crank_to_ring_speed(self) -> float:
        """Speed of the crank relative to the ring, by which the mechanism is calculated."""
        return self.speeds.crank_to_ring

    @property
    @answered("W", "P₁", optional=True)
    def crank_power(self) -> float:
        """Power that enters by the crank."""
        return self.crank_torque * self.speeds.crank

    @property
    @answered("W", "P_c", optional=True)
    def carrier_power(self) -> float:
        """Power that enters by the pins."""
        return self.pin_torque * self.speeds.carrier

    @property
    @answered("W", "P_r", optional=True)
    def ring_power(self) -> float:
        """Power that enters by the ring."""
        return self.ring_torque * self.speeds.ring

    @property
    @answered("W", optional=True)
    def power_balance(self) -> float:
        """Sum of the powers, which is 0 within rounding."""
        return math.fsum(self._powers)

    @property
    def output_power(self) -> float:
        """Power that leaves the mechanism, W."""
        return -math.fsum(min(each, 0.0) for each in self._powers)

    @property
    def _powers(self) -> tuple[float, float, float]:
        return self.crank_power, self.carrier_power, self.ring_power


@dataclass(frozen=True, slots=True)
class Members:
    """Output member of a mechanism of ratio u.

    With the ring at rest the crank turns u times as fast as the pins, in the opposite sense. All
    speeds therefore obey ``w_1 + u*w_c - (u + 1)*w_r = 0``. The torques on the members are
    ``T_1 : T_c : T_r = 1 : u : -(u + 1)``, whichever member stands still. Derived from the
    velocities at the pitch point and from statics (Willis).

    >>> ring = Members("ring", 20.0)
    >>> round(500*ring.pin_share, 3), ring.output_ratio
    (476.19, 21.0)
    """

    output: Output = "pins"
    ratio: float = math.inf  # u > 0; infinite for a coupling, which has no ring

    @property
    def output_ratio(self) -> float | None:
        """Speed of the crank over that of the output; 1 for a coupling, None if both are driven."""
        ratios = {"pins": -self.ratio, "ring": self.ratio + 1, "coupling": 1.0}
        return ratios.get(self.output)

    @property
    def pin_share(self) -> float:
        """Torque on the pins over output torque: ``u/(u + 1)`` if the ring is the output, or 1.

        Angles of the output are this part of the angles that the satellites turn against the pins.
        """
        return self.ratio / (self.ratio + 1) if self.output == "ring" else 1.0

    def torque_at_output(self, on_pins: Number) -> Number:
        """Output torque that belongs to a torque on the pins."""
        return on_pins / self.pin_share

    def input_torque(self, of_crank: Number, output_torque: Number) -> Number:
        """Input torque that belongs to the crank's torque.

        The crank of a coupling stands still, so that its input also carries the output torque.
        """
        return of_crank + output_torque if self.output == "coupling" else of_crank

    def angle_at_output(self, at_pins: Number) -> Number:
        """Output angle that belongs to an angle of the satellites against the pins."""
        return at_pins * self.pin_share

    def stiffness_at_output(self, at_pins: Number) -> Number:
        """Torsional stiffness at the output that belongs to the stiffness at the pins."""
        return at_pins / self.pin_share**2

    @property
    def torque_ratio(self) -> float:
        """Output torque over crank torque, without losses; pin torque if both are driven."""
        ratios = {"ring": self.ratio + 1, "coupling": 1.0}
        return ratios.get(self.output, self.ratio)

    def speeds(
        self, *, crank: float, ring: float | None = None, carrier: float | None = None
    ) -> MemberSpeeds:
        """Speeds of all members, from that of the crank or of a coupling's shafts, rad/s.

        If both are the output, one of `ring` and `carrier` is needed; `NotKnown` is raised without
        it.

        >>> Members("both", 20.0).speeds(crank=1500.0, ring=7.0).carrier
        -67.65
        """
        u = self.ratio
        if self.output == "coupling":  # The shafts turn about a crank that stands still.
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
        """Torques and powers of all members under an output torque, N*m; of both, that on the pins.

        >>> ring = Members("ring", 20.0)
        >>> found = ring.loads(output_torque=500.0, speeds=ring.speeds(crank=1500.0))
        >>> round(found.crank_torque, 3), round(found.ring_torque, 9), round(found.speeds.ring, 6)
        (23.81, -500.0, 71.428571)
        """
        pins = output_torque * self.pin_share
        if self.output == "coupling":  # The disc drives the pins in its own sense.
            pins = -pins
        crank = pins / self.ratio
        ring = -(pins + crank)
        return MemberLoads(self.output_ratio, pins, crank, ring, speeds)


def felt(*, clearance: float, hole_radius: float) -> float:
    """Clearance, negative for interference; 0 within the rounding of the sizes.

    >>> felt(clearance=0.01 - 0.008 - 0.002, hole_radius=0.01)
    0.0
    """
    return 0.0 if abs(clearance) <= SAME * hole_radius else clearance


@dataclass(frozen=True, slots=True)
class PinFit:
    """Fit of pins in holes by their sizes alone, at any crank angle."""

    eccentricity: float  # e, m: as given, or without clearance
    clearance: float  # r_out - r_in - e, m; < 0 interference
    notices: tuple[Notice, ...]  # clearance, interference, parts that overlap, assumed eccentricity


def pin_fit(
    *,
    pins: int,
    pin_radius: float,
    hole_radius: float,
    eccentricity: float | None = None,
    pin_circle_radius: float = math.inf,
) -> PinFit:
    """Fit of pins in holes: radial clearance ``r_out - r_in - e``, m, and walls between neighbours.

    Neighbouring centres lie ``2*R*sin(pi/N)`` apart; neighbours are not checked without R. An
    eccentricity that is not given is ``r_out - r_in``, with which pin and hole touch at every crank
    angle (Yanchevskiy and Niekhoroshykh 2021). A hole must be larger than its pin.

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
        "pins_like_crankshafts": 1 < pins <= 3 and pin_radius > LIKE_BEARING * pin_circle_radius,
    }
    needed = {"limit": 1e3 * (pin_radius + eccentricity)}
    notices = tuple(
        Notice(code, needed if code in ("clearance", "interference") else {})
        for code, holds in strained.items()
        if holds
    )
    if not assumed:  # Intended sizes come before their consequences.
        notices = (
            *slip_notices(
                pin_radius=pin_radius, hole_radius=hole_radius, eccentricity=eccentricity
            ),
            *notices,
        )
    return PinFit(eccentricity=eccentricity, clearance=clearance, notices=notices)


LIKE_BEARING = 0.3
"""Pin radius over pin circle radius from which few pins are as thick as an RV's crank bearings."""

LIKE_ECCENTRICITY = 0.5
"""Clearance over eccentricity from which a notice is given: usual mechanisms have a hundredth."""


def slip_notices(
    *, pin_radius: float, hole_radius: float, eccentricity: float | None
) -> tuple[Notice, ...]:
    """Notices of likely typing slips in sizes, m, with an unusual clearance or interference.

    Each notice has the sizes that would have been meant, in mm, and is given only if they fit. The
    bands about each slip are no limits of mechanics: they leave room for an intended clearance of 0
    to 0.3 of the eccentricity. Without an eccentricity there are no notices.

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
    driving: NDArray[np.bool_]  # True if the pair drives, shape (K, N)
    clearance: float  # radial clearance r_out - r_in - e, m
    accuracy: Accuracy  # error of the coordinates over R + r_in + e
    notices: tuple[Notice, ...]  # notices of `pin_fit`


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
    ``E_jn = M_n - r_in*(B_jn - M_n)/e``. An initial crank angle turns all cranks. Source:
    Yanchevskiy and Niekhoroshykh 2021, the equations before (6). C1 there, the square root in the
    intersection of two circles, vanishes just where pin and hole touch and is not evaluated: the
    sign of r_out - r_in - e decides the case. A hole must be larger than its pin.

    >>> m = Mechanism.evenly_spaced(pins=4, satellites=1, ratio=20.0)
    >>> g = pin_geometry(mechanism=m, crank_angle=0.0, pin_circle_radius=0.05,
    ...                  pin_radius=0.006, hole_radius=0.008, eccentricity=0.002)
    >>> g.contact_points[0, 0].round(9).tolist(), g.clearance
    ([0.0, 0.044], 0.0)
    """
    check_finite(crank_angle=crank_angle)
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
    turned = abs(crank_angle) * mechanism.waves_per_turn + abs(mechanism.initial_crank_angle)
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
