"""The Python client against a running service, and against one that is busy."""

import ast
import json
import pickle
import sys
from pathlib import Path

import httpx
import khv_calc
import numpy as np
import pytest
from khv_calc import Client, Fault, Refused, is_called

from app.examples import EXAMPLES, REQUESTS
from app.settings import Settings
from core.precision import CONVERGED, SAME

FORCE = {"pins": 3, "ratio": 20, "output_torque_Nm": 500, "pin_circle_radius_mm": 50}
HERTZ = REQUESTS["hertz"]


@pytest.fixture(scope="module")
def calc(service):
    with Client(service.url, transport=httpx.HTTPTransport()) as client:
        yield client


def test_an_answer_is_that_of_the_api(service, calc):
    answer = calc.ask("contact-force", FORCE, include=["equal_sharing"])
    assert answer["peak_force_N"] == pytest.approx(20_000 / 3, rel=CONVERGED)
    assert "equal_sharing_peak_N" in answer and "curves" not in answer
    sent = httpx.post(f"{service.url}/api/v1/contact-force", json=FORCE, trust_env=False).json()
    assert sent["peak_force_N"] == answer["peak_force_N"]


def test_a_calculation_of_a_longer_name_can_be_asked(calc):
    """Each example is asked in tests/app/test_service.py."""
    assert calc.ask("precession/contact-line", REQUESTS["precession/contact-line"])


def test_what_is_found_comes_at_once(calc):
    *found, last = calc.ask_as_found("propose", REQUESTS["propose"])
    assert [each["proposal"] for each in found] == last["result"]["proposals"]
    with pytest.raises(Refused) as caught:
        next(calc.ask_as_found("propose", REQUESTS["propose"], process="sla"))
    assert caught.value.faults[0].pointer == "/process"


def test_a_file(calc):
    name, content = calc.file("export/dxf", REQUESTS["export/dxf"], parts=["ring_pins"])
    assert name == "ring_pins.dxf" and content.rstrip().endswith(b"EOF")
    with pytest.raises(Refused) as caught:
        calc.file("export/dxf", REQUESTS["export/dxf"], parts=["lid"])
    assert caught.value.faults[0].pointer == "/parts/0"


def test_a_project_file_is_asked_again_and_says_what_moved(calc):
    (body,) = (each["input"] for each in EXAMPLES if each["id"] == "whole")
    body = body | {"include": ["hertz", "checks"]}
    pressure = calc.ask("crank-planetary", body)["hertz"]["max_pressure_MPa"]
    results = {"verdict": "fail", "governing": "gone", "max_pressure_MPa": pressure}
    kept = {"calculator": "crank-planetary", "input": {}, "results": results}
    one = {"name": "A", **kept, "path": "/crank-planetary", "body": body}
    other = one | {"name": "B", "results": {"max_pressure_MPa": 2 * pressure}}
    designs = [one, other, {"name": "C", **kept}]
    project = {"format": "khv-calc designs", "v": 2, "designs": designs}
    (name, answer, moved), (_, _, numbers) = calc.reopened(json.dumps(project))
    assert (name, answer["hertz"]["max_pressure_MPa"]) == ("A", pressure)
    assert moved == {
        "verdict": ("fail", answer["verdict"]),
        "governing": ("gone", answer["governing"]),
    }
    assert numbers == {"max_pressure_MPa": (2 * pressure, pressure)}
    with pytest.raises(ValueError, match="no project file"):
        next(calc.reopened("{}"))


def test_what_the_service_says_about_itself(calc):
    assert [each["id"] for each in calc.get("examples")["examples"]] == [
        each["id"] for each in EXAMPLES
    ]


def test_a_figure(calc):
    assert calc.ask("contact-force/chart", FORCE).keys() >= {"data", "layout"}


def test_a_warning_is_known_by_its_old_code_too(calc):
    body = REQUESTS["output-efficiency"]
    crowded = body | {"mechanism": body["mechanism"] | {"pins": 50}}
    warnings = calc.ask("output-efficiency", crowded)["warnings"]
    for code in ("wall_holes", "holes_overlap", "pins_apart", "pins_overlap"):
        assert sum(is_called(each, code) for each in warnings) == 1
    assert not any(is_called(each, "interference") for each in warnings)


def test_numbers_of_numpy(calc):
    answer = calc.ask(
        "contact-force",
        FORCE | {"pins": np.int64(3), "crank_angles_deg": np.array([0.0, 180.0])},
        satellites=np.float32(2),
    )
    assert answer["peak_force_N"] == pytest.approx(20_000 / 3, rel=SAME)


def test_wrong_fields_are_named_by_pointer_and_code(calc):
    with pytest.raises(Refused, match="pins must be at least 1") as caught:
        calc.ask("contact-force", FORCE, pins=0, colour="red")
    assert caught.value.status == 422
    assert {(each.pointer, each.code) for each in caught.value.faults} == {
        ("/pins", "greater_than_equal"),
        ("/colour", "extra_forbidden"),
    }
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.faults == caught.value.faults


def test_a_mechanism_that_cannot_work_says_where(calc):
    with pytest.raises(Refused) as caught:
        calc.ask("contact-force", FORCE, pins=2, satellites=1)
    assert [each.code for each in caught.value.faults] == ["dead_centre"]
    assert "crank_angle_deg" in caught.value.where


def test_what_no_calculation_is_is_refused(calc):
    with pytest.raises(Refused, match="No such path") as caught:
        calc.ask("no-such-thing")
    assert caught.value.status == 404


