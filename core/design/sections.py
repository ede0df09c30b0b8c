"""Sections of the design document in SI units: mechanism, load, contact, pin, fatigue, friction,
bearings, crankshaft, body of the satellite, requirements.
"""

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
"""Whose uneven share a distribution factor states: of satellites, or of the pairs of one."""

PeakKind = Literal["start", "emergency"]

Seat = Literal["housing", "carrier", "ring"]

PartName = Literal[
    "contact", "pins", "teeth", "satellite_bearing", "crank_bearings", "body", "losses"
]

PART_NAMES: tuple[PartName, ...] = get_args(PartName)
"""Parts of a reducer: `PARTS` of `core.checks.crank_planetary`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MechanismSection:
    """Pins, satellites and cranks."""

    pins: int  # N
    satellites: int  # K
    ratio: float  # u; infinite of a coupling
    output: Output = "pins"
    crank_spacing: float | None = None  # between neighbours, rad; None for an even spacing
    crank_angles: tuple[float, ...] = ()  # of each crank, rad, instead of a spacing
    initial_crank_angle: float = 0.0  # wave angle at crank angle 0, rad
    satellite_teeth: int | None = None  # z2


@dataclass(frozen=True, slots=True, kw_only=True)
class Load:
    """Torque of the output, its direction, its lever, and the speeds.

    Attributes
    ----------
    torque_direction : {"driving", "reverse", "alternating"}
        Direction of the torque; of both the worse is judged.
    application_factor : float or None
        Factor on the torque for stresses; that of the contact where not given.
    peak_torque : float or None
        Largest torque, for static strength, N*m, at least the torque times its factor; that where
        not given.
    """

    output_torque: float  # of the output, where both are it on the pins, N*m
    pin_circle_radius: float  # R, m
    force_exponent: float = 1.0  # v, of the force over the approach
    torque_direction: Direction = "driving"
    input_speed: float | None = None  # of the crank, rad/s
    application_factor: float | None = None
    peak_torque: float | None = None
    peak_kind: PeakKind = "start"  # at which the peak torque acts
    ring_speed: float | None = None  # where both are the output, in the sense of the crank, rad/s
    carrier_speed: float | None = None  # the same of the pins, instead, rad/s

    @property
    def by_ring(self) -> bool:
        """Whether the speed of the ring is given, not that of the pins."""
        return self.ring_speed is not None


class PairSizes(NamedTuple):
    """Sizes of a pair of pin and hole that touch, m."""

    contact_length: float  # b
    pin_radius: float  # r_in
    hole_radius: float  # r_out


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """Pin and hole, the crank between them, and their materials; of the crank alone no pins."""

    contact_length: float | None = None  # b, m
    pin_radius: float | None = None  # r_in, m
    hole_radius: float | None = None  # r_out, m
    eccentricity: float | None = None  # e, m
    pin_material: ElasticMaterial | None = None  # that of the pin's surface, or of its sleeve
    hole_material: ElasticMaterial | None = None  # that of the satellite
    dynamic_factor: float = 1.0  # on the force, where the load has no application factor
    distribution_factor: float = 1.0  # K_alpha, on the largest force by an uneven share
    distribution_of: SharedBy | None = None  # whose share; None: discs where there are several
    clearance_stated: bool = False  # whether one of 0 is: else a hole of just pin and e says none
    iso_fit: str = ""  # the classes that the clearance is of, as H7/f7; empty where it is a number


@dataclass(frozen=True, slots=True, kw_only=True)
class SatelliteBody:
    """The body of a satellite, as far as it is given: radii, m."""

    outer_radius: float | None = None  # r_o, with its teeth
    root_radius: float | None = None  # r_f, of its teeth
    bore_radius: float | None = None  # r_b
    solid_wall: float | None = None  # of a printed one, behind the surface of its holes


@dataclass(frozen=True, slots=True, kw_only=True)
class Temperatures:
    """Temperatures of parts at work, as far as they are given, degrees Celsius."""

    satellite: float | None = None  # of the satellites
    pins: float | None = None  # of the pins


USUAL_LIFE = 5000 * 3600.0
"""Life that is required where none is given, s; of plastics a tenth."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Requirements:
    """What a design has to keep; what is None is not asked.

    Attributes
    ----------
    scope : tuple of str
        Parts of the reducer that are judged.
    pitting_safety : float
        Required safety against pitting, of the pressure.
    bending_safety, fatigue_safety : float
        Required safety of the pins against yield, and in fatigue.
    static_safety : float or None
        Required safety of bearings against their static rating; `STATIC_SAFETY` of their kind where
        not given.
    life : float
        Required life, s; infinite where none is asked, `USUAL_LIFE` where it is not given, a tenth
        of it where a body is of plastic.
    min_efficiency, min_ring_efficiency : float or None
        Least efficiency of the output mechanism, and of the teeth alone.
    max_seat_pressure : float or None
        Largest pressure of the ring's pins in their seats, on the area that they cover, Pa.
    max_unbalance, max_unbalance_couple : float or None
        Largest force, N, and couple, N*m, of what turns with the crankshaft.
    max_unbalance_share : float or None
        Largest force of it on a bearing of the crankshaft over the load of the mechanism there.
    balance_grade : float or None
        Largest speed of the centre of what turns about the axis, m/s.
    """

    scope: tuple[PartName, ...] = PART_NAMES
    pitting_safety: float = 1.2
    bending_safety: float = 1.5
    fatigue_safety: float = 1.5
    static_safety: float | None = None
    life: float | None = None  # s; None: usual
    min_wall: float | None = None  # m
    max_backlash: float | None = None  # rad
    max_lost_motion: float | None = None  # rad
    max_ring_backlash: float | None = None  # of the teeth alone, rad
    max_transmission_error: float | None = None  # of the teeth alone, rad
    max_deflection: float | None = None  # of the pins, m
    max_slope: float | None = None  # of the pins, rad
    min_efficiency: float | None = None
    min_ring_efficiency: float | None = None
    max_seat_pressure: float | None = None
    max_wear: float | None = None  # depth, m
    max_pv: float | None = None  # pressure times speed, Pa*m/s
    max_sliding_speed: float | None = None  # m/s
    max_outer_diameter: float | None = None  # of the reducer, m
    max_unbalance: float | None = None
    max_unbalance_couple: float | None = None
    max_unbalance_share: float | None = None
    balance_grade: float | None = None


