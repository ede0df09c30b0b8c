"""The room of pins in their holes over REST.

Held numbers were found twice when this was specified: by arcs of each pair, and by plain distances
whose lag and crank angle were scanned.
"""

import cmath
import math
import random
from itertools import pairwise

import pytest

from core.precision import EXACT, SEARCHED
from tests.oracles.room import Sizes, room

pytestmark = pytest.mark.anyio

PATH = "fit"
MM, ARCMIN = 1e-3, math.pi / 10_800


def asked(pins, satellites, ratio, radius, pin, eccentricity, clearance, **more):
    """A request, lengths in mm."""
    contact = {
        "contact_length_mm": 10,
        "pin_radius_mm": pin,
        "eccentricity_mm": eccentricity,
        "hole_clearance_mm": clearance,
    }
    return {
        "mechanism": {"pins": pins, "satellites": satellites, "ratio": ratio},
        "load": {"pin_circle_radius_mm": radius},
        "contact": contact | more.pop("contact", {}),
        **more,
    }


def turned(degrees):
    """Two equal discs, the second turned."""
    return asked(4, 2, 20, 30, 2, 1.5, 0.5, deviations={"disc_phase_deg": [0, degrees]})


OFF = {
    "pin_radial_mm": [-0.0089, 0, 0.0024, -0.0113, -0.0084, 0.0103],
    "pin_tangential_mm": [-0.0103, -0.0089, 0.0108, 0.0029, -0.0031, 0.0003],
    "pin_radius_mm": [0.0013, -0.0018, -0.0029, 0.0023, 0.0014, 0.0001],
    "hole_radial_mm": [
        [0.0076, 0.0012, 0.0115, -0.0071, 0.0013, -0.0004],
        [-0.0035, 0.0022, -0.0064, 0.0073, 0.0088, -0.0089],
    ],
    "hole_tangential_mm": [
        [-0.0008, -0.0053, -0.01, 0.0095, -0.0017, -0.0085],
        [0.0042, -0.0071, 0.0096, -0.0068, -0.0112, -0.0072],
    ],
    "hole_radius_mm": [
        [-0.0012, -0.0002, 0.0032, 0.0016, -0.0013, -0.0039],
        [-0.0027, 0.004, -0.0003, 0.0015, -0.0036, -0.0037],
    ],
    "eccentricity_mm": [0.0042, 0.001],
    "crank_phase_deg": [-0.0046, -0.0044],
    "disc_phase_deg": [-0.00248, -0.00198],
}
DEVIATING = asked(6, 2, 20, 40, 5, 2, 0.03, deviations=OFF)
BEHIND = asked(3, 1, 10, 20, 3, 1.5, 0.05, deviations={"pin_tangential_mm": [-0.12, 0, 0]})
OUTWARD = asked(6, 1, 20, 30, 2, 1.5, 0.1, deviations={"hole_radial_mm": [[2, 0, 0, 0, 0, 0]]})
SPIKED = asked(
    7, 1, 18, 20, 3, 1.5, 0.02,
    deviations={"pin_radial_mm": [0, 0, 0, 0, -0.01997556539047208, 0, -0.01999650934149601]},
)  # fmt: skip
STEEL = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3, "yield_strength_MPa": 800.0}
PRESSED = asked(
    6, 2, 20, 50, 8, 2, -0.02,
    contact={"contact_length_mm": 20, "pin_material": STEEL, "hole_material": STEEL},
)  # fmt: skip

