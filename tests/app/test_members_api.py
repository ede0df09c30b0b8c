"""Pins, ring or both as the output, and two shafts that pins couple, through the API."""

import math

import pytest

from app.calculations.members_answer import MembersOut
from app.model import ResponseModel
from core.errors import NotKnown
from core.output.mechanism import Members
from core.precision import CONVERGED, EXACT, SAME, SEARCHED

pytestmark = pytest.mark.anyio

CONTACT = {"eccentricity_mm": 2.0, "pin_radius_mm": 8.0, "contact_length_mm": 20.0}
PATH = "crank-planetary"


def design(output="pins", ratio=20, torque=500.0, speed=1500.0, **load):
    return {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": ratio, "output": output},
        "load": {
            "output_torque_Nm": torque,
            "pin_circle_radius_mm": 50.0,
            "input_speed_rpm": speed,
            **load,
        },
        "contact": CONTACT,
        "friction": {"coefficient": 0.08},
    }


async def refused(api, path, body):
    response = await api.post(path, json=body)
    assert response.status_code == 422, response.text
    error = response.json()["errors"][0]
    return error["pointer"], error["code"], error["params"]


HELD = {
    "pins": (
        design(),
        (-75.0, 1575.0, 1500.0, 500.0, 25.0, -525.0, 3333.3333333333335, 336.0, 0.921182096226644),
    ),
    "ring": (
        design("ring"),
        (0.0, 1500.0, 1428.5714285714287, 476.1904761904762, 23.80952380952381, -500.0,
         3174.603174603175, 304.76190476190476, 0.9246525331017778),
    ),
    "ring, u 5": (
        design("ring", ratio=5, torque=120.0, speed=1000.0),
        (0.0, 1000.0, 833.3333333333334, 100.0, 20.0, -120.0, 666.6666666666666,
         42.66666666666668, 0.9800348931021133),
    ),
    "both, the ring at 7 rpm": (
        design("both", ring_speed_rpm=7.0),
        (-67.65, 1567.65, 1493.0, 500.0, 25.0, -525.0, 3333.3333333333335, 334.43200000000013,
         None),
    ),
    "both, the ring with the crank": (
        design("both", speed=300.0, ring_speed_rpm=300.0),
        (300.0, 0.0, 0.0, 500.0, 25.0, -525.0, 3333.3333333333335, 0.0, 1.0),
    ),
}  # fmt: skip
"""Speeds of the carrier, relative and of the crank against the ring, torques of pins, crank and
ring, peak force, loss, efficiency: by velocities at the pitch point, statics, and 3600 angles."""


@pytest.mark.parametrize("name", HELD)
async def test_members_of_designs_that_are_known(api, name):
    body, expected = HELD[name]
    answer = await api.answer(
        PATH, body | {"include": ["members", "contact_force", "output_efficiency"]}
    )
    members, losses = answer["members"], answer["output_efficiency"]
    found = [
        members["carrier_speed_rpm"],
        members["relative_speed_rpm"],
        members["crank_to_ring_speed_rpm"],
        members["pin_torque_Nm"],
        members["crank_torque_Nm"],
        members["ring_torque_Nm"],
        answer["contact_force"]["peak_force_N"],
        losses["mean_loss_W"],
        losses["efficiency"],
    ]
    for one, two in zip(found, expected, strict=True):
        assert two is None or one == pytest.approx(two, rel=SEARCHED, abs=1e-6)
    assert members["power_balance_W"] == pytest.approx(0.0, abs=1e-6)


async def test_members_are_said_where_the_pins_are_not_the_output(api):
    assert "members" not in await api.answer(PATH, design())
    for output in ("ring", "both"):
        body = design(output, **({"ring_speed_rpm": 3.0} if output == "both" else {}))
        assert (await api.answer(PATH, body))["members"]["output"] == output
    body = design("ring")
    del body["load"]["input_speed_rpm"]
    members = (await api.answer(PATH, body))["members"]
    assert members["output_ratio"] == 21 and "crank_power_W" not in members


WHOLE = design() | {
    "contact": CONTACT | {"hole_clearance_mm": 0.02, "pin_material": "steel_bearing",
                          "hole_material": "steel_case_hardened"},
    "requirements": {"scope": ["contact", "losses"]},
}  # fmt: skip


def of(output, **changes):
    """Design with another output."""
    body = WHOLE | {"mechanism": WHOLE["mechanism"] | {"output": output}}
    for section, values in changes.items():
        body[section] = body[section] | values
    return body


