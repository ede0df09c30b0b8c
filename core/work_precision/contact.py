"""Largest pressure of pin in hole: Hertz, identical materials, terms of the integral equation."""

import math
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.conformal import conformal_contact, integral_equation
from core.errors import InvalidInput
from core.hertz import HertzContact
from core.numerics.inverse import edge
from core.work_precision.study import (
    DEFAULT,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)

_TERMS = (2, 4, 8, 16, 32, 64)
_FINEST = 128
_DIGITS = 11


def contact_pressure_study(*, contact: HertzContact) -> WorkPrecision:
    """Error against run time of the largest pressure, over that of Hertz, of a pin in its hole.

    Parameters
    ----------
    contact : HertzContact
        The contact, under a load; wide or narrow.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there is no load, or the contact would wrap around more than half of the pin.
    """
    if not (contact.conformity > 0 and contact.governing > 0):
        raise InvalidInput("force", contact.conformity, "no_conformal_pressure")
    load_parameter, (alpha, beta) = 1 / float(contact.conformity), contact.mismatch
    hertz = math.sqrt(load_parameter / math.pi)

    def by_terms(terms: int) -> Outcome:
        return float(_pressure(load_parameter, alpha, beta, terms)) / hertz, terms

    def by_contact(alpha: float, beta: float) -> Outcome:
        found = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
        return found.pressure / hertz, found.evaluations

    fine, coarse = (
        _pressure(load_parameter, alpha, beta, terms) for terms in (2 * _FINEST, _FINEST)
    )
    exact = fine + (fine - coarse) / 15 if beta else fine
    import mpmath

    return work_precision(
        reference=Reference("integral_equation_finest", _DIGITS),
        exact=[mpmath.mpf(float(exact)) / mpmath.mpf(hertz)],
        methods=[
            Method("hertz", DEFAULT, lambda _: (1.0, 1)),
            Method("identical_materials", DEFAULT, lambda _: by_contact(0.0, 0.0)),
            Method("integral_equation_terms", [("points", n) for n in _TERMS], by_terms),
            Method("integral_equation", DEFAULT, lambda _: by_contact(alpha, beta), chosen=True),
        ],
    )


def _pressure(load_parameter: float, alpha: float, beta: float, terms: int) -> Any:
    """``p_max*R_m/Q`` of the equation with so many terms, where it carries the load."""

    def at(s: float) -> tuple[FloatArray, ...]:
        return integral_equation(s=np.array([s]), beta=np.array([beta]), terms=terms)

    def over(s: float) -> float:
        stiffness, mean, *_ = at(s)
        return float(2 * stiffness[0, 0] - (1 + alpha) * mean[0, 0]) - load_parameter

    narrow = 1 / math.sqrt(math.pi * load_parameter + 2.2)  # sin(eps/2), nearly
    met, _ = edge(inside=0.5 * narrow, outside=min(1.5 * narrow, 0.75), excess=over)
    return at(met)[2][0, 0]
