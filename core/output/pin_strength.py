"""Strength of the pins: bending, shear and deflection over the turn, static safety, fatigue.

The force on a pin turns while it grows and falls, so that no fixed rule says what cycle the stress
makes: it follows from the locus that the bending moment of a section describes over the turn. With
the support function ``h(chi)``, the locus' largest moment in the direction chi, a point of the
section's edge goes from ``-h(chi + pi)/W`` to ``h(chi)/W``, ``W = pi*d^3/32``.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from core.arrays import FloatArray, check_positive
from core.errors import InvalidInput
from core.fatigue import LOW_CYCLES
from core.materials import ElasticMaterial
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, Support, section_stress
from core.output.pin_fatigue import FatigueStrength, PinFatigue, judged
from core.output.pin_search import ENOUGH, ROUNDS, Points, highest, largest
from core.output.pin_turn import ComplexArray, PinTurn, combine, pin_turn
from core.output.sampled_turn import WAYS, Direction, Made, PinSamples, SampledTurn
from core.results import ROUNDING, Accuracy, Notice, poorly_known

Sharing = Literal["equal", "stiffness"]
"""How the satellites of an ideal mechanism share the load: alike, or by their pairs' stiffness."""

AT_ZERO = 1e-6
"""Directions closer to 0 than this, rad, are 0: none is known better."""


@dataclass(frozen=True, slots=True)
class PinDeflection:
    """Deflection of a pin in the middle plane of the satellite where it is largest.

    Attributes
    ----------
    satellite : int
        Number of the satellite, from 1.
    deflection : float
        Largest deflection over the turn, m.
    slope : float
        Largest rotation of the section there over the turn, rad; between two supports it may be
        small, and is as good as the deflection over the distance to the nearer one.
    slopes, forces : tuple of float, K
        Largest rotation at each satellite, rad, and its largest force, N: what
        `core.output.pin_beam.face_load_factor` is made of.
    """

    satellite: int
    deflection: float
    slope: float
    slopes: tuple[float, ...]
    forces: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class MomentLocus:
    """Bending moment of a section of pin 1 over a turn of the crank against the output.

    Attributes
    ----------
    position : float
        Distance of the section from the carrier's face, m.
    crank_angle : array, shape (n,)
        Crank angles, rad; both sides of every switching angle.
    tangential, radial : array, shape (n,)
        Moment by the tangential and by the radial forces, N*m.
    stress : array, shape (n,)
        Stress in the worst direction of the fatigue, else in that of the largest moment, Pa.
    """

    position: float
    crank_angle: FloatArray
    tangential: FloatArray
    radial: FloatArray
    stress: FloatArray


