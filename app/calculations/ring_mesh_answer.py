"""Answer about the mesh of satellites with ring pins or involute ring teeth."""

from typing import Literal

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
    present,
    result,
)
from app.units import from_si, rounded
from core.crank.ring_mesh import cycloid_mesh
from core.design.drawings import DrawnMesh, DrawnTeeth
from core.ring.mesh_curves import MeshCurves, SeriesCurves
from core.ring.profile import CycloidDisc, OutlinePoints
from core.ring.sharing import ideal_mesh

DRAWN_DIGITS = 6
"""Digits of drawn values, relative to the largest of a kind."""


class RingGeometryOut(ResponseModel):
    """Discs by their sizes alone."""

    shortening_coefficient: float = result(
        "Shortening coefficient e·z₃/R_p of the ring pins.", symbol="K₁"
    )
    min_path_radius_mm: float = result(
        "Least convex radius of curvature of the tool's path.", symbol="ρ_min"
    )
    undercut_margin: float = result(
        "Least convex radius of the tool's path over the radius of the tool; at 1 or below the "
        "tool cuts off a part of the flanks.",
        symbol="ρ_min/r_m",
    )
    tip_radius_mm: float = result("Largest radius of a disc.", symbol="R_m + e − r_m")
    root_radius_mm: float = result("Least radius of a disc.", symbol="R_m − e − r_m")
    min_concave_radius_mm: Maybe[float] = result(
        "Least concave radius of curvature of a disc; the wheel that grinds the valleys has to "
        "be smaller."
    )


class RingIdealOut(ResponseModel):
    """Perfect parts on many pins, contacts linear, in closed form."""

    BESIDE = ("radial_force_ratio",)

    peak_force_N: float = result("Largest force of a pin, 4T_j/(K₁·z₂·R_p).", symbol="F_max")
    mean_sum_force_N: float = result(
        "Mean over the turn of the sum of forces on a disc, 4T_j/(π·e·z₂).", symbol="ΣF"
    )
    backlash_arcmin: Maybe[float] = result(
        "Play caused by the modification alone; absent if the modification makes the mesh jam.",
        symbol="2(Δ_e − Δ_p·q)/(e·z₂)",
    )
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


class MeshPositionOut(ResponseModel):
    """Mesh at one crank angle under load."""

    BESIDE = ("sliding_speed_m_per_s", "loss_per_friction", "pressed_without_load")

    crank_angle_deg: float = result("Crank angle.", symbol="φ")
    rotation_arcmin: list[float] = result(
        "Lag of each disc's teeth behind their ideal angle, including clearance; negative in "
        "reverse. The lag of a rigid output is the same.",
        symbol="θ_j",
    )
    force_N: list[list[float]] = result(
        "Force of each ring pin, as one list per satellite.", symbol="F_jk"
    )
    disc_torque_Nm: list[float] = result(
        "Torque of the forces about each disc's centre.", symbol="T_j", equation="ΣF·h"
    )
    crank_across_N: list[float] = result(
        "Force of the ring on each disc against the turning of its crank.", symbol="W_j"
    )
    crank_along_N: list[float] = result(
        "Force of the ring on each disc along its crank, to the axis."
    )
    loaded_pairs: int = result("Number of pairs with a force.")
    play_arcmin: Maybe[list[float]] = result(
        "Least and largest lag of the unloaded discs; absent if pairs press without load.",
        symbol="θ₋, θ₊",
    )
    pressed_without_load: Maybe[bool] = result("True if pairs press without load.")
    interference_mm: Maybe[float] = result(
        "Least possible value of the largest approach of the unloaded pairs, if pairs press "
        "without load.",
        symbol="δ",
    )
    stiffness_Nm_per_arcmin: float = result(
        "Torsional stiffness of the mesh alone: slope of the torque over the rotation.",
        symbol="dT/dθ",
    )
    max_pressure_MPa: float = result(
        "Largest Hertz pressure of the pairs.", symbol="p_0", equation="Johnson 4.2"
    )
    sliding_speed_m_per_s: Maybe[float] = result(
        "Largest sliding speed of a loaded disc on a ring pin at rest, if the speed is known.",
        symbol="v_s",
    )
    loss_per_friction: float = result(
        "Power loss over output power for a friction coefficient of 1.",
        equation="ΣF·|R_p·S − r|·c/T",
    )


class TeethTurnOut(ResponseModel):
    """Ring teeth over the turn, with both meshes in series: forces, pressures and lags of the discs
    in the common solution. Play, stiffness and transmission error are of both meshes and are in
    `load_sharing`. The accuracy is that of the largest pressure.
    """

    peak_force_N: float = result("Largest force of all pairs over the turn.", symbol="F_max")
    peak_force_ratio: float = result("Largest force of all pairs over that of perfect parts.")
    peak_crank_angle_deg: float = result("First crank angle with the largest force.", symbol="φ")
    peak_pair: PairOut = result("Satellite and ring pin with the largest force.")
    lag_min_arcmin: float = result(
        "Least lag of a disc under load; negative in reverse.", symbol="θ"
    )
    lag_max_arcmin: float = result("Largest lag of a disc under load.", symbol="θ")
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")
    max_pressure_MPa: float = result(
        "Largest Hertz pressure over the turn.", symbol="p_0", equation="Johnson 4.2"
    )
    radial_force_ratio_min: float = result(
        "Least force of the ring along a crank, over the force across the crank of a disc that "
        "carries its even share of the torque; negative outwards."
    )
    radial_force_ratio_max: float = result(
        "Largest force of the ring along a crank, over the force across the crank of a disc "
        "that carries its even share of the torque; negative outwards."
    )
    pressed_without_load: bool = result("True if pairs press without load at any crank angle.")


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


