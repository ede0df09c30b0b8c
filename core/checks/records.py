"""All checks, by code."""

from core.checks.crank_planetary import CRANK_CHECKS
from core.checks.rollers import ROLLERS
from core.checks.shaft import SHAFT

CHECKS = CRANK_CHECKS | {kind.code: kind for kind in (*ROLLERS, *SHAFT)}
