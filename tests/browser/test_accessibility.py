"""WCAG 2.2 AA by axe in every calculator and state, and what axe cannot see."""

from collections.abc import Iterator
from typing import Any

import pytest
from axe_playwright_python.base import AXE_SCRIPT
from playwright.sync_api import Browser, Page, expect

from tests.browser.calculator_page import (
    box,
    emptied,
    from_menu,
    open_rows,
    picked,
    settled,
    show,
    tab,
)
from tests.browser.conftest import UNFOLDED

CALCULATORS = {
    "crank-planetary": "load.output_torque_Nm",
    "rollers": "output_torque_Nm",
    "precession": "torque_Nm",
}
IMPOSSIBLE = {
    "mechanism.pins": "50",
    "mechanism.ratio": "29",
    "load.output_torque_Nm": "350",
    "load.pin_circle_radius_mm": "40",
    "contact.contact_length_mm": "10",
    "contact.pin_radius_mm": "6",
    "contact.eccentricity_mm": "2",
}
WANTED = {
    "mechanism.pins": "3",
    "mechanism.ratio": "20",
    "load.output_torque_Nm": "200",
    "load.pin_circle_radius_mm": "40",
    "contact.contact_length_mm": "12",
    "contact.pin_radius_mm": "5",
    "contact.eccentricity_mm": "2",
    "real.on": "on",
    "contact.hole_clearance_mm": "0.03",
    "strength.on": "on",
    "pin.satellite_positions_mm": "9;23",
    "losses.on": "on",
    "friction.coefficient": "0.08",
    "load.input_speed_rpm": "1500",
    "bearings.on": "on",
    "gear.kind": "cycloid",
    "gear.ring_pin_circle_radius_mm": "70",
    "crank.on": "on",
    "crankshaft.satellite_positions_mm": "14;28",
    "crankshaft.bearing_positions_mm": "0;42",
    "crankshaft.satellite_mass_kg": "0.5",
    "study.on": "on",
    "tolerances.hole_position_mm": "0.02",
    "quantities": "peak_force_N",
    "samples": "40",
    "percentiles": "50;90",
    "crank_angles": "12",
}
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
CONTRAST = "color-contrast"
ALL_BUT_CONTRAST = {"runOnly": RULES, "rules": {CONTRAST: {"enabled": False}}}
OPENED = "dialog[open], :popover-open"
DRAWN_MS, LOOKS = 500, 20
"""Until figures are drawn in other colours as a rule, and how often it is looked whether they are:
what is wrong stays so, however slow a machine draws."""


@pytest.fixture
def open_page(browser: Browser) -> Iterator[Page]:
    """A page into which axe may be put: without the policy that forbids foreign scripts."""
    context = browser.new_context(
        viewport={"width": 1440, "height": 900}, bypass_csp=True, reduced_motion="reduce"
    )
    context.add_init_script(f"if (/^http/.test(location.protocol)) {{ {UNFOLDED} }}")
    yield context.new_page()
    context.close()


def violations(page: Page, *changed: str) -> list[str]:
    """Violations that axe finds in a settled state, as parts may be pale while they are drawn.
    Colours take nine tenths of its time: they are checked in the changed part, else in the whole
    page, in the light and the dark theme, where nothing else differs.

    Colours, nine tenths of its time, are looked at in what has changed, else in the whole page: in
    the light and in the dark, where nothing else differs.
    """
    said = _found(page, None, ALL_BUT_CONTRAST)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        said += _found(page, [[part] for part in changed] or None, {"runOnly": [CONTRAST]})
    return said


RUN = """async ([part, options]) => (await axe.run(part ?? document, options)).violations"""


def _found(page: Page, part: Any, options: dict[str, Any]) -> list[str]:
    if not page.evaluate("() => 'axe' in globalThis"):
        page.evaluate(AXE_SCRIPT)
    for _ in range(LOOKS):
        page.wait_for_timeout(DRAWN_MS)
        found = page.evaluate(RUN, [part, options | {"resultTypes": ["violations"]}])
        if not found:
            break
    return [
        f"{each['id']}: {node['target']} {node['failureSummary']}"
        for each in found
        for node in each["nodes"]
    ]


@pytest.mark.parametrize("calculator", CALCULATORS)
def test_axe_finds_nothing(open_page: Page, service: str, calculator: str) -> None:
    page = open_page
    show(page, service, calculator)
    figure = page.locator(".panel > .figure").first
    tab(page, figure.get_attribute("data-figure") or "").click()
    expect(page.locator(".js-plotly-plot").first).to_be_attached()
    page.get_by_role("button", name="Compare").click()
    expect(page.get_by_label("Name of design A")).to_be_attached()
    assert violations(page) == []
    box(page, CALCULATORS[calculator]).fill("x")
    settled(page, "wrong")
    tab(page, figure.get_attribute("data-figure") or "").click()
    figure.locator(".show-table").click()
    assert violations(page, ".answer", ".inputs", "figure:has(.figure-table:not([hidden]))") == []


def test_axe_finds_nothing_in_what_opens(open_page: Page, service: str) -> None:
    page = open_page
    show(page, service, "crank-planetary")
    for name in ("Settings", "New", "Export", "Help"):
        page.get_by_role("button", name=name).click()
        assert violations(page, OPENED) == [], name
        page.keyboard.press("Escape")


OPEN_ALL = "() => document.querySelectorAll('details').forEach((one) => (one.open = true))"


