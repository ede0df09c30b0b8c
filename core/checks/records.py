"""All checks, by code."""

import copyreg

from core.checks.check import Kind
from core.checks.crank_planetary import CRANK_CHECKS
from core.checks.plain import ROLLERS, SHAFT

CHECKS = CRANK_CHECKS | {kind.code: kind for kind in (*ROLLERS, *SHAFT)}


def record(code: str) -> Kind:
    """Record of a check by its code, from which a pickled check is restored."""
    return CHECKS[code]


copyreg.pickle(Kind, lambda kind: (record, (kind.code,)))
