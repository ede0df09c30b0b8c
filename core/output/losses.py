"""Friction of the pins in the holes: sliding speed, loss, efficiency, pv and wear.

A satellite moves against the output link in a circle of the eccentricity's radius without turning,
so every contact slides at ``e*w``, w being the crank's speed against the output link. All forces of
a satellite act along its crank. The loss is the friction coefficient times the sliding speed times
the sum of all contact forces, and only this sum changes over the turn.

The sum over F0 is ``sum c^v / sum c^(1 + v)`` with the cosines c of the driving pairs. For v = 1
and an even number m of evenly spaced phases ``sum c^2 = m/4`` is constant: the mean is then 4/pi
exactly, the largest value ``4/(m*sin(pi/m))``, the least ``4/(m*tan(pi/m))``. In all other cases
the mean is integrated from one switching angle to the next by the tanh-sinh rule, because a cosine
to the power v has no derivatives at a switching angle and this rule needs none there.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from core.arrays import FloatArray, Number, check_not_negative, check_positive, every, refuse
from core.errors import Accuracy, Notice, NotKnown, poorly_known, required
from core.fields import answer, answered
from core.numerics.extremes import zoom
from core.numerics.quadrature import tanh_sinh_rule
from core.output.contact_force import AT_SWITCH, PHASE_ROUNDING, force_peak, force_ratios
from core.output.driving_set import Segment, segments
from core.output.mechanism import Mechanism, WavePhases
from core.output.pin_circle_load import PinCircleLoad
from core.output.sampled_turn import PinForces
from core.precision import CONVERGED, ROUNDING

COARSEST, FINEST = 3, 9
"""Levels of the first and the last rule: 56 and some 3500 nodes a segment."""

MANY = 200
"""Number of driving pairs above which a quarter of the nodes is enough at first, as each pair
changes little."""

SWITCHING = 1e-13
"""Cosine below which a pair begins or ends to drive. Phases merged over a larger distance, in
turns, differ by more than rounding."""


@dataclass(frozen=True, slots=True)
class TotalForce:
    """Sum of all contact forces over F0; pairs at their switching angle count for v = 0 only."""

    mean: float  # mean over the whole turn
    least: float  # least value; ranges shorter than `SAME` are left out
    largest: float  # largest value; ranges shorter than `SAME` are left out
    accuracy: Accuracy  # that of the largest contact force too


@lru_cache(maxsize=1024)
def total_force(*, mechanism: Mechanism, force_exponent: float = 1.0) -> TotalForce:
    """Sum of the contact forces over F0 over the turn (Yanchevskiy and Niekhoroshykh 2021, eq. 10);
    the module's docstring has the method. `ImpossibleMechanism` is raised at a dead centre.
    """
    peak = force_peak(mechanism, force_exponent)  # refuses what cannot be
    phases = mechanism.phases
    count = len(phases.sector_phases) * phases.pins
    if force_exponent == 1 and len(phases.sector_phases) == phases.symmetry and count % 2 == 0:
        error = max(peak.accuracy.relative_error, 4 * ROUNDING + 4 * math.pi * phases.error)
        return TotalForce(
            mean=4 / math.pi,
            least=4 / (count * math.tan(math.pi / count)),
            largest=4 / (count * math.sin(math.pi / count)),
            accuracy=Accuracy("closed_form_even", error, 1),
        )
    parts = [_Sums(part, force_exponent) for part in segments(phases)]
    means = [(part.width, *part.mean()) for part in parts]
    turn = sum(width for width, *_ in means)
    mean = sum(width * each for width, each, *_ in means) / turn
    truncation = sum(width * off for width, _, off, _ in means) / turn
    least, largest = (_extreme(parts, sign) for sign in (-1, 1))
    return TotalForce(
        mean=mean,
        least=-least[0],
        largest=largest[0],
        accuracy=Accuracy(
            "segments_tanh_sinh",
            max(
                peak.accuracy.relative_error,
                truncation / mean + _rounding(parts, phases, [least, largest]),
            ),
            sum(evaluations for *_, evaluations in means),
        ),
    )


class _Sums:
    """Total force over F0 in one segment; places are the best pair's pressure angle, turns."""

    def __init__(self, part: Segment, exponent: float) -> None:
        self.low, self.high = part.low, part.high
        self.width = part.high - part.low
        self.exponent = exponent
        self.phase, self.weight = part.driving.pairs()
        self.coarsest = COARSEST if len(self.phase) <= MANY else COARSEST - 2

    def cosines(self, places: FloatArray) -> FloatArray:
        """Cosines of the pressure angles, shape (pairs, places)."""
        away = 0.25 - np.abs(np.add.outer(self.phase, places))
        nothing = AT_SWITCH if 0 < self.exponent < 1 else 0.0
        return np.where(away > nothing, np.sin(2 * np.pi * away), 0.0)

    def ratio(self, places: FloatArray) -> FloatArray:
        """Total force over F0 at places."""
        cosines = self.cosines(places)
        best = cosines.max(axis=0)
        cosines /= best  # no power under- or overflows
        powers = cosines**self.exponent
        total: FloatArray = self.weight @ powers / (best * (self.weight @ (powers * cosines)))
        return total

    def nodes(self, level: int) -> tuple[FloatArray, FloatArray]:
        """Nodes and weights of a rule for the segment."""
        near, weights = tanh_sinh_rule(level)
        below, above = self.low + self.width * near, self.high - self.width * near
        return np.concatenate((below, above[::-1])), np.concatenate((weights, weights[::-1]))

    def mean(self) -> tuple[float, float, int]:
        """Mean of the total force, its error, and the number of evaluations."""
        enough = CONVERGED + 8 * ROUNDING * self.exponent
        _, weights = self.nodes(self.coarsest)
        _, values = self.samples
        before, evaluations = float(weights @ values[1:-1]), len(values)
        for level in range(self.coarsest + 1, FINEST + 1):
            places, weights = self.nodes(level)
            mean = float(weights @ self.ratio(places))
            evaluations += len(places)
            off, before = abs(mean - before), mean
            if off <= enough * mean:
                break
        return mean, off, evaluations

    @cached_property
    def samples(self) -> tuple[FloatArray, FloatArray]:
        """Nodes of the coarsest rule with both ends of the segment, and the total force there."""
        inner, _ = self.nodes(self.coarsest)
        places = np.concatenate(([self.low], inner, [self.high]))
        return places, self.ratio(places)

    def summits(self, sign: int) -> Iterator[tuple[float, float, float, float]]:
        """Samples larger than their neighbours (sign 1) or smaller (sign -1), times the sign:
        value, bound between the neighbours, places of the neighbours.
        """
        places, values = self.samples
        values = sign * values
        around = np.concatenate((values[:1], values, values[-1:]))
        for index in np.flatnonzero((around[:-2] <= values) & (values >= around[2:])).tolist():
            first, last = max(index - 1, 0), min(index + 1, len(places) - 1)
            drop = values[index] - min(values[first], values[last])
            yield values[index], values[index] + drop, places[first], places[last]

    def zoom(self, start: float, stop: float, sign: int) -> tuple[float, float]:
        """Largest total force times the sign between two places, and its place."""
        places, heights, _ = zoom(
            values=lambda places: sign * self.ratio(places),
            places=np.array([(start + stop) / 2]),
            width=(stop - start) / 2,
            low=start,
            high=stop,
        )
        return float(heights[0]), float(places[0])

    def least_cosine(self) -> float:
        """Least mean cosine of the driving pairs."""
        ends = self.cosines(np.array([self.low, self.high]))
        return float((self.weight @ ends).min() / self.weight.sum())

    def slope(self, place: float) -> float:
        """Relative change of ``sum c^v`` with the phases of all pairs at a place, 1/rad. Pairs that
        begin or end to drive there are left out, as the place moves with them.
        """
        cosines = self.cosines(np.array([place]))[:, 0]
        inside = cosines > SWITCHING
        relative = cosines[inside] / cosines.max()
        sines = np.abs(np.sin(2 * np.pi * (self.phase[inside] + place)))
        weight, powers = self.weight[inside], relative**self.exponent
        change = self.exponent * (weight @ (powers / relative * sines))
        return float(change / (cosines.max() * (weight @ powers)))


