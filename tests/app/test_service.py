"""Information about the service, its pages, and the headers of every answer."""

import hashlib
import json
import logging
import os
import re
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path

import httpx
import orjson
import pytest

from app import VERSION, main, observability, sources
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import EXAMPLES, REQUESTS
from app.main import create_app
from app.problems import KINDS
from app.settings import Settings
from app.units import shown_unit
from tests.inputs.children import ran

pytestmark = pytest.mark.anyio

SITE = "http://service"
VENDOR = Path(__file__).parent.parent.parent / "static" / "vendor"
JOB = {"pins": 3, "ratio": 20}


def test_examples_cite_the_sources_of_the_calculations():
    known = [each for name, each in vars(sources).items() if name.isupper()]
    for example in EXAMPLES:
        assert example["source"].startswith((*known, "docs/")), example["id"]


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
        ("", "/api/v1/cyclogram/", 404),
        ("/reducers", "/reducersapi/v1/cyclogram", 404),
        ("", "/api/v1/cyclogram/x", 404),
    ],
)
async def test_calculations_are_found_below_the_root_of_the_service(root, path, status):
    transport = httpx.ASGITransport(create_app(Settings(root_path=root)))
    async with httpx.AsyncClient(transport=transport, base_url=SITE) as client:
        assert (await client.post(path, json=JOB)).status_code == status


@pytest.mark.slow
async def test_what_the_service_says_of_its_addresses_has_its_prefix():
    transport = httpx.ASGITransport(create_app(Settings(root_path="/reducers")))
    async with httpx.AsyncClient(transport=transport, base_url=f"{SITE}/reducers/") as client:
        page = await client.get("")
        named = re.findall(r'(?:href|src)="([^"#]+)"', page.text)
        assert len(named) > 40
        for path in [*named, "docs", "static/lib/api.js"]:
            assert (await client.get(path)).status_code == 200, path
        description = (await client.get("api/v1/openapi.json")).json()
        assert description["servers"] == [{"url": "/reducers"}]
        for each in (await client.get("api/v1/calculations")).json()["calculations"]:
            assert (await client.post(SITE + each["path"], json={})).status_code == 422
        refused = (await client.post("api/v1/cyclogram", json={})).json()
        assert (await client.get(SITE + refused["type"])).json()["type"] == refused["type"]


async def test_no_answer_repeats_the_host_that_a_client_names(api):
    headers = {"host": "evil.example", "content-type": "application/json"}
    for path in ("/api/v1/hertz/", "/docs/", "/static", "/"):
        answer = await api.get(SITE + path, headers=headers)
        assert "location" not in answer.headers and "evil" not in answer.text


async def test_the_whole_design_leaves_out_what_none_of_its_sections_counts(api):
    listed = (await api.get("calculations")).json()["calculations"]
    told = {each["name"]: each for each in listed}
    left_out = {name: {one["code"] for one in each["model"]} for name, each in told.items()}
    whole = left_out["crank-planetary"]
    counted = {  # and by which section
        "clearance": "contact", "deviations": "deviations", "equal_discs": "satellite_coupling",
        "pin_bending": "pin", "misalignment": "pin", "friction": "friction", "elasticity": "pin",
        "bearing_elasticity": "crank_support",
    }  # fmt: skip
    sections = ("cyclogram", "contact-force", "load-sharing", "hertz", "pin-strength")
    sections += ("output-efficiency", "satellite-bearing", "crankshaft")
    of_sections = set().union(*(left_out[name] for name in sections))
    # the tilt but for the slope of bent pins, and what has no section
    assert whole - of_sections == {"tilt", "body_strength"}
    assert of_sections - whole == {*counted}
    assert {*counted.values()} <= {*CrankPlanetaryRequest.model_fields}
    sources = {source for name in sections for source in told[name]["sources"]}
    assert sources < {*told["crank-planetary"]["sources"]}


async def test_head_is_answered_wherever_get_is(api):
    for path in ("/", "/docs", "/livez", "/metrics", "/api/v1/health", "/api/v1/openapi.json"):
        head = await api.head(SITE + path)
        assert (head.status_code, head.content) == (200, b"")
    assert (await api.head("hertz")).status_code == 405


async def test_tags_are_those_of_the_content_and_heeded(api, tmp_path, monkeypatch):
    copied = tmp_path / "static"
    shutil.copytree(main.STATIC, copied, ignore=shutil.ignore_patterns("vendor"))
    for file in copied.rglob("*"):
        os.utime(file, (1, 1))
    monkeypatch.setattr(main, "STATIC", copied)
    replica = httpx.ASGITransport(create_app(Settings()))
    async with httpx.AsyncClient(transport=replica) as other:
        for path in ("/", "/docs", "/static/main.js", "/openapi.json", "/api/v1/words"):
            first, second = await api.get(SITE + path), await other.get(SITE + path)
            tag = first.headers["etag"]
            assert second.headers["etag"] == tag and tag.startswith('W/"')
            again = await other.get(SITE + path, headers={"if-none-match": f'"x", {tag}'})
            assert (again.status_code, again.content) == (304, b"")
            assert "last-modified" not in first.headers


