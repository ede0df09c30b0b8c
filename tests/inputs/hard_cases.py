"""Stiff and extreme cases: our error, the stated one, and that of the papers' literal forms.

Each case says why it is hard. A refusal counts as right where the case has no answer.
"""

import math
import statistics
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from mpmath import mp, mpf

from core.arrays import FloatArray
from core.errors import CalculationError
from core.hertz import ElasticMaterial, hertz
from core.output.contact_force import peak_force
from core.output.mechanism import Mechanism, pin_geometry
from core.precession.contact_line import contact_lines
from core.precession.meshing_load import meshing_load
from core.precession.rollers import RollerByAngle, RollerByLength
from core.precession.shaft import ShaftSection
from core.precession.shaft_deflection import shaft_deflection
from core.rollers.roller_strength import roller_arguments, roller_strength
from tests.oracles.crank_planetary import peak
from tests.oracles.precession import (
    length_by_angle,
    length_by_z,
    load_integrals,
    scale,
)
from tests.oracles.rollers import exact_compliance, exact_forces
from tests.oracles.shaft import exact_deflection

Answer = tuple[float, float]
"""A number and its stated relative error."""


@dataclass(frozen=True)
class Case:
    """One hard case."""

    calculation: str
    name: str
    reason: str
    ours: Callable[[], Answer]
    exact: Callable[[], mpf] | None  # None: has no answer and must be refused
    literal: Callable[[], float] | None = None


@dataclass(frozen=True)
class Row:
    """Result of a case."""

    case: Case
    error: float | None  # None: refused
    stated: float | None
    literal: str
    run_time_us: float

    @property
    def good(self) -> bool:
        """Right to the stated error, or refused where there is no answer."""
        if self.case.exact is None:
            return self.error is None
        return self.error is not None and self.stated is not None and self.error <= self.stated


def _peak(mechanism: Mechanism, exponent: float) -> Answer:
    found = peak_force(mechanism=mechanism, force_exponent=exponent)
    return found.peak_force_ratio, found.accuracy.relative_error


def _sampled(mechanism: Mechanism, exponent: float) -> float:
    """Peak as eq. (11) of 2021 is written, at 361 angles: a grid, powers of small cosines."""
    psi = np.linspace(0, 2 * np.pi, 361) * (1 + 1 / mechanism.ratio)
    phases = [
        alpha + 2 * np.pi * n / mechanism.pins
        for alpha in mechanism.crank_angles
        for n in range(mechanism.pins)
    ]
    cosines = np.cos(np.pi / 2 + psi[:, None] + np.array(phases)[None, :])
    cosines = np.where(cosines >= 0, cosines, 0.0)
    shares = (cosines ** (1 + exponent)).sum(axis=1, keepdims=True)
    return float((cosines**exponent * (cosines > 0) / shares).max())