Extreme = tuple[float, float, _Sums]
"""Largest value of a sign times the total force, its place, and its segment."""


def _extreme(parts: list[_Sums], sign: int) -> Extreme:
    """Largest total force over all segments, or least one for the sign -1."""
    summits = [(*each, part) for part in parts for each in part.summits(sign)]
    highest = max(each[0] for each in summits)
    return max(
        (
            (*part.zoom(start, stop, sign), part)
            for _, bound, start, stop, part in summits
            if bound >= highest
        ),
        key=lambda each: each[0],
    )


def _rounding(parts: list[_Sums], phases: WavePhases, extremes: list[Extreme]) -> float:
    """Relative error of mean and extremes by rounding, mainly of the phases."""
    exponent = parts[0].exponent
    # sum c^v changes by v*sum c^(v - 1) at most, which for v >= 1 is below v*n/sum c of itself; for
    # v < 1 the c^v of each pair rises by 1 and falls by 1 in a turn, and sum c^v >= sum c.
    first = max(exponent, 1.0) / min(part.least_cosine() for part in parts)
    off = PHASE_ROUNDING + phases.error
    if exponent < 1:
        first = max(first, *(part.slope(place) for _, place, part in extremes))
    if 0 < exponent < 1:
        off += AT_SWITCH
    second = (1 + exponent) * extremes[-1][0]
    wrong = 2 * math.pi * off
    error = ROUNDING * (16 + 8 * exponent) + wrong * (first + second)
    if 0 < exponent < 1 and phases.error > SWITCHING:
        # Pairs taken to begin as others end leave out a cosine of that size, to the power v.
        error += (2 * math.pi * phases.error) ** exponent
    return error


