"""Sections of the design document in SI units, without the ring."""

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, ClassVar, Literal, get_args

from core.bearings import BEARINGS
from core.crank.balance import Counterweight
from core.crank.bearing_life import Bearing
from core.crank.pin_rollers import FRICTION, Ratings, RollerKind
from core.errors import InvalidInput, Notice, NotKnown, required
from core.fatigue import (
    NOTCH_STRENGTHS,
    SIZES,
    Criterion,
    Edition,
    EnduranceFactors,
    Surface,
    beyond_range,
    endurance_limit,
    notch_factor,
    reliability_factor,
    size_factor,
    surface_factor,
)
from core.fields import LARGEST, Forms, Kinds, Rule, optional_size, quantity, size
from core.output.elasticity import PinSupport
from core.output.mechanism import MAX_SATELLITES, Output
from core.output.pin_bolt import PinBolt
from core.output.pin_fatigue import FatigueStrength
from core.output.sampled_turn import Direction
from core.precision import SAME

PeakKind = Literal["start", "emergency"]

Seat = Literal["housing", "carrier", "ring"]

PartName = Literal[
    "contact", "pins", "teeth", "satellite_bearing", "crank_bearings", "body", "losses"
]

PART_NAMES: tuple[PartName, ...] = get_args(PartName)
"""Parts of a reducer, keys of `PARTS` in `core.checks.crank_planetary`."""


bearing_name = partial(
    quantity, "Bearing", default=None, options=(*BEARINGS,), lengths=((None, 40),)
)
"""Name in the table of bearings."""

MAX_WEIGHTS = 20
"""Largest number of counterweights."""


MAX_PAIRS = 10_000
"""Largest number of pairs (pins times satellites) of a mechanism."""

USUAL_SATELLITES = 2
"""Number of satellites if none is given."""

angle = partial(quantity, unit="deg", ge=-3600, le=3600)
"""Angle of up to ten turns."""

speed_of_both = partial(
    quantity, unit="rpm", default=None, step=10, advanced=True, ge=-1e6, le=1e6, or_zero=True
)
"""Speed with a sign for its sense."""


