"""Checks of designs: invariants that hold for any, by hypothesis, and the reserve of the torque."""

import math

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from core.checks.check import MARGIN, Check, verdict
from core.checks.crank_planetary import crank_checks
from core.checks.plain import RollerDesign, roller_checks
from core.checks.records import CHECKS
from core.design.document import Design
from core.design.results import Results
from core.fixes.changes import vary
from core.fixes.fix import WHOLE as WHOLE_NUMBERS
from core.hertz import SHAKEDOWN
from core.material_table import MATERIALS
from core.precision import CONVERGED, EXACT
from core.rollers.roller_strength import ByPoissonsRatio, PositionTolerance, roller_strength
from tests.inputs.checks import REF as KNOWN
from tests.inputs.checks import check_of, fixes_of, having

STEEL = MATERIALS["steel_bearing"].material
TEMPERED = MATERIALS["steel_through_hardened"].material
REF = having(KNOWN, pin_material=STEEL, hole_material=TEMPERED, satellite_body=None)

designs = st.builds(
    lambda pins, satellites, torque, radius, pin, gap, hole: having(
        REF,
        pins=pins,
        satellites=satellites,
        output_torque=torque,
        pin_circle_radius=radius,
        pin_radius=pin,
        hole_radius=pin * (1 + gap),
        eccentricity=pin * gap,
        hole_material=MATERIALS[hole].material,
    ),
    pins=st.integers(3, 12),
    satellites=st.integers(1, 4),
    torque=st.floats(1.0, 1e5),
    radius=st.floats(0.01, 0.2),
    pin=st.floats(0.002, 0.03),
    gap=st.floats(1e-3, 1.0),
    hole=st.sampled_from(sorted(name for name, each in MATERIALS.items() if not each.missing)),
)


AT_THE_JUMP = having(
    REF,
    pins=3,
    satellites=4,
    output_torque=215.0,
    pin_circle_radius=0.09375,
    pin_radius=0.015625,
    hole_radius=0.01922607421875,
    eccentricity=0.00360107421875,
    hole_material=MATERIALS["bronze_tin_nickel"].material,
)
"""Its limit lies within the jump where the conformal pressure takes over."""

PLASTIC_AT_THE_JUMP = tuple(
    having(
        REF,
        pins=3,
        satellites=1,
        output_torque=1.0,
        pin_circle_radius=radius,
        pin_radius=0.015625,
        hole_radius=0.01953125,
        eccentricity=0.00390625,
        hole_material=MATERIALS["plastic_pom"].material,
    )
    for radius in (0.080078125, 0.125)
)
"""Their limits fall at their reserves, where the softest contact becomes conformal."""


@example(AT_THE_JUMP)
@example(PLASTIC_AT_THE_JUMP[0])
@example(PLASTIC_AT_THE_JUMP[1])
@given(designs)
def test_the_torque_reserve_puts_each_check_at_its_limit(design: Design) -> None:
    for check in crank_checks(Results(design)).checks:
        if check.torque_reserve is None:
            continue
        assert design.load.output_torque is not None
        there = having(design, output_torque=design.load.output_torque * check.torque_reserve)
        found = check_of(check.code, there)
        if found.utilisation is None or found.value is None:
            continue
        # where the conformal contact takes over, pressure and limit jump, and the reserve may end
        # there; around more than half of the pin there is no pressure
        beyond = having(design, output_torque=there.load.output_torque * (1 + 1e-9))  # type: ignore[operator]
        after = check_of(check.code, beyond)
        assert found.utilisation <= 1 + 1e-9
        ended = after.utilisation is None or after.utilisation > 1
        assert found.utilisation == pytest.approx(1, rel=EXACT) or ended


@given(designs)
def test_nothing_passes_by_absence(design: Design) -> None:
    found = crank_checks(Results(design))
    assert {each.code for each in found.checks} <= set(CHECKS)
    assert sum(found.counts.values()) == len(found.checks)
    for check in found.checks:
        if check.status in ("pass", "fail"):
            assert check.value is not None
            assert check.limit is not None
            assert math.isfinite(check.value) and math.isfinite(check.limit)
        if check.status == "not_checked":
            assert check.reason
            assert found.verdict in ("incomplete", "fail")
    if found.verdict == "pass":
        assert all(each.status != "not_checked" for each in found.checks)
        assert found.torque_reserve is None or found.torque_reserve >= MARGIN
    for body in ("pin", "hole"):
        limit, check = (
            getattr(design.contact, f"{body}_material").limit,
            found[f"contact_pressure_{body}"],
        )
        assert check.reason == "cannot_be" or (check.limit is None) == (limit is None)