async def test_one_design_run_with_pins_and_with_the_ring_as_output(api):
    """Powers and speeds close; play and stiffness are seen at the ring."""
    sections = ["members", "load_sharing", "output_efficiency", "largest_torque"]
    u, share = 20, 20 / 21
    pins = await api.answer(PATH, of("pins") | {"include": sections})
    load = {"output_torque_Nm": 500 / share, "input_speed_rpm": 1500 / share}
    ring = await api.answer(PATH, of("ring", load=load) | {"include": sections})
    for answer, output, speed in ((pins, -75.0, 1500.0), (ring, 75.0, 1575.0)):
        members = answer["members"]
        assert members["output_ratio"] == pytest.approx(speed / output, rel=SAME)
        powers = [members[f"{name}_power_W"] for name in ("crank", "carrier", "ring")]
        assert sum(powers) == pytest.approx(0, abs=1e-9) == members["power_balance_W"]
        out = answer["output_efficiency"]["output_power_W"]
        assert out == pytest.approx(powers[0], rel=SAME) == -min(powers)
    assert ring["members"]["carrier_speed_rpm"] == pins["members"]["ring_speed_rpm"] == 0
    assert ring["members"]["relative_speed_rpm"] == pytest.approx(1575, rel=SAME)

    one, two = pins["load_sharing"], ring["load_sharing"]
    assert two["peak_force_N"] == pytest.approx(one["peak_force_N"], rel=EXACT)
    for name in ("backlash_max_arcmin", "backlash_min_arcmin", "lost_motion_arcmin",
                 "transmission_error_arcmin"):  # fmt: skip
        assert two[name] == pytest.approx(one[name] * u / (u + 1), rel=SEARCHED), name
    for name in ("stiffness_min_Nm_per_arcmin", "stiffness_max_Nm_per_arcmin"):
        assert two[name] == pytest.approx(one[name] * ((u + 1) / u) ** 2, rel=SEARCHED), name
    assert two["input_torque_ripple_Nm"] == pytest.approx(
        one["input_torque_ripple_Nm"], rel=SEARCHED
    )

    # as much torque more as the ring has
    assert ring["largest_torque_Nm"] == pytest.approx(pins["largest_torque_Nm"] / share, rel=1e-4)


async def test_load_sharing_fit_and_study_see_the_output(api):
    sections = {name: WHOLE[name] for name in ("mechanism", "load", "contact")}
    load = {name: WHOLE["load"][name] for name in ("output_torque_Nm", "pin_circle_radius_mm")}
    include = ["positions", "over_turn", "curves", "stiffness_curve"]
    body = sections | {"load": load, "include": include, "samples": 5, "torques_Nm": [-100, 200.0]}
    share = 20 / 21
    pins = await api.answer("load-sharing", body)
    raised = {"output_torque_Nm": 500 / share}
    ring_mechanism = sections["mechanism"] | {"output": "ring"}
    ring_body = body | {"mechanism": ring_mechanism, "load": load | raised,
                        "torques_Nm": [-100 / share, 200 / share]}  # fmt: skip
    ring = await api.answer("load-sharing", ring_body)

    def close(one, two, factor):
        flat = [(one, two)] if not isinstance(one, list) else [*zip(one, two, strict=True)]
        for first, second in flat:
            assert second == pytest.approx(first * factor, rel=EXACT, abs=1e-9)

    factors = {"_arcmin": share, "Nm_per_arcmin": share**-2, "satellite_torque_Nm": 1 / share}
    seen = 0
    for section in include:
        one, two = (
            each[section][0] if section == "positions" else each[section] for each in (pins, ring)
        )
        for name, value in one.items():
            ends = [end for end in sorted(factors, key=len) if name.endswith(end)]
            if ends and "error" not in name:
                close(value, two[name], factors[ends[-1]])
                seen += 1
    assert seen >= 16
    close(pins["stiffness_curve"]["torque_Nm"], ring["stiffness_curve"]["torque_Nm"], 1 / share)
    close(pins["curves"]["input_torque_Nm"], ring["curves"]["input_torque_Nm"], 1.0)
    assert (await api.post("load-sharing/chart", json=ring_body)).status_code == 200

    circle = {"load": {"pin_circle_radius_mm": 50}, "include": ["positions"]}
    one, two = [
        await api.answer("fit", sections | circle | {"mechanism": each})
        for each in (sections["mechanism"], ring_mechanism)
    ]
    for name in ("least_room_arcmin", "greatest_room_arcmin"):
        close(one["fit"][name], two["fit"][name], share)
    assert two["fit"]["least_room_mm"] == one["fit"]["least_room_mm"]
    close(one["positions"][0]["window_arcmin"], two["positions"][0]["window_arcmin"], share)
    close(one["positions"][0]["pairs"][0][0], two["positions"][0]["pairs"][0][0], share)

    study = {
        "tolerances": {"pin_position_mm": 0.01},
        "samples": 100,
        "quantities": ["backlash_max_arcmin", "peak_force_N", "stiffness_min_Nm_per_arcmin"],
        "include": ["histogram"],
    }
    one = await api.answer("tolerance-study", sections | study | {"load": load})
    middle = one["quantities"]["backlash_max_arcmin"]["percentiles"][0]["value"]
    at_ring = {"load": load | raised, "mechanism": ring_mechanism}
    study |= {"limits": {"backlash_max_arcmin": middle * share}}
    two = await api.answer("tolerance-study", sections | study | at_ring)
    for name, factor in (("backlash_max_arcmin", share), ("peak_force_N", 1.0),
                         ("stiffness_min_Nm_per_arcmin", share**-2)):  # fmt: skip
        first, second = (each["quantities"][name] for each in (one, two))
        close(first["mean"], second["mean"], factor)
        close(first["nominal"], second["nominal"], factor)
        close(first["percentiles"][0]["value"], second["percentiles"][0]["value"], factor)
        close(first["histogram"]["edges"], second["histogram"]["edges"], factor)
    assert two["quantities"]["backlash_max_arcmin"]["yield"]["value"] == pytest.approx(
        0.5, abs=0.02
    )


