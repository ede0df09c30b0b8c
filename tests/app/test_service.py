"""What the service says about itself, its pages, and the headers around every answer."""

import hashlib
import json
import os
from pathlib import Path

import pytest

from app import VERSION
from app.settings import Settings
from app.units import shown_unit

pytestmark = pytest.mark.anyio

SITE = "http://service"
VENDOR = Path(__file__).parent.parent.parent / "static" / "vendor"
JOB = {"pins": 3, "ratio": 20}


async def test_health_gives_the_version(api):
    assert (await api.get("health")).json() == {"status": "ok", "version": VERSION}


@pytest.mark.parametrize("path", ["/", "/docs", "/static/main.js", "/api/v1/health", "/nothing"])
async def test_every_answer_has_the_security_headers(api, path):
    headers = (await api.get(SITE + path)).headers
    policy = headers["content-security-policy"]
    assert policy.startswith("default-src 'none'; script-src 'self'; style-src 'self'")
    assert "unsafe" not in policy
    assert "http" not in policy
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"


async def test_modules_are_revalidated_so_that_an_update_reaches_the_page(api):
    first = await api.get(f"{SITE}/static/main.js")
    assert first.headers["cache-control"] == "no-cache"
    again = await api.get(
        f"{SITE}/static/main.js", headers={"if-none-match": first.headers["etag"]}
    )
    assert again.status_code == 304


async def test_nothing_outside_static_is_served(api):
    for path in ("/static/..%2fapp/main.py", "/static/../pyproject.toml"):
        assert (await api.get(SITE + path)).status_code == 404


async def test_server_timing_gives_the_parts(api):
    response = await api.post("cyclogram", json=JOB)
    parts = dict(part.split(";dur=") for part in response.headers["server-timing"].split(", "))
    assert set(parts) == {"calculation", "total"}
    assert 0 < float(parts["calculation"]) <= float(parts["total"])
    assert "calculation" not in (await api.get("health")).headers["server-timing"]
    assert "server-timing" not in (await api.get(f"{SITE}/")).headers


async def test_the_description_is_served_at_both_places(api):
    assert (await api.get("openapi.json")).json() == (await api.get(f"{SITE}/openapi.json")).json()


async def test_the_pages_ask_no_other_host(api):
    for path in ("/", "/docs"):
        page = await api.get(SITE + path)
        assert page.headers["content-type"].startswith("text/html")
        assert "//" not in page.text.replace("<!--", "")


async def test_the_description_is_enough_for_a_form(api):
    """Each number of a request has a title and, where its name ends in one, its unit."""
    schema = (await api.get("openapi.json")).json()
    models = schema["components"]["schemas"]
    pins = models["CyclogramRequest"]["properties"]["pins"]
    assert pins["title"]
    assert pins["symbol"] == "N"
    assert pins["minimum"] == 1
    for name, model in models.items():
        for field, described in model.get("properties", {}).items():
            assert described.get("unit", "") == shown_unit(field), f"{name}.{field}"


async def test_refusals_are_part_of_the_description(api):
    operation = (await api.get("openapi.json")).json()["paths"]["/api/v1/cyclogram"]["post"]
    assert set(operation["responses"]) == {"200", "413", "422", "503"}
    assert list(operation["responses"]["422"]["content"]) == ["application/problem+json"]


def test_vendored_files_are_the_published_ones():
    packages = json.loads((VENDOR / "manifest.json").read_text())
    expected = {name: digest for package in packages for name, digest in package["files"].items()}
    found = {
        path.relative_to(VENDOR).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in VENDOR.rglob("*")
        if path.is_file() and path.parent != VENDOR
    }
    assert found == expected
    assert all(package["version"] and package["licence"] for package in packages)


def test_the_environment_overrides_the_settings(monkeypatch):
    for name in [name for name in os.environ if name.startswith("KHV_")]:
        monkeypatch.delenv(name)
    assert Settings.from_environment() == Settings()
    monkeypatch.setenv("KHV_MAX_BODY_BYTES", "10")
    assert Settings.from_environment() == Settings(max_body_bytes=10)


async def test_large_answers_travel_compressed(api):
    plotly = await api.get("http://service/static/vendor/plotly/plotly-basic.min.js")
    assert plotly.headers["content-encoding"] == "gzip" and plotly.headers["etag"]
    small = await api.get("health")
    assert "content-encoding" not in small.headers


async def test_pages_answer_head(api):
    for path in ("/", "/docs"):
        assert (await api.head(f"http://service{path}")).status_code == 200
