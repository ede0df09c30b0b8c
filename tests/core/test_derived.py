"""Derived values of a design are worked out once, as are the reasons why they are not known."""

from dataclasses import dataclass, field, replace

import pytest

from core.checks.crank_planetary import crank_checks
from core.design.results import Results
from core.errors import ImpossibleMechanism, InvalidInput, NotKnown, derived, if_known
from core.output.turn import Turn
from tests.inputs.checks import REF, having


@dataclass(frozen=True)
class Design:
    why: Exception | None = None
    asked: list[int] = field(default_factory=list)

    @derived
    def result(self) -> int:
        """A result."""
        self.asked.append(1)
        if self.why is not None:
            raise self.why
        return 7


def test_a_value_is_worked_out_once_for_each_design() -> None:
    design = Design()
    assert (design.result, design.result, design.asked) == (7, 7, [1])
    assert replace(design, asked=[]).result == 7
    assert Design.result.__doc__ == "A result."


@pytest.mark.parametrize(
    "why",
    [
        NotKnown("too_many_pairs"),
        ImpossibleMechanism("dead_centre"),
        InvalidInput("r", 0, "not_zero"),
    ],
)
def test_a_refusal_is_kept_as_it_is(why: Exception) -> None:
    design = Design(why)
    for _ in range(3):
        with pytest.raises(type(why)) as caught:
            assert design.result
        assert caught.value is why
    assert design.asked == [1]


def test_a_fault_of_the_program_is_no_result() -> None:
    design = Design(ZeroDivisionError())
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            assert if_known(lambda: design.result)
    assert design.asked == [1, 1]


def test_what_is_not_known_is_none_where_that_is_asked() -> None:
    assert if_known(lambda: Design().result) == 7
    assert if_known(lambda: Design(NotKnown("too_many_pairs")).result) is None
    with pytest.raises(InvalidInput):
        assert if_known(lambda: Design(InvalidInput("r", 0, "not_zero")).result)


def test_a_turn_that_cannot_be_solved_is_not_solved_for_each_check(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    turns = []

    def poses(turn: Turn, _: list[float]) -> None:
        turns.append(turn.torque)
        raise ImpossibleMechanism("not_stable")

    monkeypatch.setattr(Turn, "poses", poses)
    found = crank_checks(Results(having(REF, hole_radius=0.01002)))
    assert turns == [REF.load.output_torque]
    assert sum(check.reason == "not_stable" for check in found.checks) >= 4
