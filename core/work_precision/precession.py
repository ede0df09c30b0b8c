"""Precessional gear: contact-line length and meshing load by quadrature, in phi as printed and in z
without poles; deflection of the shaft by Mohr's integral, in closed form and by quadrature.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Literal

import numpy as np

from core.arrays import FloatArray, Vector
from core.precession.contact_line import ContactLine, contact_lines
from core.precession.meshing_load import meshing_load
from core.precession.rollers import Roller, RollerByLength
from core.precession.shaft import ShaftSection, bearing_reactions
from core.precession.shaft_deflection import shaft_deflection
from core.work_precision.rules import Integrand, Rule, by_rule, rules
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

Variable = Literal["phi", "z"]
VARIABLES: tuple[Variable, ...] = ("phi", "z")
"""Along a contact line: the angle as printed, and the place."""

_Piece = tuple[Integrand, float, float]


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
    lines = contact_lines(**gear, rollers=rollers).lines

    def calculate(_: float) -> Outcome:
        result = contact_lines(**gear, rollers=rollers)
        return result.total_length, result.accuracy.evaluations

    return work_precision(
        reference=Reference("multiple_tanh_sinh"),
        exact=_exact_integrals(gear, rollers, load=False),
        methods=[
            *_by_rules(lines, lambda sums: sums[0], load=False),
            Method("graded_z", DEFAULT, calculate, chosen=True),
        ],
    )


def meshing_load_study(
    *, gear: Gear, rollers: Sequence[Roller], torque: float, reference_z: float
) -> WorkPrecision:
    """Error against run time of the force of the mesh.

    Parameters
    ----------
    gear : dict
        roller_circle_radius, roller_radius, nutation_angle, ratio_u12, as `meshing_load` takes.
    rollers : sequence of Roller
        The rollers.
    torque : float
        Torque M1, N*m.
    reference_z : float
        Place l of C, m.

    Returns
    -------
    WorkPrecision
    """
    import mpmath

    loaded: dict[str, Any] = {"rollers": rollers, "torque": torque, "reference_z": reference_z}
    lines = meshing_load(**gear, **loaded).lines

    def force(sums: list[Any]) -> list[Any]:
        return [torque * sums[1] / sums[0], torque * sums[2] / sums[0]]

    def calculate(_: float) -> Outcome:
        result = meshing_load(**gear, **loaded)
        return result.force[:2], result.accuracy.evaluations

    with mpmath.workdps(REFERENCE_DIGITS):
        exact = force(_exact_integrals(gear, rollers, load=True))
    return work_precision(
        reference=Reference("multiple_tanh_sinh"),
        exact=exact,
        methods=[
            *_by_rules(lines, force, load=True),
            Method("graded_z", DEFAULT, calculate, chosen=True),
        ],
    )


def _by_rules(
    lines: Sequence[ContactLine],
    value: Callable[[list[float]], float | list[float]],
    *,
    load: bool,
) -> Iterator[Method]:
    """All rules over phi, then over z, of a value of the lines' integrals, summed."""
    for variable in VARIABLES:
        pieces = [_piece(line, variable, load) for line in lines]

        def by(rule: Rule, pieces: list[_Piece] = pieces) -> float | list[float]:
            parts = [rule.integral(*piece) for piece in pieces]
            # The length counts as positive, whichever way the limits run.
            parts = [part if part[0] >= 0 else -part for part in parts]
            return value([math.fsum(column) for column in zip(*parts, strict=True)])

        for rule in rules():
            code = f"{rule.code}_{variable}"
            yield by_rule(rule=rule, code=code, value=by, intervals=len(lines))


def _piece(line: ContactLine, variable: Variable, load: bool) -> _Piece:
    """Integrands of the length, and of the load across and upward as eqs (4), (12), (13) of the
    paper have them over phi, or the same over z, where they have no pole; with their limits.
    """
    curve = line.curve
    rho, phi1, width = curve.roller_radius, curve.position_angle, curve.width

    def loads(length: FloatArray, phi: FloatArray) -> FloatArray:
        arm = -curve.roller_circle_radius * np.sin(phi)
        return np.stack(
            (length, length * np.sin(phi + phi1) / arm, -length * np.cos(phi + phi1) / arm)
        )

    def over_phi(phi: FloatArray) -> FloatArray:
        length = rho * np.sqrt(1 + (width / (rho * np.sin(phi + phi1) ** 2)) ** 2)
        return loads(length, phi) if load else length[None, :]

    def over_z(z: FloatArray) -> FloatArray:
        length = np.sqrt(1 + (rho * width / ((z + curve.offset) ** 2 + width**2)) ** 2)
        if not load:
            return length[None, :]
        return loads(length, np.arctan2(-z * curve.sine, curve.scale + z * np.cos(phi1)))

    if variable == "phi":
        return over_phi, line.phi_min, line.phi_max
    return over_z, line.z_min, line.z_max


def _exact_integrals(gear: Gear, rollers: Sequence[Roller], *, load: bool) -> list[Any]:
    """Sums of length and load integrals in multiple precision, from the input as given."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        lines = [_exact_line(gear, roller, load) for roller in rollers]
        return [mpmath.fsum(column) for column in zip(*lines, strict=True)]


def _exact_line(gear: Gear, roller: Roller, load: bool) -> list[Any]:
    import mpmath as mp

    radius, rho = mp.mpf(gear["roller_circle_radius"]), mp.mpf(gear["roller_radius"])
    theta, phi1 = mp.mpf(gear["nutation_angle"]), mp.mpf(roller.position_angle)
    scale = radius * (mp.cos(theta) - mp.mpf(gear["ratio_u12"])) / mp.sin(theta)
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

    def length(z: Any) -> Any:
        return mp.sqrt(1 + (rho * width / ((z + offset) ** 2 + width**2)) ** 2)

    def angle(z: Any) -> Any:
        return mp.atan2(-z * mp.sin(phi1), scale + z * mp.cos(phi1))

    def across(z: Any) -> Any:
        return length(z) * mp.sin(angle(z) + phi1) / (-radius * mp.sin(angle(z)))

    def upward(z: Any) -> Any:
        return -length(z) * mp.cos(angle(z) + phi1) / (-radius * mp.sin(angle(z)))

    return [mp.quad(each, breaks) for each in ((length, across, upward) if load else (length,))]


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
        deflections: list[float] = rule.integral(integrand, 0.0, end).tolist()
        return deflections

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
            *(by_rule(rule=rule, code=f"{rule.code}_shaft", value=by) for rule in rules()),
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