def _peak_cases() -> Iterator[Case]:
    angles = (0.0, 1.0, 2.1)

    def case(
        name: str, reason: str, mechanism: Mechanism, exponent: float, dead: bool = False
    ) -> Case:
        return Case(
            "peak force",
            name,
            reason,
            lambda: _peak(mechanism, exponent),
            None
            if dead
            else lambda: (
                peak(mechanism.pins, mechanism.crank_angles, exponent, screened=True).ratio
            ),
            lambda: _sampled(mechanism, exponent),
        )

    for exponent, reason in (
        (0.0, "the force jumps where a pair starts; the peak sits on the jump"),
        (1e-9, "nearly jumps"),
        (10 / 9, "the peak may hide 1e-3 rad beside a switching angle"),
        (1e3, "nearly only the best placed pair carries; peaks 1e-3 wide"),
        (1e6, "peaks 1e-6 wide; powers of cosines underflow"),
    ):
        yield case(f"v = {exponent:g}", reason, Mechanism(5, angles, 20.0), exponent)
    yield case(
        "v = 4.09, one satellite", "the summit of three driving pairs has parted in two",
        Mechanism(5, (0.3,), 20.0), 4.09,
    )  # fmt: skip
    yield case(
        "v = 3e-8 beside a dead centre", "the slope is the difference of numbers 1e6 times larger",
        Mechanism(2, (0.0, 2e-6), 20.0), 3e-8,
    )  # fmt: skip
    for margin in (1e-3, 1e-8):
        yield case(
            f"gap of pi - {margin:g}", "the force grows as 1/margin",
            Mechanism(2, (0.4, 0.4 + margin), 20.0), 1.0,
        )  # fmt: skip
    yield case("gap of exactly pi", "dead centre", Mechanism(2, (0.0,), 20.0), 1.0, dead=True)
    yield case(
        "phases a rounding error apart", "slivers between switching angles",
        Mechanism(3, (0.0, 2 * math.pi / 3 * (1 + 2**-51)), 20.0), 1.5,
    )  # fmt: skip
    for ratio in (1e-6, 1e9):
        yield case(
            f"u = {ratio:g}",
            "a million waves a turn, or nearly one",
            Mechanism(3, angles, ratio),
            1.0,
        )
    many = Mechanism.evenly_spaced(pins=100, satellites=100, ratio=20.0, crank_spacing=1.0)
    yield Case(
        "peak force", "10,000 pairs, v = 1", "300 driving sets of 5,000 pairs",
        lambda: _peak(many, 1.0), lambda: mpf(4) / 10_000, lambda: _sampled(many, 1.0),
    )  # fmt: skip


def _p1_forces(radius: float) -> float:
    """Peak as eq. (4) of 2018 is written, arcsines and all, on a grid of half degrees; L = 1."""
    waves = np.radians(np.arange(0, 360, 0.5))
    placed = (waves[:, None] + 2 * np.pi * np.arange(3) / 3 + np.pi) % (2 * np.pi) - np.pi
    alpha = np.clip(placed, -np.pi / 2, np.pi / 2)
    rest = np.pi / 2 - alpha
    op = np.sqrt(1 + radius**2 - 2 * radius * np.cos(rest))
    beta = np.pi / 2 - np.arcsin(np.sin(rest) / op)
    reach = op * np.cos(beta)
    return float((reach / (reach * np.cos(alpha)).sum(axis=1, keepdims=True)).max())


def _p1_cases() -> Iterator[Case]:
    mechanism = Mechanism(3, (0.0,), 20.0)
    for radius, reason in (
        (0.5, "the form of 2018 takes the arcsine of numbers above 1"),
        (1.0, "the form of 2018 divides 0 by 0"),
    ):
        yield Case(
            "peak force", f"pins of r = {radius:g}*L, v = 1", reason,
            lambda: _peak(mechanism, 1.0),
            lambda: peak(3, (0.0,), 1.0).ratio,
            lambda radius=radius: _p1_forces(radius),
        )  # fmt: skip


