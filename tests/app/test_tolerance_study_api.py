"""Tolerances over REST: a run that was calculated apart from this program, sections, bounds,
refusals, and the ISO 286 table.
"""

import json
import math
from contextlib import suppress
from copy import deepcopy
from itertools import pairwise

import plotly.graph_objects as go
import pytest

from app.calculations.tolerance_study import (
    BACKLASH_SOLVES,
    POSITIONS_PER_SECOND,
    ToleranceStudyRequest,
)
from app.endpoint import read_body
from app.examples import REQUESTS
from app.problems import Problem
from app.registry import CALCULATIONS
from app.settings import Settings
from core.errors import InvalidInput
from core.precision import EXACT, SAME, SEARCHED
from core.tolerance.quantiles import percentile
from tests.inputs.tolerances import ARCMIN, run
from tests.oracles.work import steps

pytestmark = pytest.mark.anyio

PATH = "tolerance-study"
CHECKED = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.02,
    },
    "contact_law": {"kind": "linear", "stiffness_N_per_mm": 1e5},
    "tolerances": {
        "pin_position_mm": 0.01,
        "hole_position_mm": 0.02,
        "pin_diameter": {"class": "m6"},
        "hole_diameter": {"class": "H7"},
        "eccentricity_mm": 0.005,
        "disc_phase_deg": 0.01,
    },
    "seed": 7,
    "quantities": ["peak_force_N", "transmission_error_arcmin"],
    "percentiles": [50, 95, 99],
    "limits": {"peak_force_N": 3200},
}
"""The run of tests/inputs/tolerances.py as it is posted, which is solved in exact geometry."""

FEW = {"samples": 30, "crank_angles": 12, "percentiles": [50], "quantities": ["peak_force_N"]}


def changed(tolerances=None, **more):
    body = deepcopy(CHECKED | FEW) | more
    if tolerances is not None:
        body["tolerances"] = tolerances
    return body


async def test_the_first_pieces(api):
    """The means of one, two, three pieces give each of them."""
    means = []
    for samples in (1, 2, 3):
        body = CHECKED | {"samples": samples, "percentiles": []}
        quantities = (await api.answer(PATH, body))["quantities"]
        means.append([quantities[name]["mean"] for name in CHECKED["quantities"]])
    expected = run(3, exact=True)
    columns = (expected.values / [1, ARCMIN]).T
    for column, values in zip(zip(*means, strict=True), columns, strict=True):
        sums = [mean * (i + 1) for i, mean in enumerate(column)]
        pieces = [sums[0], sums[1] - sums[0], sums[2] - sums[1]]
        assert pieces == pytest.approx(values, rel=EXACT)
    nominal = quantities["peak_force_N"]["nominal"]
    assert nominal == pytest.approx(expected.nominal["peak_force"], rel=EXACT)


async def test_what_is_assumed_and_warned_of_is_of_the_request(api):
    """Not of what a fit or the middles of the tolerances make of it."""
    contact = {"contact_length_mm": 12, "pin_radius_mm": 5, "eccentricity_mm": 2, "fit": "H7/f7"}
    asked = {"contact": contact, "tolerances": {"pin_position_mm": 0.01}}
    answer = await api.answer(PATH, CHECKED | FEW | asked)
    codes = [each["code"] for each in answer.get("warnings", ())]
    assert "perfect_parts" not in codes and len(codes) == len({*codes})
    pointers = [each["pointer"] for each in answer["assumed"]]
    assert {pointer.split("/")[1] for pointer in pointers} <= {*ToleranceStudyRequest.model_fields}
    assert len(pointers) == len({*pointers})


async def test_the_whole_run(api):
    """Four pieces do not fit and are left out of the percentiles, whose ranks move by two."""
    answer = await api.answer(PATH, CHECKED | {"samples": 4096})
    force = answer["quantities"]["peak_force_N"]
    expected = run(4096, exact=True)
    for found in force["percentiles"]:
        peak = expected.percentile(quantity="peak_force", percent=found["percent"])
        values = [found[name] for name in ("value", "low", "high")]
        assert values == pytest.approx([peak.value, peak.low, peak.high], rel=EXACT)
    kept, most = force["yield"], expected.yield_within(quantity="peak_force", limit=3200.0)
    assert (kept["limit"], kept["value"]) == (3200, most.value)
    assert [kept["low"], kept["high"]] == pytest.approx([most.low, most.high], rel=EXACT)
    lag = answer["quantities"]["transmission_error_arcmin"]["percentiles"][1]
    most = expected.percentile(quantity="transmission_error", percent=95)
    assert lag["value"] == pytest.approx(most.value / ARCMIN, rel=EXACT)
    assert answer["fits"] == 4096 - round(4096 * answer["cannot_assemble"]["value"])
    assert answer["binds_in_turning"] + answer["does_not_fit"] == 4096 - answer["fits"]


