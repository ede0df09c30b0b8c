"""Involute teeth of satellite and ring: tooth data of a request, sizes and stresses answered."""

from functools import partial
from typing import Any

from app.calculations.hertz import Material
from app.model import (
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    Whole,
    quantity,
    result,
)
from app.units import from_si
from core.ring.involute import HEIGHTS, InvolutePair
from core.ring.involute_load import InvoluteLoad, RootStress

RING_MATERIAL = "steel_structural"
"""Material of the ring if it is not given."""


satellite_shift = partial(
    quantity,
    "Profile shift of the satellite",
    "x_s",
    step=0.05,
    ge=-2,
    le=3,
    help="In modules, outwards.",
)
ring_shift = partial(
    quantity,
    "Profile shift of the ring",
    "x_r",
    step=0.05,
    ge=-2,
    le=3,
    help="In modules, outwards: a positive one makes its spaces wider, its tip and root circles "
    "larger. Where the ring's teeth are counted below 0 it has the other sign.",
)
"""Fields that are optional in some requests."""


class InvoluteTeethFields(RequestModel, group="gear"):
    """Involute teeth as they are made, the satellite by a hob, the ring by a shaper cutter, and
    inputs of their stresses, as far as they are given.
    """

    satellite_profile_shift: Maybe[float] = satellite_shift()
    ring_profile_shift: Maybe[float] = ring_shift()
    satellite_addendum: Maybe[float] = quantity(
        "Addendum of the satellite", "h_as", step=0.05, ge=HEIGHTS[0], le=HEIGHTS[1]
    )
    """In modules, above its shifted reference circle."""
    ring_addendum: Maybe[float] = quantity(
        "Addendum of the ring", "h_ar", step=0.05, ge=HEIGHTS[0], le=HEIGHTS[1]
    )
    """In modules, inside its shifted reference circle."""
    satellite_tip_radius_mm: Maybe[Size] = quantity(
        "Tip radius of the satellite", "r_as", step=0.5, advanced=True
    )
    """In place of its addendum."""
    ring_tip_radius_mm: Maybe[Size] = quantity(
        "Tip radius of the ring", "r_ar", step=0.5, advanced=True
    )
    """In place of its addendum."""
    dedendum: Maybe[float] = quantity("Dedendum", "h_f", step=0.05, ge=0.8, le=1.6, advanced=True)
    """Of the hob that makes the satellite, in modules; 1.25 where not given."""
    rack_tip_radius: Maybe[float] = quantity(
        "Tip radius of the hob", "ρ_f", step=0.02, ge=0, le=0.6, advanced=True
    )
    """In modules; 0.38, or as much as there is room for, where not given."""
    cutter_teeth: Maybe[Whole] = quantity("Teeth of the cutter", "z₀", ge=6, le=1000)
    """Of the shaper cutter that makes the ring; without it the ring's root is assumed, and its
    flanks are not checked."""
    cutter_profile_shift: Maybe[float] = quantity(
        "Profile shift of the cutter", "x₀", step=0.05, ge=-1, le=1, advanced=True
    )
    """In modules; 0 where not given."""
    cutter_addendum: Maybe[float] = quantity(
        "Addendum of the cutter", "h_a0", step=0.05, ge=0.8, le=1.6, advanced=True
    )
    """In modules; 1.25 where not given."""
    satellite_material: Maybe[Material] = quantity("Satellite material")
    """A name of the table of materials, or values; that of the holes where these have one."""
    ring_material: Maybe[Material] = quantity("Ring material")
    """A name of the table of materials, or values; structural steel where not given."""
    face_load_factor: Maybe[float] = quantity(
        "Face load factor", "K_Hβ", step=0.05, advanced=True, ge=1, le=10
    )
    """Factor on the force for stresses, as it is not the same along the width; 1 where not
    given."""
    pair_stiffness_N_per_mm: Maybe[Size] = quantity(
        "Stiffness of a pair", "k", step=10_000, advanced=True
    )
    """Along the line of action, for the pairs that carry; 14 N/(mm·µm) of the width where not
    given."""


