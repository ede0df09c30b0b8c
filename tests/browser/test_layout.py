"""Layout: three columns as high as the screen, tabs, the rail, one part at a time."""

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Locator, Page, Request, expect

from tests.browser.calculator_page import address, opened, picked, settled
from tests.browser.conftest import WATCH_SCRIPT
from tests.inputs import chromium


@pytest.fixture
def newcomer(browser: Browser) -> Iterator[Page]:
    """A page of somebody who has closed the sheet on which designs begin, and done nothing else."""
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    context.add_init_script(f"{WATCH_SCRIPT}; {chromium.MET}")
    yield context.new_page()
    context.close()


def scrolls(page: Page) -> bool:
    """True if there is more of the page than the screen shows."""
    return page.evaluate(
        "() => document.documentElement.scrollHeight > innerHeight"
        " || document.documentElement.scrollWidth > innerWidth"
    )


def tab(page: Page, name: str) -> Locator:
    return page.locator(".strip").get_by_role("tab", name=name, exact=True)


@pytest.mark.parametrize("size", [(1440, 900), (1280, 720), (1024, 768)])
def test_the_page_is_as_high_as_the_screen(
    newcomer: Page, service: str, size: tuple[int, int]
) -> None:
    width, tall = size
    newcomer.set_viewport_size({"width": width, "height": tall})
    newcomer.goto(service)
    settled(newcomer)
    assert not scrolls(newcomer)
    assert newcomer.evaluate("() => watched.shift") < 0.001
    picked(newcomer, "cycloid")
    settled(newcomer)
    assert not scrolls(newcomer)
    right = newcomer.locator(".right").bounding_box()
    chips = newcomer.locator(".parts button:visible")
    edges = chips.evaluate_all("all => all.map((one) => one.getBoundingClientRect().right)")
    assert len(edges) > 7 and max(edges) < right["x"] + right["width"]
    centre = newcomer.locator(".shown").bounding_box()
    folds = newcomer.locator(".rest > details")
    expect(folds).to_have_count(2)
    assert centre["x"] + centre["width"] <= right["x"]
    assert right["y"] + right["height"] <= folds.first.bounding_box()["y"]
    if width >= 1280:
        inputs = newcomer.locator(".inputs").bounding_box()
        assert inputs["x"] + inputs["width"] <= centre["x"]
    expect(newcomer.locator(".drawing svg").first).to_be_visible()
    # On a low screen the drawing shares its box with the figures.
    tab(newcomer, "Forces").click()
    expect(newcomer.locator('[data-figure="force"] .main-svg').first).to_be_visible()
    expect(newcomer.locator("#panel-drawing")).to_be_visible(visible=tall >= 800)
    newcomer.locator(".worked > summary").click()
    assert scrolls(newcomer)  # the two folds stand below


def test_a_figure_is_asked_for_when_its_tab_is_open(newcomer: Page, service: str) -> None:
    charts: list[str] = []

    def take(request: Request) -> None:
        if request.url.split("?")[0].endswith("/chart"):
            charts.append(request.url)

    newcomer.on("request", take)
    newcomer.goto(service)
    settled(newcomer)
    assert len(charts) == 1
    tab(newcomer, "Forces").press("End")
    expect(tab(newcomer, "Designs side by side")).to_be_focused()
    assert len(charts) == 1
    tab(newcomer, "Cyclogram").click()
    expect(newcomer.locator('[data-figure="cyclogram"] .main-svg').first).to_be_visible()
    assert len(charts) == 2
    newcomer.reload()
    settled(newcomer)
    expect(tab(newcomer, "Cyclogram")).to_have_attribute("aria-selected", "true")
    newcomer.locator('[data-path="losses.on"] input').check()
    expect(tab(newcomer, "Losses")).to_have_attribute("aria-selected", "true")
    expect(newcomer.locator('[data-wanted="losses"] .figures').first).to_be_visible()


