"""Sections that are off until wanted: clearance and errors, tolerances, strength and life."""

import json
import zipfile
from contextlib import suppress

import pytest
from playwright.sync_api import Error, Locator, Page, Route, expect

from tests.browser.calculator_page import (
    address,
    ask,
    box,
    foreign,
    number,
    open_rows,
    reopen,
    settled,
    show,
    tab,
    words_at,
)
from tests.browser.conftest import Watch

DESIGN = {
    "mechanism.pins": "3",
    "mechanism.ratio": "20",
    "load.output_torque_Nm": "200",
    "load.pin_circle_radius_mm": "40",
    "contact.contact_length_mm": "12",
    "contact.pin_radius_mm": "5",
    "contact.eccentricity_mm": "2",
}
STUDY = {
    "real.on": "on",
    "study.on": "on",
    "contact.hole_clearance_mm": "0.1",
    "tolerances.hole_position_mm": "0.02",
    "tolerances.pin_diameter.class": "h6",
    "quantities": "peak_force_N",
    "samples": "40",
    "percentiles": "50;90",
    "crank_angles": "12",
}
BODY = {
    "mechanism": {"pins": 3, "ratio": 20},
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.03,
    },
    "include": ["over_turn", "ideal"],
}


def switch(page: Page, group: str) -> Locator:
    return page.locator(f'[data-path="{group}.on"] input')


def real(page: Page) -> Locator:
    return page.locator(".real")


def fresh(page: Page) -> None:
    """Wait until the real forces are those of the inputs; uncompiled they take seconds."""
    expect(real(page)).to_have_attribute("data-stale", "false")


def of_wanted(watch: Watch) -> list[str]:
    """Requests for the sections that are off until wanted."""
    modules = ("real", "study", "part", "strength", "losses", "bearings", "crank", "along", "turn")
    names = ("load-sharing", "tolerance", "besides", *(f"/{name}.js" for name in modules))
    return [path for path in watch.paths() if any(name in path for name in names)]


def test_clearance_and_errors(page: Page, service: str, watch: Watch) -> None:
    show(page, service, "crank-planetary", **DESIGN)
    expect(page.locator(".js-plotly-plot").first).to_be_attached()
    assert of_wanted(watch) == []
    expect(page.locator('[data-wanted="real"]')).to_be_hidden()
    # On: numbers, those of the service.
    switch(page, "real").check()
    box(page, "contact.hole_clearance_mm").fill("0.03")
    expect(real(page).locator(".quantities")).to_contain_text("0.03 mm")
    fresh(page)
    answer = ask(service, "/load-sharing", BODY)
    peak = real(page).locator(".numbers .figures").first.text_content() or ""
    assert number(peak.removesuffix("N")) == pytest.approx(
        answer["over_turn"]["peak_force_N"], 1e-4
    )
    expect(real(page).locator(".numbers")).to_contain_text(f"{answer['ideal']['ratio']:.3f}")
    expect(real(page).locator(".js-plotly-plot")).to_be_visible()
    # A part's measures, pasted; what is no number names its place, and all else stays.
    open_rows(page, "deviations.pins")
    first = page.get_by_label("P1, Pins outward", exact=True)
    first.evaluate(
        "(box, text) => { const data = new DataTransfer(); data.setData('text', text);"
        " box.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true })) }",
        "0,01\t0\n-0.02\t0\n",
    )
    expect(page.get_by_label("P2, Pins outward", exact=True)).to_have_value("-0.02")
    fresh(page)
    page.get_by_label("P3, Pins outward", exact=True).fill("0.0l")
    expect(words_at(page, "deviations.pins")).to_contain_text("Pins outward: Not a number")
    settled(page, "wrong")
    expect(real(page).locator(".state")).to_have_text("Numbers of earlier inputs")
    expect(page.get_by_label("P2, Pins outward", exact=True)).to_have_value("-0.02")
    page.get_by_label("P3, Pins outward", exact=True).fill("0.01")
    fresh(page)
    # More pins than were measured: the service says so, at the table.
    box(page, "mechanism.pins").fill("4")
    expect(words_at(page, "deviations.pins")).to_contain_text("must have 4 entries")
    expect(page.get_by_label("P2, Pins outward", exact=True)).to_have_value("-0.02")
    page.get_by_role("button", name="Undo").click()
    fresh(page)
    settled(page)
    reopen(page)
    fresh(page)
    open_rows(page, "deviations.pins")
    expect(page.get_by_label("P2, Pins outward", exact=True)).to_have_value("-0.02")
    assert page.evaluate("() => watched.shift") < 0.02
    switch(page, "real").uncheck()
    expect(page.locator('[data-wanted="real"]')).to_be_hidden()


