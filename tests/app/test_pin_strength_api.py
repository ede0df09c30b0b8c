"""Strength of the pins over REST."""

import pytest

from app.examples import REQUESTS
from core.precision import EXACT, SEARCHED
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "pin-strength"


def judged(**fatigue):
    return changed(REQUESTS[PATH]) | {"fatigue": fatigue}


async def test_the_worst_direction_of_a_high_exponent(api):
    """Random request with an oracle at 40 digits; the first local search misses the worst
    direction.
    """
    body = {
        "mechanism": {"pins": 2, "satellites": 4, "ratio": 500000, "crank_spacing_deg": 90.0},
        "load": {
            "pin_circle_radius_mm": 13570.0,
            "output_torque_Nm": 481.109508,
            "force_exponent": 300.0,
        },
        "pin": {
            "diameter_mm": 3.56,
            "contact_length_mm": 2.077,
            "satellite_positions_mm": [1.58, 4.04759678941505, 6.603, 9.723562603943055],
            "material": {"youngs_modulus_GPa": 198.0, "poissons_ratio": 0.2838,
                "tensile_strength_MPa": 1251.8462599391023, "yield_strength_MPa": 303.0},
        },
        "fatigue": {
            "criterion": "soderberg",
            "surface": "machined",
            "reliability_percent": 99,
            "notch": {"theoretical_factor": 3.3325824085460543, "radius_mm": 3.82e-06},
        },
    }  # fmt: skip
    answer = (await api.post(PATH, json=body)).json()
    assert answer["fatigue"]["safety_factor"] == pytest.approx(5.7074352635020088, rel=SEARCHED)


@pytest.mark.parametrize("path", ["pin-strength", "satellite-bearing", "crankshaft"])
@pytest.mark.parametrize(
    ("exponent", "code"),
    [(0, None), (1e-9, "greater_than_equal"), (1e-3, None), (500, None), (501, "less_than_equal")],
)
async def test_a_force_exponent_is_0_or_one_that_a_turn_resolves(api, path, exponent, code):
    load = REQUESTS[path]["load"] | {"force_exponent": exponent}
    body = REQUESTS[path] | {"load": load}
    answer = (await api.post(path, json=body)).json()
    refused = [(each["pointer"], each["code"]) for each in answer.get("errors", [])]
    assert refused == ([("/load/force_exponent", code)] if code else [])


NOTCHED = {"surface": "ground", "notch": {"theoretical_factor": 2.0, "radius_mm": 1.0}}
LIMITED = {"endurance_limit_MPa": 50.0}
LASTING = {"endurance_limit_MPa": 400.0}
KPSI = 6.894757293168361
LINE = 70 * KPSI, 200 * KPSI


@pytest.mark.parametrize(
    ("diameter", "strength", "fatigue", "beyond"),
    [
        (16.0, 490.0, NOTCHED, {}),
        (16.0, 345.0, NOTCHED, {"life_beyond_strength": (345, *LINE)}),
        (16.0, 335.0, NOTCHED, {
            "notch_beyond_strength": (335, 340, 1700), "life_beyond_strength": (335, *LINE),
        }),
        (30.0, 1690.0, NOTCHED, {}),
        (30.0, 1710.0, NOTCHED, {"notch_beyond_strength": (1710, 340, 1700)}),
        (30.0, 1710.0, {"surface": "ground", "fatigue_notch_factor": 2.0}, {}),
        (16.0, 1370.0, LIMITED, {}),
        (16.0, 1390.0, LIMITED, {"life_beyond_strength": (1390, *LINE)}),
        (16.0, 1390.0, LASTING, {}),
        (16.0, 1390.0, LASTING | {"life_h": 1.0}, {"life_beyond_strength": (1390, *LINE)}),
        (253.0, 1000.0, NOTCHED, {}),
        (255.0, 1000.0, NOTCHED, {"size_beyond_range": (255, 2.79, 254)}),
        (255.0, 1000.0, LIMITED, {}),
    ],
)  # fmt: skip
async def test_formulas_outside_their_range_are_warned_of(api, diameter, strength, fatigue, beyond):
    steel = REQUESTS[PATH]["pin"]["material"] | {"tensile_strength_MPa": strength}
    body = changed(REQUESTS[PATH], pin={"diameter_mm": diameter, "material": steel}) | {
        "fatigue": fatigue
    }
    warnings = (await api.post(PATH, json=body)).json().get("warnings", ())
    found = {each["code"]: each["params"] for each in warnings if "beyond" in each["code"]}
    assert found == {
        code: pytest.approx(dict(zip(("value", "low", "high"), numbers, strict=True)))
        for code, numbers in beyond.items()
    }


