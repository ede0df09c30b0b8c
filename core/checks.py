"""Checks of a design and its verdict: results against limits, each as data.

A check is a small function of a design, in the table of its kind of design (`CRANK`, `ROLLERS`,
`SHAFT`); what it is called, why it is made and by which formula stands in `CHECKS`. Nothing passes
by absence: what is asked and not known is `not_checked` and leaves the verdict incomplete, what
nobody asked is `not_asked`.
"""

import cmath
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any, Literal

from core.errors import ImpossibleMechanism
from core.exploration.solve import edge
from core.hertz import HALF_WIDTH_RATIO_LIMIT, HertzContact, hertz
from core.materials import ElasticMaterial
from core.output.contact_force import ContactForce, contact_force
from core.output.mechanism import Mechanism, assembly_angles
from core.output.pin_geometry import FIT_TOLERANCE
from core.precession.shaft_deflection import ShaftDeflection
from core.results import ROUNDING
from core.rollers.roller_strength import RollerStrength, roller_gaps

Status = Literal["pass", "marginal", "fail", "not_checked", "not_asked", "not_applicable"]
Outcome = Literal["pass", "marginal", "fail", "incomplete"]

STATUSES: tuple[Status, ...] = (
    "pass",
    "marginal",
    "fail",
    "not_checked",
    "not_asked",
    "not_applicable",
)

MARGIN = 1.1
"""Torque reserve below which a check is marginal."""

FIRST_YIELD = 1.79
"""Largest pressure at first yield below the surface over the yield strength (Mises, v = 0.3)."""

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength: the largest orthogonal shear, a
quarter of it, is the shear yield strength ``Re/sqrt(3)``."""

ROLLER_LENGTH = 10.0
"""Least length of a swinging roller's cylinder over the eccentricity."""


@dataclass(frozen=True, slots=True)
class Kind:
    """What a check is.

    Attributes
    ----------
    title : str
        Its name in English.
    group : str
        What it is about, a key of `GROUPS`.
    unit : str
        Unit of value and limit as names end in it; empty for plain numbers.
    formula : str
        What has to hold.
    why : str
        What is wrong where it does not hold, in English.
    inputs : tuple of str
        Core names of the inputs that it depends on.
    source : str
        Where the formula comes from, a key of `CHECK_SOURCES`.
    """

    title: str
    group: str
    unit: str
    formula: str
    why: str
    inputs: tuple[str, ...]
    source: str = "geometry"


GROUPS = {
    "mechanism": "Mechanism",
    "contact": "Contact of pin and hole",
    "geometry": "Pins and holes",
    "body": "Satellite",
    "rollers": "Rollers",
    "shaft": "Bending of the shaft",
    "room": "Room for rollers and shaft",
}
"""What checks are about, in English, by code."""

CHECK_SOURCES = {
    "beam": "beam theory (Mohr)",
    "geometry": "geometry",
    "hertz": "Johnson, Contact Mechanics, 4.2: Hertz asks for a narrow contact",
    "johnson_yield": "Johnson, Contact Mechanics, 4.2 and 9.1; recomputed: p = 1.79*Re (Mises)",
    "johnson_shakedown": "Melan's theorem, as in Johnson, Contact Mechanics, 9.2; recomputed: "
    "p = 2.31*Re (Mises)",
    "ovsyannikov_2019": "Ovsyannikov et al. 2019",
    "user": "the limit that was asked",
    "wang_2016": "Wang, Luo, Su 2016, eqs 32, 33, and the wall that was asked",
    "yanchevskiy_2021": "Yanchevskiy, Niekhoroshykh 2021",
    "yanchevsky_2018": "Yanchevsky et al. 2018, eq. 2",
}
"""Where the formulas of checks come from, in English, by code."""

REASONS = {
    "conformal_solution": "The pressure is that of the conformal contact, which asks for no narrow "
    "one",
    "dead_centre": "The mechanism has a dead centre: the forces are not bounded",
    "different_parts": "Satellites differ in how their holes lie against their teeth: each needs a "
    "drawing of its own",
    "eccentricity_missing": "No eccentricity is given: it is taken as hole radius minus pin radius",
    "force_law": "With clearance fewer pairs carry at once than the forces assume",
    "limit_unknown": "No limit of the pressure is known for this material: enter one",
    "no_limit": "No limit was asked",
    "no_pressure": "The contact is wider than the pin: no pressure is known",
    "one_only": "There is one only",
    "plastic_first": "The first turns yield below the surface; the contact settles after that",
    "pressure_error": "The limit lies within the error of the pressure",
    "rough_guide": "The contact is too wide for Hertz, and the materials too different for a "
    "conformal pressure: the pressure is a rough guide",
    "tested_limit": "The tested limit of this material counts, not its yield strength",
    "unbalanced": "The satellites need a counterweight",
    "uneven": "Not every roller carries",
    "yield_unknown": "No yield strength is known: enter one",
}
"""Why a status is what it is, where numbers do not say it, in English, by code."""

_FORCE = ("output_torque", "pin_circle_radius", "pins", "satellites", "force_exponent")
_CONTACT = (*_FORCE, "contact_length", "pin_radius", "hole_radius", "dynamic_factor")
_PIN = (*_CONTACT, "pin_material")
_HOLE = (*_CONTACT, "hole_material")
_ROLLER = (
    "output_torque",
    "hole_circle_radius",
    "rollers",
    "diameter",
    "cylinder_length",
    "sphere_width",
    "position_tolerance",
    "gaps",
)
_SHAFT = ("torque", "bearing_distance", "overhang", "shaft_diameter", "shaft_sections")

CHECKS = {
    "dead_centre": Kind(
        "Dead centres", "mechanism", "", "Δθ < 180°",
        "There no pair drives, and no torque is transmitted.",
        ("pins", "satellites", "crank_spacing", "crank_angles"), "yanchevskiy_2021",
    ),
    "crank_balance": Kind(
        "Balance of the crank spacing", "mechanism", "", "|Σ e^(i·α_j)|/K = 0",
        "Otherwise the satellites shake the reducer with every turn of the crank.",
        ("satellites", "crank_spacing", "crank_angles"),
    ),
    "assembly": Kind(
        "Satellites that differ", "mechanism", "", "ψ_j = 0",
        "Otherwise they are different parts that can be exchanged by mistake.",
        ("satellite_teeth", "ring_teeth", "pins", "crank_spacing", "crank_angles"),
        "yanchevskiy_2021",
    ),
    "contact_pressure_pin": Kind(
        "Contact pressure of the pin", "contact", "MPa", "p ≤ p_all/S",
        "Above it the surface of the pin pits in the long run.", _PIN, "yanchevsky_2018",
    ),
    "contact_pressure_hole": Kind(
        "Contact pressure of the hole", "contact", "MPa", "p ≤ p_all/S",
        "Above it the surface of the hole pits in the long run.", _HOLE, "yanchevsky_2018",
    ),
    "contact_shakedown_pin": Kind(
        "Shakedown of the pin", "contact", "MPa", "p ≤ 2.31·R_e",
        "Above it the surface of the pin flows on with every turn.", _PIN, "johnson_shakedown",
    ),
    "contact_shakedown_hole": Kind(
        "Shakedown of the hole", "contact", "MPa", "p ≤ 2.31·R_e",
        "Above it the surface of the hole flows on with every turn.", _HOLE, "johnson_shakedown",
    ),
    "contact_yield_pin": Kind(
        "First yield of the pin", "contact", "MPa", "p ≤ 1.79·R_e",
        "Above it the pin yields below its surface in the first turns.", _PIN, "johnson_yield",
    ),
    "contact_yield_hole": Kind(
        "First yield of the hole", "contact", "MPa", "p ≤ 1.79·R_e",
        "Above it the hole yields below its surface in the first turns.", _HOLE, "johnson_yield",
    ),
    "contact_conformity": Kind(
        "Width of the contact", "contact", "", "a/r ≤ 0.159",
        "Above it the pressure by Hertz is off by more than 1 %.",
        (*_CONTACT, "pin_material", "hole_material"), "hertz",
    ),
    "interference": Kind(
        "Interference of pin and hole", "geometry", "mm", "r_out ≥ r_in + e",
        "Otherwise pin and satellite cannot be assembled.",
        ("pin_radius", "hole_radius", "eccentricity"), "yanchevskiy_2021",
    ),
    "clearance": Kind(
        "Clearance of pin and hole", "geometry", "mm", "r_out − r_in − e = 0",
        "Otherwise fewer pairs carry, each more, and the output has lost motion.",
        ("pin_radius", "hole_radius", "eccentricity"), "yanchevskiy_2021",
    ),
    "wall_holes": Kind(
        "Wall between holes", "geometry", "mm", "2·R·sin(π/N) − 2·r_out ≥ w",
        "Otherwise the holes overlap, or the satellite is weak between them.",
        ("pins", "pin_circle_radius", "hole_radius", "min_wall"), "wang_2016",
    ),
    "pins_apart": Kind(
        "Space between pins", "geometry", "mm", "2·R·sin(π/N) − 2·r_in > 0",
        "Otherwise the pins overlap.", ("pins", "pin_circle_radius", "pin_radius"),
    ),
    "holes_off_centre": Kind(
        "Holes beside the centre", "geometry", "mm", "R − r_out > 0",
        "Otherwise the holes reach the axis.", ("pin_circle_radius", "hole_radius"),
    ),
    "wall_rim": Kind(
        "Wall to the rim", "body", "mm", "r_f − R − r_out ≥ w",
        "Otherwise the holes break through the rim of the satellite.",
        ("outer_radius", "root_radius", "pin_circle_radius", "hole_radius", "min_wall"),
        "wang_2016",
    ),
    "wall_bore": Kind(
        "Wall to the bore", "body", "mm", "R − r_out − r_b ≥ w",
        "Otherwise the holes break into the bore of the satellite.",
        ("bore_radius", "pin_circle_radius", "hole_radius", "min_wall"), "wang_2016",
    ),
    "roller_stress": Kind(
        "Bending stress of the rollers", "rollers", "MPa", "σ ≤ R_e/S",
        "Above it the rollers bend for good.",
        (*_ROLLER, "stress_concentration", "yield_strength", "bending_safety"),
        "ovsyannikov_2019",
    ),
    "roller_sharing": Kind(
        "Rollers that carry", "rollers", "", "n_c = n",
        "Otherwise few rollers carry all of the load.", _ROLLER, "ovsyannikov_2019",
    ),
    "roller_spacing": Kind(
        "Space between rollers", "rollers", "mm", "2·R·sin(π/n) − D > 0",
        "Otherwise the spheres overlap.", ("rollers", "hole_circle_radius", "sphere_diameter"),
    ),
    "roller_room": Kind(
        "Rollers beside the centre", "rollers", "mm", "R − D/2 > 0",
        "Otherwise the rollers reach the axis.", ("hole_circle_radius", "sphere_diameter"),
    ),
    "roller_tilt": Kind(
        "Length of the rollers", "rollers", "mm", "l ≥ 10·e",
        "Shorter ones tilt too much against the discs.", ("cylinder_length", "eccentricity"),
        "ovsyannikov_2019",
    ),
    "line_spacing": Kind(
        "Space between rollers", "room", "mm", "2·R_C·sin(Δφ/2) − 2·ρ > 0",
        "Otherwise the rollers overlap.", ("roller_circle_radius", "roller_radius", "wheel"),
    ),
    "shaft_in_circle": Kind(
        "Shaft within the rollers", "room", "mm", "R_C − ρ − d/2 > 0",
        "Otherwise the shaft reaches the rollers.",
        ("roller_circle_radius", "roller_radius", "shaft_diameter", "shaft_sections"),
    ),
    "shaft_deflection": Kind(
        "Deflection of the shaft", "shaft", "mm", "max(Δ_B, Δ_C) ≤ Δ_max",
        "Above it the mesh is off its place.", (*_SHAFT, "max_deflection"), "beam",
    ),
    "shaft_slope": Kind(
        "Slope of the shaft in its bearings", "shaft", "mrad", "max(θ_B, θ_C) ≤ θ_max",
        "Above it the bearings carry on their edges.", (*_SHAFT, "max_slope"), "beam",
    ),
}  # fmt: skip
"""Every check by code."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """One check of a design.

    Attributes
    ----------
    code : str
        Which, a key of `CHECKS`.
    status : Status
        How it went.
    value, limit : float or None
        What is compared, in SI units; the limit with the required safety in it.
    keep : {"below", "above"}
        On which side of the limit the value has to stay.
    utilisation : float or None
        How much of the limit is used, 1 at the limit; None where the limit is 0 or the value not
        positive.
    torque_reserve : float or None
        Factor on the torque at which the value is at its limit; None where it does not depend on
        it.
    impossible : bool
        Whether the mechanism cannot exist or move so.
    warning : bool
        Whether the check can be marginal at worst.
    reason : str
        Why the status is so, where the numbers do not say it: a key of `REASONS`.
    limit_source, criterion, verified : str
        Of the limit of a material: source, criterion, how that was seen.
    at : dict
        Where the value is reached: satellite, pin, crank_angle (rad).
    missing : tuple of str
        Core names of inputs that would have to be given.
    """

    code: str
    status: Status
    value: float | None = None
    limit: float | None = None
    keep: Literal["below", "above"] = "below"
    utilisation: float | None = None
    torque_reserve: float | None = None
    impossible: bool = False
    warning: bool = False
    reason: str = ""
    limit_source: str = ""
    criterion: str = ""
    verified: str = ""
    at: Mapping[str, float] = field(default_factory=dict)
    missing: tuple[str, ...] = ()

    @property
    def kind(self) -> Kind:
        """What it is."""
        return CHECKS[self.code]

    @property
    def margin(self) -> float | None:
        """What is left to the limit, below 0 beyond it, in SI units."""
        if self.value is None or self.limit is None:
            return None
        return self.limit - self.value if self.keep == "below" else self.value - self.limit


def judged(
    code: str,
    value: float,
    limit: float,
    *,
    keep: Literal["below", "above"] = "below",
    reserve: float | None = None,
    error: float = 4 * ROUNDING,
    strictly: bool = False,
    warning: str = "",
    **more: Any,
) -> Check:
    """A check whose value and limit are known.

    Parameters
    ----------
    code : str
        Which.
    value, limit : float
        What is compared.
    keep : {"below", "above"}
        On which side of the limit the value has to stay.
    reserve : float, optional
        Factor on the torque at which it is at its limit.
    error : float
        Relative error of the value, of number and model: where the limit lies within, the check
        is marginal.
    strictly : bool
        Whether a value at the limit fails.
    warning : str
        Reason where it does not hold, if that is a warning only.
    **more
        Other attributes of the check.

    Returns
    -------
    Check

    Examples
    --------
    >>> judged("contact_pressure_pin", 90.0, 100.0, reserve=1.2).status
    'pass'
    >>> judged("contact_pressure_pin", 99.0, 100.0, reserve=1.02).status
    'marginal'
    >>> judged("wall_holes", 1.0, 2.0, keep="above").utilisation
    2.0
    """
    part, whole = (value, limit) if keep == "below" else (limit, value)
    utilisation = part / whole if whole > 0 and part >= 0 else None
    over = part >= whole if strictly else part > whole
    doubtful = abs(value - limit) <= error * abs(value) and not strictly
    status: Status = "pass"
    if doubtful and reserve is None:
        status = "pass"  # sizes that are asked for are there
    elif over and not doubtful:
        status = "marginal" if warning else "fail"
        more.setdefault("reason", warning)
    elif doubtful or (reserve is not None and reserve < MARGIN and not warning):
        status = "marginal"
        if doubtful and error > 1e-9:
            more.setdefault("reason", "pressure_error")
    return Check(
        code=code,
        status=status,
        value=value,
        limit=limit,
        keep=keep,
        utilisation=utilisation,
        torque_reserve=reserve,
        warning=bool(warning),
        **more,
    )


@dataclass(frozen=True, kw_only=True)
class CrankDesign:
    """A crank-planetary reducer, as far as it is given; SI units.

    Attributes
    ----------
    pins, satellites : int
        Numbers of pins and satellites.
    ratio : float
        Ratio u.
    crank_spacing : float or None
        Angle between neighbouring cranks, rad; None for an even spacing.
    crank_angles : tuple of float or None
        Angle of each crank, rad, instead.
    initial_crank_angle : float
        Wave angle at crank angle 0, rad.
    satellite_teeth : int or None
        Teeth z2 of a satellite.
    output_torque, pin_circle_radius : float or None
        Torque, N*m, and radius R, m; None where there is no load.
    force_exponent : float
        Exponent v of the force over the approach.
    contact_length, pin_radius, hole_radius, eccentricity : float or None
        Sizes of pin and hole, m; None where they are not given.
    pin_material, hole_material : ElasticMaterial or None
        Their materials.
    dynamic_factor, distribution_factor : float
        Factors of the load.
    has_body : bool
        Whether the section of the satellite's body is there.
    outer_radius, root_radius, bore_radius : float or None
        Radii of the satellite, m.
    pitting_safety : float
        Required safety against pitting, of the pressure.
    min_wall : float or None
        Least wall that is asked, m.
    own_limits : tuple of str
        Which materials (`pin_material`, `hole_material`) are given by values.
    """

    pins: int
    satellites: int
    ratio: float
    crank_spacing: float | None = None
    crank_angles: tuple[float, ...] | None = None
    initial_crank_angle: float = 0.0
    satellite_teeth: int | None = None
    output_torque: float | None = None
    pin_circle_radius: float | None = None
    force_exponent: float = 1.0
    contact_length: float | None = None
    pin_radius: float | None = None
    hole_radius: float | None = None
    eccentricity: float | None = None
    pin_material: ElasticMaterial | None = None
    hole_material: ElasticMaterial | None = None
    dynamic_factor: float = 1.0
    distribution_factor: float = 1.0
    has_body: bool = False
    outer_radius: float | None = None
    root_radius: float | None = None
    bore_radius: float | None = None
    pitting_safety: float = 1.2
    min_wall: float | None = None
    own_limits: tuple[str, ...] = ()

    @cached_property
    def mechanism(self) -> Mechanism:
        """Pins and cranks."""
        if self.crank_angles is not None:
            return Mechanism(
                pins=self.pins,
                crank_angles=self.crank_angles,
                ratio=self.ratio,
                initial_crank_angle=self.initial_crank_angle,
            )
        return Mechanism.evenly_spaced(
            pins=self.pins,
            satellites=self.satellites,
            ratio=self.ratio,
            crank_spacing=self.crank_spacing,
            initial_crank_angle=self.initial_crank_angle,
        )

    @property
    def loaded(self) -> bool:
        """Whether a load is given."""
        return self.output_torque is not None

    @property
    def touching(self) -> bool:
        """Whether pins and holes are given."""
        return self.pin_radius is not None

    @cached_property
    def force(self) -> ContactForce | ImpossibleMechanism | None:
        """The contact force; why there is none at a dead centre; None without a load."""
        if self.output_torque is None or self.pin_circle_radius is None:
            return None
        try:
            return contact_force(
                mechanism=self.mechanism,
                output_torque=self.output_torque,
                pin_circle_radius=self.pin_circle_radius,
                force_exponent=self.force_exponent,
            )
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def contact(self) -> HertzContact | None:
        """The contact under the peak force, where that is known."""
        return self.contact_at(1.0) if isinstance(self.force, ContactForce) else None

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times the torque."""
        assert isinstance(self.force, ContactForce)
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        assert self.pin_material is not None and self.hole_material is not None
        return hertz(
            force=self.force.peak_force * factor,
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin_material=self.pin_material,
            hole_material=self.hole_material,
            dynamic_factor=self.dynamic_factor,
            distribution_factor=self.distribution_factor,
        )

    @property
    def peak(self) -> dict[str, float]:
        """Where the contact force peaks."""
        if not isinstance(self.force, ContactForce):
            return {}
        pair = self.force.peak_pair
        return {
            "satellite": pair.satellite,
            "pin": pair.pin,
            "crank_angle": self.force.peak_crank_angle,
        }

    @property
    def pitch(self) -> float | None:
        """Distance of neighbouring pins, m; None where there is one only, or no circle."""
        if self.pin_circle_radius is None or self.pins < 2:
            return None
        return 2 * self.pin_circle_radius * math.sin(math.pi / self.pins)


def _dead_centre(design: CrankDesign) -> Check:
    zones = design.mechanism.phases.dead_zones()
    if not zones:
        return Check(code="dead_centre", status="pass", value=0.0, limit=0.0)
    per_wave = design.mechanism.crank_angle_per_wave
    return Check(
        code="dead_centre",
        status="fail",
        value=float(len(zones)),
        limit=0.0,
        impossible=True,
        at={"crank_angle": zones[0][0] * per_wave},
    )


def _crank_balance(design: CrankDesign) -> Check:
    angles = design.mechanism.crank_angles
    off = abs(sum(cmath.exp(1j * angle) for angle in angles)) / len(angles)
    balanced = off <= 1e-9
    return Check(
        code="crank_balance",
        status="pass" if balanced else "marginal",
        value=0.0 if balanced else off,
        limit=0.0,
        warning=True,
        reason="" if balanced else "unbalanced",
    )


def _assembly(design: CrankDesign) -> Check:
    if design.satellite_teeth is None:
        return Check(code="assembly", status="not_asked", missing=("satellite_teeth",))
    angles = assembly_angles(mechanism=design.mechanism, satellite_teeth=design.satellite_teeth)
    different = sum(not each.identical for each in angles)
    return Check(
        code="assembly",
        status="marginal" if different else "pass",
        value=float(different),
        limit=0.0,
        warning=True,
        reason="different_parts" if different else "",
    )


Body = Literal["pin", "hole"]


def _pressure_check(
    design: CrankDesign, code: str, body: Body, limit: float, warning: str = "", **more: Any
) -> Check:
    """The governing pressure against a limit of a body."""
    contact = design.contact
    if contact is None:
        return Check(code=code, status="not_checked", limit=limit, reason="dead_centre", **more)
    pressure = contact.governing_pressure
    if pressure is None:
        return Check(code=code, status="not_checked", limit=limit, reason="no_pressure", **more)
    conformal = contact.conformal_error or 0.0
    return judged(
        code,
        pressure,
        limit,
        reserve=pressure_reserve(design=design, limit=limit),
        error=conformal + 8 * contact.accuracy.relative_error,
        warning=warning,
        at=design.peak,
        **more,
    )


def pressure_reserve(*, design: CrankDesign, limit: float) -> float | None:
    """Factor on the torque at which the governing pressure is at a limit.

    Hertz's pressure grows with the root of the torque, Persson's faster, up to the torque itself;
    where Persson's takes over, the governing pressure jumps by a per cent.

    Parameters
    ----------
    design : CrankDesign
        The design, with load and contact.
    limit : float
        The limit, Pa.

    Returns
    -------
    float or None
        None where no pressure is known.
    """
    contact = design.contact
    if contact is None or contact.governing_pressure is None:
        return None
    by_hertz = float((limit / contact.max_pressure) ** 2)
    there = design.contact_at(by_hertz)
    if there.conformal_pressure is None:
        # where no theory holds any more, that is the end
        return min(by_hertz, float(contact.half_width_ratio**-2))

    def left(factor: float) -> float:
        pressure = design.contact_at(factor).governing_pressure
        return math.nan if pressure is None else float(limit - pressure)

    ratio = limit / contact.governing_pressure
    met, _ = edge(
        inside=0.97 * min(ratio, ratio * ratio),
        outside=1.03 * max(ratio, ratio * ratio),
        excess=left,
    )
    return met


def _material(design: CrankDesign, body: Body) -> ElasticMaterial:
    material = design.pin_material if body == "pin" else design.hole_material
    assert material is not None
    return material


def _missing(design: CrankDesign, body: Body, value: str) -> tuple[str, ...]:
    """What would have to be given: a value of an own material, or another material."""
    name = f"{body}_material"
    return (f"{name}.{value}",) if name in design.own_limits else (name,)


def _contact_pressure(body: Body) -> Callable[[CrankDesign], Check]:
    code = f"contact_pressure_{body}"

    def check(design: CrankDesign) -> Check:
        limit = _material(design, body).limit
        if limit is None:
            contact = design.contact
            return Check(
                code=code,
                status="not_checked",
                value=None if contact is None else contact.governing_pressure,
                reason="limit_unknown",
                at=design.peak,
                missing=_missing(design, body, "allowable_pressure"),
            )
        return _pressure_check(
            design,
            code,
            body,
            float(limit.pressure) / design.pitting_safety,
            limit_source=limit.source,
            criterion=limit.criterion,
            verified=limit.verified or "",
        )

    return check


def _contact_plastic(name: str, body: Body) -> Callable[[CrankDesign], Check]:
    """First yield, which is a warning, or shakedown."""
    code = f"contact_{name}_{body}"
    ratio, warning = (FIRST_YIELD, "plastic_first") if name == "yield" else (SHAKEDOWN, "")

    def check(design: CrankDesign) -> Check:
        material = _material(design, body)
        if not material.yield_governs:
            return Check(code=code, status="not_applicable", reason="tested_limit")
        if material.yield_strength is None:
            asked = f"{body}_material" not in design.own_limits
            return Check(
                code=code,
                status="not_checked" if asked else "not_asked",
                reason="yield_unknown",
                missing=_missing(design, body, "yield_strength"),
            )
        return _pressure_check(design, code, body, ratio * material.yield_strength, warning)

    return check


def _contact_conformity(design: CrankDesign) -> Check:
    contact, code = design.contact, "contact_conformity"
    if contact is None:
        return Check(code=code, status="not_checked", reason="dead_centre")
    ratio = float(contact.half_width_ratio)
    if contact.conformal_pressure is not None:
        return Check(
            code=code,
            status="not_applicable",
            value=ratio,
            limit=HALF_WIDTH_RATIO_LIMIT,
            reason="conformal_solution",
        )
    return judged(
        code,
        ratio,
        HALF_WIDTH_RATIO_LIMIT,
        reserve=(HALF_WIDTH_RATIO_LIMIT / ratio) ** 2,
        warning="rough_guide",
    )


def _fit(code: str) -> Callable[[CrankDesign], Check]:
    """Interference, which is impossible, or clearance, which strains the forces."""

    def check(design: CrankDesign) -> Check:
        assert design.hole_radius is not None and design.pin_radius is not None
        if design.eccentricity is None:
            return Check(
                code=code,
                status="not_checked",
                reason="eccentricity_missing",
                missing=("eccentricity",),
            )
        needed = design.pin_radius + design.eccentricity
        clearance = design.hole_radius - needed
        if abs(clearance) <= FIT_TOLERANCE * design.hole_radius:
            clearance, needed = 0.0, design.hole_radius
        if code == "interference":
            fails = clearance < 0
            return Check(
                code=code,
                status="fail" if fails else "pass",
                value=design.hole_radius,
                limit=needed,
                keep="above",
                utilisation=needed / design.hole_radius,
                impossible=fails,
            )
        return Check(
            code=code,
            status="marginal" if clearance > 0 else "pass",
            value=max(clearance, 0.0),
            limit=0.0,
            warning=True,
            reason="force_law" if clearance > 0 else "",
        )

    return check


def _wall(code: str, wall: float, size: float, least: float | None = None) -> Check:
    """A wall, which has to be more than nothing, and at least what is asked."""
    if wall <= FIT_TOLERANCE * size:
        wall = min(wall, 0.0)
        return judged(code, wall, least or 0.0, keep="above", strictly=True, impossible=True)
    return judged(code, wall, least or 0.0, keep="above")


def _wall_holes(design: CrankDesign) -> Check:
    if design.pins < 2:
        return Check(code="wall_holes", status="not_applicable", reason="one_only")
    assert design.hole_radius is not None and design.pitch is not None
    wall = design.pitch - 2 * design.hole_radius
    return _wall("wall_holes", wall, design.hole_radius, design.min_wall)


def _pins_apart(design: CrankDesign) -> Check:
    if design.pins < 2:
        return Check(code="pins_apart", status="not_applicable", reason="one_only")
    assert design.pin_radius is not None and design.pitch is not None
    return _wall("pins_apart", design.pitch - 2 * design.pin_radius, design.pin_radius)


def _holes_off_centre(design: CrankDesign) -> Check:
    assert design.hole_radius is not None and design.pin_circle_radius is not None
    return _wall(
        "holes_off_centre", design.pin_circle_radius - design.hole_radius, design.hole_radius
    )


def _wall_rim(design: CrankDesign) -> Check:
    radii = [each for each in (design.outer_radius, design.root_radius) if each is not None]
    if not radii:
        return Check(code="wall_rim", status="not_asked", missing=("outer_radius",))
    assert design.hole_radius is not None and design.pin_circle_radius is not None
    wall = min(radii) - design.pin_circle_radius - design.hole_radius
    return _wall("wall_rim", wall, design.hole_radius, design.min_wall)


def _wall_bore(design: CrankDesign) -> Check:
    if design.bore_radius is None:
        return Check(code="wall_bore", status="not_asked", missing=("bore_radius",))
    assert design.hole_radius is not None and design.pin_circle_radius is not None
    wall = design.pin_circle_radius - design.hole_radius - design.bore_radius
    return _wall("wall_bore", wall, design.hole_radius, design.min_wall)


MECHANISM: dict[str, Callable[[CrankDesign], Check]] = {
    "dead_centre": _dead_centre,
    "crank_balance": _crank_balance,
    "assembly": _assembly,
}
CONTACT: dict[str, Callable[[CrankDesign], Check]] = {
    "contact_pressure_pin": _contact_pressure("pin"),
    "contact_pressure_hole": _contact_pressure("hole"),
    "contact_shakedown_pin": _contact_plastic("shakedown", "pin"),
    "contact_shakedown_hole": _contact_plastic("shakedown", "hole"),
    "contact_yield_pin": _contact_plastic("yield", "pin"),
    "contact_yield_hole": _contact_plastic("yield", "hole"),
    "contact_conformity": _contact_conformity,
}
FIT: dict[str, Callable[[CrankDesign], Check]] = {
    "interference": _fit("interference"),
    "clearance": _fit("clearance"),
}
PLACE: dict[str, Callable[[CrankDesign], Check]] = {
    "wall_holes": _wall_holes,
    "pins_apart": _pins_apart,
    "holes_off_centre": _holes_off_centre,
}
SATELLITE: dict[str, Callable[[CrankDesign], Check]] = {
    "wall_rim": _wall_rim,
    "wall_bore": _wall_bore,
}
CRANK = MECHANISM | CONTACT | FIT | PLACE | SATELLITE
"""Checks of a crank-planetary reducer, by code."""


def crank_tables(design: CrankDesign) -> dict[str, Callable[[CrankDesign], Check]]:
    """The checks that the sections of a design allow.

    Parameters
    ----------
    design : CrankDesign
        The design.

    Returns
    -------
    dict
        Functions of the design, by code.
    """
    tables = dict(MECHANISM)
    if design.touching:
        tables |= FIT
    if design.touching and design.loaded:
        tables |= CONTACT | PLACE
        if design.has_body:
            tables |= SATELLITE
    return tables


def crank_checks(design: CrankDesign) -> "Verdict":
    """All checks of a crank-planetary reducer.

    Parameters
    ----------
    design : CrankDesign
        The design.

    Returns
    -------
    Verdict
    """
    missing = {"load": not design.loaded, "contact": not design.touching}
    missing |= {"satellite_body": not design.has_body}
    later = ("clearance", "pin", "friction", "gear", "bearing", "crankshaft")
    return verdict(
        [check(design) for check in crank_tables(design).values()],
        (*[name for name, absent in missing.items() if absent], *later),
    )


def roller_checks(
    *,
    result: RollerStrength,
    output_torque: float,
    hole_circle_radius: float,
    rollers: int,
    sphere_diameter: float,
    cylinder_length: float,
    position_tolerance: float | None = None,
    gaps: Sequence[float] | None = None,
    yield_strength: float | None = None,
    eccentricity: float | None = None,
    bending_safety: float = 1.5,
) -> "Verdict":
    """All checks of swinging rollers.

    Parameters
    ----------
    result : RollerStrength
        Their load sharing and strength.
    output_torque, hole_circle_radius, rollers, sphere_diameter, cylinder_length : as there
        What they were calculated for.
    position_tolerance, gaps : as there
        One of them.
    yield_strength : float, optional
        Yield strength of the rollers, Pa.
    eccentricity : float, optional
        Eccentricity of the crank, m.
    bending_safety : float
        Required safety against yield.

    Returns
    -------
    Verdict
    """
    stress = float(result.bending_stress)
    if yield_strength is None:
        strength = Check(
            code="roller_stress",
            status="not_checked",
            value=stress,
            reason="yield_unknown",
            missing=("yield_strength",),
        )
    else:
        limit = yield_strength / bending_safety
        # F_i = c*max(0, Delta - g_i): what the rollers carry when the first is at its limit
        largest = float(result.max_force) * limit / stress
        ahead = roller_gaps(rollers=rollers, position_tolerance=position_tolerance, gaps=gaps)
        first = min(ahead)
        carried = math.fsum(
            max(0.0, largest - float(result.stiffness) * (gap - first)) for gap in ahead
        )
        strength = judged(
            "roller_stress",
            stress,
            limit,
            reserve=2 * hole_circle_radius * carried / output_torque,
            error=4 * float(result.accuracy.relative_error),
        )
    sharing = judged(
        "roller_sharing",
        float(result.loaded_rollers),
        float(rollers),
        keep="above",
        warning="uneven",
        error=0.0,
    )
    if rollers > 1:
        pitch = 2 * hole_circle_radius * math.sin(math.pi / rollers)
        spacing = _wall("roller_spacing", pitch - sphere_diameter, sphere_diameter)
    else:
        spacing = Check(code="roller_spacing", status="not_applicable", reason="one_only")
    room = _wall("roller_room", hole_circle_radius - sphere_diameter / 2, sphere_diameter)
    if eccentricity is None:
        tilt = Check(
            code="roller_tilt", status="not_asked", value=cylinder_length, missing=("eccentricity",)
        )
    else:
        tilt = judged("roller_tilt", cylinder_length, ROLLER_LENGTH * eccentricity, keep="above")
    return verdict(
        [strength, _certain(sharing), spacing, room, tilt],
        ("roller_contact", "fatigue", "friction"),
    )


def _certain(check: Check) -> Check:
    """A check of whole numbers: at its limit it passes."""
    if check.value == check.limit:
        return Check(
            code=check.code,
            status="pass",
            value=check.value,
            limit=check.limit,
            keep=check.keep,
            utilisation=check.utilisation,
            warning=check.warning,
        )
    return check


def shaft_checks(
    *,
    result: ShaftDeflection,
    positions: Sequence[float],
    roller_circle_radius: float,
    roller_radius: float,
    diameters: Iterable[float],
    max_deflection: float | None = None,
    max_slope: float | None = None,
) -> "Verdict":
    """All checks of a precessional gear and its shaft.

    Parameters
    ----------
    result : ShaftDeflection
        The shaft's deflection and slope.
    positions : sequence of float
        Position angles of the wheel's rollers, rad; the same one twice is one roller.
    roller_circle_radius, roller_radius : float
        Radii R_C of the circle of the rollers and rho of a roller, m.
    diameters : iterable of float
        Diameters of the shaft, m.
    max_deflection, max_slope : float, optional
        Largest deflection, m, and slope, rad, that are asked for.

    Returns
    -------
    Verdict
    """
    turn = 2 * math.pi
    places = sorted(angle % turn for angle in positions)
    apart = [(after - before) for before, after in pairwise(places)]
    apart = [each for each in [*apart, places[0] + turn - places[-1]] if 1e-9 < each < turn - 1e-9]
    if apart:
        pitch = 2 * roller_circle_radius * math.sin(min(min(apart), math.pi) / 2)
        spacing = _wall("line_spacing", pitch - 2 * roller_radius, roller_radius)
    else:
        spacing = Check(code="line_spacing", status="not_applicable", reason="one_only")
    room = roller_circle_radius - roller_radius - max(diameters) / 2
    deflection = max(result.deflection_B.total, result.deflection_C.total)
    slope = max(result.slope_B.total, result.slope_C.total)
    error = float(result.accuracy.relative_error)
    return verdict(
        [
            spacing,
            _wall("shaft_in_circle", room, roller_radius),
            _asked("shaft_deflection", deflection, max_deflection, "max_deflection", error),
            _asked("shaft_slope", slope, max_slope, "max_slope", error),
        ],
        ("line_pressure", "shaft_strength", "bearing", "friction"),
    )


def _asked(code: str, value: float, limit: float | None, name: str, error: float) -> Check:
    """A value that grows with the torque against a limit that the user may ask."""
    if limit is None:
        return Check(code=code, status="not_asked", value=value, reason="no_limit", missing=(name,))
    reserve = limit / value if value > 0 else None
    return judged(code, value, limit, reserve=reserve, error=4 * error)


NOT_CONSIDERED = {
    "bearing": "bearings",
    "clearance": "load sharing with clearance and deviations",
    "contact": "pins and holes",
    "crankshaft": "crankshaft and balance of masses",
    "fatigue": "fatigue",
    "friction": "friction, wear and efficiency",
    "gear": "teeth of satellite and ring",
    "line_pressure": "pressure along the contact lines",
    "load": "load",
    "pin": "bending of the pins",
    "roller_contact": "contact of spheres and holes",
    "satellite_body": "body of the satellite",
    "shaft_strength": "strength of the shaft",
}
"""What a verdict does not consider, in English, by code."""


@dataclass(frozen=True, slots=True)
class Verdict:
    """What all checks of a design come to.

    Attributes
    ----------
    verdict : Outcome
        `fail` where a check fails, else `incomplete` where one could not be made, else `marginal`
        where one is, else `pass`.
    governing : str or None
        Code of the check that decides: the worst failing one, else the one next to its limit.
    torque_reserve : float or None
        Factor on the torque at which the first check fails.
    largest_torque_known : bool
        Whether the torque alone decides: nothing fails that less torque does not cure, and nothing
        is unknown.
    counts : dict of str to int
        How many checks have each status.
    not_considered : tuple of str
        What is not looked at, keys of `NOT_CONSIDERED`.
    checks : tuple of Check
        All of them, the one that decides first.
    """

    verdict: Outcome
    governing: str | None
    torque_reserve: float | None
    largest_torque_known: bool
    counts: dict[str, int]
    not_considered: tuple[str, ...]
    checks: tuple[Check, ...]

    def __getitem__(self, code: str) -> Check:
        """The check of a code."""
        return next(each for each in self.checks if each.code == code)


def _rank(check: Check) -> tuple[float, ...]:
    """Order of checks: impossible, failing, marginal, passing, then what is not judged.

    Utilisations of different powers of the torque cannot be compared; its reserve can. What fails
    whatever the torque comes before.
    """
    order = {"fail": 1, "marginal": 2, "pass": 3, "not_checked": 4, "not_asked": 5}
    place = 0 if check.impossible and check.status == "fail" else order.get(check.status, 6)
    reserve = check.torque_reserve
    if reserve is None:
        reserve = 0.0 if check.status == "fail" else math.inf
    used = -check.utilisation if check.utilisation is not None else 0.0
    return place, reserve, used


def verdict(checks: Iterable[Check], not_considered: tuple[str, ...] = ()) -> Verdict:
    """The verdict of checks.

    Parameters
    ----------
    checks : iterable of Check
        The checks.
    not_considered : tuple of str
        What is not looked at, keys of `NOT_CONSIDERED`.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> passing = judged("contact_pressure_pin", 50.0, 100.0, reserve=4.0)
    >>> unknown = Check(code="contact_pressure_hole", status="not_checked")
    >>> found = verdict([unknown, passing])
    >>> found.verdict, found.governing, found.torque_reserve
    ('incomplete', 'contact_pressure_pin', 4.0)
    """
    ranked = tuple(sorted(checks, key=_rank))
    counts: dict[str, int] = {
        status: sum(each.status == status for each in ranked) for status in STATUSES
    }
    outcome: Outcome = "pass"
    if counts["fail"]:
        outcome = "fail"
    elif counts["not_checked"]:
        outcome = "incomplete"
    elif counts["marginal"]:
        outcome = "marginal"
    decided = [each for each in ranked if each.status in ("fail", "marginal", "pass")]
    reserves = [
        each.torque_reserve
        for each in decided
        if each.torque_reserve is not None and not each.warning
    ]
    stuck = any(each.status == "fail" and each.torque_reserve is None for each in decided)
    return Verdict(
        verdict=outcome,
        governing=decided[0].code if decided else None,
        torque_reserve=min(reserves, default=None),
        largest_torque_known=bool(reserves) and not stuck and not counts["not_checked"],
        counts=counts,
        not_considered=not_considered,
        checks=ranked,
    )
