"""An involute pair by points, circles and thicknesses at 40 digits, and by its outlines.

A tooth's thickness is carried from circle to circle; the line of action is cut with the tip
circles; the rack that makes a tooth stands where it does when it cuts; nothing is taken from the
closed forms that hold these together. Lengths are in one unit, angles in radians.
"""

import cmath
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from mpmath import mp, mpf

DIGITS = 40


@dataclass(frozen=True)
class Pair:
    """Given sizes of teeth; heights in modules, `e` None without backlash."""

    z_s: int
    z_r: int
    m: float
    x_s: float
    x_r: float
    h_as: float
    h_ar: float
    alpha: float = math.radians(20)
    h_f: float = 1.25
    rho_f: float = 0.38
    e: float | None = None
    cutter: int | None = None

    @property
    def tips(self) -> tuple[Any, Any]:
        z_s, z_r, m = self.z_s, self.z_r, mpf(self.m)
        return (
            m * (mpf(z_s) / 2 + mpf(self.x_s) + mpf(self.h_as)),
            m * (mpf(z_r) / 2 + mpf(self.x_r) - mpf(self.h_ar)),
        )


def _inv(angle):
    return mp.tan(angle) - angle


def _thickness(radius, *, teeth, m, x, alpha):
    """Thickness of an external tooth, or width of an internal gear's space, along a circle."""
    r_0 = m * teeth / 2
    at = mp.acos(r_0 * mp.cos(alpha) / radius)
    s_0 = m * (mp.pi / 2 + 2 * x * mp.tan(alpha))
    return radius * (s_0 / r_0 + 2 * _inv(alpha) - 2 * _inv(at))


def _play(e, *, inner, outer, m, alpha):
    """Room of a tooth in a space along the pitch circles of an eccentricity."""
    (z, x), (other, other_x) = inner, outer
    pitch = e * z / (other - z)
    space = _thickness(e * other / (other - z), teeth=other, m=m, x=other_x, alpha=alpha)
    return space - _thickness(pitch, teeth=z, m=m, x=x, alpha=alpha)


def _without_play(*, inner, outer, m, alpha):
    """Eccentricity at which a tooth fills its space."""
    least = m * (outer[0] - inner[0]) * mp.cos(alpha) / 2
    given = {"inner": inner, "outer": outer, "m": m, "alpha": alpha}
    low, high = least * (1 + mpf(10) ** -30), 2 * least
    while _play(high, **given) > 0:
        high *= 2
    for _ in range(170):
        middle = (low + high) / 2
        low, high = (middle, high) if _play(middle, **given) > 0 else (low, middle)
    return (low + high) / 2


def _cut(centre, radius, base_point, direction):
    """Distance along a line from a point of it to a circle, towards where it leaves the circle."""
    away = base_point - centre
    along = mp.re(mp.conj(direction) * away)
    return -along + mp.sqrt(along**2 - (abs(away) ** 2 - radius**2))


def geometry(pair: Pair) -> dict[str, Any]:
    """Sizes of a pair by points and circles."""
    with mp.workdps(DIGITS):
        return {name: +value for name, value in _geometry(pair).items()}


def _geometry(pair):
    z_s, z_r, m, alpha = pair.z_s, pair.z_r, mpf(pair.m), mpf(pair.alpha)
    given = {
        "inner": (z_s, mpf(pair.x_s)),
        "outer": (z_r, mpf(pair.x_r)),
        "m": m,
        "alpha": alpha,
    }
    e_0 = _without_play(**given)
    e = e_0 if pair.e is None else mpf(pair.e)
    r_bs, r_br = m * z_s * mp.cos(alpha) / 2, m * z_r * mp.cos(alpha) / 2
    r_as, r_ar = pair.tips
    # ring about 0, satellite about e; the line touches both base circles, on it from the base point
    # of the satellite at right angles to its radius
    turned = mp.acos((r_br - r_bs) / e)
    radial = mp.expj(-turned)
    on_satellite, on_ring, along = e + r_bs * radial, r_br * radial, mp.j * radial
    start = _cut(mpf(0), r_ar, on_ring, along) - abs(on_ring - on_satellite)
    end = _cut(e, r_as, on_satellite, along)
    found = {
        "angle": turned,
        "eccentricity_without_backlash": e_0,
        "normal_backlash": _play(e, **given) * mp.cos(turned),
        "contact_ratio": (end - start) / (mp.pi * m * mp.cos(alpha)),
        "start_roll_satellite": start / r_bs,
        "end_roll": end / r_bs,
        "end_roll_ring": (end + abs(on_ring - on_satellite)) / r_br,
        "satellite_tip_thickness": _thickness(r_as, teeth=z_s, m=m, x=mpf(pair.x_s), alpha=alpha),
        "ring_tip_thickness": 2 * mp.pi * r_ar / z_r
        - _thickness(r_ar, teeth=z_r, m=m, x=mpf(pair.x_r), alpha=alpha),
    }
    # the rack's flank ends so far below the rolling line; on its line of action from the pitch
    # point back towards the base circle
    below = m * (mpf(pair.h_f) - mpf(pair.rho_f) * (1 - mp.sin(alpha)) - mpf(pair.x_s))
    found["form_roll_satellite"] = (m * z_s / 2 * mp.sin(alpha) - below / mp.sin(alpha)) / r_bs
    for name, at in (("start", start), ("end", end)):
        convex, concave = at, at + abs(on_ring - on_satellite)
        if at > 0:
            found[f"reduced_radius_{name}"] = 1 / (1 / convex - 1 / concave)
    if pair.cutter is not None:
        tool = {**given, "inner": (pair.cutter, mpf(0))}
        apart = _without_play(**tool)
        r_b0, r_a0 = m * pair.cutter * mp.cos(alpha) / 2, m * (mpf(pair.cutter) / 2 + 1.25)
        found["ring_root_radius"] = apart + r_a0
        reach = mp.sqrt(apart**2 - (r_br - r_b0) ** 2) + mp.sqrt(r_a0**2 - r_b0**2)
        found["form_roll_ring"] = reach / r_br
    if r_ar < r_as + e and r_as < r_ar + e:
        found["tip_interference"] = _tips(z_s, z_r, e, (r_as, r_ar), r_bs, start, radial)
    return found


