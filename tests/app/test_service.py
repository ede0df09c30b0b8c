"""What the service says about itself, its pages, and the headers around every answer."""

import hashlib
import json
import os
from pathlib import Path

import httpx
import pytest

from app import VERSION
from app.main import create_app
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


@pytest.mark.parametrize(
    ("root", "path", "status"),
    [
        ("", "/api/v1/cyclogram", 200),
        ("/reducers", "/reducers/api/v1/cyclogram", 200),
        ("/reducers", "/api/v1/cyclogram", 200),
        ("", "/reducers/api/v1/cyclogram", 404),
        ("", "/api/v1/cyclogram/", 307),
        ("", "/api/v1/cyclogram/x", 404),
    ],
)
async def test_calculations_are_found_below_the_root_of_the_service(root, path, status):
    transport = httpx.ASGITransport(create_app(Settings()), root_path=root)
    async with httpx.AsyncClient(transport=transport, base_url=SITE) as client:
        assert (await client.post(path, json=JOB)).status_code == status


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


async def test_every_example_of_the_description_works_as_it_stands(api):
    paths = (await api.get("openapi.json")).json()["paths"]
    asked = 0
    for path, methods in paths.items():
        if "post" in methods:
            example = methods["post"]["requestBody"]["content"]["application/json"]["example"]
            response = await api.post(SITE + path, json=example)
            assert response.status_code == 200, (path, response.text)
            asked += 1
    assert asked >= 18


async def test_other_sites_may_ask_only_where_that_is_set(api):
    page = {"origin": "https://tools.example"}
    asks = page | {
        "access-control-request-method": "POST",
        "access-control-request-headers": "content-type",
    }
    assert (await api.options("cyclogram", headers=asks)).status_code == 405
    assert "access-control-allow-origin" not in (await api.get("health", headers=page)).headers
    allowing = create_app(Settings(cors_origins=("https://tools.example",)))
    transport = httpx.ASGITransport(app=allowing)
    async with httpx.AsyncClient(transport=transport, base_url=f"{SITE}/api/v1/") as other:
        before = await other.options("cyclogram", headers=asks)
        assert before.headers["access-control-allow-origin"] == "https://tools.example"
        answer = await other.post("cyclogram", json=JOB, headers=page)
        assert answer.headers["access-control-allow-origin"] == "https://tools.example"
        assert "x-request-id" in answer.headers["access-control-expose-headers"]
        stranger = await other.post(
            "cyclogram", json=JOB, headers={"origin": "https://bad.example"}
        )
        assert "access-control-allow-origin" not in stranger.headers


async def test_requests_have_an_id_their_own_or_a_new_one(api):
    for own in ("a-b_c.d~1", "x" * 64):
        given = (await api.get("health", headers={"x-request-id": own})).headers
        assert given["x-request-id"] == own
    for bad in ("", "x" * 65, "a b", 'a"b', "é".encode()):
        made = (await api.get("health", headers={"x-request-id": bad})).headers["x-request-id"]
        assert len(made) == 24 and made.isalnum()


async def test_a_service_that_has_not_started_is_alive_but_not_ready(api):
    assert (await api.get(f"{SITE}/livez")).text == "alive"
    starting = await api.get(f"{SITE}/readyz")
    assert starting.status_code == 503 and "retry-after" in starting.headers


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
    monkeypatch.setenv("KHV_MAX_SECONDS", "2.5")
    monkeypatch.setenv("KHV_CORS_ORIGINS", "https://a.example, https://b.example")
    assert Settings.from_environment() == Settings(
        max_body_bytes=10,
        max_seconds=2.5,
        cors_origins=("https://a.example", "https://b.example"),
    )
    monkeypatch.setenv("KHV_PROCESSES", "0")
    assert Settings.from_environment().processes == 0
    for name, text, wrong in (
        ("KHV_MAX_PAIRS", "many", "a number, not 'many'"),
        ("KHV_MAX_SECONDS", "0", "at least 0.001, not 0"),
        ("KHV_MAX_SECONDS", "nan", "at least 0.001, not nan"),
        ("KHV_PROCESSES", "-1", "at least 0, not -1"),
    ):
        with monkeypatch.context() as patched:
            patched.setenv(name, text)
            with pytest.raises(ValueError, match=f"{name} must be {wrong}"):
                Settings.from_environment()


async def test_large_answers_travel_compressed(api):
    plotly = await api.get("http://service/static/vendor/plotly/plotly-basic.min.js")
    assert plotly.headers["content-encoding"] == "gzip" and plotly.headers["etag"]
    small = await api.get("health")
    assert "content-encoding" not in small.headers


async def test_pages_answer_head(api):
    for path in ("/", "/docs"):
        assert (await api.head(f"http://service{path}")).status_code == 200
