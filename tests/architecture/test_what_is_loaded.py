"""Importing the calculations loads NumPy, and nothing that a case may not need."""

import pkgutil
import sys

import core
from tests.inputs.children import ran

HEAVY = {"numba", "mpmath", "plotly", "fastapi", "pydantic", "httpx", "uvicorn"}


def test_importing_every_calculation_loads_no_plotting_no_web_and_no_mpmath() -> None:
    every = [module.name for module in pkgutil.walk_packages(core.__path__, "core.")]
    every.remove("core.drive.by_pointer")  # a part of the compiler, which a process loads once
    assert len(every) > 20
    code = f"import sys, {', '.join(every)}; print(*sorted({HEAVY} & set(sys.modules)))"
    done = ran(sys.executable, "-c", code)
    assert done.stdout.split() == []


WORK = """
import sys
from core.output.loaded_position import loaded_position
from core.output.over_turn import over_turn
from tests.inputs.real_mechanisms import design
loaded_position(real=design(), crank_angle=0.0, output_torque=30.0)
over_turn(real=design(), output_torque=30.0)
print("numba" in sys.modules)
"""


def test_a_position_and_an_interpreted_turn_load_no_compiler() -> None:
    done = ran(sys.executable, "-c", WORK)
    assert done.stdout.split() == ["False"]


def test_the_check_would_see_what_is_loaded() -> None:
    code = f"import sys, pydantic; print(*sorted({HEAVY} & set(sys.modules)))"
    done = ran(sys.executable, "-c", code)
    assert done.stdout.split() == ["pydantic"]
