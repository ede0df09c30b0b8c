"""How a value is judged against its limit, and the order of checks, by hand."""

import math
import pickle
from typing import Any

import pytest

from core.checks.check import Check, verdict
from core.checks.records import CHECKS
from core.errors import NotKnown
from core.precision import CONVERGED


@pytest.mark.parametrize(
    ("changes", "status", "reason"),
    [
        # value 1: limit, sense, reserve, error, warning
        ({"limit": 1.0}, "pass", ""),  # a size that is asked for is there
        ({"limit": 1.0, "reserve": 1.0}, "marginal", ""),
        ({"limit": 1.0, "reserve": 1.0, "error": 2e-9}, "marginal", "pressure_error"),
        ({"limit": 1.0, "reserve": 1.0, "error": 1e-10}, "marginal", ""),
        ({"limit": 0.99, "reserve": 0.98}, "fail", ""),
        ({"limit": 0.99}, "fail", ""),
        ({"limit": 0.99, "warning": "uneven"}, "marginal", "uneven"),
        ({"limit": 1.01, "warning": "uneven", "reserve": 1.01}, "pass", ""),
        ({"limit": 1.01, "reserve": 1.0201}, "marginal", ""),
        ({"limit": 1.01}, "pass", ""),
        ({"limit": 1.01, "code": "wall_holes"}, "fail", ""),
        ({"limit": 0.99, "code": "wall_holes"}, "pass", ""),
        ({"limit": 0.95, "reserve": 0.9, "error": 0.06}, "marginal", "pressure_error"),
        ({"limit": 0.95, "reserve": 0.9, "error": 0.04}, "fail", ""),
        ({"limit": 1.2, "reserve": 1.1}, "pass", ""),
        ({"limit": 1.2, "reserve": 1.0999}, "marginal", ""),
    ],
)
def test_judging(changes: dict[str, Any], status: str, reason: str) -> None:
    limit, code = changes["limit"], changes.get("code", "contact_pressure_pin")
    more = {name: each for name, each in changes.items() if name not in ("limit", "code")}
    found = CHECKS[code].judged(1.0, limit, **more)
    assert (found.status, found.reason) == (status, reason)
    assert found.utilisation == pytest.approx(
        limit if "code" in changes else 1 / limit, rel=CONVERGED
    )
    assert found.torque_reserve == changes.get("reserve")
    assert found.warning == ("warning" in changes)


@pytest.mark.parametrize("code", ["bearing_life", "contact_pressure_pin"])
@pytest.mark.parametrize("reserve", [None, 0.9, 1.05, 4.0])
def test_of_what_nothing_is_known_nothing_is_said(code: str, reserve: float | None) -> None:
    """Not `marginal` either: 268,669 h are not within the error of 3140 h."""
    for value, error in (
        (3140.0, math.inf),
        (268_669.0, math.inf),
        (2693.0, math.inf),
        (0.0, math.inf),
        (2693.0, math.nan),
        (268_669.0, 1.0),
        (268_669.0, 85.0),
    ):
        found = CHECKS[code].judged(value, 3140.0, reserve=reserve, error=error, warning="uneven")
        assert (found.status, found.reason) == ("not_checked", "value_unknown")
        assert (found.value, found.limit, found.torque_reserve) == (value, 3140.0, None)
    # upwards a finite error ends somewhere
    kind = CHECKS[code]
    assert kind.judged(10.0, 1000.0, error=4.0).status == kind.judged(10.0, 1000.0).status
    assert kind.judged(10.0, 49.0, reserve=0.2, error=4.0).status == "marginal"


def test_utilisation_needs_something_to_use() -> None:
    for value, limit, code, used in (
        (1.0, 0.0, "wear", None),
        (0.0, 1.0, "wear", 0.0),
        (-1.0, 1.0, "wear", None),
        (0.0, 1.0, "wall_holes", None),
        (-1.0, 1.0, "wall_holes", None),
        (1.0, 0.0, "wall_holes", None),
    ):
        found = CHECKS[code].judged(value, limit)
        assert found.utilisation == used
        assert found.margin == (limit - value if code == "wear" else value - limit)
    for own in ({"value": 1.0}, {"limit": 1.0}):
        with pytest.raises(NotKnown):
            _ = Check(CHECKS["wall_holes"], "not_checked", **own).margin


def test_the_order_of_what_is_not_judged_and_of_equals() -> None:
    unknown = [
        Check(CHECKS["wall_rim"], "not_applicable"),
        Check(CHECKS["assembly"], "not_asked"),
        Check(CHECKS["clearance"], "not_checked"),
    ]
    half, most = (CHECKS["wall_holes"].judged(1.0, part) for part in (0.5, 0.9))
    found = verdict([*unknown, half, most])
    assert [each.utilisation for each in found.checks[1:3]] == [0.9, 0.5]
    assert [found.checks[index].status for index in (0, 3, 4)] == [
        "not_checked",
        "not_asked",
        "not_applicable",
    ]
    assert found["assembly"].status == "not_asked"
    # what is not known before what warns, and that before what passes, whatever their reserves
    warned = CHECKS["unbalance_force"].judged(1.0, 0.0, warning="unbalanced")
    room = CHECKS["line_spacing"].judged(1.0, 0.0)
    stressed = CHECKS["roller_stress"].judged(1.0, 2.0, reserve=1.5)
    order = [unknown[2], warned, stressed, room, unknown[1], unknown[0]]
    assert verdict(reversed(order)).checks == tuple(order)
    # an impossible part that is not there is none
    passing = half._replace(impossible=True)
    stress = CHECKS["roller_stress"].judged(1.0, 2.0, reserve=2.0)
    assert [each.code for each in verdict([passing, stress]).checks] == [stress.code, "wall_holes"]
    assert verdict([stress]).largest_torque_known
    assert not verdict([stress, half._replace(status="fail")]).largest_torque_known
    # the worst of those that no torque cures: more of the limit used
    two = [each._replace(status="fail") for each in (half, most)]
    assert verdict(two).checks[0].utilisation == 0.9


def test_checks_and_their_verdict_go_to_other_processes() -> None:
    somewhere = Check(CHECKS["wall_rim"], "pass", at={"satellite": 2})
    for each in (Check(CHECKS["assembly"], "not_asked"), somewhere, verdict([somewhere])):
        assert pickle.loads(pickle.dumps(each)) == each


def test_what_has_to_stay_above_its_limit_says_so() -> None:
    for code, kind in CHECKS.items():
        above = "≥" in kind.formula or "> 0" in kind.formula
        room = code in ("roller_sharing", "pin_roller_fits")  # written the other way round
        assert kind.keep == ("above" if above or room else "below"), code


def test_what_is_no_number_passes_nothing() -> None:
    for code in ("contact_pressure_pin", "bearing_life"):
        assert CHECKS[code].judged(math.nan, 1.0).status == "fail"
        assert CHECKS[code].judged(math.nan, 1.0, reserve=math.nan).status == "fail"
