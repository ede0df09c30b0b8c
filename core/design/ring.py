"""Section of the ring: its teeth or pins, as far as they are given, in SI units."""

import math
from dataclasses import dataclass
from typing import Any, Literal

from core.crank.ring_mesh import RingMesh, cycloid_mesh, involute_mesh
from core.design.sections import DesignPin
from core.errors import InvalidInput, Notice, NotKnown, required
from core.hertz import ElasticMaterial
from core.output.elasticity import RIGID_PINS, ContactLaw, HertzLaw
from core.ring.involute import HEIGHTS, Cutter, InvoluteTeeth, Rack, addendum_of, rack_of
from core.ring.loss import RingFriction
from core.ring.profile import CycloidDisc, Modification
from core.ring.sharing import CycloidMesh

RingKind = Literal["involute", "cycloid", "none"]

RingPinSupport = Literal["seat", "supported", "fixed"]

RingBody = Literal["pin", "disc"]

RingClass = Literal["ground", "machined", "printed"]

DEDENDUM = 1.25
"""Dedendum of involute teeth over the module, without profile shift: basic rack of ISO 53, types A
and B."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AnyRing:
    """Fields that rings of all kinds have."""

    # Teeth or pins of the ring less teeth of a satellite; None for pins if not given.
    teeth_difference: int | None = None
    contact_length: float | None = None  # width of a satellite in the ring, m
    friction_coefficient: float | None = None  # on ring pins or flanks

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of ring pins or ring teeth."""
        return None

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the satellites' teeth if the ring section states it."""
        return None

    @property
    def friction(self) -> RingFriction:
        """Sliding contact of the ring; `NotKnown` without a friction coefficient."""
        return RingFriction(self.known_friction)

    @property
    def rolls(self) -> bool:
        """True if flanks roll on sleeves or rolling elements, inside which all sliding occurs."""
        return False

    @property
    def known_friction(self) -> float:
        """Friction coefficient of the ring; `NotKnown` if it is not given."""
        name = "gear.friction_coefficient"
        return required(self.friction_coefficient, "ring_friction_unknown", name)

    def roots(self, *, ratio: float, eccentricity: float | None) -> tuple[float, float]:
        """Least and largest root radius of a satellite's teeth, m; 0 and infinite if not known."""
        return 0.0, math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class OtherRing(AnyRing):
    """Ring known by the ratio of its forces alone; kind "none" has no force along the crank."""

    kind: Literal["none"] | None = None  # "none" leaves out the force along the crank
    radial_force_ratio: float | None = None  # force along the crank over force across it

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """Force of the ring on a satellite."""
        if self.radial_force_ratio is not None:
            return RingMesh(self.radial_force_ratio)
        return RingMesh(0.0, notices=(Notice("no_ring_force"),))


