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


class InvoluteStressesOut(ResponseModel, of=InvoluteLoad):
    """Stresses of involute teeth by the torque of a satellite, with one pair carrying all."""

    root: Maybe[RootStressOut] = None
