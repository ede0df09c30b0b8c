"""Every example of the page taken along: report, JSON, CSV, DXF, each looked into."""

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
from pypdf import PdfReader

from core.precision import AS_TYPED
from tests.browser.calculator_page import (
    exported,
    picked,
    saved,
    settled,
    show,
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
MOST_PAGES = 5

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

JUDGED = ("pass", "marginal", "fail")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
PLAIN = str.maketrans("−⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "--0123456789", "\u202f")


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
        checks = the_numbers_are_taken_along(page, example["id"], given)
        the_report_has_them(page, reader, example["id"], given, checks)
    alone.close()


def the_numbers_are_taken_along(page: Page, name: str, given: dict[str, Any]) -> list[Any]:
    """JSON, CSV and, of teeth, DXF; all checks that were answered."""
    page.get_by_role("button", name="Export").click()
    requests = json.loads(saved(page, page.locator("[data-do=json]")).read_text())["requests"]
    asked = dict(leaves(requests[-1]["body"]))
    assert {path: asked.get(path) for path in given} == given, name
    checks = [check for one in requests for check in one["answer"].get("checks", [])]
    codes = [check["code"] for check in checks]

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
    return checks


def the_report_has_them(
    page: Page, reader: Page, name: str, given: dict[str, Any], checks: list[Any]
) -> None:
    reader.set_content(exported(page, "report").read_text())
    listed = reader.locator(".tables td.number").all_text_contents()
    numbers = [
        float(one)
        for text in listed
        for one in NUMBER.findall(text.translate(PLAIN).replace("×10", "e"))
    ]
    for path, value in given.items():
        for one in value if isinstance(value, list) else [value]:
            if isinstance(one, int | float) and not isinstance(one, bool):
                assert pytest.approx(one, rel=AS_TYPED) in numbers, (name, path)
    shown = {row.get_attribute("data-code") for row in reader.locator("[data-code]").all()}
    assert {each["code"] for each in checks if each["status"] in JUDGED} <= shown, name
    assert reader.evaluate(COVERED) == [], name
    assert len(PdfReader(io.BytesIO(reader.pdf(prefer_css_page_size=True))).pages) <= MOST_PAGES, (
        name
    )
