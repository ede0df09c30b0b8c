"""Layout: the answer beside the first figure, folded parts, the height of the page."""

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


def test_diameters_are_diameters_everywhere_and_in_the_link(newcomer: Page, service: str) -> None:
    newcomer.goto(f"{service}/?calculator=crank-planetary")
    settled(newcomer)
    newcomer.locator('[data-choice="lengths"] input[value="diameter"]').check(force=True)
    settled(newcomer)
    newcomer.locator('[data-path="real.on"] input').check()
    newcomer.locator('[data-path="contact.hole_clearance_mm"] .box').fill("0.02")
    newcomer.locator('[data-path="bearings.on"] input').check()
    settled(newcomer)
    expect(newcomer.locator('.shown .mechanism[data-stale="false"]')).to_be_attached()
    texts = newcomer.locator(".shown .drawing .label").all_text_contents()
    labels = {text.replace("\u00a0", " ") for text in texts}
    assert {"2R = 56 mm", "2rin = 16 mm", "2rout = 20.04 mm"} <= labels
    hole = newcomer.locator('[data-path="contact.hole_radius_mm"]')
    expect(hole.locator(".suggest")).to_contain_text("2(rin + e + c)")
    ring = newcomer.locator('[data-path="gear.ring_pin_radius_mm"]')
    expect(ring.locator("label")).to_contain_text("Diameter of the ring's pins")
    link = address(newcomer)
    assert "lengths=diameter" in link
    ring_text = ring.locator(".box").input_value()
    other = newcomer.context.browser.new_context()
    stranger = other.new_page()
    stranger.goto(link)
    settled(stranger)
    expect(stranger.locator('[data-choice="lengths"] input[value="diameter"]')).to_be_checked()
    expect(stranger.locator('[data-path="gear.ring_pin_radius_mm"] .box')).to_have_value(ring_text)
    expect(stranger.locator(".notice")).to_be_hidden()
    other.close()


def test_a_figure_has_a_large_view(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    force = newcomer.locator('[data-figure="force"]')
    expect(force.locator(".main-svg").first).to_be_visible()
    force.scroll_into_view_if_needed()
    place = force.bounding_box()
    button = force.get_by_role("button", name="Large view: Contact forces")
    button.click()
    dialog = newcomer.get_by_role("dialog", name="Contact forces")
    expect(dialog).to_be_visible()
    expect(dialog.locator(".folding")).to_be_disabled()
    newcomer.wait_for_function(
        "() => document.querySelector('.large .main-svg').getBoundingClientRect().width"
        " > 0.9 * innerWidth"
    )
    label = dialog.locator(".xtick text").first.bounding_box()
    assert label and label["height"] > 18
    newcomer.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    expect(button).to_be_focused()
    assert force.bounding_box() == place
    newcomer.locator("h1").hover()
    newcomer.locator('[data-path="mechanism.pins"] .box').focus()
    newcomer.keyboard.press("Alt+l")
    dialog = newcomer.get_by_role("dialog", name="Mechanism")
    expect(dialog.locator(".drawing svg")).to_be_visible()
    drawn = dialog.locator(".drawing svg").bounding_box()
    assert drawn and drawn["height"] > 500
    newcomer.get_by_role("button", name="Close").click()
    expect(newcomer.locator('[data-path="mechanism.pins"] .box')).to_be_focused()
    assert newcomer.evaluate("() => watched.shift") < 0.001
    assert newcomer.evaluate("() => watched.violations") == []


def test_very_many_pins_are_refused_at_once(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    refused: list[str] = []
    newcomer.on("response", lambda answer: refused.append(answer.url) if answer.status > 399 else 0)
    newcomer.locator('[data-path="mechanism.pins"] .box').fill("5000")
    expect(newcomer.locator(".verdict .word")).to_contain_text("Not possible")
    assert refused == []
