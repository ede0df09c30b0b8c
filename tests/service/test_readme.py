"""Examples of the README against a running service, with equal results."""

import json
import re
import shutil
import sys
from pathlib import Path

import httpx
import pytest
from khv_calc import Client, Refused

from tests.inputs.children import ran

ROOT = Path(__file__).parent.parent.parent
README = (ROOT / "README.md").read_text()
CLIENTS = str(ROOT / "clients" / "python")
ADDRESS = "http://127.0.0.1:8000"

BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.DOTALL | re.MULTILINE)


@pytest.fixture(scope="module")
def direct():
    """No proxy on the way to this machine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NO_PROXY", "127.0.0.1")
        patch.setenv("PYTHONPATH", CLIENTS)
        patch.setenv("MYPYPATH", CLIENTS)
        yield


def block(language):
    (text,) = (text for name, text in BLOCKS if name == language)
    return text


def part_of(answer, shown):
    """Shown fields of an answer, numbers to four digits."""
    if isinstance(shown, dict):
        return {name: part_of(answer[name], value) for name, value in shown.items()}
    return float(f"{answer:.4g}") if isinstance(answer, float) else answer


def output(*command):
    return ran(*command).stdout


def test_the_python_example_prints_what_stands_there(service, direct):
    assert ADDRESS in block("python")
    example = block("python").replace(ADDRESS, service.url)
    assert output(sys.executable, "-c", example) == block("text")


def test_the_python_example_has_the_types_it_says(direct):
    output(sys.executable, "-m", "mypy", "--strict", "--config-file=", "-c", block("python"))


@pytest.mark.skipif(not shutil.which("curl"), reason="needs curl")
def test_the_curl_example_answers_what_stands_there(service, direct):
    assert ADDRESS in block("sh")
    answer = json.loads(output("sh", "-c", block("sh").replace(ADDRESS, service.url)))
    shown = json.loads(block("json"))
    assert part_of(answer, shown) == shown


def test_the_refusal_of_the_api_document_is_what_is_sent(service):
    text = (ROOT / "docs" / "api.md").read_text()
    (shown,) = re.findall(r"^```json\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    body = {"pins": 0, "ratio": 20, "output_torque_Nm": 500, "pin_circle_radius_mm": 50}
    transport = httpx.HTTPTransport()
    with Client(service.url, transport=transport) as calc, pytest.raises(Refused) as caught:
        calc.ask("contact-force", body)
    assert caught.value.problem == json.loads(shown)
