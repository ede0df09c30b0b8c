"""Drives of a ring on its discs, and of both meshes in series, as the engine takes them."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.model import FLOATS, Contacts, Pieces, pieces_of
from core.output.conformal_law import NO_CURVE, NO_WRAP
from core.output.elasticity import law_curve, law_kind
from core.output.loop_rows import CONFORMAL, HERTZ_END, LINEAR, POWER, Curve, Law, Wrap


class Cranks(NamedTuple):
    """Deviations of the cranks and discs of pieces."""

    eccentricity: FloatArray  # m, shape (S, K)
    phase: FloatArray  # rad, shape (S, K)
    disc_phase: FloatArray  # by which holes are ahead of teeth, rad, shape (S, K)


class PinErrors(NamedTuple):
    """Deviations of the output pins and holes of pieces."""

    pin_radial: FloatArray  # m, shape (S, N)
    pin_tangential: FloatArray  # m, shape (S, N)
    pin_radius: FloatArray  # m, shape (S, N)
    hole_radial: FloatArray  # m, shape (S, K, N)
    hole_tangential: FloatArray  # m, shape (S, K, N)
    hole_radius: FloatArray  # m, shape (S, K, N)


class LobeErrors(NamedTuple):
    """Deviations of the ring's pins of pieces, and what their discs are cut with."""

    radial: FloatArray  # m, shape (S, z_p)
    tangential: FloatArray  # m, shape (S, z_p)
    radius: FloatArray  # m, shape (S, z_p)
    tool: FloatArray  # as `tool_of`, shape (S, 4)


def tool_of(disc: Any) -> tuple[float, float, float, float]:
    """Sizes that a disc is cut with: R_m, r_m, equidistant and pin circle of its modification.

    Parameters
    ----------
    disc : CycloidDisc
        The disc.

    Returns
    -------
    tuple of float
        m.
    """
    own = disc.modification
    return disc.tool_circle_radius, disc.tool_radius, own.equidistant, own.pin_circle


def _table(curve: Curve, wrap: Wrap) -> FloatArray:
    """Constants of contacts that wrap, see `engine.over_width`."""
    given = curve.modulus, curve.widest, len(curve.powers), *curve.powers
    return np.array([*given, wrap.modulus, wrap.since, wrap.widest, *wrap.powers])


def _line(law: Law, pin: FloatArray, reduced: Any) -> tuple[Any, float, FloatArray]:
    """Constants a and b of Hertz's line contact at a reduced radius, m, and the force at which it
    ends: see `core.output.contact_kernel.line_law`.
    """
    q, b = law.quarter / reduced, (law.first + law.second) / law.around
    a = law.first * (np.log(16 * pin * pin * q) - 1)
    a = (a + law.second * (np.log(4 * law.depth * law.depth * q) - law.ratio)) / law.around
    limit = np.minimum(q * pin * pin, np.exp(np.minimum(a / b - HERTZ_END, 700.0)))
    return a, b, limit


def _laws(kind: int, law: Law, pin: Any, wide: Any, give: Any) -> tuple[Any, Any, Any]:
    """Constants a, b and the force at which the law ends of contacts with pins of a radius, a
    difference of the radii (None: a lobe, whose curvature the position knows), and a compliance.
    """
    if kind == LINEAR:
        return law.a + give, 0.0, math.inf
    if kind == POWER:
        return law.a, give, math.inf
    if kind == CONFORMAL:
        return law.a * wide, law.a * give, law.a * wide * law.end
    a, b, limit = _line(law, pin, 1.0 if wide is None else pin * (pin + wide) / wide)
    return a + give, b, limit


def _blank(
    stage: Any, pins: int, radius: float, errors: Sequence[FloatArray], cranks: Cranks
) -> tuple[int, FloatArray, FloatArray]:
    """Kind of the law; floats of groups and contacts with what all contacts have."""
    kind, exponent = law_kind(stage.law)
    pieces, discs = cranks.phase.shape
    gf = np.zeros((pieces, discs, FLOATS[0]))
    gf[..., engine.OFF] = cranks.eccentricity
    gf[..., engine.ECC] = stage.eccentricity + cranks.eccentricity
    gf[..., engine.EXPONENT], gf[..., engine.BASE_E] = exponent, stage.eccentricity
    gf[..., engine.CIRCLE] = radius
    beta = 2 * np.pi * np.arange(pins) / pins
    cf = np.zeros((pieces, discs, pins, FLOATS[1]))
    cf[..., engine.CB], cf[..., engine.SB] = np.cos(beta), np.sin(beta)
    cf[..., engine.PX] = radius + errors[0][:, None]
    cf[..., engine.PY] = errors[1][:, None]
    return kind, gf, cf