def test_axe_finds_nothing_in_any_other_state(open_page: Page, service: str) -> None:
    page = open_page
    show(page, service, "precession")
    open_rows(page, "rollers")
    assert violations(page, ".inputs") == [], "a list over the centre"
    show(page, service, "crank-planetary")
    from_menu(page, "contact.pin_radius_mm", "Size for")
    expect(page.locator('[data-part="apply"]')).to_be_enabled()
    assert violations(page, OPENED) == [], "sizing"
    page.keyboard.press("Escape")
    for act in ("sweep", "sensitivity"):
        from_menu(page, "contact.pin_radius_mm", act.capitalize())
        explored = page.locator(f'[data-explored="{act}"]')
        expect(explored.locator(".js-plotly-plot, tbody tr").first).to_be_attached()
        assert violations(page, ".shown") == [], act
    box(page, "contact.hole_material").select_option("plastic_pom")
    settled(page)
    assert violations(page, ".answer", ".inputs") == [], "a limit is not known"
    emptied(page)
    settled(page, "incomplete")
    assert violations(page, ".answer", ".inputs", ".shown") == [], "incomplete"
    page.goto(f"{service}/?v=1&foo=1&mechanism.pins=50&mechanism.ratio=20")
    settled(page, "incomplete")
    expect(page.locator(".notice")).to_be_visible()
    assert violations(page, ".notice") == [], "notice"
    show(page, service, "crank-planetary", **IMPOSSIBLE)
    expect(page.locator(".word")).to_contain_text("Impossible")
    assert violations(page, ".answer", ".shown") == [], "not possible"
    page.context.set_offline(True)
    box(page, CALCULATORS["crank-planetary"]).fill("281")
    settled(page, "offline")
    assert violations(page, ".answer") == [], "no service"


SEEN_AND_SAID = """() => [...document.querySelectorAll(":is(button, a, summary)[aria-label]")]
  .map((one) => [one.textContent, one.ariaLabel]
    .map((text) => text.replace(/\\s+/g, "").toLowerCase()))
  .filter(([seen, said]) => /\\p{L}/u.test(seen) && !said.includes(seen))"""


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_a_name_that_is_spoken_holds_what_is_seen(
    open_page: Page, service: str, language: str
) -> None:
    page = open_page
    page.goto(f"{service}/?calculator=crank-planetary&lang={language}")
    settled(page)
    picked(page, "cycloid")
    expect(page.locator(".suggest").last).to_contain_text("rin + e + c")
    assert page.evaluate(SEEN_AND_SAID) == []


@pytest.mark.parametrize(("language", "calculator"), [("uk", "rollers"), ("ru", "precession")])
def test_axe_finds_nothing_in_other_languages(
    open_page: Page, service: str, language: str, calculator: str
) -> None:
    open_page.goto(f"{service}/?calculator={calculator}&lang={language}")
    settled(open_page)
    open_page.evaluate(OPEN_ALL)
    assert _found(open_page, None, ALL_BUT_CONTRAST) == []


@pytest.mark.parametrize("language", ["en", "uk"])
def test_axe_finds_nothing_in_what_was_off_until_wanted(
    open_page: Page, service: str, language: str
) -> None:
    page = open_page
    show(page, service, "crank-planetary", **WANTED, lang=language, units="us")
    tab(page, "real").click()
    expect(page.locator(".real")).to_have_attribute("data-stale", "false")
    tab(page, "study").click()
    page.locator('[data-do="run"]').click()
    expect(page.locator(".study .histogram")).to_be_visible()
    for name in ("strength", "losses", "bearings", "crank"):
        tab(page, name).click()
        expect(page.locator(f"[data-wanted={name}] .js-plotly-plot")).to_be_visible()
        assert _found(page, [[f"#panel-{name}"]], ALL_BUT_CONTRAST) == []
    page.evaluate(OPEN_ALL)
    # all else has been looked at with nothing wanted, in the light and in the dark
    changed = ".answer", ".inputs", "[data-wanted]"
    in_english = language == "en"
    assert (
        violations(page, *changed) if in_english else _found(page, None, ALL_BUT_CONTRAST)
    ) == []
    for width in (390, 320):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth"), width


@pytest.mark.parametrize("calculator", CALCULATORS)
def test_four_times_enlarged_nothing_is_cut_off(
    open_page: Page, service: str, calculator: str
) -> None:
    # 400 % of 1280 x 1024 leaves 320 x 256 points.
    open_page.set_viewport_size({"width": 320, "height": 256})
    show(open_page, service, calculator)
    assert open_page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
    covered = open_page.evaluate(
        "() => [...document.querySelectorAll('.bar, .verdict, .inputs')]"
        ".filter((part) => ['sticky', 'fixed'].includes(getComputedStyle(part).position))"
        ".reduce((sum, part) => sum + Math.min(part.offsetHeight, innerHeight), 0) / innerHeight"
    )
    assert covered <= 0.5  # what sticks leaves room for what is read


@pytest.mark.parametrize("calculator", CALCULATORS)
def test_every_control_is_reached_by_the_tab_key(
    open_page: Page, service: str, calculator: str
) -> None:
    show(open_page, service, calculator)
    wanted = open_page.evaluate(
        "() => [...document.querySelectorAll('button, input, select, summary, [tabindex=\"0\"]')]"
        ".filter((each) => !each.disabled && each.tabIndex >= 0 && each.checkVisibility()"
        " && !each.closest('[popover]:not(:popover-open), dialog:not([open])')"
        " && !(each.type === 'radio' && !each.checked)"
        " && each.id !== 'results').map((each, i) => (each.dataset.wanted = i))"
    )
    reached = set()
    for _ in range(3 * len(wanted)):
        open_page.keyboard.press("Tab")
        here = open_page.evaluate("() => document.activeElement.dataset.wanted ?? null")
        if here is not None:
            reached.add(int(here))
            seen = open_page.evaluate(
                "() => { const box = document.activeElement.getBoundingClientRect();"
                " return box.bottom > 0 && box.top < innerHeight }"
            )
            assert seen
    assert reached == set(wanted)
