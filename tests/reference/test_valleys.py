"""Pins that stand further off than the valleys of a disc are round, against the disc as it is cut:
the forces at the lag that is found carry the torque, and their sums are those on the crank.
"""

import math
from typing import Any

import numpy as np
import pytest

from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.precision import JUDGED, SEARCHED
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries, series_position
from core.ring.sharing import CycloidMesh, mesh_position
from tests.inputs.real_mechanisms import STEEL
from tests.inputs.ring_meshes import ARCMIN
from tests.inputs.valleys import narrow
from tests.oracles.cut_disc import CutDisc
from tests.oracles.seeds import seeds

KINDS = ("equidistant", "pin_circle", "both", "errors", "pressed", "wide_pin")


def same(mesh: CycloidMesh, angle: float, found: Any) -> np.ndarray:
    """The numbers of contacts of each pin, where a disc is found in its ring as it must be."""
    disc, stiffness = CutDisc(mesh, angle), mesh.law.stiffness  # type: ignore[union-attr]
    there = disc.contacts(found.rotation[0])
    force, most = stiffness * there.approach, np.zeros(disc.pins)
    np.maximum.at(most, there.pin, force)
    size = SEARCHED * force.sum()
    assert found.force[0] == pytest.approx(most, abs=size)
    lever = mesh.eccentricity * disc.lobes
    assert found.disc_torque[0] == pytest.approx(force @ there.lever, abs=size * lever)
    on_crank = (force * there.way).sum()
    assert found.crank_along[0] == pytest.approx(on_crank.real, abs=size)
    assert found.crank_across[0] == pytest.approx(-on_crank.imag, abs=size)
    return np.bincount(there.pin)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", seeds(4))
def test_against_the_disc_as_it_is_cut(seed: int, kind: Any) -> None:
    """A pin presses both flanks of a valley only where it is wider than the tool, by more than the
    valley is round, and presses without load.
    """
    mesh, angle, torque = narrow(seed, kind)
    found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
    contacts = same(mesh, angle, found)
    assert sum(found.disc_torque) == pytest.approx(torque, rel=SEARCHED)
    assert (found.play is None) >= (contacts.max() > 1)
    if kind == "wide_pin":
        assert contacts.max() == 2


@pytest.mark.parametrize(
    ("lobes", "circle", "pin", "eccentricity", "gap", "torque", "angle", "lag", "peak"),
    [
        (20, 18.0, 1.5, 0.75, 0.05, 2.8, 17.19, 17.0768, 47.9019),
        (39, 25.5, 1.0014, 0.5007, 0.1, 1.45, 0.0, 19.3322, 18.8525),
        (30, 26.5, 1.5, 0.75, 0.02, 2.6, 10.0, 4.68832, 21.2975),
    ],
)
def test_printed_drives(
    lobes: int,
    circle: float,
    pin: float,
    eccentricity: float,
    gap: float,
    torque: float,
    angle: float,
    lag: float,
    peak: float,
) -> None:
    """Public designs, linear contacts of 2000 N/mm; the first was 9 % off in first order. Numbers
    of a brute search over outlines of 120,000 points and more by others.
    """
    change = Modification(gap * 1e-3)
    disc = CycloidDisc(lobes, eccentricity * 1e-3, circle * 1e-3, pin * 1e-3, change)
    mesh = CycloidMesh(
        disc=disc,
        crank_angles=(0.0,),
        contact_length=0.004,
        law=LinearLaw(2e6),
        pin_material=STEEL,
        disc_material=STEEL,
    )
    place = math.radians(angle)
    found = mesh_position(mesh=mesh, crank_angle=place, output_torque=torque)
    same(mesh, place, found)
    assert found.rotation[0] / ARCMIN == pytest.approx(lag, rel=JUDGED)
    assert max(found.force[0]) == pytest.approx(peak, rel=JUDGED)


@pytest.mark.parametrize("kind", KINDS)
def test_in_series_with_the_output(kind: Any) -> None:
    """The ring's part of both meshes."""
    mesh, angle, torque = narrow(1, kind)
    disc = mesh.disc
    output = RealMechanism(
        mechanism=Mechanism(6, (0.0,), float(disc.satellite_teeth)),
        pin_circle_radius=0.6 * disc.ring_pin_circle_radius,
        pin_radius=2 * disc.eccentricity,
        eccentricity=disc.eccentricity,
        contact_length=0.01,
        law=LinearLaw(1e8),
        pin_material=STEEL,
        hole_material=STEEL,
        clearance=1e-6,
    )
    real = MeshesInSeries(mesh, output)
    found = series_position(real=real, crank_angle=angle, output_torque=torque)
    contacts = same(mesh, angle, found.ring)
    assert max(map(max, found.ring.force)) > 0
    if kind == "wide_pin":
        assert contacts.max() == 2