OF_RINGS = ("ratio", "satellite_teeth", "ring_teeth", "crank_spacing", "crank_angles")
"""Inputs of a mechanism that has a ring, and cranks."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StatedRatio:
    """Inputs from which the ratio of a mechanism follows."""

    ratio: float | None = quantity("Ratio", "u", default=None, step=1, ge=-1e9, le=1e9, least=1)
    """Speed of the crank over that of the pins with the ring at rest, u = z₂/(z₃ − z₂), at least 1.
    A negative sign, for pins that turn opposite to the crank, as they always do, is accepted and
    ignored."""
    output_ratio: float | None = quantity(
        "Ratio of the output", "i", default=None, step=1, ge=2, le=1e9
    )
    """Speed of the crank over that of the ring, i = u + 1, if the ring is the output."""
    ring_teeth: int | None = quantity("Ring teeth", "z₃", default=None, step=1, ge=2, le=10**6)
    """Number of teeth of the ring, larger than that of the satellite."""
    output: Literal["pins", "ring", "both", "coupling", "crankshafts"] = quantity(
        "Output", default="pins", advanced=True
    )
    """Output link: the pins with the ring at rest, the ring with the pins at rest, or both; or a
    coupling, in which pins connect two shafts an eccentricity apart, without a ring. RV reducers,
    whose crankshafts drive the output, are not calculated."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MechanismSection:
    """Pins, satellites and cranks."""

    FOLLOWS_FROM: ClassVar[Any] = StatedRatio
    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("ratio",), ("output_ratio",), ("satellite_teeth", "ring_teeth"), ()),
        (("crank_spacing",), ("crank_angles",), ()),
    )
    KIND: ClassVar[str] = "output"
    KINDS: ClassVar[Kinds] = {
        "pins": ((), OF_RINGS),
        "ring": ((), (*OF_RINGS, "output_ratio")),
        "both": ((), OF_RINGS),
        "coupling": ((), ()),
        "crankshafts": ((), OF_RINGS),
    }

    pins: int | None = quantity("Pins", "N", default=None, step=1, ge=1, le=MAX_PAIRS)
    """Number of pins of the output link, evenly spaced on the pin circle."""
    satellites: int = quantity(
        "Satellites", "K", default=USUAL_SATELLITES, step=1, ge=1, le=MAX_SATELLITES
    )
    """Number of satellites, each on its own crank."""
    crank_spacing: float | None = angle("Crank spacing", "α", default=None, step=15)
    """Angle between neighbouring cranks; 360°/K where not given."""
    crank_angles: tuple[float, ...] = angle(
        "Crank angles", "α₁ … α_K", default=(), lengths=((1, MAX_SATELLITES),)
    )
    """Angle of each crank, one for each satellite, instead of an even spacing."""
    ratio: float  # u; infinite for a coupling
    output: Output = "pins"  # link that turns the output
    initial_crank_angle: float = angle(
        "Initial wave angle", "φ₀", default=0.0, step=15, advanced=True
    )
    """Wave angle at the crank angle 0: 0° by the sign convention of Yanchevskiy 2021, 180° by that
    of Yanchevsky 2018; 180° also equals a reversed torque."""
    satellite_teeth: int | None = quantity(
        "Satellite teeth", "z₂", default=None, step=1, ge=1, le=10**6
    )
    """Number of teeth of a satellite, from which the ratio and the assembly angles follow."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StatedTorque:
    """Inputs from which the torque of the output follows."""

    input_torque: float | None = optional_size("Input torque", "T₁", "Nm", step=1)
    """Torque on the crankshaft, from which T = T₁·i·η follows; i is u, or u + 1 if the ring is the
    output."""
    efficiency: float | None = quantity("Efficiency", "η", default=None, step=0.01, ge=1e-3, le=1)
    """Efficiency of the reducer, needed with the input torque."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Load:
    """Torque of the output with its direction, lever and speeds."""

    FOLLOWS_FROM: ClassVar[Any] = StatedTorque
    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("output_torque",), ("input_torque", "efficiency"), ()),
        (("ring_speed",), ("carrier_speed",), ()),
    )

    output_torque: float | None = optional_size("Output torque", "T", "Nm", step=10)
    """Torque of the output; the torque on the pins if ring and pins are both outputs."""
    pin_circle_radius: float | None = optional_size("Pin circle radius", "R", "mm", step=1)
    """Radius of the circle of pin centres."""
    force_exponent: float = quantity("Force exponent", "v", default=1.0, step=0.1, ge=0, le=500)
    """Exponent v in force ∝ approach^v: 0 for equal sharing, 1 for linear contacts, 10/9 and 3/2
    for the usual contact laws."""
    torque_direction: Direction = quantity("Direction of the torque", default="driving")
    """Driving: the satellites turn the pins; reverse: the load turns the pins back; alternating:
    both directions are solved, and the answer gives the worse one."""
    input_speed: float | None = optional_size("Input speed", "n₁", "rpm", step=50)
    """Speed of the crankshaft."""
    application_factor: float = size(
        "Application factor", "K_A", default=1.0, step=0.05, silent=True
    )
    """Factor on the torque for stresses and pressures, not for losses, wear and the life of
    bearings; 1 where not given."""
    peak_torque: float | None = optional_size("Peak torque", "T_max", "Nm", step=10)
    """Largest torque, for static strength, at least the torque times the application factor, which
    is also the default."""
    peak_kind: PeakKind = quantity("Kind of the peak", default="start", advanced=True)
    """Event of the peak torque: a start, which happens again and again and needs a static safety of
    bearings of 1.5, or an emergency stop, which needs 1."""
    ring_speed: float | None = speed_of_both("Ring speed", "n_r")
    """Speed of the ring if ring and pins are both outputs, positive in the sense of the crank."""
    carrier_speed: float | None = speed_of_both("Speed of the pins", "n_c")
    """Speed of the pins if ring and pins are both outputs, positive in the sense of the crank;
    given instead of the ring's speed."""

    @property
    def by_ring(self) -> bool:
        """True if the speed of the ring is given, not that of the pins."""
        return self.ring_speed is not None


