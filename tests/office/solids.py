"""Build the solids of the examples with build123d and read their STEP files.

A solid that is not valid, a volume that is not that of the mass, a hole that is not where the
design has it, or two parts that meet end it with an error.
"""

import importlib.util
import itertools
import math
import tempfile
import time
from pathlib import Path

from build123d import GeomType, export_step, import_step

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import EXAMPLES
from app.exports.build123d import SolidsRequest, write
from app.exports.step import write as step_file
from core.design.drawings import drawn_satellites
from core.design.mass import mass

WHOLE = "cycloid", "involute"
"""Examples of whole reducers with teeth."""

VOLUME = 1e-6
"""Volume in which two parts may meet, mm^3."""

ALIKE = {
    "satellite": ("discs", 2e-4),  # outlines are polygons, up to 0.005 mm off
    "pin": ("pins", 1e-9),
    "carrier": ("carrier", 1e-9),
    "second_carrier": ("second_carrier", 1e-9),
    "shaft": ("shaft", 1e-9),
}
"""Names of masses, and relative differences, by the names of solids."""


def module_of(script, folder):
    """Script as a module."""
    path = folder / "reducer.py"
    path.write_bytes(script)
    spec = importlib.util.spec_from_file_location("reducer", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def read_step(content):
    """Solids of a STEP file that the service answers."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "answered.step")
        path.write_bytes(content)
        return import_step(path)


def check_volumes(parts, design):
    """Compare volumes with masses, which take all these parts to be of steel."""
    volumes = {}
    for part in parts:
        name = part.label.rstrip("0123456789").rstrip("_")  # of all satellites together
        volumes[name] = volumes.get(name, 0.0) + part.volume * 1e-9
    of_mass = {each.code: each.solid for each in mass(design).parts}
    for name, (code, close) in ALIKE.items():
        expected = of_mass[code].mass / 7850
        off = abs(volumes[name] / expected - 1)
        print(f"  {name}: {1e9 * volumes[name]:.3f} mm3, {off:.1e} from its mass")
        assert off <= close, name


def check_holes(parts, design):
    """Compare holes of discs with those of the drawings."""
    numbers = tuple(range(1, design.mechanism.satellites + 1))
    for drawn in drawn_satellites(design=design, numbers=numbers, chord_error=1e-5):
        (disc,) = (each for each in parts if each.label == f"satellite_{drawn.number}")
        axes = [face.axis_of_rotation for face in disc.faces().filter_by(GeomType.CYLINDER)]
        found = {(axis.position.X, axis.position.Y) for axis in axes}
        for x, y in drawn.holes.centres:
            at = 1e3 * (x + drawn.centre[0]), 1e3 * (y + drawn.centre[1])
            assert min(math.dist(at, each) for each in found) < 1e-6, (drawn.number, at)


def meeting(parts):
    """Pairs of parts that share a volume, and that volume, mm^3."""
    found = []
    for one, other in itertools.combinations(parts, 2):
        common = one & other
        volume = sum(each.volume for each in common.solids()) if common else 0.0
        if volume > VOLUME:
            found.append((one.label, other.label, volume))
    return found


def by_clearance(body):
    """Design with the mean clearance of its fit, which masses have, as a number."""
    clearance = 1e3 * CrankPlanetaryRequest(**body).design.known_clearance
    contact = {name: value for name, value in body["contact"].items() if name != "fit"}
    return body | {"contact": contact | {"hole_clearance_mm": clearance}}


def main():
    """Check all examples."""
    inputs = {each["id"]: each["input"] for each in EXAMPLES}
    for name in WHOLE:
        body = by_clearance(inputs[name])
        design = CrankPlanetaryRequest(**body).design
        with tempfile.TemporaryDirectory() as folder:
            begun = time.process_time()
            module = module_of(write(SolidsRequest(design=body)).content, Path(folder))
            reducer = module.reducer()
            step = Path(folder, "reducer.step")
            export_step(reducer, step)
            taken = time.process_time() - begun
            read = import_step(step)
            size = step.stat().st_size
        answered = read_step(step_file(SolidsRequest(design=body)).content)
        assert len(answered.solids()) == len(read.solids())
        assert math.isclose(answered.volume, read.volume, rel_tol=1e-12)
        parts = list(reducer.children)
        print(f"{name}: {len(parts)} solids, {taken:.1f} s, {size / 1e6:.1f} MB")
        assert len(read.solids()) == len(parts)
        assert all(each.is_valid for each in read.solids())
        assert sorted(each.label for each in read.children) == sorted(each.label for each in parts)
        whole_volume = sum(each.volume for each in parts)
        assert math.isclose(sum(each.volume for each in read.solids()), whole_volume, rel_tol=1e-9)
        check_volumes(parts, design)
        check_holes(parts, design)
        assert meeting(parts) == []


if __name__ == "__main__":
    main()