@given(designs, st.floats(1.01, 10.0))
def test_more_torque_is_never_better(design: Design, times: float) -> None:
    assert design.load.output_torque is not None
    one = crank_checks(Results(design))
    more = crank_checks(Results(having(design, output_torque=design.load.output_torque * times)))
    if one.verdict == "fail":
        assert more.verdict == "fail" or more.counts["not_checked"] > one.counts["not_checked"]
    for check in one.checks:
        other = more[check.code]
        if check.torque_reserve is not None and other.torque_reserve is not None:
            assert other.torque_reserve * times == pytest.approx(check.torque_reserve, rel=EXACT)


@given(
    st.floats(1e-3, 1e3),
    st.floats(1e-3, 1e3),
    st.sampled_from(["contact_pressure_pin", "wall_holes"]),
)
def test_one_sense_of_utilisation(value: float, limit: float, code: str) -> None:
    check = CHECKS[code].judged(value, limit)
    assert check.utilisation is not None
    assert (check.utilisation > 1 + 1e-12) == (check.status == "fail")
    assert (check.margin < 0) == (check.utilisation > 1) or check.utilisation == 1


@pytest.mark.parametrize(
    ("reserve", "warning", "status"),
    [
        (1.0999, "", "marginal"),
        (1.1, "", "pass"),
        (1.01, "plastic_first", "pass"),
        (None, "", "pass"),
    ],
)
def test_the_marginal_band(reserve: float | None, warning: str, status: str) -> None:
    check = CHECKS["contact_pressure_pin"].judged(1.0, 1.2, reserve=reserve, warning=warning)
    assert check.status == status


def test_within_the_error_of_the_model_nothing_is_certain() -> None:
    for value, status in ((0.96, "marginal"), (1.02, "marginal"), (1.06, "fail"), (0.9, "pass")):
        check = CHECKS["contact_pressure_pin"].judged(value, 1.0, reserve=1.5, error=0.05)
        assert check.status == status, value
        assert (check.reason == "pressure_error") == (status == "marginal")


def test_order_and_verdict() -> None:
    one = Check(CHECKS["interference"], "fail", impossible=True)
    two = CHECKS["wall_holes"].judged(1.0, 2.0)
    three = CHECKS["contact_pressure_pin"].judged(2.0, 1.0, reserve=0.25)
    four = CHECKS["contact_pressure_hole"].judged(1.5, 1.0, reserve=0.44)
    five = CHECKS["contact_shakedown_pin"].judged(1.0, 1.04, reserve=1.08)
    six = CHECKS["contact_yield_pin"].judged(2.0, 1.0, reserve=0.2, warning="plastic_first")
    seven = Check(CHECKS["assembly"], "not_asked")
    eight = Check(CHECKS["contact_shakedown_hole"], "not_checked")
    every = [eight, seven, six, five, four, three, two, one]
    assert [each.code for each in verdict(every).checks] == [
        *("interference", "wall_holes", "contact_pressure_pin", "contact_pressure_hole"),
        *("contact_shakedown_hole", "contact_yield_pin", "contact_shakedown_pin", "assembly"),
    ]
    assert verdict(every).verdict == "fail"
    assert verdict(every).impossible and verdict(every).torque_reserve is None
    assert not verdict(every).largest_torque_known
    assert verdict(every[:-1]).torque_reserve is None  # of what no torque cures
    assert verdict([three, four, six, seven]).torque_reserve == 0.25  # not the warning's
    assert verdict([three, four, seven]).largest_torque_known
    unknown = verdict([five, seven, eight])
    assert unknown.verdict == "incomplete"
    assert (unknown.checks[0], unknown.governing) == (eight, five.code)
    assert not verdict([five, eight]).largest_torque_known
    assert verdict([five, eight]).torque_reserve is None
    assert verdict([five, six, seven]).verdict == "marginal"
    assert verdict([seven]).verdict == "incomplete"
    room = CHECKS["line_spacing"].judged(2.0, 0.0)
    warned = CHECKS["contact_yield_pin"].judged(0.1, 0.159, reserve=2.5, warning="plastic_first")
    assert verdict([room]).verdict == "incomplete"  # nothing that the load could break
    assert verdict([room, warned]).verdict == "incomplete"
    assert verdict([room, CHECKS["shaft_slope"].judged(1.0, 2.0, reserve=2.0)]).verdict == "pass"
    assert verdict([room._replace(status="fail")]).verdict == "fail"
    assert verdict([seven]).governing is None