@pytest.mark.parametrize(
    ("body", "code"),
    [
        (judged(surface="ground"), "notch_unknown"),
        (changed(REQUESTS[PATH], pin={"material": "brass"}), "endurance_unknown"),
        (changed(REQUESTS[PATH], pin={"material": "steel_case_hardened"}), "endurance_unknown"),
        (changed(REQUESTS[PATH], pin={"diameter_mm": 31.0}), "short_pin"),
    ],
)
async def test_what_is_not_checked_is_said(api, body, code):
    answer = (await api.post(PATH, json=body)).json()
    assert code in [each["code"] for each in answer["warnings"]]
    assert ("fatigue" in answer) is (code == "short_pin")


async def test_satellites_may_touch_each_other(api):
    for places in ([10.0, 30.0], [30.1, 10.1], [10.3, 30.3]):
        answer = await api.post(PATH, json=changed(REQUESTS[PATH], pin={PLACES: places}))
        assert answer.status_code == 200, places
    near = (await api.post(PATH, json=changed(REQUESTS[PATH], pin={PLACES: [10.0, 29.0]}))).json()[
        "errors"
    ][0]
    assert near["params"] == {"field": "contact_length_mm", "limit": 20}


async def test_bounds_of_a_cage(api):
    """A load in the middle: F/4*(L - b/2) free to tilt, F/(24*L)*(3*L^2 - b^2) built in."""
    one = {PLACES: [26.0], "span_mm": 52.0}
    body = changed(REQUESTS[PATH], mechanism={"satellites": 1}, pin=one, include=["support_bounds"])
    answer = (await api.post(PATH, json=body)).json()
    force = answer["peak_force_N"] / 1e3
    moments = force / 4 * (52 - 10), force / 24 / 52 * (3 * 52**2 - 20**2)
    bounds = answer["support_bounds"]
    assert [each["support"] for each in bounds] == ["supported", "fixed"]
    assert [each["peak_moment_Nm"] for each in bounds] == pytest.approx(moments, rel=EXACT)
    assert answer["peak_moment_Nm"] == pytest.approx(force * 26, rel=EXACT)


@pytest.mark.parametrize("section", [None, "contact"])
async def test_bounds_are_the_pins_in_these_supports(api, section):
    """Also where pins in holes bend, by which the satellites share unevenly."""
    body = changed(REQUESTS[PATH], pin={"span_mm": 52.0}, include=["support_bounds", "deflection"])
    if section:
        sizes = {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "eccentricity_mm": 2.0}
        body["contact"] = sizes
    bounds = (await api.post(PATH, json=body)).json()["support_bounds"]
    for bound in bounds:
        body["pin"]["support"], body["include"] = bound.pop("support"), ["deflection"]
        alone = (await api.post(PATH, json=body)).json()
        assert alone.pop("forces") == ("real" if section else "ideal")
        alone.pop("assumed", None)
        alone.pop("warnings", None)
        for each in (bound, alone):
            del each["accuracy"]["run_time_us"]
        assert bound == alone


async def test_without_fatigue_asked_there_is_none(api):
    answer = (await api.post(PATH, json=changed(REQUESTS[PATH], fatigue=None, include=[]))).json()
    assert not {"fatigue", "deflection", "warnings"} & {*answer}


PLACES = "satellite_positions_mm"
SHORT = {"support": "fixed", "span_mm": 45.0}


async def test_a_refusal_names_the_limit_in_the_fields_unit(api):
    refused = await api.post(PATH, json=changed(REQUESTS[PATH], pin=SHORT))
    (error,) = refused.json()["errors"]
    assert error["params"]["limit"] == pytest.approx(35)  # 45 less half of 20
    assert "at most 35, half" in error["detail"]


async def test_the_figure_has_the_locus_and_the_stress(api):
    for theme in ("light", "dark"):
        figure = (await api.post(f"{PATH}/chart?theme={theme}", json=REQUESTS[PATH])).json()
        names = [trace["name"] for trace in figure["data"]]
        assert names == ["Moment over the turn", "Worst direction", "Bending stress"]
        assert max(figure["data"][2]["y"]) == pytest.approx(306.7048, rel=1e-4)


async def test_the_locus_where_it_is_asked(api):
    locus = (await api.post(PATH, json=changed(REQUESTS[PATH], include=["locus"]))).json()["locus"]
    assert max(locus["tangential_Nm"]) == pytest.approx(123.333, rel=1e-4)
    assert len(locus["stress_MPa"]) == len(locus["crank_angle_deg"])
