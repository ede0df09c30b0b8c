"""All checks, by code."""

import copyreg

from core.checks.check import Kind
from core.checks.crank_planetary import CRANK_CHECKS
from core.checks.plain import ROLLERS, SHAFT

CHECKS = CRANK_CHECKS | {kind.code: kind for kind in (*ROLLERS, *SHAFT)}


def record(code: str) -> Kind:
    """The record of a check: what a check that goes to another process has instead of it."""
    return CHECKS[code]


copyreg.pickle(Kind, lambda kind: (record, (kind.code,)))
