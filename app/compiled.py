"""The compiled load sharing: at hand once it has been compiled, which is done once an installation.

Until then, and without numba, the same loops run as they are: the same numbers, fifty times slower.
Run as a module it compiles, as the image does when it is built and the service where it finds that
it has not been done.
"""

import asyncio
import fcntl
import hashlib
import logging
import os
import platform
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Literal

from core.output import compiled, sharing_kernel
from core.output.contact_law import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.tolerance.study import Evaluation, Study, tolerance_study
from core.tolerance.tolerances import Tolerances

LOG = logging.getLogger("khv.compiled")

LOOKED_AT_S = 60.0
"""How often the service looks whether it has to be compiled."""

State = Literal["ready", "preparing", "missing"]


@cache
def _mark() -> Path | None:
    """The file that says that all is compiled, by this source and this numba; None where nothing
    can be compiled.
    """
    try:
        numba = version("numba")
    except PackageNotFoundError:
        return None
    source = Path(sharing_kernel.__file__)
    place = Path(os.environ.get("NUMBA_CACHE_DIR") or source.parent / "__pycache__")
    cpu = os.environ.get("NUMBA_CPU_NAME", "generic")  # which `compiled.load` sets
    names = numba, sys.version, platform.machine(), cpu
    made_of = source.read_bytes() + "\0".join(names).encode()
    digest = hashlib.blake2b(made_of, digest_size=12).hexdigest()
    return place / f"{source.stem}.{digest}.compiled"


def state() -> State:
    """Whether the compiled loops are at hand, will be, or cannot be: without numba, or where its
    cache cannot be written.
    """
    mark = _mark()
    if mark is None:
        return "missing"
    if mark.exists():
        return "ready"
    there = mark.parent if mark.parent.exists() else mark.parent.parent
    return "preparing" if os.access(there, os.W_OK) else "missing"


def came_late(seconds: float) -> bool:
    """Whether what began so many seconds ago went without compiled loops that another time it would
    have: they are being prepared, or have been at hand for less than that.
    """
    mark, now = _mark(), state()
    if now != "ready" or mark is None:
        return now == "preparing"
    return time.time() - mark.stat().st_mtime < seconds


def use() -> State:
    """Use the compiled loops from now on, if they are at hand."""
    now = state()
    if now == "ready":
        compiled.load()
    return now


def run_once() -> None:
    """Go through all that is compiled."""
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=3, satellites=1, ratio=18.0),
        pin_circle_radius=0.02,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.01,
        law=LinearLaw(5e7),
    )
    over_turn(real=real, output_torque=30.0)
    asked = Evaluation(("peak_force",), 30.0, positions=4)
    tolerance_study(Study(real, Tolerances(pin_position=1e-5), asked, samples=2))


def prepare() -> None:
    """Compile, unless it has been done; only one process at a time does.

    Raises
    ------
    OSError
        If the cache cannot be written.
    """
    mark = _mark()
    if mark is None or mark.exists():
        return
    mark.parent.mkdir(parents=True, exist_ok=True)
    with mark.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not mark.exists():
            compiled.load()
            run_once()
            mark.touch()


def forget() -> None:
    """Do without what was compiled, as it cannot be read; it can be compiled anew."""
    compiled.unload()
    mark = _mark()
    if mark is not None:
        mark.unlink(missing_ok=True)
        for part in mark.parent.rglob(f"{Path(sharing_kernel.__file__).stem}.*.nb[ci]"):
            part.unlink(missing_ok=True)


@asynccontextmanager
async def prepared() -> AsyncIterator[None]:
    """Compile in a process of its own beside the service, where that has not been done, or has to
    be done anew.
    """
    preparing = asyncio.create_task(_keep_prepared())
    try:
        yield
    finally:
        preparing.cancel()
        with suppress(asyncio.CancelledError):
            await preparing


async def _keep_prepared() -> None:
    while state() != "preparing" or await _prepare_beside():
        await asyncio.sleep(LOOKED_AT_S)


async def _prepare_beside() -> bool:
    """Compile, and whether that could be done."""
    LOG.info("compiling the load sharing, once: until then studies are small and slow")
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", "app.compiled", stderr=asyncio.subprocess.PIPE
    )
    try:
        _, said = await process.communicate()
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    if process.returncode == 0:
        LOG.info("the load sharing is compiled")
    else:
        LOG.warning("the load sharing was not compiled: %s", said.decode(errors="replace")[-500:])
    return process.returncode == 0


if __name__ == "__main__":
    os.nice(10)
    prepare()
