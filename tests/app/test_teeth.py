"""Teeth of the designs that we show exist: of examples, of documents, of the page's starts."""

import json
import re
from pathlib import Path

import pytest

from app.examples import EXAMPLES, REQUESTS
from tests.inputs.children import ran
from tests.oracles.teeth import contact_ratio, cycloid_margin

ROOT = Path(__file__).parents[2]
ASKED = re.compile(r"(?:'|<<\w+\n)(\{.*?\})(?:'|\n)", re.DOTALL)

STARTS = """
import { WANTED } from "./static/calculators/crank-planetary/wanted.js";
const { starts } = WANTED.find(({ id }) => id === "bearings");
const designs = [];
for (const difference of [1, 2, 3, 4, 6, 10])
  for (const ratio of [8, 10, 20, 35, 60])
    for (const eccentricity_mm of [0.6, 1.5, 2, 2.5, 3.68, 5, 8])
      for (const pin_circle_radius_mm of [10, 28, 40, 90]) {
        const satellite_teeth = difference * ratio;
        const mechanism = { satellite_teeth, ring_teeth: satellite_teeth + difference };
        const contact = { eccentricity_mm, pin_radius_mm: pin_circle_radius_mm / 5 };
        const filled = starts({ mechanism, load: { pin_circle_radius_mm }, contact });
        const gear = {};
        for (const path in filled) gear[path.replace("gear.", "")] = filled[path];
        designs.push({ mechanism, contact, gear });
      }
console.log(JSON.stringify(designs));
"""


def with_gear(value):
    """Requests inside a value whose ring is given by its teeth or pins."""
    if isinstance(value, dict):
        if "kind" in value.get("gear", {}):
            yield value
        for each in value.values():
            yield from with_gear(each)
    elif isinstance(value, list):
        for each in value:
            yield from with_gear(each)


def in_documents():
    """Bodies that documents ask with."""
    for document in (ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("clients/**/*.md")):
        for text in ASKED.findall(document.read_text()):
            try:
                yield json.loads(text)
            except json.JSONDecodeError:
                assert '"gear"' not in text, f"{document}: {text}"


def teeth(design):
    """Teeth of a satellite and of the ring."""
    mechanism = design["mechanism"]
    if "satellite_teeth" in mechanism:
        return mechanism["satellite_teeth"], mechanism["ring_teeth"]
    difference = design["gear"].get("teeth_difference", 1)
    satellite = round(mechanism["ratio"] * difference)
    return satellite, satellite + difference


def exist(design):
    """True if the teeth of a design exist."""
    (z_s, z_r), gear = teeth(design), design["gear"]
    e = design["contact"]["eccentricity_mm"]
    if gear["kind"] == "involute":
        sizes = {"satellite_teeth": z_s, "ring_teeth": z_r, "module": gear["module_mm"]}
        return contact_ratio(**sizes, eccentricity=e) >= 1
    pins = {"circle_radius": gear["ring_pin_circle_radius_mm"], "eccentricity": e}
    pins |= {"ring_pins": z_r, "pin_radius": gear["ring_pin_radius_mm"]}
    return cycloid_margin(**pins, difference=z_r - z_s) >= 1


def test_what_exists_is_told_from_what_does_not():
    """The tips of one tooth of difference meet below some 0.77 modules of eccentricity."""
    one = {"satellite_teeth": 20, "ring_teeth": 21, "module": 3.5}
    assert contact_ratio(**one, eccentricity=2.0) < 0.8
    assert contact_ratio(**one, eccentricity=0.8 * 3.5) > 1
    two = {"satellite_teeth": 40, "ring_teeth": 42, "module": 3.0}
    assert contact_ratio(**two, eccentricity=3.2) < 0.9
    assert contact_ratio(**two, eccentricity=3.68) > 1.3
    many = {"satellite_teeth": 16, "ring_teeth": 24, "module": 3.0}  # far from interference
    assert contact_ratio(**many, eccentricity=13.19) > 1.3


@pytest.mark.parametrize(("k", "lobes"), [(0.3, 9), (0.6, 11), (0.9, 29)])
def test_a_cycloid_loops_beyond_the_known_radius(k, lobes):
    """Smallest radii of curvature of an epitrochoid, in closed form."""
    pins, circle = lobes + 1, 50.0
    limit = circle * (27 * (1 - k**2) * lobes) ** 0.5 / (pins + 1) ** 1.5
    if k <= (pins - 2) / (2 * pins - 1):
        limit = circle * (1 + k) ** 2 / (1 + pins * k)
    sizes = {"ring_pins": pins, "circle_radius": circle, "eccentricity": k * circle / pins}
    assert cycloid_margin(**sizes, pin_radius=1.0) == pytest.approx(limit, rel=1e-4)
    assert cycloid_margin(**sizes | {"eccentricity": circle / pins}, pin_radius=1.0) == 0


SHOWN = [
    *with_gear(EXAMPLES),
    *with_gear(REQUESTS),
    *(design for body in in_documents() for design in with_gear(body)),
]


def test_all_kinds_of_places_are_looked_at():
    assert len(SHOWN) >= 6
    assert {design["gear"]["kind"] for design in SHOWN} == {"involute", "cycloid"}


@pytest.mark.parametrize("design", SHOWN, ids=lambda design: json.dumps(design["gear"]))
def test_teeth_of_a_design_that_is_shown_exist(design):
    assert exist(design)


@pytest.mark.slow
def test_teeth_that_the_page_starts_from_exist():
    command = ["node", "--input-type=module", "--eval", STARTS]
    designs = json.loads(ran(*command, cwd=ROOT).stdout)
    kinds = {design["gear"]["kind"] for design in designs}
    assert kinds == {"involute", "cycloid"}
    unreal = [json.dumps(design) for design in designs if not exist(design)]
    assert not unreal, f"{len(unreal)} of {len(designs)}: {unreal[:3]}"
