"""Every example of the page taken along: report, print, JSON, CSV, DXF, each looked into."""

import csv
import io
import json
import re
import zipfile
from collections.abc import Iterator
from typing import Any

import ezdxf
import httpx
import pytest
from playwright.sync_api import Browser, Page, expect

from core.precision import AS_TYPED
from tests.browser.calculator_page import (
    exported,
    number,
    picked,
    printed,
    saved,
    settled,
    show,
    text_of,
)

CALCULATIONS = {
    "crank-planetary": "crank-planetary",
    "rollers": "roller-strength",
    "precession": "precession/shaft-deflection",
}
PARTS = {
    "cycloid": 8,  # two discs, ring, two plates, housing, shaft, assembly
    "involute": 8,
    "twente-13-to-1": 6,  # one disc; no shaft is given
    "clark-19-to-1": 7,
    "vijayanathan-29-to-1": 6,  # one plate
    "xw3-43-to-1": 6,
}
PAPER_PX = 688  # A4 less the margins
MOST_PAGES = 4

COVERED = """() => {
  const shown = (node) => node.checkVisibility({ visibilityProperty: true });
  const clear = 1.5;
  const apart = (a, b) => a.left > b.right - clear || a.right < b.left + clear
    || a.top > b.bottom - clear || a.bottom < b.top + clear;
  const drawn = ".drawing svg, .plot .main-svg, .canvas > svg";
  const boxes = [...document.querySelectorAll(drawn)].filter(shown).map((one) =>
    ({ words: "a figure", box: one.getBoundingClientRect(), node: one.closest(".plot") ?? one }));
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT, ({ parentElement }) =>
    parentElement.closest("svg, .plot, math, .unseen, script") || !shown(parentElement)
      ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT);
  while (walk.nextNode()) {
    const words = walk.currentNode.data.trim();
    const range = document.createRange();
    range.selectNodeContents(walk.currentNode);
    const node = walk.currentNode;
    if (words) boxes.push(...[...range.getClientRects()].map((box) => ({ words, box, node })));
  }
  boxes.sort((a, b) => a.box.top - b.box.top);
  return boxes.flatMap((one, i) => {
    const over = [];
    for (const other of boxes.slice(i + 1)) {
      if (other.box.top > one.box.bottom) break;
      if (one.node === other.node) continue;
      if (!apart(one.box, other.box)) over.push(`${one.words} | ${other.words}`);
    }
    return over;
  });
}"""
"""What lies on something else: words on words, a figure on words or on a figure."""

GIVEN = """() => Object.fromEntries([...document.querySelectorAll(".given [data-path]")]
  .map((row) => [row.dataset.path, row.querySelector(".value").textContent]))"""
CODES = "() => [...document.querySelectorAll('.check')].map((row) => row.dataset.code)"
SAID = """() => [".given th", ".check:not([data-status=not_applicable]) .check-title"]
  .flatMap((each) => [...document.querySelectorAll(each)])
  .map((one) => [...one.childNodes].filter(({ className }) => className !== "unseen")
    .map(({ textContent }) => textContent).join(""))"""


