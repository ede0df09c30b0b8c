"""Efficiency of the output mechanism over REST."""

import math

import pytest

from app.examples import EXAMPLES, REQUESTS
from core.precision import CONVERGED, EXACT
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "output-efficiency"
CYCLOID = next(each["input"] for each in EXAMPLES if each["id"] == "cycloid")


async def test_curves_only_where_they_are_asked(api):
    answer = (
        await api.post(PATH, json=changed(REQUESTS[PATH], include=["curves"], samples=7))
    ).json()
    curves = answer["curves"]
    assert curves["crank_angle_deg"] == [0, 60, 120, 180, 240, 300, 360]
    for loss, efficiency in zip(curves["loss_W"], curves["efficiency"], strict=True):
        power = answer["output_power_W"]
        assert efficiency == pytest.approx(power / (power + loss), rel=CONVERGED)
    assert "curves" not in (await api.post(PATH, json=REQUESTS[PATH])).json()


@pytest.mark.parametrize("output", ["pins", "ring"])
async def test_a_whole_reducer_takes_what_it_gives_and_what_it_loses(api, output):
    """Power at the input is that at the output and the losses of pins and teeth, where these are
    known.
    """
    body = changed(CYCLOID, mechanism={"output": output})
    asked = body | {"include": ["output_efficiency", "ring_mesh"]}
    answer = (await api.post("crank-planetary", json=asked)).json()
    losses, teeth = answer["output_efficiency"], answer["ring_mesh"]["efficiency"]
    speed = body["load"]["input_speed_rpm"] * math.pi / 30
    lost = losses["mean_loss_W"] + teeth["mean_loss_W"]
    balance = losses["output_power_W"] + lost
    assert losses["input_torque_Nm"] * speed == pytest.approx(balance, rel=CONVERGED)
    assert losses["total_efficiency"] == pytest.approx(1 - lost / balance, rel=CONVERGED)
    del asked["gear"]["friction_coefficient"]
    pins = (await api.post("crank-planetary", json=asked)).json()["output_efficiency"]
    assert pins["total_efficiency"] == pytest.approx(losses["efficiency"], rel=CONVERGED)


async def test_wear_is_that_over_the_required_life(api):
    body = changed(REQUESTS[PATH])
    own = (await api.post(PATH, json=body)).json()["pin_wear_mm"]
    life = body["friction"].pop("life_h")
    usual = (await api.post(PATH, json=body)).json()["pin_wear_mm"]
    asked = body | {"requirements": {"life_h": 2 * life}}
    asked = (await api.post(PATH, json=asked)).json()["pin_wear_mm"]
    assert [usual, asked] == pytest.approx([own * 5000 / life, 2 * own], rel=EXACT)


async def test_what_the_geometry_forbids_is_a_warning(api):
    body = changed(
        REQUESTS[PATH],
        contact={"hole_radius_mm": 9.5, "pin_radius_mm": 7.8},
        mechanism={"pins": 40},
    )
    warnings = (await api.post(PATH, json=body)).json()["warnings"]
    codes = [each["code"] for each in warnings]
    assert codes == ["interference", "wall_holes", "pins_apart"]


async def test_the_figure_has_both_curves_with_their_means(api):
    for theme in ("light", "dark"):
        figure = (await api.post(f"{PATH}/chart?theme={theme}", json=REQUESTS[PATH])).json()
        names = [trace["name"] for trace in figure["data"]]
        assert names == ["Loss", "Loss, mean", "Efficiency", "Efficiency, mean"]
        assert [trace["yaxis"] for trace in figure["data"]] == ["y", "y", "y2", "y2"]
        assert figure["data"][1]["y"] == pytest.approx([336, 336])
        assert len({trace["line"]["dash"] for trace in figure["data"][:2]}) == 2
        # The values of the means stand at the foot of the one plot and over the other.
        loss, efficiency = figure["layout"]["annotations"]
        assert [loss["text"], efficiency["text"]] == ["mean 336 W", "mean 0.92118"]
        assert [loss["yref"], loss["y"]] == ["y domain", 0]
        assert min(figure["data"][0]["y"]) > max(figure["data"][0]["y"]) / 2
        assert [efficiency["yref"], efficiency["y"], efficiency["yanchor"]] == [
            "y2 domain",
            1,
            "bottom",
        ]
