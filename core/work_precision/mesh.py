"""Contact-line length and meshing load by quadrature, in phi as printed and in z without poles."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.precession.contact_line import ContactLine, contact_lines
from core.precession.meshing_load import meshing_load
from core.precession.rollers import Roller, RollerByLength
from core.work_precision.rules import Integrand, finite_sum, fixed_rules, integrate
from core.work_precision.study import (
    REFERENCE_DIGITS,
    WorkPoint,
    WorkPrecision,
    measured,
)

Gear = dict[str, Any]
_Components = Callable[[list[float]], float | list[float]]
_Pieces = list[tuple[Integrand, tuple[float, float]]]


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
    lines = contact_lines(**gear, rollers=rollers)
    exact = [_exact_integrals(gear, rollers, load=False)[0]]
    return _study(
        lines.lines,
        exact,
        lambda sums: sums[0],
        lambda: contact_lines(**gear, rollers=rollers).total_length,
        lines.accuracy.evaluations,
        load=False,
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
    load = meshing_load(**gear, rollers=rollers, torque=torque, reference_z=reference_z)
    total, x, y = _exact_integrals(gear, rollers, load=True)
    return _study(
        load.lines,
        [torque * x / total, torque * y / total],
        lambda sums: [torque * sums[1] / sums[0], torque * sums[2] / sums[0]],
        lambda: list(
            meshing_load(**gear, rollers=rollers, torque=torque, reference_z=reference_z).force[:2]
        ),
        load.accuracy.evaluations,
        load=True,
    )


def _study(
    lines: Sequence[ContactLine],
    exact: list[Any],
    wanted: _Components,
    default: Callable[[], float | list[float]],
    evaluations: int,
    *,
    load: bool,
) -> WorkPrecision:
    points: list[WorkPoint | None] = []
    for variable, integrand_of, limits in (
        ("phi", _in_phi, [(line.phi_min, line.phi_max) for line in lines]),
        ("z", _in_z, [(line.z_min, line.z_max) for line in lines]),
    ):
        pieces = [
            (integrand_of(line, load), ends) for line, ends in zip(lines, limits, strict=True)
        ]
        for name, setting, nodes, weights in fixed_rules():
            points.append(
                measured(
                    method=f"{name}_{variable}",
                    setting=setting,
                    calculate=partial(_by_rule, wanted, pieces, nodes, weights),
                    exact=exact,
                    evaluations=len(nodes) * len(lines),
                )
            )
    chosen = measured(
        method="graded_z",
        calculate=default,
        exact=exact,
        evaluations=evaluations,
    )
    return WorkPrecision.against("multiple_tanh_sinh", points=[*points, chosen], chosen=chosen)


def _by_rule(
    wanted: _Components, pieces: _Pieces, nodes: FloatArray, weights: FloatArray
) -> float | list[float]:
    parts = [
        _length_positive(integrate(integrand=f, start=a, end=b, nodes=nodes, weights=weights))
        for f, (a, b) in pieces
    ]
    return wanted(finite_sum(parts))


def _length_positive(values: FloatArray) -> FloatArray:
    """Integrals with the length counted positive, whichever way the limits run."""
    return values if values[0] >= 0 else -values


def _in_phi(line: ContactLine, load: bool) -> Integrand:
    """Integrands over phi, as eqs (4), (12), (13) of the paper have them."""
    curve = line.curve
    rho, phi1 = curve.roller_radius, curve.position_angle

    def integrand(phi: FloatArray) -> FloatArray:
        slope = -curve.width / (rho * np.sin(phi + phi1) ** 2)
        length = rho * np.sqrt(1 + slope**2)
        if not load:
            return length[None, :]
        arm = -curve.roller_circle_radius * np.sin(phi)
        return np.stack(
            (length, length * np.sin(phi + phi1) / arm, -length * np.cos(phi + phi1) / arm)
        )

    return integrand


def _in_z(line: ContactLine, load: bool) -> Integrand:
    """The same integrands over z, where they have no pole."""
    curve = line.curve
    rho, phi1 = curve.roller_radius, curve.position_angle

    def integrand(z: FloatArray) -> FloatArray:
        square = (z + curve.offset) ** 2 + curve.width**2
        length = np.sqrt(1 + (rho * curve.width / square) ** 2)
        if not load:
            return length[None, :]
        phi = np.arctan2(-z * curve.sine, curve.scale + z * np.cos(phi1))
        arm = -curve.roller_circle_radius * np.sin(phi)
        return np.stack(
            (length, length * np.sin(phi + phi1) / arm, -length * np.cos(phi + phi1) / arm)
        )

    return integrand


def _exact_integrals(gear: Gear, rollers: Sequence[Roller], *, load: bool) -> list[Any]:
    """Sums of length and load integrals in multiple precision, from the input as given."""
    import mpmath as mp

    with mp.workdps(REFERENCE_DIGITS):
        radius, rho = mp.mpf(gear["roller_circle_radius"]), mp.mpf(gear["roller_radius"])
        theta = mp.mpf(gear["nutation_angle"])
        scale = radius * (mp.cos(theta) - mp.mpf(gear["ratio_u12"])) / mp.sin(theta)
        sums = [mp.mpf(0)] * (3 if load else 1)
        for roller in rollers:
            phi1 = mp.mpf(roller.position_angle)
            width, offset = scale * mp.sin(phi1), scale * mp.cos(phi1)
            if isinstance(roller, RollerByLength):
                low, high = mp.mpf(roller.z_min), mp.mpf(roller.z_max)
            else:
                ends = [
                    -scale * mp.sin(phi) / mp.sin(phi + phi1)
                    for phi in (mp.mpf(roller.phi_min), mp.mpf(roller.phi_max))
                ]
                low, high = min(ends), max(ends)
            breaks = [low, high] + [
                place
                for factor in (-100, -10, -1, 0, 1, 10, 100)
                for place in (-offset + factor * width,)
                if low < place < high
            ]

            def stretch(z: Any, width: Any = width, offset: Any = offset) -> Any:
                return mp.sqrt(1 + (rho * width / ((z + offset) ** 2 + width**2)) ** 2)

            def angle(z: Any, phi1: Any = phi1) -> Any:
                return mp.atan2(-z * mp.sin(phi1), scale + z * mp.cos(phi1))

            def across(z: Any, stretch: Any = stretch, angle: Any = angle, phi1: Any = phi1) -> Any:
                return stretch(z) * mp.sin(angle(z) + phi1) / (-radius * mp.sin(angle(z)))

            def upward(z: Any, stretch: Any = stretch, angle: Any = angle, phi1: Any = phi1) -> Any:
                return -stretch(z) * mp.cos(angle(z) + phi1) / (-radius * mp.sin(angle(z)))

            for i, part in enumerate((stretch, across, upward)[: len(sums)]):
                sums[i] += mp.quad(part, sorted(set(breaks)))
        return sums
