"""Beginning of a design: from a requirement, a known reducer, a paper, a file, a link."""

import json

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from app.examples import REQUESTS
from tests.browser.calculator_page import (
    address,
    begun,
    box,
    chosen,
    exported,
    picked,
    saved,
    settled,
    show,
)
from tests.browser.conftest import WATCH_SCRIPT, Watch

ASKED = {name: value for name, value in REQUESTS["propose"].items() if name != "wanted"}
SHIFT = 0.001  # of the layout, while the page is opened
NONE = {"torque_Nm": 500.0, "ratio": 20, "outer_diameter_mm": 60.0, "process": "ground"}


def unfolded(page: Page) -> None:
    page.get_by_role("button", name="New").click()
    expect(page.locator(".propose")).to_be_visible()


def filled(page: Page, asked: dict[str, object], path: str = "") -> None:
    """Type a request."""
    for name, value in asked.items():
        if isinstance(value, dict):
            filled(page, value, f"{path}{name}.")
            continue
        one = page.locator(f'.propose [data-path="{path}{name}"]').locator(".box")
        if not one.is_visible():
            page.locator(".propose [data-group=more] summary").click()
        if one.evaluate("node => node.tagName") == "SELECT":
            one.select_option(str(value))
        else:
            one.fill(f"{value:g}")


def test_who_comes_first_is_offered_three_ways(browser: Browser, service: str) -> None:
    """Once, over a computed design; the sheet is reached again by one word, and left by a key."""
    with browser.new_context(viewport={"width": 390, "height": 844}) as context:
        context.add_init_script(WATCH_SCRIPT)
        page = context.new_page()
        page.goto(service)
        sheet = page.get_by_role("dialog", name="New design")
        expect(sheet.get_by_role("heading", level=3)).to_have_text(
            ["What I need", "A reducer I know", "A paper’s figure, a file"]
        )
        expect(sheet.locator(".known .profile").first).to_be_visible()
        assert sheet.evaluate("one => one.scrollWidth <= one.clientWidth")
        settled(page)
        assert page.evaluate("() => watched.shift") < SHIFT
        page.keyboard.press("Escape")
        expect(sheet).to_have_count(0)
        expect(page.locator(".verdict .word")).to_contain_text("Incomplete")
        page.goto(service)
        settled(page)
        expect(sheet).to_have_count(0)
        new = page.get_by_role("button", name="New")
        new.press("Enter")
        sheet.get_by_role("button", name="Close").press("Enter")
        expect(new).to_be_focused()
        page.goto("about:blank")