def test_what_is_no_number_is_not_sent(calc):
    with pytest.raises(ValueError):
        calc.ask("hertz", HERTZ, force_N=float("nan"))
    with pytest.raises(TypeError, match="object cannot be sent"):
        calc.ask("hertz", HERTZ, force_N=object())


def test_many_answers_in_their_order(calc):
    forces = np.linspace(-100.0, 5000.0, 250)
    answers = list(calc.ask_many("hertz", ({**HERTZ, "force_N": f} for f in forces), at_once=100))
    assert len(answers) == len(forces)
    for force, answer in zip(forces, answers, strict=True):
        if force <= 0:
            assert isinstance(answer, Refused)
            (fault,) = answer.faults
            assert isinstance(fault, Fault) and fault.pointer == "/force_N"
        else:
            alone = calc.ask("hertz", HERTZ, force_N=force) if force == forces[-1] else None
            assert alone is None or alone["max_pressure_MPa"] == answer["max_pressure_MPa"]
    pressures = [each["max_pressure_MPa"] for each in answers if not isinstance(each, Refused)]
    assert pressures == sorted(pressures)


def test_answers_come_before_all_are_done_and_may_be_left(calc):
    several = calc.ask_many("hertz", [HERTZ] * 10_000)
    assert next(several)["max_pressure_MPa"] > 0
    several.close()
    assert calc.ask("hertz", HERTZ)


def batches_of(*bodies, **limits):
    """Contents of the batches in which a client sends requests."""
    sent = []

    def answered(request):
        sent.append(request.content)
        return httpx.Response(200, text='{"result":{}}\n' * len(json.loads(sent[-1])["requests"]))

    client = Client("http://service", transport=httpx.MockTransport(answered))
    assert [*client.ask_many("hertz", bodies, **limits)] == [{}] * len(bodies)
    assert [each for one in sent for each in json.loads(one)["requests"]] == [*bodies]
    return sent


def test_long_lists_are_cut_by_number_and_by_bytes():
    """None is lost; none is more than a service takes, but for a request that is so by itself."""
    sent = batches_of(*({"force_N": n} for n in range(2500)))
    assert [len(json.loads(each)["requests"]) for each in sent] == [1000, 1000, 500]
    assert batches_of() == []
    for letters in ("x", "é"):
        sent = batches_of(*({"a": letters * r} for r in range(2000)))
        assert len(sent) > 2 and all(len(each) <= 1 << 20 for each in sent)
    body = {"a": "x" * 50}
    (alone,) = batches_of(body)
    assert len(batches_of(body, body, most_bytes=len(alone))) == 2
    assert len(batches_of(body, body, most_bytes=2 * len(alone))) == 1
    assert len(batches_of(body, body, most_bytes=1)) == 2


def test_what_the_client_cuts_by_is_what_the_service_takes():
    settings = Settings()
    assert settings.max_batch == khv_calc.MOST_AT_ONCE
    assert settings.max_batch_bytes == khv_calc.MOST_BYTES


def test_a_batch_that_is_none_is_refused_as_a_whole(calc):
    with pytest.raises(Refused) as caught:
        next(calc.ask_many("no-such-thing", [{}]))
    assert [each.pointer for each in caught.value.faults] == ["/calculation"]


@pytest.fixture
def slept(monkeypatch):
    """Seconds that the client has slept: no others pass."""
    seconds = []
    monkeypatch.setattr(khv_calc.time, "sleep", seconds.append)
    monkeypatch.setattr(khv_calc.time, "monotonic", lambda: float(sum(seconds)))
    return seconds


def busy(times):
    """A client of a service that is busy so many times, then answers."""
    problem = {"status": 503, "detail": "Busy", "errors": []}
    header = {"retry-after": "7", "content-type": "application/problem+json"}
    answers = iter([httpx.Response(503, json=problem, headers=header)] * times)
    good = httpx.Response(200, json={"answered": True})
    transport = httpx.MockTransport(lambda request: next(answers, good))
    return Client("http://service", patience_s=20, transport=transport)


def test_a_busy_service_is_asked_again_when_it_says(slept):
    assert busy(2).ask("hertz", HERTZ) == {"answered": True}
    assert slept == [7, 7]


def test_patience_ends(slept):
    with pytest.raises(Refused, match="Busy") as caught:
        busy(3).ask("hertz", HERTZ)
    assert caught.value.status == 503 and slept == [7, 7]


def test_an_error_of_something_else_is_httpxs(slept):
    transport = httpx.MockTransport(lambda request: httpx.Response(502, text="Bad gateway"))
    with pytest.raises(httpx.HTTPStatusError):
        Client("http://service", transport=transport).ask("hertz", HERTZ)


def test_an_answer_that_is_cut_short_is_noticed():
    line = httpx.Response(200, text='{"result":{}}\n')
    client = Client("http://service", transport=httpx.MockTransport(lambda request: line))
    several = client.ask_many("hertz", [{}, {}])
    assert next(several) == {}
    with pytest.raises(ValueError):
        next(several)


def test_it_needs_httpx_and_nothing_else():
    tree = ast.parse(Path(khv_calc.__file__).read_text())
    imported = {
        name.split(".")[0]
        for node in ast.walk(tree)
        for name in (
            [each.name for each in node.names] if isinstance(node, ast.Import)
            else [node.module or ""] if isinstance(node, ast.ImportFrom)
            else []
        )
    }  # fmt: skip
    assert imported - set(sys.stdlib_module_names) == {"httpx"}
