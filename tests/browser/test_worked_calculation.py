"""The worked calculation, built when opened, its numbers the service's; warnings explained."""

import re

import pytest
from playwright.sync_api import Locator, Page, Request, Route, expect

from core.precision import JUDGED
from tests.browser.calculator_page import (
    ask,
    box,
    first_example,
    from_menu,
    number,
    settled,
    show,
)

CALCULATORS = ("crank-planetary", "rollers", "precession")


def step(page: Page, name: str) -> Locator:
    return page.locator(f'.worked .step[data-name="{name}"]')


def unfolded(page: Page, section: str) -> Locator:
    details = page.locator(f'.worked details[data-section="{section}"]')
    details.locator("summary").click()
    expect(details.locator(".step").first).to_be_visible()
    return details


def last_number(one: Locator) -> float:
    """The number at the end of a step."""
    return number(one.locator("math").last.locator("mn").last.text_content() or "")


@pytest.mark.parametrize("calculator", CALCULATORS)
def test_steps_are_folded_and_built_when_opened(page: Page, service: str, calculator: str) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.post_data or ""))
    show(page, service, calculator)
    groups = page.locator(".worked details")
    assert groups.count() == page.locator(".results .result[data-section]").count()
    expect(page.locator(".worked math")).to_have_count(0)
    assert not any('"worked"' in each for each in asked)
    for summary in groups.locator("summary").all():
        summary.click()
    for group in groups.all():
        steps = group.locator(".step")
        expect(steps.first).to_be_visible()
        assert group.locator("math").count() >= steps.count()
    labels = page.locator(".worked math").evaluate_all("all => all.map((one) => one.ariaLabel)")
    assert all(labels)
    assert not any("undefined" in label or "NaN" in label for label in labels)