def test_tolerances_may_be_those_of_how_the_parts_are_made(page: Page, service: str) -> None:
    made = {"study.sizes": "process", "tolerances.process": "sla", "quantities": "peak_force_N"}
    few = {
        "samples": "40",
        "percentiles": "50",
        "crank_angles": "12",
        "contact.hole_clearance_mm": "0.6",
    }
    on = {"study.on": "on", "study.ranked": "plain"}
    show(page, service, "crank-planetary", **DESIGN, **on, **made, **few)
    expect(box(page, "tolerances.process")).to_have_value("sla")
    for name in ("pin_position_mm", "hole_position_mm", "pin_diameter.class"):
        expect(box(page, f"tolerances.{name}")).to_be_hidden()
    page.locator('[data-group="study"] .running').get_by_role("button", name="Run").click()
    words = page.locator(".study .sentences")
    expect(words).to_contain_text("Made as “Printed from resin”")
    expect(words).to_contain_text("the mean clearance is 0.6\u00a0mm")
    expect(words).to_contain_text("Makelab")
    box(page, "study.sizes").select_option("class")
    expect(box(page, "tolerances.pin_position_mm")).to_be_visible()
    expect(box(page, "tolerances.process")).to_be_hidden()


def test_what_a_study_warns_of_is_said(page: Page, service: str) -> None:
    def lost(route: Route) -> None:
        *progress, last = route.fetch().text().splitlines()
        answer = json.loads(last)
        answer["result"]["warnings"] = [{"code": "cluster_lost", "params": {}, "detail": ""}]
        route.fulfill(
            body="\n".join([*progress, json.dumps(answer)]), content_type="application/x-ndjson"
        )

    page.route("**/tolerance-study", lost)
    show(page, service, "crank-planetary", **DESIGN, **STUDY)
    page.locator('[data-group="study"] .running').get_by_role("button", name="Run").click()
    expect(page.locator(".study .sentences")).to_contain_text("cluster was lost")


def test_a_study_is_run_by_its_button_and_stopped(page: Page, service: str, watch: Watch) -> None:
    show(page, service, "crank-planetary", **DESIGN, **STUDY)
    study, controls = page.locator(".study"), page.locator('[data-group="study"] .running')
    run = controls.get_by_role("button", name="Run the study")
    expect(run).to_be_enabled()
    box(page, "samples").fill("45")
    settled(page)
    assert not any("tolerance-study" in path for path in watch.paths())
    run.click()
    expect(study.locator(".ranked tbody tr")).to_have_count(2)
    expect(study.locator(".sentences")).to_contain_text("with 45 pieces")
    expect(study.locator(".histogram")).to_have_count(1)
    expect(
        controls.locator('[data-do="run"]')
    ).to_be_focused()  # though it could not be pressed while the study ran
    box(page, "tolerances.hole_position_mm").fill("0.03")
    expect(study.locator(".state")).to_have_text("Numbers of earlier inputs")
    expect(study.locator(".outcome")).to_have_attribute("data-stale", "true")
    asked: list[Route] = []
    page.route("**/tolerance-study", lambda route: asked.append(route))  # never answered
    run.click()
    expect(controls.locator("progress")).to_be_visible()
    controls.get_by_role("button", name="Stop").click()
    expect(controls.locator(".state")).to_contain_text("Stopped.")
    expect(study.locator(".histogram")).to_have_count(1)
    assert len(asked) == 1
    page.unroute("**/tolerance-study")
    with suppress(Error):  # the page has given it up
        asked[0].abort()
    # Too many samples: said at their box.
    box(page, "samples").fill("1000000")
    run.click()
    expect(words_at(page, "samples")).to_contain_text("ust be at most")


