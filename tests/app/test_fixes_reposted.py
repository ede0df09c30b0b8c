"""Fixes of designs that fail, of sizes that people build: each is what a repost says it is."""

from copy import deepcopy
from typing import Any

import pytest

from tests.inputs.failing import failing
from tests.oracles.seeds import TIMES

pytestmark = [pytest.mark.anyio, pytest.mark.slow]

DESIGNS = failing(5 * TIMES)


async def answered(api: Any, body: dict[str, Any]) -> dict[str, Any]:
    answer = await api.post("crank-planetary", json=body)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def applied(body: dict[str, Any], values: dict[str, Any]) -> dict[str, Any]:
    """A body with other values, by their pointers."""
    found = deepcopy(body)
    for pointer, value in values.items():
        *sections, last = pointer.split("/")[1:]
        inner = found
        for section in sections:
            inner = inner[section]
        inner[last] = value
    return found


@pytest.mark.parametrize("index", range(len(DESIGNS)))
async def test_a_fix_says_the_verdict_that_a_repost_gives(api: Any, index: int) -> None:
    body = DESIGNS[index]
    asked = {"include": ["checks", "fixes"], "fixes_for": "failed"}
    answer = await answered(api, body | asked)
    assert answer["verdict"] == "fail" and answer["fixes"]
    for fix in answer["fixes"]:
        after = await answered(api, applied(body, fix["sets"]) | {"include": ["checks"]})
        check = next(each for each in after["checks"] if each["code"] == fix["code"])
        assert after["verdict"] == fix["verdict"], fix
        if fix["status"] == "solved":
            assert check["status"] == "pass", fix


async def test_the_largest_torque_is_that_of_which_a_repost_is_at_its_limit(api: Any) -> None:
    known = 0
    for body in DESIGNS:
        answer = await answered(api, body | {"include": ["checks"]})
        if "largest_torque_Nm" not in answer:
            continue
        known += 1
        found = answer["largest_torque_Nm"]
        for part, fails in ((1 - 2e-5, False), (1 + 1e-3, True)):  # a stress is known to 1e-5
            there = applied(body, {"/load/output_torque_Nm": found * part})
            after = await answered(api, there | {"include": ["checks"]})
            assert (after["counts"]["fail"] > 0) == fails
    assert known >= len(DESIGNS) // 2
