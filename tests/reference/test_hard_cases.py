"""Oracle tests: the stiff and extreme cases of the stability report, each right or refused."""

import pytest

from tests.inputs.hard_cases import Case, cases, run


@pytest.mark.parametrize("case", list(cases()), ids=lambda case: f"{case.calculation}, {case.name}")
def test_hard_case_is_right_to_its_stated_error_or_refused(case: Case) -> None:
    row = run(case)
    assert row.good, row