@dataclass(frozen=True, slots=True)
class BarePins:
    """Pins that slide in their holes."""

    hole_radius: Number  # r_out, m

    def slowed(self, pin_radius: Number) -> Number:
        """Ratio 1: bare pins slide at the full speed of a pin in its hole."""
        return 1.0

    def sleeve_speed(self, sliding: Number, pin_radius: Number) -> Number | None:
        """None, as bare pins have no sleeves."""
        return None

    def hole_wear(self, worn: Number) -> Number:
        """Depth of wear of the hole, m, by its area of wear, m^2."""
        return worn / self.hole_radius


@dataclass(frozen=True, slots=True)
class Sleeves:
    """Sleeves on the pins, or rolling bearings, which roll in the holes and do not wear them."""

    diameter: Number  # 2*r_p of the pin in them, m, < 2*r_s

    def slowed(self, pin_radius: Number) -> Number:
        """Sliding speed over that of a bare pin: diameter of the pin over that of the sleeve."""
        check_positive(diameter=self.diameter)
        room = self.diameter < 2 * pin_radius
        if not every(room):
            than = {"field": "pin_radius", "limit": 2 * pin_radius}
            refuse("diameter", self.diameter, room, "no_sleeve", **than)
        return self.diameter / (2 * pin_radius)

    def sleeve_speed(self, sliding: Number, pin_radius: Number) -> Number | None:
        """Speed of the sleeves against their pins, rad/s, by the speed of a bare pin, m/s."""
        return sliding / pin_radius

    def hole_wear(self, worn: Number) -> Number:
        """Raise `NotKnown`: nothing slides in the hole."""
        raise NotKnown("wear_unknown")


