"""Proposals for requirements of several kinds: how many hold, and the processor time of a search.

Each proposal is judged again as a request of its own. Times are of this process; loops are compiled
before. A requirement with `none` has no solution: the table says which check is missed most. `ring
of pieces` is the pressure on ring pins that nine tenths of the pieces keep, over its limit.
"""

import time
from typing import Any

from app import compiled
from app.calculations.propose import SECONDS, ProposeRequest, reporting
from app.model import Values
from app.registry import CALCULATIONS
from benchmarks.options import options

ABS = {"disc": "plastic_abs_printed"}
HARDENED = {"disc": "steel_case_hardened"}
PRINTED = {"ratio": 15, "outer_diameter_mm": 90, "length_mm": 40, "input_speed_rpm": 300}
TWENTY = {"ratio": 20, "torque_Nm": 500, "life_h": 6000, "process": "ground"}
SLEWING = {"ratio": 59, "torque_Nm": 1200, "length_mm": 95, "process": "ground", "output": "ring"}

SETS: dict[str, dict[str, Any]] = {
    "A printed of ABS": PRINTED | {"torque_Nm": 2.5, "process": "fdm", "materials": ABS},
    "A printed of PLA": PRINTED | {"torque_Nm": 1, "process": "fdm"},
    "A printed, none": PRINTED | {"torque_Nm": 5, "process": "fdm"},
    "B small": {
        "ratio": 20, "torque_Nm": 20, "outer_diameter_mm": 80, "length_mm": 50,
        "materials": HARDENED,
    },
    "B with more room": {
        "ratio": 20, "torque_Nm": 20, "outer_diameter_mm": 120, "length_mm": 60,
        "materials": HARDENED,
    },
    "B through-hardened": {"ratio": 20, "torque_Nm": 15, "outer_diameter_mm": 120, "length_mm": 60},
    "C robot": TWENTY | {"outer_diameter_mm": 180, "length_mm": 90},
    "C with more room": TWENTY | {"outer_diameter_mm": 220, "length_mm": 90},
    "D ring turns": SLEWING | {"outer_diameter_mm": 240},
    "D with more room": SLEWING | {"outer_diameter_mm": 280},
    "E sintered": {
        "ratio": 9, "ratio_to": 12, "torque_Nm": 2, "outer_diameter_mm": 60,
        "input_speed_rpm": 300, "process": "sls",
    },
    "G unlike discs": {"ratio": 24, "torque_Nm": 50, "outer_diameter_mm": 110},
    "F none": TWENTY | {"outer_diameter_mm": 60},
}  # fmt: skip
"""Requirements by name, the quickest last."""


def row(name: str) -> str:
    """Line of the table for a requirement."""
    body = ProposeRequest.model_validate(SETS[name])
    began, firsts = time.process_time(), []

    def report(_: float, **found: Values) -> None:
        firsts.append(time.process_time() - began)

    answer = reporting(body, report, SECONDS)
    spent = time.process_time() - began
    kept = sum(map(_same, answer["proposals"]))
    verdicts = ", ".join(sorted({each["verdict"] for each in answer["proposals"]}))
    lacks = [each["code"] for each in answer.get("nearest", {}).get("lacks", ())]
    first = f"{firsts[0]:.1f}" if firsts else "–"
    pieces = [each["columns"]["ring_utilisation"] for each in answer["proposals"]]
    ring = f"{min(pieces):.2f} to {max(pieces):.2f}" if pieces else "–"
    return (
        f"| {name} | {len(answer['proposals'])} | {kept} | {verdicts or lacks[0]} | {ring} "
        f"| {answer['screened']:,} | {answer['judged']} | {first} | {spent:.1f} |"
    )


def _same(proposal: Values) -> bool:
    """True if a proposal has the same verdict when it is asked as a request."""
    reducer = CALCULATIONS["crank-planetary"]
    asked = reducer.request.model_validate(proposal["design"] | {"include": ["checks"]})
    return bool(reducer.answered(asked)["verdict"] == proposal["verdict"])


def main(smallest: bool = False) -> None:
    """Print the table."""
    compiled.load()
    print("| requirement | held | same again | verdict, or what is missed | ring of pieces "
          "| screened | judged | first, s | all, s |")  # fmt: skip
    print("|---|---|---|---|---|---|---|---|---|")
    for name in [*SETS][-1:] if smallest else SETS:
        print(row(name), flush=True)


if __name__ == "__main__":
    main(options(__doc__).smallest)
