"""The drawings: to scale, moving with the figures, tied to the form; effects, not presence."""

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from tests.browser.calculator_page import ask, box, first_example, picked, settled, show, tab

FORCES = {
    "mechanism.pins": "6",
    "mechanism.satellites": "1",
    "mechanism.ratio": "20",
    "load.output_torque_Nm": "50",
    "load.pin_circle_radius_mm": "32.5",
    "contact.contact_length_mm": "20",
    "contact.pin_radius_mm": "5",
    "contact.hole_radius_mm": "6.5",
}

MOVE = """(slider, angle) => {
  slider.value = angle;
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}"""

ARROWS = """() => [...document.querySelectorAll(".drawing svg > .force.arrow")].map((arrow) => {
  if (arrow.classList.contains("none")) return 0;
  const value = (name) => Number(arrow.querySelector(".shaft").getAttribute(name));
  return Math.hypot(value("x2") - value("x1"), value("y2") - value("y1"));
})"""

TIPS = """() => [...document.querySelectorAll(".drawing svg > .force.arrow:not(.none) .shaft")]
  .map((shaft) => [Number(shaft.getAttribute("x2")), Number(shaft.getAttribute("y2"))])"""

CURSOR = """(id) => {
  const canvas = document.querySelector(`[data-figure="${id}"] .canvas`);
  const bar = canvas.querySelector(".cursor");
  return !bar.hidden ? bar.getBoundingClientRect().x - canvas.getBoundingClientRect().x : null;
}"""

AXIS = """([id, angle]) => {
  const plot = document.querySelector(`[data-figure="${id}"] .plot`);
  const { xaxis } = plot._fullLayout;
  return xaxis._offset + xaxis.l2p(angle);
}"""


OUTSIDE = """() => {
      const room = document.querySelector(".drawing").getBoundingClientRect();
      return [...document.querySelectorAll(".drawing svg text")].filter((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        const outside = left < room.left - 1 || right > room.right + 1
          || top < room.top - 1 || bottom > room.bottom + 1;
        return outside && getComputedStyle(text).visibility === "visible";
      }).map((text) => text.textContent);
    }"""


def slider(page: Page) -> Any:
    return page.get_by_role("slider", name="Crank angle")


def drawn(page: Page) -> None:
    """Wait until the mechanism stands there with its forces, and the figures under it."""
    expect(page.locator(".drawing svg > .force.arrow:not(.none)").first).to_be_attached()
    for figure in ("cyclogram", "force"):
        tab(page, figure).click()
        expect(page.locator(f'[data-figure="{figure}"] .cursor')).to_be_attached()


def open_mechanism(page: Page, service: str, **fields: str) -> None:
    show(page, service, "crank-planetary", **(FORCES | fields))
    drawn(page)


def geometry(service: str, angle: float) -> Any:
    """Pins, holes and forces at a crank angle, by the service."""
    body = {
        "mechanism": {"pins": 6, "satellites": 1, "ratio": 20},
        "load": {"output_torque_Nm": 50, "pin_circle_radius_mm": 32.5},
        "contact": {"contact_length_mm": 20, "pin_radius_mm": 5, "hole_radius_mm": 6.5},
        "crank_angle_deg": angle,
        "include": ["geometry"],
    }
    return ask(service, "/crank-planetary", body)["geometry"]


def scale(page: Page, name: str) -> float:
    return float(page.locator(".drawing svg").get_attribute(f"data-{name}") or "nan")


def test_arrows_are_as_long_as_the_forces_and_end_at_the_contact_points(
    page: Page, service: str
) -> None:
    open_mechanism(page, service)
    for angle in (0, 17.5, 90, 171.5, 233, 359):
        arrows_are_right(page, service, angle)


def arrows_are_right(page: Page, service: str, angle: float) -> None:
    slider(page).evaluate(MOVE, angle)
    pairs = geometry(service, angle)["pairs"]
    px, newton = scale(page, "px-per-mm"), scale(page, "px-per-mm") * scale(page, "mm-per-n")
    longest = 888.24 * newton  # of a pixel's rounding and half a degree's interpolation
    for length, pair in zip(page.evaluate(ARROWS), pairs, strict=True):
        assert length == pytest.approx(pair["force_N"] * newton, abs=2e-4 * longest + 0.02)
    centre = page.evaluate(
        "() => { const r = document.querySelector('.drawing .pin-circle');"
        " return [Number(r.getAttribute('cx')), Number(r.getAttribute('cy'))] }"
    )
    points = [pair["contact_point_mm"] for pair in pairs if pair["driving"]]
    expected = [[centre[0] + x * px, centre[1] - y * px] for x, y in points]
    for tip, point in zip(page.evaluate(TIPS), expected, strict=True):
        assert tip == pytest.approx(point, abs=0.02)


