"""Reports: their numbers are the answer's, in every language, and nothing typed is markup."""

import html
import math
import re
import typing

import pytest

from app import model
from app.examples import EXAMPLES, REQUESTS
from app.exports import report
from app.words import Language, Words

pytestmark = pytest.mark.anyio

PATH = "export/report"
LANGUAGES = typing.get_args(Language)
EXAMPLE = {each["id"]: each for each in EXAMPLES}
ROUNDED = {"rel": 6e-4, "abs": 1e-9}  # four significant digits
SHARE = {"rel": 6e-3, "abs": 0.051}  # two or three
ENGLISH = re.compile(r"\b[a-z]{3,} [a-z]{3,}\b")
"""Two words in a row that are Latin, which names, symbols and units are not."""

REQUESTED = [(name, REQUESTS[name]) for name in report.CALCULATIONS]
REQUESTED += [
    pytest.param(each["calculation"], each["input"], id=each["id"], marks=pytest.mark.slow)
    for each in EXAMPLES
]


def text_of(page):
    """Text of a page that a reader sees."""
    body = re.sub(r"<(style|defs).*?</\1>", "", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]*>", " ", body)).replace("\u00ad", "")


def number_in(text):
    """First number of a text, as a reader of any language reads it."""
    plain = text.replace("\u202f×\u202f", "·").replace("\u202f", "").replace(",", ".")
    found = re.search(r"([−]?)(\d+(?:\.\d+)?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?", plain)
    power = (found[3] or "⁰").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(found[2]) * 10 ** int(power) * (-1 if found[1] else 1)


def rows_of(page):
    """Cells of the rows of checks by code."""
    rows = re.findall(r'<tr class="([\w ]+)" data-code="(\w+)">(.*?)</tr>', page)
    cell = re.compile(r"<td[^>]*>(.*?)</td>")
    return {code: (status.split()[0], cell.findall(row)) for status, code, row in rows}


def lines_of(page):
    """Values of the tables of inputs and results by their titles, as often as they are there."""
    found = {}
    for row in re.findall(r"<tr><td>(.*?)</tr>", page, flags=re.DOTALL):
        title, *_, value = html.unescape(re.sub(r"<[^>]*>", "\n", row)).strip().split("\n")
        found.setdefault(title, []).append(value)
    return found


async def page_of(api, calculation, body, **more):
    response = await api.post(PATH, json={"calculation": calculation, "input": body} | more)
    assert response.status_code == 200, response.text
    assert response.headers["content-type"] == "text/html; charset=utf-8"
    return response.text


def held_to(page, answer, language):
    """Hold checks and results of a page against an answer."""
    rows = rows_of(page)
    for check in answer.get("checks", ()):
        status, cells = rows.get(check["code"], (None, []))
        shown = check["status"] in ("pass", "marginal", "fail") or (
            check["status"] == "not_checked" and check.get("needed", True)
        )
        assert (status == check["status"]) if shown else status is None
        for name, place, off in (("value", 3, ROUNDED), ("limit", 4, ROUNDED)):
            if status and name in check and re.search(r"\d", cells[place]):
                assert number_in(cells[place]) == pytest.approx(check[name], **off), check["code"]
        if status and "utilisation" in check and status != "not_checked":
            assert number_in(cells[5]) == pytest.approx(100 * check["utilisation"], **SHARE)
    words, lines = Words(language, {}), lines_of(page)
    for section, name in (
        ("load_sharing", "peak_force_N"),
        ("hertz", "max_pressure_MPa"),
        ("crankshaft", "speed_rpm"),
    ):
        if isinstance(answer.get(section), dict) and name in answer[section]:
            said = lines[words.result(name, section)]
            values = [number_in(each) for each in said]
            assert pytest.approx(answer[section][name], **ROUNDED) in values


@pytest.mark.parametrize(("calculation", "body"), REQUESTED)
def test_every_report_has_the_numbers_of_its_answer_in_every_language(calculation, body):
    asked = {"calculation": calculation, "input": body, "worked": True}
    answer = report.ReportRequest(**asked).answer
    for language in LANGUAGES:
        page = report.Report(report.ReportRequest(**asked, language=language), answer).html()
        text = text_of(page)
        assert f'<html lang="{language}">' in page
        assert not re.search(r"[{}]", text)
        assert "None" not in text and "nan" not in text
        held_to(page, answer, language)
        if language != "en":
            assert not ENGLISH.findall(text)
        headings = re.findall(r"<h[23]>(.*?)</h[23]>\s*(<\S+)", page)
        assert headings and all(title and not after.startswith("<h") for title, after in headings)


async def test_inputs_are_those_typed_and_those_assumed(api):
    body = EXAMPLE["cycloid"]["input"]
    lines = lines_of(await page_of(api, "crank-planetary", body))
    assert lines["Output torque"] == ["200\u00a0N·m"]
    assert "13; 37\u00a0mm" in lines["Places of the satellites"]
    assert lines["Safety against pitting"] == ["1.2"]
    assert lines["Pin material"][0] == "Case-hardened steel (18CrNiMo7-6)"


