"""Precessional gear: contact-line length by quadrature, in phi as printed and in z without poles;
deflection of the shaft by Mohr's integral, in closed form and by quadrature.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray, Vector
from core.precession.contact_line import ContactLine, contact_lines
from core.precession.rollers import Roller, RollerByLength
from core.precession.shaft import ShaftSection, bearing_reactions
from core.precession.shaft_deflection import shaft_deflection
from core.work_precision.study import (
    DEFAULT,
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)

Gear = dict[str, Any]

Integrand = Callable[[FloatArray], FloatArray]


class Rule(NamedTuple):
    """A quadrature rule at one setting, on [-1, 1]."""

    nodes: FloatArray  # shape (n,)
    weights: FloatArray  # shape (n,)

    def integral(self, integrand: Integrand, start: float, end: float) -> FloatArray:
        """Integral of every component, shape (m,), of an integrand from places, shape (n,), to its
        components there, shape (m, n).
        """
        half = (end - start) / 2
        values = integrand((start + end) / 2 + half * self.nodes)
        return np.asarray(half * (values @ self.weights))


def _gauss_legendre(count: int) -> Rule:
    return Rule(*np.polynomial.legendre.leggauss(count))


def _clenshaw_curtis(count: int) -> Rule:
    angles = np.pi * np.arange(count + 1) / count
    weights = np.ones(count + 1)
    for k in range(1, count // 2 + 1):
        factor = 1.0 if 2 * k == count else 2.0
        weights -= factor * np.cos(2 * k * angles) / (4 * k * k - 1)
    weights *= 2 / count
    weights[[0, -1]] /= 2
    return Rule(np.cos(angles), weights)


def _even(count: int, end: float, odd: float, even: float) -> Rule:
    weights = np.full(count, odd)
    weights[2:-1:2] = even
    weights[[0, -1]] = end
    return Rule(np.linspace(-1.0, 1.0, count), weights * 2 / (count - 1))


def _tanh_sinh(level: int) -> Rule:
    step = 2.0**-level
    t = np.arange(-3.2, 3.2 + step / 2, step)
    inner = np.pi / 2 * np.sinh(t)
    return Rule(np.tanh(inner), step * np.pi / 2 * np.cosh(t) / np.cosh(inner) ** 2)


_STEPS = (9, 33, 129, 513, 2049)

RULES: dict[str, tuple[Callable[[int], Rule], str, tuple[int, ...]]] = {
    "trapezoid": (partial(_even, end=1 / 2, odd=1.0, even=1.0), "points", _STEPS),
    "simpson": (partial(_even, end=1 / 3, odd=4 / 3, even=2 / 3), "points", _STEPS),
    "gauss_legendre": (_gauss_legendre, "points", (2, 4, 8, 16, 32, 64, 128)),
    "clenshaw_curtis": (_clenshaw_curtis, "points", (4, 8, 16, 32, 64, 128)),
    "tanh_sinh": (_tanh_sinh, "level", (1, 2, 3, 4, 5)),
}
"""How each is made at a setting, and its settings: numbers of points, or levels."""


@cache
def rules(code: str) -> dict[int, Rule]:
    """A rule of `RULES` at all its settings."""
    make, _, values = RULES[code]
    return {value: make(value) for value in values}


def _by_rules(
    along: str, value: Callable[[Rule], float | Sequence[float]], intervals: int = 1
) -> list[Method]:
    """All rules as methods whose codes end in `along`: value, or components of a vector, by a rule,
    which is used on so many intervals.
    """

    def by(code: str, setting: int) -> Outcome:
        rule = rules(code)[setting]
        return value(rule), intervals * len(rule.nodes)

    for code in RULES:
        rules(code)  # made before anything is timed
    return [
        Method(f"{code}_{along}", [(name, each) for each in values], partial(by, code))
        for code, (_, name, values) in RULES.items()
    ]


def contact_line_study(*, gear: Gear, rollers: Sequence[Roller]) -> WorkPrecision:
    """Error against run time of the total length of the contact lines.

    Parameters
    ----------
    gear : dict
        roller_circle_radius, roller_radius, nutation_angle, ratio_u12, as `contact_lines` takes.
    rollers : sequence of Roller
        The rollers.

    Returns
    -------
    WorkPrecision
    """
    import mpmath

    lines = contact_lines(**gear, rollers=rollers).lines
    pieces = {along: [_piece(line, along) for line in lines] for along in ("phi", "z")}

    def by(along: str, rule: Rule) -> float:
        # The length counts as positive, whichever way the limits run.
        return math.fsum(abs(float(rule.integral(*piece)[0])) for piece in pieces[along])

    def calculate(_: float) -> Outcome:
        result = contact_lines(**gear, rollers=rollers)
        return result.total_length, result.accuracy.evaluations

    with mpmath.workdps(REFERENCE_DIGITS):
        exact = mpmath.fsum(_exact_lengths(gear, rollers))
    return work_precision(
        reference=Reference("multiple_tanh_sinh"),
        exact=[exact],
        methods=[
            *_by_rules("phi", partial(by, "phi"), len(lines)),
            *_by_rules("z", partial(by, "z"), len(lines)),
            Method("graded_z", DEFAULT, calculate, chosen=True),
        ],
    )


def _piece(line: ContactLine, along: str) -> tuple[Integrand, float, float]:
    """Integrand of the length as eq. (4) of the paper has it over phi, or the same over z, where it
    has no pole; with its limits.
    """
    curve = line.curve
    rho, phi1, width = curve.roller_radius, curve.position_angle, curve.width

    def over_phi(phi: FloatArray) -> FloatArray:
        return np.atleast_2d(rho * np.sqrt(1 + (width / (rho * np.sin(phi + phi1) ** 2)) ** 2))

    def over_z(z: FloatArray) -> FloatArray:
        return np.atleast_2d(np.sqrt(1 + (rho * width / ((z + curve.offset) ** 2 + width**2)) ** 2))

    if along == "phi":
        return over_phi, line.phi_min, line.phi_max
    return over_z, line.z_min, line.z_max


def _exact_lengths(gear: Gear, rollers: Sequence[Roller]) -> Iterator[Any]:
    """Length of each line in multiple precision, from the input as given."""
    import mpmath as mp

    radius, rho = mp.mpf(gear["roller_circle_radius"]), mp.mpf(gear["roller_radius"])
    theta, ratio = mp.mpf(gear["nutation_angle"]), mp.mpf(gear["ratio_u12"])
    scale = radius * (mp.cos(theta) - ratio) / mp.sin(theta)
    for roller in rollers:
        phi1 = mp.mpf(roller.position_angle)
        width, offset = scale * mp.sin(phi1), scale * mp.cos(phi1)
        if isinstance(roller, RollerByLength):
            low, high = mp.mpf(roller.z_min), mp.mpf(roller.z_max)
        else:
            low, high = sorted(
                -scale * mp.sin(phi) / mp.sin(phi + phi1)
                for phi in (mp.mpf(roller.phi_min), mp.mpf(roller.phi_max))
            )
        steep = {factor * width - offset for factor in (-100, -10, -1, 0, 1, 10, 100)}
        breaks = sorted({low, high, *(place for place in steep if low < place < high)})
        grade = rho * width

        def length(z: Any, grade: Any = grade, width: Any = width, offset: Any = offset) -> Any:
            return mp.sqrt(1 + (grade / ((z + offset) ** 2 + width**2)) ** 2)

        yield mp.quad(length, breaks)


def shaft_deflection_study(
    *,
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    shaft_sections: Sequence[ShaftSection],
) -> WorkPrecision:
    """Error against run time of the deflection at C, both planes.

    Parameters
    ----------
    force, moment : tuple of float, shape (3,)
        Force of the mesh, N, and its moment about C, N*m.
    bearing_distance, overhang : float
        Distances a and b, m.
    youngs_modulus : float
        Young's modulus E, Pa.
    shaft_sections : sequence of ShaftSection
        Stretches of the shaft from C to the clamp.

    Returns
    -------
    WorkPrecision
    """
    end = bearing_distance + overhang
    ends = np.cumsum([section.length for section in shaft_sections])
    stiffness = np.array(
        [youngs_modulus * np.pi * section.diameter**4 / 64 for section in shaft_sections]
    )
    at_b, at_c = bearing_reactions(force=force, moment=moment, bearing_distance=bearing_distance)

    def integrand(s: FloatArray) -> FloatArray:
        """Moment of both planes times that of a unit force at C, over E*I, from C at s = 0."""
        behind = np.maximum(0.0, s - bearing_distance)
        rigidity = stiffness[np.minimum(np.searchsorted(ends, s), len(stiffness) - 1)]
        return np.stack([(-at_c[i] * s - at_b[i] * behind) * s / rigidity for i in (0, 1)])

    def by(rule: Rule) -> list[float]:
        return [*rule.integral(integrand, 0.0, end)]

    def closed_form(_: float) -> Outcome:
        result = shaft_deflection(
            force=force,
            moment=moment,
            bearing_distance=bearing_distance,
            overhang=overhang,
            youngs_modulus=youngs_modulus,
            shaft_sections=shaft_sections,
        )
        return [result.deflection_C.x, result.deflection_C.y], 1

    return work_precision(
        reference=Reference("multiple_closed_form"),
        exact=_exact_deflection(force, moment, bearing_distance, youngs_modulus, shaft_sections),
        methods=[
            *_by_rules("shaft", by),
            Method("closed_form", DEFAULT, closed_form, chosen=True),
        ],
    )


def _exact_deflection(
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    youngs_modulus: float,
    sections: Sequence[ShaftSection],
) -> list[Any]:
    """Deflection at C in multiple precision, piece by piece of the polynomials."""
    import mpmath as mp

    with mp.workdps(REFERENCE_DIGITS):
        a = mp.mpf(bearing_distance)
        # B_x = -M_Cy/a, B_y = M_Cx/a, C = -F - B; the forces on the shaft are opposite.
        at_b = [mp.mpf(moment[1]) / a, -mp.mpf(moment[0]) / a]
        at_c = [mp.mpf(force[i]) - at_b[i] for i in (0, 1)]
        deflection, start = [mp.mpf(0), mp.mpf(0)], mp.mpf(0)
        for section in sections:
            stop = start + mp.mpf(section.length)
            rigidity = mp.mpf(youngs_modulus) * mp.pi * mp.mpf(section.diameter) ** 4 / 64
            low = min(max(start, a), stop)
            behind = (stop**3 - low**3) / 3 - a * (stop**2 - low**2) / 2
            for i in (0, 1):
                moved = at_c[i] * (stop**3 - start**3) / 3 + at_b[i] * behind
                deflection[i] += moved / rigidity
            start = stop
        return deflection
