"""The pinned requirements belong to pyproject.toml: `make requirements` after each change there."""

import ast
import re
import sys
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
    run, dask, test = pinned("run"), pinned("dask"), pinned("test")
    extras = PROJECT["optional-dependencies"]
    for packages, requirements in (
        (run, PROJECT["dependencies"]),
        (dask, PROJECT["dependencies"] + extras["dask"]),
        (test, PROJECT["dependencies"] + extras["test"]),
    ):
        for name, version in asked(requirements).items():
            assert packages[name][0] == version, f"{name}: run make requirements"
    assert all(hashes for _, hashes in (run | dask | test).values())
    assert run.items() <= dask.items() <= test.items()
    assert "pytest" not in run


def test_no_registry_is_written_down():
    for file in (ROOT / "requirements").iterdir():
        assert "://" not in file.read_text()


def imported(source):
    """Top-level packages that a source imports."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (each.name.split(".")[0] for each in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module.split(".")[0]


def test_what_the_service_imports_is_installed_with_it():
    files = (*ROOT.glob("app/**/*.py"), *ROOT.glob("core/**/*.py"))
    names = {name for file in files for name in imported(file.read_text())}
    packages, dask, pdf = (
        {name.replace("-", "_") for name in pinned(of)} for of in ("run", "dask", "pdf")
    )
    extra = {"dask", "distributed", "weasyprint"}
    assert "fastapi" in names
    own = {"app", "core"}
    assert names - packages - set(sys.stdlib_module_names) - own == extra
    assert {"dask", "distributed"} <= dask and "weasyprint" in pdf
    assert "plotly" not in packages


def test_the_image_may_copy_what_it_copies():
    text = (ROOT / "Dockerfile").read_text().replace("${REQUIREMENTS}", "run")
    copied = re.findall(r"^COPY (?!--)(\S+) ", text, re.MULTILINE)
    let_in = (ROOT / ".dockerignore").read_text().split()
    assert "LICENSE" in copied
    assert {f"!{path.split('/')[0]}" for path in copied} == set(let_in) - {"*", "**/__pycache__"}
    assert all((ROOT / path).exists() for path in copied)
