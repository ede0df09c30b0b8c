"""STEP files: the script of `/export/build123d`, run as it is with a stand-in for build123d.

`make office` makes them with build123d itself.
"""

import subprocess

import pytest

from app import model
from app.examples import REQUESTS
from app.exports import build123d, step
from app.registry import EXPORTS

pytestmark = pytest.mark.anyio

PATH = "export/step"

STAND_IN = """
import inspect, os, resource, sys

class Shape:
    def __init__(self, *given, **named):
        vars(self).update(named)
    def __add__(self, other):
        return Shape()
    __sub__ = __mul__ = __rmul__ = __add__
    def rotate(self, axis, degrees):
        return self
    def edges(self):
        return []

class Axis:
    Z = None

Circle = Compound = Polyline = Pos = Spline = extrude = make_face = Shape

def export_step(shape, path):
    with open(path, "w") as file:
        limit, _ = resource.getrlimit(resource.RLIMIT_AS)
        labels = ",".join(each.label for each in shape.children)
        print(limit, os.environ["OPENBLAS_NUM_THREADS"], labels, file=file)
"""


@pytest.fixture
def kernel(tmp_path, monkeypatch):
    """File of the stand-in, which a service finds in the place of build123d."""
    file = tmp_path / "build123d.py"
    file.write_text(STAND_IN)
    monkeypatch.syspath_prepend(tmp_path)
    return file


async def test_without_the_extra_it_says_what_to_install_and_what_to_ask_instead(api, monkeypatch):
    monkeypatch.setattr(model, "find_spec", lambda name: None)
    answer = await api.post(PATH, json=REQUESTS[PATH])
    assert answer.status_code == 501
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert problem["type"] == "/problems/not-installed"
    (error,) = problem["errors"]
    assert error["code"] == "not_installed"
    assert error["params"] == {"extra": "cad", "instead": "/export/build123d"}
    assert "`cad`" in problem["detail"] and "/export/build123d" in problem["detail"]
    exports = (await api.get("calculations")).json()["exports"]
    assert {each["name"]: each["installed"] for each in exports} == {
        name: name != PATH for name in EXPORTS
    }


async def test_with_it_the_page_learns_so(api, kernel):
    assert EXPORTS[PATH].answered
    exports = (await api.get("calculations")).json()["exports"]
    assert all(each["installed"] for each in exports)


def test_the_script_runs_as_it_is_within_its_memory(kernel):
    """Labels are those that the script gives its parts."""
    body = step.SolidsRequest(**REQUESTS[PATH])
    file = step.write(body)
    assert (file.name, file.media_type) == ("reducer.step", "model/step")
    limit, threads, labels = file.content.decode().split()
    assert (int(limit), threads) == (3 * 2**30, "1")
    pins = ",".join(["ring_pin"] * 20)
    assert labels.startswith(f"satellite_1,satellite_2,housing,{pins},pin,pin,")

    kernel.write_text("import sys\nsys.exit(f'no: {sys.argv}')\n")
    with pytest.raises(subprocess.CalledProcessError):
        step.write(body)
    kernel.write_text("bytearray(4 * 2**30)\n")
    with pytest.raises(subprocess.CalledProcessError):
        step.write(body)


def test_it_is_the_script_that_is_answered(kernel, monkeypatch):
    run = []
    monkeypatch.setattr(subprocess, "run", lambda *given, **named: run.append(named["input"]))
    body = step.SolidsRequest(**REQUESTS[PATH] | {"sizes": "mean"})
    step.write(body)
    assert run == [build123d.write(body).content]