@dataclass(frozen=True, slots=True, kw_only=True)
class CycloidRing(AnyRing):
    """Ring pins on which cycloid discs roll, as far as they are given."""

    kind: Literal["cycloid"] = "cycloid"  # kind of teeth
    ring_pin_circle_radius: float  # R_p of the circle of the pins, m
    ring_pin_radius: float | None = None  # r_p of the pins, m
    modification: Modification | None = None  # None: not known
    contact_law: ContactLaw | None = None  # elastic law of pin and disc; None: by Hertz
    pin_material: ElasticMaterial | None = None  # material of the pins
    disc_material: ElasticMaterial | None = None  # None: material of the holes
    # "seat": in half a bore; "supported": both ends held, free to tilt; "fixed": both ends clamped.
    pin_support: RingPinSupport = "seat"
    span: float | None = None  # distance of the two supports, m
    satellite_positions: tuple[float, ...] = ()  # middle of each satellite from one support, m
    rotates: bool = False  # True if the pins turn in their supports
    pin_tensile_strength: float | None = None  # Pa
    pin_steel: bool = False  # True if the pin material is steel
    pin_valid_diameter: float | None = None  # largest diameter the strengths hold for, m
    seat_stiffness: float = math.inf  # stiffness of a pin's bore with the housing, N/m
    sleeve_bore_radius: float = 0.0  # sleeves on the pins, m; 0 without sleeves
    rolling: bool = False  # True if rolling elements carry the sleeves
    tool_radius: float | None = None  # tool that grinds or cuts the flanks, m
    every_second_pin: bool = False  # True if every second pin is left out
    ring_class: RingClass | None = None  # manufacturing class, for usual values

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of the ring pins."""
        return self.pin_material

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the discs if the ring section states it."""
        return self.disc_material

    @property
    def rolls(self) -> bool:
        """True if discs roll on sleeves or rolling elements of the ring pins."""
        return self.rolling or self.sleeve_bore_radius > 0

    @property
    def changed(self) -> Modification:
        """Modification of the discs; a modification of zero if it is not known."""
        return self.modification or Modification()

    @property
    def law(self) -> ContactLaw:
        """Contact law of disc and ring pin; Hertz's if none is stated."""
        return self.contact_law or HertzLaw()

    @property
    def known_pin_radius(self) -> float:
        """Radius of the ring pins, m; `NotKnown` if it is not given."""
        return required(self.ring_pin_radius, "size_missing", "gear.ring_pin_radius")

    @property
    def known_pin_material(self) -> ElasticMaterial:
        """Material of the ring pins; `NotKnown` if it is not given."""
        return required(self.pin_material, "section_missing", "gear.pin_material")

    @property
    def bent_pin(self) -> DesignPin:
        """Ring pin that bends, inside its sleeve if it has one; `NotKnown` for pins in seats."""
        if self.pin_support == "seat":
            raise NotKnown("pins_in_seats")
        inner = self.sleeve_bore_radius or self.known_pin_radius
        return DesignPin(
            support=self.pin_support,
            diameter=2 * inner,
            satellite_positions=self.satellite_positions,
            material=self.known_pin_material,
            span=self.span,
            rotates=self.rotates,
            tensile_strength=self.pin_tensile_strength,
            steel=self.pin_steel,
            valid_diameter=self.pin_valid_diameter,
            material_path="gear.pin_material",
        )

    @property
    def friction(self) -> RingFriction:
        """Sliding contact on the ring pins; `NotKnown` without a friction coefficient."""
        return RingFriction(self.known_friction, self.sleeve_bore_radius, self.rolling)

    def disc(self, *, satellite_teeth: int, eccentricity: float) -> CycloidDisc:
        """Cycloid disc with the known modification; eccentricity in m.

        Raises NotKnown without a ring pin radius, InvalidInput if no disc of these sizes exists.
        """
        return CycloidDisc(
            satellite_teeth=satellite_teeth,
            eccentricity=eccentricity,
            ring_pin_circle_radius=self.ring_pin_circle_radius,
            ring_pin_radius=self.known_pin_radius,
            modification=self.changed,
        )

    def cycloid_mesh(self, *, disc: CycloidDisc, **made: Any) -> CycloidMesh:
        """Mesh of discs and ring pins; `made` has more arguments of `CycloidMesh`."""
        return CycloidMesh(
            disc=disc,
            pin_material=self.known_pin_material,
            pin=RIGID_PINS if self.pin_support == "seat" else self.bent_pin,
            seat_stiffness=self.seat_stiffness,
            **made,
        )

    def roots(self, *, ratio: float, eccentricity: float | None) -> tuple[float, float]:
        """Least and largest root radius of a disc, m: both ``R_m - e - r_m`` swept by its tool; 0
        and ``R_m - e`` if the pin radius or the eccentricity (e = 0 then) is not known.
        """
        swept = self.ring_pin_circle_radius + self.changed.pin_circle - (eccentricity or 0.0)
        if self.ring_pin_radius is None or eccentricity is None:
            return 0.0, swept
        root = swept - self.ring_pin_radius - self.changed.equidistant
        return root, root

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """Force of the ring pins on a satellite; eccentricity in m."""
        return cycloid_mesh(
            eccentricity=eccentricity,
            ratio=ratio,
            ring_pin_circle_radius=self.ring_pin_circle_radius,
            difference=self.teeth_difference,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class InvoluteRing(AnyRing):
    """Involute teeth of ring and satellites, as far as given; profile shifts point outwards."""

    kind: Literal["involute"] = "involute"  # kind of teeth
    module: float  # m, m
    teeth_difference: int  # z_d
    reference_pressure_angle: float  # alpha, rad
    satellite_profile_shift: float | None = None  # in modules
    ring_profile_shift: float | None = None  # in modules
    satellite_addendum: float | None = None  # in modules
    ring_addendum: float | None = None  # in modules
    satellite_tip_radius: float | None = None  # replaces the addendum, m
    ring_tip_radius: float | None = None  # replaces the addendum, m
    dedendum: float = DEDENDUM  # hob that cuts the satellite, in modules
    rack_tip_radius: float | None = None  # tip radius of the hob, in modules
    cutter_teeth: int | None = None  # teeth of the ring's shaper cutter; None: not known
    cutter_profile_shift: float = 0.0  # in modules
    cutter_addendum: float = DEDENDUM  # in modules
    satellite_material: ElasticMaterial | None = None  # None: material of the holes
    ring_material: ElasticMaterial | None = None  # material of the ring's teeth
    face_load_factor: float = 1.0  # on the force for stresses along the width
    pair_stiffness: float | None = None  # stiffness of a tooth pair along the line of action, N/m
    root_strength: float | None = None  # allowable root stress of a satellite over the life, Pa

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of the ring's teeth."""
        return self.ring_material

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the satellites' teeth if the ring section states it."""
        return self.satellite_material

    @property
    def unknown_teeth(self) -> tuple[str, ...]:
        """Paths of the fields that determine the mesh of involute teeth and are not given."""
        ways = {
            "gear.satellite_profile_shift": (self.satellite_profile_shift,),
            "gear.ring_profile_shift": (self.ring_profile_shift,),
            "gear.satellite_addendum": (self.satellite_addendum, self.satellite_tip_radius),
            "gear.ring_addendum": (self.ring_addendum, self.ring_tip_radius),
        }
        return tuple(name for name, own in ways.items() if all(each is None for each in own))

    @property
    def rack(self) -> Rack:
        """Hob that cuts the satellite."""
        return rack_of(
            pressure_angle=self.reference_pressure_angle,
            dedendum=self.dedendum,
            tip_radius=self.rack_tip_radius,
        )

    def involute_teeth(self, *, satellite_teeth: int, ring_teeth: int) -> InvoluteTeeth:
        """Involute teeth of satellite and ring, for which all fields have to be given.

        Raises InvalidInput if the rack cannot exist or an addendum is out of
        `core.ring.involute.HEIGHTS`.
        """
        module, rack = self.module, self.rack
        shifts = {body: getattr(self, f"{body}_profile_shift") for body in ("satellite", "ring")}
        addenda = {}
        for body, teeth in (("satellite", satellite_teeth), ("ring", ring_teeth)):
            addendum = getattr(self, f"{body}_addendum")
            low, high = HEIGHTS
            if addendum is None:
                name = f"{body}_tip_radius"
                addendum = addendum_of(
                    name=name,
                    tip_radius=getattr(self, name),
                    teeth=teeth,
                    shift=shifts[body],
                    module=module,
                    pressure_angle=rack.pressure_angle,
                )
            elif not low <= addendum <= high:
                code, limit = (
                    ("less_than_equal", high) if addendum > high else ("greater_than_equal", low)
                )
                raise InvalidInput(f"{body}_addendum", addendum, code, limit=limit)
            addenda[body] = addendum
        cutter = None
        if self.cutter_teeth is not None:
            cutter = Cutter(self.cutter_teeth, self.cutter_profile_shift, self.cutter_addendum)
        return InvoluteTeeth(
            satellite_teeth=satellite_teeth,
            ring_teeth=ring_teeth,
            module=module,
            satellite_profile_shift=shifts["satellite"],
            ring_profile_shift=shifts["ring"],
            satellite_addendum=addenda["satellite"],
            ring_addendum=addenda["ring"],
            rack=rack,
            cutter=cutter,
        )

    def roots(self, *, ratio: float, eccentricity: float | None) -> tuple[float, float]:
        """Least and largest root radius of a satellite's teeth, m: ``m*(z2/2 - h_f + x)``. An
        unknown profile shift x is taken between 0 and h_f.

        Examples
        --------
        >>> teeth = {"module": 4e-3, "teeth_difference": 2, "reference_pressure_angle": 0.35}
        >>> InvoluteRing(**teeth).roots(ratio=20.0, eccentricity=None)
        (0.075, 0.08)
        """
        reference = self.module * self.teeth_difference * ratio / 2
        least = reference - self.dedendum * self.module
        if self.satellite_profile_shift is None:
            return least, reference
        root = least + self.satellite_profile_shift * self.module
        return root, root

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """Force of the ring's teeth on a satellite; eccentricity in m."""
        return involute_mesh(
            module=self.module,
            teeth_difference=self.teeth_difference,
            pressure_angle=self.reference_pressure_angle,
            eccentricity=eccentricity,
        )


Ring = InvoluteRing | CycloidRing | OtherRing
"""Ring with involute teeth, with pins, or described by the ratio of its forces alone."""
