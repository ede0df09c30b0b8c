"""The compiled engine: its cache is made once, read where turns are calculated, and mended."""

import os
import shutil
import sys
from pathlib import Path

import httpx
import pytest
from numba.core.caching import UserProvidedCacheLocator as Place

from app.examples import REQUESTS
from core.drive import compiled as drive
from core.drive import engine
from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.ring.profile import CycloidDisc
from core.ring.sharing import CycloidMesh, mesh_over_turn
from tests.inputs.children import ran
from tests.inputs.real_mechanisms import STEEL
from tests.running_service import running_service


def test_whole_numbers_are_floats_to_the_engine():
    """A ratio of 18 and no clearance do not have them compiled once more."""
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=3, satellites=1, ratio=18),
        pin_circle_radius=0.02,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.01,
        law=LinearLaw(50_000_000),
        clearance=0,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    disc = CycloidDisc(5, 0.001, 0.02, 0.002)
    ring = CycloidMesh(
        disc=disc,
        crank_angles=(0.0,),
        contact_length=0.01,
        law=LinearLaw(50_000_000),
        pin_material=STEEL,
        disc_material=STEEL,
    )
    found = over_turn(real=real, output_torque=30)
    assert found.peak_force > 0 and mesh_over_turn(mesh=ring, output_torque=30).peak_force > 0
    assert len(engine.positions.signatures) == 1


def test_what_starts_the_service_imports_nothing_of_the_calculation():
    code = """
import sys
import app.serve
print([name for name in sys.modules if name.partition(".")[0] in ("core", "numpy", "numba")])
"""
    assert ran(sys.executable, "-c", code).stdout.strip() == "[]"


def test_without_numba_the_engine_runs_as_it_is():
    code = """
import sys
sys.modules["numba"] = None
import app.loaded, app.main
from core.drive import compiled, engine
print(engine.positions is compiled.PLAIN["positions"])
"""
    done = ran(sys.executable, "-c", code)
    said, found = done.stdout.splitlines()
    assert found == "True" and "numba is not installed" in said


def test_who_has_imported_numba_before_reads_the_same_cache():
    code = """
import numba
from app.compiled import load
load()
from core.drive import engine
print(numba.config.CPU_NAME, engine.positions.stats.cache_misses)
"""
    done = ran(sys.executable, "-c", code)
    assert (done.stdout.strip(), done.stderr) == ("generic Counter()", "")


TINY = """
import sys, types
from core.drive import compiled, engine
def small(x: float) -> float:
    return x + 1.0
def large(x: float) -> float:
    return small(x) + 1.0
def wide(x: float) -> float:
    return small(x) + 2.0
source = "{source}"
for each in (small, large, wide):
    code = each.__code__.replace(co_filename=source)
    made = types.FunctionType(code, vars(engine), each.__name__)
    made.__annotations__, made.__module__ = each.__annotations__, engine.__name__
    setattr(engine, each.__name__, made)
compiled.PLAIN = {{each: vars(engine)[each] for each in ("small", "large", "wide")}}
compiled.CALLED = "large", "wide"
from app.compiled import load
load()
print(engine.large(1.0) + engine.wide(1.0), engine.small is compiled.PLAIN["small"])
"""
"""Three functions in the place of the engine's, which are compiled in a moment: two are called, and
one becomes a part of both."""


@pytest.fixture
def start(tmp_path):
    """Messages of a process that reads or makes the cache of three small functions."""
    source, cache = tmp_path / "small.py", tmp_path / "cache"
    source.write_text("# where the functions are said to be\n")
    cache.mkdir()

    def started(place=cache):
        found = os.environ | {"NUMBA_CACHE_DIR": str(place)}
        done = ran(sys.executable, "-c", TINY.format(source=source), env=found)
        assert done.stdout.split() == ["7.0", "True"]
        return done.stderr.splitlines()

    started.cache, started.source = cache, source
    return started


def files(cache, ending):
    return sorted(cache.rglob(f"*.nb{ending}"))


def test_the_cache_is_made_once_and_mended_once_where_it_is_broken(start):
    made, mended = [drive.MADE], [drive.UNUSABLE, drive.MADE]
    assert start() == made
    assert len(files(start.cache, "i")) == len(files(start.cache, "c")) == 2
    start.source.write_text("# of another length\n")
    assert start() == made  # it is that of another source
    for left, each in zip((40, 0), files(start.cache, "i"), strict=True):
        each.write_bytes(each.read_bytes()[:left])
    assert start() == mended
    for left, each in zip((40, 0), files(start.cache, "c"), strict=True):
        each.write_bytes(each.read_bytes()[:left])
    assert start() == mended
    assert start() == []


def test_where_nothing_can_be_written_it_is_compiled_in_memory(start, tmp_path):
    (tmp_path / "file").touch()
    assert {*start(tmp_path / "file" / "cache")} == {drive.UNUSABLE, drive.MADE}


BODY = REQUESTS["load-sharing"]


@pytest.fixture
def broken(tmp_path):
    """Cache of this installation with an index and a result that are cut, and a function that is
    not there, where nothing can be written.
    """
    beside = Path(engine.__file__).parent / "__pycache__"
    own, below = (
        os.environ.get("NUMBA_CACHE_DIR"),
        Place.get_suitable_cache_subpath(engine.__file__),
    )
    shutil.copytree(Path(own, below) if own else beside, tmp_path / below)
    for name, ending in (("unloaded", "i"), ("gaps", "c")):
        found = tmp_path.rglob(f"engine.{name}-*.nb{ending}")  # older ones may be beside it
        each = max(found, key=lambda file: file.stat().st_mtime)
        each.write_bytes(each.read_bytes()[:40])
    for each in tmp_path.rglob("engine.pieces-*.nb?"):
        each.unlink()
    if ran("mount", "--bind", "-o", "ro", tmp_path, tmp_path, check=False).returncode:
        pytest.skip("file systems can only be mounted as root")
    yield tmp_path
    ran("umount", "--lazy", tmp_path)


def test_a_service_starts_whatever_its_cache_is_like(broken, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(broken))
    before = {each: each.stat().st_size for each in broken.rglob("*")}
    with running_service(processes=1, max_seconds=300) as service:
        answer = httpx.post(f"{service.url}/api/v1/load-sharing", json=BODY, timeout=300)
        assert answer.status_code == 200
    said = [line.get("message") for line in service.log()]
    assert [said.count(each) for each in (drive.MADE, drive.UNUSABLE)] == [1, 1]
    assert before == {each: each.stat().st_size for each in broken.rglob("*")}
