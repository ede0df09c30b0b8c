"""Error against run time over REST."""

import json
import math
from pathlib import Path

import plotly.graph_objects as go
import pytest

from app.calculations.tolerance_study import ToleranceStudyRequest
from app.calculations.work_precision import COMPARED, ONE_METHOD, ToleranceSamplingStudy
from app.examples import REQUESTS
from app.registry import CALCULATIONS
from app.settings import Settings
from core.errors import InvalidInput
from core.precision import CLASSES, EXACT, JUDGED, SEARCHED
from tests.inputs.bodies import changed
from tests.inputs.papers import GEAR, SHAFT

pytestmark = pytest.mark.anyio

MECHANISM = {"pins": 3, "ratio": 20, "crank_spacing_deg": 90}
STUDIES = {
    "peak_force": {**MECHANISM, "output_torque_Nm": 500, "pin_circle_radius_mm": 50},
    "contact_line_length": GEAR,
    "shaft_deflection": SHAFT,
}


@pytest.mark.parametrize("calculation", STUDIES)
async def test_a_study_compares_methods_and_marks_an_accurate_default(api, calculation):
    body = {"calculation": calculation, "input": STUDIES[calculation]}
    answer = (await api.post("work-precision", json=body)).json()
    assert answer["reference"]["digits"] == 40
    assert answer["chosen"] in answer["points"]
    assert answer["chosen"]["relative_error"] < 1e-14
    assert all(point["run_time_us"] > 0 for point in answer["points"])
    assert len({point["method"] for point in answer["points"]}) >= 3
    assert max(point["relative_error"] for point in answer["points"]) > 1e-6
    finest = {point["method"]: point for point in answer["points"] if point["evaluations"] > 1}
    assert all(point["relative_error"] < SEARCHED for point in finest.values())


async def test_more_samples_are_better_and_dearer(api):
    body = {"calculation": "peak_force", "input": STUDIES["peak_force"]}
    points = (await api.post("work-precision", json=body)).json()["points"]
    sampling = [point for point in points if point["method"] == "sampling"]
    assert [p["evaluations"] for p in sampling] == [16, 64, 256, 1024, 4096]
    errors = [point["relative_error"] for point in sampling]
    assert (
        errors == pytest.approx(sorted(errors, reverse=True), rel=EXACT)
        and errors[0] > 1e4 * errors[-1]
    )


MADE_OF_OTHERS = {"crank-planetary", "propose", "sensitivity", "solve", "sweep", "work-precision"}


@pytest.mark.parametrize("calculation", sorted(CALCULATIONS.keys() - MADE_OF_OTHERS))
async def test_what_has_one_method_is_refused_with_what_that_promises(api, calculation):
    """The service names the compared calculations, for any input."""
    listed = (await api.get("calculations")).json()["calculations"]
    (said,) = (each["compared"] for each in listed if each["name"] == calculation)
    body = {"calculation": calculation, "input": {}}
    (first, *_) = (await api.post("work-precision", json=body)).json()["errors"]
    assert said == (first["code"] != "no_methods")
    if not said:
        answer = (await api.post(calculation, json=REQUESTS[calculation])).json()
        promised = CLASSES[answer["accuracy"]["method_code"]]
        assert (first["pointer"], first["params"]) == (
            "/calculation", {"relative_error": promised},
        )  # fmt: skip
        drawn = await api.post("work-precision/chart", json=body | {"quantity": "slope"})
        assert [each["code"] for each in drawn.json()["errors"]] == ["no_methods"]


def test_names_are_those_of_the_calculations_and_their_older_ones():
    compared = {name for name, *_ in COMPARED}
    assert compared | MADE_OF_OTHERS == CALCULATIONS.keys() - ONE_METHOD.keys()
    assert ONE_METHOD.keys() - CALCULATIONS.keys() == {"meshing_load", "roller_sharing"}


async def test_the_description_names_what_is_compared_alone(api):
    schemas = (await api.get("openapi.json")).json()
    body = schemas["paths"]["/api/v1/work-precision"]["post"]["requestBody"]
    mapping = body["content"]["application/json"]["schema"]["discriminator"]["mapping"]
    assert {*mapping} == {name for names in COMPARED for name in names}


async def test_the_papers_approximation_has_its_known_error(api):
    body = {
        "calculation": "peak_force",
        "input": {**STUDIES["peak_force"], "satellites": 1, "crank_spacing_deg": 0},
    }
    points = (await api.post("work-precision", json=body)).json()["points"]
    approximation = next(p for p in points if p["method"].startswith("approximation"))
    # 1.4*0.95/1.2492: the theory's +1.40 % for three pins and one satellite
    assert approximation["relative_error"] == pytest.approx(1.2666667 / 1.2492332 - 1, rel=JUDGED)


async def test_simpson_converges_with_the_fourth_power(api):
    body = {"calculation": "contact_line_length", "input": GEAR}
    points = (await api.post("work-precision", json=body)).json()["points"]
    simpson = [p["relative_error"] for p in points if p["method"] == "Simpson in phi"]
    rate = math.log(simpson[0] / simpson[1]) / math.log(4)
    assert rate == pytest.approx(4, abs=0.3)


RING = changed(REQUESTS["ring-mesh"], mechanism={"satellites": 1}, deviations=None) | {
    "deviations": {"ring_pin_radial_mm": [0.005] + 19 * [0.0]}
}
BOTH = json.loads((Path(__file__).parents[1] / "oracles/series_cases.json").read_text())[1]["body"]
STAGES = {
    "output pins": ("load-sharing", REQUESTS["load-sharing"], 20),
    "ring alone": ("ring-mesh", RING, 20),
    "both meshes": ("load-sharing", changed(BOTH, geometry=None), 5),
}
"""Designs, with how many times as far off the fewest samples are as the most."""


