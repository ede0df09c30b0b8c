"""Design document of a crank-planetary reducer in SI units, nested as its JSON is: a path in it is
the JSON pointer without the unit (`contact.pin_radius`).
"""

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from functools import cached_property, lru_cache, partial
from typing import Annotated, Any, TypeVar, cast

from core.arrays import check_count
from core.design.contact import Contact, PairSizes, SharedBy
from core.design.layout import PLACED, Layout
from core.design.ring import (
    RINGS,
    CycloidRing,
    InvoluteRing,
    Ring,
    RingBody,
    RingClass,
    soft,
    usual_sizes,
)
from core.design.sections import (
    USUAL_LIFE,
    USUAL_RELIABILITY,
    Build,
    DesignPin,
    FatigueBasis,
    Friction,
    Load,
    MechanismSection,
    Requirements,
    Rollers,
    RollingBearing,
    SatelliteBody,
    Shaft,
    Temperatures,
)
from core.design.tolerances import ToleranceSection
from core.errors import InvalidInput, NotKnown, derived, if_known, is_known, required, within
from core.hertz import SLIDING as KNOWN_SLIDING
from core.hertz import Body, ElasticMaterial, Plastic, Spread
from core.output.elasticity import (
    COUPLINGS,
    LAWS,
    RIGID_SUPPORT,
    ContactLaw,
    CrankSupport,
    RingInSeries,
    SatelliteSupport,
    Supports,
)
from core.output.mechanism import Mechanism, Members, MemberSpeeds, PinFit, pin_fit
from core.output.pin_beam import check_apart
from core.output.pin_section import MOST_BORE
from core.output.room import Deviations
from core.precision import AS_TYPED, SAME
from core.ring.sharing import RingDeviations

DRAWN = 1e-3
"""Relative amount of a distance that may be lost by rounding on a drawing."""

WALL_GUIDE = 0.03
"""Least usual wall between holes over the diameter of the ring pin circle (Wang 2016, 32, 33)."""

RINGLESS = ("teeth", "satellite_bearing", "crank_bearings")
"""Parts of a reducer that a coupling does not have."""

SHARPEST = 0.2
"""Least usual tip radius of a hob, in modules."""


class NotGiven:
    """Placeholder of a section that is not given: false; reading an attribute raises `NotKnown`."""

    def __init__(self, section: str) -> None:
        self.section = section

    def __bool__(self) -> bool:
        return False

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        raise NotKnown("section_missing", self.section)


def not_given(section: str) -> Any:
    """Default value of a section, given by its path, that may be left out: a `NotGiven`."""
    return NotGiven(section)


@lru_cache(maxsize=1024)
def mechanism_of(given: MechanismSection) -> Mechanism:
    """Mechanism of pins and cranks of a section; equal sections share one cached object.

    Raises NotKnown without a number of pins.
    """
    pins = required(given.pins, "size_missing", "mechanism.pins")
    if given.crank_angles:
        return Mechanism(
            pins=pins,
            crank_angles=given.crank_angles,
            ratio=given.ratio,
            initial_crank_angle=given.initial_crank_angle,
        )
    return Mechanism.evenly_spaced(
        pins=pins,
        satellites=given.satellites,
        ratio=given.ratio,
        crank_spacing=given.crank_spacing,
        initial_crank_angle=given.initial_crank_angle,
    )


