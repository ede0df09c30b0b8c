"""Involute teeth of satellite and ring: tooth data of a request, sizes and stresses answered."""

from typing import Any

from app.model import (
    Maybe,
    ResponseModel,
    Values,
    result,
)
from app.units import from_si
from core.ring.involute import InvolutePair
from core.ring.involute_load import InvoluteLoad, RootStress

RING_MATERIAL = "steel_structural"
"""Material of the ring if it is not given."""


class InvoluteGeometryOut(ResponseModel, of=InvolutePair):
    """Mesh of involute teeth of satellite and ring."""

    operating_pressure_angle_deg: float = result("Operating pressure angle.", symbol="α_w")
    eccentricity_mm: float = result(
        "Eccentricity; if none is given, the one without backlash.", symbol="e"
    )
    satellite_tip_radius_mm: float = result("Tip radius of the satellite.", symbol="r_as")
    ring_tip_radius_mm: float = result("Tip radius of the ring.", symbol="r_ar")
    satellite_root_radius_mm: float = result("Root radius of the satellite.", symbol="r_fs")
    ring_root_radius_mm: float = result(
        "Root radius of the ring; assumed if no cutter is given.", symbol="r_fr"
    )
    start_roll_satellite: float = result(
        "Tangent of the satellite's pressure angle at the start of the path.", symbol="τ₁"
    )
    tip_interference_G: Maybe[float] = result(
        "Tip interference value G, in radians times teeth, which has to be at least 0; absent "
        "if the tip circles do not cross.",
        symbol="G",
    )

    @classmethod
    def values(cls, result: InvolutePair, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a pair, of its line and of its teeth."""
        teeth = result.teeth
        sizes = {
            "operating_pressure_angle_deg": result.line.angle,
            "eccentricity_mm": result.line.eccentricity,
            "satellite_tip_radius_mm": teeth.satellite_tip,
            "ring_tip_radius_mm": teeth.ring_tip,
            "satellite_root_radius_mm": teeth.satellite_root,
            "ring_root_radius_mm": result.ring_root,
            "start_roll_satellite": result.start_roll,
        }
        own = {name: from_si(name, value) for name, value in sizes.items()}
        own["tip_interference_G"] = result.tip_interference
        return super().values(result, run_time_us, **own, **given)


class RootStressOut(ResponseModel, of=RootStress):
    """Root of the satellite's teeth under the force at the tip of one tooth."""

    root_chord_mm: float = result("Chord of the critical section.", symbol="s_Fn")
    root_stress_one_pair_MPa: float = result(
        "Root stress if one pair carries the whole load.", symbol="σ_F"
    )

    @classmethod
    def values(cls, result: RootStress, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a root."""
        sizes = {"root_chord_mm": result.chord, "root_stress_one_pair_MPa": result.stress}
        own = {name: from_si(name, value) for name, value in sizes.items()}
        return super().values(result, run_time_us, **own, **given)


class InvoluteStressesOut(ResponseModel, of=InvoluteLoad):
    """Stresses of involute teeth by the torque of a satellite, with one pair carrying all."""

    pressure_one_pair_start_MPa: Maybe[float] = result(
        "Largest contact pressure, at the start of the path of contact; absent if the path does"
        " not start on an involute."
    )
    pressure_one_pair_end_MPa: Maybe[float] = result(
        "Contact pressure at the end of the path of contact."
    )
    iso_pressure_at_pitch_point_MPa: Maybe[float] = result(
        "Contact pressure at the pitch point by ISO 6336-2, for comparison, as the pitch point "
        "need not lie on the path of contact."
    )
    normal_force_N: float = result("Force along the line of action.", symbol="F_bn")
    tangential_force_N: float = result("Component of the force across the crank.")
    radial_force_N: float = result("Component of the force along the crank, towards the axis.")
    root: Maybe[RootStressOut] = None

    @classmethod
    def values(cls, result: InvoluteLoad, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of loads, and of a root if given."""
        sizes = {
            "pressure_one_pair_start_MPa": result.pressure_start,
            "pressure_one_pair_end_MPa": result.pressure_end,
            "iso_pressure_at_pitch_point_MPa": result.pressure_at_pitch_point,
            "normal_force_N": result.force.normal,
            "tangential_force_N": result.force.tangential,
            "radial_force_N": result.force.radial,
        }
        own = {name: from_si(name, value) for name, value in sizes.items()}
        return super().values(result, run_time_us, **own, **given)