PRINTED = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 15},
    "load": {"pin_circle_radius_mm": 22, "output_torque_Nm": 5.0},
    "contact": {
        "contact_length_mm": 8.0,
        "pin_radius_mm": 4,
        "eccentricity_mm": 1.5,
        "hole_clearance_mm": 0.1,
    },
    "contact_law": {"kind": "linear", "stiffness_N_per_mm": 10000.0},
    "tolerances": {
        "pin_position_mm": 0.1,
        "hole_position_mm": 0.15,
        "pin_diameter": {"lower_mm": -0.04, "upper_mm": 0.04},
        "hole_diameter": {"lower_mm": -0.08, "upper_mm": 0.08},
        "eccentricity_mm": 0.02,
    },
    "samples": 400,
    "seed": 7,
    "quantities": ["backlash_max_arcmin"],
}
"""A printed drive; how many of its pieces fit was found by arcs and by scanned distances."""


async def test_the_pieces_that_fit_are_counted(api):
    answer = await api.answer(PATH, PRINTED)
    assert (answer["fits"], answer["does_not_fit"] + answer["binds_in_turning"]) == (264, 136)
    found = answer["cannot_assemble"]
    assert [1 - found["high"], 1 - found["value"], 1 - found["low"]] == pytest.approx(
        [0.6112739562844375, 0.66, 0.706337836679156], abs=1e-12
    )


async def test_none_that_fits_is_an_answer(api):
    """More pieces would not help, and percentiles of what cannot be put together say nothing."""
    wide = PRINTED | {"tolerances": {"hole_position_mm": 3}, "samples": 100}
    answer = await api.answer(PATH, wide | {"limits": {"backlash_max_arcmin": 10}})
    assert (answer["fits"], answer["cannot_assemble"]["value"]) == (0, 1)
    backlash = answer["quantities"]["backlash_max_arcmin"]
    assert backlash["percentiles"] == [] and "mean" not in backlash and "nominal" in backlash
    assert backlash["yield"]["value"] == 0 and "yield_of_fitting" not in backlash
    assert "no_piece_fits" in [each["code"] for each in answer["warnings"]]
    few = PRINTED | {"percentiles": [50.0, 99.0]}
    answer = await api.answer(PATH, few)
    assert [each["percent"] for each in answer["quantities"]["backlash_max_arcmin"]["percentiles"]
            ] == [50.0]  # fmt: skip
    assert "too_few_fit" in [each["code"] for each in answer["warnings"]]
    nominal = PRINTED | {"contact": PRINTED["contact"] | {"hole_clearance_mm": -0.2}}
    assert "nominal" not in (await api.answer(PATH, nominal))["quantities"]["backlash_max_arcmin"]


async def test_what_does_most_to_the_fit(api):
    answer = await api.answer(PATH, PRINTED | {"include": ["contributions"], "samples": 200})
    ranked = answer["fit_contributions"]
    assert ranked[0]["source"] == "hole_position_mm"
    assert ranked[0]["fits_without"]["value"] > 0.95
    assert "contributions" not in answer["quantities"]["backlash_max_arcmin"]


async def test_percentiles_are_those_of_the_pieces(api):
    """By hand: the pieces of one request one by one, and their order."""
    body = changed(samples=9, percentiles=[50])
    found = (await api.answer(PATH, body))["quantities"]["peak_force_N"]
    means = [0.0]
    for samples in range(1, 10):
        one = await api.answer(PATH, body | {"samples": samples, "percentiles": []})
        means.append(one["quantities"]["peak_force_N"]["mean"] * samples)
    pieces = sorted(after - before for before, after in pairwise(means))
    order = [found["percentiles"][0][name] for name in ("low", "value", "high")]
    assert order == pytest.approx([pieces[1], pieces[4], pieces[7]], rel=EXACT)
    kept = sum(force <= 3200 for force in pieces)
    assert found["yield"]["value"] == pytest.approx(kept / 9)