def test_parts_that_cannot_be_put_together_are_judged(page: Page, service: str) -> None:
    """Not possible, by how much, and the hole that would do: the input itself is right."""
    pressed = {"real.on": "on", "contact.hole_clearance_mm": "-0.3"}
    show(page, service, "crank-planetary", **DESIGN, **pressed)
    verdict = page.locator(".outputs .verdict").first
    expect(verdict).to_contain_text("Impossible")
    expect(verdict).to_contain_text("Room of the pins in their holes")
    expect(page.locator(".checks")).to_contain_text("6.7 mm → 7.015 mm")


ONE_WRONG_HOLE = {
    "mechanism.pins": "6",
    "mechanism.satellites": "1",
    "mechanism.ratio": "20",
    "load.output_torque_Nm": "20",
    "load.pin_circle_radius_mm": "30",
    "contact.contact_length_mm": "10",
    "contact.pin_radius_mm": "2",
    "contact.eccentricity_mm": "1.5",
    "contact.hole_clearance_mm": "0.1",
    "real.on": "on",
    "deviations.holes": "0;2;0" + 5 * "|0;0;0",
}


def test_one_wrong_hole_reads_as_what_it_is(page: Page, service: str, watch: Watch) -> None:
    """The parts go together and jam, and the page says between which pins; without a misfit nothing
    is requested.
    """
    show(page, service, "crank-planetary", **DESIGN)
    expect(page.locator(".js-plotly-plot").first).to_be_attached()
    card = page.locator('[data-wanted="fit"]')
    expect(card).to_be_hidden()
    assert not any(path.endswith(("/fit", "/fit/chart", "/fit.js")) for path in watch.paths())
    show(page, service, "crank-planetary", **ONE_WRONG_HOLE)
    expect(card.locator(".fit")).to_have_attribute("data-stale", "false")
    expect(card).to_contain_text("go together, but jam")
    expect(card).to_contain_text(
        "between pin 1 of satellite 1 (driving side) and pin 4 of satellite 1 (reverse side)"
    )
    expect(card.locator(".js-plotly-plot")).to_be_visible()
    assert watch.paths().count("/api/v1/fit") == watch.paths().count("/api/v1/fit/chart") == 1
    # Without the group that says so the check still finds fault, on a phone and in the dark too.
    page.set_viewport_size({"width": 390, "height": 844})
    page.emulate_media(color_scheme="dark")
    small = {**ONE_WRONG_HOLE, "real.on": "", "contact.hole_clearance_mm": "-0.3"}
    show(page, service, "crank-planetary", **small, lang="uk")
    expect(card).to_contain_text("не складаються")
    expect(card.locator(".js-plotly-plot")).to_be_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth") == 390
    page.locator('.places [data-place="inputs"]').click()
    box(page, "contact.hole_clearance_mm").fill("0.05")
    expect(card).to_be_hidden()


