"""A field's menu: a result over the field, the inputs that matter."""

from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from core.precision import JUDGED
from tests.browser.calculator_page import ask, box, from_menu, settled, show, tab

RADIUS = "contact.pin_radius_mm"


def posted(page: Page, path: str) -> list[dict[str, Any]]:
    """Bodies of requests from now on."""
    bodies: list[dict[str, Any]] = []
    mine = f"/api/v1{path}"
    page.on("request", lambda one: one.url.endswith(mine) and bodies.append(one.post_data_json))
    return bodies


def test_a_point_of_a_sweep_loads_its_design_and_undo_leads_back(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    asked = posted(page, "/sweep")
    assert tab(page, "sweep").count() == 0 and not asked  # nothing before it is opened
    from_menu(page, RADIUS, "Sweep")
    sweep = page.locator('[data-explored="sweep"]')
    expect(sweep.locator(".scatterlayer .point")).to_have_count(13)
    [body] = asked
    assert body["axes"][0]["values"][0] == 5.6
    found = ask(service, "/sweep", body)
    sweep.get_by_role("button", name="Table").click()
    rows = sweep.locator("tbody tr")
    expect(rows).to_have_count(13)
    used = found["outputs"]["/checks/governing/utilisation"]
    cells = rows.nth(2).locator("td")
    assert float(cells.nth(1).inner_text()) == pytest.approx(100 * used[2], rel=JUDGED)
    expect(cells.nth(3)).to_have_text("Contact pressure of the hole")
    rows.nth(2).get_by_role("button").click()
    expect(box(page, RADIUS)).to_have_value("6.4")
    settled(page)
    expect(sweep.locator(".state")).to_have_text("")  # it is of this design as well
    assert len(asked) == 1
    page.get_by_role("button", name="Undo").click()
    expect(box(page, RADIUS)).to_have_value("8")
    settled(page)
    # of another torque it is of earlier inputs, until it is asked again
    box(page, "load.output_torque_Nm").fill("300")
    settled(page)
    expect(sweep.locator(".state")).to_have_text("Numbers of earlier inputs")
    sweep.locator('[data-part="from"]').fill("1")
    sweep.locator('[data-part="steps"]').fill("5")
    sweep.get_by_role("button", name="Calculate").click()
    expect(rows).to_have_count(5)
    # a click on a point of the figure is a click on its row
    sweep.get_by_role("button", name="Table").click()
    sweep.locator(".scatterlayer .point").nth(4).click(force=True)
    expect(box(page, RADIUS)).to_have_value("10.4")


def test_a_second_input_has_a_line_for_each_of_its_values(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    from_menu(page, RADIUS, "Sweep")
    sweep = page.locator('[data-explored="sweep"]')
    expect(sweep.locator(".scatterlayer .point")).to_have_count(13)
    asked = posted(page, "/sweep")
    sweep.locator('[data-part="steps"]').fill("x")
    expect(sweep.locator(".state")).to_contain_text("whole numbers from 2, at most 200")
    sweep.locator('[data-part="steps"]').fill("3")
    sweep.locator('[data-part="beside"]').select_option("contact.eccentricity_mm")
    sweep.locator('[data-part="quantity"]').select_option(label="Governing pressure")
    sweep.get_by_role("button", name="Calculate").click()
    expect(sweep.locator(".scatterlayer .point")).to_have_count(15)
    expect(sweep.locator(".legend .traces")).to_have_count(5)
    [body] = asked
    assert [len(each["values"]) for each in body["axes"]] == [3, 5]
    found = ask(service, "/sweep", body)
    sweep.get_by_role("button", name="Table").click()
    cells = sweep.locator("tbody tr").nth(7).locator("td")  # the second radius and the third line
    place = [each["values"][k] for each, k in zip(body["axes"], (1, 2), strict=True)]
    assert [float(cells.nth(k).inner_text()) for k in (0, 1)] == pytest.approx(place, rel=JUDGED)
    pressure = found["outputs"][body["outputs"][0]][7]
    assert float(cells.nth(2).inner_text()) == pytest.approx(pressure, rel=JUDGED)
    cells.nth(0).get_by_role("button").click()
    for path, value in zip((RADIUS, "contact.eccentricity_mm"), place, strict=True):
        assert float(box(page, path).input_value()) == pytest.approx(value)
    settled(page)
    expect(sweep.locator(".state")).to_have_text("")  # it is of this design as well


def test_the_check_that_governs_over_two_inputs_is_a_map(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    box(page, "load.output_torque_Nm").fill("900")
    settled(page)
    asked = posted(page, "/sweep")
    from_menu(page, RADIUS, "Sweep")
    sweep = page.locator('[data-explored="sweep"]')
    expect(sweep.locator(".scatterlayer .point")).to_have_count(13)
    for part, text in (("from", "6"), ("to", "10"), ("steps", "3")):
        sweep.locator(f'[data-part="{part}"]').fill(text)
    sweep.locator('[data-part="beside"]').select_option("mechanism.pins")
    for part, text in (("from2", "2"), ("to2", "4"), ("steps2", "3")):
        sweep.locator(f'[data-part="{part}"]').fill(text)
    sweep.get_by_role("button", name="Calculate").click()
    cells = sweep.locator(".barlayer .trace").first.locator(".point")
    expect(cells).to_have_count(6)
    found = ask(service, "/sweep", asked[-1])
    works = ["impossible", "incomplete", "incomplete"]
    assert found["status"] == ["impossible", "fail", "incomplete", *works, *works]
    used = [each for each in found["outputs"]["/checks/governing/utilisation"] if each]
    texts = sweep.locator(".barlayer text").all_text_contents()
    assert sorted(map(int, texts)) == sorted(round(100 * each) for each in used)
    failing, impossible = (
        sweep.locator(".barlayer .trace").nth(k).locator(".point") for k in (1, 2)
    )
    expect(failing).to_have_count(1)
    expect(impossible).to_have_count(3)
    for word in ("Contact pressure of the hole", "Fails", "100 % of the limit", "Design at hand"):
        expect(sweep.locator(".legend")).to_contain_text(word)
    frame = sweep.locator(".barlayer .trace").last.locator(".point path")
    before = frame.bounding_box()
    impossible.nth(2).hover(force=True)
    expect(sweep.locator(".hoverlayer")).to_contain_text("10\u00a0mm, 2: –Impossible: Dead centres")
    cells.nth(5).hover(force=True)
    expect(sweep.locator(".hoverlayer")).to_contain_text("Incomplete: Contact pressure of the hole")
    cells.nth(5).click(force=True)
    expect(box(page, RADIUS)).to_have_value("10")
    expect(box(page, "mechanism.pins")).to_have_value("4")
    settled(page)
    page.wait_for_function(
        """([frame, x]) => frame.getBoundingClientRect().x > x + 20""",
        arg=[frame.element_handle(), before["x"]] if before else None,
    )
    expect(sweep.locator(".state")).to_have_text("")  # it is of this design as well
    sweep.get_by_role("button", name="Table").click()
    expect(sweep.locator("tbody tr")).to_have_count(9)


def test_impossible_points_say_why_and_a_sweep_is_ended(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    from_menu(page, "mechanism.pins", "Sweep")
    sweep = page.locator('[data-explored="sweep"]')
    expect(sweep.locator(".legend")).to_contain_text("Impossible")
    sweep.get_by_role("button", name="Table").click()
    expect(sweep.locator("tbody tr").nth(1)).to_contain_text("Impossible")
    expect(sweep.locator("tbody tr").nth(1)).to_contain_text("Dead centres")
    held: list[Route] = []
    page.route("**/api/v1/sweep", lambda route: held.append(route))
    sweep.locator('[data-part="to"]').fill("9")
    sweep.get_by_role("button", name="Calculate").click()
    sweep.get_by_role("button", name="Stop").click()
    expect(sweep.locator(".state")).to_contain_text("Stopped.")


@pytest.mark.parametrize("calculator", ["crank-planetary", "rollers"])
def test_inputs_that_matter_come_by_their_change(page: Page, service: str, calculator: str) -> None:
    show(page, service, calculator)
    asked = posted(page, "/sensitivity")
    path = {"crank-planetary": RADIUS, "rollers": "diameter_mm"}[calculator]
    from_menu(page, path, "Sensitivity")
    rows = page.locator('[data-explored="sensitivity"] tbody tr')
    expect(rows.first).to_be_visible()
    inputs = ask(service, "/sensitivity", asked[0])["inputs"]
    expect(rows).to_have_count(len(inputs))
    paths = [one["pointer"][1:].replace("/", ".") for one in inputs]
    buttons = rows.get_by_role("button")
    assert buttons.evaluate_all("all => all.map((one) => one.dataset.sweep)") == paths
    buttons.first.click()
    expect(tab(page, "sweep")).to_have_attribute("aria-selected", "true")
    expect(page.locator('[data-explored="sweep"] .scatterlayer .point').first).to_be_attached()