async def test_only_what_is_asked_is_sent(api):
    answer = await api.answer(PATH, changed(limits={}))
    assert set(answer["quantities"]) == {"peak_force_N"}
    own = {"nominal", "mean", "percentiles", "angle_grid_error"}
    assert set(answer["quantities"]["peak_force_N"]) == own
    assert "warnings" not in answer
    body = changed(limits={"backlash_max_arcmin": 5}, include=["histogram"])
    answer = await api.answer(PATH, body)
    force, backlash = answer["quantities"].values()
    assert set(force) == own | {"histogram"} and set(backlash) == own | {
        "histogram",
        "yield",
        "yield_of_fitting",
    }
    assert sum(force["histogram"]["counts"]) == 30
    assert len(force["histogram"]["edges"]) == len(force["histogram"]["counts"]) + 1


async def test_every_quantity_of_exact_parts_is_that_of_load_sharing(api):
    """At the positions that the study takes, which are those of the wave."""
    names = [
        "peak_force_N", "max_pressure_MPa", "transmission_error_arcmin", "backlash_max_arcmin",
        "lost_motion_arcmin", "stiffness_min_Nm_per_arcmin",
    ]  # fmt: skip
    steel = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3}
    contact = CHECKED["contact"] | {"pin_material": steel, "hole_material": steel}
    body = changed({}, contact=contact, quantities=names, crank_angles=360, samples=6)
    found = (await api.answer(PATH, body))["quantities"]
    design = {name: body[name] for name in ("mechanism", "load", "contact", "contact_law")}
    turn = await api.post("load-sharing", json=design | {"include": ["over_turn"]})
    for name in names:
        quantity, real = found[name], turn.json()["over_turn"][name]
        room = {"stiffness_min_Nm_per_arcmin": 0.01}.get(name, 1e-4)
        assert quantity["nominal"] == pytest.approx(real, rel=room), name
        assert quantity["percentiles"][0]["value"] == quantity["nominal"]
        assert quantity["angle_grid_error"] < room
    highest = turn.json()["over_turn"]["peak_force_N"]
    assert found["peak_force_N"]["nominal"] <= highest * (1 + 1e-12)


@pytest.mark.parametrize(
    "giving",
    [
        {"crank_support": {"stiffness_N_per_mm": 2e5, "radial_clearance_mm": 0.02}},
        {"satellite_coupling": {"kind": "elastic", "stiffness_Nm_per_arcmin": 30.0}},
        {"satellite_coupling": {"kind": "shares", "shares": [0.55, 0.45]}},
    ],
)
async def test_satellites_that_give_do_so_in_the_study_too(api, giving):
    """The piece at the middle of all limits, at positions of the wave."""
    names = ["peak_force_N", "backlash_max_arcmin", "lost_motion_arcmin"]
    names += ["stiffness_min_Nm_per_arcmin"]
    shown = {"disc_phase_deg": {"lower_deg": 0.009, "upper_deg": 0.011, "common": True}}
    body = changed(shown, quantities=names, crank_angles=60, samples=6, **giving)
    answer = await api.answer(PATH, body)
    found = answer["quantities"]
    design = {name: body[name] for name in ("mechanism", "load", "contact", "contact_law", *giving)}
    design["include"] = ["over_turn"]
    design["deviations"] = {"disc_phase_deg": [0.01, 0.01]}
    turn = (await api.post("load-sharing", json=design)).json()["over_turn"]
    for name in names:
        assert found[name]["nominal"] == pytest.approx(turn[name], rel=0.03), name
    without = {name: each for name, each in body.items() if name not in giving}
    rigid = (await api.answer(PATH, without))["quantities"]
    shared = "shares" in str(giving)
    moved = "peak_force_N" if shared else "stiffness_min_Nm_per_arcmin"
    ratio = found[moved]["nominal"] / rigid[moved]["nominal"]
    assert ratio > 1.05 if shared else ratio < 0.95


