"""The precessional gear as its user sees it: effects, not presence."""

from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.browser.calculator_page import (
    CALCULATORS,
    ask,
    box,
    cell,
    choose,
    first_example,
    fits_narrow_screens,
    number,
    open_rows,
    opened,
    reopen,
    result,
    settled,
    show,
    tab,
    verdict,
    words_at,
)


def figures(page: Page) -> list[float]:
    return [number(verdict(page, position).inner_text()) for position in range(3)]


def test_opens_with_the_papers_example_and_nothing_of_another_calculator(
    page: Page, service: str, watch: Any
) -> None:
    show(page, service, "precession")
    body = first_example(service, "precession/shaft-deflection")
    answer = ask(service, "/precession/shaft-deflection", body)
    length, load, deflection = figures(page)
    assert length == pytest.approx(40.2196026288, rel=2e-4)
    assert deflection == pytest.approx(answer["deflection_C_mm"]["total"], rel=5e-3)
    assert result(page, "max_line_load_N_per_mm") == pytest.approx(load, rel=1e-3)
    expect(page.locator(".summary .numbers")).to_contain_text("C 379.5")  # |(-171.17, 338.66)|
    for figure in ("contactLines", "lineLoad", "shaft"):
        tab(page, figure).click()
        line = page.locator(f'[data-figure="{figure}"] .scatterlayer .js-line')
        expect(line.first).to_be_attached()

    own = [
        f"/api/v1/precession/{name}"
        for name in ("contact-line", "meshing-load", "shaft-deflection")
    ]
    assert sorted(watch.calculations()) == sorted(own + [f"{path}/chart" for path in own])
    others = CALCULATORS - {"precession"}
    assert not [path for path in watch.paths() for other in others if f"/{other}/" in path]
    expect(page.locator('[data-path="output_torque_Nm"], [data-path^="mechanism"]')).to_have_count(
        0
    )
    assert page.evaluate("() => watched.shift") < 0.02


def test_rollers_one_by_one_with_the_keyboard(page: Page, service: str, watch: Any) -> None:
    show(page, service, "precession")
    before = figures(page)
    expect(page.locator('[data-path="rollers"] .open-records')).to_have_text("4 rows")
    open_rows(page, "rollers")
    page.get_by_role("button", name="Remove row 4").press("Enter")
    expect(page.locator(".summary")).to_contain_text("3 rollers")
    expect(page.get_by_role("button", name="Remove row 1")).to_be_focused()
    page.get_by_role("button", name="Add a row").press("Enter")
    expect(cell(page, 4, "Position angle")).to_be_focused()
    page.keyboard.press("ControlOrMeta+a")
    page.keyboard.type("105")
    page.keyboard.press("ArrowUp")  # by the schema's step of 15
    expect(cell(page, 4, "Position angle")).to_have_value("120")
    expect(page.locator('[data-path="rollers"] .records-line')).to_contain_text(
        "position of the roller"
    )
    expect(page.locator(".summary")).to_contain_text("4 rollers")
    settled(page)
    assert figures(page) == before
    reopen(page)
    assert figures(page) == before
    open_rows(page, "rollers")

    # What cannot be read and what the service refuses stand at their row; nothing is asked twice.
    cell(page, 4, "Position angle").fill("12o")
    settled(page, "wrong")
    expect(words_at(page, "rollers")).to_contain_text("Row 4, Position angle: Not a number")
    expect(cell(page, 4, "Position angle")).to_have_attribute("aria-invalid", "true")
    cell(page, 4, "Position angle").fill("120")
    settled(page)
    asked = len(watch.calculations())
    cell(page, 3, "Working length to").fill("14")
    settled(page, "wrong")
    expect(words_at(page, "rollers")).to_contain_text("Row 3, Working length to: Must be larger")
    expect(cell(page, 3, "Working length to")).to_have_attribute("aria-invalid", "true")
    expect(cell(page, 3, "Working length to")).to_have_value("14")
    assert cell(page, 2, "Working length to").get_attribute("aria-invalid") is None
    assert watch.calculations()[asked:] == ["/api/v1/precession/contact-line"]

    # Limits in phi instead of z.
    for column, value in (("Working length from", ""), ("Working length to", "")):
        cell(page, 3, column).fill(value)
    cell(page, 3, "Contact from").fill("-50")
    cell(page, 3, "Contact to").fill("-40")
    settled(page)
    page.keyboard.press("Escape")
    expect(page.locator('[data-path="rollers"] .open-records')).to_be_focused()
    tab(page, "contactLines").click()
    page.locator('[data-figure="contactLines"] .show-table').click()
    row = page.locator('[data-figure="contactLines"] .figure-table tbody tr').nth(2)
    expect(row).to_contain_text("\u221250")