LOOSE = {
    "contact.hole_radius_mm": "",
    "contact.eccentricity_mm": "1.5",
    "contact.hole_clearance_mm": "0.02",
}

TRACES = """(id) => document.querySelector(`[data-figure="${id}"] .plot`).data
  .map(({ name, y, base, x, line, marker }) => (
    { name, y, base, x, width: (line ?? marker.line)?.width }))"""


def test_of_a_loose_mechanism_all_shows_the_forces_that_are_solved(
    page: Page, service: str, watch: Any
) -> None:
    open_mechanism(page, service, **LOOSE)
    design = {
        "mechanism": {"pins": 6, "satellites": 1, "ratio": 20},
        "load": {"output_torque_Nm": 50, "pin_circle_radius_mm": 32.5},
        "contact": {
            "contact_length_mm": 20,
            "pin_radius_mm": 5,
            "eccentricity_mm": 1.5,
            "hole_clearance_mm": 0.02,
        },
    }
    sections = ["contact_force", "load_sharing", "real_cyclogram"]
    answer: Any = ask(service, "/crank-planetary", design | {"include": sections})
    peak, ideal = (answer[each]["peak_force_N"] for each in ("load_sharing", "contact_force"))
    assert peak > 1.2 * ideal
    # The drawing starts at the real peak, with the real forces.
    newton = scale(page, "px-per-mm") * scale(page, "mm-per-n")
    start = answer["load_sharing"]["peak_crank_angle_deg"]
    asked = len(watch.paths())
    for angle in (None, 100, 200):
        if angle is not None:
            slider(page).evaluate(MOVE, angle)
        at = start if angle is None else angle
        position: Any = ask(service, "/load-sharing", design | {"crank_angle_deg": [at]})
        forces = position["positions"][0]["force_N"][0]
        for length, force in zip(page.evaluate(ARROWS), forces, strict=True):
            assert length == pytest.approx(force * newton, abs=2e-3 * peak * newton + 0.02)
        driving = page.locator(".satellite .hole.driving")
        # at the peak another pair takes up: what it carries there is a matter of the last digit
        expect(driving).to_have_count(sum(force > 1e-6 * peak for force in forces))
    assert len(watch.paths()) == asked
    expect(page.locator(".mechanism .scale")).to_contain_text("The forces are the real ones")
    # The figures: the real forces strong, the ideal ones thin, and no ideal figure besides.
    force = {trace["name"]: trace for trace in page.evaluate(TRACES, "force")}
    strong, thin = force["Largest force, real"], force["Largest force, ideal"]
    assert max(strong["y"]) == pytest.approx(peak, rel=1e-4)
    assert max(thin["y"]) == pytest.approx(ideal, rel=1e-3) and thin["width"] < strong["width"]
    bars, *_, outlines = (one for one in page.evaluate(TRACES, "cyclogram") if one["base"])
    carried = {
        (f"{pair['satellite']}.{pair['pin']}", round(start, 4), round(stop - start, 4))
        for pair in answer["real_cyclogram"]["pairs"]
        for start, stop in pair["loaded_deg"]
    }
    rows = zip(bars["y"], bars["base"], bars["x"], strict=True)
    assert {(row, round(start, 4), round(length, 4)) for row, start, length in rows} == carried
    assert outlines["name"] == "Ideal" and sum(outlines["x"]) > 1.2 * sum(bars["x"])
    charts = [path for path in watch.paths() if path.endswith("/chart")]
    assert charts.count("/api/v1/crank-planetary/chart") == 2
    # Kept and tightened: each design by its own model.
    page.get_by_role("button", name="Compare").click()
    tab(page, "force").click()
    box(page, "contact.hole_clearance_mm").fill("0.04")
    settled(page)
    page.wait_for_function(
        "() => document.querySelector('[data-figure=force] .plot').data"
        ".filter(({ name }) => name === 'A').length === 2"
    )
    kept = [trace for trace in page.evaluate(TRACES, "force") if trace["name"] == "A"]
    assert max(kept[0]["y"]) == pytest.approx(peak, rel=1e-4)
    names = page.locator(".compare-table tbody th")
    for name in ("Peak force, ideal N", "Real peak force N", "Backlash, largest ′"):
        expect(names.filter(has_text=name)).to_have_count(1)
    titles = names.all_text_contents()
    assert len(titles) == len(set(titles))


