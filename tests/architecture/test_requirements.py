"""The pinned requirements belong to pyproject.toml: `make requirements` after each change there."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def pinned(name):
    """Version and number of hashes of each package of a requirements file."""
    text = (ROOT / "requirements" / f"{name}.txt").read_text().replace("\\\n", "")
    packages = {}
    for line in text.splitlines():
        found = re.fullmatch(
            r"([a-z0-9.-]+)==(\S+?)(?: ;.*?)?((?: +--hash=sha256:[0-9a-f]{64})+) *", line
        )
        assert found, line
        packages[found[1]] = found[2], found[3].count("--hash")
    return packages


def asked(requirements):
    """Name and version of requirements; every one names its version."""
    pairs = [each.split("==") for each in requirements]
    return {name.lower().replace("_", "-"): version for name, version in pairs}


def test_every_requirement_is_pinned_with_a_hash():
    run, test = pinned("run"), pinned("test")
    for packages, requirements in (
        (run, PROJECT["dependencies"]),
        (test, PROJECT["dependencies"] + PROJECT["optional-dependencies"]["test"]),
    ):
        for name, version in asked(requirements).items():
            assert packages[name][0] == version, f"{name}: run make requirements"
    assert all(hashes for _, hashes in (run | test).values())
    assert run.items() <= test.items()
    assert "pytest" not in run


def test_no_registry_is_written_down():
    for file in (ROOT / "requirements").iterdir():
        assert "://" not in file.read_text()