# State, least and greatest room in mm, least and greatest play in arcmin, crank angle of the least.
HELD = {
    "clearance of 5 e": (
        asked(4, 1, 20, 30, 2, 1.5, 7.5),
        ("fits", 7.5, 7.5, 1725.653806634, 1786.640609953, None),
    ),
    "a hole smaller than pin and eccentricity": (
        asked(4, 1, 30, 17, 3.5, 0.8, -0.35),
        ("does_not_fit", -0.35, -0.35, None, None, None),
    ),
    "holes farther out than any pin reaches": (
        asked(6, 1, 10, 30, 3, 1.5, 0.3, deviations={"hole_radial_mm": [[0.5] * 6]}),
        ("does_not_fit", -0.2, -0.149112133, None, None, ...),
    ),
    "clearance of 0.9 e": (
        asked(4, 1, 29, 33.875, 3, 1.25, 1.125),
        ("fits", 1.125, 1.125, 228.364493624, 266.020460992, None),
    ),
    "two discs 9 degrees out": (
        turned(9),
        ("does_not_fit", -1.854882345, -1.603144030, -425.195139277, -399.906893799, 81.428571404),
    ),
    "1.5 degrees out": (
        turned(1.5),
        ("fits", 0.107310388, 0.199267041, 24.593857593, 55.287568038, 85.000000142),
    ),
    "all deviations": (
        DEVIATING,
        ("fits", 0.004746079, 0.017542030, 1.437835798, 5.055890100, 313.963180596),
    ),
    "one pin": (
        asked(1, 1, 10, 20, 3, 1.5, 0.1),
        ("fits", 0.1, 1.6, 184.613537474, 550.627888294, 0.0),
    ),
    "two pins": (
        asked(2, 1, 10, 20, 3, 1.5, 0.05),
        ("fits", 0.05, 0.05, 17.188751326, 129.567340509, None),
    ),
    "one pin behind": (
        BEHIND,
        ("binds_in_turning", -0.002294954, 0.088873156, -0.902804926, 45.648799625, 218.056126150),
    ),
    "a clearance that is nearly eaten": (
        SPIKED,
        ("fits", 3.490658502e-6, 0.02, 1.080630181, 7.850022069, 48.721805270),
    ),
    "perfect parts": (asked(6, 2, 20, 50, 8, 2, 0), ("fits", 0, 0, 0, 0, None)),
    "one hole outward": (OUTWARD, ("binds_in_turning", -1.9, 0.1, None, None, 0.0)),
    "a hole smaller than its pin": (
        asked(4, 1, 10, 20, 3, 1.0, -1.1),
        ("does_not_fit", -1.1, -1.1, None, None, None),
    ),
    "one disc turned": (
        asked(4, 1, 20, 30, 2, 1.5, 0.5, deviations={"disc_phase_deg": [9]}),
        ("fits", 0.5, 0.5, 114.595869893, 144.579164911, None),
    ),
}


async def fit_of(api, body, *include):
    response = await api.post(PATH, json=body | {"include": [*include]})
    assert response.status_code == 200, response.json()
    return response.json()["fit"]


@pytest.mark.parametrize("name", HELD)
async def test_held_numbers(api, name):
    body, (state, least, greatest, shortest, longest, place) = HELD[name]
    found = await fit_of(api, body)
    assert found["state"] == state
    assert found["least_room_mm"] == pytest.approx(least, abs=1e-8)
    assert found["greatest_room_mm"] == pytest.approx(greatest, abs=1e-8)
    if place is None:
        assert "least_room_crank_angle_deg" not in found and "binding" not in found
    elif place is not ...:
        assert found["least_room_crank_angle_deg"] == pytest.approx(place, abs=1e-3)
    if shortest is None:
        assert "least_room_arcmin" not in found
    else:
        assert found["least_room_arcmin"] == pytest.approx(shortest, abs=1e-5)
        assert found["greatest_room_arcmin"] == pytest.approx(longest, abs=1e-5)


async def test_what_binds_and_what_is_blocked(api):
    def pair(satellite, pin, side):
        return {"satellite": satellite, "pin": pin, "side": side}

    found = await fit_of(api, DEVIATING)
    assert found["binding"] == [pair(1, 1, "driving"), pair(2, 5, "reverse")]
    assert not {"misfit", "blocked_crank_deg", "needed_hole_radius_mm"} & set(found)
    found = await fit_of(api, OUTWARD)
    assert found["binding"] == [pair(1, 1, "radial")] and found["misfit"] == "jams"
    assert found["blocked_crank_deg"] == [pytest.approx([223.910024772, 461.804260942], abs=1e-6)]
    assert found["blocked_share"] == pytest.approx(0.6938581888, abs=1e-9)
    assert found["needed_hole_radius_mm"] == pytest.approx(5.5, abs=1e-9)
    found = await fit_of(api, BEHIND)
    assert [end for ends in found["blocked_crank_deg"] for end in ends] == pytest.approx(
        [205.717509001, 230.397320825, 260.468113318, 284.737915994], abs=1e-6
    )
    assert found["blocked_share"] == pytest.approx(0.1495682665, abs=1e-9)


async def test_the_hole_that_is_needed_just_fits(api):
    needed = (await fit_of(api, turned(9)))["needed_hole_radius_mm"]
    assert needed == pytest.approx(5.854882345, abs=1e-8)
    body = turned(9)
    del body["contact"]["hole_clearance_mm"]
    for hole, state in ((needed + 1e-6, "fits"), (needed - 1e-6, "binds_in_turning")):
        body["contact"]["hole_radius_mm"] = hole
        assert (await fit_of(api, body))["state"] == state


