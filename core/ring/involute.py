"""Involute planet (satellite in code) in an involute ring: sizes, backlash, path of contact.

Profile shifts are positive outwards on both: a positive shift of the ring widens its spaces and
enlarges its tip and root circles. Heights are in modules.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import NamedTuple

from core.arrays import Number, check_finite, check_positive
from core.errors import Accuracy, InvalidInput
from core.fields import answer, answered
from core.precision import ROUNDING, SAME
from core.ring.line_of_action import LineOfAction, TipCrossing, involute, roll

MOST_DIFFERENCE = 8
"""Largest difference of teeth between ring and planet that is accepted."""

STANDARD_ANGLES = (math.radians(14.5) * (1 - SAME), math.radians(30) * (1 + SAME))
"""Least and largest reference pressure angle that is accepted, rad."""

TIPS_APART = 0.05
"""Least G of `TipCrossing.interference` that is left as a margin, rad times teeth."""

HEIGHTS = (0.3, 1.2)
"""Least and largest addendum that is accepted, in modules."""


@dataclass(frozen=True, slots=True)
class Rack:
    """Basic rack of the hob that cuts the planet; the defaults are ISO 53 A."""

    pressure_angle: float = math.radians(20)  # alpha, rad
    dedendum: float = 1.25  # h_f of the gear, in modules
    tip_radius: float = 0.38  # rho_f, in modules

    @property
    def straight(self) -> float:
        """Depth below the reference line down to which the rack's flank is straight, in modules."""
        return self.dedendum - self.tip_radius * (1 - math.sin(self.pressure_angle))

    @property
    def most_round(self) -> float:
        """Largest tip radius for which the rack's tip has room, in modules."""
        land = math.pi / 4 - self.dedendum * math.tan(self.pressure_angle)
        return land * math.cos(self.pressure_angle) / (1 - math.sin(self.pressure_angle))

    def form_roll(self, *, teeth: int, shift: Number) -> Number:
        """Roll angle above which the planet's flank is an involute, rad; undercut if below 0.

        ``tan(alpha_F) = tan(alpha) - 4*(h' - x_s)/(z_s*sin(2*alpha))`` with h' `straight`.
        """
        alpha = self.pressure_angle
        return math.tan(alpha) - 4 * (self.straight - shift) / (teeth * math.sin(2 * alpha))


def usual_rack(*, pressure_angle: float) -> Rack:
    """Rack of ISO 53 A at a pressure angle alpha in rad, its tip as round as there is room for.

    >>> round(usual_rack(pressure_angle=math.radians(25)).tip_radius, 3)
    0.318
    """
    rack = Rack(pressure_angle)
    return replace(rack, tip_radius=min(rack.tip_radius, rack.most_round))


@dataclass(frozen=True, slots=True)
class Cutter:
    """Shaper cutter of the ring."""

    teeth: int  # z_0
    profile_shift: float = 0.0  # x_0
    addendum: float = 1.25  # h_a0, in modules