async def test_torque_of_the_crank_makes_that_of_the_ring(api):
    flat = {"pins": 6, "satellites": 2, "ratio": 20, "pin_circle_radius_mm": 50}
    by_crank = flat | {"input_torque_Nm": 25, "efficiency": 0.9}
    on_pins = await api.answer("contact-force", by_crank)
    ring = await api.answer("contact-force", by_crank | {"output": "ring"})
    assert ring["peak_force_N"] == pytest.approx(on_pins["peak_force_N"], rel=CONVERGED)
    whole = design("ring")
    whole["load"] = {"input_torque_Nm": 25, "efficiency": 0.9, "pin_circle_radius_mm": 50}
    members = (await api.answer(PATH, whole))["members"]
    assert members["pin_torque_Nm"] == pytest.approx(450.0, rel=CONVERGED)
    assert members["ring_torque_Nm"] == pytest.approx(-472.5, rel=CONVERGED)


async def test_the_ratio_may_be_that_of_the_ring(api):
    body = design("ring")
    by_u = await api.answer(PATH, body)
    mechanism = {name: value for name, value in body["mechanism"].items() if name != "ratio"}
    by_i = await api.answer(PATH, body | {"mechanism": mechanism | {"output_ratio": 21}})
    for each in (by_u, by_i):
        del each["members"]["accuracy"]
    assert by_i["members"] == by_u["members"]
    assert by_i["contact_force"]["peak_force_N"] == by_u["contact_force"]["peak_force_N"]
    teeth = mechanism | {"satellite_teeth": 20, "ring_teeth": 21}
    by_teeth = (await api.answer(PATH, body | {"mechanism": teeth}))["members"]
    assert by_teeth.pop("accuracy") and by_teeth == by_u["members"]


@pytest.mark.parametrize(
    ("mechanism", "expected"),
    [
        ({"output": "ring", "ratio": -29}, ("/mechanism/ratio", "sign_of_ring", {"offered": 29})),
        ({"output": "ring", "output_ratio": 21}, ("/mechanism/output_ratio", "only_one", ...)),
        ({"output": "pins", "ratio": None, "output_ratio": 21},
         ("/mechanism/output_ratio", "of_other_output", {"output": "pins"})),
        ({"output": "ring", "ratio": None}, ("/mechanism/ratio", "needed", ...)),
        ({"output": "coupling"}, ("/mechanism/ratio", "of_other_output", {"output": "coupling"})),
        ({"output": "coupling", "ratio": None}, ("/mechanism/satellites", "one_of_coupling", ...)),
        ({"output": "crankshafts"}, ("/mechanism/output", "not_this_mechanism", ...)),
        ({"ratio": 0.05}, ("/mechanism/ratio", "ratio_below_one", {"limit": 1, "offered": 20})),
    ],
)  # fmt: skip
async def test_ratios_of_another_output_are_refused(api, mechanism, expected):
    given = design()["mechanism"] | mechanism
    body = design() | {"mechanism": {k: v for k, v in given.items() if v is not None}}
    pointer, code, params = await refused(api, PATH, body)
    assert (pointer, code) == expected[:2]
    assert expected[2] in (..., params)


async def test_a_sign_is_that_of_every_such_mechanism(api):
    answer = await api.answer(PATH, {"mechanism": {"pins": 4, "satellites": 1, "ratio": -29}})
    assert [(each["code"], each["params"]) for each in answer["warnings"]] == [
        ("ratio_sign", {"ratio": 29})
    ]


