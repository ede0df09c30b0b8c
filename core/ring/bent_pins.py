"""Bending of ring pins that are held at both ends, by the forces of all discs over the turn.

A disc presses a pin along the normal of its path, ``(1 - K1*cos(a), K1*sin(a))/S`` outward and as
the output turns, a being the angle from its crank to the pin. What several discs do at once adds as
vectors.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.output.pin_beam import PinBeam, section_stress
from core.output.sharing_kernel import Row
from core.ring.sharing import MeshTurn

SECTIONS = 65
"""Sections of a pin at which is looked, between its supports."""


@dataclass(frozen=True, slots=True)
class BentRingPins:
    """The pin of a ring that bends most, over the turn."""

    stress: float  # largest equivalent stress, Pa
    pin: int  # which pin has it, from 1
    slope: float  # largest rotation of a section in the middle of a disc, rad
    relative_error: float  # of both, an estimate: that of the forces, and of the sections


def bent_ring_pins(*, turn: MeshTurn) -> BentRingPins:
    """Stress and slope of ring pins that are held at both ends.

    Parameters
    ----------
    turn : MeshTurn
        The mesh under its torque, whose pins bend.

    Returns
    -------
    BentRingPins

    Notes
    -----
    Euler's beam with shear, each load even over the length of its contact; stresses as of output
    pins. The normals are those of perfect parts.
    """
    mesh = turn.mesh
    pin, disc = mesh.pin, mesh.disc
    assert pin is not None and pin.span is not None
    beam = PinBeam.round(
        support=pin.support,
        diameter=pin.diameter,
        contact_length=mesh.contact_length,
        youngs_modulus=pin.material.youngs_modulus,
        poissons_ratio=pin.material.poissons_ratio,
        span=pin.span,
    )
    wave, every = turn.samples
    pins, satellites = disc.pins, len(mesh.crank_angles)
    force = every.reshape(-1, satellites, pins) * _normals(
        wave, mesh.pairs.phase[:satellites], pins, disc.shortening_coefficient
    )
    places = np.array(pin.satellite_positions)
    x = np.unique(np.concatenate((np.linspace(0.0, pin.span, SECTIONS), places)))
    bending = np.array([beam.moment(x, z) for z in places]) / pin.section.modulus
    sheared = np.array([beam.shear(x, z) for z in places]) / pin.section.shear_area
    turned = np.array([beam.slope(places, z) for z in places])
    stress = [
        float(
            np.max(section_stress(bending=each @ bending, mean_shear=each @ sheared))  # of a pin
        )
        for each in np.moveaxis(force, 2, 0)
    ]
    worst, missed = int(np.argmax(stress)), turn.peak_force / float(every.max()) - 1
    return BentRingPins(
        stress=stress[worst],
        pin=worst + 1,
        slope=float(np.abs(np.einsum("njk,jx->nkx", force, turned)).max()),
        relative_error=turn.accuracy.relative_error + missed + (math.pi / SECTIONS) ** 2,
    )


def _normals(wave: FloatArray, phase: Row, pins: int, k: float) -> FloatArray:
    """Normals of the pairs, outward and along the circle of the pins, [n, K, z_p] complex."""
    ring = 2 * math.pi * np.arange(pins) / pins
    angle = wave[:, None, None] + np.array(phase)[:, None] + ring
    outward = 1 - k * np.exp(-1j * angle)
    normals: FloatArray = outward / np.abs(outward)
    return normals