async def test_each_disc_by_itself_has_room(api):
    found = await fit_of(api, turned(9), "discs")
    assert found["misfit"] == "discs_out_of_phase"
    assert [each["satellite"] for each in found["discs"]] == [1, 2]
    assert [each["least_room_mm"] for each in found["discs"]] == pytest.approx([0.5, 0.5])
    assert [each["turned_deg"] for each in found["discs"]] == pytest.approx([0, 9], abs=1e-9)
    found = await fit_of(api, DEVIATING, "discs")
    rows = [(each["least_room_mm"], each["turned_deg"]) for each in found["discs"]]
    assert rows == [
        pytest.approx((0.006524218455, -0.004740482160), abs=1e-8),
        pytest.approx((0.006000647019, -0.004634378460), abs=1e-8),
    ]
    assert "discs" not in await fit_of(api, DEVIATING)


async def test_a_disc_that_is_turned_by_a_pitch_goes_onto_the_next_holes(api):
    answer = (await api.post(PATH, json=turned(90))).json()
    assert answer["fit"]["renumbered"] == [0, 1]
    assert answer["fit"]["least_room_mm"] == pytest.approx(0.5, abs=1e-9)
    assert [each["code"] for each in answer["warnings"]] == ["next_hole"]


async def test_what_elasticity_takes_up(api):
    found = await fit_of(api, PRESSED, "elastic")
    assert found["state"] == "does_not_fit" and found["misfit"] == "pressed_without_load"
    assert found["elastic"] == {
        "limit_mm": pytest.approx(0.035671122444567174, rel=EXACT),
        "limit_force_N": pytest.approx(45027.03351387924, rel=EXACT),
        "force_without_load_N": pytest.approx(22529.45260215064, rel=EXACT),
        "pressure_without_load_MPa": pytest.approx(1012.9352157308101, rel=EXACT),
    }
    beyond = asked(
        6, 2, 20, 50, 8, 2, -0.036, contact={key: PRESSED["contact"][key] for key in
        ("contact_length_mm", "pin_material", "hole_material")},
    )  # fmt: skip
    found = await fit_of(api, beyond, "elastic")
    assert found["misfit"] == "cannot_assemble"
    assert set(found["elastic"]) == {"limit_mm", "limit_force_N"}
    unknown = {key: STEEL[key] for key in ("youngs_modulus_GPa", "poissons_ratio")}
    beyond["contact"] |= {"pin_material": unknown, "hole_material": unknown}
    found = await fit_of(api, beyond, "elastic")
    assert found["misfit"] == "pressed_without_load"  # nothing is proven
    assert set(found["elastic"]) == {"force_without_load_N", "pressure_without_load_MPa"}
    closed = HELD["a hole smaller than its pin"][0]
    found = await fit_of(api, closed, "elastic")
    assert found["misfit"] == "cannot_assemble" and "elastic" not in found


async def test_bearings_give_way_by_half_their_clearance(api):
    body = asked(6, 2, 20, 50, 8, 2, -0.001, crank_support={"radial_clearance_mm": 0.003})
    assert (await fit_of(api, body))["misfit"] == "fits_by_bearing_clearance"
    body["crank_support"] = {"radial_clearance_mm": 0.001, "stiffness_N_per_mm": 1e6}
    assert (await fit_of(api, body))["misfit"] == "pressed_without_load"


async def test_positions_are_plain_distances(api):
    """Room, window and the arcs of each pin at crank angles, without and with deviations."""
    rng = random.Random(4)
    angles = [round(rng.uniform(0, 400), 3) for _ in range(4)]
    answer = (
        await api.post(PATH, json=DEVIATING | {"include": ["positions"], "crank_angle_deg": angles})
    ).json()
    off = {name.removesuffix("_mm").removesuffix("_deg"): values for name, values in OFF.items()}
    scaled = {
        name: _scaled(values, math.radians(1) if name.endswith("phase") else MM)
        for name, values in off.items()
    }
    sizes = Sizes(6, (0.0, math.pi), 20, 40 * MM, 5 * MM, 2 * MM, 7.03 * MM, scaled)
    for angle, found in zip(angles, answer["positions"], strict=True):
        wave = math.radians(angle) * 1.05
        assert found["crank_angle_deg"] == angle
        assert found["room_mm"] == pytest.approx(room(sizes, wave, 0.1) / MM, abs=1e-6)
        low, high = found["window_arcmin"]
        for end in (low, high):
            assert sizes.left(wave, end * ARCMIN) == pytest.approx(0, abs=1e-12)
        arcs = [arc for row in found["pairs"] for arc in row]
        assert [len(row) for row in found["pairs"]] == [6, 6]
        assert low == max(arc[0] for arc in arcs) and high == min(arc[1] for arc in arcs)