def _geometry_cases() -> Iterator[Case]:
    """Contact point of pin 1 with satellite 1, its error over the radius of the pin circle."""
    pins, ratio, circle, eccentricity = 3, 20.0, 0.05, 0.0015

    def case(name: str, reason: str, degrees: float, pin: float) -> Case:
        hole = pin + eccentricity

        def ours() -> Answer:
            found = pin_geometry(
                mechanism=Mechanism(pins, (0.0,), ratio), crank_angle=math.radians(degrees),
                pin_circle_radius=circle, pin_radius=pin, hole_radius=hole,
                eccentricity=eccentricity,
            )  # fmt: skip
            return float(found.contact_points[0, 0, 0]), found.accuracy.relative_error

        def exact() -> mpf:
            angle = mpf(degrees) * mp.pi / 180
            return -mpf(circle) * mp.sin(angle / ratio) - mpf(pin) * mp.sin(angle)

        def literal() -> float:
            """Common point of the two circles, C1 = sqrt(...) as printed before eq. (6)."""
            angle = degrees * math.pi / 180
            e, x = eccentricity, -circle * math.sin(angle / ratio)
            c1 = math.sqrt(
                2 * e**2 * hole**2 + 2 * e**2 * pin**2 + 2 * hole**2 * pin**2
                - e**4 - pin**4 - hole**4
            ) / (2 * e)  # fmt: skip
            c2 = (hole**2 - pin**2 - e**2) / (2 * e)
            return x - c2 * math.sin(angle) + c1 * math.cos(angle)

        return Case("pin geometry", name, reason, ours, exact, literal)

    yield case("r_out = r_in + e", "C1 is the root of a difference that is 0", 30.0, 0.005)
    yield case("r_out = r_in + e, 7 mm", "C1 is the root of a rounding error", 30.0, 0.007)
    yield case("r_out = r_in + e, 6 mm", "C1 is the root of a rounding error", 30.0, 0.006)
    yield case("phi = 1e12 degrees", "whole turns by the billion", 1e12 + 0.125, 0.005)


def _hertz_cases() -> Iterator[Case]:
    steel = ElasticMaterial(210e9, 0.3)

    def case(
        name: str, reason: str, *, ratio: float = 1.25, other: ElasticMaterial = steel,
        force: float = 1e3,
    ) -> Case:  # fmt: skip
        radius, length = 0.008, 0.02
        hole = radius * ratio
        moduli = [
            mpf(each.youngs_modulus) / (1 - mpf(each.poissons_ratio) ** 2)
            for each in (steel, other)
        ]

        def ours() -> Answer:
            found = hertz(
                force=force, contact_length=length, pin_radius=radius, hole_radius=hole,
                pin_material=steel, hole_material=other,
            )  # fmt: skip
            return found.max_pressure, found.accuracy.relative_error

        def exact() -> mpf:
            gap = mpf(hole) - mpf(radius)
            modulus = 1 / (1 / moduli[0] + 1 / moduli[1])
            return mp.sqrt(
                mpf(force) / mpf(length) * modulus * gap / (mp.pi * mpf(hole) * mpf(radius))
            )

        def literal() -> float:
            # radii in mm with three decimals, as drawings give them, and rho = R*r/(R - r)
            r, big = round(radius * 1e3, 3), round(hole * 1e3, 3)
            rho = big * r / (big - r) * 1e-3
            factor = 1 / (math.pi * (2 * (1 - 0.3**2) / 210e9))
            return math.sqrt(factor * force / length / rho)

        return Case("Hertz", name, reason, ours, exact, literal if other is steel else None)

    for excess in (1e-12, 1e-6, 1e6):
        yield case(
            f"R/r - 1 = {excess:g}", "nearly equal radii: R - r loses digits", ratio=1 + excess
        )
    yield case("E ratio 1e9", "one body rigid", other=ElasticMaterial(210e18, 0.3))
    yield case("v = 0.4999999", "nearly incompressible", other=ElasticMaterial(1e7, 0.4999999))
    for force in (1e-12, 1e12):
        yield case(f"F = {force:g} N", "24 decades of load", force=force)


