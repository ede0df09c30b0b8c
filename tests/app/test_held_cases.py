"""Cases of exact geometry as they are posted, with numbers of other programs: output pins, cycloid
discs on the pins of their ring, both in series.
"""

import json
from pathlib import Path

import pytest

from tests.oracles.held import close

pytestmark = pytest.mark.anyio

FOLDER = Path(__file__).parents[1] / "oracles"
CASES = [
    pytest.param(path, case, id=f"{path} {case['name'].split()[0]}")
    for path, name in (
        ("load-sharing", "load_sharing_cases"),
        ("load-sharing", "series_cases"),
        ("ring-mesh", "cycloid_mesh_cases"),
    )
    for case in json.loads((FOLDER / f"{name}.json").read_text())
    if "geometry" not in case["body"] and not case["name"].startswith("S13 ")
]


@pytest.mark.parametrize(("path", "case"), CASES)
async def test_case(api, path, case):
    answer = await api.answer(path, case["body"])
    close(answer, case["expect"])
    besides = {"kind", "geometry"} if path == "ring-mesh" else {"fit"}
    told = {"accuracy", "warnings", "assumed"} | besides
    assert set(answer) - told == {*case["body"]["include"]}