@dataclass(frozen=True, kw_only=True)
class Design(Layout):
    """Crank-planetary reducer, as far as it is given.

    A section that is not given is false, and reading from it raises `NotKnown`. Where a document
    states another type than the design has, that stands in `Annotated`.

    Raises
    ------
    InvalidInput
        If sections contradict each other: the peak torque is below the working torque, the
        load-sharing factor is below 1 or gives a satellite more than the whole torque, satellites
        overlap or lie differently on pins and crankshaft, a pin is thicker than the surface that
        touches the hole, rollers or ring pins do not fit, or housing or carrier are smaller than
        what they hold.
    """

    mechanism: MechanismSection  # pins, satellites, cranks, ratio
    load: Load = not_given("load")
    contact: Contact = not_given("contact")
    # Elastic law of a pair; None: by Hertz.
    contact_law: Annotated[ContactLaw | None, LAWS] = None
    # Measured deviations of this piece; None: none stated.
    deviations: Annotated[Deviations | None, Deviations] = None
    # Elasticity between satellites and cranks.
    crank_support: Annotated[SatelliteSupport, CrankSupport] = RIGID_SUPPORT
    # Elasticity between satellites and ring, or `RingInSeries` to solve both meshes in series.
    satellite_coupling: Annotated[SatelliteSupport, COUPLINGS] = RIGID_SUPPORT
    pin: DesignPin = not_given("pin")  # support, bending and strength
    fatigue: FatigueBasis = not_given("fatigue")  # basis of the fatigue strength of the pins
    friction: Friction = not_given("friction")
    rollers: Rollers = not_given("rollers")  # rolling bearings on the pins
    gear: Annotated[Ring, RINGS] = not_given("gear")  # teeth or pins of the ring
    bearing: RollingBearing = not_given("bearing")  # satellite bearing on the crank
    crankshaft: Shaft = not_given("crankshaft")  # places of satellites and bearings
    satellite_body: SatelliteBody = not_given("satellite_body")
    build: Build = Build()  # carrier and housing around the discs
    temperatures: Temperatures = not_given("temperatures")
    tolerances: ToleranceSection = not_given("tolerances")  # of pieces, for studies
    requirements: Requirements = Requirements()

    def __post_init__(self) -> None:
        self._follow()
        self._check_build()
        self._check_peak()
        self._check_distribution()
        self._check_places()
        self._check_rollers()
        self._check_thickness()
        self._check_ring_pins()
        self._check_lists()
        if self.bearing:
            self.bearing.check_sizes("bearing")
        for index, each in enumerate(self.crankshaft.bearings if self.crankshaft else ()):
            each.check_sizes(f"crankshaft.bearings[{index}]")

    def _follow(self) -> None:
        """Set the places that follow from `build`, as far as they are known."""
        for path in self.build.follows:
            name, field = path.split(".")
            section: Any = getattr(self, name)
            with suppress(NotKnown):
                value = getattr(self, PLACED[path])
                object.__setattr__(self, name, section and replace(section, **{field: value}))

    def _check_build(self) -> None:
        """Refuse a housing smaller than the ring, and a carrier smaller than the pin circle."""
        least = {
            "housing_diameter": lambda: 2 * self.ring_reach,
            "carrier_diameter": lambda: 2 * self.pin_circle_radius + self.pin_diameter,
        }
        for name, calculate in least.items():
            given = getattr(self.build, name)
            limit = if_known(calculate) if given else None
            if limit and given < limit * (1 - AS_TYPED):
                raise InvalidInput(f"build.{name}", given, "greater_than_equal", limit=limit)

    def _check_places(self) -> None:
        """Refuse satellites that overlap, or whose distances on pins and crankshaft differ; the
        axis of the crankshaft may point the other way.
        """
        on_pins = self.pin.satellite_positions if self.pin else ()
        on_shaft = self.crankshaft.satellite_positions if self.crankshaft else ()
        if not (on_pins or on_shaft):
            return
        with suppress(NotKnown):
            for section, places in (("pin", on_pins), ("crankshaft", on_shaft)):
                name = f"{section}.satellite_positions"
                check_apart(name=name, positions=places, width=self.pin_length)
        if not on_pins or len(on_pins) != len(on_shaft):
            return
        away = [place - on_shaft[0] for place in on_shaft]
        wanted = [place - on_pins[0] for place in on_pins]
        way = math.copysign(1.0, away[-1] * wanted[-1])
        for index, (here, there) in enumerate(zip(away, wanted, strict=True)):
            if abs(here - way * there) > DRAWN * abs(there):
                name = f"crankshaft.satellite_positions[{index}]"
                raise InvalidInput(name, on_shaft[index], "other_pitch", limit=abs(there))

    def _check_thickness(self) -> None:
        """Refuse a pin thicker than its sleeve, and a bore nearly as wide as its pin."""
        bore, widest = (self.pin.bore_diameter, self.pin.diameter) if self.pin else (0.0, 0.0)
        if bore > MOST_BORE * widest:
            limit = MOST_BORE * widest
            raise InvalidInput("pin.bore_diameter", bore, "less_than_equal", limit=limit)
        if not (self.pin and self.touching):
            return
        radius, diameter = self.nominal_pair.pin_radius, self.pin.diameter
        if diameter > 2 * radius * (1 + SAME):
            most = {"field": "pin_radius", "limit": 2 * radius}
            raise InvalidInput("pin.diameter", diameter, "too_thick", **most)

    def _check_ring_pins(self) -> None:
        """Refuse ring pins whose places, width, number or sleeve bore do not fit the satellites."""
        ring = self.gear
        if not isinstance(ring, CycloidRing):
            return
        places, satellites = ring.satellite_positions, self.mechanism.satellites
        if places:
            check_count(satellites, **{"gear.satellite_positions": places})
        with suppress(NotKnown):
            width = self.ring_length
            check_apart(name="gear.satellite_positions", positions=places, width=width)
        with suppress(NotKnown):
            if ring.every_second_pin and self.ring_pins % 2:
                pins = self.ring_pins
                raise InvalidInput("gear.every_second_pin", True, "odd_ring_pins", pins=pins)
        with suppress(NotKnown):
            bore, radius = ring.sleeve_bore_radius, ring.known_pin_radius
            if not bore < radius:
                than = {"field": "ring_pin_radius", "limit": radius}
                raise InvalidInput("gear.sleeve_bore_radius", bore, "smaller_than", **than)

    def _check_lists(self) -> None:
        """Refuse deviations and shares that are not one for each part of a known number."""
        pins, satellites = self.mechanism.pins, self.mechanism.satellites
        shares = self.satellite_coupling.given_shares
        if shares:
            check_count(satellites, **{"satellite_coupling.shares": shares})
        if self.deviations is not None:
            known = if_known(lambda: self.ring_pins) if self.deviations.of_ring else None
            numbers: dict[str, Any] = {"pins": pins, "satellites": satellites, "ring_pins": known}
            within("deviations", partial(self.deviations.check, **numbers))

    def _check_rollers(self) -> None:
        """Refuse rollers that do not fit pins and holes, and a sleeve beside rollers."""
        rollers = self.rollers
        if not rollers:
            return
        rollers.check(
            pin_radius=self.contact.pin_radius if self.contact else None,
            pin_diameter=self.pin.diameter if self.pin else None,
        )
        if self.friction and self.friction.sleeve:
            raise InvalidInput("friction.sleeve", True, "only_one", field="rollers")

    def _check_distribution(self) -> None:
        """Refuse a load-sharing factor below 1, or above the whole torque for one satellite."""
        name = "contact.distribution_factor"
        factor, most = (self.contact.distribution_factor if self.contact else 1.0), math.inf
        if self.distribution_of == "discs":
            most = self.mechanism.satellites
        if factor < 1:
            raise InvalidInput(name, factor, "greater_than_equal", limit=1.0)
        if factor > most:
            raise InvalidInput(name, factor, "more_than_whole", limit=most)
        if factor > 1 and self.as_made:
            raise InvalidInput(name, factor, "with_real_forces")

    def _check_peak(self) -> None:
        given = self.load and self.load.output_torque is not None
        if given and self.static_share < 1 - AS_TYPED:
            working = self.output_torque * self.load_factor
            peak = self.load.peak_torque
            raise InvalidInput("load.peak_torque", peak, "below_working", limit=working)

    @property
    def built(self) -> Mechanism:
        """Mechanism of pins and cranks."""
        return mechanism_of(self.mechanism)

    @property
    def pin_fit(self) -> PinFit:
        """Fit of pins in holes; `NotKnown` without pins."""
        lacks = ("section_missing", "contact")
        return pin_fit(
            pins=self.pin_count,
            pin_radius=required(self.contact.pin_radius, *lacks),
            hole_radius=required(self.contact.hole_radius, *lacks),
            eccentricity=self.contact.eccentricity,
            pin_circle_radius=(self.load.pin_circle_radius if self.load else None) or math.inf,
        )

    @property
    def crank_angles(self) -> tuple[float, ...]:
        """Angle of each crank, rad."""
        own = self.mechanism
        return mechanism_of(own if own.pins else replace(own, pins=1)).crank_angles

    @property
    def pairs(self) -> int:
        """Number of pairs of pin and hole."""
        return self.pin_count * self.mechanism.satellites

    @property
    def support(self) -> SatelliteSupport:
        """Elasticity of the satellites on their cranks and in their mesh."""
        return Supports(self.crank_support, self.satellite_coupling)

    @property
    def in_series(self) -> bool:
        """True if both meshes are solved in series, which needs cycloid discs of known
        modification, a known clearance of pins and holes, and no stated load-sharing factor.
        """
        gear, contact = self.gear, self.contact
        if (
            not isinstance(self.satellite_coupling, RingInSeries)
            or not gear
            or gear.kind != "cycloid"
            or gear.modification is None
        ):
            return False
        known = self.touching and is_known(lambda: self.known_clearance)
        return known and contact.distribution_factor == 1

    @property
    def bolted(self) -> bool:
        """True if the pins are bolts through spacers."""
        return bool(self.pin) and self.pin.bolt is not None

    @property
    def tied(self) -> bool:
        """True if a tie ring joins the pins."""
        return bool(self.pin) and self.pin.support == "tie_ring"

    @property
    def touching(self) -> bool:
        """True if pins and holes are given."""
        return bool(self.contact) and self.contact.pin_radius is not None

    @property
    def as_made(self) -> bool:
        """True if clearance, deviations, contact law, elasticity or meshes in series are stated."""
        clearance = self.play
        if self.touching and not self.clearance_unknown:
            clearance += self.roller_play
        given = clearance > 0 or self.support.gives
        return given or bool(self.contact_law or self.output_deviations) or self.in_series

    @property
    def output_deviations(self) -> Deviations | None:
        """Deviations of pins, holes and cranks; None if at most those of the ring are stated."""
        made = self.deviations
        if made is None or (made.of_ring and made.of_output == Deviations()):
            return None
        return made.of_output

    @property
    def ring_deviations(self) -> RingDeviations:
        """Deviations of ring pins, cranks and discs."""
        made = self.deviations or Deviations()
        return RingDeviations(
            pin_radial=made.ring_pin_radial,
            pin_tangential=made.ring_pin_tangential,
            pin_radius=made.ring_pin_radius,
            eccentricity=made.eccentricity,
            crank_phase=made.crank_phase,
            disc_phase=made.disc_phase,
        )

    @property
    def ring_class(self) -> RingClass:
        """Manufacture of discs and ring pins: as stated, printed if discs are soft, else ground."""
        return self.cycloid.ring_class or ("printed" if soft(self.disc_material) else "ground")

    @property
    def ring_zone(self) -> float:
        """Diameter of the round zone of each ring pin's centre, m: stated, or that of the class."""
        stated = self.tolerances.ring_pin_position if self.tolerances else None
        circle = self.cycloid.ring_pin_circle_radius
        usual = 2 * usual_sizes(ring_class=self.ring_class, circle_radius=circle)[1]
        return usual if stated is None else stated

    @property
    def cycloid(self) -> CycloidRing:
        """Ring with pins; another ring raises `NotKnown`."""
        ring = self.gear
        if ring.kind != "cycloid":
            raise NotKnown("no_ring_pins")
        return ring

    @property
    def involute(self) -> InvoluteRing:
        """Ring with involute teeth; another ring raises `NotKnown`."""
        ring = self.gear
        if ring.kind != "involute":
            raise NotKnown("no_involute")
        return ring

    @property
    def lobes(self) -> int:
        """Number of lobes of a cycloid disc; `NotKnown` if a typed ratio gives no whole number."""
        ratio = self.mechanism.ratio
        lobes = ratio * (self.gear.teeth_difference or 1)
        if abs(lobes - round(lobes)) > AS_TYPED * lobes:
            raise NotKnown("ratio_not_whole", "mechanism.satellite_teeth", ratio=ratio)
        return round(lobes)

    @property
    def ring_pins(self) -> int:
        """Number of ring pins: one more than lobes if no difference is given."""
        return self.lobes + (self.gear.teeth_difference or 1)

    @property
    def ring_length(self) -> float:
        """Contact length of a disc on a ring pin, m; if not given that on the output pins."""
        of_output = self.contact.contact_length if self.contact else None
        length = self.gear.contact_length or of_output
        return required(length, "size_missing", "gear.contact_length")

    @property
    def disc_material(self) -> ElasticMaterial | None:
        """Material of the satellites' teeth; the material of their holes if it is not given."""
        of_holes = self.contact.hole_material if self.contact else None
        return self.gear.of_satellites or of_holes

    @cached_property
    def lasting_teeth(self) -> dict[RingBody, ElasticMaterial]:
        """Given materials of ring and satellite teeth, with limits for their loads over the life:
        one load per turn of the crank against the ring, and against the satellite.
        """
        life = self.life
        loads: dict[RingBody, tuple[ElasticMaterial | None, float]] = {
            "pin": (self.gear.of_ring, self.turns_over(life)),
            "disc": (self.disc_material, self.loads_over(life)),
        }
        return {
            body: each.lasting(often) for body, (each, often) in loads.items() if each is not None
        }

    @property
    def roller_play(self) -> float:
        """Movement of a roller on its pin to either side, m, which adds to the clearance."""
        return self.rollers.play if self.rollers else 0.0

    @cached_property
    def nominal_pair(self) -> PairSizes:
        """Sizes of a pair of pin and hole with the full width of the satellite."""
        contact, lacks = self.contact, ("section_missing", "contact")
        return PairSizes(
            contact_length=required(contact.contact_length, *lacks),
            pin_radius=required(contact.pin_radius, *lacks),
            hole_radius=required(contact.hole_radius, *lacks),
        )

    @property
    def pair(self) -> PairSizes:
        """Sizes of a pair that touches, whose length is at most that of the rollers."""
        pair = self.nominal_pair
        length = self.rollers.length if self.rollers else math.inf
        return pair._replace(contact_length=min(pair.contact_length, length))

    @property
    def rubs(self) -> bool:
        """True if friction of the output is known, as given or as that of rollers."""
        return bool(self.friction) or bool(self.rollers)

    @property
    def output_friction(self) -> Friction:
        """Friction of the output: in the rollers, in sleeves, or of pins in their holes."""
        return self.rollers.friction(self.friction or None) if self.rollers else self.friction

    @property
    def clearance_unknown(self) -> bool:
        """True if pins and holes are given, without a stated clearance or one by their sizes."""
        return self.touching and not (self.contact.clearance_stated or self.play)

    @derived
    def clearance(self) -> float:
        """Radial clearance, m: hole radius less pin radius and eccentricity; overlap below 0."""
        _ = required(self.contact.pin_radius, "section_missing", "contact")
        _ = self.known_eccentricity
        return required(self.contact.clearance, "section_missing", "contact")

    @property
    def play(self) -> float:
        """Radial clearance, m, or 0 if it is not known."""
        return if_known(lambda: self.clearance) or 0.0

    @property
    def scope(self) -> tuple[str, ...]:
        """Requested parts of the reducer, without teeth or cranks that the design does not have."""
        none: tuple[str, ...] = ()
        if self.members.output == "coupling":
            none = RINGLESS
        elif self.gear and self.gear.kind == "none":
            none = ("teeth",)
        return tuple(part for part in self.requirements.scope if part not in none)

    @property
    def bends(self) -> bool:
        """True if pins bend under the satellites and no load-sharing factor is stated."""
        places = self.pin.satellite_positions if self.pin and self.touching else None
        return bool(places) and self.contact.distribution_factor == 1

    @property
    def distribution_of(self) -> SharedBy:
        """Origin of the uneven share that the load-sharing factor states."""
        stated = self.contact.distribution_of if self.contact else None
        return stated or ("discs" if self.mechanism.satellites > 1 else "pins")

    @property
    def distribution_factor(self) -> float:
        """Load-sharing factor on the largest force; 1 for solved forces, which include sharing."""
        return 1.0 if self.as_made or not self.contact else self.contact.distribution_factor

    @property
    def disc_factor(self) -> float:
        """Factor on all forces of one satellite, any of them: it carries this multiple of its even
        share of the torque, and the other satellites carry the rest evenly.
        """
        return self.distribution_factor if self.distribution_of == "discs" else 1.0

    @property
    def ring_factor(self) -> float:
        """Stated load-sharing factor of satellites on the torque of the teeth; 1 without one."""
        stated = self.contact and self.distribution_of == "discs"
        return self.contact.distribution_factor if stated else 1.0

    @property
    def load_factor(self) -> float:
        """Application factor K_A on the torque for stresses."""
        return self.load.application_factor if self.load else 1.0

    @property
    def rotor_mass(self) -> float:
        """Mass of all that turns with the crankshaft, kg; that of the satellites if not given."""
        mass = self.crankshaft.rotor_mass
        return self.mechanism.satellites * self.satellite_mass if mass is None else mass

    @property
    def satellite_mass(self) -> float:
        """Mass of a satellite with its bearing, kg; `NotKnown` if it is not given."""
        mass = self.crankshaft.satellite_mass if self.crankshaft else None
        return required(mass, "mass_unknown", "crankshaft.satellite_mass")

    @property
    def known_clearance(self) -> float:
        """Radial clearance, m; `NotKnown` if it is not stated or the eccentricity is not given."""
        clearance = self.clearance
        if self.clearance_unknown:
            raise NotKnown("clearance_unknown", "contact.hole_clearance")
        return clearance

    @property
    def known_speed(self) -> float:
        """Speed of the crank, rad/s; `NotKnown` if it is not given."""
        speed = self.load.input_speed if self.load else None
        return required(speed, "speed_missing", "load.input_speed")

    @property
    def pin_count(self) -> int:
        """Number of output pins; `NotKnown` if it is not given."""
        return required(self.mechanism.pins, "size_missing", "mechanism.pins")

    @property
    def output_torque(self) -> float:
        """Torque of the output, N*m; `NotKnown` if it is not given."""
        return required(self.load.output_torque, "size_missing", "load.output_torque")

    @property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return Members(self.mechanism.output, self.mechanism.ratio)

    @property
    def pin_torque(self) -> float:
        """Torque on the pins, N*m, from which the forces are calculated."""
        return self.output_torque * self.members.pin_share

    @property
    def speeds(self) -> MemberSpeeds | None:
        """Speeds of the members; None if they are not given."""
        return if_known(lambda: self.known_speeds)

    @property
    def known_speeds(self) -> MemberSpeeds:
        """Speeds of the members; `NotKnown` if they are not given."""
        crank, load = self.known_speed, self.load
        return self.members.speeds(crank=crank, ring=load.ring_speed, carrier=load.carrier_speed)

    @property
    def turning_speed(self) -> float | None:
        """Speed of the crank against the ring, rad/s, for load cycles; None if not given or 0."""
        return (self.speeds and self.speeds.turning) or None

    def life_of(self, part: FatigueBasis | Friction) -> float:
        """Time of fatigue or wear of a part, s: its own or the required one; may be infinite."""
        return self.life if part.life is None else part.life

    def too_many(self, most: int) -> NotKnown:
        """`NotKnown` to raise if a design has more pairs than `most`."""
        given = self.mechanism
        limit = {"limit": most // given.satellites, "satellites": given.satellites}
        code = "too_many_pairs"
        refusal = InvalidInput("mechanism.pins", given.pins, code, **limit)
        return NotKnown(code, refusal=refusal)

    @cached_property
    def driven(self) -> Mechanism:
        """Ideal mechanism whose driving pairs are those that carry under the design's torque."""
        reverse = self.load and self.load.torque_direction == "reverse"
        return self.driven_by(-1.0 if reverse else 1.0)

    def driven_by(self, way: float) -> Mechanism:
        """Ideal mechanism whose driving pairs carry at `way` = 1 (driving) or -1 (reverse), where
        the wave angle is shifted by pi, as pairs carry then which would brake otherwise.
        """
        built = self.built
        if way > 0:
            return built
        return replace(built, initial_crank_angle=built.initial_crank_angle + math.pi)

    def turns_over(self, life: float) -> float:
        """Number of loads on a ring pin over a life, s, one per turn of the crank, or infinity."""
        return self._loads(life, 2 * math.pi)

    def loads_over(self, life: float) -> float:
        """Number of loads on a place of pin or hole over a life, s: one per turn of the satellite
        against its crank; infinity without a speed or an end of the life.
        """
        return self._loads(life, self.built.crank_angle_per_wave)

    def _loads(self, life: float, angle: float) -> float:
        """Number of turns by an angle, rad, of the crank against the ring over a life, s."""
        return (self.turning_speed or math.inf) * life / angle

    @cached_property
    def lasting(self) -> dict[Body, ElasticMaterial]:
        """Given materials of pin and hole, with limits for the number of loads over the life."""
        loads = self.loads_over(self.life)
        given: dict[Body, ElasticMaterial | None] = {
            "pin": self.contact.pin_material,
            "hole": self.contact.hole_material,
        }
        return {body: each.lasting(loads) for body, each in given.items() if each is not None}

    def known_material(self, body: Body) -> ElasticMaterial:
        """Material of pin or hole, with its limit for the life's loads; `NotKnown` if not given."""
        return required(self.lasting.get(body), "section_missing", f"contact.{body}_material")

    @property
    def life(self) -> float:
        """Required life, s; a usual one if it is not given."""
        own, contact = self.requirements.life, self.contact
        bodies = [contact.pin_material, contact.hole_material] if contact else []
        bodies += [self.disc_material] if self.gear else []
        plastic = any(each.plastic for each in bodies if each is not None)
        return USUAL_LIFE / (10 if plastic else 1) if own is None else own

    @cached_property
    def usual(self) -> dict[str, Any]:
        """Usual values, by path in SI units, of fields that are not given and have no default."""
        asked = self.requirements.max_outer_diameter or self.requirements.max_length
        found = self.usual_build if asked else {}
        found, fatigue = found | {"requirements.life": self.life}, self.fatigue
        if fatigue and fatigue.reliability_factor is None and fatigue.endurance_limit is None:
            found["fatigue.reliability_percent"] = USUAL_RELIABILITY
        if self.gear and self.gear.kind == "involute":
            rack = self.gear.rack
            return found | {"gear.rack_tip_radius": rack.tip_radius, "gear.dedendum": rack.dedendum}
        if self.gear and self.gear.kind == "cycloid":
            found["tolerances.ring_pin_position"] = self.ring_zone
        return found

    @property
    def mild(self) -> dict[str, float]:
        """Mild ends of the ranges of assumed values, by path in SI units."""
        found = {"requirements.life": self.life / 5} if self.requirements.life is None else {}
        if self.gear and self.gear.kind == "involute" and self.gear.rack_tip_radius is None:
            found["gear.rack_tip_radius"] = SHARPEST
        return found

    @cached_property
    def plastics(self) -> dict[Body, Plastic]:
        """Plastic data of those of pin and hole that are plastic."""
        if not self.touching:
            return {}
        return {body: each.plastic for body, each in self.lasting.items() if each.plastic}

    @cached_property
    def plastic_teeth(self) -> dict[RingBody, ElasticMaterial]:
        """Materials of ring and satellite teeth that are plastic."""
        teeth = self.lasting_teeth if self.gear else {}
        return {body: each for body, each in teeth.items() if each.plastic}

    def teeth_path(self, body: RingBody) -> str:
        """Path of the material of ring pins or teeth ("pin") or of satellite teeth ("disc")."""
        if body == "disc":
            return "contact.hole_material"
        return "gear.ring_material" if self.gear.kind == "involute" else "gear.pin_material"

    @property
    def hole_friction(self) -> Spread:
        """Range of the friction coefficient in the holes: 0 if sleeves or rollers roll there; if
        none is given, the usual one of the plastics, or of metals in oil.
        """
        if self.rollers or (self.friction.sleeve if self.friction else self.sleeved):
            return Spread.of(0.0)
        if self.friction:
            return Spread.of(self.friction.coefficient)
        if not self.plastics:
            return Spread(KNOWN_SLIDING, 0.0, KNOWN_SLIDING)
        return _of_plastics(self.plastics.values(), "friction.coefficient")

    @property
    def teeth_friction(self) -> Spread:
        """Range of the friction coefficient of plastic teeth: given, 0 if flanks roll, or usual."""
        friction = self.gear.friction_coefficient
        if friction is None and self.gear.rolls:
            friction = 0.0
        if friction is not None:
            return Spread.of(friction)
        plastics = (each.plastic for each in self.plastic_teeth.values() if each.plastic)
        return _of_plastics(plastics, "gear.friction_coefficient")

    @property
    def usual_in_holes(self) -> dict[str, Spread]:
        """Usual values, by path, that judge plastic pins and holes and are not given."""
        found = {
            path: spread
            for body in self.plastics
            for path, spread in self.lasting[body].usual(f"contact.{body}_material").items()
        }
        assumed = bool(self.plastics) and not self.friction
        friction = if_known(lambda: self.hole_friction) if assumed else None
        return found | ({"friction.coefficient": friction} if friction and friction.high else {})

    @property
    def usual_values(self) -> dict[str, Spread]:
        """Usual values of all plastics, by path, including the output pins that bend."""
        pin = self.pin.material.usual(self.pin.material_path) if self.pin else {}
        return pin | self.usual_in_holes | (self.usual_in_teeth if self.plastic_teeth else {})

    @property
    def usual_in_teeth(self) -> dict[str, Spread]:
        """Usual values, by path, that judge plastic teeth and are not given."""
        found = {
            path: spread
            for body, each in self.plastic_teeth.items()
            for path, spread in each.usual(self.teeth_path(body)).items()
        }
        given = self.gear.friction_coefficient is not None
        friction = None if given else if_known(lambda: self.teeth_friction)
        return found | (
            {"gear.friction_coefficient": friction} if friction and friction.high else {}
        )

    @cached_property
    def roots(self) -> tuple[float, float]:
        """Least and largest root radius of the satellite's teeth, m: the given one, or the range
        that the ring allows, within the outer radius; 0 and infinite if nothing is known.
        """
        body = self.satellite_body or SatelliteBody()
        low, high = 0.0, math.inf
        if body.root_radius is not None:
            low = high = body.root_radius
        elif self.gear:
            eccentricity = self.contact.eccentricity if self.contact else None
            low, high = self.gear.roots(ratio=self.mechanism.ratio, eccentricity=eccentricity)
        outer = math.inf if body.outer_radius is None else body.outer_radius
        return min(low, outer), min(high, outer)

    @property
    def bore_radius(self) -> float:
        """Radius of a satellite's bore, or of the bearing in it, m."""
        given = self.satellite_body.bore_radius if self.satellite_body else None
        if given is None:
            outer = self.bearing.outer_diameter if self.bearing else None
            return required(outer, "size_missing", "satellite_body.bore_radius") / 2
        return given

    @property
    def disc_distance(self) -> float:
        """Distance of a hole's axis to bore or tooth roots over the hole's radius, or infinity."""
        low, _ = self.roots
        circle, hole = self.pin_circle_radius, self.nominal_pair.hole_radius
        known = [low - circle] if low else []
        with suppress(NotKnown):
            known.append(circle - self.bore_radius)
        return min(known, default=math.inf) / hole

    @property
    def wall_guide(self) -> float | None:
        """Least usual wall of holes to each other and to the bore, m: 0.03 of the diameter of the
        ring pin circle, or of the circle that the roots sweep; None if neither is known.
        """
        if isinstance(self.gear, CycloidRing):
            circle = self.gear.ring_pin_circle_radius
        else:
            low, high = self.roots
            circle = (low or high) + (self.contact.eccentricity or 0.0)
        return WALL_GUIDE * 2 * circle if math.isfinite(circle) else None

    @property
    def sleeved(self) -> bool:
        """True if a sleeve on the pin touches the hole."""
        if self.rollers or not (self.pin and self.touching):
            return False
        touching = 2 * self.nominal_pair.pin_radius
        return not math.isclose(self.pin.diameter, touching, rel_tol=SAME)

    @property
    def static_torque(self) -> float:
        """Torque on the pins for static strength, N*m."""
        peak = self.load.peak_torque
        share = self.members.pin_share
        return self.pin_torque * self.load_factor if peak is None else peak * share

    @property
    def static_share(self) -> float:
        """Torque for static strength over the working torque times its factor."""
        return self.static_torque / (self.pin_torque * self.load_factor)


KINDS: dict[str, Any] = {
    each.name: getattr(each.type, "__metadata__", (each.type,))[0] for each in fields(Design)
}
"""Sections of a document: the dataclass of each, or those of its kinds."""


def _of_plastics(plastics: Iterable[Plastic], path: str) -> Spread:
    """Range of the friction coefficient between plastics: the larger value of the two."""
    spreads = [required(each.friction, "friction_unknown", path) for each in plastics]
    return Spread(*(max(values) for values in zip(*spreads, strict=True)))


Document = TypeVar("Document")


def changed(document: Document, values: Mapping[str, Any]) -> Document:
    """Copy of a document with other values, by path; a path into a list of sections sets all of
    them.

    Examples
    --------
    >>> changed(Requirements(), {"max_wear": 1e-4}).max_wear
    0.0001
    """
    direct: dict[str, Any] = {}
    within: dict[str, dict[str, Any]] = {}
    for path, value in values.items():
        name, _, rest = path.partition(".")
        if rest:
            within.setdefault(name, {})[rest] = value
        else:
            direct[name] = value
    for name, inner in within.items():
        held = getattr(document, name)
        several = isinstance(held, tuple)
        made = [changed(each, inner) for each in (held if several else (held,))]
        direct[name] = tuple(made) if several else made[0]
    return replace(cast(Any, document), **direct)  # type: ignore[no-any-return]


def value_at(document: Any, path: str) -> Any:
    """Value of a document at a path; None if it is not given."""
    for name in path.split("."):
        document = getattr(document, name, None) if document else None
    return None if isinstance(document, NotGiven) else document