@dataclass(frozen=True, slots=True, kw_only=True)
class SatelliteBody:
    """Body of a satellite, as far as it is given."""

    outer_radius: float | None = optional_size("Outer radius", "r_o", "mm", step=1)
    """Outer radius of the satellite, with its teeth."""
    root_radius: float | None = optional_size("Root radius", "r_f", "mm", step=1)
    """Radius at the root of the satellite's teeth."""
    bore_radius: float | None = optional_size("Bore radius", "r_b", "mm", step=1)
    """Radius of the satellite's bore."""
    solid_wall: float | None = optional_size("Solid wall of the holes", "w_s", "mm", step=0.4)
    """Thickness of solid material around the holes of a printed satellite: number of perimeters
    times line width."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Build:
    """Carrier and ring housing around the discs, as far as they are given. Sizes that are not given
    are usual ones, rules of thumb; places of satellites and bearings on pins and crankshaft, and
    the span of the pins, follow where they are not given.
    """

    gap: float | None = optional_size("Gap beside the discs", "g", "mm", step=0.5)
    """Gap between two discs, and between a disc and a plate of the carrier; if not given 0.1 of the
    width of a disc, from 0.5 to 2 mm."""
    carrier_width: float | None = optional_size("Width of the carrier", "b_c", "mm", step=1)
    """Width of the plate of the carrier that holds the pins; if not given 1.2 pin diameters, at
    least 3 mm and the width of the crankshaft's first bearing."""
    second_carrier_width: float | None = optional_size(
        "Width of the second plate", "b_c2", "mm", step=1
    )
    """Width of the second plate, or of the tie ring, at the other ends of the pins; usual as that
    of the first one. Pins that are a cantilever have none."""
    carrier_diameter: float | None = optional_size("Carrier diameter", "D_c", "mm", step=1)
    """Outer diameter of the carrier; if not given that of the pin circle and two pin diameters."""
    housing_diameter: float | None = optional_size("Housing diameter", "D_h", "mm", step=1)
    """Outer diameter of the ring housing; if not given 1.1 times that of the ring at its pins or
    roots, with a wall of at least 3 mm, rounded up to whole millimetres."""
    housing_width: float | None = optional_size("Housing width", "b_h", "mm", step=1)
    """Width of the ring housing, about the middle of the discs; if not given the discs with the
    gaps between and beside them."""
    # Paths of what follows from these sizes, in an order in which each needs those before.
    follows: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Temperatures:
    """Temperatures of the parts at work, by which plastics are judged."""

    satellite: float | None = quantity(
        "Temperature of the satellites", "T_s", "C", default=None, step=5, ge=-60, le=250
    )
    """Temperature of the satellites at work; a motor nearby heats them."""
    pins: float | None = quantity(
        "Temperature of the pins", "T_p", "C", default=None, step=5, ge=-60, le=250
    )
    """Temperature of the pins at work."""


USUAL_LIFE = 5000 * 3600.0
"""Required life if none is given, s; a tenth of it for plastics."""