def test_inputs_are_an_outline_that_is_searched(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    group = newcomer.locator("[data-group]")
    opened_now = newcomer.locator(".section[open]")
    expect(opened_now).to_have_count(1)
    pins = group.locator("xpath=self::*[@data-group='pins']")
    expect(pins.locator(".values")).to_have_text("3 pins Ø16 on Ø56")
    expect(pins.locator(".mark")).to_contain_text("✓")
    pins.locator("summary").first.click()
    expect(opened_now).to_have_count(1)
    expect(newcomer.locator('[data-path="mechanism.pins"] .box')).to_be_visible()
    # what is left empty and taken as usual stands in its box, and looks so
    assumed = newcomer.locator('[data-path="requirements.life_h"]')
    expect(assumed).to_have_attribute("data-origin", "usual")
    expect(assumed.locator(".box")).to_have_attribute("placeholder", "5000")
    expect(assumed.locator(".box")).to_have_value("")
    usual = newcomer.locator('[data-path="mechanism.satellites"]')
    expect(usual).to_have_attribute("data-origin", "usual")
    newcomer.locator("h1").click()
    newcomer.keyboard.press("/")
    newcomer.keyboard.type("K_A")
    expect(newcomer.locator(".search li").first).to_contain_text("Application factor")
    newcomer.keyboard.press("Enter")
    expect(newcomer.locator('[data-path="load.application_factor"] .box')).to_be_focused()
    expect(opened_now).to_have_count(1)
    newcomer.keyboard.press("Control+a")
    newcomer.keyboard.type("-1")
    expect(newcomer.locator('[data-group="load"] .mark')).to_contain_text("✕")
    newcomer.get_by_role("button", name="All open").click()
    expect(opened_now).to_have_count(group.count())


def test_below_800_px_one_part_is_in_sight(newcomer: Page, service: str) -> None:
    newcomer.set_viewport_size({"width": 390, "height": 844})
    newcomer.goto(service)
    settled(newcomer)
    parts = {"Inputs": ".inputs", "Drawing": ".shown", "Checks": ".answer", "More": ".rest"}
    for name, part in parts.items():
        newcomer.locator(".places").get_by_role("button", name=name, exact=True).click()
        for one in parts.values():
            expect(newcomer.locator(one)).to_be_visible(visible=one == part)
        expect(newcomer.locator(".verdict .word")).to_be_in_viewport()
        assert newcomer.evaluate("() => document.documentElement.scrollWidth") == 390
    newcomer.locator(".places").get_by_role("button", name="Checks", exact=True).click()
    newcomer.locator(".check .link").first.click()
    expect(newcomer.locator(".inputs")).to_be_visible()


def test_between_800_and_1280_px_inputs_fold_to_a_rail(newcomer: Page, service: str) -> None:
    newcomer.set_viewport_size({"width": 1024, "height": 768})
    newcomer.goto(service)
    settled(newcomer)
    expect(newcomer.locator(".inputs")).to_be_hidden()
    newcomer.locator(".places").get_by_role("button", name="Inputs").click()
    expect(newcomer.locator('[data-path="mechanism.ratio"] .box')).to_be_visible()
    newcomer.keyboard.press("Escape")
    expect(newcomer.locator(".inputs")).to_be_hidden()


def test_the_drawing_has_its_forces_where_their_figure_is_not_open(
    newcomer: Page, service: str
) -> None:
    newcomer.goto(service)
    settled(newcomer)
    tab(newcomer, "Cyclogram").click()
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
    assert not scrolls(newcomer)


def test_diameters_are_diameters_everywhere_and_in_the_link(newcomer: Page, service: str) -> None:
    newcomer.goto(f"{service}/?calculator=crank-planetary")
    settled(newcomer)
    newcomer.get_by_role("button", name="All open").click()
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
    expect(ring.locator("label")).to_contain_text("Diameter of ring pins")  # in short
    expect(ring.locator("label")).to_have_attribute(
        "title", re.compile("^Diameter of the ring's pins: ")
    )
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
    newcomer.locator('[data-path="mechanism.ratio"] .box').focus()
    newcomer.keyboard.press("Alt+l")
    dialog = newcomer.get_by_role("dialog", name="Mechanism")
    expect(dialog.locator(".drawing svg")).to_be_visible()
    drawn = dialog.locator(".drawing svg").bounding_box()
    assert drawn and drawn["height"] > 500
    newcomer.get_by_role("button", name="Close").click()
    expect(newcomer.locator('[data-path="mechanism.ratio"] .box')).to_be_focused()
    assert newcomer.evaluate("() => watched.shift") < 0.001
    assert newcomer.evaluate("() => watched.violations") == []


def test_very_many_pins_are_refused_at_once(newcomer: Page, service: str) -> None:
    newcomer.goto(service)
    settled(newcomer)
    refused: list[str] = []
    newcomer.on("response", lambda answer: refused.append(answer.url) if answer.status > 399 else 0)
    newcomer.locator('[data-group="pins"] summary').first.click()
    newcomer.locator('[data-path="mechanism.pins"] .box').fill("5000")
    expect(newcomer.locator(".verdict .word")).to_contain_text("Impossible")
    assert refused == []
