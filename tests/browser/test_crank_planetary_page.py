"""The crank-planetary calculator as its user sees it: effects, not presence."""

import re
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import Any

import httpx
import pytest
from playwright.sync_api import Error, Locator, Page, Route, expect

from core.precision import JUDGED
from tests.browser.calculator_page import (
    address,
    asks_results,
    emptied,
    number,
    picked,
    result,
    tab,
)

ZYL = {
    "mechanism.pins": "6",
    "mechanism.satellites": "1",
    "mechanism.ratio": "20",
    "load.output_torque_Nm": "50",
    "load.pin_circle_radius_mm": "32.5",
    "load.force_exponent": "0",
    "contact.contact_length_mm": "20",
    "contact.pin_radius_mm": "5",
    "contact.hole_radius_mm": "6.5",
}
DEAD = ZYL | {"mechanism.pins": "2"}


TYPE = """([path, texts]) => {
  const box = document.querySelector(`[data-path="${path}"] .box`);
  for (const text of texts) {
    box.value = text;
    box.dispatchEvent(new Event("input", { bubbles: true }));
  }
}"""


def query(fields: dict[str, str]) -> str:
    return str(httpx.QueryParams({"calculator": "crank-planetary", "v": "2"} | fields))


def show(
    page: Page, service: str, fields: dict[str, str] | None = None, state: str = "fresh"
) -> None:
    """Open the page (with these inputs) and wait until it has computed."""
    page.goto(f"{service}/?{query(fields)}" if fields else service)
    settled(page, state)


def settled(page: Page, state: str = "fresh") -> None:
    expect(page.locator("#panel")).to_have_attribute("data-state", state)
    expect(page.locator("#panel .outputs > .rest")).to_be_attached()