def test_the_slider_moves_everything_and_asks_nothing(page: Page, service: str, watch: Any) -> None:
    open_mechanism(page, service)
    before = len(watch.requests)
    for angle in (12.5, 180, 300.5):
        slider(page).evaluate(MOVE, angle)
        for figure in ("cyclogram", "force"):
            tab(page, figure).click()
            at = page.evaluate(CURSOR, figure)
            assert at == pytest.approx(page.evaluate(AXIS, [figure, angle]), abs=1.5)
        turned = page.locator(".drawing .pins").get_attribute("transform") or ""
        assert float(turned.split("(")[1].split()[0]) == pytest.approx(-angle / 20)
    assert watch.requests[before:] == []


def test_the_slider_runs_as_far_as_the_cyclogram(page: Page, service: str) -> None:
    open_mechanism(page, service, **{"mechanism.revolutions": "3"})
    expect(slider(page)).to_have_attribute("max", "1080")
    slider(page).evaluate(MOVE, 801)
    newton = scale(page, "px-per-mm") * scale(page, "mm-per-n")
    longest = 888.24 * newton
    for length, pair in zip(page.evaluate(ARROWS), geometry(service, 801)["pairs"], strict=True):
        assert length == pytest.approx(pair["force_N"] * newton, abs=1e-3 * longest + 0.02)
    tab(page, "cyclogram").click()
    assert page.evaluate(CURSOR, "cyclogram") is not None
    tab(page, "force").click()
    assert page.evaluate(CURSOR, "force") is None, "its axis ends at one turn"


def test_a_bar_selects_its_pair_everywhere(page: Page, service: str) -> None:
    open_mechanism(page, service)
    tab(page, "cyclogram").click()
    bar = page.locator('[data-figure="cyclogram"] .barlayer path').first
    bar.evaluate("(path) => path.scrollIntoView({ block: 'center' })")
    at = bar.bounding_box()
    assert at
    place = (at["x"] + at["width"] / 2, at["y"] + at["height"] / 2)
    page.mouse.click(*place)
    chosen = page.locator("#pair")
    expect(chosen).not_to_have_value("")
    name = chosen.input_value()
    hole = page.locator(".drawing .satellite .hole.selected")
    expect(hole).to_have_attribute("data-pair", name)
    expect(page.locator(f'.drawing .force.selected[data-pair="{name}"]')).to_be_attached()
    lit = """() => {
      const plot = document.querySelector('[data-figure="force"] .plot');
      return plot.data.filter((t) => /^\\d+\\.\\d+$/.test(t.name) && (t.opacity ?? 1) === 1)
        .map((t) => t.name);
    }"""
    assert page.evaluate(lit) == [name]
    bright = """() => {
      const plot = document.querySelector('[data-figure="cyclogram"] .plot');
      return [...new Set(plot.data.filter((t) => t.type === "bar")
        .flatMap((t) => t.y.filter((_, i) => t.marker.opacity[i] === 1)))];
    }"""
    assert page.evaluate(bright) == [name]
    expect(page.locator(".drawing .title")).to_contain_text(f"pin {name[2:]}")
    page.mouse.click(*place)
    expect(hole).to_have_count(0)
    expect(chosen).to_have_value("")
    assert page.evaluate(lit) == []  # all are thin below the largest force
    page.mouse.click(*place)
    expect(hole).to_have_count(1)
    page.keyboard.press("Escape")
    expect(hole).to_have_count(0)
    assert page.evaluate(lit) == []  # all are thin below the largest force


