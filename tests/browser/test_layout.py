"""Where things stand: the answer beside the first figure, what folds, the height of the page."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.calculator_page import address, opened, settled
from tests.browser.conftest import WATCH_SCRIPT

SECTIONS = ("real", "study", "strength", "losses", "bearings", "crank")


@pytest.fixture
def newcomer(browser: Browser) -> Iterator[Page]:
    """A page of somebody who has never been here."""
    context = browser.new_context(viewport={"width": 1366, "height": 768})
    context.add_init_script(WATCH_SCRIPT)
    yield context.new_page()
    context.close()


def height(page: Page) -> int:
    return page.evaluate("() => document.documentElement.scrollHeight")


@pytest.mark.parametrize("size", [(1366, 768), (1440, 900), (1280, 800)])
def test_the_first_figure_stands_in_the_first_screen(
    newcomer: Page, service: str, size: tuple[int, int]
) -> None:
    width, tall = size
    newcomer.set_viewport_size({"width": width, "height": tall})
    newcomer.goto(service)
    settled(newcomer)
    expect(newcomer.locator(".drawing svg").first).to_be_visible()
    drawing = newcomer.locator(".drawing").first.bounding_box()
    checks = newcomer.locator(".checks").bounding_box()
    assert drawing and checks
    assert drawing["y"] + drawing["height"] <= tall
    assert checks["y"] < tall
    assert checks["x"] + checks["width"] <= drawing["x"]
    assert height(newcomer) <= 2500
    assert newcomer.evaluate("() => document.documentElement.scrollWidth") == width
    assert newcomer.evaluate("() => watched.shift") < 0.001


def test_with_every_section_on_the_page_stays_short(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    for each in SECTIONS:
        newcomer.locator(f'[data-path="{each}.on"] input').check()
    settled(newcomer)
    for each in SECTIONS:
        expect(newcomer.locator(f'[data-wanted="{each}"]')).to_be_visible()
    expect(newcomer.locator('[data-wanted="crank"] .numbers .figures')).to_have_count(2)
    assert height(newcomer) <= 6000


def test_what_is_folded_is_remembered(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    heads = newcomer.locator(".folding")
    states = heads.evaluate_all(
        "all => all.filter((one) => one.ariaExpanded === 'true').map((one) => one.textContent)"
    )
    assert states == ["Mechanism", "Contact forces", "Cyclogram"]
    pressure = newcomer.locator('[data-figure="hertz"]')
    assert pressure.bounding_box()["height"] < 50
    pressure.get_by_role("button", name="Pressure over the contact", exact=True).click()
    expect(pressure.locator(".main-svg").first).to_be_visible()
    cyclogram = newcomer.locator('[data-figure="cyclogram"]')
    cyclogram.locator(".folding").press("Enter")
    expect(cyclogram.locator(".canvas")).to_be_hidden()
    newcomer.locator(".all-results > summary").click()
    newcomer.reload()
    settled(newcomer)
    expect(pressure.locator(".main-svg").first).to_be_visible()
    expect(cyclogram.locator(".canvas")).to_be_hidden()
    expect(newcomer.locator(".all-results")).to_have_attribute("open", "")


def test_the_drawing_has_its_forces_where_their_figure_is_folded(
    newcomer: Page, service: str
) -> None:
    newcomer.goto(service)
    settled(newcomer)
    newcomer.locator('[data-figure="force"] .folding').click()
    newcomer.reload()
    settled(newcomer)
    expect(newcomer.locator(".drawing .force.arrow:not(.none) .head").first).to_be_visible()


def test_a_kept_design_opens_the_comparison(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    expect(newcomer.locator(".compare-table")).to_be_hidden()
    newcomer.keyboard.press("Alt+k")
    expect(newcomer.locator(".compare-table")).to_be_visible()


@pytest.mark.parametrize("calculator", ["rollers", "precession"])
def test_the_other_calculators_fit_too(newcomer: Page, service: str, calculator: str) -> None:
    newcomer.goto(f"{service}/?calculator={calculator}")
    opened(newcomer, calculator)
    assert address(newcomer)
    drawing = newcomer.locator(".drawing").first.bounding_box()
    assert drawing and drawing["y"] < 300
    assert height(newcomer) <= 2500
