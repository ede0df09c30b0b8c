"""The swinging rollers as their user sees them: effects, not presence."""

import re
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from core.precision import JUDGED
from tests.browser.calculator_page import (
    CALCULATORS,
    ask,
    box,
    choose,
    first_example,
    fits_narrow_screens,
    number,
    opened,
    reopen,
    result,
    settled,
    show,
    verdict,
    words_at,
)


def test_opens_with_the_papers_example_and_nothing_of_another_calculator(
    page: Page, service: str, watch: Any
) -> None:
    show(page, service, "rollers")
    answer = ask(service, "/roller-strength", first_example(service, "roller-strength"))
    assert result(page, "bending_stress_MPa") == pytest.approx(0.0024213655 * 210e3, rel=JUDGED)
    assert number(verdict(page, 0).inner_text()) == pytest.approx(answer["max_force_N"], rel=1e-4)
    expect(page.locator('[data-figure="rollers"] .scatterlayer .js-line').first).to_be_visible()

    assert sorted(watch.calculations()) == [
        "/api/v1/roller-strength",
        "/api/v1/roller-strength/chart",
    ]
    others = CALCULATORS - {"rollers"}
    assert not [path for path in watch.paths() for other in others if f"/{other}/" in path]
    assert page.locator("[data-path]").count() == page.locator("form [data-path]").count() == 18
    expect(page.locator("[data-figure] .js-plotly-plot")).to_have_count(1)

    page.locator('[data-figure="rollers"] .show-table').click()
    captions = page.locator('[data-figure="rollers"] .figure-table caption')  # of its curves
    expect(captions.filter(has_text="Bending stress")).not_to_have_count(0)
    shown = page.locator('.results [data-name="forces_N"] .value').text_content() or ""
    assert [number(each) for each in shown.split(";")] == pytest.approx(
        answer["forces_N"], rel=1e-4
    )
    assert page.evaluate("() => watched.shift") < 0.02


def test_typing_changes_the_verdict_and_the_link_keeps_it(page: Page, service: str) -> None:
    show(page, service, "rollers")
    box(page, "position_tolerance_mm").fill("0,05")
    expect(page.locator(".summary")).to_contain_text("1 of 4 rollers carry")
    assert result(page, "load_nonuniformity") == 4
    reopen(page)
    assert box(page, "position_tolerance_mm").input_value() == "0.05"
    assert result(page, "load_nonuniformity") == 4

    # The same design said as gaps: four times the tolerance for all but the first.
    choose(page, "errors", "gaps")
    settled(page)
    assert box(page, "gaps_mm").input_value() == "0; 0.2; 0.2; 0.2"
    assert result(page, "load_nonuniformity") == 4
    expect(box(page, "position_tolerance_mm")).not_to_be_visible()
    stress = result(page, "bending_stress_MPa")
    choose(page, "shear", "modulus")
    settled(page)
    assert result(page, "bending_stress_MPa") == pytest.approx(stress, rel=JUDGED)
    reopen(page)
    assert box(page, "gaps_mm").input_value() == "0; 0.2; 0.2; 0.2"
    assert result(page, "bending_stress_MPa") == pytest.approx(stress, rel=JUDGED)


def test_what_is_wrong_stands_at_its_box(page: Page, service: str) -> None:
    show(page, service, "rollers")
    choose(page, "errors", "gaps")
    settled(page)
    box(page, "gaps_mm").fill("0; 0.2")
    settled(page, "wrong")
    expect(words_at(page, "gaps_mm")).to_contain_text("4 entries")
    assert box(page, "gaps_mm").get_attribute("aria-invalid") == "true"
    assert box(page, "gaps_mm").input_value() == "0; 0.2"
    box(page, "diameter_mm").fill("-3")
    expect(words_at(page, "diameter_mm")).to_contain_text("Must be more than 0")
    # Another tab and back, at once: nothing typed is lost.
    box(page, "diameter_mm").fill("-31")
    page.keyboard.press("Alt+3")
    opened(page, "precession")
    page.keyboard.press("Alt+2")
    expect(box(page, "diameter_mm")).to_have_value("-31")
    expect(box(page, "gaps_mm")).to_have_value("0; 0.2")
    box(page, "diameter_mm").fill("10")
    box(page, "gaps_mm").fill("0; 0; 0; 0")
    settled(page)
    assert result(page, "load_nonuniformity") == pytest.approx(1)


def test_examples_narrow_screens_and_the_dark(page: Page, service: str) -> None:
    page.emulate_media(color_scheme="dark")
    with page.expect_request("**/roller-strength/chart?theme=dark"):
        show(page, service, "rollers")
    page.get_by_role("button", name="New").click()
    expect(page.locator("#start [data-example]").first).to_be_visible()
    titles = page.locator("#start [data-example]").all_inner_texts()
    assert len(titles) > 2 and all("pairs" not in title for title in titles)
    expect(page.locator("#start section")).to_have_count(1)
    page.locator("#start").get_by_role("button", name="fig. 5").click()
    expect(page.locator(".summary .numbers .cell.bad")).to_contain_text("1 of")
    naming = page.get_by_label("Name of the design")
    expect(naming).to_have_attribute("title", re.compile("Ovsyannikov"))
    fits_narrow_screens(page, "rollers")
    expect(page.locator(".notes")).to_contain_text("n/4")


def test_error_against_run_time_is_measured_on_demand_only(page: Page, service: str, watch) -> None:
    show(page, service, "rollers")
    expect(page.locator(".accuracy-fold .numbers-of li")).to_have_count(1)
    expect(page.locator(".measure, .trade-off")).to_have_count(0)  # it has one method
    show(page, service, "precession")
    work = "/api/v1/work-precision/chart"
    assert work not in watch.paths()
    figure = page.locator('[data-figure="workShaft"]')
    page.locator(".accuracy-fold > summary").click()
    figure.get_by_role("button", name="Measure on these inputs").click()
    expect(figure.locator(".legendtext", has_text="Used by the calculator")).to_be_visible()
    assert watch.paths().count(work) == 1
    # Other inputs need another measurement: the old one does not stay beside new numbers.
    box(page, "overhang_mm").fill("45")
    expect(figure.get_by_role("button", name="Measure on these inputs")).to_be_enabled()
    expect(figure.locator(".legendtext")).to_have_count(0)
    assert watch.paths().count(work) == 1
