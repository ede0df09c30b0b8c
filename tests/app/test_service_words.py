"""The page's English words of what the service says: all codes, ids and names, kept true."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from app import theme
from app.examples import EXAMPLES, REQUESTS
from app.main import create_app
from app.model import NEGLECTED
from app.problems import TEXTS
from app.registry import CALCULATIONS
from app.units import api_value
from core.checks.kinds import CHECK_SOURCES, CHECKS, NOT_CONSIDERED, REASONS
from core.checks.kinds import GROUPS as CHECK_GROUPS
from core.errors import PLACES
from core.materials import GROUPS, LIMIT_SOURCES, MATERIALS
from core.results import METHODS, NOTICES
from core.work_precision.study import SETTINGS

pytestmark = pytest.mark.anyio

FILE = Path(__file__).parents[2] / "static" / "messages" / "service.js"
HEAD = "// Written by tests/app/test_service_words.py: what the service says in English, by code.\n"


def plain(texts: dict[str, str]) -> dict[str, str]:
    """Texts whose places are named only, without a format or the unit that the page adds."""
    return {
        code: re.sub(r"(_mm)?:[^{}]*}(?(1)( mm)?)", r"\1}", text) for code, text in texts.items()
    }


def fields() -> dict[str, list[str]]:
    """Title and help of every field of a form, by its name, or by group and name where the groups
    differ.
    """
    words: dict[str, dict[str, list[str]]] = {}
    schemas: dict[str, Any] = create_app().openapi()["components"]["schemas"]
    for schema in schemas.values():
        for name, field in schema.get("properties", {}).items():
            if group := field.get("x-group"):
                own = [field["title"], field.get("description", "")]
                assert words.setdefault(name, {}).setdefault(group, own) == own, (group, name)
    named = {}
    for name, groups in words.items():
        first, *others = groups.values()
        if all(other == first for other in others):
            named[name] = first
        else:
            named |= {f"{group}.{name}": own for group, own in groups.items()}
    return dict(sorted(named.items()))


def service_words() -> dict[str, Any]:
    """All that the service says, by kind and code."""
    return {
        "refusals": plain(TEXTS),
        "places": {api_value(name, 0.0)[0]: text for name, text in PLACES.items()},
        "notices": plain(NOTICES),
        "neglected": NEGLECTED,
        "figures": plain(theme.TEXTS),
        "methods": METHODS,
        "settings": plain(SETTINGS),
        "fields": fields(),
        "materials": {name: each.title for name, each in MATERIALS.items()},
        "materialGroups": GROUPS,
        "criteria": {
            "endurance": "endurance",
            "endurance_mean": "endurance, mean pressure",
            "static": "static",
            "given": "given",
        },
        "verified": {"standard": "read in the standard", "secondary": "two secondary sources"},
        "checks": {code: [each.title, each.why] for code, each in CHECKS.items()},
        "checkGroups": CHECK_GROUPS,
        "checkReasons": REASONS,
        "checkSources": CHECK_SOURCES,
        "notConsidered": NOT_CONSIDERED,
        "limitSources": LIMIT_SOURCES,
        "examples": {each["id"]: each["title"] for each in EXAMPLES},
        "calculations": {name: each.title for name, each in CALCULATIONS.items()},
    }


def text() -> str:
    """The file as it should be."""
    return f"{HEAD}export default {json.dumps(service_words(), ensure_ascii=False, indent=2)};\n"


def test_the_page_has_the_words_of_the_service():
    """Where this fails, ``python -m tests.app.test_service_words`` writes the file anew."""
    assert FILE.read_text(encoding="utf-8") == text()


@pytest.mark.parametrize("path", [name for name, each in CALCULATIONS.items() if each.figure])
async def test_every_word_of_a_figure_has_an_id(api, path):
    """What the texts of a figure name has no words beside them; the ids and their places agree."""
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


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
