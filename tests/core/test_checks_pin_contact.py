"""Checks of the contact of pin and hole by hand, at, below and above their limits: ideal forces."""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.crank_planetary import crank_checks
from core.conformal import disc_error
from core.design.document import Design
from core.design.results import Results
from core.fixes.changes import vary
from core.hertz import ContactLimit, ElasticMaterial, first_yield
from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.checks import HOLE, PIN, REF, check_of, fixes_of, having, says
from tests.oracles.checks import PRESSURE

SOFT = ElasticMaterial(3e9, 0.35, ContactLimit("given", 60e6), yield_strength=60e6)


def contact(limit: float, **more: Any) -> dict[str, Any]:
    """Check of the pressure of the reference design."""
    status = "pass" if limit > PRESSURE * math.sqrt(1.1) else "marginal"
    return {
        "status": status if limit > PRESSURE else "fail",
        "value": PRESSURE,
        "limit": limit,
        "utilisation": PRESSURE / limit,
        "torque_reserve": (limit / PRESSURE) ** 2,
        "margin": limit - PRESSURE,
    } | more


@pytest.mark.parametrize("safety", [0.5, 1.2, 1.5, 2.0])
def test_pressure(safety: float) -> None:
    design = having(REF, pitting_safety=safety)
    for body, limit in (("pin", 900e6), ("hole", 600e6)):
        found = check_of(f"contact_pressure_{body}", design)
        given = {"criterion": "given", "verified": "", "limit_source": "", "life_factor": None}
        says(found, **contact(limit / safety, reason="no_life_curve", **given))
        assert Results(design).contact_force is not None
        assert found.at == Results(design).peak
        assert {*found.at} == {"satellite", "pin", "crank_angle"}


def test_pressure_says_where_its_limit_is_from() -> None:
    limit = ContactLimit("endurance", 600e6, "iso_281")
    found = check_of("contact_pressure_hole", having(REF, hole_material=replace(HOLE, limit=limit)))
    assert (found.limit_source, found.criterion) == ("iso_281", "endurance")
    assert found.verified == limit.verified != ""


LASTING = ContactLimit("given", 600e6, curve="hardened")
"""A limit that falls over the life."""

# 60*1500*(1 + 1/20)*5000 = 4.725e8 turns against the cranks: (5e7/4.725e8)^0.0306
SPEED, FACTOR = 50 * math.pi, 0.93358053

LIVES: dict[str, tuple[float, float, float]] = {
    # speed, hours, factor
    "reference": (SPEED, 5000, FACTOR),
    "half the speed, twice the life": (SPEED / 2, 10000, FACTOR),
    "the knee": (SPEED, 5e7 / 94500, 1.0),
    "short": (SPEED, 10, (5e7 / 945000) ** 0.0756),
    "few loads": (SPEED, 1, 1.6),
}


def life_left_out(design: Design) -> set[str]:
    """Bodies whose life under the contact pressure is not considered."""
    return {
        body
        for body in ("pin", "hole")
        if f"contact_life_{body}" in crank_checks(Results(design)).not_considered
    }


@pytest.mark.parametrize("name", LIVES)
@pytest.mark.parametrize("loose", [0.0, 3e-5])
def test_the_limit_is_that_over_the_life(name: str, loose: float) -> None:
    """The limit, the reserve and what governs; of ideal forces and of those as made."""
    speed, hours, factor = LIVES[name]
    design = having(
        REF,
        hole_material=replace(HOLE, limit=LASTING),
        hole_radius=0.010 + loose,
        input_speed=speed,
        life=hours * 3600,
    )
    found = check_of("contact_pressure_hole", design)
    assert found.life_factor == pytest.approx(factor, rel=SEARCHED)
    assert found.limit == pytest.approx(600e6 * factor / 1.2, rel=SEARCHED)
    assert found.reason == "life_of_teeth" and found.missing == ()
    assert found.torque_reserve is not None
    there = having(design, output_torque=500.0 * found.torque_reserve)
    if not loose:  # the forces grow with the torque
        at_limit = check_of("contact_pressure_hole", there).utilisation
        assert at_limit == pytest.approx(1, rel=EXACT)
    assert Results(design).hertz.safety[1].safety_factor == pytest.approx(
        600e6 * factor / Results(design).hertz.governing_pressure, rel=SEARCHED
    )
    # of the other body it is not known
    pin = check_of("contact_pressure_pin", design)
    assert (pin.life_factor, pin.limit, pin.reason) == (None, 900e6 / 1.2, "no_life_curve")
    assert life_left_out(design) == {"pin"}


