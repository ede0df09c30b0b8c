"""The report: on paper through the browser's print, and as one HTML file."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from pypdf import PdfReader

from app import VERSION
from tests.browser.calculator_page import (
    chosen,
    exported,
    figures_drawn,
    printed,
    settled,
    show,
    tab,
    text_of,
)

CALCULATORS = ("crank-planetary", "rollers", "precession")
A4_POINTS = (595, 842)
PAPER_PX = 688  # A4 less the margins
INPUTS = {
    "crank-planetary": ("Output torque", "Pin circle radius", "Structural steel|Bearing steel"),
    "rollers": ("Output torque", "Cylinder length", "Young's modulus"),
    "precession": ("Torque", "Nutation angle", "Working length"),
}
NUMBERS = {
    "crank-planetary": ("280N·m", "28mm", "548.6MPa", "6667N"),
    "rollers": (),
    "precession": (),
}
STEPS = {
    "crank-planetary": ("Pressure angle of the pair of the peak", "Reduced radius", "eq. (4)"),
    "rollers": ("Compliance in bending", "Bending moment", "eq. (9)"),
    "precession": ("Length A of the contact lines", "Deflection at B", "eq. (30)"),
}


def drawn(page: Page, service: str, calculator: str) -> None:
    """Open a calculator and wait for its figures."""
    show(page, service, calculator)
    figures_drawn(page)


@pytest.mark.parametrize("calculator", CALCULATORS)
def test_the_report_is_whole_on_paper_and_as_a_file(
    page: Page, browser: Browser, service: str, calculator: str, tmp_path: Path
) -> None:
    drawn(page, service, calculator)
    the_saved_report_stands_alone(page, browser, calculator, tmp_path / f"{calculator}.html")
    the_printed_report_holds_inputs_steps_and_version(page, calculator)
    nothing_is_cut_on_paper(page)


def the_printed_report_holds_inputs_steps_and_version(page: Page, calculator: str) -> None:
    width = page.locator(".plot").first.bounding_box()["width"]
    pdf = printed(page)
    assert 2 <= len(pdf.pages) <= 4
    box = pdf.pages[0].mediabox
    assert (round(box.width), round(box.height)) == pytest.approx(A4_POINTS, abs=1)
    text = text_of(pdf)
    assert f"KHV Calc {VERSION}" in text
    assert re.search(r"\d{4}-\d\d-\d\d", text)
    for words in (*INPUTS[calculator][:2], "Revision", "Checks"):
        assert words in text, words
    for numbers in NUMBERS[calculator]:
        assert numbers in text.replace(" ", "").replace("\u202f", ""), numbers
    for step in page.locator(".worked details").all():
        step.locator("summary").click()
        expect(step.locator(".worked-steps > *").first).to_be_visible()
    text = text_of(printed(page))
    for words in STEPS[calculator]:
        assert words in text, words
    for step in page.locator(".worked details").all():
        step.locator("summary").click()
    assert "Undo" not in text
    assert "Keep this design" not in text
    # Afterwards the page is as before.
    expect(page.locator(".worked details[open]")).to_have_count(0)
    expect(page.locator(".report-head")).to_be_hidden()
    assert page.locator(".plot").first.bounding_box()["width"] == width
    settled(page)


def nothing_is_cut_on_paper(page: Page) -> None:
    page.emulate_media(media="print")
    page.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    page.set_viewport_size({"width": PAPER_PX, "height": 1000})
    expect(page.locator(".report-head")).to_be_visible()
    # The drawing is made anew for the width of the paper, a frame after it is there.
    page.wait_for_function(
        """(width) => [...document.querySelectorAll(".outputs *")]
          .every((one) => one.getBoundingClientRect().right <= width + 1)""",
        arg=PAPER_PX,
    )
    for plot in page.locator(".figure:not(:has(.measure)) .plot").all():
        box = plot.bounding_box()
        assert box and box["width"] <= PAPER_PX
    controls = "button:not(.folding, .chip *):visible, input:visible, select:visible"
    assert page.locator(controls).count() == 0


def test_the_print_button_draws_light_figures_in_the_dark(page: Page, service: str) -> None:
    drawn(page, service, "crank-planetary")
    chosen(page, "theme", "dark")
    text = page.locator('[data-figure="force"] .xtick text').first
    dark = "rgb(230, 237, 243)"
    expect(text).to_have_css("fill", dark)
    page.evaluate(
        """() => { globalThis.print = () => {
          globalThis.inked = getComputedStyle(document.querySelector(
            '[data-figure="force"] .xtick text')).fill;
          dispatchEvent(new Event("beforeprint"));
          dispatchEvent(new Event("afterprint"));
        }; }"""
    )
    page.get_by_role("button", name="Export").click()
    page.locator("#export [data-do=print]").click()
    page.wait_for_function("() => globalThis.inked !== undefined")
    assert page.evaluate("() => inked") == "rgb(28, 39, 51)"
    expect(text).to_have_css("fill", dark)


def the_saved_report_stands_alone(
    page: Page, browser: Browser, calculator: str, file: Path
) -> None:
    figures = page.locator(".figure:not(:has(.measure))").count()
    file.write_bytes(exported(page, "report").read_bytes())
    markup = file.read_text(encoding="utf-8")
    assert "<script" not in markup
    assert not re.search(r'(?:src|href)="(?!#)', re.sub(r"<svg.*?</svg>", "", markup, flags=re.S))

    alone = browser.new_context(offline=True, viewport={"width": 900, "height": 900})
    report = alone.new_page()
    asked: list[str] = []
    report.on("request", lambda request: asked.append(request.url))
    report.goto(file.as_uri())
    text = re.sub(r"\s+", " ", report.locator("body").inner_text())
    assert f"KHV Calc {VERSION}" in text
    for words in (*INPUTS[calculator][:2], "Revision", "Checks"):
        assert words in text, words
    assert report.locator("button, input, select").count() == 0
    assert report.locator(".figure .canvas > svg").count() == figures
    for picture in report.locator(".figure .canvas > svg").all():
        box = picture.bounding_box()
        assert box and box["width"] > 300 and box["height"] > 150
    for formula in report.locator(".worked math").all()[:5]:
        assert formula.bounding_box()
    assert report.evaluate("() => document.fonts.check('16px \"STIX Two Math\"')")
    assert [url for url in asked if not url.startswith(("file:", "data:"))] == []
    alone.close()


SECTIONS = ("real", "study", "strength", "losses", "bearings", "crank")
MARGIN_POINTS = 14 / 25.4 * 72


def left_edge(pdf: PdfReader) -> float:
    """Left edge of the leftmost text on paper, points."""
    edges: list[float] = []

    def seen(text: str, user: list[float], line: list[float], *_: object) -> None:
        if text.strip():
            edges.append(user[0] * line[4] + user[2] * line[5] + user[4])

    for page in pdf.pages:
        page.extract_text(visitor_text=seen)
    return min(edges)


def test_the_report_of_a_design_with_all_sections_on_is_short_and_whole(
    page: Page, service: str
) -> None:
    drawn(page, service, "crank-planetary")
    for each in SECTIONS:
        page.locator(f'[data-path="{each}.on"] input').check()
    settled(page)
    for each in SECTIONS:
        expect(page.locator(f'[data-wanted="{each}"] > :not(h2)')).to_be_attached()
    tab(page, "real").click()
    expect(page.locator('[data-wanted="real"] .figures').first).to_be_visible()
    pdf = printed(page)
    assert 2 <= len(pdf.pages) <= 4
    assert left_edge(pdf) >= MARGIN_POINTS - 1
    text = text_of(pdf)
    offered = page.locator(".besides > .panel > .beside-card:not([data-wanted=study])")
    for each in offered.all():
        if tab(page, each.get_attribute("data-wanted") or "").is_visible():
            heading = each.locator("> h2").text_content() or ""
            assert heading in text, heading
    for words in ("Real peak force", "Backlash, largest", "Safety factor of fatigue"):
        assert words in text.replace("fa tigue", "fatigue"), words
