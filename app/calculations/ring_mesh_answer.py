"""Answer about the mesh of satellites with ring pins or involute ring teeth."""

from typing import Any, Literal

import numpy as np

from app.calculations.involute_teeth import InvoluteGeometryOut, InvoluteStressesOut
from app.calculations.load_sharing_answer import LagTurnOut, StiffnessCurveOut
from app.calculations.mechanism import PairOut
from app.model import (
    AccuracyOut,
    DocumentResponse,
    Maybe,
    ResponseModel,
    Values,
    WarningOut,
    result,
)
from app.units import from_si, rounded
from core.crank.ring_mesh import cycloid_mesh
from core.design.drawings import MadeRingPin, RingDrawing
from core.ring.loss import RingLoss
from core.ring.profile import CycloidDisc, OutlinePoints
from core.ring.shared_pairs import PairsThatCarry
from core.ring.sharing import IdealMesh, MeshPosition, MeshTurn, ideal_mesh

DRAWN_DIGITS = 6
"""Digits of drawn values, relative to the largest of a kind."""


class RingGeometryOut(ResponseModel, of=CycloidDisc):
    """Discs by their sizes alone."""


class RingIdealOut(ResponseModel, of=IdealMesh):
    """Perfect parts on many pins, contacts linear, in closed form."""

    BESIDE = ("radial_force_ratio",)

    radial_force_ratio: float = result(
        "Force of the ring along the crank over that across it; negative outwards.", symbol="ρ"
    )

    @classmethod
    def of(cls, disc: CycloidDisc, disc_torque: float) -> dict[str, object]:
        """Values of perfect discs of these sizes, each under a torque, N*m."""
        ratio = cycloid_mesh(
            eccentricity=disc.eccentricity,
            ratio=float(disc.satellite_teeth),
            ring_pin_circle_radius=disc.ring_pin_circle_radius,
        ).radial_force_ratio
        return cls.values(ideal_mesh(disc=disc, disc_torque=disc_torque), radial_force_ratio=ratio)


class MeshPositionOut(ResponseModel, of=MeshPosition):
    """Mesh at one crank angle under load."""

    BESIDE = ("sliding_speed_m_per_s", "loss_per_friction", "pressed_without_load")

    play_arcmin: Maybe[list[float]]
    pressed_without_load: Maybe[bool] = result("True if pairs press without load.")
    sliding_speed_m_per_s: Maybe[float] = result(
        "Largest sliding speed of a loaded disc on a ring pin at rest, if the speed is known.",
        symbol="v_s",
    )
    loss_per_friction: float = result(
        "Power loss over output power for a friction coefficient of 1.",
        equation="ΣF·|R_p·S − r|·c/T",
    )


OF_BOTH_MESHES = (
    *("transmission_error", "unloaded_transmission_error", "backlash_max", "backlash_min"),
    *("lost_motion", "stiffness_min", "stiffness_max", "input_torque_ripple"),
)
"""Quantities of a turn that belong to both meshes if these are in series."""


class TeethTurnOut(ResponseModel, of=MeshTurn, without=OF_BOTH_MESHES):
    """Ring teeth over the turn, with both meshes in series: forces, pressures and lags of the discs
    in the common solution. Play, stiffness and transmission error are of both meshes and are in
    `load_sharing`. The accuracy is that of the largest pressure.
    """

    peak_pair: PairOut = result("Satellite and ring pin with the largest force.")


class MeshTurnOut(LagTurnOut, TeethTurnOut):
    """Extremes over the turn of the crank; the accuracy of the answer is that of the peak force."""

    backlash_max_arcmin: float = result(
        "Largest play of the unloaded discs, 0 if pairs press without load.", symbol="θ₊ − θ₋"
    )
    backlash_min_arcmin: float = result("Least play of the unloaded discs.", symbol="θ₊ − θ₋")
    lost_motion_arcmin: float = result(
        "Largest rotation of the discs between the two directions of a share of the torque.",
        equation="θ(+3 % T) − θ(−3 % T)",
    )
    input_torque_ripple_Nm: float = result(
        "Ripple of the input torque without friction: largest less least torque that turns the "
        "crank.",
        equation="T/u + ΣF·∂δ/∂φ",
    )