async def test_every_kind_of_problem_opens(api):
    source = "".join(file.read_text() for file in Path("app").glob("*.py"))
    kinds = {*re.findall(r'Problem\(\s*"([a-z-]+)"', source), "not-found"}
    assert kinds <= {*KINDS} and len(kinds) > 7
    for kind in KINDS:
        opened = await api.get(f"{SITE}/problems/{kind}")
        assert opened.json() == {"type": f"/problems/{kind}", "description": KINDS[kind][1]}
    assert (await api.get(f"{SITE}/problems/unknown")).status_code == 404


async def test_every_answer_says_which_build_it_is_of():
    transport = httpx.ASGITransport(create_app(Settings(build="abc1")))
    async with httpx.AsyncClient(transport=transport, base_url=SITE) as client:
        assert (await client.get("/livez")).headers["server"] == f"khv-calc/{VERSION}+abc1"
        assert (
            f'khv_build_info{{build="",version="{VERSION}"}} 1.0'
            in (await client.get("/metrics")).text
        )


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
    """Each number of a request has a title, a help, a group and, where its name ends in one, its
    unit.
    """
    schema = (await api.get("openapi.json")).json()
    models = schema["components"]["schemas"]
    pins = models["CyclogramRequest"]["properties"]["pins"]
    assert pins["title"]
    assert pins["x-symbol"] == "N"
    assert pins["minimum"] == 1
    for name, model in models.items():
        for field, described in model.get("properties", {}).items():
            assert described.get("x-unit", "") == shown_unit(field), f"{name}.{field}"
            if "x-group" in described:
                assert described["title"] and described["description"], f"{name}.{field}"


async def test_the_values_of_each_choice_have_names_of_their_own_in_generated_clients(api):
    """Clients that ignore case would turn both `f7` and `F7` into F7."""

    def choices(schema):
        if isinstance(schema, dict):
            if isinstance(schema.get("enum"), list):
                yield schema
            schema = [*schema.values()]
        if isinstance(schema, list):
            for inner in schema:
                yield from choices(inner)

    found = [*choices((await api.get("/openapi.json")).json())]
    assert len(found) > 20
    for each in found:
        names = each.get("x-enum-varnames", each["enum"])
        assert len(names) == len(each["enum"]) == len({str(name).upper() for name in names})


async def test_every_input_says_what_it_is(api):
    """A field that is a section has the description of the section."""
    schema = (await api.get("openapi.json")).json()
    models = schema["components"]["schemas"]
    bodies = [
        operation["post"]["requestBody"]["content"]["application/json"]["schema"]
        for operation in schema["paths"].values()
        if "post" in operation
    ]
    reached: set[str] = set()
    rest = re.findall(r"schemas/(\w+)", json.dumps(bodies))
    while rest:
        if (name := rest.pop()) not in reached:
            reached.add(name)
            rest += re.findall(r"schemas/(\w+)", json.dumps(models[name]))
    fields = [
        (name, field, described)
        for name in reached
        for field, described in models[name].get("properties", {}).items()
        if "$ref" not in described
    ]
    assert len(fields) > 200
    assert [(name, field) for name, field, each in fields if not each.get("description")] == []


@pytest.mark.slow
def test_another_process_describes_alike_and_loads_nothing_that_may_not_be_asked_for():
    """Whatever the seed of hashes, which the order of a set hangs on; as do those that calculate,
    it loads no library that few requests need.
    """
    heavy = "'mpmath', 'plotly', 'ezdxf', 'xlsxwriter', 'fontTools'"
    code = (
        f"import sys, app.main, app.loaded; print([m for m in ({heavy}) if m in sys.modules]);"
        "import orjson; print(orjson.dumps(app.main.app.openapi()))"
    )
    loaded, there = ran(
        sys.executable, "-c", code, env={**os.environ, "PYTHONHASHSEED": "4"}
    ).stdout.splitlines()
    assert loaded == "[]"
    assert there == repr(orjson.dumps(create_app().openapi()))


async def test_refusals_are_part_of_the_description(api):
    operation = (await api.get("openapi.json")).json()["paths"]["/api/v1/cyclogram"]["post"]
    assert set(operation["responses"]) == {"200", "413", "415", "422", "503"}
    assert list(operation["responses"]["422"]["content"]) == ["application/problem+json"]


@pytest.mark.slow
async def test_every_example_of_the_description_works_as_it_stands(api):
    paths = (await api.get("openapi.json")).json()["paths"]
    asked = 0
    for path, methods in paths.items():
        if "post" in methods:
            example = methods["post"]["requestBody"]["content"]["application/json"]["example"]
            response = await api.post(SITE + path, json=example)
            solids = path.endswith("/export/step") and not find_spec("build123d")
            assert response.status_code == (501 if solids else 200), (path, response.text)
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


