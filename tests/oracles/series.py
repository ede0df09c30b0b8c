"""Ring and output mechanism in series from their definition: points in the plane, 40 digits.

Nothing is shared with ``core``. A disc is a rigid body on its crank, turned back by its lag: the
ring's pins press on its outline, those of the output on its holes, along the lines of centres; its
balance is that of moments about its centre, that of the output one about the axis, all from the
vectors of forces and places. The lags are narrowed by secants until nothing is left: since energy
is convex they are the only ones.
"""

from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpc, mpf

from tests.oracles.load_sharing import _law
from tests.oracles.ring_mesh import DIGITS, Teeth, play, spring

STEP = mpf("1e-14")
"""Of secants, rad."""

LEFT = mpf("1e-26")
"""What is left of a balance over the load."""


@dataclass(frozen=True, slots=True)
class ExactSeries:
    """Lags, forces disc by disc, moments about the centres of the discs, and about the axis."""

    rotation: mpf
    lags: list[mpf]
    force: list[mpf]
    ring_force: list[mpf]
    torques: list[mpf]
    input_torque: mpf
    across: list[mpf]  # force of the ring on each disc
    along: list[mpf]
    on_crank: list[tuple[mpf, mpf]]  # of ring and pins together, along and across


class Body:
    """A disc between ring and pins, at a crank angle."""

    def __init__(self, series: Any, j: int, crank_angle: mpf) -> None:
        ring, real = series.ring, series.output
        self.teeth = Teeth(ring, j, crank_angle)
        self.springs = [spring(ring, self.teeth, k) for k in range(self.teeth.zp)]
        own, errors = real.mechanism, real.deviations

        def error(name: str, *place: int) -> mpf:
            values = getattr(errors, name)
            for index in place:
                values = values[index] if values else 0
            return mpf(values or 0)

        psi = crank_angle * (1 + 1 / mpf(own.ratio)) + mpf(own.initial_crank_angle)
        angle = psi + mpf(own.crank_angles[j]) + error("crank_phase", j)
        self.crank = 1j * mp.expj(-angle)
        self.centre = (mpf(real.eccentricity) + error("eccentricity", j)) * self.crank
        self.pins = []
        for n in range(own.pins):
            way = 1j * mp.expj(2 * mp.pi * n / own.pins)
            circle = mpf(real.pin_circle_radius)
            pin = way * mpc(circle + error("pin_radial", n), error("pin_tangential", n))
            hole = way * mpc(circle + error("hole_radial", j, n), error("hole_tangential", j, n))
            wider = error("hole_radius", j, n) - error("pin_radius", n)
            reach = mpf(real.eccentricity) + mpf(real.clearance) + wider
            radius = mpf(real.pin_radius) + error("pin_radius", n)
            self.pins.append((pin, hole, reach, _law(real, radius, reach, mpf(0))))

    def on_pins(self, lag: mpf, own: mpf) -> tuple[list[mpf], mpf, mpf, mpc]:
        """Forces of the output's pins, their moments on the output about the axis and against the
        disc about its centre, and their sum on the disc.
        """
        forces, on_output, on_disc, total = [], mpf(0), mpf(0), mpc(0)
        for pin, hole, reach, law in self.pins:
            place, arm = pin * mp.expj(-lag), hole * mp.expj(-own)
            apart = place - self.centre - arm
            force = law(abs(apart) - reach)
            pressing = force * apart / abs(apart)  # on the disc, from the hole to the pin
            forces.append(force)
            total += pressing
            on_disc -= (mp.conj(arm) * pressing).imag
            on_output -= (mp.conj(place) * pressing).imag
        return forces, on_output, on_disc, total

    def in_ring(self, own: mpf) -> tuple[list[mpf], mpf, mpc]:
        """Forces of the ring's pins, their moment on the disc as it drives, and their sum on it
        over the direction of the crank.
        """
        forces, moment, total = [], mpf(0), mpc(0)
        for k in range(self.teeth.zp):
            approach, outward = self.teeth.pin(k, own)
            force = self.springs[k](approach)[0] if approach > 0 else mpf(0)
            forces.append(force)
            if force > 0:
                place, radius, _ = self.teeth.pins[k]
                touched = place - radius * outward - self.teeth.centre
                total -= force * outward / self.teeth.crank
                moment -= force * (mp.conj(touched) * outward).imag
        return forces, moment, total


def exact_series(
    series: Any, crank_angle: float, torque: float, near: tuple[float, list[float]]
) -> ExactSeries:
    """The position next to given lags of the output and of the discs."""
    with mp.workdps(DIGITS):
        return _narrowed(series, mpf(crank_angle), mpf(torque), [*map(mpf, (near[0], *near[1]))])


def _narrowed(series: Any, angle: mpf, torque: mpf, lags: list[mpf]) -> ExactSeries:
    count = series.output.mechanism.satellites
    bodies = [Body(series, j, angle) for j in range(count)]

    def off(j: int, lag: mpf, own: mpf) -> tuple[mpf, mpf]:
        """Torque of disc j on the output, and the error of its own balance."""
        _, on_output, on_disc, _ = bodies[j].on_pins(lag, own)
        return on_output, bodies[j].in_ring(own)[1] - on_disc

    for _ in range(8):
        system, left = mp.matrix(count + 1, count + 1), mp.matrix(count + 1, 1)
        left[0] = -torque
        for j in range(count):
            lag, own = lags[0], lags[j + 1]
            on_output, balance = off(j, lag, own)
            left[0] += on_output
            left[j + 1] = balance
            for column, moved in ((0, (lag + STEP, own)), (j + 1, (lag, own + STEP))):
                other = off(j, *moved)
                system[0, column] += (other[0] - on_output) / STEP
                system[j + 1, column] += (other[1] - balance) / STEP
            if system[j + 1, j + 1] == 0:  # nothing holds it: it stays
                system[j + 1, j + 1] = mpf(1)
        if max(map(abs, left)) < LEFT * abs(torque):
            break
        step = mp.lu_solve(system, -left)
        lags = [each + change for each, change in zip(lags, step, strict=True)]
    else:
        raise AssertionError("the lags given are not near a balance")
    force, ring_force, torques, along, across, on_crank, turning = [], [], [], [], [], [], mpf(0)
    for body, own in zip(bodies, lags[1:], strict=True):
        forces, _, _, pins = body.on_pins(lags[0], own)
        teeth, moment, ring = body.in_ring(own)
        force += forces
        ring_force += teeth
        torques.append(moment)
        along.append(-ring.real)
        across.append(ring.imag)
        pins /= body.crank
        turning += abs(body.centre) * (ring + pins).imag
        on_crank.append(((ring + pins).real, (ring + pins).imag))
    return ExactSeries(
        lags[0], lags[1:], force, ring_force, torques, turning, across, along, on_crank
    )


def exact_play(series: Any, crank_angle: float) -> tuple[mpf, mpf]:
    """Lags of the output at which a disc, pushed to its end in the ring, touches its pins."""
    with mp.workdps(DIGITS):
        ends = [[], []]
        for j in range(series.output.mechanism.satellites):
            body = Body(series, j, mpf(crank_angle))
            limits = play([body.teeth])
            assert limits is not None
            for side, own in zip((-1, 1), limits, strict=True):
                free, pressed = mpf(0), mpf("0.02")
                for _ in range(100):
                    between = (free + pressed) / 2
                    forces, *_ = body.on_pins(own + side * between, own)
                    free, pressed = (free, between) if any(forces) else (between, pressed)
                ends[side > 0].append(own + side * free)
        return max(ends[0]), min(ends[1])
