"""Workbench of every calculator: undo, units, files, links, designs side by side."""

import csv
import io
import json
import re
import sys
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from core.precision import JUDGED, SAME
from tests.browser.calculator_page import (
    address,
    ask,
    box,
    choose,
    chosen,
    first_example,
    from_menu,
    number,
    reopen,
    result,
    saved,
    settled,
    show,
    tab,
    verdict,
)
from tests.browser.conftest import Watch
from tests.inputs.children import ran

TORQUE = "load.output_torque_Nm"


def leading_number(text: str) -> float:
    """The number that a cell begins with."""
    found = re.match(r"[\d.\u202f]+", text.removeprefix("★"))
    assert found, text
    return number(found[0])


def test_undo_and_redo_bring_back_inputs_and_numbers(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    undo = page.get_by_role("button", name="Undo")
    expect(undo).to_be_disabled()
    first = verdict(page, 0).inner_text()
    box(page, TORQUE).fill("70")
    box(page, TORQUE).press("Enter")
    settled(page)
    second = verdict(page, 0).inner_text()
    choose(page, "cranks", "list")
    settled(page)
    undo.click()
    expect(page.locator('[data-choice="cranks"] input[value="spacing"]')).to_be_checked()
    page.keyboard.press("ControlOrMeta+z")
    expect(verdict(page, 0)).to_have_text(first)
    page.keyboard.press("ControlOrMeta+Shift+z")
    expect(verdict(page, 0)).to_have_text(second)
    expect(box(page, TORQUE)).to_have_value("70")
    page.keyboard.press("ControlOrMeta+y")
    expect(page.locator('[data-choice="cranks"] input[value="list"]')).to_be_checked()
    expect(page.get_by_role("button", name="Redo")).to_be_disabled()


def test_what_was_typed_elsewhere_survives_a_reload(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    box(page, TORQUE).fill("7o")
    page.locator("#tab-rollers").click()
    settled(page)
    page.reload()
    settled(page)
    page.locator("#tab-crank-planetary").click()
    settled(page, "wrong")
    expect(box(page, TORQUE)).to_have_value("7o")


def test_units_are_shown_and_typed_as_chosen_and_stay_canonical_underneath(
    page: Page, service: str
) -> None:
    show(page, service, "crank-planetary")
    force = result(page, "peak_force_N")
    radius = box(page, "contact.pin_radius_mm").input_value()
    link = address(page)
    chosen(page, "units", "us")
    settled(page)
    assert address(page) == link
    assert result(page, "peak_force_N") == pytest.approx(force / 4.4482216, rel=JUDGED)
    expect(page.locator('.results [data-name="peak_force_N"] .unit-cell')).to_have_text("lbf")
    expect(page.locator('[data-figure="force"] .ytitle')).to_have_text("Contact force, lbf")
    top = page.evaluate("() => document.querySelector('[data-figure=force] .plot').layout.yaxis")
    assert top["range"][1] == pytest.approx(1.15 * force / 4.4482216, rel=1e-4)

    box(page, "contact.pin_radius_mm").fill("0.3")
    box(page, "contact.pin_radius_mm").press("Enter")
    settled(page)
    asked = httpx.URL(address(page)).params["contact.pin_radius_mm"]
    assert float(asked) == pytest.approx(7.62, rel=SAME)
    page.get_by_role("button", name="Undo").click()
    address(page)  # the browser is not to load again while the page writes it
    page.reload()
    settled(page)
    expect(page.locator('[data-path="contact.pin_radius_mm"] .unit')).to_have_text("in")

    chosen(page, "units", "metric")
    settled(page)
    expect(box(page, "contact.pin_radius_mm")).to_have_value(radius)
    assert result(page, "peak_force_N") == force


def test_limits_are_said_in_the_units_shown(page: Page, service: str) -> None:
    show(page, service, "rollers")
    chosen(page, "units", "us")
    box(page, "diameter_mm").fill("1e15")
    settled(page, "wrong")
    words = page.locator('[data-path="diameter_mm"] .field-message')
    expect(words).to_contain_text("Must be 3.93701\u202f×\u202f10¹⁰ or less")  # 1e12 mm


def test_the_csv_of_a_figure_is_the_services_answer(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    path = saved(page, page.get_by_role("button", name="Contact forces: save as CSV"))
    head, *rows = csv.reader(io.StringIO(path.read_text("utf-8")))
    example = first_example(service, "crank-planetary")
    body = {**example["mechanism"], **example["load"], "include": ["curves"]}
    curves = ask(service, "/contact-force", body)["curves"]
    assert head[0] == "Crank angle, °" and head[1] == "S1 P1, N"
    table = [[float(value) for value in row] for row in rows]
    assert [row[0] for row in table] == curves["crank_angle_deg"]
    for index, force in enumerate(curves["force_N"], start=1):
        assert [row[index] for row in table] == force


def test_a_figure_without_a_list_of_numbers_gives_its_curves(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    tab(page, "hertz").click()
    expect(page.locator('[data-figure="hertz"] .js-line').first).to_be_attached()
    path = saved(page, page.get_by_role("button", name="Pressure over the contact: save as CSV"))
    lines = path.read_text("utf-8").splitlines()
    assert lines[1] == '"Place along the arc of the pin, mm","Hertz, MPa"'
    pressures = [float(line.split(",")[1]) for line in lines[2 : lines.index("")]]
    assert max(pressures) == pytest.approx(result(page, "max_pressure_MPa"), rel=JUDGED)
    page.get_by_role("button", name="Pressure over the contact: Show as a table").click()
    expect(page.locator('[data-figure="hertz"] .figure-table th').first).to_contain_text("Place")


def test_figures_are_saved_as_pictures_for_paper(page: Page, service: str) -> None:
    page.emulate_media(color_scheme="dark")
    show(page, service, "crank-planetary")
    expect(page.locator('[data-figure="force"] .js-line').first).to_be_attached()
    path = saved(page, page.get_by_role("button", name="Contact forces: save as SVG"))
    picture = path.read_text("utf-8")
    assert picture.startswith("<svg") and "Contact force, N" in picture
    assert "fill: rgb(255, 255, 255)" in picture
    png = saved(page, page.get_by_role("button", name="Contact forces: save as PNG")).read_bytes()
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert int.from_bytes(png[16:20], "big") == 1800


def test_the_request_runs_elsewhere_and_gives_the_same(
    page: Page, service: str, tmp_path: Path
) -> None:
    show(page, service, "precession")
    page.get_by_role("button", name="Export").click()
    code = page.get_by_label("Request in Python", exact=True).inner_text()
    done = ran(sys.executable, "-c", code)
    assert "deflection_C_mm" in done.stdout
    kept = json.loads(saved(page, page.get_by_role("button", name="JSON")).read_text("utf-8"))
    assert [each["path"] for each in kept["requests"]] == [
        f"/api/v1/precession/{name}"
        for name in ("contact-line", "meshing-load", "shaft-deflection")
    ]
    for each in kept["requests"]:
        answer = httpx.post(service + each["path"], json=each["body"], trust_env=False).json()
        for one in (answer, each["answer"]):
            one.pop("accuracy")
        assert answer == each["answer"]
    path = saved(page, page.get_by_role("button", name="All results, CSV"))
    rows = list(csv.DictReader(io.StringIO(path.read_text("utf-8"))))
    total = next(row for row in rows if row["name"] == "deflection_C_mm.total")
    assert float(total["value"]) == kept["requests"][-1]["answer"]["deflection_C_mm"]["total"]
    assert total["unit"] == "mm"


def test_designs_stand_side_by_side_with_their_curves(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    page.get_by_role("button", name="Compare").click()
    named = page.get_by_label("Name of design A").element_handle()
    assert named
    box(page, TORQUE).fill("1000")
    box(page, TORQUE).press("Enter")
    settled(page)
    compare = page.locator(".compare-table")
    own = compare.get_by_role("row", name="Output torque").get_by_role("cell").first
    expect(own).to_have_text("1000")  # the table and the figure come after the numbers
    assert named.evaluate("(box) => box.isConnected")  # a name that is being typed stays
    tab(page, "force").click()
    page.wait_for_function(
        "(top) => document.querySelector('[data-figure=force] .plot').layout?.yaxis.range[1] > top",
        arg=1000 * 6666.67 / 280,
    )
    tab(page, "compare").click()
    force = compare.get_by_role("row", name="Peak force, ideal N")
    cells = [leading_number(text) for text in force.get_by_role("cell").all_inner_texts()]
    assert cells[0] == pytest.approx(result(page, "peak_force_N"), rel=1e-4)
    torque = compare.get_by_role("row", name="Output torque").get_by_role("cell")
    now, kept = (leading_number(text) for text in torque.all_inner_texts())
    assert now == 1000 and cells[1] == pytest.approx(cells[0] * kept / now, rel=1e-4)
    expect(force.locator(".differs")).to_have_count(1)
    expect(compare.get_by_role("row", name="Pins", exact=False)).to_have_count(0)
    drawn = page.evaluate(
        "() => document.querySelector('[data-figure=force] .plot').data"
        ".filter((trace) => trace.name === 'A').map(({ line, y }) => [line.dash, Math.max(...y)])"
    )
    (dashed, top), (_, point) = drawn  # the largest force of the kept design, and its peak
    assert dashed == "dash"
    assert top == pytest.approx(cells[1], rel=1e-4) and point == pytest.approx(cells[1], rel=1e-4)

    reopen(page)  # kept in the browser
    tab(page, "compare").click()
    page.get_by_label("Name of design A").fill("first")
    page.get_by_label("Name of design A").press("Enter")
    path = saved(page, page.get_by_role("button", name="Save all to a file"))
    page.get_by_role("button", name="Remove design first").click()
    expect(compare).to_contain_text("Keep designs to see them")
    page.get_by_role("button", name="New").click()
    page.get_by_label("Open a file").set_input_files(path)
    expect(box(page, TORQUE)).to_have_value(f"{kept:g}")
    settled(page)
    assert result(page, "peak_force_N") == pytest.approx(cells[1], rel=1e-4)


def test_a_part_that_does_not_load_is_said_and_the_page_is_loaded_anew(
    page: Page, service: str, watch: Watch
) -> None:
    """Chromium keeps that a module could not be loaded as long as the page."""
    show(page, service, "crank-planetary")
    box(page, TORQUE).fill("270")
    settled(page)
    missing = ("views/large.js", "views/start.js", "views/explore.js", "views/real.js")
    for name in missing:
        page.route(f"**/{name}", lambda route: route.abort())
    again = page.locator(".unloaded").get_by_role("button", name="Try again")
    tries = (
        lambda: page.locator(".mechanism .enlarge").click(),
        lambda: page.get_by_role("button", name="New").click(),
        lambda: from_menu(page, "contact.pin_radius_mm", "Sweep"),
        lambda: page.locator('[data-path="real.on"] input').check(),
    )
    for attempt in tries:
        page.evaluate("() => document.querySelector('.unloaded')?.remove()")
        attempt()
        expect(again).to_be_visible()
        expect(page.locator(".unloaded")).to_contain_text("could not be loaded")
    for name in missing:
        page.unroute(f"**/{name}")
    again.click()
    expect(again).to_have_count(0)
    settled(page)
    expect(box(page, TORQUE)).to_have_value("270")
    page.get_by_role("button", name="New").click()
    expect(page.locator("#start")).to_be_visible()
    watch.complaints = [line for line in watch.complaints if "ERR_FAILED" not in line]