@pytest.mark.parametrize("clearance", ["", "0.02"])
def test_of_thousands_of_pins_nothing_is_asked_that_is_refused(
    page: Page, service: str, clearance: str
) -> None:
    made = {"real.on": "on", "contact.hole_clearance_mm": clearance} if clearance else {}
    show(page, service, "crank-planetary", **DESIGN, **made)
    expect(page.locator(".js-plotly-plot").first).to_be_attached()
    refused: list[str] = []
    page.on("response", lambda response: refused.append(response.url) if not response.ok else None)
    box(page, "mechanism.pins").fill("5000")
    many = page.locator('[data-figure="force"] .figure-message')
    expect(many).to_contain_text("must be at most 120, with 2 satellites")
    if clearance:
        expect(words_at(page, "mechanism.pins")).to_contain_text("ust be at most 500")
    assert refused == []


STEEL = {
    "youngs_modulus_GPa": "210",
    "poissons_ratio": "0.3",
    "yield_strength_MPa": "800",
    "tensile_strength_MPa": "1000",
}


HARD = {"load.output_torque_Nm": "40", "contact.hole_material": "steel_bearing"}


def part(page: Page, group: str) -> Locator:
    return page.locator(f'[data-wanted="{group}"]')


def in_full(cell: Locator) -> float:
    """A number with all the digits that it has for who points at it."""
    return number((cell.get_attribute("title") or "").partition("\u00a0")[0])


def value(page: Page, group: str, name: str) -> float:
    return in_full(part(page, group).locator(f'[data-name="{name}"] .value'))


