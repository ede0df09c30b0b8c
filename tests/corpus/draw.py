"""Make the corpus anew: `python -m tests.corpus.draw`.

Examples and paper figures, what the API's description shows, the tutorial, what calculations are
held to exact values with, random whole designs, what is refused, and every case of the load
sharing.
"""

import json
import random
import re
from pathlib import Path
from typing import Any

from app.examples import EXAMPLES, REQUESTS
from app.registry import EXPORTS
from tests.app.worked_designs import BARE_4000, SLEEVED_4000
from tests.app.worked_designs import REQUESTS as WORKED
from tests.corpus.engine import engine
from tests.inputs.fuzz_requests import DESIGNS, mutated
from tests.inputs.fuzz_requests import Draw as Wide
from tests.inputs.in_process import Service
from tests.oracles.answers import CALCULATIONS
from tests.oracles.answers.calculation import Draw

HERE = Path(__file__).parent
CORPUS = HERE / "requests.json"
TUTORIAL = HERE.parent.parent / "docs" / "tutorial.md"

COUNT, REFUSED = 400, 35
HELD = 10
"""Requests of each calculation that exact values are known of, one in five of them extreme."""

LEFT = {"work-precision", "batch", *EXPORTS}
"""What takes minutes, is many of the others, or is no numbers."""

Asked = dict[str, Any]


def asked(path: str, body: Any) -> Asked:
    return {"path": path, "body": body}


def usual() -> list[Asked]:
    """Usual requests, as shown to people."""
    found = [asked(each["calculation"], each["input"]) for each in EXAMPLES]
    found += [asked(path, body) for path, body in REQUESTS.items() if path not in LEFT]
    tutorial = re.findall(r"ask (\S+) '(.*?)'\n", TUTORIAL.read_text(encoding="utf-8"), re.DOTALL)
    found += [asked(path, json.loads(body)) for path, body in tutorial]
    whole = [each for each in found if each["path"] == "crank-planetary"]
    every = ["checks", "fixes"]
    return found + [asked("crank-planetary", each["body"] | {"include": every}) for each in whole]


MADE = {
    "contact_law": {"kind": "linear", "stiffness_N_per_mm": 1e5},
    "deviations": {
        "pin_tangential_mm": [0.004, -0.002, 0.0, 0.003, -0.005, 0.001],
        "pin_radius_mm": [0.0, -0.002, 0.001, 0.0, -0.001, 0.0],
        "hole_radial_mm": [[0.002, 0.0, -0.003, 0.001, 0.0, 0.0], [0.0] * 6],
        "hole_tangential_mm": [[0.0] * 6, [0.001, -0.001, 0.002, 0.0, 0.0, -0.002]],
        "hole_radius_mm": [[0.02] * 6, [0.025] * 6],
        "eccentricity_mm": [0.001, -0.001],
        "crank_phase_deg": [0.01, 0.0],
        "disc_phase_deg": [0.0, 0.01],
    },
}
"""A mechanism as it is made, with all that its parts may deviate by."""

SECTIONS: list[dict[str, Any]] = [
    {"satellite_body": {"outer_radius_mm": 75.0, "root_radius_mm": 68.0, "bore_radius_mm": 15.0}},
    {"satellite_body": {"outer_radius_mm": 66.0}, "requirements": {"max_outer_diameter_mm": 120.0}},
    MADE | {"requirements": {"max_lost_motion_arcmin": 2.0, "max_backlash_arcmin": 3.0}},
    MADE | {"crank_support": {"stiffness_N_per_mm": 2e5, "radial_clearance_mm": 0.01}},
    {"satellite_coupling": {"kind": "shares", "shares": [0.6, 0.4]}, "pin": None},
    {"satellite_coupling": {"kind": "elastic", "stiffness_Nm_per_arcmin": 40.0}, "pin": None},
    {"gear": {"kind": "cycloid", "ring_pin_circle_radius_mm": 66.0, "ring_pin_radius_mm": 3.0}},
    {
        "fatigue": {
            "surface": "ground",
            "edition": "shigley_9",
            "reliability_factor": 0.868,
            "fatigue_notch_factor": 1.4,
            "life_h": 2.0,
        },
        "requirements": {"min_wall_mm": 30.0, "max_slope_mrad": 1.0, "max_deflection_mm": 0.01},
    },
    {
        "requirements": {
            "min_efficiency": 0.99,
            "max_wear_mm": 1e-4,
            "max_pv_MPa_m_per_s": 1.0,
            "max_sliding_speed_m_per_s": 0.1,
            "max_unbalance_N": 1.0,
            "max_unbalance_couple_Nm": 0.1,
        }
    },
]
"""Sections and their fields that random designs seldom have, beside those of whole designs."""