WRAPPER = (
    """(
 function(root, factory) {
  if (typeof module === "object" && module.exports) {
   module.exports = factory();
  } else {
   root.moduleName = factory();
  }
} (typeof self !== "undefined" ? self : this, () => {
""",
    """
window.Plotly = Plotly;
return Plotly;
}));""",
)
"""What the published Plotly.js has around its code."""


def published(path: Path) -> bytes:
    """A vendored file as its package has it: see `static/vendor/README.md` for what is left out."""
    if path.name != "plotly-basic.min.js":
        return path.read_bytes()
    hint, *licence, code = path.read_bytes().decode().split("\n", 7)
    assert hint == "//# allFunctionsCalledOnLoad"
    return "\n".join([*licence, WRAPPER[0] + code + WRAPPER[1]]).encode()


def test_vendored_files_are_the_published_ones():
    packages = json.loads((VENDOR / "manifest.json").read_text())
    expected = {name: digest for package in packages for name, digest in package["files"].items()}
    found = {
        path.relative_to(VENDOR).as_posix(): hashlib.sha256(published(path)).hexdigest()
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
    monkeypatch.setenv("KHV_MAX_PAIRS", "")
    assert Settings.from_environment().max_pairs == 10_000
    for name, text in WRONG:
        with monkeypatch.context() as patched:
            patched.setenv(f"KHV_{name}", text)
            with pytest.raises(ValueError, match=f"^KHV_{name}[^\n]*$"):
                Settings.from_environment()


WRONG = [
    ("MAX_BODY_BYTES", "-1"),
    ("MAX_BODY_BYTES", "abc"),
    ("PROCESSES", "-1"),
    ("MAX_SECONDS", "nan"),
    ("MAX_SECONDS", "0"),
    ("MAX_CONNECTIONS", "0"),
    ("MAX_PAIRS", "999999"),
    ("MAX_CURVE_SAMPLES", "10002"),
    ("KEEP_ALIVE_SECONDS", "2.5"),
    ("LOG_LEVEL", "foo"),
    ("PORT", "99999"),
    ("WORKERS", "0"),
    ("ROOT_PATH", "reducers/"),
    ("CORS_ORIGINS", "https://a.example/x"),
    ("TRUSTED_PROXIES", "10.0.0.0/99"),
    ("BUILD", "a b"),
    ("MAX_BODY_BYTE", "5"),
]
"""Settings that cannot be, and one that is not there."""


async def test_large_answers_travel_compressed(api):
    plotly = await api.get("http://service/static/vendor/plotly/plotly-basic.min.js")
    assert plotly.headers["content-encoding"] == "gzip" and plotly.headers["etag"]
    small = await api.get("health")
    assert "content-encoding" not in small.headers
    for path in ("materials", "examples", "calculations", "words", "http://service/metrics"):
        plain = await api.get(path, headers={"accept-encoding": "identity"})
        packed = await api.get(path, headers={"accept-encoding": "gzip"})
        assert packed.headers["content-encoding"] == "gzip"
        assert "content-encoding" not in plain.headers
        assert {each.headers["vary"].lower() for each in (plain, packed)} == {"accept-encoding"}
        assert int(packed.headers["content-length"]) < len(plain.content) / 1.5


async def test_nothing_is_compressed_for_who_does_not_take_that(api):
    batch = {"calculation": "hertz", "requests": [REQUESTS["hertz"]] * 20}
    for refused in ("gzip;q=0", "br, gzip ; q=0.0", "gzip;q=0, br"):
        headers = {"accept-encoding": refused}
        for path in ("materials", "http://service/static/main.js"):
            assert "content-encoding" not in (await api.get(path, headers=headers)).headers
        for path, body in (("batch", batch), ("hertz/chart", REQUESTS["hertz"])):
            answer = await api.post(path, json=body, headers=headers)
            assert "content-encoding" not in answer.headers
    taken = await api.get("materials", headers={"accept-encoding": "gzip;q=0.5"})
    assert taken.headers["content-encoding"] == "gzip"


async def test_the_line_of_a_request_suits_every_formatter(api):
    """The record has all attributes that `logging` promises, not only those of our format."""
    lines = []

    class Lines(logging.Handler):
        def emit(self, record):
            lines.append(self.format(record))

    handler = Lines()
    handler.setFormatter(logging.Formatter("%(pathname)s %(lineno)d %(msecs)d %(levelname)s"))
    log = logging.getLogger("khv.request")
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        await api.get("health")
    finally:
        log.removeHandler(handler)
        log.setLevel(logging.NOTSET)
    (line,) = lines
    assert line.startswith(observability.__file__) and line.endswith("INFO")