@dataclass(frozen=True, slots=True, kw_only=True)
class InvoluteTeeth:
    """Involute teeth of planet and ring."""

    satellite_teeth: int  # z_s
    ring_teeth: int  # z_r
    module: float  # m, m
    satellite_profile_shift: float  # x_s
    ring_profile_shift: float  # x_r
    satellite_addendum: float  # h_as, in modules
    ring_addendum: float  # h_ar, in modules
    rack: Rack = Rack()
    cutter: Cutter | None = None  # shaper cutter of the ring

    @property
    def difference(self) -> int:
        """Number of teeth of the ring less that of the planet."""
        return self.ring_teeth - self.satellite_teeth

    @property
    def satellite_tip(self) -> float:
        """Tip radius r_as of the planet, m."""
        height = self.satellite_profile_shift + self.satellite_addendum
        return self.module * (self.satellite_teeth / 2 + height)

    @property
    def ring_tip(self) -> float:
        """Tip radius r_ar of the ring, m."""
        height = self.ring_profile_shift - self.ring_addendum
        return self.module * (self.ring_teeth / 2 + height)

    @property
    def satellite_root(self) -> float:
        """Root radius r_fs of the planet, m."""
        height = self.satellite_profile_shift - self.rack.dedendum
        return self.module * (self.satellite_teeth / 2 + height)

    @property
    def satellite_half_angle(self) -> float:
        """Half angle sigma_s of a planet's tooth at the base circle, rad."""
        return self._half_angle(self.satellite_teeth, self.satellite_profile_shift)

    @property
    def ring_half_angle(self) -> float:
        """Half angle sigma_r of a ring's space at the base circle, rad."""
        return self._half_angle(self.ring_teeth, self.ring_profile_shift)

    def _half_angle(self, teeth: int, shift: float) -> float:
        alpha = self.rack.pressure_angle
        return (math.pi / 2 + 2 * shift * math.tan(alpha)) / teeth + float(involute(alpha))

    def check(self) -> None:
        """Raise InvalidInput if sizes, difference of teeth, rack or addenda are out of range."""
        check_positive(satellite_teeth=self.satellite_teeth, module=self.module)
        check_finite(
            satellite_profile_shift=self.satellite_profile_shift,
            ring_profile_shift=self.ring_profile_shift,
            satellite_addendum=self.satellite_addendum,
            ring_addendum=self.ring_addendum,
        )
        if not 1 <= self.difference <= MOST_DIFFERENCE:
            more = self.satellite_teeth + max(1, min(self.difference, MOST_DIFFERENCE))
            code = "less_than_equal" if self.difference > 1 else "greater_than_equal"
            raise InvalidInput("ring_teeth", self.ring_teeth, code, limit=more)
        most = self.rack.most_round
        if not self.rack.tip_radius <= most:
            name = "rack_tip_radius"
            raise InvalidInput(name, self.rack.tip_radius, "less_than_equal", limit=most)
        cosine = math.cos(self.rack.pressure_angle) / 2
        outside = self.satellite_teeth * (cosine - 0.5) - self.satellite_profile_shift
        if not self.satellite_addendum > outside:
            code, than = "greater_than", {"limit": outside}
            raise InvalidInput("satellite_addendum", self.satellite_addendum, code, **than)
        inside = self.ring_teeth * (0.5 - cosine) + self.ring_profile_shift
        if not self.ring_addendum < inside:
            raise InvalidInput("ring_addendum", self.ring_addendum, "less_than", limit=inside)


def rack_of(*, pressure_angle: float, dedendum: float, tip_radius: float | None) -> Rack:
    """Rack with a given dedendum; its tip is as round as `usual_rack` has it if no radius is given.

    Raises InvalidInput if the flanks of the rack meet above its tip. Angles are in rad, sizes in
    modules.
    """
    rack = Rack(pressure_angle, dedendum)
    if not rack.most_round >= 0:
        most = math.pi / 4 / math.tan(pressure_angle)
        raise InvalidInput("dedendum", dedendum, "less_than_equal", limit=most)
    usual = min(rack.tip_radius, rack.most_round)
    return replace(rack, tip_radius=usual if tip_radius is None else tip_radius)


def addendum_of(
    *, name: str, tip_radius: float, teeth: int, shift: float, module: float, pressure_angle: float
) -> float:
    """Addendum of planet or ring from its tip radius, in modules.

    Raises InvalidInput if the tip lies within the base circle or the addendum is out of `HEIGHTS`.
    The tip radius and the module are in m, the profile shift in modules, the pressure angle in rad.
    """
    outwards = 1 if name == "satellite_tip_radius" else -1
    own, base = teeth / 2 + shift, module * (teeth * math.cos(pressure_angle) / 2)
    low, high = sorted(module * (own + outwards * each) for each in HEIGHTS)
    if not tip_radius > base:
        raise InvalidInput(name, tip_radius, "greater_than", limit=base)
    if not tip_radius >= low * (1 - SAME):
        raise InvalidInput(name, tip_radius, "greater_than_equal", limit=low)
    if not tip_radius <= high * (1 + SAME):
        raise InvalidInput(name, tip_radius, "less_than_equal", limit=high)
    return outwards * (tip_radius / module - own)


