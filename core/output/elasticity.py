"""What gives under a force: the contact of a pair of pin and hole, by its law, and its pin, which
bends; and satellites that give: elastic crank bearings, an elastic mesh, or given shares of the
torque.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Self

import numpy as np

from core.arrays import FloatArray, Number, check_positive, larger, log
from core.drive.engine import CONFORMAL, HERTZ, HERTZ_END, LINEAR, POWER
from core.drive.model import Bending
from core.errors import InvalidInput
from core.hertz import ElasticMaterial, effective_modulus
from core.materials import SOFT
from core.output.conformal_law import NO_CURVE, Curve, approach_over_load, conformal_curve, end
from core.output.pin_beam import PinBeam, Support, check_apart
from core.output.pin_section import PinSection, check_bore
from core.output.tie_ring import RingJoint, TieRing
from core.precision import SAME

MIN_EXPONENT, MAX_EXPONENT = 0.5, 3.0
"""Exponents of a power law with gaps; below, ``(T/k)^(1/n)`` leaves the range of numbers."""

LOG_EXPONENT = 10 / 9
"""The power law next to Hertz's with its logarithm."""


@dataclass(frozen=True, slots=True)
class LinearLaw:
    """``F = k*delta``."""

    stiffness: float  # k of a pair, N/m, > 0


@dataclass(frozen=True, slots=True)
class PowerLaw:
    """``F = F_ref*(delta/delta_ref)^n``."""

    exponent: float  # n, from `MIN_EXPONENT` to `MAX_EXPONENT`
    reference_force: float  # F_ref, N, > 0
    reference_approach: float  # delta_ref, m, > 0


@dataclass(frozen=True, slots=True)
class PalmgrenLaw:
    """``delta = 3.84e-5*F^0.9/b^0.8`` in mm and N: rollers of steel, Palmgren 1959."""


@dataclass(frozen=True, slots=True)
class HertzLaw:
    """Hertz line contact: ``delta = F*(A - B*ln F)``."""

    # Depth t below the hole's surface to which its approach is counted, m; the nominal hole radius
    # where not given. A plane contact has no scale of its own: the approach depends on it, by its
    # logarithm.
    reference_depth: float | None = None

    def depth(self, hole_radius: float) -> float:
        """That depth in a hole of a nominal radius, m."""
        return hole_radius if self.reference_depth is None else self.reference_depth


@dataclass(frozen=True, slots=True)
class ConformalLaw:
    """The pin wraps: approach over force of `core.output.conformal_law`, counted to a circle of
    three hole radii.
    """


ContactLaw = LinearLaw | PowerLaw | PalmgrenLaw | HertzLaw | ConformalLaw


def usual_law(*, pin: ElasticMaterial, hole: ElasticMaterial) -> ContactLaw:
    """The law where none is given: by the materials, never by what they do, so that nothing jumps.

    Parameters
    ----------
    pin, hole : ElasticMaterial
        The materials.

    Returns
    -------
    ContactLaw
        Conformal where a body is softer than `core.materials.SOFT`, whose contacts wrap at
        usual loads; else Hertz's.
    """
    soft = min(pin.youngs_modulus, hole.youngs_modulus) < SOFT
    return ConformalLaw() if soft else HertzLaw()


@dataclass(frozen=True, slots=True)
class Pins:
    """Pins as they are held: rigidly, where no kind of it says how they bend."""

    @property
    def bends(self) -> bool:
        """Whether each bends for itself."""
        return False

    @property
    def tied(self) -> bool:
        """Whether a tie ring joins them."""
        return False

    @property
    def loosely_tied(self) -> bool:
        """Whether its joints are pinned, whose clearance is left out."""
        return False

    def at(self, satellite: int) -> Self:
        """The pins under one of the satellites alone, counted from 0."""
        return self

    def bending(self, satellites: int) -> list[float]:
        """Compliance of a pin at each satellite by its bending, m/N.

        Parameters
        ----------
        satellites : int
            Their number K.

        Raises
        ------
        InvalidInput
            If the pins are not held where that many satellites load them.
        """
        return [0.0] * satellites

    def wall_compliance(self, contact_length: float) -> float:
        """How much the wall about its bore gives under a force, m/N: in series with each contact.

        Parameters
        ----------
        contact_length : float
            Length b on which the force presses, m, > 0.

        Raises
        ------
        InvalidInput
            If satellites reach into each other.
        """
        return 0.0

    @property
    def spring(self) -> Bending | None:
        """Stiffness of a pin between its satellites; None where it does not bend."""
        return None


RIGID_PINS = Pins()


@dataclass(frozen=True, slots=True)
class PinSupport(Pins):
    """How the pins are held, and where the satellites load them."""

    # Held at one end, simply supported at both, clamped at both, at one with a tie ring at the
    # other.
    support: Support
    diameter: float  # d of the pin itself, m, > 0
    satellite_positions: tuple[float, ...]  # z_j of their middles from the support, m, > 0
    material: ElasticMaterial  # of the pin
    span: float | None = None  # L of the supports, or to the tie ring, m; needed with either
    bore_diameter: float = 0.0  # d_i of its bore, m, from 0 to 0.95 d
    ring_joint: RingJoint = "pinned"  # of a tie ring to the pins

    @property
    def section(self) -> PinSection:
        """Its section."""
        return PinSection(self.diameter, self.bore_diameter)

    @property
    def known_span(self) -> float:
        """The span, where one is needed.

        Raises
        ------
        InvalidInput
            If it is not given.
        """
        if self.span is None:
            raise InvalidInput("span", None, "needed", field="support")
        return self.span

    @property
    def bends(self) -> bool:
        """Whether each bends for itself: no tie ring joins them."""
        return not self.tied

    @property
    def tied(self) -> bool:
        """Whether a tie ring joins them."""
        return self.support == "tie_ring"

    @property
    def loosely_tied(self) -> bool:
        """Whether its joints are pinned."""
        return self.tied and self.ring_joint == "pinned"

    def at(self, satellite: int) -> Self:
        """The same under one satellite."""
        return replace(
            self, satellite_positions=self.satellite_positions[satellite : satellite + 1]
        )

    def _check_count(self, satellites: int) -> None:
        places = self.satellite_positions
        if len(places) != satellites:
            counts = {"expected": satellites, "actual": len(places)}
            raise InvalidInput("satellite_positions", places, "different_length", **counts)

    def bending(self, satellites: int) -> list[float]:
        """See `pin_compliance`."""
        self._check_count(satellites)
        return [*pin_compliance(self)]

    def wall_compliance(self, contact_length: float) -> float:
        """See `Pins.wall_compliance`."""
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
        """Stiffness of a pin between its satellites, and the end that a tie ring joins."""
        count, places = len(self.satellite_positions), self.satellite_positions
        if not self.tied:
            return Bending(np.asarray(np.linalg.inv(pin_flexibility(self)), float))
        ring, nodes = ring_of(self), (*places, self.known_span)
        whole = np.linalg.inv([[ring.flexibility(x, z) for z in nodes] for x in nodes])
        return Bending(whole[:count, :count], float(whole[count, count]), whole[:count, count])


def pin_flexibility(pin: PinSupport) -> FloatArray:
    """Deflections of a pin at its satellites under a unit force at each: bending and shear.

    Parameters
    ----------
    pin : PinSupport
        The pin; one that a tie ring joins while nothing holds its end.

    Returns
    -------
    array, shape (K, K)
        m/N.

    Raises
    ------
    InvalidInput
        If a size is not positive, or a satellite does not lie between the supports.

    Notes
    -----
    With I, S and k of the section, of a solid pin ``pi*d^4/64``, ``pi*d^2/4``, 10/9, at x under a
    force at z, x <= z: a cantilever ``x^2*(3*z - x)/(6*E*I) + k*x/(G*S)``; two supports
    ``x*(L - z)*(2*L*z - x^2 - z^2)/(6*E*I*L) + k*x*(L - z)/(G*S*L)``; clamped ends take from this
    what their moments turn back.
    """
    check_positive(diameter=pin.diameter)
    check_bore(bore_diameter=pin.bore_diameter, diameter=pin.diameter)
    d, bore, ratio = pin.diameter, pin.bore_diameter, pin.material.poissons_ratio
    bending = pin.material.youngs_modulus * math.pi * (d**4 - bore**4) / 64
    shear_modulus = pin.material.youngs_modulus / (2 * (1 + ratio))
    coefficient = pin.section.shear_coefficient(ratio)
    shear = coefficient / (shear_modulus * math.pi * (d**2 - bore**2) / 4)
    span = math.inf if pin.support == "cantilever" else pin.known_span
    for index, z in enumerate(pin.satellite_positions):
        name = f"satellite_positions[{index}]"
        if not z > 0:
            raise InvalidInput(name, z, "greater_than", limit=0)
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
        # End rotations by the force, even and odd, and what moments at the ends turn back.
        turned = places * (span - places) / (6 * bending * span)
        near, far = turned * (2 * span - places), turned * (span + places)
        even, odd = span / (2 * bending), span / (6 * bending) + 2 * shear / span
        found -= np.outer(near + far, near + far) / (2 * even)
        found -= np.outer(near - far, near - far) / (2 * odd)
    return found


def pin_compliance(pin: PinSupport) -> tuple[float, ...]:
    """Deflection of a pin under a unit force, at each satellite that loads it alone.

    Parameters
    ----------
    pin : PinSupport
        The pin.

    Returns
    -------
    tuple of float
        Compliance C_j, m/N.

    Raises
    ------
    InvalidInput
        As `pin_flexibility`.

    Examples
    --------
    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> pin = PinSupport("cantilever", 0.01, (0.008, 0.022), steel)
    >>> [round(c*1e9, 3) for c in pin_compliance(pin)]
    [3.057, 38.285]
    """
    return tuple(pin_flexibility(pin).diagonal().tolist())


def ring_of(pin: PinSupport) -> TieRing:
    """A tie ring as one of its pins feels it.

    Parameters
    ----------
    pin : PinSupport
        The pin.

    Returns
    -------
    TieRing
    """
    beam = PinBeam.round(
        support=pin.support,
        diameter=pin.diameter,
        bore_diameter=pin.bore_diameter,
        contact_length=1.0,  # of the loads, which are single ones here
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
    """Approach of a contact over its force: the secant of its law.

    Parameters
    ----------
    law : ContactLaw
        The law.
    contact_length, pin_radius, hole_radius : float
        Length b and radii, m.
    pin, hole : ElasticMaterial
        Materials.

    Returns
    -------
    callable
        Of forces F, N, > 0: m/N; times the force it is the approach.

    Examples
    --------
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
    """Approach over force of a contact with a compliance in series, by its law's constants."""
    if kind == LINEAR:
        return a + 0.0 * force
    if kind == HERTZ:
        return b * larger(a / b - log(force), HERTZ_END)
    if kind == CONFORMAL:
        return (approach_over_load(load=force / a, curve=curve) + b) / curve.modulus
    return (force / a) ** (1 / exponent) / force + b


def approach_under(*, law: ContactLaw, curve: Curve, force: Number, a: Number, b: Number) -> Number:
    """Approach of a contact under a force, its pin's compliance with it.

    Parameters
    ----------
    law : ContactLaw
        The law.
    curve : Curve
        Of a contact that wraps.
    force : float or array
        Force F, N, > 0.
    a, b : float or array
        Constants as `pair_law` gives them.

    Returns
    -------
    float or array
        m.
    """
    kind, exponent = law_kind(law)
    return force * _secant(kind, force, a, b, exponent, curve)


class Law(NamedTuple):
    """Law of contact of all pairs."""

    a: float  # LINEAR 1/k; POWER k; CONFORMAL b*E*
    first: float  # HERTZ: (1 - nu^2)/E of the pin
    second: float  # of the hole
    quarter: float  # pi*b*E*/4
    around: float  # pi*b
    depth: float  # to which the hole's approach is counted, m
    ratio: float  # nu/(1 - nu) of the hole
    end: float  # CONFORMAL: load Q/(E* dR) at which it ends


def pair_law(*, kind: int, law: Law, pin: Any, wide: Any, give: Any) -> tuple[Any, Any, Any]:
    """Constants a, b and the force at which the law ends of contacts.

    Parameters
    ----------
    kind : int
        Of the law.
    law : Law
        Its constants.
    pin : float or array
        Radius of the pin, m.
    wide : float, array or None
        Difference of the radii, m; None of a lobe, whose curvature the position knows.
    give : float or array
        Compliance in series, m/N.

    Returns
    -------
    a, b, limit : float or array
        LINEAR ``1/k + C, 0``; POWER ``k, C``; HERTZ ``A + C, B`` of ``F*(A - B*ln F)``, of a lobe
        at a reduced radius of 1 m; CONFORMAL ``b*E*dR, b*E*C``.
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
    """Kind and exponent of a law, as the engine knows them.

    Parameters
    ----------
    law : ContactLaw
        The law.

    Returns
    -------
    kind : int
        `LINEAR`, `POWER`, `HERTZ` or `CONFORMAL`.
    exponent : float
        Of the force over the approach.
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
    """Refuse a law whose numbers are out of range.

    Parameters
    ----------
    law : ContactLaw
        The law.

    Raises
    ------
    InvalidInput
        If they are.
    """
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
    """Constants of a law, of which `pair_law` makes those of each pair.

    Parameters
    ----------
    law : ContactLaw
        The law.
    contact_length : float
        Length b of the contact, m.
    hole_radius : float
        Nominal hole radius, m.
    pin, hole : ElasticMaterial
        Materials.

    Returns
    -------
    Law

    Notes
    -----
    Hertz with ``q = pi*b*E*/(4*rho)``, ``c = (1 - nu^2)/E``: the pin from its surface to its axis,
    ``c_1*(2*ln(4*r/a) - 1)``, the hole as a half-space to the depth t,
    ``c_2*(2*ln(2*t/a) - nu_2/(1 - nu_2))``, each times ``F/(pi*b)``, with ``a^2 = F/q``. Johnson,
    Contact Mechanics, 4.2 and 5.6. Published laws differ by 5 to 45 %: forces hardly change with
    them, the stiffness is good to 10 to 25 %.
    """
    match law:
        case LinearLaw(stiffness=stiffness):
            return Law(1 / stiffness, *[0.0] * 7)
        case PowerLaw(exponent=n, reference_force=force, reference_approach=approach):
            return Law(force / approach**n, *[0.0] * 7)
        case PalmgrenLaw():
            per_force = 3.84e-5 / (1e3 * contact_length) ** 0.8 * 1e-3  # m/N^0.9
            return Law(per_force**-LOG_EXPONENT, *[0.0] * 7)
        case ConformalLaw():
            curve = law_curve(law=law, contact_length=contact_length, pin=pin, hole=hole)
            return Law(curve.modulus, *[0.0] * 7)._replace(end=end(curve))
    around = math.pi * contact_length
    return Law(
        a=0.0,
        first=(1 - pin.poissons_ratio**2) / pin.youngs_modulus,
        second=(1 - hole.poissons_ratio**2) / hole.youngs_modulus,
        quarter=around * effective_modulus(first=pin, second=hole) / 4,
        around=around,
        depth=law.depth(hole_radius),
        ratio=hole.poissons_ratio / (1 - hole.poissons_ratio),
        end=0.0,
    )


def law_curve(
    *,
    law: ContactLaw,
    contact_length: float,
    pin: ElasticMaterial,
    hole: ElasticMaterial,
) -> Curve:
    """The curve of a contact that wraps; of other laws nothing.

    Parameters
    ----------
    law : ContactLaw
        The law.
    contact_length : float
        Length b of the contact, m.
    pin, hole : ElasticMaterial
        Materials.

    Returns
    -------
    Curve
    """
    if not isinstance(law, ConformalLaw):
        return NO_CURVE
    return conformal_curve(contact_length=contact_length, pin=pin, hole=hole)


@dataclass(frozen=True, slots=True)
class SatelliteSupport:
    """How the satellites are held: rigidly, where no kind of it says what gives."""

    @property
    def gives(self) -> bool:
        """True where it lets satellites move or turn."""
        return False

    @property
    def turning(self) -> bool:
        """True where satellites turn against each other."""
        return False

    @property
    def bearing(self) -> float:
        """Stiffness of the bearing of one satellite on its crank, N/m; 0 where that is rigid."""
        return 0.0

    @property
    def mesh(self) -> float:
        """Torque over rotation of one satellite in its mesh, N*m/rad; 0 where that is rigid."""
        return 0.0

    @property
    def loose(self) -> float:
        """How far a satellite moves freely to either side of its middle, m."""
        return 0.0

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Shares of the torque; none where they follow from what gives."""
        return ()

    def check(self, satellites: int) -> None:
        """Refuse what a support cannot be.

        Parameters
        ----------
        satellites : int
            Their number K.

        Raises
        ------
        InvalidInput
            If a size is out of range, or shares are not one each or do not add up to 1.
        """


RIGID_SUPPORT = SatelliteSupport()


@dataclass(frozen=True, slots=True)
class CrankSupport(SatelliteSupport):
    """Bearing of each satellite on its crank."""

    stiffness: float = math.inf  # k_b of one bearing, radial, N/m; infinite where not given
    radial_clearance: float = 0.0  # G, m: the inner ring moves by G/2 to either side of its middle

    @property
    def gives(self) -> bool:
        """True: a bearing is given."""
        return True

    @property
    def bearing(self) -> float:
        """Of one bearing; 0 where it is not given."""
        return self.stiffness if math.isfinite(self.stiffness) else 0.0

    @property
    def loose(self) -> float:
        """Half of its clearance, m."""
        return self.radial_clearance / 2

    def check(self, satellites: int) -> None:
        """Refuse a stiffness or a clearance out of range."""
        check_positive(stiffness=self.stiffness)
        if not 0 <= self.radial_clearance < math.inf:
            clearance = self.radial_clearance
            raise InvalidInput("radial_clearance", clearance, "greater_than_equal", limit=0)


@dataclass(frozen=True, slots=True)
class ElasticMesh(SatelliteSupport):
    """Mesh of each satellite with the ring, which lets the disc turn under its torque."""

    stiffness: float  # torque over rotation k_D of one disc, N*m/rad

    @property
    def gives(self) -> bool:
        """True: a mesh is given."""
        return True

    @property
    def turning(self) -> bool:
        """True: each mesh gives for itself."""
        return True

    @property
    def mesh(self) -> float:
        """Of one mesh; 0 where it is infinite."""
        return self.stiffness if math.isfinite(self.stiffness) else 0.0

    def check(self, satellites: int) -> None:
        """Refuse a stiffness out of range."""
        check_positive(stiffness=self.stiffness)


@dataclass(frozen=True, slots=True)
class Shares(SatelliteSupport):
    """Torque that is shared as given, whatever the discs need to turn for it."""

    shares: tuple[float, ...]  # w_j of each of the K satellites, > 0, of sum 1

    @property
    def gives(self) -> bool:
        """True: satellites are not held together."""
        return True

    @property
    def turning(self) -> bool:
        """True: each turns for itself."""
        return True

    @property
    def given_shares(self) -> tuple[float, ...]:
        """The shares."""
        return self.shares

    def check(self, satellites: int) -> None:
        """Refuse shares that are not one each, or do not add up to 1."""
        if len(self.shares) != satellites:
            counts = {"expected": satellites, "actual": len(self.shares)}
            raise InvalidInput("shares", self.shares, "different_length", **counts)
        for j, share in enumerate(self.shares):
            check_positive(**{f"shares[{j}]": share})
        if not abs(math.fsum(self.shares) - 1) <= SAME:
            raise InvalidInput("shares", self.shares, "sum_not_one", sum=math.fsum(self.shares))


@dataclass(frozen=True, slots=True)
class RingInSeries(SatelliteSupport):
    """Each disc finds its place between the pins of its ring and those of the output, as both
    meshes give: of the one alone it is rigid.
    """


@dataclass(frozen=True, slots=True)
class Supports(SatelliteSupport):
    """Bearings of the satellites on their cranks, and how they share the torque."""

    crank: SatelliteSupport  # a `CrankSupport`, or rigid
    coupling: SatelliteSupport  # an elastic mesh, shares, both meshes in series, or rigid

    @property
    def gives(self) -> bool:
        """True where either does."""
        return self.crank.gives or self.coupling.gives

    @property
    def turning(self) -> bool:
        """True where the coupling lets them turn."""
        return self.coupling.turning

    @property
    def bearing(self) -> float:
        """Stiffness of one bearing, N/m; 0 where it is rigid."""
        return self.crank.bearing

    @property
    def mesh(self) -> float:
        """Torque over rotation of one mesh, N*m/rad; 0 where it is rigid."""
        return self.coupling.mesh

    @property
    def loose(self) -> float:
        """Half of the clearance of a bearing, m."""
        return self.crank.loose

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Shares of the coupling."""
        return self.coupling.given_shares

    def check(self, satellites: int) -> None:
        """Refuse what either cannot be."""
        self.crank.check(satellites)
        self.coupling.check(satellites)