@dataclass(frozen=True, slots=True)
class PinStrength:
    """Strength of a pin over the turn.

    Attributes
    ----------
    peak_force : float
        Largest contact force, N.
    peak_moment : float
        Largest bending moment of any section, N*m.
    peak_moment_position : float
        Distance of that section from the carrier's face, m.
    peak_bending_stress : float
        Its bending stress, Pa.
    peak_shear_force : float
        Largest shear force of any section, N.
    peak_shear_stress : float
        Largest shear stress, 4/3 of its mean, Pa.
    peak_equivalent_stress : float
        Largest equivalent stress (Mises) of any section, Pa.
    static_safety_factor : float or None
        Yield strength over that stress under the peak torque, where it is known.
    fatigue : PinFatigue or None
        The worst stress cycle, where it was asked.
    deflection : PinDeflection or None
        Where it was asked.
    locus : MomentLocus or None
        Of the section of the worst cycle, else of the largest moment, where it was asked.
    sharing : {"equal", "stiffness"} or None
        By which sharing of the satellites the fatigue, else the equivalent stress, is worst; None
        where the forces are those of the mechanism as it is made.
    pin : int
        The pin of which it is, from 1; those of an ideal mechanism are alike.
    accuracy : Accuracy
        Of all numbers but direction, amplitude, mean and life of the fatigue: the first three are
        good to `FLAT`, as the utilisation is flat there; the life has the error of the safety times
        the slope of its line.
    notices : tuple of Notice
        Limits of validity that are strained.
    """

    peak_force: float
    peak_moment: float
    peak_moment_position: float
    peak_bending_stress: float
    peak_shear_force: float
    peak_shear_stress: float
    peak_equivalent_stress: float
    static_safety_factor: float | None
    fatigue: PinFatigue | None
    deflection: PinDeflection | None
    locus: MomentLocus | None
    sharing: Sharing | None
    pin: int
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def pin_strength(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    diameter: float,
    contact_length: float,
    satellite_positions: tuple[float, ...],
    material: ElasticMaterial,
    support: Support = "cantilever",
    span: float | None = None,
    rotates: bool = False,
    fatigue: FatigueStrength | None = None,
    input_speed: float | None = None,
    deflection: bool = False,
    locus: bool = False,
    application_factor: float = 1.0,
    peak_torque: float | None = None,
    torque_direction: Direction = "driving",
    pair_stiffness: tuple[float, ...] | None = None,
    made: Made | None = None,
) -> PinStrength:
    """Bending, shear, static safety, fatigue and deflection of the pins.

    The forces are the ideal ones, shared equally by the satellites; with `pair_stiffness` also
    shared by it, and the worse counts; with `made` those of the mechanism as it is made, and the
    worst pin counts.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    output_torque : float
        Torque T on the output link, N*m, > 0.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m, > 0.
    diameter : float
        Diameter d of the pin, m, > 0.
    contact_length : float
        Length b over which each force is spread evenly, m, > 0.
    satellite_positions : tuple of float
        Middle plane z of each satellite from the carrier's face, m, at least b/2; beside a span at
        most ``L - b/2``.
    material : ElasticMaterial
        Of the pin.
    support : {"cantilever", "supported", "fixed"}
        Held at one end; at both, free to tilt; at both, built in.
    span : float, optional
        Distance L of the two supports, m; for the latter two.
    rotates : bool
        Whether the pin turns in the carrier: then every point of its edge meets every direction,
        and the cycle of the largest moment is fully reversed.
    fatigue : FatigueStrength, optional
        What its fatigue is judged by.
    input_speed : float, optional
        Speed w_in of the crank, rad/s, > 0, for the life.
    deflection, locus : bool
        Whether the deflection, or the locus of the moment, is wanted.
    application_factor : float
        Factor K_A on the torque, > 0, in all but the static safety.
    peak_torque : float, optional
        Torque of the static safety, N*m, > 0; ``K_A*T`` where not given.
    torque_direction : {"driving", "reverse", "alternating"}
        Of a torque that alternates each cycle has both directions.
    pair_stiffness : tuple of float, K, optional
        Stiffness of the pairs of each satellite against each other, see
        `core.output.pin_beam.PinBeam.pair_stiffness`; not beside `made`.
    made : callable, optional
        Forces of the mechanism as it is made, see `core.output.real_turn.made`.

    Returns
    -------
    PinStrength

    Raises
    ------
    InvalidInput
        If a size is out of range or a satellite is not between the supports.
    ImpossibleMechanism
        If the mechanism has a dead centre.

    Notes
    -----
    Source of the ideal forces: Yanchevskiy and Niekhoroshykh 2021, eq. (10); the rest is derived,
    see docs/theory.md. In reverse an ideal pin feels the same forces the other way, half a turn of
    the wave later. A pin shorter than half its diameter bends less than its seat gives way.

    Examples
    --------
    Six pins, two satellites, 500 N*m: every point of the root has the same amplitude.

    >>> steel = ElasticMaterial(210e9, 0.3, yield_strength=800e6)
    >>> pin = {"output_torque": 500.0, "pin_circle_radius": 0.05, "diameter": 0.016,
    ...        "contact_length": 0.02, "satellite_positions": (0.015, 0.037), "material": steel}
    >>> found = pin_strength(
    ...     mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0), **pin,
    ...     fatigue=FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6))
    >>> round(found.peak_bending_stress/1e6, 6), round(found.fatigue.safety_factor, 6)
    (306.704838, 1.504829)
    """
    check_positive(
        output_torque=output_torque,
        application_factor=application_factor,
        pin_circle_radius=pin_circle_radius,
    )
    torque = application_factor * output_torque
    static_torque = torque if peak_torque is None else peak_torque
    check_positive(peak_torque=static_torque)
    if support != "cantilever" and span is None:
        raise InvalidInput("span", None, "needed", field="support")
    beam = PinBeam.round(
        support=support,
        diameter=diameter,
        contact_length=contact_length,
        youngs_modulus=material.youngs_modulus,
        poissons_ratio=material.poissons_ratio,
        span=span if support != "cantilever" else None,
    )
    _check_positions(mechanism, satellite_positions, contact_length, beam.span)
    pin = _Pin(beam, diameter, np.array(satellite_positions))
    ways = WAYS[torque_direction]
    static = 1.0
    if made is None:
        peak = force_peak(mechanism, force_exponent)
        cases = _ideal_cases(
            mechanism=mechanism,
            force_exponent=force_exponent,
            reference=torque / pin_circle_radius,
            ways=ways,
            stiffnesses=(None,) if pair_stiffness is None else (None, pair_stiffness),
        )
        error = 8 * peak.accuracy.relative_error + ENOUGH
        error += ROUNDING * (64 + 16 * force_exponent)
        method, evaluations = "locus_support", cases[0].turn.forces[0].size
        static = static_torque / torque
    else:
        turns = [made(way * torque) for way in ways]
        cases = _made_cases(turns)
        error = max(turn.error for turn in turns)
        method, evaluations = "sampling", sum(turn.evaluations for turn in turns)
    wanted = fatigue, rotates, deflection, locus
    strength = _worst([_strength(pin, case, mechanism, *wanted) for case in cases])
    if made is not None and static_torque != torque:
        most = max(
            pin.equivalent(case)
            for case in _made_cases([made(way * static_torque) for way in ways])
        )
        static = most / strength.peak_equivalent_stress
    notices = []
    cycle = strength.fatigue
    if cycle is not None and cycle.cycles is not None:
        if input_speed is not None:
            frequency = input_speed * (1 + 1 / mechanism.ratio) / (2 * math.pi)
            cycle = replace(cycle, life=cycle.cycles / frequency)
        if cycle.cycles is not None and cycle.cycles < LOW_CYCLES:
            notices.append(Notice("low_cycle_fatigue"))
    if min(satellite_positions) < diameter / 2:
        notices.append(Notice("short_pin"))
    accuracy = Accuracy(method, error + _of_two_supports(beam, satellite_positions), evaluations)
    safety = None
    if material.yield_strength is not None:
        safety = material.yield_strength / (static * strength.peak_equivalent_stress)
    return replace(
        strength,
        static_safety_factor=safety,
        fatigue=cycle,
        accuracy=accuracy,
        notices=(*notices, *poorly_known(accuracy)),
    )