def test_what_is_not_known_of_the_life_is_said() -> None:
    bodies = {"pin_material": PIN, "hole_material": HOLE}
    both = {name: replace(each, limit=LASTING) for name, each in bodies.items()}
    still = having(REF, **both)  # type: ignore[arg-type]
    found = check_of("contact_pressure_hole", still)
    least = (5e7 / 1e10) ** 0.0306
    assert found.life_factor == pytest.approx(least, rel=SAME)
    assert found.limit == pytest.approx(600e6 * least / 1.2, rel=SAME)
    assert (found.reason, found.missing) == ("life_without_speed", ("load.input_speed",))
    assert life_left_out(still) == set()
    turning = having(still, input_speed=SPEED)
    assert life_left_out(turning) == set()
    unknown = having(turning, pin_material=replace(PIN, limit=None))
    assert life_left_out(unknown) == set()  # it is not checked at all
    assert life_left_out(having(REF, pin_radius=None)) == set()


def test_a_limit_within_the_loss_of_a_long_life_fails() -> None:
    """Green by 3 % of the limit as it stands; not after 5000 h."""
    pressure = float(Results(REF).hertz.governing_pressure)
    limit = replace(LASTING, pressure=1.2 * 1.06 * pressure)
    design = having(REF, hole_material=replace(HOLE, limit=limit))
    unknown = check_of("contact_pressure_hole", design)
    says(
        unknown._replace(at={}, life_factor=None),
        status="marginal",
        value=PRESSURE,
        limit=1.06 * PRESSURE * (5e7 / 1e10) ** 0.0306,
        utilisation=1 / (1.06 * (5e7 / 1e10) ** 0.0306),
        torque_reserve=(1.06 * (5e7 / 1e10) ** 0.0306) ** 2,
        reason="range_decides",
        missing=("load.input_speed",),
    )
    worse = having(design, output_torque=500 * 1.06**2 * 1.001)  # without a factor of the life
    assert check_of("contact_pressure_hole", worse).status == "fail"
    lasting = having(design, input_speed=SPEED, life=5000 * 3600)
    assert check_of("contact_pressure_hole", lasting).status == "fail"
    for fix in fixes_of(lasting, ["contact_pressure_hole"]):
        cured = vary(design=lasting, variable=fix.variable, value=fix.after)
        check = check_of("contact_pressure_hole", cured)
        assert check.status == "pass" and check.torque_reserve >= 1.1  # type: ignore[operator]
        assert check.life_factor == pytest.approx(FACTOR, rel=SEARCHED)


def test_a_limit_that_is_not_known() -> None:
    unknown = ElasticMaterial(210e9, 0.3)
    design = having(REF, hole_material=unknown)
    says(
        check_of("contact_pressure_hole", design),
        status="not_checked",
        value=PRESSURE,
        reason="limit_unknown",
        missing=("contact.hole_material.allowable_pressure",),
        at=Results(design).peak,
    )
    for code in ("contact_shakedown_hole", "contact_yield_hole"):
        says(
            check_of(code, design),
            status="not_checked",
            value=None,
            reason="yield_unknown",
            missing=("contact.hole_material.yield_strength",),
        )
    assert check_of("contact_pressure_hole", having(design, pins=2, satellites=1)).value is None
    tested = having(REF, hole_material=replace(HOLE, yield_governs=False))
    for code in ("contact_shakedown_hole", "contact_yield_hole"):
        says(check_of(code, tested), status="not_applicable", value=None, reason="tested_limit")


@pytest.mark.parametrize("factor", [0.5, 1.0, 2.0])
def test_shakedown_and_first_yield(factor: float) -> None:
    for body, strength in (("pin", 300e6), ("hole", 200e6)):
        bodies = {"pin": PIN, "hole": HOLE}
        material = replace(bodies[body], yield_strength=strength * factor)
        design = having(REF, **{f"{body}_material": material})
        says(
            check_of(f"contact_shakedown_{body}", design),
            **contact(2.06 * strength * factor, at=Results(design).peak),
        )
        yields = first_yield(poissons_ratio=0.3, friction=0.1) * strength * factor
        first = contact(yields, warning=True)
        if first["status"] == "fail":
            first |= {"status": "marginal", "reason": "plastic_first"}
        elif first["status"] == "marginal":
            first |= {"status": "pass"}
        says(check_of(f"contact_yield_{body}", design), **first)