async def test_speeds_of_both_are_asked_of_both_alone(api):
    pointer, code, _ = await refused(api, PATH, design("ring", ring_speed_rpm=3.0))
    assert (pointer, code) == ("/load/ring_speed_rpm", "of_other_output")
    pointer, code, _ = await refused(api, PATH, design("both"))
    assert (pointer, code) == ("/load/ring_speed_rpm", "needed_beside")
    two = design("both", ring_speed_rpm=3.0, carrier_speed_rpm=1.0)
    assert (await refused(api, PATH, two))[1] == "only_one"
    alone = design("both", ring_speed_rpm=3.0)
    del alone["load"]["input_speed_rpm"]
    assert (await refused(api, PATH, alone))[:2] == ("/load/input_speed_rpm", "needed_beside")
    by_pins = design("both", carrier_speed_rpm=-67.65)
    members = (await api.answer(PATH, by_pins))["members"]
    assert members["ring_speed_rpm"] == pytest.approx(7.0, abs=1e-9)


COUPLING = {
    "mechanism": {"pins": 6, "output": "coupling"},
    "load": {"output_torque_Nm": 20, "pin_circle_radius_mm": 30, "input_speed_rpm": 600},
    "contact": {"eccentricity_mm": 1.5, "pin_radius_mm": 4, "contact_length_mm": 10,
                "hole_clearance_mm": 0.01},
    "friction": {"coefficient": 0.1},
}  # fmt: skip


async def test_two_shafts_that_pins_couple(api):
    """The pins slide at e times the speed of the shafts, which turn alike; the loss by the mean sum
    of forces, 4/pi T/R for six even pins that share as cosines."""
    ideal = COUPLING | {"contact": COUPLING["contact"] | {"hole_clearance_mm": 0}}
    answer = await api.answer(PATH, ideal)
    speed = 600 * math.pi / 30
    losses = answer["output_efficiency"]
    assert losses["sliding_speed_m_per_s"] == pytest.approx(1.5e-3 * speed, rel=SAME)
    assert losses["output_power_W"] == pytest.approx(20 * speed, rel=SAME)
    loss = 0.1 * 1.5e-3 * speed * 4 / math.pi * 20 / 0.03
    assert losses["mean_loss_W"] == pytest.approx(loss, rel=SAME)
    assert losses["efficiency"] == pytest.approx(1 / (1 + loss / (20 * speed)), rel=SAME)
    assert answer["cyclogram"]["period_deg"] == 360
    members = answer["members"]
    assert (members["output_ratio"], members["carrier_speed_rpm"]) == (1, 600)
    assert members["power_balance_W"] == 0
    parts = {each["code"]: each["status"] for each in answer["parts"]}
    for part in ("teeth", "satellite_bearing", "crank_bearings"):
        assert parts[part] == "left_out"
    assert "assumed" not in answer or "/mechanism/satellites" not in str(answer["assumed"])


async def test_a_loose_coupling_is_solved_and_drives_with_what_it_is_driven(api):
    sections = {name: COUPLING[name] for name in ("mechanism", "contact")}
    load = {"output_torque_Nm": 20, "pin_circle_radius_mm": 30}
    body = sections | {"load": load, "include": ["over_turn", "curves"], "samples": 361}
    answer = await api.answer("load-sharing", body)
    driving = answer["curves"]["input_torque_Nm"][:-1]
    assert sum(driving) / len(driving) == pytest.approx(20, rel=1e-3)
    backlash = 2 * 0.01 / (30 * math.cos(math.pi / 6)) * 10800 / math.pi  # of first order
    assert answer["over_turn"]["backlash_max_arcmin"] == pytest.approx(backlash, rel=0.01)
    await api.answer(PATH, COUPLING | {"include": ["checks", "load_sharing", "hertz"]})
    answer = await api.answer(PATH, COUPLING | {"include": ["worked", "output_efficiency"]})
    assert all("u" not in each["names"] for each in answer["worked"])
    for section, values in (
        ("gear", {"kind": "none"}),
        ("crank_support", {"radial_clearance_mm": 0.01}),
    ):
        found = await refused(api, PATH, COUPLING | {section: values})
        assert found[:2] == (f"/{section}", "of_other_output")
    found = await refused(
        api, "load-sharing", body | {"crank_support": {"stiffness_N_per_mm": 1e4}}
    )
    assert found[:2] == ("/crank_support", "of_other_output")


def test_an_answer_leaves_out_what_may_be_absent_and_nothing_else() -> None:
    class Moving(ResponseModel):
        crank_power_W: float

    loads = Members("pins", 20.0).loads(output_torque=500.0)
    found = MembersOut.values(loads, output="pins")
    assert found["crank_torque_Nm"] == 25 and "crank_power_W" not in found
    with pytest.raises(NotKnown):
        Moving.values(loads)