def _roller_cases() -> Iterator[Case]:
    def case(name: str, reason: str, length: float, delta: float, rollers: int) -> Case:
        design = {
            "output_torque": 210.0, "hole_circle_radius": 0.03, "rollers": rollers,
            "cylinder_length": 0.01 * length, "sphere_width": 0.008, "sphere_diameter": 0.015,
            "diameter": 0.01, "friction_coefficient": 0.16, "youngs_modulus": 210e9,
            "poissons_ratio": 0.3, "stress_concentration": 2.0,
        }  # fmt: skip
        stiffness = 1 / exact_compliance(design)
        total = mpf(210) / (2 * mpf("0.03"))
        tolerance = float(delta * total / rollers / stiffness)

        def ours() -> Answer:
            found = roller_strength(**roller_arguments(**design, position_tolerance=tolerance))
            return found.bending_stress, found.accuracy.relative_error

        def exact() -> mpf:
            torque = mpf(210.0) / (2 * mpf(0.03))
            force = exact_forces(
                torque, stiffness, [mpf(0)] + [4 * mpf(tolerance)] * (rollers - 1)
            )[0]
            lever = mpf(design["cylinder_length"]) + mpf(0.008) / 2 + mpf(0.16) * mpf(0.015) / 2
            return 2 * lever * force * 32 / (mp.pi * mpf(0.01) ** 3)

        def literal() -> float:
            """Eq. (12) as printed: n before the bending part of the compliance only."""
            a, b, big, d, k, e = 0.01 * length, 0.008, 0.015, 0.01, 0.16, 210e9
            bending = (k * big + b) * a / 4 + a**2 / 3 + b * (a + k * big + b) / 4
            inertia, area = math.pi * d**4 / 64, math.pi * d**2 / 4
            compliance = rollers * a / (e * inertia) * bending + 1.11 / (e / 2.6 * area) * (
                a + b / 2
            )
            force = 210.0 / (2 * 0.03 * rollers) + 4 * tolerance * (rollers - 1) / compliance
            return 2 * (a + b / 2 + k * big / 2) * force * 32 / (math.pi * d**3)

        return Case("roller strength", name, reason, ours, exact, literal)

    for length in (1e-6, 1.0, 1e6):
        yield case(f"l/d = {length:g}", "shear alone, both, bending alone", length, 0.05, 4)
    for delta in (0.0, 1.0, 1e12):
        yield case(f"delta = {delta:g}", "all carry, the limit, one carries all", 2.0, delta, 4)
    for rollers in (1, 2):
        yield case(f"n = {rollers}", "the fewest rollers", 2.0, 1.0, rollers)


