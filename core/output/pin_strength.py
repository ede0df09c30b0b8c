"""Strength of the pins: bending, shear and deflection over the turn, static safety, fatigue.

The force on a pin turns while it grows and falls, so that no fixed rule gives the stress cycle. The
cycle follows from the locus that the bending moment of a section describes over the turn. With the
support function ``h(chi)``, the largest moment of the locus in the direction chi, the stress of a
point of the section's edge ranges from ``-h(chi + pi)/W`` to ``h(chi)/W``, with ``W = pi*d^3/32``
of a solid pin.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, check_count, check_single
from core.errors import Accuracy, InvalidInput, Notice, poorly_known, required
from core.fatigue import LOW_CYCLES
from core.fields import answer, answered
from core.hertz import ElasticMaterial
from core.output.loaded_pin import LoadedPin, PinLoads
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, Support, section_stress
from core.output.pin_bolt import Grip
from core.output.pin_circle_load import PinCircleLoad
from core.output.pin_fatigue import FatigueStrength, PinFatigue, judged
from core.output.pin_section import check_bore
from core.output.sampled_turn import PinForces, PinSamples
from core.output.tie_ring import RingJoint, TieRing
from core.output.tied_pin import TiedPin, TieRingLoad
from core.precision import EXACT, ROUNDING, SEARCHED

DRAWN = 1e-4
"""Distance of a drawn line from the forces, over the largest force."""

AT_ZERO = 1e-6
"""Angle, rad, below which a direction counts as 0, as directions are not known better."""


@dataclass(frozen=True, slots=True)
class PinDeflection:
    """Largest deflection and largest slope of a pin over the middle planes of the discs.

    Each has a disc of its own: between two supports a pin slopes least where it deflects most.
    """

    satellite: int = answer()
    """Number of the satellite with the largest deflection, from 1."""
    deflection: float = answer("mm", "w")
    """Largest deflection in the middle of a satellite over the turn."""
    slope_satellite: int = answer()
    """Number of the satellite with the largest slope, from 1."""
    slope: float = answer("mrad", "θ")
    """Largest rotation of the section in the middle of a satellite. For one satellite between two
    supports, its error is that of the deflection over the distance to the nearer support."""


@dataclass(frozen=True, slots=True)
class MomentLocus:
    """Bending moment of a section of a pin over a turn of the crank against the output, at both
    sides of every switching angle.
    """

    position: float = answer("mm", "x")
    """Distance of the section from the carrier's face."""
    crank_angle: FloatArray = answer("deg", "φ")
    """Crank angles of the locus, over one turn of the crank relative to the pins."""
    tangential: FloatArray = answer("Nm")
    """Bending moment of the tangential forces."""
    radial: FloatArray = answer("Nm")
    """Bending moment of the radial forces."""
    stress: FloatArray = answer("MPa", "σ")
    """Bending stress in the worst direction."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PinStrength:
    """Strength of a pin over the turn.

    The accuracy is that of all numbers but direction, amplitude, mean and life of the fatigue. The
    first three are less exact than the utilisation, which is flat about the worst place; the life
    has the error of the safety times the slope of the S-N line.
    """

    peak_force: float = answer("N", "F_max")
    """Largest contact force over the turn."""
    peak_moment: float = answer("Nm", "M")
    """Largest bending moment of any section."""
    peak_moment_position: float = answer("mm", "x")
    """Distance of the section with the largest bending moment from the carrier's face."""
    peak_bending_stress: float = answer("MPa", "σ_b")
    """Largest bending stress, M/W; 32·M/(π·d³) for a solid pin."""
    peak_shear_force: float = answer("N", "V")
    """Largest shear force of any section."""
    peak_shear_stress: float = answer("MPa", "τ")
    """Largest shear stress, 4/3·V/A for a solid pin."""
    peak_equivalent_stress: float = answer("MPa", "σ_v")
    """Largest equivalent stress (Mises) of any section."""
    static_stress: float  # largest equivalent stress under the peak torque, Pa
    yield_strength: float | None  # Re of the pin, Pa, if known
    cycle: PinFatigue | None  # worst stress cycle, if asked for
    deflection: PinDeflection = answer()
    """Largest deflection and slope in the middle of satellites."""
    # Locus of the section of the worst cycle, or of the largest moment, if it was asked for.
    locus: MomentLocus | None
    pin: int  # number of the worst pin, from 1; ideal pins are alike
    tie_ring: TieRingLoad | None = answer()
    """Loads of the tie ring, if one joins the pins."""
    bolt: Grip | None = answer(default=None)
    """Bolt and spacer, if the pin is a bolt."""
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer()

    @property
    @answered("", "S", optional=True)
    def static_safety_factor(self) -> float:
        """Yield strength over the largest equivalent stress at the peak torque; absent if the
        yield strength is not known.
        """
        return required(self.yield_strength, "yield_unknown") / self.static_stress

    @property
    @answered(optional=True)
    def fatigue(self) -> PinFatigue:
        """Worst stress cycle of the pins; absent without fatigue data."""
        return required(self.cycle, "endurance_unknown")