def test_wide_contacts_have_a_pressure_of_their_own() -> None:
    """Materials may differ a lot, up to a contact that wraps around half of the pin."""
    narrow = check_of("contact_conformity", REF)
    assert (narrow.status, narrow.reason) == ("not_applicable", "conformal_solution")
    soft = having(REF, pin_material=SOFT, output_torque=5e3)
    contact = Results(soft).hertz
    assert contact.half_width_ratio > 0.2 and contact.conformal_pressure is not None
    assert check_of("contact_pressure_pin", soft).value == contact.conformal_pressure
    # beyond that nothing is known
    none = having(soft, output_torque=1e9)
    for code in ("contact_pressure_pin", "contact_shakedown_hole"):
        unknown = check_of(code, none)
        assert (unknown.status, unknown.reason) == ("not_checked", "contact_wraps")
        assert unknown.limit is not None and unknown.value is None
    # the reserve is that of the pressure, not of its square
    for limit in (60e6, 200e6):
        given = having(soft, pin_material=replace(SOFT, limit=ContactLimit("given", limit)))
        reserve = check_of("contact_pressure_pin", given).torque_reserve
        assert reserve is not None
        there = having(given, output_torque=5e3 * reserve)
        assert check_of("contact_pressure_pin", there).utilisation == pytest.approx(1, rel=EXACT)
        square = (limit / 1.2 / float(contact.governing_pressure)) ** 2
        assert reserve != pytest.approx(square, rel=0.02)
    # of steel it may end before the pressure reaches a limit
    strong = replace(SOFT, limit=ContactLimit("given", 1e12))
    reserve = check_of("contact_pressure_pin", having(soft, pin_material=strong)).torque_reserve
    assert reserve is not None
    for share, known in ((1 - 1e-9, True), (1 + 1e-9, False)):
        at = Results(having(soft, output_torque=5e3 * reserve * share)).hertz
        assert math.isnan(at.governing) != known


@pytest.mark.parametrize(
    ("distance", "status", "reason"),
    [
        (5.01, "pass", "no_life_curve"),
        (4.9, "marginal", "pressure_error"),
        (1.99, "not_checked", "disc_ovals"),
    ],
)
@pytest.mark.parametrize("edge", ["bore_radius", "root_radius"])
def test_the_edge_of_the_satellite_is_part_of_the_error(
    edge: str, distance: float, status: str, reason: str
) -> None:
    """The limit of a wrapping contact is 4 % above the pressure."""
    wide = having(REF, hole_radius=0.00802, eccentricity=2e-5)
    pressure = float(Results(wide).hertz.governing_pressure)  # type: ignore[arg-type]
    limit = ContactLimit("given", 1.2 * 1.04 * pressure)
    sign = -1 if edge == "bore_radius" else 1
    body = {edge: 0.05 + sign * distance * 0.00802}
    design = having(wide, hole_material=replace(HOLE, limit=limit), **body)
    found = check_of("contact_pressure_hole", design)
    if status == "pass":  # within a tenth of the torque it is marginal by that
        assert (found.status, found.reason) == ("marginal", reason)
    else:
        assert (found.status, found.reason) == (status, reason)
    assert found.value == pressure and found.limit == pytest.approx(1.04 * pressure, rel=SAME)
    beyond = replace(HOLE, limit=ContactLimit("given", 1.2 * 0.8 * pressure))
    assert check_of("contact_pressure_hole", having(design, hole_material=beyond)).status == "fail"
    at_rest = replace(HOLE, static_pressure=1.04 * pressure)
    still = having(design, hole_material=at_rest, peak_torque=500.0)
    at_once = check_of("contact_static_hole", still)
    assert (at_once.status, at_once.reason == "disc_ovals") == (
        status if status == "not_checked" else "marginal",
        status == "not_checked",
    )
    notice = Results(design).disc_of(Results(design).hertz)
    codes = {"pass": None, "marginal": "finite_disc", "not_checked": "disc_ovals"}
    assert (notice and notice.code) == codes[status]
    narrow = Results(having(REF, **{edge: 0.05 + sign * distance * 0.01}))
    assert narrow.disc_of(narrow.hertz) is None


@pytest.mark.parametrize(
    ("distance", "error"), [(2.0, 0.15), (2.99, 0.15), (3.0, 0.08), (4.0, 0.05), (5.0, 0.0)]
)
def test_how_far_the_edge_of_the_satellite_moves_the_pressure(
    distance: float, error: float
) -> None:
    assert disc_error(distance) == error


@pytest.mark.parametrize("limit", [30e6, 60e6, 600e6, 2400e6])
def test_the_reserve_of_a_conformal_contact_is_where_its_pressure_reaches_the_limit(
    limit: float,
) -> None:
    material = replace(HOLE, limit=ContactLimit("given", limit))
    design = having(REF, hole_radius=0.00802, eccentricity=2e-5, hole_material=material)
    reserve = check_of("contact_pressure_hole", design).torque_reserve
    assert reserve is not None
    there = having(design, output_torque=500.0 * reserve)
    assert check_of("contact_pressure_hole", there).utilisation == pytest.approx(1, rel=SAME)


def test_a_pressure_within_rounding_of_its_limit_is_marginal() -> None:
    assert Results(REF).hertz is not None
    pressure, error = (
        float(Results(REF).hertz.max_pressure),
        Results(REF).hertz.accuracy.relative_error,
    )
    for part, status in ((7.5, "marginal"), (8.5, "fail")):
        limit = ContactLimit("given", 1.2 * pressure * (1 - part * float(error)))
        design = having(REF, hole_material=replace(HOLE, limit=limit))
        assert check_of("contact_pressure_hole", design).status == status
