"""Elasticity that shares the load: contacts of pin and hole by their law, pins that bend, and
supports of the satellites (elastic crank bearings, an elastic mesh, or given shares of the torque).

Hertz's law, with ``q = pi*b*E*/(4*rho)`` and ``c = (1 - nu^2)/E``, counts the pin from its surface
to its axis, ``c_1*(2*ln(4*r/a) - 1)``, and the hole as a half-space to the depth t,
``c_2*(2*ln(2*t/a) - nu_2/(1 - nu_2))``, each times ``F/(pi*b)``, with ``a^2 = F/q`` (Johnson,
Contact Mechanics, 4.2 and 5.6). Published laws differ by 5 to 45 %: forces hardly change with the
law, and the stiffness is good to 10 to 25 %.

With the second moment of area I, the area S and the shear coefficient k of a pin's section (10/9 of
a solid pin) a unit force at z bends the pin at x <= z by ``x^2*(3*z - x)/(6*E*I) + k*x/(G*S)`` as a
cantilever, and by ``x*(L - z)*(2*L*z - x^2 - z^2)/(6*E*I*L) + k*x*(L - z)/(G*S*L)`` on two
supports. Clamped ends take from the latter what their moments turn back.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np

from core.arrays import FloatArray, Number, check_count, check_positive, larger, log
from core.drive.engine import CONFORMAL, HERTZ, HERTZ_END, LINEAR, POWER
from core.drive.model import Bending
from core.errors import InvalidInput
from core.fields import LARGEST, Variants, optional_size, quantity, size
from core.hertz import ElasticMaterial, effective_modulus
from core.materials import SOFT
from core.output.conformal_law import NO_CURVE, Curve, approach_over_load, conformal_curve, end
from core.output.mechanism import MAX_SATELLITES
from core.output.pin_beam import PinBeam, Support, check_apart
from core.output.pin_section import PinSection, check_bore
from core.output.tie_ring import RingJoint, TieRing
from core.precision import SAME

MIN_EXPONENT, MAX_EXPONENT = 0.5, 3.0
"""Range of exponents of a power law with gaps; below it ``(T/k)^(1/n)`` leaves the range of
numbers."""

LOG_EXPONENT = 10 / 9
"""Exponent of the power law nearest to Hertz's law with its logarithm."""


@dataclass(frozen=True, slots=True)
class LinearLaw:
    """Linear law ``F = k*delta``."""

    stiffness: float = size("Contact stiffness", "k", "N_per_mm", step=1000)
    """Stiffness of a pair of pin and hole, for the linear law."""


@dataclass(frozen=True, slots=True)
class PowerLaw:
    """Power law ``F = F_ref*(delta/delta_ref)^n``."""

    exponent: float = quantity("Exponent", "n", step=0.1, ge=MIN_EXPONENT, le=MAX_EXPONENT)
    """Exponent n of the power law, force ∝ approachⁿ."""
    reference_force: float = size("Reference force", "F_ref", "N", step=100)
    """Force at which the approach of a pair is known, for the power law."""
    reference_approach: float = size("Reference approach", "δ_ref", "mm", step=0.001)
    """Approach of a pair under the reference force, for the power law."""


@dataclass(frozen=True, slots=True)
class PalmgrenLaw:
    """Palmgren's law of steel rollers, 1959: ``delta = 3.84e-5*F^0.9/b^0.8`` in mm and N."""


@dataclass(frozen=True, slots=True)
class HertzLaw:
    """Hertz's law of line contact: ``delta = F*(A - B*ln F)``.

    A plane contact has no scale of its own: the approach depends on the logarithm of the depth to
    which it is counted.
    """

    reference_depth: float | None = optional_size(
        "Reference depth", "t", "mm", step=1, advanced=True
    )
    """Depth to which the Hertz law counts the approach of the hole; the hole's radius if not
    given."""

    def depth(self, hole_radius: float) -> float:
        """Reference depth in a hole of a nominal radius, m."""
        return hole_radius if self.reference_depth is None else self.reference_depth


@dataclass(frozen=True, slots=True)
class ConformalLaw:
    """Law of a hole that wraps around its pin: approach over force of `core.output.conformal_law`,
    counted to a circle of three hole radii.
    """


ContactLaw = LinearLaw | PowerLaw | PalmgrenLaw | HertzLaw | ConformalLaw

