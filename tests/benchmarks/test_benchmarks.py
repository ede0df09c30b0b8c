"""Every benchmark in its smallest form: it runs to its end, says what it should, writes nothing."""

import os
import runpy
import sys
from pathlib import Path

import pytest

from tests.inputs import chromium
from tests.inputs.children import ran
from tests.running_service import Service

ROOT = Path(__file__).parent.parent.parent
SAYS = {
    "attacks": "left as they are",
    "batches": "more than",
    "catalogue": "rating over it",
    "compare": "0 requests answered otherwise",
    "fit": "fit: 0 misses",
    "frame": "first visit",
    "front": "| shaft deflection |",
    "fuzz": "\n0 failures",
    "honesty": "\nhonest",
    "house": "largest files",
    "load": "stopped (SIGTERM)",
    "mutations": "1 of 1 mutations killed",
    "page": "a frame",
    "peaks": "0 peaks missed",
    "pins": "0 numbers missed",
    "proposals": "| F none | 0 |",
    "ratios": "whole design",
    "service": "parts of a request",
    "sharing": "compiling is not timed",
    "soak": "most processes",
    "speed": "contact line",
    "studies": "beside two studies",
    "studio": "times its rate",
    "stability": "right to their stated error",
    "turns": "\n0 missed",
}
"""What each says last, where all went well."""

ASK = {"attacks", "batches", "frame", "page", "ratios", "soak", "studies"}
"""Those whose matter is not the start of the service: they ask one that runs already."""

CHROMIUM = {"frame", "page"}
"""Those that open the page."""

APART = {"load", "mutations", "service", "sharing"}
"""Those that need a process of their own: they bind it to a processor, raise its limits, or begin
with loops that are not compiled.
"""


def written() -> dict[Path, float]:
    """When each report was written."""
    return {file: file.stat().st_mtime for file in (ROOT / "docs").iterdir()}


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.browser) if name in CHROMIUM else name for name in SAYS],
)
@pytest.mark.filterwarnings("ignore:.*found in sys.modules:RuntimeWarning")  # of another one
def test_a_benchmark_runs_in_its_smallest_form(
    name: str,
    request: pytest.FixtureRequest,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    if name in CHROMIUM and not chromium.path():
        assert not os.environ.get("CI"), "no Chromium"
        pytest.skip("no Chromium on this machine")
    before, command = written(), [f"benchmarks.{name}", "--smallest"]
    monkeypatch.setenv("PYTHONPATH", ".")
    monkeypatch.chdir(ROOT)
    if name in ASK:
        served: Service = request.getfixturevalue("served")
        command += ["--service", str(served.process.pid), str(served.port)]
    if name in APART:
        pipes = {"stdout": None, "stderr": None}
        code: object = ran(sys.executable, "-m", *command, check=False, **pipes).returncode
    else:
        code = ran_here(command, monkeypatch)
    said = capfd.readouterr()
    assert not code, said
    assert SAYS[name] in said.out
    assert written() == before


def ran_here(command: list[str], monkeypatch: pytest.MonkeyPatch) -> object:
    """Exit value of a module run as main in this process, which has imported most of its needs."""
    monkeypatch.setattr(sys, "argv", command)
    try:
        runpy.run_module(command[0], run_name="__main__", alter_sys=True)
    except SystemExit as ended:
        return ended.code
    return 0


def test_every_benchmark_is_run() -> None:
    commands = (ROOT / "benchmarks").glob("*.py")
    assert {file.stem for file in commands if "__main__" in file.read_text()} == set(SAYS)
