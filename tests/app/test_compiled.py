"""The cache of the compiled loops: made once, read where turns are calculated, mended."""

import ast
import functools
import importlib
import json
import signal
import subprocess
import sys
from collections import Counter
from contextlib import suppress
from pathlib import Path

import numba
import pytest
from numba.core.caching import FunctionCache, IndexDataCacheFile
from pydantic import ValidationError

import core
from app import compiled
from app.problems import Problem
from app.registry import CALCULATIONS
from core.drive import compiled as drive
from core.drive import engine
from core.errors import ImpossibleMechanism, InvalidInput
from core.output import compiled as loops
from core.output import sharing_kernel, turn_kernel
from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.ring.profile import CycloidDisc
from core.ring.sharing import CycloidMesh, mesh_over_turn
from tests.inputs.children import ran
from tests.inputs.real_mechanisms import STEEL

CORPUS = Path(__file__).parent.parent / "corpus" / "requests.json"
WALKED = ("crank-planetary", "load-sharing", "tolerance-study", "crankshaft", "satellite-bearing")


def called() -> set[str]:
    """What core calls of the loops by name."""
    trees = (ast.parse(path.read_text()) for path in Path(core.__file__).parent.rglob("*.py"))
    return {
        node.func.attr
        for tree in trees
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
        if (isinstance(of := node.func.value, ast.Name) and of.id == "kernel")
        or (isinstance(of, ast.Attribute) and of.attr == "kernel")
    } - {"row", "table", "none"}


def test_all_that_is_called_of_the_loops_is_in_the_cache():
    """Nothing is compiled any more by turns, curves and pieces of whatever design."""
    names = called()
    assert names == {*loops.CALLED} == {"poses", "values", "narrow", "pieces"}
    compiled.load()
    kernel = loops.at_hand()
    before = {name: getattr(kernel, name).signatures for name in names}
    assert {name: len(each) for name, each in before.items()} == dict.fromkeys(names, 1)
    asked = Counter[str]()
    for request in json.loads(CORPUS.read_text())[2::4]:
        body = request["body"]
        searches = "fixes" in body.get("include", ())  # which solve the same again and again
        if request["path"] in WALKED and "contact" in body and not searches:
            calculation = CALCULATIONS[request["path"]]
            with suppress(ValidationError, InvalidInput, ImpossibleMechanism, Problem):
                calculation.solve(calculation.request.model_validate(body))
                asked[request["path"]] += 1
    assert {*asked} == {*WALKED} and asked.total() > 30
    assert {name: getattr(kernel, name).signatures for name in names} == before


def test_whole_numbers_are_floats_to_the_loops():
    """A ratio of 18 and no clearance do not have them compiled once more."""
    compiled.load()
    kernel = loops.at_hand()
    before = kernel.poses.signatures, engine.positions.signatures
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
    assert (kernel.poses.signatures, engine.positions.signatures) == before != ([], [])


def test_who_looks_for_the_cache_imports_nothing_of_the_calculation():
    code = """
import sys
import app.serve
print([name for name in sys.modules if name.partition(".")[0] in ("core", "numpy", "numba")])
"""
    done = ran(sys.executable, "-c", code)
    assert done.stdout.strip() == "[]"
    assert tuple(Path(each.__file__) for each in loops.SOURCES) == compiled.SOURCES
    assert Path(engine.__file__) == compiled.ENGINE
    assert {*compiled.LAST} <= {*loops.CALLED, *drive.CALLED}


def test_without_numba_the_loops_run_as_they_are():
    code = """
import sys
sys.modules["numba"] = None
import app.loaded, app.main
from core.output import compiled
print(compiled.at_hand() is compiled.PLAIN)
"""
    done = ran(sys.executable, "-c", code)
    assert done.stdout.split() == ["True"]
    assert "numba is not installed" in done.stderr


def test_who_has_imported_numba_before_reads_the_same_cache():
    code = """
import numba
from app import compiled
compiled.load()
from core.output import compiled as loops
print(numba.config.CPU_NAME, loops.at_hand().poses.stats.cache_misses)
"""
    compiled.load()
    done = ran(sys.executable, "-c", code)
    assert done.stdout.strip() == "generic Counter()"


