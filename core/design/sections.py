"""Sections of the design document in SI units, without the ring."""

import math
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple, get_args

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
from core.hertz import ElasticMaterial
from core.output.elasticity import PinSupport
from core.output.mechanism import Output
from core.output.pin_bolt import PinBolt
from core.output.pin_fatigue import FatigueStrength
from core.output.sampled_turn import Direction
from core.precision import SAME

SharedBy = Literal["discs", "pins"]
"""Origin of an uneven share that a load-sharing factor states: satellites ("discs"), or pins of one
satellite."""

PeakKind = Literal["start", "emergency"]

Seat = Literal["housing", "carrier", "ring"]

PartName = Literal[
    "contact", "pins", "teeth", "satellite_bearing", "crank_bearings", "body", "losses"
]

PART_NAMES: tuple[PartName, ...] = get_args(PartName)
"""Parts of a reducer, keys of `PARTS` in `core.checks.crank_planetary`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MechanismSection:
    """Pins, satellites and cranks."""

    pins: int  # N
    satellites: int  # K
    ratio: float  # u; infinite for a coupling
    output: Output = "pins"
    crank_spacing: float | None = None  # between neighbouring cranks, rad; None: even spacing
    crank_angles: tuple[float, ...] = ()  # angle of each crank, rad, in place of a spacing
    initial_crank_angle: float = 0.0  # wave angle at crank angle 0, rad
    satellite_teeth: int | None = None  # z2


@dataclass(frozen=True, slots=True, kw_only=True)
class Load:
    """Torque of the output with its direction, lever and speeds."""

    output_torque: float  # output torque, N*m; torque of the pins if pins and ring are both outputs
    pin_circle_radius: float  # R, m
    force_exponent: float = 1.0  # v, exponent of the approach in the force
    torque_direction: Direction = "driving"  # "alternating" judges the worse direction
    input_speed: float | None = None  # speed of the crank, rad/s
    application_factor: float = 1.0  # K_A on stresses
    peak_torque: float | None = None  # for static strength, N*m; None: torque times K_A
    peak_kind: PeakKind = "start"  # event at which the peak torque acts
    # Speed of the ring if pins and ring are both outputs, positive as the crank turns, rad/s.
    ring_speed: float | None = None
    carrier_speed: float | None = None  # speed of the pins, given in place of the ring's, rad/s

    @property
    def by_ring(self) -> bool:
        """True if the speed of the ring is given, not that of the pins."""
        return self.ring_speed is not None


class PairSizes(NamedTuple):
    """Sizes of a pair of pin and hole, m."""

    contact_length: float  # b
    pin_radius: float  # r_in
    hole_radius: float  # r_out


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """Pin, hole and eccentricity with their materials; pins are left out for a crank alone."""

    contact_length: float | None = None  # b, m
    pin_radius: float | None = None  # r_in, m
    hole_radius: float | None = None  # r_out, m
    eccentricity: float | None = None  # e, m
    pin_material: ElasticMaterial | None = None  # material of the pin's surface, or of its sleeve
    hole_material: ElasticMaterial | None = None  # material of the satellite
    distribution_factor: float = 1.0  # K_alpha, load-sharing factor on the largest force
    distribution_of: SharedBy | None = None  # origin of that factor; None: discs if several
    clearance_stated: bool = False  # True if a clearance is stated, which may be 0
    iso_fit: str = ""  # fit of the clearance, such as H7/f7; empty if stated as a number


@dataclass(frozen=True, slots=True, kw_only=True)
class SatelliteBody:
    """Body of a satellite, as far as it is given: radii, m."""

    outer_radius: float | None = None  # r_o, tips of the teeth
    root_radius: float | None = None  # r_f, roots of the teeth
    bore_radius: float | None = None  # r_b
    solid_wall: float | None = None  # solid wall of a printed disc around its holes


@dataclass(frozen=True, slots=True, kw_only=True)
class Temperatures:
    """Temperatures of parts at work, as far as they are given, degrees Celsius."""

    satellite: float | None = None  # temperature of the satellites
    pins: float | None = None  # temperature of the pins


USUAL_LIFE = 5000 * 3600.0
"""Required life if none is given, s; a tenth of it for plastics."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Requirements:
    """Limits that a design has to keep; a limit of None is not checked."""

    scope: tuple[PartName, ...] = PART_NAMES  # parts of the reducer that are judged
    pitting_safety: float = 1.2  # safety of the contact pressure
    bending_safety: float = 1.5  # safety of the pins against yield
    fatigue_safety: float = 1.5  # safety of the pins in fatigue
    static_safety: float | None = None  # safety of bearings; None: `STATIC_SAFETY` of their kind
    life: float | None = None  # s; infinite if not checked; None: `USUAL_LIFE`, for plastics 1/10
    min_wall: float | None = None  # m
    max_backlash: float | None = None  # rad
    max_lost_motion: float | None = None  # rad
    max_ring_backlash: float | None = None  # backlash of the teeth alone, rad
    max_transmission_error: float | None = None  # transmission error of the teeth alone, rad
    max_deflection: float | None = None  # deflection of the pins, m
    max_slope: float | None = None  # slope of the pins, rad
    min_efficiency: float | None = None  # efficiency of the output mechanism
    min_ring_efficiency: float | None = None  # efficiency of the teeth alone
    max_seat_pressure: float | None = None  # pressure of ring pins on the area of their seats, Pa
    max_wear: float | None = None  # depth, m
    max_pv: float | None = None  # pressure times speed, Pa*m/s
    max_sliding_speed: float | None = None  # m/s
    max_outer_diameter: float | None = None  # outer diameter of the reducer, m
    max_unbalance: float | None = None  # force of all parts that turn with the crankshaft, N
    max_unbalance_couple: float | None = None  # couple of the parts that turn with it, N*m
    max_unbalance_share: float | None = None  # on a crankshaft bearing, over its working load
    balance_grade: float | None = None  # speed of the centre of mass about the axis, m/s