@dataclass(frozen=True, slots=True, kw_only=True)
class PinLosses:
    """Friction of the pins in the holes, or on their sleeves."""

    relative_speed: Number = answer("rpm", "n")
    """Speed of the crank relative to the pins, n₁·(1 + 1/u)."""
    sliding_speed: Number = answer("m_per_s", "v")
    """Sliding speed of the pin in the hole, e·ω, or of the pin in its sleeve, e·ω·r_p/r_s."""
    sleeve_speed: Number | None = answer("rpm", "n_s")
    """Speed of the sleeves relative to their pins, n·e/r_s."""
    output_power: Number = answer("W", "P₂")
    """Power of the output, T·ω₁/u."""
    mean_total_force_ratio: Number = answer("", "⟨ΣF⟩/F₀")
    """Mean over the turn of the sum of all contact forces, over F₀ = T/R; 4/π for linear contacts
    and an even number of evenly spaced phases."""
    mean_loss: Number = answer("W", "P")
    """Mean power loss over the turn, of μ·v·ΣF."""
    efficiency: Number = answer("", "η")
    """Efficiency of the output mechanism alone, P₂/(P₂ + P) with the mean loss."""
    min_efficiency: Number = answer("", "η_min")
    """Least efficiency over the turn."""
    max_efficiency: Number = answer("", "η_max")
    """Largest efficiency over the turn."""
    peak_force: Number = answer("N", "F_max")
    """Largest contact force over the turn."""
    peak_pv: Number = answer("MPa_m_per_s", "(pv)_max")
    """Largest force over the projected area 2·r·b, times e·ω, as in the limits of bushes. A bare
    pin touches its wider hole along a narrow strip, where the value is higher."""
    mean_pv: Number = answer("MPa_m_per_s", "(pv)_m")
    """Mean force of all pairs over the turn over the projected area 2·r·b, times e·ω."""
    friction_couple: Number = answer("", "ΔP/P")
    """Share of the torque that friction itself carries on the mean, μ·r·⟨ΣF⟩/T: to the first order
    the loss is too large by this share."""
    wear_rate: Number | None  # k, m^2/N, where it is given
    rubbed: Number  # way that rubs over the life, over 2*pi and the contact's length, dimensionless
    pin_radius: Number  # radius that touches the hole, m
    rubbing: BarePins | Sleeves  # bare pins, or pins with sleeves
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer()  # of results that are hardly known

    @property
    @answered("mm", "h_in", optional=True)
    def pin_wear(self) -> Number:
        """Largest depth of wear of the pin, k·F_max·e/(b·r) per turn of the relative speed."""
        return self._worn / self.pin_radius

    @property
    @answered("mm", "h_out", optional=True)
    def hole_wear(self) -> Number:
        """Largest depth of wear of the hole, k·F_max·e/(b·r_out) per turn of the relative speed;
        absent with sleeves, which roll in the hole.
        """
        return self.rubbing.hole_wear(self._worn)

    @property
    def _worn(self) -> Number:
        """Area worn away under the largest force, m^2."""
        rate = required(self.wear_rate, "wear_unknown", "friction.wear_rate")
        return rate * self.peak_force * self.rubbed