def test_strength_and_life_from_the_switch_to_the_cure(page: Page, service: str) -> None:
    soft = {"contact.pin_material": "steel_case_hardened"}
    show(page, service, "crank-planetary", **DESIGN | HARD | soft)
    # Pins: they start from places of the satellites; what is not known is asked for.
    switch(page, "strength").check()
    expect(box(page, "pin.satellite_positions_mm")).to_have_attribute("placeholder", "8; 22")
    expect(page.locator(".word")).to_contain_text("Incomplete")
    # The pin has one material, above; its strengths, which the table does not know, are asked for.
    expect(page.locator('[data-choice="pin.material"]')).to_be_hidden()
    page.locator(".checks").get_by_role("button", name="Tensile strength").first.click()
    expect(box(page, "pin.material.tensile_strength_MPa")).to_be_focused()
    for name, text in STEEL.items():
        box(page, f"pin.material.{name}").fill(text)
    box(page, "fatigue.fatigue_notch_factor").fill("1.5")
    settled(page)
    pin = {"satellite_positions_mm": [8, 22], "material": {k: float(v) for k, v in STEEL.items()}}
    body = {
        "mechanism": BODY["mechanism"],
        "load": {"output_torque_Nm": 40, "pin_circle_radius_mm": 40},
        "contact": {
            "contact_length_mm": 12,
            "pin_radius_mm": 5,
            "eccentricity_mm": 2,
            "pin_material": "steel_case_hardened",
            "hole_material": "steel_bearing",
        },
        "pin": pin,
        "fatigue": {
            "surface": "machined",
            "fatigue_notch_factor": 1.5,
            "reliability_percent": 99,
        },
    }
    found = ask(service, "/crank-planetary", body)["pin_strength"]
    assert value(page, "strength", "peak_bending_stress_MPa") == pytest.approx(
        found["peak_bending_stress_MPa"], 1e-5
    )
    assert value(page, "strength", "fatigue_safety_factor") == pytest.approx(
        found["fatigue"]["safety_factor"], 1e-5
    )
    # The pin is drawn to scale, each satellite where it is.
    drawing = part(page, "strength").locator("svg[data-px-per-mm]")
    scale = float(drawing.get_attribute("data-px-per-mm") or "")
    z = [
        float(drawing.locator(f".series-{i} .force .shaft").get_attribute("x1") or "")
        for i in (1, 2)
    ]
    assert z[1] - z[0] == pytest.approx(14 * scale, abs=0.02)
    assert page.evaluate("() => watched.shift") < 0.02
    # The shaft needs the ring: it is switched on with it, and off by it.
    switch(page, "losses").check()
    switch(page, "crank").check()
    expect(switch(page, "bearings")).to_be_checked()
    expect(box(page, "load.input_speed_rpm")).to_have_value("1500")
    along = box(page, "crankshaft.satellite_positions_mm")
    expect(along).to_have_attribute("placeholder", "12; 26")  # as along the pins
    expect(part(page, "crank").locator(".figures").first).to_contain_text("N")
    drawn(page)
    tab(page, "bearings").click()
    part(page, "bearings").locator(".show-table").click()
    expect(part(page, "bearings").locator(".figure-table td").first).to_be_visible()
    part(page, "bearings").locator(".show-table").click()
    switch(page, "bearings").uncheck()
    expect(switch(page, "crank")).not_to_be_checked()
    expect(part(page, "crank")).to_be_hidden()
    settled(page)
    switch(page, "bearings").check()
    expect(switch(page, "crank")).to_be_checked()
    page.get_by_role("button", name="Undo").click()
    expect(switch(page, "crank")).not_to_be_checked()
    page.get_by_role("button", name="Undo").click()
    expect(switch(page, "crank")).to_be_checked()
    # Held at both ends, it lies between two supports.
    tab(page, "strength").click()
    bounds = part(page, "strength").locator(".bounds")
    expect(bounds).to_be_hidden()
    box(page, "pin.support").select_option("fixed")
    box(page, "pin.span_mm").fill("30")
    settled(page)
    bounds.locator("summary").click()
    stress = bounds.locator("tr", has_text="Largest bending stress").locator("td")
    expect(stress).to_have_count(2)
    free, fixed = (in_full(each) for each in stress.all())
    shown = value(page, "strength", "peak_bending_stress_MPa")
    assert fixed == pytest.approx(shown, rel=1e-4) and free > 1.2 * fixed
    safety = bounds.locator("tr", has_text="Safety factor of fatigue").locator("td").nth(1)
    assert in_full(safety) == pytest.approx(
        value(page, "strength", "fatigue_safety_factor"), rel=1e-4
    )
    box(page, "pin.support").select_option("cantilever")
    settled(page)
    expect(bounds).to_be_hidden()
    # Less than either way of sharing asks for: the clearance is not known.
    box(page, "bearing.dynamic_rating_N").fill("1.5 kN")
    box(page, "bearing.static_rating_N").fill("3 kN")
    box(page, "crankshaft.bearings.0.dynamic_rating_N").fill("20000")
    life = part(page, "crank").locator("tr", has_text="Life at 90")
    expect(life.locator("td").nth(1)).to_have_text("–")  # of the bearing whose rating is not known
    box(page, "crankshaft.bearings.1.dynamic_rating_N").fill("20000")
    # What fails first, and a cure of it.
    expect(page.locator(".word")).to_contain_text("Fails")
    page.locator(".fixes button", has_text="Output torque").click()
    expect(page.locator(".word")).not_to_contain_text("Fails")
    settled(page)
    # Worked, in a link, in another language.
    steps = page.locator('.worked [data-section="crankshaft"]')
    steps.locator("summary").click()
    expect(steps.locator("math").first).to_be_visible()
    page.set_viewport_size({"width": 320, "height": 800})
    page.goto(f"{address(page)}&lang=uk")
    settled(page)
    expect(box(page, "bearing.dynamic_rating_N")).to_have_value("1500")
    titles = page.locator(".part .js-plotly-plot .xtitle, .part .js-plotly-plot .x2title")
    drawn(page)
    expect(page.locator(".part .js-plotly-plot .xtitle")).to_have_count(4)
    beyond = titles.evaluate_all(
        """(all) => all.filter((one) => one.getBoundingClientRect().right
             > one.closest(".plot").getBoundingClientRect().right).map((one) => one.textContent)"""
    )
    assert beyond == []
    page.evaluate("() => document.querySelectorAll('details').forEach((d) => d.open = true)")
    assert foreign(page) == set()