@dataclass(frozen=True, slots=True)
class _Case:
    """Forces on a pin, in a unit, N, negative in reverse; of ideal ones both ways where it
    alternates.
    """

    turn: PinTurn | PinSamples
    unit: float
    alternates: bool = False
    sharing: Sharing | None = None
    pin: int = 1
    wave: FloatArray | None = None


def _ideal_cases(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    reference: float,
    ways: tuple[float, ...],
    stiffnesses: tuple[tuple[float, ...] | None, ...],
) -> list[_Case]:
    """All pins are alike; of an alternating torque the reverse is the same the other way."""
    return [
        _Case(
            turn=pin_turn(mechanism, force_exponent, each),
            unit=ways[0] * reference,
            alternates=len(ways) > 1,
            sharing="equal" if each is None else "stiffness",
        )
        for each in stiffnesses
    ]


def _made_cases(turns: list[SampledTurn]) -> list[_Case]:
    """Each pin under all directions."""
    wave = np.concatenate([turn.wave for turn in turns])
    return [
        _Case(
            turn=PinSamples(np.concatenate([turn.on_pins[:, n] for turn in turns], axis=1)),
            unit=1.0,
            pin=n + 1,
            wave=wave,
        )
        for n in range(turns[0].on_pins.shape[1])
    ]


