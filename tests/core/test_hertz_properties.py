"""Invariants of the line contact: scaling, symmetry, bounds, refusals."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from core.conformal import conformal_contact, load_under_pressure, widest_load
from core.errors import InvalidInput
from core.hertz import (
    HERTZ_TOLERANCE,
    ContactLimit,
    ElasticMaterial,
    HertzContact,
    force_factor,
    hertz,
    mismatch,
    narrow_load,
    pressure_profile,
)
from core.material_table import MATERIALS
from core.precision import CONVERGED, EXACT, JUDGED, SAME

STEEL = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)

materials = st.builds(
    ElasticMaterial,
    youngs_modulus=st.floats(1e8, 1e12),
    poissons_ratio=st.floats(0.0, 0.49),
    limit=st.one_of(st.none(), st.builds(ContactLimit, st.just("given"), st.floats(1e6, 5e9))),
)


@st.composite
def contacts(draw: st.DrawFn) -> dict[str, object]:
    pin_radius = draw(st.floats(1e-3, 0.1))
    return {
        "force": draw(st.floats(1e-2, 1e6)),
        "contact_length": draw(st.floats(1e-3, 0.5)),
        "pin_radius": pin_radius,
        "hole_radius": pin_radius * (1 + draw(st.floats(1e-4, 10.0))),
        "pin_material": draw(materials),
        "hole_material": draw(materials),
        "dynamic_factor": draw(st.floats(0.5, 3.0)),
        "distribution_factor": draw(st.floats(0.5, 3.0)),
    }


def calculate(contact: dict[str, object], **changes: object) -> HertzContact:
    return hertz(**(contact | changes))  # type: ignore[arg-type]


@given(contacts())
def test_the_pressure_over_the_width_carries_the_load(contact: dict[str, object]) -> None:
    """From end to end, where it is nothing: an ellipse of the area of the load per length."""
    found = calculate(contact)
    x, pressure = pressure_profile(contact=found, samples=2001)
    assert x[[0, -1]] == pytest.approx([-found.half_width, found.half_width], rel=SAME)
    assert pressure[[0, -1]] == pytest.approx([0, 0], abs=1e-15 * found.max_pressure)
    load = math.prod(
        contact[each]  # type: ignore[misc]
        for each in ("force", "dynamic_factor", "distribution_factor")
    )
    carried = np.trapezoid(pressure, x) * contact["contact_length"]
    assert carried == pytest.approx(load, rel=JUDGED)


@given(contacts())
def test_each_body_is_judged_by_its_own_limit(contact: dict[str, object]) -> None:
    one = calculate(contact)
    bodies = {"pin": contact["pin_material"], "hole": contact["hole_material"]}
    if math.isnan(one.governing):  # the contact would wrap around more than half of the pin
        assert one.conformal_pressure is None
        assert [each.code for each in one.notices] == ["contact_wraps"]
        assert (one.safety, one.safety_factor) == ((), None)
        return
    largest = one.max_pressure if one.conformal_pressure is None else one.conformal_pressure
    assert one.governing_pressure == largest
    known = {name: each.limit for name, each in bodies.items() if each.limit is not None}  # type: ignore[attr-defined]
    assert {each.body: each.limit for each in one.safety} == known
    for each in one.safety:
        assert each.safety_factor == pytest.approx(each.limit.pressure / largest, rel=SAME)
    if len(known) == 2:
        assert one.safety_factor == min(each.safety_factor for each in one.safety)
    else:
        assert one.safety_factor is None


@given(st.lists(contacts(), min_size=1, max_size=6), st.booleans())
def test_contacts_of_an_array_are_those_one_by_one(
    several: list[dict[str, object]], alike: bool
) -> None:
    if alike:
        for contact in several:
            contact["hole_material"] = contact["pin_material"]
    sizes = [name for name in several[0] if not name.endswith("material")]
    together = hertz(
        **{name: np.array([contact[name] for contact in several]) for name in sizes},
        **{
            name: ElasticMaterial(
                np.array([contact[name].youngs_modulus for contact in several]),  # type: ignore[attr-defined]
                np.array([contact[name].poissons_ratio for contact in several]),  # type: ignore[attr-defined]
                ContactLimit(
                    "given", np.array([pressure_of(contact[name]) for contact in several])
                ),
            )
            for name in ("pin_material", "hole_material")
        },
    )
    for index, contact in enumerate(several):
        one = calculate(contact)
        for name in HertzContact._fields:
            if name in ("safety", "accuracy", "mismatch"):
                continue
            expected, got = getattr(one, name), getattr(together, name)
            value = math.nan if got is None else got[index]
            expected = math.nan if expected is None else expected
            assert value == pytest.approx(expected, rel=CONVERGED, abs=0, nan_ok=True), name
        assert together.accuracy.relative_error[index] == one.accuracy.relative_error
        alone = {each.body: each.safety_factor for each in one.safety}
        for each in together.safety:
            expected = alone.get(each.body, math.nan)
            assert each.safety_factor[index] == pytest.approx(expected, rel=CONVERGED, nan_ok=True)


def pressure_of(material: ElasticMaterial) -> float:
    return math.nan if material.limit is None else material.limit.pressure


def test_the_entry_of_an_array_that_is_refused_is_named() -> None:
    one = np.ones(3)
    good = {"force": one, "contact_length": one, "pin_radius": one, "hole_radius": 2 * one}
    for name, value in (("force", -1.0), ("pin_radius", 0.0), ("hole_radius", 1.0)):
        wrong = good[name].copy()
        wrong[1] = value
        with pytest.raises(InvalidInput) as refusal:
            hertz(**(good | {name: wrong}), pin_material=STEEL, hole_material=STEEL)
        assert refusal.value.parameter == f"{name}[1]"


@given(contacts())
def test_conformal_pressure_only_where_it_applies(contact: dict[str, object]) -> None:
    for changes in ({}, {"hole_material": contact["pin_material"]}):
        one = calculate(contact, **changes)
        alpha, beta = one.mismatch
        assert one.mismatch == mismatch(
            first=contact["pin_material"],  # type: ignore[arg-type]
            second=changes.get("hole_material", contact["hole_material"]),  # type: ignore[arg-type]
        )
        wide = one.conformity * widest_load(alpha=alpha, beta=beta) <= 1
        found = conformal_contact(
            load_parameter=1 / one.conformity, alpha=alpha, beta=beta
        ).pressure / math.sqrt(1 / one.conformity / math.pi)
        if one.conformal_pressure is None:
            assert math.isnan(one.governing) == (not wide)
            assert not wide or found <= (1 + HERTZ_TOLERANCE) * (1 + 1e-12)
            assert one.edge_tension is None
            continue
        assert one.conformal_pressure > (1 + HERTZ_TOLERANCE) * one.max_pressure
        assert one.conformal_pressure == pytest.approx(found * one.max_pressure, rel=EXACT)
        assert one.conformal_half_angle is not None
        assert 0 < one.conformal_half_angle <= math.pi / 2
        assert one.edge_tension > 0  # type: ignore[operator]
        assert (one.accuracy.relative_error > 1e-10) == (abs(beta) > 1e-2)


def test_bearing_steel_and_tempered_steel_have_a_conformal_pressure() -> None:
    """207 on 206 GPa: nearly what equal materials of the mean modulus have."""
    sizes = {"force": 5000.0, "contact_length": 0.02, "pin_radius": 0.008, "hole_radius": 0.00802}
    bearing, tempered = ElasticMaterial(207e9, 0.3), ElasticMaterial(206e9, 0.3)
    mean = ElasticMaterial(206.4988e9, 0.3)
    one = hertz(**sizes, pin_material=bearing, hole_material=tempered)  # type: ignore[arg-type]
    same = hertz(**sizes, pin_material=mean, hole_material=mean)  # type: ignore[arg-type]
    assert one.conformal_pressure == pytest.approx(same.conformal_pressure, rel=4e-4)
    assert one.conformal_pressure != pytest.approx(same.conformal_pressure, rel=JUDGED)
    assert 0 < one.accuracy.relative_error - same.accuracy.relative_error < 1e-11


@pytest.mark.parametrize("load_parameter", [0.3, 1.0, 5.0, 40.0])
def test_the_pressure_is_continuous_where_the_constants_vanish(load_parameter: float) -> None:
    """Both from both sides: the difference falls with them."""
    same = conformal_contact(load_parameter=load_parameter)
    for alpha, beta in ((1e-6, 0.0), (-1e-6, 0.0), (0.0, 1e-6), (0.0, -1e-6), (1e-6, 1e-6)):
        near = conformal_contact(load_parameter=load_parameter, alpha=alpha, beta=beta)
        nearer = conformal_contact(
            load_parameter=load_parameter, alpha=alpha / 100, beta=beta / 100
        )
        for name in ("tangent", "pressure", "mean_pressure"):
            off = getattr(near, name) - getattr(same, name)
            assert 0 < abs(off) < 1e-6
            assert getattr(nearer, name) - getattr(same, name) == pytest.approx(
                off / 100, abs=1e-13
            )


@given(st.floats(-1, 1), st.floats(-0.25, 0.25), st.floats(-3, 4))
def test_the_pressure_grows_with_the_load_and_its_parameter(
    alpha: float, beta: float, power: float
) -> None:
    beta = max(min(alpha / 4 + beta, 0.5), -0.5)
    load_parameter = max(widest_load(alpha=alpha, beta=beta), 0.0) + 10**power
    one, more = (
        conformal_contact(load_parameter=each, alpha=alpha, beta=beta)
        for each in (load_parameter, load_parameter / 1.01)
    )
    assert one.tangent < more.tangent or math.isnan(more.tangent)
    assert one.pressure < 1.01 * more.pressure or math.isnan(more.tangent)
    again = load_under_pressure(
        pressure_parameter=one.pressure / load_parameter, alpha=alpha, beta=beta
    )
    assert again == pytest.approx(load_parameter, rel=SAME)


def test_beyond_a_right_angle_nothing_is_known() -> None:
    alpha, beta = -0.97, -0.2
    least = widest_load(alpha=alpha, beta=beta)
    assert least > 0
    at, beyond = (
        conformal_contact(load_parameter=least * share, alpha=alpha, beta=beta)
        for share in (1 + 1e-9, 1 - 1e-9)
    )
    assert at.tangent == pytest.approx(1.0, abs=1e-7)
    assert math.isnan(beyond.tangent) and math.isnan(beyond.pressure)
    # a pressure that is not reached before
    assert load_under_pressure(pressure_parameter=1e6, alpha=alpha, beta=beta) == pytest.approx(
        least, rel=SAME
    )


def test_contacts_beyond_a_right_angle_are_masked_in_arrays() -> None:
    plastic = ElasticMaterial(2.8e9, 0.38, ContactLimit("given", 60e6))
    force = np.array([1.0, 3e3, 1e6])
    found = hertz(
        force=force,
        contact_length=0.02,
        pin_radius=0.006,
        hole_radius=0.00602,
        pin_material=plastic,
        hole_material=STEEL,
    )
    assert found.conformal_pressure is not None
    assert np.isnan(found.governing).tolist() == [False, False, True]
    assert np.isnan(found.conformal_pressure).tolist() == [True, False, True]
    assert np.isnan(found.safety[0].safety_factor).tolist() == [False, False, True]


@pytest.mark.parametrize("limit", [5e6, 9e6, 10e6, 10.1e6, 20e6, 60e6, 1e12])
def test_the_force_under_which_a_pressure_is_at_its_limit(limit: float) -> None:
    """A contact of a plastic pin wraps around half of it before the largest limit."""
    sizes = {"contact_length": 0.02, "pin_radius": 0.006, "hole_radius": 0.0065}
    plastic = ElasticMaterial(2.8e9, 0.38)

    def at(factor: float) -> HertzContact:
        force = 100.0 * factor
        return hertz(force=force, **sizes, pin_material=plastic, hole_material=STEEL)

    factor = force_factor(contact=at(1.0), contact_at=at, limit=limit)
    there = at(factor)
    assert there.governing_pressure <= limit
    after = at(factor * (1 + 1e-9)).governing
    jump = math.isnan(after) or after > 1.009 * there.governing_pressure
    assert there.governing_pressure == pytest.approx(limit, rel=EXACT) or jump


WRAPPED = {
    "force": 449321.0,
    "contact_length": 0.004,
    "pin_radius": 0.03,
    "hole_radius": 0.06,
    "pin_material": ElasticMaterial(1e8, 0.375),
    "hole_material": ElasticMaterial(1e8, 0.0),
}


@given(contacts())
@example(WRAPPED)
def test_everything_is_a_number_whatever_the_contact(contact: dict[str, object]) -> None:
    """The judged pressure is the exception, if the contact would wrap around the pin."""
    one = calculate(contact)
    assert math.isfinite(one.governing) or one.half_width_ratio > 3
    for name in HertzContact._fields:
        value = getattr(one, name)
        if isinstance(value, float) and not (name == "governing" and one.half_width_ratio > 3):
            assert math.isfinite(value)
            assert value > 0
    factor = 1e-8 * abs(one.mismatch[1]) if one.governing > one.max_pressure else 0.0
    assert 0 < one.accuracy.relative_error - factor < 1e-10


def test_no_load_no_pressure() -> None:
    none = hertz(
        force=0.0,
        contact_length=0.02,
        pin_radius=0.006,
        hole_radius=0.008,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    assert (none.max_pressure, none.half_width, none.max_shear) == (0.0, 0.0, 0.0)
    assert none.safety_factor is None
    assert none.conformal_pressure is None


@pytest.mark.parametrize(
    ("parameter", "value"),
    [
        ("force", -1.0),
        ("force", math.nan),
        ("contact_length", 0.0),
        ("pin_radius", 0.0),
        ("pin_radius", -0.006),
        ("hole_radius", 0.006),
        ("hole_radius", 0.005),
        ("hole_radius", math.nan),
        ("dynamic_factor", 0.0),
        ("distribution_factor", -1.0),
    ],
)
def test_contacts_that_cannot_be_are_refused_by_name(parameter: str, value: float) -> None:
    # R = r would give "stress 0: infinitely safe"
    contact: dict[str, object] = {
        "force": 1e3,
        "contact_length": 0.02,
        "pin_radius": 0.006,
        "hole_radius": 0.008,
        "pin_material": STEEL,
        "hole_material": STEEL,
    }
    with pytest.raises(InvalidInput) as refusal:
        calculate(contact, **{parameter: value})
    assert refusal.value.parameter == parameter


@pytest.mark.parametrize(
    ("parameter", "values"),
    [
        ("youngs_modulus", (0.0, 0.3)),
        ("youngs_modulus", (-1.0, 0.3)),
        ("youngs_modulus", (math.nan, 0.3)),
        ("poissons_ratio", (210e9, 0.5)),
        ("poissons_ratio", (210e9, -0.1)),
        ("poissons_ratio", (210e9, math.nan)),
    ],
)
def test_materials_that_cannot_be_are_refused(parameter: str, values: tuple[float, float]) -> None:
    with pytest.raises(InvalidInput) as refusal:
        ElasticMaterial(youngs_modulus=values[0], poissons_ratio=values[1])
    assert refusal.value.parameter == parameter
    if values[1] == 0.5:
        assert (refusal.value.code, refusal.value.params) == ("less_than", {"limit": 0.5})


@pytest.mark.parametrize("name", MATERIALS)
def test_materials_of_the_table_are_plausible(name: str) -> None:
    entry = MATERIALS[name]
    assert entry.name == name
    assert entry.title
    assert entry.group
    assert entry.source
    assert len({limit.criterion for limit in entry.limits}) == len(entry.limits)
    for limit in entry.limits:
        assert limit.source
        assert 10e6 <= limit.pressure <= 4.5e9
    if entry.missing:
        return
    assert 1e9 <= entry.material.youngs_modulus <= 250e9
    assert 0.25 <= entry.material.poissons_ratio <= 0.45
    # a limit that holds under a load at rest says nothing of the long run
    judged = entry.material.limit
    assert judged is None or (judged.criterion != "static" and judged in entry.limits)


@pytest.mark.parametrize(("gap", "codes"), [(1e-12, []), (3e-15, ["hardly_known"])])
def test_radii_that_are_equal_but_for_rounding_say_that_hardly_anything_is_known(
    gap: float, codes: list[str]
) -> None:
    contact = hertz(
        force=1e-12,
        contact_length=1.0,
        pin_radius=1.0,
        hole_radius=1.0 + gap,
        pin_material=STEEL,
        hole_material=ElasticMaterial(youngs_modulus=100e9, poissons_ratio=0.3),
    )
    assert [notice.code for notice in contact.notices] == codes


def test_the_load_from_which_the_conformal_pressure_is_given_of_identical_materials() -> None:
    """Found at 40 digits."""
    load_parameter = 50.1910356000450
    found = conformal_contact(load_parameter=load_parameter)
    ratio = found.pressure / math.sqrt(load_parameter / math.pi)
    assert ratio - 1 == pytest.approx(HERTZ_TOLERANCE, rel=SAME)


@pytest.mark.parametrize("alpha", [-1.0, -0.5, 0.0, 0.5, 1.0])
def test_no_narrower_contact_of_any_two_materials_has_a_conformal_pressure(alpha: float) -> None:
    for beta in np.linspace((alpha - 1) / 4, (alpha + 1) / 4, 5).tolist():
        load = narrow_load(beta) * np.geomspace(1.0, 100.0, 40)
        found = conformal_contact(load_parameter=load, alpha=alpha, beta=beta)
        assert (found.pressure / np.sqrt(load / np.pi) < 1 + HERTZ_TOLERANCE).all()


@pytest.mark.parametrize(("alpha", "beta"), [(1.0, 0.0), (-1.0, -0.5)])
def test_of_two_pairs_of_materials_hardly_a_wider_one_has_none(alpha: float, beta: float) -> None:
    load = 0.98 * narrow_load(beta)
    found = conformal_contact(load_parameter=load, alpha=alpha, beta=beta)
    assert found.pressure / math.sqrt(load / math.pi) > 1 + HERTZ_TOLERANCE