class RingEfficiencyOut(ResponseModel, of=RingLoss):
    """Friction of the mesh over the turn, if its coefficient is known."""


class ProfileOut(ResponseModel):
    """Outline of a disc as a closed polygon about its centre, clockwise from the valley that faces
    the crank at crank angle 0.
    """

    BESIDE = ("points", "closed")

    chord_error_mm: float = result("Largest distance of the outline from the polygon.")
    closed: bool = result("Always true: the first point follows the last one and is not repeated.")
    points: list[list[float]] = result("Points x, y, mm.")

    @classmethod
    def of(cls, points: OutlinePoints) -> dict[str, object]:
        """The values of an outline."""
        found = from_si("points_mm", points.points)
        return cls.values(points, closed=True, points=found.tolist())


class RingPinOut(ResponseModel, of=MadeRingPin):
    """Ring pin as it is made."""


class RingDrawingOut(ResponseModel, of=RingDrawing):
    """Satellites and ring as they are drawn (Y up through output pin 1 at crank angle 0, X right):
    outline and place of a disc, and curves of its pins over the turn of the crank.
    """

    @classmethod
    def values(cls, result: RingDrawing, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a drawing, with digits that can be seen."""
        found = super().values(result, run_time_us, **given)
        exact = ("repeats_after_deg", "pins_further", "ring_pins")
        short = {name: _short(each) for name, each in found.items() if name not in exact}
        pins = found.get("ring_pins", ())
        for name in ("centre_mm", "radius_mm") if pins else ():
            for pin, each in zip(pins, _short([pin[name] for pin in pins]), strict=True):
                pin[name] = each
        return found | short


def _short(values: Any) -> Any:
    return rounded(np.array(values), DRAWN_DIGITS).tolist()


class SharedPairsOut(ResponseModel, of=PairsThatCarry):
    """Number of pairs of perfect involute teeth that carry over a pitch, for information: pitch
    errors of some microns remove most of this sharing, and stresses are those of one pair.
    """


class DesignMeshOut(ResponseModel):
    """Mesh of cycloid discs and ring in a whole design, under the torque without its factor."""

    BESIDE = ("geometry", "torque_direction", "ideal", "over_turn", "efficiency")

    geometry: RingGeometryOut
    torque_direction: Literal["driving", "reverse"] = result(
        "Direction of the torque that is shown; with an alternating torque the one with the "
        "larger pressure."
    )
    ideal: RingIdealOut
    over_turn: MeshTurnOut | TeethTurnOut
    efficiency: Maybe[RingEfficiencyOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


class DesignPairOut(ResponseModel):
    """Mesh of involute teeth in a whole design, for the satellite with the largest torque."""

    satellite_torque_Nm: float = result(
        "Largest torque of a satellite over the turn under the dynamic load, divided by the "
        "dynamic factor.",
        symbol="T_j",
    )
    geometry: InvoluteGeometryOut
    stresses: InvoluteStressesOut
    shared_pairs: Maybe[SharedPairsOut] = result(
        "Number of pairs that carry, if teeth do not interfere."
    )
    efficiency: Maybe[RingEfficiencyOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


class RingMeshResponse(DocumentResponse):
    """Requested sections."""

    kind: Literal["cycloid", "involute"] = result("Kind of the ring.")
    geometry: RingGeometryOut | InvoluteGeometryOut
    stresses: Maybe[InvoluteStressesOut] = None
    shared_pairs: Maybe[SharedPairsOut] = None
    ideal: Maybe[RingIdealOut] = None
    positions: Maybe[list[MeshPositionOut]] = None
    over_turn: Maybe[MeshTurnOut] = None
    efficiency: Maybe[RingEfficiencyOut] = None
    stiffness_curve: Maybe[StiffnessCurveOut] = None
    profile: Maybe[ProfileOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None