def _printed_stretch(
    gear: dict[str, float], phi_1: float, phi: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Root of eq. (4) with the slope (5) as the printed difference; Simpson's weights times rho."""
    rho = gear["roller_radius"]
    theta = gear["nutation_angle"]
    a = gear["roller_circle_radius"] * (math.cos(theta) - gear["ratio_u12"])
    slope = a * np.cos(phi) / (rho * np.sin(phi_1 + phi) * math.sin(theta)) - a * np.sin(
        phi
    ) * np.cos(phi_1 + phi) / (rho * np.sin(phi_1 + phi) ** 2 * math.sin(theta))
    weights = np.full(len(phi), 2.0)
    weights[1::2] = 4.0
    weights[[0, -1]] = 1.0
    return np.sqrt(1 + slope**2), rho * (phi[-1] - phi[0]) / (3 * (len(phi) - 1)) * weights


def _simpson_as_printed(gear: dict[str, float], phi_1: float, low: float, high: float) -> float:
    """Eq. (4) by Simpson's rule at 1001 points."""
    stretch, weights = _printed_stretch(gear, phi_1, np.linspace(low, high, 1001))
    return abs(float(weights @ stretch))


def _line_cases() -> Iterator[Case]:
    base = {
        "roller_circle_radius": 0.05, "roller_radius": 0.004,
        "nutation_angle": math.radians(6), "ratio_u12": 0.96,
    }  # fmt: skip

    def by_angle(name: str, reason: str, phi_1: float, low: float, high: float) -> Case:
        def ours() -> Answer:
            found = contact_lines(**base, rollers=[RollerByAngle(phi_1, low, high)])
            return found.total_length, found.accuracy.relative_error

        return Case(
            "contact line", name, reason, ours,
            lambda: length_by_angle(
                scale(0.05, base["nutation_angle"], 0.96), phi_1, 0.004, low, high
            ),
            lambda: _simpson_as_printed(base, phi_1, low, high),
        )  # fmt: skip

    def by_length(name: str, reason: str, phi_1: float, **change: float) -> Case:
        gear = base | change
        low, high = 0.015, 0.025

        def ours() -> Answer:
            found = contact_lines(**gear, rollers=[RollerByLength(phi_1, low, high)])
            return found.total_length, found.accuracy.relative_error

        def literal() -> float:
            theta = gear["nutation_angle"]
            a = 0.05 * (math.cos(theta) - gear["ratio_u12"]) / math.sin(theta)
            ends = [math.atan2(-z * math.sin(phi_1), a + z * math.cos(phi_1)) for z in (low, high)]
            return _simpson_as_printed(gear, phi_1, *sorted(ends))

        return Case(
            "contact line", name, reason, ours,
            lambda: length_by_z(
                scale(0.05, gear["nutation_angle"], gear["ratio_u12"]), phi_1, 0.004,
                mpf(low), mpf(high),
            ),
            literal,
        )  # fmt: skip

    yield by_angle("end 1e-12 from a pole", "the line is 1e10 long there", 0.5, -0.5 + 1e-12, 0.3)
    yield by_angle(
        "end 1e-6 from a pole", "nearly all of the length at one end", 0.5, -0.499999, 0.3
    )
    yield by_length("phi1 = 1e-9", "the slope as a difference cancels", 1e-9)
    yield by_length(
        "theta = 1e-8", "cos(theta) - 1 cancels", 0.5, nutation_angle=1e-8, ratio_u12=1.0
    )
    near = math.cos(math.radians(6))
    yield by_length("cos(theta) - u12 = 1e-12", "nearly no line", 0.5, ratio_u12=near - 1e-12)
    yield Case(
        "contact line", "cos(theta) = u12", "no line at all",
        lambda: (
            contact_lines(
                **(base | {"ratio_u12": near}), rollers=[RollerByLength(0.5, 0.015, 0.025)]
            ).total_length,
            0.0,
        ),
        None,
        lambda: _simpson_as_printed(base | {"ratio_u12": near}, 0.5, -0.3, -0.2),
    )  # fmt: skip


def _load_cases() -> Iterator[Case]:
    gear = {
        "roller_circle_radius": 0.05, "roller_radius": 0.004,
        "nutation_angle": math.radians(6), "ratio_u12": 0.96,
    }  # fmt: skip
    torque = 10.0

    def case(name: str, reason: str, phi_1: float, low: float, high: float) -> Case:
        curve_scale = scale(0.05, gear["nutation_angle"], gear["ratio_u12"])

        def ours() -> Answer:
            found = meshing_load(
                **gear, rollers=[RollerByLength(phi_1, low, high)], torque=torque, reference_z=0.02
            )
            return math.hypot(*found.force), found.accuracy.relative_error

        def exact() -> mpf:
            x, y, *_ = load_integrals(curve_scale, 0.05, 0.004, phi_1, low, high, 0.02)
            length = length_by_z(curve_scale, phi_1, 0.004, mpf(low), mpf(high))
            return torque / length * mp.hypot(x, y)

        def literal() -> float:
            """Eqs (8)-(13) over phi by Simpson's rule, the slope as the printed difference."""
            a = float(curve_scale)
            ends = sorted(
                math.atan2(-z * math.sin(phi_1), a + z * math.cos(phi_1)) for z in (low, high)
            )
            phi = np.linspace(*ends, 1001)
            stretch, weights = _printed_stretch(gear, phi_1, phi)
            arm = -0.05 * np.sin(phi)
            length = weights @ stretch
            x, y = (weights @ (stretch * n / arm) for n in (np.sin(phi), -np.cos(phi)))
            return abs(torque / length) * math.hypot(x, y)

        return Case("meshing load", name, reason, ours, exact, literal)

    yield case("30 degrees, 15 to 25 mm", "the usual case", math.radians(30), 0.015, 0.025)
    yield case("from 1e-9 m", "the arm is nearly zero at one end", 0.5, 1e-9, 0.025)
    yield case("phi1 = 1e-9", "no arm, and the slope as a difference cancels", 1e-9, 0.015, 0.025)
    yield case("a thousandth of 1e-9 wide", "hardly any length", 0.5, 0.02, 0.02 * (1 + 1e-12))
    yield Case(
        "meshing load", "across z = 0", "the load would be unbounded",
        lambda: (
            meshing_load(
                **gear, rollers=[RollerByLength(0.5, -0.01, 0.02)], torque=torque, reference_z=0.02
            ).force[0],
            0.0,
        ),
        None,
        case("", "", 0.5, -0.01, 0.02).literal,
    )  # fmt: skip


def _shaft_cases() -> Iterator[Case]:
    def case(name: str, reason: str, a: float, b: float, diameters: tuple[float, float]) -> Case:
        force, moment = (168.75, -337.5, 0.0), (-0.03125, -0.0703125, 10.0)
        sections = [(a, diameters[0]), (b, diameters[1])]

        def ours() -> Answer:
            found = shaft_deflection(
                force=force, moment=moment, bearing_distance=a, overhang=b, youngs_modulus=210e9,
                shaft_sections=[ShaftSection(*section) for section in sections],
            )  # fmt: skip
            return found.deflection_C.y, found.accuracy.relative_error

        def exact() -> mpf:
            lever = -mpf(moment[0]) / mpf(a)
            return exact_deflection(sections, a, b, 210e9, lever, mpf(force[1]) - lever, mpf(0))

        def literal() -> float:
            """Eq. (33) as printed: smallest diameter, unit load at the wrong bearing."""
            rigidity = 210e9 * math.pi * min(diameters) ** 4 / 64
            at_b = moment[0] / a
            at_c = -force[1] - at_b
            return (-at_c * (a * b**2 / 2 + b**3 / 3) - at_b * b**3 / 3) / rigidity

        return Case("shaft deflection", name, reason, ours, exact, literal)

    yield case("a/b = 1e-9", "bearings close together: huge reactions", 2.0**-30, 1.0, (0.02, 0.02))
    yield case("a/b = 1", "the usual case", 0.03125, 0.03125, (0.02, 0.02))
    yield case("a/b = 1e9", "no overhang", 1.0, 2.0**-30, (0.02, 0.02))
    yield case(
        "EI over 30 decades", "one stretch takes all the bending", 0.03125, 0.03125, (1.0, 3e-8)
    )


def cases() -> Iterator[Case]:
    """Every case, calculation by calculation."""
    yield from _peak_cases()
    yield from _p1_cases()
    yield from _geometry_cases()
    yield from _hertz_cases()
    yield from _roller_cases()
    yield from _line_cases()
    yield from _load_cases()
    yield from _shaft_cases()


def run(case: Case) -> Row:
    """Run a case and compare."""
    times, error, stated = [], None, None
    exact = case.exact() if case.exact is not None else None
    for _ in range(3):
        start = time.perf_counter_ns()
        try:
            value, stated = case.ours()
            error = 0.0 if exact is None else float(abs(mpf(value) - exact) / abs(exact))
        except CalculationError:
            error = stated = None
        times.append((time.perf_counter_ns() - start) / 1000)
    return Row(case, error, stated, _literally(case, exact), statistics.median(times))


def _literally(case: Case, exact: mpf | None) -> str:
    """Error of the literal form, or how it fails."""
    if case.literal is None:
        return "-"
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            value = case.literal()
    except (ArithmeticError, ValueError) as failure:
        return type(failure).__name__
    if not math.isfinite(value):
        return "NaN" if math.isnan(value) else "infinite"
    if exact is None:
        return f"gives {value:.1e}"
    return f"{float(abs(mpf(value) - exact) / abs(exact)):.1e}"
