"""The drawings: their arrows are the forces, they move without the service, and follow the user."""

from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.calculator_page import ask, box, first_example, settled, show

LENGTHS = (
    "() => Object.fromEntries([...document.querySelectorAll('.force[data-pair]')]"
    ".map(({ dataset }) => [dataset.pair, Number(dataset.length)]))"
)
HEADS = (
    "() => Math.max(...[...document.querySelectorAll('.force[data-pair]')].map((arrow) => {"
    " const drawn = arrow.getAttribute('d').match(/-?[\\d.]+(?:e-?\\d+)?/g);"
    " const [x, y, u, v] = (drawn ?? [0, 0, 0, 0]).map(Number);"
    " return Math.abs(Math.hypot(u - x, v - y) - arrow.dataset.length) }))"
)


def crank(page: Page, angle: int) -> None:
    page.get_by_role("slider", name="Crank angle").fill(str(angle))


def drawn(page: Page) -> None:
    """Wait until the drawing has its forces."""
    page.wait_for_function(
        "() => [...document.querySelectorAll('.force[data-pair]')]"
        ".some(({ dataset }) => dataset.length > 0)"
    )


def test_arrows_are_the_forces_at_the_sliders_angle(page: Page, service: str, watch: Any) -> None:
    show(page, service, "crank-planetary")
    drawn(page)
    example = first_example(service, "crank-planetary")
    body = {**example["mechanism"], **example["load"], "include": ["curves"]}
    answer = ask(service, "/contact-force", body)
    curves, peak = answer["curves"], answer["peak_force_N"]
    longest = 0.45 * example["load"]["pin_circle_radius_mm"]
    asked = len(watch.calculations())
    for angle in (0, 40, 123, 359):
        crank(page, angle)
        lengths = page.evaluate(LENGTHS)
        for pair, force in zip(curves["pairs"], curves["force_N"], strict=True):
            wanted = longest * force[angle] / peak
            name = f"{pair['satellite']}.{pair['pin']}"
            assert lengths[name] == pytest.approx(wanted, rel=1e-4, abs=1e-3 * longest)
        assert page.evaluate(HEADS) < 1e-3  # as long as it says
    assert len(watch.calculations()) == asked  # the service was not asked


def test_the_cursor_of_the_figures_follows_and_a_bar_selects_everywhere(
    page: Page, service: str
) -> None:
    show(page, service, "crank-planetary")
    drawn(page)
    crank(page, 90)
    for figure in ("cyclogram", "force"):
        off = page.evaluate(
            """(figure) => {
              const host = document.querySelector(`[data-figure=${figure}]`);
              const at = host.querySelector(".cursor").getBoundingClientRect().left;
              const ticks = [...host.querySelectorAll(".xtick text")];
              const tick = ticks.find(({ textContent }) => textContent === "90");
              const box = tick.getBoundingClientRect();
              return Math.abs(at + 1 - (box.left + box.width / 2));
            }""",
            figure,
        )
        assert off < 2, figure
    bars = page.locator('[data-figure="cyclogram"] .barlayer .point path')
    bars.first.scroll_into_view_if_needed()
    place = bars.first.bounding_box()
    assert place
    page.mouse.click(place["x"] + place["width"] / 3, place["y"] + place["height"] / 2)
    choice = page.get_by_label("Pair", exact=True)
    expect(choice).not_to_have_value("")
    pair = choice.input_value()
    expect(page.locator(f'.force.selected[data-pair="{pair}"]')).to_be_attached()
    expect(page.locator(".caption")).to_contain_text(f"S{pair[0]} P{pair[2]}")
    weights = page.evaluate(
        "() => document.querySelector('[data-figure=force] .plot').data"
        ".map(({ name, opacity }) => [name, opacity ?? 1])"
    )
    assert dict(weights)[pair] == 1
    assert all(weight < 1 for name, weight in weights if "." in name and name != pair)
    page.keyboard.press("Escape")
    expect(choice).to_have_value("")


