"""Swinging rollers and the precessional gear as their user sees them: effects, not presence."""

import re

import httpx
import pytest
from playwright.sync_api import Locator, Page, expect


def show(page: Page, service: str, calculator: str, **fields: str) -> None:
    """Open a calculator (with these inputs) and wait until it has computed."""
    query = httpx.QueryParams({"calculator": calculator} | ({"v": "1"} | fields if fields else {}))
    page.goto(f"{service}/?{query}")
    settled(page)


def settled(page: Page, state: str = "fresh") -> None:
    expect(page.locator("#panel")).to_have_attribute("data-state", state)


def box(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .box')


def cell(page: Page, row: int, column: str) -> Locator:
    return page.get_by_label(f"Row {row}, {column}", exact=True)


def figures(page: Page) -> list[str]:
    return page.locator(".verdict .cell .figures").all_inner_texts()[:3]


def result(page: Page, name: str) -> float:
    text = page.locator(f'.results [data-name="{name}"] .value').inner_text()
    return float(re.sub(r"\s", "", text).replace("\u2212", "-"))


def words_at(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .field-message')


def no_sideways_scroll(page: Page) -> bool:
    return page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")


def test_rollers_compute_as_typed_and_travel_in_the_address(page: Page, service: str) -> None:
    show(page, service, "rollers")
    assert figures(page)[0] == "990.49"  # the paper's fig. 6, l/d = 2, chi/d = 2e-4
    assert result(page, "bending_stress_MPa") == pytest.approx(0.0024213655 * 210e3, rel=1e-5)

    box(page, "position_tolerance_mm").fill("0,05")
    expect(page.locator(".verdict")).to_contain_text("1 of 4 rollers carry")
    assert result(page, "load_nonuniformity") == 4
    address = page.url
    page.goto("about:blank")
    page.goto(address)
    settled(page)
    assert box(page, "position_tolerance_mm").input_value() == "0.05"
    assert result(page, "load_nonuniformity") == 4

    # The same design said as gaps: four times the tolerance for all but the first.
    page.locator('[data-choice="errors"] input[value="gaps"]').check(force=True)
    settled(page)
    assert box(page, "gaps_mm").input_value() == "0; 0.2; 0.2; 0.2"
    assert result(page, "load_nonuniformity") == 4
    box(page, "gaps_mm").fill("0; 0.2")
    settled(page, "wrong")
    expect(words_at(page, "gaps_mm")).to_contain_text("one gap for each of the 4 rollers")
    assert box(page, "gaps_mm").input_value() == "0; 0.2"


def test_the_table_of_rollers_is_that_of_the_answer(page: Page, service: str) -> None:
    show(page, service, "rollers")
    body = {
        "output_torque_Nm": 210, "hole_circle_radius_mm": 30, "rollers": 4,
        "position_tolerance_mm": 0.002, "diameter_mm": 10, "cylinder_length_mm": 20,
        "sphere_width_mm": 8, "sphere_diameter_mm": 15, "poissons_ratio": 0.3,
    }  # fmt: skip
    with httpx.Client(trust_env=False) as client:
        answer = client.post(f"{service}/api/v1/roller-strength", json=body).json()
    page.locator('[data-figure="rollers"] .toggle').click()
    rows = page.locator('[data-figure="rollers"] .figure-table tbody tr')
    expect(rows).to_have_count(4)
    shown = [float(row.split()[-1]) for row in rows.all_inner_texts()]
    assert shown == pytest.approx(answer["forces_N"], rel=1e-4)


def test_rollers_one_by_one(page: Page, service: str) -> None:
    show(page, service, "precession")
    assert figures(page) == ["40.22", "20.18", "0.02625"]

    cell(page, 4, "Position angle").fill("150")
    expect(page.locator(".verdict .cell .figures").first).not_to_have_text("40.22")
    settled(page)
    page.get_by_role("button", name="Remove row 4").click()
    expect(page.locator(".verdict")).to_contain_text("3 rollers")
    page.get_by_role("button", name="Add a row").click()
    cell(page, 4, "Position angle").fill("12o")
    settled(page, "wrong")
    expect(words_at(page, "rollers")).to_contain_text("Row 4, Position angle: Not a number")
    assert cell(page, 4, "Position angle").get_attribute("aria-invalid") == "true"
    cell(page, 4, "Position angle").fill("120")
    settled(page)
    assert figures(page) == ["40.22", "20.18", "0.02625"]
    address = page.url
    page.goto("about:blank")
    page.goto(address)
    settled(page)
    assert figures(page) == ["40.22", "20.18", "0.02625"]

    # What the service refuses stands at its row.
    cell(page, 2, "Working length to").fill("14")
    settled(page, "wrong")
    expect(words_at(page, "rollers")).to_contain_text("Row 2, Working length to")
    assert cell(page, 2, "Working length to").get_attribute("aria-invalid") == "true"
    assert cell(page, 2, "Working length to").input_value() == "14"


def test_a_wheel_and_a_stepped_shaft(page: Page, service: str) -> None:
    show(page, service, "precession")
    page.locator('[data-choice="rollersBy"] input[value="wheel"]').check(force=True)
    settled(page)
    expect(box(page, "wheel.rollers_in_mesh")).to_have_value("4")
    box(page, "wheel.rollers_total").fill("12")
    expect(page.locator(".verdict .cell .figures").first).to_have_text("40.22")
    settled(page)
    page.locator('[data-choice="shaftBy"] input[value="sections"]').check(force=True)
    settled(page)
    cell(page, 2, "Diameter").fill("30")
    expect(page.locator(".results [data-name=simplification_error_C]")).to_be_visible()
    assert result(page, "simplification_error_C") > 0
    box(page, "wheel.z_min_mm").fill("-5")
    settled(page, "refused")
    expect(page.locator(".verdict")).to_contain_text("phi = 0")
    assert box(page, "wheel.z_min_mm").input_value() == "-5"


@pytest.mark.parametrize("calculator", ["rollers", "precession"])
def test_nothing_of_another_calculator_is_loaded(
    page: Page, service: str, watch, calculator: str
) -> None:
    show(page, service, calculator)
    own = {"rollers": "roller-strength", "precession": "precession/"}[calculator]
    asked = [path for path in watch.calculations() if not path.endswith("/examples")]
    assert asked and all(path.startswith(f"/api/v1/{own}") for path in asked)
    modules = [path for path in watch.paths() if "/static/calculators/" in path]
    assert sorted(modules) == sorted(
        f"/static/calculators/{name}.js" for name in ("index", calculator)
    )
    expect(page.locator('[data-path="mechanism.pins"]')).to_have_count(0)


def test_what_was_typed_survives_another_tab(page: Page, service: str) -> None:
    show(page, service, "precession")
    cell(page, 1, "Position angle").fill("35")
    settled(page)
    page.keyboard.press("Alt+2")
    expect(page.get_by_role("tab", name="Swinging rollers")).to_have_attribute(
        "aria-selected", "true"
    )
    expect(page.locator(".verdict")).to_contain_text("rollers carry")
    page.keyboard.press("Alt+3")
    expect(cell(page, 1, "Position angle")).to_have_value("35")


def test_narrow_and_dark_without_sideways_scroll(page: Page, service: str) -> None:
    page.emulate_media(color_scheme="dark")
    for width in (390, 360):
        page.set_viewport_size({"width": width, "height": 800})
        for calculator in ("rollers", "precession"):
            show(page, service, calculator)
            assert no_sideways_scroll(page)
            tab = page.locator(f"#tab-{calculator}").bounding_box()
            assert tab and tab["x"] >= 0 and tab["x"] + tab["width"] <= width
    assert page.evaluate("() => watched.shift") < 0.02
