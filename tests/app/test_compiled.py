"""The compiled loops in the service: compiled once, told, and never waited for."""

import asyncio
import importlib
import subprocess
import sys
import time

import pytest

from app import compiled, loaded, processes
from core.output import compiled as loops
from core.output import sharing_kernel


@pytest.fixture
def elsewhere(monkeypatch, tmp_path):
    """A cache of its own."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    compiled._mark.cache_clear()
    yield tmp_path
    compiled._mark.cache_clear()


def test_an_installation_prepares_once(elsewhere, monkeypatch):
    done = []
    monkeypatch.setattr(compiled, "run_once", lambda: done.append(1))
    monkeypatch.setattr(loops, "load", lambda: None)
    assert compiled.state() == "preparing"
    assert compiled.use() == "preparing"
    compiled.prepare()
    compiled.prepare()
    assert (compiled.state(), done) == ("ready", [1])


def test_what_loading_sets_for_other_processes_moves_no_mark(elsewhere, monkeypatch):
    monkeypatch.delenv("NUMBA_CPU_NAME", raising=False)
    before = compiled._mark()
    monkeypatch.setenv("NUMBA_CPU_NAME", "generic")  # as `core.output.compiled.load` does
    compiled._mark.cache_clear()
    assert compiled._mark() == before


def test_a_process_from_before_they_were_compiled_uses_them_once_they_are(elsewhere, monkeypatch):
    def used():
        told = []
        processes._told(told.append, lambda tell: tell(loops.at_hand()), ())
        return [part for part, _ in told]

    monkeypatch.setattr(compiled, "run_once", lambda: None)
    monkeypatch.setattr(loops, "_compiled", lambda: "compiled")
    monkeypatch.setattr(loops, "_at_hand", loops.PLAIN)
    assert used() == [loops.PLAIN]
    compiled._mark().touch()
    assert used() == ["compiled"]


def test_what_began_before_the_loops_were_there_may_be_faster_another_time(elsewhere, monkeypatch):
    assert compiled.came_late(10.0)
    mark = compiled._mark()
    mark.touch()
    monkeypatch.setattr(time, "time", lambda: mark.stat().st_mtime + 8)
    assert compiled.came_late(10.0) and not compiled.came_late(6.0)
    mark.unlink()
    monkeypatch.setattr("os.access", lambda path, mode: False)
    assert compiled.state() == "missing" and not compiled.came_late(10.0)


def test_what_failed_is_not_ready(elsewhere, monkeypatch):
    def fails():
        raise RuntimeError

    monkeypatch.setattr(compiled, "run_once", fails)
    monkeypatch.setattr(loops, "load", lambda: None)
    with pytest.raises(RuntimeError):
        compiled.prepare()
    assert compiled.state() == "preparing"


def test_a_cache_that_cannot_be_written_is_not_waited_for(elsewhere, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, mode: False)
    assert compiled.state() == "missing"


def test_without_numba_all_is_answered_as_it_is():
    code = """
import sys
sys.modules["numba"] = None
import importlib.metadata as installed
version = installed.version
def without(name):
    if name == "numba":
        raise installed.PackageNotFoundError
    return version(name)
installed.version = without
from app.compiled import prepare, state, use, run_once
import app.loaded, app.main
prepare()
run_once()
print(state(), use())
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["missing", "missing"]


def test_a_broken_cache_is_done_without_and_compiled_anew(elsewhere, monkeypatch):
    for name in ("sharing_kernel.solve-1.py311.nbi", "sharing_kernel.solve-1.py311.1.nbc"):
        (elsewhere / "output_0").mkdir(exist_ok=True)
        (elsewhere / "output_0" / name).write_bytes(b"broken")
    compiled._mark().touch()

    def fails():
        raise EOFError

    monkeypatch.setattr(loops, "_at_hand", None)
    monkeypatch.setattr(loops, "load", lambda: None)
    monkeypatch.setattr(compiled, "run_once", fails)
    importlib.reload(loaded)
    assert loops.at_hand() is loops.PLAIN
    assert compiled.state() == "preparing"
    assert not [*elsewhere.rglob("*.nb?")]


@pytest.mark.usefixtures("compiled_loops")
def test_a_cache_can_be_read_where_it_cannot_be_written(monkeypatch):
    """As in an image, whose files are another user's: no locator of numba's own takes that."""

    def refuse(path):
        raise PermissionError(path)

    from numba.core.caching import UserProvidedCacheLocator

    monkeypatch.setenv("NUMBA_CACHE_DIR", str(compiled._mark().parent))
    monkeypatch.setattr(UserProvidedCacheLocator, "ensure_cache_path", refuse)
    found = loops.Place.from_function(sharing_kernel.solve, sharing_kernel.__file__)
    assert found.get_cache_path()


@pytest.mark.anyio
@pytest.mark.parametrize("failed", [False, True])
async def test_the_service_compiles_beside_itself_and_says_so(
    elsewhere, monkeypatch, caplog, failed
):
    monkeypatch.setattr(sys, "executable", "/bin/false" if failed else "/bin/true")
    with caplog.at_level("INFO", logger="khv.compiled"):
        async with compiled.prepared():
            for _ in range(600):
                if len(caplog.records) == 2:
                    break
                await asyncio.sleep(0.1)
    first, last = (record.message for record in caplog.records)
    assert "until then" in first
    assert ("was not compiled" in last) == failed