class RingFlank(NamedTuple):
    """Flank of the ring as it is made."""

    root: float  # r_fr, m
    form_roll: float  # roll angle where the involute ends, rad; infinite without a cutter


@dataclass(frozen=True, kw_only=True)
class InvolutePair:
    """Mesh of an involute planet and its ring."""

    teeth: InvoluteTeeth  # teeth of planet and ring
    line: LineOfAction  # line of action at the eccentricity
    eccentricity_without_backlash: float = answer("mm", "e₀")
    """Eccentricity at which the teeth fill their spaces."""
    normal_backlash: float = answer("mm", "j_n")
    """Distance between the idle flanks along their normal; the teeth press if it is negative."""
    ring_flank: RingFlank
    accuracy: Accuracy

    @property
    @answered("deg", "α_w")
    def operating_pressure_angle(self) -> float:
        """Operating pressure angle."""
        return self.line.angle

    @property
    @answered("mm", "e")
    def eccentricity(self) -> float:
        """Eccentricity; if none is given, the one without backlash."""
        return self.line.eccentricity

    @property
    @answered("mm", "r_as")
    def satellite_tip_radius(self) -> float:
        """Tip radius of the satellite."""
        return self.teeth.satellite_tip

    @property
    @answered("mm", "r_ar")
    def ring_tip_radius(self) -> float:
        """Tip radius of the ring."""
        return self.teeth.ring_tip

    @property
    @answered("mm", "r_fs")
    def satellite_root_radius(self) -> float:
        """Root radius of the satellite."""
        return self.teeth.satellite_root

    @property
    @answered("mm", "r_fr")
    def ring_root_radius(self) -> float:
        """Root radius of the ring; assumed if no cutter is given."""
        return self.ring_flank.root

    @property
    @answered("arcmin", "j_n/r_bs")
    def backlash(self) -> float:
        """Angle through which the satellite, and with it the output, can turn in the ring."""
        return self.normal_backlash / self.line.satellite_base

    @property
    @answered("", "τ₁")
    def start_roll_satellite(self) -> float:
        """Tangent of the satellite's pressure angle at the start of the path."""
        return float(self.line.start_roll(self.teeth.ring_tip))

    @cached_property
    def end_roll(self) -> float:
        """Roll angle of the planet at the end of the path, where the planet's tip is in contact."""
        return float(self.line.end_roll(self.teeth.satellite_tip))

    @property
    @answered("", "ε")
    def contact_ratio(self) -> float:
        """Length of the path of contact over the base pitch."""
        return float(self.line.contact_ratio(start=self.start_roll_satellite, end=self.end_roll))

    @property
    @answered()
    def pitch_point_on_path(self) -> bool:
        """True if the pitch point, at which the flanks roll without sliding, lies on the path of
        contact.
        """
        return self.start_roll_satellite <= self.line.pitch_roll <= self.end_roll

    @property
    @answered("", "τ_F")
    def form_roll_satellite(self) -> float:
        """Tangent of the pressure angle above which the satellite's flank is an involute; the
        satellite is undercut if it is negative.
        """
        shift = self.teeth.satellite_profile_shift
        return float(self.teeth.rack.form_roll(teeth=self.teeth.satellite_teeth, shift=shift))

    @property
    @answered()
    def satellite_undercut(self) -> bool:
        """True if the hob cuts away a part of the satellite's involute."""
        return self.form_roll_satellite < 0

    @property
    def on_involutes(self) -> bool:
        """True if tips pass each other and the whole path of contact lies on involutes."""
        whole = self.end_roll_ring <= self.ring_flank.form_roll
        return (
            self.tips_apart(0.0)
            and self.start_roll_satellite >= self.form_roll_satellite >= 0
            and whole
        )

    @property
    @answered()
    def end_roll_ring(self) -> float:
        """Tangent of the ring's pressure angle at the end of the path."""
        return float(self.line.on_ring(self.end_roll))

    @property
    @answered()
    def form_roll_ring(self) -> float | None:
        """Tangent of the pressure angle up to which the ring's flank is an involute, if the cutter
        is given.
        """
        return self.ring_flank.form_roll if self.ring_flank.form_roll < math.inf else None

    @cached_property
    def crossing(self) -> TipCrossing:
        """Passage of the tips at the crossing of the tip circles."""
        return self.line.crossing(
            satellite_tip=self.teeth.satellite_tip, ring_tip=self.teeth.ring_tip
        )

    @property
    @answered()
    def tips_overlap_all_round(self) -> bool:
        """True if the satellite's tip circle encloses the ring's tip circle."""
        return bool(self.crossing.overlap)

    def tips_apart(self, room: float) -> bool:
        """True if the tip circles cross and `tip_interference` is at least ``room``."""
        return float(self.crossing.interference) >= room

    @property
    def tip_interference(self) -> float | None:
        """Interference G of the tips, which has to be >= 0; None if tip circles do not cross."""
        found = float(self.crossing.interference)
        return None if math.isnan(found) else found

    @property
    @answered("mm")
    def tip_gap(self) -> float | None:
        """Approximate gap between the tips at the crossing of the tip circles; absent if the
        circles do not cross.
        """
        if self.tip_interference is None:
            return None
        return self.tip_interference * self.teeth.ring_tip / self.teeth.ring_teeth

    @property
    @answered("mm")
    def tip_clearance_satellite(self) -> float:
        """Clearance from the satellite's tip to the ring's root."""
        return self.ring_root_radius - self.line.eccentricity - self.teeth.satellite_tip

    @property
    @answered("mm")
    def tip_clearance_ring(self) -> float:
        """Clearance from the ring's tip to the satellite's root."""
        return self.teeth.ring_tip - self.line.eccentricity - self.teeth.satellite_root

    @property
    @answered("mm")
    def satellite_tip_thickness(self) -> float:
        """Thickness of the satellite's teeth at the tip circle."""
        tip = float(involute(math.atan(self.end_roll)))
        return 2 * self.teeth.satellite_tip * (self.teeth.satellite_half_angle - tip)

    @property
    @answered("mm")
    def ring_tip_thickness(self) -> float:
        """Thickness of the ring's teeth at the tip circle."""
        tip = float(involute(math.atan(roll(self.teeth.ring_tip, base=self.line.ring_base))))
        half = math.pi / self.teeth.ring_teeth - self.teeth.ring_half_angle
        return 2 * self.teeth.ring_tip * (half + tip)

    @property
    @answered("mm", "ρ")
    def reduced_radius_start(self) -> float | None:
        """Radius of relative curvature at the start of the path of contact."""
        return self._reduced_radius(self.start_roll_satellite)

    @property
    @answered("mm", "ρ")
    def reduced_radius_end(self) -> float | None:
        """Radius of relative curvature at the end of the path of contact."""
        return self._reduced_radius(self.end_roll)

    def _reduced_radius(self, at: float) -> float | None:
        curved = at > 0 and self.line.base_distance > 0
        return float(self.line.reduced_radius(at)) if curved else None


def involute_pair(*, teeth: InvoluteTeeth, eccentricity: float | None = None) -> InvolutePair:
    """Mesh of an involute planet in its ring at an eccentricity e, by default without backlash.

    ``inv(alpha_w0) = inv(alpha) + 2*(x_r - x_s)*tan(alpha)/dz``,
    ``e_0 = m*dz*cos(alpha)/(2*cos(alpha_w0))``,
    ``j_n = m*cos(alpha)*(2*(x_r - x_s)*tan(alpha) + dz*(inv(alpha) - inv(alpha_w)))``. Raises
    InvalidInput if `InvoluteTeeth.check` or the ring's cutter refuses the sizes, the spaces of the
    ring are too narrow for any eccentricity, or the base circles leave no room for the given one.

    >>> teeth = InvoluteTeeth(satellite_teeth=40, ring_teeth=41, module=2.5e-3,
    ...                       satellite_profile_shift=0.0, ring_profile_shift=0.58,
    ...                       satellite_addendum=0.8, ring_addendum=0.8)
    >>> pair = involute_pair(teeth=teeth)
    >>> round(1e3*pair.line.eccentricity, 9), round(pair.contact_ratio, 9)
    (2.003027286, 1.091406213)
    >>> pair.pitch_point_on_path
    False
    """
    teeth.check()
    alpha, difference = teeth.rack.pressure_angle, teeth.difference
    wider = 2 * (teeth.ring_profile_shift - teeth.satellite_profile_shift) * math.tan(alpha)
    own = float(involute(alpha))
    spaces = own + wider / difference
    if not spaces > 0:
        least = teeth.satellite_profile_shift - difference * own / (2 * math.tan(alpha))
        shift = teeth.ring_profile_shift
        raise InvalidInput("ring_profile_shift", shift, "greater_than", limit=least)
    without = teeth.module * difference * math.cos(alpha) / (2 * math.cos(angle_of(spaces)))
    line_at = partial(
        LineOfAction.of,
        satellite_teeth=teeth.satellite_teeth,
        ring_teeth=teeth.ring_teeth,
        module=teeth.module,
        pressure_angle=alpha,
    )
    if eccentricity is None:
        line, backlash = line_at(eccentricity=without), 0.0
    else:
        line = line_at(eccentricity=eccentricity)
        closer = difference * (own - float(involute(line.angle)))
        backlash = teeth.module * math.cos(alpha) * (wider + closer)
    return InvolutePair(
        teeth=teeth,
        line=line,
        eccentricity_without_backlash=without,
        normal_backlash=backlash,
        ring_flank=_ring_flank(teeth),
        accuracy=Accuracy("closed_form", line.error + 8 * ROUNDING * teeth.ring_teeth, 1),
    )