def _tips(z_s, z_r, e, tips, r_bs, start, radial):
    """Angle between the corner of a ring's tip and that of a satellite's, which touched at the
    start of the path, once this one is where the tip circles cross, times the ring's teeth.
    """
    r_as, r_ar = tips
    touched = e + r_bs * radial + start * mp.j * radial  # the ring's corner, on both flanks
    roll, tip = start / r_bs, mp.sqrt(r_as**2 - r_bs**2) / r_bs
    inner = mp.arg(touched - e) + (roll - mp.atan(roll)) - (tip - mp.atan(tip))
    x = (r_ar**2 - r_as**2 + e**2) / (2 * e)
    crossing = x + mp.j * mp.sqrt(r_ar**2 - x**2)
    turned = mp.arg(crossing - e) - inner
    return z_r * (mp.arg(touched) + turned * z_s / z_r - mp.arg(crossing))


def root(pair: Pair) -> dict[str, Any]:
    """Chord, fillet and arm of the satellite's root under a force at the tip, on the fillet that
    the rack's rounded tip leaves as it rolls along.
    """
    with mp.workdps(DIGITS):
        return {name: +value for name, value in _root(pair).items()}


def _root(pair):
    z, m, alpha, rho = pair.z_s, mpf(pair.m), mpf(pair.alpha), mpf(pair.rho_f) * mpf(pair.m)
    r = m * z / 2
    depth = m * (mpf(pair.h_f) - mpf(pair.x_s)) - rho  # of the arc's centre below the rolling line
    # half of a rack's space at its reference line, less the flank's run and the arc's, is how far
    # the centre is from the middle of the rack's tooth; the tooth's middle is half a pitch on
    run = mpf(pair.h_f) * m * mp.tan(alpha) + rho * (1 - mp.sin(alpha)) / mp.cos(alpha)
    centre = mp.pi * m / 4 - run  # from the middle of the rack's tooth

    def fillet(down):
        """A point that the arc cuts with its normal so far below the rolling line, which goes
        through the pitch point: from the gear's centre, the middle of a space upwards."""
        roll = (depth / mp.tan(down) - centre) / r  # by which gear and rack have turned
        normal = mp.expj(-down)
        point = mp.mpc(0, r) + normal * (depth / mp.sin(down) + rho)
        return point * mp.expj(roll), roll

    # 30 degrees off the middle of the tooth beside the space, half a pitch on
    low, high = mpf("0.01"), mp.pi / 2
    for _ in range(140):
        half = (low + high) / 2
        if half - fillet(half)[1] < mp.pi / z + mp.pi / 6:
            low = half
        else:
            high = half
    own = fillet(high)[0] * mp.expj(mp.pi / z)  # tooth upwards
    step = mpf(10) ** -12
    before, here, after = (fillet(high + k * step)[0] for k in (-1, 0, 1))
    first, second = (after - before) / (2 * step), (after - 2 * here + before) / step**2
    curvature = abs(mp.im(mp.conj(first) * second)) / abs(first) ** 3
    r_b, r_a = r * mp.cos(alpha), pair.tips[0]
    tip = mp.acos(r_b / r_a)
    half = _thickness(r_a, teeth=z, m=m, x=mpf(pair.x_s), alpha=alpha) / (2 * r_a)
    return {
        "root_chord": 2 * abs(mp.re(own)),
        "fillet_radius": 1 / curvature,
        "load_angle": tip - half,
        "moment_arm": r_b / mp.cos(tip - half) - mp.im(own),
    }