@dataclass(frozen=True, slots=True)
class PinStresses:
    """Stresses of the pins over the turn, from which the strength follows."""

    pin: LoadedPin  # pin as a beam
    mechanism: Mechanism
    material: ElasticMaterial  # material of the pin
    cases: list["_Stresses"]  # largest stresses of one pin if all are alike, or of each
    static: float  # largest equivalent stress under the peak torque over that of the cases
    accuracy: Accuracy  # accuracy of all stresses
    tie_ring: TieRingLoad | None = None  # loads of the tie ring, if one joins the pins

    @property
    def loads(self) -> list[PinLoads]:
        """Loads of the cases."""
        return [each.loads for each in self.cases]

    def strength(
        self,
        *,
        rotates: bool = False,
        fatigue: FatigueStrength | None = None,
        input_speed: float | None = None,
        locus: bool = False,
    ) -> PinStrength:
        """Strength that follows from the stresses.

        If the pin `rotates` in the carrier, every point of the edge meets every direction, and the
        cycle of the largest moment is fully reversed. The crank's `input_speed`, rad/s, is needed
        for a life as time; True for `locus` adds the locus of the moment.
        """
        pin, found, mechanism = self.pin, self.cases, self.mechanism
        positions = pin.positions.tolist()
        bent = max(found, key=lambda each: each.bent)
        worst = max(found, key=lambda each: each.equivalent)
        most, mean_shear = worst.equivalent, max(each.mean_shear for each in found)
        static = self.static * most
        cycle, seen, chi = None, worst.place, None
        notices: list[Notice] = []
        if fatigue is not None:
            cycles = _cycles(pin, found, fatigue, rotates)
            worst, cycle = min(cycles, key=lambda each: each[1].safety_factor)
            seen, chi = cycle.position, cycle.direction
            notices += cycle.notices
            if cycle.cycles is not None:
                notices += [Notice("low_cycle_fatigue")] if cycle.cycles < LOW_CYCLES else []
                if input_speed is not None:
                    frequency = input_speed * mechanism.waves_per_turn / (2 * math.pi)
                    cycle = replace(cycle, life=cycle.cycles / frequency)
        if min(positions) < pin.diameter / 2:
            notices.append(Notice("short_pin"))
        if isinstance(pin, TiedPin) and pin.ring.joint == "pinned":
            notices.append(Notice("ring_clearance_left_out"))
        return PinStrength(
            peak_force=float(max(each.forces.max() for each in found)),
            peak_moment=bent.bent * pin.modulus,
            peak_moment_position=bent.place,
            peak_bending_stress=bent.bent,
            peak_shear_force=mean_shear * pin.area,
            peak_shear_stress=4 / 3 * mean_shear,
            peak_equivalent_stress=most,
            static_stress=static,
            yield_strength=self.material.yield_strength,
            cycle=cycle,
            deflection=_deflection(found),
            locus=_locus(pin, worst.loads, mechanism, seen, chi) if locus else None,
            pin=worst.loads.pin,
            tie_ring=self.tie_ring,
            accuracy=self.accuracy,
            notices=(*notices, *poorly_known(self.accuracy)),
        )