@dataclass(frozen=True, slots=True)
class DesignPin(PinSupport):
    """A pin as it bends and breaks.

    Attributes
    ----------
    support : {"cantilever", "supported", "fixed", "tie_ring"}
        Held at one end, simply supported at both, clamped at both, at one with a tie ring that
        joins the others.
    diameter : float
        Diameter d of the pin itself, m.
    satellite_positions : tuple of float
        Distance z_j of the middle of each satellite from the support, m; none where it is rigid.
    material : ElasticMaterial
        The pin's material, with its yield strength.
    span : float or None
        Distance L of the supports, or of the tie ring from the carrier, m.
    bore_diameter : float
        Diameter d_i of its bore, m; 0 of a solid pin.
    ring_joint : {"pinned", "clamped"}
        Of a tie ring to the pins.
    contact_length : float or None
        Length of the contact along it, m; that of the contact where not given.
    rotates : bool
        Whether it turns in the carrier.
    tensile_strength : float or None
        Of its material, Pa; the yield strength is the material's own.
    steel : bool
        Whether that is a steel, for which there is a rule of the endurance limit.
    valid_diameter : float or None
        Largest diameter that these strengths hold for, m.
    bolt : PinBolt or None
        The bolt through the pin, which is its spacer then.
    material_path : str
        Where its material stands in the design.
    """

    contact_length: float | None = None
    rotates: bool = False
    tensile_strength: float | None = None
    steel: bool = False
    valid_diameter: float | None = None
    bolt: PinBolt | None = None
    material_path: str = "pin.material"

    @property
    def thick(self) -> tuple[Notice, ...]:
        """That it is thicker than its material's strengths hold for, where it is."""
        valid = self.valid_diameter
        if valid is None or self.diameter <= valid:
            return ()
        return (Notice("beyond_size", {"limit": valid * 1e3}),)

    def bolt_alone(self, bolt: PinBolt) -> "DesignPin":
        """The bolt as the pin: the spacer is only what touches the hole."""
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
"""Reliability of a pin's fatigue strength where none is given, %."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FatigueBasis:
    """What the fatigue of a pin is judged by, as far as it is given.

    Attributes
    ----------
    surface : {"ground", "machined", "hot_rolled", "forged"} or None
        How the surface was made.
    surface_factor : float or None
        Its factor instead.
    edition : {"shigley_9", "shigley_11"}
        Whose constants of the surface.
    reliability_percent, reliability_factor : float or None
        Reliability, or its factor; 50 % where neither is given.
    fatigue_notch_factor : float or None
        Factor Kf of the seat or a notch.
    notch : tuple of float or None
        Its theoretical factor Kt and its radius, m, instead.
    endurance_limit : float or None
        Endurance limit Se, Pa, all factors in it.
    criterion : {"goodman", "gerber", "soderberg", "fkm_haigh"}
        How the mean stress counts.
    life : float or None
        Time that the part has to last, s; the required life where not given.
    """

    surface: Surface | None = None
    surface_factor: float | None = None
    edition: Edition = "shigley_11"
    reliability_percent: float | None = None
    reliability_factor: float | None = None
    fatigue_notch_factor: float | None = None
    notch: tuple[float, float] | None = None
    endurance_limit: float | None = None
    criterion: Criterion = "goodman"
    life: float | None = None

    def strength(self, pin: DesignPin) -> FatigueStrength:
        """What a pin's fatigue is judged by.

        Parameters
        ----------
        pin : DesignPin
            The pin; the limit falls with its diameter.

        Returns
        -------
        FatigueStrength

        Raises
        ------
        InvalidInput
            If the criterion needs a yield strength that is not known.
        NotKnown
            If it needs another value that is not given.
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
        """What the fatigue of a round part is judged by.

        Parameters
        ----------
        diameter : float
            Its diameter, m.
        tensile_strength, yield_strength : float or None
            Of its material, Pa.
        steel : bool
            Whether that is a steel.
        material_path : str
            Where it stands in the design.

        Returns
        -------
        FatigueStrength

        Raises
        ------
        InvalidInput
            If the criterion needs a yield strength that is not known.
        NotKnown
            If it needs another value that is not given.
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
    """Friction and wear of pin and hole, or of pin and sleeve.

    Attributes
    ----------
    coefficient : float
        Friction coefficient, dimensionless.
    sleeve : bool
        Whether sleeves roll in the holes.
    wear_rate : float or None
        Worn volume over force and distance, m^2/N.
    life : float or None
        Time in which it wears, s; the required life where not given.
    """

    coefficient: float
    sleeve: bool = False
    wear_rate: float | None = None
    life: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Rollers:
    """Rolling bearings on the pins, whose outer rings roll in the holes, as catalogues give them.

    Attributes
    ----------
    kind : {"ball", "cylindrical", "needle"}
        What rolls.
    ratings : {"bearing", "roller"}
        What the load ratings are of: a bearing in a rigid seat, or a roller.
    bore_diameter : float
        That of the pins, m.
    outer_diameter : float or None
        Twice the radius that touches the hole, m.
    per_satellite : int
        Rollers side by side under each satellite.
    radial_clearance : float or None
        Radial internal clearance, m: an outer ring moves by half of it to either side.
    """

    kind: RollerKind
    ratings: Ratings = "bearing"
    bore_diameter: float  # d
    outer_diameter: float | None = None  # D
    width: float = math.inf  # B of one, m; infinite where not given
    per_satellite: int = 1
    dynamic_rating: float | None = None  # C of one, N
    static_rating: float | None = None  # C0, N
    rolling_elements: int | None = None  # Z
    max_radial_load: float = math.inf  # F_r that its maker allows, N; infinite where not given
    max_static_radial_load: float = math.inf  # F_0r likewise, N
    radial_clearance: float | None = None  # G_r
    friction_coefficient: float | None = None  # mu_b, at the bore
    limiting_speed: float | None = None  # of the outer ring on the pin, rad/s

    @property
    def play(self) -> float:
        """What an outer ring gives to either side, m."""
        return (self.radial_clearance or 0.0) / 2

    @property
    def length(self) -> float:
        """Of all rollers under a satellite, m; infinite where their width is not given."""
        return self.per_satellite * self.width

    def check(self, *, pin_radius: float | None, pin_diameter: float | None) -> None:
        """Refuse sizes that contradict each other, and rollers without a ring of their own.

        Parameters
        ----------
        pin_radius : float or None
            Radius of what touches the hole, m.
        pin_diameter : float or None
            Of the pins, m.

        Raises
        ------
        InvalidInput
            If they do.
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
        """Friction of the output: that of the rollers, on their pins.

        Parameters
        ----------
        given : Friction or None
            What is given of it besides.

        Returns
        -------
        Friction
        """
        coefficient = self.friction_coefficient
        if coefficient is None:
            coefficient = given.coefficient if given else FRICTION[self.kind]
        return Friction(coefficient=coefficient, sleeve=True)