@pytest.fixture
def elsewhere(monkeypatch, tmp_path):
    """A place of its own for the cache."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    return tmp_path


def indexed(place, stamp=None, names=tuple(compiled.LAST)):
    """Indices as numba writes them of what it compiles last, for its stamps of the sources."""
    functions = {"pieces": loops.in_place_of().pieces, "narrow": drive.PLAIN["narrow"]}
    for name in names:
        source = turn_kernel if name == "pieces" else engine
        own = loops.Place.from_function(functions[name], source.__file__).get_source_stamp()
        base = f"{Path(source.__file__).stem}.{name}-1.py311"
        IndexDataCacheFile(str(place), base, own if stamp is None else stamp(own)).flush()


def test_a_cache_is_one_that_numba_takes_for_that_of_the_sources(elsewhere, monkeypatch):
    assert not compiled.cached()
    place = elsewhere / "ring_0"
    place.mkdir()
    for name in compiled.LAST:
        indexed(place, names=(name,))
        assert compiled.cached() == (name == [*compiled.LAST][-1])
    assert compiled.cached()
    monkeypatch.setattr(compiled, "version", lambda _: "0.1")
    assert not compiled.cached()


def test_a_cache_of_sources_of_other_times_is_none(elsewhere):
    """As of a tree that was copied by whole seconds, with the cache that was made before."""
    indexed(elsewhere, lambda own: [(float(int(time) - 1), size) for time, size in own])
    assert not compiled.cached()
    indexed(elsewhere, lambda own: [(time, size + 1) for time, size in own])
    assert not compiled.cached()
    indexed(elsewhere)
    index = min(elsewhere.glob("*.nbi"))
    index.write_bytes(index.read_bytes()[:40])
    assert not compiled.cached()


def test_the_cache_that_is_loaded_is_one():
    compiled.load()
    assert compiled.cached()


def test_a_broken_cache_is_made_anew(elsewhere, monkeypatch):
    runs = []

    def run_once():
        runs.append([*elsewhere.rglob("*.nb?")])
        if runs[-1]:
            raise EOFError

    (elsewhere / "turn_kernel.pieces-1.py311.1.nbc").write_bytes(b"broken")
    monkeypatch.setattr(compiled, "run_once", run_once)
    compiled.load()
    assert [*map(bool, runs)] == [True, False]


@pytest.fixture
def tiny(elsewhere, monkeypatch):
    """Loops that are compiled in a moment."""
    source = elsewhere / "tiny.py"
    source.write_text("\n".join(f"def {name}(x):\n    return x + 1.0\n" for name in loops.CALLED))
    monkeypatch.syspath_prepend(elsewhere)
    monkeypatch.setattr(loops, "SOURCES", (importlib.import_module("tiny"),))
    monkeypatch.setattr(loops, "_at_hand", loops.plain)
    for name in ("_dispatchers", "_compiled"):
        monkeypatch.setattr(loops, name, functools.cache(getattr(loops, name).__wrapped__))
    monkeypatch.setattr(compiled, "run_once", lambda: loops.at_hand().poses(1.0))
    for name in ("save_overload", "load_overload"):
        monkeypatch.setattr(FunctionCache, name, getattr(FunctionCache, name))
    yield elsewhere
    del sys.modules["tiny"]
    monkeypatch.undo()
    numba.config.reload_config()


def test_where_nothing_can_be_written_the_loops_are_compiled_in_memory(tiny, monkeypatch, caplog):
    (tiny / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tiny / "file" / "cache"))
    compiled.load()
    poses = loops.at_hand().poses
    assert poses.signatures and poses(2.0) == 3.0
    assert "cannot be made" in caplog.text


def test_a_service_without_a_cache_makes_one_first(elsewhere, monkeypatch, caplog):
    run, ended = [], []
    former = elsewhere / "turn_kernel.pieces-1.py311.nbi"
    former.write_bytes(b"of other sources")

    class Part:
        def __init__(self, command):
            assert not former.exists()
            run.append(command[2])

        def wait(self):
            ended.append("waited")

        def kill(self):
            ended.append("killed")

    monkeypatch.setattr(subprocess, "Popen", Part)
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    with caplog.at_level("INFO", logger="khv.compiled"):
        compiled.make_cache()
        named = [[name for name in compiled.PARTS if repr(name) in code] for code in run]
        assert named == [["turns"], ["engine"]]
        assert ended == [*["waited"] * 2, *["killed"] * 2]
        assert "once an installation" in caplog.text
        indexed(elsewhere)
        compiled.make_cache()
    assert len(run) == 2 and len(caplog.records) == 1


def test_a_cache_can_be_read_where_it_cannot_be_written(elsewhere, monkeypatch):
    """As in an image, whose files are another user's: no locator of numba's own takes that."""

    def refuse(path):
        raise PermissionError(path)

    from numba.core.caching import UserProvidedCacheLocator

    monkeypatch.setattr(UserProvidedCacheLocator, "ensure_cache_path", refuse)
    found = loops.Place.from_function(sharing_kernel.solve, sharing_kernel.__file__)
    assert found.get_cache_path()