async def test_a_torque_that_alternates_has_the_worse_of_both_directions(api):
    names = ["peak_force_N", "stiffness_min_Nm_per_arcmin"]
    found = {}
    for way in ("driving", "reverse", "alternating"):
        load = CHECKED["load"] | {"torque_direction": way}
        found[way] = (await api.answer(PATH, changed(load=load, quantities=names)))["quantities"]
    force, stiffness = (
        {way: each[name]["nominal"] for way, each in found.items()} for name in names
    )
    assert force["alternating"] == max(force["driving"], force["reverse"])
    assert stiffness["alternating"] == min(stiffness["driving"], stiffness["reverse"])
    mean = {way: each["peak_force_N"]["mean"] for way, each in found.items()}
    assert mean["alternating"] > max(mean["driving"], mean["reverse"])


async def test_the_stated_error_is_that_of_sample_and_grid(api):
    answer = await api.answer(PATH, changed())
    accuracy, force = answer["accuracy"], answer["quantities"]["peak_force_N"]
    (middle,) = force["percentiles"]
    half = (middle["high"] - middle["low"]) / 2 / middle["value"]
    assert accuracy["sampling_error"] == pytest.approx(half)
    assert accuracy["angle_grid_error"] == force["angle_grid_error"] > 0
    assert accuracy["relative_error"] == pytest.approx(half + force["angle_grid_error"])
    finer = await api.answer(PATH, changed(crank_angles=96))
    assert finer["accuracy"]["angle_grid_error"] < accuracy["angle_grid_error"]
    more = await api.answer(PATH, changed(samples=300))
    assert more["accuracy"]["sampling_error"] < half / 2


async def test_contributions_are_ranked(api):
    body = changed(
        {"pin_position_mm": 0.001, "hole_position_mm": 0.02}, include=["contributions"], samples=60
    )
    ranked = (await api.answer(PATH, body))["quantities"]["peak_force_N"]["contributions"]
    assert [each["source"] for each in ranked] == ["hole_position_mm", "pin_position_mm"]
    assert ranked[0]["total"] > 0.9 > 0.1 > ranked[1]["total"]
    without = [each["percentile_without"] for each in ranked]
    assert without[0]["percent"] == 50 and without[0]["value"] < without[1]["value"]


async def test_classes_and_limits_of_the_same_width_are_the_same(api):
    by_class = await api.answer(PATH, changed())
    tolerances = CHECKED["tolerances"] | {
        "pin_diameter": {"lower_mm": 0.006, "upper_mm": 0.015},
        "hole_diameter": {"lower_mm": 0, "upper_mm": 0.018},
        "eccentricity_mm": {"lower_mm": -0.005, "upper_mm": 0.005, "distribution": "normal"},
        "disc_phase_deg": {"lower_deg": -0.01, "upper_deg": 0.01, "common": False},
    }
    by_limits = await api.answer(PATH, changed(tolerances))
    found = [each["quantities"]["peak_force_N"]["mean"] for each in (by_class, by_limits)]
    assert found[0] == pytest.approx(found[1], rel=SAME)
    tolerances["pin_diameter"] |= {"distribution": "uniform", "common": True}
    other = await api.answer(PATH, changed(tolerances))
    assert other["quantities"]["peak_force_N"]["mean"] != pytest.approx(found[0], rel=SEARCHED)


async def test_a_diameter_beyond_the_table_is_refused(api):
    body = changed({"pin_diameter": {"class": "m6"}})
    body["load"] |= {"pin_circle_radius_mm": 4000}
    body["contact"] |= {"pin_radius_mm": 251}
    assert await api.refusal(PATH, body) == ("/tolerances/pin_diameter/class", "no_class_of_size")


async def test_a_percentile_that_the_sample_does_not_give_is_refused(api):
    response = await api.post(PATH, json=changed(percentiles=[50, 95]))
    (error,) = response.json()["errors"]
    assert (error["pointer"], error["code"]) == ("/percentiles/1", "too_few")
    assert error["params"] == {"limit": 72} and "72" in error["detail"]
    enough = await api.post(PATH, json=changed(percentiles=[50, 95], samples=72))
    assert enough.status_code == 200


async def test_a_design_that_cannot_work_is_refused(api):
    body = changed()
    body["contact_law"] |= {"stiffness_N_per_mm": 1}
    assert await api.refusal(PATH, body) == ("", "not_stable")


