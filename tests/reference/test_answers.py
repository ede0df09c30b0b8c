"""Oracle tests: every number of every answer is as good as the answer says.

A part of what `make accuracy` asks ten thousand times: requests as people type them, through the
service, against the exact values of their decimals; practical ones (even seeds) and extreme ones.
"""

import pytest

from tests.inputs.outcome import outcome
from tests.oracles.answers import CALCULATIONS
from tests.oracles.answers.calculation import Calculation, Number, pattern, typed
from tests.oracles.seeds import TIMES, seeds

RIDGES = (1480, 7760)
"""Pins whose worst cycle has a least stress that is next to nothing, and moves with the direction;
forces of exponent 0.5, whose stated error was too small.
"""

ENDING = (44, 54)
"""Pins whose life ends before a million loads: the required one, and one of their own."""

OFTEN = (
    "cyclogram",
    "hertz",
    "precession/contact-line",
    "precession/meshing-load",
    "roller-strength",
)
"""Closed calculations, whose oracles are quick."""

ONE_OR_ALL = slice(None) if TIMES > 1 else slice(1)
TRIED = {  # whose oracle takes seconds
    "pin-strength": (*RIDGES[ONE_OR_ALL], *ENDING[ONE_OR_ALL], *seeds(2, 3)[1:])
}
TRIED |= dict.fromkeys(OFTEN, seeds(24))
CASES = [(each, seed) for each in CALCULATIONS for seed in TRIED.get(each.path, seeds(4, 8))]


@pytest.mark.parametrize(
    ("calculation", "seed"), CASES, ids=lambda each: getattr(each, "path", each)
)
def test_every_number_is_as_good_as_is_stated(calculation: Calculation, seed: int) -> None:
    case = outcome(calculation, seed)
    assert case.false == {}, case.body
    assert case.unknown == set(), "numbers that nothing is held against"
    assert case.extreme or not (case.refused or case.beyond), case.body


def test_the_error_is_that_against_the_decimal() -> None:
    assert typed(0.1) * 10 == 1
    assert Number(0.1, typed(0.1)).error == pytest.approx(5.6e-17, rel=0.02)
    assert Number(1.5, typed(1.0), typed(2.0)).error == 0.25
    assert pattern("/pairs/12/driving_deg/0/1") == "/pairs/*/driving_deg/*/*"


def test_a_number_that_nothing_is_held_against_is_seen() -> None:
    (hertz,) = (each for each in CALCULATIONS if each.path == "hertz")
    answer = {"max_pressure_MPa": 1.0, "new": [{"torque_Nm": 2}], "accuracy": {"evaluations": 1}}
    known = {"/max_pressure_MPa": Number(1.0, typed(1.0))}
    assert hertz.not_checked(answer, known) == {"/new/*/torque_Nm"}
