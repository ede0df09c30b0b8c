"""Section of the ring: its teeth or pins, as far as they are given, in SI units."""

import math
from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, Literal

from core.crank.ring_mesh import RingMesh, cycloid_mesh, involute_mesh
from core.design.sections import DesignPin
from core.errors import InvalidInput, Notice, NotKnown, required
from core.fields import SMALLEST, Forms, Variants, optional_size, quantity, size
from core.hertz import ElasticMaterial
from core.output.elasticity import RIGID_PINS, ContactLaw, HertzLaw
from core.output.mechanism import MAX_SATELLITES
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

LARGEST_RING = 1e5
"""Largest size of a ring, mm, a hundred metres, as the turn of a larger one takes long."""

SOFT = 20e9
"""Young's modulus below which a part is taken as printed, Pa."""

GROUND_LEAST, GROUND_SHARE = 5e-6, 1e-4
"""Equidistant modification of ground discs: least value, m, and part of the circle's radius."""

MADE: dict[RingClass, tuple[float, float]] = {
    "machined": (0.03e-3, 0.025e-3),
    "printed": (0.22e-3, 0.15e-3),
}
"""Equidistant modification and zone radius of the pins, m: guide values of a public tool."""


def soft(material: ElasticMaterial | None) -> bool:
    """True if a part is taken as printed, by its material."""
    return material is not None and bool(material.youngs_modulus < SOFT)


def usual_sizes(*, ring_class: RingClass, circle_radius: float) -> tuple[float, float]:
    """Usual equidistant modification and zone radius of each ring pin, m; the circle's radius is in
    m.

    >>> usual_sizes(ring_class="machined", circle_radius=0.08)
    (3e-05, 2.5e-05)
    """
    if ring_class == "ground":
        equidistant = max(GROUND_LEAST, GROUND_SHARE * circle_radius)
        return equidistant, equidistant / 2
    return MADE[ring_class]


addendum = partial(quantity, default=None, step=0.05, ge=HEIGHTS[0], le=HEIGHTS[1])
tool_height = partial(quantity, silent=True, step=0.05, advanced=True)
"""Heights of teeth, and of the tools that cut them, in modules."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AnyRing:
    """Fields that rings of all kinds have."""

    # Teeth or pins of the ring less teeth of a satellite; None for pins if not given.
    teeth_difference: int | None = None
    contact_length: float | None = None  # m; none without pins or teeth
    friction_coefficient: float | None = None  # none without pins or teeth

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

    def reach(self, ratio: float) -> float | None:
        """Radius that pins or teeth of the ring take, m; None without them."""
        return None


@dataclass(frozen=True, slots=True, kw_only=True)
class ToothedRing(AnyRing):
    """Fields of rings with pins or teeth."""

    contact_length: float | None = optional_size("Contact length", "b", "mm", step=1)
    """Length of the contact along the pin, which is the width of the satellite."""
    friction_coefficient: float | None = quantity(
        "Friction coefficient", "μ", default=None, step=0.01, ge=0, le=1
    )
    """Friction coefficient of sliding on the ring pins, or of the flanks of teeth; without it the
    loss is not calculated."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OtherRing(AnyRing):
    """Ring known by the ratio of its forces alone; kind "none" has no force along the crank."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("kind",), ("radial_force_ratio",)),)

    kind: Literal["none"] | None = None  # "none" leaves out the force along the crank
    radial_force_ratio: float | None = quantity(
        "Ratio of the ring's forces", "ρ", default=None, step=0.05, ge=-100, le=100
    )
    """Force of the ring along the crank over its force across the crank: positive towards the
    reducer's axis, as with involute teeth, negative outwards, as with ring pins."""

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """Force of the ring on a satellite."""
        if self.radial_force_ratio is not None:
            return RingMesh(self.radial_force_ratio)
        return RingMesh(0.0, notices=(Notice("no_ring_force"),))


