"""A check of a crank-planetary reducer: a small function of its design and results."""

from collections.abc import Callable

from core.checks.check import Check
from core.design.document import Design
from core.design.results import Results

Judge = Callable[[Design, Results], Check]
