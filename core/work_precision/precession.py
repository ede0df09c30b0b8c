"""Precessional gear: contact-line length by quadrature, in phi as printed and in z without poles;
deflection of the shaft by Mohr's integral, in closed form and by quadrature.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.precession.contact_curve import ContactCurve
from core.precession.contact_line import contact_lines
from core.precession.rollers import Roller, RollerByLength
from core.precession.shaft import bearing_reactions
from core.precession.shaft_deflection import shaft_deflection
from core.work_precision.study import (
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)

Given = dict[str, Any]

Integral = tuple[Callable[[FloatArray], FloatArray | ComplexArray], float, float]
"""Integrand and its limits, in either order."""

POINTS = {"simpson": (9, 33, 129, 513, 2049), "gauss_legendre": (2, 4, 8, 16, 32, 64, 128)}
"""Rules of quadrature, and the numbers of points that each is tried at."""


def rule(*, code: str, count: int) -> tuple[FloatArray, FloatArray]:
    """Nodes and weights of a rule of `POINTS` on [-1, 1], each of shape (count,)."""
    if code == "gauss_legendre":
        return np.polynomial.legendre.leggauss(count)
    weights = np.tile([2.0, 4.0], count // 2 + 1)[:count]
    weights[[0, -1]] = 1.0
    return np.linspace(-1.0, 1.0, count), weights * 2 / (3 * (count - 1))


def _by_rule(code: str, along: str, integrals: Sequence[Integral]) -> Method:
    """Sum of integrals by a rule of quadrature, which is made before anything is timed."""
    rules = {count: rule(code=code, count=count) for count in POINTS[code]}

    def by(count: int) -> Outcome:
        nodes, weights = rules[count]
        total: complex = 0.0
        for integrand, start, end in integrals:
            half = abs(end - start) / 2
            total += half * complex(integrand((start + end) / 2 + half * nodes) @ weights)
        return total, count * len(integrals)

    return Method(f"{code}_{along}", by, "points", POINTS[code])


def contact_line_study(*, gear: Given, rollers: Sequence[Roller]) -> WorkPrecision:
    """Error against run time of the total length of the contact lines. `gear` has the sizes and the
    ratio that `contact_lines` takes.
    """
    import mpmath

    found = contact_lines(**gear, rollers=rollers)
    in_phi = [(partial(_in_phi, each.curve), each.phi_min, each.phi_max) for each in found.lines]
    in_z = [(partial(_in_z, each.curve), each.z_min, each.z_max) for each in found.lines]

    def graded(_: float) -> Outcome:
        result = contact_lines(**gear, rollers=rollers)
        return result.total_length, result.accuracy.evaluations

    with mpmath.workdps(REFERENCE_DIGITS):
        exact = mpmath.fsum(_exact_lengths(gear, rollers))
    return work_precision(
        reference=Reference("multiple_tanh_sinh"),
        exact=exact,
        methods=[
            _by_rule("simpson", "phi", in_phi),
            _by_rule("gauss_legendre", "z", in_z),
            Method(found.accuracy.method, graded),
        ],
    )


def _in_phi(curve: ContactCurve, phi: FloatArray) -> FloatArray:
    """Length of a line over phi, eq. (4) of the paper."""
    steep = curve.width / np.sin(phi + curve.position_angle) ** 2
    return np.asarray(np.hypot(curve.roller_radius, steep))


def _in_z(curve: ContactCurve, z: FloatArray) -> FloatArray:
    """Length of a line over z, where it has no pole."""
    return np.asarray(np.hypot(1.0, curve.slope(z + curve.offset)))


def _exact_lengths(gear: Given, rollers: Sequence[Roller]) -> Iterator[Any]:
    """Length of each line in multiple precision, from the input as given."""
    import mpmath as mp

    radius, rho = mp.mpf(gear["roller_circle_radius"]), mp.mpf(gear["roller_radius"])
    theta, ratio = mp.mpf(gear["nutation_angle"]), mp.mpf(gear["ratio_u12"])
    scale = radius * (mp.cos(theta) - ratio) / mp.sin(theta)
    for roller in rollers:
        phi1 = mp.mpf(roller.position_angle)
        width, offset = scale * mp.sin(phi1), scale * mp.cos(phi1)
        if isinstance(roller, RollerByLength):
            ends = [mp.mpf(roller.z_min), mp.mpf(roller.z_max)]
        else:
            limits = mp.mpf(roller.phi_min), mp.mpf(roller.phi_max)
            ends = [-scale * mp.sin(phi) / mp.sin(phi + phi1) for phi in limits]
        low, high = sorted(offset + end for end in ends)
        steep = sorted(factor * width for factor in (-100, -10, -1, 0, 1, 10, 100))

        def length(y: Any, width: Any = width) -> Any:
            return mp.sqrt(1 + (rho * width / (y**2 + width**2)) ** 2)

        yield mp.quad(length, [low, *(place for place in steep if low < place < high), high])


def shaft_deflection_study(*, shaft: Given) -> WorkPrecision:
    """Error against run time of the deflection at C, x + i*y. `shaft` has the arguments of
    `shaft_deflection`.
    """
    distance, sections = shaft["bearing_distance"], shaft["shaft_sections"]
    ends = np.cumsum([each.length for each in sections])
    inertias = np.array([math.pi / 64 * each.diameter**4 for each in sections])
    loads = {"force": shaft["force"], "moment": shaft["moment"], "bearing_distance": distance}
    at_b, at_c = (complex(*each) for each in bearing_reactions(**loads))

    def bent(s: FloatArray) -> ComplexArray:
        """Moment in both planes times that of a unit force at C, over E*I, from C at s = 0."""
        inertia = inertias[np.minimum(np.searchsorted(ends, s), len(ends) - 1)]
        moment = -at_c * s - at_b * np.maximum(0.0, s - distance)
        return np.asarray(moment * s / (shaft["youngs_modulus"] * inertia))

    def closed_form(_: float) -> Outcome:
        found = shaft_deflection(**shaft).deflection_C
        return complex(found.x, found.y), 1

    whole = [(bent, 0.0, distance + shaft["overhang"])]
    return work_precision(
        reference=Reference("multiple_closed_form"),
        exact=_exact_deflection(shaft),
        methods=[
            _by_rule("simpson", "shaft", whole),
            _by_rule("gauss_legendre", "shaft", whole),
            Method("mohr", closed_form),
        ],
    )


def _exact_deflection(shaft: Given) -> Any:
    """Deflection at C in multiple precision, piece by piece of the polynomials."""
    import mpmath as mp

    with mp.workdps(REFERENCE_DIGITS):
        (f_x, f_y, _), (m_x, m_y, _), a = shaft["force"], shaft["moment"], shaft["bearing_distance"]
        # B_x = -M_Cy/a, B_y = M_Cx/a, C = -F - B; the forces on the shaft are opposite.
        at_b = mp.mpc(m_y, -m_x) / a
        at_c = mp.mpc(f_x, f_y) - at_b
        deflection = start = mp.mpf(0)
        for section in shaft["shaft_sections"]:
            stop = start + section.length
            low = min(max(start, a), stop)
            behind = (stop**3 - low**3) / 3 - a * (stop**2 - low**2) / 2
            inertia = mp.pi * mp.mpf(section.diameter) ** 4 / 64
            moved = at_c * (stop**3 - start**3) / 3 + at_b * behind
            deflection += moved / (shaft["youngs_modulus"] * inertia)
            start = stop
        return deflection
