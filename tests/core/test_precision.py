"""Classes of precision: what loops that are compiled by themselves repeat of them, and methods."""

from core import precision
from core.drive import engine
from core.errors import METHODS


def test_the_compiled_loops_have_the_same_constants() -> None:
    assert engine.EPS == precision.ROUNDING
    assert engine.JUST == precision.AS_TYPED


def test_each_class_is_of_a_method_and_finer_than_the_next() -> None:
    classes = (precision.EXACT, precision.SEARCHED, precision.JUDGED, precision.HARDLY_KNOWN)
    assert classes == tuple(sorted(classes)) and precision.CONVERGED < precision.EXACT
    assert {*precision.CLASSES} <= {*METHODS}
    assert {*precision.CLASSES.values()} <= {*classes, 10 * precision.JUDGED}
