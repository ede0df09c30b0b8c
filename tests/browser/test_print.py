"""The report: printed in place of the page, and saved as one HTML file."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from app import VERSION
from tests.browser.calculator_page import (
    exported,
    figures_drawn,
    printed,
    settled,
    show,
    text_of,
)

A4_POINTS = (595, 842)
INPUTS = {
    "crank-planetary": ("Output torque", "Pin circle radius", "280\u00a0N·m", "548.6\u00a0MPa"),
    "rollers": ("Output torque", "Cylinder length", "Young's modulus"),
    "precession": ("Torque", "Nutation angle", "Working length"),
}


def asked_to_print(page: Page) -> None:
    """Ask for the report on paper, and wait until it would be printed."""
    page.evaluate("() => { globalThis.print = () => { globalThis.done = true; }; }")
    page.locator('[data-tool="export"]').click()
    page.locator("#export [data-do=print]").click()
    page.wait_for_function("() => globalThis.done")


@pytest.mark.parametrize("calculator", INPUTS)
def test_the_report_is_printed_in_place_of_the_page_and_saved(
    page: Page, browser: Browser, service: str, calculator: str, tmp_path: Path
) -> None:
    show(page, service, calculator)
    figures_drawn(page)
    page.get_by_label("Name of the design").fill("Joint <3>")
    settled(page)
    file = tmp_path / "report.html"
    file.write_bytes(exported(page, "report").read_bytes())
    alone = browser.new_context(offline=True)
    report = alone.new_page()
    asked: list[str] = []
    report.on("request", lambda request: asked.append(request.url))
    report.goto(file.as_uri())
    saved = report.locator("body").inner_text()
    assert asked == [file.as_uri()]
    link = report.locator(".link a").get_attribute("href") or ""
    alone.close()
    asked_to_print(page)
    expect(page.locator("#export")).not_to_be_visible()
    expect(page.locator(".paper")).to_be_hidden()  # on the screen
    pdf = printed(page)
    assert 1 <= len(pdf.pages) <= 3
    box = pdf.pages[0].mediabox
    assert (round(box.width), round(box.height)) == pytest.approx(A4_POINTS, abs=1)
    text = text_of(pdf)
    for words in ("Joint <3>", "Revision", "Checks", *INPUTS[calculator]):
        assert words in saved, words
        assert words.replace("\u00a0", " ") in text.replace("\u00a0", " "), words
    assert f"KHV Calc {VERSION}" in text and re.search(r"\d{4}-\d\d-\d\d", text)
    assert "Undo" not in text and "New design" not in text
    page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    expect(page.locator(".paper")).to_have_count(0)
    page.goto(link)
    expect(page.get_by_label("Name of the design")).to_have_value("Joint <3>")


def test_the_keys_of_the_browser_print_the_report_in_the_language_of_the_page(
    page: Page, service: str
) -> None:
    page.goto(f"{service}/?calculator=rollers&lang=uk")
    settled(page)
    page.evaluate("() => { globalThis.print = () => { globalThis.done = true; }; }")
    page.keyboard.press("Control+p")
    page.wait_for_function("() => globalThis.done")
    text = text_of(printed(page))
    assert "Вхідні дані" in text