REAL_DESIGN = {
    "load.input_speed_rpm": "1500",
    "load.application_factor": "1.25",
    "real.on": "on",
    "contact.hole_clearance_mm": "0.02",
    "deviations.pins": "; -0.02|;0|;0.01",
    "strength.on": "on",
    "pin.satellite_positions_mm": "8;22",
    "losses.on": "on",
    "friction.coefficient": "0.08",
    "friction.wear_rate_mm3_per_Nm": "1e-8",
    "bearings.on": "on",
    "gear.kind": "cycloid",
    "gear.ring_pin_circle_radius_mm": "80",
    "crank.on": "on",
}
FIGURES = {
    "strength": ("pin-strength", "peak_bending_stress_MPa"),
    "losses": ("output-efficiency", "min_efficiency"),
    "bearings": ("satellite-bearing", "Largest load"),
    "crank": ("crankshaft", "Largest reaction"),
}
EXTREMES = """(plot, below) => {
  const traces = plot.data.filter(({ y, yaxis }) => y.length > 2 && yaxis === "y2");
  return traces.map(({ y }) => (below ? Math.min(...y) : Math.max(...y.map(Math.abs))));
}"""


def drawn(page: Page) -> None:
    """Open the figures of the parts until each is of the results on the page."""
    for group in FIGURES:
        tab(page, group).click()
        figure = part(page, group).locator(".figure")
        expect(figure.locator(".plot.js-plotly-plot")).to_be_visible()
        expect(figure).to_have_attribute("data-stale", "false")


def numbers_of(page: Page, group: str) -> list[float]:
    """The numbers that the figure of a group has as extremes."""
    name = FIGURES[group][1]
    if "_" in name:
        return [value(page, group, name)]
    cells = part(page, group).locator("tr", has_text=name).locator("td")
    return [number(text) for text in cells.all_text_contents()]


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"load.torque_direction": "alternating"},
        {"real.on": "", "contact.hole_clearance_mm": "", "deviations.pins": ""},
    ],
)
def test_figures_are_of_the_forces_of_their_numbers(
    page: Page, service: str, watch: Watch, changes: dict[str, str]
) -> None:
    show(page, service, "crank-planetary", **DESIGN | REAL_DESIGN | changes)
    drawn(page)
    for group in FIGURES:
        plot = part(page, group).locator(".js-plotly-plot")
        extremes = plot.evaluate(EXTREMES, group == "losses")
        assert extremes == pytest.approx(numbers_of(page, group), rel=0.01), group
    asked = watch.paths()
    for path, _ in FIGURES.values():
        assert asked.count(f"/api/v1/{path}/chart") == 1, path


def test_a_figure_is_grey_until_it_is_of_the_numbers(
    page: Page, service: str, watch: Watch
) -> None:
    """Kept figures are not requested again."""
    show(page, service, "crank-planetary", **DESIGN | REAL_DESIGN)
    drawn(page)
    figure = part(page, "bearings").locator(".figure")
    path = "/api/v1/satellite-bearing/chart"
    page.get_by_role("button", name="Compare").click()
    expect(page.locator(".compare thead input")).to_have_count(1)
    tab(page, "bearings").click()
    page.wait_for_timeout(300)
    assert watch.paths().count(path) == 1
    held: list[Route] = []
    page.route(f"**{path}*", lambda route: held.append(route))
    box(page, "load.output_torque_Nm").fill("150")
    settled(page)
    expect(figure).to_have_attribute("data-stale", "true")
    expect(figure.locator(".plot")).to_have_css("opacity", "0.5")
    held[0].continue_()
    expect(figure).to_have_attribute("data-stale", "false")
    expect(figure.locator(".plot")).to_have_css("opacity", "1")
    assert watch.paths().count(path) == 2