class InvoluteGeometryOut(ResponseModel):
    """Mesh of involute teeth of satellite and ring."""

    operating_pressure_angle_deg: float = result("Operating pressure angle.", symbol="α_w")
    eccentricity_mm: float = result(
        "The eccentricity, that without backlash where none is given.", symbol="e"
    )
    eccentricity_without_backlash_mm: float = result(
        "At which teeth fill their spaces.", symbol="e₀"
    )
    normal_backlash_mm: float = result(
        "Between the idle flanks, along their normal; below 0 the teeth press.", symbol="j_n"
    )
    backlash_arcmin: float = result(
        "By how much the satellite can turn in the ring, and the output with it.", symbol="j_n/r_bs"
    )
    satellite_tip_radius_mm: float = result("Of the satellite.", symbol="r_as")
    ring_tip_radius_mm: float = result("Of the ring.", symbol="r_ar")
    satellite_root_radius_mm: float = result("Of the satellite.", symbol="r_fs")
    ring_root_radius_mm: float = result("Of the ring; assumed without a cutter.", symbol="r_fr")
    tip_clearance_satellite_mm: float = result("From the satellite's tip to the ring's root.")
    tip_clearance_ring_mm: float = result("From the ring's tip to the satellite's root.")
    satellite_tip_thickness_mm: float = result("Of the satellite's teeth at the tip.")
    ring_tip_thickness_mm: float = result("Of the ring's teeth at the tip.")
    contact_ratio: float = result("Length of the path of contact over the base pitch.", symbol="ε")
    start_roll_satellite: float = result(
        "Tangent of the satellite's pressure angle at the start of the path.", symbol="τ₁"
    )
    form_roll_satellite: float = result(
        "From which on its flank is an involute; below 0 it is undercut.", symbol="τ_F"
    )
    end_roll_ring: float = result("Tangent of the ring's pressure angle at the end of the path.")
    form_roll_ring: Maybe[float] = result(
        "Up to which its flank is an involute; where the cutter is given."
    )
    tips_overlap_all_round: bool = result(
        "Whether the satellite's tip circle has the ring's in it."
    )
    tip_interference_G: Maybe[float] = result(
        "Room of the tips beside the path, in radians times teeth; where the tip circles cross.",
        symbol="G",
    )
    tip_gap_mm: Maybe[float] = result("About how wide the gap there is.")
    reduced_radius_start_mm: Maybe[float] = result("Of curvature at the start of the path.")
    reduced_radius_end_mm: Maybe[float] = result("Of curvature at the end of the path.")
    pitch_point_on_path: bool = result("Whether the flanks roll on each other somewhere.")
    satellite_undercut: bool = result("Whether the hob cuts away a part of the involute.")

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


class RootStressOut(ResponseModel):
    """Root of the satellite's teeth under the force at the tip of one tooth."""

    root_chord_mm: float = result("Chord of the critical section.", symbol="s_Fn")
    fillet_radius_mm: float = result("Radius of the fillet there.", symbol="ρ_F")
    moment_arm_mm: float = result("Arm of the force.", symbol="h_Fe")
    form_factor: float = result("By the arm and the chord.", symbol="Y_F")
    stress_correction: float = result("By the notch.", symbol="Y_S")
    load_angle_deg: float = result("Of the force against the tooth.", symbol="α_Fen")
    root_stress_one_pair_MPa: float = result("Of one pair that carries all.", symbol="σ_F")

    @classmethod
    def values(cls, result: RootStress, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a root."""
        sizes = {"root_chord_mm": result.chord, "root_stress_one_pair_MPa": result.stress}
        own = {name: from_si(name, value) for name, value in sizes.items()}
        return super().values(result, run_time_us, **own, **given)


class InvoluteStressesOut(ResponseModel):
    """Stresses of involute teeth by the torque of a satellite, with one pair carrying all."""

    pressure_one_pair_start_MPa: Maybe[float] = result(
        "Largest contact pressure, at the start of the path; where it starts on an involute."
    )
    pressure_one_pair_end_MPa: Maybe[float] = result("Contact pressure at the end of the path.")
    iso_pressure_at_pitch_point_MPa: Maybe[float] = result(
        "Contact pressure at the pitch point, as ISO 6336-2 has it: to compare, it need not be on "
        "the path."
    )
    normal_force_N: float = result("Along the line of action.", symbol="F_bn")
    tangential_force_N: float = result("Across the crank.")
    radial_force_N: float = result("Along the crank, to the axis.")
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