LAWS = Variants(
    {
        None: HertzLaw,
        "hertz": HertzLaw,
        "conformal": ConformalLaw,
        "palmgren": PalmgrenLaw,
        "linear": LinearLaw,
        "power": PowerLaw,
    },
    title="Law of contact",
    help="Hertz: line contact with a logarithmic approach; conformal: the hole wraps around the "
    "pin, and its approach is counted to a depth of three hole radii; Palmgren: steel rollers; "
    "linear; power. The default is conformal if a body is softer than 20 GPa, else Hertz.",
    about="Elastic law of a pair of pin and hole.\n\n"
    "If it is not given, the conformal law holds with a body below 20 GPa, else Hertz's law.",
)
"""Contact laws by their kind in the document."""


def usual_law(*, pin: ElasticMaterial, hole: ElasticMaterial) -> ContactLaw:
    """Law where none is given: conformal if a body is softer than `core.materials.SOFT`, else
    Hertz's. Loads have no influence, so that results do not jump.
    """
    soft = min(pin.youngs_modulus, hole.youngs_modulus) < SOFT
    return ConformalLaw() if soft else HertzLaw()


@dataclass(frozen=True, slots=True)
class Pins:
    """Support of the output pins: rigid here, elastic in `PinSupport`."""

    @property
    def bends(self) -> bool:
        """True if each pin bends by itself."""
        return False

    @property
    def tied(self) -> bool:
        """True if a tie ring joins the pins."""
        return False

    @property
    def loosely_tied(self) -> bool:
        """True if joints of a tie ring are pinned; their clearance is left out."""
        return False

    def at(self, satellite: int) -> Self:
        """Pins under one satellite alone, counted from 0."""
        return self

    def bending(self, satellites: int) -> list[float]:
        """Compliance of a pin at each of K satellites by its bending, m/N; `InvalidInput` is raised
        if the pins are not held for K satellites.
        """
        return [0.0] * satellites

    def wall_compliance(self, contact_length: float) -> float:
        """Compliance of the wall about the pin's bore, m/N, in series with each contact, for a
        contact length in m; `InvalidInput` is raised if satellites reach into each other.
        """
        return 0.0

    @property
    def spring(self) -> Bending | None:
        """Stiffness of a pin between its satellites; None where pins do not bend."""
        return None


RIGID_PINS = Pins()


@dataclass(frozen=True, slots=True)
class PinSupport(Pins):
    """Elastic pins: how they are held, and where the satellites load them."""

    support: Support = quantity("Support", filled=True)
    """Support of the pin: one end fixed (cantilever), both ends free to tilt (supported), both ends
    built in (fixed), or one end fixed and the other ends joined by a free ring (tie ring). The true
    support of a cage lies between supported and fixed; a tie ring supports less."""
    diameter: float = size("Pin diameter", "d", "mm", step=0.5, filled=True)
    """Diameter of the pin itself, inside its sleeve or its rollers where it has them."""
    satellite_positions: tuple[float, ...] = size(
        "Places of the satellites", "z₁ … z_K", "mm", lengths=((1, MAX_SATELLITES),), filled=True
    )
    """Middle plane of each satellite, from the face of the carrier."""
    material: ElasticMaterial = quantity("Material of the pin", filled=True)
    """Name in the table of materials, or values; the pin material of the contact if not given."""
    span: float | None = optional_size("Span", "L", "mm", step=1)
    """Distance between the two supports, or from the carrier to the middle of the tie ring; not for
    a cantilever."""
    bore_diameter: float = quantity(
        "Bore of the pin", "d_i", "mm", default=0.0, step=0.5, ge=0, le=LARGEST, or_zero=True
    )
    """Diameter of the pin's bore, up to 0.95 of the pin diameter; 0 for a solid pin."""
    ring_joint: RingJoint = quantity("Joint of the tie ring", default="pinned", silent=True)
    """Joint of the pins' ends to the tie ring: free to turn (pinned), which is the default, or
    clamped."""

    @property
    def section(self) -> PinSection:
        """Section of the pin."""
        return PinSection(self.diameter, self.bore_diameter)

    @property
    def known_span(self) -> float:
        """Span of the supports, m; `InvalidInput` is raised where none is given."""
        if self.span is None:
            raise InvalidInput("span", None, "needed", field="support")
        return self.span

    @property
    def bends(self) -> bool:
        """True unless a tie ring joins the pins."""
        return not self.tied

    @property
    def tied(self) -> bool:
        """True if a tie ring joins the pins."""
        return self.support == "tie_ring"

    @property
    def loosely_tied(self) -> bool:
        """True if a tie ring has pinned joints."""
        return self.tied and self.ring_joint == "pinned"

    def at(self, satellite: int) -> Self:
        """Pins under one satellite alone, counted from 0."""
        return replace(
            self, satellite_positions=self.satellite_positions[satellite : satellite + 1]
        )

    def bending(self, satellites: int) -> list[float]:
        """Compliance of a pin at each satellite, m/N; see `pin_compliance`."""
        check_count(satellites, satellite_positions=self.satellite_positions)
        return [*pin_compliance(self)]

    def wall_compliance(self, contact_length: float) -> float:
        """Compliance of the wall about the bore, m/N; see `Pins.wall_compliance`."""
        places = self.satellite_positions
        check_apart(name="satellite_positions", positions=places, width=contact_length)
        given = self.section.wall_compliance(
            contact_length=contact_length,
            youngs_modulus=self.material.youngs_modulus,
            poissons_ratio=self.material.poissons_ratio,
        )
        return float(given)

    @property
    def spring(self) -> Bending:
        """Stiffness of a pin between its satellites, and at the end that a tie ring joins."""
        count, places = len(self.satellite_positions), self.satellite_positions
        if not self.tied:
            return Bending(np.asarray(np.linalg.inv(pin_flexibility(self)), float))
        ring, nodes = ring_of(self), (*places, self.known_span)
        whole = np.linalg.inv([[ring.flexibility(x, z) for z in nodes] for x in nodes])
        return Bending(whole[:count, :count], float(whole[count, count]), whole[:count, count])