def test_shakedown_is_where_the_orthogonal_shear_yields() -> None:
    """Largest orthogonal shear over the depth: p0/4, found by hand over the stress field."""
    largest = 0.0
    for i in range(1, 200):
        for j in range(1, 200):
            x, z = i / 100, j / 100
            # McEwen, Johnson 4.49: m, n of the elliptic pressure over half-width 1
            root = math.sqrt((1 - x * x + z * z) ** 2 + 4 * x * x * z * z)
            m2, n2 = (root + (1 - x * x + z * z)) / 2, (root - (1 - x * x + z * z)) / 2
            n = math.copysign(math.sqrt(n2), x)
            largest = max(largest, abs(n * (m2 - z * z) / (m2 + n2)))
    assert largest == pytest.approx(0.25, rel=1e-3)
    assert SHAKEDOWN * largest == pytest.approx(1 / math.sqrt(3), rel=1e-3)


@given(st.floats(1.0, 1e4), st.floats(0.0, 1e-4), st.integers(1, 12), st.floats(50e6, 2e9))
def test_the_reserve_of_rollers(torque: float, tolerance: float, rollers: int, strength: float):
    """Not proportional: with more torque more rollers carry."""
    sizes = {
        "hole_circle_radius": 0.03,
        "rollers": rollers,
        "sphere_diameter": 0.015,
        "cylinder_length": 0.02,
        "sphere_width": 0.008,
        "spacing": PositionTolerance(tolerance),
    }
    more = {
        "diameter": 0.01,
        "friction_coefficient": 0.16,
        "youngs_modulus": 210e9,
        "shear": ByPoissonsRatio(0.3),
    }

    def check(torque: float) -> Check:
        result = roller_strength(output_torque=torque, **sizes, **more)  # type: ignore[arg-type]
        found = roller_checks(
            RollerDesign(
                result=result,
                output_torque=torque,
                yield_strength=strength,
                **sizes,  # type: ignore[arg-type]
            )
        )
        return found["roller_stress"]

    reserve = check(torque).torque_reserve
    assert reserve is not None
    assume(1e-6 < reserve < 1e6)
    assert check(torque * reserve).utilisation == pytest.approx(1, rel=EXACT)


def test_fixes_are_rounded_to_the_safe_side_and_say_what_else_changes() -> None:
    design = having(REF, output_torque=1000.0)
    current = crank_checks(Results(design))
    fixes = fixes_of(design, ["contact_pressure_hole"])
    assert {"contact.pin_radius", "contact.contact_length", "load.output_torque"} <= {
        fix.variable for fix in fixes
    }
    for fix in fixes:
        after = crank_checks(Results(vary(design=design, variable=fix.variable, value=fix.after)))
        if fix.status == "solved" and fix.variable not in WHOLE_NUMBERS:
            up = fix.exact > fix.before
            assert fix.after >= fix.exact if up else fix.after <= fix.exact
            assert fix.standard or abs(fix.after / fix.exact - 1) <= 0.01
            assert fix.standard or float(f"{fix.after:.3g}") == pytest.approx(
                fix.after, rel=CONVERGED
            )
        expected = set()
        for code in {each.code for each in current.checks} - {fix.code}:
            old, new = current[code], after[code]
            one, two = old.utilisation, new.utilisation
            moved = None not in (one, two) and abs(two - one) > 1e-3 * abs(one)  # type: ignore[operator, arg-type]
            if old.status != new.status or moved:
                expected.add(code)
        assert {each.code for each in fix.side_effects} == expected
        assert expected
