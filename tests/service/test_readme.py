"""The Python client of the README, run as it stands against a running service."""

import re
import subprocess
import sys
from pathlib import Path

import httpx
import pytest

README = Path(__file__).parent.parent.parent / "README.md"


@pytest.fixture(scope="module")
def client():
    (block,) = re.findall(r"```python\n(.*?)```", README.read_text(), re.DOTALL)
    return block


def test_the_client_gets_the_numbers_of_the_api(service, client):
    names = {"__name__": "client"}
    exec(compile(client, "README.md", "exec"), names)
    calculator = names["Calculator"](service.url)
    try:
        contact = calculator.contact(pins=3, output_torque_Nm=500, pin_radius_mm=8)
        hertz = httpx.post(
            f"{service.url}/api/v1/hertz",
            json={
                "force_N": contact.peak_force_N,
                "contact_length_mm": 20,
                "pin_radius_mm": 8,
                "hole_radius_mm": 10,
            },
        ).json()
        assert contact.peak_force_N == pytest.approx(20_000 / 3, rel=1e-12)
        assert contact.max_pressure_MPa == pytest.approx(hertz["max_pressure_MPa"], rel=1e-12)
        with pytest.raises(names["Refused"], match="pins must be at least 1"):
            calculator.contact(pins=0, output_torque_Nm=500, pin_radius_mm=8)
    finally:
        calculator.http.close()


def test_the_client_has_the_types_it_says(client, tmp_path):
    file = tmp_path / "client.py"
    file.write_text(client)
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--config-file=", str(file)],
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout
