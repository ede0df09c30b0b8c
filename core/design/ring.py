"""The section of the ring: its teeth or pins, as far as they are given, in SI units."""

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
"""Depth of the roots of involute teeth within their reference circle without a profile shift, over
the module: that of the basic rack of ISO 53, types A and B."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AnyRing:
    """What rings of whatever teeth have."""

    # Teeth, or pins, of the ring less those of a satellite; of pins where it is known.
    teeth_difference: int | None = None
    contact_length: float | None = None  # of a satellite in the ring, m
    friction_coefficient: float | None = None  # of what slides on pins or flanks

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of the ring's pins or teeth."""
        return None

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the satellites' teeth, where it is given here."""
        return None

    @property
    def friction(self) -> RingFriction:
        """What slides in the ring, where the coefficient is known."""
        return RingFriction(self.known_friction)

    @property
    def rolls(self) -> bool:
        """Whether flanks roll on sleeves or rolling elements, in which all slides."""
        return False

    @property
    def known_friction(self) -> float:
        """Its friction coefficient, which has to be given."""
        name = "gear.friction_coefficient"
        return required(self.friction_coefficient, "ring_friction_unknown", name)

    def roots(self, *, ratio: float, eccentricity: float | None) -> tuple[float, float]:
        """Between which radii the roots of a satellite's teeth lie.

        Parameters
        ----------
        ratio : float
            Ratio u.
        eccentricity : float or None
            Eccentricity of the cranks, m.

        Returns
        -------
        tuple of float
            Least and largest radius, m; 0 and infinite where nothing is known.
        """
        return 0.0, math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class OtherRing(AnyRing):
    """A ring of teeth of which the ratio of their forces is all that is known; or, of kind none,
    one whose force along the crank is left out.
    """

    kind: Literal["none"] | None = None  # of none the force along the crank is left out
    radial_force_ratio: float | None = None  # force along the crank over that across it

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """The ring's force on a satellite.

        Parameters
        ----------
        eccentricity : float
            Eccentricity of the cranks, m.
        ratio : float
            Ratio u.

        Returns
        -------
        RingMesh
        """
        if self.radial_force_ratio is not None:
            return RingMesh(self.radial_force_ratio)
        return RingMesh(0.0, notices=(Notice("no_ring_force"),))


@dataclass(frozen=True, slots=True, kw_only=True)
class CycloidRing(AnyRing):
    """Pins on which cycloid discs roll, as far as they are given.

    Attributes
    ----------
    modification : Modification or None
        Of the discs; None where nothing is known of it.
    contact_law : ContactLaw or None
        How a pin and a disc give; by Hertz where that is not stated.
    pin_support : {"seat", "supported", "fixed"}
        In half a bore, held at both ends free to tilt, or built in at both.
    satellite_positions : tuple of float
        Middle plane of each satellite from one of the two supports, m.
    pin_tensile_strength, pin_steel, pin_valid_diameter
        Of the material of the pins, as `DesignPin` has them.
    seat_stiffness : float
        Of a pin in its bore and of what holds that, N/m.
    ring_class : {"ground", "machined", "printed"} or None
        How discs and ring are made, by which what is not known of them is usual.
    """

    kind: Literal["cycloid"] = "cycloid"  # pins
    ring_pin_circle_radius: float  # R_p of the circle of the pins, m
    ring_pin_radius: float | None = None  # of these, m
    modification: Modification | None = None
    contact_law: ContactLaw | None = None
    pin_material: ElasticMaterial | None = None  # of the pins
    disc_material: ElasticMaterial | None = None  # of the discs
    pin_support: RingPinSupport = "seat"
    span: float | None = None  # distance of the two supports, m
    satellite_positions: tuple[float, ...] = ()
    rotates: bool = False  # whether the pins turn in their supports
    pin_tensile_strength: float | None = None
    pin_steel: bool = False
    pin_valid_diameter: float | None = None
    seat_stiffness: float = math.inf
    sleeve_bore_radius: float = 0.0  # of sleeves on the pins, m; 0 without them
    rolling: bool = False  # whether rolling elements carry them
    tool_radius: float | None = None  # of what grinds or cuts the flanks of the discs, m
    every_second_pin: bool = False  # whether every second pin is left out
    ring_class: RingClass | None = None

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of the pins."""
        return self.pin_material

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the discs, where it is given here."""
        return self.disc_material

    @property
    def rolls(self) -> bool:
        """Whether discs roll on sleeves or rolling elements of the ring's pins."""
        return self.rolling or self.sleeve_bore_radius > 0

    @property
    def changed(self) -> Modification:
        """The modification; none where nothing is known of it."""
        return self.modification or Modification()

    @property
    def law(self) -> ContactLaw:
        """The law of contact of the teeth: Hertz's where none is stated."""
        return self.contact_law or HertzLaw()

    @property
    def known_pin_radius(self) -> float:
        """Radius of the pins, which has to be given, m."""
        return required(self.ring_pin_radius, "size_missing", "gear.ring_pin_radius")

    @property
    def known_pin_material(self) -> ElasticMaterial:
        """Material of the pins, which has to be given."""
        return required(self.pin_material, "section_missing", "gear.pin_material")

    @property
    def bent_pin(self) -> DesignPin:
        """The pins as they bend, inside their sleeves; not at all in seats."""
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
        """What slides on the pins, where the coefficient is known."""
        return RingFriction(self.known_friction, self.sleeve_bore_radius, self.rolling)

    def disc(self, *, satellite_teeth: int, eccentricity: float) -> CycloidDisc:
        """A disc, as far as its modification is known.

        Parameters
        ----------
        satellite_teeth : int
            Its lobes.
        eccentricity : float
            Eccentricity of the cranks, m.

        Returns
        -------
        CycloidDisc

        Raises
        ------
        NotKnown
            If the size of the pins is not given.
        InvalidInput
            If there is no such disc.
        """
        return CycloidDisc(
            satellite_teeth=satellite_teeth,
            eccentricity=eccentricity,
            ring_pin_circle_radius=self.ring_pin_circle_radius,
            ring_pin_radius=self.known_pin_radius,
            modification=self.changed,
        )

    def cycloid_mesh(self, *, disc: CycloidDisc, **made: Any) -> CycloidMesh:
        """Such discs on the pins.

        Parameters
        ----------
        disc : CycloidDisc
            All of them.
        **made
            Their cranks, width and material, law, deviations, geometry, shares: see
            `core.ring.sharing.CycloidMesh`.

        Returns
        -------
        CycloidMesh

        Raises
        ------
        InvalidInput
            If an input is out of range.
        """
        return CycloidMesh(
            disc=disc,
            pin_material=self.known_pin_material,
            pin=RIGID_PINS if self.pin_support == "seat" else self.bent_pin,
            seat_stiffness=self.seat_stiffness,
            **made,
        )

    def roots(self, *, ratio: float, eccentricity: float | None) -> tuple[float, float]:
        """Between which radii the roots of a disc lie: ``R_m - e - r_m``, what its tool sweeps,
        that of the ring's pins where no modification is known, or within ``R_m - e`` where their
        radius is not.

        Parameters
        ----------
        ratio : float
            Ratio u.
        eccentricity : float or None
            Eccentricity of the cranks, m.

        Returns
        -------
        tuple of float
            Least and largest radius, m; 0 where the least is not known.
        """
        swept = self.ring_pin_circle_radius + self.changed.pin_circle - (eccentricity or 0.0)
        if self.ring_pin_radius is None or eccentricity is None:
            return 0.0, swept
        root = swept - self.ring_pin_radius - self.changed.equidistant
        return root, root

    def mesh(self, *, eccentricity: float, ratio: float) -> RingMesh:
        """The force of the pins on a satellite.

        Parameters
        ----------
        eccentricity : float
            Eccentricity of the cranks, m.
        ratio : float
            Ratio u.

        Returns
        -------
        RingMesh

        Raises
        ------
        InvalidInput
            If there are no such discs.
        """
        return cycloid_mesh(
            eccentricity=eccentricity,
            ratio=ratio,
            ring_pin_circle_radius=self.ring_pin_circle_radius,
            difference=self.teeth_difference,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class InvoluteRing(AnyRing):
    """Involute teeth of ring and satellites, as far as they are given.

    Attributes
    ----------
    satellite_profile_shift, ring_profile_shift : float or None
        Outwards, in modules.
    satellite_addendum, ring_addendum : float or None
        Addenda, in modules.
    satellite_tip_radius, ring_tip_radius : float or None
        Radii of the tips in place of these, m.
    dedendum, rack_tip_radius : float, float or None
        Of the hob that makes the satellite, in modules.
    cutter_teeth : int or None
        Of the shaper cutter that makes the ring; None where nothing is known of it.
    cutter_profile_shift, cutter_addendum : float
        Of that cutter, in modules.
    """

    kind: Literal["involute"] = "involute"  # teeth
    module: float  # m, m
    teeth_difference: int  # z_d
    reference_pressure_angle: float  # alpha, rad
    satellite_profile_shift: float | None = None
    ring_profile_shift: float | None = None
    satellite_addendum: float | None = None
    ring_addendum: float | None = None
    satellite_tip_radius: float | None = None
    ring_tip_radius: float | None = None
    dedendum: float = DEDENDUM
    rack_tip_radius: float | None = None
    cutter_teeth: int | None = None
    cutter_profile_shift: float = 0.0
    cutter_addendum: float = DEDENDUM
    satellite_material: ElasticMaterial | None = None  # of the satellites' teeth
    ring_material: ElasticMaterial | None = None  # of the ring's
    face_load_factor: float = 1.0  # on the force for stresses along the width
    pair_stiffness: float | None = None  # of a pair of teeth along the line of action, N/m
    root_strength: float | None = None  # what a satellite's root bears over the life, Pa

    @property
    def of_ring(self) -> ElasticMaterial | None:
        """Material of the ring's teeth."""
        return self.ring_material

    @property
    def of_satellites(self) -> ElasticMaterial | None:
        """Material of the satellites' teeth, where it is given here."""
        return self.satellite_material

    @property
    def unknown_teeth(self) -> tuple[str, ...]:
        """What is not given of involute teeth, of which how they mesh hangs: paths of a design."""
        ways = {
            "gear.satellite_profile_shift": (self.satellite_profile_shift,),
            "gear.ring_profile_shift": (self.ring_profile_shift,),
            "gear.satellite_addendum": (self.satellite_addendum, self.satellite_tip_radius),
            "gear.ring_addendum": (self.ring_addendum, self.ring_tip_radius),
        }
        return tuple(name for name, own in ways.items() if all(each is None for each in own))

    @property
    def rack(self) -> Rack:
        """The hob that makes the satellite."""
        return rack_of(
            pressure_angle=self.reference_pressure_angle,
            dedendum=self.dedendum,
            tip_radius=self.rack_tip_radius,
        )

    def involute_teeth(self, *, satellite_teeth: int, ring_teeth: int) -> InvoluteTeeth:
        """Involute teeth of which all is given.

        Parameters
        ----------
        satellite_teeth, ring_teeth : int
            Their numbers.

        Returns
        -------
        InvoluteTeeth

        Raises
        ------
        InvalidInput
            If there is no such rack, or an addendum is none of `core.ring.involute.HEIGHTS`.
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
        """Between which radii the roots of a satellite's teeth lie: ``m*(z2/2 - h_f + x)``, with a
        profile shift x that is taken to be from 0 to h_f where it is not known.

        Parameters
        ----------
        ratio : float
            Ratio u.
        eccentricity : float or None
            Eccentricity of the cranks, m.

        Returns
        -------
        tuple of float
            Least and largest radius, m.

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
        """The force of the ring's teeth on a satellite.

        Parameters
        ----------
        eccentricity : float
            Eccentricity of the cranks, m.
        ratio : float
            Ratio u.

        Returns
        -------
        RingMesh

        Raises
        ------
        InvalidInput
            If there are no such teeth.
        """
        return involute_mesh(
            module=self.module,
            teeth_difference=self.teeth_difference,
            pressure_angle=self.reference_pressure_angle,
            eccentricity=eccentricity,
        )


Ring = InvoluteRing | CycloidRing | OtherRing
"""Teeth or pins of the ring, or the ratio of its forces itself."""