def test_a_design_is_brought_as_a_file_or_as_a_link(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    picked(page, "cycloid")
    settled(page)
    link = address(page)
    file = exported(page, "json").read_text()
    kept = page.locator(".compare thead input")
    for text in (file, json.dumps(json.loads(file)["requests"][-1]["body"])):
        picked(page, "clearance")
        settled(page)
        unfolded(page)
        page.locator("#start [type=file]").set_input_files(
            {"name": "a.json", "mimeType": "application/json", "buffer": text.encode()}
        )
        expect(page.locator("#start")).to_have_count(0)
        settled(page)
        assert address(page) == link
    page.get_by_role("button", name="Compare").click()
    designs = saved(page, page.get_by_role("button", name="Save all to a file")).read_text()
    picked(page, "clearance")
    begun(page, ".box.free-text")
    pasted = page.get_by_label("Paste a link or JSON")
    pasted.fill("17")
    pasted.press("Enter")
    expect(page.locator("#start .refused")).to_contain_text("no link")
    pasted.fill(designs)
    pasted.press("Enter")
    expect(page.locator("#start")).to_have_count(0)
    expect(kept).to_have_count(2)
    settled(page)
    assert address(page) == link
    picked(page, "clearance")
    begun(page, ".box.free-text")
    pasted.fill(link)
    pasted.press("Enter")
    expect(box(page, "mechanism.satellite_teeth")).to_have_value("20")
    settled(page)


def test_a_button_that_works_says_so(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    held: list[Route] = []
    page.get_by_role("tab", name="Forces").click()
    page.route("**/crank-planetary/chart*", lambda route: held.append(route))
    png = page.get_by_role("button", name="Contact forces: save as PNG")
    with page.expect_download():
        png.click()
        expect(png).to_have_attribute("aria-busy", "true")
        held[0].continue_()
    expect(png).not_to_have_attribute("aria-busy", "true")
    page.unroute("**/crank-planetary/chart*")
    page.get_by_role("button", name="Export").click()
    page.evaluate(
        "() => { globalThis.print = () => { globalThis.done = export_is_open(); };"
        " globalThis.export_is_open = () => document.querySelector('#export').open; }"
    )
    page.locator("#export [data-do=print]").click()
    page.wait_for_function("() => 'done' in globalThis")
    assert page.evaluate("() => done") is False


def test_the_name_is_typed_in_the_bar_and_said_in_the_link(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    name = page.get_by_label("Name of the design")
    name.fill("Joint 3")
    expect(page).to_have_title("Joint 3 · Crank-planetary reducer · KHV Calc")
    expect(page.locator(".naming")).to_have_attribute("data-saved", "true")
    assert "title=Joint+3" in page.url
    page.get_by_role("button", name="Export").click()
    page.get_by_label("Author").fill("N. N.")
    page.keyboard.press("Escape")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Share").click()
    expect(page.locator("#live")).to_have_text("Link copied.")
    assert page.evaluate("() => navigator.clipboard.readText()") == address(page)
    assert "author=N.+N." in page.url


def test_a_ring_that_pieces_press_too_hard_makes_it_marginal(page: Page, service: str) -> None:
    """Parts without errors pass."""
    show(page, service, "crank-planetary")
    unfolded(page)
    filled(page, ASKED | {"outer_diameter_mm": 80.0, "length_mm": 50.0})
    page.locator('.propose [data-path="torque_Nm"] .box').press("Enter")
    expect(page.locator(".proposal").first).to_contain_text("Just works")


def test_a_proposal_is_found_and_opened(page: Page, service: str, watch: Watch) -> None:
    show(page, service, "crank-planetary")
    before = address(page)
    assert not any("propose" in path for path in watch.paths())
    unfolded(page)
    assert watch.paths()[-1] != "/api/v1/propose"
    filled(page, ASKED)
    page.locator('.propose [data-path="torque_Nm"] .box').press("Enter")
    expect(page.get_by_role("button", name="Cancel")).to_be_enabled()
    row = page.locator(".proposal").first
    expect(row).to_contain_text("20:1")
    expect(row).to_contain_text("Works")
    expect(row.locator("dl > div")).to_have_count(6)
    expect(row.locator("svg .profile")).to_have_count(2)
    expect(page.locator(".propose .state")).to_contain_text("Estimated")  # the search is over
    cell = row.locator("dl > div").nth(3).locator("dd")
    largest = (cell.text_content() or "").split("\u00a0")[0]
    efficiency = row.locator("dl > div").nth(5).locator("dd").inner_text()
    sheet = page.locator("#start")
    assert sheet.evaluate("one => one.scrollWidth <= one.clientWidth")
    row.get_by_role("button", name="Open design 20:1").click()
    expect(sheet).to_have_count(0)
    expect(box(page, "load.output_torque_Nm")).to_have_value("20")
    settled(page)
    expect(page.locator(".verdict .word")).to_have_text("✓Works")
    shown = page.locator(".verdict .torque .figures")
    expect(shown).not_to_have_text("…")
    assert float(shown.inner_text()) == pytest.approx(float(largest), rel=0.01)
    needed = page.locator(".summary .cell").nth(3)
    expect(needed).to_contain_text(f"efficiency {efficiency}")
    expect(needed).to_contain_text("Needed at the input")
    life = page.locator('[data-path="requirements.life_h"]')
    expect(life).to_have_attribute("data-origin", "usual")  # which was not asked for
    expect(life.locator(".box")).to_have_attribute("placeholder", "5000")
    address(page)
    page.go_back()
    settled(page)
    assert address(page) == before
    unfolded(page)
    expect(row).to_be_visible()  # another one may be opened
    page.keyboard.press("Escape")
    chosen(page, "language", "uk")
    settled(page)
    page.locator('[data-tool="new"]').click()
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


def test_another_way_to_make_it_is_searched_by_one_click(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    unfolded(page)
    filled(page, {"torque_Nm": 500.0, "ratio": 20, "outer_diameter_mm": 180.0})
    page.get_by_role("button", name="Search").click()
    page.locator(".propose .none").get_by_role("button", name="Ground").press("Enter")
    expect(page.locator(".proposals .word").first).to_contain_text("Just works")
    process = page.locator('.propose [data-path="process"] .box')
    expect(process).to_have_value("ground")
    expect(process).to_be_focused()


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