def test_fatigue_of_rollers_and_of_the_shaft_with_its_contact_lines(
    page: Page, service: str
) -> None:
    def row(name: str) -> Locator:
        return page.locator(".checks").get_by_text(name)

    show(page, service, "rollers")
    switch(page, "endurance").check()
    expect(row("Fatigue of the rollers")).to_be_visible()
    expect(page.locator(".checks")).to_contain_text("Enter: Tensile strength")
    box(page, "tensile_strength_MPa").fill("900")
    # 254.2/246.6 + 254.2/900: the concentration of the stress counts once
    expect(page.locator(".checks")).to_contain_text("0.7614")
    box(page, "fatigue.fatigue_notch_factor").fill("1.6")
    expect(words_at(page, "fatigue.fatigue_notch_factor")).to_contain_text("Stress concentration")
    box(page, "fatigue.fatigue_notch_factor").fill("")
    settled(page)
    show(page, service, "precession")
    switch(page, "endurance").check()
    size = page.locator('[data-path="tensile_strength_MPa"] .size')
    expect(size).to_be_disabled()  # until a check tells how much of it is used
    box(page, "tensile_strength_MPa").fill("900")
    box(page, "fatigue.fatigue_notch_factor").fill("1.6")
    switch(page, "lines").check()
    box(page, "line_contact.mating_radius_mm").fill("-30")
    expect(row("Pressure along the contact lines")).to_be_attached()
    expect(row("Fatigue of the shaft in bending")).to_be_attached()
    settled(page)
    expect(size).to_be_enabled()
    assert "line_contact.mating_radius_mm=-30" in address(page)
    reopen(page)
    expect(row("Pressure along the contact lines")).to_be_attached()


def test_discs_are_taken_along_as_drawings_once_their_modification_is_known(
    page: Page, service: str
) -> None:
    ring = {
        "mechanism.satellite_teeth": "19",
        "mechanism.ring_teeth": "20",
        "contact.hole_clearance_mm": "0.03",
        "load.input_speed_rpm": "1500",
        "bearings.on": "on",
        "gear.kind": "cycloid",
        "gear.ring_pin_circle_radius_mm": "70",
        "gear.ring_pin_radius_mm": "5",
    }
    design = {name: text for name, text in DESIGN.items() if name != "mechanism.ratio"}
    show(page, service, "crank-planetary", **design | ring)
    names = ("Export", "Drawings of all parts, DXF")
    take, drawings = (page.get_by_role("button", name=name) for name in names)
    take.click()
    expect(page.get_by_role("button", name="All results, CSV")).to_be_visible()
    expect(drawings).to_have_count(0)
    page.keyboard.press("Escape")
    box(page, "gear.modification.equidistant_mm").fill("0.02")
    settled(page)
    reopen(page)
    take.press("Enter")
    with page.expect_download() as download:
        drawings.press("Enter")
    with zipfile.ZipFile(download.value.path()) as bundle:
        drawn = ("satellite_1", "satellite_2", "ring_pins", "carrier", "housing", "assembly")
        assert bundle.namelist() == [*(f"{name}.dxf" for name in drawn), "left_out.txt"]
        assert b"Equidistant modification +0.02 mm" in bundle.read("satellite_2.dxf")
    page.keyboard.press("Escape")
    box(page, "gear.ring_pin_radius_mm").fill("40")
    settled(page)
    take.click()
    drawings.click()
    expect(page.get_by_role("alert")).to_contain_text("the tool would cut off a part")


def test_mass_is_shown_where_it_is_wanted(page: Page, service: str) -> None:
    """A group without fields of its own: each part says its mass, or what it lacks."""
    show(page, service, "crank-planetary", **DESIGN)
    switch(page, "mass").check()
    settled(page)
    expect(part(page, "mass").locator(".numbers")).to_contain_text("pieces: 3; estimate")
    reopen(page)
    lacks = "A part of the design that it needs is not given"
    expect(part(page, "mass").locator(".numbers")).to_contain_text(lacks)