@dataclass(frozen=True, slots=True, kw_only=True)
class CycloidRing(ToothedRing):
    """Ring pins on which cycloid discs roll, as far as they are given."""

    kind: Literal["cycloid"] = "cycloid"  # kind of teeth
    ring_pin_circle_radius: float = quantity(
        "Circle of the ring's pins", "R_p", "mm", step=1, ge=SMALLEST, le=LARGEST_RING
    )
    """Radius of the circle of the ring pins, on which a cycloid disc rolls."""
    ring_pin_radius: float | None = quantity(
        "Radius of the ring's pins",
        "r_p",
        "mm",
        default=None,
        step=0.5,
        ge=SMALLEST,
        le=LARGEST_RING,
    )
    """Radius of the ring pins, or of their sleeves; the roots of a cycloid disc follow from it."""
    modification: Modification | None = quantity(default=None)
    contact_law: ContactLaw | None = quantity(default=None)
    pin_material: ElasticMaterial | None = quantity("Material of the ring's pins", default=None)
    """Name in the table of materials, or values; bearing steel if not given."""
    disc_material: ElasticMaterial | None = quantity("Disc material", default=None)
    """Name in the table of materials, or values; the material of the holes if not given."""
    pin_support: RingPinSupport = quantity(
        "Support of the ring's pins", default="seat", silent=True, advanced=True
    )
    """Support of the ring pins: in half a bore (seat), which is the default, held at both ends free
    to tilt (supported), or built in (fixed)."""
    span: float | None = optional_size("Span of the ring's pins", "L", "mm", step=1, advanced=True)
    """Distance between the two supports of the ring pins; not for seats."""
    satellite_positions: tuple[float, ...] = size(
        "Places of the satellites",
        "z₁ … z_K",
        "mm",
        default=(),
        lengths=((1, MAX_SATELLITES),),
        advanced=True,
    )
    """Middle plane of each satellite, from one support of the ring pins; not for seats."""
    seat_stiffness: float = size(
        "Stiffness of a seat", "k_s", "N_per_mm", default=math.inf, step=10_000, advanced=True
    )
    """Stiffness of a ring pin in its bore and of the part that holds the bore; rigid if not
    given."""
    sleeve_bore_radius: float = size(
        "Bore of the sleeves", "r_i", "mm", default=0.0, silent=True, step=0.5
    )
    """Radius of the bore of sleeves, which slide on the ring pins."""
    rolling: bool = quantity("Rolling elements", default=False, silent=True, advanced=True)
    """True if rolling elements carry the sleeves. The friction coefficient is then that of the
    rolling elements at the bore of the sleeves, or at their outer radius if no bore is given, which
    gives a larger loss."""
    rotates: bool = quantity("Ring pins rotate", default=False, silent=True, advanced=True)
    """True if the ring pins turn in their supports, so that their bending is fully reversed."""
    tool_radius: float | None = optional_size(
        "Radius of the tool", "r_t", "mm", step=1, advanced=True
    )
    """Radius of the wheel or cutter that makes the flanks of the discs; it has to reach into their
    valleys."""
    every_second_pin: bool = quantity("Every second pin", default=False, silent=True, advanced=True)
    """True if every second pin of an even number of ring pins is left out; the forces of such a
    ring are not calculated."""
    ring_class: RingClass | None = quantity("How the ring is made", default=None, advanced=True)
    """Manufacture of discs and ring: ground, machined or printed. It states the usual modification
    of the discs and the usual places of the ring pins, if these are not known. The default is
    printed if discs are softer than 20 GPa, else ground."""
    pin_tensile_strength: float | None = None  # Pa
    pin_steel: bool = False  # True if the pin material is steel
    pin_valid_diameter: float | None = None  # largest diameter the strengths hold for, m

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

    def reach(self, ratio: float) -> float:
        """Radius at the outside of the ring pins, m; `NotKnown` without a ring pin radius."""
        return self.ring_pin_circle_radius + self.known_pin_radius

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """Force of the ring pins on a satellite; eccentricity in m."""
        return cycloid_mesh(
            eccentricity=eccentricity,
            ratio=ratio,
            ring_pin_circle_radius=self.ring_pin_circle_radius,
            difference=self.teeth_difference,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class InvoluteRing(ToothedRing):
    """Involute teeth of ring and satellites, as far as given; profile shifts point outwards."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("satellite_addendum",), ("satellite_tip_radius",), ()),
        (("ring_addendum",), ("ring_tip_radius",), ()),
    )

    kind: Literal["involute"] = "involute"  # kind of teeth
    module: float = size("Module", "m", "mm", step=0.5)
    """Module of the teeth."""
    teeth_difference: int = quantity("Difference of teeth", "z₃ − z₂", filled=True, ge=1, le=1000)
    """Number of teeth of the ring less that of a satellite; the difference of the mechanism's teeth
    if these are given."""
    reference_pressure_angle: float = quantity(
        "Reference pressure angle",
        "α",
        "deg",
        default=math.radians(20),
        silent=True,
        step=0.5,
        ge=1,
        le=60,
    )
    """Pressure angle of the teeth at the reference circle; 20° if not given."""
    satellite_profile_shift: float | None = quantity(
        "Profile shift of the satellite", "x_s", default=None, step=0.05, ge=-2, le=3
    )
    """Profile shift of the satellite, in modules, positive outwards."""
    ring_profile_shift: float | None = quantity(
        "Profile shift of the ring", "x_r", default=None, step=0.05, ge=-2, le=3
    )
    """Profile shift of the ring, in modules, positive outwards: a positive shift makes the ring's
    spaces wider and its tip and root circles larger. Conventions with negative numbers of ring
    teeth use the opposite sign."""
    satellite_addendum: float | None = addendum("Addendum of the satellite", "h_as")
    """Addendum of the satellite above its shifted reference circle, in modules."""
    ring_addendum: float | None = addendum("Addendum of the ring", "h_ar")
    """Addendum of the ring inside its shifted reference circle, in modules."""
    satellite_tip_radius: float | None = optional_size(
        "Tip radius of the satellite", "r_as", "mm", step=0.5, advanced=True
    )
    """Tip radius of the satellite, given instead of its addendum."""
    ring_tip_radius: float | None = optional_size(
        "Tip radius of the ring", "r_ar", "mm", step=0.5, advanced=True
    )
    """Tip radius of the ring, given instead of its addendum."""
    dedendum: float = tool_height("Dedendum", "h_f", default=DEDENDUM, ge=0.8, le=1.6)
    """Dedendum that the hob cuts on the satellite, in modules; 1.25 if not given."""
    rack_tip_radius: float | None = quantity(
        "Tip radius of the hob", "ρ_f", default=None, step=0.02, ge=0, le=0.6, advanced=True
    )
    """Radius at the tip of the hob, in modules; 0.38, or the largest that there is room for, if not
    given."""
    cutter_teeth: int | None = quantity("Teeth of the cutter", "z₀", default=None, ge=6, le=1000)
    """Number of teeth of the shaper cutter that makes the ring; without it the ring's root is
    assumed, and its flanks are not checked."""
    cutter_profile_shift: float = tool_height(
        "Profile shift of the cutter", "x₀", default=0.0, ge=-1, le=1
    )
    """Profile shift of the shaper cutter, in modules; 0 if not given."""
    cutter_addendum: float = tool_height(
        "Addendum of the cutter", "h_a0", default=DEDENDUM, ge=0.8, le=1.6
    )
    """Addendum of the shaper cutter, in modules; 1.25 if not given."""
    satellite_material: ElasticMaterial | None = quantity("Satellite material", default=None)
    """Name in the table of materials, or values; the material of the holes if not given."""
    ring_material: ElasticMaterial | None = quantity("Ring material", default=None)
    """Name in the table of materials, or values; structural steel if not given."""
    face_load_factor: float = quantity(
        "Face load factor", "K_Hβ", default=1.0, silent=True, step=0.05, advanced=True, ge=1, le=10
    )
    """Factor on the force for stresses, as the load is uneven along the width; 1 if not given."""
    pair_stiffness: float | None = optional_size(
        "Stiffness of a pair", "k", "N_per_mm", step=10_000, advanced=True
    )
    """Stiffness of a pair of teeth along the line of action, from which the number of carrying
    pairs follows; 14 N/(mm·µm) times the width if not given."""
    root_strength: float | None = optional_size(
        "Strength of the tooth root", "σ_FG", "MPa", step=10
    )
    """Stress that the tooth root of a satellite endures over the life, for the torque in one
    direction or in both, as it acts; the safety factor in fatigue refers to it."""

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

    def reach(self, ratio: float) -> float:
        """Usual radius at the roots of the ring's teeth, m: ``m*(z3/2 + 1.25 + x)``; an unknown
        profile shift x counts as 0.

        >>> InvoluteRing(module=4e-3, teeth_difference=2).reach(ratio=20.0)
        0.089
        """
        shift = self.ring_profile_shift or 0.0
        return self.module * (self.teeth_difference * (ratio + 1) / 2 + DEDENDUM + shift)

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

RINGS = Variants(
    {"involute": InvoluteRing, "cycloid": CycloidRing, "none": OtherRing, None: OtherRing},
    title="Ring",
    help="Kind of ring: involute teeth, pins on which a cycloid disc rolls, or none, whose force "
    "along the crank is left out.",
)
"""Rings by their kind in the document; None for a ring given by the ratio of its forces."""
