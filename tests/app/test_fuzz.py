"""A part of `make fuzz` with a fixed seed: designs, hostile numbers and broken bodies."""

import pytest

pytestmark = pytest.mark.anyio

HERTZ = {"force_N": 5000, "contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}


@pytest.fixture(scope="module")
def fuzz():
    from tests.inputs.fuzz import Fuzz  # the service is described there: not by who only collects

    return Fuzz()


async def test_nothing_breaks_the_service(fuzz):
    report = await fuzz.run(requests=120, seed=0)
    assert report.failures == []
    assert {status for _, status in report.answers} == {200, 413, 415, 422}


@pytest.mark.parametrize(
    ("body", "before", "after"),
    [
        (HERTZ, b'"mean_pressure_MPa":', b'"mean_pressure_MPa":NaN,"x":'),
        (HERTZ, b'"mean_pressure_MPa":', b'"mean_pressure_MPa":null,"x":'),
        (HERTZ | {"force_N": -1}, b"/force_N", b"/force"),
        (HERTZ | {"force_N": -1}, b"/problems/invalid", b"/problems/unknown"),
    ],
)
async def test_the_fuzz_sees_what_is_wrong(fuzz, monkeypatch, body, before, after):
    from tests.inputs.fuzz_requests import Request

    await fuzz.check(Request("hertz", body))
    send = fuzz.send

    async def tampered(request):
        status, headers, content = await send(request)
        assert before in content
        return status, headers, content.replace(before, after)

    monkeypatch.setattr(fuzz, "send", tampered)
    with pytest.raises((AssertionError, ValueError, KeyError)):
        await fuzz.check(Request("hertz", body))
