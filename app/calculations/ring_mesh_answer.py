"""Answer about the mesh of satellites with ring pins or involute ring teeth."""

from typing import Literal

import numpy as np

from app.calculations.involute_teeth import InvoluteGeometryOut, InvoluteStressesOut
from app.calculations.load_sharing_answer import StiffnessCurveOut
from app.calculations.mechanism import PairOut
from app.model import (
    AccuracyOut,
    AssumedOut,
    Maybe,
    ResponseModel,
    StepOut,
    Values,
    WarningOut,
    assumptions,
    present,
    result,
    worked_steps,
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

    shortening_coefficient: float = result("e·z₃/R_p of the ring's pins.", symbol="K₁")
    min_path_radius_mm: float = result(
        "Least convex radius of curvature of the tool's path.", symbol="ρ_min"
    )
    undercut_margin: float = result(
        "That over the tool's radius; at 1 the tool cuts off a part of the flanks.",
        symbol="ρ_min/r_m",
    )
    tip_radius_mm: float = result("Largest radius of a disc.", symbol="R_m + e − r_m")
    root_radius_mm: float = result("Least radius of a disc.", symbol="R_m − e − r_m")
    min_concave_radius_mm: Maybe[float] = result(
        "Least concave radius of a disc: what grinds its valleys is smaller."
    )


class RingIdealOut(ResponseModel):
    """Perfect parts on many pins, contacts linear, in closed form."""

    BESIDE = ("radial_force_ratio",)

    peak_force_N: float = result("Largest force of a pin, 4T_j/(K₁·z₂·R_p).", symbol="F_max")
    mean_sum_force_N: float = result(
        "Sum of the forces on a disc, 4T_j/(π·e·z₂), mean over the turn.", symbol="ΣF"
    )
    backlash_arcmin: Maybe[float] = result(
        "Play by the modification alone; absent where that jams.", symbol="2(Δ_e − Δ_p·q)/(e·z₂)"
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
        "Lag of each disc's teeth behind their ideal angle, clearance included; negative in "
        "reverse. That of a rigid output.",
        symbol="θ_j",
    )
    force_N: list[list[float]] = result(
        "Force of each pin of the ring, a list for each satellite.", symbol="F_jk"
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
        "From where to where the unloaded discs can turn; absent where pairs press without load.",
        symbol="θ₋, θ₊",
    )
    pressed_without_load: Maybe[bool] = result("True where pairs press without load.")
    interference_mm: Maybe[float] = result(
        "Smallest possible worst approach of the unloaded pairs, where they press.", symbol="δ"
    )
    stiffness_Nm_per_arcmin: float = result(
        "Torque over rotation of the mesh alone.", symbol="dT/dθ"
    )
    max_pressure_MPa: float = result(
        "Largest Hertz pressure of the pairs.", symbol="p_0", equation="Johnson 4.2"
    )
    sliding_speed_m_per_s: Maybe[float] = result(
        "Largest speed at which a loaded disc slides on a pin that stands still, where the speed "
        "is known.",
        symbol="v_s",
    )
    loss_per_friction: float = result(
        "Loss over output for a friction coefficient of 1.", equation="ΣF·|R_p·S − r|·c/T"
    )


class TeethTurnOut(ResponseModel):
    """Ring teeth over the turn, with both meshes in series: forces, pressures and lags of the discs
    in the common solution. Play, stiffness and transmission error are of both meshes and are in
    `load_sharing`. The accuracy is that of the largest pressure.
    """

    peak_force_N: float = result("Largest force of all pairs over the turn.", symbol="F_max")
    peak_force_ratio: float = result("The same over that of perfect parts.")
    peak_crank_angle_deg: float = result("First crank angle at which it occurs.", symbol="φ")
    peak_pair: PairOut = result("The satellite, and the pin of the ring that carries it there.")
    lag_min_arcmin: float = result(
        "Least lag of a disc under load; negative in reverse.", symbol="θ"
    )
    lag_max_arcmin: float = result("Largest lag of a disc under load.", symbol="θ")
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")
    max_pressure_MPa: float = result(
        "Largest Hertz pressure.", symbol="p_0", equation="Johnson 4.2"
    )
    radial_force_ratio_min: float = result(
        "Least force of the ring along a crank, over that across the crank of a disc that carries "
        "its part of the torque; negative outwards."
    )
    radial_force_ratio_max: float = result("Largest of the same.")
    pressed_without_load: bool = result("Whether pairs press without load anywhere.")


class MeshTurnOut(TeethTurnOut):
    """Extremes over the turn of the crank; the accuracy of the answer is that of the peak force."""

    backlash_max_arcmin: float = result(
        "Largest play of the unloaded discs, 0 where pairs press.", symbol="θ₊ − θ₋"
    )
    backlash_min_arcmin: float = result("Least play of the unloaded discs.", symbol="θ₊ − θ₋")
    lost_motion_arcmin: float = result(
        "Largest rotation between the two directions of a share of the torque.",
        equation="θ(+3 % T) − θ(−3 % T)",
    )
    transmission_error_arcmin: float = result("Largest less least lag under load.", symbol="TE")
    unloaded_transmission_error_arcmin: float = result(
        "The same of the lag at which the first pair touches.", symbol="TE₀"
    )
    stiffness_min_Nm_per_arcmin: float = result("Least stiffness.", symbol="dT/dθ")
    stiffness_max_Nm_per_arcmin: float = result("Largest stiffness.", symbol="dT/dθ")
    input_torque_ripple_Nm: float = result(
        "Largest less least torque that turns the crank, without friction.",
        equation="T/u + ΣF·∂δ/∂φ",
    )


class RingEfficiencyOut(ResponseModel):
    """Friction of the mesh over the turn, if its coefficient is known."""

    loss_per_friction: float = result(
        "Loss over output for a friction coefficient of 1, mean over the turn.",
        equation="ΣF·|R_p·S − r|·c/T; |τ − tan α_w| of involute teeth, over the path",
    )
    loss_ratio: float = result("Loss over output, mean over the turn.")
    efficiency: float = result("Of this mesh alone.", symbol="η")
    ideal_loss_ratio: Maybe[float] = result(
        "Loss over output of perfect parts on many pins.", symbol="4μ(R_p − r)/(π·e·z₂)"
    )
    mean_loss_W: Maybe[float] = result("Mean loss, where the speed is known.")
    peak_pv_MPa_m_per_s: Maybe[float] = result(
        "Largest product of pressure and sliding speed, where the speed is known: of sleeves in "
        "their bores, else of the contact by π/4 of its Hertz pressure, for comparison only.",
        symbol="pv",
    )


class ProfileOut(ResponseModel):
    """Outline of a disc as a closed polygon about its centre, clockwise from the valley that faces
    the crank at crank angle 0.
    """

    BESIDE = ("points", "closed")

    chord_error_mm: float = result("How far the outline is from the polygon at most.")
    closed: bool = result("True: the first point follows the last, and is not repeated.")
    points: list[list[float]] = result("Points x, y, mm.")

    @classmethod
    def of(cls, points: OutlinePoints) -> dict[str, object]:
        """The values of an outline."""
        found = from_si("points_mm", points.points)
        return cls.values(points, closed=True, points=found.tolist())


class RingPinOut(ResponseModel):
    """Ring pin as it is made."""

    pin: int = result("Number of the pin, from 1.", symbol="k")
    centre_mm: tuple[float, float] = result("Its centre, X and Y.", symbol="P_k")
    radius_mm: float = result("Its radius.", symbol="r")


class RingDrawingOut(ResponseModel):
    """Satellites and ring as they are drawn (Y up through output pin 1 at crank angle 0, X right):
    outline and place of a disc, and curves of its pins over the turn of the crank.
    """

    lobe_mm: Maybe[list[list[float]]] = result(
        "Points x, y of one lobe about a disc's centre, from a valley, that is up, clockwise; the "
        "next begins where it ends, and all are the same. Of involute teeth from the middle of a "
        "space to the next. Absent where flanks are turned: no outline is known."
    )
    ring_lobe_mm: Maybe[list[list[float]]] = result(
        "The same of an involute ring, about the axis: without a cutter flanks go on to its roots."
    )
    ring_turn_deg: Maybe[float] = result(
        "Angle of that ring from where a space is up, anticlockwise.", equation="−φ₀"
    )
    turn_deg: list[float] = result(
        "Angle of each disc at the crank angle 0, anticlockwise; over the turn it grows by that of "
        "the crank over the ratio.",
        equation="α_j/u − φ₀; of involute teeth π/z₂ more",
    )
    ring_pins: Maybe[list[RingPinOut]] = result("Pins of a ring of pins.")
    crank_angle_deg: Maybe[list[float]] = result(
        "Crank angles of forces and gaps, until all repeats; these are left out where that takes "
        "too many.",
        symbol="φ",
    )
    repeats_after_deg: Maybe[float] = result(
        "After how much of the crank's turning all repeats, with pins further on."
    )
    pins_further: Maybe[int] = result(
        "By how many pins: so much later a pin of the ring feels what that one does."
    )
    force_N: Maybe[list[list[list[float]]]] = result(
        "Force of each pin of the ring at these, satellite by satellite.", symbol="F_jk"
    )
    gap_mm: Maybe[list[list[list[float]]]] = result(
        "What is left between disc and pin under the torque, 0 where they press."
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
    largest_share: float = result("Most that a pair carries, over the force of one that has all.")
    edge_contact: bool = result(
        "Whether a pair carries at the corner of a tip, where no pressure is known."
    )


class DesignMeshOut(ResponseModel):
    """Mesh of cycloid discs and ring in a whole design, under the torque without its factor."""

    BESIDE = ("geometry", "torque_direction", "ideal", "over_turn", "efficiency")

    geometry: RingGeometryOut
    torque_direction: Literal["driving", "reverse"] = result(
        "Direction of the torque: of both the one with the larger pressure."
    )
    ideal: RingIdealOut
    over_turn: MeshTurnOut | TeethTurnOut
    efficiency: Maybe[RingEfficiencyOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


class DesignPairOut(ResponseModel):
    """Mesh of involute teeth in a whole design, for the satellite with the largest torque."""

    satellite_torque_Nm: float = result(
        "Largest torque of a satellite over the turn, under the dynamic load over its factor.",
        symbol="T_j",
    )
    geometry: InvoluteGeometryOut
    stresses: InvoluteStressesOut
    shared_pairs: Maybe[SharedPairsOut] = result("Pairs that carry, where teeth do not interfere.")
    efficiency: Maybe[RingEfficiencyOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


class RingMeshResponse(ResponseModel):
    """Requested sections."""

    assumed: Maybe[list[AssumedOut]] = assumptions()
    kind: Literal["cycloid", "involute"] = result("What the ring is.")
    geometry: RingGeometryOut | InvoluteGeometryOut
    stresses: Maybe[InvoluteStressesOut] = None
    shared_pairs: Maybe[SharedPairsOut] = None
    ideal: Maybe[RingIdealOut] = None
    positions: Maybe[list[MeshPositionOut]] = None
    over_turn: Maybe[MeshTurnOut] = None
    efficiency: Maybe[RingEfficiencyOut] = None
    stiffness_curve: Maybe[StiffnessCurveOut] = None
    profile: Maybe[ProfileOut] = None
    worked: Maybe[list[StepOut]] = worked_steps()
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None