@dataclass(frozen=True, slots=True)
class DesignPin(PinSupport):
    """Pin with its support, section and strength; see `core.output.elasticity.PinSupport`."""

    contact_length: float | None = None  # along the pin, m; None: that of the contact
    rotates: bool = False  # True if the pin turns in the carrier
    tensile_strength: float | None = None  # tensile strength of the material, Pa
    steel: bool = False  # True if a rule of the endurance limit exists for the material
    valid_diameter: float | None = None  # largest diameter that the strengths hold for, m
    bolt: PinBolt | None = None  # bolt through the pin, which is a spacer then
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
class FatigueBasis:
    """Factors and criterion of the fatigue strength of a pin, as far as they are given."""

    surface: Surface | None = None  # manufacture of the surface
    surface_factor: float | None = None  # in place of `surface`
    edition: Edition = "shigley_11"  # source of the constants of the surface
    reliability_percent: float | None = None  # None: 50
    reliability_factor: float | None = None  # in place of the reliability
    fatigue_notch_factor: float | None = None  # Kf of the seat or a notch
    notch: tuple[float, float] | None = None  # Kt and notch radius, m, in place of Kf
    endurance_limit: float | None = None  # Se with all factors, Pa
    criterion: Criterion = "goodman"  # effect of the mean stress
    life: float | None = None  # s; None: the required life

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
            theoretical, radius = self.notch
            strength = tensile / 1e6
            beyond += beyond_range(
                code="notch_beyond_strength", value=strength, ends=NOTCH_STRENGTHS
            )
            notch = float(
                notch_factor(
                    theoretical_factor=theoretical, radius=radius, tensile_strength=tensile
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

    coefficient: float  # friction coefficient
    sleeve: bool = False  # True if sleeves roll in the holes
    wear_rate: float | None = None  # worn volume over force and distance, m^2/N
    life: float | None = None  # time of wear, s; None: the required life


@dataclass(frozen=True, slots=True, kw_only=True)
class Rollers:
    """Rolling bearings on the pins whose outer rings roll in the holes, as catalogues give them."""

    kind: RollerKind  # kind of rolling elements
    ratings: Ratings = "bearing"  # load ratings of a bearing in a rigid seat, or of a roller
    bore_diameter: float  # d, diameter of the pins, m
    outer_diameter: float | None = None  # D, twice the radius that touches the hole, m
    width: float = math.inf  # B of one, m; infinite if not given
    per_satellite: int = 1  # rollers side by side under each satellite
    dynamic_rating: float | None = None  # C of one, N
    static_rating: float | None = None  # C0, N
    rolling_elements: int | None = None  # Z
    max_radial_load: float = math.inf  # F_r allowed by the maker, N; infinite if not given
    max_static_radial_load: float = math.inf  # F_0r allowed, N; infinite if not given
    # G_r, radial internal clearance, m: an outer ring moves by half of it to either side.
    radial_clearance: float | None = None
    friction_coefficient: float | None = None  # mu_b, at the bore
    limiting_speed: float | None = None  # speed of the outer ring on the pin, rad/s

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
        for field, size in given:
            if not self.bore_diameter < size:
                bore, than = self.bore_diameter, {"field": field, "limit": size}
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
class RollingBearing:
    """Rolling bearing, as its catalogue gives it."""

    kind: Bearing  # kind of rolling elements
    dynamic_rating: float | None = None  # C, N
    static_rating: float | None = None  # C0, N
    reliability_percent: float = 90.0  # share of bearings that reach the life
    ring_factor: float = 1.0  # factor V of the equivalent load
    weibull_slope: float | None = None  # slope of the distribution of lives
    bore_diameter: float | None = None  # d, m
    outer_diameter: float | None = None  # D, m
    width: float | None = None  # B, m
    limiting_speed: float | None = None  # speed of its rings against each other, rad/s
    seat: Seat = "housing"  # part that holds a crankshaft bearing

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
class Shaft:
    """Crankshaft with the places of its loads and bearings."""

    satellite_positions: tuple[float, ...]  # middle plane of each satellite along the shaft, m
    bearing_positions: tuple[float, float]  # m
    satellite_mass: float | None = None  # satellite and bearing, kg
    counterweights: tuple[Counterweight, ...] = ()
    rotor_mass: float | None = None  # all parts turning with the shaft, kg; None: satellites
    bearings: tuple[RollingBearing, ...] = ()  # two, or empty if not given
    eccentric_diameter: float | None = None  # diameter of the crank in its bearing, m
    shaft_diameter: float | None = None  # between the cranks, m

    @property
    def known_bearings(self) -> tuple[RollingBearing, ...]:
        """Both bearings of the crankshaft; `NotKnown` if they are not given."""
        if not self.bearings:
            raise NotKnown("rating_unknown", "crankshaft.bearings")
        return self.bearings
