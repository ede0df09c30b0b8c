"""The requests of the tutorials, asked as they stand there, give the numbers printed there."""

import ast
import io
import json
import re
import zipfile
from decimal import Decimal
from pathlib import Path

import pytest

DOCS = Path(__file__).parent.parent.parent / "docs"
TUTORIALS = {name: (DOCS / name).read_text() for name in ("tutorial.md", "tutorial_cycloid.md")}
BLOCK = re.compile(r"^( *)```(sh|json)\n(.*?)^\1```$", re.DOTALL | re.MULTILINE)
ASKED = re.compile(r"ask (\S+) '([^']*)'\n")

WARNED = re.compile(r'"warnings":\[\{"code":"(\w+)"')

BLOCKS = {
    name: [(language, text) for _, language, text in BLOCK.findall(tutorial)]
    for name, tutorial in TUTORIALS.items()
}
STEPS = [
    pytest.param(*asked.groups(), blocks[index + 1], id=f"{name}-{index}-{asked[1]}")
    for name, blocks in BLOCKS.items()
    for index, (language, text) in enumerate(blocks)
    if language == "sh" and (asked := ASKED.search(text))
]

OWN = {
    "tutorial.md": {
        "0.038",  # the radius in metres
        "0.16",  # where the service warns, rounded
        "0.018",  # the clearance of the fit, rounded
        "1.2",  # the safety of the pressure, where none is asked
        "0.85",  # Z_NT for 1e10 loads
    },
    "tutorial_cycloid.md": {
        "0.001",  # of the drawings
        "1158",  # with the narrower zone
        "0.002",  # of the measured ring
        "0.9",  # changes in per cent
        "0.4",
        "0.97",  # of the limit: 1066 over 819, times 881 over 1185
    },
}
"""Numbers of the text that stand in no block."""

EXPECTED = {
    "perfect_parts",
    "uneven_sharing",
    "modification_unknown",
    "seat_rigid",
    "guide_tolerances",
}
"""Warnings of these designs."""


STATED = {
    "propose": 0.02,  # the largest torque is searched to 1 %
    "tolerance-study": 0.1,
    "sweep": 1e-5,
    "sensitivity": 1e-5,
}
"""Relative errors that these calculations may state."""


def named(record, answer):
    """The check or fix of an answer that a printed record speaks of."""
    (one,) = (
        each
        for each in answer
        if each["code"] == record["code"] and each.get("pointer") == record.get("pointer")
    )
    return one


def compare(printed, answer, place=""):
    """Assert that the answer contains the printed values, numbers to their last printed digit."""
    if isinstance(printed, dict):
        for name, value in printed.items():
            assert name in answer, f"{place}/{name}"
            compare(value, answer[name], f"{place}/{name}")
    elif isinstance(printed, list):
        if any("code" in each for each in printed if isinstance(each, dict)):  # some of them only
            answer = [named(each, answer) for each in printed]
        assert len(printed) == len(answer), place
        for index, value in enumerate(printed):
            compare(value, answer[index], f"{place}/{index}")
    elif isinstance(printed, Decimal):
        last_digit = Decimal(1).scaleb(printed.as_tuple().exponent)
        assert abs(Decimal(answer) - printed) <= last_digit / 2, f"{place}: {answer}"
    else:
        assert printed == answer, place


def accuracies(answer):
    if isinstance(answer, dict):
        if "accuracy" in answer:
            yield answer["accuracy"]
        for value in answer.values():
            yield from accuracies(value)


def test_every_request_is_followed_by_its_answer():
    assert len(STEPS) == 8 + 6
    blocks = [language for each in BLOCKS.values() for language, _ in each]
    assert blocks.count("json") == len(STEPS)


@pytest.mark.anyio
@pytest.mark.parametrize(("path", "body", "following"), STEPS)
async def test_the_service_gives_the_printed_numbers(api, path, body, following):
    language, text = following
    assert language == "json"
    response = await api.post(path, json=json.loads(body))
    assert response.status_code == 200, response.text
    answer = response.json()
    compare(json.loads(text, parse_float=Decimal, parse_int=Decimal), answer)
    assert {*WARNED.findall(response.text)} <= EXPECTED
    solved = {"fit", "hole_clearance_mm"} & {*json.loads(body).get("contact", {})}
    worst = max((each["relative_error"] for each in accuracies(answer)), default=0.0)
    assert worst < STATED.get(path, 1e-3 if solved else 1e-12)


@pytest.mark.anyio
async def test_the_files_of_the_last_step_hold_what_it_says(api):
    """The design is that of the other steps, with the narrower zone."""
    tutorial = TUTORIALS["tutorial_cycloid.md"]
    step = tutorial[tutorial.index("## 7.") :]
    (whole,) = [json.loads(step.values[1]) for step in STEPS if step.values[0] == "tolerance-study"]
    design = {name: value for name, value in whole.items() if isinstance(value, dict)}
    drawn = await api.post("export/dxf", json={"design": design})
    with zipfile.ZipFile(io.BytesIO(drawn.content)) as files:
        assert files.namelist() == re.findall(r"`(\w+\.dxf)`", step)
    script = (await api.post("export/build123d", json={"design": design})).text
    (counted,) = re.findall(r"with (\d+) solids", step)
    places = re.findall(r", (\[\([^\[\]]*\)\])\),$", script, re.MULTILINE)
    assert sum(len(ast.literal_eval(each)) for each in places) == int(counted)
    asked = {"calculation": "crank-planetary", "input": design}
    for name in re.findall(r"^file (\w+) whole\.json", step, re.MULTILINE):
        assert (await api.post(f"export/{name}", json=asked)).status_code == 200, name


@pytest.mark.parametrize("name", TUTORIALS)
def test_numbers_in_the_text_are_those_of_the_blocks(name):
    prose = BLOCK.sub("", TUTORIALS[name])
    blocks = "".join(text for _, text in BLOCKS[name])
    shown = {Decimal(each) for each in re.findall(r"\d+\.\d+", blocks)}
    said = set(re.findall(r"\d+\.\d+", prose)) - OWN[name]
    assert {each for each in said if Decimal(each) not in shown} == set()


@pytest.mark.anyio
async def test_the_example_of_a_refusal_is_refused_with_its_place(api):
    body = {
        "pins": 2,
        "satellites": 1,
        "ratio": 20,
        "output_torque_Nm": 400,
        "pin_circle_radius_mm": 38,
    }
    refusal = await api.post("contact-force", json=body)
    assert refusal.status_code == 422
    assert "crank_angle_deg" in refusal.text
