"""Every refusal has one shape, names the field in plain words and never echoes the input."""

import re
import tracemalloc

import httpx
import pytest

from app.examples import REQUESTS
from app.main import create_app
from app.model import MAX_NAME, UNION_TAGS, pointer
from app.problems import TEXTS
from app.settings import Settings
from core.codes import WARNINGS
from core.precision import CONVERGED

pytestmark = pytest.mark.anyio

JSON = {"content-type": "application/json"}
SHAPE = {"type", "title", "status", "detail", "errors"}


@pytest.fixture
async def small():
    """Client of a service that takes 1000 bytes and has an endpoint that fails."""
    app = create_app(Settings(max_body_bytes=1000))

    @app.get("/api/v1/failing")
    async def failing() -> None:
        raise RuntimeError("a secret")

    transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as client:
        yield client


def refused(response: httpx.Response, status: int) -> list[tuple[str, str]]:
    """Pointers and details of a refusal whose shape is right."""
    problem = response.json()
    assert response.status_code == problem["status"] == status
    assert response.headers["content-type"] == "application/problem+json"
    assert set(problem) - {"where", "more"} == SHAPE
    assert problem["type"].startswith("/problems/")
    assert problem["title"]
    assert problem["detail"]
    return [(each["pointer"], each["detail"]) for each in problem["errors"]]


@pytest.mark.parametrize(
    ("body", "pointer", "detail"),
    [
        ('{"pins": 0, "ratio": 2}', "/pins", "must be at least 1"),
        ('{"pins": 3, "ratio": 2, "revolutions": 0}', "/revolutions", "must be greater than 0"),
        ('{"pins": 2.5, "ratio": 2}', "/pins", "must be a whole number"),
        ('{"pins": "5", "ratio": 2}', "/pins", "must be a whole number"),
        ('{"pins": 3, "ratio": "5"}', "/ratio", "must be a number"),
        ('{"pins": 3, "ratio": true}', "/ratio", "must be a number"),
        ('{"pins": 3, "ratio": 1e999}', "/ratio", "must be a finite number"),
        ('{"pins": 3, "ratio": NaN}', "/ratio", "must be a finite number"),
        ('{"ratio": 2}', "/pins", "is needed"),
        ('{"pins": 3, "ratio": 2, "a~b/c": 1}', "/a~0b~1c", "is not a known field"),
        ('{"pins": 3, "ratio": 2, "crank_angles_deg": 5}', "/crank_angles_deg", "must be a list"),
        ('{"pins": 3, "ratio": 2, "revolutions": 1e7}', "/revolutions", "must be at most 1000000"),
        (
            '{"pins": 3, ',
            "",
            "is not valid JSON: EOF while parsing a value at line 1 column 12",
        ),
        ("[1]", "", "must be an object"),
        ("", "", "is not valid JSON: EOF while parsing a value at line 1 column 0"),
    ],
)
async def test_a_wrong_field_is_named_in_plain_words(api, body, pointer, detail):
    response = await api.post("cyclogram", content=body, headers=JSON)
    assert refused(response, 422) == [(pointer, detail)]


CYCLOID = {
    "mechanism": {"pins": 6, "satellites": 2, "satellite_teeth": 19, "ring_teeth": 20},
    "load": {"output_torque_Nm": 5.28, "pin_circle_radius_mm": 22},
    "contact": {
        "contact_length_mm": 8,
        "pin_radius_mm": 3,
        "hole_radius_mm": 5,
        "eccentricity_mm": 2,
    },
    "gear": {"kind": "cycloid", "ring_pin_circle_radius_mm": 40, "ring_pin_radius_mm": 2.5},
}


@pytest.mark.parametrize(
    ("path", "body", "pointer", "limit"),
    [
        ("crank-planetary", CYCLOID, "/gear/ring_pin_circle_radius_mm", 40),
        (
            "hertz",
            {"force_N": 1, "contact_length_mm": 1, "pin_radius_mm": 8, "hole_radius_mm": 8},
            "/hole_radius_mm",
            8,
        ),
        ("cyclogram", {"pins": 3, "satellite_teeth": 20, "ring_teeth": 20}, "/ring_teeth", 20),
        (
            "solve",
            {
                "calculation": "hertz",
                "input": REQUESTS["hertz"],
                "variable": {"pointer": "/force_N", "from": 5.5, "to": 5.5},
                "target": {"pointer": "/max_pressure_MPa", "equals": 1},
            },
            "/variable/to",
            5.5,
        ),
    ],
)
async def test_a_limit_is_said_with_its_number_in_the_unit_of_the_field(
    api, path, body, pointer, limit
):
    response = await api.post(path, json=body)
    (error,) = response.json()["errors"]
    assert error["pointer"] == pointer
    assert error["params"]["limit"] == pytest.approx(limit, rel=CONVERGED)
    assert f"{limit:g}" in error["detail"]