class RingEfficiencyOut(ResponseModel):
    """Friction of the mesh over the turn, if its coefficient is known."""

    loss_per_friction: float = result(
        "Power loss over output power for a friction coefficient of 1, mean over the turn.",
        equation="ΣF·|R_p·S − r|·c/T; |τ − tan α_w| of involute teeth, over the path",
    )
    loss_ratio: float = result("Power loss over output power, mean over the turn.")
    efficiency: float = result("Efficiency of the mesh with the ring alone.", symbol="η")
    ideal_loss_ratio: Maybe[float] = result(
        "Power loss over output power of perfect parts with many pins.",
        symbol="4μ(R_p − r)/(π·e·z₂)",
    )
    mean_loss_W: Maybe[float] = result("Mean power loss, if the speed is known.")
    peak_pv_MPa_m_per_s: Maybe[float] = result(
        "Largest product of pressure and sliding speed, if the speed is known: of sleeves in "
        "their bores, else of the contact with π/4 of its Hertz pressure, for comparison only.",
        symbol="pv",
    )


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


class RingPinOut(ResponseModel):
    """Ring pin as it is made."""

    pin: int = result("Number of the pin, from 1.", symbol="k")
    centre_mm: tuple[float, float] = result("Centre of the pin, X and Y.", symbol="P_k")
    radius_mm: float = result("Radius of the pin.", symbol="r")


class RingDrawingOut(ResponseModel):
    """Satellites and ring as they are drawn (Y up through output pin 1 at crank angle 0, X right):
    outline and place of a disc, and curves of its pins over the turn of the crank.
    """

    lobe_mm: Maybe[list[list[float]]] = result(
        "Points x, y of one lobe about the disc's centre, clockwise from a valley that points "
        "up. The other lobes are equal, and each begins at the end of the one before. The lobe "
        "of involute teeth reaches from the middle of a space to the middle of the next. The "
        "points are absent if flanks are turned, as the outline is not known."
    )
    ring_lobe_mm: Maybe[list[list[float]]] = result(
        "Points x, y of one tooth of an involute ring about the axis, from the middle of a "
        "space to the middle of the next; without a cutter flanks continue to the roots."
    )
    ring_turn_deg: Maybe[float] = result(
        "Angle of the involute ring from the position with a space pointing up, anticlockwise.",
        equation="−φ₀",
    )
    turn_deg: list[float] = result(
        "Angle of each disc at the crank angle 0, anticlockwise; over the turn it grows by the "
        "crank angle over the ratio.",
        equation="α_j/u − φ₀; of involute teeth π/z₂ more",
    )
    ring_pins: Maybe[list[RingPinOut]] = result("Pins of the ring, if it is a ring of pins.")
    crank_angle_deg: Maybe[list[float]] = result(
        "Crank angles of forces and gaps, until the pattern repeats; absent, as are forces and "
        "gaps, if this takes too many angles.",
        symbol="φ",
    )
    repeats_after_deg: Maybe[float] = result(
        "Crank angle after which forces and gaps repeat, at pins further on."
    )
    pins_further: Maybe[int] = result(
        "Number of pins by which forces and gaps have moved on after that crank angle."
    )
    force_N: Maybe[list[list[list[float]]]] = result(
        "Force of each ring pin at the crank angles, satellite by satellite.", symbol="F_jk"
    )
    gap_mm: Maybe[list[list[list[float]]]] = result(
        "Gap between disc and ring pin under the torque; 0 if they press."
    )

    @classmethod
    def of_teeth(cls, drawn: DrawnTeeth) -> dict[str, object]:
        """The values of involute satellites and their ring."""
        return {
            name: rounded(from_si(name, np.array(value)), DRAWN_DIGITS).tolist()
            for name, value in {
                "lobe_mm": drawn.lobe,
                "turn_deg": drawn.turns,
                "ring_lobe_mm": drawn.ring_lobe,
                "ring_turn_deg": drawn.ring_turn,
            }.items()
        }

    @classmethod
    def with_curves(cls, drawn: DrawnMesh, curves: MeshCurves | SeriesCurves) -> dict[str, object]:
        """Values of discs and ring, with curves of forces."""
        values = cls.of(
            drawn, crank_angle_deg=curves.crank_angle, force_N=curves.force, gap_mm=curves.gap
        )
        values["repeats_after_deg"] = float(from_si("repeats_after_deg", curves.period))
        values["pins_further"] = curves.further
        return values

    @classmethod
    def of(cls, drawn: DrawnMesh, **curves: object) -> dict[str, object]:
        """The values of discs and ring, and curves over the turn, in SI units."""
        own: Values = {
            "turn_deg": drawn.turns,
            "centre_mm": drawn.pin_centres,
            "radius_mm": drawn.pin_radii,
            "lobe_mm": drawn.lobe,
        }
        own |= curves
        values = {
            name: rounded(from_si(name, np.array(value)), DRAWN_DIGITS).tolist()
            for name, value in present(own).items()
        }
        sizes = zip(values.pop("centre_mm"), values.pop("radius_mm"), strict=True)
        values["ring_pins"] = [
            {"pin": k + 1, "centre_mm": centre, "radius_mm": radius}
            for k, (centre, radius) in enumerate(sizes)
        ]
        return values


class SharedPairsOut(ResponseModel):
    """Number of pairs of perfect involute teeth that carry over a pitch, for information: pitch
    errors of some microns remove most of this sharing, and stresses are those of one pair.
    """

    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")
    largest_share: float = result("Largest share of the force that one pair carries.")
    edge_contact: bool = result(
        "True if a pair carries at the corner of a tip, where the pressure is not known."
    )


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