@pytest.mark.parametrize(
    ("example", "word", "shown"),
    [
        ("involute", "pass", {"en": "Works", "uk": "Придатна", "ru": "Пригодна"}),
        ("cycloid", "marginal", {"en": "Just works", "uk": "На межі", "ru": "На пределе"}),
        ("yanchevskiy-2021-fig-6a", "fail", {"en": "Fails"}),
        ("opening", "incomplete", {"en": "Incomplete (1 of 6)"}),
        ("ovsyannikov-2019-fig-6", "incomplete", {"en": "Incomplete"}),
    ],
)
async def test_the_verdict_is_a_word_with_the_check_that_decides(api, example, word, shown):
    each = EXAMPLE[example]
    for language, said in shown.items():
        page = await page_of(api, each["calculation"], each["input"], language=language)
        assert f'<div class="verdict" data-word="{word}">\n<div class="word">{said}</div>' in page
        assert re.search(r'<div class="why">\s*<p>[^<]+<strong>[^<]+</strong>', page)


async def test_what_cannot_be_built_is_impossible_and_what_cannot_be_read_is_refused(api):
    body = EXAMPLE["cycloid"]["input"]
    tight = body | {"contact": body["contact"] | {"pin_radius_mm": 16.0}}
    assert "Impossible" in await page_of(api, "crank-planetary", tight)
    wrong = REQUESTS["hertz"] | {"force_N": -1.0}
    asked = {"calculation": "hertz", "input": wrong}
    assert await api.refusal(PATH, asked) == ("/input/force_N", "greater_than_equal")
    asked = {"calculation": "hertz", "input": REQUESTS["hertz"]}
    link = asked | {"title_block": {"link": "javascript:alert(1)"}}
    assert (await api.refusal(PATH, link))[0] == "/title_block/link"
    assert (await api.refusal(PATH, asked | {"language": "de"}))[0] == "/language"


async def test_what_is_typed_is_no_markup_and_nothing_is_fetched(api):
    evil = "<script>alert(1)</script>\"'&"
    block = {"title": evil, "author": evil, "revision": evil, "date": evil, "note": evil}
    link = "https://calc.example/?calculator=rollers&v=2&x='\"><script>"
    page = await page_of(api, "hertz", REQUESTS["hertz"], title_block=block | {"link": link})
    assert "<script" not in page
    assert page.count("&lt;script&gt;alert(1)&lt;/script&gt;&#34;&#39;&amp;") == 6
    href = "https://calc.example/?calculator=rollers&amp;v=2&amp;x=&#39;&#34;&gt;&lt;script&gt;"
    assert re.findall(r'\s(?:href|src|on\w+)="([^"]*)"', page) == [href]
    assert not re.search(r"url\((?!#)|@import", page)
    for style in re.findall(r"<style>(.*?)</style>", page, flags=re.DOTALL):
        assert "<" not in style


async def test_worked_steps_are_at_the_end_if_they_are_wanted(api):
    asked = ("hertz", REQUESTS["hertz"])
    without, worked = await page_of(api, *asked), await page_of(api, *asked, worked=True)
    answer = await api.answer("hertz", REQUESTS["hertz"] | {"include": ["worked"]})
    assert "Worked calculation" not in without
    assert worked.partition("Worked calculation")[2].count("<tr>") == len(answer["worked"])


def test_numbers_are_written_as_the_page_writes_them():
    english, other = Words("en", {}), Words("uk", {})
    assert [english.number(each) for each in (0, 3.0, -0.00123456, 1234.56, 12345.6)] == [
        *("0", "3", "−0.001235", "1235", "12\u202f350")
    ]
    assert other.quantity(0.25, "mm") == "0,25\u00a0мм"
    assert (other.quantity(90.0, "°"), english.number(2.5e-7)) == ("90°", "2.5\u202f×\u202f10⁻⁷")
    assert math.isclose(number_in(other.number(2.5e-7)), 2.5e-7)


STAND_IN = """
class HTML:
    def __init__(self, string, url_fetcher):
        self.string, self.fetch = string, url_fetcher
    def write_pdf(self):
        try:
            self.fetch("http://example/")
        except ValueError:
            return b"%PDF " + self.string[:15].encode()
"""

ACCEPTED = {"accept": "application/pdf"}


async def test_a_pdf_needs_the_extra_and_says_so(api, monkeypatch):
    monkeypatch.setattr(model, "find_spec", lambda name: None)
    answer = await api.post(PATH, json=REQUESTS[PATH], headers=ACCEPTED)
    assert answer.status_code == 501
    (error,) = answer.json()["errors"]
    assert error["code"] == "not_installed"
    assert error["params"] == {"extra": "pdf", "instead": "/export/report"}
    assert (await api.post(PATH, json=REQUESTS[PATH])).status_code == 200
    exports = (await api.get("calculations")).json()["exports"]
    (own,) = (each for each in exports if each["name"] == PATH)
    assert (own["installed"], own["media_types"]) == (True, ["text/html"])


async def test_with_the_extra_the_page_is_made_a_pdf(api, tmp_path, monkeypatch):
    (tmp_path / "weasyprint.py").write_text(STAND_IN)
    monkeypatch.syspath_prepend(tmp_path)
    assert report.EXPORT.answered == ("text/html", "application/pdf")
    written = report.write(report.ReportRequest(**REQUESTS[PATH]))
    file = report.as_pdf(written)
    assert (file.name, file.media_type) == ("hertz.pdf", "application/pdf")
    assert file.content == b"%PDF <!doctype html>"
    assert report.EXPORT.file(report.ReportRequest(**REQUESTS[PATH]), converted=False) == written
    assert report.EXPORT.converts("application/pdf") and not report.EXPORT.converts("*/*")
