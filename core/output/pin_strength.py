"""Strength of the pins: bending, shear and deflection over the turn, static safety, fatigue.

The force on a pin turns while it grows and falls, so that no fixed rule says what cycle the stress
makes: it follows from the locus that the bending moment of a section describes over the turn. With
the support function ``h(chi)``, the locus' largest moment in the direction chi, a point of the
section's edge goes from ``-h(chi + pi)/W`` to ``h(chi)/W``, ``W = pi*d^3/32``.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.fatigue import LOW_CYCLES
from core.materials import ElasticMaterial
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, Support, section_stress
from core.output.pin_fatigue import FatigueStrength, PinFatigue, judged
from core.output.pin_forces import reference_force
from core.output.pin_search import ENOUGH, ROUNDS, Points, highest, largest
from core.output.pin_turn import ComplexArray, PinTurn, combine, pin_turn
from core.results import ROUNDING, Accuracy, Notice, poorly_known

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
    turn = pin_turn(mechanism, force_exponent)
    positions = np.array(satellite_positions)
    ends = _ends(beam, positions)
    area, modulus = math.pi * diameter**2 / 4, math.pi * diameter**3 / 32
    unit = reference / modulus

    def moments(x: FloatArray) -> FloatArray:
        """By unit forces, as stresses."""
        arms: FloatArray = unit * beam.moment(x[:, None], positions)
        return arms

    def shears(x: FloatArray) -> FloatArray:
        """The same as mean stresses."""
        arms: FloatArray = reference / area * beam.shear(x[:, None], positions)
        return arms

    steepest = unit * float(np.abs(turn.forces).sum(axis=0).max())
    curvature = steepest / contact_length

    def bending(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
        values = largest(turn=turn, arms=(moments(at.section),), measure=np.abs, rounds=rounds)
        return values, curvature * at.length**2 / 8

    def equivalent(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
        arms = moments(at.section), shears(at.section)
        values = largest(turn=turn, arms=arms, measure=_stress, rounds=rounds)
        return values, curvature * at.length**2 / 8

    bent, place, _ = highest(value=bending, ends=ends)
    most, _, _ = highest(value=equivalent, ends=ends)
    mean_shear = float(largest(turn=turn, arms=(shears(ends),), measure=np.abs).max())
    cycle, chi, seen, notices = None, None, place, []
    if fatigue is not None:
        extremes = bent, -bent
        if not rotates:

            def cycles(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
                """Largest and least stress of points of the edge."""
                arms = moments(at.section) * np.exp(-1j * at.direction)[:, None]
                both = (np.concatenate((arms, -arms)),)
                found = largest(turn=turn, arms=both, measure=np.real, rounds=rounds)
                return found[: len(arms)], -found[len(arms) :]

            def used(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
                top, bottom = cycles(at, rounds)
                use: FloatArray = fatigue.utilisation((top - bottom) / 2, (top + bottom) / 2)
                room = (steep * at.length**2 + use * at.angle**2) / 8
                if fatigue.criterion == "fkm_haigh" and always_loaded:
                    # its line is less steep beyond R = 0 and R = 0.5: the utilisation may be
                    # largest where it has a corner, from which it falls at once
                    reach = (bent * at.angle + steepest * at.length) / 2
                    corner = np.minimum(abs(bottom), abs(2 * bottom - top) / 3) <= reach
                    more = fatigue.utilisation((top - bottom) / 2 + reach, (top + bottom) / 2)
                    room = room + corner * (more - use)
                return use, room

            always_loaded = bool(np.abs(turn.forces).sum(axis=0).min() > 0)
            steep = fatigue.utilisation(curvature, 0.0) + fatigue.utilisation(0.0, curvature)
            _, seen, angle = highest(value=used, ends=ends, around=True)
            at = Points(np.array([seen]), np.array([angle]), np.zeros(1), 0.0)
            top, bottom = cycles(at, ROUNDS)
            chi, extremes = _turned(angle), (float(top[0]), float(bottom[0]))
        cycle = judged(
            strength=fatigue, direction=chi, position=seen, largest=extremes[0], least=extremes[1]
        )
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
        + ENOUGH
        + ROUNDING * (64 + 16 * force_exponent)
        + _of_two_supports(beam, satellite_positions),
        turn.forces[0].size,
    )
    strength = material.yield_strength
    return PinStrength(
        peak_force=reference * peak.peak_force_ratio,
        peak_moment=bent * modulus,
        peak_moment_position=place,
        peak_bending_stress=bent,
        peak_shear_force=mean_shear * area,
        peak_shear_stress=4 / 3 * mean_shear,
        peak_equivalent_stress=most,
        static_safety_factor=None if strength is None else strength / most,
        fatigue=cycle,
        deflection=_deflection(turn, beam, positions, reference) if deflection else None,
        locus=_locus(turn, mechanism, seen, moments(np.array([seen])), modulus, chi)
        if locus
        else None,
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


def _stress(bending: ComplexArray, mean_shear: ComplexArray) -> FloatArray:
    """Equivalent stress."""
    found: FloatArray = section_stress(bending=bending, mean_shear=mean_shear)
    return found


def _locus(
    turn: PinTurn,
    mechanism: Mechanism,
    position: float,
    arms: FloatArray,
    modulus: float,
    chi: float | None,
) -> MomentLocus:
    """The locus by what the satellites' forces bend, with its stress in a direction, else in that
    of the largest moment.
    """
    places, forces = turn.drawn()
    moment = combine(arms=modulus * arms, forces=forces)[0]
    if chi is None:
        chi = float(np.angle(moment[np.abs(moment).argmax()]))
    return MomentLocus(
        position=position,
        crank_angle=places * mechanism.crank_angle_per_wave,
        tangential=moment.real,
        radial=moment.imag,
        stress=(moment * np.exp(-1j * chi)).real / modulus,
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


def _ends(beam: PinBeam, positions: FloatArray) -> FloatArray:
    """Ends of loads and supports: the root alone of a cantilever, as no other section is worse."""
    if beam.span is None:
        return np.zeros(1)
    half = beam.contact_length / 2
    ends = [0.0, *(positions - half), *(positions + half), beam.span]
    return np.unique(np.clip(ends, 0, beam.span))


def _deflection(
    turn: PinTurn, beam: PinBeam, positions: FloatArray, reference: float
) -> PinDeflection:
    """Deflection and rotation where the pin bends most in the middle of a satellite."""
    bent = np.stack(
        (beam.deflection(positions[:, None], positions), beam.slope(positions[:, None], positions))
    )
    arms = bent.reshape(-1, len(positions))
    found = largest(turn=turn, arms=(arms,), measure=np.abs)
    deflections, slopes = found.reshape(2, -1)
    satellite = int(deflections.argmax())
    return PinDeflection(
        satellite + 1,
        reference * float(deflections[satellite]),
        reference * float(slopes[satellite]),
    )


def _turned(chi: float) -> float:
    """Direction from 0 to less than a turn."""
    chi %= 2 * math.pi
    return chi if AT_ZERO < chi < 2 * math.pi - AT_ZERO else 0.0
