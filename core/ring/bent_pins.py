"""Forces on ring pins over the turn, for pins that bend between two supports.

A disc presses a pin along the normal of the pin's path, ``(1 - K1*cos(a), K1*sin(a))/S`` outward
and in the direction of the output's rotation; a is the angle from the crank of the disc to the pin.
Forces of several discs add as vectors.
"""

import math

import numpy as np

from core.output.sampled_turn import PinForces
from core.ring.sharing import MeshTurn


def forces_on_ring(turn: MeshTurn) -> PinForces:
    """Forces of cycloid discs on ring pins in the ring's frame, N, with normals of perfect parts.

    Largest force of a disc of 29 lobes, which agrees with a published program.

    >>> from core.materials import ElasticMaterial
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.profile import CycloidDisc
    >>> from core.ring.sharing import CycloidMesh, mesh_over_turn
    >>> disc = CycloidDisc(satellite_teeth=29, eccentricity=1.250025e-3,
    ...                    ring_pin_circle_radius=0.0525, ring_pin_radius=3.5e-3)
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.0135, exact=False,
    ...                    law=LinearLaw(1e8), pin_material=steel, disc_material=steel)
    >>> found = forces_on_ring(mesh_over_turn(mesh=mesh, output_torque=58.0))
    >>> found.on_pins.shape[:2], round(float(abs(found.on_pins).max()), 2)
    ((1, 30), 213.14)
    """
    mesh, samples = turn.mesh, turn.close
    pins, satellites = mesh.disc.pins, len(mesh.crank_angles)
    phases = np.array(mesh.phases)[:, None, None]
    ring = 2 * math.pi * np.arange(pins)[:, None] / pins
    turned = np.exp(1j * (phases + ring)) * np.exp(1j * samples.wave)
    outward = 1 - mesh.disc.shortening_coefficient * turned
    force = samples.force.reshape(satellites, pins, -1)
    return PinForces(
        wave=samples.wave,
        on_pins=1j * force * outward / np.abs(outward),
        error=samples.error,
        evaluations=samples.evaluations,
        unlike=1 if mesh.pins_alike else pins,
    )