@dataclass(frozen=True, slots=True, kw_only=True)
class RollingBearing:
    """A rolling bearing as its catalogue gives it.

    Attributes
    ----------
    kind : {"ball", "roller"}
        Rolling elements.
    dynamic_rating, static_rating : float or None
        Basic load ratings C and C0, N.
    reliability_percent : float
        Share of bearings that reach the life.
    ring_factor : float
        Factor V of the equivalent load.
    weibull_slope : float or None
        Slope of the distribution of lives.
    """

    kind: Bearing
    dynamic_rating: float | None = None
    static_rating: float | None = None
    reliability_percent: float = 90.0
    ring_factor: float = 1.0
    weibull_slope: float | None = None
    bore_diameter: float | None = None  # d, m
    outer_diameter: float | None = None  # D, m
    width: float | None = None  # B, m
    limiting_speed: float | None = None  # of its rings against each other, rad/s
    seat: Seat = "housing"  # what one of the crankshaft sits in

    @property
    def sizes(self) -> tuple[float, float, float] | tuple[()]:
        """Bore, outer diameter and width, m; none where they are not all given."""
        bore, outer, width = self.bore_diameter, self.outer_diameter, self.width
        return () if bore is None or outer is None or width is None else (bore, outer, width)

    def check_sizes(self, path: str) -> None:
        """Refuse a bore that is not smaller than the outside.

        Parameters
        ----------
        path : str
            Path of the bearing in its design.

        Raises
        ------
        InvalidInput
            If it is not.
        """
        bore, outer = self.bore_diameter, self.outer_diameter
        if bore is not None and outer is not None and not bore < outer:
            than = {"field": "outer_diameter", "limit": outer}
            raise InvalidInput(f"{path}.bore_diameter", bore, "smaller_than", **than)