@dataclass(frozen=True)
class _Pin:
    """A pin as a beam, and where satellites load it."""

    beam: PinBeam
    diameter: float
    positions: FloatArray

    @property
    def area(self) -> float:
        """Of its section, m^2."""
        return math.pi * self.diameter**2 / 4

    @property
    def modulus(self) -> float:
        """Section modulus W, m^3."""
        return math.pi * self.diameter**3 / 32

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of loads and supports: the root alone of a cantilever, as no other section is
        worse.
        """
        if self.beam.span is None:
            return np.zeros(1)
        half = self.beam.contact_length / 2
        ends = [0.0, *(self.positions - half), *(self.positions + half), self.beam.span]
        return np.unique(np.clip(ends, 0, self.beam.span))

    def moments(self, x: FloatArray, unit: float) -> FloatArray:
        """Bending stress at sections by unit forces of the satellites."""
        found: FloatArray = unit / self.modulus * self.beam.moment(x[:, None], self.positions)
        return found

    def shears(self, x: FloatArray, unit: float) -> FloatArray:
        """Mean shear stress of the same."""
        found: FloatArray = unit / self.area * self.beam.shear(x[:, None], self.positions)
        return found

    def curvature(self, case: _Case) -> float:
        """Largest second derivative of the bending stress along the pin."""
        most = float(np.abs(case.turn.forces).sum(axis=0).max())
        return abs(case.unit) / self.modulus * most / float(self.beam.contact_length)

    def bending(self, case: _Case) -> tuple[float, float]:
        """Largest bending stress of any section, and its place."""
        curvature = self.curvature(case)

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            arms = (self.moments(at.section, case.unit),)
            values = largest(turn=case.turn, arms=arms, measure=np.abs, rounds=rounds)
            return values, curvature * at.length**2 / 8

        bent, place, _ = highest(value=value, ends=self.ends)
        return bent, place

    def equivalent(self, case: _Case) -> float:
        """Largest equivalent stress of any section."""
        curvature = self.curvature(case)

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            arms = self.moments(at.section, case.unit), self.shears(at.section, case.unit)
            values = largest(turn=case.turn, arms=arms, measure=_stress, rounds=rounds)
            return values, curvature * at.length**2 / 8

        return highest(value=value, ends=self.ends)[0]

    def cycle(
        self, case: _Case, strength: FatigueStrength, bent: float
    ) -> tuple[float, float, float, float]:
        """Largest and least stress of the worst cycle, its section and direction."""
        curvature = self.curvature(case)
        steepest = curvature * float(self.beam.contact_length)

        def cycles(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            """Largest and least stress of points of the edge."""
            arms = self.moments(at.section, case.unit) * np.exp(-1j * at.direction)[:, None]
            both = (np.concatenate((arms, -arms)),)
            found = largest(turn=case.turn, arms=both, measure=np.real, rounds=rounds)
            top, bottom = found[: len(arms)], -found[len(arms) :]
            if case.alternates:
                top = np.maximum(top, -bottom)
                bottom = -top
            return top, bottom

        def used(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            top, bottom = cycles(at, rounds)
            use: FloatArray = strength.utilisation((top - bottom) / 2, (top + bottom) / 2)
            room = (steep * at.length**2 + use * at.angle**2) / 8
            if strength.criterion == "fkm_haigh" and always_loaded:
                # its line is less steep beyond R = 0 and R = 0.5: the utilisation may be
                # largest where it has a corner, from which it falls at once
                reach = (bent * at.angle + steepest * at.length) / 2
                corner = np.minimum(abs(bottom), abs(2 * bottom - top) / 3) <= reach
                more = strength.utilisation((top - bottom) / 2 + reach, (top + bottom) / 2)
                room = room + corner * (more - use)
            return use, room

        always_loaded = bool(np.abs(case.turn.forces).sum(axis=0).min() > 0)
        steep = strength.utilisation(curvature, 0.0) + strength.utilisation(0.0, curvature)
        _, seen, angle = highest(value=used, ends=self.ends, around=True)
        at = Points(np.array([seen]), np.array([angle]), np.zeros(1), 0.0)
        top, bottom = cycles(at, ROUNDS)
        return float(top[0]), float(bottom[0]), seen, angle


def _strength(
    pin: _Pin,
    case: _Case,
    mechanism: Mechanism,
    fatigue: FatigueStrength | None,
    rotates: bool,
    deflection: bool,
    locus: bool,
) -> PinStrength:
    """Strength of a pin under the forces of a case."""
    bent, place = pin.bending(case)
    arms = (pin.shears(pin.ends, case.unit),)
    mean_shear = float(largest(turn=case.turn, arms=arms, measure=np.abs).max())
    force = largest(turn=case.turn, arms=(np.eye(len(pin.positions)),), measure=np.abs)
    forces = abs(case.unit) * force
    cycle, chi, seen = None, None, place
    if fatigue is not None:
        top, bottom = bent, -bent
        if not rotates:
            top, bottom, seen, angle = pin.cycle(case, fatigue, bent)
            chi = _turned(angle)
        cycle = judged(strength=fatigue, direction=chi, position=seen, largest=top, least=bottom)
    return PinStrength(
        peak_force=float(forces.max()),
        peak_moment=bent * pin.modulus,
        peak_moment_position=place,
        peak_bending_stress=bent,
        peak_shear_force=mean_shear * pin.area,
        peak_shear_stress=4 / 3 * mean_shear,
        peak_equivalent_stress=pin.equivalent(case),
        static_safety_factor=None,
        fatigue=cycle,
        deflection=_deflection(pin, case, forces) if deflection else None,
        locus=_locus(pin, case, mechanism, seen, chi) if locus else None,
        sharing=case.sharing,
        pin=case.pin,
        accuracy=Accuracy("locus_support", 0.0, 0),
        notices=(),
    )


def _worst(cases: list[PinStrength]) -> PinStrength:
    """The largest of all, with the fatigue, else the stress, of the worst."""
    bent = max(cases, key=lambda each: each.peak_moment)
    most = max(each.peak_equivalent_stress for each in cases)
    if cases[0].fatigue is None:
        worst = max(cases, key=lambda each: each.peak_equivalent_stress)
    else:
        worst = min(cases, key=lambda each: each.fatigue.safety_factor)  # type: ignore[union-attr]
    deflections = [each.deflection for each in cases if each.deflection is not None]
    deflection = max(deflections, key=lambda each: each.deflection, default=None)
    if deflection is not None:
        rows = zip(*(each.slopes for each in deflections), strict=True)
        deflection = replace(deflection, slopes=tuple(max(each) for each in rows))
        rows = zip(*(each.forces for each in deflections), strict=True)
        deflection = replace(deflection, forces=tuple(max(each) for each in rows))
    return replace(
        worst,
        peak_force=max(each.peak_force for each in cases),
        peak_moment=bent.peak_moment,
        peak_moment_position=bent.peak_moment_position,
        peak_bending_stress=bent.peak_bending_stress,
        peak_shear_force=max(each.peak_shear_force for each in cases),
        peak_shear_stress=max(each.peak_shear_stress for each in cases),
        peak_equivalent_stress=most,
        deflection=deflection,
    )


def _check_positions(
    mechanism: Mechanism, positions: tuple[float, ...], length: float, span: float | None
) -> None:
    """Refuse satellites whose contact is not on the pin."""
    name = "satellite_positions"
    if len(positions) != mechanism.satellites:
        count = {"expected": mechanism.satellites, "actual": len(positions)}
        raise InvalidInput(name, len(positions), "different_length", **count)
    slack = 4 * ROUNDING
    for index, z in enumerate(positions):
        if not z >= length / 2 * (1 - slack):
            raise InvalidInput(f"{name}[{index}]", z, "in_carrier", field="contact_length")
        if span is not None and not z + length / 2 <= span * (1 + slack):
            raise InvalidInput(f"{name}[{index}]", z, "beyond_support", field="span")


def _stress(bending: ComplexArray, mean_shear: ComplexArray) -> FloatArray:
    """Equivalent stress."""
    found: FloatArray = section_stress(bending=bending, mean_shear=mean_shear)
    return found


def _locus(
    pin: _Pin, case: _Case, mechanism: Mechanism, position: float, chi: float | None
) -> MomentLocus:
    """The locus of a section, with its stress in a direction, else in that of the largest
    moment.
    """
    arms = pin.moments(np.array([position]), case.unit)
    if isinstance(case.turn, PinTurn):
        places, forces = case.turn.drawn()
        if case.unit < 0:
            places = (places + 0.5) % 1.0
            first = int(places.argmin())
            places, forces = np.roll(places, -first), np.roll(forces, -first, axis=1)
        angles = places * mechanism.crank_angle_per_wave
    else:
        assert case.wave is not None
        forces = case.turn.forces
        angles = (case.wave - mechanism.initial_crank_angle) / (1 + 1 / mechanism.ratio)
    stress = combine(arms=arms, forces=forces)[0]
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
    """What is lost where a support is near a satellite: there the deflection is small beside its
    parts, by the cube of the distance.
    """
    if beam.span is None:
        return 0.0
    near = min(min(positions), beam.span - max(positions))
    found: float = 8 * ROUNDING * (beam.span / near) ** 3
    return found


def _deflection(pin: _Pin, case: _Case, forces: FloatArray) -> PinDeflection:
    """Deflection and rotation where the pin bends most in the middle of a satellite."""
    z, beam = pin.positions, pin.beam
    bent = np.stack((beam.deflection(z[:, None], z), beam.slope(z[:, None], z)))
    arms = case.unit * bent.reshape(-1, len(z))
    found = largest(turn=case.turn, arms=(arms,), measure=np.abs)
    deflections, slopes = found.reshape(2, -1)
    satellite = int(deflections.argmax())
    return PinDeflection(
        satellite=satellite + 1,
        deflection=float(deflections[satellite]),
        slope=float(slopes[satellite]),
        slopes=tuple(slopes.tolist()),
        forces=tuple(forces.tolist()),
    )


def _turned(chi: float) -> float:
    """Direction from 0 to less than a turn."""
    chi %= 2 * math.pi
    return chi if AT_ZERO < chi < 2 * math.pi - AT_ZERO else 0.0