@pytest.mark.parametrize("stage", STAGES)
async def test_samples_miss_the_real_peak_downwards_and_narrowed_summits_do_not(api, stage):
    calculation, design, times = STAGES[stage]
    body = {"calculation": calculation, "input": design}
    answer = (await api.post("work-precision", json=body)).json()
    assert answer["reference"]["digits"] == 12
    assert answer["chosen"] in answer["points"]
    sampling = [point for point in answer["points"] if point["method"] == "sampling"]
    errors = [point["relative_error"] for point in sampling]
    assert errors[0] > times * errors[-1] > 0
    assert answer["chosen"]["relative_error"] < min(1e-6, errors[-1])
    if stage == "output pins":
        assert [point["evaluations"] for point in sampling] == [24, 60, 120, 360, 720, 1440]
        assert errors == pytest.approx(sorted(errors, reverse=True), rel=EXACT)
        assert answer["chosen"]["relative_error"] < 1e-9


@pytest.mark.parametrize(
    ("stage", "changes", "pointer"),
    [
        ("output pins", {"mechanism": {"pins": 61}, "deviations": None}, "/input/mechanism/pins"),
        ("ring alone", {"mechanism": {"satellites": 7}}, "/input/mechanism/ring_teeth"),
        (
            "both meshes",
            {"mechanism": {"satellites": 5}, "deviations": None},
            "/input/mechanism/ring_teeth",
        ),
    ],
)
async def test_a_study_of_the_real_peak_has_a_limit(api, stage, changes, pointer):
    calculation, design, _ = STAGES[stage]
    body = {"calculation": calculation, "input": changed(design, **changes)}
    error = (await api.post("work-precision", json=body)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == (pointer, "too_many_pairs")


PIECES = {**REQUESTS["tolerance-study"], "crank_angles": 12, "percentiles": [50], "limits": {}}


async def test_more_pieces_scatter_less_and_more_positions_miss_less(api):
    own = {**PIECES, "samples": 160}
    answer = (
        await api.post("work-precision", json={"calculation": "tolerance-study", "input": own})
    ).json()
    lines: dict[str, list[dict]] = {}
    for point in answer["points"]:
        lines.setdefault(point["method_code"], []).append(point)
    assert [*lines] == [f"monte_carlo{grid}" for grid in ("_quarter", "_double", "")]
    for line, positions in zip(lines.values(), (3, 24, 12), strict=True):
        assert [point["setting_value"] for point in line] == [10, 40, 160]
        assert [point["evaluations"] for point in line] == [
            pieces * positions for pieces in (10, 40, 160)
        ]
        errors = [point["relative_error"] for point in line]
        assert errors == sorted(errors, reverse=True)
    coarse, fine, asked = (line[-1]["relative_error"] for line in lines.values())
    assert coarse > 2 * asked and asked > fine
    assert answer["chosen"] == lines["monte_carlo"][-1]
    # the study's own interval says the same of the scatter, the grid's bias taken away
    study = (await api.post("tolerance-study", json=own)).json()["quantities"]["peak_force_N"]
    interval = study["percentiles"][0]
    said = (interval["high"] - interval["low"]) / (2 * 1.96) / interval["value"]
    first, last = (lines["monte_carlo"][i]["relative_error"] ** 2 for i in (0, -1))
    assert (first - last) ** 0.5 == pytest.approx(15**0.5 * said, rel=0.5)


async def test_too_few_pieces_are_refused_by_name(api):
    body = {"calculation": "tolerance-study", "input": {**PIECES, "samples": 20}}
    error = (await api.post("work-precision", json=body)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/input/samples", "too_few")
    assert error["params"]["limit"] > 20


def test_pieces_take_eight_times_as_long_as_their_own_study():
    own = {**PIECES, "samples": 1_000_000}
    requests = (
        ToleranceStudyRequest.model_validate(own),
        ToleranceSamplingStudy(calculation="tolerance-study", input=own),
    )
    limits = []
    for request in requests:
        with pytest.raises(InvalidInput, match="samples") as refused:
            request.refuse_beyond(Settings(max_seconds=10))
        limits.append(refused.value.params["limit"])
    assert limits[1] == limits[0] // 8


@pytest.mark.parametrize("calculation", ["peak_force", "shaft_deflection"])
async def test_the_diagram_is_a_figure(api, calculation):
    body = {"calculation": calculation, "input": STUDIES[calculation]}
    figure = (await api.post("work-precision/chart?theme=dark", json=body)).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    assert figure["data"][-1]["name"] == "Used by the calculator"
    assert {figure["layout"][axis]["type"] for axis in ("xaxis", "yaxis")} == {"log"}


@pytest.mark.parametrize(
    ("body", "field"),
    [
        (
            {"calculation": "peak_force", "input": {**STUDIES["peak_force"], "pins": 0}},
            "/input/pins",
        ),
        (
            {"calculation": "peak_force", "input": {**STUDIES["peak_force"], "pins": 200}},
            "/input/pins",
        ),
        ({"calculation": "colour", "input": {}}, "/calculation"),
        ({"calculation": "shaft_deflection", "input": GEAR}, "/input/torque_Nm"),
        (
            {
                "calculation": "load-sharing",
                "quantity": "carried_ends",
                "input": REQUESTS["load-sharing"],
            },
            "/quantity",
        ),
    ],
)
async def test_wrong_studies_are_refused(api, body, field):
    response = await api.post("work-precision", json=body)
    assert response.status_code == 422
    assert response.json()["errors"][0]["pointer"] == field