def test_a_step_shows_the_inputs_the_answer_and_the_source(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    unfolded(page, "contact_force")
    given = first_example(service, "crank-planetary")
    reference = step(page, "reference_force_N")
    shown = reference.locator("math").nth(1).get_attribute("aria-label") or ""
    load = given["load"]
    assert isinstance(load, dict)
    assert re.findall(r"\d+", shown) == [
        f"{load['output_torque_Nm']:g}",
        f"{load['pin_circle_radius_mm']:g}",
    ]
    expect(reference.locator(".step-source")).to_contain_text("2021, eq. (11)")
    answer = ask(service, "/crank-planetary", given)["contact_force"]
    assert isinstance(answer, dict)
    assert last_number(reference) == pytest.approx(answer["reference_force_N"], rel=JUDGED)
    assert last_number(step(page, "peak_force_N")) == pytest.approx(
        answer["peak_force_N"], rel=JUDGED
    )
    assert "arcsine" in step(page, "peak_force_N").inner_text()
    assert "stationary points" in step(page, "peak_crank_angle_deg").inner_text()


def test_open_steps_follow_the_inputs(page: Page, service: str) -> None:
    show(page, service, "rollers")
    unfolded(page, "roller_strength")
    mean = step(page, "mean_force_N")
    first = last_number(mean)
    torque = box(page, "output_torque_Nm")
    torque.fill(str(2 * float(torque.input_value())))
    torque.press("Enter")
    settled(page)
    expect(page.locator(".worked details[aria-busy]")).to_have_count(0)
    assert last_number(mean) == pytest.approx(2 * first, rel=JUDGED)


def test_formulas_are_drawn_with_the_math_font(page: Page, service: str) -> None:
    show(page, service, "precession")
    assert not page.evaluate("() => document.fonts.check('16px \"STIX Two Math\"')")
    unfolded(page, "contact_line")
    page.evaluate("() => document.fonts.ready.then(() => true)")
    assert page.evaluate("() => document.fonts.check('16px \"STIX Two Math\"')")


def test_the_verdict_in_words_and_what_mends_a_warning(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    words = page.locator(".plain-words")
    expect(words).to_contain_text("Torque is transmitted at every crank angle")
    expect(words.locator(".explained")).to_have_count(1)  # that the parts are perfect
    pins = box(page, "mechanism.pins")
    pins.fill("50")
    pins.press("Enter")
    settled(page)
    expect(page.locator(".verdict .word")).to_have_text(re.compile("Impossible"))
    assert words.locator(".explained").count() >= 2  # holes and pins overlap, which checks say
    for explained in words.locator(".explained").all():
        assert explained.locator("dd").count() == 3


def test_the_largest_torque_said_is_true(page: Page, service: str) -> None:
    """At the torque that is said the check that governs is at its limit."""
    show(page, service, "crank-planetary")
    expect(page.locator(".verdict .torque .figures")).to_have_text(re.compile(r"\d"))
    torque = number(page.locator(".verdict .torque .figures").inner_text())
    given = first_example(service, "crank-planetary")
    load = given["load"]
    assert isinstance(load, dict)
    load["output_torque_Nm"] = torque
    answer = ask(service, "/crank-planetary", given | {"include": ["hertz", "checks"]})
    checks = answer["checks"]
    assert isinstance(checks, list)
    governing = next(one for one in checks if one["code"] == answer["governing"])
    assert governing["utilisation"] == pytest.approx(1, rel=5e-3)


def test_several_inputs_are_changed_by_a_click(page: Page, service: str) -> None:
    """Changes of several inputs are offered if no change of one cures the failing checks."""
    design = {
        **{"mechanism.pins": "8", "mechanism.satellites": "2", "mechanism.ratio": "15"},
        **{"load.output_torque_Nm": "3530", "load.pin_circle_radius_mm": "47.9"},
        **{"contact.contact_length_mm": "13.6", "contact.pin_radius_mm": "6.6"},
        **{"contact.eccentricity_mm": "1.14", "contact.hole_clearance_mm": "0.033"},
        **{"contact.pin_material": "steel_bearing"},
        **{"contact.hole_material": "bronze_tin_centrifugal"},
        **{"strength.on": "on", "pin.satellite_positions_mm": "8.16;23.12"},
    }
    show(page, service, "crank-planetary", **design)
    expect(page.locator(".verdict .word")).to_have_text(re.compile("Fails"))
    together = page.locator(".fix").first
    expect(together).to_contain_text("Together: Pin radius 6.6")
    expect(together.locator("xpath=..")).to_contain_text("then: Incomplete")
    together.click()
    expect(page.locator(".verdict .word")).to_have_text(re.compile("Incomplete"))
    settled(page)
    assert float(box(page, "contact.pin_radius_mm").input_value()) > 6.6
    assert float(box(page, "load.pin_circle_radius_mm").input_value()) > 47.9


def test_a_fix_and_a_size_are_applied_by_a_click(page: Page, service: str) -> None:
    """From a design that fails to one that works; from a size wanted to the size in the box."""
    show(page, service, "crank-planetary")
    load = box(page, "load.output_torque_Nm")
    load.fill("1500")
    expect(page.locator(".verdict .word")).to_have_text(re.compile("Fails"))
    page.locator(".fix").first.click()
    expect(page.locator(".verdict .word")).to_have_text(re.compile("Incomplete"))
    page.get_by_role("button", name="Undo").click()
    from_menu(page, "contact.pin_radius_mm", "Size for")
    sheet = page.locator("#sizing")
    expect(sheet.locator('[data-part="result"]')).to_contain_text("at least")
    sheet.get_by_role("button", name="Take it over").click()
    settled(page)
    row = page.locator('.results [data-name="safety_factor"] .value')
    assert number(row.text_content() or "") == pytest.approx(1.5, rel=2e-3)


def test_that_nothing_mends_is_said(page: Page, service: str) -> None:
    def finding_none(route: Route) -> None:
        if "fixes" not in (route.request.post_data or ""):
            return route.continue_()
        found = route.fetch()
        return route.fulfill(response=found, json=found.json() | {"fixes": [], "combined": None})

    page.route("**/crank-planetary", finding_none)
    show(page, service, "crank-planetary")
    box(page, "load.output_torque_Nm").fill("1500")
    expect(page.locator(".fixes:not([hidden])")).to_contain_text("Nothing found")


def test_what_mends_is_looked_for_last_and_gives_way(page: Page, service: str) -> None:
    """While it is looked for, that is said in its room; a size that is asked for comes first."""
    held: list[Route] = []
    ended: list[Request] = []

    def mends(request: Request) -> bool:
        return "fixes" in (request.post_data or "")

    page.route(
        "**/crank-planetary",
        lambda route: held.append(route) if mends(route.request) else route.continue_(),
    )
    page.on("requestfailed", lambda request: ended.append(request) if mends(request) else None)
    show(page, service, "crank-planetary")
    load, fixes = box(page, "load.output_torque_Nm"), page.locator(".fixes:not([hidden])")
    with page.expect_request(mends):
        load.fill("1500")
    settled(page)
    expect(fixes).to_contain_text("Looking for what mends it")
    height = fixes.evaluate("(one) => one.offsetHeight")
    with page.expect_request("**/solve"):
        from_menu(page, "contact.pin_radius_mm", "Size for")
    with page.expect_request(mends):  # again, after it
        expect(page.locator('#sizing [data-part="result"]')).to_contain_text("at least")
    assert ended
    page.keyboard.press("Escape")
    held[-1].continue_()
    expect(fixes.locator(".fix").first).to_be_visible()
    expect(fixes).not_to_contain_text("Looking")
    assert fixes.evaluate("(one) => one.offsetHeight") == height
    best, more = fixes.locator("> ul > li"), fixes.locator(".more")
    expect(best).to_have_count(2)
    expect(more.locator("li").first).to_be_hidden()
    more.locator("summary").click()
    expect(more.locator("li").first).to_be_visible()
    basis = page.locator(".check", has=page.locator(".fix")).first.locator(".check-more")
    expect(basis.locator("p").first).to_be_hidden()  # as nobody has opened the row
    basis.locator("summary").click()
    expect(basis.locator("p").first).to_be_visible()
    expect(fixes).to_be_visible()
    with page.expect_request(mends):
        load.fill("1600")
    given_way = len(ended)
    load.fill("x")  # a key ends it
    settled(page, "wrong")
    expect(fixes).not_to_contain_text("Looking")
    assert len(ended) == given_way + 1
