"""Drives of a ring on its discs, and of both meshes in series, as the engine takes them."""

from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.model import Contacts, Pieces, pieces_of
from core.output.conformal_law import NO_CURVE, NO_WRAP, table_of
from core.output.drives import Cranks, blank, in_series, journals, output_pins
from core.output.elasticity import pair_law
from core.output.room import Errors


class LobeErrors(NamedTuple):
    """Deviations of the ring pins of S pieces, and sizes of the tools of their discs."""

    radial: FloatArray  # m, shape (S, z_p)
    tangential: FloatArray  # m, shape (S, z_p)
    radius: FloatArray  # m, shape (S, z_p)
    tool: FloatArray  # values of `tool_of`, m, shape (S, 4)


def tool_of(disc: Any) -> tuple[float, float, float, float]:
    """R_m, r_m, equidistant and pin_circle that a disc is cut with, m."""
    own = disc.modification
    return disc.tool_circle_radius, disc.tool_radius, own.equidistant, own.pin_circle


def _lobes(ring: Any, errors: LobeErrors, cranks: Cranks) -> Contacts:
    """Contacts of the ring pins with the lobes of the discs."""
    disc, e = ring.disc, ring.eccentricity
    circle, z = disc.ring_pin_circle_radius, disc.pins - 1
    kind, gf, cf = blank(stage=ring, pins=disc.pins, radius=circle, errors=errors, cranks=cranks)
    tool_circle, tool, equidistant, pin_circle = errors.tool.T[..., None]
    gf[..., engine.RATE], gf[..., engine.RATIO], gf[..., engine.LOBES] = 1.0, z, disc.pins
    gf[..., engine.PHASE] = np.array(ring.crank_angles) + cranks.phase
    gf[..., engine.LATE] = cranks.disc_phase + cranks.phase / z
    gf[..., engine.TOOL_R], gf[..., engine.TOOL] = tool_circle, tool
    gf[..., engine.RADIUS] = disc.ring_pin_radius
    gf[..., engine.ROTATION] = disc.modification.rotation
    short = e * disc.pins / tool_circle
    hollow = disc.pins * short - 1
    gf[..., engine.HOLLOW] = np.maximum(hollow, 0) / (tool_circle * (1 - short) ** 2)
    gf[..., engine.SHORT] = short if ring.exact else e * disc.pins / circle
    radial, tangential, larger = (each[:, None] for each in errors[:3])
    cf[..., engine.EX], cf[..., engine.EY] = radial - pin_circle[..., None], tangential
    cf[..., engine.GAP] = larger - equidistant[..., None]
    cf[..., engine.RAD] = pin = np.broadcast_to(disc.ring_pin_radius + larger, cf.shape[:-1])
    give = np.array(ring.compliance)[:, None]
    a, b, limit = pair_law(kind=kind, law=ring.law_constants, pin=pin, wide=None, give=give)
    cf[..., engine.A], cf[..., engine.B], cf[..., engine.LIMIT] = a, b, limit
    return Contacts(engine.LOBE, kind, ring.exact, gf, cf)


def series_pieces(*, series: Any, teeth: LobeErrors, errors: Errors[FloatArray]) -> Pieces:
    """Drives of many pieces of both meshes in series, from nominal design and deviations."""
    output = series.output
    pins = in_series(pins=output_pins(output=output, errors=errors), output=output)
    return pieces_of(
        pins=pins,
        journals=journals(pins=pins, output=output),
        lobes=_lobes(series.ring, teeth, Cranks(*errors[6:])),
        springs=output.springs,
        table=output.table,
    )


def _as_made(ring: Any) -> tuple[LobeErrors, Cranks]:
    """Deviations of one ring and its discs, as arrays of one piece."""
    rows = ring.deviations.each(pins=ring.disc.pins, satellites=len(ring.crank_angles))
    given = [np.array([each]) for each in rows]
    tool = np.array([tool_of(ring.disc)])
    return LobeErrors(given[0], given[1], given[2], tool), Cranks(*given[3:])


def ring_drive(ring: Any) -> Pieces:
    """Drive of one ring and its discs as they are made."""
    lobes, shares = _lobes(ring, *_as_made(ring)), tuple(ring.support.given_shares)
    return pieces_of(lobes=lobes, shares=shares, table=table_of(curve=NO_CURVE, wrap=NO_WRAP))


def series_drive(series: Any) -> Pieces:
    """Drive of both meshes as made; holes are numbered as discs come onto the output pins."""
    teeth, _ = _as_made(series.ring)
    return series_pieces(series=series, teeth=teeth, errors=series.output.errors)