def leaves(part: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Values of a body by their paths; of lists of numbers or names the whole."""
    if isinstance(part, dict):
        for name, value in part.items():
            yield from leaves(value, f"{path}.{name}" if path else name)
    elif isinstance(part, list) and isinstance(part[0], dict):
        for i, value in enumerate(part):
            yield from leaves(value, f"{path}[{i}]")
    else:
        yield path, part


def given_by(example: dict[str, Any]) -> dict[str, Any]:
    """Values that an example types; an even spacing equals an empty box, sleeves are a choice."""
    given = dict(leaves(example["input"]))
    given.pop("friction.sleeve", None)
    spacing = "mechanism.crank_spacing_deg"
    if given.get(spacing) == 360 / given.get("mechanism.satellites", 1):
        del given[spacing]
    return given


def plain(text: str) -> str:
    """Words without what a line's end does to them."""
    return re.sub(r"[\s\u00ad\u202f-]", "", text)


@pytest.mark.parametrize("calculator", CALCULATIONS)
def test_every_example_is_taken_along_whole(
    page: Page, browser: Browser, service: str, calculator: str
) -> None:
    found = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"]
    show(page, service, calculator)
    alone = browser.new_context(offline=True, viewport={"width": 900, "height": 900})
    reader = alone.new_page()
    for example in found:
        if example["calculation"] != CALCULATIONS[calculator]:
            continue
        picked(page, example["id"])
        settled(page)
        expect(page.locator(".outputs [data-stale=true]:visible")).to_have_count(0)
        given = given_by(example)
        codes = the_numbers_are_taken_along(page, example["id"], given)
        the_saved_report_has_them(page, reader, example["id"], given, codes)
        the_print_has_them(page, example["id"], reader.evaluate(SAID))
    alone.close()


def the_numbers_are_taken_along(page: Page, name: str, given: dict[str, Any]) -> list[str]:
    """JSON, CSV and, of teeth, DXF; the codes of all checks that were answered."""
    page.get_by_role("button", name="Export").click()
    requests = json.loads(saved(page, page.locator("[data-do=json]")).read_text())["requests"]
    asked = dict(leaves(requests[-1]["body"]))
    assert {path: asked.get(path) for path in given} == given, name
    codes = [check["code"] for one in requests for check in one["answer"].get("checks", [])]

    text = saved(page, page.locator("[data-do=csv]")).read_text()
    head, *rows = csv.reader(io.StringIO(text))
    assert head == ["section", "name", "value", "unit"], name
    assert {len(row) for row in rows} == {4}, name
    inputs = {row[1]: row[2] for row in rows if row[0] == "inputs"}
    for path, value in given.items():
        for at, one in enumerate(value) if isinstance(value, list) else [(None, value)]:
            written = inputs[path if at is None else f"{path}[{at}]"]
            assert written == one or float(written) == one, (name, path)
    judged = [row[1].removesuffix(".status") for row in rows if row[1].endswith(".status")]
    assert judged == codes and codes, name

    drawings = page.locator("[data-do=dxf]")
    assert drawings.count() == (name in PARTS), name
    if drawings.count():
        with zipfile.ZipFile(saved(page, drawings)) as pieces:
            drawn = [each for each in pieces.namelist() if each.endswith(".dxf")]
            assert len(drawn) == PARTS[name], name
            for piece in drawn:
                drawing = ezdxf.read(io.StringIO(pieces.read(piece).decode()))
                assert len(drawing.modelspace()) > 0, (name, piece)
                assert not drawing.audit().has_errors, (name, piece)
    page.keyboard.press("Escape")
    return codes


def the_saved_report_has_them(
    page: Page, reader: Page, name: str, given: dict[str, Any], codes: list[str]
) -> None:
    reader.set_content(exported(page, "report").read_text())
    rows = reader.evaluate(GIVEN)
    listed = reader.locator(".given .data td").all_text_contents()
    for path, value in given.items():
        shown = rows.get(re.sub(r"\[(\d+)\]", r".\1", path))
        if isinstance(value, int | float) and not isinstance(value, bool):
            numbers = map(number, listed if shown is None else [shown])
            assert pytest.approx(value, rel=AS_TYPED) in numbers, (name, path)
        else:
            assert shown, (name, path)
    assert sorted(reader.evaluate(CODES)) == sorted(codes), name
    figures = page.locator(".figure:not(:has(.measure), [hidden]):visible").count()
    assert reader.locator(".canvas > svg").count() >= figures, name
    assert reader.evaluate(COVERED) == [], name


def the_print_has_them(page: Page, name: str, said: list[str]) -> None:
    pdf = printed(page)
    if len(pdf.pages) > MOST_PAGES:  # seen once on a busy machine; the cause is not known
        page.wait_for_timeout(3000)
        pdf = printed(page)
    assert 2 <= len(pdf.pages) <= MOST_PAGES, (name, len(pdf.pages))
    text = plain(text_of(pdf))
    assert [words for words in said if plain(words) not in text] == [], name
    page.emulate_media(media="print")
    page.evaluate(
        "(width) => { document.body.style.width = `${width}px`;"
        " dispatchEvent(new Event('beforeprint')); }",
        PAPER_PX,
    )
    assert page.evaluate(COVERED) == [], name
    page.evaluate(
        "() => { dispatchEvent(new Event('afterprint')); document.body.style.width = ''; }"
    )
    page.emulate_media(media="null")