def test_the_keyboard_alone_does_it(page: Page, service: str) -> None:
    open_mechanism(page, service)
    slider(page).focus()
    page.keyboard.press("Home")
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    expect(page.locator(".motion output")).to_have_text("φ = 2°")
    expect(slider(page)).to_have_attribute("aria-valuetext", "φ = 2°")
    page.locator("#pair").focus()
    page.keyboard.press("ArrowDown")
    expect(page.locator(".drawing .satellite .hole.selected")).to_have_count(1)
    page.keyboard.press("Escape")
    expect(page.locator(".drawing .satellite .hole.selected")).to_have_count(0)


def test_it_plays_and_stops(page: Page, service: str) -> None:
    open_mechanism(page, service)
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".motion output")).not_to_have_text("φ = 0°")
    page.get_by_role("button", name="Pause").click()
    held = page.locator(".motion output").inner_text()
    page.wait_for_timeout(200)
    expect(page.locator(".motion output")).to_have_text(held)


def test_nothing_moves_by_itself_where_motion_is_not_wanted(browser: Browser, service: str) -> None:
    context = browser.new_context(reduced_motion="reduce", viewport={"width": 1440, "height": 900})
    page = context.new_page()
    open_mechanism(page, service)
    expect(page.get_by_role("button", name="Play")).to_have_count(0)
    slider(page).focus()
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".motion output")).to_have_text("φ = 0.5°")
    context.close()


def test_a_field_and_its_part_point_at_each_other(page: Page, service: str) -> None:
    open_mechanism(page, service)
    lit = page.locator(".drawing .lit")
    box(page, "contact.pin_radius_mm").focus()
    assert lit.count() > 0
    assert {"contact.pin_radius_mm"} <= set(
        " ".join(lit.evaluate_all("(all) => all.map((e) => e.dataset.field)")).split()
    )
    page.locator('[data-path="load.pin_circle_radius_mm"] label').hover()
    paths = set(" ".join(lit.evaluate_all("(all) => all.map((e) => e.dataset.field)")).split())
    assert paths == {"load.pin_circle_radius_mm"}
    page.locator(".drawing .dimension", has_text="R =").locator("text").dispatch_event(
        "pointerover"
    )
    expect(page.locator('[data-path="load.pin_circle_radius_mm"].lit')).to_be_attached()


def test_a_drawing_has_no_forces_until_those_of_the_newest_answer_are_there(
    page: Page, service: str
) -> None:
    open_mechanism(page, service)
    forces = page.locator(".drawing svg > .force.arrow:not(.none)")
    held: list[Route] = []
    page.route("**/chart*", lambda route: held.append(route))
    box(page, "contact.hole_radius_mm").fill("8")
    settled(page)
    expect(page.locator('.mechanism[data-stale="false"]')).to_contain_text("8 mm")
    expect(forces).to_have_count(0)
    for route in held:
        route.continue_()
    expect(forces.first).to_be_attached()


def test_a_changed_size_is_drawn_and_the_angle_stays(page: Page, service: str) -> None:
    open_mechanism(page, service)
    slider(page).evaluate(MOVE, 90)
    box(page, "contact.hole_radius_mm").fill("8")
    settled(page)
    expect(page.locator(".drawing")).to_contain_text("8 mm")
    expect(page.locator(".motion output")).to_have_text("φ = 90°")
    hole = page.locator(".drawing .satellite .hole").first
    assert float(hole.get_attribute("r") or 0) == pytest.approx(
        8 * scale(page, "px-per-mm"), abs=0.01
    )


def test_a_dead_centre_is_drawn_without_forces(page: Page, service: str) -> None:
    fields = FORCES | {"mechanism.pins": "2"}
    version = "&".join(f"{name}={value}" for name, value in fields.items())
    page.goto(f"{service}/?calculator=crank-planetary&v=2&{version}")
    settled(page, "refused")
    expect(page.locator(".drawing .satellite .hole")).to_have_count(2)
    slider(page).evaluate(MOVE, 100)
    assert all(length == 0 for length in page.evaluate(ARROWS))
    assert "NaN" not in page.locator(".drawing").inner_html()


