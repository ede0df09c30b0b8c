"""The compiled loops of the load sharing: their cache, which is made once an installation.

Run as a module it makes the cache, as `make run`, `make test` and the image do. Processes for
calculations read it as they start; where it is missing or broken they make it.
"""

import logging
import os
import pickle
import signal
import subprocess
import sys
from contextlib import ExitStack, suppress
from importlib.metadata import version
from pathlib import Path
from typing import Any

LOG = logging.getLogger("khv.compiled")

ONCE = "compiling the load sharing, once an installation: a minute or two"

CORE = Path(__file__).parent.parent / "core"

SOURCES = (
    CORE / "output" / "loop_rows.py",
    CORE / "output" / "contact_kernel.py",
    CORE / "output" / "giving_kernel.py",
    CORE / "output" / "tied_kernel.py",
    CORE / "output" / "sharing_kernel.py",
    CORE / "output" / "turn_kernel.py",
)

ENGINE = CORE / "drive" / "engine.py"

LAST = {"pieces": (CORE / "output" / "compiled.py", *SOURCES), "narrow": (ENGINE,)}
"""Functions that are compiled last, and their sources: of the loops, and of the engine."""


def _files(name: str = "*") -> list[Path]:
    """What the cache has of a function, or of all."""
    return [
        file
        for source in (*SOURCES, ENGINE)
        for file in Path(os.environ.get("NUMBA_CACHE_DIR") or source.parent / "__pycache__").rglob(
            f"{source.stem}.{name}-*.nb[ci]"
        )
    ]


class _Unread:
    """A type that numba keeps in an index, which nobody asks for here."""

    def __new__(cls, *_: Any, **__: Any) -> "_Unread":
        return super().__new__(cls)

    def __setstate__(self, _: Any) -> None:
        pass


class _Index(pickle.Unpickler):
    """Reads an index of numba's without numba."""

    def find_class(self, *_: str) -> Any:
        return _Unread


def _stamp(index: Path) -> tuple[Any, ...]:
    """What an index of numba's says that it was made of: numba's version, times and sizes of the
    sources; empty where it cannot be read.
    """
    with suppress(Exception), index.open("rb") as file:
        made_by, (sources, _) = _Index(file).load(), _Index(file).load()
        return made_by, *sorted(sources)
    return ()


def cached() -> bool:
    """Whether there is a cache, whole, which numba takes for one of the sources as they are: they
    have the very times and sizes that they had then.
    """
    with suppress(ModuleNotFoundError):
        for name, made_of in LAST.items():
            stats = [source.stat() for source in made_of]
            sources = sorted((each.st_mtime, each.st_size) for each in stats)
            expected = (version("numba"), *sources)
            if not any(_stamp(file) == expected for file in _files(name)):
                return False
        return True
    return False


def _turns() -> None:
    """All that is called of pins in holes, over the turn and of pieces."""
    from core.hertz import ElasticMaterial
    from core.output.elasticity import LinearLaw
    from core.output.mechanism import Mechanism
    from core.output.over_turn import over_turn
    from core.output.real_mechanism import RealMechanism
    from core.tolerance.study import Evaluation, Study, tolerance_study
    from core.tolerance.tolerances import Tolerances

    steel = ElasticMaterial(210e9, 0.3)
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=3, satellites=1, ratio=18.0),
        pin_circle_radius=0.02,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.01,
        law=LinearLaw(5e7),
        pin_material=steel,
        hole_material=steel,
    )
    turn = over_turn(real=real, output_torque=30.0)
    assert turn.peak_force > 0 and turn.lost_motion > 0
    asked = Evaluation(("peak_force",), 30.0, positions=4)
    tolerance_study(Study(real, Tolerances(pin_position=1e-5), asked, samples=2))


def _engine() -> None:
    """The engine of both meshes and of the ring alone, all of which is compiled as it is loaded."""
    from core.drive import compiled

    compiled.load()


PARTS = {"turns": _turns, "engine": _engine}
"""Parts of the cache, which are compiled apart from each other."""


def run_once() -> None:
    """Go through all that is called of what is compiled."""
    for part in PARTS.values():
        part()


def make_part(name: str) -> None:
    """Make a part of the cache, by its name of `PARTS`; nothing without numba, or where it cannot
    be written.
    """
    from core.output import compiled

    with suppress(ImportError, OSError):
        if name == "turns":
            compiled.load_loops()
        PARTS[name]()


def load() -> None:
    """Calculate with the compiled loops from now on, all of them read from the cache or compiled
    now, anew where it is broken, in memory where it cannot be written; without numba with the same
    loops as they are. (Who only looks for the cache, as the parent of workers, imports none of the
    calculation.)
    """
    from core.output import compiled

    try:
        compiled.load()
    except ImportError:
        LOG.warning("numba is not installed: the load sharing is calculated fifty times slower")
        return
    try:
        run_once()
    except Exception as error:
        LOG.warning("the cache of the compiled loops is broken, or cannot be made: %r", error)
        try:
            for file in _files():
                file.unlink(missing_ok=True)
            run_once()
        except OSError:
            _keep_nothing()
            run_once()


def _keep_nothing() -> None:
    """Have numba neither write nor read a cache, in this process and those forked from it."""
    from numba.core.caching import FunctionCache

    FunctionCache.save_overload = FunctionCache.load_overload = lambda *_: None


def make_cache() -> None:
    """Make the cache where there is none of the sources as they are, each part in a process of its
    own; a signal to stop ends them too. One of other sources may name what is no longer there.

    Where it cannot be made, processes for calculations compile as they start.
    """
    if cached():
        return
    LOG.info(ONCE)
    for file in _files():
        with suppress(OSError):
            file.unlink()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    with ExitStack() as ends:
        codes = (f"from app.compiled import make_part; make_part({name!r})" for name in PARTS)
        parts = [subprocess.Popen([sys.executable, "-c", code]) for code in codes]
        for part in parts:
            ends.callback(part.kill)
        for part in parts:
            part.wait()


if __name__ == "__main__":
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    make_cache()
    load()