def pin_stresses(
    *,
    load: PinCircleLoad[PinForces],
    diameter: float,
    bore_diameter: float = 0.0,
    contact_length: float,
    satellite_positions: tuple[float, ...],
    material: ElasticMaterial,
    support: Support = "cantilever",
    span: float | None = None,
    ring_joint: RingJoint = "pinned",
) -> PinStresses:
    """Stresses of the pins over the turn.

    The diameters d of pin and bore (at most 0.95 d), and the length b over which each force is
    spread evenly, m, are > 0. The middle plane z of each disc lies at least b/2 from the carrier's
    face, and at most ``L - b/2`` with the distance L of the supports, or of the tie ring from the
    carrier; a cantilever has none. Each cycle of an alternating torque has both senses.

    The worst pin of a mechanism as made counts. In reverse an ideal pin feels opposite forces half
    a turn of the wave later. A pin shorter than half its diameter bends less than its seat gives
    way. `ImpossibleMechanism` is raised if the mechanism has a dead centre. Source of the ideal
    forces: Yanchevskiy and Niekhoroshykh 2021, eq. (10); the rest is derived, see docs/theory.md.

    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    >>> stresses = pin_stresses(
    ...     load=PinCircleLoad(mechanism=six, output_torque=500.0, pin_circle_radius=0.05),
    ...     diameter=0.016, contact_length=0.02, satellite_positions=(0.015, 0.037),
    ...     material=ElasticMaterial(210e9, 0.3, yield_strength=800e6))
    >>> found = stresses.strength(
    ...     fatigue=FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6))
    >>> round(found.peak_bending_stress/1e6, 6), round(found.fatigue.safety_factor, 6)
    (306.704838, 1.504829)
    """
    check_single(diameter=diameter, contact_length=contact_length, span=span)
    if support != "cantilever" and span is None:
        raise InvalidInput("span", None, "needed", field="support")
    check_bore(bore_diameter=bore_diameter, diameter=diameter)
    beam = PinBeam.round(
        support=support,
        diameter=diameter,
        bore_diameter=bore_diameter,
        contact_length=contact_length,
        youngs_modulus=material.youngs_modulus,
        poissons_ratio=material.poissons_ratio,
        span=span if support != "cantilever" else math.inf,
    )
    _check_positions(load.mechanism, satellite_positions, beam)
    pin = LoadedPin(beam, diameter, np.array(satellite_positions), bore_diameter)
    if support == "tie_ring":
        ring = TieRing(ring_joint, beam.span, beam.rigidity, beam.shear_area)
        pin = TiedPin(beam, diameter, pin.positions, bore_diameter, ring=ring)
    turns = [pin.held(turn) for turn in load.turns(load.output_torque)]
    found: list[_Stresses] = []
    # Uneven cases come first: the others mostly stay within them.
    for case in reversed(_cases(turns)):
        most = max((each.equivalent for each in found), default=0.0)
        found.insert(0, _stresses(pin, case, most))
    static = load.static_torque / load.output_torque
    if load.made and static != 1:
        again = _cases([pin.held(turn) for turn in load.turns(load.static_torque)])
        static = max(pin.equivalent(case, 0.0) for case in again)
        static /= max(each.equivalent for each in found)
    error = max(turn.error for turn in turns) + _of_two_supports(beam, satellite_positions)
    if not load.made:
        error += SEARCHED
    tied = pin.ring_load(turns, load.pin_circle_radius) if isinstance(pin, TiedPin) else None
    return PinStresses(
        pin=pin,
        mechanism=load.mechanism,
        material=material,
        cases=found,
        static=static,
        accuracy=Accuracy("sampling", error, sum(turn.evaluations for turn in turns)),
        tie_ring=tied,
    )


def _cases(turns: list[PinForces]) -> list[PinLoads]:
    """Loads of each pin that differs from the others, in all senses of the torque."""
    return [
        PinLoads(PinSamples.together([turn.felt(pin) for turn in turns]), pin + 1)
        for pin in range(turns[0].unlike)
    ]


@dataclass(frozen=True, slots=True)
class _Stresses:
    """Largest stresses of a turn, Pa, and forces, N, deflections, m, slopes, rad, by discs."""

    loads: PinLoads
    bent: float
    place: float
    mean_shear: float
    equivalent: float
    forces: FloatArray
    deflections: FloatArray
    slopes: FloatArray


