"""Every benchmark in its smallest form: it runs to its end, says what it should, writes nothing."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.inputs import chromium

ROOT = Path(__file__).parent.parent.parent
SAYS = {
    "attacks": "left as they are",
    "batches": "more than",
    "catalogue": "rating over it",
    "compare": "0 requests answered otherwise",
    "fit": "fit: 0 misses",
    "front": "| shaft deflection |",
    "fuzz": "\n0 failures",
    "honesty": "\nhonest",
    "house": "largest files",
    "load": "stopped (SIGTERM)",
    "mutations": "1 of 1 mutations killed",
    "page": "a frame",
    "peaks": "0 peaks missed",
    "pins": "0 numbers missed",
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


def written() -> dict[Path, float]:
    """When each report was written."""
    return {file: file.stat().st_mtime for file in (ROOT / "docs").iterdir()}


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.browser) if name == "page" else name for name in SAYS],
)
def test_a_benchmark_runs_in_its_smallest_form(name: str) -> None:
    if name == "page" and not chromium.path():
        assert not os.environ.get("CI"), "no Chromium"
        pytest.skip("no Chromium on this machine")
    before = written()
    done = subprocess.run(
        [sys.executable, "-m", f"benchmarks.{name}", "--smallest"],
        cwd=ROOT,
        env=os.environ | {"PYTHONPATH": "."},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert SAYS[name] in done.stdout
    assert written() == before


def test_every_benchmark_is_run() -> None:
    commands = (ROOT / "benchmarks").glob("*.py")
    assert {file.stem for file in commands if "__main__" in file.read_text()} == set(SAYS)
