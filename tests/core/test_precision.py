"""Classes of precision: what loops that are compiled by themselves repeat of them, and methods."""

from core import precision
from core.errors import METHODS
from core.output import loop_rows


def test_the_compiled_loops_have_the_same_constants() -> None:
    assert loop_rows.EPS == precision.ROUNDING
    assert loop_rows.JUST == precision.AS_TYPED


def test_each_class_is_of_a_method_and_finer_than_the_next() -> None:
    classes = (precision.EXACT, precision.SEARCHED, precision.JUDGED, precision.HARDLY_KNOWN)
    assert classes == tuple(sorted(classes)) and precision.CONVERGED < precision.EXACT
    assert {*precision.CLASSES} <= {*METHODS}
    assert {*precision.CLASSES.values()} <= {*classes, 10 * precision.JUDGED}