def sections() -> list[Asked]:
    """Designs of every section, with their checks; with the fixes of all that fail where their
    forces are the ideal ones.
    """
    found = [asked(*each) for each in WORKED.values() if each[0] == "crank-planetary"]
    for design in (BARE_4000, SLEEVED_4000):
        for more in SECTIONS:
            body = {name: each for name, each in (design | more).items() if each is not None}
            found.append(asked("crank-planetary", body))
            ideal = not {"contact_law", "satellite_coupling"} & {*more}
            every = ["checks", "fixes"] if ideal else ["checks"]
            body = body | {"include": every, "fixes_for": "failed"}
            found.append(asked("crank-planetary", body))
    return found


IN_SERIES: list[dict[str, Any]] = [
    {"requirements": {"max_transmission_error_arcmin": 1.0, "max_lost_motion_arcmin": 9.0}},
    {"load": {"torque_direction": "alternating", "peak_torque_Nm": 300.0}},
    {"gear": {"modification": {"equidistant_mm": 0.03, "rotation_arcmin": 0.5}}},
    {"deviations": {"eccentricity_mm": [0.002, -0.002], "disc_phase_deg": [0.01, -0.01]}},
    {"mechanism": {"output": "ring"}, "contact": {"hole_clearance_mm": 0.05}},
]
"""What changes the example of cycloid discs whose meshes are solved in series."""


def in_series() -> list[Asked]:
    """Designs that are judged by both meshes, with what their ring does."""
    (whole,) = (each["input"] for each in EXAMPLES if each["id"] == "cycloid")
    found = []
    for more in IN_SERIES:
        body = json.loads(json.dumps(whole))
        for section, values in more.items():
            body[section] = None if values is None else {**body.get(section, {}), **values}
        body = {name: each for name, each in body.items() if each is not None}
        found.append(asked("crank-planetary", body))
        every = ["load_sharing", "ring_mesh", "ring_drawing", "checks"]
        found.append(asked("crank-planetary", body | {"include": every}))
    return found


def held() -> list[Asked]:
    """Requests with known exact values."""
    return [
        asked(calculation.path, calculation.request(Draw(seed, extreme=seed % 5 == 4)))
        for calculation in CALCULATIONS
        for seed in range(HELD)
    ]


def drawn(count: int, service: Service) -> list[Asked]:
    """Random designs of practical sizes that are answered, whole ones in half."""
    r, found = Wide(20261125), []
    others = [each for each in DESIGNS if each != "crank-planetary"]
    while len(found) < count:
        path = "crank-planetary" if r.chance(0.5) else r.choice(others)
        body = DESIGNS[path](r)
        mechanism = body.get("mechanism", body)
        few = mechanism.get("pins", 1) * mechanism.get("satellites", 1) <= 60
        if few and service.post(path, body)[0] == 200:
            found.append(asked(path, body))
    return found


def refused(good: list[Asked]) -> list[Asked]:
    """Requests with one fault."""
    r, picks = Wide(7), random.Random(7).sample(good, REFUSED)
    return [asked(each["path"], mutated(r, each["body"])) for each in picks]


def main() -> None:
    """Write the corpus."""
    service = Service()
    good = [
        each
        for each in usual() + sections() + in_series() + held()
        if service.post(each["path"], each["body"])[0] == 200
    ]
    good += drawn(COUNT - REFUSED - len(good), service)
    lines = [json.dumps(each) for each in good + refused(good) + engine()]
    CORPUS.write_text("[\n" + ",\n".join(lines) + "\n]\n", encoding="utf-8")
    print(f"{len(lines)} requests in {CORPUS.name}")


if __name__ == "__main__":
    main()