@pytest.mark.parametrize("width", [1440, 390, 360])
def test_nothing_shifts_and_nothing_overflows(page: Page, service: str, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    show(page, service, "crank-planetary", **FORCES)
    expect(page.locator(".drawing svg > .force.arrow:not(.none)").first).to_be_attached()
    assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
    assert page.evaluate("() => watched.shift") < 0.02
    assert page.evaluate(OUTSIDE) == []


FIELDS = [
    ("crank-planetary", "contact.pin_radius_mm"),
    ("rollers", "sphere_width_mm"),
    ("precession", "overhang_mm nutation_angle_deg"),
]


@pytest.mark.parametrize(("calculator", "paths"), FIELDS)
def test_a_field_lights_its_part_in_every_calculator(
    page: Page, service: str, calculator: str, paths: str
) -> None:
    show(page, service, calculator)
    for path in paths.split():
        part = page.locator(f'.drawing [data-field~="{path}"]').first
        expect(part).to_be_attached()
        box(page, path).focus()
        expect(page.locator(f'.drawing .lit[data-field~="{path}"]').first).to_be_attached()
        part.dispatch_event("pointerover")
        expect(page.locator(f'.field.lit[data-path="{path}"]')).to_be_attached()


SHAFT = """(arrow) => {
  const shaft = arrow.querySelector(".shaft");
  if (!shaft) return 0;
  const value = (name) => Number(shaft.getAttribute(name));
  return Math.hypot(value("x2") - value("x1"), value("y2") - value("y1"));
}"""


def test_the_rollers_arrows_are_their_forces(page: Page, service: str) -> None:
    show(page, service, "rollers")
    answer = ask(service, "/roller-strength", first_example(service, "roller-strength"))
    arrows = page.locator(".drawing [data-roller]")
    expect(arrows).to_have_count(len(answer["forces_N"]))
    for arrow, force in zip(arrows.all(), answer["forces_N"], strict=True):
        assert arrow.evaluate(SHAFT) == pytest.approx(force * scale(page, "px-per-n"), abs=0.02)
    box(page, "position_tolerance_mm").fill("0.1")
    box(page, "position_tolerance_mm").press("Enter")
    settled(page)
    expect(page.locator(".drawing .body.idle")).to_have_count(len(answer["forces_N"]) - 1)
    expect(arrows).to_have_count(1)


def test_the_shaft_shows_reactions_and_its_deflection(page: Page, service: str) -> None:
    show(page, service, "precession")
    example = first_example(service, "precession/shaft-deflection")
    answer = ask(service, "/precession/shaft-deflection", example)
    expect(page.locator(".drawing .deflected")).to_have_count(2)
    for plane, name in enumerate("xy"):
        for at in "BC":
            arrow = page.locator(f'.drawing [data-reaction="{at}{name}"]')
            length = abs(answer[f"reaction_{at}_N"][plane]) * scale(page, "px-per-n")
            assert arrow.evaluate(SHAFT) == pytest.approx(length if length > 0.5 else 0, abs=0.02)
    # Each shape starts, at C, as far from the axis as the deflection there, the other way than C.
    factor = scale(page, "px-per-deflection")
    for shape, name in zip(page.locator(".drawing .deflected").all(), "yx", strict=True):
        path = (shape.get_attribute("d") or "")[1:].split("L")
        start, end = (float(point.split()[1]) for point in (path[0], path[-1]))
        assert end - start == pytest.approx(answer["deflection_C_mm"][name] * factor, abs=0.05)


@pytest.mark.parametrize("calculator", ["rollers", "precession"])
@pytest.mark.parametrize("width", [1440, 360])
def test_texts_stay_on_the_paper(page: Page, service: str, calculator: str, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    show(page, service, calculator)
    expect(page.locator(".drawing svg")).to_be_attached()
    assert page.evaluate(OUTSIDE) == []
    assert page.evaluate("() => watched.shift") < 0.02


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_drawing_is_saved_as_it_is_light_on_white(page: Page, service: str, theme: str) -> None:
    page.emulate_media(color_scheme=theme)  # type: ignore[arg-type]
    show(page, service, "crank-planetary", **FORCES)
    drawing = page.locator(".mechanism")
    with page.expect_download() as download:
        drawing.get_by_role("button", name="SVG").click()
    saved = ElementTree.parse(download.value.path()).getroot()
    paper, *parts = saved.iter()
    paper = saved[0]
    assert paper.get("fill") == "#ffffff"
    assert saved.get("width") == paper.get("width")
    for kind in ("circle", "text", "path"):
        count = page.locator(f".drawing svg {kind}").count()
        assert sum(part.tag.endswith(f"}}{kind}") for part in parts) == count > 0
    colours = {part.get("stroke") for part in parts} | {part.get("fill") for part in parts}
    assert "rgb(0, 114, 178)" in colours  # the first series on light paper
    assert not any(part.get("class") or part.get("style") for part in parts)
    with page.expect_download() as download:
        drawing.get_by_role("button", name="PNG").click()
    content = Path(download.value.path()).read_bytes()
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    width = int.from_bytes(content[16:20], "big")
    assert width == 2 * int(float(saved.get("width") or 0))


def test_nothing_of_older_inputs_is_drawn_beside_numbers(page: Page, service: str) -> None:
    open_mechanism(page, service)
    marks = page.locator(".mechanism .older, [data-figure=force] .older")
    expect(marks.filter(visible=True)).to_have_count(0)
    room = page.locator(".mechanism").bounding_box()
    held: list[Route] = []

    def hold(route: Route) -> None:
        of_forces = route.request.post_data_json["include"] == ["contact_force"]
        held.append(route) if of_forces else route.continue_()

    page.route("**/crank-planetary/chart*", hold)
    box(page, "load.output_torque_Nm").fill("60")
    settled(page)
    shaft = page.locator(".drawing svg > .force.arrow:not(.none)")
    expect(page.locator(".figure-message:visible")).to_have_text("Computing…")
    expect(shaft).to_have_count(0)
    expect(page.locator(".drawing .title")).to_have_text("")
    expect(marks.filter(visible=True)).to_have_count(0)
    page.evaluate("() => scrollTo(0, 0)")
    assert page.locator(".mechanism").bounding_box() == room
    for route in held:
        route.continue_()
    page.unroute("**/crank-planetary/chart*")
    expect(marks.filter(visible=True)).to_have_count(0)
    # A figure that is refused leaves the drawing without its forces.
    expect(shaft).not_to_have_count(0)
    refused = {"type": "/problems/impossible-mechanism", "status": 422, "detail": "No figure"}
    page.route(
        "**/crank-planetary/chart*",
        lambda route: route.fulfill(status=422, json=refused),
    )
    picked(page, "cycloid")
    settled(page)
    expect(page.locator("#panel-drawing .satellite .profile")).to_have_count(2)
    expect(marks.filter(visible=True)).to_have_count(0)
    expect(shaft).to_have_count(0)
    page.unroute("**/crank-planetary/chart*")
    box(page, "mechanism.satellites").fill("40")
    settled(page, "wrong")
    expect(page.locator("#panel-drawing .scale")).to_contain_text("Too many pairs")
    expect(page.locator("#panel-drawing .drawing svg")).to_have_count(0)


MIDDLE = """(drawing) => {
  const room = drawing.getBoundingClientRect();
  return [room.left + room.width / 2, room.top + room.height / 2];
}"""
MIDDLES = """(pins) => pins.map((pin) => {
  const { left, top, width, height } = pin.getBoundingClientRect();
  return [left + width / 2, top + height / 2, width];
})"""


def test_the_mesh_is_magnified_at_the_pin_that_bears_most(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    expect(page.locator('[data-view="mesh"]')).to_be_hidden()  # there are no teeth
    picked(page, "cycloid")
    settled(page)
    drawing = page.locator('[data-drawing="crank-planetary"] .drawing')
    pins = drawing.locator(".ring-pins .ring-pin")
    expect(pins).to_have_count(21)
    small = pins.evaluate_all(MIDDLES)[0][2]
    page.locator('[data-view="mesh"]').click()
    title = drawing.locator(".title")
    expect(title).to_contain_text("carries")
    said = []
    for angle in ("39", "120"):
        page.locator(".motion input").evaluate(MOVE, angle)
        said.append(int((title.text_content() or "").split("pin ")[1].split(" ")[0]))
        x, y, width = pins.evaluate_all(MIDDLES)[said[-1] - 1]
        assert [x, y] == pytest.approx(drawing.evaluate(MIDDLE), abs=2)
        assert width > 2 * small
        expect(drawing.locator(".ring-marks .arrow:not(.none)").first).to_be_attached()
    assert said[0] != said[1]
    page.locator("#pair").select_option("2/5")
    expect(title).to_contain_text("ring pin 5")