def _stresses(pin: LoadedPin, loads: PinLoads, beyond: float) -> _Stresses:
    """Largest stresses of a pin; the equivalent stress only if it exceeds `beyond`, Pa.

    Moment and shear force of loads that come one at a time are parallel.
    """
    found, count, alone = pin.largest(loads), 3 * len(pin.positions), loads.one_by_one
    forces, deflections, slopes = found[:count].reshape(3, -1)
    shears, bends = found[count : -len(pin.bent)], found[-len(pin.bent) :]
    mean_shear = float(shears.max())
    if alone or pin.rooted:
        alike = np.flatnonzero(bends >= bends.max() * (1 - EXACT))
        top = alike[pin.bent[alike].argmin()]
        bent, place = float(bends[top]), float(pin.bent[top])
    else:
        bent, place, _ = pin.bending(loads)
    if alone:
        equivalent = float(section_stress(bending=bent, mean_shear=mean_shear))
    else:
        equivalent = pin.equivalent(loads, max(beyond, bent))
    return _Stresses(
        loads,
        bent,
        place,
        mean_shear=mean_shear,
        equivalent=max(equivalent, bent),
        forces=forces,
        deflections=deflections,
        slopes=slopes,
    )


def _cycles(
    pin: LoadedPin, cases: list[_Stresses], strength: FatigueStrength, rotates: bool
) -> Iterator[tuple[_Stresses, PinFatigue]]:
    """Cases with their stress cycles of which one may be the worst.

    No cycle is worse than the case's largest stress, fully reversed.
    """
    least = math.inf  # safety factor
    for case in sorted(cases, key=lambda each: -each.bent):
        reversed_use = strength.utilisation(case.bent, 0.0)
        if reversed_use * least <= 1:
            break
        top, bottom, seen, chi = case.bent, -case.bent, case.place, None
        if not rotates:
            cycle = pin.cycle(case.loads, strength, 1 / least)
            if cycle is None:
                continue
            top, bottom, seen, angle = cycle
            chi = _turned(angle)
        fatigue = judged(strength=strength, direction=chi, position=seen, largest=top, least=bottom)
        least = min(least, fatigue.safety_factor)
        yield case, fatigue


def _check_positions(mechanism: Mechanism, positions: tuple[float, ...], beam: PinBeam) -> None:
    """Refuse discs whose contact is not on the pin."""
    length, span = float(beam.contact_length), beam.span
    name = "satellite_positions"
    check_count(mechanism.satellites, **{name: positions})
    slack = 4 * ROUNDING
    for index, z in enumerate(positions):
        if not z >= length / 2 * (1 - slack):
            least = {"field": "contact_length", "limit": length / 2}
            raise InvalidInput(f"{name}[{index}]", z, "in_carrier", **least)
        if not beam.rooted and not z + length / 2 <= span * (1 + slack):
            most = span - length / 2
            raise InvalidInput(f"{name}[{index}]", z, "beyond_support", limit=most, field="span")


def _locus(
    pin: LoadedPin, case: PinLoads, mechanism: Mechanism, position: float, chi: float | None
) -> MomentLocus:
    """Moment locus of a section, with the stress in chi or in the largest moment's direction."""
    turn = case.turn.thinned(DRAWN)
    angles = (turn.wave - mechanism.initial_crank_angle) / mechanism.waves_per_turn
    stress = turn.sums(pin.moments(np.array([position])))[0]
    if chi is None:
        chi = float(np.angle(stress[np.abs(stress).argmax()]))
    return MomentLocus(
        position=position,
        crank_angle=angles,
        tangential=pin.modulus * stress.real,
        radial=pin.modulus * stress.imag,
        stress=(stress * np.exp(-1j * chi)).real,
    )


def _of_two_supports(beam: PinBeam, positions: tuple[float, ...]) -> float:
    """Rounding error of the deflection, by the cube of span over distance to a support."""
    if beam.rooted:
        return 0.0
    near = max(min(z, beam.span - z) for z in positions)
    found: float = ROUNDING * (beam.span / near) ** 3
    return found


def _deflection(cases: list[_Stresses]) -> PinDeflection:
    """Largest deflection and slope in the middle planes of the discs."""
    deflections = np.max([each.deflections for each in cases], axis=0)
    slopes = np.max([each.slopes for each in cases], axis=0)
    return PinDeflection(
        satellite=int(deflections.argmax()) + 1,
        deflection=float(deflections.max()),
        slope_satellite=int(slopes.argmax()) + 1,
        slope=float(slopes.max()),
    )


def _turned(chi: float) -> float:
    """Direction from 0 to less than a turn, rad."""
    chi %= 2 * math.pi
    return chi if AT_ZERO < chi < 2 * math.pi - AT_ZERO else 0.0
