"""Discs on output pins as groups and contacts of the engine."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.model import FLOATS, Contacts, Pieces, pieces_of
from core.output.elasticity import law_kind, pair_law
from core.output.room import Errors

HARD_BEARING = 50.0
"""Stiffness that stands for a rigid bearing with clearance between both meshes, over the contact
length times Young's modulus of the softer of pin and hole; a contact has about 1."""


class Cranks(NamedTuple):
    """Deviations of the cranks of S pieces with K discs each."""

    eccentricity: FloatArray  # m, shape (S, K)
    phase: FloatArray  # rad, shape (S, K)
    disc_phase: FloatArray  # lead of the holes over the teeth, rad, shape (S, K)


def blank(
    *, stage: Any, pins: int, radius: float, errors: Sequence[FloatArray], cranks: Cranks
) -> tuple[int, FloatArray, FloatArray]:
    """Kind of the contact law, and floats of groups and contacts with what all contacts have.

    The stage is the nominal design, a `RealMechanism` or a `CycloidMesh`; errors are radial and
    tangential ones of the pins' places, m, outward and as the output turns, shape (S, pins). Floats
    have the shapes (S, K, 16) and (S, K, pins, 13).
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
    """Output pins in holes of discs that do not turn; phases count from the wave angle."""
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
    with np.errstate(invalid="ignore", divide="ignore"):  # pieces may have no size
        a, b, limit = pair_law(
            kind=kind, law=output.law_constants, pin=pin, wide=difference, give=give
        )
        cf[..., engine.CURVED] = difference / pin / (pin + difference)
    cf[..., engine.A], cf[..., engine.B], cf[..., engine.LIMIT] = a, b, limit
    cf[..., engine.WIDER] = wider
    return Contacts(engine.PIN, kind, output.exact, gf, cf)


def in_series(*, pins: Contacts, output: Any) -> Contacts:
    """Contacts of `output_pins` for discs that also mesh with a ring; phases count from the crank.

    Phase errors of the discs are in their lags. Clearance of the crank bearings is left to
    `journals`, in which the discs float.
    """
    gf, cf, own = pins.gf.copy(), pins.cf.copy(), output.mechanism
    cf[..., engine.GAP] -= output.support.loose
    gf[..., engine.RATE], gf[..., engine.LATE] = 1 + 1 / own.ratio, 0.0
    gf[..., engine.PHASE] += own.initial_crank_angle
    return pins._replace(gf=gf, cf=cf)


def journals(*, pins: Contacts, output: Any) -> Contacts | None:
    """Cranks in bearings of discs that float between output pins and a ring; None without
    clearance.

    `pins` are the contacts that `in_series` gives.
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
    """Drives of many pieces of an output mechanism; `errors` has one row for each piece."""
    return pieces_of(
        pins=output_pins(output=output, errors=errors),
        shares=tuple(output.support.given_shares),
        springs=output.springs,
        table=output.table,
    )