def _scaled(values, size):
    return [_scaled(each, size) if isinstance(each, list) else each * size for each in values]


async def test_arcs_of_pins(api):
    """Each pin has its own arc; a pin whose hole is off outward has none at some angles."""
    body = OUTWARD | {"include": ["positions"], "crank_angle_deg": [0.0, 180.0]}
    blocked, free = (await api.post(PATH, json=body)).json()["positions"]
    assert blocked["pairs"][0][0] == [] and "window_arcmin" not in blocked
    assert blocked["room_mm"] == pytest.approx(-1.9, abs=1e-9)
    assert free["room_mm"] > 0 and len(free["window_arcmin"]) == 2
    wave = math.pi * 1.05
    for n, arc in enumerate(free["pairs"][0]):
        out = 1j * cmath.exp(2j * math.pi * n / 6)
        hole = (32 if n == 0 else 30) * out + 1.5j * cmath.exp(-1j * wave)
        for lag in arc:
            pin = 30 * out * cmath.exp(-1j * lag * ARCMIN)
            assert abs(pin - hole) == pytest.approx(1.6, abs=1e-9)
    wide = OUTWARD | {
        "deviations": {"hole_radius_mm": [[100, 0, 0, 0, 0, 0]]}, "include": ["positions"]
    }  # fmt: skip
    (position,) = (await api.post(PATH, json=wide)).json()["positions"]
    assert position["pairs"][0][0] == [-10_800, 10_800]


@pytest.mark.parametrize("clearance", [17.9, 58.5, 1e6])
async def test_holes_that_do_not_hold_their_pins_are_a_state(api, clearance):
    body = asked(4, 1, 20, 30, 2, 1.5, clearance, include=["positions", "elastic", "discs"])
    response = await api.post(PATH, json=body)
    answer = response.json()
    assert response.status_code == 200 and "positions" not in answer
    assert answer["fit"] == {
        "state": "no_bound",
        "largest_hole_radius_mm": pytest.approx(math.hypot(2, 30 * math.sin(math.pi / 4))),
    }
    refused = await api.post(f"{PATH}/chart", json=body)
    assert refused.status_code == 422
    (error,) = refused.json()["errors"]
    assert (error["pointer"], error["code"]) == ("/contact/hole_radius_mm", "no_mechanism")


async def test_holes_that_just_hold_their_pins(api):
    limit = math.hypot(2, 30 * math.sin(math.pi / 4)) - 3.5
    body = asked(4, 1, 20, 30, 2, 1.5, limit - 1e-6)
    assert (await fit_of(api, body))["least_room_mm"] == pytest.approx(limit - 1e-6)
    assert (await fit_of(api, asked(4, 1, 20, 30, 2, 1.5, limit + 1e-6)))["state"] == "no_bound"


async def test_a_fit_by_its_classes_is_its_clearance(api):
    body = asked(6, 2, 20, 50, 8, 2, 0)
    del body["contact"]["hole_clearance_mm"]
    body["contact"]["fit"] = "H7/f7"
    # 20 H7 +0..+0.021, 16 f7 -0.016..-0.034: half of the mean of 0.016 and 0.055
    assert (await fit_of(api, body))["least_room_mm"] == pytest.approx(0.01775, abs=1e-9)


async def test_it_is_the_fit_of_the_load_sharing(api):
    """Values that both answers contain are equal."""
    for body in (DEVIATING, turned(1.5), SPIKED):
        load = body["load"] | {"output_torque_Nm": 20.0}
        other = (await api.post("load-sharing", json=body | {"load": load})).json()["fit"]
        found = await fit_of(api, body)
        assert {key: found[key] for key in other} == other


