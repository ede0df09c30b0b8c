"""How parts are made fills tolerances that are not given, with guides that say their source."""

import pytest

pytestmark = pytest.mark.anyio

PATH = "tolerance-study"
BODY = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 20, "pin_circle_radius_mm": 40},
    "contact": {"contact_length_mm": 12, "pin_radius_mm": 5, "eccentricity_mm": 2,
                "hole_clearance_mm": 0.5},
    "samples": 40,
    "crank_angles": 12,
    "percentiles": [50],
}  # fmt: skip


async def answered(api, tolerances, **more):
    answer = await api.post(PATH, json=BODY | {"tolerances": tolerances} | more)
    assert answer.status_code == 200, answer.text
    return answer.json()


async def test_a_process_fills_what_is_not_given(api):
    """Filament: holes 0 to 0.4 mm too small in diameter, pins 0 to 0.2 mm too large; the clearance
    of 0.5 mm is 0.35 mm on the mean: 0.5 - 0.4/4 - 0.2/4."""
    answer = await answered(api, {"process": "fdm"})
    process = answer["process"]
    assert process["code"] == "fdm" and "Makelab" in process["source"]
    assert {*process["filled"]} == {
        f"/tolerances/{part}_{of}" for part in ("pin", "hole") for of in ("position_mm", "diameter")
    }
    assert process["mean_clearance_mm"] == pytest.approx(0.35, abs=1e-12)
    (warning,) = (each for each in answer["warnings"] if each["code"] == "guide_tolerances")
    assert "factor of two" in warning["detail"]
    assumed = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert assumed["/tolerances/hole_diameter"] == {"lower_mm": -0.4, "upper_mm": 0.0}
    assert assumed["/tolerances/pin_position_mm"] == 0.3
    assert "pin_code" not in process


async def test_it_is_as_if_the_guides_were_typed(api):
    """Fields that are given keep their values."""
    typed = {
        "pin_position_mm": 0.2,
        "hole_position_mm": 0.2,
        "pin_diameter": {"lower_mm": -0.1, "upper_mm": 0.1},
        "hole_diameter": {"lower_mm": -0.1, "upper_mm": 0.1},
    }
    by_hand = await answered(api, typed)
    assert "process" not in by_hand and "assumed" not in str(by_hand.get("warnings"))
    by_process = await answered(api, {"process": "sla"})
    assert by_process["quantities"] == by_hand["quantities"]
    one = {"process": "sla", "hole_position_mm": 0.05}
    answer = await answered(api, one)
    assert "/tolerances/hole_position_mm" not in answer["process"]["filled"]
    by_hand = await answered(api, typed | {"hole_position_mm": 0.05})
    assert answer["quantities"] == by_hand["quantities"]
    every = await answered(api, typed | {"process": "sla"})
    assert every["process"]["filled"] == []
    assert "guide_tolerances" not in str(every.get("warnings"))


async def test_pins_that_are_bought_have_a_process_of_their_own(api):
    answer = await answered(api, {"process": "fdm", "pin_process": "precise"})
    process = answer["process"]
    assert (process["code"], process["pin_code"]) == ("fdm", "precise")
    # h6 of 10 mm: 0 to -9 um in diameter
    assert process["mean_clearance_mm"] == pytest.approx(0.5 - 0.1 + 0.00225, abs=1e-12)
    alone = await answered(api, {"pin_process": "precise", "hole_position_mm": 0.1})
    assert alone["process"]["code"] == "precise" and "pin_code" not in alone["process"]
    assert {*alone["process"]["filled"]} == {"/tolerances/pin_position_mm",
                                             "/tolerances/pin_diameter"}  # fmt: skip
    cut = await answered(api, {"process": "laser_cut"})
    assert "/tolerances/pin_diameter" not in cut["process"]["filled"]  # no pin is cut so


async def test_a_fit_says_the_diameters(api):
    contact = {name: each for name, each in BODY["contact"].items() if "clearance" not in name}
    answer = await answered(api, {"process": "milled"}, contact=contact | {"fit": "H7/f7"})
    assert {*answer["process"]["filled"]} == {
        "/tolerances/pin_position_mm",
        "/tolerances/hole_position_mm",
    }
    # H7 of 14 mm: 0 to 18 um; f7 of 10 mm: -28 to -13 um
    assert answer["process"]["mean_clearance_mm"] == pytest.approx(0.01475, abs=1e-12)


async def test_contributions_are_of_what_is_filled(api):
    answer = await answered(api, {"process": "milled"}, include=["contributions"], samples=64)
    ranked = (
        answer.get("fit_contributions") or answer["quantities"]["peak_force_N"]["contributions"]
    )
    assert {each["source"] for each in ranked} == {
        "pin_position_mm", "hole_position_mm", "pin_diameter", "hole_diameter"
    }  # fmt: skip


async def test_all_processes_are_listed_with_their_sources(api):
    found = (await api.get("processes")).json()["processes"]
    assert [each["code"] for each in found] == [
        "fdm", "sla", "sls", "mjf", "laser_cut", "milled", "precise", "ground"
    ]  # fmt: skip
    for each in found:
        assert each["source"] and each["position_mm"] > 0
        assert each["least_clearance_mm"] <= each["clearance_mm"] <= each["largest_clearance_mm"]
        answer = await answered(api, {"process": each["code"]})
        filled = {one["pointer"]: one["value"] for one in answer["assumed"]}
        for part in ("hole", "pin"):
            assert filled[f"/tolerances/{part}_position_mm"] == each["position_mm"]
            assert filled.get(f"/tolerances/{part}_diameter") == each.get(f"{part}_diameter")
    fdm, _, sls, *_ = found
    assert fdm["hole_diameter"] == {"lower_mm": -0.4, "upper_mm": 0.0}
    assert fdm["pin_diameter"] == {"lower_mm": 0.0, "upper_mm": 0.2}
    assert sls["hole_diameter"] == {"lower_mm": -0.3, "upper_mm": 0.1}
    assert found[-1]["hole_diameter"] == {"class": "H6"} and "pin_diameter" not in found[4]


async def test_another_process_is_refused(api):
    answer = await api.post(PATH, json=BODY | {"tolerances": {"process": "cast"}})
    (error,) = answer.json()["errors"]
    assert (error["pointer"], error["code"]) == ("/tolerances/process", "literal_error")