@pytest.mark.parametrize("quantity", ["backlash_max_arcmin", "peak_force_N"])
async def test_one_pin_swings_to_the_other_side_of_its_hole(api, quantity):
    """Beyond its dead centre; in first order there would be no end of the play."""
    just = {"hole_diameter": {"lower_mm": 0.0, "upper_mm": 0.0}}
    body = changed(just, quantities=[quantity], crank_angles=360, limits={})
    body["mechanism"] |= {"pins": 1, "satellites": 1}
    found = (await api.answer(PATH, body))["quantities"][quantity]["nominal"]
    design = {name: body[name] for name in ("mechanism", "load", "contact", "contact_law")}
    turn = await api.post("load-sharing", json=design | {"include": ["over_turn"]})
    assert found == pytest.approx(turn.json()["over_turn"][quantity], rel=1e-3)


def refusal(body, seconds):
    read = ToleranceStudyRequest.model_validate(body)
    with pytest.raises(InvalidInput) as caught:
        read.refuse_beyond(Settings(max_seconds=seconds))
    return caught.value.parameter, caught.value.code, caught.value.params


def test_work_is_bounded_by_samples_pairs_and_positions():
    budget = POSITIONS_PER_SECOND * 10
    body = CHECKED | {"samples": 100_000, "percentiles": [50]}
    most = budget // (12 * 60)
    assert refusal(body, 10) == ("samples", "service_limit", {"limit": most})
    ToleranceStudyRequest.model_validate(body | {"samples": most}).refuse_beyond(Settings())
    ToleranceStudyRequest.model_validate(body).refuse_beyond(Settings(max_seconds=3000))
    lost = body | {"quantities": ["lost_motion_arcmin"], "limits": {}}
    assert refusal(lost, 10)[2] == {"limit": most // 3}
    backlash = body | {"quantities": ["backlash_max_arcmin"], "limits": {}}
    assert refusal(backlash, 10)[2] == {"limit": int(budget / (12 * 60 * BACKLASH_SOLVES))}
    ranked = body | {"include": ["contributions"]}
    assert refusal(ranked, 10)[2] == {"limit": budget // (12 * 60 * 15)}
    many = body | {"mechanism": {"pins": 4000, "ratio": 20}, "samples": 1, "percentiles": []}
    limit = {"limit": budget // (60 * 20 * 2), "satellites": 2}
    assert refusal(many, 10) == ("pins", "too_many_pairs", limit)
    fits = body | {"mechanism": {"pins": limit["limit"], "ratio": 20}}
    fits |= {"samples": 20, "percentiles": []}
    ToleranceStudyRequest.model_validate(fits).refuse_beyond(Settings())


def test_the_usual_study_is_answered():
    """4,096 samples at 60 angles."""
    body = {name: value for name, value in CHECKED.items() if name != "limits"}
    usual = ToleranceStudyRequest.model_validate(body)
    assert (usual.drawn, usual.crank_angles) == (4096, 60)
    usual.refuse_beyond(Settings())


@pytest.mark.parametrize(
    ("pins", "seconds", "samples"), [(6, 60, 1024), (6, 10, 462), (32, 60, 520), (50, 10, 55)]
)
def test_samples_that_are_not_given_are_as_many_as_fit(pins, seconds, samples):
    """With contributions of six tolerances fifteen times the pieces of one quantity."""
    body = CHECKED | {"include": ["contributions"], "percentiles": [50], "limits": {}}
    body["mechanism"] = CHECKED["mechanism"] | {"pins": pins}
    study = ToleranceStudyRequest.model_validate(body)
    study.refuse_beyond(Settings(max_seconds=seconds))
    assert study.drawn == samples
    assert samples in (1024, 500_000 * seconds // (15 * 2 * pins * 60))


async def test_the_answer_says_how_many_samples_were_drawn(api):
    body = changed(include=["contributions"], percentiles=[50])
    del body["samples"]
    answer = await api.answer(PATH, body)
    assert answer["samples"] == 1024
    assert len(answer["quantities"]["peak_force_N"]["contributions"]) == 6


def test_the_percentile_is_judged_by_its_own_number():
    for samples, percent in ((71, 95), (367, 99)):
        body = CHECKED | {"samples": samples, "percentiles": [percent], "crank_angles": 12}
        with pytest.raises(Problem):
            ToleranceStudyRequest.model_validate(body).refuse_beyond(Settings(max_seconds=100))
        body["samples"] += 1
        ToleranceStudyRequest.model_validate(body).refuse_beyond(Settings(max_seconds=100))
        percentile(values=range(samples + 1), percent=percent)


def test_a_study_is_read_and_refused_without_going_through_its_samples():
    settings, percentiles = Settings(max_seconds=1e4), [50.0 + each for each in range(20)]

    def taken(asked: list[float], samples: int) -> int:
        content = json.dumps(CHECKED | {"samples": samples, "percentiles": asked}).encode()

        def read() -> None:
            with suppress(Problem):
                read_body(CALCULATIONS[PATH], content, settings)

        read()
        return steps(read)

    for asked in (percentiles, [*percentiles[1:], 99.999]):
        assert abs(taken(asked, 138_000) - taken(asked, 300)) < 100


def test_deviations_are_drawn_and_those_of_the_document_are_not_used():
    body = ToleranceStudyRequest.model_validate(CHECKED | {"deviations": {}})
    assert body.not_used == ["deviations"] and body.design.deviations is None
    assert not CALCULATIONS[PATH].batched


@pytest.mark.parametrize("include", [[], ["histogram"], ["contributions"]])
async def test_the_figure_shows_the_answer(api, include):
    body = changed(include=include)
    figure = (await api.post(f"{PATH}/chart", json=body)).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    named = ["contributions" if include == ["contributions"] else "histogram"]
    force = (await api.answer(PATH, body | {"include": named}))["quantities"]["peak_force_N"]
    if include == ["contributions"]:
        for trace, field in zip(figure["data"], ("total", "first"), strict=True):
            assert trace["x"] == [each[field] for each in force["contributions"]]
        return
    (bars,) = figure["data"]
    assert bars["y"] == force["histogram"]["counts"]
    lines = [shape["x0"] for shape in figure["layout"]["shapes"]]
    assert lines == [force["nominal"], force["percentiles"][0]["value"], 3200]


async def test_the_same_body_gives_the_same_numbers(api):
    answers = [await api.answer(PATH, REQUESTS[PATH] | FEW) for _ in range(2)]
    for answer in answers:
        del answer["accuracy"]["run_time_us"]
    assert answers[0] == answers[1]
    other = await api.answer(PATH, REQUESTS[PATH] | FEW | {"seed": 1})
    assert other["quantities"] != answers[0]["quantities"]


async def test_classes_of_a_size(api):
    answer = (await api.get("tolerances?size_mm=14.04&class=H7")).json()
    assert answer["tolerances"] == [{"class": "H7", "lower_mm": 0, "upper_mm": 0.018}]
    every = (await api.get("tolerances?size_mm=10")).json()["tolerances"]
    assert len(every) == 63 and math.isclose(every[0]["lower_mm"], -0.019)
    assert {"class": "m6", "lower_mm": 0.006, "upper_mm": 0.015} in every


@pytest.mark.parametrize(
    ("query", "pointer", "code"),
    [
        ("", "size_mm", "missing"),
        ("size_mm=x", "size_mm", "float_type"),
        ("size_mm=nan", "size_mm", "finite_number"),
        ("size_mm=0", "size_mm", "greater_than_equal"),
        ("size_mm=5e-324", "size_mm", "greater_than_equal"),
        ("size_mm=500.1", "size_mm", "less_than_equal"),
        ("size_mm=10&class=k6", "class", "literal_error"),
    ],
)
async def test_what_the_table_has_not_is_refused(api, query, pointer, code):
    answer = await api.get(f"tolerances?{query}")
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    (error,) = answer.json()["errors"]
    assert (error["pointer"], error["code"]) == (f"/query/{pointer}", code)


async def test_a_tolerance_of_0_says_exact(api):
    """Pieces are those of a tolerance that is not named; it was refused."""
    exact = {"hole_position_mm": 0, "eccentricity_mm": 0, "disc_phase_deg": 0}
    plain, said = [
        await api.answer(PATH, changed({"pin_position_mm": 0.02} | each)) for each in ({}, exact)
    ]
    assert said["quantities"] == plain["quantities"]
    assert said["quantities"]["peak_force_N"]["mean"] > 2400  # 2333 N of perfect parts
