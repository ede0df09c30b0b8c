"""Designs from a requirement on the page: searched, shown as they are found, opened."""

import json

import pytest
from playwright.sync_api import Page, Route, expect

from app.examples import REQUESTS
from tests.browser.calculator_page import (
    address,
    box,
    chosen,
    fits_narrow_screens,
    settled,
    show,
)
from tests.browser.conftest import Watch

NONE = {"torque_Nm": 500.0, "ratio": 20, "outer_diameter_mm": 60.0, "process": "ground"}


def unfolded(page: Page) -> None:
    page.locator(".requirement > summary").click()
    expect(page.locator(".propose")).to_be_visible()


def filled(page: Page, asked: dict[str, object], path: str = "") -> None:
    """Type a request."""
    for name, value in asked.items():
        if isinstance(value, dict):
            filled(page, value, f"{path}{name}.")
            continue
        one = page.locator(f'.propose [data-path="{path}{name}"]').locator(".box")
        if not one.is_visible():
            page.locator(".propose .more summary").click()
        if one.evaluate("node => node.tagName") == "SELECT":
            one.select_option(str(value))
        else:
            one.fill(f"{value:g}")


def test_a_ring_that_pieces_press_too_hard_makes_it_marginal(page: Page, service: str) -> None:
    """Parts without errors pass."""
    show(page, service, "crank-planetary")
    unfolded(page)
    filled(page, REQUESTS["propose"] | {"outer_diameter_mm": 80.0, "length_mm": 50.0})
    page.locator('.propose [data-path="torque_Nm"] .box').press("Enter")
    expect(page.locator(".proposal")).to_contain_text("Just works")


def test_a_proposal_is_found_and_opened(page: Page, service: str, watch: Watch) -> None:
    asked = REQUESTS["propose"]
    show(page, service, "crank-planetary")
    before = address(page)
    assert not any("propose" in path for path in watch.paths())
    unfolded(page)
    assert watch.paths()[-1] != "/api/v1/propose"
    filled(page, asked)
    page.locator('.propose [data-path="torque_Nm"] .box').press("Enter")
    expect(page.get_by_role("button", name="Cancel")).to_be_enabled()
    row = page.locator(".proposal")
    expect(row).to_have_count(1)
    expect(row).to_contain_text("20:1")
    expect(row).to_contain_text("Works")
    expect(row.locator("dl > div")).to_have_count(8)
    expect(page.locator(".propose .state")).to_contain_text("Found: 1.")
    fits_narrow_screens(page, "crank-planetary")
    page.set_viewport_size({"width": 1280, "height": 900})
    page.get_by_role("button", name="Open design 20:1").click()
    expect(box(page, "load.output_torque_Nm")).to_have_value("20")
    settled(page)
    expect(page.locator(".verdict .word")).to_have_text("✓Works")
    largest = row.locator("dl > div").nth(4).locator("dd")
    shown = page.locator(".verdict .torque .figures")
    expect(shown).not_to_have_text("…")
    assert float(shown.inner_text()) == pytest.approx(
        float((largest.text_content() or "").split("\u00a0")[0]), rel=0.01
    )
    address(page)
    page.go_back()
    settled(page)
    assert address(page) == before
    expect(row).to_have_count(1)  # another one may be opened
    chosen(page, "language", "uk")
    settled(page)
    page.locator(".requirement > summary").click()
    expect(page.locator('.propose [data-path="torque_Nm"] .box')).to_have_value("20")


def test_where_none_is_found_it_is_said_why(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    unfolded(page)
    filled(page, NONE)
    page.get_by_role("button", name="Search").click()
    expect(page.locator(".propose .state")).to_contain_text("No design does all that is asked")
    tally = page.locator(".propose .none tbody tr")
    expect(tally.filter(has_text="Life of the satellites' bearings")).to_have_count(1)
    expect(page.locator(".lacks li").first).to_contain_text("×")
    page.get_by_role("button", name="Open design").click()
    expect(box(page, "load.output_torque_Nm")).to_have_value("500")
    settled(page)
    expect(page.locator(".verdict .word")).to_have_text("✕Fails")


def test_what_is_refused_stands_at_its_field_and_a_search_is_cancelled(
    page: Page, service: str
) -> None:
    show(page, service, "crank-planetary")
    unfolded(page)
    filled(page, {"torque_Nm": 20.0, "ratio": 20, "outer_diameter_mm": 10.0})
    search = page.get_by_role("button", name="Search")
    search.click()
    diameter = page.locator('.propose [data-path="outer_diameter_mm"]')
    expect(diameter.locator(".field-message")).to_contain_text("Must be 30 or more")
    expect(diameter.locator(".box")).to_be_focused()
    filled(page, {"outer_diameter_mm": 120.0})
    filled(page, {"ratio": 10, "ratio_to": 40})
    search.click()
    end = page.locator('.propose [data-path="ratio_to"] .field-message')
    expect(end).to_contain_text("at most 17")
    held: list[Route] = []
    page.route("**/propose", lambda route: held.append(route))  # never answered
    filled(page, {"ratio_to": 12})
    search.click()
    page.get_by_role("button", name="Cancel").click()
    expect(page.locator(".propose .state")).to_contain_text("Stopped.")
    expect(search).to_be_focused()
    asked = held[0].request.post_data_json
    assert (asked["ratio"], asked["ratio_to"]) == (10, 12), json.dumps(asked)
