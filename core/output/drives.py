"""Drives of discs on output pins, as the engine takes them."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.model import FLOATS, Contacts, Pieces, pieces_of
from core.output.elasticity import law_kind, pair_law
from core.output.room import Errors

HARD_BEARING = 50.0
"""Stiffness of a bearing between both meshes that is rigid and has clearance, over the modulus of
the softer body of pins and holes times the length of their contact: a contact's is about one such.
"""


class Cranks(NamedTuple):
    """Deviations of the cranks and discs of pieces."""

    eccentricity: FloatArray  # m, shape (S, K)
    phase: FloatArray  # rad, shape (S, K)
    disc_phase: FloatArray  # by which holes are ahead of teeth, rad, shape (S, K)


def blank(
    *, stage: Any, pins: int, radius: float, errors: Sequence[FloatArray], cranks: Cranks
) -> tuple[int, FloatArray, FloatArray]:
    """Kind of the law; floats of groups and contacts with what all contacts have.

    Parameters
    ----------
    stage : RealMechanism or CycloidMesh
        The nominal design.
    pins : int
        Number of pins on the circle.
    radius : float
        Of that circle, m.
    errors : sequence of array, shape (S, pins)
        By which pins lie outward and as the output turns, m.
    cranks : Cranks
        Deviations of the cranks.

    Returns
    -------
    kind : int
        Of the law.
    gf : array, shape (S, K, 16)
    cf : array, shape (S, K, pins, 13)
    """
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


def output_pins(*, output: Any, errors: Errors[FloatArray]) -> Contacts:
    """Output pins in the holes of discs that do not turn; their phase counts from the wave.

    Parameters
    ----------
    output : RealMechanism
        The nominal design.
    errors : Errors of array
        Deviations of pieces, a row for each.

    Returns
    -------
    Contacts
    """
    own, cranks = output.mechanism, Cranks(*errors[6:])
    kind, gf, cf = blank(
        stage=output,
        pins=own.pins,
        radius=output.pin_circle_radius,
        errors=errors,
        cranks=cranks,
    )
    gf[..., engine.RATE], gf[..., engine.RATIO] = 1.0, own.ratio
    gf[..., engine.PHASE] = np.array(own.crank_angles) + cranks.phase
    gf[..., engine.LATE] = -(cranks.disc_phase + cranks.phase / own.ratio)
    radial, tangential, larger = (each[:, None] for each in errors[:3])
    holes = [each.reshape(len(each), own.satellites, own.pins) for each in errors[3:6]]
    cf[..., engine.EX], cf[..., engine.EY] = radial - holes[0], tangential - holes[1]
    wider = output.clearance + holes[2] - larger
    loose = output.roller_play + output.support.loose
    cf[..., engine.GAP] = wider - cranks.eccentricity[..., None] + loose
    cf[..., engine.RAD] = pin = np.broadcast_to(output.pin_radius + larger, wider.shape)
    difference, give = output.eccentricity + wider, np.array(output.compliance)[:, None]
    with np.errstate(invalid="ignore", divide="ignore"):  # of pieces that have no size
        a, b, limit = pair_law(
            kind=kind, law=output.law_constants, pin=pin, wide=difference, give=give
        )
        cf[..., engine.CURVED] = difference / pin / (pin + difference)
    cf[..., engine.A], cf[..., engine.B], cf[..., engine.LIMIT] = a, b, limit
    cf[..., engine.WIDER] = wider
    return Contacts(engine.PIN, kind, output.exact, gf, cf)


def in_series(*, pins: Contacts, output: Any) -> Contacts:
    """Output pins in the holes of discs that turn in a ring, of whose phases their lags have all;
    their phase counts from the crank. Bearings whose clearance is no contact's let discs float.

    Parameters
    ----------
    pins : Contacts
        As `output_pins` gives them.
    output : RealMechanism
        The nominal design.

    Returns
    -------
    Contacts
    """
    gf, cf, own = pins.gf.copy(), pins.cf.copy(), output.mechanism
    cf[..., engine.GAP] -= output.support.loose
    gf[..., engine.RATE], gf[..., engine.LATE] = 1 + 1 / own.ratio, 0.0
    gf[..., engine.PHASE] += own.initial_crank_angle
    return pins._replace(gf=gf, cf=cf)


def journals(*, pins: Contacts, output: Any) -> Contacts | None:
    """Cranks in the bearings of discs that float there between output pins and a ring.

    Parameters
    ----------
    pins : Contacts
        As `in_series` gives them.
    output : RealMechanism
        The nominal design.

    Returns
    -------
    Contacts or None
        None without a clearance.
    """
    support = output.support
    if not support.loose:
        return None
    gf, cf = pins.gf.copy(), np.zeros((*pins.gf.shape[:2], 1, FLOATS[1]))
    gf[..., engine.ECC] = gf[..., engine.OFF] = 0.0
    cf[..., [engine.CB, engine.RAD]], cf[..., engine.GAP] = 1.0, support.loose
    soft = min(output.pin_material.youngs_modulus, output.hole_material.youngs_modulus)
    hard = HARD_BEARING * soft * output.contact_length
    cf[..., engine.A], cf[..., engine.LIMIT] = 1 / (support.bearing or hard), np.inf
    return Contacts(engine.JOURNAL, engine.LINEAR, pins.exact, gf, cf)


def output_pieces(*, output: Any, errors: Errors[FloatArray]) -> Pieces:
    """Drives of many pieces of an output mechanism.

    Parameters
    ----------
    output : RealMechanism
        The nominal design.
    errors : Errors of array
        Deviations of the pieces, a row for each.

    Returns
    -------
    Pieces
    """
    return pieces_of(
        pins=output_pins(output=output, errors=errors),
        shares=tuple(output.support.given_shares),
        springs=output.springs,
        table=output.table,
    )