@dataclass(frozen=True, slots=True, kw_only=True)
class Shaft:
    """The crankshaft: where its loads and bearings are.

    Attributes
    ----------
    satellite_positions : tuple of float
        Middle plane of each satellite along the shaft, m.
    bearing_positions : tuple of float
        Places of both bearings, m.
    satellite_mass : float or None
        Mass of a satellite with its bearing, kg.
    counterweights : tuple of Counterweight
        Masses on the shaft besides them.
    rotor_mass : float or None
        Mass of all that turns with the shaft, kg; that of the satellites where not given.
    bearings : tuple of RollingBearing
        Both bearings; none where they are not given.
    """

    satellite_positions: tuple[float, ...]
    bearing_positions: tuple[float, float]
    satellite_mass: float | None = None
    counterweights: tuple[Counterweight, ...] = ()
    rotor_mass: float | None = None
    bearings: tuple[RollingBearing, ...] = ()
    eccentric_diameter: float | None = None  # of the crank in its bearing, m
    shaft_diameter: float | None = None  # between the cranks, m

    @property
    def known_bearings(self) -> tuple[RollingBearing, ...]:
        """Both bearings, which have to be given."""
        if not self.bearings:
            raise NotKnown("rating_unknown", "crankshaft.bearings")
        return self.bearings