def box(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .box')


def option(page: Page, choice: str, name: str) -> Locator:
    return page.locator(f'[data-choice="{choice}"] input[value="{name}"]')


def add_digits(page: Page, path: str, digits: str) -> None:
    box(page, path).press("End")
    box(page, path).press_sequentially(digits)


def words_at(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .field-message')


def peak_cell(page: Page) -> Locator:
    return page.locator(".summary .cell").first.locator(".figures")


def asked_from(page: Page) -> list[dict[str, Any]]:
    """Bodies of the questions for results from here on, as they are sent."""
    bodies: list[dict[str, Any]] = []
    page.on(
        "request",
        lambda request: bodies.append(request.post_data_json) if asks_results(request) else None,
    )
    return bodies


def change(page: Page, action: Callable[[], object]) -> None:
    """Do something to the inputs and wait for the numbers of the new ones."""
    with page.expect_response(lambda response: asks_results(response.request) and response.ok):
        action()
    settled(page)


def test_opens_with_a_computed_example(page: Page, service: str) -> None:
    show(page, service)
    naming = page.get_by_label("Name of the design")
    first = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"][0]
    body = first["input"] | {"include": ["cyclogram", "contact_force", "hertz"]}
    answer = httpx.post(f"{service}/api/v1/crank-planetary", json=body, trust_env=False).json()
    force = answer["contact_force"]
    assert result(page, "peak_force_N") == pytest.approx(force["peak_force_N"], rel=JUDGED)
    assert result(page, "max_pressure_MPa") == pytest.approx(
        answer["hertz"]["max_pressure_MPa"], rel=JUDGED
    )
    expect(naming).to_have_attribute("placeholder", first["title"])
    pairs = first["input"]["mechanism"]["pins"] * first["input"]["mechanism"]["satellites"]
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line')).to_have_count(pairs + 1)
    tab(page, "cyclogram").click()
    expect(page.locator('[data-figure="cyclogram"] .barlayer path').first).to_be_visible()


def test_the_number_of_the_paper(page: Page, service: str) -> None:
    show(page, service, ZYL)
    assert result(page, "peak_force_N") == pytest.approx(888.231, abs=5e-4)
    expect(peak_cell(page)).to_have_text("888.2")
    expect(peak_cell(page)).to_have_attribute("title", re.compile(r"^888\.23118"))
    change(page, lambda: box(page, "mechanism.pins").fill("4"))
    assert result(page, "peak_force_N") == pytest.approx(1538.46, abs=5e-3)


def test_typing_changes_numbers_and_figures(page: Page, service: str) -> None:
    show(page, service, ZYL)
    lines = page.locator('[data-figure="force"] .scatterlayer .js-line')
    expect(lines).to_have_count(7)  # the pairs, and the largest force
    change(page, lambda: add_digits(page, "load.output_torque_Nm", "0"))
    assert result(page, "peak_force_N") == pytest.approx(8882.31, abs=5e-3)
    change(page, lambda: box(page, "mechanism.pins").fill("5"))
    expect(lines).to_have_count(6)


def test_every_way_to_write_a_number(page: Page, service: str) -> None:
    show(page, service, ZYL)
    radius = box(page, "load.pin_circle_radius_mm")
    for typed in ("65,0", "65.0", "6.5e1", "0,065e3"):
        change(page, partial(radius.fill, "32.5"))
        change(page, partial(radius.fill, typed))
        assert result(page, "peak_force_N") == pytest.approx(888.2307692 / 2, rel=JUDGED)
        expect(radius).to_have_value(typed)


def test_thousands_commas_are_refused_with_words_and_kept(page: Page, service: str) -> None:
    show(page, service, ZYL)
    expect(page.locator(".verdict .torque .sought")).to_have_count(0)
    asked = asked_from(page)
    torque = box(page, "load.output_torque_Nm")
    torque.fill("1,000.5")
    settled(page, "wrong")
    expect(words_at(page, "load.output_torque_Nm")).to_contain_text("One decimal sign")
    expect(torque).to_have_attribute("aria-invalid", "true")
    described = torque.get_attribute("aria-describedby") or ""
    assert words_at(page, "load.output_torque_Nm").get_attribute("id") in described.split()
    expect(page).to_have_url(re.compile(r"output_torque_Nm=1%2C000\.5"))
    assert asked == [], "nothing is asked with a box that cannot be read"
    page.reload()
    expect(torque).to_have_value("1,000.5")
    change(page, lambda: torque.fill("50"))
    expect(words_at(page, "load.output_torque_Nm")).not_to_contain_text("One decimal sign")
    assert torque.get_attribute("aria-invalid") is None


def test_the_services_words_stand_at_the_box_they_mean(page: Page, service: str) -> None:
    show(page, service, ZYL)
    hole = box(page, "contact.hole_radius_mm")
    hole.fill("4")
    settled(page, "wrong")
    expect(hole).to_have_attribute("aria-invalid", "true")
    expect(words_at(page, "contact.hole_radius_mm")).to_contain_text("larger")
    expect(hole).to_have_value("4")
    # What does not need the wrong box is still there, and of the inputs on the screen.
    assert result(page, "peak_force_N") == pytest.approx(888.231, abs=5e-4)
    expect(page.locator('[data-section="hertz"]')).to_contain_text("Not computed")
    change(page, lambda: hole.fill("6.5"))
    assert hole.get_attribute("aria-invalid") is None


def test_a_list_of_the_wrong_length_is_said_at_the_list(page: Page, service: str) -> None:
    show(page, service, ZYL | {"mechanism.satellites": "2"})
    change(page, lambda: option(page, "cranks", "list").check())
    angles = box(page, "mechanism.crank_angles_deg")
    expect(angles).to_have_value("0; 180")
    expect(box(page, "mechanism.crank_spacing_deg")).not_to_be_visible()
    angles.fill("0; 90; 180")
    settled(page, "wrong")
    expect(angles).to_have_attribute("aria-invalid", "true")
    change(page, lambda: angles.fill("0; 90"))


def test_a_dead_centre_is_a_cyclogram_and_words(page: Page, service: str) -> None:
    show(page, service, DEAD, state="refused")
    expect(page.locator(".say")).to_contain_text(re.compile("transmit", re.IGNORECASE))
    expect(page.locator(".summary .cell.bad").first).to_contain_text("none at")
    expect(page.locator('[data-figure="force"] .figure-message')).to_be_visible()
    tab(page, "cyclogram").click()
    expect(page.locator('[data-figure="cyclogram"] .barlayer path').first).to_be_visible()
    assert "∞" not in page.inner_text("body") and "NaN" not in page.inner_text("body")


FITTED = ZYL | {"contact.eccentricity_mm": "1.5"}


def test_nothing_is_called_safe_whose_limit_is_not_known(page: Page, service: str) -> None:
    """A limit is entered where the page asks for it; then, and only then, there is a safety."""
    show(page, service, FITTED | {"contact.hole_material": "plastic_pom"})
    strip, checks = page.locator(".verdict"), page.locator(".checks")
    expect(strip.locator(".word")).to_have_text(re.compile("Incomplete"))
    assert "✓" not in strip.inner_text() and "afety" not in page.locator(".summary").inner_text()
    unknown = checks.locator('[data-code="contact_pressure_hole"]')
    expect(unknown).to_have_attribute("data-status", "not_checked")
    assert page.locator('.results [data-name="safety_factor"]').count() == 0
    expect(words_at(page, "contact.hole_material")).to_contain_text("strength 61 (61–67)\u00a0MPa")
    expect(words_at(page, "contact.pin_material")).to_contain_text("1500\u00a0MPa (endurance: ISO")
    change(page, option(page, "contact.hole_material", "own").check)
    change(page, lambda: box(page, "contact.hole_material.allowable_pressure_MPa").fill("400"))
    expect(unknown).not_to_have_attribute("data-status", "not_checked")
    own = result(page, "safety_factor")
    assert own == pytest.approx(400 / result(page, "governing_pressure_MPa"), rel=1e-4)


def test_what_cannot_be_built_is_red_with_the_reason(page: Page, service: str) -> None:
    show(page, service, FITTED)
    page.get_by_role("button", name="Compare").click()
    for path, text, code in (
        ("contact.hole_radius_mm", "6.47", "interference"),
        ("mechanism.pins", "18", "wall_holes"),
        ("mechanism.pins", "50", "pins_apart"),
    ):
        change(page, partial(box(page, path).fill, text))
        cannot_be_built(page, code)
        change(page, partial(box(page, path).fill, FITTED[path]))
        expect(page.locator("#panel")).not_to_have_attribute("data-impossible", "true")


def cannot_be_built(page: Page, code: str) -> None:
    expect(page.locator(".verdict .word.bad")).to_contain_text("Impossible")
    expect(page.locator("#panel")).to_have_attribute("data-impossible", "true")
    expect(page.locator(f'.check[data-code="{code}"]')).to_have_attribute("data-status", "fail")
    assert "✓" not in page.locator(".verdict").inner_text()
    assert page.locator('.results [data-name="safety_factor"]').count() == 0
    compared = page.locator(".compare")
    expect(compared.locator("tbody tr").first).to_contain_text("Impossible")
    row = compared.locator("tbody tr").filter(has_text=re.compile("^Safety factor"))
    expect(row.locator("td").first).to_have_text("–")
    assert number(row.locator("td").nth(1).inner_text()) > 0


def test_other_options_start_from_the_same_design(page: Page, service: str) -> None:
    show(page, service, ZYL)
    change(page, lambda: option(page, "ratio", "teeth").check())
    change(page, lambda: option(page, "torque", "input").check())
    own = option(page, "contact.pin_material", "own")
    pressure = result(page, "max_pressure_MPa")
    change(page, own.check)
    assert result(page, "peak_force_N") == pytest.approx(888.231, abs=5e-4)
    assert result(page, "max_pressure_MPa") == pressure
    assert (
        page.locator('[data-section="cyclogram"] table.data').first.text_content().count("yes") >= 1
    )


def test_spacing_and_hole_follow_until_typed(page: Page, service: str) -> None:
    show(page, service, ZYL | {"mechanism.satellites": "4", "contact.eccentricity_mm": "1.5"})
    spacing = page.locator('[data-path="mechanism.crank_spacing_deg"]')
    assert spacing.locator(".box").get_attribute("placeholder") == "90"
    hole = page.locator('[data-path="contact.hole_radius_mm"]')
    expect(hole.locator(".box")).to_have_value("")  # 6.5 is what it would be
    expect(hole.locator(".suggest")).to_have_attribute("aria-pressed", "true")
    change(page, lambda: box(page, "contact.pin_radius_mm").fill("Ø12"))
    assert hole.locator(".box").get_attribute("placeholder") == "7.5"
    change(page, lambda: hole.locator(".box").fill("7,53"))
    expect(hole.locator(".suggest")).to_have_attribute("aria-pressed", "false")
    expect(words_at(page, "contact.hole_radius_mm")).to_contain_text("radial clearance 0.03")
    change(page, hole.locator(".suggest").click)
    expect(hole.locator(".box")).to_have_value("")


def test_radii_are_typed_as_diameters_where_chosen(page: Page, service: str) -> None:
    show(page, service, ZYL)
    force = result(page, "peak_force_N")
    page.locator('[data-choice="lengths"] input[value="diameter"]').check(force=True)
    settled(page)
    expect(page.locator('[data-choice="lengths"] input[value="diameter"]')).to_be_focused()
    expect(box(page, "load.pin_circle_radius_mm")).to_have_value("65")
    assert result(page, "peak_force_N") == force
    page.locator('[data-choice="lengths"] input[value="radius"]').check(force=True)
    expect(box(page, "load.pin_circle_radius_mm")).to_have_value("32.5")


def test_a_design_of_ones_own_from_an_empty_form(page: Page, service: str) -> None:
    """New clears and asks, with no number of the design before; Undo and Back lead to that."""
    show(page, service, ZYL)
    page.get_by_role("button", name="Compare").click()
    emptied(page)
    settled(page, "incomplete")
    expect(box(page, "mechanism.pins")).not_to_have_value("6")
    for figures in page.locator(".summary .figures").all():
        expect(figures).to_have_text("–")
    expect(page.locator(".plain-words li, .drawing svg, .check, .js-line")).to_have_count(0)
    expect(page.locator(".field.wrong")).to_have_count(0)
    tab(page, "force").click()
    expect(page.locator(".figure-message:visible")).to_have_count(1)
    tab(page, "compare").click()
    expect(page.locator(".compare-table").get_by_role("button", name="Open")).to_be_visible()
    expect(page.locator(".say")).to_contain_text("Still needed")
    # The formula stands typeset on its button only.
    expect(box(page, "contact.hole_radius_mm")).to_have_attribute("placeholder", "")
    page.get_by_role("button", name="Undo").click()
    settled(page)
    expect(box(page, "mechanism.pins")).to_have_value("6")
    emptied(page)
    settled(page, "incomplete")
    page.go_back()
    settled(page)
    expect(box(page, "mechanism.pins")).to_have_value("6")


def test_what_is_typed_on_a_phone_keeps_its_place_while_it_computes(
    page: Page, service: str
) -> None:
    """The first answer of a design from an empty form: nothing is hidden, no key goes astray."""
    page.set_viewport_size({"width": 390, "height": 844})
    show(page, service)
    page.locator('.places [data-place="inputs"]').click()
    emptied(page)
    settled(page, "incomplete")
    for path, text in ZYL.items():
        if path not in ("contact.contact_length_mm", "load.force_exponent"):
            box(page, path).fill(text)
    held: list[Route] = []
    page.route("**/api/v1/crank-planetary", lambda route: held.append(route))
    length = box(page, "contact.contact_length_mm")
    length.press_sequentially("1")
    settled(page, "computing")
    expect(length).to_be_focused()
    expect(length).to_be_visible()
    page.keyboard.type("6")
    expect(length).to_have_value("16")
    page.unroute("**/api/v1/crank-planetary")
    for route in held:
        with suppress(Error):  # what is asked anew is taken back
            route.continue_()
    settled(page)
    # The sentence of a plastic leaves the form its room.
    box(page, "contact.hole_clearance_mm").fill("0.1")
    box(page, "contact.hole_radius_mm").fill("")
    box(page, "contact.eccentricity_mm").fill("1.5")
    box(page, "contact.hole_material").select_option("plastic_pla_printed")
    expect(page.locator(".verdict .cold")).to_contain_text("May yield at once above")
    assert page.locator(".verdict").bounding_box()["height"] < 844 / 3


def test_a_link_with_something_unknown_says_so(page: Page, service: str) -> None:
    fields = httpx.QueryParams(ZYL | {"v": "9", "foo": "1"})
    page.goto(f"{service}/?calculator=crank-planetary&{fields}")
    settled(page)
    expect(page.locator(".notice")).to_contain_text("v=9, foo")
    expect(box(page, "load.output_torque_Nm")).to_have_value("50")


def test_a_verdict_that_has_moved_is_said(page: Page, service: str) -> None:
    show(page, service)
    link = address(page)
    assert link.endswith("&verdict=incomplete")
    notice = page.locator(".notice")
    expect(notice).to_be_hidden()
    page.goto(link.replace("verdict=incomplete", "verdict=fail"))
    expect(notice).to_contain_text("the verdict was “Fails”; it is now “Incomplete”")
    page.get_by_role("button", name="Compare").click()
    page.evaluate(
        "() => { const kept = JSON.parse(localStorage['khv-calc.designs']);"
        " kept[0].results.verdict = 'fail';"
        " localStorage['khv-calc.designs'] = JSON.stringify(kept); }"
    )
    page.goto(link)
    tab(page, "compare").click()
    verdict = page.locator(".compare-table").get_by_role("row", name="Verdict")
    expect(verdict).to_contain_text("when kept: Fails")
    expect(notice).to_be_hidden()
    page.get_by_role("button", name="Open design A").click()
    expect(notice).to_contain_text("it is now “Incomplete”")
    held: list[Route] = []
    page.route("**/api/v1/crank-planetary", lambda route: held.append(route))  # never answered
    page.goto(link.replace("&verdict=incomplete", "").replace("v=2", "v=1") + "&lang=uk")
    expect(notice).to_contain_text("Посилання створено попередньою версією")
    notice.get_by_role("button").click()  # before there is any answer
    expect(notice).to_be_hidden()


def test_what_a_check_misses_is_a_click_away(page: Page, service: str) -> None:
    show(page, service)
    page.locator(".verdict .unknown").click()  # the first part that is not known has no pins
    expect(box(page, "pin.support")).to_be_focused()
    change(page, page.get_by_role("button", name="Undo").click)
    change(page, lambda: box(page, "contact.hole_material").select_option("plastic_pom"))
    page.locator(".verdict .unknown").click()
    expect(page.get_by_role("button", name="Temperature of the satellites")).to_be_focused()
    page.get_by_role("button", name="Allowable pressure").click()
    limit = box(page, "contact.hole_material.allowable_pressure_MPa")
    expect(limit).to_be_focused()
    expect(box(page, "contact.hole_material.name")).to_have_value("plastic_pom")
    limit.fill("80")
    settled(page)
    expect(page.locator(".word")).to_contain_text("Fails")
    page.locator(".checks .apart > summary").click()
    page.locator('[data-ask="mechanism.satellite_teeth"]').click()
    expect(box(page, "mechanism.satellite_teeth")).to_be_focused()


def test_what_is_missing_of_a_printed_drive_is_a_click_away(page: Page, service: str) -> None:
    """A name without Poisson's ratio, and friction, in a group that is off, are asked for."""
    show(page, service, FITTED)
    petg = words_at(page, "contact.hole_material")
    box(page, "contact.hole_material").select_option("plastic_petg_printed")
    expect(petg).to_contain_text("“Poisson's ratio”: is needed beside the name")
    expect(page.locator(".word")).to_have_text("Input incomplete")
    expect(page.locator(".field.wrong")).to_have_count(0)
    petg.get_by_role("button", name="Poisson's ratio").click()
    expect(box(page, "contact.hole_material.poissons_ratio")).to_be_focused()
    expect(box(page, "contact.hole_material.name")).to_have_value("plastic_petg_printed")
    change(page, lambda: page.keyboard.type("0.38"))
    page.get_by_role("button", name="Friction coefficient").click()
    expect(box(page, "friction.coefficient")).to_be_focused()
    expect(box(page, "friction.coefficient")).to_have_value("")  # no usual value of a plastic
    change(page, lambda: page.keyboard.type("0.4"))
    page.get_by_role("button", name="Yield strength").click()
    change(page, lambda: page.keyboard.type("44"))
    expect(page.locator(".verdict .cold")).to_contain_text("May yield at once above")
    page.locator('[data-part="pins"]').click()
    expect(box(page, "pin.support")).to_be_focused()


def test_two_tabs_share_what_is_kept(page: Page, service: str) -> None:
    show(page, service, ZYL)
    other = page.context.new_page()
    show(other, service, ZYL | {"mechanism.pins": "7"})
    page.get_by_role("button", name="Compare").click()
    expect(other.locator(".compare thead input")).to_have_count(1)
    other.get_by_role("button", name="Compare").click()
    expect(page.locator(".compare thead input")).to_have_count(2)
    other.close()


def test_an_example_picked_fills_the_form(page: Page, service: str) -> None:
    show(page, service)
    examples = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"]
    zyl = next(one for one in examples if "888" in one["title"])
    change(page, lambda: picked(page, zyl["id"]))
    expect(box(page, "mechanism.pins")).to_have_value("6")
    naming = page.get_by_label("Name of the design")
    expect(naming).to_have_attribute("placeholder", zyl["title"])
    expect(naming).to_have_attribute("title", f"Source: {zyl['source']}")
    change(page, lambda: box(page, "mechanism.pins").fill("7"))
    expect(naming).to_have_attribute("placeholder", "Unnamed design")


def test_a_whole_reducer_picked_shows_all_its_sections(page: Page, service: str) -> None:
    """The page sends the request of the example and shows equal checks and values."""
    show(page, service)
    examples = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"]
    whole = next(one for one in examples if one["id"] == "whole")
    wanted = httpx.post(
        f"{service}/api/v1/{whole['calculation']}",
        json=whole["input"] | {"include": ["checks"]},
        trust_env=False,
    ).json()
    with page.expect_response(
        lambda response: (
            response.url.endswith(whole["calculation"])
            and "crankshaft" in response.request.post_data_json["include"]
        )
    ) as caught:
        change(page, lambda: picked(page, "whole"))
    answer = caught.value.json()
    assert answer["checks"] == wanted["checks"]
    assert answer["verdict"] == wanted["verdict"] == "incomplete"  # the teeth are open
    for group in ("strength", "losses", "bearings", "crank"):
        expect(tab(page, group)).to_be_visible()
    asked = page.locator(".checks [data-ask]").evaluate_all(
        "all => all.map((one) => one.dataset.ask)"
    )
    assert len(asked) == len(set(asked)) > 0  # each field at the first check that lacks it
    expect(page.get_by_label("Name of the design")).to_have_attribute("placeholder", whole["title"])


def test_the_address_reopened_gives_the_same_numbers(page: Page, service: str) -> None:
    show(page, service)
    change(page, lambda: box(page, "mechanism.pins").fill("5"))
    change(page, lambda: box(page, "load.pin_circle_radius_mm").fill("41,5"))
    change(page, lambda: option(page, "cranks", "list").check())
    change(page, lambda: box(page, "mechanism.crank_angles_deg").fill("0; 100,5"))
    numbers = page.locator(".results .value").all_text_contents()
    link = address(page)
    assert "mechanism.crank_angles_deg=0%3B100.5" in link and "force_exponent" not in link
    page.goto("about:blank")
    page.goto(link)
    settled(page)
    assert page.locator(".results .value").all_text_contents() == numbers
    assert address(page) == link


def test_stale_numbers_are_greyed_and_late_answers_dropped(page: Page, service: str) -> None:
    show(page, service, ZYL)
    release: list[Route] = []

    def hold(route: Route) -> None:
        if '"pins":9' in (route.request.post_data or ""):
            release.append(route)
        else:
            route.continue_()

    page.route("**/api/v1/crank-planetary", hold)
    shade = "() => getComputedStyle(document.querySelector('.results .value')).color"
    fresh = page.evaluate(shade)
    with page.expect_request(lambda request: '"pins":9' in (request.post_data or "")):
        box(page, "mechanism.pins").fill("9")
    settled(page, "computing")
    page.wait_for_function(f"(fresh) => ({shade})() !== fresh", arg=fresh)
    change(page, lambda: box(page, "mechanism.pins").fill("4"))
    with suppress(Error):  # The browser may have given the request up already.
        release[0].continue_()
    page.wait_for_timeout(200)
    assert result(page, "peak_force_N") == pytest.approx(1538.46, abs=5e-3)


def test_no_tick_stays_green_beside_a_wrong_input(page: Page, service: str) -> None:
    page.goto(service)
    tick = page.locator(".chip .mark.good").first
    expect(tick).to_be_visible()
    colour = "e => getComputedStyle(e).color"
    green = tick.evaluate(colour)
    box(page, "mechanism.pins").fill("0")
    settled(page, "wrong")
    assert tick.evaluate(colour) == page.locator(".numbers *").first.evaluate(colour) != green


def test_controls_wait_for_the_first_answer(page: Page, service: str) -> None:
    show(page, service, ZYL | {"mechanism.pins": "0"}, state="wrong")
    controls = page.locator(
        ".motion button, .motion input, .motion select, .mechanism .save, "
        '[data-figure="force"] .figure-tools button'
    )
    assert controls.count() == 11
    for control in controls.all():
        expect(control).to_be_disabled()
    expect(page.locator(".verdict .judged")).to_contain_text("nothing computed yet")
    change(page, lambda: box(page, "mechanism.pins").fill("6"))
    for control in controls.all():
        expect(control).to_be_enabled()
    box(page, "mechanism.pins").fill("0")
    settled(page, "wrong")
    expect(page.locator(".verdict .judged")).to_contain_text("numbers are of older inputs")
    for control in controls.all():
        expect(control).to_be_enabled()


def test_typing_quickly_asks_once(page: Page, service: str) -> None:
    show(page, service, ZYL)
    asked = asked_from(page)
    texts = ["5", "50", "500", "5000", "50000"]
    change(page, lambda: page.evaluate(TYPE, ["load.output_torque_Nm", texts]))
    assert result(page, "peak_force_N") == pytest.approx(888230.77, rel=JUDGED)
    assert [body["load"]["output_torque_Nm"] for body in asked] == [50000]


def test_enter_does_not_wait(page: Page, service: str) -> None:
    show(page, service, ZYL)
    waiting = asked_from(page)
    page.evaluate("() => { globalThis.setTimeout = () => 0; }")  # no pause comes to its end
    page.evaluate(TYPE, ["mechanism.pins", ["8"]])
    page.wait_for_timeout(300)
    assert waiting == []
    with page.expect_request(asks_results) as asked:
        box(page, "mechanism.pins").press("Enter")
    assert asked.value.post_data_json["mechanism"]["pins"] == 8


def test_only_what_is_shown_is_asked(page: Page, service: str) -> None:
    show(page, service, ZYL)
    toggle = page.locator('[data-figure="force"] .show-table')
    with page.expect_request(lambda each: "curves" in (each.post_data or "")) as asked:
        change(page, toggle.click)
    body = asked.value.post_data_json
    assert "curves" in body["load"]["include"]
    rows = page.locator('[data-figure="force"] table.data tbody tr')
    shown = [number(cell) for cell in rows.nth(10).locator("td").all_inner_texts()]
    answer = httpx.post(f"{service}/api/v1/crank-planetary", json=body, trust_env=False).json()[
        "contact_force"
    ]["curves"]
    assert rows.count() == len(answer["crank_angle_deg"])
    assert shown == pytest.approx(
        [answer["crank_angle_deg"][10], *(pair[10] for pair in answer["force_N"])],
        rel=JUDGED,
        abs=1e-9,
    )
    with page.expect_request(asks_results) as asked:
        change(page, toggle.click)
    assert "curves" not in asked.value.post_data_json["load"]["include"]
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line')).to_have_count(7)


def test_keyboard_alone(page: Page, service: str) -> None:
    show(page, service, ZYL)
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("() => document.activeElement.closest('[data-path]')?.dataset.path") == (
            "mechanism.pins"
        ):
            break
    else:
        pytest.fail("the box of the pins cannot be reached with Tab")
    change(page, lambda: page.keyboard.press("ArrowDown"))
    expect(box(page, "mechanism.pins")).to_have_value("5")
    change(page, lambda: page.keyboard.press("Shift+ArrowUp"))
    expect(box(page, "mechanism.pins")).to_have_value("15")
    page.keyboard.press("?")
    expect(page.get_by_role("dialog")).to_be_visible()
    expect(box(page, "mechanism.pins")).to_have_value("15")
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).not_to_be_visible()
    expect(box(page, "mechanism.pins")).to_be_focused()
    page.keyboard.press("Alt+1")
    expect(page.get_by_role("tab", name="Crank-planetary reducer")).to_be_focused()
    option(page, "ratio", "value").focus()
    change(page, lambda: page.keyboard.press("ArrowRight"))
    expect(box(page, "mechanism.satellite_teeth")).to_be_visible()


def test_enter_with_a_wrong_box_goes_to_it(page: Page, service: str) -> None:
    show(page, service, ZYL)
    box(page, "mechanism.ratio").fill("u")
    box(page, "contact.pin_radius_mm").press("Enter")
    expect(box(page, "mechanism.ratio")).to_be_focused()


def test_the_verdict_is_spoken(page: Page, service: str) -> None:
    show(page, service, ZYL)
    live = page.locator("#live")
    expect(live).to_contain_text("Peak force, ideal 888.2 N")
    box(page, "mechanism.pins").fill("0")
    expect(live).to_contain_text("Pins: must be 1 or more")
    expect(page.locator("[aria-live]")).to_have_count(1)


@pytest.mark.parametrize("width", [390, 360, 320])
def test_narrow_pages_do_not_scroll_sideways(page: Page, service: str, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    show(page, service)
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line').first).to_be_attached()
    wide = page.evaluate(
        """() => [...document.querySelectorAll("body *")]
          .filter((node) => node.getBoundingClientRect().right > innerWidth + 0.5
                            && !node.closest(".figure-table, .tabs, .plot, .unseen, .parts ul"))
          .map((node) => node.outerHTML.slice(0, 120))"""
    )
    assert wide == []
    assert page.evaluate("() => document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("width", [1440, 390])
def test_nothing_moves_while_the_page_comes_up_or_computes(
    page: Page, service: str, width: int
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    show(page, service)
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line').first).to_be_attached()
    page.wait_for_timeout(300)
    assert page.evaluate("() => watched.shift") < 0.01
    # Later changes are asked for without a key or pointer, which would excuse every shift.
    boxes = [("mechanism.ratio", "0"), ("mechanism.ratio", "20"), ("contact.hole_radius_mm", "1")]
    for path, text in boxes:
        page.evaluate(TYPE, [path, [text]])
        page.wait_for_timeout(500)
    assert page.evaluate("() => watched.shift") < 0.05


def luminance(colour: str) -> float:
    red, green, blue = (int(part) / 255 for part in re.findall(r"\d+", colour)[:3])
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def look(page: Page) -> tuple[float, float]:
    """Luminance of the page and of the text in a figure."""
    paper = page.evaluate("() => getComputedStyle(document.body).backgroundColor")
    text = page.locator('[data-figure="force"] .xtick text').first.evaluate(
        "node => getComputedStyle(node).fill"
    )
    return luminance(paper), luminance(text)


def test_dark_follows_the_system_and_the_switch_and_is_remembered(page: Page, service: str) -> None:
    page.emulate_media(color_scheme="dark")
    show(page, service)
    expect(page.locator('[data-figure="force"] .xtick text').first).to_be_attached()
    paper, ink = look(page)
    assert paper < 0.2 < 0.6 < ink
    page.get_by_role("button", name="Settings").click()
    with page.expect_response("**/crank-planetary/chart?theme=light"):
        page.get_by_label("Theme").select_option("light")
    expect(page.locator('[data-figure="force"] .xtick text').first).to_have_css(
        "fill", re.compile(r"rgb\((\d|[1-9]\d), ")
    )
    paper, ink = look(page)
    assert ink < 0.4 < 0.8 < paper
    page.reload()
    settled(page)
    assert luminance(page.evaluate("() => getComputedStyle(document.body).backgroundColor")) > 0.8


def test_nothing_is_asked_for_twice_or_in_vain(page: Page, service: str, watch: Any) -> None:
    """Requests made by the head of the page are used, even before anything is drawn."""
    show(page, service, ZYL | {"mechanism.pins": "0"}, state="wrong")
    page.wait_for_function("() => globalThis.Plotly !== undefined")
    page.wait_for_timeout(4000)  # by then the browser complains of what was asked for in vain
    asked = [url for url in watch.requests if not url.endswith("icon.svg")]  # asked for by address
    assert len(asked) == len(set(asked))
    for pins in ("3", "4", "5"):
        change(page, partial(box(page, "mechanism.pins").fill, pins))
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line')).to_have_count(6)
    assert len([path for path in watch.paths() if path.endswith("plotly-basic.min.js")]) == 1


def test_a_field_that_nobody_has_touched_asks(page: Page, service: str) -> None:
    show(page, service, {"mechanism.satellites": "4"}, state="incomplete")
    line, wrong = page.locator(".say"), page.locator(".field.wrong")
    expect(line).to_have_text(re.compile("^Still needed: Ratio, Eccentricity, Pins"))
    expect(wrong).to_have_count(0)
    assert page.locator("[aria-invalid]").count() == 0 and "✕" not in page.inner_text(".verdict")
    box(page, "mechanism.pins").fill("6")
    expect(line).to_have_text(re.compile("^Still needed: Ratio, Eccentricity, Pin circle"))
    box(page, "mechanism.ratio").focus()
    box(page, "load.output_torque_Nm").focus()
    settled(page, "wrong")
    expect(wrong).to_have_count(1)
    expect(words_at(page, "mechanism.ratio")).to_have_text("Needs a value")
    expect(line).to_have_text(re.compile("Ratio: needs a value; Still needed: Eccentricity"))
    box(page, "load.output_torque_Nm").press("Enter")
    expect(wrong).to_have_count(6)
    expect(box(page, "mechanism.ratio")).to_be_focused()


def test_figures_have_no_toolbar_over_their_legend(page: Page, service: str) -> None:
    show(page, service)
    plot = page.locator('[data-figure="force"] .plot')
    expect(plot.locator(".legend .legendtext").first).to_be_attached()
    plot.hover()
    expect(plot.locator(".modebar-btn, .plotlyjsicon")).to_have_count(0)
    assert plot.get_attribute("role") == "group" and plot.get_attribute("aria-label")


def test_without_the_service_everything_typed_stays(page: Page, service: str, watch: Any) -> None:
    show(page, service, ZYL)
    page.route("**/api/v1/**", lambda route: route.abort())
    box(page, "mechanism.pins").fill("4")
    settled(page, "offline")
    expect(page.locator(".say")).to_contain_text("cannot be reached")
    expect(box(page, "mechanism.pins")).to_have_value("4")
    page.unroute("**/api/v1/**")
    settled(page)  # the page asks again by itself
    assert result(page, "peak_force_N") == pytest.approx(1538.46, abs=5e-3)

    failing = {"status": 500, "content_type": "text/plain", "body": "oh"}
    page.route("**/api/v1/crank-planetary", lambda route: route.fulfill(**failing))
    box(page, "mechanism.pins").fill("5")
    settled(page, "failed")
    expect(page.locator(".word")).to_have_text("✕Error of the service")
    page.unroute("**/api/v1/crank-planetary")
    page.get_by_role("button", name="Try again").press("Enter")
    settled(page)
    expect(page.locator(".verdict .judged")).to_be_focused()

    page.route("**/api/v1/*/chart*", lambda route: route.abort())  # gone with the first figures
    page.route("**/api/v1/crank-planetary", lambda route: route.abort())
    page.reload()
    settled(page, "offline")
    page.unroute("**/api/v1/crank-planetary")
    settled(page)
    missing = page.locator('[data-figure="force"] .figure-message')
    expect(missing).to_contain_text("asks again by itself")
    page.unroute("**/api/v1/*/chart*")
    expect(missing).to_be_hidden()
    expect(page.locator('[data-figure="force"] .scatterlayer .js-line').first).to_be_attached()
    watch.complaints = [
        line for line in watch.complaints if not re.search("ERR_FAILED|status of 500", line)
    ]


def test_what_is_assumed_stands_beside_the_verdict(page: Page, service: str) -> None:
    """A box that shows its default says it; one that is emptied leaves it to the service."""
    show(page, service, ZYL | {"contact.eccentricity_mm": "1.5"})
    aside = page.locator(".summary .aside")
    expect(aside).not_to_contain_text("Satellites:")
    box(page, "mechanism.satellites").fill("")
    settled(page)
    expect(aside).to_contain_text("Assumed, as it is not given: Satellites: 2 (for one: 888.2")


def test_a_ratio_with_a_sign_is_read_without_it(page: Page, service: str) -> None:
    show(page, service, ZYL | {"mechanism.ratio": "-20", "contact.eccentricity_mm": "1.5"})
    expect(page.locator(".summary .say")).to_contain_text("The ratio is taken as 20")
    box(page, "mechanism.ratio").fill("0.05")
    expect(page.locator('[data-path="mechanism.ratio"]')).to_contain_text("its inverse is 20")


def test_with_the_ring_as_output_crank_pins_and_ring_are_shown(page: Page, service: str) -> None:
    ring = ZYL | {"mechanism.output": "ring", "load.input_speed_rpm": "1500"}
    show(page, service, ring)
    tab(page, "results").click()
    members = page.locator('[data-section="members"]')
    for name, shown in (("ring_speed_rpm", "71.43"), ("pin_torque_Nm", "47.62")):
        expect(members.locator(f'[data-name="{name}"] .value')).to_contain_text(shown)
    # two shafts have neither ratio nor cranks: what these boxes say is not asked
    box(page, "mechanism.output").select_option("coupling")
    settled(page)
    expect(members.locator('[data-name="output_ratio"] .value')).to_have_text("1")


@pytest.mark.parametrize("width", [1280, 390])
def test_the_largest_torque_comes_after_the_first_answer_in_its_place(
    page: Page, service: str, width: int
) -> None:
    """Nothing moves when it does; until then its place is grey."""
    held: list[Route] = []

    def hold(route: Route) -> None:
        if (route.request.post_data_json or {}).get("include") == ["largest_torque"]:
            held.append(route)
        else:
            route.continue_()

    page.set_viewport_size({"width": width, "height": 800})
    page.route("**/api/v1/crank-planetary", hold)
    show(page, service)
    torque, verdict = page.locator(".verdict .torque"), page.locator(".verdict")
    expect(torque.locator(".sought .figures")).to_have_text("…")
    while not held:
        page.wait_for_timeout(20)
    places = torque.bounding_box(), verdict.bounding_box()
    held[0].continue_()
    expect(torque.locator(".sought")).to_have_count(0)
    expect(torque.locator(".figures")).to_have_text(re.compile(r"\d"))
    assert (torque.bounding_box(), verdict.bounding_box()) == places