def angle_of(value: float) -> float:
    """Pressure angle in rad at which the involute function has a value > 0, by Newton's method.

    >>> round(math.degrees(angle_of(0.014904384)), 6)
    20.0
    """
    angle, closer = math.inf, min((3 * value) ** (1 / 3), math.atan(value + math.pi / 2))
    while closer < angle:  # Newton's steps from above, as the function is convex
        angle = closer
        closer = angle - (math.tan(angle) - angle - value) / math.tan(angle) ** 2
    return angle


def _ring_flank(teeth: InvoluteTeeth) -> RingFlank:
    """Ring's flank; without a cutter the root follows the rack's dedendum and all is involute."""
    if teeth.cutter is None:
        height = teeth.ring_profile_shift + teeth.rack.dedendum
        return RingFlank(teeth.module * (teeth.ring_teeth / 2 + height), math.inf)
    return _generated(teeth, teeth.cutter)


def _generated(teeth: InvoluteTeeth, cutter: Cutter) -> RingFlank:
    """Ring's flank as a shaper cutter makes it."""
    alpha, more = teeth.rack.pressure_angle, teeth.ring_teeth - cutter.teeth
    if not more > 0:
        most = teeth.ring_teeth
        raise InvalidInput("cutter_teeth", cutter.teeth, "less_than", limit=most)
    wider = 2 * (teeth.ring_profile_shift - cutter.profile_shift) * math.tan(alpha) / more
    spaces = float(involute(alpha)) + wider
    if not spaces > 0:
        own = more * float(involute(alpha)) / (2 * math.tan(alpha))
        limit = teeth.ring_profile_shift + own
        raise InvalidInput("cutter_profile_shift", cutter.profile_shift, "less_than", limit=limit)
    height = cutter.profile_shift + cutter.addendum
    tip = teeth.module * (cutter.teeth / 2 + height)
    base = teeth.module * cutter.teeth * math.cos(alpha) / 2
    if not tip > base:
        limit = cutter.teeth * (math.cos(alpha) - 1) / 2 - cutter.profile_shift
        raise InvalidInput("cutter_addendum", cutter.addendum, "greater_than", limit=limit)
    angle = angle_of(spaces)
    distance = teeth.module * more * math.cos(alpha) / (2 * math.cos(angle))
    reached = more * math.tan(angle) + cutter.teeth * float(roll(tip, base=base))
    return RingFlank(distance + tip, reached / teeth.ring_teeth)