def flank_scan(pair: Pair, *, angle: float, e: float, places: int = 400_000) -> dict[int, float]:
    """Turn of the satellite by which each of its teeth touches the ring's flank, over points of
    that; infinite where it never does.
    """
    cos = math.cos(pair.alpha)
    r_bs, r_br = pair.m * pair.z_s * cos / 2, pair.m * pair.z_r * cos / 2
    r_as, r_ar = map(float, pair.tips)
    root = pair.m * (pair.z_r / 2 + pair.x_r + 1.25)
    if pair.cutter is not None:
        root = float(geometry(pair)["ring_root_radius"])
    with mp.workdps(DIGITS):
        r_form = r_bs * math.hypot(1, max(0.0, float(_geometry(pair)["form_roll_satellite"])))
    own = math.tan(pair.alpha) - pair.alpha
    sigma_s = (math.pi / 2 + 2 * pair.x_s * math.tan(pair.alpha)) / pair.z_s + own
    sigma_r = (math.pi / 2 + 2 * pair.x_r * math.tan(pair.alpha)) / pair.z_r + own
    radius = np.linspace(r_ar, root, places)
    flank = np.arccos(r_br / radius)
    flank = radius * np.exp(1j * (sigma_r - np.tan(flank) + flank))
    found = {}
    for i in range(-(pair.z_s // 2), pair.z_s - pair.z_s // 2):
        turned = cmath.exp(1j * (angle * pair.z_s + 2 * math.pi * i) / pair.z_r)
        from_centre = flank * turned - e
        away = np.abs(from_centre)
        there = (away >= r_form) & (away <= r_as)
        if not there.any():
            found[i] = math.inf
            continue
        at = np.arccos(r_bs / away[there])
        touched = angle + 2 * math.pi * i / pair.z_s + sigma_s - (np.tan(at) - at)
        off = np.angle(from_centre[there] * np.exp(-1j * touched))
        found[i] = float(off.min())
    return found


def least_gap(pair: Pair, *, e: float, positions: int = 2000) -> float:
    """Least angle between tips of the satellite and flanks of the ring, and the other way round,
    over a pitch with the teeth centred; below 0 they run into each other.
    """
    cos = math.cos(pair.alpha)
    r_bs, r_br = pair.m * pair.z_s * cos / 2, pair.m * pair.z_r * cos / 2
    r_as, r_ar = map(float, pair.tips)
    own = math.tan(pair.alpha) - pair.alpha
    sigma_s = (math.pi / 2 + 2 * pair.x_s * math.tan(pair.alpha)) / pair.z_s + own
    sigma_r = (math.pi / 2 + 2 * pair.x_r * math.tan(pair.alpha)) / pair.z_r + own

    def inv(radius, base):
        at = np.arccos(base / radius)
        return np.tan(at) - at

    angle = np.linspace(0, 2 * math.pi / pair.z_s, positions, endpoint=False)[:, None]
    teeth = np.arange(-(pair.z_s // 2), pair.z_s - pair.z_s // 2)
    axis = angle + 2 * math.pi * teeth / pair.z_s
    space = angle * pair.z_s / pair.z_r + 2 * math.pi * teeth / pair.z_r
    least = math.inf
    for side in (1, -1):  # both flanks
        corner = e + r_as * np.exp(1j * (axis + side * (sigma_s - inv(r_as, r_bs))))
        away = np.abs(corner)
        off = side * np.angle(corner * np.exp(-1j * space))
        inside = away >= r_ar
        gap = sigma_r - inv(np.maximum(away, r_ar), r_br) - off
        least = min(least, float(np.min(gap, where=inside, initial=math.inf)))
        corner = r_ar * np.exp(1j * (space + side * (sigma_r - inv(r_ar, r_br)))) - e
        away = np.abs(corner)
        off = side * np.angle(corner * np.exp(-1j * axis))
        inside = (away <= r_as) & (away >= r_bs)
        gap = off - sigma_s + inv(np.maximum(away, r_bs), r_bs)
        least = min(least, float(np.min(gap, where=inside, initial=math.inf)))
    return least


def carried(
    onsets: dict[int, float], levers: dict[int, float], *, torque: float, stiffness: float
) -> dict[int, float]:
    """Forces of pairs that share a torque, by halving the turn of the satellite."""
    low, high = min(onsets.values()), 1.0

    def held(turn: float) -> float:
        return sum(
            stiffness * levers[i] ** 2 * max(0.0, turn - onset) for i, onset in onsets.items()
        )

    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if held(middle) < torque else (low, middle)
    return {i: stiffness * levers[i] * max(0.0, high - onset) for i, onset in onsets.items()}