def test_the_keyboard_turns_the_crank(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    drawn(page)
    slider = page.get_by_role("slider", name="Crank angle")
    slider.focus()
    before = page.locator("[data-turned]").get_attribute("data-turned")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".motion output")).to_have_text("1°")
    assert page.locator("[data-turned]").get_attribute("data-turned") != before


def test_a_frame_of_the_motion_leaves_time_for_sixty_a_second(page: Page, service: str) -> None:
    show(page, service, "crank-planetary")
    drawn(page)
    spent = page.evaluate(
        """() => {
          const slider = document.querySelector(".motion input");
          const start = performance.now();
          for (let angle = 0; angle < 240; angle += 1) {
            slider.value = angle;
            slider.dispatchEvent(new Event("input"));
          }
          return (performance.now() - start) / 240;
        }"""
    )
    assert spent < 1000 / 60


def test_play_moves_and_stands_still_where_motion_is_unwanted(
    page: Page, service: str, browser: Browser
) -> None:
    show(page, service, "crank-planetary")
    drawn(page)
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".motion output")).not_to_have_text("0°")
    page.get_by_role("button", name="Pause").click()
    here = page.locator(".motion output").inner_text()
    page.wait_for_timeout(200)
    assert page.locator(".motion output").inner_text() == here
    context = browser.new_context(reduced_motion="reduce")
    still = context.new_page()
    show(still, service, "crank-planetary")
    assert still.get_by_role("button", name="Play").count() == 0
    context.close()


@pytest.mark.parametrize(
    ("calculator", "path"),
    [
        ("crank-planetary", "contact.pin_radius_mm"),
        ("rollers", "sphere_width_mm"),
        ("precession", "overhang_mm"),
    ],
)
def test_a_field_lights_its_dimension_and_the_dimension_its_field(
    page: Page, service: str, calculator: str, path: str
) -> None:
    show(page, service, calculator)
    mark = page.locator(f'.drawing [data-dimension="{path}"]').first
    expect(mark).to_be_attached()
    box(page, path).focus()
    expect(page.locator(f'.dimension.lit[data-dimension="{path}"]').first).to_be_attached()
    page.locator("#tab-rollers").focus()
    mark.locator("text").dispatch_event("pointerover")
    expect(page.locator(f'.field.lit[data-path="{path}"]')).to_be_attached()


def test_the_rollers_arrows_are_their_forces(page: Page, service: str) -> None:
    show(page, service, "rollers")
    answer = ask(service, "/roller-strength", first_example(service, "roller-strength"))
    lengths = page.locator(".force[data-roller]")
    expect(lengths).to_have_count(len(answer["forces_N"]))
    drawn = [float(each.get_attribute("data-length") or 0) for each in lengths.all()]
    for length, force in zip(drawn, answer["forces_N"], strict=True):
        assert length / drawn[0] == pytest.approx(force / answer["forces_N"][0], rel=1e-6)
    box(page, "position_tolerance_mm").fill("0.1")
    box(page, "position_tolerance_mm").press("Enter")
    settled(page)
    expect(page.locator(".body.idle")).to_have_count(len(answer["forces_N"]) - 1)


def test_the_shaft_shows_reactions_and_deflection(page: Page, service: str) -> None:
    show(page, service, "precession")
    example = first_example(service, "precession/shaft-deflection")
    answer = ask(service, "/precession/shaft-deflection", example)
    expect(page.locator(".deflected")).to_have_count(2)
    arrows = page.locator(".force[data-reaction]").all()
    drawn = [float(each.get_attribute("data-length") or 0) for each in arrows]
    forces = [abs(answer[f"reaction_{at}_N"][plane]) for plane in (0, 1) for at in ("C", "B")]
    for length, force in zip(drawn, forces, strict=True):
        assert length / max(drawn) == pytest.approx(force / max(forces), rel=1e-5)
