"""Strength of the pins: bending, shear and deflection over the turn, static safety, fatigue.

The force on a pin turns while it grows and falls, so that no fixed rule says what cycle the stress
makes: it follows from the locus that the bending moment of a section describes over the turn. With
the support function ``h(chi)``, the locus' largest moment in the direction chi, a point of the
section's edge goes from ``-h(chi + pi)/W`` to ``h(chi)/W``, ``W = pi*d^3/32``.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from core.arrays import FloatArray, Number
from core.errors import InvalidInput
from core.fatigue import (
    LOW_CYCLES,
    Criterion,
    EnduranceFactors,
    cycles_to_failure,
    utilisation,
)
from core.materials import ElasticMaterial
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, Support
from core.output.pin_forces import reference_force
from core.output.pin_turn import ComplexArray, PinTurn, combine, pin_turn
from core.results import ROUNDING, Accuracy, Notice, poorly_known

DIRECTIONS = 144
"""Directions of stress that are looked at first."""

ROUNDS = 7
"""How often a range of sections is narrowed to an eighth."""

NEAR = 1e-5
"""How far apart directions are of which one is seen to be worse, rad."""

NARROW = 1e-7
"""Range of directions, rad, within which the utilisation does not change: by its square."""

MOST_LOOKS = 24
"""Most directions that are looked at about a summit."""

SECTIONS = 8
"""Parts of each stretch between ends of loads and supports at which sections are looked at."""

TURNS_BETWEEN = 40
"""Most changes between the worst section in one direction and the worst direction of one."""

SETTLED = 1e-12
"""Relative growth by such a change that ends them."""

FLAT = 1e-4
"""Relative error of direction, amplitude and mean: the utilisation is flat about its largest."""


def section_stress(*, bending: Number, mean_shear: Number) -> Number:
    """Largest equivalent stress (Mises) of a round section in bending and shear.

    The shear stress is largest, 4/3 of its mean, where there is no bending. With the moment's
    stress m and ``v = sqrt(3)*4/3*V/A`` as vectors of the section it is
    ``sqrt((|m|^2 + |v|^2 + |m^2 - v^2|)/2)``, squares as of complex numbers: the larger of the two
    where they are parallel, the hypotenuse where they are at right angles.

    Parameters
    ----------
    bending : complex, float or array
        ``M/W``, Pa, in the direction of the force that makes it.
    mean_shear : complex, float or array
        ``V/A``, Pa, in its direction.

    Returns
    -------
    float or array
        Pa.

    Notes
    -----
    Derived with Jourawski's shear stress, at the edge along the edge: there, at the angle phi,
    ``s^2*cos^2(phi) + t^2*sin^2(phi - beta)``, whose largest value this is; inside it is less.

    Examples
    --------
    >>> round(section_stress(bending=50.0, mean_shear=40.0), 4)
    92.376
    """
    shear = math.sqrt(3) * 4 / 3 * mean_shear
    apart = abs(bending * bending - shear * shear)
    return ((abs(bending) ** 2 + abs(shear) ** 2 + apart) / 2) ** 0.5


@dataclass(frozen=True, slots=True)
class FatigueStrength:
    """What the fatigue of a pin is judged by.

    Attributes
    ----------
    endurance_limit : float
        Endurance limit Se, Pa.
    tensile_strength : float
        Tensile strength Rm, Pa.
    yield_strength : float or None
        Yield strength Re, Pa.
    criterion : {"goodman", "gerber", "soderberg", "fkm_haigh"}
        How the mean stress counts.
    factors : EnduranceFactors or None
        What the limit was made of; None where it was given.
    """

    endurance_limit: float
    tensile_strength: float
    yield_strength: float | None = None
    criterion: Criterion = "goodman"
    factors: EnduranceFactors | None = None

    def __post_init__(self) -> None:
        for name in ("endurance_limit", "tensile_strength"):
            if not getattr(self, name) > 0:
                raise InvalidInput(name, getattr(self, name), "greater_than", limit=0)
        if self.criterion == "soderberg" and self.yield_strength is None:
            raise InvalidInput("yield_strength", None, "needed", field="criterion")

    def utilisation(self, amplitude: Number, mean: Number) -> Number:
        """Share of the strength that a cycle takes."""
        return utilisation(
            amplitude=amplitude,
            mean=mean,
            endurance=self.endurance_limit,
            tensile_strength=self.tensile_strength,
            yield_strength=self.yield_strength,
            criterion=self.criterion,
        )


@dataclass(frozen=True, slots=True)
class PinFatigue:
    """The worst stress cycle of a pin.

    Attributes
    ----------
    direction : float or None
        Direction chi of the point of the section's edge from the tangential one, towards growing
        pressure angles, rad, 0 to 2*pi; None where the pin rotates and all are alike.
    position : float
        Distance of the section from the carrier's face, m.
    max_stress, min_stress : float
        Largest and least stress there over the turn, Pa.
    amplitude, mean : float
        Of the cycle, Pa.
    endurance_limit : float
        Endurance limit Se, Pa.
    factors : EnduranceFactors or None
        What the limit was made of.
    safety_factor : float
        By the criterion: all stresses may grow by this factor.
    cycles : float or None
        Cycles that it stands, one a turn of the crank against the output; None within the
        endurance limit: as many as there are.
    life : float or None
        The same as time, s, where it is finite and the speed is known.
    """

    direction: float | None
    position: float
    max_stress: float
    min_stress: float
    amplitude: float
    mean: float
    endurance_limit: float
    factors: EnduranceFactors | None
    safety_factor: float
    cycles: float | None
    life: float | None


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
        Largest rotation of the section there over the turn, rad.
    """

    satellite: int
    deflection: float
    slope: float


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
        Yield strength over that, where it is known.
    fatigue : PinFatigue or None
        The worst stress cycle, where it was asked.
    deflection : PinDeflection or None
        Where it was asked.
    locus : MomentLocus or None
        Of the section of the worst cycle, else of the largest moment, where it was asked.
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
) -> PinStrength:
    """Bending, shear, static safety, fatigue and deflection of the pins under the ideal forces.

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
    Source of the forces: Yanchevskiy and Niekhoroshykh 2021, eq. (10); the rest is derived, see
    docs/theory.md. A pin shorter than half its diameter bends less than its seat gives way.

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
    reference = reference_force(output_torque=output_torque, pin_circle_radius=pin_circle_radius)
    if not reference > 0:
        raise InvalidInput("output_torque", output_torque, "greater_than", limit=0)
    peak = force_peak(mechanism, force_exponent)
    beam = PinBeam.round(
        support=support,
        diameter=diameter,
        contact_length=contact_length,
        youngs_modulus=material.youngs_modulus,
        poissons_ratio=material.poissons_ratio,
        span=span if support != "cantilever" else None,
    )
    if support != "cantilever" and span is None:
        raise InvalidInput("span", None, "needed", field="support")
    _check_positions(mechanism, satellite_positions, contact_length, beam.span)
    turn = pin_turn(mechanism, force_exponent)
    pin = _Pin(turn, beam, satellite_positions)
    area, modulus = math.pi * diameter**2 / 4, math.pi * diameter**3 / 32

    def equivalent(moment: ComplexArray, shear: ComplexArray) -> FloatArray:
        found: FloatArray = section_stress(bending=moment / modulus, mean_shear=shear / area)
        return found

    moment, place = pin.worst(lambda moment, _: np.abs(moment))
    shear, _ = pin.worst(lambda _, shear: np.abs(shear))
    most, _ = pin.worst(equivalent)
    bending, most = reference * moment / modulus, reference * most
    cycle = None
    notices = []
    if fatigue is not None:
        unit = reference / modulus
        worst: tuple[float | None, float, float, float] = None, place, bending, -bending
        if not rotates:
            chi, where, largest, least = pin.worst_cycle(fatigue, unit)
            worst = chi, where, largest * unit, least * unit
        cycle = _cycle(fatigue, *worst)
        if input_speed is not None and cycle.cycles is not None:
            frequency = input_speed * (1 + 1 / mechanism.ratio) / (2 * math.pi)
            cycle = replace(cycle, life=cycle.cycles / frequency)
        if cycle.cycles is not None and cycle.cycles < LOW_CYCLES:
            notices.append(Notice("low_cycle_fatigue"))
    if min(satellite_positions) < diameter / 2:
        notices.append(Notice("short_pin"))
    accuracy = Accuracy(
        "locus_support",
        8 * peak.accuracy.relative_error
        + ROUNDING * (64 + 16 * force_exponent)
        + (0.0 if beam.span is None else 4 * SETTLED),
        len(turn.places),
    )
    strength = material.yield_strength
    return PinStrength(
        peak_force=reference * peak.peak_force_ratio,
        peak_moment=reference * moment,
        peak_moment_position=place,
        peak_bending_stress=bending,
        peak_shear_force=reference * shear,
        peak_shear_stress=4 / 3 * reference * shear / area,
        peak_equivalent_stress=most,
        static_safety_factor=None if strength is None else strength / most,
        fatigue=cycle,
        deflection=pin.largest_deflection(reference) if deflection else None,
        locus=_locus(pin, mechanism, reference, modulus, place, cycle) if locus else None,
        accuracy=accuracy,
        notices=(*notices, *poorly_known(accuracy)),
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


def _cycle(
    strength: FatigueStrength,
    direction: float | None,
    position: float,
    largest: float,
    least: float,
) -> PinFatigue:
    """The fatigue of a cycle."""
    amplitude, mean = (largest - least) / 2, (largest + least) / 2
    cycles = cycles_to_failure(
        amplitude=amplitude,
        mean=mean,
        endurance=strength.endurance_limit,
        tensile_strength=strength.tensile_strength,
    )
    return PinFatigue(
        direction=direction,
        position=position,
        max_stress=largest,
        min_stress=least,
        amplitude=amplitude,
        mean=mean,
        endurance_limit=strength.endurance_limit,
        factors=strength.factors,
        safety_factor=1 / float(strength.utilisation(amplitude, mean)),
        cycles=cycles if cycles < math.inf else None,
        life=None,
    )


def _locus(
    pin: "_Pin",
    mechanism: Mechanism,
    reference: float,
    modulus: float,
    place: float,
    cycle: PinFatigue | None,
) -> MomentLocus:
    """The locus of the section that is judged."""
    position = place if cycle is None else cycle.position
    turn = pin.turn
    weights = pin.moments(np.asarray(position))
    moment = reference * combine(weights=weights, forces=turn.forces)
    along = moment[np.abs(moment).argmax()]
    chi = float(np.angle(along))
    if cycle is not None and cycle.direction is not None:
        chi = cycle.direction
    return MomentLocus(
        position=position,
        crank_angle=turn.places * mechanism.crank_angle_per_wave,
        tangential=moment.real,
        radial=moment.imag,
        stress=(moment * np.exp(-1j * chi)).real / modulus,
    )


Measure = Callable[[ComplexArray, ComplexArray], FloatArray]
"""A measure of moments and shear forces, element by element."""


class _Pin:
    """A pin over the turn: where any measure of its sections is largest."""

    def __init__(self, turn: PinTurn, beam: PinBeam, positions: tuple[float, ...]) -> None:
        self.turn, self.beam = turn, beam
        self.positions = np.array(positions)
        half = beam.contact_length / 2
        if beam.span is None:
            self.sections = np.zeros(1)
            return
        ends = np.unique([0.0, *(self.positions - half), *(self.positions + half), beam.span])
        steps = np.linspace(0.0, 1.0, SECTIONS, endpoint=False)
        inner = (ends[:-1, None] + np.diff(ends)[:, None] * steps).ravel()
        self.sections = np.unique(np.clip([*inner, beam.span], 0.0, beam.span))

    def moments(self, x: FloatArray) -> FloatArray:
        """Moment of each satellite's unit force at sections, m, shape (..., K)."""
        found: FloatArray = self.beam.moment(x[..., None], self.positions)
        return found

    def shears(self, x: FloatArray) -> FloatArray:
        """Shear force of each satellite's unit force at sections, shape (..., K)."""
        found: FloatArray = self.beam.shear(x[..., None], self.positions)
        return found

    def candidates(self, values: FloatArray) -> list[int]:
        """Sections that may be the worst beside them."""
        before, after = np.append(values[:1], values[:-1]), np.append(values[1:], values[-1:])
        summit = (values >= before) & (values >= after)
        chosen = summit & (2 * values - np.minimum(before, after) >= values.max() * (1 - 1e-3))
        indices: list[int] = np.flatnonzero(chosen).tolist()
        return indices

    def narrow(self, index: int, value: Callable[[FloatArray], FloatArray]) -> float:
        """Section beside another with the largest value."""
        start = self.sections[max(index - 1, 0)]
        stop = self.sections[min(index + 1, len(self.sections) - 1)]
        for _ in range(ROUNDS):
            places = np.linspace(start, stop, 17)
            best = int(np.argmax(value(places)))
            start, stop = places[max(best - 1, 0)], places[min(best + 1, 16)]
        return float(places[best])

    def worst(self, measure: Measure) -> tuple[float, float]:
        """The largest measure of any section over the turn, and the section."""

        def at(places: FloatArray, forces: ComplexArray) -> FloatArray:
            return measure(
                combine(weights=self.moments(places), forces=forces),
                combine(weights=self.shears(places), forces=forces),
            )

        coarse = at(self.sections, self.turn.forces).max(axis=1)
        found = []
        for index in self.candidates(coarse):
            place, before = np.asarray(self.sections[index]), 0.0
            for _ in range(TURNS_BETWEEN):
                value, forces = self.turn.largest(partial(at, place))
                if len(self.sections) == 1 or value <= before * (1 + SETTLED):
                    break
                before = value
                place = np.asarray(self.narrow(index, partial(at, forces=forces)))
            found.append((max(value, before), float(place)))
        return max(found)

    def worst_cycle(
        self, strength: FatigueStrength, unit: float
    ) -> tuple[float, float, float, float]:
        """Direction and section with the largest utilisation; largest and least moment there."""

        def used(largest: Number, least: Number) -> Number:
            return strength.utilisation(unit * (largest - least) / 2, unit * (largest + least) / 2)

        grid = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
        moments = combine(weights=self.moments(self.sections), forces=self.turn.forces)
        # largest moment of each section in each direction; the least is that of the opposite one
        largest = np.stack([(np.exp(-1j * chi) * moments).real.max(axis=1) for chi in grid], axis=1)
        table = used(largest, -np.roll(largest, DIRECTIONS // 2, axis=1))
        found = []
        for index in self.candidates(table.max(axis=1)):
            place, before = np.asarray(self.sections[index]), 0.0
            for _ in range(TURNS_BETWEEN):
                value, chi, ends = self._worst_direction(place, table[index], grid, used)
                along = (np.exp(-1j * chi) * ends).real
                if len(self.sections) == 1 or value <= before * (1 + SETTLED):
                    break
                before = value

                def at(places: FloatArray, along: FloatArray = along) -> FloatArray:
                    uses: FloatArray = used(*np.moveaxis(self.moments(places) @ along, -1, 0))
                    return uses

                place = np.asarray(self.narrow(index, at))
            most, least = (self.moments(place) @ along).tolist()
            found.append((value, _turned(chi), float(place), most, least))
        return max(found)[1:]

    def _worst_direction(
        self,
        place: FloatArray,
        coarse: FloatArray,
        grid: FloatArray,
        used: Callable[[Number, Number], Number],
    ) -> tuple[float, float, ComplexArray]:
        """Largest utilisation of a section, its direction, and the forces of both ends of the
        cycle.
        """
        weights = self.moments(place)
        moments = combine(weights=weights, forces=self.turn.forces)
        ends = np.zeros((len(weights), 2), dtype=np.complex128)

        def look(chi: float) -> tuple[float, float]:
            """Utilisation in a direction, and how fast it grows with it.

            The forces of both ends turn with the direction too, but at an extreme that changes
            nothing to the first order.
            """
            turned = np.exp(-1j * chi)
            along = (turned * moments).real
            up, down = self.turn.peaks(along), self.turn.peaks(-along)
            index = np.concatenate((up, down))
            signed = turned * np.repeat([1.0, -1.0], [len(up), len(down)])[:, None]
            values, places = self.turn.narrow(
                index, lambda forces: (signed * combine(weights=weights, forces=forces)).real
            )
            chosen = [int(values[: len(up)].argmax()), len(up) + int(values[len(up) :].argmax())]
            ends[:] = self.turn.at(places[chosen], self.turn.segment[index[chosen]])
            own = combine(weights=weights, forces=ends) * turned
            beside = own[:, None] * np.exp(-1j * np.array([0.0, NEAR, -NEAR]))
            value, after, before = used(beside[0].real, beside[1].real).tolist()
            return value, after - before

        around = np.concatenate((coarse[-1:], coarse, coarse[:1]))
        summit = (coarse >= around[:-2]) & (coarse >= around[2:])
        drop = coarse - np.minimum(around[:-2], around[2:])
        step = 2 * np.pi / len(grid)
        best = (-math.inf, 0.0, ends)
        for start in grid[summit & (coarse + drop >= coarse.max())].tolist():
            for value, chi in _climb(look, start, step):
                if value > best[0]:
                    best = value, chi, ends.copy()
        return best

    def largest_deflection(self, reference: float) -> PinDeflection:
        """Deflection and rotation where the pin bends most in the middle of a satellite."""
        turn, beam = self.turn, self.beam

        def largest(weights: FloatArray) -> float:
            return turn.largest(lambda forces: np.abs(combine(weights=weights, forces=forces)))[0]

        most, satellite, z = max(
            (largest(beam.deflection(z, self.positions)), satellite, z)
            for satellite, z in enumerate(self.positions, start=1)
        )
        slope = largest(beam.slope(z, self.positions))
        return PinDeflection(satellite, reference * most, reference * slope)


def _turned(chi: float) -> float:
    """Direction from 0 to less than a turn; a trifle below a turn is 0."""
    chi %= 2 * math.pi
    return chi if chi < 2 * math.pi - NARROW else 0.0


def _climb(
    look: Callable[[float], tuple[float, float]], start: float, step: float
) -> Iterator[tuple[float, float]]:
    """Values on the way to a summit, and their places: regula falsi on the growth, halving behind.

    Parameters
    ----------
    look : callable
        Value and growth at a place.
    start, step : float
        Where it begins, and how far it looks for the other side.

    Yields
    ------
    value, place : float
    """
    value, growth = look(start)
    yield value, start
    if growth == 0:
        return
    low, at_low = start, growth
    for _ in range(3):
        high = low + math.copysign(step, at_low)
        value, at_high = look(high)
        yield value, high
        if at_high * at_low <= 0:
            break
        low, at_low = high, at_high
    else:
        return
    for _ in range(MOST_LOOKS):
        share = at_low / (at_low - at_high) if at_low != at_high else 0.5
        place = low + (high - low) * min(max(share, 0.01), 0.99)
        value, growth = look(place)
        yield value, place
        if growth * at_low > 0:
            low, at_low, at_high = place, growth, at_high / 2
        else:
            high, at_high, at_low = place, growth, at_low / 2
        if growth == 0 or abs(high - low) < NARROW:
            return
