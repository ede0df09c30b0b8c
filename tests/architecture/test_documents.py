"""The documents speak of what is there: names, files, version, licence, tolerances."""

import re
import tomllib
from pathlib import Path

import pytest

from app import VERSION
from app.about import API
from app.batch import SPELLINGS
from app.calculations.work_precision import COMPARED
from app.main import app
from app.registry import CALCULATIONS
from app.settings import Settings
from core.codes import WAS

ROOT = Path(__file__).parent.parent.parent
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
README = (ROOT / "README.md").read_text()
SOURCE = "\n".join(path.read_text() for path in sorted(ROOT.glob("core/**/*.py")))


@pytest.mark.slow
def test_names_of_the_glossary_are_those_of_the_core():
    rows = [line.split(" | ") for line in (ROOT / "docs/glossary.md").read_text().splitlines()]
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
        if not heading:
            continue
        anchors = {
            re.sub(r"[^\w -]", "", line.lstrip("# ").lower()).replace(" ", "-")
            for line in target.read_text().splitlines()
            if line.startswith("#")
        }
        assert heading in anchors, link


def test_the_citation_has_the_version_and_the_licence():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    citation = (ROOT / "CITATION.cff").read_text()
    assert re.findall(r"^version: (.*)$", citation, re.MULTILINE) == [VERSION]
    assert re.findall(r"^license: (.*)$", citation, re.MULTILINE) == [project["license"]]
    assert all((ROOT / name).exists() for name in project["license-files"])


def test_the_changelog_starts_with_the_version():
    versions = re.findall(r"^## ([\d.]+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert versions[0] == VERSION


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


def test_the_readme_lists_the_calculations_of_the_registry():
    rows = re.findall(r"^\| `([\w/-]+)` \| (.*?) \| .* \|$", README, re.MULTILINE)
    assert len(rows) == len(CALCULATIONS)
    assert dict(rows) == {name: each.title for name, each in CALCULATIONS.items()}


@pytest.mark.slow
def test_the_documents_of_the_api_name_every_path_and_kind_of_problem():
    text = (ROOT / "docs/api.md").read_text()
    named = {*re.findall(r"`(?:POST|GET) (/[\w/.-]*)`", text)}
    paths = {path.removeprefix(API) for path in app.openapi()["paths"]}
    calculations = {f"/{name}" for name in CALCULATIONS} | {f"/{n}/chart" for n in CALCULATIONS}
    assert paths - calculations <= named


def test_the_older_spellings_are_listed():
    text = (ROOT / "docs/api.md").read_text()
    of_batches = {(new, old) for old, new in SPELLINGS.items() if old != new}
    of_studies = {(new, old) for new, *spelt in COMPARED for old in spelt}
    listed = re.findall(r"^\| `([\w/-]+)` \| (.*) \|(.*) \|$", text, re.MULTILINE)
    for column, older in ((1, of_batches), (2, of_studies)):
        told = {(row[0], old) for row in listed for old in re.findall(r"`(\w+)`", row[column])}
        assert told == older


def test_every_picture_is_small():
    pictures = [*ROOT.glob("docs/**/*.webp"), *ROOT.glob("docs/**/*.png")]
    assert pictures and all(each.stat().st_size < 150_000 for each in pictures)
    documents = "".join(document.read_text() for document in DOCUMENTS)
    assert all(each.name in documents for each in pictures)


def test_every_document_can_be_reached_from_the_readme():
    seen, rest = set(), [ROOT / "README.md"]
    while rest:
        document = rest.pop()
        seen.add(document)
        links = re.findall(r"\]\(([^)\s#]+\.md)", document.read_text())
        found = {(document.parent / link).resolve() for link in links if "://" not in link}
        rest += found - seen - {*rest}
    assert set(DOCUMENTS) - seen == set()


def test_files_that_documents_name_are_there():
    for document in DOCUMENTS:
        if document.name == "CHANGELOG.md":
            continue
        named = re.findall(
            r"`((?:app|core|static|tests|benchmarks|clients|docs|requirements)/[\w./-]*)`",
            document.read_text(),
        )
        assert [name for name in named if not (ROOT / name).exists()] == [], document.name


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


def test_the_codes_that_were_replaced_are_listed():
    text = (ROOT / "docs/api.md").read_text()
    for table, name in (
        ("errors", "error"),
        ("warnings", "warning"),
        ("reasons", "reason"),
        ("checks", "check"),
    ):
        listed = re.findall(rf"^\| {name} `(\w+)` \| (.*) \|$", text, re.MULTILINE)
        pairs = [(new, old) for old, cell in listed for new in re.findall(r"`(\w+)`", cell)]
        assert sorted(pairs) == sorted(WAS[table].items())


def test_tolerances_are_classes_of_precision():
    literal = re.compile(r"\b(?:rel|rtol)=(?:\d[\d.]*e-(?:0?[6-9]|1\d)|1e-5)\b")
    files = [path for path in ROOT.glob("tests/**/*.py") if "oracles" not in path.parts]
    assert len(files) > 100
    assert [
        (path.name, found) for path in files for found in literal.findall(path.read_text())
    ] == []