safety = partial(quantity, step=0.1, ge=0.1, le=100)
"""Required safety factor."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Requirements:
    """Limits that a design has to keep; a limit that is not given is not checked."""

    pitting_safety: float = safety("Safety against pitting", "S_H", default=1.2)
    """Safety factor against pitting: limit of the contact pressure over the contact pressure. The
    factor is a ratio of pressures, not of loads."""
    bending_safety: float = safety("Safety against bending", "S_F", default=1.5)
    """Safety factor in bending: yield strength over bending stress."""
    fatigue_safety: float = safety("Safety in fatigue", "S_D", default=1.5)
    """Factor by which all stresses of a part may grow before it breaks by fatigue."""
    static_safety: float | None = safety("Static safety of bearings", "S_0", default=None)
    """Static load rating of a bearing over its largest load; 1 for balls and 1.5 for rollers if it
    is not given."""
    life: float | None = optional_size("Life", "L", "h", step=500)
    """Required life of the reducer; 5,000 h, or 500 h for plastics, if it is not given."""
    min_wall: float | None = optional_size("Least wall", "w", "mm", step=0.5)
    """Least wall between holes, to the rim and to the bore."""
    max_backlash: float | None = optional_size("Largest backlash", "Δφ_b", "arcmin", step=0.5)
    """Largest play of the unloaded output mechanism over the turn."""
    max_lost_motion: float | None = optional_size("Largest lost motion", "Δφ_l", "arcmin", step=0.5)
    """Largest rotation of the output mechanism between 3 % of the torque in both directions."""
    max_ring_backlash: float | None = optional_size(
        "Largest backlash of the teeth", "Δφ_r", "arcmin", step=0.5
    )
    """Largest play of the unloaded output over the turn by the teeth alone."""
    max_transmission_error: float | None = optional_size(
        "Largest transmission error of the teeth", "TE_max", "arcmin", step=0.1
    )
    """Largest lag of the output less its least lag over the turn under the torque, by the teeth
    alone, or by both meshes if they are in series."""
    max_deflection: float | None = optional_size("Largest deflection", "Δ_max", "mm", step=0.01)
    """Largest deflection of the shaft at its bearings, or of the pins in the satellites."""
    max_slope: float | None = optional_size("Largest slope", "θ_max", "mrad", step=0.1)
    """Largest slope of the shaft in its bearings, or of the pins in the satellites."""
    min_efficiency: float | None = quantity(
        "Least efficiency", "η_min", default=None, step=0.01, ge=1e-3, lt=1
    )
    """Least mean efficiency of the output mechanism; the ring is included if its friction
    coefficient is given."""
    min_ring_efficiency: float | None = quantity(
        "Least efficiency of the teeth", "η_min", default=None, step=0.01, ge=1e-3, lt=1
    )
    """Least mean efficiency of the teeth alone."""
    max_seat_pressure: float | None = optional_size(
        "Largest pressure of the ring's seats", "p_all", "MPa", step=10
    )
    """Largest pressure of the ring pins in half bores, on the projected area."""
    max_wear: float | None = optional_size("Largest wear", "h_max", "mm", step=0.01)
    """Largest depth of wear of pin or hole at the end of the life."""
    max_pv: float | None = optional_size("Largest pv", "(pv)_all", "MPa_m_per_s", step=0.1)
    """Largest pressure on the projected area times sliding speed."""
    max_sliding_speed: float | None = optional_size(
        "Largest sliding speed", "v_max", "m_per_s", step=0.1
    )
    """Largest speed at which pins slide in the holes, or in their sleeves."""
    max_outer_diameter: float | None = optional_size("Largest diameter", "D_max", "mm", step=5)
    """Largest outer diameter of the reducer: of ring housing and carrier."""
    max_length: float | None = optional_size("Largest length", "L_max", "mm", step=5)
    """Largest length of the reducer, without motor, bearing of the output and seals."""
    max_unbalance: float | None = optional_size("Largest unbalanced force", "F_U", "N", step=10)
    """Largest unbalanced centrifugal force of the parts that turn with the crankshaft."""
    max_unbalance_couple: float | None = optional_size(
        "Largest unbalanced couple", "M_U", "Nm", step=0.1
    )
    """Largest unbalanced couple of the parts that turn with the crankshaft, about the middle of the
    bearings."""
    max_unbalance_share: float | None = quantity(
        "Largest share of unbalance", default=None, step=0.05, gt=0, le=1e6
    )
    """Largest reaction of a crankshaft bearing to the unbalance, over the largest reaction to the
    forces of the mechanism."""
    balance_grade: float | None = optional_size("Balance grade", "G", "mm_per_s", step=0.5)
    """Balance grade G of ISO 21940-11: largest speed of the rotor's centre of mass about the axis.
    The usual value is 16."""
    scope: tuple[PartName, ...] = quantity(
        "Parts that are judged", default=PART_NAMES, lengths=((1, len(PART_NAMES)),)
    )
    """Parts of the reducer to judge. Other parts have no checks and are not in the verdict."""


@dataclass(frozen=True, slots=True)
class DesignPin(PinSupport):
    """Pin with its support, section and strength; see `core.output.elasticity.PinSupport`."""

    KIND: ClassVar[str] = "support"
    KINDS: ClassVar[Kinds] = {
        "cantilever": ((), ("span",)),
        "supported": ((), ("span",)),
        "fixed": ((), ("span",)),
        "tie_ring": ((), ("span", "ring_joint")),
    }

    contact_length: float | None = optional_size("Contact length", "b", "mm", step=1)
    """Length of the contact along the pin, which is the width of the satellite."""
    rotates: bool = quantity("Pin rotates", default=False)
    """True if the pin turns in the carrier, so that its bending is fully reversed."""
    tensile_strength: float | None = None  # tensile strength of the material, Pa
    steel: bool = False  # True if a rule of the endurance limit exists for the material
    valid_diameter: float | None = None  # largest diameter that the strengths hold for, m
    bolt: PinBolt | None = quantity(default=None)  # bolt through the pin, which is a spacer then
    material_path: str = "pin.material"  # path of the material in the design

    @property
    def thick(self) -> tuple[Notice, ...]:
        """Notice if the pin is thicker than the strengths of its material hold for."""
        valid = self.valid_diameter
        if valid is None or self.diameter <= valid:
            return ()
        return (Notice("beyond_size", {"limit": valid * 1e3}),)

    def bolt_alone(self, bolt: PinBolt) -> "DesignPin":
        """Bolt as the pin that bends; the spacer only touches the hole."""
        alone = replace(self, diameter=bolt.core_diameter, bore_diameter=0.0, bolt=None)
        if bolt.material is None:
            return alone
        return replace(
            alone,
            material=bolt.material,
            tensile_strength=bolt.tensile_strength,
            steel=bolt.steel,
            valid_diameter=bolt.valid_diameter,
            material_path="pin.bolt.bolt_material",
        )


USUAL_RELIABILITY = 50.0
"""Reliability of a pin's fatigue strength if none is given, %."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Notch:
    """Notch of the part at its largest bending stress."""

    theoretical_factor: float = quantity("Stress concentration", "K_t", step=0.1, ge=1, le=100)
    """Elastic stress concentration factor of the notch."""
    radius: float = size("Notch radius", "r", "mm", step=0.1)
    """Radius of the notch."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FatigueBasis:
    """Basis of the fatigue strength of a part; a pin is loaded once a turn of the crank against the
    pins.
    """

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("surface",), ("surface_factor",), ("endurance_limit",)),
        (("reliability_percent",), ("reliability_factor",), ()),
        (("fatigue_notch_factor",), ("notch",), ()),
    )

    surface: Surface | None = quantity("Surface", default=None)
    """Finish of the surface; cold-drawn counts as machined."""
    surface_factor: float | None = quantity(
        "Surface factor", "k_a", default=None, step=0.05, ge=0.01, le=1
    )
    """Surface factor, given instead of the finish of the surface."""
    edition: Edition = quantity("Edition", default="shigley_11", advanced=True)
    """Edition of Shigley from which the constants of the surface factor are taken."""
    reliability_percent: float | None = quantity("Reliability", default=None, ge=50, le=99.99)
    """Reliability of 50, 90, 95, 99, 99.9 or 99.99 %; 50 % if neither the reliability nor its
    factor is given."""
    reliability_factor: float | None = quantity(
        "Reliability factor", "k_e", default=None, step=0.05, ge=0.01, le=1
    )
    """Reliability factor, given instead of the reliability."""
    fatigue_notch_factor: float | None = quantity(
        "Fatigue notch factor", "K_f", default=None, step=0.1, ge=1, le=100
    )
    """Fatigue notch factor of the seat or of any notch at the place of the largest bending; 1 means
    no notch."""
    notch: Notch | None = quantity(default=None)
    endurance_limit: float | None = optional_size("Endurance limit", "S_e", "MPa", step=10)
    """Endurance limit of the part itself, with all factors included."""
    criterion: Criterion = quantity("Criterion", default="goodman")
    """Criterion for the mean stress: Goodman, Gerber, Soderberg, or Haigh as in FKM."""
    life: float | None = optional_size("Life", "L", "h", step=500)
    """Required life of the pins, of the requirements if not given; for fewer than a million cycles
    their strength is above the endurance limit."""

    def strength(self, pin: DesignPin) -> FatigueStrength:
        """Fatigue strength of a pin.

        Raises NotKnown if a value that it needs is not given, InvalidInput without a yield strength
        that the criterion needs.
        """
        return self.of(
            diameter=pin.diameter,
            tensile_strength=pin.tensile_strength,
            yield_strength=pin.material.yield_strength,
            steel=pin.steel,
            material_path=pin.material_path,
        )

    def of(
        self,
        *,
        diameter: float,
        tensile_strength: float | None,
        yield_strength: float | None,
        steel: bool,
        material_path: str = "pin.material",
    ) -> FatigueStrength:
        """Fatigue strength of a round part; diameter in m, strengths in Pa.

        Raises NotKnown if a value that it needs is not given, InvalidInput without a yield strength
        that the criterion needs.
        """
        name, yields = f"{material_path}.tensile_strength", yield_strength
        tensile = required(tensile_strength, "endurance_unknown", name)
        if not steel:
            required(self.endurance_limit, "endurance_unknown", "fatigue.endurance_limit")
        if self.criterion == "soderberg" and yields is None:
            raise InvalidInput("yield_strength", None, "needed_beside", field="criterion")
        if self.endurance_limit is not None:
            return FatigueStrength(self.endurance_limit, tensile, yields, self.criterion)
        beyond = beyond_range(code="size_beyond_range", value=diameter * 1e3, ends=SIZES)
        if self.notch is None:
            name = "fatigue.fatigue_notch_factor"
            notch = required(self.fatigue_notch_factor, "notch_unknown", name)
        else:
            strength = tensile / 1e6
            beyond += beyond_range(
                code="notch_beyond_strength", value=strength, ends=NOTCH_STRENGTHS
            )
            notch = float(
                notch_factor(
                    theoretical_factor=self.notch.theoretical_factor,
                    radius=self.notch.radius,
                    tensile_strength=tensile,
                )
            )
        surface = self.surface_factor
        if surface is None:
            finish: Surface = required(self.surface, "endurance_unknown", "fatigue.surface")
            surface = float(
                surface_factor(tensile_strength=tensile, surface=finish, edition=self.edition)
            )
        reliability = self.reliability_factor
        if reliability is None:
            percent = self.reliability_percent or USUAL_RELIABILITY
            reliability = reliability_factor(percent=percent)
        size = size_factor(diameter=diameter)
        factors = EnduranceFactors(surface, size, reliability, notch)
        limit = float(endurance_limit(tensile_strength=tensile, factors=factors))
        return FatigueStrength(limit, tensile, yields, self.criterion, factors, notices=beyond)


@dataclass(frozen=True, slots=True, kw_only=True)
class Friction:
    """Friction and wear of pin and hole, or of pin and sleeve."""

    coefficient: float = quantity("Friction coefficient", "μ", step=0.01, ge=0, le=10, or_zero=True)
    """Friction coefficient of the sliding surfaces."""
    sleeve: bool = quantity("Sleeves on the pins", default=False)
    """True if sleeves roll in the holes and slide on the pins; the pin diameter is needed then."""
    wear_rate: float | None = optional_size("Wear coefficient", "k", "mm3_per_Nm", step=1e-9)
    """Worn volume over force and sliding distance (Archard)."""
    life: float | None = optional_size("Life", "t", "h", step=100)
    """Operating time over which the wear is calculated."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rollers:
    """Rolling bearings on the pins, whose outer rings roll in the holes."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("bore_diameter",), ("name",), ("bore_diameter", "name")),
        (("kind",), ("name",), ("kind", "name")),
    )

    name: str | None = bearing_name()
    """Name in the table of bearings, such as 686, from which the sizes and the lowest load ratings
    of the makers are taken; values that are given as well replace them."""
    kind: RollerKind = quantity("Rolling elements", filled=True)
    """Balls, cylindrical rollers or needles."""
    bore_diameter: float = size("Bore", "d", "mm", step=1, filled=True)
    """Bore diameter of the bearing, equal to the pin diameter."""
    outer_diameter: float | None = optional_size("Outer diameter", "D", "mm", step=1)
    """Outer diameter of the bearing, twice the radius that touches the holes."""
    width: float = size("Width", "B", "mm", default=math.inf, step=0.5)
    """Width of one bearing; the contact with the hole is not longer than the bearings."""
    per_satellite: int = quantity(
        "Bearings side by side", "n", default=1, ge=1, le=20, advanced=True
    )
    """Number of bearings on each pin under each satellite, which share the force evenly."""
    dynamic_rating: float | None = optional_size("Dynamic load rating", "C", "N", step=100)
    """Basic dynamic load rating of one bearing, for the life."""
    static_rating: float | None = optional_size("Static load rating", "C₀", "N", step=100)
    """Basic static load rating of one bearing, for the static safety."""
    ratings: Ratings = quantity("Ratings of", default="bearing")
    """Kind of bearing to which the ratings apply: a bearing, whose ratings hold in a rigid seat, so
    that a lower bound without a seat is used; or a track roller, whose ratings by the maker include
    the missing seat."""
    rolling_elements: int | None = quantity("Number of elements", "Z", default=None, ge=3, le=200)
    """Number of rolling elements of a bearing; more elements leave less of the ratings without a
    seat."""
    max_radial_load: float = size(
        "Largest load", "F_r", "N", default=math.inf, step=100, advanced=True
    )
    """Largest load of a track roller by its maker, limited by the bending of the outer ring."""
    max_static_radial_load: float = size(
        "Largest static load", "F_0r", "N", default=math.inf, step=100, advanced=True
    )
    """Largest static load of a track roller by its maker, compared with the load at the peak
    torque."""
    radial_clearance: float | None = quantity(
        "Clearance of the bearings", "G_r", "mm", default=None, step=0.005, ge=0, le=LARGEST
    )
    """Radial internal clearance as stated in catalogues; half of it adds to the clearance of pins
    and holes."""
    friction_coefficient: float | None = quantity(
        "Friction of the bearings", "μ_b", default=None, step=0.0005, ge=0, le=10, advanced=True
    )
    """Friction coefficient of the bearing at its bore; 0.0015 for balls, 0.002 for cylindrical
    rollers, 0.003 for needles if not given."""
    limiting_speed: float | None = optional_size(
        "Limiting speed", "n_lim", "rpm", step=500, advanced=True
    )
    """Limiting speed in the catalogue; without it the speed is not judged."""

    @property
    def play(self) -> float:
        """Movement of an outer ring to either side, m."""
        return (self.radial_clearance or 0.0) / 2

    @property
    def length(self) -> float:
        """Total length of the rollers under a satellite, m; infinite without a given width."""
        return self.per_satellite * self.width

    def check(self, *, pin_radius: float | None, pin_diameter: float | None) -> None:
        """Raise InvalidInput if sizes contradict each other or rollers have no outer ring of their
        own.

        `pin_radius` is the radius of the surface that touches the hole, m; `pin_diameter` that of
        the pin, m.
        """
        outer = self.outer_diameter
        if outer is None and self.kind == "needle" and self.ratings == "bearing":
            raise InvalidInput("rollers.ratings", self.ratings, "drawn_cup")
        touching = None if pin_radius is None else 2 * pin_radius
        sizes = [("pin_radius", touching), ("outer_diameter", outer)]
        given = [(field, size) for field, size in sizes if size is not None]
        if len(given) > 1 and not math.isclose(given[0][1], given[1][1], rel_tol=SAME):
            touches = {"field": "pin_radius", "limit": touching}
            raise InvalidInput("rollers.outer_diameter", outer, "only_one", **touches)
        for field, diameter in given:
            if not self.bore_diameter < diameter:
                bore, than = self.bore_diameter, {"field": field, "limit": diameter}
                raise InvalidInput("rollers.bore_diameter", bore, "smaller_than", **than)
        if pin_diameter and not math.isclose(pin_diameter, self.bore_diameter, rel_tol=SAME):
            raise InvalidInput("pin.diameter", pin_diameter, "only_one", field="bore_diameter")

    def friction(self, given: "Friction | None") -> "Friction":
        """Friction of rollers on their pins; `given` is used if rollers have no coefficient."""
        coefficient = self.friction_coefficient
        if coefficient is None:
            coefficient = given.coefficient if given else FRICTION[self.kind]
        return Friction(coefficient=coefficient, sleeve=True)


@dataclass(frozen=True, slots=True, kw_only=True)
class CatalogueBearing:
    """Rolling bearing, as its catalogue gives it."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("kind",), ("name",), ("kind", "name")),)

    name: str | None = bearing_name()
    """Name in the table of bearings, such as 686, from which the sizes and the lowest load ratings
    of the makers are taken; values that are given as well replace them."""
    kind: Bearing = quantity("Rolling elements", filled=True)
    """Kind of rolling elements, which states the exponent of the load in the life: 3 for balls,
    10/3 for rollers."""
    dynamic_rating: float | None = optional_size("Dynamic load rating", "C", "N", step=100)
    """Basic dynamic load rating; without it the life is not calculated."""
    static_rating: float | None = optional_size("Static load rating", "C₀", "N", step=100)
    """Basic static load rating, for the static safety."""
    bore_diameter: float | None = optional_size("Bore", "d", "mm", step=1)
    """Bore diameter of the bearing; bore, outer diameter and width together show if such a bearing
    exists."""
    outer_diameter: float | None = optional_size("Outer diameter", "D", "mm", step=1)
    """Outer diameter of the bearing, larger than its bore."""
    width: float | None = optional_size("Width", "B", "mm", step=1)
    """Width of the bearing."""
    limiting_speed: float | None = optional_size("Limiting speed", "n_lim", "rpm", step=500)
    """Limiting speed in the catalogue for the lubrication used; without it the speed is not
    judged."""

    @property
    def sizes(self) -> tuple[float, float, float] | tuple[()]:
        """Bore, outer diameter and width, m; empty unless all are given."""
        bore, outer, width = self.bore_diameter, self.outer_diameter, self.width
        return () if bore is None or outer is None or width is None else (bore, outer, width)

    def check_sizes(self, path: str) -> None:
        """Refuse a bore that is not smaller than the outer diameter; `path` names the bearing."""
        bore, outer = self.bore_diameter, self.outer_diameter
        if bore is not None and outer is not None and not bore < outer:
            than = {"field": "outer_diameter", "limit": outer}
            raise InvalidInput(f"{path}.bore_diameter", bore, "smaller_than", **than)


