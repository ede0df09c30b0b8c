"""Every code of the service has words, for the page and for other languages."""

import json
import re
from itertools import chain
from typing import Any, get_args

import pytest

from app import theme
from app.examples import REQUESTS
from app.registry import CALCULATIONS
from app.words import Language
from core.errors import METHODS
from core.work_precision.study import SETTINGS

pytestmark = pytest.mark.anyio

CODES = {
    ("CheckOut", "code"): "checks",
    ("CheckOut", "group"): "check_groups",
    ("AccuracyOut", "method_code"): "methods",
    ("LimitOut", "criterion"): "criteria",
    ("LimitOut", "verified"): "verified",
}
"""Fields of the description that list their codes, and the table of the words of these."""

SAID = ("refusals", "notices", "reasons", "checks")
"""Tables of words whose codes are one space."""


def leaves(words: dict[str, Any]):
    """All texts."""
    for each in words.values():
        if isinstance(each, dict):
            yield from leaves(each)
        else:
            yield each


async def test_every_code_of_the_description_has_words_and_no_other(api):
    words = (await api.get("words")).json()
    schemas = (await api.get("openapi.json")).json()["components"]["schemas"]
    for (schema, field), table in CODES.items():
        assert sorted(schemas[schema]["properties"][field]["enum"]) == sorted(words[table]), table
    listed = {
        name: {*schemas[name]["properties"]["code"]["enum"]}
        for name in ("FieldProblem", "WarningOut", "ReasonOut", "CheckOut")
    }
    every = [code for table in SAID for code in words[table]]
    assert len(every) == len({*every}) and {*every} == {*chain(*listed.values())}
    warned = {code for code, each in words["checks"].items() if "warning" in each}
    refused = {code for code, each in words["checks"].items() if "refusal" in each}
    assert listed["WarningOut"] == {*words["notices"]} | warned
    assert listed["FieldProblem"] == {*words["refusals"]} | refused
    assert {*words["reasons"]} | listed["WarningOut"] <= listed["ReasonOut"]
    assert all(len(text) > 1 for text in leaves(words))


@pytest.mark.parametrize("language", get_args(Language))
async def test_what_a_text_names_is_a_name_only(api, language):
    """A format or a unit is that of whoever shows it."""
    for text in leaves((await api.get(f"words?language={language}")).json()):
        assert re.fullmatch(r"([^{}]|{[a-z_]\w*})*", text), text
        assert not re.search(r"{\w+_mm} mm", text), text


async def test_words_are_those_of_the_answers(api):
    body = REQUESTS["crank-planetary"] | {"include": ["hertz", "checks"]}
    words = (await api.get("words")).json()
    judged = (await api.post("crank-planetary", json=body)).json()
    assert judged["checks"]
    for check in judged["checks"]:
        own = words["checks"][check["code"]]
        assert (check["title"], check["why"]) == (own["title"], own["why"])
        assert check["source"] == words["sources"][check["source_code"]]
        if reason := check.get("reason"):
            assert reason["detail"] == words["reasons"].get(reason["code"], reason["detail"])
    assert {*judged["not_considered"]} <= {*words["not_considered"]}


@pytest.mark.parametrize("path", [name for name, each in CALCULATIONS.items() if each.figure])
async def test_every_word_of_a_figure_has_an_id(api, path):
    """Named texts of a figure have no other words; ids and their places agree."""
    figure = (await api.post(f"{path}/chart", json=REQUESTS[path])).json()
    worded = set()
    for place, code, params in figure["layout"]["meta"]["words"]:
        part = figure
        for key in place:
            part = part[key]
        worded.add(json.dumps(place))
        table, _, name = code.rpartition(".")
        texts = {"": theme.TEXTS, "methods": METHODS, "settings": SETTINGS}[table]
        assert isinstance(part, str) and set(re.findall(r"{(\w+)", texts[name])) <= set(params)
    for place, words in texts_of(figure):
        if re.search(r"[A-Za-z]{3}", re.sub(r"<[^>]*>|%{[^}]*}", "", words)):
            assert json.dumps(place) in worded, words


def test_no_two_ids_say_the_same():
    """`theme.text` keeps what it has made by what it was given, texts by their letters."""
    for texts in (theme.TEXTS, METHODS, SETTINGS):
        assert len(set(texts.values())) == len(texts)
    assert not set(theme.TEXTS.values()) & set(METHODS.values())


def texts_of(figure: dict[str, Any]):
    """Texts of a figure that people read, with their places."""
    for index, trace in enumerate(figure["data"]):
        for key in ("name", "hovertemplate"):
            if key in trace:
                yield ["data", index, key], trace[key]
    for key, part in figure["layout"].items():
        if "axis" in key:
            yield ["layout", key, "title", "text"], part["title"]["text"]
    for index, shape in enumerate(figure["layout"].get("shapes", ())):
        if "name" in shape:
            yield ["layout", "shapes", index, "name"], shape["name"]
    for index, note in enumerate(figure["layout"].get("annotations", ())):
        yield ["layout", "annotations", index, "text"], note["text"]
