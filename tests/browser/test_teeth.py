"""Teeth of cycloid discs on the page: typed by keyboard up to a verdict, drawn as the service has
them.
"""

import cmath
import math
from typing import Any
from urllib.parse import parse_qsl, urlencode, urlsplit

import httpx
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.calculator_page import address, ask, box, picked, settled

MOVE = """(slider, angle) => {
  slider.value = angle;
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}"""

AT = "() => document.activeElement.closest('[data-path]')?.dataset.path"

ON_PAGE = """() => {
  const of = (part, name) => Number(part.getAttribute(name));
  const centre = document.querySelector(".drawing .pin-circle");
  const middle = [of(centre, "cx"), of(centre, "cy")];
  const ends = (line) => [["x1", "y1"], ["x2", "y2"]].map(([x, y]) =>
    [of(line, x) - middle[0], middle[1] - of(line, y)]);
  const shown = (part, line) => part.classList.contains("none") ? null : ends(line);
  return {
    arrows: [...document.querySelectorAll(".ring-marks .arrow")]
      .map((arrow) => shown(arrow, arrow.querySelector(".shaft"))),
    gaps: [...document.querySelectorAll(".ring-gap")].map((gap) => shown(gap, gap)),
  };
}"""


def cycloid(service: str) -> dict[str, Any]:
    examples = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"]
    found: dict[str, Any] = next(one["input"] for one in examples if one["id"] == "cycloid")
    return found


def opened(page: Page, service: str) -> None:
    page.goto(f"{service}/?calculator=crank-planetary")
    settled(page)
    picked(page, "cycloid")
    expect(box(page, "gear.modification.equidistant_mm")).to_have_value("0.015")
    settled(page)


def word(page: Page) -> Locator:
    return page.locator(".verdict .word")


def to(page: Page, path: str) -> None:
    """Go on by the keyboard to a box."""
    for _ in range(40):
        page.keyboard.press("Tab")
        if page.evaluate(AT) == path and page.locator(":focus").get_attribute("class") == "box":
            return
    pytest.fail(f"no way to {path}")


def test_teeth_are_typed_by_keyboard_to_a_verdict(page: Page, service: str) -> None:
    opened(page, service)
    teeth = ("gear.", "teeth.", "requirements.max_ring", "verdict")
    query = parse_qsl(urlsplit(address(page)).query)
    kept = [(name, value) for name, value in query if not name.startswith(teeth)]
    page.goto(f"{service}/?{urlencode(kept)}")
    settled(page, "incomplete")  # the ring is asked for
    box(page, "gear.kind").focus()
    page.keyboard.type("Pins")
    for name, value in (("circle_radius", "66"), ("radius", "4")):
        to(page, f"gear.ring_pin_{name}_mm")
        page.keyboard.type(value)
    settled(page)
    open_part = page.locator('[data-part="teeth"]')
    expect(open_part).to_contain_text("Modification not known")
    expect(word(page)).to_contain_text("Incomplete")
    for name, value in (("equidistant", "0,015"), ("pin_circle", "-0.005")):
        to(page, f"gear.modification.{name}_mm")
        page.keyboard.type(value)
    page.locator('[data-path="teeth.on"] input').focus()
    page.keyboard.press("Space")
    to(page, "gear.friction_coefficient")
    page.keyboard.type("0.06")
    expect(word(page)).to_contain_text("Just works")
    settled(page)
    figure = page.locator('[data-figure="teeth"]')
    expect(figure.locator(".plot .main-svg").first).to_be_attached()

    # Measured pins: what cannot be is said at its place and stays, and then it counts.
    grid = page.locator('[data-path="deviations.ring_pins"]')
    expect(grid).to_have_count(1)
    grid.locator(".open-records").focus()
    page.keyboard.press("Enter")
    first = grid.get_by_label("P1, Ring pins outward", exact=True)
    first.focus()
    page.keyboard.type("0,5")
    expect(grid.locator(".field-message")).to_contain_text("Row 1, Ring pins outward")
    expect(first).to_have_attribute("aria-invalid", "true")
    expect(first).to_have_value("0,5")
    first.press("ControlOrMeta+a")
    page.keyboard.type("-0,02")  # it presses
    expect(word(page)).to_contain_text("Fails")
    page.reload()
    settled(page)
    grid.locator(".open-records").click()
    expect(first).to_have_value("-0.02")


def matches(page: Page, angle: float, force: list[float]) -> None:
    """Arrows as long as the forces, on the line from the pin to the pitch point; else a gap."""
    expect(page.locator(".ring-marks .arrow")).to_have_count(len(force))
    page.get_by_role("slider", name="Crank angle").evaluate(MOVE, angle)
    svg = page.locator('[data-drawing="crank-planetary"] .drawing svg')
    px = float(svg.get_attribute("data-px-per-mm") or "nan")
    newton = px * float(svg.get_attribute("data-mm-per-n") or "nan")
    drawn = page.evaluate(ON_PAGE)
    for i, (value, arrow, gap) in enumerate(
        zip(force, drawn["arrows"], drawn["gaps"], strict=True)
    ):
        length = math.dist(*arrow) if arrow else 0.0
        assert length == pytest.approx(value * newton, abs=0.01 * max(force) * newton), i
        assert bool(gap) == (not arrow), i
        if not arrow:
            continue
        tail, tip = (complex(*end) for end in arrow)
        j, k = divmod(i, 21)
        pin = 66j * px * cmath.exp(2j * math.pi * k / 21)
        pitch = 42j * px * cmath.exp(-1j * math.radians(angle + 180 * j))
        assert abs(pin - tip) == pytest.approx(4 * px, abs=0.05)
        assert abs(pitch - tip) < abs(pitch - tail)
        for other in (tail, pitch):
            assert abs(cmath.phase((other - tip) ** 2 / (pin - tip) ** 2)) < 0.04


def test_forces_and_gaps_of_the_ring_are_drawn_as_they_are(page: Page, service: str) -> None:
    opened(page, service)
    design = cycloid(service)
    angles = [0, 137.5, 350]
    gear = {**design["gear"], "contact_length_mm": design["contact"]["contact_length_mm"]}
    named = ("output_torque_Nm", "pin_circle_radius_mm")
    body = {
        "mechanism": design["mechanism"],
        "load": {name: design["load"][name] for name in named},
        "contact": design["contact"],
        "gear": {**gear, "disc_material": design["contact"]["hole_material"]},
        "satellite_coupling": {"kind": "ring"},
        "crank_angle_deg": angles,
    }
    answer: Any = ask(service, "/load-sharing", body)
    force: list[float] = []
    for angle, position in zip(angles, answer["positions"], strict=True):
        force = [value for row in position["ring"]["force_N"] for value in row]
        matches(page, angle, force)
    most = force.index(max(force))
    name = f"{most // 21 + 1}/{most % 21 + 1}"
    page.locator(f'.ring-pins [data-pair="{name}"]').click()
    expect(page.locator("#pair")).to_have_value(name)
    title = page.locator(".drawing .title")
    expect(title).to_contain_text(f"ring pin {most % 21 + 1} carries")
    far = (most + 10) % 21 + 21 * (most // 21)
    page.locator("#pair").select_option(f"{far // 21 + 1}/{far % 21 + 1}")
    expect(title).to_contain_text("a gap of 0.0")
