"""The page in every language: all its words, decimal signs, and the same numbers."""

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.calculator_page import (
    TEXTS,
    box,
    figures_drawn,
    foreign,
    picked,
    settled,
    show,
)
from tests.running_service import eventually

CALCULATORS = {
    "crank-planetary": "contact.pin_radius_mm",
    "rollers": "diameter_mm",
    "precession": "",
}


@pytest.mark.parametrize("language", ["uk", "ru"])
@pytest.mark.parametrize("calculator", CALCULATORS)
def test_nothing_is_left_in_english(
    page: Page, service: str, calculator: str, language: str
) -> None:
    show(page, service, calculator)
    figures_drawn(page)
    english = page.locator(".results .value").all_text_contents()
    assert foreign(page)  # the check sees English
    page.get_by_role("button", name="Settings").click()
    with page.expect_navigation():
        page.locator("#language").select_option(language)
    settled(page)
    assert page.evaluate("() => document.documentElement.lang") == language
    figures_drawn(page)
    page.evaluate(
        "() => document.querySelectorAll('.outputs details').forEach((d) => d.open = true)"
    )
    assert eventually(lambda: foreign(page) == set()), foreign(page)

    def numbers(texts: list[str]) -> list[str]:
        return [text.replace(".", ",") for text in texts if re.fullmatch(r"[\d.,\s\u2212]+", text)]

    shown = page.locator(".results .value").all_text_contents()
    assert numbers(shown) == numbers(english)
    for typed in page.locator("form input.box:not([type=radio])").all():
        assert "." not in typed.input_value()
    for measure in page.locator(".measure").all():
        measure.click()
        expect(measure).to_be_hidden()
    assert foreign(page) == set()
    if CALCULATORS[calculator]:
        box(page, CALCULATORS[calculator]).fill("-1")
        settled(page, "wrong")
        assert foreign(page) == set()


CHAPTERS = re.compile(
    r"Contact Mechanics, \d\.\d(, \d\.\d)*( \w \d\.\d)?|8\.8"
)  # and a class of bolts


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_every_decimal_fraction_has_a_comma(page: Page, service: str, language: str) -> None:
    page.goto(f"{service}/?calculator=crank-planetary&lang={language}")
    settled(page)
    picked(page, "printed-15-to-1")
    settled(page)
    box(page, "contact.hole_material").select_option("plastic_pla_printed")
    settled(page)
    page.evaluate("() => document.querySelectorAll('details').forEach((d) => d.open = true)")
    texts = [CHAPTERS.sub("", text) for text in page.evaluate(TEXTS)]
    assert [text for text in texts if re.search(r"(?<![\w.])\d+\.\d+(?![\w.])", text)] == []
    assert any("PolyTerra (Polymaker 2023) 23,2" in text for text in texts)


def test_the_browsers_language_is_taken(browser, service: str) -> None:  # type: ignore[no-untyped-def]
    context = browser.new_context(locale="uk-UA")
    page = context.new_page()
    show(page, service, "rollers")
    expect(page.locator("#tab-rollers")).to_have_text("Хитні ролики")
    context.close()


def test_refusals_of_the_service_are_translated(browser, service: str) -> None:  # type: ignore[no-untyped-def]
    context = browser.new_context(locale="ru-RU")
    page = context.new_page()
    show(page, service, "crank-planetary")
    page.locator(".search .toggle").click()
    for path, value in (("mechanism.pins", "2"), ("mechanism.satellites", "1")):
        box(page, path).fill(value)
    box(page, "mechanism.crank_spacing_deg").fill("0")
    settled(page, "refused")
    expect(page.locator(".say")).to_contain_text("момент не передаётся")
    assert foreign(page) == set()
    context.close()


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
@pytest.mark.parametrize("calculator", CALCULATORS)
def test_words_have_their_room_at_every_width(
    page: Page, service: str, calculator: str, language: str
) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(f"{service}/?calculator={calculator}&lang={language}")
    settled(page)
    expect(page.locator(f"#tab-{calculator}")).to_have_attribute("aria-selected", "true")
    for width in (390, 320):
        page.set_viewport_size({"width": width, "height": 844})
        tabs_and_headings_are_in_sight(page)
    page.evaluate("() => document.querySelectorAll('.form details').forEach((d) => d.open = true)")
    for width in (360, 1400):
        page.set_viewport_size({"width": width, "height": 844})
        names_break_between_words_only(page)


def tabs_and_headings_are_in_sight(page: Page) -> None:
    room = page.locator("#tabs").evaluate(
        "({ scrollWidth, clientWidth, scrollHeight, clientHeight }) =>"
        " [scrollWidth - clientWidth, scrollHeight - clientHeight]"
    )
    assert room == [0, 0]
    headings = page.locator("figcaption h2, .head h2, .compare-head h2, .worked h2")
    headings = headings.filter(visible=True)
    cut = headings.evaluate_all(
        "(all) => all.filter((h) => h.scrollWidth > h.clientWidth).map((h) => h.innerText)"
    )
    assert cut == []  # nor under the buttons beside it


def names_break_between_words_only(page: Page) -> None:
    """Names of fields; or at a soft hyphen that is written into them."""
    broken = page.evaluate(
        """() => [...document.querySelectorAll(".field-name, .choice > legend")]
          .filter((name) => name.offsetParent && name.firstChild)
          .flatMap(({ firstChild: text }) => [...text.data.matchAll(/[^\\s\\u00ad-]+/g)]
            .filter((word) => {
              const range = document.createRange();
              range.setStart(text, word.index);
              range.setEnd(text, word.index + word[0].length);
              const lines = [...range.getClientRects()].map(({ top }) => Math.round(top));
              return new Set(lines).size > 1;
            }).map(([word]) => `${text.data}: ${word}`))"""
    )
    assert broken == []


def test_help_is_in_sight_covers_not_its_box_and_moves_nothing(page: Page, service: str) -> None:
    page.goto(f"{service}/?calculator=crank-planetary&lang=uk&crank.on=on&bearings.on=on")
    settled(page, "incomplete")
    expect(box(page, "gear.kind")).to_be_visible()
    help_line = page.locator(".help")
    for size in ((1280, 720), (360, 640)):
        page.set_viewport_size({"width": size[0], "height": size[1]})
        if size[0] < 800:
            page.locator('.places [data-place="inputs"]').click()
        page.evaluate("() => document.activeElement.blur()")
        expect(help_line).to_be_hidden()
        height = page.locator(".form").evaluate("(form) => form.offsetHeight")
        for path in ("contact.eccentricity_mm", "gear.kind", "crankshaft.satellite_mass_kg"):
            row = page.locator(f'[data-path="{path}"]')
            box(page, path).focus()
            expect(help_line).to_have_text(row.locator("label").get_attribute("title") or "-")
            assert page.locator(".form").evaluate("(form) => form.offsetHeight") == height
            at, line = box(page, path).bounding_box(), help_line.bounding_box()
            assert at and line and at["y"] + at["height"] <= line["y"], path
            assert line["y"] + line["height"] <= size[1], path