def pin_flexibility(pin: PinSupport) -> FloatArray:
    """Deflections of a pin at its satellites under a unit force at each by bending and shear, m/N,
    shape (K, K). A pin that a tie ring joins counts as a cantilever.
    """
    check_positive(diameter=pin.diameter)
    check_bore(bore_diameter=pin.bore_diameter, diameter=pin.diameter)
    d, bore, ratio = pin.diameter, pin.bore_diameter, pin.material.poissons_ratio
    bending = pin.material.youngs_modulus * math.pi * (d**4 - bore**4) / 64
    coefficient = pin.section.shear_coefficient(ratio)
    shear = coefficient / (pin.material.shear_modulus * math.pi * (d**2 - bore**2) / 4)
    span = math.inf if pin.support == "cantilever" else pin.known_span
    for index, z in enumerate(pin.satellite_positions):
        name = f"satellite_positions[{index}]"
        check_positive(**{name: z})
        if not z < span:
            raise InvalidInput(name, z, "smaller_than", field="span", limit=span)
    places = np.array(pin.satellite_positions)
    x, z = np.minimum.outer(places, places), np.maximum.outer(places, places)
    found: FloatArray
    if pin.support in ("cantilever", "tie_ring"):
        found = x * x * (3 * z - x) / (6 * bending) + shear * x
        return found
    rest = span - z
    found = x * rest * (2 * span * z - x * x - z * z) / (6 * bending * span)
    found += shear * x * rest / span
    if pin.support == "fixed":
        # Moments at the clamped ends turn back the end rotations by the force, even and odd.
        turned = places * (span - places) / (6 * bending * span)
        near, far = turned * (2 * span - places), turned * (span + places)
        even, odd = span / (2 * bending), span / (6 * bending) + 2 * shear / span
        found -= np.outer(near + far, near + far) / (2 * even)
        found -= np.outer(near - far, near - far) / (2 * odd)
    return found


def pin_compliance(pin: PinSupport) -> tuple[float, ...]:
    """Deflection of a pin under a unit force, m/N, at each satellite that loads it alone.

    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> pin = PinSupport("cantilever", 0.01, (0.008, 0.022), steel)
    >>> [round(c*1e9, 3) for c in pin_compliance(pin)]
    [3.057, 38.285]
    """
    return tuple(pin_flexibility(pin).diagonal().tolist())


def ring_of(pin: PinSupport) -> TieRing:
    """Tie ring with the span and the stiffness of one of its pins."""
    beam = PinBeam.round(
        support=pin.support,
        diameter=pin.diameter,
        bore_diameter=pin.bore_diameter,
        contact_length=1.0,  # length of the loads, which are single forces here
        youngs_modulus=pin.material.youngs_modulus,
        poissons_ratio=pin.material.poissons_ratio,
    )
    return TieRing(pin.ring_joint, pin.known_span, beam.rigidity, beam.shear_area)


def contact_compliance(
    *,
    law: ContactLaw,
    contact_length: float,
    pin_radius: float,
    hole_radius: float,
    pin: ElasticMaterial,
    hole: ElasticMaterial,
) -> Callable[[Number], Number]:
    """Approach of a contact over its force, m/N, by the secant of its law: a function of the force,
    N, > 0.

    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> size = {"contact_length": 0.02, "pin_radius": 0.008, "hole_radius": 0.010}
    >>> found = contact_compliance(law=HertzLaw(), **size, pin=steel, hole=steel)
    >>> round(found(1e4/3)*1e4/3*1e6, 4)
    3.8423
    """
    check_law(law)
    clearance = hole_radius - pin_radius
    check_positive(contact_length=contact_length, pin_radius=pin_radius, clearance=clearance)
    kind, exponent = law_kind(law)
    constants = law_constants(
        law=law, contact_length=contact_length, hole_radius=hole_radius, pin=pin, hole=hole
    )
    given = pair_law(kind=kind, law=constants, pin=pin_radius, wide=clearance, give=0.0)
    a, b = map(float, given[:2])
    curve = law_curve(law=law, contact_length=contact_length, pin=pin, hole=hole)
    return lambda force: _secant(kind, force, a, b, exponent, curve)


def _secant(
    kind: int, force: Number, a: Number, b: Number, exponent: float, curve: Curve
) -> Number:
    """Approach over force, m/N, of a contact with its compliance in series; see `pair_law`."""
    if kind == LINEAR:
        return a + 0.0 * force
    if kind == HERTZ:
        return b * larger(a / b - log(force), HERTZ_END)
    if kind == CONFORMAL:
        return (approach_over_load(load=force / a, curve=curve) + b) / curve.modulus
    return (force / a) ** (1 / exponent) / force + b


def approach_under(*, law: ContactLaw, curve: Curve, force: Number, a: Number, b: Number) -> Number:
    """Approach, m, of a contact and its pin's compliance under a force > 0, N; see `pair_law`."""
    kind, exponent = law_kind(law)
    return force * _secant(kind, force, a, b, exponent, curve)


class Law(NamedTuple):
    """Constants of the contact law of all pairs."""

    a: float = 0.0  # LINEAR 1/k; POWER k; CONFORMAL b*E*
    first: float = 0.0  # HERTZ: (1 - nu^2)/E of the pin
    second: float = 0.0  # HERTZ: (1 - nu^2)/E of the hole
    quarter: float = 0.0  # pi*b*E*/4
    around: float = 0.0  # pi*b
    depth: float = 0.0  # depth to which the hole's approach is counted, m
    ratio: float = 0.0  # nu/(1 - nu) of the hole
    end: float = 0.0  # CONFORMAL: load Q/(E* dR) at which the law ends


def pair_law(*, kind: int, law: Law, pin: Any, wide: Any, give: Any) -> tuple[Any, Any, Any]:
    """Constants a and b of contacts, and the force at which their law ends, N.

    With the compliance C in series they are LINEAR ``1/k + C, 0``; POWER ``k, C``; HERTZ
    ``A + C, B`` of ``F*(A - B*ln F)``; CONFORMAL ``b*E*dR, b*E*C``. Radius of the pin and
    difference of the radii are in m; a lobe has no difference (None), as its curvature depends on
    the position: HERTZ is then taken at a reduced radius of 1 m.
    """
    if kind == LINEAR:
        return law.a + give, 0.0, math.inf
    if kind == POWER:
        return law.a, give, math.inf
    if kind == CONFORMAL:
        return law.a * wide, law.a * give, law.a * wide * law.end
    q = law.quarter / (1.0 if wide is None else pin * (pin + wide) / wide)
    b = (law.first + law.second) / law.around
    a = law.first * (np.log(16 * pin * pin * q) - 1)
    a = (a + law.second * (np.log(4 * law.depth * law.depth * q) - law.ratio)) / law.around
    limit = np.minimum(q * pin * pin, np.exp(np.minimum(a / b - HERTZ_END, 700.0)))
    return a + give, b, limit


def law_kind(law: ContactLaw) -> tuple[int, float]:
    """Kind of a law (`LINEAR`, `POWER`, `HERTZ` or `CONFORMAL`) and exponent of its force over the
    approach, as the engine takes them.
    """
    match law:
        case LinearLaw():
            return LINEAR, 1.0
        case PowerLaw(exponent=exponent):
            return POWER, exponent
        case PalmgrenLaw():
            return POWER, LOG_EXPONENT
        case ConformalLaw():
            return CONFORMAL, LOG_EXPONENT
    return HERTZ, LOG_EXPONENT


def check_law(law: ContactLaw) -> None:
    """Raise `InvalidInput` if a number of a law is out of range."""
    match law:
        case LinearLaw(stiffness=stiffness):
            check_positive(stiffness=stiffness)
        case PowerLaw(exponent=n, reference_force=force, reference_approach=approach):
            check_positive(reference_force=force, reference_approach=approach)
            if not n >= MIN_EXPONENT:
                raise InvalidInput("exponent", n, "greater_than_equal", limit=MIN_EXPONENT)
            if not n <= MAX_EXPONENT:
                raise InvalidInput("exponent", n, "less_than_equal", limit=MAX_EXPONENT)
        case HertzLaw():
            check_positive(reference_depth=law.depth(1.0))


def law_constants(
    *,
    law: ContactLaw,
    contact_length: float,
    hole_radius: float,
    pin: ElasticMaterial,
    hole: ElasticMaterial,
) -> Law:
    """Constants of a law, from which `pair_law` makes those of each pair, for a nominal hole
    radius, m; the module's docstring has Hertz's formulas.
    """
    match law:
        case LinearLaw(stiffness=stiffness):
            return Law(1 / stiffness)
        case PowerLaw(exponent=n, reference_force=force, reference_approach=approach):
            return Law(force / approach**n)
        case PalmgrenLaw():
            per_force = 3.84e-5 / (1e3 * contact_length) ** 0.8 * 1e-3  # m/N^0.9
            return Law(per_force**-LOG_EXPONENT)
        case ConformalLaw():
            curve = law_curve(law=law, contact_length=contact_length, pin=pin, hole=hole)
            return Law(curve.modulus, end=end(curve))
    around = math.pi * contact_length
    return Law(
        first=(1 - pin.poissons_ratio**2) / pin.youngs_modulus,
        second=(1 - hole.poissons_ratio**2) / hole.youngs_modulus,
        quarter=around * effective_modulus(first=pin, second=hole) / 4,
        around=around,
        depth=law.depth(hole_radius),
        ratio=hole.poissons_ratio / (1 - hole.poissons_ratio),
    )


def law_curve(
    *,
    law: ContactLaw,
    contact_length: float,
    pin: ElasticMaterial,
    hole: ElasticMaterial,
) -> Curve:
    """Curve of a conformal contact; `NO_CURVE` for other laws."""
    if not isinstance(law, ConformalLaw):
        return NO_CURVE
    return conformal_curve(contact_length=contact_length, pin=pin, hole=hole)


@dataclass(frozen=True, slots=True)
class SatelliteSupport:
    """Support of the satellites: rigid here, elastic in subclasses."""

    gives: ClassVar[bool] = False
    """True if the support lets satellites move or turn."""
    turning: ClassVar[bool] = False
    """True if satellites turn against each other."""

    @property
    def bearing(self) -> float:
        """Stiffness of one satellite's bearing on its crank, N/m; 0 where rigid."""
        return 0.0

    @property
    def mesh(self) -> float:
        """Torque over rotation of one satellite in its mesh, N*m/rad; 0 where rigid."""
        return 0.0

    @property
    def loose(self) -> float:
        """Free travel of a satellite to either side of its middle, m."""
        return 0.0

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Given shares of the torque; empty where they follow from elasticity."""
        return ()

    def check(self, satellites: int) -> None:
        """Raise `InvalidInput` if a size is out of range, or if shares are not one for each
        satellite or do not add up to 1.
        """


RIGID_SUPPORT = SatelliteSupport()


@dataclass(frozen=True, slots=True)
class CrankSupport(SatelliteSupport):
    """Bearings of the satellites on their cranks. The force of the ring on them is left out."""

    stiffness: float = size(
        "Stiffness of a bearing", "k_b", "N_per_mm", default=math.inf, step=10_000
    )
    """Radial stiffness of the bearing of one satellite; the bearing is rigid if not given."""
    radial_clearance: float = quantity(
        "Clearance of a bearing", "G", "mm", default=0.0, step=0.005, ge=0, le=LARGEST
    )
    """Radial internal clearance as stated in catalogues; half of it lies on either side."""
    gives: ClassVar[bool] = True

    @property
    def bearing(self) -> float:
        """Radial stiffness of one bearing, N/m; 0 where it is not given."""
        return self.stiffness if math.isfinite(self.stiffness) else 0.0

    @property
    def loose(self) -> float:
        """Half of a bearing's radial clearance, m."""
        return self.radial_clearance / 2

    def check(self, satellites: int) -> None:
        """Raise `InvalidInput` if stiffness or clearance is out of range."""
        check_positive(stiffness=self.stiffness)
        if not 0 <= self.radial_clearance < math.inf:
            clearance = self.radial_clearance
            raise InvalidInput("radial_clearance", clearance, "greater_than_equal", limit=0)


@dataclass(frozen=True, slots=True)
class ElasticMesh(SatelliteSupport):
    """Mesh of each satellite with the ring, which lets the disc turn under its torque."""

    stiffness: float = size("Stiffness of a mesh", "k_D", "Nm_per_arcmin", step=1)
    """Torque of one satellite over the rotation that its mesh allows, for elastic coupling."""
    gives: ClassVar[bool] = True
    turning: ClassVar[bool] = True

    @property
    def mesh(self) -> float:
        """Torque over rotation of one mesh, N*m/rad; 0 where it is infinite."""
        return self.stiffness if math.isfinite(self.stiffness) else 0.0

    def check(self, satellites: int) -> None:
        """Raise `InvalidInput` if the stiffness is out of range."""
        check_positive(stiffness=self.stiffness)


@dataclass(frozen=True, slots=True)
class Shares(SatelliteSupport):
    """Given shares of the torque, whatever the discs must turn for them; a sum other than 1 raises
    `InvalidInput`.
    """

    shares: tuple[float, ...] = quantity(
        "Shares of the torque", "w_j", ge=1e-6, le=1, lengths=((1, MAX_SATELLITES),)
    )
    """Share of the torque that each satellite carries; the shares add up to 1."""
    gives: ClassVar[bool] = True
    turning: ClassVar[bool] = True

    def __post_init__(self) -> None:
        if not abs(math.fsum(self.shares) - 1) <= SAME:
            raise InvalidInput("shares", self.shares, "sum_not_one", sum=math.fsum(self.shares))

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Given shares of the torque."""
        return self.shares

    def check(self, satellites: int) -> None:
        """Raise `InvalidInput` if shares are not one for each satellite, or not positive."""
        check_count(satellites, shares=self.shares)
        for j, share in enumerate(self.shares):
            check_positive(**{f"shares[{j}]": share})


@dataclass(frozen=True, slots=True)
class RingInSeries(SatelliteSupport):
    """Discs that find their place between ring pins and output pins, as both meshes give. Within
    the output mechanism alone this support is rigid.
    """


COUPLINGS = Variants(
    {"rigid": SatelliteSupport, "elastic": ElasticMesh, "shares": Shares, "ring": RingInSeries},
    title="Coupling of the satellites",
    help="Rigid: all satellites turn as one; elastic: each satellite gives in its mesh with the "
    "ring; shares: each satellite carries a given share; ring: each satellite finds its place "
    "between the ring of `gear` and the pins, so that both meshes are in series.",
    default="rigid",
    about="Sharing of the torque between the satellites.",
)
"""Sharing of the torque between the satellites, by its kind in the document."""


@dataclass(frozen=True, slots=True)
class Supports(SatelliteSupport):
    """Bearings of the satellites on their cranks, and the sharing of the torque."""

    crank: SatelliteSupport  # `CrankSupport`, or rigid
    coupling: SatelliteSupport  # elastic mesh, shares, both meshes in series, or rigid

    @property
    def gives(self) -> bool:  # type: ignore[override] # not set
        """True if bearings or coupling let satellites move or turn."""
        return self.crank.gives or self.coupling.gives

    @property
    def turning(self) -> bool:  # type: ignore[override] # not set
        """True if the coupling lets satellites turn against each other."""
        return self.coupling.turning

    @property
    def bearing(self) -> float:
        """Stiffness of one bearing, N/m; 0 where rigid."""
        return self.crank.bearing

    @property
    def mesh(self) -> float:
        """Torque over rotation of one mesh, N*m/rad; 0 where rigid."""
        return self.coupling.mesh

    @property
    def loose(self) -> float:
        """Half of a bearing's radial clearance, m."""
        return self.crank.loose

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Given shares of the coupling."""
        return self.coupling.given_shares

    def check(self, satellites: int) -> None:
        """Raise `InvalidInput` if a number of bearings or coupling is out of range."""
        self.crank.check(satellites)
        self.coupling.check(satellites)