async def test_accuracy_is_stated(api):
    answer = (await api.post(PATH, json=SPIKED)).json()
    accuracy, fit = answer["accuracy"], answer["fit"]
    assert accuracy["method_code"] == "arcs_zoomed" and accuracy["evaluations"] == 720
    stated = accuracy["relative_error"] * fit["least_room_mm"]
    assert 0 < stated < 1e-11
    assert abs(fit["least_room_mm"] - 3.490658501803523e-06) <= stated
    answer = (await api.post(PATH, json=asked(4, 1, 20, 30, 2, 1.5, 0.5))).json()
    assert answer["accuracy"]["method_code"] == "closed_form"
    assert answer["accuracy"]["relative_error"] < 1e-14


@pytest.mark.parametrize(
    ("more", "pointer", "code"),
    [
        ({"mechanism": {"pins": 121, "ratio": 20}}, "/mechanism/pins", "too_many_pairs"),
        ({"mechanism": {"pins": 60, "ratio": 20}, "include": ["positions"],
          "crank_angle_deg": [0.0] * 1000}, "/mechanism/pins", "too_many_pairs"),
    ],
)  # fmt: skip
async def test_refusals_name_field_and_limit(api, more, pointer, code):
    response = await api.post(PATH, json=asked(6, 2, 20, 40, 5, 2, 0.03) | more)
    assert response.status_code == 422
    (error,) = response.json()["errors"]
    assert (error["pointer"], error["code"]) == (pointer, code)
    chart = await api.post(f"{PATH}/chart", json=asked(6, 2, 20, 40, 5, 2, 0.03) | more)
    assert (chart.status_code, chart.json()["errors"]) == (422, response.json()["errors"])
    if code == "too_many_pairs":
        assert error["params"] == {"limit": 50 if "include" in more else 120, "satellites": 2}


async def test_a_slip_is_asked_about(api):
    answer = (await api.post(PATH, json=asked(4, 2, 29, 33.875, 6, 1.25, 1.25))).json()
    codes = [each["code"] for each in answer["warnings"]]
    assert "twice_the_eccentricity" in codes and "clearance_like_eccentricity" in codes


async def test_worked_names_each_number(api):
    answer = (await api.post(PATH, json=DEVIATING | {"include": ["worked"]})).json()
    steps = {each["code"]: each["result"] for each in answer["worked"]}
    fit = answer["fit"]
    numbers = {key for key, value in fit.items() if isinstance(value, float)}
    assert set(steps) == numbers
    assert all(steps[key] == fit[key] for key in steps)


async def test_the_figure_shows_the_room_and_what_is_blocked(api):
    for body, several in ((BEHIND, 0), (OUTWARD, 0), (turned(9), 2), (turned(1.5), 2)):
        found = await fit_of(api, body)
        figure = (await api.post(f"{PATH}/chart", json=body)).json()
        whole, *discs, mark = figure["data"]
        assert len(discs) == several
        assert (mark["x"], mark["y"]) == (
            [found["least_room_crank_angle_deg"]], [found["least_room_mm"]]
        )  # fmt: skip
        assert min(whole["y"]) == pytest.approx(found["least_room_mm"], rel=SEARCHED)
        assert max(whole["y"]) == pytest.approx(found["greatest_room_mm"], abs=1e-3)
        for disc in discs:
            rooms = zip(disc["y"], whole["y"], strict=True)
            assert all(alone >= together - 1e-6 for alone, together in rooms)
        shaded = [(each["x0"], each["x1"]) for each in figure["layout"]["shapes"]]
        end = figure["layout"]["xaxis"]["range"][1]
        ratio = body["mechanism"]["ratio"]
        assert end == pytest.approx(360 / (1 + 1 / ratio))
        for start, stop in shaded:
            assert 0 <= start < stop <= end + 1e-9
        for (x0, y0), (x1, y1) in pairwise(zip(whole["x"], whole["y"], strict=True)):
            inside = any(start <= (x0 + x1) / 2 <= stop for start, stop in shaded)
            assert inside == (min(y0, y1) < -1e-7), x0
        share = math.fsum(stop - start for start, stop in shaded) / end
        known = {"fits": 0.0, "does_not_fit": 1.0}.get(found["state"], found.get("blocked_share"))
        assert share == pytest.approx(known)


async def test_the_figure_of_an_even_room_has_no_least_place(api):
    figure = (await api.post(f"{PATH}/chart", json=asked(4, 1, 20, 30, 2, 1.5, 0.5))).json()
    (curve,) = figure["data"]
    assert curve["y"] == pytest.approx([0.5] * len(curve["y"])) and not figure["layout"]["shapes"]