def _pins(output: Any, errors: PinErrors, cranks: Cranks) -> Contacts:
    """Output pins in the holes of discs, of whose phases their lags have all."""
    own = output.mechanism
    kind, gf, cf = _blank(output, own.pins, output.pin_circle_radius, errors, cranks)
    gf[..., engine.RATE], gf[..., engine.RATIO] = 1 + 1 / own.ratio, own.ratio
    gf[..., engine.PHASE] = own.initial_crank_angle + np.array(own.crank_angles) + cranks.phase
    radial, tangential, larger = (each[:, None] for each in errors[:3])
    cf[..., engine.EX] = radial - errors.hole_radial
    cf[..., engine.EY] = tangential - errors.hole_tangential
    wider = output.clearance + errors.hole_radius - larger
    loose = output.roller_play + output.support.loose
    cf[..., engine.GAP] = wider - cranks.eccentricity[..., None] + loose
    cf[..., engine.RAD] = pin = np.broadcast_to(output.pin_radius + larger, wider.shape)
    difference, give = output.eccentricity + wider, np.array(output.compliance)[:, None]
    a, b, limit = _laws(kind, output.law_constants, pin, difference, give)
    cf[..., engine.A], cf[..., engine.B], cf[..., engine.LIMIT] = a, b, limit
    cf[..., engine.CURVED] = difference / pin / (pin + difference)
    cf[..., engine.WIDER] = wider
    return Contacts(engine.PIN, kind, output.exact, gf, cf)


def _lobes(ring: Any, errors: LobeErrors, cranks: Cranks) -> Contacts:
    """The pins of a ring on the lobes of discs."""
    disc, e = ring.disc, ring.eccentricity
    circle, z = disc.ring_pin_circle_radius, disc.pins - 1
    kind, gf, cf = _blank(ring, disc.pins, circle, errors, cranks)
    tool_circle, tool, equidistant, pin_circle = errors.tool.T[..., None]
    gf[..., engine.RATE], gf[..., engine.RATIO], gf[..., engine.LOBES] = 1.0, z, disc.pins
    gf[..., engine.PHASE] = np.array(ring.crank_angles) + cranks.phase
    gf[..., engine.LATE] = cranks.disc_phase + cranks.phase / z
    gf[..., engine.TOOL_R], gf[..., engine.TOOL] = tool_circle, tool
    gf[..., engine.RADIUS] = disc.ring_pin_radius
    gf[..., engine.ROTATION] = disc.modification.rotation
    short = e * disc.pins / tool_circle
    gf[..., engine.HOLLOW] = np.maximum(z * short - 1, 0) / (tool_circle * (1 - short) ** 2)
    gf[..., engine.SHORT] = short if ring.exact else e * disc.pins / circle
    radial, tangential, larger = (each[:, None] for each in errors[:3])
    cf[..., engine.EX], cf[..., engine.EY] = radial - pin_circle[..., None], tangential
    cf[..., engine.GAP] = larger - equidistant[..., None]
    cf[..., engine.RAD] = pin = np.broadcast_to(disc.ring_pin_radius + larger, cf.shape[:-1])
    give = np.array(ring.compliance)[:, None]
    a, b, limit = _laws(kind, ring.law_constants, pin, None, give)
    cf[..., engine.A], cf[..., engine.B], cf[..., engine.LIMIT] = a, b, limit
    return Contacts(engine.LOBE, kind, ring.exact, gf, cf)


def series_pieces(*, series: Any, teeth: LobeErrors, holes: PinErrors, cranks: Cranks) -> Pieces:
    """Drives of many pieces of both meshes in series.

    Parameters
    ----------
    series : MeshesInSeries
        The nominal design.
    teeth : LobeErrors
        Deviations of the rings.
    holes : PinErrors
        Those of the output pins.
    cranks : Cranks
        Those of cranks and discs.

    Returns
    -------
    Pieces
    """
    output = series.output
    curve = law_curve(
        law=output.law,
        contact_length=output.contact_length,
        pin=output.pin_material,
        hole=output.hole_material,
    )
    return pieces_of(
        pins=_pins(output, holes, cranks),
        lobes=_lobes(series.ring, teeth, cranks),
        table=_table(curve, output.wrap),
    )


def _as_made(ring: Any) -> tuple[LobeErrors, Cranks]:
    """Deviations of one ring and its discs."""
    rows = ring.deviations.each(pins=ring.disc.pins, satellites=len(ring.crank_angles))
    given = [np.array([each]) for each in rows]
    tool = np.array([tool_of(ring.disc)])
    return LobeErrors(given[0], given[1], given[2], tool), Cranks(*given[3:])


def ring_drive(ring: Any) -> Pieces:
    """Drive of a ring and its discs as they are made.

    Parameters
    ----------
    ring : CycloidMesh
        The ring.

    Returns
    -------
    Pieces
        One.
    """
    lobes, shares = _lobes(ring, *_as_made(ring)), tuple(ring.support.given_shares)
    return pieces_of(lobes=lobes, shares=shares, table=_table(NO_CURVE, NO_WRAP))


def series_drive(series: Any) -> Pieces:
    """Drive of both meshes as they are made; discs are put onto the output pins by the holes that
    lie next to them.

    Parameters
    ----------
    series : MeshesInSeries
        Both meshes.

    Returns
    -------
    Pieces
        One.
    """
    own = series.mechanism
    teeth, _ = _as_made(series.ring)
    rows = series.output.rooms.numbered[0].rows(own.pins, own.satellites)
    given = [np.array([each]) for each in rows]
    holes = [each.reshape(1, own.satellites, -1) for each in given[3:6]]
    pins = PinErrors(given[0], given[1], given[2], *holes)
    return series_pieces(series=series, teeth=teeth, holes=pins, cranks=Cranks(*given[6:]))