def test_no_limit_is_said_in_words_alone():
    """Refusals and warnings that compare state a number; two typed diameters are no limit."""
    compares = re.compile(r"(must be|is) (at (most|least)|(larger|smaller|greater|less)\b)")
    number = re.compile(r"{(limit|error|ratio|share|value)[:}]|\d|a (tenth|half|right angle)")
    texts = TEXTS | {code: kind.text for code, kind in WARNINGS.items()}
    compared = {code for code, text in texts.items() if compares.search(text)}
    assert len(compared) > 20
    assert {code for code in compared if not number.search(texts[code])} == {"sphere_below_roller"}


@pytest.mark.parametrize("name", sorted(UNION_TAGS))
async def test_an_unknown_field_may_have_any_name(api, name):
    response = await api.post("cyclogram", json={"pins": 6, "ratio": 20, name: {}})
    assert refused(response, 422) == [(f"/{name}", "is not a known field")]


async def test_several_wrong_fields_are_all_named(api):
    response = await api.post("cyclogram", json={"pins": 0, "ratio": "x", "color": "red"})
    assert {pointer for pointer, _ in refused(response, 422)} == {"/pins", "/ratio", "/color"}


@pytest.mark.parametrize(
    ("wrong", "named"), [(49, 49), (50, 50), (51, 50), (999, 50), (1001, 0), (20_000, 0)]
)
async def test_so_many_wrong_fields_are_named_and_the_rest_counted(api, wrong, named):
    body = {"pins": 3, "ratio": 20} | {f"f{n}": 0 for n in range(wrong)}
    response = await api.post("cyclogram", json=body)
    errors = refused(response, 422)
    assert errors == [(f"/f{n}", "is not a known field") for n in range(named)]
    problem = response.json()
    assert problem.get("more", 0) == wrong - named
    if wrong == 51:
        assert problem["detail"].endswith("f49 is not a known field; 1 more")
    if not named:
        assert problem["detail"] == f"{wrong} fields are wrong"


async def test_long_names_are_cut(api):
    body = {"pins": 3, "ratio": 20, "x" * 64: 0, "y" * 65: 0}
    response = await api.post("cyclogram", json=body)
    pointers = [pointer for pointer, _ in refused(response, 422)]
    assert pointers == ["/" + "x" * 64, "/" + "y" * 63 + "…"]
    assert "y" * 64 not in response.text


async def test_a_body_that_is_not_sent_as_json_is_refused_with_the_reason(api):
    response = await api.post("cyclogram", data={"pins": 3})
    assert refused(response, 415) == []
    packed = {**JSON, "content-encoding": "gzip"}
    response = await api.post("cyclogram", content=b"{}", headers=packed)
    assert refused(response, 415) == []


@pytest.mark.parametrize("value", ['"<script>secret"', "[123454321]", '{"secret": 1}'])
async def test_the_input_is_not_echoed(api, value):
    response = await api.post("cyclogram", content=f'{{"pins": 3, "ratio": {value}}}', headers=JSON)
    assert refused(response, 422) == [("/ratio", "must be a number")]
    assert "secret" not in response.text
    assert "123454321" not in response.text


@pytest.mark.parametrize("content", [b"\xff\xfe", b'{"\\ud800": 1}', b"[" * 200_000, b"\x00"])
async def test_garbage_is_the_senders_error(api, content):
    response = await api.post("cyclogram", content=content, headers=JSON)
    assert [pointer for pointer, _ in refused(response, 422)] in ([""], ["/\\ud800"])


async def test_an_impossible_mechanism_says_where(api):
    body = {
        "pins": 2,
        "satellites": 1,
        "ratio": 20,
        "output_torque_Nm": 50,
        "pin_circle_radius_mm": 50,
    }
    response = await api.post("contact-force", json=body)
    ((pointer, _),) = refused(response, 422)
    assert pointer == ""
    assert response.json()["errors"][0]["code"] == "dead_centre"
    assert response.json()["type"] == "/problems/impossible-mechanism"
    assert set(response.json()["where"]) == {"crank_angle_deg"}


@pytest.mark.parametrize(
    ("method", "path", "status"), [("GET", "nothing", 404), ("GET", "cyclogram", 405)]
)
async def test_wrong_paths_and_methods_are_problems(api, method, path, status):
    assert refused(await api.request(method, path), status) == []


async def test_a_body_above_the_limit_is_too_large_announced_or_not(small):
    async def chunks():
        for _ in range(30):
            yield b" " * 100

    for content in (b" " * 3000, chunks()):
        response = await small.post("cyclogram", content=content, headers=JSON)
        assert refused(response, 413) == []
        assert response.json()["type"] == "/problems/too-large"


async def test_a_body_below_the_limit_passes(small):
    body = '{"pins": 3, "ratio": 20}'.ljust(1000)
    assert (await small.post("cyclogram", content=body, headers=JSON)).status_code == 200


async def test_a_failure_of_the_service_tells_nothing_about_itself(small):
    response = await small.get("failing")
    assert refused(response, 500) == []
    assert "secret" not in response.text
    assert response.headers["x-content-type-options"] == "nosniff"


def test_long_names_are_cut_before_they_are_kept():
    """1,000 of 100 kB, each another one, leave next to nothing behind."""
    tracemalloc.start()
    try:
        for number in range(1000):
            assert len(pointer([f"{number}{'~' * 100_000}"])) < 2 * MAX_NAME
        kept, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert kept < 1_000_000