@dataclass(frozen=True, slots=True, kw_only=True)
class RollingBearing(CatalogueBearing):
    """A rolling bearing as its catalogue gives it."""

    reliability_percent: float = quantity("Reliability", default=90.0, ge=90, le=99)
    """Share of bearings that reach the life: 90, 95, 96, 97, 98 or 99 %."""
    ring_factor: float = quantity("Factor of the rings", "V", default=1.0, step=0.1, ge=0.1, le=10)
    """Rotation factor V of the equivalent load; 1.2 is usual if the outer ring turns relative to
    the load."""
    weibull_slope: float | None = quantity(
        "Weibull slope", "β", default=None, step=0.1, ge=0.1, le=10
    )
    """Slope of the Weibull distribution of lives, for the common life of all satellites' bearings,
    without those of the crankshaft."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SeatedBearing(CatalogueBearing):
    """Bearing of the crankshaft, and the part that holds it."""

    seat: Seat = quantity("Sits in", alias="in", default="housing")
    """Part in which the bearing sits: the housing, or the part of the pins or of the ring if it
    turns. The life uses the speed of the crankshaft relative to that part."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shaft:
    """Crankshaft with the places of its loads and bearings."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("satellite_mass", "needed_beside", "counterweights"),
    )

    satellite_positions: tuple[float, ...] = quantity(
        "Places of the satellites",
        "z₁ … z_K",
        "mm",
        default=(),
        lengths=((1, MAX_SATELLITES),),
        ge=-LARGEST,
        le=LARGEST,
    )
    """Middle plane of each satellite along the shaft; beside `build` it follows if not given."""
    bearing_positions: tuple[float, ...] = quantity(
        "Places of the bearings",
        "A, B",
        "mm",
        default=(),
        lengths=((2, 2),),
        ge=-LARGEST,
        le=LARGEST,
    )
    """Position of both bearings along the shaft, ascending; satellites may lie beyond them. Beside
    `build` they follow if not given."""
    satellite_mass: float | None = optional_size("Mass of a satellite", "m", "kg", step=0.1)
    """Mass of one satellite with its bearing; without it the balance is not calculated, and
    bearings carry no centrifugal forces."""
    counterweights: tuple[Counterweight, ...] = quantity(
        "Counterweights", default=(), lengths=((None, MAX_WEIGHTS),)
    )
    """Counterweights on the shaft; the mass of a satellite has to be given as well."""
    rotor_mass: float | None = optional_size("Mass of what turns", "M", "kg", step=0.1)
    """Mass of all parts that turn with the crankshaft, for the balance grade; the mass of the
    satellites if not given."""
    eccentric_diameter: float | None = optional_size(
        "Diameter of the eccentrics", "d_e", "mm", step=1
    )
    """Diameter of the eccentric inside the satellite's bearing."""
    shaft_diameter: float | None = optional_size("Diameter of the shaft", "d_s", "mm", step=1)
    """Diameter of the shaft between the eccentrics and in its bearings."""
    bearings: tuple[SeatedBearing, ...] = quantity(default=(), lengths=((2, 2),))
    """Both bearings of the crankshaft; ball bearings in the housing if not given."""

    @property
    def places(self) -> dict[str, Any]:
        """Places of satellites and bearings by their names; `NotKnown` without them."""
        return {
            name: required(getattr(self, name) or None, "size_missing", f"crankshaft.{name}")
            for name in ("satellite_positions", "bearing_positions")
        }

    @property
    def known_bearings(self) -> tuple[SeatedBearing, ...]:
        """Both bearings of the crankshaft; `NotKnown` if they are not given."""
        if not self.bearings:
            raise NotKnown("rating_unknown", "crankshaft.bearings")
        return self.bearings