def pin_losses(
    *,
    load: PinCircleLoad[PinForces],
    input_speed: Number,
    output_power: Number,
    eccentricity: Number,
    pin_radius: Number,
    contact_length: Number,
    friction_coefficient: Number,
    rubbing: BarePins | Sleeves,
    distribution_factor: Number = 1.0,
    wear_rate: Number | None = None,
    life: Number = math.inf,
) -> PinLosses:
    """Sliding speed, loss, efficiency, pv and wear of the pins in the holes.

    With ``w = w_in*(1 + 1/u)`` pins slide in the holes at ``v = e*w``. A sleeve of outer radius r_s
    on a pin of radius r_p rolls in the hole, turns at ``w*e/r_s`` and slides on its pin at
    ``v = e*w*r_p/r_s``. The loss is ``P = mu*v*sum F``, so that

        eta = 1/(1 + mu*(e/R)*(u + 1)*(r_p/r_s)*sum F/F0),   pv = F/(2*r*b)*e*w

    with the radius r that touches the hole. The contact sweeps each surface once in a turn of w:
    its depth of wear is then ``k*F*e/(b*r)`` on the pin, with or without sleeve, and
    ``k*F*e/(b*r_out)`` in the hole (Archard 1953).

    Forces are the ideal ones of Yanchevskiy and Niekhoroshykh 2021, eq. (10). To the first order in
    mu, for v = 1 and an even number of phases, eta is eq. (5) of Wang, Luo and Su 2016. Friction
    does not change the forces here, though its couple ``mu*r*sum F`` helps the torque. Heat, oil
    film and seals are left out. `ImpossibleMechanism` is raised if the mechanism has a dead centre.

    The speed w_in of the crank against the ring, rad/s, is 0 where both turn together; the output
    power, W, > 0, is ``T*w_in/u`` if the pins alone are the output. The pin radius, m, > 0, is the
    one that touches the hole: r_in, or r_s of a sleeve. The factor K_alpha >= 1 of uneven sharing
    on the largest force counts for pv and wear where they are largest; the loss is that of all
    forces together. The wear rate k is volume over force and distance, m^2/N, the life, s, the time
    in which pins wear.

    Six pins, two satellites, 500 N*m at 75 rpm, mu = 0.08: 336 W of 3927 W are lost.

    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    >>> found = pin_losses(
    ...     load=PinCircleLoad(mechanism=six, output_torque=500.0, pin_circle_radius=0.05),
    ...     input_speed=50*math.pi, output_power=1250*math.pi, eccentricity=0.002,
    ...     pin_radius=0.008, contact_length=0.02, friction_coefficient=0.08,
    ...     rubbing=BarePins(0.010))
    >>> round(found.mean_loss, 3), round(found.efficiency, 6), round(found.min_efficiency, 6)
    (336.0, 0.921182, 0.917768)
    """
    check_positive(
        output_power=output_power,
        eccentricity=eccentricity,
        pin_radius=pin_radius,
        contact_length=contact_length,
        distribution_factor=distribution_factor,
    )
    check_not_negative(
        friction_coefficient=friction_coefficient, input_speed=input_speed, life=life
    )
    if wear_rate is not None:
        check_not_negative(wear_rate=wear_rate)
    slows = rubbing.slowed(pin_radius)
    mechanism, radius = load.mechanism, load.pin_circle_radius
    total = total_force(mechanism=mechanism, force_exponent=load.force_exponent)
    reference = load.output_torque / radius
    relative_speed = input_speed * mechanism.waves_per_turn
    sliding = eccentricity * relative_speed
    sliding_speed = sliding * slows
    loss = friction_coefficient * sliding_speed * reference
    share = loss / output_power
    peak = force_peak(mechanism, load.force_exponent).peak_force_ratio
    peak_force = distribution_factor * reference * peak
    pv = sliding / (2 * pin_radius * contact_length)
    accuracy = total.accuracy._replace(relative_error=total.accuracy.relative_error + 24 * ROUNDING)
    return PinLosses(
        relative_speed=relative_speed,
        sliding_speed=sliding_speed,
        sleeve_speed=rubbing.sleeve_speed(sliding, pin_radius),
        output_power=output_power,
        mean_total_force_ratio=total.mean,
        mean_loss=loss * total.mean,
        efficiency=1 / (1 + share * total.mean),
        min_efficiency=1 / (1 + share * total.largest),
        max_efficiency=1 / (1 + share * total.least),
        peak_force=peak_force,
        peak_pv=pv * peak_force,
        mean_pv=pv * reference * (total.mean / (mechanism.pins * mechanism.satellites)),
        wear_rate=wear_rate,
        rubbed=sliding * life / (2 * math.pi) / contact_length,
        pin_radius=pin_radius,
        rubbing=rubbing,
        friction_couple=friction_coefficient * slows * (pin_radius / radius) * total.mean,
        accuracy=accuracy,
        notices=poorly_known(accuracy),
    )


@dataclass(frozen=True, slots=True)
class LossCurves:
    """Loss and efficiency over the turn."""

    crank_angle: FloatArray = answer("deg", "φ")
    """Crank angles, evenly spaced."""
    loss: FloatArray = answer("W", "P")
    """Power loss by friction, μ·v·ΣF."""
    efficiency: FloatArray = answer("", "η")
    """Output power over the sum of output power and loss."""


def loss_curves(
    *, losses: PinLosses, mechanism: Mechanism, force_exponent: float, crank_angle: FloatArray
) -> LossCurves:
    """Loss and efficiency at crank angles, rad, shape (n,), from the losses of a design."""
    ratios = force_ratios(
        mechanism=mechanism, crank_angles=crank_angle, force_exponent=force_exponent
    )
    loss = losses.mean_loss * (ratios.sum(axis=(1, 2)) / losses.mean_total_force_ratio)
    return LossCurves(
        crank_angle=crank_angle, loss=loss, efficiency=1 / (1 + loss / losses.output_power)
    )