def test_a_wheel_and_a_stepped_shaft_start_from_the_same_design(page: Page, service: str) -> None:
    show(page, service, "precession")
    before = figures(page)
    choose(page, "rollersBy", "wheel")
    settled(page)
    expect(box(page, "wheel.rollers_total")).to_have_value("12")
    expect(page.get_by_role("button", name="Remove row 1")).not_to_be_visible()
    assert figures(page) == before
    choose(page, "shaftBy", "sections")
    settled(page)
    assert figures(page) == before
    open_rows(page, "shaft_sections")
    cell(page, 2, "Diameter").fill("30")
    expect(page.locator(".results [data-name=simplification_error_C]")).to_be_attached()
    assert figures(page)[2] < before[2]
    reopen(page)
    open_rows(page, "shaft_sections")
    expect(cell(page, 2, "Diameter")).to_have_value("30")

    # A shaft that cannot be computed leaves the mesh standing, and the other way round not.
    cell(page, 1, "Length").fill("35")
    settled(page, "wrong")
    expect(words_at(page, "shaft_sections")).to_contain_text("add up to")
    expect(page.locator('[data-section="shaft_deflection"]')).to_contain_text("Not computed")
    assert result(page, "max_line_load_N_per_mm") > 0
    # At once into another tab and back: nothing typed is lost.
    cell(page, 1, "Length").fill("30")
    box(page, "wheel.z_min_mm").fill("-5")
    page.keyboard.press("Alt+2")
    opened(page, "rollers")
    page.keyboard.press("Alt+3")
    expect(box(page, "wheel.z_min_mm")).to_have_value("-5")
    settled(page, "refused")
    expect(page.locator(".say")).to_contain_text("phi = 0")


def test_narrow_screens_and_the_dark(page: Page, service: str) -> None:
    page.emulate_media(color_scheme="dark")
    show(page, service, "precession")
    with page.expect_request("**/precession/contact-line/chart?theme=dark"):
        tab(page, "contactLines").click()
    fits_narrow_screens(page, "precession")
    page.locator('.places [data-place="inputs"]').click()
    open_rows(page, "rollers")
    boxes = page.locator(".records .box").evaluate_all("all => all.map(one => one.offsetWidth)")
    assert len(boxes) == 4 * 5 and min(boxes) >= 44  # five boxes side by side, still wide
    expect(page.locator(".notes")).to_contain_text("reciprocity")


def test_figures_of_extreme_sizes_need_no_inline_styles(page: Page, service: str) -> None:
    show(page, service, "precession")
    box(page, "overhang_mm").fill("1e9")
    tab(page, "shaft").click()
    ticks = page.locator('[data-figure="shaft"] .xtick text')
    expect(ticks.filter(has_text="e+").first).to_be_attached()


def test_labels_of_the_drawing_stand_apart(page: Page, service: str) -> None:
    show(page, service, "precession")
    expect(page.locator(".mechanism .label").first).to_be_visible()
    crossing = page.evaluate(
        """() => {
          const boxes = [...document.querySelectorAll(".mechanism .label")]
            .map((one) => [one.textContent, one.getBoundingClientRect()]);
          const apart = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) < 1
            || Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) < 2;
          const crossed = ([, a], i) =>
            boxes.slice(i + 1).filter(([, b]) => !apart(a, b)).map(([text]) => text);
          return boxes.flatMap((one, i) => crossed(one, i).map((other) => [one[0], other]));
        }"""
    )
    assert crossing == []
