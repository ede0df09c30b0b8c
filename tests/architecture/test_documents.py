"""The documents speak of what is there: names, files, version, licence."""

import re
import tomllib
from pathlib import Path

import pytest

from app import VERSION
from app.settings import Settings

ROOT = Path(__file__).parent.parent.parent
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
SOURCE = "\n".join(path.read_text() for path in sorted(ROOT.glob("core/**/*.py")))


def test_names_of_the_nomenclature_are_those_of_the_core():
    rows = [line.split(" | ") for line in (ROOT / "docs/nomenclature.md").read_text().splitlines()]
    names = {name for row in rows if len(row) > 3 for name in re.findall(r"`(\w+)`", row[1])}
    assert len(names) > 50
    assert {name for name in names if not re.search(rf"\b{name}\b", SOURCE)} == set()


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_lead_somewhere(document):
    for link in re.findall(r"\]\(([^)\s]+)\)", document.read_text()):
        if "://" in link:
            continue
        file, _, heading = link.partition("#")
        target = document.parent / file if file else document
        assert target.exists(), link
        anchors = {
            re.sub(r"[^\w -]", "", line.lstrip("# ").lower()).replace(" ", "-")
            for line in target.read_text().splitlines()
            if line.startswith("#")
        }
        assert not heading or heading in anchors, link


def test_the_citation_has_the_version_and_the_licence():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    citation = (ROOT / "CITATION.cff").read_text()
    assert re.findall(r"^version: (.*)$", citation, re.MULTILINE) == [VERSION]
    assert re.findall(r"^license: (.*)$", citation, re.MULTILINE) == [project["license"]]
    assert all((ROOT / name).exists() for name in project["license-files"])


def test_every_decision_is_short_complete_and_listed():
    index = (ROOT / "docs/decisions/README.md").read_text()
    records = sorted((ROOT / "docs/decisions").glob("[0-9]*.md"))
    assert records
    for record in records:
        text = record.read_text()
        title = text.splitlines()[0].removeprefix("# ")
        assert len(text.splitlines()) < 25, record.name
        assert f"[{record.name[:2]} {title}]({record.name})" in index
        assert re.findall(r"^\*\*(\w+)\.\*\*", text, re.MULTILINE) == [
            "Context",
            "Decision",
            "Consequence",
        ]


def test_every_setting_is_in_the_table_of_operation():
    text = (ROOT / "docs/operation.md").read_text()
    rows = re.findall(r"^\| `KHV_(\w+)` \| (.*) \| `?([^|`]*?)`? \|$", text, re.MULTILINE)
    assert rows == [
        (name.upper(), field.description, _shown(field.default))
        for name, field in Settings.model_fields.items()
    ]


def _shown(default):
    if isinstance(default, tuple):
        default = ", ".join(default)
    return (f"{default:.9g}" if isinstance(default, int | float) else default) or "none"
